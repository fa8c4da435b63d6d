/* raised.h - raised forces and loads; which blocks stay. */

#ifndef UNIT_RAISED_H
#define UNIT_RAISED_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"
#include "plan.h"
#include "known.h"

/* The verdict of kern_raised(), or a status; its proof is checked, and that
   nothing else passes for it. */
static int raised(const world *w, kern_real *reserve)
{
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    kern_proof proof = proof_here();
    kern_raising got = KERN_NOT_SHOWN;
    kern_real error;
    const int status = kern_raised(task, 0, &got, reserve, &proof);
    int i;
    if (status != KERN_STANDS)
        return -10 - status;
    error = kern_check_raised(task, 0, got, &proof);
    CHECK((error <= 1) == (got != KERN_NOT_SHOWN));
    CHECK(kern_check_forces(task, 0, proof.force) <= 1 || got == KERN_HANGS);
    if (got == KERN_NOT_SHOWN)
        return got;
    CHECK(!(kern_check_raised(
                task, 0, got == KERN_RAISED ? KERN_HANGS : KERN_RAISED, &proof)
            <= 1));
    for (i = 0; i < w->blocks && got == KERN_RAISED; i++) {
        motion_of[i].vx *= -1;
        motion_of[i].vy *= -1;
        motion_of[i].spin *= -1;
    }
    for (i = 0; i < w->blocks && got == KERN_HANGS; i++)
        motion_of[i].vy = -1;
    CHECK(!(kern_check_raised(task, 0, got, &proof) <= 1));
    return got;
}

/* A block of height 1 and width 1 at its foot between two walls that lean out
   by these angles, in degrees. */
static void between_walls(world *w, double left, double right, double mu)
{
    const double l = tan(left * pi / 180), r = tan(right * pi / 180);
    const double block[] = {0, 0, 1, 0, 1 + r, 1, -l, 1};
    const double west[] = {-5, 0, 0, 0, -l, 1, -5, 1};
    const double east[] = {1, 0, 6, 0, 6, 1, 1 + r, 1};
    world_reset(w);
    w->options.mu = R(mu);
    world_polygon(w, 1, block, 4);
    world_polygon(w, 0, west, 4);
    world_polygon(w, 0, east, 4);
    world_touch(w);
}

static void jack_arch(world *w)
{
    const double west[] = {-6, 0, -1.5, 0, -2, 1, -6, 1};
    const double east[] = {1.5, 0, 6, 0, 6, 1, 2, 1};
    int i;
    world_reset(w);
    w->options.mu = R(0.5);
    for (i = 0; i < 5; i++) {
        const double a = 0.2 * i - 0.5, b = a + 0.2;
        const double xy[] = {3 * a, 0, 3 * b, 0, 4 * b, 1, 4 * a, 1};
        world_polygon(w, 1, xy, 4);
    }
    world_polygon(w, 0, west, 4);
    world_polygon(w, 0, east, 4);
    world_touch(w);
}

static void corbel(world *w)
{
    int i;
    world_reset(w);
    world_box(w, 0, -3, -1, 0, 0);
    for (i = 0; i < 4; i++)
        world_box(w, 1, 0.25 * i - 1.25, 0.4 * i, 0.25 * (i + 1),
                  0.4 * (i + 1));
    world_box(w, 1, -0.5, 1.6, 0.5, 2.6);
    world_touch(w);
}

static void leaning_plank(world *w)
{
    const double c = cos(70 * pi / 180), s = sin(70 * pi / 180);
    const double x = 2 * c, thick = 0.05;
    const double xy[] = {
        x, 0, x + thick * s, thick * c, thick * s, thick * c + 2 * s, 0, 2 * s};
    world_reset(w);
    w->options.mu = R(0.5);
    world_box(w, 0, -1, -1, 4, 0);
    world_box(w, 0, -1, 0, 0, 4);
    world_polygon(w, 1, xy, 4);
    world_touch(w);
}

