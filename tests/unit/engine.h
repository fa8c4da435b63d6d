/* engine.h - the engine, part by part: one row, one factor, one group, one
   basis. */

#ifndef UNIT_ENGINE_H
#define UNIT_ENGINE_H

#include "harness.h"
#include "worlds.h"

/* Each tool of the engine by itself: what no answer shows, since every answer is
   proven and a tool that is wrong only costs time. Private parts of kern.h that
   are called here:

     rows     kern_row_of, kern_row_speed, kern_row_exert
     laws     kern_law_stiff
     factor   kern_take_open, kern_skyline_open, _clear, _law,
              _shift, _factor, _solve
     group    kern_pass_solve
     basis    kern_simplex_lay, kern_program_solve, kern_basis_solve
     step     kern_call_open, kern_ipm_open, kern_ipm_begin, kern_ipm_step
     bracket  kern_path_evaluate, kern_path_critical

   With tests/audit.h included first, the state of an engine is checked wherever
   a test of this room uses it: see there. */

enum { ENGINE_GROUPS = 9, ENGINE_TIES = 24, ENGINE_ROWS = 9, ENGINE_COLS = 14 };

static kern_row engine_row(kern_vec n)
{
    return kern_row_of(n, vec(uniform(-2, 2), uniform(-2, 2)),
                       R(uniform(0.5, 2)));
}

static kern_vec engine_normal(void)
{
    const double angle = uniform(0, 2 * pi);
    return vec(cos(angle), sin(angle));
}

/* The power of a force is the same seen from the contact and from the block. */
static void engine_rows(void)
{
    const kern_real up[3] = {0, R(2), R(3)};
    kern_real w[2] = {0, 0}, b[3] = {0, 0, 0};
    kern_row row = kern_row_of(vec(0, 1), vec(0.5, -1), R(2));
    int i;
    kern_row_speed(&row, up, w); /* 2 + 3 * 2 * .5 up; t is to the left */
    CHECK_NEAR(w[0], 5, 8 * EPS);
    CHECK_NEAR(w[1], -6, 8 * EPS);
    kern_row_exert(&row, R(4), R(1), b);
    CHECK_NEAR(b[0], -1, 8 * EPS);
    CHECK_NEAR(b[1], 4, 8 * EPS);
    CHECK_NEAR(b[2], 4 * 2 * 0.5 - 2, 8 * EPS);
    for (i = 0; i < 1000; i++) {
        const kern_real f = R(uniform(0, 5)), r = R(uniform(-2, 2));
        const kern_real v[3] = {R(uniform(-1, 1)), R(uniform(-1, 1)),
                                R(uniform(-1, 1))};
        row = engine_row(engine_normal());
        w[0] = w[1] = b[0] = b[1] = b[2] = 0;
        kern_row_speed(&row, v, w);
        kern_row_exert(&row, f, r, b);
        CHECK_NEAR(f * w[0] + r * w[1], b[0] * v[0] + b[1] * v[1] + b[2] * v[2],
                   100 * EPS);
    }
}

/* The law of minimum-norm forces: of rays of stiffness 1 that only press. */
static kern_law engine_pressed(kern_real wn, kern_real wt, kern_real mu)
{
    return kern_law_stiff(wn, wt, mu, R(2), mu);
}

/* Whatever the motion, a force lies in its cone, is what the law says of the
   motion, and never helps it. */
static void engine_law(kern_law s, double wn, double wt, double mu)
{
    const double f = s.force.normal, r = s.force.tangential;
    const double tol = 1e4 * EPS * (1 + fabs(wn) + fabs(wt));
    CHECK(f >= 0 && fabs(r) <= mu * f * (1 + 4 * EPS));
    CHECK_NEAR(f, s.nn * wn + s.nt * wt, tol);
    CHECK_NEAR(r, s.nt * wn + s.tt * wt, tol);
    CHECK(f * wn + r * wt >= -tol);
    CHECK(s.nn >= 0 && s.tt >= 0 && s.nn * s.tt >= s.nt * s.nt - tol);
}

