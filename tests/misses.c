/* cc -O2 -ffp-contract=off -o misses tests/misses.c -lm
       ./misses [SEEDS [ERROR [KIND [FILE]]]]

   Near misses: measures how often kern_certain() says that a structure stands
   for certain although it truly falls, or moves farther than `settles` tells.

   Each kind is a structure with random dimensions, half of them mirrored, that
   lacks a support by a gap of 0.5 to 10 errors. The true motion of a structure
   is the largest displacement of a vertex in the simulator of rigid.h, run from
   the true geometry until it rests or has fallen. kern_certain() gets two
   measured copies of it, with the noise of noise.c. A verdict is wrong if
   KERN_STANDS is certain and the true motion exceeds `settles` by more than 0.1
   errors and 1e-4 mean sizes. Joints that are closed move by less than that. A
   structure topples if it moves by more than 0.3 mean sizes.

     SEEDS  structures of each kind and gap; default 3
     ERROR  standard error of place in mean sizes; default 0.005. That of angle
            is as large in radians
     KIND   name of one kind: prints the range of the true motion for each gap,
            in errors, and each wrong verdict
     FILE   receives the first wrong structure of that kind, as measured

   The first table has the measured structures of each kind, those that are
   certain to stand, those of the latter that are wrong and that topple, the
   wrong ones in per cent of the certain ones, and the gap with most wrong ones,
   in per cent of all structures of that gap. Kinds of even and of odd number,
   counted from 0, are also summed apart, so that constants can be chosen on one
   half and tested on the other.

   The second table has structures that stand and do not move: the per cent of
   them that is certain, at five errors, and their largest true motion.

   Returns 1 if a call is refused for another reason than an overlap, if the
   simulator does not find a motion that is known, if what stands moves by a
   tenth of an error, or if more than MOST_WRONG of the certain verdicts are
   wrong.
   SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "../examples/parts/random.h"
#include "../examples/laboratory/rigid.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    MOST_BLOCKS = 200,
    MOST_VERTICES = 4000,
    MOST_CONTACTS = 8000,
    MOST_CORNERS = 64, /* of one block */
    GAPS = 8,
    COPIES = 2,  /* measured copies of a near miss            */
    STANDING = 3 /* structures that stand for each near miss  */
};

/* Largest share of the certain verdicts that may be wrong: 0.021 at an error of
   0.005, and 0.006 to 0.030 at errors of 0.0001 to 0.02. */
static const double MOST_WRONG = 0.03;

static const double gap_errors[GAPS] = {0.5, 1, 2, 3, 4, 6, 8, 10};

/* A polygon of a structure, and a force at a point on it. */
struct shape {
    int first, corners;
    double density; /* 0: ground */
    double fx, fy, x, y;
};

struct structure {
    struct shape shape[MOST_BLOCKS];
    kern_vec vertex[MOST_VERTICES];
    kern_block block[MOST_BLOCKS];
    int blocks, vertices;
    double friction, size;
    double e; /* the error that the kind is made for */
};

struct score {
    long asked, certain, wrong, topples, overlaps, refused;
    long cells, bad_cells; /* kinds times gaps; with over 1 % that is wrong */
};

/* true: the structure as it is; seen: as measured. */
static struct structure true_one, seen;
static kern_contact contact[MOST_CONTACTS], again[MOST_CONTACTS];
static kern_real *real;
static int *integer, reals, integers;

/* ---- random numbers ---- */

static uint64_t state;

/* Begins the numbers of one structure or of one measured copy of it. */
static void begin_random(const char *name, int gap, int seed, int copy)
{
    uint64_t mix = UINT64_C(0xcbf29ce484222325);
    for (; *name; name++)
        mix = (mix ^ (unsigned char)*name) * UINT64_C(0x100000001b3);
    mix ^= (uint64_t)gap << 40 ^ (uint64_t)copy << 32 ^ (uint64_t)seed;
    state = random_mixed(&mix);
    state += state == 0;
}

static double draw(double low, double high)
{
    return random_uniform(&state, low, high);
}

/* Returns an integer from low to high. */
static int draw_count(int low, int high)
{
    return low + (int)(random_bits(&state) % (uint64_t)(high - low + 1));
}

/* Returns a number of the standard normal distribution. */
static double gauss(void)
{
    const double r = sqrt(-2 * log(1 - random_share(random_bits(&state))));
    return r * cos(6.283185307179586 * random_share(random_bits(&state)));
}

/* ---- making structures ---- */

#define COUNT_OF(array) ((int)(sizeof(array) / sizeof *(array)))

/* Adds a polygon from coordinates x, y, x, y, ... */
#define SHAPE(density, ...)                       \
    add((density), (const double[]){__VA_ARGS__}, \
        COUNT_OF(((const double[]){__VA_ARGS__})) / 2)

/* Adds a polygon of n corners; ground if the density is 0. */
static void add(double density, const double *xy, int n)
{
    static const struct shape none;
    struct structure *t = &true_one;
    struct shape *s = &t->shape[t->blocks++];
    int i;
    if (t->blocks > MOST_BLOCKS || t->vertices + n > MOST_VERTICES
        || n > MOST_CORNERS) {
        fprintf(stderr, "misses: a structure is too large\n");
        exit(2);
    }
    *s = none;
    s->first = t->vertices;
    s->corners = n;
    s->density = density;
    for (i = 0; i < n; i++) {
        t->vertex[t->vertices].x = (kern_real)xy[2 * i];
        t->vertex[t->vertices++].y = (kern_real)xy[2 * i + 1];
    }
}

/* Adds a rectangle from its lower left to its upper right corner. */
static void box(double density, double x0, double y0, double x1, double y1)
{
    SHAPE(density, x0, y0, x1, y0, x1, y1, x0, y1);
}

/* Lets a force act at a point of the last polygon. */
static void load(double fx, double fy, double x, double y)
{
    struct shape *s = &true_one.shape[true_one.blocks - 1];
    s->fx = fx;
    s->fy = fy;
    s->x = x;
    s->y = y;
}

/* Turns all polygons from number `first` on about (x, y). */
static void turn(int first, double angle, double x, double y)
{
    const double c = cos(angle), s = sin(angle);
    int i;
    for (i = true_one.shape[first].first; i < true_one.vertices; i++) {
        kern_vec *v = &true_one.vertex[i];
        const double u = (double)v->x - x, w = (double)v->y - y;
        v->x = (kern_real)(x + u * c - w * s);
        v->y = (kern_real)(y + u * s + w * c);
    }
}

/* Mirrors the structure at the y axis. */
static void mirror(void)
{
    struct structure *t = &true_one;
    int i, k;
    for (i = 0; i < t->blocks; i++) {
        kern_vec *v = t->vertex + t->shape[i].first;
        const int n = t->shape[i].corners;
        for (k = 0; k < n / 2; k++) {
            const kern_vec w = v[k];
            v[k] = v[n - 1 - k];
            v[n - 1 - k] = w;
        }
        for (k = 0; k < n; k++)
            v[k].x = -v[k].x;
        t->shape[i].fx = -t->shape[i].fx;
        t->shape[i].x = -t->shape[i].x;
    }
}

/* Makes a block of one polygon. Returns a status. */
static kern_status make_block(struct structure *t, int i)
{
    const struct shape *s = &t->shape[i];
    const kern_vec *v = t->vertex + s->first;
    return s->density > 0 ? kern_block_init(&t->block[i], v, s->corners,
                                            (kern_real)s->density, NULL)
                          : kern_ground_init(&t->block[i], v, s->corners, NULL);
}

/* Makes the blocks of the polygons. Returns 0 if one of them is refused. */
static int make_blocks(void)
{
    struct structure *t = &true_one;
    int i;
    for (i = 0; i < t->blocks; i++) {
        const struct shape *s = &t->shape[i];
        const kern_vec force = {(kern_real)s->fx, (kern_real)s->fy};
        const kern_vec point = {(kern_real)s->x, (kern_real)s->y};
        if (make_block(t, i) < 0)
            return 0;
        if (s->fx != 0 || s->fy != 0)
            kern_block_load(&t->block[i], force, point, 0);
    }
    t->size = (double)kern_mean_size(t->block, t->blocks);
    return 1;
}

/* ---- grounds ---- */

/* Adds one ground whose surface is at 0 up to x and at -gap after it. */
static void step(double x, double gap)
{
    SHAPE(0, -6, -2, 6, -2, 6, -gap, x, -gap, x, 0, -6, 0);
}

/* Adds the same surface as two grounds. */
static void cut_step(double x, double gap)
{
    box(0, -6, -2, x, 0);
    box(0, x, -2, 6, -gap);
}

static void flat(void) { box(0, -6, -2, 6, 0); }

/* Adds a block with a flat bed from 0 to b, of height h, whose weight passes
   through x = at: a parallelogram. */
static void leaning(double b, double h, double at)
{
    const double s = 2 * at - b;
    SHAPE(draw(1, 3), 0, 0, b, 0, b + s, h, s, h);
}

/* ---- kinds: one stone ---- */

/* Makes a stone between two walls with nothing below. */
static void slot(double gap)
{
    const double w = draw(0.5, 1.5), h = draw(0.5, 2), at = draw(0, gap);
    box(0, -2, -1, 0, h + 1);
    box(0, w + gap, -1, w + 3, h + 1);
    box(1, at, 0, at + w, h);
    true_one.friction = draw(0.2, 0.9);
}

