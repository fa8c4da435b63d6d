/* figures - the paper's table and figures, from structures built here.

   Builds walls, stacks, pyramids and towers of irregular stones, shakes them
   on the table of table.h, and writes into a folder:

       structures, labels.csv, stones.csv          for the program study
       table1.md, table1.csv    what shaking and measuring cost (Table I)
       fig3-first.svg, -last    contacts shrunk, with forces (Fig. 3)
       fig6.svg, fig6.csv       displacement and shaking level (Fig. 6)
       fig7*.svg, fig7.csv      two walls that differ in one stone (Fig. 7)

       cc -O2 -ffp-contract=off -o figures examples/laboratory/figures.c -lm
       mkdir -p out/structures && ./figures out

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/args.h"
#include "build.h"
#include "../parts/draw.h"
#include "../parts/json.h"
#include "measures.h"
#include "../parts/plot.h"
#include "table.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { PATH = 4096, LEVELS = 20, MOST_SEED = 1000000 };

static const char help[] =
    "usage: figures [--quick] [--seed S[-T]] [--json] FOLDER\n"
    "Builds and shakes structures, and writes the table and the figures of the\n"
    "paper into FOLDER, which must hold a folder `structures`.\n"
    "  --quick      few structures, each shaken once\n"
    "  --seed S[-T] the structures of these numbers; default 1-80, quick 1-6\n"
    "  --json       one JSON object a structure, one line each, and no figures:\n"
    "               seed, name, family, irregularity (%); collapse: level of\n"
    "               shaking after which the stones are displaced by more than a\n"
    "               quarter of a stone in the mean, 21: never; collapse_sd; ads:\n"
    "               that mean after each level; and what is measured without\n"
    "               shaking: lengths in stones, load factors in g, tilt in rad,\n"
    "               near_*: near contacts counted; near_drop: 1 / (1 + expected\n"
    "               drop)\n"
    "  -h, --help\n";

struct sample {
    char name[40], path[PATH];
    enum build_kind kind;
    int irregularity, stones;
    double value[MEASURES];
    struct table_report shaken;
};

struct figures {
    const char *folder;
    int quick, json, first, samples; /* numbers from `first` on */
    struct sample *sample;
};

static int fail(const char *what, const char *name)
{
    fprintf(stderr, "figures: %s %s\n", what, name);
    return -1;
}

/* ---- Structures ---------------------------------------------------------- */

static int shake_file(const char *path, int first, int last, int repeat,
                      struct table_report *r)
{
    static const struct table empty;
    struct table t = empty;
    int bad;
    t.plan.first = first;
    t.plan.last = last;
    t.plan.repeat = repeat;
    t.plan.unit = 1;
    t.plan.seed = 1;
    t.file = path;
    bad = table_load(&t) || table_collapse(&t, r);
    if (bad)
        fail(path, t.text.message);
    table_free(&t);
    return bad;
}

static int measure_file(const char *path, double value[MEASURES])
{
    struct measures_of m;
    int bad = measures_load(&m, path) || measures_all(&m, value);
    measures_free(&m);
    return bad;
}

/* Builds sample i. What the simulator holds only by its tolerance for gaps
   does not count as standing: then another seed is tried, one of its own. */
static int build_sample(const struct figures *f, int i, struct sample *s)
{
    struct build *b = malloc(sizeof *b);
    int bad = -1;
    s->kind = (enum build_kind)(i % BUILD_KINDS);
    s->irregularity = 10 + 10 * (i / BUILD_KINDS % 5);
    snprintf(s->name, sizeof s->name, "i%d-%s-%02d", s->irregularity,
             build_kind_name[s->kind], i / BUILD_KINDS / 5);
    snprintf(s->path, sizeof s->path, "%s/structures/%s.kern", f->folder,
             s->name);
    for (int tries = 0; b && bad && tries < 100; tries++) {
        build_structure(b, s->kind, s->irregularity,
                        (uint64_t)(1 + i % 1000 + 1000 * tries)
                            + (uint64_t)(i / 1000) * 100000);
        s->stones = b->stones;
        if (build_write(b, s->path)) {
            free(b);
            return fail("cannot write (is the folder there?)", s->path);
        }
        bad = measure_file(s->path, s->value);
    }
    free(b);
    return bad ? fail("no structure that stands was found for", s->path) : 0;
}

