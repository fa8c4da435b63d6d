/* page.h - --report: one page in HTML to print and hand in, with the picture in
   it, what was found, what was assumed, where the rules come from, and the
   statements and the command that it was made of.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_PAGE_H
#define PROGRAM_PAGE_H

#include "../../kern.h"

#include "beds.h"
#include "let_go.h"
#include "loads.h"
#include "picture.h"
#include "report.h"
#include "state.h"
#include "sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum {
    PAGE_BEDS = 200,     /* beds that are listed at most            */
    PAGE_INPUT = 1000000 /* bytes of statements, of some 15,000 blocks */
};

static inline void page_text(FILE *out, const char *text)
{
    draw_escape(out, text, strlen(text));
}

static inline void page_head(FILE *out, const char *title)
{
    fprintf(out, "<h2>%s</h2>\n", title);
}

/* Writes a paragraph, where it applies. */
static inline void page_note(FILE *out, int applies, const char *text)
{
    if (applies)
        fprintf(out, "<p>%s</p>\n", text);
}

/* A row of two cells and what the second means. */
static inline void page_row(FILE *out, const char *name, const char *value,
                            const char *means)
{
    fputs("<tr><th>", out);
    page_text(out, name);
    fputs("</th><td>", out);
    page_text(out, value);
    fputs("</td><td>", out);
    page_text(out, means);
    fputs("</td></tr>\n", out);
}

static inline void page_line(const char *word, const char *what, void *out)
{
    page_row(out, word, "", what);
}

/* The factors of the live load where the file has it: those at which it stays when
   it is let go, where that is asked for. */
static inline const char *page_live(const struct analysis *a, char out[100])
{
    char low[40], high[40];
    if (live_text(a, low, high))
        snprintf(out, 100, "%s to %s", low, high);
    else
        snprintf(out, 100, "%s", low);
    return out;
}

/* Writes what the factors count on where the file states no strength. */
static inline void page_strength(FILE *out, const struct analysis *a,
                                 const char *begin, const char *end)
{
    if (!(a->text.strength > 0))
        fprintf(out, "%sNo strength is stated: " ENDLESS_STRENGTH ".%s", begin,
                end);
}

/* Writes how it falls just beyond the factor that governs, where few groups of
   blocks move. */
static inline void page_beyond(FILE *out, const struct analysis *a)
{
    enum { GROUPS = 3 };
    const enum earth_part least = earth_governs(a);
    const struct analysis beyond = beyond_growth(a, least);
    kern_critical moving = find_groups(&beyond);
    char head[60], text[32];
    snprintf(head, sizeof head,
             " Beyond %s: ", factor_text(a->earth[least].limit, 1, "", text));
    for (int k = 0; k < moving.groups && moving.groups <= GROUPS; k++)
        if (write_group(out, &beyond, &moving, k, k > 0 ? "; " : head,
                        page_text))
            fputs(k + 1 == moving.groups ? "." : "", out);
    free_groups(&moving);
}

/* Writes the factors on the thrust of earth, that which governs first. */
static inline void page_growing(FILE *out, const struct analysis *a)
{
    static const char *const on[EARTH_PARTS] = {
        "whole thrust of the earth", "horizontal part of the earth's thrust"};
    const enum earth_part least = earth_order(a, 0), other = earth_order(a, 1);
    char text[32];
    if (!has_growth(a, EARTH_WHOLE))
        return;
    fprintf(out, " The factor that governs is %s on the %s%s",
            growth_text(a, least, text), on[least],
            least == EARTH_HORIZONTAL
                ? ", which compares forces and moments as a design does"
                : "");
    if (has_growth(a, other))
        fprintf(out, "; on the %s it is %s", on[other],
                growth_text(a, other, text));
    fputs(asks_raised_loads(a) ? " (when it is let go; limit analysis "
                               : " (limit analysis",
          out);
    if (asks_raised_loads(a))
        fputs(factor_text(a->earth[least].limit, 1, "", text), out);
    if (asks_raised_loads(a) && has_growth(a, other))
        fprintf(out, " and %s",
                factor_text(a->earth[other].limit, 1, "", text));
    fputs(").", out);
    page_beyond(out, a);
}

/* Writes the factor that governs: of all places, or of the file's. Where fill
   pushes back, that is the one without its passive pressure; that with all of it
   follows. */
