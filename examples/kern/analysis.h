/* analysis.h - reads a file, finds its contacts, the verdict, and what follows
   the verdict.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_ANALYSIS_H
#define PROGRAM_ANALYSIS_H

#include "../../kern.h"

#include "../parts/args.h"
#include "../parts/drawing.h"
#include "asked.h"
#include "crush.h"
#include "earth.h"
#include "place.h"
#include "sweep.h"
#include "thrust.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Beyond that an int may not hold the length of the work arrays. */
enum { MOST_CONTACTS = 10000000 };

/* The contacts of the file, or all that are found between its polygons. */
static inline int find_contacts(struct analysis *a)
{
    struct text_file *t = &a->text;
    if (t->given) {
        a->contact = t->contact;
        a->task.s.contacts = t->contacts;
        for (int k = 0; k < t->contacts; k++)
            if (!t->own_mu[k])
                t->contact[k].mu = a->task.options.mu;
        return 0;
    }
    kern_options search = a->task.options; /* a short limit is for questions */
    kern_fault fault;
    if (search.limit > 0 && search.limit < kern_defaults().limit)
        search.limit = kern_defaults().limit;
    const int found = text_all_contacts(t->block, t->blocks, &search,
                                        &a->contact, &fault);
    if (found == KERN_NO_SPACE)
        return fail(a, 0, "not enough memory for the contacts of %d blocks",
                    t->blocks);
    if (found < 0)
        return fail_blocks(a, (kern_status)found, &fault);
    a->task.s.contacts = found;
    return 0;
}

/* The stage that a large structure is at, shown on a terminal. */
static inline void show_stage(const struct analysis *a, const char *what)
{
    if (a->task.s.blocks < 200 || !ARGS_TERMINAL(2))
        return;
    fprintf(stderr, "\r%-20s%s", what, *what ? "" : "\r");
    fflush(stderr);
}

static inline int take_memory(struct analysis *a)
{
    int blocks = a->task.s.blocks, contacts = a->task.s.contacts;
    if (contacts > MOST_CONTACTS)
        return fail_memory(a);
    a->work = room_work(blocks, contacts);
    a->force = array(contacts, sizeof *a->force);
    a->last_force = array(contacts, sizeof *a->last_force);
    a->critical.limit = array(contacts, sizeof *a->critical.limit);
    a->critical.meeting = array(contacts, sizeof *a->critical.meeting);
    a->motion = array(blocks, sizeof *a->motion);
    a->fall = array(blocks, sizeof *a->fall);
    a->collapse = array(blocks, sizeof *a->collapse);
    int bad = 0;
    for (int k = 0; k < PROFILES; k++) {
        a->fate[k] = array(blocks, sizeof *a->fate[k]);
        bad |= !a->fate[k];
    }
    bad |= !a->critical.limit || !a->critical.meeting;
    return a->work.real && a->work.index && a->force && a->last_force
                && a->motion && a->fall && a->collapse && !bad
             ? 0
             : fail_memory(a);
}

static inline void free_work(struct analysis *a)
{
    room_free_work(&a->work);
    free(a->force);
    free(a->last_force);
    free(a->critical.limit);
    free(a->critical.meeting);
    free(a->motion);
    free(a->fall);
    free(a->collapse);
    for (int k = 0; k < PROFILES; k++)
        free(a->fate[k]);
}

/* Frees what was found of a structure. */
static inline void free_found(struct analysis *a)
{
    if (a->contact != a->text.contact)
        free(a->contact);
    free(a->sequence);
    free(a->laid);
    free(a->stays);
    free(a->swept);
    free(a->placed);
    text_free(&a->stone);
    free(a->place_vertex);
    free(a->stress);
    free(a->whole);
    free(a->live_force);
    for (int k = 0; k < EARTH_PARTS; k++)
        free(a->earth[k].motion);
    free_work(a);
}

static inline void free_analysis(struct analysis *a)
{
    if (a->without) {
        free_found(a->without);
        free(a->without->text.contact);
        free(a->without->text.own_mu);
        free(a->without);
    }
    free_found(a);
    text_free(&a->text);
    drawing_free(&a->drawing);
}

/* What limits the margin; nothing does where it is not known or saturated. */
static inline void find_limit(struct analysis *a)
{
    int falls = a->measured == KERN_FALLS;
    kern_proof proof = {falls ? NULL : a->last_force, a->collapse};
    a->critical.contact = -1;
    if (a->measured < 0 || (!falls && a->m.saturated))
        return;
    kern_critical_of(&a->task, a->m.margin, &proof, &a->critical);
}

