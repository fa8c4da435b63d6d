/* cc -O2 -ffp-contract=off -o noise tests/noise.c -lm && ./noise [SEEDS [FOLDER]]

   How far kern_measured_options() and kern_certain() can be trusted. Every
   pose, that of the ground too, gets Gaussian noise in x, y and, over the mean
   size (of the ground: over its own), in angle, and every vertex half of it. The
   library is told these errors. SEEDS: 300 without.

   Near misses, which all fall: a stone between two walls with nothing below, a
   beam whose second column is short, a plank that misses its second support,
   half a block over the edge, a slope steeper than friction, a block on two
   beds of which the wider one is open; each by so many errors of 0.005 sizes.
   The beam and the block come to rest after a small motion. Prints how many per
   cent are said to stand, and to stand for certain, settling by less than they
   move; fails where that is above 1.

   FOLDER: holds labels.csv with structures/NAME.kern, which all stand, and
   removal.csv with removal/NAME.kern and the column `verdict`: stands, falls or
   unclear (left out). Noise is a share of the mean size. Prints, for each share:
   of what stands and of what falls the verdicts that are right, and those that
   are certain; the calls that were refused; of the certain verdicts those that
   are wrong; and of what stands the median error of the margin, in errors of
   place, how many intervals hold the exact margin, how many begin more than 1.5
   times above it (and 2 errors), and their median width in mean sizes. Last, of
   every other structure, since the loss of the lower end was chosen on the rest:
   how many lower ends the exact margin exceeds, and the median of their share of
   it.
   Before that: of what stands, how much falls without one of the supports of a
   block that has several, and how much of that without one that is not the
   widest. With that support half an error short it falls and looks the same, so
   no rule may call it certain.
   SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "../examples/parts/random.h"
#include "../examples/parts/text.h"

enum {
    MOST_FILES = 1000,
    MOST_VERTICES = 20000,
    MOST_BLOCKS = 500,
    MOST_CONTACTS = 20000
};

struct sample {
    struct text_file file;
    int stands, needs; /* one of several supports; 2: not the widest either */
    double size, margin;
};

struct score {
    long asked[2], right[2], certain[2]; /* of what falls, of what stands */
    long refused, wrong, errors, inside, above, lows, held;
};

static struct sample sample[MOST_FILES];
static int samples;
static double *error, *width, *share_low; /* of the margin, one a verdict */

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
        const double own = b->fixed ? sqrt(fabs((double)b->area)) : s->size;
        const double angle = e / own * gauss();
        const double x = (double)b->centre.x, y = (double)b->centre.y;
        const double dx = x + e * gauss(), dy = y + e * gauss();
        kern_status status;
        for (k = 0; k < b->vertices; k++) {
            const double u = (double)b->vertex[k].x - x;
            const double v = (double)b->vertex[k].y - y;
            kern_vec *to = &vertex[n + k];
            to->x = (kern_real)(dx + u * cos(angle) - v * sin(angle)
                                + e / 2 * gauss());
            to->y = (kern_real)(dy + u * sin(angle) + v * cos(angle)
                                + e / 2 * gauss());
        }
        status = b->fixed
                   ? kern_ground_init(&block[i], vertex + n, b->vertices, NULL)
                   : kern_block_init(&block[i], vertex + n, b->vertices,
                                     b->mass / (kern_real)fabs((double)b->area),
                                     NULL);
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

static double percent(long part, long whole)
{
    return whole ? 100.0 * (double)part / (double)whole : 0;
}

/* An answer about what stands, beside the exact margin. */
static void score_margin(const struct sample *s, double e, double margin,
                         const kern_interval *in, struct score *to)
{
    const double low = (double)in->low, high = (double)in->high;
    error[to->errors] = fabs(margin - s->margin) / e;
    width[to->errors++] = (high - low) / s->size;
    to->inside += low <= s->margin && s->margin <= high;
    to->above += low > 1.5 * s->margin && low > s->margin + 2 * e;
    if ((s - sample) % 2) {
        share_low[to->lows++] = low / s->margin;
        to->held += low <= s->margin;
    }
}

