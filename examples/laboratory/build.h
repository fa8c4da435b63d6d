/* build.h - structures of irregular stones, built in the simulator, for the
   example programs.

   A stone of irregularity L is a rectangle whose height varies by L/200, whose
   corners are moved by up to L/200 of it, and whose edges get with probability
   L/100 one more vertex outside; the convex hull of that. build_structure()
   lets them down one by one on what is there, chooses of some stones the one
   that lies lowest, lets the whole settle, and keeps only what stays about
   where it was put.

   The same seed gives the same structure. Lengths: a stone is about 1 wide.

   SPDX-License-Identifier: MIT */

#ifndef BUILD_H
#define BUILD_H

#include "../parts/random.h"
#include "rigid.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

enum { BUILD_CORNERS = 8, BUILD_STONES = 64, BUILD_CANDIDATES = 4 };

struct build_stone {
    struct rigid_pt v[BUILD_CORNERS]; /* counter-clockwise */
    int n;
};

enum build_kind {
    BUILD_WALL,
    BUILD_STACK,
    BUILD_PYRAMID,
    BUILD_TOWER,
    BUILD_KINDS
};

static const char *const build_kind_name[] = {"wall", "stack", "pyramid",
                                              "tower"};

struct build {
    struct build_stone stone[BUILD_STONES];
    int stones;
    double left, right; /* of the base, whose top is at 0 */
    uint64_t state;     /* of the random numbers          */
};

static double build_uniform(struct build *b, double low, double high)
{
    return random_uniform(&b->state, low, high);
}

/* ---- One stone ----------------------------------------------------------- */

/* The convex hull of p[0..n), by Andrew's monotone chain. */
static int build_hull(struct rigid_pt *p, int n, struct rigid_pt *out)
{
    int k = 0;
    for (int i = 1; i < n; i++)
        for (int j = i; j > 0
                        && (p[j].x < p[j - 1].x
                            || (p[j].x <= p[j - 1].x && p[j].y < p[j - 1].y));
             j--) {
            struct rigid_pt swap = p[j];
            p[j] = p[j - 1];
            p[j - 1] = swap;
        }
    for (int side = 0; side < 2; side++) {
        int least = k + 1;
        for (int i = 0; i < n; i++) {
            struct rigid_pt q = p[side ? n - 1 - i : i];
            while (k > least && rigid_area(out[k - 2], out[k - 1], q) <= 1e-4)
                k--;
            out[k++] = q;
        }
        k--; /* it begins the other side */
    }
    return k;
}

static double build_area(const struct build_stone *s)
{
    double sum = 0;
    for (int i = 0; i < s->n; i++)
        sum += rigid_cross(s->v[i], s->v[(i + 1) % s->n]) / 2;
    return sum;
}

/* The angle and the middle of the edge that looks down most. */
static double build_bottom(const struct build_stone *s)
{
    double best = 2, angle = 0;
    for (int i = 0; i < s->n; i++) {
        struct rigid_pt e = rigid_sub(s->v[(i + 1) % s->n], s->v[i]);
        double length = rigid_length(e), up = -e.x / length;
        if (length > 0.3 && up < best) {
            best = up;
            angle = atan2(e.y, e.x);
        }
    }
    return angle;
}

/* A stone whose lowest edge lies on y = 0, its middle above x = 0. */
static void build_make(struct build *b, double irregularity,
                       struct build_stone *s)
{
    const double rough = irregularity / 200;
    const double height = 0.7 * (1 + build_uniform(b, -rough, rough));
    const double half = build_uniform(b, 0.8, 1.4) / 2, jog = rough * height;
    struct rigid_pt p[BUILD_CORNERS], hull[2 * BUILD_CORNERS];
    double least = HUGE_VAL, low = HUGE_VAL, high = -HUGE_VAL, angle;
    int n = 4;
    for (int i = 0; i < 4; i++) { /* not as arguments: these have no order */
        p[i].y = (i > 1 ? height : 0) + build_uniform(b, -jog, jog);
        p[i].x = (i == 1 || i == 2 ? half : -half)
               + build_uniform(b, -jog, jog);
    }
    for (int i = 0; i < 4; i++)
        if (build_uniform(b, 0, 1) < irregularity / 100) {
            struct rigid_pt u = p[i], v = p[(i + 1) % 4];
            double at = build_uniform(b, 0.25, 0.75);
            double out = build_uniform(b, 0.05, 0.25) * irregularity / 100;
            p[n++] = rigid_vec(u.x + at * (v.x - u.x) + out * (v.y - u.y),
                               u.y + at * (v.y - u.y) - out * (v.x - u.x));
        }
    s->n = build_hull(p, n, hull);
    for (int i = 0; i < s->n; i++)
        s->v[i] = hull[i];
    angle = build_bottom(s);
    for (int i = 0; i < s->n; i++) {
        s->v[i] = rigid_turned(rigid_unit(-angle), s->v[i]);
        least = fmin(least, s->v[i].y);
        low = fmin(low, s->v[i].x);
        high = fmax(high, s->v[i].x);
    }
    for (int i = 0; i < s->n; i++) {
        s->v[i].x -= (low + high) / 2;
        s->v[i].y -= least;
    }
}

