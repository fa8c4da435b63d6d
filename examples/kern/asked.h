/* asked.h - what options of the command line and statements of the file ask
   for, and errors that name blocks.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_ASKED_H
#define PROGRAM_ASKED_H

#include "../../kern.h"

#include "../parts/room.h"
#include "crush.h"
#include "let_go.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* All pairs that overlap, as far as the message has room, and the remedy. */
static inline int fail_overlaps(struct analysis *a, int block)
{
    const struct text_file *t = &a->text;
    int ints = 2 * t->blocks, *index = malloc((size_t)ints * sizeof *index);
    kern_work work = kern_work_of(NULL, 0, index, ints);
    kern_overlap pair[8];
    char list[400] = "", one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    size_t used = 0;
    int pairs = kern_overlaps(t->block, t->blocks, &a->task.options, pair, 8,
                              &work);
    int shown = 0;
    free(index);
    while (shown < pairs && shown < 8 && used < sizeof list / 2) {
        const kern_overlap *p = &pair[shown++];
        used += (size_t)snprintf(list + used, sizeof list - used,
                                 "%s'%s' and '%s' overlap, %.3g "
                                 "deep, %.3g is allowed",
                                 used ? "; " : "",
                                 text_show(one, t->name[p->a]),
                                 text_show(two, t->name[p->b]),
                                 (double)p->depth, (double)p->allowed);
    }
    if (pairs < 0)
        return fail(a, 0, "%s", kern_status_text((kern_status)pairs));
    if (shown < pairs)
        snprintf(two, sizeof two, "; %d pairs in all", pairs);
    return fail(a, t->block_line[block], "%s%s (--measured E, --overlap D)",
                list, shown < pairs ? two : "");
}

/* An error of the library, at the block it names. */
static inline int fail_blocks(struct analysis *a, kern_status status,
                              const kern_fault *fault)
{
    const struct text_file *t = &a->text;
    char one[TEXT_SHOW_ROOM];
    int i = fault->block, j = fault->other;
    if (i < 0 || i >= t->blocks)
        return fail(a, 0, "%s", kern_status_text(status));
    if (j < 0 || j >= t->blocks)
        return fail(a, t->block_line[i], "block '%s': %s",
                    text_show(one, t->name[i]), kern_status_text(status));
    return fail_overlaps(a, i > j ? i : j);
}

/* The least forces with the live load as the file has it. With stone that crushes
   they would crush other contacts than those at rest, and are not found. */
static inline int find_live_forces(struct analysis *a)
{
    kern_block *block;
    if (a->text.lives == 0 || a->whole || as_stated(a) != KERN_STANDS)
        return 0;
    block = array(a->task.s.blocks, sizeof *block);
    a->live_force = array(a->task.s.contacts, sizeof *a->live_force);
    const int there = block && a->live_force;
    if (there) {
        const kern_task task = loaded_task(&a->task, a->text.live, 1, block);
        if (kern_forces(&task, shrinkage(a), a->live_force) != KERN_STANDS) {
            free(a->live_force);
            a->live_force = NULL;
        }
    }
    free(block);
    return there ? 0 : fail_memory(a);
}

static inline int stays_under(const struct analysis *a,
                              const kern_wrench *pattern, kern_block *block,
                              double factor)
{
    const kern_task task = loaded_task(&a->task, pattern, factor, block);
    return kern_let_go(&task, NULL, NULL) == KERN_STANDS;
}

/* The factor of a pattern nearest to `moves` at which it stays, to .1 %. */
static inline double live_edge(const struct analysis *a,
                               const kern_wrench *pattern, kern_block *block,
                               double stays, double moves)
{
    while (fabs(stays - moves) > 1e-3 * fmax(stays, moves)) {
        const double middle = (stays + moves) / 2;
        *(stays_under(a, pattern, block, middle) ? &stays : &moves) = middle;
    }
    return stays;
}

/* Between which factors of the live load it stays let go. Without one, this is
   a path from rest: its raised load. Otherwise factors are walked up from the
   least at which it stands, or from a thousandth of the weight, by a quarter
   each, since let go is not monotone. */
