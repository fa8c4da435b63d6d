/* svg.h - reads a drawing (SVG) as shapes:

       outlines    polygon, rect (its corners are square), circle, ellipse, the
                   closed parts of a path
       open paths  line, polyline, path
       curves      become chords: 32 each
       transform   of elements and groups: all kinds, but none of styles
       labels      inkscape:label or id; of a group where only the group's has a
                   role
       use         draws a shape or a group of this file again; one of a symbol,
                   of another file, or in itself is skipped and listed

   y runs down in the file. What is in defs, symbol, clipPath, mask, marker and
   pattern is no part of the picture; texts, images, an svg in the svg, and what is
   hidden or moved by its style are skipped and listed. A style sheet that may do
   so is named. Lengths are as drawn; those with a unit are pixels, shares (%) are
   of the viewBox.

   SPDX-License-Identifier: MIT */

#ifndef SVG_H
#define SVG_H

#include "shapes.h"

enum {
    SVG_DEEP = 100,      /* elements within each other                        */
    SVG_CHORDS = 32,     /* of a curve                                        */
    SVG_HALVINGS = 5,    /* of an arc: the same                              */
    SVG_USES = 8,        /* elements `use` that draw each other              */
    SVG_WORK = 200000000 /* of all elements `use`                       */
};

/* Is an element taken? What is not is listed, but for parts of no picture. */
enum svg_state {
    SVG_TAKEN,
    SVG_HIDDEN,
    SVG_NO_PART,
    SVG_MOVED, /* by a style                                              */
    SVG_NESTED /* in an svg in the svg                                    */
};

struct svg_part {
    int at, length;
};

/* x' = xx x + xy y + x: of all groups around an element. */
struct svg_frame {
    double xx, xy, yx, yy, x, y;
    int label; /* of the nearest group that has one, -1: none            */
    struct svg_part name; /* of the element whose frame it is             */
    int line;             /* and its line                                 */
    enum svg_state state;
};

struct svg {
    struct shapes *s;
    const char *data;
    int length, at, line;
    struct svg_frame frame[SVG_DEEP];
    int depth;
    struct svg_part name, attributes; /* of the element that is read     */
    int start;                        /* its line                       */
    int found;                        /* nonzero: an element `svg`      */
    double wide, high;                /* of the picture; 0: not known   */
    int uses;                         /* around the element             */
    double *work; /* of all elements `use`: bytes searched, 10 for one read */
};

/* The numbers of an attribute, one after the other. */
struct svg_numbers {
    const char *at, *end;
};

/* ---- Elements ------------------------------------------------------------- */

static int svg_is(const struct svg *v, struct svg_part part, const char *word)
{
    const int n = (int)strlen(word);
    return part.length == n && memcmp(v->data + part.at, word, (size_t)n) == 0;
}

static int svg_is_one(const struct svg *v, struct svg_part part,
                      const char *list)
{
    return shapes_listed(list, v->data + part.at, part.length);
}

static int svg_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\n' || c == '\r';
}

/* Moves behind the next `end`, or to the end of the file. */
static void svg_skip_to(struct svg *v, const char *end)
{
    const int n = (int)strlen(end);
    while (v->at < v->length) {
        if (v->length - v->at >= n
            && memcmp(v->data + v->at, end, (size_t)n) == 0) {
            v->at += n;
            return;
        }
        v->line += v->data[v->at++] == '\n';
    }
}

/* Moves to the end of an element, past what stands in quotation marks. */
static void svg_to_end(struct svg *v)
{
    char mark = '\0';
    while (v->at < v->length && (mark || v->data[v->at] != '>')) {
        const char c = v->data[v->at++];
        v->line += c == '\n';
        if (mark ? c == mark : c == '"' || c == '\'')
            mark = mark ? '\0' : c;
    }
}

/* Finds an attribute. Returns 0 where there is none. */
static int svg_get(const struct svg *v, const char *key, struct svg_part *out)
{
    const int n = (int)strlen(key);
    int at = v->attributes.at;
    const int end = at + v->attributes.length;
    while (at < end) {
        int from, length;
        char mark;
        while (at < end && svg_blank(v->data[at]))
            at++;
        for (from = at;
             at < end && v->data[at] != '=' && !svg_blank(v->data[at]);)
            at++;
        length = at - from;
        while (at < end && v->data[at] != '"' && v->data[at] != '\'')
            at++;
        if (at >= end)
            return 0;
        mark = v->data[at++];
        out->at = at;
        while (at < end && v->data[at] != mark)
            at++;
        out->length = at++ - out->at;
        if (length == n && memcmp(v->data + from, key, (size_t)n) == 0)
            return 1;
    }
    return 0;
}

