/* walls - Figs. 8 and 9 of Y. Liu, M. Saboia, V. Thangavelu and N. Napp
   (Approximate Stability Analysis for Drystacked Structures, IROS 2019): walls
   that the planners of stack.h build from the same stocks, and their quality
   over the irregularity of the stones. Writes into a folder:

       walls/                   every wall, for the program kern
       walls.csv                one line a wall
       fig8.svg                 the walls of the first set, side by side, with
                                lines along the tops of their courses
       fig9.svg                 quality over irregularity: mean and deviation,
                                that of heuristic as a band, with the level of
                                collapse as the stability; beside it the paired
                                differences of that level, with intervals
       fig9-margin.svg          the same with the margin
       fig9.csv                 both in numbers
       fig9.md                  means, figures of masonry, differences between
                                planners with intervals

       cc -O2 -ffp-contract=off -o walls examples/laboratory/walls.c -lm
       mkdir -p out/walls && ./walls out

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/args.h"
#include "../parts/draw.h"
#include "../parts/plot.h"
#include "table.h"
#include "drop.h"
#include "masonry.h"
#include "stack.h"
#include "stones.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char help[] =
    "usage: walls [--quick] [--settled] [--sets N] [--first S] [--steps N]\n"
    "             [--dress P] [--from LIST] FOLDER\n"
    "Builds walls with the planners of stack.h from N stocks a level of\n"
    "irregularity (20), and writes Figs. 8 and 9 of the paper into FOLDER, which\n"
    "must hold a folder `walls`.\n"
    "  --quick     2 stocks a level, 1 for the step test\n"
    "  --settled   heuristic and combined alone: they drop stones in the simulator\n"
    "              and let the wall settle, see drop.h\n"
    "  --first S   the seed of the first stock; default 1\n"
    "  --steps N   the step test, of the walls of the first N stocks a level: each\n"
    "              step is let go in six runs of the simulator; default 0\n"
    "  --dress P   best may dress a stone by P per cent of its area; default 0\n"
    "  --from LIST builds nothing: Fig. 9 of walls that are listed, a walls.csv of one\n"
    "              run or of several\n";

enum { WALLS_LEVELS = 5, WALLS_STONES = 36, WALLS_PATH = 4096 };

/* What quality takes for stability: Eq. (8) of the paper takes the level of
   collapse. */
#define WALLS_STABILITY_LIST(X)      \
    X(COLLAPSE, "level of collapse") \
    X(MARGIN, "margin / size")       \
    X(LEVEL, "level")

enum walls_stability {
#define WALLS_STABILITY_ID(id, words) WALLS_##id,
    WALLS_STABILITY_LIST(WALLS_STABILITY_ID)
#undef WALLS_STABILITY_ID
        WALLS_STABILITIES
};

static const char *const walls_stability_words[] = {
#define WALLS_STABILITY_WORDS(id, words) words,
    WALLS_STABILITY_LIST(WALLS_STABILITY_WORDS)
#undef WALLS_STABILITY_WORDS
};

static const char *const walls_colour[] = {DRAW_GHOST, DRAW_KERN, "#2f6b3a"};

struct walls_one {
    int laid;
    double fill, seconds;
    double stability[WALLS_STABILITIES];
    struct masonry masonry;
    int tried, asked;
    double asking;
    int tested;    /* by the step test: what follows is known      */
    int some, all; /* steps that move in some, in all of its runs  */
    int falls;     /* runs in which the finished wall moves        */
};

struct walls {
    const char *folder;
    const char *from; /* a list of walls that were built before       */
    int sets, quick, settled;
    int planners;     /* the first of stack.h                         */
    int dress;        /* per cent of a stone's area                   */
    int first, steps; /* seed of the first set; sets of the step test */
    FILE *list;
    /* one a level, set and planner */
    struct walls_one *one;
};

/* The irregularity of a level, in per cent. */
static int walls_percent(int level) { return 10 + 10 * level; }

