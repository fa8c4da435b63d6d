/* cc -O2 -ffp-contract=off -o kern_test tests/kern_test.c -lm && ./kern_test

   Tests of kern.h. `kern_test --help` lists what it can be told; the same file
   is compiled with -DKERN_SINGLE (float) and with -DKERN_USE_GLPK -lglpk.

   Every verdict that a test gets through verdict() or measure() is verified
   again here, by code that shares nothing with the header but its types.

   CONTENTS: search for the tags. The tests run in the order of the file.
     tools      >>harness: checks; >>numbers: tolerances, random numbers
                >>worlds: structures by hand
     twin       >>twin: shares nothing with kern.h but its types; >>proofs:
                verified again; >>tableau: another simplex method
     answers    >>verdict: calls of the library, each answer verified
                >>random: structures from a seed
     geometry   >>polygon >>contact, >>turned: whichever way the world is
                >>steps >>outlines
     engine     >>engine: one row, one factor, one group, one basis
                >>lp, >>bases: the twin that tries all
     statics    >>proof >>digits: of the last digits; >>margin
                >>load: deficit, load factor, tilt
     plans      >>plan >>plan_fuzz >>jams
     bounds     >>bearing >>limits: of work
     known      >>known: cases whose answer is known, each with its derivation
                or source; >>laws; >>against: random ones against the twin
     bad input  >>bad >>statuses >>memory
     readers    >>profile: and what is near, measured, certain, critical
                >>raised >>pose: its error; >>push >>sensitivity
                >>forces: the least
     all        >>all: the list of tests, main()

   RULES of the header and their tests; `kern_test NAME` runs those alone whose
   names contain NAME:
     steps        steps_           line         contact_cube contact_narrow
     point        contact_points   corner       contact_concave
     face         contact_merged   overlap      overlap contact_in_a_mouth
     gap, angle   contact_gap contact_floor contact_angle
     each of them where it alone decides: contact_rules
     shrinkage    contact_travels  lone         lone_points
     level        margin_steps     margin       margin_ known_
     deficit      deficit_         load factor  load_ laws_load
     tilt         tilt_            profile      profile_
     mechanism    proof_motions    critical     critical_
     stands       twin_ known_     falls        proof_

   Of the private parts of kern.h only these are called: kern_max, kern_closes;
   the boxes of an outline (kern_outline_set, kern_polygon_depth); in >>engine what
   is listed there. */

#include <float.h>
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "../examples/lab/random.h"

/* ==== Harness =================================================== >>harness */

static long passed, failed, failed_here;
static char context[160]; /* which random case, for messages */
static int quick;         /* fewer random structures */

/* How many of `all` structures are made. */
static int some(int all) { return quick ? all / 5 : all; }

static void check_report(int ok, int line, const char *what, double got,
                         double want, double tol)
{
    if (ok) {
        passed++;
        return;
    }
    failed++;
    if (failed_here++ < 10)
        printf("%s:%d: %s: got %.12g, want %.12g within %.3g %s\n", __FILE__,
               line, what, got, want, tol, context);
}

static int check_near(double got, double want, double tol, int line,
                      const char *what)
{
    /* a NaN fails; equal infinities pass */
    const int ok = fabs(got - want) <= tol
                || (isinf(got) && isinf(want) && (got > 0) == (want > 0));
    check_report(ok, line, what, got, want, tol);
    return ok;
}

#define CHECK(cond) check_report((cond) ? 1 : 0, __LINE__, #cond, 0, 1, 0)
#define CHECK_INT(got, want) \
    check_near((double)(got), (double)(want), 0, __LINE__, #got)
#define CHECK_NEAR(got, want, tol) \
    check_near((double)(got), (double)(want), (double)(tol), __LINE__, #got)

/* Whether run(4 n) takes less than `most` times as long as run(n): 4 where time
   is proportional to n, 16 where it is to n^2. Each is the least of up to 30
   runs, since a machine that is busy takes longer now and then. */
static int grows_less(void (*run)(int), int n, double most)
{
    double least[2] = {HUGE_VAL, HUGE_VAL};
    int i, k;
    for (i = 0; i < 30; i++) {
        for (k = 0; k < 2; k++) {
            const clock_t start = clock();
            run(k ? 4 * n : n);
            least[k] = fmin(least[k], (double)(clock() - start));
        }
        if (i > 1 && least[1] < most * fmax(least[0], 1))
            return 1;
    }
    return 0;
}

/* ---- numbers --------------------------------------------------- >>numbers */

#define R(x) ((kern_real)(x))
#define COUNT_OF(array) ((int)(sizeof(array) / sizeof *(array)))

#ifdef KERN_USE_GLPK
#define GLPK 1
#else
#define GLPK 0
#endif
#ifdef KERN_SINGLE
typedef double wide; /* the twin's numbers: wider than kern_real */
#define SINGLE 1
#define EPS ((double)FLT_EPSILON)
#define FORCE_BOUND 1e3  /* F: forces larger than this count as none */
#define TWIN_ZERO 1e-12  /* the twin's own rounding: of its sum,     */
#define TWIN_PRICE 1e-14 /* of its prices,                           */
#define TWIN_PIVOT 1e-10 /* and of its pivots                        */
#define NEAR_LO \
    1e-7 /* shortfall, as a share of the weight, that                          \
            is surely none ...                       */
#define NEAR_HI \
    2e-3 /* ... and surely one: in between a verdict                           \
            may be either                            */
#else
typedef long double wide;
#define SINGLE 0
#define EPS DBL_EPSILON
#define FORCE_BOUND 1e6
#define TWIN_ZERO 1e-15
#define TWIN_PRICE 1e-17
#define TWIN_PIVOT 1e-11
#define NEAR_LO 1e-12
#define NEAR_HI 1e-8
#endif

/* Share of a block's weight that a residual may be: 1e-9 in double. */
#define PROOF_TOL (SINGLE ? 1e-4 : 1e-9)
/* Lengths of thresholds found through verdicts, as a share of a block: a few
   times PROOF_TOL, since the verdict may be off by as much. */
#define EDGE (SINGLE ? 2e-3 : 5e-9)
/* Measures with a formula: the margin to 1e-9 of a block. */
#define EXACT (SINGLE ? 1e-4 : 1e-9)
/* Tables of five digits. */
#define DIGITS5 6e-6
/* Geometry: some roundings. */
#define GEO (64 * EPS)

static const double pi = 3.14159265358979323846;

#define W 9.81 /* the weight of a unit cube */

/* A quiet NaN and an infinity that no compiler warns about. */
static double huge_value(void)
{
    volatile double x = DBL_MAX;
    return x * 2;
}

static double not_a_number(void)
{
    volatile double x = huge_value();
    return x - x;
}

enum { NO_NUMBERS = 3 };

static double no_number(int which)
{
    return which == 0 ? not_a_number()
         : which == 1 ? huge_value()
                      : -huge_value();
}

static uint64_t random_state = 88172645463325252ull;

static void random_seed(unsigned long long seed)
{
    random_state = random_from(seed);
}

static double uniform(double low, double high)
{
    return random_uniform(&random_state, low, high);
}

static int random_int(int low, int high) /* both ends included */
{
    return low + (int)(random_bits(&random_state) % (uint64_t)(high - low + 1));
}

static int chance(double share) { return uniform(0, 1) < share; }

/* ==== Worlds ===================================================== >>worlds */

/* A task of these, valid for the next seven; NULL where one of the first two is
   NULL. */
static kern_task *task_of(const kern_structure *s, const kern_options *options,
                          kern_work *work)
{
    static kern_task tasks[8];
    static int next;
    kern_task *task = &tasks[next++ % 8];
    if (!s || !options)
        return NULL;
    *task = kern_task_of(s->block, s->blocks, s->contact, s->contacts, work);
    task->s.gravity = s->gravity;
    task->options = *options;
    return task;
}

/* kern_contact_make() with everything as a parameter. */
static int contact_make(int a, int b, kern_vec n, kern_vec p, kern_vec q,
                        kern_real mu, const kern_options *options,
                        kern_contact *out)
{
    if (out) {
        out->a = a;
        out->b = b;
        out->n = n;
        out->p = p;
        out->mu = mu;
    }
    return kern_contact_make(out, q, options);
}

/* A structure with the memory of everything it holds. */
enum { MAX_BLOCKS = 160, MAX_VERTICES = 2000, MAX_POINTS = 1600 };

typedef struct world {
    kern_block block[MAX_BLOCKS];
    kern_vec vertex[MAX_VERTICES];
    kern_contact contact[MAX_POINTS];
    int blocks, vertices, contacts;
    int given; /* contacts are explicit, not found */
    kern_vec gravity;
    kern_options options;
    double mu; /* of the explicit contacts made next */
} world;

static kern_vec vec(double x, double y)
{
    kern_vec v;
    v.x = R(x);
    v.y = R(y);
    return v;
}

static void world_reset(world *w)
{
    w->blocks = w->vertices = w->contacts = w->given = 0;
    w->gravity = vec(0, -9.81);
    w->options = kern_defaults();
    w->mu = 0.4;
}

/* Adds a block from a polygon x0 y0 x1 y1 ...; density 0 means fixed here. */
static int world_polygon(world *w, double density, const double *xy, int n)
{
    kern_vec *v = w->vertex + w->vertices;
    kern_fault fault;
    int i;
    if (w->blocks >= MAX_BLOCKS || w->vertices + n > MAX_VERTICES) {
        CHECK(!"world too small");
        return 0;
    }
    for (i = 0; i < n; i++)
        v[i] = vec(xy[2 * i], xy[2 * i + 1]);
    w->vertices += n;
    CHECK_INT(
        density > 0
            ? kern_block_init(&w->block[w->blocks], v, n, R(density), &fault)
            : kern_ground_init(&w->block[w->blocks], v, n, &fault),
        KERN_OK);
    return w->blocks++;
}

static int world_box(world *w, double density, double x0, double y0, double x1,
                     double y1)
{
    double xy[8];
    xy[0] = x0;
    xy[1] = y0;
    xy[2] = x1;
    xy[3] = y0;
    xy[4] = x1;
    xy[5] = y1;
    xy[6] = x0;
    xy[7] = y1;
    return world_polygon(w, density, xy, 4);
}

/* A block without a polygon, for explicit contacts; mass 0 makes it fixed. */
static int world_mass(world *w, double mass, double x, double y, double size)
{
    kern_block *b = &w->block[w->blocks];
    memset(b, 0, sizeof *b);
    b->fixed = !(mass > 0);
    b->mass = R(mass);
    b->area = R(size * size);
    b->centre = vec(x, y);
    return w->blocks++;
}

static void world_line(world *w, int a, int b, double nx, double ny, double x0,
                       double y0, double x1, double y1)
{
    const int got = contact_make(a, b, vec(nx, ny), vec(x0, y0), vec(x1, y1),
                                 R(w->mu), &w->options,
                                 w->contact + w->contacts);
    w->given = 1;
    CHECK(got == 1 || got == 2);
    if (got > 0)
        w->contacts += got;
}

static void world_point(world *w, int a, int b, double nx, double ny, double x,
                        double y)
{
    world_line(w, a, b, nx, ny, x, y, x, y);
}

/* Finds the contacts, or sets the travels of those given. Counts the points. */
static int world_touch(world *w)
{
    static int index[2 * MAX_BLOCKS];
    kern_work work = kern_work_of(NULL, 0, index, 2 * w->blocks);
    int got;
    if (w->given) {
        kern_contact_travels(w->contact, w->contacts);
        return w->contacts;
    }
    got = kern_contacts(w->block, w->blocks, &w->options, w->contact,
                        MAX_POINTS, &work);
    w->contacts = got > 0 ? got : 0;
    return got;
}

/* A floor and a cube on it. */
static void one_cube(world *w)
{
    world_reset(w);
    world_box(w, 0, -2, -1, 3, 0);
    world_box(w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(w), 2);
}

/* A wide floor, a cube on it, and a cube shifted by s: d* = 1/2 - s. */
static void stack_of_two(world *w, double s)
{
    world_reset(w);
    world_box(w, 0, -5, -1, 5, 0);
    world_box(w, 1, 0, 0, 1, 1);
    world_box(w, 1, s, 1, 1 + s, 2);
    world_touch(w);
}

static kern_structure structure_of(const world *w)
{
    const kern_structure s = {w->block, w->blocks, w->contact, w->contacts,
                              w->gravity};
    return s;
}

static kern_task *world_task(const world *w, kern_work *work)
{
    const kern_structure s = structure_of(w);
    return task_of(&s, &w->options, work);
}

static void world_copy(world *to, const world *from)
{
    int i;
    memcpy(to, from, sizeof *to);
    for (i = 0; i < to->blocks; i++)
        if (to->block[i].vertex)
            to->block[i].vertex = to->vertex
                                + (from->block[i].vertex - from->vertex);
}

static void world_friction(world *w, double mu)
{
    int k;
    for (k = 0; k < w->contacts; k++)
        w->contact[k].mu = R(mu);
}

static double mean_size(const world *w)
{
    double sum = 0;
    int i, n = 0;
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed) {
            sum += sqrt(fabs((double)w->block[i].area));
            n++;
        }
    return n > 0 ? sum / n : 0;
}

/* Work memory of exactly the size that the header asks for, so that a memory
   checker sees a write behind it. */
static kern_work work_for(int blocks, int contacts)
{
    static kern_real *real;
    static int *index;
    static int reals = -1, indices = -1;
    int need_reals, need_indices;
    kern_work_need(blocks, contacts, &need_reals, &need_indices);
    if (need_reals != reals || need_indices != indices) {
        free(real);
        free(index);
        reals = need_reals;
        indices = need_indices;
        real = (kern_real *)malloc(sizeof *real * (size_t)reals);
        index = (int *)malloc(sizeof *index * (size_t)indices);
    }
    return kern_work_of(real, reals, index, indices);
}

/* Numbers that a test puts into work memory and behind it, to see that what
   lies behind stays. */
enum { GUARD = 64, MARK = 12345 };

static void guard_fill(kern_real *real, int reals, int *index, int ints)
{
    int k;
    for (k = 0; k < reals + GUARD; k++)
        real[k] = R(MARK);
    for (k = 0; k < ints + GUARD; k++)
        index[k] = MARK;
}

/* Is everything behind the work memory as guard_fill() left it? */
static int guard_holds(const kern_work *work, int reals, int ints)
{
    int k, clean = 1;
    for (k = work->reals; k < reals + GUARD; k++)
        clean = clean && !(work->real[k] < R(MARK))
             && !(work->real[k] > R(MARK));
    for (k = work->indices; k < ints + GUARD; k++)
        clean = clean && work->index[k] == MARK;
    return clean;
}

static kern_work work_of(const world *w)
{
    return work_for(w->blocks, w->contacts);
}

/* The same, with only part of 50 of what is needed. */
static kern_work work_of_part(const world *w, int part)
{
    kern_work work = work_of(w);
    int reals, ints;
    kern_work_need(w->blocks, w->contacts, &reals, &ints);
    work.reals = reals * part / 50;
    work.indices = ints * part / 50;
    return work;
}

/* ==== The independent solver ====================================== >>twin */

/* ---- proofs ----------------------------------------------------- >>proofs */

/* Checked again as kern_check_forces() and kern_check_motion() define them,
   with contact points moved as >>rules of the header says. */

/* Do two points belong to one interface, in either order of its blocks? */
static int same_interface(const kern_contact *p, const kern_contact *q)
{
    return (p->a == q->a && p->b == q->b) || (p->a == q->b && p->b == q->a);
}

/* The middle of the line that ends in contact k: ends come in pairs. */
static void middle_of_line(const world *w, int k, wide *x, wide *y)
{
    int i, other, before = 0;
    for (i = k - 1; i >= 0 && w->contact[i].line; i--)
        before++;
    other = before % 2 ? k - 1 : k + 1;
    *x = ((wide)w->contact[k].p.x + w->contact[other].p.x) / 2;
    *y = ((wide)w->contact[k].p.y + w->contact[other].p.y) / 2;
}

/* Whether contact p carries the same block as contact k, as options.lone says
   where down is. */
static int carry_the_same(const world *w, const kern_contact *p,
                          const kern_contact *k)
{
    const kern_vec down = w->options.lone;
    const double of_p = (double)(p->n.x * down.x + p->n.y * down.y);
    const double of_k = (double)(k->n.x * down.x + k->n.y * down.y);
    return (of_p < 0 || of_p > 0) && (of_k < 0 || of_k > 0)
        && (of_p < 0 ? p->b : p->a) == (of_k < 0 ? k->b : k->a);
}

/* The middle of what carries the block of contact k. */
static void middle_of_carriers(const world *w, int k, wide *x, wide *y)
{
    const kern_contact *c = &w->contact[k];
    wide most = -1;
    int i, j;
    for (i = 0; i < w->contacts; i++)
        for (j = i; j < w->contacts; j++) {
            const kern_contact *p = &w->contact[i], *q = &w->contact[j];
            const wide dx = (wide)p->p.x - q->p.x, dy = (wide)p->p.y - q->p.y;
            if (!carry_the_same(w, p, c) || !carry_the_same(w, q, c)
                || dx * dx + dy * dy <= most)
                continue;
            most = dx * dx + dy * dy;
            *x = ((wide)p->p.x + q->p.x) / 2;
            *y = ((wide)p->p.y + q->p.y) / 2;
        }
}

/* The middle between the two points of the interface of contact k that are
   furthest apart. */
static void middle_of_points(const world *w, int k, wide *x, wide *y)
{
    const kern_contact *c = &w->contact[k];
    wide most = -1;
    int i, j;
    int points = 0;
    *x = c->p.x;
    *y = c->p.y;
    for (i = 0; i < w->contacts; i++) {
        const kern_contact *p = &w->contact[i];
        if (p->line || !same_interface(p, c))
            continue;
        points++;
        for (j = i + 1; j < w->contacts; j++) {
            const kern_contact *q = &w->contact[j];
            const wide dx = (wide)p->p.x - q->p.x, dy = (wide)p->p.y - q->p.y;
            if (q->line || !same_interface(q, c) || dx * dx + dy * dy <= most)
                continue;
            most = dx * dx + dy * dy;
            *x = ((wide)p->p.x + q->p.x) / 2;
            *y = ((wide)p->p.y + q->p.y) / 2;
        }
    }
    if (points == 1 && carry_the_same(w, c, c))
        middle_of_carriers(w, k, x, y);
}

/* The way that the point of each contact may go. Written from the definition:
   ends of a line meet in the middle, points of one interface at the feet of its
   centre, with options.lone the one point of an interface at the foot of the
   middle of what carries its block. */
static void own_travels(const world *w, wide *travel)
{
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        wide x, y;
        if (c->line)
            middle_of_line(w, k, &x, &y);
        else
            middle_of_points(w, k, &x, &y);
        travel[k] = (x - c->p.x) * -(wide)c->n.y + (y - c->p.y) * (wide)c->n.x;
        if (fabs((double)travel[k]) < 1e-9 * mean_size(w))
            travel[k] = 0;
    }
}

static wide own_slide(wide travel, wide d, int relative)
{
    const wide way = travel < 0 ? -travel : travel;
    const wide sign = travel < 0 ? -1 : travel > 0 ? 1 : 0;
    if (relative)
        return d * travel;
    return sign * (d < way ? d : way);
}

/* Weight and loads of a block, in newtons. */
static wide own_weight(const world *w, int i)
{
    const kern_block *b = &w->block[i];
    const double size = sqrt(fabs((double)b->area));
    double sum = (double)b->mass
                   * hypot((double)w->gravity.x, (double)w->gravity.y)
               + hypot((double)b->load.fx, (double)b->load.fy);
    if (b->load.torque < 0 || b->load.torque > 0)
        sum += fabs((double)b->load.torque) / (size > 0 ? size : 1);
    return sum;
}

static wide own_total(const world *w)
{
    wide sum = 0;
    int i;
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed)
            sum += own_weight(w, i);
    return sum;
}

/* Largest violation of the friction cones, in roundings; *total is the sum of
   the normal forces. Infinite where a force lies clearly outside. */
static wide share_of_cones(const world *w, const kern_force *force, wide *total)
{
    wide worst = 0;
    int k;
    *total = 0;
    for (k = 0; k < w->contacts; k++) {
        const wide f = force[k].normal, r = force[k].tangential;
        const wide limit = (wide)w->contact[k].mu * f;
        const wide over = (r < 0 ? -r : r) - limit,
                   round_off = 8 * (wide)EPS * limit;
        if (!(f >= 0) || !(over <= 1000 * round_off))
            return (wide)huge_value();
        if (over > 0 && over > worst * round_off)
            worst = over / round_off;
        *total += f;
    }
    return worst;
}

/* How far block i is from equilibrium, as a share of the allowed. */
static wide share_of_block(const world *w, double d, const wide *travel,
                           const kern_force *force, int i)
{
    const kern_block *b = &w->block[i];
    const double area = fabs((double)b->area);
    const wide size = area > 0         ? sqrt(area)
                    : mean_size(w) > 0 ? mean_size(w)
                                       : 1;
    wide fx = (wide)b->mass * w->gravity.x + b->load.fx;
    wide fy = (wide)b->mass * w->gravity.y + b->load.fy;
    wide torque = b->load.torque, largest = 0, noise = 0, allowed, error;
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const wide s = own_slide(travel[k], (wide)d, w->options.relative);
        const wide px = c->p.x - s * c->n.y - b->centre.x;
        const wide py = c->p.y + s * c->n.x - b->centre.y;
        const wide f = force[k].normal, r = force[k].tangential;
        const int side = c->b == i ? 1 : -1;
        const wide gx = side * (f * c->n.x - r * c->n.y);
        const wide gy = side * (f * c->n.y + r * c->n.x);
        if (c->a != i && c->b != i)
            continue;
        fx += gx;
        fy += gy;
        torque += px * gy - py * gx;
        if (f > largest)
            largest = f;
        /* places are known to the rounding of their coordinates, no better */
        noise += 4 * EPS * (1 + (double)c->mu) * (double)f
               * (fabs((double)c->p.x) + fabs((double)c->p.y)
                  + fabs((double)b->centre.x) + fabs((double)b->centre.y))
               / (double)size;
    }
    allowed = (wide)PROOF_TOL * (own_weight(w, i) + 1e-12 * largest) + noise
            + (SINGLE ? 32 * (wide)EPS * largest : 0);
    error = (wide)fmax(fmax(fabs((double)fx), fabs((double)fy)),
                       fabs((double)(torque / size)));
    if (error <= 0)
        return 0;
    return allowed > 0 ? error / allowed : (wide)huge_value();
}

/* Largest violation of what forces must satisfy, as a share of the allowed. */
static double share_of_forces(const world *w, double d, const kern_force *force)
{
    static wide travel[MAX_POINTS];
    wide total, worst = share_of_cones(w, force, &total);
    int i;
    own_travels(w, travel);
    if (isinf((double)worst))
        return (double)worst;
    if (total > (wide)FORCE_BOUND * own_total(w))
        worst = total / ((wide)FORCE_BOUND * own_total(w) + (wide)DBL_MIN);
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed) {
            const wide share = share_of_block(w, d, travel, force, i);
            if (!(share <= worst))
                worst = share;
        }
    return (double)worst;
}

/* The motion proves that the structure falls where this is at most 1: what
   forces of the largest size could take out of the motion, over what gravity
   and loads put in. */
static double share_of_motion(const world *w, double d,
                              const kern_motion *motion)
{
    static wide travel[MAX_POINTS];
    wide power = 0, against = 0, weight = 0;
    int i, k, side;
    own_travels(w, travel);
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        const kern_motion *v = &motion[i];
        const int moves = v->vx < 0 || v->vx > 0 || v->vy < 0 || v->vy > 0
                       || v->spin < 0 || v->spin > 0;
        if (!(fabs((double)v->vx) + fabs((double)v->vy) + fabs((double)v->spin)
              <= DBL_MAX))
            return huge_value();
        if (b->fixed) {
            if (moves)
                return huge_value();
            continue;
        }
        if (moves)
            weight += own_weight(w, i);
        power += ((wide)b->mass * w->gravity.x + b->load.fx) * v->vx
               + ((wide)b->mass * w->gravity.y + b->load.fy) * v->vy
               + (wide)b->load.torque * v->spin;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const kern_block *a = &w->block[c->a], *b = &w->block[c->b];
        const kern_motion *va = &motion[c->a], *vb = &motion[c->b];
        const wide s = own_slide(travel[k], (wide)d, w->options.relative);
        const wide px = c->p.x - s * c->n.y, py = c->p.y + s * c->n.x;
        const wide rx = vb->vx - (wide)vb->spin * (py - b->centre.y)
                      - (va->vx - (wide)va->spin * (py - a->centre.y));
        const wide ry = vb->vy + (wide)vb->spin * (px - b->centre.x)
                      - (va->vy + (wide)va->spin * (px - a->centre.x));
        const wide open = rx * c->n.x + ry * c->n.y;
        const wide slide = ry * c->n.x - rx * c->n.y;
        /* places are known to the rounding of their coordinates, no better */
        const double reach = fabs((double)px) + fabs((double)py);
        const wide noise = 4 * EPS * (1 + (double)c->mu)
                         * (fabs((double)va->vx) + fabs((double)va->vy)
                            + fabs((double)vb->vx) + fabs((double)vb->vy)
                            + fabs((double)va->spin)
                                  * (reach + fabs((double)a->centre.x)
                                     + fabs((double)a->centre.y))
                            + fabs((double)vb->spin)
                                  * (reach + fabs((double)b->centre.x)
                                     + fabs((double)b->centre.y)));
        for (side = -1; side <= 1; side += 2)
            if (-(open + side * (wide)c->mu * slide) - noise > against)
                against = -(open + side * (wide)c->mu * slide) - noise;
    }
    if (!(power > 0))
        return huge_value();
    return (double)((wide)FORCE_BOUND * weight * against / power);
}

/* ---- the twin: a simplex method on a dense tableau ------------- >>tableau */

static wide *twin_table;
static int *twin_basis, twin_stalled;
#define TWIN_MOST 20000
static long twin_room;

/* The tableau of twin_least_error(): `rows` rows of all + 1 numbers, and below
   them the prices. Columns from `errors` on are the errors; the last holds the
   right-hand side. */
typedef struct tableau {
    int rows, errors, all;
    int still; /* pivots since something moved: then Bland's rule */
} tableau;

static wide *twin_row(const tableau *t, int i)
{
    return twin_table + (long)i * (t->all + 1);
}

/* Prices carry the roundings of all pivots: before they are believed they are
   made anew from the rows that err. */
static void twin_price(const tableau *t)
{
    wide *cost = twin_row(t, t->rows);
    int i, j;
    for (j = 0; j <= t->all; j++) {
        cost[j] = j >= t->errors && j < t->all ? 1 : 0;
        for (i = 0; i < t->rows; i++)
            if (twin_basis[i] >= t->errors)
                cost[j] -= twin_row(t, i)[j];
    }
    for (i = 0; i < t->rows; i++)
        cost[twin_basis[i]] = 0;
}

/* The entering column, -1: none. */
static int twin_enter(const tableau *t)
{
    const wide *cost = twin_row(t, t->rows);
    wide best = -(wide)TWIN_PRICE;
    int j, enter = -1;
    for (j = 0; j < t->all; j++)
        if (cost[j] < best) {
            enter = j;
            if (t->still > 2 * t->rows)
                break;
            best = cost[j];
        }
    return enter;
}

/* The leaving row, -1: none. A row may go below zero by TWIN_ZERO, so that
   among ties, which are the rule here, the largest coefficient can be taken. */
static int twin_leave(const tableau *t, int enter)
{
    wide least = 0;
    int i, leave = -1;
    for (i = 0; i < t->rows; i++) {
        const wide *row = twin_row(t, i);
        if (row[enter] > (wide)TWIN_PIVOT
            && (leave < 0
                || (row[t->all] + (wide)TWIN_ZERO) / row[enter] < least)) {
            least = (row[t->all] + (wide)TWIN_ZERO) / row[enter];
            leave = i;
        }
    }
    for (i = 0; i < t->rows && leave >= 0; i++) {
        const wide *row = twin_row(t, i), *now = twin_row(t, leave);
        if (row[enter] > (wide)TWIN_PIVOT && row[t->all] / row[enter] <= least
            && (t->still > 2 * t->rows && row[enter] > (wide)1e-6
                        && now[enter] > (wide)1e-6
                    ? twin_basis[i] < twin_basis[leave]
                    : row[enter] > now[enter]))
            leave = i;
    }
    return leave;
}

static void twin_pivot(const tableau *t, int enter, int leave)
{
    wide *pivot = twin_row(t, leave);
    const wide by = 1 / pivot[enter];
    int i, j;
    for (j = 0; j <= t->all; j++)
        pivot[j] *= by;
    pivot[enter] = 1;
    for (i = 0; i <= t->rows; i++) {
        wide *row = twin_row(t, i);
        const wide h = row[enter];
        if (i == leave || (h <= 0 && h >= 0))
            continue;
        for (j = 0; j <= t->all; j++)
            row[j] -= h * pivot[j];
        row[enter] = 0;
        if (i < t->rows && row[t->all] < 0)
            row[t->all] = 0;
    }
    twin_basis[leave] = enter;
}

/* Least sum of errors, up and down, in all rows but the last. A row of the
   tableau holds `cols` coefficients, two error columns for each row but the
   last (+1 and -1), and the right-hand side, which is not negative. The last
   row has its own slack in column cols - 1 and no error. Errors cost 1 each.
   Largest price first; Bland's rule when nothing has moved for a while. */
static wide twin_least_error(int rows, int cols)
{
    tableau t;
    wide sum = 0;
    long count;
    int i, fresh = 0;
    t.rows = rows;
    t.errors = cols;
    t.all = cols + 2 * (rows - 1);
    t.still = 0;
    for (i = 0; i < rows - 1; i++) {
        twin_row(&t, i)[cols + i] = 1;
        twin_row(&t, i)[cols + rows - 1 + i] = -1;
        twin_basis[i] = cols + i;
    }
    twin_basis[rows - 1] = cols - 1;
    for (count = 0; count < TWIN_MOST; count++) {
        wide *cost = twin_row(&t, rows), before;
        int enter, leave;
        if (count == 0 || fresh == 1)
            twin_price(&t);
        before = -cost[t.all];
        enter = twin_enter(&t);
        if (before < (wide)TWIN_ZERO || (enter < 0 && fresh))
            break;
        fresh = enter < 0;
        if (fresh)
            continue;
        leave = twin_leave(&t, enter);
        if (leave < 0) {
            cost[enter] = 0; /* only roundings are left of this price */
            continue;
        }
        twin_pivot(&t, enter, leave);
        t.still = -cost[t.all] < before - (wide)TWIN_ZERO ? 0 : t.still + 1;
    }
    /* it has no rule against cycling: where it stalls it cannot tell */
    twin_stalled = count == TWIN_MOST;
    for (i = 0; i < rows; i++)
        if (twin_basis[i] >= cols)
            sum += twin_row(&t, i)[t.all];
    return sum;
}

/* An empty tableau of the size, in memory that grows. */
static void twin_clear(int rows, int all)
{
    const long need = (long)(rows + 1) * (all + 1);
    long cell;
    if (need > twin_room) {
        free(twin_table);
        twin_table = (wide *)malloc(sizeof *twin_table * (size_t)need);
        twin_room = need;
    }
    if (!twin_basis)
        twin_basis = (int *)malloc(sizeof *twin_basis * (3 * MAX_BLOCKS + 1));
    for (cell = 0; cell < need; cell++)
        twin_table[cell] = 0;
}

static wide twin_size(const kern_block *b)
{
    const double area = fabs((double)b->area);
    return area > 0 ? sqrt(area) : 1;
}

/* The two columns of contact k, in the rows of its blocks: the edges of its
   friction cone. */
static void twin_contact(const world *w, int k, wide s, const int *row_of,
                         int all)
{
    const kern_contact *c = &w->contact[k];
    const wide px = c->p.x - s * c->n.y, py = c->p.y + s * c->n.x;
    int side, j;
    for (side = 0; side < 2; side++) {
        const wide m = side ? -(wide)c->mu : (wide)c->mu;
        const wide gx = c->n.x - m * c->n.y, gy = c->n.y + m * c->n.x;
        for (j = 0; j < 2; j++) {
            const int e = j ? c->b : c->a;
            const wide sign = j ? 1 : -1;
            const kern_block *b = &w->block[e];
            wide *at = twin_table + (long)row_of[e] * (all + 1) + 2 * k + side;
            if (row_of[e] < 0)
                continue;
            at[0] = sign * gx;
            at[all + 1] = sign * gy;
            at[2 * (all + 1)] = sign
                              * ((px - b->centre.x) * gy
                                 - (py - b->centre.y) * gx)
                              / twin_size(b);
        }
    }
}

/* The right-hand side of a block's rows, which are turned where it is
   negative. */
static void twin_load(const world *w, int i, wide weight, int row, int all)
{
    const kern_block *b = &w->block[i];
    wide load[3];
    int j, k;
    load[0] = (wide)b->mass * w->gravity.x + b->load.fx;
    load[1] = (wide)b->mass * w->gravity.y + b->load.fy;
    load[2] = (wide)b->load.torque / twin_size(b);
    for (j = 0; j < 3; j++) {
        wide *at = twin_table + (long)(row + j) * (all + 1);
        at[all] = -load[j] / weight;
        for (k = 0; k <= all && load[j] > 0; k++)
            at[k] = -at[k];
    }
}

/* How far the structure is from standing at shrinkage d (negative: grown): the
   least sum of equilibrium errors, as a share of the weight, that contact
   forces of total size up to `bound` times the weight leave. 0: it stands. */
static double twin_shortfall(const world *w, double d, double bound)
{
    static wide travel[MAX_POINTS];
    const wide weight = own_total(w);
    const int cols = 2 * w->contacts + 1;
    int row_of[MAX_BLOCKS], rows = 0, all, i, k;
    wide *last;
    own_travels(w, travel);
    for (i = 0; i < w->blocks; i++) {
        row_of[i] = w->block[i].fixed ? -1 : rows;
        rows += w->block[i].fixed ? 0 : 3;
    }
    if (!(weight > 0))
        return 0;
    rows++;
    all = cols + 2 * (rows - 1);
    twin_clear(rows, all);
    for (k = 0; k < w->contacts; k++)
        twin_contact(w, k, own_slide(travel[k], (wide)d, w->options.relative),
                     row_of, all);
    last = twin_table + (long)(rows - 1) * (all + 1);
    for (k = 0; k < cols - 1; k++)
        last[k] = 1 / (wide)bound;
    last[cols - 1] = 1;
    last[all] = 1;
    for (i = 0; i < w->blocks; i++)
        if (row_of[i] >= 0)
            twin_load(w, i, weight, row_of[i], all);
    return (double)twin_least_error(rows, cols);
}

/* A verdict agrees with the twin unless the twin is sure of the opposite. Near
   the edge, and where only forces about as large as the bound would help, the
   twin is not sure. */
static long twin_near, twin_asked;

static int twin_agrees(const world *w, double d, int stands)
{
    double z = twin_shortfall(w, d, FORCE_BOUND);
    twin_asked++;
    if (twin_stalled || (z > NEAR_LO && z < NEAR_HI))
        twin_near++;
    if (twin_stalled)
        return 1;
    if (stands ? z < NEAR_HI : z > NEAR_LO)
        return 1;
    z = twin_shortfall(w, d, stands ? FORCE_BOUND * 1000 : FORCE_BOUND / 1000);
    if (twin_stalled || (stands ? z < NEAR_HI : z > NEAR_LO)) {
        twin_near++;
        return 1;
    }
    return 0;
}

static double twin_most(const world *w)
{
    static wide travel[MAX_POINTS];
    double most = 0;
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++)
        most = fmax(most, fabs((double)travel[k]));
    return w->options.relative ? 1 : most;
}

/* Largest coordinate of a contact: its rounding is in every length. */
static double reach_of(const world *w)
{
    double most = 0;
    int k;
    for (k = 0; k < w->contacts; k++)
        most = fmax(most, fmax(fabs((double)w->contact[k].p.x),
                               fabs((double)w->contact[k].p.y)));
    return most;
}

/* Contacts are nested where no interface has two point contacts. */
static int twin_nested(const world *w)
{
    static wide travel[MAX_POINTS];
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++)
        if (!w->contact[k].line && (travel[k] < 0 || travel[k] > 0))
            return 0;
    return 1;
}

/* Algorithm 1, literally: shrink, test, until it falls. */
static int twin_level(const world *w, double epsilon, double most)
{
    int k = 0;
    if (twin_shortfall(w, 0, FORCE_BOUND) > NEAR_LO)
        return 0;
    for (;;) {
        double d;
        k++;
        d = k * epsilon < most ? k * epsilon : most;
        if (twin_shortfall(w, d, FORCE_BOUND) > NEAR_LO)
            return k;
        if (d >= most)
            return (int)ceil(most / epsilon) + 1;
    }
}

/* First loss: between `low`, which stands, and `high`, which falls. */
static double twin_bisect(const world *w, double low, double high, double width)
{
    while (high - low > width) {
        const double middle = (low + high) / 2;
        if (!(middle > low && middle < high))
            break;
        if (twin_shortfall(w, middle, FORCE_BOUND) > NEAR_LO)
            high = middle;
        else
            low = middle;
    }
    return (low + high) / 2;
}

/* ==== Verdicts with proofs ====================================== >>verdict */

static kern_force force_of[MAX_POINTS];
static kern_motion motion_of[MAX_BLOCKS];
static kern_real proof_error; /* largest that the library admitted */
static long undecided, asked;

static kern_proof proof_here(void)
{
    kern_proof proof;
    proof.force = force_of;
    proof.motion = motion_of;
    return proof;
}

/* In float the band between the two proofs is wide enough to be met by chance;
   then no verdict is right, if rare (see main). In double it must not happen.
 */
static int decided(int got)
{
    return got >= 0 || (SINGLE && got == KERN_UNDECIDED);
}

/* The largest of the speeds of the centres and of the spins times the size. */
static double speed_of(const world *w, const kern_motion *motion)
{
    double most = 0;
    int i;
    for (i = 0; i < w->blocks; i++) {
        const double size = sqrt(fabs((double)w->block[i].area));
        most = fmax(most, hypot((double)motion[i].vx, (double)motion[i].vy));
        most = fmax(most, fabs((double)motion[i].spin) * size);
    }
    return most;
}

/* kern_verdict(), its proof checked by the code above and by the header's. */
static int verdict(const world *w, double d)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w);
    const kern_status got = kern_verdict(world_task(w, &work), R(d), &proof);
    d = (double)R(d);
    asked++;
    if (work.error > proof_error)
        proof_error = work.error;
    if (got == KERN_STANDS) {
        CHECK(share_of_forces(w, d, force_of) <= 1.001);
        CHECK(kern_check_forces(world_task(w, &work), R(d), force_of) <= 1);
    } else if (got == KERN_FALLS) {
        CHECK(share_of_motion(w, d, motion_of) <= 1.001);
        CHECK(kern_check_motion(world_task(w, &work), R(d), motion_of) <= 1);
        CHECK_NEAR(speed_of(w, motion_of), 1, 100 * EPS);
    } else if (got == KERN_UNDECIDED)
        undecided++;
    return got;
}

/* Is it an answer without a verdict, or without a level? */
static int unanswered(int got, const kern_margin *m)
{
    return got == KERN_UNDECIDED || (got >= 0 && m->level < 0);
}

/* What a measure promises of a structure that does not stand. */
static void check_fallen(const world *w, const kern_margin *m)
{
    CHECK_INT(m->level, 0);
    CHECK(!(m->margin < 0) && !(m->margin > 0));
    CHECK(!(m->holds < 0) && !(m->holds > 0));
    CHECK(!m->saturated);
    CHECK(share_of_motion(w, 0, motion_of) <= 1.001);
}

/* And of one that stands at any shrinkage. */
static void check_saturated(const kern_margin *m)
{
    /* a quotient that is a whole number may be rounded either way */
    const double steps = (double)m->most / (double)m->epsilon,
                 slip = 8 * fmax(EPS, 1e-10) * steps;
    CHECK_NEAR(m->margin, m->most, 0);
    CHECK_NEAR(m->fails, m->most, 0);
    CHECK((SINGLE && m->level == -1) || m->level == (int)ceil(steps - slip) + 1
          || m->level == (int)ceil(steps + slip) + 1);
}

/* And of one that falls at the end of the bracket. */
static void check_end(const world *w, const kern_margin *m)
{
    const double mean = mean_size(w);
    const double past = (double)m->margin
                      + (SINGLE ? 1e-4 : 1e-6) * fmax((double)m->margin, mean);
    /* forces of GLPK miss more than a proof allows in a wider zone: the bracket
       may grow there to KERN_WIDEST times its width */
    const double wide_as = (SINGLE ? 0.04001
                            : GLPK ? 2.8001e-5
                                   : 2.0001e-6)
                         * (w->options.relative ? 1 : mean);
    CHECK_NEAR(m->fails - m->holds, 0, wide_as);
    CHECK(share_of_motion(w, (double)m->fails, motion_of) <= 1.001
          || share_of_motion(w, past, motion_of) <= 1.001);
    CHECK_NEAR(speed_of(w, motion_of), 1, 100 * EPS);
}

/* Everything that a measure promises about itself, where `work` counted it and
   its proofs are in force_of and motion_of. */
static void check_measure(const world *w, int got, const kern_margin *m,
                          const kern_work *work)
{
    asked++;
    if (work->error > proof_error)
        proof_error = work->error;
    undecided += unanswered(got, m);
    if (got < 0)
        return;
    CHECK_NEAR(m->most, twin_most(w), 8 * EPS * (reach_of(w) + mean_size(w)));
    CHECK(work->error <= 1 && work->solves > 0);
    if (got == KERN_FALLS) {
        check_fallen(w, m);
        return;
    }
    CHECK_INT(got, KERN_STANDS);
    CHECK(m->level >= 1 || (SINGLE && m->level == -1));
    CHECK(m->margin >= 0 && m->margin <= m->most);
    CHECK(m->holds >= 0 && m->holds <= m->margin * (1 + 4 * R(EPS)));
    CHECK(m->fails >= m->margin * (1 - 4 * R(EPS)) || m->saturated);
    CHECK(share_of_forces(w, (double)m->holds, force_of) <= 1.001);
    if (m->saturated)
        check_saturated(m);
    else
        check_end(w, m);
}

/* kern_measure(), checked. */
static int measure(const world *w, kern_margin *m)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w);
    int got;
    memset(m, 0, sizeof *m);
    got = kern_measure(world_task(w, &work), m, &proof);
    check_measure(w, got, m, &work);
    return got;
}

/* May both verdicts be right, since the twin cannot tell at d? */
static int open_question(const world *w, double d)
{
    return twin_agrees(w, d, 1) && twin_agrees(w, d, 0);
}

/* The bracket of a measured margin, asked again one verdict at a time. Where it
   ends within the tolerance of the edge both proofs can pass, so either verdict
   is right; none at all is not. */
static void check_bracket(const world *w, const kern_margin *m)
{
    const int holds = verdict(w, (double)m->holds);
    const int fails = m->saturated ? KERN_FALLS : verdict(w, (double)m->fails);
    CHECK(decided(holds) && decided(fails));
    CHECK(holds != KERN_FALLS || open_question(w, (double)m->holds));
    CHECK(fails != KERN_STANDS || m->saturated
          || open_question(w, (double)m->fails));
}

/* Two margins of one structure are alike, or what differs is an open question.
 */
static void same_margin(const world *w, double n, double m, double tol,
                        int line)
{
    if (fabs(n - m) > tol && !open_question(w, (n + m) / 2))
        check_near(n, m, tol, line, "margin of the same");
    passed++;
}

/* The same for the levels. One step more or less to closing is a rounding of
   the quotient of most and epsilon. */
static void same_level(const world *w, const kern_margin *m,
                       const kern_margin *n, int line)
{
    const double steps = (double)(m->most / m->epsilon);
    const double edge = (n->level < m->level ? n->level : m->level)
                      * (double)m->epsilon;
    const int closing = n->saturated && m->saturated
                     && abs(n->level - m->level) == 1
                     && fabs(steps - floor(steps + 0.5)) < 1e-6;
    if (n->level != m->level && !closing
        && !open_question(w, fmin(edge, (double)m->most)))
        check_near(n->level, m->level, 0, line, "level of the same");
    passed++;
}

/* The answer `now`, n is the answer `got`, m about w, its lengths `scale` times
   as long; or what differs is an open question. */
static void same_answer(const world *w, const kern_margin *m, int got,
                        const kern_margin *n, int now, double scale, double tol,
                        int line)
{
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double by = w->options.relative ? 1 : scale;
    if (SINGLE && (unanswered(now, n) || unanswered(got, m)))
        return; /* no answer is like any other */
    if (now != got) {
        if (now < 0 || got < 0 || !open_question(w, 0))
            check_near(now, got, 0, line, "verdict of the same");
        return;
    }
    passed++;
    if (got != KERN_STANDS)
        return;
    same_margin(w, (double)n->margin / by, (double)m->margin, tol * unit, line);
    same_level(w, m, n, line);
}

static int load_factor(const world *w, const kern_wrench *pattern, int side,
                       double *factor)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const kern_task *task = world_task(w, &work);
    const int got = pattern ? kern_load_factor_of(task, 0, pattern, &out, NULL)
                            : kern_load_factor(task, 0, side, &out, NULL);
    *factor = (double)out;
    return got;
}

static int tilt(const world *w, int side, double *angle)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const int got = kern_tilt(world_task(w, &work), 0, side, &out, NULL);
    *angle = (double)out;
    return got;
}

static int deficit(const world *w, double *growth)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const int got = kern_deficit(world_task(w, &work), &out);
    *growth = (double)out;
    return got;
}

/* Threshold of a family of structures: build(w, x) stands at `stands` and
   falls at `falls`. */
typedef void (*family)(world *w, double x);

static double threshold(family build, double stands, double falls)
{
    static world w;
    int i, got;
    build(&w, stands);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    build(&w, falls);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    for (i = 0; i < (SINGLE ? 20 : 40); i++) {
        const double middle = (stands + falls) / 2;
        build(&w, middle);
        got = verdict(&w, 0);
        if (got == KERN_UNDECIDED) {
            /* allowed only where nobody could tell */
            CHECK_NEAR(stands, falls, EDGE);
            undecided--;
            break;
        }
        if (got == KERN_STANDS)
            stands = middle;
        else
            falls = middle;
    }
    return (stands + falls) / 2;
}

/* ==== Random structures ========================================== >>random */

enum { TOWER, WALL, ARCH, PILE, POINTS, CONCAVE, CHAIN, KINDS };
static const char *const kind_name[KINDS] = {
    "tower", "wall", "arch", "pile", "points", "concave", "chain"};

/* Towers of boxes, each a little off the one below. */
static void random_tower(world *w, int blocks)
{
    double x = 0, y = 0;
    const double jitter = uniform(0.02, 0.5) / blocks + uniform(0, 0.1);
    int i;
    world_box(w, 0, -40, -1, 40, 0);
    for (i = 0; i < blocks; i++) {
        const double wide_as = uniform(0.6, 1.4), high = uniform(0.3, 1.2);
        x += uniform(-jitter, jitter);
        world_box(w, uniform(1, 3), x - wide_as / 2, y, x + wide_as / 2,
                  y + high);
        y += high;
    }
}

/* Courses of bricks with head joints that touch or not, and openings. */
static void random_wall(world *w, int blocks)
{
    const int row = random_int(1, 6);
    const double open = chance(0.5) ? 0 : 0.02, missing = chance(0.3) ? 0.1 : 0;
    double y = 0;
    int i = 0;
    world_box(w, 0, -40, -1, 40, 0);
    while (i < blocks) {
        double x = uniform(-0.3, 0.3);
        const double high = uniform(0.3, 0.7);
        int k;
        for (k = 0; k < row && i < blocks; k++) {
            const double wide_as = uniform(0.5, 1.5);
            if (y <= 0 || !chance(missing)) {
                world_box(w, 2, x, y, x + wide_as, y + high);
                i++;
            }
            x += wide_as + open;
        }
        y += high;
    }
}

/* A quadrilateral between two rays from the origin. */
static void world_voussoir(world *w, double density, double from, double to,
                           double inner, double outer)
{
    double xy[8];
    xy[0] = inner * cos(from);
    xy[1] = inner * sin(from);
    xy[2] = outer * cos(from);
    xy[3] = outer * sin(from);
    xy[4] = outer * cos(to);
    xy[5] = outer * sin(to);
    xy[6] = inner * cos(to);
    xy[7] = inner * sin(to);
    world_polygon(w, density, xy, 4);
}

/* Circular arches of equal voussoirs between two fixed ones. */
static void random_arch(world *w, int blocks)
{
    const double half = uniform(0.6, 0.5 * pi), t = uniform(0.04, 0.3) * half;
    const double step = 2 * half / blocks;
    int i;
    for (i = -1; i <= blocks; i++)
        world_voussoir(w, i < 0 || i == blocks ? 0 : 1,
                       pi / 2 - half + i * step, pi / 2 - half + (i + 1) * step,
                       1 - t / 2, 1 + t / 2);
}

/* Irregular stones: each lies on one to three earlier ones or on the ground,
   on short faces given one by one. Block 0 is the ground. */
static void random_pile(world *w, int blocks)
{
    int i, k;
    world_mass(w, 0, 0, 0, 1);
    for (i = 1; i <= blocks; i++) {
        const int supports = random_int(1, 3);
        const int on = i == 1 || chance(0.3)
                         ? 0
                         : random_int(i > 6 ? i - 6 : 1, i - 1);
        const double x = on ? (double)w->block[on].centre.x + uniform(-0.4, 0.4)
                            : uniform(-4, 4);
        const double y = on ? (double)w->block[on].centre.y + 1 : 0.5;
        world_mass(w, uniform(0.5, 2), x, y, uniform(0.8, 1.2));
        for (k = 0; k < supports; k++) {
            const int from = k == 0 ? on : random_int(0, i - 1);
            const double at = supports == 1
                                ? uniform(-0.2, 0.2)
                                : -0.5 + (k + uniform(0.2, 0.8)) / supports;
            const double lean = uniform(-0.6, 0.6) * (k == 0 ? 0.3 : 1);
            const double nx = sin(lean), ny = cos(lean),
                         half = uniform(0.05, 0.3);
            world_line(w, from, i, nx, ny, x + at - half * ny,
                       y - 0.5 + half * nx, x + at + half * ny,
                       y - 0.5 - half * nx);
        }
    }
}

/* Stones on points: two to four an interface, with normals of their own, so
   that shrinking is not monotone. */
static void random_points(world *w, int blocks)
{
    int i, k;
    world_mass(w, 0, 0, 0, 1);
    for (i = 1; i <= blocks; i++) {
        const int points = random_int(2, 4), swap = chance(0.5);
        const double x = uniform(-0.15, 0.15), y = i;
        world_mass(w, uniform(0.5, 2), x, y, 1);
        for (k = 0; k < points; k++) {
            const double lean = uniform(-0.9, 0.9);
            const double px = -0.6 + 1.2 * (k + uniform(0, 1)) / points;
            const double py = y - 0.5 + uniform(-0.2, 0.2);
            w->mu = uniform(0.1, 0.9);
            if (swap)
                world_point(w, i, i - 1, -sin(lean), -cos(lean), px, py);
            else
                world_point(w, i - 1, i, sin(lean), cos(lean), px, py);
        }
        if (chance(0.2)) /* a face beside the points of the interface */
            world_line(w, i - 1, i, 0, 1, -0.1, y - 0.5, 0.2, y - 0.5);
    }
}

/* L, T, U and Z shapes and boxes, one on the other and some side by side. */
static void random_concave(world *w, int blocks)
{
    double x = 0, y = 0;
    const double jitter = uniform(0.02, 0.3);
    int i;
    world_box(w, 0, -40, -1, 40, 0);
    for (i = 0; i < blocks; i++) {
        const double a = uniform(0.2, 0.4), h = uniform(0.8, 1.2);
        static const double shape[5][16] = {
            /* x in halves of the width, y in shares of the height; 2 marks a,
               -2 marks -a */
            {-1, 0, 1, 0, 1, 1, -1, 1},
            {-1, 0, 1, 0, 1, .4, -2, .4, -2, 1, -1, 1},
            {-2, 0, 2, 0, 2, .5, 1, .5, 1, 1, -1, 1, -1, .5, -2, .5},
            {-1, 0, -2, 0, -2, .6, 2, .6, 2, 0, 1, 0, 1, 1, -1, 1},
            {-1, 0, 2, 0, 2, .5, 1, .5, 1, 1, -2, 1, -2, .5, -1, .5}};
        static const int corners[5] = {4, 6, 8, 8, 8};
        const int kind = random_int(0, 4);
        const double side = chance(0.5) ? 1 : -1;
        double xy[16];
        int k;
        x += uniform(-jitter, jitter);
        for (k = 0; k < corners[kind]; k++) {
            double u = shape[kind][2 * k];
            u = u > 1.5 ? a : u < -1.5 ? -a : u;
            xy[2 * k] = x + side * u;
            xy[2 * k + 1] = y + h * shape[kind][2 * k + 1];
        }
        world_polygon(w, uniform(1, 2), xy, corners[kind]);
        y += h;
    }
}

/* Leaning rods, hung and propped at single points and held at lines. */
static void random_chain(world *w, int blocks)
{
    int i;
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 0, 5, 5, 1);
    for (i = 2; i < blocks + 2; i++) {
        const double x = uniform(0, 4), y = uniform(0, 4), r = uniform(0.3, 1);
        const int points = random_int(2, 4);
        int k;
        world_mass(w, uniform(0.5, 2), x, y, 1);
        for (k = 0; k < points; k++) {
            const int other = random_int(0, i - 1);
            const double lean = uniform(-pi, pi) * (k < 2 ? 0.4 : 0.6);
            const double at = uniform(-r, r);
            w->mu = uniform(0, 1);
            if (chance(0.5))
                world_point(w, other, i, sin(lean), cos(lean), x + at,
                            y - r * 0.3);
            else
                world_line(w, other, i, sin(lean), cos(lean), x + at,
                           y - r * 0.3, x + at + 0.2 * cos(lean),
                           y - r * 0.3 - 0.2 * sin(lean));
        }
    }
}

/* Loads on some of the blocks. */
static void random_loads(world *w)
{
    int i;
    for (i = 0; i < w->blocks; i++)
        if (!w->block[i].fixed && chance(0.4)) {
            kern_block *b = &w->block[i];
            const double weight = 9.81 * (double)b->mass;
            kern_block_load(
                b,
                vec(uniform(-0.3, 0.3) * weight, uniform(-0.5, 0.2) * weight),
                vec((double)b->centre.x + uniform(-0.3, 0.3),
                    (double)b->centre.y + uniform(-0.3, 0.3)),
                R(uniform(-0.05, 0.05) * weight));
        }
}

/* The random structure number `seed`, of any kind or of the one wanted.
   Returns its kind. */
static int random_of_kind(world *w, unsigned long long seed, int most,
                          int wanted)
{
    static void (*const make[KINDS])(world *, int) = {
        random_tower,  random_wall,    random_arch, random_pile,
        random_points, random_concave, random_chain};
    static const int fewer[KINDS] = {0, 0, 0, 0, 6, 0, 12};
    static const double step[4] = {0.02, 0.05, 0.1, 0.3};
    double epsilon;
    int kind, blocks;
    random_seed(seed);
    kind = random_int(0, KINDS - 1);
    kind = wanted < KINDS ? wanted : kind;
    /* small ones are the most frequent */
    blocks = 1 + (int)(pow(uniform(0, 1), 3) * most);
    blocks = blocks > most ? most : blocks;
    sprintf(context, "(random %llu: %s of %d)", seed, kind_name[kind], blocks);
    if (fewer[kind] > 0 && blocks > fewer[kind])
        blocks = fewer[kind];
    world_reset(w);
    w->mu = chance(0.7) ? uniform(0.3, 1) : uniform(0.05, 0.3);
    w->options.mu = R(w->mu);
    make[kind](w, blocks);
    CHECK(world_touch(w) >= 0);
    if (chance(0.3)) {
        const double lean = uniform(-0.25, 0.25);
        w->gravity = vec(9.81 * sin(lean), -9.81 * cos(lean));
    }
    if (chance(0.3))
        random_loads(w);
    w->options.relative = chance(0.3);
    epsilon = step[random_int(w->blocks > 12 ? 2 : 0, 3)] * uniform(0.9, 1.1);
    w->options.epsilon = R(w->options.relative ? epsilon
                                               : epsilon * mean_size(w));
    return kind;
}

static int random_world(world *w, unsigned long long seed, int most)
{
    return random_of_kind(w, seed, most, KINDS);
}

/* The literal scan: stands at every step below the level, falls at it. */
static void scan_with_twin(const world *w, const kern_margin *m)
{
    const double most = (double)m->most, epsilon = (double)m->epsilon;
    int k;
    for (k = 1; k <= m->level; k++) {
        const double d = k * epsilon < most ? k * epsilon : most;
        const int stands = k < m->level || m->saturated;
        if (!twin_agrees(w, d, stands)) {
            check_near(twin_level(w, epsilon, most), m->level, 0, __LINE__,
                       "level by linear scan");
            break;
        }
        if (d >= most)
            break;
    }
    passed++;
}

/* Where contacts are nested the verdict changes once: the margin, bisected. */
static void bisect_with_twin(const world *w, const kern_margin *m)
{
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double most = (double)m->most, margin = (double)m->margin;
    const double width = fmax(1e3 * EPS * unit, 1e-11 * unit);
    double d;
    if (m->saturated) {
        CHECK(twin_agrees(w, most, 1));
        return;
    }
    d = twin_bisect(w, (double)m->holds * 0.999,
                    fmin(most, (double)m->fails + 1e-3 * unit), width);
    /* or it is only a question of how large forces may grow */
    if (fabs(margin - d) > EXACT * unit
        && !twin_agrees(w, (margin + d) / 2, margin > d))
        CHECK_NEAR(margin, d, EXACT * unit);
    passed++;
}

/* Where they are not: no loss as wide as a thousandth of the way before the
   margin. */
static void losses_with_twin(const world *w, const kern_margin *m)
{
    const int steps = 2400;
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double most = (double)m->most;
    const double end = m->saturated ? most : (double)m->margin;
    /* in float a proof itself leaves 1e-4 of what acts on a block */
    const double off = (SINGLE ? 1e-4 : 1e-6) * unit;
    int k, lost = 0;
    for (k = 0; k <= steps; k++) {
        const double d = most * k / steps;
        if (d >= end - 1e-6 * unit)
            break;
        lost = twin_agrees(w, d, 1) ? 0 : lost + 1;
        if (lost > 2) {
            CHECK(!"a loss before the margin was missed");
            break;
        }
    }
    passed++;
    if (!m->saturated) {
        CHECK(twin_agrees(w, fmax(0, end - off), 1));
        CHECK(twin_agrees(w, fmin(most, end + 2 * off), 0));
    }
}

/* Verdict, level and margin against the twin. `deep` also bisects the margin.
 */
static void compare_with_twin(const world *w, int deep)
{
    kern_margin m;
    const int got = measure(w, &m);
    CHECK(decided(got));
    if (got < 0 || m.level < 0)
        return;
    CHECK(twin_agrees(w, 0, got == KERN_STANDS));
    if (got == KERN_FALLS)
        return;
    CHECK_NEAR(m.epsilon, w->options.epsilon, 0);
    scan_with_twin(w, &m);
    check_bracket(w, &m);
    if (!deep)
        return;
    if (twin_nested(w))
        bisect_with_twin(w, &m);
    else
        losses_with_twin(w, &m);
}

/* ==== Polygons ================================================== >>polygon */

static kern_status polygon(kern_block *b, kern_fault *fault, double density,
                           const double *xy, int n)
{
    static kern_vec v[64];
    int i;
    for (i = 0; i < n; i++)
        v[i] = vec(xy[2 * i], xy[2 * i + 1]);
    memset(b, 0x55, sizeof *b);
    fault->block = fault->other = fault->index = -7;
    fault->value = 0;
    return fabs(density) <= 0 ? kern_ground_init(b, v, n, fault)
                              : kern_block_init(b, v, n, R(density), fault);
}

static void polygon_area_and_centre(void)
{
    static const double square[] = {2, 3, 4, 3, 4, 5, 2, 5};
    static const double clock[] = {2, 5, 4, 5, 4, 3, 2, 3};
    static const double triangle[] = {0, 0, 3, 0, 0, 3};
    static const double ell[] = {0, 0, 2, 0, 2, 1, 1, 1, 1, 3, 0, 3};
    static const double midpoints[] = {0, 0, 1, 0, 2, 0, 2, 2, 0, 2, 0, 1};
    kern_block b;
    kern_fault fault;
    CHECK_INT(polygon(&b, &fault, 2.5, square, 4), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
    CHECK_NEAR(b.mass, 10, GEO);
    CHECK_NEAR(b.centre.x, 3, GEO);
    CHECK_NEAR(b.centre.y, 4, GEO);
    CHECK_NEAR(b.box.low.x, 2, 0);
    CHECK_NEAR(b.box.low.y, 3, 0);
    CHECK_NEAR(b.box.high.x, 4, 0);
    CHECK_NEAR(b.box.high.y, 5, 0);
    CHECK(!b.fixed && b.vertices == 4 && b.vertex);
    CHECK(!(b.load.fx < 0 || b.load.fx > 0 || b.load.fy < 0 || b.load.fy > 0
            || b.load.torque < 0 || b.load.torque > 0));
    CHECK_INT(polygon(&b, &fault, 2.5, clock, 4), KERN_OK);
    CHECK_NEAR(b.area, -4, GEO);
    CHECK_NEAR(b.mass, 10, GEO);
    CHECK_NEAR(b.centre.x, 3, GEO);
    CHECK_NEAR(b.centre.y, 4, GEO);
    CHECK_INT(polygon(&b, &fault, 0, triangle, 3), KERN_OK);
    CHECK_NEAR(b.area, 4.5, GEO);
    CHECK_NEAR(b.centre.x, 1, GEO);
    CHECK_NEAR(b.centre.y, 1, GEO);
    CHECK(b.fixed);
    CHECK_NEAR(b.mass, 0, 0);
    /* 2 x 1 below 1 x 2: area 4, x (2 * 1 + 2 * .5) / 4, y (2 * .5 + 2 * 2) / 4
     */
    CHECK_INT(polygon(&b, &fault, 1, ell, 6), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
    CHECK_NEAR(b.centre.x, 0.75, GEO);
    CHECK_NEAR(b.centre.y, 1.25, GEO);
    /* vertices on straight edges are welcome */
    CHECK_INT(polygon(&b, &fault, 1, midpoints, 6), KERN_OK);
    CHECK_NEAR(b.area, 4, GEO);
}

/* A centroid far from the origin must not drown in its coordinates. */
static void polygon_far_away(void)
{
    const double far_x = SINGLE ? 1024 : 1048576, far_y = -2 * far_x;
    double xy[6];
    kern_block b;
    kern_fault fault;
    xy[0] = far_x;
    xy[1] = far_y;
    xy[2] = far_x + 3;
    xy[3] = far_y;
    xy[4] = far_x;
    xy[5] = far_y + 3;
    CHECK_INT(polygon(&b, &fault, 1, xy, 3), KERN_OK);
    CHECK_NEAR(b.area, 4.5, 64 * EPS);
    CHECK_NEAR(b.centre.x, far_x + 1, 4 * EPS * far_x);
    CHECK_NEAR(b.centre.y, far_y + 1, 4 * EPS * far_x);
}

/* Corners that a polygon may not have. */
static void polygon_shapes(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1};
    static const double flat[] = {0, 0, 1, 0, 2, 0};
    static const double point[] = {1, 1, 1, 1, 1, 1};
    static const double pinched[] = {0, 0, 2, 0, 1, 1, 2, 2, 0, 2, 1, 1};
    static const double on_edge[] = {0, 0, 4, 0, 4, 2, 2, 0, 0, 2};
    static const double spike[] = {0, 0, 2, 0, 2, 2, 2, 3, 2, 2, 0, 2};
    static const double star[] = {0,   1,   .59, -.81, -.95,
                                  .31, .95, .31, -.59, -.81};
    double needle[] = {0, 0, 2, 0, 1, 1, 1, 2, 1, 1, 0.5, 1, 0, 1};
    kern_block b;
    kern_fault fault;
    int i;
    CHECK_INT(polygon(&b, &fault, 1, square, 2), KERN_FEW_VERTICES);
    CHECK_INT(polygon(&b, &fault, 1, square, 0), KERN_FEW_VERTICES);
    i = polygon(&b, &fault, 1, square, -5);
    CHECK(i == KERN_FEW_VERTICES || i == KERN_BAD_COUNT);
    CHECK_INT(polygon(&b, &fault, 1, bow, 4), KERN_CROSSING);
    CHECK(fault.index >= 0 && fault.index < 4);
    CHECK_INT(polygon(&b, &fault, 1, star, 5), KERN_CROSSING);
    i = polygon(&b, &fault, 1, flat, 3);
    CHECK(i == KERN_NO_AREA || i == KERN_CROSSING);
    i = polygon(&b, &fault, 1, point, 3);
    CHECK(i == KERN_NO_AREA || i == KERN_FEW_VERTICES);
    CHECK_INT(polygon(&b, &fault, 1, pinched, 6), KERN_CROSSING);
    CHECK(fault.index >= 0 && fault.index < 6);
    CHECK_INT(polygon(&b, &fault, 1, on_edge, 5), KERN_CROSSING);
    CHECK_INT(polygon(&b, &fault, 1, spike, 6), KERN_CROSSING);
    for (i = 0; i < 2 && !SINGLE; i++) { /* a needle of 0.7e-6 rad is a spike */
        needle[4] = 1 + (i ? 1.4e-6 : 0.7e-6);
        CHECK_INT(polygon(&b, &fault, 1, needle, 7),
                  i ? KERN_OK : KERN_CROSSING);
        CHECK_INT(fault.index, i ? -1 : 3);
    }
}

/* Masses and coordinates that are no numbers, or none to reckon with. */
static void polygon_numbers(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    double xy[8];
    kern_block b;
    kern_fault fault;
    int i, j;
    CHECK_INT(polygon(&b, &fault, -1, square, 4), KERN_BAD_MASS);
    i = polygon(&b, &fault, not_a_number(), square, 4);
    CHECK(i == KERN_BAD_MASS || i == KERN_BAD_NUMBER);
    i = polygon(&b, &fault, huge_value(), square, 4);
    CHECK(i == KERN_BAD_MASS || i == KERN_BAD_NUMBER);
    for (i = 0; i < 8; i++)
        for (j = 0; j < 3; j++) {
            memcpy(xy, square, sizeof xy);
            xy[i] = no_number(j);
            CHECK_INT(polygon(&b, &fault, 1, xy, 4), KERN_BAD_NUMBER);
            CHECK_INT(fault.index, i / 2);
        }
    memcpy(xy, square, sizeof xy);
    xy[5] = SINGLE ? 2e10 : 2e100;
    CHECK_INT(polygon(&b, &fault, 1, xy, 4), KERN_BAD_NUMBER);
    CHECK_INT(fault.index, 2);
}

static void polygon_faults(void)
{
    kern_block b;
    kern_fault fault;
    kern_vec v[3];
    polygon_shapes();
    polygon_numbers();
    v[0] = vec(0, 0);
    v[1] = vec(1, 0);
    v[2] = vec(0, 1);
    CHECK_INT(kern_block_init(&b, v, 1000001, R(1), &fault), KERN_BAD_COUNT);
    CHECK_INT(kern_block_init(NULL, v, 3, R(1), &fault), KERN_BAD_POINTER);
    CHECK_INT(kern_block_init(&b, NULL, 3, R(1), &fault), KERN_BAD_POINTER);
    CHECK_INT(kern_block_init(&b, v, 3, R(1), NULL), KERN_OK);
    CHECK_INT(kern_block_init(&b, v, 2, R(1), NULL), KERN_FEW_VERTICES);
}

static void polygon_load(void)
{
    static const double square[] = {2, 3, 4, 3, 4, 5, 2, 5};
    kern_block b;
    kern_fault fault;
    polygon(&b, &fault, 1, square, 4);
    /* centre (3, 4): (2, -1) at (5, 5) turns by 2 * -1 - 1 * 2 = -4 */
    kern_block_load(&b, vec(2, -1), vec(5, 5), R(1.5));
    CHECK_NEAR(b.load.fx, 2, 0);
    CHECK_NEAR(b.load.fy, -1, 0);
    CHECK_NEAR(b.load.torque, -2.5, GEO);
    kern_block_load(&b, vec(1, 1), vec(3, 4), R(0));
    CHECK_NEAR(b.load.fx, 3, 0);
    CHECK_NEAR(b.load.fy, 0, 0);
    CHECK_NEAR(b.load.torque, -2.5, GEO);
}

static kern_vec many_vertices[100000];

/* A circle of n vertices on the ground; in float, rounding may bend it in and
   out. */
static void circle_on_ground(int n)
{
    static kern_contact contact[4000]; /* room for what is merged later */
    kern_vec *v = many_vertices;
    kern_block b[2];
    kern_vec ground[4] = {{-9, -2}, {9, -2}, {9, -1}, {-9, -1}};
    kern_fault fault;
    kern_options options = kern_defaults();
    int i, got, index[4];
    kern_work work = kern_work_of(NULL, 0, index, 4);
    for (i = 0; i < n; i++)
        v[i] = vec(cos(2 * pi * i / n), sin(2 * pi * i / n));
    got = kern_block_init(&b[1], v, n, R(1), &fault);
    CHECK(got == KERN_OK || (SINGLE && got == KERN_CROSSING));
    if (SINGLE)
        return;
    CHECK_NEAR(b[1].area, pi, 1e-6);
    CHECK_NEAR(b[1].centre.x, 0, 1e-9);
    CHECK_INT(kern_ground_init(&b[0], ground, 4, &fault), KERN_OK);
    got = kern_contacts(b, 2, &options, contact, 4000, &work);
    CHECK(got >= 1 && got <= 64);
    for (i = 0; i < got; i++) { /* all of them at the foot, upward */
        CHECK(fabs((double)contact[i].p.x) < 0.1);
        CHECK(fabs((double)contact[i].n.y) > 0.99);
    }
}

static void polygon_of_many_vertices(void)
{
    const int n = SINGLE ? 10000 : 100000;
    kern_vec *v = many_vertices;
    kern_block b;
    kern_fault fault;
    CHECK(grows_less(circle_on_ground, n / 4, 8));
    if (SINGLE)
        return;
    /* a far pair of vertices exchanged is found */
    v[777] = vec(cos(2 * pi * 50777 / n) * 0.5, sin(2 * pi * 50777 / n) * 0.5);
    v[778] = vec(2, 0);
    CHECK_INT(kern_block_init(&b, v, n, R(1), &fault), KERN_CROSSING);
}

/* The depth of the vertices of stars, whichever edge is guessed to be nearest:
   the distance to an edge may be rounded to less than that to the box of its
   part. */
static void polygon_depth_of_vertices(void)
{
    enum { CORNERS = 60 };
    uint64_t seed = 7;
    int trial, i, guess;
    for (trial = 0; trial < 200; trial++) {
        const double from = random_share(random_bits(&seed));
        kern_vec v[CORNERS];
        kern_block b;
        kern_outline parts;
        for (i = 0; i < CORNERS; i++) {
            const double r = i % 2 ? 0.6 : 1, a = 2 * pi * i / CORNERS + from;
            v[i] = vec(r * cos(a), r * sin(a));
        }
        CHECK_INT(kern_block_init(&b, v, CORNERS, R(1), NULL), KERN_OK);
        kern_outline_set(&parts, &b);
        for (i = 0; i < CORNERS; i++)
            for (guess = -1; guess < 2; guess++) {
                int nearest = (i + guess + CORNERS) % CORNERS;
                kern_vec p = v[i];
                p.y += R(1e-7 * (random_share(random_bits(&seed)) - 0.5));
                CHECK_NEAR(kern_polygon_depth(&parts, p, &nearest), 0, 1e-5);
            }
    }
}

/* ==== Contacts ================================================== >>contact */

/* Is there a contact point between a and b at (x, y) with the normal (nx, ny)
   from a into b? Also where it was reported from b into a. */
static int contact_at(const world *w, int a, int b, double x, double y,
                      double nx, double ny, double tol)
{
    int k;
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const double sign = c->a == a && c->b == b ? 1
                          : c->a == b && c->b == a ? -1
                                                   : 0;
        if (fabs(sign) > 0 && fabs((double)c->p.x - x) <= tol
            && fabs((double)c->p.y - y) <= tol
            && fabs(sign * (double)c->n.x - nx) <= tol
            && fabs(sign * (double)c->n.y - ny) <= tol)
            return 1;
    }
    return 0;
}

static int lines_of(const world *w)
{
    int k, n = 0;
    for (k = 0; k < w->contacts; k++)
        n += w->contact[k].line ? 1 : 0;
    return n / 2;
}

/* What holds of every set of contacts: unit normals, ends in pairs with the
   same normal and opposite travels, travels as defined. */
static void check_contacts(const world *w)
{
    static wide travel[MAX_POINTS];
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        CHECK(c->a >= 0 && c->a < w->blocks && c->b >= 0 && c->b < w->blocks
              && c->a != c->b);
        CHECK(!(w->block[c->a].fixed && w->block[c->b].fixed));
        CHECK_NEAR(hypot((double)c->n.x, (double)c->n.y), 1, 8 * EPS);
        CHECK_NEAR(c->travel, travel[k],
                   64 * EPS
                       * (1 + fabs((double)c->p.x) + fabs((double)c->p.y)));
        if (c->line && k + 1 < w->contacts && w->contact[k + 1].line
            && c->travel > 0 && w->contact[k + 1].travel < 0) {
            const kern_contact *e = c + 1;
            CHECK(c->a == e->a && c->b == e->b);
            CHECK_NEAR(c->n.x, e->n.x, 0);
            CHECK_NEAR(c->n.y, e->n.y, 0);
            CHECK_NEAR(c->mu, e->mu, 0);
            k++;
        }
    }
}

/* Contact points at both ends of a level bed between blocks 0 and 1. */
static void bed_at(const world *w, double x0, double x1, double y)
{
    CHECK(contact_at(w, 0, 1, x0, y, 0, 1, GEO));
    CHECK(contact_at(w, 0, 1, x1, y, 0, 1, GEO));
}

/* The unit cube and one with its lower left corner at (x, y): their contact is
   the line from `from` to (1, 1). */
static void cubes_touch(world *w, double x, double y, kern_vec from, kern_vec n)
{
    world_reset(w);
    world_box(w, 0, 0, 0, 1, 1);
    world_box(w, 1, x, y, x + 1, y + 1);
    CHECK_INT(world_touch(w), 2);
    CHECK(contact_at(w, 0, 1, from.x, from.y, n.x, n.y, GEO));
    CHECK(contact_at(w, 0, 1, 1, 1, n.x, n.y, GEO));
    CHECK_INT(lines_of(w), 1);
    check_contacts(w);
}

static void contact_cube_on_cube(void)
{
    static world w;
    kern_vec p;
    int k;
    cubes_touch(&w, 0, 1, vec(0, 1), vec(0, 1));
    for (k = 0; k < 2; k++) {
        const kern_contact *c = &w.contact[k];
        const double out = c->p.x < R(0.5) ? -1 : 1;
        CHECK_NEAR(c->mu, R(0.4), 0);
        CHECK_NEAR(fabs((double)c->travel), 0.5, GEO);
        p = kern_contact_at(c, R(0.2), 0);
        CHECK_NEAR(p.x, 0.5 + out * 0.3, GEO);
        CHECK_NEAR(p.y, 1, GEO);
        p = kern_contact_at(c, R(7), 0); /* closed */
        CHECK_NEAR(p.x, 0.5, GEO);
        p = kern_contact_at(c, R(-0.3), 0); /* grown */
        CHECK_NEAR(p.x, 0.5 + out * 0.8, GEO);
        p = kern_contact_at(c, R(0.2), 1); /* a share of 1/2 */
        CHECK_NEAR(p.x, 0.5 + out * 0.4, GEO);
        p = kern_contact_at(c, R(-3), 1);
        CHECK_NEAR(p.x, 0.5 + out * 2, GEO);
    }
    cubes_touch(&w, 0.3, 1, vec(0.3, 1), vec(0, 1));
    cubes_touch(&w, 1, 0.25, vec(1, 0.25), vec(1, 0)); /* a head joint */
    /* friction of contacts found is the options' */
    w.options.mu = R(0.7);
    CHECK_INT(world_touch(&w), 2);
    CHECK_NEAR(w.contact[0].mu, R(0.7), 0);
}

static void contact_two_feet(void)
{
    static const double bridge[] = {0, 0, 1, 0, 1, 1, 2, 1,
                                    2, 0, 3, 0, 3, 2, 0, 2};
    static world w;
    world_reset(&w);
    world_box(&w, 0, -5, -1, 5, 0);
    world_polygon(&w, 1, bridge, 8);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 1);
    bed_at(&w, 0, 3, 0);
    check_contacts(&w);
    /* feet at two heights of one stepped bed are two faces */
    {
        static const double bed[] = {-5,  -2, 5,   -2,  5,  0,
                                     1.5, 0,  1.5, 0.5, -5, 0.5};
        static const double step[] = {0, 0.5, 1, 0.5, 1, 1, 2, 1,
                                      2, 0,   3, 0,   3, 2, 0, 2};
        world_reset(&w);
        world_polygon(&w, 0, bed, 6);
        world_polygon(&w, 1, step, 8);
        CHECK_INT(world_touch(&w), 4);
        CHECK_INT(lines_of(&w), 2);
        bed_at(&w, 0, 1, 0.5);
        bed_at(&w, 2, 3, 0);
        check_contacts(&w);
    }
}

static void contact_concave(void)
{
    static const double cup[] = {-1, -1, 2, -1, 2, 1, 1,  1,
                                 1,  0,  0, 0,  0, 1, -1, 1};
    static const double ell[] = {-1, -1, 3, -1, 3, 0, 0, 0, 0, 3, -1, 3};
    static const double wedge[] = {0, 0, 2, 1, 1, 2};
    static const double tee[] = {0.5, 0, 1.5,  0, 1.5,  1, 2.5, 1,
                                 2.5, 2, -0.5, 2, -0.5, 1, 0.5, 1};
    static world w;
    /* a cube that fills a cup: bottom and both sides, no points in corners */
    world_reset(&w);
    world_polygon(&w, 0, cup, 8);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(&w), 6);
    CHECK_INT(lines_of(&w), 3);
    bed_at(&w, 0, 1, 0);
    CHECK(contact_at(&w, 0, 1, 0, 0, 1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 0, 1, 1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 1, 0, -1, 0, GEO));
    CHECK(contact_at(&w, 0, 1, 1, 1, -1, 0, GEO));
    check_contacts(&w);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    /* a wedge whose corner sits in the corner of an L: two points there */
    world_reset(&w);
    world_polygon(&w, 0, ell, 6);
    world_polygon(&w, 1, wedge, 3);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 0);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    CHECK(contact_at(&w, 0, 1, 0, 0, 1, 0, GEO));
    check_contacts(&w);
    /* a T hung over two posts: under both arms */
    world_reset(&w);
    world_box(&w, 0, -1, -1, 0.4, 1);
    world_box(&w, 0, 1.6, -1, 3, 1);
    world_polygon(&w, 1, tee, 8);
    CHECK_INT(world_touch(&w), 4);
    CHECK(contact_at(&w, 0, 2, -0.5, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 0, 2, 0.4, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 1, 2, 1.6, 1, 0, 1, GEO));
    CHECK(contact_at(&w, 1, 2, 2.5, 1, 0, 1, GEO));
}

static void contact_points(void)
{
    static const double diamond[] = {0, 0, 1, 1, 0, 2, -1, 1};
    static const double roof[] = {-2, -2, 2, -2, 0, 0};
    static world w;
    /* a vertex on an edge: the normal is the edge's */
    world_reset(&w);
    world_box(&w, 0, -2, -1, 2, 0);
    world_polygon(&w, 1, diamond, 4);
    CHECK_INT(world_touch(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    CHECK(!w.contact[0].line);
    CHECK_NEAR(w.contact[0].travel, 0, 0);
    /* an edge on a vertex */
    world_reset(&w);
    world_polygon(&w, 0, roof, 3);
    world_box(&w, 1, -1, 0, 1.5, 1);
    CHECK_INT(world_touch(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    /* corner on corner carries nothing, also between diagonal neighbours */
    world_reset(&w);
    world_polygon(&w, 0, roof, 3);
    world_polygon(&w, 1, diamond, 4);
    CHECK_INT(world_touch(&w), 0);
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 1, 2, 2);
    CHECK_INT(world_touch(&w), 0);
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    world_box(&w, 1, 0, 1, 1, 2);
    world_box(&w, 1, 1, 1, 2, 2);
    CHECK_INT(world_touch(&w), 8);
    CHECK_INT(lines_of(&w), 4);
    /* diagonal neighbours with a rounding between them: still nothing */
    {
        const double r = 16 * EPS;
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 - r, 1, 2, 2);
        CHECK_INT(world_touch(&w), 0);
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 - r, 1 - r, 2, 2);
        CHECK_INT(world_touch(&w), 0);
        world_reset(&w);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 1, 1 + r, 1 - r, 2, 2);
        CHECK_INT(world_touch(&w), 0);
    }
    /* two ground blocks may overlap and have no contacts */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 1);
    world_box(&w, 0, 0.5, 0, 2, 1);
    world_box(&w, 1, 5, 5, 6, 6);
    CHECK_INT(world_touch(&w), 0);
}

static void contact_merged_faces(void)
{
    static const double kinked[] = {-2, -1, 4, -1, 4, 0, 1, 1e-4, -2, 0};
    static world w;
    int k;
    /* a bed with a vertex in it */
    world_reset(&w);
    world_polygon(&w, 0, kinked, 5);
    world_box(&w, 1, 0.25, 1e-4, 1.75, 1);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(lines_of(&w), 1);
    for (k = 0; k < 2; k++) {
        CHECK_NEAR(fabs((double)w.contact[k].p.x - 1), 0.75, 1e-4);
        CHECK_NEAR(w.contact[k].p.y, 1e-4, 1e-4);
    }
    check_contacts(&w);
    /* collinear vertices change nothing */
    {
        static const double bed[] = {-2, -1, 4, -1,  4, 0,  1.1,
                                     0,  1,  0, 0.5, 0, -2, 0};
        world_reset(&w);
        world_polygon(&w, 0, bed, 7);
        world_box(&w, 1, 0.25, 0, 1.75, 1);
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0.25, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 1.75, 0, 0, 1, GEO));
    }
    /* two blocks of the bed are two interfaces */
    world_reset(&w);
    world_box(&w, 0, 0, -1, 1, 0);
    world_box(&w, 0, 1, -1, 2, 0);
    world_box(&w, 1, 0.25, 0, 1.75, 1);
    CHECK_INT(world_touch(&w), 4);
    CHECK_INT(lines_of(&w), 2);
    check_contacts(&w);
}

/* A cube set on the floor at one corner and turned up by `angle`. */
static int turned_cube(world *w, double angle)
{
    const double c = cos(angle), s = sin(angle);
    double xy[8];
    xy[0] = 0;
    xy[1] = 0;
    xy[2] = c;
    xy[3] = s;
    xy[4] = c - s;
    xy[5] = s + c;
    xy[6] = -s;
    xy[7] = c;
    world_reset(w);
    world_box(w, 0, -5, -1, 5, 0);
    world_polygon(w, 1, xy, 4);
    return world_touch(w);
}

static void contact_angle(void)
{
    static world w;
    const double one = (double)kern_defaults().angle,
                 off = SINGLE ? 1e-5 : 1e-7;
    const double gap = 1e-3, half = (one - off) / 2,
                 way = gap / (2 * tan(half));
    CHECK_NEAR(one, 0.0174533, 1e-7);
    CHECK_NEAR(kern_defaults().mu, R(0.4), 0);
    /* just within the angle: the part where they are within the gap */
    CHECK_INT(turned_cube(&w, one - off), 2);
    CHECK_INT(lines_of(&w), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, -sin(half), cos(half), 1e3 * GEO));
    CHECK(contact_at(&w, 0, 1, way * cos(half), way * sin(half), -sin(half),
                     cos(half), SINGLE ? 1e-4 : 1e-9));
    /* just beyond: a corner */
    CHECK_INT(turned_cube(&w, one + off), 1);
    CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
}

/* A box of a width and height, lower left corner at (x, y), on wide ground. */
static int box_on_ground(world *w, double x, double y, double width,
                         double height)
{
    world_reset(w);
    world_box(w, 0, -5, -1, 5, 0);
    world_box(w, 1, x, y, x + width, y + height);
    return world_touch(w);
}

/* The rules of contacts (>>rules in kern.h), each where it alone decides: a
   stone on ground, how many contact points there are, and where some are, with
   the x of their normals, which point up. */
static const struct rule {
    int tiny;                     /* too small for float                     */
    double gap;                   /* 0: 1e-3 of the stone's size             */
    double ground[24], stone[20]; /* vertices, until the first 99            */
    int points, lines;
    double at[4][3]; /* x, y, n.x, until the first 99           */
} contact_rule[] = {
    /* a point is the vertex, not midway to the edge */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0.01, 1, 1, -1, 1, 99},
     1,
     0,
     {{0, 0.01, 0}, {99}}},
    /* what is longer than the gap is a line, however short beside the stone */
    {0,
     1e-4,
     {-1, -1, 2e-4, -1, 2e-4, 0, -1, 0, 99},
     {0, 0, 1, 0, 1, 1, 0, 1, 99},
     2,
     1,
     {{0, 0, 0}, {2e-4, 0, 0}, {99}}},
    /* a tip beside a stone, within the gap of its bed, has another normal */
    {0,
     0.01,
     {-1, -1, 2, -1, 2, 0, -0.03, 0, 0, 0.005, -0.03, 0.03, -1, 0.03, 99},
     {0, 0, 1, 0, 1, 1, 0, 1, 99},
     3,
     1,
     {{0, 0, 0}, {1, 0, 0}, {0, 0.005, 1}, {99}}},
    /* a tip on a shelf below another has the normal of the line on that one */
    {0,
     0,
     {-1, -1, 1, -1, 1, 0, 0, 0, 0, 0.7, 1, 0.7, 1, 1, -1, 1, 99},
     {0.5, 0, 1.5, 0.2, 1.5, 1.3, 0, 1.3, 0, 1, 1.2, 1, 1.2, 0.5, 0.2, 0.3, 99},
     3,
     1,
     {{0, 1, 0}, {1, 1, 0}, {0.5, 0, 0}, {99}}},
    /* of two on one line, one bears the stone and one holds it down */
    {0,
     0,
     {-2,  -1, 0, -1, 0, 0, -1.2, 0,  -1.2, 0.8, 1,
      0.8, 1,  0, 2,  0, 2, 1.2,  -2, 1.2,  99},
     {-1, 0, 0.2, 0, 0.2, -0.3, 2, -0.3, 2, 0, 0.6, 0, 0.6, 0.3, -1, 0.3, 99},
     4,
     2,
     {{-1, 0, 0}, {0, 0, 0}, {99}}},
    /* a bed that bends by more than the angle is two, also within the gap */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, 0, 0, -1, 0.05, 99},
     {-0.3, 0.015, 0, 0, 0.7, 0, 0.7, 1, -0.3, 1, 99},
     4,
     2,
     {{0, 0, 0}, {0.7, 0, 0}, {99}}},
    /* so is one within the angle whose end is off the line of the other */
    {0,
     0,
     {-2, -1, 1.5, -1, 1.5, 0.0025, 0.5, -0.0025, 0.5, -0.5, 0, -0.5, 0, 0, -2,
      0, 99},
     {-2, 0, 0, 0, 0.5, -0.0025, 1.5, 0.0025, 1.5, 0.5, -2, 0.5, 99},
     4,
     2,
     {{-2, 0, 0}, {0, 0, 0}, {99}}},
    /* normals count by length: tilts of 0.0005 over 1 and -0.001 over 0.5 */
    {0,
     0.01,
     {-2, -1, 2, -1, 2, 0, -2, 0, 99},
     {-1, 0.001, 0, 0, 0.5, 0.001, 0.5, 1, -1, 1, 99},
     2,
     1,
     {{-1, 0.0005, 0}, {0.5, 0.0005, 0}, {99}}},
    /* points count alike: on slopes of 0.004 and -0.002 */
    {0,
     0.01,
     {-1, -1, 1, -1, 1, -0.002, 0, 0, -1, -0.004, 99},
     {-0.5, -0.002, 0, 0.5, 0.5, -0.001, 1, 1, -1, 1, 99},
     2,
     1,
     {{-0.5, -0.002, -0.001}, {0.5, -0.001, -0.001}, {99}}},
    /* a line of an outline with a step is midway between the chords */
    {0,
     0.02,
     {-1, -1, 1, -1, 1, 0, 0.1, 0, 0.1, -0.01, -0.1, -0.01, -0.1, 0, -1, 0, 99},
     {-0.5, 0.008, 0.5, 0.008, 0.5, 1, -0.5, 1, 99},
     2,
     1,
     {{-0.5, 0.004, 0}, {0.5, 0.004, 0}, {99}}},
    /* a tooth below the gap is none, also where the outline begins with it */
    {0,
     0.05,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 0.02, 0.04, 1, 0.04, 1, 1, -1, 1, -1, 0.04, -0.02, 0.04, 99},
     2,
     1,
     {{-1, 0.02, 0}, {1, 0.02, 0}, {99}}},
    /* what is farther from its chord than a tenth of a stone is no step,
       whatever the gap: both beds bear, 0.105 above and below their mean */
    {0,
     0.3,
     {-1, -1, 1, -1, 1, -0.21, 0, -0.21, 0, 0, -1, 0, 99},
     {-1, 0, 1, 0, 1, 0.5, -1, 0.5, 99},
     2,
     1,
     {{-1, -0.0525, 0}, {1, -0.0525, 0}, {99}}},
    {0,
     0.3,
     {-1, -1, 1, -1, 1, -0.19, 0, -0.19, 0, 0, -1, 0, 99},
     {-1, 0, 1, 0, 1, 0.5, -1, 0.5, 99},
     4,
     2,
     {{-1, 0, 0}, {0, 0, 0}, {99}}},
    /* the tread of a step in a side bears nothing: it is no part of the side */
    {0,
     0.02,
     {-1, -1, 1.015, -1, 1.015, -0.01, 1, -0.01, 1, 0, -1, 0, 99},
     {1.008, -0.01, 2, -0.01, 2, 1, 1.2, 1, 99},
     1,
     0,
     {{99}}},
    /* a point beside a line within 10 degrees (here 9.5, then 10.5) is none */
    {0,
     0,
     {-1, -1, 1, -1, 1, 0.16734, 0, 0, -1, 0, 99},
     {-0.5, 0, 0, 0, 1, 0.5, 1, 2, -0.5, 2, 99},
     2,
     1,
     {{99}}},
    {0,
     0,
     {-1, -1, 1, -1, 1, 0.18534, 0, 0, -1, 0, 99},
     {-0.5, 0, 0, 0, 1, 0.5, 1, 2, -0.5, 2, 99},
     3,
     1,
     {{99}}},
    /* 1e-6 of the size: a foot so close to the end is none, */
    {1,
     0,
     {-1, -1, 0, -1, 0, 0, -1, 0, 99},
     {-0.7e-6, 0, 1, 1, -1, 1, 99},
     0,
     0,
     {{99}}},
    {1,
     0,
     {-1, -1, 0, -1, 0, 0, -1, 0, 99},
     {-1.4e-6, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{-1.4e-6, 0, 0}, {99}}},
    /* a face so short is a point, */
    {1,
     0,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 0.7e-6, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{0.35e-6, 0, 0}, {99}}},
    {1,
     0,
     {-1, -1, 1, -1, 1, 0, -1, 0, 99},
     {0, 0, 1.4e-6, 0, 1, 1, -1, 1, 99},
     2,
     1,
     {{0, 0, 0}, {1.4e-6, 0, 0}, {99}}},
    /* and a vertex that turns by less is no corner, which bears nothing */
    {1,
     0,
     {-1, -1, 1, -1, 1, -0.35e-6, 0, 0, -1, -0.35e-6, 99},
     {0, 0, 1, 1, -1, 1, 99},
     1,
     0,
     {{0, 0, 0}, {99}}},
    {1,
     0,
     {-1, -1, 1, -1, 1, -0.7e-6, 0, 0, -1, -0.7e-6, 99},
     {0, 0, 1, 1, -1, 1, 99},
     0,
     0,
     {{99}}},
};

static int rule_polygon(world *w, double density, const double *xy)
{
    int n = 0;
    while (xy[2 * n] < 99)
        n++;
    return world_polygon(w, density, xy, n);
}

static void contact_rules(void)
{
    static world w;
    size_t i;
    int k;
    for (i = 0; i < sizeof contact_rule / sizeof contact_rule[0]; i++) {
        const struct rule *r = &contact_rule[i];
        if (SINGLE && r->tiny)
            continue;
        sprintf(context, "(rule %d)", (int)i);
        world_reset(&w);
        w.options.gap = R(r->gap);
        rule_polygon(&w, 0, r->ground);
        rule_polygon(&w, 1, r->stone);
        CHECK_INT(world_touch(&w), r->points);
        CHECK_INT(lines_of(&w), r->lines);
        for (k = 0; k < 4 && r->at[k][0] < 99; k++)
            CHECK(contact_at(&w, 0, 1, r->at[k][0], r->at[k][1], r->at[k][2],
                             sqrt(1 - r->at[k][2] * r->at[k][2]),
                             r->tiny  ? 1e-9
                             : SINGLE ? 1e-5
                                      : 2e-6));
        check_contacts(&w);
    }
    context[0] = 0;
}

/* No gap is less than 64 roundings of the largest coordinate. */
static void contact_floor(void)
{
    static world w;
    const double least = 64 * EPS * 5; /* the ground ends at 5 */
    CHECK_INT(box_on_ground(&w, 0, 0.7 * least, 1, 1), 2);
    w.options.gap = R(1e-3 * least);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(box_on_ground(&w, 0, 1.4 * least, 1, 1), 2);
    w.options.gap = R(1e-3 * least);
    CHECK_INT(world_touch(&w), 0);
}

/* The gap tolerance is a thousandth of the smaller free block's size, unless
   the user gives one, which holds for all pairs. */
static void contact_gap(void)
{
    static world w;
    const double gap = 1e-3, tiny = SINGLE ? 1e-3 : 1e-6;
    int k;
    for (k = 0; k < 6; k++) {
        const double size = k < 2 ? 1 : k < 4 ? 0.5 : 3;
        const double lift = size * gap * (k % 2 ? 1 + tiny : 1 - tiny);
        CHECK_INT(box_on_ground(&w, 0, lift, size, size), k % 2 ? 0 : 2);
        if (k % 2 == 0)
            CHECK(contact_at(&w, 0, 1, size, lift / 2, 0, 1, 4 * GEO));
    }
    w.options.gap = R(0.1);
    CHECK_INT(world_touch(&w), 2);
    box_on_ground(&w, 0, 0.09, 10, 4.91);
    w.options.gap = R(0.1);
    CHECK_INT(world_touch(&w), 2);
    w.options.gap = R(0.08);
    CHECK_INT(world_touch(&w), 0);
    /* penetration within the gap is a contact, deeper an overlap */
    for (k = 0; k < 2; k++) {
        const double sink = gap * (k ? 1.001 : 0.999);
        CHECK_INT(box_on_ground(&w, 0, -sink, 1, 1), k ? KERN_OVERLAP : 2);
        if (!k)
            CHECK(contact_at(&w, 0, 1, 1, -sink / 2, 0, 1, 4 * GEO));
    }
}

/* A seat longer than the gap is a line; on a shorter one the corners stand on
   the edges as points, which lie on one line and so are a face again. */
static void contact_narrow_seat(void)
{
    static world w;
    int k;
    for (k = 0; k < 2; k++) {
        const double on = 1e-3 * (k ? 1.01 : 0.99);
        world_reset(&w);
        world_box(&w, 0, -5, -1, 0, 0);
        world_box(&w, 1, -on, 0, 1 - on, 1);
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, -on, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
    }
}

static const double moon[] = {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1};

/* Two blocks that overlap. A box is its lower left and upper right corner. */
static const struct {
    const char *what;
    int fixed, n, other_n; /* the first one is fixed; numbers of a polygon, 2 is
                              a box */
    double block[16], other[16];
} overlaps[] = {
    {"a corner in the other", 0, 2, 2, {0, 0, 1, 1}, {0.9, 0.9, 2, 2}},
    {"crossing bars: no vertex inside",
     0,
     2,
     2,
     {-2, -0.5, 2, 0.5},
     {-0.5, -2, 0.5, 2}},
    {"one in the other", 0, 2, 2, {-2, -2, 2, 2}, {-0.5, -0.5, 0.5, 0.5}},
    {"the same place twice", 0, 2, 2, {0, 0, 1, 1}, {0, 0, 1, 1}},
    {"sides in common, half over half",
     0,
     2,
     2,
     {0, 0, 1, 1},
     {0.5, 0, 1.5, 1}},
    {"through the reflex part",
     0,
     8,
     2,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {1, 1.25, 4, 1.75}},
    {"from side to side of a jaw, where no vertex is inside",
     0,
     8,
     2,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {0.5, -1, 0.75, 1.5}},
    {"a shape that is not convex, twice, a little turned",
     0,
     8,
     8,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {2e-4, 0, 3, 2e-4, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1}},
    {"a wedge pushed into a mouth, beyond its corners",
     0,
     8,
     3,
     {0, 0, 3, 0, 3, 3, 0, 3, 0, 2, 2, 2, 2, 1, 0, 1},
     {-1, 0.7, -1, 2.3, 1.9, 1.5}},
    {"with a fixed one", 1, 2, 2, {0, 0, 1, 1}, {0.2, 0.5, 0.8, 3}},
    {"a blade thinner than the gap, in the side of a box: only its own outline"
     " is deep",
     0,
     2,
     7,
     {-4, 0, -1, 1},
     {0, 0, 1, 0, 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5}},
    {"the other way round",
     0,
     7,
     2,
     {0, 0, 1, 0, 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5},
     {-4, 0, -1, 1}},
};

static void world_shape(world *w, double density, const double *xy, int n)
{
    if (n == 2)
        world_box(w, density, xy[0], xy[1], xy[2], xy[3]);
    else
        world_polygon(w, density, xy, n);
}

/* Blocks 1 and 2 of three overlap; block 0 is a bystander. */
static void check_overlap(const world *w)
{
    static kern_contact out[MAX_POINTS];
    int index[6];
    kern_work work = kern_work_of(NULL, 0, index, 6);
    memset(&work.fault, 0, sizeof work.fault);
    CHECK_INT(kern_contacts(w->block, 3, &w->options, out, MAX_POINTS, &work),
              KERN_OVERLAP);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(work.fault.other, 2);
    CHECK(work.fault.value > R(5e-4));
    CHECK_INT(kern_touch(w->block, 2, &w->options, out, MAX_POINTS, &work),
              KERN_OVERLAP);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(work.fault.other, 2);
    CHECK_INT(kern_touch(w->block, 0, &w->options, out, MAX_POINTS, &work), 0);
}

static void contact_overlap(void)
{
    double ring[200];
    static world w;
    int k;
    for (k = 0; k < COUNT_OF(overlaps); k++) {
        sprintf(context, "(%s)", overlaps[k].what);
        world_reset(&w);
        world_box(&w, 0, 90, 0, 91, 1);
        world_shape(&w, overlaps[k].fixed ? 0 : 1, overlaps[k].block,
                    overlaps[k].n);
        world_shape(&w, 1, overlaps[k].other, overlaps[k].other_n);
        check_overlap(&w);
    }
    context[0] = 0;
    for (k = 0; k < 100; k++) { /* round, twice */
        ring[2 * k] = cos(2 * pi * k / 100);
        ring[2 * k + 1] = sin(2 * pi * k / 100);
    }
    world_reset(&w);
    world_box(&w, 0, 90, 0, 91, 1);
    world_polygon(&w, 1, ring, 100);
    world_polygon(&w, 1, ring, 100);
    check_overlap(&w);
}

static void contact_in_a_mouth(void)
{
    static world w;
    /* a block in the mouth of another is no overlap */
    world_reset(&w);
    world_polygon(&w, 0, moon, 8);
    world_box(&w, 1, 0.5, 1, 1.5, 1.9);
    CHECK_INT(world_touch(&w), 2);
    CHECK(contact_at(&w, 0, 1, 0.5, 1, 0, 1, GEO));
    /* nor beside its jaws, however small the gap: time does not depend on it */
    world_reset(&w);
    world_polygon(&w, 0, moon, 8);
    world_box(&w, 1, -0.5, 1.0001, 1.9999, 1.9999);
    w.options.gap = R(SINGLE ? 3e-5 : 1e-13);
    CHECK_INT(world_touch(&w), 0);
    w.vertex[9].y = w.vertex[9].y - R(0.0002); /* a foot in the jaw */
    CHECK_INT(kern_block_init(&w.block[1], w.vertex + 8, 4, R(1), NULL),
              KERN_OK);
    CHECK_INT(world_touch(&w), KERN_OVERLAP);
}

/* A bowl whose thin floor lies in the ground, which is accepted: the reflex vertex
   inside stands on nothing. */
static void contact_of_a_bowl(void)
{
    static const double bowl[] = {-1, -0.1, 1, -0.1, 1, 1, 0, 0, -1, 1};
    static world w;
    world_reset(&w);
    world_box(&w, 0, -2, -1, 2, 0);
    world_polygon(&w, 1, bowl, 5);
    w.options.gap = R(0.01);
    w.options.overlap = R(0.2);
    CHECK_INT(world_touch(&w), 2);
}

/* Contacts given by the user: blocks, normal, two points, friction, the angle
   tolerance (0: the default) and what kern_contact_make() returns. */
static const struct {
    int a, b;
    double v[7], angle;
    int want;
} makes[] = {
    {0, 1, {0, 1, 0, 0, 1, 0, 0.3}, 0, 2},
    {0, 1, {0, 1, 0, 0, 1, 0, 0}, 0, 2}, /* without friction */
    /* the tangent within the angle, and not */
    {0, 1, {0, 1, 0, 0, 1, 0.017, 0.3}, 0, 2},
    {0, 1, {0, 1, 0, 0, 1, 0.018, 0.3}, 0, KERN_BAD_LINE},
    {0, 1, {0, 1, 0, 0, 1, 0.018, 0.3}, 0.02, 2},
    {0, 1, {0, 1, 0, 0, 0, 1, 0.3}, 0, KERN_BAD_LINE},
    {0, 1, {0, 0, 0, 0, 1, 0, 0.3}, 0, KERN_BAD_NORMAL},
    {0, 1, {0, 1, 0, 0, 1, 0, -0.1}, 0, KERN_BAD_FRICTION},
    {2, 2, {0, 1, 0, 0, 1, 0, 0.3}, 0, KERN_SAME_BLOCK},
    {-1, 2, {0, 1, 0, 0, 1, 0, 0.3}, 0, KERN_BAD_BLOCK},
    /* a normal as small or as large as a number can be has a direction */
    {0, 1, {0, SINGLE ? 1e-30 : 1e-300, 0, 0, 1, 0, 0.3}, 0, 2},
    {0, 1, {0, SINGLE ? 1e30 : 1e300, 0, 0, 1, 0, 0.3}, 0, 2},
};

static int make_given(int a, int b, const double *v, double angle,
                      kern_contact *c)
{
    kern_options options = kern_defaults();
    if (angle > 0)
        options.angle = R(angle);
    return contact_make(a, b, vec(v[0], v[1]), vec(v[2], v[3]), vec(v[4], v[5]),
                        R(v[6]), &options, c);
}

static void contact_given(void)
{
    kern_contact c[2];
    int i, j;
    for (i = 0; i < COUNT_OF(makes); i++) {
        sprintf(context, "(contact %d)", i);
        memset(c, 0x55, sizeof c);
        CHECK_INT(
            make_given(makes[i].a, makes[i].b, makes[i].v, makes[i].angle, c),
            makes[i].want);
        if (makes[i].want != 2)
            continue;
        /* the normal is made unit; half the length along t */
        CHECK_NEAR(c[0].n.y, 1, EPS);
        CHECK_NEAR(fabs((double)c[0].travel), 0.5, GEO);
    }
    context[0] = 0;
    for (i = 0; i < 7; i++)
        for (j = 0; j < NO_NUMBERS; j++) {
            double v[7] = {0, 1, 0, 0, 1, 0, 0.3};
            v[i] = no_number(j);
            CHECK_INT(make_given(0, 1, v, 0, c), KERN_BAD_NUMBER);
        }
    CHECK_INT(make_given(0, 1, makes[0].v, 0, NULL), KERN_BAD_POINTER);
}

/* Vertices that were moved, or an array that was used again, without
   kern_block_init(): refused where the polygon is read. */
static void contact_stale(void)
{
    static world w;
    kern_contact out[8];
    int index[6], k;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    stack_of_two(&w, 0);
    CHECK_INT(w.contacts, 4);
    for (k = 0; k < 5; k++) {
        /* moved, smaller, larger, one corner, no number: by box and by area */
        kern_vec *v = w.vertex + 4;
        const kern_vec before = v[2];
        v[2] = k == 0 ? vec(0.5, 0.5)
             : k == 1 ? vec(1, 0.9)
             : k == 2 ? vec(1.1, 1)
             : k == 3 ? vec(1, 1.01)
                      : vec(not_a_number(), 1);
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 1, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work),
                  KERN_STALE);
        CHECK_INT(work.fault.block, 1);
        v[2] = before;
    }
    CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work), 2);
    /* in the same box, 0.7 and 1.4 thousandths of the area less */
    for (k = 0; k < 2; k++) {
        static const double notch[] = {5, 0, 6, 0, 6, 1, 5.5, 1, 5, 1};
        world_polygon(&w, 1, notch, 5);
        w.vertex[w.vertices - 2].y = R(k ? 1 - 2.8e-3 : 1 - 1.4e-3);
        CHECK_INT(kern_touch(w.block, 3, &w.options, out, 8, &work),
                  k ? KERN_STALE : 0);
        w.blocks--;
        w.vertices -= 5;
    }
    /* the mirror image has the same box, and the other sign of area */
    w.vertex[4] = vec(0, 1);
    w.vertex[5] = vec(1, 1);
    w.vertex[6] = vec(1, 0);
    w.vertex[7] = vec(0, 0);
    CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), KERN_STALE);
    /* one array for two stones that do not touch */
    for (k = 0; k < 4; k++)
        w.vertex[4 + k] = vec(k % 3 ? 3 : 2, k / 2);
    CHECK_INT(kern_block_init(&w.block[2], w.vertex + 4, 4, R(1), NULL),
              KERN_OK);
    CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work), KERN_STALE);
    CHECK_INT(work.fault.block, 1);
    CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), KERN_STALE);
    CHECK_INT(work.fault.block, 1);
}

/* What kern_contacts() returned in place of a count is returned again, and the
   fault stays; work memory without arrays is a null pointer. */
static void count_that_is_a_status(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    kern_margin m;
    kern_real out;
    kern_collapse all;
    kern_real value[3];
    int i;
    world_reset(&w);
    world_box(&w, 0, -2, -1, 4, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0, 0.5, 1, 2);
    s = structure_of(&w);
    work = work_for(3, 64);
    s.contacts = kern_contacts(w.block, 3, &w.options, w.contact, MAX_POINTS,
                               &work);
    for (i = 0; i < 2; i++) {
        const int want = i ? KERN_BAD_POINTER : KERN_OVERLAP;
        kern_task *task = task_of(&s, &w.options, &work);
        CHECK_INT(kern_verdict(task, 0, NULL), want);
        CHECK_INT(kern_measure(task, &m, NULL), want);
        CHECK_INT(kern_deficit(task, &out), want);
        CHECK_INT(kern_load_factor(task, 0, KERN_LEFT, &out, NULL), want);
        CHECK_INT(kern_tilt(task, 0, KERN_LEFT, &out, NULL), want);
        CHECK_INT(kern_profile(task, KERN_LEFT, value, &all), want);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(work.fault.other, 2);
        work.real = NULL;
        s.contacts = 0;
    }
    s.contacts = -1; /* no call returns KERN_UNDECIDED for a count */
    work = work_for(3, 64);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_BAD_COUNT);
}

static void contact_given_point_and_line(void)
{
    const double point[7] = {0, 5, 2, 1, 2, 1, 0.3};
    kern_contact c[2];
    kern_vec p;
    int i, j;
    /* a point; the normal is made unit */
    CHECK_INT(make_given(3, 1, point, 0, c), 1);
    CHECK(c[0].a == 3 && c[0].b == 1 && !c[0].line);
    CHECK_NEAR(c[0].n.x, 0, 0);
    CHECK_NEAR(c[0].n.y, 1, EPS);
    CHECK_NEAR(c[0].p.x, 2, 0);
    CHECK_NEAR(c[0].mu, R(0.3), 0);
    CHECK_NEAR(c[0].travel, 0, 0);
    /* a line, in both directions */
    for (i = 0; i < 2; i++) {
        const double line[7] = {0, 1, i ? 3 : 1, 2, i ? 1 : 3, 2, 0.3};
        CHECK_INT(make_given(0, 1, line, 0, c), 2);
        for (j = 0; j < 2; j++) {
            CHECK(c[j].line && c[j].a == 0 && c[j].b == 1);
            CHECK_NEAR(fabs((double)c[j].travel), 1, GEO);
            p = kern_contact_at(&c[j], R(0.25), 0);
            CHECK_NEAR(fabs((double)p.x - 2), 0.75, GEO);
            CHECK_NEAR(p.y, 2, GEO);
        }
        CHECK_NEAR(c[0].p.x + c[1].p.x, 4, 0);
        CHECK_NEAR(fabs((double)(c[0].p.x - c[1].p.x)), 2, 0);
    }
}

static void contact_travels(void)
{
    static world w;
    int k;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_mass(&w, k ? 1 : 0, 0, 0, 1);
    /* three points of one interface: the centre is between the outer two, and
       travels are along each point's own tangent */
    world_point(&w, 0, 1, 0, 1, 0, 0);
    world_point(&w, 0, 1, 3, 4, 1, 0.5);
    world_point(&w, 1, 0, 0, -1, 4, 0); /* the same interface, reversed */
    /* a lone point, and two at one place */
    world_point(&w, 0, 2, 1, 0, 7, 7);
    world_point(&w, 2, 1, 1, 0, 5, 5);
    world_point(&w, 2, 1, 0, 1, 5, 5);
    /* a tie: the first pair by index, (0,0)-(3,4), has the centre (1.5, 2) */
    world_point(&w, 0, 3, 0, 1, 0, 0);
    world_point(&w, 0, 3, 0, 1, 3, 4);
    world_point(&w, 0, 3, 1, 0, 5, 0);
    /* a lone point beside a line of the same interface stays */
    world_point(&w, 1, 3, 0, 1, -1, 0);
    world_line(&w, 1, 3, 0, 1, 0, 0, 2, 0);
    world_touch(&w);
    CHECK_INT(w.contacts, 12);
    CHECK_NEAR(w.contact[0].travel, -2, GEO); /* t = (-1, 0), q = (2, 0) */
    /* n = (.6, .8), t = (-.8, .6), q - p = (1, -.5): -.8 - .3 */
    CHECK_NEAR(w.contact[1].travel, -1.1, GEO);
    CHECK_NEAR(w.contact[2].travel, -2, GEO); /* t = (1, 0) */
    CHECK_NEAR(w.contact[3].travel, 0, 0);
    CHECK_NEAR(w.contact[4].travel, 0, 0);
    CHECK_NEAR(w.contact[5].travel, 0, 0);
    CHECK_NEAR(w.contact[6].travel, -1.5, GEO); /* t = (-1, 0) */
    CHECK_NEAR(w.contact[7].travel, 1.5, GEO);
    CHECK_NEAR(w.contact[8].travel, 2, GEO); /* t = (0, 1) */
    CHECK_NEAR(w.contact[9].travel, 0, 0);
    for (k = 10; k < 12; k++) /* t = (-1, 0), q = (1, 0) */
        CHECK_NEAR(w.contact[k].travel, w.contact[k].p.x - 1, GEO);
    check_contacts(&w);
    {
        const kern_vec p = kern_contact_at(&w.contact[1], R(0.55), 0);
        CHECK_NEAR(p.x, 1 + 0.8 * 0.55, GEO);
        CHECK_NEAR(p.y, 0.5 - 0.6 * 0.55, GEO);
    }
    /* points found from polygons: a bench of two slanted feet on the floor */
    {
        static const double bench[] = {0, 0, 1, 1, 2, 1, 3, 0, 2.6, 2, 0.4, 2};
        world_reset(&w);
        world_box(&w, 0, -9, -1, 9, 0);
        world_polygon(&w, 1, bench, 6);
        /* two single points on one line are one face, hence one line contact */
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0, 0, 0, 1, GEO));
        CHECK(contact_at(&w, 0, 1, 3, 0, 0, 1, GEO));
        check_contacts(&w);
    }
}

/* A beam on the tips of two fixed wedges, 4 apart: each tip is alone with the
   beam. They go to the middle between them where that is asked for, and the
   beam falls when one reaches the centre of mass, 1.5 from the left. */
static void lone_points(void)
{
    static const double wedge[2][6] = {{-1, -1, 1, -1, 0, 0},
                                       {3, -1, 5, -1, 4, 0}};
    static world w;
    kern_margin m;
    int side, relative;
    for (relative = 0; relative < 2; relative++)
        for (side = -1; side <= 1; side++) {
            world_reset(&w);
            world_polygon(&w, 0, wedge[0], 3);
            world_polygon(&w, 0, wedge[1], 3);
            world_box(&w, 1, -0.5, 0, 4.5, 0.5);
            w.block[2].centre = vec(1.5, 0.25);
            w.options.relative = relative;
            w.options.lone = vec(0, side * 1e3);
            CHECK_INT(world_touch(&w), 2);
            CHECK_NEAR(w.contact[0].travel,
                       side < 0 ? w.contact[0].n.y * -2 : 0, GEO);
            CHECK_NEAR(w.contact[1].travel, side < 0 ? w.contact[1].n.y * 2 : 0,
                       GEO);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_INT(m.saturated, side >= 0);
            if (side < 0)
                CHECK_NEAR(m.margin, relative ? 0.75 : 1.5, EXACT);
        }
    /* a tip beside the end of a bed from 0 to 1: their middle is at 2 */
    world_reset(&w);
    world_polygon(&w, 0, wedge[1], 3);
    world_box(&w, 0, 0, -1, 1, 0);
    world_box(&w, 1, 0, 0, 4.5, 0.5);
    w.options.lone = w.gravity;
    CHECK_INT(world_touch(&w), 3);
    CHECK_NEAR(kern_contact_at(&w.contact[0], R(0.25), 0).x, 3.75, GEO);
    CHECK_NEAR(fabs((double)w.contact[0].travel), 2, GEO);
    w.options.lone.x = R(INFINITY);
    CHECK_INT(world_touch(&w), KERN_BAD_NUMBER);
}

static void contact_room(void)
{
    static world w;
    kern_contact two[3];
    int index[8];
    kern_work work = kern_work_of(NULL, 0, index, 8);
    int k;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_box(&w, k, 0, k, 1, k + 1);
    CHECK_INT(world_touch(&w), 6);
    for (k = 0; k < 6; k++)
        CHECK_INT(kern_contacts(w.block, 4, &w.options, w.contact, k, &work),
                  KERN_NO_SPACE);
    CHECK_INT(kern_contacts(w.block, 4, &w.options, w.contact, 6, &work), 6);
    memset(two, 0x55, sizeof two);
    work = kern_work_of(NULL, 0, NULL, 0); /* one block needs none */
    CHECK_INT(kern_touch(w.block, 3, &w.options, two, 1, &work), KERN_NO_SPACE);
    CHECK_INT(kern_touch(w.block, 3, &w.options, two, 2, &work), 2);
    CHECK_INT(two[0].a, 2);
    CHECK_INT(two[0].b, 3);
    CHECK_INT(two[2].a, 0x55555555);
    CHECK_INT(kern_touch(w.block, -1, &w.options, two, 2, &work),
              KERN_BAD_COUNT);
}

/* The search for contacts needs no work memory but its fault, and writes none. */
static void contact_work(void)
{
    static world w;
    kern_contact found[8];
    int index[10], k, size;
    world_reset(&w);
    for (k = 0; k < 4; k++)
        world_box(&w, k, 0, k, 1, k + 1);
    for (size = -1; size <= 9; size++) {
        kern_work work = kern_work_of(NULL, 0, size < 0 ? NULL : index, size);
        for (k = 0; k < 10; k++)
            index[k] = 12345;
        CHECK_INT(kern_contacts(w.block, 4, &w.options, found, 8, &work), 6);
        for (k = 0; k < 10; k++)
            CHECK_INT(index[k], 12345);
        CHECK_INT(work.pivots, 0);
        CHECK_INT(work.fault.block, -1);
    }
    CHECK_INT(kern_contacts(w.block, 4, &w.options, found, 8, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_touch(w.block, 1, &w.options, found, 8, NULL),
              KERN_BAD_POINTER);
}

enum { CUBES = 20000 };
static int cubes_upright;

/* A row of cubes on one piece of ground, in any order: each has a bed and joins
   its neighbours. */
static void row_of_cubes(int cubes)
{
    static kern_block block[CUBES + 1];
    static kern_vec corner[CUBES + 1][4];
    static kern_contact contact[4 * CUBES];
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    kern_options options = kern_defaults();
    int i, k, bad = 0;
    for (k = 0; k <= cubes; k++) {
        /* ground in the middle; 7919 is prime to the number of cubes */
        const int ground = k == cubes / 2;
        const double place = (double)(k * 7919l % (cubes + 1)) / 8;
        const double wide = ground ? cubes / 8 + 2 : 0.125;
        kern_vec *v = corner[k];
        v[0] = vec(ground ? -1 : place, ground ? -1 : 0);
        v[1] = vec((double)v[0].x + wide, (double)v[0].y);
        v[2] = vec((double)v[1].x, ground ? 0 : 0.125);
        v[3] = vec((double)v[0].x, (double)v[2].y);
        for (i = 0; i < 4 && cubes_upright; i++)
            v[i] = vec((double)v[i].y, (double)v[i].x);
        bad += (ground ? kern_ground_init(&block[k], v, 4, NULL)
                       : kern_block_init(&block[k], v, 4, 1, NULL))
            != KERN_OK;
    }
    CHECK_INT(bad, 0);
    /* one place of the row is the ground's, and empty */
    CHECK_INT(
        kern_contacts(block, cubes + 1, &options, contact, 4 * cubes, &work),
        2 * cubes + 2 * (cubes - 2));
}

/* Each two blocks are looked at, which takes some nanoseconds: the most blocks
   that are allowed, about half a second. */
static void contact_many_blocks(void)
{
    for (cubes_upright = 0; cubes_upright < 2; cubes_upright++) {
        const clock_t start = clock();
        row_of_cubes(some(CUBES - 1));
        CHECK(clock() - start < 4 * CLOCKS_PER_SEC);
    }
}

/* ---- the same contacts whichever way the world is turned -------- >>turned */

/* `to` becomes `from` with block i at order[i], mirrored, scaled, turned by
   `angle` with gravity, and moved. Contacts are found anew or moved along. */
typedef struct change {
    double scale, mass, angle, dx, dy;
    int mirror, shuffle;
} change;

static change no_change(void)
{
    change c;
    c.scale = c.mass = 1;
    c.angle = c.dx = c.dy = 0;
    c.mirror = c.shuffle = 0;
    return c;
}

static kern_vec turned(const change *c, kern_vec v)
{
    const double x = c->mirror ? -(double)v.x : (double)v.x, y = (double)v.y;
    return vec(x * cos(c->angle) - y * sin(c->angle),
               x * sin(c->angle) + y * cos(c->angle));
}

static kern_vec moved(const change *c, kern_vec v)
{
    const kern_vec t = turned(c, v);
    return vec((double)t.x * c->scale + c->dx, (double)t.y * c->scale + c->dy);
}

/* A random order of 0 .. n - 1. */
static void shuffle(int *order, int n)
{
    int i;
    for (i = n - 1; i > 0; i--) {
        const int j = random_int(0, i), keep = order[i];
        order[i] = order[j];
        order[j] = keep;
    }
}

static void block_changed(const world *from, const change *c, int i,
                          const world *to, kern_block *t)
{
    const kern_block *b = &from->block[i];
    const int turn = c->mirror ? -1 : 1;
    const kern_vec f = turned(c, vec((double)b->load.fx, (double)b->load.fy));
    *t = *b;
    if (b->vertex) {
        kern_block placed;
        t->vertex = to->vertex + (b->vertex - from->vertex);
        CHECK_INT(kern_block_init(&placed, t->vertex, t->vertices, R(1), NULL),
                  KERN_OK);
        t->box = placed.box;
    }
    t->area = R((double)b->area * c->scale * c->scale * turn);
    t->mass = R((double)b->mass * c->mass);
    t->centre = moved(c, b->centre);
    t->load.fx = R((double)f.x * c->mass);
    t->load.fy = R((double)f.y * c->mass);
    t->load.torque = R((double)b->load.torque * c->mass * c->scale * turn);
}

/* Lines stay together: contacts change places as wholes, some turn round. */
static void contacts_shuffled(world *w)
{
    static kern_contact unit[MAX_POINTS];
    int done = 0, units = 0, first[MAX_POINTS], i, k;
    for (k = 0; k < w->contacts; k += w->contact[k].line ? 2 : 1)
        first[units++] = k;
    shuffle(first, units);
    for (k = 0; k < units; k++) {
        const int two = w->contact[first[k]].line ? 2 : 1, turn = chance(0.5);
        for (i = 0; i < two; i++) {
            unit[done] = w->contact[first[k] + (turn ? two - 1 - i : i)];
            if (turn) { /* from b into a: t turns too */
                const int keep = unit[done].a;
                unit[done].a = unit[done].b;
                unit[done].b = keep;
                unit[done].n = vec(-(double)unit[done].n.x,
                                   -(double)unit[done].n.y);
                unit[done].travel = -unit[done].travel;
            }
            done++;
        }
    }
    memcpy(w->contact, unit, sizeof *unit * (size_t)done);
}

static void world_changed(world *to, const world *from, const change *c,
                          int *order)
{
    int i, k;
    memcpy(to, from, sizeof *to);
    for (i = 0; i < from->blocks; i++)
        order[i] = i;
    if (c->shuffle)
        shuffle(order, from->blocks);
    to->gravity = turned(c, from->gravity);
    for (i = 0; i < from->vertices; i++)
        to->vertex[i] = moved(c, from->vertex[i]);
    for (i = 0; i < from->blocks; i++)
        block_changed(from, c, i, to, &to->block[order[i]]);
    if (from->options.gap > 0)
        to->options.gap = R((double)from->options.gap * c->scale);
    if (!from->options.relative)
        to->options.epsilon = R((double)from->options.epsilon * c->scale);
    if (!from->given) {
        CHECK(world_touch(to) >= 0);
        return;
    }
    for (k = 0; k < from->contacts; k++) {
        kern_contact *t = &to->contact[k];
        t->a = order[t->a];
        t->b = order[t->b];
        t->p = moved(c, t->p);
        t->n = turned(c, t->n);
        t->travel = R((double)t->travel * c->scale * (c->mirror ? -1 : 1));
    }
    if (c->shuffle)
        contacts_shuffled(to);
}

/* Is e the image of contact o under a change? Its normal may point either way.
 */
static int is_image(const change *c, const int *order, const kern_contact *o,
                    const kern_contact *e)
{
    const double tol = SINGLE ? 2e-3 : 1e-10;
    const kern_vec p = moved(c, o->p), n = turned(c, o->n);
    const double sign = e->a == order[o->a] && e->b == order[o->b] ? 1
                      : e->b == order[o->a] && e->a == order[o->b] ? -1
                                                                   : 0;
    return fabs(sign) > 0
        && hypot((double)(e->p.x - p.x), (double)(e->p.y - p.y))
               <= tol * c->scale
        && hypot((double)e->n.x * sign - (double)n.x,
                 (double)e->n.y * sign - (double)n.y)
               <= tol
        && fabs(fabs((double)e->travel) - fabs((double)o->travel) * c->scale)
               <= 2 * tol * c->scale;
}

static void contact_invariance(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, i, k, trial;
    for (seed = 0; seed < 300; seed++) {
        random_world(&w, 7000u + (unsigned long long)seed, 20);
        if (w.given)
            continue;
        check_contacts(&w);
        for (trial = 0; trial < 4; trial++) {
            change c = no_change();
            c.shuffle = trial != 1;
            c.angle = trial == 0 ? 0 : uniform(-pi, pi);
            c.scale = trial < 2 ? 1 : pow(10, uniform(-3, 3));
            c.mirror = trial == 3;
            c.dx = trial ? uniform(-50, 50) * c.scale : 0;
            world_changed(&t, &w, &c, order);
            CHECK_INT(t.contacts, w.contacts);
            CHECK_INT(lines_of(&t), lines_of(&w));
            for (k = 0; k < w.contacts; k++) {
                int found = 0;
                for (i = 0; i < t.contacts; i++)
                    found += is_image(&c, order, &w.contact[k], &t.contact[i]);
                CHECK(found >= 1);
            }
        }
    }
}

/* Does the same contact stand in both places, bit by bit? */
static int same_contact(const kern_contact *c, const kern_contact *d)
{
    return c->a == d->a && c->b == d->b && c->line == d->line
        && memcmp(&c->p, &d->p, sizeof c->p) == 0
        && memcmp(&c->n, &d->n, sizeof c->n) == 0
        && memcmp(&c->mu, &d->mu, sizeof c->mu) == 0
        && memcmp(&c->travel, &d->travel, sizeof c->travel) == 0;
}

/* The contacts of block after block, each with those before it, are those of
   all together, in the same order; and those of one block are its own among
   all, the other blocks ascending. */
static void contact_order(void)
{
    static world w, t;
    static kern_contact one[MAX_POINTS];
    static int order[MAX_BLOCKS];
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    int seed, b, k, got;
    for (seed = 0; seed < 200; seed++) {
        change c = no_change();
        int all = 0;
        random_world(&t, 9000u + (unsigned long long)seed, 25);
        if (t.given)
            continue;
        c.shuffle = 1;
        c.angle = seed % 2 ? uniform(-pi, pi) : 0;
        world_changed(&w, &t, &c, order);
        for (k = 1; k < w.contacts; k++) {
            const kern_contact *d = &w.contact[k - 1], *e = &w.contact[k];
            CHECK(e->a < e->b);
            CHECK(d->b < e->b || (d->b == e->b && d->a <= e->a));
        }
        for (b = 0; b < w.blocks; b++) {
            if (SINGLE) /* the rounding of far blocks counts among all */
                continue;
            got = kern_touch(w.block, b, &w.options, one, MAX_POINTS, &none);
            for (k = 0; k < got; k++, all++)
                CHECK(all < w.contacts
                      && same_contact(&w.contact[all], &one[k]));
        }
        if (!SINGLE)
            CHECK_INT(all, w.contacts);
    }
}

/* ==== Steps ======================================================= >>steps */
/* Outlines from clippers and from images have steps lower than the gap. What
   lies on them has the contacts of outlines without. */

/* A unit box on a bed with friction 0.4 and nothing to push against. */
static void check_slides(world *w)
{
    int side;
    world_touch(w);
    check_contacts(w);
    for (side = -1; side <= 1; side += 2) {
        double value;
        CHECK_INT(load_factor(w, NULL, side, &value), KERN_STANDS);
        CHECK_NEAR(value, 0.4, 2e-3);
        CHECK_INT(tilt(w, side, &value), KERN_STANDS);
        CHECK_NEAR(value, atan(0.4), 2e-3);
    }
}

/* shear/step_1e-12, shear/kerb_1e-9: a step of a rounding was a shear key, with
   load factors of 2.27 and 1. */
static void steps_of_a_rounding(void)
{
    static const double high[] = {1e-12, 1e-9, 1e-6, 1e-4, 9e-4};
    int i;
    for (i = 0; i < 5; i++) {
        const double h = high[i];
        static world w;
        double xy[16] = {0, -1, 1, -1, 1, 0, 0.5, 0, 0.5, 0, 0, 0};
        double on[16] = {0, 0, 0.5, 0, 0.5, 0, 1, 0, 1, 1, 0, 1};
        const double kerb[] = {-2, -1, 3, -1, 3, h, 1, h, 1, 0, -2, 0};
        const double both[] = {-2, -1, 3, -1, 3, h, 1,  h,
                               1,  0,  0, 0,  0, h, -2, h};
        if (SINGLE && h < 1e-6)
            continue;
        sprintf(context, "(step of %g)", h);
        xy[5] = xy[7] = on[5] = on[7] = -h;
        world_reset(&w);
        world_polygon(&w, 0, xy, 6);
        world_polygon(&w, 1, on, 6);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
        world_reset(&w);
        world_polygon(&w, 0, kerb, 6);
        world_box(&w, 1, 0, 0, 1, 1);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
        world_reset(&w);
        world_polygon(&w, 0, both, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        check_slides(&w);
        CHECK_INT(w.contacts, 2);
    }
    context[0] = 0;
}

/* A step as high as the gap and more is one. */
static void steps_that_carry(void)
{
    const double kerb[] = {-2, -1, 3, -1, 3, 2e-3, 1, 2e-3, 1, 0, -2, 0};
    static world w;
    double value;
    world_reset(&w);
    world_polygon(&w, 0, kerb, 6);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK(value > 0.9);
    CHECK_INT(load_factor(&w, NULL, -1, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.4, EXACT * 10);
    w.options.gap = R(2.5e-3); /* whoever calls it a gap has no kerb */
    check_slides(&w);
    /* shear/lip_2e-6: a sliver of support is one */
    world_reset(&w);
    world_box(&w, 0, -2, -1, SINGLE ? 1e-4 : 2e-6, 0);
    world_box(&w, 0, 0.7, -1, 3, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.4, SINGLE ? 1e-3 : 1e-6);
}

/* The joint between two stones of unit width in an image of n pixels across a
   stone: a row of pixels ends where the joint passes its middle. n = 0: the
   joint as it is. */
static void pixel_joint(world *w, int n, double slope)
{
    static double xy[MAX_VERTICES], on[MAX_VERTICES];
    int c, k = 0, i, last;
    world_reset(w);
    if (n == 0) {
        const double a[] = {0, -1, 1, -1, 1, slope, 0, 0};
        const double b[] = {0, 0, 1, slope, 1, 1 + slope, 0, 1 + slope};
        world_polygon(w, 0, a, 4);
        world_polygon(w, 1, b, 4);
        return;
    }
    last = 0;
    on[k++] = 0;
    on[k++] = 0;
    for (c = 0; c < n; c++) {
        const int high = (int)floor(slope * (c + 0.5) + 0.5);
        if (high != last) {
            on[k++] = (double)c / n;
            on[k++] = (double)last / n;
            on[k++] = (double)c / n;
            on[k++] = (double)high / n;
        }
        last = high;
    }
    on[k++] = 1;
    on[k++] = (double)last / n;
    /* clockwise below, counter-clockwise above */
    for (i = 0; i < k; i++)
        xy[i] = on[i];
    xy[i++] = 1;
    xy[i++] = -1;
    xy[i++] = 0;
    xy[i++] = -1;
    world_polygon(w, 0, xy, i / 2);
    on[k++] = 1;
    on[k++] = 1 + slope;
    on[k++] = 0;
    on[k++] = 1 + slope;
    world_polygon(w, 1, on, k / 2);
}

/* Where a pixel is more than the gap of 1/1000, the gap must be told: a pixel
   and a half. */
static void steps_of_pixels(void)
{
    static const int pixels[] = {100, 300, 1000, 2000};
    static const double degrees[] = {1, 5, 10, 20, 30, 44};
    static world w, t;
    int i, j;
    for (j = 0; j < 6; j++)
        for (i = 0; i < 4; i++) {
            const int n = pixels[i];
            const double slope = tan(degrees[j] * pi / 180);
            const double pixel = 1.0 / n;
            kern_margin m, straight;
            double right, want;
            int side;
            if (4 * slope * n > MAX_VERTICES / 2 - 10)
                continue;
            sprintf(context, "(%d pixels, %g degrees)", n, degrees[j]);
            pixel_joint(&t, 0, slope);
            pixel_joint(&w, n, slope);
            w.options.mu = t.options.mu = R(degrees[j] > 15 ? 1.2 : 0.4);
            w.options.gap = R(n < 2000 ? 1.5 * pixel : 0);
            world_touch(&w);
            world_touch(&t);
            CHECK_INT(w.contacts, 2);
            CHECK_INT(measure(&t, &straight), KERN_STANDS);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, straight.margin, pixel);
            CHECK(abs(m.level - straight.level) <= 1);
            for (side = -1; side <= 1; side += 2) {
                load_factor(&t, NULL, side, &want);
                CHECK_INT(load_factor(&w, NULL, side, &right), KERN_STANDS);
                CHECK_NEAR(right, want, 0.05 * want);
            }
        }
    context[0] = 0;
}

/* stairs/gap_1.01px, default_gap_900px: a joint drawn in pixels of up to 1.57
   gaps slides where the straight one does. Its steps held it where the gap was
   below 1.4 pixels. */
static void steps_that_slide(void)
{
    static world w;
    int trial;
    for (trial = 0; trial < some(660); trial++) {
        double angle, mu, gap;
        int n;
        random_seed(61000u + (unsigned long long)trial);
        n = random_int(20, 120);
        angle = uniform(2, 44) * pi / 180;
        mu = uniform(0.1, 1.2);
        gap = trial % 3 == 0 ? uniform(1 / 1.57, 1)
            : trial % 3 == 1 ? 1.001
                             : uniform(1, 3);
        if (fabs(angle - atan(mu)) < 0.03)
            continue;
        sprintf(context, "(%d pixels, %g rad, friction %g, gap of %g pixels)",
                n, angle, mu, gap);
        pixel_joint(&w, n, tan(angle));
        w.options.mu = R(mu);
        w.options.gap = R(gap / n);
        CHECK_INT(world_touch(&w), 2);
        CHECK_INT(verdict(&w, 0), angle < atan(mu) ? KERN_STANDS : KERN_FALLS);
    }
    context[0] = 0;
}

/* A knee lower than the gap is no step: each of its two edges has its contact,
   whichever of the two stones is reflex there. Where the outlines also have a
   step, the chord stands for both edges. */
static void steps_and_knees(void)
{
    static world w;
    int up, k;
    for (k = 0; k < 2; k++)
        for (up = -1; up <= 1; up += 2) {
            const double h = 1e-3 * up, s = 5e-5;
            const double low[] = {0, -1, 1, -1, 1, 0, 0.05, 0, 0, h};
            const double high[] = {0, h, 0.05, 0, 1, 0, 1, 1, 0, 1};
            const double step[] = {0, -1,  1, -1,   1, s, 0.5,
                                   s, 0.5, 0, 0.05, 0, 0, h};
            const double on[] = {0, h, 0.05, 0, 0.5, 0, 0.5,
                                 s, 1, s,    1, 1,   0, 1};
            world_reset(&w);
            world_polygon(&w, 0, k ? step : low, k ? 7 : 5);
            world_polygon(&w, 1, k ? on : high, k ? 7 : 5);
            CHECK_INT(world_touch(&w), k ? 2 : 4);
            check_contacts(&w);
            if (k || w.contacts != 4)
                continue;
            CHECK_NEAR(fabs((double)w.contact[0].travel), 0.475, GEO);
            CHECK_NEAR(w.contact[0].n.x, 0, GEO);
            CHECK_NEAR(w.contact[2].n.x, 0.02 * up / sqrt(1.0004), GEO);
        }
}

/* A stone in a valley, a bed and a slope of 45 degrees, with a riser between
   them: the bed's span ends with it. Lower than the gap it is no shear key, and
   the stone slides up the slope at tan(45 degrees + atan(mu)); one of two gaps
   holds it. */
static void steps_at_ends(void)
{
    static world w;
    int mirror, high, i, k;
    double load;
    for (mirror = 0; mirror < 2; mirror++)
        for (high = 0; high < 2; high++) {
            const double h = high ? 8e-3 : 3e-3;
            double valley[] = {-1, -1, 3, -1, 2, 1 + h, 1, h, 1, 0, -1, 0};
            double stone[] = {0, 0, 1, 0, 1, h, 1.5, 0.5 + h, 1.5, 1, 0, 1};
            for (i = 0; i < 12 && mirror; i += 2) {
                valley[i] *= -1;
                stone[i] *= -1;
            }
            sprintf(context, "(mirrored %d, high %d)", mirror, high);
            world_reset(&w);
            w.options.gap = R(4e-3);
            world_polygon(&w, 0, valley, 6);
            world_polygon(&w, 1, stone, 6);
            CHECK_INT(world_touch(&w), high ? 6 : 4);
            check_contacts(&w);
            for (k = 0; k < w.contacts && !high; k++)
                CHECK(w.contact[k].n.y > R(0.7));
            CHECK_INT(load_factor(&w, NULL, mirror ? -1 : 1, &load),
                      KERN_STANDS);
            CHECK(high ? load > 3 : fabs(load - 1.4 / 0.6) < 0.02);
        }
    context[0] = 0;
}

/* A lip lower than the gap at the end of a bed is no shear key, whether it
   stands on the ground beside the stone, or hangs from the stone beside the
   ground; a higher one is. */
static void steps_lips(void)
{
    static const double high[] = {1e-4, 5e-4, 1.1e-3, 2e-3, 3.9e-3, 5e-3};
    static world w;
    double load;
    int k, i, kind, turned;
    for (k = 0; k < 6; k++)
        for (kind = 0; kind < 2; kind++)
            for (turned = 0; turned < 2; turned++) {
                const double h = high[k];
                const double lip[2][10] = {{-1, -1, 3, -1, 1, h, 1, 0, -1, 0},
                                           {0, 0, 1, 0, 1, -h, 2, 1, 0, 1}};
                const double box[2][8] = {{0, 0, 1, 0, 1, 1, 0, 1},
                                          {-1, -1, 1, -1, 1, 0, -1, 0}};
                double xy[10];
                for (i = 0; i < 10; i += 2) { /* the other way round */
                    const int at = turned ? 8 - i : i;
                    xy[at] = lip[kind][i];
                    xy[at + 1] = lip[kind][i + 1];
                }
                sprintf(context, "(lip %g, kind %d, turned %d)", h, kind,
                        turned);
                world_reset(&w);
                w.options.gap = R(4e-3);
                w.options.mu = R(0.4);
                world_polygon(&w, kind, xy, 5);
                world_polygon(&w, !kind, box[kind], 4);
                CHECK(world_touch(&w) >= 2);
                CHECK_INT(load_factor(&w, NULL, kind ? -1 : 1, &load),
                          KERN_STANDS);
                CHECK(h > 4e-3 ? load > 0.9 : fabs(load - 0.4) < 5e-3);
            }
    context[0] = 0;
}

/* A ramp lower than the gap and longer, in a bed that fits it: one contact, on
   the chord. */
static void steps_of_ramps(void)
{
    static world w;
    const double h = 3e-3;
    const double base[] = {-1, -1, 2, -1, 2, h, 0.53, h, 0.5, 0, -1, 0};
    const double box[] = {0, 0, 0.5, 0, 0.53, h, 1, h, 1, 1, 0, 1};
    double load;
    world_reset(&w);
    w.options.gap = R(4e-3);
    world_polygon(&w, 0, base, 6);
    world_polygon(&w, 1, box, 6);
    CHECK_INT(world_touch(&w), 2);
    check_contacts(&w);
    CHECK_INT(load_factor(&w, NULL, 1, &load), KERN_STANDS);
    CHECK_NEAR(load, 0.4, 0.005);
}

/* Stairs in stairs, a third of the gap apart: the contact lies midway between
   their chords and ends where the stairs do. */
static void steps_apart(void)
{
    enum { TREADS = 100 };
    static double xy[4 * TREADS + 8];
    static world w;
    const double tread = 1.0 / TREADS, high = tread / 2, up = tread / 3;
    int i, j, k;
    world_reset(&w);
    w.options.gap = R(tread);
    for (j = 0; j < 2; j++) {
        for (i = k = 0; i < TREADS; i++) {
            xy[k++] = i * tread;
            xy[k++] = i * high + j * up;
            xy[k++] = (i + 1) * tread;
            xy[k++] = i * high + j * up;
        }
        xy[k++] = 1;
        xy[k++] = j ? 2 : -1;
        xy[k++] = 0;
        xy[k++] = j ? 2 : -1;
        world_polygon(&w, j, xy, k / 2);
    }
    CHECK_INT(world_touch(&w), 2);
    for (i = 0; i < 2;
         i++) { /* from the last tread's end to the first's start */
        const kern_contact *c = &w.contact[i];
        CHECK_NEAR(c->p.x, 1 - i, GEO);
        CHECK_NEAR(c->p.y, (1 - i) * (TREADS - 1) * high + up / 2, GEO);
    }
}

/* knife/joint_10deg_2000px: the joint of steps_of_pixels() before it was an
   image. */
static void steps_straight_joint(void)
{
    static world w;
    double value;
    kern_margin m;
    pixel_joint(&w, 0, tan(10 * pi / 180));
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.4940021, 1e-4);
    CHECK_INT(load_factor(&w, NULL, 1, &value), KERN_STANDS);
    CHECK_NEAR(value, tan(atan(0.4) + 10 * pi / 180), 1e-3);
}

/* overlap/whisker: the same stone twice, the second with a whisker that is
   thinner than the gap. */
static void overlap_with_whiskers(void)
{
    static const double whisker[] = {0, 0, 1,      0,  1,       1, 0,
                                     1, 0, 0.5005, -3, 0.50025, 0, 0.5};
    static const double two[] = {0, 0, 1, 0, 1, 0.3,    5,  0.30025, 1, 0.3005,
                                 1, 1, 0, 1, 0, 0.5005, -3, 0.50025, 0, 0.5};
    /* two stones with a neck between them, as an image may join them */
    static const double neck[] = {0,   0,      1,   0,      1,   0.5, 1.5, 0.5,
                                  1.5, 0,      2.5, 0,      2.5, 1,   1.5, 1,
                                  1.5, 0.5005, 1,   0.5005, 1,   1,   0,   1};
    static world w;
    kern_work work = kern_work_of(NULL, 0, NULL, 0);
    int k, swap;
    for (k = 0; k < 5; k++)
        for (swap = 0; swap < 2; swap++) {
            world_reset(&w);
            if (swap)
                world_box(&w, 1, k == 4 ? 1.5 : 0, 0, k == 4 ? 2.5 : 1, 1);
            if (k == 0)
                world_polygon(&w, 1, whisker, 7);
            else if (k == 1)
                world_polygon(&w, 1, two, 10);
            else if (k == 2)
                world_box(&w, 1, 2e-4, -2e-4, 1 + 2e-4, 1 - 2e-4);
            else
                world_polygon(&w, 1, neck, 12);
            if (!swap)
                world_box(&w, 1, k == 4 ? 1.5 : 0, 0, k == 4 ? 2.5 : 1, 1);
            CHECK_INT(kern_touch(w.block, 1, &w.options, w.contact, MAX_POINTS,
                                 &work),
                      KERN_OVERLAP);
            CHECK(work.fault.value > R(0.001));
        }
    world_reset(&w); /* beside each other, whiskers and all */
    world_polygon(&w, 1, whisker, 7);
    world_box(&w, 1, -1, 0, 0, 0.5);
    CHECK_INT(kern_touch(w.block, 1, &w.options, w.contact, MAX_POINTS, &work),
              4);
}

/* A point contact goes to the middle of the two that are farthest apart, of
   several such pairs the first, as two loops would find it. */
static kern_contact many_points[4800];

static void points_of_one_pair(int n)
{
    kern_contact *c = many_points;
    int i;
    for (i = 0; i < n; i++) {
        memset(&c[i], 0, sizeof c[i]);
        c[i].b = 1;
        c[i].p = vec(i, i * 0.5);
        c[i].n = vec(0.6, 0.8);
    }
    kern_contact_travels(c, n);
    CHECK_NEAR(c[0].travel + c[n - 1].travel, 0, GEO * n);
}

static void travels_of_many(void)
{
    kern_contact *c = many_points;
    int trial, i, j, k;
    for (trial = 0; trial < 196; trial++) {
        const int n = random_int(0, 40), pairs = random_int(1, 4);
        for (i = 0; i < n; i++) {
            const double x = trial % 2 ? random_int(0, 4) : uniform(0, 1);
            const double y = trial % 2 ? random_int(0, 4) : uniform(0, 1);
            memset(&c[i], 0, sizeof c[i]);
            k = random_int(0, pairs - 1);
            c[i].a = chance(0.5) ? 0 : k + 1;
            c[i].b = c[i].a == 0 ? k + 1 : 0;
            c[i].p = vec(x, y);
            c[i].n = vec(0.6, 0.8);
            c[i].travel = R(i);
        }
        kern_contact_travels(c, n);
        for (i = 0; i < n; i++) {
            double widest = 0, x = (double)c[i].p.x, y = (double)c[i].p.y;
            for (j = 0; j < n; j++)
                for (k = j + 1; k < n; k++) {
                    const double dx = (double)(c[k].p.x - c[j].p.x);
                    const double dy = (double)(c[k].p.y - c[j].p.y);
                    if (c[j].a + c[j].b == c[i].a + c[i].b
                        && c[k].a + c[k].b == c[i].a + c[i].b
                        && (double)R(dx * dx + dy * dy) > widest) {
                        widest = (double)R(dx * dx + dy * dy);
                        x = (double)(c[j].p.x + c[k].p.x) / 2;
                        y = (double)(c[j].p.y + c[k].p.y) / 2;
                    }
                }
            CHECK_NEAR(c[i].travel,
                       0.6 * (y - (double)c[i].p.y)
                           - 0.8 * (x - (double)c[i].p.x),
                       GEO);
        }
    }
    CHECK(grows_less(points_of_one_pair, 1200, 32));
    kern_contact_travels(NULL, 0);
    kern_contact_travels(NULL, 3);
    CHECK_NEAR(kern_contact_at(NULL, 0, 0).x, 0, 0);
    CHECK_NEAR(kern_near(NULL, 1).gap, R(0.04), 0);
    CHECK_NEAR(kern_near(NULL, 1).mu, kern_defaults().mu, 0);
}

/* The normal of a given contact may be of any length that has an inverse. */
static void given_normals(void)
{
    const double longest = SINGLE ? (double)FLT_MAX : DBL_MAX;
    const double shortest = SINGLE ? (double)FLT_MIN : DBL_MIN;
    const kern_options o = kern_defaults();
    const double length[] = {shortest * 1e-2, shortest, longest / 2, longest};
    int i;
    for (i = 0; i < 4; i++) {
        kern_contact c[2];
        const int got = contact_make(0, 1, vec(length[i], length[i]), vec(0, 0),
                                     vec(0, 0), R(0.4), &o, c);
        CHECK_INT(got, i == 0 ? (int)KERN_BAD_NORMAL : 1);
        if (got == 1)
            CHECK_NEAR(hypot((double)c[0].n.x - sqrt(0.5),
                             (double)c[0].n.y - sqrt(0.5)),
                       0, GEO);
    }
}

/* ---- random stones with and without steps ---- */

#ifndef STONES
#define STONES 2000
#endif

/* An edge of a polygon, and the outline that it is copied to. */
typedef struct edge_copy {
    double *out;
    int to; /* numbers that are written */
    double x, y, tx, ty, length;
} edge_copy;

/* A point so far along the edge, and a share of a height to its right. */
static void put_point(edge_copy *e, double at, double high, double share)
{
    e->out[e->to++] = e->x + e->tx * at + e->ty * high * share;
    e->out[e->to++] = e->y + e->ty * at - e->tx * high * share;
}

/* A pair of risers, upright, inclined or broken, in one of some equal parts of
   the edge: out of the stone or into it by less than a gap, and back. */
static void put_risers(edge_copy *e, int pair, int pairs, double gap)
{
    double at, high, run, part;
    high = gap * pow(10, uniform(SINGLE ? -3 : -9, log10(0.9)));
    high *= chance(0.5) ? 1 : -1;
    at = chance(0.2) ? uniform(0.1, 3) * gap
                     : uniform(0.05, 0.9) * e->length / pairs;
    at += e->length * pair / pairs;
    run = chance(0.5) ? 0 : fabs(high) * uniform(0, 1);
    part = chance(0.3) ? uniform(0.2, 0.8) : 0;
    put_point(e, at, high, 0);
    at += run;
    if (part > 0)
        put_point(e, at - run * 0.7, high, part);
    put_point(e, at, high, 1);
    at += ((pair + 1.0) / pairs * e->length - at - 3 * run) * uniform(0.1, 0.9);
    put_point(e, at, high, 1);
    at += run;
    if (part > 0)
        put_point(e, at - run * 0.7, high, part);
    put_point(e, at, high, 0);
}

/* The polygon xy with risers in the edges that `rough` has a bit for. Returns
   how many vertices there are. */
static int roughened(double *out, const double *xy, int n, int rough,
                     double gap)
{
    edge_copy e;
    int i, k;
    e.out = out;
    e.to = 0;
    for (i = 0; i < n; i++) {
        const double *p = xy + 2 * i, *q = xy + 2 * ((i + 1) % n);
        const int pairs = rough >> i & 1 ? random_int(1, 3) : 0;
        e.x = p[0];
        e.y = p[1];
        e.length = hypot(q[0] - p[0], q[1] - p[1]);
        e.tx = (q[0] - p[0]) / e.length;
        e.ty = (q[1] - p[1]) / e.length;
        put_point(&e, 0, 0, 0);
        for (k = 0; k < pairs; k++)
            put_risers(&e, k, pairs, gap);
    }
    return e.to / 2;
}

/* A random stone of three to seven corners around (0, 0). */
static int round_stone(double *xy)
{
    const int n = random_int(3, 7);
    const double turn = uniform(0, 2 * pi);
    int i;
    for (i = 0; i < n; i++) {
        const double angle = turn + 2 * pi * (i + uniform(-0.2, 0.2)) / n;
        xy[2 * i] = cos(angle);
        xy[2 * i + 1] = sin(angle);
    }
    return n;
}

/* A fixed neighbour of the edge from p to q: a box along part of it, a box with
   a corner on it, or one on whose edge corner q stands. */
static int neighbour(double *xy, const double *p, const double *q)
{
    const double long_ = hypot(q[0] - p[0], q[1] - p[1]);
    const double tx = (q[0] - p[0]) / long_, ty = (q[1] - p[1]) / long_;
    const double from = uniform(-0.3, 0.7) * long_;
    const double wide_ = uniform(0.2, 1) * long_, deep = uniform(0.2, 1);
    double turn = 0;
    int i;
    for (i = 0; i < 4; i++) {
        const double along = i == 0 || i == 3 ? 0 : wide_;
        const double out = i == 0 || i == 1 ? deep : 0;
        xy[2 * i] = along;
        xy[2 * i + 1] = -out;
    }
    if (chance(0.3))
        turn = uniform(0.2, 1.2);
    for (i = 0; i < 4; i++) { /* corner 3 is its place on the edge */
        const double x = xy[2 * i] * cos(turn) + xy[2 * i + 1] * sin(turn);
        const double y = -xy[2 * i] * sin(turn) + xy[2 * i + 1] * cos(turn);
        xy[2 * i] = p[0] + tx * (x + from) - ty * y;
        xy[2 * i + 1] = p[1] + ty * (x + from) + tx * y;
    }
    return 4;
}

/* Has each contact of w one of t at its place, and none another? */
static int same_supports(const world *w, const world *t, double gap)
{
    int i, j, ok = w->contacts == t->contacts;
    for (i = 0; i < w->contacts && ok; i++) {
        const kern_contact *c = &w->contact[i];
        int found = 0;
        for (j = 0; j < t->contacts; j++) {
            const kern_contact *d = &t->contact[j];
            found |= c->a == d->a && c->b == d->b && c->line == d->line
                  && hypot((double)(c->p.x - d->p.x), (double)(c->p.y - d->p.y))
                         <= gap
                  && (double)(c->n.x * d->n.x + c->n.y * d->n.y)
                         >= cos((double)w->options.angle);
        }
        ok = found;
    }
    return ok;
}

/* Is the polygon a good one? Steps near a sharp corner may cross. */
static int is_simple(const double *xy, int n)
{
    kern_vec v[200];
    kern_block b;
    int i;
    for (i = 0; i < n; i++)
        v[i] = vec(xy[2 * i], xy[2 * i + 1]);
    return kern_block_init(&b, v, n, R(1), NULL) == KERN_OK;
}

/* A stone with a fixed neighbour, in w as they are, in t with steps in the one
   or the other. Returns 0 where they have no contacts. */
static int stone_with_steps(world *w, world *t, int trial)
{
    double stone[14], other[8], rough[400], gap;
    int n, edge, k;
    random_seed(52000u + (unsigned long long)trial);
    sprintf(context, "(stone %d)", trial);
    n = round_stone(stone);
    edge = random_int(0, n - 1);
    neighbour(other, stone + 2 * edge, stone + 2 * ((edge + 1) % n));
    world_reset(w);
    world_polygon(w, 1, stone, n);
    world_polygon(w, 0, other, 4);
    gap = 1e-3 * sqrt(fabs((double)w->block[0].area));
    if (world_touch(w) <= 0)
        return 0; /* one in the other */
    world_reset(t);
    k = roughened(rough, stone, n, trial % 2 ? random_int(1, 127) : 0, gap);
    if (!is_simple(rough, k))
        return 0;
    world_polygon(t, 1, rough, k);
    k = roughened(rough, other, 4, trial % 2 ? 0 : random_int(1, 15), gap);
    if (!is_simple(rough, k))
        return 0;
    world_polygon(t, 0, rough, k);
    CHECK(world_touch(t) > 0);
    return 1;
}

static void steps_in_random_stones(void)
{
    int trial, cases = 0;
    for (trial = 0; trial < STONES; trial++) {
        static world w, t;
        if (!stone_with_steps(&w, &t, trial))
            continue;
        cases++;
        check_contacts(&t);
        CHECK(same_supports(&w, &t,
                            1.125e-3 * sqrt(fabs((double)w.block[0].area))));
    }
    context[0] = 0;
    CHECK(cases > STONES / 4 * 3);
}

/* Contacts at steps are the same whichever way the world is turned, mirrored,
   scaled, and in whichever order the blocks are. */
static void steps_invariance(void)
{
    static world w, t, u, v;
    static int order[MAX_BLOCKS];
    int trial, k;
    for (trial = 0; trial < 600; trial++) {
        change c = no_change();
        double gap;
        if (trial < 60) {
            const int n = random_int(60, 150);
            pixel_joint(&w, n, uniform(0.01, 0.9));
            w.options.gap = R(1.5 / n);
            CHECK_INT(world_touch(&w), 2);
        } else if (!stone_with_steps(&t, &w, trial))
            continue;
        gap = w.options.gap > 0 ? (double)w.options.gap : 1.125e-3;
        if (trial % 4 == 0)
            c.shuffle = 1;
        if (trial % 4 == 1)
            c.mirror = 1;
        if (trial % 4 == 2)
            c.scale = pow(10, uniform(-2, 2));
        if (trial % 4 == 3)
            c.angle = uniform(-pi, pi);
        world_changed(&u, &w, &c, order);
        /* and back: the contacts of u in the frame of w */
        world_copy(&v, &w);
        v.contacts = u.contacts;
        for (k = 0; k < u.contacts; k++) {
            const kern_contact *d = &u.contact[k];
            const int swap = order[0] > order[1];
            const double x = ((double)d->p.x) / c.scale;
            const double y = ((double)d->p.y) / c.scale;
            const double cs = cos(c.angle), sn = sin(c.angle);
            const double sign = c.mirror ? -1 : 1, side = swap ? -1 : 1;
            v.contact[k] = *d;
            v.contact[k].a = 0;
            v.contact[k].b = 1;
            v.contact[k].p = vec(sign * (x * cs + y * sn), y * cs - x * sn);
            v.contact[k].n = vec(
                side * sign * ((double)d->n.x * cs + (double)d->n.y * sn),
                side * ((double)d->n.y * cs - (double)d->n.x * sn));
        }
        CHECK(same_supports(&w, &v, gap * (SINGLE ? 0.1 : 0.01)));
    }
    context[0] = 0;
}

/* The structure with steps in some edges of its stones, lower than half the gap
   of the smallest, so that two on each other do not reach into each other. */
static int structure_with_steps(world *to, const world *from)
{
    double least = huge_value();
    int i, k;
    for (i = 0; i < from->blocks; i++)
        if (!from->block[i].fixed)
            least = fmin(least, sqrt(fabs((double)from->block[i].area)));
    world_reset(to);
    to->gravity = from->gravity;
    to->options = from->options;
    for (i = 0; i < from->blocks; i++) {
        const kern_block *b = &from->block[i];
        double xy[32], rough[600];
        if (b->vertices < 3 || b->vertices > 16)
            return 0;
        for (k = 0; k < b->vertices; k++) {
            const kern_vec v = b->vertex[b->area < 0 ? b->vertices - 1 - k : k];
            xy[2 * k] = (double)v.x;
            xy[2 * k + 1] = (double)v.y;
        }
        k = roughened(rough, xy, b->vertices, random_int(0, 65535),
                      0.45e-3 * least);
        if (k > 190 || !is_simple(rough, k) || to->vertices + k > MAX_VERTICES)
            return 0;
        world_polygon(to, 1, rough, k);
        to->block[i].fixed = b->fixed;
        to->block[i].mass = b->mass;
        to->block[i].centre = b->centre;
        to->block[i].load = b->load;
    }
    return world_touch(to) > 0;
}

/* No structure falls because its stones have steps, and none bears more. */
/* What stands with a margin of more than a gap, by which an end of a contact
   moves, stands still. */
static void check_stays(const world *w, int got, const kern_margin *m, int now)
{
    if (got == KERN_STANDS && (double)m->margin > 0.01 * mean_size(w))
        CHECK(now == KERN_STANDS || (SINGLE && now == KERN_UNDECIDED));
}

/* Two load factors of about the same structure. */
static void check_like_load(const world *w, const world *t)
{
    double factor, rough;
    if (load_factor(w, NULL, 1, &factor) != KERN_STANDS
        || load_factor(t, NULL, 1, &rough) != KERN_STANDS)
        return;
    if (isinf(factor) || isinf(rough))
        CHECK(isinf(factor) && isinf(rough));
    else
        CHECK_NEAR(rough, factor, 0.05 * factor + 0.01);
}

static void steps_in_random_structures(void)
{
    static world w, t;
    int seed, cases = 0;
    for (seed = 0; seed < 2000; seed++) {
        kern_margin m, n;
        int got, now;
        random_of_kind(&w, 83000u + (unsigned long long)seed, 8, seed % KINDS);
        w.options.relative = 0;
        w.options.epsilon = 0;
        if (w.given || w.contacts < 1 || w.contacts > 60
            || !structure_with_steps(&t, &w))
            continue;
        cases++;
        got = measure(&w, &m);
        now = measure(&t, &n);
        check_stays(&w, got, &m, now);
        check_stays(&w, now, &n, got);
        if (!SINGLE && got == KERN_STANDS && now == KERN_STANDS)
            check_like_load(&w, &t);
    }
    context[0] = 0;
    CHECK(cases > 500);
}

/* ---- outlines of many vertices -------------------------------- >>outlines */

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
    CHECK_INT(kern_block_init(&block[0], long_outline[0], k + 2, R(1), NULL),
              KERN_OK);
    CHECK_INT(kern_ground_init(&block[1], long_outline[1], k + 2, NULL),
              KERN_OK);
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
    /* 84 where each contact splits the outline anew */
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

/* ==== The engine, part by part =================================== >>engine */

/* Each tool of the engine by itself: what no answer shows, since every answer is
   proven and a tool that is wrong only costs time. Private parts of kern.h that
   are called here:

     rows     kern_row_of, kern_row_speed, kern_row_exert
     laws     kern_law_stiff
     factor   kern_take_open, kern_skyline_open, _clear, _law,
              _shift, _factor, _solve
     group    kern_pass_solve
     basis    kern_simplex_lay, kern_program_solve, kern_basis_solve
     step     kern_call_open, kern_ipm_open, kern_ipm_begin, kern_ipm_step
     bracket  kern_path_evaluate, kern_path_critical

   With tests/audit.h included first, the state of an engine is checked wherever
   a test of this file uses it: see there. */

enum { ENGINE_GROUPS = 9, ENGINE_TIES = 24, ENGINE_ROWS = 9, ENGINE_COLS = 14 };

static kern_row engine_row(kern_vec n)
{
    return kern_row_of(n, vec(uniform(-2, 2), uniform(-2, 2)),
                       R(uniform(0.5, 2)));
}

static kern_vec engine_normal(void)
{
    const double angle = uniform(0, 2 * pi);
    return vec(cos(angle), sin(angle));
}

/* The power of a force is the same seen from the contact and from the block. */
static void engine_rows(void)
{
    const kern_real up[3] = {0, R(2), R(3)};
    kern_real w[2] = {0, 0}, b[3] = {0, 0, 0};
    kern_row row = kern_row_of(vec(0, 1), vec(0.5, -1), R(2));
    int i;
    kern_row_speed(&row, up, w); /* 2 + 3 * 2 * .5 up; t is to the left */
    CHECK_NEAR(w[0], 5, 8 * EPS);
    CHECK_NEAR(w[1], -6, 8 * EPS);
    kern_row_exert(&row, R(4), R(1), b);
    CHECK_NEAR(b[0], -1, 8 * EPS);
    CHECK_NEAR(b[1], 4, 8 * EPS);
    CHECK_NEAR(b[2], 4 * 2 * 0.5 - 2, 8 * EPS);
    for (i = 0; i < 1000; i++) {
        const kern_real f = R(uniform(0, 5)), r = R(uniform(-2, 2));
        const kern_real v[3] = {R(uniform(-1, 1)), R(uniform(-1, 1)),
                                R(uniform(-1, 1))};
        row = engine_row(engine_normal());
        w[0] = w[1] = b[0] = b[1] = b[2] = 0;
        kern_row_speed(&row, v, w);
        kern_row_exert(&row, f, r, b);
        CHECK_NEAR(f * w[0] + r * w[1], b[0] * v[0] + b[1] * v[1] + b[2] * v[2],
                   100 * EPS);
    }
}

/* The law of minimum-norm forces: of rays of stiffness 1 that only press. */
static kern_law engine_pressed(kern_real wn, kern_real wt, kern_real mu)
{
    return kern_law_stiff(wn, wt, mu, R(2), mu);
}

/* Whatever the motion, a force lies in its cone, is what the law says of the
   motion, and never helps it. */
static void engine_law(kern_law s, double wn, double wt, double mu)
{
    const double f = s.force.normal, r = s.force.tangential;
    const double tol = 1e4 * EPS * (1 + fabs(wn) + fabs(wt));
    CHECK(f >= 0 && fabs(r) <= mu * f * (1 + 4 * EPS));
    CHECK_NEAR(f, s.nn * wn + s.nt * wt, tol);
    CHECK_NEAR(r, s.nt * wn + s.tt * wt, tol);
    CHECK(f * wn + r * wt >= -tol);
    CHECK(s.nn >= 0 && s.tt >= 0 && s.nn * s.tt >= s.nt * s.nt - tol);
}

static void engine_laws(void)
{
    int i;
    kern_law s = engine_pressed(R(1), 0, R(0.5));
    CHECK_NEAR(s.force.normal, 2, 8 * EPS); /* both rays press by 1 */
    CHECK_NEAR(s.force.tangential, 0, 8 * EPS);
    s = engine_pressed(R(1), R(4), R(0.5)); /* one by 3 */
    CHECK_NEAR(s.force.normal, 3, 8 * EPS);
    CHECK_NEAR(s.force.tangential, 1.5, 8 * EPS);
    s = kern_law_stiff(R(2), 0, R(0.5), R(3), 1 / KERN_STICKS);
    CHECK_NEAR(s.force.normal, 6, 16 * EPS);
    s = kern_law_stiff(R(-2), R(1), R(0.5), R(3), 1 / KERN_STICKS); /* parts */
    CHECK_NEAR(s.force.normal, 0, 0);
    for (i = 0; i < 2000; i++) {
        const double wn = uniform(-1, 1), mu = uniform(0.05, 1);
        const double wt = uniform(-1, 1) * (i % 2 ? 1 : 1e-3);
        engine_law(engine_pressed(R(wn), R(wt), R(mu)), wn, wt, mu);
        engine_law(kern_law_stiff(R(wn), R(wt), R(mu), R(2), 1 / KERN_STICKS),
                   wn, wt, mu);
    }
}

/* Groups tied to each other, and some to the ground, by contacts of a law. */
typedef struct ties {
    int groups, count;
    int ends[2 * ENGINE_TIES];
    kern_row row[2 * ENGINE_TIES];
    kern_law law[ENGINE_TIES];
    kern_skyline a;
    kern_real real[ENGINE_GROUPS * ENGINE_GROUPS * 9];
    int index[4 * ENGINE_GROUPS];
} ties;

static void ties_open(ties *t)
{
    kern_take take;
    const kern_work work = kern_work_of(t->real, COUNT_OF(t->real), t->index,
                                        COUNT_OF(t->index));
    int k;
    t->groups = random_int(1, ENGINE_GROUPS);
    t->count = random_int(t->groups, ENGINE_TIES);
    kern_take_open(&take, &work);
    for (k = 0; k < t->count; k++) {
        const kern_vec n = engine_normal();
        t->ends[2 * k] = random_int(0, t->groups - 1);
        do /* t->groups: the ground */
            t->ends[2 * k + 1] = random_int(0, t->groups);
        while (t->ends[2 * k + 1] == t->ends[2 * k]);
        t->row[2 * k] = engine_row(n);
        t->row[2 * k + 1] = engine_row(vec(-n.x, -n.y));
        t->law[k] = engine_pressed(R(1), R(uniform(-3, 3)), R(0.6));
    }
    CHECK(kern_skyline_open(&t->a, t->groups, t->ends, t->count, &take) > 0);
    CHECK(kern_take_fits(&take));
    kern_skyline_clear(&t->a);
    for (k = 0; k < t->count; k++)
        kern_skyline_law(&t->a, t->ends + 2 * k, t->row + 2 * k, &t->law[k]);
    kern_skyline_shift(&t->a, R(1e-3)); /* what hangs loose has a matrix, too */
}

/* out := the matrix times v, contact by contact, without the shift. */
static void ties_times(const ties *t, const kern_real *v, kern_real *out)
{
    int k, e, i;
    for (i = 0; i < 3 * t->groups + 3; i++)
        out[i] = 0;
    for (k = 0; k < t->count; k++) {
        const kern_law *s = &t->law[k];
        kern_real w[2] = {0, 0};
        for (e = 0; e < 2; e++)
            kern_row_speed(&t->row[2 * k + e], v + 3 * t->ends[2 * k + e], w);
        for (e = 0; e < 2; e++)
            kern_row_exert(&t->row[2 * k + e], s->nn * w[0] + s->nt * w[1],
                           s->nt * w[0] + s->tt * w[1],
                           out + 3 * t->ends[2 * k + e]);
    }
}

/* What the shift adds to the diagonal: a share of its mean. */
static double ties_shift(const ties *t)
{
    kern_real v[3 * ENGINE_GROUPS + 3], out[3 * ENGINE_GROUPS + 3];
    double trace = 0;
    int i, k;
    for (i = 0; i < 3 * t->groups; i++) {
        for (k = 0; k < 3 * t->groups + 3; k++)
            v[k] = R(k == i);
        ties_times(t, v, out);
        trace += (double)out[i];
    }
    return 1e-3 * trace / (3 * t->groups);
}

/* L L' v = M v, M from the contacts one by one, and M times the solution is
   what was asked for. */
static void engine_factor(void)
{
    static ties t;
    kern_real v[3 * ENGINE_GROUPS + 3], b[3 * ENGINE_GROUPS + 3],
        x[3 * ENGINE_GROUPS + 3];
    int round, i;
    random_seed(77);
    for (round = 0; round < some(400); round++) {
        double shift, size = 0;
        ties_open(&t);
        shift = ties_shift(&t);
        for (i = 0; i < 3 * t.groups + 3; i++)
            v[i] = i < 3 * t.groups ? R(uniform(-1, 1)) : 0;
        ties_times(&t, v, b);
        for (i = 0; i < 3 * t.groups; i++) {
            b[i] += R(shift) * v[i];
            size = fmax(size, fabs((double)b[i]));
        }
        kern_skyline_factor(&t.a);
        kern_skyline_solve(&t.a, b, x);
        for (i = 0; i < 3 * t.groups; i++)
            CHECK_NEAR(x[i], v[i], (SINGLE ? 0.1 : 1e-9) * (1 + size));
    }
}

/* A box on two points at -1 and 1, loaded at x: the forces are (1 -+ x) / 2;
   beyond the points none hold it. */
static void engine_group_on(double x)
{
    const kern_real b[3] = {0, R(1), R(x)}, rests[2] = {0, 0};
    kern_ray c[4];
    kern_status got;
    int k;
    for (k = 0; k < 2; k++) {
        const kern_row row = kern_row_of(vec(0, 1), vec(k ? 1 : -1, -0.5),
                                         R(1));
        kern_ray_pair(c + 2 * k, &row, R(0.4), rests);
    }
    got = kern_pass_solve(c, 4, b, R(SINGLE ? 1e-6 : 1e-11));
    CHECK_INT(got, fabs(x) <= 1 ? KERN_STANDS : KERN_FALLS);
    for (k = 0; k < 2 && got == KERN_STANDS; k++) {
        const double plus = fmax(c[2 * k].x, 0),
                     minus = fmax(c[2 * k + 1].x, 0);
        CHECK_NEAR(plus + minus, (1 + (k ? x : -x)) / 2, 1e4 * EPS);
        CHECK_NEAR(plus, minus, 1e4 * EPS);
    }
}

static void engine_group(void)
{
    static const double at[] = {0, 0.25, -0.7, 0.99, 1.01, -3};
    int i;
    for (i = 0; i < COUNT_OF(at); i++)
        engine_group_on(at[i]);
}

/* The basis in which a program ends: header and places are inverse to each
   other, B x = b, and every column of B solves to a unit vector. */
static void engine_basis_holds(const kern_simplex *sx, const kern_real *a,
                               const kern_real *rhs)
{
    const int rows = sx->lp->rows, cols = sx->lp->cols;
    double left[ENGINE_ROWS];
    int p, i;
    for (i = 0; i < rows; i++)
        left[i] = (double)rhs[i];
    for (p = 0; p < rows; p++) {
        const int j = sx->base[p];
        kern_real v[ENGINE_ROWS + 3] = {0};
        for (i = 0; i < rows; i++) {
            v[i] = j < cols ? a[j * rows + i] : R(i == j - cols - 1);
            left[i] -= (double)(v[i] * sx->value[p]);
        }
        CHECK(j >= cols || sx->place[j] == p);
        kern_basis_solve(sx, v);
        for (i = 0; i < rows; i++)
            CHECK_NEAR(v[i], i == p, SINGLE ? 1e-2 : 1e-8);
    }
    for (i = 0; i < rows; i++)
        CHECK_NEAR(left[i], 0, SINGLE ? 1e-3 : 1e-9);
}

static void engine_basis(void)
{
    static kern_real real[4000], a[ENGINE_ROWS * ENGINE_COLS];
    static int index[2000];
    int round, i;
    random_seed(78);
    for (round = 0; round < some(300); round++) {
        kern_real rhs[ENGINE_ROWS], x[ENGINE_COLS], y[ENGINE_ROWS + 3];
        kern_work work = kern_work_of(real, 4000, index, 2000);
        kern_simplex sx;
        kern_program lp;
        kern_take take;
        kern_status got;
        memset(&lp, 0, sizeof lp);
        lp.rows = random_int(1, ENGINE_ROWS);
        lp.cols = random_int(lp.rows, ENGINE_COLS);
        lp.a = a;
        lp.rhs = rhs;
        lp.work = &work;
        for (i = 0; i < lp.rows * lp.cols; i++)
            a[i] = chance(0.3) ? 0 : R(uniform(-1, 1));
        for (i = 0; i < lp.rows; i++)
            rhs[i] = R(uniform(-1, 1));
        kern_take_open(&take, &work);
        kern_simplex_lay(&sx, &lp, 100, &take);
        CHECK(kern_take_fits(&take));
        got = kern_program_solve(&sx, 1, x, y);
        CHECK(got == KERN_LP_OPTIMAL || got == KERN_LP_INFEASIBLE);
        engine_basis_holds(&sx, a, rhs);
    }
}

/* The place of a program: x = rhs - s rate stays above 0 up to s = 4 / 1.5, and
   without the second row for ever; held beyond that it is infeasible. */
static void engine_place(void)
{
    static const kern_real a[4] = {1, 0, 0, 1};
    static kern_real real[400];
    static int index[400];
    kern_real rhs[2] = {1, 4}, rate[2] = {R(-0.5), R(1.5)};
    kern_real x[3], y[2];
    kern_work work = kern_work_of(real, 400, index, 400);
    kern_simplex sx;
    kern_program lp;
    kern_take take;
    memset(&lp, 0, sizeof lp);
    lp.rows = lp.cols = 2;
    lp.a = a;
    lp.rhs = rhs;
    lp.rate = rate;
    lp.work = &work;
    lp.follow = 1;
    kern_take_open(&take, &work);
    kern_simplex_lay(&sx, &lp, 20, &take);
    CHECK(kern_take_fits(&take));
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_OPTIMAL);
    CHECK_NEAR(x[2], 4 / 1.5, 8 * EPS);
    CHECK_NEAR(x[0], 1 + 2 / 1.5, 8 * EPS);
    lp.follow = 0;
    rhs[0] = R(2.5);
    rhs[1] = R(-0.5);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_INFEASIBLE);
    CHECK(y[0] >= 0 && y[1] > 0);
    rhs[0] = R(2.0);
    rhs[1] = R(1.0);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_OPTIMAL);
    CHECK_NEAR(x[1], 1, 8 * EPS);
    lp.rows = lp.cols = 1;
    lp.follow = 1;
    kern_simplex_change(&sx, KERN_BASIS_NONE);
    CHECK_INT(kern_program_solve(&sx, 1, x, y), KERN_LP_UNBOUNDED);
}

#ifndef KERN_NO_INTERIOR
/* With forces and speeds above 0 in each interior point, and a gap that goes to
   0, s gets to 0 where the stack stands, and where it falls to y.b, less. */
static void engine_step(void)
{
    static world w;
    int falls, round, i;
    stack_of_two(&w, 0.25);
    for (falls = 0; falls < 2; falls++) {
        const double least = SINGLE ? 1e-4 : 1e-9;
        kern_work work = work_of(&w);
        kern_call c;
        kern_ipm in;
        CHECK_INT(
            kern_call_open(&c, world_task(&w, &work), R(0.2 + 0.1 * falls), &w),
            KERN_OK);
        CHECK(kern_ipm_open(&in, &c.m, &c.part, &c.path.q));
        kern_part_load(in.p, &c.path.q, in.p->eq.rhs);
        CHECK(kern_ipm_begin(&in));
        for (round = 0; round < 25 && in.gap > least && in.s < 0; round++) {
            const double before = (double)in.gap;
            CHECK(kern_ipm_step(&in));
            CHECK(in.gap < 2 * before && in.s <= 0);
            for (i = 0; i < 2 * in.p->contacts; i++)
                CHECK(in.p->x[i] > 0 && in.z[i] > 0);
        }
        CHECK(round >= (falls ? 3 : 1) && round < 25);
        if (falls) {
            CHECK(in.s < -1e-3);
            CHECK_NEAR(in.s, kern_dot(in.p->y, in.p->eq.rhs, 3 * in.p->groups),
                       10 * least);
        } else
            CHECK(in.s >= 0);
    }
}
#endif

/* A bracket around it is narrowed to the tolerance, and both its ends are what
   verdicts from nothing say. */
static void engine_bracket(void)
{
    static const double off[] = {0.05, 0.1, 0.25, 0.3, 0.4};
    static world w;
    int i;
    for (i = 0; i < COUNT_OF(off); i++) {
        const double edge = 0.5 - off[i];
        kern_work work;
        kern_call c;
        kern_path *path = &c.path;
        stack_of_two(&w, off[i]);
        work = work_of(&w);
        CHECK_INT(kern_call_open(&c, world_task(&w, &work), 0, &w), KERN_OK);
        path->end = R(edge * 1.04); /* within half of the joint */
        CHECK_INT(kern_path_evaluate(&c.m, path, 0), KERN_STANDS);
        CHECK_INT(kern_path_evaluate(&c.m, path, path->end), KERN_FALLS);
        CHECK(kern_path_critical(&c.m, path) >= 0);
        CHECK_NEAR(path->critical, edge, EXACT);
        CHECK(path->holds <= path->critical && path->critical <= path->fails);
        CHECK(path->fails - path->holds <= kern_width(path) * R(1.01));
        CHECK_INT(kern_verdict(world_task(&w, &work), path->holds, NULL),
                  KERN_STANDS);
        CHECK_INT(kern_verdict(world_task(&w, &work), path->fails, NULL),
                  KERN_FALLS);
    }
}

/* ==== Linear programs ================================================ >>lp */

enum { LP_ROWS = 11, LP_COLS = 24 };

typedef struct program {
    kern_lp lp;
    kern_real a[LP_ROWS * LP_COLS], rhs[LP_ROWS], cost[LP_COLS];
    kern_real x[LP_COLS], y[LP_ROWS];
} program;

/* rows of `table`: the coefficients, then the right-hand side */
static void program_set(program *p, int rows, int cols, const double *table,
                        const double *cost)
{
    int i, j;
    memset(p, 0, sizeof *p);
    for (i = 0; i < rows; i++) {
        for (j = 0; j < cols; j++)
            p->a[j * rows + i] = R(table[i * (cols + 1) + j]);
        p->rhs[i] = R(table[i * (cols + 1) + cols]);
    }
    for (j = 0; cost && j < cols; j++)
        p->cost[j] = R(cost[j]);
    p->lp.rows = rows;
    p->lp.cols = cols;
    p->lp.a = p->a;
    p->lp.rhs = p->rhs;
    p->lp.cost = cost ? p->cost : NULL;
}

/* The coordinates of an optimum, or of a ray of falling cost, which changes no
   row. Returns the cost. */
static double check_primal(const program *p, int got)
{
    const double tol = SINGLE ? 1e-3 : 1e-8;
    const int m = p->lp.rows, n = p->lp.cols;
    double cost = 0, large = 1;
    int i, j;
    for (j = 0; j < n; j++) {
        CHECK(p->x[j] >= 0);
        large = fmax(large, (double)p->x[j]);
        if (p->lp.cost)
            cost += (double)p->x[j] * (double)p->lp.cost[j];
    }
    for (i = 0; i < m; i++) {
        double sum = got == KERN_LP_OPTIMAL ? -(double)p->lp.rhs[i] : 0;
        for (j = 0; j < n; j++)
            sum += (double)p->lp.a[j * m + i] * (double)p->x[j];
        CHECK_NEAR(sum, 0, tol * large);
    }
    if (got == KERN_LP_UNBOUNDED)
        CHECK(cost < -tol * large * 0.01);
    return cost;
}

/* The prices of an optimum that costs so much, or the Farkas certificate. */
static void check_dual(const program *p, int got, double cost)
{
    const double tol = SINGLE ? 1e-3 : 1e-8;
    const int m = p->lp.rows, n = p->lp.cols, optimal = got == KERN_LP_OPTIMAL;
    double dual = 0, large = 0;
    int i, j;
    for (i = 0; i < m; i++) {
        dual += (double)p->y[i] * (double)p->lp.rhs[i];
        large = fmax(large, fabs((double)p->y[i]));
    }
    for (j = 0; j < n; j++) {
        double sum = optimal ? (double)p->lp.cost[j] : 0;
        for (i = 0; i < m; i++)
            sum += (optimal ? -1 : 1) * (double)p->lp.a[j * m + i]
                 * (double)p->y[i];
        CHECK(sum >= -tol * fmax(large, optimal ? 1 : 0));
    }
    if (optimal)
        CHECK_NEAR(cost, dual, 10 * tol * (1 + fabs(cost)));
    else
        CHECK(dual < -tol * 0.01 * large);
}

/* Solves and checks everything that the answer says of itself. */
static int program_solve(program *p)
{
    static kern_real real[KERN_LP_REALS(LP_ROWS, LP_COLS)];
    static int index[KERN_LP_INTS(LP_ROWS, LP_COLS)];
    kern_work work = kern_work_of(real, KERN_LP_REALS(LP_ROWS, LP_COLS), index,
                                  KERN_LP_INTS(LP_ROWS, LP_COLS));
    const int got = kern_lp_solve(&p->lp, p->x, p->y, &work);
    double cost = 0;
    if (got == KERN_LP_OPTIMAL || got == KERN_LP_UNBOUNDED)
        cost = check_primal(p, got);
    if (got == KERN_LP_INFEASIBLE || (got == KERN_LP_OPTIMAL && p->lp.cost))
        check_dual(p, got, cost);
    return got;
}

static double program_cost(const program *p)
{
    double sum = 0;
    int j;
    for (j = 0; j < p->lp.cols; j++)
        sum += (double)p->x[j] * (double)p->lp.cost[j];
    return sum;
}

static void lp_cycling(void)
{
    static const double beale[] = {0.25, -60, -0.04, 9, 1, 0, 0, 0,
                                   0.5,  -90, -0.02, 3, 0, 1, 0, 0,
                                   0,    0,   1,     0, 0, 0, 1, 1};
    static const double beale_cost[] = {-0.75, 150, -0.02, 6, 0, 0, 0};
    static const double kuhn[] = {-2,     -9, 1,       9,   1, 0, 0, 0,
                                  1. / 3, 1,  -1. / 3, -2,  0, 1, 0, 0,
                                  2,      3,  -1,      -12, 0, 0, 1, 2};
    static const double kuhn_cost[] = {-2, -3, 1, 12, 0, 0, 0};
    static const double kuhn_open[] = {-2,     -9, 1,       9,  1, 0, 0,
                                       1. / 3, 1,  -1. / 3, -2, 0, 1, 0};
    program p;
    program_set(&p, 3, 7, beale, beale_cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -0.05, 1e3 * EPS);
    CHECK_NEAR(p.x[0], 0.04, 1e3 * EPS);
    CHECK_NEAR(p.x[2], 1, 1e3 * EPS);
    program_set(&p, 3, 7, kuhn, kuhn_cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -2, 1e3 * EPS);
    /* without its last row Kuhn's example has no end; in float 1/3 is not a
       third, and the ray along which the second row stays 0 may be lost */
    program_set(&p, 2, 6, kuhn_open, kuhn_cost);
    CHECK_INT(program_solve(&p), KERN_LP_UNBOUNDED);
}

/* Klee and Minty's cube: the largest cost takes far more pivots than there are
   rows; they are within the bounds on pivots. */
static void lp_many_pivots(void)
{
    enum { N = 11 };
    double a[N * (2 * N + 1)] = {0}, cost[2 * N] = {0};
    program p;
    int i, j;
    if (SINGLE) /* its numbers are no floats */
        return;
    for (i = 0; i < N; i++) {
        double *row = a + i * (2 * N + 1);
        for (j = 0; j < i; j++)
            row[j] = pow(2, i - j + 1);
        row[i] = row[N + i] = 1;
        row[2 * N] = pow(5, i + 1);
        cost[i] = -pow(2, N - 1 - i);
    }
    program_set(&p, N, 2 * N, a, cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), -pow(5, N), 1e-6);
}

/* The least cost is 0, paid by prices of (-2/35, 0): what the second one is by
   rounding pays 1e-19, which is all that there is to compare. */
static void lp_of_no_cost(void)
{
    static const double table[] = {1, 0, -0.25, -0.75, 17.5, 0,
                                   0, 1, 22.5,  -0.25, 2.25, 1};
    static const double cost[] = {0, 0, 2, 2, -1};
    program p;
    program_set(&p, 2, 5, table, cost);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(program_cost(&p), 0, 0);
    CHECK_NEAR(p.x[1], 1, EPS);
    CHECK_NEAR(p.y[0], -2. / 35, 4 * EPS);
}

/* Rows of coefficients, each with its right-hand side, and the least cost. */
static void lp_kinds(void)
{
    static const struct {
        int rows, cols, with_cost, want;
        double table[15], cost[4], least;
    } kind[] = {
        {2, 2, 0, KERN_LP_OPTIMAL, {1, 1, 2, 1, -1, 0}, {0}, 0},
        {4,
         2,
         1,
         KERN_LP_OPTIMAL,
         {1, 1, 2, 2, 2, 4, 1, -1, 0, 3, 1, 4},
         {1, 1},
         2}, /* redundant rows */
        {2, 2, 0, KERN_LP_INFEASIBLE, {1, 1, 2, 1, 1, 3}, {0}, 0},
        {1, 2, 1, KERN_LP_INFEASIBLE, {1, 1, -1}, {1, 1}, 0},
        {3,
         4,
         1,
         KERN_LP_OPTIMAL, /* a degenerate vertex */
         {1, 1, 1, 0, 1, 1, 1, 0, 1, 1, 1, 1, 0, 0, 1},
         {1, 2, 3, -1},
         1},
        {1, 2, 1, KERN_LP_OPTIMAL, {1, -1, 1}, {1, 1}, 1}, /* a ray */
        {1, 2, 1, KERN_LP_UNBOUNDED, {1, -1, 1}, {-1, -1}, 0},
        {1, 2, 0, KERN_LP_OPTIMAL, {1, -1, 1}, {0}, 0},
        {2, 2, 1, KERN_LP_OPTIMAL, {0}, {1, 1}, 0},
        {2, 2, 1, KERN_LP_UNBOUNDED, {0}, {-1, -1}, 0},
    };
    static const double nothing[] = {0}, something[] = {2};
    program p;
    size_t i;
    int got;
    for (i = 0; i < sizeof kind / sizeof *kind; i++) {
        sprintf(context, "(program %d)", (int)i);
        program_set(&p, kind[i].rows, kind[i].cols, kind[i].table,
                    kind[i].with_cost ? kind[i].cost : NULL);
        CHECK_INT(program_solve(&p), kind[i].want);
        if (kind[i].want == KERN_LP_OPTIMAL && kind[i].with_cost)
            CHECK_NEAR(program_cost(&p), kind[i].least, 1e3 * EPS);
    }
    context[0] = 0;
    /* no columns: solved where the right-hand side is zero, or not taken */
    program_set(&p, 1, 0, nothing, NULL);
    got = program_solve(&p);
    CHECK(got == KERN_LP_OPTIMAL || got == KERN_BAD_COUNT);
    program_set(&p, 1, 0, something, NULL);
    got = program_solve(&p);
    CHECK(got == KERN_LP_INFEASIBLE || got == KERN_BAD_COUNT);
}

/* ---- the twin: all bases ----------------------------------------- >>bases */

/* Row reduction from row `from`, column j: the largest of the column comes to
   row `from`, and the column becomes 0 in the others, or only below. Zero: the
   column has no pivot. */
static int eliminate(double *t, int rows, int cols, int from, int j, int below)
{
    const int wide_row = cols + 1;
    int i, k, pivot = from;
    for (i = from; i < rows; i++)
        if (fabs(t[i * wide_row + j]) > fabs(t[pivot * wide_row + j]))
            pivot = i;
    if (fabs(t[pivot * wide_row + j]) < 1e-9)
        return 0;
    for (k = 0; k <= cols; k++) {
        const double keep = t[pivot * wide_row + k];
        t[pivot * wide_row + k] = t[from * wide_row + k];
        t[from * wide_row + k] = keep;
    }
    for (i = below ? from + 1 : 0; i < rows; i++)
        if (i != from) {
            const double h = t[i * wide_row + j] / t[from * wide_row + j];
            for (k = 0; k <= cols; k++)
                t[i * wide_row + k] -= h * t[from * wide_row + k];
        }
    return 1;
}

/* Cost of the basic solution of the chosen columns; zero: there is none. */
static int basic_solution(int rank, int cols, const double *t,
                          const int *choice, const double *cost, double *sum)
{
    double b[(LP_ROWS + 1) * (LP_ROWS + 2)];
    int i, j, k;
    for (i = 0; i < rank; i++) {
        for (k = 0; k < rank; k++)
            b[i * (rank + 1) + k] = t[i * (cols + 1) + choice[k]];
        b[i * (rank + 1) + rank] = t[i * (cols + 1) + cols];
    }
    for (j = 0; j < rank; j++)
        if (!eliminate(b, rank, rank, j, j, 0))
            return 0;
    *sum = 0;
    for (i = 0; i < rank; i++) {
        const double x = b[i * (rank + 1) + rank] / b[i * (rank + 1) + i];
        if (!(x > -1e-9))
            return 0;
        *sum += cost[choice[i]] * x;
    }
    return 1;
}

/* The next choice of `rank` of the columns, in lexical order; zero: none. */
static int next_choice(int *choice, int rank, int cols)
{
    int i, k;
    for (i = rank - 1; i >= 0 && choice[i] == cols - rank + i; i--)
        ;
    if (i < 0)
        return 0;
    choice[i]++;
    for (k = i + 1; k < rank; k++)
        choice[k] = choice[k - 1] + 1;
    return 1;
}

/* Least cost over all basic solutions of A x = rhs, x >= 0 (columns j of
   `table`, rows x (cols + 1)), by trying every choice of independent columns.
   *found tells whether there is any. Row reduction first, so that redundant
   rows do no harm. Small whole numbers: 1e-9 is far below any true value. */
static double all_bases(int rows, int cols, const double *table,
                        const double *cost, int *found)
{
    double t[(LP_ROWS + 1) * (LP_COLS + 1)], best = 0, sum;
    int i, j, rank = 0, choice[LP_ROWS + 1];
    memcpy(t, table, sizeof *t * (size_t)(rows * (cols + 1)));
    *found = 0;
    for (j = 0; j < cols && rank < rows; j++)
        rank += eliminate(t, rows, cols, rank, j, 1);
    for (i = rank; i < rows; i++)
        if (fabs(t[i * (cols + 1) + cols]) > 1e-9)
            return 0;
    for (i = 0; i < rank; i++)
        choice[i] = i;
    do
        if (basic_solution(rank, cols, t, choice, cost, &sum)
            && (!*found || sum < best)) {
            best = sum;
            *found = 1;
        }
    while (next_choice(choice, rank, cols));
    return best;
}

/* Small whole numbers; some rows follow from others, or are degenerate. */
static void random_table(int rows, int cols, double *table)
{
    int i, j;
    for (i = 0; i < rows; i++)
        for (j = 0; j <= cols; j++)
            table[i * (cols + 1) + j] = chance(0.3) ? 0 : random_int(-4, 4);
    if (rows > 1 && chance(0.3)) /* a row that says nothing new */
        for (j = 0; j <= cols; j++)
            table[(rows - 1) * (cols + 1) + j] = 2 * table[j]
                                               - (rows > 2 ? table[cols + 1 + j]
                                                           : 0);
    if (chance(0.5)) /* degenerate */
        for (i = 0; i < rows; i++)
            table[i * (cols + 1) + cols] = chance(0.7)
                                             ? 0
                                             : table[i * (cols + 1) + cols];
}

/* Is there a ray of falling cost? It is cut at a sum of one. */
static int cost_falls(int rows, int cols, const double *table,
                      const double *cost)
{
    double ray[(LP_ROWS + 1) * (LP_COLS + 1)], down;
    int i, j, found;
    for (i = 0; i <= rows; i++)
        for (j = 0; j <= cols; j++)
            ray[i * (cols + 1) + j] = i < rows
                                        ? (j < cols ? table[i * (cols + 1) + j]
                                                    : 0)
                                        : 1;
    down = all_bases(rows + 1, cols, ray, cost, &found);
    return found && down < -1e-9;
}

static void lp_random(void)
{
    int trial, counts[3] = {0, 0, 0};
    for (trial = 0; trial < 4000; trial++) {
        double table[(LP_ROWS + 1) * (LP_COLS + 1)], cost[LP_COLS], best;
        program p;
        int rows, cols, j, found, got, want;
        random_seed(31u + (unsigned long long)trial);
        sprintf(context, "(program %d)", trial);
        rows = random_int(1, 4);
        cols = random_int(1, 8);
        random_table(rows, cols, table);
        for (j = 0; j < cols; j++)
            cost[j] = random_int(-3, 5);
        best = all_bases(rows, cols, table, cost, &found);
        want = !found                              ? KERN_LP_INFEASIBLE
             : cost_falls(rows, cols, table, cost) ? KERN_LP_UNBOUNDED
                                                   : KERN_LP_OPTIMAL;
        program_set(&p, rows, cols, table, cost);
        got = program_solve(&p);
        CHECK_INT(got, want);
        if (got == KERN_LP_OPTIMAL && want == KERN_LP_OPTIMAL)
            CHECK_NEAR(program_cost(&p), best,
                       (SINGLE ? 1e-4 : 1e-9) * (1 + fabs(best)));
        counts[want - KERN_LP_OPTIMAL]++;
        /* the same without a cost: only whether there is a solution */
        program_set(&p, rows, cols, table, NULL);
        CHECK_INT(program_solve(&p),
                  found ? KERN_LP_OPTIMAL : KERN_LP_INFEASIBLE);
    }
    context[0] = 0;
    CHECK(counts[0] > 200 && counts[1] > 200 && counts[2] > 200);
}

/* A random program that has a solution. */
static void program_random(program *p)
{
    double table[LP_ROWS * (LP_COLS + 1)], cost[LP_COLS];
    const int m = random_int(2, LP_ROWS), n = random_int(m, LP_COLS);
    int i, j;
    for (j = 0; j < n; j++)
        cost[j] = uniform(0, 1);
    for (i = 0; i < m; i++) {
        double *row = table + i * (n + 1);
        row[n] = 0;
        for (j = 0; j < n; j++) {
            row[j] = uniform(-1, 1);
            row[n] += j % 3 ? 0 : row[j]; /* 1 in every third one */
        }
    }
    program_set(p, m, n, table, cost);
}

/* The same program with rows and columns in other units. */
static void program_scaled(program *t, const program *p)
{
    const double most = SINGLE ? 2 : 6;
    int i, j;
    *t = *p;
    t->lp.a = t->a;
    t->lp.rhs = t->rhs;
    t->lp.cost = t->cost;
    for (i = 0; i < p->lp.rows; i++) {
        const double unit = pow(10, uniform(-most, most));
        t->rhs[i] *= R(unit);
        for (j = 0; j < p->lp.cols; j++)
            t->a[j * p->lp.rows + i] *= R(unit);
    }
    for (j = 0; j < p->lp.cols; j++) {
        const double unit = pow(10, uniform(-most, most));
        t->cost[j] *= R(unit);
        for (i = 0; i < p->lp.rows; i++)
            t->a[j * p->lp.rows + i] *= R(unit);
    }
}

/* Units do not matter: with rows and columns in other ones an answer is the
   same, or there is none. */
static void lp_scaled(void)
{
    static kern_real real[KERN_LP_REALS(LP_ROWS, LP_COLS)];
    static int index[KERN_LP_INTS(LP_ROWS, LP_COLS)];
    program p, t;
    int k, j, answers = 0;
    for (k = 0; k < 400; k++) {
        kern_work work = kern_work_of(real, KERN_LP_REALS(LP_ROWS, LP_COLS),
                                      index, KERN_LP_INTS(LP_ROWS, LP_COLS));
        double primal = 0;
        int got;
        random_seed(31000u + (unsigned long long)k);
        program_random(&p);
        if (program_solve(&p) != KERN_LP_OPTIMAL)
            continue;
        program_scaled(&t, &p);
        got = kern_lp_solve(&t.lp, t.x, t.y, &work);
        if (got < 0)
            continue;
        answers++;
        CHECK_INT(got, KERN_LP_OPTIMAL);
        for (j = 0; j < t.lp.cols; j++)
            primal += (double)t.cost[j] * (double)t.x[j];
        CHECK_NEAR(primal, program_cost(&p),
                   (SINGLE ? 1e-2 : 1e-6) * (1 + program_cost(&p)));
    }
    CHECK(answers > 20);
}

/* A variable that is rounding beside another is kept where a row needs it. */
static void lp_small_beside_large(void)
{
    const double unit = SINGLE ? 1e2 : 1e6;
    const double rows[] = {1 / unit, 0, 1e3, 0, unit, 1};
    program p;
    program_set(&p, 2, 2, rows, NULL);
    CHECK_INT(program_solve(&p), KERN_LP_OPTIMAL);
    CHECK_NEAR(p.x[0], 1e3 * unit, 1e3 * unit * 8 * EPS);
    CHECK_NEAR(p.x[1], 1 / unit, 8 * EPS / unit);
}

/* Rows that differ by 1e-10 have no common solution; a ray along which the
   cost falls is found. */
static void lp_small_rows_and_rays(void)
{
    static const double rows[] = {1, 1, 1e-10, 2e-10};
    static const double free_ray[] = {
        1, 0, 0, -1, -1, 1, 1,  1, 0, -1, 1, 0,  1, 0,  0,  -1, 1,  1,  0,
        0, 0, 0, 0,  -1, 1, 0,  1, 0, 0,  0, -1, 0, 1,  -1, -1, -1, -1, 1,
        1, 1, 0, 0,  -1, 0, -1, 0, 0, 1,  1, 1,  1, -1, 1,  1,  -1, 0};
    static const double free_cost[] = {-2, 3,  -2, 5,  4,  -2, 3,
                                       2,  -1, 1,  -1, -2, -2};
    program p;
    program_set(&p, 2, 1, rows, NULL);
    CHECK(program_solve(&p) != KERN_LP_OPTIMAL);
    program_set(&p, 4, 13, free_ray, free_cost);
    CHECK_INT(program_solve(&p), KERN_LP_UNBOUNDED);
}

static const double small_program[] = {1, 1, 2, 1, -1, 0};
static const double small_cost[] = {1, 1};

static void lp_bad_input(void)
{
    static kern_real real[KERN_LP_REALS(2, 2)];
    static int index[KERN_LP_INTS(2, 2)];
    kern_work work = kern_work_of(real, KERN_LP_REALS(2, 2), index,
                                  KERN_LP_INTS(2, 2));
    program p;
    int i, j;
    for (i = 0; i < 4 + 2 + 2; i++)
        for (j = 0; j < 2; j++) {
            program_set(&p, 2, 2, small_program, small_cost);
            *(i < 4   ? &p.a[i]
              : i < 6 ? &p.rhs[i - 4]
                      : &p.cost[i - 6]) = R(no_number(j));
            CHECK_INT(program_solve(&p), KERN_BAD_NUMBER);
        }
    for (i = 0; i < 4; i++) {
        program_set(&p, 2, 2, small_program, small_cost);
        p.lp.rows = i == 0 ? -1 : 2;
        p.lp.cols = i == 1 ? -1 : 2;
        p.lp.a = i == 2 ? NULL : p.a;
        p.lp.rhs = i == 3 ? NULL : p.rhs;
        CHECK_INT(program_solve(&p), i < 2 ? KERN_BAD_COUNT : KERN_BAD_POINTER);
    }
    program_set(&p, 2, 2, small_program, small_cost);
    CHECK_INT(kern_lp_solve(NULL, p.x, p.y, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, NULL, p.y, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, p.x, NULL, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_lp_solve(&p.lp, p.x, p.y, NULL), KERN_BAD_POINTER);
}

/* Every size of the work arrays; what lies behind them stays as it was. */
static void lp_every_size(void)
{
    enum { REALS = KERN_LP_REALS(2, 2), INTS = KERN_LP_INTS(2, 2) };
    static kern_real real[REALS + GUARD];
    static int index[INTS + GUARD];
    program p;
    int array, size, enough = 0;
    program_set(&p, 2, 2, small_program, small_cost);
    for (array = 0; array < 2; array++) {
        const int need = array ? INTS : REALS;
        for (size = 0; size <= need; size++) {
            kern_work work = kern_work_of(real, array ? REALS : size, index,
                                          array ? size : INTS);
            int got;
            guard_fill(real, REALS, index, INTS);
            got = kern_lp_solve(&p.lp, p.x, p.y, &work);
            CHECK(got == KERN_NO_SPACE || got == KERN_LP_OPTIMAL);
            enough += got == KERN_LP_OPTIMAL;
            if (size == need)
                CHECK_INT(got, KERN_LP_OPTIMAL);
            if (size == 0)
                CHECK_INT(got, KERN_NO_SPACE);
            CHECK(guard_holds(&work, REALS, INTS));
        }
    }
    CHECK(enough >= 2);
}

/* ==== Verdicts and proofs ========================================= >>proof */

/* A cube of weight W = 9.81 shifted by s on a fixed one. */
static void shifted_cube(world *w, double s)
{
    world_reset(w);
    world_box(w, 0, 0, 0, 1, 1);
    world_box(w, 1, s, 1, 1 + s, 2);
    world_touch(w);
}

static void proof_forces_of_a_cube(void)
{
    static world w;
    double sum = 0, torque = 0;
    int k;
    shifted_cube(&w, 0);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    for (k = 0; k < w.contacts; k++) {
        const double sign = w.contact[k].b == 1 ? 1 : -1;
        sum += (double)force_of[k].normal * (double)w.contact[k].n.y * sign
             + (double)force_of[k].tangential * (double)w.contact[k].n.x * sign;
        torque += (double)force_of[k].normal * ((double)w.contact[k].p.x - 0.5);
    }
    CHECK_NEAR(sum, 9.81, 9.81 * PROOF_TOL);
    CHECK_NEAR(torque, 0, 9.81 * PROOF_TOL);
}

static void proof_free_fall(void)
{
    static world w;
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(&w), 0);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_NEAR(motion_of[0].vy, -1, 100 * EPS);
    CHECK_NEAR(motion_of[0].vx, 0, 1e-6);
    /* neither gravity nor a load: forgotten, most likely */
    w.gravity = vec(0, 0);
    CHECK_INT(verdict(&w, 0), KERN_NO_LOAD);
    kern_block_load(&w.block[0], vec(0, 0), vec(0, 0), R(1));
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK(motion_of[0].spin > 0);
    /* arrays for proofs may be missing, one or both */
    {
        kern_work work = work_of(&w);
        kern_proof none;
        none.force = NULL;
        none.motion = NULL;
        CHECK_INT(kern_verdict(world_task(&w, &work), 0, &none), KERN_FALLS);
        CHECK_INT(kern_verdict(world_task(&w, &work), 0, NULL), KERN_FALLS);
    }
}

/* Which way it goes: a cube beyond the edge turns about the edge, on a slope
   it slides along the slope. */
static void proof_motions_of_a_cube(void)
{
    static world w;
    double foot_x, foot_y;
    shifted_cube(&w, 0.75);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_NEAR(motion_of[0].vx, 0, 0);
    CHECK_NEAR(motion_of[0].vy, 0, 0);
    CHECK_NEAR(motion_of[0].spin, 0, 0);
    CHECK(motion_of[1].vy < 0);
    /* the corner of the lower cube at (1, 1) is not entered */
    foot_x = (double)motion_of[1].vx - (double)motion_of[1].spin * (1 - 1.5);
    foot_y = (double)motion_of[1].vy + (double)motion_of[1].spin * (1 - 1.25);
    CHECK(foot_y >= 0.4 * fabs(foot_x) - 1e-5);
}

/* Damages one contact's force, in the way of a trial 0 .. 7. */
static void damage_forces(const world *w, kern_force *f, int trial, double by)
{
    const int k = random_int(0, w->contacts - 1);
    const double push = by * (double)own_total(w);
    if (trial < 4)
        f[k].normal += R(push);
    else if (trial < 6)
        f[k].tangential += R(push);
    else if (trial == 6)
        f[k].normal = R(-1e-6);
    else
        f[k].tangential = R(not_a_number());
}

/* Damages one block's motion, or that of all, in the way of a trial 0 .. 7. */
static void damage_motion(const world *w, kern_motion *y, int trial, double by)
{
    int k;
    do
        k = random_int(0, w->blocks - 1);
    while (w->block[k].fixed);
    if (trial < 2)
        y[k].vx += R(by);
    else if (trial < 4)
        y[k].vy += R(by);
    else if (trial == 4)
        y[k].spin += R(by);
    else if (trial == 5)
        for (k = 0; k < w->blocks; k++) {
            y[k].vx = -y[k].vx;
            y[k].vy = -y[k].vy;
            y[k].spin = -y[k].spin;
        }
    else if (trial == 6)
        memset(y, 0, sizeof *y * (size_t)w->blocks);
    else
        y[k].spin = R(huge_value());
}

/* What the speeds of a motion at the contacts lose by roundings in the library's
   precision, in its measure of a proof: a share of what is allowed. */
static double rounded_share(const world *w, const kern_motion *y)
{
    wide power = 0, weight = 0, most = 0;
    int i, k, end;
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        if (b->fixed)
            continue;
        weight += own_weight(w, i);
        power += ((wide)b->mass * w->gravity.x + b->load.fx) * y[i].vx
               + ((wide)b->mass * w->gravity.y + b->load.fy) * y[i].vy
               + (wide)b->load.torque * y[i].spin;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        wide gap = 0;
        for (end = 0; end < 2; end++) {
            const kern_motion *v = &y[end ? c->b : c->a];
            const kern_vec centre = w->block[end ? c->b : c->a].centre;
            gap += fabs((double)v->vx) + fabs((double)v->vy)
                 + fabs((double)v->spin)
                       * (fabs((double)(c->p.x - centre.x))
                          + fabs((double)(c->p.y - centre.y)));
        }
        gap *= (1 + c->mu) * 4;
        most = gap > most ? gap : most;
    }
    return power > 0
             ? (double)((SINGLE ? 1e3 : 1e6) * weight * EPS * most / power)
             : huge_value();
}

/* A damaged proof, measured by the test (*own) and by the library (*theirs).
   Nonzero: there is nothing to damage, or roundings decide. */
static int damaged(const world *w, int verdict_was, int trial, double *own,
                   double *theirs)
{
    static kern_force f[MAX_POINTS];
    static kern_motion y[MAX_BLOCKS];
    kern_work work = work_of(w);
    const double by = pow(10, uniform(-14, 0)) * (chance(0.5) ? 1 : -1);
    if (verdict_was == KERN_STANDS) {
        if (w->contacts == 0)
            return 1;
        memcpy(f, force_of, sizeof *f * (size_t)w->contacts);
        damage_forces(w, f, trial, by);
        *own = share_of_forces(w, 0, f);
        *theirs = (double)kern_check_forces(world_task(w, &work), 0, f);
    } else {
        memcpy(y, motion_of, sizeof *y * (size_t)w->blocks);
        damage_motion(w, y, trial, by);
        *own = share_of_motion(w, 0, y);
        *theirs = (double)kern_check_motion(world_task(w, &work), 0, y);
        return *own < 0.5 && rounded_share(w, y) > 0.5;
    }
    return 0;
}

/* Damage is found, by the measure of the test's own check. */
static void proof_damage(void)
{
    static world w;
    int seed, trial, good = 0, bad = 0;
    for (seed = 0; seed < 400; seed++) {
        int got;
        random_world(&w, 500000u + (unsigned long long)seed, 12);
        got = verdict(&w, 0);
        for (trial = 0; trial < 8; trial++) {
            double own, theirs;
            if (damaged(&w, got, trial, &own, &theirs))
                continue;
            /* between a half and twice the allowed, roundings may decide */
            if (own < 0.5 && !(SINGLE && own > 1e-3)) {
                CHECK(theirs <= 1);
                good++;
            }
            if (own > (SINGLE ? 20 : 2)) {
                CHECK(theirs > 1);
                bad++;
            }
        }
    }
    context[0] = 0;
    CHECK(good > 100 && bad > 500);
}

/* A fixed block that moves proves nothing. */
static void proof_of_a_fixed_block(void)
{
    static world w;
    kern_work work;
    shifted_cube(&w, 0.75);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    work = work_of(&w);
    motion_of[0].vx = R(1e-3);
    CHECK(kern_check_motion(world_task(&w, &work), 0, motion_of) > 1);
}

/* Forces of the right sum that the bodies could never press: too large. */
static void proof_too_large(void)
{
    static world w;
    kern_force f[4];
    kern_work work;
    int side, k;
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 0, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 4);
    world_friction(&w, 1);
    work = work_of(&w);
    for (side = 0; side < 2; side++) {
        const double press = (side ? 100 : 0.05) * FORCE_BOUND * W;
        for (k = 0; k < 4; k++) {
            /* normals are horizontal: t is up where n points right */
            const double up = (w.contact[k].b == 1 ? 1 : -1)
                            * (double)w.contact[k].n.x;
            f[k].normal = R(press);
            f[k].tangential = R(W / 4 * up);
        }
        CHECK_INT(kern_check_forces(world_task(&w, &work), 0, f) <= 1, !side);
    }
}

/* ==== Proofs of the last digits ================================== >>digits */

/* share_of_motion() without allowance: of the numbers that the library was
   given, in an arithmetic in which their rounding is none. */
static double strict_share(const world *w, double d, const kern_motion *motion)
{
    const double mean = mean_size(w);
    wide power = 0, against = 0, weight = 0;
    int i, k, side, end;
    for (i = 0; i < w->blocks; i++) {
        const kern_block *b = &w->block[i];
        const kern_motion *v = &motion[i];
        const wide part = ((wide)b->mass * w->gravity.x + b->load.fx) * v->vx
                        + ((wide)b->mass * w->gravity.y + b->load.fy) * v->vy
                        + (wide)b->load.torque * v->spin;
        if (b->fixed)
            continue;
        if (v->vx < 0 || v->vx > 0 || v->vy < 0 || v->vy > 0 || v->spin < 0
            || v->spin > 0)
            weight += own_weight(w, i);
        power += part;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_contact *c = &w->contact[k];
        const wide own = fabs((double)c->travel) < 1e-9 * mean ? 0 : c->travel;
        const wide s = own_slide(own, (wide)d, w->options.relative);
        wide rx = 0, ry = 0;
        for (end = 0; end < 2; end++) {
            const int j = end ? c->b : c->a;
            const kern_motion *v = &motion[j];
            const kern_vec o = w->block[j].centre;
            rx = v->vx - v->spin * ((wide)c->p.y - o.y + s * c->n.x) - rx;
            ry = v->vy + v->spin * ((wide)c->p.x - o.x - s * c->n.y) - ry;
        }
        for (side = -1; side <= 1; side += 2) {
            const wide shut = side * (wide)c->mu * (ry * c->n.x - rx * c->n.y)
                            - rx * c->n.x - ry * c->n.y;
            against = shut > against ? shut : against;
        }
    }
    return power > 0 ? (double)((wide)FORCE_BOUND * weight * against / power)
                     : huge_value();
}

/* Every motion accepted just beyond the margin is one without rounding too. */
static void strict_motions(world *w)
{
    const kern_proof proof = proof_here();
    const double mean = w->options.relative ? 1 : mean_size(w);
    const double unit = SINGLE ? 1e-4 : 1e-11;
    kern_work work = work_of(w);
    kern_margin m;
    int k;
    world_touch(w);
    if (kern_measure(world_task(w, &work), &m, NULL) != KERN_STANDS)
        return;
    for (k = -20; k <= 200; k++) {
        const kern_real d = R((double)m.margin + k * unit * mean);
        if (kern_verdict(world_task(w, &work), d, &proof) == KERN_FALLS)
            CHECK(strict_share(w, (double)d, motion_of) <= 1 + 1e-6);
    }
}

static void proof_without_rounding(void)
{
    /* clang-format off */
    static const double turned[] = {
        2.95888096364245, 0, 3.995178370686835, 0, 5, 0, 5, 0.9575368596071754,
        4.0325608030101785, 1.024719457953587, 2.9923412409437704,
        1.021428540435464};
    /* clang-format on */
    /* clang-format off */
    static const double upper[] = {
        0, 1.0101624356398868, 0.9760333529370225, 1.0186265482993435,
        1.9685798551100973, 0.9963834993000589, 2.000124195517344,
        2.038238484334806, 2.0263384679946204, 2.9752005977606184,
        1.0471287107056582, 3.006636593821413};
    /* clang-format on */
    /* clang-format off */
    static const double lower[] = {
        0, 0, 0.9693282853377662, 0, 2.029722807360566, 0, 1.9685798551100973,
        0.9963834993000589, 0.9760333529370225, 1.0186265482993435, 0,
        1.0101624356398868};
    /* clang-format on */
    static world w;
    int seed, relative;
#if !defined(KERN_SINGLE) && LDBL_MANT_DIG < 60
    return; /* long double would round as the library does */
#endif
    for (relative = 0; relative < 2; relative++) {
        world_reset(&w);
        w.options.mu = R(0.7);
        w.options.relative = relative;
        world_box(&w, 0, -1, -1, 6, 0);
        world_polygon(&w, 1, turned, 6);
        strict_motions(&w);
        world_reset(&w);
        w.options.relative = relative;
        world_box(&w, 0, -1, -1, 7, 0);
        world_polygon(&w, 1, upper, 6);
        world_polygon(&w, 1, lower, 6);
        kern_block_load(&w.block[2], vec(2.331164152285308, 0.7769891002595068),
                        vec(0.7978817221925798, 0.7525462368403466), 0);
        strict_motions(&w);
    }
    for (seed = 0; seed < 60; seed++) {
        random_of_kind(&w, 995000u + (unsigned long long)seed, 5, KINDS);
        strict_motions(&w);
    }
    context[0] = 0;
}

/* An arch of three, leaning at a thousand kilometres from the origin: from each
   joint, a point inside and one outside, to the next. */
static void proof_far_away(void)
{
    static const double joint[][4] = {{1000006.85734197, 1000.1728159780357,
                                       1000007.5851202048, 1000.3435271441456},
                                      {1000006.6543420705, 1003.1726144780692,
                                       1000007.0821204553, 1003.343025644229},
                                      {1000001.119489143, 1007.2861243280652,
                                       1000001.2061444587, 1007.7383689172251},
                                      {999996.3914897689, 1006.4279008636657,
                                       999996.1739658307, 1006.8337550843848},
                                      {999993.1862584405, 1002.8255061236022,
                                       999992.8068576313, 1003.0864454616521},
                                      {999992.98925854, 999.8253076236354,
                                       999992.3098578807, 1000.0859469617354}};
    static const int from[] = {0, 4, 1, 2, 3}; /* the supports first */
    int k;
    static world w;
#if defined(KERN_SINGLE) || LDBL_MANT_DIG < 60
    return;
#endif
    world_reset(&w);
    w.options.mu = R(5);
    w.gravity = vec(0.009809998365000083, -9.80999509500041);
    for (k = 0; k < 5; k++) {
        const double *p = joint[from[k]], *q = joint[from[k] + 1];
        const double xy[] = {p[0], p[1], p[2], p[3], q[2], q[3], q[0], q[1]};
        world_polygon(&w, k > 1, xy, 4);
    }
    strict_motions(&w);
}

/* What is not a number proves nothing. */
static void proof_of_no_numbers(void)
{
    static world w;
    kern_force force[4];
    kern_motion motion[2];
    kern_work work;
    int i, k;
    world_reset(&w);
    world_box(&w, 0, -5, -1, 5, 0);
    world_box(&w, 2400, 0, 0, 2, 1);
    world_touch(&w);
    CHECK_INT(w.contacts, 2);
    work = work_of(&w);
    for (i = 0; i < 3; i++) {
        const kern_real bad = R(no_number(i));
        memset(force, 0, sizeof force);
        memset(motion, 0, sizeof motion);
        for (k = 0; k < 3; k++) { /* no force, the half, all on one end */
            force[0].normal = R(k * 2400 * 9.81);
            CHECK_NEAR(kern_check_forces(world_task(&w, &work), bad, force),
                       huge_value(), 0);
            CHECK(!(kern_check_forces(world_task(&w, &work), 0, force) <= 1));
        }
        motion[1].vy = R(-1); /* into the ground */
        motion[1].spin = R(0.001);
        CHECK_NEAR(kern_check_motion(world_task(&w, &work), bad, motion),
                   huge_value(), 0);
        for (k = 0; k < 3; k++) {
            memset(force, 0, sizeof force);
            memset(motion, 0, sizeof motion);
            force[0].normal = force[1].normal = R(2400 * 9.81);
            *(k ? &force[1].normal : &force[0].tangential) = bad;
            motion[1].vy = R(1);
            *(k == 0   ? &motion[1].vx
              : k == 1 ? &motion[1].vy
                       : &motion[1].spin) = bad;
            CHECK_NEAR(kern_check_forces(world_task(&w, &work), 0, force),
                       huge_value(), 0);
            CHECK_NEAR(kern_check_motion(world_task(&w, &work), 0, motion),
                       huge_value(), 0);
        }
    }
}

/* A stone in mid-air neither stands nor falls if its weight has no square. */
static void proof_out_of_bounds(void)
{
    static const double ground[] = {-1, -1, 1, -1, 0, -0.5};
    static const double masses[] = {1e160, 1e155, 1e300, 1e61, 1e-61, 1e-200};
    static const double loads[] = {-1e200, -1e61, 1e-61, 1e-200};
    const double most = SINGLE ? 1e10 : 1e60;
    static world w;
    kern_structure s;
    kern_work work;
    int i, k;
    for (i = 0; i < 6 + 4; i++) {
        world_reset(&w);
        world_polygon(&w, 0, ground, 3);
        world_box(&w, 1, 0, 5, 1, 6);
        s = structure_of(&w);
        work = work_of(&w);
        if (i < 6) {
            if (SINGLE && !(masses[i] > 1e-30 && masses[i] < 1e30))
                continue;
            w.block[1].mass = R(masses[i]);
        } else {
            if (SINGLE && !(fabs(loads[i - 6]) < 1e30))
                continue;
            s.gravity = vec(0, 0);
            kern_block_load(&w.block[1], vec(0, loads[i - 6]), vec(0.5, 5.5),
                            0);
            if (!(fabs((double)w.block[1].load.fy) > 0))
                continue;
        }
        CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
                  i < 6 ? KERN_BAD_MASS : KERN_BAD_NUMBER);
        CHECK_INT(work.fault.block, 1);
    }
    /* within the bounds: falls, or stands on a bed, as it would in newtons */
    for (i = 0; i < 2; i++)
        for (k = 0; k < 2; k++) {
            world_reset(&w);
            world_box(&w, 0, -1, -1, 2, 0);
            world_box(&w, 1, 0, i, 1, i + 1);
            world_touch(&w);
            w.block[1].mass = R(k ? 0.1 * most : 10 / most);
            CHECK_INT(verdict(&w, 0), i ? KERN_FALLS : KERN_STANDS);
        }
}

/* Sizes: the centre of mass is right, or there is a status. */
static void proof_of_small_stones(void)
{
    const double shape[8] = {0, 0, 3, 0, 3, 1, 0, 1};
    int e;
    for (e = 0; e > -300; e--) {
        const double unit = pow(10, e);
        kern_vec v[4];
        kern_block b;
        kern_status got;
        int i;
        if (SINGLE && e < -36)
            break;
        for (i = 0; i < 4; i++)
            v[i] = vec(unit * shape[2 * i], unit * shape[2 * i + 1]);
        got = kern_ground_init(&b, v, 4, NULL);
        if (e >= (SINGLE ? -9 : -59))
            CHECK_INT(got, KERN_OK);
        if (got != KERN_OK) {
            CHECK_INT(got, KERN_NO_AREA);
            continue;
        }
        CHECK(e >= (SINGLE ? -10 : -60));
        CHECK_NEAR(b.centre.x / R(unit), 1.5, GEO);
        CHECK_NEAR(b.centre.y / R(unit), 0.5, GEO);
    }
}

/* ==== Level and margin =========================================== >>margin */

static void margin_relative(void)
{
    static world w;
    kern_margin m;
    /* upper bed [.25, 1]: half length .375, and the load is .25 from its end:
       d = 2/3; lower bed: 1/2, and the load of both .375 from its end: 3/4 */
    stack_of_two(&w, 0.25);
    w.options.relative = 1;
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 2. / 3, EXACT);
    CHECK_NEAR(m.most, 1, 0);
    CHECK_NEAR(m.epsilon, R(0.05), 0);
    CHECK_INT(m.level, 14);
    check_bracket(&w, &m);
    stack_of_two(&w, 0);
    w.options.relative = 1;
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(m.level, 21);
}

static void margin_steps(void)
{
    static world w;
    kern_margin m;
    kern_work work;
    static const double steps[] = {0.02, 0.03, 0.07, 0.2, 0.24,
                                   0.26, 0.4,  0.6,  7,   1e-5};
    int k;
    stack_of_two(&w, 0.25);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_NEAR(m.epsilon, 0.02, EPS); /* by default, of the mean size */
    for (k = 0; k < COUNT_OF(steps); k++) {
        double ratio = 0.25 / steps[k];
        if (SINGLE
            && steps[k] < 1e-3) /* 1e-5 is finer than float knows the margin */
            continue;
        w.options.epsilon = R(steps[k]);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK_NEAR(m.margin, 0.25, EXACT);
        /* where d* is a multiple of the step (1e-5), either count is right */
        if (fabs(ratio - floor(ratio + 0.5)) < 1e-9)
            CHECK_NEAR(m.level, ratio + 0.5, 0.51);
        else
            CHECK_INT(m.level, (int)floor(ratio) + 1);
        check_bracket(&w, &m);
    }
    /* a step that needs more than a million levels */
    work = work_of(&w);
    stack_of_two(&w, 0);
    w.options.epsilon = R(0.5 / 2e6);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(SINGLE ? 1e-30 : 1e-300);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(0.5 / 0.9e6);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.level, 900001, 1);
    w.options.epsilon = R(0);
    w.options.relative = 1;
    w.options.epsilon = R(1e-7);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_STEP);
    w.options.epsilon = R(-0.1);
    CHECK_INT(kern_measure(world_task(&w, &work), &m, NULL), KERN_BAD_OPTION);
    /* past closing: the last test is at d_max */
    stack_of_two(&w, 0);
    w.options.epsilon = R(3);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_INT(m.level, 2);
    CHECK(m.saturated);
}

static void margin_ends(void)
{
    static world w;
    kern_margin m;
    /* it does not stand: nothing to shrink */
    shifted_cube(&w, 0.75);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
    CHECK_NEAR(m.most, 0.125, GEO);
    /* no contacts, loads that cancel: saturated at d_max = 0 */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
    CHECK_NEAR(m.most, 0, 0);
    kern_block_load(&w.block[0], vec(0, 9.81), vec(0.5, 0.5), 0);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.margin, 0, 0);
    CHECK_NEAR(m.most, 0, 0);
    /* a block on one point, right above it: nothing shrinks */
    world_reset(&w);
    world_mass(&w, 0, 0, 0, 1);
    world_mass(&w, 1, 0, 1, 1);
    world_point(&w, 0, 1, 0, 1, 0, 0.5);
    world_touch(&w);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.most, 0, 0);
}

/* One stone on three points of one interface, of which the middle one leans:
   it stands, falls and stands again. */
static void margin_not_monotone(void)
{
    static world w, t;
    kern_margin m;
    int found = 0, seed;
    for (seed = 0; seed < 4000 && found < some(40); seed++) {
        double most, d;
        int k, got, verdicts = 0, last = 1;
        random_of_kind(&w, 990000u + (unsigned long long)seed, 3, POINTS);
        if (twin_nested(&w) || twin_shortfall(&w, 0, FORCE_BOUND) > NEAR_LO)
            continue;
        most = twin_most(&w);
        for (k = 1; k <= 60; k++) {
            d = most * k / 60;
            if ((twin_shortfall(&w, d, FORCE_BOUND) <= NEAR_LO) != last) {
                last = !last;
                verdicts++;
            }
        }
        if (verdicts < 2)
            continue;
        found++;
        /* steps of many sizes pass over the losses or meet them */
        for (k = 0; k < 12; k++) {
            world_copy(&t, &w);
            t.options.epsilon = R(most * uniform(0.02, 0.6));
            compare_with_twin(&t, k == 0);
        }
        got = measure(&w, &m);
        CHECK(got == KERN_STANDS ? !m.saturated
                                 : SINGLE && got == KERN_UNDECIDED);
    }
    context[0] = 0;
    CHECK_INT(found, some(40));
}

/* ==== Deficit, load factor, tilt =================================== >>load */

static void deficit_by_hand(void)
{
    static world w;
    double growth;
    /* overhang .1 beyond the half: the bed's end must come out by as much */
    shifted_cube(&w, 0.6);
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, 0.1, SINGLE ? 1e-3 : 1e-6);
    w.options.relative = 1; /* half length .2 */
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, 0.5, SINGLE ? 1e-3 : 1e-6);
    /* stands: nothing is missing */
    shifted_cube(&w, 0.3);
    CHECK_INT(deficit(&w, &growth), KERN_STANDS);
    CHECK_NEAR(growth, 0, 0);
    /* in the air, or sliding, no growth helps */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    shifted_cube(&w, 0);
    w.gravity = vec(9.81 * sin(0.5), -9.81 * cos(0.5)); /* tan .5 = .546 */
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    w.options.relative = 1;
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, huge_value(), 0);
    /* a leaning box of 1 x 2 that topples: the weight passes the end of the
       bed by tan .7 - 1/2 */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 1);
    world_box(&w, 1, 0, 1, 1, 3);
    world_touch(&w);
    world_friction(&w, 1);
    w.gravity = vec(9.81 * sin(0.7), -9.81 * cos(0.7));
    CHECK_INT(deficit(&w, &growth), KERN_FALLS);
    CHECK_NEAR(growth, tan(0.7) - 0.5, SINGLE ? 1e-3 : 1e-6);
}

/* The growth found is the first: a little less falls, it and a bit more
   stands. */
static void deficit_random(void)
{
    static world w;
    int seed, finite = 0;
    for (seed = 0; seed < 600; seed++) {
        double growth, scale;
        int got;
        random_world(&w, 820000u + (unsigned long long)seed, 8);
        scale = w.options.relative ? 1 : mean_size(&w);
        got = deficit(&w, &growth);
        CHECK(decided(got));
        if (got != KERN_FALLS)
            continue;
        CHECK(growth > 0);
        if (isinf(growth)) {
            CHECK(twin_agrees(&w, -(w.options.relative ? 10 : 10 * scale), 0)
                  || !twin_nested(&w));
            continue;
        }
        finite++;
        {
            const double off = (SINGLE ? 1e-2 : 4e-6) * fmax(growth, scale);
            CHECK(twin_agrees(&w, -growth - off, 1));
            CHECK(twin_agrees(&w, -growth + off, 0));
        }
        CHECK(!twin_nested(&w) || twin_agrees(&w, -growth / 2, 0));
    }
    context[0] = 0;
    CHECK(finite > 20);
}

/* A unit cube on a fixed one, shifted by `shift`, pushed by a pattern of loads
   on a block, or (-1) horizontally at its centre. By hand: it slides where the
   push is mu times what presses, and topples about an end of the bed. */
static const struct {
    double shift, mu;
    int block;
    double fx, fy, torque;
    int side;
    double want;
} pushes[] = {
    {0, 0.4, -1, 0, 0, 0, 1, 0.4}, /* slides at mu, to either side */
    {0, 0.4, -1, 0, 0, 0, -1, 0.4},
    {0, 0.4, 1, 2, 0, 0, 1, 0.4 * W / 2},
    {0, 0.4, 1, 0, 0, -1, 1, W / 2},     /* topples when the torque is W / 2 */
    {0, 0.4, 1, 0, 1, 0, 1, W},          /* lifts off */
    {0, 0.4, 1, 0, -1, 0, 1, HUGE_VAL},  /* downward: never */
    {0, 0.4, 0, 100, 0, 0, 1, HUGE_VAL}, /* on the fixed block: never */
    /* it topples sooner to the side it hangs over: the load acts 1/2 above the
       bed, and the weight .1 and .5 from the ends of the bed [.4, 1] */
    {0.4, 5, -1, 0, 0, 0, 1, 0.2},
    {0.4, 5, -1, 0, 0, 0, -1, 1},
};

static void load_by_hand(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    double factor;
    change c = no_change();
    int i;
    for (i = 0; i < COUNT_OF(pushes); i++) {
        const int block = pushes[i].block;
        kern_wrench pattern[2];
        memset(pattern, 0, sizeof pattern);
        if (block >= 0) {
            pattern[block].fx = R(pushes[i].fx);
            pattern[block].fy = R(pushes[i].fy);
            pattern[block].torque = R(pushes[i].torque);
        }
        sprintf(context, "(push %d)", i);
        shifted_cube(&w, pushes[i].shift);
        world_friction(&w, pushes[i].mu);
        CHECK_INT(load_factor(&w, block < 0 ? NULL : pattern, pushes[i].side,
                              &factor),
                  KERN_STANDS);
        CHECK_NEAR(factor, pushes[i].want,
                   isinf(pushes[i].want) ? 0
                   : block < 0           ? EDGE
                                         : EDGE * W);
    }
    context[0] = 0;
    /* gravity turned by a quarter: right is up the page */
    shifted_cube(&w, 0.4);
    c.angle = pi / 2;
    world_changed(&t, &w, &c, order);
    world_friction(&t, 5);
    CHECK_INT(load_factor(&t, NULL, 1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.2, EDGE);
    /* falls with no load at all */
    shifted_cube(&w, 0.75);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_FALLS);
    CHECK_NEAR(factor, -1, 0);
    /* no gravity, no horizontal load */
    shifted_cube(&w, 0);
    w.gravity = vec(0, 0);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_NO_LOAD);
    w.block[1].load.fy = R(-9.81);
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_BAD_OPTION);
}

static void load_beside_others(void)
{
    static world w;
    kern_work work;
    kern_real out = R(-1);
    kern_proof proof = proof_here();
    double factor;
    /* own loads stay while the factor grows */
    shifted_cube(&w, 0);
    kern_block_load(&w.block[1], vec(0.1 * W, 0), vec(0.5, 1.5), R(0));
    CHECK_INT(load_factor(&w, NULL, 1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.3, EDGE);
    CHECK_INT(load_factor(&w, NULL, -1, &factor), KERN_STANDS);
    CHECK_NEAR(factor, 0.5, EDGE);
    /* shrunk by .4 the bed is [.4, .6]: topples at .1 / .5 */
    shifted_cube(&w, 0);
    work = work_of(&w);
    CHECK_INT(kern_load_factor(world_task(&w, &work), R(0.4), KERN_RIGHT, &out,
                               &proof),
              KERN_STANDS);
    CHECK_NEAR(out, 0.2, EDGE);
}

/* A cube on a cube slides at atan(mu) or topples about the end of its bed;
   pressed down by p of its weight, which does not turn, it slides where
   sin a = mu (cos a + p). */
static void tilt_by_hand(void)
{
    const double slide = atan(0.4);
    const struct {
        double shift, mu, press, left, right, tol;
    } cubes[] = {
        {0, 0.4, 0, slide, slide, EDGE},
        {0, 5, 0, pi / 4, pi / 4, EDGE},
        {0.4, 5, 0, atan(1), atan(0.2), EDGE},
        {0, 0.4, 0.5, slide + asin(0.5 * sin(slide)),
         slide + asin(0.5 * sin(slide)), EDGE},
        /* the angle passes a right one, and it never falls where the load
           times sin(atan mu) is more than the weight */
        {0, 0.4, 2.6, slide + asin(2.6 * sin(slide)),
         slide + asin(2.6 * sin(slide)), 10 * EDGE},
        {0, 0.4, 3, pi, pi, 16 * EPS},
    };
    static world w;
    double angle, factor;
    int side, i;
    for (side = -1; side <= 1; side += 2)
        for (i = 0; i < COUNT_OF(cubes); i++) {
            sprintf(context, "(cube %d)", i);
            shifted_cube(&w, cubes[i].shift);
            world_friction(&w, cubes[i].mu);
            kern_block_load(&w.block[1], vec(0, -cubes[i].press * W),
                            vec(0.5, 1.5), R(0));
            CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
            CHECK_NEAR(angle, side > 0 ? cubes[i].right : cubes[i].left,
                       cubes[i].tol);
            if (cubes[i].press > 0)
                continue;
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(tan(angle), factor, 2 * EDGE);
        }
    context[0] = 0;
}

/* A cube in a slot between two walls. */
static void tilt_in_a_slot(void)
{
    static const double slot[] = {-1, -1, 2, -1, 2, 2, 1,  2,
                                  1,  0,  0, 0,  0, 2, -1, 2};
    static world w;
    double angle;
    int side;
    for (side = -1; side <= 1; side += 2) {
        /* with a lid on it stays in */
        world_reset(&w);
        world_polygon(&w, 0, slot, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        world_box(&w, 0, 0, 1, 1, 2);
        world_touch(&w);
        CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
        CHECK_NEAR(angle, pi, 16 * EPS);
        /* without the lid and without friction: falls out past a right angle */
        world_reset(&w);
        world_polygon(&w, 0, slot, 8);
        world_box(&w, 1, 0, 0, 1, 1);
        world_touch(&w);
        world_friction(&w, 0);
        CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
        CHECK_NEAR(angle, pi / 2, EDGE);
        /* falls as it is; no gravity */
        shifted_cube(&w, 0.75);
        CHECK_INT(tilt(&w, side, &angle), KERN_FALLS);
        CHECK_NEAR(angle, -1, 0);
        w.gravity = vec(0, 0);
        w.block[1].load.fy = R(-9.81);
        CHECK_INT(tilt(&w, side, &angle), KERN_BAD_OPTION);
    }
}

/* Under a little less than the load factor it stands, under a bit more it
   falls. */
static void around_load_factor(const world *w, int side, double factor)
{
    static world t;
    const double step = SINGLE ? 1e-2 : 4e-6;
    int i, s;
    for (s = -1; s <= 1; s += 2) {
        const double x = fmax(0, factor + s * step * (1 + factor));
        world_copy(&t, w);
        for (i = 0; i < t.blocks; i++)
            if (!t.block[i].fixed) {
                const double mass = (double)t.block[i].mass;
                t.block[i].load.fx = R(-side * x * mass * (double)w->gravity.y);
                t.block[i].load.fy = R(side * x * mass * (double)w->gravity.x);
            }
        if (s > 0 || factor > step)
            CHECK(twin_agrees(&t, 0, s < 0));
    }
}

/* Without loads tan(tilt) is the load factor. */
static void tilt_and_load_factor(void)
{
    static world w;
    double angle, factor;
    int side, i, k;
    for (k = 0; k < 500; k++) {
        random_world(&w, 860000u + (unsigned long long)k, 10);
        for (i = 0; i < w.blocks; i++)
            memset(&w.block[i].load, 0, sizeof w.block[i].load);
        for (side = -1; side <= 1; side += 2) {
            const int got = load_factor(&w, NULL, side, &factor);
            const int turned_got = tilt(&w, side, &angle);
            CHECK(decided(got) && decided(turned_got));
            if (got < 0 || turned_got < 0)
                continue;
            CHECK_INT(turned_got, got);
            if (got != KERN_STANDS)
                continue;
            if (factor < 50) {
                CHECK_NEAR(tan(angle), factor,
                           (SINGLE ? 2e-2 : 1e-5) * (1 + factor * factor));
                around_load_factor(&w, side, factor);
            } else if (isinf(factor))
                CHECK(angle > 1.57);
        }
    }
    context[0] = 0;
}

/* An arch bridge of 16 voussoirs between springings, its fill as mass, and an
   axle at 13 places on it: under a load 1e-6 below the factor the independent
   solver finds forces, 1e-6 above it none. */
static void axle_on_a_bridge(void)
{
    enum { VOUSSOIRS = 16, PLACES = 13 };
    const double half = 1.2, step = 2 * half / VOUSSOIRS, outer = 1.15;
    const double step_of_load = SINGLE ? 1e-2 : 1e-6;
    static world w, t;
    int i, place, side;
    world_reset(&w);
    w.options.mu = R(0.6);
    for (i = -1; i <= VOUSSOIRS; i++)
        world_voussoir(&w, i < 0 || i == VOUSSOIRS ? 0 : 1,
                       pi / 2 - half + i * step, pi / 2 - half + (i + 1) * step,
                       0.95, outer);
    for (i = 1; i <= VOUSSOIRS; i++) { /* fill up to a level of 1.3 */
        kern_block *b = &w.block[i];
        const double high = 1.3 - (double)b->box.high.y;
        b->mass += R(0.5 * high * (double)(b->box.high.x - b->box.low.x));
    }
    CHECK_INT(world_touch(&w), 2 * (VOUSSOIRS + 1));
    for (place = 0; place < PLACES; place++) {
        const double from = pi / 2 - half * (place - 6) / 9;
        const double x = outer * cos(from), y = outer * sin(from);
        const int at = 1 + (int)((from - (pi / 2 - half)) / step);
        kern_wrench pattern[VOUSSOIRS + 2];
        double factor;
        memset(pattern, 0, sizeof pattern);
        pattern[at].fy = -1;
        pattern[at].torque = R((double)w.block[at].centre.x - x);
        sprintf(context, "(axle %d)", place);
        CHECK_INT(load_factor(&w, pattern, 1, &factor), KERN_STANDS);
        CHECK(factor > 0.01 && factor < 100);
        for (side = -1; side <= 1; side += 2) {
            world_copy(&t, &w);
            kern_block_load(&t.block[at],
                            vec(0, -factor * (1 + side * step_of_load)),
                            vec(x, y), 0);
            CHECK(twin_agrees(&t, 0, side < 0));
        }
    }
    context[0] = 0;
}

/* ==== Plans ======================================================== >>plan */

/* A plan of blocks of a world, with the memory of everything it holds.
   Contacts of blocks without a polygon are appended by hand, as a planner with
   a camera would do it. */
typedef struct site {
    kern_block block[MAX_BLOCKS];
    kern_contact contact[MAX_POINTS];
    kern_motion motion[MAX_BLOCKS];
    kern_force force[MAX_POINTS];
    int number[MAX_BLOCKS]; /* in the world, of the plan's blocks */
    kern_real real[KERN_REALS(MAX_BLOCKS, MAX_POINTS)];
    int index[KERN_INTS(MAX_BLOCKS, MAX_POINTS)];
    kern_work work;
    kern_plan plan;
    const world *w;
} site;

static void site_open(site *p, const world *w)
{
    p->w = w;
    p->work = kern_work_of(p->real, KERN_REALS(MAX_BLOCKS, MAX_POINTS),
                           p->index, KERN_INTS(MAX_BLOCKS, MAX_POINTS));
    p->plan = kern_plan_of(p->block, MAX_BLOCKS, p->contact, MAX_POINTS,
                           kern_known_of(p->motion, p->force), &p->work);
    p->plan.task.options = w->options;
    p->plan.task.s.gravity = w->gravity;
}

/* Where block `number` of the world is in the plan; -1: nowhere. */
static int site_place(const site *p, int number)
{
    int i;
    for (i = 0; i < p->plan.task.s.blocks; i++)
        if (p->number[i] == number)
            return i;
    return -1;
}

static void site_add(site *p, int number)
{
    const world *w = p->w;
    const int last = p->plan.task.s.blocks, before = p->plan.task.s.contacts;
    const int found = kern_plan_add(&p->plan, &w->block[number]);
    int k;
    CHECK(found >= 0);
    CHECK_INT(p->plan.task.s.blocks, last + 1);
    CHECK_INT(p->plan.task.s.contacts, before + found);
    for (k = 0; w->given && k < w->contacts; k++) {
        kern_contact c = w->contact[k];
        const int turned = c.a == number;
        const int other = site_place(p, turned ? c.b : c.a);
        if ((c.a != number && c.b != number) || other < 0)
            continue;
        c.a = turned ? last : other;
        c.b = turned ? other : last;
        p->contact[p->plan.task.s.contacts++] = c;
    }
    p->number[last] = number;
}

/* A plan of the first blocks of a world. */
static void site_with(site *p, const world *w, int blocks)
{
    int i;
    site_open(p, w);
    for (i = 0; i < blocks; i++)
        site_add(p, i);
}

static void site_remove(site *p, int i)
{
    const int blocks = p->plan.task.s.blocks;
    CHECK_INT(kern_plan_remove(&p->plan, i), KERN_OK);
    CHECK_INT(p->plan.task.s.blocks, blocks - 1);
    memmove(p->number + i, p->number + i + 1,
            sizeof *p->number * (size_t)(blocks - 1 - i));
}

/* The plan as a world: its blocks and `more` of those behind them, with
   contacts `points` behind its own. */
static void site_world(const site *p, world *t, int more, int points)
{
    world_reset(t);
    t->blocks = p->plan.task.s.blocks + more;
    t->contacts = p->plan.task.s.contacts + points;
    t->gravity = p->plan.task.s.gravity;
    t->options = p->plan.task.options;
    memcpy(t->block, p->block, sizeof *t->block * (size_t)t->blocks);
    memcpy(t->contact, p->contact, sizeof *t->contact * (size_t)t->contacts);
}

/* What has been found block by block is what is found at once. */
static void site_contacts(const site *p)
{
    static world t;
    int k;
    if (p->w->given || SINGLE) /* in float the rounding of far blocks counts */
        return;
    site_world(p, &t, 0, 0);
    CHECK_INT(world_touch(&t), p->plan.task.s.contacts);
    for (k = 0; k < t.contacts && k < p->plan.task.s.contacts; k++)
        CHECK(same_contact(&t.contact[k], &p->contact[k]));
}

/* An answer about the plan, its proofs in force_of and motion_of, is that of a
   fresh structure: t. */
static int site_answer(const site *p, const world *t, int got,
                       const kern_margin *m, int line)
{
    kern_work work = work_of(t);
    kern_margin n;
    int now;
    check_measure(t, got, m, &p->work);
    if (got == KERN_STANDS)
        CHECK(kern_check_forces(world_task(t, &work), m->holds, force_of) <= 1);
    if (got == KERN_FALLS)
        CHECK(kern_check_motion(world_task(t, &work), 0, motion_of) <= 1);
    if (got == KERN_STANDS && !m->saturated)
        CHECK(kern_check_motion(world_task(t, &work), m->fails, motion_of)
              <= 1);
    now = measure(t, &n);
    same_answer(t, &n, now, m, got, 1, EXACT, line);
    return now;
}

static void site_forget_counts(site *p)
{
    p->work.pivots = p->work.solves = 0;
    p->work.error = 0;
    memset(force_of, 0xff, sizeof force_of);
    memset(motion_of, 0xff, sizeof motion_of);
}

/* kern_measure() of a plan, compared. */
static int site_measure(site *p, kern_margin *m)
{
    static world t;
    const kern_proof proof = proof_here();
    int got;
    memset(m, 0, sizeof *m);
    site_forget_counts(p);
    got = kern_measure(&p->plan.task, m, &proof);
    site_world(p, &t, 0, 0);
    site_answer(p, &t, got, m, __LINE__);
    return got;
}

/* A copy of all that a plan holds, and whether it still is as it was, byte for
   byte. */
static struct {
    kern_plan plan;
    kern_block block[MAX_BLOCKS];
    kern_contact contact[MAX_POINTS];
    kern_motion motion[MAX_BLOCKS];
} site_was;

static void site_keep(const site *p)
{
    memcpy(&site_was.plan, &p->plan, sizeof site_was.plan);
    memcpy(site_was.block, p->block,
           sizeof *p->block * (size_t)p->plan.task.s.blocks);
    memcpy(site_was.contact, p->contact,
           sizeof *p->contact * (size_t)p->plan.task.s.contacts);
    memcpy(site_was.motion, p->motion,
           sizeof *p->motion * (size_t)p->plan.task.s.blocks);
}

static void site_unchanged(const site *p, int line)
{
    const size_t b = (size_t)site_was.plan.task.s.blocks,
                 c = (size_t)site_was.plan.task.s.contacts;
    check_report(
        !memcmp(&p->plan, &site_was.plan, sizeof site_was.plan)
            && !memcmp(p->block, site_was.block, sizeof *p->block * b)
            && !memcmp(p->contact, site_was.contact, sizeof *p->contact * c)
            && !memcmp(p->motion, site_was.motion, sizeof *p->motion * b),
        line, "the plan is as it was", 0, 0, 0);
}

/* kern_plan_bears() beside the margin that kern_plan_try() gave: with proofs,
   and nothing that the plan holds changes. */
static void site_bears(site *p, const kern_block *block, int got,
                       const kern_margin *m, int found)
{
    const kern_proof proof = proof_here();
    const int b = p->plan.task.s.blocks, c = p->plan.task.s.contacts;
    const kern_real aside = R(2e-6) * kern_mean_size(p->block, b + 1);
    kern_structure s = p->plan.task.s;
    int side;
    if (got < 0)
        return;
    s.blocks = b + 1;
    s.contacts = c + found;
    site_keep(p);
    for (side = 0; side < 2; side++) {
        const kern_real at = got == KERN_FALLS ? R(0)
                           : side              ? m->fails + aside
                                  : kern_max(m->holds - aside, R(0));
        const int want = got == KERN_FALLS || side ? KERN_FALLS : KERN_STANDS;
        int said;
        if (side && m->saturated)
            break;
        said = kern_plan_bears(&p->plan, block, at, &proof);
        site_unchanged(p, __LINE__);
        if (SINGLE && said != want) /* both proofs may hold over some way */
            continue;
        CHECK_INT(said, want);
        p->block[b] = *block; /* the proof is of the plan with the block */
        if (said == KERN_STANDS)
            CHECK(
                kern_check_forces(task_of(&s, &p->plan.task.options, &p->work),
                                  at, proof.force)
                <= 1);
        else if (p->w->options.relative == 0)
            CHECK(
                kern_check_motion(task_of(&s, &p->plan.task.options, &p->work),
                                  at, proof.motion)
                    <= 1
                || side);
    }
}

/* kern_plan_try(), compared; and nothing else that the plan holds changes. */
static int site_try(site *p, const kern_block *block, kern_margin *m)
{
    static kern_contact one[MAX_POINTS];
    static world t;
    const kern_proof proof = proof_here();
    const int b = p->plan.task.s.blocks, c = p->plan.task.s.contacts;
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    int got, found, k;
    site_keep(p);
    memset(m, 0, sizeof *m);
    site_forget_counts(p);
    got = kern_plan_try(&p->plan, block, m, &proof);
    site_unchanged(p, __LINE__);
    p->block[b] = *block;
    found = kern_touch(p->block, b, &p->plan.task.options, one, MAX_POINTS,
                       &none);
    if (found < 0) {
        CHECK_INT(got, found);
        CHECK_INT(p->work.fault.block, none.fault.block);
        CHECK_INT(p->work.fault.other, none.fault.other);
        return got;
    }
    for (k = 0; k < found; k++)
        CHECK(same_contact(&p->contact[c + k], &one[k]));
    site_world(p, &t, 1, found);
    site_answer(p, &t, got, m, __LINE__);
    site_bears(p, block, got, m, found);
    return got;
}

/* Stones on points with two normals to an interface: a keel that lies with
   two corners in a notch, and on its flat back the next notched stone. */
static void random_keels(world *w, int pairs)
{
    const double lean = uniform(0.3, 0.9), r = uniform(0.3, 0.6);
    double y = 0, x = 0;
    int i;
    world_box(w, 0, -9, -1, 9, 0);
    for (i = 0; i < pairs; i++) {
        const double high = tan(lean) + uniform(0.1, 0.3);
        const double s = r * sin(lean), c = r * cos(lean);
        double notch[10], keel[8], axis;
        x += uniform(-0.1, 0.1);
        notch[0] = notch[8] = x - 1;
        notch[2] = notch[4] = x + 1;
        notch[1] = notch[3] = y;
        notch[5] = notch[9] = y + high;
        notch[6] = x;
        notch[7] = y + high - tan(lean);
        world_polygon(w, uniform(1, 2), notch, 5);
        axis = notch[7] + r / cos(lean);
        keel[0] = x - s;
        keel[2] = x + s;
        keel[1] = keel[3] = axis - c;
        keel[4] = x + s + uniform(0.05, 0.15);
        keel[6] = x - s - uniform(0.05, 0.15);
        y = fmax(axis, y + high) + 0.3;
        keel[5] = keel[7] = y;
        world_polygon(w, uniform(1, 2), keel, 4);
    }
    CHECK(world_touch(w) > 0);
}

/* Block after block, as they were made or in any order. Before each is added
   it is tried; whether the plan has been measured lately makes no difference
   to any answer. */
static void plan_grow(const world *w, int shuffle)
{
    static site p;
    int order[MAX_BLOCKS], i;
    for (i = 0; i < w->blocks; i++)
        order[i] = i;
    for (i = w->blocks - 1; shuffle && i > 0; i--) {
        const int j = random_int(0, i), keep = order[i];
        order[i] = order[j];
        order[j] = keep;
    }
    site_open(&p, w);
    for (i = 0; i < w->blocks; i++) {
        kern_margin m;
        if (!w->given || chance(0.1)) /* what has no polygon hangs in the air */
            site_try(&p, &w->block[order[i]], &m);
        site_add(&p, order[i]);
        site_contacts(&p);
        if (chance(0.8))
            site_measure(&p, &m);
    }
}

static void plan_random(void)
{
    static world w;
    int seed, kind;
    for (seed = 0; seed < some(120); seed++)
        for (kind = 0; kind < KINDS; kind++) {
            random_of_kind(&w, 700000u + (unsigned long long)seed,
                           seed % 4 ? 12 : 30, kind);
            plan_grow(&w, seed % 2);
        }
    context[0] = 0;
}

static void plan_points(void)
{
    static world w;
    int seed, apart = 0;
    for (seed = 0; seed < some(120); seed++) {
        random_seed(710000u + (unsigned long long)seed);
        sprintf(context, "(keels %d)", seed);
        world_reset(&w);
        w.options.mu = R(uniform(0.2, 1));
        w.options.relative = chance(0.3);
        random_keels(&w, random_int(1, 4));
        if (chance(0.5))
            w.gravity = vec(9.81 * uniform(-0.1, 0.1), -9.81);
        apart += !twin_nested(&w);
        plan_grow(&w, seed % 2);
    }
    context[0] = 0;
    CHECK_INT(apart, some(120));
}

/* Blocks go and come back, wherever they are; every answer is that of a fresh
   structure. */
static void plan_changes(void)
{
    static world w;
    static site p;
    int seed, i, round;
    for (seed = 0; seed < some(240); seed++) {
        kern_margin m;
        random_of_kind(&w, 720000u + (unsigned long long)seed, 25,
                       seed % KINDS);
        site_with(&p, &w, w.blocks);
        for (round = 0; round < 8; round++) {
            int gone[3], n = 0;
            for (i = random_int(1, 3); i > 0 && p.plan.task.s.blocks > 1; i--) {
                const int last = p.plan.task.s.blocks - 1;
                const int at = chance(0.3) ? last
                             : chance(0.3) ? 0
                                           : random_int(0, last);
                gone[n++] = p.number[at];
                site_remove(&p, at);
            }
            if (chance(0.6))
                site_measure(&p, &m);
            while (n > 0)
                site_add(&p, gone[--n]);
            if (chance(0.6))
                site_measure(&p, &m);
            site_contacts(&p);
        }
    }
    context[0] = 0;
}

/* A slab on a pillar: half of the bed less the way from its middle to where
   the load passes. A candidate moves that place, or has a place of its own. */
static void slab_on_pillar(world *w)
{
    world_reset(w);
    world_box(w, 0, -9, -1, 9, 0);
    world_box(w, 1, 0, 0, 1, 1);
    world_box(w, 1, -0.2, 1, 1.4, 1.2);
    world_touch(w);
}

static kern_block candidate(world *w, double density, double x, double y,
                            double size)
{
    const int i = world_box(w, density, x, y, x + size, y + size);
    w->blocks = i;
    return w->block[i];
}

/* The plan of a slab on a pillar, measured. Returns a candidate upon it. */
static kern_block on_slab(world *w, site *p, double x)
{
    kern_block b;
    kern_margin m;
    slab_on_pillar(w);
    b = candidate(w, 1, x, 1.2, 0.2);
    site_with(p, w, w->blocks);
    CHECK_INT(site_measure(p, &m), KERN_STANDS);
    return b;
}

static void plan_candidates(void)
{
    static world w;
    static site p;
    static const struct {
        double density, x, y, margin; /* < 0: it falls */
    } tries[] = {
        {1, 1.2, 1.2, 0.5 - 0.064 / 0.36},  /* lower */
        {1, -0.2, 1.2, 0.5 - 0.008 / 0.36}, /* higher */
        {1, 5, 0, 0.4},                     /* the same */
        {10, 1.2, 1.2, 0.5 - 0.352 / 0.72}, /* hardly any */
        {20, 1.2, 1.2, -1},                 /* over the edge */
        {1, 3, 2, -1},                      /* hangs on nothing */
        {0, 3, 2, 0.4},                     /* so does ground */
    };
    kern_margin m, first;
    int i, round;
    slab_on_pillar(&w);
    site_with(&p, &w, w.blocks);
    for (round = 0; round < 2; round++) { /* of a plan not measured, measured */
        for (i = 0; i < COUNT_OF(tries); i++) {
            const kern_block b = candidate(&w, tries[i].density, tries[i].x,
                                           tries[i].y, 0.2);
            const int got = site_try(&p, &b, &m);
            CHECK_INT(got, tries[i].margin < 0 ? KERN_FALLS : KERN_STANDS);
            if (got == KERN_STANDS)
                CHECK_NEAR(m.margin, tries[i].margin, EXACT);
        }
        CHECK_INT(site_measure(&p, &first), KERN_STANDS);
        CHECK_NEAR(first.margin, 0.4, EXACT);
    }
    for (i = 0; i < 2; i++) {
        const kern_block b = candidate(&w, 1, 1.2, 1.2 - 0.1 * (i + 1), 0.2);
        CHECK_INT(site_try(&p, &b, &m), KERN_OVERLAP);
        CHECK_INT(p.work.fault.block, 2);
        CHECK_INT(p.work.fault.other, 3);
    }
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, first.margin, EXACT);
}

/* Cubes that stand exactly above each other stand with every kern closed;
   then one does not, and is taken away again. */
static void plan_saturated(void)
{
    static world w;
    static site p;
    kern_margin m;
    int i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    for (i = 0; i < 6; i++)
        world_box(&w, 1, 0, i, 1, i + 1);
    world_box(&w, 1, 0.25, 6, 1.25, 7);
    world_touch(&w);
    site_open(&p, &w);
    for (i = 0; i < 7; i++) {
        site_add(&p, i);
        CHECK_INT(site_measure(&p, &m), i ? KERN_STANDS : KERN_NO_FREE);
        CHECK(i == 0 || m.saturated);
    }
    CHECK_INT(site_try(&p, &w.block[7], &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.25, EXACT);
    site_add(&p, 7);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK_NEAR(m.margin, 0.25, EXACT);
    site_remove(&p, 7);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK(m.saturated);
    site_remove(&p, 3); /* what was above it hangs in the air */
    CHECK_INT(site_measure(&p, &m), KERN_FALLS);
    site_add(&p, 3);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    CHECK(m.saturated);
}

/* Blocks and contacts taken back by hand, and garbage in the work memory: the
   plan goes on with less than it knew, and answers the same. */
/* Every stone of a plan in the same array of vertices: the second one is
   refused, wherever it lies, to be added and to be tried. */
static void plan_with_one_array(void)
{
    static world w;
    static site p;
    kern_vec v[4];
    kern_block stone;
    kern_margin m;
    int i, k;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_touch(&w);
    site_open(&p, &w);
    site_add(&p, 0);
    for (i = 0; i < 3; i++) {
        for (k = 0; k < 4; k++)
            v[k] = vec((k == 1 || k == 2 ? 1 : 0) + 3 * i, k / 2);
        CHECK_INT(kern_block_init(&stone, v, 4, R(1), NULL), KERN_OK);
        k = kern_plan_try(&p.plan, &stone, &m, NULL);
        CHECK_INT(k, i ? KERN_STALE : KERN_STANDS);
        CHECK_INT(kern_plan_add(&p.plan, &stone), i ? KERN_STALE : 2);
        if (i)
            CHECK_INT(p.work.fault.block, 1);
        CHECK_INT(p.plan.task.s.blocks, 2);
    }
}

/* kern_critical_of() for the measure of a world; arrays have guards. */
static kern_meeting meeting_at[MAX_POINTS];
static kern_real limit_at[MAX_POINTS];
static int group_of[MAX_BLOCKS];

static int critical(const world *w, kern_margin *m, kern_critical *c)
{
    kern_work work = work_of(w);
    kern_proof proof = proof_here();
    const int got = measure(w, m);
    int k, status;
    if (got < 0 || m->saturated)
        return got;
    if (got == KERN_FALLS)
        proof.force = NULL;
    c->meeting = meeting_at;
    c->limit = limit_at;
    c->group = group_of;
    status = kern_critical_of(world_task(w, &work), m->margin, &proof, c);
    CHECK_INT(status, KERN_OK);
    for (k = 0; k < w->contacts; k++) {
        CHECK(limit_at[k] >= 0 && limit_at[k] <= 1 + 1e-4);
        if (c->contact < 0)
            CHECK_NEAR(limit_at[k], 0, 0);
    }
    if (c->contact >= 0)
        CHECK_NEAR(limit_at[c->contact], 1, 1.1e-4);
    for (k = 0; k < w->blocks; k++) {
        const kern_motion v = motion_of[k];
        const int moves = v.vx * v.vx + v.vy * v.vy > 0 || v.spin * v.spin > 0;
        CHECK(group_of[k] >= -1 && group_of[k] < c->groups);
        CHECK(group_of[k] < 0 || (moves && !w->block[k].fixed));
    }
    CHECK(c->groups > 0);
    return got;
}

static void critical_by_hand(void)
{
    static world w;
    kern_margin m;
    kern_critical c;
    int k, hinges;
    /* a cube that reaches out: it tips about the edge, standing or falling */
    for (k = 0; k < 2; k++) {
        shifted_cube(&w, k ? 0.75 : 0.25);
        CHECK_INT(critical(&w, &m, &c), k ? KERN_FALLS : KERN_STANDS);
        CHECK_INT(c.groups, 1);
        CHECK_INT(group_of[0], -1);
        CHECK_INT(group_of[1], 0);
        CHECK(c.contact >= 0);
        CHECK_INT(meeting_at[c.contact], KERN_HINGES);
        CHECK_INT(meeting_at[1 - c.contact], KERN_OPENS);
        CHECK(w.contact[c.contact].p.x > w.contact[1 - c.contact].p.x);
    }
    /* nothing to press on: one group, no contact */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(c.groups, 1);
    CHECK_INT(c.contact, -1);
    /* on ice, pushed: it slides, and both ends limit alike */
    shifted_cube(&w, 0);
    world_friction(&w, 0.1);
    w.block[1].load.fx = R(3);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(meeting_at[0], KERN_SLIDES);
    CHECK_INT(meeting_at[1], KERN_SLIDES);
    CHECK_NEAR(limit_at[0], limit_at[1], 1e-3);
    /* a stone on a beam that tips about its pier moves as one with it */
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 2);
    world_box(&w, 1, 0, 2, 4, 2.5);
    world_box(&w, 1, 0, 2.5, 0.8, 3.5);
    world_touch(&w);
    CHECK_INT(critical(&w, &m, &c), KERN_FALLS);
    CHECK_INT(group_of[1], 0);
    for (hinges = k = 0; k < w.contacts; k++)
        hinges += meeting_at[k] == KERN_HINGES;
    CHECK(hinges >= 1);
    CHECK_INT(meeting_at[c.contact], KERN_HINGES);
    CHECK_NEAR(w.contact[c.contact].p.x, 1, GEO);
    CHECK_NEAR(w.contact[c.contact].p.y, 2, GEO);
}

static void critical_laws(void)
{
    static world w;
    kern_margin m;
    kern_critical c;
    int seed, limits = 0;
    for (seed = 0; seed < 200; seed++) {
        random_world(&w, 660000u + (unsigned long long)seed, 20);
        if (critical(&w, &m, &c) < 0 || m.saturated)
            continue;
        limits += c.contact >= 0;
    }
    context[0] = 0;
    CHECK(limits > 50);
}

/* A cone of friction .5, narrower by the angle of 1.5 * .2, is that of .2 /
   1.15 = .1739: what moves along its edge slides, and opens if it is faster. */
static void critical_narrow(void)
{
    static world w;
    static const struct {
        double vy, narrow;
        int meets;
    } at[] = {
        {0.49, 0, KERN_SLIDES},
        {0.51, 0, KERN_OPENS},
        {0.17, 1.5, KERN_SLIDES},
        {0.18, 1.5, KERN_OPENS},
    };
    kern_motion motion[2] = {{0, 0, 0}, {1, 0, 0}};
    kern_meeting meeting[2];
    kern_proof proof;
    kern_critical c;
    kern_work work;
    size_t k;
    memset(&c, 0, sizeof c);
    c.meeting = meeting;
    proof.force = NULL;
    proof.motion = motion;
    shifted_cube(&w, 0);
    world_friction(&w, 0.5);
    work = work_of(&w);
    for (k = 0; k < sizeof at / sizeof *at; k++) {
        motion[1].vy = R(at[k].vy);
        w.options.narrow = R(at[k].narrow);
        CHECK_INT(kern_critical_of(world_task(&w, &work), R(0.2), &proof, &c),
                  KERN_OK);
        CHECK_INT(meeting[0], at[k].meets);
        CHECK_INT(meeting[1], at[k].meets);
    }
}

static void critical_bad_input(void)
{
    static world w;
    const kern_motion zero[2] = {{0, 0, 0}, {0, 0, 0}};
    kern_motion motion[2];
    kern_proof proof;
    kern_critical c;
    kern_work work;
    kern_task *task;
    memset(&c, 0, sizeof c);
    memcpy(motion, zero, sizeof zero);
    proof.force = NULL;
    proof.motion = motion;
    shifted_cube(&w, 0.25);
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_OK); /* all rests */
    CHECK_INT(c.contact, -1);
    CHECK_INT(c.groups, 0);
    CHECK_INT(kern_critical_of(NULL, 0, &proof, &c), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, 0, NULL, &c), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, 0, &proof, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_critical_of(task, R(not_a_number()), &proof, &c),
              KERN_BAD_NUMBER);
    motion[1].spin = R(not_a_number());
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_BAD_NUMBER);
    CHECK_INT(work.fault.block, 1);
    proof.motion = NULL;
    CHECK_INT(kern_critical_of(task, 0, &proof, &c), KERN_BAD_POINTER);
}

/* Whatever is said to be known, the measure is the same, and proven: what was
   known before a change, of another structure, random numbers, no numbers. */
static kern_real random_number(void)
{
    const int kind = random_int(0, 9);
    return R(kind == 0   ? not_a_number()
             : kind == 1 ? huge_value()
             : kind == 2 ? -huge_value()
             : kind == 3 ? 0
                         : uniform(-1, 1) * pow(10, random_int(-8, 8)));
}

static void known_garbage(void)
{
    static world w;
    static kern_motion motion[MAX_BLOCKS];
    static kern_force force[MAX_POINTS];
    kern_known known = kern_known_of(motion, force);
    int seed, way, i;
    for (seed = 0; seed < some(300); seed++) {
        kern_margin fresh, m;
        int want;
        random_world(&w, 640000u + (unsigned long long)seed, 20);
        want = measure(&w, &fresh);
        for (way = 0; way < 7; way++) {
            const kern_proof proof = proof_here();
            kern_work work = work_of(&w);
            kern_task task = *world_task(&w, &work);
            /* 0: of the world before; 1: as the last measure left it; 2: the
               same in a wide bracket; 3: that bracket but for one number */
            for (i = 0; i < w.blocks && way > 3; i++) {
                motion[i].vx = random_number();
                motion[i].vy = random_number();
                motion[i].spin = random_number();
            }
            for (i = 0; i < w.contacts && way > 3; i++) {
                force[i].normal = random_number();
                force[i].tangential = random_number();
            }
            if (way == 2 && (!SINGLE || known.fails > mean_size(&w) / 4)) {
                known.holds = 0; /* much wider than any is */
                known.margin = known.fails / 2;
            } else if (way == 3 || way == 4) {
                known.holds = fresh.holds;
                known.fails = fresh.fails;
                known.margin = way == 4 ? fresh.margin : random_number();
            } else if (way > 4) {
                known.holds = random_number();
                known.fails = random_number();
                known.margin = random_number();
            }
            task.known = known;
            memset(&m, 0, sizeof m);
            i = kern_measure(&task, &m, &proof);
            check_measure(&w, i, &m, &work);
            same_answer(&w, &fresh, want, &m, i, 1, EXACT, __LINE__);
            known = task.known;
        }
    }
    context[0] = 0;
}

static void plan_stale(void)
{
    enum { BOXES = 8, ROOM = 40 };
    static kern_real real[KERN_REALS(BOXES, ROOM)];
    static int index[KERN_INTS(BOXES, ROOM)];
    static kern_motion motion[BOXES];
    static kern_force force[ROOM];
    static world w;
    kern_block block[BOXES];
    kern_contact contact[ROOM];
    kern_work work = kern_work_of(real, KERN_REALS(BOXES, ROOM), index,
                                  KERN_INTS(BOXES, ROOM));
    kern_margin m, fresh;
    int way, i;
    for (way = 0; way < 3; way++) {
        kern_plan plan = kern_plan_of(block, BOXES, contact, ROOM,
                                      kern_known_of(motion, force), &work);
        kern_work own = kern_work_of(real, KERN_REALS(BOXES, ROOM), index,
                                     KERN_INTS(BOXES, ROOM));
        int before, got;
        world_reset(&w);
        for (i = 0; i < BOXES; i++) {
            const double x = i ? 0.1 * (i & 1) : -3;
            world_box(&w, i > 0, x, i - 1, x + (i ? 1 : 7), i);
            CHECK(kern_plan_add(&plan, &w.block[i]) >= 0);
        }
        before = plan.task.s.contacts;
        if (way == 2) {
            got = contact_make(6, 7, vec(0, 1), vec(0.2, 6), vec(0.9, 6),
                               R(0.4), &plan.task.options, contact + before);
            CHECK_INT(got, 2);
            plan.task.s.contacts += got;
        }
        CHECK_INT(kern_measure(&plan.task, &m, NULL), KERN_STANDS);
        if (way < 2) {
            plan.task.s.blocks -= 3;
            plan.task.s.contacts -= 6;
        } else
            plan.task.s.contacts = before;
        for (i = 0; i < work.indices; i++)
            index[i] = way == 1 ? 1000000 + i : -1000000 - i;
        CHECK_INT(kern_plan_remove(&plan, plan.task.s.blocks - 1), KERN_OK);
        CHECK_INT(kern_measure(&plan.task, &m, NULL), KERN_STANDS);
        CHECK_INT(kern_measure(task_of(&plan.task.s, &plan.task.options, &own),
                               &fresh, NULL),
                  KERN_STANDS);
        CHECK_INT(m.level, fresh.level);
        CHECK_NEAR(m.margin, fresh.margin, SINGLE ? 2e-3 : 1e-6);
    }
}

/* Nothing, or ground alone: a question without an answer, which changes
   nothing. */
static void plan_ground_only(void)
{
    static world w;
    static site p;
    kern_margin m;
    int i;
    slab_on_pillar(&w);
    site_open(&p, &w);
    CHECK_INT(site_measure(&p, &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[0], &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[1], &m), KERN_FALLS);
    site_add(&p, 0);
    CHECK_INT(site_measure(&p, &m), KERN_NO_FREE);
    CHECK_INT(site_try(&p, &w.block[1], &m), KERN_STANDS);
    CHECK(m.saturated);
    for (i = 1; i < 3; i++)
        site_add(&p, i);
    CHECK_INT(site_measure(&p, &m), KERN_STANDS);
    for (i = 2; i >= 0; i--) {
        site_remove(&p, i);
        site_measure(&p, &m);
    }
    CHECK_INT(p.plan.task.s.contacts, 0);
    CHECK_INT(kern_plan_remove(&p.plan, 0), KERN_BAD_BLOCK);
}

/* What every call on a plan says; those that are refused change nothing. */
static void plan_say(site *p, const kern_block *b, int add, int remove,
                     int measured, int tried, int line)
{
    kern_margin m, untouched;
    memset(&m, 0x55, sizeof m);
    untouched = m;
    site_keep(p);
    check_near(kern_plan_try(&p->plan, b, &m, NULL), tried, 0, line, "try");
    site_unchanged(p, line);
    if (tried < 0)
        check_report(!memcmp(&m, &untouched, sizeof m), line, "margin", 0, 0,
                     0);
    if (measured < 0) {
        m = untouched;
        check_near(kern_measure(&p->plan.task, &m, NULL), measured, 0, line,
                   "measure");
        check_report(!memcmp(&m, &untouched, sizeof m), line, "margin", 0, 0,
                     0);
    }
    if (add < 0)
        check_near(kern_plan_add(&p->plan, b), add, 0, line, "add");
    if (remove < 0)
        check_near(kern_plan_remove(&p->plan, 0), remove, 0, line, "remove");
    site_unchanged(p, line);
}

/* What was measured is trusted, what came later is not: contacts appended by
   hand are checked, and what is changed by hand is seen where fails is 0. */
static void plan_by_hand(void)
{
    static world w;
    static site p;
    kern_contact *bad, good;
    kern_block b, aside;
    kern_margin m;
    b = on_slab(&w, &p, 0.4);
    bad = p.contact + p.plan.task.s.contacts++;
    *bad = good = p.contact[0];
    bad->mu = -1;
    plan_say(&p, &b, 0, KERN_OK, KERN_BAD_FRICTION, KERN_BAD_FRICTION,
             __LINE__);
    bad->mu = good.mu;
    bad->a = 99;
    CHECK_INT(kern_plan_bears(&p.plan, &b, 0, NULL), KERN_BAD_BLOCK);
    p.plan.task.s.contacts--;
    site_try(&p, &b, &m);
    aside = candidate(&w, 1, 5, 0, 0.2);
    p.block[2].load.fx = 8 * p.block[2].mass; /* is noticed */
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 0, NULL), KERN_FALLS);
    site_try(&p, &aside, &m);
    site_try(&p, &b, &m);
    p.block[2].load.fx = 0;
    site_measure(&p, &m);
    p.block[2].mass *= 3;
    site_try(&p, &b, &m);
    p.block[2].mass /= 3;
    site_measure(&p, &m);
    p.contact[2].mu = p.contact[3].mu = R(0.01);
    p.block[2].load.fx = p.block[2].mass;
    p.plan.task.known.fails = 0;
    site_try(&p, &b, &m);
    CHECK_INT(kern_plan_bears(&p.plan, &b, 0, NULL), KERN_FALLS);
    site_measure(&p, &m);
    p.plan.task.s.gravity = vec(0.3, -9.81);
    site_try(&p, &b, &m);
}

/* What stands with every kern closed bears any margin, kerns nested or not: a
   block on two points whose normals differ, and one aside. With cones that
   narrow it falls where friction is gone, by a motion. */
static void plan_bears_when_closed(void)
{
    static world w;
    static site p;
    const kern_proof proof = proof_here();
    kern_block aside;
    kern_margin m;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_box(&w, 1, -1, 0, 1, 1);
    world_point(&w, 0, 1, 0.3, 1, -0.8, 0);
    world_point(&w, 0, 1, -0.3, 1, 0.8, 0);
    kern_contact_travels(w.contact, w.contacts);
    site_with(&p, &w, 2);
    aside = candidate(&w, 1, 5, 0, 0.2);
    CHECK_INT(kern_plan_try(&p.plan, &aside, &m, NULL), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, m.most / 2, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, m.most, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 3 * m.most, NULL), KERN_STANDS);
    kern_block_load(&aside, vec(0.004, 0), vec(5.1, 0), 0); /* slides at last */
    p.plan.task.options.narrow = R(0.1);
    CHECK_INT(kern_plan_try(&p.plan, &aside, &m, NULL), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 2 * m.most, NULL), KERN_STANDS);
    CHECK_INT(kern_plan_bears(&p.plan, &aside, 9 * m.most, &proof), KERN_FALLS);
    p.block[2] = aside;
    p.plan.task.s.blocks++;
    p.plan.task.s.contacts += 2; /* still there, behind the plan's */
    CHECK(kern_check_motion(&p.plan.task, 9 * m.most, proof.motion) <= 1);
}

static void plan_faults(void)
{
    static world w;
    static site p;
    static const int none = KERN_BAD_POINTER, full = KERN_NO_SPACE;
    kern_plan keep;
    kern_block b;
    kern_margin m;
    int i;
    b = on_slab(&w, &p, 1.1);
    keep = p.plan;
    for (i = 0; i < 4; i++) {
        p.plan.block = i == 0 ? NULL : keep.block;
        p.plan.contact = i == 1 ? NULL : keep.contact;
        p.plan.task.known.motion = i == 2 ? NULL : keep.task.known.motion;
        p.plan.task.work = i == 3 ? NULL : keep.task.work;
        plan_say(&p, &b, none, none, i == 3 ? none : 0, none, __LINE__);
        p.plan = keep;
    }
    plan_say(&p, NULL, none, 0, 0, none, __LINE__);
    CHECK_INT(kern_plan_add(NULL, &b), none);
    CHECK_INT(kern_plan_remove(NULL, 0), none);
    CHECK_INT(kern_measure(NULL, &m, NULL), none);
    CHECK_INT(kern_plan_try(NULL, &b, &m, NULL), none);
    site_keep(&p);
    CHECK_INT(kern_measure(&p.plan.task, NULL, NULL), none);
    CHECK_INT(kern_plan_try(&p.plan, &b, NULL, NULL), none);
    CHECK_INT(kern_plan_remove(&p.plan, -1), KERN_BAD_BLOCK);
    CHECK_INT(kern_plan_remove(&p.plan, w.blocks), KERN_BAD_BLOCK);
    site_unchanged(&p, __LINE__);
    for (i = -1; i <= w.blocks; i++) { /* no room for a block */
        p.plan.block_room = i;
        plan_say(&p, &b, full, 0, 0, full, __LINE__);
        p.plan = keep;
    }
    for (i = -1; i < 2; i++) { /* nor for its two contact points */
        p.plan.contact_room = w.contacts + i;
        plan_say(&p, &b, i < 0 ? KERN_BAD_COUNT : full, 0, 0,
                 i < 0 ? KERN_BAD_COUNT : full, __LINE__);
        p.plan = keep;
    }
}

/* Bad blocks and options. */
static void plan_bad_input(void)
{
    static world w;
    static site p;
    kern_plan keep;
    kern_block b;
    kern_margin m;
    b = on_slab(&w, &p, 1.1);
    keep = p.plan;
    b.mass = 0;
    plan_say(&p, &b, 0, 0, 0, KERN_BAD_MASS, __LINE__);
    p.plan.task.known.force = NULL;
    CHECK_INT(kern_plan_add(&p.plan, &w.block[1]), KERN_BAD_POINTER);
    CHECK_INT(p.work.fault.block, -1); /* not that of the call before */
    p.plan = keep;
    plan_say(&p, &b, 0, 0, 0, KERN_BAD_MASS, __LINE__);
    CHECK_INT(p.work.fault.block, w.blocks);
    b.area = R(not_a_number());
    plan_say(&p, &b, KERN_BAD_NUMBER, 0, 0, KERN_BAD_NUMBER, __LINE__);
    CHECK_INT(p.work.fault.block, w.blocks);
    p.plan.task.options.mu = R(-1);
    plan_say(&p, &w.block[1], KERN_BAD_FRICTION, 0, KERN_BAD_FRICTION,
             KERN_BAD_FRICTION, __LINE__);
    p.plan = keep;
    p.plan.task.options.epsilon = R(1e-12);
    plan_say(&p, &w.block[0], 0, 0, KERN_BAD_STEP, KERN_BAD_STEP, __LINE__);
    p.plan = keep;
    site_measure(&p, &m);
    CHECK_NEAR(m.margin, 0.4, EXACT);
}

/* Work memory of every size, one array at a time: the answer, or that there is
   too little; never a write behind it, nor another plan. */
static void plan_every_size(void)
{
    static world w;
    static site p, was;
    kern_real *real = p.real;
    int *index = p.index;
    kern_block b;
    kern_margin m;
    int array, size, call, need[2], want;
    b = on_slab(&w, &was, 1.2);
    kern_work_need(w.blocks + 1, was.plan.task.s.contacts + 2, &need[0],
                   &need[1]);
    for (array = 0; array < 2; array++)
        for (size = 0; size <= need[array]; size++)
            for (call = 0; call < 3; call++) {
                int got;
                p.plan = was.plan;
                memcpy(p.block, was.block, sizeof p.block);
                memcpy(p.contact, was.contact, sizeof p.contact);
                memcpy(p.motion, was.motion, sizeof p.motion);
                memcpy(p.force, was.force, sizeof p.force);
                p.plan.task.s.block = p.plan.block = p.block;
                p.plan.task.s.contact = p.plan.contact = p.contact;
                p.plan.task.known.motion = p.motion;
                p.plan.task.known.force = p.force;
                p.plan.task.work = &p.work;
                guard_fill(real, need[0], index, need[1]);
                p.work = kern_work_of(real, array ? need[0] : size, index,
                                      array ? size : need[1]);
                site_keep(&p);
                got = call == 0 ? kern_measure(&p.plan.task, &m, NULL)
                    : call == 1 ? kern_plan_try(&p.plan, &b, &m, NULL)
                                : kern_plan_remove(&p.plan, 1);
                CHECK(guard_holds(&p.work, need[0], need[1]));
                want = size < need[array] && got == KERN_NO_SPACE
                         ? KERN_NO_SPACE
                     : call == 2 ? KERN_OK
                                 : KERN_STANDS;
                CHECK_INT(got, want);
                CHECK(size > 0 || got == KERN_NO_SPACE || call == 2);
                if (got < 0 || call == 1)
                    site_unchanged(&p, __LINE__);
            }
}

/* Half a brick over the edge, relative: at a share above 1 its points would come
   out behind their middle. No call takes one, and none answers one. */
static void relative_shares(void)
{
    static world w;
    static site p;
    const kern_real above[] = {R(1.0001), R(2.41), R(1e6)};
    const kern_wrench push[3] = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    kern_work work;
    kern_task *task;
    kern_raising raising = KERN_NOT_SHOWN;
    kern_real value = -7;
    kern_critical critical = {NULL, NULL, NULL, 0, 0};
    kern_proof proof = proof_here();
    kern_block b;
    int i;
    world_reset(&w);
    world_box(&w, 0, -9, -1, 9, 0);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0.4, 1, 1.6, 2);
    w.options.relative = 1;
    world_touch(&w);
    b = w.block[2];
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_verdict(task, 1, &proof), KERN_FALLS);
    site_with(&p, &w, 2);
    for (i = 0; i < 3; i++) {
        const kern_real at = above[i];
        CHECK_INT(kern_verdict(task, at, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_raised(task, at, &raising, NULL, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_forces(task, at, force_of), KERN_BAD_SHARE);
        CHECK_INT(kern_load_factor(task, at, KERN_LEFT, &value, NULL),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_load_factor_of(task, at, push, &value, NULL),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_tilt(task, at, KERN_LEFT, &value, NULL), KERN_BAD_SHARE);
        CHECK_INT(kern_critical_of(task, at, &proof, &critical),
                  KERN_BAD_SHARE);
        CHECK_INT(kern_plan_bears(&p.plan, &b, at, NULL), KERN_BAD_SHARE);
        CHECK(isinf(kern_check_motion(task, at, motion_of)));
        CHECK(isinf(kern_check_forces(task, at, force_of)));
    }
    CHECK_NEAR(value, -7, 0);
    CHECK_INT(raising, KERN_NOT_SHOWN);
    CHECK_INT(kern_verdict(task, -2, NULL), KERN_STANDS); /* growth has none */
}

/* Known from before a stone was taken away and another laid down: an older
   version said margin 1 of this, for 0.60. */
static void plan_out_of_date(void)
{
    static const double stone[4][16] = {
        {-2815, -469, 2815, -469, 2815, 0, -2815, 0},
        {501, 0, 595, 0, 595, 117, 648, 117, 648, 0, 742, 0, 742, 234.5, 501,
         234.5},
        {526, 469, 1120, 469, 1120, 703, 526, 703},
        {645, 234.5, 1233, 234.5, 1233, 469, 645, 469}};
    static world w;
    static site p;
    kern_margin m, n;
    kern_known *known = &p.plan.task.known;
    int i;
    world_reset(&w);
    w.options.mu = R(0.32);
    w.options.relative = 1;
    w.gravity = vec(-1.04, -9.81);
    for (i = 0; i < 4; i++)
        world_polygon(&w, i % 2, stone[i], i == 1 ? 8 : 4);
    world_touch(&w);
    CHECK_INT(measure(&w, &n), KERN_STANDS);
    CHECK(n.margin > R(0.5) && n.margin < R(0.7));
    site_with(&p, &w, 3);
    memset(p.motion, 0, sizeof p.motion);
    memset(p.force, 0, sizeof p.force);
    for (i = 0; i < 9; i++) {
        known->margin = R(0.3 * (i + 1));
        known->holds = known->margin * R(1 - 1e-6);
        known->fails = known->margin * R(1 + 1e-6);
        p.force[0].normal = R(1.4e4) * w.block[1].mass / R(1e3);
        p.force[1].normal = p.force[0].normal;
        CHECK_INT(kern_plan_try(&p.plan, &w.block[3], &m, NULL), KERN_STANDS);
        CHECK_NEAR(m.margin, n.margin, SINGLE ? 1e-2 : 2e-6); /* a jam */
        CHECK(!m.saturated);
    }
}

/* ---- fuzzed ------------------------------------------------- >>plan_fuzz */
/* Any sequence of calls on a plan, with what is known spoiled, or kept from long
   ago, relative or not, with a limit of work and with less memory: every answer
   is that of a fresh structure, or the status that says why there is none. */

static struct {
    kern_motion motion[MAX_BLOCKS];
    kern_force force[MAX_POINTS];
    kern_known known; /* its numbers; the arrays are those above */
} plan_then;

static long plan_calls, plan_ends; /* of these ended by limit or memory */

static kern_real plan_rubbish(void)
{
    return chance(0.1) ? KERN_INFINITY
         : chance(0.1) ? R(not_a_number())
                       : R(chance(0.5) ? uniform(-1, 8) : uniform(0, 1));
}

/* Spoils what is known, keeps a copy of it, or goes back to the copy. */
static void plan_spoil(site *p)
{
    kern_known *known = &p->plan.task.known;
    const int i = random_int(0, MAX_BLOCKS / 8);
    const kern_real by = plan_rubbish();
    switch (random_int(0, 7)) {
    case 0: known->fails = 0; break;
    case 1: known->margin = plan_rubbish(); break;
    case 2: known->holds *= by, known->margin *= by, known->fails *= by; break;
    case 3: known->holds += by, known->margin += by, known->fails += by; break;
    case 4: p->motion[i].vx = plan_rubbish(), p->motion[i].spin = by; break;
    case 5: p->force[i].normal = p->force[i + 1].tangential = by; break;
    case 6:
        memcpy(plan_then.motion, p->motion, sizeof p->motion);
        memcpy(plan_then.force, p->force, sizeof p->force);
        plan_then.known = *known;
        break;
    default:
        memcpy(p->motion, plan_then.motion, sizeof p->motion);
        memcpy(p->force, plan_then.force, sizeof p->force);
        known->holds = plan_then.known.holds;
        known->margin = plan_then.known.margin;
        known->fails = plan_then.known.fails;
    }
}

/* A limit, less memory, another gravity, relative or not, or all as it was. */
static void plan_settings(site *p)
{
    kern_task *task = &p->plan.task;
    const int short_of = chance(0.15);
    const int b = task->s.blocks + 1, c = task->s.contacts + 60;
    p->work.reals = short_of ? KERN_LEAN_REALS(b, c)
                             : KERN_REALS(MAX_BLOCKS, MAX_POINTS);
    p->work.indices = short_of ? KERN_LEAN_INTS(b, c)
                               : KERN_INTS(MAX_BLOCKS, MAX_POINTS);
    task->options.limit = chance(0.2) ? (int)pow(10, uniform(0, 4)) : 0;
    if (chance(0.05))
        task->options.relative = !task->options.relative;
    if (chance(0.05))
        task->s.gravity = vec(uniform(-1, 1), -9.81);
}

/* Whether a call ended by its limit, or for want of memory. */
static int plan_ended(const site *p, int got)
{
    const int ended = (got == KERN_LIMIT && p->plan.task.options.limit > 0)
                   || (got == KERN_NO_SPACE
                       && p->work.reals < KERN_REALS(MAX_BLOCKS, MAX_POINTS));
    plan_calls++;
    plan_ends += ended;
    return ended;
}

/* The plan with `more` blocks and `points` contact points behind its own, of
   which nothing is known. */
static void plan_fresh(const site *p, world *t, int more, int points)
{
    site_world(p, t, more, points);
    t->options.limit = 0;
}

/* A measure said `got` and *m: so does a fresh one, or its bracket lies in that
   of one that was ended. */
static void plan_measured(const site *p, int more, int points, int got,
                          const kern_margin *m, int line)
{
    static world t;
    kern_margin n;
    int want;
    kern_work work;
    plan_fresh(p, &t, more, points);
    work = work_of(&t);
    memset(&n, 0, sizeof n);
    want = kern_measure(world_task(&t, &work), &n, NULL);
    if (!plan_ended(p, got))
        same_answer(&t, &n, want, m, got, 1, EXACT, line);
    else if (got == KERN_LIMIT && want == KERN_STANDS)
        check_report(m->holds <= n.fails && m->fails >= n.holds, line,
                     "bracket at the limit", (double)m->holds, (double)n.margin,
                     (double)m->fails);
}

/* Whether it bears a margin, asked of the plan and of a fresh structure; and,
   relative, that no share above 1 is asked for. */
static void plan_bears(site *p, const kern_block *block, int points)
{
    static world t;
    const double most = p->plan.task.options.relative ? 1.5
                      : chance(0.5)                   ? 0.5
                                                      : 1e-3;
    const kern_real at = R(uniform(0, most));
    const int got = kern_plan_bears(&p->plan, block, at, NULL);
    kern_margin n;
    int want;
    kern_work work;
    if (plan_ended(p, got) && got == KERN_NO_SPACE)
        return;
    plan_fresh(p, &t, 1, points);
    work = work_of(&t);
    memset(&n, 0, sizeof n);
    want = kern_measure(world_task(&t, &work), &n, NULL);
    if (want == KERN_STANDS && n.margin < at && !n.saturated)
        want = KERN_FALLS;
    if (want >= KERN_UNDECIDED && t.options.relative && at > 1)
        want = KERN_BAD_SHARE;
    if (got != KERN_LIMIT && got != want && !open_question(&t, (double)at))
        check_near(got, want, 0, __LINE__, "bears");
}

/* A block that is not in the plan: tried, asked what it bears, raised. */
static void plan_candidate(site *p, const kern_block *block)
{
    static world t;
    kern_margin m;
    kern_raising raising[2] = {KERN_NOT_SHOWN, KERN_NOT_SHOWN};
    int got, points;
    kern_work none = kern_work_of(NULL, 0, NULL, 0);
    memset(&m, 0, sizeof m);
    site_keep(p);
    got = kern_plan_try(&p->plan, block, &m, NULL);
    site_unchanged(p, __LINE__);
    p->block[p->plan.task.s.blocks] = *block;
    points = kern_touch(p->block, p->plan.task.s.blocks, &p->plan.task.options,
                        p->contact + p->plan.task.s.contacts, 200, &none);
    if (points < 0) {
        CHECK_INT(got, points);
        return;
    }
    plan_measured(p, 1, points, got, &m, __LINE__);
    plan_bears(p, block, points);
    got = kern_plan_raised(&p->plan, block, &raising[0], NULL, NULL);
    if (!plan_ended(p, got)) {
        kern_work work;
        plan_fresh(p, &t, 1, points);
        work = work_of(&t);
        CHECK_INT(got, kern_raised(world_task(&t, &work), 0, &raising[1], NULL,
                                   NULL));
        CHECK_INT(raising[0], raising[1]);
    }
}

/* Some calls on one structure. */
static void plan_fuzz_one(const world *w)
{
    static site p;
    kern_margin m;
    int round, got;
    site_open(&p, w);
    p.plan.task.options.epsilon = 0;
    memset(p.motion, 0, sizeof p.motion);
    memset(p.force, 0, sizeof p.force);
    memset(&plan_then, 0, sizeof plan_then);
    for (round = 0; round < 12 + w->blocks; round++) {
        const int number = random_int(0, w->blocks - 1);
        const int at = site_place(&p, number);
        if (chance(0.3))
            plan_spoil(&p);
        plan_settings(&p);
        if (at < 0 && p.plan.task.s.blocks > 0 && !w->given)
            plan_candidate(&p, &w->block[number]);
        if (at < 0)
            site_add(&p, number);
        else if (chance(0.3))
            site_remove(&p, at);
        if (p.plan.task.s.blocks == 0 || chance(0.3))
            continue;
        memset(&m, 0, sizeof m);
        got = kern_measure(&p.plan.task, &m, NULL);
        plan_measured(&p, 0, 0, got, &m, __LINE__);
    }
}

/* So many calls, on structures from number `first` on. */
static void plan_fuzz_calls(long calls, unsigned long long first)
{
    static world w;
    unsigned long long seed = first;
    plan_calls = plan_ends = 0;
    for (; plan_calls < calls; seed++) {
        const int kind = random_of_kind(&w, seed, 20,
                                        (int)(seed % (KINDS + 1)));
        if (seed % (KINDS + 1) == KINDS && kind < CHAIN) {
            world_reset(&w);
            random_keels(&w, random_int(1, 4));
            w.options.relative = chance(0.5);
        }
        plan_fuzz_one(&w);
    }
    context[0] = 0;
}

static void plan_fuzz(void)
{
    plan_fuzz_calls(quick ? 1000 : 6000, 7300000u);
    CHECK(plan_ends > plan_calls / 50);
}

/* ==== Jams ========================================================= >>jams */

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

/* ==== The bearing length ======================================== >>bearing */

static double bearing(const world *w, int *status)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w), check = work_of(w);
    kern_real length = R(-2);
    *status = kern_bearing(world_task(w, &work), &length, &proof);
    if (*status == KERN_STANDS)
        CHECK(kern_check_forces(world_task(w, &check), 0, force_of) <= 1);
    return (double)length;
}

/* By the definition: all lengths in turn, shorter contacts taken out by hand. */
static double bearing_by_hand(const world *w)
{
    static world t;
    double best = -1;
    int i, k;
    for (i = -1; i <= w->contacts; i++) {
        const double length = i < 0 ? 0
                            : i == w->contacts
                                ? huge_value()
                                : 2 * fabs((double)w->contact[i].travel);
        if (!(length > best))
            continue;
        world_copy(&t, w);
        for (k = t.contacts = 0; k < w->contacts; k++) {
            const double own = 2 * fabs((double)w->contact[k].travel);
            if (!(own > 0) || own >= length)
                t.contact[t.contacts++] = w->contact[k];
        }
        if (verdict(&t, 0) == KERN_STANDS)
            best = length;
    }
    return best;
}

/* A unit stone on two lips: `left` and `right` wide. */
static void stone_on_lips(world *w, double left, double right)
{
    world_reset(w);
    world_box(w, 0, -2, -1, left, 0);
    world_box(w, 0, 1 - right, -1, 3, 0);
    world_box(w, 1, 0, 0, 1, 1);
    CHECK_INT(world_touch(w), 4);
}

static void bearing_of_lips(void)
{
    static const double lip[] = {0.3, 0.1, 2e-2, 1e-2};
    static world w;
    int i, got;
    for (i = 0; i < 4; i++) {
        stone_on_lips(&w, lip[i], 0.3);
        CHECK_NEAR(bearing(&w, &got), lip[i], SINGLE ? 1e-6 : 1e-12);
        CHECK_INT(got, KERN_STANDS);
        stone_on_lips(&w, lip[i], 0.7); /* the lip is not needed */
        CHECK_NEAR(bearing(&w, &got), 0.7, SINGLE ? 1e-6 : 1e-12);
    }
    if (!SINGLE) { /* the margin is that of a lip of 100 mm, and saturated */
        kern_margin m;
        stone_on_lips(&w, 2e-6, 0.3);
        CHECK_NEAR(bearing(&w, &got), 2e-6, 1e-12);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated && m.margin > R(0.14));
    }
    stack_of_two(&w, 0.25);
    CHECK_NEAR(bearing(&w, &got), 0.75, EXACT);
    stack_of_two(&w, 0.75);
    CHECK_NEAR(bearing(&w, &got), -2, 0);
    CHECK_INT(got, KERN_FALLS);
    world_reset(&w); /* on two points that have no length */
    world_mass(&w, 0, 0, -1, 1);
    world_mass(&w, 0, 1, -1, 1);
    world_mass(&w, 1, 0.5, 0.5, 1);
    world_point(&w, 0, 2, 0, 1, 0, 0);
    world_point(&w, 1, 2, 0, 1, 1, 0);
    world_touch(&w);
    CHECK(bearing(&w, &got) > 1e30);
}

static void bearing_by_definition(void)
{
    static world w;
    int seed, slivers = 0;
    for (seed = 0; seed < 300; seed++) {
        int got; /* of the verdict on all contacts */
        double here, by_hand;
        random_world(&w, 780000u + (unsigned long long)seed, 10);
        here = bearing(&w, &got);
        by_hand = bearing_by_hand(&w);
        if (got == KERN_STANDS)
            CHECK_NEAR(here, by_hand, 1e-12 * here);
        else
            CHECK(got == KERN_FALLS ? by_hand < 0 : SINGLE);
        slivers += here < 0.3 && here > 0;
    }
    context[0] = 0;
    CHECK(slivers > 20);
}

/* ==== Limits of work ============================================= >>limits */

enum limited_call {
    LIMIT_STANDS,
    LIMIT_SHRUNK,
    LIMIT_MEASURE,
    LIMIT_DEFICIT,
    LIMIT_LEFT,
    LIMIT_RIGHT,
    LIMIT_TILT,
    LIMIT_BEARING,
    LIMIT_MARGINS,
    LIMIT_LOADS,
    LIMIT_PLAN,
    LIMIT_TRY,
    LIMIT_BEARS,
    LIMIT_CALLS
};

/* What a call says: 0 in all that it does not write. */
typedef struct limited {
    int status, units;
    kern_margin m;
    kern_real value[MAX_BLOCKS];
} limited;

/* One call with a limit of work. Plans are made anew each time. */
/* A call on a task, its answer to r. */
static int ask_task(enum limited_call call, kern_task *task, limited *r)
{
    const kern_real at = R(
        0.1 * (double)kern_mean_size(task->s.block, task->s.blocks));
    const int side = call == LIMIT_LEFT ? -1 : 1;
    kern_collapse c;
    switch (call) {
    case LIMIT_STANDS: return kern_verdict(task, 0, NULL);
    case LIMIT_SHRUNK: return kern_verdict(task, at, NULL);
    case LIMIT_MEASURE:
    case LIMIT_PLAN: return kern_measure(task, &r->m, NULL);
    case LIMIT_DEFICIT: return kern_deficit(task, r->value);
    case LIMIT_LEFT:
    case LIMIT_RIGHT: return kern_load_factor(task, 0, side, r->value, NULL);
    case LIMIT_TILT: return kern_tilt(task, 0, side, r->value, NULL);
    case LIMIT_BEARING: return kern_bearing(task, r->value, NULL);
    default: return kern_profile(task, call == LIMIT_LOADS, r->value, &c);
    }
}

/* The last block of a world as a candidate for the others. */
static void ask_plan(enum limited_call call, const world *w, int limit,
                     limited *r)
{
    static site p;
    const int last = w->blocks - 1;
    kern_margin m;
    int i;
    site_with(&p, w, last);
    if (call != LIMIT_PLAN)
        kern_measure(&p.plan.task, &r->m, NULL);
    memset(&r->m, 0, sizeof r->m);
    p.plan.task.options.limit = limit;
    r->status = call == LIMIT_PLAN ? ask_task(call, &p.plan.task, r)
              : call == LIMIT_TRY
                  ? kern_plan_try(&p.plan, &w->block[last], &r->m, NULL)
                  : kern_plan_bears(&p.plan, &w->block[last],
                                    R(0.1 * mean_size(w)), NULL);
    r->units = p.work.units;
    if (r->status != KERN_LIMIT)
        return;
    p.plan.task.options.limit = 0; /* the plan is what it was */
    CHECK_INT(p.plan.task.s.blocks, last);
    i = kern_measure(&p.plan.task, &m, NULL);
    CHECK(i >= 0 || i == KERN_NO_FREE || SINGLE);
    if (call == LIMIT_PLAN && i == KERN_STANDS)
        CHECK(r->m.holds <= m.fails);
}

static limited ask_limited(enum limited_call call, const world *w, int limit)
{
    const kern_structure s = structure_of(w);
    kern_work work = work_of(w);
    kern_options o = w->options;
    limited r;
    memset(&r, 0, sizeof r);
    o.limit = limit;
    if (call >= LIMIT_PLAN) {
        ask_plan(call, w, limit, &r);
        return r;
    }
    r.status = ask_task(call, task_of(&s, &o, &work), &r);
    r.units = work.units;
    return r;
}

/* Are all contacts ends of lines, so that kerns only shrink? */
static int all_lines(const world *w)
{
    int i, lines = 1;
    for (i = 0; i < w->contacts; i++)
        lines &= w->contact[i].line;
    return lines;
}

/* A bracket that ended at the limit does not contradict the whole one. */
static void check_known_margin(const world *w, const limited *all,
                               const kern_margin *m)
{
    const kern_real inside = R(1 + (SINGLE ? 1e-3 : 1e-9));
    CHECK_INT(m->level, -1);
    CHECK_INT(m->saturated, 0);
    CHECK(m->holds <= m->fails && m->fails <= m->most);
    CHECK(m->holds <= m->margin && m->margin <= m->holds);
    CHECK(m->holds >= 0 || all->status == KERN_FALLS || m->holds <= -1);
    if (all->status == KERN_STANDS && all_lines(w)) {
        CHECK(m->holds <= all->m.fails * inside);
        CHECK(m->fails * inside >= all->m.holds);
    }
}

/* What is known where the limit was reached does not contradict the answer. */
static void check_known(enum limited_call call, const world *w,
                        const limited *all, const limited *r)
{
    const kern_real inside = R(1 + (SINGLE ? 1e-3 : 1e-9));
    int i;
    if (all->status < 0)
        return;
    switch (call) {
    case LIMIT_MEASURE:
    case LIMIT_PLAN:
    case LIMIT_TRY: check_known_margin(w, all, &r->m); break;
    case LIMIT_DEFICIT:
    case LIMIT_LEFT:
    case LIMIT_RIGHT:
    case LIMIT_TILT:
    case LIMIT_BEARING:
        CHECK(r->value[0] <= all->value[0] * inside + R(1e-6));
        break;
    case LIMIT_MARGINS:
    case LIMIT_LOADS:
        for (i = 0; i < w->blocks; i++)
            CHECK(r->value[i] <= -1 || r->value[i] == all->value[i]);
        break;
    default: break;
    }
}

/* Every call with every limit, or some of them where there are many: enough
   work, and the answer is the same to the last bit; less, and it says so,
   having done no more than the limit. */
static void limits_of_work(void)
{
    static world w;
    int seed, call, reached = 0, known = 0;
    for (seed = 0; seed < some(60); seed++) {
        random_world(&w, 770000u + (unsigned long long)seed, 12);
        for (call = 0; call < LIMIT_CALLS; call++) {
            const limited all = ask_limited((enum limited_call)call, &w, 0);
            const int step = 1 + all.units / 50;
            int limit;
            if (all.status < KERN_UNDECIDED)
                continue;
            CHECK(all.units > 0);
            for (limit = 1; limit <= all.units + 1;
                 limit += limit + 3 < all.units && limit > 3 ? step : 1) {
                const limited r = ask_limited((enum limited_call)call, &w,
                                              limit);
                if (limit >= all.units) {
                    CHECK(memcmp(&r, &all, sizeof r) == 0);
                    continue;
                }
                CHECK_INT(r.status, KERN_LIMIT);
                CHECK_INT(r.units, limit + 1);
                check_known((enum limited_call)call, &w, &all, &r);
                reached++;
                known += r.m.holds > 0 || r.value[0] > 0;
            }
        }
    }
    context[0] = 0;
    CHECK(reached > some(10000));
    CHECK(known > some(1000));
}

/* A limit that does not reach for the input: it is not read, and what is wrong
   about it is not seen; and nothing is known. */
static void limit_before_reading(void)
{
    static world w;
    int call;
    random_world(&w, 770000u, 12);
    CHECK(w.blocks + w.contacts >= 10);
    w.contact[w.contacts - 1].p.x = R(NAN);
    for (call = 0; call < LIMIT_PLAN; call++) {
        const limited whole = ask_limited((enum limited_call)call, &w, 0);
        const limited r = ask_limited((enum limited_call)call, &w, 1);
        CHECK_INT(whole.status, KERN_BAD_NUMBER);
        CHECK_INT(r.status, KERN_LIMIT);
        CHECK_INT(r.units, 2);
        if (call == LIMIT_MEASURE) {
            CHECK(r.m.holds <= -1 && r.m.margin <= -1 && r.m.level == -1);
            CHECK(r.m.fails >= INFINITY && r.m.most >= INFINITY);
        } else if (call != LIMIT_STANDS && call != LIMIT_SHRUNK)
            CHECK(r.value[0] <= -1);
    }
}

/* ==== Known cases ================================================= >>known */

/* What the cases share: the parameters that a family keeps fixed. */
static struct {
    double mu, a, b;
    int n;
} given;

/* ---- a block on a slope ---- */

/* By hand: b wide and 1 high, it slides at tan a = mu and topples at
   tan a = b, whichever is less; two free cubes topple together at 1/2. The
   degrees are those numbers. */

/* n free unit cubes (b wide, 1 high) on a plane tilted by x. */
static void on_a_slope(world *w, double x)
{
    const double c = cos(x), s = sin(x);
    const double at[8] = {0, 0, 1, 0, 1, 1, 0, 1};
    double xy[8];
    int i, k;
    world_reset(w);
    w->options.mu = R(given.mu);
    for (i = 0; i <= given.n; i++) {
        for (k = 0; k < 4; k++) {
            const double u = at[2 * k] * given.b, v = at[2 * k + 1] + i;
            xy[2 * k] = u * c - v * s;
            xy[2 * k + 1] = u * s + v * c;
        }
        world_polygon(w, i ? 1 : 0, xy, 4);
    }
    CHECK_INT(world_touch(w), 2 * given.n);
}

static void known_slope(void)
{
    static const double mu[] = {0.1, 0.4, 0.84, 1.2};
    static const double degrees[] = {5.7106, 21.8014, 40.0303, 45};
    static world w;
    double angle;
    int k;
    for (k = 0; k < 4; k++) {
        given.mu = (double)R(mu[k]);
        given.b = 1;
        given.n = 1;
        angle = threshold(on_a_slope, 0.01, 1.2);
        CHECK_NEAR(angle, atan(fmin(given.mu, 1)), EDGE);
        CHECK_NEAR(angle * 180 / pi, degrees[k], SINGLE ? 0.1 : 6e-5);
        /* the same by turning gravity */
        on_a_slope(&w, 0);
        CHECK_INT(tilt(&w, 1, &angle), KERN_STANDS);
        CHECK_NEAR(angle, atan(fmin(given.mu, 1)), EDGE);
        /* narrow and wide blocks */
        given.b = 0.3;
        CHECK_NEAR(threshold(on_a_slope, 0.01, 1.2), atan(fmin(given.mu, 0.3)),
                   EDGE);
        given.b = 3;
        CHECK_NEAR(threshold(on_a_slope, 0.01, 1.2), atan(given.mu), EDGE);
    }
    given.mu = 0.84;
    given.b = 1;
    given.n = 2;
    angle = threshold(on_a_slope, 0.01, 1.2);
    CHECK_NEAR(angle, atan(0.5), EDGE);
    CHECK_NEAR(angle * 180 / pi, 26.565, SINGLE ? 0.1 : 6e-4);
}

/* ---- a column of n cubes ---- */

/* By hand: under f W sideways at every centre it slides at f = mu, and the
   whole topples about its lowest corner where f n / 2 = 1/2. */

static void column_of(world *w, int n)
{
    int i;
    world_reset(w);
    world_box(w, 0, -3, -1, 4, 0);
    for (i = 0; i < n; i++)
        world_box(w, 1, 0, i, 1, i + 1);
    CHECK_INT(world_touch(w), 2 * n);
}

static void known_column(void)
{
    static world w;
    double factor, angle;
    int n, side;
    for (n = 1; n <= 10; n++)
        for (side = -1; side <= 1; side += 2) {
            const double want = fmin((double)R(0.84), 1.0 / n);
            column_of(&w, n);
            world_friction(&w, 0.84);
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(factor, want, EDGE);
            CHECK_INT(tilt(&w, side, &angle), KERN_STANDS);
            CHECK_NEAR(tan(angle), want, 2 * EDGE);
        }
}

/* ---- a cube shifted on a cube ---- */

/* By hand: the weight passes the end of the bed at a shift of 1/2. */

static void known_offset(void)
{
    CHECK_NEAR(threshold(shifted_cube, 0.1, 0.8), 0.5, EDGE);
    CHECK_NEAR(threshold(shifted_cube, -0.1, -0.8), -0.5, EDGE);
    {
        /* centred, the ends carry the weight together and no torque: see also
           proof_forces_of_a_cube; closed, the one point carries it */
        static world w;
        shifted_cube(&w, 0);
        CHECK_INT(verdict(&w, 0.25), KERN_STANDS);
        CHECK_NEAR(force_of[0].normal + force_of[1].normal, 9.81,
                   9.81 * 2 * PROOF_TOL);
        CHECK_NEAR(force_of[0].normal, force_of[1].normal,
                   9.81 * 8 * PROOF_TOL);
    }
}

/* ---- a box shifted on a box ---- */

/* By hand: the weight of the upper box passes its bed s from the middle, so
   the bed may shrink to 2 s: d* = 1/2 - s at each end. The literal Algorithm 1
   does not end for s = 0: there it is saturated, 0.5 / 0.02 + 1 = 26 steps. */

static void known_boxes(void)
{
    static const double shift[] = {0.1, 0.25, 0.4};
    static world w;
    kern_margin m;
    int k, side;
    for (k = 0; k < 3; k++)
        for (side = -1; side <= 1; side += 2) {
            const double want = 0.5 - shift[k];
            stack_of_two(&w, side * shift[k]);
            w.options.epsilon = R(0.03);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, want, EXACT);
            CHECK_INT(m.level, (int)floor(want / 0.03) + 1);
            CHECK(!m.saturated);
            CHECK_NEAR(m.most, 0.5, GEO);
            check_bracket(&w, &m);
            CHECK_INT(verdict(&w, want - EDGE), KERN_STANDS);
            CHECK_INT(verdict(&w, want + EDGE), KERN_FALLS);
        }
    stack_of_two(&w, 0);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(m.margin, 0.5, GEO);
    CHECK_INT(m.level, SINGLE ? m.level : 26);
    w.options.epsilon = R(0.03);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK_INT(m.level, 18);
    CHECK_INT(verdict(&w, 100), KERN_STANDS);
}

/* ---- a lintel on two piers ---- */

/* By hand: each bearing [0, 1] carries half of the weight anywhere in it, so it
   stands with every kern closed. */

static void known_lintel(void)
{
    static world w;
    kern_margin m;
    int free_piers;
    for (free_piers = 0; free_piers < 2; free_piers++) {
        world_reset(&w);
        world_box(&w, 0, -2, -1, 8, 0);
        world_box(&w, free_piers, 0, 0, 1, 2);
        world_box(&w, free_piers, 4, 0, 5, 2);
        world_box(&w, 1, 0, 2, 5, 2.5);
        CHECK_INT(world_touch(&w), free_piers ? 8 : 4);
        w.options.epsilon = R(0.07);
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated);
        CHECK_NEAR(m.margin, 0.5, GEO);
        CHECK_INT(m.level, 9);
        CHECK_INT(verdict(&w, 0.5), KERN_STANDS);
        CHECK_INT(verdict(&w, 5), KERN_STANDS);
        w.options.relative = 1;
        CHECK_INT(measure(&w, &m), KERN_STANDS);
        CHECK(m.saturated);
        CHECK_INT(m.level, 16);
    }
}

/* ---- the harmonic stack ---- */

/* By hand: without friction the i-th brick from the top may overhang the next
   by 1 / (2 i); the overhang of n is half the harmonic number. */

/* Brick i from the top overhangs the one below by x / (2 i); the table ends at
   x = 0. */
static void harmonic_stack(world *w, double x)
{
    double right = 0;
    int i;
    world_reset(w);
    w->options.mu = R(0);
    for (i = given.n; i >= 1; i--)
        right += x / (2 * i);
    world_box(w, 0, -9, -1, 0, 0);
    for (i = 1; i <= given.n; i++) {
        const double y = given.n - i;
        world_box(w, 1, right - 1, y, right, y + 1);
        right -= x / (2 * i);
    }
    CHECK_INT(world_touch(w), 2 * given.n);
}

static void known_harmonic_stack(void)
{
    static const int bricks[] = {1, 2, 3, 4, 5, 10};
    static const double overhang[] = {0.5,     0.75,    0.91667,
                                      1.04167, 1.14167, 1.46448};
    static world w;
    const double off = SINGLE ? 3e-3 : 1e-4;
    int k;
    for (k = 0; k < 6; k++) {
        given.n = bricks[k];
        harmonic_stack(&w, 1);
        CHECK_NEAR((double)w.block[1].centre.x + 0.5, overhang[k], 6e-6);
        harmonic_stack(&w, 1 - off);
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        harmonic_stack(&w, 1 + off);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
        CHECK_NEAR(threshold(harmonic_stack, 0.9, 1.1), 1, given.n * EDGE);
    }
}

/* ---- a ladder ---- */

/* By hand: a uniform rod against a wall, friction mu at both ends, slips below
   90 degrees - 2 atan(mu): the lines of both friction cones' edges meet above
   the middle. */

/* A rod of length 2 at the angle x to the floor, its upper end at the wall. */
static void ladder(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 1, cos(x), sin(x), 0.3);
    w->mu = given.mu;
    world_point(w, 0, 1, 0, 1, 0, 0);
    world_point(w, 0, 1, -1, 0, 2 * cos(x), 2 * sin(x));
    /* floor and wall are two interfaces: two blocks */
    world_mass(w, 0, 0, 0, 1);
    w->contact[1].a = 2;
    world_touch(w);
}

static double ladder_slips(double mu) { return pi / 2 - 2 * atan(mu); }

/* The angle at which rods slip, between one that stands and one that falls, for
   three coefficients of friction. */
static void rods_slip(void (*build)(world *, double), double stands,
                      double falls, double (*angle)(double),
                      const double degrees[3])
{
    static const double mu[] = {0.2, 0.4, 0.5};
    int k;
    for (k = 0; k < 3; k++) {
        double found;
        given.mu = (double)R(mu[k]);
        found = threshold(build, stands, falls);
        CHECK_NEAR(found, angle(given.mu), 4 * EDGE);
        CHECK_NEAR(found * 180 / pi, degrees[k], SINGLE ? 0.3 : 6e-4);
    }
}

static void known_ladder(void)
{
    static const double degrees[] = {67.380, 46.397, 36.870};
    rods_slip(ladder, 1.5, 0.1, ladder_slips, degrees);
}

/* ---- an A-frame ---- */

/* By hand: at the apex the forces are horizontal, at each foot N = W and
   R = W tan(a) / 2, so tan(a) = 2 mu. */

/* Two rods of length 2 that lean on each other, x from the vertical. */
static void a_frame(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 1, -sin(x), cos(x), 0.3);
    world_mass(w, 1, sin(x), cos(x), 0.3);
    w->mu = given.mu;
    world_point(w, 0, 1, 0, 1, -2 * sin(x), 0);
    world_point(w, 0, 2, 0, 1, 2 * sin(x), 0);
    world_point(w, 1, 2, 1, 0, 0, 2 * cos(x));
    world_touch(w);
}

static double a_frame_slips(double mu) { return atan(2 * mu); }

static void known_a_frame(void)
{
    static const double degrees[] = {21.801, 38.660, 45};
    rods_slip(a_frame, 0.05, 1.4, a_frame_slips, degrees);
}

/* ---- arches ---- */

/* Thin: the least t / R of a semicircle of N voussoirs whose joints do not slip;
   digits of two independent linear programs, and for N without end
   Milankovitch's .1075. Sliding: the arch of M. Gilbert, C. Casapulla and H. M.
   Ahmed, Limit analysis of masonry block structures with non-associative
   frictional joints using linear programming, Computers and Structures 84
   (2006); N = 27, R = 10. */

/* A semicircular arch of given.n voussoirs, centreline radius given.a,
   thickness x, between two fixed springings. */
static void semicircle(world *w, double x)
{
    const double r = given.a, step = pi / given.n;
    int i;
    world_reset(w);
    w->options.mu = R(given.mu);
    for (i = 0; i < given.n; i++)
        world_voussoir(w, 1, i * step, (i + 1) * step, r - x / 2, r + x / 2);
    world_box(w, 0, r - x, -r / 2, r + x, 0);
    world_box(w, 0, -r - x, -r / 2, -r + x, 0);
    CHECK_INT(world_touch(w), 2 * (given.n + 1));
}

static void known_thin_arch(void)
{
    static const int n[] = {4, 5, 6, 8, 10, 15, 20, 31, 51, 101};
    static const double ratio[] = {.09736, .09498, .10413, .09997, .10701,
                                   .10607, .10735, .10713, .10736, .10745};
    static world w;
    int k;
    given.mu = 1;
    given.a = 1;
    for (k = 0; k < 10; k++) {
        given.n = n[k];
        sprintf(context, "(arch of %d)", n[k]);
        /* what a hundred voussoirs sum up is more than float can tell closely
         */
        semicircle(&w, ratio[k] + (SINGLE ? 2e-3 : DIGITS5));
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        semicircle(&w, ratio[k] - (SINGLE ? 2e-3 : DIGITS5));
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    context[0] = 0;
    given.n = 10;
    CHECK_NEAR(threshold(semicircle, 0.2, 0.05), 0.10701,
               SINGLE ? 1e-3 : DIGITS5);
}

static void known_sliding_arch(void)
{
    static const double mu[] = {.31, .325, .35, .375, .39, .396, .5, 1};
    static const double least[] = {1.9600, 1.7821, 1.5119, 1.2597,
                                   1.1163, 1.0672, 1.0672, 1.0672};
    static const double thick[] = {1.1, 1.2, 1.5, 2.0};
    static const double margin[] = {.01638, .06633, .21617, .46581};
    static const double factor4[] = {0, .02028, .05235, .09909};
    static const double factor7[] = {0, .04843, .14534, .28434};
    static world w;
    kern_margin m;
    double factor;
    int k, side;
    given.a = 10;
    given.n = 27;
    for (k = 0; k < 8; k++) {
        const double off = SINGLE ? 3e-2 : 6e-5;
        given.mu = mu[k];
        sprintf(context, "(mu %g)", mu[k]);
        semicircle(&w, least[k] + off);
        CHECK_INT(verdict(&w, 0), KERN_STANDS);
        semicircle(&w, least[k] - off);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    given.mu = 0.308;
    for (k = 0; k < 5; k++) {
        static const double any[] = {1, 1.5, 2, 3, 5};
        semicircle(&w, any[k]);
        CHECK_INT(verdict(&w, 0), KERN_FALLS);
    }
    for (k = 0; k < 4; k++) {
        double friction;
        for (friction = 0.4; friction < 1.2; friction += 0.3) {
            given.mu = friction;
            sprintf(context, "(thickness %g, mu %g)", thick[k], friction);
            semicircle(&w, thick[k]);
            CHECK_INT(measure(&w, &m), KERN_STANDS);
            CHECK_NEAR(m.margin, margin[k], SINGLE ? 2e-3 : 6e-6);
            CHECK_INT(m.level,
                      (int)floor((double)m.margin / (double)m.epsilon) + 1);
            if (k == 0 || friction > 0.8)
                continue;
            for (side = -1; side <= 1; side += 2) {
                CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
                CHECK_NEAR(factor, friction < 0.5 ? factor4[k] : factor7[k],
                           SINGLE ? 2e-3 : 6e-6);
            }
        }
    }
    context[0] = 0;
}

/* ---- two bodies, four contacts ---- */

/* K. M. Lynch and F. C. Park, Modern Robotics (2017), ch. 12, an exercise; the
   threshold of mu by hand: 10/31. */

/* Mass of the second body given.a, friction of the first contact x. */
static void two_bodies(world *w, double x)
{
    world_reset(w);
    world_mass(w, 0, 0, 0, 1);
    world_mass(w, 2, 25, 35, 40);
    world_mass(w, given.a, 66, 42, 40);
    w->mu = x;
    world_point(w, 0, 1, 0, 1, 0, 0);
    w->mu = 0.5;
    world_point(w, 2, 1, -1, 0, 60, 60);
    world_point(w, 0, 2, 0, 1, 60, 0);
    world_point(w, 0, 2, 0, 1, 72, 0);
    world_touch(w);
}

static void known_two_bodies(void)
{
    static world w;
    given.a = 5;
    two_bodies(&w, 0.1);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    given.a = 10;
    two_bodies(&w, 0.5);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_NEAR(w.contact[2].travel, -6, GEO);
    CHECK_NEAR(w.contact[3].travel, 6, GEO);
    CHECK_NEAR(threshold(two_bodies, 0.5, 0.1), 10. / 31, 8 * EDGE);
}

/* ---- a jam ---- */

/* The known limit of statics by forces alone: walls may press as hard as they
   like, and nothing says that they do. */

static void known_jam(void)
{
    static world w;
    kern_margin m;
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 0, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 4);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    world_friction(&w, 0.01);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    /* the force needed is W / (2 mu) on each side, W / mu in all: the bound on
       forces is where it ends */
    world_friction(&w, 4 / FORCE_BOUND);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    world_friction(&w, 0.1 / FORCE_BOUND);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    world_friction(&w, 0);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    /* two free cubes in the air */
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    CHECK_INT(world_touch(&w), 2);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    CHECK_INT(measure(&w, &m), KERN_FALLS);
}

/* ---- walls with openings ---- */

/* Walls 1, 3 and 4 of M. C. Ferris and F. Tin-Loi, Limit analysis of frictional
   block assemblies as a mathematical program with complementarity constraints,
   Int. J. Mech. Sci. 43 (2001); here with associative friction, digits of two
   independent linear programs. Blocks are .4 x .175. */

/* Courses from the bottom, ended by 0: block lengths in blocks, -1 an opening
   one block wide. */
#define H 0.5
static const double wall1[][10] = {{H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {H, 1, 1, 1, 1, H},
                                   {1, 1, 1, 1, 1},
                                   {0}};
static const double wall3[][10] = {
    {1, 1, 1, 1},     {H, 1, 1, 1, H},  {1, 1, 1, 1},     {H, 1, -1, 1, H},
    {1, H, -1, H, 1}, {H, 1, -1, 1, H}, {1, H, -1, H, 1}, {H, 1, -1, 1, H},
    {1, 1, 1, 1},     {H, 1, 1, 1, H},  {1, 1, 1, 1},     {0}};
static const double wall4[][10] = {
    {H, 1, 1, 1, 1, H},         {1, 1, 1, 1, 1},
    {H, 1, 1, 1, 1, H},         {1, -1, 1, -1, 1},
    {H, H, -1, H, H, -1, H, H}, {1, -1, 1, -1, 1},
    {H, H, -1, H, H, -1, H, H}, {1, -1, 1, -1, 1},
    {H, 1, 1, 1, 1, H},         {1, 1, 1, 1, 1},
    {H, 1, 1, 1, 1, H},         {0}};

static void brick_wall(world *w, const double (*course)[10], double mu,
                       int heads)
{
    int i, k, kept = 0;
    world_reset(w);
    w->options.mu = R(mu);
    world_box(w, 0, -1, -1, 3, 0);
    for (i = 0; course[i][0] > 0; i++) {
        double x = 0;
        for (k = 0; k < 10 && (course[i][k] > 0 || course[i][k] < 0); k++) {
            const double long_as = 0.4 * fabs(course[i][k]);
            if (course[i][k] > 0)
                world_box(w, 1, x, 0.175 * i, x + long_as, 0.175 * (i + 1));
            x += long_as;
        }
    }
    CHECK(world_touch(w) > 0);
    if (heads)
        return;
    for (k = 0; k < w->contacts; k++)
        if (fabs((double)w->contact[k].n.y) > 0.5)
            w->contact[kept++] = w->contact[k];
    w->contacts = kept;
}

static void known_walls(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const int blocks[3] = {33, 46, 55}, contacts[3] = {83, 102, 116};
    static const double mu[3] = {0.65, 0.4, 0.2};
    static const double factors[3][3] = {
        {.64286, .4, .2}, {.40369, .36189, .2}, {.33195, .27561, .2}};
    static const double headless[3] = {.63997, .35901, .28540};
    static const double margin[3] = {0, .09509, .08932};
    static world w;
    kern_margin m;
    double factor, tol = SINGLE ? 2e-3 : 6e-6;
    int i, k, side;
    for (i = 0; i < 3; i++) {
        sprintf(context, "(wall %d)", i > 0 ? i + 2 : 1);
        for (k = 0; k < 3; k++) {
            brick_wall(&w, wall[i], mu[k], 1);
            CHECK_INT(w.blocks - 1, blocks[i]);
            CHECK_INT(w.contacts, 2 * contacts[i]);
            CHECK_INT(lines_of(&w), contacts[i]);
            for (side = -1; side <= 1; side += 2) {
                CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
                CHECK_NEAR(factor, factors[i][k], tol);
            }
            if (k == 1) {
                CHECK_INT(measure(&w, &m), KERN_STANDS);
                CHECK_INT(m.saturated, i == 0);
                if (i > 0)
                    CHECK_NEAR(m.margin, margin[i], SINGLE ? 1e-3 : 6e-6);
                check_bracket(&w, &m);
            }
        }
        brick_wall(&w, wall[i], 0.65, 0);
        for (side = -1; side <= 1; side += 2) {
            CHECK_INT(load_factor(&w, NULL, side, &factor), KERN_STANDS);
            CHECK_NEAR(factor, headless[i], tol);
        }
    }
    context[0] = 0;
}

/* ---- a tower, and a trapezoid on a steep face ---- */

/* By hand: ten cubes stand on each other; one face alone, at 60 degrees, holds
   where mu is more than tan 60 degrees. */

/* A trapezoid on a face of 60 degrees, its weight over the face. */
static void on_steep_face(world *w, double x)
{
    const double s = sqrt(3);
    double ground[6] = {0, 0, 1, 0, 1, 0}, stone[8] = {0, 0, 1, 0, 1, 3, 0, 1};
    ground[5] = s;
    stone[3] = s;
    world_reset(w);
    w->options.mu = R(x);
    world_polygon(w, 0, ground, 3);
    world_polygon(w, 1, stone, 4);
    CHECK_INT(world_touch(w), 2);
}

static void known_tower_and_trapezoid(void)
{
    static world w;
    kern_margin m;
    column_of(&w, 10);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    CHECK_INT(measure(&w, &m), KERN_STANDS);
    CHECK(m.saturated);
    CHECK_NEAR(threshold(on_steep_face, 3, 1), sqrt(3), 8 * EDGE);
}

/* ---- laws ---------------------------------------------------- >>laws */

/* `t`, a changed `w`, has the margin of `w` times `scale`, the same verdict
   and the same level; or what differs is an open question. */
static void same_result(const world *w, const kern_margin *m, int got,
                        const world *t, double scale, double tol, int line)
{
    kern_margin n;
    const int now = measure(t, &n);
    same_answer(w, m, got, &n, now, scale, tol, line);
}

/* `t` is at least as good as `w`. */
static void not_worse(const world *w, const kern_margin *m, int got,
                      const world *t, double tol, int line)
{
    kern_margin n;
    const double unit = w->options.relative ? 1 : mean_size(w);
    const int now = measure(t, &n);
    if (got != KERN_STANDS || (SINGLE && now < 0))
        return;
    if (now != KERN_STANDS) {
        if (!open_question(w, 0))
            check_near(now, got, 0, line, "verdict of what is not worse");
        return;
    }
    if ((double)n.margin < (double)m->margin - tol * unit
        && !open_question(w, ((double)n.margin + (double)m->margin) / 2))
        check_near((double)n.margin, (double)m->margin, tol * unit, line,
                   "margin of what is not worse");
    passed++;
}

static double law_tolerance(const world *w)
{
    return SINGLE ? 2e-3 : twin_nested(w) ? 2e-9 : 3e-6;
}

static void laws_units_and_places(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, trial;
    for (seed = 0; seed < some(1200); seed++) {
        kern_margin m;
        int got;
        random_world(&w, 100000u + (unsigned long long)seed, 40);
        got = measure(&w, &m);
        CHECK(decided(got));
        for (trial = 0; trial < 7; trial++) {
            change c = no_change();
            double tol = law_tolerance(&w);
            switch (trial) {
            case 0: c.scale = pow(10, uniform(-3, 3)); break;
            case 1: c.mass = pow(10, uniform(-6, 6)); break;
            case 2:
                /* 1e4 diameters, and what their rounding is to a block */
                c.dx = (SINGLE ? 3 : 1e4) * 2 * (reach_of(&w) + mean_size(&w));
                c.dy = -c.dx / 2;
                tol += 64 * EPS * c.dx / mean_size(&w);
                break;
            case 3: c.mirror = 1; break;
            case 4: c.angle = uniform(-pi, pi); break;
            case 5: c.shuffle = 1; break;
            default:
                c.scale = seed % 2 ? 1e3 : 1e-3;
                c.mass = seed % 3 ? 1e6 : 1e-6;
                c.angle = uniform(-pi, pi);
                c.shuffle = 1;
                c.mirror = chance(0.5);
            }
            /* mass times gravity is what counts: loads go with the mass */
            world_changed(&t, &w, &c, order);
            same_result(&w, &m, got, &t, c.scale, tol, __LINE__);
        }
    }
    context[0] = 0;
}

/* The load factor `now` of a structure like w, whose own is `want`, below 0
   where it falls. Returns 1 where the two were compared. */
static int check_same_load(const world *w, int got, double now, double want)
{
    if ((SINGLE && got < 0) || want >= 100)
        return 0;
    if (want < 0) {
        if (got != KERN_FALLS && !open_question(w, 0))
            CHECK_INT(got, KERN_FALLS);
        return 0;
    }
    if (got != KERN_STANDS && open_question(w, 0))
        return 1;
    CHECK_INT(got, KERN_STANDS);
    CHECK_NEAR(now, want, (SINGLE ? 5e-3 : 2e-6) * (1 + want));
    return 1;
}

static void laws_load_factor(void)
{
    static world w, t;
    static int order[MAX_BLOCKS];
    int seed, trial, side, found = 0;
    for (seed = 0; seed < 300; seed++) {
        double factor[3];
        random_world(&w, 140000u + (unsigned long long)seed, 15);
        for (side = -1; side <= 1; side += 2)
            if (load_factor(&w, NULL, side, &factor[side + 1]) != KERN_STANDS)
                factor[side + 1] = -1;
        for (trial = 0; trial < 3; trial++) {
            change c = no_change();
            c.scale = trial == 0 ? pow(10, uniform(-3, 3)) : 1;
            c.mass = trial == 0 ? pow(10, uniform(-6, 6)) : 1;
            c.angle = trial == 1 ? uniform(-pi, pi) : 0;
            c.mirror = trial == 1;
            c.shuffle = trial == 2;
            world_changed(&t, &w, &c, order);
            for (side = -1; side <= 1; side += 2) {
                double now;
                const int got = load_factor(&t, NULL, side, &now);
                found += check_same_load(&w, got, now,
                                         factor[(c.mirror ? -side : side) + 1]);
            }
        }
    }
    context[0] = 0;
    CHECK(found > 200);
}

static void laws_more_support(void)
{
    static world w, t;
    int seed, k;
    for (seed = 0; seed < some(1500); seed++) {
        kern_margin m;
        const int kind = random_world(&w, 160000u + (unsigned long long)seed,
                                      25);
        const int got = measure(&w, &m);
        const double tol = law_tolerance(&w);
        int b;
        (void)kind;
        CHECK(decided(got));
        /* more friction */
        world_copy(&t, &w);
        for (k = 0; k < t.contacts; k++)
            t.contact[k].mu = R((double)t.contact[k].mu * uniform(1, 2)
                                + uniform(0, 0.1));
        not_worse(&w, &m, got, &t, tol, __LINE__);
        /* a fixed block more, against any free block anywhere */
        world_copy(&t, &w);
        do
            b = random_int(0, w.blocks - 1);
        while (w.block[b].fixed);
        {
            const double lean = uniform(-pi, pi),
                         r = 0.4 * sqrt(fabs((double)w.block[b].area));
            const double x = (double)w.block[b].centre.x - r * sin(lean);
            const double y = (double)w.block[b].centre.y - r * cos(lean);
            const int ground = world_mass(&t, 0, x, y - 1, 1);
            const double half = chance(0.5) ? 0.2 * r : 0;
            world_line(&t, ground, b, sin(lean), cos(lean),
                       x - half * cos(lean), y + half * sin(lean),
                       x + half * cos(lean), y - half * sin(lean));
        }
        kern_contact_travels(t.contact, t.contacts);
        not_worse(&w, &m, got, &t, tol, __LINE__);
    }
    context[0] = 0;
}

/* Two structures in one: contacts and blocks of `b` behind those of `a`. */
static void world_joined(world *to, const world *a, const world *b, double dx)
{
    int i, k;
    world_copy(to, a);
    for (i = 0; i < b->blocks; i++) {
        kern_block *t = &to->block[to->blocks + i];
        *t = b->block[i];
        t->vertex = NULL; /* contacts are given from here on */
        t->vertices = 0;
        t->centre.x += R(dx);
    }
    for (k = 0; k < b->contacts; k++) {
        kern_contact *t = &to->contact[to->contacts + k];
        *t = b->contact[k];
        t->a += to->blocks;
        t->b += to->blocks;
        t->p.x += R(dx);
    }
    to->blocks += b->blocks;
    to->contacts += b->contacts;
    to->given = 1;
}

/* The margin of two structures side by side; one that is saturated stands at
   any shrinkage. */
static double least_margin(const kern_margin *m, const kern_margin *n)
{
    if (m->saturated && n->saturated)
        return fmax((double)m->margin, (double)n->margin);
    if (m->saturated || n->saturated)
        return (double)(m->saturated ? n : m)->margin;
    return fmin((double)m->margin, (double)n->margin);
}

/* Two structures stand side by side where both stand. Returns 1 where they
   do. */
static int check_both(const world *a, int got_a, const world *b, int got_b,
                      int got)
{
    const int stand = got_a == KERN_STANDS && got_b == KERN_STANDS;
    if (got != (stand ? KERN_STANDS : KERN_FALLS)) {
        CHECK(decided(got) && decided(got_a) && decided(got_b));
        if (got >= 0 && got_a >= 0 && got_b >= 0 && !open_question(a, 0)
            && !open_question(b, 0))
            CHECK(!"verdict of two side by side");
        return 0;
    }
    return stand;
}

static void laws_side_by_side(void)
{
    static world a, b, both;
    int seed, stand = 0;
    for (seed = 0; seed < some(1000); seed++) {
        kern_margin m, n, o;
        int got_a, got_b, got;
        double want, unit;
        random_world(&a, 180000u + (unsigned long long)(2 * seed), 20);
        random_world(&b, 180001u + (unsigned long long)(2 * seed), 20);
        b.gravity = a.gravity;
        b.options = a.options;
        a.options.gap = R(0);
        got_a = measure(&a, &m);
        got_b = measure(&b, &n);
        world_joined(&both, &a, &b, SINGLE ? 10 : 100);
        got = measure(&both, &o);
        if ((SINGLE && (got < 0 || got_a < 0 || got_b < 0))
            || !check_both(&a, got_a, &b, got_b, got))
            continue;
        stand++;
        want = least_margin(&m, &n);
        unit = a.options.relative ? 1 : mean_size(&both);
        if (fabs((double)o.margin - want)
                > 4 * unit * fmax(law_tolerance(&a), law_tolerance(&b))
            && !open_question(&both, ((double)o.margin + want) / 2))
            CHECK_NEAR(o.margin, want, 0);
        passed++;
    }
    context[0] = 0;
    CHECK(stand > some(100));
}

/* ---- against the independent solver ---------------------------- >>against */

static long compare_many(long first, long many, int most, int deep_every)
{
    static world w;
    long k, kinds[KINDS] = {0}, stand = 0;
    const long before = undecided;
    for (k = 0; k < many; k++) {
        const int kind = random_world(
            &w, 1000000u + (unsigned long long)(first + k), most);
        kinds[kind]++;
        compare_with_twin(&w, deep_every > 0 && k % deep_every == 0);
        stand += twin_shortfall(&w, 0, FORCE_BOUND) <= NEAR_LO;
    }
    context[0] = 0;
    /* the sample must be worth something */
    if (many >= 500) {
        for (k = 0; k < KINDS; k++)
            CHECK(kinds[k] > many / (4 * KINDS));
        CHECK(stand > many / 10 && stand < many * 9 / 10);
    }
    return undecided - before;
}

static void twin_random(void)
{
    const long none = compare_many(0, some(3000), 12, 6)
                    + compare_many(500000, some(250), 40, 25);
    CHECK(SINGLE || none == 0);
    /* near the edge the twin leaves the question open: must be rare */
    CHECK(twin_near * 50 < twin_asked);
}

/* Lays a polygon whose corners are along u and up from a place. */
static void lay_along(world *w, int free_one, double x, double y, double angle,
                      const double *local, int corners)
{
    double xy[8];
    int k;
    for (k = 0; k < corners; k++) {
        const double u = local[2 * k], v = local[2 * k + 1];
        xy[2 * k] = x + u * cos(angle) - v * sin(angle);
        xy[2 * k + 1] = y + u * sin(angle) + v * cos(angle);
    }
    world_polygon(w, free_one ? uniform(0.5, 2) : 0, xy, corners);
}

/* Storeys of a beam on the tips of two wedges, which stand on the beam below
   and differ in height, so that every beam leans. */
static void random_tips(world *w, int storeys)
{
    const double ground[8] = {-9, -1, 9, -1, 9, 0, -9, 0};
    double x = -2, y = 0, angle = 0;
    int i, side;
    world_reset(w);
    w->options.mu = R(uniform(0.3, 0.9));
    w->options.relative = chance(0.3);
    w->options.epsilon = R(uniform(0.02, 0.1));
    lay_along(w, 0, 0, 0, 0, ground, 4);
    for (i = 0; i < storeys; i++) {
        double tip[2][2];
        for (side = 0; side < 2; side++) {
            const double at = side ? uniform(2.5, 3.5) : uniform(0.5, 1.6);
            const double high = uniform(0.6, 0.7);
            const double wedge[6] = {at - 0.4, 0, at + 0.4, 0, at, high};
            lay_along(w, 1, x, y, angle, wedge, 3);
            tip[side][0] = x + at * cos(angle) - high * sin(angle);
            tip[side][1] = y + at * sin(angle) + high * cos(angle);
        }
        angle = atan2(tip[1][1] - tip[0][1], tip[1][0] - tip[0][0]);
        {
            const double back = uniform(0.2, 1), thick = uniform(0.2, 0.4);
            const double beam[8] = {-back,    0,     4 - back, 0,
                                    4 - back, thick, -back,    thick};
            lay_along(w, 1, tip[0][0], tip[0][1], angle, beam, 4);
            x = tip[0][0] - back * cos(angle) - thick * sin(angle);
            y = tip[0][1] - back * sin(angle) + thick * cos(angle);
        }
    }
}

/* The same where lone points travel: most of these kerns are not nested. */
static void twin_lone_points(void)
{
    static world w;
    int seed, lone = 0, stand = 0;
    for (seed = 0; seed < some(200); seed++) {
        kern_margin stays, travels;
        random_seed(1900000u + (unsigned long long)seed);
        random_tips(&w, 1 + seed % 3);
        sprintf(context, "(tips %d)", seed);
        CHECK(world_touch(&w) > 0);
        if (measure(&w, &stays) != KERN_STANDS)
            continue;
        w.options.lone = w.gravity;
        world_touch(&w);
        check_contacts(&w);
        CHECK(measure(&w, &travels) == KERN_STANDS || SINGLE);
        compare_with_twin(&w, 0);
        lone += !twin_nested(&w);
        stand++;
    }
    context[0] = 0;
    CHECK(stand > some(30) && lone == stand);
}

/* ==== Bad input ===================================================== >>bad */

/* Every entry that takes a structure says the same of a bad one. */
static void all_say(const kern_structure *s, const kern_options *o,
                    kern_work *work, int want, int block, int index, int line)
{
    kern_margin m;
    kern_real out = R(7), value[MAX_BLOCKS];
    kern_collapse all;
    int k;
    all.mean = R(7);
    memset(&m, 0x55, sizeof m);
    for (k = 0; k < 6; k++) {
        kern_margin keep = m;
        int got;
        if (work)
            work->fault.block = work->fault.index = -77;
        got = k == 0 ? kern_verdict(task_of(s, o, work), 0, NULL)
            : k == 1 ? kern_measure(task_of(s, o, work), &m, NULL)
            : k == 2 ? kern_deficit(task_of(s, o, work), &out)
            : k == 3 ? kern_load_factor(task_of(s, o, work), 0, KERN_RIGHT,
                                        &out, NULL)
            : k == 4
                ? kern_tilt(task_of(s, o, work), 0, KERN_RIGHT, &out, NULL)
                : kern_profile(task_of(s, o, work), KERN_SHRINK, value, &all);
        check_near(got, want, 0, line, "status of a bad structure");
        /* nothing but the fault is touched */
        check_report(!memcmp(&keep, &m, sizeof m), line, "margin untouched", 0,
                     0, 0);
        check_near((double)out, 7, 0, line, "result untouched");
        check_near((double)all.mean, 7, 0, line, "means untouched");
        if (work && block >= -1)
            check_near(work->fault.block, block, 0, line, "fault.block");
        if (work && index >= -1)
            check_near(work->fault.index, index, 0, line, "fault.index");
    }
}

/* A field of the world with a value that makes the structure bad, and what the
   library says: a status, and in the fault the index of a block or a contact
   (-2: any). Blocks 0, 1, 2 stand on each other; contacts 0 and 1 lie between
   the first two, 2 and 3 between the last two. */
typedef struct spoilt {
    int line;
    size_t field;
    int whole; /* nonzero: the field is an int */
    double value;
    int want, block, index;
} spoilt;

#define REAL(field, value, want, block, index)                         \
    {                                                                  \
        __LINE__, offsetof(world, field), 0, value, want, block, index \
    }
#define WHOLE(field, value, want, block, index)                        \
    {                                                                  \
        __LINE__, offsetof(world, field), 1, value, want, block, index \
    }

static const spoilt bad_values[] = {
    WHOLE(blocks, -1, KERN_BAD_COUNT, -2, -2),
    WHOLE(contacts, -1, KERN_BAD_COUNT, -2, -2),
    WHOLE(blocks, 2147483647, KERN_BAD_COUNT, -2, -2),
    WHOLE(contacts, 2147483647, KERN_BAD_COUNT, -2, -2),
    REAL(block[1].mass, 0, KERN_BAD_MASS, 1, -2),
    REAL(block[1].mass, -3, KERN_BAD_MASS, 1, -2),
    REAL(contact[1].mu, -0.1, KERN_BAD_FRICTION, -2, 1),
    WHOLE(contact[2].a, -1, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].b, 3, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].b, 2147483647, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].a, -2147483648.0, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[0].a, 1, KERN_SAME_BLOCK, -2, 0),
    REAL(contact[0].n.y, 0, KERN_BAD_NORMAL, -2, 0),
    REAL(options.epsilon, -1, KERN_BAD_OPTION, -2, -2),
    WHOLE(options.limit, -1, KERN_BAD_OPTION, -2, -2),
    WHOLE(options.limit, 2000000001, KERN_BAD_OPTION, -2, -2),
};

#define NUMBER(field, block, index) \
    REAL(field, 0, KERN_BAD_NUMBER, block, index)
static const spoilt numbers_of_a_structure[] = {
    NUMBER(block[2].mass, 2, -2),     NUMBER(block[2].centre.x, 2, -2),
    NUMBER(block[2].centre.y, 2, -2), NUMBER(block[2].load.fx, 2, -2),
    NUMBER(block[2].load.fy, 2, -2),  NUMBER(block[2].load.torque, 2, -2),
    NUMBER(block[2].area, 2, -2),     NUMBER(contact[3].p.x, -2, 3),
    NUMBER(contact[3].p.y, -2, 3),    NUMBER(contact[3].n.x, -2, 3),
    NUMBER(contact[3].n.y, -2, 3),    NUMBER(contact[3].mu, -2, 3),
    NUMBER(contact[3].travel, -2, 3), NUMBER(gravity.x, -2, -2),
    NUMBER(gravity.y, -2, -2),        NUMBER(options.epsilon, -2, -2),
};

static void spoil(world *w, const spoilt *row, double value)
{
    void *field = (char *)w + row->field;
    if (row->whole)
        *(int *)field = (int)value;
    else
        *(kern_real *)field = R(value);
}

/* Calls say() of each row with its own value, and of each of a second table
   with all that is not a number. */
static void spoil_each(const world *good, const spoilt *row, int rows,
                       const spoilt *number, int numbers,
                       void (*say)(const world *, const spoilt *, double))
{
    int i, j;
    for (i = 0; i < rows; i++)
        say(good, &row[i], row[i].value);
    for (i = 0; i < numbers; i++)
        for (j = 0; j < NO_NUMBERS; j++)
            say(good, &number[i], no_number(j));
}

/* Every entry, asked about a stack of two in which one field has a value. */
static void say_of_row(const world *good, const spoilt *row, double value)
{
    static world w;
    kern_structure s;
    kern_work work = work_of(good);
    world_copy(&w, good);
    spoil(&w, row, value);
    s = structure_of(&w);
    all_say(&s, &w.options, &work, row->want, row->block, row->index,
            row->line);
}

static void bad_structure(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    int i;
    stack_of_two(&w, 0.25);
    CHECK_INT(w.contacts, 4);
    s = structure_of(&w);
    work = work_of(&w);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_STANDS);
    spoil_each(&w, bad_values, COUNT_OF(bad_values), numbers_of_a_structure,
               COUNT_OF(numbers_of_a_structure), say_of_row);
    /* no block, the ground alone, nothing but fixed blocks */
    work = work_of(&w);
    s.contacts = 0;
    for (i = 0; i < 2; i++) {
        s.blocks = i;
        all_say(&s, &w.options, &work, KERN_NO_FREE, -2, -2, __LINE__);
    }
    s = structure_of(&w);
    w.block[1].fixed = w.block[2].fixed = 1;
    all_say(&s, &w.options, &work, KERN_NO_FREE, -2, -2, __LINE__);
    /* what is wrong with a fixed block's mass does not matter */
    stack_of_two(&w, 0.25);
    w.block[0].mass = R(-5);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_STANDS);
}

static void bad_pointers(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    kern_real out;
    stack_of_two(&w, 0.25);
    work = work_of(&w);
    s = structure_of(&w);
    s.block = NULL;
    all_say(&s, &w.options, &work, KERN_BAD_POINTER, -2, -2, __LINE__);
    s = structure_of(&w);
    s.contact = NULL;
    all_say(&s, &w.options, &work, KERN_BAD_POINTER, -2, -2, __LINE__);
    s = structure_of(&w);
    all_say(NULL, &w.options, &work, KERN_BAD_POINTER, -2, -2, __LINE__);
    all_say(&s, NULL, &work, KERN_BAD_POINTER, -2, -2, __LINE__);
    all_say(&s, &w.options, NULL, KERN_BAD_POINTER, -2, -2, __LINE__);
    CHECK_INT(kern_measure(task_of(&s, &w.options, &work), NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_deficit(task_of(&s, &w.options, &work), NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_load_factor(task_of(&s, &w.options, &work), 0, KERN_RIGHT,
                               NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(
        kern_tilt(task_of(&s, &w.options, &work), 0, KERN_RIGHT, NULL, NULL),
        KERN_BAD_POINTER);
    CHECK_INT(kern_load_factor(task_of(&s, &w.options, &work), 0, KERN_SHRINK,
                               &out, NULL),
              KERN_BAD_OPTION);
    CHECK_INT(kern_tilt(task_of(&s, &w.options, &work), 0, 2, &out, NULL),
              KERN_BAD_OPTION);
    /* a proof that cannot be read is none */
    CHECK(kern_check_forces(task_of(&s, &w.options, &work), 0, NULL) > 1);
    CHECK(kern_check_motion(task_of(&s, &w.options, &work), 0, NULL) > 1);
}

/* Shrinkages and load patterns that are no numbers, patterns that are too large. */
static void bad_arguments(void)
{
    static world w;
    kern_work work;
    kern_real out;
    int i, j;
    stack_of_two(&w, 0.25);
    work = work_of(&w);
    for (j = 0; j < NO_NUMBERS; j++) {
        const kern_real bad = R(no_number(j));
        CHECK_INT(kern_verdict(world_task(&w, &work), bad, NULL),
                  KERN_BAD_NUMBER);
        CHECK_INT(kern_tilt(world_task(&w, &work), bad, KERN_RIGHT, &out, NULL),
                  KERN_BAD_NUMBER);
        CHECK_INT(kern_load_factor(world_task(&w, &work), bad, KERN_RIGHT, &out,
                                   NULL),
                  KERN_BAD_NUMBER);
        for (i = 0; i < 6; i++) {
            kern_wrench pattern[3];
            memset(pattern, 0, sizeof pattern);
            *(i % 3 == 0 ? &pattern[1].fx
              : i % 3 == 1
                  ? &pattern[1].fy
                  : &pattern[1].torque) = i < 3 ? bad : R(SINGLE ? 1e11 : 1e61);
            CHECK_INT(kern_load_factor_of(world_task(&w, &work), 0, pattern,
                                          &out, NULL),
                      KERN_BAD_NUMBER);
            CHECK_INT(work.fault.block, 1);
        }
    }
}

/* The same for kern_contacts(): w.options are those it is given. */
static const spoilt bad_geometries[] = {
    REAL(options.mu, -1, KERN_BAD_FRICTION, -2, -2),
    REAL(options.gap, -1, KERN_BAD_OPTION, -2, -2),
    REAL(options.angle, -1, KERN_BAD_OPTION, -2, -2),
    REAL(options.angle, 0.5, KERN_BAD_OPTION, -2, -2),
    WHOLE(block[2].vertices, 2, KERN_FEW_VERTICES, 2, -2),
};

static const spoilt numbers_of_a_geometry[] = {
    NUMBER(block[1].box.low.x, 1, -1),  NUMBER(block[1].box.low.y, 1, -1),
    NUMBER(block[1].box.high.x, 1, -1), NUMBER(block[1].box.high.y, 1, -1),
    NUMBER(block[1].area, 1, -1),       NUMBER(options.mu, -2, -2),
    NUMBER(options.gap, -2, -2),        NUMBER(options.angle, -2, -2),
};

/* What kern_contacts() says of a world; the fault goes to *fault. */
static int contacts_say(const world *w, kern_fault *fault)
{
    static kern_contact out[64];
    int index[6], got;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    memset(&work.fault, 0x55, sizeof work.fault);
    got = kern_contacts(w->block, w->blocks, &w->options, out, 64, &work);
    *fault = work.fault;
    return got;
}

static void contacts_say_of_row(const world *good, const spoilt *row,
                                double value)
{
    static world w;
    kern_fault fault;
    world_copy(&w, good);
    spoil(&w, row, value);
    check_near(contacts_say(&w, &fault), row->want, 0, row->line,
               "status of bad geometry");
    if (row->block > -2)
        check_near(fault.block, row->block, 0, row->line, "fault.block");
    if (row->index > -2)
        check_near(fault.index, row->index, 0, row->line, "fault.index");
}

static void bad_geometry(void)
{
    static world w;
    kern_fault fault;
    stack_of_two(&w, 0.25);
    CHECK_INT(contacts_say(&w, &fault), 4);
    spoil_each(&w, bad_geometries, COUNT_OF(bad_geometries),
               numbers_of_a_geometry, COUNT_OF(numbers_of_a_geometry),
               contacts_say_of_row);
    w.options.angle = R(0.49);
    CHECK(contacts_say(&w, &fault) >= 0);
    w.options = kern_defaults();
    w.block[2].vertices = -2;
    CHECK_INT(contacts_say(&w, &fault), KERN_NO_BLOCK);
    CHECK_INT(fault.block, 2);
    w.block[2].vertices = 4;
    w.block[2].vertex = NULL;
    CHECK_INT(contacts_say(&w, &fault), KERN_BAD_POINTER);
    CHECK_INT(fault.block, 2);
    /* a block without a polygon touches nothing */
    w.block[2].vertices = 0;
    CHECK_INT(contacts_say(&w, &fault), 2);
}

/* An init that fails in way k. */
static kern_status refused(kern_block *b, int k)
{
    static const kern_vec square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const kern_vec bow[] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    static kern_vec hole[4];
    memcpy(hole, square, sizeof hole);
    hole[2].x = R(not_a_number());
    switch (k) {
    case 0: return kern_block_init(b, hole, 4, 1, NULL);
    case 1: return kern_block_init(b, bow, 4, 1, NULL);
    case 2: return kern_block_init(b, square, 2, 1, NULL);
    case 3: return kern_block_init(b, square, -1, 1, NULL);
    case 4: return kern_block_init(b, square, 4, 0, NULL);
    case 5: return kern_block_init(b, NULL, 4, 1, NULL);
    case 6: return kern_ground_init(b, hole, 4, NULL);
    default: return kern_ground_init(b, NULL, 0, NULL);
    }
}

/* What plans say of a block that was refused. */
static void plans_refuse(const world *w, const kern_block *b)
{
    static site p;
    kern_margin m;
    kern_raising raising;
    site_open(&p, w);
    site_add(&p, 0);
    CHECK_INT(kern_plan_add(&p.plan, b), KERN_NO_BLOCK);
    CHECK_INT(p.work.fault.block, 1);
    CHECK_INT(kern_plan_try(&p.plan, b, &m, NULL), KERN_NO_BLOCK);
    CHECK_INT(kern_plan_bears(&p.plan, b, 0, NULL), KERN_NO_BLOCK);
    CHECK_INT(kern_plan_raised(&p.plan, b, &raising, NULL, NULL),
              KERN_NO_BLOCK);
    CHECK_INT(p.plan.task.s.blocks, 1);
}

/* A block whose init failed was that of the call before, and its answer was
   given again. Now every call refuses it, whatever is set in it by hand, until
   an init succeeds. */
static void refused_blocks(void)
{
    static world w;
    static kern_overlap overlap[4];
    kern_proof proof = proof_here();
    kern_margin m;
    kern_interval in;
    kern_critical critical = {NULL, NULL, NULL, 0, 0};
    kern_raising raising;
    kern_real value = 0;
    int k;
    for (k = 0; k < 8; k++) {
        kern_contact out[8];
        kern_block good, *b = &w.block[1];
        kern_contact_rate rate[8];
        kern_block_rate of[3];
        kern_structure s;
        kern_work work;
        kern_task *task;
        stack_of_two(&w, 0.25);
        good = *b;
        work = work_of(&w);
        s = structure_of(&w);
        CHECK_INT(kern_measure(task_of(&s, &w.options, &work), &m, &proof),
                  KERN_STANDS);
        CHECK(refused(b, k) < 0);
        CHECK_INT(b->vertices, -1);
        CHECK_NEAR(kern_mean_size(b, 1), 0, 0);
        b->mass = good.mass;
        b->centre = good.centre;
        b->area = good.area;
        b->box = good.box;
        all_say(&s, &w.options, &work, KERN_NO_BLOCK, 1, -2, __LINE__);
        task = task_of(&s, &w.options, &work);
        CHECK_INT(kern_raised(task, 0, &raising, NULL, NULL), KERN_NO_BLOCK);
        CHECK_INT(kern_forces(task, 0, force_of), KERN_NO_BLOCK);
        CHECK_INT(kern_bearing(task, &value, NULL), KERN_NO_BLOCK);
        CHECK_INT(kern_critical_of(task, 0, &proof, &critical), KERN_NO_BLOCK);
        CHECK_INT(kern_sensitivity(task, &m, &proof, rate, of), KERN_NO_BLOCK);
        CHECK(isinf(kern_check_forces(task, 0, force_of)));
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work),
                  KERN_NO_BLOCK);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work),
                  KERN_NO_BLOCK);
        CHECK_INT(kern_overlaps(w.block, 3, &w.options, overlap, 4, &work),
                  KERN_NO_BLOCK);
        task->options = kern_measured_options(&w.options, R(0.001), R(0.001));
        CHECK_INT(kern_certain(task, 0, &in, out, 8), KERN_NO_BLOCK);
        plans_refuse(&w, b);
        CHECK_INT(kern_block_init(b, good.vertex, good.vertices, 1, NULL),
                  KERN_OK);
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), 4);
    }
}

static void bad_contact_pointers(void)
{
    static world w;
    static kern_contact out[64];
    int index[6], got;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    const kern_options o = kern_defaults();
    stack_of_two(&w, 0.25);
    CHECK_INT(kern_contacts(NULL, 3, &o, out, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, 3, NULL, out, 64, &work),
              KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, 3, &o, NULL, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, -1, &o, out, 64, &work), KERN_BAD_COUNT);
    got = kern_contacts(w.block, 3, &o, out, -1, &work);
    CHECK(got == KERN_BAD_COUNT || got == KERN_NO_SPACE);
    CHECK_INT(kern_touch(NULL, 1, &o, out, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_touch(w.block, -1, &o, out, 64, &work), KERN_BAD_COUNT);
    CHECK_INT(kern_touch(w.block, 2147483647, &o, out, 64, &work),
              KERN_BAD_COUNT);
}

/* ---- statuses ------------------------------------------------- >>statuses */

static const struct {
    int value;
    const char *name;
} statuses[] = {
#define STATUS_ROW(name, value, text) {value, #name},
    KERN_STATUS_LIST(STATUS_ROW)
#undef STATUS_ROW
};

/* The statuses that calls of the tests below returned. */
static int had[64], had_count;

static int have(int status)
{
    had[had_count++] = status;
    return status;
}

/* A limit of work, and friction of which no number is left in the proofs. */
static void statuses_without_verdict(void)
{
    static world w;
    kern_work work;
    brick_wall(&w, wall4, 0.4, 1);
    work = work_of(&w);
    w.options.limit = 1;
    have(kern_verdict(world_task(&w, &work), 0, NULL));
    w.options.limit = 0;
    world_friction(&w, 1e9);
    have(kern_verdict(world_task(&w, &work), R(0.12), NULL));
}

static void statuses_of_measures(void)
{
    static const double ray[] = {1, -1, 1}, down[] = {-1, -1},
                        minus[] = {-1, 1};
    static world w;
    kern_margin m;
    kern_structure s;
    kern_work work;
    program p;
    stack_of_two(&w, 0.25);
    have(verdict(&w, 0));
    w.gravity = vec(9, 0);
    have(verdict(&w, 0));
    program_set(&p, 1, 2, ray, down);
    have(program_solve(&p));
    program_set(&p, 1, 2, ray, NULL);
    have(program_solve(&p));
    program_set(&p, 1, 1, minus, NULL);
    have(program_solve(&p));
    work = work_of(&w);
    s = structure_of(&w);
    work.reals = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    have(kern_verdict(task_of(NULL, &w.options, &work), 0, NULL));
    work = work_of(&w);
    have(kern_verdict(task_of(&s, &w.options, &work), R(not_a_number()), NULL));
    s.gravity = vec(0, 0);
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.contacts = KERN_STALE;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.blocks = -1;
    s.contacts = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.blocks = 1;
    s.contacts = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s = structure_of(&w);
    w.options.epsilon = R(1e-12);
    w.gravity = vec(0, -9.81);
    s = structure_of(&w);
    have(kern_measure(task_of(&s, &w.options, &work), &m, NULL));
    w.options.epsilon = R(-1);
    have(kern_measure(task_of(&s, &w.options, &work), &m, NULL));
    w.options = kern_defaults();
    w.options.relative = 1;
    have(kern_verdict(task_of(&s, &w.options, &work), R(1.5), NULL));
}

static void statuses_of_geometry(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1};
    static const double flat[] = {0, 0, 1, 0, 2, 0, 1, 0};
    static const struct {
        int a, ny, py; /* block a and block 1, normal and second point */
        double mu;
    } given_contact[] = {
        {0, 1, 0, -1}, {1, 1, 0, 1}, {-1, 1, 0, 1}, {0, 0, 0, 1}, {0, 1, 1, 1}};
    static world w;
    const kern_options o = kern_defaults();
    kern_block b;
    kern_fault fault;
    kern_contact c[2];
    int i;
    have(polygon(&b, &fault, 1, square, 4));
    have(polygon(&b, &fault, 1, square, 2));
    have(polygon(&b, &fault, 1, bow, 4));
    have(polygon(&b, &fault, 1, flat, 3));
    have(polygon(&b, &fault, -1, square, 4));
    for (i = 0; i < 5; i++)
        have(contact_make(given_contact[i].a, 1, vec(0, given_contact[i].ny),
                          vec(0, 0), vec(0, given_contact[i].py),
                          R(given_contact[i].mu), &o, c));
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0.5, 0.5, 2, 2);
    have(world_touch(&w));
    refused(&w.block[0], 0);
    have(world_touch(&w));
}

/* A wheel beside a slope, and on it. */
static void statuses_of_rest(void)
{
    const kern_vec slope[3] = {vec(0, 0), vec(90, 0), vec(90, 30)};
    enum { CORNERS = 40 };
    kern_vec wheel[CORNERS], out[CORNERS];
    kern_block stone, ground;
    kern_pose pose;
    kern_work work = work_for(1, 4);
    kern_task task = kern_task_of(&ground, 1, NULL, 0, &work);
    int i;
    for (i = 0; i < CORNERS; i++)
        wheel[i] = vec(cos(6.283185307179586 * i / CORNERS),
                       sin(6.283185307179586 * i / CORNERS));
    kern_block_init(&stone, wheel, CORNERS, 1, NULL);
    kern_ground_init(&ground, slope, 3, NULL);
    have(kern_rest(&task, &stone, -9, 0, out, &pose));
    have(kern_rest(&task, &stone, 80, 0, out, &pose));
}

/* Every status has a text of its own and can be had. */
static void status_of_every_kind(void)
{
    enum { ROWS = COUNT_OF(statuses) };
    int i, j;
    had_count = 0;
    statuses_of_measures();
    statuses_without_verdict();
    statuses_of_geometry();
    statuses_of_rest();
    for (i = 0; i < ROWS; i++) {
        const char *text = kern_status_text((kern_status)statuses[i].value);
        int count = 0;
        CHECK(text && text[0]);
        for (j = 0; j < i; j++)
            CHECK(strcmp(text, kern_status_text((kern_status)statuses[j].value))
                  != 0);
        for (j = 0; j < had_count; j++)
            count += had[j] == statuses[i].value;
        if (!count)
            printf("no test gives %s\n", statuses[i].name);
        CHECK(count > 0);
        CHECK(statuses[i].value >= KERN_STATUS_LEAST);
    }
    CHECK(kern_status_text((kern_status)-99) != NULL);
    CHECK(kern_status_text((kern_status)99) != NULL);
}

/* ---- memory ----------------------------------------------------- >>memory */

static const int constant_reals[KERN_REALS(3, 4) > 0 ? 1 : -1] = {
    KERN_REALS(3, 4)};
static const int constant_ints[KERN_INTS(3, 4) > 0 ? 1 : -1] = {
    KERN_INTS(3, 4)};

static void memory_need(void)
{
    int b, c, reals, ints;
    for (b = 0; b < 60; b++)
        for (c = 0; c < 200; c += 1 + c / 7) {
            kern_work_need(b, c, &reals, &ints);
            CHECK_INT(reals, KERN_REALS(b, c));
            CHECK_INT(ints, KERN_INTS(b, c));
        }
    CHECK_INT(constant_reals[0], KERN_REALS(3, 4));
    CHECK_INT(constant_ints[0], KERN_INTS(3, 4));
    /* arguments of the macro are not torn apart */
    CHECK_INT(KERN_REALS(1 + 2, 2 + 2), KERN_REALS(3, 4));
    CHECK_INT(KERN_INTS(1 + 2, 2 + 2), KERN_INTS(3, 4));
}

enum { ENTRIES = 6 };

/* Every entry that takes a structure, with nothing said of the answer. */
static int call_entry(int entry, const world *w, kern_work *work)
{
    const kern_structure s = structure_of(w);
    const kern_options *o = &w->options;
    kern_real value[MAX_BLOCKS], out;
    kern_collapse all;
    kern_margin m;
    switch (entry) {
    case 0: return kern_verdict(task_of(&s, o, work), 0, NULL);
    case 1: return kern_measure(task_of(&s, o, work), &m, NULL);
    case 2: return kern_deficit(task_of(&s, o, work), &out);
    case 3:
        return kern_load_factor(task_of(&s, o, work), 0, KERN_RIGHT, &out,
                                NULL);
    case 4: return kern_tilt(task_of(&s, o, work), 0, KERN_RIGHT, &out, NULL);
    default:
        return kern_profile(task_of(&s, o, work), KERN_SHRINK, value, &all);
    }
}

/* Sizes below zero, and arrays that are not there. */
static void no_work(const world *w, kern_real *real, int reals, int *index,
                    int ints)
{
    kern_work work = kern_work_of(real, -1, index, ints);
    int got;
    CHECK_INT(call_entry(0, w, &work), KERN_NO_SPACE);
    work = kern_work_of(real, reals, index, -5);
    CHECK_INT(call_entry(0, w, &work), KERN_NO_SPACE);
    work = kern_work_of(NULL, reals, index, ints);
    got = call_entry(0, w, &work);
    CHECK(got == KERN_BAD_POINTER || got == KERN_NO_SPACE);
    work = kern_work_of(real, reals, NULL, ints);
    got = call_entry(0, w, &work);
    CHECK(got == KERN_BAD_POINTER || got == KERN_NO_SPACE);
}

/* Every size of one array with the other whole: enough gives the right answer,
   less says so, and what lies behind the array is never touched. */
static void every_size(const world *w, int stride)
{
    int reals, ints, array, size, entry, want[ENTRIES];
    kern_real *real;
    int *index;
    kern_work work = work_of(w);
    for (entry = 0; entry < ENTRIES; entry++)
        want[entry] = call_entry(entry, w, &work);
    kern_work_need(w->blocks, w->contacts, &reals, &ints);
    real = (kern_real *)malloc(sizeof *real * (size_t)(reals + GUARD));
    index = (int *)malloc(sizeof *index * (size_t)(ints + GUARD));
    for (array = 0; array < 2; array++) {
        const int need = array ? ints : reals;
        for (size = 0; size <= need;
             size += size + stride > need && size < need ? need - size : stride)
            for (entry = 0; entry < ENTRIES; entry++) {
                int got;
                guard_fill(real, reals, index, ints);
                work = kern_work_of(real, array ? reals : size, index,
                                    array ? size : ints);
                got = call_entry(entry, w, &work);
                CHECK(guard_holds(&work, reals, ints));
                if (got != KERN_NO_SPACE)
                    CHECK_INT(got, want[entry]);
                if (size == 0)
                    CHECK_INT(got, KERN_NO_SPACE);
                if (size == need)
                    CHECK_INT(got, want[entry]);
            }
    }
    no_work(w, real, reals, index, ints);
    free(real);
    free(index);
}

static void memory_every_size(void)
{
    static world w;
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    every_size(&w, 1); /* no contacts */
    stack_of_two(&w, 0.25);
    every_size(&w, 1);
    given.n = 12;
    given.a = 1;
    given.mu = 0.6;
    semicircle(&w, 0.2);
    every_size(&w, 37);
}

static int lean(const world *w, kern_margin *m)
{
    kern_work work = work_of(w);
    work.reals = KERN_LEAN_REALS(w->blocks, w->contacts);
    work.indices = KERN_LEAN_INTS(w->blocks, w->contacts);
    return kern_measure(world_task(w, &work), m, NULL);
}

/* Lean memory gives the same answer, or none: it is too little for arches, and
   where many blocks move at the margin. */
static void memory_lean(void)
{
    static world w;
    kern_margin m, whole;
    int seed, refused = 0, none = 0;
    for (seed = 0; seed < 600; seed++) {
        int got;
        random_world(&w, 700000u + (unsigned long long)seed, 40);
        got = lean(&w, &m);
        refused += got < 0;
        if (got < 0) {
            CHECK(got == KERN_NO_SPACE || got == KERN_UNDECIDED);
            continue;
        }
        CHECK_INT(got, measure(&w, &whole));
        if (!SINGLE)
            CHECK_INT(m.level, whole.level);
        CHECK_NEAR(m.margin, whole.margin, law_tolerance(&w));
    }
    CHECK(refused < 180);
    context[0] = 0;
    given.n = 60;
    given.a = 1;
    given.mu = 3; /* holds it almost until every kern is a point */
    for (seed = 2; seed < 14; seed++) {
        int got;
        semicircle(&w, 0.1 * seed);
        got = lean(&w, &m);
        none += got == KERN_NO_SPACE;
        CHECK_INT(measure(&w, &whole), KERN_STANDS);
        if (got == KERN_STANDS)
            CHECK_NEAR(m.margin, whole.margin, law_tolerance(&w));
        else
            CHECK(got == KERN_NO_SPACE || got == KERN_UNDECIDED);
    }
#ifndef KERN_USE_GLPK /* which has its own memory */
    CHECK(none > 0);
#endif
}

/* Nothing is kept in the work arrays: garbage in them changes no bit. */
static void memory_garbage(void)
{
    static world w;
    int seed, fill;
    for (seed = 0; seed < 200; seed++) {
        kern_margin m[3];
        kern_real f[3];
        int units[3];
        random_world(&w, 300000u + (unsigned long long)seed, 15);
        for (fill = 0; fill < 3; fill++) {
            kern_work work = work_of(&w);
            const int byte = fill == 0 ? 0 : fill == 1 ? 0xff : 0x3f;
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            memset(&m[fill], 0, sizeof m[fill]);
            f[fill] = 0;
            CHECK(decided(kern_measure(world_task(&w, &work), &m[fill], NULL)));
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            CHECK(decided(kern_load_factor(world_task(&w, &work), 0, KERN_RIGHT,
                                           &f[fill], NULL)));
            CHECK(work.pivots >= 0 && work.solves > 0);
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            CHECK(decided(kern_verdict(world_task(&w, &work), R(-1), NULL)));
            units[fill] = work.units;
            if (fill > 0) {
                CHECK_INT(units[fill], units[0]);
                CHECK_NEAR(m[fill].margin, m[0].margin, 0);
                CHECK_NEAR(m[fill].holds, m[0].holds, 0);
                CHECK_NEAR(m[fill].fails, m[0].fails, 0);
                CHECK_INT(m[fill].level, m[0].level);
                CHECK_NEAR(f[fill], f[0], 0);
            }
        }
    }
    context[0] = 0;
}

/* ==== The profile =============================================== >>profile */

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
        CHECK_NEAR(in.low, fmax(fmin(end / 2, end - 0.5) - 0.035, 0), 1e-3);
        CHECK_NEAR(in.high, fmax(fmin(end / 2, end - 0.5) + 0.035, 0), 0.01);
        CHECK_INT(certain_world(&w, &in, 1), KERN_NO_SPACE);
        w.options.pose_error = 0;
        CHECK_INT(certain_world(&w, &in, 100), KERN_BAD_OPTION);
    }
    CHECK_INT(kern_certain(NULL, 0, &in, &one, 1), KERN_BAD_POINTER);
    CHECK_INT(kern_certain(world_task(&w, &work), 0, &in, &one, 1),
              KERN_BAD_POINTER);
}

/* Supports that may be short within the error: nothing below, a beam, a plank;
   and one bed, which no error of place takes away. The interval holds the margin
   and widens as the error grows. */
enum { SLOT, BEAM, PLANK, STACK, SUPPORTS };

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
    kern_interval in, last = {0, 0};
    int kind, step;
    for (kind = 0; kind < SUPPORTS; kind++)
        for (step = 1; step <= 4; step++) {
            const double e = 0.002 * step;
            support_of(&w, kind);
            w.options = kern_measured_options(NULL, R(e), R(e));
            CHECK(world_touch(&w) > 0);
            CHECK_INT(verdict(&w, 0), KERN_STANDS);
            CHECK_INT(certain_world(&w, &in, 100),
                      kind == STACK ? KERN_STANDS : KERN_OK);
            CHECK(in.low >= 0 && in.high >= in.low);
            CHECK((in.low > 0) == (kind == STACK));
            CHECK(step == 1 || (in.low <= last.low && in.high >= last.high));
            last = in;
        }
}

/* A box on a bed of slope 0.3 whose contacts have a friction of their own. Found
   anew they have that of the options, with which it slides for certain: so its
   interval is 0, whatever the given ones bear. */
static void certain_given(void)
{
    static world w;
    kern_interval in = {-1, -1};
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
    CHECK_INT(certain_world(&w, &in, 100), KERN_FALLS);
    CHECK_NEAR(in.low, 0, 0);
    CHECK_NEAR(in.high, 0, 0);
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

/* The corner of a stone, two errors beyond the end of ground that has a step: its
   foot is on the chord of the ground, y = -0.002 x, whose normal it takes. The
   corner is the end of its own chords, which have no normal there. So is the
   corner of the ground, with its foot on the side of the stone, x + y = 0.02. */
static void measured_corner_beyond_steps(void)
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
        w.options = kern_measured_options(&w.options, R(0.01), R(0));
        CHECK_INT(world_touch(&w), 2);
        CHECK(contact_at(&w, 0, 1, 0.02 / square, -0.00004 / square,
                         up * 0.002 / length, up / length, GEO));
        CHECK(contact_at(&w, 0, 1, 0.01, 0.01, up * sqrt(0.5), up * sqrt(0.5),
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

/* ==== Raised ==================================================== >>raised */

/* The verdict of kern_raised(), or a status; its proof is checked, and that
   nothing else passes for it. */
static int raised(const world *w, kern_real *reserve)
{
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    kern_proof proof = proof_here();
    kern_raising got = KERN_NOT_SHOWN;
    kern_real error;
    const int status = kern_raised(task, 0, &got, reserve, &proof);
    int i;
    if (status != KERN_STANDS)
        return -10 - status;
    error = kern_check_raised(task, 0, got, &proof);
    CHECK((error <= 1) == (got != KERN_NOT_SHOWN));
    CHECK(kern_check_forces(task, 0, proof.force) <= 1 || got == KERN_HANGS);
    if (got == KERN_NOT_SHOWN)
        return got;
    CHECK(!(kern_check_raised(
                task, 0, got == KERN_RAISED ? KERN_HANGS : KERN_RAISED, &proof)
            <= 1));
    for (i = 0; i < w->blocks && got == KERN_RAISED; i++) {
        motion_of[i].vx *= -1;
        motion_of[i].vy *= -1;
        motion_of[i].spin *= -1;
    }
    for (i = 0; i < w->blocks && got == KERN_HANGS; i++)
        motion_of[i].vy = -1;
    CHECK(!(kern_check_raised(task, 0, got, &proof) <= 1));
    return got;
}

/* A block of height 1 and width 1 at its foot between two walls that lean out
   by these angles, in degrees. */
static void between_walls(world *w, double left, double right, double mu)
{
    const double l = tan(left * pi / 180), r = tan(right * pi / 180);
    const double block[] = {0, 0, 1, 0, 1 + r, 1, -l, 1};
    const double west[] = {-5, 0, 0, 0, -l, 1, -5, 1};
    const double east[] = {1, 0, 6, 0, 6, 1, 1 + r, 1};
    world_reset(w);
    w->options.mu = R(mu);
    world_polygon(w, 1, block, 4);
    world_polygon(w, 0, west, 4);
    world_polygon(w, 0, east, 4);
    world_touch(w);
}

static void jack_arch(world *w)
{
    const double west[] = {-6, 0, -1.5, 0, -2, 1, -6, 1};
    const double east[] = {1.5, 0, 6, 0, 6, 1, 2, 1};
    int i;
    world_reset(w);
    w->options.mu = R(0.5);
    for (i = 0; i < 5; i++) {
        const double a = 0.2 * i - 0.5, b = a + 0.2;
        const double xy[] = {3 * a, 0, 3 * b, 0, 4 * b, 1, 4 * a, 1};
        world_polygon(w, 1, xy, 4);
    }
    world_polygon(w, 0, west, 4);
    world_polygon(w, 0, east, 4);
    world_touch(w);
}

static void corbel(world *w)
{
    int i;
    world_reset(w);
    world_box(w, 0, -3, -1, 0, 0);
    for (i = 0; i < 4; i++)
        world_box(w, 1, 0.25 * i - 1.25, 0.4 * i, 0.25 * (i + 1),
                  0.4 * (i + 1));
    world_box(w, 1, -0.5, 1.6, 0.5, 2.6);
    world_touch(w);
}

static void leaning_plank(world *w)
{
    const double c = cos(70 * pi / 180), s = sin(70 * pi / 180);
    const double x = 2 * c, thick = 0.05;
    const double xy[] = {
        x, 0, x + thick * s, thick * c, thick * s, thick * c + 2 * s, 0, 2 * s};
    world_reset(w);
    w->options.mu = R(0.5);
    world_box(w, 0, -1, -1, 4, 0);
    world_box(w, 0, -1, 0, 0, 4);
    world_polygon(w, 1, xy, 4);
    world_touch(w);
}

static void stone_between_leaning(world *w)
{
    const double t = tan(10 * pi / 180), y = 0.4, z = 0.7;
    const double west[] = {-2, 0, -1, 0, -1 + t, 1, -2 + t, 1};
    const double east[] = {1, 0, 2, 0, 2 - t, 1, 1 - t, 1};
    const double stone[] = {-1 + t * y, y, 1 - t * y,  y,
                            1 - t * z,  z, -1 + t * z, z};
    world_reset(w);
    w->options.mu = R(0.6);
    world_box(w, 0, -4, -1, 4, 0);
    world_polygon(w, 1, west, 4);
    world_polygon(w, 1, east, 4);
    world_polygon(w, 1, stone, 4);
    world_touch(w);
}

static void raised_by_hand(void)
{
    static const struct {
        double left, right, mu;
        int want;
    } walls[] = {{0, 0, 0.4, KERN_HANGS},    {5, 5, 0.4, KERN_RAISED},
                 {-5, -5, 0.4, KERN_HANGS},  {10, 10, 0.4, KERN_RAISED},
                 {30, 30, 0.4, KERN_RAISED}, {30, 30, 0.8, KERN_RAISED},
                 {60, 60, 0.2, KERN_RAISED}, {0, 20, 0.4, KERN_RAISED},
                 {-10, 20, 0.4, KERN_RAISED}};
    static world w;
    kern_real reserve;
    size_t i;
    for (i = 0; i < sizeof walls / sizeof *walls; i++) {
        sprintf(context, "walls %g %g", walls[i].left, walls[i].right);
        between_walls(&w, walls[i].left, walls[i].right, walls[i].mu);
        CHECK_INT(raised(&w, NULL), walls[i].want);
    }
    context[0] = 0;
    between_walls(&w, 0, 0, 0.4);
    world_box(&w, 0, -1, -1, 2, 0);
    world_touch(&w);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT); /* the walls hold it */
    world_reset(&w);
    world_box(&w, 0, -1, 0, 0, 1);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 1, 0, 2, 1);
    world_box(&w, 0, 2, 0, 3, 1);
    world_touch(&w);
    CHECK_INT(raised(&w, &reserve), KERN_HANGS);
    CHECK_NEAR(reserve, 0, 0);
    jack_arch(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    corbel(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    leaning_plank(&w);
    CHECK_INT(raised(&w, NULL), KERN_RAISED);
    stone_between_leaning(&w);
    CHECK_INT(raised(&w, NULL), KERN_HANGS);
}

/* A cube on a slope of .1 slides down with a push of more than about .3 g, one
   on a slope of .395 with one of .0043 g: (.395 + x) / (1 - .395 x) = .4. */
static void raised_reserve(void)
{
    static world w;
    kern_real reserve;
    one_cube(&w);
    w.gravity = vec(9.81 * 0.1, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT);
    w.gravity = vec(9.81 * 0.395, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.004, EXACT);
    w.options.reserve = R(0.0055); /* no more is asked for */
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.004, EXACT);
    w.gravity = vec(9.81 * 0.1, -9.81);
    CHECK_INT(raised(&w, &reserve), KERN_RAISED);
    CHECK_NEAR(reserve, 0.0055, EXACT);
    w.options.reserve = R(0.2);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_BAD_OPTION);
    w.options.reserve = R(0);
    w.gravity = vec(9.81 * 0.405, -9.81);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_FALLS);
    w.gravity = vec(0, 0);
    CHECK_INT(raised(&w, &reserve), -10 - KERN_NO_LOAD);
    CHECK_INT(raised(&w, NULL), -10 - KERN_NO_LOAD);
}

/* Whatever stands is shown to be raised or not, with proofs that hold; the
   reserve is no more than the load factor. */
static void raised_random(void)
{
    static world w;
    int seed, stood = 0, shown = 0;
    for (seed = 1; seed <= 400; seed++) {
        kern_real reserve = R(-1);
        int got, side;
        if (!random_world(&w, (unsigned long long)seed, 12))
            continue;
        sprintf(context, "seed %d", seed);
        got = raised(&w, &reserve);
        if (got < 0) {
            CHECK(decided(-10 - got) && verdict(&w, 0) != KERN_STANDS);
            continue;
        }
        stood++;
        shown += got == KERN_RAISED;
        for (side = -1; side <= 1 && got == KERN_RAISED; side += 2) {
            double factor = 0;
            if (load_factor(&w, NULL, side, &factor) == KERN_STANDS)
                CHECK(reserve <= R(factor) + EDGE);
        }
    }
    context[0] = 0;
    CHECK(stood > 100 && shown > stood / 2);
}

/* kern_stays() of a block, or -10 less what it returns. Of the last block a
   plan says the same that does not have it yet, and that has it. */
static double stays(const world *w, int i)
{
    static site p;
    kern_work work = work_of(w);
    kern_real got = R(-1), with = R(-1), has = R(-1);
    const kern_status status = kern_stays(world_task(w, &work), i, &got);
    CHECK((got >= 0 && got <= 1) == (status == KERN_STANDS));
    CHECK(got >= 0 || got <= -1);
    if (i == w->blocks - 1 && !w->given) {
        site_with(&p, w, i);
        CHECK_INT(kern_plan_stays(&p.plan, &w->block[i], &with), status);
        CHECK_INT(p.plan.task.s.blocks, i);
        site_add(&p, i);
        CHECK_INT(kern_plan_stays(&p.plan, NULL, &has), status);
        CHECK(memcmp(&with, &has, sizeof has) == 0);
        CHECK_NEAR(with, got, EXACT);
    }
    return status == KERN_STANDS ? (double)got : -10 - status;
}

/* n cubes have a reserve of .1 and more; the bed of each has two points, of the
   stiffness .1 + .5, so that the top one sinks by (1 + ... + n) / 1.2. What is
   more than four contacts away is held: it neither sinks nor weighs. */
static void stays_law(void)
{
    static world w;
    double last = 1, shift;
    int n, k;
    for (n = 1; n <= 8; n++)
        for (k = 1; k <= n; k++) {
            const int top = k + 4 < n ? k + 4 : n;
            double down = 0, q, chance;
            int i;
            for (i = k > 4 ? k - 4 : 1; i <= k; i++) /* what bed i carries */
                down += (top - i + 1) / 1.2;
            q = 5.5e7 * 0.014 * 0.014 * 0.014 / (down < 1 ? 1 : down);
            chance = 0.05 + 0.95 * q * q / (1 + q * q);
            world_reset(&w);
            world_box(&w, 0, -5, -1, 5, 0);
            for (i = 0; i < n; i++)
                world_box(&w, 1, 0, i, 1, i + 1);
            world_touch(&w);
            CHECK_NEAR(stays(&w, k), chance, 100 * PROOF_TOL);
        }
    for (shift = 0; shift < 0.499; shift += 0.02) { /* nearer to its edge */
        shifted_cube(&w, shift);
        CHECK(stays(&w, 1) <= last);
        last = stays(&w, 1);
    }
    shifted_cube(&w, 0.4999);
    CHECK(stays(&w, 1) < 0.5 && last > 0.98);
    shifted_cube(&w, 0.51);
    CHECK_INT((int)stays(&w, 1), -10 - KERN_FALLS);
    CHECK_INT((int)stays(&w, 0), -10 - KERN_BAD_BLOCK);
    CHECK_INT((int)stays(&w, 2), -10 - KERN_BAD_BLOCK);
    CHECK_INT((int)stays(&w, -1), -10 - KERN_BAD_BLOCK);
    w.gravity = vec(0, 0);
    kern_block_load(&w.block[1], vec(0, -1), w.block[1].centre, 0);
    CHECK_INT((int)stays(&w, 1), -10 - KERN_BAD_OPTION);
    between_walls(&w, 0, 0, 0.5); /* between walls that nothing presses */
    CHECK_NEAR(stays(&w, 0), 0, EXACT);
}

/* The chance is that of the mirrored structure, and of other units. */
static void stays_random(void)
{
    static world w, other;
    static int order[MAX_BLOCKS];
    change c = no_change();
    int seed, stood = 0;
    c.mirror = 1;
    c.scale = c.mass = 8;
    for (seed = 1; seed <= 100; seed++) {
        double got;
        if (!random_world(&w, (unsigned long long)seed, 12))
            continue;
        sprintf(context, "seed %d", seed);
        got = stays(&w, w.blocks - 1);
        if (got < 0)
            continue;
        stood++;
        world_changed(&other, &w, &c, order);
        CHECK_NEAR(stays(&other, w.blocks - 1), got, EXACT);
    }
    context[0] = 0;
    CHECK(stood > 25);
}

static void stays_memory(void)
{
    static world w;
    kern_work work;
    kern_real got = -1;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        status = kern_stays(world_task(&w, &work), 4, &got);
        CHECK(status == KERN_NO_SPACE || status == KERN_STANDS);
        enough |= status == KERN_STANDS;
        CHECK((got >= 0) == enough);
    }
    CHECK(enough);
    got = -1;
    w.options.limit = 3;
    CHECK_INT(kern_stays(world_task(&w, &work), 4, &got), KERN_LIMIT);
    CHECK_INT(kern_stays(world_task(&w, &work), 4, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_stays(NULL, 4, &got), KERN_BAD_POINTER);
    CHECK_INT(kern_plan_stays(NULL, NULL, &got), KERN_BAD_POINTER);
    CHECK_NEAR(got, -1, 0);
}

static void raised_memory(void)
{
    static world w;
    kern_work work;
    kern_raising got = KERN_NOT_SHOWN;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        status = kern_raised(world_task(&w, &work), 0, &got, NULL, NULL);
        CHECK(status == KERN_NO_SPACE || status == KERN_STANDS);
        CHECK(status == KERN_STANDS || !enough);
        enough |= status == KERN_STANDS;
        CHECK((got == KERN_RAISED) == enough);
    }
    CHECK(enough);
    got = KERN_NOT_SHOWN;
    w.options.limit = 3;
    CHECK_INT(kern_raised(world_task(&w, &work), 0, &got, NULL, NULL),
              KERN_LIMIT);
    CHECK_INT(kern_raised(world_task(&w, &work), 0, NULL, NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_raised(NULL, 0, &got, NULL, NULL), KERN_BAD_POINTER);
    CHECK_INT(
        kern_raised(world_task(&w, &work), R(not_a_number()), &got, NULL, NULL),
        KERN_BAD_NUMBER);
    CHECK(!(kern_check_raised(NULL, 0, KERN_RAISED, NULL) <= 1));
    CHECK_INT(got, KERN_NOT_SHOWN);
}

/* kern_raised_load(), its proof checked with the loads at the factor, and that
   it is not above the load factor. */
static int raised_load(const world *w, const kern_wrench *pattern, int side,
                       double *out)
{
    static world loaded;
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    const kern_proof proof = proof_here();
    kern_real most = 0, got = -1;
    const kern_status status = kern_raised_load(task, 0, (kern_side)side,
                                                pattern, &got, &proof);
    int i;
    CHECK(work.units > 0 || status < 0);
    *out = (double)got;
    if (status != KERN_STANDS || !(got < HUGE_VAL))
        return status;
    CHECK_INT(pattern ? kern_load_factor_of(task, 0, pattern, &most, NULL)
                      : kern_load_factor(task, 0, (kern_side)side, &most, NULL),
              KERN_STANDS);
    CHECK(got <= most * (1 + GEO));
    loaded = *w;
    for (i = 0; i < w->blocks; i++) {
        kern_block *b = &loaded.block[i];
        const kern_real weight = got * b->mass * side;
        if (b->fixed)
            continue;
        kern_block_load(
            b,
            pattern ? vec(got * pattern[i].fx, got * pattern[i].fy)
                    : vec(-weight * w->gravity.y, weight * w->gravity.x),
            b->centre, pattern ? got * pattern[i].torque : 0);
    }
    CHECK(kern_check_raised(world_task(&loaded, &work), 0, KERN_RAISED, &proof)
          <= 1);
    return status;
}

/* Where nothing slides it is the load factor; Ferris and Tin-Loi's walls slide:
   a simulator lets them collapse between .640 and .645, .360 and .365, .260
   and .265. */
static void raised_loads(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const double falls[3] = {.645, .365, .265};
    static world w;
    double got, other;
    int i, n;
    for (n = 1; n <= 10; n++) {
        world_reset(&w);
        w.options.mu = R(0.84);
        world_box(&w, 0, -1, -1, 2, 0);
        for (i = 0; i < n; i++)
            world_box(&w, 1, 0, i, 1, i + 1);
        CHECK(world_touch(&w) > 0);
        CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &got), KERN_STANDS);
        CHECK_NEAR(got, n == 1 ? .84 : 1.0 / n, SINGLE ? 3e-2 : 4e-3);
    }
    for (i = 0; i < 3 && !SINGLE; i++) {
        brick_wall(&w, wall[i], 0.65, 1);
        CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &got), KERN_STANDS);
        CHECK(got >= .97 * falls[i] && got <= falls[i]);
        CHECK_INT(raised_load(&w, NULL, KERN_LEFT, &other), KERN_STANDS);
        CHECK_NEAR(other / got, 1, 0.03);
    }
}

/* The unit of length changes nothing: by powers of 2 not a bit. */
static void raised_scaled(void)
{
    static world w, other;
    static int order[MAX_BLOCKS];
    change c = no_change();
    double got, now;
    int seed, stood = 0;
    for (seed = 1; seed <= some(300); seed++) {
        if (!random_world(&w, (unsigned long long)seed, 8)
            || raised_load(&w, NULL, KERN_RIGHT, &got) != KERN_STANDS)
            continue;
        sprintf(context, "seed %d", seed);
        stood++;
        c.scale = seed % 2 ? 1.0 / 8192 : 8192;
        world_changed(&other, &w, &c, order);
        CHECK_INT(raised_load(&other, NULL, KERN_RIGHT, &now), KERN_STANDS);
        CHECK_NEAR(now, got, EXACT);
    }
    context[0] = 0;
    CHECK(stood > some(300) / 8);
}

/* The same walls under loads of their blocks, which kern_raised() finds raised
   where they grow from 0: up to 97 % of where the simulator lets them fall. */
static void raised_grown(void)
{
    static const double(*const wall[3])[10] = {wall1, wall3, wall4};
    static const double falls[3] = {.645, .365, .265};
    const kern_proof proof = proof_here();
    static world w;
    int i, k, b;
    for (i = 0; i < 3 && !SINGLE; i++)
        for (k = 1; k <= 12; k++) {
            kern_raising out = KERN_NOT_SHOWN;
            kern_work work;
            kern_task *task;
            brick_wall(&w, wall[i], 0.65, 1);
            for (b = 0; b < w.blocks; b++)
                if (!w.block[b].fixed)
                    kern_block_load(
                        &w.block[b],
                        vec(.97 * falls[i] * k / 12 * w.block[b].mass * 9.81,
                            0),
                        w.block[b].centre, 0);
            work = work_of(&w);
            task = world_task(&w, &work);
            CHECK_INT(kern_raised(task, 0, &out, NULL, &proof), KERN_STANDS);
            CHECK_INT(out, KERN_RAISED);
            CHECK(kern_check_raised(task, 0, out, &proof) <= 1);
        }
}

/* A load on one block; loads without bound; what is refused. */
static void raised_patterns(void)
{
    static world w;
    kern_wrench pattern[3] = {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}};
    kern_work work;
    kern_task *task;
    kern_real got = -7;
    double value;
    world_reset(&w);
    w.options.mu = R(0.5);
    world_box(&w, 0, -1, -1, 3, 0);
    world_box(&w, 1, 0, 0, 2, 1);
    CHECK_INT(world_touch(&w), 2);
    pattern[1].fx = w.block[1].mass * R(9.81); /* slides at mu */
    CHECK_INT(raised_load(&w, pattern, 0, &value), KERN_STANDS);
    CHECK_NEAR(value, 0.5, 2e-3);
    pattern[1].fx = 0;
    pattern[1].fy = -w.block[1].mass;
    CHECK_INT(raised_load(&w, pattern, 0, &value), KERN_STANDS);
    CHECK(value > 1e30);
    work = work_of(&w);
    task = world_task(&w, &work);
    CHECK_INT(kern_raised_load(task, 0, KERN_SHRINK, NULL, &got, NULL),
              KERN_BAD_OPTION);
    CHECK_INT(kern_raised_load(task, 0, KERN_RIGHT, NULL, NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_raised_load(NULL, 0, KERN_RIGHT, NULL, &got, NULL),
              KERN_BAD_POINTER);
    pattern[1].fy = R(not_a_number());
    CHECK_INT(kern_raised_load(task, 0, KERN_SHRINK, pattern, &got, NULL),
              KERN_BAD_NUMBER);
    CHECK_NEAR(got, -7, GEO);
    task->options.limit = 3;
    CHECK_INT(kern_raised_load(task, 0, KERN_RIGHT, NULL, &got, NULL),
              KERN_LIMIT);
    CHECK(got < 0);
    world_reset(&w); /* hangs between two walls */
    world_box(&w, 0, -1, 0, 0, 3);
    world_box(&w, 0, 1, 0, 2, 3);
    world_box(&w, 1, 0, 1, 1, 2);
    CHECK(world_touch(&w) > 0);
    CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &value), KERN_UNDECIDED);
    CHECK_NEAR(value, -1, GEO);
    w.block[2].centre.y = 5; /* falls over the edge */
    w.contacts = 0;
    CHECK_INT(raised_load(&w, NULL, KERN_RIGHT, &value), KERN_FALLS);
}

/* A cube that is tried between two walls hangs there, on the floor it does
   not. */
static void plan_raised(void)
{
    static world w;
    static site p;
    kern_raising got = KERN_NOT_SHOWN;
    kern_real reserve = 0;
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 0, -1, 0, 0, 3);
    world_box(&w, 0, 1, 0, 2, 3);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0, 2, 1, 3);
    site_with(&p, &w, 4);
    CHECK_INT(kern_plan_raised(&p.plan, NULL, &got, &reserve, NULL),
              KERN_STANDS);
    CHECK_INT(got, KERN_RAISED);
    CHECK_NEAR(reserve, 0.1, EXACT);
    CHECK_INT(kern_plan_raised(&p.plan, &w.block[4], &got, &reserve, NULL),
              KERN_STANDS);
    CHECK_INT(got, KERN_HANGS);
    CHECK_INT(p.plan.task.s.blocks, 4);
    CHECK_INT(kern_plan_raised(NULL, NULL, &got, NULL, NULL), KERN_BAD_POINTER);
}

/* ==== Pose error ================================================== >>pose */

static int margin_narrow(world *w, double narrow, double *margin)
{
    kern_work work = work_of(w);
    const kern_proof proof = proof_here();
    kern_margin m;
    int got;
    memset(&m, 0, sizeof m);
    w->options.narrow = R(narrow);
    got = kern_measure(world_task(w, &work), &m, &proof);
    *margin = (double)m.margin;
    w->options.narrow = 0;
    return got;
}

/* A cube under a gravity that leans by a tangent of .2 slides where the tangent
   of the friction angle of .4 less that of k d is .2: k d = .2 / 1.08. It tips
   at d = .4. So the least friction comes from the margin where k is large. */
static void narrow_by_hand(void)
{
    static const double rate[] = {0.1, 0.4, 0.6, 1, 10, 1000};
    static world w;
    double margin;
    size_t i;
    one_cube(&w);
    w.gravity = vec(-9.81 * 0.2, -9.81);
    for (i = 0; i < sizeof rate / sizeof *rate; i++) {
        const double slides = 0.2 / 1.08 / rate[i];
        CHECK_INT(margin_narrow(&w, rate[i], &margin), KERN_STANDS);
        CHECK_NEAR(margin, slides < 0.4 ? slides : 0.4, 2 * EDGE);
    }
    w.options.relative = 1; /* a share of .5 */
    CHECK_INT(margin_narrow(&w, 1, &margin), KERN_STANDS);
    CHECK_NEAR(margin, 0.2 / 1.08, 2 * EDGE);
    w.options.narrow = R(-1);
    CHECK_INT(verdict(&w, 0), KERN_BAD_OPTION);
    w.options.narrow = R(not_a_number());
    CHECK_INT(verdict(&w, 0), KERN_BAD_NUMBER);
}

/* w with the friction that is left at shrinkage d of cones that narrow at a
   rate. */
static const world *narrowed(const world *w, double rate, double d)
{
    static world now;
    int c;
    world_copy(&now, w);
    for (c = 0; c < now.contacts; c++) {
        const double mu = (double)now.contact[c].mu;
        const double left = (mu - rate * d) / (1 + mu * rate * d);
        now.contact[c].mu = R(left > 0 ? left : 0);
    }
    return &now;
}

/* Whether cones without narrowing hold before a margin and fail behind it.
   Returns how often that was asked. In float some structures are critical along
   a stretch: there the motion of the measure must be a proof beside the forces. */
static int check_narrowed(const world *w, double rate, double margin)
{
    const double step = (SINGLE ? 6e-3 : 4e-6) * mean_size(w);
    int side, compared = 0;
    for (side = -1; side <= 1; side += 2) {
        const double at = margin + side * step;
        int got;
        if (at < 0 || at > twin_most(w))
            continue;
        got = verdict(narrowed(w, rate, at), at);
        compared++;
        CHECK(got == (side < 0 ? KERN_STANDS : KERN_FALLS) || !decided(got)
              || (SINGLE && side > 0
                  && share_of_motion(narrowed(w, rate, at), at, motion_of)
                         <= 1.001));
    }
    return compared;
}

/* The faster cones narrow, the smaller the margin; each is that of contacts
   with the friction that is left there. Of 10,000 structures in float some
   dozens are critical along a stretch: there forces within the tolerance of
   float and a motion both are proofs, so it is asked of fewer. */
static void narrow_random(void)
{
    static const double rate[] = {0, 0.03, 0.3, 3, 300};
    static world w;
    int seed, compared = 0, structures = 0;
    for (seed = 1; seed <= (quick || SINGLE ? 400 : 40000); seed++) {
        double last = HUGE_VAL, margin;
        size_t i;
        if (!random_world(&w, (unsigned long long)seed, 12) || !twin_nested(&w))
            continue;
        sprintf(context, "seed %d", seed);
        w.options.relative = 0;
        for (i = 0; i < sizeof rate / sizeof *rate; i++) {
            const double size = mean_size(&w), k = rate[i] / size;
            if (margin_narrow(&w, k, &margin) != KERN_STANDS)
                break;
            structures += i == 1;
            CHECK(margin <= last + EDGE * size);
            last = margin;
            compared += check_narrowed(&w, k, margin);
        }
    }
    context[0] = 0;
    CHECK(compared > (quick || SINGLE ? 500 : 50000));
    CHECK(structures > (quick || SINGLE ? 100 : 10000));
}

/* ---- the largest push of one stone ------------------------------- >>push */

/* A box 1 wide and 2 high, mu .4, is pushed at its centre: it slides, and at 45
   degrees too, by P cos = mu (W - P sin); upward it takes its weight, downward
   there is no bound. Pushed at mu .6 it tips, at half its weight. */
static void push_by_hand(void)
{
    static const double mu[] = {0.4, 0.4, 0.4, 0.4, 0.4, 0.6};
    static const double angle[] = {0, 90, 180, 270, 45, 0};
    static const double want[] = {0.4, 1, 0.4, HUGE_VAL, 0.4, 0.5};
    static world w;
    size_t k;
    for (k = 0; k < sizeof mu / sizeof *mu; k++) {
        kern_wrench push[2];
        kern_work work;
        kern_real most = -1;
        world_reset(&w);
        w.options.mu = R(mu[k]);
        world_box(&w, 0, -3, -1, 4, 0);
        world_box(&w, 1, 0, 0, 1, 2);
        world_touch(&w);
        work = work_of(&w);
        memset(push, 0, sizeof push);
        push[1].fx = R(2 * W * cos(angle[k] * pi / 180));
        push[1].fy = R(2 * W * sin(angle[k] * pi / 180));
        CHECK_INT(
            kern_load_factor_of(world_task(&w, &work), 0, push, &most, NULL),
            KERN_STANDS);
        CHECK_NEAR(most, k == 4 ? 0.4 / (sqrt(0.5) * 1.4) : want[k],
                   SINGLE ? 5e-3 : 1e-6);
    }
}

/* ==== Sensitivity ========================================== >>sensitivity */

static kern_contact_rate contact_rate[MAX_POINTS];
static kern_block_rate block_rate[MAX_BLOCKS];

/* The margin, with its sensitivity if `rates`; 0 where there is none. */
static double margin_rates(const world *w, int rates)
{
    kern_work work = work_of(w);
    kern_task *task = world_task(w, &work);
    const kern_proof proof = proof_here();
    kern_margin m;
    if (kern_measure(task, &m, &proof) != KERN_STANDS || m.saturated)
        return 0;
    if (rates
        && kern_sensitivity(task, &m, &proof, contact_rate, block_rate)
               != KERN_OK)
        return 0;
    return (double)m.margin;
}

/* A cube whose centre is .1 off the middle of its bed falls at .4: the centre,
   and the far end of the bed, count once each, in opposite directions. Turned
   about its centre, .5 above the bed, it takes that end along by half of that. */
static void sensitivity_by_hand(void)
{
    static world w;
    int k;
    one_cube(&w);
    w.block[1].centre.x += R(0.1);
    CHECK_NEAR(margin_rates(&w, 1), 0.4, 2 * EDGE);
    CHECK_NEAR(block_rate[1].centre.x, -1, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].centre.y, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].mass, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].place.x, 0, SINGLE ? 0.02 : 1e-3);
    CHECK_NEAR(block_rate[1].turn, 0.5, SINGLE ? 0.02 : 1e-3);
    for (k = 0; k < 2; k++)
        CHECK_NEAR(contact_rate[k].p.x, w.contact[k].p.x > R(0.5),
                   SINGLE ? 0.02 : 1e-3);
}

/* Lines of which an end lost its travel, its sign or its partner, the last one
   of the array too: an end is taken for another's only where that exists. What
   is marked as a line and has no partner has the rates of a point. */
static void sensitivity_of_odd_lines(void)
{
    static world w;
    int seed, k, cases = 0;
    for (seed = 0; seed < some(300); seed++) {
        kern_contact_rate *rate;
        kern_work work;
        kern_task *task;
        kern_margin m;
        kern_proof proof = proof_here();
        if (!random_world(&w, 7300u + (unsigned long long)seed, 8)
            || w.contacts < 2)
            continue;
        for (k = 0; k < w.contacts; k++) {
            kern_contact *c = &w.contact[k];
            c->line = chance(0.2) ? !c->line : c->line;
            c->travel = chance(0.2) ? 0 : chance(0.2) ? -c->travel : c->travel;
        }
        w.contact[w.contacts - 1].line = 1;
        work = work_of(&w);
        task = world_task(&w, &work);
        if (kern_measure(task, &m, &proof) != KERN_STANDS || m.saturated)
            continue;
        /* an array of its own size: nothing behind it is read or written */
        rate = malloc(sizeof *rate * (size_t)w.contacts);
        CHECK(rate != NULL);
        if (rate
            && kern_sensitivity(task, &m, &proof, rate, block_rate)
                   == KERN_OK) {
            cases++;
            for (k = 0; k < w.blocks; k++)
                CHECK(isfinite((double)block_rate[k].place.x)
                      && isfinite((double)block_rate[k].turn));
        }
        free(rate);
    }
    CHECK(cases > some(15));
    context[0] = 0;
}

/* The bed of sensitivity_by_hand() as points: the same rates. */
static void sensitivity_of_points(void)
{
    static world w;
    int k;
    for (k = 0; k < 2; k++) {
        static kern_block_rate keep[MAX_BLOCKS];
        int b;
        one_cube(&w);
        w.block[1].centre.x += R(0.1);
        w.contact[0].line = 0;
        w.contact[1].line = k;
        CHECK(margin_rates(&w, 1) > 0);
        for (b = 0; b < w.blocks && k; b++) {
            CHECK_NEAR(block_rate[b].place.x, keep[b].place.x,
                       SINGLE ? 0.02 : 1e-3);
            CHECK_NEAR(block_rate[b].turn, keep[b].turn, SINGLE ? 0.02 : 1e-3);
        }
        memcpy(keep, block_rate, sizeof keep);
    }
}

/* Changes one datum by a step; returns the rate that belongs to it. */
static double nudge(world *w, int kind, int k, int b, double size, double *step)
{
    kern_contact *c = &w->contact[k];
    kern_block *block = &w->block[b];
    const double one = *step * 1e-5, h = one * size;
    const double cosine = cos(one), sine = sin(one);
    const kern_vec n = c->n;
    *step = h;
    switch (kind) {
    case 0: c->p.x += R(h); return (double)contact_rate[k].p.x;
    case 1: c->p.y += R(h); return (double)contact_rate[k].p.y;
    case 2:
        *step = one;
        c->n = vec((double)n.x * cosine - (double)n.y * sine,
                   (double)n.y * cosine + (double)n.x * sine);
        return (double)contact_rate[k].turn;
    case 3:
        *step = one;
        c->mu += R(one);
        return (double)contact_rate[k].mu;
    case 4: /* the load stays where it is */
        block->centre.x += R(h);
        block->load.torque -= R(h) * block->load.fy;
        return (double)block_rate[b].centre.x;
    case 5:
        *step = one * (double)block->mass;
        block->mass += R(*step);
        return (double)block_rate[b].mass;
    default:
        *step = one * (double)block->mass;
        block->load.fx += R(*step);
        return (double)block_rate[b].load.fx;
    }
}

static void sensitivity_random(void)
{
    static world w, now;
    unsigned long long seed;
    int good = 0, asked_here = 0;
    for (seed = 1; seed < 4000 && asked_here < 1000 && !SINGLE; seed++) {
        double margin, size, step, rate, change[2];
        int i;
        if (!random_world(&w, seed, 12) || !twin_nested(&w))
            continue;
        w.options.relative = 0;
        size = mean_size(&w);
        margin = margin_rates(&w, 1);
        if (!(margin > 0.001 * size))
            continue;
        for (i = 0; i < 6; i++) {
            const int k = random_int(0, w.contacts - 1);
            const int b = random_int(0, w.blocks - 1);
            const int kind = random_int(0, 6);
            int side, close;
            if (w.block[b].fixed)
                continue;
            for (side = -1, close = 0; side <= 1; side += 2) {
                step = side;
                world_copy(&now, &w);
                rate = nudge(&now, kind, k, b, size, &step) * step;
                change[side > 0] = margin_rates(&now, 0) - margin;
                close |= fabs(change[side > 0] - rate)
                      <= 0.01 * fabs(rate) + 1e-8 * size;
            }
            if (fabs(change[0] + change[1])
                > 0.01 * fabs(change[1]) + 1e-8 * size)
                continue; /* several mechanisms are critical */
            good += close;
            asked_here++;
        }
    }
    CHECK(SINGLE || asked_here >= 1000);
    CHECK(good >= asked_here * 95 / 100);
}

/* Moves block b by a share of the size, or turns it about its centre, with the
   load where it is, and finds its contacts anew; returns the rate that belongs
   to it. */
static double displace(world *w, int kind, int b, double size, double *step)
{
    kern_block *block = &w->block[b];
    kern_vec *v = w->vertex + (block->vertex - w->vertex);
    const kern_block was = *block;
    const double h = *step * size, cosine = cos(*step), sine = sin(*step);
    int i;
    *step = kind == 2 ? *step : h;
    for (i = 0; i < block->vertices; i++) {
        const double x = (double)(v[i].x - was.centre.x);
        const double y = (double)(v[i].y - was.centre.y);
        v[i] = kind == 2 ? vec((double)was.centre.x + x * cosine - y * sine,
                               (double)was.centre.y + y * cosine + x * sine)
                         : vec((double)v[i].x + (kind == 0) * h,
                               (double)v[i].y + (kind == 1) * h);
    }
    if (was.fixed)
        kern_ground_init(block, v, was.vertices, NULL);
    else
        kern_block_init(block, v, was.vertices, 1, NULL);
    block->mass = was.mass;
    block->load = was.load;
    block->centre = was.centre;
    block->centre.x += R(kind == 0) * R(h);
    block->centre.y += R(kind == 1) * R(h);
    block->load.torque -= R(kind == 0) * R(h) * was.load.fy
                        - R(kind == 1) * R(h) * was.load.fx;
    world_touch(w);
    return (double)(kind == 0   ? block_rate[b].place.x
                    : kind == 1 ? block_rate[b].place.y
                                : block_rate[b].turn);
}

/* Whether a kern that carries a force is about to close at the margin. */
static int kern_closes(const world *w, double margin, double size)
{
    int k, closes = 0;
    for (k = 0; k < w->contacts; k++)
        closes |= fabs(fabs((double)w->contact[k].travel) - margin)
                < 1e-3 * size;
    return closes;
}

/* Moves every free stone a little, so that no two corners coincide. */
static void shake_up(world *w, double size)
{
    int i;
    for (i = 0; i < 3 * w->blocks; i++) {
        double step = uniform(-1e-4, 1e-4);
        if (!w->block[i / 3].fixed)
            displace(w, i % 3, i / 3, size, &step);
    }
}

/* Does the margin of w change as its rates say when block b is moved or turned a
   little? Contacts are found again, so the difference is one-sided. -1 where it
   rests while others move. */
static int moves_as_said(const world *w, double margin, int kind, int b,
                         double step)
{
    static world now;
    const double size = mean_size(w);
    double said, by;
    int alike;
    world_copy(&now, w);
    said = displace(&now, kind, b, size, &step) * step;
    by = margin_rates(&now, 0) - margin;
    alike = fabs(by - said) <= 0.01 * fabs(said) + 1e-9 * size;
    return now.contacts != w->contacts || (alike && fabs(said) < 1e-9 * size)
             ? -1
             : alike;
}

static void sensitivity_of_poses(void)
{
    static world w;
    unsigned long long seed;
    int good[3] = {0, 0, 0}, all[3] = {0, 0, 0}, kind;
    for (seed = 1; seed < 20000 && all[2] < some(1000) && !SINGLE; seed++) {
        double margin, size;
        int i;
        if (!random_world(&w, seed, 12) || w.given)
            continue;
        w.options.relative = 0;
        size = mean_size(&w);
        shake_up(&w, size);
        if (w.contacts < 0 || !twin_nested(&w))
            continue;
        margin = margin_rates(&w, 1);
        if (!(margin > 0.001 * size) || kern_closes(&w, margin, size))
            continue;
        for (i = 0; i < 12; i++) {
            const int b = random_int(0, w.blocks - 1);
            const int good_now = moves_as_said(&w, margin, i % 3, b,
                                               i < 6 ? 1e-6 : -1e-6);
            good[i % 3] += good_now > 0;
            all[i % 3] += good_now >= 0;
        }
    }
    for (kind = 0; kind < 3; kind++) {
        CHECK(SINGLE || all[kind] >= some(700));
        CHECK(100 * good[kind] >= 95 * all[kind]);
    }
}

/* All sensitivities of a structure cost less than a twentieth of its margin:
   the least of up to 30 runs over many. */
static void sensitivity_cost(void)
{
    static world w;
    const kern_proof proof = proof_here();
    double least[2] = {HUGE_VAL, HUGE_VAL};
    int run, k;
    for (run = 0;
         run < (SINGLE ? 0 : 30) && (run == 0 || least[1] > 0.05 * least[0]);
         run++) {
        clock_t spent[2] = {0, 0};
        unsigned long long seed;
        for (seed = 1; seed < 400; seed++) {
            kern_margin m;
            clock_t at[3];
            kern_work work;
            random_world(&w, seed, 40);
            work = work_of(&w);
            at[0] = clock();
            if (kern_measure(world_task(&w, &work), &m, &proof) != KERN_STANDS)
                continue;
            at[1] = clock();
            kern_sensitivity(world_task(&w, &work), &m, &proof, contact_rate,
                             block_rate);
            at[2] = clock();
            for (k = 0; k < 2; k++)
                spent[k] += at[k + 1] - at[k];
        }
        for (k = 0; k < 2; k++)
            least[k] = fmin(least[k], (double)spent[k]);
    }
    CHECK(SINGLE || least[1] <= 0.05 * least[0]);
}

/* ==== Least forces ============================================== >>forces */

static kern_force least_of[MAX_POINTS];

static kern_status least_forces(const world *w, double d, kern_force *force)
{
    kern_work work = work_of(w);
    const kern_status got = kern_forces(world_task(w, &work), R(d), force);
    if (got == KERN_STANDS)
        CHECK(share_of_forces(w, (double)R(d), force) <= 1.001);
    return got;
}

/* A cube stands on two forces of half its weight, a mass on three points of a
   row on a third at each, a lintel on its piers on a quarter. */
static void forces_by_hand(void)
{
    static world w;
    const double tol = SINGLE ? 1e-4 : 1e-9;
    int k;
    one_cube(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_STANDS);
    for (k = 0; k < 2; k++) {
        CHECK_NEAR(least_of[k].normal, W / 2, tol * W);
        CHECK_NEAR(least_of[k].tangential, 0, tol * W);
    }
    world_reset(&w);
    world_mass(&w, 0, 0, 0, 1);
    world_mass(&w, 1, 0, 0.5, 1);
    for (k = -1; k <= 1; k++)
        world_point(&w, 0, 1, 0, 1, 0.5 * k, 0);
    world_touch(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_STANDS);
    for (k = 0; k < 3; k++)
        CHECK_NEAR(least_of[k].normal, W / 3, tol * W);
    world_reset(&w);
    world_box(&w, 0, 0, 0, 1, 2);
    world_box(&w, 0, 4, 0, 5, 2);
    world_box(&w, 1, 0, 2, 5, 2.5);
    world_touch(&w);
    CHECK_INT(least_forces(&w, R(0.25), least_of), KERN_STANDS);
    for (k = 0; k < 4; k++) {
        CHECK_NEAR(least_of[k].normal, 2.5 * W / 4, 3 * tol * W);
        CHECK_NEAR(least_of[k].tangential, 0, 3 * tol * W);
    }
}

/* The product of two sets of forces in which the least ones are least. */
static double force_product(const world *w, const kern_force *a,
                            const kern_force *b)
{
    double sum = 0;
    int k;
    for (k = 0; k < w->contacts; k++) {
        const double mu = (double)w->contact[k].mu;
        sum += (double)a[k].normal * (double)b[k].normal;
        if (mu > 0)
            sum += (double)a[k].tangential * (double)b[k].tangential
                 / (mu * mu);
    }
    return sum;
}

/* The force of contact k of w, which may stand elsewhere in t with its blocks
   the other way round. */
static const kern_force *force_at(const world *w, int k, const world *t,
                                  const int *order, const kern_force *force)
{
    const kern_contact *c = &w->contact[k];
    int j;
    for (j = 0; j < t->contacts; j++) {
        const kern_contact *e = &t->contact[j];
        const int turned_round = e->b == order[c->a];
        const double sign = turned_round ? -1 : 1;
        if (memcmp(&e->p, &c->p, sizeof c->p) == 0
            && e->a == order[turned_round ? c->b : c->a]
            && e->b == order[turned_round ? c->a : c->b]
            && fabs(sign * (double)e->n.x - (double)c->n.x) <= 0
            && fabs(sign * (double)e->n.y - (double)c->n.y) <= 0)
            return &force[j];
    }
    return NULL;
}

/* The forces of w, changed by c, are least_of[] within tol; mirrored with it. */
static void forces_changed(const world *w, const change *c, double d,
                           double tol)
{
    static world t;
    static kern_force image[MAX_POINTS];
    static int order[MAX_BLOCKS];
    const int side = c->mirror ? -1 : 1;
    int k;
    world_changed(&t, w, c, order);
    if (least_forces(&t, d, image) != KERN_STANDS) {
        CHECK(SINGLE); /* some are less exact there */
        return;
    }
    for (k = 0; k < w->contacts; k++) {
        const kern_force *f = c->shuffle ? force_at(w, k, &t, order, image)
                                         : &image[k];
        CHECK(f != NULL);
        if (!f)
            continue;
        CHECK_NEAR(f->normal, least_of[k].normal, tol);
        CHECK_NEAR(f->tangential, side * least_of[k].tangential, tol);
    }
}

/* Forces of a mirror image are mirrored, those of a structure whose blocks and
   contacts stand in another order the same; and no admissible forces are less:
   f.(g - f) >= 0 for the least f and any g. */
static void forces_laws(void)
{
    static world w;
    const double tol = SINGLE ? 1e-2 : 1e-6;
    int seed, place, k, done = 0, asked_here = 0;
    for (seed = 1; seed <= some(1000); seed++) {
        change c = no_change();
        double margin;
        random_world(&w, (unsigned long long)seed, 15);
        w.given = 1;
        margin = margin_rates(&w, 0);
        sprintf(context, "seed %d", seed);
        for (place = 0; place < 3 && margin > 1e-3 * mean_size(&w); place++) {
            const double d = margin * place * 0.45;
            double most = 0, size;
            if (verdict(&w, d) != KERN_STANDS)
                continue;
            asked_here++;
            if (least_forces(&w, d, least_of) != KERN_STANDS)
                continue;
            done++;
            size = force_product(&w, least_of, least_of);
            CHECK(force_product(&w, least_of, force_of) >= size * (1 - tol));
            for (k = 0; k < w.contacts; k++)
                most = fmax(most, (double)least_of[k].normal);
            for (c.mirror = 0; c.mirror < 2; c.mirror++) {
                c.shuffle = !c.mirror;
                forces_changed(&w, &c, d, tol * most);
            }
        }
    }
    context[0] = 0;
    CHECK(asked_here > some(500));
    CHECK(100 * done >= (SINGLE ? 97 : 99) * asked_here);
}

/* A fall, bad input, too little memory, too little work. */
static void forces_refused(void)
{
    static world w;
    kern_work work;
    int part, enough = 0;
    jack_arch(&w);
    for (part = 0; part <= 50; part++) {
        kern_status status;
        work = work_of_part(&w, part);
        least_of[0].normal = -1;
        status = kern_forces(world_task(&w, &work), 0, least_of);
        CHECK(status == (enough ? KERN_STANDS : KERN_NO_SPACE)
              || status == KERN_STANDS);
        enough |= status == KERN_STANDS;
        CHECK((least_of[0].normal >= 0) == enough);
    }
    CHECK(enough);
    w.options.limit = 3;
    CHECK_INT(kern_forces(world_task(&w, &work), 0, least_of), KERN_LIMIT);
    w.options.limit = 0;
    CHECK_INT(kern_forces(world_task(&w, &work), 0, NULL), KERN_BAD_POINTER);
    CHECK_INT(kern_forces(NULL, 0, least_of), KERN_BAD_POINTER);
    CHECK_INT(kern_forces(world_task(&w, &work), R(not_a_number()), least_of),
              KERN_BAD_NUMBER);
    world_reset(&w);
    world_box(&w, 0, -1, -1, 2, 0);
    world_box(&w, 1, 1.6, 0, 2.6, 1);
    world_touch(&w);
    CHECK_INT(least_forces(&w, 0, least_of), KERN_UNDECIDED);
}

/* ==== All tests ===================================================== >>all */

typedef struct test {
    const char *name;
    void (*run)(void);
} test;

#define TEST(name)  \
    {               \
#name, name \
    }
static const test tests[] = {
    TEST(polygon_area_and_centre),
    TEST(polygon_far_away),
    TEST(polygon_faults),
    TEST(polygon_load),
    TEST(polygon_of_many_vertices),
    TEST(polygon_depth_of_vertices),
    TEST(contact_cube_on_cube),
    TEST(contact_two_feet),
    TEST(contact_concave),
    TEST(contact_points),
    TEST(contact_merged_faces),
    TEST(contact_angle),
    TEST(contact_rules),
    TEST(contact_floor),
    TEST(contact_gap),
    TEST(contact_narrow_seat),
    TEST(contact_overlap),
    TEST(contact_in_a_mouth),
    TEST(contact_of_a_bowl),
    TEST(contact_given),
    TEST(contact_stale),
    TEST(count_that_is_a_status),
    TEST(contact_given_point_and_line),
    TEST(contact_travels),
    TEST(lone_points),
    TEST(contact_room),
    TEST(contact_work),
    TEST(contact_many_blocks),
    TEST(contact_invariance),
    TEST(contact_order),
    TEST(steps_of_a_rounding),
    TEST(steps_that_carry),
    TEST(steps_of_pixels),
    TEST(steps_that_slide),
    TEST(steps_and_knees),
    TEST(steps_at_ends),
    TEST(steps_lips),
    TEST(steps_of_ramps),
    TEST(steps_apart),
    TEST(steps_straight_joint),
    TEST(overlap_with_whiskers),
    TEST(travels_of_many),
    TEST(given_normals),
    TEST(steps_in_random_stones),
    TEST(steps_invariance),
    TEST(steps_in_random_structures),
    TEST(long_outlines),
    TEST(long_joint),
    TEST(open_joint),
    TEST(engine_rows),
    TEST(engine_laws),
    TEST(engine_factor),
    TEST(engine_group),
    TEST(engine_basis),
    TEST(engine_place),
#ifndef KERN_NO_INTERIOR
    TEST(engine_step),
#endif
    TEST(engine_bracket),
    TEST(lp_cycling),
    TEST(lp_many_pivots),
    TEST(lp_of_no_cost),
    TEST(lp_kinds),
    TEST(lp_random),
    TEST(lp_scaled),
    TEST(lp_small_beside_large),
    TEST(lp_small_rows_and_rays),
    TEST(lp_bad_input),
    TEST(lp_every_size),
    TEST(proof_forces_of_a_cube),
    TEST(proof_free_fall),
    TEST(proof_motions_of_a_cube),
    TEST(proof_damage),
    TEST(proof_of_a_fixed_block),
    TEST(proof_too_large),
    TEST(proof_without_rounding),
    TEST(proof_far_away),
    TEST(proof_of_no_numbers),
    TEST(proof_out_of_bounds),
    TEST(proof_of_small_stones),
    TEST(margin_relative),
    TEST(margin_steps),
    TEST(margin_ends),
    TEST(margin_not_monotone),
    TEST(deficit_by_hand),
    TEST(deficit_random),
    TEST(load_by_hand),
    TEST(load_beside_others),
    TEST(tilt_by_hand),
    TEST(tilt_in_a_slot),
    TEST(tilt_and_load_factor),
    TEST(axle_on_a_bridge),
    TEST(plan_random),
    TEST(plan_points),
    TEST(plan_changes),
    TEST(plan_candidates),
    TEST(plan_saturated),
    TEST(plan_with_one_array),
    TEST(critical_by_hand),
    TEST(critical_narrow),
    TEST(critical_laws),
    TEST(critical_bad_input),
    TEST(known_garbage),
    TEST(plan_stale),
    TEST(plan_ground_only),
    TEST(plan_by_hand),
    TEST(plan_bears_when_closed),
    TEST(plan_faults),
    TEST(plan_bad_input),
    TEST(plan_every_size),
    TEST(relative_shares),
    TEST(plan_out_of_date),
    TEST(plan_fuzz),
    TEST(jams_are_bounded),
    TEST(jams_fill_the_factors),
    TEST(profile_ends),
    TEST(bearing_of_lips),
    TEST(bearing_by_definition),
    TEST(limits_of_work),
    TEST(limit_before_reading),
    TEST(known_slope),
    TEST(known_column),
    TEST(known_offset),
    TEST(known_boxes),
    TEST(known_lintel),
    TEST(known_harmonic_stack),
    TEST(known_ladder),
    TEST(known_a_frame),
    TEST(known_thin_arch),
    TEST(known_sliding_arch),
    TEST(known_two_bodies),
    TEST(known_jam),
    TEST(known_walls),
    TEST(known_tower_and_trapezoid),
    TEST(laws_units_and_places),
    TEST(laws_load_factor),
    TEST(laws_more_support),
    TEST(laws_side_by_side),
    TEST(twin_random),
    TEST(twin_lone_points),
    TEST(bad_structure),
    TEST(bad_pointers),
    TEST(bad_arguments),
    TEST(bad_geometry),
    TEST(refused_blocks),
    TEST(bad_contact_pointers),
    TEST(status_of_every_kind),
    TEST(memory_need),
    TEST(memory_every_size),
    TEST(memory_lean),
    TEST(memory_garbage),
    TEST(profile_two_storeys),
    TEST(profile_side_by_side),
    TEST(profile_takes_along),
    TEST(profile_laws),
    TEST(profile_of_two),
    TEST(profile_bad_input),
    TEST(near_contacts),
    TEST(measured_gaps),
    TEST(overlaps_of_three),
    TEST(certain_verdicts),
    TEST(measured_bounds),
    TEST(measured_corner_beyond_steps),
    TEST(certain_supports),
    TEST(certain_given),
    TEST(certain_limit),
    TEST(certain_bounds),
    TEST(measured_round_stone),
    TEST(mean_size_of_blocks),
    TEST(raised_by_hand),
    TEST(raised_reserve),
    TEST(raised_random),
    TEST(raised_memory),
    TEST(stays_law),
    TEST(stays_random),
    TEST(stays_memory),
    TEST(raised_loads),
    TEST(raised_scaled),
    TEST(raised_grown),
    TEST(raised_patterns),
    TEST(plan_raised),
    TEST(narrow_by_hand),
    TEST(narrow_random),
    TEST(push_by_hand),
    TEST(sensitivity_by_hand),
    TEST(sensitivity_of_odd_lines),
    TEST(sensitivity_of_points),
    TEST(sensitivity_random),
    TEST(sensitivity_of_poses),
    TEST(sensitivity_cost),
    TEST(forces_by_hand),
    TEST(forces_laws),
    TEST(forces_refused),
};
#undef TEST

/* A count with a comma after every three digits. */
static const char *grouped(long n)
{
    static char text[40];
    char digits[24];
    int i, k = 0, length = sprintf(digits, "%ld", n);
    for (i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            text[k++] = ',';
        text[k++] = digits[i];
    }
    text[k] = 0;
    return text;
}

/* The comparison with the twin alone, on `many` structures. */
static void run_random(long many, long first)
{
    const long none = compare_many(first, many, 40, 20);
    printf("%ld random structures: %ld undecided, %ld of %ld questions open to "
           "the twin\n",
           many, none, twin_near, twin_asked);
    CHECK(SINGLE || none == 0);
}

static void run_test(const test *one)
{
    const clock_t start = clock();
    failed_here = 0;
    context[0] = 0;
    one->run();
    context[0] = 0;
    printf("%-28s %s%6.2f s\n", one->name, failed_here ? "FAILED" : "ok    ",
           (double)(clock() - start) / CLOCKS_PER_SEC);
    if (failed_here > 10)
        printf("    ... %ld checks failed\n", failed_here);
    fflush(stdout);
}

static const char help[] =
    "usage: kern_test [--quick] [NAME...]\n"
    "       kern_test --random N [FIRST] | --plans N [FIRST]\n"
    "Runs the tests whose name contains one of the NAMEs, or all.\n"
    "  --quick    a fifth of the random structures, or fewer\n"
    "  --random   only this comparison, on N structures from number FIRST on\n"
    "  --plans    only N calls on plans, on structures from number FIRST on\n";

/* Runs the tests whose names contain one of some words, or all where there is
   none. Returns how many. */
static int run_tests(int words, char **word)
{
    size_t i;
    int run = 0;
    for (i = 0; i < sizeof tests / sizeof *tests; i++) {
        int k, wanted = words == 0;
        for (k = 0; k < words; k++)
            wanted = wanted || strstr(tests[i].name, word[k]);
        if (!wanted)
            continue;
        run_test(&tests[i]);
        run++;
    }
    if (run == 0) {
        printf("no test has such a name\n");
        failed++;
    }
    return run;
}

int main(int argc, char **argv)
{
    int run = 1;
    if (argc > 1 && strcmp(argv[1], "--help") == 0)
        return fputs(help, stdout) < 0;
    if (argc > 1 && strcmp(argv[1], "--quick") == 0) {
        quick = 1;
        argc--;
        argv++;
    }
    if (argc > 2 && strcmp(argv[1], "--random") == 0) {
        run_random(atol(argv[2]), argc > 3 ? atol(argv[3]) : 10000000);
    } else if (argc > 2 && strcmp(argv[1], "--plans") == 0) {
        plan_fuzz_calls(atol(argv[2]), argc > 3
                                           ? (unsigned long long)atol(argv[3])
                                           : 7400000u);
        printf(
            "%ld calls on plans, %ld ended by a limit or for want of memory\n",
            plan_calls, plan_ends);
    } else if (argc > 1 && argv[1][0] == '-') {
        fputs(help, stderr);
        return 2;
    } else
        run = run_tests(argc - 1, argv + 1);
    failed_here = 0;
    CHECK(undecided <= (SINGLE ? asked / 50 : 0));
    CHECK(proof_error <= 1);
    printf("%d tests: %s checks passed, ", run, grouped(passed));
    printf("%s failed\n", grouped(failed));
    return failed ? 1 : 0;
}
