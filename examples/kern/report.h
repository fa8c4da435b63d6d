/* report.h - the report for a person, on stdout.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_REPORT_H
#define PROGRAM_REPORT_H

#include "../../kern.h"

#include "beds.h"
#include "earth.h"
#include "let_go.h"
#include "loads.h"
#include "state.h"
#include "place.h"
#include "sweep.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static inline const char *name_of(const struct analysis *a, int block,
                                  char *shown)
{
    return text_show(shown, a->text.name[block]);
}

/* A rate that is printed with five decimals, without the sign of a zero. */
static inline double rate(double x) { return fabs(x) < 5e-6 ? 0 : x; }

/* What a drawing or a photograph was taken for, before the verdict. */
static inline void report_drawing(const struct analysis *a)
{
    enum { ROWS = 12 };
    const struct shapes *s = &a->drawing.s;
    char kind[TEXT_SHOW_ROOM], label[TEXT_SHOW_ROOM];
    if (!a->drawing.made)
        return;
    printf("%s: reads %d block%s of a %s%s%s\n", a->file, stones(a),
           plural(stones(a)), s->photograph ? "photograph" : "drawing",
           s->units ? ", in " : "", s->units ? s->units : "");
    for (const char *n = s->notes.at, *end; *n; n = end + 1) {
        end = strchr(n, '\n');
        printf("  note        %.*s\n", (int)(end - n), n);
    }
    for (int i = 0; i < s->skips && i < ROWS; i++) {
        const struct shapes_skip *k = s->skip + i;
        printf("  skipped     %d %s", k->count,
               text_show(kind, shapes_at(s, k->kind)));
        if (*shapes_at(s, k->label))
            printf(" on %s", text_show(label, shapes_at(s, k->label)));
        if (k->line > 0)
            printf(", %sline %d", k->count > 1 ? "first " : "", k->line);
        printf("\n");
    }
    if (s->skips > ROWS)
        printf("  skipped     and %d more kinds (--json lists all)\n",
               s->skips - ROWS);
    fflush(stdout);
}

/* A length with its unit, where that is known. */
static inline const char *length_text(const struct analysis *a, double value,
                                      char out[TEXT_SHOW_ROOM])
{
    const int share = a->set->relative != 0;
    char unit[TEXT_SHOW_ROOM];
    snprintf(out, TEXT_SHOW_ROOM, "%.4g%s%.20s", value,
             a->text.units && !share ? " " : "",
             a->text.units && !share ? text_show(unit, a->text.units) : "");
    return out;
}

static inline void report_structure(const struct analysis *a)
{
    int blocks = stones(a) - a->text.fixed, ends = line_points(a);
    int lines = ends / 2;
    int points = a->task.s.contacts - ends - 2 * a->text.props;
    printf("  structure   %d block%s on %d fixed; ", blocks, plural(blocks),
           a->text.fixed);
    printf("%d line contact%s and %d point%s%s", lines, plural(lines), points,
           plural(points),
           a->text.given && !a->text.found ? ", given by the file" : "");
    if (a->text.props > 0)
        printf("; %d push%s as needed", a->text.props,
               a->text.props == 1 ? "" : "es");
    printf("\n");
}

/* Why there is no answer: of a status below 0, or of a number that is missing
   beside one that is not, for which a limit of the command line speaks. */
static inline const char *undecided_why(const struct analysis *a,
                                        kern_status status)
{
    return a->whole && !a->settled
             ? "the ends of contacts that crush did not settle"
         : status == KERN_LIMIT || a->set->limit > 0
             ? "the limit of work ended it (--limit 0 goes "
               "on)"
             : "no proof either way was found: it is "
               "critical within rounding, or sizes and "
               "weights differ by much";
}

/* What is lost where fill does not push back; NULL: nothing, or no fill does. */
static inline const char *lost_without(const struct analysis *a)
{
    const struct analysis *w = a->without;
    if (!w)
        return NULL;
    if (w->shown != KERN_STANDS)
        return w->shown == KERN_FALLS ? "it falls" : "it is undecided";
    if (a->let_go == KERN_STANDS && w->let_go != KERN_STANDS)
        return w->let_go == KERN_FALLS
                 ? "it moves when it is let go"
                 : "it is not shown to stay when it is let go";
    if (as_stated(a) == KERN_STANDS && as_stated(w) != KERN_STANDS)
        return as_stated(w) == KERN_FALLS
                 ? "it falls under the live load as stated"
                 : "it is not known to stand under the live load as stated";
    if (!sweep_loss(a) && sweep_loss(w))
        return "its least factor is below 1 as the live load drives over";
    return NULL;
}

/* Returns 1 if it stands under the live load as stated, but is not shown to stay
   when it is let go. */
static inline int is_loosened(const struct analysis *a)
{
    return a->text.lives > 0 && as_stated(a) == KERN_STANDS
        && asks_raised_loads(a)
        && !(a->live_let_go[0] <= 1 && a->live_let_go[1] >= 1 - 1e-9);
}

/* Right below the verdict: what may turn it round. */
static inline void report_let_go(const struct analysis *a)
{
    const char *lost = lost_without(a);
    printf("  let go      %-9s %s\n", let_go_word(a), a->let_go_why);
    if (as_stated(a) == KERN_FALLS)
        printf("  warning     it falls under the live load as stated: 1 is "
               "outside of its factors\n");
    if (sweep_loss(a))
        printf(
            "  warning     as the live load drives over, %s: its least factor "
            "is below 1\n",
            sweep_loss(a));
    if (is_loosened(a))
        printf("  warning     let go under the live load as stated, it is not "
               "shown to stay\n");
    if (lost)
        printf("  warning     without the passive pressure of the fill %s\n",
               lost);
}

