/* How hard may each stone be pushed, and which way?

       cc -O2 -o push examples/push.c -lm
       ./push push.svg examples/structures/wall-60.kern

   A force acts at the centre of mass of one stone at a time, in one of 24
   directions, counter-clockwise from the right: kern_load_factor_of() finds the
   largest that the structure bears, and every smaller one, in weights of the
   stone. Without arguments the structure is the one below. The first argument
   is a file for a picture (- for none), the second a structure; with --json
   before them the output is one JSON object: weights, and the pushes of each
   stone, null where there is no bound or where it is undecided. */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "parts/args.h"
#include "parts/draw.h"
#include "parts/json.h"
#include "parts/room.h"
#include "parts/text.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIRECTIONS = 24, COLUMNS = 8 };

static const char built_in[] =
    "fixed ground  -1 -0.5  5 -0.5  5 0  -1 0\n"
    "block box    *  0 0      1 0    1 2    0 2\n"
    "block left   *  2 0      2.6 0  2.6 1  2 1\n"
    "block right  *  3.4 0    4 0    4 1    3.4 1\n"
    "block lintel *  1.8 1    4 1    4 1.4  1.8 1.4\n"
    "block top    *  2.8 1.4  3.6 1.4  3.6 2  2.8 2\n";

struct pushes {
    struct text_file file;
    kern_task task;
    kern_work work;
    kern_contact *contact;
    kern_wrench *pattern; /* one a block, 0 but where it is pushed        */
    double (*most)[DIRECTIONS]; /* of a block, in its weights; NAN: undecided */
    double median; /* of those that are bounded                    */
};

static double degrees(int direction) { return 360.0 * direction / DIRECTIONS; }

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "push: %s: %s\n", what, why);
    return -1;
}

/* A force of one weight on block i, toward a direction. */
static kern_wrench push_of(const struct pushes *p, int i, int direction)
{
    const kern_vec g = p->task.s.gravity;
    const double angle = degrees(direction) * 3.14159265358979323846 / 180;
    const double weight = p->task.s.block[i].mass * draw_hypot(g.x, g.y);
    kern_wrench w;

    w.fx = weight * cos(angle);
    w.fy = weight * sin(angle);
    w.torque = 0;
    return w;
}

static int find_pushes(struct pushes *p)
{
    const kern_wrench none = {0, 0, 0};
    const char *name;
    int i, k;

    for (i = 0; i < p->task.s.blocks; i++) {
        name = p->file.name[i];
        for (k = 0; k < DIRECTIONS && !p->task.s.block[i].fixed; k++) {
            kern_real most = 0;
            kern_status status;

            p->pattern[i] = push_of(p, i, k);
            status = kern_load_factor_of(&p->task, 0, p->pattern, &most, NULL);
            p->pattern[i] = none;
            if (status == KERN_FALLS)
                return complain(name, "the structure falls as it is");
            if (status < 0 && status != KERN_UNDECIDED)
                return complain(name, kern_status_text(status));
            p->most[i][k] = status == KERN_STANDS ? most : NAN;
        }
    }
    return 0;
}

/* Contacts, and memory for the task. */
static int open_task(struct pushes *p)
{
    struct text_file *t = &p->file;
    const int room = t->given ? t->contacts : 32 * t->blocks + 64;

    p->work = room_work(t->blocks, room);
    p->contact = malloc((size_t)room * sizeof *p->contact + 1);
    p->pattern = calloc((size_t)t->blocks, sizeof *p->pattern);
    p->most = calloc((size_t)t->blocks, sizeof *p->most);
    if (!p->work.real || !p->work.index || !p->contact || !p->pattern
        || !p->most)
        return complain("memory", strerror(errno));
    p->task = kern_task_of(t->block, t->blocks, p->contact, 0, &p->work);
    p->task.s.gravity = t->gravity;
    p->task.options = t->options;
    if (t->given) {
        p->task.s.contact = t->contact;
        p->task.s.contacts = t->contacts;
    } else {
        p->task.s.contacts = kern_contacts(t->block, t->blocks, &t->options,
                                           p->contact, room, &p->work);
    }
    return 0;
}

