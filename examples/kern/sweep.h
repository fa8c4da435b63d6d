/* sweep.h - a live load that drives over the structure: its factor at each place.

   All statements `live` of the file move together, as the axles of a vehicle
   do, from where the last of them enters to where the first leaves. Each force
   stands on the upper outline, vertically above or below where it was; one that
   is beyond the structure carries nothing. Axles spread through fill at each
   place, and bear on the structure from beside it. The place with the least factor
   is found, and added.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_SWEEP_H
#define PROGRAM_SWEEP_H

#include "../../kern.h"

#include "../parts/json.h"
#include "../parts/plot.h"
#include "asked.h"
#include "crush.h"
#include "let_go.h"
#include "loads.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What places are tried with. */
struct sweep {
    struct analysis *a;
    struct text_surface above; /* the upper outline, of the joints         */
    kern_wrench *pattern;
    double low, high; /* between these the first force drives              */
};

enum {
    SWEEP_PLACES = 2500, /* that are tried at most, but for a few          */
    SWEEP_PARTS = 4,     /* tried from joint to joint, under fill          */
    SWEEP_CUTS = 12,     /* steps of the search between two places         */
    SWEEP_EDGES = 24     /* places whose factor let go is found to .1 %    */
};

/* Share by which a path of loading may end below what it bears. */
#define SWEEP_NARROW 0.01

/* The forces that move: statements live, then axles. */
static inline int sweep_lives(const struct analysis *a)
{
    return a->text.lives - a->text.spread;
}

static inline int sweep_forces(const struct analysis *a)
{
    return sweep_lives(a) + a->text.wheels;
}

/* Where force k stands in the file. */
static inline double sweep_place(const struct analysis *a, int k)
{
    const int lives = sweep_lives(a);
    return k < lives ? (double)a->text.axle[k].place.x
                     : a->text.wheel[k - lives].x;
}

/* Returns how far beside a stone, down to the level `low`, force k still bears on
   it: an axle by half its width, and through fill by the spread on the way
   down. */
static inline double sweep_reach(const struct analysis *a, int k, double low)
{
    const int lives = sweep_lives(a);
    double reach = k < lives ? 0 : a->text.wheel[k - lives].width / 2, most = 0;
    for (int i = 0; i < a->text.soils && k >= lives; i++)
        if (a->text.soil[i].kind == TEXT_FILL)
            most = fmax(most, a->text.soil[i].earth.top - low);
    return reach + most * tan(TEXT_CONE);
}

/* Finds over what the load drives: the free blocks, and as far beside them as it
   bears on them. */
static inline int sweep_range(struct sweep *w)
{
    const struct analysis *a = w->a;
    const kern_structure *s = &a->task.s;
    double left = HUGE_VAL, right = -HUGE_VAL, foot = HUGE_VAL;
    w->low = HUGE_VAL;
    w->high = -HUGE_VAL;
    for (int i = 0; i < stones(a); i++) {
        if (s->block[i].fixed || s->block[i].vertices == 0)
            continue;
        left = fmin(left, (double)s->block[i].box.low.x);
        right = fmax(right, (double)s->block[i].box.high.x);
        foot = fmin(foot, (double)s->block[i].box.low.y);
    }
    for (int k = 0; k < sweep_forces(a); k++) {
        const double to = sweep_place(a, 0) - sweep_place(a, k);
        const double reach = sweep_reach(a, k, foot);
        w->low = fmin(w->low, left - reach + to);
        w->high = fmax(w->high, right + reach + to);
    }
    return w->low < w->high;
}

