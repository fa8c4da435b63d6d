/* stack.h - a planner that builds a wall of irregular stones, for the example
   programs.

   A step: several of the next stones are let down, in several turns, at several
   places, and slid against what is beside them (candidates). A hierarchy of
   filters then keeps the good ones; each is a number and a threshold, see
   stack_filter. The kern filter predicts the level of the wall with each
   candidate, by a plan of the wall, and drops those below the mean. Of what is
   left the planner takes the candidate with most of the first feature, if it
   also stays there by kern_plan_stays(): a stone may slide although forces
   exist that would hold it.

   Features and hierarchy are those that the heuristic planner of V. Thangavelu,
   Y. Liu, M. Saboia and N. Napp (Dry stacking for automated construction with
   irregular objects, ICRA 2018) is described with; the kern filter is that of
   Y. Liu, M. Saboia, V. Thangavelu and N. Napp (Approximate Stability Analysis
   for Drystacked Structures, IROS 2019). The formulas beside the functions say
   what is meant here.

   The planners: `heuristic` has no kern filter, `combined` has. `best` builds
   several walls, see stack_best(), as a mason does: in courses from the left,
   each stone where the lowest course is open, by a cost of beds on two stones,
   level faces, and tops on which the next stone finds two beds. A stone is laid
   where the wall stands tilted to either side, if there is such a place. It may
   dress a stone level, and keeps small ones back as pins. All planners take
   poses from kern_rest(), and take the last stones off again until the finished
   wall stays in the simulator, see stack_finish(). Before that they ask
   kern_plan_stays() alone.

   stack_wall.h has the options, the wall and the features, stack_place.h the
   candidates, what may be laid and the last look, stack_pin.h pins; this file
   has the filters and the search. The same input gives the same wall.

   SPDX-License-Identifier: MIT */

#ifndef STACK_H
#define STACK_H

#include "../parts/random.h"
#include "masonry.h"
#include "stack_pin.h"
#include "stack_place.h"
#include "stack_wall.h"
#include "stones.h"

/* ---- Filters ------------------------------------------------------------- */

static int stack_is_filler(const struct stack_wall *w,
                           const struct stack_candidate *c)
{
    return w->stock->stone[c->place.stone].area < stack_filler * w->stock->area;
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
        if (list->one[i].feature[feature]
            < best - w->options.threshold[feature])
            list->one[i].out = 1;
}

/* The level of the wall with a candidate; 0 where the stone has no bed: its
   lone points would shrink first. */
static int stack_level_of(const struct stack_candidate *c)
{
    return c->bed.beds == 0 ? 0 : c->m.level;
}

/* Drops candidates whose level is below the mean, but for fillers. */
static void stack_sift_levels(const struct stack_wall *w,
                              struct stack_list *list)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out && !stack_is_filler(w, &list->one[i])) {
            sum += stack_level_of(&list->one[i]);
            count++;
        }
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out && !stack_is_filler(w, &list->one[i])
            && (double)stack_level_of(&list->one[i]) * count < sum)
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
        if (list->one[i].out || list->one[i].known
            || stack_ask(w, &list->one[i]))
            continue;
        stack_strike(list, i--);
        fell++;
    }
    return fell;
}

/* Of what the filters left, the candidate with the longest common edges; -1:
   none is left. */
static int stack_most_edges(const struct stack_list *list)
{
    int best = -1;
    for (int i = 0; i < list->count; i++)
        if (!list->one[i].out
            && (best < 0
                || list->one[i].feature[STACK_EDGES]
                       > list->one[best].feature[STACK_EDGES]))
            best = i;
    return best;
}

/* What all filters leave, and of this the candidate with the longest common
   edges; -1: none stands. Filters see only what stands: where some of those
   that they left fall, they begin again without these. */
