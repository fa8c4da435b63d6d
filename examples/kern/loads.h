/* loads.h - what statements about soil, mortar and stone put where, in a line
   each: for the report and for the file that is handed in.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_LOADS_H
#define PROGRAM_LOADS_H

#include "../../kern.h"

#include "../parts/json.h"
#include "state.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

enum { LOADS_ROOM = 480, LOADS_QUANTITY = TEXT_SHOW_ROOM + 40 };

static inline const char *plural(int count) { return count == 1 ? "" : "s"; }

/* A coordinate without what the width of a bracket left where it should be
   0. */
static inline double tidy(const struct analysis *a, double x)
{
    return fabs(x) < 2e-6 * mean_size(a) ? 0 : x;
}

/* Returns 1 if a quantity is written in kN, or kPa: a force in N from 10 kN on, a
   stress in Pa likewise. JSON and the tables of --forces have the file's units. */
static inline int loads_is_large(const struct analysis *a, double value,
                                 int per_length)
{
    const struct text_file *t = &a->text;
    return t->force_units && strcmp(t->force_units, "N") == 0
        && (per_length == 0 || strcmp(t->units, "m") == 0)
        && fabs(value) >= 9999.5;
}

/* The unit of a force on a slice of depth 1, where units are known, over
   `per_length` times a length; `large` as loads_is_large() says. */
static inline const char *loads_unit(const struct analysis *a, int per_length,
                                     int large, char out[TEXT_SHOW_ROOM])
{
    const struct text_file *t = &a->text;
    char force[TEXT_SHOW_ROOM], length[TEXT_SHOW_ROOM];
    const char *kilo = large ? "k" : "";
    if (per_length == 0)
        snprintf(out, TEXT_SHOW_ROOM, "%s%.20s", kilo,
                 text_show(force, t->force_units));
    else if (per_length == 2 && strcmp(t->force_units, "N") == 0
             && strcmp(t->units, "m") == 0)
        snprintf(out, TEXT_SHOW_ROOM, "%sPa", kilo);
    else
        snprintf(out, TEXT_SHOW_ROOM, "%s%.20s/%.20s%s", kilo,
                 text_show(force, t->force_units), text_show(length, t->units),
                 per_length == 2 ? "2" : "");
    return out;
}

/* A quantity with its unit, where units are known. */
static inline const char *loads_number(const struct analysis *a, double value,
                                       int per_length, char *out)
{
    const double shown = fabs(value) < 1e-12 ? 0 : value;
    const int large = loads_is_large(a, value, per_length);
    char unit[TEXT_SHOW_ROOM];
    if (a->text.force_units)
        snprintf(out, LOADS_QUANTITY, "%.4g %s", large ? shown / 1000 : shown,
                 loads_unit(a, per_length, large, unit));
    else
        snprintf(out, LOADS_QUANTITY, "%.4g%s", shown,
                 is_per_density(a) ? " per unit of density" : "");
    return out;
}

/* A place. */
static inline const char *loads_at(const struct analysis *a, kern_vec at,
                                   char out[64])
{
    snprintf(out, 64, "(%.4g, %.4g)", tidy(a, (double)at.x),
             tidy(a, (double)at.y));
    return out;
}

/* What a statement fill, earth or prop does. */
static inline void loads_line(const struct analysis *a, int i,
                              char out[LOADS_ROOM])
{
    static const double degrees = 57.295779513082321;
    const struct text_soil *s = &a->text.soil[i];
    char one[LOADS_QUANTITY], two[LOADS_QUANTITY], at[64];
    char name[TEXT_SHOW_ROOM];
    const double fx = (double)s->sum.force.x, fy = (double)s->sum.force.y;
    if (s->kind == TEXT_PROP) {
        snprintf(out, LOADS_ROOM,
                 "up to %.60s on %.60s at %s, toward (%.4g, %.4g), as needed",
                 loads_number(a, s->most, 0, one),
                 text_show(name, a->text.name[s->block]),
                 loads_at(a, s->at, at), (double)s->way.x, (double)s->way.y);
        return;
    }
    if (s->kind == TEXT_EARTH) {
        char back[200] = "", more[80] = "", foot[64], head[64];
        const double lean = s->earth.lean * 57.295779513082321;
        if (fabs((double)(s->head.x - s->foot.x)) > 0)
            snprintf(
                back, sizeof back,
                "; back taken as the line from %.40s to %.40s, %.3g deg %s",
                loads_at(a, s->foot, foot), loads_at(a, s->head, head),
                fabs(lean),
                lean > 0   ? "over the earth"
                : lean < 0 ? "under the earth"
                           : "from upright");
        if (s->earth.surcharge > 0)
            snprintf(more, sizeof more, "; surcharge %.60s",
                     loads_number(a, s->earth.surcharge, 2, one));
        snprintf(out, LOADS_ROOM,
                 "%.60s to the %s and %.60s %s, through %s, on %d face%s%s%s; "
                 "K = %.4g, phi %.4g, delta %.4g%s",
                 loads_number(a, fabs(fx), 0, one), fx < 0 ? "left" : "right",
                 loads_number(a, fabs(fy), 0, two), fy > 0 ? "up" : "down",
                 loads_at(a, s->sum.at, at), s->blocks, plural(s->blocks),
                 !s->live       ? ""
                 : fabs(fy) > 0 ? ": live load, its vertical part as well"
                                : ": live load",
                 back, soil_active(s->earth.phi, s->earth.delta, s->earth.lean),
                 degrees * s->earth.phi, degrees * s->earth.delta, more);
        return;
    }
    int n = snprintf(out, LOADS_ROOM, "weighs %.60s about %s on %d face%s",
                     loads_number(a, -fy, 0, one), loads_at(a, s->sum.at, at),
                     s->blocks, plural(s->blocks));
    if (s->props > 0 && n > 0 && n < LOADS_ROOM)
        snprintf(out + n, (size_t)(LOADS_ROOM - n),
                 "; pushes %d of them back, with up to %.60s in all (left and "
                 "right added), as needed",
                 s->props, loads_number(a, s->most, 0, two));
}

