/* report_json.h - the report as JSON, one object a file, on stdout. help.h
   lists the keys.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_REPORT_JSON_H
#define PROGRAM_REPORT_JSON_H

#include "../../kern.h"

#include "../parts/json.h"
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

static inline void json_count(const char *key, int value, int exists)
{
    if (exists)
        printf(", \"%s\": %d", key, value);
    else
        printf(", \"%s\": null", key);
}

static inline void json_known(const char *key, double value, int known)
{
    json_number(key, known ? value : (double)NAN);
}

static inline void json_flag(const char *key, int value, int known)
{
    printf(", \"%s\": %s", key, !known ? "null" : value ? "true" : "false");
}

static inline void json_word(const char *key, const char *word)
{
    if (!word) {
        printf(", \"%s\": null", key);
        return;
    }
    printf(", ");
    json_string(key, word);
}

/* Opens an object: two blocks, and a place between them. */
static inline void json_between(const struct analysis *a, const char *comma,
                                const kern_contact *c, double x, double y)
{
    printf("%s{", comma);
    json_string("a", a->text.name[c->a]);
    printf(", ");
    json_string("b", a->text.name[c->b]);
    json_number("x", x);
    json_number("y", y);
}

static inline void json_contacts(const struct analysis *a)
{
    int stands = a->shown == KERN_STANDS;
    printf(", \"contacts\": [");
    for (int k = 0; k < a->task.s.contacts; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, shrinkage(a), a->set->relative);
        json_between(a, k > 0 ? ", " : "", c, (double)p.x, (double)p.y);
        json_number("nx", (double)c->n.x);
        json_number("ny", (double)c->n.y);
        json_number("mu", (double)c->mu);
        json_number("travel", fabs((double)c->travel));
        json_known("normal", (double)a->force[k].normal, stands);
        json_known("tangential", (double)a->force[k].tangential, stands);
        printf("}");
    }
    printf("]");
}

/* One resultant an interface, and where the thrust goes through blocks. */
static inline void json_thrust(const struct analysis *a)
{
    const struct draw_scene scene = scene_of(a);
    const kern_structure *s = &a->task.s;
    struct draw_pt at, f;
    struct draw_pt(*through)[2] = array(s->blocks, sizeof *through);
    int *presses = scene.force && through ? draw_thrust_of(&scene, through)
                                          : NULL;
    const char *comma = "";
    printf(", \"resultants\": [");
    for (int k = 0; presses && k < s->contacts; k++) {
        if (!draw_resultant(&scene, k, &at, &f))
            continue;
        json_between(a, comma, &s->contact[k], at.x, at.y);
        json_number("fx", f.x);
        json_number("fy", f.y);
        int most = most_stressed(a, k, draw_interface(s, k));
        json_number("stress", most < 0 ? (double)NAN : a->stress[most]);
        printf("}");
        comma = ", ";
    }
    printf("], \"thrust\": [");
    comma = "";
    for (int i = 0; presses && i < s->blocks; i++) {
        if (presses[i] != 2 || s->block[i].fixed)
            continue;
        printf("%s{", comma);
        json_string("block", a->text.name[i]);
        json_number("x1", through[i][0].x);
        json_number("y1", through[i][0].y);
        json_number("x2", through[i][1].x);
        json_number("y2", through[i][1].y);
        printf("}");
        comma = ", ";
    }
    printf("]");
    free(through);
    free(presses);
}

static inline void json_motion(const struct analysis *a)
{
    const kern_motion *motion = shown_motion(a);
    if (!motion) {
        printf(", \"motion\": null");
        return;
    }
    printf(", \"motion\": [");
    int first = 1;
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed)
            continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("vx", (double)motion[i].vx);
        json_number("vy", (double)motion[i].vy);
        json_number("spin", (double)motion[i].spin);
        printf("}");
        first = 0;
    }
    printf("]");
}

static inline void json_limits(const struct analysis *a, int good)
{
    const char *comma = "";
    double share;
    printf(", \"limited_by\": [");
    for (int k; good && (k = next_limit(a, &share)) >= 0; comma = ", ") {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, a->m.margin, a->set->relative);
        json_between(a, comma, c, (double)p.x, (double)p.y);
        json_number("corner_x", (double)c->p.x);
        json_number("corner_y", (double)c->p.y);
        json_number("share", share);
        printf(", ");
        json_string("does", meeting_word[a->critical.meeting[k]]);
        printf("}");
    }
    printf("], \"would_fall\": [");
    kern_critical moving = {NULL, NULL, NULL, -1, 0};
    if (good)
        moving = find_groups(a);
    for (int group = 0; group < moving.groups; group++) {
        printf("%s[", group > 0 ? ", " : "");
        comma = "\"";
        for (int i = 0; i < a->task.s.blocks; i++) {
            if (moving.group[i] != group)
                continue;
            printf("%s", comma);
            json_text(a->text.name[i]);
            comma = "\", \"";
        }
        printf("\"]");
    }
    printf("]");
    free_groups(&moving);
}

