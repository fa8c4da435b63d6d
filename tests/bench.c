/* bench.c: how long the questions of kern.h take, beside general LP solvers

   Build it in the directory of kern.h:

       cc -O2 -ffp-contract=off -o bench tests/bench.c -lm

   and with one or both of the peers (Debian: libglpk-dev, coinor-libclp-dev;
   where the linker misses C++ symbols of Clp, add -lstdc++):

       cc -O2 -ffp-contract=off -DBENCH_GLPK -DBENCH_CLP -o bench \
           tests/bench.c -lglpk -lClp -lCoinUtils -lm

   Then ./bench prints CSV for 5 to 200 blocks, one line for each number that is
   known of a structure: family, blocks, number, whether it is a wall, the name
   of the number, its value. ./bench --quick takes less time, ./bench --release
   goes on to 500, 1000 and 2000 blocks, ./bench --help lists the options.
   Progress goes to stderr. The exit status is 1 if any two answers disagree;
   times are never judged by it. tests/bench.awk makes tables of the CSV:

       ./bench >times.csv && awk -f tests/bench.awk times.csv

   and those of the README are made anew by

       ./bench --quick | awk -v summary=1 -f tests/bench.awk >summary.md &&
           sed -i -e '/^<!-- bench/,/^<!-- end/{//!d}' \
               -e '/^<!-- bench/r summary.md' README.md

   STRUCTURES are made here from fixed seeds: walls in running bond (bond),
   ragged with gaps (rag), with sloped beds (irr), towers, voussoir arches, and
   perfect brick walls (brick), whose programs are as degenerate as can be. A
   structure is named family/blocks/number; --family, --sizes and --number ask
   for it alone.

   TIMES are CPU time of this one process, in ms, of the fastest of three
   batches, each long enough for the clock; before each the work memory is
   filled with garbage. A verdict, a measure and so on of kern.h include
   everything from the caller's data to the checked proof, except contact
   search, which has its own column. A peer's time is that of its solve alone,
   the model ready in its memory; of its Algorithm 1, of 20 levels, each from
   the last basis, with the torque entries written in between. Both get programs
   that are built here from the equations and not by kern.h:

       A(d) x = -w, x >= 0    three rows a free block, two columns a contact
                              point; lengths in mean block sizes, forces in
                              mean weights; torques about each block's centre

   The FLOOR is what no measure can do without: kern_check_forces() at `holds`
   and, unless it stands with every kern closed, kern_check_motion() at `fails`.
   Each checks the whole input, which stands for opening it, and evaluates the
   columns of the matrix once.

   The STEP of Algorithm 1 is random: the margin is 19 to 20 steps. For one
   structure of eight a step falls into the bracket of the margin, where the
   level takes a question of its own; left to chance that is too rare to see.

   CANDIDATES: a stone is laid on a wall at places along all of its top, a
   quarter of a brick apart (above 50 blocks farther): it stands, falls, hangs
   over an end, or overlaps. A try is kern_plan_try on the wall as it was
   measured, contact search included. `tries/s` is the number of places over the
   time of all, `stay/s` the same of those where the margin of the wall stays as
   it was, `bears/s` that of all when only asked whether the margin is at least
   a share of the wall's, drawn from .5 to 1. Each answer is compared with that
   of kern_measure of all blocks from nothing; `try / measure` is the median of
   the ratios of their times where the stone stands.

   MEDIANS, of bench.awk: a family's number is the median over its structures, a size's
   number the median over the families' numbers; a ratio is taken for each
   structure, against the faster peer on that structure. The worst is that of
   any structure. What kern.h leaves undecided is in no median, but is listed as
   DISAGREE; structures without a margin are listed at the end.

   INSTRUCTIONS: --ask puts a question once to each structure, without clock, in
   the function run_QUESTION. As `Collected` they are counted by

       valgrind --tool=callgrind --callgrind-out-file=/dev/null \
           --toggle-collect=run_measure \
           ./bench --ask measure --family rag --sizes 30 --number 0

   The questions are verdict, measure, level (Algorithm 1, a verdict a step),
   load, tilt, floor, try and bears (once at each place: divide by their
   number), and lp (of every peer that was built in; toggle at glp_simplex or
   Clp_dual for one of them). What --times 0 counts in all can be subtracted.

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

#include "../examples/parts/random.h"

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
#define SAME 1e-9          /* mean block sizes within which margins are one   */
#define BRACKET 2e-6       /* mean block sizes from holds to fails at the most */
/* The LIMITS of kern.h: in larger structures a margin may lie anywhere in its
   bracket, and in still larger ones that may be so many mean sizes wide. */
#define EXACT_MOST 128
#define NARROW_MOST 256
#define BRACKET_WIDE 3e-5
#define LEVELS 20          /* of Algorithm 1                                  */
#define DETAIL_MOST 200    /* largest structures of which all is asked        */
#define CLOSED_MOST 500    /* and whose kerns are closed                      */
#define PLACES_MOST 96     /* candidates of a structure of up to 50 blocks    */
#define PLACES_FEW 24      /* and of a larger one                             */
#define TOUCHES 32         /* contact points of a candidate                   */
#define SIZES_MOST 16

static void give_up(const char *why)
{
    fprintf(stderr, "bench: %s\n", why);
    exit(2);
}

static void *room_for(size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (!p)
        give_up("out of memory");
    return p;
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
    return low + (high - low) * random_share(random_mixed(&scene->random));
}

static kern_vec vec(double x, double y)
{
    kern_vec v;
    v.x = x;
    v.y = y;
    return v;
}

static void scene_block(struct scene *scene, const kern_vec *vertex, int n,
                        double density)
{
    kern_vec *copy = scene->vertex + scene->vertices;
    kern_block *b = &scene->block[scene->blocks++];
    memcpy(copy, vertex, (size_t)n * sizeof *vertex);
    scene->vertices += n;
    if ((density > 0 ? kern_block_init(b, copy, n, density, NULL)
                     : kern_ground_init(b, copy, n, NULL)) != KERN_OK)
        give_up("a bad block");
}