/* At the margin a force acts no nearer to the end of a line contact than that:
   it can spread over twice the margin, or over all of a shorter contact, with what
   crushes at their ends. A bond,
   which presses all of a joint, is no stress of the stone. */
static inline void find_stress(struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    kern_force *least = array(s->contacts, sizeof *least), *force = least;
    a->stress = array(s->contacts, sizeof *a->stress);
    if (a->measured == KERN_STANDS && force && a->stress) {
        if (kern_forces(&a->task, a->m.holds, least) != KERN_STANDS)
            force = a->last_force;
        for (int k = 0; k < s->contacts; k++) {
            if (!draw_is_line(s, k))
                continue;
            kern_vec p = a->whole ? a->whole[k].p : s->contact[k].p;
            kern_vec q = kern_contact_at(&s->contact[k], a->m.margin,
                                         a->set->relative);
            double pressed = (double)force[k].normal + force[k + 1].normal;
            if (pressed > 0)
                a->stress[k] = fmax(pressed / (2 * hypot(q.x - p.x, q.y - p.y))
                                        - a->text.bond,
                                    0);
            k++;
        }
    }
    free(least);
}

/* The load factor to a side. A raised load of the same contacts that ended
   there is this factor. */
static inline double find_load(const struct analysis *a, int side)
{
    kern_real value = 0;
    if (!is_near(a) && a->raised_end[side]
        && strcmp(a->raised_end[side], end_word(KERN_OK, KERN_END_SHOWN)) == 0)
        return a->raised_load[side];
    const kern_status status = kern_load_factor(
        &a->task, shrinkage(a), side == LEFT ? KERN_LEFT : KERN_RIGHT, &value,
        NULL);
    return value_or_nan(status, value);
}

/* The load factor and the tilt to each side. Where weight alone acts, weight
   with a load sideways is a larger weight at a slant, which the same forces
   hold, made as much larger: the tilt is atan(load). */
static inline void find_loads(struct analysis *a)
{
    const int loads = has_loads(a);
    for (int side = LEFT; side <= RIGHT; side++) {
        a->load[side] = a->tilt[side] = (double)NAN;
        if (a->shown != KERN_STANDS || !(gravity_of(a) > 0))
            continue;
        a->load[side] = find_load(a, side);
        if (!loads && isfinite(a->load[side])) {
            a->tilt[side] = atan(a->load[side]);
            continue;
        }
        kern_real value = 0;
        const kern_status status = kern_tilt(
            &a->task, shrinkage(a), side == LEFT ? KERN_LEFT : KERN_RIGHT,
            &value, NULL);
        a->tilt[side] = value_or_nan(status, value);
    }
}

/* The contacts with these options, and the verdict with them. */
static inline int decide(struct analysis *a, const kern_options *options)
{
    kern_proof proof = {NULL, NULL};
    a->task.options = *options;
    if (find_contacts(a))
        return -1;
    a->task.s.contact = a->contact;
    free_work(a);
    if (take_memory(a))
        return -1;
    proof.force = a->force;
    proof.motion = a->motion;
    /* The least forces prove it as well, and of thousands of blocks sooner. */
    a->shown = kern_forces(&a->task, shrinkage(a), a->force);
    a->least = a->shown == KERN_STANDS;
    if (!a->least)
        a->shown = kern_verdict(&a->task, shrinkage(a), &proof);
    if (a->text.strength > 0 && crush_settle(a))
        return -1;
    if (a->shown == KERN_FALLS) {
        memcpy(a->fall, a->motion, sizeof *a->fall * (size_t)a->task.s.blocks);
        room_falls(&a->task, shrinkage(a), a->fall);
    }
    return a->shown < 0 && !is_open(a->shown)
             ? fail_blocks(a, a->shown, &a->work.fault)
             : 0;
}

/* Finds the bearing length: of the stretches of the contacts, unless these are
   given. Stretches are more points than contacts where faces are hollow. */
static inline int find_bearing(struct analysis *a)
{
    int room = 2 * a->task.s.contacts + KERN_CONTACTS(a->text.blocks);
    const int most = 64 * room;
    kern_task task = a->task;
    kern_status status = KERN_NO_SPACE;
    kern_real length = 0;
    if (a->text.given)
        status = kern_bearing(&task, &length, NULL);
    for (; status == KERN_NO_SPACE && room <= most; room *= 2) {
        kern_contact *out = malloc((size_t)room * sizeof *out);
        kern_work work = room_work(a->text.blocks, room);
        const int there = out && work.real && work.index;
        task.s.contact = out;
        task.work = &work;
        if (there) {
            task.s.contacts = kern_stretches(task.s.block, task.s.blocks,
                                             &task.options, out, room, &work);
            status = (kern_status)task.s.contacts;
        }
        if (there && task.s.contacts >= 0)
            status = kern_bearing(&task, &length, NULL);
        free(out);
        room_free_work(&work);
        if (!there)
            return fail_memory(a);
    }
    a->bearing = value_or_nan(status, length);
    return 0;
}

