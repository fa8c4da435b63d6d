/* shake - at which strength of shaking does a dry-stacked structure collapse?

   Puts structures, in the text format of text.h, on a table that moves along
   a figure of eight, harder from level to level, and says how far the stones
   are displaced after each, and at which level the structure collapses.

       cc -O2 -ffp-contract=off -o shake examples/laboratory/shake.c -lm
       ./shake --film wall.svg examples/structures/wall-60.kern
       ./shake --help

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/args.h"
#include "../parts/draw.h"
#include "../parts/json.h"
#include "rigid.h"
#include "table.h"
#include "../parts/text.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { EXIT_DONE = 0, EXIT_BAD = 2, MOST_LEVELS = 1000, NAME_ROOM = 4096 };

struct settings {
    struct table_plan plan;
    int first, last; /* seeds                                   */
    int json;
    int show; /* level of the pictures, 0: collapse      */
    const char *svg, *film;
    char **file;
    int files;
};

static const char help[] =
    "usage: shake [options] FILE...\n"
    "Shakes structures, each time as they were built and harder from level to\n"
    "level, and says at which they collapse: the first after which the stones are\n"
    "displaced by more than a quarter of a stone in the mean. FILE is a structure\n"
    "(kern --help has the format); - is stdin.\n"
    "\n"
    "  -l, --levels A-B   shake at levels A to B; default 1-20; N: 1-N\n"
    "  -n, --repeat R     shake R times, each with a little noise in the places\n"
    "                     of the stones and another moment to begin; default 1\n"
    "      --seed S[-T]   of that noise, an integer; default 1. A range shakes with\n"
    "                     each, and reports of each\n"
    "      --unit U       length of a stone, in the units of the file; default 1\n"
    "      --json         one JSON object a file and seed, one line each\n"
    "      --svg OUT.svg  draw it before and after a level\n"
    "      --film OUT.svg the shaking of a level, an SVG that moves\n"
    "      --show L       the level which they show; default: that of collapse\n"
    "  -h, --help, --version\n"
    "\n"
    "With several files the pictures of each NAME.* are in OUT-NAME.svg.\n"
    "A level is 0.059 g of peak horizontal acceleration, 0.01 U of amplitude.\n"
    "A stone is displaced by what it moved on the base, in U, and half of its turn in\n"
    "rad, as the root of the sum of their squares.\n"
    "JSON: file, seed, stones, levels (first, last), repetitions; level of collapse\n"
    "and its standard deviation level_sd, where last + 1 means never; ads: mean\n"
    "displacement of the stones after each level; first: of each block the level\n"
    "after which it is displaced by a quarter of U; seconds of CPU time.\n"
    "Exit status: 0 done, 2 bad use or input.\n";

static time_t began; /* the file that is shaken */

/* Says what is going on where someone may be waiting. */
static void show_progress(const struct table *t, int repetition, int level)
{
    if (!ARGS_TERMINAL(2) || difftime(time(NULL), began) < 2)
        return;
    fprintf(stderr, "\rshake: %.40s, repetition %d of %d, level %d   ", t->file,
            repetition + 1, t->plan.repeat, level);
    fflush(stderr);
}

static void clear_progress(void)
{
    if (ARGS_TERMINAL(2))
        fprintf(stderr, "\r%*s\r", 90, "");
}

/* ---- Reports ------------------------------------------------------------- */

static const char *stone_name(const struct table *t, int stone)
{
    return t->text.name[t->source[stone]];
}

