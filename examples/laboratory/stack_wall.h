/* stack_wall.h - a wall of irregular stones under construction: options of the
   planner of stack.h, the wall, what it is worth, the features of a stone in
   place, output.

   Lengths are those of the stock; thresholds are in stones, so they have no
   unit.

   SPDX-License-Identifier: MIT */

#ifndef STACK_WALL_H
#define STACK_WALL_H

#include "../../kern.h"
#include "../parts/draw.h"
#include "../parts/room.h"
#include "masonry.h"
#include "stones.h"

#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define STACK_API static __attribute__((unused))
#else
#define STACK_API static
#endif

/* ---- Options ------------------------------------------------------------- */

#define STACK_FILTER_LIST(X)                                             \
    X(EDGES, "edges", 0.20, "common edges / perimeter")                  \
    X(HOLE, "hole", 0.25, "area of the hole below / area of the stone")  \
    X(NEIGHBOURS, "neighbours", 0.04, "height of the neighbours / size") \
    X(SLOPE, "slope", 0.03, "slope of the top, as a tangent")            \
    X(BOND, "bond", 0.30, "distance to the joints below / size")

enum stack_filter {
#define STACK_FILTER_ID(id, name, threshold, words) STACK_##id,
    STACK_FILTER_LIST(STACK_FILTER_ID)
#undef STACK_FILTER_ID
        STACK_FILTERS
};

static const char *const stack_filter_name[] = {
#define STACK_FILTER_NAME(id, name, threshold, words) name,
    STACK_FILTER_LIST(STACK_FILTER_NAME)
#undef STACK_FILTER_NAME
};

static const double stack_threshold[] = {
#define STACK_FILTER_THRESHOLD(id, name, threshold, words) threshold,
    STACK_FILTER_LIST(STACK_FILTER_THRESHOLD)
#undef STACK_FILTER_THRESHOLD
};

enum stack_planner {
    STACK_HEURISTIC,
    STACK_COMBINED,
    STACK_BEST,
    STACK_PLANNERS
};

static const char *const stack_planner_name[] = {"heuristic", "combined",
                                                 "best"};

/* What `best` wants to be high beside the filling: the level of collapse that
   the expected drop predicts, or the load factor. */
enum stack_goal { STACK_DROP, STACK_LOAD, STACK_GOALS };

static const char *const stack_goal_name[] = {"drop", "load"};

struct stack_wall;

/* As how many candidates it takes to ask whether the wall stands with one, and
   whether it stays; and how many stones of the stock may be the next one, if
   nothing else is asked for. */
enum { STACK_ASKING = 2, STACK_HOLDING = 20, STACK_LOOK = 6 };

struct stack_options {
    enum stack_planner planner;
    double width, height; /* of the frame, whose lower left is 0, 0     */
    int most;             /* stones that are laid at the most           */
    int look;             /* stones of the stock that may be the next   */
    double threshold[STACK_FILTERS];
    int levels;   /* filters before that by kern's levels       */
    double dress; /* share of its area that a stone may lose at its top */
    double friction;
    double joints;        /* friction in head joints; < 0: the same     */
    uint64_t seed;        /* of what `best` leaves to chance            */
    int walls;            /* that `best` builds                         */
    int effort;           /* no further wall is begun beyond, in candidates,
                               see stack_spent(); 0: no limit             */
    enum stack_goal goal; /* what it wants to be high                   */
    double beat[2];       /* with STACK_LOAD: a filling and a limit
                               multiplier that both are to be exceeded    */
    /* called before each stone, if not NULL, where someone may wait      */
    void (*progress)(const struct stack_wall *w, int wall);
};

STACK_API struct stack_options stack_defaults(void)
{
    /* clang-format off */
    struct stack_options o = {
        STACK_BEST, 8, 4.5, STONES_MOST, 0, {0}, 0, 0, 0.4, -1, 1, 400, 185000,
        STACK_DROP, {0, 0}, NULL};
    /* clang-format on */
    for (int k = 0; k < STACK_FILTERS; k++)
        o.threshold[k] = stack_threshold[k];
    return o;
}

/* A small stone fills what others leave: below this share of the mean area. */
static const double stack_filler = 0.25;

/* ---- A wall -------------------------------------------------------------- */

struct stack_place {
    int stone;         /* of the stock                     */
    kern_vec at, turn; /* centre; cosine and sine          */
    double top;        /* dressed level at this height; HUGE_VAL: not  */
};

