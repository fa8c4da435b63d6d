/* profile.h - the profile; what is near, measured, certain. */

#ifndef UNIT_PROFILE_H
#define UNIT_PROFILE_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "contact.h"
#include "turned.h"
#include "laws.h"

static int profile(const world *w, int side, kern_real *value,
                   kern_collapse *out)
{
    kern_work work = work_of(w);
    const int got = kern_profile(world_task(w, &work), side, value, out);
    if (work.error > proof_error)
        proof_error = work.error;
    return got;
}

/* A slab 4 x 1 and on it a slim stone 1 x 3, each with its centre of mass
   moved to the right by a quarter of its width: its weight passes that far from
   the end of its bed. */
static void two_storeys(world *w)
{
    world_reset(w);
    world_box(w, 0, -9, -1, 9, 0);
    world_box(w, 1, 0, 0, 4, 1);
    world_box(w, 1, 1, 1, 2, 4);
    w->block[1].centre.x = R(3);
    w->block[2].centre.x = R(1.75);
    world_touch(w);
}

/* The upper stone has 1/4 to lose, or 1/4 of load at a height of 3/2: to the
   right a sixth, to the left a half, but it slides at mu. By itself the slab
   has 1 to lose, and slides before it topples. */
static void profile_two_storeys(void)
{
    static world w;
    kern_real value[3];
    kern_collapse c;
    two_storeys(&w);
    CHECK_INT(profile(&w, 0, value, &c), KERN_OK);
    CHECK_NEAR(value[0], huge_value(), 0);
    CHECK_NEAR(value[1], 1, EDGE);
    CHECK_NEAR(value[2], 0.25, EDGE);
    CHECK_NEAR(c.least, 0.25, EDGE);
    CHECK_NEAR(c.mean, 0.625, EDGE);
    CHECK_NEAR(c.weak, 0.25, EDGE);
    CHECK_NEAR(c.drop, 0, 0);
    CHECK_INT(profile(&w, 1, value, &c), KERN_OK);
    CHECK_NEAR(value[1], 0.4, EDGE);
    CHECK_NEAR(value[2], 1. / 6, EDGE);
    /* sizes 2 and sqrt 3; the lowest block begins half its size below its
       centre, at -1/2: heights 1 and 3, in mean sizes */
    CHECK_NEAR(c.drop, (exp(-0.4 / 0.07) + 3 * exp(-1 / 0.42)) / (2 + sqrt(3.)),
               1e-4);
    CHECK_INT(profile(&w, -1, value, &c), KERN_OK);
    CHECK_NEAR(value[1], 0.4, EDGE);
    CHECK_NEAR(value[2], 0.4, EDGE);
    w.options.relative = 1;
    CHECK_INT(profile(&w, 0, value, &c), KERN_OK);
    CHECK_NEAR(value[1], 0.5, EDGE);
    CHECK_NEAR(value[2], 0.5, EDGE);
}

/* Five stones side by side, each with a margin of its own; the third does not
   stand as it is, and the last never falls. */
static void profile_side_by_side(void)
{
    static const double moved[] = {0.3, 0.1, 0.6, 0.2};
    static world w;
    kern_real value[6];
    kern_collapse c;
    int i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 99, 0);
    for (i = 0; i < 4; i++) {
        world_box(&w, 1, 10 * i, 0, 10 * i + 1, 1);
        w.block[i + 1].centre.x += R(moved[i]);
    }
    world_box(&w, 1, 50, 0, 50.5, 0.5);
    world_touch(&w);
    for (i = 0; i < w.contacts; i++)
        if (w.contact[i].b == 5 || w.contact[i].a == 5)
            w.contact[i].travel /= 2; /* a kern that does not close entirely */
    CHECK_INT(profile(&w, 0, value, &c), KERN_OK);
    for (i = 0; i < 4; i++)
        CHECK_NEAR(value[i + 1], fmax(0, 0.5 - moved[i]), EDGE);
    CHECK_NEAR(value[5], 0.5, EDGE);
    CHECK_NEAR(c.least, 0, 0);
    CHECK_NEAR(c.mean, (0.2 + 0.4 + 0.3 + 0.5) / 5, EDGE);
    CHECK_NEAR(c.weak, (0.2 + 0.3) / 3, EDGE);
}

/* A stone over nothing but its neighbour's counterweight: when the weight has
   fallen, so does the stone, at the same place. */