static void stone_between_leaning(world *w)
{
    const double t = tan(10 * pi / 180), y = 0.4, z = 0.7;
    const double west[] = {-2, 0, -1, 0, -1 + t, 1, -2 + t, 1};
    const double east[] = {1, 0, 2, 0, 2 - t, 1, 1 - t, 1};
    const double stone[] = {-1 + t * y, y, 1 - t * y,  y,
                            1 - t * z,  z, -1 + t * z, z};
    world_reset(w);
    w->options.mu = R(0.6);
    world_box(w, 0, -4, -1, 4, 0);
    world_polygon(w, 1, west, 4);
    world_polygon(w, 1, east, 4);
    world_polygon(w, 1, stone, 4);
    world_touch(w);
}

/* A stone between upright walls, in a drawing that is turned and has the digits
   of a file: its joints open or close by 1e-6 and still hold nothing up. */
static void upright_walls_turned(world *w)
{
    static const double square[3][4] = {
        {0, 0, 1, 1}, {-5, -2, 0, 1}, {1, -2, 6, 1}};
    int turn, i, k;
    for (turn = 0; turn < 12; turn++) {
        const double c = cos(0.5 * turn), s = sin(0.5 * turn), digit = 1e-6;
        world_reset(w);
        w->gravity = vec(10 * s, -10 * c);
        for (i = 0; i < 3; i++) {
            const double *box = square[i];
            double corner[8];
            for (k = 0; k < 4; k++) {
                const double x = box[k == 1 || k == 2 ? 2 : 0];
                const double y = box[k > 1 ? 3 : 1];
                corner[2 * k] = floor((c * x - s * y) / digit) * digit;
                corner[2 * k + 1] = floor((s * x + c * y) / digit) * digit;
            }
            world_polygon(w, i == 0, corner, 4);
        }
        world_touch(w);
        sprintf(context, "upright walls turned by %g", 0.5 * turn);
        CHECK_INT(raised(w, NULL), KERN_HANGS);
    }
    context[0] = 0;
}

static void raised_by_hand(void)
{
    static const struct {
        double left, right, mu;
        int want;
    } walls[] = {{0, 0, 0.4, KERN_HANGS},    {5, 5, 0.4, KERN_RAISED},
                 {-5, -5, 0.4, KERN_HANGS},  {10, 10, 0.4, KERN_RAISED},
                 {30, 30, 0.4, KERN_RAISED}, {30, 30, 0.8, KERN_RAISED},
                 {60, 60, 0.2, KERN_RAISED}, {0, 20, 0.4, KERN_RAISED},
                 {-10, 20, 0.4, KERN_RAISED}};
    static world w;
    kern_real reserve;
    size_t i;
    for (i = 0; i < sizeof walls / sizeof *walls; i++) {
        sprintf(context, "walls %g %g", walls[i].left, walls[i].right);
        between_walls(&w, walls[i].left, walls[i].right, walls[i].mu);
        CHECK_INT(raised(&w, NULL), walls[i].want);
    }
    context[0] = 0;
    upright_walls_turned(&w);
    between_walls(&w, 0, 0, 0.4);
    world_box(&w, 0, -1, -1, 2, 0);
    world_touch(&w);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT); /* the walls hold it */
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    world_box(&w, 0, 2, 0, 3, 1);
    world_touch(&w);
    CHECK_INT(raised(&w, &reserve), KERN_HANGS);
    CHECK_NEAR(reserve, 0, 0);
    jack_arch(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    corbel(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    leaning_plank(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    stone_between_leaning(&w);
    CHECK_INT(raised(&w, NULL), KERN_HANGS);
}

/* A cube on a slope of .1 slides down with a push of more than about .3 g, one
   on a slope of .395 with one of .0043 g: (.395 + x) / (1 - .395 x) = .4. */
static void raised_reserve(void)
{
    static world w;
    kern_real reserve;
    one_cube(&w);
    w.gravity = vec(9.81 * 0.1, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT);
    w.gravity = vec(9.81 * 0.395, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.004, EXACT);
    w.options.reserve = R(0.0055); /* no more is asked for */
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.004, EXACT);
    w.gravity = vec(9.81 * 0.1, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.0055, EXACT);
    w.options.reserve = R(0.2);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_BAD_OPTION);
    w.options.reserve = R(0);
    w.gravity = vec(9.81 * 0.405, -9.81);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_FALLS);
    w.gravity = vec(0, 0);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_NO_LOAD);
    CHECK_INT(raised(&w, NULL), -10 - KERN_NO_LOAD);
}