/* Makes a wedge in a tapered slot that is too wide. */
static void wedge(double gap)
{
    const double t = draw(0.08, 0.35), w = draw(0.2, 0.6), h = draw(0.5, 1.2);
    const double a = w + gap / 2, up = a + 4 * t;
    SHAPE(0, -4, -1, -a, -1, -up, 3, -4, 3);
    SHAPE(0, 4, -1, 4, 3, up, 3, a, -1);
    SHAPE(1, -w - t, 0, w + t, 0, w + t + h * t, h, -w - t - h * t, h);
    true_one.friction = draw(0.05, 0.5);
}

/* Makes a plank that misses its second support. */
static void plank(double gap)
{
    const double w = draw(0.6, 2), h = draw(0.2, 0.8);
    box(0, -3, -1, w * draw(0.1, 0.48), 0);
    box(0, w + gap, -1, 4, 0);
    box(1, 0, 0, w, h);
}

/* Makes a block with its centre beyond the edge of the ground. */
static void half(double gap)
{
    const double w = draw(0.4, 1.5), h = draw(0.2, 1.5);
    box(0, -4, -1, 0, 0);
    box(1, gap - w / 2, 0, gap + w / 2, h);
}

/* Makes a block on two grounds of which the wider one is low. */
static void wide_low(double gap)
{
    const double w = draw(0.6, 1.4), x = w * draw(0.15, 0.45);
    cut_step(x, gap);
    box(1, 0, 0, w, draw(0.4, 1.5));
}

/* Makes a block on two grounds of which the one nearer to its weight is low. */
static void near_low(double gap)
{
    const double w = draw(0.6, 1.4), h = draw(0.4, 1.2), x = w * draw(0.3, 0.6);
    box(0, -6, -2, x * draw(0.5, 1), 0);
    box(0, x, -2, 6, -gap);
    SHAPE(1, 0, 0, w, 0, w, h, w * draw(0.3, 0.8), h);
}

/* Makes a block on two grounds of which the one farther from its weight is low.
   */
static void far_low(double gap)
{
    const double w = draw(0.6, 1.4), h = draw(0.4, 1.2), x = w * draw(0.2, 0.5);
    box(0, -6, -2, x * draw(0.5, 1), 0);
    box(0, x, -2, 6, -gap);
    SHAPE(1, 0, 0, w, 0, w * draw(0.3, 0.8), h, 0, h);
}

/* Makes a block on one ground with a step. */
static void bed_step(double gap)
{
    const double w = draw(0.6, 1.4);
    step(w * draw(0.05, 0.52), gap);
    box(1, 0, 0, w, draw(0.4, 1.8));
}

/* Makes a block on the same step of two grounds. */
static void cut_bed_step(double gap)
{
    const double w = draw(0.6, 1.4);
    cut_step(w * draw(0.05, 0.52), gap);
    box(1, 0, 0, w, draw(0.4, 1.8));
}

/* Adds a ground with one bump, and a stone on it. */
static void bump(double gap, double wide)
{
    const double w = draw(0.6, 1.4), x = draw(0, w / 2 - wide);
    SHAPE(0, -6, -2, 6, -2, 6, -gap, x + wide, -gap, x + wide, 0, x, 0, x, -gap,
          -6, -gap);
    box(1, 0, 0, w, draw(0.4, 1.8));
}

/* Makes a block on a bump beside its weight. */
static void kerb(double gap) { bump(gap, draw(0.1, 0.28)); }

/* Makes a block on a bump 2 to 8 errors wide. */
static void sliver(double gap) { bump(gap, draw(2, 8) * true_one.e); }

/* Makes a block on a step narrower than an eighth of its bed. */
static void thin_step(double gap)
{
    const double w = draw(0.8, 1.4);
    step(w * draw(0.03, 0.125), gap);
    box(1, 0, 0, w, draw(0.4, 1.8));
}

/* Makes a ground with a pit, which a stone spans that misses the far lip. */
static void lip_ground(double gap)
{
    const double w = draw(0.6, 1.5), x = w * draw(0.15, 0.48);
    SHAPE(0, -3, -2, 4, -2, 4, 0, w + gap, 0, w + gap, -0.5, x, -0.5, x, 0, -3,
          0);
    box(1, 0, 0, w, draw(0.3, 1));
}

/* Makes the same pit in a free stone. */
static void lip_stone(double gap)
{
    const double w = draw(0.6, 1.5), x = w * draw(0.15, 0.48);
    box(0, -4, -2, 5, -1);
    SHAPE(draw(1, 3), -1, -1, w + 1, -1, w + 1, 0, w + gap, 0, w + gap, -0.5, x,
          -0.5, x, 0, -1, 0);
    box(1, 0, 0, w, draw(0.3, 1));
}

/* Adds a stone on feet of which all but one or two may be short. */
static void feet(double gap, int n)
{
    const double w = draw(0.8, 1.6), h = draw(0.4, 1.2);
    const int tall = draw_count(0, n - 1), other = draw_count(0, n - 1);
    double xy[2 * MOST_CORNERS];
    int i, k = 0;
    for (i = 0; i < n; i++) {
        const double left = i * w / n + (i ? draw(0.1, 0.4) * w / n : 0);
        const double right = (i + 1) * w / n;
        const double y = i == tall || (n > 2 && i == other) ? 0 : gap;
        if (i) {
            xy[k++] = left, xy[k++] = 0.25;
        }
        xy[k++] = left, xy[k++] = y;
        xy[k++] = right - (i + 1 < n ? 0.2 * w / n : 0), xy[k++] = y;
        if (i + 1 < n) {
            xy[k] = xy[k - 2], xy[k + 1] = 0.25;
            k += 2;
        }
    }
    xy[k++] = w, xy[k++] = 0.25 + h;
    xy[k++] = 0, xy[k++] = 0.25 + h;
    flat();
    add(1, xy, k / 2);
}

/* Makes a stone on three to five feet of which some are short. */
static void comb(double gap) { feet(gap, draw_count(3, 5)); }

/* Makes a stone on two feet of which one is short. */
static void table(double gap) { feet(gap, 2); }

/* Makes a block on a ground with four to seven bumps of different height. */
static void rough_bed(double gap)
{
    const int n = draw_count(4, 7);
    const double w = draw(0.8, 1.5), pitch = w / n;
    double xy[2 * MOST_CORNERS];
    int i, k = 0;
    xy[k++] = -3, xy[k++] = -1;
    xy[k++] = 4, xy[k++] = -1;
    xy[k++] = 4, xy[k++] = -gap;
    for (i = n; i-- > 0;) {
        const double x = (i + draw(0, 0.4)) * pitch;
        const double to = x + draw(0.2, 0.5) * pitch;
        const double y = -gap * draw_count(0, 2) / 3.0;
        xy[k++] = to, xy[k++] = -gap - 0.1;
        xy[k++] = to, xy[k++] = y;
        xy[k++] = x, xy[k++] = y;
        xy[k++] = x, xy[k++] = -gap - 0.1;
    }
    xy[k++] = -3, xy[k++] = -gap;
    add(0, xy, k / 2);
    box(1, 0, 0, w, draw(0.4, 1.6));
}

/* Makes a block on a slope steeper than friction. */
static void slope(double gap)
{
    const double w = draw(0.7, 1.5), mu = draw(0.2, 0.8);
    box(0, -4, -1, 4, 0);
    box(1, -w / 2, 0, w / 2, w * draw(0.3, 0.9));
    true_one.friction = mu;
    turn(0, atan(mu) + gap, 0, 0);
}

/* Makes a block on a steep slope above a kerb. */
static void slope_kerb(double gap)
{
    const double w = draw(0.7, 1.5), mu = draw(0.2, 0.5);
    SHAPE(0, -4, -1, 4, -1, 4, 0, -gap, 0, -gap, draw(0.15, 0.4), -4, 0.4);
    box(1, 0, 0, w, w * draw(0.3, 0.8));
    true_one.friction = mu;
    turn(0, atan(mu) + draw(0.02, 0.3), 0, 0);
}

/* Makes a stone on a steep slope with a tongue in a wider groove. */
static void tongue(double gap)
{
    const double w = draw(0.8, 1.4), mu = draw(0.2, 0.5), deep = 0.2;
    const double x = w * draw(0.3, 0.5), to = x + draw(0.15, 0.3);
    SHAPE(0, -4, -1, 4, -1, 4, 0, to + gap, 0, to + gap, -deep - 0.1, x - gap,
          -deep - 0.1, x - gap, 0, -4, 0);
    SHAPE(1, 0, 0, x, 0, x, -deep, to, -deep, to, 0, w, 0, w, draw(0.3, 0.9), 0,
          0.3);
    true_one.friction = mu;
    turn(0, atan(mu) + draw(0.02, 0.3), 0, 0);
}

/* Makes a block that a horizontal force turns over. */
static void side_load(double gap)
{
    const double w = draw(0.4, 1), h = draw(0.5, 1.5), y = h * draw(0.5, 1);
    const double weight = 9.81 * w * h;
    flat();
    box(1, 0, 0, w, h);
    load(weight * (w / 2 + gap) / y, 0, 0, y);
    true_one.friction = 0.9;
}

/* Makes a block with a horizontal force and a step at its toe. */
static void toe_load(double gap)
{
    const double w = draw(0.5, 1), h = draw(0.5, 1.5), y = h * draw(0.5, 1);
    const double inside = draw(6, 40) * true_one.e;
    const double weight = 9.81 * w * h;
    step(w * draw(0.3, 0.9), gap);
    box(1, 0, 0, w, h);
    load(weight * (w / 2 - inside) / y, 0, 0, y);
    true_one.friction = 0.9;
}

/* Makes a block over an edge with a vertical force at its side. */
static void side_weight(double gap)
{
    const double w = draw(0.5, 1), h = draw(0.3, 1), x = w * draw(0.05, 0.3);
    const double weight = 9.81 * w * h;
    box(0, -4, -2, w - x, 0);
    box(1, 0, 0, w, h);
    load(0, -weight * (w / 2 - x + gap) / x, w, h * 0.7);
}

