/* load.h - deficit, load factor, tilt. */

#ifndef UNIT_LOAD_H
#define UNIT_LOAD_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"

static void deficit_by_hand(void)
{
    static world w;
    double growth;
    /* overhang .1 beyond the half: the bed's end must come out by as much */
    shifted_cube(&w, 0.6);
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, 0.1, SINGLE ? 1e-3 : 1e-6);
    w.options.relative = 1; /* half length .2 */
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, 0.5, SINGLE ? 1e-3 : 1e-6);
    /* stands: nothing is missing */
    shifted_cube(&w, 0.3);
    CHECK_INT(deficit(&w, &growth), KERN_STANDS);
    CHECK_NEAR(growth, 0, 0);
    /* in the air, or sliding, no growth helps */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    shifted_cube(&w, 0);
    w.gravity = vec(9.81 * sin(0.5), -9.81 * cos(0.5)); /* tan .5 = .546 */
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    w.options.relative = 1;
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    /* a leaning box of 1 x 2 that topples: the weight passes the end of the
       bed by tan .7 - 1/2 */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 1);
    world_box(&w, 1, 0, 1, 1, 3);
    world_touch(&w);
    world_friction(&w, 1);
    w.gravity = vec(9.81 * sin(0.7), -9.81 * cos(0.7));
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, tan(0.7) - 0.5, SINGLE ? 1e-3 : 1e-6);
}

/* The growth found is the first: a little less falls, it and a bit more
   stands. */
static void deficit_random(void)
{
    static world w;
    int seed, finite = 0;
    for (seed = 0; seed < 600; seed++) {
        double growth, scale;
        int got;
        random_world(&w, 820000u + (unsigned long long)seed, 8);
        scale = w.options.relative ? 1 : mean_size(&w);
        got = deficit(&w, &growth);
        CHECK(decided(got));
        if (got != KERN_FALLS)
            continue;
        CHECK(growth > 0);
        if (isinf(growth)) {
            CHECK(twin_agrees(&w, -(w.options.relative ? 10 : 10 * scale), 0)
                  || !twin_nested(&w));
            continue;
        }
        finite++;
        {
            const double off = (SINGLE ? 1e-2 : 4e-6) * fmax(growth, scale);
            CHECK(twin_agrees(&w, -growth - off, 1));
            CHECK(twin_agrees(&w, -growth + off, 0));
        }
        CHECK(!twin_nested(&w) || twin_agrees(&w, -growth / 2, 0));
    }
    context[0] = 0;
    CHECK(finite > 20);
}

/* A unit cube on a fixed one, shifted by `shift`, pushed by a pattern of loads
   on a block, or (-1) horizontally at its centre. By hand: it slides where the
   push is mu times what presses, and topples about an end of the bed. */
static const struct {
    double shift, mu;
    int block;
    double fx, fy, torque;
    int side;
    double want;
} pushes[] = {
    {0, 0.4, -1, 0, 0, 0, 1, 0.4}, /* slides at mu, to either side */
    {0, 0.4, -1, 0, 0, 0, -1, 0.4},
    {0, 0.4, 1, 2, 0, 0, 1, 0.4 * W / 2},
    {0, 0.4, 1, 0, 0, -1, 1, W / 2},     /* topples when the torque is W / 2 */
    {0, 0.4, 1, 0, 1, 0, 1, W},          /* lifts off */
    {0, 0.4, 1, 0, -1, 0, 1, HUGE_VAL},  /* downward: never */
    {0, 0.4, 0, 100, 0, 0, 1, HUGE_VAL}, /* on the fixed block: never */
    /* it topples sooner to the side it hangs over: the load acts 1/2 above the
       bed, and the weight .1 and .5 from the ends of the bed [.4, 1] */
    {0.4, 5, -1, 0, 0, 0, 1, 0.2},
    {0.4, 5, -1, 0, 0, 0, -1, 1},
};

