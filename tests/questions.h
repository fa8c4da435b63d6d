/* questions.h - what bench.c and work.c ask of a structure, each question a
   function that begins from the caller's data and keeps nothing between calls
   but the plan of a wall that was measured.

   SPDX-License-Identifier: MIT */

#ifndef QUESTIONS_H
#define QUESTIONS_H

#include "peers.h"

#define TOUCHES 32      /* contact points of a candidate                   */
#define TOPS 3          /* stones taken off a wall and tried again         */
#define PLACES_MOST 96  /* candidates on a wall of up to PLACES_SMALL      */
#define PLACES_FEW 24   /* and on a larger one                             */
#define PLACES_SMALL 50 /* [blocks]                                        */
#define SAME 1e-9       /* mean block sizes within which lengths are one   */

/* Places from one end of a wall's top to the other. */
struct site {
    double from, step; /* of the stone's middle                           */
    int places;
    kern_vec corner[4]; /* of the stone                                    */
};

/* A structure, what is asked, and the last answers. */
struct ask {
    struct scene *scene;
    kern_work work;
    kern_task task;
    kern_proof proof;
    double shrink; /* of a verdict                                    */
    kern_status status;
    kern_margin margin; /* of the measure                                  */
    double number;      /* load factor, angle, errors or count             */
    kern_plan plan;     /* of a wall that was measured                     */
    kern_block stone;   /* to be tried on it                               */
    double least;       /* margin that is asked for                        */
    kern_margin with;   /* the stone                                       */
    struct site site;   /* where else stones are tried                     */
    struct program lp;
    const struct peer *peer;
    void *model;         /* NULL: none is open                              */
    int answer;          /* of the peer                                     */
    struct bench *bench; /* of bench.c                                      */
};

typedef void ask_function(struct ask *ask);

static inline void ask_open(struct ask *ask, struct scene *scene)
{
    int reals, ints;
    memset(ask, 0, sizeof *ask);
    ask->scene = scene;
    kern_work_need(scene->blocks + 1, scene->contacts + TOUCHES, &reals, &ints);
    ask->work = kern_work_of(room_for((size_t)reals, sizeof(kern_real)), reals,
                             room_for((size_t)ints, sizeof(int)), ints);
    ask->proof.force = room_for((size_t)scene->contacts, sizeof(kern_force));
    ask->proof.motion = room_for((size_t)scene->blocks, sizeof(kern_motion));
    program_open(&ask->lp, scene);
}

static inline void plan_close(kern_plan *plan)
{
    free(plan->block);
    free(plan->contact);
    free(plan->task.known.motion);
    free(plan->task.known.force);
    memset(plan, 0, sizeof *plan);
}

static inline void ask_close(struct ask *ask)
{
    plan_close(&ask->plan);
    program_close(&ask->lp);
    free(ask->work.real);
    free(ask->work.index);
    free(ask->proof.force);
    free(ask->proof.motion);
}

/* The scene as it is now, and nothing known of it. */
static inline kern_task *task_of(struct ask *ask)
{
    const struct scene *scene = ask->scene;
    ask->task = kern_task_of(scene->block, scene->blocks, scene->contact,
                             scene->contacts, &ask->work);
    ask->task.s.gravity = scene->gravity;
    ask->task.options = scene->options;
    return &ask->task;
}

static inline void run_verdict(struct ask *ask)
{
    ask->status = kern_verdict(task_of(ask), ask->shrink, NULL);
}

static inline void run_measure(struct ask *ask)
{
    ask->status = kern_measure(task_of(ask), &ask->margin, &ask->proof);
}

static inline void run_load(struct ask *ask)
{
    ask->status = kern_load_factor(task_of(ask), 0, KERN_RIGHT, &ask->number,
                                   NULL);
}

static inline void run_tilt(struct ask *ask)
{
    ask->status = kern_tilt(task_of(ask), 0, KERN_RIGHT, &ask->number, NULL);
}

static inline void run_raised(struct ask *ask)
{
    kern_raising raising;
    ask->status = kern_raised(task_of(ask), 0, &raising, &ask->number, NULL);
}

/* The proofs of the last measure. */
static inline void run_floor(struct ask *ask)
{
    const kern_margin *m = &ask->margin;
    ask->number = kern_check_forces(task_of(ask), m->holds, ask->proof.force);
    if (!m->saturated)
        ask->number = fmax(
            ask->number,
            kern_check_motion(task_of(ask), m->fails, ask->proof.motion));
}

/* It finds what is there already. */
static inline void run_contacts(struct ask *ask)
{
    const struct scene *scene = ask->scene;
    ask->number = kern_contacts(scene->block, scene->blocks, &scene->options,
                                scene->contact, scene->room, &ask->work);
}

/* A plan with room for all blocks and one more, without block `but`, -1: with
   all. */
