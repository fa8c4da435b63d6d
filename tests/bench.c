/* bench.c: how long the questions of kern.h take, beside general LP solvers

   Build it in the directory of kern.h:

       cc -O2 -ffp-contract=off -o bench tests/bench.c -lm

   and with one or both of the peers (Debian: libglpk-dev, coinor-libclp-dev;
   where the linker misses C++ symbols of Clp, add -lstdc++):

       cc -O2 -ffp-contract=off -DBENCH_GLPK -DBENCH_CLP -o bench \
           tests/bench.c -lglpk -lClp -lCoinUtils -lm

   DAQP is fetched: its sources are compiled into a folder of your own,

       git clone https://github.com/darnstrom/daqp DAQP
       (cd DAQP && cc -O2 -Iinclude -c src/[a-z]*.c && ar rcs libdaqp.a [a-z]*.o)

   and -DBENCH_DAQP -IDAQP/include -LDAQP -ldaqp are added. OSQP 1.0 is fetched,
   too (its own build fetches QDLDL):

       git clone https://github.com/osqp/osqp OSQP
       cmake -S OSQP -B OSQP/build -DCMAKE_BUILD_TYPE=Release
       cmake --build OSQP/build --target osqpstatic

   with -DBENCH_OSQP -IOSQP/include/public -IOSQP/build/include/public
   -LOSQP/build/out -losqpstatic. Both look for the least-norm forces; their times
   include the setup, which factors the matrix. OSQP ends at 1e-6.

   So is Box2D 3, beside which a robot's whole question is asked (robot.h):

       git clone https://github.com/erincatto/box2d BOX2D
       (cd BOX2D && cc -O2 -DNDEBUG -std=gnu17 -Iinclude -c src/[a-z]*.c &&
           ar rcs libbox2d.a [a-z]*.o)

   with -DBENCH_BOX2D -IBOX2D/include -LBOX2D -lbox2d -lpthread.

   Then ./bench prints CSV, one line for each number that is known of a
   structure: family or set, blocks, number or file, kind (0 made, 1 a made wall,
   2 a file), the name of the number, its value. It asks the reported half of the
   corpus first (tests/CORPUS.md), then made structures of 5 to 200 blocks.
   ./bench --quick takes less time, ./bench --release goes on to 500, 1000 and
   2000 blocks, ./bench --help lists the options. Progress goes to stderr. The
   exit status is 1 if any two answers disagree; times are never judged by it.
   tests/bench.awk makes tables of the CSV:

       ./bench >times.csv && awk -f tests/bench.awk times.csv

   and bash tests/bench.sh writes those of tests/BENCH.md.

   Instructions instead of times: bash tests/work.sh corpus.

   TIMES are CPU time of this one process, in ms, of the fastest of three
   batches, each long enough for the clock; before each the work memory is
   filled with garbage. A verdict, a measure and so on of kern.h include
   everything from the caller's data to the checked proof, except contact
   search, which has its own column. A peer's time is that of its solve alone,
   the model ready in its memory; of its Algorithm 1, of 20 levels, each from
   the last basis, with the torque entries written in between. Both get programs
   that are built from the equations and not by kern.h (peers.h).

   The FLOOR is what no measure can do without: kern_check_forces() at `holds`
   and, unless it stands with every kern closed, kern_check_motion() at `fails`.
   Each checks the whole input, which stands for opening it, and evaluates the
   columns of the matrix once.

   The STEP of Algorithm 1 is random: the margin is 19 to 20 steps. For one
   structure of eight a step falls into the bracket of the margin, where the
   level takes a question of its own; left to chance that is too rare to see.

   CANDIDATES: of a file, up to three stones that carry none, the highest first,
   are each taken off and tried again at their places. On a made wall a stone is
   laid at places along all of its top, a quarter of a brick apart (above 50
   blocks farther): it stands, falls, hangs over an end, or overlaps. A try is
   kern_plan_try on the wall as it was measured, contact search included.
   `tries/s` is the number of places over the time of all, `stay/s` the same of
   those where the margin of the wall stays as it was, `bears/s` that of all when
   only asked whether the margin is at least a share of the wall's, drawn from .5
   to 1. Each answer is compared with that of kern_measure of all blocks from
   nothing; `try / measure` is the median of the ratios of their times where the
   stone stands.

   MEDIANS, of bench.awk: files count alike, by size; of made structures a
   family's number is the median over its structures, a size's number the median
   over the families' numbers. A ratio is taken for each structure, against the
   faster simplex on that structure. The worst is that of any structure. Each
   peer's own times stand beside the verdict's, with how often it had no answer or
   a wrong one: two questions a structure that stands, as it is and with all kerns
   closed, and wrong only beyond NEAR of the critical value. What kern.h
   leaves undecided is in no median, but is listed as DISAGREE; structures
   without a margin are listed at the end.

   SPDX-License-Identifier: MIT */

