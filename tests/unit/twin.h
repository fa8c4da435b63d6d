/* twin.h - the independent solver: verifies proofs again, and shares nothing
   with kern.h but its types. */

#ifndef UNIT_TWIN_H
#define UNIT_TWIN_H

#include "harness.h"
#include "worlds.h"

/* Checked again as kern_check_forces() and kern_check_motion() define them,
   with contact points moved as >>rules of the header says. */

/* Do two points belong to one interface, in either order of its blocks? */
static int same_interface(const kern_contact *p, const kern_contact *q)
{
    return (p->a == q->a && p->b == q->b) || (p->a == q->b && p->b == q->a);
}

/* The middle of the line that ends in contact k: ends come in pairs. */
static void middle_of_line(const world *w, int k, wide *x, wide *y)
{
    int i, other, before = 0;
    for (i = k - 1; i >= 0 && w->contact[i].line; i--)
        before++;
    other = before % 2 ? k - 1 : k + 1;
    *x = ((wide)w->contact[k].p.x + w->contact[other].p.x) / 2;
    *y = ((wide)w->contact[k].p.y + w->contact[other].p.y) / 2;
}

/* Whether contact p carries the same block as contact k, as options.lone says
   where down is. One whose normal is horizontal within 1e-6 carries none. */
static int carry_the_same(const world *w, const kern_contact *p,
                          const kern_contact *k)
{
    const kern_vec down = w->options.lone;
    const double of_p = (double)(p->n.x * down.x + p->n.y * down.y);
    const double of_k = (double)(k->n.x * down.x + k->n.y * down.y);
    const double least = 1e-6
                       * fmax(fabs((double)down.x), fabs((double)down.y));
    return fabs(of_p) > least && fabs(of_k) > least
        && (of_p < 0 ? p->b : p->a) == (of_k < 0 ? k->b : k->a);
}

/* The middle of what carries the block of contact k. */
static void middle_of_carriers(const world *w, int k, wide *x, wide *y)
{
    const kern_contact *c = &w->contact[k];
    wide most = -1;
    int i, j;
    for (i = 0; i < w->contacts; i++)
        for (j = i; j < w->contacts; j++) {
            const kern_contact *p = &w->contact[i], *q = &w->contact[j];
            const wide dx = (wide)p->p.x - q->p.x, dy = (wide)p->p.y - q->p.y;
            if (!carry_the_same(w, p, c) || !carry_the_same(w, q, c)
                || dx * dx + dy * dy <= most)
                continue;
            most = dx * dx + dy * dy;
            *x = ((wide)p->p.x + q->p.x) / 2;
            *y = ((wide)p->p.y + q->p.y) / 2;
        }
}

/* The middle between the two points of the interface of contact k that are
   furthest apart. */
static void middle_of_points(const world *w, int k, wide *x, wide *y)
{
    const kern_contact *c = &w->contact[k];
    wide most = -1;
    int i, j;
    int points = 0;
    *x = c->p.x;
    *y = c->p.y;
    for (i = 0; i < w->contacts; i++) {
        const kern_contact *p = &w->contact[i];
        if (p->line || !same_interface(p, c))
            continue;
        points++;
        for (j = i + 1; j < w->contacts; j++) {
            const kern_contact *q = &w->contact[j];
            const wide dx = (wide)p->p.x - q->p.x, dy = (wide)p->p.y - q->p.y;
            if (q->line || !same_interface(q, c) || dx * dx + dy * dy <= most)
                continue;
            most = dx * dx + dy * dy;
            *x = ((wide)p->p.x + q->p.x) / 2;
            *y = ((wide)p->p.y + q->p.y) / 2;
        }
    }
    if (points == 1 && carry_the_same(w, c, c))
        middle_of_carriers(w, k, x, y);
}

/* The way that the point of each contact may go. Written from the definition:
   ends of a line meet in the middle, points of one interface at the feet of its
   centre, with options.lone the one point of an interface at the foot of the
   middle of what carries its block. */
static void own_travels(const world *w, wide *travel)
{
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        wide x, y;
        if (c->line)
            middle_of_line(w, k, &x, &y);
        else
            middle_of_points(w, k, &x, &y);
        travel[k] = (x - c->p.x) * -(wide)c->n.y + (y - c->p.y) * (wide)c->n.x;
        if (fabs((double)travel[k]) < 1e-9 * mean_size(w))
            travel[k] = 0;
    }
}

static wide own_slide(wide travel, wide d, int relative)
{
    const wide way = travel < 0 ? -travel : travel;
    const wide sign = travel < 0 ? -1 : travel > 0 ? 1 : 0;
    if (relative)
        return d * travel;
    return sign * (d < way ? d : way);
}

/* Weight and loads of a block, in newtons. */
static wide own_weight(const world *w, int i)
{
    const kern_block *b = &w->block[i];
    const double size = sqrt(fabs((double)b->area));
    double sum = (double)b->mass
                   * hypot((double)w->gravity.x, (double)w->gravity.y)
               + hypot((double)b->load.fx, (double)b->load.fy);
    if (b->load.torque < 0 || b->load.torque > 0)
        sum += fabs((double)b->load.torque) / (size > 0 ? size : 1);
    return sum;
}

static wide own_total(const world *w)
{
    wide sum = 0;
    int i;
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed)
            sum += own_weight(w, i);
    return sum;
}

/* Largest violation of the friction cones, in roundings; *total is the sum of
   the normal forces. Infinite where a force lies clearly outside. */
