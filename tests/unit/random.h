/* random.h - random structures from a seed, and their comparison with the
   twin. */

#ifndef UNIT_RANDOM_H
#define UNIT_RANDOM_H

#include "harness.h"
#include "worlds.h"
#include "tableau.h"
#include "verdict.h"

enum { TOWER, WALL, ARCH, PILE, POINTS, CONCAVE, CHAIN, KINDS };
static const char *const kind_name[KINDS] = {
    "tower", "wall", "arch", "pile", "points", "concave", "chain"};

/* Towers of boxes, each a little off the one below. */
static void random_tower(world *w, int blocks)
{
    double x = 0, y = 0;
    const double jitter = uniform(0.02, 0.5) / blocks + uniform(0, 0.1);
    int i;
    world_box(w, 0, -40, -1, 40, 0);
    for (i = 0; i < blocks; i++) {
        const double wide_as = uniform(0.6, 1.4), high = uniform(0.3, 1.2);
        x += uniform(-jitter, jitter);
        world_box(w, uniform(1, 3), x - wide_as / 2, y, x + wide_as / 2,
                  y + high);
        y += high;
    }
}

/* Courses of bricks with head joints that touch or not, and openings. */
static void random_wall(world *w, int blocks)
{
    const int row = random_int(1, 6);
    const double open = chance(0.5) ? 0 : 0.02, missing = chance(0.3) ? 0.1 : 0;
    double y = 0;
    int i = 0;
    world_box(w, 0, -40, -1, 40, 0);
    while (i < blocks) {
        double x = uniform(-0.3, 0.3);
        const double high = uniform(0.3, 0.7);
        int k;
        for (k = 0; k < row && i < blocks; k++) {
            const double wide_as = uniform(0.5, 1.5);
            if (y <= 0 || !chance(missing)) {
                world_box(w, 2, x, y, x + wide_as, y + high);
                i++;
            }
            x += wide_as + open;
        }
        y += high;
    }
}

/* A quadrilateral between two rays from the origin. */
static void world_voussoir(world *w, double density, double from, double to,
                           double inner, double outer)
{
    double xy[8];
    xy[0] = inner * cos(from);
    xy[1] = inner * sin(from);
    xy[2] = outer * cos(from);
    xy[3] = outer * sin(from);
    xy[4] = outer * cos(to);
    xy[5] = outer * sin(to);
    xy[6] = inner * cos(to);
    xy[7] = inner * sin(to);
    world_polygon(w, density, xy, 4);
}

/* Circular arches of equal voussoirs between two fixed ones. */
static void random_arch(world *w, int blocks)
{
    const double half = uniform(0.6, 0.5 * pi), t = uniform(0.04, 0.3) * half;
    const double step = 2 * half / blocks;
    int i;
    for (i = -1; i <= blocks; i++)
        world_voussoir(w, i < 0 || i == blocks ? 0 : 1,
                       pi / 2 - half + i * step, pi / 2 - half + (i + 1) * step,
                       1 - t / 2, 1 + t / 2);
}

/* Irregular stones: each lies on one to three earlier ones or on the ground,
   on short faces given one by one. Block 0 is the ground. */
static void random_pile(world *w, int blocks)
{
    int i, k;
    world_mass(w, 0, 0, 0, 1);
    for (i = 1; i <= blocks; i++) {
        const int supports = random_int(1, 3);
        const int on = i == 1 || chance(0.3)
                         ? 0
                         : random_int(i > 6 ? i - 6 : 1, i - 1);
        const double x = on ? (double)w->block[on].centre.x + uniform(-0.4, 0.4)
                            : uniform(-4, 4);
        const double y = on ? (double)w->block[on].centre.y + 1 : 0.5;
        world_mass(w, uniform(0.5, 2), x, y, uniform(0.8, 1.2));
        for (k = 0; k < supports; k++) {
            const int from = k == 0 ? on : random_int(0, i - 1);
            const double at = supports == 1
                                ? uniform(-0.2, 0.2)
                                : -0.5 + (k + uniform(0.2, 0.8)) / supports;
            const double lean = uniform(-0.6, 0.6) * (k == 0 ? 0.3 : 1);
            const double nx = sin(lean), ny = cos(lean),
                         half = uniform(0.05, 0.3);
            world_line(w, from, i, nx, ny, x + at - half * ny,
                       y - 0.5 + half * nx, x + at + half * ny,
                       y - 0.5 - half * nx);
        }
    }
}

/* Stones on points: two to four an interface, with normals of their own, so
   that shrinking is not monotone. */