static inline void page_governing(FILE *out, const struct analysis *a)
{
    const struct analysis *r = relied_on(a);
    const int least = sweep_governs(r), full = sweep_governs(a);
    const char *bare = a->without ? passive_note(r) : "";
    char value[100], one[40];
    if (a->lived != KERN_STANDS || a->text.lives == 0)
        return;
    if (a->sweeps > 0 && least < 0)
        fprintf(out,
                " No least factor of the live load is known as it drives "
                "over%s.",
                bare);
    else if (a->sweeps > 0)
        fprintf(out,
                " The factor that governs is %s, with the live load at its "
                "worst place, x = %.4g%s%s.",
                sweep_text(r, one), tidy(a, r->swept[least].x), bare,
                sweeps_let_go(r) ? "" : " (limit analysis)");
    else
        fprintf(out, " Factors of the live load%s: %s%s.", bare,
                page_live(r, value),
                asks_raised_loads(a) ? "" : " (limit analysis)");
    if (a->without && a->sweeps == 0)
        fprintf(out, " With all of that pressure: %s.", page_live(a, value));
    else if (a->without && full >= 0)
        fprintf(out, " With all of that pressure it would be %s, at x = %.4g.",
                sweep_text(a, one), tidy(a, a->swept[full].x));
}

/* Writes what may turn the verdict round: let go, the live load, and fill that does
   not push back. */
static inline void page_reversals(FILE *out, const struct analysis *a)
{
    const int live = a->text.lives > 0;
    const char *lost = lost_without(a),
               *load = live ? " without that load" : "";
    if (a->let_go_why[0]) {
        if (a->let_go >= 0)
            fprintf(out, " Let go from rest%s, it %s: ", load, let_go_word(a));
        else
            fprintf(out,
                    " That it stays when it is let go%s is not shown: ", load);
        page_text(out, a->let_go_why);
        fputs(".", out);
    }
    if (live && as_stated(a) != KERN_UNDECIDED)
        page_text(out, as_stated(a) == KERN_STANDS
                           ? " Under the live load as stated it stands."
                           : " Under the live load as stated it falls.");
    if (sweep_loss(a))
        fprintf(out, " As this load drives over, %s.", sweep_loss(a));
    if (is_loosened(a))
        fputs(" Let go under the live load as stated, it is not shown to stay.",
              out);
    if (lost)
        fprintf(out, " Without the passive pressure of the fill %s.", lost);
}

/* The verdict in a sentence. */
static inline void page_verdict(FILE *out, const struct analysis *a)
{
    const int live = a->text.lives > 0;
    fputs("<p class=\"verdict\">", out);
    page_text(out, a->verdict == KERN_STANDS
                       ? live ? "It stands without the live load: forces hold "
                                "it."
                              : "It stands: forces hold it."
                   : a->verdict == KERN_FALLS
                       ? live ? "It falls without the live load: no forces "
                                "hold it."
                              : "It falls: no forces hold it."
                       : "Undecided.");
    if (a->crushes)
        page_text(out, " It crushes: at a strength without limit it would "
                       "stand.");
    page_reversals(out, a);
    if (a->certain >= 0)
        page_text(out, a->certain ? " As far as the error of the outlines "
                                    "tells, that is certain."
                                  : " Within the error of the outlines it may "
                                    "be otherwise.");
    if (a->certain > 0 && a->verdict == KERN_STANDS)
        fprintf(out,
                " The margin is at least %.4g, and the stones may settle "
                "by %.4g.",
                (double)a->interval.low, (double)a->interval.settles);
    page_governing(out, a);
    page_growing(out, a);
    if (a->text.lives > 0 || has_growth(a, EARTH_WHOLE))
        page_strength(out, a, " ", "");
    fputs("</p>\n", out);
}

/* Margin, or deficit. */
static inline void page_margin(FILE *out, const struct analysis *a)
{
    char value[TEXT_SHOW_ROOM + 40];
    const char *unit = a->set->relative ? "a share of each contact" : "";
    if (a->measured == KERN_FALLS) {
        page_row(out, "deficit", length_text(a, a->deficit, value),
                 "how far each contact would have to grow at both ends until "
                 "it stands");
    } else if (a->measured == KERN_STANDS) {
        page_row(out, "margin", length_text(a, (double)a->m.margin, value),
                 a->m.saturated ? "it stands with every contact a point"
                 : *unit        ? unit
                         : "how far each contact can shrink at both ends "
                           "before it falls");
        if (!isnan(a->bearing) && !isinf(a->bearing))
            page_row(out, "bearing", length_text(a, a->bearing, value),
                     "it would fall without contacts of up to this length");
    } else
        page_row(out, "margin", "undecided", "");
}

