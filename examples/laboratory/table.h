/* table.h - a table that shakes structures, for the example programs.

   table_load() puts a structure of the text format on the table, table_shake()
   shakes it at one level, table_collapse() at all of them, from the structure
   as it was built. The table moves along a figure of eight; the displacement
   scores of the stones and their mean are Eqs. (6) and (7) of the paper.

   The same plan gives the same bits. Programs are linked with -lm.

   SPDX-License-Identifier: MIT */

#ifndef TABLE_H
#define TABLE_H

#include "../../kern.h"
#include "../parts/random.h"
#include "rigid.h"
#include "../parts/text.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

/* ---- The scene and its numbers: lengths in stones, g is 9.81 ------------- */

static const double table_gravity = 9.81;
static const double table_pi = 3.14159265358979323846;
static const double table_frequency = 0.7;    /* of the table, 1/s */
static const double table_amplitude = 0.02;   /* of a level, over 3 - cos 2wt */
static const double table_turn_weight = 0.25; /* of a squared turn in a score */
static const double table_threshold = 0.25;   /* of the mean score: collapse */
static const double table_noise = 1e-4;       /* of each place and angle */
static const double table_stop_height = 0.3; /* of the side stops on the base */
static const double table_stop_thick = 0.3;  /* of each */
static const double table_stop_clear = 0.5; /* between them and the structure */
static const double table_ground_below = 0.25; /* the base */

/* The shaking: rest, swelling, full strength, fading, and rest until nothing
   moves any more. The end of each, in seconds. */
static const double table_rest_ends = 0.5, table_swell_ends = 1.5,
                    table_full_ends = 7.5, table_fade_ends = 8.5,
                    table_last_end = 10.5;
static const double table_still = 2e-3;  /* speed of a stone at rest       */
static const int table_look_every = 24;  /* steps, whether all do */
static const int table_frame_every = 12; /* steps, of a film */

struct table;

/* What to do. */
struct table_plan {
    int first, last; /* levels                                  */
    int repeat;      /* times, each with other noise            */
    double unit;     /* length of a stone, in that of the file  */
    uint64_t seed;   /* of the noise                            */
    /* called before each level, if not NULL, where someone may wait   */
    void (*progress)(const struct table *t, int repetition, int level);
};

struct table_pose {
    double x, y, angle;
};

/* A structure on the table. Pose 0 is the base, pose i + 1 stone i. */
struct table {
    struct table_plan plan;
    const char *file;
    struct text_file text;
    struct rigid_world world;
    int stones;
    int *block;               /* of the world, for each pose             */
    int *source;              /* block of the text, for each stone       */
    struct table_pose *home;  /* as in the file            */
    struct table_pose *begin; /* with the noise            */
    double left, right, bottom, top; /* of base and structure     */
    struct rigid_pt stop[2];         /* upper inner corners       */
};

/* Poses of a film, frame after frame. */
struct table_film {
    struct table_pose *pose;
    int frames, room; /* in frames                               */
};

/* What shaking said, over all repetitions. */
struct table_report {
    double *ads;            /* mean score, one a level                 */
    double *first;          /* mean first level of each stone          */
    double level, level_sd; /* of collapse                             */
    int shown;              /* level of collapse of repetition 0       */
    double seconds;
};

/* ---- Noise --------------------------------------------------------------- */

static inline double table_uniform(uint64_t *state)
{
    return random_share(random_mixed(state));
}

/* Near enough to a normal distribution, and without a logarithm, which not
   every machine rounds alike. */
static inline double table_normal(uint64_t *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++)
        sum += table_uniform(state);
    return sum;
}

/* ---- Building ------------------------------------------------------------ */

static inline int table_fail(struct table *t, const char *message)
{
    snprintf(t->text.message, sizeof t->text.message, "%s", message);
    t->text.line = 0;
    return -1;
}

/* A point of the file, in stones. */
static inline struct rigid_pt table_scaled(const struct table *t, kern_vec p)
{
    double unit = t->plan.unit;
    return rigid_vec((double)p.x / unit, (double)p.y / unit);
}

/* Adds block i of the text; with `more` it becomes part of the last one. */
static inline int table_add_block(struct table *t, int i, int more)
{
    const kern_block *b = &t->text.block[i];
    struct rigid_pt *v = malloc((size_t)b->vertices * sizeof *v);
    int index = -1;
    if (!v)
        return -1;
    for (int k = 0; k < b->vertices; k++) {
        v[k] = table_scaled(t, b->vertex[k]);
        t->left = fmin(t->left, v[k].x);
        t->right = fmax(t->right, v[k].x);
        t->bottom = fmin(t->bottom, v[k].y);
        t->top = fmax(t->top, v[k].y);
    }
    index = rigid_add_part(&t->world, v, b->vertices,
                           b->fixed ? 0 : (double)b->mass,
                           table_scaled(t, b->centre), more);
    free(v);
    return index;
}

