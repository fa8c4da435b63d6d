/* scenes.h - the structures that bench.c and work.c ask about: files of the
   corpus (tests/CORPUS.md), and families that are made from fixed seeds: walls
   in running bond (bond), ragged with gaps (rag), with sloped beds (irr), towers,
   voussoir arches, and perfect brick walls (brick), whose programs are as
   degenerate as can be. A made structure is named family/blocks/number.

   SPDX-License-Identifier: MIT */

#ifndef SCENES_H
#define SCENES_H

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KERN_STATIC
#include "../kern.h"

#include "../examples/parts/random.h"
#include "../examples/parts/text.h"

#define MU 0.4         /* of the families                                 */
#define LENGTH 0.4     /* of a brick [m]; it is half as high              */
#define DENSITY 2000.0 /* [kg/m^2]                                        */
#define CORNERS 16     /* most vertices of a block                        */
#define COURSE 256     /* most bricks of a course                         */

static inline void give_up(const char *why)
{
    fprintf(stderr, "%s\n", why);
    exit(2);
}

static inline void *room_for(size_t count, size_t size)
{
    void *p = calloc(count ? count : 1, size);
    if (!p)
        give_up("out of memory");
    return p;
}

struct scene {
    char name[80]; /* set/file, or family/blocks/number               */
    int size;      /* free blocks                                     */
    int is_wall;   /* of a family: stones can be laid on its top      */
    int is_file;
    kern_vec *vertex;
    kern_block *block;
    kern_contact *contact;
    int blocks, vertices, contacts;
    int room; /* for contacts                                    */
    uint64_t random;
    kern_vec gravity;
    kern_options options;
    struct text_file text; /* of a file: its blocks                           */
};

/* ---- Families ------------------------------------------------------------ */

static inline double scene_random(struct scene *scene, double low, double high)
{
    return low + (high - low) * random_share(random_mixed(&scene->random));
}

static inline kern_vec vec(double x, double y)
{
    kern_vec v;
    v.x = x;
    v.y = y;
    return v;
}

static inline void scene_block(struct scene *scene, const kern_vec *vertex,
                               int n, double density)
{
    kern_vec *copy = scene->vertex + scene->vertices;
    kern_block *b = &scene->block[scene->blocks++];
    memcpy(copy, vertex, (size_t)n * sizeof *vertex);
    scene->vertices += n;
    if ((density > 0 ? kern_block_init(b, copy, n, density, NULL)
                     : kern_ground_init(b, copy, n, NULL))
        != KERN_OK)
        give_up("a bad block");
}

static inline void scene_box(struct scene *scene, double left, double low,
                             double right, double high, double density)
{
    kern_vec v[4];
    v[0] = vec(left, low);
    v[1] = vec(right, low);
    v[2] = vec(right, high);
    v[3] = vec(left, high);
    scene_block(scene, v, 4, density);
}

/* What distinguishes the walls from each other; lengths in bricks. */
struct wall {
    double first[2]; /* bounds of the first brick of odd courses; that of
                              even ones is half a brick longer                */
    double ragged;   /* lengths differ by this share                    */
    double gap[2];   /* bounds of the gap between neighbours            */
    double batter;   /* each course is that much shorter at its ends    */
    double loose;    /* its ends lie somewhere within that              */
    double slope;    /* heights of the joints differ by this share      */
    double uneven;   /* densities differ by this share                  */
};

/* The upper side of a course: a line that bends in the middle of each joint
   between two bricks, so that every brick has a straight top. */
struct bed {
    double x[COURSE + 1], y[COURSE + 1];
    int knots;
};

static inline double bed_at(const struct bed *bed, double x)
{
    int i = 1;
    if (x <= bed->x[0])
        return bed->y[0];
    while (i < bed->knots && x > bed->x[i])
        i++;
    if (i == bed->knots)
        return bed->y[i - 1];
    return bed->y[i - 1]
         + (bed->y[i] - bed->y[i - 1]) * (x - bed->x[i - 1])
               / (bed->x[i] - bed->x[i - 1]);
}