static struct walls_one *walls_at(const struct walls *f, int level, int set,
                                  int planner)
{
    return &f->one[(level * f->sets + set) * STACK_PLANNERS + planner];
}

static double walls_quality(const struct walls_one *o, int stability)
{
    return stack_quality(o->stability[stability], o->fill);
}

static int fail(const char *what, const char *name)
{
    fprintf(stderr, "walls: %s %s\n", what, name);
    return -1;
}

/* ---- Building ------------------------------------------------------------ */

static void walls_step_test(const struct stack_wall *w, struct walls_one *one)
{
    one->tested = 1;
    for (int i = 1; i <= w->laid; i++) {
        int moves = stack_moves(w, i);
        one->some += moves > 0;
        one->all += moves == STACK_TESTS;
        one->falls = moves;
    }
}

/* Plans one wall, writes and shakes it; leaves it open. */
static int walls_build(const struct walls *f, const struct stones *stock,
                       int level, int set, int planner, struct stack_wall *w)
{
    struct walls_one *one = walls_at(f, level, set, planner);
    struct stack_options o = stack_defaults();
    struct drop_options drop = drop_defaults();
    char path[WALLS_PATH];
    clock_t start = clock();
    o.planner = (enum stack_planner)planner;
    o.seed = (uint64_t)(f->first + set);
    o.dress = f->dress / 100.0;
    if (f->quick) {
        o.walls = 4;
        drop.drops = 40;
    }
    if (stack_open(w, stock, &o)
        || (f->settled ? drop_build(w, &drop) : stack_plan(w)))
        return fail("not enough memory for", "a wall");
    one->seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    one->laid = w->laid;
    one->fill = stack_fill(w);
    one->stability[WALLS_MARGIN] = w->m.margin / stock->size;
    one->stability[WALLS_LEVEL] = w->m.level;
    one->tried = w->tried;
    one->asked = w->asked;
    one->asking = w->asking;
    snprintf(path, sizeof path, "%s/walls/i%d-%02d-%s.kern", f->folder,
             walls_percent(level), f->first + set, stack_planner_name[planner]);
    if (masonry_of(&w->plan.task.s, stock->size, &one->masonry))
        return fail("not enough memory for", "its figures");
    if (stack_write(w, path))
        return fail("cannot write", path);
    if (set < f->steps)
        walls_step_test(w, one);
    return table_once("walls", path, 1, &one->stability[WALLS_COLLAPSE]);
}

/* A line a wall, as soon as it is built. */
static void walls_list(const struct walls *f, int level, int set, int planner)
{
    const struct walls_one *o = walls_at(f, level, set, planner);
    fprintf(f->list,
            "%d,%d,%s,%d,%.4f,%.0f,%.4f,%.4g,%.5f,%.5f,%.4f,%.4f,"
            "%.4f,%.4f,%.4f,%.4f,%.4f,%.1f,%.3g,%.0f,%d,%d,%.0f",
            walls_percent(level), f->first + set, stack_planner_name[planner],
            o->laid, o->fill, o->stability[WALLS_LEVEL],
            o->stability[WALLS_MARGIN], o->stability[WALLS_COLLAPSE],
            walls_quality(o, WALLS_COLLAPSE), walls_quality(o, WALLS_MARGIN),
            o->masonry.off_level, o->masonry.on_two, o->masonry.bedless,
            o->masonry.corners, o->masonry.gaping, o->masonry.uneven,
            o->masonry.joint, o->masonry.end_columns, o->seconds,
            o->masonry.running, o->tried, o->asked,
            o->asked / fmax(o->asking, 1e-9));
    if (o->tested)
        fprintf(f->list, ",%d,%d,%d\n", o->some, o->all, o->falls);
    else
        fputs(",,,\n", f->list);
    fflush(f->list);
}

static int walls_open_list(struct walls *f)
{
    f->list = plot_open(f->folder, "walls.csv");
    if (!f->list)
        return -1;
    fprintf(
        f->list,
        "irregularity,seed,planner,stones,filling,level,"
        "margin_sizes,collapse,Q,Q_margin,off_level,on_two,bedless,"
        "corners,gaping,uneven,joint,end_columns,seconds,running,candidates,asked,"
        "asked_a_second,moves_some,moves_all,finished_moves\n");
    return 0;
}

