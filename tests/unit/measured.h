/* measured.h - laws of kern_stretches() and kern_certain(), gross errors. */

#ifndef UNIT_MEASURED_H
#define UNIT_MEASURED_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"

/* ---- stretches ---- */

/* Finds the stretches of the contacts in their place. */
static int world_stretch(world *w)
{
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    const int got = kern_stretches(w->block, w->blocks, &w->options, w->contact,
                                   MAX_POINTS, &work);
    w->contacts = got > 0 ? got : 0;
    return got;
}

static double bearing_of_stretches(world *w, int *status)
{
    const int points = world_stretch(w);
    kern_work work = work_of(w);
    kern_real length = R(-2);
    CHECK(points >= 0);
    *status = kern_bearing(world_task(w, &work), &length, NULL);
    return (double)length;
}

/* Cuts the fixed box in two at x. */
static void cut_box(world *w, int i, double x)
{
    const kern_box box = w->block[i].box;
    world_box(w, 0, x, (double)box.low.y, (double)box.high.x,
              (double)box.high.y);
    w->block[i].vertex = NULL;
    {
        static kern_vec corner[4];
        corner[0] = box.low;
        corner[1] = vec(x, (double)box.low.y);
        corner[2] = vec(x, (double)box.high.y);
        corner[3] = vec((double)box.low.x, (double)box.high.y);
        CHECK_INT(kern_ground_init(&w->block[i], corner, 4, NULL), KERN_OK);
    }
}

/* A block on a foot of 0.4 and one of `sliver`, between which it is hollow. */
static void stone_on_feet(world *w, double sliver)
{
    const double in = 1 - sliver;
    const double stone[] = {-1, 0, -0.6, 0, -0.6, 0.6, in, 0.6,
                            in, 0, 1,    0, 1,    1,   -1, 1};
    world_reset(w);
    world_box(w, 0, -3, -1, 3, 0);
    world_polygon(w, 1, stone, 8);
}

/* Both feet are needed: the bearing length is that of the shorter one, on one
   ground and on two. As one contact it would be that of the whole width. */
static void stretches_of_feet(void)
{
    static const double cut[] = {-0.8, 0.2, 0.9};
    static const double sliver[] = {0.3, 0.02, 2e-3};
    static world w;
    size_t i, k;
    int got;
    for (i = 0; i < sizeof sliver / sizeof *sliver; i++) {
        stone_on_feet(&w, sliver[i]);
        CHECK_INT(world_touch(&w), 2);
        CHECK_NEAR(bearing_of_stretches(&w, &got), sliver[i],
                   SINGLE ? 1e-6 : 1e-12);
        CHECK_INT(w.contacts, 4);
        for (k = 0; k < sizeof cut / sizeof *cut; k++) {
            stone_on_feet(&w, sliver[i]);
            cut_box(&w, 0, cut[k]);
            CHECK_NEAR(bearing_of_stretches(&w, &got), sliver[i],
                       SINGLE ? 1e-6 : 1e-12);
            CHECK_INT(got, KERN_STANDS);
        }
    }
}

/* Of random structures: where the ground is cut in two stretches and bearing
   length stay. */
static void stretches_of_cuts(void)
{
    static world w;
    int seed, under = 0;
    for (seed = 1; seed <= (quick ? 60 : 600); seed++) {
        double whole, cut, x;
        int got, same, points, k;
        random_seed((unsigned long long)seed);
        world_reset(&w);
        if (seed % 2)
            random_tower(&w, 1 + seed % 7);
        else
            random_wall(&w, 2 + seed % 9);
        x = uniform(-0.5, 1.5);
        whole = bearing_of_stretches(&w, &got);
        points = w.contacts;
        for (k = 0; k + 1 < points; k++)
            under += w.contact[k].a == 0
                  && ((double)w.contact[k].p.x - x)
                             * ((double)w.contact[k + 1].p.x - x)
                         < 0;
        cut_box(&w, 0, x);
        cut = bearing_of_stretches(&w, &same);
        CHECK_INT(same, got);
        CHECK_INT(w.contacts, points);
        if (got == KERN_STANDS)
            CHECK(cut > 1e30 ? whole > 1e30
                             : fabs(cut - whole) <= (SINGLE ? 1e-4 : 1e-12));
    }
    CHECK(under > (quick ? 20 : 200));
}

/* ---- gross errors ---- */

/* A stone of 60 is drawn 58 deep in a ground of any width: no error of a pixel
   explains that. One that is 3 deep touches it. */
