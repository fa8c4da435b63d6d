/* measures.h - everything that the library says about a structure, and how well
   numbers rank, for the example programs that compare it with shaking.

   measures_load() reads a file and finds its contacts, measures_all() fills one
   number for each measure of the list, all of them such that more is safer.
   rank_correlation() and rank_accuracy() say how well one list of numbers puts
   things in the order of another.

   SPDX-License-Identifier: MIT */

#ifndef MEASURES_H
#define MEASURES_H

#include "../../kern.h"
#include "../parts/room.h"
#include "../parts/text.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define MEASURES_API static __attribute__((unused))
#else
#define MEASURES_API static
#endif

/* ---- A structure with its contacts --------------------------------------- */

struct measures_of {
    struct text_file text;
    kern_task task;
    kern_contact *contact;
    kern_work work;
    kern_real *fate[3]; /* of each block: its margin, and its load
                               factors to the left and the right      */
};

static void measures_drop(struct measures_of *m)
{
    free(m->contact);
    m->contact = NULL;
    room_free_work(&m->work);
}

/* Finds the contacts with the options as they are, in room that grows until it
   is enough, and with it the work memory. Returns 0, or -1. */
MEASURES_API int measures_contacts(struct measures_of *m)
{
    int room = 16 * m->text.blocks + 64, found;
    do {
        measures_drop(m);
        m->contact = malloc((size_t)room * sizeof *m->contact);
        m->work = room_work(m->task.s.blocks, room);
        if (!m->contact || !m->work.real || !m->work.index)
            return -1;
        found = kern_contacts(m->text.block, m->text.blocks, &m->task.options,
                              m->contact, room, &m->work);
        room *= 2;
    } while (found == KERN_NO_SPACE && room < INT_MAX / 4);
    m->task.s.contact = m->contact;
    m->task.s.contacts = found;
    return found < 0 ? -1 : 0;
}

MEASURES_API void measures_free(struct measures_of *m)
{
    int k;
    for (k = 0; k < 3; k++)
        free(m->fate[k]);
    measures_drop(m);
    text_free(&m->text);
}

MEASURES_API int measures_load(struct measures_of *m, const char *path)
{
    static const struct measures_of empty;
    int k, bad = 0;
    *m = empty;
    if (text_load(&m->text, path))
        return -1;
    m->task = kern_task_of(m->text.block, m->text.blocks, NULL, 0, &m->work);
    m->task.options = m->text.options;
    m->task.s.gravity = m->text.gravity;
    for (k = 0; k < 3; k++) {
        m->fate[k] = calloc((size_t)m->task.s.blocks, sizeof *m->fate[k]);
        bad |= !m->fate[k];
    }
    return bad || measures_contacts(m) ? -1 : 0;
}

/* ---- The measures -------------------------------------------------------- */

#define MEASURES_LIST(X)                                                    \
    X(LEVEL, "level", "level")                                              \
    X(MARGIN, "margin", "margin")                                           \
    X(LOAD, "load", "load factor")                                          \
    X(TILT, "tilt", "tilt")                                                 \
    X(PROGRESSIVE_MARGIN, "progressive_margin", "progressive margin")       \
    X(PROGRESSIVE_LOAD, "progressive_load", "progressive load factor")      \
    X(WEAK_MARGIN, "weak_margin", "margin, weaker half")                    \
    X(WEAK_LOAD, "weak_load", "load factor, weaker half")                   \
    X(FRICTION, "low_friction_margin", "progressive margin, half friction") \
    X(NEAR_MARGIN, "near_margin", "near: margin")                           \
    X(NEAR_LOAD, "near_load", "near: load factor")                          \
    X(NEAR_PROGRESSIVE_MARGIN, "near_progressive_margin",                   \
      "near: progressive margin")                                           \
    X(NEAR_PROGRESSIVE_LOAD, "near_progressive_load",                       \
      "near: progressive load factor")                                      \
    X(NEAR_WEAK_MARGIN, "near_weak_margin", "near: margin, weaker half")    \
    X(NEAR_WEAK_LOAD, "near_weak_load", "near: load factor, weaker half")   \
    X(NEAR_DROP, "near_drop", "near: 1 / (1 + expected drop)")              \
    X(SLENDERNESS, "slenderness", "width over height")                      \
    X(STONES, "stones", "number of stones")

