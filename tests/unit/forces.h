/* forces.h - the least forces. */

#ifndef UNIT_FORCES_H
#define UNIT_FORCES_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "verdict.h"
#include "random.h"
#include "turned.h"
#include "raised.h"
#include "sensitivity.h"

static kern_force least_of[MAX_POINTS];

static kern_status least_forces(const world *w, double d, kern_force *force)
{
    kern_work work = work_of(w);
    const kern_status got = kern_forces(world_task(w, &work), R(d), force);
    if (got == KERN_STANDS)
        CHECK(share_of_forces(w, (double)R(d), force) <= 1.001);
    return got;
}

/* A cube stands on two forces of half its weight, a mass on three points of a
   row on a third at each, a lintel on its piers on a quarter. */
static void forces_by_hand(void)
{
    static world w;
    const double tol = SINGLE ? 1e-4 : 1e-9;
    int k;
    one_cube(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_STANDS);
    for (k = 0; k < 2; k++) {
        CHECK_NEAR(least_of[k].normal, W / 2, tol * W);
        CHECK_NEAR(least_of[k].tangential, 0, tol * W);
    }
    world_reset(&w);
    world_mass(&w, 0, 0, 0, 1);
    world_mass(&w, 1, 0, 0.5, 1);
    for (k = -1; k <= 1; k++)
        world_point(&w, 0, 1, 0, 1, 0.5 * k, 0);
    world_touch(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_STANDS);
    for (k = 0; k < 3; k++)
        CHECK_NEAR(least_of[k].normal, W / 3, tol * W);
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 2);
    world_box(&w, 0, 4, 0, 5, 2);
    world_box(&w, 1, 0, 2, 5, 2.5);
    world_touch(&w);
    CHECK_INT(least_forces(&w, R(0.25), least_of), KERN_STANDS);
    for (k = 0; k < 4; k++) {
        CHECK_NEAR(least_of[k].normal, 2.5 * W / 4, 3 * tol * W);
        CHECK_NEAR(least_of[k].tangential, 0, 3 * tol * W);
    }
}

/* The product of two sets of forces in which the least ones are least. */
static double force_product(const world *w, const kern_force *a,
                            const kern_force *b)
{
    double sum = 0;
    int k;
    for (k = 0; k < w->contacts; k++) {
        const double mu = (double)w->contact[k].mu;
        sum += (double)a[k].normal * (double)b[k].normal;
        if (mu > 0)
            sum += (double)a[k].tangential * (double)b[k].tangential
                 / (mu * mu);
    }
    return sum;
}

/* The force of contact k of w, which may stand elsewhere in t with its blocks
   the other way round. */
static const kern_force *force_at(const world *w, int k, const world *t,
                                  const int *order, const kern_force *force)
{
    const kern_contact *c = &w->contact[k];
    int j;
    for (j = 0; j < t->contacts; j++) {
        const kern_contact *e = &t->contact[j];
        const int turned_round = e->b == order[c->a];
        const double sign = turned_round ? -1 : 1;
        if (memcmp(&e->p, &c->p, sizeof c->p) == 0
            && e->a == order[turned_round ? c->b : c->a]
            && e->b == order[turned_round ? c->a : c->b]
            && fabs(sign * (double)e->n.x - (double)c->n.x) <= 0
            && fabs(sign * (double)e->n.y - (double)c->n.y) <= 0)
            return &force[j];
    }
    return NULL;
}

/* The forces of w, changed by c, are least_of[] within tol; mirrored with it. */
static void forces_changed(const world *w, const change *c, double d,
                           double tol)
{
    static world t;
    static kern_force image[MAX_POINTS];
    static int order[MAX_BLOCKS];
    const int side = c->mirror ? -1 : 1;
    int k;
    world_changed(&t, w, c, order);
    if (least_forces(&t, d, image) != KERN_STANDS) {
        CHECK(SINGLE); /* some are less exact there */
        return;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_force *f = c->shuffle ? force_at(w, k, &t, order, image)
                                         : &image[k];
        CHECK(f != NULL);
        if (!f)
            continue;
        CHECK_NEAR(f->normal, least_of[k].normal, tol);
        CHECK_NEAR(f->tangential, side * least_of[k].tangential, tol);
    }
}

/* Forces of a mirror image are mirrored, those of a structure whose blocks and
   contacts stand in another order the same; and no admissible forces are less:
   f.(g - f) >= 0 for the least f and any g. */
static void forces_laws(void)
{
    static world w;
    const double tol = SINGLE ? 1e-2 : 1e-6;
    int seed, place, k, done = 0, asked_here = 0;
    for (seed = 1; seed <= some(1000); seed++) {
        change c = no_change();
        double margin;
        random_world(&w, (unsigned long long)seed, 15);
        w.given = 1;
        margin = margin_rates(&w, 0);
        sprintf(context, "seed %d", seed);
        for (place = 0; place < 3 && margin > 1e-3 * mean_size(&w); place++) {
            const double d = margin * place * 0.45;
            double most = 0, size;
            if (verdict(&w, d) != KERN_STANDS)
                continue;
            asked_here++;
            if (least_forces(&w, d, least_of) != KERN_STANDS)
                continue;
            done++;
            size = force_product(&w, least_of, least_of);
            CHECK(force_product(&w, least_of, force_of) >= size * (1 - tol));
            for (k = 0; k < w.contacts; k++)
                most = fmax(most, (double)least_of[k].normal);
            for (c.mirror = 0; c.mirror < 2; c.mirror++) {
                c.shuffle = !c.mirror;
                forces_changed(&w, &c, d, tol * most);
            }
        }
    }
    context[0] = 0;
    CHECK(asked_here > some(500));
    CHECK(100 * done >= (SINGLE ? 97 : 99) * asked_here);
}

/* A fall, bad input, too little memory, too little work. */
static void forces_refused(void)
{
    static world w;
    kern_work work;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        least_of[0].normal = -1;
        status = kern_forces(world_task(&w, &work), 0, least_of);
        CHECK(status == (enough ? KERN_STANDS : KERN_NO_SPACE)
              || status == KERN_STANDS);
        enough |= status == KERN_STANDS;
        CHECK((least_of[0].normal >= 0) == enough);
    }
    CHECK(enough);
    w.options.limit = 3;
    CHECK_INT(kern_forces(world_task(&w, &work), 0, least_of), KERN_LIMIT);
    w.options.limit = 0;
    CHECK_INT(kern_forces(world_task(&w, &work), 0, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_forces(NULL, 0, least_of), KERN_BAD_POINTER);
    CHECK_INT(kern_forces(world_task(&w, &work), R(not_a_number()), least_of),
              KERN_BAD_NUMBER);
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 1.6, 0, 2.6, 1);
    world_touch(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_UNDECIDED);
}

static const test forces_tests[] = {
    TEST(forces_by_hand),
    TEST(forces_laws),
    TEST(forces_refused),
};

#endif
