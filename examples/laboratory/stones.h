/* stones.h - stones for the example programs that build walls: a stock of them,
   and how far one can be pushed.

   stones_load() takes the blocks of a structure file as a stock, stones_make()
   makes one of a given irregularity. rest_way() finds how far a stone can be
   pushed in a direction before it touches something. kern_rest() finds where a
   stone comes to rest that is let down from above.

   Only + - * / and sqrt() are used: the same input gives the same bits.

   SPDX-License-Identifier: MIT */

#ifndef STONES_H
#define STONES_H

#include "../../kern.h"
#include "build.h"
#include "../parts/random.h"
#include "rigid.h"
#include "../parts/text.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define STONES_API static __attribute__((unused))
#else
#define STONES_API static
#endif

enum { STONES_CORNERS = 64, STONES_BEDS = 8, STONES_MOST = 1000 };

/* Counter-clockwise; in a stock about its centroid, in a wall in place. */
struct stone {
    kern_vec v[STONES_CORNERS];
    int n;
    kern_vec centre;
    double area;
    double reach;              /* of the farthest corner, from the centre */
    kern_vec low, high;        /* its box                                 */
    kern_vec turn;             /* by which it was turned: cosine, sine    */
    kern_vec bed[STONES_BEDS]; /* directions of the longest edges of its
                                  hull, as in the stock                */
    int beds;
};

struct stones {
    struct stone *stone;
    int stones;
    int pins;          /* of them: stones_is_pin()                */
    double size;       /* mean square root of the areas, no pins  */
    double area;       /* mean, no pins                           */
    char message[600]; /* what is wrong                           */
};

/* ---- Vectors ------------------------------------------------------------- */

static kern_vec stones_vec(double x, double y)
{
    const kern_vec v = {x, y};
    return v;
}

static kern_vec stones_sub(kern_vec a, kern_vec b)
{
    return stones_vec(a.x - b.x, a.y - b.y);
}

static double stones_dot(kern_vec a, kern_vec b)
{
    return a.x * b.x + a.y * b.y;
}

static double stones_cross(kern_vec a, kern_vec b)
{
    return a.x * b.y - a.y * b.x;
}

static kern_vec stones_unit(kern_vec a)
{
    double length = sqrt(stones_dot(a, a));
    return stones_vec(a.x / length, a.y / length);
}

/* p turned by the angle whose cosine and sine are q. */
static kern_vec stones_turned(kern_vec q, kern_vec p)
{
    return stones_vec(q.x * p.x - q.y * p.y, q.y * p.x + q.x * p.y);
}

/* ---- A stone ------------------------------------------------------------- */

/* Box and reach after the corners have moved with the centre. */
STONES_API void stone_frame(struct stone *s)
{
    s->low = s->high = s->v[0];
    for (int i = 1; i < s->n; i++) {
        s->low.x = fmin(s->low.x, s->v[i].x);
        s->low.y = fmin(s->low.y, s->v[i].y);
        s->high.x = fmax(s->high.x, s->v[i].x);
        s->high.y = fmax(s->high.y, s->v[i].y);
    }
}

STONES_API void stone_move(struct stone *s, kern_vec way)
{
    for (int i = 0; i < s->n; i++)
        s->v[i] = stones_vec(s->v[i].x + way.x, s->v[i].y + way.y);
    s->centre = stones_vec(s->centre.x + way.x, s->centre.y + way.y);
    s->low = stones_vec(s->low.x + way.x, s->low.y + way.y);
    s->high = stones_vec(s->high.x + way.x, s->high.y + way.y);
}

/* Turns it about a point, by the angle with this cosine and sine. */
STONES_API void stone_turn(struct stone *s, kern_vec about, kern_vec turn)
{
    for (int i = 0; i < s->n; i++) {
        kern_vec p = stones_turned(turn, stones_sub(s->v[i], about));
        s->v[i] = stones_vec(about.x + p.x, about.y + p.y);
    }
    kern_vec c = stones_turned(turn, stones_sub(s->centre, about));
    s->centre = stones_vec(about.x + c.x, about.y + c.y);
    s->turn = stones_unit(stones_turned(turn, s->turn));
    stone_frame(s);
}

/* Finds the edges of the hull that a stone may lie on: the longest first, none
   like one before it. A stone of many corners lies on few of them. Edges shorter
   than a fifth of its size are none, but the longest always is one. */