static void profile_takes_along(void)
{
    static world w;
    kern_real value[3];
    kern_collapse c;
    world_reset(&w);
    world_box(&w, 0, 0, -1, 2, 0);
    world_box(&w, 1, 0, 0, 6, 1);
    world_box(&w, 9, 0, 1, 1, 4);
    w.block[2].centre.x = R(0.8);
    world_touch(&w);
    CHECK_INT(profile(&w, 0, value, &c), KERN_OK);
    CHECK_NEAR(value[2], 0.2, EDGE);
    CHECK_NEAR(value[1], value[2], EDGE);
}

/* Walls: the least value is the measure's, and turning left into right turns
   the loads. */
static void profile_laws(void)
{
    static world w, mirror;
    static int order[MAX_BLOCKS];
    int seed, i, stand = 0;
    for (seed = 0; seed < 300; seed++) {
        kern_real value[MAX_BLOCKS], other[MAX_BLOCKS];
        kern_collapse c, d;
        kern_margin m;
        double factor, unit;
        int got, left;
        change turn = no_change();
        random_world(&w, 500000u + (unsigned long long)seed, 20);
        unit = w.options.relative ? 1 : mean_size(&w);
        got = profile(&w, 0, value, &c);
        CHECK(got == KERN_OK || got == KERN_UNDECIDED);
        if (got != KERN_OK) {
            undecided++;
            continue;
        }
        CHECK(c.least <= c.weak * (1 + 8 * R(EPS)));
        CHECK(c.weak <= c.mean * (1 + 8 * R(EPS)));
        if (measure(&w, &m) == KERN_FALLS)
            CHECK_NEAR(c.least, 0, 0);
        if (measure(&w, &m) != KERN_STANDS)
            continue;
        CHECK_NEAR(c.least, m.margin, 20 * law_tolerance(&w) * unit);
        got = profile(&w, 1, value, &c);
        if (load_factor(&w, NULL, 1, &factor) != KERN_STANDS || got != KERN_OK)
            continue;
        CHECK_NEAR(c.least, fmin(factor, 10), SINGLE ? 5e-2 : 1e-5);
        turn.mirror = 1;
        world_changed(&mirror, &w, &turn, order);
        left = profile(&mirror, -1, other, &d);
        if (left != KERN_OK)
            continue;
        CHECK_NEAR(d.least, c.least, SINGLE ? 5e-2 : 1e-5);
        for (i = 0; i < w.blocks; i++)
            if (!w.block[i].fixed)
                CHECK(value[i] >= 0 && value[i] <= 10);
        stand++;
    }
    context[0] = 0;
    CHECK(stand > 30);
}

/* Two structures side by side fall each by itself: the mean is theirs, weighted
   by their blocks. Where two mechanisms are critical at one place either may be
   taken, and what it leaves may differ: seldom. */
static void profile_of_two(void)
{
    static world a, b, both;
    int seed, same = 0, all = 0;
    for (seed = 0; seed < 200; seed++) {
        kern_real value[MAX_BLOCKS];
        kern_collapse c[3];
        double n[2] = {0, 0}, want;
        int i;
        random_world(&a, 520000u + (unsigned long long)(2 * seed), 15);
        random_world(&b, 520001u + (unsigned long long)(2 * seed), 15);
        b.gravity = a.gravity;
        b.options = a.options;
        world_joined(&both, &a, &b, SINGLE ? 10 : 100);
        if (profile(&a, 1, value, &c[0]) || profile(&b, 1, value, &c[1])
            || profile(&both, 1, value, &c[2]))
            continue;
        for (i = 0; i < a.blocks; i++)
            n[0] += !a.block[i].fixed;
        for (i = 0; i < b.blocks; i++)
            n[1] += !b.block[i].fixed;
        want = (n[0] * (double)c[0].mean + n[1] * (double)c[1].mean)
             / (n[0] + n[1]);
        same += fabs((double)c[2].mean - want) < (SINGLE ? 5e-2 : 1e-4);
        all++;
    }
    context[0] = 0;
    CHECK(all > 100);
    CHECK(same > 0.9 * all);
}

