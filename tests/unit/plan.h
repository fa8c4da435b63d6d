/* plan.h - plans, and the critical parts of a structure. */

#ifndef UNIT_PLAN_H
#define UNIT_PLAN_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"

/* A plan of blocks of a world, with the memory of everything it holds.
   Contacts of blocks without a polygon are appended by hand, as a planner with
   a camera would do it. */
typedef struct site {
    kern_block block[MAX_BLOCKS];
    kern_contact contact[MAX_POINTS];
    kern_motion motion[MAX_BLOCKS];
    kern_force force[MAX_POINTS];
    int number[MAX_BLOCKS]; /* in the world, of the plan's blocks */
    kern_real real[KERN_REALS(MAX_BLOCKS, MAX_POINTS)];
    int index[KERN_INTS(MAX_BLOCKS, MAX_POINTS)];
    kern_work work;
    kern_plan plan;
    const world *w;
} site;

static void site_open(site *p, const world *w)
{
    p->w = w;
    p->work = kern_work_of(p->real, KERN_REALS(MAX_BLOCKS, MAX_POINTS),
                           p->index, KERN_INTS(MAX_BLOCKS, MAX_POINTS));
    p->plan = kern_plan_of(p->block, MAX_BLOCKS, p->contact, MAX_POINTS,
                           kern_known_of(p->motion, p->force), &p->work);
    p->plan.task.options = w->options;
    p->plan.task.s.gravity = w->gravity;
}

/* Where block `number` of the world is in the plan; -1: nowhere. */
static int site_place(const site *p, int number)
{
    int i;
    for (i = 0; i < p->plan.task.s.blocks; i++)
        if (p->number[i] == number)
            return i;
    return -1;
}

static void site_add(site *p, int number)
{
    const world *w = p->w;
    const int last = p->plan.task.s.blocks, before = p->plan.task.s.contacts;
    const int limit = p->plan.task.options.limit;
    int found, k;
    p->plan.task.options.limit = 0;
    found = kern_plan_add(&p->plan, &w->block[number]);
    p->plan.task.options.limit = limit;
    CHECK(found >= 0);
    CHECK_INT(p->plan.task.s.blocks, last + 1);
    CHECK_INT(p->plan.task.s.contacts, before + found);
    for (k = 0; w->given && k < w->contacts; k++) {
        kern_contact c = w->contact[k];
        const int turned = c.a == number;
        const int other = site_place(p, turned ? c.b : c.a);
        if ((c.a != number && c.b != number) || other < 0)
            continue;
        c.a = turned ? last : other;
        c.b = turned ? other : last;
        p->contact[p->plan.task.s.contacts++] = c;
    }
    p->number[last] = number;
}

/* A plan of the first blocks of a world. */
static void site_with(site *p, const world *w, int blocks)
{
    int i;
    site_open(p, w);
    for (i = 0; i < blocks; i++)
        site_add(p, i);
}

static void site_remove(site *p, int i)
{
    const int blocks = p->plan.task.s.blocks;
    CHECK_INT(kern_plan_remove(&p->plan, i), KERN_OK);
    CHECK_INT(p->plan.task.s.blocks, blocks - 1);
    memmove(p->number + i, p->number + i + 1,
            sizeof *p->number * (size_t)(blocks - 1 - i));
}

/* The plan as a world: its blocks and `more` of those behind them, with
   contacts `points` behind its own. */
static void site_world(const site *p, world *t, int more, int points)
{
    world_reset(t);
    t->blocks = p->plan.task.s.blocks + more;
    t->contacts = p->plan.task.s.contacts + points;
    t->gravity = p->plan.task.s.gravity;
    t->options = p->plan.task.options;
    memcpy(t->block, p->block, sizeof *t->block * (size_t)t->blocks);
    memcpy(t->contact, p->contact, sizeof *t->contact * (size_t)t->contacts);
}

/* What has been found block by block is what is found at once. */
static void site_contacts(const site *p)
{
    static world t;
    int k;
    if (p->w->given || SINGLE) /* in float the rounding of far blocks counts */
        return;
    site_world(p, &t, 0, 0);
    CHECK_INT(world_touch(&t), p->plan.task.s.contacts);
    for (k = 0; k < t.contacts && k < p->plan.task.s.contacts; k++)
        CHECK(same_contact(&t.contact[k], &p->contact[k]));
}

/* An answer about the plan, its proofs in force_of and motion_of, is that of a
   fresh structure: t. */
static int site_answer(const site *p, const world *t, int got,
                       const kern_margin *m, const char *where)
{
    kern_work work = work_of(t);
    kern_margin n;
    int now;
    check_measure(t, got, m, &p->work);
    if (got == KERN_STANDS)
        CHECK(kern_check_forces(world_task(t, &work), m->holds, force_of) <= 1);
    if (got == KERN_FALLS)
        CHECK(kern_check_motion(world_task(t, &work), 0, motion_of) <= 1);
    if (got == KERN_STANDS && !m->saturated)
        CHECK(kern_check_motion(world_task(t, &work), m->fails, motion_of)
              <= 1);
    now = measure(t, &n);
    same_answer(t, &n, now, m, got, 1, EXACT, where);
    return now;
}

static void site_forget_counts(site *p)
{
    p->work.pivots = p->work.solves = 0;
    p->work.error = 0;
    memset(force_of, 0xff, sizeof force_of);
    memset(motion_of, 0xff, sizeof motion_of);
}

/* kern_measure() of a plan, compared. */
static int site_measure(site *p, kern_margin *m)
{
    static world t;
    const kern_proof proof = proof_here();
    int got;
    memset(m, 0, sizeof *m);
    site_forget_counts(p);
    got = kern_measure(&p->plan.task, m, &proof);
    site_world(p, &t, 0, 0);
    site_answer(p, &t, got, m, HERE);
    return got;
}

/* A copy of all that a plan holds, and whether it still is as it was, byte for
   byte. */
