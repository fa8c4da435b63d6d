/* masonry.h - counts what a mason sees in a wall: beds, faces off level, head
   joints, the tops of courses, the bond, and the way that a crack takes through
   the joints.

   Sizes of stones are the square roots of their areas. Gravity points to -y.
   Pins are stones of less than a fifth of the square of the mean size. They are
   counted in none of these figures, but a stone may have a bed on one.

   SPDX-License-Identifier: MIT */

#ifndef MASONRY_H
#define MASONRY_H

#include "../../kern.h"

#include <math.h>
#include <stdlib.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define MASONRY_API static __attribute__((unused))
#else
#define MASONRY_API static
#endif

/* Shares of stones are of those above the ground: nothing fixed carries them. A
   support is a block that carries a stone; a bed is a support that touches it
   along 0.15 mean sizes or more, a corner a support that does not. */
struct masonry {
    double on_two;      /* share of stones with beds on two blocks or more */
    double bedless;     /* share of stones without a bed                */
    double corners;     /* share of the supports that are corners       */
    double off_level;   /* share of all stones whose longest face is more
                           than 15 degrees off the level                */
    double gaping;      /* share of the head joints wider than a tenth of
                           a mean size, where the centre of the stone on
                           their left is                                */
    double uneven;      /* deviation of the tops from the mean top of their
                           course, root of the mean square, in mean sizes */
    double end_columns; /* share of the two ends that hold a column: four
                           stones or more, each on the one below alone  */
    double joint;       /* length of the shortest way up through the
                           joints over its height: 1 is a running joint */
    double running;     /* joints that run up through three courses     */
};

static const double masonry_off = 0.25882; /* slope off level: sine of 15 deg */
static const double masonry_wide = 0.1;    /* width of a joint that gapes    */
static const double masonry_point = 0.15;  /* a shorter bed is none          */
static const double masonry_rests = 0.5;   /* normal of what carries: 60 deg  */
static const double masonry_pin = 0.2;     /* below so much of a mean square */
static const double masonry_apart = 0.15;  /* of joints that run on, in sizes */
static const double masonry_step = 0.06;   /* of the ways, in mean sizes     */
static const double masonry_side = 0.6;    /* no way runs nearer to the ends */
static const double masonry_high = 0.8;    /* of the mean top: the end       */

/* ---- Stones ------------------------------------------------------------- */

/* Is a block one of the stones, neither fixed nor a pin where these are of this
   mean size? */
static int masonry_is_stone(const kern_block *b, double size)
{
    return !b->fixed && fabs(b->area) >= masonry_pin * size * size;
}

/* Returns the mean size of the stones. */
static double masonry_mean(const kern_structure *s, double size)
{
    double sum = 0;
    int stones = 0;
    for (int i = 0; i < s->blocks; i++)
        if (masonry_is_stone(&s->block[i], size)) {
            sum += sqrt(fabs(s->block[i].area));
            stones++;
        }
    return stones > 0 ? sum / stones : size;
}

/* ---- Faces off level ----------------------------------------------------- */

/* Returns 1 if the longest face of a polygon is more than 15 degrees off the
   level. Of faces equally long the one that rises least counts. */
MASONRY_API int masonry_is_off(const kern_vec *v, int n)
{
    double longest = -1, least = 0;
    for (int i = 0; i < n; i++) {
        const kern_vec *a = &v[i], *b = &v[i + 1 < n ? i + 1 : 0];
        const double length = hypot(b->x - a->x, b->y - a->y);
        const double rise = fabs(b->y - a->y);
        if (length < longest * (1 - 1e-9))
            continue;
        least = length > longest * (1 + 1e-9) ? rise : fmin(least, rise);
        longest = fmax(longest, length);
    }
    return least > masonry_off * longest;
}

static double masonry_off_level(const kern_structure *s, double size)
{
    int stones = 0, off = 0;
    for (int i = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        if (!masonry_is_stone(b, size))
            continue;
        stones++;
        off += masonry_is_off(b->vertex, b->vertices);
    }
    return stones > 0 ? (double)off / stones : 0;
}

/* ---- Beds ---------------------------------------------------------------- */

/* Returns 1 if contact k carries block `over` on block `under`, at most 60
   degrees off the level. */