static void engine_laws(void)
{
    int i;
    kern_law s = engine_pressed(R(1), 0, R(0.5));
    CHECK_NEAR(s.force.normal, 2, 8 * EPS); /* both rays press by 1 */
    CHECK_NEAR(s.force.tangential, 0, 8 * EPS);
    s = engine_pressed(R(1), R(4), R(0.5)); /* one by 3 */
    CHECK_NEAR(s.force.normal, 3, 8 * EPS);
    CHECK_NEAR(s.force.tangential, 1.5, 8 * EPS);
    s = kern_law_stiff(R(2), 0, R(0.5), R(3), 1 / KERN_STICKS);
    CHECK_NEAR(s.force.normal, 6, 16 * EPS);
    s = kern_law_stiff(R(-2), R(1), R(0.5), R(3), 1 / KERN_STICKS); /* parts */
    CHECK_NEAR(s.force.normal, 0, 0);
    for (i = 0; i < 2000; i++) {
        const double wn = uniform(-1, 1), mu = uniform(0.05, 1);
        const double wt = uniform(-1, 1) * (i % 2 ? 1 : 1e-3);
        engine_law(engine_pressed(R(wn), R(wt), R(mu)), wn, wt, mu);
        engine_law(kern_law_stiff(R(wn), R(wt), R(mu), R(2), 1 / KERN_STICKS),
                   wn, wt, mu);
    }
}

/* Groups tied to each other, and some to the ground, by contacts of a law. */
typedef struct ties {
    int groups, count;
    int ends[2 * ENGINE_TIES];
    kern_row row[2 * ENGINE_TIES];
    kern_law law[ENGINE_TIES];
    kern_skyline a;
    kern_real real[ENGINE_GROUPS * ENGINE_GROUPS * 9];
    int index[4 * ENGINE_GROUPS];
} ties;

static void ties_open(ties *t)
{
    kern_take take;
    const kern_work work = kern_work_of(t->real, COUNT_OF(t->real), t->index,
                                        COUNT_OF(t->index));
    int k;
    t->groups = random_int(1, ENGINE_GROUPS);
    t->count = random_int(t->groups, ENGINE_TIES);
    kern_take_open(&take, &work);
    for (k = 0; k < t->count; k++) {
        const kern_vec n = engine_normal();
        t->ends[2 * k] = random_int(0, t->groups - 1);
        do /* t->groups: the ground */
            t->ends[2 * k + 1] = random_int(0, t->groups);
        while (t->ends[2 * k + 1] == t->ends[2 * k]);
        t->row[2 * k] = engine_row(n);
        t->row[2 * k + 1] = engine_row(vec(-n.x, -n.y));
        t->law[k] = engine_pressed(R(1), R(uniform(-3, 3)), R(0.6));
    }
    CHECK(kern_skyline_open(&t->a, t->groups, t->ends, t->count, &take) > 0);
    CHECK(kern_take_fits(&take));
    kern_skyline_clear(&t->a);
    for (k = 0; k < t->count; k++)
        kern_skyline_law(&t->a, t->ends + 2 * k, t->row + 2 * k, &t->law[k]);
    kern_skyline_shift(&t->a, R(1e-3)); /* what hangs loose has a matrix, too */
}

/* out := the matrix times v, contact by contact, without the shift. */
static void ties_times(const ties *t, const kern_real *v, kern_real *out)
{
    int k, e, i;
    for (i = 0; i < 3 * t->groups + 3; i++)
        out[i] = 0;
    for (k = 0; k < t->count; k++) {
        const kern_law *s = &t->law[k];
        kern_real w[2] = {0, 0};
        for (e = 0; e < 2; e++)
            kern_row_speed(&t->row[2 * k + e], v + 3 * t->ends[2 * k + e], w);
        for (e = 0; e < 2; e++)
            kern_row_exert(&t->row[2 * k + e], s->nn * w[0] + s->nt * w[1],
                           s->nt * w[0] + s->tt * w[1],
                           out + 3 * t->ends[2 * k + e]);
    }
}