static inline kern_plan plan_open(struct ask *ask, int but)
{
    const struct scene *scene = ask->scene;
    const int blocks = scene->blocks + 1, contacts = scene->contacts + TOUCHES;
    kern_plan plan = kern_plan_of(
        room_for((size_t)blocks, sizeof(kern_block)), blocks,
        room_for((size_t)contacts, sizeof(kern_contact)), contacts,
        kern_known_of(room_for((size_t)blocks, sizeof(kern_motion)),
                      room_for((size_t)contacts, sizeof(kern_force))),
        &ask->work);
    int i;
    plan.task.options = scene->options;
    plan.task.s.gravity = scene->gravity;
    for (i = 0; i < scene->blocks; i++)
        if (i != but)
            kern_plan_add(&plan, &scene->block[i]);
    return plan;
}

/* Takes a stone off and measures what is left, for the stone to be tried again
   where it was. Returns what the measure said. */
static inline kern_status take_off(struct ask *ask, int block)
{
    plan_close(&ask->plan);
    ask->plan = plan_open(ask, block);
    ask->stone = ask->scene->block[block];
    return kern_measure(&ask->plan.task, &ask->with, NULL);
}

static inline void run_try(struct ask *ask)
{
    ask->status = kern_plan_try(&ask->plan, &ask->stone, &ask->with, NULL);
}

static inline void run_bears(struct ask *ask)
{
    ask->status = kern_plan_bears(&ask->plan, &ask->stone, ask->least, NULL);
}

/* ---- Stones on top of a made wall ---------------------------------------- */

/* A plan of the wall, and places from one end of its top to the other, where
   the stone's middle is within its own half length of the wall. The upper face
   of a brick is its last edge but one. */
static inline int site_open(struct ask *ask)
{
    struct scene *scene = ask->scene;
    struct site *site = &ask->site;
    const int most = scene->blocks <= PLACES_SMALL + 1 ? PLACES_MOST
                                                       : PLACES_FEW;
    double low = INFINITY, high = -INFINITY;
    int i;
    for (i = 0; i < scene->blocks; i++)
        if (!scene->block[i].fixed) {
            const kern_block *b = &scene->block[i];
            low = fmin(low, b->vertex[b->vertices - 1].x - 0.4 * LENGTH);
            high = fmax(high, b->vertex[b->vertices - 2].x + 0.4 * LENGTH);
        }
    site->step = fmax(LENGTH / 4, (high - low) / most);
    site->from = low + site->step * scene_random(scene, 0, 1);
    site->places = (int)ceil((high - site->from) / site->step);
    ask->least = ask->margin.margin * scene_random(scene, 0.5, 1);
    plan_close(&ask->plan);
    ask->plan = plan_open(ask, -1);
    kern_measure(&ask->plan.task, &ask->with, NULL);
    return site->places;
}

/* Lays the stone, a brick, from above on the face that is highest under it;
   where several are, on the nearest. */
static inline void site_lay(struct ask *ask, int place)
{
    struct site *site = &ask->site;
    const double x = site->from + place * site->step, half = 0.4 * LENGTH;
    double best_y = -INFINITY, best_away = INFINITY;
    kern_vec *v = site->corner, u = vec(1, 0), middle = vec(x, 0);
    int i;
    for (i = 0; i < ask->scene->blocks; i++) {
        const kern_block *b = &ask->scene->block[i];
        const kern_vec left = b->vertex[b->vertices - 1];
        const kern_vec right = b->vertex[b->vertices - 2];
        const double from = fmax(left.x, x - half);
        const double to = fmin(right.x, x + half);
        const double slope = (right.y - left.y) / (right.x - left.x);
        const double y = left.y
                       + fmax(slope * (from - left.x), slope * (to - left.x));
        const double away = fmax(fmax(left.x - x, x - right.x), 0);
        if (b->fixed || from >= to || y < best_y - SAME
            || (y < best_y + SAME && away >= best_away))
            continue;
        best_y = y;
        best_away = away;
        middle.y = left.y + slope * (x - left.x);
        u = vec(1 / hypot(1, slope), slope / hypot(1, slope));
    }
    v[0] = vec(x - half * u.x, middle.y - half * u.y);
    v[1] = vec(x + half * u.x, middle.y + half * u.y);
    v[2] = vec(v[1].x - 0.5 * LENGTH * u.y, v[1].y + 0.5 * LENGTH * u.x);
    v[3] = vec(v[0].x - 0.5 * LENGTH * u.y, v[0].y + 0.5 * LENGTH * u.x);
    kern_block_init(&ask->stone, v, 4, DENSITY, NULL);
}

/* ---- The peers ----------------------------------------------------------- */

static inline void close_lp(struct ask *ask)
{
    if (ask->model)
        ask->peer->close(ask->model);
    ask->model = NULL;
}

static inline void open_lp(struct ask *ask)
{
    close_lp(ask);
    program_shrink(&ask->lp, ask->shrink);
    ask->model = ask->peer->open(&ask->lp);
}

static inline void run_lp(struct ask *ask)
{
    ask->answer = ask->peer->solve(ask->model);
}

#endif