/* A corner of a stone of the stock between two faces that may both be beds, on
   two tops that meet at the same angle: the sine of its turn. */
struct stack_bend {
    int stone;
    double turn;
};

struct stack_wall {
    const struct stones *stock;
    struct stack_options options;
    kern_block *below;   /* room for blocks below a height            */
    kern_block *shape;   /* all stones of the stock, as they are there */
    struct stone *stone; /* as they lie; block i + 1 of the plan      */
    struct stack_place *place;
    int laid;
    int pins;                /* of them: stack_keeps_back()               */
    kern_vec ground[4];      /* block 0                                   */
    char *used;              /* one a stone of the stock                  */
    struct stack_bend *bend; /* of all stones                        */
    int bends;
    kern_plan plan;
    kern_work work;
    kern_motion *motion; /* room for what a plan knows                */
    kern_force *force;
    kern_margin m;
    double filled;       /* area within the frame                     */
    double *sky;         /* height of what is highest, column by column */
    int *owner;          /* block which that is                       */
    int lie;             /* nonzero: the longest face of a stone is level */
    double course;       /* a stone is laid so far above the lowest place, in
                            sizes                                        */
    kern_contact *close; /* room for contacts that are nearly closed  */
    kern_real *load;     /* and for the load factor of every block    */
    int columns;
    struct rest_near around; /* room for the edges of all                 */
    int walls;               /* that `best` has built                     */
    int tried;               /* stones let down that came to rest         */
    int asked;               /* candidates that kern was asked about      */
    int held;                /* of them, whether they stay                */
    double asking;           /* CPU seconds that took                     */
    int slipped;             /* of them, those that do not                */
    char message[200];       /* why the wall ended                        */
};

enum { STACK_COLUMNS = 24 }; /* in a stone of mean size */

STACK_API void stack_free(struct stack_wall *w)
{
    free(w->below);
    free(w->shape);
    free(w->stone);
    free(w->place);
    free(w->used);
    free(w->bend);
    room_free_plan(&w->plan);
    free(w->motion);
    free(w->force);
    free(w->sky);
    free(w->owner);
    free(w->close);
    free(w->load);
    free(w->around.edge);
}

static void stack_clear_sky(struct stack_wall *w)
{
    for (int i = 0; i < w->columns; i++) {
        w->sky[i] = 0;
        w->owner[i] = 0;
    }
}

/* The ground alone. */
static int stack_begin(struct stack_wall *w)
{
    kern_block ground;
    kern_ground_init(&ground, w->ground, 4, NULL);
    w->plan.task.s.blocks = w->plan.task.s.contacts = 0;
    w->plan.task.known.fails = 0;
    w->laid = w->pins = 0;
    w->filled = 0;
    memset(w->used, 0, (size_t)w->stock->stones);
    stack_clear_sky(w);
    return kern_plan_add(&w->plan, &ground) < 0 ? -1 : 0;
}

/* Sets the shapes of all stones of the stock, which stone_of() has checked. */
static void stack_find_shapes(struct stack_wall *w)
{
    for (int i = 0; i < w->stock->stones; i++)
        kern_block_init(&w->shape[i], w->stock->stone[i].v,
                        w->stock->stone[i].n, 1, NULL);
}

/* Finds the bends of all stones of the stock between faces that may be beds. */
static void stack_find_bends(struct stack_wall *w)
{
    const double least = 0.25 * w->stock->size, most = 0.42; /* sine */
    w->bends = 0;
    for (int i = 0; i < w->stock->stones; i++) {
        const struct stone *s = &w->stock->stone[i];
        for (int k = 0; k < s->n; k++) {
            const int next = k + 1 < s->n ? k + 1 : 0;
            const struct rest_edge a = rest_edge_at(s, k);
            const struct rest_edge b = rest_edge_at(s, next);
            const kern_vec p = stones_sub(a.b, a.a), q = stones_sub(b.b, b.a);
            const double turn = stones_cross(a.n, b.n);
            if (turn <= 0 || turn > most || stones_dot(a.n, b.n) < 0
                || stones_dot(p, p) < least * least
                || stones_dot(q, q) < least * least)
                continue;
            w->bend[w->bends].stone = i;
            w->bend[w->bends++].turn = turn;
        }
    }
}

