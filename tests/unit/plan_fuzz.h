/* plan_fuzz.h - random sequences of calls on a plan. */

#ifndef UNIT_PLAN_FUZZ_H
#define UNIT_PLAN_FUZZ_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "plan.h"

/* Any sequence of calls on a plan, with what is known spoiled, or kept from long
   ago, relative or not, with a limit of work and with less memory: every answer
   is that of a fresh structure, or the status that says why there is none. */

static struct {
    kern_motion motion[MAX_BLOCKS];
    kern_force force[MAX_POINTS];
    kern_known known; /* its numbers; the arrays are those above */
} plan_then;

static long plan_calls, plan_ends; /* of these ended by limit or memory */

static kern_real plan_rubbish(void)
{
    return chance(0.1) ? KERN_INFINITY
         : chance(0.1) ? R(not_a_number())
                       : R(chance(0.5) ? uniform(-1, 8) : uniform(0, 1));
}

/* Spoils what is known, keeps a copy of it, or goes back to the copy. */
static void plan_spoil(site *p)
{
    kern_known *known = &p->plan.task.known;
    const int i = random_int(0, MAX_BLOCKS / 8);
    const kern_real by = plan_rubbish();
    switch (random_int(0, 7)) {
    case 0: known->fails = 0; break;
    case 1: known->margin = plan_rubbish(); break;
    case 2: known->holds *= by, known->margin *= by, known->fails *= by; break;
    case 3: known->holds += by, known->margin += by, known->fails += by; break;
    case 4: p->motion[i].vx = plan_rubbish(), p->motion[i].spin = by; break;
    case 5: p->force[i].normal = p->force[i + 1].tangential = by; break;
    case 6:
        memcpy(plan_then.motion, p->motion, sizeof p->motion);
        memcpy(plan_then.force, p->force, sizeof p->force);
        plan_then.known = *known;
        break;
    default:
        memcpy(p->motion, plan_then.motion, sizeof p->motion);
        memcpy(p->force, plan_then.force, sizeof p->force);
        known->holds = plan_then.known.holds;
        known->margin = plan_then.known.margin;
        known->fails = plan_then.known.fails;
    }
}

/* A limit, less memory, another gravity, relative or not, or all as it was. */
static void plan_settings(site *p)
{
    kern_task *task = &p->plan.task;
    const int short_of = chance(0.15);
    const int b = task->s.blocks + 1, c = task->s.contacts + 60;
    p->work.reals = short_of ? KERN_LEAN_REALS(b, c)
                             : KERN_REALS(MAX_BLOCKS, MAX_POINTS);
    p->work.indices = short_of ? KERN_LEAN_INTS(b, c)
                               : KERN_INTS(MAX_BLOCKS, MAX_POINTS);
    task->options.limit = chance(0.2) ? (int)pow(10, uniform(0, 4)) : 0;
    if (chance(0.05))
        task->options.relative = !task->options.relative;
    if (chance(0.05))
        task->s.gravity = vec(uniform(-1, 1), -9.81);
}

/* Whether a call ended by its limit, or for want of memory. */
static int plan_ended(const site *p, int got)
{
    const int ended = (got == KERN_LIMIT && p->plan.task.options.limit > 0)
                   || (got == KERN_NO_SPACE
                       && p->work.reals < KERN_REALS(MAX_BLOCKS, MAX_POINTS));
    plan_calls++;
    plan_ends += ended;
    return ended;
}

/* The plan with `more` blocks and `points` contact points behind its own, of
   which nothing is known. */
static void plan_fresh(const site *p, world *t, int more, int points)
{
    site_world(p, t, more, points);
    t->options.limit = 0;
}

/* A measure said `got` and *m: so does a fresh one, or its bracket lies in that
   of one that was ended. */
static void plan_measured(const site *p, int more, int points, int got,
                          const kern_margin *m, const char *where)
{
    static world t;
    kern_margin n;
    int want;
    kern_work work;
    plan_fresh(p, &t, more, points);
    work = work_of(&t);
    memset(&n, 0, sizeof n);
    want = kern_measure(world_task(&t, &work), &n, NULL);
    if (!plan_ended(p, got))
        same_answer(&t, &n, want, m, got, 1, EXACT, where);
    else if (got == KERN_LIMIT && want == KERN_STANDS)
        check_report(m->holds <= n.fails && m->fails >= n.holds, where,
                     "bracket at the limit", (double)m->holds, (double)n.margin,
                     (double)m->fails);
}

/* Checks the proof of what kern_plan_bears() said about t. Where kerns are not
   nested the motion may be one at a smaller margin. */
static void plan_bears_proof(const world *t, int got, kern_real at,
                             const kern_proof *proof)
{
    kern_work work = work_of(t);
    const kern_task *task = world_task(t, &work);
    if (got == KERN_STANDS)
        CHECK(kern_check_forces(task, at, proof->force) <= 1);
    if (got == KERN_FALLS && twin_nested(t))
        CHECK(kern_check_motion(task, at, proof->motion) <= 1);
}

/* A plan begun anew, of the same blocks in the same order, is measured and asked
   the same: it says `got`, and the largest error of a proof is in bounds. */
static void plan_bears_anew(const site *p, const world *t,
                            const kern_block *block, kern_real at, int got)
{
    static site anew;
    kern_margin m;
    int i, said;
    site_open(&anew, p->w);
    anew.plan.task.options = t->options;
    anew.plan.task.s.gravity = t->gravity;
    for (i = 0; i < p->plan.task.s.blocks; i++)
        site_add(&anew, p->number[i]);
    kern_measure(&anew.plan.task, &m, NULL);
    said = kern_plan_bears(&anew.plan, block, at, NULL);
    CHECK(anew.work.error <= 1);
    if (said != got && !open_question(t, (double)at))
        check_near(said, got, 0, HERE, "bears, of a plan begun anew");
}

