/* stack - builds a wall from a stock of irregular stones.

   Lays one stone after the other where it rests on those below, and asks the
   library how safely the wall would stand with each candidate. The stock is
   the blocks of a structure file, in any pose, or is made by the program.

       cc -O2 -ffp-contract=off -o stack examples/laboratory/stack.c -lm
       ./stack --irregularity 30 --stones 36
       ./stack --help

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/args.h"
#include "../parts/draw.h"
#include "measures.h"
#include "table.h"
#include "../parts/text.h"
#include "masonry.h"
#include "stack.h"
#include "stones.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

static const char help[] =
    "usage: stack [options] STOCK\n"
    "       stack [options] --irregularity L\n"
    "Builds a wall of stones and writes it as a structure, with a picture and a\n"
    "table. STOCK is a structure file, - is stdin: its blocks are the stock.\n"
    "\n"
    "      --irregularity L  makes a stock instead, of L per cent: 0 to 60\n"
    "      --stones N        of so many stones; default 36\n"
    "      --chips N         and of so many chips of 0.02 to 0.15 mean stones, that\n"
    "                        best lays as pins; default 0\n"
    "      --seed S[-T]      of the stock and of the planner best; default 1. A\n"
    "                        range builds a wall for each and adds -S to the names\n"
    "                        of what is written\n"
    "      --planner P       heuristic, combined or best, the default\n"
    "  -w, --width W         of the frame to be filled, in the units of the stock\n"
    "  -h, --height H        of it; default: 16:9, room for 4/3 of the stock\n"
    "      --boxes N         a frame of N mean bounding boxes each way instead\n"
    "      --most N          lay so many stones at the most\n"
    "      --look N          the next N stones of the stock are candidates;\n"
    "                        default 6, of best all\n"
    "      --dress S         best: a stone may lose the share S of its area along\n"
    "                        its top, which is then level; default 0\n"
    "      --threshold F=T   how much worse than the best candidate one may be in\n"
    "                        a feature: edges, hole, neighbours, slope, bond\n"
    "      --levels K        combined: the kern filter comes after K of these\n"
    "                        five; default 0\n"
    "      --friction MU     default 0.4\n"
    "      --joints MU       friction in head joints, steeper than 45 degrees, for\n"
    "                        the margin alone; default: that of all contacts\n"
    "      --walls N         best: so many walls are built; default: as many as\n"
    "                        some seconds allow\n"
    "      --goal G          best: what it wants to be high beside the filling:\n"
    "                        drop, the level of collapse that the expected drop\n"
    "                        predicts, the default, or load\n"
    "      --beat F,M        best: a wall with more filling than F and a limit\n"
    "                        multiplier above M is wanted; implies --goal load\n"
    "      --out FILE        the wall; default stacked.kern\n"
    "      --svg OUT.svg     its picture; default stacked.svg\n"
    "      --film OUT.svg    a picture that shows how it is built, with margin, level\n"
    "                        and sideways reserve after each stone\n"
    "      --steps NAME      a picture a step: NAME-01.svg and so on\n"
    "      --against FILE    another wall, its stones in the order of laying\n"
    "      --no-shaking      leave out the shaking test\n"
    "      --json            one JSON object a wall, one line each, no table:\n"
    "                        lengths in mean stones, limit in g\n"
    "      --help, --version\n"
    "\n"
    "Table: share of the frame that is filled; level, margin (a length); limit: load\n"
    "factor in g with a friction of 0.58, in head joints 0; collapse: level of\n"
    "shaking, 0.059 g each; Q: margin in stones times what the filling is worth;\n"
    "tilted: share of the stones whose longest face is more than 15 degrees off\n"
    "level; of the stones above the ground, on two: share with beds of 0.15 mean\n"
    "stones on two or more, no bed: share without any; corner: share of their\n"
    "supports that are shorter; gape: share of the head joints wider than 0.1 mean\n"
    "stones; uneven: deviation of the tops of a course, in mean stones; ends: share\n"
    "of the two ends that are four stones or more, each on the one below alone;\n"
    "joint: shortest way up through the joints over the height, 1 is a running\n"
    "joint. Stones of less than a fifth of the square of the mean size are pins:\n"
    "best keeps them back until one makes a stone rest on two, or fits into a joint;\n"
    "in the table, from tilted to ends, they are no stones.\n"
    "\n"
    "Exit status: 0 done, 1 no stone could be laid, 2 bad use or input.\n";

enum {
    EXIT_DONE = 0,
    EXIT_NONE = 1,
    EXIT_BAD = 2,
    PATH = 4096,
    FILM_BARS = 60
}; /* pixels, the highest bar of a film           */

