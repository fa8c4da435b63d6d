/* outlines.h - from the shapes of a drawing or a photograph to the statements of
   text.h.

       open paths    that meet become outlines (lines.h); the rest is skipped
       outlines      of a photograph are simplified; one that crosses itself is
                     mended where a loop is smaller than the outline may be off,
                     or where one corner stands in the wrong place; otherwise it
                     is skipped by name
       parts         of one stone are joined where they touch; those that are
                     apart are stones of their own, and named
       nested        an outline around others is a frame, one inside another a
                     hole; both are skipped by name
       ground        what a label makes it; or a line that the user draws, below
                     which outlines are cut; or else the lowest outlines
       fill          is no stone: its weight lies on the stones right below it
       suspicious    blocks that touch nothing fixed, and one stone as large as
                     many that touches many: named in the notes

   SPDX-License-Identifier: MIT */

#ifndef OUTLINES_H
#define OUTLINES_H

#include "lines.h"
#include "shapes.h"

enum {
    OUTLINES_MOST = 20000, /* that are read: as many as kern analyses     */
    OUTLINES_MEND = 2000,  /* points of an outline that is mended         */
    OUTLINES_MOVE = 200,   /* of one whose corner is moved                */
    OUTLINES_TRIES = 64,   /* seams between two parts                     */
    OUTLINES_SAMPLES = 32, /* of a new edge                              */
    OUTLINES_ON_ARC = 64,  /* corners of others on a chord                */
    OUTLINES_NAMED = 4     /* names in a note                             */
};

#define OUTLINES_FARTHEST 1e15 /* m: what is drawn there is no stone */

/* The measures of a block that is written. */
struct outlines_block {
    int path, name; /* name: offset of a word                         */
    int root, touches;
    double left, right, low, high, size;
    double mass, mass_x, mass_y; /* of the fill on it                  */
    int idle;                    /* nonzero: fill that lies on no stone */
    int pushes;                  /* nonzero: fill that is a statement   */
    int counted;                 /* nonzero: fill whose weight is there */
    double misfit; /* share of such a fill that is not as drawn          */
};

struct outlines {
    struct shapes *s;
    struct outlines_block *block;
    int blocks;
    double size;   /* of blocks, in the mean                             */
    double exact;  /* standard error of a photograph's outlines, or 0    */
    int mended;    /* outlines                                           */
    int mended_at; /* the first one                                     */
};

static struct shapes_point *outlines_points(const struct shapes *s,
                                            const struct shapes_path *p)
{
    return s->point + p->first;
}

/* Returns the length of the diagonal of the box around n points. */
static double outlines_extent(const struct shapes_point *p, int n)
{
    struct shapes_point low = p[0], high = p[0];
    lines_box(p, n, 1, &low, &high);
    return shapes_distance(low, high);
}

/* ---- One outline ---------------------------------------------------------- */

/* Returns after how many of its n points a path comes back to where it began
   and then only repeats its own edges. Returns 0 where it does not. */
static int outlines_ring(const struct shapes_point *p, int n)
{
    for (int m = 3; m < n; m++) {
        int i = m;
        while (i < n
               && shapes_distance(p[i - m], p[i])
                      <= 1e-6 * shapes_distance(p[i - m], p[i - m + 1]))
            i++;
        if (i == n)
            return m;
    }
    return 0;
}

/* Marks open paths that come back to their beginning as closed. */
static void outlines_close(struct shapes *s)
{
    for (int i = 0; i < s->paths; i++) {
        struct shapes_path *p = s->path + i;
        const int ring = outlines_ring(outlines_points(s, p), p->points);
        if (ring == 0)
            continue;
        p->points = ring;
        p->closed = 1;
    }
}

/* Takes away points that repeat their neighbour, and spikes without area. */
static void outlines_clean(struct shapes *s, struct shapes_path *path)
{
    struct shapes_point *p = outlines_points(s, path);
    const double size = outlines_extent(p, path->points);
    int n = path->points, before;
    do {
        int to = 0;
        before = n;
        for (int i = 0; i < n; i++) {
            const struct shapes_point a = p[to > 0 ? to - 1 : n - 1], b = p[i];
            const struct shapes_point c = p[i + 1 < n ? i + 1 : 0];
            const double cross = (b.x - a.x) * (c.y - b.y)
                               - (b.y - a.y) * (c.x - b.x);
            const double dot = (b.x - a.x) * (c.x - b.x)
                             + (b.y - a.y) * (c.y - b.y);
            if (shapes_distance(a, b) <= 1e-6 * size && n - i + to > 1)
                continue;
            if (shapes_abs(cross) <= 1e-12 * size * size && dot < 0)
                continue;
            p[to++] = b;
        }
        n = to;
    } while (n < before && n > 2);
    path->points = n;
}

/* The box of an outline, and its area: 0 of what is no stone. */
struct outlines_box {
    struct shapes_point low, high;
    double area;
};

static struct outlines_box outlines_box(const struct shapes *s, int i)
{
    const struct shapes_path *path = s->path + i;
    const struct shapes_point *p = outlines_points(s, path);
    struct outlines_box box = {{0, 0, 0}, {0, 0, 0}, 0};
    lines_box(p, path->points, 1, &box.low, &box.high);
    if (!path->gone && path->closed && path->role != SHAPES_FILL)
        box.area = shapes_abs(lines_area(p, path->points)) / 2;
    return box;
}

/* Returns 1 if two boxes are within a distance. */
static int outlines_close_by(const struct outlines_box *a,
                             const struct outlines_box *b, double distance)
{
    return a->low.x <= b->high.x + distance && b->low.x <= a->high.x + distance
        && a->low.y <= b->high.y + distance && b->low.y <= a->high.y + distance;
}

/* Lists the outlines around outline i. Writes half the default gap of the
   smallest of them and itself to *slack: by so much it may be off. */
