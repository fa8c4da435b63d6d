/* stack.h - a planner that builds a wall of irregular stones, for the example
   programs.

   A step: several of the next stones are let down, in several turns, at several
   places, and slid against what is beside them (candidates). A hierarchy of
   filters then keeps the good ones; each is a number and a threshold, see
   stack_filter. The kern filter predicts the level of the wall with each
   candidate, by a plan of the wall, and drops those below the mean. Of what is
   left the planner takes the candidate with most of the first feature, if it
   also stays there in the simulator: a stone may slide although forces exist
   that would hold it.

   Features and hierarchy are those that the heuristic planner of V. Thangavelu,
   Y. Liu, M. Saboia and N. Napp (Dry stacking for automated construction with
   irregular objects, ICRA 2018) is described with; the kern filter is that of
   Y. Liu, M. Saboia, V. Thangavelu and N. Napp (Approximate Stability Analysis
   for Drystacked Structures, IROS 2019). The formulas beside the functions say
   what is meant here.

   The planners: `heuristic` has no kern filter, `combined` has. `best` builds
   several walls, see stack_best(), by a cost of what masons want: long faces
   down, beds, level courses, crossed joints. All of them take the last stones
   off again until the finished wall stays, see stack_finish().

   Chapters: options, a wall, its worth, features, candidates, the simulator,
   what may be laid, filters, search, output.

   Lengths are those of the stock; thresholds are in stones, so they have no
   unit. The same input gives the same wall.

   SPDX-License-Identifier: MIT */

#ifndef STACK_H
#define STACK_H

#include "../../kern.h"
#include "../parts/draw.h"
#include "../parts/random.h"
#include "../parts/rigid.h"
#include "../parts/room.h"
#include "../parts/table.h"
#include "masonry.h"
#include "stones.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define STACK_API static __attribute__((unused))
#else
#define STACK_API static
#endif

/* ---- Options ------------------------------------------------------------- */

#define STACK_FILTER_LIST(X)                                                  \
    X(EDGES, "edges", 0.20, "common edges / perimeter")                       \
    X(HOLE, "hole", 0.25, "area of the hole below / area of the stone")       \
    X(NEIGHBOURS, "neighbours", 0.04, "height of the neighbours / size")      \
    X(SLOPE, "slope", 0.03, "slope of the top, as a tangent")                 \
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

enum stack_planner { STACK_HEURISTIC, STACK_COMBINED, STACK_BEST,
                     STACK_PLANNERS };

static const char *const stack_planner_name[] = { "heuristic", "combined",
                                                  "best" };

/* What `best` wants to be high beside the filling: the level of shaking that a
   finished wall endures in the simulator, the one that the expected drop
   predicts, or the load factor. */
enum stack_goal { STACK_SHAKING, STACK_DROP, STACK_LOAD, STACK_GOALS };

static const char *const stack_goal_name[] = { "shaking", "drop", "load" };

struct stack_wall;

/* The effort of one look in the simulator, in candidates; and how many stones of
   the stock may be the next one, if nothing else is asked for. */
enum { STACK_SWAY = 100, STACK_LOOK = 6 };

struct stack_options {
    enum stack_planner planner;
    double width, height;   /* of the frame, whose lower left is 0, 0     */
    int most;               /* stones that are laid at the most           */
    int look;               /* stones of the stock that may be the next   */
    double threshold[STACK_FILTERS];
    int levels;             /* filters before that by kern's levels       */
    double friction;
    double joints;          /* friction in head joints; < 0: the same     */
    uint64_t seed;          /* of what `best` leaves to chance            */
    int walls;              /* that `best` builds                         */
    int effort;             /* where it begins no further one: candidates,
                               questions to kern, and STACK_SWAY for each
                               look in the simulator; in proportion to
                               `look`, up to twice as much; 0: no limit   */
    enum stack_goal goal;   /* what it wants to be high                   */
    double beat[2];         /* with STACK_LOAD: a filling and a limit
                               multiplier that both are to be exceeded    */
    /* called before each stone, if not NULL, where someone may wait      */
    void (*progress)(const struct stack_wall *w, int wall);
};

STACK_API struct stack_options stack_defaults(void)
{
    struct stack_options o = { STACK_BEST, 8, 4.5, STONES_MOST, STACK_LOOK,
                               { 0 }, 0, 0.4, -1, 1, 48, 140000, STACK_SHAKING,
                               { 0, 0 }, NULL };
    for (int k = 0; k < STACK_FILTERS; k++) o.threshold[k] = stack_threshold[k];
    return o;
}

/* A small stone fills what others leave: below this share of the mean area. */
static const double stack_filler = 0.25;

/* ---- A wall -------------------------------------------------------------- */

struct stack_place {
    int stone;              /* of the stock                     */
    kern_vec at, turn;      /* centre; cosine and sine          */
};

struct stack_wall {
    const struct stones *stock;
    struct stack_options options;
    struct stone *stone;    /* as they lie; block i + 1 of the plan      */
    struct stack_place *place;
    int laid;
    kern_vec ground[4];     /* block 0                                   */
    char *used;             /* one a stone of the stock                  */
    kern_plan plan;
    kern_work work;
    kern_motion *motion;    /* room for what a plan knows                */
    kern_force *force;
    kern_margin m;
    double filled;          /* area within the frame                     */
    double *sky;            /* height of what is highest, column by column */
    int *owner;             /* block which that is                       */
    int upright;            /* long stones that stand on end             */
    int lie;                /* nonzero: no further stone may stand so    */
    kern_contact *close;    /* room for contacts that are nearly closed  */
    kern_real *load;        /* and for the load factor of every block    */
    int columns;
    struct rest_near around;  /* room for the edges of all                 */
    int walls;              /* that `best` has built                     */
    int tried;              /* stones let down that came to rest         */
    int asked;              /* candidates that kern was asked about      */
    double asking;          /* CPU seconds that took                     */
    int swayed, slipped;    /* let go in the simulator; moved            */
    double swaying;         /* CPU seconds that took                     */
    char message[200];      /* why the wall ended                        */
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
    w->laid = 0;
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
    w->stock = stock;
    w->options = *options;
    for (int i = 0; i < stock->stones; i++) corners += stock->stone[i].n;
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
    if (!room_is_there(&w->plan) || !w->stone || !w->motion || !w->place ||
        !w->force || !w->used || !w->sky || !w->owner || !w->around.edge ||
        !w->close || !w->load)
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
        if ((p.x < x) == (q.x < x)) continue;
        double y = p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y);
        *low = fmin(*low, y);
        *high = fmax(*high, y);
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
        if (!stack_sides(s, stack_column_x(w, c), &low, &high)) break;
        if (high <= w->sky[c]) continue;
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