static inline void bed_knot(struct bed *bed, double x, double y)
{
    if (bed->knots > COURSE)
        give_up("a course is too long");
    bed->x[bed->knots] = x;
    bed->y[bed->knots++] = y;
}

static inline void wall_brick_add(struct scene *scene, const struct bed *under,
                                  const struct bed *over, double left,
                                  double right, int bends, double density)
{
    kern_vec v[CORNERS];
    int n = 0, i;
    v[n++] = vec(left, bed_at(under, left));
    for (i = 0; bends && i < under->knots && n < CORNERS - 3; i++)
        if (under->x[i] > left && under->x[i] < right)
            v[n++] = vec(under->x[i], under->y[i]);
    v[n++] = vec(right, bed_at(under, right));
    v[n++] = vec(right, bed_at(over, right));
    v[n++] = vec(left, bed_at(over, left));
    scene_block(scene, v, n, density);
}

/* One course, from `x` to `end`, of `most` bricks at the most. What is left at
   the end and too short for a brick goes to the last one. */
static inline void wall_course(struct scene *scene, const struct wall *wall,
                               int odd, double x, double end, double top,
                               const struct bed *under, struct bed *over,
                               int most)
{
    double share = scene_random(scene, wall->first[0], wall->first[1])
                 + (odd ? 0.0 : 0.5);
    double half = 0; /* of the gap at x: none before the first brick    */
    over->knots = 0;
    bed_knot(over, x,
             top + LENGTH * wall->slope * scene_random(scene, -0.5, 0.5));
    while (x < end && most > 0) {
        double next = x + share * LENGTH, gap;
        if (next > end - 0.4 * LENGTH)
            next = end;
        gap = next < end
                ? LENGTH * scene_random(scene, wall->gap[0], wall->gap[1])
                : 0;
        bed_knot(over, next,
                 top + LENGTH * wall->slope * scene_random(scene, -0.5, 0.5));
        wall_brick_add(
            scene, under, over, x + half, next - gap / 2, wall->slope > 0,
            DENSITY * (1 + wall->uneven * scene_random(scene, -1, 1)));
        half = gap / 2;
        x = next;
        share = 1 + wall->ragged * scene_random(scene, -1, 1);
        most--;
    }
}

/* About twice as long as high, give or take a third. */
static inline void make_wall(struct scene *scene, int n,
                             const struct wall *wall)
{
    const int courses = (int)(sqrt(n * scene_random(scene, 0.67, 1.5)) + 0.5);
    const double inset = wall->batter * LENGTH;
    const double loose = wall->loose * LENGTH;
    const double length = LENGTH * n / courses + inset * courses;
    struct bed bed[2];
    int k;
    scene_box(scene, -length, -LENGTH, 2 * length, 0, 0);
    bed[0].knots = 0;
    bed_knot(&bed[0], 0, 0);
    for (k = 0; scene->blocks < n + 1; k++) {
        const double right = length - inset * k
                           + loose * scene_random(scene, -0.5, 0.5);
        const double left = inset * k + loose * scene_random(scene, -0.5, 0.5);
        wall_course(scene, wall, k % 2, left, right, LENGTH / 2 * (k + 1),
                    &bed[k % 2], &bed[(k + 1) % 2], n + 1 - scene->blocks);
    }
}

static inline void make_tower(struct scene *scene, int n,
                              const struct wall *wall)
{
    double low = 0;
    int i;
    (void)wall;
    scene_box(scene, -4 * LENGTH, -LENGTH, 4 * LENGTH, 0, 0);
    for (i = 0; i < n; i++) {
        const double wide = LENGTH * scene_random(scene, 0.8, 1.2);
        const double left = LENGTH * scene_random(scene, -0.2, 0.2) - wide / 2;
        const double high = low + LENGTH * scene_random(scene, 0.3, 0.6);
        scene_box(scene, left, low, left + wide, high, DENSITY);
        low = high;
    }
}

