/* thrust.h - --thrust NAME: the least and the greatest horizontal force that a
   support gives the structure.

   The support is set free to move sideways: it becomes a block that is far heavier
   than all others, on a floor without friction, and a horizontal force on it is
   asked for as a live load. The least is what it gives as it settles outwards,
   the greatest as it is pressed in.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_THRUST_H
#define PROGRAM_THRUST_H

#include "../../kern.h"

#include "../parts/room.h"
#include "crush.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The structure with a support that slides. */
struct thrust {
    kern_task task;
    kern_work work;
    kern_block *block; /* one more than there were: the floor                */
    kern_contact *contact; /* two points more                               */
    kern_wrench *push;
    int support;
};

static inline void thrust_close(struct thrust *t)
{
    free(t->block);
    free(t->contact);
    free(t->push);
    room_free_work(&t->work);
}

/* The fixed block of the name; -1: there is none. */
static inline int thrust_support(const struct analysis *a)
{
    for (int i = 0; i < stones(a); i++)
        if (a->task.s.block[i].fixed
            && strcmp(a->text.name[i], a->set->thrust) == 0)
            return i;
    return -1;
}

/* Makes the support a heavy block on two points of the floor, a hundred stones
   apart. Returns a status. */
static inline kern_status thrust_open(const struct analysis *a,
                                      struct thrust *t, kern_vec floor[4])
{
    const kern_structure *s = &a->task.s;
    const int blocks = s->blocks, contacts = s->contacts;
    const double half = 50 * mean_size(a);
    kern_block *support = t->block + t->support;
    kern_contact *c = t->contact + contacts;
    double weight = 0, area;
    kern_status status;
    memcpy(t->block, s->block, sizeof *t->block * (size_t)blocks);
    memcpy(t->contact, s->contact, sizeof *t->contact * (size_t)contacts);
    for (int i = 0; i < blocks; i++)
        if (!s->block[i].fixed)
            weight += (double)s->block[i].mass
                    + hypot((double)s->block[i].load.fx,
                            (double)s->block[i].load.fy)
                          / gravity_of(a);

    /* what pushes as needed does so from the floor, not from the support */
    for (int k = 0; k < contacts; k++)
        if (t->contact[k].a == t->support && t->contact[k].b >= stones(a))
            t->contact[k].a = blocks;

    /* a floor of any shape: contacts are given */
    area = fabs((double)support->area);
    for (int k = 0; k < 4; k++) {
        floor[k].x = support->centre.x
                   + (kern_real)(k == 1 || k == 2 ? half : -half);
        floor[k].y = support->centre.y - (kern_real)(k < 2 ? half : 0);
    }
    status = kern_block_init(support, support->vertex, support->vertices,
                             (kern_real)(1000 * weight / area), NULL);
    if (status == KERN_OK)
        status = kern_ground_init(&t->block[blocks], floor, 4, NULL);
    if (status != KERN_OK)
        return status;
    for (int k = 0; k < 2; k++) {
        memset(&c[k], 0, sizeof c[k]);
        c[k].a = blocks;
        c[k].b = t->support;
        c[k].n.y = 1;
        c[k].p = floor[3 - k];
        const int made = kern_contact_make(&c[k], c[k].p, &a->task.options);
        if (made < 0)
            return (kern_status)made;
    }
    t->task = kern_task_of(t->block, blocks + 1, t->contact, contacts + 2,
                           &t->work);
    t->task.s.gravity = s->gravity;
    t->task.options = a->task.options;
    return KERN_OK;
}

/* The least and the largest force toward the side, -1 or 1. Contacts stay as the
   load at rest crushes them. */
static inline kern_status thrust_toward(const struct analysis *a,
                                        struct thrust *t, int side,
                                        double *least, double *most)
{
    struct analysis rigid = *a;
    rigid.whole = NULL;
    t->push[t->support].fx = (kern_real)side;
    return crush_range(&rigid, &t->task, t->push, NULL, least, most);
}

/* Between which forces to the left it stands; below 0 to the right. */
static inline kern_status thrust_range(struct analysis *a, struct thrust *t)
{
    double least, most;
    kern_status status = thrust_toward(a, t, -1, &a->thrust_least,
                                       &a->thrust_most);
    if (status == KERN_STANDS && a->thrust_least > 0)
        return status;
    const int left = status == KERN_STANDS;
    status = thrust_toward(a, t, 1, &least, &most);
    if (status == KERN_STANDS) { /* or to the left where that holds it */
        a->thrust_least = -most;
        a->thrust_most = left ? a->thrust_most : -least;
    }
    return status;
}

/* Asks for both; leaves them NAN where it falls or they are not known. */
static inline int find_thrust(struct analysis *a)
{
    const size_t blocks = (size_t)a->task.s.blocks + 1;
    const int points = a->task.s.contacts + 2;
    struct thrust t;
    kern_vec floor[4];
    kern_status status = KERN_UNDECIDED;
    memset(&t, 0, sizeof t);
    a->thrust_least = a->thrust_most = (double)NAN;
    if (a->shown != KERN_STANDS)
        return 0;
    t.support = thrust_support(a);
    t.block = malloc(sizeof *t.block * blocks);
    t.contact = malloc(sizeof *t.contact * (size_t)points);
    t.push = calloc(blocks, sizeof *t.push);
    t.work = room_work((int)blocks, points);
    const int there = t.block && t.contact && t.push && t.work.real
                   && t.work.index;
    if (there)
        status = thrust_open(a, &t, floor);
    if (status == KERN_OK)
        status = thrust_range(a, &t);
    if (status < 0)
        a->thrust_least = a->thrust_most = (double)NAN;
    thrust_close(&t);
    return there ? 0 : fail_memory(a);
}

#endif /* PROGRAM_THRUST_H */
