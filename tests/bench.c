/* bench.c: how long the questions of kern.h take, beside general LP solvers

   Build it in the directory of kern.h:

       cc -O2 -ffp-contract=off -o bench tests/bench.c -lm

   and with one or both of the peers (Debian: libglpk-dev, coinor-libclp-dev;
   where the linker misses C++ symbols of Clp, add -lstdc++):

       cc -O2 -ffp-contract=off -DBENCH_GLPK -DBENCH_CLP -o bench \
           tests/bench.c -lglpk -lClp -lCoinUtils -lm

   Then ./bench prints the tables, ./bench --quick a small part of them within
   a minute, ./bench --help the options. Progress goes to stderr. The exit
   status is 1 if any two answers disagree; times are never judged by it. The
   README's tables are made anew by

       ./bench --quick --summary >summary.md && sed -i \
           -e '/^<!-- bench/,/^<!-- end/{//!d}' \
           -e '/^<!-- bench/r summary.md' README.md

   STRUCTURES are made here from fixed seeds: walls in running bond (bond),
   ragged with gaps (rag), with sloped beds (irr), towers, voussoir arches, and
   perfect brick walls (brick), whose programs are as degenerate as can be and
   which are kept out of the medians over families. A structure is named
   family/blocks/number; --family, --sizes and --number ask for it alone.

   TIMES are CPU time of this one process, in ms, of the fastest of three runs,
   each long enough for the clock. A verdict, a measure and so on of kern.h
   include everything from the caller's data to the checked proof, except
   contact search, which has its own column. A peer's time is that of its solve
   alone, the model ready in its memory; of its Algorithm 1, of 20 levels, each
   from the last basis, with the torque entries written in between. Both get
   programs that are built here from the equations and not by kern.h:

       A(d) x = -w, x >= 0    three rows a free block, two columns a contact
                              point; lengths in mean block sizes, forces in
                              mean weights; torques about each block's centre

   CANDIDATES: a stone is laid on top of a structure at several places. `try`
   is kern_plan_try on the structure as it was measured, with the contacts of
   the stone found on the way; `fresh` is kern_measure of all blocks with the
   stone from nothing, contacts given; `+search` finds these with kern_contacts
   before. A structure's ratio is the median over the places where it stands.
   `per s` counts all places, also where it falls and where the stone overlaps.

   MEDIANS: a family's number is the median over its structures, a size's
   number the median over the five families' numbers; a ratio is taken for each
   structure, against the faster peer on that structure. What kern.h leaves
   undecided is in no median, but is listed as DISAGREE.

   SPDX-License-Identifier: MIT */

#define _POSIX_C_SOURCE 199309L

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define KERN_STATIC
#include "../kern.h"

#ifdef BENCH_GLPK
#include <glpk.h>
#endif
#ifdef BENCH_CLP
#include <coin/Clp_C_Interface.h>
#endif

#define MU 0.4
#define LENGTH 0.4         /* of a brick [m]; it is half as high              */
#define DENSITY 2000.0     /* [kg/m^2]                                        */
#define NEAR 1e-5          /* mean block sizes around d* where peers, with
                              their tolerances of 1e-7, may answer either way */
#define LEVELS 20          /* of Algorithm 1                                  */
#define STALL 10           /* pivots a row: an LP of kern.h that needs more is
                              undecided, which disagrees with everything      */
#define SCAN_MOST 500      /* largest structures whose levels are scanned     */
#define PLACES_MOST 24     /* candidates of a structure                       */
#define PLAN_MOST 1000     /* largest structures with candidates              */
#define GROWTH_GOAL 2      /* exponent of the measure on walls                */
#define MEMORY_GOAL 32     /* for 30 blocks [KB]                              */
#define MISSING (-1.0)     /* a number that was not measured                  */

static void *room_for(size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (!p) {
        fprintf(stderr, "bench: out of memory\n");
        exit(2);
    }
    return p;
}

/* ---- Random numbers: splitmix64 ------------------------------------------ */

static double random_in(uint64_t *state, double low, double high)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    z ^= z >> 31;
    return low + (high - low) * ((double)(z >> 11) / 9007199254740992.0);
}

/* ---- Time ---------------------------------------------------------------- */

/* Something to be timed. Where `ready` is given it comes before every run and
   is not counted. */
struct job {
    void (*ready)(void *data);
    void (*run)(void *data);
    void *data;
};

struct patience {
    double batch;          /* shortest time on the clock [ms]                 */
    double once;           /* longer than this is run but once [ms]           */
};

static double clock_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

static double time_batch(const struct job *job, int runs)
{
    double from = clock_ms(), sum = 0;
    int i;
    if (!job->ready) {
        for (i = 0; i < runs; i++)
            job->run(job->data);
        return (clock_ms() - from) / runs;
    }
    for (i = 0; i < runs; i++) {
        job->ready(job->data);
        from = clock_ms();
        job->run(job->data);
        sum += clock_ms() - from;
    }
    return sum / runs;
}

/* The least of three batches: what other programs on the machine add to CPU
   time, by way of its caches, is never negative. */
static double time_job(const struct job *job, const struct patience *patience)
{
    double best = time_batch(job, 1);
    int runs = 1, i;
    if (best > patience->once)
        return best;
    if (best < patience->batch)
        runs = (int)(patience->batch / (best > 1e-4 ? best : 1e-4)) + 1;
    for (i = 0; i < 3; i++) {
        const double t = time_batch(job, runs);
        best = t < best ? t : best;
    }
    return best;
}

/* ---- Medians of numbers -------------------------------------------------- */

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *number, int n)
{
    if (n == 0)
        return MISSING;
    qsort(number, (size_t)n, sizeof *number, compare_numbers);
    return (number[(n - 1) / 2] + number[n / 2]) / 2;
}

/* ---- Structures ---------------------------------------------------------- */

#define CORNERS 16         /* most vertices of a block                        */
#define COURSE 256         /* most bricks of a course                         */

struct scene {
    kern_vec *vertex;
    kern_block *block;
    kern_contact *contact;
    int blocks, vertices, contacts;
    int room;              /* for contacts                                    */
    uint64_t random;
    kern_structure s;
    kern_options options;
};

static double scene_random(struct scene *scene, double low, double high)
{
    return random_in(&scene->random, low, high);
}

static void scene_block(struct scene *scene, const kern_vec *vertex, int n,
                        double density)
{
    kern_vec *copy = scene->vertex + scene->vertices;
    kern_status status;
    memcpy(copy, vertex, (size_t)n * sizeof *vertex);
    status = kern_block_init(&scene->block[scene->blocks], copy, n, density,
                             NULL);
    if (status != KERN_STANDS) {
        fprintf(stderr, "bench: block %d: %s\n", scene->blocks,
                kern_status_text(status));
        exit(2);
    }
    scene->vertices += n;
    scene->blocks++;
}

static void scene_box(struct scene *scene, double left, double low,
                      double right, double high, double density)
{
    kern_vec v[4];
    v[0].x = v[3].x = left;
    v[1].x = v[2].x = right;
    v[0].y = v[1].y = low;
    v[2].y = v[3].y = high;
    scene_block(scene, v, 4, density);
}

/* What distinguishes the walls from each other; lengths in bricks. */
struct wall {
    double first[2];       /* bounds of the first brick of odd courses; that of
                              even ones is half a brick longer                */
    double ragged;         /* lengths differ by this share                    */
    double gap[2];         /* bounds of the gap between neighbours            */
    double batter;         /* each course is that much shorter at its ends    */
    double loose;          /* its ends lie somewhere within that              */
    double slope;          /* heights of the joints differ by this share      */
    double uneven;         /* densities differ by this share                  */
};

static const struct wall wall_bond = {
    {0.25, 0.75}, 0.15, {0.02, 0.02}, 0.0, 0.3, 0.0, 0.0};
static const struct wall wall_rag = {
    {0.4, 0.9}, 0.4, {0.03, 0.2}, 0.12, 0.12, 0.0, 0.2};
static const struct wall wall_irr = {
    {0.4, 0.7}, 0.3, {0.02, 0.02}, 0.1, 0.1, 0.12, 0.2};
static const struct wall wall_brick = {
    {0.5, 0.5}, 0.0, {0.0, 0.0}, 0.0, 0.0, 0.0, 0.0};

/* The upper side of a course: a line that bends in the middle of each joint
   between two bricks, so that every brick has a straight top. */
struct bed {
    double x[COURSE + 1], y[COURSE + 1];
    int knots;
};

static double bed_at(const struct bed *bed, double x)
{
    int i = 1;
    if (x <= bed->x[0])
        return bed->y[0];
    while (i < bed->knots && x > bed->x[i])
        i++;
    if (i == bed->knots)
        return bed->y[i - 1];
    return bed->y[i - 1] + (bed->y[i] - bed->y[i - 1])
        * (x - bed->x[i - 1]) / (bed->x[i] - bed->x[i - 1]);
}