static inline void find_live_let_go(struct analysis *a, kern_block *block)
{
    enum { STEPS = 60 };
    const kern_wrench *live = a->text.live;
    double weight = 0, push = 0, moves = 0, at;
    int k;
    if (a->let_go == KERN_STANDS) {
        a->live_let_go[0] = 0;
        a->live_let_go[1] = a->raised_load[LIVE] > a->live /* crushes */
                              ? a->live
                              : a->raised_load[LIVE];
        return;
    }
    for (k = 0; k < a->task.s.blocks; k++) {
        if (a->task.s.block[k].fixed)
            continue;
        weight += (double)a->task.s.block[k].mass * gravity_of(a);
        push += hypot(live[k].fx, live[k].fy);
    }
    at = fmax(a->live_least * (1 + 1e-9),
              push > 0 ? 1e-3 * weight / push : 1e-3);

    /* The first factor at which it stays, and the first beyond that at which it
       does not. */
    for (k = 0; k < STEPS && at <= a->live && !stays_under(a, live, block, at);
         k++) {
        moves = at;
        at *= 1.25;
    }
    if (k == STEPS || !(at <= a->live))
        return;
    a->live_let_go[0] = moves > 0 ? live_edge(a, live, block, at, moves) : at;
    for (; k < STEPS && 1.25 * at <= a->live
           && stays_under(a, live, block, 1.25 * at);
         k++)
        at *= 1.25;
    a->live_let_go[1] = live_edge(a, live, block, at, fmin(1.25 * at, a->live));
}

/* Between which factors of the live load it stands, and how it falls just beyond
   the largest, and between which it stays let go. */
static inline int find_live(struct analysis *a)
{
    kern_block *block;
    a->live_least = a->live = a->live_let_go[0] = a->live_let_go[1] = (double)
        NAN;
    if (a->shown < 0 || a->text.lives == 0)
        return 0;
    a->lived = crush_range(a, &a->task, a->text.live,
                           a->set->mechanism_live ? a->collapse : NULL,
                           &a->live_least, &a->live);
    if (a->lived != KERN_STANDS)
        return a->lived == KERN_NO_SPACE ? fail_memory(a) : 0;
    block = array(a->task.s.blocks, sizeof *block);
    if (block && asks_raised_loads(a))
        find_live_let_go(a, block);

    /* A path from rest asks contacts that the load at rest crushes. */
    if (a->whole && !(a->live_let_go[1] <= a->live))
        a->live_let_go[1] = isnan(a->live_let_go[1]) ? (double)NAN : a->live;
    free(block);
    return block ? 0 : fail_memory(a);
}

/* Margins first, then loads; without gravity there are none of those. */
static inline void find_profile(struct analysis *a)
{
    static const kern_side side[PROFILES] = {KERN_SHRINK, KERN_LEFT,
                                             KERN_RIGHT};
    int falls = gravity_of(a) > 0;
    a->profiled = KERN_OK;
    for (int k = 0; k < (falls ? PROFILES : 1); k++) {
        kern_status status;
        status = kern_profile(&a->task, side[k], a->fate[k], &a->all[k]);
        if (status < 0)
            a->profiled = status;
    }
    for (int k = falls ? PROFILES : 1; k < PROFILES; k++) {
        for (int i = 0; i < a->task.s.blocks; i++)
            a->fate[k][i] = (kern_real)NAN;
        a->all[k].least = a->all[k].mean = a->all[k].weak = a->all[k].drop =
            (kern_real)NAN;
    }
}

/* Whether the load raises the forces, and how far gravity may push sideways. */
static inline int find_raised(struct analysis *a)
{
    kern_real reserve = 0;
    int pushed = gravity_of(a) > 0;
    a->raised = kern_raised(&a->task, shrinkage(a), &a->raising,
                            pushed ? &reserve : NULL, NULL);
    a->reserve = value_or_nan(pushed ? a->raised : KERN_UNDECIDED, reserve);
    return a->raised < 0 && !is_open(a->raised)
             ? fail_blocks(a, a->raised, &a->work.fault)
             : 0;
}

/* The structure as it grows in the order of the file, all fixed blocks there
   from the start. */
struct grown {
    kern_task task;
    struct falls_part part;
};

static inline int open_grown(const struct analysis *a, struct grown *g)
{
    const size_t blocks = (size_t)a->task.s.blocks;
    g->task = a->task;
    g->part.contact = array(a->task.s.contacts, sizeof *g->part.contact);
    g->part.block = malloc(sizeof *g->part.block * blocks);
    g->part.place = malloc(sizeof *g->part.place * blocks);
    return g->part.contact && g->part.block && g->part.place;
}

static inline void close_grown(struct grown *g)
{
    free(g->part.contact);
    free(g->part.block);
    free(g->part.place);
}

/* All blocks up to `last`, with the contacts between them. */
static inline void grow_to(const struct analysis *a, struct grown *g, int last)
{
    const kern_structure *s = &a->task.s;
    for (int i = 0; i < s->blocks; i++)
        g->part.place[i] = s->block[i].fixed || i <= last ? 0 : -1;
    falls_take(s, &g->part, &g->task.s);
}