/* Returns 1 if an attribute holds a word. */
static int svg_holds(const struct svg *v, struct svg_part part,
                     const char *word)
{
    const int n = (int)strlen(word);
    for (int i = 0; i + n <= part.length; i++)
        if (memcmp(v->data + part.at + i, word, (size_t)n) == 0)
            return 1;
    return 0;
}

/* Returns where a part of a style ends that begins at `at`: at one of two
   marks. */
static int svg_style_end(const struct svg *v, int at, int end, char one,
                         char two)
{
    while (at < end && v->data[at] != one && v->data[at] != two)
        at++;
    return at;
}

/* Returns a part without the blanks around it. */
static struct svg_part svg_bare(const struct svg *v, int from, int to)
{
    struct svg_part p;
    while (from < to && svg_blank(v->data[from]))
        from++;
    while (to > from && svg_blank(v->data[to - 1]))
        to--;
    p.at = from;
    p.length = to - from;
    return p;
}

/* Finds a property in the element's style. Returns 0 where there is none. */
static int svg_style(const struct svg *v, const char *key, struct svg_part *out)
{
    struct svg_part p;
    if (!svg_get(v, "style", &p))
        return 0;
    for (int at = p.at, end = p.at + p.length, stop; at < end; at = stop + 1) {
        const int colon = svg_style_end(v, at, end, ':', ';');
        stop = svg_style_end(v, colon, end, ';', ';');
        if (colon < stop && svg_is(v, svg_bare(v, at, colon), key)) {
            *out = svg_bare(v, colon + 1, stop);
            return 1;
        }
    }
    return 0;
}

/* Returns 1 if a style moves the element. */
static int svg_is_moved(const struct svg *v)
{
    static const char *const key[] = {"transform", "translate", "rotate",
                                      "scale",     "offset",    "zoom"};
    struct svg_part p;
    for (int k = 0; k < 6; k++)
        if (svg_style(v, key[k], &p) && !svg_is(v, p, "none"))
            return 1;
    return svg_get(v, "transform-origin", &p)
        || svg_style(v, "transform-origin", &p);
}

/* Returns 1 if an opacity is 0. */
static int svg_is_clear(const struct svg *v, struct svg_part p)
{
    double value;
    return shapes_read_number(v->data + p.at, p.length, &value) && !(value > 0);
}

static int svg_is_hidden(const struct svg *v)
{
    struct svg_part p;
    if ((svg_get(v, "opacity", &p) && svg_is_clear(v, p))
        || (svg_style(v, "opacity", &p) && svg_is_clear(v, p)))
        return 1;
    if ((svg_get(v, "display", &p) && svg_is(v, p, "none"))
        || (svg_get(v, "visibility", &p) && svg_is(v, p, "hidden")))
        return 1;
    return svg_get(v, "style", &p)
        && (svg_holds(v, p, "display:none") || svg_holds(v, p, "display: none")
            || svg_holds(v, p, "visibility:hidden"));
}

/* ---- Numbers -------------------------------------------------------------- */

static struct svg_numbers svg_numbers_of(const struct svg *v,
                                         struct svg_part part)
{
    struct svg_numbers n;
    n.at = v->data + part.at;
    n.end = n.at + part.length;
    return n;
}

static void svg_gap(struct svg_numbers *n)
{
    while (n->at < n->end && (svg_blank(*n->at) || *n->at == ','))
        n->at++;
}

static int svg_digits(const char *s, const char *end)
{
    int n = 0;
    while (s + n < end && s[n] >= '0' && s[n] <= '9')
        n++;
    return n;
}

/* Reads the next number, which may touch the one before. Returns 0 where there is
   none. */
static int svg_number(struct svg_numbers *n, double *out)
{
    const char *s;
    int power;
    svg_gap(n);
    s = n->at;
    s += s < n->end && (*s == '-' || *s == '+');
    s += svg_digits(s, n->end);
    if (s < n->end && *s == '.')
        s += 1 + svg_digits(s + 1, n->end);
    if (s < n->end && (*s == 'e' || *s == 'E')) {
        power = s + 1 < n->end && (s[1] == '-' || s[1] == '+');
        if (svg_digits(s + 1 + power, n->end) > 0)
            s += 1 + power + svg_digits(s + 1 + power, n->end);
    }
    if (!shapes_read_number(n->at, (int)(s - n->at), out))
        return 0;
    n->at = s;
    return 1;
}

/* Reads a flag of an arc: one character. Returns 0 where it is none. */
static int svg_flag(struct svg_numbers *n, int *out)
{
    svg_gap(n);
    if (n->at >= n->end || (*n->at != '0' && *n->at != '1'))
        return 0;
    *out = *n->at++ == '1';
    return 1;
}

/* Returns how many pixels the unit at the end of a number is, 0: it is none that
   is read (a share of the page, a size of letters). */
