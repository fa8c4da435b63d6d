/* lines.h - closed outlines of lines and arcs that meet.

   The open paths of a drawing, and the edges of its outlines, are cut where they
   cross or where one ends on another, dead ends are taken away, and every face
   that remains is an outline: if more than half of its edge is of open paths (a
   line across a window makes no stone of the window), and it lies in no outline
   that was drawn closed.

   Ends meet within a thousandth of the median path, and within a ten-thousandth
   of the drawing. On an arc an end is looked for on the arc and not on its
   chords.

   SPDX-License-Identifier: MIT */

#ifndef LINES_H
#define LINES_H

#include "shapes.h"

enum {
    LINES_MOST = 40000,   /* straight pieces that are joined            */
    LINES_CUTS = 1000000, /* cuts of all of them                        */
    LINES_LABELS = 64     /* paths of a face that name it               */
};

/* A straight piece of a path, or a chord of its arc. */
struct lines_piece {
    struct shapes_point a, b; /* a.bulge: of the arc                   */
    int path;
};

struct lines_cut {
    int piece;
    double share; /* of the way from a to b                         */
    struct shapes_point at;
};

struct lines_edge {
    int a, b; /* nodes                                          */
    int path;
    int open; /* nonzero: of an open path                       */
    int gone;
};

struct lines {
    struct shapes *s;
    double snap, x, y; /* ends that meet; the least of all places */
    struct lines_piece *piece;
    int pieces;
    struct lines_cut *cut;
    int cuts, cut_room;
    struct shapes_point *node;
    int nodes, node_room;
    int *next, next_room; /* of a node in its cell, -1: none   */
    int *cell, cells;     /* the first node of a cell, by hash */
    struct lines_edge *edge;
    int edges, edge_room;
    int *order, *start, *place; /* half edges around each node   */
    char *used;                 /* paths that are part of a face */
};

/* ---- Polygons ------------------------------------------------------------- */

/* Returns twice the area of the n points, positive where they run counter-
   clockwise. */
static double lines_area(const struct shapes_point *p, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++) {
        const struct shapes_point a = p[i], b = p[i + 1 < n ? i + 1 : 0];
        sum += (a.x - p[0].x) * (b.y - p[0].y)
             - (b.x - p[0].x) * (a.y - p[0].y);
    }
    return sum;
}

static int lines_inside(const struct shapes_point *p, int n,
                        struct shapes_point q)
{
    int inside = 0;
    for (int i = 0, j = n - 1; i < n; j = i++)
        if ((p[i].y > q.y) != (p[j].y > q.y)
            && q.x < p[i].x
                         + (p[j].x - p[i].x) * (q.y - p[i].y)
                               / (p[j].y - p[i].y))
            inside = !inside;
    return inside;
}

/* Sorts n indices by their keys: a heap. */
static void lines_sort(int *index, int n, const double *key)
{
    for (int end = n, from = n / 2; end > 1;) {
        int top, child;
        if (from > 0)
            from--;
        else {
            const int last = index[--end];
            index[end] = index[0];
            index[0] = last;
        }
        top = from;
        while ((child = 2 * top + 1) < end) {
            const int value = index[top];
            if (child + 1 < end && key[index[child + 1]] > key[index[child]])
                child++;
            if (!(key[index[child]] > key[value]))
                break;
            index[top] = index[child];
            index[child] = value;
            top = child;
        }
    }
}

/* Finds a point inside the polygon: in the middle of the widest stretch at
   some height. */
static struct shapes_point lines_inner(const struct shapes_point *p, int n)
{
    double low = p[0].y, high = p[0].y, widest = -1;
    struct shapes_point out = p[0];
    for (int i = 1; i < n; i++) {
        low = p[i].y < low ? p[i].y : low;
        high = p[i].y > high ? p[i].y : high;
    }
    out.y = low + 0.4567 * (high - low);
    for (int i = 0, j = n - 1; i < n; j = i++) {
        double x, right = 0;
        int found = 0;
        if ((p[i].y > out.y) == (p[j].y > out.y))
            continue;
        x = p[i].x + (p[j].x - p[i].x) * (out.y - p[i].y) / (p[j].y - p[i].y);
        for (int k = 0, m = n - 1; k < n; m = k++) {
            double other;
            if ((p[k].y > out.y) == (p[m].y > out.y))
                continue;
            other = p[k].x
                  + (p[m].x - p[k].x) * (out.y - p[k].y) / (p[m].y - p[k].y);
            if (other > x && (!found || other < right)) {
                right = other;
                found = 1;
            }
        }
        if (found && right - x > widest) {
            struct shapes_point middle = out;
            middle.x = x + (right - x) / 2;
            if (!lines_inside(p, n, middle))
                continue;
            widest = right - x;
            out = middle;
        }
    }
    return out;
}