static inline void report_level(const struct analysis *a)
{
    const char *unit = a->set->relative ? " of each contact" : "";
    char length[TEXT_SHOW_ROOM];
    length_text(a, (double)a->m.epsilon, length);
    if (a->measured < 0 || a->m.level < 0) {
        printf("  level       undecided: %s\n", undecided_why(a, a->measured));
        return;
    }
    printf("  level       %-8d", a->m.level);
    if (a->measured == KERN_FALLS && a->shown == KERN_STANDS
        && !(shrinkage(a) > 0))
        printf("  critical: it stands and it falls, as exactly as proofs "
               "are\n");
    else if (a->measured == KERN_FALLS)
        printf("  falls as it is\n");
    else if (a->m.saturated)
        printf("  stands even with every kern closed (steps of %s%s), so\n"
               "                        level and margin do not compare\n",
               length, unit);
    else
        printf("  falls after %d step%s of %s%s\n", a->m.level,
               plural(a->m.level), length, unit);
}

static inline void report_margin(const struct analysis *a)
{
    int falls = a->measured == KERN_FALLS;
    double value = falls ? a->deficit : (double)a->m.margin;
    char length[TEXT_SHOW_ROOM];
    printf("  %-10s  ", falls ? "deficit" : "margin");
    if (a->measured == KERN_LIMIT) {
        printf("undecided by the limit of work (--limit 0 goes on): ");
        if (a->m.holds < 0)
            printf("not known to stand");
        else
            printf("stands at %.4g", (double)a->m.holds);
        if (isfinite((double)a->m.fails))
            printf(", %s %.4g", a->m.fails < a->m.most ? "falls at" : "at most",
                   (double)a->m.fails);
        printf("\n");
        return;
    }
    if (a->measured < 0 || isnan(value)) {
        printf("undecided: %s\n", undecided_why(a, a->measured));
        return;
    }
    if (isinf(value)) {
        printf("none      longer contacts would not help\n");
        return;
    }
    if (!falls && !(value > 1e-9 * mean_size(a))) {
        printf("0         critical: it stands, but with any smaller contact it "
               "falls\n");
        return;
    }
    printf("%-8s  %s each contact %s at both ends",
           length_text(a, value, length),
           a->set->relative ? "by which share of its half" : "how far",
           falls ? "must grow" : "can shrink");
    if (!a->set->relative)
        printf(", %.3g %% of the mean block size", 100 * value / mean_size(a));
    printf("\n");
}

static inline void report_bearing(const struct analysis *a)
{
    if (a->measured != KERN_STANDS)
        return;
    char length[TEXT_SHOW_ROOM];
    printf("  bearing     ");
    if (isnan(a->bearing))
        printf("undecided: %s\n", undecided_why(a, KERN_UNDECIDED));
    else if (isinf(a->bearing))
        printf("none      it needs points alone\n");
    else
        printf("%-8s  it would fall without contacts of up to this length, "
               "%.3g %% of the mean block size\n",
               length_text(a, a->bearing, length),
               100 * a->bearing / mean_size(a));
}

static inline void report_stress(const struct analysis *a)
{
    int most = most_stressed(a, 0, a->task.s.contacts);
    char stress[LOADS_QUANTITY];
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    if (most < 0)
        return;
    const kern_contact *c = &a->task.s.contact[most];
    if (isinf(a->stress[most]))
        printf("  stress      any       ");
    else
        printf("  stress      %-8s  ",
               loads_number(a, a->stress[most], 2, stress));
    printf("mean stress if the most loaded contact, between %s and %s, were "
           "only twice the margin%s long\n",
           name_of(a, c->a, one), name_of(a, c->b, two),
           a->whole ? " and what crushes" : "");
}

static inline void report_limit(const struct analysis *a)
{
    const char *head = a->measured == KERN_FALLS ? "gives way" : "limited by";
    double share;
    for (int shown = 0, k; shown < 4 && (k = next_limit(a, &share)) >= 0;
         shown++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, a->m.margin, a->set->relative);
        char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
        printf("  %-10s  %s and %s at (%.6g, %.6g), which %s", head,
               name_of(a, c->a, one), name_of(a, c->b, two), tidy(a, c->p.x),
               tidy(a, c->p.y), meeting_word[a->critical.meeting[k]]);
        if (a->m.margin > 0 && fabs((double)c->travel) > 0)
            printf(" (shrunk: at %.6g, %.6g)", tidy(a, p.x), tidy(a, p.y));
        printf("\n");
        head = "";
    }
}

/* The centre about which a block turns; where that is a hinge of the shrunk
   structure, the corner of the drawing at which it hinges. */
static inline kern_vec turns_about(const struct analysis *a,
                                   const kern_block *b, kern_motion v)
{
    const double near_by = 1e-4 * mean_size(a);
    kern_vec centre;
    centre.x = b->centre.x - v.vy / v.spin;
    centre.y = b->centre.y + v.vx / v.spin;
    if (a->shown != KERN_STANDS || a->set->mechanism_live)
        return centre;
    for (int k = 0; k < a->task.s.contacts; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        const kern_vec p = kern_contact_at(c, a->m.margin, a->set->relative);
        if (hypot((double)(p.x - centre.x), (double)(p.y - centre.y)) < near_by)
            return c->p;
    }
    return centre;
}

