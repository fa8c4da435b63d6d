/* bases.h - random linear programs against a twin that tries all bases. */

#ifndef UNIT_BASES_H
#define UNIT_BASES_H

#include "harness.h"
#include "worlds.h"
#include "lp.h"

/* Row reduction from row `from`, column j: the largest of the column comes to
   row `from`, and the column becomes 0 in the others, or only below. Zero: the
   column has no pivot. */
static int eliminate(double *t, int rows, int cols, int from, int j, int below)
{
    const int wide_row = cols + 1;
    int i, k, pivot = from;
    for (i = from; i < rows; i++)
        if (fabs(t[i * wide_row + j]) > fabs(t[pivot * wide_row + j]))
            pivot = i;
    if (fabs(t[pivot * wide_row + j]) < 1e-9)
        return 0;
    for (k = 0; k <= cols; k++) {
        const double keep = t[pivot * wide_row + k];
        t[pivot * wide_row + k] = t[from * wide_row + k];
        t[from * wide_row + k] = keep;
    }
    for (i = below ? from + 1 : 0; i < rows; i++)
        if (i != from) {
            const double h = t[i * wide_row + j] / t[from * wide_row + j];
            for (k = 0; k <= cols; k++)
                t[i * wide_row + k] -= h * t[from * wide_row + k];
        }
    return 1;
}

/* Cost of the basic solution of the chosen columns; zero: there is none. */
static int basic_solution(int rank, int cols, const double *t,
                          const int *choice, const double *cost, double *sum)
{
    double b[(LP_ROWS + 1) * (LP_ROWS + 2)];
    int i, j, k;
    for (i = 0; i < rank; i++) {
        for (k = 0; k < rank; k++)
            b[i * (rank + 1) + k] = t[i * (cols + 1) + choice[k]];
        b[i * (rank + 1) + rank] = t[i * (cols + 1) + cols];
    }
    for (j = 0; j < rank; j++)
        if (!eliminate(b, rank, rank, j, j, 0))
            return 0;
    *sum = 0;
    for (i = 0; i < rank; i++) {
        const double x = b[i * (rank + 1) + rank] / b[i * (rank + 1) + i];
        if (!(x > -1e-9))
            return 0;
        *sum += cost[choice[i]] * x;
    }
    return 1;
}

/* The next choice of `rank` of the columns, in lexical order; zero: none. */
static int next_choice(int *choice, int rank, int cols)
{
    int i, k;
    for (i = rank - 1; i >= 0 && choice[i] == cols - rank + i; i--)
        ;
    if (i < 0)
        return 0;
    choice[i]++;
    for (k = i + 1; k < rank; k++)
        choice[k] = choice[k - 1] + 1;
    return 1;
}

/* Least cost over all basic solutions of A x = rhs, x >= 0 (columns j of
   `table`, rows x (cols + 1)), by trying every choice of independent columns.
   *found tells whether there is any. Row reduction first, so that redundant
   rows do no harm. Small whole numbers: 1e-9 is far below any true value. */
static double all_bases(int rows, int cols, const double *table,
                        const double *cost, int *found)
{
    double t[(LP_ROWS + 1) * (LP_COLS + 1)], best = 0, sum;
    int i, j, rank = 0, choice[LP_ROWS + 1];
    memcpy(t, table, sizeof *t * (size_t)(rows * (cols + 1)));
    *found = 0;
    for (j = 0; j < cols && rank < rows; j++)
        rank += eliminate(t, rows, cols, rank, j, 1);
    for (i = rank; i < rows; i++)
        if (fabs(t[i * (cols + 1) + cols]) > 1e-9)
            return 0;
    for (i = 0; i < rank; i++)
        choice[i] = i;
    do
        if (basic_solution(rank, cols, t, choice, cost, &sum)
            && (!*found || sum < best)) {
            best = sum;
            *found = 1;
        }
    while (next_choice(choice, rank, cols));
    return best;
}

/* Small whole numbers; some rows follow from others, or are degenerate. */
static void random_table(int rows, int cols, double *table)
{
    int i, j;
    for (i = 0; i < rows; i++)
        for (j = 0; j <= cols; j++)
            table[i * (cols + 1) + j] = chance(0.3) ? 0 : random_int(-4, 4);
    if (rows > 1 && chance(0.3)) /* a row that says nothing new */
        for (j = 0; j <= cols; j++)
            table[(rows - 1) * (cols + 1) + j] = 2 * table[j]
                                               - (rows > 2 ? table[cols + 1 + j]
                                                           : 0);
    if (chance(0.5)) /* degenerate */
        for (i = 0; i < rows; i++)
            table[i * (cols + 1) + cols] = chance(0.7)
                                             ? 0
                                             : table[i * (cols + 1) + cols];
}