static void load_by_hand(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    double factor;
    change c = no_change();
    int i;
    for (i = 0; i < COUNT_OF(pushes); i++) {
        const int block = pushes[i].block;
        kern_wrench pattern[2];
        memset(pattern, 0, sizeof pattern);
        if (block >= 0) {
            pattern[block].fx = R(pushes[i].fx);
            pattern[block].fy = R(pushes[i].fy);
            pattern[block].torque = R(pushes[i].torque);
        }
        sprintf(context, "(push %d)", i);
        shifted_cube(&w, pushes[i].shift);
        world_friction(&w, pushes[i].mu);
        CHECK_INT(load_factor(&w, block < 0 ? NULL : pattern, pushes[i].side,
                              &factor),
                  KERN_STANDS);
        CHECK_NEAR(factor, pushes[i].want,
                   isinf(pushes[i].want) ? 0
                   : block < 0           ? EDGE
                                         : EDGE * W);
    }
    context[0] = 0;
    /* gravity turned by a quarter: right is up the page */
    shifted_cube(&w, 0.4);
    c.angle = pi / 2;
    world_changed(&t, &w, &c, order);
    world_friction(&t, 5);
    CHECK_INT(load_factor(&t, NULL, 1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.2, EDGE);
    /* falls with no load at all */
    shifted_cube(&w, 0.75);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_FALLS);
    CHECK_NEAR(factor, -1, 0);
    /* no gravity, no horizontal load */
    shifted_cube(&w, 0);
    w.gravity = vec(0, 0);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_NO_LOAD);
    w.block[1].load.fy = R(-9.81);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_BAD_OPTION);
}

static void load_beside_others(void)
{
    static world w;
    kern_work work;
    kern_real out = R(-1);
    kern_proof proof = proof_here();
    double factor;
    /* own loads stay while the factor grows */
    shifted_cube(&w, 0);
    kern_block_load(&w.block[1], vec(0.1 * W, 0), vec(0.5, 1.5), R(0));
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.3, EDGE);
    CHECK_INT(load_factor(&w, NULL, -1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.5, EDGE);
    /* shrunk by .4 the bed is [.4, .6]: topples at .1 / .5 */
    shifted_cube(&w, 0);
    work = work_of(&w);
    CHECK_INT(kern_load_factor(world_task(&w, &work), R(0.4), KERN_RIGHT, &out,
                               &proof),
              KERN_STANDS);
    CHECK_NEAR(out, 0.2, EDGE);
}

/* A cube on a cube slides at atan(mu) or topples about the end of its bed;
   pressed down by p of its weight, which does not turn, it slides where
   sin a = mu (cos a + p). */
static void tilt_by_hand(void)
{
    const double slide = atan(0.4);
    const struct {
        double shift, mu, press, left, right, tol;
    } cubes[] = {
        {0, 0.4, 0, slide, slide, EDGE},
        {0, 5, 0, pi / 4, pi / 4, EDGE},
        {0.4, 5, 0, atan(1), atan(0.2), EDGE},
        {0, 0.4, 0.5, slide + asin(0.5 * sin(slide)),
         slide + asin(0.5 * sin(slide)), EDGE},
        /* the angle passes a right one, and it never falls where the load
           times sin(atan mu) is more than the weight */
        {0, 0.4, 2.6, slide + asin(2.6 * sin(slide)),
         slide + asin(2.6 * sin(slide)), 10 * EDGE},
        {0, 0.4, 3, pi, pi, 16 * EPS},
    };
    static world w;
    double angle, factor;
    int side, i;
    for (side = -1; side <= 1; side += 2)
        for (i = 0; i < COUNT_OF(cubes); i++) {
            sprintf(context, "(cube %d)", i);
            shifted_cube(&w, cubes[i].shift);
            world_friction(&w, cubes[i].mu);
            kern_block_load(&w.block[1], vec(0, -cubes[i].press * W),
                            vec(0.5, 1.5), R(0));
            CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
            CHECK_NEAR(angle, side > 0 ? cubes[i].right : cubes[i].left,
                       cubes[i].tol);
            if (cubes[i].press > 0)
                continue;
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(tan(angle), factor, 2 * EDGE);
        }
    context[0] = 0;
}

