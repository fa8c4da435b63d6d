/* soil.h - what soil, mortar and weak stone do to a structure of kern.h.

   Fill that weighs on stones, earth that presses on a wall, the patch of a load
   that spreads through fill, soil that pushes back up to its passive pressure,
   mortar that bonds, and stone that crushes: each in a few lines on the public
   functions of kern.h. All lengths, weights and forces are per unit of depth of
   the structure, in the units of the caller. Angles are in radians.

   Every model here is the textbook's: Coulomb (1776) and Rankine (1857) for
   earth pressure, Boussinesq (1885) within a cone for the spread of a load, the
   rectangular stress block for crushing. See tests/REALITY.md for what they are
   worth beside experiments.

   SPDX-License-Identifier: MIT */

#ifndef SOIL_H
#define SOIL_H

#include "../../kern.h"

#include <math.h>
#include <stddef.h>
#include <stdlib.h>

/* ---- The faces that soil meets ------------------------------------------- */

/* A force and where it acts. */
struct soil_force {
    kern_vec force, at;
};

/* A piece of an outline: of ABOVE from its left end p to its right end q, of the
   sides from its foot p to its head q. */
struct soil_edge {
    kern_vec p, q;
    int block, vertex; /* the edge of that block which begins at the vertex */
};

enum soil_side { SOIL_ABOVE, SOIL_LEFT, SOIL_RIGHT };

/* Along what the outlines are looked at, and how high they are there. */
static inline double soil_along(enum soil_side side, kern_vec p)
{
    return (double)(side == SOIL_ABOVE ? p.x : p.y);
}

static inline double soil_height(enum soil_side side, kern_vec p)
{
    return side == SOIL_ABOVE ? (double)p.y
         : side == SOIL_RIGHT ? (double)p.x
                              : -(double)p.x;
}

static inline kern_vec soil_place(enum soil_side side, double along,
                                  double high)
{
    kern_vec p;
    p.x = (kern_real)(side == SOIL_ABOVE   ? along
                      : side == SOIL_RIGHT ? high
                                           : -high);
    p.y = (kern_real)(side == SOIL_ABOVE ? high : along);
    return p;
}

static inline int soil_compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Finds the edge that is outermost between two places along. Returns 0 where
   there is none. */
static inline int soil_outermost(const kern_block *block, int blocks,
                                 enum soil_side side, double from, double to,
                                 struct soil_edge *out)
{
    double best = 0;
    int i, k, found = 0;
    for (i = 0; i < blocks; i++) {
        const kern_block *b = &block[i];
        if (b->vertices == 0 || soil_along(side, b->box.low) > from
            || soil_along(side, b->box.high) < to)
            continue;
        for (k = 0; k < b->vertices; k++) {
            const kern_vec p = b->vertex[k];
            const kern_vec q = b->vertex[k + 1 < b->vertices ? k + 1 : 0];
            const double s = soil_along(side, p), t = soil_along(side, q);
            const double h = soil_height(side, p);
            const double slope = (soil_height(side, q) - h) / (t - s);
            const double middle = h + slope * ((from + to) / 2 - s);
            if (!(fmin(s, t) <= from && fmax(s, t) >= to && fabs(t - s) > 0)
                || (found && middle <= best))
                continue;
            best = middle;
            found = 1;
            out->p = soil_place(side, from, h + slope * (from - s));
            out->q = soil_place(side, to, h + slope * (to - s));
            out->block = i;
            out->vertex = k;
        }
    }
    return found;
}

/* Finds the outline of all blocks as it is seen from a side, and writes its
   pieces to edge[]. Both arrays have room for all vertices of the blocks. Returns
   how many pieces there are. Time: vertices times blocks. */
static inline int soil_surface(const kern_block *block, int blocks,
                               enum soil_side side, double *corner,
                               struct soil_edge *edge)
{
    int corners = 0, edges = 0, i, k;
    double least;
    for (i = 0; i < blocks; i++)
        for (k = 0; k < block[i].vertices; k++)
            corner[corners++] = soil_along(side, block[i].vertex[k]);
    if (corners == 0)
        return 0;
    qsort(corner, (size_t)corners, sizeof *corner, soil_compare);
    least = 1e-9 * (corner[corners - 1] - corner[0]);