/* What weight that is no stone adds: of a drawing, fill that is weight alone. */
static inline void loads_masses(const struct analysis *a, char out[LOADS_ROOM])
{
    const struct text_file *t = &a->text;
    char one[LOADS_QUANTITY], at[64];
    kern_vec middle;
    middle.x = (kern_real)(t->added_x / t->added);
    middle.y = (kern_real)(t->added_y / t->added);
    snprintf(out, LOADS_ROOM, "weighs %.60s about %s %s %d %s%s",
             loads_number(a, t->added * gravity_of(a), 0, one),
             loads_at(a, middle, at), a->drawing.made ? "on" : "in", t->masses,
             a->drawing.made ? "block" : "statement", plural(t->masses));
}

static const char *const loads_word[] = {"fill", "earth", "prop"};

/* What an axle does. */
static inline void loads_axle(const struct analysis *a, int k,
                              char out[LOADS_ROOM])
{
    const struct text_axle *w = &a->text.wheel[k];
    char one[LOADS_QUANTITY];
    double cone;
    text_road(&a->text, w->x, &cone);
    snprintf(out, LOADS_ROOM, "%.60s at x = %.4g, %.4g wide, %s",
             loads_number(a, w->force, 0, one), w->x, w->width,
             cone > 0 ? "spread by the fill" : "without fill below it");
}

/* What the strength does, or is not asked to. */
static inline void loads_strength(const struct analysis *a,
                                  char out[LOADS_ROOM])
{
    const int points = a->task.s.contacts - line_points(a) - 2 * a->text.props;
    char one[LOADS_QUANTITY], broken[80] = "", point[80] = "";
    if (a->broken > 0)
        snprintf(broken, sizeof broken, ", %d line contact%s bear%s nothing",
                 a->broken, a->broken > 1 ? "s" : "", a->broken > 1 ? "" : "s");
    if (points > 0)
        snprintf(point, sizeof point,
                 "; not applied to %d point contact%s, which %s no width",
                 points, plural(points), points > 1 ? "have" : "has");
    snprintf(
        out, LOADS_ROOM,
        "%.60s: ends of contacts are moved in by up to %.4g where stone "
        "crushes%s%s; tilts and horizontal loads cause no further crushing%s",
        loads_number(a, a->text.strength, 2, one), a->crushed, broken,
        a->settled ? "" : ", and did not settle", point);
}

/* Does water press on a wall? */
static inline int has_water(const struct analysis *a)
{
    for (int i = 0; i < a->text.soils; i++)
        if (a->text.soil[i].kind == TEXT_EARTH
            && a->text.soil[i].earth.water > 0)
            return 1;
    return 0;
}

/* What --thrust found. */
static inline void loads_thrust(const struct analysis *a, char out[LOADS_ROOM])
{
    char one[LOADS_QUANTITY], two[LOADS_QUANTITY], name[TEXT_SHOW_ROOM];
    double least = a->thrust_least, most = a->thrust_most;
    const double tiny = 1e-6 * fmax(fabs(least), fabs(most));
    if (isnan(most)) {
        snprintf(out, LOADS_ROOM, "undecided");
        return;
    }
    least = fabs(least) < tiny ? 0 : least;
    most = fabs(most) < tiny ? 0 : most;
    const int right = most <= 0 && least < 0;
    const double low = right ? fabs(most) : least;
    snprintf(out, LOADS_ROOM,
             "[%.60s, %.60s]: to the %s, of %.60s; the least as it "
             "gives way, the greatest as it is pressed in%s",
             loads_number(a, low, 0, one),
             loads_number(a, right ? -least : most, 0, two),
             right ? "right" : "left", text_show(name, a->set->thrust),
             low > 0 || a->text.props == 0
                 ? ""
                 : "; at 0 the pushes of fill and props replace it");
}