static double svg_unit(const struct svg_numbers *n)
{
    static const char *const name[] = {"", "px", "mm", "cm", "in", "pt", "pc"};
    static const double pixels[] = {1,  1,        96 / 25.4, 96 / 2.54,
                                    96, 96 / 72., 16};
    int length = (int)(n->end - n->at);
    while (length > 0 && svg_blank(n->at[length - 1]))
        length--;
    for (int k = 0; k < 7; k++)
        if (shapes_same(n->at, length, name[k]))
            return pixels[k];
    return 0;
}

/* Returns what a hundredth of the picture is, along the axis of a key; 0: that is
   not known, or it is a radius. */
static double svg_hundredth(const struct svg *v, const char *key)
{
    const char axis = *key == 'c' || *key == 'r' ? key[1] : *key;
    return (axis == 'x' || axis == 'w' ? v->wide : axis ? v->high : 0) / 100;
}

/* Reads the length of an attribute, which is 0 without it. Returns 0 where
   it is none. */
static int svg_value(const struct svg *v, const char *key, double *out)
{
    struct svg_part p;
    struct svg_numbers n;
    double unit;
    *out = 0;
    if (!svg_get(v, key, &p))
        return 1;
    n = svg_numbers_of(v, p);
    if (!svg_number(&n, out))
        return 0;
    unit = shapes_same(n.at, (int)(n.end - n.at), "%") ? svg_hundredth(v, key)
                                                       : svg_unit(&n);
    *out *= unit;
    return unit > 0;
}

/* Reads how large the picture is, of which lengths may be shares. */
static void svg_size(struct svg *v)
{
    struct svg_part p;
    struct svg_numbers n;
    double x, y;
    if (!svg_get(v, "viewBox", &p)) {
        if (svg_value(v, "width", &x) && svg_value(v, "height", &y)) {
            v->wide = x;
            v->high = y;
        }
        return;
    }
    n = svg_numbers_of(v, p);
    if (!svg_number(&n, &x) || !svg_number(&n, &y) || !svg_number(&n, &v->wide)
        || !svg_number(&n, &v->high))
        v->wide = v->high = 0;
}

/* ---- Transforms ----------------------------------------------------------- */

/* Puts a transform before those of a frame. */
static void svg_apply(struct svg_frame *f, double xx, double yx, double xy,
                      double yy, double x, double y)
{
    const struct svg_frame g = *f;
    f->xx = g.xx * xx + g.xy * yx;
    f->xy = g.xx * xy + g.xy * yy;
    f->x = g.xx * x + g.xy * y + g.x;
    f->yx = g.yx * xx + g.yy * yx;
    f->yy = g.yx * xy + g.yy * yy;
    f->y = g.yx * x + g.yy * y + g.y;
}

/* Applies a turn about a point, or a skew of x or y. */
static void svg_turn(const struct svg *v, struct svg_part kind, const double *a,
                     int n, struct svg_frame *f)
{
    const double x = n > 1 ? a[1] : 0, y = n > 1 ? a[2] : 0;
    double c, s;
    shapes_turn(a[0], &c, &s);
    if (svg_is(v, kind, "rotate"))
        svg_apply(f, c, s, -s, c, x - c * x + s * y, y - s * x - c * y);
    else if (svg_is(v, kind, "skewX"))
        svg_apply(f, 1, 0, s / c, 1, 0, 0);
    else
        svg_apply(f, 1, s / c, 0, 1, 0, 0);
}

/* Applies one kind of transform with its n numbers. Returns 0 where it is
   none. */
static int svg_transform_one(const struct svg *v, struct svg_part kind,
                             const double *a, int n, struct svg_frame *f)
{
    static const char *const name[] = {"matrix", "translate", "scale",
                                       "rotate", "skewX",     "skewY"};
    static const int least[] = {6, 1, 1, 1, 1, 1}, most[] = {6, 2, 2, 3, 1, 1};
    int k = 0;
    while (k < 6 && !svg_is(v, kind, name[k]))
        k++;
    if (k == 6 || n < least[k] || n > most[k] || (k == 3 && n == 2))
        return 0;
    if (k == 0)
        svg_apply(f, a[0], a[1], a[2], a[3], a[4], a[5]);
    else if (k == 1)
        svg_apply(f, 1, 0, 0, 1, a[0], n > 1 ? a[1] : 0);
    else if (k == 2)
        svg_apply(f, a[0], 0, 0, n > 1 ? a[1] : a[0], 0, 0);
    else
        svg_turn(v, kind, a, n, f);
    return 1;
}

/* Applies the transform of the element. Returns -1 where it cannot be read.
   */