static void overlap_beyond_error(void)
{
    static const double width[] = {200, 800, 5000};
    static world w;
    size_t i;
    for (i = 0; i < sizeof width / sizeof *width; i++) {
        kern_work work = kern_work_of(NULL, 0, NULL, 0);
        int deep;
        for (deep = 0; deep < 2; deep++) {
            const double y = deep ? -58 : -3;
            world_reset(&w);
            world_box(&w, 0, -width[i] / 2, -100, width[i] / 2, 0);
            world_box(&w, 1, -30, y, 30, y + 60);
            w.options = kern_measured_options(&w.options, 1, R(1.0 / 60));
            CHECK_INT(kern_contacts(w.block, 2, &w.options, w.contact,
                                    MAX_POINTS, &work),
                      deep ? KERN_OVERLAP : 2);
            CHECK_INT(work.fault.block, deep ? 0 : -1);
            CHECK_INT(work.fault.other, deep ? 1 : -1);
        }
    }
}

/* A block no thicker than the error has no deep inside: a post or a hook through
   a slab, and a stone drawn twice. No motion shorter than 50, 15 and 40 parts
   them. A slab that is sunk by 5 in another may touch it. */
static void overlap_of_thin_parts(void)
{
    static const double slab[] = {-60, 50, 60, 50, 60, 60, -60, 60};
    static const double post[] = {-5, 0, 5, 0, 5, 100, -5, 100};
    static const double hook[] = {-5, 35, 5, 35, 5, 75, 30, 75,
                                  30, 90, 5, 90, 5, 95, -5, 95};
    static const double twin[] = {-20, 0, 20, 0, 20, 40, -20, 40};
    static const double sunk[] = {-60, 55, 60, 55, 60, 65, -60, 65};
    static const struct {
        const double *a, *b;
        int vertices;
        double deep; /* 0: no error */
    } pair[] = {{slab, post, 4, 50},
                {slab, hook, 8, 15},
                {twin, twin, 4, 40},
                {slab, sunk, 4, 0}};
    static world w;
    size_t i;
    int order;
    for (i = 0; i < sizeof pair / sizeof *pair; i++)
        for (order = 0; order < 2; order++) {
            kern_work work = kern_work_of(NULL, 0, NULL, 0);
            int got;
            world_reset(&w);
            world_box(&w, 0, -100, -500, 100, -490);
            if (order)
                world_polygon(&w, 1, pair[i].a, 4);
            world_polygon(&w, 1, pair[i].b, pair[i].vertices);
            if (!order)
                world_polygon(&w, 1, pair[i].a, 4);
            w.options = kern_measured_options(&w.options, 1, R(0.01));
            got = kern_contacts(w.block, 3, &w.options, w.contact, MAX_POINTS,
                                &work);
            CHECK_INT(got, pair[i].deep > 0 ? KERN_OVERLAP : 2);
            CHECK_INT(work.fault.block, pair[i].deep > 0 ? 1 : -1);
            CHECK_INT(work.fault.other, pair[i].deep > 0 ? 2 : -1);
            CHECK(!(pair[i].deep > 0) || work.fault.value > work.fault.allowed);
            CHECK((double)work.fault.value <= 50 + 1e-4);
        }
}

/* A stone whose two feet, `wide` errors wide, rest on posts as wide. Their tops
   rise to the right by the tangent `slope`. */
static void stone_on_posts(world *w, double wide, double slope, int mirrored)
{
    const double e = 0.01, half = wide * e / 2, up = slope * half;
    double ground[24] = {-2, -2, 2, -2, 2, -1}, stone[24] = {-0.5, 0.15};
    int foot, i;
    for (foot = 0; foot < 2; foot++) {
        const double x = foot ? -0.35 : 0.35;
        const double post[] = {x + half, -1,  x + half, up,
                               x - half, -up, x - half, -1};
        const double under[] = {-x - half, 0.15, -x - half, -up,
                                -x + half, up,   -x + half, 0.15};
        memcpy(ground + 6 + 8 * foot, post, sizeof post);
        memcpy(stone + 2 + 8 * foot, under, sizeof under);
    }
    ground[22] = -2;
    ground[23] = -1;
    stone[18] = stone[20] = 0.5;
    stone[19] = 0.15;
    stone[21] = stone[23] = 0.9;
    stone[22] = -0.5;
    for (i = 0; i < 24 && mirrored; i += 2) {
        ground[i] *= -1;
        stone[i] *= -1;
    }
    world_reset(w);
    world_polygon(w, 0, ground, 12);
    world_polygon(w, 1, stone, 12);
    w->options.mu = R(0.4);
    w->options = kern_measured_options(&w->options, R(e), R(e / 0.9));
}

/* It slides where the tops are steeper than friction. The sides of feet and
   posts that look away from each other are no keys, though they overlap by the
   width, nor does a post bear on the stone beside the foot above it. */
