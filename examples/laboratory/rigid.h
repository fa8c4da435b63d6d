/* rigid.h - a small simulator of rigid blocks in the plane, with dry friction.

   Blocks are simple polygons; concave ones are cut into convex pieces. Nothing
   bounces. The solver takes many small sub-steps with one pass over the
   contacts in each, which start from the impulses of the last sub-step ("warm
   starting"); overlaps are pushed out by soft springs, and the speed which
   that would leave is taken back by a second pass without them. These ideas
   were published with Box2D; E. Catto, Solver2D, 2024, compares them. Two are
   added: no sub-step adds energy, see rigid_relax(), and what is at rest can
   be told so, see rigid_settle().

       struct rigid_world w;
       rigid_init(&w);
       rigid_add(&w, ground, 4, 0, at);              mass 0: moves only as told
       rigid_add(&w, stone, 4, 1.5, at);             and its centre of mass
       while (...) rigid_step(&w);
       rigid_free(&w);

   The same calls give the same bits wherever doubles are IEEE doubles and the
   compiler keeps to them (-ffp-contract=off, and for x86 with -mfma gcc's
   -fno-tree-vectorize): a step takes + - * / and sqrt().
   Lengths should be of the order of 1: see `slop`.

   SPDX-License-Identifier: MIT */

#ifndef RIGID_H
#define RIGID_H

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct rigid_pt {
    double x, y;
};

/* A block. The first lines are all that the solver touches. */
struct rigid_block {
    struct rigid_pt v; /* speed of the centre of mass              */
    double spin;
    struct rigid_pt moved; /* since the step began                     */
    double turned;
    double inv_mass, inv_inertia; /* 0: moves only as told                    */
    struct rigid_pt at;           /* centre of mass                           */
    struct rigid_pt turn;         /* cosine and sine of the angle             */
    double angle;                 /* the same, with whole turns               */
    struct rigid_pt force;        /* acts besides the weight                  */
    double torque;
    double reach;            /* of the farthest corner, from the centre  */
    struct rigid_pt seen_at; /* where it was when the pairs were listed  */
    struct rigid_pt seen_turn;
};

/* A corner, and the normal of the edge from it to the next one. */
struct rigid_corner {
    struct rigid_pt local, local_normal; /* from the centre of mass, unturned */
    struct rigid_pt at, normal;          /* in the world                      */
};

/* A convex part of a block, counter-clockwise. */
struct rigid_piece {
    int block, first, corners;
    struct rigid_pt local, at; /* a point inside: the mean of the corners  */
    struct rigid_pt low, high; /* its box when the pairs were listed       */
};

/* Two pieces near each other, a before b, and what is worth remembering of
   the last step: edges that kept them apart, and impulses by corners. `rest`
   is added to a gap, see rigid_settle(). */
struct rigid_pair {
    int a, b;
    int edge_a, edge_b;
    int points, id[2];
    double normal[2], tangent[2], rest[2];
};

/* A point of contact, as the solver wants it: arms of the normal and the
   tangent about both centres, 1 / (what a unit impulse changes), the gap at
   the beginning of the step, impulses. */
struct rigid_point {
    double normal_a, normal_b, tangent_a, tangent_b;
    double normal_mass, tangent_mass;
    double gap, rest;
    double normal, tangent;
};

struct rigid_contact {
    int a, b, pair, points, driven;
    struct rigid_pt n; /* from a into b                            */
    struct rigid_point point[2];
};

/* A contact before that, in the world. */
struct rigid_touch {
    struct rigid_pt n, at[2];
    double gap[2];
    int points, id[2];
};

struct rigid_world {
    struct rigid_pt gravity;
    double friction;
    double step; /* seconds                                  */
    int substeps;
    double slop;    /* lengths below it do not matter           */
    double damping; /* of the springs that push overlaps out    */
    double push;    /* the fastest that they may do it          */
    struct rigid_block *block;
    struct rigid_piece *piece;
    struct rigid_corner *corner;
    struct rigid_pair *pair, *old_pair;
    struct rigid_contact *contact;
    int blocks, pieces, corners, pairs, contacts;
    int block_room, piece_room, corner_room, pair_room, contact_room;
    int listed; /* 0: pairs must be listed anew             */
    int failed; /* memory was lacking: the world is useless */
};

/* ---- Vectors ------------------------------------------------------------- */

static inline struct rigid_pt rigid_vec(double x, double y)
{
    struct rigid_pt p = {x, y};
    return p;
}

static inline struct rigid_pt rigid_sub(struct rigid_pt a, struct rigid_pt b)
{
    return rigid_vec(a.x - b.x, a.y - b.y);
}

static inline double rigid_dot(struct rigid_pt a, struct rigid_pt b)
{
    return a.x * b.x + a.y * b.y;
}

static inline double rigid_length(struct rigid_pt a)
{
    return sqrt(rigid_dot(a, a));
}

static inline double rigid_cross(struct rigid_pt a, struct rigid_pt b)
{
    return a.x * b.y - a.y * b.x;
}

static inline double rigid_least(double a, double b) { return a < b ? a : b; }

static inline double rigid_most(double a, double b) { return a > b ? a : b; }

/* The product of two complex numbers: turns p by the angle of q. */
static inline struct rigid_pt rigid_turned(struct rigid_pt q, struct rigid_pt p)
{
    return rigid_vec(q.x * p.x - q.y * p.y, q.x * p.y + q.y * p.x);
}