static int svg_transform(struct svg *v, struct svg_frame *f)
{
    struct svg_part p, kind;
    struct svg_numbers n;
    if (!svg_get(v, "transform", &p))
        return 0;
    n = svg_numbers_of(v, p);
    for (svg_gap(&n); n.at < n.end; svg_gap(&n)) {
        double a[6];
        int count = 0;
        kind.at = (int)(n.at - v->data);
        while (n.at < n.end && *n.at != '(' && !svg_blank(*n.at))
            n.at++;
        kind.length = (int)(n.at - v->data) - kind.at;
        svg_gap(&n);
        if (n.at < n.end && *n.at == '(') {
            n.at++;
            while (count < 6 && svg_number(&n, a + count))
                count++;
            svg_gap(&n);
        }
        if (n.at >= n.end || *n.at != ')'
            || !svg_transform_one(v, kind, a, count, f))
            return shapes_expected(v->s, v->start, "a transform",
                                   v->data + p.at, p.length);
        n.at++;
    }
    return 0;
}

/* ---- Shapes --------------------------------------------------------------- */

/* Returns the label of the element: its own, or that of a group if only it
   has a role. */
static int svg_label(struct svg *v)
{
    const int group = v->frame[v->depth - 1].label;
    struct svg_part p;
    int own;
    if (!svg_get(v, "inkscape:label", &p) && !svg_get(v, "id", &p))
        return group >= 0
                 ? group
                 : shapes_word(v->s, v->data + v->name.at, v->name.length);
    own = shapes_word(v->s, v->data + p.at, p.length);
    if (group < 0 || shapes_role_asked(v->s, shapes_at(v->s, own)) >= 0)
        return own;
    if (shapes_role_asked(v->s, shapes_at(v->s, group)) >= 0)
        return group;
    return shapes_role_of(shapes_at(v->s, own)) < 0
                && shapes_role_of(shapes_at(v->s, group)) >= 0
             ? group
             : own;
}

/* Ends a path: brings it to its place in the picture. */
static void svg_path_end(struct svg *v, const struct svg_frame *f, int first,
                         int closed, int label)
{
    struct shapes *s = v->s;
    const double det = f->xx * f->yy - f->xy * f->yx;
    const double square = f->xx * f->xx + f->yx * f->yx;
    const int alike = shapes_abs(f->xx * f->xy + f->yx * f->yy)
                       <= 1e-9 * shapes_abs(det)
                   && shapes_abs(shapes_abs(det) - square) <= 1e-9 * square;
    const int kind = shapes_word(s, v->data + v->name.at, v->name.length);
    const int made = shapes_path(s, first, closed, kind, label, v->start);
    if (made < 0)
        return;
    for (int k = 0; k < s->path[made].points; k++) {
        struct shapes_point *p = s->point + s->path[made].first + k;
        const double x = p->x, y = p->y;
        p->x = f->xx * x + f->xy * y + f->x;
        p->y = f->yx * x + f->yy * y + f->y;
        p->bulge = !alike ? 0 : det < 0 ? -p->bulge : p->bulge;
    }
}

/* Remembers how far the chords of a curve are off. */
static void svg_curved(struct shapes *s, double off)
{
    s->arcs++;
    s->sagitta = off > s->sagitta ? off : s->sagitta;
}

/* Reads rect, circle, ellipse, line. Returns 0 where their numbers are none.
   */
static int svg_basic(struct svg *v)
{
    static const char *const key[4][4] = {{"x", "y", "width", "height"},
                                          {"cx", "cy", "r", "r"},
                                          {"cx", "cy", "rx", "ry"},
                                          {"x1", "y1", "x2", "y2"}};
    static const char *const name[4] = {"rect", "circle", "ellipse", "line"};
    struct shapes *s = v->s;
    double a[4];
    int kind = 0;
    while (kind < 4 && !svg_is(v, v->name, name[kind]))
        kind++;
    if (kind == 4)
        return 0;
    for (int k = 0; k < 4; k++)
        if (!svg_value(v, key[kind][k], a + k))
            return 0;
    if (kind < 3 && (a[2] < 0 || a[3] < 0))
        return 0; /* a size below 0 is an error in SVG */
    if (kind == 0) {
        shapes_point(s, a[0], a[1], 0);
        shapes_point(s, a[0] + a[2], a[1], 0);
        shapes_point(s, a[0] + a[2], a[1] + a[3], 0);
        shapes_point(s, a[0], a[1] + a[3], 0);
    } else if (kind == 3) {
        shapes_point(s, a[0], a[1], 0);
        shapes_point(s, a[2], a[3], 0);
    } else
        for (int k = 0; k < 2 * SVG_CHORDS; k++) {
            double c, q;
            shapes_turn(180.0 * k / SVG_CHORDS, &c, &q);
            shapes_point(s, a[0] + a[2] * c, a[1] + a[3] * q, 0);
        }
    if (kind == 1 || kind == 2)
        svg_curved(s, 1.3e-3 * (a[2] > a[3] ? a[2] : a[3]));
    return 1;
}

