/* turned.h - the same contacts whichever way the world is turned. */

#ifndef UNIT_TURNED_H
#define UNIT_TURNED_H

#include "harness.h"
#include "worlds.h"
#include "random.h"
#include "contact.h"

/* `to` becomes `from` with block i at order[i], mirrored, scaled, turned by
   `angle` with gravity, and moved. Contacts are found anew or moved along. */
typedef struct change {
    double scale, mass, angle, dx, dy;
    int mirror, shuffle;
} change;

static change no_change(void)
{
    change c;
    c.scale = c.mass = 1;
    c.angle = c.dx = c.dy = 0;
    c.mirror = c.shuffle = 0;
    return c;
}

static kern_vec turned(const change *c, kern_vec v)
{
    const double x = c->mirror ? -(double)v.x : (double)v.x, y = (double)v.y;
    return vec(x * cos(c->angle) - y * sin(c->angle),
               x * sin(c->angle) + y * cos(c->angle));
}

static kern_vec moved(const change *c, kern_vec v)
{
    const kern_vec t = turned(c, v);
    return vec((double)t.x * c->scale + c->dx, (double)t.y * c->scale + c->dy);
}

/* A random order of 0 .. n - 1. */
static void shuffle(int *order, int n)
{
    int i;
    for (i = n - 1; i > 0; i--) {
        const int j = random_int(0, i), keep = order[i];
        order[i] = order[j];
        order[j] = keep;
    }
}

static void block_changed(const world *from, const change *c, int i,
                          const world *to, kern_block *t)
{
    const kern_block *b = &from->block[i];
    const int turn = c->mirror ? -1 : 1;
    const kern_vec f = turned(c, vec((double)b->load.fx, (double)b->load.fy));
    *t = *b;
    if (b->vertex) {
        kern_block placed;
        t->vertex = to->vertex + (b->vertex - from->vertex);
        CHECK_INT(kern_block_init(&placed, t->vertex, t->vertices, R(1), NULL),
                  KERN_OK);
        t->box = placed.box;
    }
    t->area = R((double)b->area * c->scale * c->scale * turn);
    t->mass = R((double)b->mass * c->mass);
    t->centre = moved(c, b->centre);
    t->load.fx = R((double)f.x * c->mass);
    t->load.fy = R((double)f.y * c->mass);
    t->load.torque = R((double)b->load.torque * c->mass * c->scale * turn);
}

/* Lines stay together: contacts change places as wholes, some turn round. */
static void contacts_shuffled(world *w)
{
    static kern_contact unit[MAX_POINTS];
    int done = 0, units = 0, first[MAX_POINTS], i, k;
    for (k = 0; k < w->contacts; k += w->contact[k].line ? 2 : 1)
        first[units++] = k;
    shuffle(first, units);
    for (k = 0; k < units; k++) {
        const int two = w->contact[first[k]].line ? 2 : 1, turn = chance(0.5);
        for (i = 0; i < two; i++) {
            unit[done] = w->contact[first[k] + (turn ? two - 1 - i : i)];
            if (turn) { /* from b into a: t turns too */
                const int keep = unit[done].a;
                unit[done].a = unit[done].b;
                unit[done].b = keep;
                unit[done].n = vec(-(double)unit[done].n.x,
                                   -(double)unit[done].n.y);
                unit[done].travel = -unit[done].travel;
            }
            done++;
        }
    }
    memcpy(w->contact, unit, sizeof *unit * (size_t)done);
}

static void world_changed(world *to, const world *from, const change *c,
                          int *order)
{
    int i, k;
    memcpy(to, from, sizeof *to);
    for (i = 0; i < from->blocks; i++)
        order[i] = i;
    if (c->shuffle)
        shuffle(order, from->blocks);
    to->gravity = turned(c, from->gravity);
    for (i = 0; i < from->vertices; i++)
        to->vertex[i] = moved(c, from->vertex[i]);
    for (i = 0; i < from->blocks; i++)
        block_changed(from, c, i, to, &to->block[order[i]]);
    if (from->options.gap > 0)
        to->options.gap = R((double)from->options.gap * c->scale);
    if (!from->options.relative)
        to->options.epsilon = R((double)from->options.epsilon * c->scale);
    if (!from->given) {
        CHECK(world_touch(to) >= 0);
        return;
    }
    for (k = 0; k < from->contacts; k++) {
        kern_contact *t = &to->contact[k];
        t->a = order[t->a];
        t->b = order[t->b];
        t->p = moved(c, t->p);
        t->n = turned(c, t->n);
        t->travel = R((double)t->travel * c->scale * (c->mirror ? -1 : 1));
    }
    if (c->shuffle)
        contacts_shuffled(to);
}

/* Is e the image of contact o under a change? Its normal may point either way.
 */