/* A piece of a ring, from one angle to another, counted from upright. */
static inline void arch_piece(struct scene *scene, double inner, double outer,
                              double from, double to, double density)
{
    kern_vec v[4];
    v[0] = vec(inner * sin(from), inner * cos(from));
    v[1] = vec(inner * sin(to), inner * cos(to));
    v[2] = vec(outer * sin(to), outer * cos(to));
    v[3] = vec(outer * sin(from), outer * cos(from));
    scene_block(scene, v, 4, density);
}

static inline void make_arch(struct scene *scene, int n,
                             const struct wall *wall)
{
    const double inner = LENGTH * n / 4 + LENGTH;
    const double outer = inner * scene_random(scene, 1.2, 1.4);
    const double half = scene_random(scene, 0.9, 1.3);
    int i;
    (void)wall;
    arch_piece(scene, inner, outer, -half - 0.2, -half, 0);
    arch_piece(scene, inner, outer, half, half + 0.2, 0);
    for (i = 0; i < n; i++)
        arch_piece(scene, inner, outer, -half + 2 * half * i / n,
                   -half + 2 * half * (i + 1) / n,
                   DENSITY * scene_random(scene, 0.7, 1.3));
}

static const struct family {
    const char *name;
    void (*make)(struct scene *scene, int n, const struct wall *wall);
    int is_wall;
    struct wall wall;
} families[] = {
    {"bond", make_wall, 1, {{0.25, 0.75}, 0.15, {0.02, 0.02}, 0, 0.3, 0, 0}},
    {"rag", make_wall, 1, {{0.4, 0.9}, 0.4, {0.03, 0.2}, 0.12, 0.12, 0, 0.2}},
    {"irr", make_wall, 1, {{0.4, 0.7}, 0.3, {0.02, 0.02}, 0.1, 0.1, 0.12, 0.2}},
    {"tower", make_tower, 0, {{0, 0}, 0, {0, 0}, 0, 0, 0, 0}},
    {"arch", make_arch, 0, {{0, 0}, 0, {0, 0}, 0, 0, 0, 0}},
    {"brick", make_wall, 1, {{0.5, 0.5}, 0, {0, 0}, 0, 0, 0, 0}},
    /* fitted masonry: beds with knees, and closed head joints */
    {"fit", make_wall, 1, {{0.4, 0.7}, 0.3, {0, 0}, 0.1, 0.1, 0.12, 0.2}},
};
enum { FAMILIES = sizeof families / sizeof families[0] };

/* ---- Opening ------------------------------------------------------------- */

/* Finds the contacts, as any program does. */
static inline void scene_touch(struct scene *scene)
{
    kern_work work = kern_work_of(
        NULL, 0, room_for(2 * (size_t)scene->blocks, sizeof(int)),
        2 * scene->blocks);
    scene->room = 32 * (scene->blocks + 1);
    scene->contact = room_for((size_t)scene->room, sizeof(kern_contact));
    scene->contacts = kern_contacts(scene->block, scene->blocks,
                                    &scene->options, scene->contact,
                                    scene->room, &work);
    free(work.index);
    if (scene->contacts < 0) {
        fprintf(stderr, "%s: ", scene->name);
        give_up(kern_status_text((kern_status)scene->contacts));
    }
}

static inline void scene_make(struct scene *scene, int family, int n,
                              int number)
{
    memset(scene, 0, sizeof *scene);
    snprintf(scene->name, sizeof scene->name, "%s/%d/%d", families[family].name,
             n, number);
    scene->random = (uint64_t)(1000003 * family + 101 * n + number);
    scene->is_wall = families[family].is_wall;
    scene->vertex = room_for((size_t)(n + 2) * CORNERS, sizeof(kern_vec));
    scene->block = room_for((size_t)n + 2, sizeof(kern_block));
    scene->gravity = vec(0, -9.81);
    scene->options = kern_defaults();
    scene->options.mu = MU;
    families[family].make(scene, n, &families[family].wall);
    scene->size = n;
    scene_touch(scene);
}