/* Factors of the live load, first the one that governs. */
static inline void page_live_load(FILE *out, const struct analysis *a)
{
    static const char full[] = "with passive pressure";
    const struct analysis *r = relied_on(a);
    char one[40], two[40], value[100], means[LOADS_ROOM];
    if (a->shown < 0 || a->text.lives == 0)
        return;
    if (a->sweeps > 0) {
        sweep_sentence(r, means);
        page_row(out, "live load, worst place", sweep_text(r, one), means);
    }
    if (a->sweeps > 0 && a->without) {
        sweep_sentence(a, means);
        page_row(out, full, sweep_text(a, one), means);
    }
    if (a->lived != KERN_STANDS) {
        page_row(out, "live load",
                 a->lived == KERN_FALLS ? "none" : "undecided",
                 "factors at which it stands, with the load at the place "
                 "given in the file");
        return;
    }
    snprintf(means, sizeof means,
             "factors at which it %s, with the load at the place given in the "
             "file%s%s",
             asks_raised_loads(a) ? "stays when it is let go"
                                  : "stands by limit analysis",
             a->without ? passive_note(r) : "",
             asks_raised_loads(a) ? "" : " (--raised: let go)");
    page_row(out, "live load as placed", page_live(r, value), means);
    if (a->without)
        page_row(out, full, page_live(a, value),
                 "the same with the full passive pressure of the fill");
    if (!asks_raised_loads(a))
        return;
    snprintf(value, sizeof value, "%s to %s",
             factor_text(a->live_least, 1, "", one),
             factor_text(a->live, 1, "", two));
    page_row(out, "the same, limit analysis", value,
             "in which sliding stones part: where it is larger it is too "
             "high");
}

/* Horizontal loads, and tilts. */
static inline void page_factors(FILE *out, const struct analysis *a)
{
    static const double degrees = 57.295779513082321;
    char one[40], two[40], value[100];
    if (a->shown != KERN_STANDS || !(gravity_of(a) > 0))
        return;
    if (has_friction_loads(a)) {
        snprintf(value, sizeof value, "%s left, %s right",
                 shown_text(a, LEFT, one), shown_text(a, RIGHT, two));
        page_row(out, "horizontal load", value,
                 "in g, that Coulomb friction bears as it grows from 0");
    }
    snprintf(value, sizeof value, "%s left, %s right",
             factor_text(a->load[LEFT], 1, "", one),
             factor_text(a->load[RIGHT], 1, "", two));
    page_row(
        out, "horizontal load, limit", value,
        "in g, of limit analysis, in which sliding stones part: where it is "
        "larger it is too high");

    /* of weight alone, what friction bears sideways is what it bears tilted */
    if (has_friction_loads(a) && !has_loads(a)) {
        snprintf(value, sizeof value, "%s left, %s right",
                 angle_text(atan(a->raised_load[LEFT]), a->cut[LEFT], degrees,
                            "\xc2\xb0", one),
                 angle_text(atan(a->raised_load[RIGHT]), a->cut[RIGHT], degrees,
                            "\xc2\xb0", two));
        page_row(out, "tilt", value,
                 "of the ground, that Coulomb friction bears as it grows "
                 "from 0");
    }
    snprintf(value, sizeof value, "%s left, %s right",
             factor_text(a->tilt[LEFT], degrees, "\xc2\xb0", one),
             factor_text(a->tilt[RIGHT], degrees, "\xc2\xb0", two));
    page_row(out, "tilt, limit", value, "of the ground, of limit analysis");
}

/* The analysis with the forces under the live load as stated, where these are
   known; otherwise with those that hold it without. */
static inline struct analysis page_loaded(const struct analysis *a)
{
    struct analysis loaded = *a;
    if (a->live_force) {
        loaded.force = a->live_force;
        loaded.least = 1;
    }
    return loaded;
}

/* What the forces are of. */
static inline const char *page_of(const struct analysis *a, int loaded)
{
    return loaded            ? "with the live load as stated"
         : a->text.lives > 0 ? "without the live load"
                             : "under weight and all loads of the file";
}

/* The largest linear stress at the edge of a bed, and where. */
static inline void page_edge(FILE *out, const struct analysis *a, int loaded)
{
    struct bed *bed;
    struct bed_row r, worst = {{0, 0}, {0, 0}, {0, 0}, 0, 0, 0, 0, 0};
    const int beds = find_beds(a, &bed);
    char value[LOADS_QUANTITY], means[2 * TEXT_SHOW_ROOM + 200], at[64];
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    double most = 0;
    int k = -1;
    for (int i = 0; i < beds; i++)
        if (bed_row_of(a, bed + i, &r) && fmax(r.low, r.high) > most) {
            most = fmax(r.low, r.high);
            worst = r;
            k = i;
        }
    if (k >= 0) {
        snprintf(
            means, sizeof means,
            "between %s and %s at %s, %s: linear over the joint. Not unique: "
            "other forces may hold it as well",
            name_of(a, bed[k].a, one), name_of(a, bed[k].b, two),
            loads_at(a, worst.low < most ? worst.high_end : worst.low_end, at),
            page_of(a, loaded));
        page_row(out,
                 a->least ? "edge stress, least forces"
                          : "edge stress, forces found",
                 isinf(most) ? "all on an edge"
                             : loads_number(a, most, 2, value),
                 means);
    }
    free(bed);
}