/* moves: how far what is not held falls or settles. */
static void ask_disturbed(const struct sample *s, double e, double moves,
                          struct score *to)
{
    const kern_options options = kern_measured_options(
        &s->file.options, (kern_real)e, (kern_real)(e / s->size));
    kern_work work;
    kern_task task;
    kern_margin margin;
    kern_interval in;
    kern_status verdict = KERN_UNDECIDED, sure;
    to->asked[s->stands]++;
    if (disturb(s, e))
        verdict = ask(s, block, options, &work, &task, &margin);
    if (verdict < 0) {
        to->refused++;
        return;
    }
    to->right[s->stands] += (verdict == KERN_STANDS) == s->stands;
    sure = kern_certain(&task, margin.margin, &in, again, MOST_CONTACTS);
    if (sure < 0) {
        to->refused++;
        return;
    }
    to->certain[s->stands] += sure > 0;
    to->wrong += s->stands ? sure == KERN_FALLS
                           : sure == KERN_STANDS && (double)in.settles < moves;
    if (s->stands && s->margin > 0)
        score_margin(s, e, (double)margin.margin, &in, to);
}

/* ---- near misses ---- */

enum { SLOT, BEAM, PLANK, HALF, SLOPE, WIDEST, MISSES, GAPS = 8 };

/* A rectangle, turned about the origin; fixed where the density is 0. */
static void add_box(struct sample *s, double density, const double *low,
                    const double *high, double turn)
{
    static kern_vec corner[4 * 8];
    kern_vec *v = corner + 4 * s->file.blocks;
    kern_block *b = s->file.block + s->file.blocks++;
    int i;
    for (i = 0; i < 4; i++) {
        const double x = i == 0 || i == 3 ? low[0] : high[0];
        const double y = i < 2 ? low[1] : high[1];
        v[i].x = (kern_real)(x * cos(turn) - y * sin(turn));
        v[i].y = (kern_real)(x * sin(turn) + y * cos(turn));
    }
    if (density > 0)
        kern_block_init(b, v, 4, (kern_real)density, NULL);
    else
        kern_ground_init(b, v, 4, NULL);
}

/* What falls for want of a gap. */
static void open_miss(struct sample *s, int kind, double gap)
{
    static kern_block blocks[8];
    /* density, lower left and upper right corner */
    const double box[MISSES][4][5] = {
        {{0, -2, -1, 0, 2},
         {0, 1 + gap, -1, 3, 2},
         {1, gap / 2, 0, 1 + gap / 2, 1},
         {-1}},
        {{0, -2, -1, 6, 0},
         {1, 0, 0, 1, 1},
         {1, 3, 0, 4, 1 - gap},
         {1, 0, 1, 4, 1.25}},
        {{0, -2, -1, 0.3, 0}, {0, 1 + gap, -1, 4, 0}, {1, 0, 0, 1, 1}, {-1}},
        {{0, -2, -1, 0, 0}, {1, -0.5 + gap, 0, 0.5 + gap, 1}, {-1}, {-1}},
        {{0, -4, -1, 4, 0}, {1, -0.5, 0, 0.5, 1}, {-1}, {-1}},
        {{0, 0.1, -1, 1.5, -gap},
         {0, -1, -1, 0.1, 0},
         {1, -0.15, 0, 0.85, 1},
         {-1}}};
    int i;
    memset(s, 0, sizeof *s);
    s->file.block = blocks;
    for (i = 0; i < 4 && box[kind][i][0] >= 0; i++)
        add_box(s, box[kind][i][0], box[kind][i] + 1, box[kind][i] + 3,
                kind == SLOPE ? atan(0.5) + gap : 0);
    s->file.gravity.y = KERN_R(-9.81);
    s->file.options = kern_defaults();
    s->file.options.mu = KERN_R(0.5);
    s->size = (double)kern_mean_size(blocks, s->file.blocks);
}