/* Cosine and sine of any angle, the same on every machine: a series for a
   small part of it, squared back. */
static inline struct rigid_pt rigid_unit(double angle)
{
    enum { HALVINGS = 12 };
    double t = angle / (1 << HALVINGS), tt = t * t;
    struct rigid_pt q = {1 - tt / 2 + tt * tt / 24,
                         t * (1 - tt / 6 + tt * tt / 120)};
    for (int i = 0; i < HALVINGS; i++) {
        double length;
        q = rigid_turned(q, q);
        length = rigid_length(q);
        q = rigid_vec(q.x / length, q.y / length);
    }
    return q;
}

/* ---- Memory -------------------------------------------------------------- */

static inline void rigid_init(struct rigid_world *w)
{
    static const struct rigid_world empty;
    *w = empty;
    w->gravity = rigid_vec(0, -9.81);
    w->friction = 0.4;
    w->step = 1.0 / 240;
    w->substeps = 4;
    w->slop = 0.005;
    w->damping = 10;
    w->push = 3;
}

static inline void rigid_free(struct rigid_world *w)
{
    free(w->block);
    free(w->piece);
    free(w->corner);
    free(w->pair);
    free(w->old_pair);
    free(w->contact);
    rigid_init(w);
}

/* Makes room for `count` things more in an array that holds `used` of `room`;
   returns the array, or NULL, the old one then being as it was. */
static inline void *rigid_room(void *array, int used, int count, int *room,
                               size_t size)
{
    int want = *room > 0 ? *room : 16;
    void *more;
    if (array && used + count <= *room)
        return array;
    while (want < used + count)
        want *= 2;
    more = realloc(array, (size_t)want * size);
    if (more)
        *room = want;
    return more;
}

/* ---- Convex pieces ------------------------------------------------------- */

/* Twice the area of a triangle, counter-clockwise positive. */
static inline double rigid_area(struct rigid_pt a, struct rigid_pt b,
                                struct rigid_pt c)
{
    return rigid_cross(rigid_sub(b, a), rigid_sub(c, a));
}

/* Is corner k of this ring an ear: convex, no other corner in its triangle? */
static inline int rigid_ear(const struct rigid_pt *v, const int *ring, int n,
                            int k)
{
    int before = ring[(k + n - 1) % n], here = ring[k];
    int next = ring[(k + 1) % n];
    struct rigid_pt a = v[before], b = v[here], c = v[next];
    if (!(rigid_area(a, b, c) > 0))
        return 0;
    for (int i = 0; i < n; i++) {
        struct rigid_pt p = v[ring[i]];
        if (ring[i] == before || ring[i] == here || ring[i] == next)
            continue;
        if (rigid_area(a, b, p) >= 0 && rigid_area(b, c, p) >= 0
            && rigid_area(c, a, p) >= 0)
            return 0;
    }
    return 1;
}

/* Cuts a simple counter-clockwise polygon into n - 2 triangles by cutting off
   ears; of two that remain in doubt the first is cut. Each triangle takes a
   row of `part`, n wide. */
static inline int rigid_triangles(const struct rigid_pt *v, int n, int *part,
                                  int *size, int *ring)
{
    int parts = 0, left = n;
    for (int i = 0; i < n; i++)
        ring[i] = i;
    while (left >= 3) {
        int k = 0;
        while (k < left - 1 && !rigid_ear(v, ring, left, k))
            k++;
        int *t = part + (size_t)n * (size_t)parts;
        t[0] = ring[(k + left - 1) % left];
        t[1] = ring[k];
        t[2] = ring[(k + 1) % left];
        if (rigid_area(v[t[0]], v[t[1]], v[t[2]]) > 0)
            size[parts++] = 3;
        for (int i = k; i < left - 1; i++)
            ring[i] = ring[i + 1];
        left--;
    }
    return parts;
}

/* Joins q to p along the edge that they share, if the whole is convex; `out`
   has room for both. Returns the number of its corners, or 0. */
static inline int rigid_join(const struct rigid_pt *v, const int *p, int np,
                             const int *q, int nq, int *out)
{
    for (int i = 0; i < np; i++)
        for (int j = 0; j < nq; j++) {
            int n = 0, convex = 1;
            if (p[i] != q[(j + 1) % nq] || p[(i + 1) % np] != q[j])
                continue;
            for (int k = 1; k <= np; k++)
                out[n++] = p[(i + k) % np];
            for (int k = 2; k < nq; k++)
                out[n++] = q[(j + k) % nq];
            for (int k = 0; k < n; k++)
                convex &= rigid_area(v[out[k]], v[out[(k + 1) % n]],
                                     v[out[(k + 2) % n]])
                       >= 0;
            return convex ? n : 0;
        }
    return 0;
}

/* Cuts a simple counter-clockwise polygon into convex parts, each a row of
   `part` (n * n ints); `size` takes their lengths. `spare` holds 2 n ints.
   Returns how many there are. */
static inline int rigid_convex(const struct rigid_pt *v, int n, int *part,
                               int *size, int *spare)
{
    int parts = rigid_triangles(v, n, part, size, spare);
    for (int i = 0; i < parts; i++)
        for (int j = i + 1; j < parts; j++) {
            int *p = part + (size_t)n * (size_t)i;
            int *q = part + (size_t)n * (size_t)j;
            int *last = part + (size_t)n * (size_t)(parts - 1);
            int joined = rigid_join(v, p, size[i], q, size[j], spare);
            if (joined == 0)
                continue;
            memcpy(p, spare, (size_t)joined * sizeof *p);
            memmove(q, last, (size_t)size[parts - 1] * sizeof *q);
            size[i] = joined;
            size[j] = size[--parts];
            j = i; /* what did not fit before may fit now */
        }
    return parts;
}