/* ---- Laying ------------------------------------------------------------- */

/* Height of the upper (sign 1) or lower (-1) side of a stone at x, or none. */
static int build_height(const struct build_stone *s, double x, int sign,
                        double *out)
{
    int found = 0;
    for (int i = 0; i < s->n; i++) {
        struct rigid_pt p = s->v[i], q = s->v[(i + 1) % s->n];
        double y;
        if ((x < p.x && x < q.x) || (x > p.x && x > q.x))
            continue;
        y = fabs(q.x - p.x) > 1e-12
              ? p.y + (x - p.x) / (q.x - p.x) * (q.y - p.y)
              : p.y;
        if (!found || sign * y > sign * *out)
            *out = y;
        found = 1;
    }
    return found;
}

/* Returns the height at which a stone that is moved straight down at x first
   touches. It does not turn: build_settle() lets it find its rest. */
static double build_drop(const struct build *b, const struct build_stone *s,
                         double x)
{
    double lift = 0;
    for (int j = 0; j < b->stones; j++) {
        const struct build_stone *o = &b->stone[j];
        double top, low;
        for (int i = 0; i < s->n; i++)
            if (build_height(o, s->v[i].x + x, 1, &top))
                lift = fmax(lift, top - s->v[i].y);
        for (int i = 0; i < o->n; i++)
            if (build_height(s, o->v[i].x - x, -1, &low))
                lift = fmax(lift, o->v[i].y - low);
    }
    return lift;
}

/* Lays the lowest of some stones at x; returns its width. */
static double build_lay(struct build *b, double irregularity, double x,
                        int beside)
{
    struct build_stone best = {{{0, 0}}, 0};
    double least = HUGE_VAL, shift = 0, low = 0, high = 0;
    if (b->stones == BUILD_STONES)
        return 1;
    for (int k = 0; k < BUILD_CANDIDATES; k++) {
        struct build_stone s;
        double left = HUGE_VAL, right = -HUGE_VAL, height;
        build_make(b, irregularity, &s);
        for (int i = 0; i < s.n; i++) {
            left = fmin(left, s.v[i].x);
            right = fmax(right, s.v[i].x);
        }
        height = build_drop(b, &s, beside ? x - left : x);
        if (height >= least)
            continue;
        least = height;
        best = s;
        low = left;
        high = right;
        shift = beside ? x - left : x;
    }
    for (int i = 0; i < best.n; i++) {
        best.v[i].x += shift;
        best.v[i].y += least + 1e-4;
    }
    b->stone[b->stones++] = best;
    return high - low;
}

static void build_courses(struct build *b, enum build_kind kind,
                          double irregularity)
{
    int courses = kind == BUILD_TOWER ? (int)build_uniform(b, 4, 8)
                                      : (int)build_uniform(b, 3, 6);
    int width = (int)build_uniform(b, 3, 6);
    for (int c = 0; c < courses; c++) {
        int count = kind == BUILD_TOWER   ? 1
                  : kind == BUILD_PYRAMID ? width + 1 - c
                                          : width;
        double x = kind == BUILD_TOWER   ? build_uniform(b, -0.2, 0.2)
                 : kind == BUILD_PYRAMID ? 0.6 * c
                 : kind == BUILD_WALL    ? (c % 2 ? 0.5 : 0)
                                         : build_uniform(b, 0, 0.1);
        for (int i = 0; i < count; i++) {
            double w = build_lay(b, irregularity, x, kind != BUILD_TOWER);
            x += w + build_uniform(b, 0.02, 0.08);
        }
    }
}