static struct {
    kern_plan plan;
    kern_block block[MAX_BLOCKS];
    kern_contact contact[MAX_POINTS];
    kern_motion motion[MAX_BLOCKS];
} site_was;

static void site_keep(const site *p)
{
    memcpy(&site_was.plan, &p->plan, sizeof site_was.plan);
    memcpy(site_was.block, p->block,
           sizeof *p->block * (size_t)p->plan.task.s.blocks);
    memcpy(site_was.contact, p->contact,
           sizeof *p->contact * (size_t)p->plan.task.s.contacts);
    memcpy(site_was.motion, p->motion,
           sizeof *p->motion * (size_t)p->plan.task.s.blocks);
}

static void site_unchanged(const site *p, const char *where)
{
    const size_t b = (size_t)site_was.plan.task.s.blocks,
                 c = (size_t)site_was.plan.task.s.contacts;
    check_report(
        !memcmp(&p->plan, &site_was.plan, sizeof site_was.plan)
            && !memcmp(p->block, site_was.block, sizeof *p->block * b)
            && !memcmp(p->contact, site_was.contact, sizeof *p->contact * c)
            && !memcmp(p->motion, site_was.motion, sizeof *p->motion * b),
        where, "the plan is as it was", 0, 0, 0);
}

/* kern_plan_bears() beside the margin that kern_plan_try() gave: with proofs,
   and nothing that the plan holds changes. */
static void site_bears(site *p, const kern_block *block, int got,
                       const kern_margin *m, int found)
{
    const kern_proof proof = proof_here();
    const int b = p->plan.task.s.blocks, c = p->plan.task.s.contacts;
    const kern_real aside = R(2e-6) * kern_mean_size(p->block, b + 1);
    kern_structure s = p->plan.task.s;
    int side;
    if (got < 0)
        return;
    s.blocks = b + 1;
    s.contacts = c + found;
    site_keep(p);
    for (side = 0; side < 2; side++) {
        const kern_real at = got == KERN_FALLS ? R(0)
                           : side              ? m->fails + aside
                                  : kern_max(m->holds - aside, R(0));
        const int want = got == KERN_FALLS || side ? KERN_FALLS : KERN_STANDS;
        int said;
        if (side && m->saturated)
            break;
        said = kern_plan_bears(&p->plan, block, at, &proof);
        site_unchanged(p, HERE);
        if (SINGLE && said != want) /* both proofs may hold over some way */
            continue;
        CHECK_INT(said, want);
        p->block[b] = *block; /* the proof is of the plan with the block */
        if (said == KERN_STANDS)
            CHECK(
                kern_check_forces(task_of(&s, &p->plan.task.options, &p->work),
                                  at, proof.force)
                <= 1);
        else if (p->w->options.relative == 0)
            CHECK(
                kern_check_motion(task_of(&s, &p->plan.task.options, &p->work),
                                  at, proof.motion)
                    <= 1
                || side);
    }
}

/* kern_plan_try(), compared; and nothing else that the plan holds changes. */
static int site_try(site *p, const kern_block *block, kern_margin *m)
{
    static kern_contact one[MAX_POINTS];
    static world t;
    const kern_proof proof = proof_here();
    const int b = p->plan.task.s.blocks, c = p->plan.task.s.contacts;
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    int got, found, k;
    site_keep(p);
    memset(m, 0, sizeof *m);
    site_forget_counts(p);
    got = kern_plan_try(&p->plan, block, m, &proof);
    site_unchanged(p, HERE);
    p->block[b] = *block;
    found = kern_touch(p->block, b, &p->plan.task.options, one, MAX_POINTS,
                       &none);
    if (found < 0) {
        CHECK_INT(got, found);
        CHECK_INT(p->work.fault.block, none.fault.block);
        CHECK_INT(p->work.fault.other, none.fault.other);
        return got;
    }
    for (k = 0; k < found; k++)
        CHECK(same_contact(&p->contact[c + k], &one[k]));
    site_world(p, &t, 1, found);
    site_answer(p, &t, got, m, HERE);
    site_bears(p, block, got, m, found);
    return got;
}

/* Stones on points with two normals to an interface: a keel that lies with
   two corners in a notch, and on its flat back the next notched stone. */
static void random_keels(world *w, int pairs)
{
    const double lean = uniform(0.3, 0.9), r = uniform(0.3, 0.6);
    double y = 0, x = 0;
    int i;
    world_box(w, 0, -9, -1, 9, 0);
    for (i = 0; i < pairs; i++) {
        const double high = tan(lean) + uniform(0.1, 0.3);
        const double s = r * sin(lean), c = r * cos(lean);
        double notch[10], keel[8], axis;
        x += uniform(-0.1, 0.1);
        notch[0] = notch[8] = x - 1;
        notch[2] = notch[4] = x + 1;
        notch[1] = notch[3] = y;
        notch[5] = notch[9] = y + high;
        notch[6] = x;
        notch[7] = y + high - tan(lean);
        world_polygon(w, uniform(1, 2), notch, 5);
        axis = notch[7] + r / cos(lean);
        keel[0] = x - s;
        keel[2] = x + s;
        keel[1] = keel[3] = axis - c;
        keel[4] = x + s + uniform(0.05, 0.15);
        keel[6] = x - s - uniform(0.05, 0.15);
        y = fmax(axis, y + high) + 0.3;
        keel[5] = keel[7] = y;
        world_polygon(w, uniform(1, 2), keel, 4);
    }
    CHECK(world_touch(w) > 0);
}

/* Block after block, as they were made or in any order. Before each is added
   it is tried; whether the plan has been measured lately makes no difference
   to any answer. */
static void plan_grow(const world *w, int shuffle)
{
    static site p;
    int order[MAX_BLOCKS], i;
    for (i = 0; i < w->blocks; i++)
        order[i] = i;
    for (i = w->blocks - 1; shuffle && i > 0; i--) {
        const int j = random_int(0, i), keep = order[i];
        order[i] = order[j];
        order[j] = keep;
    }
    site_open(&p, w);
    for (i = 0; i < w->blocks; i++) {
        kern_margin m;
        if (!w->given || chance(0.1)) /* what has no polygon hangs in the air */
            site_try(&p, &w->block[order[i]], &m);
        site_add(&p, order[i]);
        site_contacts(&p);
        if (chance(0.8))
            site_measure(&p, &m);
    }
}