/* Returns 1 if every array of a wall is there. */
static int stack_has_room(const struct stack_wall *w)
{
    return room_is_there(&w->plan) && w->below && w->shape && w->stone
        && w->motion && w->place && w->force && w->used && w->bend && w->sky
        && w->owner && w->around.edge && w->close && w->load;
}

/* An empty wall. Returns 0, or -1 where memory is lacking. */
STACK_API int stack_open(struct stack_wall *w, const struct stones *stock,
                         const struct stack_options *options)
{
    static const struct stack_wall empty;
    const size_t stones = (size_t)stock->stones;
    const int blocks = stock->stones + 2, contacts = 40 * blocks;
    int corners = 4;
    *w = empty;
    w->stock = stock;
    w->options = *options;
    if (w->options.look == 0)
        w->options.look = options->planner == STACK_BEST ? STONES_MOST
                                                         : STACK_LOOK;
    for (int i = 0; i < stock->stones; i++)
        corners += stock->stone[i].n;
    w->plan = room_plan(blocks, contacts, &w->work);
    w->motion = malloc((size_t)blocks * sizeof(kern_motion));
    w->force = malloc((size_t)contacts * sizeof(kern_force));
    w->close = malloc((size_t)contacts * sizeof *w->close);
    w->load = malloc((size_t)blocks * sizeof *w->load);
    w->plan.task.options.mu = options->friction;
    w->plan.task.options.epsilon = 0.02 * stock->size;
    w->plan.task.s.gravity = stones_vec(0, -9.81);
    w->below = malloc((size_t)blocks * sizeof *w->below);
    w->shape = malloc(stones * sizeof *w->shape);
    w->stone = malloc(stones * sizeof *w->stone);
    w->place = malloc(stones * sizeof *w->place);
    w->used = malloc(stones);
    w->bend = malloc((size_t)corners * sizeof *w->bend);
    w->columns = (int)ceil(options->width / stock->size * STACK_COLUMNS);
    w->sky = malloc((size_t)w->columns * sizeof *w->sky);
    w->owner = malloc((size_t)w->columns * sizeof *w->owner);
    w->around.edge = malloc((size_t)corners * sizeof *w->around.edge);
    if (!stack_has_room(w))
        return -1;
    stack_find_shapes(w);
    stack_find_bends(w);
    w->ground[0] = stones_vec(-stock->size, -0.5 * stock->size);
    w->ground[1] = stones_vec(options->width + stock->size, w->ground[0].y);
    w->ground[2] = stones_vec(w->ground[1].x, 0);
    w->ground[3] = stones_vec(-stock->size, 0);
    return stack_begin(w);
}

/* Heights of the lower and the upper side of a stone at x. */
static int stack_sides(const struct stone *s, double x, double *low,
                       double *high)
{
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (int i = 0; i < s->n; i++) {
        kern_vec p = s->v[i], q = s->v[i + 1 < s->n ? i + 1 : 0];
        if ((p.x < x) == (q.x < x))
            continue;
        double y = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
        *low = rigid_least(*low, y);
        *high = rigid_most(*high, y);
    }
    return *low < HUGE_VAL;
}

static double stack_column_x(const struct stack_wall *w, int column)
{
    return (column + 0.5) * w->options.width / w->columns;
}

/* The first column at x or to the right of it, within the frame. */
static int stack_column(const struct stack_wall *w, double x)
{
    double c = ceil(x / w->options.width * w->columns - 0.5);
    return c < 0 ? 0 : c > w->columns ? w->columns : (int)c;
}

STACK_API struct stone stack_placed(const struct stack_wall *w,
                                    const struct stack_place *place)
{
    struct stone s = w->stock->stone[place->stone];
    stone_turn(&s, s.centre, place->turn);
    stone_move(&s, place->at);
    if (place->top < s.high.y)
        stone_dress(&s, stones_vec(0, 1), place->top);
    return s;
}

/* The sky rises over stone i of the wall. */
static void stack_raise(struct stack_wall *w, int i)
{
    const struct stone *s = &w->stone[i];
    for (int c = stack_column(w, s->low.x); c < w->columns; c++) {
        double low, high;
        if (!stack_sides(s, stack_column_x(w, c), &low, &high))
            break;
        if (high <= w->sky[c])
            continue;
        w->sky[c] = high;
        w->owner[c] = i + 1;
    }
}

/* Head joints: contacts steeper than 45 degrees. */
static int stack_is_joint(const kern_contact *c)
{
    return fabs(c->n.y) < fabs(c->n.x);
}

