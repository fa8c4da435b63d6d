/* Where on a wall should the next stone go?

       cc -O2 -o place examples/place.c -lm
       ./place place.svg examples/structures/wall-60.kern

   A stone is let down at many places, from left to right, and turns until it
   rests. kern_plan_try() gives the margin of the wall with the stone there; the
   plan of the wall stays as it is. The best place is the one that is good also a
   little beside it, since a hand is not exact; kern_plan_stays() gives the
   chance that the stone stays there when it is let go. Without arguments the wall is the
   one below: a slab reaches out far to the left, and the stone holds it down or
   tips it, or lies elsewhere and makes no difference. The first argument is a
   file for a picture (- for none), the second a wall made of polygons. Times
   go to stderr. */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "parts/args.h"
#include "parts/draw.h"
#include "parts/room.h"
#include "parts/text.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { CORNERS = 5, PLACES = 240, ROWS = 24 };

#define LEANING 0.6 /* most a stone turns, rad */
#define ERROR 0.1   /* of a place, in sizes of the stone */

static const char built_in[] =
    "density 2400\n"
    "fixed ground  -1 -0.3  6.4 -0.3  6.4 0  -1 0\n"
    "block a *  0 0      1 0      1 0.5      0 0.5\n"
    "block b *  1 0      2.1 0    2.1 0.5    1 0.5\n"
    "block c *  3.5 0    4.6 0    4.6 0.5    3.5 0.5\n"
    "block d *  4.6 0    5.6 0    5.6 0.5    4.6 0.5\n"
    "block e *  0.1 0.5  1.4 0.5  1.4 1      0.1 1\n"
    "block f *  1.4 0.5  2.2 0.5  2.2 1      1.4 1\n"
    "block g *  3.4 0.5  4.2 0.5  4.2 1      3.4 1\n"
    "block h *  4.2 0.5  5.4 0.5  5.4 1      4.2 1\n"
    "block i *  0.3 1    1.6 1    1.6 1.5    0.3 1.5\n"
    "block j *  1.7 1    3.9 1    3.9 1.4    1.7 1.4\n"
    "block k *  4 1      5 1      5 1.5      4 1.5\n"
    "block slab *  -0.5 1.5  1.3 1.5  1.3 1.8  -0.5 1.8\n"
    "block l *  2.5 1.4  3.2 1.4  3.2 1.8    2.5 1.95\n"
    "block m *  4.2 1.5  4.7 1.5  4.7 2.1    4.2 2.1\n";

/* Of size 1 or so; no two sides are parallel. */
static const double outline[CORNERS][2] = {
    {-0.6, -0.35}, {0.5, -0.42}, {0.68, 0.1}, {0.2, 0.45}, {-0.52, 0.35},
};

struct place {
    double x, y, turn; /* of the centre of mass                          */
    kern_status status;
    kern_margin m;
};

struct wall {
    struct text_file file;
    kern_plan plan;
    kern_work work;
    kern_vec shape[CORNERS]; /* of the stone, about its centre                */
    kern_vec corner[CORNERS]; /* where it is                                  */
    kern_block stone;
    double density;
    kern_margin alone;
    struct place place[PLACES];
    double error; /* of a place                                    */
    int best;     /* place, -1: none                               */
    double stays; /* the chance that it stays there, NAN: unknown  */
};

/* ---- where a stone rests ------------------------------------------------ */

/* The height of edge pq at x, if it is that far; else far below. */
static double height_at(kern_vec p, kern_vec q, double x)
{
    if ((p.x < x) == (q.x < x))
        return -HUGE_VAL;
    return p.y + (q.y - p.y) * (x - p.x) / (q.x - p.x);
}

static void turn_stone(struct wall *w, double turn)
{
    double c = cos(turn), s = sin(turn);
    int i;

    for (i = 0; i < CORNERS; i++) {
        w->corner[i].x = c * w->shape[i].x - s * w->shape[i].y;
        w->corner[i].y = s * w->shape[i].x + c * w->shape[i].y;
    }
}

/* How high the centre of the stone is where it comes down at x: a corner of
   it meets an edge, or an edge of it a corner. */