/* Makes a leaning block with its weight 8 to 25 errors from the end of its bed,
   which has a step. */
static void lean_end(double gap)
{
    const double b = draw(0.6, 1.2), inside = draw(8, 25) * true_one.e;
    step(b * draw(0.4, 0.7), gap);
    leaning(b, draw(0.8, 1.6), b - inside);
}

/* Makes a slender leaning block on a step. */
static void leaning_post(double gap)
{
    const double b = draw(0.15, 0.4), h = draw(1, 2), at = draw(0.5, 0.9);
    step(b * draw(0.2, 0.8), gap);
    leaning(b, h, b * at);
    true_one.friction = 0.8;
}

/* Makes a leaning block on a bed 10 to 60 errors wide with a step. */
static void narrow_post(double gap)
{
    const double b = draw(10, 60) * true_one.e, h = draw(0.4, 1);
    cut_step(b * draw(0.1, 0.5), gap);
    leaning(b, h, b * draw(0.5, 0.8));
    true_one.friction = 0.8;
}

/* Makes a block on an apex that is not below its centre. */
static void apex(double gap)
{
    const double w = draw(0.6, 1.4), s = draw(0.3, 1);
    SHAPE(0, -4, -4 * s, 4, -4 * s, 0, 0);
    box(1, gap - w / 2, 0, gap + w / 2, draw(0.2, 0.8));
}

/* Makes a pointed stone in a wider notch. */
static void notch(double gap)
{
    const double s = draw(0.8, 1.2), r = draw(0.4, 0.7), up = draw(0.4, 0.9);
    SHAPE(0, -3, -2, 3, -2, 3, s * r, r + gap, s * r, 0, -gap * s, -r - gap,
          s * r, -3, s * r);
    SHAPE(1, 0, 0, r, s * r, r, s * r + up, -r, s * r + up, -r, s * r);
    true_one.friction = draw(0.2, 0.6);
}

/* Adds a regular polygon of twelve corners, turned by `angle`. */
static void twelve(double density, double x, double y, double r, double angle)
{
    double xy[24];
    int i;
    for (i = 0; i < 12; i++) {
        xy[2 * i] = x + r * cos(angle + 0.5235987755982988 * i);
        xy[2 * i + 1] = y + r * sin(angle + 0.5235987755982988 * i);
    }
    add(density, xy, 12);
}

/* Makes a round stone in a seat of which one side is low. */
static void round_seat(double gap)
{
    const double a = 0.2617993877991494, r = draw(0.4, 0.8), t = tan(a);
    const double down = r; /* cos(a) / cos(a): where the two sides meet */
    SHAPE(0, -4, -2, 0, -2, 0, -down, -2, 2 * t - down, -4, 2 * t - down);
    SHAPE(0, 0, -2, 4, -2, 4, 2 * t - down - gap, 2, 2 * t - down - gap, 0,
          -down - gap);
    twelve(1, 0, 0, r, 0);
    true_one.friction = draw(0.3, 0.8);
}

/* ---- kinds: few stones ---- */

/* Adds n columns with a beam; bit k of `low` makes column k short. `weight` is
   the density of a stone on the right end of the beam; 0: none. */
static void beam_on(int n, int low, double weight, double gap)
{
    const double pitch = draw(0.8, 1.4), h = draw(0.5, 1.2);
    const double over = draw(0, 0.3), top = h + draw(0.15, 0.4);
    double right = 0;
    int i;
    flat();
    for (i = 0; i < n; i++) {
        const double w = draw(0.2, 0.6), x = i * pitch;
        box(draw(1, 3), x, 0, x + w, low >> i & 1 ? h - gap : h);
        right = x + w;
    }
    box(1, -over * draw(0, 1), h, right + over, top);
    if (weight > 0)
        box(weight, right - 0.5, top, right, top + draw(0.4, 1.2));
}

/* Makes a beam on two columns of which one is short. */
static void beam(double gap) { beam_on(2, 2, 0, gap); }
/* Makes a beam on three columns, loaded above an end one that is short. */
static void beam_end(double gap) { beam_on(3, 4, 6, gap); }
/* Makes a beam on three columns of which the middle one is short. */
static void beam_middle(double gap) { beam_on(3, 2, 1, gap); }
/* Makes a beam on three columns of which only the middle one is not short. */
static void beam_ends(double gap) { beam_on(3, 5, 3, gap); }
/* Makes a beam on three columns of which only the left one is not short. */
static void beam_two_low(double gap) { beam_on(3, 6, 1, gap); }

/* Makes a slender post on a beam whose right column is short. */
static void statue(double gap)
{
    const double w = draw(0.8, 1.4), h = draw(0.4, 1), b = draw(0.12, 0.3);
    const double x = w * draw(0.1, 0.9);
    flat();
    box(2, 0, 0, 0.3, h);
    box(2, w, 0, w + 0.3, h - gap);
    box(1, 0, h, w + 0.3, h + 0.25);
    box(1, x, h + 0.25, x + b, h + 0.25 + b * draw(2, 7));
}

/* Makes a tower of blocks on a slab whose bed has a step. */
static void tower_on_slab(double gap)
{
    const double w = draw(0.8, 1.3), b = draw(0.3, 0.5), x = w * draw(0, 0.6);
    double y = 0.3;
    int i, n = draw_count(2, 4);
    step(w * draw(0.1, 0.5), gap);
    box(1, 0, 0, w, y);
    for (i = 0; i < n; i++, y += b)
        box(1, x, y, x + b, y + b);
}

/* Makes a stone on a table of which one leg, a block, is short. */
static void bench(double gap)
{
    const double w = draw(0.8, 1.4), mu = draw(0.1, 0.3), h = draw(0.3, 0.7);
    const double t = tan(atan(mu) - draw(0, 0.08)), c = 0.4 + w * t;
    const double x = draw(0.1, 0.4), b = 0.3;
    flat();
    box(1, 0, 0, 0.25, h);
    box(1, w - 0.25, 0, w, h - gap);
    SHAPE(1, 0, h, w, h, w, h + c - w * t, 0, h + c);
    SHAPE(1, x, h + c - x * t, x + b, h + c - (x + b) * t, x + b,
          h + c + 0.3 - (x + b) * t, x, h + c + 0.3 - x * t);
    true_one.friction = mu;
}

/* Makes a stack of blocks on a slope that is as steep as friction, but less by
   the half of what the support tilts. */
static void slope_stack(double gap)
{
    const double w = draw(0.8, 1.4), mu = draw(0.3, 0.6),
                 x = w * draw(0.2, 0.5);
    const double t = tan(atan(mu) - 0.5 * gap / (w - x)), h = 0.3 + w * t;
    const int n = draw_count(1, 3);
    int i;
    step(x, gap);
    SHAPE(2, 0, 0, w, 0, w, h - w * t, 0, h);
    for (i = 0; i < n; i++) {
        const double y = h + 0.25 * i;
        SHAPE(1, 0.1, y - 0.1 * t, w - 0.1, y - (w - 0.1) * t, w - 0.1,
              y + 0.25 - (w - 0.1) * t, 0.1, y + 0.25 - 0.1 * t);
    }
    true_one.friction = mu;
}

/* Makes a beam on two apexes of which one is low. */
static void apexes(double gap)
{
    const double w = draw(0.8, 1.6), at = w * draw(0.55, 0.95);
    SHAPE(0, -1, -1, 1.2 * w + 0.3, -1, at + 0.2, -0.4, at, -gap, at - 0.1,
          -0.4, 0.35 * w, -0.4, 0.2 * w, 0, 0, -0.5);
    box(1, 0, 0, w, draw(0.2, 0.7));
}

/* Adds a tower of n blocks. */
static void tower_of(int n, double w, double h)
{
    double y = 0;
    int i;
    for (i = 0; i < n; i++) {
        const double x = i ? w * draw(-0.04, 0.04) : 0, t = h * draw(0.7, 1.3);
        box(draw(1, 2), x, y, x + w, y + t);
        y += t;
    }
}

/* Makes a tower on a step. */
static void tower(double gap)
{
    const int n = draw_count(2, 6);
    const double w = draw(0.4, 0.8);
    step(w * draw(0.2, 0.7), gap);
    tower_of(n, w, w * draw(0.6, 1.2));
}

/* Makes a tower of squat blocks on a step of two grounds. */
static void squat_tower(double gap)
{
    const int n = draw_count(4, 8);
    const double w = draw(0.7, 1.2);
    cut_step(w * draw(0.2, 0.6), gap);
    tower_of(n, w, w * draw(0.2, 0.4));
}

/* Makes a tower that lacks half of its bed beside another block. */
static void tower_neighbour(double gap)
{
    const double w = draw(0.4, 0.7), side = w + draw(1, 8) * true_one.e;
    const double b = draw(0.2, 0.5), h = draw(1, 2);
    SHAPE(0, -6, -2, 6, -2, 6, 0, side - true_one.e / 2, 0,
          side - true_one.e / 2, -gap, w * draw(0.2, 0.48), -gap, w * 0.15, 0,
          -6, 0);
    tower_of(draw_count(2, 4), w, w);
    box(draw(1, 3), side, 0, side + b, h);
}

/* Makes a tower of leaning blocks. */
static void leaning_tower(double gap)
{
    const int n = draw_count(2, 4);
    const double b = draw(0.4, 0.7), h = draw(0.3, 0.5), s = draw(0.02, 0.08);
    int i;
    step(b * draw(0.2, 0.6), gap);
    for (i = 0; i < n; i++) {
        const double x = i * s, y = i * h;
        SHAPE(1, x, y, x + b, y, x + b + s, y + h, x + s, y + h);
    }
    true_one.friction = 0.8;
}

