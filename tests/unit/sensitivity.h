/* sensitivity.h - rates of the margin. */

#ifndef UNIT_SENSITIVITY_H
#define UNIT_SENSITIVITY_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"

static kern_contact_rate contact_rate[MAX_POINTS];
static kern_block_rate block_rate[MAX_BLOCKS];

/* The margin, with its sensitivity if `rates`; 0 where there is none. */
static double margin_rates(const world *w, int rates)
{
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    const kern_proof proof = proof_here();
    kern_margin m;
    if (kern_measure(task, &m, &proof) != KERN_STANDS || m.saturated)
        return 0;
    if (rates
        && kern_sensitivity(task, &m, &proof, contact_rate, block_rate)
               != KERN_OK)
        return 0;
    return (double)m.margin;
}

/* A cube whose centre is .1 off the middle of its bed falls at .4: the centre,
   and the far end of the bed, count once each, in opposite directions. Turned
   about its centre, .5 above the bed, it takes that end along by half of that. */
static void sensitivity_by_hand(void)
{
    static world w;
    int k;
    one_cube(&w);
    w.block[1].centre.x += R(0.1);
    CHECK_NEAR(margin_rates(&w, 1), 0.4, 2 * EDGE);
    CHECK_NEAR(block_rate[1].centre.x, -1, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].centre.y, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].mass, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].place.x, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].turn, 0.5, SINGLE ? 0.02 : 1e-3);
    for (k = 0; k < 2; k++)
        CHECK_NEAR(contact_rate[k].p.x, w.contact[k].p.x > R(0.5),
                   SINGLE ? 0.02 : 1e-3);
}

/* Lines of which an end lost its travel, its sign or its partner, the last one
   of the array too: an end is taken for another's only where that exists. What
   is marked as a line and has no partner has the rates of a point. */
static void sensitivity_of_odd_lines(void)
{
    static world w;
    int seed, k, cases = 0;
    for (seed = 0; seed < some(300); seed++) {
        kern_contact_rate *rate;
        kern_work work;
        kern_task *task;
        kern_margin m;
        kern_proof proof = proof_here();
        if (!random_world(&w, 7300u + (unsigned long long)seed, 8)
            || w.contacts < 2)
            continue;
        for (k = 0; k < w.contacts; k++) {
            kern_contact *c = &w.contact[k];
            c->line = chance(0.2) ? !c->line : c->line;
            c->travel = chance(0.2) ? 0 : chance(0.2) ? -c->travel : c->travel;
        }
        w.contact[w.contacts - 1].line = 1;
        work = work_of(&w);
        task = world_task(&w, &work);
        if (kern_measure(task, &m, &proof) != KERN_STANDS || m.saturated)
            continue;
        /* an array of its own size: nothing behind it is read or written */
        rate = malloc(sizeof *rate * (size_t)w.contacts);
        CHECK(rate != NULL);
        if (rate
            && kern_sensitivity(task, &m, &proof, rate, block_rate)
                   == KERN_OK) {
            cases++;
            for (k = 0; k < w.blocks; k++)
                CHECK(isfinite((double)block_rate[k].place.x)
                      && isfinite((double)block_rate[k].turn));
        }
        free(rate);
    }
    CHECK(cases > some(15));
    context[0] = 0;
}

/* The bed of sensitivity_by_hand() as points: the same rates. */
static void sensitivity_of_points(void)
{
    static world w;
    int k;
    for (k = 0; k < 2; k++) {
        static kern_block_rate keep[MAX_BLOCKS];
        int b;
        one_cube(&w);
        w.block[1].centre.x += R(0.1);
        w.contact[0].line = 0;
        w.contact[1].line = k;
        CHECK(margin_rates(&w, 1) > 0);
        for (b = 0; b < w.blocks && k; b++) {
            CHECK_NEAR(block_rate[b].place.x, keep[b].place.x,
                       SINGLE ? 0.02 : 1e-3);
            CHECK_NEAR(block_rate[b].turn, keep[b].turn, SINGLE ? 0.02 : 1e-3);
        }
        memcpy(keep, block_rate, sizeof keep);
    }
}