static int masonry_is_support(const kern_contact *c, int over, int under)
{
    return c->a + c->b == over + under && (c->n.y > 0 ? c->b : c->a) == over
        && fabs(c->n.y) >= masonry_rests;
}

/* Returns how far the contact points are apart at which one block carries
   another, or -1 where it does not. */
static double masonry_support(const kern_structure *s, int over, int under)
{
    double longest = -1;
    for (int k = 0; k < s->contacts; k++) {
        const kern_contact *c = &s->contact[k];
        if (!masonry_is_support(c, over, under))
            continue;
        longest = fmax(longest, 0);
        for (int j = k + 1; j < s->contacts; j++) {
            const kern_contact *d = &s->contact[j];
            if (masonry_is_support(d, over, under))
                longest = fmax(longest,
                               hypot(c->p.x - d->p.x, c->p.y - d->p.y));
        }
    }
    return longest;
}

/* Supports and beds of a stone; ground: a fixed block is one of them. */
struct masonry_bedding {
    int supports, beds, ground;
};

/* Counts the supports of block i; a bed has this length or more. */
static struct masonry_bedding masonry_bedding_of(const kern_structure *s, int i,
                                                 double least)
{
    struct masonry_bedding b = {0, 0, 0};
    for (int k = 0; k < s->blocks; k++) {
        const double length = k == i ? -1 : masonry_support(s, i, k);
        if (length < 0)
            continue;
        b.supports++;
        b.beds += length >= least;
        b.ground |= s->block[k].fixed;
    }
    return b;
}

/* Counts the beds of the stones above the ground. */
static void masonry_beds(const kern_structure *s, double size,
                         struct masonry *m)
{
    const double least = masonry_point * masonry_mean(s, size);
    int above = 0, two = 0, none = 0, supports = 0, beds = 0;
    for (int i = 0; i < s->blocks; i++) {
        struct masonry_bedding b;
        if (!masonry_is_stone(&s->block[i], size))
            continue;
        b = masonry_bedding_of(s, i, least);
        if (b.ground)
            continue;
        above++;
        two += b.beds >= 2;
        none += b.beds == 0;
        supports += b.supports;
        beds += b.beds;
    }
    m->on_two = above > 0 ? (double)two / above : 0;
    m->bedless = above > 0 ? (double)none / above : 0;
    m->corners = supports > 0 ? (double)(supports - beds) / supports : 0;
}

/* ---- The bond ------------------------------------------------------------ */

enum { MASONRY_COLUMN = 4, MASONRY_PINS = 2, MASONRY_NONE = -1 };

/* What carries a stone, face to face or at a point, at most 60 degrees off the
   level: how many stones, 2 for more, the lowest and the highest index among
   them, and whether the ground does too. */
struct masonry_rest {
    int stones, below, last, ground;
};

/* Adds what carries block i to what is known. Pins on pins are followed so
   deep. */
static void masonry_carries(const kern_structure *s, int i, double size,
                            int deep, struct masonry_rest *r)
{
    for (int k = 0; k < s->contacts; k++) {
        const kern_contact *c = &s->contact[k];
        const int over = c->n.y > 0 ? c->b : c->a, under = c->a + c->b - over;
        if (over != i || fabs(c->n.y) < masonry_rests)
            continue;
        if (s->block[under].fixed) {
            r->ground = 1;
        } else if (!masonry_is_stone(&s->block[under], size)) {
            if (deep > 0)
                masonry_carries(s, under, size, deep - 1, r);
        } else {
            if (r->below == MASONRY_NONE || under < r->below)
                r->below = under;
            if (under > r->last)
                r->last = under;
        }
    }
}

/* Of stones of this mean size. */
static struct masonry_rest masonry_rest_on(const kern_structure *s, int i,
                                           double size)
{
    struct masonry_rest r = {0, MASONRY_NONE, MASONRY_NONE, 0};
    masonry_carries(s, i, size, MASONRY_PINS, &r);
    r.stones = (r.below != MASONRY_NONE) + (r.last > r.below);
    return r;
}

/* Is a stone the last one to a side (-1 left, 1 right) at its own height? */
static int masonry_is_end(const kern_structure *s, int i, double size, int side)
{
    const kern_vec at = s->block[i].centre;
    for (int k = 0; k < s->blocks; k++) {
        const kern_block *b = &s->block[k];
        if (k != i && masonry_is_stone(b, size)
            && side * (b->centre.x - at.x) > 0 && b->box.low.y < at.y
            && at.y < b->box.high.y)
            return 0;
    }
    return 1;
}

