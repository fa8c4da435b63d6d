/* simplify.h - outlines that kern_outline_simplify() simplifies. */

#ifndef UNIT_SIMPLIFY_H
#define UNIT_SIMPLIFY_H

#include "harness.h"
#include "worlds.h"

enum { RAW = 2000 };
static kern_vec raw_outline[RAW], changed_outline[RAW];
static kern_vec simple_outline[RAW], other_outline[RAW];
static int kept_vertices[RAW], other_kept[RAW];

/* A wavy stone of n points, on a grid if that is above 0. */
static void wavy_outline(int n, double grid)
{
    const double wave = uniform(0, 0.2), flat = uniform(0.6, 1);
    const int waves = random_int(2, 9);
    int i;
    for (i = 0; i < n; i++) {
        const double a = 2 * pi * (i + 0.5) / n;
        const double r = 1 + wave * sin(waves * a) + uniform(-1e-3, 1e-3);
        double x = r * cos(a), y = flat * r * sin(a);
        if (grid > 0) {
            x = floor(x / grid + 0.5) * grid;
            y = floor(y / grid + 0.5) * grid;
        }
        raw_outline[i] = vec(x, y);
    }
}

static int same_place(kern_vec p, kern_vec q)
{
    return p.x >= q.x && p.x <= q.x && p.y >= q.y && p.y <= q.y;
}

static int simplified(const kern_vec *raw, int n, double tolerance)
{
    return kern_outline_simplify(raw, n, R(tolerance), simple_outline,
                                 kept_vertices, n);
}

/* Distance of a point from a segment. */
static double way_from(kern_vec p, kern_vec a, kern_vec b)
{
    const double x = (double)(b.x - a.x), y = (double)(b.y - a.y);
    const double u = (double)(p.x - a.x), v = (double)(p.y - a.y);
    const double square = x * x + y * y;
    const double at = square > 0 ? fmin(fmax((u * x + v * y) / square, 0), 1)
                                 : 0;
    return hypot(u - at * x, v - at * y);
}

/* What is left out lies within the tolerance of the edge that replaces it; what
   remains is a polygon, its vertices are those of the indices. */
static void check_simplified(const kern_vec *raw, int n, int count,
                             double tolerance)
{
    kern_block b;
    int k, i;
    CHECK(count >= 3);
    CHECK_INT(kern_ground_init(&b, simple_outline, count, NULL), KERN_OK);
    for (k = 0; k < count; k++) {
        const int next = (k + 1) % count;
        CHECK(same_place(raw[kept_vertices[k]], simple_outline[k]));
        for (i = kept_vertices[k]; i != kept_vertices[next]; i = (i + 1) % n)
            CHECK(way_from(raw[i], simple_outline[k], simple_outline[next])
                  <= tolerance * (SINGLE ? 1.001 : 1.00001) + GEO);
    }
}

static void simplify_within(void)
{
    int trial;
    for (trial = 0; trial < 200; trial++) {
        const int n = random_int(60, 900);
        const double grid = trial % 2 ? uniform(2e-3, 2e-2) : 0;
        const double tolerance = trial % 2 ? uniform(0.8, 3) * grid
                                           : uniform(1e-3, 5e-2);
        int count;
        random_seed(77000u + (unsigned long long)trial);
        sprintf(context, "(outline %d)", trial);
        wavy_outline(n, grid);
        count = simplified(raw_outline, n, tolerance);
        if (count == KERN_CROSSING && tolerance < 1.5 * grid)
            continue; /* a neck of a pixel passes one point twice */
        CHECK(count < n);
        check_simplified(raw_outline, n, count, tolerance);
    }
    context[0] = 0;
}

/* The same polygon from any vertex on and whichever way it turns, also where
   vertices are equally far from an edge, as on a grid. */
static void simplify_starts(void)
{
    int trial, i, k;
    for (trial = 0; trial < 100; trial++) {
        random_seed(78000u + (unsigned long long)trial);
        const int n = random_int(60, 600), shift = random_int(1, n - 1);
        const double grid = trial % 3 ? 0.01 : 0;
        int count, got;
        sprintf(context, "(outline %d)", trial);
        wavy_outline(n, grid);
        count = simplified(raw_outline, n, 0.015);
        for (k = 0; k < 2; k++) {
            for (i = 0; i < n; i++)
                changed_outline[i] =
                    raw_outline[k ? n - 1 - i : (i + shift) % n];
            got = kern_outline_simplify(changed_outline, n, R(0.015),
                                        other_outline, other_kept, n);
            CHECK_INT(got, count);
            for (i = 0; i < got && got == count; i++)
                CHECK(same_place(simple_outline[i],
                                 other_outline[k && i ? got - i : i]));
        }
    }
    context[0] = 0;
}

