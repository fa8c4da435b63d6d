/* picture.h - the picture of a structure, and the name of its file.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_PICTURE_H
#define PROGRAM_PICTURE_H

#include "../../kern.h"

#include "place.h"
#include "loads.h"
#include "state.h"
#include "sweep.h"

#include <errno.h>
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The name of a file without folder and suffix. */
static inline const char *stem_of(const char *path, int *length)
{
    const char *name = path;
    for (const char *s = path; *s; s++)
        if (*s == '/' || *s == '\\')
            name = s + 1;
    if (strcmp(name, "-") == 0)
        name = "stdin";
    const char *dot = strrchr(name, '.');
    *length = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    return name;
}

/* OUT.svg for one file, OUT-NAME.svg for each of several, and OUT-NAME-2.svg
   for the second of that name. */
static inline char *output_name(const struct analysis *a, const char *to)
{
    const struct settings *set = a->set;
    int out, stem, same = 1, folder;
    const char *name = stem_of(a->file, &stem), *base = stem_of(to, &out);
    folder = (int)(base - to) + out;
    for (int i = 0; i < a->number; i++) {
        int n;
        const char *other = stem_of(set->file[i], &n);
        same += n == stem && strncmp(name, other, (size_t)n) == 0;
    }
    size_t room = strlen(to) + (size_t)stem + 16;
    char *path = malloc(room);
    if (!path)
        return NULL;
    if (set->files == 1)
        strcpy(path, to);
    else if (same == 1)
        snprintf(path, room, "%.*s-%.*s%s", folder, to, stem, name,
                 to + folder);
    else
        snprintf(path, room, "%.*s-%.*s-%d%s", folder, to, stem, name, same,
                 to + folder);
    return path;
}

/* The file that an option names, for this structure; *out is NULL where it
   cannot be written. The path is for close_output(). */
static inline char *open_output(const struct analysis *a, const char *to,
                                FILE **out)
{
    char *path = output_name(a, to);
    *out = path ? fopen(path, "w") : NULL;
    return path;
}

/* Says what went wrong; returns nonzero where something did. */
static inline int close_output(char *path, FILE *out, int bad)
{
    if (out)
        bad |= fclose(out) != 0;
    if (bad)
        fprintf(stderr, "kern: cannot write %s: %s\n", path ? path : "the file",
                strerror(errno));
    free(path);
    return bad;
}

/* Writes a line for the worst place, where one is known. */
static inline void write_worst(const struct analysis *a, char *out, size_t room)
{
    const struct analysis *r = relied_on(a);
    char full[40] = "";
    if (a->without && sweep_governs(a) >= 0)
        snprintf(full, sizeof full, "; %.4g with it", sweep_factor_least(a));
    if (sweep_governs(r) >= 0)
        snprintf(out, room, "\nblack: worst place, factor %.4g%s%s",
                 sweep_factor_least(r),
                 a->without ? " without passive pressure" : "", full);
}

static inline void write_caption(const struct analysis *a, char *out,
                                 size_t room)
{
    int stem;
    const char *name = stem_of(a->file, &stem);
    char level[120] = "level undecided", unit[TEXT_SHOW_ROOM];
    if (a->set->verdict_only)
        snprintf(level, sizeof level, "margin not asked for");
    else if (a->measured == KERN_FALLS)
        snprintf(level, sizeof level,
                 isfinite(a->deficit) ? "level 0, deficit %.4g"
                                      : "level 0, wider contacts do not help",
                 a->deficit);
    else if (a->measured == KERN_STANDS)
        snprintf(
            level, sizeof level, "level %d, margin %.4g%s%.20s%s", a->m.level,
            (double)a->m.margin, a->text.units && !a->set->relative ? " " : "",
            a->text.units && !a->set->relative ? text_show(unit, a->text.units)
                                               : "",
            a->m.saturated     ? " (every kern closed)"
            : a->set->relative ? " of each contact"
            : a->text.units    ? ""
                               : " (a length)");
    char shrunk[40] = "";
    if (shrinkage(a) > 0)
        snprintf(shrunk, sizeof shrunk, " when shrunk by %.4g",
                 (double)shrinkage(a));
    stem = (int)strlen(name);
    char worst[140] = "";
    write_worst(a, worst, sizeof worst);
    snprintf(out, room, "%.*s %s%s; %s%s", stem > 100 ? 100 : stem, name,
             status_word(a), shrunk, level, worst);
}