/* Finds the deficit of what falls, the bearing length of what stands. */
static inline int find_lengths(struct analysis *a)
{
    kern_real length = 0;
    a->deficit = a->bearing = (double)NAN;
    if (a->measured == KERN_FALLS) {
        kern_status status = kern_deficit(&a->task, &length);
        a->deficit = status < 0 ? (double)NAN : (double)length;
    }
    return a->measured == KERN_STANDS ? find_bearing(a) : 0;
}

/* Returns how many of the last blocks are pushes of fill. */
static inline int fill_pushes(const struct analysis *a)
{
    int pushes = 0;
    for (int k = 0; k < a->text.soils; k++)
        if (a->text.soil[k].kind == TEXT_FILL)
            pushes += a->text.soil[k].props;
    return pushes;
}

/* Copies the contacts of all blocks but these pushes, as they were found. Returns
   -1 where memory is lacking. */
static inline int copy_without(const struct analysis *a, struct analysis *w,
                               int pushes)
{
    const int contacts = a->task.s.contacts + 2 * a->broken;
    const kern_contact *found = a->whole ? a->whole : a->contact;
    w->text.blocks -= pushes;
    w->text.props -= pushes;
    w->text.contacts = 0;
    w->text.contact = array(contacts, sizeof *w->text.contact);
    w->text.own_mu = array(contacts, 1);
    if (!w->text.contact || !w->text.own_mu)
        return -1;
    memset(w->text.own_mu, 1, (size_t)contacts); /* all have theirs by now */
    for (int k = 0; k < contacts; k++)
        if (found[k].a < w->text.blocks && found[k].b < w->text.blocks)
            w->text.contact[w->text.contacts++] = found[k];
    return 0;
}

/* Asks the same where fill weighs and spreads axles, but does not push back:
   whether it stands and stays, and the factors of the live load. */
static inline int find_without(struct analysis *a)
{
    const int pushes = fill_pushes(a);
    struct analysis *w;
    if (pushes == 0 || a->verdict != KERN_STANDS)
        return 0;
    w = a->without = array(1, sizeof *w);
    if (!w)
        return fail_memory(a);
    w->bare = 1;
    w->set = a->set;
    w->text = a->text;
    w->task = a->task;
    w->task.work = &w->work;
    w->task.s.blocks -= pushes;
    w->critical.contact = -1;
    if (copy_without(a, w, pushes))
        return fail_memory(a);
    if (decide(w, &a->task.options))
        return fail(a, 0, "%s", w->error);
    w->verdict = w->shown;
    if (find_let_go(w))
        return fail(a, 0, "%s", w->error);
    find_raised_loads(w);
    return find_live(w) || (a->set->sweep > 0 && find_sweep(w))
             ? fail(a, 0, "%s", w->error)
             : 0;
}

/* What options ask for beside the margin and the loads. */
static inline int find_more(struct analysis *a)
{
    const struct settings *set = a->set;
    find_earth(a);
    return (set->page && find_live_forces(a))
                || (set->sweep > 0 && find_sweep(a)) || find_without(a)
                || (set->place && find_places(a))
                || (set->thrust && find_thrust(a))
             ? -1
             : 0;
}

/* What follows the verdict. */
static inline int measure(struct analysis *a)
{
    kern_proof limit = {a->last_force, a->collapse};
    const kern_options near_too = kern_near(&a->task.options,
                                            (kern_real)mean_size(a));
    show_stage(a, "  let go ...");
    if (find_what_is_asked(a))
        return -1;
    if (is_near(a) && decide(a, &near_too))
        return -1;
    limit.force = a->last_force;
    limit.motion = a->collapse;
    show_stage(a, "  margin ...");
    a->measured = kern_measure(&a->task, &a->m, &limit);
    if (a->measured == KERN_BAD_STEP)
        return fail(a, a->set->epsilon < 0 ? a->text.epsilon_line : 0,
                    "%s, the step is %.9g (--epsilon)",
                    kern_status_text(a->measured),
                    (double)a->task.options.epsilon);
    if (a->measured < 0 && !is_open(a->measured))
        return fail_blocks(a, a->measured, &a->work.fault);
    if (find_lengths(a))
        return -1;
    find_limit(a);
    find_stress(a);
    show_stage(a, "  load factors ...");
    find_loads(a);
    if (find_live(a) || find_more(a))
        return -1;
    show_stage(a, "  profile ...");
    if (a->set->profile)
        find_profile(a);
    return 0;
}

