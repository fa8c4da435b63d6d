/* bearing.h - the bearing length. */

#ifndef UNIT_BEARING_H
#define UNIT_BEARING_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"

static double bearing(const world *w, int *status)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w), check = work_of(w);
    kern_real length = R(-2);
    *status = kern_bearing(world_task(w, &work), &length, &proof);
    if (*status == KERN_STANDS)
        CHECK(kern_check_forces(world_task(w, &check), 0, force_of) <= 1);
    return (double)length;
}

/* By the definition: all lengths in turn, shorter contacts taken out by hand. */
static double bearing_by_hand(const world *w)
{
    static world t;
    double best = -1;
    int i, k;
    for (i = -1; i <= w->contacts; i++) {
        const double length = i < 0 ? 0
                            : i == w->contacts
                                ? huge_value()
                                : 2 * fabs((double)w->contact[i].travel);
        if (!(length > best))
            continue;
        world_copy(&t, w);
        for (k = t.contacts = 0; k < w->contacts; k++) {
            const double own = 2 * fabs((double)w->contact[k].travel);
            if (!(own > 0) || own >= length)
                t.contact[t.contacts++] = w->contact[k];
        }
        if (verdict(&t, 0) == KERN_STANDS)
            best = length;
    }
    return best;
}

/* A unit stone on two lips: `left` and `right` wide. */
static void stone_on_lips(world *w, double left, double right)
{
    world_reset(w);
    world_box(w, 0, -2, -1, left, 0);
    world_box(w, 0, 1 - right, -1, 3, 0);
    world_box(w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(w), 4);
}

static void bearing_of_lips(void)
{
    static const double lip[] = {0.3, 0.1, 2e-2, 1e-2};
    static world w;
    int i, got;
    for (i = 0; i < 4; i++) {
        stone_on_lips(&w, lip[i], 0.3);
        CHECK_NEAR(bearing(&w, &got), lip[i], SINGLE ? 1e-6 : 1e-12);
        CHECK_INT(got, KERN_STANDS);
        stone_on_lips(&w, lip[i], 0.7); /* the lip is not needed */
        CHECK_NEAR(bearing(&w, &got), 0.7, SINGLE ? 1e-6 : 1e-12);
    }
    if (!SINGLE) { /* the margin is that of a lip of 100 mm, and saturated */
        kern_margin m;
        stone_on_lips(&w, 2e-6, 0.3);
        CHECK_NEAR(bearing(&w, &got), 2e-6, 1e-12);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated && m.margin > R(0.14));
    }
    stack_of_two(&w, 0.25);
    CHECK_NEAR(bearing(&w, &got), 0.75, EXACT);
    stack_of_two(&w, 0.75);
    CHECK_NEAR(bearing(&w, &got), -2, 0);
    CHECK_INT(got, KERN_FALLS);
    world_reset(&w); /* on two points that have no length */
    world_mass(&w, 0, 0, -1, 1);
    world_mass(&w, 0, 1, -1, 1);
    world_mass(&w, 1, 0.5, 0.5, 1);
    world_point(&w, 0, 2, 0, 1, 0, 0);
    world_point(&w, 1, 2, 0, 1, 1, 0);
    world_touch(&w);
    CHECK(bearing(&w, &got) > 1e30);
}

static void bearing_by_definition(void)
{
    static world w;
    int seed, slivers = 0;
    for (seed = 0; seed < 300; seed++) {
        int got; /* of the verdict on all contacts */
        double here, by_hand;
        random_world(&w, 780000u + (unsigned long long)seed, 10);
        here = bearing(&w, &got);
        by_hand = bearing_by_hand(&w);
        if (got == KERN_STANDS)
            CHECK_NEAR(here, by_hand, 1e-12 * here);
        else
            CHECK(got == KERN_FALLS ? by_hand < 0 : SINGLE);
        slivers += here < 0.3 && here > 0;
    }
    context[0] = 0;
    CHECK(slivers > 20);
}

static const test bearing_tests[] = {
    TEST(bearing_of_lips),
    TEST(bearing_by_definition),
};

#endif