/* ---- Pieces and cuts ------------------------------------------------------ */

static int lines_is_open(const struct shapes_path *p)
{
    return !p->closed && !p->gone && p->role != SHAPES_IGNORED;
}

/* Outlines of fill are no edges of stones, and cover none. */
static int lines_takes_part(const struct shapes_path *p)
{
    return !p->gone && p->role != SHAPES_IGNORED
        && !(p->closed && p->role == SHAPES_FILL);
}

static void lines_collect(struct lines *l)
{
    const struct shapes *s = l->s;
    for (int i = 0; i < s->paths; i++) {
        const struct shapes_path *path = s->path + i;
        const struct shapes_point *p = s->point + path->first;
        if (!lines_takes_part(path))
            continue;
        for (int k = 0; k + !path->closed < path->points; k++) {
            struct lines_piece *piece = l->piece + l->pieces++;
            piece->a = p[k];
            piece->b = p[k + 1 < path->points ? k + 1 : 0];
            piece->path = i;
        }
    }
}

/* Widens the box from `low` to `high` by n points; the first ones make it. */
static void lines_box(const struct shapes_point *p, int n, int first,
                      struct shapes_point *low, struct shapes_point *high)
{
    for (int i = 0; i < n; i++) {
        const int made = first && i == 0;
        low->x = made || p[i].x < low->x ? p[i].x : low->x;
        low->y = made || p[i].y < low->y ? p[i].y : low->y;
        high->x = made || p[i].x > high->x ? p[i].x : high->x;
        high->y = made || p[i].y > high->y ? p[i].y : high->y;
    }
}

/* Finds how near ends must be to meet, and where the drawing begins. Returns
   0 where there is nothing to join. */
static int lines_measure(struct lines *l)
{
    struct shapes *s = l->s;
    double *size = shapes_array(s, s->paths, sizeof *size), whole;
    int *index = shapes_array(s, s->paths, sizeof *index), n = 0;
    struct shapes_point low = {0, 0, 0}, high = {0, 0, 0}, from, to;
    for (int i = 0; size && index && i < s->paths; i++) {
        const struct shapes_path *path = s->path + i;
        if (!lines_is_open(path))
            continue;
        lines_box(s->point + path->first, path->points, 1, &from, &to);
        lines_box(s->point + path->first, path->points, n == 0, &low, &high);
        size[n] = shapes_distance(from, to);
        index[n] = n;
        n++;
    }
    l->x = low.x;
    l->y = low.y;
    whole = shapes_distance(low, high);
    if (n > 0) {
        lines_sort(index, n, size);
        l->snap = 1e-3 * size[index[n / 2]];
        l->snap = l->snap < 1e-4 * whole ? l->snap : 1e-4 * whole;
        l->snap = l->snap > 1e-9 * whole ? l->snap : 1e-9 * whole;
    }
    s->meet = l->snap;
    free(size);
    free(index);
    return l->snap > 0 && l->snap < 1e300;
}

static void lines_cut(struct lines *l, int piece, double share,
                      struct shapes_point at)
{
    struct lines_cut *c = shapes_grown(l->s, l->cut, l->cuts, &l->cut_room,
                                       sizeof *c);
    if (!c)
        return;
    l->cut = c;
    c += l->cuts++;
    c->piece = piece;
    c->share = share;
    c->at = at;
}

/* Returns how far p is from a piece, below 0 where it is beyond its ends.
   Writes the share of the piece's way to `share`. */