/* Lays a stone and measures the wall. Returns 0, or -1 where it falls. */
STACK_API int stack_lay(struct stack_wall *w, const struct stack_place *place)
{
    struct stone *s = &w->stone[w->laid];
    kern_block block;
    *s = stack_placed(w, place);
    if (kern_block_init(&block, s->v, s->n, 1, NULL) != KERN_OK ||
        stack_add(w, &block) < 0)
        return -1;
    if (kern_measure(&w->plan.task, &w->m, NULL) != KERN_STANDS) {
        kern_plan_remove(&w->plan, w->laid + 1);
        return -1;
    }
    stack_raise(w, w->laid);
    w->used[place->stone] = 1;
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
    kern_real factor[2] = { 0, 0 };
    kern_real *mu = calloc((size_t)contacts + 1, sizeof *mu);
    int falls = 0;
    if (!mu) return -1;
    task.options = kern_defaults();
    for (int i = 0; i < contacts; i++) {
        mu[i] = contact[i].mu;
        contact[i].mu = stack_is_joint(&contact[i]) ? 0 : friction;
    }
    for (int k = 0; k < 2; k++)
        falls |= kern_load_factor(&task, 0, k ? KERN_RIGHT : KERN_LEFT,
                                  &factor[k], NULL) != KERN_STANDS;
    for (int i = 0; i < contacts; i++) contact[i].mu = mu[i];
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
        if (block->box.high.y < low || block->box.low.x > right ||
            block->box.high.x < left)
            continue;
        for (int i = 0; i < block->vertices; i++) {
            kern_vec p = block->vertex[i];
            kern_vec q = block->vertex[i + 1 < block->vertices ? i + 1 : 0];
            if (fmax(p.y, q.y) >= low && fmin(p.x, q.x) <= right &&
                fmax(p.x, q.x) >= left)
                w->around.edge[w->around.edges++] = rest_edge_of(p, q);
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
    if (stones_dot(a->n, b->n) > -cosine) return 0;
    from = fmax(0, stones_dot(t, stones_sub(b->b, a->a)));
    to = fmin(length, stones_dot(t, stones_sub(b->a, a->a)));
    if (to <= from) return 0;
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
    for (int i = stack_column(w, s->low.x); i < w->columns &&
         stack_sides(s, stack_column_x(w, i), &low, &high); i++)
        sum += fmax(0, low - w->sky[i]);
    return sum * w->options.width / w->columns / s->area;
}

/* Mean height of the sky from x to x + way; HUGE_VAL outside of the frame. */
static double stack_mean_sky(const struct stack_wall *w, double x, double way)
{
    int from = stack_column(w, fmin(x, x + way));
    int to = stack_column(w, fmax(x, x + way));
    double sum = 0;
    for (int i = from; i < to; i++) sum += w->sky[i];
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
    if (!(left < HUGE_VAL)) left = right;
    if (!(right < HUGE_VAL)) right = left;
    return right < HUGE_VAL ? ((left + right) / 2 - s->low.y) / size : 0;
}

/* Rise over run of the upper side, without its sign: mean over its width. Less
   is better: the next stone does not slide. */
STACK_API double stack_slope(const struct stone *s)
{
    double rise = 0, run = 0;
    for (int i = 0; i < s->n; i++) {
        struct rest_edge e = rest_edge_at(s, i);
        if (e.n.y < 0.5) continue;
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
        if (w->owner[i] == w->owner[i - 1] || w->sky[i] > top ||
            w->sky[i - 1] > top)
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
        if (own.n.y > -masonry_level) continue;
        for (int k = 0; k < around->edges; k++)
            sum += stack_common(&own, &around->edge[k], 1e-3 * size);
    }
    return sum / size;
}

/* How far the top of a stone is from those beside it, in sizes, at most 0.5:
   the mean of the sides where something reaches above its middle. The side of
   the frame counts as level; 0.25 where nothing is beside it. Less is better:
   courses grow from stone to stone, and their tops are level. */
STACK_API double stack_step_up(const struct stack_wall *w,
                               const struct stone *s)
{
    const double size = w->stock->size, middle = (s->low.y + s->high.y) / 2;
    const double top[2] = { stack_mean_sky(w, s->low.x, -size / 8),
                            stack_mean_sky(w, s->high.x, size / 8) };
    double sum = 0;
    int sides = 0;
    for (int k = 0; k < 2; k++) {
        if (top[k] <= middle) continue;
        sides++;
        if (top[k] < HUGE_VAL)
            sum += fmin(0.5, fabs(top[k] - s->high.y) / size);
    }
    return sides > 0 ? sum / sides : 0.25;
}

/* ---- Candidates ---------------------------------------------------------- */

struct stack_candidate {
    struct stack_place place;
    double feature[STACK_FILTERS]; /* signed so that more is better      */
    double inside;          /* area within the frame                     */
    double bed, step;       /* of stack_bed() and stack_step_up()        */
    int upright;            /* stands on end                             */
    double cost;            /* to `best`                                 */
    int out;                /* a filter dropped it, or it falls          */
    int known;              /* kern was asked: what follows is the wall's
                               with it                                   */
    kern_margin m;
    double stable;          /* its load factor, where that is the goal   */
};

struct stack_list {
    struct stack_candidate *one;
    int count, room;
};

static int stack_same(const struct stack_place *a, const struct stack_place *b,
                      double within)
{
    return a->stone == b->stone && fabs(a->at.x - b->at.x) < within &&
           fabs(a->at.y - b->at.y) < within &&
           fabs(a->turn.x - b->turn.x) < within &&
           fabs(a->turn.y - b->turn.y) < within;
}

/* Notes a stone at rest, if it lies in the frame and is not known yet; one of
   many corners finds a hold anywhere, so that places a little apart are one.
   Returns -1 where memory is lacking. */
static int stack_note(struct stack_wall *w, struct stack_list *list, int stone,
                      const struct stone *s)
{
    const double within = (s->n > STONES_BEDS ? 0.03 : 1e-3) * w->stock->size;
    struct stack_candidate *more, c;
    if (s->low.x < -rest_touch || s->high.x > w->options.width + rest_touch)
        return 0;
    c.place.stone = stone;
    c.place.at = s->centre;
    c.place.turn = s->turn;
    c.out = c.known = 0;
    c.inside = s->high.y <= w->options.height ? s->area :
               stone_area_in(s, w->options.width, w->options.height);
    if (c.inside < s->area / 2) return 0;
    for (int i = list->count - 1; i >= 0 && list->one[i].place.stone == stone;
         i--)
        if (stack_same(&list->one[i].place, &c.place, within))
            return 0;
    c.feature[STACK_EDGES] = stack_edges(&w->around, s);
    c.feature[STACK_HOLE] = -stack_hole(w, s);
    c.feature[STACK_NEIGHBOURS] = stack_neighbours(w, s);
    c.feature[STACK_SLOPE] = -stack_slope(s);
    c.feature[STACK_BOND] = stack_bond(w, s);
    c.bed = stack_bed(&w->around, s);
    c.step = stack_step_up(w, s);
    c.upright = stack_on_end(s);
    more = rigid_room(list->one, list->count, 1, &list->room, sizeof *more);
    if (!more) return -1;
    list->one = more;
    list->one[list->count++] = c;
    return 0;
}

/* A place above which a stone is let down, and the direction of what is there:
   a bed of the stone is turned to it. */
struct stack_anchor {
    double x;
    kern_vec along;
};

static const double stack_grid = 0.4; /* between anchors, in sizes          */
static const double stack_fine = 0.1; /* where none of these will do        */
static const double stack_soldiers = 0.1; /* share of stones on end, `best`  */
static const double stack_slide = 0.8; /* most that a stone slides, in sizes */
static const double stack_level = 0.1; /* tops of one height, in sizes       */
static const double stack_steep = 0.9; /* cosine of the steepest bed        */

/* The middle of every notch of the sky, between what rises on either side or the
   side of the frame: a stone that just fits is let down nowhere else. */
static int stack_notches(const struct stack_wall *w, struct stack_anchor *a)
{
    const double level = stack_level * w->stock->size;
    double left = 0;
    int n = 0, down = 1;
    for (int c = 1; c <= w->columns; c++) {
        const double rise = c < w->columns ? w->sky[c] - w->sky[c - 1]
                                           : HUGE_VAL;
        if (rise < -level) {
            left = w->stone[w->owner[c - 1] - 1].high.x;
            down = 1;
        } else if (rise > level && down) {
            const double right = c < w->columns
                ? w->stone[w->owner[c] - 1].low.x : w->options.width;
            a[n].x = (left + right) / 2;
            a[n++].along = stones_vec(1, 0);
            down = 0;
        }
    }
    return n;
}

/* The faces that look upward and can be seen from there, the longer ones of a
   stone of many corners, and a grid; for `best` also the notches, and the joints
   between tops of one height, that a stone may cross. */
static int stack_anchors(const struct stack_wall *w, double step,
                         struct stack_anchor *a)
{
    const double size = w->stock->size;
    const int grid = (int)ceil(w->options.width / step);
    int n = 0;
    for (int b = 1; b < w->plan.task.s.blocks; b++)
        for (int i = 0; i < w->stone[b - 1].n; i++) {
            const struct stone *s = &w->stone[b - 1];
            struct rest_edge e = rest_edge_at(s, i);
            double x = (e.a.x + e.b.x) / 2;
            double least = (s->n > STONES_BEDS ? 0.3 : 0.15) * size;
            int column = stack_column(w, x);
            if (e.n.y < stack_steep || e.a.x - e.b.x < least ||
                column >= w->columns || w->owner[column] != b)
                continue;
            a[n].x = x;
            a[n++].along = stones_vec(e.n.y, -e.n.x);
        }
    for (int i = 0; i < grid; i++) {
        a[n].x = (i + 0.5) * w->options.width / grid;
        a[n++].along = stones_vec(1, 0);
    }
    if (w->options.planner != STACK_BEST) return n;
    n += stack_notches(w, a + n);
    for (int c = 1; c < w->columns; c++) {
        if (w->owner[c] == w->owner[c - 1] ||
            fabs(w->sky[c] - w->sky[c - 1]) > stack_level * size)
            continue;
        a[n].x = c * w->options.width / w->columns;
        a[n++].along = stones_vec(1, 0);
    }
    return n;
}

/* Slides a stone at rest to one side until something, or the side of the frame,
   is in the way, and notes it where it then comes to rest. */
static int stack_slide_on(struct stack_wall *w, struct stack_list *list,
                          int stone, struct stone s, double side)
{
    kern_vec left, right, d = { side, 0 };
    double way, room;
    rest_holds(&w->around, &s, &left, &right);
    if (right.x - left.x > 0.05 * w->stock->size)
        d = stones_unit(stones_sub(right, left));
    if (side * d.x < 0) d = stones_vec(-d.x, -d.y);
    if (fabs(d.x) < stack_steep) return 0;
    room = (side > 0 ? w->options.width - s.high.x : s.low.x) / fabs(d.x);
    way = fmin(rest_way(&w->around, &s, d), room);
    if (!(way > 0.01 * w->stock->size &&
          way < stack_slide * w->stock->size))
        return 0;
    stone_move(&s, stones_vec(way * d.x, way * d.y));
    return rest_settle(&w->around, &s) ? stack_note(w, list, stone, &s) : 0;
}

/* One stone, one bed, one anchor: up to three candidates. */
static int stack_let_down(struct stack_wall *w, struct stack_list *list,
                          int stone, int bed, const struct stack_anchor *a)
{
    struct stone s = w->stock->stone[stone];
    const kern_vec b = s.bed[bed];
    double x, high = 0;
    stone_turn(&s, s.centre, stones_turned(a->along, stones_vec(b.x, -b.y)));
    if (s.high.x - s.low.x > w->options.width ||
        (w->lie && stack_on_end(&s)))
        return 0;
    x = fmin(fmax(a->x, -s.low.x), w->options.width - s.high.x);
    for (int i = 0; i < w->around.edges; i++)
        high = fmax(high, w->around.edge[i].a.y);
    stone_move(&s, stones_vec(x, high - s.low.y + 1));
    if (!rest_settle(&w->around, &s)) return 0;
    w->tried++;
    return stack_note(w, list, stone, &s) ||
           stack_slide_on(w, list, stone, s, -1) ||
           stack_slide_on(w, list, stone, s, 1);
}

/* Is a number of stones asked for? */
static int stack_asked(const struct stack_wall *w)
{
    return w->options.most <= w->stock->stones;
}

/* Finds the edges that a stone may meet when it is let down at x and slid. */
static void stack_look_below(struct stack_wall *w, const struct stone *s,
                             double x)
{
    const double most = 2 * s->reach + stack_slide * w->stock->size;
    const int to = stack_column(w, x + most);
    double low = HUGE_VAL;
    for (int c = stack_column(w, x - most); c < to; c++)
        low = fmin(low, w->sky[c]);
    stack_look(w, x - most, x + most, low - rest_touch);
}

/* Where stones are let down, and how much of that is looked at: a share of the
   pairs of anchor and bed, by chance. */
struct stack_scan {
    struct stack_anchor *anchor;
    int anchors;
    double share;
    uint64_t *chance;
};

/* The candidates of one stone of the stock. */
static int stack_propose_one(struct stack_wall *w, struct stack_list *list,
                             int stone, const struct stack_scan *scan)
{
    const struct stone *s = &w->stock->stone[stone];
    int bad = 0;
    for (int i = 0; i < scan->anchors && !bad; i++) {
        const struct stack_anchor *a = &scan->anchor[i];
        stack_look_below(w, s, a->x);
        for (int bed = 0; bed < s->beds && !bad; bed++)
            if (scan->share >= 1 ||
                random_uniform(scan->chance, 0, 1) < scan->share)
                bad = stack_let_down(w, list, stone, bed, a);
    }
    return bad;
}

/* Fills the list with candidates of the next stones of the stock, or of `all`
   that are left; `share` of what could be is looked at. `all` is on a finer
   grid and looks at everything, for `best` only where a number of stones is
   asked for. Returns 0, or -1 where memory is lacking. */
STACK_API int stack_propose(struct stack_wall *w, struct stack_list *list,
                            double share, uint64_t *chance, int all)
{
    const int fine = all && (stack_asked(w) ||
                             w->options.planner != STACK_BEST);
    const double step = (fine ? stack_fine : stack_grid) * w->stock->size;
    struct stack_scan scan = { NULL, 0, fine ? 1 : share, chance };
    int stones = 0, bad = 0;
    int room = (int)(w->options.width / step) + 2 + 2 * w->columns;
    for (int i = 0; i < w->laid; i++) room += w->stone[i].n;
    scan.anchor = malloc((size_t)room * sizeof *scan.anchor);
    if (!scan.anchor) return -1;
    scan.anchors = stack_anchors(w, step, scan.anchor);
    list->count = 0;
    for (int k = 0; k < w->stock->stones && !bad &&
         (all || stones < w->options.look); k++) {
        if (w->used[k]) continue;
        stones++;
        bad = stack_propose_one(w, list, k, &scan);
    }
    free(scan.anchor);
    return bad;
}

/* ---- Candidates: what kern says of them ---------------------------------- */

/* Levels of shaking that a load factor of one is worth, about: `best` weighs
   both in the same unit. */
static const double stack_levels_a_load = 20;

/* The smaller load factor of the plan as it is. */
static double stack_load(struct stack_wall *w)
{
    kern_real factor[2] = { 0, 0 };
    for (int k = 0; k < 2; k++)
        if (kern_load_factor(&w->plan.task, 0, k ? KERN_RIGHT : KERN_LEFT,
                             &factor[k], NULL) != KERN_STANDS)
            return 0;
    return fmin(factor[0], factor[1]);
}

/* The level at which the wall is predicted to collapse when it is shaken: by
   its expected drop; 0 where that cannot be found. Of 150 walls of an earlier
   planner the mean of the predictions is 5.0, that of the levels in the shaking
   test 5.1; their rank correlation is 0.76. */
STACK_API double stack_predicted_level(struct stack_wall *w)
{
    const double at_one = 2, slope = 3.2, least = 0.01;
    const kern_side side[2] = { KERN_LEFT, KERN_RIGHT };
    kern_task task = w->plan.task;
    double drop = 0;
    task.options = kern_near(&task.options, w->stock->size);
    task.s.contact = w->close;
    task.s.contacts = kern_contacts(task.s.block, task.s.blocks, &task.options,
                                    w->close, w->plan.contact_room, task.work);
    task.known.motion = NULL;
    task.known.force = NULL;
    if (task.s.contacts < 0) return 0;
    for (int k = 0; k < 2; k++) {
        kern_collapse c;
        if (kern_profile(&task, side[k], w->load, &c) != KERN_OK) return 0;
        drop += c.drop;
    }
    return at_one - slope * log(drop + least);
}

/* Measures the wall with one more block, and its load factor if that is wanted.
   The block is added and taken off again; what the plan knows is as before. */
static kern_status stack_measure_with(struct stack_wall *w,
                                      const kern_block *block, int load,
                                      struct stack_candidate *c)
{
    const struct kern_known known = w->plan.task.known;
    const size_t motions = (size_t)w->plan.task.s.blocks * sizeof(kern_motion);
    const size_t forces = (size_t)w->plan.task.s.contacts * sizeof(kern_force);
    kern_status status = KERN_OVERLAP;
    memcpy(w->motion, known.motion, motions);
    memcpy(w->force, known.force, forces);
    if (stack_add(w, block) >= 0) {
        status = kern_measure(&w->plan.task, &c->m, NULL);
        if (load && status == KERN_STANDS)
            c->stable = stack_levels_a_load * stack_load(w);
        kern_plan_remove(&w->plan, w->laid + 1);
    }
    memcpy(known.motion, w->motion, motions);
    memcpy(known.force, w->force, forces);
    w->plan.task.known = known;
    return status;
}

/* Asks the plan what the wall would be with a candidate: for `best` whether it
   stands, and where that is the goal its load factor; for the others its margin.
   Returns 1 where it stands. */
static int stack_ask(struct stack_wall *w, struct stack_candidate *c)
{
    struct stone s = stack_placed(w, &c->place);
    const int best = w->options.planner == STACK_BEST;
    const int load = best && w->options.goal == STACK_LOAD;
    kern_block block;
    clock_t start = clock();
    kern_status status = kern_block_init(&block, s.v, s.n, 1, NULL);
    w->asked++;
    c->known = 1;
    c->stable = 0;
    if (status == KERN_OK && (load || w->options.joints >= 0))
        status = stack_measure_with(w, &block, load, c);
    else if (status == KERN_OK)
        status = best ? kern_plan_bears(&w->plan, &block, 0, NULL)
                      : kern_plan_try(&w->plan, &block, &c->m, NULL);
    w->asking += (double)(clock() - start) / CLOCKS_PER_SEC;
    return status == KERN_STANDS;
}

/* ---- The simulator ------------------------------------------------------- */

/* What forces allow may still slide or tip over: a wall is let go. Lengths in
   sizes, seconds where gravity is 9.81. */
struct stack_run {
    double rate;            /* steps a second                              */
    int substeps;
    double noise;           /* of every place and angle                    */
    double push;            /* sideways, as a share of gravity             */
    double least, seconds;  /* it ends after so long where all are calm    */
};

static const double stack_still = 0.02; /* a stone may not go farther      */

/* The runs that a planner asks: as the stones lie, with an error in each pose
   and a push to either side, and in long steps for longer. */
static const struct stack_run stack_runs[] = {
    { 240, 4, 0, 0, 0, 4 }, { 240, 4, 2e-4, 0.02, 0, 4 },
    { 120, 6, 2e-4, -0.02, 0, 4 }, { 90, 6, 2e-4, 0, 0.5, 6 }
};

/* The runs of the step test, which no planner sees, and how far a stone may go
   there. */
enum { STACK_TESTS = 6 };
static const struct stack_run stack_tests[STACK_TESTS] = {
    { 240, 4, 0, 0, 1, 6 }, { 240, 4, 1e-4, 0, 1, 6 },
    { 240, 4, 1e-4, 0, 1, 6 }, { 60, 8, 1e-4, 0, 1, 6 },
    { 120, 16, 1e-4, 0, 1, 6 }, { 480, 32, 1e-4, 0, 1, 4 }
};
static const double stack_moved = 0.05;

/* An error of a pose, in -1 to 1. */
static double stack_error(uint64_t *state)
{
    return 2 * random_share(random_mixed(state)) - 1;
}

/* A world with the wall, and one more stone if `last` is not NULL; block 0 is
   the ground. */
static int stack_world(struct rigid_world *r, const struct stack_wall *w,
                       const struct stone *last, double noise, uint64_t seed)
{
    const double unit = w->stock->size;
    struct rigid_pt v[STONES_CORNERS];
    uint64_t state = seed;
    rigid_init(r);
    r->friction = w->options.friction;
    r->slop = 5e-4; /* stones sink in by this */
    for (int i = 0; i < 4; i++)
        v[i] = rigid_vec(w->ground[i].x / unit, w->ground[i].y / unit);
    if (rigid_add(r, v, 4, 0, v[0]) < 0) return -1;
    for (int i = 0; i <= w->laid; i++) {
        const struct stone *s = i < w->laid ? &w->stone[i] : last;
        struct rigid_pt at;
        if (!s) continue;
        at = rigid_vec(s->centre.x / unit, s->centre.y / unit);
        for (int k = 0; k < s->n; k++)
            v[k] = rigid_vec(s->v[k].x / unit, s->v[k].y / unit);
        if (rigid_add(r, v, s->n, s->area, at) < 0) return -1;
        at.x += noise * stack_error(&state);
        at.y += noise * stack_error(&state);
        rigid_put(r, i + 1, at, noise * stack_error(&state));
    }
    return 0;
}

/* How far a block has gone from where it was laid: in sizes, a turn of 5
   degrees counting as 0.05. */
static double stack_gone(const struct rigid_block *b, const struct stone *s,
                         double unit)
{
    const struct rigid_pt from = rigid_vec(s->centre.x / unit,
                                           s->centre.y / unit);
    return fmax(rigid_length(rigid_sub(b->at, from)), 0.573 * fabs(b->angle));
}

/* The longest way of a stone when the wall, with one more stone if `last` is
   not NULL, is let go in a run, or until all are calm; HUGE_VAL where memory is
   lacking. Ends at the first that goes farther than `most`. */
STACK_API double stack_sway(const struct stack_wall *w,
                            const struct stone *last,
                            const struct stack_run *run, uint64_t seed,
                            double most)
{
    const double unit = w->stock->size, calm = 1e-4;
    const int look = (int)(run->rate / 10);
    struct rigid_world r;
    double sway = 0, fast = 1;
    if (stack_world(&r, w, last, run->noise, seed)) sway = HUGE_VAL;
    r.step = 1 / run->rate;
    r.substeps = run->substeps;
    r.gravity.x = -run->push * r.gravity.y;
    for (int i = 1; i <= run->seconds * run->rate && sway <= most &&
         (fast > calm || i <= run->least * run->rate); i++) {
        if (rigid_step(&r)) sway = HUGE_VAL;
        if (i % look > 0) continue;
        fast = 0;
        for (int k = 1; k < r.blocks; k++) {
            const struct rigid_block *b = &r.block[k];
            const struct stone *s = k <= w->laid ? &w->stone[k - 1] : last;
            sway = fmax(sway, stack_gone(b, s, unit));
            fast = fmax(fast, rigid_length(b->v) + b->reach * fabs(b->spin));
        }
    }
    rigid_free(&r);
    return sway;
}

/* Does the wall stay where it is with one more stone, in every run? */
static int stack_stays(struct stack_wall *w, const struct stone *last)
{
    const int runs = (int)(sizeof stack_runs / sizeof stack_runs[0]);
    clock_t start = clock();
    int stays = 1;
    for (int i = 0; i < runs && stays; i++)
        stays = stack_sway(w, last, &stack_runs[i], (uint64_t)i,
                           stack_still) <= stack_still;
    w->swaying += (double)(clock() - start) / CLOCKS_PER_SEC;
    w->swayed++;
    w->slipped += !stays;
    return stays;
}

/* The last look at a finished wall, with errors larger than in any run before. */
static const struct stack_run stack_last = { 240, 16, 5e-4, 0, 1, 4 };
enum { STACK_LAST = 4 };

/* Does a finished wall stay where it is, in every run of the last look? */
static int stack_rests(const struct stack_wall *w)
{
    int rests = 1;
    for (int i = 0; i < STACK_LAST && rests; i++)
        rests = stack_sway(w, NULL, &stack_last, (uint64_t)(10 + i),
                           stack_moved) <= stack_moved;
    return rests;
}

/* In how many runs of the step test the first stones of a wall move. */
STACK_API int stack_moves(const struct stack_wall *w, int stones)
{
    struct stack_wall part = *w;
    int moves = 0;
    part.laid = stones;
    for (int i = 0; i < STACK_TESTS; i++)
        moves += stack_sway(&part, NULL, &stack_tests[i], (uint64_t)(100 + i),
                            stack_moved) > stack_moved;
    return moves;
}

/* The least and the most that stack_endured_level() tells apart, levels. */
static const double stack_endured_low = 1, stack_endured_high = 30;

/* Do the stones keep their places, within a quarter of a size in the mean, when
   the ground runs along the figure of eight of table.h at some level? It begins
   at another moment than the shaking test, and stones lie otherwise. */
static int stack_endures(const struct stack_wall *w, double level,
                         uint64_t seed)
{
    const double unit = w->stock->size, allowed = 0.25;
    struct rigid_world r;
    double time = 0, mean = 0;
    int bad = stack_world(&r, w, NULL, table_noise, seed);
    const struct rigid_pt from = bad ? rigid_vec(0, 0) : r.block[0].at;
    const struct rigid_pt on = rigid_unit(2 * table_pi * table_frequency
                                          * r.step);
    struct rigid_pt q = rigid_unit(2 * table_pi * (double)seed / 5);
    for (int i = 1; !bad && time < table_fade_ends && mean < 2 * allowed; i++) {
        struct rigid_pt to, *at = &r.block[0].at;
        time = i * r.step;
        to = table_eight(q, table_amplitude * level * table_strength(time));
        r.block[0].v = rigid_vec((from.x + to.x - at->x) / r.step,
                                 (from.y + to.y - at->y) / r.step);
        bad = rigid_step(&r);
        q = rigid_turned(q, on);
        if (i % table_look_every > 0) continue;
        mean = 0;
        for (int k = 1; k < r.blocks; k++) {
            struct rigid_block b = r.block[k];
            b.at = rigid_vec(b.at.x - to.x, b.at.y - to.y);
            mean += stack_gone(&b, &w->stone[k - 1], unit) / (r.blocks - 1);
        }
    }
    rigid_free(&r);
    return !bad && mean <= allowed;
}

/* In two runs? */
static int stack_endures_twice(const struct stack_wall *w, double level)
{
    return stack_endures(w, level, 1) && stack_endures(w, level, 2);
}

/* The highest level of shaking, to 5 per cent, that the wall endures twice; 0
   where that is below `least`. */
STACK_API double stack_endured_level(const struct stack_wall *w, double least)
{
    double level = fmax(least, stack_endured_low), step = 2;
    if (!stack_endures_twice(w, level))
        return least > stack_endured_low ? 0 : stack_endured_low;
    while (step > 1.03) {
        const double next = level * step;
        if (next <= stack_endured_high && stack_endures_twice(w, next))
            level = next;
        else step = sqrt(step);
    }
    return level;
}

/* ---- What may be laid ---------------------------------------------------- */

/* The share of gravity that may push sideways while the load still raises the
   forces: what the library recommends. */
static const double stack_reserve = 0.0055;

/* Does a block touch another at points that are no face but shrink toward each
   other, as a stone does that sticks in a notch? What they can carry may grow
   again as kerns shrink, so that kern has to look at every step: the wall would be
   asked about ten times as long. */
static int stack_sticks(struct stack_wall *w, const kern_block *block)
{
    const int last = w->plan.task.s.blocks;
    int found, sticks = 0;
    w->plan.block[last] = *block;
    found = kern_touch(w->plan.block, last, &w->plan.task.options, w->close,
                       w->plan.contact_room, &w->work);
    for (int i = 0; i < found; i++)
        sticks |= !w->close[i].line &&
                  fabs(w->close[i].travel) > 1e-9 * w->stock->size;
    return sticks;
}

/* The load itself must raise the forces that hold the wall with a candidate,
   with that reserve, and nothing may move in the simulator. */
static int stack_holds(struct stack_wall *w, const struct stack_candidate *c)
{
    struct stone s = stack_placed(w, &c->place);
    kern_block block;
    kern_raising raising;
    kern_real reserve;
    return kern_block_init(&block, s.v, s.n, 1, NULL) == KERN_OK &&
           !stack_sticks(w, &block) &&
           kern_plan_raised(&w->plan, &block, &raising, &reserve, NULL)
               == KERN_STANDS &&
           raising == KERN_RAISED && reserve >= stack_reserve &&
           stack_stays(w, &s);
}

/* ---- Filters ------------------------------------------------------------- */

static int stack_is_filler(const struct stack_wall *w,
                           const struct stack_candidate *c)
{
    return w->stock->stone[c->place.stone].area
           < stack_filler * w->stock->area;
}

/* Drops what is worse than the best in a feature by more than its threshold. */
static void stack_sift(const struct stack_wall *w, struct stack_list *list,
                       int feature)
{
    double best = -HUGE_VAL;
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out)
            best = fmax(best, list->one[i].feature[feature]);
    for (int i = 0; i < list->count; i++)
        if (list->one[i].feature[feature] < best
                                            - w->options.threshold[feature])
            list->one[i].out = 1;
}