/* Makes a wide block on a narrow one. */
static void tee(double gap)
{
    const double b = draw(0.25, 0.5), w = draw(0.5, 0.9), h = draw(0.3, 0.8);
    const double x = draw(-0.05, 0.05);
    cut_step(b * draw(0.1, 0.48), gap);
    box(1, 0, 0, b, h);
    box(1, b / 2 - w + x, h, b / 2 + w + x, h + draw(0.2, 0.5));
    true_one.friction = 0.8;
}

/* Makes a block with a narrow waist. */
static void hourglass(double gap)
{
    const double b = draw(0.4, 0.8), h = draw(0.8, 1.6),
                 in = b * draw(0.2, 0.35);
    const double x = b * draw(0.25, 0.7);
    SHAPE(0, -6, -2, 6, -2, 6, 0, x + 0.1, 0, x + 0.1, -gap, -0.1, -gap, -0.1,
          0, -6, 0);
    SHAPE(1, 0, 0, x, 0, x, gap, x + 0.05, gap, x + 0.05, 0, b, 0, b - in,
          h / 2, b, h, 0, h, in, h / 2);
}

/* Makes a slab on two rollers, one of which is smaller. */
static void rollers(double gap)
{
    const double r = draw(0.25, 0.4), w = draw(0.9, 1.5),
                 a = 0.2617993877991494;
    const double low = r - gap / (2 * cos(a));
    flat();
    twelve(1, 0, r * cos(a), r, a);
    twelve(1, w, low * cos(a), low, a);
    box(1, -0.2, 2 * r * cos(a), w + 0.2, 2 * r * cos(a) + draw(0.15, 0.4));
    true_one.friction = 0.7;
}

/* Makes a leaning block that a thin shim under its low side holds. */
static void shim(double gap)
{
    const double b = draw(0.5, 0.9), h = draw(0.6, 1.2), t = 0.15;
    const double x = b * draw(0.55, 0.85);
    SHAPE(0, -6, -2, 6, -2, 6, -t, b * 0.45, -t, b * 0.45, 0, -6, 0);
    box(2, x, -t, x + draw(0.1, 0.3), -gap);
    leaning(b, h, b * draw(0.5, 0.7));
    true_one.friction = 0.7;
}

/* Makes a tower whose second block has a step in its bed. */
static void tower_middle(double gap)
{
    const double w = draw(0.5, 0.9), h = draw(0.3, 0.6),
                 x = w * draw(0.2, 0.48);
    flat();
    box(1, 0, 0, w, h);
    SHAPE(1, 0, h, x, h, x, h + gap, w, h + gap, w, 2 * h, 0, 2 * h);
    box(1, 0, 2 * h, w, 3 * h);
    box(1, 0, 3 * h, w, 4 * h);
}

/* Makes two posts with a lintel on a slab on a stem that lacks a part of its
   bed. */
static void frame_stem(double gap)
{
    const double b = draw(0.3, 0.6), up = draw(0.5, 1.2), w = draw(0.5, 0.8);
    const double h = draw(0.4, 1), y = up + 0.2;
    cut_step(draw(-0.1, 0.2) * b, gap);
    box(1, -b / 2, 0, b / 2, up);
    box(1, -w, up, w, y);
    box(1, -w, y, 0.25 - w, y + h);
    box(1, w - 0.25, y, w, y + h);
    box(1, -w, y + h, w, y + h + 0.2);
}

/* Makes a portal of which all columns lack the same side of their beds. */
static void portal_side(double gap)
{
    const int n = draw_count(2, 3);
    const double w = draw(0.15, 0.35), h = draw(0.8, 1.6), p = draw(0.8, 1.3);
    const double part = draw(0.25, 0.6);
    int i;
    box(0, -6, -2, 6, -gap);
    for (i = 0; i < n; i++)
        box(0, i * p - 0.2, -1, i * p + part * w, 0);
    for (i = 0; i < n; i++)
        box(1, i * p, 0, i * p + w, h);
    box(1, 0, h, (n - 1) * p + w, h + draw(0.15, 0.3));
    true_one.friction = 0.7;
}

/* Makes a portal of two storeys of which both columns lack the same side of
   their beds. */
static void storeys(double gap)
{
    const double w = draw(0.2, 0.35), h = draw(0.6, 1), p = draw(0.8, 1.3);
    const double part = w * draw(0.25, 0.6), up = h + 0.2;
    int i;
    box(0, -6, -2, part, 0);
    box(0, part, -2, p - 0.2, -gap);
    box(0, p - 0.2, -2, p + part, 0);
    box(0, p + part, -2, 6, -gap);
    for (i = 0; i < 2; i++) {
        box(1, 0, i * up, w, i * up + h);
        box(1, p, i * up, p + w, i * up + h);
        box(1, 0, i * up + h, p + w, (i + 1) * up);
    }
    true_one.friction = 0.7;
}

/* Makes a portal on a slab on a step. */
static void frame_on_slab(double gap)
{
    const double w = draw(0.8, 1.4), h = draw(0.5, 1.2), b = draw(0.15, 0.25);
    step(w * draw(0.1, 0.5), gap);
    box(1, 0, 0, w, 0.25);
    box(1, 0, 0.25, b, h);
    box(1, w - b, 0.25, w, h);
    box(1, 0, h, w, h + 0.2);
    true_one.friction = 0.7;
}

/* Makes a stone on the sloped top of a block on a step, nearly as steep as
   friction. */
static void sloped_top(double gap)
{
    const double w = draw(0.8, 1.4), h = draw(0.4, 0.8), mu = draw(0.2, 0.4);
    const double t = tan(atan(mu) - draw(0, 0.06)), b = w * draw(0.3, 0.5);
    step(w * draw(0.1, 0.5), gap);
    SHAPE(1, 0, 0, w, 0, w, h, b, h + (w - b) * t, 0, h + (w - b) * t);
    SHAPE(1, b, h + (w - b) * t, w, h, w, h + 0.3, b, h + 0.3 + (w - b) * t);
    true_one.friction = mu;
}

/* Makes a small stone on a slope nearly as steep as friction, which tilts on
   its step. */
static void tilted_support(double gap)
{
    const double w = draw(0.8, 1.4), mu = draw(0.2, 0.5);
    const double t = tan(atan(mu) - draw(0, 0.1)), c = sqrt(1 + t * t);
    const double h = 0.3, from = w * draw(0.25, 0.5), b = draw(0.25, 0.4);
    const double top = h + (w - from) * t;
    step(w * draw(0.1, 0.5), gap);
    SHAPE(2, 0, 0, w, 0, w, h, 0, h + w * t);
    SHAPE(1, from, top, from + b / c, top - b * t / c,
          from + b / c + 0.3 * t / c, top - b * t / c + 0.3 / c,
          from + 0.3 * t / c, top + 0.3 / c);
    true_one.friction = mu;
}

/* Makes a lintel that reaches only the chamfer of its second support. */
static void lintel_chamfer(double gap)
{
    const double w = draw(0.8, 1.6), c = draw(0.1, 0.3);
    box(0, -2, -2, draw(0.1, 0.3), 0);
    SHAPE(0, w + gap - c, -2, 4, -2, 4, 0, w + gap, 0, w + gap - c,
          -c * draw(0.8, 2));
    box(1, 0, 0, w, draw(0.2, 0.5));
    true_one.friction = draw(0.2, 0.8);
}

/* Makes a cantilever whose counterweight is too light. */
static void cantilever(double gap)
{
    const double back = draw(0.5, 1), out = back + draw(0.2, 0.6);
    const double h = draw(0.15, 0.3), c = draw(0.2, 0.5), tall = draw(0.3, 0.8);
    const double at = (out - back) / 2, with = c / 2 - back;
    const double mass = (back + out) * h * (at - gap) / (gap - with);
    box(0, -4, -2, 0, 0);
    box(1, -back, 0, out, h);
    box(mass / (c * tall), -back, h, c - back, h + tall);
}

/* Makes a stack in which one block is beyond the edge of the block below. */
static void corbel(double gap)
{
    const int n = draw_count(3, 5), bad = draw_count(1, n - 1);
    const double w = draw(0.6, 1.2), h = draw(0.2, 0.4);
    double x = 0, sum = 0;
    int i;
    for (i = 0; i < n; i++) {
        box(1, x, -h * i, x + w, h - h * i);
        sum += x + w / 2;
        x = sum / (i + 1) + (i + 1 == bad ? -gap : draw(0.04, 0.2) * w) - w;
    }
    box(0, -8, -h * (n - 1) - 1, x + w + (bad == n ? 0 : 0.05), -h * (n - 1));
}

/* Makes a plank on a post that falls to a block beside it. */
static void seesaw(double gap)
{
    const double w = draw(0.3, 0.6), left = draw(0.8, 1.2);
    const double right = left + draw(0.05, 0.3), h = draw(0.6, 1);
    flat();
    box(1, -w / 2, 0, w / 2, h);
    box(draw(0.5, 1), -left, h, right + 0.8, h + 0.2);
    box(1, -left - 0.6 - gap, 0, -left - gap, h + 1);
}

/* Makes a stone whose tail is off the ledge above it. */
static void hook(double gap)
{
    const double w = draw(0.8, 1.3), x = draw(0.2, 0.35) * w,
                 h = draw(0.2, 0.6);
    SHAPE(0, -3, -1, 0, -1, 0, 1, -x, 1, -x, 1.2, -3, 1.2);
    box(1, gap - x, 1, gap - x + w, 1 + h);
}