/* How block i moves, seen with gravity pointing down. On the bed that is told it
   slides: that limit analysis lifts it as well says nothing. */
static inline void write_move(FILE *out, const struct analysis *a,
                              const kern_motion *motion, int i,
                              const kern_contact *bed)
{
    kern_motion v = motion[i];
    const kern_block *b = &a->task.s.block[i];
    double g = gravity_of(a);
    double downx = g > 0 ? a->task.s.gravity.x / g : 0;
    double downy = g > 0 ? a->task.s.gravity.y / g : -1;
    double right = -v.vx * downy + v.vy * downx;
    double down = v.vx * downx + v.vy * downy;
    double size = sqrt(fabs((double)b->area)), speed = hypot(v.vx, v.vy);
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM], at[64];

    /* Beyond some ten sizes a centre of rotation says less than a direction. */
    if (fabs(v.spin) * size > 0.1 * speed)
        fprintf(out, "tipping %s about %s", v.spin < 0 ? "right" : "left",
                loads_at(a, turns_about(a, b, v), at));
    else if (bed)
        fprintf(out, "sliding %s%s on the bed between %s and %s",
                right < 0 ? "left" : "right",
                down > 0.25 * fabs(right) ? " and down" : "",
                name_of(a, bed->a, one), name_of(a, bed->b, two));
    else if (fabs(down) > 2 * fabs(right))
        fprintf(out, "%s", down > 0 ? "dropping" : "rising");
    else
        fprintf(out, "sliding %s%s", right < 0 ? "left" : "right",
                down > 0.25 * fabs(right)    ? " and down"
                : down < -0.25 * fabs(right) ? " and up"
                                             : "");
}

static inline void plain_text(FILE *out, const char *text) { fputs(text, out); }

/* The first contact of a bed on which a group slides; NULL: there is none. */
static inline const kern_contact *slides_on(const struct analysis *a,
                                            const kern_critical *moving,
                                            int group)
{
    const kern_vec g = a->task.s.gravity;
    for (int k = 0; k < a->task.s.contacts && moving->meeting; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        const double along = fabs((double)(c->n.x * g.x + c->n.y * g.y));
        if (moving->meeting[k] == KERN_SLIDES && c->a < stones(a)
            && c->b < stones(a) && along > 0.7 * gravity_of(a)
            && (moving->group[c->a] == group || moving->group[c->b] == group))
            return c;
    }
    return NULL;
}

/* The stones of a group that moves as one, and how: many that follow each other
   in the file by the first and the last. Returns 0, and writes nothing, where
   there are none: pushes that slide. */
static inline int write_group(FILE *out, const struct analysis *a,
                              const kern_critical *moving, int group,
                              const char *head,
                              void (*text)(FILE *, const char *))
{
    enum { NAMES = 6 };
    char shown[TEXT_SHOW_ROOM];
    int lead = -1, last = -1, names = 0, written = 0;
    for (int i = 0; i < stones(a); i++) {
        if (moving->group[i] != group)
            continue;
        lead = lead < 0 ? i : lead;
        last = i;
        names++;
    }
    if (lead < 0)
        return 0;
    fputs(head, out);
    if (names > NAMES && names == last - lead + 1) {
        text(out, name_of(a, lead, shown));
        fputs(" to ", out);
        text(out, name_of(a, last, shown));
        names = 0;
    }
    for (int i = lead; i <= last && written < NAMES && written < names; i++) {
        if (moving->group[i] != group)
            continue;
        fputs(written++ > 0 ? " " : "", out);
        text(out, name_of(a, i, shown));
    }
    if (names > NAMES)
        fprintf(out, " and %d more", names - NAMES);
    fprintf(out, " ");
    write_move(out, a, shown_fall(a), lead, slides_on(a, moving, group));
    return 1;
}

/* Prints the groups that move, the first of them behind `head`. */
static inline void report_groups(const struct analysis *a,
                                 const kern_critical *moving, const char *head)
{
    enum { GROUPS = 5 };
    int rest = 0;
    for (int group = 0; group < moving->groups && group < GROUPS; group++)
        if (write_group(stdout, a, moving, group, head, plain_text)) {
            printf("\n");
            head = "              ";
        }
    for (int i = 0; i < stones(a) && moving->groups > GROUPS; i++)
        rest += moving->group[i] >= GROUPS;
    if (rest > 0)
        printf("              and %d more block%s\n", rest, plural(rest));
}

static inline void report_collapse(const struct analysis *a)
{
    kern_critical moving = find_groups(a);
    report_groups(a, &moving,
                  a->shown == KERN_FALLS ? "  falls by    " : "  would fall  ");
    free_groups(&moving);
}

static inline const char *factor_text(double value, double scale,
                                      const char *unit, char out[32])
{
    if (isnan(value))
        return "undecided";
    if (isinf(value))
        return "any";
    snprintf(out, 32, "%.4g%s", fabs(value) < 1e-9 ? 0 : scale * value, unit);
    return out;
}

/* To how many times the part of the thrust may grow: let go where that is asked
   for. */
static inline const char *growth_text(const struct analysis *a,
                                      enum earth_part part, char out[32])
{
    const struct growth *g = &a->earth[part];
    if (!asks_raised_loads(a))
        return factor_text(g->limit, 1, "", out);
    return isnan(g->let_go) ? "not shown" : factor_text(g->let_go, 1, "", out);
}

