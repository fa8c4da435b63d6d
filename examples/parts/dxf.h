/* dxf.h - reads a drawing (DXF, as text) as shapes:

       outlines    LWPOLYLINE and POLYLINE with its VERTEX entities, CIRCLE,
                   ELLIPSE; with arcs (bulges)
       open paths  LINE, ARC and the same where they are not closed
       INSERT      counts as the entities of its block, scaled, turned and in rows;
                   layer 0 in a block is the layer of the INSERT
       layers      are the labels; what lies on one that is off or frozen is
                   invisible
       units       metres by $INSUNITS; without it, one unit is one

   Everything else is skipped and listed: texts, dimensions, hatches, splines,
   polylines fitted by curves, what is invisible or tilted out of the plane.
   Entities of the BLOCKS section count only where they are inserted, and those
   in paper space never.

   SPDX-License-Identifier: MIT */

#ifndef DXF_H
#define DXF_H

#include "shapes.h"

enum {
    DXF_DEEP = 16,      /* INSERTs within each other                    */
    DXF_MOST = 1000000, /* entities, with those of INSERTs               */
    DXF_ELLIPSE = 64    /* chords of a whole ellipse                    */
};

/* A line with a code, and a line with its value. */
struct dxf_group {
    int code, at, length, line;
};

struct dxf_layer {
    int at, length; /* its name                                        */
    int off;
};

struct dxf_block {
    int at, length; /* its name                                        */
    int first, end; /* groups of its entities                          */
    double x, y;    /* its base point                                  */
};

/* Where the entities of a block go: x' = xx x + xy y + x. */
struct dxf_frame {
    double xx, xy, yx, yy, x, y;
    int first, at, end;       /* groups                              */
    int label;                /* of layer 0, -1: itself              */
    int copy, columns, rows;  /* of an INSERT in rows                */
    double column[2], row[2]; /* from one to the next                */
    double start_x, start_y;  /* of the first one                    */
};

struct dxf {
    struct shapes *s;
    const char *data;
    struct dxf_group *group;
    int groups, group_room;
    struct dxf_layer *layer;
    int layers, layer_room;
    struct dxf_block *block;
    int blocks, block_room;
    struct dxf_frame frame[DXF_DEEP];
    int depth;    /* frames                                            */
    int entities; /* that were read                                    */
};

/* ---- Groups --------------------------------------------------------------- */

/* Finds the line that begins at *at, without the blanks around it, and moves
   *at behind it. Returns 0 at the end of the file. */
static int dxf_line(const char *data, int length, int *at, int *from, int *n)
{
    int to = *at, next;
    if (*at >= length)
        return 0;
    while (to < length && data[to] != '\n' && data[to] != '\r')
        to++;
    next = to + 1;
    if (to + 1 < length && data[to] == '\r' && data[to + 1] == '\n')
        next++;
    *from = *at;
    *at = next;
    while (*from < to && (data[*from] == ' ' || data[*from] == '\t'))
        (*from)++;
    while (to > *from && (data[to - 1] == ' ' || data[to - 1] == '\t'))
        to--;
    *n = to - *from;
    return 1;
}

/* Reads a group code. Returns 0 where there is none. */
static int dxf_code(const char *word, int n, int *code)
{
    const int minus = n > 0 && word[0] == '-';
    int value = 0;
    if (n - minus < 1 || n - minus > 4)
        return 0;
    for (int i = minus; i < n; i++) {
        if (word[i] < '0' || word[i] > '9')
            return 0;
        value = 10 * value + (word[i] - '0');
    }
    *code = minus ? -value : value;
    return value <= 1071;
}

static int dxf_is(const struct dxf *d, int i, int code, const char *value)
{
    const struct dxf_group *g = d->group + i;
    const int n = (int)strlen(value);
    return i < d->groups && g->code == code && g->length == n
        && memcmp(d->data + g->at, value, (size_t)n) == 0;
}

