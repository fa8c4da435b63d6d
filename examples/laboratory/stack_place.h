/* stack_place.h - places for the next stone of a wall: where it comes to rest,
   what the library says of the wall with it, which of these places it may be
   laid at, and the last look of the simulator at a finished wall.

   Lengths are those of the stock, in the simulator sizes of a stone.

   SPDX-License-Identifier: MIT */

#ifndef STACK_PLACE_H
#define STACK_PLACE_H

#include "../../kern.h"
#include "../parts/random.h"
#include "rigid.h"
#include "stack_wall.h"

#include <time.h>

/* ---- Candidates ---------------------------------------------------------- */

struct stack_candidate {
    struct stack_place place;
    double feature[STACK_FILTERS]; /* signed so that more is better      */
    double inside;                 /* area within the frame              */
    struct stack_bedding bed;
    double step; /* of stack_step_up()                                   */
    int matches; /* of stack_matches()                                   */
    int off;     /* its longest face is off level                        */
    double cost; /* to `best`                                            */
    int out;     /* a filter dropped it, or it falls                     */
    int known;   /* kern was asked: what follows is the wall's with it   */
    kern_margin m;
    double stable; /* its load factor, where that is the goal            */
};

struct stack_list {
    struct stack_candidate *one;
    int count, room;
};

static int stack_same(const struct stack_place *a, const struct stack_place *b,
                      double within)
{
    return a->stone == b->stone && fabs(a->at.x - b->at.x) < within
        && fabs(a->at.y - b->at.y) < within
        && fabs(a->turn.x - b->turn.x) < within
        && fabs(a->turn.y - b->turn.y) < within;
}

/* Notes a stone at rest, dressed, if it lies in the frame and is not known yet;
   one of many corners finds a hold anywhere, so that places a little apart are
   one. Returns -1 where memory is lacking. */
static int stack_note(struct stack_wall *w, struct stack_list *list, int stone,
                      const struct stone *rests)
{
    const double within = (rests->n > STONES_BEDS ? 0.03 : 1e-3)
                        * w->stock->size;
    const int best = w->options.planner == STACK_BEST;
    struct stone dressed = *rests;
    const struct stone *s = &dressed;
    struct stack_candidate *more, c;
    if (s->low.x < -rest_touch || s->high.x > w->options.width + rest_touch)
        return 0;
    c.place.stone = stone;
    c.place.at = s->centre;
    c.place.turn = s->turn;
    for (int i = list->count - 1; i >= 0 && list->one[i].place.stone == stone;
         i--)
        if (stack_same(&list->one[i].place, &c.place, within))
            return 0;
    c.place.top = stack_dressed(w, s);
    if (c.place.top < s->high.y
        && stone_dress(&dressed, stones_vec(0, 1), c.place.top))
        return 0;
    c.out = c.known = 0;
    c.inside = s->high.y <= w->options.height
                 ? s->area
                 : stone_area_in(s, w->options.width, w->options.height);
    if (c.inside < s->area / 2)
        return 0;
    c.feature[STACK_EDGES] = stack_edges(&w->around, s);
    c.feature[STACK_HOLE] = best ? 0 : -stack_hole(w, s); /* has no use of it */
    c.feature[STACK_NEIGHBOURS] = best ? 0 : stack_neighbours(w, s);
    c.feature[STACK_SLOPE] = -stack_slope(s);
    c.feature[STACK_BOND] = stack_bond(w, s);
    c.bed = stack_bedding_of(w, s);
    c.step = stack_step_up(w, s);
    c.matches = stack_matches(w, stone, s);
    c.off = masonry_is_off(s->v, s->n);
    more = rigid_room(list->one, list->count, 1, &list->room, sizeof *more);
    if (!more)
        return -1;
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

static const double stack_grid = 0.4;   /* between anchors, in sizes          */
static const double stack_fine = 0.1;   /* where none of these will do        */
static const double stack_slide = 0.8;  /* most that a stone slides, in sizes */
static const double stack_level = 0.1;  /* depth of a notch, in sizes         */
static const double stack_across = 0.3; /* unevenness that a stone crosses    */
static const double stack_steep = 0.9;  /* cosine of the steepest bed        */

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
                                   ? w->stone[w->owner[c] - 1].low.x
                                   : w->options.width;
            a[n].x = (left + right) / 2;
            a[n++].along = stones_vec(1, 0);
            down = 0;
        }
    }
    return n;
}