static void profile_bad_input(void)
{
    static world w;
    kern_real value[3];
    kern_collapse c;
    kern_work work;
    two_storeys(&w);
    work = work_of(&w);
    c.mean = R(7);
    CHECK_INT(kern_profile(world_task(&w, &work), KERN_SHRINK, NULL, &c),
              KERN_BAD_POINTER);
    CHECK_INT(kern_profile(world_task(&w, &work), KERN_SHRINK, value, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_profile(world_task(&w, &work), 2, value, &c),
              KERN_BAD_OPTION);
    w.gravity = vec(0, 0);
    w.block[1].load.fy = R(-9.81);
    CHECK_INT(kern_profile(world_task(&w, &work), KERN_RIGHT, value, &c),
              KERN_BAD_OPTION);
    CHECK_NEAR(c.mean, 7, 0);
}

/* A stone that rests on a corner, its lower edge an angle of 0.05 off its bed:
   near enough, and the edge counts. */
static void near_contacts(void)
{
    static const double stone[] = {0, 0, 0.3, -0.015, 1, 0.02, 1, 1, 0, 1};
    static world w;
    kern_options o;
    kern_real tight;
    world_reset(&w);
    world_box(&w, 0, -9, -2, 9, -0.015);
    world_polygon(&w, 1, stone, 5);
    CHECK_INT(world_touch(&w), 1);
    tight = w.options.gap;
    o = kern_near(&w.options, R(2));
    CHECK_NEAR(o.gap, R(0.08), GEO);
    CHECK_NEAR(o.angle, R(0.15), GEO);
    CHECK_NEAR(w.options.gap, tight, 0);
    o.gap = R(1);
    o.angle = R(0.2);
    o = kern_near(&o, R(2));
    CHECK_NEAR(o.gap, 1, 0);
    CHECK_NEAR(o.angle, R(0.2), 0);
    w.options = kern_near(&w.options, R(1));
    CHECK_INT(world_touch(&w), 2);
    CHECK(fabs((double)(w.contact[1].p.x - w.contact[0].p.x)) > 0.6);
}

/* A stone above its bed: a gap of 4 errors, and 5 errors of angle times the
   distance of its corners from both centres, is a contact. */
static void measured_gaps(void)
{
    static world w;
    const double angle = 0.01, e = 0.01;
    const double place = 5.25 * e + 1e-3;
    const double gap = sqrt(place * place + 3.4 * 3.4 * angle * angle);
    int open_, k;
    for (open_ = 0; open_ < 2; open_++) {
        const double h = open_ ? 1.2 * gap : 0.9 * gap;
        world_reset(&w);
        world_box(&w, 0, 0, -1, 1, 0);
        world_box(&w, 1, 0, h, 1, 1 + h);
        w.options = kern_measured_options(&w.options, R(e), R(angle));
        CHECK_INT(world_touch(&w), open_ ? 0 : 2);
        CHECK_INT(verdict(&w, 0), open_ ? KERN_FALLS : KERN_STANDS);
        if (!open_) /* midway */
            CHECK_NEAR(w.contact[0].p.y, h / 2, 1e-6);
    }
    for (k = 0; k < 4; k++) { /* the gap of exact contacts is added */
        const double size = 1 + k / 2, h = 5.25e-4 + 1e-3 * size;
        const double low = (k % 2 ? 1.02 : 0.98) * h;
        world_reset(&w);
        world_box(&w, 0, 0, -1, 2, 0);
        world_box(&w, 1, 0, low, size, size + low);
        w.options = kern_measured_options(&w.options, R(1e-4), R(0));
        CHECK_INT(world_touch(&w), k % 2 ? 0 : 2);
    }
    w.options = kern_measured_options(NULL, R(0), R(0.1));
    CHECK_INT(world_touch(&w), KERN_BAD_OPTION);
    w.options = kern_measured_options(NULL, R(0.1), R(-1));
    CHECK_INT(world_touch(&w), KERN_BAD_OPTION);
    w.options = kern_measured_options(NULL, R(0.1), R(NAN));
    CHECK_INT(world_touch(&w), KERN_BAD_NUMBER);
}

/* All overlaps at once, and what accepts them. */
static void overlaps_of_three(void)
{
    static world w;
    kern_overlap found[3];
    int index[6], k;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 0, -0.1, 1, 1);
    world_box(&w, 1, 0, 0.8, 1, 2);
    CHECK_INT(world_touch(&w), KERN_OVERLAP);
    found[1].a = -7;
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, found, 1, &work), 2);
    CHECK_INT(found[1].a, -7);
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, NULL, 0, &work), 2);
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, NULL, 1, &work),
              KERN_BAD_POINTER);
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, found, -1, &work),
              KERN_BAD_COUNT);
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, found, 3, &work), 2);
    for (k = 0; k < 2; k++) {
        const double depth = found[k].a == 0 ? 0.1 : 0.2;
        CHECK_INT(found[k].b, found[k].a + 1);
        CHECK((double)found[k].depth <= depth * (1 + GEO));
        CHECK((double)found[k].depth >= depth * 7 / 8);
        CHECK_NEAR(found[k].allowed, 1e-3 * sqrt(found[k].a == 0 ? 1.1 : 1.1),
                   1e-6);
    }
    w.options.overlap = R(0.25);
    CHECK_INT(kern_overlaps(w.block, 3, &w.options, found, 3, &work), 0);
    CHECK_INT(world_touch(&w), 4);
    CHECK_NEAR(w.contact[0].p.y, -0.05, GEO);
    CHECK_NEAR(w.contact[2].p.y, 0.9, GEO);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
}