static inline void page_results(FILE *out, const struct analysis *a)
{
    const int most = most_stressed(a, 0, a->task.s.contacts);
    const struct analysis loaded = page_loaded(a);
    char value[LOADS_QUANTITY], means[2 * TEXT_SHOW_ROOM + 200];
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM], earth[LOADS_ROOM];
    if (a->set->verdict_only)
        return;
    page_head(out, "Results");
    page_strength(out, a, "<p>", "</p>\n");
    fputs("<table>\n", out);
    page_live_load(out, a);
    for (int k = 0; k < EARTH_PARTS; k++) {
        const enum earth_part part = earth_order(a, k);
        if (!has_growth(a, part))
            continue;
        growth_means(a, part, earth);
        page_row(out,
                 part == EARTH_WHOLE ? "earth, thrust"
                                     : "earth, horizontal part",
                 growth_text(a, part, value), earth);
    }
    page_margin(out, a);
    page_factors(out, a);
    if (a->set->thrust && a->shown == KERN_STANDS) {
        char thrust[LOADS_ROOM];
        loads_thrust(a, thrust);
        page_row(out, "thrust", "", thrust);
    }
    if (a->live_force)
        page_edge(out, &loaded, 1);
    page_edge(out, a, 0);
    if (most >= 0) {
        const kern_contact *c = &a->task.s.contact[most];
        snprintf(means, sizeof means,
                 "between %s and %s, %s: mean if it were only twice the "
                 "margin%s long",
                 name_of(a, c->a, one), name_of(a, c->b, two), page_of(a, 0),
                 a->whole ? " and what crushes" : "");
        page_row(out, "mean stress at the margin",
                 loads_number(a, a->stress[most], 2, value), means);
    }
    fputs("</table>\n", out);
}

/* Geometry, materials and loads. */
static inline void page_structure(FILE *out, const struct analysis *a)
{
    char value[200], one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    const int ends = line_points(a), given = a->text.given && !a->text.found;
    page_head(out, "Structure and loads");
    fputs("<table>\n", out);
    snprintf(value, sizeof value, "%d block%s on %d fixed",
             stones(a) - a->text.fixed, plural(stones(a) - a->text.fixed),
             a->text.fixed);
    page_row(out, "blocks", value, "");
    const int points = a->task.s.contacts - ends - 2 * a->text.props;
    snprintf(value, sizeof value, "%d line%s, %d point%s", ends / 2,
             plural(ends / 2), points, plural(points));
    page_row(out, "contacts", value,
             given ? "given by the file" : "found between outlines");
    snprintf(value, sizeof value, "%.4g", (double)a->task.options.mu);
    page_row(out, "friction", value,
             a->text.found ? "tan(friction angle), where the file does not say "
                             "another"
                           : "tan(friction angle)");
    snprintf(value, sizeof value, "%.4g, %.4g", (double)a->task.s.gravity.x,
             (double)a->task.s.gravity.y);
    page_row(out, "gravity", value, "x, y");
    snprintf(value, sizeof value, "%.40s, %.40s",
             a->text.units ? text_show(one, a->text.units) : "of the file",
             a->text.force_units ? text_show(two, a->text.force_units)
                                 : "mass times gravity");
    page_row(out, "units", value,
             "of lengths, and of forces on a slice of "
             "depth 1");
    snprintf(value, sizeof value, "%d", a->text.lives - a->text.spread);
    if (a->text.lives > a->text.spread)
        page_row(out, "live loads", value, "forces of the live load");
    loads_each(a, page_line, out);
    fputs("</table>\n", out);
}

/* What each support gives the structure: the sum of its contact forces. */
static inline void page_reactions(FILE *out, const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    char one[LOADS_QUANTITY], two[LOADS_QUANTITY], name[TEXT_SHOW_ROOM];
    if (a->text.bond > 0)
        return;
    fputs("<ul>\n", out);
    for (int i = 0; i < stones(a); i++) {
        double fx = 0, fy = 0;
        for (int k = 0; k < s->contacts && s->block[i].fixed; k++) {
            const kern_contact *c = &s->contact[k];
            const double side = c->a == i ? 1 : c->b == i ? -1 : 0;
            if (c->a >= stones(a) || c->b >= stones(a))
                continue;
            fx += side
                * (double)(a->force[k].normal * c->n.x
                           - a->force[k].tangential * c->n.y);
            fy += side
                * (double)(a->force[k].normal * c->n.y
                           + a->force[k].tangential * c->n.x);
        }
        if (!(hypot(fx, fy) > 0))
            continue;
        fputs("<li>", out);
        page_text(out, name_of(a, i, name));
        fputs(" bears it with ", out);
        page_text(out, loads_number(a, fabs(fx), 0, one));
        fputs(fx < 0 ? " to the left and " : " to the right and ", out);
        page_text(out, loads_number(a, fabs(fy), 0, two));
        fprintf(out, " %s%s</li>\n", fy < 0 ? "down" : "up",
                a->text.props > 0 ? ", beside pushes" : "");
    }
    fputs("</ul>\n", out);
}