static int svg_points(struct svg *v)
{
    struct svg_part p;
    struct svg_numbers n;
    double x, y;
    if (!svg_get(v, "points", &p))
        return 0;
    n = svg_numbers_of(v, p);
    while (svg_number(&n, &x)) {
        if (!svg_number(&n, &y))
            return 0;
        shapes_point(v->s, x, y, 0);
    }
    svg_gap(&n);
    return n.at >= n.end;
}

/* ---- Paths ---------------------------------------------------------------- */

/* A path as it is drawn: where the pen is, where its part began, and the control
   point that a smooth curve mirrors. */
struct svg_pen {
    double x, y, start_x, start_y, mirror_x, mirror_y;
    char last; /* command, in capitals                                  */
};

/* Draws a cubic curve from the pen by its control points, without its
   beginning. */
static void svg_cubic(struct shapes *s, const struct svg_pen *p,
                      const double a[6])
{
    double off = 0;
    for (int k = 1; k <= SVG_CHORDS; k++) {
        const double t = (double)k / SVG_CHORDS, u = 1 - t;
        const double b[4] = {u * u * u, 3 * u * u * t, 3 * u * t * t,
                             t * t * t};
        shapes_point(s, b[0] * p->x + b[1] * a[0] + b[2] * a[2] + b[3] * a[4],
                     b[0] * p->y + b[1] * a[1] + b[2] * a[3] + b[3] * a[5], 0);
    }
    off += shapes_abs(p->x - 2 * a[0] + a[2])
         + shapes_abs(p->y - 2 * a[1] + a[3]);
    off += shapes_abs(a[0] - 2 * a[2] + a[4])
         + shapes_abs(a[1] - 2 * a[3] + a[5]);
    svg_curved(s, 0.75 * off / (SVG_CHORDS * SVG_CHORDS));
}

/* Draws an arc of an ellipse from the pen, on the circle of radius 1 that
   the ellipse is when it is turned and scaled. */
static void svg_arc(struct shapes *s, const struct svg_pen *p, double rx,
                    double ry, double turn, int large, int sweep, double x,
                    double y)
{
    struct shapes_point out[SVG_CHORDS + 1];
    double c, q, half, bulge, scale;
    shapes_turn(turn, &c, &q);
    rx = shapes_abs(rx);
    ry = shapes_abs(ry);
    out[0].x = (c * p->x + q * p->y) / rx;
    out[0].y = (c * p->y - q * p->x) / ry;
    out[SVG_CHORDS].x = (c * x + q * y) / rx;
    out[SVG_CHORDS].y = (c * y - q * x) / ry;
    half = shapes_distance(out[0], out[SVG_CHORDS]) / 2;
    if (rx > 0 && ry > 0 && half > 0 && half < 1e15) {
        scale = half > 1 ? half : 1;
        bulge = SHAPES_SQRT(scale * scale - half * half);
        bulge = (scale + (large ? bulge : -bulge)) / half;
        svg_curved(s, 1.3e-3 * (rx > ry ? rx : ry) * scale);
        bulge = sweep ? bulge : -bulge;
        for (int step = SVG_CHORDS; step > 1; step /= 2) {
            for (int i = 0; i < SVG_CHORDS; i += step)
                out[i + step / 2] = shapes_middle(out[i], out[i + step], bulge);
            bulge /= 1 + SHAPES_SQRT(1 + bulge * bulge);
        }
        for (int i = 1; i < SVG_CHORDS; i++)
            shapes_point(s, c * rx * out[i].x - q * ry * out[i].y,
                         q * rx * out[i].x + c * ry * out[i].y, 0);
    }
    shapes_point(s, x, y, 0);
}

/* Reads the `n` numbers of a command, and makes them absolute; flags count
   as numbers. Returns 0 where they are too few. */
static int svg_arguments(struct svg_numbers *in, char command, int own,
                         const struct svg_pen *p, double *a, int n)
{
    for (int k = 0; k < n; k++) {
        int flag = 0;
        if (command == 'A' && (k == 3 || k == 4)) {
            if (!svg_flag(in, &flag))
                return 0;
            a[k] = flag;
        } else if (!svg_number(in, a + k))
            return 0;
        if (!own || (command == 'A' && k < 5))
            continue;
        if (command == 'V' || (command != 'H' && (k + (command == 'A')) % 2))
            a[k] += p->y;
        else
            a[k] += p->x;
    }
    return 1;
}