static void feet_of_few_errors(void)
{
    static world w;
    int wide, side, i;
    for (wide = 8; wide <= 28; wide++)
        for (side = 0; side < 4; side++) {
            const double slope = 0.4 + (side < 2 ? 0.07 : -0.07);
            const double normal = 1 / sqrt(1 + slope * slope);
            stone_on_posts(&w, wide, slope, side % 2);
            CHECK_INT(world_touch(&w), 4);
            CHECK_INT(verdict(&w, 0), side < 2 ? KERN_FALLS : KERN_STANDS);
            for (i = 0; i < w.contacts; i++)
                CHECK_NEAR(w.contact[i].n.y, normal, SINGLE ? 1e-5 : 1e-12);
        }
}

/* ---- certainty ---- */

/* Moves every block of w by noise of standard deviation e, in angle e too. */
static void add_noise(world *w, double e)
{
    int i, k;
    for (i = 0; i < w->blocks; i++) {
        kern_block *b = &w->block[i];
        kern_vec *v = w->vertex + 4 * i;
        const double turn = e * uniform(-1.7, 1.7);
        const double dx = e * uniform(-1.7, 1.7), dy = e * uniform(-1.7, 1.7);
        for (k = 0; k < 4 && !b->fixed; k++) {
            const double x = (double)(v[k].x - b->centre.x);
            const double y = (double)(v[k].y - b->centre.y);
            v[k] = vec((double)b->centre.x + dx + x * cos(turn) - y * sin(turn),
                       (double)b->centre.y + dy + y * cos(turn)
                           + x * sin(turn));
        }
        if (!b->fixed)
            CHECK_INT(kern_block_init(b, v, 4, R(1), NULL), KERN_OK);
    }
}

/* kern_certain() at an error; the verdict and the margin in *got and *m. */
static int certain_within(world *w, double e, double turn, int *got,
                          kern_margin *m, kern_interval *in)
{
    static kern_contact again[4 * MAX_POINTS];
    kern_work work = work_for(w->blocks, 4 * MAX_POINTS);
    kern_task *task;
    kern_options given = kern_defaults();
    given.mu = w->options.mu;
    w->options = kern_measured_options(&given, R(e), R(turn));
    if (world_touch(w) < 0)
        return -1;
    task = world_task(w, &work);
    *got = kern_measure(task, m, NULL);
    if (*got < 0)
        return -1;
    return kern_certain(task, *got == KERN_STANDS ? m->margin : 0, in, again,
                        4 * MAX_POINTS);
}

static int certain_at(world *w, double e, int *got, kern_margin *m,
                      kern_interval *in)
{
    return certain_within(w, e, e, got, m, in);
}

/* A table whose second foot is short, a block over a step of the ground, and a
   stone on two lips of one ground, of which it misses the second. */
enum { TABLE, STEP, LIPS, NEARLY };

static void nearly_held(world *w, int kind, double gap)
{
    const double table[] = {-1,  0,   -0.6, 0,   -0.6, 0.6, 0.6, 0.6,
                            0.6, gap, 1,    gap, 1,    1,   -1,  1};
    const double step[] = {-1,  -1,   1.5, -1, 1.5, -gap,
                           0.1, -gap, 0.1, 0,  -1,  0};
    const double lips[] = {-2,      -1,   3,   -1,   3,   0, 1 + gap, 0,
                           1 + gap, -0.5, 0.3, -0.5, 0.3, 0, -2,      0};
    world_reset(w);
    w->options.mu = R(0.5);
    if (kind == TABLE) {
        world_box(w, 0, -3, -1, 3, 0);
        world_polygon(w, 1, table, 8);
    } else if (kind == STEP) {
        world_polygon(w, 0, step, 6);
        world_box(w, 1, -0.15, 0, 0.85, 1);
    } else {
        world_polygon(w, 0, lips, 8);
        world_box(w, 1, 0, 0, 1, 0.7);
    }
    w->options = kern_measured_options(&w->options, R(0.005), R(0.005));
}

/* What stands for certain comes to rest after less than it tells, whatever its
   faces are called: a foot of the same stone and a step of the same ground are
   doubted as other blocks are. */
