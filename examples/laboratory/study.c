/* study - which measure predicts collapse under shaking?

   Reads a set of structures that were shaken, measures each of them without
   shaking, and says how well each measure ranks the levels at which they
   collapsed: rank correlation with its interval, the share of pairs in the
   right order, by family and by irregularity; and whether the values of single
   stones tell which of them move first.

       cc -O2 -ffp-contract=off -o study examples/laboratory/study.c -lm
       ./study --svg pictures FOLDER

   FOLDER holds labels.csv (columns name, family, irregularity, level),
   structures/NAME.kern, and if the stones were watched stones.csv (columns
   name, stone, level). Levels are such that more is safer.

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/draw.h"
#include "measures.h"
#include "../parts/plot.h"

#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROOM = 4096, WORD = 64, RESAMPLES = 1000, KINDS = 32 };

static const char help[] =
    "usage: study [--svg DIR] [--csv FILE] [--tune] FOLDER\n"
    "Says how well static measures rank the structures of FOLDER by the level of\n"
    "shaking at which they collapsed. Prints tables in Markdown.\n"
    "  --svg DIR   a scatter plot of each measure, in an existing folder\n"
    "  --csv FILE  every measure of every structure\n"
    "  --tune      also a grid of gaps and angles of near contacts: the best on one\n"
    "              half of the structures is judged on the other\n";

struct entry {
    char name[WORD], family[WORD], irregularity[WORD];
    double level;
    double *value; /* MEASURES numbers                            */
    int stones;
    char (*stone)[WORD]; /* names of its stones                         */
    double *fate;        /* of each stone: near load factor             */
    double *moved;       /* level at which each first moved, NAN: unknown */
};

struct study {
    const char *folder, *svg, *csv;
    int tune, entries;
    struct entry *entry;
};

/* ---- Reading ------------------------------------------------------------- */

/* The word in a column of a line of CSV. */
static void csv_word(const char *line, int column, char out[WORD])
{
    int n = 0;
    while (column > 0 && *line)
        if (*line++ == ',')
            column--;
    while (*line && *line != ',' && *line != '\n' && *line != '\r'
           && n < WORD - 1)
        out[n++] = *line++;
    out[n] = '\0';
}

/* The column with a name in the first line, -1: none. */
static int csv_column(const char *head, const char *name)
{
    char word[WORD];
    int columns = 1;
    for (const char *s = head; *s; s++)
        columns += *s == ',';
    for (int i = 0; i < columns; i++) {
        csv_word(head, i, word);
        if (strcmp(word, name) == 0)
            return i;
    }
    return -1;
}

static FILE *open_csv(const struct study *y, const char *name, char line[ROOM])
{
    char path[ROOM];
    FILE *in;
    snprintf(path, sizeof path, "%s/%s", y->folder, name);
    in = fopen(path, "r");
    if (in && !fgets(line, ROOM, in)) {
        fclose(in);
        in = NULL;
    }
    return in;
}

static int read_labels(struct study *y)
{
    char line[ROOM], word[WORD];
    FILE *in = open_csv(y, "labels.csv", line);
    int column[4], room = 0, known = 1;
    static const char *const names[4] = {"name", "family", "irregularity",
                                         "level"};
    if (!in)
        return -1;
    for (int i = 0; i < 4; i++) {
        column[i] = csv_column(line, names[i]);
        known &= column[i] >= 0;
    }
    while (known && fgets(line, ROOM, in)) {
        struct entry e = {"", "", "", 0, NULL, 0, NULL, NULL, NULL};
        if (y->entries == room) {
            struct entry *more;
            room = 2 * room + 64;
            more = realloc(y->entry, (size_t)room * sizeof *more);
            if (!more)
                break;
            y->entry = more;
        }
        csv_word(line, column[0], e.name);
        csv_word(line, column[1], e.family);
        csv_word(line, column[2], e.irregularity);
        csv_word(line, column[3], word);
        e.level = strtod(word, NULL);
        y->entry[y->entries++] = e;
    }
    fclose(in);
    return y->entries > 0 ? 0 : -1;
}