static void print_text(const struct table *t, const struct table_report *r)
{
    const struct table_plan *plan = &t->plan;
    char shown[TEXT_SHOW_ROOM];
    printf("%s: %d stones, seed %d\n", t->file, t->stones, (int)plan->seed);
    if (r->level > plan->last)
        printf("  does not collapse up to level %d\n", plan->last);
    else
        printf("  collapses at level %.4g", r->level);
    if (r->level <= plan->last && plan->repeat > 1)
        printf(" (standard deviation %.2g of %d)", r->level_sd, plan->repeat);
    if (r->level <= plan->last)
        putchar('\n');
    printf("  %.2f s to shake it\n  level  mean displacement\n", r->seconds);
    for (int l = plan->first; l <= plan->last; l++)
        printf("  %5d  %.4f\n", l, r->ads[l - plan->first]);
    printf("  stone  first displaced at level\n");
    for (int i = 0; i < t->stones; i++)
        if (r->first[i] > plan->last)
            printf("  %s  never\n", text_show(shown, stone_name(t, i)));
        else
            printf("  %s  %.4g\n", text_show(shown, stone_name(t, i)),
                   r->first[i]);
}

static void print_json(const struct table *t, const struct table_report *r)
{
    const struct table_plan *plan = &t->plan;
    printf("{");
    json_string("file", t->file);
    printf(", \"seed\": %d, \"stones\": %d, \"levels\": [%d, %d], "
           "\"repetitions\": %d, \"level\": %.6g, \"level_sd\": %.6g, "
           "\"ads\": [",
           (int)plan->seed, t->stones, plan->first, plan->last, plan->repeat,
           r->level, r->level_sd);
    for (int l = plan->first; l <= plan->last; l++)
        printf("%s%.9g", l > plan->first ? ", " : "", r->ads[l - plan->first]);
    printf("], \"first\": [");
    for (int i = 0; i < t->stones; i++) {
        printf("%s{", i > 0 ? ", " : "");
        json_string("block", stone_name(t, i));
        printf(", \"level\": %.6g}", r->first[i]);
    }
    printf("], \"seconds\": %.2f}\n", r->seconds);
}

/* ---- Pictures ------------------------------------------------------------ */

/* What both pictures show of the world: the room that the base may take. */
static void fit_view(const struct table *t, struct draw_view *v, double level,
                     double width, double height)
{
    const double margin = 0.25, fallen = 1.5; /* for what is beside the base */
    double sway = table_amplitude * level / 2;
    v->low = draw_vec(t->left - sway - fallen, t->bottom - margin);
    v->high = draw_vec(t->right + sway + fallen, t->top + sway / 2 + margin);
    v->scale = fmin(width / (v->high.x - v->low.x),
                    height / (v->high.y - v->low.y));
    v->scale = fmin(v->scale, DRAW_STONE);
}

static double view_width(const struct draw_view *v)
{
    return (v->high.x - v->low.x) * v->scale;
}

static double view_height(const struct draw_view *v)
{
    return (v->high.y - v->low.y) * v->scale;
}

/* Writes the outline of a block of the text, about its home, as a path in
   pixels. The end of the element is the caller's. */
static void put_outline(const struct table *t, const struct draw_view *v,
                        int source, int pose)
{
    const kern_block *b = &t->text.block[source];
    const double most = 4 * (t->right - t->left + t->top - t->bottom);
    fputs("<path d=\"", v->out);
    for (int k = 0; k < b->vertices; k++) {
        struct rigid_pt p = table_scaled(t, b->vertex[k]);
        /* Renderers do not like a ground as wide as the world. */
        double x = draw_clamp(p.x - t->home[pose].x, -most, most);
        double y = draw_clamp(p.y - t->home[pose].y, -most, most);
        fprintf(v->out, "%s%.2f %.2f", k ? "L" : "M", draw_px(x * v->scale),
                draw_px(-y * v->scale));
    }
    fputs("Z\"", v->out);
}

/* The base about its home, with the side stops. */
static void put_base(const struct table *t, const struct draw_view *v)
{
    static const char *const hatch = "fill=\"url(#ground)\" stroke=\"" DRAW_EDGE
                                     "\" stroke-width=\"1\"";
    for (int i = 0; i < t->text.blocks; i++) {
        if (!t->text.block[i].fixed)
            continue;
        put_outline(t, v, i, 0);
        fprintf(v->out, " %s/>\n", hatch);
    }
    for (int side = 0; side < 2; side++) {
        const double thick = table_stop_thick;
        double x = (t->stop[side].x - (side ? 0 : thick) - t->home[0].x);
        double y = t->stop[side].y - t->home[0].y;
        double height = t->stop[side].y - (t->bottom + table_ground_below);
        draw_rect(v->out, x * v->scale, -y * v->scale, thick * v->scale,
                  height * v->scale, hatch);
    }
}

