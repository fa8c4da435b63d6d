/* contact.h - contacts, found and given; each rule where it alone decides. */

#ifndef UNIT_CONTACT_H
#define UNIT_CONTACT_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "verdict.h"

/* Is there a contact point between a and b at (x, y) with the normal (nx, ny)
   from a into b? Also where it was reported from b into a. */
static int contact_at(const world *w, int a, int b, double x, double y,
                      double nx, double ny, double tol)
{
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const double sign = c->a == a && c->b == b ? 1
                          : c->a == b && c->b == a ? -1
                                                   : 0;
        if (fabs(sign) > 0 && fabs((double)c->p.x - x) <= tol
            && fabs((double)c->p.y - y) <= tol
            && fabs(sign * (double)c->n.x - nx) <= tol
            && fabs(sign * (double)c->n.y - ny) <= tol)
            return 1;
    }
    return 0;
}

static int lines_of(const world *w)
{
    int k, n = 0;
    for (k = 0; k < w->contacts; k++)
        n += w->contact[k].line ? 1 : 0;
    return n / 2;
}

/* What holds of every set of contacts: unit normals, ends in pairs with the
   same normal and opposite travels, travels as defined. */
static void check_contacts(const world *w)
{
    static wide travel[MAX_POINTS];
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        CHECK(c->a >= 0 && c->a < w->blocks && c->b >= 0 && c->b < w->blocks
              && c->a != c->b);
        CHECK(!(w->block[c->a].fixed && w->block[c->b].fixed));
        CHECK_NEAR(hypot((double)c->n.x, (double)c->n.y), 1, 8 * EPS);
        CHECK_NEAR(c->travel, travel[k],
                   64 * EPS
                       * (1 + fabs((double)c->p.x) + fabs((double)c->p.y)));
        if (c->line && k + 1 < w->contacts && w->contact[k + 1].line
            && c->travel > 0 && w->contact[k + 1].travel < 0) {
            const kern_contact *e = c + 1;
            CHECK(c->a == e->a && c->b == e->b);
            CHECK_NEAR(c->n.x, e->n.x, 0);
            CHECK_NEAR(c->n.y, e->n.y, 0);
            CHECK_NEAR(c->mu, e->mu, 0);
            k++;
        }
    }
}

/* Contact points at both ends of a level bed between blocks 0 and 1. */
static void bed_at(const world *w, double x0, double x1, double y)
{
    CHECK(contact_at(w, 0, 1, x0, y, 0, 1, GEO));
    CHECK(contact_at(w, 0, 1, x1, y, 0, 1, GEO));
}

/* The unit cube and one with its lower left corner at (x, y): their contact is
   the line from `from` to (1, 1). */
static void cubes_touch(world *w, double x, double y, kern_vec from, kern_vec n)
{
    world_reset(w);
    world_box(w, 0, 0, 0, 1, 1);
    world_box(w, 1, x, y, x + 1, y + 1);
    CHECK_INT(world_touch(w), 2);
    CHECK(contact_at(w, 0, 1, from.x, from.y, n.x, n.y, GEO));
    CHECK(contact_at(w, 0, 1, 1, 1, n.x, n.y, GEO));
    CHECK_INT(lines_of(w), 1);
    check_contacts(w);
}

static void contact_cube_on_cube(void)
{
    static world w;
    kern_vec p;
    int k;
    cubes_touch(&w, 0, 1, vec(0, 1), vec(0, 1));
    for (k = 0; k < 2; k++) {
        const kern_contact *c = &w.contact[k];
        const double out = c->p.x < R(0.5) ? -1 : 1;
        CHECK_NEAR(c->mu, R(0.4), 0);
        CHECK_NEAR(fabs((double)c->travel), 0.5, GEO);
        p = kern_contact_at(c, R(0.2), 0);
        CHECK_NEAR(p.x, 0.5 + out * 0.3, GEO);
        CHECK_NEAR(p.y, 1, GEO);
        p = kern_contact_at(c, R(7), 0); /* closed */
        CHECK_NEAR(p.x, 0.5, GEO);
        p = kern_contact_at(c, R(-0.3), 0); /* grown */
        CHECK_NEAR(p.x, 0.5 + out * 0.8, GEO);
        p = kern_contact_at(c, R(0.2), 1); /* a share of 1/2 */
        CHECK_NEAR(p.x, 0.5 + out * 0.4, GEO);
        p = kern_contact_at(c, R(-3), 1);
        CHECK_NEAR(p.x, 0.5 + out * 2, GEO);
    }
    cubes_touch(&w, 0.3, 1, vec(0.3, 1), vec(0, 1));
    cubes_touch(&w, 1, 0.25, vec(1, 0.25), vec(1, 0)); /* a head joint */
    /* friction of contacts found is the options' */
    w.options.mu = R(0.7);
    CHECK_INT(world_touch(&w), 2);
    CHECK_NEAR(w.contact[0].mu, R(0.7), 0);
}

static void contact_two_feet(void)
{
    static const double bridge[] = {0, 0, 1, 0, 1, 1, 2, 1,
                                    2, 0, 3, 0, 3, 2, 0, 2};
    static world w;
    world_reset(&w);
    world_box(&w, 0, -5, -1, 5, 0);
    world_polygon(&w, 1, bridge, 8);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 1);
    bed_at(&w, 0, 3, 0);
    check_contacts(&w);
    /* feet at two heights of one stepped bed are two faces */
    {
        static const double bed[] = {-5,  -2, 5,   -2,  5,  0,
                                     1.5, 0,  1.5, 0.5, -5, 0.5};
        static const double step[] = {0, 0.5, 1, 0.5, 1, 1, 2, 1,
                                      2, 0,   3, 0,   3, 2, 0, 2};
        world_reset(&w);
        world_polygon(&w, 0, bed, 6);
        world_polygon(&w, 1, step, 8);
        CHECK_INT(world_touch(&w), 4);
        CHECK_INT(lines_of(&w), 2);
        bed_at(&w, 0, 1, 0.5);
        bed_at(&w, 2, 3, 0);
        check_contacts(&w);
    }
}