#define _POSIX_C_SOURCE 199309L

#include <time.h>

#include "robot.h"

#define NEAR \
    1e-5             /* mean block sizes around d* where peers, with
                              their tolerances of 1e-7, may answer either way */
#define BRACKET 2e-6 /* mean block sizes from holds to fails at the most */
/* The LIMITS of kern.h: in larger structures a margin may lie anywhere in its
   bracket, and in still larger ones that may be so many mean sizes wide. */
#define EXACT_MOST 128
#define NARROW_MOST 256
#define BRACKET_WIDE 3e-5
#define LEVELS 20       /* of Algorithm 1                                  */
#define DETAIL_MOST 200 /* largest structures of which all is asked        */
#define CLOSED_MOST 500 /* and whose kerns are closed                      */
#define SIZES_MOST 16

/* ---- Records ------------------------------------------------------------- */

/* Everything that is known of a structure. A new number needs a line here, a
   note() where it is found, and a place in a table of bench.awk. Ratios name
   what is divided by what. */
#define COLUMNS_OF(X)                                                         \
    X(NONE, "", 0, 0)                                                         \
    X(VERDICT, "verdict ms", 0, 0)     /* kern_verdict at 0                */ \
    X(MEASURE, "measure ms", 0, 0)     /* kern_measure with both proofs    */ \
    X(LEVEL, "scan ms", 0, 0)          /* kern_verdict at each level       */ \
    X(CLOSED, "kerns closed ms", 0, 0) /* kern_verdict, kerns closed       */ \
    X(LOAD, "load ms", 0, 0)           /* kern_load_factor to the right    */ \
    X(TILT, "tilt ms", 0, 0)           /* kern_tilt to the right           */ \
    X(FLOOR, "floor ms", 0, 0)                                                \
    X(SEARCH, "contacts ms", 0, 0) /* kern_contacts                    */     \
    X(GLPK, "GLPK ms", 0, 0)                                                  \
    X(CLP, "Clp ms", 0, 0)                                                    \
    X(DAQP, "DAQP ms", 0, 0)                                                  \
    X(OSQP, "OSQP ms", 0, 0)                                                  \
    X(GLPK_WARM, "GLPK's Alg. 1 ms", 0, 0)                                    \
    X(CLP_WARM, "Clp's Alg. 1 ms", 0, 0)                                      \
    X(LP, "peer's LP ms", 0, 0) /* of the faster simplex            */        \
    X(WARM, "peer's Alg. 1 ms", 0, 0)                                         \
    X(LP_CLOSED, "LP closed ms", 0, 0)                                        \
    X(POINTS, "points", 0, 0) /* contact points                   */          \
    X(FALLEN, "fallen", 0, 0) /* it has no margin                 */          \
    X(MARGIN, "d*/d_max", 0, 0)                                               \
    X(FIRST, "pivots at 0", 0, 0) /* of the verdict                   */      \
    X(PIVOTS, "pivots", 0, 0)     /* of the measure                   */      \
    X(SOLVES, "LPs", 0, 0)                                                    \
    X(VERDICT_LP, "verdict / LP", VERDICT, LP)                                \
    X(MEASURE_LP, "measure / LP", MEASURE, LP)                                \
    X(LOAD_LP, "load / LP", LOAD, LP)                                         \
    X(TILT_LP, "tilt / LP", TILT, LP)                                         \
    X(SEARCH_LP, "contacts / LP", SEARCH, LP)                                 \
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
    int over, under; /* of a ratio; else NONE                           */
} columns[] = {COLUMNS_OF(COLUMN_LINE)};