/* Whatever stands is shown to be raised or not, with proofs that hold; the
   reserve is no more than the load factor. */
static void raised_random(void)
{
    static world w;
    int seed, stood = 0, shown = 0;
    for (seed = 1; seed <= 400; seed++) {
        kern_real reserve = R(-1);
        int got, side;
        if (!random_world(&w, (unsigned long long)seed, 12))
            continue;
        sprintf(context, "seed %d", seed);
        got = raised(&w, &reserve);
        if (got < 0) {
            CHECK(decided(-10 - got) && verdict(&w, 0) != KERN_STANDS);
            continue;
        }
        stood++;
        shown += got == KERN_RAISED;
        for (side = -1; side <= 1 && got == KERN_RAISED; side += 2) {
            double factor = 0;
            if (load_factor(&w, NULL, side, &factor) == KERN_STANDS)
                CHECK(reserve <= R(factor) + EDGE);
        }
    }
    context[0] = 0;
    CHECK(stood > 100 && shown > stood / 2);
}

/* kern_stays() of a block, or -10 less what it returns. Of the last block a
   plan says the same that does not have it yet, and that has it. */
static double stays(const world *w, int i)
{
    static site p;
    kern_work work = work_of(w);
    kern_real got = R(-1), with = R(-1), has = R(-1);
    const kern_status status = kern_stays(world_task(w, &work), i, &got);
    CHECK((got >= 0 && got <= 1) == (status == KERN_STANDS));
    CHECK(got >= 0 || got <= -1);
    if (i == w->blocks - 1 && !w->given) {
        site_with(&p, w, i);
        CHECK_INT(kern_plan_stays(&p.plan, &w->block[i], &with), status);
        CHECK_INT(p.plan.task.s.blocks, i);
        site_add(&p, i);
        CHECK_INT(kern_plan_stays(&p.plan, NULL, &has), status);
        CHECK(memcmp(&with, &has, sizeof has) == 0);
        CHECK_NEAR(with, got, EXACT);
    }
    return status == KERN_STANDS ? (double)got : -10 - status;
}

/* n cubes have a reserve of .1 and more; the bed of each has two points, of the
   stiffness .1 + .5, so that the top one sinks by (1 + ... + n) / 1.2. What is
   more than four contacts away is held: it neither sinks nor weighs. */
static void stays_law(void)
{
    static world w;
    double last = 1, shift;
    int n, k;
    for (n = 1; n <= 8; n++)
        for (k = 1; k <= n; k++) {
            const int top = k + 4 < n ? k + 4 : n;
            double down = 0, q, chance;
            int i;
            for (i = k > 4 ? k - 4 : 1; i <= k; i++) /* what bed i carries */
                down += (top - i + 1) / 1.2;
            q = 5.5e7 * 0.014 * 0.014 * 0.014 / (down < 1 ? 1 : down);
            chance = 0.05 + 0.95 * q * q / (1 + q * q);
            world_reset(&w);
            world_box(&w, 0, -5, -1, 5, 0);
            for (i = 0; i < n; i++)
                world_box(&w, 1, 0, i, 1, i + 1);
            world_touch(&w);
            CHECK_NEAR(stays(&w, k), chance, 100 * PROOF_TOL);
        }
    for (shift = 0; shift < 0.499; shift += 0.02) { /* nearer to its edge */
        shifted_cube(&w, shift);
        CHECK(stays(&w, 1) <= last);
        last = stays(&w, 1);
    }
    shifted_cube(&w, 0.4999);
    CHECK(stays(&w, 1) < 0.5 && last > 0.98);
    shifted_cube(&w, 0.51);
    CHECK_INT((int)stays(&w, 1), -10 - KERN_FALLS);
    CHECK_INT((int)stays(&w, 0), -10 - KERN_BAD_BLOCK);
    CHECK_INT((int)stays(&w, 2), -10 - KERN_BAD_BLOCK);
    CHECK_INT((int)stays(&w, -1), -10 - KERN_BAD_BLOCK);
    w.gravity = vec(0, 0);
    kern_block_load(&w.block[1], vec(0, -1), w.block[1].centre, 0);
    CHECK_INT((int)stays(&w, 1), -10 - KERN_BAD_OPTION);
    between_walls(&w, 0, 0, 0.5); /* between walls that nothing presses */
    CHECK_NEAR(stays(&w, 0), 0, EXACT);
}

