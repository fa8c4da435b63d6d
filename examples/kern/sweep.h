/* sweep.h - a live load that drives over the structure: its factor at each place.

   All statements `live` of the file move together, as the axles of a vehicle
   do, from where the last of them enters to where the first leaves. Each force
   stands on the upper outline, vertically above or below where it was; one that
   is beyond the structure carries nothing.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_SWEEP_H
#define PROGRAM_SWEEP_H

#include "../../kern.h"

#include "../parts/json.h"
#include "../parts/plot.h"
#include "asked.h"
#include "picture.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The highest point of the outlines at x. Returns its block; -1: there is
   none. */
static inline int sweep_top(const kern_structure *s, double x, double *y)
{
    int top = -1;
    for (int i = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        for (int k = 0; k < b->vertices; k++) {
            const kern_vec p = b->vertex[k];
            const kern_vec q = b->vertex[k + 1 < b->vertices ? k + 1 : 0];
            double at, along = x - (double)p.x;
            if ((p.x <= x) == (q.x <= x))
                continue;
            at = p.y + along * ((double)q.y - p.y) / ((double)q.x - p.x);
            if (top >= 0 && at <= *y)
                continue;
            *y = at;
            top = i;
        }
    }
    return top;
}

/* Over what the load drives: the free blocks. */
static inline int sweep_range(const struct analysis *a, double *low,
                              double *high)
{
    const kern_structure *s = &a->task.s;
    double first = HUGE_VAL, last = -HUGE_VAL;
    *low = HUGE_VAL;
    *high = -HUGE_VAL;
    for (int i = 0; i < s->blocks; i++) {
        if (s->block[i].fixed || s->block[i].vertices == 0)
            continue;
        *low = fmin(*low, (double)s->block[i].box.low.x);
        *high = fmax(*high, (double)s->block[i].box.high.x);
    }
    for (int k = 0; k < a->text.lives; k++) {
        first = fmin(first, (double)a->text.axle[k].place.x);
        last = fmax(last, (double)a->text.axle[k].place.x);
    }
    *low += (double)a->text.axle[0].place.x - last;
    *high += (double)a->text.axle[0].place.x - first;
    return *low < *high;
}

/* The pattern with the first force at x, and where that then stands. */
static inline void sweep_pattern(const struct analysis *a, double x,
                                 kern_wrench *pattern, struct swept *at)
{
    const kern_structure *s = &a->task.s;
    const double shift = x - (double)a->text.axle[0].place.x;
    memset(pattern, 0, sizeof *pattern * (size_t)s->blocks);
    at->x = x;
    for (int k = 0; k < a->text.lives; k++) {
        const struct text_live *axle = &a->text.axle[k];
        double y = 0;
        kern_vec place;
        const int i = sweep_top(s, (double)axle->place.x + shift, &y);
        if (k == 0) {
            at->block = i;
            at->y = i < 0 ? (double)NAN : y;
        }
        if (i < 0)
            continue;
        place.x = axle->place.x + (kern_real)shift;
        place.y = (kern_real)y;
        kern_block here = s->block[i];
        here.load = pattern[i];
        kern_block_load(&here, axle->force, place, 0);
        pattern[i] = here.load;
    }
}

/* Both factors with the load at x. */
static inline void sweep_at(struct analysis *a, double x, kern_wrench *pattern,
                            struct swept *at)
{
    kern_real value = 0;
    kern_status status;
    sweep_pattern(a, x, pattern, at);
    status = kern_load_factor_of(&a->task, shrinkage(a), pattern, &value, NULL);
    at->live = value_or_nan(status, value);
    at->raised = (double)NAN;
    if (a->raising != KERN_RAISED || a->raised != KERN_STANDS)
        return;
    status = kern_raised_load(&a->task, shrinkage(a), KERN_SHRINK, pattern,
                              &value, NULL);
    at->raised = value_or_nan(status, value);
    at->cut = status == KERN_LIMIT;
}

/* At places in the middle of equal parts of the way. */
static inline int find_sweep(struct analysis *a)
{
    const int places = (int)a->set->sweep;
    double low, high;
    kern_wrench *pattern;
    if (!sweep_range(a, &low, &high))
        return fail(a, 0, "--sweep: the blocks have no outline");
    if (a->shown != KERN_STANDS)
        return 0;
    pattern = array(a->task.s.blocks, sizeof *pattern);
    a->swept = array(places, sizeof *a->swept);
    for (int k = 0; k < places && pattern && a->swept; k++) {
        sweep_at(a, low + (k + 0.5) / places * (high - low), pattern,
                 &a->swept[k]);
        a->sweeps++;
    }
    free(pattern);
    return a->sweeps == places ? 0 : fail_memory(a);
}