struct settings {
    struct stack_options plan;
    const char *stock, *out, *svg, *film, *steps, *against;
    double irregularity, boxes;
    int stones, chips, shaking, json;
    int first, last; /* seeds                                   */
};

static int fail(const char *what, const char *why)
{
    fprintf(stderr, "stack: %s: %s\n", what, why);
    return -1;
}

/* ---- The command line ---------------------------------------------------- */

/* Reads a number in [low, high]. */
static int number(const char *name, const char *word, double low, double high,
                  double *out)
{
    char why[120];
    kern_real value;
    if (text_number(word, &value) && value >= low && value <= high) {
        *out = value;
        return 0;
    }
    snprintf(why, sizeof why, "a number from %g to %g is expected", low, high);
    return fail(name, why);
}

static int whole(const char *name, const char *word, int low, int high,
                 int *out)
{
    double value;
    if (number(name, word, low, high, &value))
        return -1;
    if (value > floor(value))
        return fail(name, "a whole number is expected");
    *out = (int)value;
    return 0;
}

/* One of some names; returns its index, or -1. */
static int one_of(const char *name, const char *word, size_t length,
                  const char *const *list, int count)
{
    for (int i = 0; i < count; i++)
        if (strlen(list[i]) == length && strncmp(list[i], word, length) == 0)
            return i;
    return fail(name, "no such name; see --help");
}

static int read_threshold(struct settings *o, const char *word)
{
    size_t length = strcspn(word, "=");
    int k;
    if (word[length] == '\0')
        return fail("--threshold", "FEATURE=NUMBER is expected");
    k = one_of("--threshold", word, length, stack_filter_name, STACK_FILTERS);
    return k < 0 ? -1
                 : number("--threshold", word + length + 1, 0, 1e9,
                          &o->plan.threshold[k]);
}

static int read_beat(struct settings *o, const char *word)
{
    char fill[40];
    size_t length = strcspn(word, ",");
    if (word[length] == '\0' || length >= sizeof fill)
        return fail("--beat", "FILLING,MULTIPLIER is expected");
    memcpy(fill, word, length);
    fill[length] = '\0';
    o->plan.goal = STACK_LOAD;
    return number("--beat", fill, 1e-3, 1, &o->plan.beat[0])
        || number("--beat", word + length + 1, 1e-3, 10, &o->plan.beat[1]);
}

static int read_seed(struct settings *o, const char *word)
{
    return args_range(word, 0, INT_MAX - 1, &o->first, &o->last)
             ? fail("--seed", "S or S-T is expected")
             : 0;
}

static int read_planner(struct settings *o, const char *word)
{
    const int k = one_of("--planner", word, strlen(word), stack_planner_name,
                         STACK_PLANNERS);
    if (k >= 0)
        o->plan.planner = (enum stack_planner)k;
    return k < 0 ? -1 : 0;
}

static int read_goal(struct settings *o, const char *word)
{
    const int k = one_of("--goal", word, strlen(word), stack_goal_name,
                         STACK_GOALS);
    if (k >= 0)
        o->plan.goal = (enum stack_goal)k;
    return k < 0 ? -1 : 0;
}

/* So many, however long they take. */
static int read_walls(struct settings *o, const char *word)
{
    o->plan.effort = 0;
    return whole("--walls", word, 1, 100000, &o->plan.walls);
}