/* What of the thrust grows, by which analysis, and whether to rely on it. */
static inline void growth_means(const struct analysis *a, enum earth_part part,
                                char out[LOADS_ROOM])
{
    const struct growth *g = &a->earth[part];
    const int asked = asks_raised_loads(a);
    const int both = has_growth(a, EARTH_HORIZONTAL);
    const int relied = both && part == earth_governs(a)
                    && isfinite(asked ? g->let_go : g->limit);
    char limit[32];
    snprintf(out, LOADS_ROOM, "times the %s%s%s%s%s",
             part == EARTH_HORIZONTAL ? "horizontal part of its thrust alone"
             : both ? "whole thrust, horizontal and vertical part together"
                    : "whole thrust",
             asked ? ", when it is let go; limit analysis "
                   : ", by limit analysis",
             asked ? factor_text(g->limit, 1, "", limit) : "",
             relied ? ". Rely on this factor" : "",
             relied && part == EARTH_HORIZONTAL
                 ? ": it compares forces and moments as a design does"
                 : "");
}

/* How it falls just beyond the factor of limit analysis of a part of the thrust,
   as a structure that falls. */
static inline struct analysis beyond_growth(const struct analysis *a,
                                            enum earth_part part)
{
    struct analysis beyond = *a;
    beyond.shown = KERN_FALLS;
    beyond.motion = beyond.fall = a->earth[part].motion;
    return beyond;
}

/* Why a factor of limit analysis may be too high. */
#define SLIDING_PARTS ", in which sliding stones part"

/* What factors count on where the file states no strength. */
#define ENDLESS_STRENGTH "the stone is taken as infinitely strong"

/* Raised load k; where the limit did not end it, none that is raised exists or
   none was found. Where the load factor has no bound, a path that ended says no
   more than that: it doubled its end until then. */
static inline const char *shown_text(const struct analysis *a, int k,
                                     char out[32])
{
    const double raised = k == LIVE ? a->live_let_go[1] : a->raised_load[k];
    const double plain = k == LIVE ? a->live : a->load[k];
    if (isnan(raised) && !a->cut[k])
        return "not shown";
    factor_text(raised, 1, "", out);
    if (isinf(plain) && isfinite(raised))
        strcat(out, " or more");
    return isfinite(raised) ? out : factor_text(raised, 1, "", out);
}

/* Between which factors of the live load it stays let go, where that is asked for,
   or stands. Returns 0, and writes a word into `low`, where none are known. */
static inline int live_text(const struct analysis *a, char low[40],
                            char high[40])
{
    const int asked = asks_raised_loads(a);
    char text[32];
    if (a->lived != KERN_STANDS || (asked && isnan(a->live_let_go[0]))) {
        snprintf(low, 40, "%s",
                 a->lived == KERN_FALLS    ? "none"
                 : a->lived != KERN_STANDS ? "undecided"
                                           : "not shown");
        return 0;
    }
    snprintf(
        low, 40, "%s",
        factor_text(asked ? a->live_let_go[0] : a->live_least, 1, "", text));
    snprintf(high, 40, "%s",
             asked ? shown_text(a, LIVE, text)
                   : factor_text(a->live, 1, "", text));
    return 1;
}

/* Before the range of the live load that where fill does not push back. */
static inline void report_without(const struct analysis *a)
{
    char low[40], high[40] = "";
    if (!a->without)
        return;
    const int known = live_text(a->without, low, high);
    printf("  no passive  %s%s%s%s%s: %sfactors of the live load%s\n",
           known ? "[" : "", low, known ? ", " : "", high, known ? "]" : "",
           known ? "rely on these " : "", passive_note(a->without));
}

/* The range of the live load: first that in which it stays let go, where that is
   asked for, then that of limit analysis, as report_load() has loads. */
static inline void report_live(const struct analysis *a)
{
    const int asked = asks_raised_loads(a);
    char low[32], high[32];
    report_without(a);
    if (a->lived != KERN_STANDS)
        printf("  live        %s\n",
               a->lived == KERN_FALLS
                   ? "none: it falls at every factor of the live load"
                   : "undecided: factors of the live load");
    else if (asked && isnan(a->live_let_go[0]))
        printf("  live        not shown: no factor of the live load at which "
               "it stays when it is let go\n");
    else if (asked)
        printf("  live        [%s, %s]: factors of the live load at which it "
               "stays when it is let go%s\n",
               factor_text(a->live_let_go[0], 1, "", low),
               shown_text(a, LIVE, high), passive_note(a));
    if (a->lived == KERN_STANDS)
        printf("  live limit  [%s, %s]: %s%s\n",
               factor_text(a->live_least, 1, "", low),
               factor_text(a->live, 1, "", high),
               asked ? "limit analysis"
                     : "factors of the live load at which it stands, by limit "
                       "analysis (--raised: let go)",
               !is_lower(a, LIVE) ? ""
               : isinf(a->live)   ? ", no bound"
                                  : SLIDING_PARTS ": too high");
    if (!(a->text.strength > 0))
        printf("  strength    none is stated: " ENDLESS_STRENGTH "\n");
}

/* The load factors: those that Coulomb friction bears from rest, wherever they
   are asked for, then those of limit analysis. Page and JSON have the same two,
   each under a name of its own, however near they are to each other. */