static double rest_height(struct wall *w, double x, double turn)
{
    const kern_structure *s = &w->plan.task.s;
    double top = -HUGE_VAL;
    int b, i, k;

    turn_stone(w, turn);
    for (b = 0; b < s->blocks; b++) {
        const kern_block *block = &s->block[b];

        if (block->box.low.x > x + 1.5 * sqrt(fabs(w->stone.area))
            || block->box.high.x < x - 1.5 * sqrt(fabs(w->stone.area)))
            continue;
        for (k = 0; k < block->vertices; k++) {
            kern_vec p = block->vertex[k];
            kern_vec q = block->vertex[k + 1 < block->vertices ? k + 1 : 0];

            for (i = 0; i < CORNERS; i++) {
                kern_vec u = w->corner[i], v = w->corner[(i + 1) % CORNERS];
                double under = height_at(u, v, p.x - x);

                top = fmax(top, height_at(p, q, x + u.x) - u.y);
                if (under > -HUGE_VAL)
                    top = fmax(top, p.y - under);
            }
        }
    }
    return top;
}

/* The stone turns, its centre always above x, until that is as low as it gets:
   then something supports it on either side. */
static void lower_stone(struct wall *w, struct place *place)
{
    const double ratio = 0.6180339887498949;
    double step = 0.01, at = 0, y = rest_height(w, place->x, 0), low, high;

    if (rest_height(w, place->x, -step) < y)
        step = -step;
    while (fabs(at) < LEANING && rest_height(w, place->x, at + step) < y)
        y = rest_height(w, place->x, at += step);
    for (low = at - fabs(step), high = at + fabs(step); high - low > 1e-10;) {
        double a = high - ratio * (high - low), b = low + ratio * (high - low);

        if (rest_height(w, place->x, a) < rest_height(w, place->x, b))
            high = b;
        else
            low = a;
    }
    place->turn = (low + high) / 2;
    place->y = rest_height(w, place->x, place->turn);
}

static void put_stone(struct wall *w, const struct place *place)
{
    int i;

    turn_stone(w, place->turn);
    for (i = 0; i < CORNERS; i++) {
        w->corner[i].x += place->x;
        w->corner[i].y += place->y;
    }
    kern_block_init(&w->stone, w->corner, CORNERS, w->density, NULL);
}

/* ---- the wall, and every place on it ------------------------------------ */

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "place: %s: %s\n", what, why);
    return -1;
}

/* As heavy for its size as the last block, and somewhat smaller. */
static void make_stone(struct wall *w)
{
    const kern_block *last = &w->file.block[w->file.blocks - 1];
    double size = 0.6 * kern_mean_size(w->file.block, w->file.blocks);
    int i;

    w->density = last->fixed ? 1 : last->mass / fabs(last->area);
    for (i = 0; i < CORNERS; i++) {
        w->shape[i].x = size * outline[i][0];
        w->shape[i].y = size * outline[i][1];
    }
    kern_block_init(&w->stone, w->shape, CORNERS, w->density, NULL);
    for (i = 0; i < CORNERS; i++) {
        w->shape[i].x -= w->stone.centre.x;
        w->shape[i].y -= w->stone.centre.y;
    }
}

static int plan_wall(struct wall *w)
{
    int blocks = w->file.blocks + 1, i;

    w->plan = room_plan(blocks, 32 * blocks, &w->work);
    if (!room_is_there(&w->plan))
        return complain("memory", strerror(errno));
    w->plan.task.options = w->file.options;
    w->plan.task.s.gravity = w->file.gravity;
    for (i = 0; i < w->file.blocks; i++) {
        int found = kern_plan_add(&w->plan, &w->file.block[i]);

        if (found < 0)
            return complain(w->file.name[i],
                            kern_status_text((kern_status)found));
    }
    return 0;
}

static int open_wall(struct wall *w, const char *path)
{
    const char *name = path ? path : "the built-in wall";
    kern_status status;

    if (path ? text_load(&w->file, path)
             : text_read(&w->file, built_in, sizeof built_in - 1))
        return complain(name, w->file.message);
    if (w->file.given)
        return complain(name, "contacts are given, so none can be found");
    make_stone(w);
    if (plan_wall(w))
        return -1;
    status = kern_measure(&w->plan.task, &w->alone, NULL);
    if (status != KERN_STANDS)
        return complain("the wall without the stone", kern_status_text(status));
    return 0;
}

static void close_wall(struct wall *w)
{
    room_free_plan(&w->plan);
    text_free(&w->file);
}