/* Stones of the longest column that an end of the wall holds. */
static int masonry_column(const kern_structure *s, double size,
                          const struct masonry_rest *r, int side)
{
    int longest = 0;
    for (int i = 0; i < s->blocks; i++) {
        int count = 0, k = i;
        if (!masonry_is_stone(&s->block[i], size))
            continue;
        for (; k != MASONRY_NONE && masonry_is_end(s, k, size, side)
               && count < s->blocks;
             k = r[k].below) {
            count++;
            if (r[k].stones != 1 || r[k].ground)
                break;
        }
        if (count > longest)
            longest = count;
    }
    return longest;
}

/* The course of every block, in the order in which they were laid: one above
   the highest course that carries it. The ground is 0; a pin is of the course
   that carries it. */
MASONRY_API void masonry_courses(const kern_structure *s, double size,
                                 int *course)
{
    for (int i = 0; i < s->blocks; i++) {
        course[i] = 0;
        for (int k = 0; k < s->contacts; k++) {
            const kern_contact *c = &s->contact[k];
            const int over = c->n.y > 0 ? c->b : c->a;
            const int under = c->a + c->b - over;
            if (over == i && under < i && fabs(c->n.y) >= masonry_rests
                && course[under] > course[i])
                course[i] = course[under];
        }
        course[i] += masonry_is_stone(&s->block[i], size);
    }
}

/* The head joint to the right of block i: the middle between it and the next
   stone of its course, beside it; HUGE_VAL: there is none. */
static double masonry_head_joint(const kern_structure *s, double size,
                                 const int *course, int i)
{
    const kern_block *b = &s->block[i], *next = NULL;
    for (int k = 0; k < s->blocks; k++) {
        const kern_block *c = &s->block[k];
        if (course[k] != course[i] || c->centre.x <= b->centre.x
            || !masonry_is_stone(c, size) || c->box.low.y >= b->box.high.y
            || b->box.low.y >= c->box.high.y)
            continue;
        if (!next || c->centre.x < next->centre.x)
            next = c;
    }
    return next && masonry_is_stone(b, size)
             ? (b->box.high.x + next->box.low.x) / 2
             : HUGE_VAL;
}

/* Through how many courses a joint has come, from below. */
struct masonry_line {
    double x;
    int courses;
};

/* How many joints run on from course to course through three. */
static int masonry_running(const kern_structure *s, double size,
                           struct masonry *m)
{
    const size_t blocks = (size_t)s->blocks + 1;
    struct masonry_line *line = malloc(blocks * sizeof *line);
    int *course = malloc(blocks * sizeof *course), left = s->blocks;
    m->running = 0;
    if (line && course)
        masonry_courses(s, size, course);
    for (int now = 0; line && course && left > 0; now++)
        for (int i = 0; i < s->blocks; i++) {
            if (course[i] != now)
                continue;
            left--;
            line[i].x = masonry_head_joint(s, size, course, i);
            line[i].courses = 1;
            for (int k = 0; k < s->blocks && line[i].x < HUGE_VAL; k++)
                if (course[k] == now - 1
                    && fabs(line[k].x - line[i].x) < masonry_apart * size
                    && line[k].courses >= line[i].courses)
                    line[i].courses = line[k].courses + 1;
            m->running += line[i].courses == 3;
        }
    free(course);
    free(line);
    return left > 0 ? -1 : 0;
}

static int masonry_columns(const kern_structure *s, double size,
                           struct masonry *m)
{
    struct masonry_rest *r = malloc(((size_t)s->blocks + 1) * sizeof *r);
    if (!r)
        return -1;
    for (int i = 0; i < s->blocks; i++)
        r[i] = masonry_rest_on(s, i, size);
    m->end_columns = ((masonry_column(s, size, r, -1) >= MASONRY_COLUMN)
                      + (masonry_column(s, size, r, 1) >= MASONRY_COLUMN))
                   / 2.0;
    free(r);
    return 0;
}

/* ---- Head joints and tops ------------------------------------------------ */

/* Finds the ends of what a block covers at height y; left is the larger where
   it covers nothing. */