/* The chance that block i, laid last, stays; -1 where the structure falls. */
static inline void find_chance(const kern_task *task, int i, double *chance)
{
    kern_real value = 0;
    const kern_status status = kern_stays(task, i, &value);
    *chance = status == KERN_FALLS ? -1 : value_or_nan(status, value);
}

/* The margin after each block, 0 where it falls, NAN where that is undecided,
   and with gravity the chance that it stays on those before it. */
static inline int find_sequence(struct analysis *a)
{
    struct grown g = {0};
    int last, there = open_grown(a, &g);
    const int blocks = stones(a); /* before the pushes are there */
    a->sequence = malloc(sizeof *a->sequence * (size_t)blocks);
    a->laid = malloc(sizeof *a->laid * (size_t)blocks);
    there = there && a->sequence && a->laid;
    for (last = 0; last < blocks && there; last++) {
        kern_margin m;
        kern_status status;
        a->sequence[last] = a->laid[last] = (double)NAN;
        if (a->task.s.block[last].fixed)
            continue;
        grow_to(a, &g, last);
        status = kern_measure(&g.task, &m, NULL);
        if (status == KERN_STANDS)
            a->sequence[last] = (double)m.margin;
        if (status == KERN_FALLS)
            a->sequence[last] = 0;
        if (gravity_of(a) > 0)
            find_chance(&g.task, g.part.place[last], &a->laid[last]);
    }
    close_grown(&g);
    return last < blocks ? fail_memory(a) : 0;
}

/* The chance of the block of --stays, or of each, laid last on all others. */
static inline int find_stays(struct analysis *a)
{
    a->stays = array(a->task.s.blocks, sizeof *a->stays);
    for (int i = 0; i < a->task.s.blocks && a->stays; i++) {
        a->stays[i] = (double)NAN;
        if (is_asked(a, i))
            find_chance(&a->task, i, &a->stays[i]);
    }
    return a->stays ? 0 : fail_memory(a);
}

/* The interval of the margin of measured blocks, and whether the verdict holds
   within their error. Contacts that are given have no error. Twice the error
   finds more contacts, for which there is work memory of its own. */
static inline int find_certain(struct analysis *a)
{
    int room = 2 * a->task.s.contacts + KERN_CONTACTS(a->text.blocks);
    const int most = 64 * room;
    kern_status got = KERN_NO_SPACE;
    kern_margin m;
    if (!(pose_error(a) > 0) || a->text.given || is_open(a->shown)
        || shrinkage(a) > 0 || kern_measure(&a->task, &m, NULL) < 0)
        return 0;
    for (; got == KERN_NO_SPACE && room <= most; room *= 2) {
        kern_contact *out = malloc((size_t)room * sizeof *out);
        kern_work work = room_work(a->text.blocks, room);
        kern_task task = a->task;
        const int there = out && work.real && work.index;
        task.work = &work;
        if (there)
            got = kern_certain(&task, m.margin, &a->interval, out, room);
        free(out);
        room_free_work(&work);
        if (!there)
            return fail_memory(a);
    }
    a->probable = (double)m.margin;
    if (got >= 0)
        a->certain = got > 0;
    return 0;
}

/* How many times the error of --error, a length in every mode, the structure
   bears, 0 for what falls; the least friction at which it stands and at which
   it stays let go as a whole, and the tilts up to which it stays. */
static inline void find_error(struct analysis *a)
{
    const struct settings *set = a->set;
    const kern_options options = a->task.options;
    kern_margin m;
    a->bears = (double)NAN;
    a->task.options.relative = 0;
    a->task.options.epsilon = 0;
    a->task.options.narrow = set->own_turn > 0
                               ? (kern_real)tan((double)set->own_turn)
                                     / (2 * set->own_error)
                               : 0;
    a->borne = kern_measure(&a->task, &m, NULL);
    if (a->borne == KERN_STANDS)
        a->bears = (double)(m.margin / (2 * set->own_error));
    if (a->borne == KERN_FALLS)
        a->bears = 0;
    a->task.options = options;
    a->least_friction = find_friction(a, OF_VERDICT, &a->slid);
    a->least_friction_let_go = find_friction(a, OF_LET_GO, &a->slid_let_go);
    for (int side = LEFT; side <= RIGHT; side++)
        a->tilt_let_go[side] = find_tilt_let_go(a, side,
                                                &a->tilted_let_go[side]);
}

/* What every report and what options ask for, of the real contacts. */
static inline int find_what_is_asked(struct analysis *a)
{
    if (find_let_go(a) || (a->set->raised && find_raised(a)))
        return -1;
    find_raised_loads(a);
    if (a->set->own_error > 0)
        find_error(a);
    if (a->set->sequence && find_sequence(a))
        return -1;
    return a->set->stays ? find_stays(a) : 0;
}

#endif /* PROGRAM_ASKED_H */