static int structure_load(const struct study *y, const struct entry *e,
                          struct measures_of *m)
{
    char path[ROOM];
    snprintf(path, sizeof path, "%s/structures/%s.kern", y->folder, e->name);
    if (measures_load(m, path) == 0)
        return 0;
    fprintf(stderr, "study: %s: %s\n", path,
            m->text.message[0] ? m->text.message : "cannot be read");
    return -1;
}

/* Measures one structure, and keeps the load factors of its stones. */
static int measure_entry(const struct study *y, struct entry *e)
{
    struct measures_of m;
    int bad = structure_load(y, e, &m);
    e->value = calloc(MEASURES, sizeof *e->value);
    bad = bad || !e->value || measures_all(&m, e->value);
    e->stone = calloc((size_t)m.task.s.blocks + 1, sizeof *e->stone);
    e->fate = calloc((size_t)m.task.s.blocks + 1, sizeof *e->fate);
    e->moved = calloc((size_t)m.task.s.blocks + 1, sizeof *e->moved);
    bad = bad || !e->stone || !e->fate || !e->moved;
    for (int i = 0; i < m.task.s.blocks && !bad; i++) {
        if (m.task.s.block[i].fixed)
            continue;
        snprintf(e->stone[e->stones], WORD, "%s", m.text.name[i]);
        e->moved[e->stones] = (double)NAN;
        e->fate[e->stones++] = ((double)m.fate[1][i] + (double)m.fate[2][i])
                             / 2;
    }
    measures_free(&m);
    return bad ? -1 : 0;
}

static void read_stones(struct study *y)
{
    char line[ROOM], name[WORD], stone[WORD], word[WORD];
    FILE *in = open_csv(y, "stones.csv", line);
    int a, b, c, at = 0;
    if (!in)
        return;
    a = csv_column(line, "name");
    b = csv_column(line, "stone");
    c = csv_column(line, "level");
    while (a >= 0 && b >= 0 && c >= 0 && fgets(line, ROOM, in)) {
        csv_word(line, a, name);
        csv_word(line, b, stone);
        csv_word(line, c, word);
        for (int tries = 0;
             tries < y->entries && strcmp(y->entry[at].name, name) != 0;
             tries++)
            at = (at + 1) % y->entries;
        for (int i = 0; i < y->entry[at].stones; i++)
            if (strcmp(y->entry[at].stone[i], stone) == 0)
                y->entry[at].moved[i] = strtod(word, NULL);
    }
    fclose(in);
}

/* ---- Tables -------------------------------------------------------------- */

/* Measure k and level of the entries that are chosen (NULL: of all). */
static int columns_of(const struct study *y, int k, const char *chosen,
                      double *a, double *b)
{
    int n = 0;
    for (int i = 0; i < y->entries; i++)
        if (!chosen || chosen[i]) {
            a[n] = y->entry[i].value[k];
            b[n++] = y->entry[i].level;
        }
    return n;
}