/* Places astride a joint between two stones whose tops are about level: with its
   centre above the joint, a stone lies on the higher top alone; a little aside,
   it tilts until the lower one carries it too. */
enum { STACK_ACROSS = 3 };

static int stack_joints(const struct stack_wall *w, struct stack_anchor *a)
{
    const double size = w->stock->size;
    int n = 0;
    for (int c = 1; c < w->columns; c++) {
        const double rise = w->sky[c] - w->sky[c - 1];
        if (w->owner[c] == w->owner[c - 1] || fabs(rise) > stack_across * size)
            continue;
        for (int k = 0; k < STACK_ACROSS; k++) {
            const double aside = 0.15 * k * size;
            a[n].x = c * w->options.width / w->columns
                   + (rise > 0 ? -aside : aside);
            a[n++].along = stones_vec(1, 0);
        }
    }
    return n;
}

/* Keeps of n anchors those where the course that is being laid goes on. It goes
   on where, from the left, the first half a stone's width of the sky is at most
   w->course sizes above the lowest, and from there two stones to the right.
   Returns how many are kept. */
static int stack_course(const struct stack_wall *w, struct stack_anchor *a,
                        int n)
{
    const int wide = STACK_COLUMNS / 2, reach = 2 * STACK_COLUMNS;
    double low = HUGE_VAL, least;
    int first = 0, kept = 0;
    for (int c = w->columns - wide; c >= 0; c--) {
        double high = 0;
        for (int k = c; k < c + wide; k++)
            high = rigid_most(high, w->sky[k]);
        low = rigid_least(low, high);
    }
    least = low + w->course * w->stock->size;
    for (int c = w->columns - wide; c >= 0; c--) {
        double high = 0;
        for (int k = c; k < c + wide; k++)
            high = rigid_most(high, w->sky[k]);
        if (high <= least)
            first = c;
    }
    for (int i = 0; i < n; i++) {
        int c = stack_column(w, a[i].x);
        if (c == w->columns)
            c--;
        if (w->sky[c] <= least
            && (!(w->course < HUGE_VAL) || (c >= first && c < first + reach)))
            a[kept++] = a[i];
    }
    return kept;
}

/* The faces that look upward and can be seen from there, the longer ones of a
   stone of many corners, and a grid; for `best` also the notches, and the joints
   between tops of about one height, that a stone may cross. */
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
            if (e.n.y < stack_steep || e.a.x - e.b.x < least
                || column >= w->columns || w->owner[column] != b)
                continue;
            a[n].x = x;
            a[n++].along = stones_vec(e.n.y, -e.n.x);
        }
    for (int i = 0; i < grid; i++) {
        a[n].x = (i + 0.5) * w->options.width / grid;
        a[n++].along = stones_vec(1, 0);
    }
    if (w->options.planner != STACK_BEST)
        return n;
    n += stack_notches(w, a + n);
    n += stack_joints(w, a + n);
    return stack_course(w, a, n);
}

/* Finds how far back along d a stone that was slid against the one beside it
   has to go until one face may lie on both tops; 0 where it need not, or too far. */
static double stack_way_back(const struct stack_wall *w, const struct stone *s,
                             int side, kern_vec d)
{
    const double size = w->stock->size, turned = 0.011, wide = 0.12 * size;
    const struct stone *t = stack_beside(w, s, side);
    kern_vec own[2], other[2], a, b;
    double rise, off, back;
    if (!t || !stack_top_face(s, side, size, own)
        || !stack_top_face(t, -side, size, other))
        return 0;
    rise = stack_rise(other[0], other[1]);
    if (fabs(stack_rise(own[0], own[1]) - rise) > turned)
        return 0;
    a = own[side > 0];
    b = other[side < 0];
    off = a.y - b.y - rise * (a.x - b.x);
    back = off / (d.y - rise * d.x);
    return back > 0 && back < wide ? back : 0;
}

/* Lets a stone of the stock down at x, turned as given, past all blocks that lie
   above height `from`, and puts it where it comes to rest. Returns 0 if it comes
   to rest nowhere, or above that height. */
