/* shapes.h - what a drawing or an annotated photograph consists of, whatever its
   format: closed outlines and open paths with a label each, and a list of what
   was skipped. A reader of a format (dxf.h, image.h, svg.h) adds paths;
   outlines.h makes blocks of them.

       paths     points with the bulge of the edge that follows (0: straight,
                 otherwise the tangent of a quarter of the arc's angle, as in
                 DXF). An arc becomes equal chords, so many that they lie within
                 SHAPES_ARC of its chord or diameter: the number depends on the
                 arc alone, and two stones that share an arc share its chords
       labels    the layer of a drawing, the label or category of a photograph
       roles     of a label: stone, ground (fixed), fill (weight on what is below
                 it), ignored. The command line names them ("NAME=ROLE");
                 otherwise the last word of the label that has a role decides,
                 in any case; a label without such a word is a stone's
       skipped   kind, label, first line and how many
       notes     sentences about what was assumed, for a person to read before
                 the verdict

   Nothing here needs a C library where SHAPES_BARE is defined: then the includer
   declares malloc(), realloc(), free(), memcpy(), memset(), memcmp(), strlen(),
   and defines SHAPES_SQRT, shapes_read_number() and shapes_write_number().

   SPDX-License-Identifier: MIT */

#ifndef SHAPES_H
#define SHAPES_H

#include "../../kern.h"

#include "words.h"

#include <limits.h>
#include <stddef.h>

#ifndef SHAPES_BARE
#include "text.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SHAPES_SQRT(x) sqrt(x)

/* Reads the n bytes at s as a finite number. Returns 0 where they are none. */
static int shapes_read_number(const char *s, int n, double *out)
{
    char room[64], *word = n < (int)sizeof room ? room : malloc((size_t)n + 1);
    kern_real value = 0;
    int good;
    if (!word)
        return 0;
    memcpy(word, s, (size_t)n);
    word[n] = '\0';
    good = text_number(word, &value);
    if (word != room)
        free(word);
    *out = (double)value;
    return good;
}

/* Writes a number with so many digits, with 17 the fewest of three that read
   back to it. Returns the length; out has room for 40 bytes. */
static int shapes_write_number(double x, int digits, char *out)
{
    int n = 0;
    for (int d = digits < 17 ? digits : 15; d <= digits; d++) {
        n = snprintf(out, 40, "%.*g", d, x);
        double back = digits < 17 ? x : strtod(out, NULL);
        if (!(back < x) && !(back > x))
            break;
    }
    for (char *c = out; c < out + n; c++)
        if (*c == ',')
            *c = '.';
    return n;
}
#endif

/* An arc is farther than that from its chords nowhere, as a share of its own
   chord, or of its diameter where it is more than a half of a circle. */
#define SHAPES_ARC 1e-3

enum {
    SHAPES_HALVINGS = 8, /* of an arc, at most                             */
    SHAPES_KINDS = 500,  /* rows of the list of what was skipped, at most  */
    SHAPES_SHOWN = 40    /* bytes of a label in a sentence                 */
};

enum shapes_role {
    SHAPES_STONE,
    SHAPES_GROUND,
    SHAPES_FILL,
    SHAPES_IGNORED,
    SHAPES_ROLES
};

/* Text that grows; `lost` where memory was lacking. */
struct shapes_text {
    char *at;
    int length, room, lost;
};

struct shapes_point {
    double x, y, bulge;
};

struct shapes_path {
    int first, points; /* in the list of points                            */
    int kind, label;   /* offsets of words                                 */
    int line;          /* where it begins, 0: not known                    */
    int group;         /* parts of one stone have one number; -1: alone    */
    int closed;        /* nonzero: an outline                              */
    int gone;          /* nonzero: it became no block                      */
    int joined;        /* nonzero: an outline of lines that meet           */
    enum shapes_role role;
    double area; /* of an outline, once it is known                  */
};

struct shapes_skip {
    int kind, label, line, count;
};

