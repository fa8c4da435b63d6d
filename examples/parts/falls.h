/* falls.h - every mechanism of a structure that falls, not the first alone.

   A proof of falling is one motion: some blocks move, the others rest. Of the
   others some may fall as well. So what moves is taken away, and what is left is
   asked again, until it stands or nothing is left; a mason then sees all that
   must be mended.

   SPDX-License-Identifier: MIT */

#ifndef FALLS_H
#define FALLS_H

#include <stddef.h>

#include "../../kern.h"

/* Slower than that share of the fastest counts as rest: as in
   kern_critical_of(). */
#define FALLS_REST 1e-4

/* Arrays of the caller, as long as those of the structure: what is left. */
struct falls_part {
    kern_block *block;
    kern_contact *contact;
    kern_motion *motion;
    int *place; /* of a block of the whole in it; -1: taken     */
};

static inline int falls_moves(kern_motion v, const kern_block *b)
{
    const kern_real rest = (kern_real)(FALLS_REST * FALLS_REST);
    const kern_real area = b->area < 0 ? -b->area : b->area;
    return !b->fixed
        && (v.vx * v.vx + v.vy * v.vy > rest || v.spin * v.spin * area > rest);
}

/* Those of place[] that are not negative, renumbered, with the contacts between
   them. */
static inline void falls_take(const kern_structure *s, struct falls_part *left,
                              kern_structure *part)
{
    part->blocks = part->contacts = 0;
    for (int i = 0; i < s->blocks; i++) {
        if (left->place[i] < 0)
            continue;
        left->place[i] = part->blocks;
        left->block[part->blocks++] = s->block[i];
    }
    for (int k = 0; k < s->contacts; k++) {
        kern_contact c = s->contact[k];
        c.a = left->place[c.a];
        c.b = left->place[c.b];
        if (c.a >= 0 && c.b >= 0)
            left->contact[part->contacts++] = c;
    }
    part->block = left->block;
    part->contact = left->contact;
}

/* Takes away what moves in `motion`; returns how many blocks that are. */
static inline int falls_left(const kern_structure *s, const kern_motion *motion,
                             struct falls_part *left, kern_structure *part)
{
    int gone = 0;
    for (int i = 0; i < s->blocks; i++) {
        if (left->place[i] < 0 || !falls_moves(motion[i], &s->block[i]))
            continue;
        left->place[i] = -1;
        gone++;
    }
    falls_take(s, left, part);
    return gone;
}

/* Adds to a motion, with which the structure falls at a shrinkage, those with
   which what it leaves behind falls too, each with 1 as its fastest. The work
   memory is the task's. Where a verdict is undecided, the motions found by
   then. */
static inline void falls_all(const kern_task *task, kern_real shrink,
                             kern_motion *motion, struct falls_part *left)
{
    const kern_structure *s = &task->s;
    kern_task rest = *task;
    kern_proof proof = {NULL, NULL};
    proof.motion = left->motion;
    for (int i = 0; i < s->blocks; i++)
        left->place[i] = i;
    while (falls_left(s, motion, left, &rest.s) > 0
           && kern_verdict(&rest, shrink, &proof) == KERN_FALLS)
        for (int i = 0; i < s->blocks; i++)
            if (left->place[i] >= 0)
                motion[i] = left->motion[left->place[i]];
}

#endif /* FALLS_H */