static int is_image(const change *c, const int *order, const kern_contact *o,
                    const kern_contact *e)
{
    const double tol = SINGLE ? 2e-3 : 1e-10;
    const kern_vec p = moved(c, o->p), n = turned(c, o->n);
    const double sign = e->a == order[o->a] && e->b == order[o->b] ? 1
                      : e->b == order[o->a] && e->a == order[o->b] ? -1
                                                                   : 0;
    return fabs(sign) > 0
        && hypot((double)(e->p.x - p.x), (double)(e->p.y - p.y))
               <= tol * c->scale
        && hypot((double)e->n.x * sign - (double)n.x,
                 (double)e->n.y * sign - (double)n.y)
               <= tol
        && fabs(fabs((double)e->travel) - fabs((double)o->travel) * c->scale)
               <= 2 * tol * c->scale;
}

static void contact_invariance(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, i, k, trial;
    for (seed = 0; seed < 300; seed++) {
        random_world(&w, 7000u + (unsigned long long)seed, 20);
        if (w.given)
            continue;
        check_contacts(&w);
        for (trial = 0; trial < 4; trial++) {
            change c = no_change();
            c.shuffle = trial != 1;
            c.angle = trial == 0 ? 0 : uniform(-pi, pi);
            c.scale = trial < 2 ? 1 : pow(10, uniform(-3, 3));
            c.mirror = trial == 3;
            c.dx = trial ? uniform(-50, 50) * c.scale : 0;
            world_changed(&t, &w, &c, order);
            CHECK_INT(t.contacts, w.contacts);
            CHECK_INT(lines_of(&t), lines_of(&w));
            for (k = 0; k < w.contacts; k++) {
                int found = 0;
                for (i = 0; i < t.contacts; i++)
                    found += is_image(&c, order, &w.contact[k], &t.contact[i]);
                CHECK(found >= 1);
            }
        }
    }
}

/* Does the same contact stand in both places, bit by bit? */
static int same_contact(const kern_contact *c, const kern_contact *d)
{
    return c->a == d->a && c->b == d->b && c->line == d->line
        && memcmp(&c->p, &d->p, sizeof c->p) == 0
        && memcmp(&c->n, &d->n, sizeof c->n) == 0
        && memcmp(&c->mu, &d->mu, sizeof c->mu) == 0
        && memcmp(&c->travel, &d->travel, sizeof c->travel) == 0;
}

/* The contacts of block after block, each with those before it, are those of
   all together, in the same order; and those of one block are its own among
   all, the other blocks ascending. */
static void contact_order(void)
{
    static world w, t;
    static kern_contact one[MAX_POINTS];
    static int order[MAX_BLOCKS];
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    int seed, b, k, got;
    for (seed = 0; seed < 200; seed++) {
        change c = no_change();
        int all = 0;
        random_world(&t, 9000u + (unsigned long long)seed, 25);
        if (t.given)
            continue;
        c.shuffle = 1;
        c.angle = seed % 2 ? uniform(-pi, pi) : 0;
        world_changed(&w, &t, &c, order);
        for (k = 1; k < w.contacts; k++) {
            const kern_contact *d = &w.contact[k - 1], *e = &w.contact[k];
            CHECK(e->a < e->b);
            CHECK(d->b < e->b || (d->b == e->b && d->a <= e->a));
        }
        for (b = 0; b < w.blocks; b++) {
            if (SINGLE) /* the rounding of far blocks counts among all */
                continue;
            got = kern_touch(w.block, b, &w.options, one, MAX_POINTS, &none);
            for (k = 0; k < got; k++, all++)
                CHECK(all < w.contacts
                      && same_contact(&w.contact[all], &one[k]));
        }
        if (!SINGLE)
            CHECK_INT(all, w.contacts);
    }
}

/* A stone that leans on a vertical face, turned with its gravity: what carries
   it does not depend on the last digit of the normal, nor does the margin. */
static void lone_on_a_wall(void)
{
    static const double floor_[] = {-3, -1, 3, -1, 3, 0, -3, 0};
    static const double stop[] = {0, 0, 1, 0, 1, 2, 0, 2};
    static const double stone[] = {-0.6, 0.07, -0.45, 0, 0, 0.9, -0.15, 0.97};
    double margin = -1;
    int i, k;
    for (i = 0; i < 40; i++) { /* i = 0: as it is */
        static world w, t;
        static int order[MAX_BLOCKS];
        change c = no_change();
        kern_margin m;
        c.angle = 0.3 * i;
        c.mirror = i % 2;
        world_reset(&w);
        world_polygon(&w, 0, floor_, 4);
        world_polygon(&w, 0, stop, 4);
        world_polygon(&w, 1, stone, 4);
        w.options.mu = R(0.6);
        world_changed(&t, &w, &c, order);
        t.options.lone = t.gravity;
        CHECK(world_touch(&t) > 0);
        for (k = 0; k < t.contacts; k++)
            CHECK(!t.contact[k].line);
        CHECK_INT(measure(&t, &m), KERN_STANDS);
        if (i == 0)
            margin = (double)m.margin;
        CHECK_NEAR(m.margin, margin, SINGLE ? 3e-3 : 1e-5);
    }
}

static const test turned_tests[] = {
    TEST(contact_invariance),
    TEST(contact_order),
    TEST(lone_on_a_wall),
};

#endif