/* Draws a curve. */
static void svg_curve(struct shapes *s, struct svg_pen *p, char command,
                      const double *a, int n)
{
    const double x = a[n - 2], y = a[n - 1];
    const int smooth = command == 'S' ? p->last == 'C' || p->last == 'S'
                                      : p->last == 'Q' || p->last == 'T';
    double b[6] = {a[0], a[1], a[n > 2 ? 2 : 0], a[n > 2 ? 3 : 1], x, y};
    if (command == 'S' || command == 'T') {
        b[0] = smooth ? 2 * p->x - p->mirror_x : p->x;
        b[1] = smooth ? 2 * p->y - p->mirror_y : p->y;
        b[2] = a[0];
        b[3] = a[1];
    }
    p->mirror_x = command == 'C' ? b[2] : command == 'S' ? a[0] : b[0];
    p->mirror_y = command == 'C' ? b[3] : command == 'S' ? a[1] : b[1];
    if (command == 'Q' || command == 'T') { /* of two thirds to its point */
        b[0] = p->x + 2.0 / 3 * (p->mirror_x - p->x);
        b[1] = p->y + 2.0 / 3 * (p->mirror_y - p->y);
        b[2] = x + 2.0 / 3 * (p->mirror_x - x);
        b[3] = y + 2.0 / 3 * (p->mirror_y - y);
    }
    svg_cubic(s, p, b);
}

/* Returns how many numbers a command takes, -1 where it is none. */
static int svg_takes(char command)
{
    static const char *const all = "ZHVMLTSQCA";
    static const int takes[] = {0, 1, 1, 2, 2, 2, 4, 4, 6, 7};
    for (int k = 0; all[k]; k++)
        if (all[k] == command)
            return takes[k];
    return -1;
}

/* Draws one command with its numbers. */
static void svg_draw(struct shapes *s, struct svg_pen *p, char command,
                     const double *a, int n)
{
    double x = p->x, y = p->y;
    if (command == 'H')
        x = a[0];
    else if (command == 'V')
        y = a[0];
    else {
        x = a[n - 2];
        y = a[n - 1];
    }
    if (command == 'A')
        svg_arc(s, p, a[0], a[1], a[2], a[3] > 0, a[4] > 0, x, y);
    else if (command == 'C' || command == 'S' || command == 'Q'
             || command == 'T')
        svg_curve(s, p, command, a, n);
    else
        shapes_point(s, x, y, 0);
    p->x = x;
    p->y = y;
    p->last = command;
}

/* Begins a part of a path: at a point (M), or where the last one began (Z). */
static void svg_begin(struct shapes *s, struct svg_pen *p, char command,
                      const double *a)
{
    p->x = command == 'M' ? a[0] : p->start_x;
    p->y = command == 'M' ? a[1] : p->start_y;
    p->start_x = p->x;
    p->start_y = p->y;
    p->last = command;
    if (command == 'M')
        shapes_point(s, p->x, p->y, 0);
}

/* Reads the parts of a path. Returns 0 where something in it cannot be read.
   */
static int svg_parts(struct svg *v, const struct svg_frame *f, int label)
{
    struct shapes *s = v->s;
    struct svg_pen p = {0, 0, 0, 0, 0, 0, 'Z'};
    struct svg_part d;
    struct svg_numbers in;
    int first = s->points, own = 0;
    char command = '\0';
    double a[7];
    if (!svg_get(v, "d", &d))
        return 1;
    in = svg_numbers_of(v, d);
    for (svg_gap(&in); in.at < in.end && !s->lost; svg_gap(&in)) {
        const int letter = shapes_is_letter(in.at, 0);
        int takes;
        if (letter) {
            own = *in.at >= 'a';
            command = (char)(*in.at++ & ~0x20);
        } else if (command == 'M')
            command = 'L'; /* what follows a move is a line */
        takes = svg_takes(command);
        if (takes < 0 || (takes == 0 && !letter)
            || !svg_arguments(&in, command, own, &p, a, takes))
            return 0;
        if (takes == 0 || command == 'M') {
            svg_path_end(v, f, first, takes == 0, label);
            first = s->points;
            svg_begin(s, &p, command, a);
            continue;
        }
        if (s->points == first) /* goes on where a part was closed */
            shapes_point(s, p.x, p.y, 0);
        svg_draw(s, &p, command, a, takes);
    }
    svg_path_end(v, f, first, 0, label);
    return 1;
}

/* ---- The file ------------------------------------------------------------- */

/* Returns what becomes of the element, within one of a state. */
static enum svg_state svg_state_of(const struct svg *v, enum svg_state outer)
{
    if (svg_is_one(v, v->name,
                   " defs symbol clippath mask marker pattern metadata style "
                   "script title desc lineargradient radialgradient filter "))
        return SVG_NO_PART;
    if (outer != SVG_TAKEN)
        return outer;
    if (svg_is_hidden(v))
        return SVG_HIDDEN;
    if (svg_is(v, v->name, "svg") && v->found)
        return SVG_NESTED;
    return svg_is_moved(v) ? SVG_MOVED : SVG_TAKEN;
}

/* Moves behind what begins with "<" but is no element. Returns 0 where an element
   begins or ends there. */
