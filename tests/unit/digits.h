/* digits.h - proofs of the last digits. */

#ifndef UNIT_DIGITS_H
#define UNIT_DIGITS_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "verdict.h"
#include "random.h"

/* share_of_motion() without allowance: of the numbers that the library was
   given, in an arithmetic in which their rounding is none. */
static double strict_share(const world *w, double d, const kern_motion *motion)
{
    const double mean = mean_size(w);
    wide power = 0, against = 0, weight = 0;
    int i, k, side, end;
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        const kern_motion *v = &motion[i];
        const wide part = ((wide)b->mass * w->gravity.x + b->load.fx) * v->vx
                        + ((wide)b->mass * w->gravity.y + b->load.fy) * v->vy
                        + (wide)b->load.torque * v->spin;
        if (b->fixed)
            continue;
        if (v->vx < 0 || v->vx > 0 || v->vy < 0 || v->vy > 0 || v->spin < 0
            || v->spin > 0)
            weight += own_weight(w, i);
        power += part;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const wide own = fabs((double)c->travel) < 1e-9 * mean ? 0 : c->travel;
        const wide s = own_slide(own, (wide)d, w->options.relative);
        wide rx = 0, ry = 0;
        for (end = 0; end < 2; end++) {
            const int j = end ? c->b : c->a;
            const kern_motion *v = &motion[j];
            const kern_vec o = w->block[j].centre;
            rx = v->vx - v->spin * ((wide)c->p.y - o.y + s * c->n.x) - rx;
            ry = v->vy + v->spin * ((wide)c->p.x - o.x - s * c->n.y) - ry;
        }
        for (side = -1; side <= 1; side += 2) {
            const wide shut = side * (wide)c->mu * (ry * c->n.x - rx * c->n.y)
                            - rx * c->n.x - ry * c->n.y;
            against = shut > against ? shut : against;
        }
    }
    return power > 0 ? (double)((wide)FORCE_BOUND * weight * against / power)
                     : huge_value();
}

/* Every motion accepted just beyond the margin is one without rounding too. */
static void strict_motions(world *w)
{
    const kern_proof proof = proof_here();
    const double mean = w->options.relative ? 1 : mean_size(w);
    const double unit = SINGLE ? 1e-4 : 1e-11;
    kern_work work = work_of(w);
    kern_margin m;
    int k;
    world_touch(w);
    if (kern_measure(world_task(w, &work), &m, NULL) != KERN_STANDS)
        return;
    for (k = -20; k <= 200; k++) {
        const kern_real d = R((double)m.margin + k * unit * mean);
        if (kern_verdict(world_task(w, &work), d, &proof) == KERN_FALLS)
            CHECK(strict_share(w, (double)d, motion_of) <= 1 + 1e-6);
    }
}

static void proof_without_rounding(void)
{
    /* clang-format off */
    static const double turned[] = {
        2.95888096364245, 0, 3.995178370686835, 0, 5, 0, 5, 0.9575368596071754,
        4.0325608030101785, 1.024719457953587, 2.9923412409437704,
        1.021428540435464};
    /* clang-format on */
    /* clang-format off */
    static const double upper[] = {
        0, 1.0101624356398868, 0.9760333529370225, 1.0186265482993435,
        1.9685798551100973, 0.9963834993000589, 2.000124195517344,
        2.038238484334806, 2.0263384679946204, 2.9752005977606184,
        1.0471287107056582, 3.006636593821413};
    /* clang-format on */
    /* clang-format off */
    static const double lower[] = {
        0, 0, 0.9693282853377662, 0, 2.029722807360566, 0, 1.9685798551100973,
        0.9963834993000589, 0.9760333529370225, 1.0186265482993435, 0,
        1.0101624356398868};
    /* clang-format on */
    static world w;
    int seed, relative;
#if !defined(KERN_SINGLE) && LDBL_MANT_DIG < 60
    return; /* long double would round as the library does */
#endif
    for (relative = 0; relative < 2; relative++) {
        world_reset(&w);
        w.options.mu = R(0.7);
        w.options.relative = relative;
        world_box(&w, 0, -1, -1, 6, 0);
        world_polygon(&w, 1, turned, 6);
        strict_motions(&w);
        world_reset(&w);
        w.options.relative = relative;
        world_box(&w, 0, -1, -1, 7, 0);
        world_polygon(&w, 1, upper, 6);
        world_polygon(&w, 1, lower, 6);
        kern_block_load(&w.block[2], vec(2.331164152285308, 0.7769891002595068),
                        vec(0.7978817221925798, 0.7525462368403466), 0);
        strict_motions(&w);
    }
    for (seed = 0; seed < 60; seed++) {
        random_of_kind(&w, 995000u + (unsigned long long)seed, 5, KINDS);
        strict_motions(&w);
    }
    context[0] = 0;
}

/* An arch of three, leaning at a thousand kilometres from the origin: from each
   joint, a point inside and one outside, to the next. */
static void proof_far_away(void)
{
    static const double joint[][4] = {{1000006.85734197, 1000.1728159780357,
                                       1000007.5851202048, 1000.3435271441456},
                                      {1000006.6543420705, 1003.1726144780692,
                                       1000007.0821204553, 1003.343025644229},
                                      {1000001.119489143, 1007.2861243280652,
                                       1000001.2061444587, 1007.7383689172251},
                                      {999996.3914897689, 1006.4279008636657,
                                       999996.1739658307, 1006.8337550843848},
                                      {999993.1862584405, 1002.8255061236022,
                                       999992.8068576313, 1003.0864454616521},
                                      {999992.98925854, 999.8253076236354,
                                       999992.3098578807, 1000.0859469617354}};
    static const int from[] = {0, 4, 1, 2, 3}; /* the supports first */
    int k;
    static world w;
#if defined(KERN_SINGLE) || LDBL_MANT_DIG < 60
    return;
#endif
    world_reset(&w);
    w.options.mu = R(5);
    w.gravity = vec(0.009809998365000083, -9.80999509500041);
    for (k = 0; k < 5; k++) {
        const double *p = joint[from[k]], *q = joint[from[k] + 1];
        const double xy[] = {p[0], p[1], p[2], p[3], q[2], q[3], q[0], q[1]};
        world_polygon(&w, k > 1, xy, 4);
    }
    strict_motions(&w);
}