static void bed_knot(struct bed *bed, double x, double y)
{
    if (bed->knots > COURSE) {
        fprintf(stderr, "bench: a course of more than %d bricks\n", COURSE);
        exit(2);
    }
    bed->x[bed->knots] = x;
    bed->y[bed->knots] = y;
    bed->knots++;
}

static void wall_brick_add(struct scene *scene, const struct bed *under,
                           const struct bed *over, double left, double right,
                           int bends, double density)
{
    kern_vec v[CORNERS];
    int n = 0, i;
    v[n].x = left;
    v[n++].y = bed_at(under, left);
    for (i = 0; bends && i < under->knots && n < CORNERS - 3; i++)
        if (under->x[i] > left && under->x[i] < right) {
            v[n].x = under->x[i];
            v[n++].y = under->y[i];
        }
    v[n].x = right;
    v[n++].y = bed_at(under, right);
    v[n].x = right;
    v[n++].y = bed_at(over, right);
    v[n].x = left;
    v[n++].y = bed_at(over, left);
    scene_block(scene, v, n, density);
}

/* One course, from `x` to `end`, of `most` bricks at the most. What is left at
   the end and too short for a brick goes to the last one. */
static void wall_course(struct scene *scene, const struct wall *wall, int odd,
                        double x, double end, double top,
                        const struct bed *under, struct bed *over, int most)
{
    double share = scene_random(scene, wall->first[0], wall->first[1])
        + (odd ? 0.0 : 0.5);
    double half = 0;       /* of the gap at x: none before the first brick    */
    over->knots = 0;
    bed_knot(over, x, top + LENGTH * wall->slope
        * scene_random(scene, -0.5, 0.5));
    while (x < end && most > 0) {
        double next = x + share * LENGTH, gap;
        if (next > end - 0.4 * LENGTH)
            next = end;
        gap = next < end
            ? LENGTH * scene_random(scene, wall->gap[0], wall->gap[1]) : 0;
        bed_knot(over, next, top + LENGTH * wall->slope
            * scene_random(scene, -0.5, 0.5));
        wall_brick_add(scene, under, over, x + half, next - gap / 2,
                       wall->slope > 0, DENSITY
            * (1 + wall->uneven * scene_random(scene, -1, 1)));
        half = gap / 2;
        x = next;
        share = 1 + wall->ragged * scene_random(scene, -1, 1);
        most--;
    }
}

/* About twice as long as high, give or take a third. */
static void make_wall(struct scene *scene, int n, const struct wall *wall)
{
    const int courses = (int)(sqrt(n * scene_random(scene, 0.67, 1.5)) + 0.5);
    const double inset = wall->batter * LENGTH;
    const double loose = wall->loose * LENGTH;
    const double length = LENGTH * n / courses + inset * courses;
    struct bed bed[2];
    int k;
    scene_box(scene, -length, -LENGTH, 2 * length, 0, 0);
    bed[0].knots = 0;
    bed_knot(&bed[0], 0, 0);
    for (k = 0; scene->blocks < n + 1; k++) {
        wall_course(scene, wall, k % 2,
                    inset * k + loose * scene_random(scene, -0.5, 0.5),
                    length - inset * k + loose * scene_random(scene, -0.5, 0.5),
                    LENGTH / 2 * (k + 1), &bed[k % 2], &bed[(k + 1) % 2],
                    n + 1 - scene->blocks);
    }
}

static void make_bond(struct scene *scene, int n)
{
    make_wall(scene, n, &wall_bond);
}

static void make_rag(struct scene *scene, int n)
{
    make_wall(scene, n, &wall_rag);
}

static void make_irr(struct scene *scene, int n)
{
    make_wall(scene, n, &wall_irr);
}

static void make_brick(struct scene *scene, int n)
{
    make_wall(scene, n, &wall_brick);
}

static void make_tower(struct scene *scene, int n)
{
    double low = 0;
    int i;
    scene_box(scene, -4 * LENGTH, -LENGTH, 4 * LENGTH, 0, 0);
    for (i = 0; i < n; i++) {
        const double wide = LENGTH * scene_random(scene, 0.8, 1.2);
        const double left = LENGTH * scene_random(scene, -0.2, 0.2) - wide / 2;
        const double high = low + LENGTH * scene_random(scene, 0.3, 0.6);
        scene_box(scene, left, low, left + wide, high, DENSITY);
        low = high;
    }
}

/* A piece of a ring, from one angle to another, counted from upright. */
static void arch_piece(struct scene *scene, double inner, double outer,
                       double from, double to, double density)
{
    kern_vec v[4];
    v[0].x = inner * sin(from);
    v[0].y = inner * cos(from);
    v[1].x = inner * sin(to);
    v[1].y = inner * cos(to);
    v[2].x = outer * sin(to);
    v[2].y = outer * cos(to);
    v[3].x = outer * sin(from);
    v[3].y = outer * cos(from);
    scene_block(scene, v, 4, density);
}

static void make_arch(struct scene *scene, int n)
{
    const double inner = LENGTH * n / 4 + LENGTH;
    const double outer = inner * scene_random(scene, 1.2, 1.4);
    const double half = scene_random(scene, 0.9, 1.3);
    int i;
    arch_piece(scene, inner, outer, -half - 0.2, -half, 0);
    arch_piece(scene, inner, outer, half, half + 0.2, 0);
    for (i = 0; i < n; i++)
        arch_piece(scene, inner, outer, -half + 2 * half * i / n,
                   -half + 2 * half * (i + 1) / n,
                   DENSITY * scene_random(scene, 0.7, 1.3));
}

struct family {
    const char *name;
    void (*make)(struct scene *scene, int n);
    int wall;              /* counts for the growth exponents                 */
    int counts;            /* for the medians over families                   */
};