/* Of what is undecided the numbers are null, and the list is empty. */
static inline void json_profile(const struct analysis *a, int good)
{
    int known = good && a->profiled >= 0, first = 1;
    const int mean = known && a->text.props == 0; /* not of pushes */
    json_known("progressive_margin", (double)a->all[MARGIN].mean, mean);
    json_known("progressive_load", mean_load(a), mean);
    json_known("weak_margin", (double)a->all[MARGIN].weak, mean);
    json_known("weak_load", weak_load(a), mean);
    json_known("expected_drop", expected_drop(a), mean);
    printf(", \"profile\": [");
    for (int i = 0; known && i < stones(a); i++) {
        if (a->task.s.block[i].fixed)
            continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("margin", (double)a->fate[MARGIN][i]);
        json_number("load_left", (double)a->fate[LOAD_LEFT][i]);
        json_number("load_right", (double)a->fate[LOAD_RIGHT][i]);
        json_number("load", fate_load(a, i));
        printf("}");
        first = 0;
    }
    printf("]");
}

static inline void json_error(const struct analysis *a)
{
    printf(", \"error\": ");
    if (!a->error[0]) {
        printf("null");
        return;
    }
    printf("\"");
    json_text(a->file);
    if (a->line > 0)
        printf(":%d", a->line);
    printf(": ");
    json_text(a->error);
    printf("\"");
}

/* Which numbers are null because they are undecided; others that are null are
   without limit, or belong to the other verdict. */
static inline void json_raised(const struct analysis *a, int good)
{
    int known = good && a->raised == KERN_STANDS;
    if (known) {
        printf(", ");
        json_string("raised", raising_word[a->raising]);
    } else
        printf(", \"raised\": null");
    json_known("reserve", a->reserve, known);
    if (a->text.lives > 0)
        json_known("raised_live", a->raised_load[LIVE], good);
}

/* A chance, null where there is none. */
static inline void json_chance(double chance)
{
    json_number("stays", chance >= 0 ? chance : (double)NAN);
}

static inline void json_sequence(const struct analysis *a, int good)
{
    int weakest = good ? weakest_step(a) : -1, first = 1;
    printf(", \"sequence\": [");
    for (int i = 0; good && i < stones(a); i++) {
        if (a->task.s.block[i].fixed)
            continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("margin", a->sequence[i]);
        json_chance(a->laid[i]);
        printf("}");
        first = 0;
    }
    printf("], ");
    if (weakest < 0)
        printf("\"weakest_step\": null");
    else
        json_string("weakest_step", a->text.name[weakest]);
}

/* Of the block that was named. */
static inline void json_stays(const struct analysis *a, int good)
{
    double chance = (double)NAN;
    for (int i = 0; good && i < a->task.s.blocks; i++)
        if (strcmp(a->text.name[i], a->set->stays) == 0)
            chance = a->stays[i];
    json_chance(chance);
}

/* All blocks of the file, in its order. */
static inline void json_each(const struct analysis *a, int good)
{
    printf(", \"stays\": [");
    for (int i = 0; good && i < stones(a); i++) {
        printf("%s{", i > 0 ? ", " : "");
        json_string("block", a->text.name[i]);
        json_flag("fixed", a->task.s.block[i].fixed, 1);
        json_chance(a->stays[i]);
        printf("}");
    }
    printf("]");
}

/* The numbers that are null because they have no bound. */
static inline void json_unbounded(const struct analysis *a, int good)
{
    const struct {
        const char *name;
        double value;
        int asked;
    } key[] = {
        {"deficit", a->deficit, a->measured == KERN_FALLS},
        {"bearing", a->bearing, a->measured == KERN_STANDS},
        {"load_left", a->load[LEFT], 1},
        {"load_right", a->load[RIGHT], 1},
        {"tilt_left", a->tilt[LEFT], 1},
        {"tilt_right", a->tilt[RIGHT], 1},
        {"raised_load_left", a->raised_load[LEFT], 1},
        {"raised_load_right", a->raised_load[RIGHT], 1},
        {"raised_live", a->raised_load[LIVE], a->text.lives > 0},
        {"live_let_go", a->live_let_go[1], a->text.lives > 0},
        {"live", a->live, a->text.lives > 0},
        {"thrust_most", a->thrust_most, a->set->thrust != NULL},
    };
    const char *comma = "";
    printf(", \"unbounded\": [");
    for (size_t k = 0; good && k < sizeof key / sizeof *key; k++) {
        if (!key[k].asked || !isinf(key[k].value))
            continue;
        printf("%s\"%s\"", comma, key[k].name);
        comma = ", ";
    }
    printf("]");
}