/* One line of a list; what is not of these sets is passed over. */
static void walls_line(const struct walls *f, const char *line)
{
    struct walls_one o = {0};
    char planner[20];
    int level, seed,
        found = sscanf(
            line,
            "%d,%d,%19[a-z],%d,%lf,%lf,%lf,%lf,"
            "%*f,%*f,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%lf,%d,%d,%*f,%d,%d,"
            "%d",
            &level, &seed, planner, &o.laid, &o.fill, &o.stability[WALLS_LEVEL],
            &o.stability[WALLS_MARGIN], &o.stability[WALLS_COLLAPSE],
            &o.masonry.off_level, &o.masonry.on_two, &o.masonry.bedless,
            &o.masonry.corners, &o.masonry.gaping, &o.masonry.uneven,
            &o.masonry.joint, &o.masonry.end_columns, &o.seconds,
            &o.masonry.running, &o.tried, &o.asked, &o.some, &o.all, &o.falls);
    const int set = seed - f->first;
    level = level / 10 - 1;
    if (found < 20 || set < 0 || set >= f->sets || level < 0
        || level >= WALLS_LEVELS)
        return;
    o.tested = found == 23;
    for (int p = 0; p < f->planners; p++)
        if (strcmp(planner, stack_planner_name[p]) == 0)
            *walls_at(f, level, set, p) = o;
}

/* Reads the walls of all sets from a list. */
static int walls_read(const struct walls *f)
{
    FILE *in = fopen(f->from, "r");
    char line[400];
    if (!in)
        return fail("cannot read", f->from);
    while (fgets(line, sizeof line, in))
        walls_line(f, line);
    fclose(in);
    for (int i = 0; i < WALLS_LEVELS * f->sets * STACK_PLANNERS; i++)
        if (f->one[i].laid == 0 && i % STACK_PLANNERS < f->planners)
            return fail("not all walls are in", f->from);
    return 0;
}

/* ---- Fig. 8 -------------------------------------------------------------- */

static const double walls_wide = 300, walls_high = 212, walls_left = 40,
                    walls_top = 40;

/* The top of a stone, from left to right: the ends of its edges that look upward,
   45 degrees off the level at the most. Returns how many. */
static int walls_upper(const struct stone *s, kern_vec *at)
{
    const double up = 0.7071;
    int right = 0, n = 0;
    for (int i = 0; i < s->n; i++) /* edges go from right to left there */
        if (rest_edge_at(s, i).n.y >= up
            && rest_edge_at(s, i + 1 < s->n ? i + 1 : 0).n.y < up)
            right = i;
    for (int i = right + s->n; n < s->n; i--) {
        const struct rest_edge e = rest_edge_at(s, i % s->n);
        if (e.n.y < up)
            break;
        if (n == 0)
            at[n++] = e.b;
        at[n++] = e.a;
    }
    return n;
}

/* The stone of a course whose centre is the next one to the right of x; -1: there
   is none. */
static int walls_next(const struct stack_wall *w, const int *course, int which,
                      double x)
{
    int next = -1;
    for (int i = 0; i < w->laid; i++)
        if (course[i + 1] == which && w->stone[i].centre.x > x
            && !stack_keeps_back(w, w->place[i].stone)
            && (next < 0 || w->stone[i].centre.x < w->stone[next].centre.x))
            next = i;
    return next;
}

/* A line along the tops of a course, broken where the next top is far. Returns how
   many stones the course has. */