/* Adds a block to the plan, with the friction of head joints. */
static int stack_add(struct stack_wall *w, const kern_block *block)
{
    int i = w->plan.task.s.contacts, found = kern_plan_add(&w->plan, block);
    for (; i < w->plan.task.s.contacts && w->options.joints >= 0; i++)
        if (stack_is_joint(&w->plan.contact[i]))
            w->plan.contact[i].mu = w->options.joints;
    return found;
}

/* Is a stone of the stock a pin, that `best` keeps back for others? */
STACK_API int stack_keeps_back(const struct stack_wall *w, int stone)
{
    return w->options.planner == STACK_BEST
        && stones_is_pin(w->stock, &w->stock->stone[stone]);
}

/* Stones that are left, without pins. */
STACK_API int stack_left(const struct stack_wall *w)
{
    const int pins = w->options.planner == STACK_BEST ? w->stock->pins : 0;
    return w->stock->stones - pins - (w->laid - w->pins);
}

/* Lays a stone and measures the wall. Returns 0, or -1 where it falls. */
STACK_API int stack_lay(struct stack_wall *w, const struct stack_place *place)
{
    struct stone *s = &w->stone[w->laid];
    kern_block block;
    *s = stack_placed(w, place);
    if (kern_block_init(&block, s->v, s->n, 1, NULL) != KERN_OK
        || stack_add(w, &block) < 0)
        return -1;
    if (kern_measure(&w->plan.task, &w->m, NULL) != KERN_STANDS) {
        kern_plan_remove(&w->plan, w->laid + 1);
        return -1;
    }
    stack_raise(w, w->laid);
    w->used[place->stone] = 1;
    w->pins += stack_keeps_back(w, place->stone);
    w->filled += stone_area_in(s, w->options.width, w->options.height);
    w->place[w->laid++] = *place;
    return 0;
}

/* ---- What a wall is worth ------------------------------------------------ */

/* What of the frame is filled: the target fill fraction. */
STACK_API double stack_fill(const struct stack_wall *w)
{
    return w->filled / (w->options.width * w->options.height);
}

/* What a filling is worth, 0 to 1: half at 0.70, the middle of the walls that
   heuristics are known to build (0.65 to 0.79); steep enough that little is
   lost by calling it 0 below 0.60, where a wall is no wall (0.05 there), and
   that the best fillings are still told apart (0.95 at 0.80). */
STACK_API double stack_worth(double fill)
{
    return 1 / (1 + exp(-30 * (fill - 0.70)));
}

/* The quality of a wall: stability times what the filling is worth. Stability
   is the margin in sizes of a stone: the level without its steps. */
STACK_API double stack_quality(double stability, double fill)
{
    return fill < 0.60 ? 0 : stability * stack_worth(fill);
}

/* The limit multiplier: the largest horizontal acceleration in units of gravity
   to the weaker side, with a friction of 0.58 and none in head joints;
   -1 where it does not stand at all so.
   Frictions of the contacts are as before afterwards. */
STACK_API double stack_limit(const kern_task *as_it_is, kern_contact *contact)
{
    const double friction = 0.58;
    const int contacts = as_it_is->s.contacts;
    kern_task task = *as_it_is;
    kern_real factor[2] = {0, 0};
    kern_real *mu = calloc((size_t)contacts + 1, sizeof *mu);
    int falls = 0;
    if (!mu)
        return -1;
    task.options = kern_defaults();
    for (int i = 0; i < contacts; i++) {
        mu[i] = contact[i].mu;
        contact[i].mu = stack_is_joint(&contact[i]) ? 0 : friction;
    }
    for (int k = 0; k < 2; k++)
        falls |= kern_load_factor(&task, 0, k ? KERN_RIGHT : KERN_LEFT,
                                  &factor[k], NULL)
              != KERN_STANDS;
    for (int i = 0; i < contacts; i++)
        contact[i].mu = mu[i];
    free(mu);
    return falls ? -1 : fmin(factor[0], factor[1]);
}

/* ---- Features ------------------------------------------------------------ */

/* Edges of the wall that a stone may meet in a box; those far below are out
   of its reach. */