/* Reads all groups up to EOF. */
static int dxf_groups(struct dxf *d, int length)
{
    int at = 0, line = 0, from, n;
    if (length >= 3 && memcmp(d->data, "\xef\xbb\xbf", 3) == 0)
        at = 3;
    while (dxf_line(d->data, length, &at, &from, &n)) {
        struct dxf_group *g = shapes_grown(d->s, d->group, d->groups,
                                           &d->group_room, sizeof *g);
        if (!g)
            return -1;
        d->group = g;
        g += d->groups;
        line += 2;
        if (!dxf_code(d->data + from, n, &g->code))
            return shapes_expected(d->s, line - 1, "a group code",
                                   d->data + from, n);
        if (!dxf_line(d->data, length, &at, &g->at, &g->length))
            return shapes_fail(d->s, line - 1,
                               "the file ends after a group code");
        g->line = line;
        d->groups++;
        if (dxf_is(d, d->groups - 1, 0, "EOF"))
            return 0;
    }
    return shapes_fail(d->s, line, "the file ends without EOF");
}

/* Returns the first group of a code in [first, end), -1 where there is none.
   */
static int dxf_find(const struct dxf *d, int first, int end, int code)
{
    for (int i = first; i < end; i++)
        if (d->group[i].code == code)
            return i;
    return -1;
}

/* Reads the number in a group. Returns -1 where it is none. */
static int dxf_number(struct dxf *d, int i, double *out)
{
    const struct dxf_group *g = d->group + i;
    if (shapes_read_number(d->data + g->at, g->length, out))
        return 0;
    return shapes_expected(d->s, g->line, "a number", d->data + g->at,
                           g->length);
}

/* Reads the number of a code in [first, end), or takes another one without
   it. Returns -1 where it is no number. */
static int dxf_value(struct dxf *d, int first, int end, int code,
                     double without, double *out)
{
    const int i = dxf_find(d, first, end, code);
    *out = without;
    return i < 0 ? 0 : dxf_number(d, i, out);
}

/* Reads a whole number; one that is too large is 0. Returns -1 where it is
   no number. */
static int dxf_whole(struct dxf *d, int first, int end, int code, int without,
                     int *out)
{
    double value;
    if (dxf_value(d, first, end, code, without, &value))
        return -1;
    *out = value > -1e9 && value < 1e9 ? (int)value : 0;
    return 0;
}

/* Returns the group after the entity that begins at i. */
static int dxf_end(const struct dxf *d, int i)
{
    for (i++; i < d->groups && d->group[i].code != 0;)
        i++;
    return i;
}

/* ---- Header, layers, blocks ----------------------------------------------- */

/* Takes the unit of the header, which follows the name of its variable. */
static int dxf_units(struct dxf *d, int first, int end)
{
    static const double metre[] = {
        0,       0.0254, 0.3048, 1609.344, 0.001, 0.01, 1,  1000, 2.54e-8,
        2.54e-5, 0.9144, 1e-10,  1e-9,     1e-6,  0.1,  10, 100};
    int unit = 0;
    for (int i = first; i + 1 < end; i++)
        if (dxf_is(d, i, 9, "$INSUNITS")
            && dxf_whole(d, i + 1, i + 2, 70, 0, &unit))
            return -1;
    if (unit > 0 && unit < (int)(sizeof metre / sizeof *metre)) {
        d->s->unit = metre[unit];
        d->s->units = "m";
    } else if (unit != 0) {
        shapes_put(&d->s->notes, "$INSUNITS is ");
        shapes_put_int(&d->s->notes, unit);
        shapes_put(&d->s->notes, ", no unit of length that is known: lengths "
                                 "are as drawn\n");
    }
    return 0;
}