/* The chance is that of the mirrored structure, and of other units. */
static void stays_random(void)
{
    static world w, other;
    static int order[MAX_BLOCKS];
    change c = no_change();
    int seed, stood = 0;
    c.mirror = 1;
    c.scale = c.mass = 8;
    for (seed = 1; seed <= 100; seed++) {
        double got;
        if (!random_world(&w, (unsigned long long)seed, 12))
            continue;
        sprintf(context, "seed %d", seed);
        got = stays(&w, w.blocks - 1);
        if (got < 0)
            continue;
        stood++;
        world_changed(&other, &w, &c, order);
        CHECK_NEAR(stays(&other, w.blocks - 1), got, EXACT);
    }
    context[0] = 0;
    CHECK(stood > 25);
}

static void stays_memory(void)
{
    static world w;
    kern_work work;
    kern_real got = -1;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        status = kern_stays(world_task(&w, &work), 4, &got);
        CHECK(status == KERN_NO_SPACE || status == KERN_STANDS);
        enough |= status == KERN_STANDS;
        CHECK((got >= 0) == enough);
    }
    CHECK(enough);
    got = -1;
    w.options.limit = 3;
    CHECK_INT(kern_stays(world_task(&w, &work), 4, &got), KERN_LIMIT);
    CHECK_INT(kern_stays(world_task(&w, &work), 4, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_stays(NULL, 4, &got), KERN_BAD_POINTER);
    CHECK_INT(kern_plan_stays(NULL, NULL, &got), KERN_BAD_POINTER);
    CHECK_NEAR(got, -1, 0);
}

static void raised_memory(void)
{
    static world w;
    kern_work work;
    kern_raising got = KERN_NOT_SHOWN;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        status = kern_raised(world_task(&w, &work), 0, &got, NULL, NULL);
        CHECK(status == KERN_NO_SPACE || status == KERN_STANDS);
        CHECK(status == KERN_STANDS || !enough);
        enough |= status == KERN_STANDS;
        CHECK((got == KERN_RAISED) == enough);
    }
    CHECK(enough);
    got = KERN_NOT_SHOWN;
    w.options.limit = 3;
    CHECK_INT(kern_raised(world_task(&w, &work), 0, &got, NULL, NULL),
              KERN_LIMIT);
    CHECK_INT(kern_raised(world_task(&w, &work), 0, NULL, NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_raised(NULL, 0, &got, NULL, NULL), KERN_BAD_POINTER);
    CHECK_INT(
        kern_raised(world_task(&w, &work), R(not_a_number()), &got, NULL, NULL),
        KERN_BAD_NUMBER);
    CHECK(!(kern_check_raised(NULL, 0, KERN_RAISED, NULL) <= 1));
    CHECK_INT(got, KERN_NOT_SHOWN);
}

/* kern_raised_load(), its proof checked with the loads at the factor, and that
   it is not above the load factor. */
static int raised_load(const world *w, const kern_wrench *pattern, int side,
                       double *out)
{
    static world loaded;
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    const kern_proof proof = proof_here();
    kern_real most = 0, got = -1;
    const kern_status status = kern_raised_load(task, 0, (kern_side)side,
                                                pattern, &got, &proof);
    int i;
    CHECK(work.units > 0 || status < 0);
    *out = (double)got;
    if (status != KERN_STANDS || !(got < HUGE_VAL))
        return status;
    CHECK_INT(pattern ? kern_load_factor_of(task, 0, pattern, &most, NULL)
                      : kern_load_factor(task, 0, (kern_side)side, &most, NULL),
              KERN_STANDS);
    CHECK(got <= most * (1 + GEO));
    loaded = *w;
    for (i = 0; i < w->blocks; i++) {
        kern_block *b = &loaded.block[i];
        const kern_real weight = got * b->mass * side;
        if (b->fixed)
            continue;
        kern_block_load(
            b,
            pattern ? vec(got * pattern[i].fx, got * pattern[i].fy)
                    : vec(-weight * w->gravity.y, weight * w->gravity.x),
            b->centre, pattern ? got * pattern[i].torque : 0);
    }
    CHECK(kern_check_raised(world_task(&loaded, &work), 0, KERN_RAISED, &proof)
          <= 1);
    return status;
}