static double lines_away(const struct lines_piece *piece, struct shapes_point p,
                         double *share)
{
    const double x = piece->b.x - piece->a.x, y = piece->b.y - piece->a.y;
    const double chord = SHAPES_SQRT(x * x + y * y), b = piece->a.bulge;
    const double size = shapes_abs(b);
    double radius, off, beyond;
    struct shapes_point c = {0, 0, 0};
    if (!(chord > 0))
        return -1;
    *share = ((p.x - piece->a.x) * x + (p.y - piece->a.y) * y) / chord / chord;
    if (!(*share > 0 && *share < 1))
        return -1;
    off = shapes_abs((p.x - piece->a.x) * y - (p.y - piece->a.y) * x) / chord;
    if (!(size > 1e-9))
        return off;
    radius = chord * (1 + size * size) / (4 * size);
    c.x = (piece->a.x + piece->b.x) / 2
        - y / chord * (radius - size * chord / 2) * (b < 0 ? -1 : 1);
    c.y = (piece->a.y + piece->b.y) / 2
        + x / chord * (radius - size * chord / 2) * (b < 0 ? -1 : 1);
    beyond = off - size * chord / 2; /* of the other side of the circle */
    off = shapes_abs(shapes_distance(c, p) - radius);
    return beyond > off ? beyond : off;
}

/* Cuts a piece where an end of another one lies on it. */
static void lines_touch(struct lines *l, int i, struct shapes_point end)
{
    const struct lines_piece *piece = l->piece + i;
    double share = 0, away = lines_away(piece, end, &share);
    if (!(away >= 0 && away <= l->snap)
        || shapes_distance(end, piece->a) <= l->snap
        || shapes_distance(end, piece->b) <= l->snap)
        return;
    lines_cut(l, i, share, end);
}

/* Cuts two pieces where they cross, away from their ends. */
static void lines_cross(struct lines *l, int i, int j)
{
    const struct lines_piece *p = l->piece + i, *q = l->piece + j;
    const double ux = p->b.x - p->a.x, uy = p->b.y - p->a.y;
    const double vx = q->b.x - q->a.x, vy = q->b.y - q->a.y;
    const double x = q->a.x - p->a.x, y = q->a.y - p->a.y;
    const double cross = ux * vy - uy * vx;
    const double a = (x * vy - y * vx) / cross, b = (x * uy - y * ux) / cross;
    struct shapes_point at = {0, 0, 0};
    if (!(a > 0 && a < 1 && b > 0 && b < 1))
        return;
    at.x = p->a.x + a * ux;
    at.y = p->a.y + a * uy;
    if (shapes_distance(at, p->a) > l->snap
        && shapes_distance(at, p->b) > l->snap
        && shapes_distance(at, q->a) > l->snap
        && shapes_distance(at, q->b) > l->snap) {
        lines_cut(l, i, a, at);
        lines_cut(l, j, b, at);
    }
}

static void lines_meet(struct lines *l, int i, int j)
{
    const struct lines_piece p = l->piece[i], q = l->piece[j];
    const double room = 2 * l->snap
                      + SHAPES_ARC
                            * (shapes_distance(p.a, p.b)
                               + shapes_distance(q.a, q.b));
    if ((p.a.y < p.b.y ? p.a.y : p.b.y) > (q.a.y > q.b.y ? q.a.y : q.b.y) + room
        || (q.a.y < q.b.y ? q.a.y : q.b.y)
               > (p.a.y > p.b.y ? p.a.y : p.b.y) + room)
        return;
    lines_touch(l, i, q.a);
    lines_touch(l, i, q.b);
    lines_touch(l, j, p.a);
    lines_touch(l, j, p.b);
    lines_cross(l, i, j);
}

/* Cuts all pairs of pieces whose stretches of x are near. Returns 0 where
   there are too many cuts. */
static int lines_cut_all(struct lines *l)
{
    struct shapes *s = l->s;
    double *left = shapes_array(s, l->pieces, sizeof *left);
    int *index = shapes_array(s, l->pieces, sizeof *index);
    for (int i = 0; left && index && i < l->pieces; i++) {
        const struct lines_piece *p = l->piece + i;
        left[i] = p->a.x < p->b.x ? p->a.x : p->b.x;
        index[i] = i;
    }
    if (left && index)
        lines_sort(index, l->pieces, left);
    for (int i = 0; left && index && i < l->pieces && !s->lost; i++) {
        const struct lines_piece *p = l->piece + index[i];
        const double right = (p->a.x > p->b.x ? p->a.x : p->b.x) + 2 * l->snap
                           + 2 * SHAPES_ARC * shapes_distance(p->a, p->b);
        for (int j = i + 1;
             j < l->pieces && left[index[j]] <= right && l->cuts < LINES_CUTS;
             j++)
            lines_meet(l, index[i], index[j]);
    }
    free(left);
    free(index);
    return l->cuts < LINES_CUTS && !s->lost;
}