static int outlines_around(const struct shapes *s,
                           const struct outlines_box *box, int i, int *out,
                           double *slack)
{
    double least = box[i].area;
    int n = 0;
    for (int j = 0; j < s->paths; j++) {
        if (j == i || !(box[j].area > 0)
            || !outlines_close_by(
                box + i, box + j,
                1e-3 * shapes_distance(box[j].low, box[j].high)))
            continue;
        least = !(least > 0) || box[j].area < least ? box[j].area : least;
        out[n++] = j;
    }
    *slack = 0.5e-3 * SHAPES_SQRT(least);
    return n;
}

/* Finds the corners of other outlines that lie on an arc, between the ends of
   its chord. Returns how many. */
static int outlines_on_arc(const struct shapes *s, struct lines_piece piece,
                           const int *around, int arounds, double slack,
                           struct lines_cut *cut, int room)
{
    int n = 0;
    for (int j = 0; j < arounds; j++) {
        const struct shapes_path *other = s->path + around[j];
        const struct shapes_point *q = outlines_points(s, other);
        for (int v = 0; v < other->points && n < room; v++) {
            const double away = lines_away(&piece, q[v], &cut[n].share);
            cut[n].at = q[v];
            n += away >= 0 && away <= slack
              && shapes_distance(q[v], piece.a) > slack
              && shapes_distance(q[v], piece.b) > slack;
        }
    }
    return n;
}

/* Gives an outline the corners of others around it that lie on its arcs, so that
   stones on one arc do not overlap by what chords are off. */
static void outlines_conform(struct shapes *s, int i, const int *around,
                             int arounds, double slack)
{
    const struct shapes_path path = s->path[i];
    const int first = s->points;
    struct lines_cut cut[OUTLINES_ON_ARC];
    double key[OUTLINES_ON_ARC];
    int index[OUTLINES_ON_ARC], added = 0;
    for (int k = 0; k < path.points && !s->lost; k++) {
        struct lines_piece piece;
        int n = 0;
        piece.a = s->point[path.first + k];
        piece.b = s->point[path.first + (k + 1 < path.points ? k + 1 : 0)];
        piece.path = i;
        if (piece.a.bulge < 0 || piece.a.bulge > 0)
            n = outlines_on_arc(s, piece, around, arounds, slack, cut,
                                OUTLINES_ON_ARC - 1);
        for (int c = 0; c < n; c++) {
            key[c] = cut[c].share;
            index[c] = c;
        }
        lines_sort(index, n, key);
        shapes_point(s, piece.a.x, piece.a.y, piece.a.bulge);
        for (int c = 0; c < n; c++)
            shapes_point(s, cut[index[c]].at.x, cut[index[c]].at.y, 0);
        added += n;
    }
    if (added > 0 && !s->lost) {
        s->path[i].first = first;
        s->path[i].points = s->points - first;
    } else
        s->points = first;
}

/* Simplifies an outline by kern_outline_simplify(): within the tolerance, or
   where that is 0 within half the default gap of the smallest block there, so that
   steps of a rounding are no shear keys. An outline that is no polygon yet, or
   would be none, stays as it is. */
static void outlines_simplify(struct shapes *s, struct shapes_path *path,
                              double tolerance)
{
    struct shapes_point *p = outlines_points(s, path);
    const int n = path->points;
    kern_vec *raw = shapes_array(s, n, sizeof *raw);
    kern_vec *simple = shapes_array(s, n, sizeof *simple);
    int *kept = shapes_array(s, n, sizeof *kept);
    int count = 0;
    for (int i = 0; raw && i < n; i++) {
        raw[i].x = (kern_real)p[i].x;
        raw[i].y = (kern_real)p[i].y;
    }
    if (raw && simple && kept)
        count = kern_outline_simplify(raw, n, (kern_real)tolerance, simple,
                                      kept, n);
    for (int i = 0; i < count; i++) {
        p[i].x = (double)simple[i].x;
        p[i].y = (double)simple[i].y;
        p[i].bulge = 0;
    }
    if (count > 0)
        path->points = count;
    free(raw);
    free(simple);
    free(kept);
}

/* Returns 1 if two outlines are the same to the last digit, as stones or as
   fill. */
static int outlines_same(const struct shapes *s, const struct shapes_path *a,
                         const struct shapes_path *b)
{
    const size_t bytes = (size_t)a->points * sizeof *s->point;
    return a->points == b->points && a->role == b->role && a->group == b->group
        && memcmp(outlines_points(s, a), outlines_points(s, b), bytes) == 0;
}

/* Lists outlines that are drawn twice to the last digit, but for the first of
   them. They are sorted by a sum of their corners, since comparing each with each
   would take the square of their number. Returns how many outlines are left. */
static int outlines_repeated(struct shapes *s)
{
    double *key = shapes_array(s, s->paths, sizeof *key);
    int *index = shapes_array(s, s->paths, sizeof *index), n = 0, left = 0;
    for (int i = 0; key && index && i < s->paths; i++) {
        const struct shapes_point *p = outlines_points(s, s->path + i);
        if (s->path[i].gone)
            continue;
        for (int k = 0; k < s->path[i].points; k++)
            key[i] += p[k].x + 3 * p[k].y + (p[k].x + p[k].y) * k;
        index[n++] = i;
    }
    if (n > 0)
        lines_sort(index, n, key);
    for (int from = 0, to; from < n; from = to) {
        int first = index[from];
        for (to = from; to < n && !(key[index[to]] > key[index[from]]); to++)
            first = index[to] < first ? index[to] : first;
        for (int k = from; k < to; k++) {
            struct shapes_path *path = s->path + index[k];
            if (index[k] != first && outlines_same(s, s->path + first, path))
                shapes_leave(s, path, "outline drawn twice");
            left += !path->gone;
        }
    }
    free(key);
    free(index);
    return left;
}

/* Gives outlines on one arc the same corners, and simplifies them: within `off`,
   or where that is 0 within what the smallest outline around each may be off. */