/* What the shift adds to the diagonal: a share of its mean. */
static double ties_shift(const ties *t)
{
    kern_real v[3 * ENGINE_GROUPS + 3], out[3 * ENGINE_GROUPS + 3];
    double trace = 0;
    int i, k;
    for (i = 0; i < 3 * t->groups; i++) {
        for (k = 0; k < 3 * t->groups + 3; k++)
            v[k] = R(k == i);
        ties_times(t, v, out);
        trace += (double)out[i];
    }
    return 1e-3 * trace / (3 * t->groups);
}

/* L L' v = M v, M from the contacts one by one, and M times the solution is
   what was asked for. */
static void engine_factor(void)
{
    static ties t;
    kern_real v[3 * ENGINE_GROUPS + 3], b[3 * ENGINE_GROUPS + 3],
        x[3 * ENGINE_GROUPS + 3];
    int round, i;
    random_seed(77);
    for (round = 0; round < some(400); round++) {
        double shift, size = 0;
        ties_open(&t);
        shift = ties_shift(&t);
        for (i = 0; i < 3 * t.groups + 3; i++)
            v[i] = i < 3 * t.groups ? R(uniform(-1, 1)) : 0;
        ties_times(&t, v, b);
        for (i = 0; i < 3 * t.groups; i++) {
            b[i] += R(shift) * v[i];
            size = fmax(size, fabs((double)b[i]));
        }
        kern_skyline_factor(&t.a);
        kern_skyline_solve(&t.a, b, x);
        for (i = 0; i < 3 * t.groups; i++)
            CHECK_NEAR(x[i], v[i], (SINGLE ? 0.1 : 1e-9) * (1 + size));
    }
}

/* A box on two points at -1 and 1, loaded at x: the forces are (1 -+ x) / 2,
   whatever their units; beyond the points none hold it. */
static void engine_group_on(double x)
{
    const kern_real b[3] = {0, R(1), R(x)}, rests[2] = {0, 0};
    kern_ray c[4];
    kern_status got;
    int k;
    for (k = 0; k < 2; k++) {
        const kern_row row = kern_row_of(vec(0, 1), vec(k ? 1 : -1, -0.5),
                                         R(1));
        kern_ray_pair(c + 2 * k, &row, R(0.4), rests, R(k ? 0.1 : 1));
    }
    got = kern_pass_solve(c, 4, b, R(SINGLE ? 1e-6 : 1e-11));
    CHECK_INT(got, fabs(x) <= 1 ? KERN_STANDS : KERN_FALLS);
    for (k = 0; k < 2 && got == KERN_STANDS; k++) {
        const double unit = k ? 0.1 : 1;
        const double plus = unit * fmax(c[2 * k].x, 0);
        const double minus = unit * fmax(c[2 * k + 1].x, 0);
        CHECK_NEAR(plus + minus, (1 + (k ? x : -x)) / 2, 1e4 * EPS);
        CHECK_NEAR(plus, minus, 1e4 * EPS);
    }
}

static void engine_group(void)
{
    static const double at[] = {0, 0.25, -0.7, 0.99, 1.01, -3};
    int i;
    for (i = 0; i < COUNT_OF(at); i++)
        engine_group_on(at[i]);
}

/* Running bond of square bricks, closed joints: a bed takes the load of a brick,
   the joint beside it does not push the next one, so that every brick is
   balanced alone and once, whatever the side that numbers begin at. */
static void engine_bond(void)
{
    static world w;
    const int side = 11, courses = 13;
    kern_work work;
    int mirror, row, i;
    for (mirror = -1; mirror <= 1; mirror += 2) {
        world_reset(&w);
        w.options.mu = R(0.6);
        world_box(&w, 0, -20, -1, 20, 0);
        for (row = 0; row < courses; row++)
            for (i = 0; i < side + row % 2; i++) {
                const double left = fmax(i - 0.5 * (row % 2), 0);
                const double right = fmin(i + 1 - 0.5 * (row % 2), side);
                world_box(&w, 1, mirror < 0 ? -right : left, row,
                          mirror < 0 ? -left : right, row + 1);
            }
        world_touch(&w);
        CHECK(w.blocks == 150);
        work = work_of(&w);
        CHECK_INT(kern_verdict(world_task(&w, &work), 0, NULL), KERN_STANDS);
        CHECK(work.units <= 3 * w.blocks);
    }
}