static void plan_random(void)
{
    static world w;
    int seed, kind;
    for (seed = 0; seed < some(120); seed++)
        for (kind = 0; kind < KINDS; kind++) {
            random_of_kind(&w, 700000u + (unsigned long long)seed,
                           seed % 4 ? 12 : 30, kind);
            plan_grow(&w, seed % 2);
        }
    context[0] = 0;
}

static void plan_points(void)
{
    static world w;
    int seed, apart = 0;
    for (seed = 0; seed < some(120); seed++) {
        random_seed(710000u + (unsigned long long)seed);
        sprintf(context, "(keels %d)", seed);
        world_reset(&w);
        w.options.mu = R(uniform(0.2, 1));
        w.options.relative = chance(0.3);
        random_keels(&w, random_int(1, 4));
        if (chance(0.5))
            w.gravity = vec(9.81 * uniform(-0.1, 0.1), -9.81);
        apart += !twin_nested(&w);
        plan_grow(&w, seed % 2);
    }
    context[0] = 0;
    CHECK_INT(apart, some(120));
}

/* Blocks go and come back, wherever they are; every answer is that of a fresh
   structure. */
static void plan_changes(void)
{
    static world w;
    static site p;
    int seed, i, round;
    for (seed = 0; seed < some(240); seed++) {
        kern_margin m;
        random_of_kind(&w, 720000u + (unsigned long long)seed, 25,
                       seed % KINDS);
        site_with(&p, &w, w.blocks);
        for (round = 0; round < 8; round++) {
            int gone[3], n = 0;
            for (i = random_int(1, 3); i > 0 && p.plan.task.s.blocks > 1; i--) {
                const int last = p.plan.task.s.blocks - 1;
                const int at = chance(0.3) ? last
                             : chance(0.3) ? 0
                                           : random_int(0, last);
                gone[n++] = p.number[at];
                site_remove(&p, at);
            }
            if (chance(0.6))
                site_measure(&p, &m);
            while (n > 0)
                site_add(&p, gone[--n]);
            if (chance(0.6))
                site_measure(&p, &m);
            site_contacts(&p);
        }
    }
    context[0] = 0;
}

/* A slab on a pillar: half of the bed less the way from its middle to where
   the load passes. A candidate moves that place, or has a place of its own. */
static void slab_on_pillar(world *w)
{
    world_reset(w);
    world_box(w, 0, -9, -1, 9, 0);
    world_box(w, 1, 0, 0, 1, 1);
    world_box(w, 1, -0.2, 1, 1.4, 1.2);
    world_touch(w);
}

static kern_block candidate(world *w, double density, double x, double y,
                            double size)
{
    const int i = world_box(w, density, x, y, x + size, y + size);
    w->blocks = i;
    return w->block[i];
}

/* The plan of a slab on a pillar, measured. Returns a candidate upon it. */
static kern_block on_slab(world *w, site *p, double x)
{
    kern_block b;
    kern_margin m;
    slab_on_pillar(w);
    b = candidate(w, 1, x, 1.2, 0.2);
    site_with(p, w, w->blocks);
    CHECK_INT(site_measure(p, &m), KERN_STANDS);
    return b;
}

static void plan_candidates(void)
{
    static world w;
    static site p;
    static const struct {
        double density, x, y, margin; /* < 0: it falls */
    } tries[] = {
        {1, 1.2, 1.2, 0.5 - 0.064 / 0.36},  /* lower */
        {1, -0.2, 1.2, 0.5 - 0.008 / 0.36}, /* higher */
        {1, 5, 0, 0.4},                     /* the same */
        {10, 1.2, 1.2, 0.5 - 0.352 / 0.72}, /* hardly any */
        {20, 1.2, 1.2, -1},                 /* over the edge */
        {1, 3, 2, -1},                      /* hangs on nothing */
        {0, 3, 2, 0.4},                     /* so does ground */
    };
    kern_margin m, first;
    int i, round;
    slab_on_pillar(&w);
    site_with(&p, &w, w.blocks);
    for (round = 0; round < 2; round++) { /* of a plan not measured, measured */
        for (i = 0; i < COUNT_OF(tries); i++) {
            const kern_block b = candidate(&w, tries[i].density, tries[i].x,
                                           tries[i].y, 0.2);
            const int got = site_try(&p, &b, &m);
            CHECK_INT(got, tries[i].margin < 0 ? KERN_FALLS : KERN_STANDS);
            if (got == KERN_STANDS)
                CHECK_NEAR(m.margin, tries[i].margin, EXACT);
        }
        CHECK_INT(site_measure(&p, &first), KERN_STANDS);
        CHECK_NEAR(first.margin, 0.4, EXACT);
    }
    for (i = 0; i < 2; i++) {
        const kern_block b = candidate(&w, 1, 1.2, 1.2 - 0.1 * (i + 1), 0.2);
        CHECK_INT(site_try(&p, &b, &m), KERN_OVERLAP);
        CHECK_INT(p.work.fault.block, 2);
        CHECK_INT(p.work.fault.other, 3);
    }
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, first.margin, EXACT);
}

/* Cubes that stand exactly above each other stand with every kern closed;
   then one does not, and is taken away again. */