/* Writes to `out` that the blocks weigh what no stone does, where metres and
   the unit of force are known: densities of a weight under a gravity of 9.81.
   Returns 0 if not so. */
static inline int loads_odd(const struct analysis *a, char *out)
{
    static const struct {
        const char *unit;
        double newtons;
    } known[] = {{"N", 1}, {"kN", 1e3}, {"MN", 1e6}};
    const struct text_file *t = &a->text;
    double weight = 0, area = 0, newtons = 0;
    for (size_t k = 0; t->force_units && k < sizeof known / sizeof *known; k++)
        if (strcmp(t->units, "m") == 0
            && strcmp(t->force_units, known[k].unit) == 0)
            newtons = known[k].newtons;
    for (int i = 0; i < a->task.s.blocks; i++) {
        const kern_block *b = &a->task.s.block[i];
        weight += b->fixed ? 0 : (double)b->mass * gravity_of(a);
        area += b->fixed ? 0 : fabs((double)b->area);
    }
    weight *= newtons / 1e3;
    if (!(weight > 0) || (weight > area && weight < 100 * area))
        return 0;
    snprintf(out, LOADS_ROOM,
             "blocks weigh %.3g kN/m3: give densities in kg/m3 with N, in t/m3 "
             "with kN, or in kN/m3 with 'gravity 0 -1'",
             weight / area);
    return 1;
}

/* Calls `line` with each word and its sentence. */
static inline void loads_each(const struct analysis *a,
                              void (*line)(const char *word, const char *what,
                                           void *data),
                              void *data)
{
    char text[LOADS_ROOM], one[LOADS_QUANTITY];
    for (int i = 0; i < a->text.soils; i++) {
        loads_line(a, i, text);
        line(loads_word[a->text.soil[i].kind], text, data);
    }
    if (a->text.masses > 0) {
        loads_masses(a, text);
        line(a->drawing.made ? "fill" : "mass", text, data);
    }
    for (int k = 0; k < a->text.wheels; k++) {
        loads_axle(a, k, text);
        line("axle", text, data);
    }
    if (loads_odd(a, text))
        line("warning", text, data);
    if (a->text.beside > 1e-9) {
        snprintf(text, sizeof text,
                 "%.3g %% of the axles reaches no free block and is left out",
                 100 * a->text.beside);
        line("warning", text, data);
    }
    if (a->text.bond > 0) {
        snprintf(text, sizeof text,
                 "%.60s: tensile strength of line contacts, plastic; forces "
                 "and thrust hold it as a compression",
                 loads_number(a, a->text.bond, 2, one));
        line("bond", text, data);
    }
    if (a->text.strength > 0) {
        loads_strength(a, text);
        line("strength", text, data);
    }
}

/* A line of the report. */
static inline void loads_print(const char *word, const char *what, void *none)
{
    (void)none;
    printf("  %-10s  %s\n", word, what);
}

/* The same as JSON: a list of statement, line, numbers. */
static inline void json_soil(const struct analysis *a)
{
    const char *comma = "";
    if (a->text.bond > 0)
        json_number("bond", a->text.bond);
    if (a->text.strength > 0) {
        json_number("strength", a->text.strength);
        json_number("crushed", a->crushed);
        printf(", \"crushes\": %s, \"broken\": %d",
               a->crushes ? "true" : "false", a->broken);
    }
    if (a->text.masses > 0) {
        json_number("mass_weight", a->text.added * gravity_of(a));
        json_number("mass_x", a->text.added_x / a->text.added);
        json_number("mass_y", a->text.added_y / a->text.added);
    }
    if (a->text.soils == 0)
        return;
    printf(", \"soil\": [");
    for (int i = 0; i < a->text.soils; i++, comma = ", ") {
        const struct text_soil *s = &a->text.soil[i];
        const int prop = s->kind == TEXT_PROP;
        printf("%s{", comma);
        json_string("statement", loads_word[s->kind]);
        printf(", \"line\": %d, \"faces\": %d, \"pushes\": %d", s->line,
               s->blocks, s->props);
        json_number("fx", (double)s->sum.force.x);
        json_number("fy", (double)s->sum.force.y);
        json_number("x", (double)(prop ? s->at.x : s->sum.at.x));
        json_number("y", (double)(prop ? s->at.y : s->sum.at.y));
        json_number("most", s->props > 0 ? s->most : (double)NAN);
        if (s->kind == TEXT_EARTH) {
            json_number("lean", s->earth.lean * 57.295779513082321);
            json_number("foot_x", (double)s->foot.x);
            json_number("foot_y", (double)s->foot.y);
            json_number("head_x", (double)s->head.x);
            json_number("head_y", (double)s->head.y);
        }
        printf("}");
    }
    printf("]");
}

#endif /* PROGRAM_LOADS_H */