    /* between two corners it is one edge, which may go on from the last one */
    for (i = 0; i + 1 < corners; i++) {
        struct soil_edge e = {{0, 0}, {0, 0}, -1, -1};
        struct soil_edge *last = edges > 0 ? edge + edges - 1 : NULL;
        if (!(corner[i + 1] - corner[i] > least)
            || !soil_outermost(block, blocks, side, corner[i], corner[i + 1],
                               &e))
            continue;
        if (last && last->block == e.block && last->vertex == e.vertex)
            last->q = e.q;
        else
            edge[edges++] = e;
    }
    return edges;
}

/* ---- Fill and earth ------------------------------------------------------ */

/* Returns Rankine's coefficient of passive pressure, (1 + sin) / (1 - sin). */
static inline double soil_passive(double phi)
{
    return (1 + sin(phi)) / (1 - sin(phi));
}

/* Returns Coulomb's coefficient of active pressure on a back that leans over
   the earth by `lean` from the vertical (below 0: earth rests on it), with the
   friction angles phi of the soil and delta between soil and wall, for a level
   surface. The resultant is K w h^2 / 2 on a back of the height h. */
static inline double soil_active(double phi, double delta, double lean)
{
    const double a = -lean;
    const double root = sqrt(cos(a + delta))
                      + sqrt(sin(phi + delta) * sin(phi) / cos(a));
    const double share = cos(phi - a) / (cos(a) * root);
    return share * share;
}

/* Returns the force of a pressure that changes linearly along the edge from p
   to q, from `at_p` to `at_q` [force per length], in the direction of the vector
   `way` of length 1. Where one end is 0 the force acts at a third. */
static inline struct soil_force soil_press(kern_vec p, kern_vec q, double at_p,
                                           double at_q, kern_vec way)
{
    const double length = hypot((double)(q.x - p.x), (double)(q.y - p.y));
    const double force = (at_p + at_q) / 2 * length;
    struct soil_force out = {{0, 0}, {0, 0}};
    double share;
    if (!(force > 0))
        return out;

    share = (at_p + 2 * at_q) / (3 * (at_p + at_q)); /* of the way from p */
    out.at.x = p.x + (kern_real)share * (q.x - p.x);
    out.at.y = p.y + (kern_real)share * (q.y - p.y);
    out.force.x = way.x * (kern_real)force;
    out.force.y = way.y * (kern_real)force;
    return out;
}

/* Returns the weight of the fill that lies above an edge, up to the level
   `top`, at its centroid. `weight` is that of a unit of its area. An edge that
   leans back carries none. The edge goes from its left end p to its right end
   q. */
static inline struct soil_force soil_fill(kern_vec p, kern_vec q, double top,
                                          double weight)
{
    const kern_vec down = {0, -1};
    const double length = hypot((double)(q.x - p.x), (double)(q.y - p.y));
    const double level = q.x > p.x ? (double)(q.x - p.x) / length : 0;
    const double left = fmax(top - (double)p.y, 0);
    const double right = fmax(top - (double)q.y, 0);
    struct soil_force out = soil_press(p, q, weight * level * left,
                                       weight * level * right, down);
    if (left + right > 0)
        out.at.y = (kern_real)(top
                               - (left * left + left * right + right * right)
                                     / (3 * (left + right)));
    return out;
}

/* Returns the most that fill pushes back with on an edge, level, by passive
   pressure. */
static inline double soil_push_back(kern_vec p, kern_vec q, double top,
                                    double weight, double phi)
{
    const double depth = top - (double)(p.y + q.y) / 2;
    return soil_passive(phi) * weight * fmax(depth, 0)
         * fabs((double)(q.y - p.y));
}

/* Earth behind a back that leans as in soil_active(), up to the level `top`,
   with a pressure on its surface, and water up to a level. Weights are those of
   a unit of area; `water` is 0 where there is none. */
struct soil_earth {
    double top, weight, phi, delta, lean, surcharge, level, water;
};

/* Returns the pressure of the earth's own weight at a height: that of the
   grains, without the water between them. */
static inline double soil_grains(const struct soil_earth *e, double y)
{
    const double wet = e->water > 0 ? fmin(e->level, e->top) : -HUGE_VAL;
    return e->surcharge + e->weight * (e->top - fmax(y, wet))
         + (y < wet ? (e->weight - e->water) * (wet - y) : 0);
}

/* Returns the active pressure of earth on a piece of a back, from its foot p up
   to its head q; the earth is at the right. A piece ends at the level of the
   water, or does not cross it. */