/* Makes a loaded lever on two columns of which one is short. */
static void strut(double gap)
{
    const double x = draw(1.8, 2.4), w = draw(0.3, 0.6), h = draw(0.8, 1.4);
    flat();
    box(1, 0, 0, 1, h);
    box(1, x, 0, x + w, h - gap);
    box(1, draw(0.4, 0.8), h, 3.2, h + 0.4);
    box(draw(0.5, 2), 2.2, h + 0.4, 3.2, h + 1.4);
}

/* Makes a loaded lever that ends before its second column. */
static void missed_prop(double gap)
{
    const double w = draw(1, 1.4), h = draw(0.8, 1.2), x = draw(0.3, 0.6);
    const double tall = draw(0.6, 1);
    flat();
    box(1, -0.5, 0, 0.5, h);
    box(1, w + gap, 0, w + 0.8, h);
    box(1, -0.3, h, w, h + 0.3);
    box(draw(1, 3), x, h + 0.3, w, h + 0.3 + tall);
}

/* Makes a slab that leans to a buttress at a distance. */
static void buttress(double gap)
{
    const double b = draw(0.2, 0.4), h = draw(1, 1.8), over = draw(0.02, 0.1);
    const double s = b + 2 * over, y = h * draw(0.4, 0.9), side = b + s * y / h;
    flat();
    SHAPE(1, 0, 0, b, 0, b + s, h, s, h);
    box(2, side + gap, 0, side + gap + draw(0.4, 0.8), y);
    true_one.friction = 0.8;
}

/* Makes leaning slabs at a distance from each other and from a buttress. */
static void dominoes(double gap)
{
    const int n = draw_count(2, 4);
    const double b = draw(0.2, 0.35), h = draw(0.8, 1.2), s = b + draw(0, 0.1);
    int i;
    flat();
    for (i = 0; i < n; i++) {
        const double x = i * (b + gap);
        SHAPE(1, x, 0, x + b, 0, x + b + s, h, x + s, h);
    }
    box(3, n * (b + gap) + s, 0, n * (b + gap) + s + 0.8, h * 1.1);
    true_one.friction = 0.8;
}

/* Makes a plank against a wall whose foot is off its stop. */
static void ladder(double gap)
{
    const double h = draw(0.8, 1.4), s = draw(0.4, 0.9), t = draw(0.08, 0.2);
    SHAPE(0, -4, -1, 4, -1, 4, 0, s + t + gap, 0, -4, 0);
    box(0, s + t + gap, 0, s + t + 0.8, 0.3);
    box(0, -3, 0, 0, 3);
    SHAPE(1, s, 0, s + t, 0, t, h, 0, h * 1.1);
    true_one.friction = draw(0.1, 0.3);
}

/* Makes two slabs that lean towards each other. */
static void lean_pair(double gap)
{
    const double s = draw(0.3, 0.6), t = draw(0.15, 0.4), g = gap / 2;
    const double low = draw(0.6, 1), high = low + draw(0.15, 0.3);
    flat();
    SHAPE(1, -s - t, 0, -s, 0, -g, low, -g, high);
    SHAPE(1, s, 0, s + t, 0, g, high, g, low);
    true_one.friction = draw(0.6, 0.9);
}

/* Makes two blocks over edges that meet in the middle. */
static void bridge(double gap)
{
    const double w = draw(0.6, 1.2), h = draw(0.2, 0.6),
                 over = draw(0.01, 0.08);
    const double g = gap / 2;
    box(0, -4, -2, -w / 2 - over - g, 0);
    box(0, w / 2 + over + g, -2, 4, 0);
    box(1, -w - g, 0, -g, h);
    box(1, g, 0, w + g, h);
    true_one.friction = 0.8;
}

/* Makes a block that two others should hold by friction. */
static void squeezed(double gap)
{
    const double w = draw(0.4, 0.9), b = draw(0.4, 1), h = draw(0.6, 1.2);
    box(0, -4, -2, 0, 0);
    box(0, w + gap, -2, 5, 0);
    box(3, -b, 0, 0, h);
    box(3, w + gap, 0, w + gap + b, h);
    box(1, gap / 2, 0.1, w + gap / 2, h);
    true_one.friction = 0.8;
}

/* Makes a sloped slab on two columns of which one is short. */
static void lean_roof(double gap)
{
    const double h = draw(0.8, 1.2), w = draw(1, 1.6), t = draw(0.15, 0.3);
    const double b = draw(0.2, 0.4), s = draw(0.1, 0.4), end = h - w * s;
    const double low = end - gap;
    flat();
    SHAPE(1, 0, 0, b, 0, b, h - b * s, 0, h);
    SHAPE(1, w - b, 0, w, 0, w, low, w - b, low + b * s);
    SHAPE(1, 0, h, w, end, w, end + t, 0, h + t);
    true_one.friction = 0.7;
}

/* Makes three round stones between walls that are too far apart. */
static void pile(double gap)
{
    const double r = draw(0.3, 0.6), a = r * cos(0.2617993877991494);
    box(0, -5, -2, 5, -a);
    box(0, -4, -a, -2 * a - gap, 3);
    box(0, 2 * a, -a, 4, 3);
    twelve(1, -a - gap, 0, r, 0.2617993877991494);
    twelve(1, a, 0, r, 0.2617993877991494);
    twelve(1, -gap / 2, 2 * a * 0.8660254037844386 + gap / 10, r,
           0.2617993877991494);
    true_one.friction = draw(0.2, 0.6);
}

/* ---- kinds: arches and walls ---- */

struct arch {
    int n;
    double inner, outer, from, to;
    int at;     /* voussoir at fault; -1: none            */
    double cut; /* it is thinner by that at its right joint */
    double up;  /* it lies higher by that                 */
    double spread;
};

/* Adds n voussoirs from the left to the right springer, and the springers. */
static void arch_of(const struct arch *a)
{
    const double x0 = a->outer * cos(a->from), x1 = a->outer * cos(a->to);
    const double c0 = cos(a->from), s0 = sin(a->from), c1 = cos(a->to);
    const double s1 = sin(a->to), low = a->inner * s0 - 0.5;
    int i;
    SHAPE(0, x0 - 1, low, a->inner * c0, low, a->inner * c0, a->inner * s0, x0,
          a->outer * s0, x0 - 1, a->outer * s0);
    SHAPE(0, a->inner * c1 + a->spread, low, x1 + 1, low, x1 + 1, a->outer * s1,
          x1 + a->spread, a->outer * s1, a->inner * c1 + a->spread,
          a->inner * s1);
    for (i = 0; i < a->n; i++) {
        const double p = a->from + (a->to - a->from) * i / a->n;
        const double q = a->from + (a->to - a->from) * (i + 1) / a->n;
        const double cut = i == a->at ? a->cut : 0;
        const double up = i == a->at ? a->up : 0;
        const double dx = -cut * sin(q), dy = cut * cos(q);
        SHAPE(1, a->inner * cos(p), a->inner * sin(p) + up,
              a->inner * cos(q) + dx, a->inner * sin(q) + dy + up,
              a->outer * cos(q) + dx, a->outer * sin(q) + dy + up,
              a->outer * cos(p), a->outer * sin(p) + up);
    }
}

/* Returns an arch without fault, with an odd number of voussoirs. */
static struct arch draw_arch(int least, int most)
{
    const double low = draw(0, 0.6);
    struct arch a = {0, 1, 1, 3.14159265358979323846, 0, -1, 0, 0, 0};
    a.n = 2 * draw_count(least / 2, most / 2) + 1;
    a.outer = 1 + draw(0.18, 0.4);
    a.from -= low;
    a.to = low;
    true_one.friction = draw(0.6, 0.9);
    return a;
}

/* Makes an arch of which one voussoir is too thin. */
static void arch_short(double gap)
{
    struct arch a = draw_arch(5, 11);
    a.at = draw_count(0, a.n - 1);
    a.cut = gap;
    arch_of(&a);
}

/* Makes an arch of which one abutment has moved. */
static void arch_spread(double gap)
{
    struct arch a = draw_arch(5, 11);
    a.spread = gap;
    arch_of(&a);
}

/* Makes an arch of which the key lies too high. */
static void arch_key(double gap)
{
    struct arch a = draw_arch(5, 11);
    a.at = a.n / 2;
    a.up = gap;
    arch_of(&a);
}

/* Makes a flat arch of three stones between abutments that have moved. */
static void flat_arch(double gap)
{
    const double t = draw(0.1, 0.35), h = draw(0.5, 1), w = draw(0.8, 1.2);
    const double end = 0.5 + w + gap / 2;
    box(0, -5, -1, -end, h);
    box(0, end, -1, 5, h);
    SHAPE(1, -0.5 - w, 0, -0.5, 0, -0.5 - t * h, h, -0.5 - w, h);
    SHAPE(1, -0.5, 0, 0.5, 0, 0.5 + t * h, h, -0.5 - t * h, h);
    SHAPE(1, 0.5, 0, 0.5 + w, 0, 0.5 + w, h, 0.5 + t * h, h);
    true_one.friction = 0.8;
}

/* Makes an arch on two piers, of which one lacks a part of its bed. */
static void pier_arch(double gap)
{
    const int n = 2 * draw_count(3, 6) + 1;
    const double outer = 1 + draw(0.25, 0.4), w = draw(0.6, 1),
                 h = draw(0.4, 1);
    const double pi = 3.14159265358979323846;
    const double part = w * draw(0.3, 0.6);
    int i;
    box(0, -6, -2, -0.5, -h);
    box(0, -0.5, -2, 1 + part, -h);
    box(0, 1 + part, -2, 6, -h - gap);
    box(1, -1 - w, -h, -1, 0);
    box(1, 1, -h, 1 + w, 0);
    for (i = 0; i < n; i++) {
        const double p = pi - pi * i / n, q = pi - pi * (i + 1) / n;
        SHAPE(1, cos(p), sin(p), cos(q), sin(q), outer * cos(q), outer * sin(q),
              outer * cos(p), outer * sin(p));
    }
    true_one.friction = 0.7;
}

