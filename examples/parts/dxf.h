/* dxf.h - reads a drawing (DXF, as text) as a structure:

       polylines   LWPOLYLINE and POLYLINE with its VERTEX entities, closed or
                   with the first point repeated at the end, are blocks
       layers      a block on a layer named `ground` or `fixed` (in any case)
                   does not move; where there is no such layer the lowest block
                   does not
       names       of a block: its layer, on layer 0 `b`, and a number
       units       metres by $INSUNITS; without it, one unit is one metre
       POINT       carries nothing and is passed over

   Masses are areas (density 1). What else is in the drawing is refused by its
   name and line: arcs in polylines (bulges), INSERT, LINE, ARC, CIRCLE, SPLINE,
   solids; so that nothing of a drawing is left out silently. Entities of the
   BLOCKS section count only where they are inserted, and those in paper space
   never.

   SPDX-License-Identifier: MIT */

#ifndef DXF_H
#define DXF_H

#include "text.h"

struct dxf_reader {
    const char *at, *end; /* of what is left                             */
    int line;             /* of the value that was read last             */
    int code;             /* of the group that was read last             */
    char value[256];      /* its value, without blanks around it         */
    double metre;         /* of a unit                                   */
    kern_vec *point;      /* of all blocks                               */
    int points, point_room;
    struct dxf_block *block;
    int blocks, block_room;
    char *message; /* what is wrong                               */
    size_t room;
    int fault; /* the line where it is, 0: the whole file     */
};

struct dxf_block {
    char layer[256];
    int first, points; /* of the reader's                             */
    int line;          /* where it begins                             */
};

/* What an entity says, beside its points. */
struct dxf_entity {
    char layer[256];
    int flags, paper, curved, tilted, line;
};

static int dxf_fail(struct dxf_reader *r, int line, const char *format, ...)
{
    va_list values;
    va_start(values, format);
    vsnprintf(r->message, r->room, format, values);
    va_end(values);
    r->fault = line;
    return -1;
}

/* One more of `size` bytes behind n; NULL where memory ends. */
static void *dxf_grown(void *array, int n, int *room, size_t size)
{
    if (n < *room)
        return array;
    *room = *room ? 2 * *room : 64;
    return realloc(array, (size_t)*room * size);
}

/* ---- groups: a line with a code, a line with its value -------------------- */

/* A line without the blanks around it; 0 at the end of the file. */
static int dxf_line(struct dxf_reader *r, char *out, size_t room)
{
    const char *from = r->at, *to;
    size_t n;
    if (from >= r->end)
        return 0;
    to = memchr(from, '\n', (size_t)(r->end - from));
    r->at = to ? to + 1 : r->end;
    to = to ? to : r->end;
    while (from < to && (*from == ' ' || *from == '\t'))
        from++;
    while (to > from && (to[-1] == '\r' || to[-1] == ' ' || to[-1] == '\t'))
        to--;
    n = (size_t)(to - from) < room ? (size_t)(to - from) : room - 1;
    memcpy(out, from, n);
    out[n] = '\0';
    r->line++;
    return 1;
}

/* The next group: 1, 0 at the end of the file, -1: it is none. */
static int dxf_group(struct dxf_reader *r)
{
    char word[256], *end;
    long code;
    if (!dxf_line(r, word, sizeof word))
        return 0;
    code = strtol(word, &end, 10);
    if (end == word || *end || code < -5 || code > 1071) {
        char shown[TEXT_SHOW_ROOM];
        return dxf_fail(r, r->line, "a group code is expected, read '%s'",
                        text_show(shown, word));
    }
    r->code = (int)code;
    if (!dxf_line(r, r->value, sizeof r->value))
        return dxf_fail(r, r->line, "the file ends after a group code");
    return 1;
}

static int dxf_number(struct dxf_reader *r, kern_real *out)
{
    char shown[TEXT_SHOW_ROOM];
    if (text_number(r->value, out))
        return 0;
    return dxf_fail(r, r->line, "a number is expected, read '%s'",
                    text_show(shown, r->value));
}

static int dxf_is(const struct dxf_reader *r, int code, const char *value)
{
    return r->code == code && strcmp(r->value, value) == 0;
}

/* Letters in any case: the names of layers. */
static int dxf_same(const char *a, const char *b)
{
    while (*a && *b && (*a | 0x20) == (*b | 0x20)) {
        a++;
        b++;
    }
    return *a == *b;
}