static void contact_concave(void)
{
    static const double cup[] = {-1, -1, 2, -1, 2, 1, 1,  1,
                                 1,  0,  0, 0,  0, 1, -1, 1};
    static const double ell[] = {-1, -1, 3, -1, 3, 0, 0, 0, 0, 3, -1, 3};
    static const double wedge[] = {0, 0, 2, 1, 1, 2};
    static const double tee[] = {0.5, 0, 1.5,  0, 1.5,  1, 2.5, 1,
                                 2.5, 2, -0.5, 2, -0.5, 1, 0.5, 1};
    static world w;
    /* a cube that fills a cup: bottom and both sides, no points in corners */
    world_reset(&w);
    world_polygon(&w, 0, cup, 8);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(&w), 6);
    CHECK_INT(lines_of(&w), 3);
    bed_at(&w, 0, 1, 0);
    CHECK(contact_at(&w, 0, 1, 0, 0, 1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 0, 1, 1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 1, 0, -1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 1, 1, -1, 0, GEO));
    check_contacts(&w);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    /* a wedge whose corner sits in the corner of an L: two points there */
    world_reset(&w);
    world_polygon(&w, 0, ell, 6);
    world_polygon(&w, 1, wedge, 3);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 0);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    CHECK(contact_at(&w, 0, 1, 0, 0, 1, 0, GEO));
    check_contacts(&w);
    /* a T hung over two posts: under both arms */
    world_reset(&w);
    world_box(&w, 0, -1, -1, 0.4, 1);
    world_box(&w, 0, 1.6, -1, 3, 1);
    world_polygon(&w, 1, tee, 8);
    CHECK_INT(world_touch(&w), 4);
    CHECK(contact_at(&w, 0, 2, -0.5, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 0, 2, 0.4, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 1, 2, 1.6, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 1, 2, 2.5, 1, 0, 1, GEO));
}

static void contact_points(void)
{
    static const double diamond[] = {0, 0, 1, 1, 0, 2, -1, 1};
    static const double roof[] = {-2, -2, 2, -2, 0, 0};
    static world w;
    /* a vertex on an edge: the normal is the edge's */
    world_reset(&w);
    world_box(&w, 0, -2, -1, 2, 0);
    world_polygon(&w, 1, diamond, 4);
    CHECK_INT(world_touch(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    CHECK(!w.contact[0].line);
    CHECK_NEAR(w.contact[0].travel, 0, 0);
    /* an edge on a vertex */
    world_reset(&w);
    world_polygon(&w, 0, roof, 3);
    world_box(&w, 1, -1, 0, 1.5, 1);
    CHECK_INT(world_touch(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    /* corner on corner carries nothing, also between diagonal neighbours */
    world_reset(&w);
    world_polygon(&w, 0, roof, 3);
    world_polygon(&w, 1, diamond, 4);
    CHECK_INT(world_touch(&w), 0);
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 1, 2, 2);
    CHECK_INT(world_touch(&w), 0);
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    world_box(&w, 1, 0, 1, 1, 2);
    world_box(&w, 1, 1, 1, 2, 2);
    CHECK_INT(world_touch(&w), 8);
    CHECK_INT(lines_of(&w), 4);
    /* diagonal neighbours with a rounding between them: still nothing */
    {
        const double r = 16 * EPS;
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 - r, 1, 2, 2);
        CHECK_INT(world_touch(&w), 0);
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 - r, 1 - r, 2, 2);
        CHECK_INT(world_touch(&w), 0);
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 + r, 1 - r, 2, 2);
        CHECK_INT(world_touch(&w), 0);
    }
    /* two ground blocks may overlap and have no contacts */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 1);
    world_box(&w, 0, 0.5, 0, 2, 1);
    world_box(&w, 1, 5, 5, 6, 6);
    CHECK_INT(world_touch(&w), 0);
}

static void contact_merged_faces(void)
{
    static const double kinked[] = {-2, -1, 4, -1, 4, 0, 1, 1e-4, -2, 0};
    static world w;
    int k;
    /* a bed with a vertex in it */
    world_reset(&w);
    world_polygon(&w, 0, kinked, 5);
    world_box(&w, 1, 0.25, 1e-4, 1.75, 1);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 1);
    for (k = 0; k < 2; k++) {
        CHECK_NEAR(fabs((double)w.contact[k].p.x - 1), 0.75, 1e-4);
        CHECK_NEAR(w.contact[k].p.y, 1e-4, 1e-4);
    }
    check_contacts(&w);
    /* collinear vertices change nothing */
    {
        static const double bed[] = {-2, -1, 4, -1,  4, 0,  1.1,
                                     0,  1,  0, 0.5, 0, -2, 0};
        world_reset(&w);
        world_polygon(&w, 0, bed, 7);
        world_box(&w, 1, 0.25, 0, 1.75, 1);
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0.25, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 1.75, 0, 0, 1, GEO));
    }
    /* two blocks of the bed are two interfaces */
    world_reset(&w);
    world_box(&w, 0, 0, -1, 1, 0);
    world_box(&w, 0, 1, -1, 2, 0);
    world_box(&w, 1, 0.25, 0, 1.75, 1);
    CHECK_INT(world_touch(&w), 4);
    CHECK_INT(lines_of(&w), 2);
    check_contacts(&w);
}

/* A cube set on the floor at one corner and turned up by `angle`. */
static int turned_cube(world *w, double angle)
{
    const double c = cos(angle), s = sin(angle);
    double xy[8];
    xy[0] = 0;
    xy[1] = 0;
    xy[2] = c;
    xy[3] = s;
    xy[4] = c - s;
    xy[5] = s + c;
    xy[6] = -s;
    xy[7] = c;
    world_reset(w);
    world_box(w, 0, -5, -1, 5, 0);
    world_polygon(w, 1, xy, 4);
    return world_touch(w);
}