/* Adds a pyramid of n rows; bit i of `low` makes block i of the base lower. */
static void pyramid_of(int n, int low, double gap)
{
    const double w = draw(0.7, 1.1), h = draw(0.3, 0.6), joint = 0.05;
    int i, k;
    flat();
    for (k = 0; k < n; k++)
        for (i = 0; i < n - k; i++) {
            const double x = (i + 0.5 * k) * (w + joint);
            const double top = (k + 1) * h - (k == 0 && low >> i & 1 ? gap : 0);
            box(1, x, k * h, x + w, top);
        }
}

/* Makes a pyramid of which some blocks of the base are low. */
static void pyramid(double gap)
{
    const int n = draw_count(3, 4);
    pyramid_of(n, draw_count(1, (1 << n) - 2), gap);
}

/* Adds a wall in running bond. Stone `low`, counted in rows, is lower by the
   gap. The head joints are `joint` wide. */
static void wall_of(int rows, int columns, double joint, int low, double gap)
{
    const double w = draw(0.8, 1.3), h = draw(0.4, 0.7);
    int i, k, n = 0;
    for (k = 0; k < rows; k++) {
        const int halves = k % 2;
        for (i = 0; i < columns + halves; i++, n++) {
            const int first = halves && i == 0, last = halves && i == columns;
            const double x = (i - 0.5 * halves) * w;
            const double left = first ? 0 : x + joint / 2;
            const double right = last ? columns * w : x + w - joint / 2;
            box(1, left, k * h, right, (k + 1) * h - (n == low ? gap : 0));
        }
    }
}

/* Makes a wall in which one stone of the two lowest courses is low. */
static void courses(double gap)
{
    const int columns = draw_count(3, 4), rows = draw_count(3, 4);
    const int open = draw_count(0, 1), low = draw_count(0, 2 * columns);
    flat();
    wall_of(rows, columns, open * 0.06, low, gap);
}

/* Makes a wall on a ground with a step. */
static void scour(double gap)
{
    cut_step(draw(0.5, 2.5), gap);
    wall_of(draw_count(3, 4), 3, 0.06, -1, 0);
}

/* Makes a wall whose last bricks hang over the end of the ground. */
static void wall_end(double gap)
{
    const double w = draw(0.8, 1.2), h = draw(0.3, 0.6),
                 over = w * draw(0.4, 0.5);
    int k;
    box(0, -6, -2, 2 * w - over, 0);
    box(0, 2 * w - over, -2, 6, -gap);
    for (k = 0; k < 3; k++) {
        const double x = k % 2 ? w / 2 : 0;
        box(1, x, k * h, x + w - 0.03, (k + 1) * h);
        box(1, x + w, k * h, 2 * w, (k + 1) * h);
    }
}

/* Adds n piers with lintels; pier `low` is lower by the gap. */
static void piers_of(int n, int low, double gap)
{
    const double w = draw(0.3, 0.5), p = draw(0.9, 1.3), h = draw(0.6, 1.2);
    int i;
    box(0, -1, -2, n * p + 1, 0);
    for (i = 0; i < n; i++)
        box(1, i * p, 0, i * p + w, h - (i == low ? gap : 0));
    for (i = 0; i + 1 < n; i++)
        box(1, i * p + (i ? w / 2 + 0.02 : 0), h,
            (i + 1) * p + (i + 2 < n ? w / 2 - 0.02 : w), h + 0.3);
}

/* Makes a row of piers of which one is low, with lintels. */
static void piers(double gap)
{
    const int n = draw_count(3, 5);
    piers_of(n, draw_count(0, n - 1), gap);
}

/* ---- kinds that stand ---- */

/* Makes a wall in running bond with closed head joints. */
static void bricks_closed(double gap)
{
    flat();
    wall_of(draw_count(3, 8), 4, 0, -1, gap);
}

/* Makes a wall in running bond with open head joints. */
static void bricks_open(double gap)
{
    flat();
    wall_of(draw_count(3, 8), 4, 0.06, -1, gap);
}

/* Makes an arch of 7 to 13 voussoirs. */
static void small_arch(double gap)
{
    struct arch a = draw_arch(7, 13);
    a.cut = gap; /* of no voussoir */
    arch_of(&a);
}

/* Makes an arch of 15 to 27 voussoirs. */
static void large_arch(double gap)
{
    struct arch a = draw_arch(15, 27);
    a.cut = gap; /* of no voussoir */
    arch_of(&a);
}

/* Makes a pyramid of three to five rows. */
static void whole_pyramid(double gap) { pyramid_of(draw_count(3, 5), 0, gap); }

/* Makes a beam on two columns. */
static void portal(double gap) { beam_on(2, 0, 0, gap); }

/* Makes a row of piers with lintels. */
static void lintels(double gap) { piers_of(draw_count(3, 6), -1, gap); }

/* Makes a tower. */
static void lone_tower(double gap)
{
    const int n = draw_count(2, 6);
    const double w = draw(0.5, 0.9);
    (void)gap;
    flat();
    tower_of(n, w, w * draw(0.5, 1));
}

/* Makes courses of irregular stones a little above each other, which must come
   to rest. */
static void rubble(double gap)
{
    const int rows = draw_count(2, 4), columns = draw_count(3, 4);
    int i, k, n;
    (void)gap;
    flat();
    for (k = 0; k < rows; k++)
        for (i = 0; i < columns - k % 2; i++) {
            const double x = 0.9 * i + 0.45 * (k % 2), y = 0.55 * k;
            double xy[8] = {x + 0.02, y,       x + 0.88, y,
                            x + 0.88, y + 0.5, x + 0.02, y + 0.5};
            for (n = 0; n < 8; n++)
                xy[n] += draw(0, 0.05) * (n == 0 || n == 6 || n < 4 ? 1 : -1);
            add(draw(1, 2), xy, 4);
        }
    true_one.friction = 0.6;
}

struct kind {
    const char *name;
    void (*make)(double gap);
};

static const struct kind kind[] = {{"slot", slot},
                                   {"wedge", wedge},
                                   {"plank", plank},
                                   {"half", half},
                                   {"wide-low", wide_low},
                                   {"near-low", near_low},
                                   {"far-low", far_low},
                                   {"bed-step", bed_step},
                                   {"cut-bed-step", cut_bed_step},
                                   {"kerb", kerb},
                                   {"sliver", sliver},
                                   {"thin-step", thin_step},
                                   {"lip-ground", lip_ground},
                                   {"lip-stone", lip_stone},
                                   {"comb", comb},
                                   {"table", table},
                                   {"rough-bed", rough_bed},
                                   {"slope", slope},
                                   {"slope-kerb", slope_kerb},
                                   {"tongue", tongue},
                                   {"side-load", side_load},
                                   {"toe-load", toe_load},
                                   {"side-weight", side_weight},
                                   {"lean-end", lean_end},
                                   {"leaning-post", leaning_post},
                                   {"narrow-post", narrow_post},
                                   {"apex", apex},
                                   {"notch", notch},
                                   {"round-seat", round_seat},
                                   {"beam", beam},
                                   {"beam-end", beam_end},
                                   {"beam-middle", beam_middle},
                                   {"beam-ends", beam_ends},
                                   {"beam-two-low", beam_two_low},
                                   {"statue", statue},
                                   {"tower-on-slab", tower_on_slab},
                                   {"bench", bench},
                                   {"slope-stack", slope_stack},
                                   {"apexes", apexes},
                                   {"tower", tower},
                                   {"squat-tower", squat_tower},
                                   {"tower-neighbour", tower_neighbour},
                                   {"leaning-tower", leaning_tower},
                                   {"tee", tee},
                                   {"hourglass", hourglass},
                                   {"rollers", rollers},
                                   {"shim", shim},
                                   {"tower-middle", tower_middle},
                                   {"frame-stem", frame_stem},
                                   {"portal-side", portal_side},
                                   {"storeys", storeys},
                                   {"frame-on-slab", frame_on_slab},
                                   {"sloped-top", sloped_top},
                                   {"tilted-support", tilted_support},
                                   {"lintel-chamfer", lintel_chamfer},
                                   {"cantilever", cantilever},
                                   {"corbel", corbel},
                                   {"seesaw", seesaw},
                                   {"hook", hook},
                                   {"strut", strut},
                                   {"missed-prop", missed_prop},
                                   {"buttress", buttress},
                                   {"dominoes", dominoes},
                                   {"ladder", ladder},
                                   {"lean-pair", lean_pair},
                                   {"bridge", bridge},
                                   {"squeezed", squeezed},
                                   {"lean-roof", lean_roof},
                                   {"pile", pile},
                                   {"arch-short", arch_short},
                                   {"arch-spread", arch_spread},
                                   {"arch-key", arch_key},
                                   {"flat-arch", flat_arch},
                                   {"pier-arch", pier_arch},
                                   {"pyramid", pyramid},
                                   {"wall-end", wall_end},
                                   {"courses", courses},
                                   {"scour", scour},
                                   {"piers", piers}};

/* What stands; the rubble first comes to rest. */
static const struct kind stands[] = {{"bricks-closed", bricks_closed},
                                     {"bricks-open", bricks_open},
                                     {"small-arch", small_arch},
                                     {"large-arch", large_arch},
                                     {"pyramid", whole_pyramid},
                                     {"portal", portal},
                                     {"lintels", lintels},
                                     {"tower", lone_tower},
                                     {"rubble", rubble}};