static int walls_course(const struct stack_wall *w, const struct draw_view *v,
                        const int *course, int which)
{
    const double apart = 0.5 * w->stock->size;
    kern_vec last = {-HUGE_VAL, 0};
    int stones = 0;
    fputs("<path fill=\"none\" stroke=\"" DRAW_FORCE "\" stroke-width=\"1.6\""
          " stroke-linejoin=\"round\" d=\"",
          v->out);
    for (int i = walls_next(w, course, which, last.x); i >= 0;
         i = walls_next(w, course, which, w->stone[i].centre.x), stones++) {
        kern_vec top[STONES_CORNERS + 1];
        const int n = walls_upper(&w->stone[i], top);
        for (int k = 0; k < n; k++) {
            const struct draw_pt p = draw_place(v, top[k].x, top[k].y);
            const int broken = k == 0
                            && (top[k].x - last.x > apart
                                || fabs(top[k].y - last.y) > apart);
            fprintf(v->out, "%c%.2f %.2f", broken ? 'M' : 'L', draw_px(p.x),
                    draw_px(p.y));
            last = top[k];
        }
    }
    fputs("\"/>\n", v->out);
    return stones;
}

/* One wall in its place: levels downwards, planners to the right. */
static void walls_draw(const struct walls *f, FILE *out, int level, int planner,
                       const struct stack_wall *w)
{
    const struct walls_one *one = walls_at(f, level, 0, planner);
    struct draw_view v;
    int course[WALLS_STONES + 1];
    char text[120];
    stack_view(w, &v, walls_wide);
    v.out = out;
    v.scale = walls_wide / (w->options.width + 1);
    v.left = walls_left + planner * walls_wide;
    v.top = walls_top + level * walls_high + walls_high - 34
          - (v.high.y - v.low.y) * v.scale;
    stack_draw_frame(w, &v);
    for (int i = 0; i < w->laid; i++)
        stack_draw_stone(w, &v, i);
    masonry_courses(&w->plan.task.s, w->stock->size, course);
    for (int k = 1; walls_course(w, &v, course, k) > 0;)
        k++;
    snprintf(text, sizeof text, "filling %.2f, collapse at %.0f, joints %.2f",
             one->fill, one->stability[WALLS_COLLAPSE], one->masonry.joint);
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    draw_text(out, v.left + walls_wide / 2 - 14,
              walls_top + level * walls_high + walls_high - 20, 11, "middle",
              text, strlen(text));
    draw_close(out);
}

static void walls_head(const struct walls *f, FILE *out)
{
    char text[40];
    draw_begin(out, walls_left + f->planners * walls_wide,
               walls_top + WALLS_LEVELS * walls_high);
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    for (int p = 0; p < f->planners; p++)
        draw_text(out, walls_left + (p + 0.5) * walls_wide - 14, 20, 13,
                  "middle", stack_planner_name[p],
                  strlen(stack_planner_name[p]));
    for (int l = 0; l < WALLS_LEVELS; l++) {
        snprintf(text, sizeof text, "%d %%", walls_percent(l));
        draw_text(out, 22, walls_top + (l + 0.5) * walls_high, 13, "middle",
                  text, strlen(text));
    }
    draw_close(out);
}

/* Builds everything; Fig. 8 is drawn on the way. */
static int walls_make(const struct walls *f)
{
    FILE *out = plot_open(f->folder, "fig8.svg");
    int bad = !out;
    if (out)
        walls_head(f, out);
    for (int set = 0; set < f->sets && !bad; set++)
        for (int l = 0; l < WALLS_LEVELS && !bad; l++) {
            struct stones stock;
            fprintf(stderr, "walls: set %d of %d, irregularity %d\n", set + 1,
                    f->sets, walls_percent(l));
            bad = stones_make(&stock, walls_percent(l), WALLS_STONES, 0,
                              (uint64_t)(f->first + set));
            for (int p = 0; p < f->planners && !bad; p++) {
                struct stack_wall w;
                bad = walls_build(f, &stock, l, set, p, &w);
                if (!bad)
                    walls_list(f, l, set, p);
                if (!bad && set == 0)
                    walls_draw(f, out, l, p, &w);
                stack_free(&w);
            }
            stones_free(&stock);
        }
    if (out) {
        bad |= draw_end(out);
        bad |= fclose(out);
    }
    return bad;
}

