/* crush.h - stone that crushes: the statement `strength`.

   The ends of a line contact move in by half the length of the stress block that
   carries its force, and forces are asked for again until they settle. A contact
   that would have to be longer than it is then crushes and bears nothing more:
   what stands without it stands, since forces hold it that crush nothing. Verdict,
   margin, loads and tilts are those of contacts crushed by the load at rest; a
   factor of the live load is found with those that its own forces crush.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_CRUSH_H
#define PROGRAM_CRUSH_H

#include "../../kern.h"

#include "../parts/soil.h"
#include "state.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { CRUSH_ROUNDS = 60 };

/* A structure whose contacts crush. */
struct crushing {
    kern_task task;
    kern_contact *contact; /* of the task                        */
    kern_contact *whole;   /* as they were found                 */
    kern_force *force;     /* that hold it                       */
    char *own_mu;          /* of given contacts; NULL: are found */
    int settled;
};

/* Moves all ends in by what the forces crush. A bond is in the forces, and pulls
   on the stone where they press. Returns the largest change. */
static inline double crush_ends(const struct analysis *a,
                                const struct crushing *c)
{
    const double change = soil_crush(c->contact, c->whole, c->task.s.contacts,
                                     c->force, a->text.strength + a->text.bond,
                                     .5);
    kern_contact_travels(c->contact, c->task.s.contacts);
    return change;
}

/* The line contact that forces press most beyond what all of it bears; -1: there
   is none. */
static inline int crush_worst(const struct analysis *a,
                              const struct crushing *c)
{
    const double strength = a->text.strength + a->text.bond;
    double most = 1 + 1e-9;
    int worst = -1;
    for (int k = 0; k + 1 < c->task.s.contacts; k++) {
        const kern_contact *w = &c->whole[k];
        if (!draw_is_line(&c->task.s, k))
            continue;
        const double bears = strength
                           * hypot((double)(w[1].p.x - w->p.x),
                                   (double)(w[1].p.y - w->p.y));
        const double share = (double)(c->force[k].normal
                                      + c->force[k + 1].normal)
                           / bears;
        if (share > most) {
            most = share;
            worst = k;
        }
        k++;
    }
    return worst;
}

/* Takes away both ends of the line contact k. They are kept behind the last of
   whole[]. */
static inline void crush_remove(struct crushing *c, int k)
{
    const size_t after = (size_t)(c->task.s.contacts - k - 2);
    kern_contact gone[2];
    memcpy(gone, c->whole + k, sizeof gone);
    memmove(c->contact + k, c->contact + k + 2, after * sizeof *c->contact);
    memmove(c->whole + k, c->whole + k + 2, after * sizeof *c->whole);
    memcpy(c->whole + c->task.s.contacts - 2, gone, sizeof gone);
    if (c->own_mu)
        memmove(c->own_mu + k, c->own_mu + k + 2, after);
    c->task.s.contacts -= 2;
    kern_contact_travels(c->contact, c->task.s.contacts);
}

/* Crushes contacts until the forces settle or none hold it. Returns the verdict
   then. `motion` may be NULL. */
static inline kern_status crush_until(const struct analysis *a,
                                      struct crushing *c, kern_status status,
                                      kern_motion *motion)
{
    const double small = 1e-7 * mean_size(a);
    const kern_proof proof = {c->force, motion};
    c->settled = 0;
    for (int k = 0; k < CRUSH_ROUNDS && status == KERN_STANDS; k++) {
        if (crush_ends(a, c) < small) {
            const int worst = crush_worst(a, c);
            c->settled = worst < 0;
            if (c->settled)
                break;
            crush_remove(c, worst);
            k = 0;
        }
        status = kern_forces(&c->task, shrinkage(a), c->force);
        if (status != KERN_STANDS)
            status = kern_verdict(&c->task, shrinkage(a), &proof);
    }
    c->settled |= status != KERN_STANDS;
    return status;
}

/* Crushes the contacts by the load at rest. Returns -1 where memory is
   lacking. */