static void contact_angle(void)
{
    static world w;
    const double one = (double)kern_defaults().angle,
                 off = SINGLE ? 1e-5 : 1e-7;
    const double gap = 1e-3, half = (one - off) / 2,
                 way = gap / (2 * tan(half));
    CHECK_NEAR(one, 0.0174533, 1e-7);
    CHECK_NEAR(kern_defaults().mu, R(0.4), 0);
    /* just within the angle: the part where they are within the gap */
    CHECK_INT(turned_cube(&w, one - off), 2);
    CHECK_INT(lines_of(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, -sin(half), cos(half), 1e3 * GEO));
    CHECK(contact_at(&w, 0, 1, way * cos(half), way * sin(half), -sin(half),
                     cos(half), SINGLE ? 1e-4 : 1e-9));
    /* just beyond: a corner */
    CHECK_INT(turned_cube(&w, one + off), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
}

/* A box of a width and height, lower left corner at (x, y), on wide ground. */
static int box_on_ground(world *w, double x, double y, double width,
                         double height)
{
    world_reset(w);
    world_box(w, 0, -5, -1, 5, 0);
    world_box(w, 1, x, y, x + width, y + height);
    return world_touch(w);
}

/* The rules of contacts (>>rules in kern.h), each where it alone decides: a
   stone on ground, how many contact points there are, and where some are, with
   the x of their normals, which point up. */
static const struct rule {
    int tiny;                     /* too small for float                     */
    double gap;                   /* 0: 1e-3 of the stone's size             */
    double ground[24], stone[20]; /* vertices, until the first 99            */
    int points, lines;
    double at[4][3]; /* x, y, n.x, until the first 99           */
} contact_rule[] = {
    /* a point is the vertex, not midway to the edge */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0.01, 1, 1, -1, 1, 99},
     1,
     0,
     {{0, 0.01, 0}, {99}}},
    /* what is longer than the gap is a line, however short beside the stone */
    {0,
     1e-4,
     {-1, -1, 2e-4, -1, 2e-4, 0, -1, 0, 99},
     {0, 0, 1, 0, 1, 1, 0, 1, 99},
     2,
     1,
     {{0, 0, 0}, {2e-4, 0, 0}, {99}}},
    /* a tip beside a stone, within the gap of its bed, has another normal */
    {0,
     0.01,
     {-1, -1, 2, -1, 2, 0, -0.03, 0, 0, 0.005, -0.03, 0.03, -1, 0.03, 99},
     {0, 0, 1, 0, 1, 1, 0, 1, 99},
     3,
     1,
     {{0, 0, 0}, {1, 0, 0}, {0, 0.005, 1}, {99}}},
    /* a tip on a shelf below another has the normal of the line on that one */
    {0,
     0,
     {-1, -1, 1, -1, 1, 0, 0, 0, 0, 0.7, 1, 0.7, 1, 1, -1, 1, 99},
     {0.5, 0, 1.5, 0.2, 1.5, 1.3, 0, 1.3, 0, 1, 1.2, 1, 1.2, 0.5, 0.2, 0.3, 99},
     3,
     1,
     {{0, 1, 0}, {1, 1, 0}, {0.5, 0, 0}, {99}}},
    /* of two on one line, one bears the stone and one holds it down */
    {0,
     0,
     {-2,  -1, 0, -1, 0, 0, -1.2, 0,  -1.2, 0.8, 1,
      0.8, 1,  0, 2,  0, 2, 1.2,  -2, 1.2,  99},
     {-1, 0, 0.2, 0, 0.2, -0.3, 2, -0.3, 2, 0, 0.6, 0, 0.6, 0.3, -1, 0.3, 99},
     4,
     2,
     {{-1, 0, 0}, {0, 0, 0}, {99}}},
    /* a bed that bends by more than the angle is two, also within the gap */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, 0, 0, -1, 0.05, 99},
     {-0.3, 0.015, 0, 0, 0.7, 0, 0.7, 1, -0.3, 1, 99},
     4,
     2,
     {{0, 0, 0}, {0.7, 0, 0}, {99}}},
    /* so is one within the angle whose end is off the line of the other */
    {0,
     0,
     {-2, -1, 1.5, -1, 1.5, 0.0025, 0.5, -0.0025, 0.5, -0.5, 0, -0.5, 0, 0, -2,
      0, 99},
     {-2, 0, 0, 0, 0.5, -0.0025, 1.5, 0.0025, 1.5, 0.5, -2, 0.5, 99},
     4,
     2,
     {{-2, 0, 0}, {0, 0, 0}, {99}}},
    /* normals count by length: tilts of 0.0005 over 1 and -0.001 over 0.5 */
    {0,
     0.01,
     {-2, -1, 2, -1, 2, 0, -2, 0, 99},
     {-1, 0.001, 0, 0, 0.5, 0.001, 0.5, 1, -1, 1, 99},
     2,
     1,
     {{-1, 0.0005, 0}, {0.5, 0.0005, 0}, {99}}},
    /* points count alike: on slopes of 0.004 and -0.002 */
    {0,
     0.01,
     {-1, -1, 1, -1, 1, -0.002, 0, 0, -1, -0.004, 99},
     {-0.5, -0.002, 0, 0.5, 0.5, -0.001, 1, 1, -1, 1, 99},
     2,
     1,
     {{-0.5, -0.002, -0.001}, {0.5, -0.001, -0.001}, {99}}},
    /* a notch less deep than the gap does not part a face */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, 0.1, 0, 0.1, -0.01, -0.1, -0.01, -0.1, 0, -1, 0, 99},
     {-0.5, 0.008, 0.5, 0.008, 0.5, 1, -0.5, 1, 99},
     2,
     1,
     {{-0.5, 0.004, 0}, {0.5, 0.004, 0}, {99}}},
    /* a tooth less high than the gap does not, where the outline begins */
    {0,
     0.05,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 0.02, 0.04, 1, 0.04, 1, 1, -1, 1, -1, 0.04, -0.02, 0.04, 99},
     2,
     1,
     {{-1, 0.02, 0}, {1, 0.02, 0}, {99}}},
    /* two beds at different heights, within the gap, are one face */
    {0,
     0.3,
     {-1, -1, 1, -1, 1, -0.21, 0, -0.21, 0, 0, -1, 0, 99},
     {-1, 0, 1, 0, 1, 0.5, -1, 0.5, 99},
     2,
     1,
     {{-1, -0.0525, 0}, {1, -0.0525, 0}, {99}}},
    /* a point beside a line within 10 degrees (here 9.5, then 10.5) is none */
    {0,
     0,
     {-1, -1, 1, -1, 1, 0.16734, 0, 0, -1, 0, 99},
     {-0.5, 0, 0, 0, 1, 0.5, 1, 2, -0.5, 2, 99},
     2,
     1,
     {{99}}},
    {0,
     0,
     {-1, -1, 1, -1, 1, 0.18534, 0, 0, -1, 0, 99},
     {-0.5, 0, 0, 0, 1, 0.5, 1, 2, -0.5, 2, 99},
     3,
     1,
     {{99}}},
    /* 1e-6 of the size: a foot so close to the end is none, */
    {1,
     0,
     {-1, -1, 0, -1, 0, 0, -1, 0, 99},
     {-0.7e-6, 0, 1, 1, -1, 1, 99},
     0,
     0,
     {{99}}},
    {1,
     0,
     {-1, -1, 0, -1, 0, 0, -1, 0, 99},
     {-1.4e-6, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{-1.4e-6, 0, 0}, {99}}},
    /* a face so short is a point, */
    {1,
     0,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 0.7e-6, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{0.35e-6, 0, 0}, {99}}},
    {1,
     0,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 1.4e-6, 0, 1, 1, -1, 1, 99},
     2,
     1,
     {{0, 0, 0}, {1.4e-6, 0, 0}, {99}}},
    /* and a vertex that turns by less is no corner, which bears nothing */
    {1,
     0,
     {-1, -1, 1, -1, 1, -0.35e-6, 0, 0, -1, -0.35e-6, 99},
     {0, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{0, 0, 0}, {99}}},
    {1,
     0,
     {-1, -1, 1, -1, 1, -0.7e-6, 0, 0, -1, -0.7e-6, 99},
     {0, 0, 1, 1, -1, 1, 99},
     0,
     0,
     {{99}}},
};