/* Adds a rectangle that is part of the last block, or a block of its own. */
static inline int table_add_box(struct table *t, double left, double bottom,
                                double right, double top, int more)
{
    struct rigid_pt v[4] = {
        {left, bottom}, {right, bottom}, {right, top}, {left, top}};
    return rigid_add_part(&t->world, v, 4, 0, v[0], more);
}

/* Where the base ends on one side (-1 left, 1 right), and its height there. */
static inline struct rigid_pt table_base_end(const struct table *t, int side)
{
    struct rigid_pt end = {0, 0};
    double most = -HUGE_VAL;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        double reach = -HUGE_VAL, top = -HUGE_VAL;
        if (!b->fixed)
            continue;
        for (int k = 0; k < b->vertices; k++) {
            struct rigid_pt p = table_scaled(t, b->vertex[k]);
            reach = fmax(reach, side * p.x);
            top = fmax(top, p.y);
        }
        if (reach > most) {
            most = reach;
            end = rigid_vec(side * reach, top);
        }
    }
    return end;
}

/* The table: all that is fixed, with a stop at either side so that stones do
   not roll off, and the ground beneath. */
static inline int table_add_base(struct table *t, double left, double right)
{
    const double thick = table_stop_thick, deep = 2, wide = 200;
    int base = -1;
    for (int i = 0; i < t->text.blocks; i++)
        if (t->text.block[i].fixed) {
            base = table_add_block(t, i, base >= 0);
            if (base < 0)
                return -1;
        }
    t->stop[0] = table_base_end(t, -1);
    t->stop[1] = table_base_end(t, 1);
    t->stop[0].x = fmin(t->stop[0].x, left - table_stop_clear);
    t->stop[1].x = fmax(t->stop[1].x, right + table_stop_clear);
    t->stop[0].y += table_stop_height;
    t->stop[1].y += table_stop_height;
    t->left = fmin(t->left, t->stop[0].x) - thick;
    t->right = fmax(t->right, t->stop[1].x) + thick;
    t->top = fmax(t->top, fmax(t->stop[0].y, t->stop[1].y));
    if (table_add_box(t, t->stop[0].x - thick, t->bottom, t->stop[0].x,
                      t->stop[0].y, 1)
            < 0
        || table_add_box(t, t->stop[1].x, t->bottom, t->stop[1].x + thick,
                         t->stop[1].y, 1)
               < 0)
        return -1;
    t->block[0] = base;
    t->bottom -= table_ground_below;
    return table_add_box(t, t->left - wide, t->bottom - deep, t->right + wide,
                         t->bottom, 0)
                 < 0
             ? -1
             : 0;
}

/* Loads keep their ratio to the weights: g becomes 9.81, a stone 1. */
static inline int table_add_stones(struct table *t, double strength)
{
    double pull = table_gravity / strength;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        struct rigid_block *r;
        int index;
        if (b->fixed)
            continue;
        index = table_add_block(t, i, 0);
        if (index < 0)
            return -1;
        r = &t->world.block[index];
        r->force = rigid_vec((double)b->load.fx * pull,
                             (double)b->load.fy * pull);
        r->torque = (double)b->load.torque * pull / t->plan.unit;
        t->source[t->stones] = i;
        t->block[++t->stones] = index;
    }
    return 0;
}

static inline int table_make_room(struct table *t)
{
    size_t poses = (size_t)t->text.blocks + 1;
    t->block = calloc(poses, sizeof *t->block);
    t->source = calloc(poses, sizeof *t->source);
    t->home = calloc(poses, sizeof *t->home);
    t->begin = calloc(poses, sizeof *t->begin);
    return t->block && t->source && t->home && t->begin ? 0 : -1;
}

/* The leftmost and rightmost corner of the stones. */
static inline void table_sides(const struct table *t, double *left,
                               double *right)
{
    *left = HUGE_VAL;
    *right = -HUGE_VAL;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        for (int k = 0; k < b->vertices && !b->fixed; k++) {
            *left = fmin(*left, table_scaled(t, b->vertex[k]).x);
            *right = fmax(*right, table_scaled(t, b->vertex[k]).x);
        }
    }
}

