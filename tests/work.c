/* work.c: how much work the library says that its questions take

       cc -O2 -ffp-contract=off -o work tests/work.c -lm
       ./work                        compares sums with tests/work.csv
       ./work --table >tests/work.csv    the table anew, after a change that is
                                     meant to change it
       ./work --each [LIST]          a line for each question to each structure,
                                     of the files that LIST names, or of all

   Each question is put once to each structure of the corpus (tests/CORPUS.md,
   in its two halves) and of the families of scenes.h. A sum is that of
   kern_work.units over the structures of one set: the same on every machine, so
   that a mechanism that stops working shows, which no answer does. A sum that is
   more than 3 % off the table fails, in either direction: what became cheaper
   needs a new table as well. Top-down passes and linear programs (solves)
   and pivots stand beside it for the reader.

   The questions: verdict at 0, measure, load factor and tilt to the right,
   raised with its reserve; and for up to three stones that carry none, the
   highest first: the measure of the wall without it (plan), the stone tried
   where it was (try), and whether the margin is 3/4, 5/4 of the whole structure's
   with it (bears).

   Units are blind to work that they do not count. Compiled with
   -DWORK_CALLGRIND and run under valgrind, each question is dumped under the
   name of its line, and tests/work.sh counts instructions; with the peers of
   peers.h one cold solve of theirs is a question too.

   SPDX-License-Identifier: MIT */

#include "questions.h"

#ifdef WORK_CALLGRIND
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS ((void)0)
#define CALLGRIND_DUMP_STATS_AT(name) ((void)(name))
#endif

#ifdef __has_feature
#if __has_feature(memory_sanitizer)
#include <sanitizer/msan_interface.h>
#define FORGET(array, count) \
    __msan_allocated_memory(array, (size_t)(count) * sizeof *(array))
#endif
#endif
#ifndef FORGET
#define FORGET(array, count) ((void)0)
#endif

#define ALLOWED 0.03 /* share by which a sum may be off the table       */
#define SUMS_MOST 400
#define TABLE "tests/work.csv"
#define HEADING "set,question,asked,undecided,units,solves,pivots"

/* Sums over one set and question. */
struct sum {
    char name[80]; /* set,question                                    */
    long asked, undecided, units, solves, pivots;
};

static struct sum sums[SUMS_MOST];
static int count;
static int each; /* a line a question is printed                    */

static struct sum *sum_of(const char *name)
{
    int i;
    for (i = 0; i < count; i++)
        if (strcmp(sums[i].name, name) == 0)
            return &sums[i];
    if (count == SUMS_MOST)
        give_up("too many sums");
    snprintf(sums[count].name, sizeof sums[count].name, "%s", name);
    return &sums[count++];
}

/* Work memory as new: under -fsanitize=memory what is read of it before it is
   written is an error. */
static void forget(const kern_work *work)
{
    FORGET(work->real, work->reals);
    FORGET(work->index, work->indices);
    (void)work;
}

/* Asks, and adds what it took to the sum of the set. */
static void put(struct ask *ask, const char *set, const char *question,
                ask_function *run)
{
    struct sum *sum;
    char name[200];
    ask->work.solves = ask->work.pivots = ask->work.units = 0;
    ask->number = 0;
    snprintf(name, sizeof name, "%s,%s", ask->scene->name, question);
    forget(&ask->work);
    CALLGRIND_ZERO_STATS;
    run(ask);
    CALLGRIND_DUMP_STATS_AT(name);
    if (each)
        printf("%s,%s,%d,%d,%d,%d,%d,%.9g\n", set, name, ask->scene->size,
               ask->status, ask->work.units, ask->work.solves, ask->work.pivots,
               (double)ask->number);
    snprintf(name, sizeof name, "%s,%s", set, question);
    sum = sum_of(name);
    sum->asked++;
    sum->undecided += ask->status < 0;
    sum->units += ask->work.units;
    sum->solves += ask->work.solves;
    sum->pivots += ask->work.pivots;
}

/* What a question of a margin found is a number, too. */
static void run_margin(struct ask *ask)
{
    run_measure(ask);
    ask->number = ask->margin.margin;
}

static void run_plan(struct ask *ask)
{
    ask->status = kern_measure(&ask->plan.task, &ask->with, NULL);
    ask->number = ask->with.margin;
}

static void run_tried(struct ask *ask)
{
    run_try(ask);
    ask->number = ask->with.margin;
}

static void ask_tops(struct ask *ask, const char *set)
{
    const double margin = ask->margin.margin;
    int top[TOPS], k;
    const int n = scene_tops(ask->scene, top, TOPS);
    for (k = 0; k < n; k++) {
        take_off(ask, top[k]);
        put(ask, set, "plan", run_plan);
        if (ask->status != KERN_STANDS)
            continue;
        put(ask, set, "try", run_tried);
        ask->least = margin * (k % 2 ? 1.25 : 0.75);
        put(ask, set, "bears", run_bears);
    }
}