static void outlines_prepare(struct shapes *s, double off)
{
    struct outlines_box *box = shapes_array(s, s->paths, sizeof *box);
    int *around = shapes_array(s, s->paths, sizeof *around);
    double *slack = shapes_array(s, s->paths, sizeof *slack);
    for (int i = 0; box && i < s->paths; i++)
        box[i] = outlines_box(s, i);
    for (int i = 0; box && around && slack && i < s->paths; i++)
        if (!s->path[i].gone && !(off > 0)) {
            const int n = outlines_around(s, box, i, around, slack + i);
            outlines_conform(s, i, around, n, slack[i]);
        }
    for (int i = 0; slack && i < s->paths && !s->lost; i++)
        if (!s->path[i].gone)
            outlines_simplify(s, s->path + i, off > 0 ? off : slack[i]);
    free(box);
    free(around);
    free(slack);
}

/* Returns what kern_block_init() says of a polygon, of density 1. */
static kern_status outlines_status(struct shapes *s,
                                   const struct shapes_point *p, int n)
{
    kern_vec *vertex = shapes_array(s, n, sizeof *vertex);
    kern_status status = KERN_NO_SPACE;
    kern_block block;
    for (int i = 0; vertex && i < n; i++) {
        if (!(shapes_abs(p[i].x) < OUTLINES_FARTHEST
              && shapes_abs(p[i].y) < OUTLINES_FARTHEST)) {
            free(vertex);
            return KERN_BAD_NUMBER;
        }
        vertex[i].x = (kern_real)p[i].x;
        vertex[i].y = (kern_real)p[i].y;
    }
    if (vertex)
        status = kern_block_init(&block, vertex, n, 1, NULL);
    free(vertex);
    return status;
}

/* ---- Mending -------------------------------------------------------------- */

/* Returns 1 if two edges share a point, which is written to `at`. */
static int outlines_meet(struct shapes_point a, struct shapes_point b,
                         struct shapes_point c, struct shapes_point d,
                         struct shapes_point *at)
{
    const double ux = b.x - a.x, uy = b.y - a.y, vx = d.x - c.x;
    const double vy = d.y - c.y, x = c.x - a.x, y = c.y - a.y;
    const double cross = ux * vy - uy * vx;
    double s, t;
    if (!(cross < 0 || cross > 0)) {
        const double whole = ux * ux + uy * uy;
        s = (x * ux + y * uy) / whole;
        *at = c;
        return !(x * uy - y * ux < 0 || x * uy - y * ux > 0) && s >= 0
            && s <= 1;
    }
    s = (x * vy - y * vx) / cross;
    t = (x * uy - y * ux) / cross;
    *at = a;
    at->x += s * ux;
    at->y += s * uy;
    return s >= 0 && s <= 1 && t >= 0 && t <= 1;
}

/* Finds the first two edges of an outline that meet without being neighbours.
   Returns 0 where there are none. */
static int outlines_crossing(const struct shapes_point *p, int n, int *first,
                             int *second, struct shapes_point *at)
{
    for (int i = 0; i < n; i++)
        for (int j = i + 2; j < n; j++) {
            if (i == 0 && j == n - 1)
                continue;
            if (outlines_meet(p[i], p[i + 1], p[j], p[j + 1 < n ? j + 1 : 0],
                              at)) {
                *first = i;
                *second = j;
                return 1;
            }
        }
    return 0;
}

/* Cuts loops that are no larger than `reach`. Returns 1 if the outline then is
   simple. */
static int outlines_unloop(struct shapes *s, struct shapes_path *path,
                           double reach)
{
    struct shapes_point *p = outlines_points(s, path), at;
    int i, j;
    for (int round = 0; round < 100 && path->points > 3; round++) {
        int n = path->points;
        if (!outlines_crossing(p, n, &i, &j, &at))
            break;
        if (outlines_extent(p + i + 1, j - i) <= reach) {
            p[i + 1] = at;
            memmove(p + i + 2, p + j + 1, (size_t)(n - j - 1) * sizeof *p);
            path->points = n - (j - i) + 1;
        } else {
            struct shapes_point *rest = shapes_array(s, n, sizeof *rest);
            int m = 0;
            for (int k = j + 1; rest && k < n; k++)
                rest[m++] = p[k];
            for (int k = 0; rest && k <= i; k++)
                rest[m++] = p[k];
            const int tiny = rest && outlines_extent(rest, m) <= reach;
            free(rest);
            if (!tiny)
                break;
            memmove(p, p + i + 1, (size_t)(j - i) * sizeof *p);
            p[j - i] = at;
            path->points = j - i + 1;
        }
        outlines_clean(s, path);
    }
    return path->points > 2 && outlines_status(s, p, path->points) == KERN_OK;
}

/* Moves point `from` to place `to` of a copy. */
static void outlines_move(const struct shapes_point *p, int n, int from, int to,
                          struct shapes_point *out)
{
    int k = 0;
    for (int i = 0; i < n; i++) {
        if (i == from)
            continue;
        out[k++] = p[i];
        if (i == to)
            out[k++] = p[from];
    }
}

static double outlines_perimeter(const struct shapes_point *p, int n)
{
    double sum = 0;
    for (int i = 0; i < n; i++)
        sum += shapes_distance(p[i], p[i + 1 < n ? i + 1 : 0]);
    return sum;
}

/* Puts one corner of a crossing in another place, where the outline is simple
   and shortest. Returns 0 where there is none. */
static int outlines_reorder(struct shapes *s, struct shapes_path *path)
{
    struct shapes_point *p = outlines_points(s, path), at, *copy, *best;
    const int n = path->points;
    double least = 0;
    int i, j, found = 0;
    if (n > OUTLINES_MOVE || !outlines_crossing(p, n, &i, &j, &at))
        return 0;
    copy = shapes_array(s, n, sizeof *copy);
    best = shapes_array(s, n, sizeof *best);
    for (int k = 0; copy && best && k < 4; k++) {
        const int from = ((k < 2 ? i : j) + k % 2) % n;
        for (int to = 0; to < n; to++) {
            double length;
            if (to == from)
                continue;
            outlines_move(p, n, from, to, copy);
            length = outlines_perimeter(copy, n);
            if ((found && !(length < least))
                || outlines_status(s, copy, n) != KERN_OK)
                continue;
            found = 1;
            least = length;
            memcpy(best, copy, (size_t)n * sizeof *best);
        }
    }
    if (found)
        memcpy(p, best, (size_t)n * sizeof *best);
    free(copy);
    free(best);
    return found;
}

