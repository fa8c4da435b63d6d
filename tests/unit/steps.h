/* steps.h - outlines with steps lower than the gap. */

#ifndef UNIT_STEPS_H
#define UNIT_STEPS_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "contact.h"
#include "turned.h"

/* Outlines from clippers and from images have steps lower than the gap. Once
   they are simplified, structures answer as those of outlines without. */

/* A unit box on a bed with friction 0.4 and nothing to push against. */
static void check_slides(world *w)
{
    int side;
    world_touch(w);
    check_contacts(w);
    for (side = -1; side <= 1; side += 2) {
        double value;
        CHECK_INT(load_factor(w, NULL, side, &value), KERN_STANDS);
        CHECK_NEAR(value, 0.4, 2e-3);
        CHECK_INT(tilt(w, side, &value), KERN_STANDS);
        CHECK_NEAR(value, atan(0.4), 2e-3);
    }
}

/* shear/step_1e-12, shear/kerb_1e-9: a step of a rounding was a shear key, with
   load factors of 2.27 and 1. */
static void steps_of_a_rounding(void)
{
    static const double high[] = {1e-12, 1e-9, 1e-6, 1e-4, 9e-4};
    int i;
    for (i = 0; i < 5; i++) {
        const double h = high[i];
        static world w;
        double xy[16] = {0, -1, 1, -1, 1, 0, 0.5, 0, 0.5, 0, 0, 0};
        double on[16] = {0, 0, 0.5, 0, 0.5, 0, 1, 0, 1, 1, 0, 1};
        const double kerb[] = {-2, -1, 3, -1, 3, h, 1, h, 1, 0, -2, 0};
        const double both[] = {-2, -1, 3, -1, 3, h, 1,  h,
                               1,  0,  0, 0,  0, h, -2, h};
        if (SINGLE && h < 1e-6)
            continue;
        sprintf(context, "(step of %g)", h);
        xy[5] = xy[7] = on[5] = on[7] = -h;
        world_reset(&w);
        world_polygon(&w, 0, xy, 6);
        world_polygon(&w, 1, on, 6);
        world_simplify(&w, 1e-3);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
        world_reset(&w);
        world_polygon(&w, 0, kerb, 6);
        world_box(&w, 1, 0, 0, 1, 1);
        world_simplify(&w, 1e-3);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
        world_reset(&w);
        world_polygon(&w, 0, both, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        world_simplify(&w, 1e-3);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
    }
    context[0] = 0;
}

/* A step that is higher than twice the tolerance is one. */
static void steps_that_carry(void)
{
    const double kerb[] = {-2, -1, 3, -1, 3, 2e-3, 1, 2e-3, 1, 0, -2, 0};
    static world w;
    double value;
    world_reset(&w);
    world_polygon(&w, 0, kerb, 6);
    world_box(&w, 1, 0, 0, 1, 1);
    world_simplify(&w, 0.9e-3);
    world_touch(&w);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK(value > 0.9);
    CHECK_INT(load_factor(&w, NULL, -1, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.4, EXACT * 10);
    w.options.gap = R(2.5e-3);
    world_simplify(&w, 2.5e-3);
    check_slides(&w);
    /* shear/lip_2e-6: a sliver of support is one */
    world_reset(&w);
    world_box(&w, 0, -2, -1, SINGLE ? 1e-4 : 2e-6, 0);
    world_box(&w, 0, 0.7, -1, 3, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.4, SINGLE ? 1e-3 : 1e-6);
}

/* The joint between two stones of unit width in an image of n pixels across a
   stone: a row of pixels ends where the joint passes its middle. n = 0: the
   joint as it is. */
static void pixel_joint(world *w, int n, double slope)
{
    static double xy[MAX_VERTICES], on[MAX_VERTICES];
    int c, k = 0, i, last;
    world_reset(w);
    if (n == 0) {
        const double a[] = {0, -1, 1, -1, 1, slope, 0, 0};
        const double b[] = {0, 0, 1, slope, 1, 1 + slope, 0, 1 + slope};
        world_polygon(w, 0, a, 4);
        world_polygon(w, 1, b, 4);
        return;
    }
    last = 0;
    on[k++] = 0;
    on[k++] = 0;
    for (c = 0; c < n; c++) {
        const int high = (int)floor(slope * (c + 0.5) + 0.5);
        if (high != last) {
            on[k++] = (double)c / n;
            on[k++] = (double)last / n;
            on[k++] = (double)c / n;
            on[k++] = (double)high / n;
        }
        last = high;
    }
    on[k++] = 1;
    on[k++] = (double)last / n;
    /* clockwise below, counter-clockwise above */
    for (i = 0; i < k; i++)
        xy[i] = on[i];
    xy[i++] = 1;
    xy[i++] = -1;
    xy[i++] = 0;
    xy[i++] = -1;
    world_polygon(w, 0, xy, i / 2);
    on[k++] = 1;
    on[k++] = 1 + slope;
    on[k++] = 0;
    on[k++] = 1 + slope;
    world_polygon(w, 1, on, k / 2);
}

/* Where a pixel is more than the gap of 1/1000, the gap must be told: a pixel
   and a half, which is also the tolerance. */
static void steps_of_pixels(void)
{
    static const int pixels[] = {100, 300, 1000, 2000};
    static const double degrees[] = {1, 5, 10, 20, 30, 44};
    static world w, t;
    int i, j;
    for (j = 0; j < 6; j++)
        for (i = 0; i < 4; i++) {
            const int n = pixels[i];
            const double slope = tan(degrees[j] * pi / 180);
            const double pixel = 1.0 / n;
            kern_margin m, straight;
            double right, want;
            int side;
            if (4 * slope * n > MAX_VERTICES / 2 - 10)
                continue;
            sprintf(context, "(%d pixels, %g degrees)", n, degrees[j]);
            pixel_joint(&t, 0, slope);
            pixel_joint(&w, n, slope);
            w.options.mu = t.options.mu = R(degrees[j] > 15 ? 1.2 : 0.4);
            w.options.gap = R(n < 2000 ? 1.5 * pixel : 0);
            world_simplify(&w, 1.5 * pixel);
            world_touch(&w);
            world_touch(&t);
            CHECK_INT(w.contacts, 2);
            CHECK_INT(measure(&t, &straight), KERN_STANDS);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, straight.margin, pixel);
            CHECK(abs(m.level - straight.level) <= 1);
            for (side = -1; side <= 1; side += 2) {
                load_factor(&t, NULL, side, &want);
                CHECK_INT(load_factor(&w, NULL, side, &right), KERN_STANDS);
                CHECK_NEAR(right, want, 0.05 * want);
            }
        }
    context[0] = 0;
}

/* stairs/gap_1.01px, default_gap_900px: a joint that was drawn in pixels slides
   where the straight one does, whatever the gap. */
static void steps_that_slide(void)
{
    static world w;
    int trial;
    for (trial = 0; trial < some(660); trial++) {
        double angle, mu, gap;
        int n;
        random_seed(61000u + (unsigned long long)trial);
        n = random_int(20, 120);
        angle = uniform(2, 44) * pi / 180;
        mu = uniform(0.1, 1.2);
        gap = trial % 3 == 0 ? uniform(1 / 1.57, 1)
            : trial % 3 == 1 ? 1.001
                             : uniform(1, 3);
        if (fabs(angle - atan(mu)) < 0.03)
            continue;
        sprintf(context, "(%d pixels, %g rad, friction %g, gap of %g pixels)",
                n, angle, mu, gap);
        pixel_joint(&w, n, tan(angle));
        w.options.mu = R(mu);
        w.options.gap = R(gap / n);
        world_simplify(&w, 1.6 / n);
        CHECK_INT(world_touch(&w), 2);
        CHECK_INT(verdict(&w, 0), angle < atan(mu) ? KERN_STANDS : KERN_FALLS);
    }
    context[0] = 0;
}

/* A knee is a reflex corner where the outline turns and goes on. It is kept
   where it is higher than the tolerance, and straightened where it is lower,
   whichever of the two stones is reflex there. */
static void steps_and_knees(void)
{
    static world w;
    int up, low;
    for (low = 0; low < 2; low++)
        for (up = -1; up <= 1; up += 2) {
            const double h = 1e-3 * up;
            const double bed[] = {0, -1, 1, -1, 1, 0, 0.05, 0, 0, h};
            const double stone[] = {0, h, 0.05, 0, 1, 0, 1, 1, 0, 1};
            world_reset(&w);
            world_polygon(&w, 0, bed, 5);
            world_polygon(&w, 1, stone, 5);
            world_simplify(&w, low ? 1e-3 : 5e-4);
            CHECK_INT(world_touch(&w), low ? 2 : 4);
            check_contacts(&w);
            if (low) {
                CHECK_NEAR(fabs((double)w.contact[0].n.x), 1e-3, 1e-6);
                continue;
            }
            CHECK_NEAR(fabs((double)w.contact[0].travel), 0.475, GEO);
            CHECK_NEAR(w.contact[0].n.x, 0, GEO);
            CHECK_NEAR(w.contact[2].n.x, 0.02 * up / sqrt(1.0004), GEO);
        }
}

/* A stone in a valley, a bed and a slope of 45 degrees, with a riser between
   them. Lower than the tolerance it is no shear key, and
   the stone slides up the slope at tan(45 degrees + atan(mu)); one of two gaps
   holds it. */
static void steps_at_ends(void)
{
    static world w;
    int mirror, high, i, k;
    double load;
    for (mirror = 0; mirror < 2; mirror++)
        for (high = 0; high < 2; high++) {
            const double h = high ? 8e-3 : 3e-3;
            double valley[] = {-1, -1, 3, -1, 2, 1 + h, 1, h, 1, 0, -1, 0};
            double stone[] = {0, 0, 1, 0, 1, h, 1.5, 0.5 + h, 1.5, 1, 0, 1};
            for (i = 0; i < 12 && mirror; i += 2) {
                valley[i] *= -1;
                stone[i] *= -1;
            }
            sprintf(context, "(mirrored %d, high %d)", mirror, high);
            world_reset(&w);
            w.options.gap = R(4e-3);
            world_polygon(&w, 0, valley, 6);
            world_polygon(&w, 1, stone, 6);
            world_simplify(&w, 4e-3);
            CHECK_INT(world_touch(&w), high ? 6 : 4);
            check_contacts(&w);
            for (k = 0; k < w.contacts && !high; k++)
                CHECK(w.contact[k].n.y > R(0.7));
            CHECK_INT(load_factor(&w, NULL, mirror ? -1 : 1, &load),
                      KERN_STANDS);
            CHECK(high ? load > 3 : fabs(load - 1.4 / 0.6) < 0.02);
        }
    context[0] = 0;
}

/* A lip lower than the tolerance at the end of a bed is no shear key, whether it
   stands on the ground beside the stone, or hangs from the stone beside the
   ground; a higher one is. */
static void steps_lips(void)
{
    static const double high[] = {1e-4, 5e-4, 1.1e-3, 2e-3, 3.9e-3, 5e-3};
    static world w;
    double load;
    int k, i, kind, turned;
    for (k = 0; k < 6; k++)
        for (kind = 0; kind < 2; kind++)
            for (turned = 0; turned < 2; turned++) {
                const double h = high[k];
                const double lip[2][10] = {{-1, -1, 3, -1, 1, h, 1, 0, -1, 0},
                                           {0, 0, 1, 0, 1, -h, 2, 1, 0, 1}};
                const double box[2][8] = {{0, 0, 1, 0, 1, 1, 0, 1},
                                          {-1, -1, 1, -1, 1, 0, -1, 0}};
                double xy[10];
                for (i = 0; i < 10; i += 2) { /* the other way round */
                    const int at = turned ? 8 - i : i;
                    xy[at] = lip[kind][i];
                    xy[at + 1] = lip[kind][i + 1];
                }
                sprintf(context, "(lip %g, kind %d, turned %d)", h, kind,
                        turned);
                world_reset(&w);
                w.options.gap = R(4e-3);
                w.options.mu = R(0.4);
                world_polygon(&w, kind, xy, 5);
                world_polygon(&w, !kind, box[kind], 4);
                world_simplify(&w, 4e-3);
                CHECK(world_touch(&w) >= 2);
                CHECK_INT(load_factor(&w, NULL, kind ? -1 : 1, &load),
                          KERN_STANDS);
                CHECK(h > 4e-3 ? load > 0.9 : fabs(load - 0.4) < 5e-3);
            }
    context[0] = 0;
}

/* A ramp lower than the tolerance and longer, in a bed that fits it: one
   contact, on the chord. */
static void steps_of_ramps(void)
{
    static world w;
    const double h = 3e-3;
    const double base[] = {-1, -1, 2, -1, 2, h, 0.53, h, 0.5, 0, -1, 0};
    const double box[] = {0, 0, 0.5, 0, 0.53, h, 1, h, 1, 1, 0, 1};
    double load;
    world_reset(&w);
    w.options.gap = R(4e-3);
    world_polygon(&w, 0, base, 6);
    world_polygon(&w, 1, box, 6);
    world_simplify(&w, h);
    CHECK_INT(world_touch(&w), 2);
    check_contacts(&w);
    CHECK_INT(load_factor(&w, NULL, 1, &load), KERN_STANDS);
    CHECK_NEAR(load, 0.4, 0.005);
}

/* knife/joint_10deg_2000px: the joint of steps_of_pixels() before it was an
   image. */
static void steps_straight_joint(void)
{
    static world w;
    double value;
    kern_margin m;
    pixel_joint(&w, 0, tan(10 * pi / 180));
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.4940021, 1e-4);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK_NEAR(value, tan(atan(0.4) + 10 * pi / 180), 1e-3);
}