/* What the user says about a file. */
struct shapes_asked {
    const char *const *layer; /* words "NAME=ROLE"                          */
    int layers;
    const char *const *densities; /* words "D" or "NAME=D", the last one wins */
    int density_words;
    int has_ground;    /* nonzero: the ground is a line at `ground`        */
    double ground;     /* y, in the numbers of the file                    */
    double pixel;      /* metres a pixel of a photograph; 0: not known     */
    double tolerance;  /* pixels by which an outline may be off            */
    const char *image; /* number or name, of several in a file; NULL      */
    const char *const *frictions; /* words "NAME=MU", "NAME,NAME=MU" or "MU" */
    int friction_words;
    double phi; /* friction angle of fill, in degrees; 0: it is weight alone */
};

struct shapes {
    struct shapes_point *point;
    int points, point_room;
    struct shapes_path *path;
    int paths, path_room;
    struct shapes_skip *skip;
    int skips, skip_room;
    struct shapes_text words;
    struct shapes_text notes; /* one a line                                */
    struct shapes_text text;  /* the statements that are made              */
    struct shapes_text message;
    int fault; /* the line of the message, 0: the whole file              */
    int lost;  /* nonzero: memory was lacking                             */
    const struct shapes_asked *asked;
    double unit;       /* metres a unit of the file                       */
    const char *units; /* "m", "px" or NULL: not known                    */
    int photograph;    /* labels are names, outlines are measured         */
    int down;          /* nonzero: y runs down, from `height`             */
    double height;     /* of a photograph, < 0: not known                 */
    int arcs, groups;
    double meet;    /* ends of lines as near as that meet; 0: none were drawn */
    double apart;   /* the nearest ends that do not; 0: none are near      */
    int apart_line; /* of one of them                                      */
    int assumed;    /* outlines whose density nobody told                 */
    int all_assumed; /* nonzero: of none is it told                        */
    double sagitta;  /* farthest of a chord from its arc                */
};

/* ---- Text ----------------------------------------------------------------- */

static void shapes_put_bytes(struct shapes_text *t, const char *s, int n)
{
    if (t->lost)
        return;
    if (n > t->room - t->length - 1) {
        int room = t->room > INT_MAX / 4 ? 0 : 2 * t->room + n + 64;
        char *more = room > 0 && n < INT_MAX / 4 ? realloc(t->at, (size_t)room)
                                                 : NULL;
        if (!more) {
            t->lost = 1;
            return;
        }
        t->at = more;
        t->room = room;
    }
    memcpy(t->at + t->length, s, (size_t)n);
    t->length += n;
    t->at[t->length] = '\0';
}

static void shapes_put(struct shapes_text *t, const char *s)
{
    shapes_put_bytes(t, s, (int)strlen(s));
}

static void shapes_put_int(struct shapes_text *t, int value)
{
    char digit[12];
    int n = 0;
    unsigned left = value < 0 ? 0u - (unsigned)value : (unsigned)value;
    do
        digit[sizeof digit - 1 - (size_t)n++] = (char)('0' + left % 10);
    while (left /= 10);
    if (value < 0)
        digit[sizeof digit - 1 - (size_t)n++] = '-';
    shapes_put_bytes(t, digit + sizeof digit - n, n);
}

static void shapes_put_number(struct shapes_text *t, double x, int digits)
{
    char out[40];
    shapes_put_bytes(t, out, shapes_write_number(x, digits, out));
}

/* Puts at most SHAPES_SHOWN bytes of a word that words() has made, in whole
   characters. */
static void shapes_put_shown(struct shapes_text *t, const char *word)
{
    int n = 0;
    while (word[n] && n + text_utf8(word + n) <= SHAPES_SHOWN)
        n += text_utf8(word + n);
    shapes_put_bytes(t, word, n);
    if (word[n])
        shapes_put(t, "...");
}

/* ---- Lists and words ------------------------------------------------------ */

