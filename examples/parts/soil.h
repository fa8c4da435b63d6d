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

/* ---- earth and fill ------------------------------------------------------ */

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

/* Adds to a block the force of a pressure that changes along the edge from p
   to q linearly, from `at_p` to `at_q` [force per length], in the direction of
   the vector `way` of length 1. Where one end is 0 the force acts at a third. */
static inline void soil_press(kern_block *block, kern_vec p, kern_vec q,
                              double at_p, double at_q, kern_vec way)
{
    const double length = hypot((double)(q.x - p.x), (double)(q.y - p.y));
    const double force = (at_p + at_q) / 2 * length;
    kern_vec at;
    double share;
    if (!(force > 0))
        return;

    share = (at_p + 2 * at_q) / (3 * (at_p + at_q)); /* of the way from p */
    at.x = p.x + (kern_real)share * (q.x - p.x);
    at.y = p.y + (kern_real)share * (q.y - p.y);
    way.x *= (kern_real)force;
    way.y *= (kern_real)force;
    kern_block_load(block, way, at, 0);
}

/* Adds the weight of the fill that lies above an edge, up to the level `top`.
   `weight` is that of a unit of its area. An edge that leans back carries
   none. The edge goes from its left end p to its right end q. */
static inline void soil_fill(kern_block *block, kern_vec p, kern_vec q,
                             double top, double weight)
{
    const kern_vec down = {0, -1};
    const double length = hypot((double)(q.x - p.x), (double)(q.y - p.y));
    const double level = q.x > p.x ? (double)(q.x - p.x) / length : 0;
    const double left = weight * level * fmax(top - (double)p.y, 0);
    soil_press(block, p, q, left, weight * level * fmax(top - (double)q.y, 0),
               down);
}

/* Adds the active pressure of earth up to the level `top` on the back of a
   stone, from its foot p up to its head q; the earth is at the right. */
static inline void soil_earth(kern_block *block, kern_vec p, kern_vec q,
                              double top, double weight, double phi,
                              double delta)
{
    const double rise = (double)(q.y - p.y);
    const double lean = atan2((double)(q.x - p.x), rise);
    const double wet = fmin((double)q.y, top);
    const double length = hypot((double)(q.x - p.x), rise);
    const double k = soil_active(phi, delta, lean) * weight * rise / length;
    const double turn = delta - lean;
    const kern_vec way = {(kern_real)-cos(turn), (kern_real)-sin(turn)};
    if (!(wet > (double)p.y))
        return;

    /* the part of the back that the earth reaches */
    q.x = p.x + (q.x - p.x) * (kern_real)((wet - (double)p.y) / rise);
    q.y = (kern_real)wet;
    soil_press(block, p, q, k * (top - (double)p.y), k * (top - wet), way);
}

/* ---- a load that spreads ------------------------------------------------- */

/* Adds to the pattern of the blocks [first, first + n) the share of a vertical
   unit load that reaches each of them: a patch on the level `top`, `patch` wide
   about x, spreads within `cone` from the vertical by Boussinesq's law onto the
   edges from top[i] to top[i + 1], which the blocks carry. Without fill above,
   set cone to 0: the patch acts straight down. */
static inline void soil_spread(kern_wrench *pattern, const kern_block *block,
                               int first, int n, const kern_vec *edge, double x,
                               double patch, double top, double cone)
{
    enum { STRIPS = 31, PIECES = 8 };
    int s, i, k;
    for (s = 0; s < STRIPS; s++) {
        const double from = x + patch * ((s + .5) / STRIPS - .5);
        double sum = 0;
        int pass;

        /* add up the shares, then hand each piece its part of the strip */
        for (pass = 0; pass < 2; pass++)
            for (i = 0; i < n; i++) {
                const double dx = (double)(edge[i + 1].x - edge[i].x);
                const double dy = (double)(edge[i + 1].y - edge[i].y);
                for (k = 0; k < PIECES && dx > 0; k++) {
                    const double t = (k + .5) / PIECES;
                    const double px = (double)edge[i].x + t * dx;
                    const double z = fmax(top - (double)edge[i].y - t * dy,
                                          1e-3);
                    const double off = fabs(px - from);
                    const double reach = fmax(z * tan(cone), dx / PIECES / 2);
                    const double q = z * z + off * off;
                    const double share = off > reach ? 0
                                                     : z * z * z / (q * q) * dx;
                    if (pass == 0) {
                        sum += share;
                    } else if (share > 0) {
                        const int b = first + i;
                        const double f = share / sum / STRIPS;
                        pattern[b].fy -= (kern_real)f;
                        pattern[b].torque -=
                            (kern_real)(f * (px - (double)block[b].centre.x));
                    }
                }
            }
    }
}

/* ---- soil that pushes back, mortar, crushing ----------------------------- */

/* A push on a stone that is there as far as it is needed, from 0 to `most`:
   passive pressure, a strut. It is a slider: a weight on a fixed floor, which
   friction holds up to `most`, and which touches the stone at one point without
   friction. Writes the two blocks to block[*blocks] and on, three contact points
   to contact[*contacts] and on, and counts them. outline[8] keeps their
   vertices. The slider pushes block `on` at `at` to the right, or where `side`
   is -1 to the left. `gravity` is the acceleration downwards. Returns 0, or a
   status below 0. */
static inline int soil_prop(kern_block *block, int *blocks,
                            kern_contact *contact, int *contacts,
                            kern_vec outline[8], const kern_options *options,
                            int on, kern_vec at, int side, double most,
                            double gravity, double size)
{
    enum { FRICTION = 1 };
    const int floor = *blocks, slider = *blocks + 1;
    const double half = size / 2;
    const double apart = 2 * size * (slider + 1); /* from all others */
    kern_contact c = {0};
    kern_vec q;
    kern_status status;
    int k, n;
    for (k = 0; k < 8; k++) {
        outline[k].x = at.x
                     + (kern_real)(-side * apart + (k % 4 % 3 ? half : -half));
        outline[k].y = at.y
                     + (kern_real)(k < 4 ? (k > 1 ? -half : -3 * half)
                                         : (k > 5 ? half : -half));
    }
    status = kern_ground_init(&block[floor], outline, 4, NULL);
    if (status == KERN_OK)
        status = kern_block_init(
            &block[slider], outline + 4, 4,
            (kern_real)(most / FRICTION / gravity / (size * size)), NULL);
    if (status != KERN_OK)
        return status;

    /* the floor carries the slider below its centre */
    c.a = floor;
    c.b = slider;
    c.n.x = 0;
    c.n.y = 1;
    c.mu = FRICTION;
    c.p.x = block[slider].centre.x - (kern_real)(half / 2);
    c.p.y = at.y;
    q.x = block[slider].centre.x + (kern_real)(half / 2);
    q.y = at.y;
    contact[*contacts] = c;
    n = kern_contact_make(contact + *contacts, q, options);
    if (n < 0)
        return n;
    *contacts += n;

    /* the slider presses the stone on its line of action */
    c.a = slider;
    c.b = on;
    c.n.x = (kern_real)side;
    c.n.y = 0;
    c.mu = 0;
    c.p = at;
    contact[*contacts] = c;
    n = kern_contact_make(contact + *contacts, at, options);
    if (n < 0)
        return n;
    *contacts += n;
    *blocks += 2;
    return 0;
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