/* Drops candidates whose level is below the mean, but for fillers. */
static void stack_sift_levels(const struct stack_wall *w,
                              struct stack_list *list)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out && !stack_is_filler(w, &list->one[i])) {
            sum += list->one[i].m.level;
            count++;
        }
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out && !stack_is_filler(w, &list->one[i]) &&
            list->one[i].m.level * count < sum)
            list->one[i].out = 1;
}

static void stack_strike(struct stack_list *list, int i)
{
    list->one[i] = list->one[--list->count];
}

/* Asks about all that is left and takes away what falls. Returns how many
   fell. */
static int stack_drop_falling(struct stack_wall *w, struct stack_list *list)
{
    int fell = 0;
    for (int i = 0; i < list->count; i++) {
        if (list->one[i].out || list->one[i].known ||
            stack_ask(w, &list->one[i]))
            continue;
        stack_strike(list, i--);
        fell++;
    }
    return fell;
}

/* What all filters leave, and of this the candidate with the longest common
   edges; -1: none stands. Filters see only what stands: where some of those
   that they left fall, they begin again without these. */
static int stack_filter(struct stack_wall *w, struct stack_list *list)
{
    const int levels = w->options.planner == STACK_HEURISTIC
                     ? -1 : w->options.levels;
    int best = -1, k = 0;
    while (k <= STACK_FILTERS) {
        if (k == 0)
            for (int i = 0; i < list->count; i++) list->one[i].out = 0;
        if ((k == levels || k == STACK_FILTERS) && stack_drop_falling(w, list) > 0) {
            k = 0;
            continue;
        }
        if (k == levels) stack_sift_levels(w, list);
        if (k < STACK_FILTERS) stack_sift(w, list, k);
        k++;
    }
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out &&
            (best < 0 || list->one[i].feature[STACK_EDGES]
                             > list->one[best].feature[STACK_EDGES]))
            best = i;
    return best;
}

