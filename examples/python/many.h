/* many.h - one question about many structures: the loop of kern.many() in
   Python. Every structure is the wall with other poses, another friction or one
   more stone, and is solved from its own numbers alone: so the answers do not
   depend on how the structures are divided among threads.

   SPDX-License-Identifier: MIT */

#ifndef MANY_H
#define MANY_H

#include "../../kern.h"
#include "../parts/room.h"

#include <math.h>
#include <string.h>

/* What is asked, and the arrays for the answers of all structures. */
struct many {
    const kern_structure *wall; /* blocks and gravity                         */
    const kern_options *options;
    const double *density;   /* of each block of the wall                     */
    const int *own;          /* of each block: MANY_MASS, MANY_CENTRE         */
    const double *pose;      /* x, y, turn of each block of each structure    */
    const double *mu;        /* of each structure                             */
    const kern_block *stone; /* one more block of each structure              */
    int *status;
    int *level;
    double *margin;      /* 0 where it falls, NaN where it is neither         */
    double *load;        /* NULL, or load factors to the left and right       */
    kern_motion *motion; /* NULL, or the mechanism of each structure          */
};

enum { MANY_MASS = 1, MANY_CENTRE = 2 }; /* what polygon and density give not */

/* Memory for one structure at a time. */
struct many_room {
    kern_block *block;
    kern_vec *vertex;
    kern_contact *contact;
    kern_force *force;
    kern_motion *motion;
    kern_work work;
    int blocks;
    int contacts;
};

static void many_close(struct many_room *room)
{
    free(room->block);
    free(room->vertex);
    free(room->contact);
    free(room->force);
    free(room->motion);
    room_free_work(&room->work);
}

/* Returns 1 if there is memory for the wall, one more block and so many contact
   points. */
static int many_open(const struct many *m, int contacts, struct many_room *room)
{
    const int blocks = m->wall->blocks + (m->stone != NULL);
    const size_t b = (size_t)blocks, c = (size_t)contacts;
    size_t vertices = 1;
    int i;
    for (i = 0; i < m->wall->blocks; i++)
        vertices += (size_t)m->wall->block[i].vertices;
    room->blocks = blocks;
    room->contacts = contacts;
    room->block = (kern_block *)malloc((b + 1) * sizeof(kern_block));
    room->vertex = (kern_vec *)malloc(vertices * sizeof(kern_vec));
    room->contact = (kern_contact *)malloc(c * sizeof(kern_contact));
    room->force = (kern_force *)malloc(c * sizeof(kern_force));
    room->motion = (kern_motion *)malloc((b + 1) * sizeof(kern_motion));
    room->work = room_work(blocks, contacts);
    return room->block && room->vertex && room->contact && room->force
        && room->motion && room->work.real && room->work.index;
}

/* Makes a block that is turned about the centre of mass of another, then
   shifted, with vertices of its own. Returns a kern_status. */
static kern_status many_move(const kern_block *from, const double *pose,
                             double density, int own, kern_vec *vertex,
                             kern_block *to)
{
    const double c = cos(pose[2]), s = sin(pose[2]);
    const kern_vec at = from->centre;
    kern_status status;
    int i;
    for (i = 0; i < from->vertices; i++) {
        kern_vec p = from->vertex[i];
        if (pose[2] != 0) {
            const double x = p.x - at.x, y = p.y - at.y;
            p.x = at.x + c * x - s * y;
            p.y = at.y + s * x + c * y;
        }
        vertex[i].x = p.x + pose[0];
        vertex[i].y = p.y + pose[1];
    }
    status = from->fixed
               ? kern_ground_init(to, vertex, from->vertices, NULL)
               : kern_block_init(to, vertex, from->vertices, density, NULL);
    if (own & MANY_MASS)
        to->mass = from->mass;
    if (own & MANY_CENTRE) {
        to->centre.x = at.x + pose[0];
        to->centre.y = at.y + pose[1];
    }
    to->load = from->load;
    return status;
}

/* Makes the blocks of structure k. Returns a kern_status. */
static kern_status many_place(const struct many *m, int k,
                              struct many_room *room)
{
    const int n = m->wall->blocks;
    kern_vec *vertex = room->vertex;
    int i;
    memcpy(room->block, m->wall->block, (size_t)n * sizeof(kern_block));
    for (i = 0; m->pose && i < n; i++) {
        const double *pose = m->pose + 3 * ((size_t)k * (size_t)n + (size_t)i);
        kern_status status;
        if (pose[0] == 0 && pose[1] == 0 && pose[2] == 0)
            continue;
        status = many_move(&m->wall->block[i], pose, m->density[i], m->own[i],
                           vertex, &room->block[i]);
        if (status != KERN_OK)
            return status;
        vertex += m->wall->block[i].vertices;
    }
    if (m->stone)
        room->block[n] = m->stone[k];
    return KERN_OK;
}

/* Writes the load factors of structure k, 0 where it falls without a load. */
static void many_loads(const struct many *m, int k, const kern_task *task,
                       kern_status alone)
{
    int side;
    for (side = 0; side < 2; side++) {
        double *load = &m->load[2 * (size_t)k + (size_t)side];
        kern_real factor = 0;
        kern_status status = alone;
        if (alone == KERN_STANDS)
            status = kern_load_factor(task, 0, side ? 1 : -1, &factor, NULL);
        if (status == KERN_STANDS || status == KERN_FALLS)
            *load = status == KERN_STANDS ? factor : 0;
    }
}

/* Answers for structure k. Returns its status: KERN_STANDS, KERN_FALLS, below 0
   the reason why there is no answer. */
static kern_status many_solve(const struct many *m, int k,
                              struct many_room *room)
{
    const kern_proof proof = {room->force, room->motion};
    kern_task task;
    kern_margin margin;
    kern_status status = many_place(m, k, room);
    int found;

    /* The blocks and their contacts. */
    if (status != KERN_OK)
        return status;
    task = kern_task_of(room->block, room->blocks, room->contact, 0,
                        &room->work);
    task.options = *m->options;
    task.s.gravity = m->wall->gravity;
    if (m->mu)
        task.options.mu = m->mu[k];
    found = kern_contacts(room->block, room->blocks, &task.options,
                          room->contact, room->contacts, &room->work);
    if (found < 0)
        return (kern_status)found;
    task.s.contacts = found;

    /* The margin, with its mechanism. */
    status = kern_measure(&task, &margin, &proof);
    if (status != KERN_STANDS && status != KERN_FALLS)
        return status;
    m->margin[k] = status == KERN_STANDS ? margin.margin : 0;
    m->level[k] = margin.level;
    if (m->motion && !(status == KERN_STANDS && margin.saturated))
        memcpy(m->motion + (size_t)k * (size_t)room->blocks, room->motion,
               (size_t)room->blocks * sizeof(kern_motion));
    if (m->load)
        many_loads(m, k, &task, status);
    return status;
}

/* Answers for the structures [first, end). Where contacts find no room there
   are more, up to a million. Returns 0 if memory is lacking. */
static int many_run(const struct many *m, int first, int end)
{
    struct many_room room;
    int contacts = 16 * (m->wall->blocks + 1), k, there;
    there = many_open(m, contacts, &room);
    for (k = first; there && k < end; k++) {
        m->status[k] = many_solve(m, k, &room);
        while (there && m->status[k] == KERN_NO_SPACE && contacts < 1000000) {
            contacts *= 2;
            many_close(&room);
            there = many_open(m, contacts, &room);
            if (there)
                m->status[k] = many_solve(m, k, &room);
        }
    }
    many_close(&room);
    return there;
}

#endif