static int rule_polygon(world *w, double density, const double *xy)
{
    int n = 0;
    while (xy[2 * n] < 99)
        n++;
    return world_polygon(w, density, xy, n);
}

static void contact_rules(void)
{
    static world w;
    size_t i;
    int k;
    for (i = 0; i < sizeof contact_rule / sizeof contact_rule[0]; i++) {
        const struct rule *r = &contact_rule[i];
        if (SINGLE && r->tiny)
            continue;
        sprintf(context, "(rule %d)", (int)i);
        world_reset(&w);
        w.options.gap = R(r->gap);
        rule_polygon(&w, 0, r->ground);
        rule_polygon(&w, 1, r->stone);
        CHECK_INT(world_touch(&w), r->points);
        CHECK_INT(lines_of(&w), r->lines);
        for (k = 0; k < 4 && r->at[k][0] < 99; k++)
            CHECK(contact_at(&w, 0, 1, r->at[k][0], r->at[k][1], r->at[k][2],
                             sqrt(1 - r->at[k][2] * r->at[k][2]),
                             r->tiny  ? 1e-9
                             : SINGLE ? 1e-5
                                      : 2e-6));
        check_contacts(&w);
    }
    context[0] = 0;
}

/* No gap is less than 64 roundings of the largest coordinate. */
static void contact_floor(void)
{
    static world w;
    const double least = 64 * EPS * 5; /* the ground ends at 5 */
    CHECK_INT(box_on_ground(&w, 0, 0.7 * least, 1, 1), 2);
    w.options.gap = R(1e-3 * least);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(box_on_ground(&w, 0, 1.4 * least, 1, 1), 2);
    w.options.gap = R(1e-3 * least);
    CHECK_INT(world_touch(&w), 0);
}

/* The gap tolerance is a thousandth of the smaller free block's size, unless
   the user gives one, which holds for all pairs. */
static void contact_gap(void)
{
    static world w;
    const double gap = 1e-3, tiny = SINGLE ? 1e-3 : 1e-6;
    int k;
    for (k = 0; k < 6; k++) {
        const double size = k < 2 ? 1 : k < 4 ? 0.5 : 3;
        const double lift = size * gap * (k % 2 ? 1 + tiny : 1 - tiny);
        CHECK_INT(box_on_ground(&w, 0, lift, size, size), k % 2 ? 0 : 2);
        if (k % 2 == 0)
            CHECK(contact_at(&w, 0, 1, size, lift / 2, 0, 1, 4 * GEO));
    }
    w.options.gap = R(0.1);
    CHECK_INT(world_touch(&w), 2);
    box_on_ground(&w, 0, 0.09, 10, 4.91);
    w.options.gap = R(0.1);
    CHECK_INT(world_touch(&w), 2);
    w.options.gap = R(0.08);
    CHECK_INT(world_touch(&w), 0);
    /* penetration within the gap is a contact, deeper an overlap */
    for (k = 0; k < 2; k++) {
        const double sink = gap * (k ? 1.001 : 0.999);
        CHECK_INT(box_on_ground(&w, 0, -sink, 1, 1), k ? KERN_OVERLAP : 2);
        if (!k)
            CHECK(contact_at(&w, 0, 1, 1, -sink / 2, 0, 1, 4 * GEO));
    }
}

/* A seat longer than the gap is a line; on a shorter one the corners stand on
   the edges as points, which lie on one line and so are a face again. */
static void contact_narrow_seat(void)
{
    static world w;
    int k;
    for (k = 0; k < 2; k++) {
        const double on = 1e-3 * (k ? 1.01 : 0.99);
        world_reset(&w);
        world_box(&w, 0, -5, -1, 0, 0);
        world_box(&w, 1, -on, 0, 1 - on, 1);
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, -on, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    }
}

static const double moon[] = {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1};

/* Two blocks that overlap. A box is its lower left and upper right corner. */
static const struct {
    const char *what;
    int fixed, n, other_n; /* the first one is fixed; numbers of a polygon, 2 is
                              a box */
    double block[16], other[16];
} overlaps[] = {
    {"a corner in the other", 0, 2, 2, {0, 0, 1, 1}, {0.9, 0.9, 2, 2}},
    {"crossing bars: no vertex inside",
     0,
     2,
     2,
     {-2, -0.5, 2, 0.5},
     {-0.5, -2, 0.5, 2}},
    {"one in the other", 0, 2, 2, {-2, -2, 2, 2}, {-0.5, -0.5, 0.5, 0.5}},
    {"the same place twice", 0, 2, 2, {0, 0, 1, 1}, {0, 0, 1, 1}},
    {"sides in common, half over half",
     0,
     2,
     2,
     {0, 0, 1, 1},
     {0.5, 0, 1.5, 1}},
    {"through the reflex part",
     0,
     8,
     2,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {1, 1.25, 4, 1.75}},
    {"from side to side of a jaw, where no vertex is inside",
     0,
     8,
     2,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {0.5, -1, 0.75, 1.5}},
    {"a shape that is not convex, twice, a little turned",
     0,
     8,
     8,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {2e-4, 0, 3, 2e-4, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1}},
    {"a wedge pushed into a mouth, beyond its corners",
     0,
     8,
     3,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {-1, 0.7, -1, 2.3, 1.9, 1.5}},
    {"with a fixed one", 1, 2, 2, {0, 0, 1, 1}, {0.2, 0.5, 0.8, 3}},
    {"a blade thinner than the gap, in the side of a box: only its own outline"
     " is deep",
     0,
     2,
     7,
     {-4, 0, -1, 1},
     {0, 0, 1, 0, 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5}},
    {"the other way round",
     0,
     7,
     2,
     {0, 0, 1, 0, 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5},
     {-4, 0, -1, 1}},
};

static void world_shape(world *w, double density, const double *xy, int n)
{
    if (n == 2)
        world_box(w, density, xy[0], xy[1], xy[2], xy[3]);
    else
        world_polygon(w, density, xy, n);
}

/* Blocks 1 and 2 of three overlap; block 0 is a bystander. */
static void check_overlap(const world *w)
{
    static kern_contact out[MAX_POINTS];
    int index[6];
    kern_work work = kern_work_of(NULL, 0, index, 6);
    memset(&work.fault, 0, sizeof work.fault);
    CHECK_INT(kern_contacts(w->block, 3, &w->options, out, MAX_POINTS, &work),
              KERN_OVERLAP);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(work.fault.other, 2);
    CHECK(work.fault.value > R(5e-4));
    CHECK_INT(kern_touch(w->block, 2, &w->options, out, MAX_POINTS, &work),
              KERN_OVERLAP);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(work.fault.other, 2);
    CHECK_INT(kern_touch(w->block, 0, &w->options, out, MAX_POINTS, &work), 0);
}

