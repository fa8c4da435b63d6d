/* rest.h - where stones come to rest (kern_rest()), which place is best
   (kern_place_compare()) and copies of plans (kern_plan_copy()). */

#ifndef UNIT_REST_H
#define UNIT_REST_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"

enum { YARD_BLOCKS = 40, YARD_POINTS = 64 * YARD_BLOCKS, YARD_CORNERS = 64 };

/* Lengths that rounding changes, in sizes of a stone of 1. */
#define REST_EXACT (SINGLE ? 2e-3 : 1e-6)

/* ---- yards: plans and a stone ---- */

struct yard {
    kern_vec corner[YARD_BLOCKS][YARD_CORNERS];
    kern_block block[YARD_BLOCKS];
    kern_contact contact[YARD_POINTS];
    kern_motion motion[YARD_BLOCKS];
    kern_force force[YARD_POINTS];
    kern_real real[KERN_REALS(YARD_BLOCKS, YARD_POINTS)];
    int index[KERN_INTS(YARD_BLOCKS, YARD_POINTS)];
    kern_work work;
    kern_plan plan;
    kern_vec rest[YARD_CORNERS]; /* the stone's vertices at rest */
    kern_pose pose;
};

static void yard_open(struct yard *w)
{
    w->work = kern_work_of(w->real, KERN_REALS(YARD_BLOCKS, YARD_POINTS),
                           w->index, KERN_INTS(YARD_BLOCKS, YARD_POINTS));
    w->plan = kern_plan_of(w->block, YARD_BLOCKS, w->contact, YARD_POINTS,
                           kern_known_of(w->motion, w->force), &w->work);
}

/* Adds a block: density 0 is ground. Returns contacts, or a status. */
static int yard_add(struct yard *w, const kern_vec *v, int n, kern_real density)
{
    kern_vec *own = w->corner[w->plan.task.s.blocks];
    kern_block b;
    memcpy(own, v, (size_t)n * sizeof *v);
    if (density > 0)
        CHECK(kern_block_init(&b, own, n, density, NULL) == KERN_OK);
    else
        CHECK(kern_ground_init(&b, own, n, NULL) == KERN_OK);
    return kern_plan_add(&w->plan, &b);
}

static void yard_box(struct yard *w, double left, double low, double right,
                     double high)
{
    kern_vec v[4];
    v[0].x = v[3].x = (kern_real)left;
    v[1].x = v[2].x = (kern_real)right;
    v[0].y = v[1].y = (kern_real)low;
    v[2].y = v[3].y = (kern_real)high;
    CHECK(yard_add(w, v, 4, 0) >= 0);
}

static void yard_triangle(struct yard *w, double ax, double ay, double bx,
                          double by, double cx, double cy)
{
    const kern_vec v[3] = {{(kern_real)ax, (kern_real)ay},
                           {(kern_real)bx, (kern_real)by},
                           {(kern_real)cx, (kern_real)cy}};
    CHECK(yard_add(w, v, 3, 0) >= 0);
}

static kern_block yard_block(const kern_vec *v, int n)
{
    kern_block b;
    CHECK(kern_block_init(&b, v, n, 1, NULL) == KERN_OK);
    return b;
}

static kern_status yard_rest(struct yard *w, const kern_block *stone, double x,
                             double turn)
{
    kern_vec q;
    q.x = (kern_real)cos(turn);
    q.y = (kern_real)sin(turn);
    return kern_rest(&w->plan.task, stone, (kern_real)x, q, w->rest, &w->pose);
}

