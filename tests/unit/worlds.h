/* worlds.h - structures by hand, with the memory of everything they hold. */

#ifndef UNIT_WORLDS_H
#define UNIT_WORLDS_H

#include "harness.h"

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

/* A cube of weight W = 9.81 shifted by s on a fixed one. */
static void shifted_cube(world *w, double s)
{
    world_reset(w);
    world_box(w, 0, 0, 0, 1, 1);
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

/* Simplifies the outlines of all blocks; masses, centres and loads stay. */
static void world_simplify(world *w, double tolerance)
{
    static kern_vec raw[MAX_VERTICES];
    static int kept[MAX_VERTICES];
    int i;
    for (i = 0; i < w->blocks; i++) {
        kern_block *b = &w->block[i], made;
        const int n = b->vertices;
        kern_vec *out = w->vertex + (b->vertex - w->vertex);
        memcpy(raw, out, sizeof *raw * (size_t)n);
        b->vertices = kern_outline_simplify(raw, n, R(tolerance), out, kept, n);
        CHECK(b->vertices >= 3);
        CHECK_INT(kern_ground_init(&made, out, b->vertices, NULL), KERN_OK);
        b->area = made.area;
        b->box = made.box;
    }
}

#endif