/* ---- Adding blocks ------------------------------------------------------- */

/* Drops corners that stick out by less than 1e-4 of the neighbours' distance:
   an edge in two halves would be two short beds instead of a long one. */
static inline int rigid_smooth(const struct rigid_pt *v, int *part, int n)
{
    for (int k = 0; k < n && n > 3; k++) {
        struct rigid_pt a = v[part[(k + n - 1) % n]], b = v[part[k]];
        struct rigid_pt c = v[part[(k + 1) % n]], ac = rigid_sub(c, a);
        if (rigid_area(a, b, c) > 1e-4 * rigid_dot(ac, ac))
            continue;
        for (int i = k; i < n - 1; i++)
            part[i] = part[i + 1];
        n--;
        k = -1;
    }
    return n;
}

/* Adds a piece of the last block; v is relative to its centre of mass. */
static inline int rigid_add_piece(struct rigid_world *w,
                                  const struct rigid_pt *v, int *part, int n)
{
    struct rigid_piece *p;
    struct rigid_corner *c;
    n = rigid_smooth(v, part, n);
    p = rigid_room(w->piece, w->pieces, 1, &w->piece_room, sizeof *p);
    if (p)
        w->piece = p;
    c = rigid_room(w->corner, w->corners, n, &w->corner_room, sizeof *c);
    if (c)
        w->corner = c;
    if (!p || !c)
        return -1;
    p += w->pieces++;
    c += w->corners;
    memset(p, 0, sizeof *p);
    memset(c, 0, (size_t)n * sizeof *c);
    p->block = w->blocks - 1;
    p->first = w->corners;
    p->corners = n;
    for (int i = 0; i < n; i++) {
        struct rigid_pt here = v[part[i]];
        struct rigid_pt e = rigid_sub(v[part[(i + 1) % n]], here);
        double length = rigid_length(e);
        c[i].local = here;
        c[i].local_normal = rigid_vec(e.y / length, -e.x / length);
        p->local.x += here.x / n;
        p->local.y += here.y / n;
    }
    w->corners += n;
    return 0;
}

/* The inertia of a polygon about the origin, over its mass. */
static inline double rigid_inertia(const struct rigid_pt *v, int n)
{
    double area = 0, sum = 0;
    for (int i = 0; i < n; i++) {
        struct rigid_pt a = v[i], b = v[(i + 1) % n];
        double c = rigid_cross(a, b);
        area += c;
        sum += c * (rigid_dot(a, a) + rigid_dot(a, b) + rigid_dot(b, b));
    }
    return sum / (6 * area);
}

/* Adds polygon v, relative to the centre of mass, to the last block. */
static inline int rigid_add_polygon(struct rigid_world *w,
                                    const struct rigid_pt *v, int n)
{
    size_t row = (size_t)n;
    int *part = malloc((row * row + 3 * row) * sizeof *part), bad = !part;
    if (part) {
        int *size = part + row * row, *spare = size + row;
        int parts = rigid_convex(v, n, part, size, spare);
        for (int i = 0; i < parts && !bad; i++)
            bad = rigid_add_piece(w, v, part + row * (size_t)i, size[i]);
    }
    free(part);
    return bad ? -1 : 0;
}

/* Adds a block: a simple polygon in world coordinates, either way round, its
   mass (0: it moves only as told) and centre of mass. With mass 0 and `more`
   not 0 it becomes part of the last block. Returns the index of the block, or
   -1 where memory is lacking. */
static inline int rigid_add_part(struct rigid_world *w,
                                 const struct rigid_pt *v, int n, double mass,
                                 struct rigid_pt centre, int more)
{
    struct rigid_block *b;
    struct rigid_pt *u = malloc((size_t)n * sizeof *u);
    double area = 0, reach = 0;
    b = rigid_room(w->block, w->blocks, 1, &w->block_room, sizeof *b);
    if (b)
        w->block = b;
    if (!u || !b) {
        free(u);
        w->failed = 1;
        return -1;
    }
    if (more)
        centre = b[w->blocks - 1].at;
    else
        memset(b + w->blocks++, 0, sizeof *b);
    b += w->blocks - 1;
    for (int i = 0; i < n; i++) {
        area += rigid_cross(rigid_sub(v[i], v[0]),
                            rigid_sub(v[(i + 1) % n], v[0]));
        u[i] = rigid_sub(v[i], centre);
        if (reach < rigid_dot(u[i], u[i]))
            reach = rigid_dot(u[i], u[i]);
    }
    for (int i = 0; area < 0 && i < n / 2; i++) {
        struct rigid_pt p = u[i];
        u[i] = u[n - 1 - i];
        u[n - 1 - i] = p;
    }
    if (mass > 0) {
        b->inv_mass = 1 / mass;
        b->inv_inertia = 1 / (mass * rigid_inertia(u, n));
    }
    b->at = centre;
    b->turn = rigid_vec(1, 0);
    if (b->reach < sqrt(reach))
        b->reach = sqrt(reach);
    w->failed |= rigid_add_polygon(w, u, n);
    w->listed = 0;
    free(u);
    return w->failed ? -1 : w->blocks - 1;
}