static const kern_vec unit_box[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
static struct yard yard;

/* Checks place and turn of the stone at rest. */
static void yard_at(const struct yard *w, double x, double y, double turn)
{
    CHECK_NEAR(w->pose.block.centre.x, x, REST_EXACT);
    CHECK_NEAR(w->pose.block.centre.y, y, REST_EXACT);
    CHECK_NEAR(w->pose.turn.x, cos(turn), REST_EXACT);
    CHECK_NEAR(w->pose.turn.y, sin(turn), REST_EXACT);
}
#define AT(x, y, turn) yard_at(&yard, x, y, turn)

static int yard_stands(struct yard *w)
{
    return kern_plan_bears(&w->plan, &w->pose.block, 0, NULL) == KERN_STANDS;
}

/* ---- poses by hand ---- */

static void rest_flat(void)
{
    const kern_block box = yard_block(unit_box, 4);
    const double half = 1.5707963267948966;
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    CHECK(yard_rest(&yard, &box, 0.3, 0) == KERN_OK);
    AT(0.3, 0.5, 0);
    CHECK(yard.pose.motions == 1);
    CHECK(yard_stands(&yard));
    CHECK(yard.rest[2].x > yard.rest[0].x); /* vertices in their order */

    /* on its first corner it tips to the nearer side, about that corner */
    CHECK(yard_rest(&yard, &box, 0, 0.1) == KERN_OK);
    AT(0.5 - (cos(0.1) - sin(0.1)) / 2, 0.5, 0);
    CHECK(yard_rest(&yard, &box, 0, 0.9) == KERN_OK);
    AT((sin(0.9) - cos(0.9)) / 2 - 0.5, 0.5, half);
    /* a turn is an angle, whole turns and more */
    CHECK(yard_rest(&yard, &box, 0, 8 * half) == KERN_OK);
    AT(0, 0.5, 0);
    CHECK(yard_rest(&yard, &box, 0, -half) == KERN_OK);
    AT(0, 0.5, -half);
}

static void rest_over_an_edge(void)
{
    const kern_vec slab[4] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    const kern_block b = yard_block(slab, 4);
    yard_open(&yard);
    yard_box(&yard, -4, -1, 0, 0);
    yard_box(&yard, -4, -2, 9, -1);
    CHECK(yard_rest(&yard, &b, -0.1, 0) == KERN_OK);
    AT(-0.1, 0.5, 0);
    /* centre beyond the edge: clockwise about it, until a corner 1.2 from it
       is 1 lower: sine 1 / 1.2 */
    CHECK(yard_rest(&yard, &b, 0.2, 0) == KERN_OK);
    CHECK(yard.pose.motions > 1 && yard.pose.block.centre.x > 0.2);
    yard.plan.task.options.mu = 10; /* and stays there */
    CHECK(yard_rest(&yard, &b, 0.2, 0) == KERN_OK);
    CHECK_NEAR(yard.pose.turn.y, -1 / 1.2, REST_EXACT);
    CHECK_NEAR(yard.rest[1].y, -1, REST_EXACT);
    CHECK(yard_stands(&yard));
}

static void rest_triangles(void)
{
    const double high = sqrt(0.75);
    const kern_vec up[3] = {{0, 0}, {1, 0}, {(kern_real)0.5, (kern_real)high}};
    const kern_vec down[3] = {{0, 0},
                              {(kern_real)0.5, (kern_real)high},
                              {(kern_real)-0.5, (kern_real)high}};
    const kern_block a = yard_block(up, 3), b = yard_block(down, 3);
    const double third = 1.0471975511965976;
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    CHECK(yard_rest(&yard, &a, 0, 0) == KERN_OK);
    AT(0, high / 3, 0);
    CHECK(yard_rest(&yard, &b, 0, 0.01) == KERN_OK);
    CHECK_NEAR(yard.pose.turn.y, sin(third), REST_EXACT);
    CHECK(yard_rest(&yard, &b, 0, -0.01) == KERN_OK);
    CHECK_NEAR(yard.pose.turn.y, -sin(third), REST_EXACT);
    CHECK_NEAR(yard.pose.block.centre.y, high / 3, REST_EXACT);
    CHECK(yard_rest(&yard, &b, 0, 0) == KERN_OK); /* on its point, in balance */
    AT(0, 2 * high / 3, 0);
}

static void rest_slopes(void)
{
    const kern_block box = yard_block(unit_box, 4);
    const double quarter = 0.7853981633974483, lean = atan(0.3);
    const double c = cos(lean), s = sin(lean);
    int i;

    /* a groove of two slopes of 45 degrees: it slides to the bottom */
    yard_open(&yard);
    yard_triangle(&yard, -9, 9, -9, 0, 0, 0);
    yard_triangle(&yard, 9, 9, 0, 0, 9, 0);
    CHECK(yard_rest(&yard, &box, 0, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);
    CHECK(yard_stands(&yard));
    CHECK(yard_rest(&yard, &box, 1.2, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);
    CHECK(yard_rest(&yard, &box, -1.2, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);

    /* a slope of 0.3: friction of 0.4 holds it, 0.2 does not, and a wall at
       the foot does */
    yard_open(&yard);
    yard_triangle(&yard, 0, 0, 9, 0, 9, 2.7);
    yard_box(&yard, -1, 0, 0, 9);
    CHECK(yard_rest(&yard, &box, 4, lean) == KERN_OK);
    AT(4, 1.2 + 0.5 / c, lean);
    CHECK(yard.pose.motions == 1 && yard_stands(&yard));
    yard.plan.task.options.mu = (kern_real)0.3; /* as steep as friction holds */
    for (i = 0; i < 20; i++) {
        CHECK(yard_rest(&yard, &box, 2 + 0.3 * i, lean) == KERN_OK);
        CHECK_NEAR(yard.pose.block.centre.x, 2 + 0.3 * i, REST_EXACT);
    }
    yard.plan.task.options.mu = (kern_real)0.2;
    CHECK(yard_rest(&yard, &box, 4, lean) == KERN_OK);
    AT((c + s) / 2, 0.15 * (c + s) + 0.5 / c, lean);
}

/* Without friction a brick slides to the foot of steps and of slopes, and off
   the end of a slope. */
static void rest_slippery(void)
{
    const kern_vec brick[4] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    const kern_block b = yard_block(brick, 4);
    kern_vec v[40];
    kern_block disc;
    int i, held = 0, found = 0;
    yard_open(&yard);
    for (i = 0; i < 8; i++)
        yard_box(&yard, -10, i - 1, -1.3 * i, i);
    yard_box(&yard, -10, -2, 20, -1);
    yard_box(&yard, 20, -2, 21, 9);
    yard.plan.task.options.mu = 0;
    for (i = 0; i < 40; i++) {
        if (yard_rest(&yard, &b, -9 + 0.25 * i, 0.15 * i) != KERN_OK)
            continue;
        yard.plan.task.options.mu = (kern_real)0.02;
        found++;
        held += yard_stands(&yard);
        yard.plan.task.options.mu = 0;
    }
    printf("%d bricks on slippery steps: %d rest, %d of these are held\n", i,
           found, held);
    CHECK(found > 30 && held == found);

    /* a disc of 40 corners comes to the lower end of a slope */
    for (i = 0; i < 40; i++) {
        v[i].x = (kern_real)(0.5 * cos(6.283185307179586 * i / 40));
        v[i].y = (kern_real)(0.5 * sin(6.283185307179586 * i / 40));
    }
    disc = yard_block(v, 40);
    yard_open(&yard);
    yard_triangle(&yard, -5, -2, 5, -2, 5, 2);
    for (i = 0; i < 40; i++)
        if (yard_rest(&yard, &disc, -4.9 + 0.07 * i, 0.2 * i) == KERN_OK)
            CHECK(yard_stands(&yard));
}

static void rest_gaps(void)
{
    const kern_vec half[4] = {
        {0, 0}, {(kern_real)0.5, 0}, {(kern_real)0.5, 1}, {0, 1}};
    const kern_block box = yard_block(unit_box, 4), thin = yard_block(half, 4);
    yard_open(&yard);
    yard_box(&yard, -5, 0, 0, 2);
    yard_box(&yard, 0.6, 0, 5, 2);
    yard_box(&yard, 0, 0, 0.6, 0.5);
    CHECK(yard_rest(&yard, &box, 0.3, 0) == KERN_OK); /* across */
    AT(0.3, 2.5, 0);
    CHECK(yard_rest(&yard, &thin, 0.3, 0) == KERN_OK); /* into it */
    AT(0.3, 1, 0);
    CHECK(yard_rest(&yard, &thin, 0.25, 0) == KERN_OK); /* along a side */
    AT(0.25, 1, 0);
    yard_open(&yard);
    yard_box(&yard, -5, 0, 0, 2);
    yard_box(&yard, 0.5, 0, 5, 2);
    yard_box(&yard, 0, 0, 0.5, 0.5);
    CHECK(yard_rest(&yard, &thin, 0.25, 0) == KERN_OK); /* where it just fits */
    AT(0.25, 1, 0);

    /* a step of 0.5: about its edge until a corner 0.6 from there meets the
       ground, and about that onto its side */
    yard_open(&yard);
    yard_box(&yard, -5, -1, 5, 0);
    yard_box(&yard, -5, 0, 0, 0.5);
    yard.plan.task.options.mu = 10;
    CHECK(yard_rest(&yard, &box, 0.1, 0) == KERN_OK);
    AT(sqrt(0.36 - 0.25) + 0.5, 0.5, -1.5707963267948966);
    CHECK(yard_stands(&yard));
}

/* Corners that meet exactly. The stone leans by (1.1, 0.9) over a foot of 0.5,
   so its centre is beyond the foot: it turns about the foot's end until that
   side, sqrt(2.02) long, is level. Its other corner may be at a corner. */
static void rest_corners(void)
{
    const kern_vec lean[4] = {{0, 0},
                              {(kern_real)0.3, 0},
                              {(kern_real)1.4, (kern_real)0.9},
                              {0, (kern_real)0.9}};
    const kern_vec back[4] = {{0, 0},
                              {(kern_real)-0.5, 0},
                              {(kern_real)-1.6, (kern_real)0.9},
                              {(kern_real)-1.1, (kern_real)0.9}};
    const double side = sqrt(2.02), turn = atan(0.9 / 1.1);
    kern_block b = yard_block(lean, 4);
    int i;

    /* flush with a wall beside it, of two blocks, at any height */
    for (i = 0; i < 2; i++) {
        yard_open(&yard);
        yard_box(&yard, -9, -1, 9, 0);
        yard_box(&yard, -1, 0, 0, 1);
        yard_box(&yard, -1, 1, 0, 2);
        if (i)
            yard_box(&yard, 0, 0, 1, 1);
        CHECK(yard_rest(&yard, &b, (double)b.centre.x, 0) == KERN_OK);
        CHECK_NEAR(yard.pose.turn.y, -sin(turn), REST_EXACT);
        CHECK_NEAR(yard.rest[2].x, 0.3 + side, 10 * REST_EXACT);
        CHECK_NEAR(yard.rest[2].y, i, REST_EXACT);
        CHECK(SINGLE || yard_stands(&yard));
    }

    /* its corner at the foot of a box */
    b = yard_block(back, 4);
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    yard_box(&yard, 0, 0, 1, 1);
    CHECK(yard_rest(&yard, &b, (double)b.centre.x, 0) == KERN_OK);
    CHECK_NEAR(yard.pose.turn.y, sin(turn), REST_EXACT);
    CHECK_NEAR(yard.rest[2].x, -0.5 - side, 10 * REST_EXACT);
    CHECK_NEAR(yard.rest[2].y, 0, REST_EXACT);
    CHECK(SINGLE || yard_stands(&yard));

    /* a box on a box of its width stays; 0.6 off it tips */
    b = yard_block(unit_box, 4);
    CHECK(yard_rest(&yard, &b, 0.5, 0) == KERN_OK);
    AT(0.5, 1.5, 0);
    CHECK(yard.pose.motions == 1 && yard_stands(&yard));
    CHECK(yard_rest(&yard, &b, 1.1, 0) == KERN_OK);
    CHECK(yard.pose.block.centre.y < 1 && (SINGLE || yard_stands(&yard)));
}

/* A tile with a notch of a right angle on a spike that is sharper: the notch
   stays on the tip, and the tile turns until its flank is on the spike's, whose
   slope is 0.3 to 1. */
static void rest_pocket(void)
{
    const double e = 0.5;
    const kern_vec tile[6] = {{(kern_real)-e, (kern_real)-e},
                              {0, 0},
                              {(kern_real)e, (kern_real)-e},
                              {(kern_real)0.8, 0},
                              {0, (kern_real)e},
                              {(kern_real)-e, 0}};
    const kern_block b = yard_block(tile, 6);
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    yard_triangle(&yard, -0.3, 0, 0.3, 0, 0, 1);
    CHECK(yard_rest(&yard, &b, 0, 0) == KERN_OK);
    CHECK_NEAR(yard.rest[1].x, 0, REST_EXACT);
    CHECK_NEAR(yard.rest[1].y, 1, REST_EXACT);
    CHECK_NEAR(yard.pose.turn.y, -sin(atan(1.0) - atan(0.3)), REST_EXACT);
    CHECK(yard_stands(&yard));
}

/* A ladder of length 1 against a wall, at an angle of 1 to the ground. Friction
   mu at both ends holds it from tan 1 = (1 - mu^2) / (2 mu) on: mu = 0.293. */
static void rest_ladder(void)
{
    const kern_vec thin[4] = {
        {0, 0}, {1, 0}, {1, (kern_real)0.002}, {0, (kern_real)0.002}};
    const kern_block b = yard_block(thin, 4);
    const double x = 0.5 * cos(1) + 0.001 * sin(1);
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    yard_box(&yard, -1, 0, 0, 5);
    if (SINGLE) /* rounding moves the ladder's foot */
        return;
    yard.plan.task.options.mu = (kern_real)0.3;
    CHECK(yard_rest(&yard, &b, x, -1) == KERN_OK);
    CHECK(yard_stands(&yard));
    CHECK_NEAR(yard.pose.turn.y, -sin(1), 1e-2);
    yard.plan.task.options.mu = (kern_real)0.28;
    CHECK(yard_rest(&yard, &b, x, -1) == KERN_OK);
    CHECK(yard_stands(&yard));
    CHECK_NEAR(yard.pose.block.centre.y, 0.001, REST_EXACT);
}

/* Concave, thin, tiny, round and clockwise stones. */
static void rest_shapes(void)
{
    const kern_vec arch[8] = {{0, 0}, {1, 0}, {1, 2}, {2, 2},
                              {2, 0}, {3, 0}, {3, 3}, {0, 3}};
    kern_vec v[40];
    kern_block b = yard_block(arch, 8);
    int i;
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    yard_box(&yard, -0.25, 0, 0.25, 2.5); /* a post */
    CHECK(yard_rest(&yard, &b, 0, 0) == KERN_OK);
    AT(0, 0.5 + (double)b.centre.y, 0);
    CHECK(yard_stands(&yard));
    for (i = 0; i < 8; i++)
        v[i] = arch[7 - i];
    b = yard_block(v, 8);
    CHECK(b.area < 0 && yard_rest(&yard, &b, 0, 0) == KERN_OK);
    AT(0, 0.5 + (double)b.centre.y, 0);

    for (i = 0; i < 40; i++) {
        v[i].x = (kern_real)cos(6.283185307179586 * (i + 0.5) / 40);
        v[i].y = (kern_real)sin(6.283185307179586 * (i + 0.5) / 40);
    }
    b = yard_block(v, 40);
    CHECK(yard_rest(&yard, &b, 5, 0) == KERN_OK);
    AT(5, cos(3.141592653589793 / 40), 0);
    CHECK(yard_rest(&yard, &b, 5, 0.05) == KERN_OK);
    CHECK_NEAR(yard.pose.block.centre.y, cos(3.141592653589793 / 40),
               REST_EXACT);

    for (i = 0; i < 4; i++) {
        v[i].x = unit_box[i].x;
        v[i].y = unit_box[i].y / 1000;
    }
    b = yard_block(v, 4);
    CHECK(yard_rest(&yard, &b, 3, 0.3) == KERN_OK);
    CHECK_NEAR(yard.pose.block.centre.y, 0.0005, REST_EXACT);
    for (i = 0; i < 4; i++)
        v[i].x = unit_box[i].x / 1000;
    b = yard_block(v, 4);
    CHECK(yard_rest(&yard, &b, 3, 0.3) == KERN_OK);
    CHECK(fabs((double)yard.pose.block.centre.y - 0.0005) < 1e-3 * REST_EXACT
          || sizeof(kern_real) == sizeof(float));

    /* one of 40 corners rolls down a long slope, and past its end */
    for (i = 0; i < 40; i++) {
        v[i].x = (kern_real)cos(6.283185307179586 * i / 40);
        v[i].y = (kern_real)sin(6.283185307179586 * i / 40);
    }
    b = yard_block(v, 40);
    yard_open(&yard);
    yard_triangle(&yard, 0, 0, 40, 0, 40, 12);
    if (SINGLE) /* rounding stops it */
        return;
    CHECK(yard_rest(&yard, &b, 38, 0) == KERN_NO_REST);
    CHECK(yard_rest(&yard, &b, 2, 0) == KERN_NO_SUPPORT);
}

/* ---- walls ---- */

/* A stone of 3 to 12 vertices around a centre; every fifth is concave. */
static int yard_stone(kern_vec *v)
{
    const int n = 3 + (int)uniform(0, 9.99), dent = uniform(0, 5) < 1 && n > 4;
    const double size = uniform(0.3, 0.7), flat = uniform(0.4, 1);
    int i;
    for (i = 0; i < n; i++) {
        const double a = 6.283185307179586 * (i + uniform(-0.3, 0.3)) / n;
        const double r = size * (dent && i == 0 ? 0.4 : 1);
        v[i].x = (kern_real)(r * cos(a));
        v[i].y = (kern_real)(flat * r * sin(a));
    }
    return n;
}

/* Builds a wall of stones where they come to rest and stand. */
static void yard_build(struct yard *w, int stones)
{
    int tries;
    yard_open(w);
    w->plan.task.options.mu = (kern_real)uniform(0.3, 0.8);
    yard_box(w, -1, -1, 6, 0);
    yard_box(w, 6, -1, 7, 0.4);
    for (tries = 0; tries < 40 * stones && w->plan.task.s.blocks < stones + 2;
         tries++) {
        kern_vec v[YARD_CORNERS];
        kern_block b;
        const int n = yard_stone(v);
        if (kern_block_init(&b, v, n, 1, NULL) == KERN_OK
            && yard_rest(w, &b, uniform(0, 5), uniform(-3, 3)) == KERN_OK
            && yard_stands(w))
            CHECK(yard_add(w, w->rest, n, 1) >= 0);
    }
}

/* The vertex p in a yard that is mirrored, scaled, turned by a right angle and
   moved. */
struct yard_frame {
    double mirror, scale, dx, dy;
    int turned, reversed; /* 1: by a right angle; the order of blocks */
};

static kern_vec yard_framed(const struct yard_frame *f, kern_vec p)
{
    const double x = f->mirror * f->scale * (double)p.x;
    const double y = f->scale * (double)p.y;
    kern_vec q;
    q.x = (kern_real)((f->turned ? -y : x) + f->dx);
    q.y = (kern_real)((f->turned ? x : y) + f->dy);
    return q;
}

static struct yard other_yard;

/* Compares where a stone rests on a wall and on the wall in a frame. */
static int yard_alike(struct yard *w, const struct yard_frame *f,
                      const kern_vec *v, int n, double x, double turn)
{
    const kern_block stone = yard_block(v, n);
    const kern_vec along = {(kern_real)x, 0};
    kern_vec u[YARD_CORNERS], to;
    kern_block seen;
    kern_status a, b;
    int i, good;
    yard_open(&other_yard);
    other_yard.plan.task.options = w->plan.task.options;
    if (f->turned) {
        other_yard.plan.task.s.gravity.x = (kern_real)9.81;
        other_yard.plan.task.s.gravity.y = 0;
    }
    for (i = 0; i < w->plan.task.s.blocks; i++) {
        const int last = w->plan.task.s.blocks - 1;
        const kern_block *from = &w->block[f->reversed ? last - i : i];
        int k;
        for (k = 0; k < from->vertices; k++)
            u[k] = yard_framed(f, from->vertex[k]);
        CHECK(yard_add(&other_yard, u, from->vertices, from->fixed ? 0 : 1)
              >= 0);
    }
    for (i = 0; i < n; i++)
        u[i] = yard_framed(f, v[i]);
    seen = yard_block(u, n);
    to = yard_framed(f, along);
    a = yard_rest(w, &stone, x, turn);
    b = yard_rest(&other_yard, &seen, (double)(f->turned ? to.y : to.x),
                  f->mirror * turn);
    good = a == b;
    for (i = 0; i < n && good && a == KERN_OK; i++) {
        const kern_vec p = yard_framed(f, w->rest[i]);
        good = fabs((double)(p.x - other_yard.rest[i].x))
                <= REST_EXACT * f->scale
            && fabs((double)(p.y - other_yard.rest[i].y))
                   <= REST_EXACT * f->scale;
    }
    return good;
}

static void rest_laws(void)
{
    const struct yard_frame frame[6] = {
        {-1, 1, 0, 0, 0, 0}, {1, 1, 100, -50, 0, 0},     {1, 1024, 0, 0, 0, 0},
        {1, 1, 0, 0, 1, 0},  {-1, 1.0 / 64, 3, 1, 1, 0}, {1, 1, 0, 0, 0, 1}};
    int wall, i, k, tried = 0, good[6] = {0};
    for (wall = 0; wall < 4; wall++) {
        yard_build(&yard, 12);
        for (i = 0; i < 50; i++) {
            kern_vec v[YARD_CORNERS];
            const int n = yard_stone(v);
            const double x = uniform(-1, 6), turn = uniform(-2, 2);
            tried++;
            for (k = 0; k < 6; k++)
                good[k] += yard_alike(&yard, &frame[k], v, n, x, turn);
        }
    }
    for (k = 0; k < 6; k++) {
        if (good[k] < tried)
            printf("frame %d: %d of %d are alike\n", k, good[k], tried);
        CHECK(good[k]
              >= (sizeof(kern_real) == sizeof(double) ? tried : tried / 2));
    }
}

/* Fills `other` with the wall, all of it fixed. */
static void yard_fix(struct yard *w)
{
    int i;
    yard_open(&other_yard);
    other_yard.plan.task.options = w->plan.task.options;
    for (i = 0; i < w->plan.task.s.blocks; i++)
        CHECK(yard_add(&other_yard, w->block[i].vertex, w->block[i].vertices, 0)
              >= 0);
}

/* What poses on walls that cannot move are worth: none overlaps, and 99 of 100
   are held. */
static void rest_poses(void)
{
    const int walls = quick ? 6 : 12;
    int wall, i, tried = 0, found = 0, held = 0;
    for (wall = 0; wall < walls; wall++) {
        yard_build(&yard, 36);
        yard_fix(&yard);
        for (i = 0; i < 60; i++) {
            kern_vec v[YARD_CORNERS];
            const int n = yard_stone(v);
            const kern_block b = yard_block(v, n);
            kern_status status = yard_rest(&yard, &b, uniform(0, 5),
                                           uniform(-2, 2));
            tried++;
            CHECK(status == KERN_OK || status == KERN_NO_REST
                  || status == KERN_NO_SUPPORT);
            if (status != KERN_OK)
                continue;
            found++;
            status = kern_plan_bears(&other_yard.plan, &yard.pose.block, 0,
                                     NULL);
            CHECK(SINGLE || status != KERN_OVERLAP);
            held += status == KERN_STANDS;
        }
    }
    printf("%d stones on %d walls: %d rest, %d of these are held\n", tried,
           walls, found, held);
    CHECK(found > tried * 9 / 10 && held > found * (SINGLE ? 75 : 98) / 100);
}

/* Lets a tile down with the middle of its edge on a corner: a turn about that
   and a slide begin equally steeply, and the choice is the same in any scale. */
static void rest_ties(void)
{
    const struct yard_frame frame[2] = {{1, 1024, 0, 0, 0, 0},
                                        {-1, 1, 0, 0, 0, 0}};
    kern_vec v[4];
    int i;
    for (i = 0; i < 4; i++) {
        v[i].x = unit_box[i].x / 4;
        v[i].y = unit_box[i].y / 4;
    }
    yard_open(&yard);
    yard_box(&yard, -9, -1, 9, 0);
    yard_box(&yard, -2, 0, 0, 2);
    for (i = 0; i < 2; i++)
        CHECK(
            yard_alike(&yard, &frame[i], v, 4, 0.125 * 0.6, -atan2(0.6, 0.8)));
}

/* Fills a yard with sharp teeth on a floor, a little apart or side by side. */
static void yard_teeth(struct yard *w)
{
    double x = -4;
    yard_open(w);
    w->plan.task.options.mu = (kern_real)uniform(0.2, 0.9);
    yard_box(w, -9, -1, 9, 0);
    while (x < 4 && w->plan.task.s.blocks < YARD_BLOCKS - 1) {
        const double wide = uniform(0.5, 2);
        yard_triangle(w, x, 0, x + wide, 0, x + wide * uniform(0, 1),
                      uniform(0.2, 3));
        x += wide + (uniform(0, 2) < 1 ? 0 : uniform(0, 0.4));
    }
}

/* Stones between teeth: with two legs, splinters, and round ones of up to 40
   corners, small and large. The mirrored pose is the same, and a million away
   from the origin no stone is inside a block. A stone whose corner has just slid
   past the tip of a tooth is not held by the tooth's other side. */
static void rest_teeth(void)
{
    const struct yard_frame mirror = {-1, 1, 0, 0, 0, 0};
    const struct yard_frame away = {1, 1, 1e6, -1e6, 0, 0};
    int i, k, tried = 0, alike = 0, found = 0, held = 0;
    for (i = 0; i < some(600); i++) {
        const kern_vec legs[8] = {{0, 0}, {1, 0}, {1, 6}, {6, 6},
                                  {6, 0}, {7, 0}, {7, 7}, {0, 7}};
        const double size = uniform(0, 2) < 1 ? uniform(0.01, 0.1)
                                              : uniform(0.2, 0.9);
        const double flat = uniform(0.001, 0.02);
        const double x = uniform(-3, 3), turn = uniform(-3, 3);
        const int n = i % 3 == 0 ? 8
                    : i % 3 == 1 ? 3
                                 : 5 + (int)uniform(0, 35.9);
        kern_vec v[YARD_CORNERS];
        kern_block b;
        yard_teeth(&yard);
        for (k = 0; k < n; k++) {
            const double a = 6.283185307179586 * k / n;
            v[k].x = (kern_real)(size * cos(a));
            v[k].y = (kern_real)(size * (n == 3 ? flat : 1) * sin(a));
            if (i % 3 == 0) {
                v[k].x = (kern_real)size / 4 * legs[k].x;
                v[k].y = (kern_real)size / 4 * legs[k].y;
            }
        }
        b = yard_block(v, n);
        tried++;
        alike += yard_alike(&yard, &mirror, v, n, x, turn);
        if (yard_rest(&yard, &b, x, turn) != KERN_OK)
            continue;
        found++;
        held += yard_stands(&yard);
        if (SINGLE)
            continue;
        yard_alike(&yard, &away, v, n, x, turn);
        CHECK(kern_plan_bears(&other_yard.plan, &other_yard.pose.block, 0, NULL)
              != KERN_OVERLAP);
    }
    printf("%d stones on teeth: %d rest, %d of these are held, %d have their "
           "mirrored pose\n",
           tried, found, held, alike);
    CHECK(alike >= (SINGLE ? tried / 2 : tried));
    CHECK(found > tried * 9 / 10 && held > found * (SINGLE ? 92 : 97) / 100);
}

/* ---- what is refused ---- */

static void rest_refused(void)
{
    const kern_vec upright = {1, 0};
    const kern_vec bow[4] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    kern_vec own[4], out[4];
    kern_block box, bad;
    kern_pose pose;
    kern_task *const task = &yard.plan.task;
    memcpy(own, unit_box, sizeof own);
    box = yard_block(own, 4);
    yard_open(&yard);
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_NO_SUPPORT); /* an empty plan */
    yard_box(&yard, -1, -1, 1, 0);
    CHECK(yard_rest(&yard, &box, 5, 0) == KERN_NO_SUPPORT);
    CHECK(yard_rest(&yard, &box, -1.6, 0) == KERN_NO_SUPPORT);

    CHECK(kern_rest(NULL, &box, 0, upright, out, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, NULL, 0, upright, out, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, upright, NULL, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, upright, out, NULL) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, upright, own, &pose) == KERN_BAD_POINTER);
    CHECK(yard_rest(&yard, &box, R(not_a_number()), 0) == KERN_BAD_NUMBER);
    CHECK(yard_rest(&yard, &box, 0, (double)KERN_INFINITY) == KERN_BAD_NUMBER);

    CHECK(kern_block_init(&bad, bow, 4, 1, NULL) == KERN_CROSSING);
    CHECK(yard_rest(&yard, &bad, 0, 0) == KERN_NO_BLOCK);
    CHECK(yard.work.fault.block == 1);
    bad = box;
    bad.vertex = NULL;
    bad.vertices = 0;
    CHECK(yard_rest(&yard, &bad, 0, 0) == KERN_FEW_VERTICES);
    own[2].x = 2;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_STALE);
    own[2].x = 1;
    bad = box;
    bad.centre.y = R(not_a_number());
    CHECK(yard_rest(&yard, &bad, 0, 0) == KERN_BAD_NUMBER);
    CHECK(yard.work.fault.block == 1);
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_OK);
    CHECK(yard.work.fault.block == -1);

    task->s.gravity.y = 0;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_NO_LOAD);
    task->s.gravity.y = -1;
    task->options.mu = -1;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_BAD_FRICTION);
    task->options.mu = 0;
    task->options.limit = 1;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_LIMIT);
    CHECK(yard.work.units == 2);
    task->options.limit = 0;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_OK);
    yard.block[0].vertices = -1;
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_NO_BLOCK);
    CHECK(yard.work.fault.block == 0);
    yard.block[0].vertices = 4;
    yard.block[0].box.high.x = (kern_real)R(not_a_number());
    CHECK(yard_rest(&yard, &box, 0, 0) == KERN_BAD_NUMBER);
    CHECK(kern_status_text(KERN_NO_REST) != kern_status_text(KERN_NO_SUPPORT));
}