/* Is there a ray of falling cost? It is cut at a sum of one. */
static int cost_falls(int rows, int cols, const double *table,
                      const double *cost)
{
    double ray[(LP_ROWS + 1) * (LP_COLS + 1)], down;
    int i, j, found;
    for (i = 0; i <= rows; i++)
        for (j = 0; j <= cols; j++)
            ray[i * (cols + 1) + j] = i < rows
                                        ? (j < cols ? table[i * (cols + 1) + j]
                                                    : 0)
                                        : 1;
    down = all_bases(rows + 1, cols, ray, cost, &found);
    return found && down < -1e-9;
}

static void lp_random(void)
{
    int trial, counts[3] = {0, 0, 0};
    for (trial = 0; trial < 4000; trial++) {
        double table[(LP_ROWS + 1) * (LP_COLS + 1)], cost[LP_COLS], best;
        program p;
        int rows, cols, j, found, got, want;
        random_seed(31u + (unsigned long long)trial);
        sprintf(context, "(program %d)", trial);
        rows = random_int(1, 4);
        cols = random_int(1, 8);
        random_table(rows, cols, table);
        for (j = 0; j < cols; j++)
            cost[j] = random_int(-3, 5);
        best = all_bases(rows, cols, table, cost, &found);
        want = !found                              ? KERN_LP_INFEASIBLE
             : cost_falls(rows, cols, table, cost) ? KERN_LP_UNBOUNDED
                                                   : KERN_LP_OPTIMAL;
        program_set(&p, rows, cols, table, cost);
        got = program_solve(&p);
        CHECK_INT(got, want);
        if (got == KERN_LP_OPTIMAL && want == KERN_LP_OPTIMAL)
            CHECK_NEAR(program_cost(&p), best,
                       (SINGLE ? 1e-4 : 1e-9) * (1 + fabs(best)));
        counts[want - KERN_LP_OPTIMAL]++;
        /* the same without a cost: only whether there is a solution */
        program_set(&p, rows, cols, table, NULL);
        CHECK_INT(program_solve(&p),
                  found ? KERN_LP_OPTIMAL : KERN_LP_INFEASIBLE);
    }
    context[0] = 0;
    CHECK(counts[0] > 200 && counts[1] > 200 && counts[2] > 200);
}

/* A random program that has a solution. */
static void program_random(program *p)
{
    double table[LP_ROWS * (LP_COLS + 1)], cost[LP_COLS];
    const int m = random_int(2, LP_ROWS), n = random_int(m, LP_COLS);
    int i, j;
    for (j = 0; j < n; j++)
        cost[j] = uniform(0, 1);
    for (i = 0; i < m; i++) {
        double *row = table + i * (n + 1);
        row[n] = 0;
        for (j = 0; j < n; j++) {
            row[j] = uniform(-1, 1);
            row[n] += j % 3 ? 0 : row[j]; /* 1 in every third one */
        }
    }
    program_set(p, m, n, table, cost);
}

/* The same program with rows and columns in other units. */
static void program_scaled(program *t, const program *p)
{
    const double most = SINGLE ? 2 : 6;
    int i, j;
    *t = *p;
    t->lp.a = t->a;
    t->lp.rhs = t->rhs;
    t->lp.cost = t->cost;
    for (i = 0; i < p->lp.rows; i++) {
        const double unit = pow(10, uniform(-most, most));
        t->rhs[i] *= R(unit);
        for (j = 0; j < p->lp.cols; j++)
            t->a[j * p->lp.rows + i] *= R(unit);
    }
    for (j = 0; j < p->lp.cols; j++) {
        const double unit = pow(10, uniform(-most, most));
        t->cost[j] *= R(unit);
        for (i = 0; i < p->lp.rows; i++)
            t->a[j * p->lp.rows + i] *= R(unit);
    }
}

/* Units do not matter: with rows and columns in other ones an answer is the
   same, or there is none. */
static void lp_scaled(void)
{
    static kern_real real[KERN_LP_REALS(LP_ROWS, LP_COLS)];
    static int index[KERN_LP_INTS(LP_ROWS, LP_COLS)];
    program p, t;
    int k, j, answers = 0;
    for (k = 0; k < 400; k++) {
        kern_work work = kern_work_of(real, KERN_LP_REALS(LP_ROWS, LP_COLS),
                                      index, KERN_LP_INTS(LP_ROWS, LP_COLS));
        double primal = 0;
        int got;
        random_seed(31000u + (unsigned long long)k);
        program_random(&p);
        if (program_solve(&p) != KERN_LP_OPTIMAL)
            continue;
        program_scaled(&t, &p);
        got = kern_lp_solve(&t.lp, t.x, t.y, &work);
        if (got < 0)
            continue;
        answers++;
        CHECK_INT(got, KERN_LP_OPTIMAL);
        for (j = 0; j < t.lp.cols; j++)
            primal += (double)t.cost[j] * (double)t.x[j];
        CHECK_NEAR(primal, program_cost(&p),
                   (SINGLE ? 1e-2 : 1e-6) * (1 + program_cost(&p)));
    }
    CHECK(answers > 20);
}