static void scene_box(struct scene *scene, double left, double low,
                      double right, double high, double density)
{
    kern_vec v[4];
    v[0] = vec(left, low);
    v[1] = vec(right, low);
    v[2] = vec(right, high);
    v[3] = vec(left, high);
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
    if (bed->knots > COURSE)
        give_up("a course is too long");
    bed->x[bed->knots] = x;
    bed->y[bed->knots++] = y;
}

static void wall_brick_add(struct scene *scene, const struct bed *under,
                           const struct bed *over, double left, double right,
                           int bends, double density)
{
    kern_vec v[CORNERS];
    int n = 0, i;
    v[n++] = vec(left, bed_at(under, left));
    for (i = 0; bends && i < under->knots && n < CORNERS - 3; i++)
        if (under->x[i] > left && under->x[i] < right)
            v[n++] = vec(under->x[i], under->y[i]);
    v[n++] = vec(right, bed_at(under, right));
    v[n++] = vec(right, bed_at(over, right));
    v[n++] = vec(left, bed_at(over, left));
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
        const double right = length - inset * k
            + loose * scene_random(scene, -0.5, 0.5);
        const double left = inset * k + loose * scene_random(scene, -0.5, 0.5);
        wall_course(scene, wall, k % 2, left, right, LENGTH / 2 * (k + 1),
                    &bed[k % 2], &bed[(k + 1) % 2], n + 1 - scene->blocks);
    }
}

static void make_tower(struct scene *scene, int n, const struct wall *wall)
{
    double low = 0;
    int i;
    (void)wall;
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
    v[0] = vec(inner * sin(from), inner * cos(from));
    v[1] = vec(inner * sin(to), inner * cos(to));
    v[2] = vec(outer * sin(to), outer * cos(to));
    v[3] = vec(outer * sin(from), outer * cos(from));
    scene_block(scene, v, 4, density);
}

static void make_arch(struct scene *scene, int n, const struct wall *wall)
{
    const double inner = LENGTH * n / 4 + LENGTH;
    const double outer = inner * scene_random(scene, 1.2, 1.4);
    const double half = scene_random(scene, 0.9, 1.3);
    int i;
    (void)wall;
    arch_piece(scene, inner, outer, -half - 0.2, -half, 0);
    arch_piece(scene, inner, outer, half, half + 0.2, 0);
    for (i = 0; i < n; i++)
        arch_piece(scene, inner, outer, -half + 2 * half * i / n,
                   -half + 2 * half * (i + 1) / n,
                   DENSITY * scene_random(scene, 0.7, 1.3));
}