/* The pattern with the first force at x, and where that then stands. */
static inline void sweep_pattern(struct sweep *w, double x, struct swept *at)
{
    const struct analysis *a = w->a;
    const kern_structure *s = &a->task.s;
    const double shift = x - sweep_place(a, 0);
    memset(w->pattern, 0, sizeof *w->pattern * (size_t)s->blocks);
    at->x = x;
    at->y = (double)NAN;
    at->block = sweep_top(a, x, &at->y);
    for (int k = 0; k < sweep_lives(a); k++) {
        const struct text_live *axle = &a->text.axle[k];
        double y = 0;
        kern_vec place;
        const int i = sweep_top(a, (double)axle->place.x + shift, &y);
        if (i < 0)
            continue;
        place.x = axle->place.x + (kern_real)shift;
        place.y = (kern_real)y;
        kern_block here = s->block[i];
        here.load = w->pattern[i];
        kern_block_load(&here, axle->force, place, 0);
        w->pattern[i] = here.load;
    }
    text_axles(&a->text, shift, w->pattern);
}

/* The factor of limit analysis with the load at x. */
static inline void sweep_factor(struct sweep *w, double x, struct swept *at)
{
    kern_real value = 0;
    kern_status status;
    sweep_pattern(w, x, at);
    status = crush_factor(w->a, &w->a->task, w->pattern, NULL, &value);
    at->live = value_or_nan(status, value);
    at->raised = (double)NAN;
    at->cut = at->edge = 0;
}

/* Are the factors at which it stays when it is let go asked for as well? Without
   the live load it must stay, so that a path leads there from rest. */
static inline int sweeps_let_go(const struct analysis *a)
{
    return asks_raised_loads(a) && a->let_go == KERN_STANDS;
}