/* Returns the array with room for one more behind n, NULL where memory ends. */
static void *shapes_grown(struct shapes *s, void *array, int n, int *room,
                          size_t size)
{
    void *more;
    if (n < *room)
        return array;
    more = *room < INT_MAX / 4 ? realloc(array, (size_t)(2 * *room + 64) * size)
                               : NULL;
    if (!more) {
        s->lost = 1;
        return NULL;
    }
    *room = 2 * *room + 64;
    return more;
}

/* Returns memory for n of a size, all 0; NULL with `lost` where there is none. */
static void *shapes_array(struct shapes *s, int n, size_t size)
{
    const size_t bytes = (size_t)(n > 0 ? n : 1) * size;
    void *made = malloc(bytes);
    if (made)
        memset(made, 0, bytes);
    else
        s->lost = 1;
    return made;
}

static const char *shapes_at(const struct shapes *s, int word)
{
    return s->words.lost || !s->words.at ? "" : s->words.at + word;
}

static int shapes_is_utf8(const char *s, int n)
{
    char end[4] = {0};
    for (int i = 0; i < n;) {
        int step = n - i >= 4 ? text_utf8(s + i) : 0;
        if (n - i < 4) {
            memset(end, 0, sizeof end);
            memcpy(end, s + i, (size_t)(n - i));
            step = text_utf8(end);
        }
        if (step == 0)
            return 0;
        i += step;
    }
    return 1;
}

/* Keeps a word as UTF-8: what is none is taken for Latin-1, and control
   characters become "?". Returns its offset. */
static int shapes_word(struct shapes *s, const char *word, int n)
{
    const int at = s->words.length, good = shapes_is_utf8(word, n);
    for (int i = 0; i < n; i++) {
        const unsigned char c = (unsigned char)word[i];
        char two[2] = {(char)(0xc0 | c >> 6), (char)(0x80 | (c & 0x3f))};
        if (c < 0x20 || c == 0x7f)
            shapes_put_bytes(&s->words, "?", 1);
        else if (c < 0x80 || good)
            shapes_put_bytes(&s->words, word + i, 1);
        else
            shapes_put_bytes(&s->words, two, 2);
    }
    shapes_put_bytes(&s->words, "", 1);
    s->lost |= s->words.lost;
    return s->words.lost ? 0 : at;
}

/* Returns the letter at s in lower case, also of Latin-1's letters in UTF-8. */
static int shapes_lower(const char *s, int i)
{
    const unsigned char c = (unsigned char)s[i];
    if (c >= 'A' && c <= 'Z')
        return c + 32;
    if (i > 0 && (unsigned char)s[i - 1] == 0xc3 && c >= 0x80 && c <= 0x9e)
        return c + 32;
    return c;
}

/* Returns 1 if n bytes at a are the word b, letters in any case. */
static int shapes_same(const char *a, int n, const char *b)
{
    int i = 0;
    while (i < n && b[i] && shapes_lower(a, i) == shapes_lower(b, i))
        i++;
    return i == n && !b[i];
}

/* Says what is wrong, in pieces: begins the message, with the line. */
static struct shapes_text *shapes_fault(struct shapes *s, int line)
{
    s->message.length = 0;
    s->fault = line;
    return &s->message;
}

static int shapes_fail(struct shapes *s, int line, const char *what)
{
    shapes_put(shapes_fault(s, line), what);
    return -1;
}

/* Says what was expected, and what was read in its place. */
static int shapes_expected(struct shapes *s, int line, const char *what,
                           const char *read, int n)
{
    struct shapes_text *t = shapes_fault(s, line);
    const int word = shapes_word(s, read, n < 400 ? n : 400);
    shapes_put(t, what);
    shapes_put(t, " is expected, read '");
    shapes_put_shown(t, shapes_at(s, word));
    shapes_put(t, "'");
    return -1;
}