static void contact_overlap(void)
{
    double ring[200];
    static world w;
    int k;
    for (k = 0; k < COUNT_OF(overlaps); k++) {
        sprintf(context, "(%s)", overlaps[k].what);
        world_reset(&w);
        world_box(&w, 0, 90, 0, 91, 1);
        world_shape(&w, overlaps[k].fixed ? 0 : 1, overlaps[k].block,
                    overlaps[k].n);
        world_shape(&w, 1, overlaps[k].other, overlaps[k].other_n);
        check_overlap(&w);
    }
    context[0] = 0;
    for (k = 0; k < 100; k++) { /* round, twice */
        ring[2 * k] = cos(2 * pi * k / 100);
        ring[2 * k + 1] = sin(2 * pi * k / 100);
    }
    world_reset(&w);
    world_box(&w, 0, 90, 0, 91, 1);
    world_polygon(&w, 1, ring, 100);
    world_polygon(&w, 1, ring, 100);
    check_overlap(&w);
}

static void contact_in_a_mouth(void)
{
    static world w;
    /* a block in the mouth of another is no overlap */
    world_reset(&w);
    world_polygon(&w, 0, moon, 8);
    world_box(&w, 1, 0.5, 1, 1.5, 1.9);
    CHECK_INT(world_touch(&w), 2);
    CHECK(contact_at(&w, 0, 1, 0.5, 1, 0, 1, GEO));
    /* nor beside its jaws, however small the gap: time does not depend on it */
    world_reset(&w);
    world_polygon(&w, 0, moon, 8);
    world_box(&w, 1, -0.5, 1.0001, 1.9999, 1.9999);
    w.options.gap = R(SINGLE ? 3e-5 : 1e-13);
    CHECK_INT(world_touch(&w), 0);
    w.vertex[9].y = w.vertex[9].y - R(0.0002); /* a foot in the jaw */
    CHECK_INT(kern_block_init(&w.block[1], w.vertex + 8, 4, R(1), NULL),
              KERN_OK);
    CHECK_INT(world_touch(&w), KERN_OVERLAP);
}

/* A bowl whose thin floor lies in the ground, which is accepted: the reflex vertex
   inside stands on nothing. */
static void contact_of_a_bowl(void)
{
    static const double bowl[] = {-1, -0.1, 1, -0.1, 1, 1, 0, 0, -1, 1};
    static world w;
    world_reset(&w);
    world_box(&w, 0, -2, -1, 2, 0);
    world_polygon(&w, 1, bowl, 5);
    w.options.gap = R(0.01);
    w.options.overlap = R(0.2);
    CHECK_INT(world_touch(&w), 2);
}

/* Contacts given by the user: blocks, normal, two points, friction, the angle
   tolerance (0: the default) and what kern_contact_make() returns. */
static const struct {
    int a, b;
    double v[7], angle;
    int want;
} makes[] = {
    {0, 1, {0, 1, 0, 0, 1, 0, 0.3}, 0, 2},
    {0, 1, {0, 1, 0, 0, 1, 0, 0}, 0, 2}, /* without friction */
    /* the tangent within the angle, and not */
    {0, 1, {0, 1, 0, 0, 1, 0.017, 0.3}, 0, 2},
    {0, 1, {0, 1, 0, 0, 1, 0.018, 0.3}, 0, KERN_BAD_LINE},
    {0, 1, {0, 1, 0, 0, 1, 0.018, 0.3}, 0.02, 2},
    {0, 1, {0, 1, 0, 0, 0, 1, 0.3}, 0, KERN_BAD_LINE},
    {0, 1, {0, 0, 0, 0, 1, 0, 0.3}, 0, KERN_BAD_NORMAL},
    {0, 1, {0, 1, 0, 0, 1, 0, -0.1}, 0, KERN_BAD_FRICTION},
    {2, 2, {0, 1, 0, 0, 1, 0, 0.3}, 0, KERN_SAME_BLOCK},
    {-1, 2, {0, 1, 0, 0, 1, 0, 0.3}, 0, KERN_BAD_BLOCK},
    /* a normal as small or as large as a number can be has a direction */
    {0, 1, {0, SINGLE ? 1e-30 : 1e-300, 0, 0, 1, 0, 0.3}, 0, 2},
    {0, 1, {0, SINGLE ? 1e30 : 1e300, 0, 0, 1, 0, 0.3}, 0, 2},
};

static int make_given(int a, int b, const double *v, double angle,
                      kern_contact *c)
{
    kern_options options = kern_defaults();
    if (angle > 0)
        options.angle = R(angle);
    return contact_make(a, b, vec(v[0], v[1]), vec(v[2], v[3]), vec(v[4], v[5]),
                        R(v[6]), &options, c);
}

static void contact_given(void)
{
    kern_contact c[2];
    int i, j;
    for (i = 0; i < COUNT_OF(makes); i++) {
        sprintf(context, "(contact %d)", i);
        memset(c, 0x55, sizeof c);
        CHECK_INT(
            make_given(makes[i].a, makes[i].b, makes[i].v, makes[i].angle, c),
            makes[i].want);
        if (makes[i].want != 2)
            continue;
        /* the normal is made unit; half the length along t */
        CHECK_NEAR(c[0].n.y, 1, EPS);
        CHECK_NEAR(fabs((double)c[0].travel), 0.5, GEO);
    }
    context[0] = 0;
    for (i = 0; i < 7; i++)
        for (j = 0; j < NO_NUMBERS; j++) {
            double v[7] = {0, 1, 0, 0, 1, 0, 0.3};
            v[i] = no_number(j);
            CHECK_INT(make_given(0, 1, v, 0, c), KERN_BAD_NUMBER);
        }
    CHECK_INT(make_given(0, 1, makes[0].v, 0, NULL), KERN_BAD_POINTER);
}

/* Vertices that were moved, or an array that was used again, without
   kern_block_init(): refused where the polygon is read. */