static const struct family families[] = {
    {"bond", make_bond, 1, 1},   {"rag", make_rag, 1, 1},
    {"irr", make_irr, 1, 1},     {"tower", make_tower, 0, 1},
    {"arch", make_arch, 0, 1},   {"brick", make_brick, 1, 0},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

static void scene_open(struct scene *scene, int family, int n, int number)
{
    int found;
    kern_work work;
    memset(scene, 0, sizeof *scene);
    scene->random = (uint64_t)(1000003 * family + 101 * n + number);
    scene->vertex = room_for((size_t)(n + 2) * CORNERS, sizeof(kern_vec));
    scene->block = room_for((size_t)n + 2, sizeof(kern_block));
    scene->room = 32 * (n + 2);
    scene->contact = room_for((size_t)scene->room, sizeof(kern_contact));
    scene->options = kern_defaults();
    scene->options.mu = MU;
    families[family].make(scene, n);
    work = kern_work_of(NULL, 0,
                        room_for(2 * (size_t)scene->blocks, sizeof(int)),
                        2 * scene->blocks);
    found = kern_contacts(scene->block, scene->blocks, &scene->options,
                          scene->contact, scene->room, &work);
    free(work.index);
    if (found < 0) {
        fprintf(stderr, "bench: contacts of %s/%d/%d: %s\n",
                families[family].name, n, number,
                kern_status_text((kern_status)found));
        exit(2);
    }
    scene->contacts = found;
    scene->options.pivots = STALL * 3 * scene->blocks;
    scene->s.block = scene->block;
    scene->s.blocks = scene->blocks;
    scene->s.contact = scene->contact;
    scene->s.contacts = scene->contacts;
    scene->s.gravity.x = 0;
    scene->s.gravity.y = -9.81;
}

static void scene_close(struct scene *scene)
{
    free(scene->vertex);
    free(scene->block);
    free(scene->contact);
}

/* The structure as a text that examples/kern.c reads. */
static void scene_print(const struct scene *scene)
{
    int i, k;
    printf("friction %.17g\ngravity 0 -9.81\n", MU);
    for (i = 0; i < scene->blocks; i++) {
        const kern_block *b = &scene->block[i];
        if (b->fixed)
            printf("fixed b%d", i);
        else
            printf("block b%d %.17g", i, b->mass);
        for (k = 0; k < b->vertices; k++)
            printf(" %.17g %.17g", b->vertex[k].x, b->vertex[k].y);
        printf("\n");
    }
}

/* ---- The linear program, from the equations ------------------------------ */

struct program {
    const struct scene *scene;
    int rows, cols;
    int *first;            /* first row of each block, -1 of fixed ones       */
    int *start;            /* of each column in row and value; start[cols]    */
    int *row;
    double *value;
    double *rhs;
    double length, weight; /* units                                           */
    double shrink;         /* at which the entries are                        */
};

/* One end of a column: what the unit force f at p does to a block. A torque
   that is 0 here may not be 0 at another shrinkage, and solvers drop zeros:
   they get a number that is none to them. */
static int program_end(const struct program *lp, int block, kern_vec f,
                       kern_vec p, double sign, int at)
{
    const kern_vec c = lp->scene->block[block].centre;
    double torque = sign * ((p.x - c.x) * f.y - (p.y - c.y) * f.x) / lp->length;
    int i;
    if (lp->first[block] < 0)
        return at;
    if (fabs(torque) < 1e-15)
        torque = 1e-15;
    lp->value[at] = sign * f.x;
    lp->value[at + 1] = sign * f.y;
    lp->value[at + 2] = torque;
    for (i = 0; i < 3; i++) {
        if (i < 2 && fabs(lp->value[at + i]) < 1e-15)
            lp->value[at + i] = 1e-15;
        lp->row[at + i] = lp->first[block] + i;
    }
    return at + 3;
}

/* Writes all columns for a shrinkage; the pattern is always the same. */
static void program_shrink(struct program *lp, double shrink)
{
    const struct scene *scene = lp->scene;
    int i, side, at = 0, col = 0;
    for (i = 0; i < scene->contacts; i++) {
        const kern_contact *c = &scene->contact[i];
        const double way = fmin(fabs(c->travel), shrink)
            * (c->travel < 0 ? -1 : 1);
        kern_vec p, f;
        p.x = c->p.x - way * c->n.y;
        p.y = c->p.y + way * c->n.x;
        for (side = -1; side <= 1; side += 2) {
            f.x = c->n.x - side * c->mu * c->n.y;
            f.y = c->n.y + side * c->mu * c->n.x;
            lp->start[col++] = at;
            at = program_end(lp, c->b, f, p, 1, at);
            at = program_end(lp, c->a, f, p, -1, at);
        }
    }
    lp->start[col] = at;
    lp->shrink = shrink;
}

static void program_open(struct program *lp, const struct scene *scene)
{
    const size_t cols = 2 * (size_t)scene->contacts;
    double mass = 0;
    int i;
    lp->scene = scene;
    lp->rows = 0;
    lp->cols = (int)cols;
    lp->first = room_for((size_t)scene->blocks, sizeof(int));
    lp->start = room_for(cols + 1, sizeof(int));
    lp->row = room_for(6 * cols, sizeof(int));
    lp->value = room_for(6 * cols, sizeof(double));
    lp->rhs = room_for(3 * (size_t)scene->blocks, sizeof(double));
    for (i = 0; i < scene->blocks; i++) {
        lp->first[i] = scene->block[i].fixed ? -1 : lp->rows;
        lp->rows += scene->block[i].fixed ? 0 : 3;
        mass += scene->block[i].fixed ? 0 : scene->block[i].mass;
    }
    lp->length = kern_mean_size(scene->block, scene->blocks);
    lp->weight = mass * 9.81 / (lp->rows / 3);
    for (i = 0; i < scene->blocks; i++)
        if (lp->first[i] >= 0)
            lp->rhs[lp->first[i] + 1] = scene->block[i].mass * 9.81
                / lp->weight;
    program_shrink(lp, 0);
}

static void program_close(struct program *lp)
{
    free(lp->first);
    free(lp->start);
    free(lp->row);
    free(lp->value);
    free(lp->rhs);
}

/* ---- Peers --------------------------------------------------------------- */

/* A solver: a model made of a program, with the basis of slacks; its solve by
   the dual simplex from the basis at hand, 1 feasible, 0 infeasible, -1 no
   answer; and new entries in the same places. */
struct peer {
    const char *name;
    int cold, warm;        /* quantities where its times go                   */
    int cold_most;         /* largest structures for one LP                   */
    int warm_most;         /* and for Algorithm 1                             */
    void *(*open)(const struct program *lp);
    void (*change)(void *model, const struct program *lp);
    int (*solve)(void *model);
    void (*close)(void *model);
};

#ifdef BENCH_GLPK

static void glpk_change(void *model, const struct program *lp)
{
    int row[7], j, k;
    for (j = 0; j < lp->cols; j++) {
        const int n = lp->start[j + 1] - lp->start[j];
        for (k = 0; k < n; k++)
            row[k + 1] = lp->row[lp->start[j] + k] + 1;
        glp_set_mat_col(model, j + 1, n, row, lp->value + lp->start[j] - 1);
    }
}

static void *glpk_open(const struct program *lp)
{
    glp_prob *p = glp_create_prob();
    int i, j;
    glp_add_rows(p, lp->rows);
    glp_add_cols(p, lp->cols);
    for (i = 0; i < lp->rows; i++)
        glp_set_row_bnds(p, i + 1, GLP_FX, lp->rhs[i], 0);
    for (j = 0; j < lp->cols; j++)
        glp_set_col_bnds(p, j + 1, GLP_LO, 0, 0);
    glpk_change(p, lp);
    glp_std_basis(p);
    return p;
}

/* Where two points of a contact coincide the last basis may be singular. That
   is an error and no answer: it starts again from the slacks. */
static int glpk_solve(void *model)
{
    glp_smcp how;
    int status;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_DUAL;
    how.presolve = GLP_OFF;
    how.pricing = GLP_PT_STD; /* some 10 % faster here than the default       */
    if (glp_simplex(model, &how)) {
        glp_std_basis(model);
        if (glp_simplex(model, &how))
            return -1;
    }
    status = glp_get_status(model);
    return status == GLP_OPT ? 1 : status == GLP_NOFEAS ? 0 : -1;
}

static void glpk_close(void *model)
{
    glp_delete_prob(model);
}

#endif
#ifdef BENCH_CLP

/* Writes into the matrix itself: the door for single entries searches the
   column for each. It is used once, to tell Clp that there was a change. */
static void clp_change(void *model, const struct program *lp)
{
    memcpy((void *)Clp_getElements(model), lp->value,
           (size_t)lp->start[lp->cols] * sizeof(double));
    Clp_modifyCoefficient(model, lp->row[0], 0, lp->value[0], 1);
}

static void *clp_open(const struct program *lp)
{
    Clp_Simplex *p = Clp_newModel();
    Clp_setLogLevel(p, 0);
    Clp_loadProblem(p, lp->cols, lp->rows, lp->start, lp->row, lp->value,
                    NULL, NULL, NULL, lp->rhs, lp->rhs);
    return p;
}

static int clp_solve(void *model)
{
    const int failed = Clp_dual(model, 0);
    const int status = Clp_status(model);
    if (failed < 0)
        return -1;
    return status == 0 ? 1 : status == 1 ? 0 : -1;
}

static void clp_close(void *model)
{
    Clp_deleteModel(model);
}

#endif

/* ---- Quantities ---------------------------------------------------------- */

/* Everything that is known of a structure. A new one needs a line here, a
   place in a measure_...() function, and, if it has a goal, a line in goals[].
   Widths are those of the tables. */
#define QUANTITIES_OF(X)                                                      \
    X(VERDICT, "verdict")       /* ms: kern_stands at 0                     */\
    X(MEASURE, "measure")       /* kern_measure with both proofs            */\
    X(SCAN, "scan")             /* kern_stands at each of the 20 levels     */\
    X(LOAD, "load")             /* kern_load_factor to the right            */\
    X(TILT, "tilt")             /* kern_tilt to the right                   */\
    X(SEARCH, "search")         /* kern_contacts                            */\
    X(CRITICAL, "at d*")        /* kern_stands at the margin                */\
    X(CLOSED, "closed")         /* kern_stands with every kern closed       */\
    X(GLPK_COLD, "GLPK")                                                      \
    X(GLPK_WARM, "GLPK A1")                                                   \
    X(CLP_COLD, "Clp")                                                        \
    X(CLP_WARM, "Clp A1")                                                     \
    X(PEER_COLD, "peer")        /* the faster peer                          */\
    X(PEER_WARM, "peer A1")                                                   \
    X(PEER_CRITICAL, "peer d*")                                               \
    X(PEER_CLOSED, "peer cl.")                                                \
    X(TRY, "try")               /* ms: kern_plan_try of a candidate         */\
    X(FRESH, "fresh")           /* kern_measure with it                     */\
    X(TRY_SHARE, "try/fresh")   /* median of ratios                         */\
    X(WALL_SHARE, "walls")      /* the same, of walls alone                 */\
    X(TRY_WORST, "worst")                                                     \
    X(TRY_SEARCHED, "/+search") /* over kern_contacts and kern_measure      */\
    X(TRY_FALLS, "if falls")    /* over the verdict that it falls           */\
    X(PLACES, "places")         /* where it stands                          */\
    X(RATE, "per s")            /* candidates                               */\
    X(POINTS, "points")         /* contact points                           */\
    X(MARGIN, "d*/d_max")                                                     \
    X(PIVOTS, "pivots")         /* of the measure                           */\
    X(SOLVES, "LPs")                                                          \
    X(FIRST, "pivots 0")        /* of the verdict at 0                      */\
    X(MEMORY, "work KB")                                                      \
    X(LEAN, "least KB")         /* with which the measure is the same       */\
    X(ALL_MEMORY, "all KB")     /* with the blocks and contacts             */

enum quantity {
#define QUANTITY_NAME(name, text) name,
    QUANTITIES_OF(QUANTITY_NAME)
#undef QUANTITY_NAME
    QUANTITIES
};

static const char *const quantity_text[] = {
#define QUANTITY_TEXT(name, text) text,
    QUANTITIES_OF(QUANTITY_TEXT)
#undef QUANTITY_TEXT
};

static const struct peer peers[] = {
#ifdef BENCH_GLPK
    {"GLPK", GLPK_COLD, GLPK_WARM, 200, 200, glpk_open, glpk_change,
     glpk_solve, glpk_close},
#endif
#ifdef BENCH_CLP
    {"Clp", CLP_COLD, CLP_WARM, 2000, 1000, clp_open, clp_change, clp_solve,
     clp_close},
#endif
    {NULL, 0, 0, 0, 0, NULL, NULL, NULL, NULL},
};

struct sample {
    int family, size, number;
    double value[QUANTITIES];
};

struct bench {
    struct patience patience;
    int size[16], sizes;
    int family;            /* -1: all                                         */
    int number;            /* -1: as many as are due                          */
    int quick, summary, print;
    int most;              /* of larger structures only contacts are searched */
    struct sample *sample;
    int samples, room;
    int checks, differences, silent;
};

/* ---- Agreement ----------------------------------------------------------- */

static void check(struct bench *bench, const struct sample *sample, int agree,
                  const char *what, double ours, double theirs)
{
    bench->checks++;
    if (agree)
        return;
    bench->differences++;
    fprintf(bench->summary ? stderr : stdout,
            "DISAGREE %s/%d/%d: %s: %.12g, %.12g\n",
            families[sample->family].name, sample->size, sample->number, what,
            ours, theirs);
}

/* Algorithm 1, with anybody's verdicts (1, 0, -1: none): -1 for no answer. */
static int algorithm_1(int (*stands)(void *data, double shrink), void *data,
                       double most, double step)
{
    const int last = (int)ceil(most / step);
    int k;
    for (k = 0; k <= last; k++) {
        const int verdict = stands(data, fmin(k * step, most));
        if (verdict != 1)
            return verdict < 0 ? -1 : k;
    }
    return last + 1;
}

/* ---- Ours ---------------------------------------------------------------- */

/* A question to kern.h and its answer. */
struct ask {
    struct scene *scene;
    kern_work work;
    kern_proof proof;
    kern_contact *contact; /* for contact search                              */
    double shrink;
    kern_status status;
    kern_margin margin;
    double number;         /* level, load factor, angle or count              */
};

static void ask_open(struct ask *ask, struct scene *scene)
{
    int reals, ints;
    kern_work_need(scene->blocks, scene->contacts, &reals, &ints);
    memset(ask, 0, sizeof *ask);
    ask->scene = scene;
    ask->work = kern_work_of(room_for((size_t)reals, sizeof(kern_real)), reals,
                             room_for((size_t)ints, sizeof(int)), ints);
    ask->proof.force = room_for((size_t)scene->contacts, sizeof(kern_force));
    ask->proof.motion = room_for((size_t)scene->blocks, sizeof(kern_motion));
    ask->contact = room_for((size_t)scene->room, sizeof(kern_contact));
}

static void ask_close(struct ask *ask)
{
    free(ask->work.real);
    free(ask->work.index);
    free(ask->proof.force);
    free(ask->proof.motion);
    free(ask->contact);
}

static void run_verdict(void *data)
{
    struct ask *ask = data;
    ask->status = kern_stands(&ask->scene->s, ask->shrink,
                              &ask->scene->options, &ask->work, NULL);
}

static void run_measure(void *data)
{
    struct ask *ask = data;
    ask->status = kern_measure(&ask->scene->s, &ask->scene->options,
                               &ask->work, &ask->margin, &ask->proof);
}

static int ask_stands(void *data, double shrink)
{
    struct ask *ask = data;
    ask->shrink = shrink;
    run_verdict(ask);
    return ask->status == KERN_STANDS ? 1 : ask->status == KERN_FALLS ? 0 : -1;
}

static void run_scan(void *data)
{
    struct ask *ask = data;
    ask->number = algorithm_1(ask_stands, ask, ask->margin.most,
                              ask->scene->options.epsilon);
}

static void run_load(void *data)
{
    struct ask *ask = data;
    ask->status = kern_load_factor(&ask->scene->s, 0, NULL, 1,
                                   &ask->scene->options, &ask->work,
                                   &ask->number, NULL);
}

static void run_tilt(void *data)
{
    struct ask *ask = data;
    ask->status = kern_tilt(&ask->scene->s, 0, 1, &ask->scene->options,
                            &ask->work, &ask->number, NULL);
}

static void run_search(void *data)
{
    struct ask *ask = data;
    const struct scene *scene = ask->scene;
    ask->number = kern_contacts(scene->block, scene->blocks, &scene->options,
                                ask->contact, scene->room, &ask->work);
}

static double ask_time(const struct bench *bench, struct ask *ask,
                       void (*run)(void *data))
{
    struct job job;
    job.ready = NULL;
    job.run = run;
    job.data = ask;
    return time_job(&job, &bench->patience);
}

/* The verdict at 0, the margin, and the step that makes of it 20 levels: the
   last that stands is half a step below the margin. */
static kern_status measure_margin(struct bench *bench, struct sample *sample,
                                  struct ask *ask)
{
    struct scene *scene = ask->scene;
    kern_status first;
    ask->shrink = 0;
    run_verdict(ask);
    first = ask->status;
    sample->value[FIRST] = ask->work.pivots;
    check(bench, sample, first >= 0, "verdict at 0, status", first, 0);
    if (first < 0)
        return first;
    sample->value[VERDICT] = ask_time(bench, ask, run_verdict);
    run_measure(ask);
    check(bench, sample, first == ask->status,
          "verdict at 0, of the measure", first, ask->status);
    if (ask->status != KERN_STANDS || !(ask->margin.margin > 0))
        return ask->status;
    scene->options.epsilon = ask->margin.margin / (LEVELS - 0.5);
    ask->work.pivots = ask->work.solves = 0;
    run_measure(ask);
    sample->value[PIVOTS] = ask->work.pivots;
    sample->value[SOLVES] = ask->work.solves;
    sample->value[MARGIN] = ask->margin.margin / ask->margin.most;
    sample->value[MEASURE] = ask_time(bench, ask, run_measure);
    return ask->status;
}

/* The proofs of the measure, and how near to each other they are. */
static void measure_proofs(struct bench *bench, struct sample *sample,
                           struct ask *ask)
{
    const struct scene *scene = ask->scene;
    const kern_margin *m = &ask->margin;
    double error = kern_check_forces(&scene->s, m->holds, &scene->options,
                                     ask->proof.force, &ask->work);
    check(bench, sample, error <= 1, "error of the forces", error, 1);
    if (m->saturated)
        return;
    error = kern_check_motion(&scene->s, m->fails, &scene->options,
                              ask->proof.motion);
    check(bench, sample, error <= 1, "error of the motion", error, 1);
    check(bench, sample, m->fails - m->holds
          <= 2e-6 * kern_mean_size(scene->block, scene->blocks),
          "bracket of the margin", m->holds, m->fails);
}

/* Fresh verdicts on both sides of the margin, and the literal scan. Between
   the proven bounds both answers may be proven, within the tolerances. */
static void measure_levels(struct bench *bench, struct sample *sample,
                           struct ask *ask)
{
    const struct scene *scene = ask->scene;
    const kern_margin *m = &ask->margin;
    const double near = NEAR * kern_mean_size(scene->block, scene->blocks);
    check(bench, sample, ask_stands(ask, fmax(m->margin - near, 0)) == 1,
          "status below the margin", ask->status, m->margin);
    if (!m->saturated && m->margin + near < m->most)
        check(bench, sample, ask_stands(ask, m->margin + near) == 0,
              "status above the margin", ask->status, m->margin);
    if (sample->size > SCAN_MOST)
        return;
    sample->value[SCAN] = ask_time(bench, ask, run_scan);
    check(bench, sample, (int)ask->number == m->level
          || m->epsilon < 2 * near, "scan, level", ask->number, m->level);
}

/* Verdicts just at the margin, where no answer is an answer too, and with
   every kern closed. */
static void measure_edge(struct bench *bench, struct sample *sample,
                         struct ask *ask)
{
    ask->shrink = ask->margin.margin;
    sample->value[CRITICAL] = ask_time(bench, ask, run_verdict);
    ask->shrink = ask->margin.most;
    sample->value[CLOSED] = ask_time(bench, ask, run_verdict);
    check(bench, sample, ask->margin.saturated || ask->status == KERN_FALLS
          || ask->margin.most - ask->margin.margin < NEAR * ask->margin.most,
          "falls with its kerns closed", ask->status, ask->margin.margin);
}

/* Without loads the tilt is the angle of the load factor. */
static void measure_sideways(struct bench *bench, struct sample *sample,
                             struct ask *ask)
{
    double factor;
    sample->value[LOAD] = ask_time(bench, ask, run_load);
    factor = ask->number;
    check(bench, sample, ask->status == KERN_STANDS, "load factor",
          ask->status, factor);
    sample->value[TILT] = ask_time(bench, ask, run_tilt);
    check(bench, sample, ask->status == KERN_STANDS, "tilt", ask->status,
          ask->number);
    if (ask->number < 1.5 && factor < 10)
        check(bench, sample,
              fabs(tan(ask->number) - factor) <= 1e-5 * (1 + factor * factor),
              "tan(tilt), load factor", tan(ask->number), factor);
}

/* ---- Candidates ---------------------------------------------------------- */

/* A plan of a structure, and a stone that is tried on it. */
struct site {
    const struct scene *scene;
    kern_plan plan;
    kern_work work;
    kern_vec corner[4];
    kern_block stone;
    kern_contact *found;   /* of all blocks with the stone                    */
    kern_status status;
    kern_margin margin;
};

static void site_open(struct site *site, const struct scene *scene)
{
    const int blocks = scene->blocks + 1, contacts = scene->room;
    int reals, ints, i;
    memset(site, 0, sizeof *site);
    site->scene = scene;
    kern_work_need(blocks, contacts, &reals, &ints);
    site->work = kern_work_of(room_for((size_t)reals, sizeof(kern_real)),
                              reals, room_for((size_t)ints, sizeof(int)),
                              ints);
    site->found = room_for((size_t)contacts, sizeof(kern_contact));
    site->plan = kern_plan_of(
        room_for((size_t)blocks, sizeof(kern_block)), blocks,
        room_for((size_t)contacts, sizeof(kern_contact)), contacts,
        room_for((size_t)KERN_PLAN_INTS(blocks), sizeof(int)), &site->work);
    site->plan.options = scene->options;
    for (i = 0; i < scene->blocks; i++)
        kern_plan_add(&site->plan, &scene->block[i]);
}

static void site_close(struct site *site)
{
    free(site->work.real);
    free(site->work.index);
    free(site->found);
    free(site->plan.block);
    free(site->plan.contact);
    free(site->plan.known.basis);
}

/* Lays the stone, a brick, on the last edge but one of a block, its upper
   face: from that share of the face on, and maybe over its end. */
static void site_lay(struct site *site, int block, double share)
{
    const kern_block *b = &site->scene->block[block];
    const kern_vec right = b->vertex[b->vertices - 2];
    const kern_vec left = b->vertex[b->vertices - 1];
    const double face = hypot(right.x - left.x, right.y - left.y);
    const double ux = (right.x - left.x) / face, uy = (right.y - left.y) / face;
    kern_vec *v = site->corner;
    v[0].x = left.x + share * face * ux;
    v[0].y = left.y + share * face * uy;
    v[1].x = v[0].x + 0.8 * LENGTH * ux;
    v[1].y = v[0].y + 0.8 * LENGTH * uy;
    v[2].x = v[1].x - 0.5 * LENGTH * uy;
    v[2].y = v[1].y + 0.5 * LENGTH * ux;
    v[3].x = v[0].x - 0.5 * LENGTH * uy;
    v[3].y = v[0].y + 0.5 * LENGTH * ux;
    kern_block_init(&site->stone, v, 4, DENSITY, NULL);
}

static void run_try(void *data)
{
    struct site *site = data;
    site->status = kern_plan_try(&site->plan, &site->stone, &site->margin,
                                 NULL);
}

/* Of a plan to which the stone was added: kern_measure knows nothing of it. */
static void run_fresh(void *data)
{
    struct site *site = data;
    site->status = kern_measure(&site->plan.s, &site->plan.options,
                                &site->work, &site->margin, NULL);
}

static void run_searched(void *data)
{
    struct site *site = data;
    kern_structure s = site->plan.s;
    s.contact = site->found;
    s.contacts = kern_contacts(s.block, s.blocks, &site->plan.options,
                               site->found, site->scene->room, &site->work);
    site->status = kern_measure(&s, &site->plan.options, &site->work,
                                &site->margin, NULL);
}

static double site_time(const struct bench *bench, struct site *site,
                        void (*run)(void *data))
{
    struct job job;
    job.ready = NULL;
    job.run = run;
    job.data = site;
    return time_job(&job, &bench->patience);
}

/* Numbers of the candidates of a structure. */
struct places {
    int stand, fall;
    double time;           /* of all                                          */
    double tried[PLACES_MOST], fresh[PLACES_MOST], share[PLACES_MOST];
    double searched[PLACES_MOST], falls[PLACES_MOST];
};

/* One candidate; the answer must be that of a fresh structure. */
static void measure_place(struct bench *bench, struct sample *sample,
                          struct site *site, struct places *places)
{
    const kern_plan before = site->plan;
    const double tried = site_time(bench, site, run_try);
    const kern_status status = site->status;
    const kern_margin m = site->margin;
    double fresh;
    places->time += tried;
    if (status < 0) {
        check(bench, sample, status == KERN_OVERLAP, "candidate, status",
              status, KERN_OVERLAP);
        return;
    }
    kern_plan_add(&site->plan, &site->stone);
    fresh = site_time(bench, site, run_fresh);
    check(bench, sample, site->status == status, "candidate, verdict", status,
          site->status);
    if (status == KERN_FALLS) {
        places->falls[places->fall++] = tried / fresh;
    } else {
        check(bench, sample, fabs(m.margin - site->margin.margin) <= 1e-9
              * kern_mean_size(site->plan.block, site->plan.s.blocks),
              "candidate, margin", m.margin, site->margin.margin);
        check(bench, sample, m.level == site->margin.level,
              "candidate, level", m.level, site->margin.level);
        places->tried[places->stand] = tried;
        places->fresh[places->stand] = fresh;
        places->searched[places->stand] = tried
            / site_time(bench, site, run_searched);
        places->share[places->stand++] = tried / fresh;
    }
    site->plan = before;
}

/* Places on top: beside, within and across the ends of upper faces. */
static void measure_places(struct bench *bench, struct sample *sample,
                           const struct scene *scene)
{
    static const double share[] = {-0.3, 0.05, 0.4, -0.8};
    const int places = sample->size <= 50 ? PLACES_MOST
                     : sample->size <= 200 ? 8 : 4;
    struct places all;
    struct site site;
    int block = scene->blocks - 1, count = 0, i;
    all.stand = all.fall = 0;
    all.time = 0;
    site_open(&site, scene);
    kern_plan_measure(&site.plan, &site.margin, NULL);
    for (; block > 0 && count < places; block--) {
        if (scene->block[block].fixed)
            continue;
        for (i = 0; i < 4 && count < places; i++, count++) {
            site_lay(&site, block, share[i]);
            measure_place(bench, sample, &site, &all);
        }
    }
    sample->value[PLACES] = all.stand;
    sample->value[RATE] = 1000 * count / all.time;
    sample->value[TRY] = median(all.tried, all.stand);
    sample->value[FRESH] = median(all.fresh, all.stand);
    sample->value[TRY_SHARE] = median(all.share, all.stand);
    if (families[sample->family].wall)
        sample->value[WALL_SHARE] = sample->value[TRY_SHARE];
    if (all.stand > 0)
        sample->value[TRY_WORST] = all.share[all.stand - 1];
    sample->value[TRY_SEARCHED] = median(all.searched, all.stand);
    sample->value[TRY_FALLS] = median(all.falls, all.fall);
    site_close(&site);
}

/* ---- Theirs -------------------------------------------------------------- */

struct rival {
    const struct peer *peer;
    struct program *lp;
    void *model;
    double shrink;         /* at which the model is made                      */
    double most, step;     /* for Algorithm 1                                 */
    int answer;
};

static void rival_ready(void *data)
{
    struct rival *r = data;
    if (r->model)
        r->peer->close(r->model);
    program_shrink(r->lp, r->shrink);
    r->model = r->peer->open(r->lp);
}

static void rival_solve(void *data)
{
    struct rival *r = data;
    r->answer = r->peer->solve(r->model);
}

static int rival_stands(void *data, double shrink)
{
    struct rival *r = data;
    if (shrink > r->lp->shrink || shrink < r->lp->shrink) {
        program_shrink(r->lp, shrink);
        r->peer->change(r->model, r->lp);
    }
    return r->peer->solve(r->model);
}

static void rival_levels(void *data)
{
    struct rival *r = data;
    r->answer = algorithm_1(rival_stands, r, r->most, r->step);
}

static double rival_time(const struct bench *bench, struct rival *r,
                         double shrink, void (*run)(void *data))
{
    struct job job;
    job.ready = rival_ready;
    job.run = run;
    job.data = r;
    r->shrink = shrink;
    return time_job(&job, &bench->patience);
}

static void keep_least(double *value, double candidate)
{
    if (*value < 0 || candidate < *value)
        *value = candidate;
}

/* One peer's Algorithm 1, and single programs where answers are delicate.
   Differences count unless the shrinkage is as good as critical. */
static void measure_delicate(struct bench *bench, struct sample *sample,
                             struct rival *r, const kern_margin *m)
{
    const double near = NEAR * r->lp->length;
    const struct peer *peer = r->peer;
    if (sample->size <= peer->warm_most) {
        sample->value[peer->warm] = rival_time(bench, r, 0, rival_levels);
        keep_least(&sample->value[PEER_WARM], sample->value[peer->warm]);
        bench->silent += r->answer < 0;
        check(bench, sample, r->answer < 0 || r->answer == m->level
              || m->epsilon < 2 * near || m->saturated, peer->name, m->level,
              r->answer);
    }
    keep_least(&sample->value[PEER_CRITICAL],
               rival_time(bench, r, m->margin, rival_solve));
    keep_least(&sample->value[PEER_CLOSED],
               rival_time(bench, r, m->most, rival_solve));
    bench->silent += r->answer < 0;
    check(bench, sample, r->answer < 1 || m->saturated
          || m->most - m->margin < near, "peer stands with kerns closed",
          m->margin, m->most);
}

static void measure_peers(struct bench *bench, struct sample *sample,
                          const struct ask *ask, kern_status status)
{
    struct program lp;
    struct rival r;
    program_open(&lp, ask->scene);
    memset(&r, 0, sizeof r);
    r.lp = &lp;
    r.most = ask->margin.most;
    r.step = ask->scene->options.epsilon;
    for (r.peer = peers; r.peer->name; r.peer++) {
        if (sample->size > r.peer->cold_most)
            continue;
        sample->value[r.peer->cold] = rival_time(bench, &r, 0, rival_solve);
        keep_least(&sample->value[PEER_COLD], sample->value[r.peer->cold]);
        bench->silent += r.answer < 0;
        check(bench, sample, r.answer < 0 || r.answer == (status == KERN_STANDS)
              || (status == KERN_STANDS
                  && ask->margin.margin < NEAR * lp.length),
              "verdict at 0, of a peer", status, r.answer);
        if (status == KERN_STANDS && ask->margin.margin > 0)
            measure_delicate(bench, sample, &r, &ask->margin);
        r.peer->close(r.model);
        r.model = NULL;
    }
    program_close(&lp);
}

/* ---- One structure ------------------------------------------------------- */

static void measure_memory(struct sample *sample, const struct ask *ask)
{
    const struct scene *scene = ask->scene;
    const double work = (double)ask->work.reals * sizeof(kern_real)
        + (double)ask->work.indices * sizeof(int);
    const double lean
        = (double)KERN_LEAN_REALS(scene->blocks, scene->contacts)
          * sizeof(kern_real)
        + (double)KERN_LEAN_INTS(scene->blocks, scene->contacts)
          * sizeof(int);
    sample->value[POINTS] = scene->contacts;
    sample->value[MEMORY] = work / 1024;
    sample->value[LEAN] = lean / 1024;
    sample->value[ALL_MEMORY] = (work
        + (double)scene->blocks * sizeof(kern_block)
        + (double)scene->contacts * sizeof(kern_contact)) / 1024;
}

/* The same question with lean memory, which is not enough for every arch. */
static void measure_lean(struct bench *bench, struct sample *sample,
                         const struct ask *whole)
{
    const struct scene *scene = whole->scene;
    struct ask ask = *whole;
    ask.proof.force = NULL;
    ask.proof.motion = NULL;
    ask.work.reals = KERN_LEAN_REALS(scene->blocks, scene->contacts);
    ask.work.indices = KERN_LEAN_INTS(scene->blocks, scene->contacts);
    run_measure(&ask);
    if (ask.status == KERN_NO_SPACE)
        sample->value[LEAN] = sample->value[MEMORY];
    else
        check(bench, sample, ask.status == whole->status
              && ask.margin.level == whole->margin.level
              && fabs(ask.margin.margin - whole->margin.margin)
                 < 1e-9 * LENGTH,
              "margin with lean memory", whole->margin.margin,
              ask.margin.margin);
}

static void measure_structure(struct bench *bench, struct sample *sample)
{
    struct scene scene;
    struct ask ask;
    kern_status status;
    int i;
    for (i = 0; i < QUANTITIES; i++)
        sample->value[i] = MISSING;
    scene_open(&scene, sample->family, sample->size, sample->number);
    if (bench->print) {
        scene_print(&scene);
        scene_close(&scene);
        return;
    }
    ask_open(&ask, &scene);
    measure_memory(sample, &ask);
    sample->value[SEARCH] = ask_time(bench, &ask, run_search);
    if (sample->size > bench->most) {
        ask_close(&ask);
        scene_close(&scene);
        return;
    }
    status = measure_margin(bench, sample, &ask);
    measure_lean(bench, sample, &ask);
    if (status == KERN_STANDS && ask.margin.margin > 0) {
        const kern_margin m = ask.margin;
        measure_proofs(bench, sample, &ask);
        measure_levels(bench, sample, &ask);
        measure_edge(bench, sample, &ask);
        measure_sideways(bench, sample, &ask);
        if (sample->size <= PLAN_MOST)
            measure_places(bench, sample, &scene);
        ask.margin = m;
    }
    measure_peers(bench, sample, &ask, status);
    ask_close(&ask);
    scene_close(&scene);
}

/* Structures of a family: fewer where each takes long. */
static int numbers_of(const struct bench *bench, int size)
{
    if (bench->quick)
        return size <= 100 ? 3 : 1;
    return size <= 50 ? 15 : size <= 200 ? 7 : size <= 1000 ? 3 : 2;
}

static void measure_size(struct bench *bench, int size)
{
    const int from = bench->number < 0 ? 0 : bench->number;
    const int to = bench->number < 0 ? numbers_of(bench, size) : from + 1;
    int family, number;
    for (family = 0; family < FAMILIES; family++) {
        if (bench->family >= 0 && family != bench->family)
            continue;
        fprintf(stderr, "%s/%d ", families[family].name, size);
        for (number = from; number < to; number++) {
            struct sample *sample = &bench->sample[bench->samples];
            if (bench->samples == bench->room)
                return;
            sample->family = family;
            sample->size = size;
            sample->number = number;
            measure_structure(bench, sample);
            bench->samples++;
            fprintf(stderr, ".");
        }
        fprintf(stderr, "\n");
    }
}

/* ---- Medians of structures ----------------------------------------------- */

/* A quantity, or its ratio to another one; MISSING where it was not taken. */
struct figure {
    int over, under;       /* quantities; under -1: no ratio                  */
};

static double figure_of(const struct figure *f, const struct sample *sample)
{
    const double over = sample->value[f->over];
    if (f->under < 0 || over < 0)
        return over;
    return sample->value[f->under] > 0 ? over / sample->value[f->under]
                                       : MISSING;
}

/* Over the structures of a family and size (0: all sizes). */
static double family_median(const struct bench *bench, const struct figure *f,
                            int family, int size)
{
    double *number = room_for((size_t)bench->samples, sizeof(double));
    double result;
    int i, n = 0;
    for (i = 0; i < bench->samples; i++) {
        const struct sample *sample = &bench->sample[i];
        const double v = figure_of(f, sample);
        if (sample->family == family && (size == 0 || sample->size == size)
            && v >= 0)
            number[n++] = v;
    }
    result = median(number, n);
    free(number);
    return result;
}

static double size_median(const struct bench *bench, const struct figure *f,
                          int size)
{
    double number[FAMILIES];
    int family, n = 0;
    for (family = 0; family < FAMILIES; family++) {
        const double v = family_median(bench, f, family, size);
        if (families[family].counts && v >= 0)
            number[n++] = v;
    }
    return median(number, n);
}

/* The structure with the largest figure; NULL: none. */
static const struct sample *size_worst(const struct bench *bench,
                                       const struct figure *f, int size)
{
    const struct sample *worst = NULL;
    int i;
    for (i = 0; i < bench->samples; i++) {
        const struct sample *sample = &bench->sample[i];
        if ((size == 0 || sample->size == size) && figure_of(f, sample) >= 0
            && (!worst || figure_of(f, sample) > figure_of(f, worst)))
            worst = sample;
    }
    return worst;
}

/* The slope of log(family's median) over log(size), by least squares from 100
   blocks on; MISSING with fewer than two sizes. */
static double growth(const struct bench *bench, int quantity, int family)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    struct figure f;
    int i;
    f.over = quantity;
    f.under = -1;
    for (i = 0; i < bench->sizes; i++) {
        const double v = family_median(bench, &f, family, bench->size[i]);
        if (v > 0 && bench->size[i] >= 100) {
            const double lx = log((double)bench->size[i]), ly = log(v);
            n++;
            x += lx;
            y += ly;
            xx += lx * lx;
            xy += lx * ly;
        }
    }
    return n < 2 ? MISSING : (n * xy - x * y) / (n * xx - x * x);
}