static void random_points(world *w, int blocks)
{
    int i, k;
    world_mass(w, 0, 0, 0, 1);
    for (i = 1; i <= blocks; i++) {
        const int points = random_int(2, 4), swap = chance(0.5);
        const double x = uniform(-0.15, 0.15), y = i;
        world_mass(w, uniform(0.5, 2), x, y, 1);
        for (k = 0; k < points; k++) {
            const double lean = uniform(-0.9, 0.9);
            const double px = -0.6 + 1.2 * (k + uniform(0, 1)) / points;
            const double py = y - 0.5 + uniform(-0.2, 0.2);
            w->mu = uniform(0.1, 0.9);
            if (swap)
                world_point(w, i, i - 1, -sin(lean), -cos(lean), px, py);
            else
                world_point(w, i - 1, i, sin(lean), cos(lean), px, py);
        }
        if (chance(0.2)) /* a face beside the points of the interface */
            world_line(w, i - 1, i, 0, 1, -0.1, y - 0.5, 0.2, y - 0.5);
    }
}

/* L, T, U and Z shapes and boxes, one on the other and some side by side. */
static void random_concave(world *w, int blocks)
{
    double x = 0, y = 0;
    const double jitter = uniform(0.02, 0.3);
    int i;
    world_box(w, 0, -40, -1, 40, 0);
    for (i = 0; i < blocks; i++) {
        const double a = uniform(0.2, 0.4), h = uniform(0.8, 1.2);
        static const double shape[5][16] = {
            /* x in halves of the width, y in shares of the height; 2 marks a,
               -2 marks -a */
            {-1, 0, 1, 0, 1, 1, -1, 1},
            {-1, 0, 1, 0, 1, .4, -2, .4, -2, 1, -1, 1},
            {-2, 0, 2, 0, 2, .5, 1, .5, 1, 1, -1, 1, -1, .5, -2, .5},
            {-1, 0, -2, 0, -2, .6, 2, .6, 2, 0, 1, 0, 1, 1, -1, 1},
            {-1, 0, 2, 0, 2, .5, 1, .5, 1, 1, -2, 1, -2, .5, -1, .5}};
        static const int corners[5] = {4, 6, 8, 8, 8};
        const int kind = random_int(0, 4);
        const double side = chance(0.5) ? 1 : -1;
        double xy[16];
        int k;
        x += uniform(-jitter, jitter);
        for (k = 0; k < corners[kind]; k++) {
            double u = shape[kind][2 * k];
            u = u > 1.5 ? a : u < -1.5 ? -a : u;
            xy[2 * k] = x + side * u;
            xy[2 * k + 1] = y + h * shape[kind][2 * k + 1];
        }
        world_polygon(w, uniform(1, 2), xy, corners[kind]);
        y += h;
    }
}

/* Leaning rods, hung and propped at single points and held at lines. */
static void random_chain(world *w, int blocks)
{
    int i;
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 0, 5, 5, 1);
    for (i = 2; i < blocks + 2; i++) {
        const double x = uniform(0, 4), y = uniform(0, 4), r = uniform(0.3, 1);
        const int points = random_int(2, 4);
        int k;
        world_mass(w, uniform(0.5, 2), x, y, 1);
        for (k = 0; k < points; k++) {
            const int other = random_int(0, i - 1);
            const double lean = uniform(-pi, pi) * (k < 2 ? 0.4 : 0.6);
            const double at = uniform(-r, r);
            w->mu = uniform(0, 1);
            if (chance(0.5))
                world_point(w, other, i, sin(lean), cos(lean), x + at,
                            y - r * 0.3);
            else
                world_line(w, other, i, sin(lean), cos(lean), x + at,
                           y - r * 0.3, x + at + 0.2 * cos(lean),
                           y - r * 0.3 - 0.2 * sin(lean));
        }
    }
}

/* Loads on some of the blocks. */
static void random_loads(world *w)
{
    int i;
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed && chance(0.4)) {
            kern_block *b = &w->block[i];
            const double weight = 9.81 * (double)b->mass;
            kern_block_load(
                b,
                vec(uniform(-0.3, 0.3) * weight, uniform(-0.5, 0.2) * weight),
                vec((double)b->centre.x + uniform(-0.3, 0.3),
                    (double)b->centre.y + uniform(-0.3, 0.3)),
                R(uniform(-0.05, 0.05) * weight));
        }
}

/* The random structure number `seed`, of any kind or of the one wanted.
   Returns its kind. */
