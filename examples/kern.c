/* kern - can a dry-stacked structure stand, and how far from falling is it?

   Reads structures in the text format of parts/text.h, drawings and annotated
   photographs as parts/drawing.h says, and reports on each: verdict, level and margin, what limits
   them, how it falls, the horizontal load and the tilt it bears; for a person,
   as JSON (one object a line), or as a picture. Its parts are in kern/:

       state.h        settings, and what was found of one file
       analysis.h     reads, finds contacts, decides, measures
       asked.h, sweep.h, crush.h, earth.h, place.h
                           what options and statements ask for beyond that
       loads.h, beds.h      what statements put where, one resultant a bed
       report.h, report_json.h, page.h, picture.h, c_arrays.h, statements_file.h
                           what is written
       help.h, usage.h      what --help prints

       cc -O2 -o kern examples/kern.c -lm
       ./kern --svg wall.svg examples/structures/wall-60.kern
       ./kern --help

   SPDX-License-Identifier: MIT */

/* The same digits where products and sums are fused: see >>determinism. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__FMA__)
#pragma GCC optimize("no-tree-vectorize")
#endif

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "kern/analysis.h"
#include "kern/c_arrays.h"
#include "kern/page.h"
#include "kern/picture.h"
#include "kern/report.h"
#include "kern/report_json.h"
#include "kern/state.h"
#include "kern/statements_file.h"
#include "kern/usage.h"
#include "parts/args.h"
#include "parts/text.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { EXIT_STANDS, EXIT_FALLS, EXIT_BAD, EXIT_UNDECIDED };

/* ---- Files --------------------------------------------------------------- */

/* After the first second: how far a long run has come, ten times a second. */
static void show_progress(const struct settings *set, int number, int *shown)
{
    static clock_t next = CLOCKS_PER_SEC;
    if (clock() < next || !ARGS_TERMINAL(2))
        return;
    next = clock() + CLOCKS_PER_SEC / 10;
    fprintf(stderr, "\rkern: file %d of %d ", number + 1, set->files);
    fflush(stderr);
    *shown = 1;
}

static void clear_progress(int *shown)
{
    if (*shown)
        fprintf(stderr, "\r%*s\r", 40, "");
    *shown = 0;
}

static int exit_status_of(const struct analysis *a)
{
    if (a->error[0])
        return EXIT_BAD;
    if (a->verdict < 0 || (!a->set->verdict_only && open_questions(a)))
        return EXIT_UNDECIDED;
    return a->verdict == KERN_FALLS ? EXIT_FALLS : EXIT_STANDS;
}

/* Refuses what the library would, with both numbers. */
static int too_many(struct analysis *a)
{
    if (a->text.blocks <= KERN_BLOCKS_MOST)
        return 0;
    return fail(a, 0, "%d blocks, at most %d are analysed", a->text.blocks,
                KERN_BLOCKS_MOST);
}

static void print_error(const struct analysis *a)
{
    if (!a->error[0])
        return;
    fflush(stdout); /* stdout and stderr may go to one log */
    fprintf(stderr, "%s:", a->file);
    if (a->line > 0)
        fprintf(stderr, "%d:", a->line);
    fprintf(stderr, " %s\n", a->error);
}

/* Writes the pictures and arrays asked for. Nonzero: one cannot be written. */
static int write_files(const struct analysis *a)
{
    int bad = a->set->svg && draw(a);
    if (a->set->svg && a->sweeps > 0)
        bad |= draw_sweep(a);
    if (a->set->kern_file)
        bad |= write_kern(a);
    if (a->set->page)
        bad |= write_page(a);
    return (a->set->c_file && write_c(a)) || bad;
}

/* A part of the report, for a person. */
static void show(const struct analysis *a,
                 void (*part)(const struct analysis *), int *shown)
{
    if (a->set->json)
        return;
    if (ARGS_TERMINAL(1))
        clear_progress(shown);
    part(a);
}