/* The basis in which a program ends: header and places are inverse to each
   other, B x = b, and every column of B solves to a unit vector. */
static void engine_basis_holds(const kern_simplex *sx, const kern_real *a,
                               const kern_real *rhs)
{
    const int rows = sx->lp->rows, cols = sx->lp->cols;
    double left[ENGINE_ROWS];
    int p, i;
    for (i = 0; i < rows; i++)
        left[i] = (double)rhs[i];
    for (p = 0; p < rows; p++) {
        const int j = sx->base[p];
        kern_real v[ENGINE_ROWS + 3] = {0};
        for (i = 0; i < rows; i++) {
            v[i] = j < cols ? a[j * rows + i] : R(i == j - cols - 1);
            left[i] -= (double)(v[i] * sx->value[p]);
        }
        CHECK(j >= cols || sx->basic_row[j] == p);
        kern_basis_solve(sx, v);
        for (i = 0; i < rows; i++)
            CHECK_NEAR(v[i], i == p, SINGLE ? 1e-2 : 1e-8);
    }
    for (i = 0; i < rows; i++)
        CHECK_NEAR(left[i], 0, SINGLE ? 1e-3 : 1e-9);
}

static void engine_basis(void)
{
    static kern_real real[4000], a[ENGINE_ROWS * ENGINE_COLS];
    static int index[2000];
    int round, i;
    random_seed(78);
    for (round = 0; round < some(300); round++) {
        kern_real rhs[ENGINE_ROWS], x[ENGINE_COLS], y[ENGINE_ROWS + 3];
        kern_work work = kern_work_of(real, 4000, index, 2000);
        kern_simplex sx;
        kern_program lp;
        kern_take take;
        kern_status got;
        memset(&lp, 0, sizeof lp);
        lp.rows = random_int(1, ENGINE_ROWS);
        lp.cols = random_int(lp.rows, ENGINE_COLS);
        lp.a = a;
        lp.rhs = rhs;
        lp.work = &work;
        for (i = 0; i < lp.rows * lp.cols; i++)
            a[i] = chance(0.3) ? 0 : R(uniform(-1, 1));
        for (i = 0; i < lp.rows; i++)
            rhs[i] = R(uniform(-1, 1));
        kern_take_open(&take, &work);
        kern_simplex_lay(&sx, &lp, 100, &take);
        CHECK(kern_take_fits(&take));
        got = kern_program_solve(&sx, 1, x, y);
        CHECK(got == KERN_LP_OPTIMAL || got == KERN_LP_INFEASIBLE);
        engine_basis_holds(&sx, a, rhs);
    }
}

/* The place of a program: x = rhs - s rate stays above 0 up to s = 4 / 1.5, and
   without the second row for ever; held beyond that it is infeasible. */
static void engine_place(void)
{
    static const kern_real a[4] = {1, 0, 0, 1};
    static kern_real real[400];
    static int index[400];
    kern_real rhs[2] = {1, 4}, rate[2] = {R(-0.5), R(1.5)};
    kern_real x[3], y[2];
    kern_work work = kern_work_of(real, 400, index, 400);
    kern_simplex sx;
    kern_program lp;
    kern_take take;
    memset(&lp, 0, sizeof lp);
    lp.rows = lp.cols = 2;
    lp.a = a;
    lp.rhs = rhs;
    lp.rate = rate;
    lp.work = &work;
    lp.follow = 1;
    kern_take_open(&take, &work);
    kern_simplex_lay(&sx, &lp, 20, &take);
    CHECK(kern_take_fits(&take));
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_OPTIMAL);
    CHECK_NEAR(x[2], 4 / 1.5, 8 * EPS);
    CHECK_NEAR(x[0], 1 + 2 / 1.5, 8 * EPS);
    lp.follow = 0;
    rhs[0] = R(2.5);
    rhs[1] = R(-0.5);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_INFEASIBLE);
    CHECK(y[0] >= 0 && y[1] > 0);
    rhs[0] = R(2.0);
    rhs[1] = R(1.0);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_OPTIMAL);
    CHECK_NEAR(x[1], 1, 8 * EPS);
    lp.rows = lp.cols = 1;
    lp.follow = 1;
    kern_simplex_change(&sx, KERN_BASIS_NONE);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_UNBOUNDED);
}

