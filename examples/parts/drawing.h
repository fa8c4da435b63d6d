/* drawing.h - reads a structure from any file: text.h's format, a drawing (DXF,
   SVG), or the annotations of a photograph (JSON). The program, the Python
   module and the page read drawings by this.

   drawing_make() makes statements of text.h of a drawing; drawing_load() and
   drawing_parse() read these as text_load() and text_read() read a file, and an
   error has the line of the drawing. drawing_free() ends either.

   SPDX-License-Identifier: MIT */

#ifndef DRAWING_H
#define DRAWING_H

#include "dxf.h"
#include "image.h"
#include "shapes.h"
#include "statements.h"
#include "svg.h"

enum drawing_format { DRAWING_TEXT, DRAWING_DXF, DRAWING_JSON, DRAWING_SVG };

struct drawing {
    struct shapes s;   /* statements, notes, what was skipped, units     */
    struct outlines o; /* the blocks                                     */
    int made;          /* nonzero: the file was none of text.h's format  */
    char *source;      /* of drawing_load(): such a file, ends with a 0  */
};

static int drawing_ends(const char *name, const char *end)
{
    const int n = (int)strlen(name), m = (int)strlen(end);
    return n > m && shapes_same(name + n - m, m, end);
}

/* Returns the format of a file whose name does not tell, by how it begins.
   */
static enum drawing_format drawing_begins(const char *data, size_t length)
{
    size_t i = 0;
    char first, second;
    while (i < length && i < 100 && (data[i] == ' ' || data[i] == '\n'))
        i++;
    first = i < length ? data[i] : '\0';
    second = i + 1 < length ? data[i + 1] : '\0';
    if (first == '{' || first == '[')
        return DRAWING_JSON;
    if (first == '<')
        return DRAWING_SVG;
    return first == '0' && (second == '\n' || second == '\r') ? DRAWING_DXF
                                                              : DRAWING_TEXT;
}

/* Returns the format of a file by the end of its name, or else by how it
   begins. */
static enum drawing_format drawing_format(const char *name, const char *data,
                                          size_t length)
{
    if (drawing_ends(name, ".dxf"))
        return DRAWING_DXF;
    if (drawing_ends(name, ".json"))
        return DRAWING_JSON;
    if (drawing_ends(name, ".svg"))
        return DRAWING_SVG;
    if (drawing_ends(name, ".kern"))
        return DRAWING_TEXT;
    return drawing_begins(data, length);
}

/* Returns what to do with a file of a format that is not read, or NULL. */
static inline const char *drawing_foreign(const char *data, size_t length)
{
    static const char picture[] = "a picture, which has no outlines: draw a "
                                  "polygon round each stone in LabelMe, COCO "
                                  "or VIA, and read the .json";
    if (length < 5)
        return NULL;
    if (memcmp(data, "AC10", 4) == 0)
        return "a DWG, which is not read: save it as DXF";
    if (memcmp(data, "%PDF", 4) == 0)
        return "a PDF, which is not read: save it as DXF or SVG";
    return memcmp(data, "\x89PNG", 4) == 0
                || memcmp(data, "\xff\xd8\xff", 3) == 0
             ? picture
             : NULL;
}

/* Makes statements of a drawing. Returns 0, or -1 with a message. */
static inline int drawing_make(struct drawing *d, enum drawing_format format,
                               const char *data, size_t length,
                               const struct shapes_asked *asked)
{
    static int (*const read[])(struct shapes *, const char *,
                               int) = {NULL, dxf_read, image_read, svg_read};
    const char *foreign = drawing_foreign(data, length);
    int bad;
    memset(d, 0, sizeof *d);
    d->made = 1;
    d->s.asked = asked;
    d->s.unit = 1;
    shapes_put(&d->s.notes, "");
    shapes_put(&d->s.text, "");
    if (foreign)
        return shapes_fail(&d->s, 0, foreign);
    if (length >= INT_MAX / 4)
        return shapes_fail(&d->s, 0, "the file is too long");
    bad = read[format](&d->s, data, (int)length);
    if (!bad || d->s.lost)
        bad = statements_make(&d->s, &d->o);
    return bad;
}

static inline void drawing_free(struct drawing *d)
{
    free(d->o.block);
    free(d->source);
    shapes_free(&d->s);
    memset(d, 0, sizeof *d);
}

#ifndef SHAPES_BARE

/* Returns the line of the drawing that a line of its statements comes from.
   */
static int drawing_line(const struct drawing *d, int line)
{
    const char *at = d->s.text.at;
    char name[300];
    int n = 0;
    for (; at && line > 1; line--) {
        at = strchr(at, '\n');
        at = at ? at + 1 : NULL;
    }
    if (line < 1 || !at || !(at = strchr(at, ' ')))
        return 0;
    for (at++; *at && *at != ' ' && *at != '\n' && n + 1 < (int)sizeof name;)
        name[n++] = *at++;
    name[n] = '\0';
    return statements_line(&d->o, name);
}

/* Reads a structure as text_read() does, from a file of any format; `name`
   tells which, unless its content does. */
static inline int drawing_parse(struct text_file *t, struct drawing *d,
                                const char *name, const char *data,
                                size_t length, const struct shapes_asked *asked)
{
    static const struct text_file empty;
    const enum drawing_format format = drawing_format(name, data, length);
    int bad, next = 0;
    memset(d, 0, sizeof *d);
    if (format == DRAWING_TEXT && !drawing_foreign(data, length))
        return text_read(t, data, length);
    *t = empty;
    if (drawing_make(d, format, data, length, asked)) {
        t->line = d->s.fault;
        return text_fail(t, "%s", d->s.message.at ? d->s.message.at : "");
    }
    bad = text_read(t, d->s.text.at, (size_t)d->s.text.length);
    if (bad)
        t->line = drawing_line(d, t->line);
    for (int i = 0; i < d->o.blocks && next < t->blocks; i++)
        if (outlines_path(&d->o, i)->role != SHAPES_FILL)
            t->block_line[next++] = outlines_path(&d->o, i)->line;
    return bad;
}

/* Reads a file as drawing_parse() does, "-" for standard input. */
static inline int drawing_load(struct text_file *t, struct drawing *d,
                               const char *path,
                               const struct shapes_asked *asked)
{
    static const struct text_file empty;
    const int standard = strcmp(path, "-") == 0;
    size_t length = 0;
    char *data;
    int error, bad;
    FILE *in;
    memset(d, 0, sizeof *d);
    *t = empty;
    errno = 0;
    in = standard ? stdin : fopen(path, "rb");
    data = in ? text_slurp(in, &length) : NULL;
    error = errno;
    if (in && !standard)
        fclose(in);
    if (!data)
        return text_fail(t, "cannot be read: %s", strerror(error));
    bad = drawing_parse(t, d, path, data, length, asked);
    if (d->made)
        free(data);
    else
        d->source = data;
    return bad;
}
#endif

#endif /* DRAWING_H */