static inline int read_structure(struct analysis *a)
{
    return drawing_load(&a->text, &a->drawing, a->file, &a->set->drawing)
             ? fail(a, a->text.line, "%s", a->text.message)
             : 0;
}

/* Lengths of the command line by which everything would touch everything are
   of another unit, or mistyped. */
static inline int check_lengths(struct analysis *a)
{
    const struct settings *set = a->set;
    const double size = mean_size(a);
    static const char *const share[] = {"", "a fifth of "};
    const struct {
        const char *name;
        kern_real value;
        int part;
    } length[] = {
        {"--gap", set->gap, 0},
        {"--overlap", set->overlap, 0},
        {"--error", set->own_error, 0},
        {set->error > 0 ? "--measured" : "measured", pose_error(a), 1}};
    for (size_t k = 0; k < sizeof length / sizeof *length; k++) {
        const double most = length[k].part ? size / 5 : size;
        if ((double)length[k].value > most)
            return fail(a, 0,
                        "%s takes a length up to %sthe mean size of the "
                        "blocks, %.4g, read %.9g",
                        length[k].name, share[length[k].part], most,
                        (double)length[k].value);
    }
    return 0;
}

/* A support is fixed, and gravity tells what is horizontal. */
static inline int check_thrust(struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    if (thrust_support(a) < 0)
        return fail(a, 0, "--thrust: there is no fixed block '%s'",
                    text_show(shown, a->set->thrust));
    if (fabs((double)a->text.gravity.x) > 0 || !(a->text.gravity.y < 0))
        return fail(a, 0, "--thrust: gravity straight down is expected");
    return 0;
}

/* What is asked about must be in the file. */
static inline int check_asked(struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    const char *stays = a->set->stays;
    int found = 0;
    for (int i = 0; stays && i < a->task.s.blocks; i++)
        found |= is_asked(a, i);
    const int moving = a->text.lives - a->text.spread + a->text.wheels;
    if ((a->set->sweep > 0 && moving == 0)
        || (a->set->mechanism_live && a->text.lives == 0))
        return fail(a, 0,
                    "%s: no live load ('live NAME FX FY X Y', 'axle X FORCE')",
                    a->set->sweep > 0 ? "--sweep" : "--mechanism live");
    if (stays && !found)
        return fail(a, 0, "--stays: there is no free block '%s'",
                    text_show(shown, stays));
    if (stays && !(gravity_of(a) > 0))
        return fail(a, 0, "--stays: there is no gravity");
    return a->set->thrust ? check_thrust(a) : 0;
}

/* Contacts shrink by no more than all of them. */
static inline int check_shrinkage(struct analysis *a, int line,
                                  const char *name, kern_real value)
{
    double most = a->set->relative ? 1 : mean_size(a);
    for (int k = 0; k < a->task.s.contacts && !a->set->relative; k++)
        most = fmax(most, fabs((double)a->task.s.contact[k].travel));
    if (!((double)value > most))
        return 0;
    return fail(a, line,
                "%s takes a %s up to %.4g, at which every contact is "
                "a point, read %.9g",
                name, a->set->relative ? "share (--relative)" : "length", most,
                (double)value);
}

static inline int check_shrinkages(struct analysis *a)
{
    const int own = a->set->epsilon > 0;
    return check_shrinkage(a, 0, "--at", shrinkage(a))
        || check_shrinkage(a, own ? 0 : a->text.epsilon_line,
                           own ? "--epsilon" : "epsilon",
                           a->task.options.epsilon);
}

/* Finds the verdict on what was read. */
static inline int analyse(struct analysis *a)
{
    const struct settings *set = a->set;
    kern_options options;
    a->task = kern_task_of(a->text.block, a->text.blocks, NULL, 0, &a->work);
    a->task.s.gravity = a->text.gravity;
    if (check_lengths(a) || check_asked(a) || check_place(a))
        return -1;
    options = a->text.options;
    options.relative = set->relative;
    if (set->lone)
        options.lone = a->text.gravity;
    if (set->epsilon > 0)
        options.epsilon = set->epsilon;
    if (set->gap > 0)
        options.gap = set->gap;
    if (!(set->mu < 0))
        options.mu = set->mu;
    if (!(set->limit < 0))
        options.limit = (int)set->limit;
    if (pose_error(a) > 0)
        options = kern_measured_options(&options, pose_error(a), pose_turn(a));
    if (set->overlap > options.overlap)
        options.overlap = set->overlap;
    if (decide(a, &options) || check_shrinkages(a))
        return -1;
    a->verdict = a->shown;
    return find_certain(a);
}

#endif /* PROGRAM_ANALYSIS_H */
