/* cc -O2 -ffp-contract=off -o noise tests/noise.c -lm && ./noise FOLDER [SEEDS]

   How far kern_measured() and kern_certain() can be trusted. FOLDER holds
   labels.csv with structures/NAME.kern, which all stand, and removal.csv with
   removal/NAME.kern and the column `verdict`: stands, falls or unclear (left
   out). Every pose, that of the ground too, gets Gaussian noise of a share of
   the mean size in x, y and, over the mean size, in angle, and every vertex half
   of it. The library is told these errors. SEEDS: 10 without.

   Prints, for each share: of what stands and of what falls the verdicts that
   are right, the calls that were refused, how many verdicts were certain and
   how many of these wrong, and the median error of the margin, in errors of
   place, of what stands. SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "../examples/parts/random.h"
#include "../examples/parts/text.h"

enum { MOST_FILES = 1000, MOST_VERTICES = 20000, MOST_BLOCKS = 500,
       MOST_CONTACTS = 20000 };

struct sample {
    struct text_file file;
    int stands;
    double size, margin;
};

struct score {
    long asked[2], right[2]; /* of what falls, of what stands */
    long refused, certain, wrong, errors;
};

static struct sample sample[MOST_FILES];
static int samples;
static double *error; /* of the margin, one a verdict */

static kern_vec vertex[MOST_VERTICES];
static kern_block block[MOST_BLOCKS];
static kern_contact contact[MOST_CONTACTS], again[MOST_CONTACTS];
static kern_real *real;
static int *integer, reals, integers;

/* ---- noise ---- */

static uint64_t state;

static double uniform(void) /* above 0 and below 1 */
{
    return ((double)(random_bits(&state) >> 12) + 0.5) / 4503599627370496.0;
}

static double gauss(void)
{
    const double r = sqrt(-2 * log(uniform()));
    return r * cos(6.283185307179586 * uniform());
}

/* The blocks of the sample with noise of standard deviation e. */
static int disturb(const struct sample *s, double e)
{
    int i, k, n = 0;
    for (i = 0; i < s->file.blocks; i++) {
        const kern_block *b = &s->file.block[i];
        const double angle = e / s->size * gauss();
        const double x = (double)b->centre.x, y = (double)b->centre.y;
        const double dx = x + e * gauss(), dy = y + e * gauss();
        kern_status status;
        for (k = 0; k < b->vertices; k++) {
            const double u = (double)b->vertex[k].x - x;
            const double v = (double)b->vertex[k].y - y;
            kern_vec *to = &vertex[n + k];
            to->x = (kern_real)(dx + u * cos(angle) - v * sin(angle) +
                                e / 2 * gauss());
            to->y = (kern_real)(dy + u * sin(angle) + v * cos(angle) +
                                e / 2 * gauss());
        }
        status = b->fixed
            ? kern_ground_init(&block[i], vertex + n, b->vertices, NULL)
            : kern_block_init(&block[i], vertex + n, b->vertices,
                              b->mass / (kern_real)fabs((double)b->area), NULL);
        if (status < 0)
            return 0;
        n += b->vertices;
    }
    return 1;
}

/* ---- questions ---- */

/* Finds the contacts and measures; the task is left for kern_certain(). */
static kern_status ask(const struct sample *s, const kern_block *blocks,
                       kern_options options, kern_work *work, kern_task *task,
                       kern_margin *margin)
{
    *work = kern_work_of(real, reals, integer, integers);
    *task = kern_task_of(blocks, s->file.blocks, contact, 0, work);
    task->options = options;
    task->s.gravity = s->file.gravity;
    task->s.contacts = kern_contacts(blocks, s->file.blocks, &options, contact,
                                     MOST_CONTACTS, work);
    if (task->s.contacts < 0)
        return (kern_status)task->s.contacts;
    return kern_measure(task, margin, NULL);
}

static void ask_disturbed(const struct sample *s, double e, struct score *to)
{
    const kern_options options = kern_measured(
        &s->file.options, (kern_real)e, (kern_real)(e / s->size));
    kern_work work;
    kern_task task;
    kern_margin margin;
    kern_status verdict;
    to->asked[s->stands]++;
    if (!disturb(s, e)) {
        to->refused++;
        return;
    }
    verdict = ask(s, block, options, &work, &task, &margin);
    if (verdict < 0) {
        to->refused++;
        return;
    }
    if ((verdict == KERN_STANDS) == s->stands)
        to->right[s->stands]++;
    if (verdict == KERN_STANDS && s->stands)
        error[to->errors++] = fabs((double)margin.margin - s->margin) / e;
    if (kern_certain(&task, verdict, again, MOST_CONTACTS) == 1) {
        to->certain++;
        to->wrong += (verdict == KERN_STANDS) != s->stands;
    }
}