/* ---- Fig. 9 -------------------------------------------------------------- */

/* Mean and standard deviation. */
static void walls_moments(const double *x, int n, double *mean, double *sd)
{
    double sum = 0, squares = 0;
    for (int i = 0; i < n; i++)
        sum += x[i];
    *mean = sum / n;
    for (int i = 0; i < n; i++)
        squares += (x[i] - *mean) * (x[i] - *mean);
    *sd = n > 1 ? sqrt(squares / (n - 1)) : 0;
}

/* Half the 95 % interval of a mean: Student's t, by its series in 1 / degrees
   of freedom (2.093 for 19; the table has the same). */
static double walls_interval(double sd, int n)
{
    const double z = 1.959964, d = n - 1;
    double t = z + (z * z * z + z) / (4 * d)
             + (5 * pow(z, 5) + 16 * pow(z, 3) + 3 * z) / (96 * d * d);
    return n > 1 ? t * sd / sqrt(n) : 0;
}

/* Of the quality of a planner's walls at a level, or without `worth` of their
   stability alone; less another's on the same stocks, if that is not
   negative. */
static void walls_sum_up(const struct walls *f, int level, int planner,
                         int less, int stability, int worth, double *mean,
                         double *sd)
{
    double *x = malloc((size_t)f->sets * sizeof *x);
    *mean = *sd = 0;
    if (!x)
        return;
    for (int i = 0; i < f->sets; i++) {
        const struct walls_one *a = walls_at(f, level, i, planner);
        const struct walls_one *b = less < 0 ? NULL
                                             : walls_at(f, level, i, less);
        x[i] = worth ? walls_quality(a, stability) : a->stability[stability];
        if (b)
            x[i] -= worth ? walls_quality(b, stability)
                          : b->stability[stability];
    }
    walls_moments(x, f->sets, mean, sd);
    free(x);
}

static void walls_difference(const struct walls *f, FILE *out, int more,
                             int less, int stability, int worth)
{
    for (int l = 0; l < WALLS_LEVELS; l++) {
        double mean, sd;
        walls_sum_up(f, l, more, less, stability, worth, &mean, &sd);
        fprintf(out, " %.3g ± %.2g |", mean, walls_interval(sd, f->sets));
    }
    fprintf(out, "\n");
}

/* Differences of two planners: in the level of collapse itself, and in Q for
   each choice of stability. */
static void walls_differences(const struct walls *f, FILE *out, int more,
                              int less)
{
    fprintf(out,
            "\n%s less %s, mean of the paired differences and its 95 %% "
            "interval:\n\n| of |",
            stack_planner_name[more], stack_planner_name[less]);
    for (int l = 0; l < WALLS_LEVELS; l++)
        fprintf(out, " %d |", walls_percent(l));
    fprintf(out, "\n|---|---|---|---|---|---|\n| level of collapse |");
    walls_difference(f, out, more, less, WALLS_COLLAPSE, 0);
    for (int k = 0; k < WALLS_STABILITIES; k++) {
        fprintf(out, "| Q, %s |", walls_stability_words[k]);
        walls_difference(f, out, more, less, k, 1);
    }
}

enum { WALLS_FIGURES = 12 };

/* Writes what the table of means has of a wall, from left to right. */
static void walls_figures(const struct walls_one *o, double x[WALLS_FIGURES])
{
    /* clang-format off */
    const double all[WALLS_FIGURES] = {
        o->laid, o->fill, o->stability[WALLS_COLLAPSE], o->masonry.off_level,
        o->masonry.on_two, o->masonry.bedless, o->masonry.corners,
        o->masonry.gaping, o->masonry.uneven, o->masonry.end_columns,
        o->masonry.running, o->seconds
    };
    /* clang-format on */
    memcpy(x, all, sizeof all);
}