static void stone_find_beds(struct stone *s)
{
    const double alike = 0.9986; /* cosine of 3 degrees */
    const int most = s->n > STONES_BEDS ? STONES_BEDS / 2 : STONES_BEDS;
    struct rigid_pt p[STONES_CORNERS], hull[2 * STONES_CORNERS];
    double last = HUGE_VAL;
    int n;
    for (int i = 0; i < s->n; i++)
        p[i] = rigid_vec(s->v[i].x, s->v[i].y);
    n = build_hull(p, s->n, hull);
    s->beds = 0;
    while (s->beds < most) {
        const double least = s->beds > 0 ? 0.04 * s->area : 0;
        double longest = least;
        kern_vec bed = {0, 0};
        for (int i = 0; i < n; i++) {
            struct rigid_pt e = rigid_sub(hull[(i + 1) % n], hull[i]);
            double square = rigid_dot(e, e);
            if (square <= longest || square >= last)
                continue;
            longest = square;
            bed = stones_unit(stones_vec(e.x, e.y));
        }
        if (!(longest > least))
            break;
        last = longest;
        int like = 0;
        for (int k = 0; k < s->beds; k++)
            like |= stones_dot(bed, s->bed[k]) > alike;
        if (!like)
            s->bed[s->beds++] = bed;
    }
}

/* Fills a stone from corners in either order, about its centroid. */
STONES_API int stone_of(struct stone *s, const kern_vec *v, int n)
{
    kern_block b;
    if (n > STONES_CORNERS || kern_block_init(&b, v, n, 1, NULL) != KERN_OK)
        return -1;
    s->n = n;
    s->area = fabs(b.area);
    s->centre = stones_vec(0, 0);
    s->turn = stones_vec(1, 0);
    s->reach = 0;
    for (int i = 0; i < n; i++) {
        s->v[i] = stones_sub(v[b.area > 0 ? i : n - 1 - i], b.centre);
        s->reach = fmax(s->reach, sqrt(stones_dot(s->v[i], s->v[i])));
    }
    stone_frame(s);
    stone_find_beds(s);
    return 0;
}

/* Cuts off the part of a polygon where n.p > limit; room for one corner more
   an edge. Where it falls into pieces, seams of no width join them. */
static int stones_cut(const kern_vec *v, int n, kern_vec normal, double limit,
                      kern_vec *out)
{
    int k = 0;
    for (int i = 0; i < n; i++) {
        kern_vec p = v[i], q = v[i + 1 < n ? i + 1 : 0];
        double a = stones_dot(normal, p) - limit;
        double b = stones_dot(normal, q) - limit;
        if (a <= 0)
            out[k++] = p;
        if ((a < 0 && b > 0) || (a > 0 && b < 0))
            out[k++] = stones_vec(p.x + a / (a - b) * (q.x - p.x),
                                  p.y + a / (a - b) * (q.y - p.y));
    }
    return k;
}

/* The area of the part in a frame from 0, 0 to width, height. */
STONES_API double stone_area_in(const struct stone *s, double width,
                                double height)
{
    const kern_vec normal[4] = {{-1, 0}, {1, 0}, {0, -1}, {0, 1}};
    const double limit[4] = {0, width, 0, height};
    kern_vec v[2][STONES_CORNERS * 16];
    double sum = 0;
    int n = s->n;
    for (int i = 0; i < n; i++)
        v[0][i] = s->v[i];
    for (int k = 0; k < 4; k++)
        n = stones_cut(v[k % 2], n, normal[k], limit[k], v[(k + 1) % 2]);
    for (int i = 0; i < n; i++)
        sum += stones_cross(v[0][i], v[0][i + 1 < n ? i + 1 : 0]) / 2;
    return sum;
}

/* Returns the area of a stone in place below a height. */
STONES_API double stone_area_below(const struct stone *s, double height)
{
    const kern_vec up = {0, 1};
    kern_vec v[2 * STONES_CORNERS];
    const int n = stones_cut(s->v, s->n, up, height, v);
    double sum = 0;
    for (int i = 1; i + 1 < n; i++)
        sum += stones_cross(stones_sub(v[i], v[0]), stones_sub(v[i + 1], v[0]))
             / 2;
    return sum;
}

/* Takes away the part of a stone in place where n.p > limit. Returns 0, or -1
   where nothing that is a stone is left. */
STONES_API int stone_dress(struct stone *s, kern_vec n, double limit)
{
    kern_vec v[2 * STONES_CORNERS];
    const int corners = stones_cut(s->v, s->n, n, limit, v);
    kern_block b;
    if (corners > STONES_CORNERS
        || kern_block_init(&b, v, corners, 1, NULL) != KERN_OK)
        return -1;
    s->n = corners;
    s->area = fabs(b.area);
    s->centre = b.centre;
    for (int i = 0; i < corners; i++)
        s->v[i] = v[i];
    stone_frame(s);
    return 0;
}