STACK_API void stack_look(struct stack_wall *w, double left, double right,
                          double low)
{
    const kern_structure *s = &w->plan.task.s;
    w->around.edges = 0;
    for (int b = 0; b < s->blocks; b++) {
        const kern_block *block = &s->block[b];
        if (block->box.high.y < low || block->box.low.x > right
            || block->box.high.x < left)
            continue;
        for (int i = 0; i < block->vertices; i++) {
            kern_vec p = block->vertex[i];
            kern_vec q = block->vertex[i + 1 < block->vertices ? i + 1 : 0];
            if (rigid_most(p.y, q.y) < low || rigid_least(p.x, q.x) > right
                || rigid_most(p.x, q.x) < left)
                continue;
            w->around.edge[w->around.edges] = rest_edge_of(p, q);
            w->around.edge[w->around.edges++].block = b;
        }
    }
}

/* Returns the length along which two edges touch: antiparallel within 1 degree,
   the part where they are within `gap` of each other. */
STACK_API double stack_common(const struct rest_edge *a,
                              const struct rest_edge *b, double gap)
{
    const double cosine = 0.99984769515639127; /* of 1 degree */
    const kern_vec t = stones_vec(-a->n.y, a->n.x);
    double from, to, at, rise;
    if (stones_dot(a->n, b->n) > -cosine)
        return 0;
    from = rigid_most(0, stones_dot(t, stones_sub(b->b, a->a)));
    to = rigid_least(stones_dot(t, stones_sub(a->b, a->a)),
                     stones_dot(t, stones_sub(b->a, a->a)));
    at = stones_dot(b->n, stones_sub(a->a, b->a));
    rise = stones_dot(b->n, t);
    if (fabs(rise) < 1e-12)
        return fabs(at) <= gap ? rigid_most(0, to - from) : 0;
    from = rigid_most(from, -at / rise - gap / fabs(rise));
    to = rigid_least(to, -at / rise + gap / fabs(rise));
    return rigid_most(0, to - from);
}

/* Length of all edges that a stone shares with what is near, over its
   perimeter. More is better: it is held, and fits. */
STACK_API double stack_edges(const struct rest_near *around,
                             const struct stone *s)
{
    double common = 0, perimeter = 0, gap = 1e-3 * sqrt(s->area);
    for (int i = 0; i < s->n; i++) {
        struct rest_edge own = rest_edge_at(s, i);
        kern_vec t = stones_sub(own.b, own.a);
        perimeter += sqrt(stones_dot(t, t));
        for (int k = 0; k < around->edges; k++)
            common += stack_common(&own, &around->edge[k], gap);
    }
    return common / perimeter;
}

/* Area between a stone and what is below it, over its own area. Less is
   better: nothing can be laid there any more. */
STACK_API double stack_hole(const struct stack_wall *w, const struct stone *s)
{
    double sum = 0, low, high;
    for (int i = stack_column(w, s->low.x);
         i < w->columns && stack_sides(s, stack_column_x(w, i), &low, &high);
         i++)
        sum += fmax(0, low - w->sky[i]);
    return sum * w->options.width / w->columns / s->area;
}

/* Mean height of the sky from x to x + way; HUGE_VAL outside of the frame. */
static double stack_mean_sky(const struct stack_wall *w, double x, double way)
{
    int from = stack_column(w, rigid_least(x, x + way));
    int to = stack_column(w, rigid_most(x, x + way));
    double sum = 0;
    for (int i = from; i < to; i++)
        sum += w->sky[i];
    return to > from ? sum / (to - from) : HUGE_VAL;
}

/* How far the neighbours, over half a stone on either side, rise above the
   lowest point of a stone, in sizes. More is better: gaps are closed before a
   course is begun on top. */
STACK_API double stack_neighbours(const struct stack_wall *w,
                                  const struct stone *s)
{
    const double size = w->stock->size;
    double left = stack_mean_sky(w, s->low.x, -size / 2);
    double right = stack_mean_sky(w, s->high.x, size / 2);
    if (!(left < HUGE_VAL))
        left = right;
    if (!(right < HUGE_VAL))
        right = left;
    return right < HUGE_VAL ? ((left + right) / 2 - s->low.y) / size : 0;
}

/* Rise over run of the upper side, without its sign: mean over its width. Less
   is better: the next stone does not slide. */
STACK_API double stack_slope(const struct stone *s)
{
    double rise = 0, run = 0;
    for (int i = 0; i < s->n; i++) {
        struct rest_edge e = rest_edge_at(s, i);
        if (e.n.y < 0.5)
            continue;
        rise += fabs(e.b.y - e.a.y);
        run += fabs(e.b.x - e.a.x);
    }
    return run > 0 ? rise / run : HUGE_VAL;
}