static void plan_saturated(void)
{
    static world w;
    static site p;
    kern_margin m;
    int i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    for (i = 0; i < 6; i++)
        world_box(&w, 1, 0, i, 1, i + 1);
    world_box(&w, 1, 0.25, 6, 1.25, 7);
    world_touch(&w);
    site_open(&p, &w);
    for (i = 0; i < 7; i++) {
        site_add(&p, i);
        CHECK_INT(site_measure(&p, &m), i ? KERN_STANDS : KERN_NO_FREE);
        CHECK(i == 0 || m.saturated);
    }
    CHECK_INT(site_try(&p, &w.block[7], &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.25, EXACT);
    site_add(&p, 7);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.25, EXACT);
    site_remove(&p, 7);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK(m.saturated);
    site_remove(&p, 3); /* what was above it hangs in the air */
    CHECK_INT(site_measure(&p, &m), KERN_FALLS);
    site_add(&p, 3);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK(m.saturated);
}

/* Blocks and contacts taken back by hand, and garbage in the work memory: the
   plan goes on with less than it knew, and answers the same. */
/* A search for contacts that the limit ends: nothing is proven of the plan with
   the stone, and the plan is as it was. */
static void plan_limits(void)
{
    static world w;
    static site p;
    static kern_vec v[2][500];
    kern_margin m;
    kern_real chance = 0, reserve = 0;
    kern_raising raising = KERN_RAISED;
    int i, b, k = 0;
    world_reset(&w);
    for (b = 0; b < 2; b++) {
        for (i = k = 0; i <= 400; i++)
            v[b][k++] = vec(i, i % 2);
        v[b][k++] = vec(400, b ? 200 : -200);
        v[b][k++] = vec(0, b ? 200 : -200);
        CHECK_INT(kern_block_init(&w.block[b], v[b], k, R(1), NULL), KERN_OK);
    }
    w.block[0].fixed = 1;
    w.blocks = 2;
    site_open(&p, &w);
    site_add(&p, 0);
    p.plan.task.options.limit = 1000;
    CHECK_INT(kern_plan_add(&p.plan, &w.block[1]), KERN_LIMIT);
    CHECK_INT(kern_plan_try(&p.plan, &w.block[1], &m, NULL), KERN_LIMIT);
    CHECK(m.margin < 0 && m.holds < 0 && m.fails >= KERN_INFINITY);
    CHECK_INT(m.level, -1);
    CHECK_INT(kern_plan_bears(&p.plan, &w.block[1], R(0.1), NULL), KERN_LIMIT);
    CHECK_INT(kern_plan_stays(&p.plan, &w.block[1], &chance), KERN_LIMIT);
    CHECK_INT(kern_plan_raised(&p.plan, &w.block[1], &raising, &reserve, NULL),
              KERN_LIMIT);
    CHECK_INT(p.plan.task.s.blocks, 1);
    CHECK_INT(p.plan.task.s.contacts, 0);
    p.plan.task.options.limit = 0;
    CHECK_INT(kern_plan_add(&p.plan, &w.block[1]), 800);
}

/* Every stone of a plan in the same array of vertices: the second one is
   refused, wherever it lies, to be added and to be tried. */
static void plan_with_one_array(void)
{
    static world w;
    static site p;
    kern_vec v[4];
    kern_block stone;
    kern_margin m;
    int i, k;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_touch(&w);
    site_open(&p, &w);
    site_add(&p, 0);
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 4; k++)
            v[k] = vec((k == 1 || k == 2 ? 1 : 0) + 3 * i, k / 2);
        CHECK_INT(kern_block_init(&stone, v, 4, R(1), NULL), KERN_OK);
        k = kern_plan_try(&p.plan, &stone, &m, NULL);
        CHECK_INT(k, i ? KERN_STALE : KERN_STANDS);
        CHECK_INT(kern_plan_add(&p.plan, &stone), i ? KERN_STALE : 2);
        if (i)
            CHECK_INT(p.work.fault.block, 1);
        CHECK_INT(p.plan.task.s.blocks, 2);
    }
}

/* kern_critical_of() for the measure of a world; arrays have guards. */
static kern_meeting meeting_at[MAX_POINTS];
static kern_real limit_at[MAX_POINTS];
static int group_of[MAX_BLOCKS];

static int critical(const world *w, kern_margin *m, kern_critical *c)
{
    kern_work work = work_of(w);
    kern_proof proof = proof_here();
    const int got = measure(w, m);
    int k, status;
    if (got < 0 || m->saturated)
        return got;
    if (got == KERN_FALLS)
        proof.force = NULL;
    c->meeting = meeting_at;
    c->limit = limit_at;
    c->group = group_of;
    status = kern_critical_of(world_task(w, &work), m->margin, &proof, c);
    CHECK_INT(status, KERN_OK);
    for (k = 0; k < w->contacts; k++) {
        CHECK(limit_at[k] >= 0 && limit_at[k] <= 1 + 1e-4);
        if (c->contact < 0)
            CHECK_NEAR(limit_at[k], 0, 0);
    }
    if (c->contact >= 0)
        CHECK_NEAR(limit_at[c->contact], 1, 1.1e-4);
    for (k = 0; k < w->blocks; k++) {
        const kern_motion v = motion_of[k];
        const int moves = v.vx * v.vx + v.vy * v.vy > 0 || v.spin * v.spin > 0;
        CHECK(group_of[k] >= -1 && group_of[k] < c->groups);
        CHECK(group_of[k] < 0 || (moves && !w->block[k].fixed));
    }
    CHECK(c->groups > 0);
    return got;
}