/* ---- Stocks -------------------------------------------------------------- */

STONES_API void stones_free(struct stones *s)
{
    free(s->stone);
    s->stone = NULL;
}

static int stones_fail(struct stones *s, const char *what, const char *why)
{
    snprintf(s->message, sizeof s->message, "%s%s%s", what, *why ? ": " : "",
             why);
    return -1;
}

/* A pin wedges others: it has less than a fifth of the square of their mean
   size. */
STONES_API int stones_is_pin(const struct stones *s, const struct stone *one)
{
    const double share = 0.2;
    return one->area < share * s->size * s->size;
}

static void stones_count_pins(struct stones *s)
{
    s->pins = 0;
    for (int i = 0; i < s->stones; i++)
        s->pins += stones_is_pin(s, &s->stone[i]);
}

/* Mean size and area without the pins of the means so far; counts pins anew. */
static void stones_mean(struct stones *s)
{
    const int stones = s->stones - s->pins;
    double area = 0, size = 0;
    for (int i = 0; i < s->stones; i++)
        if (!stones_is_pin(s, &s->stone[i])) {
            area += s->stone[i].area / stones;
            size += sqrt(s->stone[i].area) / stones;
        }
    s->area = area;
    s->size = size;
    stones_count_pins(s);
}

/* From the mean area weighed by area, which pins hardly change, until their
   number does not: the means grow or shrink from step to step alike. */
static int stones_sum_up(struct stones *s)
{
    double sum = 0, square = 0;
    int before = -1;
    for (int i = 0; i < s->stones; i++) {
        sum += s->stone[i].area;
        square += s->stone[i].area * s->stone[i].area;
    }
    s->size = sqrt(square / sum);
    stones_count_pins(s);
    while (s->pins != before) {
        before = s->pins;
        stones_mean(s);
    }
    return 0;
}

/* The blocks of a structure file, in any pose, are the stock; what is fixed
   there is left out. Returns 0, or -1 with a message. */
STONES_API int stones_load(struct stones *s, const char *path)
{
    struct text_file t;
    char line[40];
    int bad = text_load(&t, path), stones = t.blocks - t.fixed;
    s->stones = 0;
    s->stone = NULL;
    if (bad) {
        snprintf(line, sizeof line, "line %d", t.line);
        if (t.line)
            stones_fail(s, line, t.message);
        else
            stones_fail(s, t.message, "");
    } else if (stones > STONES_MOST) {
        bad = stones_fail(s, "more than 1000 stones", "");
    } else {
        s->stone = calloc((size_t)stones, sizeof *s->stone);
        if (!s->stone)
            bad = stones_fail(s, "not enough memory", "");
    }
    for (int i = 0; i < t.blocks && !bad; i++)
        if (!t.block[i].fixed
            && stone_of(&s->stone[s->stones++], t.block[i].vertex,
                        t.block[i].vertices))
            bad = stones_fail(s, t.name[i], "a stone of more than 64 corners");
    text_free(&t);
    return bad ? -1 : stones_sum_up(s);
}

/* A convex stone of irregularity L in per cent, f = L/100, area about 1: a
   rectangle 3:2 whose area varies by 0.15 + 0.2 f (standard deviation), on each
   side with probability min(0.7, 2 f) one more point in its middle part, every
   point moved by up to 0.75 f of the sides, the convex hull, made smaller by
   what moving adds. Corners that stand out by less than 0.012 are none. */