/* From the ends of a stone to the next joint in the course below it: the
   shorter way, in sizes, at most 0.5. More is better: no joint runs through. A
   joint is where the sky below the stone passes from one block to the next. */
STACK_API double stack_bond(const struct stack_wall *w, const struct stone *s)
{
    const double most = 0.5 * w->stock->size, top = s->low.y + most / 2;
    double least = most;
    int from = stack_column(w, s->low.x - most);
    int to = stack_column(w, s->high.x + most);
    for (int i = from + 1; i < to; i++) {
        double x = i * w->options.width / w->columns;
        if (w->owner[i] == w->owner[i - 1] || w->sky[i] > top
            || w->sky[i - 1] > top)
            continue;
        least = fmin(least, fmin(fabs(x - s->low.x), fabs(x - s->high.x)));
    }
    return least / w->stock->size;
}

/* Do two edges touch within `gap`, the second below the first? */
static int stack_carries(const struct rest_edge *own, const struct rest_edge *e,
                         double gap)
{
    return (e->n.y >= masonry_rests && rest_on(e, own->a)
            && fabs(stones_dot(e->n, stones_sub(own->a, e->a))) < gap)
        || (own->n.y <= -masonry_rests && rest_on(own, e->a)
            && fabs(stones_dot(own->n, stones_sub(e->a, own->a))) < gap);
}

/* What carries a stone: blocks on beds of masonry_point or more, at corners,
   whether the ground is one of them, the one block that carries it alone or 0,
   and the length of all beds, in sizes. */
struct stack_bedding {
    int beds, corners, ground, alone;
    double length;
};

STACK_API struct stack_bedding stack_bedding_of(const struct stack_wall *w,
                                                const struct stone *s)
{
    enum { MOST = 8 };
    struct stack_bedding b = {0, 0, 0, 0, 0};
    double length[MOST] = {0};
    int below[MOST], count = 0;
    for (int i = 0; i < s->n; i++) {
        const struct rest_edge own = rest_edge_at(s, i);
        for (int k = 0; k < w->around.edges; k++) {
            const struct rest_edge *e = &w->around.edge[k];
            const double other = e->block > 0 ? w->stone[e->block - 1].area
                                              : s->area;
            const double gap = 1e-3 * sqrt(rigid_least(s->area, other));
            double common;
            int at = 0;
            if (!rest_is_beside(e, s, gap))
                continue;
            common = own.n.y <= -masonry_rests ? stack_common(&own, e, gap) : 0;
            if (common <= 0 && !stack_carries(&own, e, gap))
                continue;
            while (at < count && below[at] != e->block)
                at++;
            if (at == count && count == MOST)
                continue;
            if (at == count)
                below[count++] = e->block;
            length[at] = rigid_most(length[at], common);
        }
    }
    for (int i = 0; i < count; i++) {
        const int bed = length[i] >= masonry_point * w->stock->size;
        b.beds += bed;
        b.corners += !bed;
        b.ground |= below[i] == 0;
        b.length += length[i] / sqrt(s->area);
    }
    b.alone = count == 1 ? below[0] : 0;
    return b;
}

/* Finds the face of a stone that looks up and ends nearest to a side (-1 left,
   1 right), up to half a size long: its ends from left to right. Returns 0
   where there is none of 0.15 sizes. */
static int stack_top_face(const struct stone *s, int side, double size,
                          kern_vec end[2])
{
    const double up = 0.94, least = masonry_point * size, most = 0.5 * size;
    double best = -HUGE_VAL;
    for (int i = 0; i < s->n; i++) {
        const struct rest_edge e = rest_edge_at(s, i);
        const double at = side < 0 ? -e.b.x : e.a.x;
        if (e.n.y < up || e.a.x - e.b.x < least || at <= best)
            continue;
        best = at;
        end[0] = e.b;
        end[1] = e.a;
    }
    if (best > -HUGE_VAL && end[1].x - end[0].x > most) {
        const double share = most / (end[1].x - end[0].x);
        const kern_vec way = stones_vec(share * (end[1].x - end[0].x),
                                        share * (end[1].y - end[0].y));
        if (side < 0)
            end[1] = stones_vec(end[0].x + way.x, end[0].y + way.y);
        else
            end[0] = stones_vec(end[1].x - way.x, end[1].y - way.y);
    }
    return best > -HUGE_VAL;
}

static double stack_rise(kern_vec a, kern_vec b)
{
    return (b.y - a.y) / (b.x - a.x);
}