static void certain_places(void)
{
    /* how far they turn and sink, in gaps */
    static const double moves[NEARLY] = {0.75, 1.4, 1e9};
    static world w;
    int kind, gap, certain = 0;
    for (kind = 0; kind < NEARLY; kind++)
        for (gap = 1; gap <= 20; gap++) {
            const double short_by = 0.5 * 0.005 * gap;
            kern_interval in;
            kern_margin m;
            kern_contact again[100];
            kern_work work = work_for(2, 100);
            kern_task *task;
            int sure;
            nearly_held(&w, kind, short_by);
            CHECK(world_touch(&w) >= 0);
            task = world_task(&w, &work);
            memset(&m, 0, sizeof m);
            CHECK(kern_measure(task, &m, NULL) > 0);
            sure = kern_certain(task, m.margin, &in, again, 100);
            CHECK(sure >= 0);
            if (sure != KERN_STANDS)
                continue;
            certain++;
            CHECK((double)in.settles > moves[kind] * short_by);
        }
    CHECK(certain >= 15);
}

/* Verdict, margin, interval and certainty of generated structures with noise do
   not contradict each other, at any error that is told: what stands by proof
   never falls for certain, low <= margin <= high, what falls for certain has
   the interval 0; and what does not fall for certain at an error does not at a
   larger one. */
static void certain_laws(void)
{
    static const double told[] = {1e-4, 1e-3, 3e-3, 1e-2, 2e-2};
    static world w;
    int seed, asked = 0, stands = 0, falls = 0;
    for (seed = 1; seed <= (quick || SINGLE ? 60 : 400); seed++) {
        int open = 0; /* not certain to fall at a smaller error */
        size_t i;
        random_seed((unsigned long long)seed);
        sprintf(context, "seed %d", seed);
        world_reset(&w);
        if (seed % 3)
            random_tower(&w, 1 + seed % 7);
        else
            random_wall(&w, 1 + seed % 9);
        add_noise(&w, uniform(0, 0.02));
        for (i = 0; i < sizeof told / sizeof *told; i++) {
            kern_margin m;
            kern_interval in;
            int got;
            const int sure = certain_at(&w, told[i], &got, &m, &in);
            if (sure < 0)
                continue;
            asked++;
            stands += sure == KERN_STANDS;
            falls += sure == KERN_FALLS;
            CHECK(sure == KERN_OK || sure == got);
            CHECK(!(in.low < 0) && in.low <= in.high);
            if (got == KERN_STANDS)
                CHECK(in.low <= m.margin && m.margin <= in.high);
            else
                CHECK(!(in.low > 0));
            CHECK(sure != KERN_STANDS || in.low > 0);
            CHECK((sure == KERN_FALLS) == !(in.high > 0));
            CHECK(!open || sure != KERN_FALLS);
            open |= sure != KERN_FALLS;
        }
    }
    context[0] = 0;
    CHECK(asked > (quick || SINGLE ? 100 : 1000));
    CHECK(stands > asked / 20 && falls > asked / 20);
}

/* Makes `to` of the blocks of `from`, which have four corners: from the last to
   the first, mirrored where side is -1, fixed ones cut in two at x = cut. */
static void reordered(const world *from, world *to, double side, double cut)
{
    int i, k;
    world_reset(to);
    for (i = from->blocks - 1; i >= 0; i--) {
        const kern_block *b = &from->block[i];
        int part, parts = b->fixed && cut > (double)b->box.low.x
                               && cut < (double)b->box.high.x
                            ? 2
                            : 1;
        for (part = 0; part < parts; part++) {
            kern_vec *v = to->vertex + 4 * to->blocks;
            kern_block *out = &to->block[to->blocks++];
            for (k = 0; k < 4; k++) {
                const double x = (double)b->vertex[k].x;
                const double within = parts == 1 ? x
                                    : part       ? fmax(x, cut)
                                                 : fmin(x, cut);
                v[side < 0 ? 3 - k : k] = vec(side * within,
                                              (double)b->vertex[k].y);
            }
            CHECK_INT(b->fixed ? kern_ground_init(out, v, 4, NULL)
                               : kern_block_init(out, v, 4, R(1), NULL),
                      KERN_OK);
        }
    }
}

/* Makes a random tower or wall with noise. */
static void noisy_world(world *w, int seed, double e)
{
    random_seed((unsigned long long)seed);
    world_reset(w);
    if (seed % 3)
        random_tower(w, 1 + seed % 7);
    else
        random_wall(w, 1 + seed % 9);
    add_noise(w, e);
}

/* What stands may not lean on what is pulled away, nor fall against a proof: a
   pillar that tips onto a foot three errors below it pulls a lintel off a ledge
   of eight errors; and a stone in a groove, whose kerns are not nested. */