/* ---- Search: what both kinds need ---------------------------------------- */

/* How `best` builds a wall: the cost of a candidate is a weighted sum. Areas are
   in squares of a stone's size, lengths in sizes. */
struct stack_weights {
    double notch;           /* narrower ones are dead, sizes               */
    double height;          /* of the top of a stone, against a dead area  */
    double stable;          /* a load factor of 1/20, where that is the goal */
    double slope, bond, edges; /* the features                             */
    double bed, step;       /* length of beds; unevenness of a course      */
    double end;             /* area of what ends a course                  */
    double noise;
    double share;           /* of the candidates that are looked at        */
};

/* Room for the skies that a cost compares. */
struct stack_skies {
    double *now, *then, *room, *closed[2];
};

struct stack_search {
    struct stack_list list;     /* candidates for the next stone          */
    uint64_t chance;            /* state of the random numbers            */
    struct stack_place *kept;   /* the stones of the best wall so far     */
    int keep;                   /* how many these are                     */
    int retreats;               /* of stack_build()                       */
    struct stack_skies skies;   /* the rest is for `best`                 */
    double value;               /* of the best wall, and how it was built */
    struct stack_weights good;
};

/* Returns 0, or -1 where memory is lacking; stack_search_free() either way. */
static int stack_search_open(const struct stack_wall *w, uint64_t chance,
                             struct stack_search *s)
{
    static const struct stack_search empty;
    const size_t n = (size_t)w->columns + 4 * STACK_COLUMNS; /* notches below 2
                                                          sizes on both sides */
    *s = empty;
    s->chance = chance;
    s->value = -HUGE_VAL;
    s->kept = malloc((size_t)w->stock->stones * sizeof *s->kept);
    s->skies.now = malloc(5 * n * sizeof *s->skies.now);
    if (!s->kept || !s->skies.now) return -1;
    s->skies.then = s->skies.now + n;
    s->skies.room = s->skies.then + n;
    s->skies.closed[0] = s->skies.room + n;
    s->skies.closed[1] = s->skies.closed[0] + n;
    return 0;
}