static void put_ground(const struct table *t, const struct draw_view *v)
{
    struct draw_pt p = draw_place(v, v->low.x, t->bottom);
    draw_rect(v->out, p.x, p.y, view_width(v), v->top + view_height(v) - p.y,
              "fill=\"#d8d3c8\"");
    draw_line(v->out, p, draw_vec(p.x + view_width(v), p.y),
              "stroke=\"" DRAW_EDGE "\" stroke-width=\"1\"");
}

/* The colour of a stone: one of the usual, or that of what was displaced. */
static const char *stone_fill(int stone, int displaced)
{
    const int fills = (int)(sizeof draw_stone / sizeof draw_stone[0]);
    return displaced ? "#e2a37f" : draw_stone[stone % fills];
}

/* The name of a stone about its home, where the stone is wide enough. */
static void put_name(const struct table *t, const struct draw_view *v,
                     int stone)
{
    const double size = 9.5;
    const char *name = stone_name(t, stone);
    const kern_box *box = &t->text.block[t->source[stone]].box;
    double wide = (double)(box->high.x - box->low.x) / t->plan.unit;
    if (draw_text_width(name, strlen(name), size) < 0.8 * wide * v->scale)
        draw_text(v->out, 0, 0.34 * size, size, "middle", name, strlen(name));
}

static void put_stone(const struct table *t, const struct draw_view *v,
                      int stone, int displaced)
{
    put_outline(t, v, t->source[stone], stone + 1);
    fprintf(v->out,
            " fill=\"%s\" stroke=\"" DRAW_EDGE "\" stroke-width=\"1\" "
            "stroke-linejoin=\"round\"/>\n",
            stone_fill(stone, displaced));
    put_name(t, v, stone);
}

static void put_transform(const struct draw_view *v, struct table_pose p)
{
    struct draw_pt at = draw_place(v, p.x, p.y);
    fprintf(v->out, "<g transform=\"translate(%.2f %.2f) rotate(%.3f)\">\n",
            draw_px(at.x), draw_px(at.y), -p.angle * 180 / table_pi);
}

/* The scene, base and stones at these poses; NULL: as in the file. */
static void put_scene(const struct table *t, const struct draw_view *v,
                      const struct table_pose *pose)
{
    if (!pose)
        pose = t->home;
    put_ground(t, v);
    put_transform(v, pose[0]);
    put_base(t, v);
    draw_close(v->out);
    for (int i = 0; i < t->stones; i++) {
        put_transform(v, pose[i + 1]);
        put_stone(t, v, i,
                  pose != t->home && table_score(t, i) > table_threshold);
        draw_close(v->out);
    }
}

/* Hatching, and the window that the drawing is cut at, named by a number. */
static void put_window(const struct draw_view *v, int number)
{
    fprintf(v->out,
            "<defs>\n<clipPath id=\"view%d\"><rect x=\"%.2f\" "
            "y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/></clipPath>\n",
            number, v->left, v->top, draw_px(view_width(v)),
            draw_px(view_height(v)));
    if (number == 0)
        fputs("<pattern id=\"ground\" width=\"7\" height=\"7\" patternUnits="
              "\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
              "<rect width=\"7\" height=\"7\" fill=\"#f4f2ee\"/>"
              "<path d=\"M3.5 0V7\" stroke=\"#a59d90\" stroke-width=\"0.9\"/>"
              "</pattern>\n",
              v->out);
    fputs("</defs>\n", v->out);
}