static inline struct soil_force soil_earth(kern_vec p, kern_vec q,
                                           const struct soil_earth *e)
{
    const double rise = (double)(q.y - p.y);
    const double high = fmin((double)q.y, e->top);
    const double length = hypot((double)(q.x - p.x), rise);
    const double k = soil_active(e->phi, e->delta, e->lean) * rise / length;
    const double turn = e->delta - e->lean;
    const kern_vec way = {(kern_real)-cos(turn), (kern_real)-sin(turn)};
    const struct soil_force none = {{0, 0}, {0, 0}};
    if (!(high > (double)p.y))
        return none;

    /* the part of the back that the earth reaches */
    q.x = p.x + (q.x - p.x) * (kern_real)((high - (double)p.y) / rise);
    q.y = (kern_real)high;
    return soil_press(p, q, k * soil_grains(e, (double)p.y),
                      k * soil_grains(e, high), way);
}

/* Returns the pressure of water on a piece of a back, as soil_earth() does. */
static inline struct soil_force soil_water(kern_vec p, kern_vec q,
                                           const struct soil_earth *e)
{
    const double rise = (double)(q.y - p.y);
    const double high = fmin((double)q.y, e->level);
    const double length = hypot((double)(q.x - p.x), rise);
    const kern_vec way = {(kern_real)(-rise / length),
                          (kern_real)((double)(q.x - p.x) / length)};
    const struct soil_force none = {{0, 0}, {0, 0}};
    if (!(high > (double)p.y) || !(e->water > 0))
        return none;
    q.x = p.x + (q.x - p.x) * (kern_real)((high - (double)p.y) / rise);
    q.y = (kern_real)high;
    return soil_press(p, q, e->water * (e->level - (double)p.y),
                      e->water * (e->level - high), way);
}

/* Writes what earth and water press with on an edge of a back, from its foot p
   up to its head q: each below the level of the water, then above it. */
static inline void soil_back(kern_vec p, kern_vec q, const struct soil_earth *e,
                             struct soil_force out[4])
{
    kern_vec cut = q;
    if (e->water > 0 && (double)p.y < e->level && (double)q.y > e->level) {
        cut.y = (kern_real)e->level;
        cut.x = p.x + (q.x - p.x) * (cut.y - p.y) / (q.y - p.y);
    }
    out[0] = soil_earth(p, cut, e);
    out[1] = soil_water(p, cut, e);
    out[2] = soil_earth(cut, q, e);
    out[3] = soil_water(cut, q, e);
}

/* ---- A load that spreads ------------------------------------------------- */

/* Adds a share of a unit load, downwards at px, to the pattern of a block. */
static inline void soil_share(kern_wrench *pattern, const kern_block *block,
                              int b, double share, double px)
{
    pattern[b].fy -= (kern_real)share;
    pattern[b].torque -= (kern_real)(share * (px - (double)block[b].centre.x));
}

/* Finds where a ray enters a block: it goes down from (x, top) and aside by
   `tangent` times its depth. Returns the depth, 0 where the ray begins within the
   block, or HUGE_VAL where it meets it nowhere above the depth `most`. */
static inline double soil_enter(const kern_block *b, double x, double top,
                                double tangent, double most)
{
    const double low = top - (double)b->box.low.y;
    const double high = fmax(top - (double)b->box.high.y, 0);
    const double a = x + tangent * low, c = x + tangent * high;
    double least = HUGE_VAL;
    int k, crossed = 0;
    if (b->vertices == 0 || low < 0 || high >= most
        || fmax(a, c) < (double)b->box.low.x
        || fmin(a, c) > (double)b->box.high.x)
        return HUGE_VAL;
    for (k = 0; k < b->vertices; k++) {
        const kern_vec p = b->vertex[k];
        const kern_vec q = b->vertex[k + 1 < b->vertices ? k + 1 : 0];
        const double zp = top - (double)p.y, zq = top - (double)q.y;
        const double to_p = (double)p.x - x - tangent * zp;
        const double to_q = (double)q.x - x - tangent * zq;
        double z;
        if ((to_p < 0) == (to_q < 0))
            continue;
        z = zp + to_p / (to_p - to_q) * (zq - zp);
        crossed += z >= 0;
        if (z >= 0 && z < least)
            least = z;
    }
    least = crossed % 2 ? 0 : least;
    return least < most ? least : HUGE_VAL;
}