static int dxf_layers(struct dxf *d, int first, int end)
{
    for (int i = first; i < end; i = dxf_end(d, i)) {
        const int stop = dxf_end(d, i), name = dxf_find(d, i, stop, 2);
        struct dxf_layer *l;
        int flags, colour;
        if (!dxf_is(d, i, 0, "LAYER") || name < 0)
            continue;
        if (dxf_whole(d, i, stop, 70, 0, &flags)
            || dxf_whole(d, i, stop, 62, 7, &colour))
            return -1;
        l = shapes_grown(d->s, d->layer, d->layers, &d->layer_room, sizeof *l);
        if (!l)
            return -1;
        d->layer = l;
        l += d->layers++;
        l->at = d->group[name].at;
        l->length = d->group[name].length;
        l->off = flags & 1 || colour < 0;
    }
    return 0;
}

static int dxf_blocks(struct dxf *d, int first, int end)
{
    for (int i = first; i < end; i = dxf_end(d, i)) {
        const int stop = dxf_end(d, i), name = dxf_find(d, i, stop, 2);
        struct dxf_block *b;
        double x, y;
        if (!dxf_is(d, i, 0, "BLOCK") || name < 0)
            continue;
        if (dxf_value(d, i, stop, 10, 0, &x)
            || dxf_value(d, i, stop, 20, 0, &y))
            return -1;
        b = shapes_grown(d->s, d->block, d->blocks, &d->block_room, sizeof *b);
        if (!b)
            return -1;
        d->block = b;
        b += d->blocks++;
        b->at = d->group[name].at;
        b->length = d->group[name].length;
        b->first = b->end = stop;
        while (b->end < end && !dxf_is(d, b->end, 0, "ENDBLK"))
            b->end = dxf_end(d, b->end);
        b->x = x;
        b->y = y;
    }
    return 0;
}

static int dxf_same(const struct dxf *d, int i, int at, int length)
{
    const struct dxf_group *g = d->group + i;
    return g->length == length
        && memcmp(d->data + g->at, d->data + at, (size_t)length) == 0;
}

/* ---- Entities ------------------------------------------------------------- */

static int dxf_kind(struct dxf *d, int i)
{
    const struct dxf_group *g = d->group + i;
    return shapes_word(d->s, d->data + g->at, g->length < 40 ? g->length : 40);
}

/* Returns the label of the entity in [i, end): its layer. */
static int dxf_label(struct dxf *d, int i, int end)
{
    const int layer = dxf_find(d, i, end, 8);
    const struct dxf_frame *f = d->frame + d->depth - 1;
    const struct dxf_group *g = d->group + (layer < 0 ? i : layer);
    if (f->label >= 0 && (layer < 0 || dxf_is(d, layer, 8, "0")))
        return f->label;
    return layer < 0 ? shapes_word(d->s, "0", 1)
                     : shapes_word(d->s, d->data + g->at, g->length);
}

static int dxf_is_off(const struct dxf *d, int i, int end)
{
    const int layer = dxf_find(d, i, end, 8);
    for (int k = 0; layer >= 0 && k < d->layers; k++)
        if (dxf_same(d, layer, d->layer[k].at, d->layer[k].length))
            return d->layer[k].off;
    return 0;
}

/* Lists an entity as skipped, with the reason in front of its kind. */
static void dxf_skip(struct dxf *d, const char *why, int i, int end)
{
    struct shapes_text t = {NULL, 0, 0, 0};
    const int kind = dxf_kind(d, i);
    shapes_put(&t, why);
    shapes_put(&t, shapes_at(d->s, kind));
    if (!t.lost)
        shapes_skipped(d->s, t.at, dxf_label(d, i, end), d->group[i].line);
    d->s->lost |= t.lost;
    free(t.at);
}

/* Finds the direction that an entity is seen from: 1, or -1 from behind, or
   0 where it is tilted. Returns -1 where that is no number. */
static int dxf_side(struct dxf *d, int i, int end, int *side)
{
    double x, y, z;
    if (dxf_value(d, i, end, 210, 0, &x) || dxf_value(d, i, end, 220, 0, &y)
        || dxf_value(d, i, end, 230, 1, &z))
        return -1;
    *side = shapes_abs(x) + shapes_abs(y) > 1e-6 * shapes_abs(z) ? 0
          : z > 0                                                ? 1
          : z < 0                                                ? -1
                                                                 : 0;
    return 0;
}

