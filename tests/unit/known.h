/* known.h - cases whose answer is known, each with its derivation or source. */

#ifndef UNIT_KNOWN_H
#define UNIT_KNOWN_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "contact.h"

/* What the cases share: the parameters that a family keeps fixed. */
static struct {
    double mu, a, b;
    int n;
} given;

/* ---- a block on a slope ---- */

/* By hand: b wide and 1 high, it slides at tan a = mu and topples at
   tan a = b, whichever is less; two free cubes topple together at 1/2. The
   degrees are those numbers. */

/* n free unit cubes (b wide, 1 high) on a plane tilted by x. */
static void on_a_slope(world *w, double x)
{
    const double c = cos(x), s = sin(x);
    const double at[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    double xy[8];
    int i, k;
    world_reset(w);
    w->options.mu = R(given.mu);
    for (i = 0; i <= given.n; i++) {
        for (k = 0; k < 4; k++) {
            const double u = at[2 * k] * given.b, v = at[2 * k + 1] + i;
            xy[2 * k] = u * c - v * s;
            xy[2 * k + 1] = u * s + v * c;
        }
        world_polygon(w, i ? 1 : 0, xy, 4);
    }
    CHECK_INT(world_touch(w), 2 * given.n);
}

static void known_slope(void)
{
    static const double mu[] = {0.1, 0.4, 0.84, 1.2};
    static const double degrees[] = {5.7106, 21.8014, 40.0303, 45};
    static world w;
    double angle;
    int k;
    for (k = 0; k < 4; k++) {
        given.mu = (double)R(mu[k]);
        given.b = 1;
        given.n = 1;
        angle = threshold(on_a_slope, 0.01, 1.2);
        CHECK_NEAR(angle, atan(fmin(given.mu, 1)), EDGE);
        CHECK_NEAR(angle * 180 / pi, degrees[k], SINGLE ? 0.1 : 6e-5);
        /* the same by turning gravity */
        on_a_slope(&w, 0);
        CHECK_INT(tilt(&w, 1, &angle), KERN_STANDS);
        CHECK_NEAR(angle, atan(fmin(given.mu, 1)), EDGE);
        /* narrow and wide blocks */
        given.b = 0.3;
        CHECK_NEAR(threshold(on_a_slope, 0.01, 1.2), atan(fmin(given.mu, 0.3)),
                   EDGE);
        given.b = 3;
        CHECK_NEAR(threshold(on_a_slope, 0.01, 1.2), atan(given.mu), EDGE);
    }
    given.mu = 0.84;
    given.b = 1;
    given.n = 2;
    angle = threshold(on_a_slope, 0.01, 1.2);
    CHECK_NEAR(angle, atan(0.5), EDGE);
    CHECK_NEAR(angle * 180 / pi, 26.565, SINGLE ? 0.1 : 6e-4);
}

/* ---- a column of n cubes ---- */

/* By hand: under f W sideways at every centre it slides at f = mu, and the
   whole topples about its lowest corner where f n / 2 = 1/2. */

static void column_of(world *w, int n)
{
    int i;
    world_reset(w);
    world_box(w, 0, -3, -1, 4, 0);
    for (i = 0; i < n; i++)
        world_box(w, 1, 0, i, 1, i + 1);
    CHECK_INT(world_touch(w), 2 * n);
}

static void known_column(void)
{
    static world w;
    double factor, angle;
    int n, side;
    for (n = 1; n <= 10; n++)
        for (side = -1; side <= 1; side += 2) {
            const double want = fmin((double)R(0.84), 1.0 / n);
            column_of(&w, n);
            world_friction(&w, 0.84);
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(factor, want, EDGE);
            CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
            CHECK_NEAR(tan(angle), want, 2 * EDGE);
        }
}

/* ---- a cube shifted on a cube ---- */

/* By hand: the weight passes the end of the bed at a shift of 1/2. */

static void known_offset(void)
{
    CHECK_NEAR(threshold(shifted_cube, 0.1, 0.8), 0.5, EDGE);
    CHECK_NEAR(threshold(shifted_cube, -0.1, -0.8), -0.5, EDGE);
    {
        /* centred, the ends carry the weight together and no torque: see also
           proof_forces_of_a_cube; closed, the one point carries it */
        static world w;
        shifted_cube(&w, 0);
        CHECK_INT(verdict(&w, 0.25), KERN_STANDS);
        CHECK_NEAR(force_of[0].normal + force_of[1].normal, 9.81,
                   9.81 * 2 * PROOF_TOL);
        CHECK_NEAR(force_of[0].normal, force_of[1].normal,
                   9.81 * 8 * PROOF_TOL);
    }
}

/* ---- a box shifted on a box ---- */

/* By hand: the weight of the upper box passes its bed s from the middle, so
   the bed may shrink to 2 s: d* = 1/2 - s at each end. The literal Algorithm 1
   does not end for s = 0: there it is saturated, 0.5 / 0.02 + 1 = 26 steps. */

static void known_boxes(void)
{
    static const double shift[] = {0.1, 0.25, 0.4};
    static world w;
    kern_margin m;
    int k, side;
    for (k = 0; k < 3; k++)
        for (side = -1; side <= 1; side += 2) {
            const double want = 0.5 - shift[k];
            stack_of_two(&w, side * shift[k]);
            w.options.epsilon = R(0.03);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, want, EXACT);
            CHECK_INT(m.level, (int)floor(want / 0.03) + 1);
            CHECK(!m.saturated);
            CHECK_NEAR(m.most, 0.5, GEO);
            check_bracket(&w, &m);
            CHECK_INT(verdict(&w, want - EDGE), KERN_STANDS);
            CHECK_INT(verdict(&w, want + EDGE), KERN_FALLS);
        }
    stack_of_two(&w, 0);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.margin, 0.5, GEO);
    CHECK_INT(m.level, SINGLE ? m.level : 26);
    w.options.epsilon = R(0.03);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_INT(m.level, 18);
    CHECK_INT(verdict(&w, 100), KERN_STANDS);
}