/* A cube in a slot between two walls. */
static void tilt_in_a_slot(void)
{
    static const double slot[] = {-1, -1, 2, -1, 2, 2, 1,  2,
                                  1,  0,  0, 0,  0, 2, -1, 2};
    static world w;
    double angle;
    int side;
    for (side = -1; side <= 1; side += 2) {
        /* with a lid on it stays in */
        world_reset(&w);
        world_polygon(&w, 0, slot, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 0, 0, 1, 1, 2);
        world_touch(&w);
        CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
        CHECK_NEAR(angle, pi, 16 * EPS);
        /* without the lid and without friction: falls out past a right angle */
        world_reset(&w);
        world_polygon(&w, 0, slot, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        world_touch(&w);
        world_friction(&w, 0);
        CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
        CHECK_NEAR(angle, pi / 2, EDGE);
        /* falls as it is; no gravity */
        shifted_cube(&w, 0.75);
        CHECK_INT(tilt(&w, side, &angle), KERN_FALLS);
        CHECK_NEAR(angle, -1, 0);
        w.gravity = vec(0, 0);
        w.block[1].load.fy = R(-9.81);
        CHECK_INT(tilt(&w, side, &angle), KERN_BAD_OPTION);
    }
}

/* Under a little less than the load factor it stands, under a bit more it
   falls. */
static void around_load_factor(const world *w, int side, double factor)
{
    static world t;
    const double step = SINGLE ? 1e-2 : 4e-6;
    int i, s;
    for (s = -1; s <= 1; s += 2) {
        const double x = fmax(0, factor + s * step * (1 + factor));
        world_copy(&t, w);
        for (i = 0; i < t.blocks; i++)
            if (!t.block[i].fixed) {
                const double mass = (double)t.block[i].mass;
                t.block[i].load.fx = R(-side * x * mass * (double)w->gravity.y);
                t.block[i].load.fy = R(side * x * mass * (double)w->gravity.x);
            }
        if (s > 0 || factor > step)
            CHECK(twin_agrees(&t, 0, s < 0));
    }
}

/* Without loads tan(tilt) is the load factor. */
static void tilt_and_load_factor(void)
{
    static world w;
    double angle, factor;
    int side, i, k;
    for (k = 0; k < 500; k++) {
        random_world(&w, 860000u + (unsigned long long)k, 10);
        for (i = 0; i < w.blocks; i++)
            memset(&w.block[i].load, 0, sizeof w.block[i].load);
        for (side = -1; side <= 1; side += 2) {
            const int got = load_factor(&w, NULL, side, &factor);
            const int turned_got = tilt(&w, side, &angle);
            CHECK(decided(got) && decided(turned_got));
            if (got < 0 || turned_got < 0)
                continue;
            CHECK_INT(turned_got, got);
            if (got != KERN_STANDS)
                continue;
            if (factor < 50) {
                CHECK_NEAR(tan(angle), factor,
                           (SINGLE ? 2e-2 : 1e-5) * (1 + factor * factor));
                around_load_factor(&w, side, factor);
            } else if (isinf(factor))
                CHECK(angle > 1.57);
        }
    }
    context[0] = 0;
}

/* An arch bridge of 16 voussoirs between springings, its fill as mass, and an
   axle at 13 places on it: under a load 1e-6 below the factor the independent
   solver finds forces, 1e-6 above it none. */
static void axle_on_a_bridge(void)
{
    enum { VOUSSOIRS = 16, PLACES = 13 };
    const double half = 1.2, step = 2 * half / VOUSSOIRS, outer = 1.15;
    const double step_of_load = SINGLE ? 1e-2 : 1e-6;
    static world w, t;
    int i, place, side;
    world_reset(&w);
    w.options.mu = R(0.6);
    for (i = -1; i <= VOUSSOIRS; i++)
        world_voussoir(&w, i < 0 || i == VOUSSOIRS ? 0 : 1,
                       pi / 2 - half + i * step, pi / 2 - half + (i + 1) * step,
                       0.95, outer);
    for (i = 1; i <= VOUSSOIRS; i++) { /* fill up to a level of 1.3 */
        kern_block *b = &w.block[i];
        const double high = 1.3 - (double)b->box.high.y;
        b->mass += R(0.5 * high * (double)(b->box.high.x - b->box.low.x));
    }
    CHECK_INT(world_touch(&w), 2 * (VOUSSOIRS + 1));
    for (place = 0; place < PLACES; place++) {
        const double from = pi / 2 - half * (place - 6) / 9;
        const double x = outer * cos(from), y = outer * sin(from);
        const int at = 1 + (int)((from - (pi / 2 - half)) / step);
        kern_wrench pattern[VOUSSOIRS + 2];
        double factor;
        memset(pattern, 0, sizeof pattern);
        pattern[at].fy = -1;
        pattern[at].torque = R((double)w.block[at].centre.x - x);
        sprintf(context, "(axle %d)", place);
        CHECK_INT(load_factor(&w, pattern, 1, &factor), KERN_STANDS);
        CHECK(factor > 0.01 && factor < 100);
        for (side = -1; side <= 1; side += 2) {
            world_copy(&t, &w);
            kern_block_load(&t.block[at],
                            vec(0, -factor * (1 + side * step_of_load)),
                            vec(x, y), 0);
            CHECK(twin_agrees(&t, 0, side < 0));
        }
    }
    context[0] = 0;
}

static const test load_tests[] = {
    TEST(deficit_by_hand),      TEST(deficit_random),   TEST(load_by_hand),
    TEST(load_beside_others),   TEST(tilt_by_hand),     TEST(tilt_in_a_slot),
    TEST(tilt_and_load_factor), TEST(axle_on_a_bridge),
};

#endif