static int stack_filter(struct stack_wall *w, struct stack_list *list)
{
    const int levels = w->options.planner == STACK_HEURISTIC
                         ? -1
                         : w->options.levels;
    int k = 0;
    while (k <= STACK_FILTERS) {
        if (k == 0)
            for (int i = 0; i < list->count; i++)
                list->one[i].out = 0;
        if ((k == levels || k == STACK_FILTERS)
            && stack_drop_falling(w, list) > 0) {
            k = 0;
            continue;
        }
        if (k == levels)
            stack_sift_levels(w, list);
        if (k < STACK_FILTERS)
            stack_sift(w, list, k);
        k++;
    }
    return stack_most_edges(list);
}

/* ---- Search: what both kinds need ---------------------------------------- */

/* How `best` builds a wall: the cost of a candidate is a weighted sum. Areas are
   in squares of a stone's size, lengths in sizes. */
struct stack_weights {
    double notch;  /* narrower ones are dead, sizes               */
    double height; /* of the top of a stone, against a dead area  */
    double stable; /* a load factor of 1/20, where that is the goal */
    double slope, bond, edges; /* the features                             */
    double bed, step;          /* length of beds; unevenness of a course      */
    double end;                /* area of what ends a course                  */
    double one;                /* a stone that has no two beds                */
    double match;              /* a side on which the next one may have two   */
    double tilt;               /* at which the wall stands, as a tangent      */
    double noise;
    double course; /* height of a course that is being laid, sizes */
    double share;  /* of the candidates that are looked at        */
};

/* Room for the skies that a cost compares. */
struct stack_skies {
    double *then, *room, *closed[2];
};

struct stack_search {
    struct stack_list list;       /* candidates for the next stone          */
    struct stack_candidate leans; /* the cheapest that falls tilted      */
    uint64_t chance;              /* state of the random numbers            */
    struct stack_place *kept;     /* the stones of the best wall so far     */
    int keep;                     /* how many these are                     */
    int retreats;                 /* of stack_build()                       */
    struct stack_skies skies;     /* the rest is for `best`                 */
    double value;                 /* of the best wall, and how it was built */
    struct stack_weights good;
};

/* Returns 0, or -1 where memory is lacking; stack_search_free() either way. */
static int stack_search_open(const struct stack_wall *w, uint64_t chance,
                             struct stack_search *s)
{
    static const struct stack_search empty;
    const size_t n = (size_t)w->columns + 6 * STACK_COLUMNS; /* stack_close() of
                                                          notches below 2 sizes */
    *s = empty;
    s->chance = chance;
    s->value = -HUGE_VAL;
    s->kept = malloc((size_t)w->stock->stones * sizeof *s->kept);
    s->skies.then = malloc(4 * n * sizeof *s->skies.then);
    if (!s->kept || !s->skies.then)
        return -1;
    s->skies.room = s->skies.then + n;
    s->skies.closed[0] = s->skies.room + n;
    s->skies.closed[1] = s->skies.closed[0] + n;
    return 0;
}

static void stack_search_free(struct stack_search *s)
{
    free(s->list.one);
    free(s->kept);
    free(s->skies.then);
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
        const int stone = w->place[--w->laid].stone;
        w->pins -= stack_keeps_back(w, stone);
        w->used[stone] = 0;
        w->filled -= stone_area_in(&w->stone[w->laid], w->options.width,
                                   w->options.height);
        kern_plan_remove(&w->plan, w->laid + 1);
    }
    stack_clear_sky(w);
    for (int i = 0; i < w->laid; i++)
        stack_raise(w, i);
}

/* Takes all stones off and lays others. Returns 0, or -1. */
static int stack_restore(struct stack_wall *w, const struct stack_place *place,
                         int laid)
{
    int bad = 0;
    stack_cut(w, 0);
    for (int i = 0; i < laid && !bad; i++)
        bad = stack_lay(w, &place[i]);
    return bad;
}

/* Is every stone laid that is wanted? Notes this as why the wall ended. */
static int stack_ends(struct stack_wall *w)
{
    const int left = stack_left(w);
    if (left > 0 && w->laid - w->pins < w->options.most)
        return 0;
    snprintf(w->message, sizeof w->message, "%s",
             left == 0 ? "every stone of the stock is laid"
                       : "as many stones as asked for are laid");
    return 1;
}

static void stack_give_up(struct stack_wall *w)
{
    snprintf(w->message, sizeof w->message,
             "none of the %d stones that are "
             "left finds a place in the frame where it stands",
             stack_left(w));
}