static void contact_stale(void)
{
    static world w;
    kern_contact out[8];
    int index[6], k;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    stack_of_two(&w, 0);
    CHECK_INT(w.contacts, 4);
    for (k = 0; k < 5; k++) {
        /* moved, smaller, larger, one corner, no number: by box and by area */
        kern_vec *v = w.vertex + 4;
        const kern_vec before = v[2];
        v[2] = k == 0 ? vec(0.5, 0.5)
             : k == 1 ? vec(1, 0.9)
             : k == 2 ? vec(1.1, 1)
             : k == 3 ? vec(1, 1.01)
                      : vec(not_a_number(), 1);
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 1, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        v[2] = before;
    }
    CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work), 2);
    /* in the same box, 0.7 and 1.4 thousandths of the area less */
    for (k = 0; k < 2; k++) {
        static const double notch[] = {5, 0, 6, 0, 6, 1, 5.5, 1, 5, 1};
        world_polygon(&w, 1, notch, 5);
        w.vertex[w.vertices - 2].y = R(k ? 1 - 2.8e-3 : 1 - 1.4e-3);
        CHECK_INT(kern_touch(w.block, 3, &w.options, out, 8, &work),
                  k ? KERN_STALE : 0);
        w.blocks--;
        w.vertices -= 5;
    }
    /* the mirror image has the same box, and the other sign of area */
    w.vertex[4] = vec(0, 1);
    w.vertex[5] = vec(1, 1);
    w.vertex[6] = vec(1, 0);
    w.vertex[7] = vec(0, 0);
    CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), KERN_STALE);
    /* one array for two stones that do not touch */
    for (k = 0; k < 4; k++)
        w.vertex[4 + k] = vec(k % 3 ? 3 : 2, k / 2);
    CHECK_INT(kern_block_init(&w.block[2], w.vertex + 4, 4, R(1), NULL),
              KERN_OK);
    CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work), KERN_STALE);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), KERN_STALE);
    CHECK_INT(work.fault.block, 1);
}

/* What kern_contacts() returned in place of a count is returned again, and the
   fault stays; work memory without arrays is a null pointer. */
static void count_that_is_a_status(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    kern_margin m;
    kern_real out;
    kern_collapse all;
    kern_real value[3];
    int i;
    world_reset(&w);
    world_box(&w, 0, -2, -1, 4, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0, 0.5, 1, 2);
    s = structure_of(&w);
    work = work_for(3, 64);
    s.contacts = kern_contacts(w.block, 3, &w.options, w.contact, MAX_POINTS,
                               &work);
    for (i = 0; i < 2; i++) {
        const int want = i ? KERN_BAD_POINTER : KERN_OVERLAP;
        kern_task *task = task_of(&s, &w.options, &work);
        CHECK_INT(kern_verdict(task, 0, NULL), want);
        CHECK_INT(kern_measure(task, &m, NULL), want);
        CHECK_INT(kern_deficit(task, &out), want);
        CHECK_INT(kern_load_factor(task, 0, KERN_LEFT, &out, NULL), want);
        CHECK_INT(kern_tilt(task, 0, KERN_LEFT, &out, NULL), want);
        CHECK_INT(kern_profile(task, KERN_LEFT, value, &all), want);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(work.fault.other, 2);
        work.real = NULL;
        s.contacts = 0;
    }
    s.contacts = -1; /* no call returns KERN_UNDECIDED for a count */
    work = work_for(3, 64);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_BAD_COUNT);
}

static void contact_given_point_and_line(void)
{
    const double point[7] = {0, 5, 2, 1, 2, 1, 0.3};
    kern_contact c[2];
    kern_vec p;
    int i, j;
    /* a point; the normal is made unit */
    CHECK_INT(make_given(3, 1, point, 0, c), 1);
    CHECK(c[0].a == 3 && c[0].b == 1 && !c[0].line);
    CHECK_NEAR(c[0].n.x, 0, 0);
    CHECK_NEAR(c[0].n.y, 1, EPS);
    CHECK_NEAR(c[0].p.x, 2, 0);
    CHECK_NEAR(c[0].mu, R(0.3), 0);
    CHECK_NEAR(c[0].travel, 0, 0);
    /* a line, in both directions */
    for (i = 0; i < 2; i++) {
        const double line[7] = {0, 1, i ? 3 : 1, 2, i ? 1 : 3, 2, 0.3};
        CHECK_INT(make_given(0, 1, line, 0, c), 2);
        for (j = 0; j < 2; j++) {
            CHECK(c[j].line && c[j].a == 0 && c[j].b == 1);
            CHECK_NEAR(fabs((double)c[j].travel), 1, GEO);
            p = kern_contact_at(&c[j], R(0.25), 0);
            CHECK_NEAR(fabs((double)p.x - 2), 0.75, GEO);
            CHECK_NEAR(p.y, 2, GEO);
        }
        CHECK_NEAR(c[0].p.x + c[1].p.x, 4, 0);
        CHECK_NEAR(fabs((double)(c[0].p.x - c[1].p.x)), 2, 0);
    }
}

static void contact_travels(void)
{
    static world w;
    int k;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_mass(&w, k ? 1 : 0, 0, 0, 1);
    /* three points of one interface: the centre is between the outer two, and
       travels are along each point's own tangent */
    world_point(&w, 0, 1, 0, 1, 0, 0);
    world_point(&w, 0, 1, 3, 4, 1, 0.5);
    world_point(&w, 1, 0, 0, -1, 4, 0); /* the same interface, reversed */
    /* a lone point, and two at one place */
    world_point(&w, 0, 2, 1, 0, 7, 7);
    world_point(&w, 2, 1, 1, 0, 5, 5);
    world_point(&w, 2, 1, 0, 1, 5, 5);
    /* a tie: the first pair by index, (0,0)-(3,4), has the centre (1.5, 2) */
    world_point(&w, 0, 3, 0, 1, 0, 0);
    world_point(&w, 0, 3, 0, 1, 3, 4);
    world_point(&w, 0, 3, 1, 0, 5, 0);
    /* a lone point beside a line of the same interface stays */
    world_point(&w, 1, 3, 0, 1, -1, 0);
    world_line(&w, 1, 3, 0, 1, 0, 0, 2, 0);
    world_touch(&w);
    CHECK_INT(w.contacts, 12);
    CHECK_NEAR(w.contact[0].travel, -2, GEO); /* t = (-1, 0), q = (2, 0) */
    /* n = (.6, .8), t = (-.8, .6), q - p = (1, -.5): -.8 - .3 */
    CHECK_NEAR(w.contact[1].travel, -1.1, GEO);
    CHECK_NEAR(w.contact[2].travel, -2, GEO); /* t = (1, 0) */
    CHECK_NEAR(w.contact[3].travel, 0, 0);
    CHECK_NEAR(w.contact[4].travel, 0, 0);
    CHECK_NEAR(w.contact[5].travel, 0, 0);
    CHECK_NEAR(w.contact[6].travel, -1.5, GEO); /* t = (-1, 0) */
    CHECK_NEAR(w.contact[7].travel, 1.5, GEO);
    CHECK_NEAR(w.contact[8].travel, 2, GEO); /* t = (0, 1) */
    CHECK_NEAR(w.contact[9].travel, 0, 0);
    for (k = 10; k < 12; k++) /* t = (-1, 0), q = (1, 0) */
        CHECK_NEAR(w.contact[k].travel, w.contact[k].p.x - 1, GEO);
    check_contacts(&w);
    {
        const kern_vec p = kern_contact_at(&w.contact[1], R(0.55), 0);
        CHECK_NEAR(p.x, 1 + 0.8 * 0.55, GEO);
        CHECK_NEAR(p.y, 0.5 - 0.6 * 0.55, GEO);
    }
    /* points found from polygons: a bench of two slanted feet on the floor */
    {
        static const double bench[] = {0, 0, 1, 1, 2, 1, 3, 0, 2.6, 2, 0.4, 2};
        world_reset(&w);
        world_box(&w, 0, -9, -1, 9, 0);
        world_polygon(&w, 1, bench, 6);
        /* two single points on one line are one face, hence one line contact */
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 3, 0, 0, 1, GEO));
        check_contacts(&w);
    }
}