static int svg_pass(struct svg *v)
{
    static const char *const begins[] = {"<!--", "<![CDATA[", "<?", "<!"};
    static const char *const ends[] = {"-->", "]]>", "?>", ">"};
    for (int k = 0; k < 4; k++) {
        const int n = (int)strlen(begins[k]);
        if (v->length - v->at < n
            || memcmp(v->data + v->at, begins[k], (size_t)n) != 0)
            continue;
        svg_skip_to(v, ends[k]);
        return 1;
    }
    return 0;
}

/* Reads the name and the attributes of an element, at its "<". Returns 1 where it
   is closed at once, -1 where the file ends in it. */
static int svg_begins(struct svg *v)
{
    int closed;
    v->start = v->line;
    v->name.at = ++v->at;
    while (v->at < v->length && !svg_blank(v->data[v->at])
           && v->data[v->at] != '>' && v->data[v->at] != '/')
        v->at++;
    v->name.length = v->at - v->name.at;
    v->attributes.at = v->at;
    svg_to_end(v);
    if (v->at >= v->length)
        return -1;
    closed = v->data[v->at - 1] == '/' && v->at > v->attributes.at;
    v->attributes.length = v->at - v->attributes.at - closed;
    v->at++;
    return closed;
}

/* Moves to the "<" of the element with an id. Returns 0 where there is none, or
   it is no part of a picture. */
static int svg_find(struct svg *v, struct svg_part id)
{
    struct svg_part p;
    v->at = 0;
    while (v->at < v->length) {
        const int at = v->at;
        if (v->data[at] != '<') {
            v->at++;
            continue;
        }
        if (svg_pass(v) || svg_begins(v) < 0 || !svg_get(v, "id", &p)
            || p.length != id.length
            || memcmp(v->data + p.at, v->data + id.at, (size_t)id.length) != 0)
            continue;
        v->at = at;
        return svg_state_of(v, SVG_TAKEN) != SVG_NO_PART;
    }
    return 0;
}

static int svg_tag(struct svg *v);

/* Returns 1, and lists an element `use`, where too many draw each other. */
static int svg_exceeds(struct svg *v, int label)
{
    const int deep = v->uses >= SVG_USES;
    if (!deep && *v->work < SVG_WORK)
        return 0;
    shapes_skipped(v->s,
                   deep ? "use in more than 8 others"
                        : "use after the most work that uses may take",
                   label, v->start);
    return 1;
}

/* Draws what an element `use` names, or lists this. */
static int svg_use(struct svg *v, const struct svg_frame *f, int label)
{
    struct svg again = *v;
    struct svg_part p;
    double x, y;
    int bad = 0, drawn = svg_get(v, "href", &p) || svg_get(v, "xlink:href", &p);
    drawn = drawn && p.length > 1 && v->data[p.at] == '#'
         && svg_value(v, "x", &x) && svg_value(v, "y", &y);
    if (drawn && svg_exceeds(v, label))
        return 0;
    if (drawn) {
        p.at++;
        p.length--;
        drawn = svg_find(&again, p);
        *v->work += again.at;
    }
    if (!drawn) {
        shapes_skipped(v->s, "use", label, v->start);
        return 0;
    }
    again.line = v->start; /* of what is listed in it */
    again.uses++;
    again.depth = 1;
    again.frame[0] = *f;
    again.frame[0].label = label;
    svg_apply(again.frame, 1, 0, 0, 1, x, y);

    /* from its "<" to its end */
    do {
        const int from = again.at;
        if (again.data[from] == '<')
            bad = svg_tag(&again);
        else
            again.at++;
        *v->work += 10. * (again.at - from);
    } while (!bad && again.depth > 1 && again.at < again.length
             && !again.s->lost);
    return bad;
}

/* Reads an element that is drawn, or lists it. */
static int svg_shape(struct svg *v, const struct svg_frame *f)
{
    struct shapes *s = v->s;
    const int first = s->points, label = svg_label(v);
    int good;
    if (svg_is_one(v, v->name, " text tspan image foreignobject ")) {
        shapes_listed_as(s,
                         shapes_word(s, v->data + v->name.at, v->name.length),
                         label, v->start);
        return 0;
    }
    if (svg_is(v, v->name, "use"))
        return svg_use(v, f, label);
    if (svg_is(v, v->name, "path"))
        good = svg_parts(v, f, label);
    else {
        const int open = svg_is_one(v, v->name, " line polyline ");
        good = svg_is_one(v, v->name, " polygon polyline ") ? svg_points(v)
                                                            : svg_basic(v);
        if (good)
            svg_path_end(v, f, first, !open, label);
    }
    if (!good) /* parts of a path that were read before stay */
        shapes_skipped(s, "outline that cannot be read", label, v->start);
    return 0;
}