/* A cell of the head of a table, with its unit: of lengths where `per_length` is
   below 0. */
static inline void page_unit(FILE *out, const struct analysis *a,
                             const char *name, int per_length, int large)
{
    const struct text_file *t = &a->text;
    char unit[TEXT_SHOW_ROOM];
    fputs("<th>", out);
    page_text(out, name);
    if (per_length < 0 ? t->units != NULL : t->force_units != NULL) {
        fputs(" [", out);
        page_text(out, per_length < 0 ? t->units
                                      : loads_unit(a, per_length, large, unit));
        fputs("]", out);
    }
    fputs("</th>", out);
}

/* Which columns of the table of beds are in kN, or kPa: all of it, since columns
   are compared. */
struct page_large {
    int force, stress;
};

static inline struct page_large page_find_large(const struct analysis *a,
                                                const struct bed *bed, int beds)
{
    struct page_large large = {0, 0};
    struct bed_row r;
    for (int i = 0; i < beds; i++) {
        if (!bed_row_of(a, bed + i, &r))
            continue;
        large.force |= loads_is_large(a, r.normal, 0)
                    || loads_is_large(a, r.shear, 0);
        large.stress |= loads_is_large(a, isfinite(r.low) ? r.low : 0, 2)
                     || loads_is_large(a, isfinite(r.high) ? r.high : 0, 2);
    }
    return large;
}

/* One resultant a bed. */
static inline void page_thrust(FILE *out, const struct analysis *a, int loaded)
{
    struct bed *bed;
    const int beds = find_beds(a, &bed);
    const struct page_large large = page_find_large(a, bed, beds);
    const double force = large.force ? 1e-3 : 1;
    const double stress = large.stress ? 1e-3 : 1;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    struct bed_row r;
    if (beds > 0) {
        fprintf(out, "<h2>Thrust: one resultant a bed or joint, %s</h2>\n",
                page_of(a, loaded));
        page_reactions(out, a);
        fprintf(out,
                "<p>One possible set of forces%s. Other sets may hold it too, "
                "with other stresses. Forces are those of \"from\" on \"on\"; "
                "shear and eccentricity are above 0 toward the second end. "
                "Eccentricity is a share of the length, below 1/6 where "
                "all of it is pressed; stresses are linear over all of it%s, "
                "\"edge\" where all is on an end.</p>\n",
                a->least ? ", the smallest" : "",
                a->text.bond > 0 ? ", below 0 what mortar bears"
                                 : " without tension");
        fputs("<table class=\"numbers\">\n<tr><th>from</th><th>on</th>", out);
        page_unit(out, a, "x", -1, 0);
        page_unit(out, a, "y", -1, 0);
        page_unit(out, a, "normal", 0, large.force);
        page_unit(out, a, "shear", 0, large.force);
        fputs("<th>eccentricity</th>", out);
        page_unit(out, a, "stress", 2, large.stress);
        fputs("<th>at one end</th>", out);
        page_unit(out, a, "stress", 2, large.stress);
        fputs("<th>at the second</th></tr>\n", out);
    }
    for (int i = 0; i < beds && i < PAGE_BEDS; i++) {
        const struct bed *d = &bed[i];
        char low[64], high[64], from[32], to[32];
        if (!bed_row_of(a, d, &r))
            continue;
        fputs("<tr><td>", out);
        page_text(out, name_of(a, d->a, one));
        fputs("</td><td>", out);
        page_text(out, name_of(a, d->b, two));
        fprintf(out,
                "</td><td>%.4g</td><td>%.4g</td><td>%.4g</td><td>%.4g</td>"
                "<td>%.3f</td><td>%s</td><td>%s</td><td>%s</td><td>%s</td>"
                "</tr>\n",
                tidy(a, (double)r.at.x), tidy(a, (double)r.at.y),
                force * r.normal, force * r.shear, r.e,
                bed_number(stress * r.low, from), loads_at(a, r.low_end, low),
                bed_number(stress * r.high, to), loads_at(a, r.high_end, high));
    }
    if (beds > 0)
        fputs("</table>\n", out);
    if (beds > PAGE_BEDS)
        fprintf(out, "<p>and %d more (--forces lists all)</p>\n",
                beds - PAGE_BEDS);
    free(bed);
}

