/* laws.h - laws that the answers for related structures obey. */

#ifndef UNIT_LAWS_H
#define UNIT_LAWS_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"

/* `t`, a changed `w`, has the margin of `w` times `scale`, the same verdict
   and the same level; or what differs is an open question. */
static void same_result(const world *w, const kern_margin *m, int got,
                        const world *t, double scale, double tol,
                        const char *where)
{
    kern_margin n;
    const int now = measure(t, &n);
    same_answer(w, m, got, &n, now, scale, tol, where);
}

/* `t` is at least as good as `w`. */
static void not_worse(const world *w, const kern_margin *m, int got,
                      const world *t, double tol, const char *where)
{
    kern_margin n;
    const double unit = w->options.relative ? 1 : mean_size(w);
    const int now = measure(t, &n);
    if (got != KERN_STANDS || (SINGLE && now < 0))
        return;
    if (now != KERN_STANDS) {
        if (!open_question(w, 0))
            check_near(now, got, 0, where, "verdict of what is not worse");
        return;
    }
    if ((double)n.margin < (double)m->margin - tol * unit
        && !open_question(w, ((double)n.margin + (double)m->margin) / 2))
        check_near((double)n.margin, (double)m->margin, tol * unit, where,
                   "margin of what is not worse");
    passed++;
}

/* Returns the difference of margins that is rounding, in mean sizes. The motions
   of GLPK have half a digit less. */
static double law_tolerance(const world *w)
{
    return SINGLE ? 2e-3 : !twin_nested(w) ? 3e-6 : GLPK ? 4e-9 : 2e-9;
}

static void laws_units_and_places(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, trial;
    for (seed = 0; seed < some(1200); seed++) {
        kern_margin m;
        int got;
        random_world(&w, 100000u + (unsigned long long)seed, 40);
        got = measure(&w, &m);
        CHECK(decided(got));
        for (trial = 0; trial < 7; trial++) {
            change c = no_change();
            double tol = law_tolerance(&w);
            switch (trial) {
            case 0: c.scale = pow(10, uniform(-3, 3)); break;
            case 1: c.mass = pow(10, uniform(-6, 6)); break;
            case 2:
                /* 1e4 diameters, and what their rounding is to a block */
                c.dx = (SINGLE ? 3 : 1e4) * 2 * (reach_of(&w) + mean_size(&w));
                c.dy = -c.dx / 2;
                tol += 64 * EPS * c.dx / mean_size(&w);
                break;
            case 3: c.mirror = 1; break;
            case 4: c.angle = uniform(-pi, pi); break;
            case 5: c.shuffle = 1; break;
            default:
                c.scale = seed % 2 ? 1e3 : 1e-3;
                c.mass = seed % 3 ? 1e6 : 1e-6;
                c.angle = uniform(-pi, pi);
                c.shuffle = 1;
                c.mirror = chance(0.5);
            }
            /* mass times gravity is what counts: loads go with the mass */
            world_changed(&t, &w, &c, order);
            same_result(&w, &m, got, &t, c.scale, tol, HERE);
        }
    }
    context[0] = 0;
}

/* The load factor `now` of a structure like w, whose own is `want`, below 0
   where it falls. Returns 1 where the two were compared. */
static int check_same_load(const world *w, int got, double now, double want)
{
    if ((SINGLE && got < 0) || want >= 100)
        return 0;
    if (want < 0) {
        if (got != KERN_FALLS && !open_question(w, 0))
            CHECK_INT(got, KERN_FALLS);
        return 0;
    }
    if (got != KERN_STANDS && open_question(w, 0))
        return 1;
    CHECK_INT(got, KERN_STANDS);
    CHECK_NEAR(now, want, (SINGLE ? 5e-3 : 2e-6) * (1 + want));
    return 1;
}

static void laws_load_factor(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, trial, side, found = 0;
    for (seed = 0; seed < 300; seed++) {
        double factor[3];
        random_world(&w, 140000u + (unsigned long long)seed, 15);
        for (side = -1; side <= 1; side += 2)
            if (load_factor(&w, NULL, side, &factor[side + 1]) != KERN_STANDS)
                factor[side + 1] = -1;
        for (trial = 0; trial < 3; trial++) {
            change c = no_change();
            c.scale = trial == 0 ? pow(10, uniform(-3, 3)) : 1;
            c.mass = trial == 0 ? pow(10, uniform(-6, 6)) : 1;
            c.angle = trial == 1 ? uniform(-pi, pi) : 0;
            c.mirror = trial == 1;
            c.shuffle = trial == 2;
            world_changed(&t, &w, &c, order);
            for (side = -1; side <= 1; side += 2) {
                double now;
                const int got = load_factor(&t, NULL, side, &now);
                found += check_same_load(&w, got, now,
                                         factor[(c.mirror ? -side : side) + 1]);
            }
        }
    }
    context[0] = 0;
    CHECK(found > 200);
}