/* overlap/whisker: the same stone twice, the second with a whisker that is
   thinner than the gap. */
static void overlap_with_whiskers(void)
{
    static const double whisker[] = {0, 0, 1,      0,  1,       1, 0,
                                     1, 0, 0.5005, -3, 0.50025, 0, 0.5};
    static const double two[] = {0, 0, 1, 0, 1, 0.3,    5,  0.30025, 1, 0.3005,
                                 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5};
    /* two stones with a neck between them, as an image may join them */
    static const double neck[] = {0,   0,      1,   0,      1,   0.5, 1.5, 0.5,
                                  1.5, 0,      2.5, 0,      2.5, 1,   1.5, 1,
                                  1.5, 0.5005, 1,   0.5005, 1,   1,   0,   1};
    static world w;
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    int k, swap;
    for (k = 0; k < 5; k++)
        for (swap = 0; swap < 2; swap++) {
            world_reset(&w);
            if (swap)
                world_box(&w, 1, k == 4 ? 1.5 : 0, 0, k == 4 ? 2.5 : 1, 1);
            if (k == 0)
                world_polygon(&w, 1, whisker, 7);
            else if (k == 1)
                world_polygon(&w, 1, two, 10);
            else if (k == 2)
                world_box(&w, 1, 2e-4, -2e-4, 1 + 2e-4, 1 - 2e-4);
            else
                world_polygon(&w, 1, neck, 12);
            if (!swap)
                world_box(&w, 1, k == 4 ? 1.5 : 0, 0, k == 4 ? 2.5 : 1, 1);
            CHECK_INT(kern_touch(w.block, 1, &w.options, w.contact, MAX_POINTS,
                                 &work),
                      KERN_OVERLAP);
            CHECK(work.fault.value > R(0.001));
        }
    world_reset(&w); /* beside each other, whiskers and all */
    world_polygon(&w, 1, whisker, 7);
    world_box(&w, 1, -1, 0, 0, 0.5);
    CHECK_INT(kern_touch(w.block, 1, &w.options, w.contact, MAX_POINTS, &work),
              4);
}