static const struct {
    const char *name;
    int digits;
} walls_column[WALLS_FIGURES] = {
    {"stones", 1}, {"filling", 3}, {"collapse", 1}, {"off level", 2},
    {"on two", 2}, {"no bed", 2},  {"corners", 2},  {"gaping", 2},
    {"uneven", 2}, {"ends", 2},    {"running", 2},  {"seconds", 1}};

/* Writes means over all sets of a level, with 95 % intervals. */
static void walls_means(const struct walls *f, FILE *out)
{
    double *x = malloc((size_t)f->sets * sizeof *x);
    fprintf(out, "| irregularity | planner |");
    for (int k = 0; k < WALLS_FIGURES; k++)
        fprintf(out, " %s |", walls_column[k].name);
    fprintf(out, "\n|---|---|");
    for (int k = 0; k < WALLS_FIGURES; k++)
        fprintf(out, "---|");
    fprintf(out, "\n");
    for (int row = 0; x && row < WALLS_LEVELS * f->planners; row++) {
        const int l = row / f->planners, p = row % f->planners;
        fprintf(out, "| %d | %s |", walls_percent(l), stack_planner_name[p]);
        for (int k = 0; k < WALLS_FIGURES; k++) {
            const int digits = walls_column[k].digits;
            double all[WALLS_FIGURES], mean, sd;
            for (int set = 0; set < f->sets; set++) {
                walls_figures(walls_at(f, l, set, p), all);
                x[set] = all[k];
            }
            walls_moments(x, f->sets, &mean, &sd);
            fprintf(out, " %.*f ± %.*f |", digits, mean, digits,
                    walls_interval(sd, f->sets));
        }
        fprintf(out, "\n");
    }
    free(x);
}

/* The step test, in sums over all levels. */
static void walls_steps(const struct walls *f, FILE *out)
{
    const int sets = f->steps < f->sets ? f->steps : f->sets;
    fprintf(out, "\n| planner | walls | with a step that moves in some run | "
                 "in all runs | finished walls that move in some run | steps | "
                 "that move in some run |\n|---|---|---|---|---|---|---|\n");
    for (int p = 0; p < f->planners; p++) {
        int some = 0, all = 0, falls = 0, steps = 0, moving = 0;
        for (int l = 0; l < WALLS_LEVELS; l++)
            for (int set = 0; set < sets; set++) {
                const struct walls_one *o = walls_at(f, l, set, p);
                some += o->some > 0;
                all += o->all > 0;
                falls += o->falls > 0;
                steps += o->laid;
                moving += o->some;
            }
        fprintf(out, "| %s | %d | %d | %d | %d | %d | %d |\n",
                stack_planner_name[p], WALLS_LEVELS * sets, some, all, falls,
                steps, moving);
    }
}

static int walls_tables(const struct walls *f)
{
    FILE *csv = plot_open(f->folder, "fig9.csv");
    FILE *md = plot_open(f->folder, "fig9.md");
    if (!csv || !md)
        return -1;
    fprintf(csv, "irregularity,planner,sets,mean,deviation,interval,"
                 "margin_mean,margin_deviation,margin_interval\n");
    for (int l = 0; l < WALLS_LEVELS; l++)
        for (int p = 0; p < f->planners; p++) {
            fprintf(csv, "%d,%s,%d", walls_percent(l), stack_planner_name[p],
                    f->sets);
            for (int k = WALLS_COLLAPSE; k <= WALLS_MARGIN; k++) {
                double mean, sd;
                walls_sum_up(f, l, p, -1, k, 1, &mean, &sd);
                fprintf(csv, ",%.5f,%.5f,%.5f", mean, sd,
                        walls_interval(sd, f->sets));
            }
            fputs("\n", csv);
        }
    walls_means(f, md);
    walls_differences(f, md, STACK_COMBINED, STACK_HEURISTIC);
    for (int p = 0; p < STACK_BEST && f->planners > STACK_BEST; p++)
        walls_differences(f, md, STACK_BEST, p);
    if (f->steps > 0)
        walls_steps(f, md);
    return fclose(csv) | fclose(md) ? fail("cannot write", "fig9") : 0;
}