/* ---- files ---- */

static int open_sample(const char *folder, const char *part, const char *name,
                       int stands)
{
    struct sample *s = &sample[samples];
    char path[1000];
    kern_work work;
    kern_task task;
    kern_margin margin;
    snprintf(path, sizeof path, "%s/%s/%s.kern", folder, part, name);
    if (samples == MOST_FILES || text_load(&s->file, path) < 0 ||
        s->file.message[0]) {
        fprintf(stderr, "%s: %s\n", path, s->file.message);
        return 0;
    }
    s->stands = stands;
    s->size = (double)kern_mean_size(s->file.block, s->file.blocks);
    s->margin = ask(s, s->file.block, s->file.options, &work, &task,
                    &margin) == KERN_STANDS ? (double)margin.margin : 0;
    samples++;
    return 1;
}

/* The names in the first column of a table; `verdict` is the third, if any. */
static int open_table(const char *folder, const char *table, const char *part,
                      int labelled)
{
    char line[2000], name[200], verdict[100];
    FILE *in;
    snprintf(line, sizeof line, "%s/%s", folder, table);
    in = fopen(line, "r");
    if (!in) {
        perror(line);
        return 0;
    }
    while (fgets(line, sizeof line, in)) {
        strcpy(verdict, "stands");
        if (sscanf(line, labelled ? "%199[^,],%*[^,],%99[^,\n]" : "%199[^,]",
                   name, verdict) < 1 + labelled ||
            strcmp(name, "name") == 0 || strcmp(verdict, "unclear") == 0)
            continue;
        if (!open_sample(folder, part, name, strcmp(verdict, "stands") == 0)) {
            fclose(in);
            return 0;
        }
    }
    fclose(in);
    return 1;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double percent(long part, long whole)
{ return whole ? 100.0 * (double)part / (double)whole : 0; }

static void row(double share, int seeds)
{
    static const struct score none;
    struct score score = none;
    int i, k;
    for (i = 0; i < samples; i++)
        for (k = 0; k < seeds; k++) {
            state = 88172645463325252u + (uint64_t)k * 7919 +
                    (uint64_t)i * 104729 + (uint64_t)(share * 1e6) * 1299709;
            uniform(), uniform(), uniform();
            ask_disturbed(&sample[i], share * sample[i].size, &score);
        }
    qsort(error, (size_t)score.errors, sizeof *error, ascending);
    printf("%5.1f %% | %7.2f | %7.2f | %7ld | %9.1f | %9.2f | %6.2f\n",
           100 * share, percent(score.right[1], score.asked[1]),
           percent(score.right[0], score.asked[0]), score.refused,
           percent(score.certain, score.asked[0] + score.asked[1]),
           percent(score.wrong, score.certain),
           score.errors ? error[score.errors / 2] : 0);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    static const double share[] = {0.002, 0.005, 0.01, 0.02};
    const int seeds = argc > 2 ? atoi(argv[2]) : 10;
    int i;
    if (argc < 2 || seeds < 1) {
        fprintf(stderr, "usage: noise FOLDER [SEEDS]\n");
        return 2;
    }
    reals = KERN_REALS(MOST_BLOCKS, MOST_CONTACTS);
    integers = KERN_INTS(MOST_BLOCKS, MOST_CONTACTS);
    real = (kern_real *)malloc((size_t)reals * sizeof *real);
    integer = (int *)malloc((size_t)integers * sizeof *integer);
    error = (double *)malloc((size_t)seeds * MOST_FILES * sizeof *error);
    if (!real || !integer || !error ||
        !open_table(argv[1], "labels.csv", "structures", 0) ||
        !open_table(argv[1], "removal.csv", "removal", 1))
        return 1;
    printf("  noise | stands  | falls   | refused | certain   | of these  | "
           "margin\n        | right %% | right %% |         | %%         | "
           "wrong %%   | error\n");
    for (i = 0; i < 4; i++)
        row(share[i], seeds);
    return 0;
}