/* A point contact goes to the middle of the two that are farthest apart, of
   several such pairs the first, as two loops would find it. */
static kern_contact many_points[4800];

static void points_of_one_pair(int n)
{
    kern_contact *c = many_points;
    int i;
    for (i = 0; i < n; i++) {
        memset(&c[i], 0, sizeof c[i]);
        c[i].b = 1;
        c[i].p = vec(i, i * 0.5);
        c[i].n = vec(0.6, 0.8);
    }
    kern_contact_travels(c, n);
    CHECK_NEAR(c[0].travel + c[n - 1].travel, 0, GEO * n);
}

static void travels_of_many(void)
{
    kern_contact *c = many_points;
    int trial, i, j, k;
    for (trial = 0; trial < 196; trial++) {
        const int n = random_int(0, 40), pairs = random_int(1, 4);
        for (i = 0; i < n; i++) {
            const double x = trial % 2 ? random_int(0, 4) : uniform(0, 1);
            const double y = trial % 2 ? random_int(0, 4) : uniform(0, 1);
            memset(&c[i], 0, sizeof c[i]);
            k = random_int(0, pairs - 1);
            c[i].a = chance(0.5) ? 0 : k + 1;
            c[i].b = c[i].a == 0 ? k + 1 : 0;
            c[i].p = vec(x, y);
            c[i].n = vec(0.6, 0.8);
            c[i].travel = R(i);
        }
        kern_contact_travels(c, n);
        for (i = 0; i < n; i++) {
            double widest = 0, x = (double)c[i].p.x, y = (double)c[i].p.y;
            for (j = 0; j < n; j++)
                for (k = j + 1; k < n; k++) {
                    const double dx = (double)(c[k].p.x - c[j].p.x);
                    const double dy = (double)(c[k].p.y - c[j].p.y);
                    if (c[j].a + c[j].b == c[i].a + c[i].b
                        && c[k].a + c[k].b == c[i].a + c[i].b
                        && (double)R(dx * dx + dy * dy) > widest) {
                        widest = (double)R(dx * dx + dy * dy);
                        x = (double)(c[j].p.x + c[k].p.x) / 2;
                        y = (double)(c[j].p.y + c[k].p.y) / 2;
                    }
                }
            CHECK_NEAR(c[i].travel,
                       0.6 * (y - (double)c[i].p.y)
                           - 0.8 * (x - (double)c[i].p.x),
                       GEO);
        }
    }
    CHECK(grows_less(points_of_one_pair, 1200, 32));
    kern_contact_travels(NULL, 0);
    kern_contact_travels(NULL, 3);
    CHECK_NEAR(kern_contact_at(NULL, 0, 0).x, 0, 0);
    CHECK_NEAR(kern_near(NULL, 1).gap, R(0.04), 0);
    CHECK_NEAR(kern_near(NULL, 1).mu, kern_defaults().mu, 0);
}

