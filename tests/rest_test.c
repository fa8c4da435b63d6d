/* cc -O2 -ffp-contract=off -o rest_test tests/rest_test.c -lm && ./rest_test

   Where stones come to rest (kern_rest()), which place is best
   (kern_place_compare()) and copies of plans (kern_plan_copy()): poses derived
   by hand, laws on walls that the test builds, and every error.
   `rest_test walls N` builds N walls and prints what share of poses stand. */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { BLOCKS = 40, POINTS = 64 * BLOCKS, CORNERS = 64 };

/* Lengths that rounding changes, in sizes of a stone of 1. */
#define NEAR (sizeof(kern_real) == sizeof(double) ? 1e-6 : 2e-3)

static int failed;

#define CHECK(condition) check(condition, #condition, __LINE__)
#define CHECK_NEAR(a, b) check_near((double)(a), (double)(b), #a, __LINE__)

static void check(int good, const char *what, int line)
{
    if (good)
        return;
    printf("line %d: %s\n", line, what);
    failed++;
}

static void check_near(double a, double b, const char *what, int line)
{
    if (fabs(a - b) <= NEAR)
        return;
    printf("line %d: %s is %.9g, not %.9g\n", line, what, a, b);
    failed++;
}

/* ---- worlds ---- */

struct world {
    kern_vec corner[BLOCKS][CORNERS];
    kern_block block[BLOCKS];
    kern_contact contact[POINTS];
    kern_motion motion[BLOCKS];
    kern_force force[POINTS];
    kern_real real[KERN_REALS(BLOCKS, POINTS)];
    int index[KERN_INTS(BLOCKS, POINTS)];
    kern_work work;
    kern_plan plan;
    kern_vec rest[CORNERS]; /* the stone's vertices at rest */
    kern_pose pose;
};

static void open_world(struct world *w)
{
    w->work = kern_work_of(w->real, KERN_REALS(BLOCKS, POINTS), w->index,
                           KERN_INTS(BLOCKS, POINTS));
    w->plan = kern_plan_of(w->block, BLOCKS, w->contact, POINTS,
                           kern_known_of(w->motion, w->force), &w->work);
}

/* Adds a block: density 0 is ground. Returns contacts, or a status. */
static int add(struct world *w, const kern_vec *v, int n, kern_real density)
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

static void add_box(struct world *w, double left, double low, double right,
                    double high)
{
    kern_vec v[4];
    v[0].x = v[3].x = (kern_real)left;
    v[1].x = v[2].x = (kern_real)right;
    v[0].y = v[1].y = (kern_real)low;
    v[2].y = v[3].y = (kern_real)high;
    CHECK(add(w, v, 4, 0) >= 0);
}

static void add_triangle(struct world *w, double ax, double ay, double bx,
                         double by, double cx, double cy)
{
    const kern_vec v[3] = {{(kern_real)ax, (kern_real)ay},
                           {(kern_real)bx, (kern_real)by},
                           {(kern_real)cx, (kern_real)cy}};
    CHECK(add(w, v, 3, 0) >= 0);
}

static kern_block stone_of(const kern_vec *v, int n)
{
    kern_block b;
    CHECK(kern_block_init(&b, v, n, 1, NULL) == KERN_OK);
    return b;
}

static kern_status rest(struct world *w, const kern_block *stone, double x,
                        double turn)
{
    return kern_rest(&w->plan.task, stone, (kern_real)x, (kern_real)turn,
                     w->rest, &w->pose);
}

static const kern_vec unit_box[4] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
static struct world world;

/* Checks place and turn of the stone at rest. */
static void at(const struct world *w, double x, double y, double turn, int line)
{
    check_near((double)w->pose.block.centre.x, x, "x", line);
    check_near((double)w->pose.block.centre.y, y, "y", line);
    check_near((double)w->pose.turn.x, cos(turn), "cosine", line);
    check_near((double)w->pose.turn.y, sin(turn), "sine", line);
}
#define AT(x, y, turn) at(&world, x, y, turn, __LINE__)

static int stands(struct world *w)
{
    return kern_plan_bears(&w->plan, &w->pose.block, 0, NULL) == KERN_STANDS;
}

/* ---- poses by hand ---- */