/* What is not a number proves nothing. */
static void proof_of_no_numbers(void)
{
    static world w;
    kern_force force[4];
    kern_motion motion[2];
    kern_work work;
    int i, k;
    world_reset(&w);
    world_box(&w, 0, -5, -1, 5, 0);
    world_box(&w, 2400, 0, 0, 2, 1);
    world_touch(&w);
    CHECK_INT(w.contacts, 2);
    work = work_of(&w);
    for (i = 0; i < 3; i++) {
        const kern_real bad = R(no_number(i));
        memset(force, 0, sizeof force);
        memset(motion, 0, sizeof motion);
        for (k = 0; k < 3; k++) { /* no force, the half, all on one end */
            force[0].normal = R(k * 2400 * 9.81);
            CHECK_NEAR(kern_check_forces(world_task(&w, &work), bad, force),
                       huge_value(), 0);
            CHECK(!(kern_check_forces(world_task(&w, &work), 0, force) <= 1));
        }
        motion[1].vy = R(-1); /* into the ground */
        motion[1].spin = R(0.001);
        CHECK_NEAR(kern_check_motion(world_task(&w, &work), bad, motion),
                   huge_value(), 0);
        for (k = 0; k < 3; k++) {
            memset(force, 0, sizeof force);
            memset(motion, 0, sizeof motion);
            force[0].normal = force[1].normal = R(2400 * 9.81);
            *(k ? &force[1].normal : &force[0].tangential) = bad;
            motion[1].vy = R(1);
            *(k == 0   ? &motion[1].vx
              : k == 1 ? &motion[1].vy
                       : &motion[1].spin) = bad;
            CHECK_NEAR(kern_check_forces(world_task(&w, &work), 0, force),
                       huge_value(), 0);
            CHECK_NEAR(kern_check_motion(world_task(&w, &work), 0, motion),
                       huge_value(), 0);
        }
    }
}

/* A stone in mid-air neither stands nor falls if its weight has no square. */
static void proof_out_of_bounds(void)
{
    static const double ground[] = {-1, -1, 1, -1, 0, -0.5};
    static const double masses[] = {1e160, 1e155, 1e300, 1e61, 1e-61, 1e-200};
    static const double loads[] = {-1e200, -1e61, 1e-61, 1e-200};
    const double most = SINGLE ? 1e10 : 1e60;
    static world w;
    kern_structure s;
    kern_work work;
    int i, k;
    for (i = 0; i < 6 + 4; i++) {
        world_reset(&w);
        world_polygon(&w, 0, ground, 3);
        world_box(&w, 1, 0, 5, 1, 6);
        s = structure_of(&w);
        work = work_of(&w);
        if (i < 6) {
            if (SINGLE && !(masses[i] > 1e-30 && masses[i] < 1e30))
                continue;
            w.block[1].mass = R(masses[i]);
        } else {
            if (SINGLE && !(fabs(loads[i - 6]) < 1e30))
                continue;
            s.gravity = vec(0, 0);
            kern_block_load(&w.block[1], vec(0, loads[i - 6]), vec(0.5, 5.5),
                            0);
            if (!(fabs((double)w.block[1].load.fy) > 0))
                continue;
        }
        CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
                  i < 6 ? KERN_BAD_MASS : KERN_BAD_NUMBER);
        CHECK_INT(work.fault.block, 1);
    }
    /* within the bounds: falls, or stands on a bed, as it would in newtons */
    for (i = 0; i < 2; i++)
        for (k = 0; k < 2; k++) {
            world_reset(&w);
            world_box(&w, 0, -1, -1, 2, 0);
            world_box(&w, 1, 0, i, 1, i + 1);
            world_touch(&w);
            w.block[1].mass = R(k ? 0.1 * most : 10 / most);
            CHECK_INT(verdict(&w, 0), i ? KERN_FALLS : KERN_STANDS);
        }
}

/* Sizes: the centre of mass is right, or there is a status. */
static void proof_of_small_stones(void)
{
    const double shape[8] = {0, 0, 3, 0, 3, 1, 0, 1};
    int e;
    for (e = 0; e > -300; e--) {
        const double unit = pow(10, e);
        kern_vec v[4];
        kern_block b;
        kern_status got;
        int i;
        if (SINGLE && e < -36)
            break;
        for (i = 0; i < 4; i++)
            v[i] = vec(unit * shape[2 * i], unit * shape[2 * i + 1]);
        got = kern_ground_init(&b, v, 4, NULL);
        if (e >= (SINGLE ? -9 : -59))
            CHECK_INT(got, KERN_OK);
        if (got != KERN_OK) {
            CHECK_INT(got, KERN_NO_AREA);
            continue;
        }
        CHECK(e >= (SINGLE ? -10 : -60));
        CHECK_NEAR(b.centre.x / R(unit), 1.5, GEO);
        CHECK_NEAR(b.centre.y / R(unit), 0.5, GEO);
    }
}

static const test digits_tests[] = {
    TEST(proof_without_rounding), TEST(proof_far_away),
    TEST(proof_of_no_numbers),    TEST(proof_out_of_bounds),
    TEST(proof_of_small_stones),
};

#endif