struct bench {
    int size[SIZES_MOST], sizes;
    int family, number; /* -1: all                                         */
    const char *list;   /* of files; NULL: none                            */
    int quick, print, release;
    double batch;          /* shortest time on the clock [ms]                 */
    double once;           /* longer than this is run but once [ms]           */
    double value[COLUMNS]; /* of the structure at hand; NAN: not found        */
    double tried[TOPS];    /* of a file: the times of its tries [ms]          */
    int tries;
    kern_plan whole; /* of a made wall: a candidate is added to it      */
    int structures, checks, differences, silent;
    int place, placements; /* of the robot                                 */
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

/* Prints a number of the structure at hand. */
static void record(const struct ask *ask, const char *text, double value)
{
    const struct scene *scene = ask->scene;
    if (!isnan(value))
        printf("%.*s,%d,%s,%d,%s,%.9g\n", (int)strcspn(scene->name, "/"),
               scene->name, scene->size, strrchr(scene->name, '/') + 1,
               scene->is_file ? 2 : scene->is_wall, text, value);
}

/* Prints what was found of a structure, and the ratios. */
static void record_all(struct ask *ask)
{
    struct bench *bench = ask->bench;
    int i;
    for (i = 0; i < COLUMNS; i++) {
        const struct column *c = &columns[i];
        record(ask, c->text,
               c->over ? bench->value[c->over] / bench->value[c->under]
                       : bench->value[i]);
    }
    for (i = 0; i < bench->tries; i++) {
        record(ask, "try ms", bench->tried[i]);
        record(ask, "try / LP", bench->tried[i] / bench->value[LP]);
    }
    bench->structures++;
}

/* ---- Questions ----------------------------------------------------------- */

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
                       ? (int)(bench->batch / fmax(best, 1e-4)) + 1
                       : 1;
    int i;
    if (best > bench->once || (before && ask->scene->size > DETAIL_MOST))
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
    fprintf(stderr, "DISAGREE %s: %s: %.12g, %.12g\n", ask->scene->name, what,
            ours, theirs);
}

/* Shrinkages as good as the same to a peer [m]. */
static double near_of(const struct ask *ask) { return NEAR * ask->lp.length; }

static int is_same(const struct ask *ask, double a, double b)
{
    return fabs(a - b) <= SAME * ask->lp.length;
}

/* Whether two margins of one structure agree: above EXACT_MOST blocks kern.h
   promises a place in the bracket alone. */