/* An option with a value. Returns 0, or -1 where something is wrong. */
static int read_option(struct settings *o, const char *name, const char *word)
{
    struct stack_options *p = &o->plan;
    const struct {
        const char *name;
        double low, high, *out;
    } numbers[] = {{"--irregularity", 0, 60, &o->irregularity},
                   {"--width", 1e-3, 1e6, &p->width},
                   {"-w", 1e-3, 1e6, &p->width},
                   {"--height", 1e-3, 1e6, &p->height},
                   {"-h", 1e-3, 1e6, &p->height},
                   {"--boxes", 1, 1000, &o->boxes},
                   {"--dress", 0, 0.3, &p->dress},
                   {"--friction", 0, 10, &p->friction},
                   {"--joints", 0, 10, &p->joints}};
    const struct {
        const char *name;
        int low, high, *out;
    } wholes[] = {{"--stones", 1, STONES_MOST, &o->stones},
                  {"--chips", 0, STONES_MOST, &o->chips},
                  {"--most", 1, STONES_MOST, &p->most},
                  {"--look", 1, STONES_MOST, &p->look},
                  {"--levels", 0, STACK_FILTERS, &p->levels}};
    const struct {
        const char *name;
        int svg;
        const char **out;
    } files[] = {{"--out", 0, &o->out},
                 {"--svg", 1, &o->svg},
                 {"--film", 1, &o->film},
                 {"--steps", 0, &o->steps},
                 {"--against", 0, &o->against}};
    static const struct {
        const char *name;
        int (*read)(struct settings *o, const char *word);
    } others[] = {{"--seed", read_seed}, {"--planner", read_planner},
                  {"--goal", read_goal}, {"--walls", read_walls},
                  {"--beat", read_beat}, {"--threshold", read_threshold}};
    if (!word)
        return fail(name, "a value is expected; see --help");
    for (size_t k = 0; k < sizeof numbers / sizeof *numbers; k++)
        if (strcmp(name, numbers[k].name) == 0)
            return number(name, word, numbers[k].low, numbers[k].high,
                          numbers[k].out);
    for (size_t k = 0; k < sizeof wholes / sizeof *wholes; k++)
        if (strcmp(name, wholes[k].name) == 0)
            return whole(name, word, wholes[k].low, wholes[k].high,
                         wholes[k].out);
    for (size_t k = 0; k < sizeof others / sizeof *others; k++)
        if (strcmp(name, others[k].name) == 0)
            return others[k].read(o, word);
    for (size_t k = 0; k < sizeof files / sizeof *files; k++)
        if (strcmp(name, files[k].name) == 0) {
            if (files[k].svg && !args_is_svg(word))
                return fail(name, "a name that ends in .svg is expected");
            *files[k].out = word;
            return 0;
        }
    return fail(name, "no such option; see --help");
}

/* Returns 0, -1 where something is wrong, 1 where all is said. */
static int read_arguments(struct settings *o, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0) {
            fputs(help, stdout);
            return 1;
        }
        if (strcmp(argv[i], "--version") == 0) {
            printf("stack %s\n", KERN_VERSION);
            return 1;
        }
        if (strcmp(argv[i], "--no-shaking") == 0) {
            o->shaking = 0;
        } else if (strcmp(argv[i], "--json") == 0) {
            o->json = 1;
        } else if (argv[i][0] == '-' && argv[i][1] != '\0') {
            if (read_option(o, argv[i], argv[i + 1]))
                return -1;
            i++;
        } else if (o->stock) {
            return fail(argv[i], "there is a stock already");
        } else {
            o->stock = argv[i];
        }
    }
    if (!o->stock == (o->irregularity < 0))
        return fail("usage", "either a STOCK or --irregularity is expected; "
                             "see --help");
    return 0;
}

/* ---- Pictures ------------------------------------------------------------ */

static int draw_wall(const struct stack_wall *w, const char *path)
{
    struct draw_scene scene = {0};
    char caption[200];
    FILE *out = fopen(path, "w");
    int bad;
    if (!out)
        return fail(path, strerror(errno));
    snprintf(caption, sizeof caption,
             "%s: %d stones, filling %.3f, level %d, "
             "margin %.3g mean stones",
             stack_planner_name[w->options.planner], w->laid, stack_fill(w),
             w->m.level, w->m.margin / w->stock->size);
    scene.s = &w->plan.task.s;
    scene.limiting = -1;
    scene.caption = caption;
    bad = draw_svg(out, &scene);
    bad |= fclose(out);
    return bad ? fail(path, "cannot be written") : 0;
}