/* Mirrored, turned and scaled it keeps the same vertices where none are equally
   far: within 1e-6, in float 1e-5, some are by chance. */
static void simplify_frames(void)
{
    int trial, i, other = 0;
    for (trial = 0; trial < 100; trial++) {
        random_seed(79000u + (unsigned long long)trial);
        const int n = random_int(60, 600);
        const double scale = trial % 3 == 0 ? pow(10, uniform(-3, 3)) : 1;
        const double angle = trial % 3 == 1 ? uniform(-pi, pi) : 0;
        const double mirror = trial % 3 == 2 ? -1 : 1;
        int count, got;
        sprintf(context, "(outline %d)", trial);
        wavy_outline(n, 0);
        count = simplified(raw_outline, n, 0.015);
        for (i = 0; i < n; i++) {
            const double x = mirror * (double)raw_outline[i].x;
            const double y = (double)raw_outline[i].y;
            changed_outline[i] = vec(scale * (x * cos(angle) - y * sin(angle)),
                                     scale * (x * sin(angle) + y * cos(angle)));
        }
        got = kern_outline_simplify(changed_outline, n, R(0.015 * scale),
                                    other_outline, other_kept, n);
        for (i = 0; i < got && got == count; i++)
            if (other_kept[i] != kept_vertices[i])
                break;
        other += got != count || i < count;
    }
    context[0] = 0;
    CHECK(other <= (SINGLE ? 4 : 1));
}

/* A round stone of many vertices on ground: it rests on its lowest place before
   and after, and weighs the same but for the tolerance. */
static void simplify_round_stones(void)
{
    static world w;
    int trial;
    for (trial = 0; trial < 40; trial++) {
        random_seed(80000u + (unsigned long long)trial);
        const int n = random_int(40, 400);
        const double tolerance = 5e-4; /* a quarter of the gap */
        const double turn = uniform(0, 2 * pi);
        double xy[800], low = 0;
        int i, raw;
        for (i = 0; i < n; i++)
            low = fmin(low, sin(turn + 2 * pi * i / n));
        for (i = 0; i < n; i++) {
            xy[2 * i] = cos(turn + 2 * pi * i / n);
            xy[2 * i + 1] = sin(turn + 2 * pi * i / n) - low;
        }
        sprintf(context, "(%d vertices)", n);
        world_reset(&w);
        w.options.gap = R(2e-3);
        world_polygon(&w, 1, xy, n);
        world_box(&w, 0, -2, -1, 2, 0);
        raw = world_touch(&w);
        world_simplify(&w, tolerance);
        CHECK(raw > 0);
        CHECK(world_touch(&w) > 0);
        CHECK_NEAR(w.contact[0].p.y, 0, 3e-3);
        CHECK_NEAR(fabs((double)w.block[0].area), pi * (1 - tolerance),
                   5 * tolerance + 20.0 / n / n);
    }
    context[0] = 0;
}

/* Where edges would cross, fewer vertices are left out: whatever the tolerance,
   a polygon stays one. */
static void simplify_stays_simple(void)
{
    int trial, i, less = 0;
    for (trial = 0; trial < 400; trial++) {
        random_seed(81000u + (unsigned long long)trial);
        const int n = random_int(8, 80);
        const double tolerance = pow(10, uniform(-2, 1));
        kern_block b;
        int count;
        sprintf(context, "(star %d)", trial);
        for (i = 0; i < n; i++) {
            const double a = 2 * pi * (i + uniform(0, 0.8)) / n;
            const double r = uniform(0.05, 1);
            raw_outline[i] = vec(r * cos(a), r * sin(a));
        }
        if (kern_ground_init(&b, raw_outline, n, NULL) != KERN_OK)
            continue;
        count = simplified(raw_outline, n, tolerance);
        check_simplified(raw_outline, n, count, tolerance);
        less += count < n;
    }
    CHECK(less > 200);
    context[0] = 0;
}

