/* pose.h - pose errors: narrow contacts. */

#ifndef UNIT_POSE_H
#define UNIT_POSE_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"

static int margin_narrow(world *w, double narrow, double *margin)
{
    kern_work work = work_of(w);
    const kern_proof proof = proof_here();
    kern_margin m;
    int got;
    memset(&m, 0, sizeof m);
    w->options.narrow = R(narrow);
    got = kern_measure(world_task(w, &work), &m, &proof);
    *margin = (double)m.margin;
    w->options.narrow = 0;
    return got;
}

/* A cube under a gravity that leans by a tangent of .2 slides where the tangent
   of the friction angle of .4 less that of k d is .2: k d = .2 / 1.08. It tips
   at d = .4. So the least friction comes from the margin where k is large. */
static void narrow_by_hand(void)
{
    static const double rate[] = {0.1, 0.4, 0.6, 1, 10, 1000};
    static world w;
    double margin;
    size_t i;
    one_cube(&w);
    w.gravity = vec(-9.81 * 0.2, -9.81);
    for (i = 0; i < sizeof rate / sizeof *rate; i++) {
        const double slides = 0.2 / 1.08 / rate[i];
        CHECK_INT(margin_narrow(&w, rate[i], &margin), KERN_STANDS);
        CHECK_NEAR(margin, slides < 0.4 ? slides : 0.4, 2 * EDGE);
    }
    w.options.relative = 1; /* a share of .5 */
    CHECK_INT(margin_narrow(&w, 1, &margin), KERN_STANDS);
    CHECK_NEAR(margin, 0.2 / 1.08, 2 * EDGE);
    w.options.narrow = R(-1);
    CHECK_INT(verdict(&w, 0), KERN_BAD_OPTION);
    w.options.narrow = R(not_a_number());
    CHECK_INT(verdict(&w, 0), KERN_BAD_NUMBER);
}

/* w with the friction that is left at shrinkage d of cones that narrow at a
   rate. */
static const world *narrowed(const world *w, double rate, double d)
{
    static world now;
    int c;
    world_copy(&now, w);
    for (c = 0; c < now.contacts; c++) {
        const double mu = (double)now.contact[c].mu;
        const double left = (mu - rate * d) / (1 + mu * rate * d);
        now.contact[c].mu = R(left > 0 ? left : 0);
    }
    return &now;
}

/* Whether cones without narrowing hold before a margin and fail behind it.
   Returns how often that was asked. In float some structures are critical along
   a stretch: there the motion of the measure must be a proof beside the forces. */
static int check_narrowed(const world *w, double rate, double margin)
{
    const double step = (SINGLE ? 6e-3 : 4e-6) * mean_size(w);
    int side, compared = 0;
    for (side = -1; side <= 1; side += 2) {
        const double at = margin + side * step;
        int got;
        if (at < 0 || at > twin_most(w))
            continue;
        got = verdict(narrowed(w, rate, at), at);
        compared++;
        CHECK(got == (side < 0 ? KERN_STANDS : KERN_FALLS) || !decided(got)
              || (SINGLE && side > 0
                  && share_of_motion(narrowed(w, rate, at), at, motion_of)
                         <= 1.001));
    }
    return compared;
}

/* The faster cones narrow, the smaller the margin; each is that of contacts
   with the friction that is left there. Of 10,000 structures in float some
   dozens are critical along a stretch: there forces within the tolerance of
   float and a motion both are proofs, so it is asked of fewer. */
static void narrow_random(void)
{
    static const double rate[] = {0, 0.03, 0.3, 3, 300};
    static world w;
    int seed, compared = 0, structures = 0;
    for (seed = 1; seed <= (quick || SINGLE ? 400 : 40000); seed++) {
        double last = HUGE_VAL, margin;
        size_t i;
        if (!random_world(&w, (unsigned long long)seed, 12) || !twin_nested(&w))
            continue;
        sprintf(context, "seed %d", seed);
        w.options.relative = 0;
        for (i = 0; i < sizeof rate / sizeof *rate; i++) {
            const double size = mean_size(&w), k = rate[i] / size;
            if (margin_narrow(&w, k, &margin) != KERN_STANDS)
                break;
            structures += i == 1;
            CHECK(margin <= last + EDGE * size);
            last = margin;
            compared += check_narrowed(&w, k, margin);
        }
    }
    context[0] = 0;
    CHECK(compared > (quick || SINGLE ? 500 : 50000));
    CHECK(structures > (quick || SINGLE ? 100 : 10000));
}

static const test pose_tests[] = {
    TEST(narrow_by_hand),
    TEST(narrow_random),
};

#endif