/* What the film says of the wall after each stone. */
struct scene {
    kern_margin m;
    kern_real reserve; /* against a push sideways, as a share of gravity */
};

/* Lays the wall once more, and notes its margin and its reserve after each
   stone; 0 where it is not raised. */
static int lay_again(struct stack_wall *w, struct scene *after)
{
    const int laid = w->laid;
    int bad = 0;
    stack_cut(w, 0);
    for (int i = 0; i < laid && !bad; i++) {
        kern_raising raising = KERN_NOT_SHOWN;
        bad = stack_lay(w, &w->place[i]);
        after[i].m = w->m;
        if (kern_raised(&w->plan.task, 0, &raising, &after[i].reserve, NULL)
                != KERN_STANDS
            || raising != KERN_RAISED)
            after[i].reserve = 0;
    }
    return bad;
}

/* What follows, up to draw_close(), is seen from one share of the film to
   another; where nothing moves, what stays to the end is. */
static void film_show(FILE *out, double seconds, double from, double to)
{
    fprintf(out,
            "<g opacity=\"%d\"><animate attributeName=\"opacity\" "
            "dur=\"%.2fs\" repeatCount=\"indefinite\" calcMode=\"discrete\" "
            "keyTimes=\"0;%.4f;%.4f\" values=\"0;1;%d\"/>\n",
            to >= 1, seconds, fmax(from, 0.0001), fmin(to, 1), to >= 1);
}

/* A bar under the wall, one of two beside each other for stone i of some. */
static void film_bar(const struct stack_wall *w, const struct draw_view *v,
                     double foot, int i, int second, double share)
{
    const double wide = (DRAW_WIDTH - 2 * DRAW_PAD) / w->laid;
    const double high = FILM_BARS * share;
    draw_rect(v->out, v->left + wide * (i + 0.4 * second),
              foot + FILM_BARS - high, 0.4 * wide, high,
              second ? "fill=\"#c2703d\"" : "fill=\"" DRAW_KERN "\"");
}

/* Stones appear one after the other, each with its margin and its reserve as
   bars under the wall and a line that says both, and it begins again. */
static void put_film(const struct stack_wall *w, const struct draw_view *v,
                     const struct scene *after, double foot)
{
    const double each = 0.4, hold = 3, all = each * w->laid + hold;
    double most[2] = {1e-9, 1e-9};
    char text[200];
    for (int i = 0; i < w->laid; i++) {
        most[0] = fmax(most[0], after[i].m.margin);
        most[1] = fmax(most[1], after[i].reserve);
    }
    for (int i = 0; i < w->laid; i++) {
        const double at = each * i / all, size = w->stock->size;
        const struct scene *now = &after[i];
        film_show(v->out, all, at, 1);
        stack_draw_stone(w, v, i);
        film_bar(w, v, foot, i, 0, now->m.margin / most[0]);
        film_bar(w, v, foot, i, 1, now->reserve / most[1]);
        draw_close(v->out);
        film_show(v->out, all, at, i + 1 < w->laid ? at + each / all : 1);
        snprintf(text, sizeof text,
                 "stone %d of %d: level %d, margin %.3f "
                 "stones (blue, to %.3f), sideways reserve %.3f g "
                 "(brown, to %.3f)",
                 i + 1, w->laid, now->m.level, now->m.margin / size,
                 most[0] / size, now->reserve, most[1]);
        draw_text(v->out, v->left, foot + FILM_BARS + 18, 12.5, "start", text,
                  strlen(text));
        draw_close(v->out);
    }
}

static int draw_film(struct stack_wall *w, const char *path)
{
    struct scene *after = malloc((size_t)w->laid * sizeof *after);
    FILE *out = fopen(path, "w");
    struct draw_view v;
    int bad = !after || lay_again(w, after);
    if (out && !bad) {
        stack_view(w, &v, DRAW_WIDTH);
        v.out = out;
        const double foot = v.top + (v.high.y - v.low.y) * v.scale + 14;
        draw_begin(out, DRAW_WIDTH, ceil(foot + FILM_BARS + 18 + DRAW_PAD));
        draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
        stack_draw_frame(w, &v);
        put_film(w, &v, after, foot);
        draw_close(out);
        bad = draw_end(out);
    }
    free(after);
    if (!out)
        return fail(path, strerror(errno));
    bad |= fclose(out);
    return bad ? fail(path, "cannot be written") : 0;
}

