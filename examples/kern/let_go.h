/* let_go.h - whether it stays when all blocks are let go at once, the least
   friction and the tilt of that answer, and the loads that friction bears.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_LET_GO_H
#define PROGRAM_LET_GO_H

#include "../../kern.h"

#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Blocks up to which raised loads and a reserve are part of every report. */
enum { RAISED_MOST = 200 };

/* The reserve, as a share of gravity, from which on stones that are let go stay
   as a rule (tests/TRUST.md). */
#define ENOUGH_RESERVE ((kern_real)0.0055)

/* Why it stays. */
#define LOAD_BUILDS_UP "its own load builds up the forces that hold it"

/* The block that moves fastest, by its name. */
static inline const char *fastest_name(const struct analysis *a,
                                       const kern_motion *motion,
                                       char shown[TEXT_SHOW_ROOM])
{
    double most = -1;
    int fastest = 0;
    for (int i = 0; i < stones(a); i++) {
        const double size = sqrt(fabs((double)a->task.s.block[i].area));
        const double speed = hypot(motion[i].vx, motion[i].vy)
                           + fabs((double)motion[i].spin) * size / 2;
        if (!a->task.s.block[i].fixed && speed > most * (1 + 1e-9)) {
            most = speed;
            fastest = i;
        }
    }
    return text_show(shown, a->text.name[fastest]);
}

/* Why neither is shown. */
static inline const char *not_shown_why(const struct analysis *a, kern_end end)
{
    if (a->let_go == KERN_LIMIT)
        return "--limit ended the search (--limit 0 goes on)";
    if (a->let_go != KERN_UNDECIDED)
        return kern_status_text(a->let_go);
    return end == KERN_END_LOST ? "no equilibrium was found from rest"
         : end == KERN_END_WORK ? "a limit of work ended the search"
                                : "the verdict is undecided";
}

/* How it stays: where gravity acts, the reserve tells a firm structure from one
   on the edge. It is the one that --raised prints. */
static inline void explain_staying(struct analysis *a)
{
    kern_raising how;
    kern_real reserve = 0;
    kern_status status = KERN_UNDECIDED;
    if (gravity_of(a) > 0 && a->task.s.blocks <= RAISED_MOST)
        status = kern_raised(&a->task, 0, &how, &reserve, NULL);
    snprintf(a->let_go_why, sizeof a->let_go_why, "%s", LOAD_BUILDS_UP);
    const size_t used = strlen(a->let_go_why);
    if (gravity_of(a) > 0 && a->task.s.blocks > RAISED_MOST && !a->set->raised)
        snprintf(a->let_go_why + used, sizeof a->let_go_why - used,
                 "; the reserve is not asked above %d blocks (--raised)",
                 RAISED_MOST);
    if (status == KERN_STANDS && reserve < ENOUGH_RESERVE)
        snprintf(a->let_go_why + used, sizeof a->let_go_why - used,
                 ", with a reserve of %.4g g: %g is enough as a rule",
                 (double)reserve, (double)ENOUGH_RESERVE);
}

/* The answer for all blocks at once, on contacts as they are. */
static inline int find_let_go(struct analysis *a)
{
    kern_motion *motion = array(a->task.s.blocks, sizeof *motion);
    const kern_proof proof = {NULL, motion};
    kern_raising how = KERN_NOT_SHOWN;
    char shown[TEXT_SHOW_ROOM];
    if (!motion)
        return fail_memory(a);
    a->work.end = KERN_END_NONE;
    a->let_go = kern_let_go(&a->task, &how, &proof);

    /* What falls moves, as its verdict proves, whatever the limit says. */
    if (a->let_go == KERN_LIMIT && a->verdict == KERN_FALLS) {
        a->let_go = KERN_FALLS;
        memcpy(motion, a->motion, sizeof *motion * (size_t)a->task.s.blocks);
    }
    if (a->let_go == KERN_STANDS)
        explain_staying(a);
    else if (a->let_go == KERN_FALLS)
        snprintf(a->let_go_why, sizeof a->let_go_why, "%s; %s moves fastest",
                 how == KERN_HANGS ? "some blocks rest on nothing"
                                   : "no forces hold it",
                 fastest_name(a, motion, shown));
    else
        snprintf(a->let_go_why, sizeof a->let_go_why, "%s",
                 not_shown_why(a, a->work.end));
    free(motion);
    return 0;
}