static inline void report_load(const struct analysis *a, const char *stay)
{
    const int lower_left = is_lower(a, LEFT), lower_right = is_lower(a, RIGHT);
    const int asked = has_friction_loads(a);
    char left[32], right[32];
    if (asked)
        printf("  load        %s left, %s right: horizontal load, in g, that "
               "Coulomb friction bears as it grows from 0%s\n",
               shown_text(a, LEFT, left), shown_text(a, RIGHT, right), stay);
    printf("  load limit  %s left, %s right: %slimit analysis%s%s%s\n",
           factor_text(a->load[LEFT], 1, "", left),
           factor_text(a->load[RIGHT], 1, "", right),
           asked ? "" : "horizontal load, in g, by ",
           lower_left || lower_right ? SLIDING_PARTS ": too high" : "",
           lower_left && lower_right ? ""
           : lower_left              ? " to the left"
           : lower_right             ? " to the right"
           : asks_raised_loads(a)    ? ""
                                     : " (--raised: of friction)",
           asked ? "" : stay);
}

/* An angle, or why it is not known. */
static inline const char *angle_text(double angle, int cut, double scale,
                                     const char *unit, char out[32])
{
    return isnan(angle) && !cut ? "not shown"
                                : factor_text(angle, scale, unit, out);
}

/* A tilt to each side; `cut` tells where the limit of work ended it. */
static inline void report_tilt(const char *name, const double angle[2],
                               const int cut[2], const char *what)
{
    static const double degrees = 57.295779513082321;
    char left[32], right[32];
    printf("  %-10s  %s left, %s right, ", name,
           angle_text(angle[LEFT], cut[LEFT], 1, "", left),
           angle_text(angle[RIGHT], cut[RIGHT], 1, "", right));
    printf("in rad: %s and %s%s\n",
           angle_text(angle[LEFT], cut[LEFT], degrees, " deg", left),
           angle_text(angle[RIGHT], cut[RIGHT], degrees, " deg", right), what);
}

static inline void report_loads(const struct analysis *a)
{
    const char *stay = a->text.loads > 0 ? " (loads stay as they are)"
                     : a->text.lives > 0 ? " (without the live load)"
                                         : "";
    const int tilts = has_friction_loads(a) && !has_loads(a);
    const int undecided[2] = {1, 1};
    if (a->shown >= 0 && a->text.lives > 0)
        report_live(a);
    if (a->shown != KERN_STANDS || !(gravity_of(a) > 0))
        return;
    report_load(a, stay);

    /* Weight alone at a slant is a load sideways: what friction bears of it is
       the tilt that friction bears. */
    if (tilts) {
        const double angle[2] = {atan(a->raised_load[LEFT]),
                                 atan(a->raised_load[RIGHT])};
        report_tilt("tilt", angle, a->cut,
                    ": Coulomb friction, growing from 0");
    }
    report_tilt("tilt limit", a->tilt, undecided,
                has_friction_loads(a) && has_loads(a)
                    ? ": limit analysis; not known by Coulomb friction, since "
                      "loads do not turn with gravity"
                : is_lower(a, LEFT) || is_lower(a, RIGHT)
                    ? ": limit analysis" SLIDING_PARTS
                    : ": limit analysis");
}

static inline void report_forces(const struct analysis *a)
{
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    if (a->shown != KERN_STANDS) {
        printf("  forces      none that hold every block\n");
        return;
    }
    printf("  forces      %-10s %-10s %11s %11s %11s %11s %8s\n", "from", "on",
           "x", "y", "normal", "tangential", "of mu");
    for (int k = 0; k < a->task.s.contacts; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, shrinkage(a), a->set->relative);
        printf("              %-10s %-10s %11.5g %11.5g", name_of(a, c->a, one),
               name_of(a, c->b, two), tidy(a, p.x), tidy(a, p.y));
        double f = (double)a->force[k].normal;
        double r = (double)a->force[k].tangential;
        if (fabs(r) < 1e-9 * f)
            r = 0;
        if (f * c->mu > 0)
            printf(" %11.5g %11.5g %7.0f%%\n", f, r,
                   100 * fabs(r) / (f * c->mu));
        else
            printf(" %11.5g %11.5g %8s\n", f, r, "-");
    }
}

static inline void report_resultants(const struct analysis *a)
{
    const struct draw_scene scene = scene_of(a);
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    struct draw_pt at, f;
    double least = 0; /* below, a component is rounding */
    if (!scene.force)
        return;
    for (int k = 0; k < a->task.s.contacts; k++)
        if (draw_resultant(&scene, k, &at, &f))
            least = fmax(least, 1e-9 * hypot(f.x, f.y));
    printf("  resultants  %-10s %-10s %11s %11s %11s %11s\n", "from", "on", "x",
           "y", "fx", "fy");
    for (int k = 0; k < a->task.s.contacts; k++)
        if (draw_resultant(&scene, k, &at, &f))
            printf("              %-10s %-10s %11.5g %11.5g %11.5g %11.5g\n",
                   name_of(a, a->task.s.contact[k].a, one),
                   name_of(a, a->task.s.contact[k].b, two), tidy(a, at.x),
                   tidy(a, at.y), fabs(f.x) < least ? 0 : f.x,
                   fabs(f.y) < least ? 0 : f.y);
}