/* One planner's curve, and a standard deviation each way: a band for the first,
   bars for the others. */
static void walls_curve(const struct walls *f, const struct plot *p,
                        int planner, int stability)
{
    double x[WALLS_LEVELS], mean[WALLS_LEVELS];
    double low[WALLS_LEVELS], high[WALLS_LEVELS];
    char style[80];
    snprintf(style, sizeof style, "stroke=\"%s\" stroke-width=\"1.2\"",
             walls_colour[planner]);
    for (int l = 0; l < WALLS_LEVELS; l++) {
        double sd;
        walls_sum_up(f, l, planner, -1, stability, 1, &mean[l], &sd);
        x[l] = walls_percent(l) + 0.5 * planner; /* bars side by side */
        low[l] = fmax(mean[l] - sd, p->y0);
        high[l] = fmin(mean[l] + sd, p->y1);
        if (planner != STACK_HEURISTIC)
            draw_line(p->out, plot_place(p, x[l], low[l]),
                      plot_place(p, x[l], high[l]), style);
    }
    if (planner == STACK_HEURISTIC)
        plot_band(p, x, low, high, WALLS_LEVELS, walls_colour[planner]);
    for (int l = 0; l < WALLS_LEVELS; l++)
        plot_point(p, x[l], mean[l], walls_colour[planner]);
    plot_curve(p, x, mean, WALLS_LEVELS, walls_colour[planner], 1.8);
    draw_line(p->out, draw_vec(p->left + 236, p->top + 18 + 18 * planner),
              draw_vec(p->left + 260, p->top + 18 + 18 * planner), style);
    plot_text(p, p->left + 268, p->top + 22 + 18 * planner, 11.5, "start",
              stack_planner_name[planner]);
}

/* The stability of a planner less that of heuristic on the same stocks, by
   level: mean and half the 95 % interval. Returns the farthest end of the
   intervals. */
static double walls_lead(const struct walls *f, int planner, int stability,
                         double mean[WALLS_LEVELS], double half[WALLS_LEVELS])
{
    double most = 0;
    for (int l = 0; l < WALLS_LEVELS; l++) {
        double sd;
        walls_sum_up(f, l, planner, STACK_HEURISTIC, stability, 0, &mean[l],
                     &sd);
        half[l] = walls_interval(sd, f->sets);
        most = fmax(most, fabs(mean[l]) + half[l]);
    }
    return most;
}

/* From the field of a figure to that of walls_panel(), in pixels. */
static const double walls_panel_right = 380 + 24 + 62;

/* A second field to the right of p: differences to heuristic in the stability
   alone, a point and its interval for every level and planner. */
static void walls_panel(const struct walls *f, const struct plot *p,
                        int stability)
{
    struct plot q = *p;
    double mean[WALLS_LEVELS], half[WALLS_LEVELS], most = 1e-3;
    char title[100];
    for (int k = STACK_COMBINED; k < f->planners; k++)
        most = fmax(most, walls_lead(f, k, stability, mean, half));
    q.left += walls_panel_right;
    q.y0 = -most;
    q.y1 = most;
    const double step = plot_round(&q.y0, &q.y1);
    plot_axes(&q, plot_round(&q.x0, &q.x1), step);
    snprintf(title, sizeof title,
             "Difference to heuristic, %s: mean, 95 %% "
             "interval",
             walls_stability_words[stability]);
    plot_text(&q, q.left, 20, 12.5, "start", title);
    plot_text(&q, q.left + q.width / 2, q.top + q.height + 35, 11.5, "middle",
              "irregularity, %");
    draw_line(q.out, plot_place(&q, q.x0, 0), plot_place(&q, q.x1, 0),
              "stroke=\"" DRAW_EDGE "\" stroke-width=\"0.8\"");
    for (int k = STACK_COMBINED; k < f->planners; k++) {
        char style[80];
        snprintf(style, sizeof style, "stroke=\"%s\" stroke-width=\"1.6\"",
                 walls_colour[k]);
        walls_lead(f, k, stability, mean, half);
        for (int l = 0; l < WALLS_LEVELS; l++) {
            const double x = walls_percent(l) + 0.5 * k; /* side by side */
            draw_line(q.out, plot_place(&q, x, mean[l] - half[l]),
                      plot_place(&q, x, mean[l] + half[l]), style);
            plot_point(&q, x, mean[l], walls_colour[k]);
        }
    }
}