/* A variable that is rounding beside another is kept where a row needs it. */
static void lp_small_beside_large(void)
{
    const double unit = SINGLE ? 1e2 : 1e6;
    const double rows[] = {1 / unit, 0, 1e3, 0, unit, 1};
    program p;
    program_set(&p, 2, 2, rows, NULL);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(p.x[0], 1e3 * unit, 1e3 * unit * 8 * EPS);
    CHECK_NEAR(p.x[1], 1 / unit, 8 * EPS / unit);
}

/* Rows that differ by 1e-10 have no common solution; a ray along which the
   cost falls is found. */
static void lp_small_rows_and_rays(void)
{
    static const double rows[] = {1, 1, 1e-10, 2e-10};
    static const double free_ray[] = {
        1, 0, 0, -1, -1, 1, 1,  1, 0, -1, 1, 0,  1, 0,  0,  -1, 1,  1,  0,
        0, 0, 0, 0,  -1, 1, 0,  1, 0, 0,  0, -1, 0, 1,  -1, -1, -1, -1, 1,
        1, 1, 0, 0,  -1, 0, -1, 0, 0, 1,  1, 1,  1, -1, 1,  1,  -1, 0};
    static const double free_cost[] = {-2, 3,  -2, 5,  4,  -2, 3,
                                       2,  -1, 1,  -1, -2, -2};
    program p;
    program_set(&p, 2, 1, rows, NULL);
    CHECK(program_solve(&p) != KERN_LP_OPTIMAL);
    program_set(&p, 4, 13, free_ray, free_cost);
    CHECK_INT(program_solve(&p), KERN_LP_UNBOUNDED);
}

static const double small_program[] = {1, 1, 2, 1, -1, 0};
static const double small_cost[] = {1, 1};

static void lp_bad_input(void)
{
    static kern_real real[KERN_LP_REALS(2, 2)];
    static int index[KERN_LP_INTS(2, 2)];
    kern_work work = kern_work_of(real, KERN_LP_REALS(2, 2), index,
                                  KERN_LP_INTS(2, 2));
    program p;
    int i, j;
    for (i = 0; i < 4 + 2 + 2; i++)
        for (j = 0; j < 2; j++) {
            program_set(&p, 2, 2, small_program, small_cost);
            *(i < 4   ? &p.a[i]
              : i < 6 ? &p.rhs[i - 4]
                      : &p.cost[i - 6]) = R(no_number(j));
            CHECK_INT(program_solve(&p), KERN_BAD_NUMBER);
        }
    for (i = 0; i < 4; i++) {
        program_set(&p, 2, 2, small_program, small_cost);
        p.lp.rows = i == 0 ? -1 : 2;
        p.lp.cols = i == 1 ? -1 : 2;
        p.lp.a = i == 2 ? NULL : p.a;
        p.lp.rhs = i == 3 ? NULL : p.rhs;
        CHECK_INT(program_solve(&p), i < 2 ? KERN_BAD_COUNT : KERN_BAD_POINTER);
    }
    program_set(&p, 2, 2, small_program, small_cost);
    CHECK_INT(kern_lp_solve(NULL, p.x, p.y, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, NULL, p.y, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, p.x, NULL, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, p.x, p.y, NULL), KERN_BAD_POINTER);
}

/* Every size of the work arrays; what lies behind them stays as it was. */
static void lp_every_size(void)
{
    enum { REALS = KERN_LP_REALS(2, 2), INTS = KERN_LP_INTS(2, 2) };
    static kern_real real[REALS + GUARD];
    static int index[INTS + GUARD];
    program p;
    int array, size, enough = 0;
    program_set(&p, 2, 2, small_program, small_cost);
    for (array = 0; array < 2; array++) {
        const int need = array ? INTS : REALS;
        for (size = 0; size <= need; size++) {
            kern_work work = kern_work_of(real, array ? REALS : size, index,
                                          array ? size : INTS);
            int got;
            guard_fill(real, REALS, index, INTS);
            got = kern_lp_solve(&p.lp, p.x, p.y, &work);
            CHECK(got == KERN_NO_SPACE || got == KERN_LP_OPTIMAL);
            enough += got == KERN_LP_OPTIMAL;
            if (size == need)
                CHECK_INT(got, KERN_LP_OPTIMAL);
            if (size == 0)
                CHECK_INT(got, KERN_NO_SPACE);
            CHECK(guard_holds(&work, REALS, INTS));
        }
    }
    CHECK(enough >= 2);
}

static const test bases_tests[] = {
    TEST(lp_random),
    TEST(lp_scaled),
    TEST(lp_small_beside_large),
    TEST(lp_small_rows_and_rays),
    TEST(lp_bad_input),
    TEST(lp_every_size),
};

#endif