/* Changes one datum by a step; returns the rate that belongs to it. */
static double nudge(world *w, int kind, int k, int b, double size, double *step)
{
    kern_contact *c = &w->contact[k];
    kern_block *block = &w->block[b];
    const double one = *step * 1e-5, h = one * size;
    const double cosine = cos(one), sine = sin(one);
    const kern_vec n = c->n;
    *step = h;
    switch (kind) {
    case 0: c->p.x += R(h); return (double)contact_rate[k].p.x;
    case 1: c->p.y += R(h); return (double)contact_rate[k].p.y;
    case 2:
        *step = one;
        c->n = vec((double)n.x * cosine - (double)n.y * sine,
                   (double)n.y * cosine + (double)n.x * sine);
        return (double)contact_rate[k].turn;
    case 3:
        *step = one;
        c->mu += R(one);
        return (double)contact_rate[k].mu;
    case 4: /* the load stays where it is */
        block->centre.x += R(h);
        block->load.torque -= R(h) * block->load.fy;
        return (double)block_rate[b].centre.x;
    case 5:
        *step = one * (double)block->mass;
        block->mass += R(*step);
        return (double)block_rate[b].mass;
    default:
        *step = one * (double)block->mass;
        block->load.fx += R(*step);
        return (double)block_rate[b].load.fx;
    }
}

static void sensitivity_random(void)
{
    static world w, now;
    unsigned long long seed;
    int good = 0, asked_here = 0;
    for (seed = 1; seed < 4000 && asked_here < 1000 && !SINGLE; seed++) {
        double margin, size, step, rate, change[2];
        int i;
        if (!random_world(&w, seed, 12) || !twin_nested(&w))
            continue;
        w.options.relative = 0;
        size = mean_size(&w);
        margin = margin_rates(&w, 1);
        if (!(margin > 0.001 * size))
            continue;
        for (i = 0; i < 6; i++) {
            const int k = random_int(0, w.contacts - 1);
            const int b = random_int(0, w.blocks - 1);
            const int kind = random_int(0, 6);
            int side, close;
            if (w.block[b].fixed)
                continue;
            for (side = -1, close = 0; side <= 1; side += 2) {
                step = side;
                world_copy(&now, &w);
                rate = nudge(&now, kind, k, b, size, &step) * step;
                change[side > 0] = margin_rates(&now, 0) - margin;
                close |= fabs(change[side > 0] - rate)
                      <= 0.01 * fabs(rate) + 1e-8 * size;
            }
            if (fabs(change[0] + change[1])
                > 0.01 * fabs(change[1]) + 1e-8 * size)
                continue; /* several mechanisms are critical */
            good += close;
            asked_here++;
        }
    }
    CHECK(SINGLE || asked_here >= 1000);
    CHECK(good >= asked_here * 95 / 100);
}

/* Moves block b by a share of the size, or turns it about its centre, with the
   load where it is, and finds its contacts anew; returns the rate that belongs
   to it. */
static double displace(world *w, int kind, int b, double size, double *step)
{
    kern_block *block = &w->block[b];
    kern_vec *v = w->vertex + (block->vertex - w->vertex);
    const kern_block was = *block;
    const double h = *step * size, cosine = cos(*step), sine = sin(*step);
    int i;
    *step = kind == 2 ? *step : h;
    for (i = 0; i < block->vertices; i++) {
        const double x = (double)(v[i].x - was.centre.x);
        const double y = (double)(v[i].y - was.centre.y);
        v[i] = kind == 2 ? vec((double)was.centre.x + x * cosine - y * sine,
                               (double)was.centre.y + y * cosine + x * sine)
                         : vec((double)v[i].x + (kind == 0) * h,
                               (double)v[i].y + (kind == 1) * h);
    }
    if (was.fixed)
        kern_ground_init(block, v, was.vertices, NULL);
    else
        kern_block_init(block, v, was.vertices, 1, NULL);
    block->mass = was.mass;
    block->load = was.load;
    block->centre = was.centre;
    block->centre.x += R(kind == 0) * R(h);
    block->centre.y += R(kind == 1) * R(h);
    block->load.torque -= R(kind == 0) * R(h) * was.load.fy
                        - R(kind == 1) * R(h) * was.load.fx;
    world_touch(w);
    return (double)(kind == 0   ? block_rate[b].place.x
                    : kind == 1 ? block_rate[b].place.y
                                : block_rate[b].turn);
}