static void stack_search_free(struct stack_search *s)
{
    free(s->list.one);
    free(s->kept);
    free(s->skies.now);
}

/* Notes the wall as the best so far. */
static void stack_keep(const struct stack_wall *w, struct stack_search *s)
{
    s->keep = w->laid;
    memcpy(s->kept, w->place, (size_t)s->keep * sizeof *s->kept);
}

/* Takes away the last stones, down to a number of them. */
static void stack_cut(struct stack_wall *w, int keep)
{
    while (w->laid > keep) {
        w->laid--;
        w->upright -= stack_on_end(&w->stone[w->laid]);
        w->used[w->place[w->laid].stone] = 0;
        w->filled -= stone_area_in(&w->stone[w->laid], w->options.width,
                                   w->options.height);
        kern_plan_remove(&w->plan, w->laid + 1);
    }
    stack_clear_sky(w);
    for (int i = 0; i < w->laid; i++) stack_raise(w, i);
}

/* Takes all stones off and lays others. Returns 0, or -1. */
static int stack_restore(struct stack_wall *w, const struct stack_place *place,
                         int laid)
{
    int bad = 0;
    stack_cut(w, 0);
    for (int i = 0; i < laid && !bad; i++) bad = stack_lay(w, &place[i]);
    return bad;
}