static wide share_of_cones(const world *w, const kern_force *force, wide *total)
{
    wide worst = 0;
    int k;
    *total = 0;
    for (k = 0; k < w->contacts; k++) {
        const wide f = force[k].normal, r = force[k].tangential;
        const wide limit = (wide)w->contact[k].mu * f;
        const wide over = (r < 0 ? -r : r) - limit,
                   round_off = 8 * (wide)EPS * limit;
        if (!(f >= 0) || !(over <= 1000 * round_off))
            return (wide)huge_value();
        if (over > 0 && over > worst * round_off)
            worst = over / round_off;
        *total += f;
    }
    return worst;
}

/* How far block i is from equilibrium, as a share of the allowed. */
static wide share_of_block(const world *w, double d, const wide *travel,
                           const kern_force *force, int i)
{
    const kern_block *b = &w->block[i];
    const double area = fabs((double)b->area);
    const wide size = area > 0         ? sqrt(area)
                    : mean_size(w) > 0 ? mean_size(w)
                                       : 1;
    wide fx = (wide)b->mass * w->gravity.x + b->load.fx;
    wide fy = (wide)b->mass * w->gravity.y + b->load.fy;
    wide torque = b->load.torque, largest = 0, noise = 0, allowed, error;
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const wide s = own_slide(travel[k], (wide)d, w->options.relative);
        const wide px = c->p.x - s * c->n.y - b->centre.x;
        const wide py = c->p.y + s * c->n.x - b->centre.y;
        const wide f = force[k].normal, r = force[k].tangential;
        const int side = c->b == i ? 1 : -1;
        const wide gx = side * (f * c->n.x - r * c->n.y);
        const wide gy = side * (f * c->n.y + r * c->n.x);
        if (c->a != i && c->b != i)
            continue;
        fx += gx;
        fy += gy;
        torque += px * gy - py * gx;
        if (f > largest)
            largest = f;
        /* places are known to the rounding of their coordinates, no better */
        noise += 4 * EPS * (1 + (double)c->mu) * (double)f
               * (fabs((double)c->p.x) + fabs((double)c->p.y)
                  + fabs((double)b->centre.x) + fabs((double)b->centre.y))
               / (double)size;
    }
    allowed = (wide)PROOF_TOL * (own_weight(w, i) + 1e-12 * largest) + noise
            + (SINGLE ? 32 * (wide)EPS * largest : 0);
    error = (wide)fmax(fmax(fabs((double)fx), fabs((double)fy)),
                       fabs((double)(torque / size)));
    if (error <= 0)
        return 0;
    return allowed > 0 ? error / allowed : (wide)huge_value();
}

/* Largest violation of what forces must satisfy, as a share of the allowed. */
static double share_of_forces(const world *w, double d, const kern_force *force)
{
    static wide travel[MAX_POINTS];
    wide total, worst = share_of_cones(w, force, &total);
    int i;
    own_travels(w, travel);
    if (isinf((double)worst))
        return (double)worst;
    if (total > (wide)FORCE_BOUND * own_total(w))
        worst = total / ((wide)FORCE_BOUND * own_total(w) + (wide)DBL_MIN);
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed) {
            const wide share = share_of_block(w, d, travel, force, i);
            if (!(share <= worst))
                worst = share;
        }
    return (double)worst;
}

/* The motion proves that the structure falls where this is at most 1: what
   forces of the largest size could take out of the motion, over what gravity
   and loads put in. */
static double share_of_motion(const world *w, double d,
                              const kern_motion *motion)
{
    static wide travel[MAX_POINTS];
    wide power = 0, against = 0, weight = 0;
    int i, k, side;
    own_travels(w, travel);
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        const kern_motion *v = &motion[i];
        const int moves = v->vx < 0 || v->vx > 0 || v->vy < 0 || v->vy > 0
                       || v->spin < 0 || v->spin > 0;
        if (!(fabs((double)v->vx) + fabs((double)v->vy) + fabs((double)v->spin)
              <= DBL_MAX))
            return huge_value();
        if (b->fixed) {
            if (moves)
                return huge_value();
            continue;
        }
        if (moves)
            weight += own_weight(w, i);
        power += ((wide)b->mass * w->gravity.x + b->load.fx) * v->vx
               + ((wide)b->mass * w->gravity.y + b->load.fy) * v->vy
               + (wide)b->load.torque * v->spin;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const kern_block *a = &w->block[c->a], *b = &w->block[c->b];
        const kern_motion *va = &motion[c->a], *vb = &motion[c->b];
        const wide s = own_slide(travel[k], (wide)d, w->options.relative);
        const wide px = c->p.x - s * c->n.y, py = c->p.y + s * c->n.x;
        const wide rx = vb->vx - (wide)vb->spin * (py - b->centre.y)
                      - (va->vx - (wide)va->spin * (py - a->centre.y));
        const wide ry = vb->vy + (wide)vb->spin * (px - b->centre.x)
                      - (va->vy + (wide)va->spin * (px - a->centre.x));
        const wide open = rx * c->n.x + ry * c->n.y;
        const wide slide = ry * c->n.x - rx * c->n.y;
        /* places are known to the rounding of their coordinates, no better */
        const double reach = fabs((double)px) + fabs((double)py);
        const wide noise = 4 * EPS * (1 + (double)c->mu)
                         * (fabs((double)va->vx) + fabs((double)va->vy)
                            + fabs((double)vb->vx) + fabs((double)vb->vy)
                            + fabs((double)va->spin)
                                  * (reach + fabs((double)a->centre.x)
                                     + fabs((double)a->centre.y))
                            + fabs((double)vb->spin)
                                  * (reach + fabs((double)b->centre.x)
                                     + fabs((double)b->centre.y)));
        for (side = -1; side <= 1; side += 2)
            if (-(open + side * (wide)c->mu * slide) - noise > against)
                against = -(open + side * (wide)c->mu * slide) - noise;
    }
    if (!(power > 0))
        return huge_value();
    return (double)((wide)FORCE_BOUND * weight * against / power);
}

#endif