static void certain_ways(void)
{
    static const double ground[] = {-1, -1,    2,  -1,    2,  -.2, .4, -.2,
                                    .4, -.012, .3, -.012, .3, -.2, .1, -.2,
                                    .1, 0,     0,  0,     0,  -.2, -1, -.2};
    static const double pillar[] = {0, 0, .5, 0, .5, 1.6, 0, 1.6};
    static const double lintel[] = {-1.5, 1.6, 1, 1.6, 1, 1.8, -1.5, 1.8};
    static const double groove[] = {-3,     -1, 3, -1, 3,
                                    .30397, 0,  0, -3, 7.07837};
    static const double stone[] = {
        .41240, 1.85546, -.11444, 1.36252, -.29485, .69568,  .21455,  .09911,
        .86562, .08771,  1.37467, .45603,  1.60687, 1.19082, 1.06446, 1.73549};
    static world w;
    kern_margin m;
    kern_interval in;
    int got, ledge;
    for (ledge = 0; ledge < 2; ledge++) {
        const double end = ledge ? -1.468 : -0.9; /* 8 errors, or 150 */
        const double rest[] = {-2.5, -1, end, -1, end, 1.6, -2.5, 1.6};
        world_reset(&w);
        world_polygon(&w, 0, ground, 12);
        world_polygon(&w, 0, rest, 4);
        world_polygon(&w, 1, pillar, 4);
        world_polygon(&w, 1, lintel, 4);
        CHECK_INT(certain_at(&w, 0.004, &got, &m, &in),
                  ledge ? KERN_OK : KERN_STANDS);
        CHECK_INT(got, KERN_STANDS);
    }
    world_reset(&w);
    world_polygon(&w, 0, groove, 5);
    world_polygon(&w, 1, stone, 8);
    w.options.mu = R(0.1);
    CHECK(certain_within(&w, 0.0047, 0, &got, &m, &in) != KERN_FALLS);
    CHECK(!(in.high < m.margin));
}

/* A pillar of width 0.5, its centre `beyond` the first of two feet, 0.1 wide and
   0.2 apart. Where the second is 3 errors lower than it was measured it turns by
   15 of them, however slowly, and its centre moves by half its height times
   that: as far as it tells, where it stands for certain. */
static void certain_slender(void)
{
    static const double high[] = {1, 2, 4, 8, 20};
    static const double error[] = {5e-4, 1e-3, 2e-3, 4e-3};
    static const double ground[] = {-2, -1, 2,  -1, 2,  -.2, .4, -.2,
                                    .4, 0,  .3, 0,  .3, -.2, .1, -.2,
                                    .1, 0,  0,  0,  0,  -.2, -2, -.2};
    static world w;
    kern_margin m;
    kern_interval in;
    size_t i, k;
    int beyond, got, certain = 0;
    for (i = 0; i < sizeof high / sizeof *high; i++)
        for (k = 0; k < sizeof error / sizeof *error; k++)
            for (beyond = 1; beyond < 10; beyond++) {
                const double x = 0.1 + 0.01 * beyond;
                const double turn = 3 * error[k] / 0.2;
                world_reset(&w);
                world_polygon(&w, 0, ground, 12);
                world_box(&w, 1, x - 0.25, 0, x + 0.25, high[i]);
                if (certain_within(&w, error[k], error[k] / sqrt(high[i] / 2),
                                   &got, &m, &in)
                    != KERN_STANDS)
                    continue;
                certain++;
                CHECK((double)in.settles > turn * high[i] / 2);
            }
    CHECK(certain >= 40);
}

/* A block on five teeth, of which three are in the air: the ground behind the
   second is lower by so many errors. It turns about the end of that tooth until
   the last one bears. What is told is at least how far its centre moves. */
static void certain_combs(void)
{
    static const double comb[] = {
        0,   0,  .1,  0,  .1,  .1, .25,  .1, .25,  0,  .33, 0, .33, .1,
        .5,  .1, .5,  0,  .6,  0,  .6,   .1, .75,  .1, .75, 0, .85, 0,
        .85, .1, .95, .1, .95, 0,  1.05, 0,  1.05, .8, 0,   .8};
    static world w;
    kern_margin m;
    kern_interval in;
    int errors, got, certain = 0;
    for (errors = 1; errors < 8; errors++) {
        const double low = 0.005 * errors, turn = low / (1.05 - 0.33);
        const double ground[] = {-1,   -1,   2,   -1, 2,  -low,
                                 0.35, -low, .35, 0,  -1, 0};
        double x, y;
        world_reset(&w);
        world_polygon(&w, 0, ground, 6);
        world_polygon(&w, 1, comb, 20);
        if (certain_at(&w, 0.005, &got, &m, &in) != KERN_STANDS)
            continue;
        certain++;
        x = (double)w.block[1].centre.x - 0.33;
        y = (double)w.block[1].centre.y;
        CHECK((double)in.settles > turn * sqrt(x * x + y * y));
    }
    CHECK(certain >= 4);
}

