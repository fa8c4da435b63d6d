/* jams.h - wedges that hold each other. */

#ifndef UNIT_JAMS_H
#define UNIT_JAMS_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "verdict.h"

/* A chockstone in two pieces between two walls that lean; 0 where there is no
   such thing. */
static int two_wedges(world *w)
{
    const double y0 = uniform(0.05, 0.4), y1 = y0 + uniform(0.8, 2);
    const double left = uniform(-0.15, 0.6), right = uniform(-0.15, 0.6);
    const double half = uniform(0.3, 0.8), x = uniform(-0.3, 0.3);
    const double top = x + uniform(-0.4, 0.4) * (y1 - y0);
    const double l0 = -half - left * y0, l1 = -half - left * y1;
    const double r0 = half + right * y0, r1 = half + right * y1;
    double wall[2][8] = {{-9, 0, 0, 0, 0, 4, -9, 4}, {0, 0, 9, 0, 9, 4, 0, 4}};
    double piece[2][8];
    if (x < l0 + 0.05 || top < l1 + 0.05 || x > r0 - 0.05 || top > r1 - 0.05)
        return 0;
    wall[0][2] = -half;
    wall[0][4] = -half - 4 * left;
    wall[1][0] = half;
    wall[1][6] = half + 4 * right;
    piece[0][0] = l0, piece[0][1] = y0, piece[0][2] = x, piece[0][3] = y0;
    piece[0][4] = top, piece[0][5] = y1, piece[0][6] = l1, piece[0][7] = y1;
    piece[1][0] = x, piece[1][1] = y0, piece[1][2] = r0, piece[1][3] = y0;
    piece[1][4] = r1, piece[1][5] = y1, piece[1][6] = top, piece[1][7] = y1;
    world_reset(w);
    w->options.mu = R(uniform(0.3, 0.9));
    world_polygon(w, 0, wall[0], 4);
    world_polygon(w, 0, wall[1], 4);
    world_polygon(w, 1, piece[0], 4);
    world_polygon(w, 1, piece[1], 4);
    world_touch(w);
    return 1;
}

/* Near to critical the forces of a jam grow like 1 / (d* - d), up to the bound.
   It must not use up the limit of program after program: 211,315 pivots were
   seen. */
static void jams_are_bounded(void)
{
    static world w;
    int seed, most = 0, found = 0;
    for (seed = 0; seed < (quick ? 3000 : 40000); seed++) {
        kern_work work;
        kern_margin m;
        random_seed(730000u + (unsigned long long)seed);
        sprintf(context, "(two wedges %d)", seed);
        if (!two_wedges(&w))
            continue;
        work = work_of(&w);
        CHECK(kern_measure(world_task(&w, &work), &m, NULL) >= 0 || SINGLE);
        most = work.pivots > most ? work.pivots : most;
        found++;
    }
    context[0] = 0;
    CHECK(found > (quick ? 1000 : 20000));
    CHECK(most <= 5000);
}

/* Flat arches of many voussoirs between two walls, laid in any order: about half
   of their height their thrust is at its bound. Their blocks are at one height
   but for rounding; were it that to order them, the factors of a basis would
   fill all the room that there is, and brackets be up to 7e-6 sizes wide. */