/* The groups that move, each an entry of a list. */
static inline void page_groups(FILE *out, const struct analysis *a,
                               const kern_critical *moving, const char *head)
{
    for (int k = 0; k < moving->groups && k < 12; k++)
        if (write_group(out, a, moving, k, head, page_text))
            fputs("</li>\n", out);
}

/* How it falls as the earth grows, the factor that governs first. */
static inline void page_earth(FILE *out, const struct analysis *a)
{
    char head[60], text[32];
    if (!a->earth[earth_governs(a)].motion)
        return;
    page_head(out, "How it would fall as the earth grows");
    fputs("<ul>\n", out);
    for (int k = 0; k < EARTH_PARTS; k++) {
        const enum earth_part part = earth_order(a, k);
        const struct analysis beyond = beyond_growth(a, part);
        kern_critical moving = find_groups(&beyond);
        snprintf(head, sizeof head, "<li>beyond %s: ",
                 factor_text(a->earth[part].limit, 1, "", text));
        page_groups(out, &beyond, &moving, head);
        free_groups(&moving);
    }
    fputs("</ul>\n", out);
}

/* How it falls, or would. */
static inline void page_mechanism(FILE *out, const struct analysis *a)
{
    kern_critical moving = find_groups(a);
    if (moving.groups > 0) {
        page_head(out, a->shown == KERN_FALLS ? "How it falls"
                       : a->set->mechanism_live
                           ? "How it falls beyond the live load"
                           : "How it would fall beyond the margin");
        page_note(out,
                  has_growth(a, EARTH_WHOLE) && !a->set->mechanism_live
                      && !a->set->relative,
                  "The margin is a length: where a wall tapers, the narrowest "
                  "course limits it, whatever the earth does.");
        fputs("<ul>\n", out);
        page_groups(out, a, &moving, "<li>");
        fputs("</ul>\n", out);
    }
    free_groups(&moving);
}

static inline void page_sweep(FILE *out, const struct analysis *a)
{
    const struct analysis *r = relied_on(a);
    char what[LOADS_ROOM], one[40];
    if (a->sweeps == 0 || sweep_least(a) < 0)
        return;
    sweep_sentence(r, what);
    page_head(out, "A live load that drives over it");
    fprintf(out, "<p>The factor that governs is %s, ", sweep_text(r, one));
    page_text(out, what);
    if (a->without) {
        sweep_sentence(a, what);
        fprintf(out, ". It would be %s, ", sweep_text(a, one));
        page_text(out, what);
    }
    fputs(". Arrows at the top: any factor.</p>\n<div class=\"picture\">\n",
          out);
    sweep_plot(a, out);
    fputs("</div>\n", out);
}

/* What a drawing was taken for, and what of it was left out. */
static inline void page_drawing(FILE *out, const struct analysis *a)
{
    const struct shapes *s = &a->drawing.s;
    const char *note = s->notes.at ? s->notes.at : "";
    char kind[TEXT_SHOW_ROOM], label[TEXT_SHOW_ROOM];
    if (!a->drawing.made)
        return;
    page_head(out, s->photograph ? "How the photograph was read"
                                 : "How the drawing was read");
    fputs("<ul>\n", out);
    for (; *note; note = strchr(note, '\n') + 1) {
        fputs("<li>", out);
        draw_escape(out, note, strcspn(note, "\n"));
        fputs("</li>\n", out);
    }
    for (int i = 0; i < s->skips; i++) {
        const struct shapes_skip *k = s->skip + i;
        fprintf(out, "<li>skipped: %d ", k->count);
        page_text(out, text_show(kind, shapes_at(s, k->kind)));
        if (*shapes_at(s, k->label)) {
            fputs(" on ", out);
            page_text(out, text_show(label, shapes_at(s, k->label)));
        }
        fputs("</li>\n", out);
    }
    fputs("</ul>\n", out);
}

/* A sentence of a list, where it applies. */
static inline void page_item(FILE *out, int applies, const char *text)
{
    if (!applies)
        return;
    fputs("<li>", out);
    page_text(out, text);
    fputs("</li>\n", out);
}

/* Does a statement of this kind stand in the file? */
static inline int page_has(const struct analysis *a, enum text_soil_kind kind)
{
    for (int i = 0; i < a->text.soils; i++)
        if (a->text.soil[i].kind == kind)
            return 1;
    return 0;
}

