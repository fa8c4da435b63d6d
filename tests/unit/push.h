/* push.h - the largest push of one stone. */

#ifndef UNIT_PUSH_H
#define UNIT_PUSH_H

#include "harness.h"
#include "worlds.h"

/* A box 1 wide and 2 high, mu .4, is pushed at its centre: it slides, and at 45
   degrees too, by P cos = mu (W - P sin); upward it takes its weight, downward
   there is no bound. Pushed at mu .6 it tips, at half its weight. */
static void push_by_hand(void)
{
    static const double mu[] = {0.4, 0.4, 0.4, 0.4, 0.4, 0.6};
    static const double angle[] = {0, 90, 180, 270, 45, 0};
    static const double want[] = {0.4, 1, 0.4, HUGE_VAL, 0.4, 0.5};
    static world w;
    size_t k;
    for (k = 0; k < sizeof mu / sizeof *mu; k++) {
        kern_wrench push[2];
        kern_work work;
        kern_real most = -1;
        world_reset(&w);
        w.options.mu = R(mu[k]);
        world_box(&w, 0, -3, -1, 4, 0);
        world_box(&w, 1, 0, 0, 1, 2);
        world_touch(&w);
        work = work_of(&w);
        memset(push, 0, sizeof push);
        push[1].fx = R(2 * W * cos(angle[k] * pi / 180));
        push[1].fy = R(2 * W * sin(angle[k] * pi / 180));
        CHECK_INT(
            kern_load_factor_of(world_task(&w, &work), 0, push, &most, NULL),
            KERN_STANDS);
        CHECK_NEAR(most, k == 4 ? 0.4 / (sqrt(0.5) * 1.4) : want[k],
                   SINGLE ? 5e-3 : 1e-6);
    }
}

static const test push_tests[] = {
    TEST(push_by_hand),
};

#endif
