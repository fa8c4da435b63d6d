/* crush.h - stone that crushes: the statement `strength`.

   The ends of a line contact move in by half the length of the stress block that
   carries its force, and forces are asked for again until they settle. Verdict,
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

/* Moves all ends in by what the forces crush. A bond is in the forces, and pulls
   on the stone where they press. Returns the largest change. */
static inline double crush_ends(struct analysis *a, const kern_force *force)
{
    const double change = soil_crush(a->contact, a->whole, a->task.s.contacts,
                                     force, a->text.strength + a->text.bond,
                                     .5);
    kern_contact_travels(a->contact, a->task.s.contacts);
    return change;
}

/* Crushes the contacts by the load at rest, until the forces settle or none
   hold it. Returns -1 where memory is lacking. */
static inline int crush_settle(struct analysis *a)
{
    const size_t bytes = sizeof *a->whole * (size_t)a->task.s.contacts;
    const double small = 1e-7 * mean_size(a);
    kern_proof proof = {a->force, a->motion};
    free(a->whole);
    a->whole = array(a->task.s.contacts, sizeof *a->whole);
    if (!a->whole)
        return fail_memory(a);
    memcpy(a->whole, a->contact, bytes);
    a->settled = a->shown != KERN_STANDS;
    for (int k = 0; k < CRUSH_ROUNDS && a->shown == KERN_STANDS; k++) {
        if (crush_ends(a, a->force) < small) {
            a->settled = 1;
            break;
        }
        a->shown = kern_forces(&a->task, shrinkage(a), a->force);
        a->least = a->shown == KERN_STANDS;
        if (!a->least)
            a->shown = kern_verdict(&a->task, shrinkage(a), &proof);
    }
    for (int k = 0; k < a->task.s.contacts; k++)
        a->crushed = fmax(a->crushed,
                          hypot((double)(a->contact[k].p.x - a->whole[k].p.x),
                                (double)(a->contact[k].p.y - a->whole[k].p.y)));
    return 0;
}

/* The largest factor of a pattern with the contacts that its forces crush, or
   where stone does not crush with contacts as they are. The contacts are left
   as they were. `motion` may be NULL. */
static inline kern_status crush_factor(struct analysis *a,
                                       const kern_task *task,
                                       const kern_wrench *pattern,
                                       kern_motion *motion, kern_real *value)
{
    const size_t bytes = sizeof *a->whole * (size_t)a->task.s.contacts;
    kern_contact *rest = a->whole ? (kern_contact *)malloc(bytes) : NULL;
    kern_force *force = a->whole ? (kern_force *)malloc(
                            sizeof *force * (size_t)a->task.s.contacts)
                                 : NULL;
    const kern_proof proof = {force, motion};
    kern_status status;
    double last = -1;
    if (rest)
        memcpy(rest, a->contact, bytes);
    status = kern_load_factor_of(task, shrinkage(a), pattern, value, &proof);
    for (int k = 0; k < CRUSH_ROUNDS && rest && force && status == KERN_STANDS
                    && isfinite((double)*value)
                    && fabs((double)*value - last) > 1e-5 * (double)*value;
         k++) {
        last = (double)*value;
        crush_ends(a, force);
        status = kern_load_factor_of(task, shrinkage(a), pattern, value,
                                     &proof);
    }
    if (rest)
        memcpy(a->contact, rest, bytes);
    free(rest);
    free(force);
    return status;
}

#endif /* PROGRAM_CRUSH_H */