static inline void page_assumptions(FILE *out, const struct analysis *a)
{
    const int fill = page_has(a, TEXT_FILL), earth = page_has(a, TEXT_EARTH);
    const char *notes = a->drawing.made ? a->drawing.s.notes.at : NULL;
    page_head(out, "What is assumed");
    fputs("<ul>\n", out);
    page_item(out, 1,
              "Blocks are rigid and lie in a plane: a slice of depth 1. What "
              "happens across it (spandrel walls, skew) is not seen.");
    page_item(
        out, 1,
        "Joints carry no tension and slide by Coulomb's law. Deflections, "
        "settlement and time are not seen.");
    page_item(out, 1,
              "\"Stands\" says that admissible forces exist. With friction "
              "this is necessary, but not sufficient. \"Let go\" adds that the "
              "load raises such forces from rest.");
    page_item(out, !(a->text.strength > 0), "Stone does not crush.");
    page_item(out, a->text.strength > 0,
              "Stone crushes in a rectangular stress block at the end of a "
              "contact, at the strength that is given; a contact that all of "
              "it cannot bear bears nothing. A point contact has no width, "
              "and does not crush.");
    page_item(out, !(a->text.bond > 0), "Mortar does not bond.");
    page_item(
        out, a->text.bond > 0,
        "The bond of mortar is plastic: it acts over the whole of a joint "
        "that opens. That is unsafe for brittle mortar, for which the "
        "answer without bond holds. Forces and thrust hold it as a "
        "compression.");
    page_item(out, a->text.lives > 0,
              "Margin, stress at the margin, horizontal load and tilt are "
              "without the live load.");
    page_item(out, fill || (notes && strstr(notes, "fill: ")),
              "Fill lies on the stones right below it with its weight.");
    page_item(out, a->text.props > 0,
              "Pushes (passive pressure, props) are there as far as they are "
              "needed, up to their largest value, whatever the movement.");
    page_item(out, a->without != NULL,
              "Margin, stresses, horizontal loads and tilts count on the "
              "passive pressure of the fill as well.");
    page_item(out, has_growth(a, EARTH_HORIZONTAL),
              "A factor on all of the thrust of earth makes its vertical part "
              "larger as well; one on its horizontal part alone compares "
              "overturning and resisting moments as a design does.");
    page_item(out, earth,
              "Earth is level and presses with its active pressure, which "
              "grows with depth; a surcharge adds the same at every depth.");
    page_item(out, has_water(a),
              "Water presses on the back of the wall; its uplift under the "
              "wall is not counted, unless a load holds it. The density of "
              "earth below water is the saturated one.");
    page_item(out, pose_error(a) > 0,
              "Outlines were measured: gaps and overlaps of some errors are "
              "contacts.");
    page_item(out, a->text.loads > 0,
              "Loads, earth and bond stay as they are under horizontal loads "
              "and tilts.");
    fputs("</ul>\n", out);
}

static inline void page_sources(FILE *out, const struct analysis *a)
{
    const int fill = page_has(a, TEXT_FILL), earth = page_has(a, TEXT_EARTH);
    page_head(out, "Sources of the rules");
    fputs("<ul>\n", out);
    page_item(out, 1,
              "Equilibrium of rigid blocks without tension: J. Heyman, The "
              "stone skeleton, Int. J. Solids Struct. 2 (1966) 249; by linear "
              "programming: R. K. Livesley, Int. J. Numer. Meth. Engng 12 "
              "(1978) 1853.");
    page_item(out, 1,
              "Margin and level: Y. Liu, M. Saboia, V. Thangavelu, N. Napp, "
              "Approximate Stability Analysis for Drystacked Structures, IROS "
              "2019.");
    page_item(out, earth,
              "Active pressure: C. A. Coulomb, 1776; W. J. M. "
              "Rankine, 1857.");
    page_item(out, fill && a->text.props > 0,
              "Passive pressure: W. J. M. Rankine, 1857.");
    page_item(out, a->text.wheels > 0 && fill,
              "Spread of a load through fill: J. Boussinesq, 1885, within 30 "
              "degrees, onto the first stones that it meets.");
    page_item(out, 1,
              "How far these rules meet experiments: tests/REALITY.md of "
              "kern.");
    fputs("</ul>\n", out);
}

/* Writes a word of a command as a shell reads it. */
static inline void page_word(FILE *out, const char *word)
{
    const char *plain = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                        "0123456789-_=./,+:@%";
    const int quoted = word[strspn(word, plain)] != '\0' || !*word;
    fputs(quoted ? " '" : " ", out);
    while (*word) {
        const size_t n = strcspn(word, "'");
        draw_escape(out, word, n);
        word += n;
        for (; *word == '\''; word++)
            fputs("'\\''", out);
    }
    fputs(quoted ? "'" : "", out);
}

/* Writes text of several lines, whose first `length` bytes hold no 0. */
static inline void page_lines(FILE *out, const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        size_t n = strcspn(text + i, "\n\r\t");
        n = n < length - i ? n : length - i;
        draw_escape(out, text + i, n);
        i += n;
        if (i < length)
            fputc(text[i], out);
    }
}

