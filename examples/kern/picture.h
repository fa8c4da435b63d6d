/* picture.h - the picture of a structure, and the name of its file.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_PICTURE_H
#define PROGRAM_PICTURE_H

#include "../../kern.h"

#include "place.h"
#include "state.h"

#include <errno.h>
#include <math.h>
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

static inline void write_caption(const struct analysis *a, char *out,
                                 size_t room)
{
    int stem;
    const char *name = stem_of(a->file, &stem);
    char level[80] = "level undecided";
    if (a->set->verdict_only)
        snprintf(level, sizeof level, "margin not asked for");
    else if (a->measured == KERN_FALLS)
        snprintf(level, sizeof level,
                 isfinite(a->deficit) ? "level 0, deficit %.4g"
                                      : "level 0, wider contacts do not help",
                 a->deficit);
    else if (a->measured == KERN_STANDS)
        snprintf(level, sizeof level, "level %d, margin %.4g%s", a->m.level,
                 (double)a->m.margin,
                 a->m.saturated     ? " (every kern closed)"
                 : a->set->relative ? " of each contact"
                                    : " (a length)");
    char shrunk[40] = "";
    if (shrinkage(a) > 0)
        snprintf(shrunk, sizeof shrunk, " when shrunk by %.4g",
                 (double)shrinkage(a));
    stem = (int)strlen(name);
    snprintf(out, room, "%.*s %s%s; %s", stem > 100 ? 100 : stem, name,
             status_word(a), shrunk, level);
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

static inline int draw(const struct analysis *a)
{
    char caption[256];
    write_caption(a, caption, sizeof caption);
    int falls = a->shown == KERN_FALLS;
    struct draw_scene scene = scene_of(a);
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
    scene.limiting = a->critical.contact;
    scene.caption = caption;
    scene.over = a->places ? draw_places : NULL;
    scene.data = a;
    scene.shown = a->place_vertex;
    scene.shows = a->places * a->place_vertices;
    if (a->set->profile && a->profiled >= 0)
        colour(a, &scene);
    FILE *out;
    char *path = open_output(a, a->set->svg, &out);
    return close_output(path, out, !out || draw_svg(out, &scene));
}

#endif /* PROGRAM_PICTURE_H */