static int run_file(const struct settings *set, int number, int *shown)
{
    struct analysis a = {0};
    a.set = set;
    a.file = set->file[number];
    a.number = number;
    a.critical.contact = a.certain = -1;
    a.deficit = a.load[LEFT] = a.load[RIGHT] = a.tilt[LEFT] = a.tilt[RIGHT] =
        (double)NAN;
    int bad = read_structure(&a) || too_many(&a);
    if (!bad)
        show(&a, report_drawing, shown);
    bad = bad || analyse(&a);
    if (!bad)
        show(&a, report_verdict, shown);
    if (!bad && !set->verdict_only)
        measure(&a);
    show_stage(&a, "");
    if (a.error[0] || ARGS_TERMINAL(1))
        clear_progress(shown);
    int status = exit_status_of(&a);
    print_error(&a);
    if (set->json)
        report_json(&a);
    else if (!a.error[0] && !set->verdict_only)
        report(&a);
    if (!a.error[0] && write_files(&a))
        status = EXIT_BAD;
    free_analysis(&a);
    return status;
}

static int run(const struct settings *set)
{
    int count[4] = {0}, shown = 0;
    for (int i = 0; i < set->files; i++) {
        show_progress(set, i, &shown);
        count[run_file(set, i, &shown)]++;
    }
    clear_progress(&shown);
    if (set->files > 1 && !set->json)
        printf("%d files: %d stand, %d fall, %d undecided, %d bad\n",
               set->files, count[EXIT_STANDS], count[EXIT_FALLS],
               count[EXIT_UNDECIDED], count[EXIT_BAD]);
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "kern: cannot write the report: %s\n", strerror(errno));
        return EXIT_BAD;
    }
    return count[EXIT_BAD]       ? EXIT_BAD
         : count[EXIT_UNDECIDED] ? EXIT_UNDECIDED
         : count[EXIT_FALLS]     ? EXIT_FALLS
                                 : EXIT_STANDS;
}

/* ---- Command line -------------------------------------------------------- */

static int bad_use(const char *what, const char *word)
{
    fprintf(stderr, "kern: %s %s; try kern --help\n", what, word);
    return -1;
}

enum kind { POSITIVE, NOT_NEGATIVE, ANGLE, PLACES, UNITS, ANY, DEGREES };

static int is_of_kind(enum kind kind, double x)
{
    const int whole = !(floor(x) < x);
    switch (kind) {
    case POSITIVE: return x > 0;
    case NOT_NEGATIVE: return x >= 0;
    case ANGLE: return x >= 0 && x < 0.5;
    case PLACES: return whole && x >= 1 && x <= 10000;
    case ANY: return 1;
    case DEGREES: return x >= 5 && x <= 60;
    default: return whole && x >= 0 && x <= 2e9;
    }
}

static int number_option(const char *name, const char *value, enum kind kind,
                         kern_real *out)
{
    static const char *const what[] = {
        "positive number",
        "number not below zero",
        "angle in radians from 0 to below 0.5",
        "whole number from 1 to 10,000",
        "whole number from 1 to 2,000,000,000, or 0",
        "number",
        "angle in degrees from 5 to 60"};
    if (!value)
        return bad_use("a number is missing after", name);
    if (!text_number(value, out) || !is_of_kind(kind, (double)*out)) {
        fprintf(stderr, "kern: %s takes a%s %s, read '%s'\n", name,
                kind == ANGLE || kind == DEGREES ? "n" : "", what[kind], value);
        return -1;
    }
    return 0;
}

/* E or E,THETA */
static int error_option(const char *name, const char *value, kern_real *error,
                        kern_real *turn)
{
    char first[100];
    const char *comma = value ? strchr(value, ',') : NULL;
    size_t n = comma ? (size_t)(comma - value) : 0;
    if (!comma || n >= sizeof first)
        return number_option(name, value, POSITIVE, error);
    memcpy(first, value, n);
    first[n] = '\0';
    return number_option(name, first, POSITIVE, error)
                || number_option(name, comma + 1, ANGLE, turn)
             ? -1
             : 0;
}

/* A file that is written must end as such files do, so that none is written
   over a structure. */
static int output_option(const char *name, const char *file, const char *end)
{
    if (args_ends(file, end))
        return 0;
    if (!file || !file[0])
        return bad_use("a file name is missing after", name);
    fprintf(stderr, "kern: %s takes a name that ends in %s, read %s; %s\n",
            name, end, file,
            args_ends(file, ".png")
                ? "a browser or rsvg-convert makes a PNG of an SVG"
                : "try kern --help");
    return -1;
}

/* NAME=ROLE: the words stay where they are, for the readers of drawings. */
static int layer_option(struct settings *set, const char *value)
{
    const char *role = value ? strrchr(value, '=') : NULL;
    if (!role || role == value)
        return bad_use("NAME=ROLE is missing after", "--layer");
    if (shapes_role_named(role + 1, (int)strlen(role + 1)) < 0) {
        fprintf(stderr,
                "kern: --layer takes NAME=ground, NAME=stone, NAME=fill or "
                "NAME=ignore, read '%s'\n",
                value);
        return -1;
    }
    if (set->drawing.layers == LABELS_MOST)
        return bad_use("more than 100 options", "--layer");
    set->layer[set->drawing.layers++] = value;
    return 0;
}