enum measures_kind {
#define MEASURES_KIND(id, name, words) MEASURE_##id,
    MEASURES_LIST(MEASURES_KIND)
#undef MEASURES_KIND
        MEASURES
};

static const char *const measures_name[] = {
#define MEASURES_NAME(id, name, words) name,
    MEASURES_LIST(MEASURES_NAME)
#undef MEASURES_NAME
};

static const char *const measures_words[] = {
#define MEASURES_WORDS(id, name, words) words,
    MEASURES_LIST(MEASURES_WORDS)
#undef MEASURES_WORDS
};

/* Margin, load factor and the two profiles, the load's as the mean of both
   sides, to out[0..6): what is asked of contacts as found and of near ones. */
enum {
    ASK_MARGIN,
    ASK_LOAD,
    ASK_MEAN_MARGIN,
    ASK_MEAN_LOAD,
    ASK_WEAK_MARGIN,
    ASK_WEAK_LOAD,
    ASK_DROP,
    ASKS
};

MEASURES_API int measures_profiles(struct measures_of *m, double out[ASKS])
{
    static const kern_side side[3] = {KERN_SHRINK, KERN_LEFT, KERN_RIGHT};
    kern_collapse all[3];
    int k;
    for (k = 0; k < 3; k++)
        if (kern_profile(&m->task, side[k], m->fate[k], &all[k]) != KERN_OK)
            return -1;
    out[ASK_MARGIN] = (double)all[0].least;
    out[ASK_LOAD] = fmin((double)all[1].least, (double)all[2].least);
    out[ASK_MEAN_MARGIN] = (double)all[0].mean;
    out[ASK_MEAN_LOAD] = ((double)all[1].mean + (double)all[2].mean) / 2;
    out[ASK_WEAK_MARGIN] = (double)all[0].weak;
    out[ASK_WEAK_LOAD] = ((double)all[1].weak + (double)all[2].weak) / 2;
    out[ASK_DROP] = 1 / (1 + (double)all[1].drop + (double)all[2].drop);
    return 0;
}

static double measures_slenderness(const kern_structure *s)
{
    double low[2] = {HUGE_VAL, HUGE_VAL}, high[2] = {-HUGE_VAL, -HUGE_VAL};
    int i, k;
    for (i = 0; i < s->blocks; i++)
        for (k = 0; k < s->block[i].vertices && !s->block[i].fixed; k++) {
            const kern_vec v = s->block[i].vertex[k];
            low[0] = fmin(low[0], (double)v.x);
            low[1] = fmin(low[1], (double)v.y);
            high[0] = fmax(high[0], (double)v.x);
            high[1] = fmax(high[1], (double)v.y);
        }
    return (high[0] - low[0]) / (high[1] - low[1]);
}

/* Progressive margin with half the friction at every contact. */
static int measures_low_friction(struct measures_of *m, double *out)
{
    kern_collapse all;
    kern_status status;
    int k;
    for (k = 0; k < m->task.s.contacts; k++)
        m->contact[k].mu /= 2;
    status = kern_profile(&m->task, KERN_SHRINK, m->fate[0], &all);
    for (k = 0; k < m->task.s.contacts; k++)
        m->contact[k].mu *= 2;
    *out = (double)all.mean;
    return status == KERN_OK ? 0 : -1;
}

/* Fills out[0..MEASURES). At the end contacts and `fate` are those of near
   contacts. Returns 0, or -1 where something is undecided or falls. */