static void laws_more_support(void)
{
    static world w, t;
    int seed, k;
    for (seed = 0; seed < some(1500); seed++) {
        kern_margin m;
        const int kind = random_world(&w, 160000u + (unsigned long long)seed,
                                      25);
        const int got = measure(&w, &m);
        const double tol = law_tolerance(&w);
        int b;
        (void)kind;
        CHECK(decided(got));
        /* more friction */
        world_copy(&t, &w);
        for (k = 0; k < t.contacts; k++)
            t.contact[k].mu = R((double)t.contact[k].mu * uniform(1, 2)
                                + uniform(0, 0.1));
        not_worse(&w, &m, got, &t, tol, HERE);
        /* a fixed block more, against any free block anywhere */
        world_copy(&t, &w);
        do
            b = random_int(0, w.blocks - 1);
        while (w.block[b].fixed);
        {
            const double lean = uniform(-pi, pi),
                         r = 0.4 * sqrt(fabs((double)w.block[b].area));
            const double x = (double)w.block[b].centre.x - r * sin(lean);
            const double y = (double)w.block[b].centre.y - r * cos(lean);
            const int ground = world_mass(&t, 0, x, y - 1, 1);
            const double half = chance(0.5) ? 0.2 * r : 0;
            world_line(&t, ground, b, sin(lean), cos(lean),
                       x - half * cos(lean), y + half * sin(lean),
                       x + half * cos(lean), y - half * sin(lean));
        }
        kern_contact_travels(t.contact, t.contacts);
        not_worse(&w, &m, got, &t, tol, HERE);
    }
    context[0] = 0;
}

/* Two structures in one: contacts and blocks of `b` behind those of `a`. */
static void world_joined(world *to, const world *a, const world *b, double dx)
{
    int i, k;
    world_copy(to, a);
    for (i = 0; i < b->blocks; i++) {
        kern_block *t = &to->block[to->blocks + i];
        *t = b->block[i];
        t->vertex = NULL; /* contacts are given from here on */
        t->vertices = 0;
        t->centre.x += R(dx);
    }
    for (k = 0; k < b->contacts; k++) {
        kern_contact *t = &to->contact[to->contacts + k];
        *t = b->contact[k];
        t->a += to->blocks;
        t->b += to->blocks;
        t->p.x += R(dx);
    }
    to->blocks += b->blocks;
    to->contacts += b->contacts;
    to->given = 1;
}

/* The margin of two structures side by side; one that is saturated stands at
   any shrinkage. */
static double least_margin(const kern_margin *m, const kern_margin *n)
{
    if (m->saturated && n->saturated)
        return fmax((double)m->margin, (double)n->margin);
    if (m->saturated || n->saturated)
        return (double)(m->saturated ? n : m)->margin;
    return fmin((double)m->margin, (double)n->margin);
}

/* Two structures stand side by side where both stand. Returns 1 where they
   do. */
static int check_both(const world *a, int got_a, const world *b, int got_b,
                      int got)
{
    const int stand = got_a == KERN_STANDS && got_b == KERN_STANDS;
    if (got != (stand ? KERN_STANDS : KERN_FALLS)) {
        CHECK(decided(got) && decided(got_a) && decided(got_b));
        if (got >= 0 && got_a >= 0 && got_b >= 0 && !open_question(a, 0)
            && !open_question(b, 0))
            CHECK(!"verdict of two side by side");
        return 0;
    }
    return stand;
}

static void laws_side_by_side(void)
{
    static world a, b, both;
    int seed, stand = 0;
    for (seed = 0; seed < some(1000); seed++) {
        kern_margin m, n, o;
        int got_a, got_b, got;
        double want, unit;
        random_world(&a, 180000u + (unsigned long long)(2 * seed), 20);
        random_world(&b, 180001u + (unsigned long long)(2 * seed), 20);
        b.gravity = a.gravity;
        b.options = a.options;
        a.options.gap = R(0);
        got_a = measure(&a, &m);
        got_b = measure(&b, &n);
        world_joined(&both, &a, &b, SINGLE ? 10 : 100);
        got = measure(&both, &o);
        if ((SINGLE && (got < 0 || got_a < 0 || got_b < 0))
            || !check_both(&a, got_a, &b, got_b, got))
            continue;
        stand++;
        want = least_margin(&m, &n);
        unit = a.options.relative ? 1 : mean_size(&both);
        if (fabs((double)o.margin - want)
                > 4 * unit * fmax(law_tolerance(&a), law_tolerance(&b))
            && !open_question(&both, ((double)o.margin + want) / 2))
            CHECK_NEAR(o.margin, want, 0);
        passed++;
    }
    context[0] = 0;
    CHECK(stand > some(100));
}

static const test laws_tests[] = {
    TEST(laws_units_and_places),
    TEST(laws_load_factor),
    TEST(laws_more_support),
    TEST(laws_side_by_side),
};

#endif