STONES_API void stone_make(uint64_t *state, double level, struct stone *s)
{
    const double f = level / 100, shrink = 1 / sqrt(1 + 0.42 * f);
    do {
        struct rigid_pt p[8], hull[2 * 8];
        kern_vec v[8];
        double area = 1
                    + (0.15 + 0.2 * f) * sqrt(3) * random_uniform(state, -1, 1);
        double high = sqrt(area / 1.5), wide = 1.5 * high;
        int n = 4, k;
        for (int i = 0; i < 4; i++)
            p[i] = rigid_vec(i == 1 || i == 2 ? wide : 0, i > 1 ? high : 0);
        for (int i = 0; i < 4; i++)
            if (random_uniform(state, 0, 1) < fmin(0.7, 2 * f)) {
                double at = random_uniform(state, 0.3, 0.7);
                struct rigid_pt q = p[i], r = p[(i + 1) % 4];
                p[n++] = rigid_vec(q.x + at * (r.x - q.x),
                                   q.y + at * (r.y - q.y));
            }
        for (int i = 0; i < n; i++) {
            p[i].x = shrink
                   * (p[i].x + 0.75 * f * wide * random_uniform(state, -1, 1));
            p[i].y = shrink
                   * (p[i].y + 0.75 * f * high * random_uniform(state, -1, 1));
        }
        n = build_hull(p, n, hull);
        for (int i = k = 0; i < n; i++) {
            struct rigid_pt before = k ? rigid_vec(v[k - 1].x, v[k - 1].y)
                                       : hull[n - 1];
            struct rigid_pt chord = rigid_sub(hull[(i + 1) % n], before);
            double out = rigid_cross(chord, rigid_sub(hull[i], before));
            if (-out >= 0.012 * rigid_length(chord))
                v[k++] = stones_vec(hull[i].x, hull[i].y);
        }
        s->area = 0;
        if (k >= 3)
            stone_of(s, v, k);
    } while (s->area < 0.12);
}

/* A chip, as a mason knocks it off a stone of area 1: a wedge of 0.02 to 0.15
   of it, 1.2 to 3 times as long as thick, thin at one end. */
STONES_API void stone_make_chip(uint64_t *state, struct stone *s)
{
    const double share = random_uniform(state, 0, 1);
    const double area = 0.02 + 0.13 * share * share;
    const double length = sqrt(area * random_uniform(state, 1.2, 3));
    const double thin = random_uniform(state, 0.1, 0.6);
    const double thick = 2 * area / (length * (1 + thin));
    const kern_vec v[4] = {stones_vec(0, 0), stones_vec(length, 0),
                           stones_vec(length, thick),
                           stones_vec(0, thin * thick)};
    stone_of(s, v, 4);
}

/* Makes a stock, with so many chips. Returns 0, or -1 with a message. */
STONES_API int stones_make(struct stones *s, double level, int stones,
                           int chips, uint64_t seed)
{
    uint64_t state = random_start(seed);
    s->stones = stones + chips;
    s->stone = calloc((size_t)s->stones, sizeof *s->stone);
    if (!s->stone)
        return stones_fail(s, "not enough memory", "");
    for (int i = 0; i < stones; i++)
        stone_make(&state, level, &s->stone[i]);
    for (int i = stones; i < s->stones; i++)
        stone_make_chip(&state, &s->stone[i]);
    return stones_sum_up(s);
}

/* ---- What a stone may meet ----------------------------------------------- */

struct rest_edge {
    kern_vec a, b; /* the stone is on the left of it */
    kern_vec n;    /* outer normal, unit             */
    int block;     /* whose it is, where that is asked */
};

/* Edges near a place. */
struct rest_near {
    struct rest_edge *edge;
    int edges;
};

/* Lengths, in stones of size 1: what still touches, and what is beside an end
   of an edge. */
static const double rest_touch = 1e-7, rest_beside = 1e-9;

static struct rest_edge rest_edge_of(kern_vec a, kern_vec b)
{
    struct rest_edge e = {a, b, {0, 0}, 0};
    kern_vec t = stones_unit(stones_sub(b, a));
    e.n = stones_vec(t.y, -t.x);
    return e;
}

static struct rest_edge rest_edge_at(const struct stone *s, int i)
{
    return rest_edge_of(s->v[i], s->v[i + 1 < s->n ? i + 1 : 0]);
}

/* Is p, which lies on the line of an edge, between its ends? */
static int rest_on(const struct rest_edge *e, kern_vec p)
{
    kern_vec t = stones_vec(-e->n.y, e->n.x);
    return stones_dot(t, stones_sub(p, e->a)) > -rest_beside
        && stones_dot(t, stones_sub(e->b, p)) > -rest_beside;
}

/* The way along unit vector d after which point p meets edge e from outside. */
static double rest_way_one(const struct rest_edge *e, kern_vec p, kern_vec d)
{
    double into = -stones_dot(e->n, d), gap, way;
    if (into < 1e-9)
        return HUGE_VAL;
    gap = stones_dot(e->n, stones_sub(p, e->a));
    if (gap < -rest_touch)
        return HUGE_VAL;
    way = gap / into;
    return rest_on(e, stones_vec(p.x + way * d.x, p.y + way * d.y))
             ? rigid_most(way, 0)
             : HUGE_VAL;
}

/* Lengths within which nothing that might touch is passed over. */
static const double rest_skip = 1e-6;