/* Returns how many rows have more than 1 % certain and wrong. */
static int near_misses(int seeds)
{
    static const char *const name[MISSES] = {"slot", "beam",  "plank",
                                             "half", "slope", "widest"};
    /* in gaps, as simulated: the beam's end sinks by one, its centre less; the
       block turns by one over what its lower bed is wide */
    static const double moves[MISSES] = {1e9, 0.35, 1e9, 1e9, 1e9, 1.35};
    static const double gap[GAPS] = {0.5, 1, 2, 3, 4, 6, 8, 10};
    static const struct score none;
    const double e = 0.005;
    struct sample s;
    int kind, g, k, bad = 0;
    printf("errors short |    0.5 |      1 |      2 |      3 |      4 |      6 "
           "|      8 |     10\n");
    for (kind = 0; kind < MISSES; kind++) {
        printf("%-12s", name[kind]);
        for (g = 0; g < GAPS; g++) {
            struct score score = none;
            for (k = 0; k < seeds; k++) {
                open_miss(&s, kind, gap[g] * e);
                if (kind == SLOPE)
                    open_miss(&s, kind, gap[g] * e / s.size);
                state = 88172645463325252u + (uint64_t)k * 7919
                      + (uint64_t)(kind * GAPS + g) * 104729;
                uniform(), uniform(), uniform();
                ask_disturbed(&s, e, moves[kind] * gap[g] * e, &score);
            }
            printf(" | %3.0f/%.1f", 100 - percent(score.right[0], seeds),
                   percent(score.wrong, seeds));
            bad += score.refused > 0 || 100 * score.wrong > seeds;
        }
        printf("\n");
    }
    return bad;
}

/* ---- what needs a support ---- */

/* The contacts of one pair of blocks. */
struct support {
    int first, end, held; /* held: the block that they carry */
    double width;         /* as gravity sees it */
};

/* The support that begins at contact i; its end, as kern_contacts() orders. */
static int support_of(const kern_task *task, int i, struct support *to)
{
    const kern_vec down = task->s.gravity;
    const kern_contact *c = task->s.contact, *first = c + i;
    double low = 1e300, high = -1e300, push = 0;
    to->first = i;
    for (; i < task->s.contacts && c[i].a == first->a && c[i].b == first->b;
         i++) {
        const double at = (double)(down.x * c[i].p.y - down.y * c[i].p.x);
        low = fmin(low, at);
        high = fmax(high, at);
        push += (double)(c[i].n.x * down.x + c[i].n.y * down.y);
    }
    to->held = push < 0 ? first->b : first->a;
    to->width = high - low;
    return to->end = i;
}

/* 1: falls without one of the supports of a block that has several; 2: without
   one that is not its widest. */
static int needs_support(const kern_task *task)
{
    static struct support all[MOST_CONTACTS];
    kern_work work = kern_work_of(real, reals, integer, integers);
    kern_task less = *task;
    int i, k, n = 0, needs = 0;
    less.s.contact = again;
    less.work = &work;
    for (i = 0; i < task->s.contacts; n++)
        i = support_of(task, i, &all[n]);
    for (i = 0; i < n && needs < 2; i++) {
        int others = 0, wider = 0;
        const int gone = all[i].end - all[i].first;
        for (k = 0; k < n; k++)
            if (k != i && all[k].held == all[i].held) {
                others++;
                wider += all[k].width >= all[i].width;
            }
        less.s.contacts = task->s.contacts - gone;
        for (k = 0; k < less.s.contacts; k++)
            again[k] = task->s.contact[k < all[i].first ? k : k + gone];
        if (others && kern_verdict(&less, 0, NULL) == KERN_FALLS)
            needs = wider ? 2 : 1;
    }
    return needs;
}

