/* place.h - where one more stone comes to rest on the structure, and which of
   these places is best.

   The stone of a file is let down in every turn at places a quarter of its size
   apart. Where the structure stands with it, the place is ranked as by
   kern_place_compare(); places at which it comes to the same rest count once,
   and those in fill or in earth not at all.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_PLACE_H
#define PROGRAM_PLACE_H

#include "../../kern.h"

#include "../parts/draw.h"
#include "../parts/json.h"
#include "../parts/room.h"
#include "../parts/text.h"
#include "asked.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Most places along the structure, and the turns and best places by default. */
enum { PLACE_COLUMNS = 1000, PLACE_TURNS = 8, PLACE_BEST = 5 };

/* What is needed while places are sought. */
struct placing {
    const kern_block *stone;
    kern_plan plan;
    kern_work work;
    kern_margin alone;
    kern_real *value; /* of each block: its margin in the profile   */
    int turns, most;  /* how many turns; how many places are kept   */
};

/* Reads the stone, if one is asked for. */
static inline int check_place(struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    const char *path = a->set->place;
    if (!path)
        return 0;
    if (text_load(&a->stone, path))
        return fail(a, 0, "--place: %s: %s", text_show(shown, path),
                    a->stone.message);
    if (a->stone.blocks != 1 || a->stone.fixed)
        return fail(a, 0, "--place: %s: not one free block",
                    text_show(shown, path));
    if (a->text.given)
        return fail(a, 0, "--place: contacts are given, so none are found");
    return 0;
}

/* Makes a plan of the structure with room for the stone. Returns 1 if it
   stands. */
static inline int place_plan(const struct analysis *a, struct placing *p)
{
    const int blocks = a->text.blocks + 1;
    p->plan = room_plan(blocks,
                        64 * blocks + 64
                            + 8 * (a->task.s.contacts + p->stone->vertices),
                        &p->work);
    p->value = array(blocks, sizeof *p->value);
    if (!room_is_there(&p->plan) || !p->value)
        return 0;
    p->plan.task.options = a->task.options;
    if (a->task.options.limit < kern_defaults().limit)
        p->plan.task.options.limit = 0; /* a short one is for questions */
    p->plan.task.s.gravity = a->text.gravity;
    for (int i = 0; i < a->text.blocks; i++)
        if (kern_plan_add(&p->plan, &a->text.block[i]) < 0)
            return 0;
    p->plan.task.options.limit = a->task.options.limit;
    return kern_measure(&p->plan.task, &p->alone, NULL) == KERN_STANDS;
}

/* Returns how far the structure reaches to the side of the earth, beside the
   stone; above all blocks, at any height. */
static inline double place_back(const struct text_file *t, enum soil_side side,
                                const kern_block *stone)
{
    double beside = -HUGE_VAL, all = -HUGE_VAL;
    for (int i = 0; i < t->blocks; i++) {
        const kern_box *box = &t->block[i].box;
        const double out = fmax(soil_height(side, box->low),
                                soil_height(side, box->high));
        if (t->block[i].fixed)
            continue;
        all = fmax(all, out);
        if (box->high.y > stone->box.low.y && box->low.y < stone->box.high.y)
            beside = fmax(beside, out);
    }
    return beside > -HUGE_VAL ? beside : all;
}

/* Returns 1 if the stone lies in fill, or in the earth behind the structure. */
static inline int place_buried(const struct text_file *t,
                               const kern_block *stone)
{
    const double little = 1e-3 * sqrt(fabs((double)stone->area));
    const kern_box *box = &stone->box;
    int buried = 0;
    for (int i = 0; i < t->soils && !buried; i++) {
        const struct text_soil *s = &t->soil[i];
        if (s->kind == TEXT_PROP || (double)box->low.y > s->earth.top - little)
            continue;
        buried = s->kind == TEXT_FILL
                   ? (double)box->high.x > s->from + little
                         && (double)box->low.x < s->to - little
                   : fmax(soil_height(s->side, box->low),
                          soil_height(s->side, box->high))
                         > place_back(t, s->side, stone) + little;
    }
    return buried;
}

/* Returns 1 if the structure stands with the stone, and what that is worth: -1
   for its own margin and the load where the limit of work ends them. */
