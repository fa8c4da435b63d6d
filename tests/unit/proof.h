/* proof.h - verdicts and their proofs. */

#ifndef UNIT_PROOF_H
#define UNIT_PROOF_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "verdict.h"
#include "random.h"

static void proof_forces_of_a_cube(void)
{
    static world w;
    double sum = 0, torque = 0;
    int k;
    shifted_cube(&w, 0);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    for (k = 0; k < w.contacts; k++) {
        const double sign = w.contact[k].b == 1 ? 1 : -1;
        sum += (double)force_of[k].normal * (double)w.contact[k].n.y * sign
             + (double)force_of[k].tangential * (double)w.contact[k].n.x * sign;
        torque += (double)force_of[k].normal * ((double)w.contact[k].p.x - 0.5);
    }
    CHECK_NEAR(sum, 9.81, 9.81 * PROOF_TOL);
    CHECK_NEAR(torque, 0, 9.81 * PROOF_TOL);
}

static void proof_free_fall(void)
{
    static world w;
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(&w), 0);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_NEAR(motion_of[0].vy, -1, 100 * EPS);
    CHECK_NEAR(motion_of[0].vx, 0, 1e-6);
    /* neither gravity nor a load: forgotten, most likely */
    w.gravity = vec(0, 0);
    CHECK_INT(verdict(&w, 0), KERN_NO_LOAD);
    kern_block_load(&w.block[0], vec(0, 0), vec(0, 0), R(1));
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK(motion_of[0].spin > 0);
    /* arrays for proofs may be missing, one or both */
    {
        kern_work work = work_of(&w);
        kern_proof none;
        none.force = NULL;
        none.motion = NULL;
        CHECK_INT(kern_verdict(world_task(&w, &work), 0, &none), KERN_FALLS);
        CHECK_INT(kern_verdict(world_task(&w, &work), 0, NULL), KERN_FALLS);
    }
}

/* Which way it goes: a cube beyond the edge turns about the edge, on a slope
   it slides along the slope. */
static void proof_motions_of_a_cube(void)
{
    static world w;
    double foot_x, foot_y;
    shifted_cube(&w, 0.75);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_NEAR(motion_of[0].vx, 0, 0);
    CHECK_NEAR(motion_of[0].vy, 0, 0);
    CHECK_NEAR(motion_of[0].spin, 0, 0);
    CHECK(motion_of[1].vy < 0);
    /* the corner of the lower cube at (1, 1) is not entered */
    foot_x = (double)motion_of[1].vx - (double)motion_of[1].spin * (1 - 1.5);
    foot_y = (double)motion_of[1].vy + (double)motion_of[1].spin * (1 - 1.25);
    CHECK(foot_y >= 0.4 * fabs(foot_x) - 1e-5);
}

/* Damages one contact's force, in the way of a trial 0 .. 7. */
static void damage_forces(const world *w, kern_force *f, int trial, double by)
{
    const int k = random_int(0, w->contacts - 1);
    const double push = by * (double)own_total(w);
    if (trial < 4)
        f[k].normal += R(push);
    else if (trial < 6)
        f[k].tangential += R(push);
    else if (trial == 6)
        f[k].normal = R(-1e-6);
    else
        f[k].tangential = R(not_a_number());
}

/* Damages one block's motion, or that of all, in the way of a trial 0 .. 7. */
static void damage_motion(const world *w, kern_motion *y, int trial, double by)
{
    int k;
    do
        k = random_int(0, w->blocks - 1);
    while (w->block[k].fixed);
    if (trial < 2)
        y[k].vx += R(by);
    else if (trial < 4)
        y[k].vy += R(by);
    else if (trial == 4)
        y[k].spin += R(by);
    else if (trial == 5)
        for (k = 0; k < w->blocks; k++) {
            y[k].vx = -y[k].vx;
            y[k].vy = -y[k].vy;
            y[k].spin = -y[k].spin;
        }
    else if (trial == 6)
        memset(y, 0, sizeof *y * (size_t)w->blocks);
    else
        y[k].spin = R(huge_value());
}

/* What the speeds of a motion at the contacts lose by roundings in the library's
   precision, in its measure of a proof: a share of what is allowed. */