static inline int rigid_add(struct rigid_world *w, const struct rigid_pt *v,
                            int n, double mass, struct rigid_pt centre)
{
    return rigid_add_part(w, v, n, mass, centre, 0);
}

/* Puts a block somewhere, at rest; all contacts are forgotten. */
static inline void rigid_put(struct rigid_world *w, int block,
                             struct rigid_pt at, double angle)
{
    struct rigid_block *b = &w->block[block];
    b->at = at;
    b->angle = angle;
    b->turn = rigid_unit(angle);
    b->v = rigid_vec(0, 0);
    b->spin = 0;
    w->pairs = 0;
    w->listed = 0;
}

/* ---- Which pieces are near each other ------------------------------------ */

/* Contacts are made this far ahead, so that nothing runs into each other. */
static inline double rigid_ahead(const struct rigid_world *w)
{
    return 4 * w->slop;
}

/* How far a block may go before the pairs are listed again. */
static inline double rigid_skin(const struct rigid_world *w)
{
    return 10 * w->slop;
}

static inline void rigid_place(struct rigid_world *w)
{
    for (int i = 0; i < w->pieces; i++) {
        struct rigid_piece *p = &w->piece[i];
        const struct rigid_block *b = &w->block[p->block];
        const struct rigid_pt q = b->turn, o = b->at;
        struct rigid_corner *c = w->corner + p->first;
        struct rigid_pt r = rigid_turned(q, p->local);
        p->at = rigid_vec(o.x + r.x, o.y + r.y);
        for (int k = 0; k < p->corners; k++) {
            r = rigid_turned(q, c[k].local);
            c[k].at = rigid_vec(o.x + r.x, o.y + r.y);
            c[k].normal = rigid_turned(q, c[k].local_normal);
        }
    }
}

/* Has a block gone so far that a pair may be missing? */
static inline int rigid_strayed(const struct rigid_world *w)
{
    double skin = rigid_skin(w);
    for (int i = 0; i < w->blocks; i++) {
        const struct rigid_block *b = &w->block[i];
        struct rigid_pt d = rigid_sub(b->at, b->seen_at);
        struct rigid_pt q = rigid_sub(b->turn, b->seen_turn);
        double dist = rigid_dot(d, d);
        double turn = b->reach * b->reach * rigid_dot(q, q);
        if (4 * dist > skin * skin || 4 * turn > skin * skin)
            return 1;
    }
    return 0;
}

/* A block may go skin / 2 and turn its corners by as much: each box is wider
   by the sum of both. */
static inline void rigid_boxes(struct rigid_world *w)
{
    double wide = rigid_skin(w) + rigid_ahead(w) / 2;
    for (int i = 0; i < w->blocks; i++) {
        w->block[i].seen_at = w->block[i].at;
        w->block[i].seen_turn = w->block[i].turn;
    }
    for (int i = 0; i < w->pieces; i++) {
        struct rigid_piece *p = &w->piece[i];
        const struct rigid_corner *c = w->corner + p->first;
        p->low = p->high = c->at;
        for (int k = 1; k < p->corners; k++) {
            p->low.x = rigid_least(p->low.x, c[k].at.x);
            p->low.y = rigid_least(p->low.y, c[k].at.y);
            p->high.x = rigid_most(p->high.x, c[k].at.x);
            p->high.y = rigid_most(p->high.y, c[k].at.y);
        }
        p->low = rigid_vec(p->low.x - wide, p->low.y - wide);
        p->high = rigid_vec(p->high.x + wide, p->high.y + wide);
    }
}

static inline int rigid_boxes_meet(const struct rigid_world *w, int i, int j)
{
    const struct rigid_piece *p = &w->piece[i], *q = &w->piece[j];
    const struct rigid_block *a = &w->block[p->block], *b = &w->block[q->block];
    return p->low.x <= q->high.x && q->low.x <= p->high.x
        && p->low.y <= q->high.y && q->low.y <= p->high.y
        && p->block != q->block && (a->inv_mass > 0 || b->inv_mass > 0);
}

/* Lists the pairs in the order of their indices, which is that of the old
   list too: what it remembers is found by going along it. */
static inline void rigid_list(struct rigid_world *w)
{
    struct rigid_pair *old = w->pair;
    int olds = w->pairs, next = 0, room = w->pair_room;
    rigid_boxes(w);
    w->pair = w->old_pair;
    w->old_pair = old;
    w->pairs = 0;
    for (int i = 0; i < w->pieces; i++)
        for (int j = i + 1; j < w->pieces; j++) {
            struct rigid_pair *p;
            if (!rigid_boxes_meet(w, i, j))
                continue;
            p = rigid_room(w->pair, w->pairs, 1, &w->pair_room, sizeof *p);
            if (!p) {
                w->failed = 1;
                return;
            }
            w->pair = p;
            p += w->pairs++;
            while (
                next < olds
                && (old[next].a < i || (old[next].a == i && old[next].b < j)))
                next++;
            if (next < olds && old[next].a == i && old[next].b == j) {
                *p = old[next];
                continue;
            }
            memset(p, 0, sizeof *p);
            p->a = i;
            p->b = j;
        }
    /* Both lists have the same room. */
    if (w->pair_room > room) {
        old = realloc(w->old_pair, (size_t)w->pair_room * sizeof *old);
        if (old)
            w->old_pair = old;
        else
            w->failed = 1;
    }
    w->listed = 1;
}