static int open_file(struct pushes *p, const char *path)
{
    if (path ? text_load(&p->file, path)
             : text_read(&p->file, built_in, sizeof built_in - 1))
        return complain(path ? path : "the built-in structure",
                        p->file.message);
    if (!(draw_hypot(p->file.gravity.x, p->file.gravity.y) > 0))
        return complain(path, "there is no gravity to measure a push by");
    return open_task(p);
}

static void close_file(struct pushes *p)
{
    room_free_work(&p->work);
    free(p->contact);
    free(p->pattern);
    free(p->most);
    text_free(&p->file);
}

/* ---- what it prints ----------------------------------------------------- */

static void print_table(const struct pushes *p)
{
    char name[TEXT_SHOW_ROOM];
    int i, k;

    printf("largest push, in weights of the stone, by direction in degrees\n\n"
           "%-10s",
           "stone");
    for (k = 0; k < COLUMNS; k++)
        printf(" %8g", degrees(k * DIRECTIONS / COLUMNS));
    printf("\n");
    for (i = 0; i < p->task.s.blocks; i++) {
        if (p->task.s.block[i].fixed)
            continue;
        printf("%-10s", text_show(name, p->file.name[i]));
        for (k = 0; k < COLUMNS; k++) {
            const double most = p->most[i][k * DIRECTIONS / COLUMNS];

            if (isfinite(most))
                printf(" %8.4f", most);
            else
                printf(" %8s", isnan(most) ? "?" : "any");
        }
        printf("\n");
    }
}

static void print_json(const struct pushes *p, const char *path)
{
    const kern_vec g = p->task.s.gravity;
    const char *comma = "", *between;
    int i, k;

    printf("{");
    json_string("file", path ? path : "");
    printf(", \"degrees\": [");
    for (k = 0; k < DIRECTIONS; k++)
        printf("%s%g", k > 0 ? ", " : "", degrees(k));
    printf("], \"blocks\": [");
    for (i = 0; i < p->task.s.blocks; i++) {
        if (p->task.s.block[i].fixed)
            continue;
        printf("%s{", comma);
        comma = ", ";
        json_string("block", p->file.name[i]);
        json_number("weight", p->task.s.block[i].mass * draw_hypot(g.x, g.y));
        printf(", \"push\": [");
        for (k = 0; k < DIRECTIONS; k++) {
            printf("%s", k > 0 ? ", " : "");
            json_value(p->most[i][k]);
        }
        printf("], \"undecided\": [");
        for (k = 0, between = ""; k < DIRECTIONS; k++)
            if (isnan(p->most[i][k])) {
                printf("%s%g", between, degrees(k));
                between = ", ";
            }
        printf("]}");
    }
    printf("]}\n");
}

/* ---- the picture: on each stone its pushes, around its centre ----------- */

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;

    return (x > y) - (x < y);
}

/* The median of all pushes that have a bound, in weights; 1: none has. */
static double median_push(const struct pushes *p)
{
    double *all = malloc((size_t)p->task.s.blocks * sizeof *p->most);
    double median;
    int i, k, n = 0;

    if (!all)
        return 1;
    for (i = 0; i < p->task.s.blocks; i++)
        for (k = 0; k < DIRECTIONS; k++)
            if (!p->task.s.block[i].fixed && p->most[i][k] > 0
                && !isinf(p->most[i][k]))
                all[n++] = p->most[i][k];
    qsort(all, (size_t)n, sizeof *all, ascending);
    median = n > 0 ? all[n / 2] : 1;
    free(all);
    return median;
}

/* A push of m weights is drawn m / (p->median + m) of the outer ring long: the
   median reaches the inner ring, at half of it, what has no bound the outer. */
