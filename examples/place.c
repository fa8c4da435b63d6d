/* Where on a wall should the next stone go?

       cc -O2 -o place examples/place.c -lm
       ./place place.svg examples/structures/wall-60.kern

   A stone is let down at many places, from left to right: kern_rest() finds
   where it comes to rest there, kern_plan_try() the margin of the wall with it,
   and kern_plan_stays() the chance that it stays when it is let go; the plan of
   the wall stays as it is. kern_place_compare() ranks the places, each by the
   worst of what is within an error to both sides, since a hand is not exact.
   Without arguments the wall is the one below: a slab reaches out far to the
   left, and the stone holds it down or tips it, or lies elsewhere and makes no
   difference. The first argument is a file for a picture (- for none), the
   second a wall made of polygons, the third a file with one block: the stone.
   Times go to stderr. */

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

enum { CORNERS = 5, MOST = 64, PLACES = 240, ROWS = 24 };

#define ERROR 0.1 /* of a place, in sizes of the stone */

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
    kern_status rests;  /* what kern_rest() said                      */
    kern_vec at, turn;  /* there: centre of mass; cosine, sine        */
    kern_status status; /* of the wall with the stone                 */
    kern_margin m;
    kern_place rank; /* x where it is let down; what it is worth   */
};

struct wall {
    struct text_file file, stone_file;
    kern_plan plan;
    kern_work work;
    kern_vec outline[CORNERS]; /* of the stone, if no file has it    */
    kern_block stone;          /* as it was given                    */
    kern_vec corner[MOST];     /* of the stone at rest               */
    kern_pose pose;
    kern_margin alone;
    struct place place[PLACES];
    double error; /* of a place                                    */
    int best;     /* place, -1: none                               */
};

/* ---- the wall, and every place on it ------------------------------------ */

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "place: %s: %s\n", what, why);
    return -1;
}

/* As heavy for its size as the last block, and somewhat smaller; or the block
   of a file. */
static int make_stone(struct wall *w, const char *path)
{
    const kern_block *last = &w->file.block[w->file.blocks - 1];
    double size = 0.6 * kern_mean_size(w->file.block, w->file.blocks);
    int i;

    if (path && text_load(&w->stone_file, path))
        return complain(path, w->stone_file.message);
    if (path
        && (w->stone_file.blocks != 1
            || w->stone_file.block[0].vertices > MOST))
        return complain(path, "not one block of up to 64 vertices");
    if (path) {
        w->stone = w->stone_file.block[0];
        return 0;
    }
    for (i = 0; i < CORNERS; i++) {
        w->outline[i].x = size * outline[i][0];
        w->outline[i].y = size * outline[i][1];
    }
    return kern_block_init(&w->stone, w->outline, CORNERS,
                           last->fixed ? 1 : last->mass / fabs(last->area),
                           NULL);
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
            return complain(w->file.name[i], kern_status_text(found));
    }
    return 0;
}