MEASURES_API int measures_all(struct measures_of *m, double *out)
{
    const kern_options tight = m->task.options;
    double ask[ASKS], beside[ASKS];
    kern_margin margin;
    kern_real tilt[2];
    int i, k;
    if (kern_measure(&m->task, &margin, NULL) != KERN_STANDS
        || kern_tilt(&m->task, 0, KERN_LEFT, &tilt[0], NULL) != KERN_STANDS
        || kern_tilt(&m->task, 0, KERN_RIGHT, &tilt[1], NULL) != KERN_STANDS)
        return -1;
    if (measures_profiles(m, ask))
        return -1;
    if (measures_low_friction(m, &out[MEASURE_FRICTION]))
        return -1;
    m->task.options = kern_near(
        &tight, kern_mean_size(m->task.s.block, m->task.s.blocks));
    if (measures_contacts(m) || measures_profiles(m, beside))
        return -1;
    m->task.options = tight;
    out[MEASURE_LEVEL] = margin.level;
    out[MEASURE_TILT] = fmin((double)tilt[0], (double)tilt[1]);
    out[MEASURE_NEAR_DROP] = beside[ASK_DROP];
    for (k = 0; k < ASK_DROP; k++) {
        static const int place[ASK_DROP] = {MEASURE_MARGIN,
                                            MEASURE_LOAD,
                                            MEASURE_PROGRESSIVE_MARGIN,
                                            MEASURE_PROGRESSIVE_LOAD,
                                            MEASURE_WEAK_MARGIN,
                                            MEASURE_WEAK_LOAD};
        static const int place_beside[ASK_DROP] = {
            MEASURE_NEAR_MARGIN,
            MEASURE_NEAR_LOAD,
            MEASURE_NEAR_PROGRESSIVE_MARGIN,
            MEASURE_NEAR_PROGRESSIVE_LOAD,
            MEASURE_NEAR_WEAK_MARGIN,
            MEASURE_NEAR_WEAK_LOAD};
        out[place[k]] = ask[k];
        out[place_beside[k]] = beside[k];
    }
    out[MEASURE_SLENDERNESS] = measures_slenderness(&m->task.s);
    out[MEASURE_STONES] = 0;
    for (i = 0; i < m->task.s.blocks; i++)
        out[MEASURE_STONES] += !m->task.s.block[i].fixed;
    return 0;
}

/* ---- Ranks --------------------------------------------------------------- */

/* Ranks of x[0..n) to out, equal ones with the mean of their ranks. */
MEASURES_API void rank_of(const double *x, int n, double *out)
{
    int i, j;
    for (i = 0; i < n; i++) {
        int less = 0, same = 0;
        for (j = 0; j < n; j++) {
            less += x[j] < x[i];
            same += !(x[j] < x[i]) && !(x[j] > x[i]);
        }
        out[i] = less + (same - 1) / 2.0;
    }
}

/* The correlation of a and b, 0 where one of them is constant. */
MEASURES_API double rank_pearson(const double *a, const double *b, int n)
{
    double ma = 0, mb = 0, ab = 0, aa = 0, bb = 0;
    int i;
    for (i = 0; i < n; i++) {
        ma += a[i] / n;
        mb += b[i] / n;
    }
    for (i = 0; i < n; i++) {
        ab += (a[i] - ma) * (b[i] - mb);
        aa += (a[i] - ma) * (a[i] - ma);
        bb += (b[i] - mb) * (b[i] - mb);
    }
    return aa > 0 && bb > 0 ? ab / sqrt(aa * bb) : 0;
}

/* Spearman's rank correlation; room for 2 n numbers. */
MEASURES_API double rank_correlation(const double *a, const double *b, int n,
                                     double *room)
{
    rank_of(a, n, room);
    rank_of(b, n, room + n);
    return rank_pearson(room, room + n, n);
}

/* Of all pairs with different b, the share that a puts in the same order; a
   tie counts half. */
MEASURES_API double rank_accuracy(const double *a, const double *b, int n)
{
    double right = 0, all = 0;
    int i, j;
    for (i = 0; i < n; i++)
        for (j = 0; j < i; j++) {
            const double da = a[i] - a[j], db = b[i] - b[j];
            if (!(db < 0) && !(db > 0))
                continue;
            all++;
            right += da * db > 0 ? 1 : da * db < 0 ? 0 : 0.5;
        }
    return all > 0 ? right / all : 0;
}

#endif /* MEASURES_H */