/* Returns 1 if the outline is one, or could be mended: otherwise it is listed. */
static int outlines_mend(struct outlines *o, int i, double reach)
{
    struct shapes *s = o->s;
    struct shapes_path *path = s->path + i;
    kern_status status;
    outlines_clean(s, path);
    if (path->points < 3) {
        shapes_leave(s, path, "outline without area");
        return 0;
    }
    status = outlines_status(s, outlines_points(s, path), path->points);
    if (status == KERN_OK)
        return 1;
    if (status == KERN_CROSSING && path->points <= OUTLINES_MEND) {
        const double extent = outlines_extent(outlines_points(s, path),
                                              path->points);
        if (outlines_unloop(s, path, reach > 0 ? reach : 1e-3 * extent)
            || outlines_reorder(s, path)) {
            if (o->mended++ == 0)
                o->mended_at = i;
            return 1;
        }
    }
    shapes_leave(s, path,
                 status == KERN_CROSSING ? "outline that crosses itself"
                 : status == KERN_BAD_NUMBER || status == KERN_BAD_MASS
                     ? "outline too large or too far away"
                     : "outline without area");
    return 0;
}

/* ---- Parts of one stone --------------------------------------------------- */

static void outlines_orient(struct shapes_point *p, int n)
{
    if (!(lines_area(p, n) < 0))
        return;
    for (int i = 0; i < n / 2; i++) {
        const struct shapes_point q = p[i];
        p[i] = p[n - 1 - i];
        p[n - 1 - i] = q;
    }
}

/* Writes both outlines as one, with edge i of the first and j of the second
   opened. Returns the number of its points. */
static int outlines_bridge(const struct shapes_point *p, int n, int i,
                           const struct shapes_point *q, int m, int j,
                           struct shapes_point *out)
{
    int k = 0;
    for (int a = 0; a < n; a++)
        out[k++] = p[(i + 1 + a) % n];
    for (int b = 0; b < m; b++)
        out[k++] = q[(j + 1 + b) % m];
    return k;
}

/* Returns how far a point is from the straight way from a to b. */
static double outlines_off(struct shapes_point a, struct shapes_point b,
                           struct shapes_point q)
{
    const double x = b.x - a.x, y = b.y - a.y, whole = x * x + y * y;
    double share = whole > 0 ? ((q.x - a.x) * x + (q.y - a.y) * y) / whole : 0;
    share = share < 0 ? 0 : share > 1 ? 1 : share;
    a.x += share * x;
    a.y += share * y;
    return shapes_distance(a, q);
}

/* Returns 1 if a point is inside an outline, or that near to it. */
static int outlines_holds(const struct shapes_point *p, int n,
                          struct shapes_point q, double snap)
{
    if (lines_inside(p, n, q))
        return 1;
    for (int i = 0; i < n; i++)
        if (outlines_off(p[i], p[i + 1 < n ? i + 1 : 0], q) <= snap)
            return 1;
    return 0;
}

/* Two edges that may be opened to join the outlines of two parts, and what that
   costs: the area between them, and the new edges times the reach. */
struct outlines_seam {
    int i, j;
    double cost;
};

static double outlines_cost(const struct shapes_point *p, int n, int i,
                            const struct shapes_point *q, int m, int j,
                            double reach)
{
    const struct shapes_point quad[4] = {p[i], q[(j + 1) % m], q[j],
                                         p[(i + 1) % n]};
    return shapes_abs(lines_area(quad, 4)) / 2
         + reach
               * (shapes_distance(quad[0], quad[1])
                  + shapes_distance(quad[2], quad[3]));
}

/* Finds the cheapest seam after another one. Returns 0 where there is none. */
static int outlines_next_seam(const struct shapes_point *p, int n,
                              const struct shapes_point *q, int m, double reach,
                              struct outlines_seam *seam)
{
    const struct outlines_seam last = *seam;
    int found = 0;
    for (int i = 0; i < n; i++)
        for (int j = 0; j < m; j++) {
            const double cost = outlines_cost(p, n, i, q, m, j, reach);
            if (cost < last.cost || (found && !(cost < seam->cost))
                || (!(cost > last.cost)
                    && (i < last.i || (i == last.i && j <= last.j))))
                continue;
            seam->i = i;
            seam->j = j;
            seam->cost = cost;
            found = 1;
        }
    return found;
}

/* Returns 1 if the straight way from a to b lies in one of two outlines, or
   nowhere farther from them than the reach. */
static int outlines_follows(struct shapes_point a, struct shapes_point b,
                            const struct shapes_point *p, int n,
                            const struct shapes_point *q, int m, double reach)
{
    for (int k = 1; k < OUTLINES_SAMPLES; k++) {
        struct shapes_point at = a;
        at.x += (b.x - a.x) * k / OUTLINES_SAMPLES;
        at.y += (b.y - a.y) * k / OUTLINES_SAMPLES;
        if (!outlines_holds(p, n, at, reach)
            && !outlines_holds(q, m, at, reach))
            return 0;
    }
    return 1;
}

/* Adds both outlines as one to the points. Returns 0 where that is no simple
   outline. */
static int outlines_sewn(struct outlines *o, const struct shapes_point *out,
                         double reach, struct shapes_path *whole)
{
    struct shapes *s = o->s;
    whole->first = s->points;
    for (int i = 0; i < whole->points; i++)
        shapes_point(s, out[i].x, out[i].y, 0);
    if (s->lost)
        return 0;
    outlines_clean(s, whole);
    if (whole->points > 2
        && (outlines_status(s, outlines_points(s, whole), whole->points)
                == KERN_OK
            || outlines_unloop(s, whole, reach)))
        return 1;
    s->points = whole->first;
    return 0;
}