/* Is every stone laid that is wanted? Notes this as why the wall ended. */
static int stack_ends(struct stack_wall *w)
{
    int left = w->stock->stones - w->laid;
    if (left > 0 && w->laid < w->options.most) return 0;
    snprintf(w->message, sizeof w->message, "%s", left == 0 ?
             "every stone of the stock is laid" :
             "as many stones as asked for are laid");
    return 1;
}

static void stack_give_up(struct stack_wall *w)
{
    snprintf(w->message, sizeof w->message, "none of the %d stones that are "
             "left finds a place in the frame where it stands",
             w->stock->stones - w->laid);
}

/* ---- Search: one wall by the filters ------------------------------------- */

/* Where so many candidates that stand are not raised or move, none is laid. */
enum { STACK_TRIES = 128 };

/* What the filters choose of the candidates that stack_holds(); -1: none. */
STACK_API int stack_choose(struct stack_wall *w, struct stack_list *list)
{
    for (int i = 0; i < STACK_TRIES; i++) {
        int best = stack_filter(w, list);
        if (best < 0 || stack_holds(w, &list->one[best])) return best;
        stack_strike(list, best);
    }
    return -1;
}

/* Chooses and lays one stone, of the next or of all that are left. Returns 1
   where it is laid, 0 where none can be, -1 where memory is lacking. */
static int stack_step(struct stack_wall *w, struct stack_search *s)
{
    const double share = s->retreats > 0 ? 0.5 : 1;
    int best = -1;
    for (int all = 0; all < 2 && best < 0; all++) {
        if (stack_propose(w, &s->list, share, &s->chance, all)) return -1;
        best = stack_choose(w, &s->list);
    }
    return best >= 0 && !stack_lay(w, &s->list.one[best].place);
}

/* Are all stones laid that are wanted? Where a number is asked for they must
   also stay in the last look. */
static int stack_is_done(struct stack_wall *w)
{
    return stack_ends(w) && (!stack_asked(w) || stack_rests(w));
}

/* Takes stones off again, more from time to time, so that it can go on
   otherwise: returns 1. Where that does not pay it leaves the longest wall and
   returns 0, or -1 where this cannot be laid again. */
static int stack_retreat(struct stack_wall *w, struct stack_search *s)
{
    enum { RETREATS = 20 };
    int bad = 0, off;
    if (w->laid > s->keep) stack_keep(w, s);
    if (!stack_asked(w) || s->retreats == RETREATS) {
        if (w->laid < s->keep) bad = stack_restore(w, s->kept, s->keep);
        stack_give_up(w);
        return bad;
    }
    off = 2 * ++s->retreats;
    stack_cut(w, w->laid > off ? w->laid - off : 0);
    return 1;
}