/* Ends a path: brings it to where the block is inserted. */
static void dxf_path(struct dxf *d, int first, int closed, int side, int i,
                     int end)
{
    struct shapes *s = d->s;
    const struct dxf_frame *f = d->frame + d->depth - 1;
    const double det = f->xx * f->yy - f->xy * f->yx;
    const double square = f->xx * f->xx + f->yx * f->yx;
    const int alike = shapes_abs(f->xx * f->xy + f->yx * f->yy)
                       <= 1e-9 * shapes_abs(det)
                   && shapes_abs(shapes_abs(det) - square) <= 1e-9 * square;
    const double before = s->sagitta;
    int made;
    s->sagitta = 0;
    made = shapes_path(s, first, closed, dxf_kind(d, i), dxf_label(d, i, end),
                       d->group[i].line);
    s->sagitta *= SHAPES_SQRT(square);
    s->sagitta = s->sagitta > before ? s->sagitta : before;
    for (int k = 0; made >= 0 && k < s->path[made].points; k++) {
        struct shapes_point *p = s->point + s->path[made].first + k;
        const double x = side * p->x, y = p->y;
        p->x = f->xx * x + f->xy * y + f->x;
        p->y = f->yx * x + f->yy * y + f->y;
        p->bulge = !alike ? 0 : (det < 0) != (side < 0) ? -p->bulge : p->bulge;
    }
}

static int dxf_lwpolyline(struct dxf *d, int i, int end, int side)
{
    struct shapes *s = d->s;
    const int first = s->points;
    int flags;
    if (dxf_whole(d, i, end, 70, 0, &flags))
        return -1;
    for (int k = i + 1; k < end; k++) {
        const int code = d->group[k].code;
        double number;
        if (code != 10 && code != 20 && code != 42)
            continue;
        if (dxf_number(d, k, &number))
            return -1;
        if (code == 10)
            shapes_point(s, number, 0, 0);
        else if (s->points > first && code == 20)
            s->point[s->points - 1].y = number;
        else if (s->points > first)
            s->point[s->points - 1].bulge = number;
    }
    dxf_path(d, first, flags & 1, side, i, end);
    return 0;
}

/* Adds the vertices of an old POLYLINE up to `stop`, and sets *tilted where
   they are not at one height. */
static int dxf_vertices(struct dxf *d, int i, int stop, int *tilted)
{
    double height = 0, lowest = 0, highest = 0;
    int found = 0;
    for (; i < stop; i = dxf_end(d, i)) {
        const int end = dxf_end(d, i);
        double x, y, bulge;
        if (!dxf_is(d, i, 0, "VERTEX"))
            continue;
        if (dxf_value(d, i, end, 10, 0, &x) || dxf_value(d, i, end, 20, 0, &y)
            || dxf_value(d, i, end, 30, 0, &height)
            || dxf_value(d, i, end, 42, 0, &bulge))
            return -1;
        shapes_point(d->s, x, y, bulge);
        lowest = !found || height < lowest ? height : lowest;
        highest = !found || height > highest ? height : highest;
        found = 1;
    }
    *tilted = highest - lowest > 1e-9 * (shapes_abs(highest) + 1);
    return 0;
}

/* Returns the end of a POLYLINE with its vertices, behind SEQEND, or of an
   INSERT with its attributes. */
static int dxf_sequence(const struct dxf *d, int i)
{
    int end = dxf_end(d, i);
    while (dxf_is(d, end, 0, "VERTEX") || dxf_is(d, end, 0, "ATTRIB"))
        end = dxf_end(d, end);
    return dxf_is(d, end, 0, "SEQEND") ? dxf_end(d, end) : end;
}