/* Joins outline b to outline a where they touch: each may be off by the reach,
   and nothing farther than that from both becomes stone. Returns 0 where they do
   not touch, or no seam makes a simple outline. */
static int outlines_unite(struct outlines *o, int a, int b, double reach)
{
    struct shapes *s = o->s;
    const int n = s->path[a].points, m = s->path[b].points;
    struct outlines_seam seam = {-1, -1, -1};
    struct outlines_box box[2];
    struct shapes_point *out;
    int done = 0;
    box[0] = outlines_box(s, a);
    box[1] = outlines_box(s, b);
    if (!outlines_close_by(box, box + 1, 2 * reach))
        return 0;
    out = shapes_array(s, n + m, sizeof *out);
    for (int k = 0; out && k < OUTLINES_TRIES && !done && !s->lost; k++) {
        const struct shapes_point *p = s->point + s->path[a].first;
        const struct shapes_point *q = s->point + s->path[b].first;
        struct shapes_path whole = s->path[a];
        if (!outlines_next_seam(p, n, q, m, reach, &seam))
            break;
        if (!outlines_follows(p[seam.i], q[(seam.j + 1) % m], p, n, q, m, reach)
            || !outlines_follows(q[seam.j], p[(seam.i + 1) % n], p, n, q, m,
                                 reach))
            continue;
        whole.points = outlines_bridge(p, n, seam.i, q, m, seam.j, out);
        done = outlines_sewn(o, out, reach, &whole);
        if (done)
            s->path[a] = whole;
    }
    free(out);
    return done;
}

/* Joins two parts of a stone if they touch; a part inside another is a hole of
   it. Returns 1 where one of them is gone. */
static int outlines_join_two(struct outlines *o, int a, int b, double reach)
{
    struct shapes *s = o->s;
    struct shapes_path *q = s->path + a, *p = s->path + b;
    if (lines_inside(outlines_points(s, q), q->points,
                     lines_inner(outlines_points(s, p), p->points)))
        shapes_leave(s, p, "hole");
    else if (lines_inside(outlines_points(s, p), p->points,
                          lines_inner(outlines_points(s, q), q->points)))
        shapes_leave(s, q, "hole");
    else if ((double)p->points * q->points <= 4e6
             && outlines_unite(o, a, b, reach))
        s->path[b].gone = 1;
    return s->path[a].gone || s->path[b].gone;
}

/* Joins the parts of a stone that touch, until none of them do: the first one,
   and of each the next one. */
static void outlines_join_all(struct outlines *o, int first, const int *next,
                              double reach)
{
    const struct shapes *s = o->s;
    for (int again = 1; again && !s->lost;) {
        again = 0;
        for (int i = first; i >= 0; i = next[i])
            for (int j = next[i]; j >= 0 && !s->path[i].gone; j = next[j])
                if (!s->path[j].gone)
                    again |= outlines_join_two(o, i, j, reach);
    }
}

/* Joins the parts of each stone that touch. Parts that are apart stay stones of
   their own. */
static void outlines_join(struct outlines *o, double reach)
{
    struct shapes *s = o->s;
    int *head = shapes_array(s, s->groups, sizeof *head);
    int *next = shapes_array(s, s->paths, sizeof *next);
    for (int g = 0; head && g < s->groups; g++)
        head[g] = -1;
    for (int i = s->paths - 1; head && next && i >= 0; i--) {
        struct shapes_path *p = s->path + i;
        if (p->group < 0 || p->gone || !p->closed)
            continue;
        outlines_orient(outlines_points(s, p), p->points);
        next[i] = head[p->group];
        head[p->group] = i;
    }
    for (int g = 0; head && next && g < s->groups; g++)
        outlines_join_all(o, head[g], next, reach);
    free(head);
    free(next);
}

/* ---- One outline in another ----------------------------------------------- */

static int outlines_within(const struct outlines *o,
                           const struct outlines_block *outer,
                           const struct outlines_block *inner)
{
    const struct shapes *s = o->s;
    const struct shapes_path *a = s->path + outer->path;
    const struct shapes_path *b = s->path + inner->path;
    const struct shapes_point *p = outlines_points(s, a);
    const struct shapes_point *q = outlines_points(s, b);
    const double snap = 1e-3 * inner->size;
    if (inner->left < outer->left - snap || inner->right > outer->right + snap
        || inner->low < outer->low - snap || inner->high > outer->high + snap
        || b->area > a->area * (1 + 1e-9)
        || !lines_inside(p, a->points, lines_inner(q, b->points)))
        return 0;
    for (int i = 0; i < b->points; i++)
        if (!outlines_holds(p, a->points, q[i], snap))
            return 0;
    return 1;
}

/* Returns 1 if a block is looked at: it is not gone, and no fill. */
static int outlines_nests(const struct outlines *o, int i)
{
    const struct shapes_path *path = o->s->path + o->block[i].path;
    return !path->gone && path->role != SHAPES_FILL;
}

/* Marks what lies in outline i, less what is drawn twice, which is listed: how
   many there are, how many others, and their area. */
static int outlines_contents(struct outlines *o, int i, char *in, int *others,
                             double *area)
{
    struct shapes *s = o->s;
    const struct shapes_path *a = s->path + o->block[i].path;
    int found = 0;
    *others = 0;
    *area = 0;
    for (int j = 0; j < o->blocks; j++) {
        struct shapes_path *b = s->path + o->block[j].path;
        in[j] = 0;
        if (j == i || !outlines_nests(o, j))
            continue;
        ++*others;
        if (!outlines_within(o, o->block + i, o->block + j))
            continue;
        if (b->area > 0.999 * a->area) {
            shapes_leave(s, b, "outline drawn twice");
            --*others;
            continue;
        }
        in[j] = 1;
        *area += b->area;
        found++;
    }
    return found;
}