static int ascending(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* The middle 95 % of the correlations of as many structures, drawn again and
   again out of them. */
static void bootstrap(const double *a, const double *b, int n, double *room,
                      double ends[2])
{
    double found[RESAMPLES], *x = room, *z = room + n;
    uint64_t state = 1;
    for (int r = 0; r < RESAMPLES; r++) {
        for (int i = 0; i < n; i++) {
            int from;
            state = state * UINT64_C(6364136223846793005)
                  + UINT64_C(1442695040888963407);
            from = (int)((state >> 33) % (uint64_t)n);
            x[i] = a[from];
            z[i] = b[from];
        }
        found[r] = rank_correlation(x, z, n, room + 2 * n);
    }
    qsort(found, RESAMPLES, sizeof found[0], ascending);
    ends[0] = found[RESAMPLES / 40];
    ends[1] = found[RESAMPLES - 1 - RESAMPLES / 40];
}

/* One of two halves, in no order that families or sizes might have. */
static int half_of(int entry)
{
    return (int)((unsigned)entry * 2654435761u >> 16 & 1);
}

static void choose_half(const struct study *y, int half, char *chosen)
{
    for (int i = 0; i < y->entries; i++)
        chosen[i] = half_of(i) == half;
}

static void table_overall(const struct study *y, double *room, char *chosen)
{
    const int n = y->entries;
    double *a = room, *b = room + n, *rest = room + 2 * n;
    printf("| measure | rank correlation | 95 %% interval | pairs in order | "
           "first half | second half |\n|---|---|---|---|---|---|\n");
    for (int k = 0; k < MEASURES; k++) {
        double ends[2], half[2];
        for (int h = 0; h < 2; h++) {
            choose_half(y, h, chosen);
            half[h] = rank_correlation(a, b, columns_of(y, k, chosen, a, b),
                                       rest);
        }
        columns_of(y, k, NULL, a, b);
        bootstrap(a, b, n, rest, ends);
        printf("| %s | %.2f | %.2f .. %.2f | %.2f | %.2f | %.2f |\n",
               measures_words[k], rank_correlation(a, b, n, rest), ends[0],
               ends[1], rank_accuracy(a, b, n), half[0], half[1]);
    }
}

/* The same, for the entries with each word in one of two columns. */
static void table_by(const struct study *y, int by_family, double *room,
                     char *chosen)
{
    char kind[KINDS][WORD];
    int kinds = 0, n = y->entries;
    double *a = room, *b = room + n, *rest = room + 2 * n;
    for (int i = 0; i < n; i++) {
        const char *w = by_family ? y->entry[i].family
                                  : y->entry[i].irregularity;
        int k = 0;
        while (k < kinds && strcmp(kind[k], w) != 0)
            k++;
        if (k == kinds && kinds < KINDS)
            strcpy(kind[kinds++], w);
    }
    printf("| %s |", by_family ? "family" : "irregularity");
    for (int j = 0; j < kinds; j++)
        printf(" %s |", kind[j]);
    printf("\n|---|");
    for (int j = 0; j < kinds; j++)
        printf("---|");
    printf("\n");
    for (int k = 0; k < MEASURES; k++) {
        printf("| %s |", measures_words[k]);
        for (int j = 0; j < kinds; j++) {
            for (int i = 0; i < n; i++)
                chosen[i] = strcmp(kind[j], by_family
                                                ? y->entry[i].family
                                                : y->entry[i].irregularity)
                         == 0;
            printf(" %.2f |", rank_correlation(
                                  a, b, columns_of(y, k, chosen, a, b), rest));
        }
        printf("\n");
    }
}

/* Within each structure: does the near load factor of a stone rank when it
   moves, and is the first stone to move among the weakest quarter? */
static void table_stones(const struct study *y)
{
    double sum = 0, right = 0, chance = 0;
    int counted = 0;
    for (int i = 0; i < y->entries; i++) {
        const struct entry *e = &y->entry[i];
        double *room = calloc(2 * (size_t)e->stones + 1, sizeof *room);
        int known = room != NULL && e->stones > 3, first = 0, weaker = 0;
        for (int k = 0; k < e->stones && known; k++) {
            known &= !isnan(e->moved[k]);
            if (e->moved[k] < e->moved[first])
                first = k;
        }
        for (int k = 0; k < e->stones && known; k++)
            weaker += e->fate[k] < e->fate[first];
        if (known) {
            sum += rank_correlation(e->fate, e->moved, e->stones, room);
            right += 4 * weaker < e->stones;
            chance += (e->stones + 3) / 4 / (double)e->stones;
            counted++;
        }
        free(room);
    }
    if (counted == 0)
        return;
    printf("\nOf the stones of one structure, in %d structures: mean rank "
           "correlation of a stone's\nload factor with the level at which it "
           "moves %.2f; the first to move is in the\nweakest quarter in "
           "%.0f %% (by chance, %.0f %%).\n",
           counted, sum / counted, 100 * right / counted,
           100 * chance / counted);
}

/* ---- The gap and the angle of near contacts ------------------------------ */

/* The correlation of the expected drop, in each half of the
   structures, with contacts of a gap (in mean sizes) and an angle. */
static int tune_one(const struct study *y, double gap, double angle,
                    double *room, double out[2])
{
    const int n = y->entries;
    double *value = room, *a = room + n, *b = room + 2 * n;
    for (int i = 0; i < n; i++) {
        struct measures_of m;
        double ask[ASKS];
        int bad = structure_load(y, &y->entry[i], &m);
        double size = (double)kern_mean_size(m.task.s.block, m.task.s.blocks);
        if (gap > 0)
            m.task.options.gap = (kern_real)(gap * size);
        if (angle > 0)
            m.task.options.angle = (kern_real)angle;
        bad = bad || measures_contacts(&m) || measures_profiles(&m, ask);
        measures_free(&m);
        if (bad)
            return -1;
        value[i] = ask[ASK_DROP];
    }
    for (int half = 0; half < 2; half++) {
        int k = 0;
        for (int i = 0; i < n; i++) {
            if (half_of(i) != half)
                continue;
            a[k] = value[i];
            b[k++] = y->entry[i].level;
        }
        out[half] = rank_correlation(a, b, k, room + 3 * n);
    }
    return 0;
}

static int table_tune(const struct study *y, double *room)
{
    static const double gap[] = {0, 0.01, 0.02, 0.03, 0.04, 0.06};
    static const double angle[] = {0, 0.05, 0.1, 0.15, 0.2};
    double best = -1, judged = 0;
    int bg = 0, ba = 0;
    printf("\n| gap \\ angle |");
    for (int j = 0; j < 5; j++)
        printf(angle[j] > 0 ? " %g |" : " as found |", angle[j]);
    printf("\n|---|---|---|---|---|---|\n");
    for (int i = 0; i < 6; i++) {
        printf(gap[i] > 0 ? "| %g |" : "| as found |", gap[i]);
        for (int j = 0; j < 5; j++) {
            double half[2];
            if (tune_one(y, gap[i], angle[j], room, half))
                return -1;
            printf(" %.2f, %.2f |", half[0], half[1]);
            if (half[0] > best) {
                best = half[0];
                judged = half[1];
                bg = i;
                ba = j;
            }
        }
        printf("\n");
    }
    printf("\nBest on the first half: gap %g, angle %g, %.2f; on the second "
           "half that is %.2f.\n",
           gap[bg], angle[ba], best, judged);
    return 0;
}

/* ---- Files --------------------------------------------------------------- */

static int write_csv(const struct study *y)
{
    FILE *out = fopen(y->csv, "w");
    if (!out)
        return -1;
    fprintf(out, "name,family,irregularity,collapse");
    for (int k = 0; k < MEASURES; k++)
        fprintf(out, ",%s", measures_name[k]);
    fprintf(out, "\n");
    for (int i = 0; i < y->entries; i++) {
        const struct entry *e = &y->entry[i];
        fprintf(out, "%s,%s,%s,%g", e->name, e->family, e->irregularity,
                e->level);
        for (int k = 0; k < MEASURES; k++)
            fprintf(out, ",%.6g", e->value[k]);
        fprintf(out, "\n");
    }
    return fclose(out) ? -1 : 0;
}

static const char *unit_of(int measure)
{
    switch (measure) {
    case MEASURE_MARGIN:
    case MEASURE_PROGRESSIVE_MARGIN:
    case MEASURE_WEAK_MARGIN:
    case MEASURE_FRICTION:
    case MEASURE_NEAR_MARGIN:
    case MEASURE_NEAR_PROGRESSIVE_MARGIN:
    case MEASURE_NEAR_WEAK_MARGIN: return ", in units of length";
    case MEASURE_LOAD:
    case MEASURE_PROGRESSIVE_LOAD:
    case MEASURE_WEAK_LOAD:
    case MEASURE_NEAR_LOAD:
    case MEASURE_NEAR_PROGRESSIVE_LOAD:
    case MEASURE_NEAR_WEAK_LOAD: return ", g";
    case MEASURE_TILT: return ", rad";
    default: return "";
    }
}

static int write_scatter(const struct study *y, int k, double *room)
{
    const int n = y->entries;
    double *a = room, *b = room + n;
    struct plot p = {NULL, 0, 0, 0, 0, 0, 0, 0, 0};
    char name[80], title[160], axis[160], shade[8];
    FILE *out;
    int skip;
    snprintf(name, sizeof name, "scatter-%s.svg", measures_name[k]);
    out = plot_open(y->svg, name);
    if (!out)
        return -1;
    columns_of(y, k, NULL, a, b);
    for (int i = 0; i < n; i++) {
        p.x1 = fmax(p.x1, a[i]);
        p.y1 = fmax(p.y1, b[i]);
    }
    snprintf(title, sizeof title, "Rank correlation %.2f, %d structures",
             rank_correlation(a, b, n, room + 2 * n), n);
    skip = strncmp(measures_words[k], "near: ", 6) == 0 ? 6 : 0;
    snprintf(axis, sizeof axis, "%s%s%s", measures_words[k] + skip, unit_of(k),
             skip ? " (near contacts counted)" : "");
    plot_begin(&p, out, title, axis,
               "level of shaking at collapse (after the last: never)", 70);
    for (int i = 0; i < n; i++)
        plot_point(
            &p, a[i], b[i],
            draw_shade(1 - strtod(y->entry[i].irregularity, NULL) / 50, shade));
    plot_colours(&p, 50, 0, "irregularity of the stones, %");
    return plot_end(&p) | (fclose(out) ? -1 : 0);
}

static int write_files(const struct study *y, double *room)
{
    int bad = y->csv ? write_csv(y) : 0;
    for (int k = 0; k < MEASURES && y->svg; k++)
        bad |= write_scatter(y, k, room);
    if (bad)
        fprintf(stderr, "study: cannot write %s\n", y->svg ? y->svg : y->csv);
    return bad;
}

static int run(struct study *y)
{
    double *room;
    char *chosen;
    int bad = 0;
    if (read_labels(y)) {
        fprintf(stderr, "study: cannot read %s/labels.csv\n", y->folder);
        return -1;
    }
    for (int i = 0; i < y->entries && !bad; i++) {
        bad = measure_entry(y, &y->entry[i]);
        if (bad)
            fprintf(stderr, "study: no measure of %s\n", y->entry[i].name);
    }
    if (!bad)
        read_stones(y);
    room = calloc(8 * (size_t)y->entries, sizeof *room);
    chosen = calloc((size_t)y->entries, 1);
    bad = bad || !room || !chosen;
    if (!bad) {
        printf("%d structures\n\n", y->entries);
        if (y->entries < 20)
            printf("Fewer than 20: correlations mean little.\n\n");
        table_overall(y, room, chosen);
        printf("\n");
        table_by(y, 0, room, chosen);
        printf("\n");
        table_by(y, 1, room, chosen);
        table_stones(y);
        if (y->tune)
            bad = table_tune(y, room);
        bad |= write_files(y, room);
    }
    free(room);
    free(chosen);
    for (int i = 0; i < y->entries; i++) {
        free(y->entry[i].value);
        free(y->entry[i].stone);
        free(y->entry[i].fate);
        free(y->entry[i].moved);
    }
    free(y->entry);
    return bad;
}

int main(int argc, char **argv)
{
    struct study y = {NULL, NULL, NULL, 0, 0, NULL};
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--help") == 0)
            return fputs(help, stdout) < 0 ? 2 : 0;
        if (strcmp(argv[i], "--tune") == 0)
            y.tune = 1;
        else if (strcmp(argv[i], "--svg") == 0 && i + 1 < argc)
            y.svg = argv[++i];
        else if (strcmp(argv[i], "--csv") == 0 && i + 1 < argc)
            y.csv = argv[++i];
        else if (argv[i][0] != '-' && !y.folder)
            y.folder = argv[i];
        else
            y.folder = NULL, i = argc;
    }
    if (!y.folder) {
        fputs(help, stderr);
        return 2;
    }
    return run(&y) || fflush(stdout) ? 2 : 0;
}