/* A beam on the tips of two fixed wedges, 4 apart: each tip is alone with the
   beam. They go to the middle between them where that is asked for, and the
   beam falls when one reaches the centre of mass, 1.5 from the left. */
static void lone_points(void)
{
    static const double wedge[2][6] = {{-1, -1, 1, -1, 0, 0},
                                       {3, -1, 5, -1, 4, 0}};
    static world w;
    kern_margin m;
    int side, relative;
    for (relative = 0; relative < 2; relative++)
        for (side = -1; side <= 1; side++) {
            world_reset(&w);
            world_polygon(&w, 0, wedge[0], 3);
            world_polygon(&w, 0, wedge[1], 3);
            world_box(&w, 1, -0.5, 0, 4.5, 0.5);
            w.block[2].centre = vec(1.5, 0.25);
            w.options.relative = relative;
            w.options.lone = vec(0, side * 1e3);
            CHECK_INT(world_touch(&w), 2);
            CHECK_NEAR(w.contact[0].travel,
                       side < 0 ? w.contact[0].n.y * -2 : 0, GEO);
            CHECK_NEAR(w.contact[1].travel, side < 0 ? w.contact[1].n.y * 2 : 0,
                       GEO);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_INT(m.saturated, side >= 0);
            if (side < 0)
                CHECK_NEAR(m.margin, relative ? 0.75 : 1.5, EXACT);
        }
    /* a tip beside the end of a bed from 0 to 1: their middle is at 2 */
    world_reset(&w);
    world_polygon(&w, 0, wedge[1], 3);
    world_box(&w, 0, 0, -1, 1, 0);
    world_box(&w, 1, 0, 0, 4.5, 0.5);
    w.options.lone = w.gravity;
    CHECK_INT(world_touch(&w), 3);
    CHECK_NEAR(kern_contact_at(&w.contact[0], R(0.25), 0).x, 3.75, GEO);
    CHECK_NEAR(fabs((double)w.contact[0].travel), 2, GEO);
    w.options.lone.x = R(INFINITY);
    CHECK_INT(world_touch(&w), KERN_BAD_NUMBER);
}

static void contact_room(void)
{
    static world w;
    kern_contact two[3];
    int index[8];
    kern_work work = kern_work_of(NULL, 0, index, 8);
    int k;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_box(&w, k, 0, k, 1, k + 1);
    CHECK_INT(world_touch(&w), 6);
    for (k = 0; k < 6; k++)
        CHECK_INT(kern_contacts(w.block, 4, &w.options, w.contact, k, &work),
                  KERN_NO_SPACE);
    CHECK_INT(kern_contacts(w.block, 4, &w.options, w.contact, 6, &work), 6);
    memset(two, 0x55, sizeof two);
    work = kern_work_of(NULL, 0, NULL, 0); /* one block needs none */
    CHECK_INT(kern_touch(w.block, 3, &w.options, two, 1, &work), KERN_NO_SPACE);
    CHECK_INT(kern_touch(w.block, 3, &w.options, two, 2, &work), 2);
    CHECK_INT(two[0].a, 2);
    CHECK_INT(two[0].b, 3);
    CHECK_INT(two[2].a, 0x55555555);
    CHECK_INT(kern_touch(w.block, -1, &w.options, two, 2, &work),
              KERN_BAD_COUNT);
}