/* Lists what is drawn twice of fill i. */
static void outlines_repeat(struct outlines *o, int i)
{
    struct shapes *s = o->s;
    const struct shapes_path *a = s->path + o->block[i].path;
    for (int j = i + 1; j < o->blocks && !a->gone; j++) {
        struct shapes_path *b = s->path + o->block[j].path;
        if (!b->gone && b->role == SHAPES_FILL && b->area > 0.999 * a->area
            && a->area > 0.999 * b->area
            && outlines_within(o, o->block + i, o->block + j))
            shapes_leave(s, b, "outline drawn twice");
    }
}

/* Lists outlines that are drawn twice, frames, and holes. */
static void outlines_nest(struct outlines *o)
{
    struct shapes *s = o->s;
    char *in = shapes_array(s, o->blocks, sizeof *in);
    for (int i = 0; in && i < o->blocks; i++) {
        struct shapes_path *a = s->path + o->block[i].path;
        double area;
        int others;
        if (a->role == SHAPES_FILL)
            outlines_repeat(o, i);
        if (!outlines_nests(o, i))
            continue;
        const int found = outlines_contents(o, i, in, &others, &area);
        if (found > 1 && (found == others || area > a->area / 2)) {
            shapes_leave(s, a, "outline around others");
            continue;
        }
        for (int j = 0; j < o->blocks && found > 0; j++)
            if (in[j])
                shapes_leave(s, s->path + o->block[j].path, "hole");
    }
    free(in);
}

/* ---- Blocks --------------------------------------------------------------- */

static void outlines_measure(struct outlines *o, struct outlines_block *b)
{
    const struct shapes_path *path = o->s->path + b->path;
    struct shapes_point low = {0, 0, 0}, high = {0, 0, 0};
    lines_box(outlines_points(o->s, path), path->points, 1, &low, &high);
    b->left = low.x;
    b->low = low.y;
    b->right = high.x;
    b->high = high.y;
    b->size = SHAPES_SQRT(path->area);
}

/* Lists the outlines that are left, in the order of their lines. */
static void outlines_list(struct outlines *o)
{
    struct shapes *s = o->s;
    int *index = shapes_array(s, s->paths, sizeof *index), n = 0;
    double *key = shapes_array(s, s->paths, sizeof *key);
    free(o->block);
    o->block = shapes_array(s, s->paths, sizeof *o->block);
    o->blocks = 0;
    o->size = 0;
    for (int i = 0; index && key && i < s->paths; i++) {
        key[i] = s->path[i].line + 1e-9 * i;
        if (s->path[i].closed && !s->path[i].gone)
            index[n++] = i;
    }
    if (index && key)
        lines_sort(index, n, key);
    for (int i = 0; i < n && o->block; i++) {
        struct shapes_path *path = s->path + index[i];
        struct outlines_block *b = o->block + o->blocks++;
        const double area = lines_area(outlines_points(s, path), path->points);
        path->area = shapes_abs(area) / 2;
        b->path = index[i];
        b->root = i;
        outlines_measure(o, b);
        o->size += b->size / n;
    }
    free(index);
    free(key);
}

static struct shapes_path *outlines_path(const struct outlines *o, int i)
{
    return o->s->path + o->block[i].path;
}

/* Makes the word of a label that a statement takes: layer 0 is `b`. */
static int outlines_word(struct shapes *s, const char *label, char *out,
                         int room)
{
    int n = 0;
    if (strcmp(label, "0") != 0)
        for (; label[n] && n + 1 < room; n++)
            out[n] = label[n] == ' ' || label[n] == '#' ? '_' : label[n];
    while (n > 0 && !shapes_is_utf8(out, n))
        n--;
    if (n == 0)
        out[n++] = s->photograph ? 's' : 'b';
    out[n] = '\0';
    return n;
}

/* Returns the slot of a name in a table of twice as many slots as names. */
static int outlines_slot(const struct outlines *o, const int *slot, int slots,
                         const char *name)
{
    unsigned hash = 2166136261u;
    int i;
    for (const char *c = name; *c; c++)
        hash = (hash ^ (unsigned char)*c) * 16777619u;
    i = (int)(hash & (unsigned)(slots - 1));
    while (slot[i]
           && strcmp(shapes_at(o->s, o->block[slot[i] - 1].name), name) != 0)
        i = (i + 1) & (slots - 1);
    return i;
}

/* Names block i: of a drawing its layer and its number; of a photograph its
   label, with a number where it was given before. */
static void outlines_name(struct outlines *o, int i, int *slot, int slots,
                          int *again)
{
    struct shapes *s = o->s;
    struct shapes_text t = {NULL, 0, 0, 0};
    char word[256];
    int n = outlines_word(s, shapes_at(s, outlines_path(o, i)->label), word,
                          sizeof word);
    int at, number = s->photograph ? 1 : i + 1, first = -1;
    do {
        t.length = 0;
        shapes_put_bytes(&t, word, n);
        if (number > 1 || !s->photograph) {
            shapes_put(&t, "_");
            shapes_put_int(&t, number);
        }
        at = t.lost ? 0 : outlines_slot(o, slot, slots, t.at);
        if (first < 0)
            first = at;
        number = number == 1 && again[first] > 1 ? again[first] : number + 1;
    } while (!t.lost && slot[at]);
    again[first] = number;
    slot[at] = i + 1;
    o->block[i].name = t.lost ? 0 : shapes_word(s, t.at, t.length);
    s->lost |= t.lost;
    free(t.at);
}

static void outlines_names(struct outlines *o)
{
    int slots = 64, *slot, *again;
    while (slots < 2 * o->blocks)
        slots *= 2;
    slot = shapes_array(o->s, slots, sizeof *slot);
    again = shapes_array(o->s, slots, sizeof *again);
    for (int i = 0; slot && again && i < o->blocks && !o->s->lost; i++)
        outlines_name(o, i, slot, slots, again);
    free(slot);
    free(again);
}