/* The normal of a given contact may be of any length that has an inverse. */
static void given_normals(void)
{
    const double longest = SINGLE ? (double)FLT_MAX : DBL_MAX;
    const double shortest = SINGLE ? (double)FLT_MIN : DBL_MIN;
    const kern_options o = kern_defaults();
    const double length[] = {shortest * 1e-2, shortest, longest / 2, longest};
    int i;
    for (i = 0; i < 4; i++) {
        kern_contact c[2];
        const int got = contact_make(0, 1, vec(length[i], length[i]), vec(0, 0),
                                     vec(0, 0), R(0.4), &o, c);
        CHECK_INT(got, i == 0 ? (int)KERN_BAD_NORMAL : 1);
        if (got == 1)
            CHECK_NEAR(hypot((double)c[0].n.x - sqrt(0.5),
                             (double)c[0].n.y - sqrt(0.5)),
                       0, GEO);
    }
}

/* ---- random stones with and without steps ---- */

#ifndef STONES
#define STONES 2000
#endif

/* An edge of a polygon, and the outline that it is copied to. */
typedef struct edge_copy {
    double *out;
    int to; /* numbers that are written */
    double x, y, tx, ty, length;
} edge_copy;

/* A point so far along the edge, and a share of a height to its right. */
static void put_point(edge_copy *e, double at, double high, double share)
{
    e->out[e->to++] = e->x + e->tx * at + e->ty * high * share;
    e->out[e->to++] = e->y + e->ty * at - e->tx * high * share;
}