static void flat_ground(void)
{
    const kern_block box = stone_of(unit_box, 4);
    const double half = 1.5707963267948966;
    open_world(&world);
    add_box(&world, -9, -1, 9, 0);
    CHECK(rest(&world, &box, 0.3, 0) == KERN_OK);
    AT(0.3, 0.5, 0);
    CHECK(world.pose.held == KERN_HELD && world.pose.motions == 1);
    CHECK(world.pose.on[0] == 0 && world.pose.on[1] == 0 && stands(&world));
    CHECK(world.rest[2].x > world.rest[0].x); /* vertices in their order */

    /* on its first corner it tips to the nearer side, about that corner */
    CHECK(rest(&world, &box, 0, 0.1) == KERN_OK);
    AT(0.5 - (cos(0.1) - sin(0.1)) / 2, 0.5, 0);
    CHECK(rest(&world, &box, 0, 0.9) == KERN_OK);
    AT((sin(0.9) - cos(0.9)) / 2 - 0.5, 0.5, half);
    /* a turn is an angle, whole turns and more */
    CHECK(rest(&world, &box, 0, 8 * half) == KERN_OK);
    AT(0, 0.5, 0);
    CHECK(rest(&world, &box, 0, -half) == KERN_OK);
    AT(0, 0.5, -half);
}

static void over_an_edge(void)
{
    const kern_vec slab[4] = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
    const kern_block b = stone_of(slab, 4);
    open_world(&world);
    add_box(&world, -4, -1, 0, 0);
    add_box(&world, -4, -2, 9, -1);
    CHECK(rest(&world, &b, -0.1, 0) == KERN_OK);
    AT(-0.1, 0.5, 0);
    /* centre beyond the edge: clockwise about it, until a corner 1.2 from it
       is 1 lower: sine 1 / 1.2 */
    CHECK(rest(&world, &b, 0.2, 0) == KERN_OK);
    CHECK(world.pose.motions > 1 && world.pose.block.centre.x > 0.2);
    world.plan.task.options.mu = 10; /* and stays there */
    CHECK(rest(&world, &b, 0.2, 0) == KERN_OK);
    CHECK_NEAR(world.pose.turn.y, -1 / 1.2);
    CHECK_NEAR(world.rest[1].y, -1);
    CHECK(world.pose.held == KERN_HELD && stands(&world));
}

static void triangles(void)
{
    const double high = sqrt(0.75);
    const kern_vec up[3] = {{0, 0}, {1, 0}, {(kern_real)0.5, (kern_real)high}};
    const kern_vec down[3] = {{0, 0},
                              {(kern_real)0.5, (kern_real)high},
                              {(kern_real)-0.5, (kern_real)high}};
    const kern_block a = stone_of(up, 3), b = stone_of(down, 3);
    const double third = 1.0471975511965976;
    open_world(&world);
    add_box(&world, -9, -1, 9, 0);
    CHECK(rest(&world, &a, 0, 0) == KERN_OK);
    AT(0, high / 3, 0);
    CHECK(rest(&world, &b, 0, 0.01) == KERN_OK);
    CHECK_NEAR(world.pose.turn.y, sin(third));
    CHECK(rest(&world, &b, 0, -0.01) == KERN_OK);
    CHECK_NEAR(world.pose.turn.y, -sin(third));
    CHECK_NEAR(world.pose.block.centre.y, high / 3);
    CHECK(rest(&world, &b, 0, 0) == KERN_OK); /* on its point, in balance */
    AT(0, 2 * high / 3, 0);
}

