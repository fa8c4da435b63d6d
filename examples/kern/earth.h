/* earth.h - by how much the earth behind a wall may grow.

   The pressure of all statements `earth` that are no live load grows together,
   with its water and surcharge, on top of the other loads: the whole thrust, and
   then its horizontal part alone, as overturning and resisting moments are
   compared in a design.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_EARTH_H
#define PROGRAM_EARTH_H

#include "../../kern.h"

#include "../parts/soil.h"
#include "crush.h"
#include "let_go.h"
#include "state.h"

#include <math.h>
#include <stdlib.h>

/* Adds a force on a piece of a back, as its side sees it, to the pattern: all of
   it, or its horizontal part. */
static inline void earth_add(const struct analysis *a, int side,
                             enum earth_part part, int block,
                             struct soil_force f, kern_wrench *pattern)
{
    kern_block here = a->task.s.block[block];
    if (part == EARTH_HORIZONTAL)
        f.force.y = 0;
    if (side == SOIL_LEFT) { /* seen in a mirror */
        f.force.x = -f.force.x;
        f.at.x = -f.at.x;
    }
    here.load = pattern[block];
    kern_block_load(&here, f.force, f.at, 0);
    pattern[block] = here.load;
}

/* Adds what earth and water press with on the outline of their side. */
static inline void earth_press(const struct analysis *a,
                               const struct text_soil *s, enum earth_part part,
                               const struct text_surface *back,
                               kern_wrench *pattern)
{
    const kern_real way = s->side == SOIL_LEFT ? -1 : 1;
    for (int k = 0; k < back->edges; k++) {
        const struct soil_edge *e = back->edge + k;
        struct soil_force force[4];
        kern_vec p = e->p, q = e->q;
        if (a->task.s.block[e->block].fixed)
            continue;
        p.x *= way;
        q.x *= way;
        soil_back(p, q, &s->earth, force);
        for (int i = 0; i < 4; i++)
            earth_add(a, s->side, part, e->block, force[i], pattern);
    }
}

/* The pattern of all earth that stays; NULL where there is none, or no
   memory. */
static inline kern_wrench *earth_pattern(const struct analysis *a,
                                         enum earth_part part)
{
    kern_wrench *pattern = array(a->task.s.blocks, sizeof *pattern);
    struct text_file text = a->text;
    int there = 0;
    for (int i = 0; pattern && i < a->text.soils; i++) {
        const struct text_soil *s = &a->text.soil[i];
        struct text_surface back = {NULL, 0};
        if (s->kind != TEXT_EARTH || s->live
            || text_outline(&text, s->side, &back))
            continue;
        earth_press(a, s, part, &back, pattern);
        free(back.edge);
        there = 1;
    }
    if (!there) {
        free(pattern);
        pattern = NULL;
    }
    return pattern;
}

/* Does the earth press up or down as well? */
static inline int earth_leans(const struct analysis *a)
{
    for (int i = 0; i < a->text.soils; i++) {
        const struct text_soil *s = &a->text.soil[i];
        const kern_vec f = s->sum.force;
        if (s->kind == TEXT_EARTH && !s->live
            && fabs((double)f.y) > 1e-9 * fabs((double)f.x))
            return 1;
    }
    return 0;
}

/* Finds to how many times its pressure the earth may grow: by limit analysis, with
   how it falls beyond that, and let go. All are 0 where there is no earth or it
   does not stand. */
static inline void find_growth(struct analysis *a, enum earth_part part)
{
    kern_wrench *pattern = a->shown == KERN_STANDS ? earth_pattern(a, part)
                                                   : NULL;
    struct growth *g = &a->earth[part];
    kern_motion *motion = array(a->task.s.blocks, sizeof *motion);
    kern_real value = 0;
    kern_status status;
    if (!pattern || !motion) {
        free(pattern);
        free(motion);
        return;
    }
    status = crush_factor(a, &a->task, pattern, motion, &value);
    g->limit = 1 + value_or_nan(status, value);
    if (isfinite(g->limit))
        g->motion = motion;
    else
        free(motion);
    g->let_go = (double)NAN;
    if (asks_raised_loads(a) && a->let_go == KERN_STANDS) {
        status = kern_raised_load(&a->task, shrinkage(a), KERN_SHRINK, pattern,
                                  &value, NULL);
        if (status == KERN_STANDS)
            g->let_go = fmin(1 + (double)value, g->limit);
    }
    free(pattern);
}

/* Finds it for the whole thrust, and for its horizontal part where it has
   another. */
static inline void find_earth(struct analysis *a)
{
    find_growth(a, EARTH_WHOLE);
    if (earth_leans(a))
        find_growth(a, EARTH_HORIZONTAL);
}

/* Is it known, or asked and not known, by how much this part may grow? */
static inline int has_growth(const struct analysis *a, enum earth_part part)
{
    return isnan(a->earth[part].limit) || a->earth[part].limit > 0;
}

/* The part whose factor governs: the lower one, as a rule of the horizontal part.
   Earth that lifts the wall has it of all of its thrust. */
static inline enum earth_part earth_governs(const struct analysis *a)
{
    return has_growth(a, EARTH_HORIZONTAL)
                && !(a->earth[EARTH_HORIZONTAL].limit
                     > a->earth[EARTH_WHOLE].limit)
             ? EARTH_HORIZONTAL
             : EARTH_WHOLE;
}

/* Part k in the order in which they are told: the one that governs first. */
static inline enum earth_part earth_order(const struct analysis *a, int k)
{
    const int least = (int)earth_governs(a);
    return (enum earth_part)(k == 0 ? least : EARTH_PARTS - 1 - least);
}

#endif /* PROGRAM_EARTH_H */
