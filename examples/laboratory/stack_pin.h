/* stack_pin.h - pins and hearting of a wall: small stones of the stock, or chips,
   that `best` keeps back. A pin goes below a stone that rests on one, so that it
   rests on two, or into the joint beside a stone. It is asked as any stone.

   SPDX-License-Identifier: MIT */

#ifndef STACK_PIN_H
#define STACK_PIN_H

#include "stack_place.h"

/* So many pins of the stock are tried at a place, and so many are asked. */
enum { STACK_PINS = 24, STACK_PINS_ASKED = 3 };

static const double stack_joint = 0.5; /* wider gaps are none, in sizes */

/* What is looked for, and the pin that is found so far. */
struct stack_pinned {
    int block;   /* the stone to be pinned                        */
    int alone;   /* what carries it alone; 0: a pin is looked for
                               that goes beside it, else below it            */
    double gap;  /* below it                                      */
    double most; /* area of a pin                                 */
    double area; /* 0: none is found                              */
    struct stack_place place;
};

/* Contact points of a stone with the wall, in w->close; below 0: it overlaps. */
static int stack_touches(struct stack_wall *w, const struct stone *s)
{
    const int last = w->plan.task.s.blocks;
    if (kern_block_init(&w->plan.block[last], s->v, s->n, 1, NULL) != KERN_OK)
        return -1;
    return kern_touch(w->plan.block, last, &w->plan.task.options, w->close,
                      w->plan.contact_room, &w->work);
}

/* Is a pin in place good for what is looked for? Below a stone it carries that
   and lies on another than what carries it alone; beside it, it lies no higher.
   None founds the wall. */
static int stack_serves(struct stack_wall *w, const struct stone *s,
                        const struct stack_pinned *p)
{
    const int pin = w->plan.task.s.blocks, found = stack_touches(w, s);
    int carries = 0, lies = 0;
    for (int i = 0; i < found; i++) {
        const kern_contact *c = &w->close[i];
        const int other = c->a + c->b - pin;
        const double up = c->b == pin ? c->n.y : -c->n.y; /* to the pin */
        if (other == 0)
            return 0;
        carries |= other == p->block && up <= -masonry_rests;
        lies |= other != p->block && other != p->alone && up >= masonry_rests;
    }
    return p->alone ? carries && lies
                    : found > 0 && s->high.y <= w->stone[p->block - 1].high.y;
}

/* Notes a pin in place where it is larger than the one found so far. */
static void stack_note_pin(struct stack_wall *w, int stone,
                           const struct stone *s, struct stack_pinned *p)
{
    w->tried++;
    if (s->area <= p->area || s->area >= p->most || s->low.x < 0
        || s->high.x > w->options.width || !stack_serves(w, s, p))
        return;
    p->area = s->area;
    p->place.stone = stone;
    p->place.at = s->centre;
    p->place.turn = s->turn;
}

/* Lays a pin on face e with its middle at x and pushes it along, until it
   touches something. */
static void stack_push_pin(struct stack_wall *w, int stone, struct stone s,
                           const struct rest_edge *e, double x, double side,
                           struct stack_pinned *p)
{
    const kern_vec d = stones_vec(side * e->n.y, -side * e->n.x);
    const double most = 2 * w->stock->size;
    double deep = HUGE_VAL, top = -HUGE_VAL, way;
    for (int i = 0; i < s.n; i++) {
        deep = fmin(deep, stones_dot(e->n, s.v[i]));
        top = fmax(top, stones_dot(e->n, s.v[i]));
    }
    if (top - deep < p->gap * e->n.y)
        return;
    /* of its centre: above e at x by so much that its bed is on e */
    way = (stones_dot(e->n, e->a) - deep - e->n.x * x) / e->n.y;
    stone_move(&s, stones_vec(x, way));
    if (stack_touches(w, &s) < 0)
        return;
    way = rest_way(&w->around, &s, d);
    if (!(way < most))
        return;
    stone_move(&s, stones_vec(way * d.x, way * d.y));
    stack_note_pin(w, stone, &s, p);
}

/* Pushes a pin below the stone over face e, from both sides. */
static void stack_try_below(struct stack_wall *w, int stone,
                            const struct rest_edge *e, struct stack_pinned *p)
{
    const struct stone *above = &w->stone[p->block - 1];
    const struct stone *pin = &w->stock->stone[stone];
    const double aside = 0.01 * w->stock->size;
    const kern_vec along = stones_vec(e->n.y, -e->n.x);
    for (int bed = 0; bed < pin->beds; bed++) {
        struct stone s = *pin;
        const kern_vec b = s.bed[bed];
        stone_turn(&s, s.centre, stones_turned(along, stones_vec(b.x, -b.y)));
        stack_push_pin(w, stone, s, e, above->high.x - s.low.x + aside, -1, p);
        stack_push_pin(w, stone, s, e, above->low.x - s.high.x - aside, 1, p);
    }
}

/* The gap between face e and a stone, in the middle of what is above e; 0:
   none. */