/* Says that a style sheet may hide or move elements. */
static void svg_note_sheet(struct svg *v)
{
    static const char *const key[] = {"display", "visibility", "opacity",
                                      "transform"};
    struct svg sheet = *v;
    struct svg_part p;
    p.at = v->at;
    svg_skip_to(&sheet, "</style");
    p.length = sheet.at - p.at;
    for (int k = 0; k < 4; k++) {
        if (!svg_holds(v, p, key[k]))
            continue;
        shapes_put(&v->s->notes, "looks hidden or moved: the style sheet in "
                                 "line ");
        shapes_put_int(&v->s->notes, v->start);
        shapes_put(&v->s->notes, " has a rule with ");
        shapes_put(&v->s->notes, key[k]);
        shapes_put(&v->s->notes, ", which is not read\n");
    }
}

/* Reads the element whose name was read. `inner`: others may follow in it.
   */
static int svg_element(struct svg *v, int inner)
{
    static const char *const why[] = {"", "invisible element", "",
                                      "element moved by a style",
                                      "element in a nested svg"};
    struct svg_frame f = v->frame[v->depth - 1];
    struct svg_part p;
    const int drawn = svg_is_one(v, v->name,
                                 " path polygon polyline rect circle ellipse "
                                 "line text tspan image use foreignobject ");
    if (svg_transform(v, &f))
        return -1;
    f.state = svg_state_of(v, f.state);
    if (svg_is(v, v->name, "svg") && !v->found)
        svg_size(v);
    v->found |= svg_is(v, v->name, "svg");
    if (drawn && *why[f.state])
        shapes_skipped(v->s, why[f.state], svg_label(v), v->start);
    else if (drawn && f.state == SVG_TAKEN && svg_shape(v, &f))
        return -1;
    if (!inner)
        return 0;
    if (svg_is(v, v->name, "style"))
        svg_note_sheet(v);
    if (v->depth == SVG_DEEP)
        return shapes_fail(v->s, v->start,
                           "more than 100 elements in each "
                           "other");
    if (!drawn && (svg_get(v, "inkscape:label", &p) || svg_get(v, "id", &p))
        && svg_is(v, v->name, "g"))
        f.label = shapes_word(v->s, v->data + p.at, p.length);
    f.name = v->name;
    f.line = v->start;
    v->frame[v->depth++] = f;
    return 0;
}

/* Says that an element is not closed. */
static int svg_unclosed(struct svg *v, int line)
{
    const struct svg_frame *f = v->frame + v->depth - 1;
    const int name = shapes_word(v->s, v->data + f->name.at, f->name.length);
    struct shapes_text *t = shapes_fault(v->s, line);
    shapes_put(t, "the element '");
    shapes_put_shown(t, shapes_at(v->s, name));
    shapes_put(t, "' of line ");
    shapes_put_int(t, f->line);
    shapes_put(t, " is not closed");
    return -1;
}

/* Reads the end of an element, at its "</". */
static int svg_close(struct svg *v)
{
    const struct svg_part open = v->frame[v->depth - 1].name;
    const char *name = v->data + v->at + 2;
    const int line = v->line, left = v->length - v->at - 2;
    svg_skip_to(v, ">");
    if (v->depth == 1)
        return shapes_fail(v->s, line, "the end of no element");
    if (open.length >= left
        || memcmp(name, v->data + open.at, (size_t)open.length) != 0
        || !(svg_blank(name[open.length]) || name[open.length] == '>'))
        return svg_unclosed(v, line);
    v->depth--;
    return 0;
}

/* Reads what begins with "<". */
static int svg_tag(struct svg *v)
{
    int closed;
    if (svg_pass(v))
        return 0;
    if (v->at + 1 < v->length && v->data[v->at + 1] == '/')
        return svg_close(v);
    closed = svg_begins(v);
    return closed < 0
             ? shapes_fail(v->s, v->start, "the file ends in an element")
             : svg_element(v, !closed);
}

/* Reads the shapes of a drawing. Returns 0, or -1 with a message. */
static int svg_read(struct shapes *s, const char *data, int length)
{
    static const struct svg_frame start = {1, 0,  0,      1, 0,
                                           0, -1, {0, 0}, 0, SVG_TAKEN};
    struct svg v;
    double work = 0;
    memset(&v, 0, sizeof v);
    v.work = &work;
    v.s = s;
    v.data = data;
    v.length = length;
    v.line = 1;
    v.depth = 1;
    v.frame[0] = start;
    s->down = 1;
    while (v.at < length && !s->lost) {
        if (data[v.at] != '<') {
            v.line += data[v.at++] == '\n';
            continue;
        }
        if (svg_tag(&v))
            return -1;
    }
    if (v.depth > 1)
        return svg_unclosed(&v, v.line);
    return v.found ? 0 : shapes_fail(s, 0, "there is no element <svg>");
}

#endif /* SVG_H */