static void critical_by_hand(void)
{
    static world w;
    kern_margin m;
    kern_critical c;
    int k, hinges;
    /* a cube that reaches out: it tips about the edge, standing or falling */
    for (k = 0; k < 2; k++) {
        shifted_cube(&w, k ? 0.75 : 0.25);
        CHECK_INT(critical(&w, &m, &c), k ? KERN_FALLS : KERN_STANDS);
        CHECK_INT(c.groups, 1);
        CHECK_INT(group_of[0], -1);
        CHECK_INT(group_of[1], 0);
        CHECK(c.contact >= 0);
        CHECK_INT(meeting_at[c.contact], KERN_HINGES);
        CHECK_INT(meeting_at[1 - c.contact], KERN_OPENS);
        CHECK(w.contact[c.contact].p.x > w.contact[1 - c.contact].p.x);
    }
    /* nothing to press on: one group, no contact */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(c.groups, 1);
    CHECK_INT(c.contact, -1);
    /* on ice, pushed: it slides, and both ends limit alike */
    shifted_cube(&w, 0);
    world_friction(&w, 0.1);
    w.block[1].load.fx = R(3);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(meeting_at[0], KERN_SLIDES);
    CHECK_INT(meeting_at[1], KERN_SLIDES);
    CHECK_NEAR(limit_at[0], limit_at[1], 1e-3);
    /* a stone on a beam that tips about its pier moves as one with it */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 2);
    world_box(&w, 1, 0, 2, 4, 2.5);
    world_box(&w, 1, 0, 2.5, 0.8, 3.5);
    world_touch(&w);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(group_of[1], 0);
    for (hinges = k = 0; k < w.contacts; k++)
        hinges += meeting_at[k] == KERN_HINGES;
    CHECK(hinges >= 1);
    CHECK_INT(meeting_at[c.contact], KERN_HINGES);
    CHECK_NEAR(w.contact[c.contact].p.x, 1, GEO);
    CHECK_NEAR(w.contact[c.contact].p.y, 2, GEO);
}

static void critical_laws(void)
{
    static world w;
    kern_margin m;
    kern_critical c;
    int seed, limits = 0;
    for (seed = 0; seed < 200; seed++) {
        random_world(&w, 660000u + (unsigned long long)seed, 20);
        if (critical(&w, &m, &c) < 0 || m.saturated)
            continue;
        limits += c.contact >= 0;
    }
    context[0] = 0;
    CHECK(limits > 50);
}

/* A cone of friction .5, narrower by the angle of 1.5 * .2, is that of .2 /
   1.15 = .1739: what moves along its edge slides, and opens if it is faster. */
static void critical_narrow(void)
{
    static world w;
    static const struct {
        double vy, narrow;
        int meets;
    } at[] = {
        {0.49, 0, KERN_SLIDES},
        {0.51, 0, KERN_OPENS},
        {0.17, 1.5, KERN_SLIDES},
        {0.18, 1.5, KERN_OPENS},
    };
    kern_motion motion[2] = {{0, 0, 0}, {1, 0, 0}};
    kern_meeting meeting[2];
    kern_proof proof;
    kern_critical c;
    kern_work work;
    size_t k;
    memset(&c, 0, sizeof c);
    c.meeting = meeting;
    proof.force = NULL;
    proof.motion = motion;
    shifted_cube(&w, 0);
    world_friction(&w, 0.5);
    work = work_of(&w);
    for (k = 0; k < sizeof at / sizeof *at; k++) {
        motion[1].vy = R(at[k].vy);
        w.options.narrow = R(at[k].narrow);
        CHECK_INT(kern_critical_of(world_task(&w, &work), R(0.2), &proof, &c),
                  KERN_OK);
        CHECK_INT(meeting[0], at[k].meets);
        CHECK_INT(meeting[1], at[k].meets);
    }
}

static void critical_bad_input(void)
{
    static world w;
    const kern_motion zero[2] = {{0, 0, 0}, {0, 0, 0}};
    kern_motion motion[2];
    kern_proof proof;
    kern_critical c;
    kern_work work;
    kern_task *task;
    memset(&c, 0, sizeof c);
    memcpy(motion, zero, sizeof zero);
    proof.force = NULL;
    proof.motion = motion;
    shifted_cube(&w, 0.25);
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_OK); /* all rests */
    CHECK_INT(c.contact, -1);
    CHECK_INT(c.groups, 0);
    CHECK_INT(kern_critical_of(NULL, 0, &proof, &c), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, 0, NULL, &c), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, 0, &proof, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, R(not_a_number()), &proof, &c),
              KERN_BAD_NUMBER);
    motion[1].spin = R(not_a_number());
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_BAD_NUMBER);
    CHECK_INT(work.fault.block, 1);
    proof.motion = NULL;
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_BAD_POINTER);
}

/* Whatever is said to be known, the measure is the same, and proven: what was
   known before a change, of another structure, random numbers, no numbers. */
static kern_real random_number(void)
{
    const int kind = random_int(0, 9);
    return R(kind == 0   ? not_a_number()
             : kind == 1 ? huge_value()
             : kind == 2 ? -huge_value()
             : kind == 3 ? 0
                         : uniform(-1, 1) * pow(10, random_int(-8, 8)));
}

static void known_garbage(void)
{
    static world w;
    static kern_motion motion[MAX_BLOCKS];
    static kern_force force[MAX_POINTS];
    kern_known known = kern_known_of(motion, force);
    int seed, way, i;
    for (seed = 0; seed < some(300); seed++) {
        kern_margin fresh, m;
        int want;
        random_world(&w, 640000u + (unsigned long long)seed, 20);
        want = measure(&w, &fresh);
        for (way = 0; way < 7; way++) {
            const kern_proof proof = proof_here();
            kern_work work = work_of(&w);
            kern_task task = *world_task(&w, &work);
            /* 0: of the world before; 1: as the last measure left it; 2: the
               same in a wide bracket; 3: that bracket but for one number */
            for (i = 0; i < w.blocks && way > 3; i++) {
                motion[i].vx = random_number();
                motion[i].vy = random_number();
                motion[i].spin = random_number();
            }
            for (i = 0; i < w.contacts && way > 3; i++) {
                force[i].normal = random_number();
                force[i].tangential = random_number();
            }
            if (way == 2 && (!SINGLE || known.fails > mean_size(&w) / 4)) {
                known.holds = 0; /* much wider than any is */
                known.margin = known.fails / 2;
            } else if (way == 3 || way == 4) {
                known.holds = fresh.holds;
                known.fails = fresh.fails;
                known.margin = way == 4 ? fresh.margin : random_number();
            } else if (way > 4) {
                known.holds = random_number();
                known.fails = random_number();
                known.margin = random_number();
            }
            task.known = known;
            memset(&m, 0, sizeof m);
            i = kern_measure(&task, &m, &proof);
            check_measure(&w, i, &m, &work);
            same_answer(&w, &fresh, want, &m, i, 1, EXACT, HERE);
            known = task.known;
        }
    }
    context[0] = 0;
}