/* One cold solve of each solver that was compiled in. */
static void ask_peers(struct ask *ask, const char *set)
{
    ask->shrink = 0;
    for (ask->peer = peers; ask->peer->name; ask->peer++) {
        open_lp(ask);
        put(ask, set, ask->peer->name, run_lp);
        close_lp(ask);
    }
}

static void ask_all(struct scene *scene, const char *set)
{
    struct ask ask;
    ask_open(&ask, scene);
    if (each && !scene->text.given)
        put(&ask, set, "contacts", run_contacts);
    put(&ask, set, "verdict", run_verdict);
    put(&ask, set, "measure", run_margin);
    if (ask.status == KERN_STANDS) {
        if (each)
            put(&ask, set, "floor", run_floor);
        put(&ask, set, "load", run_load);
        put(&ask, set, "tilt", run_tilt);
        put(&ask, set, "raised", run_raised);
    }
    if (!scene->text.given && scene->size > 3)
        ask_tops(&ask, set);
    ask_peers(&ask, set);
    ask_close(&ask);
    scene_close(scene);
}

static void ask_list(const char *name)
{
    FILE *list = list_open(name);
    const char *slash = strrchr(name, '/');
    char path[1000], set[200];
    struct scene scene;
    while (list_next(list, path, (int)sizeof path)) {
        scene_read(&scene, path);
        snprintf(set, sizeof set, "%.*s %s", (int)strcspn(scene.name, "/"),
                 scene.name, slash ? slash + 1 : name);
        set[strcspn(set, ".")] = 0;
        ask_all(&scene, set);
    }
    fclose(list);
}

static void ask_families(void)
{
    static const int size[] = {5, 10, 20, 30, 50, 100, 200};
    struct scene scene;
    int family, i, number;
    for (family = 0; family < FAMILIES; family++)
        for (i = 0; i < (int)(sizeof size / sizeof size[0]); i++)
            for (number = 0; number < 2; number++) {
                scene_make(&scene, family, size[i], number);
                ask_all(&scene, families[family].name);
            }
}

static void print_table(void)
{
    int i;
    printf("%s\n", HEADING);
    for (i = 0; i < count; i++) {
        const struct sum *s = &sums[i];
        printf("%s,%ld,%ld,%ld,%ld,%ld\n", s->name, s->asked, s->undecided,
               s->units, s->solves, s->pivots);
    }
}

/* Prints a sum that differs from the table. Returns whether it agrees. */
static int compare_one(const struct sum *got, const struct sum *want)
{
    const double ratio = want->units > 0
                           ? (double)got->units / (double)want->units
                       : got->units > 0 ? 99
                                        : 1;
    const int same = got->asked == want->asked
                  && got->undecided == want->undecided
                  && fabs(ratio - 1) <= ALLOWED;
    if (!same)
        printf("%-24s %9ld units for %9ld: %6.3f; %ld asked for %ld; %ld "
               "undecided for %ld\n",
               got->name, got->units, want->units, ratio, got->asked,
               want->asked, got->undecided, want->undecided);
    return same;
}

/* Whether all sums are those of the table. */
static int compare(void)
{
    FILE *table = list_open(TABLE);
    char line[300];
    struct sum want;
    int rows = 0, same = 0;
    while (list_next(table, line, (int)sizeof line)) {
        if (strcmp(line, HEADING) == 0)
            continue;
        memset(&want, 0, sizeof want);
        if (sscanf(line, "%79[^,]", want.name) != 1)
            give_up("a bad row in " TABLE);
        snprintf(want.name, sizeof want.name, "%.*s",
                 (int)(strcspn(line, ",") + 1
                       + strcspn(line + strcspn(line, ",") + 1, ",")),
                 line);
        if (sscanf(line + strlen(want.name), ",%ld,%ld,%ld,%ld,%ld",
                   &want.asked, &want.undecided, &want.units, &want.solves,
                   &want.pivots)
            != 5)
            give_up("a bad row in " TABLE);
        rows++;
        same += compare_one(sum_of(want.name), &want);
    }
    fclose(table);
    printf("%d of %d sums within 3 %% of " TABLE "\n", same, rows);
    return same == rows && rows == count;
}

int main(int argc, char **argv)
{
    const int table = argc == 2 && strcmp(argv[1], "--table") == 0;
    each = argc >= 2 && strcmp(argv[1], "--each") == 0;
    if (argc > 1 && !table && !each) {
        fprintf(stderr, "usage: work [--table | --each [LIST]]\n");
        return 2;
    }
    if (argc == 3) {
        ask_list(argv[2]);
    } else {
        ask_list("tests/corpus/odd.txt");
        ask_list("tests/corpus/even.txt");
        ask_families();
    }
    if (table)
        print_table();
    return table || each || compare() ? 0 : 1;
}