/* The place with the least factor; -1: at none is it known. */
static inline int sweep_least(const struct analysis *a)
{
    int least = -1;
    for (int k = 0; k < a->sweeps; k++)
        if (a->swept[k].live < (least < 0 ? HUGE_VAL : a->swept[least].live))
            least = k;
    return least;
}

/* As the report has it: six digits. */
static inline void sweep_print(double value)
{
    if (isnan(value))
        printf(" %11s", "-");
    else if (isinf(value))
        printf(" %11s", "any");
    else
        printf(" %11.6g", value);
}

static inline void report_sweep(const struct analysis *a)
{
    const int least = sweep_least(a);
    char shown[TEXT_SHOW_ROOM];
    printf("  sweep       %11s %11s %11s", "x", "y", "live");
    printf(a->set->raised ? " %11s  on\n" : "  on\n", "raised live");
    for (int k = 0; k < a->sweeps; k++) {
        const struct swept *at = &a->swept[k];
        printf("             ");
        sweep_print(at->x);
        sweep_print(at->y);
        sweep_print(at->live);
        if (a->set->raised)
            sweep_print(at->raised);
        printf("  %s%s\n",
               at->block < 0 ? "-" : text_show(shown, a->text.name[at->block]),
               k == least ? "  least" : "");
    }
}

static inline void json_sweep(const struct analysis *a)
{
    printf(", \"sweep\": [");
    for (int k = 0; k < a->sweeps; k++) {
        const struct swept *at = &a->swept[k];
        printf("%s{", k > 0 ? ", " : "");
        if (at->block < 0)
            printf("\"block\": null");
        else
            json_string("block", a->text.name[at->block]);
        json_number("x", at->x);
        json_number("y", at->y);
        json_number("live", at->live);
        if (a->set->raised)
            json_number("raised_live", at->raised);
        printf("}");
    }
    printf("]");
}

/* A curve through the places where the factor is finite. */
static inline void sweep_curve(const struct analysis *a, const struct plot *p,
                               int raised, double *x, double *y)
{
    int n = 0;
    for (int k = 0; k < a->sweeps; k++) {
        y[n] = raised ? a->swept[k].raised : a->swept[k].live;
        x[n] = a->swept[k].x;
        n += isfinite(y[n]) != 0;
    }
    plot_curve(p, x, y, n, raised ? DRAW_FORCE : DRAW_INK, 1.6);
}

/* The factor over the place, up to four times the least. */
static inline int sweep_plot(const struct analysis *a, FILE *out)
{
    const int least = sweep_least(a), last = a->sweeps - 1;
    struct plot p = {0};
    double *x = array(2 * a->sweeps, sizeof *x);
    if (!x)
        return -1;
    p.x0 = a->swept[0].x;
    p.x1 = a->swept[last].x;
    p.y1 = least < 0 ? 1 : 4 * a->swept[least].live;
    plot_begin(&p, out,
               a->set->raised
                   ? "Live load: black limit analysis, red raised from rest"
                   : "Live load: factor at collapse",
               "place of the first force", "factor", 0);
    sweep_curve(a, &p, 0, x, x + a->sweeps);
    if (a->set->raised)
        sweep_curve(a, &p, 1, x, x + a->sweeps);
    free(x);
    return plot_end(&p);
}

/* OUT-sweep.svg beside the picture OUT.svg. */
static inline int draw_sweep(const struct analysis *a)
{
    FILE *out = NULL;
    char *picture = output_name(a, a->set->svg);
    const size_t n = picture ? strlen(picture) - strlen(".svg") : 0;
    char *path = picture ? (char *)malloc(n + sizeof "-sweep.svg") : NULL;
    if (path) {
        memcpy(path, picture, n);
        strcpy(path + n, "-sweep.svg");
        out = fopen(path, "w");
    }
    free(picture);
    return close_output(path, out, !out || sweep_plot(a, out));
}

#endif /* PROGRAM_SWEEP_H */