/* What a bisection asks: the verdict, or let go as a whole. */
enum answer { OF_VERDICT, OF_LET_GO };

static inline kern_status answer_of(const kern_task *task, enum answer which)
{
    return which == OF_VERDICT ? kern_verdict(task, 0, NULL)
                               : kern_let_go(task, NULL, NULL);
}

/* Does contact k take the friction of the file or of --mu? */
static inline int takes_friction(const struct analysis *a, int k)
{
    return !a->text.given || !a->text.own_mu[k];
}

/* The answer where contacts without a value of their own have this friction. */
static inline kern_status answer_at(const struct analysis *a,
                                    kern_contact *contact, double mu,
                                    enum answer which)
{
    kern_task task = a->task;
    for (int k = 0; k < task.s.contacts; k++) {
        contact[k] = a->contact[k];
        if (takes_friction(a, k))
            contact[k].mu = (kern_real)mu;
    }
    task.s.contact = contact;
    task.options.mu = (kern_real)mu;
    return answer_of(&task, which);
}

/* Returns how many contacts take the friction of the file. */
static inline int frictions_taken(const struct analysis *a)
{
    int taken = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        taken += takes_friction(a, k);
    return taken;
}

/* A friction at which an answer holds, and one below it at which it does not,
   0 where none is known. */
struct friction {
    const struct analysis *a;
    enum answer which;
    kern_contact *contact;
    kern_status status; /* of the last question */
    double low, high;
};

static inline int holds_at(struct friction *f, double mu)
{
    f->status = answer_at(f->a, f->contact, mu, f->which);
    if (f->status != KERN_LIMIT)
        *(f->status == KERN_STANDS ? &f->high : &f->low) = mu;
    return f->status == KERN_STANDS;
}

/* Finds one: doubles the friction from `mu` on, up to 8 times that, or walks
   down from there by fifths. Let go is not monotone in friction, and a bisection
   alone might pass over a gap. Returns 0 where none holds. */
static inline int bracket_friction(struct friction *f, double mu)
{
    const double least = 1e-3 * mu, most = 8 * mu;
    double next = mu;
    while (!holds_at(f, next)) {
        next *= 2;
        if (f->status == KERN_LIMIT || next > most)
            return 0;
    }
    while (!(f->low > 0) && f->high > 0
           && holds_at(f, f->high > least ? 0.8 * f->high : 0))
        continue;
    return f->status != KERN_LIMIT;
}

/* The least friction of an answer: at all values that were asked from there up
   to that of the file it stands, or stays. To 1e-5 of it; NAN where no contact
   takes it, none up to 8 times that of the file is enough, or the limit of work
   ends a question, of which *status tells. */
static inline double find_friction(const struct analysis *a, enum answer which,
                                   kern_status *status)
{
    struct friction f = {
        a, which, array(a->task.s.contacts, sizeof *f.contact), KERN_OK, 0, 0};
    const int found = f.contact && frictions_taken(a) > 0
                   && bracket_friction(&f,
                                       fmax((double)a->task.options.mu, 0.01));
    while (found && f.status != KERN_LIMIT && f.high - f.low > 1e-5 * f.high)
        holds_at(&f, (f.low + f.high) / 2);
    free(f.contact);
    *status = f.status;
    return found && f.status != KERN_LIMIT ? f.high : (double)NAN;
}

/* Whether it stays when gravity turns by this angle to a side. */
static inline kern_status stays_tilted(const struct analysis *a, int side,
                                       double angle)
{
    kern_task task = a->task;
    const double s = side == LEFT ? -sin(angle) : sin(angle);
    const double x = (double)task.s.gravity.x, y = (double)task.s.gravity.y;
    task.s.gravity.x = (kern_real)(x * cos(angle) - y * s);
    task.s.gravity.y = (kern_real)(y * cos(angle) + x * s);
    return kern_let_go(&task, NULL, NULL);
}

