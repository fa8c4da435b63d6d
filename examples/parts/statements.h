/* statements.h - writes the shapes of a drawing or a photograph as statements of
   text.h: blocks, the weight of fill on them, densities, units, and how exact
   the outlines of a photograph are.

   Fill is cut into columns between all corners; a column's weight lies on the
   highest block below it, and is written as one `mass` a block. Fill inside a
   block's outline does not count.

   SPDX-License-Identifier: MIT */

#ifndef STATEMENTS_H
#define STATEMENTS_H

#include "outlines.h"
#include "shapes.h"

enum {
    STATEMENTS_ROLES = 20,      /* labels in a note                       */
    STATEMENTS_ENDS = 500,      /* open paths whose ends are compared     */
    STATEMENTS_FILL = 200000000 /* edges of all columns that are weighed */
};

/* Share of a statement fill that its outline may have more or less. */
#define STATEMENTS_MISFIT 0.02

/* ---- Fill ----------------------------------------------------------------- */

/* Where a column leaves an outline: y at its left side, middle and right. */
struct statements_span {
    double low[3], high[3];
    int block; /* -1: fill                                             */
};

/* Areas of a fill that add no weight: over no block, and within fill whose weight
   is there already. */
struct statements_lost {
    double none, twice;
};

/* Finds the heights at which an edge passes a column. Returns 0 where it
   does not. */
static int statements_edge(struct shapes_point a, struct shapes_point b,
                           double left, double right, double y[3])
{
    const double from = a.x < b.x ? a.x : b.x, to = a.x < b.x ? b.x : a.x;
    if (!(from <= left && to >= right && to > from))
        return 0;
    for (int k = 0; k < 3; k++) {
        const double x = left + (right - left) / 2 * k;
        y[k] = a.y + (b.y - a.y) * (x - a.x) / (b.x - a.x);
    }
    return 1;
}

/* Adds the spans of an outline in a column, from below; n of them are there. */
static int statements_spans(const struct outlines *o, int block, int name,
                            double left, double right,
                            struct statements_span *out, int n, int room)
{
    const struct shapes_path *path = outlines_path(o, block);
    const struct shapes_point *p = outlines_points(o->s, path);
    const int first = n;
    double y[3];
    int found = 0;
    if (o->block[block].left > left || o->block[block].right < right)
        return n;
    for (int i = 0; i < path->points; i++) {
        int at;
        if (!statements_edge(p[i], p[i + 1 < path->points ? i + 1 : 0], left,
                             right, y)
            || n >= room)
            continue;
        /* keeps the heights sorted: low and high are filled in turn */
        for (at = found++; at > 0; at--) {
            struct statements_span *before = out + first + (at - 1) / 2;
            double *below = (at - 1) % 2 ? before->high : before->low;
            double *here = at % 2 ? out[first + at / 2].high
                                  : out[first + at / 2].low;
            if (below[1] <= y[1])
                break;
            memcpy(here, below, 3 * sizeof *here);
        }
        memcpy(at % 2 ? out[first + at / 2].high : out[first + at / 2].low, y,
               sizeof y);
        out[first + (found - 1) / 2].block = name;
        n = first + found / 2;
    }
    return n;
}