static inline int place_rank(struct placing *p, const kern_block *stone,
                             kern_place *rank)
{
    kern_task *const task = &p->plan.task;
    kern_collapse all;
    kern_margin m;
    kern_real side[2] = {0, 0};
    int stands = kern_plan_try(&p->plan, stone, &m, NULL) == KERN_STANDS
              && kern_plan_add(&p->plan, stone) >= 0;
    if (!stands)
        return 0;
    rank->margin = m.margin;
    rank->own = rank->load = -1;
    if (kern_stays(task, task->s.blocks - 1, &rank->stays) != KERN_STANDS)
        rank->stays = 0;
    if (kern_profile(task, KERN_SHRINK, p->value, &all) >= 0)
        rank->own = p->value[task->s.blocks - 1];
    if (kern_load_factor(task, 0, KERN_LEFT, &side[0], NULL) == KERN_STANDS
        && kern_load_factor(task, 0, KERN_RIGHT, &side[1], NULL) == KERN_STANDS)
        rank->load = side[0] < side[1] ? side[0] : side[1];
    kern_plan_remove(&p->plan, task->s.blocks - 1);
    return 1;
}

/* Returns 1 if the stone rests in the same pose, but for a thousandth. */
static inline int place_same(const struct placed *at, const kern_pose *pose)
{
    const double size = 1e-3 * sqrt(fabs((double)pose->block.area));
    const kern_vec *v = at->vertex, *w = pose->block.vertex;
    const int n = pose->block.vertices;
    int first = 0, same = 0;
    for (; first < n && !same; first++) {
        same = 1;
        for (int i = 0; i < n && same; i++) {
            const kern_vec *to = w + (i + first) % n;
            same = fabs((double)(v[i].x - to->x)) < size
                && fabs((double)(v[i].y - to->y)) < size;
        }
    }
    return same;
}

/* Keeps a place among the best, which are in order. One that is in the same
   pose as a better one is none. */
static inline void place_keep(struct analysis *a, const struct placing *p,
                              const kern_pose *pose, const kern_place *rank)
{
    struct placed *of = a->placed, last;
    int i = a->places;
    for (int k = 0; k < a->places; k++)
        if (place_same(&of[k], pose)) {
            if (kern_place_compare(rank, &of[k].rank, p->alone.margin) <= 0)
                return;
            last = of[k];
            memmove(&of[k], &of[k + 1],
                    sizeof *of * (size_t)(a->places - 1 - k));
            of[--a->places] = last;
            i = a->places;
            break;
        }
    if (a->places == p->most) {
        if (kern_place_compare(rank, &of[p->most - 1].rank, p->alone.margin)
            <= 0)
            return;
        i = --a->places;
    }
    last = of[i]; /* its vertices are written over */
    for (; i > 0
           && kern_place_compare(rank, &of[i - 1].rank, p->alone.margin) > 0;
         i--)
        of[i] = of[i - 1];
    last.rank = *rank;
    memcpy(last.vertex, pose->block.vertex,
           sizeof *last.vertex * (size_t)pose->block.vertices);
    of[i] = last;
    a->places++;
}

/* Lets the stone down everywhere. */
static inline void place_everywhere(struct analysis *a, struct placing *p,
                                    kern_vec *vertex)
{
    const double pi = 3.14159265358979323846;
    const double size = sqrt(fabs((double)p->stone->area));
    double low = HUGE_VAL, high = -HUGE_VAL;
    for (int i = 0; i < a->text.blocks; i++)
        if (!a->text.block[i].fixed) {
            low = fmin(low, (double)a->text.block[i].box.low.x - size);
            high = fmax(high, (double)a->text.block[i].box.high.x + size);
        }
    const double columns = fmin(ceil((high - low) / (size / 4)), PLACE_COLUMNS);
    for (int turn = 0; turn < p->turns; turn++)
        for (int i = 0; i < (int)columns; i++) {
            const double angle = 2 * pi * turn / p->turns;
            const double x = low + (high - low) * (i + 0.5) / columns;
            const kern_vec by = {(kern_real)cos(angle), (kern_real)sin(angle)};
            kern_place rank = {0, 0, 0, 0, (kern_real)x, (kern_real)angle};
            kern_pose pose;
            if (kern_rest(&p->plan.task, p->stone, rank.x, by, vertex, &pose)
                    == KERN_OK
                && !place_buried(&a->text, &pose.block)
                && place_rank(p, &pose.block, &rank))
                place_keep(a, p, &pose, &rank);
        }
}

