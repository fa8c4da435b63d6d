/* drop.h - planners that drop stones in the simulator and let the wall settle,
   for the example programs.

   The planners of stack.h lay stones by exact geometry, each of their longer
   edges turned to what is below. Those of the papers that they are named after
   take feasible poses from a simulator instead: a stone falls from a random
   turn and comes to rest. Here `heuristic` and `combined` do the same:

   1. The next stone of the stock is turned and placed above the wall by chance,
      moved down to the first contact, and released: rigid.h lets it fall, tip
      over and slide, on a wall that does not move.
   2. The filters of stack.h keep the good ones of the poses in which it came
      to rest; the kern filter of `combined` measures the wall with each of
      them, by the contacts of kern_near().
   3. The wall is released with the stone that is left, and comes to rest once
      more: every stone keeps the pose that it then has. A stone that makes the
      wall move farther is taken away, and the next one that is left is tried.

   No other test is asked: a stone stays where the simulator leaves it.

   Lengths are those of the stock, in the simulator mean sizes of its stones.
   The same input gives the same wall.

   SPDX-License-Identifier: MIT */

#ifndef DROP_H
#define DROP_H

#include "stack.h"
#include "table.h"

/* What a planner that drops stones may need; drop_defaults(). */
struct drop_options {
    int drops;    /* of every stone                               */
    int tries;    /* poses with which the wall is released        */
    double moved; /* farthest that a laid stone may go then, sizes */
};

STACK_API struct drop_options drop_defaults(void)
{
    const struct drop_options o = {300, 8, 0.1};
    return o;
}

static const double drop_rate = 120;   /* steps a second                   */
static const double drop_seconds = 3;  /* a stone that still moves then is
                                           given up                         */
static const double drop_calm = 2e-3;  /* sizes a second: at rest          */
static const double drop_alike = 0.02; /* poses closer are one, sizes      */

/* ---- One stone on a wall that does not move ------------------------------ */

/* Adds a stone; mass 0: it does not move. Returns its block, or -1. */
static int drop_add(struct rigid_world *r, const struct stone *s, double mass,
                    double unit)
{
    struct rigid_pt v[STONES_CORNERS];
    for (int k = 0; k < s->n; k++)
        v[k] = rigid_vec(s->v[k].x / unit, s->v[k].y / unit);
    return rigid_add(r, v, s->n, mass,
                     rigid_vec(s->centre.x / unit, s->centre.y / unit));
}

/* The farthest that a stone may go sideways. */
static double drop_way(const struct stone *s) { return 2 * s->reach; }

/* The stone, and what of the wall it may meet on a way of drop_way(). Returns
   its block, or -1. */
static int drop_world(struct rigid_world *r, const struct stack_wall *w,
                      const struct stone *s)
{
    const double unit = w->stock->size, within = drop_way(s) + s->reach;
    struct rigid_pt ground[4];
    rigid_init(r);
    r->friction = w->options.friction;
    r->slop = 5e-4;
    r->step = 1 / drop_rate;
    for (int i = 0; i < 4; i++)
        ground[i] = rigid_vec(w->ground[i].x / unit, w->ground[i].y / unit);
    if (rigid_add(r, ground, 4, 0, ground[0]) < 0)
        return -1;
    for (int i = 0; i < w->laid; i++) {
        const struct stone *o = &w->stone[i];
        if (o->low.x < s->centre.x + within && o->high.x > s->centre.x - within
            && drop_add(r, o, 0, unit) < 0)
            return -1;
    }
    return drop_add(r, s, s->area, unit);
}

static double drop_speed(const struct rigid_block *b)
{
    return rigid_length(b->v) + b->reach * fabs(b->spin);
}

/* Turns and moves a stone as its block was. */
static void drop_follow(struct stone *s, const struct rigid_block *b,
                        double unit)
{
    stone_turn(s, s->centre, stones_vec(b->turn.x, b->turn.y));
    stone_move(s, stones_vec(b->at.x * unit - s->centre.x,
                             b->at.y * unit - s->centre.y));
}