/* What the picture shows: all that is free, and room for the stone. */
static void view_wall(const struct wall *w, struct draw_view *v)
{
    const kern_structure *s = &w->plan.task.s;
    double size = sqrt(fabs(w->stone.area));
    int i;

    v->low = draw_vec(HUGE_VAL, HUGE_VAL);
    v->high = draw_vec(-HUGE_VAL, -HUGE_VAL);
    for (i = 0; i < s->blocks; i++)
        if (!s->block[i].fixed) {
            draw_widen(v, s->block[i].box.low.x, s->block[i].box.low.y);
            draw_widen(v, s->block[i].box.high.x, s->block[i].box.high.y);
        }
    draw_widen(v, v->low.x - size, v->low.y - size / 2);
    draw_widen(v, v->high.x + size, v->high.y + 1.4 * size);
}

/* The least margin at place i and as far to both sides as the error; below 0
   where it does not stand there. */
static double sure_margin(const struct wall *w, int i)
{
    double least = HUGE_VAL;
    int k;

    for (k = 0; k < PLACES; k++) {
        const struct place *p = &w->place[k];

        if (fabs(p->x - w->place[i].x) <= w->error)
            least = fmin(least, p->status == KERN_STANDS ? p->m.margin : -1);
    }
    return least;
}

static void find_best(struct wall *w)
{
    int i;

    w->best = -1;
    for (i = 0; i < PLACES; i++) { /* of equal ones the first */
        double sure = sure_margin(w, i);

        if (sure >= 0 && (w->best < 0 || sure > sure_margin(w, w->best) + 1e-6))
            w->best = i;
    }
}

/* The chance that the stone stays in the best place. */
static void find_stays(struct wall *w)
{
    w->stays = (double)NAN;
    if (w->best < 0)
        return;
    put_stone(w, &w->place[w->best]);
    kern_plan_stays(&w->plan, &w->stone, &w->stays);
}

static void try_places(struct wall *w)
{
    struct draw_view v;
    clock_t from, spent = 0;
    int i, tried = 0;

    view_wall(w, &v);
    w->error = ERROR * sqrt(fabs(w->stone.area));
    for (i = 0; i < PLACES; i++) {
        struct place *p = &w->place[i];

        p->x = v.low.x + (v.high.x - v.low.x) * (i + 0.5) / PLACES;
        p->status = KERN_UNDECIDED;
        lower_stone(w, p);
        if (!(p->y > -HUGE_VAL)) /* nothing is under it */
            continue;
        put_stone(w, p);
        from = clock();
        p->status = kern_plan_try(&w->plan, &w->stone, &p->m, NULL);
        spent += clock() - from;
        tried++;
    }
    find_best(w);
    find_stays(w);
    fprintf(stderr, "%d stones and one more: %d places tried, %.0f a second\n",
            w->file.blocks - w->file.fixed, tried,
            tried / ((double)(spent + 1) / CLOCKS_PER_SEC));
}

static void print_place(const struct place *p)
{
    if (!(p->y > -HUGE_VAL)) {
        printf("%6.2f  nothing is under it\n", p->x);
        return;
    }
    printf("%6.2f  %5.2f  %6.1f  ", p->x, p->y, p->turn * 180 / 3.14159265);
    if (p->status == KERN_STANDS)
        printf("%5d  %.3f\n", p->m.level, p->m.margin);
    else if (p->status == KERN_FALLS)
        printf("falls\n");
    else
        printf("%s\n", kern_status_text(p->status));
}

static void print_table(const struct wall *w)
{
    int i;

    printf("without the stone: level %d, margin %.3f\n\n", w->alone.level,
           w->alone.margin);
    printf("     x      y  turned  level  margin\n");
    for (i = PLACES / ROWS / 2; i < PLACES; i += PLACES / ROWS)
        print_place(&w->place[i]);
    if (w->best >= 0) {
        printf("\nbest of all %d places, with an error of %.2f to both "
               "sides:\n",
               PLACES, w->error);
        print_place(&w->place[w->best]);
        printf("there at least  %.3f; it stays with a chance of %.2f\n",
               sure_margin(w, w->best), w->stays);
    }
}

/* ---- the picture: the margin over the place, and the wall below --------- */

#define WIDE 760.0 /* the page                                           */
#define LEFT 74.0  /* of both drawings                                   */
#define PLOT_TOP 24.0
#define PLOT_HIGH 190.0
#define FALLS_HIGH 22.0 /* a strip for the places where it falls              */
#define GAP 26.0
#define BELOW 62.0 /* of the drawings: the paragraph                     */