/* ---- truth ---- */

/* Returns how far the vertex of a block that moved farthest has moved. */
static double motion_of(const struct rigid_world *w)
{
    double most = 0;
    int i, k;
    for (i = 0; i < true_one.blocks; i++) {
        const kern_block *b = &true_one.block[i];
        const struct rigid_block *to = &w->block[i];
        for (k = 0; k < b->vertices && !b->fixed; k++) {
            const double x = (double)b->vertex[k].x, y = (double)b->vertex[k].y;
            const double u = x - (double)b->centre.x;
            const double v = y - (double)b->centre.y;
            const double dx = to->at.x + to->turn.x * u - to->turn.y * v - x;
            const double dy = to->at.y + to->turn.y * u + to->turn.x * v - y;
            most = fmax(most, hypot(dx, dy));
        }
    }
    return most;
}

/* Fills a world with the blocks of the true structure. */
static void fill_world(struct rigid_world *w)
{
    struct rigid_pt v[MOST_CORNERS];
    int i, k;
    rigid_init(w);
    w->friction = true_one.friction;
    w->step = 1.0 / 480;
    w->substeps = 8;
    w->slop = 0.001;
    for (i = 0; i < true_one.blocks; i++) {
        const kern_block *b = &true_one.block[i];
        const struct rigid_pt at = {(double)b->centre.x, (double)b->centre.y};
        for (k = 0; k < b->vertices; k++)
            v[k] = rigid_vec((double)b->vertex[k].x, (double)b->vertex[k].y);
        rigid_add(w, v, b->vertices, b->fixed ? 0 : (double)b->mass, at);
        w->block[i].force = rigid_vec((double)b->load.fx, (double)b->load.fy);
        w->block[i].torque = (double)b->load.torque;
    }
}

/* Lets the true structure move until it rests or has fallen. Returns how far it
   moved. With `rests` its joints carry load from the beginning. It rests if no
   vertex moves by a hundredth of an error in three quarters of a second, and
   has fallen if it moves by a mean size. */
static double simulate(struct rigid_world *w, double e, int rests)
{
    enum { EVERY = 120, MOST_CHECKS = 40, STILL = 3 };
    double last = 0, now = 0;
    int i, check, still = 0;
    fill_world(w);
    if (rests)
        rigid_settle(w);
    for (check = 0; check < MOST_CHECKS && still < STILL; check++) {
        for (i = 0; i < EVERY && rigid_step(w) == 0; i++)
            ;
        now = motion_of(w);
        still = fabs(now - last) < 0.01 * e ? still + 1 : 0;
        last = now;
        if (now > true_one.size)
            break;
    }
    return now;
}

/* Returns the true motion of the structure. */
static double true_motion(double e, int rests)
{
    struct rigid_world w;
    const double moved = simulate(&w, e, rests);
    rigid_free(&w);
    return moved;
}

/* ---- measuring ---- */

/* Adds noise of standard deviation e to the true structure. Returns 0 if a
   polygon is refused. */
static int disturb(double e)
{
    int i, k;
    seen.blocks = true_one.blocks;
    for (i = 0; i < seen.blocks; i++) {
        const kern_block *b = &true_one.block[i];
        const double own = b->fixed ? sqrt(fabs((double)b->area))
                                    : true_one.size;
        const double angle = e / own * gauss();
        const double x = (double)b->centre.x, y = (double)b->centre.y;
        const double dx = x + e * gauss(), dy = y + e * gauss();
        seen.shape[i] = true_one.shape[i];
        for (k = 0; k < b->vertices; k++) {
            const double u = (double)b->vertex[k].x - x;
            const double v = (double)b->vertex[k].y - y;
            kern_vec *to = &seen.vertex[seen.shape[i].first + k];
            to->x = (kern_real)(dx + u * cos(angle) - v * sin(angle)
                                + e / 2 * gauss());
            to->y = (kern_real)(dy + u * sin(angle) + v * cos(angle)
                                + e / 2 * gauss());
        }
        if (make_block(&seen, i) < 0)
            return 0;
        seen.block[i].load = b->load;
    }
    return 1;
}

/* Calls kern_certain() for the measured structure. Returns its verdict, or
   KERN_OK if the structure falls as measured. */
static kern_status ask(double e, kern_interval *in)
{
    kern_options options = kern_defaults();
    kern_work work = kern_work_of(real, reals, integer, integers);
    kern_task task = kern_task_of(seen.block, seen.blocks, contact, 0, &work);
    kern_margin margin;
    kern_status status;
    options.mu = (kern_real)true_one.friction;
    task.options = kern_measured_options(&options, (kern_real)e,
                                         (kern_real)(e / true_one.size));
    task.s.contacts = kern_contacts(seen.block, seen.blocks, &task.options,
                                    contact, MOST_CONTACTS, &work);
    if (task.s.contacts < 0)
        return (kern_status)task.s.contacts;
    status = kern_measure(&task, &margin, NULL);
    if (status < 0)
        return status;
    return kern_certain(&task, margin.margin, in, again, MOST_CONTACTS);
}

/* Makes a structure of a kind. Returns 0 if a polygon of it is refused. */
static int make_one(const struct kind *k, int gap, int seed, double error)
{
    struct structure *t = &true_one;
    int pass, flip = 0;
    double lack = 1e-3;
    t->e = error;
    for (pass = 0; pass < 2; pass++) {
        t->blocks = t->vertices = 0;
        t->friction = 0.5;
        begin_random(k->name, gap, seed, 0);
        flip = draw_count(0, 1);
        k->make(lack);
        if (flip)
            mirror();
        if (!make_blocks()) {
            fprintf(stderr, "misses: %s %d: no polygon\n", k->name, seed);
            return 0;
        }
        t->e = error * t->size;
        lack = gap < 0 ? 0 : gap_errors[gap] * t->e;
    }
    return 1;
}

/* Adds a status of the calls for one copy to the score. Returns 1 if the copy
   is said to stand for certain. */
static int count_status(kern_status status, struct score *to)
{
    to->asked++;
    to->overlaps += status == KERN_OVERLAP;
    to->refused += status < 0 && status != KERN_OVERLAP;
    to->certain += status == KERN_STANDS;
    return status == KERN_STANDS;
}

/* ---- tables ---- */

static double percent(long part, long whole)
{
    return whole ? 100.0 * (double)part / (double)whole : 0;
}

static void add_score(struct score *to, const struct score *s)
{
    to->asked += s->asked;
    to->certain += s->certain;
    to->wrong += s->wrong;
    to->topples += s->topples;
    to->overlaps += s->overlaps;
    to->refused += s->refused;
    to->cells += s->cells;
    to->bad_cells += s->bad_cells;
}

/* Writes the measured structure to a file, in the format of text.h. */
static void save_seen(const char *path, double e, const char *about)
{
    FILE *out = fopen(path, "w");
    int i, k;
    if (!out) {
        perror(path);
        exit(2);
    }
    fprintf(out, "# %s\nfriction %.17g\nmeasured %.17g %.17g\ndensity 1\n",
            about, true_one.friction, e, e / true_one.size);
    for (i = 0; i < seen.blocks; i++) {
        const kern_block *b = &seen.block[i];
        if (b->fixed)
            fprintf(out, "fixed b%d", i);
        else
            fprintf(out, "block b%d %.17g", i, (double)b->mass);
        for (k = 0; k < b->vertices; k++)
            fprintf(out, "  %.17g %.17g", (double)b->vertex[k].x,
                    (double)b->vertex[k].y);
        if (b->load.fx != 0 || b->load.fy != 0 || b->load.torque != 0)
            fprintf(out, "\nload b%d %.17g %.17g %.17g %.17g\ntorque b%d %.17g",
                    i, (double)b->load.fx, (double)b->load.fy,
                    (double)b->centre.x, (double)b->centre.y, i,
                    (double)b->load.torque);
        fprintf(out, "\n");
    }
    fclose(out);
}

/* What a run of one kind prints besides its row. */
struct detail {
    int each;         /* 1: each wrong verdict                      */
    const char *file; /* for the first wrong structure; NULL: none  */
};

/* Compares a certain verdict with the true motion. */
static void count_wrong(const struct kind *k, int gap, int seed, int copy,
                        double told, double moved, struct score *to,
                        struct detail *detail)
{
    const double e = true_one.e, size = true_one.size;
    char about[200];
    if (moved <= told + 0.1 * e + 1e-4 * size)
        return;
    to->wrong++;
    to->topples += moved > 0.3 * size;
    if (!detail->each)
        return;
    snprintf(about, sizeof about,
             "%s lacks %g errors, seed %d copy %d: moves %.1f e, told %.1f e",
             k->name, gap_errors[gap], seed, copy, moved / e, told / e);
    printf("    %s\n", about);
    if (detail->file)
        save_seen(detail->file, e, about);
    detail->file = NULL;
}

/* Measures copies of one structure. Its true motion is computed when a copy is
   certain, or for a detailed run. Returns that motion, or -1. */
static double measure_one(const struct kind *k, int gap, int seed, double error,
                          struct score *to, struct detail *detail)
{
    double moved = -1;
    int copy;
    if (!make_one(k, gap, seed, error)) {
        to->refused++;
        return moved;
    }
    for (copy = 1; copy <= COPIES; copy++) {
        kern_interval in = {0, 0, 0};
        kern_status status = KERN_OVERLAP;
        begin_random(k->name, gap, seed, copy);
        if (disturb(true_one.e))
            status = ask(true_one.e, &in);
        if (count_status(status, to)) {
            moved = moved < 0 ? true_motion(true_one.e, 0) : moved;
            count_wrong(k, gap, seed, copy, (double)in.settles, moved, to,
                        detail);
        }
    }
    return moved < 0 && detail->each ? true_motion(true_one.e, 0) : moved;
}