/* Stones in the colours of their margins. */
static inline void colour(const struct analysis *a, struct draw_scene *scene)
{
    scene->value = a->fate[MARGIN];
    scene->value_name = a->set->relative ? "margin of a stone, a share"
                                         : "margin of a stone, a length";
    for (int i = 0; i < a->task.s.blocks; i++)
        if (!a->task.s.block[i].fixed)
            scene->most = fmax(scene->most, (double)a->fate[MARGIN][i]);
}

/* A quadrilateral of soil. */
static inline void draw_soil_piece(const struct draw_view *v,
                                   kern_vec corner[4])
{
    kern_block b = {0};
    b.vertex = corner;
    b.vertices = 4;
    draw_block(v, &b, NULL, 0,
               "fill=\"" DRAW_SOIL "\" fill-opacity=\"0.25\" "
               "stroke=\"none\"");
}

/* Fill, from each edge of the upper outline to its level. */
static inline void draw_fill(const struct draw_view *v,
                             const struct analysis *a,
                             const struct text_soil *s,
                             const struct text_surface *seen)
{
    const kern_real top = (kern_real)s->earth.top;
    for (int k = 0; k < seen->edges; k++) {
        const struct soil_edge *e = &seen->edge[k];
        kern_vec corner[4] = {e->p, e->q, e->q, e->p};
        if (a->task.s.block[e->block].fixed || !(fmin(e->p.y, e->q.y) < top)
            || !((double)e->q.x > s->from && (double)e->p.x < s->to))
            continue;
        corner[2].y = (kern_real)fmax(top, e->q.y);
        corner[3].y = (kern_real)fmax(top, e->p.y);
        draw_soil_piece(v, corner);
    }
}

/* Earth behind its back: the line from the foot to the head of the outline that
   it meets, whose lean its pressure has. */
static inline void draw_earth(const struct draw_view *v,
                              const struct analysis *a,
                              const struct text_soil *s,
                              const struct text_surface *seen)
{
    const double top = s->earth.top, size = 0.8 * mean_size(a);
    const double out = s->side == SOIL_LEFT ? -size : size;
    const struct soil_edge *foot = NULL, *head = NULL;
    kern_vec p, q;
    for (int k = 0; k < seen->edges; k++) {
        const struct soil_edge *e = &seen->edge[k];
        if (a->task.s.block[e->block].fixed || !((double)e->p.y < top))
            continue;
        foot = foot ? foot : e;
        head = e;
    }
    if (!foot)
        return;
    p = foot->p;
    q = head->q;
    if ((double)q.y > top) {
        q.x = p.x + (q.x - p.x) * ((kern_real)top - p.y) / (q.y - p.y);
        q.y = (kern_real)top;
    }
    kern_vec corner[4] = {p, q, q, p};
    corner[2].x += (kern_real)out;
    corner[3].x += (kern_real)out;
    draw_soil_piece(v, corner);
    draw_line(v->out, draw_place(v, p.x, p.y), draw_place(v, q.x, q.y),
              "stroke=\"" DRAW_INK "\" stroke-dasharray=\"4 3\"");
}

/* The pushes that act, each an arrow onto the face. Their contacts are the last
   ones, two a push, of which the second is on the stone. */
static inline void draw_pushes(const struct draw_view *v,
                               const struct analysis *a)
{
    const int first = a->task.s.contacts - 2 * a->text.props;
    double most = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        most = fmax(most, (double)a->force[k].normal);
    for (int k = first + 1; k < a->task.s.contacts; k += 2) {
        const kern_contact *c = &a->task.s.contact[k];
        const struct draw_pt to = draw_place(v, c->p.x, c->p.y);
        if ((double)a->force[k].normal > 1e-6 * most)
            draw_arrow(v->out,
                       draw_vec(to.x - 18 * (double)c->n.x,
                                to.y + 18 * (double)c->n.y),
                       to, 1.5, DRAW_FORCE);
    }
}

/* An arrow of the live load, down from where it stands at x, with a patch as wide
   as the axle and a text at its right. `axle` is NULL for a force, which stands on
   the stones. */