/* Returns 1 if one straight face may have beds on two faces: their common
   tangent turns off neither by more than a bed of 0.15 sizes allows. */
static int stack_is_one_bed(const kern_vec left[2], const kern_vec right[2])
{
    const double most = 0.0055; /* 1e-3 sizes in 0.15, and a little less */
    for (int k = 0; k < 4; k++) {
        const kern_vec a = left[k / 2], b = right[k % 2];
        const double rise = stack_rise(a, b);
        int above = b.x > a.x;
        for (int i = 0; i < 2 && above; i++)
            above = left[i].y - a.y <= rise * (left[i].x - a.x) + 1e-9
                 && right[i].y - a.y <= rise * (right[i].x - a.x) + 1e-9;
        if (above)
            return fabs(rise - stack_rise(left[0], left[1])) <= most
                && fabs(rise - stack_rise(right[0], right[1])) <= most;
    }
    return 0;
}

/* Returns 1 if another stone that is left has a bend that fits between two
   faces: their lines meet near the joint, at its angle. */
static int stack_is_notch(const struct stack_wall *w, int stone,
                          const kern_vec left[2], const kern_vec right[2])
{
    const double size = w->stock->size, error = 0.005, room = 0.2 * size;
    const double a = stack_rise(left[0], left[1]);
    const double b = stack_rise(right[0], right[1]);
    const double turn = (b - a) / sqrt((1 + a * a) * (1 + b * b));
    double x;
    if (turn < error)
        return 0;
    x = (left[1].y - right[0].y + b * right[0].x - a * left[1].x) / (b - a);
    if (x < left[0].x + room || x > right[1].x - room || x > left[1].x + room
        || x < right[0].x - room)
        return 0;
    for (int i = 0; i < w->bends; i++)
        if (!w->used[w->bend[i].stone] && w->bend[i].stone != stone
            && fabs(w->bend[i].turn - turn) < error)
            return 1;
    return 0;
}

/* Finds the stone whose top is beside a stone on a side; NULL: there is none. */
static const struct stone *stack_beside(const struct stack_wall *w,
                                        const struct stone *s, int side)
{
    const double aside = w->stock->size / 8;
    const double x = side < 0 ? s->low.x - aside : s->high.x + aside;
    const int c = stack_column(w, x);
    return x > 0 && c < w->columns && w->owner[c] > 0
             ? &w->stone[w->owner[c] - 1]
             : NULL;
}

/* Returns on how many sides of a stone, of this number in the stock, another one
   may have beds on it and on the one beside it. */
STACK_API int stack_matches(const struct stack_wall *w, int stone,
                            const struct stone *s)
{
    const double size = w->stock->size;
    int count = 0;
    for (int side = -1; side < 2; side += 2) {
        const struct stone *t = stack_beside(w, s, side);
        kern_vec own[2], other[2], *left, *right;
        if (!t || fabs(t->high.y - s->high.y) > 0.2 * size
            || !stack_top_face(s, side, size, own)
            || !stack_top_face(t, -side, size, other))
            continue;
        left = side < 0 ? other : own;
        right = side < 0 ? own : other;
        count += stack_is_one_bed(left, right)
              || stack_is_notch(w, stone, left, right);
    }
    return count;
}

/* ---- Dressing ------------------------------------------------------------ */

/* Returns the least height at which a stone may be dressed level. */
static double stack_lowest_top(const struct stack_wall *w,
                               const struct stone *s)
{
    double low = (s->low.y + s->high.y) / 2, high = s->high.y;
    for (int i = 0; i < 24; i++) {
        const double middle = (low + high) / 2;
        if (stone_area_below(s, middle) < (1 - w->options.dress) * s->area)
            low = middle;
        else
            high = middle;
    }
    return high;
}

/* Returns the lowest of the corners between the faces of a stone that look up. */
static double stack_shoulder(const struct stone *s)
{
    const double up = 0.7;
    double low = HUGE_VAL;
    for (int i = 0; i < s->n; i++) {
        const struct rest_edge e = rest_edge_at(s, i);
        if (e.n.y >= up)
            low = fmin(low, fmin(e.a.y, e.b.y));
    }
    return low;
}

/* Returns the height at which a stone in place is dressed: that of a top beside
   it if so much may go, else that makes its top level, or nearly; HUGE_VAL: it
   is not dressed. */
