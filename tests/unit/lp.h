/* lp.h - linear programs by hand. */

#ifndef UNIT_LP_H
#define UNIT_LP_H

#include "harness.h"

enum { LP_ROWS = 11, LP_COLS = 24 };

typedef struct program {
    kern_lp lp;
    kern_real a[LP_ROWS * LP_COLS], rhs[LP_ROWS], cost[LP_COLS];
    kern_real x[LP_COLS], y[LP_ROWS];
} program;

/* rows of `table`: the coefficients, then the right-hand side */
static void program_set(program *p, int rows, int cols, const double *table,
                        const double *cost)
{
    int i, j;
    memset(p, 0, sizeof *p);
    for (i = 0; i < rows; i++) {
        for (j = 0; j < cols; j++)
            p->a[j * rows + i] = R(table[i * (cols + 1) + j]);
        p->rhs[i] = R(table[i * (cols + 1) + cols]);
    }
    for (j = 0; cost && j < cols; j++)
        p->cost[j] = R(cost[j]);
    p->lp.rows = rows;
    p->lp.cols = cols;
    p->lp.a = p->a;
    p->lp.rhs = p->rhs;
    p->lp.cost = cost ? p->cost : NULL;
}

/* The coordinates of an optimum, or of a ray of falling cost, which changes no
   row. Returns the cost. */
static double check_primal(const program *p, int got)
{
    const double tol = SINGLE ? 1e-3 : 1e-8;
    const int m = p->lp.rows, n = p->lp.cols;
    double cost = 0, large = 1;
    int i, j;
    for (j = 0; j < n; j++) {
        CHECK(p->x[j] >= 0);
        large = fmax(large, (double)p->x[j]);
        if (p->lp.cost)
            cost += (double)p->x[j] * (double)p->lp.cost[j];
    }
    for (i = 0; i < m; i++) {
        double sum = got == KERN_LP_OPTIMAL ? -(double)p->lp.rhs[i] : 0;
        for (j = 0; j < n; j++)
            sum += (double)p->lp.a[j * m + i] * (double)p->x[j];
        CHECK_NEAR(sum, 0, tol * large);
    }
    if (got == KERN_LP_UNBOUNDED)
        CHECK(cost < -tol * large * 0.01);
    return cost;
}

/* The prices of an optimum that costs so much, or the Farkas certificate. */
static void check_dual(const program *p, int got, double cost)
{
    const double tol = SINGLE ? 1e-3 : 1e-8;
    const int m = p->lp.rows, n = p->lp.cols, optimal = got == KERN_LP_OPTIMAL;
    double dual = 0, large = 0;
    int i, j;
    for (i = 0; i < m; i++) {
        dual += (double)p->y[i] * (double)p->lp.rhs[i];
        large = fmax(large, fabs((double)p->y[i]));
    }
    for (j = 0; j < n; j++) {
        double sum = optimal ? (double)p->lp.cost[j] : 0;
        for (i = 0; i < m; i++)
            sum += (optimal ? -1 : 1) * (double)p->lp.a[j * m + i]
                 * (double)p->y[i];
        CHECK(sum >= -tol * fmax(large, optimal ? 1 : 0));
    }
    if (optimal)
        CHECK_NEAR(cost, dual, 10 * tol * (1 + fabs(cost)));
    else
        CHECK(dual < -tol * 0.01 * large);
}

/* Solves and checks everything that the answer says of itself. */
static int program_solve(program *p)
{
    static kern_real real[KERN_LP_REALS(LP_ROWS, LP_COLS)];
    static int index[KERN_LP_INTS(LP_ROWS, LP_COLS)];
    kern_work work = kern_work_of(real, KERN_LP_REALS(LP_ROWS, LP_COLS), index,
                                  KERN_LP_INTS(LP_ROWS, LP_COLS));
    const int got = kern_lp_solve(&p->lp, p->x, p->y, &work);
    double cost = 0;
    if (got == KERN_LP_OPTIMAL || got == KERN_LP_UNBOUNDED)
        cost = check_primal(p, got);
    if (got == KERN_LP_INFEASIBLE || (got == KERN_LP_OPTIMAL && p->lp.cost))
        check_dual(p, got, cost);
    return got;
}

static double program_cost(const program *p)
{
    double sum = 0;
    int j;
    for (j = 0; j < p->lp.cols; j++)
        sum += (double)p->x[j] * (double)p->lp.cost[j];
    return sum;
}