#ifndef KERN_NO_INTERIOR
/* With forces and speeds above 0 in each interior point, and a gap that goes to
   0, s gets to 0 where the stack stands, and where it falls to y.b, less. */
static void engine_step(void)
{
    static world w;
    int falls, round, i;
    stack_of_two(&w, 0.25);
    for (falls = 0; falls < 2; falls++) {
        const double least = SINGLE ? 1e-4 : 1e-9;
        kern_work work = work_of(&w);
        kern_call c;
        kern_ipm in;
        CHECK_INT(
            kern_call_open(&c, world_task(&w, &work), R(0.2 + 0.1 * falls), &w),
            KERN_OK);
        CHECK(kern_ipm_open(&in, &c.m, &c.part, &c.path.q));
        kern_part_load(in.part, &c.path.q, in.part->eq.rhs);
        CHECK(kern_ipm_begin(&in));
        for (round = 0; round < 25 && in.duality_gap > least && in.s < 0;
             round++) {
            const double before = (double)in.duality_gap;
            CHECK(kern_ipm_step(&in));
            CHECK(in.duality_gap < 2 * before && in.s <= 0);
            for (i = 0; i < 2 * in.part->contacts; i++)
                CHECK(in.part->x[i] > 0 && in.z[i] > 0);
        }
        CHECK(round >= (falls ? 3 : 1) && round < 25);
        if (falls) {
            CHECK(in.s < -1e-3);
            CHECK_NEAR(
                in.s,
                kern_dot(in.part->y, in.part->eq.rhs, 3 * in.part->groups),
                10 * least);
        } else
            CHECK(in.s >= 0);
    }
}
#endif

/* A bracket around it is narrowed to the tolerance, and both its ends are what
   verdicts from nothing say. */
static void engine_bracket(void)
{
    static const double off[] = {0.05, 0.1, 0.25, 0.3, 0.4};
    static world w;
    int i;
    for (i = 0; i < COUNT_OF(off); i++) {
        const double edge = 0.5 - off[i];
        kern_work work;
        kern_call c;
        kern_path *path = &c.path;
        stack_of_two(&w, off[i]);
        work = work_of(&w);
        CHECK_INT(kern_call_open(&c, world_task(&w, &work), 0, &w), KERN_OK);
        path->end = R(edge * 1.04); /* within half of the joint */
        CHECK_INT(kern_path_evaluate(&c.m, path, 0), KERN_STANDS);
        CHECK_INT(kern_path_evaluate(&c.m, path, path->end), KERN_FALLS);
        CHECK(kern_path_critical(&c.m, path) >= 0);
        CHECK_NEAR(path->critical, edge, EXACT);
        CHECK(path->holds <= path->critical && path->critical <= path->fails);
        CHECK(path->fails - path->holds <= kern_width(path) * R(1.01));
        CHECK_INT(kern_verdict(world_task(&w, &work), path->holds, NULL),
                  KERN_STANDS);
        CHECK_INT(kern_verdict(world_task(&w, &work), path->fails, NULL),
                  KERN_FALLS);
    }
}

static const test engine_tests[] = {
    TEST(engine_rows),    TEST(engine_laws), TEST(engine_factor),
    TEST(engine_group),   TEST(engine_bond), TEST(engine_basis),
    TEST(engine_place),
#ifndef KERN_NO_INTERIOR
    TEST(engine_step),
#endif
    TEST(engine_bracket),
};

#endif