/* ---- ranking, copies ---- */

static void rest_ranking(void)
{
    /* stays, margin, own, load, x, turn; the best first, alone 0.1 */
    static const kern_place order[8] = {
        {(kern_real)0.91, (kern_real)0.2, 0, 0, 5, 0},
        {(kern_real)0.9, (kern_real)0.1, 2, 1, 4, 0},
        {(kern_real)0.99, (kern_real)0.1000001, 1, 2, 6, 0},
        {(kern_real)0.95, (kern_real)0.1, 1, 1, 1, 0},
        {(kern_real)0.95, (kern_real)0.1, 1, 1, 2, -1},
        {(kern_real)0.95, (kern_real)0.1, 1, 1, 2, 1},
        {1, (kern_real)0.05, 9, 9, 0, 0},
        {(kern_real)0.89, 9, 9, 9, 0, 0}};
    const kern_real alone = (kern_real)0.1;
    int i, k;
    for (i = 0; i < 8; i++)
        for (k = 0; k < 8; k++) {
            const int got = kern_place_compare(&order[i], &order[k], alone);
            CHECK((got > 0) == (i < k) && (got < 0) == (i > k));
        }
    /* rounding does not decide, and what is not a number is worst */
    for (i = 0; i < 6; i++) {
        kern_place a = order[4], b = a, *of[2];
        kern_real *number[2][6];
        of[0] = &a;
        of[1] = &b;
        for (k = 0; k < 2; k++) {
            number[k][0] = &of[k]->stays;
            number[k][1] = &of[k]->margin;
            number[k][2] = &of[k]->own;
            number[k][3] = &of[k]->load;
            number[k][4] = &of[k]->x;
            number[k][5] = &of[k]->turn;
        }
        *number[0][1] = *number[1][1] = *number[0][2] = *number[1][2] = 1;
        *number[0][0] = *number[1][0] = (kern_real)0.7;
        *number[0][i] *= 1 + 8 * KERN_EPS;
        CHECK(kern_place_compare(&a, &b, alone) == (i < 4 ? 0 : 2 * i - 9));
        *number[0][i] = (kern_real)R(not_a_number());
        CHECK(kern_place_compare(&a, &b, alone) < 0);
        CHECK(kern_place_compare(&b, &a, alone) > 0);
        *number[1][i] = *number[0][i];
        CHECK(kern_place_compare(&a, &b, alone) == 0);
        *number[1][i] = KERN_INFINITY;
        CHECK(i >= 4 || kern_place_compare(&a, &b, alone) < 0);
    }
    CHECK(kern_place_compare(&order[0], NULL, alone) > 0);
    CHECK(kern_place_compare(NULL, &order[0], alone) < 0);
    CHECK(kern_place_compare(NULL, NULL, alone) == 0);
}

