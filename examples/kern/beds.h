/* beds.h - one resultant a bed or joint, and the stresses at its two ends.

   A bed is all that lies on one line across gravity without a wide gap: the stones of
   a course on those of the course below. Any other face of an interface is a joint
   of its own. The forces are those of the report, less the bond of mortar; stresses are
   linear over all of the bed, whatever of it crushes, and without tension where
   nothing bonds.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_BEDS_H
#define PROGRAM_BEDS_H

#include "../../kern.h"

#include "../parts/json.h"
#include "loads.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

struct bed {
    int a, b;              /* blocks of its first interface                */
    int interfaces;        /* how many                                     */
    kern_vec n;            /* normal, into b                               */
    double level;          /* of its line along n                          */
    double low, high;      /* ends, along the tangent                      */
    double fx, fy, torque; /* the force on b, and its torque about (0, 0) */
};

static inline double bed_along(const struct bed *d, kern_vec p)
{
    return (double)(p.y * d->n.x - p.x * d->n.y);
}

/* The point of a bed at a place along it. */
static inline kern_vec bed_point(const struct bed *d, double along)
{
    kern_vec p;
    p.x = (kern_real)(d->level * d->n.x - along * d->n.y);
    p.y = (kern_real)(d->level * d->n.y + along * d->n.x);
    return p;
}

/* Are these normals of one face? */
static inline int bed_faces(kern_vec n, kern_vec m)
{
    return (double)(n.x * m.x + n.y * m.y) > 0.999;
}

/* Adds a force at p, given along the normal and the tangent of n. */
static inline void bed_press(struct bed *d, kern_vec p, kern_vec n,
                             double normal, double tangential)
{
    const double fx = normal * (double)n.x - tangential * (double)n.y;
    const double fy = normal * (double)n.y + tangential * (double)n.x;
    d->fx += fx;
    d->fy += fy;
    d->torque += (double)p.x * fy - (double)p.y * fx;
}

static inline double bed_normal(const struct bed *d)
{
    return d->fx * (double)d->n.x + d->fy * (double)d->n.y;
}

static inline double bed_shear(const struct bed *d)
{
    return d->fy * (double)d->n.x - d->fx * (double)d->n.y;
}

/* Where the resultant meets the line of the bed, along the tangent. */
static inline double bed_meets_at(const struct bed *d)
{
    return -(d->torque - d->level * bed_shear(d)) / bed_normal(d);
}

/* The bed of the face of contact k, among the n points from `first` on of its
   interface: all of them whose normal is that of k. */
static inline struct bed bed_of(const struct analysis *a, int k, int first,
                                int n)
{
    const kern_contact *c = &a->task.s.contact[k];
    struct bed d = {c->a, c->b, 1, c->n, 0, HUGE_VAL, -HUGE_VAL, 0, 0, 0};
    kern_vec middle;
    d.level = (double)(c->p.x * c->n.x + c->p.y * c->n.y);
    for (int i = first; i < first + n; i++) {
        const kern_contact *p = &a->task.s.contact[i];
        const double along = bed_along(&d, a->whole ? a->whole[i].p : p->p);
        if (!bed_faces(c->n, p->n))
            continue;
        d.low = fmin(d.low, along);
        d.high = fmax(d.high, along);
        bed_press(&d, p->p, p->n, (double)a->force[i].normal,
                  (double)a->force[i].tangential);
    }
    middle = bed_point(&d, (d.low + d.high) / 2);
    if (c->line && d.high > d.low)
        bed_press(&d, middle, c->n, -a->text.bond * (d.high - d.low), 0);
    return d;
}

/* Adds the beds of an interface to bed[]: one for each face, the longest contact
   first, so that a corner which touches a face at an angle is a row of its own.
   Returns how many. */
static inline int bed_faces_of(const struct analysis *a, int first, int n,
                               struct bed *bed)
{
    const kern_contact *c = a->task.s.contact;
    int beds = 0;
    for (;;) {
        double longest = -1;
        int k = -1;
        for (int i = first; i < first + n; i++) {
            const kern_vec p = c[i].p, q = c[i + draw_is_line(&a->task.s, i)].p;
            const double length = hypot((double)(q.x - p.x),
                                        (double)(q.y - p.y));
            int taken = 0;
            for (int j = 0; j < beds; j++)
                taken |= bed_faces(bed[j].n, c[i].n);
            if (taken || !(length > longest))
                continue;
            longest = length;
            k = i;
        }
        if (k < 0)
            return beds;
        bed[beds++] = bed_of(a, k, first, n);
    }
}

/* Is e a part of the same bed? */
static inline int bed_meets(const struct analysis *a, const struct bed *d,
                            const struct bed *e, double size)
{
    const kern_vec g = a->task.s.gravity;
    const double across = (double)(d->n.x * g.x + d->n.y * g.y) / gravity_of(a);
    return fabs(across) > 0.95 && bed_faces(d->n, e->n)
        && fabs(d->level - e->level) < 0.02 * size
        && fmax(d->low, e->low) - fmin(d->high, e->high) < 0.2 * size;
}

static inline void bed_join(struct bed *d, const struct bed *e)
{
    d->interfaces += e->interfaces;
    d->low = fmin(d->low, e->low);
    d->high = fmax(d->high, e->high);
    d->fx += e->fx;
    d->fy += e->fy;
    d->torque += e->torque;
}

/* Finds all beds and joints of stones that forces press, in the order of the
   file. Returns how many; *out is the caller's to free. */