/* kern_certain() of a world whose options are measured. */
static int certain_world(const world *w, kern_interval *in, int room)
{
    static kern_contact again[100];
    kern_work work = work_for(w->blocks, 100);
    kern_margin m;
    kern_task *task = world_task(w, &work);
    memset(&m, 0, sizeof m);
    CHECK(kern_measure(task, &m, NULL) > 0);
    return kern_certain(task, m.margin, in, again, room);
}

/* A stone on a slope of 30 degrees with friction 0.3, held by a kerb that is 10
   errors high: the search with twice the error keeps the kerb. Where its bed is
   deeper it slides down along the kerb, by more than half of the contact, which
   grows. */
static void certain_kerb(void)
{
    const double e = 0.005, high = 10 * e, c = cos(pi / 6), n = sin(pi / 6);
    static const double flat[2][12] = {
        {-3, -1.5, 3, -1.5, 3, 0, -0.5, 0, -0.5, 1, -3, 1},
        {-0.5, 0, 0.5, 0, 0.5, 0.5, -0.5, 0.5}};
    static world w;
    kern_interval in;
    int b, i;
    world_reset(&w);
    for (b = 0; b < 2; b++) {
        double xy[12];
        const int vertices = b ? 4 : 6;
        for (i = 0; i < vertices; i++) {
            const double x = flat[b][2 * i];
            const double y = !b && i > 3 ? high * flat[b][2 * i + 1]
                                         : flat[b][2 * i + 1];
            xy[2 * i] = c * x - n * y;
            xy[2 * i + 1] = n * x + c * y;
        }
        world_polygon(&w, b, xy, vertices);
    }
    w.options.mu = R(0.3);
    w.options = kern_measured_options(&w.options, R(e), R(e));
    CHECK(world_touch(&w) > 0);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(certain_world(&w, &in, 100), KERN_STANDS);
    CHECK(in.low > 0 && in.high > in.low);
}

/* A unit box on a bed that ends at x: what is nearer to critical than 3.5 errors
   of place is not certain. */
static void certain_verdicts(void)
{
    static const struct {
        double end;
        int verdict, certain;
    } row[] = {{1.5, KERN_STANDS, KERN_STANDS},
               {0.7, KERN_STANDS, KERN_STANDS},
               {0.53, KERN_STANDS, KERN_OK},
               {0.47, KERN_FALLS, KERN_OK},
               {0.3, KERN_FALLS, KERN_FALLS}};
    static world w;
    kern_interval in;
    kern_contact one;
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    int i;
    for (i = 0; i < 5; i++) {
        const double end = fmin(row[i].end, 1);
        world_reset(&w);
        world_box(&w, 0, -1, -1, row[i].end, 0);
        world_box(&w, 1, 0, 0, 1, 1);
        w.options = kern_measured_options(&w.options, R(0.01), R(0.01));
        CHECK(world_touch(&w) > 0);
        CHECK_INT(verdict(&w, 0), row[i].verdict);
        CHECK_INT(certain_world(&w, &in, 100), row[i].certain);
        /* half of the bed, or what is left of it beyond the middle */
        CHECK_NEAR(in.low, fmax(fmin(end / 2, end - 0.5) / 3.1, 0), 1e-3);
        CHECK((in.settles < 1) == (row[i].certain == KERN_STANDS));
        CHECK_NEAR(in.high, fmax(fmin(end / 2, end - 0.5) + 0.035, 0), 0.01);
        CHECK_INT(certain_world(&w, &in, 1), KERN_NO_SPACE);
        w.options.pose_error = 0;
        CHECK_INT(certain_world(&w, &in, 100), KERN_BAD_OPTION);
    }
    CHECK_INT(kern_certain(NULL, 0, &in, &one, 1), KERN_BAD_POINTER);
    CHECK_INT(kern_certain(world_task(&w, &work), 0, &in, &one, 1),
              KERN_BAD_POINTER);
}