static int walls_nine(const struct walls *f, int stability, const char *name,
                      const char *yname)
{
    FILE *out = plot_open(f->folder, name);
    struct plot p = {NULL, 5, 55, 0, 0.1, 0, 0, 0, 0};
    char title[100];
    int bad;
    if (!out)
        return -1;
    for (int l = 0; l < WALLS_LEVELS; l++)
        for (int k = 0; k < f->planners; k++) {
            double mean, sd;
            walls_sum_up(f, l, k, -1, stability, 1, &mean, &sd);
            p.y1 = fmax(p.y1, mean + sd);
        }
    p.y1 *= 1.25; /* the names stand above */
    snprintf(title, sizeof title,
             "Quality, %d stocks a level: mean, deviation "
             "(heuristic: band)",
             f->sets);
    plot_begin(&p, out, title, "irregularity, %", yname, walls_panel_right);
    for (int k = 0; k < f->planners; k++)
        walls_curve(f, &p, k, stability);
    walls_panel(f, &p, stability);
    bad = plot_end(&p);
    return fclose(out) | bad ? fail("cannot write", name) : 0;
}

/* All of it, into the folder of *f. */
static int walls_all(struct walls *f)
{
    int bad;
    f->one = calloc((size_t)(WALLS_LEVELS * f->sets * STACK_PLANNERS),
                    sizeof *f->one);
    bad = !f->one
       || (f->from ? walls_read(f) : walls_open_list(f) || walls_make(f));
    if (f->list && fclose(f->list))
        bad = fail("cannot write", "walls.csv");
    bad = bad || walls_tables(f)
       || walls_nine(f, WALLS_COLLAPSE, "fig9.svg",
                     "Q: level of collapse x worth of the filling")
       || walls_nine(f, WALLS_MARGIN, "fig9-margin.svg",
                     "Q: margin in stones x worth of the filling");
    free(f->one);
    return bad;
}

/* Reads the option at argv[*i]; returns 0, or -1. */
static int walls_option(void *set, char **argv, int *i)
{
    struct walls *f = set;
    const struct {
        const char *name;
        int most, *out;
    } number[] = {{"--sets", 1000, &f->sets},
                  {"--first", 1000000, &f->first},
                  {"--dress", 30, &f->dress},
                  {"--steps", 1000000, &f->steps}};
    const char *word;
    for (int k = 0; k < 4; k++)
        if (args_value(argv, i, number[k].name, &word))
            return args_integer(&word, 1, number[k].most, number[k].out)
                        || *word
                     ? -1
                     : 0;
    if (args_value(argv, i, "--from", &f->from))
        return f->from ? 0 : -1;
    if (strcmp(argv[*i], "--quick") == 0)
        f->quick = 1;
    else if (strcmp(argv[*i], "--settled") == 0)
        f->settled = 1;
    else
        return -1;
    return 0;
}

int main(int argc, char **argv)
{
    struct walls f = {NULL, NULL, 0, 0, 0, 0, 0, 1, 0, NULL, NULL};
    const int folders = args_read(argc, argv, walls_option, &f);
    if (folders == ARGS_HELP)
        return fputs(help, stdout) < 0 ? 2 : 0;
    if (folders != 1) {
        fputs(help, stderr);
        return 2;
    }
    f.folder = argv[0];
    if (f.sets == 0)
        f.sets = f.quick ? 2 : 20;
    f.planners = f.settled ? STACK_BEST : STACK_PLANNERS;
    if (f.quick && !f.settled && f.steps == 0)
        f.steps = 1;
    return walls_all(&f) ? 2 : 0;
}