/* ---- Nodes and edges ------------------------------------------------------ */

/* Returns the cell of a place, so many columns and rows away. */
static int *lines_cell(struct lines *l, struct shapes_point p, int dx, int dy)
{
    const double size = 2 * l->snap;
    double x = (p.x - l->x) / size + dx, y = (p.y - l->y) / size + dy;
    unsigned long column, row;
    x = x > -1e9 && x < 1e9 ? x + 1e9 : 0;
    y = y > -1e9 && y < 1e9 ? y + 1e9 : 0;
    column = (unsigned long)x & 0xffffffffu;
    row = (unsigned long)y & 0xffffffffu;
    return l->cell
         + ((column * 73856093u ^ row * 19349663u)
            & (unsigned long)(l->cells - 1));
}

/* Returns the node near a place, and makes one where there is none. Returns
   -1 without memory. */
static int lines_node(struct lines *l, struct shapes_point p)
{
    struct shapes_point *node;
    int *next, *cell;
    for (int dx = -1; dx <= 1; dx++)
        for (int dy = -1; dy <= 1; dy++)
            for (int i = *lines_cell(l, p, dx, dy); i >= 0; i = l->next[i])
                if (shapes_distance(l->node[i], p) <= l->snap)
                    return i;
    node = shapes_grown(l->s, l->node, l->nodes, &l->node_room, sizeof *node);
    l->node = node ? node : l->node;
    next = shapes_grown(l->s, l->next, l->nodes, &l->next_room, sizeof *next);
    l->next = next ? next : l->next;
    if (!node || !next)
        return -1;
    cell = lines_cell(l, p, 0, 0);
    node[l->nodes] = p;
    next[l->nodes] = *cell;
    *cell = l->nodes;
    return l->nodes++;
}

static void lines_edge(struct lines *l, int a, int b, int path)
{
    struct lines_edge *e = NULL;
    if (a != b && a >= 0 && b >= 0)
        e = shapes_grown(l->s, l->edge, l->edges, &l->edge_room, sizeof *e);
    if (!e)
        return;
    l->edge = e;
    e += l->edges++;
    e->a = a < b ? a : b;
    e->b = a < b ? b : a;
    e->path = path;
    e->open = !l->s->path[path].closed;
    e->gone = 0;
}

/* Makes edges of the pieces between their cuts. */
static void lines_divide(struct lines *l)
{
    struct shapes *s = l->s;
    double *key = shapes_array(s, l->cuts, sizeof *key);
    int *index = shapes_array(s, l->cuts, sizeof *index), k = 0;
    for (l->cells = 64; l->cells < l->pieces + l->cuts;)
        l->cells *= 2;
    l->cell = shapes_array(s, l->cells, sizeof *l->cell);
    for (int i = 0; l->cell && i < l->cells; i++)
        l->cell[i] = -1;
    for (int i = 0; key && index && i < l->cuts; i++) {
        key[i] = l->cut[i].piece + 0.5 * l->cut[i].share;
        index[i] = i;
    }
    if (!s->lost)
        lines_sort(index, l->cuts, key);
    for (int i = 0; i < l->pieces && !s->lost; i++) {
        const struct lines_piece *p = l->piece + i;
        int from = lines_node(l, p->a);
        for (; k < l->cuts && l->cut[index[k]].piece == i && !s->lost; k++) {
            const int to = lines_node(l, l->cut[index[k]].at);
            lines_edge(l, from, to, p->path);
            from = to;
        }
        if (!s->lost)
            lines_edge(l, from, lines_node(l, p->b), p->path);
    }
    free(key);
    free(index);
}

/* Keeps one of the edges between the same nodes: an open one, if there is
   one. */
static void lines_merge(struct lines *l)
{
    struct shapes *s = l->s;
    double *key = shapes_array(s, l->edges, sizeof *key);
    int *index = shapes_array(s, l->edges, sizeof *index), kept = -1;
    for (int i = 0; key && index && i < l->edges; i++) {
        key[i] = (double)l->edge[i].a * l->nodes + l->edge[i].b;
        index[i] = i;
    }
    if (!s->lost)
        lines_sort(index, l->edges, key);
    for (int i = 0; i < l->edges && !s->lost; i++) {
        struct lines_edge *e = l->edge + index[i];
        struct lines_edge *k = kept < 0 ? NULL : l->edge + kept;
        if (!k || k->a != e->a || k->b != e->b) {
            kept = index[i];
            continue;
        }
        e->gone = 1;
        if (e->open && !k->open) {
            k->open = 1;
            k->path = e->path;
        }
    }
    free(key);
    free(index);
}