/* Supports that may be short within the error: nothing below, and a plank, which
   fall without; a beam that the other column catches; and one bed, which no
   error of place takes away. The interval widens as the error grows. */
enum { SLOT, PLANK, BEAM, STACK, SUPPORTS };

/* A slot with nothing below, a beam on two columns, a plank over a gap, two
   blocks on each other. */
static void support_of(world *w, int kind)
{
    world_reset(w);
    if (kind == SLOT) {
        world_box(w, 0, -2, -1, 0, 2);
        world_box(w, 0, 1 + 1e-3, -1, 3, 2);
        world_box(w, 1, 5e-4, 0, 1 + 5e-4, 1);
    } else if (kind == PLANK) {
        world_box(w, 0, -2, -1, 0.3, 0);
        world_box(w, 0, 1.001, -1, 4, 0);
        world_box(w, 1, 0, 0, 1, 1);
    } else {
        world_box(w, 0, -2, -1, 6, 0);
        world_box(w, 1, 0, 0, 1, 1);
        if (kind == BEAM)
            world_box(w, 1, 3, 0, 4, 1);
        world_box(w, 1, 0, 1, kind == BEAM ? 4 : 1, 1.25);
    }
}

static void certain_supports(void)
{
    static world w;
    kern_interval in, last = {0, 0, 0};
    int kind, step;
    for (kind = 0; kind < SUPPORTS; kind++)
        for (step = 1; step <= 4; step++) {
            const double e = 0.002 * step;
            support_of(&w, kind);
            w.options = kern_measured_options(NULL, R(e), R(e));
            CHECK(world_touch(&w) > 0);
            CHECK_INT(verdict(&w, 0), KERN_STANDS);
            CHECK_INT(certain_world(&w, &in, 100),
                      kind >= BEAM ? KERN_STANDS : KERN_OK);
            CHECK(in.low >= 0 && in.high >= in.low);
            CHECK(kind < BEAM || in.low > 0);
            CHECK(step == 1 || (in.low <= last.low && in.high >= last.high));
            last = in;
        }
}

/* A box on a bed of slope 0.3, which slides for certain with the friction of the
   options. With a friction of their own its contacts hold it by proof: then it
   does not fall for certain, although contacts found anew have that of the
   options. */
static void certain_given(void)
{
    static world w;
    kern_interval in = {-1, -1, -1};
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    w.options = kern_measured_options(&w.options, R(0.01), R(0.01));
    w.options.mu = R(0.1);
    w.gravity = vec(0.3, -1);
    CHECK(world_touch(&w) == 2);
    CHECK_INT(certain_world(&w, &in, 100), KERN_FALLS);
    world_friction(&w, 0.9);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK(certain_world(&w, &in, 100) != KERN_FALLS);
    CHECK(in.high > in.low);
}

/* A limit bounds both questions together, and what is proven by then is handed
   out. */
static void certain_limit(void)
{
    static world w;
    static kern_contact again[400];
    kern_interval in, whole;
    kern_margin m;
    int limit, ended = 0, got, all, units = 0;
    random_seed(5);
    world_reset(&w);
    random_wall(&w, 12);
    w.options = kern_measured_options(NULL, R(1e-3), R(1e-3));
    CHECK(world_touch(&w) > 0);
    for (limit = 0; limit <= units + 1;
         limit += limit > 0 && limit + units / 20 < units ? units / 20 : 1) {
        kern_work work = work_for(w.blocks, 400);
        kern_task *task = world_task(&w, &work);
        CHECK_INT(kern_measure(task, &m, NULL), KERN_STANDS);
        task->options.limit = limit;
        got = kern_certain(task, m.margin, &in, again, 400);
        if (limit == 0) {
            whole = in;
            all = got;
            units = work.units;
            CHECK(got >= 0);
        } else if (got == KERN_LIMIT) {
            ended++;
            CHECK(limit < units);
            CHECK_INT(work.units, limit + 1);
            CHECK(in.low <= whole.low && in.high >= whole.high);
        } else {
            CHECK_INT(got, all);
            CHECK_INT(work.units, units);
            CHECK_NEAR(in.low, whole.low, 0);
            CHECK_NEAR(in.high, whole.high, 0);
        }
    }
    CHECK(ended > 20);
}