/* Releases a stone. Returns 1 where it comes to rest, at *s; 0 where it does
   not, or falls off the end; -1 where memory is lacking. */
STACK_API int drop_release(const struct stack_wall *w, struct stone *s)
{
    const double unit = w->stock->size;
    const int look = 6, steps = (int)(drop_seconds * drop_rate);
    struct rigid_world r;
    const int block = drop_world(&r, w, s);
    int calm = 0, bad = block < 0;
    for (int i = 1; i <= steps && !bad && calm < 2; i++) {
        bad = rigid_step(&r);
        if (i % look > 0)
            continue;
        calm = drop_speed(&r.block[block]) < drop_calm ? calm + 1 : 0;
        if (fabs(r.block[block].at.x * unit - s->centre.x) > drop_way(s))
            break;
    }
    if (calm == 2)
        drop_follow(s, &r.block[block], unit);
    rigid_free(&r);
    return bad ? -1 : calm == 2;
}

/* ---- Candidates ---------------------------------------------------------- */

/* Is a pose of the last stone about the same as one that is known? */
static int drop_known(const struct stack_wall *w, const struct stack_list *list,
                      int stone, const struct stone *s)
{
    const double within = drop_alike * w->stock->size;
    struct stack_place place;
    place.stone = stone;
    place.at = s->centre;
    place.turn = s->turn;
    for (int i = 0; i < list->count; i++)
        if (stack_same(&list->one[i].place, &place, within))
            return 1;
    return 0;
}

/* Drops a stone once, from a random turn at a random place. */
static int drop_once(struct stack_wall *w, struct stack_list *list, int stone,
                     uint64_t *chance)
{
    struct stone s = w->stock->stone[stone];
    const double angle = random_uniform(chance, 0, 2 * table_pi);
    const double share = random_uniform(chance, 0, 1);
    const struct rigid_pt turn = rigid_unit(angle);
    double x, high = 0;
    int rests;
    stone_turn(&s, s.centre, stones_vec(turn.x, turn.y));
    x = -s.low.x + share * (w->options.width - (s.high.x - s.low.x));
    for (int i = 0; i < w->columns; i++)
        high = fmax(high, w->sky[i]);
    stone_move(&s, stones_vec(x, high - s.low.y + w->stock->size));
    stack_look_below(w, &s, x);
    if (!rest_drop(&w->around, &s))
        return 0;
    rests = drop_release(w, &s);
    if (rests <= 0)
        return rests;
    w->tried++;
    if (drop_known(w, list, stone, &s))
        return 0;
    stack_look_below(w, &s, s.centre.x);
    return stack_note(w, list, stone, &s);
}

/* Fills the list with the poses in which a stone comes to rest. Returns 0, or
   -1 where memory is lacking. */
STACK_API int drop_propose(struct stack_wall *w, struct stack_list *list,
                           int stone, int drops, uint64_t *chance)
{
    int bad = 0;
    list->count = 0;
    for (int i = 0; i < drops && !bad; i++)
        bad = drop_once(w, list, stone, chance);
    return bad;
}

/* What the filters leave, and of this the candidate with the longest common
   edges; -1: none is left. */
static int drop_filter(struct stack_wall *w, struct stack_list *list)
{
    const int levels = w->options.planner == STACK_COMBINED ? w->options.levels
                                                            : -1;
    for (int i = 0; i < list->count; i++)
        list->one[i].out = 0;
    for (int k = 0; k <= STACK_FILTERS; k++) {
        if (k == levels) {
            stack_drop_falling(w, list);
            stack_sift_levels(w, list);
        }
        if (k < STACK_FILTERS)
            stack_sift(w, list, k);
    }
    return stack_most_edges(list);
}

/* ---- The whole wall ------------------------------------------------------ */

/* Takes over the stones and poses of place[0..laid), and what kern needs to be
   asked. Returns 0, or -1 where the stones overlap too deeply. */
