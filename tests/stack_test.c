/* stack_test - are the stones, the geometry and the walls of the planner right?

       cc -O2 -ffp-contract=off -o stack_test tests/stack_test.c -lm
       ./stack_test            walls from 1 seed a level and planner
       ./stack_test 20         from 20

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "../examples/parts/draw.h"
#include "../examples/laboratory/rigid.h"
#include "../examples/parts/text.h"

#include "../examples/laboratory/drop.h"
#include "../examples/laboratory/masonry.h"
#include "../examples/laboratory/stones.h"
#include "../examples/laboratory/stack.h"

static const double pi = 3.14159265358979323846;
static int failures;

static void check(int good, const char *what, double found, double wanted)
{
    if (good)
        return;
    printf("FAILED  %s: %.9g, wanted %.9g\n", what, found, wanted);
    failures++;
}

static void near_to(const char *what, double found, double wanted,
                    double allowed)
{
    check(fabs(found - wanted) <= allowed, what, found, wanted);
}

/* ---- Statistics of the stones that are made ------------------------------ */

/* Means over stones of 0.25 and more of the mean area; `aspect` is a median. */
struct shape {
    double corners, rect, aspect, cv, corner, least;
};

static int ascending(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The smallest rectangle around a convex stone lies along one of its edges. */
static void smallest_box(const struct stone *s, double *area, double *aspect)
{
    *area = HUGE_VAL;
    for (int i = 0; i < s->n; i++) {
        kern_vec n = rest_edge_at(s, i).n, t = stones_vec(-n.y, n.x);
        double low[2] = {HUGE_VAL, HUGE_VAL};
        double high[2] = {-HUGE_VAL, -HUGE_VAL}, a, b;
        for (int k = 0; k < s->n; k++) {
            double along = stones_dot(t, s->v[k]), out = stones_dot(n, s->v[k]);
            low[0] = fmin(low[0], along);
            high[0] = fmax(high[0], along);
            low[1] = fmin(low[1], out);
            high[1] = fmax(high[1], out);
        }
        a = high[0] - low[0];
        b = high[1] - low[1];
        if (a * b >= *area)
            continue;
        *area = a * b;
        *aspect = fmax(a, b) / fmin(a, b);
    }
}

/* Departure of the four largest turns from 90 degrees, and the least interior
   angle, in degrees. */
static void angles(const struct stone *s, double *corner, double *least)
{
    double turn[STONES_CORNERS];
    int most = s->n < 4 ? s->n : 4;
    for (int i = 0; i < s->n; i++) {
        kern_vec a = rest_edge_at(s, i).n;
        kern_vec b = rest_edge_at(s, i + 1 < s->n ? i + 1 : 0).n;
        turn[i] = atan2(stones_cross(a, b), stones_dot(a, b)) * 180 / pi;
    }
    qsort(turn, (size_t)s->n, sizeof *turn, ascending);
    *least = 180 - turn[s->n - 1];
    *corner = 0;
    for (int i = 0; i < most; i++)
        *corner += fabs(turn[s->n - 1 - i] - 90) / most;
}

static struct shape statistics(const struct stones *all)
{
    struct shape mean = {0, 0, 0, 0, 0, 0};
    double *aspect = malloc((size_t)all->stones * sizeof *aspect);
    double sum = 0, squares = 0;
    int n = 0;
    for (int i = 0; i < all->stones && aspect; i++) {
        const struct stone *s = &all->stone[i];
        double box = 1, corner, least;
        if (s->area < 0.25)
            continue;
        smallest_box(s, &box, &aspect[n++]);
        angles(s, &corner, &least);
        mean.corners += s->n;
        mean.rect += s->area / box;
        mean.corner += corner;
        mean.least += least;
        sum += s->area;
        squares += s->area * s->area;
    }
    qsort(aspect, (size_t)n, sizeof *aspect, ascending);
    mean.corners /= n;
    mean.rect /= n;
    mean.corner /= n;
    mean.least /= n;
    mean.aspect = aspect[n / 2];
    mean.cv = sqrt(squares / n - sum / n * (sum / n)) / (sum / n);
    free(aspect);
    return mean;
}

/* Against published statistics of 600 stones a level. */
static void test_generator(void)
{
    static const struct shape wanted[] = {
        {4.4, 0.92, 1.52, 0.18, 5.5, 84},  {4.7, 0.85, 1.53, 0.22, 11.5, 79},
        {5.1, 0.81, 1.55, 0.27, 16.3, 77}, {5.1, 0.76, 1.62, 0.31, 19.5, 73},
        {5.0, 0.73, 1.64, 0.36, 22.1, 68},
    };
    for (int l = 0; l < 5; l++) {
        struct stones all;
        struct shape found;
        stones_make(&all, 10 + 10 * l, 1000, 0, 7);
        found = statistics(&all);
        near_to("corners of a stone", found.corners, wanted[l].corners, 0.15);
        near_to("share of the smallest rectangle", found.rect, wanted[l].rect,
                0.015);
        near_to("aspect", found.aspect, wanted[l].aspect, 0.06);
        near_to("deviation of the area", found.cv, wanted[l].cv, 0.025);
        near_to("turn off 90 degrees", found.corner, wanted[l].corner, 1);
        near_to("least angle", found.least, wanted[l].least, 2);
        near_to("mean area", all.area, 1, 0.05);
        stones_free(&all);
    }
}

/* ---- Geometry by hand ---------------------------------------------------- */

static struct stone box(double left, double low, double right, double high)
{
    const kern_vec v[4] = {
        {left, low}, {right, low}, {right, high}, {left, high}};
    struct stone s;
    stone_of(&s, v, 4);
    stone_move(&s, stones_vec((left + right) / 2, (low + high) / 2));
    return s;
}

static void put(struct stack_wall *w, double left, double low, double right,
                double high)
{
    struct stack_place place = {0, {0, 0}, {1, 0}, HUGE_VAL};
    struct stones *stock = (struct stones *)(size_t)w->stock;
    place.stone = w->laid;
    place.at = stones_vec((left + right) / 2, (low + high) / 2);
    stock->stone[w->laid] = box(left, low, right, high);
    stone_move(&stock->stone[w->laid], stones_vec(-place.at.x, -place.at.y));
    check(stack_lay(w, &place) == 0, "a box stands", left, low);
}

/* Boxes 0..1 and 1.5..2.5, both 1 high, in a frame of 4 by 3. */
static int two_boxes(struct stack_wall *w, struct stones *stock)
{
    struct stack_options o = stack_defaults();
    o.width = 4;
    o.height = 3;
    stones_make(stock, 0, 4, 0, 1);
    stock->size = stock->area = 1;
    if (stack_open(w, stock, &o))
        return -1;
    put(w, 0, 0, 1, 1);
    put(w, 1.5, 0, 2.5, 1);
    stack_look(w, -1, 5, -1);
    return 0;
}

static void test_features(void)
{
    const double column = 1.0 / STACK_COLUMNS;
    struct stones stock;
    struct stack_wall w;
    struct stone slab = box(0.25, 1, 2.25, 1.5), low = box(1, 0, 1.5, 0.5);
    struct stone roof;
    const kern_vec gable[5] = {{0, 0}, {2, 0}, {2, 1}, {1, 1.5}, {0, 1}};
    if (two_boxes(&w, &stock))
        return;
    stone_of(&roof, gable, 5);
    /* the slab lies on 0.75 + 0.75 of its perimeter of 5 */
    near_to("common edges of a slab", stack_edges(&w.around, &slab), 0.3,
            1e-12);
    /* a box in the gap: 0.5 below and 0.5 on either side of 2 */
    near_to("common edges in a gap", stack_edges(&w.around, &low), 0.75, 1e-12);
    near_to("hole below a slab", stack_hole(&w, &slab), 0.5, 2 * column);
    near_to("no hole in the gap", stack_hole(&w, &low), 0, 1e-12);
    /* the gap's neighbours: 1 high over half a stone on both sides */
    near_to("neighbours of a gap", stack_neighbours(&w, &low), 1, 1e-12);
    /* the slab's: left 0.25 of 0.5 is outside of the frame, what is in it is
       1 high; right half 1 high, half nothing; 1 below the slab */
    near_to("neighbours of a slab", stack_neighbours(&w, &slab),
            (1 + 0.5) / 2 - 1, 2 * column);
    near_to("slope of a box", stack_slope(&slab), 0, 0);
    near_to("slope of a gable", stack_slope(&roof), 0.5, 1e-12);
    /* joints below the slab at 1, 1.5 and 2.5; its right end is at 2.25 */
    near_to("bond of a slab", stack_bond(&w, &slab), 0.25, column);
    near_to("area in a frame", stone_area_in(&slab, 1.25, 1.25), 0.25, 1e-12);
    near_to("area of a gable's lower half", stone_area_in(&roof, 9, 9),
            /* its centroid is at 0, 0: what lies right of it and above */
            roof.area / 2 - 1 * -roof.low.y, 1e-9);
    stack_free(&w);
    stones_free(&stock);
}

/* A closed sky: notches of less than k columns are filled. */
static void test_sky(void)
{
    const double sky[8] = {1, 0, 2, 0, 0, 0, 3, 0};
    const double wanted[8] = {1, 1, 2, 0, 0, 0, 3, 3};
    const double wide[8] = {2, 2, 2, 2, 2, 2, 3, 3};
    double room[20], out[20];
    stack_close(sky, 8, 2, room, out);
    for (int i = 0; i < 8; i++)
        near_to("closed sky", out[i + 1], wanted[i], 0);
    stack_close(sky, 8, 4, room, out);
    for (int i = 1; i < 8; i++)
        near_to("sky closed wider", out[i + 3], wide[i], 0);
}

/* Bricks of 2 by 1 in courses, each course moved by `shift` against the one
   below. */
static int bricks(struct stack_wall *w, struct stones *stock, double shift)
{
    enum { LONG = 5, COURSES = 5 };
    struct stack_options o = stack_defaults();
    o.width = 12;
    o.height = 6;
    stones_make(stock, 0, LONG * COURSES, 0, 1);
    stock->size = sqrt(2);
    stock->area = 2;
    if (stack_open(w, stock, &o))
        return -1;
    for (int c = 0; c < COURSES; c++)
        for (int i = 0; i < LONG; i++) {
            double left = 2 * i + (c % 2) * shift;
            put(w, left, c, left + 2, c + 1);
        }
    return 0;
}

/* Up to 4 of 5 courses a way passes 3 beds, each along half a brick. */
static void test_masonry(void)
{
    const double shift[3] = {0, 0.5, 0.9};
    for (int k = 0; k < 3; k++) {
        struct stones stock;
        struct stack_wall w;
        struct masonry m;
        if (bricks(&w, &stock, shift[k]))
            return;
        check(masonry_of(&w.plan.task.s, stock.size, &m) == 0, "masonry", 0, 0);
        near_to("way through the joints", m.joint, (4 + 3 * shift[k]) / 4,
                0.03);
        near_to("no brick off level", m.off_level, 0, 0);
        near_to("bricks without bed", m.bedless, 0, 0);
        near_to("no support is a corner", m.corners, 0, 0);
        near_to("no joint gapes", m.gaping, 0, 0);
        near_to("courses are level", m.uneven, 0, 1e-12);
        /* of each upper course all bricks but one at an end */
        near_to("bricks on two", m.on_two, shift[k] > 0 ? 0.8 : 0, 1e-12);
        near_to("ends that are columns", m.end_columns, shift[k] > 0 ? 0 : 1,
                0);
        near_to("joints through three courses", m.running, shift[k] > 0 ? 0 : 4,
                0);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* A wall with a known answer, all stones of size 1: two boxes carry a slab on
   beds, a lower one carries a box; a diamond lies on a corner of the slab and
   one of the box. Of three head joints two gape; the first course has tops at
   1, 1 and 0.8. */
static void test_counts(void)
{
    enum { BLOCKS = 7, POINTS = 64 };
    static const kern_vec v[BLOCKS][4] = {
        {{-1, -1}, {5, -1}, {5, 0}, {-1, 0}},
        {{0, 0}, {1, 0}, {1, 1}, {0, 1}},
        {{1.05, 0}, {2.05, 0}, {2.05, 1}, {1.05, 1}},
        {{2.35, 0}, {3.6, 0}, {3.6, 0.8}, {2.35, 0.8}},
        {{0.4, 1}, {1.65, 1}, {1.65, 1.8}, {0.4, 1.8}},
        {{2.6, 0.8}, {3.6, 0.8}, {3.6, 1.8}, {2.6, 1.8}},
        {{2.125, 1.325},
         {2.83210678, 2.03210678},
         {2.125, 2.73921356},
         {1.41789322, 2.03210678}}};
    struct stones stock;
    struct stack_wall w;
    kern_structure s = {0};
    kern_block block[BLOCKS];
    kern_contact contact[POINTS];
    struct masonry m;
    if (two_boxes(&w, &stock))
        return;
    kern_ground_init(&block[0], v[0], 4, NULL);
    for (int i = 1; i < BLOCKS; i++)
        kern_block_init(&block[i], v[i], 4, 1, NULL);
    s.block = block;
    s.blocks = BLOCKS;
    s.contact = contact;
    s.contacts = kern_contacts(block, BLOCKS, &w.plan.task.options, contact,
                               POINTS, &w.work);
    check(masonry_of(&s, 1, &m) == 0, "masonry", s.contacts, 0);
    near_to("on two beds", m.on_two, 1.0 / 3, 1e-12);
    near_to("no bed", m.bedless, 1.0 / 3, 1e-12);
    near_to("corners of the supports", m.corners, 2.0 / 5, 1e-12);
    near_to("off level", m.off_level, 1.0 / 6, 1e-12);
    near_to("joints that gape", m.gaping, 2.0 / 3, 1e-12);
    near_to("tops of the courses", m.uneven, sqrt(0.08 / 3 / 5), 1e-9);
    stack_free(&w);
    stones_free(&stock);
}

/* Tops that one face may lie on: of one height, or hardly different; those that
   differ by more, and a notch for which no stone has a bend, are none. A stone is
   dressed to the height of the one beside it where its share allows that. */
static void test_matches(void)
{
    const double high[4] = {1, 1.001, 1.03, 0.95};
    struct stones stock;
    struct stack_wall w;
    if (two_boxes(&w, &stock))
        return;
    for (int k = 0; k < 4; k++) {
        const struct stone s = box(2.52, 0, 3.52, high[k]);
        check(stack_matches(&w, 3, &s) == (k < 2), "tops that match", k, k < 2);
    }
    const struct stone much = box(2.52, 0, 3.52, 1.1);
    const struct stone little = box(2.52, 0, 3.52, 1.04);
    check(!(stack_dressed(&w, &little) < HUGE_VAL), "no stone is dressed", 0,
          1);
    w.options.dress = 0.05;
    near_to("dressed to the box beside it", stack_dressed(&w, &little), 1, 0);
    check(!(stack_dressed(&w, &much) < HUGE_VAL), "too much to dress", 0, 1);
    struct stone wedge = box(2.52, 0, 3.52, 1);
    wedge.v[2].y = 1.2; /* its right upper corner */
    wedge.high.y = 1.2;
    wedge.area = 1.1;
    near_to("as far as the share allows", stack_lowest_top(&w, &wedge),
            1.2 - sqrt(2 * 0.05 * 1.1 * 0.2), 1e-5);
    check(stone_dress(&wedge, stones_vec(0, 1), 1.1) == 0, "dressed", 0, 0);
    near_to("area that is left", wedge.area, 1.1 - 0.1 * 0.5 / 2, 1e-12);
    near_to("top that is left", wedge.high.y, 1.1, 1e-12);
    stack_free(&w);
    stones_free(&stock);
}

static void test_courses(void)
{
    struct stones stock;
    struct stack_wall w;
    struct stone slab = box(0.25, 1, 2.25, 1.5), post = box(2.6, 0, 3, 2);
    struct stone low = box(1, 0, 1.5, 0.5);
    if (two_boxes(&w, &stock))
        return;
    const struct stack_bedding on = stack_bedding_of(&w, &slab);
    near_to("bed of a slab", on.length, 1.5, 1e-12);
    check(on.beds == 2 && on.corners == 0 && !on.ground && !on.alone,
          "beds of a slab", on.beds, 2);
    near_to("nothing beside a slab", stack_step_up(&w, &slab), 0.25, 0);
    near_to("half a box below both", stack_step_up(&w, &low), 0.5, 1e-12);
    near_to("nothing above its middle", stack_step_up(&w, &post), 0.25, 0);
    check(masonry_is_off(post.v, post.n) && !masonry_is_off(slab.v, slab.n),
          "a post", 0, 1);
    stack_free(&w);
    stones_free(&stock);
}

/* A stone that is let down turned by 30 degrees lies flat on the ground. */
static void test_rest(void)
{
    struct stones stock;
    struct stack_wall w;
    struct stone s;
    if (two_boxes(&w, &stock))
        return;
    check(stack_rest(&w, 2, 3.4, stones_vec(sqrt(3) / 2, 0.5), HUGE_VAL, &s),
          "a stone comes to rest", 0, 1);
    near_to("flat on the ground", s.low.y, 0, 1e-6);
    near_to("its turn", fabs(s.turn.x * s.turn.y), 0, 1e-6);
    near_to("its height", s.high.y * (s.high.x - s.low.x), s.area, 1e-6);
    stack_free(&w);
    stones_free(&stock);
}

/* A stone whose centre is 0.1 inside of the edge of a box tips when the wall is
   tilted by 0.1 over the height of its centre. */
static void test_tilts(void)
{
    struct stones stock;
    struct stack_wall w;
    struct stack_candidate c;
    if (two_boxes(&w, &stock))
        return;
    c.place.stone = 2;
    c.place.at = stones_vec(2.4, 1 + stock.stone[2].high.y);
    c.place.turn = stones_vec(1, 0);
    c.place.top = HUGE_VAL;
    check(stack_tilts(&w, &c, 0.2), "it stands at 0.2", 0, 1);
    check(!stack_tilts(&w, &c, 0.3), "and tips at 0.3", 1, 0);
    check(w.plan.task.s.blocks == 3, "and is not in the plan",
          w.plan.task.s.blocks, 3);
    stack_free(&w);
    stones_free(&stock);
}

/* How far a box can be pushed. */
static void test_ways(void)
{
    struct stones stock;
    struct stack_wall w;
    struct stone t;
    if (two_boxes(&w, &stock))
        return;
    /* slid against a box it stops there */
    t = box(2.6, 0, 3.6, 1);
    near_to("way to a box", rest_way(&w.around, &t, stones_vec(-1, 0)), 0.1,
            1e-12);
    near_to("way down", rest_way(&w.around, &t, stones_vec(0, -1)), 0, 1e-12);
    /* it fits where it just fits, and not where it is wider */
    t = box(1, 2, 1.5, 3);
    near_to("into a gap as wide", rest_way(&w.around, &t, stones_vec(0, -1)), 2,
            1e-12);
    t = box(1 - 1e-6, 2, 1.5, 3);
    near_to("not into a narrower one",
            rest_way(&w.around, &t, stones_vec(0, -1)), 1, 1e-12);
    stack_free(&w);
    stones_free(&stock);
}

static void test_quality(void)
{
    near_to("half of it at 0.70", stack_worth(0.70), 0.5, 1e-12);
    near_to("at 0.80", stack_worth(0.80), 1 / (1 + exp(-3)), 1e-12);
    near_to("no wall below 0.60", stack_quality(1, 0.5999), 0, 0);
    near_to("quality", stack_quality(0.2, 0.70), 0.1, 1e-12);
}

/* Two boxes of four of a stock in a frame of 12: the stock fills a third of it,
   and half of that is laid. In a frame of 4 it could fill all. */
static void test_worth_of_filling(void)
{
    struct stones stock;
    struct stack_wall w;
    if (two_boxes(&w, &stock))
        return;
    near_to("by what the stock can fill", stack_worth_of_filling(&w),
            stack_worth(stack_enough - 1.0 / 6 - stack_more), 1e-12);
    w.options.height = 1;
    near_to("by the frame", stack_worth_of_filling(&w),
            stack_worth(0.5 - stack_more), 1e-12);
    stack_free(&w);
    stones_free(&stock);
}

/* The step test: a box stays in every run; one whose centre is beside what
   carries it moves in all. */
static void test_steps(void)
{
    const double left[2] = {0.2, 2.1};
    for (int k = 0; k < 2; k++) {
        struct stones stock;
        struct stack_wall w;
        int moves;
        if (two_boxes(&w, &stock))
            return;
        moves = stack_moves(&w, 2);
        check(moves == 0, "boxes on the ground stay", moves, 0);
        w.stone[w.laid++] = box(left[k], 1, left[k] + 1, 2);
        moves = stack_moves(&w, 3);
        check(moves == k * STACK_TESTS, "runs that move", moves,
              k * STACK_TESTS);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* The last look: of three boxes the last is taken off again where its centre is
   less than the errors away from the end of what carries it. */
static void test_finish(void)
{
    const double left[2] = {1.6, 1.9999};
    for (int k = 0; k < 2; k++) {
        struct stones stock;
        struct stack_wall w;
        if (two_boxes(&w, &stock))
            return;
        put(&w, left[k], 1, left[k] + 1, 2);
        check(stack_finish(&w) == 0, "memory for the last look", k, 0);
        check(w.laid == 3 - k, "boxes that stay", w.laid, 3 - k);
        check(w.plan.task.s.blocks == w.laid + 1 && w.m.margin > 0.1 * k,
              "what is left is measured", w.m.margin, k);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* A wedge sticks between the rims of a notch, a slab lies on them. */
static void test_sticks(void)
{
    const kern_vec notch[7] = {{0, 0},   {2, 0},   {2, 1}, {1.5, 1},
                               {1, 0.2}, {0.5, 1}, {0, 1}};
    const kern_vec wedge[3] = {{1, 0.6}, {2, 1.4}, {0, 1.4}};
    const kern_vec slab[4] = {{0.2, 1}, {1.8, 1}, {1.8, 1.4}, {0.2, 1.4}};
    struct stack_place place = {0, {0, 0}, {1, 0}, HUGE_VAL};
    struct stones stock;
    struct stack_wall w;
    kern_block b;
    if (two_boxes(&w, &stock))
        return;
    stack_cut(&w, 0);
    kern_block_init(&b, notch, 7, 1, NULL);
    place.at = b.centre;
    stone_of(&stock.stone[0], notch, 7);
    check(stack_lay(&w, &place) == 0, "a notch on the ground", 0, 0);
    kern_block_init(&b, wedge, 3, 1, NULL);
    check(stack_sticks(&w, &b), "a wedge in a notch", 0, 1);
    kern_block_init(&b, slab, 4, 1, NULL);
    check(!stack_sticks(&w, &b), "a slab on a notch", 1, 0);
    stack_free(&w);
    stones_free(&stock);
}

/* The limit multiplier of a box: it tips at width / height, or slides. */
static void test_limit(void)
{
    struct stones stock;
    struct stack_wall w;
    if (two_boxes(&w, &stock))
        return;
    near_to("boxes slide", stack_limit(&w.plan.task, w.plan.contact), 0.58,
            1e-5);
    put(&w, 1.75, 1, 2.25, 3);
    near_to("a post tips", stack_limit(&w.plan.task, w.plan.contact), 0.25,
            1e-5);
    stack_free(&w);
    stones_free(&stock);
}

/* ---- Walls --------------------------------------------------------------- */

/* Builds the wall again, stone by stone: at each step nothing overlaps, it
   stands, and it stays when it is let go. */
static void replay(struct stack_wall *w, const struct stack_wall *built)
{
    const double most = 0.05;
    const struct stack_run run = {240, 4, 0, 0, 0, 2};
    for (int i = 0; i < built->laid; i++) {
        kern_contact contact[4000];
        if (stack_lay(w, &built->place[i])) {
            check(0, "a wall stands at every step", i, built->laid);
            return;
        }
        check(kern_contacts(w->plan.block, w->plan.task.s.blocks,
                            &w->plan.task.options, contact, 4000, &w->work)
                  >= 0,
              "nothing overlaps", i, built->laid);
        check(stack_sway(w, NULL, &run, 1, most) <= most, "a wall stays", i,
              most);
    }
}

/* Thirty stones of 36, in a frame that is high enough. */
static void test_walls(int seeds)
{
    for (int level = 10; level <= 50; level += 20)
        for (int seed = 1; seed <= seeds; seed++)
            for (int p = 0; p < STACK_PLANNERS; p++) {
                struct stones stock;
                struct stack_wall w, again;
                struct stack_options o = stack_defaults();
                o.height = 12;
                o.most = 30;
                o.planner = (enum stack_planner)p;
                o.walls = 8;
                o.seed = (uint64_t)seed;
                stones_make(&stock, level, 36, 0, (uint64_t)(500 + seed));
                if (stack_open(&w, &stock, &o) || stack_open(&again, &stock, &o)
                    || stack_plan(&w)) {
                    check(0, "memory for a wall", level, seed);
                    return;
                }
                if (w.laid < 30)
                    printf("%d, seed %d, %s: %s\n", level, seed,
                           stack_planner_name[p], w.message);
                check(w.laid == 30, "30 stones are laid", w.laid, 30);
                replay(&again, &w);
                near_to("the same margin", again.m.margin, w.m.margin, 1e-6);
                stack_free(&again);
                stack_free(&w);
                stones_free(&stock);
            }
}

/* A stone on top of the left end of five courses: a column where joints run
   through, none where every other course is shifted. Five bricks a course. */
static void test_bond(void)
{
    for (int k = 0; k < 2; k++) {
        struct stones stock;
        struct stack_wall w;
        struct stone on_top = box(0, 5, 2, 6), middle = box(4, 5, 6, 6);
        int course[26];
        if (bricks(&w, &stock, k))
            return;
        check(stack_column_of(&w, &on_top, 21) == (k ? 0 : 4), "column",
              stack_column_of(&w, &on_top, 21), k ? 0 : 4);
        check(stack_column_of(&w, &middle, 23) == 0, "not at an end",
              stack_column_of(&w, &middle, 23), 0);
        masonry_courses(&w.plan.task.s, stock.size, course);
        for (int i = 0; i < w.plan.task.s.blocks; i++)
            check(course[i] == (i + 4) / 5, "course", course[i], (i + 4) / 5);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* Half of a stock is small, a quarter of the others: none of these lies in the
   foundation, which has stones, and some lie above. */
static void test_foundation(void)
{
    for (int seed = 1; seed <= 3; seed++) {
        struct stack_options o = stack_defaults();
        struct stones stock;
        struct stack_wall w;
        double mean = 0;
        int founded = 0, small = 0;
        o.walls = 4;
        o.width = 5;
        o.height = 3;
        o.seed = (uint64_t)seed;
        stones_make(&stock, 30, 30, 0, (uint64_t)(900 + seed));
        for (int i = 0; i < 30; i++) {
            struct stone *s = &stock.stone[i];
            kern_vec v[STONES_CORNERS];
            const int n = s->n;
            const double scale = i % 2 ? 1 : 0.5;
            for (int k = 0; k < n; k++)
                v[k] = stones_vec(scale * s->v[k].x, scale * s->v[k].y);
            stone_of(s, v, n);
            mean += s->area / 30;
        }
        stones_sum_up(&stock);
        if (stack_open(&w, &stock, &o) || stack_plan(&w))
            return;
        for (int i = 0; i < w.laid; i++) {
            const struct stone *s = &w.stone[i];
            small += s->area < mean / 3;
            if (s->low.y > 0.05)
                continue;
            founded++;
            check(s->area >= mean / 3, "a stone of the foundation", s->area,
                  mean / 3);
        }
        check(founded > 2 && small > 0, "stones of the foundation", founded, 3);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* A box hangs over a lower one by less than half: without a pin it rests on one;
   with a wedge that is thicker than the gap it rests on two. A wedge that is
   thinner does nothing. Neither is a stone of the masonry figures. */
static void test_pins(void)
{
    const double thick[2] = {0.3, 0.15};
    for (int k = 0; k < 2; k++) {
        const kern_vec wedge[3] = {{0, 0}, {0.6, 0}, {0.6, thick[k]}};
        struct stones stock;
        struct stack_wall w;
        struct masonry m;
        if (two_boxes(&w, &stock))
            return;
        stack_cut(&w, 1);
        put(&w, 1, 0, 2.5, 0.8);
        put(&w, 0.2, 1, 1.4, 2);
        stone_of(&stock.stone[3], wedge, 3);
        check(stack_keeps_back(&w, 3) && !stack_keeps_back(&w, 2), "a pin", k,
              k);
        stock.pins = 1;
        check(stack_left(&w) == 0, "stones that are left", stack_left(&w), 0);
        stack_pin(&w, 3);
        check(w.laid == 4 - k && w.pins == 1 - k, "a pin is laid", w.laid,
              4 - k);
        check(masonry_of(&w.plan.task.s, 1, &m) == 0, "masonry", k, 0);
        near_to("stones below", masonry_rest_on(&w.plan.task.s, 3, 1).stones,
                2 - k, 0);
        near_to("a pin is no bed", m.corners, k ? 0 : 0.5, 0);
        stack_cut(&w, 3);
        check(w.pins == 0, "pins", w.pins, 0);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* Chips: as many as asked for, all of them pins, and the stones are those of a
   stock without. */
static void test_chips(void)
{
    struct stones plain, all;
    stones_make(&plain, 30, 20, 0, 4);
    stones_make(&all, 30, 20, 30, 4);
    check(all.stones == 50 && all.pins == 30, "chips are pins", all.pins, 30);
    near_to("mean size without pins", all.size, plain.size, 1e-12);
    near_to("mean area without pins", all.area, plain.area, 1e-12);
    for (int i = 0; i < 20; i++)
        near_to("the same stone", all.stone[i].area, plain.stone[i].area, 0);
    for (int i = 20; i < 50; i++)
        check(stones_is_pin(&all, &all.stone[i]) && all.stone[i].area > 0.01,
              "a chip", all.stone[i].area, 0.2);
    stones_free(&plain);
    stones_free(&all);
}

/* Notches between the boxes and beside them; a large stone at a side. */
static void test_notches(void)
{
    struct stack_anchor a[400];
    struct stones stock;
    struct stack_wall w;
    struct stone end = box(3, 0, 4, 1.5), inner = box(2.6, 0, 3.6, 1.5);
    if (two_boxes(&w, &stock))
        return;
    check(stack_notches(&w, a) == 2, "notches", stack_notches(&w, a), 2);
    near_to("middle between two boxes", a[0].x, 1.25, 1e-12);
    near_to("middle up to the side", a[1].x, 3.25, 1e-12);
    near_to("half a stone more at the side", stack_end(&w, &end), 0.5, 1e-12);
    near_to("not at the side", stack_end(&w, &inner), 0, 0);
    stack_free(&w);
    stones_free(&stock);
}

/* The same input, the same wall. */
static void test_same(void)
{
    struct stack_options o = stack_defaults();
    struct stones stock;
    struct stack_wall w[2];
    o.walls = 3;
    stones_make(&stock, 40, 20, 0, 3);
    for (int k = 0; k < 2; k++)
        if (stack_open(&w[k], &stock, &o) || stack_plan(&w[k]))
            return;
    check(w[0].laid == w[1].laid, "the same wall", w[0].laid, w[1].laid);
    for (int i = 0; i < w[0].laid && i < w[1].laid; i++)
        check(stack_same(&w[0].place[i], &w[1].place[i], 1e-300)
                  || w[0].place[i].at.x - w[1].place[i].at.x == 0,
              "the same place", w[0].place[i].at.x, w[1].place[i].at.x);
    for (int k = 0; k < 2; k++)
        stack_free(&w[k]);
    stones_free(&stock);
}

/* Equal bricks: `best` lays level courses, and no joint runs through. */
static void test_bricks(void)
{
    const kern_vec v[4] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    for (int seed = 1; seed <= 3; seed++) {
        struct stack_options o = stack_defaults();
        struct stones stock;
        struct stack_wall w;
        struct masonry m;
        o.width = 8.5;
        o.height = 3;
        o.walls = 16;
        o.seed = (uint64_t)seed;
        stones_make(&stock, 0, 30, 0, 1);
        for (int i = 0; i < stock.stones; i++)
            stone_of(&stock.stone[i], v, 4);
        stock.size = sqrt(2);
        stock.area = 2;
        if (stack_open(&w, &stock, &o) || stack_plan(&w))
            return;
        masonry_of(&w.plan.task.s, stock.size, &m);
        check(w.laid == 12, "bricks that fill the frame", w.laid, 12);
        for (int i = 0; i < w.laid; i++)
            near_to("a brick lies in its course", w.stone[i].low.y,
                    floor(w.stone[i].low.y + 0.5), 1e-3);
        near_to("no brick off level", m.off_level, 0, 0);
        check(m.joint > 1.15, "joints are crossed", m.joint, 1.15);
        stack_free(&w);
        stones_free(&stock);
    }
}

/* The filters keep the best of each feature, whatever the thresholds. */
static void test_filters(void)
{
    struct stack_options o = stack_defaults();
    struct stones stock;
    struct stack_wall w;
    struct stack_list list = {NULL, 0, 0};
    int kept = 0;
    for (int k = 0; k < STACK_FILTERS; k++)
        o.threshold[k] = 0;
    stones_make(&stock, 30, 10, 0, 5);
    if (stack_open(&w, &stock, &o) || stack_propose(&w, &list, 1, NULL, 0))
        return;
    check(list.count > 20, "candidates on the ground", list.count, 20);
    for (int k = 0; k < STACK_FILTERS; k++)
        stack_sift(&w, &list, k);
    for (int i = 0; i < list.count; i++)
        kept += !list.one[i].out;
    check(kept >= 1 && kept < list.count, "what filters keep", kept, 1);
    free(list.one);
    stack_free(&w);
    stones_free(&stock);
}

/* A brick, 2 x 1, that is released over the ground. */
static struct stone released(const struct stack_wall *w, double angle)
{
    const struct rigid_pt turn = rigid_unit(angle);
    struct stone s = w->stock->stone[0];
    stone_turn(&s, s.centre, stones_vec(turn.x, turn.y));
    stone_move(&s, stones_vec(4, 0.01 - s.low.y));
    check(drop_release(w, &s) == 1, "a brick comes to rest", 0, 1);
    return s;
}

/* A brick falls to the side on which its centre is: at the angle of its
   diagonal, 26.6 degrees off the long face, it could do either. */
static void test_release(void)
{
    static const kern_vec brick[4] = {
        {-1, -0.5}, {1, -0.5}, {1, 0.5}, {-1, 0.5}};
    struct stack_options o = stack_defaults();
    struct stones stock;
    struct stack_wall w;
    stones_make(&stock, 0, 2, 0, 1);
    for (int i = 0; i < 2; i++)
        stone_of(&stock.stone[i], brick, 4);
    stock.size = sqrt(2);
    stock.area = 2;
    if (stack_open(&w, &stock, &o))
        return;
    near_to("lies", released(&w, 0.9).centre.y, 0.5, 2e-3);
    near_to("lies on its other face", released(&w, 0.9 + pi).centre.y, 0.5,
            2e-3);
    near_to("stands", released(&w, 1.3).centre.y, 1, 2e-3);
    stack_free(&w);
    stones_free(&stock);
}

/* A wall that settles: a stone over the edge of another takes nothing with it
   and is refused, one above its middle stays. */
static void test_settle(void)
{
    struct stones stock;
    struct stack_wall w;
    struct stack_place place[2];
    struct stack_candidate c;
    memset(&c, 0, sizeof c);
    if (two_boxes(&w, &stock))
        return;
    stack_cut(&w, 1);
    c.place.stone = 1;
    c.place.turn = stones_vec(1, 0);
    c.place.at = stones_vec(w.stone[0].centre.x,
                            w.stone[0].high.y - stock.stone[1].low.y);
    check(drop_settle(&w, 0.1, &c, place) == 1, "a stone on another", 0, 1);
    near_to("stays", place[1].at.x, c.place.at.x, 1e-3);
    near_to("height", place[1].at.y, c.place.at.y, 2e-3);
    c.place.at.x = w.stone[0].high.x + 0.1;
    check(drop_settle(&w, 0.1, &c, place) == 0, "a stone over an edge", 1, 0);
    stack_free(&w);
    stones_free(&stock);
}

/* Both planners that drop stones: nothing overlaps, the wall lies in its frame,
   stays when it is released, and is the same once more. */
static void test_dropped(void)
{
    const struct drop_options drop = {60, 8, 0.1};
    const struct stack_run run = {240, 4, 0, 0, 0, 2};
    for (int p = STACK_HEURISTIC; p <= STACK_COMBINED; p++) {
        struct stack_options o = stack_defaults();
        struct stones stock;
        struct stack_wall w, again;
        o.planner = (enum stack_planner)p;
        o.width = 5;
        stones_make(&stock, 30, 10, 0, 77);
        if (stack_open(&w, &stock, &o) || stack_open(&again, &stock, &o)
            || drop_build(&w, &drop) || drop_build(&again, &drop))
            return;
        check(w.laid >= 8, "stones that are laid", w.laid, 8);
        check(stack_sway(&w, NULL, &run, 1, 0.05) <= 0.05, "a wall stays", 0,
              0.05);
        check(again.laid == w.laid, "the same wall", again.laid, w.laid);
        for (int i = 0; i < w.laid; i++) {
            near_to("the same place", again.stone[i].centre.x,
                    w.stone[i].centre.x, 0);
            check(w.stone[i].low.x > -0.01 && w.stone[i].high.x < 5.01
                      && w.stone[i].low.y > -2e-3,
                  "a stone in the frame", w.stone[i].low.x, 0);
        }
        stack_free(&w);
        stack_free(&again);
        stones_free(&stock);
    }
}

/* A stone on its point has level 0 in the kern filter, whatever the wall's. */
static void test_level_of(void)
{
    struct stack_candidate c;
    memset(&c, 0, sizeof c);
    c.m.level = 7;
    c.bed.beds = 1;
    near_to("level with a bed", stack_level_of(&c), 7, 0);
    c.bed.beds = 0;
    near_to("level without one", stack_level_of(&c), 0, 0);
}

/* A stone of 32 equal short edges has a bed: without one it is never let down. */
static void test_round(void)
{
    enum { CORNERS = 32 };
    kern_vec v[CORNERS];
    struct stone s;
    for (int k = 0; k < CORNERS; k++)
        v[k] = stones_vec(cos(2 * pi * k / CORNERS), sin(2 * pi * k / CORNERS));
    check(stone_of(&s, v, CORNERS) == 0, "a round stone", 0, 0);
    check(s.beds > 0, "beds of a round stone", s.beds, 1);
}

static void test_bad_stocks(void)
{
    struct stones s;
    check(stones_load(&s, "no such file") != 0, "a file that is not there", 0,
          -1);
    check(strstr(s.message, "cannot be read") != NULL, "is said so", 0, 1);
    stones_free(&s);
}

int main(int argc, char **argv)
{
    test_generator();
    test_features();
    test_sky();
    test_masonry();
    test_counts();
    test_matches();
    test_courses();
    test_bond();
    test_rest();
    test_tilts();
    test_ways();
    test_quality();
    test_worth_of_filling();
    test_limit();
    test_steps();
    test_finish();
    test_sticks();
    test_foundation();
    test_pins();
    test_chips();
    test_notches();
    test_filters();
    test_bricks();
    test_release();
    test_settle();
    test_dropped();
    test_level_of();
    test_same();
    test_round();
    test_bad_stocks();
    test_walls(argc > 1 ? atoi(argv[1]) : 1);
    printf(failures ? "%d failures\n" : "all passed\n", failures);
    return failures ? 1 : 0;
}