static const struct family {
    const char *name;
    void (*make)(struct scene *scene, int n, const struct wall *wall);
    int is_wall;
    struct wall wall;
} families[] = {
    {"bond", make_wall, 1,
     {{0.25, 0.75}, 0.15, {0.02, 0.02}, 0, 0.3, 0, 0}},
    {"rag", make_wall, 1,
     {{0.4, 0.9}, 0.4, {0.03, 0.2}, 0.12, 0.12, 0, 0.2}},
    {"irr", make_wall, 1,
     {{0.4, 0.7}, 0.3, {0.02, 0.02}, 0.1, 0.1, 0.12, 0.2}},
    {"tower", make_tower, 0, {{0, 0}, 0, {0, 0}, 0, 0, 0, 0}},
    {"arch", make_arch, 0, {{0, 0}, 0, {0, 0}, 0, 0, 0, 0}},
    {"brick", make_wall, 1, {{0.5, 0.5}, 0, {0, 0}, 0, 0, 0, 0}},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

static void scene_open(struct scene *scene, int family, int n, int number)
{
    kern_work work;
    memset(scene, 0, sizeof *scene);
    scene->random = (uint64_t)(1000003 * family + 101 * n + number);
    scene->vertex = room_for((size_t)(n + 2) * CORNERS, sizeof(kern_vec));
    scene->block = room_for((size_t)n + 2, sizeof(kern_block));
    scene->room = 32 * (n + 2);
    scene->contact = room_for((size_t)scene->room, sizeof(kern_contact));
    scene->options = kern_defaults();
    scene->options.mu = MU;
    families[family].make(scene, n, &families[family].wall);
    work = kern_work_of(NULL, 0,
                        room_for(2 * (size_t)scene->blocks, sizeof(int)),
                        2 * scene->blocks);
    scene->contacts = kern_contacts(scene->block, scene->blocks,
                                    &scene->options, scene->contact,
                                    scene->room, &work);
    free(work.index);
    if (scene->contacts < 0)
        give_up(kern_status_text((kern_status)scene->contacts));
    scene->s.block = scene->block;
    scene->s.blocks = scene->blocks;
    scene->s.contact = scene->contact;
    scene->s.contacts = scene->contacts;
    scene->s.gravity = vec(0, -9.81);
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
    const double value[3] = {
        sign * f.x, sign * f.y,
        sign * ((p.x - c.x) * f.y - (p.y - c.y) * f.x) / lp->length};
    int i;
    if (lp->first[block] < 0)
        return at;
    for (i = 0; i < 3; i++) {
        lp->value[at + i] = fabs(value[i]) < 1e-15 ? 1e-15 : value[i];
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
        const kern_vec p = vec(c->p.x - way * c->n.y, c->p.y + way * c->n.x);
        for (side = -1; side <= 1; side += 2) {
            const kern_vec f = vec(c->n.x - side * c->mu * c->n.y,
                                   c->n.y + side * c->mu * c->n.x);
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

/* ---- Records ------------------------------------------------------------- */

/* Everything that is known of a structure. A new number needs a line here, a
   note() where it is found, and a place in a table of bench.awk. Ratios name
   what is divided by what. */
#define COLUMNS_OF(X)                                                         \
    X(NONE, "", 0, 0)                                                         \
    X(VERDICT, "verdict ms", 0, 0)     /* kern_verdict at 0                */\
    X(MEASURE, "measure ms", 0, 0)     /* kern_measure with both proofs    */\
    X(LEVEL, "scan ms", 0, 0)          /* kern_verdict at each level       */\
    X(CLOSED, "kerns closed ms", 0, 0) /* kern_verdict, kerns closed       */\
    X(LOAD, "load ms", 0, 0)           /* kern_load_factor to the right    */\
    X(TILT, "tilt ms", 0, 0)           /* kern_tilt to the right           */\
    X(FLOOR, "floor ms", 0, 0)                                               \
    X(SEARCH, "search ms", 0, 0)       /* kern_contacts                    */\
    X(GLPK, "GLPK ms", 0, 0)                                                 \
    X(CLP, "Clp ms", 0, 0)                                                   \
    X(GLPK_WARM, "GLPK's Alg. 1 ms", 0, 0)                                   \
    X(CLP_WARM, "Clp's Alg. 1 ms", 0, 0)                                     \
    X(LP, "peer's LP ms", 0, 0)        /* of the faster peer               */\
    X(WARM, "peer's Alg. 1 ms", 0, 0)                                        \
    X(LP_CLOSED, "LP closed ms", 0, 0)                                       \
    X(POINTS, "points", 0, 0)           /* contact points                   */\
    X(FALLEN, "fallen", 0, 0)                 /* it has no margin                 */\
    X(MARGIN, "d*/d_max", 0, 0)                                               \
    X(FIRST, "pivots at 0", 0, 0)       /* of the verdict                   */\
    X(PIVOTS, "pivots", 0, 0)           /* of the measure                   */\
    X(SOLVES, "LPs", 0, 0)                                                    \
    X(VERDICT_LP, "verdict / LP", VERDICT, LP)                                \
    X(MEASURE_LP, "measure / LP", MEASURE, LP)                                \
    X(CLOSED_LP, "kerns closed / LP", CLOSED, LP_CLOSED)                      \
    X(MEASURE_WARM, "Alg. 1 / peer's", MEASURE, WARM)                         \
    X(LEVEL_WARM, "scan / peer's", LEVEL, WARM)                               \
    X(MEASURE_FLOOR, "measure / floor", MEASURE, FLOOR)                       \
    X(LOAD_MEASURE, "load / measure", LOAD, MEASURE)                          \
    X(TILT_MEASURE, "tilt / measure", TILT, MEASURE)                          \
    X(TRY_MEASURE, "try / measure", 0, 0)                                     \
    X(PLACES, "places", 0, 0)                                                 \
    X(STAND, "stand", 0, 0)                                                   \
    X(STAY, "margin stays", 0, 0)                                             \
    X(RATE, "tries/s", 0, 0)                                                  \
    X(RATE_STAY, "stay/s", 0, 0)                                              \
    X(RATE_BEARS, "bears/s", 0, 0)

#define COLUMN_NAME(name, text, over, under) name,
#define COLUMN_LINE(name, text, over, under) {text, over, under},
enum { COLUMNS_OF(COLUMN_NAME) COLUMNS };
static const struct column {
    const char *text;
    int over, under;       /* of a ratio; else NONE                           */
} columns[] = {COLUMNS_OF(COLUMN_LINE)};

/* The name of a structure. */
struct record {
    int family, blocks, number;
};

struct bench {
    int size[SIZES_MOST], sizes;
    int family, number;    /* -1: all                                         */
    int quick, print, release;
    const struct question *question; /* NULL: all are asked, and timed        */
    int times;             /* that it is asked                                */
    double batch;          /* shortest time on the clock [ms]                 */
    double once;           /* longer than this is run but once [ms]           */
    double value[COLUMNS]; /* of the structure at hand; NAN: not found        */
    struct record now;     /* its name                                        */
    int structures, checks, differences, silent;
    int inside;            /* margins of candidates that differ in a bracket  */
};

static int compare_numbers(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *number, int n)
{
    if (n == 0)
        return NAN;
    qsort(number, (size_t)n, sizeof *number, compare_numbers);
    return (number[(n - 1) / 2] + number[n / 2]) / 2;
}

/* Prints what was found of a structure, and the ratios. */
static void record_all(struct bench *bench)
{
    const struct record *now = &bench->now;
    int i;
    for (i = 0; i < COLUMNS; i++) {
        const struct column *c = &columns[i];
        const double v = c->over
            ? bench->value[c->over] / bench->value[c->under] : bench->value[i];
        if (!isnan(v))
            printf("%s,%d,%d,%d,%s,%.9g\n", families[now->family].name,
                   now->blocks, now->number, families[now->family].is_wall,
                   c->text, v);
    }
    bench->structures++;
}

/* ---- Questions ----------------------------------------------------------- */

/* What is asked about a structure, and the answers. */
struct ask {
    struct bench *bench;
    struct scene *scene;
    kern_work work;
    kern_task task;
    kern_proof proof;
    double same;           /* shrinkages as good as the same to a peer [m]    */
    double shrink;
    kern_status status;
    kern_margin margin;
    double number;         /* level, load factor, angle, errors or count      */

    kern_plan plan;        /* of a wall that was measured                     */
    kern_plan whole;       /* the same, to which a stone is added             */
    double from, step;     /* where the stone's middle lies                   */
    int places;
    double least;          /* margin that is asked for                        */
    kern_vec corner[4];
    kern_block stone;
    kern_margin with;      /* the stone                                       */

    struct program lp;
    const struct peer *peer;
    void *model;           /* NULL: none is open                              */
    int answer;
};

typedef void ask_function(struct ask *ask);

static double clock_ms(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return 1e3 * (double)t.tv_sec + 1e-6 * (double)t.tv_nsec;
}

/* Numbers of 1e306 and indices far out: what is read before it is written
   shows. */
static void garble(const kern_work *work)
{
    memset(work->real, 0x7f, (size_t)work->reals * sizeof *work->real);
    memset(work->index, 0x7f, (size_t)work->indices * sizeof *work->index);
}

/* What comes before each run, where it is given, is not counted. */
static double time_batch(struct ask *ask, ask_function *run,
                         ask_function *before, int runs)
{
    double from, sum = 0;
    int i;
    garble(&ask->work);
    from = clock_ms();
    for (i = 0; i < runs; i++) {
        if (before) {
            before(ask);
            from = clock_ms();
        }
        run(ask);
        if (before)
            sum += clock_ms() - from;
    }
    return (before ? sum : clock_ms() - from) / runs;
}

/* The least of three batches: what other programs on the machine add to CPU
   time, by way of its caches, is never negative. */
static double time_of(struct ask *ask, ask_function *run, ask_function *before)
{
    const struct bench *bench = ask->bench;
    double best = time_batch(ask, run, before, 1);
    const int runs = best < bench->batch
        ? (int)(bench->batch / fmax(best, 1e-4)) + 1 : 1;
    int i;
    if (best > bench->once || (before && bench->now.blocks > DETAIL_MOST))
        return best;
    for (i = 0; i < 3; i++)
        best = fmin(best, time_batch(ask, run, before, runs));
    return best;
}

static void note(struct ask *ask, int column, double value)
{
    ask->bench->value[column] = value;
}

static void check(struct ask *ask, int agree, const char *what, double ours,
                  double theirs)
{
    struct bench *bench = ask->bench;
    bench->checks++;
    if (agree)
        return;
    bench->differences++;
    fprintf(stderr, "DISAGREE %s/%d/%d: %s: %.12g, %.12g\n",
            families[bench->now.family].name, bench->now.blocks,
            bench->now.number, what, ours, theirs);
}

static int is_same(const struct ask *ask, double a, double b)
{
    return fabs(a - b) <= SAME / NEAR * ask->same;
}

/* Whether two margins of one structure agree: above EXACT_MOST blocks kern.h
   promises a place in the bracket alone. */
static int margins_agree(const struct ask *ask, const kern_margin *a,
                         const kern_margin *b)
{
    return is_same(ask, a->margin, b->margin)
           || (ask->bench->now.blocks > EXACT_MOST && a->holds <= b->fails
               && b->holds <= a->fails);
}

/* Whether somebody else's level is as good as that of the measure: where a step
   lies in the bracket of the margin, or within `near` of it, either answer may
   be given there, or none. */
static int level_fits(const kern_margin *m, double same, int level)
{
    const double slack = same + SAME * m->epsilon;
    int least, most;
    if (level == m->level)
        return 1;
    if (m->saturated && same <= 0)
        return 0;
    least = (int)floor(fmax(m->holds - slack, 0) / m->epsilon) + 1;
    most = m->saturated ? m->level
                        : (int)floor((m->fails + slack) / m->epsilon) + 1;
    return least < most && (level < 0 || (level >= least && level <= most));
}

/* Algorithm 1, with anybody's verdicts (1, 0, -1: none): -1 for no answer. */
static int algorithm_1(struct ask *ask,
                       int (*stands)(struct ask *ask, double shrink))
{
    const kern_margin *m = &ask->margin;
    const int last = (int)ceil(m->most / m->epsilon);
    int k;
    for (k = 0; k <= last; k++) {
        const int verdict = stands(ask, fmin(k * m->epsilon, m->most));
        if (verdict != 1)
            return verdict < 0 ? -1 : k;
    }
    return last + 1;
}

/* ---- Peers --------------------------------------------------------------- */

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

/* A solver: a model made of a program, with the basis of slacks; its solve by
   the dual simplex from the basis at hand, 1 feasible, 0 infeasible, -1 no
   answer; and new entries in the same places. */
static const struct peer {
    const char *name;
    int cold, warm;        /* columns where its times go                      */
    int most;              /* largest structures that it is asked about       */
    void *(*open)(const struct program *lp);
    void (*change)(void *model, const struct program *lp);
    int (*solve)(void *model);
    void (*close)(void *model);
} peers[] = {
#ifdef BENCH_GLPK
    {"GLPK", GLPK, GLPK_WARM, 200, glpk_open, glpk_change, glpk_solve,
     glpk_close},
#endif
#ifdef BENCH_CLP
    {"Clp", CLP, CLP_WARM, 2000, clp_open, clp_change, clp_solve, clp_close},
#endif
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL},
};

/* ---- Ours ---------------------------------------------------------------- */

/* The scene as it is now, and nothing known of it. */
static kern_task *task_of(struct ask *ask)
{
    const struct scene *scene = ask->scene;
    ask->task = kern_task_of(scene->block, scene->blocks, scene->contact,
                             scene->contacts, &ask->work);
    ask->task.options = scene->options;
    return &ask->task;
}

static void run_verdict(struct ask *ask)
{
    ask->status = kern_verdict(task_of(ask), ask->shrink, NULL);
}

static void run_measure(struct ask *ask)
{
    ask->status = kern_measure(task_of(ask), &ask->margin, &ask->proof);
}

static int ask_stands(struct ask *ask, double shrink)
{
    ask->shrink = shrink;
    run_verdict(ask);
    return ask->status == KERN_STANDS ? 1 : ask->status == KERN_FALLS ? 0 : -1;
}

static void run_level(struct ask *ask)
{
    ask->number = algorithm_1(ask, ask_stands);
}

static void run_load(struct ask *ask)
{
    ask->status = kern_load_factor(task_of(ask), 0, KERN_RIGHT, &ask->number,
                                   NULL);
}

static void run_tilt(struct ask *ask)
{
    ask->status = kern_tilt(task_of(ask), 0, KERN_RIGHT, &ask->number, NULL);
}

/* The proofs of the last measure. */
static void run_floor(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    ask->number = kern_check_forces(task_of(ask), m->holds, ask->proof.force);
    if (!m->saturated)
        ask->number = fmax(ask->number,
                           kern_check_motion(task_of(ask), m->fails,
                                             ask->proof.motion));
}

/* It finds what is there already. */
static void run_search(struct ask *ask)
{
    const struct scene *scene = ask->scene;
    ask->number = kern_contacts(scene->block, scene->blocks, &scene->options,
                                scene->contact, scene->room, &ask->work);
}

/* A measure with the default step, and the step that the structure gets. Not
   by run_measure, whose instructions may be counted. */
static kern_status settle(struct ask *ask)
{
    struct scene *scene = ask->scene;
    const kern_margin *m = &ask->margin;
    const double where = scene_random(scene, 0, 1);
    const int inside = scene_random(scene, 0, 8) < 1;
    ask->status = kern_measure(task_of(ask), &ask->margin, &ask->proof);
    if (ask->status != KERN_STANDS || m->margin < 1e-4 * m->most)
        return ask->status; /* of a smaller step there may be too many */
    scene->options.epsilon = inside && !m->saturated
        ? (m->holds + where * (m->fails - m->holds)) / (LEVELS - 1)
        : m->margin / (LEVELS - where);
    ask->margin.epsilon = scene->options.epsilon;
    return ask->status;
}

static kern_status measure_verdict(struct ask *ask)
{
    kern_status first;
    ask->shrink = 0;
    run_verdict(ask);
    first = ask->status;
    note(ask, FIRST, ask->work.pivots);
    check(ask, first >= 0, "verdict at 0, status", first, 0);
    if (first < 0)
        return first;
    note(ask, VERDICT, time_of(ask, run_verdict, NULL));
    ask->work.pivots = ask->work.solves = 0;
    settle(ask);
    note(ask, PIVOTS, ask->work.pivots);
    note(ask, SOLVES, ask->work.solves);
    check(ask, first == ask->status, "verdict at 0, of the measure", first,
          ask->status);
    return ask->status;
}

/* The measure, its proofs, and how near to each other they are. */
static void measure_margin(struct ask *ask)
{
    const kern_margin *m = &ask->margin, before = *m;
    const int blocks = ask->bench->now.blocks;
    const double width = blocks > NARROW_MOST ? BRACKET_WIDE : BRACKET;
    note(ask, MEASURE, time_of(ask, run_measure, NULL));
    check(ask, ask->status == KERN_STANDS && margins_agree(ask, m, &before),
          "margin with another step", before.margin, m->margin);
    note(ask, MARGIN, m->margin / m->most);
    note(ask, FLOOR, time_of(ask, run_floor, NULL));
    check(ask, ask->number <= 1, "error of a proof", ask->number, 1);
    check(ask, m->saturated || m->fails - m->holds <= width / NEAR * ask->same,
          "bracket of the margin", m->holds, m->fails);
}

/* Fresh verdicts on both sides of the margin, and the literal scan. */
static void measure_levels(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    check(ask, ask_stands(ask, fmax(m->margin - ask->same, 0)) == 1,
          "status below the margin", ask->status, m->margin);
    if (!m->saturated && m->margin + ask->same < m->most)
        check(ask, ask_stands(ask, m->margin + ask->same) == 0,
              "status above the margin", ask->status, m->margin);
    note(ask, LEVEL, time_of(ask, run_level, NULL));
    check(ask, level_fits(m, 0, (int)ask->number), "scan, level", m->level,
          ask->number);
}

static void measure_closed(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    ask->shrink = m->most;
    note(ask, CLOSED, time_of(ask, run_verdict, NULL));
    check(ask, m->saturated || ask->status == KERN_FALLS
          || m->most - m->margin < NEAR * m->most,
          "falls with its kerns closed", ask->status, m->margin);
}

/* Without loads the tilt is the angle of the load factor. */
static void measure_sideways(struct ask *ask)
{
    double factor;
    note(ask, LOAD, time_of(ask, run_load, NULL));
    factor = ask->number;
    check(ask, ask->status == KERN_STANDS, "load factor", ask->status, factor);
    note(ask, TILT, time_of(ask, run_tilt, NULL));
    check(ask, ask->status == KERN_STANDS, "tilt", ask->status, ask->number);
    if (ask->number < 1.5 && factor < 10)
        check(ask, fabs(tan(ask->number) - factor)
              <= 1e-5 * (1 + factor * factor), "tan(tilt), load factor",
              tan(ask->number), factor);
}

/* ---- Candidates ---------------------------------------------------------- */

static kern_plan plan_open(struct ask *ask)
{
    const int blocks = ask->scene->blocks + 1;
    const int contacts = ask->scene->contacts + TOUCHES;
    kern_plan plan = kern_plan_of(
        room_for((size_t)blocks, sizeof(kern_block)), blocks,
        room_for((size_t)contacts, sizeof(kern_contact)), contacts,
        kern_known_of(room_for((size_t)blocks, sizeof(kern_motion)),
                      room_for((size_t)contacts, sizeof(kern_force))),
        &ask->work);
    int i;
    plan.task.options = ask->scene->options;
    for (i = 0; i + 1 < blocks; i++)
        kern_plan_add(&plan, &ask->scene->block[i]);
    return plan;
}

/* A plan of the wall, and places from one end of its top to the other, where
   the stone's middle is within its own half length of the wall. The upper face
   of a brick is its last edge but one. */
static int site_open(struct ask *ask)
{
    struct scene *scene = ask->scene;
    const int most = ask->bench->now.blocks <= 50 ? PLACES_MOST : PLACES_FEW;
    double low = INFINITY, high = -INFINITY;
    int i;
    for (i = 0; i < scene->blocks; i++)
        if (!scene->block[i].fixed) {
            const kern_block *b = &scene->block[i];
            low = fmin(low, b->vertex[b->vertices - 1].x - 0.4 * LENGTH);
            high = fmax(high, b->vertex[b->vertices - 2].x + 0.4 * LENGTH);
        }
    ask->step = fmax(LENGTH / 4, (high - low) / most);
    ask->from = low + ask->step * scene_random(scene, 0, 1);
    ask->places = (int)ceil((high - ask->from) / ask->step);
    ask->least = ask->margin.margin * scene_random(scene, 0.5, 1);
    ask->plan = plan_open(ask);
    ask->whole = plan_open(ask);
    kern_measure(&ask->plan.task, &ask->with, NULL);
    check(ask, margins_agree(ask, &ask->with, &ask->margin),
          "margin of the plan", ask->with.margin, ask->margin.margin);
    return ask->places;
}

/* Lays the stone, a brick, from above on the face that is highest under it;
   where several are, on the nearest. */
static void site_lay(struct ask *ask, int place)
{
    const double x = ask->from + place * ask->step, half = 0.4 * LENGTH;
    double best_y = -INFINITY, best_away = INFINITY;
    kern_vec *v = ask->corner, u = vec(1, 0), middle = vec(x, 0);
    int i;
    for (i = 0; i < ask->scene->blocks; i++) {
        const kern_block *b = &ask->scene->block[i];
        const kern_vec left = b->vertex[b->vertices - 1];
        const kern_vec right = b->vertex[b->vertices - 2];
        const double from = fmax(left.x, x - half);
        const double to = fmin(right.x, x + half);
        const double slope = (right.y - left.y) / (right.x - left.x);
        const double y = left.y
            + fmax(slope * (from - left.x), slope * (to - left.x));
        const double away = fmax(fmax(left.x - x, x - right.x), 0);
        if (b->fixed || from >= to || y < best_y - SAME
            || (y < best_y + SAME && away >= best_away))
            continue;
        best_y = y;
        best_away = away;
        middle.y = left.y + slope * (x - left.x);
        u = vec(1 / hypot(1, slope), slope / hypot(1, slope));
    }
    v[0] = vec(x - half * u.x, middle.y - half * u.y);
    v[1] = vec(x + half * u.x, middle.y + half * u.y);
    v[2] = vec(v[1].x - 0.5 * LENGTH * u.y, v[1].y + 0.5 * LENGTH * u.x);
    v[3] = vec(v[0].x - 0.5 * LENGTH * u.y, v[0].y + 0.5 * LENGTH * u.x);
    kern_block_init(&ask->stone, v, 4, DENSITY, NULL);
}

static void run_try(struct ask *ask)
{
    ask->status = kern_plan_try(&ask->plan, &ask->stone, &ask->with, NULL);
}

static void run_bears(struct ask *ask)
{
    ask->status = kern_plan_bears(&ask->plan, &ask->stone, ask->least, NULL);
}

/* kern_measure() without what is known of the plan. */
static void run_fresh(struct ask *ask)
{
    kern_task task = ask->whole.task;
    task.known = kern_known_of(NULL, NULL);
    ask->status = kern_measure(&task, &ask->with, NULL);
}

/* Sums over the candidates of a structure. */
struct tally {
    int stand, stay;
    double all_time, stay_time, bears_time;
    double share[PLACES_MOST];
};

/* Whether the margin is as large as asked for, against the fresh measure; in
   its bracket either may be said. */
static void check_bears(struct ask *ask, kern_status bears)
{
    const kern_margin *m = &ask->with;
    const int stands = ask->status == KERN_STANDS;
    const kern_status due = stands && m->margin >= ask->least ? KERN_STANDS
                                                              : KERN_FALLS;
    check(ask, bears == due
          || (stands && ask->least >= m->holds
              && (m->saturated || ask->least <= m->fails)
              && (bears >= 0 || bears == KERN_UNDECIDED)),
          "candidate, bears", bears, due);
}

/* One candidate; the answers must be those of a fresh structure. */
static void measure_place(struct ask *ask, struct tally *tally)
{
    int same;
    const double tried = time_of(ask, run_try, NULL);
    const kern_status status = ask->status;
    const kern_margin m = ask->with;
    double fresh;
    kern_status bears = status;
    tally->all_time += tried;
    tally->bears_time += time_of(ask, run_bears, NULL);
    bears = ask->status;
    if (status < 0) {
        check(ask, status == KERN_OVERLAP && bears == status,
              "candidate, status", status, bears);
        return;
    }
    kern_plan_add(&ask->whole, &ask->stone);
    fresh = time_of(ask, run_fresh, NULL);
    kern_plan_remove(&ask->whole, ask->whole.task.s.blocks - 1);
    check(ask, ask->status == status, "candidate, verdict", status,
          ask->status);
    if (tally->bears_time > 0)
        check_bears(ask, bears);
    if (status != KERN_STANDS || ask->status != status)
        return;
    /* where both proofs hold over some way, each may end at another place */
    same = is_same(ask, m.margin, ask->with.margin);
    ask->bench->inside += !same;
    check(ask, same || (m.holds <= ask->with.fails
                        && ask->with.holds <= m.fails),
          "candidate, margin", m.margin, ask->with.margin);
    check(ask, level_fits(&ask->with, 0, m.level), "candidate, level",
          m.level, ask->with.level);
    tally->share[tally->stand++] = tried / fresh;
    if (is_same(ask, m.margin, ask->margin.margin)) {
        tally->stay++;
        tally->stay_time += tried;
    }
}

static void measure_places(struct ask *ask)
{
    struct tally tally;
    int i;
    memset(&tally, 0, sizeof tally);
    site_open(ask);
    for (i = 0; i < ask->places; i++) {
        site_lay(ask, i);
        measure_place(ask, &tally);
    }
    note(ask, PLACES, ask->places);
    note(ask, STAND, tally.stand);
    note(ask, STAY, tally.stay);
    note(ask, TRY_MEASURE, median(tally.share, tally.stand));
    note(ask, RATE, 1000 * ask->places / tally.all_time);
    if (tally.stay > 0)
        note(ask, RATE_STAY, 1000 * tally.stay / tally.stay_time);
    if (tally.bears_time > 0)
        note(ask, RATE_BEARS, 1000 * ask->places / tally.bears_time);
}

/* ---- Theirs -------------------------------------------------------------- */

static void close_lp(struct ask *ask)
{
    if (ask->model)
        ask->peer->close(ask->model);
    ask->model = NULL;
}

static void open_lp(struct ask *ask)
{
    close_lp(ask);
    program_shrink(&ask->lp, ask->shrink);
    ask->model = ask->peer->open(&ask->lp);
}

static void run_lp(struct ask *ask)
{
    ask->answer = ask->peer->solve(ask->model);
}

static int lp_stands(struct ask *ask, double shrink)
{
    if (shrink > ask->lp.shrink || shrink < ask->lp.shrink) {
        program_shrink(&ask->lp, shrink);
        ask->peer->change(ask->model, &ask->lp);
    }
    return ask->peer->solve(ask->model);
}

static void run_lp_levels(struct ask *ask)
{
    ask->answer = algorithm_1(ask, lp_stands);
}

static double lp_time(struct ask *ask, double shrink, ask_function *run)
{
    double time;
    ask->shrink = shrink;
    time = time_of(ask, run, open_lp);
    ask->bench->silent += ask->answer < 0;
    close_lp(ask);
    return time;
}

/* Differences count unless the shrinkage is as good as critical. */
static void measure_peer(struct ask *ask)
{
    const struct peer *peer = ask->peer;
    const double *value = ask->bench->value;
    const kern_margin *m = &ask->margin;
    const int blocks = ask->bench->now.blocks;
    const int stands = ask->status == KERN_STANDS;
    const double cold = lp_time(ask, 0, run_lp);
    note(ask, peer->cold, cold);
    note(ask, LP, fmin(value[LP], cold)); /* of NAN and a number the number */
    check(ask, ask->answer < 0 || ask->answer == stands
          || (stands && m->margin < ask->same), "verdict at 0, of a peer",
          ask->status, ask->answer);
    if (!stands || !(m->margin > 0) || blocks > CLOSED_MOST)
        return;
    note(ask, LP_CLOSED, fmin(value[LP_CLOSED],
                              lp_time(ask, m->most, run_lp)));
    check(ask, ask->answer < 1 || m->saturated
          || m->most - m->margin < ask->same, "peer stands with kerns closed",
          m->margin, m->most);
    if (blocks > DETAIL_MOST)
        return;
    note(ask, peer->warm, lp_time(ask, 0, run_lp_levels));
    note(ask, WARM, fmin(value[WARM], value[peer->warm]));
    check(ask, ask->answer < 0 || level_fits(m, ask->same, ask->answer),
          peer->name, m->level, ask->answer);
}

/* ---- One structure ------------------------------------------------------- */

static void ask_open(struct ask *ask, struct bench *bench, struct scene *scene)
{
    int reals, ints;
    memset(ask, 0, sizeof *ask);
    ask->bench = bench;
    ask->scene = scene;
    ask->same = NEAR * kern_mean_size(scene->block, scene->blocks);
    kern_work_need(scene->blocks + 1, scene->contacts + TOUCHES, &reals, &ints);
    ask->work = kern_work_of(room_for((size_t)reals, sizeof(kern_real)), reals,
                             room_for((size_t)ints, sizeof(int)), ints);
    garble(&ask->work);
    ask->proof.force = room_for((size_t)scene->contacts, sizeof(kern_force));
    ask->proof.motion = room_for((size_t)scene->blocks, sizeof(kern_motion));
    program_open(&ask->lp, scene);
}

static void ask_close(struct ask *ask)
{
    void *const room[] = {
        ask->work.real, ask->work.index, ask->proof.force, ask->proof.motion,
        ask->plan.block, ask->plan.contact, ask->plan.task.known.motion,
        ask->whole.block, ask->whole.contact, ask->whole.task.known.motion,
        ask->lp.first, ask->lp.start, ask->lp.row, ask->lp.value, ask->lp.rhs};
    size_t i;
    for (i = 0; i < sizeof room / sizeof room[0]; i++)
        free(room[i]);
}

static void measure_structure(struct ask *ask)
{
    struct bench *bench = ask->bench;
    const int blocks = bench->now.blocks;
    kern_status status;
    int i;
    for (i = 0; i < COLUMNS; i++)
        bench->value[i] = NAN;
    note(ask, POINTS, ask->scene->contacts);
    note(ask, SEARCH, time_of(ask, run_search, NULL));
    status = measure_verdict(ask);
    if (status == KERN_STANDS && ask->margin.margin > 0) {
        measure_margin(ask);
        if (blocks <= DETAIL_MOST) {
            measure_levels(ask);
            measure_sideways(ask);
        }
        if (blocks <= CLOSED_MOST)
            measure_closed(ask);
        if (blocks <= DETAIL_MOST && families[bench->now.family].is_wall)
            measure_places(ask);
    } else {
        note(ask, FALLEN, 1);
    }
    ask->status = status;
    for (ask->peer = peers; ask->peer->name; ask->peer++)
        if (blocks <= ask->peer->most)
            measure_peer(ask);
    record_all(bench);
}

/* What --ask puts without clock: to the structure, to the stone at each place
   of a wall, or to each peer; the step and margin may be needed before. */
enum { OF_WALL = 1, OF_PEERS = 2, SETTLED = 4 };

static const struct question {
    const char *name;
    ask_function *run;
    int how;
} questions[] = {
    {"verdict", run_verdict, 0},       {"measure", run_measure, SETTLED},
    {"level", run_level, SETTLED},     {"load", run_load, 0},
    {"tilt", run_tilt, 0},             {"floor", run_floor, SETTLED},
    {"lp", run_lp, OF_PEERS},          {"try", run_try, OF_WALL | SETTLED},
    {"bears", run_bears, OF_WALL | SETTLED},
    {NULL, NULL, 0},
};

static void ask_once(struct ask *ask)
{
    const struct bench *bench = ask->bench;
    const struct question *q = bench->question;
    const int on_wall = (q->how & OF_WALL) != 0;
    int count = 0, due = 1, i, k;
    if (q->how & OF_PEERS)
        due = (int)(sizeof peers / sizeof peers[0]) - 1;
    if ((q->how & SETTLED) && settle(ask) != KERN_STANDS)
        due = 0;
    if (due && on_wall)
        due = families[bench->now.family].is_wall ? site_open(ask) : 0;
    for (i = 0; i < due; i++)
        for (k = 0; k < bench->times; k++, count++) {
            if (on_wall)
                site_lay(ask, i);
            if (q->how & OF_PEERS) {
                ask->peer = &peers[i];
                open_lp(ask);
            }
            q->run(ask);
            close_lp(ask);
        }
    printf("%s/%d/%d: %s asked %d times\n", families[bench->now.family].name,
           bench->now.blocks, bench->now.number, q->name, count);
}

static void measure_size(struct bench *bench, int size)
{
    const int from = bench->number < 0 ? 0 : bench->number;
    const int to = bench->number >= 0 ? from + 1
                 : size > DETAIL_MOST ? 3 : bench->quick ? 5 : 9;
    struct record *now = &bench->now;
    struct scene scene;
    struct ask ask;
    now->blocks = size;
    for (now->family = 0; now->family < FAMILIES; now->family++) {
        if (bench->family >= 0 && now->family != bench->family)
            continue;
        fprintf(stderr, "%s/%d ", families[now->family].name, size);
        for (now->number = from; now->number < to; now->number++) {
            scene_open(&scene, now->family, size, now->number);
            ask_open(&ask, bench, &scene);
            if (bench->print)
                scene_print(&scene);
            else if (bench->question)
                ask_once(&ask);
            else
                measure_structure(&ask);
            ask_close(&ask);
            scene_close(&scene);
            fprintf(stderr, ".");
        }
        fprintf(stderr, "\n");
    }
}

/* Lean work memory [KB], of so many blocks and contacts. */
static void print_memory(int blocks, int contacts)
{
    const double lean =
        (KERN_LEAN_REALS(blocks, contacts) * (double)sizeof(kern_real)
         + KERN_LEAN_INTS(blocks, contacts) * (double)sizeof(int)) / 1024;
    const double whole = lean + ((double)blocks * sizeof(kern_block)
        + (double)contacts * sizeof(kern_contact)) / 1024;
    printf("memory,%d,%d,0,lean KB,%.9g\n", blocks, contacts, lean);
    printf("memory,%d,%d,0,whole KB,%.9g\n", blocks, contacts, whole);
}

/* ---- The program --------------------------------------------------------- */

static int usage(FILE *out, int status)
{
    fprintf(out,
            "bench [OPTIONS]\n"
            "  --quick     shorter timing, five structures a family\n"
            "  --release   also 500, 1000 and 2000 blocks\n"
            "  --family F  bond, rag, irr, tower, arch or brick alone\n"
            "  --sizes N,N at most %d, each of 5 to 5000 blocks\n"
            "  --number K  only structure K of each family and size\n"
            "  --print     write the structures as text, ask nothing\n"
            "  --ask Q     verdict, measure, level, load, tilt, floor, lp,\n"
            "              try or bears once, without clock\n"
            "  --times K   that it is asked\n", SIZES_MOST);
    return status;
}

static int read_sizes(struct bench *bench, const char *text)
{
    for (bench->sizes = 0; *text && bench->sizes < SIZES_MOST; text++) {
        char *end;
        const long size = strtol(text, &end, 10);
        if (end == text || size < 5 || size > 5000)
            return 0;
        bench->size[bench->sizes++] = (int)size;
        text = end;
        if (*text != ',')
            break;
    }
    return bench->sizes > 0 && !*text;
}

/* An option with a value; 0: there is none. */
static int read_value(struct bench *bench, const char *option,
                      const char *value)
{
    if (strcmp(option, "--sizes") == 0)
        return read_sizes(bench, value);
    if (strcmp(option, "--family") == 0) {
        while (++bench->family < FAMILIES)
            if (strcmp(families[bench->family].name, value) == 0)
                return 1;
    } else if (strcmp(option, "--ask") == 0) {
        for (bench->question = questions; bench->question->name;
             bench->question++)
            if (strcmp(bench->question->name, value) == 0)
                return 1;
    } else if (*value >= '0' && *value <= '9') {
        int *const number = strcmp(option, "--number") == 0 ? &bench->number
                          : strcmp(option, "--times") == 0 ? &bench->times
                          : NULL;
        if (number)
            *number = atoi(value);
        return number != NULL;
    }
    return 0;
}

static int read_options(struct bench *bench, int argc, char **argv)
{
    static const char *const flag[] = {"--quick", "--release", "--print"};
    int *const on[] = {&bench->quick, &bench->release, &bench->print};
    int i, k;
    for (i = 1; i < argc; i++) {
        for (k = 0; k < 3 && strcmp(argv[i], flag[k]) != 0; k++)
            ;
        if (k < 3)
            *on[k] = 1;
        else if (i + 1 == argc || !read_value(bench, argv[i], argv[i + 1]))
            return 0;
        else
            i++;
    }
    return 1;
}

int main(int argc, char **argv)
{
    struct bench *bench = room_for(1, sizeof *bench);
    int status, i, plain;
    bench->family = bench->number = -1;
    bench->times = 1;
    if (argc == 2 && strcmp(argv[1], "--help") == 0)
        return usage(stdout, 0);
    if (!read_options(bench, argc, argv))
        return usage(stderr, 2);
    if (bench->sizes == 0)
        read_sizes(bench, bench->release
                   ? "5,10,20,30,50,100,200,500,1000,2000"
                   : "5,10,20,30,50,100,200");
    bench->batch = bench->quick ? 0.3 : 1.7;
    bench->once = bench->quick ? 10 : 200;
    plain = !bench->print && !bench->question;
    if (plain)
        printf("family,blocks,number,wall,name,value\n");
    for (i = 0; i < bench->sizes; i++)
        measure_size(bench, bench->size[i]);
    if (plain) {
        print_memory(31, 140);    /* 30 blocks with 70 line contacts */
        print_memory(1001, 3500);
        fprintf(stderr, "%d structures, %d checks, %d disagree, %d margins of "
                "candidates differ by more\nthan 1e-9 within their brackets; a "
                "peer had no answer %d times.\n", bench->structures,
                bench->checks, bench->differences, bench->inside,
                bench->silent);
    }
    status = bench->differences > 0;
    free(bench);
    return status;
}