static inline int crush_settle(struct analysis *a)
{
    const size_t bytes = sizeof *a->whole * (size_t)a->task.s.contacts;
    struct crushing c = {a->task, a->contact, NULL, a->force, NULL, 0};
    const kern_status rigid = a->shown;
    free(a->whole);
    a->whole = array(a->task.s.contacts, sizeof *a->whole);
    if (!a->whole)
        return fail_memory(a);
    memcpy(a->whole, a->contact, bytes);
    c.whole = a->whole;
    if (a->text.given)
        c.own_mu = a->text.own_mu;

    a->shown = crush_until(a, &c, a->shown, a->motion);
    a->settled = c.settled;
    if (!c.settled && a->shown == KERN_STANDS)
        a->shown = KERN_UNDECIDED;
    a->crushes = rigid == KERN_STANDS && a->shown == KERN_FALLS;
    a->broken = (a->task.s.contacts - c.task.s.contacts) / 2;
    a->task.s.contacts = c.task.s.contacts;
    if (a->text.given)
        a->text.contacts = c.task.s.contacts;
    if (a->shown == KERN_STANDS)
        a->least = kern_forces(&a->task, shrinkage(a), a->force) == KERN_STANDS;
    a->crushed = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        a->crushed = fmax(a->crushed,
                          hypot((double)(a->contact[k].p.x - a->whole[k].p.x),
                                (double)(a->contact[k].p.y - a->whole[k].p.y)));
    return 0;
}

/* The structure of a task with a factor of a pattern of loads, in `block`. */
static inline kern_task loaded_task(const kern_task *task,
                                    const kern_wrench *pattern, double factor,
                                    kern_block *block)
{
    const kern_real f = (kern_real)factor;
    kern_task loaded = *task;
    for (int i = 0; i < task->s.blocks; i++) {
        block[i] = task->s.block[i];
        if (block[i].fixed)
            continue;
        block[i].load.fx += f * pattern[i].fx;
        block[i].load.fy += f * pattern[i].fy;
        block[i].load.torque += f * pattern[i].torque;
    }
    loaded.s.block = block;
    return loaded;
}

/* Room to try a factor in; NULL where memory is lacking. */
struct crush_room {
    kern_block *block;
    kern_contact *contact, *whole;
    kern_force *force;
    kern_motion *motion; /* how it falls, the caller's; may be NULL */
};

/* Does it stand under the pattern at this factor, with what that crushes? */
static inline int crush_bears(const struct analysis *a, const kern_task *task,
                              const kern_wrench *pattern, double factor,
                              const struct crush_room *r)
{
    const size_t bytes = sizeof *a->whole * (size_t)task->s.contacts;
    struct crushing c = {*task, r->contact, r->whole, r->force, NULL, 0};
    const kern_proof proof = {r->force, r->motion};
    memcpy(r->contact, a->whole, bytes);
    memcpy(r->whole, a->whole, bytes);
    c.task = loaded_task(task, pattern, factor, r->block);
    c.task.s.contact = r->contact;
    kern_status status = kern_forces(&c.task, shrinkage(a), r->force);
    if (status != KERN_STANDS)
        status = kern_verdict(&c.task, shrinkage(a), &proof);
    return crush_until(a, &c, status, r->motion) == KERN_STANDS && c.settled;
}

/* The largest factor found that it bears: up to `value` where that is finite. */
static inline kern_status crush_bisect(const struct analysis *a,
                                       const kern_task *task,
                                       const kern_wrench *pattern,
                                       const struct crush_room *r,
                                       kern_real *value)
{
    enum { DOUBLINGS = 64, HALVINGS = 80 };
    double low = 0, high = isfinite((double)*value) ? (double)*value : 1;
    int k;
    if (isfinite((double)*value)
        && crush_bears(a, task, pattern, high * (1 - 1e-4), r))
        return KERN_STANDS;
    if (!crush_bears(a, task, pattern, 0, r))
        return KERN_UNDECIDED;
    for (k = 0; k < DOUBLINGS && !isfinite((double)*value)
                && crush_bears(a, task, pattern, high, r);
         k++) {
        low = high;
        high *= 2;
    }
    if (k == DOUBLINGS)
        return KERN_STANDS;
    for (k = 0; k < HALVINGS && high - low > 1e-5 * high; k++) {
        const double middle = (low + high) / 2;
        *(crush_bears(a, task, pattern, middle, r) ? &low : &high) = middle;
    }
    *value = (kern_real)low;
    return KERN_STANDS;
}