static void print_sample(int seed, const struct sample *s)
{
    printf("{\"seed\": %d, \"name\": \"%s\", \"family\": \"%s\", "
           "\"irregularity\": %d, \"collapse\": %.6g, \"collapse_sd\": %.6g, "
           "\"ads\": [",
           seed, s->name, build_kind_name[s->kind], s->irregularity,
           s->shaken.level, s->shaken.level_sd);
    for (int l = 0; l < LEVELS; l++)
        printf("%s%.6g", l > 0 ? ", " : "", s->shaken.ads[l]);
    printf("]");
    for (int k = 0; k < MEASURES; k++)
        json_number(measures_name[k], s->value[k]);
    printf("}\n");
    fflush(stdout);
}

static int write_labels(const struct figures *f)
{
    FILE *out = plot_open(f->folder, "labels.csv");
    FILE *stones = plot_open(f->folder, "stones.csv");
    if (!out || !stones)
        return -1;
    fprintf(out, "name,family,irregularity,stones,level,level_sd\n");
    fprintf(stones, "name,stone,level\n");
    for (int i = 0; i < f->samples; i++) {
        const struct sample *s = &f->sample[i];
        fprintf(out, "%s,%s,%d,%d,%.6g,%.6g\n", s->name,
                build_kind_name[s->kind], s->irregularity, s->stones,
                s->shaken.level, s->shaken.level_sd);
        for (int k = 0; k < s->stones; k++)
            fprintf(stones, "%s,s%d,%.6g\n", s->name, k, s->shaken.first[k]);
    }
    return fclose(out) | fclose(stones) ? fail("cannot write", "labels") : 0;
}

static int make_samples(struct figures *f)
{
    f->sample = calloc((size_t)f->samples, sizeof *f->sample);
    if (!f->sample)
        return fail("not enough memory for", "the structures");
    for (int i = 0; i < f->samples; i++) {
        struct sample *s = &f->sample[i];
        if (!f->json)
            fprintf(stderr, "figures: structure %d of %d\n", i + 1, f->samples);
        if (build_sample(f, f->first + i - 1, s)
            || shake_file(s->path, 1, LEVELS, f->quick ? 1 : 3, &s->shaken))
            return -1;
        if (f->json)
            print_sample(f->first + i, s);
    }
    return f->json ? 0 : write_labels(f);
}

/* ---- Table I ------------------------------------------------------------- */

static double seconds_since(clock_t start)
{
    return (double)(clock() - start) / CLOCKS_PER_SEC;
}

enum { COST_ONE_SHAKING, COST_SHAKING, COST_MARGIN, COST_PROFILE, COSTS };

/* Calls of one measure, each with its own search for contacts, for a twentieth
   of a second. */
static int time_measure(struct measures_of *m, int which, double *seconds)
{
    clock_t start = clock();
    int calls = 0;
    do {
        double ask[ASKS];
        kern_margin out;
        int bad = measures_contacts(m);
        if (!bad && which == COST_PROFILE)
            bad = measures_profiles(m, ask);
        if (!bad && which == COST_MARGIN)
            bad = kern_measure(&m->task, &out, NULL) < 0;
        if (bad)
            return -1;
        calls++;
    } while (seconds_since(start) < 0.05);
    *seconds = seconds_since(start) / calls;
    return 0;
}

static int time_shaking(const char *path, int first, int last, double *seconds)
{
    struct table_report r = {NULL, NULL, 0, 0, 0, 0};
    int bad = shake_file(path, first, last, 1, &r);
    *seconds = r.seconds;
    free(r.ads);
    free(r.first);
    return bad;
}

static int time_sample(const struct sample *s, double cost[COSTS])
{
    struct measures_of m;
    int bad = measures_load(&m, s->path)
           || time_shaking(s->path, 10, 10, &cost[COST_ONE_SHAKING])
           || time_shaking(s->path, 1, LEVELS, &cost[COST_SHAKING]);
    for (int which = COST_MARGIN; which < COSTS && !bad; which++)
        bad = time_measure(&m, which, &cost[which]);
    measures_free(&m);
    return bad;
}