/* Puts names of blocks that a mark is set for into a note. */
static void outlines_put_names(struct outlines *o, const char *mark)
{
    struct shapes_text *t = &o->s->notes;
    int shown = 0, count = 0;
    for (int i = 0; i < o->blocks; i++)
        count += mark[i] != 0;
    for (int i = 0; i < o->blocks && shown < OUTLINES_NAMED; i++) {
        if (!mark[i])
            continue;
        shapes_put(t, shown == 0 ? "" : shown + 1 == count ? " and " : ", ");
        shapes_put_shown(t, shapes_at(o->s, o->block[i].name));
        shown++;
    }
    if (count > shown) {
        shapes_put(t, " and ");
        shapes_put_int(t, count - shown);
        shapes_put(t, " more");
    }
}

/* Names the parts of one stone that are stones of their own. */
static void outlines_note_parts(struct outlines *o)
{
    struct shapes *s = o->s;
    char *mark = shapes_array(s, o->blocks, sizeof *mark);
    int *count = shapes_array(s, s->groups, sizeof *count), parts = 0;
    for (int i = 0; mark && count && i < o->blocks; i++)
        if (outlines_path(o, i)->group >= 0)
            count[outlines_path(o, i)->group]++;
    for (int i = 0; mark && count && i < o->blocks; i++) {
        const struct shapes_path *path = outlines_path(o, i);
        mark[i] = path->group >= 0 && count[path->group] > 1
               && path->role != SHAPES_GROUND;
        parts += mark[i];
    }
    if (parts > 0) {
        shapes_put(&s->notes, "parts of one stone that do not touch are stones "
                              "of their own: ");
        outlines_put_names(o, mark);
        shapes_put(&s->notes, " (draw what holds them together)\n");
    }
    free(mark);
    free(count);
}

/* ---- Ground --------------------------------------------------------------- */

/* Keeps the part of an outline above a height. */
static void outlines_cut(struct shapes *s, struct shapes_path *path, double y)
{
    const int n = path->points, first = s->points;
    for (int i = 0; i < n && !s->lost; i++) {
        const struct shapes_point a = s->point[path->first + i];
        const struct shapes_point b = s->point[path->first + (i + 1) % n];
        if (a.y >= y)
            shapes_point(s, a.x, a.y, 0);
        if ((a.y >= y) != (b.y >= y))
            shapes_point(s, a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), y, 0);
    }
    path->first = first;
    path->points = s->points - first;
}

/* Makes a line the ground: cuts the outlines there, and adds a slab below
   it. */
static void outlines_line(struct outlines *o, double y, double reach)
{
    struct shapes *s = o->s;
    double left = 0, right = 0;
    int first, label, made, cut = 0, below = 0;
    for (int i = 0; i < o->blocks && !s->lost; i++) {
        struct outlines_block *b = o->block + i;
        struct shapes_path *path = s->path + b->path;
        left = i == 0 || b->left < left ? b->left : left;
        right = i == 0 || b->right > right ? b->right : right;
        if (path->role == SHAPES_GROUND || b->high <= y) {
            below++;
            shapes_leave(s, path, "outline below the ground");
        } else if (b->low < y) {
            cut++;
            outlines_cut(s, path, y);
            if (path->points < 3)
                shapes_leave(s, path, "outline below the ground");
            else
                outlines_mend(o, b->path, reach);
        }
    }
    if (s->lost || o->blocks == 0)
        return;
    label = shapes_word(s, "ground", 6);
    first = s->points;
    shapes_point(s, left - o->size, y - o->size, 0);
    shapes_point(s, right + o->size, y - o->size, 0);
    shapes_point(s, right + o->size, y, 0);
    shapes_point(s, left - o->size, y, 0);
    made = shapes_path(s, first, 1, label, label, 0);
    if (made >= 0)
        s->path[made].role = SHAPES_GROUND;
    shapes_put(&s->notes, "the ground is a line, as asked: ");
    shapes_put_int(&s->notes, cut);
    shapes_put(&s->notes, " outlines are cut there, ");
    shapes_put_int(&s->notes, below);
    shapes_put(&s->notes, " below it are left out\n");
}

/* Says which outlines are fixed for want of ground. */
static void outlines_note_lowest(struct outlines *o, const char *mark)
{
    struct shapes *s = o->s;
    shapes_put(&s->notes, "no label is ground: ");
    shapes_put(&s->notes, s->photograph ? "the lowest row is fixed, "
                                        : "the lowest is fixed, ");
    outlines_put_names(o, mark);
    shapes_put(&s->notes, ", and cannot turn or slide: the favourable side");
    if (!s->photograph)
        shapes_put(&s->notes, " (an arch fixed at its end voussoirs bears "
                              "more than one on abutments)");
    shapes_put(&s->notes, "; draw what they stand on, or name it (--layer "
                          "NAME=ground)\n");
}

/* Says which outlines have nothing below them and are higher than those that are
   fixed: a second abutment, perhaps. */
static void outlines_note_second(struct outlines *o, char *mark)
{
    struct shapes *s = o->s;
    int count = 0;
    for (int i = 0; i < o->blocks; i++) {
        const struct outlines_block *b = o->block + i;
        int below = outlines_path(o, i)->role != SHAPES_STONE;
        for (int j = 0; j < o->blocks && !below; j++) {
            const struct outlines_block *c = o->block + j;
            below = j != i && outlines_path(o, j)->role != SHAPES_FILL
                 && c->low < b->low - 1e-6 * o->size && c->left < b->right
                 && c->right > b->left;
        }
        mark[i] = (char)!below;
        count += !below;
    }
    if (count == 0)
        return;
    shapes_put(&s->notes, "nothing is below ");
    outlines_put_names(o, mark);
    shapes_put(&s->notes, ", and not fixed, since other outlines are lower: "
                          "where it stands on ground, draw that, or give it a "
                          "layer of its own (--layer NAME=ground)\n");
}