/* D, or NAME=D. */
static int density_option(struct settings *set, const char *value)
{
    const char *number = value ? strrchr(value, '=') : NULL;
    kern_real density;
    if (number_option("--density", number ? number + 1 : value, POSITIVE,
                      &density))
        return -1;
    if (set->drawing.density_words == LABELS_MOST)
        return bad_use("more than 100 options", "--density");
    set->density[set->drawing.density_words++] = value;
    return 0;
}

/* MU, NAME=MU, or NAME,NAME=MU. */
static int mu_option(struct settings *set, const char *value)
{
    const char *number = value ? strrchr(value, '=') : NULL;
    kern_real mu;
    if (value && number == value)
        return bad_use("NAME=MU is missing after", "--mu");
    if (number_option("--mu", number ? number + 1 : value, NOT_NEGATIVE, &mu))
        return -1;
    if (!number)
        set->mu = mu;
    if (set->drawing.friction_words == LABELS_MOST)
        return bad_use("more than 100 options", "--mu");
    set->friction[set->drawing.friction_words++] = value;
    return 0;
}

/* An option of drawings and photographs. Returns 0 where it is fine, 1 where it
   is another one. */
static int drawing_option(struct settings *set, char **argv, int *i)
{
    const char *value;
    if (args_value(argv, i, "--layer", &value))
        return layer_option(set, value);
    if (args_value(argv, i, "--density", &value))
        return density_option(set, value);
    if (args_value(argv, i, "--mu", &value))
        return mu_option(set, value);
    if (args_value(argv, i, "--image", &set->drawing.image))
        return set->drawing.image
                 ? 0
                 : bad_use("the number or name of an image is missing after",
                           "--image");
    if (args_value(argv, i, "--ground", &value)) {
        set->drawing.has_ground = 1;
        return number_option("--ground", value, ANY, &set->ground);
    }
    if (args_value(argv, i, "--phi", &value))
        return number_option("--phi", value, DEGREES, &set->phi);
    if (args_value(argv, i, "--pixel", &value))
        return number_option("--pixel", value, POSITIVE, &set->pixel);
    return 1;
}

static int unknown_option(const char *word)
{
    char meant[USAGE_WORD + 1];
    usage_nearest(word, meant);
    if (!meant[0])
        return bad_use("unknown option", word);
    fprintf(stderr, "kern: unknown option %s; %s? try kern --help\n", word,
            meant);
    return -1;
}

/* An option with a name behind it. */
static int name_option(struct settings *set, char **argv, int *i)
{
    const struct {
        const char *name, **out, *missing;
    } text[] = {
        {"--stays", &set->stays, "a block, or all, is missing after"},
        {"--place", &set->place, "the file of a stone is missing after"},
        {"--thrust", &set->thrust, "a fixed block is missing after"},
        {"--title", &set->title, "a text is missing after"}};
    const char *word = argv[*i];
    for (size_t k = 0; k < sizeof text / sizeof *text; k++)
        if (args_value(argv, i, text[k].name, text[k].out))
            return *text[k].out && **text[k].out
                     ? 0
                     : bad_use(text[k].missing, text[k].name);
    if (args_value(argv, i, "--c", &set->c_file))
        return output_option("--c", set->c_file, ".h");
    if (args_value(argv, i, "--kern", &set->kern_file))
        return output_option("--kern", set->kern_file, ".kern");
    if (args_value(argv, i, "--report", &set->page))
        return output_option("--report", set->page, ".html");
    if (args_value(argv, i, "--svg", &set->svg))
        return output_option("--svg", set->svg, ".svg");
    return unknown_option(word);
}

