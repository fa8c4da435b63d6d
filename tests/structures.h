/* structures.h - random structures for the tests, the same on every machine.

   They are made from whole numbers by + - * / alone, since sines and powers
   differ from one libm to the next. random_structure() fills the variables
   below; towers, walls, arches, concave stones and stones on points come alike
   often, small ones more often than large ones. */

#ifndef STRUCTURES_H
#define STRUCTURES_H

#include "../kern.h"

#include "../examples/parts/random.h"

#include <stdint.h>
#include <string.h>

enum { BLOCKS = 16, CONTACTS = 120, VERTICES = 20 };

static kern_vec vertex[BLOCKS][VERTICES];
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_options options;
static kern_structure s;
static uint64_t state;
static kern_real reals[KERN_REALS(BLOCKS, CONTACTS)];
static int ints[KERN_INTS(BLOCKS, CONTACTS)];

/* All work memory that a structure may need. */
static kern_work whole_work(void)
{
    return kern_work_of(reals, KERN_REALS(BLOCKS, CONTACTS), ints,
                        KERN_INTS(BLOCKS, CONTACTS));
}

/* The structure, its options and this work memory. */
static kern_task *task_of(kern_work *work)
{
    static kern_task task;
    task = kern_task_of(s.block, s.blocks, s.contact, s.contacts, work);
    task.s.gravity = s.gravity;
    task.options = options;
    return &task;
}

static kern_vec vec_of(kern_real x, kern_real y)
{
    kern_vec v;
    v.x = x;
    v.y = y;
    return v;
}

static uint32_t random_word(void)
{
    return (uint32_t)(random_bits(&state) >> 32);
}

static int random_below(int end)
{
    return (int)(random_word() % (uint32_t)end);
}

static kern_real uniform(double low, double high)
{ /* 24 bits, which a float holds */
    const kern_real part = (kern_real)(random_word() >> 8) / 16777216;
    return (kern_real)(low) + ((kern_real)(high) - (kern_real)(low)) * part;
}

static void add(const kern_vec *corner, int corners, kern_real density)
{
    const int i = s.blocks++;
    memcpy(vertex[i], corner, sizeof *corner * (size_t)corners);
    if (density > 0)
        kern_block_init(&block[i], vertex[i], corners, density, NULL);
    else
        kern_ground_init(&block[i], vertex[i], corners, NULL);
}

static void add_box(kern_real x0, kern_real y0, kern_real x1, kern_real y1,
                    kern_real density)
{
    kern_vec c[4];
    c[0] = vec_of(x0, y0);
    c[1] = vec_of(x1, y0);
    c[2] = vec_of(x1, y1);
    c[3] = vec_of(x0, y1);
    add(c, 4, density);
}

/* Trapezoids whose beds slope, and boxes, one on the other. */
static void make_tower(int blocks, kern_real slope)
{
    const kern_real jitter = uniform(0, 0.15);
    kern_real x = 0, y = 0, bed = 0;
    int i;
    add_box(-9, -1, 9, 0, 0);
    for (i = 0; i < blocks; i++) {
        const kern_real half = uniform(0.3, 0.7), high = uniform(0.3, 1.2);
        const kern_real next = slope * uniform(-1, 1);
        kern_vec c[4];
        x += jitter * uniform(-1, 1);
        /* beds are lines through (0, y) */
        c[0] = vec_of(x - half, y + bed * (x - half));
        c[1] = vec_of(x + half, y + bed * (x + half));
        c[2] = vec_of(x + half, y + high + next * (x + half));
        c[3] = vec_of(x - half, y + high + next * (x - half));
        add(c, 4, uniform(1, 3));
        y += high;
        bed = next;
    }
}

static void make_wall(int blocks)
{
    const int row = 2 + random_below(4);
    const kern_real joint = random_below(2) ? (kern_real)(0)
                                            : (kern_real)(0.03);
    kern_real y = 0;
    add_box(-9, -1, 9, 0, 0);
    while (blocks > 0) {
        const kern_real high = uniform(0.3, 0.7);
        kern_real x = uniform(-0.3, 0.3);
        int k;
        for (k = 0; k < row && blocks > 0; k++) {
            const kern_real wide = uniform(0.5, 1.5);
            if (y <= 0 || random_below(12)) {
                add_box(x, y, x + wide, y + high, 2);
                blocks--;
            }
            x += wide + joint;
        }
        y += high;
    }
}

/* A point of the circle, from the tangent of half the angle to the vertical. */
static kern_vec on_circle(kern_real half_tangent, kern_real radius)
{
    const kern_real q = half_tangent * half_tangent;
    return vec_of(radius * 2 * half_tangent / (1 + q),
                  radius * (1 - q) / (1 + q));
}