/* Lays the wall once more, with a picture after each stone. */
static int draw_steps(struct stack_wall *w, const char *name)
{
    const int laid = w->laid;
    char path[PATH];
    int bad = 0;
    for (int i = 0; i < laid && !bad; i++) {
        stack_cut(w, i == 0 ? 0 : i);
        bad = stack_lay(w, &w->place[i]);
        snprintf(path, sizeof path, "%s-%02d.svg", name, i + 1);
        bad = bad || draw_wall(w, path);
    }
    return bad;
}

/* ---- The table ----------------------------------------------------------- */

/* What the table says of a wall; limit below 0, collapse 0: none. */
struct row {
    int stones, pins; /* all of them; how many of these are pins  */
    double fill, size, limit, collapse, expected;
    kern_margin m;
    struct masonry masonry;
};

static void print_head(void)
{
    printf(
        "%-24s %6s %7s %6s %7s %9s %9s %7s %6s %6s %6s %6s %5s %6s %4s %5s\n",
        "wall", "stones", "filling", "level", "margin", "limit", "collapse",
        "Q", "tilted", "on two", "no bed", "corner", "gape", "uneven", "ends",
        "joint");
}

static void print_row(const char *name, const struct row *r)
{
    printf("%-24.24s %6d %7.4f %6d %7.4g ", name, r->stones, r->fill,
           r->m.level, r->m.margin);
    if (r->limit < 0)
        printf("%9s ", "none");
    else
        printf("%9.4f ", r->limit);
    if (r->collapse <= 0)
        printf("%9s ", "-");
    else if (r->collapse > TABLE_LEVELS)
        printf("%8s%d ", ">", TABLE_LEVELS);
    else
        printf("%9.3g ", r->collapse);
    printf("%7.4f %6.2f %6.2f %6.2f %6.2f %5.2f %6.2f %4.1f %5.2f\n",
           stack_quality(r->m.margin / r->size, r->fill), r->masonry.off_level,
           r->masonry.on_two, r->masonry.bedless, r->masonry.corners,
           r->masonry.gaping, r->masonry.uneven, r->masonry.end_columns,
           r->masonry.joint);
}

/* The largest filling of a frame that is laid over a wall, wherever it is
   moved sideways. */
static double fill_of(const struct measures_of *m, double width, double height)
{
    enum { PLACES = 400 };
    double low = HUGE_VAL, high = -HUGE_VAL, most = 0, sum[PLACES + 1] = {0};
    for (int i = 0; i < m->task.s.blocks; i++) {
        const kern_block *b = &m->task.s.block[i];
        if (b->fixed)
            continue;
        low = fmin(low, b->box.low.x);
        high = fmax(high, b->box.high.x);
    }
    for (int i = 0; i < m->task.s.blocks; i++) {
        const kern_block *b = &m->task.s.block[i];
        struct stone s;
        if (b->fixed || stone_of(&s, b->vertex, b->vertices))
            continue;
        for (int k = 0; k <= PLACES; k++) {
            const double x = low + (high - low - width) * k / PLACES;
            struct stone there = s;
            stone_move(&there, stones_vec(b->centre.x - x, b->centre.y));
            sum[k] += stone_area_in(&there, width, height);
        }
    }
    for (int k = 0; k <= PLACES; k++)
        most = fmax(most, sum[k]);
    return most / (width * height);
}

static int print_other(const struct settings *o, const char *path, double size)
{
    struct measures_of m;
    struct row r = {0};
    r.size = size;
    if (measures_load(&m, path) || kern_measure(&m.task, &r.m, NULL) < 0
        || masonry_of(&m.task.s, size, &r.masonry)) {
        fail(path, m.text.message[0] ? m.text.message : "cannot be measured");
        measures_free(&m);
        return -1;
    }
    for (int i = 0; i < m.task.s.blocks; i++)
        r.stones += !m.task.s.block[i].fixed;
    if (o->shaking && table_once("stack", path, size, &r.collapse))
        r.collapse = 0;
    r.fill = fill_of(&m, o->plan.width, o->plan.height);
    r.limit = stack_limit(&m.task, m.contact);
    print_row(path, &r);
    measures_free(&m);
    return 0;
}