static int random_of_kind(world *w, unsigned long long seed, int most,
                          int wanted)
{
    static void (*const make[KINDS])(world *, int) = {
        random_tower,  random_wall,    random_arch, random_pile,
        random_points, random_concave, random_chain};
    static const int fewer[KINDS] = {0, 0, 0, 0, 6, 0, 12};
    static const double step[4] = {0.02, 0.05, 0.1, 0.3};
    double epsilon;
    int kind, blocks;
    random_seed(seed);
    kind = random_int(0, KINDS - 1);
    kind = wanted < KINDS ? wanted : kind;
    /* small ones are the most frequent */
    blocks = 1 + (int)(pow(uniform(0, 1), 3) * most);
    blocks = blocks > most ? most : blocks;
    sprintf(context, "(random %llu: %s of %d)", seed, kind_name[kind], blocks);
    if (fewer[kind] > 0 && blocks > fewer[kind])
        blocks = fewer[kind];
    world_reset(w);
    w->mu = chance(0.7) ? uniform(0.3, 1) : uniform(0.05, 0.3);
    w->options.mu = R(w->mu);
    make[kind](w, blocks);
    CHECK(world_touch(w) >= 0);
    if (chance(0.3)) {
        const double lean = uniform(-0.25, 0.25);
        w->gravity = vec(9.81 * sin(lean), -9.81 * cos(lean));
    }
    if (chance(0.3))
        random_loads(w);
    w->options.relative = chance(0.3);
    epsilon = step[random_int(w->blocks > 12 ? 2 : 0, 3)] * uniform(0.9, 1.1);
    w->options.epsilon = R(w->options.relative ? epsilon
                                               : epsilon * mean_size(w));
    return kind;
}

static int random_world(world *w, unsigned long long seed, int most)
{
    return random_of_kind(w, seed, most, KINDS);
}

/* The literal scan: stands at every step below the level, falls at it. */
static void scan_with_twin(const world *w, const kern_margin *m)
{
    const double most = (double)m->most, epsilon = (double)m->epsilon;
    int k;
    for (k = 1; k <= m->level; k++) {
        const double d = k * epsilon < most ? k * epsilon : most;
        const int stands = k < m->level || m->saturated;
        if (!twin_agrees(w, d, stands)) {
            check_near(twin_level(w, epsilon, most), m->level, 0, HERE,
                       "level by linear scan");
            break;
        }
        if (d >= most)
            break;
    }
    passed++;
}

/* Where contacts are nested the verdict changes once: the margin, bisected. */
static void bisect_with_twin(const world *w, const kern_margin *m)
{
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double most = (double)m->most, margin = (double)m->margin;
    const double width = fmax(1e3 * EPS * unit, 1e-11 * unit);
    double d;
    if (m->saturated) {
        CHECK(twin_agrees(w, most, 1));
        return;
    }
    d = twin_bisect(w, (double)m->holds * 0.999,
                    fmin(most, (double)m->fails + 1e-3 * unit), width);
    /* or it is only a question of how large forces may grow */
    if (fabs(margin - d) > EXACT * unit
        && !twin_agrees(w, (margin + d) / 2, margin > d))
        CHECK_NEAR(margin, d, EXACT * unit);
    passed++;
}

/* Where they are not: no loss as wide as a thousandth of the way before the
   margin. */
static void losses_with_twin(const world *w, const kern_margin *m)
{
    const int steps = 2400;
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double most = (double)m->most;
    const double end = m->saturated ? most : (double)m->margin;
    /* in float a proof itself leaves 1e-4 of what acts on a block */
    const double off = (SINGLE ? 1e-4 : 1e-6) * unit;
    int k, lost = 0;
    for (k = 0; k <= steps; k++) {
        const double d = most * k / steps;
        if (d >= end - 1e-6 * unit)
            break;
        lost = twin_agrees(w, d, 1) ? 0 : lost + 1;
        if (lost > 2) {
            CHECK(!"a loss before the margin was missed");
            break;
        }
    }
    passed++;
    if (!m->saturated) {
        CHECK(twin_agrees(w, fmax(0, end - off), 1));
        CHECK(twin_agrees(w, fmin(most, end + 2 * off), 0));
    }
}

/* Verdict, level and margin against the twin. `deep` also bisects the margin.
 */
static void compare_with_twin(const world *w, int deep)
{
    kern_margin m;
    const int got = measure(w, &m);
    CHECK(decided(got));
    if (got < 0 || m.level < 0)
        return;
    CHECK(twin_agrees(w, 0, got == KERN_STANDS));
    if (got == KERN_FALLS)
        return;
    CHECK_NEAR(m.epsilon, w->options.epsilon, 0);
    scan_with_twin(w, &m);
    check_bracket(w, &m);
    if (!deep)
        return;
    if (twin_nested(w))
        bisect_with_twin(w, &m);
    else
        losses_with_twin(w, &m);
}

#endif