/* Lists something that becomes no block: `kind` and `label` are words. */
static void shapes_listed_as(struct shapes *s, int kind, int label, int line)
{
    struct shapes_skip *row;
    for (int i = 0; i < s->skips; i++) {
        row = s->skip + i;
        if (i + 1 == SHAPES_KINDS
            || (strcmp(shapes_at(s, row->kind), shapes_at(s, kind)) == 0
                && strcmp(shapes_at(s, row->label), shapes_at(s, label))
                       == 0)) {
            row->count++;
            return;
        }
    }
    row = shapes_grown(s, s->skip, s->skips, &s->skip_room, sizeof *row);
    if (!row)
        return;
    s->skip = row;
    row += s->skips++;
    if (s->skips == SHAPES_KINDS) {
        kind = shapes_word(s, "others", 6);
        label = shapes_word(s, "", 0);
    }
    row->kind = kind;
    row->label = label;
    row->line = line;
    row->count = 1;
}

/* Lists something of a kind that is no word yet. */
static void shapes_skipped(struct shapes *s, const char *kind, int label,
                           int line)
{
    shapes_listed_as(s, shapes_word(s, kind, (int)strlen(kind)), label, line);
}

/* ---- Roles ---------------------------------------------------------------- */

/* Words that give a label its role, in lower case: of several the last one. */
/* clang-format off */
static const char *const shapes_role_words[SHAPES_ROLES] = {
    " stone stones block blocks brick bricks voussoir voussoirs keystone ring"
    " arch wall course courses pier piers pillar column lintel spandrel parapet"
    " masonry rock rocks stein steine ziegel bogen mauer pfeiler ",
    " ground fixed abutment abutments foundation foundations footing footings"
    " base bedrock terrain floor support supports boden baugrund fundament"
    " fundamente widerlager auflager sol ",
    " fill backfill infill filling soil earth sand gravel clay backing"
    " f\xc3\xbcllung fuellung hinterf\xc3\xbcllung hinterfuellung"
    " verf\xc3\xbcllung verfuellung erde erdreich kies lehm schotter remblai ",
    " frame border rahmen title text texts texte note notes dim dims dimension"
    " dimensions bemassung annotation annotations anno hatch hatching schraffur"
    " centreline centerline centrelines defpoints viewport viewports scale"
    " scalebar legend legende ignore hilfslinien "};

/* Words that say so only at the end of a label: a centre pier is a stone. */
static const char shapes_last_words[] =
    " centre center axis axes achse achsen grid hidden label labels ";
/* clang-format on */

/* Returns 1 if n letters, in any case, are a word of the list. */
static int shapes_listed(const char *list, const char *word, int n)
{
    while (*list == ' ' && list[1]) {
        int length = 0, same = 1;
        for (list++; list[length] != ' ';)
            length++;
        for (int i = 0; i < n && same; i++)
            same = i < length
                && shapes_lower(word, i) == (int)(unsigned char)list[i];
        if (same && n == length)
            return 1;
        list += length;
    }
    return 0;
}

/* Returns the role that a word of the command line names, or -1. */
static inline int shapes_role_named(const char *word, int n)
{
    static const char *const name[][2] = {{"stone", "block"},
                                          {"ground", "fixed"},
                                          {"fill", "soil"},
                                          {"ignore", "skip"}};
    for (int role = 0; role < SHAPES_ROLES; role++)
        if (shapes_same(word, n, name[role][0])
            || shapes_same(word, n, name[role][1]))
            return role;
    return -1;
}

/* Returns the place of the last "=" of a word "NAME=VALUE", -1: it has none. */
static int shapes_equals(const char *word)
{
    int at = -1;
    for (int i = 0; word[i]; i++)
        if (word[i] == '=')
            at = i;
    return at;
}

/* Returns the role that the user gives a label, or -1. */
static int shapes_role_asked(const struct shapes *s, const char *label)
{
    int role = -1;
    for (int k = 0; k < s->asked->layers; k++) {
        const char *word = s->asked->layer[k];
        const int at = shapes_equals(word);
        if (at > 0 && shapes_same(word, at, label))
            role = shapes_role_named(word + at + 1, (int)strlen(word + at + 1));
    }
    return role;
}

static int shapes_is_letter(const char *s, int i)
{
    const unsigned char c = (unsigned char)s[i];
    return (c | 0x20) >= 'a' ? (c | 0x20) <= 'z' || c >= 0x80 : 0;
}