/* ---- Tables -------------------------------------------------------------- */

static void print_number(double v)
{
    if (v < 0)
        printf(" %8s |", "");
    else if (v >= 100)
        printf(" %8.0f |", v);
    else
        printf(" %8.3g |", v);
}

static void print_title(const char *title, const char *first)
{
    printf("\n%s\n\n| %-34s |", title, first);
}

static void print_rule(int columns)
{
    int i;
    printf("\n|%.36s|", "------------------------------------------");
    for (i = 0; i < columns; i++)
        printf("---------:|");
    printf("\n");
}

/* Rows: sizes, medians over families, and each family's; columns: quantities.
   Sizes without any of the first quantity are left out. */
static void table_quantities(const struct bench *bench, const char *title,
                             const int *quantity, int columns)
{
    struct figure f;
    int i, k, family;
    f.under = -1;
    print_title(title, "blocks");
    for (k = 0; k < columns; k++)
        printf(" %8s |", quantity_text[quantity[k]]);
    print_rule(columns);
    for (i = 0; i < bench->sizes; i++)
        for (family = -1; family < FAMILIES; family++) {
            double v[QUANTITIES], any = MISSING;
            for (k = 0; k < columns; k++) {
                f.over = quantity[k];
                v[k] = family < 0
                    ? size_median(bench, &f, bench->size[i])
                    : family_median(bench, &f, family, bench->size[i]);
                any = v[k] > any ? v[k] : any;
            }
            if (any < 0)
                continue;
            printf("| %5d %-28s |", bench->size[i],
                   family < 0 ? "median over families"
                              : families[family].name);
            for (k = 0; k < columns; k++)
                print_number(v[k]);
            printf("\n");
        }
}