/* The search for contacts needs no work memory but its fault, and writes none. */
static void contact_work(void)
{
    static world w;
    kern_contact found[8];
    int index[10], k, size;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_box(&w, k, 0, k, 1, k + 1);
    for (size = -1; size <= 9; size++) {
        kern_work work = kern_work_of(NULL, 0, size < 0 ? NULL : index, size);
        for (k = 0; k < 10; k++)
            index[k] = 12345;
        CHECK_INT(kern_contacts(w.block, 4, &w.options, found, 8, &work), 6);
        for (k = 0; k < 10; k++)
            CHECK_INT(index[k], 12345);
        CHECK_INT(work.pivots, 0);
        CHECK_INT(work.fault.block, -1);
    }
    CHECK_INT(kern_contacts(w.block, 4, &w.options, found, 8, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_touch(w.block, 1, &w.options, found, 8, NULL),
              KERN_BAD_POINTER);
}

enum { CUBES = 20000 };
static int cubes_upright;

/* A row of cubes on one piece of ground, in any order: each has a bed and joins
   its neighbours. */
static void row_of_cubes(int cubes)
{
    static kern_block block[CUBES + 1];
    static kern_vec corner[CUBES + 1][4];
    static kern_contact contact[4 * CUBES];
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_options options = kern_defaults();
    int i, k, bad = 0;
    for (k = 0; k <= cubes; k++) {
        /* ground in the middle; 7919 is prime to the number of cubes */
        const int ground = k == cubes / 2;
        const double place = (double)(k * 7919l % (cubes + 1)) / 8;
        const double wide = ground ? cubes / 8 + 2 : 0.125;
        kern_vec *v = corner[k];
        v[0] = vec(ground ? -1 : place, ground ? -1 : 0);
        v[1] = vec((double)v[0].x + wide, (double)v[0].y);
        v[2] = vec((double)v[1].x, ground ? 0 : 0.125);
        v[3] = vec((double)v[0].x, (double)v[2].y);
        for (i = 0; i < 4 && cubes_upright; i++)
            v[i] = vec((double)v[i].y, (double)v[i].x);
        bad += (ground ? kern_ground_init(&block[k], v, 4, NULL)
                       : kern_block_init(&block[k], v, 4, 1, NULL))
            != KERN_OK;
    }
    CHECK_INT(bad, 0);
    /* one place of the row is the ground's, and empty */
    CHECK_INT(
        kern_contacts(block, cubes + 1, &options, contact, 4 * cubes, &work),
        2 * cubes + 2 * (cubes - 2));
}

/* Each two blocks are looked at, which takes some nanoseconds: the most blocks
   that are allowed, about half a second. */
static void contact_many_blocks(void)
{
    for (cubes_upright = 0; cubes_upright < 2; cubes_upright++) {
        const clock_t start = clock();
        row_of_cubes(some(CUBES - 1));
        CHECK(clock() - start < 4 * CLOCKS_PER_SEC);
    }
}

/* Two tips of one width meet exactly, and carry however short they are. */
static void contact_short_faces(void)
{
    static const double width[] = {2e-3, 9e-4, 1e-4, 1e-5};
    static world w;
    int i;
    for (i = 0; i < (SINGLE ? 2 : 4); i++) {
        const double x = width[i] / 2;
        const double low[] = {-1, 0, 1, 0, x, 1, -x, 1};
        const double high[] = {-x, 1, x, 1, 1, 2, -1, 2};
        sprintf(context, "(width %g)", width[i]);
        world_reset(&w);
        world_box(&w, 0, -2, -1, 2, 0);
        world_polygon(&w, 1, low, 4);
        world_polygon(&w, 1, high, 4);
        CHECK_INT(world_touch(&w), 4);
        CHECK_INT(lines_of(&w), 2);
        check_contacts(&w);
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
    }
    context[0] = 0;
}

/* A disc of n vertices that stands on another, edge on edge. */
static void contact_of_discs(void)
{
    static const int sides[] = {40, 1000, 3400, 3600, 4000};
    static kern_vec v[2][4000];
    int i, k, b;
    for (k = 0; k < (SINGLE ? 2 : 5); k++) {
        const int n = sides[k];
        const double high = cos(pi / n);
        const kern_options o = kern_defaults();
        kern_work work = kern_work_of(NULL, 0, NULL, 0);
        kern_contact c[80];
        kern_block block[2];
        for (b = 0; b < 2; b++)
            for (i = 0; i < n; i++)
                v[b][i] = vec(sin(2 * pi * (i + 0.5) / n),
                              2 * b * high - cos(2 * pi * (i + 0.5) / n));
        CHECK_INT(kern_ground_init(&block[0], v[0], n, NULL), KERN_OK);
        CHECK_INT(kern_block_init(&block[1], v[1], n, R(1), NULL), KERN_OK);
        CHECK(kern_contacts(block, 2, &o, c, 80, &work) >= 2);
        CHECK(c[0].line);
        CHECK_NEAR(c[0].n.y, 1, GEO);
    }
}

/* Two saws of n teeth in each other. */
static void saws_make(kern_block block[2], int n)
{
    static kern_vec v[2][4000];
    int i, b, k;
    for (b = 0; b < 2; b++) {
        for (i = k = 0; i <= 2 * n; i++)
            v[b][k++] = vec(i, i % 2);
        v[b][k++] = vec(2 * n, b ? n : -n);
        v[b][k++] = vec(0, b ? n : -n);
        CHECK_INT(kern_block_init(&block[b], v[b], k, R(1), NULL), KERN_OK);
    }
}

/* Time grows with the square of n at most, where with the cube it would be 64
   times as long. */
static void saws_of(int n)
{
    static kern_contact out[8000];
    const kern_options o = kern_defaults();
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_block block[2];
    saws_make(block, n);
    CHECK_INT(kern_contacts(block, 2, &o, out, 8000, &work), 4 * n);
}

static void contact_of_saws(void) { CHECK(grows_less(saws_of, 100, 32)); }

/* A search of any kind: contacts, overlaps, stretches, the contacts of one. */
static int search_of_kind(int kind, const kern_block *block,
                          const kern_options *o, kern_work *work)
{
    static kern_contact out[800];
    static kern_overlap overlap[1];
    return kind == 0 ? kern_contacts(block, 2, o, out, 800, work)
         : kind == 1 ? kern_overlaps(block, 2, o, overlap, 1, work)
         : kind == 2 ? kern_stretches(block, 2, o, out, 800, work)
                     : kern_touch(block, 1, o, out, 800, work);
}

/* A search is ended by each limit below its work, and by no other. */
static void contact_limits(void)
{
    kern_options o = kern_defaults();
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_block block[2];
    int kind, n, units;
    for (kind = 0; kind < 4; kind++) {
        saws_make(block, 50);
        o.limit = 0;
        n = search_of_kind(kind, block, &o, &work);
        units = work.units;
        CHECK_INT(n, kind == 1 ? 0 : 200);
        CHECK(units > 100);
        for (o.limit = 1; o.limit < units; o.limit += 1 + o.limit / 8) {
            CHECK_INT(search_of_kind(kind, block, &o, &work), KERN_LIMIT);
            CHECK_INT(work.units, o.limit + 1);
        }
        o.limit = units - 1;
        CHECK_INT(search_of_kind(kind, block, &o, &work), KERN_LIMIT);
        o.limit = units;
        CHECK_INT(search_of_kind(kind, block, &o, &work), n);
        CHECK_INT(work.units, units);

        /* a larger search ends, too */
        saws_make(block, 200);
        CHECK_INT(search_of_kind(kind, block, &o, &work), KERN_LIMIT);
    }
}

/* Stones on their tips: every lone point looks at all contacts. */
static void contact_limits_lone(void)
{
    static world w;
    int n = -1, i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 99, 0);
    for (i = 0; i < 24; i++) {
        const double stone[] = {3 * i, 0, 3 * i + 1, 1, 3 * i - 1, 1};
        world_polygon(&w, 1, stone, 3);
    }
    w.options.lone = vec(0, -1);
    w.options.limit = 0;
    for (i = 0; i < 3; i++) {
        kern_work work = kern_work_of(NULL, 0, NULL, 0);
        n = kern_contacts(w.block, w.blocks, &w.options, w.contact, MAX_POINTS,
                          &work);
        CHECK_INT(n, i == 1 ? (int)KERN_LIMIT : 24);
        w.options.limit = work.units - (i == 0);
    }
}

static const test contact_tests[] = {
    TEST(contact_cube_on_cube),
    TEST(contact_two_feet),
    TEST(contact_concave),
    TEST(contact_points),
    TEST(contact_merged_faces),
    TEST(contact_angle),
    TEST(contact_rules),
    TEST(contact_floor),
    TEST(contact_gap),
    TEST(contact_narrow_seat),
    TEST(contact_overlap),
    TEST(contact_in_a_mouth),
    TEST(contact_of_a_bowl),
    TEST(contact_given),
    TEST(contact_stale),
    TEST(count_that_is_a_status),
    TEST(contact_given_point_and_line),
    TEST(contact_travels),
    TEST(lone_points),
    TEST(contact_room),
    TEST(contact_work),
    TEST(contact_many_blocks),
    TEST(contact_short_faces),
    TEST(contact_of_discs),
    TEST(contact_of_saws),
    TEST(contact_limits),
    TEST(contact_limits_lone),
};

#endif