/* Adds a piece of a column of fill to the block below it. */
static void statements_weigh(struct outlines *o, double left, double right,
                             const double low[3], const double high[3],
                             double density, int carrier)
{
    struct outlines_block *b = o->block + carrier;
    static const double weight[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    for (int k = 0; k < 3; k++) {
        const double tall = (high[k] - low[k]) * weight[k] * density
                          * (right - left);
        b->mass += tall;
        b->mass_x += tall * (left + (right - left) / 2 * k);
        b->mass_y += tall * (low[k] + high[k]) / 2;
    }
}

/* Finds the lowest span that begins below `high` and ends above `low`, NULL where
   there is none, and in *carrier the highest block below `low`, -1 for none. */
static const struct statements_span *statements_above(
    const struct outlines *o, double low, double high,
    const struct statements_span *span, int n, int *carrier)
{
    const struct statements_span *next = NULL;
    double top = 0;
    *carrier = -1;
    for (int k = 0; k < n; k++) {
        const struct statements_span *b = span + k;
        if (b->high[1] > low + 1e-3 * o->size && b->low[1] < high
            && (!next || b->low[1] < next->low[1]))
            next = b;
        else if (b->high[1] <= low + 1e-3 * o->size && b->block >= 0
                 && (*carrier < 0 || b->high[1] > top)) {
            *carrier = b->block;
            top = b->high[1];
        }
    }
    return next;
}

/* Weighs the pieces of one span of fill between the blocks, and between fill whose
   weight is there already. Adds what has none to *lost. */
static void statements_column(struct outlines *o, double left, double right,
                              const struct statements_span *fill,
                              const struct statements_span *span, int n,
                              double density, struct statements_lost *lost)
{
    const double wide = right - left, top = fill->high[1], *low = fill->low;
    for (;;) {
        int carrier;
        const struct statements_span *next = statements_above(
            o, low[1], top, span, n, &carrier);
        const double *high = next ? next->low : fill->high;
        if (high[1] > low[1] && carrier >= 0)
            statements_weigh(o, left, right, low, high, density, carrier);
        else if (high[1] > low[1])
            lost->none += (high[1] - low[1]) * wide;
        if (next && next->block < 0)
            lost->twice += ((next->high[1] < top ? next->high[1] : top)
                            - (high[1] > low[1] ? high[1] : low[1]))
                         * wide;
        if (!next || !(next->high[1] < top))
            return;
        low = next->high;
    }
}

/* Finds all places where a column may begin, and sorts them. Returns how
   many there are. */
static int statements_corners(const struct outlines *o, double *x, int *index,
                              double left, double right)
{
    int n = 0;
    for (int i = 0; i < o->blocks; i++) {
        const struct shapes_path *path = outlines_path(o, i);
        const struct shapes_point *p = outlines_points(o->s, path);
        for (int k = 0; k < path->points; k++)
            if (p[k].x >= left && p[k].x <= right) {
                index[n] = n;
                x[n++] = p[k].x;
            }
    }
    lines_sort(index, n, x);
    return n;
}

/* The columns of a fill, from left to right: what it and the blocks take up in
   the one that is looked at. */
struct statements_columns {
    double *corner; /* x of each, in no order        */
    int *order;     /* of the corners                */
    struct statements_span *fill, *block;
    int corners, room; /* of the fill; of all outlines  */
    int next;          /* the corner it goes on from    */
    int cut;           /* nonzero: it goes on from `right`, before the next */
    double left, right;
    int fills, blocks; /* spans in it                   */
};

/* Finds the corners between which fill i has its columns. Returns how many there
   are, or -1 where they are too many to weigh. Memory is freed by
   statements_close(). */
static int statements_open(const struct outlines *o, int i, int room,
                           struct statements_columns *c)
{
    struct shapes *s = o->s;
    const struct statements_columns none = {0};
    *c = none;
    c->room = room;
    c->corner = shapes_array(s, room, sizeof *c->corner);
    c->order = shapes_array(s, room, sizeof *c->order);
    c->fill = shapes_array(s, 2 * room, sizeof *c->fill);
    c->block = c->fill ? c->fill + room : NULL;
    if (c->corner && c->order && c->fill)
        c->corners = statements_corners(o, c->corner, c->order,
                                        o->block[i].left, o->block[i].right);
    if ((double)c->corners * room > STATEMENTS_FILL)
        c->corners = -1;
    return c->corners;
}

/* Finds what the fill, the blocks, and fill whose weight is there already take up
   in the column. */
static void statements_look(const struct outlines *o, int i,
                            struct statements_columns *c)
{
    c->fills = statements_spans(o, i, -1, c->left, c->right, c->fill, 0,
                                c->room);
    c->blocks = 0;
    for (int b = 0; b < o->blocks; b++) {
        const int fill = outlines_path(o, b)->role == SHAPES_FILL;
        if (!fill || (b != i && o->block[b].counted))
            c->blocks = statements_spans(o, b, fill ? -1 : b, c->left, c->right,
                                         c->block, c->blocks, c->room - 1);
    }
}

/* Finds where the line from p[0] at the left to p[2] at the right of a column
   crosses another, as a share of the width. Returns the less of that and `most`. */
static double statements_cross(const double p[3], const double q[3],
                               double least, double most)
{
    const double from = p[0] - q[0], to = p[2] - q[2];
    const double share = (from < 0) == (to < 0) ? 1 : from / (from - to);
    return share > least && share < most ? share : most;
}

/* Ends the column where the fill first crosses fill whose weight is there, which
   is between corners. Returns 1 if it does. */
static int statements_cut(const struct outlines *o,
                          struct statements_columns *c)
{
    const double wide = c->right - c->left, least = 1e-9 * o->size / wide;
    double share = 1 - least;
    for (int f = 0; f < c->fills; f++)
        for (int k = 0; k < c->blocks; k++) {
            const struct statements_span *p = c->fill + f, *q = c->block + k;
            if (q->block >= 0)
                continue;
            share = statements_cross(p->low, q->low, least, share);
            share = statements_cross(p->low, q->high, least, share);
            share = statements_cross(p->high, q->low, least, share);
            share = statements_cross(p->high, q->high, least, share);
        }
    if (!(share < 1 - least))
        return 0;
    c->right = c->left + share * wide;
    return 1;
}

/* Goes on to the next column that has a width. Returns 0 where there is none. */
static int statements_next(const struct outlines *o, int i,
                           struct statements_columns *c)
{
    while (c->next + 1 < c->corners) {
        const double end = c->corner[c->order[c->next + 1]];
        c->left = c->cut ? c->right : c->corner[c->order[c->next]];
        c->right = end;
        c->cut = 0;
        while (c->right - c->left > 1e-9 * o->size) {
            statements_look(o, i, c);
            if (c->cut || !statements_cut(o, c))
                break;
            c->cut = 1;
        }
        c->next += !c->cut;
        if (c->right - c->left > 1e-9 * o->size)
            return 1;
    }
    return 0;
}

static void statements_close(struct statements_columns *c)
{
    free(c->corner);
    free(c->order);
    free(c->fill);
}

/* Lays the weight of one fill on the blocks below it. Writes the shares of it that
   add none. Returns 0, or -1 where it was too much to weigh. */
static int statements_lay(struct outlines *o, int i, int corners,
                          double density, struct statements_lost *lost)
{
    const double area = outlines_path(o, i)->area;
    struct statements_columns c;
    const int known = statements_open(o, i, corners, &c);
    lost->none = lost->twice = 0;
    while (statements_next(o, i, &c))
        for (int f = 0; f < c.fills; f++)
            statements_column(o, c.left, c.right, c.fill + f, c.block, c.blocks,
                              density, lost);
    statements_close(&c);
    lost->none /= area;
    lost->twice /= area;
    return known < 0 ? -1 : 0;
}

static void statements_put(struct shapes_text *t, double x)
{
    shapes_put(t, " ");
    shapes_put_number(t, x, 4);
}

static void statements_number(struct shapes *s, double x)
{
    shapes_put(&s->text, " ");
    shapes_put_number(&s->text, x, 17);
}

/* Returns 1 if a fill is level on top: an edge or edges at its highest, over
   most of its width. */
static int statements_level(const struct outlines *o, int i)
{
    const struct outlines_block *b = o->block + i;
    const struct shapes_path *path = outlines_path(o, i);
    const struct shapes_point *p = outlines_points(o->s, path);
    const double slack = 1e-3 * (b->right - b->left);
    double level = 0;
    for (int k = 0; k < path->points; k++) {
        const struct shapes_point *q = p + (k + 1 < path->points ? k + 1 : 0);
        const double wide = q->x > p[k].x ? q->x - p[k].x : p[k].x - q->x;
        if (p[k].y > b->high - slack && q->y > b->high - slack)
            level += wide;
    }
    return level > 0.9 * (b->right - b->left);
}

/* Says of a fill that it is a statement of its own. */
static void statements_note_push(struct outlines *o, int i)
{
    struct shapes *s = o->s;
    shapes_put(&s->notes, "fill: ");
    shapes_put_shown(&s->notes, shapes_at(s, o->block[i].name));
    shapes_put(&s->notes, " is no stone: up to y = ");
    shapes_put_number(&s->notes, o->block[i].high, 4);
    shapes_put(&s->notes, " it lies on the stones, pushes them back as they "
                          "move into it, and spreads axles\n");
}

/* Writes the statement of a fill that pushes back. */
static void statements_push(struct outlines *o, int i)
{
    struct shapes *s = o->s;
    const struct outlines_block *b = o->block + i;
    const double told = shapes_density(
        s, shapes_at(s, outlines_path(o, i)->label));
    shapes_put(&s->text, "fill");
    statements_number(s, b->high);
    statements_number(s, told > 0 ? told : 1);
    shapes_put(&s->text, " phi");
    statements_number(s, s->asked->phi);
    shapes_put(&s->text, " from");
    statements_number(s, b->left);
    shapes_put(&s->text, " to");
    statements_number(s, b->right);
    shapes_put(&s->text, "\n");
}

/* Returns 1 if some of the weight of a fill lies on stones. */
static int statements_lies(struct outlines *o, int i, int corners,
                           double density)
{
    struct outlines_block *before = shapes_array(o->s, o->blocks,
                                                 sizeof *before);
    struct statements_lost lost;
    double mass = 0;
    if (!before)
        return 0;
    memcpy(before, o->block, (size_t)o->blocks * sizeof *before);
    statements_lay(o, i, corners, density, &lost);
    for (int j = 0; j < o->blocks; j++)
        if (outlines_path(o, j)->role == SHAPES_STONE)
            mass += o->block[j].mass - before[j].mass;
    memcpy(o->block, before, (size_t)o->blocks * sizeof *before);
    free(before);
    o->block[i].idle = !(mass > 0);
    return mass > 0;
}

/* Finds on what a statement fill would lie in a column: on the highest block, or
   on a fill below that is such a statement. Returns 0 where that is no stone. */
static int statements_floor(const struct outlines *o, int i, double left,
                            double right, const struct statements_span *span,
                            int n, double floor[3])
{
    int stone = 0;
    for (int k = 0; k < n; k++)
        if (k == 0 || span[k].high[1] > floor[1]) {
            memcpy(floor, span[k].high, sizeof span[k].high);
            stone = outlines_path(o, span[k].block)->role == SHAPES_STONE;
        }
    for (int j = 0; j < o->blocks && stone; j++) {
        const struct outlines_block *b = o->block + j;
        if (j == i || !b->pushes || b->left > left || b->right < right)
            continue;
        for (int k = 0; k < 3; k++)
            floor[k] = b->high > floor[k] ? b->high : floor[k];
    }
    return stone;
}

/* Adds what a statement fill would fill in a column, and by how much its outline
   differs from that. */
static void statements_differ(double wide, double top, const double floor[3],
                              const struct statements_span *fill, int fills,
                              double *all, double *differs)
{
    static const double weight[3] = {1.0 / 6, 4.0 / 6, 1.0 / 6};
    double want = 0, have = 0;
    for (int k = 0; k < 3; k++) {
        want += top > floor[k] ? weight[k] * (top - floor[k]) : 0;
        for (int f = 0; f < fills; f++) {
            const double low = fill[f].low[k] > floor[k] ? fill[f].low[k]
                                                         : floor[k];
            have += fill[f].high[k] > low ? weight[k] * (fill[f].high[k] - low)
                                          : 0;
        }
    }
    *all += wide * want;
    *differs += wide * shapes_abs(want - have);
}

/* Returns the share of a statement fill, from its top down to the stones or to
   such a fill below, by which its outline is not that: 1 where it is none. */
static double statements_misfit(const struct outlines *o, int i, int corners)
{
    struct statements_columns c;
    double all = 0, differs = 0, floor[3];
    statements_open(o, i, corners, &c);
    while (statements_next(o, i, &c))
        if (statements_floor(o, i, c.left, c.right, c.block, c.blocks, floor))
            statements_differ(c.right - c.left, o->block[i].high, floor, c.fill,
                              c.fills, &all, &differs);
    statements_close(&c);
    return all > 0 ? differs / all : 1;
}

/* Finds which fill weighs on stones, and which of it pushes back and spreads
   loads, from the lowest: it is level on top and goes down to the stones, or to
   such a fill. */
static void statements_pushes(struct outlines *o, int corners)
{
    struct shapes *s = o->s;
    double *top = shapes_array(s, o->blocks, sizeof *top);
    int *index = shapes_array(s, o->blocks, sizeof *index), n = 0;
    for (int i = 0; i < o->blocks && top && index && !s->lost; i++) {
        const double density = shapes_density(
            s, shapes_at(s, outlines_path(o, i)->label));
        top[i] = o->block[i].high;
        if (outlines_path(o, i)->role == SHAPES_FILL
            && statements_lies(o, i, corners, density > 0 ? density : 1)
            && s->asked->phi > 0 && statements_level(o, i))
            index[n++] = i;
    }
    if (n > 0)
        lines_sort(index, n, top);
    for (int k = 0; k < n; k++) {
        struct outlines_block *b = o->block + index[k];
        b->misfit = statements_misfit(o, index[k], corners);
        b->pushes = b->misfit <= STATEMENTS_MISFIT;
    }
    free(top);
    free(index);
}

/* Says of a fill that it weighs on no stone. */
static void statements_note_idle(struct outlines *o, int i)
{
    struct shapes *s = o->s;
    shapes_put(&s->notes, "fill: ");
    shapes_put_shown(&s->notes, shapes_at(s, o->block[i].name));
    shapes_put(&s->notes, " lies on no stone and counts for nothing\n");
}

/* Counts the steep edges of stones that fill i lies against on one side, +1 the
   right of the stones: those whose middle, moved outwards, is in the fill. */
static int statements_against(const struct outlines *o, int i, int side)
{
    const struct shapes_path *fill = outlines_path(o, i);
    const struct shapes_point *around = outlines_points(o->s, fill);
    const double reach = 0.05 * o->size;
    int count = 0;
    for (int j = 0; j < o->blocks; j++) {
        const struct shapes_path *path = outlines_path(o, j);
        const struct shapes_point *p = outlines_points(o->s, path);
        const double turn = lines_area(p, path->points) < 0 ? -1 : 1;
        for (int k = 0; k < path->points && path->role == SHAPES_STONE; k++) {
            const struct shapes_point a = p[k];
            const struct shapes_point b = p[k + 1 < path->points ? k + 1 : 0];
            const double rise = b.y - a.y, wide = shapes_abs(b.x - a.x);
            struct shapes_point at = {0, 0, 0};
            at.x = (a.x + b.x) / 2 + side * reach;
            at.y = (a.y + b.y) / 2;
            count += side * turn * rise > 2 * wide
                  && side * turn * rise > 0.2 * o->size
                  && lines_inside(around, fill->points, at);
        }
    }
    return count;
}

/* Returns 1 if a fill reaches no higher than the stones: it stands behind a wall
   and not on a bridge. */
static int statements_behind(const struct outlines *o, int i)
{
    double high = o->block[i].low;
    for (int j = 0; j < o->blocks; j++)
        if (outlines_path(o, j)->role == SHAPES_STONE
            && o->block[j].high > high)
            high = o->block[j].high;
    return o->block[i].high < high + 0.5 * o->size;
}

/* Says that the thrust of fill behind a wall does not count, and by what it would:
   a statement that holds the weight on steps of the back, too. */
static void statements_note_thrust(struct outlines *o, int i, double density)
{
    static const char *const word[] = {"left", "right"};
    struct shapes *s = o->s;
    for (int side = 0; side < 2; side++) {
        const int faces = statements_against(o, i, 2 * side - 1);
        if (faces == 0 || !statements_behind(o, i))
            continue;
        shapes_put(&s->notes, "fill: ");
        shapes_put_shown(&s->notes, shapes_at(s, o->block[i].name));
        shapes_put(&s->notes, " lies against ");
        shapes_put_int(&s->notes, faces);
        shapes_put(&s->notes, faces == 1 ? " steep face" : " steep faces");
        shapes_put(&s->notes,
                   ", and its thrust is not counted; to count it, say "
                   "--layer \"");
        shapes_put_shown(&s->notes, shapes_at(s, outlines_path(o, i)->label));
        shapes_put(&s->notes,
                   "=ignore\" --kern OUT.kern and write in that file: "
                   "earth ");
        shapes_put(&s->notes, word[side]);
        statements_put(&s->notes, o->block[i].high);
        statements_put(&s->notes, density);
        if (s->asked->phi > 0)
            statements_put(&s->notes, s->asked->phi);
        shapes_put(&s->notes, s->asked->phi > 0 ? " DELTA" : " PHI DELTA");
        shapes_put(&s->notes,
                   " (degrees; DELTA: friction of the wall, from 0 to "
                   "2/3 PHI)\n");
    }
}

/* Says why a fill is weight alone. */
static void statements_note_misfit(struct outlines *o, int i)
{
    struct shapes *s = o->s;
    const double misfit = o->block[i].misfit;
    if (!(s->asked->phi > 0)) {
        shapes_put(&s->notes, " (--phi PHI; statements fill and earth)");
        return;
    }
    if (!(misfit > 0)) {
        shapes_put(&s->notes, ", since it is not level on top");
        return;
    }
    shapes_put(&s->notes, ", since its outline differs by ");
    shapes_put_number(&s->notes, 100 * misfit, 3);
    shapes_put(&s->notes, " % from a fill that goes from its top down to the "
                          "stones: a void, another outline or a slope");
}

/* Says a share of a fill that adds no weight, where it is more than 1 %. */
static void statements_note_lost(struct shapes *s, double share,
                                 const char *where)
{
    if (!(share > 0.01))
        return;
    shapes_put(&s->notes, "; ");
    shapes_put_number(&s->notes, 100 * share, 2);
    shapes_put(&s->notes, where);
}

/* Lays the weight of a fill that is weight alone, and says so. */
static void statements_lay_alone(struct outlines *o, int i, int corners,
                                 double density)
{
    struct shapes *s = o->s;
    struct statements_lost lost;
    const int bad = statements_lay(o, i, corners, density, &lost);
    o->block[i].counted = 1;
    shapes_put(&s->notes, "fill: ");
    shapes_put_shown(&s->notes, shapes_at(s, o->block[i].name));
    if (bad) {
        shapes_put(&s->notes, " has too many corners and counts for nothing\n");
        return;
    }
    shapes_put(&s->notes, " is no stone: its weight, of density ");
    shapes_put_number(&s->notes, density, 4);
    shapes_put(&s->notes, ", lies on the blocks right below it; it gives "
                          "neither thrust nor support");
    statements_note_misfit(o, i);
    statements_note_lost(s, lost.none, " % of it lies on nothing");
    statements_note_lost(s, lost.twice,
                         " % of it is drawn over other fill, and counts once");
    shapes_put(&s->notes, "\n");
}

/* Lays the weight of all fill, and says so. */
static void statements_fill(struct outlines *o)
{
    struct shapes *s = o->s;
    int corners = 2;
    for (int i = 0; i < o->blocks; i++)
        corners += outlines_path(o, i)->points;
    statements_pushes(o, corners);
    for (int i = 0; i < o->blocks; i++)
        o->block[i].counted = o->block[i].pushes;
    for (int i = 0; i < o->blocks && !s->lost; i++) {
        const char *label = shapes_at(s, outlines_path(o, i)->label);
        double density;
        if (outlines_path(o, i)->role != SHAPES_FILL)
            continue;
        density = shapes_density(s, label);
        density = density > 0 ? density : 1;
        statements_note_thrust(o, i, density);
        if (o->block[i].idle)
            statements_note_idle(o, i);
        else if (o->block[i].pushes)
            statements_note_push(o, i);
        else
            statements_lay_alone(o, i, corners, density);
    }
}

/* ---- Text ----------------------------------------------------------------- */

static void statements_block(struct outlines *o, int i, double *density)
{
    struct shapes *s = o->s;
    const struct shapes_path *path = outlines_path(o, i);
    const struct shapes_point *p = outlines_points(s, path);
    const double told = shapes_density(s, shapes_at(s, path->label));
    const double own = told > 0 ? told : 1;
    const int fixed = path->role == SHAPES_GROUND;
    if (!fixed && (own < *density || own > *density)) {
        *density = own;
        shapes_put(&s->text, "density");
        statements_number(s, own);
        shapes_put(&s->text, "\n");
    }
    shapes_put(&s->text, fixed ? "fixed " : "block ");
    shapes_put(&s->text, shapes_at(s, o->block[i].name));
    shapes_put(&s->text, fixed ? "" : " *");
    for (int k = 0; k < path->points; k++) {
        shapes_put(&s->text, " ");
        statements_number(s, p[k].x);
        statements_number(s, p[k].y);
    }
    shapes_put(&s->text, "\n");
}

/* Writes the error of a photograph's outlines, which contacts must bear.
   Returns -1 where it is too much of a block. */
static int statements_error(struct outlines *o)
{
    struct shapes *s = o->s;
    double size = 0, angle;
    int n = 0;
    if (!(o->exact > 0))
        return 0;
    for (int i = 0; i < o->blocks; i++)
        if (outlines_path(o, i)->role == SHAPES_STONE) {
            size += o->block[i].size;
            n++;
        }
    angle = n > 0 ? o->exact * n / size : 0;
    if (angle > 0.2) {
        struct shapes_text *t = shapes_fault(s, 0);
        shapes_put(t, "blocks of ");
        shapes_put_number(t, o->exact / angle / s->unit, 3);
        shapes_put(t, " pixels in the mean, of which an error of ");
        shapes_put_number(t, o->exact / s->unit, 3);
        shapes_put(t, " (pixel and tolerance) is more than a fifth");
        return -1;
    }
    shapes_put(&s->text, "measured");
    statements_number(s, o->exact);
    if (angle > 0)
        statements_number(s, angle);
    shapes_put(&s->text, "\n");
    return 0;
}

/* Writes a friction of block i, or of blocks i and j. */
static void statements_mu(struct outlines *o, double mu, int i, int j)
{
    struct shapes *s = o->s;
    shapes_put(&s->text, "friction");
    statements_number(s, mu);
    shapes_put(&s->text, " ");
    shapes_put(&s->text, shapes_at(s, o->block[i].name));
    if (j >= 0) {
        shapes_put(&s->text, " ");
        shapes_put(&s->text, shapes_at(s, o->block[j].name));
    }
    shapes_put(&s->text, "\n");
}

/* Is a block, no fill, on this layer? */
static int statements_on(const struct outlines *o, int i, const char *word,
                         int n)
{
    const struct shapes_path *path = outlines_path(o, i);
    return path->role != SHAPES_FILL
        && shapes_same(word, n, shapes_at(o->s, path->label));
}

/* Writes what the user says of the friction of a layer, or of two: of the pairs
   of their blocks that may touch. Returns how many statements. */
static int statements_friction(struct outlines *o, const char *word)
{
    const double reach = 0.5 * o->size;
    const int end = shapes_equals(word);
    int comma = 0, count = 0;
    double mu;
    if (!shapes_read_number(word + end + 1, (int)strlen(word + end + 1), &mu))
        return 0;
    while (comma < end && word[comma] != ',')
        comma++;
    for (int i = 0; i < o->blocks; i++) {
        const struct outlines_block *p = o->block + i;
        if (!statements_on(o, i, word, comma))
            continue;
        if (comma == end) {
            statements_mu(o, mu, i, -1);
            count++;
        }
        for (int j = 0; j < o->blocks && comma < end; j++) {
            const struct outlines_block *q = o->block + j;
            if (j == i
                || !statements_on(o, j, word + comma + 1, end - comma - 1)
                || p->left > q->right + reach || q->left > p->right + reach
                || p->low > q->high + reach || q->low > p->high + reach)
                continue;
            statements_mu(o, mu, i, j);
            count++;
        }
    }
    return count;
}

/* Writes all of these, and that of all others; says where one is of no block. */
static void statements_frictions(struct outlines *o)
{
    struct shapes *s = o->s;
    for (int k = 0; k < s->asked->friction_words; k++) {
        const char *word = s->asked->frictions[k];
        if (shapes_equals(word) < 0) {
            shapes_put(&s->text, "friction ");
            shapes_put(&s->text, word);
            shapes_put(&s->text, "\n");
            continue;
        }
        if (statements_friction(o, word) > 0)
            continue;
        shapes_put(&s->notes, "friction ");
        shapes_put(&s->notes, word);
        shapes_put(&s->notes, " is that of no blocks\n");
    }
}

static int statements_write(struct outlines *o)
{
    struct shapes *s = o->s;
    double density = 1;
    if (s->units) {
        shapes_put(&s->text, "units ");
        shapes_put(&s->text, s->units);
        /* a density is in kg/m3, as the user says */
        if (strcmp(s->units, "m") == 0 && s->assumed == 0)
            shapes_put(&s->text, " N");
        shapes_put(&s->text, "\n");
    }
    if (statements_error(o))
        return -1;
    for (int i = 0; i < o->blocks; i++)
        if (outlines_path(o, i)->role != SHAPES_FILL)
            statements_block(o, i, &density);
    for (int i = 0; i < o->blocks; i++) {
        const struct outlines_block *b = o->block + i;
        if (outlines_path(o, i)->role != SHAPES_STONE || !(b->mass > 0))
            continue;
        shapes_put(&s->text, "mass ");
        shapes_put(&s->text, shapes_at(s, b->name));
        statements_number(s, b->mass);
        statements_number(s, b->mass_x / b->mass);
        statements_number(s, b->mass_y / b->mass);
        shapes_put(&s->text, "\n");
    }
    for (int i = 0; i < o->blocks; i++)
        if (outlines_path(o, i)->role == SHAPES_FILL && o->block[i].pushes)
            statements_push(o, i);
    statements_frictions(o);
    return 0;
}

/* Returns the line of the file that block `name` was read from, 0 where it
   is not known. */
static inline int statements_line(const struct outlines *o, const char *name)
{
    for (int i = 0; i < o->blocks; i++)
        if (strcmp(shapes_at(o->s, o->block[i].name), name) == 0)
            return outlines_path(o, i)->line;
    return 0;
}

/* ---- The whole ------------------------------------------------------------ */

/* Kinds of what draws lines, and of texts: in lower case. */
static const char statements_lines[] =
    " line arc polyline lwpolyline spline ellipse path mline ray xline"
    " linestrip ";
static const char statements_texts[] =
    " text mtext attrib attdef dimension leader multileader mleader tspan ";

static int statements_is(const struct shapes *s, int row, const char *list)
{
    const char *kind = shapes_at(s, s->skip[row].kind);
    return shapes_listed(list, kind, (int)strlen(kind));
}

static int statements_count(const struct shapes *s, const char *list)
{
    int count = 0;
    for (int i = 0; i < s->skips; i++)
        count += statements_is(s, i, list) ? s->skip[i].count : 0;
    return count;
}

/* Finds how far an end is from an open path, where that is near and they do not
   meet: less than the least so far. */
static void statements_compare(struct shapes *s, int line,
                               struct shapes_point end,
                               const struct shapes_path *path)
{
    const struct shapes_point *p = s->point + path->first;
    double least = 1e300;
    for (int k = 0; k + 1 < path->points; k++) {
        const double off = outlines_off(p[k], p[k + 1], end);
        least = off < least ? off : least;
    }
    if (!(least > 2 * s->meet && least < 200 * s->meet)
        || (s->apart > 0 && !(least < s->apart)))
        return;
    s->apart = least;
    s->apart_line = line;
}

/* Finds how far ends of the open paths that are left are from the next one. */
static void statements_find_apart(struct shapes *s)
{
    int ends = 0;
    for (int i = 0; i < s->paths && ends < STATEMENTS_ENDS; i++) {
        const struct shapes_path *p = s->path + i;
        if (!lines_is_open(p))
            continue;
        ends++;
        for (int j = 0; j < s->paths; j++) {
            const struct shapes_path *q = s->path + j; /* used or not */
            if (j == i || q->closed || q->role == SHAPES_IGNORED)
                continue;
            statements_compare(s, p->line, s->point[p->first], s->path + j);
            statements_compare(s, p->line, s->point[p->first + p->points - 1],
                               s->path + j);
        }
    }
}

/* Says so. */
static void statements_put_apart(struct shapes *s, struct shapes_text *t,
                                 const char *before, const char *after)
{
    if (!(s->apart > 0))
        return;
    shapes_put(t, before);
    shapes_put(t, "ends of lines meet within ");
    shapes_put_number(t, s->meet, 2);
    shapes_put(t, ", and that of the line or arc in line ");
    shapes_put_int(t, s->apart_line);
    shapes_put(t, " is ");
    shapes_put_number(t, s->apart, 2);
    shapes_put(t, " away from the next");
    shapes_put(t, after);
}

/* Says that nothing was left to make a block of, or to move. */
static int statements_none(struct shapes *s, int line, const char *what)
{
    struct shapes_text *t = shapes_fault(s, line);
    const int lines = statements_count(s, statements_lines);
    const int texts = statements_count(s, statements_texts);
    shapes_put(t, what);
    shapes_put_int(t, lines);
    shapes_put(t, lines == 1 ? " line, " : " lines, ");
    shapes_put_int(t, texts);
    shapes_put(t, texts == 1 ? " text skipped" : " texts skipped");
    for (int i = 0, shown = 0; i < s->skips && shown < 4; i++) {
        if (statements_is(s, i, statements_lines)
            || statements_is(s, i, statements_texts))
            continue;
        shapes_put(t, shown++ == 0 ? "; also " : ", ");
        shapes_put_int(t, s->skip[i].count);
        shapes_put(t, " ");
        shapes_put_shown(t, shapes_at(s, s->skip[i].kind));
    }
    statements_put_apart(s, t, "; ", "");
    return -1;
}

/* Brings the numbers of the file to metres, y up. */
static void statements_scale(struct shapes *s)
{
    double height = s->height;
    if (s->photograph && height < 0)
        for (int i = 0; i < s->points; i++)
            height = s->point[i].y > height ? s->point[i].y : height;
    for (int i = 0; i < s->points; i++) {
        struct shapes_point *p = s->point + i;
        p->y = s->unit * (s->down ? height - p->y : p->y);
        p->x *= s->unit;
        p->bulge = s->down ? -p->bulge : p->bulge;
    }
    s->sagitta *= s->unit;
    s->height = height;
}

/* Lists what the user calls ignored, and open paths that met nothing. */
static void statements_sort_out(struct shapes *s)
{
    for (int i = 0; i < s->paths; i++) {
        struct shapes_path *p = s->path + i;
        if (!p->gone && (!p->closed || p->role == SHAPES_IGNORED))
            shapes_leave(s, p, "");
    }
}

/* Says where a label of the command line is none of the file. */
static void statements_unheard(struct shapes *s)
{
    for (int k = 0; k < s->asked->layers; k++) {
        const char *word = s->asked->layer[k];
        const int at = shapes_equals(word);
        int found = 0;
        for (int i = 0; i < s->paths && !found; i++)
            found = shapes_same(word, at, shapes_at(s, s->path[i].label));
        if (found || at < 1)
            continue;
        shapes_put(&s->notes, "no label is ");
        shapes_put_bytes(&s->notes, word, at);
        shapes_put(&s->notes, ", which the user gives a role\n");
    }
}

/* Returns 1 if the label of path i has no earlier path, and its role by its
   name. */
static int statements_named(const struct shapes *s, int i)
{
    const char *label = shapes_at(s, s->path[i].label);
    if (shapes_role_asked(s, label) >= 0 || shapes_role_of(label) < 0
        || shapes_role_of(label) == SHAPES_STONE)
        return 0;
    for (int j = 0; j < i; j++)
        if (s->path[j].label == s->path[i].label
            || strcmp(shapes_at(s, s->path[j].label), label) == 0)
            return 0;
    return 1;
}

/* Says which labels are ground, fill or ignored by their names. */
static void statements_note_roles(struct shapes *s)
{
    static const char *const is[SHAPES_ROLES] = {
        "", "ground by name: ", "fill by name: ", "ignored by name: "};
    for (int role = SHAPES_GROUND; role < SHAPES_ROLES; role++) {
        int count = 0;
        for (int i = 0; i < s->paths; i++) {
            const char *label = shapes_at(s, s->path[i].label);
            if (s->path[i].line == 0 || shapes_role_of(label) != role
                || !statements_named(s, i))
                continue;
            if (count < STATEMENTS_ROLES) {
                shapes_put(&s->notes, count > 0 ? ", " : is[role]);
                shapes_put_shown(&s->notes, label);
            }
            count++;
        }
        if (count > STATEMENTS_ROLES) {
            shapes_put(&s->notes, " and ");
            shapes_put_int(&s->notes, count - STATEMENTS_ROLES);
            shapes_put(&s->notes, " more");
        }
        if (count > 0)
            shapes_put(&s->notes, " (--layer NAME=stone if not)\n");
    }
}

/* Says which density and friction are assumed, for want of being told. Sets how
   many densities are. */
static void statements_assumed(struct outlines *o)
{
    struct shapes *s = o->s;
    int weighed = 0, friction = 0;
    for (int i = 0; i < o->blocks; i++) {
        const struct shapes_path *path = outlines_path(o, i);
        if (path->role == SHAPES_GROUND)
            continue;
        weighed++;
        s->assumed += !(shapes_density(s, shapes_at(s, path->label)) > 0);
    }
    s->all_assumed = s->assumed == weighed;
    if (s->assumed > 0) {
        shapes_put(&s->notes, "density 1 is assumed");
        if (!s->all_assumed) {
            shapes_put(&s->notes, " of ");
            shapes_put_int(&s->notes, s->assumed);
            shapes_put(&s->notes, " of ");
            shapes_put_int(&s->notes, weighed);
            shapes_put(&s->notes, " outlines, beside others that are told");
        }
        shapes_put(&s->notes, " (--density D, --density NAME=D)");
        shapes_put(&s->notes, s->all_assumed
                                  ? ": forces and stresses are per unit of "
                                    "density\n"
                                  : ": forces and stresses have no unit\n");
    }
    for (int k = 0; k < s->asked->friction_words; k++)
        friction |= shapes_equals(s->asked->frictions[k]) < 0;
    if (!friction)
        shapes_put(&s->notes, s->asked->friction_words > 0
                                  ? "friction 0.4 is assumed where --mu names "
                                    "no layer (--mu MU)\n"
                                  : "friction 0.4 is assumed (--mu MU)\n");
}

static void statements_notes(struct outlines *o)
{
    struct shapes *s = o->s;
    statements_assumed(o);
    if (s->arcs > 0) {
        shapes_put_int(&s->notes, s->arcs);
        shapes_put(&s->notes, s->arcs == 1 ? " arc is chords within "
                                           : " arcs are chords within ");
        shapes_put_number(&s->notes, s->sagitta, 2);
        if (s->units) {
            shapes_put(&s->notes, " ");
            shapes_put(&s->notes, s->units);
        }
        shapes_put(&s->notes, "\n");
    }
    outlines_note_parts(o);
    if (o->mended > 0) {
        shapes_put(&s->notes, "mended: ");
        shapes_put_int(&s->notes, o->mended);
        shapes_put(&s->notes, o->mended == 1
                                  ? " outline that crossed itself"
                                  : " outlines that crossed themselves");
        if (s->path[o->mended_at].line > 0) {
            shapes_put(&s->notes, ", the first in line ");
            shapes_put_int(&s->notes, s->path[o->mended_at].line);
        }
        shapes_put(&s->notes, "\n");
    }
    if (s->photograph && s->units && strcmp(s->units, "px") == 0)
        shapes_put(&s->notes, "lengths are in pixels\n");
}

/* Says that there are more outlines than are read. */
static int statements_too_many(struct shapes *s, int outlines)
{
    struct shapes_text *t = shapes_fault(s, 0);
    shapes_put_int(t, outlines);
    shapes_put(t, " closed outlines, at most ");
    shapes_put_int(t, OUTLINES_MOST);
    shapes_put(t, " are read (--layer NAME=ignore)");
    return -1;
}

/* Makes one outline of each stone, and lists what is none. Returns 0, or -1 with
   a message. */
static int statements_outlines(struct outlines *o)
{
    struct shapes *s = o->s;
    const double off = s->photograph ? s->asked->tolerance * s->unit : 0;
    const double reach = s->photograph ? off + s->unit : 0;
    outlines_close(s);
    lines_join(s);
    statements_find_apart(s);
    statements_put_apart(s, &s->notes, "", "\n");
    statements_sort_out(s);
    const int left = outlines_repeated(s);
    if (left > OUTLINES_MOST)
        return statements_too_many(s, left);
    outlines_prepare(s, off);
    for (int i = 0; i < s->paths && !s->lost; i++)
        if (!s->path[i].gone)
            outlines_mend(o, i, reach);
    outlines_join(o, reach);
    outlines_list(o);
    outlines_nest(o);
    outlines_list(o);
    if (s->asked->has_ground) {
        const double y = s->unit
                       * (s->down ? s->height - s->asked->ground
                                  : s->asked->ground);
        outlines_line(o, y, reach);
        outlines_list(o);
    }
    return 0;
}

/* Makes statements of the shapes. Returns 0, or -1 with a message. */
static int statements_make(struct shapes *s, struct outlines *o)
{
    const struct outlines none = {0};
    int bad = 0;
    *o = none;
    o->s = s;
    statements_scale(s);
    if (s->photograph)
        o->exact = s->unit
                 * SHAPES_SQRT(1 + s->asked->tolerance * s->asked->tolerance);
    statements_unheard(s);
    statements_note_roles(s);
    if (!s->lost)
        bad = statements_outlines(o);
    if (!s->lost && !bad && o->blocks == 0)
        bad = statements_none(s, 0, "no closed outline: ");
    else if (!s->lost && !bad) {
        int stones = 0;
        outlines_names(o);
        outlines_lowest(o);
        for (int i = 0; i < o->blocks; i++)
            stones += outlines_path(o, i)->role == SHAPES_STONE;
        if (stones == 0)
            return statements_none(s, outlines_path(o, 0)->line,
                                   "no block is free, all outlines are ground "
                                   "or fill: ");
        statements_notes(o);
        outlines_suspect(o);
        statements_fill(o);
        bad = statements_write(o);
    }
    if (s->lost || s->text.lost || s->notes.lost)
        bad = shapes_fail(s, 0, "not enough memory");
    return bad;
}

#endif /* STATEMENTS_H */