/* Reads argv[*i], with what belongs to it; 0 where it is fine. */
static int read_option(void *settings, char **argv, int *i)
{
    struct settings *set = settings;
    struct {
        const char *name;
        enum kind kind;
        kern_real *out;
    } number[] = {{"--epsilon", POSITIVE, &set->epsilon},
                  {"-e", POSITIVE, &set->epsilon},
                  {"--gap", POSITIVE, &set->gap},
                  {"--at", NOT_NEGATIVE, &set->at},
                  {"--limit", UNITS, &set->limit},
                  {"--overlap", POSITIVE, &set->overlap},
                  {"--sweep", PLACES, &set->sweep},
                  {"--turns", PLACES, &set->turns},
                  {"--most", PLACES, &set->most}};
    struct {
        const char *name;
        int *out;
    } flag[] = {
        {"--relative", &set->relative}, {"-r", &set->relative},
        {"--forces", &set->forces},     {"--mechanism", &set->mechanism},
        {"--raised", &set->raised},     {"--sequence", &set->sequence},
        {"--profile", &set->profile},   {"--near", &set->touching},
        {"--json", &set->json},         {"--verdict", &set->verdict_only},
        {"--lone", &set->lone}};
    const char *word = argv[*i], *value;
    if (strcmp(word, "--mechanism") == 0 && argv[*i + 1]
        && strcmp(argv[*i + 1], "live") == 0) {
        set->mechanism = set->mechanism_live = 1;
        ++*i;
        return 0;
    }
    for (size_t k = 0; k < sizeof number / sizeof *number; k++)
        if (args_value(argv, i, number[k].name, &value))
            return number_option(number[k].name, value, number[k].kind,
                                 number[k].out);
    for (size_t k = 0; k < sizeof flag / sizeof *flag; k++)
        if (strcmp(word, flag[k].name) == 0) {
            *flag[k].out = 1;
            return 0;
        }
    if (args_value(argv, i, "--measured", &value))
        return error_option("--measured", value, &set->error, &set->turn);
    if (args_value(argv, i, "--error", &value))
        return error_option("--error", value, &set->own_error, &set->own_turn);
    const int taken = drawing_option(set, argv, i);
    return taken < 1 ? taken : name_option(set, argv, i);
}

/* With --relative shrinkage is a share of each contact. */
static int check_share(const struct settings *set, const char *name,
                       kern_real value)
{
    if (!set->relative || value <= 1)
        return 0;
    fprintf(stderr,
            "kern: with --relative %s takes a share up to 1, read "
            "%.9g\n",
            name, (double)value);
    return -1;
}

/* What drawings and photographs are read with; no file is written over, and no
   title is without its page. */
static int set_drawing(struct settings *set)
{
    set->drawing.layer = set->layer;
    set->drawing.densities = set->density;
    set->drawing.frictions = set->friction;
    set->drawing.ground = (double)set->ground;
    set->drawing.pixel = (double)set->pixel;
    set->drawing.phi = (double)set->phi;
    set->drawing.tolerance = 1.5;
    if (set->title && !set->page)
        return bad_use("--report OUT.html is missing beside", "--title");
    for (int i = 0; set->kern_file && i < set->files; i++)
        if (strcmp(set->kern_file, set->file[i]) == 0)
            return bad_use("--kern would write over", set->file[i]);
    return 0;
}

/* Returns all words after the first, up to NULL; the caller's to free. NULL where
   memory is lacking. */
static char **copy_words(int argc, char **argv)
{
    char **word = calloc((size_t)argc + 1, sizeof *word);
    for (int i = 1; i < argc && word; i++)
        word[i - 1] = argv[i];
    return word;
}

static int answer(int argc, char **argv, char **word)
{
    struct settings set = {0};
    set.epsilon = set.mu = set.gap = set.at = set.limit = set.overlap = -1;
    set.error = set.turn = set.own_error = set.own_turn = -1;
    set.turns = set.most = -1;
    set.file = argv;
    set.word = word;
    set.files = args_read(argc, argv, read_option, &set);
    if (set.files == ARGS_BAD)
        return EXIT_BAD;
    if (set.files == ARGS_HELP)
        return usage_print(argv[0], argv[1]) ? EXIT_BAD : EXIT_STANDS;
    if (set.files == ARGS_VERSION)
        return puts("kern " KERN_VERSION) < 0 ? EXIT_BAD : EXIT_STANDS;
    if (set.files == 0) {
        fputs("usage: kern [options] FILE...; try kern --help\n", stderr);
        return EXIT_BAD;
    }
    return set_drawing(&set) || check_share(&set, "--at", set.at)
                || check_share(&set, "--epsilon", set.epsilon)
             ? EXIT_BAD
             : run(&set);
}

int main(int argc, char **argv)
{
    char **word = copy_words(argc, argv); /* reading them moves files ahead */
    const int status = answer(argc, argv, word);
    free(word);
    return status;
}