static inline void report_motion(const struct analysis *a)
{
    const kern_motion *motion = shown_motion(a);
    char shown[TEXT_SHOW_ROOM];
    if (!motion) {
        printf("  motion      none\n");
        return;
    }
    printf("  motion      %-10s %11s %11s %11s\n", "block", "vx", "vy", "spin");
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed)
            continue;
        printf("              %-10s %11.5f %11.5f %11.5f\n",
               name_of(a, i, shown), rate(motion[i].vx), rate(motion[i].vy),
               rate(motion[i].spin));
    }
}

static inline void report_profile(const struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    if (a->profiled < 0) {
        printf("  profile     undecided\n");
        return;
    }
    printf("  profile     %-10s %11s %11s %11s\n", "block", "margin",
           "load left", "load right");
    for (int i = 0; i < stones(a); i++) {
        if (a->task.s.block[i].fixed)
            continue;
        printf("              %-10s %11.5f %11.5f %11.5f\n",
               name_of(a, i, shown), (double)a->fate[MARGIN][i],
               (double)a->fate[LOAD_LEFT][i], (double)a->fate[LOAD_RIGHT][i]);
    }
    if (a->text.props > 0)
        return; /* the means are of pushes as well */
    printf("              %-10s %11.5f %11.5f %11.5f\n", "mean",
           (double)a->all[MARGIN].mean, (double)a->all[LOAD_LEFT].mean,
           (double)a->all[LOAD_RIGHT].mean);
    printf("              %-11s%11.5f %11.5f %11.5f\n", "weaker half",
           (double)a->all[MARGIN].weak, (double)a->all[LOAD_LEFT].weak,
           (double)a->all[LOAD_RIGHT].weak);
    printf("  drop        %-10.4g expected under shaking, in mean blocks; more "
           "is worse\n",
           expected_drop(a));
}

/* Distance between two outlines that do not cross: of a corner from an edge. */
static inline double gap_between(const kern_block *a, const kern_block *b)
{
    double least = HUGE_VAL;
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < a->vertices; i++)
            for (int j = 0; j < b->vertices; j++) {
                kern_vec p = a->vertex[i], q = b->vertex[j];
                kern_vec r = b->vertex[j + 1 < b->vertices ? j + 1 : 0];
                double ex = r.x - q.x, ey = r.y - q.y;
                double x = p.x - q.x, y = p.y - q.y;
                double at = (x * ex + y * ey) / (ex * ex + ey * ey);
                at = at > 0 ? at < 1 ? at : 1 : 0;
                least = fmin(least, hypot(x - at * ex, y - at * ey));
            }
        const kern_block *other = a;
        a = b;
        b = other;
    }
    return least;
}

/* Given contacts whose normal leads from b, over the contact, into a. */
static inline void report_normals(const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    int shown = 0;
    for (int k = 0; k < s->contacts && a->text.given && shown < 5; k++) {
        const kern_contact *c = &s->contact[k];
        const kern_vec u = s->block[c->a].centre, v = s->block[c->b].centre;
        if ((c->p.x - u.x) * c->n.x + (c->p.y - u.y) * c->n.y >= 0
            || (v.x - c->p.x) * c->n.x + (v.y - c->p.y) * c->n.y >= 0)
            continue;
        printf("  contact %s %s at (%.6g, %.6g): its normal, %.4g %.4g, leads "
               "into %s\n",
               name_of(a, c->a, one), name_of(a, c->b, two), (double)c->p.x,
               (double)c->p.y, (double)c->n.x, (double)c->n.y,
               name_of(a, c->a, one));
        shown++;
    }
}

/* Warns of a friction above 2: probably degrees where a tangent is meant. */
static inline void report_friction(const struct analysis *a)
{
    const double mu = (double)a->task.options.mu;
    if (mu > 2)
        printf("  friction %g is that of %.4g degrees: MU is the tangent of "
               "the friction angle\n",
               mu, 57.295779513082321 * atan(mu));
}

/* Options of drawings that a file of another kind leaves without effect. */
static inline void report_undrawn(const struct analysis *a)
{
    const struct shapes_asked *drawing = &a->set->drawing;
    int named = 0;
    for (int k = 0; k < drawing->friction_words; k++)
        named |= strchr(drawing->frictions[k], '=') != NULL;
    if (!a->drawing.made
        && (drawing->layers > 0 || drawing->has_ground || named
            || drawing->phi > 0))
        printf("  the file is no drawing, without effect:%s%s%s%s\n",
               drawing->layers > 0 ? " --layer" : "",
               drawing->has_ground ? " --ground" : "",
               drawing->phi > 0 ? " --phi" : "", named ? " --mu NAME=MU" : "");
}

/* Options that this file, or another option, leaves without effect. */
static inline void report_unheard(const struct analysis *a)
{
    const struct settings *set = a->set;
    const struct {
        const char *name;
        int asked;
    } option[] = {{"--near", set->touching},
                  {"--lone", set->lone},
                  {"--gap", set->gap > 0},
                  {"--overlap", set->overlap > 0},
                  {"--measured", pose_error(a) > 0}};
    const char *head = a->text.found ? "  contacts are those of the file's "
                                       "options, without effect:"
                                     : "  the file gives its contacts, without "
                                       "effect:";
    for (size_t k = 0; k < sizeof option / sizeof *option; k++) {
        if (!a->text.given || !option[k].asked)
            continue;
        printf("%s %s", head, option[k].name);
        head = "";
    }
    if (!*head)
        printf("\n");
    report_undrawn(a);
    if (pose_error(a) > 0 && !a->text.given && shrinkage(a) > 0)
        printf("  whether it is certain within the error is not told with "
               "--at\n");
}