/* What a level did, and with `legend` what the colour says. */
static void heading_of(const struct table *t, int level, int legend,
                       char out[200])
{
    snprintf(out, 200, "%slevel %d (%.2g g): mean displacement %.2f stones%s",
             legend ? "after " : "", level, 0.059 * level, table_mean_score(t),
             legend ? "; orange: above 0.25" : "");
}

static void put_heading(FILE *out, double x, double y, const char *text)
{
    draw_text(out, x, y, 12.5, "start", text, strlen(text));
}

static double heading_width(const char *text) /* a sixth more: fonts differ */
{
    return 7 * draw_text_width(text, strlen(text), 12.5) / 6;
}

/* Two drawings, before and after a level; above each other where the
   structure is wider than high. */
static int put_svg(FILE *out, const struct table *t, int level)
{
    const double head = 20, gap = 18;
    struct draw_view v;
    struct table_pose *after = malloc(((size_t)t->stones + 1) * sizeof *after);
    char text[2][200] = {"before"};
    double w, h;
    int below = t->right - t->left > t->top - t->bottom;
    if (!after)
        return -1;
    for (int i = 0; i <= t->stones; i++)
        after[i] = table_pose_of(t, i);
    v.out = out;
    fit_view(t, &v, level, below ? DRAW_WIDTH : DRAW_WIDTH / 2,
             below ? DRAW_HEIGHT / 2 : DRAW_HEIGHT);
    heading_of(t, level, 1, text[1]);
    w = fmax(view_width(&v), heading_width(text[1]));
    h = view_height(&v) + head;
    draw_begin(out, ceil((below ? w : 2 * w + gap) + 2 * DRAW_PAD),
               ceil((below ? 2 * h + gap : h) + 2 * DRAW_PAD));
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    for (int k = 0; k < 2; k++) {
        v.left = DRAW_PAD + (k && !below ? w + gap : 0);
        v.top = DRAW_PAD + head + (k && below ? h + gap : 0);
        put_window(&v, k);
        put_heading(out, v.left, v.top - 8, text[k]);
        draw_open(out, k ? "clip-path=\"url(#view1)\""
                         : "clip-path=\"url(#view0)\"");
        put_scene(t, &v, k ? after : NULL);
        draw_close(out);
    }
    draw_close(out);
    free(after);
    return draw_end(out);
}

/* Two nested groups: one moves with the poses of a film, one turns. */
static void put_motion(const struct draw_view *v, const struct table_film *f,
                       int i, int poses, double seconds)
{
    const struct table_pose *p = f->pose + i;
    struct draw_pt at = draw_place(v, p->x, p->y);
    fprintf(v->out,
            "<g transform=\"translate(%.2f %.2f)\">"
            "<animateTransform attributeName=\"transform\" type=\"translate\" "
            "dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"",
            draw_px(at.x), draw_px(at.y), seconds);
    for (int k = 0; k < f->frames; k++) {
        at = draw_place(v, p[k * poses].x, p[k * poses].y);
        fprintf(v->out, "%s%.4g %.4g", k ? ";" : "", draw_px(at.x),
                draw_px(at.y));
    }
    fprintf(v->out,
            "\"/>\n<g><animateTransform attributeName=\"transform\" "
            "type=\"rotate\" dur=\"%.2fs\" repeatCount=\"indefinite\" "
            "values=\"",
            seconds);
    for (int k = 0; k < f->frames; k++)
        fprintf(v->out, "%s%.4g", k ? ";" : "",
                draw_px(-p[k * poses].angle * 180 / table_pi));
    fputs("\"/>\n", v->out);
}