/* What a stone covers across a direction, and how far it reaches along it. */
struct rest_span {
    double low, high, reach;
};

static struct rest_span rest_span_of(const struct stone *s, kern_vec d)
{
    struct rest_span span = {HUGE_VAL, -HUGE_VAL, -HUGE_VAL};
    for (int i = 0; i < s->n; i++) {
        const double across = stones_cross(d, s->v[i]);
        span.low = rigid_least(span.low, across);
        span.high = rigid_most(span.high, across);
        span.reach = rigid_most(span.reach, stones_dot(d, s->v[i]));
    }
    return span;
}

/* May the stone that covers a span meet this edge within a way along d? What
   its side only grazes it passes by: it fits where it just fits. */
static int rest_may_meet(const struct rest_span *span,
                         const struct rest_edge *e, kern_vec d, double way)
{
    const double a = stones_cross(d, e->a), b = stones_cross(d, e->b);
    return rigid_most(a, b) > span->low + rest_beside
        && rigid_least(a, b) < span->high - rest_beside
        && rigid_least(stones_dot(d, e->a), stones_dot(d, e->b)) - span->reach
               < way + rest_skip;
}

/* The edges of a stone in place, in the order of its corners. */
static void rest_edges_of(const struct stone *s, struct rest_edge *own)
{
    for (int i = 0; i < s->n; i++)
        own[i] = rest_edge_at(s, i);
}

/* How far a stone can go along d before it touches something. */
STONES_API double rest_way(const struct rest_near *around,
                           const struct stone *s, kern_vec d)
{
    const kern_vec back = stones_vec(-d.x, -d.y);
    const struct rest_span span = rest_span_of(s, d);
    struct rest_edge own[STONES_CORNERS];
    double way = HUGE_VAL;
    rest_edges_of(s, own);
    for (int k = 0; k < around->edges; k++) {
        const struct rest_edge *e = &around->edge[k];
        if (!rest_may_meet(&span, e, d, way))
            continue;
        for (int i = 0; i < s->n; i++) {
            way = rigid_least(way, rest_way_one(e, own[i].a, d));
            if (stones_dot(own[i].n, d) > 0)
                way = rigid_least(way, rest_way_one(&own[i], e->a, back));
        }
    }
    return way;
}

/* ---- What supports a stone ------------------------------------------------ */

/* Does the box of an edge come within a gap of a stone's box? */
static int rest_is_beside(const struct rest_edge *e, const struct stone *s,
                          double gap)
{
    return rigid_most(e->a.x, e->b.x) > s->low.x - gap
        && rigid_least(e->a.x, e->b.x) < s->high.x + gap
        && rigid_most(e->a.y, e->b.y) > s->low.y - gap
        && rigid_least(e->a.y, e->b.y) < s->high.y + gap;
}

/* Notes a point of contact, if its force has a part that points upward. */
static void rest_hold(kern_vec p, double up, kern_vec *left, kern_vec *right)
{
    if (up < 0.05)
        return;
    if (p.x < left->x)
        *left = p;
    if (p.x > right->x)
        *right = p;
}

/* The leftmost and the rightmost point that supports a stone; none: left is to
   the right of right. */
STONES_API void rest_holds(const struct rest_near *around,
                           const struct stone *s, kern_vec *left,
                           kern_vec *right)
{
    struct rest_edge own[STONES_CORNERS];
    *left = stones_vec(HUGE_VAL, 0);
    *right = stones_vec(-HUGE_VAL, 0);
    rest_edges_of(s, own);
    for (int k = 0; k < around->edges; k++) {
        const struct rest_edge *e = &around->edge[k];
        if (!rest_is_beside(e, s, rest_skip))
            continue;
        for (int i = 0; i < s->n; i++) {
            const kern_vec p = own[i].a;
            if (fabs(stones_dot(e->n, stones_sub(p, e->a))) < rest_touch
                && rest_on(e, p))
                rest_hold(p, e->n.y, left, right);
            if (fabs(stones_dot(own[i].n, stones_sub(e->a, p))) < rest_touch
                && rest_on(&own[i], e->a))
                rest_hold(e->a, -own[i].n.y, left, right);
        }
    }
}

/* Lets a stone down. Returns 0 where there is nothing below. */
STONES_API int rest_drop(const struct rest_near *around, struct stone *s)
{
    double way = rest_way(around, s, stones_vec(0, -1));
    if (way < HUGE_VAL)
        stone_move(s, stones_vec(0, -way));
    return way < HUGE_VAL;
}

#endif /* STONES_H */