static int margins_agree(const struct ask *ask, const kern_margin *a,
                         const kern_margin *b)
{
    return is_same(ask, a->margin, b->margin)
        || (ask->scene->size > EXACT_MOST && a->holds <= b->fails
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

/* ---- Ours ---------------------------------------------------------------- */

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

/* A measure with the default step, and the step that the structure gets. */
static kern_status settle(struct ask *ask)
{
    struct scene *scene = ask->scene;
    const kern_margin *m = &ask->margin;
    const double where = scene_random(scene, 0, 1);
    const int inside = scene_random(scene, 0, 8) < 1;
    run_measure(ask);
    if (ask->status != KERN_STANDS || m->margin < 1e-4 * m->most)
        return ask->status; /* of a smaller step there may be too many */
    scene->options.epsilon = inside && !m->saturated
                               ? (m->holds + where * (m->fails - m->holds))
                                     / (LEVELS - 1)
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
    if (ask->status
        == KERN_LIMIT) { /* the verdict is all there is to compare */
        ask->margin.margin = 0;
        return ask->status = first;
    }
    check(ask, first == ask->status, "verdict at 0, of the measure", first,
          ask->status);
    return ask->status;
}

/* The measure, its proofs, and how near to each other they are. */
static void measure_margin(struct ask *ask)
{
    const kern_margin *m = &ask->margin, before = *m;
    const int blocks = ask->scene->size;
    const double width = blocks > NARROW_MOST ? BRACKET_WIDE : BRACKET;
    note(ask, MEASURE, time_of(ask, run_measure, NULL));
    check(ask, ask->status == KERN_STANDS && margins_agree(ask, m, &before),
          "margin with another step", before.margin, m->margin);
    note(ask, MARGIN, m->margin / m->most);
    note(ask, FLOOR, time_of(ask, run_floor, NULL));
    check(ask, ask->number <= 1, "error of a proof", ask->number, 1);
    check(ask, m->saturated || m->fails - m->holds <= width * ask->lp.length,
          "bracket of the margin", m->holds, m->fails);
}

/* Fresh verdicts on both sides of the margin, and the literal scan. */
static void measure_levels(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    check(ask, ask_stands(ask, fmax(m->margin - near_of(ask), 0)) == 1,
          "status below the margin", ask->status, m->margin);
    if (!m->saturated && m->margin + near_of(ask) < m->most)
        check(ask, ask_stands(ask, m->margin + near_of(ask)) == 0,
              "status above the margin", ask->status, m->margin);
    if (ask->scene->is_file)
        return;
    note(ask, LEVEL, time_of(ask, run_level, NULL));
    check(ask, level_fits(m, 0, (int)ask->number), "scan, level", m->level,
          ask->number);
}

static void measure_closed(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    ask->shrink = m->most;
    note(ask, CLOSED, time_of(ask, run_verdict, NULL));
    check(ask,
          m->saturated || ask->status == KERN_FALLS
              || m->most - m->margin < NEAR * m->most,
          "falls with its kerns closed", ask->status, m->margin);
}

static int has_loads(const struct scene *scene)
{
    int i;
    for (i = 0; i < scene->blocks; i++) {
        const kern_wrench *w = &scene->block[i].load;
        if (fabs(w->fx) + fabs(w->fy) + fabs(w->torque) > 0)
            return 1;
    }
    return 0;
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
    if (ask->number < 1.5 && factor < 10 && !has_loads(ask->scene))
        check(ask,
              fabs(tan(ask->number) - factor) <= 1e-5 * (1 + factor * factor),
              "tan(tilt), load factor", tan(ask->number), factor);
}

/* ---- Candidates ---------------------------------------------------------- */

/* kern_measure() without what is known of the plan. */
static void run_fresh(struct ask *ask)
{
    kern_task task = ask->bench->whole.task;
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
    check(ask,
          bears == due
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
    kern_plan_add(&ask->bench->whole, &ask->stone);
    fresh = time_of(ask, run_fresh, NULL);
    kern_plan_remove(&ask->bench->whole, ask->bench->whole.task.s.blocks - 1);
    check(ask, ask->status == status, "candidate, verdict", status,
          ask->status);
    if (tally->bears_time > 0)
        check_bears(ask, bears);
    if (status != KERN_STANDS || ask->status != status)
        return;
    /* where both proofs hold over some way, each may end at another place */
    same = is_same(ask, m.margin, ask->with.margin);
    ask->bench->inside += !same;
    check(ask,
          same || (m.holds <= ask->with.fails && ask->with.holds <= m.fails),
          "candidate, margin", m.margin, ask->with.margin);
    check(ask, level_fits(&ask->with, 0, m.level), "candidate, level", m.level,
          ask->with.level);
    tally->share[tally->stand++] = tried / fresh;
    if (is_same(ask, m.margin, ask->margin.margin)) {
        tally->stay++;
        tally->stay_time += tried;
    }
}

static void measure_places(struct ask *ask)
{
    struct bench *bench = ask->bench;
    struct tally tally;
    int i, places;
    memset(&tally, 0, sizeof tally);
    places = site_open(ask);
    check(ask, margins_agree(ask, &ask->with, &ask->margin),
          "margin of the plan", ask->with.margin, ask->margin.margin);
    bench->whole = plan_open(ask, -1);
    for (i = 0; i < places; i++) {
        site_lay(ask, i);
        measure_place(ask, &tally);
    }
    plan_close(&bench->whole);
    note(ask, PLACES, places);
    note(ask, STAND, tally.stand);
    note(ask, STAY, tally.stay);
    note(ask, TRY_MEASURE, median(tally.share, tally.stand));
    note(ask, RATE, 1000 * places / tally.all_time);
    if (tally.stay > 0)
        note(ask, RATE_STAY, 1000 * tally.stay / tally.stay_time);
    if (tally.bears_time > 0)
        note(ask, RATE_BEARS, 1000 * places / tally.bears_time);
}

/* The highest stones that carry none, each taken off and tried again. */
static void measure_tops(struct ask *ask)
{
    struct bench *bench = ask->bench;
    int top[TOPS], k;
    const int n = scene_tops(ask->scene, top, TOPS);
    for (k = 0; k < n; k++) {
        if (take_off(ask, top[k]) != KERN_STANDS)
            continue;
        bench->tried[bench->tries++] = time_of(ask, run_try, NULL);
        check(ask, ask->status == KERN_STANDS, "stone tried again", ask->status,
              KERN_STANDS);
        check(ask, margins_agree(ask, &ask->with, &ask->margin),
              "margin of the stone tried again", ask->with.margin,
              ask->margin.margin);
    }
}

/* ---- A robot's question --------------------------------------------------- */

/* The contacts of the stone, on a plan of its own. */
static void run_touch(struct ask *ask)
{
    kern_plan *whole = &ask->bench->whole;
    ask->number = kern_plan_add(whole, &ask->stone);
    if (ask->number >= 0)
        kern_plan_remove(whole, whole->task.s.blocks - 1);
}

static void run_stays_of(struct ask *ask)
{
    ask->status = kern_plan_stays(&ask->plan, &ask->stone, &ask->number);
}

/* The pose: where a brick comes to rest that is let down at the place. */
static void run_pose(struct ask *ask)
{
    static kern_vec corner[8];
    const kern_vec upright = {1, 0};
    kern_pose pose;
    site_lay(ask, ask->bench->place);
    ask->status = kern_rest(&ask->plan.task, &ask->stone, ask->stone.centre.x,
                            upright, corner, &pose);
    if (ask->status == KERN_OK)
        ask->stone = pose.block;
}

/* Whether it stands at all: the simulator asks for no margin. */
static void run_bears_any(struct ask *ask)
{
    ask->status = kern_plan_bears(&ask->plan, &ask->stone, 0, NULL);
}

#ifdef BENCH_BOX2D
static void run_simulator(struct ask *ask)
{
    ask->answer = run_stays(&ask->plan, &ask->stone);
}
#endif

/* Prints the times of one placement, their sum, and whether both agree. A step
   that says no ends the question. Returns 0 where the place overlaps. */
static int measure_robot(struct ask *ask)
{
    static ask_function *const run[STEPS] = {run_pose, run_touch, run_bears_any,
                                             run_try, run_stays_of};
    double time[STEPS], sum = 0;
    int step, lets_go = 1, answered = STEPS;
    for (step = 0; step < STEPS && lets_go; step++) {
        time[step] = time_of(ask, run[step], NULL);
        sum += time[step];
        answered = step + 1;
        if (step == TOUCH)
            lets_go = ask->number >= 0;
        else if (step == BEARS || step == TRY)
            lets_go = ask->status == KERN_STANDS;
        else if (step == STAYS)
            lets_go = ask->status == KERN_STANDS && ask->number >= ROBOT_CHANCE;
        if (ask->status == KERN_OVERLAP || (step == TOUCH && !lets_go))
            return 0;
    }
    for (step = 0; step < answered; step++) {
        char text[20];
        snprintf(text, sizeof text, "robot %s us", step_name[step]);
        record(ask, text, 1e3 * time[step]);
    }
    record(ask, "robot kern us", 1e3 * sum);
    record(ask, "robot lets go", lets_go);
#ifdef BENCH_BOX2D
    {
        const double theirs = time_of(ask, run_simulator, NULL);
        record(ask, "robot Box2D us", 1e3 * theirs);
        record(ask, "robot Box2D stays", ask->answer);
        record(ask, "robot Box2D / kern", theirs / sum);
    }
#endif
    return 1;
}

/* Places along the top of a wall that was measured. */
static void measure_wall(struct bench *bench, int family, int size, int number)
{
    struct scene scene;
    struct ask ask;
    int i, places;
    scene_make(&scene, family, size, number);
    ask_open(&ask, &scene);
    ask.bench = bench;
    run_measure(&ask);
    if (ask.status == KERN_STANDS && ask.margin.margin > 0) {
        places = site_open(&ask);
        bench->whole = plan_open(&ask, -1);
        for (i = 0; i < places && i < ROBOT_PLACES; i++) {
            bench->place = i * places / ROBOT_PLACES;
            if (places < ROBOT_PLACES)
                bench->place = i;
            bench->placements += measure_robot(&ask);
        }
        plan_close(&bench->whole);
    }
    ask_close(&ask);
    scene_close(&scene);
}

/* Walls of convex blocks: those without slope. */
static void measure_robots(struct bench *bench)
{
    static const int size[] = {8, 20, 33, 100};
    int family, number, i;
    fprintf(stderr, "robot ");
    for (i = 0; i < (int)(sizeof size / sizeof size[0]); i++)
        for (family = 0; family < FAMILIES; family++)
            for (number = 0; number < 3; number++)
                if (families[family].is_wall
                    && !(families[family].wall.slope > 0))
                    measure_wall(bench, family, size[i], number);
    fprintf(stderr, "%d placements\n", bench->placements);
}

/* ---- Theirs -------------------------------------------------------------- */

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

/* Asks a peer one question, and records its time, that of the verdict on it, and
   whether its answer is right, wrong or none. Returns the time. */
static double ask_peer(struct ask *ask, const char *question, double shrink,
                       int right, double ours)
{
    char text[40];
    const char *name = ask->peer->name;
    double time;
    ask->shrink = shrink;
    time = time_of(ask, run_lp, open_lp);
    ask->bench->silent += ask->answer < 0;
    close_lp(ask);
    (void)snprintf(text, sizeof text, "peer %s %s %s", name, question,
                   ask->answer < 0                     ? "none"
                   : right < 0 || ask->answer == right ? "right"
                                                       : "wrong");
    record(ask, text, time / ours);
    return time;
}

/* Asks a simplex for the level of Algorithm 1, each verdict from the last basis. */
static void measure_peer_levels(struct ask *ask)
{
    const struct peer *peer = ask->peer;
    const kern_margin *m = &ask->margin;
    double time;
    ask->shrink = 0;
    time = time_of(ask, run_lp_levels, open_lp);
    ask->bench->silent += ask->answer < 0;
    close_lp(ask);
    note(ask, GLPK_WARM + peer->number, time);
    note(ask, WARM, fmin(ask->bench->value[WARM], time));
    check(ask, ask->answer < 0 || level_fits(m, near_of(ask), ask->answer),
          peer->name, m->level, ask->answer);
}

/* Differences of a simplex count unless the shrinkage is as good as critical:
   then either answer is right. */
static void measure_peer(struct ask *ask)
{
    const struct peer *peer = ask->peer;
    const double *value = ask->bench->value;
    const kern_margin *m = &ask->margin;
    const int stands = ask->status == KERN_STANDS;
    const int open = stands && m->margin < near_of(ask) ? -1 : stands;
    const int closed = m->saturated                       ? 1
                     : m->most - m->margin < near_of(ask) ? -1
                                                          : 0;
    double time = ask_peer(ask, "open", 0, open, value[VERDICT]);
    note(ask, GLPK + peer->number, time);
    if (peer->is_simplex) {
        note(ask, LP,
             fmin(value[LP], time)); /* of NAN and a number the number */
        check(ask, ask->answer < 0 || open < 0 || ask->answer == open,
              "verdict at 0, of a peer", ask->status, ask->answer);
    }
    if (!stands || !(m->margin > 0) || ask->scene->size > CLOSED_MOST)
        return;
    time = ask_peer(ask, "closed", m->most, closed, value[CLOSED]);
    if (!peer->is_simplex)
        return;
    note(ask, LP_CLOSED, fmin(value[LP_CLOSED], time));
    check(ask, ask->answer < 1 || closed, "peer stands with kerns closed",
          m->margin, m->most);
    if (ask->scene->size <= DETAIL_MOST && !ask->scene->is_file)
        measure_peer_levels(ask);
}

/* ---- One structure ------------------------------------------------------- */

static void measure_standing(struct ask *ask)
{
    const struct scene *scene = ask->scene;
    const int detail = scene->size <= DETAIL_MOST;
    measure_margin(ask);
    if (detail) {
        measure_levels(ask);
        measure_sideways(ask);
    }
    if (scene->size <= CLOSED_MOST)
        measure_closed(ask);
    if (detail && scene->is_wall)
        measure_places(ask);
    if (scene->is_file && !scene->text.given && scene->size > 3)
        measure_tops(ask);
}

static void measure_structure(struct ask *ask)
{
    struct bench *bench = ask->bench;
    const struct scene *scene = ask->scene;
    kern_status status;
    int i;
    for (i = 0; i < COLUMNS; i++)
        bench->value[i] = NAN;
    bench->tries = 0;
    note(ask, POINTS, scene->contacts);
    if (!scene->text.given)
        note(ask, SEARCH, time_of(ask, run_contacts, NULL));
    status = measure_verdict(ask);
    if (status == KERN_STANDS && ask->margin.margin > 0)
        measure_standing(ask);
    else
        note(ask, FALLEN, 1);
    ask->status = status;
    for (ask->peer = peers; ask->peer->name; ask->peer++)
        if (scene->size <= ask->peer->most)
            measure_peer(ask);
    record_all(ask);
}

/* Asks about a scene, and closes it. */
static void measure_scene(struct bench *bench, struct scene *scene)
{
    struct ask ask;
    ask_open(&ask, scene);
    ask.bench = bench;
    garble(&ask.work);
    if (bench->print)
        scene_print(scene);
    else
        measure_structure(&ask);
    ask_close(&ask);
    scene_close(scene);
    fprintf(stderr, ".");
}

static void measure_list(struct bench *bench, const char *name)
{
    FILE *list = list_open(name);
    struct scene scene;
    char path[1000];
    fprintf(stderr, "%s ", name);
    while (list_next(list, path, (int)sizeof path)) {
        scene_read(&scene, path);
        measure_scene(bench, &scene);
    }
    fprintf(stderr, "\n");
    fclose(list);
}

static void measure_size(struct bench *bench, int size)
{
    const int from = bench->number < 0 ? 0 : bench->number;
    const int to = bench->number >= 0 ? from + 1
                 : size > DETAIL_MOST ? 3
                 : bench->quick       ? 5
                                      : 9;
    struct scene scene;
    int family, number;
    for (family = 0; family < FAMILIES; family++) {
        if (bench->family >= 0 && family != bench->family)
            continue;
        fprintf(stderr, "%s/%d ", families[family].name, size);
        for (number = from; number < to; number++) {
            scene_make(&scene, family, size, number);
            measure_scene(bench, &scene);
        }
        fprintf(stderr, "\n");
    }
}

/* Lean work memory [KB], of so many blocks and contacts. */
static void print_memory(int blocks, int contacts)
{
    const double lean =
        (KERN_LEAN_REALS(blocks, contacts) * (double)sizeof(kern_real)
         + KERN_LEAN_INTS(blocks, contacts) * (double)sizeof(int))
        / 1024;
    const double whole = lean
                       + ((double)blocks * sizeof(kern_block)
                          + (double)contacts * sizeof(kern_contact))
                             / 1024;
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
            "  --list FILE the files that it names, and no made structures;\n"
            "              else those of tests/corpus/even.txt are first\n"
            "  --family F  bond, rag, irr, tower, arch, brick or fit alone\n"
            "  --sizes N,N at most %d, each of 5 to 5000 blocks\n"
            "  --number K  only structure K of each family and size; with any\n"
            "              of these three no files\n"
            "  --print     write the made structures as text, ask nothing\n",
            SIZES_MOST);
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
    if (strcmp(option, "--list") == 0) {
        bench->list = value;
        return 1;
    }
    if (strcmp(option, "--sizes") == 0)
        return read_sizes(bench, value);
    if (strcmp(option, "--family") == 0) {
        while (++bench->family < FAMILIES)
            if (strcmp(families[bench->family].name, value) == 0)
                return 1;
    } else if (*value >= '0' && *value <= '9'
               && strcmp(option, "--number") == 0) {
        bench->number = atoi(value);
        return 1;
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

static void measure_all(struct bench *bench)
{
    const int some = bench->sizes > 0 || bench->family >= 0
                  || bench->number >= 0 || bench->print;
    int i;
    if (bench->list) {
        measure_list(bench, bench->list);
        return;
    }
    if (!some) {
        measure_robots(bench);
        measure_list(bench, "tests/corpus/even.txt");
    }
    if (bench->sizes == 0)
        read_sizes(bench, bench->release ? "5,10,20,30,50,100,200,500,1000,2000"
                                         : "5,10,20,30,50,100,200");
    for (i = 0; i < bench->sizes; i++)
        measure_size(bench, bench->size[i]);
}

int main(int argc, char **argv)
{
    struct bench *bench = room_for(1, sizeof *bench);
    int status;
    bench->family = bench->number = -1;
    if (argc == 2 && strcmp(argv[1], "--help") == 0)
        return usage(stdout, 0);
    if (!read_options(bench, argc, argv))
        return usage(stderr, 2);
    bench->batch = bench->quick ? 0.3 : 1.7;
    bench->once = bench->quick ? 10 : 200;
    if (!bench->print)
        printf("family,blocks,number,kind,name,value\n");
    measure_all(bench);
    if (!bench->print) {
        print_memory(31, 140); /* 30 blocks with 70 line contacts */
        print_memory(1001, 3500);
        fprintf(stderr,
                "%d structures, %d checks, %d disagree, %d margins of "
                "candidates differ by more\nthan 1e-9 within their brackets; a "
                "peer had no answer %d times.\n",
                bench->structures, bench->checks, bench->differences,
                bench->inside, bench->silent);
    }
    status = bench->differences > 0;
    free(bench);
    return status;
}