static double plot_y(double margin, double most)
{
    return PLOT_TOP + PLOT_HIGH * (1 - margin / most);
}

static void draw_label(FILE *out, double x, double y, const char *anchor,
                       const char *text)
{
    draw_text(out, x, y, 12, anchor, text, strlen(text));
}

static void draw_number(FILE *out, double x, double y, const char *anchor,
                        double number)
{
    char text[40];

    snprintf(text, sizeof text, "%g", number);
    draw_label(out, x, y, anchor, text);
}

/* Lines and numbers of both axes. */
static void draw_axes(const struct draw_view *v, double most, double bottom)
{
    const double right = draw_place(v, v->high.x, 0).x;
    double step = draw_round(most / 3), m, x, y;

    for (m = 0; m <= most * 1.001; m += step) {
        y = plot_y(m, most);
        draw_line(v->out, draw_vec(LEFT, y), draw_vec(right, y),
                  "stroke=\"#dcd7cd\" stroke-width=\"0.8\"");
        draw_number(v->out, LEFT - 8, y + 4, "end", m);
    }
    draw_label(v->out, LEFT - 8, PLOT_TOP + PLOT_HIGH + FALLS_HIGH - 3, "end",
               "falls");
    step = draw_round((v->high.x - v->low.x) / 5);
    for (m = ceil(v->low.x / step); m * step <= v->high.x; m++) {
        x = draw_place(v, m * step, 0).x;
        draw_line(v->out, draw_vec(x, bottom), draw_vec(x, bottom + 5),
                  "stroke=\"" DRAW_EDGE "\" stroke-width=\"0.8\"");
        draw_number(v->out, x, bottom + 19, "middle", m * step + 0.0);
    }
    draw_label(v->out, (LEFT + right) / 2, bottom + 38, "middle",
               "place of the stone, in units of length");
    fprintf(v->out, "<g transform=\"translate(18 %.2f) rotate(-90)\">\n",
            PLOT_TOP + PLOT_HIGH / 2);
    draw_label(v->out, 0, 0, "middle", "margin, in units of length");
    draw_close(v->out);
}

static void draw_places(const struct wall *w, const struct draw_view *v,
                        double most)
{
    const double alone = plot_y(w->alone.margin, most);
    const double under = PLOT_TOP + PLOT_HIGH + FALLS_HIGH - 7;
    int i;

    draw_line(v->out, draw_vec(LEFT, alone),
              draw_vec(draw_place(v, v->high.x, 0).x, alone),
              "stroke=\"" DRAW_LIMIT "\" stroke-width=\"1.4\" "
              "stroke-dasharray=\"6 4\"");
    for (i = 0; i < PLACES; i++) {
        const struct place *p = &w->place[i];
        double x = draw_place(v, p->x, 0).x;

        if (p->status == KERN_STANDS)
            draw_circle(v->out, draw_vec(x, plot_y(p->m.margin, most)),
                        i == w->best ? 4.5 : 1.9, "fill=\"" DRAW_KERN "\"");
        else if (p->status == KERN_FALLS)
            draw_circle(v->out, draw_vec(x, under), 1.9,
                        "fill=\"" DRAW_FORCE "\"");
    }
}

/* The wall, and the stone in the best place, which a line joins to its dot. */
static void draw_wall(struct wall *w, const struct draw_view *v, double most)
{
    const kern_structure *s = &w->plan.task.s;
    int i;

    draw_open(v->out, "stroke=\"" DRAW_EDGE "\" stroke-width=\"0.9\" "
                      "stroke-linejoin=\"round\" clip-path=\"url(#view)\"");
    for (i = 0; i < s->blocks; i++)
        draw_block(v, &s->block[i], NULL, 0,
                   s->block[i].fixed ? "fill=\"#c9c2b4\"" : "fill=\"#e9e3d6\"");
    if (w->best >= 0) {
        put_stone(w, &w->place[w->best]);
        draw_block(v, &w->stone, NULL, 0, "fill=\"" DRAW_WHOLE "\"");
    }
    draw_close(v->out);
    if (w->best >= 0)
        draw_line(v->out, draw_place(v, w->stone.centre.x, w->stone.box.high.y),
                  draw_vec(draw_place(v, w->stone.centre.x, 0).x,
                           plot_y(w->place[w->best].m.margin, most)),
                  "stroke=\"" DRAW_KERN "\" stroke-width=\"0.9\" "
                  "stroke-dasharray=\"2 3\"");
}