/* ---- Settling ------------------------------------------------------------ */

/* Runs for some seconds, calmed. Returns the longest way of a stone, or -1. */
static double build_run(struct rigid_world *w, double seconds, double calm)
{
    struct rigid_pt *from = malloc((size_t)w->blocks * sizeof *from);
    double most = from ? 0 : -1;
    for (int i = 0; i < w->blocks && from; i++)
        from[i] = w->block[i].at;
    for (int s = (int)(seconds / w->step); s > 0 && most >= 0; s--) {
        if (rigid_step(w))
            most = -1;
        for (int i = 1; i < w->blocks; i++) {
            w->block[i].v.x *= calm;
            w->block[i].v.y *= calm;
            w->block[i].spin *= calm;
        }
    }
    for (int i = 1; i < w->blocks && most >= 0; i++) {
        struct rigid_pt d = rigid_sub(w->block[i].at, from[i]);
        most = fmax(most, rigid_length(d));
    }
    free(from);
    return most;
}

/* Settles what was laid; 1 where it stands about as it was put. */
static int build_settle(struct build *b)
{
    struct rigid_world w;
    struct rigid_pt base[4];
    int good;
    rigid_init(&w);
    w.friction = 0.4;
    base[0] = rigid_vec(b->left, -1);
    base[1] = rigid_vec(b->right, -1);
    base[2] = rigid_vec(b->right, 0);
    base[3] = rigid_vec(b->left, 0);
    good = rigid_add(&w, base, 4, 0, base[0]) >= 0;
    for (int i = 0; i < b->stones && good; i++) {
        struct rigid_pt c = {0, 0};
        for (int k = 0; k < b->stone[i].n; k++) {
            c.x += b->stone[i].v[k].x / b->stone[i].n;
            c.y += b->stone[i].v[k].y / b->stone[i].n;
        }
        good = rigid_add(&w, b->stone[i].v, b->stone[i].n,
                         build_area(&b->stone[i]), c)
            >= 0;
        for (int k = 0; k < b->stone[i].n; k++)
            b->stone[i].v[k] = rigid_sub(b->stone[i].v[k], c);
    }
    if (good) {
        double way = build_run(&w, 4, 0.99), rest = build_run(&w, 4, 1);
        good = way >= 0 && way < 0.3 && rest >= 0 && rest < 1e-3;
    }
    for (int i = 0; i < b->stones && good; i++) {
        const struct rigid_block *r = &w.block[i + 1];
        for (int k = 0; k < b->stone[i].n; k++) {
            struct rigid_pt q = rigid_turned(r->turn, b->stone[i].v[k]);
            b->stone[i].v[k] = rigid_vec(r->at.x + q.x, r->at.y + q.y);
        }
    }
    rigid_free(&w);
    return good;
}

/* Builds one, trying again until it stands. */
static inline void build_structure(struct build *b, enum build_kind kind,
                                   double irregularity, uint64_t seed)
{
    b->state = random_start(seed);
    do {
        double low = HUGE_VAL, high = -HUGE_VAL;
        b->stones = 0;
        build_courses(b, kind, irregularity);
        for (int i = 0; i < b->stones; i++)
            for (int k = 0; k < b->stone[i].n; k++) {
                low = fmin(low, b->stone[i].v[k].x);
                high = fmax(high, b->stone[i].v[k].x);
            }
        b->left = low - 2;
        b->right = high + 2;
    } while (!build_settle(b));
}

/* Writes it in the text format. Returns 0, or -1. */
static inline int build_write(const struct build *b, const char *path)
{
    FILE *out = fopen(path, "w");
    if (!out)
        return -1;
    fprintf(out,
            "friction 0.4\ngravity 0 -9.81\ntolerance 0.001\n"
            "fixed base %.9g -1 %.9g -1 %.9g 0 %.9g 0\n",
            b->left, b->right, b->right, b->left);
    for (int i = 0; i < b->stones; i++) {
        fprintf(out, "block s%d *", i);
        for (int k = 0; k < b->stone[i].n; k++)
            fprintf(out, "  %.9g %.9g", b->stone[i].v[k].x, b->stone[i].v[k].y);
        fprintf(out, "\n");
    }
    return fclose(out) ? -1 : 0;
}

#endif /* BUILD_H */