/* Does anything but weight act? */
static inline int has_loads(const struct analysis *a)
{
    int loads = 0;
    for (int i = 0; i < a->task.s.blocks; i++) {
        const kern_wrench *w = &a->task.s.block[i].load;
        loads += fabs((double)w->fx) > 0 || fabs((double)w->fy) > 0
              || fabs((double)w->torque) > 0;
    }
    return loads > 0;
}

/* The tilt up to which it stays, at all angles that were asked, to 1e-5, and no
   more than that of the verdict and than that at which a load sideways of as
   much is raised from rest; NAN where it does not stay as it is, that is not
   known, or the limit of work ends a question, of which *status tells. */
static inline double find_tilt_let_go(const struct analysis *a, int side,
                                      kern_status *status)
{
    enum { STEPS = 8 };
    kern_real most = 0;
    double low = 0, high = 0, last;
    *status = KERN_OK;
    if (a->let_go != KERN_STANDS || !(gravity_of(a) > 0))
        return (double)NAN;
    *status = kern_tilt(&a->task, 0, side == LEFT ? KERN_LEFT : KERN_RIGHT,
                        &most, NULL);
    if (*status != KERN_STANDS)
        return (double)NAN;
    if (!has_loads(a) && a->raised_load[side] >= 0)
        most = (kern_real)fmin((double)most, atan(a->raised_load[side]));
    last = isfinite((double)most) ? (double)most : 1.5;

    /* Walk up to the first angle at which it does not stay. */
    for (int k = 1; k <= STEPS && !(high > 0); k++) {
        const double angle = last * (1 - 1e-5) * k / STEPS;
        *status = stays_tilted(a, side, angle);
        *(*status == KERN_STANDS ? &low : &high) = angle;
    }
    if (!(high > 0))
        return (double)most;
    while (high - low > 1e-5 && *status != KERN_LIMIT) {
        const double middle = (low + high) / 2;
        *status = stays_tilted(a, side, middle);
        *(*status == KERN_STANDS ? &low : &high) = middle;
    }
    return *status == KERN_LIMIT ? (double)NAN : low;
}

/* Are raised loads looked for? Near contacts carry nothing at rest. */
static inline int asks_raised_loads(const struct analysis *a)
{
    return a->set->raised || (!is_near(a) && a->task.s.blocks <= RAISED_MOST);
}

/* Are loads sideways that friction bears reported beside those of limit
   analysis? Those are of real contacts. */
static inline int has_friction_loads(const struct analysis *a)
{
    return asks_raised_loads(a) && !is_near(a);
}

static inline const char *end_word(kern_status status, kern_end end)
{
    if (status == KERN_LIMIT || end == KERN_END_WORK)
        return "work";
    return end == KERN_END_SHOWN ? "load factor"
         : end == KERN_END_LOST  ? "no equilibrium"
                                 : NULL;
}

/* Loads with Coulomb friction, from rest, and why each path ended. */
static inline void find_raised_loads(struct analysis *a)
{
    static const kern_side side[3] = {KERN_LEFT, KERN_RIGHT, KERN_SHRINK};
    for (int k = 0; k < 3; k++) {
        const kern_wrench *pattern = k == LIVE ? a->text.live : NULL;
        kern_real value = 0;
        a->raised_load[k] = (double)NAN;
        kern_status status;
        if (a->verdict != KERN_STANDS || !asks_raised_loads(a)
            || !(pattern ? a->text.lives > 0 : k != LIVE && gravity_of(a) > 0))
            continue;
        a->work.end = KERN_END_NONE;
        status = kern_raised_load(&a->task, shrinkage(a), side[k], pattern,
                                  &value, NULL);
        a->raised_load[k] = value_or_nan(status, value);
        a->raised_end[k] = end_word(status, a->work.end);
        a->cut[k] = status == KERN_LIMIT;
    }
}

/* Is the raised load to a side, or of the live load, more than 2 % below the
   load factor, or not shown? Asked of loads of the same contacts. */
static inline int is_lower(const struct analysis *a, int side)
{
    const double raised = side == LIVE ? a->live_let_go[1]
                                       : a->raised_load[side];
    const double plain = side == LIVE ? a->live : a->load[side];
    if (!has_friction_loads(a) || isnan(plain) || isinf(raised))
        return 0;
    return isnan(raised) || raised < 0.98 * plain;
}

#endif /* PROGRAM_LET_GO_H */