/* Fixes the lowest outlines where no label is ground: of a photograph those
   that begin less than half a stone above the lowest point. */
static void outlines_lowest(struct outlines *o)
{
    struct shapes *s = o->s;
    char *mark = shapes_array(s, o->blocks, sizeof *mark);
    double low = 0;
    int found = 0, first = 1;
    for (int i = 0; i < o->blocks; i++) {
        if (outlines_path(o, i)->role == SHAPES_GROUND)
            found = 1;
        if (outlines_path(o, i)->role == SHAPES_FILL)
            continue;
        low = first || o->block[i].low < low ? o->block[i].low : low;
        first = 0;
    }
    for (int i = 0; mark && !found && i < o->blocks; i++) {
        struct shapes_path *path = outlines_path(o, i);
        const double reach = (s->photograph ? 0.5 : 0.02) * o->size;
        if (path->role == SHAPES_FILL || o->block[i].low > low + reach)
            continue;
        path->role = SHAPES_GROUND;
        mark[i] = 1;
    }
    if (mark && !found && o->blocks > 0) {
        outlines_note_lowest(o, mark);
        if (!s->photograph)
            outlines_note_second(o, mark);
    }
    free(mark);
}

/* ---- What looks wrong ----------------------------------------------------- */

/* Returns 1 if some corner of the first outline is that near to the second
   one. */
static int outlines_corner_near(const struct outlines *o, int i, int j,
                                double snap)
{
    const struct shapes_path *a = outlines_path(o, i), *b = outlines_path(o, j);
    const struct outlines_block *box = o->block + j;
    const struct shapes_point *p = outlines_points(o->s, a);
    for (int k = 0; k < a->points; k++)
        if (p[k].x >= box->left - snap && p[k].x <= box->right + snap
            && p[k].y >= box->low - snap && p[k].y <= box->high + snap
            && outlines_holds(outlines_points(o->s, b), b->points, p[k], snap))
            return 1;
    return 0;
}

static int outlines_root(struct outlines *o, int i)
{
    while (o->block[i].root != i)
        i = o->block[i].root = o->block[o->block[i].root].root;
    return i;
}

/* Finds which blocks touch; fixed ones are one. */
static void outlines_touch(struct outlines *o)
{
    int fixed = -1;
    for (int i = 0; i < o->blocks; i++) {
        const struct outlines_block *a = o->block + i;
        const struct shapes_path *path = outlines_path(o, i);
        if (path->role == SHAPES_FILL)
            continue;
        for (int j = 0; j < i; j++) {
            const struct outlines_block *b = o->block + j;
            const double size = a->size < b->size ? a->size : b->size;
            const double snap = o->exact > 0 ? 4 * o->exact : 2e-3 * size;
            if (outlines_path(o, j)->role == SHAPES_FILL
                || a->left > b->right + snap || b->left > a->right + snap
                || a->low > b->high + snap || b->low > a->high + snap
                || !(outlines_corner_near(o, i, j, snap)
                     || outlines_corner_near(o, j, i, snap)))
                continue;
            o->block[i].touches++;
            o->block[j].touches++;
            o->block[outlines_root(o, i)].root = outlines_root(o, j);
        }
        if (path->role != SHAPES_GROUND)
            continue;
        if (fixed >= 0)
            o->block[outlines_root(o, i)].root = outlines_root(o, fixed);
        fixed = i;
    }
}

/* Names the blocks that touch nothing fixed. */
static void outlines_hang(struct outlines *o)
{
    struct shapes *s = o->s;
    char *mark = shapes_array(s, o->blocks, sizeof *mark);
    int ground = -1, hang = 0;
    for (int i = 0; i < o->blocks; i++)
        if (outlines_path(o, i)->role == SHAPES_GROUND)
            ground = outlines_root(o, i);
    for (int i = 0; mark && i < o->blocks; i++)
        if (outlines_path(o, i)->role == SHAPES_STONE
            && outlines_root(o, i) != ground)
            hang += mark[i] = 1;
    if (hang > 0) {
        shapes_put(&s->notes,
                   hang == 1 ? "hangs in the air: " : "hang in the air: ");
        outlines_put_names(o, mark);
        shapes_put(&s->notes, hang == 1 ? " touches" : " touch");
        shapes_put(&s->notes, " nothing that is held (--layer NAME=ignore)\n");
    }
    free(mark);
}

/* Names block i if it is as large as many others and touches many, unless the
   user said what it is. */
static void outlines_soil(struct outlines *o, int i, double others)
{
    struct shapes *s = o->s;
    const struct shapes_path *path = outlines_path(o, i);
    const double times = path->area / others;
    if (path->role != SHAPES_STONE || o->block[i].touches < 5 || !(times > 5)
        || shapes_role_asked(s, shapes_at(s, path->label)) >= 0)
        return;
    shapes_put(&s->notes, "looks like soil: ");
    shapes_put_shown(&s->notes, shapes_at(s, o->block[i].name));
    shapes_put(&s->notes, ", taken as one rigid stone, is as large as ");
    shapes_put_int(&s->notes, times < 1e9 ? (int)times : INT_MAX);
    shapes_put(&s->notes, " others and touches ");
    shapes_put_int(&s->notes, o->block[i].touches);
    shapes_put(&s->notes, " (--layer ");
    shapes_put_shown(&s->notes, shapes_at(s, path->label));
    shapes_put(&s->notes, "=fill)\n");
}

/* Names blocks that hang in the air, and stones that look like soil. */
static void outlines_suspect(struct outlines *o)
{
    int stones = 0;
    double area = 0;
    outlines_touch(o);
    outlines_hang(o);
    for (int i = 0; i < o->blocks; i++)
        if (outlines_path(o, i)->role == SHAPES_STONE) {
            area += outlines_path(o, i)->area;
            stones++;
        }
    for (int i = 0; i < o->blocks && stones > 5; i++)
        outlines_soil(o, i, (area - outlines_path(o, i)->area) / (stones - 1));
}

#endif /* OUTLINES_H */