static int dxf_polyline(struct dxf *d, int i, int end, int side)
{
    const int first = d->s->points;
    int flags, tilted = 0;
    if (dxf_whole(d, i, end, 70, 0, &flags))
        return -1;
    if (flags & (2 | 4 | 16 | 64)) {
        dxf_skip(d, flags & (2 | 4) ? "curve-fit " : "mesh ", i, end);
        return 0;
    }
    if (dxf_vertices(d, end, dxf_sequence(d, i), &tilted))
        return -1;
    if (tilted) {
        d->s->points = first;
        dxf_skip(d, "tilted ", i, end);
        return 0;
    }
    dxf_path(d, first, flags & 1, side, i, end);
    return 0;
}

static int dxf_straight(struct dxf *d, int i, int end)
{
    struct shapes *s = d->s;
    const int first = s->points;
    double value[6];
    static const int code[6] = {10, 20, 30, 11, 21, 31};
    for (int k = 0; k < 6; k++)
        if (dxf_value(d, i, end, code[k], 0, &value[k]))
            return -1;
    if (shapes_abs(value[5] - value[2])
        > 1e-6
              * (shapes_abs(value[3] - value[0])
                 + shapes_abs(value[4] - value[1]))) {
        dxf_skip(d, "tilted ", i, end);
        return 0;
    }
    shapes_point(s, value[0], value[1], 0);
    shapes_point(s, value[3], value[4], 0);
    dxf_path(d, first, 0, 1, i, end);
    return 0;
}

/* Reads an ARC or a CIRCLE. */
static int dxf_round(struct dxf *d, int i, int end, int side)
{
    const int first = d->s->points, whole = dxf_is(d, i, 0, "CIRCLE");
    double x, y, r, from = 0, to = 360;
    if (dxf_value(d, i, end, 10, 0, &x) || dxf_value(d, i, end, 20, 0, &y)
        || dxf_value(d, i, end, 40, 0, &r))
        return -1;
    if (!whole
        && (dxf_value(d, i, end, 50, 0, &from)
            || dxf_value(d, i, end, 51, 360, &to)))
        return -1;
    if (!(r > 0)) {
        dxf_skip(d, "sizeless ", i, end);
        return 0;
    }
    shapes_arc(d->s, x, y, r, from, to);
    dxf_path(d, first, whole, side, i, end);
    return 0;
}

static int dxf_ellipse(struct dxf *d, int i, int end, int side)
{
    struct shapes *s = d->s;
    const int first = s->points;
    const double degree = 57.295779513082321;
    double v[7], sweep, c, q;
    static const int code[7] = {10, 20, 11, 21, 40, 41, 42};
    int n, whole;
    for (int k = 0; k < 7; k++)
        if (dxf_value(d, i, end, code[k], k == 6 ? 6.283185307179586 : 0,
                      &v[k]))
            return -1;
    sweep = (v[6] - v[5]) * degree;
    if (!(shapes_abs(sweep) < 1e6))
        return 0;
    sweep -= 360 * (double)(long)(sweep / 360);
    sweep += sweep > 1e-6 ? 0 : 360;
    whole = sweep > 360 - 1e-6;
    n = 1 + (int)(DXF_ELLIPSE * sweep / 360);
    for (int k = 0; k < n + !whole; k++) {
        shapes_turn(v[5] * degree + sweep * k / n, &c, &q);
        shapes_point(s, v[0] + c * v[2] - side * q * v[4] * v[3],
                     v[1] + c * v[3] + side * q * v[4] * v[2], 0);
    }
    dxf_path(d, first, whole, 1, i, end);
    s->arcs++;
    c = 1.3e-3 * (shapes_abs(v[2]) + shapes_abs(v[3]));
    s->sagitta = c > s->sagitta ? c : s->sagitta;
    return 0;
}

/* ---- INSERT --------------------------------------------------------------- */

/* Computes the frame of an INSERT: scale, turn and place, less the base
   point. */