/* Voussoirs between two fixed ones. */
static void make_arch(int blocks)
{
    const kern_real end = uniform(0.3, 1), thick = uniform(0.03, 0.3);
    const kern_real step = 2 * end / (kern_real)(blocks);
    int i;
    for (i = -1; i <= blocks; i++) {
        const kern_real from = -end + (kern_real)(i)*step;
        const kern_real to = -end + (kern_real)(i + 1) * step;
        kern_vec c[4];
        c[0] = on_circle(from, 1);
        c[1] = on_circle(to, 1);
        c[2] = on_circle(to, 1 + thick);
        c[3] = on_circle(from, 1 + thick);
        add(c, 4, (kern_real)(i >= 0 && i < blocks));
    }
}

/* L, U and box shapes, one on the other. */
static void make_concave(int blocks)
{
    kern_real x = 0, y = 0;
    int i;
    add_box(-9, -1, 9, 0, 0);
    for (i = 0; i < blocks; i++) {
        const kern_real a = uniform(0.15, 0.4), h = uniform(0.6, 1.2);
        const int feet = random_below(3); /* box, L and table */
        kern_vec c[8];
        int n = 0;
        x += uniform(-0.12, 0.12);
        c[n++] = vec_of(x - (kern_real)(0.5), y);
        if (feet > 0) {
            c[n++] = vec_of(x - a, y);
            c[n++] = vec_of(x - a, y + h / 2);
        }
        if (feet > 1) {
            c[n++] = vec_of(x + a, y + h / 2);
            c[n++] = vec_of(x + a, y);
        }
        if (feet == 1)
            c[n++] = vec_of(x + (kern_real)(0.5), y + h / 2);
        else
            c[n++] = vec_of(x + (kern_real)(0.5), y);
        c[n++] = vec_of(x + (kern_real)(0.5), y + h);
        c[n++] = vec_of(x - (kern_real)(0.5), y + h);
        add(c, n, uniform(1, 2));
        y += h;
    }
}

/* Stones on two to four points with normals of their own, as a sensor or a
   camera would tell them. */
static void make_points(int blocks)
{
    int i, k;
    make_tower(blocks, 0);
    for (i = 1; i < s.blocks; i++) {
        const int points = 2 + random_below(3);
        for (k = 0; k < points; k++) {
            const kern_real at = block[i].centre.x + uniform(-0.5, 0.5);
            const kern_vec p = vec_of(at, vertex[i][0].y);
            const kern_vec n = vec_of(uniform(-0.8, 0.8), 1);
            kern_contact *c = contact + s.contacts;
            int got;
            c->a = i - 1;
            c->b = i;
            c->p = p;
            c->n = n;
            c->mu = uniform(0.1, 0.9);
            got = kern_contact_make(c, p, &options);
            s.contacts += got > 0 ? got : 0;
        }
    }
    kern_contact_travels(contact, s.contacts);
}

static void load_some(void)
{
    int i;
    for (i = 0; i < s.blocks; i++)
        if (!block[i].fixed && random_below(2)) {
            /* one by one: arguments are evaluated in any order */
            const kern_real weight = 9 * block[i].mass;
            const kern_real fx = uniform(-0.2, 0.2) * weight;
            const kern_real fy = uniform(-0.4, 0.2) * weight;
            const kern_real torque = uniform(-0.04, 0.04) * weight;
            kern_block_load(&block[i], vec_of(fx, fy), block[i].centre, torque);
        }
}

/* A number of blocks up to `most`. */
static int random_count(int least, int most)
{
    int n = random_below(most), m = random_below(most);
    n = (n < m ? n : m) + 1;
    return n < least ? least : n;
}

/* Before structure number `seed`: nothing is there, and lengths of one in
   `relative` are relative. */
static void random_begin(int seed, int relative)
{
    state = random_from((uint64_t)seed);
    options = kern_defaults();
    options.mu = uniform(0.1, 1);
    options.relative = random_below(relative) == 0;
    s.blocks = s.contacts = 0;
    s.block = block;
    s.contact = contact;
    s.gravity = vec_of(0, (kern_real)(-9.8125));
}

/* Structure number `seed`, of at most `most` free blocks (but three in an
   arch; up to 14). The fault says why contacts could not be found. */
static void random_structure(int seed, int most, kern_work *work)
{
    random_begin(seed, 4);
    s.gravity.x = random_below(3) ? (kern_real)(0) : uniform(-2, 2);
    switch (random_below(6)) {
    case 0: make_tower(random_count(1, most), 0); break;
    case 1: make_tower(random_count(1, most), (kern_real)(0.2)); break;
    case 2: make_wall(random_count(1, most)); break;
    case 3: make_arch(random_count(3, most)); break;
    case 4: make_concave(random_count(1, most)); break;
    default: make_points(random_count(1, most)); break;
    }
    if (s.contacts == 0)
        s.contacts = kern_contacts(block, s.blocks, &options, contact, CONTACTS,
                                   work);
    if (random_below(3) == 0)
        load_some();
}

#endif