static void jams_fill_the_factors(void)
{
    static const double slender[][2] = {{31, 150}, {40, 30}, {50, 25}, {52, 60},
                                        {54, 90},  {58, 30}, {62, 150}};
    static world w;
    int i, k, side;
    for (k = 0; k < 2 * COUNT_OF(slender) && !SINGLE; k++) {
        const int n = (int)slender[k / 2][0], stride = k % 2 ? 7 : 1;
        const double high = n / slender[k / 2][1], lean = 0.45 / n;
        kern_work work;
        kern_margin m;
        sprintf(context, "(flat arch of %d, every %dth)", n, stride);
        world_reset(&w);
        w.options.mu = R(0.5);
        for (i = 0; i < n; i++) {
            const double a = i * stride % n - n / 2.0, b = a + 1;
            const double xy[] = {
                a,   0, b, 0, b + b * lean * high, high, a + a * lean * high,
                high};
            world_polygon(&w, 1, xy, 4);
        }
        for (side = -1; side <= 1; side += 2) {
            const double a = side * n / 2.0, b = a + side * n;
            const double xy[] = {a,   0, b, 0, b, high, a + a * lean * high,
                                 high};
            world_polygon(&w, 0, xy, 4);
        }
        world_touch(&w);
        work = work_of(&w);
        CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_STANDS);
        CHECK_NEAR(m.margin, high / 2, 0.02 * high);
        CHECK(m.fails - m.holds <= 2e-6 * mean_size(&w));
    }
    context[0] = 0;
}

/* A pile of stones that fit: a bed has a knee below the middle of each stone,
   heads touch, and a corner that meets a knee is a lone point that travels. */
static void fitted_pile(world *w, int wide)
{
    double height[MAX_BLOCKS], above[MAX_BLOCKS];
    int course, i, k;
    world_reset(w);
    world_box(w, 0, -3, -1, wide + 3, 0);
    memset(height, 0, sizeof height);
    for (course = 0; course < wide; course++) {
        for (k = 0; k <= 2 * wide; k++)
            above[k] = 0.6 * (course + 1) + uniform(-0.08, 0.08);
        for (i = 0; i < wide - course; i++) {
            double xy[12];
            for (k = 0; k < 3; k++) {
                const int at = course + 2 * i + k;
                xy[2 * k] = xy[10 - 2 * k] = 0.5 * at;
                xy[2 * k + 1] = height[at];
                xy[11 - 2 * k] = above[at];
            }
            world_polygon(w, 1, xy, 6);
        }
        memcpy(height, above, sizeof height);
    }
    CHECK(world_touch(w) > 0);
}

/* Points that travel are left out of the first search. The margin is still that
   of the whole: it stands at every smaller shrinkage, and falls beyond. */
static void fitted_piles(void)
{
    static world w;
    int seed, i, apart = 0;
    for (seed = 0; seed < some(24); seed++) {
        kern_margin m;
        random_seed(760000u + (unsigned long long)seed);
        sprintf(context, "(fitted %d)", seed);
        fitted_pile(&w, random_int(2, 7));
        w.options.mu = R(uniform(0.4, 0.9));
        w.gravity = vec(9.81 * uniform(-0.1, 0.1), -9.81);
        CHECK(world_touch(&w) > 0);
        apart += !twin_nested(&w);
        if (measure(&w, &m) != KERN_STANDS)
            continue;
        check_bracket(&w, &m);
        for (i = 0; i < 40; i++)
            CHECK(verdict(&w, (double)m.holds * i / 40) == KERN_STANDS);
        CHECK(m.saturated
              || m.level == (int)((double)m.holds / (double)m.epsilon)
              || m.level == (int)((double)m.fails / (double)m.epsilon));
    }
    context[0] = 0;
    CHECK(apart > some(24) / 2);
}