static void print_families_head(int worst)
{
    int family;
    printf(" %8s |", "median");
    for (family = 0; family < FAMILIES; family++)
        printf(" %8s |", families[family].name);
    if (worst)
        printf(" %8s |", "worst");
    print_rule(FAMILIES + 1 + worst);
}

/* One ratio at one size: median, families, the worst and its name. */
static double print_ratio(const struct bench *bench, const struct figure *f,
                          int size)
{
    const struct sample *worst = size_worst(bench, f, size);
    const double m = size_median(bench, f, size);
    int family;
    print_number(m);
    for (family = 0; family < FAMILIES; family++)
        print_number(family_median(bench, f, family, size));
    if (worst) {
        print_number(figure_of(f, worst));
        printf(" %s/%d/%d", families[worst->family].name, worst->size,
               worst->number);
    }
    return m;
}

static void table_ratios(const struct bench *bench, const char *title,
                         int over, int under)
{
    struct figure f;
    int i;
    f.over = over;
    f.under = under;
    if (!size_worst(bench, &f, 0))
        return;
    print_title(title, "blocks");
    print_families_head(1);
    for (i = 0; i < bench->sizes; i++)
        if (size_worst(bench, &f, bench->size[i])) {
            printf("| %5d %-28s |", bench->size[i], "");
            print_ratio(bench, &f, bench->size[i]);
            printf("\n");
        }
}