/* ---- units ---------------------------------------------------------------- */

/* The value of $INSUNITS, in the group that was read. */
static int dxf_units(struct dxf_reader *r)
{
    static const double metre[] = {
        1,       0.0254, 0.3048, 1609.344, 0.001, 0.01, 1,  1000, 2.54e-8,
        2.54e-5, 0.9144, 1e-10,  1e-9,     1e-6,  0.1,  10, 100};
    kern_real unit = 0;
    if (dxf_number(r, &unit))
        return -1;
    if (!(unit >= 0 && unit < (kern_real)(sizeof metre / sizeof *metre)))
        return dxf_fail(r, r->line,
                        "$INSUNITS is %g, no unit of length from "
                        "inches to hectometres",
                        (double)unit);
    r->metre = metre[(int)unit];
    return 0;
}

/* ---- entities ------------------------------------------------------------- */

/* One more point, at (x, 0) for now. */
static int dxf_point(struct dxf_reader *r, kern_real x)
{
    kern_vec *p = dxf_grown(r->point, r->points, &r->point_room, sizeof *p);
    if (!p)
        return dxf_fail(r, r->line, "not enough memory");
    r->point = p;
    p[r->points].x = x;
    p[r->points++].y = 0;
    return 0;
}

/* Whether a group of an entity is a number that is read: x, y, bulge, paper
   space, flags, the direction that it is seen from. */
static int dxf_is_read(int code)
{
    static const int codes[] = {10, 20, 42, 67, 70, 230};
    for (int i = 0; i < (int)(sizeof codes / sizeof *codes); i++)
        if (codes[i] == code)
            return 1;
    return 0;
}

/* Takes a group of an entity, or of a VERTEX of it. */
static int dxf_take(struct dxf_reader *r, struct dxf_entity *e, int vertex)
{
    kern_real number = 0;
    if (r->code == 8 && !vertex)
        strcpy(e->layer, r->value);
    if (!dxf_is_read(r->code))
        return 0;
    if (dxf_number(r, &number))
        return -1;
    switch (r->code) {
    case 10: return dxf_point(r, number);
    case 20:
        if (r->points > 0)
            r->point[r->points - 1].y = number;
        break;
    case 42:
        if (number < 0 || number > 0)
            e->curved = r->line;
        break;
    case 67: e->paper |= number > 0; break;
    case 70:
        if (!vertex)
            e->flags = number > 0 ? (int)number & 255 : 0;
        break;
    default:
        if (!(number > 0))
            e->tilted = r->line;
    }
    return 0;
}

/* Whether two points are one, but for the rounding of a drawing's numbers. */
static int dxf_near(const struct dxf_reader *r, int i, int j)
{
    static const double rounding = 1e-6; /* of the first edge */
    const kern_vec p = r->point[i], q = r->point[j], s = r->point[i + 1];
    return hypot((double)(p.x - q.x), (double)(p.y - q.y))
        <= rounding * hypot((double)(p.x - s.x), (double)(p.y - s.y));
}

/* After how many of its n points a polyline comes back to where it began, and
   then only goes over its own edges again; 0: it does not. */
static int dxf_ring(const struct dxf_reader *r, int first, int n)
{
    for (int m = 3; m < n; m++) {
        int i = m;
        while (i < n && dxf_near(r, first + i - m, first + i))
            i++;
        if (i == n)
            return m;
    }
    return 0;
}

/* A polyline was read, with its points from `first` on: a block. */
static int dxf_close(struct dxf_reader *r, const struct dxf_entity *e,
                     int first)
{
    struct dxf_block *b;
    int n = r->points - first, ring = dxf_ring(r, first, n);
    if (e->paper) {
        r->points = first;
        return 0;
    }
    if (e->curved)
        return dxf_fail(r, e->curved,
                        "a polyline has an arc (bulge): only "
                        "straight edges are read");
    if (e->tilted)
        return dxf_fail(r, e->tilted, "a polyline is seen from below");
    if (e->flags & (8 | 16 | 64))
        return dxf_fail(r, e->line, "a polyline of space, or a mesh");
    if (ring) {
        n = ring;
        r->points = first + n;
    }
    if (!ring && !(e->flags & 1))
        return dxf_fail(r, e->line, "a polyline is not closed");
    if (n < 3)
        return dxf_fail(r, e->line, "a polyline of %d points", n);
    b = dxf_grown(r->block, r->blocks, &r->block_room, sizeof *b);
    if (!b)
        return dxf_fail(r, e->line, "not enough memory");
    r->block = b;
    b += r->blocks++;
    strcpy(b->layer, e->layer);
    b->first = first;
    b->points = n;
    b->line = e->line;
    return 0;
}