/* Takes dead ends away, and then what they leave as dead ends. */
static void lines_prune(struct lines *l)
{
    struct shapes *s = l->s;
    int *degree = shapes_array(s, l->nodes, sizeof *degree), gone = 1;
    int *sum = shapes_array(s, l->nodes, sizeof *sum);
    int *stack = shapes_array(s, l->nodes, sizeof *stack), n = 0;
    for (int i = 0; !s->lost && i < l->edges; i++) {
        const struct lines_edge *e = l->edge + i;
        if (e->gone)
            continue;
        degree[e->a]++;
        degree[e->b]++;
        sum[e->a] ^= i; /* of one edge it is that one */
        sum[e->b] ^= i;
    }
    for (int i = 0; !s->lost && i < l->nodes; i++)
        if (degree[i] == 1)
            stack[n++] = i;
    while (!s->lost && n > 0 && gone) {
        const int node = stack[--n], i = sum[node];
        struct lines_edge *e = l->edge + i;
        int other;
        if (degree[node] != 1)
            continue;
        other = e->a == node ? e->b : e->a;
        e->gone = 1;
        degree[node] = 0;
        sum[other] ^= i;
        if (--degree[other] == 1)
            stack[n++] = other;
    }
    free(degree);
    free(sum);
    free(stack);
}

/* ---- Faces ---------------------------------------------------------------- */

/* Returns the node where a half edge begins: 2e runs from a to b of edge e,
   2e + 1 back. */
static int lines_from(const struct lines *l, int half)
{
    const struct lines_edge *e = l->edge + half / 2;
    return half % 2 ? e->b : e->a;
}

/* Returns a number that grows with the angle of (x, y), from 0 to below 4.
   */
static double lines_angle(double x, double y)
{
    const double sum = shapes_abs(x) + shapes_abs(y);
    const double share = sum > 0 ? y / sum : 0;
    if (x >= 0)
        return y >= 0 ? share : 4 + share < 4 ? 4 + share : 0;
    return 2 - share;
}

/* Orders the half edges around each node, counter-clockwise. */
static void lines_order(struct lines *l)
{
    struct shapes *s = l->s;
    double *key = shapes_array(s, 2 * l->edges, sizeof *key);
    int n = 0;
    l->order = shapes_array(s, 2 * l->edges, sizeof *l->order);
    l->place = shapes_array(s, 2 * l->edges, sizeof *l->place);
    l->start = shapes_array(s, l->nodes + 1, sizeof *l->start);
    for (int h = 0; !s->lost && h < 2 * l->edges; h++) {
        const struct shapes_point a = l->node[lines_from(l, h)];
        const struct shapes_point b = l->node[lines_from(l, h ^ 1)];
        if (l->edge[h / 2].gone)
            continue;
        key[h] = 8.0 * lines_from(l, h) + lines_angle(b.x - a.x, b.y - a.y);
        l->order[n++] = h;
        l->start[lines_from(l, h) + 1]++;
    }
    if (!s->lost)
        lines_sort(l->order, n, key);
    for (int i = 0; !s->lost && i < n; i++)
        l->place[l->order[i]] = i;
    for (int i = 0; !s->lost && i < l->nodes; i++)
        l->start[i + 1] += l->start[i];
    free(key);
}

/* Returns the half edge after one, around the face on its left. */
static int lines_next(const struct lines *l, int half)
{
    const int node = lines_from(l, half ^ 1), at = l->place[half ^ 1];
    return l->order[at > l->start[node] ? at - 1 : l->start[node + 1] - 1];
}

/* Returns the path whose label has the longest way along a face. */
static int lines_namer(const struct lines *l, int half)
{
    int path[LINES_LABELS], n = 0, best = -1;
    double length[LINES_LABELS], most = -1;
    int h = half;
    do {
        const struct lines_edge *e = l->edge + h / 2;
        const char *label = shapes_at(l->s, l->s->path[e->path].label);
        int k = 0;
        while (k < n
               && strcmp(label, shapes_at(l->s, l->s->path[path[k]].label))
                      != 0)
            k++;
        if (k == n && n < LINES_LABELS) {
            path[n] = e->path;
            length[n++] = 0;
        }
        if (k < n && e->open)
            length[k] += shapes_distance(l->node[e->a], l->node[e->b]);
        h = lines_next(l, h);
    } while (h != half);
    for (int k = 0; k < n; k++)
        if (length[k] > most) {
            most = length[k];
            best = path[k];
        }
    return best;
}