/* Where nothing slides it is the load factor; Ferris and Tin-Loi's walls slide:
   a simulator lets them collapse between .640 and .645, .360 and .365, .260
   and .265. */
static void raised_loads(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const double falls[3] = {.645, .365, .265};
    static world w;
    double got, other;
    int i, n;
    for (n = 1; n <= 10; n++) {
        world_reset(&w);
        w.options.mu = R(0.84);
        world_box(&w, 0, -1, -1, 2, 0);
        for (i = 0; i < n; i++)
            world_box(&w, 1, 0, i, 1, i + 1);
        CHECK(world_touch(&w) > 0);
        CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &got), KERN_STANDS);
        CHECK_NEAR(got, n == 1 ? .84 : 1.0 / n, SINGLE ? 3e-2 : 4e-3);
    }
    for (i = 0; i < 3 && !SINGLE; i++) {
        brick_wall(&w, wall[i], 0.65, 1);
        CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &got), KERN_STANDS);
        CHECK(got >= .97 * falls[i] && got <= falls[i]);
        CHECK_INT(raised_load(&w, NULL, KERN_LEFT, &other), KERN_STANDS);
        CHECK_NEAR(other / got, 1, 0.03);
    }
}

/* The unit of length changes nothing: by powers of 2 not a bit. */
static void raised_scaled(void)
{
    static world w, other;
    static int order[MAX_BLOCKS];
    change c = no_change();
    double got, now;
    int seed, stood = 0;
    for (seed = 1; seed <= some(300); seed++) {
        if (!random_world(&w, (unsigned long long)seed, 8)
            || raised_load(&w, NULL, KERN_RIGHT, &got) != KERN_STANDS)
            continue;
        sprintf(context, "seed %d", seed);
        stood++;
        c.scale = seed % 2 ? 1.0 / 8192 : 8192;
        world_changed(&other, &w, &c, order);
        CHECK_INT(raised_load(&other, NULL, KERN_RIGHT, &now), KERN_STANDS);
        CHECK_NEAR(now, got, EXACT);
    }
    context[0] = 0;
    CHECK(stood > some(300) / 8);
}

/* The same walls under loads of their blocks, which kern_raised() finds raised
   where they grow from 0: up to 97 % of where the simulator lets them fall. */
static void raised_grown(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const double falls[3] = {.645, .365, .265};
    const kern_proof proof = proof_here();
    static world w;
    int i, k, b;
    for (i = 0; i < 3 && !SINGLE; i++)
        for (k = 1; k <= 12; k++) {
            kern_raising out = KERN_NOT_SHOWN;
            kern_work work;
            kern_task *task;
            brick_wall(&w, wall[i], 0.65, 1);
            for (b = 0; b < w.blocks; b++)
                if (!w.block[b].fixed)
                    kern_block_load(
                        &w.block[b],
                        vec(.97 * falls[i] * k / 12 * w.block[b].mass * 9.81,
                            0),
                        w.block[b].centre, 0);
            work = work_of(&w);
            task = world_task(&w, &work);
            CHECK_INT(kern_raised(task, 0, &out, NULL, &proof), KERN_STANDS);
            CHECK_INT(out, KERN_RAISED);
            CHECK(kern_check_raised(task, 0, out, &proof) <= 1);
        }
}