/* ---- a lintel on two piers ---- */

/* By hand: each bearing [0, 1] carries half of the weight anywhere in it, so it
   stands with every kern closed. */

static void known_lintel(void)
{
    static world w;
    kern_margin m;
    int free_piers;
    for (free_piers = 0; free_piers < 2; free_piers++) {
        world_reset(&w);
        world_box(&w, 0, -2, -1, 8, 0);
        world_box(&w, free_piers, 0, 0, 1, 2);
        world_box(&w, free_piers, 4, 0, 5, 2);
        world_box(&w, 1, 0, 2, 5, 2.5);
        CHECK_INT(world_touch(&w), free_piers ? 8 : 4);
        w.options.epsilon = R(0.07);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated);
        CHECK_NEAR(m.margin, 0.5, GEO);
        CHECK_INT(m.level, 9);
        CHECK_INT(verdict(&w, 0.5), KERN_STANDS);
        CHECK_INT(verdict(&w, 5), KERN_STANDS);
        w.options.relative = 1;
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated);
        CHECK_INT(m.level, 16);
    }
}

/* ---- the harmonic stack ---- */

/* By hand: without friction the i-th brick from the top may overhang the next
   by 1 / (2 i); the overhang of n is half the harmonic number. */

/* Brick i from the top overhangs the one below by x / (2 i); the table ends at
   x = 0. */
static void harmonic_stack(world *w, double x)
{
    double right = 0;
    int i;
    world_reset(w);
    w->options.mu = R(0);
    for (i = given.n; i >= 1; i--)
        right += x / (2 * i);
    world_box(w, 0, -9, -1, 0, 0);
    for (i = 1; i <= given.n; i++) {
        const double y = given.n - i;
        world_box(w, 1, right - 1, y, right, y + 1);
        right -= x / (2 * i);
    }
    CHECK_INT(world_touch(w), 2 * given.n);
}

static void known_harmonic_stack(void)
{
    static const int bricks[] = {1, 2, 3, 4, 5, 10};
    static const double overhang[] = {0.5,     0.75,    0.91667,
                                      1.04167, 1.14167, 1.46448};
    static world w;
    const double off = SINGLE ? 3e-3 : 1e-4;
    int k;
    for (k = 0; k < 6; k++) {
        given.n = bricks[k];
        harmonic_stack(&w, 1);
        CHECK_NEAR((double)w.block[1].centre.x + 0.5, overhang[k], 6e-6);
        harmonic_stack(&w, 1 - off);
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        harmonic_stack(&w, 1 + off);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
        CHECK_NEAR(threshold(harmonic_stack, 0.9, 1.1), 1, given.n * EDGE);
    }
}

/* ---- a ladder ---- */

/* By hand: a uniform rod against a wall, friction mu at both ends, slips below
   90 degrees - 2 atan(mu): the lines of both friction cones' edges meet above
   the middle. */

