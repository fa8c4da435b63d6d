/* polygon.h - outlines: area, centre, faults, load. */

#ifndef UNIT_POLYGON_H
#define UNIT_POLYGON_H

#include "harness.h"
#include "worlds.h"

static kern_status polygon(kern_block *b, kern_fault *fault, double density,
                           const double *xy, int n)
{
    static kern_vec v[64];
    int i;
    for (i = 0; i < n; i++)
        v[i] = vec(xy[2 * i], xy[2 * i + 1]);
    memset(b, 0x55, sizeof *b);
    fault->block = fault->other = fault->index = -7;
    fault->value = 0;
    return fabs(density) <= 0 ? kern_ground_init(b, v, n, fault)
                              : kern_block_init(b, v, n, R(density), fault);
}

static void polygon_area_and_centre(void)
{
    static const double square[] = {2, 3, 4, 3, 4, 5, 2, 5};
    static const double clock[] = {2, 5, 4, 5, 4, 3, 2, 3};
    static const double triangle[] = {0, 0, 3, 0, 0, 3};
    static const double ell[] = {0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3};
    static const double midpoints[] = {0, 0, 1, 0, 2, 0, 2, 2, 0, 2, 0, 1};
    kern_block b;
    kern_fault fault;
    CHECK_INT(polygon(&b, &fault, 2.5, square, 4), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
    CHECK_NEAR(b.mass, 10, GEO);
    CHECK_NEAR(b.centre.x, 3, GEO);
    CHECK_NEAR(b.centre.y, 4, GEO);
    CHECK_NEAR(b.box.low.x, 2, 0);
    CHECK_NEAR(b.box.low.y, 3, 0);
    CHECK_NEAR(b.box.high.x, 4, 0);
    CHECK_NEAR(b.box.high.y, 5, 0);
    CHECK(!b.fixed && b.vertices == 4 && b.vertex);
    CHECK(!(b.load.fx < 0 || b.load.fx > 0 || b.load.fy < 0 || b.load.fy > 0
            || b.load.torque < 0 || b.load.torque > 0));
    CHECK_INT(polygon(&b, &fault, 2.5, clock, 4), KERN_OK);
    CHECK_NEAR(b.area, -4, GEO);
    CHECK_NEAR(b.mass, 10, GEO);
    CHECK_NEAR(b.centre.x, 3, GEO);
    CHECK_NEAR(b.centre.y, 4, GEO);
    CHECK_INT(polygon(&b, &fault, 0, triangle, 3), KERN_OK);
    CHECK_NEAR(b.area, 4.5, GEO);
    CHECK_NEAR(b.centre.x, 1, GEO);
    CHECK_NEAR(b.centre.y, 1, GEO);
    CHECK(b.fixed);
    CHECK_NEAR(b.mass, 0, 0);
    /* 2 x 1 below 1 x 2: area 4, x (2 * 1 + 2 * .5) / 4, y (2 * .5 + 2 * 2) / 4
     */
    CHECK_INT(polygon(&b, &fault, 1, ell, 6), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
    CHECK_NEAR(b.centre.x, 0.75, GEO);
    CHECK_NEAR(b.centre.y, 1.25, GEO);
    /* vertices on straight edges are welcome */
    CHECK_INT(polygon(&b, &fault, 1, midpoints, 6), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
}

/* A centroid far from the origin must not drown in its coordinates. */
static void polygon_far_away(void)
{
    const double far_x = SINGLE ? 1024 : 1048576, far_y = -2 * far_x;
    double xy[6];
    kern_block b;
    kern_fault fault;
    xy[0] = far_x;
    xy[1] = far_y;
    xy[2] = far_x + 3;
    xy[3] = far_y;
    xy[4] = far_x;
    xy[5] = far_y + 3;
    CHECK_INT(polygon(&b, &fault, 1, xy, 3), KERN_OK);
    CHECK_NEAR(b.area, 4.5, 64 * EPS);
    CHECK_NEAR(b.centre.x, far_x + 1, 4 * EPS * far_x);
    CHECK_NEAR(b.centre.y, far_y + 1, 4 * EPS * far_x);
}

/* Corners that a polygon may not have. */
static void polygon_shapes(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1};
    static const double flat[] = {0, 0, 1, 0, 2, 0};
    static const double point[] = {1, 1, 1, 1, 1, 1};
    static const double pinched[] = {0, 0, 2, 0, 1, 1, 2, 2, 0, 2, 1, 1};
    static const double on_edge[] = {0, 0, 4, 0, 4, 2, 2, 0, 0, 2};
    static const double spike[] = {0, 0, 2, 0, 2, 2, 2, 3, 2, 2, 0, 2};
    static const double star[] = {0,   1,   .59, -.81, -.95,
                                  .31, .95, .31, -.59, -.81};
    double needle[] = {0, 0, 2, 0, 1, 1, 1, 2, 1, 1, 0.5, 1, 0, 1};
    kern_block b;
    kern_fault fault;
    int i;
    CHECK_INT(polygon(&b, &fault, 1, square, 2), KERN_FEW_VERTICES);
    CHECK_INT(polygon(&b, &fault, 1, square, 0), KERN_FEW_VERTICES);
    i = polygon(&b, &fault, 1, square, -5);
    CHECK(i == KERN_FEW_VERTICES || i == KERN_BAD_COUNT);
    CHECK_INT(polygon(&b, &fault, 1, bow, 4), KERN_CROSSING);
    CHECK(fault.index >= 0 && fault.index < 4);
    CHECK_INT(polygon(&b, &fault, 1, star, 5), KERN_CROSSING);
    i = polygon(&b, &fault, 1, flat, 3);
    CHECK(i == KERN_NO_AREA || i == KERN_CROSSING);
    i = polygon(&b, &fault, 1, point, 3);
    CHECK(i == KERN_NO_AREA || i == KERN_FEW_VERTICES);
    CHECK_INT(polygon(&b, &fault, 1, pinched, 6), KERN_CROSSING);
    CHECK(fault.index >= 0 && fault.index < 6);
    CHECK_INT(polygon(&b, &fault, 1, on_edge, 5), KERN_CROSSING);
    CHECK_INT(polygon(&b, &fault, 1, spike, 6), KERN_CROSSING);
    for (i = 0; i < 2 && !SINGLE; i++) { /* a needle of 0.7e-6 rad is a spike */
        needle[4] = 1 + (i ? 1.4e-6 : 0.7e-6);
        CHECK_INT(polygon(&b, &fault, 1, needle, 7),
                  i ? KERN_OK : KERN_CROSSING);
        CHECK_INT(fault.index, i ? -1 : 3);
    }
}

/* Masses and coordinates that are no numbers, or none to reckon with. */
static void polygon_numbers(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    double xy[8];
    kern_block b;
    kern_fault fault;
    int i, j;
    CHECK_INT(polygon(&b, &fault, -1, square, 4), KERN_BAD_MASS);
    i = polygon(&b, &fault, not_a_number(), square, 4);
    CHECK(i == KERN_BAD_MASS || i == KERN_BAD_NUMBER);
    i = polygon(&b, &fault, huge_value(), square, 4);
    CHECK(i == KERN_BAD_MASS || i == KERN_BAD_NUMBER);
    for (i = 0; i < 8; i++)
        for (j = 0; j < 3; j++) {
            memcpy(xy, square, sizeof xy);
            xy[i] = no_number(j);
            CHECK_INT(polygon(&b, &fault, 1, xy, 4), KERN_BAD_NUMBER);
            CHECK_INT(fault.index, i / 2);
        }
    memcpy(xy, square, sizeof xy);
    xy[5] = SINGLE ? 2e10 : 2e100;
    CHECK_INT(polygon(&b, &fault, 1, xy, 4), KERN_BAD_NUMBER);
    CHECK_INT(fault.index, 2);
}

static void polygon_faults(void)
{
    kern_block b;
    kern_fault fault;
    kern_vec v[3];
    polygon_shapes();
    polygon_numbers();
    v[0] = vec(0, 0);
    v[1] = vec(1, 0);
    v[2] = vec(0, 1);
    CHECK_INT(kern_block_init(&b, v, 1000001, R(1), &fault), KERN_BAD_COUNT);
    CHECK_INT(kern_block_init(NULL, v, 3, R(1), &fault), KERN_BAD_POINTER);
    CHECK_INT(kern_block_init(&b, NULL, 3, R(1), &fault), KERN_BAD_POINTER);
    CHECK_INT(kern_block_init(&b, v, 3, R(1), NULL), KERN_OK);
    CHECK_INT(kern_block_init(&b, v, 2, R(1), NULL), KERN_FEW_VERTICES);
}

static void polygon_load(void)
{
    static const double square[] = {2, 3, 4, 3, 4, 5, 2, 5};
    kern_block b;
    kern_fault fault;
    polygon(&b, &fault, 1, square, 4);
    /* centre (3, 4): (2, -1) at (5, 5) turns by 2 * -1 - 1 * 2 = -4 */
    kern_block_load(&b, vec(2, -1), vec(5, 5), R(1.5));
    CHECK_NEAR(b.load.fx, 2, 0);
    CHECK_NEAR(b.load.fy, -1, 0);
    CHECK_NEAR(b.load.torque, -2.5, GEO);
    kern_block_load(&b, vec(1, 1), vec(3, 4), R(0));
    CHECK_NEAR(b.load.fx, 3, 0);
    CHECK_NEAR(b.load.fy, 0, 0);
    CHECK_NEAR(b.load.torque, -2.5, GEO);
}

static kern_vec many_vertices[100000];

/* A circle of n vertices on the ground; in float, rounding may bend it in and
   out. */
static void circle_on_ground(int n)
{
    static kern_contact contact[4000]; /* room for what is merged later */
    kern_vec *v = many_vertices;
    kern_block b[2];
    kern_vec ground[4] = {{-9, -2}, {9, -2}, {9, -1}, {-9, -1}};
    kern_fault fault;
    kern_options options = kern_defaults();
    int i, got, index[4];
    kern_work work = kern_work_of(NULL, 0, index, 4);
    for (i = 0; i < n; i++)
        v[i] = vec(cos(2 * pi * i / n), sin(2 * pi * i / n));
    got = kern_block_init(&b[1], v, n, R(1), &fault);
    CHECK(got == KERN_OK || (SINGLE && got == KERN_CROSSING));
    if (SINGLE)
        return;
    CHECK_NEAR(b[1].area, pi, 1e-6);
    CHECK_NEAR(b[1].centre.x, 0, 1e-9);
    CHECK_INT(kern_ground_init(&b[0], ground, 4, &fault), KERN_OK);
    got = kern_contacts(b, 2, &options, contact, 4000, &work);
    CHECK(got >= 1 && got <= 64);
    for (i = 0; i < got; i++) { /* all of them at the foot, upward */
        CHECK(fabs((double)contact[i].p.x) < 0.1);
        CHECK(fabs((double)contact[i].n.y) > 0.99);
    }
}

static void polygon_of_many_vertices(void)
{
    const int n = SINGLE ? 10000 : 100000;
    kern_vec *v = many_vertices;
    kern_block b;
    kern_fault fault;
    CHECK(grows_less(circle_on_ground, n / 4, 8));
    if (SINGLE)
        return;
    /* a far pair of vertices exchanged is found */
    v[777] = vec(cos(2 * pi * 50777 / n) * 0.5, sin(2 * pi * 50777 / n) * 0.5);
    v[778] = vec(2, 0);
    CHECK_INT(kern_block_init(&b, v, n, R(1), &fault), KERN_CROSSING);
}

/* The depth of the vertices of stars, whichever edge is guessed to be nearest:
   the distance to an edge may be rounded to less than that to the box of its
   part. */
static void polygon_depth_of_vertices(void)
{
    enum { CORNERS = 60 };
    uint64_t seed = 7;
    int trial, i, guess;
    for (trial = 0; trial < 200; trial++) {
        const double from = random_share(random_bits(&seed));
        kern_vec v[CORNERS];
        kern_block b;
        kern_outline parts;
        for (i = 0; i < CORNERS; i++) {
            const double r = i % 2 ? 0.6 : 1, a = 2 * pi * i / CORNERS + from;
            v[i] = vec(r * cos(a), r * sin(a));
        }
        CHECK_INT(kern_block_init(&b, v, CORNERS, R(1), NULL), KERN_OK);
        kern_outline_set(&parts, &b);
        for (i = 0; i < CORNERS; i++)
            for (guess = -1; guess < 2; guess++) {
                int nearest = (i + guess + CORNERS) % CORNERS;
                kern_vec p = v[i];
                p.y += R(1e-7 * (random_share(random_bits(&seed)) - 0.5));
                CHECK_NEAR(kern_polygon_depth(&parts, p, &nearest), 0, 1e-5);
            }
    }
}

static const test polygon_tests[] = {
    TEST(polygon_area_and_centre),  TEST(polygon_far_away),
    TEST(polygon_faults),           TEST(polygon_load),
    TEST(polygon_of_many_vertices), TEST(polygon_depth_of_vertices),
};

#endif