static int stack_rest(struct stack_wall *w, int stone, double x, kern_vec turn,
                      double from, struct stone *s)
{
    kern_task task = w->plan.task;
    kern_pose pose;
    if (from < HUGE_VAL) {
        task.s.block = w->below;
        task.s.blocks = 0;
        for (int i = 0; i < w->plan.task.s.blocks; i++)
            if (w->plan.block[i].box.low.y < from)
                w->below[task.s.blocks++] = w->plan.block[i];
    }
    *s = w->stock->stone[stone];
    if (kern_rest(&task, &w->shape[stone], x, turn, s->v, &pose) != KERN_OK)
        return 0;
    s->centre = pose.block.centre;
    s->turn = pose.turn;
    s->low = pose.block.box.low;
    s->high = pose.block.box.high;
    return s->low.y < from;
}

/* Slides a stone at rest to one side until something, or the side of the frame,
   is in the way, and notes it where it then comes to rest. */
static int stack_slide_on(struct stack_wall *w, struct stack_list *list,
                          int stone, struct stone s, double side)
{
    kern_vec left, right, d = {side, 0};
    double way, room;
    rest_holds(&w->around, &s, &left, &right);
    if (right.x - left.x > 0.05 * w->stock->size)
        d = stones_unit(stones_sub(right, left));
    if (side * d.x < 0)
        d = stones_vec(-d.x, -d.y);
    if (fabs(d.x) < stack_steep)
        return 0;
    room = (side > 0 ? w->options.width - s.high.x : s.low.x) / fabs(d.x);
    way = fmin(rest_way(&w->around, &s, d), room);
    if (!(way > 0.01 * w->stock->size && way < stack_slide * w->stock->size))
        return 0;
    if (!stack_rest(w, stone, s.centre.x + way * d.x, s.turn, HUGE_VAL, &s))
        return 0;
    if (stack_note(w, list, stone, &s))
        return -1;
    way = w->options.planner == STACK_BEST
            ? stack_way_back(w, &s, side > 0 ? 1 : -1, d)
            : 0;
    return way > 0
                && stack_rest(w, stone, s.centre.x - way * d.x, s.turn,
                              HUGE_VAL, &s)
             ? stack_note(w, list, stone, &s)
             : 0;
}