/* Builds a wall by the filters. Where a number of stones is asked for and there
   is no place for the next one, or they do not stay in the last look, it
   retreats and goes on with half of the candidates, by chance. Returns 0, or -1
   where memory is lacking; w->message says why it ended. */
STACK_API int stack_build(struct stack_wall *w)
{
    struct stack_search s;
    int goes_on = stack_search_open(w, w->options.seed + 1, &s) ? -1 : 1;
    while (goes_on > 0 && !stack_is_done(w)) {
        if (w->options.progress) w->options.progress(w, 1);
        goes_on = stack_ends(w) ? 0 : stack_step(w, &s);
        if (goes_on == 0) goes_on = stack_retreat(w, &s);
    }
    stack_search_free(&s);
    return goes_on < 0 ? -1 : 0;
}

/* ---- Search: `best`, many walls by a cost -------------------------------- */

/* The most (sign 1) or least (-1) of every k neighbours in a[0..n), where what
   is beside them is `beyond`: out[i] is that of the k that end at i. */
static void stack_windows(const double *a, int n, int k, double sign,
                          double beyond, double *out)
{
    int at = -k; /* of the extreme */
    double best = 0;
    for (int i = 0; i < n + k - 1; i++) {
        int first = i - k + 1, from = at < first ? first : i;
        if (at < first) best = -HUGE_VAL;
        for (int j = from; j <= i; j++) {
            double v = sign * (j < 0 || j >= n ? beyond : a[j]);
            if (v < best) continue;
            best = v;
            at = j;
        }
        out[i] = sign * best;
    }
}

/* The sky with notches narrower than k columns filled: for every column the
   least, over the windows that hold it, of the highest in the window. What is
   beside the frame is as high as can be. */
static void stack_close(const double *sky, int n, int k, double *room,
                        double *out)
{
    stack_windows(sky, n, k, 1, HUGE_VAL, room);
    stack_windows(room, n + k - 1, k, -1, HUGE_VAL, out);
}

/* Area that a candidate takes and does not fill: what the closed sky rises by
   over it, within the frame, less the stone. */
static double stack_dead(const struct stack_wall *w, const struct stone *s,
                         double inside, int k, const struct stack_skies *r)
{
    const double top = w->options.height;
    int from = stack_column(w, s->low.x) - 2 * k, n;
    int to = stack_column(w, s->high.x) + 2 * k;
    double sum = 0;
    if (from < 0) from = 0;
    if (to > w->columns) to = w->columns;
    n = to - from;
    for (int i = 0; i < n; i++) {
        double low, high;
        r->now[i] = r->then[i] = w->sky[from + i];
        if (stack_sides(s, stack_column_x(w, from + i), &low, &high))
            r->then[i] = fmax(high, r->now[i]);
    }
    stack_close(r->now, n, k, r->room, r->closed[0]);
    stack_close(r->then, n, k, r->room, r->closed[1]);
    for (int i = 0; i < n; i++)
        sum += fmin(r->closed[1][i + k - 1], top)
             - fmin(r->closed[0][i + k - 1], top);
    return sum * w->options.width / w->columns - inside;
}

static int stack_compare(const void *a, const void *b)
{
    double x = ((const struct stack_candidate *)a)->cost;
    double y = ((const struct stack_candidate *)b)->cost;
    return (x > y) - (x < y);
}

/* A fixed cost for each fault, whatever the weights: a stone without a bed, a
   long one on end, a joint that runs on. */
static double stack_fault(const struct stack_candidate *c)
{
    const double fault = 0.5, bond = 0.15;
    return fault * ((c->bed < masonry_point) + (c->upright != 0) +
                    (c->feature[STACK_BOND] < bond));
}

/* What a stone at a side of the frame has more than the mean area, as a share
   of that. More is better: ends of courses hold what is between. */
static double stack_end(const struct stack_wall *w, const struct stone *s)
{
    const double side = 0.1 * w->stock->size;
    return s->low.x < side || s->high.x > w->options.width - side
           ? s->area / w->stock->area - 1 : 0;
}

/* What a candidate costs before kern is asked; `low` is the lowest sky. */
static double stack_cost(const struct stack_wall *w,
                         const struct stack_candidate *c, double low,
                         const struct stack_weights *g,
                         const struct stack_skies *r)
{
    const double size = w->stock->size;
    const int k = (int)(g->notch * STACK_COLUMNS);
    struct stone s = stack_placed(w, &c->place);
    return stack_dead(w, &s, c->inside, k, r) / (size * size)
         + g->height * (s.high.y - low) / size
         - g->slope * c->feature[STACK_SLOPE]
         - g->bond * c->feature[STACK_BOND]
         - g->edges * c->feature[STACK_EDGES]
         - g->bed * fmin(c->bed, 1) + g->step * c->step
         - g->end * stack_end(w, &s) + stack_fault(c);
}

/* The candidate of least cost that may be laid; -1: none. The load factor is
   weighed among the cheapest that stand. */
static int stack_pick(struct stack_wall *w, struct stack_search *s,
                      const struct stack_weights *g)
{
    struct stack_list *list = &s->list;
    const int ask = w->options.goal == STACK_LOAD ? 8 : 1;
    int stand = 0;
    double low = HUGE_VAL;
    for (int i = 0; i < w->columns; i++) low = fmin(low, w->sky[i]);
    for (int i = 0; i < list->count; i++)
        list->one[i].cost = stack_cost(w, &list->one[i], low, g, &s->skies)
                          + g->noise * random_uniform(&s->chance, 0, 1);
    if (list->count == 0) return -1;
    qsort(list->one, (size_t)list->count, sizeof *list->one, stack_compare);
    for (int from = 0; from < list->count; from += stand) {
        stand = 0;
        for (int i = from; i < list->count && stand < ask; i++) {
            struct stack_candidate c = list->one[i];
            if (!stack_ask(w, &c)) continue;
            c.cost -= g->stable * c.stable;
            list->one[i] = list->one[from + stand];
            list->one[from + stand++] = c;
        }
        if (stand == 0) break;
        qsort(list->one + from, (size_t)stand, sizeof *list->one,
              stack_compare);
        for (int i = from; i < from + stand; i++)
            if (stack_holds(w, &list->one[i])) return i;
    }
    return -1;
}

/* Builds on what is there. Where none of the next stones has a place, one of
   all that are left may. */
static int stack_grow(struct stack_wall *w, struct stack_search *s,
                      const struct stack_weights *g)
{
    int bad = 0;
    while (!bad && !stack_ends(w)) {
        int best = -1;
        if (w->options.progress) w->options.progress(w, w->walls + 1);
        for (int all = 0; all < 2 && best < 0 && !bad; all++) {
            w->lie = !all || w->upright + 1 > stack_soldiers * (w->laid + 1);
            bad = stack_propose(w, &s->list, g->share, &s->chance, all);
            if (!bad) best = stack_pick(w, s, g);
        }
        if (!bad && (best < 0 || stack_lay(w, &s->list.one[best].place))) {
            stack_give_up(w);
            break;
        }
    }
    return bad;
}

/* So much more filling than in stack_worth() is worth the same to `best`: else
   it would build walls that are low. */
static const double stack_more = 0.04;

/* The limit multiplier times what the filling is worth. A wall without a limit is
   worth less than any that has one. What is to be exceeded counts little more
   once it is. */
