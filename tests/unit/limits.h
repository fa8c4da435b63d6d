/* limits.h - limits of work. */

#ifndef UNIT_LIMITS_H
#define UNIT_LIMITS_H

#include "harness.h"
#include "worlds.h"
#include "random.h"
#include "plan.h"

enum limited_call {
    LIMIT_STANDS,
    LIMIT_SHRUNK,
    LIMIT_MEASURE,
    LIMIT_DEFICIT,
    LIMIT_LEFT,
    LIMIT_RIGHT,
    LIMIT_TILT,
    LIMIT_BEARING,
    LIMIT_MARGINS,
    LIMIT_LOADS,
    LIMIT_PLAN,
    LIMIT_TRY,
    LIMIT_BEARS,
    LIMIT_CALLS
};

/* What a call says: 0 in all that it does not write. */
typedef struct limited {
    int status, units;
    kern_margin m;
    kern_real value[MAX_BLOCKS];
} limited;

/* One call with a limit of work. Plans are made anew each time. */
/* A call on a task, its answer to r. */
static int ask_task(enum limited_call call, kern_task *task, limited *r)
{
    const kern_real at = R(
        0.1 * (double)kern_mean_size(task->s.block, task->s.blocks));
    const int side = call == LIMIT_LEFT ? -1 : 1;
    kern_collapse c;
    switch (call) {
    case LIMIT_STANDS: return kern_verdict(task, 0, NULL);
    case LIMIT_SHRUNK: return kern_verdict(task, at, NULL);
    case LIMIT_MEASURE:
    case LIMIT_PLAN: return kern_measure(task, &r->m, NULL);
    case LIMIT_DEFICIT: return kern_deficit(task, r->value);
    case LIMIT_LEFT:
    case LIMIT_RIGHT: return kern_load_factor(task, 0, side, r->value, NULL);
    case LIMIT_TILT: return kern_tilt(task, 0, side, r->value, NULL);
    case LIMIT_BEARING: return kern_bearing(task, r->value, NULL);
    default: return kern_profile(task, call == LIMIT_LOADS, r->value, &c);
    }
}

/* The last block of a world as a candidate for the others. */
static void ask_plan(enum limited_call call, const world *w, int limit,
                     limited *r)
{
    static site p;
    const int last = w->blocks - 1;
    kern_margin m;
    int i;
    site_with(&p, w, last);
    if (call != LIMIT_PLAN)
        kern_measure(&p.plan.task, &r->m, NULL);
    memset(&r->m, 0, sizeof r->m);
    p.plan.task.options.limit = limit;
    r->status = call == LIMIT_PLAN ? ask_task(call, &p.plan.task, r)
              : call == LIMIT_TRY
                  ? kern_plan_try(&p.plan, &w->block[last], &r->m, NULL)
                  : kern_plan_bears(&p.plan, &w->block[last],
                                    R(0.1 * mean_size(w)), NULL);
    r->units = p.work.units;
    if (r->status != KERN_LIMIT)
        return;
    p.plan.task.options.limit = 0; /* the plan is what it was */
    CHECK_INT(p.plan.task.s.blocks, last);
    i = kern_measure(&p.plan.task, &m, NULL);
    CHECK(i >= 0 || i == KERN_NO_FREE || SINGLE);
    if (call == LIMIT_PLAN && i == KERN_STANDS)
        CHECK(r->m.holds <= m.fails);
}

static limited ask_limited(enum limited_call call, const world *w, int limit)
{
    const kern_structure s = structure_of(w);
    kern_work work = work_of(w);
    kern_options o = w->options;
    limited r;
    memset(&r, 0, sizeof r);
    o.limit = limit;
    if (call >= LIMIT_PLAN) {
        ask_plan(call, w, limit, &r);
        return r;
    }
    r.status = ask_task(call, task_of(&s, &o, &work), &r);
    r.units = work.units;
    return r;
}

/* Are all contacts ends of lines, so that kerns only shrink? */
static int all_lines(const world *w)
{
    int i, lines = 1;
    for (i = 0; i < w->contacts; i++)
        lines &= w->contact[i].line;
    return lines;
}