static void rest_copies(void)
{
    const kern_block box = yard_block(unit_box, 4);
    kern_margin a, b;
    int i;
    yard_build(&yard, 20);
    CHECK(kern_measure(&yard.plan.task, &a, NULL) == KERN_STANDS);
    yard_open(&other_yard);
    CHECK(kern_plan_copy(&other_yard.plan, NULL) == KERN_BAD_POINTER);
    CHECK(kern_plan_copy(NULL, &yard.plan) == KERN_BAD_POINTER);
    other_yard.plan.block_room = 20;
    CHECK(kern_plan_copy(&other_yard.plan, &yard.plan) == KERN_NO_SPACE);
    CHECK(other_yard.plan.task.s.blocks == 0);
    other_yard.plan.block_room = YARD_BLOCKS;
    other_yard.plan.contact_room = yard.plan.task.s.contacts - 1;
    CHECK(kern_plan_copy(&other_yard.plan, &yard.plan) == KERN_NO_SPACE);
    other_yard.plan.contact_room = YARD_POINTS;
    CHECK(kern_plan_copy(&other_yard.plan, &yard.plan) == KERN_OK);
    CHECK(other_yard.plan.task.s.block == other_yard.block);
    CHECK(other_yard.plan.task.work == &other_yard.work);
    for (i = 0; i < 20; i++) {
        kern_status got;
        if (yard_rest(&yard, &box, 0.3 * i, 0.2) != KERN_OK)
            continue;
        memset(&a, 0, sizeof a);
        memset(&b, 0, sizeof b);
        got = kern_plan_try(&yard.plan, &yard.pose.block, &a, NULL);
        CHECK(kern_plan_try(&other_yard.plan, &yard.pose.block, &b, NULL)
              == got);
        CHECK(memcmp(&a, &b, sizeof a) == 0);
        CHECK(yard.work.units == other_yard.work.units);
    }
}

static const test rest_tests[] = {
    TEST(rest_flat),     TEST(rest_over_an_edge), TEST(rest_triangles),
    TEST(rest_slopes),   TEST(rest_gaps),         TEST(rest_shapes),
    TEST(rest_corners),  TEST(rest_pocket),       TEST(rest_ladder),
    TEST(rest_slippery), TEST(rest_laws),         TEST(rest_poses),
    TEST(rest_teeth),    TEST(rest_ties),         TEST(rest_refused),
    TEST(rest_ranking),  TEST(rest_copies),
};

#endif