static int stretches_in(const world *w)
{
    static kern_contact stretch[4 * MAX_POINTS];
    kern_work work = work_for(w->blocks, 4 * MAX_POINTS);
    return kern_stretches(w->block, w->blocks, &w->options, stretch,
                          4 * MAX_POINTS, &work);
}

/* Is nothing else changed by a cut of the ground: neither the margins a and b,
   nor the stretches, by contacts of the sides of the cut? */
static int only_cut(const world *w, const world *other, kern_real a,
                    kern_real b)
{
    return fabs((double)(a - b)) < (SINGLE ? 1e-4 : 1e-9)
        && stretches_in(other) == stretches_in(w);
}

/* Turns the page, and gravity with it. */
static void turn_page(world *w)
{
    const double c = cos(1.2), s = sin(1.2);
    int i, k;
    for (i = 0; i < w->blocks; i++) {
        kern_vec *v = w->vertex + 4 * i;
        for (k = 0; k < 4; k++)
            v[k] = vec(c * (double)v[k].x - s * (double)v[k].y,
                       s * (double)v[k].x + c * (double)v[k].y);
        CHECK_INT(w->block[i].fixed
                      ? kern_ground_init(w->block + i, v, 4, NULL)
                      : kern_block_init(w->block + i, v, 4, R(1), NULL),
                  KERN_OK);
    }
    w->gravity = vec(9.81 * s, -9.81 * c);
}

/* The force on a block passes at a distance c from the end of its bed, and its
   height above that end is h. If the end lacks g, the block falls and frees the
   energy g for a unit force, whichever point it turns about. To topple it must
   rise by c^2 / (2 h). So it may topple if g > c^2 / (2 h).

   POST is 0.5 wide and 4 high, and TOWER is such a post in two halves. BEHIND
   has a wall that the upper half leans on, which does not hold it on the other
   side. STEPPED
   is a post over a step of 2 errors, a bump of its stretch. BLOCK is 1 wide and
   0.9 high; its bed ends 0.07 to the right of its centre. HELD leans there on a
   wall. PUSHED is that block on feet at both ends, with 0.9 of its weight as a
   load to the right, and SLOPE has it on a slope of tangent 0.9: with the
   weight 1, c is 0.5 - 0.45 * 0.9, h is 0.45 + 0.5 * 0.9, and the height of the
   bed's other end makes the energy g again.

   An end that shows no gap is in doubt by 3.5 errors, and by 8.75 where the
   stretch has a bump. */
static void certain_rocks(void)
{
    enum { POST, TOWER, BEHIND, STEPPED, BLOCK, HELD, PUSHED, SLOPE, KINDS };
    static const double c[] = {0.25, 0.25, 0.25,  0.25,
                               0.07, 0.07, 0.095, 0.095};
    static const double h[] = {2, 2, 2, 2, 0.45, 0.45, 0.9, 0.9};
    /* where the first ground ends, and the second lies */
    static const double right[][3] = {{3},
                                      {3},
                                      {3},
                                      {3},
                                      {0.1, 0.45, 0.57},
                                      {0.1, 0.45, 0.57},
                                      {0.1, 0.9, 1},
                                      {0.1, 0.9, 1}};
    static world w;
    kern_margin m;
    kern_interval in;
    int i, got;
    for (i = 0; i < 2 * KINDS; i++) {
        const int kind = i / 2;
        const double g = c[kind] * c[kind] / (2 * h[kind]);
        const double e = g * (i % 2 ? 1.02 : 0.98)
                       / (kind == STEPPED ? 8.75 + 2 : 3.5);
        const double step[] = {-3,   -1,     3,    -1, 3,  -2 * e,
                               0.08, -2 * e, 0.08, 0,  -3, 0};
        double size;
        world_reset(&w);
        w.options.mu = R(2);
        if (kind == STEPPED)
            world_polygon(&w, 0, step, 6);
        else
            world_box(&w, 0, -3, -1, right[kind][0], 0);
        if (kind >= BLOCK) {
            world_box(&w, 0, right[kind][1], -1, right[kind][2], 0);
            world_box(&w, 1, 0, 0, 1, 0.9);
        } else
            world_box(&w, 1, -0.25, 0, 0.25,
                      kind == TOWER || kind == BEHIND ? 2 : 4);
        if (kind == TOWER || kind == BEHIND)
            world_box(&w, 1, -0.25, 2, 0.25, 4);
        if (kind == BEHIND)
            world_box(&w, 0, -1.25, 2.5, -0.25, 3.5);
        if (kind == HELD)
            world_box(&w, 0, 1, -1, 2, 2);
        if (kind == PUSHED)
            w.block[w.blocks - 1].load.fx = R(0.9 * 0.9 * 9.81);
        if (kind == SLOPE)
            w.gravity = vec(0.9 * 9.81, -9.81);
        size = (double)kern_mean_size(w.block, w.blocks);
        sprintf(context, "kind %d", kind);
        CHECK_INT(certain_within(&w, e, e / size, &got, &m, &in),
                  i % 2 && kind != HELD ? KERN_OK : KERN_STANDS);
        CHECK_INT(got, KERN_STANDS);
        CHECK(in.low > 0);
    }
    context[0] = 0;
}