/* The last folder and the name of a file, without its end. */
static inline void scene_name(struct scene *scene, const char *path)
{
    const char *from = strrchr(path, '/');
    char *dot;
    while (from && from > path && from[-1] != '/')
        from--;
    snprintf(scene->name, sizeof scene->name, "%.79s", from ? from : path);
    dot = strrchr(scene->name, '.');
    if (dot && dot > scene->name)
        *dot = 0;
}

/* A step that the file asks for is not taken over: all are asked alike. */
static inline void scene_read(struct scene *scene, const char *path)
{
    struct text_file *t = &scene->text;
    memset(scene, 0, sizeof *scene);
    scene_name(scene, path);
    if (text_load(t, path)) {
        fprintf(stderr, "%s: ", path);
        give_up(t->message);
    }
    for (scene->random = 1; *path; path++)
        scene->random = scene->random * 31 + (unsigned char)*path;
    scene->is_file = 1;
    scene->block = t->block;
    scene->blocks = t->blocks;
    scene->gravity = t->gravity;
    scene->options = t->options;
    scene->options.epsilon = 0;
    scene->size = t->blocks - t->fixed;
    if (!t->given) {
        scene_touch(scene);
        return;
    }
    scene->room = scene->contacts = t->contacts;
    scene->contact = room_for((size_t)t->contacts, sizeof(kern_contact));
    memcpy(scene->contact, t->contact,
           (size_t)t->contacts * sizeof(kern_contact));
}

static inline void scene_close(struct scene *scene)
{
    free(scene->contact);
    if (scene->is_file) {
        text_free(&scene->text);
        return;
    }
    free(scene->vertex);
    free(scene->block);
}

/* Whether a block carries none whose centre is higher. */
static inline int scene_is_top(const struct scene *scene, int block)
{
    int i;
    for (i = 0; i < scene->contacts; i++) {
        const kern_contact *c = &scene->contact[i];
        const int other = c->a == block ? c->b : c->b == block ? c->a : block;
        if (!scene->block[other].fixed
            && scene->block[other].centre.y > scene->block[block].centre.y)
            return 0;
    }
    return !scene->block[block].fixed;
}

/* Up to `most` blocks that carry nothing, the highest first. */
static inline int scene_tops(const struct scene *scene, int *top, int most)
{
    int n, i, k;
    for (n = 0; n < most; n++) {
        top[n] = -1;
        for (i = 0; i < scene->blocks; i++) {
            for (k = 0; k < n && top[k] != i; k++)
                ;
            if (k == n && scene_is_top(scene, i)
                && (top[n] < 0
                    || scene->block[i].centre.y
                           > scene->block[top[n]].centre.y))
                top[n] = i;
        }
        if (top[n] < 0)
            break;
    }
    return n;
}

/* The structure as a text that examples/kern.c reads. */
static inline void scene_print(const struct scene *scene)
{
    int i, k;
    printf("friction %.17g\ngravity 0 -9.81\n", MU);
    for (i = 0; i < scene->blocks; i++) {
        const kern_block *b = &scene->block[i];
        if (b->fixed)
            printf("fixed b%d", i);
        else
            printf("block b%d %.17g", i, b->mass);
        for (k = 0; k < b->vertices; k++)
            printf(" %.17g %.17g", b->vertex[k].x, b->vertex[k].y);
        printf("\n");
    }
}

/* ---- Lists of files ------------------------------------------------------ */

/* The next path of a list, a line each; 0: there is none. */
static inline int list_next(FILE *list, char *path, int room)
{
    while (fgets(path, room, list)) {
        path[strcspn(path, "\r\n")] = 0;
        if (path[0] && path[0] != '#')
            return 1;
    }
    return 0;
}

static inline FILE *list_open(const char *name)
{
    FILE *list = fopen(name, "r");
    if (!list) {
        fprintf(stderr, "%s: ", name);
        give_up("cannot be read");
    }
    return list;
}

#endif