/* One stone, one bed, one anchor: up to three candidates. */
static int stack_let_down(struct stack_wall *w, struct stack_list *list,
                          int stone, int bed, const struct stack_anchor *a)
{
    struct stone s = w->stock->stone[stone];
    const kern_vec b = s.bed[bed];
    double x;
    stone_turn(&s, s.centre, stones_turned(a->along, stones_vec(b.x, -b.y)));
    if (s.high.x - s.low.x > w->options.width
        || (w->lie && masonry_is_off(s.v, s.n)))
        return 0;
    x = fmin(fmax(a->x, -s.low.x), w->options.width - s.high.x);
    if (!stack_rest(w, stone, x, s.turn, HUGE_VAL, &s))
        return 0;
    w->tried++;
    return stack_note(w, list, stone, &s)
        || stack_slide_on(w, list, stone, s, -1)
        || stack_slide_on(w, list, stone, s, 1);
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
            if (scan->share >= 1
                || random_uniform(scan->chance, 0, 1) < scan->share)
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
    const int fine = all
                  && (stack_asked(w) || w->options.planner != STACK_BEST);
    const double step = (fine ? stack_fine : stack_grid) * w->stock->size;
    struct stack_scan scan = {NULL, 0, fine ? 1 : share, chance};
    int stones = 0, bad = 0;
    int room = (int)(w->options.width / step) + 2
             + (STACK_ACROSS + 1) * w->columns;
    for (int i = 0; i < w->laid; i++)
        room += w->stone[i].n;
    scan.anchor = malloc((size_t)room * sizeof *scan.anchor);
    if (!scan.anchor)
        return -1;
    scan.anchors = stack_anchors(w, step, scan.anchor);
    list->count = 0;
    for (int k = 0;
         k < w->stock->stones && !bad && (all || stones < w->options.look);
         k++) {
        if (w->used[k] || stack_keeps_back(w, k))
            continue;
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
    kern_real factor[2] = {0, 0};
    for (int k = 0; k < 2; k++)
        if (kern_load_factor(&w->plan.task, 0, k ? KERN_RIGHT : KERN_LEFT,
                             &factor[k], NULL)
            != KERN_STANDS)
            return 0;
    return fmin(factor[0], factor[1]);
}

/* The level at which the wall is expected to collapse when it is shaken: by its
   expected drop; 0 where that cannot be found. Fitted to 262 structures, walls,
   piles and towers, that another simulator shook and that collapse at level 20
   or below: fitted to half of them, the mean error of the other half is 0.3
   levels, the mean of its size 2.1. Walls of planners may collapse later: the
   constants before, 0.4 to 0.9 lower, were 1.4 to 1.6 too low for those. */
STACK_API double stack_predicted_level(struct stack_wall *w)
{
    const double at_one = 3.26, slope = 2.9, least = 0.01;
    const kern_side side[2] = {KERN_LEFT, KERN_RIGHT};
    kern_task task = w->plan.task;
    double drop = 0;
    task.options = kern_near(&task.options, w->stock->size);
    task.s.contact = w->close;
    task.s.contacts = kern_contacts(task.s.block, task.s.blocks, &task.options,
                                    w->close, w->plan.contact_room, task.work);
    task.known.motion = NULL;
    task.known.force = NULL;
    if (task.s.contacts < 0)
        return 0;
    for (int k = 0; k < 2; k++) {
        kern_collapse c;
        if (kern_profile(&task, side[k], w->load, &c) != KERN_OK)
            return 0;
        drop += c.drop;
    }
    return at_one - slope * log(drop + least);
}

/* Adds a block for a question; stack_take_off() restores the plan. Returns 0, or
   -1 where it cannot be added. */
static int stack_put_on(struct stack_wall *w, const kern_block *block,
                        kern_known *known)
{
    *known = w->plan.task.known;
    memcpy(w->motion, known->motion,
           (size_t)w->plan.task.s.blocks * sizeof(kern_motion));
    memcpy(w->force, known->force,
           (size_t)w->plan.task.s.contacts * sizeof(kern_force));
    return stack_add(w, block) < 0 ? -1 : 0;
}

/* Removes a block that was added for a question, and restores what the plan
   knew. */
static void stack_take_off(struct stack_wall *w, const kern_known *known)
{
    if (w->plan.task.s.blocks > w->laid + 1)
        kern_plan_remove(&w->plan, w->laid + 1);
    memcpy(known->motion, w->motion,
           (size_t)w->plan.task.s.blocks * sizeof(kern_motion));
    memcpy(known->force, w->force,
           (size_t)w->plan.task.s.contacts * sizeof(kern_force));
    w->plan.task.known = *known;
}

/* Measures the wall with one more block, and its load factor if that is
   wanted. */
static kern_status stack_measure_with(struct stack_wall *w,
                                      const kern_block *block, int load,
                                      struct stack_candidate *c)
{
    kern_known known;
    kern_status status = KERN_OVERLAP;
    if (stack_put_on(w, block, &known) == 0) {
        status = kern_measure(&w->plan.task, &c->m, NULL);
        if (load && status == KERN_STANDS)
            c->stable = stack_levels_a_load * stack_load(w);
    }
    stack_take_off(w, &known);
    return status;
}

/* Returns 1 if the wall stands with a candidate when it is tilted to either
   side, by an angle of this tangent: what leans outward at its ends falls. */
static int stack_tilts(struct stack_wall *w, const struct stack_candidate *c,
                       double tilt)
{
    const double g = 9.81;
    struct stone s = stack_placed(w, &c->place);
    kern_block block;
    kern_known known;
    int stands;
    if (kern_block_init(&block, s.v, s.n, 1, NULL) != KERN_OK)
        return 0;
    stands = stack_put_on(w, &block, &known) == 0;
    for (int side = -1; side < 2 && stands; side += 2) {
        kern_task task = w->plan.task;
        task.known.motion = NULL;
        task.known.force = NULL;
        task.s.gravity = stones_vec(side * tilt * g, -g);
        stands = kern_verdict(&task, 0, NULL) == KERN_STANDS;
    }
    stack_take_off(w, &known);
    return stands;
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
    double rate; /* steps a second                              */
    int substeps;
    double noise;          /* of every place and angle                    */
    double push;           /* sideways, as a share of gravity             */
    double least, seconds; /* it ends after so long where all are calm    */
};

/* The runs of the step test, which no planner sees, and how far a stone may go
   there. */
enum { STACK_TESTS = 6 };
static const struct stack_run stack_tests[STACK_TESTS] = {
    {240, 4, 0, 0, 1, 6},   {240, 4, 1e-4, 0, 1, 6},  {240, 4, 1e-4, 0, 1, 6},
    {60, 4, 1e-4, 0, 1, 6}, {120, 16, 1e-4, 0, 1, 6}, {480, 32, 1e-4, 0, 1, 4}};
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
    if (rigid_add(r, v, 4, 0, v[0]) < 0)
        return -1;
    for (int i = 0; i <= w->laid; i++) {
        const struct stone *s = i < w->laid ? &w->stone[i] : last;
        struct rigid_pt at;
        if (!s)
            continue;
        at = rigid_vec(s->centre.x / unit, s->centre.y / unit);
        for (int k = 0; k < s->n; k++)
            v[k] = rigid_vec(s->v[k].x / unit, s->v[k].y / unit);
        if (rigid_add(r, v, s->n, s->area, at) < 0)
            return -1;
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
STACK_API double stack_sway(struct stack_wall *w, const struct stone *last,
                            const struct stack_run *run, uint64_t seed,
                            double most)
{
    const double unit = w->stock->size, calm = 1e-4;
    const int look = (int)(run->rate / 10);
    struct rigid_world r;
    double sway = 0, fast = 1;
    if (stack_world(&r, w, last, run->noise, seed))
        sway = HUGE_VAL;
    r.step = 1 / run->rate;
    r.substeps = run->substeps;
    r.gravity.x = -run->push * r.gravity.y;
    for (int i = 1; i <= run->seconds * run->rate && sway <= most
                    && (fast > calm || i <= run->least * run->rate);
         i++) {
        if (rigid_step(&r))
            sway = HUGE_VAL;
        if (i % look > 0)
            continue;
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

/* The last look at a finished wall: four times with errors of every pose, twice
   in the steps that game engines take if nothing else is asked for. No planner
   asks the simulator before. */
enum { STACK_LAST = 6 };
static const struct stack_run stack_last[STACK_LAST] = {
    {240, 16, 5e-4, 0, 1, 4}, {240, 16, 5e-4, 0, 1, 4},
    {240, 16, 5e-4, 0, 1, 4}, {240, 16, 5e-4, 0, 1, 4},
    {60, 4, 1e-4, 0, 1, 6},   {60, 4, 5e-4, 0, 1, 6}};

/* Does a finished wall stay where it is, in every run of the last look? */
static int stack_rests(struct stack_wall *w)
{
    int rests = 1;
    for (int i = 0; i < STACK_LAST && rests; i++)
        rests = stack_sway(w, NULL, &stack_last[i], (uint64_t)(10 + i),
                           stack_moved)
             <= stack_moved;
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
                            stack_moved)
               > stack_moved;
    return moves;
}

/* ---- What may be laid ---------------------------------------------------- */

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
        sticks |= !w->close[i].line
               && fabs(w->close[i].travel) > 1e-9 * w->stock->size;
    return sticks;
}

/* The least chance that a stone stays where it is let go, of one that is laid. */
static const double stack_chance = 0.5;

/* Returns 1 if a candidate may be laid: it sticks in no notch, and by
   kern_plan_stays() it stays where it is let go. */
static int stack_holds(struct stack_wall *w, const struct stack_candidate *c)
{
    struct stone s = stack_placed(w, &c->place);
    kern_block block;
    kern_real chance;
    int holds;
    w->held++;
    holds = kern_block_init(&block, s.v, s.n, 1, NULL) == KERN_OK
         && !stack_sticks(w, &block)
         && kern_plan_stays(&w->plan, &block, &chance) == KERN_STANDS
         && chance >= stack_chance;
    w->slipped += !holds;
    return holds;
}

#endif /* STACK_PLACE_H */