/* Returns the role of the last word of the label that has one, or -1. A capital
   after a small letter begins a word. */
static int shapes_role_of(const char *label)
{
    int role = -1, last = 0;
    for (int i = 0, n; label[i]; i += n) {
        n = 1;
        if (!shapes_is_letter(label, i))
            continue;
        while (shapes_is_letter(label, i + n)
               && !(label[i + n] >= 'A' && label[i + n] <= 'Z'
                    && label[i + n - 1] >= 'a' && label[i + n - 1] <= 'z'))
            n++;
        for (int k = 0; k < SHAPES_ROLES; k++)
            if (shapes_listed(shapes_role_words[k], label + i, n))
                role = k;
        last = shapes_listed(shapes_last_words, label + i, n);
    }
    return last && role < 0 ? SHAPES_IGNORED : role;
}

static enum shapes_role shapes_role(const struct shapes *s, const char *label)
{
    int role = shapes_role_asked(s, label);
    if (role < 0)
        role = shapes_role_of(label);
    return role < 0 ? SHAPES_STONE : (enum shapes_role)role;
}

/* Returns the density that the user gives a label, 0: none. */
static double shapes_density(const struct shapes *s, const char *label)
{
    double density = 0, value;
    for (int k = 0; k < s->asked->density_words; k++) {
        const char *word = s->asked->densities[k];
        const int at = shapes_equals(word);
        if ((at < 0 || shapes_same(word, at, label))
            && shapes_read_number(word + at + 1, (int)strlen(word + at + 1),
                                  &value))
            density = value;
    }
    return density;
}

/* ---- Paths ---------------------------------------------------------------- */

/* Adds a point to the path that is being read. */
static void shapes_point(struct shapes *s, double x, double y, double bulge)
{
    struct shapes_point *p = shapes_grown(s, s->point, s->points,
                                          &s->point_room, sizeof *p);
    if (!p)
        return;
    s->point = p;
    p += s->points++;
    p->x = x;
    p->y = y;
    p->bulge = bulge;
}

static double shapes_abs(double x) { return x < 0 ? -x : x; }

static double shapes_distance(struct shapes_point p, struct shapes_point q)
{
    const double x = p.x - q.x, y = p.y - q.y;
    return SHAPES_SQRT(x * x + y * y);
}

/* Returns the middle of the arc from p to q. */
static struct shapes_point shapes_middle(struct shapes_point p,
                                         struct shapes_point q, double bulge)
{
    struct shapes_point m = {0, 0, 0};
    m.x = (p.x + q.x) / 2 + bulge / 2 * (q.y - p.y);
    m.y = (p.y + q.y) / 2 - bulge / 2 * (q.x - p.x);
    return m;
}

/* Adds the chords of the arc from p to q, whose bulge is p's; without q. Each
   point keeps the bulge of the part that follows it. */
static void shapes_chords(struct shapes *s, struct shapes_point p,
                          struct shapes_point q)
{
    struct shapes_point out[(1 << SHAPES_HALVINGS) + 1];
    double bulge = p.bulge, b = shapes_abs(bulge), chord, size;
    int halvings = 0, n;
    chord = shapes_distance(p, q);
    size = b > 1 ? chord * (1 + b * b) / (2 * b) : chord;
    while (b * chord / 2 > SHAPES_ARC * size && halvings < SHAPES_HALVINGS) {
        const double half = b / (1 + SHAPES_SQRT(1 + b * b));
        chord *= (1 + b * b) / (2 * b) * (2 * half) / (1 + half * half);
        b = half;
        halvings++;
    }
    n = 1 << halvings;
    out[0] = p;
    out[n] = q;
    for (int step = n; step > 1; step /= 2) {
        for (int i = 0; i < n; i += step)
            out[i + step / 2] = shapes_middle(out[i], out[i + step], bulge);
        bulge /= 1 + SHAPES_SQRT(1 + bulge * bulge);
    }
    for (int i = 0; i < n; i++)
        shapes_point(s, out[i].x, out[i].y, bulge);
    if (b * chord / 2 > s->sagitta)
        s->sagitta = b * chord / 2;
    s->arcs++;
}