/* ---- Search: one wall by the filters ------------------------------------- */

/* Where so many candidates that stand do not stay, none is laid; the
   second is for `best`, where a few stones may be the next one. */
enum { STACK_TRIES = 128, STACK_FEW_TRIES = 16 };

/* What the filters choose of the candidates that stack_holds(); -1: none. */
STACK_API int stack_choose(struct stack_wall *w, struct stack_list *list)
{
    for (int i = 0; i < STACK_TRIES; i++) {
        int best = stack_filter(w, list);
        if (best < 0 || stack_holds(w, &list->one[best]))
            return best;
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
        if (stack_propose(w, &s->list, share, &s->chance, all))
            return -1;
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
    if (w->laid > s->keep)
        stack_keep(w, s);
    if (!stack_asked(w) || s->retreats == RETREATS) {
        if (w->laid < s->keep)
            bad = stack_restore(w, s->kept, s->keep);
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
        if (w->options.progress)
            w->options.progress(w, 1);
        goes_on = stack_ends(w) ? 0 : stack_step(w, &s);
        if (goes_on == 0)
            goes_on = stack_retreat(w, &s);
    }
    stack_search_free(&s);
    return goes_on < 0 ? -1 : 0;
}

/* ---- Search: `best`, many walls by a cost -------------------------------- */

/* The most (sign 1) or least (-1) of every k neighbours in a[0..n), where what
   is beside them is `beyond`: out[i] is that of the k that end at i, of windows
   whose width is doubled. `out` has room for n + 2 k. */
static void stack_windows(const double *a, int n, int k, double sign,
                          double beyond, double *out)
{
    const int all = n + 2 * k - 2;
    int wide = 1;
    for (int i = 0; i < all; i++)
        out[i] = sign * beyond;
    for (int i = 0; i < n; i++)
        out[i + k - 1] = sign * a[i];
    for (; 2 * wide <= k; wide *= 2)
        for (int i = 0; i + wide < all; i++)
            out[i] = rigid_most(out[i], out[i + wide]);
    for (int i = 0; i < n + k - 1; i++)
        out[i] = sign * rigid_most(out[i], out[i + k - wide]);
}

/* The sky with notches narrower than k columns filled: for every column the
   least, over the windows that hold it, of the highest in the window. What is
   beside the frame is as high as can be. out[i + k - 1] is that of column i; it
   has room for n + 3 k. */
static void stack_close(const double *sky, int n, int k, double *room,
                        double *out)
{
    stack_windows(sky, n, k, 1, HUGE_VAL, room);
    stack_windows(room, n + k - 1, k, -1, HUGE_VAL, out);
}

/* Area that a candidate takes and does not fill: what the closed sky rises by
   over it, within the frame, less the stone. r->closed[0] is the sky before,
   closed. */
static double stack_dead(const struct stack_wall *w, const struct stone *s,
                         double inside, int k, const struct stack_skies *r)
{
    const double top = w->options.height;
    int from = stack_column(w, s->low.x) - 2 * k;
    int to = stack_column(w, s->high.x) + 2 * k, n, left = k, right = k;
    double sum = 0;
    if (from < 0)
        from = left = 0;
    if (to > w->columns) {
        to = w->columns;
        right = 0;
    }
    n = to - from;
    for (int i = 0; i < n; i++) {
        double low, high;
        r->then[i] = w->sky[from + i];
        if (stack_sides(s, stack_column_x(w, from + i), &low, &high))
            r->then[i] = rigid_most(high, r->then[i]);
    }
    stack_close(r->then, n, k, r->room, r->closed[1]);
    for (int i = left; i < n - right; i++) /* beyond, nothing has changed */
        sum += rigid_least(r->closed[1][i + k - 1], top)
             - rigid_least(r->closed[0][from + i + k - 1], top);
    return sum * w->options.width / w->columns - inside;
}

static int stack_compare(const void *a, const void *b)
{
    double x = ((const struct stack_candidate *)a)->cost;
    double y = ((const struct stack_candidate *)b)->cost;
    return (x > y) - (x < y);
}

/* Does a stone end a course at a side of the frame: less than so many sizes from
   it? */
static int stack_at_side(const struct stack_wall *w, const struct stone *s,
                         double sizes)
{
    const double side = sizes * w->stock->size;
    return s->low.x < side || s->high.x > w->options.width - side;
}

/* Does a stone end the wall to a side (-1 left, 1 right) at its own height: none
   lies beyond it, and hardly one fits? */
static int stack_is_end(const struct stack_wall *w, const struct stone *s,
                        int side)
{
    const double fits = 1.2 * w->stock->size;
    if ((side < 0 ? s->low.x : w->options.width - s->high.x) > fits)
        return 0;
    for (int i = 0; i < w->laid; i++) {
        const struct stone *t = &w->stone[i];
        if (side * (t->centre.x - s->centre.x) > 0 && t->low.y < s->centre.y
            && s->centre.y < t->high.y
            && !stack_keeps_back(w, w->place[i].stone))
            return 0;
    }
    return 1;
}

/* Of the stones at an end of the wall that carry each other alone below a stone
   that block `alone` carries: how many there are beyond the first, without one
   that rests on two itself. */
static int stack_column_of(const struct stack_wall *w, const struct stone *s,
                           int alone)
{
    int most = 1;
    for (int side = -1; side < 2; side += 2) {
        const struct stone *t = s;
        int below = 0, k = alone;
        while (k > 0 && stack_is_end(w, t, side)) {
            const struct masonry_rest r = masonry_rest_on(&w->plan.task.s, k,
                                                          w->stock->size);
            if (r.stones > 1)
                break;
            t = &w->stone[k - 1];
            below += stack_is_end(w, t, side);
            k = r.ground ? MASONRY_NONE : r.below;
        }
        if (below > most)
            most = below;
    }
    return most - 1;
}

/* Would a stone of less than a third of the mean area lie in the foundation?
   None is laid there. */
static int stack_founds_badly(const struct stack_wall *w,
                              const struct stack_place *place)
{
    const double small = 1.0 / 3;
    const struct stone s = stack_placed(w, place);
    return s.low.y < masonry_step * w->stock->size
        && s.area < small * w->stock->area;
}

/* A fixed cost for each fault, whatever the weights: a stone without a bed, one
   whose longest face is off level, each corner, a joint that runs on, and every
   stone beyond two of a column at an end of the wall. */
static double stack_fault(const struct stack_wall *w, const struct stone *s,
                          const struct stack_candidate *c)
{
    const double bedless = 4, off = 3, corner = 0.2, runs = 0.4;
    const double bond = 0.15, column = 1;
    return bedless * (c->bed.beds == 0) + off * c->off + corner * c->bed.corners
         + runs * (c->feature[STACK_BOND] < bond)
         + column * stack_column_of(w, s, c->bed.alone);
}

/* What a stone at a side of the frame has more than the mean area, as a share
   of that. More is better: ends of courses hold what is between. */
static double stack_end(const struct stack_wall *w, const struct stone *s)
{
    return stack_at_side(w, s, 0.1) ? s->area / w->stock->area - 1 : 0;
}

/* Returns 1 if a stone has one bed where it could have two. Where courses end,
   every other one ends so. */
static int stack_on_one(const struct stack_wall *w, const struct stone *s,
                        const struct stack_candidate *c)
{
    return c->bed.beds < 2 && !c->bed.ground && !stack_at_side(w, s, 0.1);
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
         - g->slope * c->feature[STACK_SLOPE] - g->bond * c->feature[STACK_BOND]
         - g->edges * c->feature[STACK_EDGES] - g->bed * fmin(c->bed.length, 1)
         - g->match * c->matches + g->step * c->step - g->end * stack_end(w, &s)
         + g->one * stack_on_one(w, &s, c) + stack_fault(w, &s, c);
}

static int stack_tries(const struct stack_wall *w)
{
    return w->options.look > STACK_LOOK ? STACK_TRIES : STACK_FEW_TRIES;
}

/* Moves the cheapest candidates from `from` on that stand to the places from
   there on, at most `most`, and sorts them by cost less what their load factor
   is worth. Returns how many. */
static int stack_gather(struct stack_wall *w, struct stack_list *list, int from,
                        int most, const struct stack_weights *g)
{
    int stand = 0;
    for (int i = from; i < list->count && stand < most; i++) {
        struct stack_candidate c = list->one[i];
        if (c.out)
            continue;
        if (stack_founds_badly(w, &c.place) || !stack_ask(w, &c)) {
            list->one[i].out = 1;
            continue;
        }
        c.cost -= g->stable * c.stable;
        list->one[i] = list->one[from + stand];
        list->one[from + stand++] = c;
    }
    qsort(list->one + from, (size_t)stand, sizeof *list->one, stack_compare);
    return stand;
}

/* So many candidates that fall when tilted are passed over. */
enum { STACK_LEANING = 12 };

/* Returns the candidate of least cost that may be laid and does not fall when
   the wall is tilted. Where none is found the cheapest that may be laid is
   returned; -1: there is none. */
static int stack_pick(struct stack_wall *w, struct stack_search *s,
                      struct stack_weights g)
{
    struct stack_list *list = &s->list;
    const int ask = w->options.goal == STACK_LOAD ? 8 : 1;
    const int most = stack_tries(w);
    int stand = 1, tries = 0, leaning = 0;
    double low = HUGE_VAL;
    for (int i = 0; i < w->columns; i++)
        low = fmin(low, w->sky[i]);
    stack_close(w->sky, w->columns, (int)(g.notch * STACK_COLUMNS),
                s->skies.room, s->skies.closed[0]);
    for (int i = 0; i < list->count; i++)
        list->one[i].cost = stack_cost(w, &list->one[i], low, &g, &s->skies)
                          + g.noise * random_uniform(&s->chance, 0, 1);
    if (list->count == 0)
        return -1;
    qsort(list->one, (size_t)list->count, sizeof *list->one, stack_compare);
    for (int from = 0; stand > 0 && tries < most && leaning < STACK_LEANING;
         from += stand) {
        stand = stack_gather(w, list, from, ask, &g);
        for (int i = from; i < from + stand; i++, tries++) {
            if (!stack_holds(w, &list->one[i]))
                continue;
            if (stack_tilts(w, &list->one[i], g.tilt))
                return i;
            if (leaning++ == 0)
                s->leans = list->one[i];
        }
    }
    if (leaning == 0)
        return -1;
    list->one[0] = s->leans;
    return 0;
}

/* Builds on what is there. Where none of the next stones has a place, one of
   all that are left may. */
static int stack_grow(struct stack_wall *w, struct stack_search *s,
                      const struct stack_weights *g)
{
    int bad = 0;
    while (!bad && !stack_ends(w)) {
        int best = -1;
        if (w->options.progress)
            w->options.progress(w, w->walls + 1);
        for (int all = 0; all < 2 && best < 0 && !bad; all++) {
            w->course = all ? HUGE_VAL : g->course;
            w->lie = !all;
            bad = stack_propose(w, &s->list, g->share, &s->chance, all);
            if (!bad)
                best = stack_pick(w, s, *g);
        }
        if (!bad && (best < 0 || stack_lay(w, &s->list.one[best].place))) {
            stack_give_up(w);
            break;
        }
    }
    return bad;
}

/* So much more filling than in stack_worth() is worth the same to `best`: else
   it would build walls that are low. A stock that cannot fill as much as is
   enough is measured by what it can: else a stone that rises above the frame
   would count for more than what the wall endures. */
static const double stack_more = 0.08, stack_enough = 0.80;

static double stack_worth_of_filling(const struct stack_wall *w)
{
    const struct stack_options *o = &w->options;
    const int stones = w->stock->stones - w->stock->pins;
    const double all = w->stock->area * (o->most < stones ? o->most : stones)
                     / (o->width * o->height);
    return stack_worth(stack_fill(w) + fmax(0, stack_enough - all)
                       - stack_more);
}

/* The limit multiplier times what the filling is worth. A wall without a limit is
   worth less than any that has one. What is to be exceeded counts little more
   once it is. */
static double stack_value_of_load(struct stack_wall *w)
{
    const double enough = 1.05, *beat = w->options.beat;
    double fill = stack_fill(w);
    double limit = stack_limit(&w->plan.task, w->plan.contact);
    if (limit < 0)
        limit = 1e-3 * w->m.margin / w->stock->size;
    if (beat[0] > 0 && fill > beat[0] && limit > beat[1])
        return 1 + fmin(fill / beat[0], limit / beat[1]);
    if (beat[0] > 0) {
        fill = fmin(fill, enough * beat[0]);
        limit = fmin(limit, enough * beat[1]);
    }
    return limit * stack_worth(fill);
}

/* What of a wall is as masons want it, more than 0: filled, its faces level, every
   stone on a bed, and to a lesser part many on two, no joint through three
   courses and no column at either end. */
static double stack_value_of_masonry(const struct stack_wall *w)
{
    const double runs = 0.7, columns = 0.4, two = 3;
    struct masonry m;
    if (masonry_count(&w->plan.task.s, w->stock->size, &m))
        return 0;
    return stack_worth_of_filling(w) * pow(1 - m.off_level, 3)
         * pow(1 - m.bedless, 3) * (1 + two * m.on_two)
         * (1 - columns * m.end_columns) * pow(runs, m.running);
}

/* Returns the value of what a wall withstands: the predicted level of collapse,
   which counts contacts that the first rocking closes, and the load factor of
   the contacts that are closed. The cube weighs about as much as masonry. */
static double stack_value_of_shaking(struct stack_wall *w)
{
    const double level = stack_predicted_level(w)
                       + stack_levels_a_load * stack_load(w);
    return level > 0 ? level * level * level : 0;
}

/* What `best` wants to be high. A wall that lacks stones that were asked for is
   worth less than any that has them. */
static double stack_value(struct stack_wall *w)
{
    if (stack_asked(w) && w->laid - w->pins < w->options.most)
        return w->laid - w->pins - w->options.most;
    if (w->options.goal == STACK_LOAD)
        return stack_value_of_load(w);
    return stack_value_of_masonry(w) * stack_value_of_shaking(w);
}

/* Weights that a search multiplies, and between what it draws them first. */
static const struct {
    size_t at;
    double low, high;
} stack_factors[] = {{offsetof(struct stack_weights, height), 0.4, 2},
                     {offsetof(struct stack_weights, stable), 0.01, 0.3},
                     {offsetof(struct stack_weights, slope), 0.02, 0.5},
                     {offsetof(struct stack_weights, bond), 0.1, 1},
                     {offsetof(struct stack_weights, edges), 0.02, 0.5},
                     {offsetof(struct stack_weights, bed), 0.15, 0.9},
                     {offsetof(struct stack_weights, step), 0.2, 1.2},
                     {offsetof(struct stack_weights, end), 0.15, 1},
                     {offsetof(struct stack_weights, one), 0.8, 3},
                     {offsetof(struct stack_weights, match), 2, 10},
                     {offsetof(struct stack_weights, tilt), 0.1, 0.3},
                     {offsetof(struct stack_weights, noise), 0.005, 0.1}};
enum { STACK_FACTORS = sizeof stack_factors / sizeof stack_factors[0] };

static double *stack_factor(struct stack_weights *g, int i)
{
    return (double *)((char *)g + stack_factors[i].at);
}

static struct stack_weights stack_weigh(const struct stack_options *o,
                                        uint64_t *chance)
{
    struct stack_weights g;
    g.notch = random_uniform(chance, 1.2, 1.75);
    for (int i = 0; i < STACK_FACTORS; i++) {
        const double low = stack_factors[i].low, high = stack_factors[i].high;
        *stack_factor(&g, i) = low
                             * pow(high / low, random_uniform(chance, 0, 1));
    }
    g.share = random_uniform(chance, 0.7, 1);
    g.course = random_uniform(chance, 0.15, 0.6);
    if (o->goal == STACK_LOAD)
        g.share = fmin(1, 2 * g.share);
    return g;
}

/* Weights like others, each by a factor of 1.5 at the most. */
static struct stack_weights stack_vary(struct stack_weights g, uint64_t *chance)
{
    for (int i = 0; i < STACK_FACTORS; i++)
        *stack_factor(&g, i) *= exp(random_uniform(chance, -0.4, 0.4));
    g.share *= exp(random_uniform(chance, -0.4, 0.4));
    g.notch = fmin(1.85,
                   fmax(0.9, g.notch + random_uniform(chance, -0.1, 0.1)));
    return g;
}

/* Returns 1 if the effort was spent: candidates and questions to kern, each by
   the time that it takes. */
static int stack_spent(const struct stack_wall *w)
{
    const struct stack_options *o = &w->options;
    const double spent = w->tried + (double)STACK_ASKING * w->asked
                       + (double)STACK_HOLDING * w->held;
    return o->effort > 0 && spent > o->effort;
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
        from = (int)((s->keep - 1) * sqrt(random_uniform(&s->chance, 0, 1)));
        if (random_uniform(&s->chance, 0, 1) < 0.6)
            g = stack_vary(s->good, &s->chance);
    }
    if (stack_restore(w, s->kept, from))
        return -1;
    if (stack_grow(w, s, &g))
        return -1;
    value = stack_value(w);
    if (value > s->value) {
        s->value = value;
        s->good = g;
        stack_keep(w, s);
    }
    return 0;
}