/* The block nearest to one that touches nothing. Returns 0 where it is alone. */
static inline int report_nearest(const struct analysis *a, int i)
{
    const kern_structure *s = &a->task.s;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    double least = HUGE_VAL;
    int nearest = -1;
    for (int j = 0; j < s->blocks; j++) {
        double gap = j == i ? HUGE_VAL
                            : gap_between(&s->block[i], &s->block[j]);
        if (!(gap < least))
            continue;
        least = gap;
        nearest = j;
    }
    if (nearest < 0)
        return 0;
    printf("  %s touches nothing; nearest gap %.4g, to %s%s\n",
           name_of(a, i, one), least, name_of(a, nearest, two),
           least <= mean_size(a) ? " (--gap)" : "");
    return 1;
}

/* A block whose contacts are gone since they crushed. Returns 0 where it has
   none. */
static inline int report_crushed(const struct analysis *a, int i)
{
    const int from = a->task.s.contacts, to = from + 2 * a->broken;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    for (int k = from; k < to; k++) {
        const kern_contact *c = &a->whole[k];
        if (c->a != i && c->b != i)
            continue;
        printf("  %s bears on nothing: its contact with %s crushed\n",
               name_of(a, i, one), name_of(a, c->a == i ? c->b : c->a, two));
        return 1;
    }
    return 0;
}

/* What a structure that falls may lack: ground, or contacts. */
static inline void report_lack(const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    int shown = 0;
    if (a->verdict != KERN_FALLS)
        return;
    if (a->text.fixed == 0)
        printf("  no block is fixed: name the ground with 'fixed'\n");
    if (s->gravity.y > 0)
        printf("  gravity points up: %.6g %.6g\n", (double)s->gravity.x,
               (double)s->gravity.y);
    report_normals(a);
    for (int i = 0; i < s->blocks && shown < 5; i++) {
        int touches = s->block[i].fixed || i >= stones(a)
                   || (a->text.given && !a->text.found);
        for (int k = 0; k < s->contacts && !touches; k++)
            touches = s->contact[k].a == i || s->contact[k].b == i;
        if (!touches)
            shown += report_crushed(a, i) || report_nearest(a, i);
    }
}

/* The verdict, as soon as it is known. */
static inline void report_verdict(const struct analysis *a)
{
    printf("%s: %s%s", a->file, status_word(a), a->crushes ? " (crushes)" : "");
    if (a->text.lives > 0)
        printf(" without the live load");
    if (shrinkage(a) > 0)
        printf(" when shrunk by %.6g%s", (double)shrinkage(a),
               a->set->relative ? " of each contact" : "");
    if (a->certain >= 0)
        printf(a->certain ? ", as far as +- %.4g tells"
                          : "; within +- %.4g it may be otherwise",
               pose_error(a));
    if (a->certain >= 0 && a->verdict == KERN_STANDS) {
        printf(": margin ");
        if (a->interval.low > 0)
            printf("%sat least %.4g, ", a->certain ? "" : "usually ",
                   (double)a->interval.low);
        printf("probably %.4g", a->probable);
        if (a->certain)
            printf("; may settle by %.4g", (double)a->interval.settles);
    }
    if (is_open_certain(a) && !is_open(a->verdict))
        printf("; whether within +- %.4g is undecided: limit", pose_error(a));
    printf("\n");
    if (is_open(a->verdict))
        printf("  undecided   %s\n", undecided_why(a, a->verdict));
    report_friction(a);
    report_unheard(a);
    report_lack(a);
    fflush(stdout);
}

static inline void report_raised(const struct analysis *a)
{
    printf("  raised      ");
    if (a->raised != KERN_STANDS) {
        printf("%s\n", a->raised == KERN_FALLS ? "no: it falls" : "undecided");
        return;
    }
    printf("%s", a->raising == KERN_RAISED ? "yes       " LOAD_BUILDS_UP
                 : a->raising == KERN_HANGS
                     ? "hangs     some blocks rest on nothing"
                     : "not shown  no forces were found that its load builds "
                       "up");
    if (a->raising == KERN_RAISED && !isnan(a->reserve))
        printf("; reserve %.4g g to either side", a->reserve);
    printf("\n");
}

/* The least friction of an answer, or why there is none. */
static inline void print_friction(double least, kern_status status,
                                  const char *what)
{
    if (!isnan(least))
        printf("  friction    %-8.4g  %s\n", least, what);
    else
        printf("  friction    %-8s  %s%s\n",
               status == KERN_LIMIT ? "undecided" : "none", what,
               status == KERN_LIMIT ? "" : ", up to 8 times that of the file");
}

/* Beside the range of the live load, and beside loads with near contacts: what
   Coulomb friction bears, from rest. */
static inline void report_raised_loads(const struct analysis *a)
{
    char left[32], right[32];
    if (a->raised != KERN_STANDS)
        return;
    if (gravity_of(a) > 0 && is_near(a))
        printf("  raised load %s left, %s right: where stones slide without "
               "parting, as the load grows from 0\n",
               shown_text(a, LEFT, left), shown_text(a, RIGHT, right));
}