/* What must be true. Size 0: over all sizes. */
static const struct goal {
    const char *text;
    struct figure figure;
    int size;
    double most;
} goals[] = {
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 5, 0.12},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 10, 0.06},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 30, 0.03},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 50, 0.03},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 100, 0.03},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 200, 0.03},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 500, 0.03},
    {"verdict at 0 / cold LP", {VERDICT, PEER_COLD}, 1000, 0.03},
    {"Algorithm 1 / warm Algorithm 1", {MEASURE, PEER_WARM}, 30, 0.04},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 5, 0.5},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 10, 0.3},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 30, 0.15},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 100, 0.12},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 200, 0.25},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 500, 0.25},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 1000, 0.35},
    {"measure / cold LP", {MEASURE, PEER_COLD}, 2000, 0.5},
    {"candidate on a wall / measure", {WALL_SHARE, -1}, 50, 0.15},
    {"work memory, lean, KB", {LEAN, -1}, 1000, 4096},
    {"load factor / measure", {LOAD, MEASURE}, 0, 2},
    {"tilt / measure", {TILT, MEASURE}, 0, 2},
};

static void print_goal(double value, double most)
{
    printf(" goal %g%s\n", most, value < 0 ? "" : value <= most ? ", met"
                                                                : ", MISSED");
}