/* The structures with the most stones of each kind. */
static int table_one(const struct figures *f)
{
    FILE *csv = plot_open(f->folder, "table1.csv");
    FILE *md = plot_open(f->folder, "table1.md");
    if (!csv || !md)
        return -1;
    fprintf(csv, "name,stones,shaking_one_level,shaking,margin,profile\n");
    fprintf(md, "CPU seconds; measures with the search for contacts.\n\n"
                "| structure | stones | one level of shaking | levels 1..20 "
                "| level and margin | profiles | shaking / margin "
                "| shaking / profiles |\n|---|---|---|---|---|---|---|---|\n");
    for (int kind = 0; kind < BUILD_KINDS; kind++) {
        const struct sample *s = NULL;
        double cost[COSTS];
        for (int i = 0; i < f->samples; i++)
            if ((int)f->sample[i].kind == kind
                && (!s || f->sample[i].stones > s->stones))
                s = &f->sample[i];
        if (!s)
            continue;
        if (time_sample(s, cost))
            return fail("cannot time", "measures");
        fprintf(csv, "%s,%d", s->name, s->stones);
        fprintf(md, "| %s | %d |", s->name, s->stones);
        for (int k = 0; k < COSTS; k++) {
            fprintf(csv, ",%.3g", cost[k]);
            fprintf(md, " %.2g |", cost[k]);
        }
        fprintf(csv, "\n");
        fprintf(md, " %.0f | %.0f |\n", cost[COST_SHAKING] / cost[COST_MARGIN],
                cost[COST_SHAKING] / cost[COST_PROFILE]);
    }
    return fclose(csv) | fclose(md) ? fail("cannot write", "table1") : 0;
}

/* ---- Fig. 3 -------------------------------------------------------------- */

static int draw_shrunk(const struct figures *f, struct measures_of *m,
                       const char *name, double shrink, const char *caption)
{
    struct draw_scene scene = {0};
    kern_proof proof = {NULL, NULL};
    FILE *out = plot_open(f->folder, name);
    int bad;
    proof.force = calloc((size_t)m->task.s.contacts, sizeof *proof.force);
    bad = !out || !proof.force
       || kern_verdict(&m->task, (kern_real)shrink, &proof) != KERN_STANDS;
    if (!bad
        && kern_forces(&m->task, (kern_real)shrink, proof.force) == KERN_STANDS)
        scene.force_name = "least forces";
    scene.s = &m->task.s;
    scene.names = m->text.name;
    scene.shrink = shrink;
    scene.force = proof.force;
    scene.limiting = -1;
    scene.caption = caption;
    bad = bad || draw_svg(out, &scene);
    if (out)
        bad |= fclose(out) != 0;
    free(proof.force);
    return bad ? fail("cannot draw", name) : 0;
}

/* The first structure, as it is and at the last step of Algorithm 1. */
static int figure_three(const struct figures *f)
{
    struct measures_of m;
    kern_margin out = {0};
    char caption[160];
    int bad = measures_load(&m, f->sample[0].path)
           || kern_measure(&m.task, &out, NULL) != KERN_STANDS;
    if (!bad) {
        double last = (out.level - 1) * (double)out.epsilon;
        bad = draw_shrunk(f, &m, "fig3-first.svg", 0,
                          "Forces that hold it, contacts as they are");
        snprintf(caption, sizeof caption,
                 "Shrunk by %d steps there are forces "
                 "still, by one more there are none: level %d, margin %.4g",
                 out.level - 1, out.level, (double)out.margin);
        bad |= draw_shrunk(f, &m, "fig3-last.svg", last, caption);
    }
    measures_free(&m);
    return bad;
}

/* ---- Figs. 6 and 7 ------------------------------------------------------- */

static void level_axis(double *x)
{
    for (int l = 0; l < LEVELS; l++)
        x[l] = l + 1;
}

static double safety(const struct sample *s)
{
    return s->value[MEASURE_NEAR_WEAK_LOAD];
}

struct ranked {
    double safety;
    const struct sample *sample;
};