static inline void report_error(const struct analysis *a)
{
    printf("  bears       ");
    if (isnan(a->bears))
        printf("undecided\n");
    else {
        printf("%-8.4g  times an error of %.4g in place", a->bears,
               (double)a->set->own_error);
        if (a->set->own_turn > 0)
            printf(" and %.4g rad in angle", (double)a->set->own_turn);
        printf("\n");
    }
    if (frictions_taken(a) == 0)
        printf("  friction    as given  every contact has a friction of its "
               "own\n");
    else {
        print_friction(a->least_friction, a->slid,
                       "the least of the verdict: it stands");
        print_friction(a->least_friction_let_go, a->slid_let_go,
                       "the least at which it stays let go");
    }
    if (!isnan(a->tilt_let_go[LEFT]) && !isnan(a->tilt_let_go[RIGHT]))
        printf("  tilt let go %.4g left, %.4g right, in rad: up to these it "
               "stays let go\n",
               a->tilt_let_go[LEFT], a->tilt_let_go[RIGHT]);
}

static inline void report_sequence(const struct analysis *a)
{
    int weakest = weakest_step(a);
    char shown[TEXT_SHOW_ROOM];
    printf("  sequence    margin after each block%s%s\n",
           a->text.props > 0 ? ", without pushes" : "",
           gravity_of(a) > 0 ? ", and the chance that it stays on those before"
                             : "");
    for (int i = 0; i < stones(a); i++)
        if (!a->task.s.block[i].fixed) {
            printf("    %-16s ", name_of(a, i, shown));
            if (isnan(a->sequence[i]))
                printf("undecided\n");
            else
                printf("%-10.4g", a->sequence[i]);
            if (!isnan(a->sequence[i]) && a->laid[i] >= 0)
                printf(" %.3f", a->laid[i]);
            else if (!isnan(a->sequence[i]))
                printf(" %s", a->laid[i] < 0 ? "falls" : "-");
            if (!isnan(a->sequence[i]))
                printf("%s\n", i == weakest ? "  weakest" : "");
        }
}

/* Of all blocks, or of the one that was named. What falls has no such chance,
   whichever of its blocks was laid last. */
static inline void report_stays(const struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    if (a->verdict == KERN_FALLS) {
        printf("  stays       no: the whole structure falls, whichever block "
               "was laid last\n");
        return;
    }
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (!is_asked(a, i))
            continue;
        if (isnan(a->stays[i]))
            printf("  stays       undecided whether");
        else
            printf("  stays       %-8.3f  chance that", a->stays[i]);
        printf(" %s, laid last, stays where it is let go\n",
               name_of(a, i, shown));
    }
}

static inline void report_near(const struct analysis *a)
{
    const struct settings *set = a->set;
    const int real = set->raised || set->own_error > 0 || set->sequence
                  || set->stays;
    printf("  near contacts count in what follows, but not in the verdict "
           "above%s\n",
           real ? ", nor in what --raised, --error, --sequence "
                  "and --stays ask"
                : "");
}

static inline void report_growth(const struct analysis *a)
{
    char value[32], means[LOADS_ROOM];
    for (int k = 0; k < EARTH_PARTS; k++) {
        const enum earth_part part = earth_order(a, k);
        const struct analysis beyond = beyond_growth(a, part);
        kern_critical moving;
        if (!has_growth(a, part))
            continue;
        growth_means(a, part, means);
        printf("  earth grows %-8s  %s\n", growth_text(a, part, value), means);
        moving = find_groups(&beyond);
        report_groups(&beyond, &moving, "    beyond it ");
        free_groups(&moving);
    }
}

static inline void report_thrust(const struct analysis *a)
{
    char thrust[LOADS_ROOM];
    if (!a->set->thrust || a->shown != KERN_STANDS)
        return;
    loads_thrust(a, thrust);
    loads_print("thrust", thrust, NULL);
}

/* What the numbers leave out, and what a bond is. */
static inline void report_warnings(const struct analysis *a)
{
    if (a->text.lives > 0)
        printf("  live load   is left out of verdict, margin, stress, load and "
               "tilt, and counts in 'live'\n");
    if (has_water(a))
        printf(
            "  warning     uplift of the water under the wall is not counted: "
            "add it as an upward 'load'\n");
    if (a->text.bond > 0)
        printf("  warning     the bond is plastic: it acts over the whole of a "
               "joint that opens; of brittle mortar\n"
               "              expect what is shown without 'bond'\n");
}

static inline void report(const struct analysis *a)
{
    report_let_go(a);
    report_structure(a);
    loads_each(a, loads_print, NULL);
    report_warnings(a);
    if (is_near(a))
        report_near(a);
    if (shrinkage(a) > 0)
        printf("  level, margin and bearing are those of contacts as they are, "
               "loads and tilts at %.6g\n",
               (double)shrinkage(a));
    report_level(a);
    report_margin(a);
    report_bearing(a);
    report_stress(a);
    report_limit(a);
    if (a->set->raised)
        report_raised(a);
    if (a->set->own_error > 0)
        report_error(a);
    if (a->set->sequence)
        report_sequence(a);
    if (a->set->stays)
        report_stays(a);
    report_collapse(a);
    report_loads(a);
    if (a->set->raised)
        report_raised_loads(a);
    report_growth(a);
    report_thrust(a);
    report_sweep(a);
    if (a->set->place)
        report_places(a);
    if (a->set->forces)
        report_forces(a);
    if (a->set->forces)
        report_resultants(a);
    if (a->set->forces)
        report_beds(a);
    if (a->set->mechanism)
        report_motion(a);
    if (a->set->profile)
        report_profile(a);
    if (a->set->files > 1)
        printf("\n");
}

#endif /* PROGRAM_REPORT_H */