static void masonry_ends(const kern_block *b, double y, double *left,
                         double *right)
{
    *left = HUGE_VAL;
    *right = -HUGE_VAL;
    for (int i = 0; i < b->vertices; i++) {
        const kern_vec p = b->vertex[i];
        const kern_vec q = b->vertex[i + 1 < b->vertices ? i + 1 : 0];
        double x;
        if ((p.y < y) == (q.y < y))
            continue;
        x = p.x + (y - p.y) / (q.y - p.y) * (q.x - p.x);
        *left = fmin(*left, x);
        *right = fmax(*right, x);
    }
}

/* Returns the width of the head joint to the right of block i, at the height of
   its centre; HUGE_VAL where no block is there. */
static double masonry_gap(const kern_structure *s, int i)
{
    const kern_vec at = s->block[i].centre;
    double left, right, next = HUGE_VAL, end;
    masonry_ends(&s->block[i], at.y, &left, &right);
    end = right;
    for (int k = 0; k < s->blocks; k++) {
        if (k == i || s->block[k].fixed)
            continue;
        masonry_ends(&s->block[k], at.y, &left, &right);
        if (left < HUGE_VAL && right > end)
            next = fmin(next, fmax(left, end));
    }
    return next - end;
}

static double masonry_gaping(const kern_structure *s, double size)
{
    const double wide = masonry_wide * masonry_mean(s, size);
    int joints = 0, gape = 0;
    for (int i = 0; i < s->blocks; i++) {
        const double gap = masonry_is_stone(&s->block[i], size)
                             ? masonry_gap(s, i)
                             : HUGE_VAL;
        joints += gap < HUGE_VAL;
        gape += gap < HUGE_VAL && gap > wide;
    }
    return joints > 0 ? (double)gape / joints : 0;
}

/* The tops of a course: how many, their mean, and the sum of the squares of
   their deviations. */
struct masonry_tops {
    int stones;
    double mean, squares;
};

static int masonry_uneven(const kern_structure *s, double size,
                          struct masonry *m)
{
    const size_t blocks = (size_t)s->blocks + 1;
    struct masonry_tops *tops = calloc(blocks, sizeof *tops);
    int *course = malloc(blocks * sizeof *course), stones = 0;
    double squares = 0;
    if (tops && course)
        masonry_courses(s, size, course);
    for (int i = 0; tops && course && i < s->blocks; i++) {
        struct masonry_tops *t = &tops[course[i]];
        const double away = s->block[i].box.high.y - t->mean;
        if (!masonry_is_stone(&s->block[i], size))
            continue;
        t->stones++;
        t->mean += away / t->stones;
        t->squares += away * (s->block[i].box.high.y - t->mean);
    }
    for (int i = 0; tops && course && i < s->blocks; i++)
        if (tops[i].stones > 1) {
            stones += tops[i].stones;
            squares += tops[i].squares;
        }
    m->uneven = stones > 0 ? sqrt(squares / stones) / masonry_mean(s, size) : 0;
    stones = tops && course ? 0 : -1;
    free(course);
    free(tops);
    return stones;
}

/* ---- The way through the joints ------------------------------------------ */

struct masonry_place {
    double x, y;
    int stone, before, next; /* neighbours on its outline         */
    double way;              /* from below; what is done is < 0   */
};

/* Points on the outlines of the stones, so far apart; returns how many, or with
   at NULL how many there would be. */
static int masonry_outline(const kern_structure *s, double step,
                           struct masonry_place *at)
{
    int n = 0;
    for (int i = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        const int first = n;
        if (b->fixed)
            continue;
        for (int k = 0; k < b->vertices; k++) {
            kern_vec p = b->vertex[k];
            kern_vec q = b->vertex[k + 1 < b->vertices ? k + 1 : 0];
            const int pieces = (int)ceil(hypot(q.x - p.x, q.y - p.y) / step);
            for (int j = 0; j < pieces; j++, n++) {
                if (!at)
                    continue;
                at[n].x = p.x + (q.x - p.x) * j / pieces;
                at[n].y = p.y + (q.y - p.y) * j / pieces;
                at[n].stone = i;
                at[n].before = n - 1;
                at[n].next = n + 1;
            }
        }
        if (!at || n == first)
            continue;
        at[first].before = n - 1;
        at[n - 1].next = first;
    }
    return n;
}