/* A fresh structure, measured, says `got` about the margin; and, relative, no
   share above 1 is asked for. */
static void plan_bears_fresh(const world *t, kern_real at, int got)
{
    kern_margin n;
    kern_work work = work_of(t);
    int want;
    memset(&n, 0, sizeof n);
    want = kern_measure(world_task(t, &work), &n, NULL);
    if (want == KERN_STANDS && n.margin < at && !n.saturated)
        want = KERN_FALLS;
    if (want >= KERN_UNDECIDED && t->options.relative && at > 1)
        want = KERN_BAD_SHARE;
    if (SINGLE && want == KERN_UNDECIDED)
        return; /* in float a known motion may prove what a measure cannot */
    if (got != want && !open_question(t, (double)at))
        check_near(got, want, 0, HERE, "bears");
}

/* Whether it bears a margin, asked of the plan, of a plan begun anew and of a
   fresh structure: where the known motion begins to fall, or anywhere. */
static void plan_bears(site *p, const kern_block *block, int points)
{
    static world t;
    const double most = p->plan.task.options.relative ? 1.5
                      : chance(0.5)                   ? 0.5
                                                      : 1e-3;
    const kern_real fails = p->plan.task.known.fails;
    const kern_real at = chance(0.3) && fails > 0 && fails < most
                           ? fails
                           : R(uniform(0, most));
    const kern_proof proof = proof_here();
    const int got = kern_plan_bears(&p->plan, block, at, &proof);
    if ((plan_ended(p, got) && got == KERN_NO_SPACE) || got == KERN_LIMIT)
        return;
    plan_fresh(p, &t, 1, points);
    plan_bears_proof(&t, got, at, &proof);
    plan_bears_anew(p, &t, block, at, got);
    plan_bears_fresh(&t, at, got);
}

/* A block that is not in the plan: tried, asked what it bears, raised. */
static void plan_candidate(site *p, const kern_block *block)
{
    static world t;
    kern_margin m;
    kern_raising raising[2] = {KERN_NOT_SHOWN, KERN_NOT_SHOWN};
    int got, points;
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    kern_options unlimited = p->plan.task.options;
    memset(&m, 0, sizeof m);
    site_keep(p);
    got = kern_plan_try(&p->plan, block, &m, NULL);
    site_unchanged(p, HERE);
    p->block[p->plan.task.s.blocks] = *block;
    unlimited.limit = 0;
    points = kern_touch(p->block, p->plan.task.s.blocks, &unlimited,
                        p->contact + p->plan.task.s.contacts, 200, &none);
    if (points < 0) {
        if (!plan_ended(p, got))
            CHECK_INT(got, points);
        return;
    }
    plan_measured(p, 1, points, got, &m, HERE);
    plan_bears(p, block, points);
    got = kern_plan_raised(&p->plan, block, &raising[0], NULL, NULL);
    if (!plan_ended(p, got)) {
        kern_work work;
        plan_fresh(p, &t, 1, points);
        work = work_of(&t);
        CHECK_INT(got, kern_raised(world_task(&t, &work), 0, &raising[1], NULL,
                                   NULL));
        CHECK_INT(raising[0], raising[1]);
    }
}

/* Some calls on one structure. */
static void plan_fuzz_one(const world *w)
{
    static site p;
    kern_margin m;
    int round, got;
    site_open(&p, w);
    p.plan.task.options.epsilon = 0;
    memset(p.motion, 0, sizeof p.motion);
    memset(p.force, 0, sizeof p.force);
    memset(&plan_then, 0, sizeof plan_then);
    for (round = 0; round < 12 + w->blocks; round++) {
        const int number = random_int(0, w->blocks - 1);
        const int at = site_place(&p, number);
        if (chance(0.3))
            plan_spoil(&p);
        plan_settings(&p);
        if (at < 0 && p.plan.task.s.blocks > 0 && !w->given)
            plan_candidate(&p, &w->block[number]);
        if (at < 0)
            site_add(&p, number);
        else if (chance(0.3))
            site_remove(&p, at);
        if (p.plan.task.s.blocks == 0 || chance(0.3))
            continue;
        memset(&m, 0, sizeof m);
        got = kern_measure(&p.plan.task, &m, NULL);
        plan_measured(&p, 0, 0, got, &m, HERE);
    }
}

/* So many calls, on structures from number `first` on. */
static void plan_fuzz_calls(long calls, unsigned long long first)
{
    static world w;
    unsigned long long seed = first;
    plan_calls = plan_ends = 0;
    for (; plan_calls < calls; seed++) {
        const int kind = random_of_kind(&w, seed, 20,
                                        (int)(seed % (KINDS + 1)));
        if (seed % (KINDS + 1) == KINDS && kind < CHAIN) {
            world_reset(&w);
            random_keels(&w, random_int(1, 4));
            w.options.relative = chance(0.5);
        }
        plan_fuzz_one(&w);
    }
    context[0] = 0;
}

static void plan_fuzz(void)
{
    plan_fuzz_calls(quick ? 1000 : 6000, 7300000u);
    CHECK(plan_ends > plan_calls / 50);
}

static const test plan_fuzz_tests[] = {
    TEST(plan_fuzz),
};

#endif