/* A load on one block; loads without bound; what is refused. */
static void raised_patterns(void)
{
    static world w;
    kern_wrench pattern[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    kern_work work;
    kern_task *task;
    kern_real got = -7;
    double value;
    world_reset(&w);
    w.options.mu = R(0.5);
    world_box(&w, 0, -1, -1, 3, 0);
    world_box(&w, 1, 0, 0, 2, 1);
    CHECK_INT(world_touch(&w), 2);
    pattern[1].fx = w.block[1].mass * R(9.81); /* slides at mu */
    CHECK_INT(raised_load(&w, pattern, 0, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.5, 2e-3);
    pattern[1].fx = 0;
    pattern[1].fy = -w.block[1].mass;
    CHECK_INT(raised_load(&w, pattern, 0, &value), KERN_STANDS);
    CHECK(value > 1e30);
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_raised_load(task, 0, KERN_SHRINK, NULL, &got, NULL),
              KERN_BAD_OPTION);
    CHECK_INT(kern_raised_load(task, 0, KERN_RIGHT, NULL, NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_raised_load(NULL, 0, KERN_RIGHT, NULL, &got, NULL),
              KERN_BAD_POINTER);
    pattern[1].fy = R(not_a_number());
    CHECK_INT(kern_raised_load(task, 0, KERN_SHRINK, pattern, &got, NULL),
              KERN_BAD_NUMBER);
    CHECK_NEAR(got, -7, GEO);
    task->options.limit = 3;
    CHECK_INT(kern_raised_load(task, 0, KERN_RIGHT, NULL, &got, NULL),
              KERN_LIMIT);
    CHECK(got < 0);
    world_reset(&w); /* hangs between two walls */
    world_box(&w, 0, -1, 0, 0, 3);
    world_box(&w, 0, 1, 0, 2, 3);
    world_box(&w, 1, 0, 1, 1, 2);
    CHECK(world_touch(&w) > 0);
    CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &value), KERN_UNDECIDED);
    CHECK_NEAR(value, -1, GEO);
    w.block[2].centre.y = 5; /* falls over the edge */
    w.contacts = 0;
    CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &value), KERN_FALLS);
}

/* Semicircular arches under loads without bound: the end of the path doubles
   twenty times, and no step is what rounding leaves of one. */
static void raised_doubling(void)
{
    static world w;
    kern_wrench pattern[15];
    double value;
    int n, i, t;
    for (n = 7; n <= 13; n += 2)
        for (t = 3; t <= 5; t++) {
            world_reset(&w);
            w.options.mu = R(0.4);
            memset(pattern, 0, sizeof pattern);
            for (i = 0; i < n; i++) {
                world_voussoir(&w, 2000, (n - 1 - i) * pi / n, (n - i) * pi / n,
                               1, 1 + 0.1 * t);
                pattern[i].fy = R(abs(i - n / 2) == 1 ? -2000 : -1000);
            }
            world_box(&w, 0, -1.1 - 0.1 * t, -1, -0.9, 0);
            world_box(&w, 0, 0.9, -1, 1.1 + 0.1 * t, 0);
            CHECK_INT(world_touch(&w), 2 * (n + 1));
            CHECK_INT(raised_load(&w, pattern, 0, &value), KERN_STANDS);
            CHECK(value > 1e30);
        }
}

/* ---- let go as a whole, and the least load that holds ---- */

/* Returns kern_let_go() of a world; its proof is checked. */
static int let_go(const world *w, kern_raising *how, kern_end *end)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w);
    const kern_task *task = world_task(w, &work);
    const kern_status got = kern_let_go(task, how, &proof);
    if (got == KERN_STANDS || *how == KERN_HANGS)
        CHECK(kern_check_raised(task, 0, *how, &proof) <= 1);
    else if (got == KERN_FALLS)
        CHECK(kern_check_motion(task, 0, proof.motion) <= 1);
    *end = work.end;
    return got;
}

/* A cube on the ground stays, one on a steep slope moves, one that only friction
   holds between two walls hangs and moves. */
static void let_go_as_whole(void)
{
    static world w;
    kern_raising how;
    kern_end end;
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK(world_touch(&w) > 0);
    CHECK_INT(let_go(&w, &how, &end), KERN_STANDS);
    CHECK_INT(how, KERN_RAISED);
    CHECK_INT(end, KERN_END_SHOWN);
    w.gravity = vec(9, -9);
    CHECK_INT(let_go(&w, &how, &end), KERN_FALLS);
    CHECK_INT(how, KERN_NOT_SHOWN);
    world_reset(&w);
    world_box(&w, 0, -1, -1, 0, 2);
    world_box(&w, 0, 1, -1, 2, 2);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK(world_touch(&w) > 0);
    CHECK_INT(let_go(&w, &how, &end), KERN_FALLS);
    CHECK_INT(how, KERN_HANGS);
    CHECK_INT(kern_let_go(NULL, &how, NULL), KERN_BAD_POINTER);
}