/* A rod of length 2 at the angle x to the floor, its upper end at the wall. */
static void ladder(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 1, cos(x), sin(x), 0.3);
    w->mu = given.mu;
    world_point(w, 0, 1, 0, 1, 0, 0);
    world_point(w, 0, 1, -1, 0, 2 * cos(x), 2 * sin(x));
    /* floor and wall are two interfaces: two blocks */
    world_mass(w, 0, 0, 0, 1);
    w->contact[1].a = 2;
    world_touch(w);
}

static double ladder_slips(double mu) { return pi / 2 - 2 * atan(mu); }

/* The angle at which rods slip, between one that stands and one that falls, for
   three coefficients of friction. */
static void rods_slip(void (*build)(world *, double), double stands,
                      double falls, double (*angle)(double),
                      const double degrees[3])
{
    static const double mu[] = {0.2, 0.4, 0.5};
    int k;
    for (k = 0; k < 3; k++) {
        double found;
        given.mu = (double)R(mu[k]);
        found = threshold(build, stands, falls);
        CHECK_NEAR(found, angle(given.mu), 4 * EDGE);
        CHECK_NEAR(found * 180 / pi, degrees[k], SINGLE ? 0.3 : 6e-4);
    }
}

static void known_ladder(void)
{
    static const double degrees[] = {67.380, 46.397, 36.870};
    rods_slip(ladder, 1.5, 0.1, ladder_slips, degrees);
}

/* ---- an A-frame ---- */

/* By hand: at the apex the forces are horizontal, at each foot N = W and
   R = W tan(a) / 2, so tan(a) = 2 mu. */

/* Two rods of length 2 that lean on each other, x from the vertical. */
static void a_frame(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 1, -sin(x), cos(x), 0.3);
    world_mass(w, 1, sin(x), cos(x), 0.3);
    w->mu = given.mu;
    world_point(w, 0, 1, 0, 1, -2 * sin(x), 0);
    world_point(w, 0, 2, 0, 1, 2 * sin(x), 0);
    world_point(w, 1, 2, 1, 0, 0, 2 * cos(x));
    world_touch(w);
}

static double a_frame_slips(double mu) { return atan(2 * mu); }

static void known_a_frame(void)
{
    static const double degrees[] = {21.801, 38.660, 45};
    rods_slip(a_frame, 0.05, 1.4, a_frame_slips, degrees);
}

/* ---- arches ---- */

/* Thin: the least t / R of a semicircle of N voussoirs whose joints do not slip;
   digits of two independent linear programs, and for N without end
   Milankovitch's .1075. Sliding: the arch of M. Gilbert, C. Casapulla and H. M.
   Ahmed, Limit analysis of masonry block structures with non-associative
   frictional joints using linear programming, Computers and Structures 84
   (2006); N = 27, R = 10. */

/* A semicircular arch of given.n voussoirs, centreline radius given.a,
   thickness x, between two fixed springings. */
static void semicircle(world *w, double x)
{
    const double r = given.a, step = pi / given.n;
    int i;
    world_reset(w);
    w->options.mu = R(given.mu);
    for (i = 0; i < given.n; i++)
        world_voussoir(w, 1, i * step, (i + 1) * step, r - x / 2, r + x / 2);
    world_box(w, 0, r - x, -r / 2, r + x, 0);
    world_box(w, 0, -r - x, -r / 2, -r + x, 0);
    CHECK_INT(world_touch(w), 2 * (given.n + 1));
}