STACK_API double stack_dressed(const struct stack_wall *w,
                               const struct stone *s)
{
    const double least = 1e-6 * w->stock->size;
    double low, top;
    if (!(w->options.dress > 0) || w->options.planner != STACK_BEST)
        return HUGE_VAL;
    low = stack_lowest_top(w, s);
    for (int side = -1; side < 2; side += 2) {
        const struct stone *t = stack_beside(w, s, side);
        if (t && t->high.y >= low && t->high.y <= s->high.y + least)
            return t->high.y;
    }
    top = fmax(low, stack_shoulder(s));
    return top < s->high.y - least ? top : HUGE_VAL;
}

/* How far the top of a stone is from those beside it, in sizes, at most 0.5:
   the mean of the sides where something reaches above its middle. The side of
   the frame counts as level; 0.25 where nothing is beside it. Less is better:
   courses grow from stone to stone, and their tops are level. */
STACK_API double stack_step_up(const struct stack_wall *w,
                               const struct stone *s)
{
    const double size = w->stock->size, middle = (s->low.y + s->high.y) / 2;
    const double top[2] = {stack_mean_sky(w, s->low.x, -size / 8),
                           stack_mean_sky(w, s->high.x, size / 8)};
    double sum = 0;
    int sides = 0;
    for (int k = 0; k < 2; k++) {
        if (top[k] <= middle)
            continue;
        sides++;
        if (top[k] < HUGE_VAL)
            sum += fmin(0.5, fabs(top[k] - s->high.y) / size);
    }
    return sides > 0 ? sum / sides : 0.25;
}

/* ---- Output -------------------------------------------------------------- */

/* Writes it in the text format, every digit: stones that were laid corner to
   corner touch or do not by the last of them. Returns 0, or -1. */
STACK_API int stack_write(const struct stack_wall *w, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out)
        return -1;
    fprintf(out, "friction %g\ngravity 0 -9.81\nepsilon %.9g\nfixed base",
            w->options.friction, w->plan.task.options.epsilon);
    for (int i = 0; i < 4; i++)
        fprintf(out, "  %.9g %.9g", w->ground[i].x, w->ground[i].y);
    for (int i = 0; i < w->laid; i++) {
        fprintf(out, "\nblock s%d *", w->place[i].stone);
        for (int k = 0; k < w->stone[i].n; k++)
            fprintf(out, "  %.17g %.17g", w->stone[i].v[k].x,
                    w->stone[i].v[k].y);
    }
    fputs("\n", out);
    return fclose(out) ? -1 : 0;
}

/* What a picture of some width shows: the frame, and what rises above it. */
STACK_API void stack_view(const struct stack_wall *w, struct draw_view *v,
                          double width)
{
    const double beside = 0.3 * w->stock->size;
    v->low = draw_vec(-beside, -beside);
    v->high = draw_vec(w->options.width + beside, w->options.height + beside);
    for (int i = 0; i < w->laid; i++)
        v->high.y = fmax(v->high.y, w->stone[i].high.y + beside);
    v->left = v->top = DRAW_PAD;
    v->scale = (width - 2 * DRAW_PAD) / (v->high.x - v->low.x);
}

/* The ground, and a dashed line around the frame. */
STACK_API void stack_draw_frame(const struct stack_wall *w,
                                const struct draw_view *v)
{
    struct draw_pt ground = draw_place(v, v->low.x, 0);
    struct draw_pt top = draw_place(v, 0, w->options.height);
    draw_rect(v->out, ground.x, ground.y, (v->high.x - v->low.x) * v->scale,
              -v->low.y * v->scale, "fill=\"#d8d3c8\"");
    draw_rect(v->out, top.x, top.y, w->options.width * v->scale,
              w->options.height * v->scale,
              "fill=\"none\" stroke=\"" DRAW_EDGE
              "\" stroke-width=\"0.8\" stroke-dasharray=\"5 4\"");
}

STACK_API void stack_draw_stone(const struct stack_wall *w,
                                const struct draw_view *v, int i)
{
    const int fills = (int)(sizeof draw_stone / sizeof draw_stone[0]);
    char style[120];
    snprintf(style, sizeof style,
             "fill=\"%s\" stroke=\"" DRAW_EDGE "\" "
             "stroke-width=\"0.9\" stroke-linejoin=\"round\"",
             draw_stone[i % fills]);
    draw_block(v, &w->plan.task.s.block[i + 1], NULL, 0, style);
}

#endif /* STACK_WALL_H */