/* Takes off the last stones until what is left stays in the last look: what a
   stone does to a wall may show late. Returns 0, or -1 where memory is
   lacking. */
STACK_API int stack_finish(struct stack_wall *w)
{
    struct stack_wall part = *w;
    while (part.laid > 0 && !stack_rests(&part))
        part.laid--;
    if (part.laid == w->laid)
        return 0;
    stack_give_up(&part);
    memcpy(w->message, part.message, sizeof w->message);
    return stack_restore(w, w->place, part.laid);
}

/* So many walls at least begin at the ground; so often the best one is built on
   where the last look took stones off it, each time from two stones fewer. */
enum { STACK_FRESH = 6, STACK_AGAIN = 8 };

/* Builds one wall after the other, the first ones from the ground, and leaves
   the best. Returns 0, or -1 where memory is lacking. */
STACK_API int stack_best(struct stack_wall *w)
{
    const struct stack_options *o = &w->options;
    struct stack_search s;
    int bad = stack_search_open(w, random_start(o->seed), &s);
    for (w->walls = 0; w->walls < o->walls && !bad && !stack_spent(w);
         w->walls++)
        bad = stack_next_wall(w, &s, s.keep == 0 || w->walls < STACK_FRESH);
    bad = bad || stack_restore(w, s.kept, s.keep);
    for (int i = 0; i < STACK_AGAIN && !bad && !stack_rests(w); i++) {
        const struct stack_weights g = stack_vary(s.good, &s.chance);
        bad = stack_finish(w);
        stack_cut(w, w->laid > 2 * i ? w->laid - 2 * i : 0);
        bad = bad || stack_grow(w, &s, &g);
    }
    if (!stack_ends(w))
        stack_give_up(w);
    stack_search_free(&s);
    return bad ? -1 : 0;
}

/* Lays pins in a finished wall: below what rests on one, and in the joints. It
   stays in the last look with them. */
STACK_API void stack_pin_all(struct stack_wall *w)
{
    const int stones = w->laid;
    for (int i = 1; i <= stones; i++)
        if (!stack_keeps_back(w, w->place[i - 1].stone)) {
            stack_pin(w, i);
            stack_heart(w, i);
        }
    while (w->laid > stones && !stack_rests(w))
        stack_cut(w, w->laid - 1);
}

/* Builds a wall with the planner of the options. Returns 0, or -1 where memory
   is lacking. */
STACK_API int stack_plan(struct stack_wall *w)
{
    int bad = w->options.planner == STACK_BEST ? stack_best(w) : stack_build(w);
    bad = bad || stack_finish(w);
    if (!bad)
        stack_pin_all(w);
    return bad ? -1 : 0;
}

#endif /* STACK_H */