static void known_thin_arch(void)
{
    static const int n[] = {4, 5, 6, 8, 10, 15, 20, 31, 51, 101};
    static const double ratio[] = {.09736, .09498, .10413, .09997, .10701,
                                   .10607, .10735, .10713, .10736, .10745};
    static world w;
    int k;
    given.mu = 1;
    given.a = 1;
    for (k = 0; k < 10; k++) {
        given.n = n[k];
        sprintf(context, "(arch of %d)", n[k]);
        /* what a hundred voussoirs sum up is more than float can tell closely
         */
        semicircle(&w, ratio[k] + (SINGLE ? 2e-3 : DIGITS5));
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        semicircle(&w, ratio[k] - (SINGLE ? 2e-3 : DIGITS5));
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    context[0] = 0;
    given.n = 10;
    CHECK_NEAR(threshold(semicircle, 0.2, 0.05), 0.10701,
               SINGLE ? 1e-3 : DIGITS5);
}

static void known_sliding_arch(void)
{
    static const double mu[] = {.31, .325, .35, .375, .39, .396, .5, 1};
    static const double least[] = {1.9600, 1.7821, 1.5119, 1.2597,
                                   1.1163, 1.0672, 1.0672, 1.0672};
    static const double thick[] = {1.1, 1.2, 1.5, 2.0};
    static const double margin[] = {.01638, .06633, .21617, .46581};
    static const double factor4[] = {0, .02028, .05235, .09909};
    static const double factor7[] = {0, .04843, .14534, .28434};
    static world w;
    kern_margin m;
    double factor;
    int k, side;
    given.a = 10;
    given.n = 27;
    for (k = 0; k < 8; k++) {
        const double off = SINGLE ? 3e-2 : 6e-5;
        given.mu = mu[k];
        sprintf(context, "(mu %g)", mu[k]);
        semicircle(&w, least[k] + off);
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        semicircle(&w, least[k] - off);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    given.mu = 0.308;
    for (k = 0; k < 5; k++) {
        static const double any[] = {1, 1.5, 2, 3, 5};
        semicircle(&w, any[k]);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    for (k = 0; k < 4; k++) {
        double friction;
        for (friction = 0.4; friction < 1.2; friction += 0.3) {
            given.mu = friction;
            sprintf(context, "(thickness %g, mu %g)", thick[k], friction);
            semicircle(&w, thick[k]);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, margin[k], SINGLE ? 2e-3 : 6e-6);
            CHECK_INT(m.level,
                      (int)floor((double)m.margin / (double)m.epsilon) + 1);
            if (k == 0 || friction > 0.8)
                continue;
            for (side = -1; side <= 1; side += 2) {
                CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
                CHECK_NEAR(factor, friction < 0.5 ? factor4[k] : factor7[k],
                           SINGLE ? 2e-3 : 6e-6);
            }
        }
    }
    context[0] = 0;
}

/* ---- two bodies, four contacts ---- */

/* K. M. Lynch and F. C. Park, Modern Robotics (2017), ch. 12, an exercise; the
   threshold of mu by hand: 10/31. */

/* Mass of the second body given.a, friction of the first contact x. */
static void two_bodies(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 2, 25, 35, 40);
    world_mass(w, given.a, 66, 42, 40);
    w->mu = x;
    world_point(w, 0, 1, 0, 1, 0, 0);
    w->mu = 0.5;
    world_point(w, 2, 1, -1, 0, 60, 60);
    world_point(w, 0, 2, 0, 1, 60, 0);
    world_point(w, 0, 2, 0, 1, 72, 0);
    world_touch(w);
}

static void known_two_bodies(void)
{
    static world w;
    given.a = 5;
    two_bodies(&w, 0.1);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    given.a = 10;
    two_bodies(&w, 0.5);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_NEAR(w.contact[2].travel, -6, GEO);
    CHECK_NEAR(w.contact[3].travel, 6, GEO);
    CHECK_NEAR(threshold(two_bodies, 0.5, 0.1), 10. / 31, 8 * EDGE);
}

/* ---- a jam ---- */

/* The known limit of statics by forces alone: walls may press as hard as they
   like, and nothing says that they do. */

static void known_jam(void)
{
    static world w;
    kern_margin m;
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 0, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 4);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    world_friction(&w, 0.01);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    /* the force needed is W / (2 mu) on each side, W / mu in all: the bound on
       forces is where it ends */
    world_friction(&w, 4 / FORCE_BOUND);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    world_friction(&w, 0.1 / FORCE_BOUND);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    world_friction(&w, 0);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    /* two free cubes in the air */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
}

/* ---- walls with openings ---- */

/* Walls 1, 3 and 4 of M. C. Ferris and F. Tin-Loi, Limit analysis of frictional
   block assemblies as a mathematical program with complementarity constraints,
   Int. J. Mech. Sci. 43 (2001); here with associative friction, digits of two
   independent linear programs. Blocks are .4 x .175. */

/* Courses from the bottom, ended by 0: block lengths in blocks, -1 an opening
   one block wide. */
