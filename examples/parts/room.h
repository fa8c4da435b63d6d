/* room.h - work memory and plans from malloc(), for programs that know only at
   run time how large they are.

   SPDX-License-Identifier: MIT */

#ifndef ROOM_H
#define ROOM_H

#include "../../kern.h"
#include "falls.h"

#include <stdlib.h>

/* Work memory for so many blocks and contact points; an array is NULL where
   there is none, or too many are asked for. */
static inline kern_work room_work(int blocks, int contacts)
{
    kern_real *real = NULL;
    int *index = NULL, reals = 0, ints = 0;
    kern_work_need(blocks, contacts, &reals, &ints);
    if (reals > 0 && ints > 0) {
        real = (kern_real *)malloc((size_t)reals * sizeof *real);
        index = (int *)malloc((size_t)ints * sizeof *index);
    }
    return kern_work_of(real, reals, index, ints);
}

static inline void room_free_work(kern_work *work)
{
    free(work->real);
    free(work->index);
    work->real = NULL;
    work->index = NULL;
}

/* An empty plan for so many blocks and contact points, which remembers its
   measures, and its work memory. Where memory is lacking arrays are NULL. */
static inline kern_plan room_plan(int blocks, int contacts, kern_work *work)
{
    const size_t b = (size_t)blocks, c = (size_t)contacts;
    *work = room_work(blocks, contacts);
    return kern_plan_of(
        (kern_block *)malloc(b * sizeof(kern_block)), blocks,
        (kern_contact *)malloc(c * sizeof(kern_contact)), contacts,
        kern_known_of((kern_motion *)malloc(b * sizeof(kern_motion)),
                      (kern_force *)malloc(c * sizeof(kern_force))),
        work);
}

/* Is all of a plan's memory there? */
static inline int room_is_there(const kern_plan *plan)
{
    return plan->block && plan->contact && plan->task.known.motion
        && plan->task.known.force && plan->task.work->real
        && plan->task.work->index;
}

static inline void room_free_plan(kern_plan *plan)
{
    free(plan->block);
    free(plan->contact);
    free(plan->task.known.motion);
    free(plan->task.known.force);
    if (plan->task.work)
        room_free_work(plan->task.work);
}

/* falls_all() with memory of its own; where that is lacking, nothing is added. */
static inline void room_falls(const kern_task *task, kern_real shrink,
                              kern_motion *motion)
{
    const size_t b = (size_t)task->s.blocks + 1;
    const size_t c = (size_t)task->s.contacts + 1;
    struct falls_part left;
    left.block = (kern_block *)malloc(b * sizeof(kern_block));
    left.contact = (kern_contact *)malloc(c * sizeof(kern_contact));
    left.motion = (kern_motion *)malloc(b * sizeof(kern_motion));
    left.place = (int *)malloc(b * sizeof(int));
    if (left.block && left.contact && left.motion && left.place)
        falls_all(task, shrink, motion, &left);
    free(left.block);
    free(left.contact);
    free(left.motion);
    free(left.place);
}

#endif /* ROOM_H */