static double stack_gap(const struct stack_wall *w, const struct stone *above,
                        const struct rest_edge *e)
{
    const double left = fmax(e->b.x, above->low.x);
    const double right = fmin(e->a.x, above->high.x);
    const double x = (left + right) / 2;
    double low, high, gap;
    if (e->n.y < stack_steep || right - left < 0.02 * w->stock->size
        || !stack_sides(above, x, &low, &high))
        return 0;
    gap = low - (e->a.y - e->n.x / e->n.y * (x - e->a.x));
    return gap > 0.01 * w->stock->size && gap < stack_joint * w->stock->size
             ? gap
             : 0;
}

/* The middle of the joint on a side of a stone, at height y; HUGE_VAL: no other
   stone is near there. */
static double stack_joint_at(const struct stack_wall *w, int block, double side,
                             double y)
{
    const kern_block *all = w->plan.task.s.block;
    double left, right, from, wide = stack_joint * w->stock->size;
    masonry_ends(&all[block], y, &left, &right);
    from = side < 0 ? left : right;
    for (int i = 1; i <= w->laid; i++) {
        double way;
        if (i == block)
            continue;
        masonry_ends(&all[i], y, &left, &right);
        way = side < 0 ? from - right : left - from;
        if (way >= 0)
            wide = fmin(wide, way);
    }
    return wide < stack_joint * w->stock->size ? from + side * wide / 2
                                               : HUGE_VAL;
}

/* Lets a pin down in the joint on a side of a stone, from height y, and pushes it
   against the stone. */
static void stack_try_beside(struct stack_wall *w, int stone, double x,
                             double y, struct stack_pinned *p)
{
    const struct stone *pin = &w->stock->stone[stone];
    const kern_vec d = stones_vec(x < w->stone[p->block - 1].centre.x ? 1 : -1,
                                  0);
    for (int bed = 0; bed < pin->beds; bed++) {
        const kern_vec turn = stones_vec(pin->bed[bed].x, -pin->bed[bed].y);
        struct stone s;
        double way;
        if (!stack_rest(w, stone, x, turn, y, &s))
            continue;
        way = rest_way(&w->around, &s, d);
        if (way < stack_joint * w->stock->size) {
            stone_move(&s, stones_vec(way * d.x, 0));
            rest_drop(&w->around, &s);
        }
        stack_note_pin(w, stone, &s, p);
    }
}

/* Tries a pin below a stone, over each face that it hangs over. */
static void stack_try_faces(struct stack_wall *w, int stone,
                            struct stack_pinned *p)
{
    for (int i = 0; i < w->around.edges; i++) {
        const struct rest_edge *e = &w->around.edge[i];
        if (e->block == p->block || e->block == p->alone)
            continue;
        p->gap = stack_gap(w, &w->stone[p->block - 1], e);
        if (p->gap > 0)
            stack_try_below(w, stone, e, p);
    }
}

/* Looks for the largest of the next pins of the stock that is good for what is
   looked for, at x, y or below the stone. */
static void stack_find_pin(struct stack_wall *w, double x, double y,
                           struct stack_pinned *p)
{
    const double size = w->stock->size;
    const struct stone *s = &w->stone[p->block - 1];
    int pins = 0;
    stack_look(w, s->low.x - size, s->high.x + size, s->low.y - size);
    for (int k = 0; k < w->stock->stones && pins < STACK_PINS; k++) {
        if (w->used[k] || !stack_keeps_back(w, k))
            continue;
        pins++;
        if (p->alone)
            stack_try_faces(w, k, p);
        else
            stack_try_beside(w, k, x, y, p);
    }
}

/* Lays the largest pin that may be laid there. */
static void stack_pin_at(struct stack_wall *w, int block, int alone, double x,
                         double y)
{
    struct stack_pinned p = {block,    alone, 0,
                             HUGE_VAL, 0,     {0, {0, 0}, {1, 0}, HUGE_VAL}};
    for (int i = 0; i < STACK_PINS_ASKED; i++) {
        struct stack_candidate c;
        p.area = 0;
        stack_find_pin(w, x, y, &p);
        c.place = p.place;
        if (!(p.area > 0)
            || (stack_holds(w, &c) && stack_lay(w, &p.place) == 0))
            return;
        p.most = p.area;
    }
}

/* Pins a stone that rests on one: it then rests on two. */
STACK_API void stack_pin(struct stack_wall *w, int block)
{
    const struct masonry_rest r = masonry_rest_on(&w->plan.task.s, block,
                                                  w->stock->size);
    if (w->stock->pins > w->pins && r.stones == 1 && !r.ground)
        stack_pin_at(w, block, r.below, 0, 0);
}

/* Pins in the joints on both sides of a stone, in its lower and its upper
   half. */
STACK_API void stack_heart(struct stack_wall *w, int block)
{
    const struct stone *s = &w->stone[block - 1];
    for (int k = 0; k < 4 && w->stock->pins > w->pins; k++) {
        const double y = s->low.y + (k / 2 + 1) * (s->high.y - s->low.y) / 3;
        const double x = stack_joint_at(w, block, k % 2 ? 1 : -1, y);
        if (x < HUGE_VAL)
            stack_pin_at(w, block, 0, x, y);
    }
}

#endif /* STACK_PIN_H */
