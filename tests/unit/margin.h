/* margin.h - level and margin. */

#ifndef UNIT_MARGIN_H
#define UNIT_MARGIN_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"

static void margin_relative(void)
{
    static world w;
    kern_margin m;
    /* upper bed [.25, 1]: half length .375, and the load is .25 from its end:
       d = 2/3; lower bed: 1/2, and the load of both .375 from its end: 3/4 */
    stack_of_two(&w, 0.25);
    w.options.relative = 1;
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 2. / 3, EXACT);
    CHECK_NEAR(m.most, 1, 0);
    CHECK_NEAR(m.epsilon, R(0.05), 0);
    CHECK_INT(m.level, 14);
    check_bracket(&w, &m);
    stack_of_two(&w, 0);
    w.options.relative = 1;
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(m.level, 21);
}

static void margin_steps(void)
{
    static world w;
    kern_margin m;
    kern_work work;
    static const double steps[] = {0.02, 0.03, 0.07, 0.2, 0.24,
                                   0.26, 0.4,  0.6,  7,   1e-5};
    int k;
    stack_of_two(&w, 0.25);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.epsilon, 0.02, EPS); /* by default, of the mean size */
    for (k = 0; k < COUNT_OF(steps); k++) {
        double ratio = 0.25 / steps[k];
        if (SINGLE
            && steps[k] < 1e-3) /* 1e-5 is finer than float knows the margin */
            continue;
        w.options.epsilon = R(steps[k]);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK_NEAR(m.margin, 0.25, EXACT);
        /* where d* is a multiple of the step (1e-5), either count is right */
        if (fabs(ratio - floor(ratio + 0.5)) < 1e-9)
            CHECK_NEAR(m.level, ratio + 0.5, 0.51);
        else
            CHECK_INT(m.level, (int)floor(ratio) + 1);
        check_bracket(&w, &m);
    }
    /* a step that needs more than a million levels */
    work = work_of(&w);
    stack_of_two(&w, 0);
    w.options.epsilon = R(0.5 / 2e6);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(SINGLE ? 1e-30 : 1e-300);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(0.5 / 0.9e6);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.level, 900001, 1);
    w.options.epsilon = R(0);
    w.options.relative = 1;
    w.options.epsilon = R(1e-7);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(-0.1);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_OPTION);
    /* past closing: the last test is at d_max */
    stack_of_two(&w, 0);
    w.options.epsilon = R(3);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_INT(m.level, 2);
    CHECK(m.saturated);
}

static void margin_ends(void)
{
    static world w;
    kern_margin m;
    /* it does not stand: nothing to shrink */
    shifted_cube(&w, 0.75);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
    CHECK_NEAR(m.most, 0.125, GEO);
    /* no contacts, loads that cancel: saturated at d_max = 0 */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
    CHECK_NEAR(m.most, 0, 0);
    kern_block_load(&w.block[0], vec(0, 9.81), vec(0.5, 0.5), 0);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.margin, 0, 0);
    CHECK_NEAR(m.most, 0, 0);
    /* a block on one point, right above it: nothing shrinks */
    world_reset(&w);
    world_mass(&w, 0, 0, 0, 1);
    world_mass(&w, 1, 0, 1, 1);
    world_point(&w, 0, 1, 0, 1, 0, 0.5);
    world_touch(&w);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.most, 0, 0);
}

/* One stone on three points of one interface, of which the middle one leans:
   it stands, falls and stands again. */
static void margin_not_monotone(void)
{
    static world w, t;
    kern_margin m;
    int found = 0, seed;
    for (seed = 0; seed < 4000 && found < some(40); seed++) {
        double most, d;
        int k, got, verdicts = 0, last = 1;
        random_of_kind(&w, 990000u + (unsigned long long)seed, 3, POINTS);
        if (twin_nested(&w) || twin_shortfall(&w, 0, FORCE_BOUND) > NEAR_LO)
            continue;
        most = twin_most(&w);
        for (k = 1; k <= 60; k++) {
            d = most * k / 60;
            if ((twin_shortfall(&w, d, FORCE_BOUND) <= NEAR_LO) != last) {
                last = !last;
                verdicts++;
            }
        }
        if (verdicts < 2)
            continue;
        found++;
        /* steps of many sizes pass over the losses or meet them */
        for (k = 0; k < 12; k++) {
            world_copy(&t, &w);
            t.options.epsilon = R(most * uniform(0.02, 0.6));
            compare_with_twin(&t, k == 0);
        }
        got = measure(&w, &m);
        CHECK(got == KERN_STANDS ? !m.saturated
                                 : SINGLE && got == KERN_UNDECIDED);
    }
    context[0] = 0;
    CHECK_INT(found, some(40));
}

static const test margin_tests[] = {
    TEST(margin_relative),
    TEST(margin_steps),
    TEST(margin_ends),
    TEST(margin_not_monotone),
};

#endif