/* A bracket that ended at the limit does not contradict the whole one. */
static void check_known_margin(const world *w, const limited *all,
                               const kern_margin *m)
{
    const kern_real inside = R(1 + (SINGLE ? 1e-3 : 1e-9));
    CHECK_INT(m->level, -1);
    CHECK_INT(m->saturated, 0);
    CHECK(m->holds <= m->fails && m->fails <= m->most);
    CHECK(m->holds <= m->margin && m->margin <= m->holds);
    CHECK(m->holds >= 0 || all->status == KERN_FALLS || m->holds <= -1);
    if (all->status == KERN_STANDS && all_lines(w)) {
        CHECK(m->holds <= all->m.fails * inside);
        CHECK(m->fails * inside >= all->m.holds);
    }
}

/* What is known where the limit was reached does not contradict the answer. */
static void check_known(enum limited_call call, const world *w,
                        const limited *all, const limited *r)
{
    const kern_real inside = R(1 + (SINGLE ? 1e-3 : 1e-9));
    int i;
    if (all->status < 0)
        return;
    switch (call) {
    case LIMIT_MEASURE:
    case LIMIT_PLAN:
    case LIMIT_TRY: check_known_margin(w, all, &r->m); break;
    case LIMIT_DEFICIT:
    case LIMIT_LEFT:
    case LIMIT_RIGHT:
    case LIMIT_TILT:
    case LIMIT_BEARING:
        CHECK(r->value[0] <= all->value[0] * inside + R(1e-6));
        break;
    case LIMIT_MARGINS:
    case LIMIT_LOADS:
        for (i = 0; i < w->blocks; i++)
            CHECK(r->value[i] <= -1 || r->value[i] == all->value[i]);
        break;
    default: break;
    }
}

/* Every call with every limit, or some of them where there are many: enough
   work, and the answer is the same to the last bit; less, and it says so,
   having done no more than the limit. */
static void limits_of_work(void)
{
    static world w;
    int seed, call, reached = 0, known = 0;
    for (seed = 0; seed < some(60); seed++) {
        random_world(&w, 770000u + (unsigned long long)seed, 12);
        for (call = 0; call < LIMIT_CALLS; call++) {
            const limited all = ask_limited((enum limited_call)call, &w, 0);
            const int step = 1 + all.units / 50;
            int limit;
            if (all.status < KERN_UNDECIDED)
                continue;
            CHECK(all.units > 0);
            for (limit = 1; limit <= all.units + 1;
                 limit += limit + 3 < all.units && limit > 3 ? step : 1) {
                const limited r = ask_limited((enum limited_call)call, &w,
                                              limit);
                if (limit >= all.units) {
                    CHECK(memcmp(&r, &all, sizeof r) == 0);
                    continue;
                }
                CHECK_INT(r.status, KERN_LIMIT);
                CHECK_INT(r.units, limit + 1);
                check_known((enum limited_call)call, &w, &all, &r);
                reached++;
                known += r.m.holds > 0 || r.value[0] > 0;
            }
        }
    }
    context[0] = 0;
    CHECK(reached > some(10000));
    CHECK(known > some(1000));
}

/* A limit that does not reach for the input: it is not read, and what is wrong
   about it is not seen; and nothing is known. */
static void limit_before_reading(void)
{
    static world w;
    int call;
    random_world(&w, 770000u, 12);
    CHECK(w.blocks + w.contacts >= 10);
    w.contact[w.contacts - 1].p.x = R(NAN);
    for (call = 0; call < LIMIT_PLAN; call++) {
        const limited whole = ask_limited((enum limited_call)call, &w, 0);
        const limited r = ask_limited((enum limited_call)call, &w, 1);
        CHECK_INT(whole.status, KERN_BAD_NUMBER);
        CHECK_INT(r.status, KERN_LIMIT);
        CHECK_INT(r.units, 2);
        if (call == LIMIT_MEASURE) {
            CHECK(r.m.holds <= -1 && r.m.margin <= -1 && r.m.level == -1);
            CHECK(r.m.fails >= INFINITY && r.m.most >= INFINITY);
        } else if (call != LIMIT_STANDS && call != LIMIT_SHRUNK)
            CHECK(r.value[0] <= -1);
    }
}

static const test limits_tests[] = {
    TEST(limits_of_work),
    TEST(limit_before_reading),
};

#endif