/* The largest factor with contacts that the forces at each factor crush, which
   settle to a limit that is then held against crushing. */
static inline kern_status crush_limit(struct analysis *a, const kern_task *task,
                                      const kern_wrench *pattern,
                                      const struct crush_room *r,
                                      kern_real *value)
{
    const size_t bytes = sizeof *a->whole * (size_t)task->s.contacts;
    const kern_proof proof = {r->force, r->motion};
    struct crushing c = {*task, r->contact, a->whole, r->force, NULL, 0};
    kern_status status;
    double last = -1;
    memcpy(r->contact, a->contact, bytes);
    c.task.s.contact = r->contact;
    status = kern_load_factor_of(&c.task, shrinkage(a), pattern, value, &proof);
    for (int k = 0;
         k < CRUSH_ROUNDS && status == KERN_STANDS && isfinite((double)*value)
         && fabs((double)*value - last) > 1e-5 * (double)*value;
         k++) {
        last = (double)*value;
        crush_ends(a, &c);
        status = kern_load_factor_of(&c.task, shrinkage(a), pattern, value,
                                     &proof);
    }
    return status == KERN_STANDS ? crush_bisect(a, task, pattern, r, value)
                                 : status;
}

/* The largest factor of a pattern with the contacts that its forces crush, or
   where stone does not crush with contacts as they are. `motion` may be NULL. */
static inline kern_status crush_factor(struct analysis *a,
                                       const kern_task *task,
                                       const kern_wrench *pattern,
                                       kern_motion *motion, kern_real *value)
{
    const int n = task->s.contacts;
    const kern_proof proof = {NULL, motion};
    struct crush_room r = {NULL, NULL, NULL, NULL, motion};
    kern_status status = KERN_NO_SPACE;
    if (!a->whole)
        return kern_load_factor_of(task, shrinkage(a), pattern, value, &proof);
    r.block = array(task->s.blocks, sizeof *r.block);
    r.contact = array(n, sizeof *r.contact);
    r.whole = array(n, sizeof *r.whole);
    r.force = array(n, sizeof *r.force);
    if (r.block && r.contact && r.whole && r.force)
        status = crush_limit(a, task, pattern, &r, value);
    free(r.block);
    free(r.contact);
    free(r.whole);
    free(r.force);
    return status;
}

/* Between which factors of a pattern it stands: the least, and on top of that the
   largest that crush_factor() finds, NAN where that is not known. KERN_FALLS: it
   stands at none. `motion` may be NULL. */
static inline kern_status crush_range(struct analysis *a, const kern_task *task,
                                      const kern_wrench *pattern,
                                      kern_motion *motion, double *least,
                                      double *most)
{
    kern_block *block = array(task->s.blocks, sizeof *block);
    kern_real value = 0;
    kern_status status = KERN_NO_SPACE;
    *least = *most = (double)NAN;
    if (block)
        status = kern_least_load_of(task, shrinkage(a), pattern, &value, NULL);
    if (status == KERN_STANDS) {
        const kern_task loaded = loaded_task(task, pattern, (double)value,
                                             block);
        const double low = (double)value;
        const kern_status beyond = crush_factor(a, &loaded, pattern, motion,
                                                &value);
        *least = low;
        *most = low + value_or_nan(beyond, value);
    }
    free(block);
    return status;
}

#endif /* PROGRAM_CRUSH_H */