/* Reads a file and builds the scene. Returns 0, or -1 with a message. */
static inline int table_load(struct table *t)
{
    const struct text_file *s = &t->text;
    double left, right, gx, gy, strength;
    if (text_load(&t->text, t->file))
        return -1;
    gx = (double)s->gravity.x;
    gy = (double)s->gravity.y;
    strength = rigid_length(rigid_vec(gx, gy));
    if (s->given)
        return table_fail(t, "its contacts are given; stones that move find "
                             "their own");
    if (s->fixed == 0)
        return table_fail(t, "nothing is fixed that could shake it");
    if (!(strength > 0))
        return table_fail(t, "there is no gravity");
    if (table_make_room(t))
        return table_fail(t, "not enough memory to shake it");

    rigid_init(&t->world);
    t->world.friction = (double)s->options.mu;
    t->world.gravity = rigid_vec(gx / strength * table_gravity,
                                 gy / strength * table_gravity);
    t->left = t->bottom = HUGE_VAL;
    t->right = t->top = -HUGE_VAL;
    table_sides(t, &left, &right);
    if (table_add_base(t, left, right) || table_add_stones(t, strength))
        return table_fail(t, "not enough memory to shake it");
    for (int i = 0; i <= t->stones; i++) {
        struct rigid_pt at = t->world.block[t->block[i]].at;
        t->home[i].x = at.x;
        t->home[i].y = at.y;
    }
    return 0;
}

static inline void table_free(struct table *t)
{
    text_free(&t->text);
    rigid_free(&t->world);
    free(t->block);
    free(t->source);
    free(t->home);
    free(t->begin);
}

/* ---- Shaking ------------------------------------------------------------- */

/* How strong the shaking is at a time. */
static inline double table_strength(double time)
{
    if (time < table_rest_ends || time > table_fade_ends)
        return 0;
    if (time < table_swell_ends)
        return (time - table_rest_ends) / (table_swell_ends - table_rest_ends);
    if (time < table_full_ends)
        return 1;
    return (table_fade_ends - time) / (table_fade_ends - table_full_ends);
}

/* The table runs x = s cos a, y = s/2 sin 2a, s = scale / (3 - cos 2a), here
   with the cosine and sine of a as q. */
static inline struct rigid_pt table_eight(struct rigid_pt q, double scale)
{
    double cos2 = q.x * q.x - q.y * q.y, sin2 = 2 * q.x * q.y;
    double s = scale / (3 - cos2);
    return rigid_vec(s * q.x, s / 2 * sin2);
}

static inline struct table_pose table_pose_of(const struct table *t, int i)
{
    const struct rigid_block *b = &t->world.block[t->block[i]];
    struct table_pose p = {b->at.x, b->at.y, b->angle};
    return p;
}

/* Puts everything back, the stones with a little noise. */
static inline void table_reset(struct table *t, uint64_t *state)
{
    for (int i = 0; i <= t->stones; i++) {
        struct table_pose *p = &t->begin[i];
        *p = t->home[i];
        if (i > 0) {
            p->x += table_noise * table_normal(state);
            p->y += table_noise * table_normal(state);
            p->angle += table_noise * table_normal(state);
        }
        rigid_put(&t->world, t->block[i], rigid_vec(p->x, p->y), p->angle);
    }
}

static inline int table_all_still(const struct table *t)
{
    for (int i = 1; i <= t->stones; i++) {
        const struct rigid_block *b = &t->world.block[t->block[i]];
        if (!(fabs(b->v.x) + fabs(b->v.y) + fabs(b->spin) < table_still))
            return 0;
    }
    return 1;
}

static inline int table_film_add(struct table_film *f, const struct table *t)
{
    size_t poses = (size_t)t->stones + 1;
    struct table_pose *more = rigid_room(f->pose, f->frames, 1, &f->room,
                                         poses * sizeof *more);
    if (!more)
        return -1;
    f->pose = more;
    for (int i = 0; i <= t->stones; i++)
        f->pose[(size_t)f->frames * poses + (size_t)i] = table_pose_of(t, i);
    f->frames++;
    return 0;
}

/* Shakes at one level. The table is driven by its speed, so that it is at each
   place at the end of a step. Returns -1 where memory is lacking. */