static void slopes(void)
{
    const kern_block box = stone_of(unit_box, 4);
    const double quarter = 0.7853981633974483, lean = atan(0.3);
    const double c = cos(lean), s = sin(lean);

    /* a groove of two slopes of 45 degrees: it slides to the bottom */
    open_world(&world);
    add_triangle(&world, -9, 9, -9, 0, 0, 0);
    add_triangle(&world, 9, 9, 0, 0, 9, 0);
    CHECK(rest(&world, &box, 0, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);
    CHECK(stands(&world));
    CHECK(rest(&world, &box, 1.2, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);
    CHECK(rest(&world, &box, -1.2, quarter) == KERN_OK);
    AT(0, sqrt(0.5), quarter);

    /* a slope of 0.3: friction of 0.4 holds it, 0.2 does not, and a wall at
       the foot does */
    open_world(&world);
    add_triangle(&world, 0, 0, 9, 0, 9, 2.7);
    add_box(&world, -1, 0, 0, 9);
    CHECK(rest(&world, &box, 4, lean) == KERN_OK);
    AT(4, 1.2 + 0.5 / c, lean);
    CHECK(world.pose.motions == 1 && stands(&world));
    world.plan.task.options.mu = (kern_real)0.2;
    CHECK(rest(&world, &box, 4, lean) == KERN_OK);
    AT((c + s) / 2, 0.15 * (c + s) + 0.5 / c, lean);
}

static void gaps_and_steps(void)
{
    const kern_vec half[4] = {
        {0, 0}, {(kern_real)0.5, 0}, {(kern_real)0.5, 1}, {0, 1}};
    const kern_block box = stone_of(unit_box, 4), thin = stone_of(half, 4);
    open_world(&world);
    add_box(&world, -5, 0, 0, 2);
    add_box(&world, 0.6, 0, 5, 2);
    add_box(&world, 0, 0, 0.6, 0.5);
    CHECK(rest(&world, &box, 0.3, 0) == KERN_OK); /* across */
    AT(0.3, 2.5, 0);
    CHECK(rest(&world, &thin, 0.3, 0) == KERN_OK); /* into it */
    AT(0.3, 1, 0);
    CHECK(rest(&world, &thin, 0.25, 0) == KERN_OK); /* along a side */
    AT(0.25, 1, 0);
    open_world(&world);
    add_box(&world, -5, 0, 0, 2);
    add_box(&world, 0.5, 0, 5, 2);
    add_box(&world, 0, 0, 0.5, 0.5);
    CHECK(rest(&world, &thin, 0.25, 0) == KERN_OK); /* where it just fits */
    AT(0.25, 1, 0);

    /* a step of 0.5: about its edge until a corner 0.6 from there meets the
       ground, and about that onto its side */
    open_world(&world);
    add_box(&world, -5, -1, 5, 0);
    add_box(&world, -5, 0, 0, 0.5);
    world.plan.task.options.mu = 10;
    CHECK(rest(&world, &box, 0.1, 0) == KERN_OK);
    AT(sqrt(0.36 - 0.25) + 0.5, 0.5, -1.5707963267948966);
    CHECK(stands(&world));
}

/* Concave, thin, tiny, round and clockwise stones. */
static void shapes(void)
{
    const kern_vec arch[8] = {{0, 0}, {1, 0}, {1, 2}, {2, 2},
                              {2, 0}, {3, 0}, {3, 3}, {0, 3}};
    kern_vec v[40];
    kern_block b = stone_of(arch, 8);
    int i;
    open_world(&world);
    add_box(&world, -9, -1, 9, 0);
    add_box(&world, -0.25, 0, 0.25, 2.5); /* a post */
    CHECK(rest(&world, &b, 0, 0) == KERN_OK);
    AT(0, 0.5 + (double)b.centre.y, 0);
    CHECK(world.pose.held == KERN_HELD && stands(&world));
    for (i = 0; i < 8; i++)
        v[i] = arch[7 - i];
    b = stone_of(v, 8);
    CHECK(b.area < 0 && rest(&world, &b, 0, 0) == KERN_OK);
    AT(0, 0.5 + (double)b.centre.y, 0);

    for (i = 0; i < 40; i++) {
        v[i].x = (kern_real)cos(6.283185307179586 * (i + 0.5) / 40);
        v[i].y = (kern_real)sin(6.283185307179586 * (i + 0.5) / 40);
    }
    b = stone_of(v, 40);
    CHECK(rest(&world, &b, 5, 0) == KERN_OK);
    AT(5, cos(3.141592653589793 / 40), 0);
    CHECK(rest(&world, &b, 5, 0.05) == KERN_OK);
    CHECK_NEAR(world.pose.block.centre.y, cos(3.141592653589793 / 40));

    for (i = 0; i < 4; i++) {
        v[i].x = unit_box[i].x;
        v[i].y = unit_box[i].y / 1000;
    }
    b = stone_of(v, 4);
    CHECK(rest(&world, &b, 3, 0.3) == KERN_OK);
    CHECK_NEAR(world.pose.block.centre.y, 0.0005);
    for (i = 0; i < 4; i++)
        v[i].x = unit_box[i].x / 1000;
    b = stone_of(v, 4);
    CHECK(rest(&world, &b, 3, 0.3) == KERN_OK);
    CHECK(fabs((double)world.pose.block.centre.y - 0.0005) < 1e-3 * NEAR
          || sizeof(kern_real) == sizeof(float));

    /* one of 40 corners rolls down a long slope, and past its end */
    for (i = 0; i < 40; i++) {
        v[i].x = (kern_real)cos(6.283185307179586 * i / 40);
        v[i].y = (kern_real)sin(6.283185307179586 * i / 40);
    }
    b = stone_of(v, 40);
    open_world(&world);
    add_triangle(&world, 0, 0, 40, 0, 40, 12);
    CHECK(rest(&world, &b, 38, 0) == KERN_NO_REST);
    CHECK(rest(&world, &b, 2, 0) == KERN_NO_SUPPORT);
}

/* ---- walls ---- */

static uint64_t state = 1;

static double uniform(double low, double high)
{
    state = state * 6364136223846793005u + 1442695040888963407u;
    return low + (high - low) * (double)(state >> 11) / 9007199254740992.0;
}

/* A stone of 3 to 12 vertices around a centre; every fifth is concave. */
static int random_stone(kern_vec *v)
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
static void build(struct world *w, int stones)
{
    int tries;
    open_world(w);
    w->plan.task.options.mu = (kern_real)uniform(0.3, 0.8);
    add_box(w, -1, -1, 6, 0);
    add_box(w, 6, -1, 7, 0.4);
    for (tries = 0; tries < 40 * stones && w->plan.task.s.blocks < stones + 2;
         tries++) {
        kern_vec v[CORNERS];
        kern_block b;
        const int n = random_stone(v);
        if (kern_block_init(&b, v, n, 1, NULL) == KERN_OK
            && rest(w, &b, uniform(0, 5), uniform(-3, 3)) == KERN_OK
            && w->pose.held == KERN_HELD && stands(w))
            CHECK(add(w, w->rest, n, 1) >= 0);
    }
}

/* The vertex p in a world that is mirrored, scaled, turned by a right angle and
   moved. */
struct frame {
    double mirror, scale, dx, dy;
    int turned;
};

static kern_vec framed(const struct frame *f, kern_vec p)
{
    const double x = f->mirror * f->scale * (double)p.x;
    const double y = f->scale * (double)p.y;
    kern_vec q;
    q.x = (kern_real)((f->turned ? -y : x) + f->dx);
    q.y = (kern_real)((f->turned ? x : y) + f->dy);
    return q;
}

static struct world other;

/* Compares where a stone rests on a wall and on the wall in a frame. */
static int law(struct world *w, const struct frame *f, const kern_vec *v, int n,
               double x, double turn)
{
    const kern_block stone = stone_of(v, n);
    const kern_vec along = {(kern_real)x, 0};
    kern_vec u[CORNERS], to;
    kern_block seen;
    kern_status a, b;
    int i, good;
    open_world(&other);
    other.plan.task.options = w->plan.task.options;
    if (f->turned) {
        other.plan.task.s.gravity.x = (kern_real)9.81;
        other.plan.task.s.gravity.y = 0;
    }
    for (i = 0; i < w->plan.task.s.blocks; i++) {
        const kern_block *from = &w->block[i];
        int k;
        for (k = 0; k < from->vertices; k++)
            u[k] = framed(f, from->vertex[k]);
        CHECK(add(&other, u, from->vertices, from->fixed ? 0 : 1) >= 0);
    }
    for (i = 0; i < n; i++)
        u[i] = framed(f, v[i]);
    seen = stone_of(u, n);
    to = framed(f, along);
    a = rest(w, &stone, x, turn);
    b = rest(&other, &seen, (double)(f->turned ? to.y : to.x),
             f->mirror * turn);
    good = a == b;
    for (i = 0; i < n && good && a == KERN_OK; i++) {
        const kern_vec p = framed(f, w->rest[i]);
        good = fabs((double)(p.x - other.rest[i].x)) <= NEAR * f->scale
            && fabs((double)(p.y - other.rest[i].y)) <= NEAR * f->scale;
    }
    return good;
}

static void laws(void)
{
    const struct frame frame[5] = {{-1, 1, 0, 0, 0},
                                   {1, 1, 100, -50, 0},
                                   {1, 1024, 0, 0, 0},
                                   {1, 1, 0, 0, 1},
                                   {-1, 1.0 / 64, 3, 1, 1}};
    int wall, i, k, tried = 0, good[5] = {0, 0, 0, 0, 0};
    for (wall = 0; wall < 4; wall++) {
        build(&world, 12);
        for (i = 0; i < 50; i++) {
            kern_vec v[CORNERS];
            const int n = random_stone(v);
            const double x = uniform(-1, 6), turn = uniform(-2, 2);
            tried++;
            for (k = 0; k < 5; k++)
                good[k] += law(&world, &frame[k], v, n, x, turn);
        }
    }
    for (k = 0; k < 5; k++) {
        if (good[k] < tried)
            printf("frame %d: %d of %d are alike\n", k, good[k], tried);
        CHECK(good[k]
              >= (sizeof(kern_real) == sizeof(double) ? tried : tried / 2));
    }
}

/* Fills `other` with the wall, all of it fixed. */
static void fix_wall(struct world *w)
{
    int i;
    open_world(&other);
    other.plan.task.options = w->plan.task.options;
    for (i = 0; i < w->plan.task.s.blocks; i++)
        CHECK(add(&other, w->block[i].vertex, w->block[i].vertices, 0) >= 0);
}

/* What poses on walls are worth: none overlaps, and where the stone is held it
   stands on the wall, if that cannot move. */
static void poses(int walls)
{
    int wall, i, tried = 0, wedged = 0, held = 0, sound = 0, standing = 0;
    long units = 0;
    for (wall = 0; wall < walls; wall++) {
        build(&world, 36);
        fix_wall(&world);
        for (i = 0; i < 60; i++) {
            kern_vec v[CORNERS];
            const int n = random_stone(v);
            const kern_block b = stone_of(v, n);
            kern_status status = rest(&world, &b, uniform(0, 5),
                                      uniform(-2, 2));
            tried++;
            units += world.work.units;
            if (status != KERN_OK)
                continue;
            status = kern_plan_bears(&world.plan, &world.pose.block, 0, NULL);
            CHECK(status == KERN_STANDS || status == KERN_FALLS
                  || status == KERN_UNDECIDED);
            standing += status == KERN_STANDS;
            wedged += world.pose.held == KERN_WEDGED;
            if (world.pose.held != KERN_HELD)
                continue;
            held++;
            sound += kern_plan_bears(&other.plan, &world.pose.block, 0, NULL)
                  == KERN_STANDS;
        }
    }
    printf("%d walls, %d stones: %d held, of these %d stand on the fixed wall; "
           "%d wedged; the wall stands with %d; %.0f units a pose\n",
           walls, tried, held, sound, wedged, standing, (double)units / tried);
    CHECK(held > tried * 3 / 4 && sound >= held * 97 / 100);
}

/* ---- what is refused ---- */

static void refused(void)
{
    const kern_vec bow[4] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    kern_vec own[4], out[4];
    kern_block box, bad;
    kern_pose pose;
    kern_task *const task = &world.plan.task;
    memcpy(own, unit_box, sizeof own);
    box = stone_of(own, 4);
    open_world(&world);
    CHECK(rest(&world, &box, 0, 0) == KERN_NO_SUPPORT); /* an empty plan */
    add_box(&world, -1, -1, 1, 0);
    CHECK(rest(&world, &box, 5, 0) == KERN_NO_SUPPORT);
    CHECK(rest(&world, &box, -1.6, 0) == KERN_NO_SUPPORT);

    CHECK(kern_rest(NULL, &box, 0, 0, out, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, NULL, 0, 0, out, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, 0, NULL, &pose) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, 0, out, NULL) == KERN_BAD_POINTER);
    CHECK(kern_rest(task, &box, 0, 0, own, &pose) == KERN_BAD_POINTER);
    CHECK(rest(&world, &box, NAN, 0) == KERN_BAD_NUMBER);
    CHECK(rest(&world, &box, 0, HUGE_VAL) == KERN_BAD_NUMBER);
    CHECK(rest(&world, &box, 0, 65) == KERN_BAD_NUMBER);

    CHECK(kern_block_init(&bad, bow, 4, 1, NULL) == KERN_CROSSING);
    CHECK(rest(&world, &bad, 0, 0) == KERN_NO_BLOCK);
    CHECK(world.work.fault.block == 1);
    CHECK(rest(&world, &world.block[0], 0, 0) == KERN_BAD_BLOCK);
    bad = box;
    bad.vertex = NULL;
    bad.vertices = 0;
    CHECK(rest(&world, &bad, 0, 0) == KERN_FEW_VERTICES);
    own[2].x = 2;
    CHECK(rest(&world, &box, 0, 0) == KERN_STALE);
    own[2].x = 1;

    task->s.gravity.y = 0;
    CHECK(rest(&world, &box, 0, 0) == KERN_BAD_OPTION);
    task->s.gravity.y = -1;
    task->options.mu = -1;
    CHECK(rest(&world, &box, 0, 0) == KERN_BAD_FRICTION);
    task->options.mu = 0;
    task->options.limit = 1;
    CHECK(rest(&world, &box, 0, 0) == KERN_LIMIT);
    CHECK(world.work.units == 2);
    task->options.limit = 4;
    CHECK(rest(&world, &box, 0, 0) == KERN_LIMIT);
    task->options.limit = 0;
    CHECK(rest(&world, &box, 0, 0) == KERN_OK);
    world.block[0].vertices = -1;
    CHECK(rest(&world, &box, 0, 0) == KERN_NO_BLOCK);
    CHECK(world.work.fault.block == 0);
    world.block[0].vertices = 4;
    world.block[0].box.high.x = (kern_real)NAN;
    CHECK(rest(&world, &box, 0, 0) == KERN_BAD_NUMBER);
    CHECK(kern_status_text(KERN_NO_REST) != kern_status_text(KERN_NO_SUPPORT));
}

/* ---- ranking, copies ---- */

static void ranking(void)
{
    /* x, turn, stays, margin, own, load; the best first, alone 0.1 */
    static const kern_place order[8] = {
        {5, 0, (kern_real)0.91, (kern_real)0.2, 0, 0},
        {4, 0, (kern_real)0.9, (kern_real)0.1, 2, 1},
        {6, 0, (kern_real)0.99, (kern_real)0.1000001, 1, 2},
        {1, 0, (kern_real)0.95, (kern_real)0.1, 1, 1},
        {2, -1, (kern_real)0.95, (kern_real)0.1, 1, 1},
        {2, 1, (kern_real)0.95, (kern_real)0.1, 1, 1},
        {0, 0, 1, (kern_real)0.05, 9, 9},
        {0, 0, (kern_real)0.89, 9, 9, 9}};
    const kern_real alone = (kern_real)0.1;
    int i, k;
    for (i = 0; i < 8; i++)
        for (k = 0; k < 8; k++) {
            const int got = kern_place_compare(&order[i], &order[k], alone);
            CHECK((got > 0) == (i < k) && (got < 0) == (i > k));
        }
    CHECK(kern_place_compare(&order[0], NULL, alone) > 0);
    CHECK(kern_place_compare(NULL, &order[0], alone) < 0);
    CHECK(kern_place_compare(NULL, NULL, alone) == 0);
}

static void copies(void)
{
    const kern_block box = stone_of(unit_box, 4);
    kern_margin a, b;
    int i;
    build(&world, 20);
    CHECK(kern_measure(&world.plan.task, &a, NULL) == KERN_STANDS);
    open_world(&other);
    CHECK(kern_plan_copy(&other.plan, NULL) == KERN_BAD_POINTER);
    CHECK(kern_plan_copy(NULL, &world.plan) == KERN_BAD_POINTER);
    other.plan.block_room = 20;
    CHECK(kern_plan_copy(&other.plan, &world.plan) == KERN_NO_SPACE);
    CHECK(other.plan.task.s.blocks == 0);
    other.plan.block_room = BLOCKS;
    other.plan.contact_room = world.plan.task.s.contacts - 1;
    CHECK(kern_plan_copy(&other.plan, &world.plan) == KERN_NO_SPACE);
    other.plan.contact_room = POINTS;
    CHECK(kern_plan_copy(&other.plan, &world.plan) == KERN_OK);
    CHECK(other.plan.task.s.block == other.block);
    CHECK(other.plan.task.work == &other.work);
    for (i = 0; i < 20; i++) {
        kern_status got;
        if (rest(&world, &box, 0.3 * i, 0.2) != KERN_OK)
            continue;
        memset(&a, 0, sizeof a);
        memset(&b, 0, sizeof b);
        got = kern_plan_try(&world.plan, &world.pose.block, &a, NULL);
        CHECK(kern_plan_try(&other.plan, &world.pose.block, &b, NULL) == got);
        CHECK(memcmp(&a, &b, sizeof a) == 0);
        CHECK(world.work.units == other.work.units);
    }
}

int main(int argc, char **argv)
{
    if (argc == 3) {
        poses(atoi(argv[2]));
        return failed > 0;
    }
    flat_ground();
    over_an_edge();
    triangles();
    slopes();
    gaps_and_steps();
    shapes();
    laws();
    poses(6);
    refused();
    ranking();
    copies();
    printf("%d failed\n", failed);
    return failed > 0;
}