/* A stone stands on its corner, with its centre `errors` to the left of it, and
   the wall is to its right: it falls to the left. The corner may lie to the left
   of the centre unless these errors are many. */
static void certain_points(void)
{
    static const double e = 0.005;
    static world w;
    kern_margin m;
    kern_interval in;
    double errors;
    int got;
    for (errors = 0.5; errors < 40; errors *= 4) {
        const double stone[] = {0, 0, 1, 1, 0, 2, -1 - 3 * errors * e, 1};
        world_reset(&w);
        world_box(&w, 0, -3, -1, 3, 0);
        world_box(&w, 0, 1, 0, 2, 3);
        world_polygon(&w, 1, stone, 4);
        CHECK_INT(certain_at(&w, e, &got, &m, &in),
                  errors < 3 ? KERN_OK : KERN_FALLS);
        CHECK_INT(got, KERN_FALLS);
    }
}

/* Checks that two answers are alike. In float returns 1 where they are not:
   rounding decides a few. */
static int certain_differs(int got, int sure, const kern_interval *same,
                           const kern_interval *in)
{
    if (SINGLE)
        return got != sure || fabs((double)(same->low - in->low)) > 1e-2;
    CHECK_INT(got, sure);
    CHECK_NEAR(same->low, in->low, 1e-6);
    if (sure == KERN_STANDS && got == sure)
        CHECK_NEAR(same->settles / in->settles, 1, 1e-6);
    return 0;
}

/* The answer does not depend on the order of the blocks, on the side from which
   they are seen, on a turn of the page, nor on a cut of the ground that leaves
   the margin as it is and whose sides are no new contacts: the lower end within
   1e-6, the way within a millionth of itself. In float rounding decides a few.
 */
static void certain_orders(void)
{
    enum { ORDER, MIRROR, CUT, TURN, TRIALS };
    static world w, other;
    int seed, asked = 0, stands = 0, differ = 0, cuts = 0;
    for (seed = 1; seed <= (quick || SINGLE ? 40 : 300); seed++) {
        kern_margin m, given;
        kern_interval in, same;
        int got, sure, trial;
        noisy_world(&w, seed, 0.004);
        sure = certain_at(&w, 0.004, &got, &given, &in);
        if (sure < 0)
            continue;
        for (trial = 0; trial < TRIALS; trial++) {
            reordered(&w, &other, trial == MIRROR ? -1 : 1,
                      trial == CUT ? 0.37 : 1e9);
            if (trial == TURN)
                turn_page(&other);
            sprintf(context, "seed %d trial %d", seed, trial);
            got = certain_at(&other, 0.004, &got, &m, &same);
            CHECK(got >= 0);
            if (trial == CUT
                && !(in.low > 0
                     && only_cut(&w, &other, m.margin, given.margin)))
                continue;
            cuts += trial == CUT && other.blocks > w.blocks;
            differ += certain_differs(got, sure, &same, &in);
            asked++;
        }
        stands += sure == KERN_STANDS;
    }
    context[0] = 0;
    CHECK(asked > (quick || SINGLE ? 80 : 700));
    CHECK(cuts > asked / 12);
    CHECK(stands > asked / 40);
    CHECK(differ <= asked / 50);
}

/* Running bond with closed joints: bricks 2 wide and 1 high, and halves at the
   ends of every second course. Every brick moves by a little, which is noise of
   the standard error e in both directions. */
static void noisy_bricks(world *w, int courses, int bricks, double e)
{
    int row, i;
    world_reset(w);
    world_box(w, 0, -2, -1, 2 * bricks + 2, 0);
    for (row = 0; row < courses; row++)
        for (i = 0; i < bricks + row % 2; i++) {
            const double x = e * uniform(-1.7, 1.7);
            const double y = row + e * uniform(-1.7, 1.7);
            const double left = 2 * i - row % 2, right = left + 2;
            world_box(w, 1, fmax(left, 0) + x, y, fmin(right, 2 * bricks) + x,
                      y + 1);
        }
}

/* What rests on beds alone is certain, however many stones it has and whether
   its joints are closed: the settling comes to rest. In float rounding decides
   some. */
