/* harness.h - checks and how many failed; tolerances and random numbers. */

#ifndef UNIT_HARNESS_H
#define UNIT_HARNESS_H

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../../examples/parts/random.h"

static long passed, failed, failed_here;
static char context[160]; /* which random case, for messages */
static int quick;         /* fewer random structures */

/* How many of `all` structures are made. */
static int some(int all) { return quick ? all / 5 : all; }

/* The place of a check in the source, as a string. */
#define TEXT_OF(x) #x
#define LINE_TEXT(line) TEXT_OF(line)
#define HERE __FILE__ ":" LINE_TEXT(__LINE__)

static void check_report(int ok, const char *where, const char *what,
                         double got, double want, double tol)
{
    if (ok) {
        passed++;
        return;
    }
    failed++;
    if (failed_here++ < 10)
        printf("%s: %s: got %.12g, want %.12g within %.3g %s\n", where, what,
               got, want, tol, context);
}

static int check_near(double got, double want, double tol, const char *where,
                      const char *what)
{
    /* a NaN fails; equal infinities pass */
    const int ok = fabs(got - want) <= tol
                || (isinf(got) && isinf(want) && (got > 0) == (want > 0));
    check_report(ok, where, what, got, want, tol);
    return ok;
}

#define CHECK(cond) check_report((cond) ? 1 : 0, HERE, #cond, 0, 1, 0)
#define CHECK_INT(got, want) \
    check_near((double)(got), (double)(want), 0, HERE, #got)
#define CHECK_NEAR(got, want, tol) \
    check_near((double)(got), (double)(want), (double)(tol), HERE, #got)

/* Whether run(4 n) takes less than `most` times as long as run(n): 4 where time
   is proportional to n, 16 where it is to n^2. Each is the least of up to 30
   runs, since a machine that is busy takes longer now and then. */
static int grows_less(void (*run)(int), int n, double most)
{
    double least[2] = {HUGE_VAL, HUGE_VAL};
    int i, k;
    for (i = 0; i < 30; i++) {
        for (k = 0; k < 2; k++) {
            const clock_t start = clock();
            run(k ? 4 * n : n);
            least[k] = fmin(least[k], (double)(clock() - start));
        }
        if (i > 1 && least[1] < most * fmax(least[0], 1))
            return 1;
    }
    return 0;
}

/* A test. Each room ends with the list of its tests, in an array of the name
   ROOM_tests. */
typedef struct test {
    const char *name;
    void (*run)(void);
} test;

#define TEST(name)  \
    {               \
#name, name \
    }

/* ---- tolerances and random numbers ---- */

#define R(x) ((kern_real)(x))
#define COUNT_OF(array) ((int)(sizeof(array) / sizeof *(array)))

#ifdef KERN_USE_GLPK
#define GLPK 1
#else
#define GLPK 0
#endif
#ifdef KERN_SINGLE
typedef double wide; /* the twin's numbers: wider than kern_real */
#define SINGLE 1
#define EPS ((double)FLT_EPSILON)
#define FORCE_BOUND 1e3  /* F: forces larger than this count as none */
#define TWIN_ZERO 1e-12  /* the twin's own rounding: of its sum,     */
#define TWIN_PRICE 1e-14 /* of its prices,                           */
#define TWIN_PIVOT 1e-10 /* and of its pivots                        */
#define NEAR_LO \
    1e-7 /* shortfall, as a share of the weight, that                          \
            is surely none ...                       */
#define NEAR_HI \
    2e-3 /* ... and surely one: in between a verdict                           \
            may be either                            */
#else
typedef long double wide;
#define SINGLE 0
#define EPS DBL_EPSILON
#define FORCE_BOUND 1e6
#define TWIN_ZERO 1e-15
#define TWIN_PRICE 1e-17
#define TWIN_PIVOT 1e-11
#define NEAR_LO 1e-12
#define NEAR_HI 1e-8
#endif

/* Share of a block's weight that a residual may be: 1e-9 in double. */
#define PROOF_TOL (SINGLE ? 1e-4 : 1e-9)
/* Lengths of thresholds found through verdicts, as a share of a block: a few
   times PROOF_TOL, since the verdict may be off by as much. */
#define EDGE (SINGLE ? 2e-3 : 5e-9)
/* Measures with a formula: the margin to 1e-9 of a block. */
#define EXACT (SINGLE ? 1e-4 : 1e-9)
/* Tables of five digits. */
#define DIGITS5 6e-6
/* Geometry: some roundings. */
#define GEO (64 * EPS)

static const double pi = 3.14159265358979323846;

#define W 9.81 /* the weight of a unit cube */

/* A quiet NaN and an infinity that no compiler warns about. */
static double huge_value(void)
{
    volatile double x = DBL_MAX;
    return x * 2;
}

static double not_a_number(void)
{
    volatile double x = huge_value();
    return x - x;
}

enum { NO_NUMBERS = 3 };

static double no_number(int which)
{
    return which == 0 ? not_a_number()
         : which == 1 ? huge_value()
                      : -huge_value();
}

static uint64_t random_state = 88172645463325252ull;

static void random_seed(unsigned long long seed)
{
    random_state = random_from(seed);
}

static double uniform(double low, double high)
{
    return random_uniform(&random_state, low, high);
}

static int random_int(int low, int high) /* both ends included */
{
    return low + (int)(random_bits(&random_state) % (uint64_t)(high - low + 1));
}

static int chance(double share) { return uniform(0, 1) < share; }

#endif