static inline void json_open(unsigned open)
{
    const char *comma = "";
    printf(", \"undecided\": [");
    for (int k = 0; k < OPENS_MOST; k++) {
        if (!(open >> k & 1))
            continue;
        printf("%s\"%s\"", comma, open_name[k]);
        comma = ", ";
    }
    printf("]");
}

/* What became no block, and what was assumed of a drawing or a photograph. */
static inline void json_drawing(const struct analysis *a)
{
    const struct shapes *s = &a->drawing.s;
    const char *comma = "", *line = s->notes.at ? s->notes.at : "";
    if (a->text.units && !a->error[0]) {
        printf(", ");
        json_string("units", a->text.units);
    } else
        printf(", \"units\": null");
    printf(", \"skipped\": [");
    for (int i = 0; i < s->skips; i++) {
        printf("%s{", comma);
        json_string("kind", shapes_at(s, s->skip[i].kind));
        printf(", ");
        json_string("name", shapes_at(s, s->skip[i].label));
        json_count("line", s->skip[i].line, s->skip[i].line > 0);
        json_count("count", s->skip[i].count, 1);
        printf("}");
        comma = ", ";
    }
    printf("], \"notes\": [");
    for (comma = ""; *line; line = strchr(line, '\n') + 1) {
        printf("%s\"", comma);
        json_text_of(line, (int)strcspn(line, "\n"));
        printf("\"");
        comma = ", ";
    }
    printf("]");
}

/* What the file has, and how it was taken. */
static inline void json_structure(const struct analysis *a, int good)
{
    int lines = good ? line_points(a) : 0;
    if (a->text.props > 0)
        json_count("props", a->text.props, good);
    json_count("blocks", stones(a) - a->text.fixed, good);
    json_count("fixed", a->text.fixed, good);
    json_count("contact_points", a->task.s.contacts, good);
    json_count("line_contacts", lines / 2, good);
    json_count("point_contacts", a->task.s.contacts - lines, good);
}

static inline void json_measure(const struct analysis *a, int good, int asked)
{
    int known = asked && a->measured >= 0;
    int falls = known && a->measured == KERN_FALLS;
    int proven = known || (good && a->measured == KERN_LIMIT);
    int most = known ? most_stressed(a, 0, a->task.s.contacts) : -1;
    json_known("epsilon", (double)a->m.epsilon, known);
    json_flag("relative", a->set->relative, 1);
    json_flag("near", is_near(a), 1);
    if (pose_error(a) > 0) {
        json_flag("certain", a->certain > 0, a->certain >= 0);
        json_flag("surely_stands", is_sure(a, KERN_STANDS), a->certain >= 0);
        json_flag("surely_falls", is_sure(a, KERN_FALLS), a->certain >= 0);
    }
    json_count("level", a->m.level, known && a->m.level >= 0);
    json_flag("saturated", a->m.saturated, known);
    json_known("margin", (double)a->m.margin, known);
    if (pose_error(a) > 0) {
        json_known("margin_low", (double)a->interval.low, a->certain >= 0);
        json_known("settles", (double)a->interval.settles,
                   is_sure(a, KERN_STANDS));
        json_known("margin_high", (double)a->interval.high,
                   a->certain >= 0 && a->interval.high < KERN_INFINITY);
    }
    json_known("holds", (double)a->m.holds, proven && !(a->m.holds < 0));
    json_known("fails", (double)a->m.fails,
               proven && (falls || a->m.fails < a->m.most));
    json_known("deficit", a->deficit, falls);
    json_known("signed_margin", falls ? -a->deficit : (double)a->m.margin,
               known);
    json_known("bearing", a->bearing, asked);
    json_known("peak_stress", most < 0 ? 0 : a->stress[most], most >= 0);
}

/* With the live load as the file states it. */
static inline const char *stated_word(const struct analysis *a)
{
    const kern_status status = as_stated(a);
    return status == KERN_STANDS ? "stands"
         : status == KERN_FALLS  ? "falls"
                                 : "undecided";
}

/* What the live load does as the file states it; verdict, margin, stress, load
   and tilt are without it. */
static inline void json_stated(const struct analysis *a, int known)
{
    known = known && a->text.lives > 0;
    json_flag("without_live", a->text.lives > 0, known);
    json_word("as_stated", known ? stated_word(a) : NULL);
}