static int put_film(FILE *out, const struct table *t,
                    const struct table_film *f, int level)
{
    const double head = 20, foot = 14;
    int poses = t->stones + 1;
    double seconds = (f->frames - 1) * table_frame_every * t->world.step;
    struct draw_view v;
    char text[200];
    v.out = out;
    v.left = DRAW_PAD;
    v.top = DRAW_PAD + head;
    fit_view(t, &v, level, DRAW_WIDTH, DRAW_HEIGHT);
    heading_of(t, level, 0, text);
    draw_begin(out,
               ceil(fmax(view_width(&v), heading_width(text)) + 2 * DRAW_PAD),
               ceil(view_height(&v) + head + foot + 2 * DRAW_PAD));
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    put_window(&v, 0);
    put_heading(out, v.left, v.top - 8, text);
    draw_open(out, "clip-path=\"url(#view0)\"");
    put_ground(t, &v);
    for (int i = 0; i < poses; i++) {
        put_motion(&v, f, i, poses, seconds);
        if (i == 0)
            put_base(t, &v);
        else
            put_stone(t, &v, i - 1, 0);
        fputs("</g></g>\n", out);
    }
    draw_close(out);
    fprintf(out,
            "<rect x=\"%.2f\" y=\"%.2f\" width=\"0\" height=\"3\" "
            "fill=\"" DRAW_KERN "\"><animate attributeName=\"width\" "
            "dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"0;%.2f\"/>"
            "</rect>\n",
            v.left, v.top + view_height(&v) + foot - 5, seconds,
            view_width(&v));
    draw_close(out);
    return draw_end(out);
}

/* The file of a picture: with several structures it takes their name, without
   folder and ending, before its own ending. */
static void picture_name(const struct settings *set, const struct table *t,
                         const char *name, char *out)
{
    const char *base = t->file, *end, *dot = strrchr(name, '.');
    int stem = dot && !strpbrk(dot, "/\\") ? (int)(dot - name)
                                           : (int)strlen(name);
    for (const char *s = t->file; *s; s++)
        if (*s == '/' || *s == '\\')
            base = s + 1;
    end = strrchr(base, '.');
    if (!end || end == base)
        end = base + strlen(base);
    if (set->files == 1)
        snprintf(out, NAME_ROOM, "%s", name);
    else
        snprintf(out, NAME_ROOM, "%.*s-%.*s%s", stem, name, (int)(end - base),
                 base, name + stem);
}

/* Writes one picture; `film` NULL: that of before and after. */
static int write_picture(const struct settings *set, const struct table *t,
                         const char *name, int level,
                         const struct table_film *film)
{
    char path[NAME_ROOM];
    FILE *out;
    int bad;
    picture_name(set, t, name, path);
    out = fopen(path, "wb");
    bad = !out;
    if (out) {
        bad = film ? put_film(out, t, film, level) : put_svg(out, t, level);
        bad |= fclose(out) != 0;
    }
    if (bad)
        fprintf(stderr, "shake: cannot write %s: %s\n", path, strerror(errno));
    return bad ? -1 : 0;
}

/* Shakes once more at the level that is to be seen, as in repetition 0. */
static int draw_level(const struct settings *set, struct table *t, int level)
{
    struct table_film film = {NULL, 0, 0};
    int bad = table_shake(t, level, 0, &film);
    if (bad)
        fputs("shake: not enough memory for the pictures\n", stderr);
    if (!bad && set->svg)
        bad = write_picture(set, t, set->svg, level, NULL);
    if (!bad && set->film)
        bad = write_picture(set, t, set->film, level, &film);
    free(film.pose);
    return bad;
}

/* ---- The command line ---------------------------------------------------- */

static int run_file(const struct settings *set, int number, int seed)
{
    static const struct table empty;
    struct table t = empty;
    struct table_report r = {NULL, NULL, 0, 0, 0, 0};
    int bad;
    t.plan = set->plan;
    t.plan.seed = (uint64_t)seed;
    t.file = set->file[number];
    began = time(NULL);
    bad = table_load(&t) || table_collapse(&t, &r);
    clear_progress();
    if (bad) {
        fprintf(stderr, "%s:", t.file);
        if (t.text.line > 0)
            fprintf(stderr, "%d:", t.text.line);
        fprintf(stderr, " %s\n", t.text.message);
    } else {
        if (set->json)
            print_json(&t, &r);
        else
            print_text(&t, &r);
        fflush(stdout);
        if (set->svg || set->film)
            bad = draw_level(set, &t, set->show ? set->show : r.shown);
    }
    free(r.ads);
    free(r.first);
    table_free(&t);
    return bad ? EXIT_BAD : EXIT_DONE;
}