/* One line of JSON; null where there was no shaking, where the wall does not
   stand without friction in its head joints, or no way leads through them. */
static void print_json(const struct settings *o, const struct row *r,
                       double seconds)
{
    printf("{\"wall\": \"%s\", \"planner\": \"%s\", \"seed\": %d, "
           "\"stones\": %d, \"pins\": %d, \"filling\": %.4f, \"level\": %d, "
           "\"margin\": %.6g, ",
           o->out, stack_planner_name[o->plan.planner], (int)o->plan.seed,
           r->stones, r->pins, r->fill, r->m.level, r->m.margin / r->size);
    if (o->irregularity >= 0)
        printf("\"irregularity\": %g, ", o->irregularity);
    if (o->shaking)
        printf("\"collapse\": %g, ", r->collapse);
    else
        printf("\"collapse\": null, ");
    printf("\"expected_collapse\": %.3g, ", r->expected);
    if (r->limit >= 0)
        printf("\"limit\": %.4g, ", r->limit);
    else
        printf("\"limit\": null, ");
    printf("\"off_level\": %.4g, \"on_two\": %.4g, \"bedless\": %.4g, "
           "\"corners\": %.4g, \"gaping\": %.4g, \"uneven\": %.4g, "
           "\"end_columns\": %.4g, ",
           r->masonry.off_level, r->masonry.on_two, r->masonry.bedless,
           r->masonry.corners, r->masonry.gaping, r->masonry.uneven,
           r->masonry.end_columns);
    if (r->masonry.joint < HUGE_VAL)
        printf("\"joint\": %.4g, ", r->masonry.joint);
    else
        printf("\"joint\": null, ");
    printf("\"running\": %.0f, ", r->masonry.running);
    printf("\"seconds\": %.2f}\n", seconds);
}

static int print_result(const struct settings *o, struct stack_wall *w,
                        double seconds)
{
    struct row r = {0};
    r.stones = w->laid;
    r.pins = w->pins;
    r.fill = stack_fill(w);
    r.size = w->stock->size;
    r.m = w->m;
    r.limit = stack_limit(&w->plan.task, w->plan.contact);
    r.expected = stack_predicted_level(w);
    if (masonry_of(&w->plan.task.s, r.size, &r.masonry)
        || (o->shaking && table_once("stack", o->out, r.size, &r.collapse)))
        return -1;
    if (o->json) {
        print_json(o, &r, seconds);
        return 0;
    }
    print_head();
    print_row(stack_planner_name[o->plan.planner], &r);
    printf("expected level of collapse, by the expected drop: %.1f\n",
           r.expected);
    return o->against ? print_other(o, o->against, r.size) : 0;
}

/* ---- All of it ----------------------------------------------------------- */

/* The frame, where it was not given. */
static int choose_frame(struct settings *o, const struct stones *stock)
{
    struct stack_options *p = &o->plan;
    const double filled = 0.75, shape = 16.0 / 9;
    double wide = 0, high = 0;
    const int stones = stock->stones - stock->pins;
    double area = stock->area * stones / filled;
    for (int i = 0; i < stock->stones; i++) {
        const struct stone *s = &stock->stone[i];
        if (stones_is_pin(stock, s))
            continue;
        wide += (s->high.x - s->low.x) / stones;
        high += (s->high.y - s->low.y) / stones;
    }
    if (o->boxes > 0) {
        p->width = o->boxes * wide;
        p->height = o->boxes * high;
    }
    if (!(p->width > 0) && !(p->height > 0))
        p->width = sqrt(area * shape);
    if (!(p->width > 0))
        p->width = area / p->height;
    if (!(p->height > 0))
        p->height = area / p->width;
    if (p->width > 1000 * stock->size || p->height > 1000 * stock->size)
        return fail("frame", "more than 1000 stones wide or high");
    return 0;
}