/* Adds to the pattern the share of a vertical unit load, uniform from left to
   right, that stands on each block. What is over none is lost. */
static inline void soil_stand(kern_wrench *pattern, const kern_block *block,
                              int blocks, double left, double right)
{
    const double wide = right - left;
    double from = left;
    while (from < right) {
        struct soil_edge e;
        double to = right;
        int i, k;
        for (i = 0; i < blocks; i++)
            for (k = 0; k < block[i].vertices; k++) {
                const double x = (double)block[i].vertex[k].x;
                if (x > from && x < to)
                    to = x;
            }
        if (soil_outermost(block, blocks, SOIL_ABOVE, from, to, &e))
            soil_share(pattern, block, e.block, (to - from) / wide,
                       (from + to) / 2);
        from = to;
    }
}

enum { SOIL_STRIPS = 32, SOIL_RAYS = 48 };

/* Returns the direction of ray k of a strip, from the vertical, within `cone`;
   0 where that is 0. Each strip has directions of its own, and those of its
   mirror image are mirrored; no ray is in the middle, where joints are. */
static inline double soil_direction(int strip, int k, double cone)
{
    const int turn = (25 * strip + 12) % SOIL_STRIPS;
    const double place = k + (turn + .5) / SOIL_STRIPS;
    return cone * (2 * place / SOIL_RAYS - 1);
}

/* Adds to the pattern the share of a vertical unit load that reaches each block:
   a patch on the level `top`, `patch` wide about x, spreads within `cone` from
   the vertical. Stress under a line load is radial, and each direction has a share
   of the load in the square of its cosine (Boussinesq 1885, Flamant 1892); the
   shares within the cone are scaled up to the whole load. The first stone in a
   direction bears its share, as a vertical force where the ray meets it; what lies
   in its shadow bears nothing. The share of a direction without a stone is lost.
   Where cone is 0 the patch stands on the highest stones below it, whole parts of
   it on each. */
static inline void soil_spread(kern_wrench *pattern, const kern_block *block,
                               int blocks, double x, double patch, double top,
                               double cone)
{
    double wide = patch, sum = 0;
    int s, i, k;
    for (i = 0; i < blocks; i++)
        wide = fmax(wide, 1e-9 * sqrt(fabs((double)block[i].area)));
    if (!(cone > 0)) {
        soil_stand(pattern, block, blocks, x - wide / 2, x + wide / 2);
        return;
    }
    for (s = 0; s < SOIL_STRIPS; s++)
        for (k = 0; k < SOIL_RAYS; k++)
            sum += pow(cos(soil_direction(s, k, cone)), 2);

    /* follow each ray to the first block */
    for (s = 0; s < SOIL_STRIPS; s++)
        for (k = 0; k < SOIL_RAYS; k++) {
            const double from = x + wide * ((s + .5) / SOIL_STRIPS - .5);
            const double angle = soil_direction(s, k, cone);
            const double tangent = tan(angle);
            double least = HUGE_VAL;
            int met = -1;
            for (i = 0; i < blocks; i++) {
                const double z = soil_enter(block + i, from, top, tangent,
                                            least);
                if (z < least) {
                    least = z;
                    met = i;
                }
            }
            if (met >= 0)
                soil_share(pattern, block, met, pow(cos(angle), 2) / sum,
                           from + tangent * least);
        }
}

/* ---- Soil that pushes back, mortar, crushing ----------------------------- */

/* Makes a push on a stone that is there as far as it is needed, from 0 to `most`
   in the direction `way` of length 1: passive pressure, a strut. It is a slider
   of the size `size`, drawn as a strut of this area, pressed onto the fixed block `floor` by a constant load of
   `most` across the way, at a friction of 1. It touches the stone at one point
   without friction. Its own weight is a ten-thousandth of `most` and held by the
   load. Writes the block, whose index is `slider`, its vertices and two contact
   points. Returns 0, or a status below 0. */