static double stack_value_of_load(struct stack_wall *w)
{
    const double enough = 1.05, *beat = w->options.beat;
    double fill = stack_fill(w);
    double limit = stack_limit(&w->plan.task, w->plan.contact);
    if (limit < 0) limit = 1e-3 * w->m.margin / w->stock->size;
    if (beat[0] > 0 && fill > beat[0] && limit > beat[1])
        return 1 + fmin(fill / beat[0], limit / beat[1]);
    if (beat[0] > 0) {
        fill = fmin(fill, enough * beat[0]);
        limit = fmin(limit, enough * beat[1]);
    }
    return limit * stack_worth(fill);
}

/* What of a wall is as masons want it, 0 to 1: filled, its joints crossed, its
   long stones lying, every stone on a bed. */
static double stack_value_of_masonry(const struct stack_wall *w)
{
    struct masonry m;
    if (masonry_of(&w->plan.task.s, w->stock->size, &m)) return 0;
    return stack_worth(stack_fill(w) - stack_more)
         * fmin(1, 0.7 + 3 * (m.joint - 1)) * (1 - m.upright) * (1 - m.bedless);
}

/* What `best` wants to be high. A wall that lacks stones that were asked for is
   worth less than any that has them. It is not shaken where its value could not
   be more than `most`. */
static double stack_value(struct stack_wall *w, double most)
{
    double worth;
    if (stack_asked(w) && w->laid < w->options.most)
        return w->laid - w->options.most;
    if (w->options.goal == STACK_LOAD) return stack_value_of_load(w);
    worth = stack_value_of_masonry(w);
    if (w->options.goal == STACK_DROP)
        return worth * fmax(0, stack_predicted_level(w));
    return worth * stack_endured_high > most
           ? worth * stack_endured_level(w, most / worth) : 0;
}

static double stack_between(uint64_t *chance, double low, double high)
{
    return low * pow(high / low, random_uniform(chance, 0, 1));
}

static struct stack_weights stack_weigh(const struct stack_options *o,
                                        uint64_t *chance)
{
    struct stack_weights g;
    g.notch = random_uniform(chance, 1.15, 1.75);
    g.height = stack_between(chance, 0.4, 2);
    g.stable = stack_between(chance, 0.01, 0.3);
    g.slope = stack_between(chance, 0.02, 0.5);
    g.bond = stack_between(chance, 0.1, 1);
    g.edges = stack_between(chance, 0.02, 0.5);
    g.bed = stack_between(chance, 0.15, 0.9);
    g.step = stack_between(chance, 0.2, 1.2);
    g.end = stack_between(chance, 0.15, 1);
    g.noise = stack_between(chance, 0.005, 0.1);
    g.share = random_uniform(chance, 0.15, 0.6);
    if (o->goal == STACK_LOAD) g.share = fmin(1, 2 * g.share);
    return g;
}

/* Weights like others, each by a factor of 1.5 at the most. */
static struct stack_weights stack_vary(struct stack_weights g, uint64_t *chance)
{
    double *one[] = { &g.height, &g.stable, &g.slope, &g.bond, &g.edges,
                      &g.bed, &g.step, &g.end, &g.noise, &g.share };
    for (size_t i = 0; i < sizeof one / sizeof one[0]; i++)
        *one[i] *= exp(random_uniform(chance, -0.4, 0.4));
    g.notch = fmin(1.85, fmax(0.9, g.notch + random_uniform(chance, -0.1, 0.1)));
    return g;
}

/* Was the effort spent? A wall has more candidates where more stones may be the
   next one: the limit grows with these. */
static int stack_spent(const struct stack_wall *w)
{
    const struct stack_options *o = &w->options;
    const double share = fmin(2, fmax(1, (double)o->look / STACK_LOOK));
    return o->effort > 0 && (double)w->tried + (double)w->asked +
                            STACK_SWAY * (double)w->swayed > share * o->effort;
}

/* Builds one more wall: from the ground, or by taking stones off the best one
   and going on differently, more often than not with weights like those that
   made it. Keeps it where it is the best so far. Returns 0, or -1. */
static int stack_next_wall(struct stack_wall *w, struct stack_search *s,
                           int fresh)
{
    struct stack_weights g = stack_weigh(&w->options, &s->chance);
    double value;
    int from = 0;
    if (!fresh) {
        from = (int)random_uniform(&s->chance, 0, s->keep - 1);
        if (random_uniform(&s->chance, 0, 1) < 0.6)
            g = stack_vary(s->good, &s->chance);
    }
    if (stack_restore(w, s->kept, from) || stack_grow(w, s, &g)) return -1;
    value = stack_value(w, s->value);
    if (value > s->value) {
        s->value = value;
        s->good = g;
        stack_keep(w, s);
    }
    return 0;
}

/* Builds one wall after the other, the first quarter from the ground, and leaves
   the best. Returns 0, or -1 where memory is lacking. */
STACK_API int stack_best(struct stack_wall *w)
{
    const struct stack_options *o = &w->options;
    struct stack_search s;
    int bad = stack_search_open(w, random_start(o->seed), &s);
    for (w->walls = 0; w->walls < o->walls && !bad && !stack_spent(w);
         w->walls++)
        bad = stack_next_wall(w, &s, s.keep == 0 || w->walls < o->walls / 4);
    bad = bad || stack_restore(w, s.kept, s.keep);
    if (!stack_ends(w)) stack_give_up(w);
    stack_search_free(&s);
    return bad ? -1 : 0;
}

/* Takes off the last stones, a few at the most, so that what is left stays in the
   last look: what a stone does to a wall may show late. Where it takes more, all
   are left. Returns 0, or -1 where memory is lacking. */
STACK_API int stack_finish(struct stack_wall *w)
{
    enum { FEW = 6 };
    struct stack_wall part = *w;
    while (part.laid > 0 && !stack_rests(&part))
        if (--part.laid < w->laid - FEW) return 0;
    if (part.laid == w->laid) return 0;
    stack_give_up(&part);
    memcpy(w->message, part.message, sizeof w->message);
    return stack_restore(w, w->place, part.laid);
}

/* Builds a wall with the planner of the options. Returns 0, or -1 where memory
   is lacking. */
STACK_API int stack_plan(struct stack_wall *w)
{
    const int bad = w->options.planner == STACK_BEST ? stack_best(w)
                                                     : stack_build(w);
    return bad ? bad : stack_finish(w);
}

/* ---- Output -------------------------------------------------------------- */

/* Writes it in the text format, every digit: stones that were laid corner to
   corner touch or do not by the last of them. Returns 0, or -1. */
STACK_API int stack_write(const struct stack_wall *w, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out) return -1;
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
              w->options.height * v->scale, "fill=\"none\" stroke=\"" DRAW_EDGE
              "\" stroke-width=\"0.8\" stroke-dasharray=\"5 4\"");
}

STACK_API void stack_draw_stone(const struct stack_wall *w,
                                const struct draw_view *v, int i)
{
    const int fills = (int)(sizeof draw_stone / sizeof draw_stone[0]);
    char style[120];
    snprintf(style, sizeof style, "fill=\"%s\" stroke=\"" DRAW_EDGE "\" "
             "stroke-width=\"0.9\" stroke-linejoin=\"round\"",
             draw_stone[i % fills]);
    draw_block(v, &w->plan.task.s.block[i + 1], NULL, 0, style);
}

#endif /* STACK_H */