/* Writes what was read and asked for, so that somebody can check it or run it
   again: the command, and the statements. */
static inline void page_input(FILE *out, const struct analysis *a)
{
    const char *text = a->drawing.made ? a->drawing.s.text.at
                                       : a->drawing.source;
    const size_t length = text ? strlen(text) : 0;
    const size_t shown = length < PAGE_INPUT ? length : PAGE_INPUT;
    page_head(out, "Input");
    fputs("<p><code>kern", out);
    for (int i = 0; a->set->word && a->set->word[i]; i++)
        page_word(out, a->set->word[i]);
    fputs("</code></p>\n<details open><summary>", out);
    page_text(out, a->drawing.made ? "Statements that were made of the file"
                                   : "The file");
    fputs("</summary>\n<pre>", out);
    page_lines(out, text, shown);
    fputs("</pre></details>\n", out);
    if (length > shown)
        fprintf(out, "<p>The first %d of %.0f bytes.</p>\n", PAGE_INPUT,
                (double)length);
}

static const char page_style[] =
    "body{font:14px/1.45 Helvetica,Arial,sans-serif;color:#2b2823;"
    "max-width:760px;margin:24px auto;padding:0 16px}\n"
    "h1{font-size:22px;margin:0}h2{font-size:16px;margin:22px 0 6px;"
    "border-bottom:1px solid #c9c2b6}\n"
    "table{border-collapse:collapse;width:100%}"
    "th,td{text-align:left;vertical-align:top;padding:2px 8px 2px 0}\n"
    "th{font-weight:600;white-space:nowrap;width:1%}td:nth-child(2)"
    "{white-space:nowrap}.numbers{font-size:11px}"
    ".numbers td,.numbers th{padding:1px 6px 1px 0}\n"
    ".verdict{font-size:17px}.picture svg{max-width:100%;height:auto}\n"
    "footer{margin-top:24px;color:#6a6256;font-size:12px}\n"
    "tr,li,.picture{break-inside:avoid}h2{break-after:avoid}\n"
    "pre{font-size:11px;line-height:1.3;white-space:pre-wrap;"
    "max-height:24em;overflow:auto}summary{cursor:pointer}\n"
    "@media print{body{margin:0;max-width:none}pre{max-height:none}}"
    "@page{margin:18mm}\n";

/* Writes the title that was told, and of several files, or where none was told,
   the name of the file. */
static inline void page_title(FILE *out, const struct analysis *a)
{
    const char *title = a->set->title;
    int length;
    if (title)
        page_text(out, title);
    if (title && a->set->files > 1)
        fputs(": ", out);
    if (!title || a->set->files > 1)
        page_text(out, stem_of(a->file, &length));
}

/* Writes the whole page. */
static inline int page_write(FILE *out, const struct analysis *a)
{
    const struct analysis loaded = page_loaded(a);
    fputs("<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n"
          "<title>",
          out);
    page_title(out, a);
    fprintf(out, "</title>\n<style>\n%s</style></head><body>\n<h1>",
            page_style);
    page_title(out, a);
    fputs("</h1>\n", out);
    page_verdict(out, a);
    fputs("<div class=\"picture\">\n", out);
    if (draw_to(out, &loaded))
        return -1;
    fputs("</div>\n", out);
    if (a->text.lives > 0 && a->shown == KERN_STANDS)
        fprintf(out, "<p>Forces and thrust line of the picture are %s%s.</p>\n",
                page_of(a, a->live_force != NULL),
                sweep_governs(relied_on(a)) < 0 ? ""
                : a->live_force                 ? ", not at its worst place"
                                : "; its worst place is marked");
    page_note(out, a->text.props > 0,
              "Short arrows onto the stones: pushes (of fill, props) where "
              "these forces need them; none is drawn where none is needed.");
    page_note(out, page_has(a, TEXT_EARTH),
              "Dashed: the back from foot to head, whose lean the pressure of "
              "earth has.");
    page_results(out, a);
    page_structure(out, a);
    page_earth(out, a);
    page_mechanism(out, a);
    page_sweep(out, a);
    page_thrust(out, a, 0);
    if (a->live_force)
        page_thrust(out, &loaded, 1);
    page_drawing(out, a);
    page_assumptions(out, a);
    page_sources(out, a);
    page_input(out, a);
    fputs("<footer>kern " KERN_VERSION
          ". Every verdict was checked against the "
          "structure before it was reported.</footer>\n</body></html>\n",
          out);
    return fflush(out) != 0 || ferror(out) ? -1 : 0;
}

static inline int write_page(const struct analysis *a)
{
    FILE *out;
    char *path = open_output(a, a->set->page, &out);
    return close_output(path, out, !out || page_write(out, a));
}

#endif /* PROGRAM_PAGE_H */