/* Rows of stones between two walls, which lean by `lean` as in a hopper. */
static void jam_rows(world *w, int rows, int wide, double lean)
{
    const double high = rows + 0.5;
    double joint[MAX_BLOCKS], next[MAX_BLOCKS];
    int row, i;
    double left[8] = {-20, -0.5, 0, -0.5, 0, 0, -20, 0};
    double right[8] = {0, -0.5, 0, -0.5, 0, 0, 0, 0};
    world_reset(w);
    left[2] = lean / 2;
    left[4] = -lean * high;
    left[5] = left[7] = right[5] = right[7] = high;
    right[0] = wide - lean / 2;
    right[2] = right[4] = wide + 20;
    right[6] = wide + lean * high;
    world_polygon(w, 0, left, 4);
    world_polygon(w, 0, right, 4);
    for (row = 0; row < rows; row++)
        for (i = 0; i <= wide; i++) {
            const double inside = i > 0 && i < wide;
            const double span = wide + 2 * lean * (row + 1);
            if (row == 0)
                joint[i] = i + inside * uniform(-0.2, 0.2);
            next[i] = span * i / wide - lean * (row + 1)
                    + inside * uniform(-0.2, 0.2);
            if (i > 0) {
                const double xy[8] = {joint[i - 1], row,      joint[i],
                                      row,          next[i],  row + 1,
                                      next[i - 1],  row + 1.0};
                world_polygon(w, exp(uniform(-2, 2)), xy, 4);
                joint[i - 1] = next[i - 1];
            }
            if (i == wide)
                joint[i] = next[i];
        }
    CHECK(world_touch(w) > 0);
}

/* In hoppers forces grow without bound toward the margin: it is decided all the
   same, within 1e-4 of the mean size. */
static void jams_are_decided(void)
{
    static world w;
    int seed, stands = 0;
    for (seed = 0; seed < some(40); seed++) {
        const kern_proof proof = proof_here();
        kern_work work;
        kern_margin m;
        int got;
        random_seed(770000u + (unsigned long long)seed);
        sprintf(context, "(jam %d)", seed);
        jam_rows(&w, random_int(2, 6), random_int(2, 6), uniform(0.05, 0.6));
        w.options.mu = R(uniform(0.3, 0.8));
        CHECK(world_touch(&w) > 0);
        work = work_of(&w);
        got = kern_measure(world_task(&w, &work), &m, &proof);
        CHECK(SINGLE || decided(got));
        if (got != KERN_STANDS)
            continue;
        stands++;
        CHECK(share_of_forces(&w, (double)m.holds, force_of) <= 1.001);
        CHECK(m.saturated
              || share_of_motion(&w, (double)m.fails, motion_of) <= 1.001);
        CHECK(SINGLE || (double)(m.fails - m.holds) <= 1e-4 * 1.5);
    }
    context[0] = 0;
    CHECK(stands > some(40) / 2);
}

/* Two small stones on a large one, turned, far from the origin: both proofs hold
   at one place, where a collapse took nothing away for ever. */
static void profile_ends(void)
{
    static const double corner[4][8] = {
        {499997.0205986467, 98.94020399325342, 500003.0193986867,
         99.06019599341343, 500002.99940002, 100.05999600008, 499997.00059998,
         99.94000399992},
        {499999.5000999967, 99.99000066665333, 500000.4999000033,
         100.00999933334667, 500000.4879008033, 100.60987933734661,
         499999.48810081665, 100.58988067065327},
        {499999.7174670727, 100.5944686079159, 499999.81744707335,
         100.59646847458524, 499999.8162471534, 100.65645647498523,
         499999.71626715275, 100.6544566083159},
        {499999.86743707367, 100.5974684079199, 499999.96741707437,
         100.59946827458924, 499999.9662171544, 100.65945627498924,
         499999.8662371537, 100.6574564083199}};
    static world w;
    kern_real value[4];
    kern_collapse c;
    kern_work work;
    int i, side, got;
    if (SINGLE)
        return; /* no digits are left there */
    world_reset(&w);
    w.gravity = vec(0.19618692026159754, -9.808038065399128);
    for (i = 0; i < 4; i++)
        world_polygon(&w, i > 0, corner[i], 4);
    world_touch(&w);
    work = work_of(&w);
    for (side = -1; side <= 1; side++) {
        got = kern_profile(world_task(&w, &work), side, value, &c);
        CHECK(got == KERN_OK || got == KERN_UNDECIDED);
    }
    CHECK(work.pivots < 1000);
}

static const test jams_tests[] = {
    TEST(jams_are_bounded), TEST(jams_fill_the_factors), TEST(fitted_piles),
    TEST(jams_are_decided), TEST(profile_ends),
};

#endif