static inline void draw_axle(const struct draw_view *v,
                             const struct analysis *a,
                             const struct text_axle *axle, double x,
                             const char *colour, const char *text)
{
    double cone = 0, y = axle ? text_road(&a->text, x, &cone) : 0;
    const double to = x + (axle ? axle->width / 2 : 0);
    const double half = fmax(draw_place(v, to, 0).x - draw_place(v, x, 0).x, 2);
    char style[60];
    if (!(cone > 0) && sweep_top(a, x, &y) < 0)
        return;
    struct draw_pt from = draw_place(v, x, y);
    from.y = fmax(from.y, v->top + 2); /* the road may be out of view */
    snprintf(style, sizeof style, "stroke=\"%s\" stroke-width=\"3\"", colour);
    draw_line(v->out, draw_vec(from.x - half, from.y),
              draw_vec(from.x + half, from.y), style);
    draw_arrow(v->out, from, draw_vec(from.x, from.y + 26), 2, colour);
    draw_text(v->out, from.x + 6, from.y + 12, 10, "start", text, strlen(text));
}

/* The live load at the worst place of a sweep, of the factors to rely on. */
static inline void draw_worst(const struct draw_view *v,
                              const struct analysis *a)
{
    const struct analysis *r = relied_on(a);
    const int worst = sweep_governs(r), lives = sweep_lives(a);
    for (int k = 0; k < sweep_forces(a) && worst >= 0; k++)
        draw_axle(v, a, k < lives ? NULL : a->text.wheel + k - lives,
                  sweep_place(a, k) - sweep_place(a, 0) + r->swept[worst].x,
                  DRAW_INK, k == 0 ? "worst place" : "");
}

/* Draws fill and earth beside the stones that bear it. */
static inline void draw_soil(const struct draw_view *v, const void *analysis)
{
    struct analysis *a = (struct analysis *)(uintptr_t)analysis;
    for (int i = 0; i < a->text.soils; i++) {
        const struct text_soil *s = &a->text.soil[i];
        struct text_surface seen = {NULL, 0};
        if (s->kind != TEXT_PROP)
            text_outline(&a->text, s->side, &seen);
        if (s->kind == TEXT_FILL)
            draw_fill(v, a, s, &seen);
        if (s->kind == TEXT_EARTH)
            draw_earth(v, a, s, &seen);
        free(seen.edge);
    }
    for (int k = 0; k < a->text.wheels; k++) {
        const struct text_axle *w = &a->text.wheel[k];
        char value[LOADS_QUANTITY];
        draw_axle(v, a, w, w->x, DRAW_LIVE,
                  loads_number(a, w->force, 0, value));
    }
    draw_worst(v, a);
}

/* What lies over the picture: the best places of a stone, and soil. */
static inline void draw_over(const struct draw_view *v, const void *analysis)
{
    const struct analysis *a = analysis;
    if (a->places > 0)
        draw_places(v, a);
    draw_soil(v, a);
    if (a->shown == KERN_STANDS)
        draw_pushes(v, a);
}

static inline int draw_to(FILE *out, const struct analysis *a)
{
    char caption[400];
    write_caption(a, caption, sizeof caption);
    int falls = a->shown == KERN_FALLS;
    struct draw_scene scene = scene_of(a);
    kern_structure built = a->task.s;

    /* what pushes is no stone: arrows show it */
    built.blocks -= a->text.props;
    built.contacts -= 2 * a->text.props;
    scene.s = &built;
    scene.pushes = 0;
    scene.names = a->text.name;
    scene.motion = falls || a->set->mechanism ? shown_fall(a) : NULL;
    scene.motion_name =
        falls ? NULL
        : a->set->mechanism_live
            ? "collapse mechanism just past the factor of the live load"
            : "collapse mechanism just past the margin";
    scene.hinges = shown_fall(a);
    scene.hinged = falls || a->set->mechanism_live ? scene.shrink
                                                   : (double)a->m.fails;
    scene.limiting = a->critical.contact < built.contacts ? a->critical.contact
                                                          : -1;
    scene.caption = caption;
    scene.shown = a->place_vertex;
    scene.shows = a->places * a->place_vertices;
    if (a->set->profile && a->profiled >= 0)
        colour(a, &scene);
    if (a->text.wheels > 0 && a->text.lives == a->text.spread)
        scene.live = NULL; /* the axles are drawn themselves */
    scene.over = draw_over;
    scene.data = a;
    return draw_svg(out, &scene);
}

static inline int draw(const struct analysis *a)
{
    FILE *out;
    char *path = open_output(a, a->set->svg, &out);
    return close_output(path, out, !out || draw_to(out, a));
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

#endif /* PROGRAM_PICTURE_H */