/* ---- Contacts ------------------------------------------------------------ */

/* The edge of p that q is farthest outside of, and how far: the distance of
   the pieces along the normals of p. The middle of q lies inside q, so it
   bounds what an edge can give, and most edges need no more than that. */
static inline double rigid_apart(const struct rigid_world *w,
                                 const struct rigid_piece *p,
                                 const struct rigid_piece *q, int *edge)
{
    const struct rigid_corner *c = w->corner + p->first;
    const struct rigid_corner *d = w->corner + q->first;
    double best = -DBL_MAX;
    int first = *edge;
    for (int k = 0, i = first; k <= p->corners; i = k++) {
        const struct rigid_pt n = c[i].normal;
        const double from = rigid_dot(n, c[i].at);
        double least;
        if ((k > 0 && i == first) || rigid_dot(n, q->at) - from <= best)
            continue;
        least = rigid_dot(n, d[0].at);
        for (int j = 1; j < q->corners; j++) {
            double x = rigid_dot(n, d[j].at);
            least = x < least ? x : least;
        }
        if (least - from > best) {
            best = least - from;
            *edge = i;
        }
    }
    return best;
}

/* The edge of a piece whose normal is most opposed to n. */
static inline int rigid_opposed(const struct rigid_world *w,
                                const struct rigid_piece *p, struct rigid_pt n)
{
    const struct rigid_corner *c = w->corner + p->first;
    double best = rigid_dot(c[0].normal, n);
    int edge = 0;
    for (int i = 1; i < p->corners; i++) {
        double x = rigid_dot(c[i].normal, n);
        if (x >= best)
            continue;
        best = x;
        edge = i;
    }
    return edge;
}

/* Names a point by the corners that make it, that of a first. */
static inline int rigid_name(int p, int q, int flip)
{
    return flip ? q * 32768 + p : p * 32768 + q;
}

/* Adds the point at distance x along edge i of p, which piece q is `gap`
   away from, midway between both. */
static inline void rigid_touch_add(struct rigid_touch *t,
                                   const struct rigid_corner *from,
                                   struct rigid_pt n, double x, double gap,
                                   int id)
{
    int k = t->points++;
    t->at[k] = rigid_vec(from->at.x - n.y * x + n.x * gap / 2,
                         from->at.y + n.x * x + n.y * gap / 2);
    t->gap[k] = gap;
    t->id[k] = id;
}

/* Within which two corners are in one place. */
static inline double rigid_near(const struct rigid_world *w)
{
    return 0.1 * w->slop;
}

/* Two corners that face each other: the normal points from one to the other.
   In one place they do not touch: each can pass the other on either side, and
   any normal would forbid one of them. Once one has gone that way by a little,
   an edge is there to slide along. */
static inline void rigid_corners(const struct rigid_world *w,
                                 struct rigid_touch *t, struct rigid_pt p,
                                 struct rigid_pt q, int id)
{
    struct rigid_pt d = rigid_sub(q, p);
    double dist = rigid_length(d);
    if (dist > rigid_ahead(w))
        return;
    if (!(rigid_dot(d, t->n) > rigid_near(w)))
        return;
    t->n = rigid_vec(d.x / dist, d.y / dist);
    t->points = 1;
    t->at[0] = rigid_vec((p.x + q.x) / 2, (p.y + q.y) / 2);
    t->gap[0] = rigid_dot(d, t->n);
    t->id[0] = id;
}

/*  The edge of q that faces edge i of p is cut at the ends of that edge:

            q  \          /            The points that are left are the
                \________/             contact, if they are near enough.
          lower  |      :  upper
           ______|______:_
        p  i            i + 1                                              */
static inline void rigid_clip(const struct rigid_world *w,
                              const struct rigid_piece *p,
                              const struct rigid_piece *q, int i, int flip,
                              struct rigid_touch *t)
{
    const struct rigid_corner *c = w->corner + p->first;
    const struct rigid_corner *d = w->corner + q->first;
    const struct rigid_pt n = c[i].normal, from = c[i].at;
    int i2 = i + 1 < p->corners ? i + 1 : 0;
    int j = rigid_opposed(w, q, n), j2 = j + 1 < q->corners ? j + 1 : 0;
    struct rigid_pt e = rigid_sub(c[i2].at, from);
    struct rigid_pt u = rigid_sub(d[j].at, from), l = rigid_sub(d[j2].at, from);
    double length = rigid_cross(n, e), upper = rigid_cross(n, u);
    double lower = rigid_cross(n, l), low = rigid_dot(n, l);
    double up = rigid_dot(n, u), ahead = rigid_ahead(w), slope, x;
    double close = rigid_near(w);

    t->n = n;
    if (lower > length - close || upper < close || upper <= lower) {
        if (lower > length - close)
            rigid_corners(w, t, c[i2].at, d[j2].at, rigid_name(i2, j2, flip));
        else if (upper < close)
            rigid_corners(w, t, from, d[j].at, rigid_name(i, j, flip));
        return;
    }
    slope = (up - low) / (upper - lower);
    x = lower < 0 ? 0 : lower;
    if (low + slope * (x - lower) <= ahead)
        rigid_touch_add(t, &c[i], n, x, low + slope * (x - lower),
                        rigid_name(i, j2, flip));
    x = upper > length ? length : upper;
    if (up - slope * (upper - x) <= ahead)
        rigid_touch_add(t, &c[i], n, x, up - slope * (upper - x),
                        rigid_name(i2, j, flip));
}