static int dxf_frame_of(struct dxf *d, int i, int end, int side,
                        const struct dxf_block *b, struct dxf_frame *out)
{
    const struct dxf_frame *f = d->frame + d->depth - 1;
    double v[7], c, q, xx, xy, yx, yy, x, y;
    static const int code[7] = {10, 20, 41, 42, 50, 44, 45};
    static const double without[7] = {0, 0, 1, 1, 0, 0, 0};
    for (int k = 0; k < 7; k++)
        if (dxf_value(d, i, end, code[k], without[k], &v[k]))
            return -1;
    if (dxf_whole(d, i, end, 70, 1, &out->columns)
        || dxf_whole(d, i, end, 71, 1, &out->rows))
        return -1;
    shapes_turn(v[4], &c, &q);
    xx = side * c * v[2];
    xy = -side * q * v[3];
    yx = q * v[2];
    yy = c * v[3];
    x = side * v[0] - xx * b->x - xy * b->y;
    y = v[1] - yx * b->x - yy * b->y;
    out->xx = f->xx * xx + f->xy * yx;
    out->xy = f->xx * xy + f->xy * yy;
    out->yx = f->yx * xx + f->yy * yx;
    out->yy = f->yx * xy + f->yy * yy;
    out->start_x = out->x = f->xx * x + f->xy * y + f->x;
    out->start_y = out->y = f->yx * x + f->yy * y + f->y;
    out->column[0] = (f->xx * side * c + f->xy * q) * v[5];
    out->column[1] = (f->yx * side * c + f->yy * q) * v[5];
    out->row[0] = (f->xy * c - f->xx * side * q) * v[6];
    out->row[1] = (f->yy * c - f->yx * side * q) * v[6];
    out->first = out->at = b->first;
    out->end = b->end;
    out->copy = 0;
    out->label = dxf_label(d, i, end);
    return 0;
}

/* Enters the block of an INSERT. */
static int dxf_insert(struct dxf *d, int i, int end, int side)
{
    const int name = dxf_find(d, i, end, 2);
    const struct dxf_block *b = NULL;
    struct dxf_frame f;
    for (int k = 0; name >= 0 && k < d->blocks && !b; k++)
        if (dxf_same(d, name, d->block[k].at, d->block[k].length))
            b = d->block + k;
    if (!b) {
        dxf_skip(d, "undefined ", i, end);
        return 0;
    }
    for (int k = 1; k < d->depth; k++)
        if (d->frame[k].first == b->first) {
            dxf_skip(d, "self-inserting ", i, end);
            return 0;
        }
    if (d->depth == DXF_DEEP) {
        dxf_skip(d, "deeply nested ", i, end);
        return 0;
    }
    if (dxf_frame_of(d, i, end, side, b, &f))
        return -1;
    if (f.columns > 0 && f.rows > 0)
        d->frame[d->depth++] = f;
    return 0;
}

/* Goes to the next copy of a block in rows, or back to where it is inserted. */
static void dxf_leave_block(struct dxf *d)
{
    struct dxf_frame *f = d->frame + d->depth - 1;
    int column, row;
    f->copy++;
    column = f->copy % f->columns;
    row = f->copy / f->columns;
    if (row >= f->rows) {
        d->depth--;
        return;
    }
    f->at = f->first;
    f->x = f->start_x + column * f->column[0] + row * f->row[0];
    f->y = f->start_y + column * f->column[1] + row * f->row[1];
    d->entities++; /* an empty block in many rows ends, too */
}

/* ---- The file ------------------------------------------------------------- */