static void print_row(const char *name, const struct score *s)
{
    printf("%-16s | %7ld | %7ld | %5ld | %5ld | %5.1f", name, s->asked,
           s->certain, s->wrong, s->topples, percent(s->wrong, s->certain));
}

/* Measures all gaps of a kind and prints its row. */
static void measure_kind(const struct kind *k, int seeds, double error,
                         struct detail *detail, struct score *sum)
{
    static const struct score none;
    struct score all = none;
    double worst = 0, at = 0;
    int gap, seed;
    for (gap = 0; gap < GAPS; gap++) {
        struct score cell = none;
        double low = 1e300, high = 0;
        int falls = 0;
        for (seed = 0; seed < seeds; seed++) {
            const double moved = measure_one(k, gap, seed, error, &cell,
                                             detail);
            low = fmin(low, moved / true_one.e);
            high = fmax(high, moved / true_one.e);
            falls += moved > 0.3 * true_one.size;
        }
        if (detail->each)
            printf(
                "  %4g errors: moves %.2f to %.2f, topples %d of %d; certain "
                "%ld, wrong %ld, overlaps %ld\n",
                gap_errors[gap], low, high, falls, seeds, cell.certain,
                cell.wrong, cell.overlaps);
        if (percent(cell.wrong, cell.asked) > worst) {
            worst = percent(cell.wrong, cell.asked);
            at = gap_errors[gap];
        }
        cell.cells = 1;
        cell.bad_cells = 100 * cell.wrong > cell.asked;
        add_score(&all, &cell);
    }
    print_row(k->name, &all);
    printf(worst > 0 ? " | %5.1f at %g e\n" : " |\n", worst, at);
    fflush(stdout);
    add_score(sum, &all);
}

/* Measures all kinds. Returns 1 if a call was refused or too many verdicts are
   wrong. */
static int near_misses(int seeds, double error)
{
    static const struct score none;
    struct score part[2] = {none, none}, all = none;
    struct detail detail = {0, NULL};
    int i;
    printf("kind             |   asked | certain | wrong | topple |   %% | "
           "worst gap, %% of asked\n");
    for (i = 0; i < COUNT_OF(kind); i++)
        measure_kind(&kind[i], seeds, error, &detail, &part[i % 2]);
    add_score(&all, &part[0]);
    add_score(&all, &part[1]);
    print_row("even kinds", &part[0]);
    print_row("\nodd kinds", &part[1]);
    print_row("\nall", &all);
    printf("\n%ld of %ld cells of a kind and a gap have more than 1 %% wrong\n",
           all.bad_cells, all.cells);
    printf("overlaps %ld, other refusals %ld\n", all.overlaps, all.refused);
    return all.refused > 0
        || (double)all.wrong > MOST_WRONG * (double)all.certain;
}

static int near_miss(const char *name, int seeds, double error,
                     const char *file)
{
    struct score sum = {0, 0, 0, 0, 0, 0, 0, 0};
    struct detail detail = {1, NULL};
    int i;
    detail.file = file;
    for (i = 0; i < COUNT_OF(kind); i++)
        if (strcmp(kind[i].name, name) == 0) {
            measure_kind(&kind[i], seeds, error, &detail, &sum);
            return sum.refused > 0;
        }
    fprintf(stderr, "misses: no kind is named %s\n", name);
    return 2;
}

/* ---- structures that stand ---- */

/* Moves the true structure to where it comes to rest. Returns 0 if it falls, or
   does not stay there. */
static int settle(void)
{
    struct rigid_world w;
    const double moved = simulate(&w, 0.0005 * true_one.size, 0);
    int i, k;
    for (i = 0; i < true_one.blocks; i++) {
        const struct rigid_block *to = &w.block[i];
        const kern_vec centre = true_one.block[i].centre;
        for (k = 0; k < true_one.shape[i].corners; k++) {
            kern_vec *v = &true_one.vertex[true_one.shape[i].first + k];
            const double x = (double)(v->x - centre.x);
            const double y = (double)(v->y - centre.y);
            v->x = (kern_real)(to->at.x + to->turn.x * x - to->turn.y * y);
            v->y = (kern_real)(to->at.y + to->turn.y * x + to->turn.x * y);
        }
    }
    rigid_free(&w);
    return make_blocks() && moved < 0.4 * true_one.size
        && true_motion(true_one.e, 1) < 1e-4 * true_one.size;
}

/* Makes a structure that stands. Returns 0 if none is found. */
static int make_standing(const struct kind *k, int seed, double error)
{
    int attempt;
    for (attempt = 0; attempt < 20; attempt++)
        if (!make_one(k, -1, seed + 1000000 * attempt, error))
            return 0;
        else if (k->make != rubble || settle())
            return 1;
    fprintf(stderr, "misses: %s %d: does not stand\n", k->name, seed);
    return 0;
}

/* Returns how many of the structures of a kind are certain at an error, in per
   cent of all, and counts the calls. */
static double covered(const struct kind *k, int seeds, double error,
                      struct score *sum)
{
    static const struct score none;
    struct score score = none;
    int seed;
    for (seed = 0; seed < seeds; seed++) {
        kern_interval in = {0, 0, 0};
        kern_status status = KERN_NO_BLOCK;
        if (make_standing(k, seed, error)) {
            begin_random(k->name, (int)(error * 1e5), seed, 1);
            status = disturb(true_one.e) ? ask(true_one.e, &in) : KERN_OVERLAP;
        }
        count_status(status, &score);
    }
    add_score(sum, &score);
    return percent(score.certain, score.asked);
}

/* Returns the largest true motion of structures of a kind that stand, in errors
   of 0.005. */
static double standing_motion(const struct kind *k, int seeds)
{
    double most = 0;
    int seed;
    for (seed = 0; seed < seeds; seed++)
        if (make_standing(k, seed, 0.005))
            most = fmax(most, true_motion(true_one.e, 1) / true_one.e);
    return most;
}

/* Prints what share of the structures that stand is certain. Returns 1 if a
   call was refused or a structure moves by a tenth of an error of 0.005. */
static int print_covered(int seeds)
{
    static const double share[] = {0.0001, 0.002, 0.005, 0.01, 0.02};
    struct score sum = {0, 0, 0, 0, 0, 0, 0, 0};
    int i, k, bad = 0;
    printf("\nstands, certain %% |  0.01 %% |   0.2 %% |   0.5 %% |     1 %% "
           "|     2 %% | moves, errors of 0.5 %%\n");
    for (i = 0; i < COUNT_OF(stands); i++) {
        const double moved = standing_motion(&stands[i], seeds);
        printf("%-17s", stands[i].name);
        for (k = 0; k < COUNT_OF(share); k++)
            printf(" | %7.0f", covered(&stands[i], seeds, share[k], &sum));
        printf(" | %.3f\n", moved);
        fflush(stdout);
        bad |= moved > 0.1;
    }
    printf("overlaps %ld, other refusals %ld\n", sum.overlaps, sum.refused);
    return bad || sum.refused > 0;
}

/* ---- self tests ---- */

/* Motions of near misses that are known by hand. */
static const struct known {
    void (*make)(double gap);
    double gaps;  /* it moves by this multiple of the gap         */
    double least; /* it moves by at least this share of its size  */
} known[] = {{slot, 0, 0.3},   {half, 0, 0.3},       {slope, 0, 0.3},
             {plank, 0, 0.05}, {cantilever, 0, 0.3}, {slope_kerb, 1, 0},
             {tongue, 1, 0},   {beam_middle, 0, 0}};

/* Returns 1 if the simulator moves a structure as is known, with a tolerance of
   a tenth of an error. */
static int moves_as_known(const struct known *n, double gap)
{
    const double moved = true_motion(true_one.e, 0);
    if (n->least > 0)
        return moved > n->least * true_one.size;
    return fabs(moved - n->gaps * gap) < 0.1 * true_one.e;
}

/* Tests the truth of the smallest and the largest gap at an error of 0.005.
   Returns 1 if a motion is not the known one. */
static int test_truth(void)
{
    int i, k, gap, bad = 0;
    for (i = 0; i < COUNT_OF(known); i++)
        for (k = 0; k < COUNT_OF(kind); k++)
            for (gap = 0; gap < GAPS; gap += GAPS - 1) {
                if (kind[k].make != known[i].make
                    || (make_one(&kind[k], gap, 0, 0.005)
                        && moves_as_known(&known[i],
                                          gap_errors[gap] * true_one.e)))
                    continue;
                printf("self test: %s with %g errors moves otherwise\n",
                       kind[k].name, gap_errors[gap]);
                bad = 1;
            }
    return bad;
}

int main(int argc, char **argv)
{
    const int seeds = argc > 1 ? atoi(argv[1]) : 3;
    const double error = argc > 2 ? atof(argv[2]) : 0.005;
    int bad;
    if (seeds < 1 || !(error > 0 && error <= 0.05)) {
        fprintf(stderr, "usage: misses [SEEDS [ERROR [KIND [FILE]]]]\n");
        return 2;
    }
    reals = KERN_REALS(MOST_BLOCKS, MOST_CONTACTS);
    integers = KERN_INTS(MOST_BLOCKS, MOST_CONTACTS);
    real = (kern_real *)malloc((size_t)reals * sizeof *real);
    integer = (int *)malloc((size_t)integers * sizeof *integer);
    if (!real || !integer)
        return 1;
    if (argc > 3)
        return near_miss(argv[3], seeds, error, argc > 4 ? argv[4] : NULL);
    bad = test_truth();
    bad |= near_misses(seeds, error);
    bad |= print_covered(STANDING * seeds);
    return bad;
}