/* Finds where the two pieces of a pair touch. The edge that they are farthest
   apart along carries the contact; the first piece's if there is little in
   it, so that it does not change all the time. */
static inline void rigid_meet(const struct rigid_world *w, struct rigid_pair *r,
                              struct rigid_touch *t)
{
    const struct rigid_piece *a = &w->piece[r->a], *b = &w->piece[r->b];
    double sa, sb, ahead = rigid_ahead(w);
    t->points = 0;
    sa = rigid_apart(w, a, b, &r->edge_a);
    if (sa > ahead)
        return;
    sb = rigid_apart(w, b, a, &r->edge_b);
    if (sb > ahead)
        return;
    if (sb <= sa + 0.1 * w->slop) {
        rigid_clip(w, a, b, r->edge_a, 0, t);
    } else {
        rigid_clip(w, b, a, r->edge_b, 1, t);
        t->n = rigid_vec(-t->n.x, -t->n.y);
    }
}

/* Makes what the solver needs of a touch, with the impulses of the points
   that were there already. */
static inline void rigid_prepare(struct rigid_world *w, int pair,
                                 const struct rigid_touch *t)
{
    const struct rigid_pair *r = &w->pair[pair];
    struct rigid_contact *c = &w->contact[w->contacts++];
    const struct rigid_pt n = t->n, s = {-n.y, n.x};
    c->a = w->piece[r->a].block;
    c->b = w->piece[r->b].block;
    c->pair = pair;
    c->points = t->points;
    c->n = n;
    const struct rigid_block *a = &w->block[c->a], *b = &w->block[c->b];
    c->driven = !(a->inv_mass > 0 && b->inv_mass > 0);
    for (int k = 0; k < t->points; k++) {
        struct rigid_point *p = &c->point[k];
        struct rigid_pt ra = rigid_sub(t->at[k], a->at);
        struct rigid_pt rb = rigid_sub(t->at[k], b->at);
        double ia = a->inv_inertia, ib = b->inv_inertia;
        double m = a->inv_mass + b->inv_mass;
        p->normal_a = rigid_cross(ra, n);
        p->normal_b = rigid_cross(rb, n);
        p->tangent_a = rigid_cross(ra, s);
        p->tangent_b = rigid_cross(rb, s);
        p->normal_mass = 1
                       / (m + ia * p->normal_a * p->normal_a
                          + ib * p->normal_b * p->normal_b);
        p->tangent_mass = 1
                        / (m + ia * p->tangent_a * p->tangent_a
                           + ib * p->tangent_b * p->tangent_b);
        p->gap = t->gap[k];
        p->normal = p->tangent = p->rest = 0;
        for (int i = 0; i < r->points; i++) {
            if (r->id[i] != t->id[k])
                continue;
            p->normal = r->normal[i];
            p->tangent = r->tangent[i];
            p->rest = r->rest[i];
            p->gap += p->rest;
        }
    }
}

/* Finds all contacts. */
static inline void rigid_collide(struct rigid_world *w)
{
    struct rigid_contact *room;
    w->contacts = 0;
    room = rigid_room(w->contact, 0, w->pairs, &w->contact_room, sizeof *room);
    if (!room) {
        w->failed = 1;
        return;
    }
    w->contact = room;
    for (int i = 0; i < w->pairs; i++) {
        struct rigid_pair *r = &w->pair[i];
        struct rigid_touch t;
        rigid_meet(w, r, &t);
        if (t.points > 0)
            rigid_prepare(w, i, &t);
        r->points = t.points;
        for (int k = 0; k < t.points; k++)
            r->id[k] = t.id[k];
    }
}

/* ---- The solver ---------------------------------------------------------- */

/* Gives an impulse to both blocks of a contact: n and s along the normal and
   the tangent, turn_a and turn_b their moments. */
static inline void rigid_impulse(struct rigid_block *a, struct rigid_block *b,
                                 struct rigid_pt normal, double n, double s,
                                 double turn_a, double turn_b)
{
    double x = normal.x * n - normal.y * s, y = normal.y * n + normal.x * s;
    a->v.x -= a->inv_mass * x;
    a->v.y -= a->inv_mass * y;
    a->spin -= a->inv_inertia * turn_a;
    b->v.x += b->inv_mass * x;
    b->v.y += b->inv_mass * y;
    b->spin += b->inv_inertia * turn_b;
}

/* Begins a sub-step with the impulses of the last one. */
static inline void rigid_warm(struct rigid_world *w)
{
    for (int i = 0; i < w->contacts; i++) {
        const struct rigid_contact *c = &w->contact[i];
        double n = 0, s = 0, turn_a = 0, turn_b = 0;
        for (int k = 0; k < c->points; k++) {
            const struct rigid_point *p = &c->point[k];
            n += p->normal;
            s += p->tangent;
            turn_a += p->normal_a * p->normal + p->tangent_a * p->tangent;
            turn_b += p->normal_b * p->normal + p->tangent_b * p->tangent;
        }
        rigid_impulse(&w->block[c->a], &w->block[c->b], c->n, n, s, turn_a,
                      turn_b);
    }
}

/* A spring as a constraint: of the overlap, how much speed; of the impulse
   that would stop the blocks, how much; of the one so far, how much back. */
struct rigid_spring {
    double bias, mass, back;
};

/* An eighth of the frequency of the sub-steps, a quarter where one of the
   blocks moves only as told. Twice as stiff, stones at rest begin to tremble
   and walk. */