#define H 0.5
static const double wall1[][10] = {{H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {0}};
static const double wall3[][10] = {
    {1, 1, 1, 1},     {H, 1, 1, 1, H},  {1, 1, 1, 1},     {H, 1, -1, 1, H},
    {1, H, -1, H, 1}, {H, 1, -1, 1, H}, {1, H, -1, H, 1}, {H, 1, -1, 1, H},
    {1, 1, 1, 1},     {H, 1, 1, 1, H},  {1, 1, 1, 1},     {0}};
static const double wall4[][10] = {
    {H, 1, 1, 1, 1, H},         {1, 1, 1, 1, 1},
    {H, 1, 1, 1, 1, H},         {1, -1, 1, -1, 1},
    {H, H, -1, H, H, -1, H, H}, {1, -1, 1, -1, 1},
    {H, H, -1, H, H, -1, H, H}, {1, -1, 1, -1, 1},
    {H, 1, 1, 1, 1, H},         {1, 1, 1, 1, 1},
    {H, 1, 1, 1, 1, H},         {0}};

static void brick_wall(world *w, const double (*course)[10], double mu,
                       int heads)
{
    int i, k, kept = 0;
    world_reset(w);
    w->options.mu = R(mu);
    world_box(w, 0, -1, -1, 3, 0);
    for (i = 0; course[i][0] > 0; i++) {
        double x = 0;
        for (k = 0; k < 10 && (course[i][k] > 0 || course[i][k] < 0); k++) {
            const double long_as = 0.4 * fabs(course[i][k]);
            if (course[i][k] > 0)
                world_box(w, 1, x, 0.175 * i, x + long_as, 0.175 * (i + 1));
            x += long_as;
        }
    }
    CHECK(world_touch(w) > 0);
    if (heads)
        return;
    for (k = 0; k < w->contacts; k++)
        if (fabs((double)w->contact[k].n.y) > 0.5)
            w->contact[kept++] = w->contact[k];
    w->contacts = kept;
}

static void known_walls(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const int blocks[3] = {33, 46, 55}, contacts[3] = {83, 102, 116};
    static const double mu[3] = {0.65, 0.4, 0.2};
    static const double factors[3][3] = {
        {.64286, .4, .2}, {.40369, .36189, .2}, {.33195, .27561, .2}};
    static const double headless[3] = {.63997, .35901, .28540};
    static const double margin[3] = {0, .09509, .08932};
    static world w;
    kern_margin m;
    double factor, tol = SINGLE ? 2e-3 : 6e-6;
    int i, k, side;
    for (i = 0; i < 3; i++) {
        sprintf(context, "(wall %d)", i > 0 ? i + 2 : 1);
        for (k = 0; k < 3; k++) {
            brick_wall(&w, wall[i], mu[k], 1);
            CHECK_INT(w.blocks - 1, blocks[i]);
            CHECK_INT(w.contacts, 2 * contacts[i]);
            CHECK_INT(lines_of(&w), contacts[i]);
            for (side = -1; side <= 1; side += 2) {
                CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
                CHECK_NEAR(factor, factors[i][k], tol);
            }
            if (k == 1) {
                CHECK_INT(measure(&w, &m), KERN_STANDS);
                CHECK_INT(m.saturated, i == 0);
                if (i > 0)
                    CHECK_NEAR(m.margin, margin[i], SINGLE ? 1e-3 : 6e-6);
                check_bracket(&w, &m);
            }
        }
        brick_wall(&w, wall[i], 0.65, 0);
        for (side = -1; side <= 1; side += 2) {
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(factor, headless[i], tol);
        }
    }
    context[0] = 0;
}

/* ---- a tower, and a trapezoid on a steep face ---- */

/* By hand: ten cubes stand on each other; one face alone, at 60 degrees, holds
   where mu is more than tan 60 degrees. */

/* A trapezoid on a face of 60 degrees, its weight over the face. */
static void on_steep_face(world *w, double x)
{
    const double s = sqrt(3);
    double ground[6] = {0, 0, 1, 0, 1, 0}, stone[8] = {0, 0, 1, 0, 1, 3, 0, 1};
    ground[5] = s;
    stone[3] = s;
    world_reset(w);
    w->options.mu = R(x);
    world_polygon(w, 0, ground, 3);
    world_polygon(w, 1, stone, 4);
    CHECK_INT(world_touch(w), 2);
}

static void known_tower_and_trapezoid(void)
{
    static world w;
    kern_margin m;
    column_of(&w, 10);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(threshold(on_steep_face, 3, 1), sqrt(3), 8 * EDGE);
}

static const test known_tests[] = {
    TEST(known_slope),      TEST(known_column),
    TEST(known_offset),     TEST(known_boxes),
    TEST(known_lintel),     TEST(known_harmonic_stack),
    TEST(known_ladder),     TEST(known_a_frame),
    TEST(known_thin_arch),  TEST(known_sliding_arch),
    TEST(known_two_bodies), TEST(known_jam),
    TEST(known_walls),      TEST(known_tower_and_trapezoid),
};

#endif