/* The groups of an entity up to the name of the next one. Of the old POLYLINE
   they are its own, those of each VERTEX, and SEQEND with what belongs to it;
   its own x and y are no point. */
static int dxf_groups(struct dxf_reader *r, struct dxf_entity *e, int old)
{
    enum { OWN, VERTEX, ENDED } stage = OWN;
    int found;
    while ((found = dxf_group(r)) == 1) {
        int place = r->code == 10 || r->code == 20;
        if (old && dxf_is(r, 0, "VERTEX"))
            stage = VERTEX;
        else if (old && dxf_is(r, 0, "SEQEND"))
            stage = ENDED;
        else if (r->code == 0)
            return 0;
        else if (stage == ENDED || (old && stage == OWN && place))
            continue;
        else if (dxf_take(r, e, stage == VERTEX))
            return -1;
    }
    return found < 0 ? -1 : dxf_fail(r, r->line, "the file ends in an entity");
}

/* An entity, whose name was read. */
static int dxf_entity(struct dxf_reader *r)
{
    static const struct dxf_entity none;
    struct dxf_entity e = none;
    const int first = r->points;
    const int old = dxf_is(r, 0, "POLYLINE"), skip = dxf_is(r, 0, "POINT");
    char shown[TEXT_SHOW_ROOM];
    e.line = r->line;
    if (!old && !skip && !dxf_is(r, 0, "LWPOLYLINE"))
        return dxf_fail(r, r->line,
                        "%s is not read: draw every block as a "
                        "closed polyline",
                        text_show(shown, r->value));
    if (dxf_groups(r, &e, old))
        return -1;
    if (skip)
        r->points = first;
    return skip ? 0 : dxf_close(r, &e, first);
}

/* A group between entities: keeps the name of the section, and reads the unit
   of the header, which follows the name of its variable. */
static int dxf_between(struct dxf_reader *r, char *section, int *variable)
{
    if (dxf_is(r, 0, "SECTION"))
        strcpy(section, "?");
    else if (dxf_is(r, 0, "ENDSEC"))
        section[0] = '\0';
    else if (r->code == 2 && strcmp(section, "?") == 0)
        strcpy(section, r->value);
    else if (r->code == 9)
        *variable = dxf_is(r, 9, "$INSUNITS");
    else if (r->code == 70 && *variable && strcmp(section, "HEADER") == 0) {
        *variable = 0;
        return dxf_units(r);
    }
    return 0;
}

/* All sections: the header's unit and the entities. */
static int dxf_sections(struct dxf_reader *r)
{
    char section[256] = "";
    int found = dxf_group(r), variable = 0;
    while (found == 1 && !dxf_is(r, 0, "EOF")) {
        if (r->code == 0 && !dxf_is(r, 0, "ENDSEC")
            && strcmp(section, "ENTITIES") == 0) {
            if (dxf_entity(r))
                return -1;
            continue;
        }
        if (dxf_between(r, section, &variable))
            return -1;
        found = dxf_group(r);
    }
    if (found < 0)
        return -1;
    if (found == 0)
        return dxf_fail(r, r->line, "the file ends without EOF");
    if (r->blocks == 0)
        return dxf_fail(r, 0, "no closed polyline among the entities");
    return 0;
}

/* ---- the structure -------------------------------------------------------- */

static int dxf_is_ground(const struct dxf_block *b)
{
    return dxf_same(b->layer, "ground") || dxf_same(b->layer, "fixed");
}

/* The block that does not move where no layer says so: the lowest. */
static int dxf_lowest(const struct dxf_reader *r)
{
    int lowest = 0;
    kern_real low = KERN_INFINITY;
    for (int i = 0; i < r->blocks; i++) {
        const struct dxf_block *b = r->block + i;
        if (dxf_is_ground(b))
            return -1;
        for (int k = 0; k < b->points; k++)
            if (r->point[b->first + k].y < low) {
                low = r->point[b->first + k].y;
                lowest = i;
            }
    }
    return lowest;
}