static inline int table_shake(struct table *t, int level, int repetition,
                              struct table_film *film)
{
    struct rigid_world *w = &t->world;
    double dt = w->step;
    uint64_t state = t->plan.seed * 1000003 + (uint64_t)repetition;
    state = random_mixed(&state) + (uint64_t)level;
    table_reset(t, &state);
    struct rigid_block *base = &w->block[t->block[0]];
    struct rigid_pt q = rigid_unit(2 * table_pi * table_uniform(&state));
    struct rigid_pt on = rigid_unit(2 * table_pi * table_frequency * dt);
    int steps = (int)(table_last_end / dt + 0.5);
    for (int i = 1; i <= steps; i++) {
        double time = i * dt, strength = table_strength(time);
        struct rigid_pt p = table_eight(q, table_amplitude * level * strength);
        if (film && i % table_frame_every == 1 && table_film_add(film, t))
            return -1;
        if (time > table_fade_ends && i % table_look_every == 0
            && table_all_still(t))
            break;
        base->v.x = (t->home[0].x + p.x - base->at.x) / dt;
        base->v.y = (t->home[0].y + p.y - base->at.y) / dt;
        if (rigid_step(w))
            return -1;
        q = rigid_turned(q, on);
    }
    return film ? table_film_add(film, t) : 0;
}

/* The displacement score of a stone: its way on the base, and its turn. */
static inline double table_score(const struct table *t, int stone)
{
    struct table_pose base = table_pose_of(t, 0);
    struct table_pose p = table_pose_of(t, stone + 1);
    const struct table_pose *b = &t->begin[0], *o = &t->begin[stone + 1];
    double x = (p.x - base.x) - (o->x - b->x);
    double y = (p.y - base.y) - (o->y - b->y), turn = p.angle - o->angle;
    return sqrt(x * x + y * y + table_turn_weight * turn * turn);
}

static inline double table_mean_score(const struct table *t)
{
    double sum = 0;
    for (int i = 0; i < t->stones; i++)
        sum += table_score(t, i);
    return sum / t->stones;
}

/* ---- All levels ---------------------------------------------------------- */

/* Shakes at all levels once. `first` takes the first level after which each
   stone is displaced, `level` that of collapse; one more than the last where
   there is none. */
static inline int table_repeat(struct table *t, int repetition,
                               struct table_report *r, int *first, int *level)
{
    const struct table_plan *set = &t->plan;
    *level = set->last + 1;
    for (int i = 0; i < t->stones; i++)
        first[i] = set->last + 1;
    for (int l = set->first; l <= set->last; l++) {
        double ads;
        if (set->progress)
            set->progress(t, repetition, l);
        if (table_shake(t, l, repetition, NULL))
            return -1;
        ads = table_mean_score(t);
        r->ads[l - set->first] += ads / set->repeat;
        if (ads > table_threshold && l < *level)
            *level = l;
        for (int i = 0; i < t->stones; i++)
            if (table_score(t, i) > table_threshold && l < first[i])
                first[i] = l;
    }
    return 0;
}

/* All repetitions. The arrays of the report are the caller's to free. */
static inline int table_collapse(struct table *t, struct table_report *r)
{
    const struct table_plan *set = &t->plan;
    clock_t start = clock();
    double sum = 0, squares = 0;
    int *first = calloc((size_t)t->stones, sizeof *first), bad = 0;
    r->ads = calloc((size_t)(set->last - set->first + 1), sizeof *r->ads);
    r->first = calloc((size_t)t->stones, sizeof *r->first);
    bad = !first || !r->ads || !r->first;
    for (int k = 0; k < set->repeat && !bad; k++) {
        int level;
        bad = table_repeat(t, k, r, first, &level);
        if (bad)
            break;
        if (k == 0)
            r->shown = level > set->last ? set->last : level;
        sum += level;
        squares += (double)level * level;
        for (int i = 0; i < t->stones; i++)
            r->first[i] += (double)first[i] / set->repeat;
    }
    free(first);
    r->level = sum / set->repeat;
    if (set->repeat > 1)
        r->level_sd = sqrt(fmax(0, squares - sum * r->level)
                           / (set->repeat - 1));
    r->seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    return bad ? table_fail(t, "not enough memory to shake it") : 0;
}

enum { TABLE_LEVELS = 20 };

/* The level of collapse of the structure in a file, shaken once at each level
   of TABLE_LEVELS up to that, in its `unit` of length. Says what is wrong on
   stderr. */
static inline int table_once(const char *program, const char *path, double unit,
                             double *level)
{
    static const struct table empty;
    struct table t = empty;
    int bad, at = 0;
    t.plan.unit = unit;
    t.plan.seed = 1;
    t.file = path;
    bad = table_load(&t);
    while (!bad && ++at <= TABLE_LEVELS) {
        if (table_shake(&t, at, 0, NULL))
            bad = table_fail(&t, "not enough memory to shake it");
        else if (table_mean_score(&t) > table_threshold)
            break;
    }
    if (bad)
        fprintf(stderr, "%s: %s: %s\n", program, path, t.text.message);
    *level = at;
    table_free(&t);
    return bad;
}

#endif /* TABLE_H */