/* Whether a kern that carries a force is about to close at the margin. */
static int kern_closes(const world *w, double margin, double size)
{
    int k, closes = 0;
    for (k = 0; k < w->contacts; k++)
        closes |= fabs(fabs((double)w->contact[k].travel) - margin)
                < 1e-3 * size;
    return closes;
}

/* Moves every free stone a little, so that no two corners coincide. */
static void shake_up(world *w, double size)
{
    int i;
    for (i = 0; i < 3 * w->blocks; i++) {
        double step = uniform(-1e-4, 1e-4);
        if (!w->block[i / 3].fixed)
            displace(w, i % 3, i / 3, size, &step);
    }
}

/* Does the margin of w change as its rates say when block b is moved or turned a
   little? Contacts are found again, so the difference is one-sided. -1 where it
   rests while others move. */
static int moves_as_said(const world *w, double margin, int kind, int b,
                         double step)
{
    static world now;
    const double size = mean_size(w);
    double said, by;
    int alike;
    world_copy(&now, w);
    said = displace(&now, kind, b, size, &step) * step;
    by = margin_rates(&now, 0) - margin;
    alike = fabs(by - said) <= 0.01 * fabs(said) + 1e-9 * size;
    return now.contacts != w->contacts || (alike && fabs(said) < 1e-9 * size)
             ? -1
             : alike;
}

static void sensitivity_of_poses(void)
{
    static world w;
    unsigned long long seed;
    int good[3] = {0, 0, 0}, all[3] = {0, 0, 0}, kind;
    for (seed = 1; seed < 20000 && all[2] < some(1000) && !SINGLE; seed++) {
        double margin, size;
        int i;
        if (!random_world(&w, seed, 12) || w.given)
            continue;
        w.options.relative = 0;
        size = mean_size(&w);
        shake_up(&w, size);
        if (w.contacts < 0 || !twin_nested(&w))
            continue;
        margin = margin_rates(&w, 1);
        if (!(margin > 0.001 * size) || kern_closes(&w, margin, size))
            continue;
        for (i = 0; i < 12; i++) {
            const int b = random_int(0, w.blocks - 1);
            const int good_now = moves_as_said(&w, margin, i % 3, b,
                                               i < 6 ? 1e-6 : -1e-6);
            good[i % 3] += good_now > 0;
            all[i % 3] += good_now >= 0;
        }
    }
    for (kind = 0; kind < 3; kind++) {
        CHECK(SINGLE || all[kind] >= some(700));
        CHECK(100 * good[kind] >= 95 * all[kind]);
    }
}

/* All sensitivities of a structure cost less than a twentieth of its margin:
   the least of up to 30 runs over many. */
static void sensitivity_cost(void)
{
    static world w;
    const kern_proof proof = proof_here();
    double least[2] = {HUGE_VAL, HUGE_VAL};
    int run, k;
    for (run = 0;
         run < (SINGLE ? 0 : 30) && (run == 0 || least[1] > 0.05 * least[0]);
         run++) {
        clock_t spent[2] = {0, 0};
        unsigned long long seed;
        for (seed = 1; seed < 400; seed++) {
            kern_margin m;
            clock_t at[3];
            kern_work work;
            random_world(&w, seed, 40);
            work = work_of(&w);
            at[0] = clock();
            if (kern_measure(world_task(&w, &work), &m, &proof) != KERN_STANDS)
                continue;
            at[1] = clock();
            kern_sensitivity(world_task(&w, &work), &m, &proof, contact_rate,
                             block_rate);
            at[2] = clock();
            for (k = 0; k < 2; k++)
                spent[k] += at[k + 1] - at[k];
        }
        for (k = 0; k < 2; k++)
            least[k] = fmin(least[k], (double)spent[k]);
    }
    CHECK(SINGLE || least[1] <= 0.05 * least[0]);
}

static const test sensitivity_tests[] = {
    TEST(sensitivity_by_hand),   TEST(sensitivity_of_odd_lines),
    TEST(sensitivity_of_points), TEST(sensitivity_random),
    TEST(sensitivity_of_poses),  TEST(sensitivity_cost),
};

#endif