static void plan_stale(void)
{
    enum { BOXES = 8, ROOM = 40 };
    static kern_real real[KERN_REALS(BOXES, ROOM)];
    static int index[KERN_INTS(BOXES, ROOM)];
    static kern_motion motion[BOXES];
    static kern_force force[ROOM];
    static world w;
    kern_block block[BOXES];
    kern_contact contact[ROOM];
    kern_work work = kern_work_of(real, KERN_REALS(BOXES, ROOM), index,
                                  KERN_INTS(BOXES, ROOM));
    kern_margin m, fresh;
    int way, i;
    for (way = 0; way < 3; way++) {
        kern_plan plan = kern_plan_of(block, BOXES, contact, ROOM,
                                      kern_known_of(motion, force), &work);
        kern_work own = kern_work_of(real, KERN_REALS(BOXES, ROOM), index,
                                     KERN_INTS(BOXES, ROOM));
        int before, got;
        world_reset(&w);
        for (i = 0; i < BOXES; i++) {
            const double x = i ? 0.1 * (i & 1) : -3;
            world_box(&w, i > 0, x, i - 1, x + (i ? 1 : 7), i);
            CHECK(kern_plan_add(&plan, &w.block[i]) >= 0);
        }
        before = plan.task.s.contacts;
        if (way == 2) {
            got = contact_make(6, 7, vec(0, 1), vec(0.2, 6), vec(0.9, 6),
                               R(0.4), &plan.task.options, contact + before);
            CHECK_INT(got, 2);
            plan.task.s.contacts += got;
        }
        CHECK_INT(kern_measure(&plan.task, &m, NULL), KERN_STANDS);
        if (way < 2) {
            plan.task.s.blocks -= 3;
            plan.task.s.contacts -= 6;
        } else
            plan.task.s.contacts = before;
        for (i = 0; i < work.indices; i++)
            index[i] = way == 1 ? 1000000 + i : -1000000 - i;
        CHECK_INT(kern_plan_remove(&plan, plan.task.s.blocks - 1), KERN_OK);
        CHECK_INT(kern_measure(&plan.task, &m, NULL), KERN_STANDS);
        CHECK_INT(kern_measure(task_of(&plan.task.s, &plan.task.options, &own),
                               &fresh, NULL),
                  KERN_STANDS);
        CHECK_INT(m.level, fresh.level);
        CHECK_NEAR(m.margin, fresh.margin, SINGLE ? 2e-3 : 1e-6);
    }
}

/* Nothing, or ground alone: a question without an answer, which changes
   nothing. */
static void plan_ground_only(void)
{
    static world w;
    static site p;
    kern_margin m;
    int i;
    slab_on_pillar(&w);
    site_open(&p, &w);
    CHECK_INT(site_measure(&p, &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[0], &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[1], &m), KERN_FALLS);
    site_add(&p, 0);
    CHECK_INT(site_measure(&p, &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[1], &m), KERN_STANDS);
    CHECK(m.saturated);
    for (i = 1; i < 3; i++)
        site_add(&p, i);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    for (i = 2; i >= 0; i--) {
        site_remove(&p, i);
        site_measure(&p, &m);
    }
    CHECK_INT(p.plan.task.s.contacts, 0);
    CHECK_INT(kern_plan_remove(&p.plan, 0), KERN_BAD_BLOCK);
}

/* What every call on a plan says; those that are refused change nothing. */
static void plan_say(site *p, const kern_block *b, int add, int remove,
                     int measured, int tried, const char *where)
{
    kern_margin m, untouched;
    memset(&m, 0x55, sizeof m);
    untouched = m;
    site_keep(p);
    check_near(kern_plan_try(&p->plan, b, &m, NULL), tried, 0, where, "try");
    site_unchanged(p, where);
    if (tried < 0)
        check_report(!memcmp(&m, &untouched, sizeof m), where, "margin", 0, 0,
                     0);
    if (measured < 0) {
        m = untouched;
        check_near(kern_measure(&p->plan.task, &m, NULL), measured, 0, where,
                   "measure");
        check_report(!memcmp(&m, &untouched, sizeof m), where, "margin", 0, 0,
                     0);
    }
    if (add < 0)
        check_near(kern_plan_add(&p->plan, b), add, 0, where, "add");
    if (remove < 0)
        check_near(kern_plan_remove(&p->plan, 0), remove, 0, where, "remove");
    site_unchanged(p, where);
}

/* What was measured is trusted, what came later is not: contacts appended by
   hand are checked, and what is changed by hand is seen where fails is 0. */
static void plan_by_hand(void)
{
    static world w;
    static site p;
    kern_contact *bad, good;
    kern_block b, aside;
    kern_margin m;
    b = on_slab(&w, &p, 0.4);
    bad = p.contact + p.plan.task.s.contacts++;
    *bad = good = p.contact[0];
    bad->mu = -1;
    plan_say(&p, &b, 0, KERN_OK, KERN_BAD_FRICTION, KERN_BAD_FRICTION, HERE);
    bad->mu = good.mu;
    bad->a = 99;
    CHECK_INT(kern_plan_bears(&p.plan, &b, 0, NULL), KERN_BAD_BLOCK);
    p.plan.task.s.contacts--;
    site_try(&p, &b, &m);
    aside = candidate(&w, 1, 5, 0, 0.2);
    p.block[2].load.fx = 8 * p.block[2].mass; /* is noticed */
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 0, NULL), KERN_FALLS);
    site_try(&p, &aside, &m);
    site_try(&p, &b, &m);
    p.block[2].load.fx = 0;
    site_measure(&p, &m);
    p.block[2].mass *= 3;
    site_try(&p, &b, &m);
    p.block[2].mass /= 3;
    site_measure(&p, &m);
    p.contact[2].mu = p.contact[3].mu = R(0.01);
    p.block[2].load.fx = p.block[2].mass;
    p.plan.task.known.fails = 0;
    site_try(&p, &b, &m);
    CHECK_INT(kern_plan_bears(&p.plan, &b, 0, NULL), KERN_FALLS);
    site_measure(&p, &m);
    p.plan.task.s.gravity = vec(0.3, -9.81);
    site_try(&p, &b, &m);
}