/* What kern_measured_options() allows, in errors: a gap of 5.25, an overlap of
   8 and 3.4 errors of angle times half the diagonals, a foot 3 beyond the edge. */
static void measured_bounds(void)
{
    static const double ground[] = {-1, -1, 0, -1, 0, 0, -1, 0};
    static const double beyond[2] = {2.8, 3.2};
    static world w;
    const double e = 0.01, angle = 0.003;
    int index[4], i, k;
    kern_work work = kern_work_of(NULL, 0, index, 4);
    double stone[6];
    kern_options o = kern_measured_options(NULL, R(e), R(0.2));
    CHECK_NEAR(o.gap, 5.25 * e, GEO);
    CHECK_NEAR(o.overlap, 8 * e, GEO);
    CHECK_NEAR(o.angle, 0.495, GEO);
    CHECK_NEAR(kern_measured_options(NULL, R(e), R(0.02)).angle, 0.14, GEO);
    for (i = 0; i < 4; i++) { /* beyond the ground's end, deep in it */
        stone[0] = i < 2 ? beyond[i] * e : -0.5;
        stone[1] = i < 2 ? 0 : i == 2 ? -0.07 : -0.09;
        stone[2] = stone[0] + 1;
        stone[4] = stone[0] - 1;
        stone[3] = stone[5] = stone[1] + 1;
        world_reset(&w);
        world_polygon(&w, 0, ground, 4);
        world_polygon(&w, 1, stone, 3);
        w.options = kern_measured_options(NULL, R(e), R(0));
        k = world_touch(&w);
        CHECK(i == 3 ? k == KERN_OVERLAP : k > 0);
        CHECK_INT(contact_at(&w, 0, 1, stone[0], stone[1] / 2, 0, 1, GEO),
                  i % 2 == 0); /* midway */
    }
    world_reset(&w);
    world_box(&w, 0, 0, 0, 3, 4);
    world_box(&w, 1, 0, 0, 3, 4);
    w.options = kern_measured_options(NULL, R(e), R(angle));
    CHECK_INT(
        kern_contacts(w.block, 2, &w.options, w.contact, MAX_POINTS, &work),
        KERN_OVERLAP);
    CHECK_NEAR(work.fault.allowed, 8 * e + 3.5 * angle * (2.5 + 2.5), GEO);
}

/* The corner of a stone, two errors beyond the end of ground that had a step
   before it was simplified: the ground rises as y = -0.002 x. The corner of the
   ground bears on the side of the stone, x + y = 0.02. Both contacts lie halfway
   between the corner and the edge. */
static void measured_corner_beyond_edge(void)
{
    static const double ground[] = {-2, -1, 0,  -1,    0,  0,
                                    -1, 0,  -1, 0.004, -2, 0.004};
    static const double stone[] = {0.02, 0, 1.02, 1, -0.98, 1};
    static world w;
    const double square = 1 + 0.002 * 0.002, length = sqrt(square);
    int first; /* of the two blocks: the ground or the stone */
    for (first = 0; first < 2; first++) {
        const double up = first ? -1 : 1;
        world_reset(&w);
        world_polygon(&w, first, first ? stone : ground, first ? 3 : 6);
        world_polygon(&w, !first, first ? ground : stone, first ? 6 : 3);
        world_simplify(&w, 0.01);
        w.options = kern_measured_options(&w.options, R(0.01), R(0));
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0.02 - 0.00000004 / square,
                         -0.00002 / square, up * 0.002 / length, up / length,
                         GEO));
        CHECK(contact_at(&w, 0, 1, 0.005, 0.005, up * sqrt(0.5), up * sqrt(0.5),
                         GEO));
    }
}

/* A unit box on a bed that ends at `end`, `gap` above it, gravity leaning: the
   verdict, and whether it is certain. */