static int drop_take(struct stack_wall *w, const struct stack_place *place,
                     int laid)
{
    int bad = stack_begin(w);
    for (int i = 0; i < laid && !bad; i++) {
        struct stone *s = &w->stone[i];
        kern_block block;
        w->place[i] = place[i];
        *s = stack_placed(w, &place[i]);
        bad = kern_block_init(&block, s->v, s->n, 1, NULL) != KERN_OK
           || stack_add(w, &block) < 0;
        if (bad)
            break;
        stack_raise(w, i);
        w->used[place[i].stone] = 1;
        w->filled += stone_area_in(s, w->options.width, w->options.height);
        w->laid = i + 1;
    }
    return bad ? -1 : 0;
}

/* Releases the wall with one more stone until all are calm. Returns 1, with the
   poses in place[], where no stone goes farther than `moved` sizes; else 0, or
   -1 where memory is lacking. */
STACK_API int drop_settle(const struct stack_wall *w, double moved,
                          const struct stack_candidate *c,
                          struct stack_place *place)
{
    const double unit = w->stock->size;
    const int look = 12, steps = (int)(drop_seconds * 240);
    const struct stone last = stack_placed(w, &c->place);
    struct rigid_world r;
    double fast = 1, gone = 0;
    int bad = stack_world(&r, w, &last, 0, 0);
    for (int i = 1; i <= steps && !bad && fast > drop_calm && gone <= moved;
         i++) {
        bad = rigid_step(&r);
        if (i % look > 0)
            continue;
        fast = 0;
        for (int k = 1; k < r.blocks; k++) {
            const struct stone *s = k <= w->laid ? &w->stone[k - 1] : &last;
            gone = fmax(gone, stack_gone(&r.block[k], s, unit));
            fast = fmax(fast, drop_speed(&r.block[k]));
        }
    }
    for (int k = 1; k < r.blocks && !bad; k++) {
        struct stack_place *p = &place[k - 1];
        const struct rigid_block *b = &r.block[k];
        *p = k <= w->laid ? w->place[k - 1] : c->place;
        p->at = stones_vec(b->at.x * unit, b->at.y * unit);
        p->turn = stones_turned(stones_vec(b->turn.x, b->turn.y), p->turn);
    }
    rigid_free(&r);
    return bad ? -1 : fast <= drop_calm && gone <= moved;
}

/* Lays one of the candidates: the first choice of the filters with which the
   wall comes to rest. Returns 1, 0 where there is none, -1 where memory is
   lacking. */
static int drop_lay(struct stack_wall *w, const struct drop_options *o,
                    struct stack_list *list, struct stack_place *room)
{
    for (int i = 0; i < o->tries; i++) {
        const int best = drop_filter(w, list);
        int rests;
        if (best < 0)
            return 0;
        w->held++;
        rests = drop_settle(w, o->moved, &list->one[best], room);
        if (rests < 0)
            return -1;
        if (rests)
            return drop_take(w, room, w->laid + 1) ? -1 : 1;
        w->slipped++;
        stack_strike(list, best);
    }
    return 0;
}

/* Builds a wall: each stone of the stock in its turn, and where it finds no
   place the next one; what was passed over is tried again once. Returns 0, or
   -1 where memory is lacking. */
STACK_API int drop_build(struct stack_wall *w, const struct drop_options *o)
{
    struct stack_place *room = malloc((size_t)w->stock->stones * sizeof *room);
    struct stack_list list = {NULL, 0, 0};
    uint64_t chance = random_from(w->options.seed + 1);
    int bad = !room;
    w->plan.task.options = kern_near(&w->plan.task.options, w->stock->size);
    for (int round = 0; round < 2; round++)
        for (int k = 0; k < w->stock->stones && !bad; k++) {
            if (w->used[k] || w->laid == w->options.most)
                continue;
            bad = drop_propose(w, &list, k, o->drops, &chance)
               || drop_lay(w, o, &list, room) < 0;
        }
    free(room);
    free(list.one);
    if (bad)
        return -1;
    if (!stack_ends(w))
        stack_give_up(w);
    return kern_measure(&w->plan.task, &w->m, NULL) < 0 ? -1 : 0;
}

#endif /* DROP_H */