static int draw_margins(struct wall *w, const char *path)
{
    FILE *out = fopen(path, "w");
    struct draw_view v;
    double most = w->alone.margin, bottom, high;
    char text[400];
    int i, bad;

    if (!out)
        return complain(path, strerror(errno));
    v.out = out;
    view_wall(w, &v);
    v.left = LEFT;
    v.top = PLOT_TOP + PLOT_HIGH + FALLS_HIGH + GAP;
    v.scale = (WIDE - LEFT - DRAW_PAD) / (v.high.x - v.low.x);
    bottom = v.top + (v.high.y - v.low.y) * v.scale;
    for (i = 0; i < PLACES; i++)
        if (w->place[i].status == KERN_STANDS)
            most = fmax(most, w->place[i].m.margin);
    most *= 1.08;
    snprintf(text, sizeof text,
             "Margin of the wall with one more stone, over "
             "its place.\nOrange: the wall without it, %.3g. Red: the "
             "wall falls.\nThe stone is drawn in its best place: %.3g, and "
             "%.3g at least if it comes to lie %.2g to either side.",
             w->alone.margin, w->best < 0 ? 0 : w->place[w->best].m.margin,
             w->best < 0 ? 0 : sure_margin(w, w->best), w->error);
    high = draw_paragraph(NULL, LEFT, bottom + BELOW, WIDE, 12.5, text);
    draw_begin(out, WIDE, ceil(high));
    fprintf(out,
            "<clipPath id=\"view\"><rect x=\"%.2f\" y=\"%.2f\" "
            "width=\"%.2f\" height=\"%.2f\"/></clipPath>\n",
            v.left, v.top, (v.high.x - v.low.x) * v.scale, bottom - v.top);
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    draw_axes(&v, most, bottom);
    draw_paragraph(out, LEFT, bottom + BELOW, WIDE, 12.5, text);
    draw_close(out);
    draw_wall(w, &v, most);
    draw_places(w, &v, most);
    bad = draw_end(out);
    bad |= fclose(out);
    return bad ? complain(path, "cannot be written") : 0;
}

int main(int argc, char **argv)
{
    static struct wall w;
    const char *svg = argc > 1 ? argv[1] : "-";
    int bad;

    if (argc > 3 || (strcmp(svg, "-") != 0 && !args_is_svg(svg))) {
        puts("usage: place [OUT.svg | - [WALL.kern]]\n"
             "The margin of a wall over the place of one more stone.");
        return strcmp(svg, "--help") == 0 || strcmp(svg, "-h") == 0 ? 0 : 2;
    }
    bad = open_wall(&w, argc > 2 ? argv[2] : NULL);
    if (!bad) {
        try_places(&w);
        print_table(&w);
        if (strcmp(svg, "-") != 0)
            bad = draw_margins(&w, svg);
    }
    close_wall(&w);
    return bad ? 1 : 0;
}

/* Output:
without the stone: level 7, margin 0.100

     x      y  turned  level  margin
 -0.74   1.88     1.3  falls
 -0.46   1.96     3.6  falls
 -0.17   1.96     3.6  falls
  0.12   1.96     3.6      3  0.035
  0.41   1.96     3.6      8  0.102
  0.69   1.96     3.6     13  0.168
  0.98   1.96     3.6     16  0.221
  1.27   1.96     3.6      3  0.030
  1.56   1.80   -35.0  falls
  1.85   1.61    -9.7      8  0.100
  2.13   1.56     3.6      8  0.100
  2.42   2.09    32.6  falls
  2.71   2.07    -8.5      8  0.100
  3.00   2.01    -8.5      8  0.100
  3.28   1.94   -27.0  falls
  3.57   1.56     3.6      8  0.100
  3.86   1.63    20.1      8  0.100
  4.15   2.26    22.5  falls
  4.43   2.26     3.6      8  0.100
  4.72   2.26    -4.1  falls
  5.01   1.66     0.2  falls
  5.30   1.16     3.6      8  0.100
  5.59   1.06   -35.0  falls
  5.87   0.16     3.6      8  0.100

best of all 240 places, with an error of 0.04 to both sides:
  0.95   1.96     3.6     16  0.221
there at least  0.221; it stays with a chance of 1.00
*/