/* Reads one entity, in [i, end). */
static int dxf_entity(struct dxf *d, int i, int end)
{
    static const struct {
        const char *name;
        int (*read)(struct dxf *, int i, int end, int side);
    } read[] = {{"LWPOLYLINE", dxf_lwpolyline},
                {"POLYLINE", dxf_polyline},
                {"ARC", dxf_round},
                {"CIRCLE", dxf_round},
                {"ELLIPSE", dxf_ellipse},
                {"INSERT", dxf_insert}};
    const int layout = dxf_find(d, i, end, 410);
    int paper, hidden, side;
    if (dxf_whole(d, i, end, 67, 0, &paper)
        || dxf_whole(d, i, end, 60, 0, &hidden) || dxf_side(d, i, end, &side))
        return -1;
    if (paper || (layout >= 0 && !dxf_is(d, layout, 410, "Model")))
        return 0;
    if (hidden || dxf_is_off(d, i, end)) {
        dxf_skip(d, "invisible ", i, end);
        return 0;
    }
    if (dxf_is(d, i, 0, "LINE"))
        return dxf_straight(d, i, end);
    for (size_t k = 0; k < sizeof read / sizeof *read; k++)
        if (dxf_is(d, i, 0, read[k].name)) {
            if (side != 0)
                return read[k].read(d, i, end, side);
            dxf_skip(d, "tilted ", i, end);
            return 0;
        }
    dxf_skip(d, "", i, end);
    return 0;
}

/* Reads all entities of the section that begins at a group, with those of
   blocks. */
static int dxf_entities(struct dxf *d, int first, int end)
{
    struct dxf_frame *f = d->frame;
    memset(f, 0, sizeof *f);
    f->xx = f->yy = f->columns = f->rows = 1;
    f->at = f->first = first;
    f->end = end;
    f->label = -1;
    d->depth = 1;
    while (d->depth > 0 && !d->s->lost && d->entities < DXF_MOST) {
        int i, stop;
        f = d->frame + d->depth - 1;
        if (f->at >= f->end) {
            dxf_leave_block(d);
            continue;
        }
        i = f->at;
        stop = dxf_end(d, i);
        f->at = dxf_is(d, i, 0, "POLYLINE") || dxf_is(d, i, 0, "INSERT")
                  ? dxf_sequence(d, i)
                  : stop;
        d->entities++;
        if (d->group[i].code == 0 && dxf_entity(d, i, stop))
            return -1;
    }
    if (d->entities >= DXF_MOST)
        return shapes_fail(d->s, 0,
                           "a million entities and more, with those "
                           "that INSERT repeats");
    return 0;
}

/* Reads the sections, in whatever order they stand: units, layers and
   blocks, and then the entities. */
static int dxf_sections(struct dxf *d)
{
    static const struct {
        const char *name;
        int (*read)(struct dxf *, int first, int end);
    } read[] = {{"HEADER", dxf_units},
                {"TABLES", dxf_layers},
                {"BLOCKS", dxf_blocks},
                {"ENTITIES", dxf_entities}};
    for (size_t k = 0; k < sizeof read / sizeof *read; k++)
        for (int i = 0; i + 1 < d->groups; i = dxf_end(d, i)) {
            int end = i + 2;
            if (!dxf_is(d, i, 0, "SECTION")
                || !dxf_is(d, i + 1, 2, read[k].name))
                continue;
            while (end < d->groups && !dxf_is(d, end, 0, "ENDSEC")
                   && !dxf_is(d, end, 0, "EOF"))
                end++;
            if (read[k].read(d, i + 2, end))
                return -1;
        }
    return 0;
}

/* Reads the shapes of a drawing. Returns 0, or -1 with a message. */
static int dxf_read(struct shapes *s, const char *data, int length)
{
    struct dxf d;
    int bad;
    memset(&d, 0, sizeof d);
    d.s = s;
    d.data = data;
    if (length > 21 && memcmp(data, "AutoCAD Binary DXF", 18) == 0)
        return shapes_fail(s, 0,
                           "a binary drawing: save it as text (ASCII "
                           "DXF)");
    bad = dxf_groups(&d, length) || dxf_sections(&d) ? -1 : 0;
    free(d.group);
    free(d.layer);
    free(d.block);
    return bad;
}

#endif /* DXF_H */