/* A pair of risers, upright, inclined or broken, in one of some equal parts of
   the edge: out of the stone or into it by less than a gap, and back. */
static void put_risers(edge_copy *e, int pair, int pairs, double gap)
{
    double at, high, run, part;
    high = gap * pow(10, uniform(SINGLE ? -3 : -9, log10(0.9)));
    high *= chance(0.5) ? 1 : -1;
    at = chance(0.2) ? uniform(0.1, 3) * gap
                     : uniform(0.05, 0.9) * e->length / pairs;
    at += e->length * pair / pairs;
    run = chance(0.5) ? 0 : fabs(high) * uniform(0, 1);
    part = chance(0.3) ? uniform(0.2, 0.8) : 0;
    put_point(e, at, high, 0);
    at += run;
    if (part > 0)
        put_point(e, at - run * 0.7, high, part);
    put_point(e, at, high, 1);
    at += ((pair + 1.0) / pairs * e->length - at - 3 * run) * uniform(0.1, 0.9);
    put_point(e, at, high, 1);
    at += run;
    if (part > 0)
        put_point(e, at - run * 0.7, high, part);
    put_point(e, at, high, 0);
}

/* The polygon xy with risers in the edges that `rough` has a bit for. Returns
   how many vertices there are. */
static int roughened(double *out, const double *xy, int n, int rough,
                     double gap)
{
    edge_copy e;
    int i, k;
    e.out = out;
    e.to = 0;
    for (i = 0; i < n; i++) {
        const double *p = xy + 2 * i, *q = xy + 2 * ((i + 1) % n);
        const int pairs = rough >> i & 1 ? random_int(1, 3) : 0;
        e.x = p[0];
        e.y = p[1];
        e.length = hypot(q[0] - p[0], q[1] - p[1]);
        e.tx = (q[0] - p[0]) / e.length;
        e.ty = (q[1] - p[1]) / e.length;
        put_point(&e, 0, 0, 0);
        for (k = 0; k < pairs; k++)
            put_risers(&e, k, pairs, gap);
    }
    return e.to / 2;
}