static int certain_of(double end, double gap, double lean, double angle,
                      kern_status got)
{
    static world w;
    kern_interval in;
    world_reset(&w);
    world_box(&w, 0, -1, -1, end, 0);
    world_box(&w, 1, 0, gap, 1, 1 + gap);
    w.gravity = vec(lean, -1);
    w.options = kern_measured_options(&w.options, R(0.01), R(angle));
    CHECK(world_touch(&w) >= 0);
    CHECK_INT(verdict(&w, 0), got);
    return certain_world(&w, &in, 100);
}

/* The errors that a certain verdict bears: in one that stands kerns are shorter
   by 3.5 and slopes steeper by 3 errors of angle; in one that falls kerns are
   longer by 3.5, slopes less steep by 3, gaps twice as wide. */
static void certain_bounds(void)
{
    const double mu = 0.4, tilt = 0.03;
    const double steep = (mu - tilt) / (1 + mu * tilt);
    const double flat = (mu + tilt) / (1 - mu * tilt);
    const double wide = 2 * 5.25 * 0.01 + 1e-3;
    int i;
    for (i = 0; i < 2; i++) {
        const double by = i ? 1.1 : 0.9;
        CHECK_INT(certain_of(0.5 + 0.035 * by, 0, 0, 0, KERN_STANDS),
                  i ? KERN_STANDS : KERN_OK);
        CHECK_INT(
            certain_of(2, 0, steep * (i ? 1.03 : 0.97), 0.01, KERN_STANDS),
            i ? KERN_OK : KERN_STANDS);
        CHECK_INT(certain_of(0.5 - 0.035 * by, 0, 0, 0, KERN_FALLS),
                  i ? KERN_FALLS : KERN_OK);
        CHECK_INT(certain_of(2, 0, flat * (i ? 1.03 : 0.97), 0.01, KERN_FALLS),
                  i ? KERN_FALLS : KERN_OK);
        CHECK_INT(certain_of(2, wide * by, 0, 0, KERN_FALLS),
                  i ? KERN_FALLS : KERN_OK);
    }
}

/* A rounded stone on a flat bed has one margin, however many vertices it has,
   if the options know how exact they are. */
static void measured_round_stone(void)
{
    static const int vertices[] = {40, 200, 1000};
    static world w;
    static double xy[2000];
    double margin[3];
    int i, k;
    for (i = 0; i < 3; i++) {
        const int n = vertices[i];
        kern_margin m;
        for (k = 0; k < n; k++) {
            const double a = 2 * pi * (k + 0.5) / n;
            const double r = pow(pow(fabs(cos(a)), 4) + pow(fabs(sin(a)), 4),
                                 -1.0 / 4);
            xy[2 * k] = r * cos(a);
            xy[2 * k + 1] = r * sin(a);
        }
        world_reset(&w);
        world_box(&w, 0, -3, -3, 3, -1);
        world_polygon(&w, 1, xy, n);
        w.options = kern_measured_options(&w.options, R(0.02), R(0.01));
        CHECK(world_touch(&w) > 0);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        margin[i] = (double)m.margin;
    }
    CHECK_NEAR(margin[0], margin[2], 0.05 * margin[2]);
    CHECK_NEAR(margin[1], margin[2], 0.05 * margin[2]);
}

static void mean_size_of_blocks(void)
{
    static world w;
    world_reset(&w);
    CHECK_NEAR(kern_mean_size(w.block, 0), 0, 0);
    world_box(&w, 0, 0, 0, 100, 100);
    world_box(&w, 1, 0, 0, 1, 4);
    world_box(&w, 1, 0, 0, 4, 4);
    CHECK_NEAR(kern_mean_size(w.block, 3), 3, GEO);
}

static const test profile_tests[] = {
    TEST(profile_two_storeys),
    TEST(profile_side_by_side),
    TEST(profile_takes_along),
    TEST(profile_laws),
    TEST(profile_of_two),
    TEST(profile_bad_input),
    TEST(certain_kerb),
    TEST(near_contacts),
    TEST(measured_gaps),
    TEST(overlaps_of_three),
    TEST(certain_verdicts),
    TEST(measured_bounds),
    TEST(measured_corner_beyond_edge),
    TEST(certain_supports),
    TEST(certain_given),
    TEST(certain_limit),
    TEST(certain_bounds),
    TEST(measured_round_stone),
    TEST(mean_size_of_blocks),
};

#endif