/* The ranges of the live load. */
static inline void json_live(const struct analysis *a, int asked)
{
    if (a->text.lives == 0)
        return;
    json_known("live_least", a->live_least, asked);
    json_known("live", a->live, asked);
    json_known("live_least_let_go", a->live_let_go[0], asked);
    json_known("live_let_go", a->live_let_go[1], asked);
}

/* The same where fill does not push back; null where no fill does. */
static inline void json_without(const struct analysis *a)
{
    const struct analysis *w = a->without;
    if (!w) {
        json_word("without_passive", NULL);
        return;
    }
    printf(", \"without_passive\": {");
    json_string("status", status_word(w));
    json_word("let_go", let_go_word(w));
    json_live(w, 1);
    if (a->text.lives > 0)
        json_word("as_stated", stated_word(w));
    if (a->set->sweep > 0)
        json_worst(w);
    printf("}");
}

/* By how much earth may grow. */
static inline void json_growth(const struct analysis *a, int asked)
{
    static const char *const key[EARTH_PARTS][2] = {
        {"earth", "earth_let_go"},
        {"earth_horizontal", "earth_horizontal_let_go"}};
    for (int k = 0; k < EARTH_PARTS; k++) {
        if (!has_growth(a, (enum earth_part)k))
            continue;
        json_known(key[k][0], a->earth[k].limit, asked);
        json_known(key[k][1], a->earth[k].let_go, asked);
    }
}

static inline void json_loads(const struct analysis *a, int asked)
{
    json_known("load_left", a->load[LEFT], asked);
    json_known("load_right", a->load[RIGHT], asked);
    json_known("tilt_left", a->tilt[LEFT], asked);
    json_known("tilt_right", a->tilt[RIGHT], asked);
    if (a->text.loads > 0)
        json_flag("loads_stay", 1, 1);
    json_known("raised_load_left", a->raised_load[LEFT], asked);
    json_known("raised_load_right", a->raised_load[RIGHT], asked);
    json_word("raised_end_left", a->raised_end[LEFT]);
    json_word("raised_end_right", a->raised_end[RIGHT]);
    json_live(a, asked);
    if (a->text.lives > 0)
        json_word("raised_end_live", a->raised_end[LIVE]);
    json_without(a);
    json_growth(a, asked);
    if (a->set->thrust) {
        json_known("thrust_least", a->thrust_least, asked);
        json_known("thrust_most", a->thrust_most, asked);
    }
    if (a->set->sweep > 0)
        json_sweep(a);
    if (a->set->place)
        json_places(a);
    json_open(asked ? open_questions(a) : 0);
    json_unbounded(a, asked);
}

/* Null where it was not asked. */
static inline void json_let_go(const struct analysis *a)
{
    const int known = a->let_go_why[0] != 0;
    json_word("let_go", known ? let_go_word(a) : NULL);
    json_word("let_go_why", known ? a->let_go_why : NULL);
}

/* What --error asks for. */
static inline void json_borne(const struct analysis *a, int asked)
{
    json_known("bears", a->bears, asked);
    json_known("least_friction", a->least_friction, asked);
    json_known("least_friction_let_go", a->least_friction_let_go, asked);
    json_known("tilt_let_go_left", a->tilt_let_go[LEFT], asked);
    json_known("tilt_let_go_right", a->tilt_let_go[RIGHT], asked);
}

/* A file with an error has the same keys as any other. */
static inline void report_json(const struct analysis *a)
{
    int good = !a->error[0], asked = good && !a->set->verdict_only;
    printf("{");
    json_string("file", a->file);
    json_word("version", KERN_VERSION);
    printf(", ");
    json_string("status", status_word(a));
    json_drawing(a);
    json_structure(a, good);
    if (good)
        json_soil(a);
    json_let_go(a);
    json_measure(a, good, asked);
    json_limits(a, asked);
    if (a->set->raised)
        json_raised(a, asked);
    if (a->set->own_error > 0)
        json_borne(a, asked);
    if (a->set->sequence)
        json_sequence(a, good && a->sequence);
    if (a->set->stays)
        (is_all(a->set->stays) ? json_each : json_stays)(a, good && a->stays);
    json_loads(a, asked);
    json_stated(a, asked);
    json_known("proof_error", (double)a->work.error, good);
    json_count("pivots", a->work.pivots, good);
    json_count("solves", a->work.solves, good);
    if (a->set->profile)
        json_profile(a, good);
    json_error(a);
    if (good && a->set->forces) {
        json_contacts(a);
        json_thrust(a);
        json_beds(a);
    }
    if (good && a->set->mechanism)
        json_motion(a);
    printf("}\n");
}

#endif /* PROGRAM_REPORT_JSON_H */