/* A random stone of three to seven corners around (0, 0). */
static int round_stone(double *xy)
{
    const int n = random_int(3, 7);
    const double turn = uniform(0, 2 * pi);
    int i;
    for (i = 0; i < n; i++) {
        const double angle = turn + 2 * pi * (i + uniform(-0.2, 0.2)) / n;
        xy[2 * i] = cos(angle);
        xy[2 * i + 1] = sin(angle);
    }
    return n;
}

/* A fixed neighbour of the edge from p to q: a box along part of it, a box with
   a corner on it, or one on whose edge corner q stands. */
static int neighbour(double *xy, const double *p, const double *q)
{
    const double long_ = hypot(q[0] - p[0], q[1] - p[1]);
    const double tx = (q[0] - p[0]) / long_, ty = (q[1] - p[1]) / long_;
    const double from = uniform(-0.3, 0.7) * long_;
    const double wide_ = uniform(0.2, 1) * long_, deep = uniform(0.2, 1);
    double turn = 0;
    int i;
    for (i = 0; i < 4; i++) {
        const double along = i == 0 || i == 3 ? 0 : wide_;
        const double out = i == 0 || i == 1 ? deep : 0;
        xy[2 * i] = along;
        xy[2 * i + 1] = -out;
    }
    if (chance(0.3))
        turn = uniform(0.2, 1.2);
    for (i = 0; i < 4; i++) { /* corner 3 is its place on the edge */
        const double x = xy[2 * i] * cos(turn) + xy[2 * i + 1] * sin(turn);
        const double y = -xy[2 * i] * sin(turn) + xy[2 * i + 1] * cos(turn);
        xy[2 * i] = p[0] + tx * (x + from) - ty * y;
        xy[2 * i + 1] = p[1] + ty * (x + from) + tx * y;
    }
    return 4;
}

/* Has each contact of w one of t at its place, and none another? */
static int same_supports(const world *w, const world *t, double gap)
{
    int i, j, ok = w->contacts == t->contacts;
    for (i = 0; i < w->contacts && ok; i++) {
        const kern_contact *c = &w->contact[i];
        int found = 0;
        for (j = 0; j < t->contacts; j++) {
            const kern_contact *d = &t->contact[j];
            found |= c->a == d->a && c->b == d->b && c->line == d->line
                  && hypot((double)(c->p.x - d->p.x), (double)(c->p.y - d->p.y))
                         <= gap
                  && (double)(c->n.x * d->n.x + c->n.y * d->n.y)
                         >= cos((double)w->options.angle);
        }
        ok = found;
    }
    return ok;
}