static inline int find_beds(const struct analysis *a, struct bed **out)
{
    const kern_structure *s = &a->task.s;
    const double size = mean_size(a);
    struct bed *bed = array(s->contacts, sizeof *bed);
    int beds = 0, joined = 1;
    *out = bed;
    if (!bed || a->shown != KERN_STANDS)
        return 0;
    for (int k = 0, n = 1; k < s->contacts; k += n) {
        for (n = 1; k + n < s->contacts
                    && s->contact[k + n].a == s->contact[k].a
                    && s->contact[k + n].b == s->contact[k].b;)
            n++;
        if (s->contact[k].a < stones(a) && s->contact[k].b < stones(a))
            beds += bed_faces_of(a, k, n, bed + beds);
    }

    /* parts may meet by others: until none is left */
    while (joined && gravity_of(a) > 0) {
        joined = 0;
        for (int i = 0; i < beds; i++)
            for (int j = i + 1; j < beds; j++) {
                if (!bed_meets(a, &bed[i], &bed[j], size))
                    continue;
                bed_join(&bed[i], &bed[j]);
                for (int k = j--; k + 1 < beds; k++)
                    bed[k] = bed[k + 1];
                beds--;
                joined = 1;
            }
    }
    return beds;
}

/* The stress at the low and the high end of a bed, below 0 what mortar bears;
   NAN for a point, infinite where all is on an end. */
static inline void bed_stress(const struct bed *d, int bonds, double *e,
                              double *low, double *high)
{
    const double wide = d->high - d->low, middle = (d->low + d->high) / 2;
    const double normal = bed_normal(d), off = bed_meets_at(d) - middle;
    const double pressed = 3 * (wide / 2 - fabs(off));
    double most = pressed > 1e-6 * wide ? 2 * normal / pressed : HUGE_VAL;
    double least = 0;
    *e = wide > 0 ? off / wide : 0;
    *low = *high = (double)NAN;
    if (!(wide > 0))
        return;
    if (bonds || fabs(off) * 6 <= wide) {
        most = normal / wide * (1 + 6 * fabs(off) / wide);
        least = normal / wide * (1 - 6 * fabs(off) / wide);
    }
    if (fabs(least) < 1e-9 * most)
        least = 0;
    *low = off > 0 ? least : most;
    *high = off > 0 ? most : least;
}

/* A row of the tables. */
struct bed_row {
    kern_vec at, low_end, high_end;
    double e, low, high, normal, shear;
};

/* Returns 0 where nothing but rounding presses the bed, or pulls at its mortar. */
static inline int bed_row_of(const struct analysis *a, const struct bed *d,
                             struct bed_row *row)
{
    double most = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        most = fmax(most, (double)a->force[k].normal);
    row->normal = bed_normal(d);
    row->shear = bed_shear(d);
    if (!(fabs(row->normal) > 1e-9 * most))
        return 0;
    if (fabs(row->shear) < 1e-9 * fabs(row->normal))
        row->shear = 0;
    bed_stress(d, a->text.bond > 0, &row->e, &row->low, &row->high);
    row->at = bed_point(d, bed_meets_at(d));
    row->low_end = bed_point(d, d->low);
    row->high_end = bed_point(d, d->high);
    return 1;
}

/* A stress, that it is all on an end, or that there is none. */
static inline const char *bed_number(double stress, char out[32])
{
    snprintf(out, 32,
             isnan(stress)   ? "-"
             : isinf(stress) ? "edge"
                             : "%.4g",
             stress);
    return out;
}

static inline void report_beds(const struct analysis *a)
{
    struct bed *bed;
    const int beds = find_beds(a, &bed);
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    struct bed_row r;
    if (beds > 0)
        printf("  beds        %-10s %-10s %9s %9s %7s %9s %-18s %9s at\n",
               "from", "on", "normal", "shear", "e / b", "stress", "at",
               "stress");
    for (int i = 0; i < beds; i++) {
        const struct bed *d = &bed[i];
        char low[64], high[64], from[32], to[32];
        if (!bed_row_of(a, d, &r))
            continue;
        printf("              %-10s %-10s %9.4g %9.4g %7.3f %9s %-18s %9s "
               "%s",
               text_show(one, a->text.name[d->a]),
               text_show(two, a->text.name[d->b]), r.normal, r.shear, r.e,
               bed_number(r.low, from), loads_at(a, r.low_end, low),
               bed_number(r.high, to), loads_at(a, r.high_end, high));
        if (d->interfaces > 1)
            printf(", a bed of %d contacts", d->interfaces);
        printf("\n");
    }
    free(bed);
}

static inline void json_beds(const struct analysis *a)
{
    struct bed *bed;
    const int beds = find_beds(a, &bed);
    const char *comma = "";
    struct bed_row r;
    printf(", \"beds\": [");
    for (int i = 0; i < beds; i++) {
        if (!bed_row_of(a, &bed[i], &r))
            continue;
        printf("%s{", comma);
        json_string("a", a->text.name[bed[i].a]);
        printf(", ");
        json_string("b", a->text.name[bed[i].b]);
        printf(", \"interfaces\": %d", bed[i].interfaces);
        json_number("x", (double)r.at.x);
        json_number("y", (double)r.at.y);
        json_number("normal", r.normal);
        json_number("tangential", r.shear);
        json_number("eccentricity", r.e);
        json_number("x1", (double)r.low_end.x);
        json_number("y1", (double)r.low_end.y);
        json_number("stress1", r.low);
        json_number("x2", (double)r.high_end.x);
        json_number("y2", (double)r.high_end.y);
        json_number("stress2", r.high);
        printf("}");
        comma = ", ";
    }
    printf("]");
    free(bed);
}

#endif /* PROGRAM_BEDS_H */