static void certain_bricks(void)
{
    static const struct {
        int courses, bricks;
    } wall[] = {{2, 1}, {3, 2}, {5, 3}, {8, 4}, {10, 7}, {14, 7}};
    static world w;
    kern_margin m;
    kern_interval in;
    int i, k, got, sure = 0, asked = 0;
    random_seed(12);
    for (i = 0; i < (quick || SINGLE ? 4 : 6); i++)
        for (k = 0; k < 3; k++) {
            const double e = SINGLE ? 1e-3 : k ? 1e-3 : 1e-6;
            noisy_bricks(&w, wall[i].courses, wall[i].bricks, e);
            CHECK(certain_within(&w, e, e, &got, &m, &in) >= 0);
            CHECK(in.low <= m.margin && in.high >= m.margin);
            sure += in.settles < 0.4 && in.low > 0;
            asked++;
        }
    CHECK(sure >= (SINGLE ? asked / 2 : asked));
}

/* Lets the blocks of a task settle, by the simplex method or by the
   interior-point method. Returns the status. */
static int settle_by(kern_repose *r, const kern_task *task, int interior,
                     kern_real *way)
{
    kern_ipm ipm;
    const int got = kern_repose_begin(r, task);
    kern_part *p = &r->call.part;
    if (got != KERN_OK)
        return got;
    kern_repose_open(r, 1, 2, 2 * task->options.pose_error, 1);
    if (!interior)
        return kern_repose_settle(r, KERN_INFINITY, way);
    return kern_ipm_open(&ipm, &r->call.m, p, &r->call.path.q)
             ? (int)kern_repose_rounds(r, &ipm, KERN_INFINITY, way)
             : -1;
}

/* Both methods find the same rest, except for what they leave to the next round:
   gaps of walls agree within 1.5 errors. */
static void settling_methods(void)
{
    static world w;
    static kern_real gap[MAX_POINTS];
    const double e = 1e-3;
    int seed, i, rest = 0;
    for (seed = 1; seed <= (SINGLE ? 0 : 30); seed++) {
        kern_work work;
        kern_task *task;
        kern_repose r;
        kern_real way[2];
        int k, differ = 0;
        random_seed(seed);
        noisy_bricks(&w, 2 + seed % 5, 1 + seed % 4, e);
        w.options = kern_measured_options(&w.options, R(e), R(e));
        CHECK(world_touch(&w) > 0);
        work = work_for(w.blocks, MAX_POINTS);
        task = world_task(&w, &work);
        for (k = 0; k < 2; k++) {
            CHECK(settle_by(&r, task, k, &way[k]) >= 0);
            for (i = 0; i < task->s.contacts; i++) {
                differ += k && fabs((double)(gap[i] - r.gap[i])) > 1.5 * e;
                gap[i] = r.gap[i];
            }
        }
        CHECK_INT(way[0] < KERN_INFINITY, way[1] < KERN_INFINITY);
        if (!(way[0] < KERN_INFINITY))
            continue;
        rest++;
        CHECK_NEAR(way[0], way[1], e / 5);
        CHECK_INT(differ, 0);
    }
    CHECK(rest >= (SINGLE ? 0 : 28));
}

/* Boxes between two walls overlap each other, so that no motion parts them:
   they are measured as touching, and neither end means that they fall. */
static void settling_jam(void)
{
    static world w;
    kern_margin m;
    kern_interval in;
    const double e = 0.002;
    int n, i, got;
    for (n = 1; n <= 30; n += n < 4 ? 1 : 13) {
        world_reset(&w);
        world_box(&w, 0, -3, -1, n + 3, 0);
        world_box(&w, 0, -3, 0, 0, 2);
        world_box(&w, 0, n, 0, n + 3, 2);
        for (i = 0; i < n; i++)
            world_box(&w, 1, i - 0.75 * e, i % 3 * e / 2, i + 1 + 0.75 * e,
                      1 + i % 3 * e / 2);
        got = certain_within(&w, e, 0, &got, &m, &in);
        CHECK(got == KERN_OK || got == KERN_STANDS);
        CHECK(in.low > 0 && in.low <= m.margin && in.high >= m.margin);
    }
}

static const test measured_tests[] = {
    TEST(stretches_of_feet),    TEST(stretches_of_cuts),
    TEST(overlap_beyond_error), TEST(overlap_of_thin_parts),
    TEST(feet_of_few_errors),   TEST(certain_places),
    TEST(certain_laws),         TEST(certain_ways),
    TEST(certain_slender),      TEST(certain_combs),
    TEST(certain_rocks),        TEST(certain_points),
    TEST(certain_orders),       TEST(certain_bricks),
    TEST(settling_methods),     TEST(settling_jam),
};

#endif