static inline int soil_prop(kern_block *block, int slider, kern_vec outline[4],
                            kern_contact contact[2],
                            const kern_options *options, int floor, int on,
                            kern_vec at, kern_vec way, double most,
                            kern_vec gravity, double size)
{
    const double g = hypot((double)gravity.x, (double)gravity.y);
    const double mass = 1e-4 * most / (g > 0 ? g : 1);
    const kern_vec across = {-way.y, way.x};
    const double length = 4 * size, width = size / 4;
    const kern_vec middle = {at.x - (kern_real)(length / 2) * way.x,
                             at.y - (kern_real)(length / 2) * way.y};
    kern_contact c = {0};
    kern_vec press;
    kern_status status;
    int k, n;
    for (k = 0; k < 4; k++) {
        const double along = (k == 1 || k == 2 ? length : -length) / 2;
        const double aside = (k > 1 ? width : -width) / 2;
        outline[k].x = middle.x + (kern_real)along * way.x
                     + (kern_real)aside * across.x;
        outline[k].y = middle.y + (kern_real)along * way.y
                     + (kern_real)aside * across.y;
    }
    status = kern_block_init(&block[slider], outline, 4,
                             (kern_real)(mass / (size * size)), NULL);
    if (status != KERN_OK)
        return status;
    block[slider].centre = middle;
    press.x = -(kern_real)most * across.x - block[slider].mass * gravity.x;
    press.y = -(kern_real)most * across.y - block[slider].mass * gravity.y;
    kern_block_load(&block[slider], press, middle, 0);

    /* the floor carries the slider at its centre, the slider the stone */
    c.a = floor;
    c.b = slider;
    c.n = across;
    c.mu = 1;
    c.p = middle;
    contact[0] = c;
    c.a = slider;
    c.b = on;
    c.n = way;
    c.mu = 0;
    c.p = at;
    contact[1] = c;
    n = kern_contact_make(contact, middle, options);
    if (n > 0)
        n = kern_contact_make(contact + 1, at, options);
    return n < 0 ? n : 0;
}

/* Adds the bond of mortar, of the tensile strength `bond` [force per area], to
   the blocks of every line contact: a constant compression that the blocks put
   on each other, so that a contact opens only against it. */
static inline void soil_bond(kern_block *block, const kern_contact *contact,
                             int contacts, double bond)
{
    int i;
    for (i = 0; i + 1 < contacts; i++) {
        const kern_contact *c = contact + i;
        const double length = hypot((double)(c[1].p.x - c->p.x),
                                    (double)(c[1].p.y - c->p.y));
        const kern_real f = (kern_real)(bond * length / 2);
        int end;
        if (!c->line || !c[1].line || c->a != c[1].a || c->b != c[1].b)
            continue;

        for (end = 0; end < 2; end++) {
            const kern_vec on_a = {f * c->n.x, f * c->n.y};
            const kern_vec on_b = {-on_a.x, -on_a.y};
            if (!block[c->a].fixed)
                kern_block_load(&block[c->a], on_a, c[end].p, 0);
            if (!block[c->b].fixed)
                kern_block_load(&block[c->b], on_b, c[end].p, 0);
        }
        i++;
    }
}

/* Moves the ends of each line contact in by the half length of the stress block
   that carries its force at the strength, `share` of the way from where they
   are: whole[] is the structure's contacts as they were found, force[] forces of
   the contacts as they are now. Ask again until the answer settles. Returns the
   largest change of an end. */
static inline double soil_crush(kern_contact *contact,
                                const kern_contact *whole, int contacts,
                                const kern_force *force, double strength,
                                double share)
{
    double most = 0;
    int i;
    for (i = 0; i + 1 < contacts; i++) {
        const kern_contact *w = whole + i;
        const double dx = (double)(w[1].p.x - w->p.x);
        const double dy = (double)(w[1].p.y - w->p.y);
        const double length = hypot(dx, dy);
        double was, want, cut;
        if (!w->line || !w[1].line || w->a != w[1].a || w->b != w[1].b)
            continue;

        was = hypot((double)(contact[i].p.x - w->p.x),
                    (double)(contact[i].p.y - w->p.y));
        want = (double)(force[i].normal + force[i + 1].normal) / (2 * strength);
        cut = fmin(was + share * (want - was), .4999 * length);
        contact[i].p.x = w->p.x + (kern_real)(cut * dx / length);
        contact[i].p.y = w->p.y + (kern_real)(cut * dy / length);
        contact[i + 1].p.x = w[1].p.x - (kern_real)(cut * dx / length);
        contact[i + 1].p.y = w[1].p.y - (kern_real)(cut * dy / length);
        most = fmax(most, fabs(cut - was));
        i++;
    }
    return most;
}

#endif /* SOIL_H */