static inline struct rigid_spring rigid_spring_at(const struct rigid_world *w,
                                                  double h, int driven)
{
    double omega = 2 * 3.14159265358979323846 * (driven ? 0.25 : 0.125) / h;
    double a = 2 * w->damping + h * omega, b = h * omega * a;
    struct rigid_spring s = {omega / a, b / (1 + b), 1 / (1 + b)};
    return s;
}

/* What two blocks have of speed and spin while one of their contacts is solved.
   Values here, and not in the blocks: the passes take most of the time. */
struct rigid_speeds {
    struct rigid_pt va, vb;
    double wa, wb, ma, mb, ia, ib; /* spins, inverse masses and inertias */
};

/* The impulse f along n, on the second block, against it on the first, with
   these arms. */
static inline void rigid_speeds_push(struct rigid_speeds *s, struct rigid_pt n,
                                     double arm_a, double arm_b, double f)
{
    const double x = n.x * f, y = n.y * f;
    s->wa -= s->ia * arm_a * f;
    s->wb += s->ib * arm_b * f;
    s->va = rigid_vec(s->va.x - s->ma * x, s->va.y - s->ma * y);
    s->vb = rigid_vec(s->vb.x + s->mb * x, s->vb.y + s->mb * y);
}

/* One pass over a contact. A gap may close within the sub-step but no faster;
   an overlap is pushed out if there is a spring, else just not allowed to
   grow. Then friction, within what the normal impulses allow. */
static inline void rigid_solve_one(struct rigid_world *w,
                                   struct rigid_contact *c, double per_second,
                                   const struct rigid_spring *spring)
{
    struct rigid_block *a = &w->block[c->a], *b = &w->block[c->b];
    const struct rigid_pt n = c->n, t = rigid_vec(-n.y, n.x);
    const double turned_a = a->turned, turned_b = b->turned;
    const double came = rigid_dot(n, rigid_sub(b->moved, a->moved));
    struct rigid_speeds s = {a->v,           b->v,          a->spin,
                             b->spin,        a->inv_mass,   b->inv_mass,
                             a->inv_inertia, b->inv_inertia};

    for (int k = 0; k < c->points; k++) {
        struct rigid_point *p = &c->point[k];
        double gap = p->gap + came + p->normal_b * turned_b
                   - p->normal_a * turned_a;
        double v = n.x * (s.vb.x - s.va.x) + n.y * (s.vb.y - s.va.y)
                 + p->normal_b * s.wb - p->normal_a * s.wa;
        double f;
        if (gap > 0 || !spring) {
            if (gap > 0)
                v += gap * per_second;
            f = p->normal - p->normal_mass * v;
        } else {
            double bias = spring->bias * gap;
            if (bias < -w->push)
                bias = -w->push;
            f = p->normal - p->normal_mass * spring->mass * (v + bias)
              - spring->back * p->normal;
        }
        f = f > 0 ? f : 0;
        rigid_speeds_push(&s, n, p->normal_a, p->normal_b, f - p->normal);
        p->normal = f;
    }
    for (int k = 0; k < c->points; k++) {
        struct rigid_point *p = &c->point[k];
        double v = n.x * (s.vb.y - s.va.y) - n.y * (s.vb.x - s.va.x)
                 + p->tangent_b * s.wb - p->tangent_a * s.wa;
        double most = w->friction * p->normal;
        double f = p->tangent - p->tangent_mass * v;
        f = f > most ? most : f < -most ? -most : f;
        rigid_speeds_push(&s, t, p->tangent_a, p->tangent_b, f - p->tangent);
        p->tangent = f;
    }
    a->v = s.va;
    b->v = s.vb;
    a->spin = s.wa;
    b->spin = s.wb;
}

/* One pass over all contacts. */
static inline void rigid_solve(struct rigid_world *w, double h, int springs)
{
    struct rigid_spring spring[2];
    spring[0] = rigid_spring_at(w, h, 0);
    spring[1] = rigid_spring_at(w, h, 1);
    for (int i = 0; i < w->contacts; i++) {
        struct rigid_contact *c = &w->contact[i];
        rigid_solve_one(w, c, 1 / h, springs ? &spring[c->driven] : NULL);
    }
}

static inline void rigid_push(struct rigid_world *w, double h)
{
    for (int i = 0; i < w->blocks; i++) {
        struct rigid_block *b = &w->block[i];
        if (!(b->inv_mass > 0))
            continue;
        b->v.x += h * (w->gravity.x + b->inv_mass * b->force.x);
        b->v.y += h * (w->gravity.y + b->inv_mass * b->force.y);
        b->spin += h * b->inv_inertia * b->torque;
    }
}

static inline void rigid_move(struct rigid_world *w, double h)
{
    for (int i = 0; i < w->blocks; i++) {
        struct rigid_block *b = &w->block[i];
        b->moved.x += h * b->v.x;
        b->moved.y += h * b->v.y;
        b->turned += h * b->spin;
    }
}