static int by_safety(const void *a, const void *b)
{
    const double x = ((const struct ranked *)a)->safety;
    const double y = ((const struct ranked *)b)->safety;
    return (x > y) - (x < y);
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The medians of each quarter of the structures, the least safe first. */
static int plot_quarters(const struct figures *f, const struct plot *p,
                         const double *x, double most)
{
    struct ranked *s = malloc((size_t)f->samples * sizeof *s);
    double *ads = malloc((size_t)f->samples * sizeof *ads);
    char shade[8];
    int bad = !s || !ads;
    for (int i = 0; i < f->samples && !bad; i++) {
        s[i].safety = safety(&f->sample[i]);
        s[i].sample = &f->sample[i];
    }
    if (!bad)
        qsort(s, (size_t)f->samples, sizeof *s, by_safety);
    for (int q = 0; q < 4 && !bad; q++) {
        const int from = f->samples * q / 4,
                  n = f->samples * (q + 1) / 4 - from;
        double median[LEVELS];
        if (n == 0)
            continue;
        for (int l = 0; l < LEVELS; l++) {
            for (int i = 0; i < n; i++)
                ads[i] = s[from + i].sample->shaken.ads[l];
            qsort(ads, (size_t)n, sizeof *ads, ascending);
            median[l] = (ads[(n - 1) / 2] + ads[n / 2]) / 2;
        }
        plot_curve(p, x, median, LEVELS, DRAW_INK, 5);
        plot_curve(p, x, median, LEVELS,
                   draw_shade(s[from + n / 2].safety / most, shade), 3.4);
    }
    free(s);
    free(ads);
    return bad;
}

static int figure_six(const struct figures *f)
{
    FILE *csv = plot_open(f->folder, "fig6.csv");
    FILE *svg = plot_open(f->folder, "fig6.svg");
    struct plot p = {NULL, 0, LEVELS, 0, 1.5, 0, 0, 0, 0};
    double x[LEVELS], most = 0;
    char shade[8];
    int bad;
    if (!csv || !svg)
        return -1;
    level_axis(x);
    for (int i = 0; i < f->samples; i++)
        most = fmax(most, safety(&f->sample[i]));
    if (!(most > 0))
        most = 1;
    plot_begin(&p, svg,
               "Shaking displaces safe structures later (thick: "
               "median of each quarter)",
               "level of shaking, 0.059 g each",
               "mean displacement of the stones, in stones", 70);
    fprintf(csv, "name,near_weak_load");
    for (int l = 1; l <= LEVELS; l++)
        fprintf(csv, ",ads%d", l);
    fprintf(csv, "\n");
    for (int i = 0; i < f->samples; i++) {
        const struct sample *s = &f->sample[i];
        fprintf(csv, "%s,%.6g", s->name, safety(s));
        for (int l = 0; l < LEVELS; l++)
            fprintf(csv, ",%.6g", s->shaken.ads[l]);
        fprintf(csv, "\n");
        plot_curve(&p, x, s->shaken.ads, LEVELS,
                   draw_shade(safety(s) / most, shade), 0.5);
    }
    bad = plot_quarters(f, &p, x, most);
    plot_colours(&p, 0, most, "load factor of the weaker half, g");
    bad |= plot_end(&p);
    return fclose(csv) | fclose(svg) | bad ? fail("cannot write", "fig6") : 0;
}

static void write_brick(FILE *out, int course, int i, double x, double width)
{
    const double height = 0.6, y = course * height;
    fprintf(out, "block b%d%d *  %g %g  %g %g  %g %g  %g %g\n", course, i, x, y,
            x + width, y, x + width, y + height, x, y + height);
}

/* A wall of bricks in bond, with half a brick at the ends of every second
   course; the last brick of all may lie a little farther out. */
static int write_wall(const char *path, double out_by)
{
    enum { COURSES = 5, BRICKS = 5 };
    const double width = 1, joint = 0.02, half = (width - joint) / 2;
    FILE *out = fopen(path, "w");
    if (!out)
        return fail("cannot write", path);
    fprintf(out,
            "friction 0.4\ngravity 0 -9.81\ntolerance 0.001\n"
            "fixed base -2 -1  %d -1  %d 0  -2 0\n",
            BRICKS + 2, BRICKS + 2);
    for (int c = 0; c < COURSES; c++) {
        double x = 0;
        for (int i = 0; i < BRICKS + c % 2; i++) {
            int end = c % 2 && (i == 0 || i == BRICKS);
            int last = c == COURSES - 1 && i == BRICKS - 1;
            write_brick(out, c, i, x + (last ? out_by : 0), end ? half : width);
            x += (end ? half : width) + joint;
        }
    }
    return fclose(out) ? fail("cannot write", path) : 0;
}

/* Draws a wall and returns its margin and level. */
static int draw_wall(const struct figures *f, const char *path,
                     const char *name, kern_margin *m)
{
    struct measures_of w;
    struct draw_scene scene = {0};
    char caption[120];
    FILE *out = plot_open(f->folder, name);
    int bad = measures_load(&w, path) || !out
           || kern_measure(&w.task, m, NULL) != KERN_STANDS;
    if (!bad) {
        snprintf(caption, sizeof caption, "level %d, margin %.3g stones",
                 m->level, (double)m->margin);
        scene.s = &w.task.s;
        scene.limiting = -1;
        scene.caption = caption;
        bad = draw_svg(out, &scene);
    }
    measures_free(&w);
    if (out)
        bad |= fclose(out) != 0;
    return bad ? fail("cannot draw", name) : 0;
}

static int figure_seven(const struct figures *f)
{
    static const double out_by[2] = {0, 0.35};
    static const char *const colour[2] = {DRAW_KERN, DRAW_GHOST};
    static const char *const name[2] = {"fig7-a.svg", "fig7-b.svg"};
    struct table_report r[2] = {{NULL, NULL, 0, 0, 0, 0},
                                {NULL, NULL, 0, 0, 0, 0}};
    struct plot p = {NULL, 0, LEVELS, 0, 0.1, 0, 0, 0, 0};
    FILE *csv = plot_open(f->folder, "fig7.csv");
    FILE *svg = plot_open(f->folder, "fig7.svg");
    kern_margin m[2];
    double x[LEVELS];
    char path[PATH], text[80];
    int bad = !csv || !svg;
    level_axis(x);
    for (int k = 0; k < 2 && !bad; k++) {
        snprintf(path, sizeof path, "%s/fig7-%c.kern", f->folder, 'a' + k);
        bad = write_wall(path, out_by[k]) || draw_wall(f, path, name[k], &m[k])
           || shake_file(path, 1, LEVELS, f->quick ? 1 : 5, &r[k]);
        for (int l = 0; l < LEVELS && !bad; l++)
            p.y1 = fmax(p.y1, r[k].ads[l]);
    }
    if (bad)
        return -1;
    plot_begin(&p, svg, "Two walls that differ in the place of one stone",
               "level of shaking, 0.059 g each",
               "mean displacement of the stones, in stones", 0);
    fprintf(csv, "wall,level,margin,collapse");
    for (int l = 1; l <= LEVELS; l++)
        fprintf(csv, ",ads%d", l);
    fprintf(csv, "\n");
    for (int k = 0; k < 2; k++) {
        fprintf(csv, "%c,%d,%.6g,%.6g", 'a' + k, m[k].level,
                (double)m[k].margin, r[k].level);
        for (int l = 0; l < LEVELS; l++)
            fprintf(csv, ",%.6g", r[k].ads[l]);
        fprintf(csv, "\n");
        plot_curve(&p, x, r[k].ads, LEVELS, colour[k], 2);
        draw_line(svg, draw_vec(p.left + 16, p.top + 18 + 18 * k),
                  draw_vec(p.left + 40, p.top + 18 + 18 * k),
                  k ? "stroke=\"" DRAW_GHOST "\" stroke-width=\"2\""
                    : "stroke=\"" DRAW_KERN "\" stroke-width=\"2\"");
        snprintf(text, sizeof text, "wall %c: level %d, margin %.3g stones",
                 'a' + k, m[k].level, (double)m[k].margin);
        plot_text(&p, p.left + 48, p.top + 22 + 18 * k, 11.5, "start", text);
        free(r[k].ads);
        free(r[k].first);
    }
    bad = plot_end(&p);
    return fclose(csv) | fclose(svg) | bad ? fail("cannot write", "fig7") : 0;
}

/* S, or S-T. */
static int read_seeds(struct figures *f, const char *word)
{
    int last;
    if (args_range(word, 1, MOST_SEED, &f->first, &last)) {
        fprintf(stderr, "figures: --seed takes S or S-T, from 1 to %d\n",
                MOST_SEED);
        return -1;
    }
    f->samples = last - f->first + 1;
    return 0;
}

/* Returns 0, 1 where all is said, or -1. */
static int read_arguments(struct figures *f, int argc, char **argv)
{
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0)
            return fputs(help, stdout) < 0 ? -1 : 1;
        if (strcmp(word, "--quick") == 0)
            f->quick = 1;
        else if (strcmp(word, "--json") == 0)
            f->json = 1;
        else if (strcmp(word, "--seed") == 0 && i + 1 < argc) {
            if (read_seeds(f, argv[++i]))
                return -1;
        } else if (word[0] != '-' && !f->folder)
            f->folder = word;
        else
            f->folder = NULL, i = argc;
    }
    if (f->samples == 0)
        f->samples = f->quick ? 6 : 80;
    if (!f->folder)
        fputs(help, stderr);
    return f->folder ? 0 : -1;
}

int main(int argc, char **argv)
{
    struct figures f = {NULL, 0, 0, 1, 0, NULL};
    int bad = read_arguments(&f, argc, argv);
    if (bad)
        return bad > 0 ? 0 : 2;
    bad = make_samples(&f);
    if (!bad && !f.json)
        bad = table_one(&f) || figure_three(&f) || figure_six(&f)
           || figure_seven(&f);
    for (int i = 0; i < f.samples && f.sample; i++) {
        free(f.sample[i].shaken.ads);
        free(f.sample[i].shaken.first);
    }
    free(f.sample);
    return bad ? 2 : 0;
}
