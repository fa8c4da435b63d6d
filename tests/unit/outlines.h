/* outlines.h - outlines of many vertices. */

#ifndef UNIT_OUTLINES_H
#define UNIT_OUTLINES_H

#include "harness.h"
#include "worlds.h"

enum { LONG = 10000 };
static kern_vec long_outline[2][LONG];

/* A wavy ring, or its mirror image below it with vertices in between, that
   turns either way. */
static kern_status long_ring(kern_block *b, int n, int below, int clockwise,
                             kern_fault *fault)
{
    kern_vec *v = long_outline[below];
    int i;
    for (i = 0; i < n; i++) {
        const double a = 2 * pi * ((clockwise ? n - i : i) + (below ? 0.3 : 0))
                       / n;
        const double r = 1 + 0.05 * sin(7 * a);
        v[i] = vec(r * cos(a), r * sin(a));
        if (below)
            v[i].y = R(-2.1 - (double)v[i].y);
    }
    return below ? kern_ground_init(b, v, n, fault)
                 : kern_block_init(b, v, n, 1, fault);
}

static void rings_of(int n)
{
    static kern_contact out[2000];
    const kern_options o = kern_defaults();
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_block block[2];
    kern_fault fault;
    int k, got[4];
    for (k = 0; k < 4; k++) {
        CHECK_INT(long_ring(&block[0], n, 0, k & 1, NULL), KERN_OK);
        CHECK_INT(long_ring(&block[1], n, 1, k >> 1, NULL), KERN_OK);
        got[k] = kern_touch(block, 1, &o, out, 2000, &work);
        CHECK(got[k] > 0 && got[k] <= 4);
        CHECK_INT(got[k], got[0]);
        CHECK_NEAR(out[0].p.y, -1.05, 2e-3);
        CHECK_NEAR(out[0].n.y, -1, 1e-3);
    }
    for (k = 0; k < n; k++) /* into each other by a tenth */
        long_outline[1][k].y += R(0.1);
    kern_ground_init(&block[1], long_outline[1], n, NULL);
    CHECK_INT(kern_touch(block, 1, &o, out, 2000, &work), KERN_OVERLAP);
    /* one vertex on the other side of the ring */
    long_outline[0][n / 3] = vec(-1.5 * cos(2 * pi / 3),
                                 -1.5 * sin(2 * pi / 3));
    CHECK_INT(kern_block_init(&block[0], long_outline[0], n, R(1), &fault),
              KERN_CROSSING);
    CHECK(fault.index >= 0 && fault.index <= n / 3);
}

static void long_outlines(void)
{
    CHECK(grows_less(rings_of, LONG / 16, 12));
    rings_of(SINGLE ? 2000 : LONG);
}

/* Two stones that fit along a joint of n pixels. */
static void joint_of_pixels(int n)
{
    static kern_contact out[20000];
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_options o = kern_defaults();
    static kern_vec simple[2][20];
    static int kept[20];
    kern_block block[2];
    int c, i, k = 1, last = 0;
    long_outline[0][0] = vec(0, 0);
    for (c = 0; c < n; c++) {
        const int high = (int)floor(0.6 * (c + 0.5) + 0.5);
        if (high != last) {
            long_outline[0][k++] = vec((double)c / n, (double)last / n);
            long_outline[0][k++] = vec((double)c / n, (double)high / n);
        }
        last = high;
    }
    long_outline[0][k++] = vec(1, (double)last / n);
    for (i = 0; i < k; i++)
        long_outline[1][i] = long_outline[0][i];
    long_outline[0][k] = vec(1, 2);
    long_outline[0][k + 1] = vec(0, 2);
    long_outline[1][k] = vec(1, -1);
    long_outline[1][k + 1] = vec(0, -1);
    o.gap = R(1.5 / n);
    for (i = 0; i < 2; i++) {
        const int got = kern_outline_simplify(long_outline[i], k + 2,
                                              R(1.5 / n), simple[i], kept, 20);
        CHECK_INT(got, 4);
        CHECK_INT(i ? kern_ground_init(&block[i], simple[i], got, NULL)
                    : kern_block_init(&block[i], simple[i], got, R(1), NULL),
                  KERN_OK);
    }
    CHECK_INT(kern_touch(block, 1, &o, out, 20000, &work), 2);
    CHECK_NEAR(fabs((double)out[0].travel), sqrt(1.36) / 2, 1.5 / n);
}

/* Two combs of n teeth in each other: one contact along all their tips, one in
   all gaps, and one at each side of a tooth but the two outermost. */
static void joint_of_teeth(int n)
{
    static kern_contact out[20000];
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    const kern_options o = kern_defaults();
    kern_block block[2];
    int i, k = 0;
    for (i = 0; i < n; i++, k += 4) {
        long_outline[0][k] = vec(2 * i, 1);
        long_outline[0][k + 1] = vec(2 * i + 1, 1);
        long_outline[0][k + 2] = vec(2 * i + 1, 0);
        long_outline[0][k + 3] = vec(2 * i + 2, 0);
    }
    for (i = 0; i < k; i++)
        long_outline[1][i] = long_outline[0][i];
    for (i = 0; i < 2; i++) {
        long_outline[i][k] = vec(2 * n, i ? -5 : 6);
        long_outline[i][k + 1] = vec(0, i ? -5 : 6);
        CHECK_INT(
            kern_block_init(&block[i], long_outline[i], k + 2, R(1), NULL),
            KERN_OK);
    }
    CHECK_INT(kern_touch(block, 1, &o, out, 20000, &work), 4 * n + 2);
}

static void long_joint(void)
{
    CHECK(grows_less(joint_of_pixels, 125, 12));
    joint_of_pixels(2000);
    CHECK(grows_less(joint_of_teeth, 30, 50));
}

/* An L in an L, with a joint of three gaps: no steps of a gap each go along it
   where overlap is looked for. There would be 3e8. */
static void open_joint(void)
{
    static const double outer[] = {-1, -1, 2, -1, 2, 0, 0, 0, 0, 2, -1, 2};
    const double gap = SINGLE ? 1e-4 : 1e-9, joint = 3 * gap;
    double inner[] = {0,   0,   1,   0,   1,   0.5, 0.6, 0.5,
                      0.6, 1.5, 0.3, 1.5, 0.3, 1.2, 0,   1.2};
    static world w;
    const clock_t start = clock();
    inner[0] = inner[14] = joint;
    world_reset(&w);
    w.options.gap = R(gap);
    world_polygon(&w, 0, outer, 6);
    world_polygon(&w, 1, inner, 8);
    CHECK_INT(world_touch(&w), 2);
    CHECK(clock() - start < CLOCKS_PER_SEC);
}

static const test outlines_tests[] = {
    TEST(long_outlines),
    TEST(long_joint),
    TEST(open_joint),
};

#endif
