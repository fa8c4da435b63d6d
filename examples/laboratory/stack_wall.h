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

/* What `best` wants to be high beside the filling: the level of shaking that a
   finished wall endures in the simulator, the one that the expected drop
   predicts, or the load factor. */
enum stack_goal { STACK_SHAKING, STACK_DROP, STACK_LOAD, STACK_GOALS };

static const char *const stack_goal_name[] = {"shaking", "drop", "load"};

struct stack_wall;

/* How many passes of the simulator over a contact take as long as a candidate; as
   how many candidates it takes to ask whether the wall stands with one, and
   whether its load raises the forces; and how many stones of the stock may be the
   next one, if nothing else is asked for. */
enum {
    STACK_PASSES = 160,
    STACK_ASKING = 2,
    STACK_RAISING = 70,
    STACK_LOOK = 6
};

/* Runs of the simulator that are asked of a stone, see stack_place.h. */
enum { STACK_RUNS = 5 };

struct stack_options {
    enum stack_planner planner;
    double width, height; /* of the frame, whose lower left is 0, 0     */
    int most;             /* stones that are laid at the most           */
    int look;             /* stones of the stock that may be the next   */
    double threshold[STACK_FILTERS];
    int levels; /* filters before that by kern's levels       */
    double friction;
    double joints;        /* friction in head joints; < 0: the same     */
    uint64_t seed;        /* of what `best` leaves to chance            */
    int walls;            /* that `best` builds                         */
    int effort;           /* where it begins no further one, see
                               stack_spent(): in candidates, in proportion to
                               `look`, up to twice as much; 0: no limit   */
    enum stack_goal goal; /* what it wants to be high                   */
    double beat[2];       /* with STACK_LOAD: a filling and a limit
                               multiplier that both are to be exceeded    */
    /* called before each stone, if not NULL, where someone may wait      */
    void (*progress)(const struct stack_wall *w, int wall);
};

STACK_API struct stack_options stack_defaults(void)
{
    struct stack_options o = {
        STACK_BEST, 8, 4.5, STONES_MOST, STACK_LOOK,    {0},    0,   0.4,
        -1,         1, 400, 420000,      STACK_SHAKING, {0, 0}, NULL};
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
};

struct stack_wall {
    const struct stones *stock;
    struct stack_options options;
    struct stone *stone; /* as they lie; block i + 1 of the plan      */
    struct stack_place *place;
    int laid;
    int pins;           /* of them: stack_keeps_back()               */
    kern_vec ground[4]; /* block 0                                   */
    char *used;         /* one a stone of the stock                  */
    kern_plan plan;
    kern_work work;
    kern_motion *motion; /* room for what a plan knows                */
    kern_force *force;
    kern_margin m;
    double filled;       /* area within the frame                     */
    double *sky;         /* height of what is highest, column by column */
    int *owner;          /* block which that is                       */
    int upright;         /* long stones that stand on end             */
    int lie;             /* nonzero: no further stone may stand so    */
    kern_contact *close; /* room for contacts that are nearly closed  */
    kern_real *load;     /* and for the load factor of every block    */
    int columns;
    struct rest_near around; /* room for the edges of all                 */
    int walls;               /* that `best` has built                     */
    int runs;                /* of the simulator before a stone is laid   */
    int tried;               /* stones let down that came to rest         */
    int asked;               /* candidates that kern was asked about      */
    int raised;              /* of them, whether they are raised          */
    double asking;           /* CPU seconds that took                     */
    int swayed, slipped;     /* let go in the simulator; moved            */
    double passes;           /* of the simulator over a contact           */
    char message[200];       /* why the wall ended                        */
};

enum { STACK_COLUMNS = 24 }; /* in a stone of mean size */

STACK_API void stack_free(struct stack_wall *w)
{
    free(w->stone);
    free(w->place);
    free(w->used);
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
    w->upright = 0;
    memset(w->used, 0, (size_t)w->stock->stones);
    stack_clear_sky(w);
    return kern_plan_add(&w->plan, &ground) < 0 ? -1 : 0;
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
    w->runs = STACK_RUNS;
    w->stock = stock;
    w->options = *options;
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
    w->stone = malloc(stones * sizeof *w->stone);
    w->place = malloc(stones * sizeof *w->place);
    w->used = malloc(stones);
    w->columns = (int)ceil(options->width / stock->size * STACK_COLUMNS);
    w->sky = malloc((size_t)w->columns * sizeof *w->sky);
    w->owner = malloc((size_t)w->columns * sizeof *w->owner);
    w->around.edge = malloc((size_t)corners * sizeof *w->around.edge);
    if (!room_is_there(&w->plan) || !w->stone || !w->motion || !w->place
        || !w->force || !w->used || !w->sky || !w->owner || !w->around.edge
        || !w->close || !w->load)
        return -1;
    w->ground[0] = stones_vec(-1, -0.5);
    w->ground[1] = stones_vec(options->width + 1, -0.5);
    w->ground[2] = stones_vec(options->width + 1, 0);
    w->ground[3] = stones_vec(-1, 0);
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

/* Does a long stone stand on end, or lean so far that it hardly lies? */
static int stack_on_end(const struct stone *s)
{
    const double steep = 50; /* degrees */
    double aspect, angle = masonry_axis(s->v, s->n, s->centre, &aspect);
    return aspect > masonry_long && angle > steep;
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
    w->upright += stack_on_end(s);
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

/* Length along which two edges touch: face to face within 1 degree, and within
   `gap` of each other. */
STACK_API double stack_common(const struct rest_edge *a,
                              const struct rest_edge *b, double gap)
{
    const double cosine = 0.99984769515639127; /* of 1 degree */
    kern_vec t = stones_vec(-a->n.y, a->n.x);
    double from, to, length = stones_dot(t, stones_sub(a->b, a->a));
    if (stones_dot(a->n, b->n) > -cosine)
        return 0;
    from = rigid_most(0, stones_dot(t, stones_sub(b->b, a->a)));
    to = rigid_least(length, stones_dot(t, stones_sub(b->a, a->a)));
    if (to <= from)
        return 0;
    /* the gap in the middle of what they share */
    kern_vec m = stones_vec(a->a.x + (from + to) / 2 * t.x,
                            a->a.y + (from + to) / 2 * t.y);
    return fabs(stones_dot(b->n, stones_sub(m, b->a))) <= gap ? to - from : 0;
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

/* Length of the beds that carry a stone, in its sizes: edges at most 30 degrees
   off the level that lie on others. */
STACK_API double stack_bed(const struct rest_near *around,
                           const struct stone *s)
{
    const double size = sqrt(s->area);
    double sum = 0;
    for (int i = 0; i < s->n; i++) {
        struct rest_edge own = rest_edge_at(s, i);
        if (own.n.y > -masonry_level)
            continue;
        for (int k = 0; k < around->edges; k++)
            sum += stack_common(&own, &around->edge[k], 1e-3 * size);
    }
    return sum / size;
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

/* How many blocks carry a stone, two for more; *below is the first of them, as
   masonry_rest_on() counts when it is laid. */
STACK_API int stack_carriers(const struct rest_near *around,
                             const struct stone *s, int *below)
{
    int count = 0;
    for (int i = 0; i < s->n && count < 2; i++) {
        const struct rest_edge own = rest_edge_at(s, i);
        for (int k = 0; k < around->edges && count < 2; k++) {
            const struct rest_edge *e = &around->edge[k];
            if ((count > 0 && e->block == *below)
                || !stack_carries(&own, e, 1e-3 * sqrt(s->area)))
                continue;
            if (count++ == 0)
                *below = e->block;
        }
    }
    return count;
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