static int open_wall(struct wall *w, const char *path, const char *stone)
{
    const char *name = path ? path : "the built-in wall";
    kern_status status;

    if (path ? text_load(&w->file, path)
             : text_read(&w->file, built_in, sizeof built_in - 1))
        return complain(name, w->file.message);
    if (w->file.given)
        return complain(name, "contacts are given, so none can be found");
    if (make_stone(w, stone) || plan_wall(w))
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
    text_free(&w->stone_file);
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

/* What place i is worth: the least of what is as far to both sides as the
   error. Returns 0 where the wall falls there, or the stone is not held. */
static int rank_place(const struct wall *w, int i, kern_place *rank)
{
    int k;

    *rank = w->place[i].rank;
    for (k = 0; k < PLACES; k++) {
        const struct place *p = &w->place[k];

        if (fabs(p->rank.x - rank->x) > w->error)
            continue;
        if (p->status != KERN_STANDS)
            return 0;
        rank->margin = fmin(rank->margin, p->rank.margin);
        rank->stays = fmin(rank->stays, p->rank.stays);
    }
    return 1;
}

static void find_best(struct wall *w)
{
    kern_place best, rank;
    int i;

    w->best = -1;
    for (i = 0; i < PLACES; i++)
        if (rank_place(w, i, &rank)
            && (w->best < 0
                || kern_place_compare(&rank, &best, w->alone.margin) > 0)) {
            w->best = i;
            best = rank;
        }
}

/* Lets the stone down at a place. */
static void put_stone(struct wall *w, struct place *p)
{
    const kern_vec upright = {1, 0};

    p->rests = kern_rest(&w->plan.task, &w->stone, p->rank.x, upright,
                         w->corner, &w->pose);
}

static void try_place(struct wall *w, struct place *p)
{
    put_stone(w, p);
    p->status = p->rests;
    if (p->rests != KERN_OK)
        return;
    p->at = w->pose.block.centre;
    p->turn = w->pose.turn;
    p->status = kern_plan_try(&w->plan, &w->pose.block, &p->m, NULL);
    if (p->status != KERN_STANDS)
        return;
    p->rank.margin = p->m.margin;
    kern_plan_stays(&w->plan, &w->pose.block, &p->rank.stays);
}

static void try_places(struct wall *w)
{
    struct draw_view v;
    clock_t from = clock();
    int i, tried = 0;

    view_wall(w, &v);
    w->error = ERROR * sqrt(fabs(w->stone.area));
    for (i = 0; i < PLACES; i++) {
        struct place *p = &w->place[i];

        p->rank.x = v.low.x + (v.high.x - v.low.x) * (i + 0.5) / PLACES;
        try_place(w, p);
        tried += p->rests == KERN_OK;
    }
    find_best(w);
    fprintf(stderr, "%d stones and one more: %d places tried, %.0f a second\n",
            w->file.blocks - w->file.fixed, tried,
            tried / ((double)(clock() - from + 1) / CLOCKS_PER_SEC));
}

static void print_place(const struct place *p)
{
    printf("%6.2f  ", p->rank.x);
    if (p->rests != KERN_OK) {
        printf("%s\n", kern_status_text(p->rests));
        return;
    }
    printf("%6.2f  %5.2f  %6.1f  ", p->at.x, p->at.y,
           atan2(p->turn.y, p->turn.x) * 180 / 3.14159265);
    if (p->status == KERN_STANDS)
        printf("%5d  %.3f   %.2f\n", p->m.level, p->m.margin, p->rank.stays);
    else if (p->status == KERN_FALLS)
        printf("falls\n");
    else
        printf("%s\n", kern_status_text(p->status));
}

static void print_table(const struct wall *w)
{
    kern_place rank;
    int i;

    printf("without the stone: level %d, margin %.3f\n\n", w->alone.level,
           w->alone.margin);
    printf("let down  x      y  turned  level  margin  stays\n");
    for (i = PLACES / ROWS / 2; i < PLACES; i += PLACES / ROWS)
        print_place(&w->place[i]);
    if (w->best >= 0) {
        rank_place(w, w->best, &rank);
        printf("\nbest of all %d places, with an error of %.2f to both "
               "sides:\n",
               PLACES, w->error);
        print_place(&w->place[w->best]);
        printf("there at least              %.3f   %.2f\n", rank.margin,
               rank.stays);
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
        double x = draw_place(v, p->rank.x, 0).x;

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
        draw_block(v, &w->pose.block, NULL, 0, "fill=\"" DRAW_WHOLE "\"");
    }
    draw_close(v->out);
    if (w->best >= 0)
        draw_line(
            v->out,
            draw_place(v, w->pose.block.centre.x, w->pose.block.box.high.y),
            draw_vec(draw_place(v, w->place[w->best].rank.x, 0).x,
                     plot_y(w->place[w->best].m.margin, most)),
            "stroke=\"" DRAW_KERN "\" stroke-width=\"0.9\" "
            "stroke-dasharray=\"2 3\"");
}

static int draw_margins(struct wall *w, const char *path)
{
    FILE *out = fopen(path, "w");
    struct draw_view v;
    double most = w->alone.margin, bottom, high;
    kern_place rank = {0, 0, 0, 0, 0, 0};
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
    if (w->best >= 0)
        rank_place(w, w->best, &rank);
    snprintf(text, sizeof text,
             "Margin of the wall with one more stone, over "
             "its place.\nOrange: the wall without it, %.3g. Red: the "
             "wall falls.\nThe stone is drawn in its best place: %.3g, and "
             "%.3g at least if it comes to lie %.2g to either side.",
             w->alone.margin, w->best < 0 ? 0 : w->place[w->best].m.margin,
             rank.margin, w->error);
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

    if (argc > 4 || (strcmp(svg, "-") != 0 && !args_is_svg(svg))) {
        puts("usage: place [OUT.svg | - [WALL.kern [STONE.kern]]]\n"
             "The margin of a wall over the place of one more stone.");
        return strcmp(svg, "--help") == 0 || strcmp(svg, "-h") == 0 ? 0 : 2;
    }
    bad = open_wall(&w, argc > 2 ? argv[2] : NULL, argc > 3 ? argv[3] : NULL);
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

let down  x      y  turned  level  margin  stays
 -0.74   -0.70   0.16     3.6      8  0.100   1.00
 -0.46   -0.47   1.96     3.6  falls
 -0.17   -0.18   1.96     3.6  falls
  0.12    0.11   1.96     3.6      3  0.033   1.00
  0.41    0.40   1.96     3.6      8  0.099   1.00
  0.69    0.68   1.96     3.6     12  0.165   1.00
  0.98    0.97   1.96     3.6     16  0.221   1.00
  1.27    1.26   1.96     3.6      3  0.041   1.00
  1.56    1.68   1.65   -22.8      8  0.100   1.00
  1.85    1.87   1.61    -9.0      8  0.100   1.00
  2.13    2.12   1.56     3.6      8  0.100   1.00
  2.42    2.25   1.65    96.5      8  0.100   1.00
  2.71    2.73   2.07    -8.5      8  0.100   1.00
  3.00    3.01   2.01    -8.5      8  0.100   1.00
  3.28    3.36   1.68   -86.4      8  0.100   1.00
  3.57    3.56   1.56     3.6      8  0.100   1.00
  3.86    3.81   1.62    17.9      8  0.100   1.00
  4.15    3.68   1.58   172.1      8  0.100   1.00
  4.43    4.42   2.26     3.6      8  0.100   1.00
  4.72    4.86   1.78   -86.4      8  0.100   1.00
  5.01    5.77   0.28   -84.2      8  0.100   1.00
  5.30    5.29   1.16     3.6      8  0.100   1.00
  5.59    5.57   0.77   -84.2      8  0.100   1.00
  5.87    5.86   0.16     3.6      8  0.100   1.00

best of all 240 places, with an error of 0.04 to both sides:
  0.98    0.97   1.96     3.6     16  0.221   1.00
there at least              0.221   1.00
*/