static void lp_cycling(void)
{
    static const double beale[] = {0.25, -60, -0.04, 9, 1, 0, 0, 0,
                                   0.5,  -90, -0.02, 3, 0, 1, 0, 0,
                                   0,    0,   1,     0, 0, 0, 1, 1};
    static const double beale_cost[] = {-0.75, 150, -0.02, 6, 0, 0, 0};
    static const double kuhn[] = {-2,     -9, 1,       9,   1, 0, 0, 0,
                                  1. / 3, 1,  -1. / 3, -2,  0, 1, 0, 0,
                                  2,      3,  -1,      -12, 0, 0, 1, 2};
    static const double kuhn_cost[] = {-2, -3, 1, 12, 0, 0, 0};
    static const double kuhn_open[] = {-2,     -9, 1,       9,  1, 0, 0,
                                       1. / 3, 1,  -1. / 3, -2, 0, 1, 0};
    program p;
    program_set(&p, 3, 7, beale, beale_cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -0.05, 1e3 * EPS);
    CHECK_NEAR(p.x[0], 0.04, 1e3 * EPS);
    CHECK_NEAR(p.x[2], 1, 1e3 * EPS);
    program_set(&p, 3, 7, kuhn, kuhn_cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -2, 1e3 * EPS);
    /* without its last row Kuhn's example has no end; in float 1/3 is not a
       third, and the ray along which the second row stays 0 may be lost */
    program_set(&p, 2, 6, kuhn_open, kuhn_cost);
    CHECK_INT(program_solve(&p), KERN_LP_UNBOUNDED);
}

/* Klee and Minty's cube: the largest cost takes far more pivots than there are
   rows; they are within the bounds on pivots. */
static void lp_many_pivots(void)
{
    enum { N = 11 };
    double a[N * (2 * N + 1)] = {0}, cost[2 * N] = {0};
    program p;
    int i, j;
    if (SINGLE) /* its numbers are no floats */
        return;
    for (i = 0; i < N; i++) {
        double *row = a + i * (2 * N + 1);
        for (j = 0; j < i; j++)
            row[j] = pow(2, i - j + 1);
        row[i] = row[N + i] = 1;
        row[2 * N] = pow(5, i + 1);
        cost[i] = -pow(2, N - 1 - i);
    }
    program_set(&p, N, 2 * N, a, cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -pow(5, N), 1e-6);
}

/* The least cost is 0, paid by prices of (-2/35, 0): what the second one is by
   rounding pays 1e-19, which is all that there is to compare. */
static void lp_of_no_cost(void)
{
    static const double table[] = {1, 0, -0.25, -0.75, 17.5, 0,
                                   0, 1, 22.5,  -0.25, 2.25, 1};
    static const double cost[] = {0, 0, 2, 2, -1};
    program p;
    program_set(&p, 2, 5, table, cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), 0, 0);
    CHECK_NEAR(p.x[1], 1, EPS);
    CHECK_NEAR(p.y[0], -2. / 35, 4 * EPS);
}

/* Rows of coefficients, each with its right-hand side, and the least cost. */
static void lp_kinds(void)
{
    static const struct {
        int rows, cols, with_cost, want;
        double table[15], cost[4], least;
    } kind[] = {
        {2, 2, 0, KERN_LP_OPTIMAL, {1, 1, 2, 1, -1, 0}, {0}, 0},
        {4,
         2,
         1,
         KERN_LP_OPTIMAL,
         {1, 1, 2, 2, 2, 4, 1, -1, 0, 3, 1, 4},
         {1, 1},
         2}, /* redundant rows */
        {2, 2, 0, KERN_LP_INFEASIBLE, {1, 1, 2, 1, 1, 3}, {0}, 0},
        {1, 2, 1, KERN_LP_INFEASIBLE, {1, 1, -1}, {1, 1}, 0},
        {3,
         4,
         1,
         KERN_LP_OPTIMAL, /* a degenerate vertex */
         {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 1},
         {1, 2, 3, -1},
         1},
        {1, 2, 1, KERN_LP_OPTIMAL, {1, -1, 1}, {1, 1}, 1}, /* a ray */
        {1, 2, 1, KERN_LP_UNBOUNDED, {1, -1, 1}, {-1, -1}, 0},
        {1, 2, 0, KERN_LP_OPTIMAL, {1, -1, 1}, {0}, 0},
        {2, 2, 1, KERN_LP_OPTIMAL, {0}, {1, 1}, 0},
        {2, 2, 1, KERN_LP_UNBOUNDED, {0}, {-1, -1}, 0},
    };
    static const double nothing[] = {0}, something[] = {2};
    program p;
    size_t i;
    int got;
    for (i = 0; i < sizeof kind / sizeof *kind; i++) {
        sprintf(context, "(program %d)", (int)i);
        program_set(&p, kind[i].rows, kind[i].cols, kind[i].table,
                    kind[i].with_cost ? kind[i].cost : NULL);
        CHECK_INT(program_solve(&p), kind[i].want);
        if (kind[i].want == KERN_LP_OPTIMAL && kind[i].with_cost)
            CHECK_NEAR(program_cost(&p), kind[i].least, 1e3 * EPS);
    }
    context[0] = 0;
    /* no columns: solved where the right-hand side is zero, or not taken */
    program_set(&p, 1, 0, nothing, NULL);
    got = program_solve(&p);
    CHECK(got == KERN_LP_OPTIMAL || got == KERN_BAD_COUNT);
    program_set(&p, 1, 0, something, NULL);
    got = program_solve(&p);
    CHECK(got == KERN_LP_INFEASIBLE || got == KERN_BAD_COUNT);
}

static const test lp_tests[] = {
    TEST(lp_cycling),
    TEST(lp_many_pivots),
    TEST(lp_of_no_cost),
    TEST(lp_kinds),
};

#endif