static int bad_use(const char *what, const char *word)
{
    fprintf(stderr, "shake: %s %s; try shake --help\n", what, word);
    return -1;
}

/* A-B, or N, which is 1-N. */
static int read_levels(struct settings *set, const char *s)
{
    if (args_range(s, 1, MOST_LEVELS, &set->plan.first, &set->plan.last))
        return -1;
    if (!strchr(s, '-'))
        set->plan.first = 1;
    return 0;
}

static int read_number(struct settings *set, const char *name, const char *s)
{
    int bad;
    const char *word = s;
    if (!s)
        return bad_use("a number is missing after", name);
    if (strcmp(name, "--repeat") == 0)
        bad = args_integer(&s, 1, 100000, &set->plan.repeat) || *s;
    else if (strcmp(name, "--show") == 0)
        bad = args_integer(&s, 1, MOST_LEVELS, &set->show) || *s;
    else if (strcmp(name, "--levels") == 0)
        bad = read_levels(set, s);
    else if (strcmp(name, "--unit") == 0) {
        kern_real unit = 0;
        bad = !text_number(s, &unit) || !(unit > 0);
        set->plan.unit = (double)unit;
    } else
        bad = args_range(s, 0, INT_MAX - 1, &set->first, &set->last);
    if (!bad)
        return 0;
    fprintf(stderr, "shake: %s does not take '%s'; try shake --help\n", name,
            word);
    return -1;
}

static int read_picture(const char *option, const char *name)
{
    if (args_is_svg(name))
        return 0;
    if (!name)
        return bad_use("a file name is missing after", option);
    fprintf(stderr, "shake: %s takes a name that ends in .svg, read '%s'\n",
            option, name);
    return -1;
}

static int read_option(void *settings, char **argv, int *i)
{
    struct settings *set = settings;
    static const char *const number[] = {"--levels", "--repeat", "--seed",
                                         "--unit", "--show"};
    const char *word = argv[*i], *value;
    for (int k = 0; k < (int)(sizeof number / sizeof number[0]); k++)
        if (args_value(argv, i, number[k], &value)
            || (k == 0 && args_value(argv, i, "-l", &value))
            || (k == 1 && args_value(argv, i, "-n", &value)))
            return read_number(set, number[k], value);
    if (args_value(argv, i, "--svg", &set->svg))
        return read_picture("--svg", set->svg);
    if (args_value(argv, i, "--film", &set->film))
        return read_picture("--film", set->film);
    if (strcmp(word, "--json") != 0)
        return bad_use("unknown option", word);
    set->json = 1;
    return 0;
}

int main(int argc, char **argv)
{
    struct settings set = {
        {1, 20, 1, 1, 1, show_progress}, 1, 1, 0, 0, NULL, NULL, argv, 0};
    int status = EXIT_DONE;
    set.files = args_read(argc, argv, read_option, &set);
    if (set.files == ARGS_BAD)
        return EXIT_BAD;
    if (set.files == ARGS_HELP)
        return fputs(help, stdout) < 0 ? EXIT_BAD : EXIT_DONE;
    if (set.files == ARGS_VERSION)
        return puts("shake " KERN_VERSION) < 0 ? EXIT_BAD : EXIT_DONE;
    if (set.files == 0) {
        fputs("shake: no file is given\n", stderr);
        fputs(help, stderr);
        return EXIT_BAD;
    }
    if (set.first < set.last && (set.svg || set.film)) {
        fputs("shake: --svg and --film take one seed\n", stderr);
        return EXIT_BAD;
    }
    for (int i = 0; i < set.files; i++)
        for (int seed = set.first; seed <= set.last; seed++)
            if (run_file(&set, i, seed))
                status = EXIT_BAD;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "shake: cannot write the report: %s\n",
                strerror(errno));
        return EXIT_BAD;
    }
    return status;
}
