/* paper.c: levels of kern_measure() against those of the paper's own algorithm

       cc -O2 -ffp-contract=off -o paper tests/paper.c -lm
       ./paper LIST|FILE.kern ...

   The oracle is examples/copy/algorithm1.c: Eq. (5) from kern_contact_at(), and
   one program of kern_lp_solve() for each step. It shares no search, no pass and
   no measure with what it tests. LIST names files. Both are asked with absolute
   and with relative steps.

   Where the margin lies within ALLOWED of a step, the verdict at that step is
   open, and levels may be one apart. Every other difference is printed and fails,
   and so does a level that is undecided. The CPU times of both are compared.

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#define main algorithm1_main
#include "../examples/copy/algorithm1.c"
#undef main

#include "scenes.h"

#include <time.h>

#define ALLOWED 1e-7 /* mean block sizes; relative: 1                     */
#define MODES 2      /* absolute steps, relative ones                     */

struct sums {
    int asked, same, at_step, open, wrong;
    double paper, kern; /* CPU time [s]                                    */
};

/* Arrays of Eq. (5), with work memory for its programs. */
struct oracle {
    struct equation5 e;
    kern_work work;
};

static void oracle_open(struct oracle *o, const struct scene *scene)
{
    const size_t rows = 3 * (size_t)scene->size;
    const size_t cols = 2 * (size_t)scene->contacts;
    const int reals = KERN_LP_REALS((int)rows, (int)cols);
    const int ints_wanted = KERN_LP_INTS((int)rows, (int)cols);
    o->e.row = room_for((size_t)scene->blocks, sizeof(int));
    o->e.rows = 0;
    o->e.a = room_for(rows * cols, sizeof(kern_real));
    o->e.rhs = room_for(rows, sizeof(kern_real));
    o->e.x = room_for(cols, sizeof(kern_real));
    o->e.y = room_for(rows, sizeof(kern_real));
    o->work = kern_work_of(room_for((size_t)reals, sizeof(kern_real)), reals,
                           room_for((size_t)ints_wanted, sizeof(int)),
                           ints_wanted);
}

static void oracle_close(struct oracle *o)
{
    free(o->e.row);
    free(o->e.a);
    free(o->e.rhs);
    free(o->e.x);
    free(o->e.y);
    free(o->work.real);
    free(o->work.index);
}

/* Returns how far the margin is from the nearest step, as a length. */
static double from_step(const kern_margin *m)
{
    const double k = floor(m->margin / m->epsilon + 0.5);
    return fabs(m->margin - k * m->epsilon);
}

/* Asks both for the level and adds the outcome to the sums. */
static void compare(const struct scene *scene, struct oracle *o,
                    kern_work *work, int relative, struct sums *sums)
{
    const double unit = relative ? 1
                                 : kern_mean_size(scene->block, scene->blocks);
    kern_task task = kern_task_of(scene->block, scene->blocks, scene->contact,
                                  scene->contacts, work);
    kern_margin m;
    clock_t start = clock();
    int level;

    task.s.gravity = scene->gravity;
    task.options = scene->options;
    task.options.relative = relative;
    memset(&m, 0, sizeof m);
    if (kern_measure(&task, &m, NULL) < 0)
        m.level = -1;
    sums->kern += (double)(clock() - start) / CLOCKS_PER_SEC;

    start = clock();
    level = algorithm1(&o->e, &task.s, relative, m.epsilon, m.most, &o->work);
    sums->paper += (double)(clock() - start) / CLOCKS_PER_SEC;

    sums->asked++;
    if (level < 0 || m.level < 0) {
        sums->open++;
        printf("%s%s: not decided: the paper %d, kern %d\n", scene->name,
               relative ? ", relative" : "", level, m.level);
    } else if (level == m.level)
        sums->same++;
    else if (from_step(&m) <= ALLOWED * unit && abs(level - m.level) == 1)
        sums->at_step++;
    else {
        sums->wrong++;
        printf("%s%s: level of the paper %d, of kern %d, margin %.17g, step "
               "%.17g\n",
               scene->name, relative ? ", relative" : "", level, m.level,
               m.margin, m.epsilon);
    }
}

static void compare_file(const char *path, struct sums sums[MODES])
{
    struct scene scene;
    struct oracle oracle;
    kern_work work;
    int reals_wanted, ints_wanted, mode;
    scene_read(&scene, path);
    kern_work_need(scene.blocks, scene.contacts, &reals_wanted, &ints_wanted);
    work = kern_work_of(
        room_for((size_t)reals_wanted, sizeof(kern_real)), reals_wanted,
        room_for((size_t)ints_wanted, sizeof(int)), ints_wanted);
    oracle_open(&oracle, &scene);
    for (mode = 0; mode < MODES; mode++)
        compare(&scene, &oracle, &work, mode, &sums[mode]);
    oracle_close(&oracle);
    free(work.real);
    free(work.index);
    scene_close(&scene);
}

static void compare_list(const char *name, struct sums sums[MODES])
{
    FILE *list = list_open(name);
    char path[1000];
    while (list_next(list, path, (int)sizeof path))
        compare_file(path, sums);
    fclose(list);
}

int main(int argc, char **argv)
{
    struct sums sums[MODES];
    int i, mode, bad = 0;
    memset(sums, 0, sizeof sums);
    for (i = 1; i < argc; i++)
        if (strstr(argv[i], ".kern"))
            compare_file(argv[i], sums);
        else
            compare_list(argv[i], sums);
    for (mode = 0; mode < MODES; mode++) {
        const struct sums *s = &sums[mode];
        printf("%s: %d structures, same level %d, margin at a step %d, not "
               "decided %d, other %d; the paper takes %.1f times as long\n",
               mode ? "relative" : "absolute", s->asked, s->same, s->at_step,
               s->open, s->wrong, s->kern > 0 ? s->paper / s->kern : 0);
        bad += s->asked == 0 || s->wrong > 0 || s->open > 0;
    }
    return bad > 0;
}