static void report(const struct stack_wall *w, double seconds)
{
    fprintf(stderr, "\nstack: %d stones laid in %.2f s: %s\n", w->laid, seconds,
            w->message);
    fprintf(stderr,
            "stack: %d candidates came to rest, %.0f a second; kern "
            "was asked about %d, %.0f a second, whether %d stay, %d do not\n",
            w->tried, w->tried / fmax(seconds, 1e-9), w->asked,
            w->asked / fmax(w->asking, 1e-9), w->held, w->slipped);
}

/* The wall as a structure and in pictures, and its line of the table. */
static int put_wall(const struct settings *o, struct stack_wall *w,
                    double seconds)
{
    if (stack_write(w, o->out))
        return fail(o->out, "cannot be written");
    return draw_wall(w, o->svg) || (o->film && draw_film(w, o->film))
        || print_result(o, w, seconds) || (o->steps && draw_steps(w, o->steps));
}

static int build(struct settings *o, const struct stones *stock)
{
    struct stack_wall w;
    clock_t start = clock();
    double seconds;
    int end = EXIT_DONE;
    if (choose_frame(o, stock))
        return EXIT_BAD;
    if (stack_open(&w, stock, &o->plan) || stack_plan(&w)) {
        fail("planner", "not enough memory");
        stack_free(&w);
        return EXIT_BAD;
    }
    seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (!o->json)
        report(&w, seconds);
    if (w.laid == 0)
        end = EXIT_NONE;
    else if (put_wall(o, &w, seconds))
        end = EXIT_BAD;
    stack_free(&w);
    return end;
}

/* A dot a wall, and for the planners that build only one a dot a stone. */
static void show_progress(const struct stack_wall *w, int wall)
{
    static int shown;
    if (w->options.planner == STACK_BEST && wall == shown)
        return;
    shown = wall;
    fputc('.', stderr);
    fflush(stderr);
}

/* NAME.* becomes NAME-SEED.* */
static int name_seeded(char out[PATH], const char *name, int seed)
{
    const char *slash = strrchr(name, '/');
    const char *dot = strrchr(slash ? slash : name, '.');
    const int stem = dot ? (int)(dot - name) : (int)strlen(name);
    const int n = snprintf(out, PATH, "%.*s-%d%s", stem, name, seed,
                           name + stem);
    return n < PATH ? 0 : fail(name, "is too long a name");
}

/* One seed: with several, what is written carries its number. */
static int run_seed(const struct settings *all, int seed)
{
    char out[PATH], svg[PATH];
    struct settings o = *all;
    struct stones stock;
    int bad;
    o.plan.seed = (uint64_t)seed;
    if (o.first < o.last) {
        if (name_seeded(out, o.out, seed) || name_seeded(svg, o.svg, seed))
            return EXIT_BAD;
        o.out = out;
        o.svg = svg;
    }
    bad = o.stock ? stones_load(&stock, o.stock)
                  : stones_make(&stock, o.irregularity, o.stones, o.chips,
                                o.plan.seed);
    if (bad)
        fail(o.stock ? o.stock : "stock", stock.message);
    bad = bad ? EXIT_BAD : build(&o, &stock);
    stones_free(&stock);
    return bad;
}

int main(int argc, char **argv)
{
    /* clang-format off */
    struct settings o = { stack_defaults(), NULL, "stacked.kern", "stacked.svg",
                          NULL, NULL, NULL, -1, 0, 36, 0, 1, 0, 1, 1 };
    /* clang-format on */
    int bad;
    o.plan.width = o.plan.height = 0;
    bad = read_arguments(&o, argc, argv);
    if (bad)
        return bad > 0 ? EXIT_DONE : EXIT_BAD;
    if (!o.json)
        o.plan.progress = show_progress;
    if (o.first < o.last && (o.film || o.steps)) {
        fail("--film and --steps", "take one seed");
        return EXIT_BAD;
    }
    for (int seed = o.first; seed <= o.last; seed++) {
        const int one = run_seed(&o, seed);
        bad = one > bad ? one : bad;
    }
    return bad;
}