static double rounded_share(const world *w, const kern_motion *y)
{
    wide power = 0, weight = 0, most = 0;
    int i, k, end;
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        if (b->fixed)
            continue;
        weight += own_weight(w, i);
        power += ((wide)b->mass * w->gravity.x + b->load.fx) * y[i].vx
               + ((wide)b->mass * w->gravity.y + b->load.fy) * y[i].vy
               + (wide)b->load.torque * y[i].spin;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        wide gap = 0;
        for (end = 0; end < 2; end++) {
            const kern_motion *v = &y[end ? c->b : c->a];
            const kern_vec centre = w->block[end ? c->b : c->a].centre;
            gap += fabs((double)v->vx) + fabs((double)v->vy)
                 + fabs((double)v->spin)
                       * (fabs((double)(c->p.x - centre.x))
                          + fabs((double)(c->p.y - centre.y)));
        }
        gap *= (1 + c->mu) * 4;
        most = gap > most ? gap : most;
    }
    return power > 0
             ? (double)((SINGLE ? 1e3 : 1e6) * weight * EPS * most / power)
             : huge_value();
}

/* A damaged proof, measured by the test (*own) and by the library (*theirs).
   Nonzero: there is nothing to damage, or roundings decide. */
static int damaged(const world *w, int verdict_was, int trial, double *own,
                   double *theirs)
{
    static kern_force f[MAX_POINTS];
    static kern_motion y[MAX_BLOCKS];
    kern_work work = work_of(w);
    const double by = pow(10, uniform(-14, 0)) * (chance(0.5) ? 1 : -1);
    if (verdict_was == KERN_STANDS) {
        if (w->contacts == 0)
            return 1;
        memcpy(f, force_of, sizeof *f * (size_t)w->contacts);
        damage_forces(w, f, trial, by);
        *own = share_of_forces(w, 0, f);
        *theirs = (double)kern_check_forces(world_task(w, &work), 0, f);
    } else {
        memcpy(y, motion_of, sizeof *y * (size_t)w->blocks);
        damage_motion(w, y, trial, by);
        *own = share_of_motion(w, 0, y);
        *theirs = (double)kern_check_motion(world_task(w, &work), 0, y);
        return *own < 0.5 && rounded_share(w, y) > 0.5;
    }
    return 0;
}

/* Damage is found, by the measure of the test's own check. */
static void proof_damage(void)
{
    static world w;
    int seed, trial, good = 0, bad = 0;
    for (seed = 0; seed < 400; seed++) {
        int got;
        random_world(&w, 500000u + (unsigned long long)seed, 12);
        got = verdict(&w, 0);
        for (trial = 0; trial < 8; trial++) {
            double own, theirs;
            if (damaged(&w, got, trial, &own, &theirs))
                continue;
            /* between a half and twice the allowed, roundings may decide */
            if (own < 0.5 && !(SINGLE && own > 1e-3)) {
                CHECK(theirs <= 1);
                good++;
            }
            if (own > (SINGLE ? 20 : 2)) {
                CHECK(theirs > 1);
                bad++;
            }
        }
    }
    context[0] = 0;
    CHECK(good > 100 && bad > 500);
}

/* A fixed block that moves proves nothing. */
static void proof_of_a_fixed_block(void)
{
    static world w;
    kern_work work;
    shifted_cube(&w, 0.75);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    work = work_of(&w);
    motion_of[0].vx = R(1e-3);
    CHECK(kern_check_motion(world_task(&w, &work), 0, motion_of) > 1);
}

/* Forces of the right sum that the bodies could never press: too large. */
static void proof_too_large(void)
{
    static world w;
    kern_force f[4];
    kern_work work;
    int side, k;
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 0, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 4);
    world_friction(&w, 1);
    work = work_of(&w);
    for (side = 0; side < 2; side++) {
        const double press = (side ? 100 : 0.05) * FORCE_BOUND * W;
        for (k = 0; k < 4; k++) {
            /* normals are horizontal: t is up where n points right */
            const double up = (w.contact[k].b == 1 ? 1 : -1)
                            * (double)w.contact[k].n.x;
            f[k].normal = R(press);
            f[k].tangential = R(W / 4 * up);
        }
        CHECK_INT(kern_check_forces(world_task(&w, &work), 0, f) <= 1, !side);
    }
}

static const test proof_tests[] = {
    TEST(proof_forces_of_a_cube),  TEST(proof_free_fall),
    TEST(proof_motions_of_a_cube), TEST(proof_damage),
    TEST(proof_of_a_fixed_block),  TEST(proof_too_large),
};

#endif