/* What stands with every kern closed bears any margin, kerns nested or not: a
   block on two points whose normals differ, and one aside. With cones that
   narrow it falls where friction is gone, by a motion. */
static void plan_bears_when_closed(void)
{
    static world w;
    static site p;
    const kern_proof proof = proof_here();
    kern_block aside;
    kern_margin m;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_box(&w, 1, -1, 0, 1, 1);
    world_point(&w, 0, 1, 0.3, 1, -0.8, 0);
    world_point(&w, 0, 1, -0.3, 1, 0.8, 0);
    kern_contact_travels(w.contact, w.contacts);
    site_with(&p, &w, 2);
    aside = candidate(&w, 1, 5, 0, 0.2);
    CHECK_INT(kern_plan_try(&p.plan, &aside, &m, NULL), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, m.most / 2, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, m.most, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 3 * m.most, NULL), KERN_STANDS);
    kern_block_load(&aside, vec(0.004, 0), vec(5.1, 0), 0); /* slides at last */
    p.plan.task.options.narrow = R(0.1);
    CHECK_INT(kern_plan_try(&p.plan, &aside, &m, NULL), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 2 * m.most, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 9 * m.most, &proof), KERN_FALLS);
    p.block[2] = aside;
    p.plan.task.s.blocks++;
    p.plan.task.s.contacts += 2; /* still there, behind the plan's */
    CHECK(kern_check_motion(&p.plan.task, 9 * m.most, proof.motion) <= 1);
}

static void plan_faults(void)
{
    static world w;
    static site p;
    static const int none = KERN_BAD_POINTER, full = KERN_NO_SPACE;
    kern_plan keep;
    kern_block b;
    kern_margin m;
    int i;
    b = on_slab(&w, &p, 1.1);
    keep = p.plan;
    for (i = 0; i < 4; i++) {
        p.plan.block = i == 0 ? NULL : keep.block;
        p.plan.contact = i == 1 ? NULL : keep.contact;
        p.plan.task.known.motion = i == 2 ? NULL : keep.task.known.motion;
        p.plan.task.work = i == 3 ? NULL : keep.task.work;
        plan_say(&p, &b, none, none, i == 3 ? none : 0, none, HERE);
        p.plan = keep;
    }
    plan_say(&p, NULL, none, 0, 0, none, HERE);
    CHECK_INT(kern_plan_add(NULL, &b), none);
    CHECK_INT(kern_plan_remove(NULL, 0), none);
    CHECK_INT(kern_measure(NULL, &m, NULL), none);
    CHECK_INT(kern_plan_try(NULL, &b, &m, NULL), none);
    site_keep(&p);
    CHECK_INT(kern_measure(&p.plan.task, NULL, NULL), none);
    CHECK_INT(kern_plan_try(&p.plan, &b, NULL, NULL), none);
    CHECK_INT(kern_plan_remove(&p.plan, -1), KERN_BAD_BLOCK);
    CHECK_INT(kern_plan_remove(&p.plan, w.blocks), KERN_BAD_BLOCK);
    site_unchanged(&p, HERE);
    for (i = -1; i <= w.blocks; i++) { /* no room for a block */
        p.plan.block_room = i;
        plan_say(&p, &b, full, 0, 0, full, HERE);
        p.plan = keep;
    }
    for (i = -1; i < 2; i++) { /* nor for its two contact points */
        p.plan.contact_room = w.contacts + i;
        plan_say(&p, &b, i < 0 ? KERN_BAD_COUNT : full, 0, 0,
                 i < 0 ? KERN_BAD_COUNT : full, HERE);
        p.plan = keep;
    }
}

/* Bad blocks and options. */
static void plan_bad_input(void)
{
    static world w;
    static site p;
    kern_plan keep;
    kern_block b;
    kern_margin m;
    b = on_slab(&w, &p, 1.1);
    keep = p.plan;
    b.mass = 0;
    plan_say(&p, &b, 0, 0, 0, KERN_BAD_MASS, HERE);
    p.plan.task.known.force = NULL;
    CHECK_INT(kern_plan_add(&p.plan, &w.block[1]), KERN_BAD_POINTER);
    CHECK_INT(p.work.fault.block, -1); /* not that of the call before */
    p.plan = keep;
    plan_say(&p, &b, 0, 0, 0, KERN_BAD_MASS, HERE);
    CHECK_INT(p.work.fault.block, w.blocks);
    b.area = R(not_a_number());
    plan_say(&p, &b, KERN_BAD_NUMBER, 0, 0, KERN_BAD_NUMBER, HERE);
    CHECK_INT(p.work.fault.block, w.blocks);
    p.plan.task.options.mu = R(-1);
    plan_say(&p, &w.block[1], KERN_BAD_FRICTION, 0, KERN_BAD_FRICTION,
             KERN_BAD_FRICTION, HERE);
    p.plan = keep;
    p.plan.task.options.epsilon = R(1e-12);
    plan_say(&p, &w.block[0], 0, 0, KERN_BAD_STEP, KERN_BAD_STEP, HERE);
    p.plan = keep;
    site_measure(&p, &m);
    CHECK_NEAR(m.margin, 0.4, EXACT);
}

/* Work memory of every size, one array at a time: the answer, or that there is
   too little; never a write behind it, nor another plan. */