/* kern_least_load_of(); its proofs are checked at the factor and just below. */
static int least_load(const world *w, const kern_wrench *pattern, double *least)
{
    static kern_force force[MAX_POINTS];
    static kern_motion motion[MAX_BLOCKS];
    static world loaded;
    const kern_proof proof = {force, motion};
    kern_work work = work_of(w);
    kern_real factor = 0;
    int i;
    const kern_status got = kern_least_load_of(world_task(w, &work), 0, pattern,
                                               &factor, &proof);
    *least = (double)factor;
    if (got != KERN_STANDS)
        return got;
    for (int below = 0; below <= (factor > 0); below++) {
        const kern_real at = factor * (below ? R(SINGLE ? 0.99 : 0.999) : 1);
        loaded = *w;
        for (i = 0; i < w->blocks; i++) {
            loaded.block[i].load.fx += at * pattern[i].fx;
            loaded.block[i].load.fy += at * pattern[i].fy;
            loaded.block[i].load.torque += at * pattern[i].torque;
        }
        if (below)
            CHECK(kern_check_motion(world_task(&loaded, &work), 0, proof.motion)
                  <= 1);
        else
            CHECK(kern_check_forces(world_task(&loaded, &work), 0, proof.force)
                  <= 1);
    }
    return got;
}

/* A cube on a slope of tan 1 and friction .4 is held by a push up the slope from
   .6 of its weight along it on; a load into the slope holds it by friction; one
   down the slope never does. */
static void least_loads(void)
{
    static world w;
    kern_wrench pattern[2] = {{0, 0, 0}, {0, 0, 0}};
    const double pull = sqrt(0.5) * 9.81;
    double least;
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    w.gravity = vec(pull, -pull);
    CHECK(world_touch(&w) > 0);
    pattern[1].fx = -1;
    CHECK_INT(least_load(&w, pattern, &least), KERN_STANDS);
    CHECK_NEAR(least / pull, w.block[1].mass * (1 - 0.4), SINGLE ? 3e-3 : 1e-4);
    pattern[1].fx = 0;
    pattern[1].fy = -1;
    CHECK_INT(least_load(&w, pattern, &least), KERN_STANDS);
    CHECK_NEAR(least / pull, w.block[1].mass * 1.5, SINGLE ? 5e-3 : 1e-4);
    pattern[1].fx = 1;
    pattern[1].fy = 0;
    CHECK_INT(least_load(&w, pattern, &least), KERN_FALLS);
    CHECK(least > 1e30);
    w.gravity = vec(0, -9.81);
    CHECK_INT(least_load(&w, pattern, &least), KERN_STANDS);
    CHECK_NEAR(least, 0, EXACT);
    CHECK_INT(least_load(&w, NULL, &least), KERN_BAD_POINTER);
}

/* A cube that is tried between two walls hangs there, on the floor it does
   not. */
static void plan_raised(void)
{
    static world w;
    static site p;
    kern_raising got = KERN_NOT_SHOWN;
    kern_real reserve = 0;
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 0, -1, 0, 0, 3);
    world_box(&w, 0, 1, 0, 2, 3);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0, 2, 1, 3);
    site_with(&p, &w, 4);
    CHECK_INT(kern_plan_raised(&p.plan, NULL, &got, &reserve, NULL),
              KERN_STANDS);
    CHECK_INT(got, KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT);
    CHECK_INT(kern_plan_raised(&p.plan, &w.block[4], &got, &reserve, NULL),
              KERN_STANDS);
    CHECK_INT(got, KERN_HANGS);
    CHECK_INT(p.plan.task.s.blocks, 4);
    CHECK_INT(kern_plan_raised(NULL, NULL, &got, NULL, NULL), KERN_BAD_POINTER);
}

static const test raised_tests[] = {
    TEST(raised_by_hand),  TEST(raised_reserve), TEST(raised_random),
    TEST(raised_memory),   TEST(stays_law),      TEST(stays_random),
    TEST(stays_memory),    TEST(raised_loads),   TEST(raised_scaled),
    TEST(raised_doubling), TEST(raised_grown),   TEST(raised_patterns),
    TEST(let_go_as_whole), TEST(least_loads),    TEST(plan_raised),
};

#endif