static void draw_pushes(const struct draw_view *v, const void *data)
{
    const struct pushes *p = data;
    const double thin = draw_clamp(0.012 * v->scale, 0.5, 1.2);
    char style[120];
    int i, k;

    for (i = 0; i < p->task.s.blocks; i++) {
        const kern_block *b = &p->task.s.block[i];
        const double wide = b->box.high.x - b->box.low.x;
        const double high = b->box.high.y - b->box.low.y;
        const double size = fmin(sqrt(fabs(b->area)), fmin(wide, high));
        const double radius = 0.48 * size * v->scale;
        const struct draw_pt c = draw_place(v, b->centre.x, b->centre.y);

        if (b->fixed || !b->vertex)
            continue;
        snprintf(style, sizeof style,
                 "fill=\"none\" stroke=\"" DRAW_EDGE
                 "\" stroke-width=\"%.2f\" stroke-dasharray=\"2 2\"",
                 0.6 * thin);
        draw_circle(v->out, c, radius, style);
        draw_circle(v->out, c, radius / 2, style);
        fprintf(v->out, "<path d=\"");
        for (k = 0; k < DIRECTIONS; k++) {
            const double most = p->most[i][k];
            const double angle = degrees(k) * 3.14159265358979323846 / 180;
            const double r = isinf(most) ? radius
                           : isnan(most) ? 0
                                         : radius * most / (p->median + most);

            fprintf(v->out, "%c%.2f %.2f", k > 0 ? 'L' : 'M',
                    draw_px(c.x + r * cos(angle)),
                    draw_px(c.y - r * sin(angle)));
        }
        fprintf(v->out,
                "Z\" fill=\"" DRAW_KERN "\" fill-opacity=\"0.35\" "
                "stroke=\"" DRAW_KERN "\" stroke-width=\"%.2f\" "
                "stroke-linejoin=\"round\"/>\n",
                thin);
    }
}

static int draw(struct pushes *p, const char *path)
{
    struct draw_scene scene = {0};
    char caption[160];

    p->median = median_push(p);
    scene.s = &p->task.s;
    scene.limiting = -1;
    scene.over = draw_pushes;
    scene.data = p;
    snprintf(caption, sizeof caption,
             "The largest push at the centre of each stone, by direction.\n"
             "Inner ring: the median, %.3g weights of the stone. Outer ring: "
             "any push.",
             p->median);
    scene.caption = caption;
    return draw_file(path, &scene) ? complain(path, strerror(errno)) : 0;
}

int main(int argc, char **argv)
{
    static struct pushes p;
    const int json = argc > 1 && strcmp(argv[1], "--json") == 0;
    const char *svg = argc > 1 + json ? argv[1 + json] : "-";
    const char *path = argc > 2 + json ? argv[2 + json] : NULL;
    int bad;

    if (argc > 3 + json || (strcmp(svg, "-") != 0 && !args_is_svg(svg))) {
        puts("usage: push [--json] [OUT.svg | - [STRUCTURE.kern]]\n"
             "The largest push that each stone bears, by direction.");
        return strcmp(svg, "--help") == 0 || strcmp(svg, "-h") == 0 ? 0 : 2;
    }
    bad = open_file(&p, path) || find_pushes(&p);
    if (!bad && json)
        print_json(&p, path);
    else if (!bad)
        print_table(&p);
    if (!bad && strcmp(svg, "-") != 0)
        bad = draw(&p, svg);
    close_file(&p);
    return bad ? 1 : 0;
}

/* Output:
largest push, in weights of the stone, by direction in degrees

stone             0       45       90      135      180      225      270      315
box          0.4000   0.4041   1.0000   0.4041   0.4000   0.9428      any   0.9428
left         1.3067   1.3199   2.3255   1.3199   1.3067   3.0798      any   3.0798
right        1.3067   1.3199   2.3412   1.3199   1.3067   3.0798      any   3.0798
lintel       0.6182   0.6245   1.3967   0.6245   0.6182   1.4571      any   1.4571
top          0.4000   0.4041   1.0000   0.4041   0.4000   0.9428      any   0.9428
*/