/* Writes a number as text.h reads it in every locale. */
static int dxf_write(char *out, size_t room, double number)
{
    int n = snprintf(out, room, " %.17g", number);
    for (char *c = out; c < out + n; c++)
        if (*c == ',')
            *c = '.';
    return n;
}

/* The block's layer as a word, and its number. */
static int dxf_name(const struct dxf_reader *r, int i, char *out, size_t room)
{
    char word[256];
    const char *layer = r->block[i].layer;
    size_t n = 0;
    if (strcmp(layer, "0") != 0)
        for (; *layer && n + 1 < sizeof word; layer++)
            word[n++] = *layer == ' ' || *layer == '\t' || *layer == '#'
                          ? '_'
                          : *layer;
    if (n == 0)
        word[n++] = 'b';
    word[n] = '\0';
    return snprintf(out, room, "%s %s_%d%s",
                    dxf_is_ground(r->block + i) ? "fixed" : "block", word,
                    i + 1, dxf_is_ground(r->block + i) ? "" : " *");
}

/* The statements of text.h, each in the line of the drawing where its block
   begins; to be freed; NULL where memory ends. */
static char *dxf_statements(const struct dxf_reader *r)
{
    enum { WORD = 32, NAME = 300 };
    const int lowest = dxf_lowest(r);
    const size_t room = (size_t)r->points * 2 * WORD + (size_t)r->blocks * NAME
                      + (size_t)r->line + 1;
    char *text = malloc(room), *to = text;
    int line = 1;
    if (!text)
        return NULL;
    *to = '\0';
    for (int i = 0; i < r->blocks; i++) {
        const struct dxf_block *b = r->block + i;
        for (; line < b->line; line++)
            *to++ = '\n';
        if (i == lowest)
            to += snprintf(to, NAME, "fixed ground_%d", i + 1);
        else
            to += dxf_name(r, i, to, NAME);
        for (int k = 0; k < b->points; k++) {
            to += dxf_write(to, WORD,
                            r->metre * (double)r->point[b->first + k].x);
            to += dxf_write(to, WORD,
                            r->metre * (double)r->point[b->first + k].y);
        }
        *to = '\0';
    }
    return text;
}

/* Whether a file is a drawing, by its name. */
static inline int dxf_named(const char *path)
{
    size_t n = strlen(path);
    return n > 4 && dxf_same(path + n - 4, ".dxf");
}

/* The structure of a drawing in the format of text.h, whose errors then have the
   lines of the drawing; to be freed. NULL: the message says what is wrong, *line
   where. */
static inline char *dxf_read(const char *data, size_t length, char *message,
                             size_t room, int *line)
{
    static const struct dxf_reader none;
    struct dxf_reader r = none;
    char *text = NULL;
    r.at = data;
    r.end = data + length;
    r.metre = 1;
    r.message = message;
    r.room = room;
    if (length > TEXT_LONGEST)
        dxf_fail(&r, 0, "the file is too long");
    else if (length > 21 && memcmp(data, "AutoCAD Binary DXF", 18) == 0)
        dxf_fail(&r, 0, "a binary drawing: save it as text (ASCII DXF)");
    else if (dxf_sections(&r) == 0) {
        text = dxf_statements(&r);
        if (!text)
            dxf_fail(&r, 0, "not enough memory");
    }
    free(r.point);
    free(r.block);
    *line = r.fault;
    return text;
}

/* text_load() of a drawing: an error has the line of the drawing. */
static inline int dxf_load(struct text_file *t, const char *path)
{
    static const struct text_file empty;
    char *text = NULL, *data = NULL;
    size_t length = 0;
    FILE *in = fopen(path, "rb");
    int bad = -1;
    *t = empty;
    if (in) {
        data = text_slurp(in, &length);
        fclose(in);
    }
    if (!data)
        snprintf(t->message, sizeof t->message, "cannot be read: %s",
                 strerror(errno));
    else if ((text = dxf_read(data, length, t->message, sizeof t->message,
                              &t->line))
             != NULL)
        bad = text_read(t, text, strlen(text));
    free(data);
    free(text);
    return bad;
}

#endif /* DXF_H */