static void print_needs(void)
{
    int i, stand = 0, one = 0, other = 0;
    for (i = 0; i < samples; i++) {
        stand += sample[i].margin > 0;
        one += sample[i].needs > 0;
        other += sample[i].needs > 1;
    }
    printf("of %d that stand %d fall without one of several supports, %d "
           "without one that is not the widest\n",
           stand, one, other);
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
    if (samples == MOST_FILES || text_load(&s->file, path) < 0
        || s->file.message[0]) {
        fprintf(stderr, "%s: %s\n", path, s->file.message);
        return 0;
    }
    s->stands = stands;
    s->size = (double)kern_mean_size(s->file.block, s->file.blocks);
    s->margin = ask(s, s->file.block, s->file.options, &work, &task, &margin)
                     == KERN_STANDS
                  ? (double)margin.margin
                  : 0;
    s->needs = stands && s->margin > 0 ? needs_support(&task) : 0;
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
                   name, verdict)
                < 1 + labelled
            || strcmp(name, "name") == 0 || strcmp(verdict, "unclear") == 0)
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

static void row(double share, int seeds)
{
    static const struct score none;
    struct score score = none;
    int i, k;
    for (i = 0; i < samples; i++)
        for (k = 0; k < seeds; k++) {
            state = 88172645463325252u + (uint64_t)k * 7919
                  + (uint64_t)i * 104729 + (uint64_t)(share * 1e6) * 1299709;
            uniform(), uniform(), uniform();
            ask_disturbed(&sample[i], share * sample[i].size, 1e9, &score);
        }
    qsort(error, (size_t)score.errors, sizeof *error, ascending);
    qsort(width, (size_t)score.errors, sizeof *width, ascending);
    qsort(share_low, (size_t)score.lows, sizeof *share_low, ascending);
    printf("%5.1f %% | %6.2f | %6.2f | %7ld | %5.1f | %5.1f | %5.2f | %5.2f | "
           "%6.1f | %5.1f | %5.3f | %5.1f | %5.2f\n",
           100 * share, percent(score.right[1], score.asked[1]),
           percent(score.right[0], score.asked[0]), score.refused,
           percent(score.certain[1], score.asked[1]),
           percent(score.certain[0], score.asked[0]),
           percent(score.wrong, score.certain[0] + score.certain[1]),
           score.errors ? error[score.errors / 2] : 0,
           percent(score.inside, score.errors),
           percent(score.above, score.errors),
           score.errors ? width[score.errors / 2] : 0,
           percent(score.held, score.lows),
           score.lows ? share_low[score.lows / 2] : 0);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    static const double share[] = {0.002, 0.005, 0.01, 0.02};
    const int seeds = argc > 1 ? atoi(argv[1]) : 300;
    int i, bad;
    if (seeds < 1) {
        fprintf(stderr, "usage: noise [SEEDS [FOLDER]]\n");
        return 2;
    }
    reals = KERN_REALS(MOST_BLOCKS, MOST_CONTACTS);
    integers = KERN_INTS(MOST_BLOCKS, MOST_CONTACTS);
    real = (kern_real *)malloc((size_t)reals * sizeof *real);
    integer = (int *)malloc((size_t)integers * sizeof *integer);
    error = (double *)malloc((size_t)seeds * MOST_FILES * sizeof *error);
    width = (double *)malloc((size_t)seeds * MOST_FILES * sizeof *width);
    share_low = (double *)malloc((size_t)seeds * MOST_FILES * sizeof *error);
    if (!real || !integer || !error || !width || !share_low)
        return 1;
    bad = near_misses(seeds);
    if (argc < 3)
        return bad > 0;
    if (!open_table(argv[2], "labels.csv", "structures", 0)
        || !open_table(argv[2], "removal.csv", "removal", 1))
        return 1;
    print_needs();
    printf(
        "  noise | right, %% of   | refused | certain, %% of | of    | "
        "margin's interval               | lower end\n        | stands | "
        "falls  |         | stands | falls | these | error | holds | above | "
        "width | holds | share\n");
    for (i = 0; i < 4; i++)
        row(share[i], seeds);
    return bad > 0;
}