/* Both factors with the load at x. */
static inline void sweep_at(struct sweep *w, double x, struct swept *at)
{
    struct analysis *a = w->a;
    kern_real value = 0;
    kern_status status;
    sweep_factor(w, x, at);
    if (!sweeps_let_go(a))
        return;
    status = kern_raised_load(&a->task, shrinkage(a), KERN_SHRINK, w->pattern,
                              &value, NULL);
    at->raised = value_or_nan(status, value);
    if (at->raised > at->live)
        at->raised = at->live;
    at->cut = status == KERN_LIMIT;
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

/* The place with the least factor at which it stays when it is let go, where such
   factors are asked for; that of limit analysis otherwise. -1: at none is it
   known. */
static inline int sweep_governs(const struct analysis *a)
{
    int least = -1;
    if (!sweeps_let_go(a))
        return sweep_least(a);
    for (int k = 0; k < a->sweeps; k++)
        if (a->swept[k].raised
            < (least < 0 ? HUGE_VAL : a->swept[least].raised * (1 - 1e-9)))
            least = k;
    return least;
}

/* How many places have no factor that is shown when it is let go. */
static inline int sweep_hidden(const struct analysis *a)
{
    int hidden = 0;
    for (int k = 0; k < a->sweeps && sweeps_let_go(a); k++)
        hidden += isnan(a->swept[k].raised);
    return hidden;
}

/* What stands at the x of a place. */
static inline const char *sweep_lead(const struct analysis *a)
{
    return sweep_lives(a) > 1 ? "first force" : "live load";
}

/* What a factor of the live load counts on, or leaves out, where fill pushes
   back. */
static inline const char *passive_note(const struct analysis *a)
{
    return a->bare    ? ", without the passive pressure of the fill"
         : a->without ? ", with the full passive pressure of the fill"
                      : "";
}

/* What to rely on: where fill pushes back, the analysis in which it does not. Soil
   must be compressed before it pushes back in full. */
static inline const struct analysis *relied_on(const struct analysis *a)
{
    return a->without ? a->without : a;
}

/* Writes what the least factor is, and where. */
static inline void sweep_sentence(const struct analysis *a,
                                  char out[LOADS_ROOM])
{
    const int least = sweep_governs(a), limit = sweep_least(a);
    const int hidden = sweep_hidden(a);
    char more[100] = "", bound[80] = "no bound";
    if (limit >= 0)
        snprintf(bound, sizeof bound, "%.4g at x = %.4g", a->swept[limit].live,
                 tidy(a, a->swept[limit].x));
    if (hidden > 0)
        snprintf(more, sizeof more, "; at %d of %d places none is shown",
                 hidden, a->sweeps);
    if (a->sweeps == 0)
        snprintf(out, LOADS_ROOM, "no factor is known%s", passive_note(a));
    else if (least < 0)
        snprintf(out, LOADS_ROOM, "at none of %d places is a factor known%s",
                 a->sweeps, passive_note(a));
    else if (sweeps_let_go(a))
        snprintf(out, LOADS_ROOM,
                 "with the %s at x = %.4g%s, when it is let go%s; limit "
                 "analysis %s",
                 sweep_lead(a), tidy(a, a->swept[least].x), passive_note(a),
                 more, bound);
    else
        snprintf(out, LOADS_ROOM,
                 "with the %s at x = %.4g%s, by limit analysis: too high where "
                 "stones slide%s",
                 sweep_lead(a), tidy(a, a->swept[least].x), passive_note(a),
                 asks_raised_loads(a)
                     ? "; let go without the live load it is not shown to stay"
                     : " (--raised: let go)");
}

/* The least factor of all places. */
static inline double sweep_factor_least(const struct analysis *a)
{
    const int least = sweep_governs(a);
    return least < 0        ? (double)NAN
         : sweeps_let_go(a) ? a->swept[least].raised
                            : a->swept[least].live;
}

/* What is lost as the load as stated drives over; NULL: nothing. */
static inline const char *sweep_loss(const struct analysis *a)
{
    const int limit = sweep_least(a);
    if (limit >= 0 && a->swept[limit].live < 1 - 1e-9)
        return "it falls";
    return sweep_governs(a) >= 0 && sweep_factor_least(a) < 1 - 1e-9
             ? "it is not shown to stay"
             : NULL;
}

/* The least factor, or why there is none. */
static inline const char *sweep_text(const struct analysis *a, char *out)
{
    if (sweep_governs(a) < 0)
        return a->shown == KERN_FALLS ? "none" : "unknown";
    snprintf(out, 32, "%.4g", sweep_factor_least(a));
    return out;
}

/* Takes the place of *least where the factor is less. */
static inline void sweep_try(struct sweep *w, double x, struct swept *least)
{
    struct swept at;
    if (!(x > w->low && x < w->high))
        return;
    sweep_factor(w, x, &at);
    if (at.live < least->live)
        *least = at;
}

/* Adds the places where force k comes to the ends of face i and leaves them,
   where the face may move; an axle with each of its ends and its middle. Under
   fill, parts of the way from end to end. Returns how many there are. */
static inline int sweep_face(const struct sweep *w, int k, int i, double *x)
{
    const struct analysis *a = w->a;
    const struct soil_edge *e = w->above.edge + i;
    const int wheel = k - sweep_lives(a);
    const double side = 1e-9 * (w->high - w->low);
    const double half = wheel < 0 ? 0 : a->text.wheel[wheel].width / 2;
    const double to = sweep_place(a, 0) - sweep_place(a, k);
    const double p = (double)e->p.x + to, q = (double)e->q.x + to;
    double cone = 0;
    int places = 0;
    if (wheel >= 0)
        text_road(&a->text, (p + q) / 2 - to, &cone);
    if (a->task.s.block[e->block].fixed && !(cone > 0))
        return 0;
    for (int n = 0; n <= SWEEP_PARTS && cone > 0; n++)
        x[places++] = p + (q - p) * n / SWEEP_PARTS;
    if (cone > 0)
        return places;
    x[places++] = p + fmax(half, side);
    x[places++] = q - fmax(half, side);
    if (half > side) {
        x[places++] = p;
        x[places++] = q;
    }
    return places;
}

/* Writes the places where the least may be, in order, and returns how many there
   are. Between the ends of faces 1 / factor is convex, as the largest of powers
   that are linear in the place, so its least is at one of these. Loads that spread
   have a least for each joint or two, anywhere. */
static inline int sweep_places(const struct sweep *w, double *x)
{
    const double side = 1e-9 * (w->high - w->low);
    int all = 0, places = 0;
    for (int k = 0; k < sweep_forces(w->a); k++)
        for (int i = 0; i < w->above.edges; i++)
            all += sweep_face(w, k, i, x + all);
    qsort(x, (size_t)all, sizeof *x, soil_compare);
    for (int k = 0; k < all; k++)
        if (places == 0 || x[k] > x[places - 1] + side / 2)
            x[places++] = x[k];
    return places;
}

/* Tries all of these places; of too many ones that are evenly spread, and those
   next to the least of them. Says how many are left. */
static inline void sweep_joints(struct sweep *w, struct swept *least)
{
    double *x = array((SWEEP_PARTS + 1) * sweep_forces(w->a) * w->above.edges,
                      sizeof *x);
    const int places = x ? sweep_places(w, x) : 0;
    const int step = 1 + (places - 1) / SWEEP_PLACES;
    int best = 0, tried = 0;
    for (int k = 0; k < places; k += step, tried++) {
        const double was = least->live;
        sweep_try(w, x[k], least);
        best = least->live < was ? k : best;
    }
    for (int k = best - step + 1; k < best + step && step > 1; k++)
        if (k >= 0 && k < places && k != best) {
            sweep_try(w, x[k], least);
            tried++;
        }
    w->a->untried = places - tried;
    free(x);
}

/* A part of the way from joint to joint at the least place. */
static inline double sweep_step(const struct sweep *w,
                                const struct swept *least)
{
    double step = (w->high - w->low) / w->a->set->sweep;
    for (int i = 0; i < w->above.edges; i++) {
        const struct soil_edge *e = w->above.edge + i;
        if ((double)e->p.x <= least->x && (double)e->q.x >= least->x)
            step = fmin(step, (double)(e->q.x - e->p.x) / SWEEP_PARTS);
    }
    return step;
}

/* Finds the factor at which it stays when it is let go to .1 %, where its path of
   loading may have ended before that. */
static inline void sweep_edge(struct sweep *w, struct swept *at)
{
    const struct analysis *a = w->a;
    const double beyond = fmin((1 + SWEEP_NARROW) * at->raised, at->live);
    kern_block *block;
    struct swept here;
    at->edge = 1;
    if (!(beyond > (1 + 1e-3) * at->raised))
        return;
    block = array(a->task.s.blocks, sizeof *block);
    if (!block)
        return;
    sweep_pattern(w, at->x, &here);
    at->raised = stays_under(a, w->pattern, block, beyond)
                   ? beyond
                   : live_edge(a, w->pattern, block, at->raised, beyond);
    free(block);
}

/* A factor with the load at x: of limit analysis, or let go. */
static inline double sweep_value(struct sweep *w, enum answer which, double x,
                                 struct swept *at)
{
    if (which == OF_VERDICT) {
        sweep_factor(w, x, at);
        return at->live;
    }
    sweep_at(w, x, at);
    sweep_edge(w, at);
    return at->raised;
}

/* Searches between two places for the least factor, less than `known`, by the
   golden section: loads that spread have their least anywhere. */
static inline void sweep_refine(struct sweep *w, enum answer which, double low,
                                double high, double known, struct swept *least)
{
    const double golden = 0.61803398874989485;
    struct swept p, q;
    double of_p = sweep_value(w, which, high - golden * (high - low), &p);
    double of_q = sweep_value(w, which, low + golden * (high - low), &q);
    for (int k = 0; k < SWEEP_CUTS; k++) {
        if (of_p < known) {
            *least = p;
            known = of_p;
        }
        if (of_q < known) {
            *least = q;
            known = of_q;
        }
        if (of_p < of_q) {
            high = q.x;
            q = p;
            of_q = of_p;
            of_p = sweep_value(w, which, high - golden * (high - low), &p);
        } else {
            low = p.x;
            p = q;
            of_p = of_q;
            of_q = sweep_value(w, which, low + golden * (high - low), &q);
        }
    }
}

/* Puts a place among the others, in order. */
static inline void sweep_insert(struct analysis *a, struct swept at)
{
    int k = a->sweeps++;
    for (; k > 0 && a->swept[k - 1].x > at.x; k--)
        a->swept[k] = a->swept[k - 1];
    a->swept[k] = at;
}

/* Adds the place with the least factor of limit analysis, where the samples miss
   it. */
static inline void sweep_add_least(struct sweep *w)
{
    struct analysis *a = w->a;
    const int sample = sweep_least(a);
    struct swept least;
    double known = HUGE_VAL;

    /* where no sample has a bound, others may */
    least = a->swept[sample < 0 ? 0 : sample];
    if (sample >= 0)
        known = least.live;
    least.live = known;
    sweep_joints(w, &least);
    if (a->text.wheels > 0 && least.live < HUGE_VAL) {
        const double step = sweep_step(w, &least);
        sweep_refine(w, OF_VERDICT, fmax(least.x - step, w->low),
                     fmin(least.x + step, w->high), least.live, &least);
    }
    if (!(least.live < known * (1 - 1e-9)))
        return;
    sweep_at(w, least.x, &least);
    sweep_insert(a, least);
}

/* Finds the least factor let go to .1 %, among the places that are known, and then
   between those beside it where it is less than that of limit analysis. */
static inline void sweep_add_let_go(struct sweep *w)
{
    struct analysis *a = w->a;
    struct swept least;
    int k = sweep_governs(a);
    for (int n = 0; n < SWEEP_EDGES && k >= 0 && !a->swept[k].edge; n++) {
        sweep_edge(w, a->swept + k);
        k = sweep_governs(a);
    }
    if (k < 0 || !(a->swept[k].raised < (1 - 1e-3) * a->swept[k].live))
        return;
    least = a->swept[k];
    sweep_refine(w, OF_LET_GO, k > 0 ? a->swept[k - 1].x : w->low,
                 k + 1 < a->sweeps ? a->swept[k + 1].x : w->high, least.raised,
                 &least);
    if (least.raised < a->swept[k].raised * (1 - 1e-9))
        sweep_insert(a, least);
}

/* At places in the middle of equal parts of the way, and at the worst ones. */
static inline int find_sweep(struct analysis *a)
{
    const int places = (int)a->set->sweep;
    struct sweep w = {a, {NULL, 0}, NULL, 0, 0};
    if (!sweep_range(&w))
        return fail(a, 0, "--sweep: the blocks have no outline");
    if (a->shown != KERN_STANDS)
        return 0;
    w.pattern = array(a->task.s.blocks, sizeof *w.pattern);
    a->swept = array(places + 2, sizeof *a->swept);
    const int there = w.pattern && a->swept
                   && !text_outline(&a->text, SOIL_ABOVE, &w.above);
    for (int k = 0; k < places && there; k++) {
        sweep_at(&w, w.low + (k + 0.5) / places * (w.high - w.low),
                 &a->swept[k]);
        a->sweeps++;
    }
    if (there)
        sweep_add_least(&w);
    if (there && sweeps_let_go(a))
        sweep_add_let_go(&w);
    free(w.above.edge);
    free(w.pattern);
    return there ? 0 : fail_memory(a);
}

static const char sweep_why[] =
    "without the live load it is not known to stand";

/* Above this a factor has no digits that mean anything. */
#define SWEEP_HUGE 1e4

/* As the report has it: six digits. */
static inline void sweep_print(double value)
{
    if (isnan(value))
        printf(" %11s", "-");
    else if (isinf(value))
        printf(" %11s", "any");
    else if (value > SWEEP_HUGE)
        printf(" %11s", "> 10000");
    else
        printf(" %11.6g", value);
}

static inline void report_sweep(const struct analysis *a)
{
    const int least = sweep_least(a), governs = sweep_governs(a);
    const int let_go = sweeps_let_go(a);
    char shown[TEXT_SHOW_ROOM], what[LOADS_ROOM];
    if (a->set->sweep > 0 && a->sweeps == 0)
        printf("  sweep       none: %s\n", sweep_why);
    if (a->sweeps == 0)
        return;
    if (a->without) {
        sweep_sentence(a->without, what);
        printf("  no passive  %-8s  %s%s\n", sweep_text(a->without, shown),
               sweep_governs(a->without) < 0 ? ""
                                             : "rely on this least factor, ",
               what);
    }
    sweep_sentence(a, what);
    if (governs >= 0)
        printf("  worst place %-8.4g  least factor, %s\n",
               sweep_factor_least(a), what);
    else
        printf("  worst place none      %s\n", what);
    if (a->untried > 0)
        printf("  sweep       %d places where the least may be were not tried: "
               "it may be less than that below\n",
               a->untried);
    if (a->without)
        printf("  sweep       each factor below%s\n", passive_note(a));
    printf("  sweep       %11s %11s", "x", "y");
    if (let_go)
        printf(" %11s", "live");
    printf(" %11s  on\n", "live limit");
    for (int k = 0; k < a->sweeps; k++) {
        const struct swept *at = &a->swept[k];
        printf("             ");
        sweep_print(at->x);
        sweep_print(at->y);
        if (let_go)
            sweep_print(at->raised);
        sweep_print(at->live);
        printf("  %s%s\n",
               at->block < 0 ? "-" : text_show(shown, a->text.name[at->block]),
               k == governs ? "  least"
               : k == least ? "  least of limit analysis"
                            : "");
    }
}

/* The place that governs; null where none is known. */
static inline void json_worst(const struct analysis *a)
{
    const int worst = sweep_governs(a);
    json_number("worst_live", sweep_factor_least(a));
    json_number("worst_x", worst < 0 ? (double)NAN : a->swept[worst].x);
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
        if (sweeps_let_go(a))
            json_number("raised_live", at->raised);
        printf("}");
    }
    printf("], \"sweep_untried\": %d", a->untried);
    json_worst(a);
    if (a->sweeps == 0) {
        printf(", ");
        json_string("sweep_why", sweep_why);
    }
}