/* Is the polygon a good one? Steps near a sharp corner may cross. */
static int is_simple(const double *xy, int n)
{
    kern_vec v[200];
    kern_block b;
    int i;
    for (i = 0; i < n; i++)
        v[i] = vec(xy[2 * i], xy[2 * i + 1]);
    return kern_block_init(&b, v, n, R(1), NULL) == KERN_OK;
}

/* A stone with a fixed neighbour, in w as they are, in t with steps in the one
   or the other. Returns 0 where they have no contacts. */
static int stone_with_steps(world *w, world *t, int trial)
{
    double stone[14], other[8], rough[400], gap;
    int n, edge, k;
    random_seed(52000u + (unsigned long long)trial);
    sprintf(context, "(stone %d)", trial);
    n = round_stone(stone);
    edge = random_int(0, n - 1);
    neighbour(other, stone + 2 * edge, stone + 2 * ((edge + 1) % n));
    world_reset(w);
    world_polygon(w, 1, stone, n);
    world_polygon(w, 0, other, 4);
    gap = 1e-3 * sqrt(fabs((double)w->block[0].area));
    if (world_touch(w) <= 0)
        return 0; /* one in the other */
    world_reset(t);
    k = roughened(rough, stone, n, trial % 2 ? random_int(1, 127) : 0, gap);
    if (!is_simple(rough, k))
        return 0;
    world_polygon(t, 1, rough, k);
    k = roughened(rough, other, 4, trial % 2 ? 0 : random_int(1, 15), gap);
    if (!is_simple(rough, k))
        return 0;
    world_polygon(t, 0, rough, k);
    world_simplify(t, 0.92 * gap);
    CHECK(world_touch(t) > 0);
    return 1;
}

/* No support is lost, and none won. In float one contact of all ends two gaps
   earlier: a vertex of a step that stands out farther than the corner beside it
   becomes the corner. */
static void steps_in_random_stones(void)
{
    int trial, cases = 0, other = 0;
    for (trial = 0; trial < STONES; trial++) {
        static world w, t;
        if (!stone_with_steps(&w, &t, trial))
            continue;
        cases++;
        check_contacts(&t);
        CHECK_INT(t.contacts, w.contacts);
        other += !same_supports(&w, &t,
                                1.125e-3 * sqrt(fabs((double)w.block[0].area)));
    }
    context[0] = 0;
    CHECK(cases > STONES / 4 * 3);
    CHECK(other <= (SINGLE ? 1 : 0));
}

/* Contacts at steps are the same whichever way the world is turned, mirrored,
   scaled, and in whichever order the blocks are. */
static void steps_invariance(void)
{
    static world w, t, u, v;
    static int order[MAX_BLOCKS];
    int trial, k;
    for (trial = 0; trial < 600; trial++) {
        change c = no_change();
        double gap;
        if (trial < 60) {
            const int n = random_int(60, 150);
            pixel_joint(&w, n, uniform(0.01, 0.9));
            w.options.gap = R(1.5 / n);
            world_simplify(&w, 1.6 / n);
            CHECK_INT(world_touch(&w), 2);
        } else if (!stone_with_steps(&t, &w, trial))
            continue;
        gap = w.options.gap > 0 ? (double)w.options.gap : 1.125e-3;
        if (trial % 4 == 0)
            c.shuffle = 1;
        if (trial % 4 == 1)
            c.mirror = 1;
        if (trial % 4 == 2)
            c.scale = pow(10, uniform(-2, 2));
        if (trial % 4 == 3)
            c.angle = uniform(-pi, pi);
        world_changed(&u, &w, &c, order);
        /* and back: the contacts of u in the frame of w */
        world_copy(&v, &w);
        v.contacts = u.contacts;
        for (k = 0; k < u.contacts; k++) {
            const kern_contact *d = &u.contact[k];
            const int swap = order[0] > order[1];
            const double x = ((double)d->p.x) / c.scale;
            const double y = ((double)d->p.y) / c.scale;
            const double cs = cos(c.angle), sn = sin(c.angle);
            const double sign = c.mirror ? -1 : 1, side = swap ? -1 : 1;
            v.contact[k] = *d;
            v.contact[k].a = 0;
            v.contact[k].b = 1;
            v.contact[k].p = vec(sign * (x * cs + y * sn), y * cs - x * sn);
            v.contact[k].n = vec(
                side * sign * ((double)d->n.x * cs + (double)d->n.y * sn),
                side * ((double)d->n.y * cs - (double)d->n.x * sn));
        }
        CHECK(same_supports(&w, &v, gap * (SINGLE ? 0.1 : 0.01)));
    }
    context[0] = 0;
}