/* Ends the path of the points from `first` on: arcs become chords. `kind` and
   `label` are words. Returns its index, -1: there is none. */
static int shapes_path(struct shapes *s, int first, int closed, int kind,
                       int label, int line)
{
    const int end = s->points;
    struct shapes_path *p = NULL;
    if (end - first > 1)
        p = shapes_grown(s, s->path, s->paths, &s->path_room, sizeof *p);
    if (!p) {
        s->points = first;
        return -1;
    }
    s->path = p;
    p += s->paths++;
    memset(p, 0, sizeof *p);
    p->first = end;
    for (int i = first; i < end && !s->lost; i++) {
        const struct shapes_point a = s->point[i];
        if ((a.bulge < 0 || a.bulge > 0) && (i + 1 < end || closed))
            shapes_chords(s, a, s->point[i + 1 < end ? i + 1 : first]);
        else
            shapes_point(s, a.x, a.y, 0);
    }
    p->points = s->points - end;
    p->closed = closed;
    p->kind = kind;
    p->label = label;
    p->line = line;
    p->group = -1;
    p->role = shapes_role(s, shapes_at(s, label));
    return s->paths - 1;
}

/* Lists a path as skipped, for a reason; "": its kind. */
static void shapes_leave(struct shapes *s, struct shapes_path *p,
                         const char *why)
{
    p->gone = 1;
    shapes_listed_as(s, *why ? shapes_word(s, why, (int)strlen(why)) : p->kind,
                     p->label, p->line);
}

/* ---- Circles and angles --------------------------------------------------- */

/* Computes sine and cosine of an angle in degrees, from arithmetic alone, so
   that every machine has the same digits. */
static void shapes_turn(double degrees, double *c, double *s)
{
    double turns = degrees / 90, x, x2, sine, cosine;
    long whole;
    if (!(shapes_abs(turns) < 1e9))
        turns = 0;
    whole = (long)(turns + (turns < 0 ? -0.5 : 0.5));
    x = (degrees - 90.0 * (double)whole) * 0.017453292519943295;
    if (!(shapes_abs(degrees) < 9e10))
        x = 0;
    x2 = x * x;
    sine = cosine = 1;
    for (int k = 10; k > 0; k--) {
        sine = 1 - sine * x2 / (double)(2 * k * (2 * k + 1));
        cosine = 1 - cosine * x2 / (double)(2 * k * (2 * k - 1));
    }
    sine *= x;
    switch (whole & 3) {
    case 0:
        *c = cosine;
        *s = sine;
        break;
    case 1:
        *c = -sine;
        *s = cosine;
        break;
    case 2:
        *c = -cosine;
        *s = -sine;
        break;
    default: *c = sine; *s = -cosine;
    }
}

/* Adds the points of an arc about a centre, counter-clockwise from one angle to
   the other (degrees); a whole circle is two halves. */
static void shapes_arc(struct shapes *s, double x, double y, double r,
                       double from, double to)
{
    double c, q, sweep = to - from;
    const double turns = sweep / 360;
    if (!(shapes_abs(turns) < 1e6))
        return;
    sweep -= 360 * (double)(long)turns;
    if (!(sweep > 0))
        sweep += 360;
    shapes_turn(sweep / 8, &c, &q);
    s->arcs--; /* of two halves, which count as one */
    for (int k = 0; k <= 2; k++) {
        double px, py;
        shapes_turn(from + sweep / 2 * k, &px, &py);
        shapes_point(s, x + r * px, y + r * py, k < 2 ? q / c : 0);
    }
}

/* ---- The whole ------------------------------------------------------------ */

static void shapes_free(struct shapes *s)
{
    free(s->point);
    free(s->path);
    free(s->skip);
    free(s->words.at);
    free(s->notes.at);
    free(s->text.at);
    free(s->message.at);
}

#endif /* SHAPES_H */