/* The mean over the width of what is highest. */
static double masonry_top(const struct masonry_place *at, int n, double left,
                          double right)
{
    enum { COLUMNS = 24 };
    double top[COLUMNS] = {0}, sum = 0;
    for (int i = 0; i < n; i++) {
        int c = (int)((at[i].x - left) / (right - left) * COLUMNS);
        c = c < 0 ? 0 : c < COLUMNS ? c : COLUMNS - 1;
        top[c] = fmax(top[c], at[i].y);
    }
    for (int c = 0; c < COLUMNS; c++)
        sum += top[c] / COLUMNS;
    return sum;
}

/* Of the points that are not done, the one with the shortest way; NULL where no
   way leads to any. */
static struct masonry_place *masonry_next(struct masonry_place *at, int n)
{
    struct masonry_place *next = NULL;
    double least = HUGE_VAL;
    for (int i = 0; i < n; i++)
        if (at[i].way >= 0 && at[i].way < least) {
            next = &at[i];
            least = next->way;
        }
    return next;
}

/* Shortens the ways to what is next to a point: its neighbours on the outline,
   and the points of other stones within a step. */
static void masonry_go_on(struct masonry_place *at, int n, double step,
                          const struct masonry_place *p)
{
    for (int i = 0; i < n; i++) {
        const double x = at[i].x - p->x, y = at[i].y - p->y;
        const int beside = i == p->next || i == p->before;
        const int across = at[i].stone != p->stone
                        && x * x + y * y <= step * step;
        if (beside || across)
            at[i].way = fmin(at[i].way, p->way + hypot(x, y));
    }
}

/* The shortest way (Dijkstra) along outlines, and from one to another within a
   step, from the base at y = 0 up to `high`; HUGE_VAL: there is none. */
static double masonry_climb(struct masonry_place *at, int n, double step,
                            double left, double right, double high)
{
    struct masonry_place *p;
    for (int i = 0; i < n; i++)
        at[i].way = at[i].y < step && at[i].x > left && at[i].x < right
                      ? at[i].y
                      : HUGE_VAL;
    while ((p = masonry_next(at, n)) != NULL) {
        if (p->y >= high)
            return p->way / p->y;
        if (p->x >= left && p->x <= right)
            masonry_go_on(at, n, step, p);
        p->way = -1;
    }
    return HUGE_VAL;
}

static int masonry_joints(const kern_structure *s, double size,
                          struct masonry *m)
{
    const double most = 4000; /* points: time grows with their square */
    double left = HUGE_VAL, right = -HUGE_VAL, step = masonry_step * size;
    struct masonry_place *at;
    int n = masonry_outline(s, step, NULL);
    if (n > most)
        step *= n / most;
    n = masonry_outline(s, step, NULL);
    at = malloc(((size_t)n + 1) * sizeof *at);
    if (!at)
        return -1;
    masonry_outline(s, step, at);
    for (int i = 0; i < n; i++) {
        left = fmin(left, at[i].x);
        right = fmax(right, at[i].x);
    }
    m->joint = masonry_climb(
        at, n, step, left + masonry_side * size, right - masonry_side * size,
        masonry_high * masonry_top(at, n, left, right) - 1e-6 * size);
    free(at);
    return 0;
}

/* Counts everything but the way through the joints, of a structure with its
   contacts, whose stones stand on y = 0 and are of this mean size. Returns 0,
   or -1 where memory is lacking. */
MASONRY_API int masonry_count(const kern_structure *s, double size,
                              struct masonry *m)
{
    m->joint = HUGE_VAL;
    m->off_level = masonry_off_level(s, size);
    m->gaping = masonry_gaping(s, size);
    masonry_beds(s, size, m);
    return masonry_columns(s, size, m) || masonry_uneven(s, size, m)
                || masonry_running(s, size, m)
             ? -1
             : 0;
}

/* Counts everything, and finds the way through the joints, which takes the most
   time. Returns 0, or -1 where memory is lacking. */
MASONRY_API int masonry_of(const kern_structure *s, double size,
                           struct masonry *m)
{
    return masonry_count(s, size, m) || masonry_joints(s, size, m) ? -1 : 0;
}

#endif /* MASONRY_H */