/* Puts the vertices of all places into one array, in their order. */
static inline int place_sort(struct analysis *a)
{
    const int n = a->place_vertices;
    kern_vec *sorted = array(a->places * n + 1, sizeof *sorted);
    if (!sorted)
        return fail_memory(a);
    for (int i = 0; i < a->places; i++) {
        memcpy(sorted + i * n, a->placed[i].vertex, sizeof *sorted * (size_t)n);
        a->placed[i].vertex = sorted + i * n;
    }
    free(a->place_vertex);
    a->place_vertex = sorted;
    return 0;
}

/* Finds the best places: none where the structure falls. */
static inline int find_places(struct analysis *a)
{
    struct placing p = {0};
    kern_vec *vertex = NULL;
    p.turns = a->set->turns < 0 ? PLACE_TURNS : (int)a->set->turns;
    p.most = a->set->most < 0 ? PLACE_BEST : (int)a->set->most;
    p.stone = a->stone.block;
    const int n = p.stone->vertices;
    a->placed = array(p.most + 1, sizeof *a->placed);
    a->place_vertex = array((p.most + 2) * n, sizeof *vertex);
    a->place_vertices = n;
    if (!a->placed || !a->place_vertex)
        return fail_memory(a);
    vertex = a->place_vertex + (p.most + 1) * n;
    for (int i = 0; i <= p.most; i++)
        a->placed[i].vertex = a->place_vertex + i * n;
    if (place_plan(a, &p))
        place_everywhere(a, &p, vertex);
    room_free_plan(&p.plan);
    free(p.value);
    return place_sort(a);
}

/* ---- what is written ---- */

/* Prints a number of a place, or that the limit of work ended it. */
static inline void report_place(kern_real value)
{
    if (value < 0)
        printf(" %11s", "none");
    else
        printf(" %11.4g", (double)value);
}

static inline void report_places(const struct analysis *a)
{
    printf("  places      %11s %11s %11s %11s %11s %11s\n", "x", "turn",
           "stays", "margin", "own margin", "load");
    for (int i = 0; i < a->places; i++) {
        const kern_place *r = &a->placed[i].rank;
        printf("              %11.4g %11.4g %11.3f %11.4g", (double)r->x,
               (double)r->turn, (double)r->stays, (double)r->margin);
        report_place(r->own);
        report_place(r->load);
        printf("\n");
    }
    if (!a->places)
        printf("              the structure stands with the stone nowhere\n");
}

/* Writes a number of a place, null where the limit of work ended it. */
static inline void json_place(const char *key, kern_real value)
{
    json_number(key, value < 0 ? HUGE_VAL : (double)value);
}

static inline void json_places(const struct analysis *a)
{
    printf(", \"places\": [");
    for (int i = 0; i < a->places; i++) {
        const struct placed *at = &a->placed[i];
        printf("%s{\"polygon\": [", i ? ", " : "");
        for (int k = 0; k < a->place_vertices; k++) {
            printf("%s[", k ? ", " : "");
            json_value((double)at->vertex[k].x);
            printf(", ");
            json_value((double)at->vertex[k].y);
            printf("]");
        }
        printf("]");
        json_number("x", (double)at->rank.x);
        json_number("turn", (double)at->rank.turn);
        printf(", \"stands\": true");
        json_number("stays", (double)at->rank.stays);
        json_number("margin", (double)at->rank.margin);
        json_place("own_margin", at->rank.own);
        json_place("load", at->rank.load);
        printf("}");
    }
    printf("]");
}

/* The best place is filled, others are outlines. */
static inline void draw_places(const struct draw_view *view, const void *data)
{
    const struct analysis *a = data;
    for (int i = a->places - 1; i >= 0; i--) {
        kern_block stone;
        if (kern_ground_init(&stone, a->placed[i].vertex, a->place_vertices,
                             NULL)
            == KERN_OK)
            draw_block(view, &stone, NULL, 0,
                       i ? "fill=\"none\" stroke=\"" DRAW_GHOST "\""
                         : "fill=\"" DRAW_WHOLE "\" stroke=\"" DRAW_GHOST "\"");
    }
}

#endif /* PROGRAM_PLACE_H */