/* Ends the step: poses and impulses are written back. */
static inline void rigid_finish(struct rigid_world *w)
{
    for (int i = 0; i < w->blocks; i++) {
        struct rigid_block *b = &w->block[i];
        double t = b->turned, tt = t * t, length;
        struct rigid_pt q = {1 - tt / 2 + tt * tt / 24, t * (1 - tt / 6)};
        q = rigid_turned(b->turn, q);
        length = rigid_length(q);
        b->turn = rigid_vec(q.x / length, q.y / length);
        b->at.x += b->moved.x;
        b->at.y += b->moved.y;
        b->angle += t;
        b->moved = rigid_vec(0, 0);
        b->turned = 0;
    }
    for (int i = 0; i < w->contacts; i++) {
        const struct rigid_contact *c = &w->contact[i];
        for (int k = 0; k < c->points; k++) {
            w->pair[c->pair].normal[k] = c->point[k].normal;
            w->pair[c->pair].tangent[k] = c->point[k].tangent;
            w->pair[c->pair].rest[k] = c->point[k].rest;
        }
    }
}

static inline double rigid_kinetic(const struct rigid_world *w)
{
    double sum = 0;
    for (int i = 0; i < w->blocks; i++) {
        const struct rigid_block *b = &w->block[i];
        if (!(b->inv_mass > 0))
            continue;
        sum += rigid_dot(b->v, b->v) / (2 * b->inv_mass)
             + b->spin * b->spin / (2 * b->inv_inertia);
    }
    return sum;
}

/* The work that blocks which move only as told do in a sub-step. */
static inline double rigid_work(const struct rigid_world *w)
{
    double sum = 0;
    for (int i = 0; i < w->contacts; i++) {
        const struct rigid_contact *c = &w->contact[i];
        const struct rigid_block *a = &w->block[c->a], *b = &w->block[c->b];
        const struct rigid_block *told = a->inv_mass > 0 ? b : a;
        double sign = told == a ? 1 : -1;
        if (!c->driven)
            continue;
        for (int k = 0; k < c->points; k++) {
            const struct rigid_point *p = &c->point[k];
            double normal = told == a ? p->normal_a : p->normal_b;
            double tangent = told == a ? p->tangent_a : p->tangent_b;
            sum += sign * p->normal
                 * (rigid_dot(told->v, c->n) + told->spin * normal);
            sum += sign * p->tangent
                 * (rigid_cross(c->n, told->v) + told->spin * tangent);
        }
    }
    return sum;
}

/* After a blow the impulses of the last sub-step are wrong for the next, and
   one pass does not take all of them back: goes on until they do not add
   energy. */
static inline void rigid_relax(struct rigid_world *w, double h, double energy)
{
    enum { PASSES = 30 };
    rigid_solve(w, h, 0);
    for (int i = 0; i < PASSES; i++) {
        if (rigid_kinetic(w) - rigid_work(w) <= energy)
            return;
        rigid_solve(w, h, 0);
    }
}

/* Goes on by one step. Returns -1 where memory was lacking, else 0. */
static inline int rigid_step(struct rigid_world *w)
{
    double h = w->step / w->substeps;
    rigid_place(w);
    if (!w->listed || rigid_strayed(w))
        rigid_list(w);
    if (!w->failed)
        rigid_collide(w);
    if (w->failed)
        return -1;
    for (int i = 0; i < w->substeps; i++) {
        double energy;
        rigid_push(w, h);
        energy = rigid_kinetic(w);
        rigid_warm(w);
        rigid_solve(w, h, 1);
        rigid_move(w, h);
        rigid_relax(w, h, energy);
    }
    rigid_finish(w);
    return 0;
}

/* One pass over the contacts, and the blocks stopped again. Returns how fast
   the fastest would have gone. */
static inline double rigid_settle_pass(struct rigid_world *w, double h)
{
    double fast = 0;
    rigid_push(w, h);
    rigid_warm(w);
    rigid_solve(w, h, 0);
    for (int i = 0; i < w->blocks; i++) {
        struct rigid_block *b = &w->block[i];
        fast = rigid_most(fast, fabs(b->v.x) + fabs(b->v.y)
                                    + b->reach * fabs(b->spin));
        b->v = rigid_vec(0, 0);
        b->spin = 0;
    }
    return fast;
}

/* For blocks that are at rest where they are: finds the impulses that hold
   them, without which a stack sags until it knows its weights, and takes the
   gap of every point that carries load for the one at which its spring does
   so. Returns -1 where memory was lacking. */
static inline int rigid_settle(struct rigid_world *w)
{
    enum { PASSES = 20000 };
    double h = w->step / w->substeps;
    double small = 1e-8 * h * rigid_length(w->gravity);
    w->pairs = 0;
    rigid_place(w);
    rigid_list(w);
    if (!w->failed)
        rigid_collide(w);
    if (w->failed)
        return -1;
    for (int i = 0; i < PASSES && rigid_settle_pass(w, h) > small; i++)
        ;
    for (int i = 0; i < w->contacts; i++) {
        struct rigid_contact *c = &w->contact[i];
        struct rigid_spring s = rigid_spring_at(w, h, c->driven);
        for (int k = 0; k < c->points; k++) {
            struct rigid_point *p = &c->point[k];
            if (p->normal > 0)
                p->rest = -s.back * p->normal
                            / (s.bias * s.mass * p->normal_mass)
                        - p->gap;
        }
    }
    rigid_finish(w);
    return 0;
}

/* Kinetic energy and that of the place in the field of gravity. */
static inline double rigid_energy(const struct rigid_world *w)
{
    double sum = rigid_kinetic(w);
    for (int i = 0; i < w->blocks; i++) {
        const struct rigid_block *b = &w->block[i];
        if (b->inv_mass > 0)
            sum -= rigid_dot(w->gravity, b->at) / b->inv_mass;
    }
    return sum;
}

#endif /* RIGID_H */