/* A curve through each run of places where the factor is finite, and arrows up at
   the top where any factor does. */
static inline void sweep_curve(const struct analysis *a, const struct plot *p,
                               int let_go, const char *colour, double *x,
                               double *y)
{
    int n = 0;
    for (int k = 0; k <= a->sweeps; k++) {
        const double value = k == a->sweeps ? (double)NAN
                           : let_go         ? a->swept[k].raised
                                            : a->swept[k].live;
        if (isfinite(value)) {
            x[n] = a->swept[k].x;
            y[n++] = value;
            continue;
        }
        if (n > 0)
            plot_curve(p, x, y, n, colour, 1.6);
        n = 0;
        if (isinf(value)) {
            const struct draw_pt top = plot_place(p, a->swept[k].x, p->y1);
            draw_arrow(p->out, draw_vec(top.x, top.y + 12), top, 1, colour);
        }
    }
}

/* The factor over the place, up to four times the least. */
static inline int sweep_plot(const struct analysis *a, FILE *out)
{
    const int least = sweep_least(a), last = a->sweeps - 1;
    const struct analysis *w = a->without;
    const int more = w && w->sweeps > a->sweeps ? w->sweeps : a->sweeps;
    struct plot p = {0};
    double *x = array(2 * more, sizeof *x);
    if (!x)
        return -1;
    p.x0 = a->swept[0].x;
    p.x1 = a->swept[last].x;
    p.y1 = least < 0 ? 1 : 4 * a->swept[least].live;
    plot_begin(&p, out,
               sweeps_let_go(a)
                   ? "Live load: red let go, black limit analysis; arrows: any"
                   : "Live load: limit analysis; arrows: any factor",
               sweep_lives(a) > 1 ? "place of the first force"
                                  : "place of the live load",
               "factor", 0);
    sweep_curve(a, &p, 0, DRAW_INK, x, x + more);
    if (sweeps_let_go(a))
        sweep_curve(a, &p, 1, DRAW_FORCE, x, x + more);
    if (w && w->sweeps > 0) {
        sweep_curve(w, &p, sweeps_let_go(w), DRAW_LOAD, x, x + more);
        plot_text(
            &p, p.left + 6, p.top + p.height - 6, 10.5, "start",
            "green, to rely on: without the passive pressure of the fill");
    }
    free(x);
    return plot_end(&p);
}

#endif /* PROGRAM_SWEEP_H */