static void simplify_by_hand(void)
{
    /* a box with a vertex in an edge, one twice, a step and a notch */
    static const double xy[] = {0, 0,   0.5, 0,   1,   0,    1, 0,
                                1, 1,   0.6, 1,   0.6, 1.01, 0, 1.01,
                                0, 0.5, 0.3, 0.4, 0,   0.3};
    static const int want[3] = {4, 7, 9};
    static const double tolerance[3] = {0.31, 0.012, 0};
    int n = COUNT_OF(xy) / 2, i, k, count;
    for (i = 0; i < n; i++)
        raw_outline[i] = vec(xy[2 * i], xy[2 * i + 1]);
    for (k = 0; k < 3; k++) {
        count = simplified(raw_outline, n, tolerance[k]);
        CHECK_INT(count, want[k]);
        check_simplified(raw_outline, n, count, tolerance[k]);
    }
    /* a spike is no polygon, and goes where the tolerance is as long */
    raw_outline[8] = vec(-0.2, 0.5);
    raw_outline[9] = vec(0, 0.5);
    raw_outline[10] = vec(0, 0.3);
    raw_outline[7] = vec(0, 0.5);
    CHECK_INT(simplified(raw_outline, n, 0.1), KERN_CROSSING);
    CHECK(simplified(raw_outline, n, 0.21) > 3);
}

static void simplify_refused(void)
{
    static kern_vec out[RAW];
    static int kept[RAW];
    const double none = huge_value() - huge_value();
    int count, i;
    wavy_outline(300, 0.01);
    count = simplified(raw_outline, 300, 0.015);
    CHECK(count > 10);
    /* room for exactly the result is enough; less is told, and not exceeded */
    for (i = -1; i <= count; i++) {
        const int room = i < 0 ? -5 : i;
        int k;
        for (k = 0; k < RAW; k++) {
            out[k] = vec(7, 7);
            kept[k] = 7777;
        }
        CHECK_INT(
            kern_outline_simplify(raw_outline, 300, R(0.015), out, kept, room),
            i < count ? (int)KERN_NO_SPACE : count);
        for (k = room < 0 ? 0 : room; k < RAW; k++)
            CHECK(same_place(out[k], vec(7, 7)) && kept[k] == 7777);
    }
    CHECK_INT(kern_outline_simplify(NULL, 300, R(0.1), out, kept, RAW),
              KERN_BAD_POINTER);
    CHECK_INT(kern_outline_simplify(raw_outline, 300, R(0.1), NULL, kept, RAW),
              KERN_BAD_POINTER);
    CHECK_INT(kern_outline_simplify(raw_outline, 300, R(0.1), out, NULL, RAW),
              KERN_BAD_POINTER);
    CHECK_INT(simplified(raw_outline, 2, 0.1), KERN_FEW_VERTICES);
    CHECK_INT(simplified(raw_outline, -1, 0.1), KERN_BAD_COUNT);
    CHECK_INT(simplified(raw_outline, 1000001, 0.1), KERN_BAD_COUNT);
    CHECK_INT(simplified(raw_outline, 300, -1e-9), KERN_BAD_OPTION);
    CHECK_INT(simplified(raw_outline, 300, none), KERN_BAD_OPTION);
    CHECK_INT(simplified(raw_outline, 300, huge_value()), KERN_BAD_OPTION);
    for (i = 0; i < 300; i += 150) {
        const kern_vec v = raw_outline[i];
        raw_outline[i].x = R(none);
        CHECK_INT(simplified(raw_outline, 300, 0.1), KERN_BAD_NUMBER);
        raw_outline[i].x = R(SINGLE ? 1e20 : 1e200);
        CHECK_INT(simplified(raw_outline, 300, 0.1), KERN_BAD_NUMBER);
        raw_outline[i] = v;
    }
    /* a tolerance above the size leaves as little as is a polygon */
    count = simplified(raw_outline, 300, 100);
    check_simplified(raw_outline, 300, count, 100);
    for (i = 0; i < 10; i++)
        raw_outline[i] = vec(1, 2);
    CHECK(simplified(raw_outline, 10, 0.1) < 0);
    for (i = 0; i < 10; i++)
        raw_outline[i] = vec(i, 2 * i);
    CHECK(simplified(raw_outline, 10, 0.1) < 0);
}

static const test simplify_tests[] = {
    TEST(simplify_by_hand),      TEST(simplify_within),
    TEST(simplify_starts),       TEST(simplify_frames),
    TEST(simplify_round_stones), TEST(simplify_stays_simple),
    TEST(simplify_refused),
};

#endif