/* The median of the exponents on walls. */
static double growth_on_walls(const struct bench *bench)
{
    double number[FAMILIES];
    int family, n = 0;
    for (family = 0; family < FAMILIES; family++) {
        const double v = growth(bench, MEASURE, family);
        if (families[family].wall && families[family].counts && v >= 0)
            number[n++] = v;
    }
    return median(number, n);
}

/* Growth on walls is a goal; the other exponents stand in their own table. */
static void print_goal_growth(const struct bench *bench)
{
    const double m = growth_on_walls(bench);
    int family;
    if (m < 0)
        return;
    printf("| %-34s |", "growth of the measure, walls");
    print_number(m);
    for (family = 0; family < FAMILIES; family++)
        print_number(families[family].wall ? growth(bench, MEASURE, family)
                                           : MISSING);
    print_number(MISSING);
    print_goal(m, GROWTH_GOAL);
}

/* Work memory for 30 blocks on the ground and 70 line contacts [KB]. */
static double memory_of_30(void)
{
    return (KERN_LEAN_REALS(31, 140) * (double)sizeof(kern_real)
        + KERN_LEAN_INTS(31, 140) * (double)sizeof(int)) / 1024;
}

/* The same with all that it is about. */
static double all_memory_of_30(void)
{
    return memory_of_30() + (31 * (double)sizeof(kern_block)
        + 140 * (double)sizeof(kern_contact)) / 1024;
}

static void print_goal_memory(const char *text, double kb)
{
    int i;
    printf("| %-34s |", text);
    print_number(kb);
    for (i = 0; i <= FAMILIES; i++)
        print_number(MISSING);
    print_goal(kb, MEMORY_GOAL);
}

static void table_goals(const struct bench *bench)
{
    size_t i;
    print_title("GOALS: medians, and the worst structure", "");
    print_families_head(1);
    for (i = 0; i < sizeof goals / sizeof goals[0]; i++) {
        const struct goal *g = &goals[i];
        double m;
        if (!size_worst(bench, &g->figure, g->size))
            continue;
        if (g->size)
            printf("| %-29s %4d |", g->text, g->size);
        else
            printf("| %-29s %4s |", g->text, "all");
        m = print_ratio(bench, &g->figure, g->size);
        print_goal(m, g->most);
    }
    print_goal_growth(bench);
    print_goal_memory("30 blocks, 70 lines: lean work, KB", memory_of_30());
    print_goal_memory("  with blocks and contacts, KB", all_memory_of_30());
}

static void table_growth(const struct bench *bench)
{
    static const int quantity[] = {VERDICT, MEASURE, SCAN,     LOAD,
                                   TILT,    SEARCH,  CLP_COLD, CLP_WARM};
    const int columns = (int)(sizeof quantity / sizeof quantity[0]);
    int family, k;
    print_title("GROWTH: exponent of the time from 100 blocks on", "family");
    for (k = 0; k < columns; k++)
        printf(" %8s |", quantity_text[quantity[k]]);
    print_rule(columns);
    for (family = 0; family < FAMILIES; family++) {
        printf("| %-34s |", families[family].name);
        for (k = 0; k < columns; k++)
            print_number(growth(bench, quantity[k], family));
        printf("\n");
    }
}

/* Structures on which a peer's single LP is more than twice as fast. */
static void table_slow(const struct bench *bench)
{
    static const struct figure figure[] = {{VERDICT, PEER_COLD},
                                           {MEASURE, PEER_COLD},
                                           {CRITICAL, PEER_CRITICAL},
                                           {CLOSED, PEER_CLOSED}};
    int i, found = 0;
    size_t k;
    for (i = 0; i < bench->samples; i++)
        for (k = 0; k < sizeof figure / sizeof figure[0]; k++) {
            const struct sample *sample = &bench->sample[i];
            const double v = figure_of(&figure[k], sample);
            if (v <= 2)
                continue;
            printf("%sabove 2: %s/%d/%d %s %.3g\n", found++ ? "" : "\n",
                   families[sample->family].name, sample->size,
                   sample->number, quantity_text[figure[k].over], v);
        }
    if (!found)
        printf("\nNo structure is above 2.\n");
}