static void plan_every_size(void)
{
    static world w;
    static site p, was;
    kern_real *real = p.real;
    int *index = p.index;
    kern_block b;
    kern_margin m;
    int array, size, call, need[2], want;
    b = on_slab(&w, &was, 1.2);
    kern_work_need(w.blocks + 1, was.plan.task.s.contacts + 2, &need[0],
                   &need[1]);
    for (array = 0; array < 2; array++)
        for (size = 0; size <= need[array]; size++)
            for (call = 0; call < 3; call++) {
                int got;
                p.plan = was.plan;
                memcpy(p.block, was.block, sizeof p.block);
                memcpy(p.contact, was.contact, sizeof p.contact);
                memcpy(p.motion, was.motion, sizeof p.motion);
                memcpy(p.force, was.force, sizeof p.force);
                p.plan.task.s.block = p.plan.block = p.block;
                p.plan.task.s.contact = p.plan.contact = p.contact;
                p.plan.task.known.motion = p.motion;
                p.plan.task.known.force = p.force;
                p.plan.task.work = &p.work;
                guard_fill(real, need[0], index, need[1]);
                p.work = kern_work_of(real, array ? need[0] : size, index,
                                      array ? size : need[1]);
                site_keep(&p);
                got = call == 0 ? kern_measure(&p.plan.task, &m, NULL)
                    : call == 1 ? kern_plan_try(&p.plan, &b, &m, NULL)
                                : kern_plan_remove(&p.plan, 1);
                CHECK(guard_holds(&p.work, need[0], need[1]));
                want = size < need[array] && got == KERN_NO_SPACE
                         ? KERN_NO_SPACE
                     : call == 2 ? KERN_OK
                                 : KERN_STANDS;
                CHECK_INT(got, want);
                CHECK(size > 0 || got == KERN_NO_SPACE || call == 2);
                if (got < 0 || call == 1)
                    site_unchanged(&p, HERE);
            }
}

/* Half a brick over the edge, relative: at a share above 1 its points would come
   out behind their middle. No call takes one, and none answers one. */
static void relative_shares(void)
{
    static world w;
    static site p;
    const kern_real above[] = {R(1.0001), R(2.41), R(1e6)};
    const kern_wrench push[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    kern_work work;
    kern_task *task;
    kern_raising raising = KERN_NOT_SHOWN;
    kern_real value = -7;
    kern_critical critical = {NULL, NULL, NULL, 0, 0};
    kern_proof proof = proof_here();
    kern_block b;
    int i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0.4, 1, 1.6, 2);
    w.options.relative = 1;
    world_touch(&w);
    b = w.block[2];
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_verdict(task, 1, &proof), KERN_FALLS);
    site_with(&p, &w, 2);
    for (i = 0; i < 3; i++) {
        const kern_real at = above[i];
        CHECK_INT(kern_verdict(task, at, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_raised(task, at, &raising, NULL, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_forces(task, at, force_of), KERN_BAD_SHARE);
        CHECK_INT(kern_load_factor(task, at, KERN_LEFT, &value, NULL),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_load_factor_of(task, at, push, &value, NULL),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_tilt(task, at, KERN_LEFT, &value, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_critical_of(task, at, &proof, &critical),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_plan_bears(&p.plan, &b, at, NULL), KERN_BAD_SHARE);
        CHECK(isinf(kern_check_motion(task, at, motion_of)));
        CHECK(isinf(kern_check_forces(task, at, force_of)));
    }
    CHECK_NEAR(value, -7, 0);
    CHECK_INT(raising, KERN_NOT_SHOWN);
    CHECK_INT(kern_verdict(task, -2, NULL), KERN_STANDS); /* growth has none */
}

/* Known from before a stone was taken away and another laid down: an older
   version said margin 1 of this, for 0.60. */
static void plan_out_of_date(void)
{
    static const double stone[4][16] = {
        {-2815, -469, 2815, -469, 2815, 0, -2815, 0},
        {501, 0, 595, 0, 595, 117, 648, 117, 648, 0, 742, 0, 742, 234.5, 501,
         234.5},
        {526, 469, 1120, 469, 1120, 703, 526, 703},
        {645, 234.5, 1233, 234.5, 1233, 469, 645, 469}};
    static world w;
    static site p;
    kern_margin m, n;
    kern_known *known = &p.plan.task.known;
    int i;
    world_reset(&w);
    w.options.mu = R(0.32);
    w.options.relative = 1;
    w.gravity = vec(-1.04, -9.81);
    for (i = 0; i < 4; i++)
        world_polygon(&w, i % 2, stone[i], i == 1 ? 8 : 4);
    world_touch(&w);
    CHECK_INT(measure(&w, &n), KERN_STANDS);
    CHECK(n.margin > R(0.5) && n.margin < R(0.7));
    site_with(&p, &w, 3);
    memset(p.motion, 0, sizeof p.motion);
    memset(p.force, 0, sizeof p.force);
    for (i = 0; i < 9; i++) {
        known->margin = R(0.3 * (i + 1));
        known->holds = known->margin * R(1 - 1e-6);
        known->fails = known->margin * R(1 + 1e-6);
        p.force[0].normal = R(1.4e4) * w.block[1].mass / R(1e3);
        p.force[1].normal = p.force[0].normal;
        CHECK_INT(kern_plan_try(&p.plan, &w.block[3], &m, NULL), KERN_STANDS);
        CHECK_NEAR(m.margin, n.margin, SINGLE ? 1e-2 : 2e-6); /* a jam */
        CHECK(!m.saturated);
    }
}

static const test plan_tests[] = {
    TEST(plan_random),         TEST(plan_points),
    TEST(plan_changes),        TEST(plan_candidates),
    TEST(plan_saturated),      TEST(plan_limits),
    TEST(plan_with_one_array), TEST(critical_by_hand),
    TEST(critical_narrow),     TEST(critical_laws),
    TEST(critical_bad_input),  TEST(known_garbage),
    TEST(plan_stale),          TEST(plan_ground_only),
    TEST(plan_by_hand),        TEST(plan_bears_when_closed),
    TEST(plan_faults),         TEST(plan_bad_input),
    TEST(plan_every_size),     TEST(relative_shares),
    TEST(plan_out_of_date),
};

#endif