/* Returns 1 if a place lies in an outline that was drawn closed. */
static int lines_covered(const struct shapes *s, int paths,
                         struct shapes_point at)
{
    for (int i = 0; i < paths; i++) {
        const struct shapes_path *p = s->path + i;
        if (p->closed && lines_takes_part(p)
            && lines_inside(s->point + p->first, p->points, at))
            return 1;
    }
    return 0;
}

/* Makes an outline of the face on the left of a half edge, if it is a stone's;
   `paths` are those that were drawn. */
static void lines_face(struct lines *l, int half, int paths)
{
    struct shapes *s = l->s;
    const int first = s->points;
    double open = 0, whole = 0, area;
    int h = half, line = 0, made, namer;
    do {
        const struct lines_edge *e = l->edge + h / 2;
        const struct shapes_point p = l->node[lines_from(l, h)];
        const double length = shapes_distance(l->node[e->a], l->node[e->b]);
        shapes_point(s, p.x, p.y, 0);
        whole += length;
        open += e->open ? length : 0;
        if (line == 0 || s->path[e->path].line < line)
            line = s->path[e->path].line;
        h = lines_next(l, h);
    } while (h != half && !s->lost);
    if (s->lost)
        return;
    area = lines_area(s->point + first, s->points - first) / 2;
    if (!(area > l->snap * whole && open > whole / 2)
        || lines_covered(s, paths,
                         lines_inner(s->point + first, s->points - first))) {
        s->points = first;
        return;
    }
    namer = lines_namer(l, half);
    do {
        l->used[l->edge[h / 2].path] = 1;
        h = lines_next(l, h);
    } while (h != half);
    made = shapes_path(s, first, 1, shapes_word(s, "lines that meet", 15),
                       s->path[namer].label, line);
    if (made >= 0)
        s->path[made].joined = 1;
}

static void lines_faces(struct lines *l)
{
    struct shapes *s = l->s;
    const int paths = s->paths;
    char *seen = shapes_array(s, 2 * l->edges, sizeof *seen);
    l->used = shapes_array(s, paths, sizeof *l->used);
    for (int h = 0; !s->lost && h < 2 * l->edges; h++) {
        int next = h;
        if (seen[h] || l->edge[h / 2].gone)
            continue;
        do {
            seen[next] = 1;
            next = lines_next(l, next);
        } while (next != h);
        lines_face(l, h, paths);
    }
    for (int i = 0; !s->lost && i < paths; i++)
        if (l->used[i] && !s->path[i].closed)
            s->path[i].gone = 1;
    free(seen);
}

static void lines_free(struct lines *l)
{
    free(l->piece);
    free(l->cut);
    free(l->node);
    free(l->next);
    free(l->cell);
    free(l->edge);
    free(l->order);
    free(l->start);
    free(l->place);
    free(l->used);
}

/* Adds the outlines of lines that meet, and takes their open paths away. */
static void lines_join(struct shapes *s)
{
    struct lines l;
    double pieces = 0;
    int open = 0;
    memset(&l, 0, sizeof l);
    l.s = s;
    for (int i = 0; i < s->paths; i++)
        if (lines_takes_part(s->path + i)) {
            pieces += s->path[i].points;
            open += lines_is_open(s->path + i);
        }
    if (open == 0 || s->lost)
        return;
    if (pieces <= LINES_MOST && lines_measure(&l)
        && (l.piece = shapes_array(s, (int)pieces, sizeof *l.piece)) != NULL) {
        lines_collect(&l);
        if (lines_cut_all(&l)) {
            lines_divide(&l);
            lines_merge(&l);
            lines_prune(&l);
            lines_order(&l);
            if (!s->lost)
                lines_faces(&l);
        }
    }
    if (pieces > LINES_MOST || l.cuts >= LINES_CUTS)
        shapes_put(&s->notes, "the lines are too many to look for outlines "
                              "among them: only closed ones are read\n");
    lines_free(&l);
}

#endif /* LINES_H */