static void print_tables(const struct bench *bench)
{
    static const int times[] = {VERDICT,   MEASURE,   SCAN,     LOAD,
                                TILT,      SEARCH,    GLPK_COLD, CLP_COLD,
                                GLPK_WARM, CLP_WARM};
    static const int counts[] = {POINTS, MARGIN, FIRST,  PIVOTS,
                                 SOLVES, MEMORY, LEAN, ALL_MEMORY};
    static const int edge[] = {CRITICAL, PEER_CRITICAL, CLOSED, PEER_CLOSED};
    static const int plan[] = {TRY,          FRESH,     TRY_SHARE, TRY_WORST,
                               TRY_SEARCHED, TRY_FALLS, PLACES,    RATE};
    table_goals(bench);
    table_ratios(bench, "RATIO: verdict at 0 / cold LP of the best peer",
                 VERDICT, PEER_COLD);
    table_ratios(bench, "RATIO: measure / cold LP of the best peer", MEASURE,
                 PEER_COLD);
    table_ratios(bench, "RATIO: Algorithm 1 (measure) / warm Algorithm 1 of "
                 "the best peer", MEASURE, PEER_WARM);
    table_ratios(bench, "RATIO: Algorithm 1 (scan) / warm Algorithm 1 of the "
                 "best peer", SCAN, PEER_WARM);
    table_ratios(bench, "RATIO: verdict at d* / cold LP there", CRITICAL,
                 PEER_CRITICAL);
    table_ratios(bench, "RATIO: verdict with kerns closed / cold LP there",
                 CLOSED, PEER_CLOSED);
    table_ratios(bench, "RATIO: load factor / measure", LOAD, MEASURE);
    table_ratios(bench, "RATIO: tilt / measure", TILT, MEASURE);
    table_quantities(bench, "TIMES, ms (A1: Algorithm 1, 20 levels, warm)",
                     times, (int)(sizeof times / sizeof times[0]));
    table_quantities(bench, "CRITICAL AND CLOSED, ms", edge,
                     (int)(sizeof edge / sizeof edge[0]));
    table_quantities(bench, "COUNTS (pivots and LPs of the measure; pivots 0: "
                     "of the verdict at 0)", counts,
                     (int)(sizeof counts / sizeof counts[0]));
    table_quantities(bench, "CANDIDATES: one more stone on top, ms and ratios",
                     plan, (int)(sizeof plan / sizeof plan[0]));
    table_growth(bench);
    table_slow(bench);
    printf("\n%d structures, %d checks, %d disagree; a peer had no answer %d "
           "times.\n", bench->samples, bench->checks, bench->differences,
           bench->silent);
}

/* ---- The README's tables ------------------------------------------------- */

static void print_cell(double value, double goal)
{
    char text[32];
    snprintf(text, sizeof text, value < 100 ? "%.2g" : "%.0f", value);
    if (value < 0)
        printf(" |");
    else if (goal > 0)
        printf(" %s (%g) |", text, goal);
    else
        printf(" %s |", text);
}

/* Medians by size; a goal stands behind the number it is about. */
static void summary_sizes(const struct bench *bench)
{
    static const struct figure figure[] = {
        {VERDICT, -1},        {MEASURE, -1},        {PEER_COLD, -1},
        {VERDICT, PEER_COLD}, {MEASURE, PEER_COLD}, {MEASURE, PEER_WARM},
        {WALL_SHARE, -1}};
    const int columns = (int)(sizeof figure / sizeof figure[0]);
    size_t g;
    int i, k;
    printf("\n| blocks | verdict, ms | measure, ms | peer's LP, ms "
           "| verdict / LP | measure / LP | measure / peer's Algorithm 1 "
           "| candidate on a wall / measure |\n|---:|---:|---:|---:|---:|---:|---:|---:|"
           "\n");
    for (i = 0; i < bench->sizes && bench->size[i] <= bench->most; i++) {
        printf("| %d |", bench->size[i]);
        for (k = 0; k < columns; k++) {
            double goal = 0;
            for (g = 0; g < sizeof goals / sizeof goals[0]; g++)
                if (goals[g].figure.over == figure[k].over
                    && goals[g].figure.under == figure[k].under
                    && goals[g].size == bench->size[i])
                    goal = goals[g].most;
            print_cell(size_median(bench, &figure[k], bench->size[i]), goal);
        }
        printf("\n");
    }
}

static void summary_row(const char *text, double value, double goal)
{
    printf("| %s |", text);
    print_cell(value, goal);
    printf("\n");
}

static void print_summary(const struct bench *bench)
{
    static const struct figure load = {LOAD, MEASURE}, tilt = {TILT, MEASURE};
    static const struct figure memory = {LEAN, -1}, rate = {RATE, -1};
    summary_sizes(bench);
    printf("\n| over all | |\n|---|---:|\n");
    summary_row("load factor / measure", size_median(bench, &load, 0), 2);
    summary_row("tilt / measure", size_median(bench, &tilt, 0), 2);
    summary_row("growth of the measure on walls, exponent from 100 blocks on",
                growth_on_walls(bench), GROWTH_GOAL);
    summary_row("work memory (lean), 30 blocks with 70 line contacts, KB",
                memory_of_30(), MEMORY_GOAL);
    summary_row("work memory (lean), 1000 blocks, KB",
                size_median(bench, &memory, 1000), 4096);
    summary_row("candidates a second, 50 blocks",
                size_median(bench, &rate, 50), 0);
    printf("\n");
}

/* ---- The program --------------------------------------------------------- */

static int usage(FILE *out, int status)
{
    fprintf(out,
            "bench [--quick] [--family NAME] [--sizes N,N,...] [--number K]\n"
            "      [--summary] [--print]\n"
            "  --quick     few structures of up to 200 blocks; contact search\n"
            "              of up to 5000\n"
            "  --summary   print the README's tables alone\n"
            "  --family    bond, rag, irr, tower, arch or brick alone\n"
            "  --sizes     of 5 to 5000 blocks, at most 16\n"
            "  --number    only structure K of each family and size\n"
            "  --print     write the structures as text, ask nothing\n");
    return status;
}

static int read_sizes(struct bench *bench, const char *text)
{
    bench->sizes = 0;
    while (*text) {
        char *end;
        const long size = strtol(text, &end, 10);
        if (end == text || size < 5 || size > 5000 || bench->sizes == 16)
            return 0;
        bench->size[bench->sizes++] = (int)size;
        text = *end == ',' ? end + 1 : end;
    }
    return bench->sizes > 0;
}

static int read_family(struct bench *bench, const char *text)
{
    for (bench->family = 0; bench->family < FAMILIES; bench->family++)
        if (strcmp(families[bench->family].name, text) == 0)
            return 1;
    return 0;
}

static int read_options(struct bench *bench, int argc, char **argv)
{
    int i, good = 1;
    for (i = 1; i < argc && good; i++) {
        const char *value = i + 1 < argc ? argv[i + 1] : "";
        if (strcmp(argv[i], "--quick") == 0) {
            bench->quick = 1;
        } else if (strcmp(argv[i], "--summary") == 0) {
            bench->summary = 1;
        } else if (strcmp(argv[i], "--print") == 0) {
            bench->print = 1;
        } else if (strcmp(argv[i], "--sizes") == 0) {
            good = read_sizes(bench, value);
            i++;
        } else if (strcmp(argv[i], "--family") == 0) {
            good = read_family(bench, value);
            i++;
        } else if (strcmp(argv[i], "--number") == 0) {
            bench->number = atoi(value);
            good = *value >= '0' && *value <= '9';
            i++;
        } else {
            good = 0;
        }
    }
    return good;
}

int main(int argc, char **argv)
{
    struct bench bench;
    int i;
    memset(&bench, 0, sizeof bench);
    bench.family = bench.number = -1;
    if (argc == 2 && strcmp(argv[1], "--help") == 0)
        return usage(stdout, 0);
    if (!read_options(&bench, argc, argv))
        return usage(stderr, 2);
    bench.most = bench.sizes > 0 ? 5000 : bench.quick ? 200 : 2000;
    if (bench.sizes == 0)
        read_sizes(&bench, "5,10,20,30,50,100,200,500,1000,2000,5000");
    bench.patience.batch = bench.quick ? 0.3 : 1.7;
    bench.patience.once = bench.quick ? 10 : 200;
    bench.room = 16 * FAMILIES * 16;
    bench.sample = room_for((size_t)bench.room, sizeof(struct sample));
    for (i = 0; i < bench.sizes; i++)
        measure_size(&bench, bench.size[i]);
    if (bench.summary)
        print_summary(&bench);
    else if (!bench.print)
        print_tables(&bench);
    free(bench.sample);
    return bench.differences > 0;
}
