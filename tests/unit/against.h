/* against.h - random structures against the independent solver. */

#ifndef UNIT_AGAINST_H
#define UNIT_AGAINST_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"
#include "contact.h"

static long compare_many(long first, long many, int most, int deep_every)
{
    static world w;
    long k, kinds[KINDS] = {0}, stand = 0;
    const long before = undecided;
    for (k = 0; k < many; k++) {
        const int kind = random_world(
            &w, 1000000u + (unsigned long long)(first + k), most);
        kinds[kind]++;
        compare_with_twin(&w, deep_every > 0 && k % deep_every == 0);
        stand += twin_shortfall(&w, 0, FORCE_BOUND) <= NEAR_LO;
    }
    context[0] = 0;
    /* the sample must be worth something */
    if (many >= 500) {
        for (k = 0; k < KINDS; k++)
            CHECK(kinds[k] > many / (4 * KINDS));
        CHECK(stand > many / 10 && stand < many * 9 / 10);
    }
    return undecided - before;
}

static void twin_random(void)
{
    const long none = compare_many(0, some(3000), 12, 6)
                    + compare_many(500000, some(250), 40, 25);
    CHECK(SINGLE || none == 0);
    /* near the edge the twin leaves the question open: must be rare */
    CHECK(twin_near * 50 < twin_asked);
}

/* Lays a polygon whose corners are along u and up from a place. */
static void lay_along(world *w, int free_one, double x, double y, double angle,
                      const double *local, int corners)
{
    double xy[8];
    int k;
    for (k = 0; k < corners; k++) {
        const double u = local[2 * k], v = local[2 * k + 1];
        xy[2 * k] = x + u * cos(angle) - v * sin(angle);
        xy[2 * k + 1] = y + u * sin(angle) + v * cos(angle);
    }
    world_polygon(w, free_one ? uniform(0.5, 2) : 0, xy, corners);
}

/* Storeys of a beam on the tips of two wedges, which stand on the beam below
   and differ in height, so that every beam leans. */
static void random_tips(world *w, int storeys)
{
    const double ground[8] = {-9, -1, 9, -1, 9, 0, -9, 0};
    double x = -2, y = 0, angle = 0;
    int i, side;
    world_reset(w);
    w->options.mu = R(uniform(0.3, 0.9));
    w->options.relative = chance(0.3);
    w->options.epsilon = R(uniform(0.02, 0.1));
    lay_along(w, 0, 0, 0, 0, ground, 4);
    for (i = 0; i < storeys; i++) {
        double tip[2][2];
        for (side = 0; side < 2; side++) {
            const double at = side ? uniform(2.5, 3.5) : uniform(0.5, 1.6);
            const double high = uniform(0.6, 0.7);
            const double wedge[6] = {at - 0.4, 0, at + 0.4, 0, at, high};
            lay_along(w, 1, x, y, angle, wedge, 3);
            tip[side][0] = x + at * cos(angle) - high * sin(angle);
            tip[side][1] = y + at * sin(angle) + high * cos(angle);
        }
        angle = atan2(tip[1][1] - tip[0][1], tip[1][0] - tip[0][0]);
        {
            const double back = uniform(0.2, 1), thick = uniform(0.2, 0.4);
            const double beam[8] = {-back,    0,     4 - back, 0,
                                    4 - back, thick, -back,    thick};
            lay_along(w, 1, tip[0][0], tip[0][1], angle, beam, 4);
            x = tip[0][0] - back * cos(angle) - thick * sin(angle);
            y = tip[0][1] - back * sin(angle) + thick * cos(angle);
        }
    }
}

/* The same where lone points travel: most of these kerns are not nested. */
static void twin_lone_points(void)
{
    static world w;
    int seed, lone = 0, stand = 0;
    for (seed = 0; seed < some(200); seed++) {
        kern_margin stays, travels;
        random_seed(1900000u + (unsigned long long)seed);
        random_tips(&w, 1 + seed % 3);
        sprintf(context, "(tips %d)", seed);
        CHECK(world_touch(&w) > 0);
        if (measure(&w, &stays) != KERN_STANDS)
            continue;
        w.options.lone = w.gravity;
        world_touch(&w);
        check_contacts(&w);
        CHECK(measure(&w, &travels) == KERN_STANDS || SINGLE);
        compare_with_twin(&w, 0);
        lone += !twin_nested(&w);
        stand++;
    }
    context[0] = 0;
    CHECK(stand > some(30) && lone == stand);
}

static const test against_tests[] = {
    TEST(twin_random),
    TEST(twin_lone_points),
};

#endif