/* The structure with steps in some edges of its stones, lower than half the gap
   of the smallest, so that two on each other do not reach into each other. */
static int structure_with_steps(world *to, const world *from)
{
    double least = huge_value();
    int i, k;
    for (i = 0; i < from->blocks; i++)
        if (!from->block[i].fixed)
            least = fmin(least, sqrt(fabs((double)from->block[i].area)));
    world_reset(to);
    to->gravity = from->gravity;
    to->options = from->options;
    for (i = 0; i < from->blocks; i++) {
        const kern_block *b = &from->block[i];
        double xy[32], rough[600];
        if (b->vertices < 3 || b->vertices > 16)
            return 0;
        for (k = 0; k < b->vertices; k++) {
            const kern_vec v = b->vertex[b->area < 0 ? b->vertices - 1 - k : k];
            xy[2 * k] = (double)v.x;
            xy[2 * k + 1] = (double)v.y;
        }
        k = roughened(rough, xy, b->vertices, random_int(0, 65535),
                      0.45e-3 * least);
        if (k > 190 || !is_simple(rough, k) || to->vertices + k > MAX_VERTICES)
            return 0;
        world_polygon(to, 1, rough, k);
        to->block[i].fixed = b->fixed;
        to->block[i].mass = b->mass;
        to->block[i].centre = b->centre;
        to->block[i].load = b->load;
    }
    world_simplify(to, 0.45e-3 * least);
    return world_touch(to) > 0;
}

/* No structure falls because its stones have steps, and none bears more. */
/* What stands with a margin of more than a gap, by which an end of a contact
   moves, stands still. */
static void check_stays(const world *w, int got, const kern_margin *m, int now)
{
    if (got == KERN_STANDS && (double)m->margin > 0.01 * mean_size(w))
        CHECK(now == KERN_STANDS || (SINGLE && now == KERN_UNDECIDED));
}

/* Two load factors of about the same structure. */
static void check_like_load(const world *w, const world *t)
{
    double factor, rough;
    if (load_factor(w, NULL, 1, &factor) != KERN_STANDS
        || load_factor(t, NULL, 1, &rough) != KERN_STANDS)
        return;
    if (isinf(factor) || isinf(rough))
        CHECK(isinf(factor) && isinf(rough));
    else
        CHECK_NEAR(rough, factor, 0.05 * factor + 0.01);
}

static void steps_in_random_structures(void)
{
    static world w, t;
    int seed, cases = 0;
    for (seed = 0; seed < 2000; seed++) {
        kern_margin m, n;
        int got, now;
        random_of_kind(&w, 83000u + (unsigned long long)seed, 8, seed % KINDS);
        w.options.relative = 0;
        w.options.epsilon = 0;
        if (w.given || w.contacts < 1 || w.contacts > 60
            || !structure_with_steps(&t, &w))
            continue;
        cases++;
        got = measure(&w, &m);
        now = measure(&t, &n);
        check_stays(&w, got, &m, now);
        check_stays(&w, now, &n, got);
        if (!SINGLE && got == KERN_STANDS && now == KERN_STANDS)
            check_like_load(&w, &t);
    }
    context[0] = 0;
    CHECK(cases > 500);
}

static const test steps_tests[] = {
    TEST(steps_of_a_rounding),
    TEST(steps_that_carry),
    TEST(steps_of_pixels),
    TEST(steps_that_slide),
    TEST(steps_and_knees),
    TEST(steps_at_ends),
    TEST(steps_lips),
    TEST(steps_of_ramps),
    TEST(steps_straight_joint),
    TEST(overlap_with_whiskers),
    TEST(travels_of_many),
    TEST(given_normals),
    TEST(steps_in_random_stones),
    TEST(steps_invariance),
    TEST(steps_in_random_structures),
};

#endif
