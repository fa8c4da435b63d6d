/* draw.h - pictures of structures as SVG, for the example programs.

   draw_svg() writes one self-contained picture: stones, hatched ground,
   contacts whole and shrunk, loads, live loads and masses, the resultant force
   of each interface, the thrust line, the limiting contact, the collapse
   mechanism with its hinges, a key with scales, a caption. A viewer that plays
   SMIL (browsers do) shows the mechanism moving. The functions above it write
   single shapes and serve other pictures too.

   Lengths on the page are in pixels, y downwards; the model has y upwards, and
   draw_place() goes from one to the other. The same input gives the same file.
   Programs that use this file are linked with -lm.

   SPDX-License-Identifier: MIT */

#ifndef DRAW_H
#define DRAW_H

#include "../../kern.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A program may leave some of these functions unused. */
#if defined(__GNUC__) || defined(__clang__)
#define DRAW_API static __attribute__((unused))
#else
#define DRAW_API static
#endif

struct draw_view; /* from the model to the page, below           */

struct draw_scene {
    const kern_structure *s;
    char *const *names;        /* one a block; NULL: none                     */
    int relative;              /* how `shrink` is meant, as in kern_options   */
    double shrink;             /* shrinkage at which the kerns are shown      */
    const kern_wrench *live;   /* one a block: a load whose factor is asked for;
                                  NULL: none                                  */
    int pushes;                /* the last of the blocks push as needed:
                                  struts, which are no stones                 */
    const kern_vec *mass;      /* where weight acts that is no stone          */
    int masses;                /* how many such places                        */
    const kern_force *force;   /* one a contact point; NULL: none             */
    const char *force_name;    /* which they are; NULL: one admissible set of
                                  forces                                      */
    const kern_motion *motion; /* one a block; NULL: none                     */
    const char *motion_name;   /* what it is; NULL: collapse mechanism        */
    const kern_motion *hinges; /* one a block: a motion whose hinges are
                                  ringed; NULL: none                          */
    double hinged;             /* shrinkage at which that motion turns        */
    int limiting;              /* contact point to point out, -1: none        */
    const kern_real *value;    /* one a block, shown by its colour; NULL: none;
                                  those of fixed blocks are not read          */
    double most;               /* the value with the last colour              */
    const char *value_name;    /* what it is                                  */
    const char *caption;       /* UTF-8, \n starts a line; NULL: none         */
    const char *unit;          /* of lengths; NULL: not known                 */
    const char *force_unit;    /* the same of forces; N is kN from 10 kN on   */
    void (*over)(const struct draw_view *view, const void *data);
    const void *data;      /* draws over the stones; NULL: nothing        */
    const kern_vec *shown; /* places that the picture shows as well     */
    int shows;             /* how many                                  */
};

/* ---- Colours and sizes -------------------------------------------------- */

#define DRAW_INK "#2b2823"   /* text                                        */
#define DRAW_EDGE "#6a6256"  /* outlines of stones                          */
#define DRAW_WHOLE "#a8c6dc" /* contacts, where they are longer than kerns  */
#define DRAW_KERN "#174a73"  /* contacts as they are, or shrunk             */
#define DRAW_FORCE "#a8232d" /* contact forces                              */
#define DRAW_LOAD "#2f6b3a"  /* loads                                       */
#define DRAW_LIVE "#6b3a8c"  /* live loads                                  */
#define DRAW_SOIL "#b89b6a"  /* fill and earth                              */
#define DRAW_PUSH "fill=\"#dfe9d8\" fill-opacity=\"0.8\""
#define DRAW_LIMIT "#f2a900" /* the limiting contact                        */
#define DRAW_GHOST "#b4511a" /* where the stones go                         */
#define DRAW_FONT "Helvetica, Arial, 'Liberation Sans', sans-serif"

#define DRAW_WIDTH 720.0  /* widest page                                 */
#define DRAW_HEIGHT 640.0 /* highest drawing on it                       */
#define DRAW_LEAST 440.0  /* narrowest page, for the key and the caption */
#define DRAW_STONE 120.0  /* largest mean stone                          */
#define DRAW_MASS 3.5     /* radius of a mass                            */
#define DRAW_MASS_STYLE "fill=\"" DRAW_INK "\" fill-opacity=\"0.7\""
#define DRAW_PAD 16.0 /* white border                                */
#define DRAW_TURN 0.2 /* radius of a torque over the mean stone      */
#define DRAW_VALUES 6 /* loads that have their values beside them    */

static const char *const draw_stone[] = {
    "#e9e3d6", "#ddd5c5", "#e3dccf", "#d6cebf", "#e6dccb", "#dad6cc",
};

/* Values from little to much. Dark text can be read on each. */
static const unsigned char draw_ramp[][3] = {
    {196, 78, 60},   {224, 132, 80},  {230, 184, 100}, {200, 196, 124},
    {140, 186, 154}, {100, 162, 174}, {72, 128, 172},
};

/* ---- Numbers ------------------------------------------------------------ */

struct draw_pt {
    double x, y;
};

DRAW_API double draw_hypot(double x, double y) { return sqrt(x * x + y * y); }

DRAW_API struct draw_pt draw_vec(double x, double y)
{
    struct draw_pt p;

    p.x = x;
    p.y = y;
    return p;
}

DRAW_API double draw_clamp(double v, double lo, double hi)
{
    return v < lo ? lo : v > hi ? hi : v;
}

/* Page coordinates are printed to 0.01; adding zero turns -0 into 0. */
DRAW_API double draw_px(double v) { return floor(v * 100 + 0.5) / 100 + 0.0; }

/* The largest of 1, 2, 5 times a power of ten that is not above v. */
DRAW_API double draw_round(double v)
{
    double ten;

    if (!(v > 0))
        return 0;
    ten = pow(10, floor(log10(v) + 1e-9));
    return (v >= 4.999 * ten ? 5 : v >= 1.999 * ten ? 2 : 1) * ten;
}

/* The colour of a share from 0 to 1. */
DRAW_API const char *draw_shade(double share, char out[8])
{
    const int last = (int)(sizeof draw_ramp / sizeof draw_ramp[0]) - 1;
    double at = draw_clamp(share, 0, 1) * last;
    int i = at < last ? (int)at : last - 1, c, part[3];

    for (c = 0; c < 3; c++)
        part[c] = (int)(draw_ramp[i][c]
                        + (at - i) * (draw_ramp[i + 1][c] - draw_ramp[i][c])
                        + 0.5);
    snprintf(out, 8, "#%02x%02x%02x", part[0] & 255, part[1] & 255,
             part[2] & 255);
    return out;
}

/* ---- Text --------------------------------------------------------------- */

static int draw_xml_holds(unsigned long c)
{
    return (c >= 0x20 || c == '\t') && c <= 0x10ffff
        && (c < 0xd800 || c >= 0xe000) && c != 0xfffe && c != 0xffff;
}

/* Reads one character of UTF-8 and says how many bytes it takes; *code is 0
   where there is none that XML may hold. */
DRAW_API int draw_utf8(const char *text, unsigned long *code)
{
    static const unsigned long least[] = {0, 0x80, 0x800, 0x10000};
    const unsigned char *s = (const unsigned char *)text;
    int more = s[0] < 0x80 ? 0 : s[0] >= 0xf0 ? 3 : s[0] >= 0xe0 ? 2 : 1;
    unsigned long c = s[0];
    int i;

    *code = 0;
    if ((c >= 0x80 && c < 0xc2) || c > 0xf4)
        return 1;
    if (more > 0)
        c &= 0x3fUL >> more;
    for (i = 1; i <= more; i++) {
        if ((s[i] & 0xc0) != 0x80)
            return 1;
        c = c << 6 | (s[i] & 0x3fUL);
    }
    if (c >= least[more] && draw_xml_holds(c))
        *code = c;
    return more + 1;
}

/* Width of the first `bytes` of a text: the widths of Helvetica, which Arial
   shares, in thousandths of the size; other letters are taken as wide ones. */
DRAW_API double draw_text_width(const char *text, size_t bytes, double size)
{
    static const short width[] = {
        278, 278, 355, 556, 556,  889, 667, 191, 333, 333, 389, 584, 278, 333,
        278, 278, 556, 556, 556,  556, 556, 556, 556, 556, 556, 556, 278, 278,
        584, 584, 584, 556, 1015, 667, 667, 722, 722, 667, 611, 778, 722, 278,
        500, 667, 556, 833, 722,  778, 667, 778, 722, 667, 611, 722, 667, 944,
        667, 667, 611, 278, 278,  278, 469, 556, 333, 556, 556, 500, 556, 556,
        278, 556, 556, 222, 222,  500, 222, 833, 556, 556, 556, 556, 333, 500,
        278, 556, 500, 722, 500,  500, 500, 334, 260, 334, 584,
    };
    const char *end = text + bytes;
    double sum = 0;
    unsigned long c;

    while (text < end && *text) {
        text += draw_utf8(text, &c);
        sum += c >= 32 && c < 127 ? width[c - 32] : c < 0x2000 ? 600 : 1000;
    }
    return sum * size / 1000;
}

/* Writes the first `bytes` of a text so that XML reads it back. */
DRAW_API void draw_escape(FILE *out, const char *text, size_t bytes)
{
    const char *end = text + bytes;
    unsigned long c;
    int n;

    for (; text < end && *text; text += n) {
        n = draw_utf8(text, &c);
        switch (c) {
        case 0: fputs("?", out); break;
        case '<': fputs("&lt;", out); break;
        case '>': fputs("&gt;", out); break;
        case '&': fputs("&amp;", out); break;
        case '"': fputs("&quot;", out); break;
        default: fwrite(text, 1, (size_t)n, out); break;
        }
    }
}

/* ---- Shapes ------------------------------------------------------------- */

DRAW_API void draw_begin(FILE *out, double width, double height)
{
    fprintf(out,
            "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"%.0f\" "
            "height=\"%.0f\" viewBox=\"0 0 %.0f %.0f\">\n"
            "<rect width=\"100%%\" height=\"100%%\" fill=\"#ffffff\"/>\n",
            width, height, width, height);
}

/* Returns -1 if anything could not be written since draw_begin(). */
DRAW_API int draw_end(FILE *out)
{
    fputs("</svg>\n", out);
    return fflush(out) != 0 || ferror(out) ? -1 : 0;
}

/* What follows, up to draw_close(), has these attributes. */
DRAW_API void draw_open(FILE *out, const char *attributes)
{
    fprintf(out, "<g %s>\n", attributes);
}

DRAW_API void draw_close(FILE *out) { fputs("</g>\n", out); }

DRAW_API void draw_line(FILE *out, struct draw_pt a, struct draw_pt b,
                        const char *attributes)
{
    fprintf(out, "<path d=\"M%.2f %.2fL%.2f %.2f\" %s/>\n", draw_px(a.x),
            draw_px(a.y), draw_px(b.x), draw_px(b.y), attributes);
}

DRAW_API void draw_circle(FILE *out, struct draw_pt at, double radius,
                          const char *attributes)
{
    fprintf(out, "<circle cx=\"%.2f\" cy=\"%.2f\" r=\"%.2f\" %s/>\n",
            draw_px(at.x), draw_px(at.y), radius, attributes);
}

DRAW_API void draw_rect(FILE *out, double x, double y, double w, double h,
                        const char *attributes)
{
    fprintf(out,
            "<rect x=\"%.2f\" y=\"%.2f\" width=\"%.2f\" height=\"%.2f\" "
            "%s/>\n",
            draw_px(x), draw_px(y), draw_px(w), draw_px(h), attributes);
}

/* One line of text; `anchor` is start, middle or end. */
DRAW_API void draw_text(FILE *out, double x, double y, double size,
                        const char *anchor, const char *text, size_t bytes)
{
    fprintf(out,
            "<text x=\"%.2f\" y=\"%.2f\" font-size=\"%.1f\" "
            "text-anchor=\"%s\">",
            draw_px(x), draw_px(y), size, anchor);
    draw_escape(out, text, bytes);
    fputs("</text>\n", out);
}

/* A paragraph, broken at blanks; returns the y of the line after it. With
   `out` NULL it only measures. */
DRAW_API double draw_paragraph(FILE *out, double x, double y, double width,
                               double size, const char *text)
{
    while (*text) {
        size_t fits = 0, i = 0;

        for (;;) {
            while (text[i] && text[i] != ' ' && text[i] != '\n')
                i++;
            if (draw_text_width(text, i, size) > width) {
                unsigned long c;

                if (fits > 0)
                    break;
                do /* a word that is too long */
                    fits += (size_t)draw_utf8(text + fits, &c);
                while (draw_text_width(text, fits + 1, size) <= width);
                break;
            }
            fits = i;
            if (!text[i] || text[i] == '\n')
                break;
            i++;
        }
        if (out)
            draw_text(out, x, y, size, "start", text, fits);
        y += 1.4 * size;
        text += fits;
        if (*text == ' ' || *text == '\n')
            text++;
    }
    return y;
}

/* A triangle of some length that points along (dx, dy), a unit vector. */
DRAW_API void draw_head(FILE *out, struct draw_pt tip, double dx, double dy,
                        double length, const char *colour)
{
    double bx = tip.x - length * dx, by = tip.y - length * dy;
    double half = 0.36 * length;

    fprintf(out, "<path d=\"M%.2f %.2fL%.2f %.2fL%.2f %.2fZ\" fill=\"%s\"/>\n",
            draw_px(tip.x), draw_px(tip.y), draw_px(bx - half * dy),
            draw_px(by + half * dx), draw_px(bx + half * dy),
            draw_px(by - half * dx), colour);
}

/* An arrow whose head is part of its length and grows no larger than it; none
   where it would be a speck. */
DRAW_API void draw_arrow(FILE *out, struct draw_pt a, struct draw_pt b,
                         double width, const char *colour)
{
    double dx = b.x - a.x, dy = b.y - a.y, length = sqrt(dx * dx + dy * dy);
    double head = fmin(3 + 3.2 * width, 0.6 * length);
    char style[100];

    if (!(length > 2.5))
        return;
    dx /= length;
    dy /= length;
    snprintf(style, sizeof style, "stroke=\"%s\" stroke-width=\"%.2f\"", colour,
             fmin(width, 0.4 * head));
    draw_line(out, a, draw_vec(b.x - 0.8 * head * dx, b.y - 0.8 * head * dy),
              style);
    draw_head(out, b, dx, dy, head, colour);
}

/* ---- From the model to the page ----------------------------------------- */

/* The rectangle of the model from `low` to `high` fills the rectangle of the
   page with its upper left corner at (left, top). */
struct draw_view {
    FILE *out;
    struct draw_pt low, high; /* model                                       */
    double left, top;         /* page                                        */
    double scale;             /* page over model                             */
};

DRAW_API struct draw_pt draw_place(const struct draw_view *v, double x,
                                   double y)
{
    struct draw_pt p;

    p.x = v->left + (x - v->low.x) * v->scale;
    p.y = v->top + (v->high.y - y) * v->scale;
    return p;
}

DRAW_API void draw_widen(struct draw_view *v, double x, double y)
{
    v->low.x = fmin(v->low.x, x);
    v->low.y = fmin(v->low.y, y);
    v->high.x = fmax(v->high.x, x);
    v->high.y = fmax(v->high.y, y);
}

/* Where a point of a block is after it has moved with its rates for a time:
   the exact motion at constant speed and spin seen from the block, so that a
   block that hinges turns about its hinge. */
DRAW_API struct draw_pt draw_moved(const kern_block *block,
                                   const kern_motion *rate, double time,
                                   double x, double y)
{
    double turn = rate->spin * time, c = cos(turn), s = sin(turn);
    double even = fabs(turn) < 1e-4 ? 1 - turn * turn / 6 : s / turn;
    double odd = fabs(turn) < 1e-4 ? turn / 2 : (1 - c) / turn;
    double rx = x - block->centre.x, ry = y - block->centre.y;
    double vx = rate->vx * time, vy = rate->vy * time;
    struct draw_pt p;

    p.x = block->centre.x + c * rx - s * ry + even * vx - odd * vy;
    p.y = block->centre.y + s * rx + c * ry + odd * vx + even * vy;
    return p;
}

/* A polygon is cut at a frame a little outside the view (Sutherland and
   Hodgman, one corner at a time): renderers do not like the coordinates of a
   ground that is a million times wider than the stones on it. */
struct draw_cut {
    FILE *out;
    double edge[4]; /* least x, least y, greatest x, greatest y    */
    struct draw_pt first[4], last[4];
    int begun[4];
    int written;
};

static void draw_cut_corner(struct draw_cut *k, int side, struct draw_pt p);

/* How far p is inside one side of the frame. */
static double draw_cut_depth(const struct draw_cut *k, int side,
                             struct draw_pt p)
{
    double at = side % 2 == 0 ? p.x : p.y;

    return side < 2 ? at - k->edge[side] : k->edge[side] - at;
}

static void draw_cut_edge(struct draw_cut *k, int side, struct draw_pt a,
                          struct draw_pt b)
{
    double da = draw_cut_depth(k, side, a), db = draw_cut_depth(k, side, b);
    struct draw_pt p;

    if ((da >= 0) == (db >= 0))
        return;
    p.x = a.x + (b.x - a.x) * (da / (da - db));
    p.y = a.y + (b.y - a.y) * (da / (da - db));
    draw_cut_corner(k, side + 1, p);
}

static void draw_cut_corner(struct draw_cut *k, int side, struct draw_pt p)
{
    if (side == 4) {
        fprintf(k->out, "%s%.2f %.2f", k->written++ ? "L" : "M", draw_px(p.x),
                draw_px(p.y));
        return;
    }
    if (k->begun[side])
        draw_cut_edge(k, side, k->last[side], p);
    else
        k->first[side] = p;
    k->begun[side] = 1;
    k->last[side] = p;
    if (draw_cut_depth(k, side, p) >= 0)
        draw_cut_corner(k, side + 1, p);
}

/* The outline of a block, moved if `rate` is not NULL. */
DRAW_API void draw_block(const struct draw_view *v, const kern_block *block,
                         const kern_motion *rate, double time,
                         const char *attributes)
{
    const double out = 20;
    struct draw_cut k;
    int i;

    if (!block->vertex)
        return;
    memset(&k, 0, sizeof k);
    k.out = v->out;
    k.edge[0] = v->left - out;
    k.edge[1] = v->top - out;
    k.edge[2] = v->left + (v->high.x - v->low.x) * v->scale + out;
    k.edge[3] = v->top + (v->high.y - v->low.y) * v->scale + out;
    fputs("<path d=\"", v->out);
    for (i = 0; i < block->vertices; i++) {
        struct draw_pt p = {block->vertex[i].x, block->vertex[i].y};

        if (rate)
            p = draw_moved(block, rate, time, p.x, p.y);
        draw_cut_corner(&k, 0, draw_place(v, p.x, p.y));
    }
    for (i = 0; i < 4; i++)
        if (k.begun[i])
            draw_cut_edge(&k, i, k.last[i], k.first[i]);
    fprintf(v->out, "%s\" %s/>\n", k.written ? "Z" : "", attributes);
}

/* ---- The parts of the picture ------------------------------------------- */

/* What the parts need to know of each other. */
struct draw_sizes {
    double stone;            /* mean size of the free blocks, model         */
    double weight;           /* mean weight of the free blocks              */
    double force, load[2];   /* model lengths of a unit of a resultant, of
                                  a load, and of a live load                  */
    double time;             /* how long the rates act for the ghosts       */
    double line, bar, arrow; /* widths on the page                          */
};

/* Is c the first end of a line contact? Its other end is c + 1. */
DRAW_API int draw_is_line(const kern_structure *s, int c)
{
    const kern_contact *k = &s->contact[c];

    return k->line && c + 1 < s->contacts && k[1].line && k[1].a == k->a
        && k[1].b == k->b;
}

/* The number of neighbours in the array, from c on, with the same two blocks:
   an interface. 0 where c is not its first. */
DRAW_API int draw_interface(const kern_structure *s, int c)
{
    const kern_contact *k = &s->contact[c];
    int n = 1;

    if (c > 0 && k[-1].a == k->a && k[-1].b == k->b)
        return 0;
    while (c + n < s->contacts && k[n].a == k->a && k[n].b == k->b)
        n++;
    return n;
}

/* The resultant of the forces of the interface that begins with c, on its block
   b, at the place on its line of action nearest to where the contacts press.
   Returns 0 where there is none. */
DRAW_API int draw_resultant(const struct draw_scene *d, int c,
                            struct draw_pt *at, struct draw_pt *force)
{
    const kern_contact *k = &d->s->contact[c];
    const int n = draw_interface(d->s, c);
    double pressed = 0, moment = 0, square;
    int i;

    *at = *force = draw_vec(0, 0);
    for (i = 0; i < n; i++) {
        const double f = d->force[c + i].normal, r = d->force[c + i].tangential;
        const kern_vec p = kern_contact_at(&k[i], (kern_real)d->shrink,
                                           d->relative);
        const double fx = f * k[i].n.x - r * k[i].n.y;
        const double fy = f * k[i].n.y + r * k[i].n.x;

        pressed += f;
        *at = draw_vec(at->x + f * p.x, at->y + f * p.y);
        *force = draw_vec(force->x + fx, force->y + fy);
        moment += p.x * fy - p.y * fx;
    }
    square = force->x * force->x + force->y * force->y;
    if (!(pressed > 0) || !(square > 1e-18 * pressed * pressed))
        return 0;
    *at = draw_vec(at->x / pressed, at->y / pressed);
    moment -= at->x * force->y - at->y * force->x;
    *at = draw_vec(at->x + moment * force->y / square,
                   at->y - moment * force->x / square);
    return 1;
}

/* The resultant as an arrow: it starts where it acts and goes into the block
   which feels it. Of the two blocks that is the one which the force lifts, so
   that arrows read as the way of the load. */
static int draw_force_ends(const struct draw_scene *d, double unit, int c,
                           struct draw_pt *from, struct draw_pt *to)
{
    const kern_contact *k = &d->s->contact[c];
    const kern_vec g = d->s->gravity;
    struct draw_pt f;
    double lift, least;

    if (!draw_resultant(d, c, from, &f))
        return 0;
    lift = -(f.x * g.x + f.y * g.y);
    least = 1e-3 * (fabs(f.x) + fabs(f.y))
          * (fabs((double)g.x) + fabs((double)g.y));
    if (d->s->block[k->b].fixed || (lift < -least && !d->s->block[k->a].fixed))
        unit = -unit;
    *to = draw_vec(from->x + f.x * unit, from->y + f.y * unit);
    return 1;
}

/* The load of block i, or its live load. */
static const kern_wrench *draw_load_of(const struct draw_scene *d, int i,
                                       int live)
{
    static const kern_wrench none = {0, 0, 0};

    if (i >= d->s->blocks - d->pushes)
        return &none;
    return !live ? &d->s->block[i].load : d->live ? &d->live[i] : &none;
}

/* The load of a block as an arrow that pushes on its outline from outside,
   along the line of action which its torque gives; it acts at the centre, and
   the torque is shown apart (returns 2), if that line misses the block. */
static int draw_load_ends(const kern_block *b, const kern_wrench *load,
                          double unit, struct draw_pt *from, struct draw_pt *to)
{
    double fx = load->fx, fy = load->fy, t = load->torque;
    double f = draw_hypot(fx, fy), ux, uy, side, first = 0;
    int i, hits = 0;

    if (b->fixed || !(f + fabs(t) > 0))
        return 0;
    *from = *to = draw_vec(b->centre.x, b->centre.y);
    if (!(f > 0))
        return 2;
    ux = fx / f;
    uy = fy / f;
    side = t / f;
    for (i = 0; i < b->vertices; i++) {
        kern_vec p = b->vertex[i], q = b->vertex[(i + 1) % b->vertices];
        double px = p.x - b->centre.x, py = p.y - b->centre.y;
        double qx = q.x - b->centre.x, qy = q.y - b->centre.y;
        double dp = px * uy - py * ux - side, dq = qx * uy - qy * ux - side;
        double along;

        if ((dp > 0) == (dq > 0))
            continue;
        along = px * ux + py * uy
              + ((qx - px) * ux + (qy - py) * uy) * dp / (dp - dq);
        if (hits++ == 0 || along < first)
            first = along;
    }
    if (hits > 0)
        *to = draw_vec(b->centre.x + first * ux + side * uy,
                       b->centre.y + first * uy - side * ux);
    *from = draw_vec(to->x - fx * unit, to->y - fy * unit);
    return hits > 0 || !(fabs(t) > 0) ? 1 : 2;
}

/* Mean size and weight of the free blocks, units of forces and loads; *v
   becomes what they and the contacts span. */
static void draw_measure_sizes(const struct draw_scene *d, struct draw_view *v,
                               struct draw_sizes *z)
{
    const kern_structure *s = d->s;
    double g = draw_hypot(s->gravity.x, s->gravity.y);
    double longest = 0, heaviest[2] = {0, 0};
    struct draw_pt a, b;
    int i, j, c, free_blocks = 0;

    memset(z, 0, sizeof *z);
    v->low = draw_vec(HUGE_VAL, HUGE_VAL);
    v->high = draw_vec(-HUGE_VAL, -HUGE_VAL);
    for (i = 0; i < s->blocks; i++) {
        const kern_block *k = &s->block[i];

        if (k->fixed)
            continue;
        if (i < s->blocks - d->pushes) {
            free_blocks++;
            z->stone += sqrt(fabs((double)k->area));
            z->weight += k->mass * g;
        }
        for (j = 0; j < 2; j++) {
            const kern_wrench *load = draw_load_of(d, i, j);

            heaviest[j] = fmax(heaviest[j], draw_hypot(load->fx, load->fy));
        }
        draw_widen(v, k->centre.x, k->centre.y);
        for (j = 0; j < k->vertices; j++)
            draw_widen(v, k->vertex[j].x, k->vertex[j].y);
    }
    for (c = 0; c < s->contacts; c++) {
        draw_widen(v, s->contact[c].p.x, s->contact[c].p.y);
        if (d->force && draw_force_ends(d, 1, c, &a, &b))
            longest = fmax(longest, draw_hypot(b.x - a.x, b.y - a.y));
    }
    if (free_blocks > 0) {
        z->stone /= free_blocks;
        z->weight /= free_blocks;
    }
    if (!(v->low.x <= v->high.x))
        v->low = v->high = draw_vec(0, 0);
    if (!(z->stone > 0)) /* blocks without outlines */
        z->stone = 0.2 * fmax(v->high.x - v->low.x, v->high.y - v->low.y);
    if (!(z->stone > 0))
        z->stone = 1;
    if (longest > 0)
        z->force = 0.8 * z->stone / longest;
    for (j = 0; j < 2; j++)
        if (heaviest[j] > 0)
            z->load[j] = 0.8 * z->stone / heaviest[j];
}

/* The time over which motions are drawn: the fastest point moves 0.3 stones. */
static void draw_measure_motion(const struct draw_scene *d,
                                struct draw_sizes *z)
{
    const kern_structure *s = d->s;
    double fastest = 0;
    int i, j;

    for (i = 0; d->motion && i < s->blocks; i++) {
        const kern_block *k = &s->block[i];
        double speed = draw_hypot(d->motion[i].vx, d->motion[i].vy);
        double spin = fabs((double)d->motion[i].spin), reach = 0;

        for (j = 0; j < k->vertices; j++)
            reach = fmax(reach, draw_hypot(k->vertex[j].x - k->centre.x,
                                           k->vertex[j].y - k->centre.y));
        if (!k->fixed && k->vertex) /* others have no outline to move */
            fastest = fmax(fastest, speed + spin * reach);
    }
    if (fastest > 0)
        z->time = 0.3 * z->stone / fastest;
}

/* Widens *v by what is drawn of blocks: ghosts, loads, torques. Returns the
   lowest point of all blocks. */
static double draw_measure_blocks(const struct draw_scene *d,
                                  struct draw_view *v,
                                  const struct draw_sizes *z)
{
    const kern_structure *s = d->s;
    struct draw_view all;
    struct draw_pt a, b;
    int i, j, c;

    all = *v;
    for (i = 0; i < s->blocks; i++) {
        const kern_block *k = &s->block[i];

        for (j = 0; j < k->vertices; j++) {
            draw_widen(&all, k->vertex[j].x, k->vertex[j].y);
            if (k->fixed || !d->motion)
                continue;
            a = draw_moved(k, &d->motion[i], z->time, k->vertex[j].x,
                           k->vertex[j].y);
            draw_widen(v, a.x, a.y);
        }
        for (j = 0; j < 2; j++) {
            c = draw_load_ends(k, draw_load_of(d, i, j), z->load[j], &a, &b);
            if (c > 0) {
                draw_widen(v, a.x, a.y);
                draw_widen(v, b.x, b.y);
            }
            if (c == 2) { /* a torque */
                double r = 1.2 * DRAW_TURN * z->stone;

                draw_widen(v, k->centre.x - r, k->centre.y - r);
                draw_widen(v, k->centre.x + r, k->centre.y + r);
            }
        }
    }
    for (i = 0; i < d->masses; i++)
        draw_widen(v, d->mass[i].x, d->mass[i].y);
    return all.low.y;
}

/* Fixes scales and times, and the part of the model that is shown: the free
   blocks, what they touch, their ghosts and loads, and a margin around. */
static void draw_measure(const struct draw_scene *d, struct draw_view *v,
                         struct draw_sizes *z)
{
    const kern_structure *s = d->s;
    double margin, lowest;
    struct draw_pt a, b;
    int c;

    draw_measure_sizes(d, v, z);
    for (c = 0; c < d->shows; c++)
        draw_widen(v, d->shown[c].x, d->shown[c].y);
    draw_measure_motion(d, z);
    lowest = draw_measure_blocks(d, v, z);
    for (c = 0; d->force && c < s->contacts; c++)
        if (draw_force_ends(d, z->force, c, &a, &b))
            draw_widen(v, b.x, b.y);
    margin = 0.35 * z->stone + 0.02 * (v->high.x - v->low.x);
    v->low.x -= margin;
    v->high.x += margin;
    /* ground below the stones, but not more of it than there is */
    v->low.y = fmin(v->low.y, fmax(v->low.y - margin, lowest));
    v->low.y -= 0.06 * z->stone;
    v->high.y += 0.15 * z->stone;
}

/* Fits the view onto the page, and fills a page that would be too narrow. */
static void draw_fit(struct draw_view *v, struct draw_sizes *z)
{
    double w = v->high.x - v->low.x, h = v->high.y - v->low.y, more, stone;

    v->scale = fmin((DRAW_WIDTH - 2 * DRAW_PAD) / w, DRAW_HEIGHT / h);
    v->scale = fmin(v->scale, DRAW_STONE / z->stone);
    more = (DRAW_LEAST - 2 * DRAW_PAD) / v->scale - w;
    if (more > 0) {
        v->low.x -= more / 2;
        v->high.x += more / 2;
    }
    v->left = v->top = DRAW_PAD;
    stone = z->stone * v->scale;
    z->line = draw_clamp(0.014 * stone, 0.4, 1.1);
    z->bar = draw_clamp(0.055 * stone, 1.3, 4.6);
    z->arrow = draw_clamp(0.026 * stone, 0.6, 1.7);
}

static void draw_blocks(const struct draw_scene *d, const struct draw_view *v,
                        const struct draw_sizes *z)
{
    const int shades = (int)(sizeof draw_stone / sizeof draw_stone[0]);
    const kern_structure *s = d->s;
    char style[160], shade[8];
    int i, c;

    snprintf(style, sizeof style,
             "stroke=\"" DRAW_EDGE "\" stroke-width="
             "\"%.2f\" stroke-linejoin=\"round\"",
             z->line);
    draw_open(v->out, style);
    for (i = 0; i < s->blocks; i++) /* the ground lies behind everything */
        if (s->block[i].fixed)
            draw_block(v, &s->block[i], NULL, 0, "fill=\"url(#ground)\"");
    for (i = 0; i < s->blocks; i++) {
        if (s->block[i].fixed)
            continue;
        if (i >= s->blocks - d->pushes) {
            draw_block(v, &s->block[i], NULL, 0, DRAW_PUSH);
            continue;
        }
        snprintf(style, sizeof style, "fill=\"%s\"",
                 d->value ? draw_shade(
                     d->most > 0 ? (double)d->value[i] / d->most : 0, shade)
                          : draw_stone[(i * 7 + i / 5) % shades]);
        draw_block(v, &s->block[i], NULL, 0, style);
        if (s->block[i].vertex)
            continue;
        for (c = 0; c < s->contacts; c++) { /* no outline: a star */
            const kern_contact *k = &s->contact[c];

            if (k->a == i || k->b == i)
                draw_line(
                    v->out, draw_place(v, k->p.x, k->p.y),
                    draw_place(v, s->block[i].centre.x, s->block[i].centre.y),
                    "");
        }
        draw_circle(v->out,
                    draw_place(v, s->block[i].centre.x, s->block[i].centre.y),
                    1.5 * z->bar, style);
    }
    draw_close(v->out);
}

/* Lets what follows, up to draw_close(), move from rest to where it is drawn,
   again and again: a turn about the point that rests, or a straight way. */
static void draw_open_moving(const struct draw_view *v, const kern_block *block,
                             const kern_motion *rate, double time)
{
    const double turn = rate->spin * time;
    struct draw_pt c = draw_place(v, block->centre.x, block->centre.y);

    fputs("<g><animateTransform attributeName=\"transform\" dur=\"4s\" "
          "keyTimes=\"0;0.15;0.7;0.85;1\" repeatCount=\"indefinite\" ",
          v->out);
    if (fabs(turn) < 1e-4) {
        const double x = -rate->vx * time * v->scale;
        const double y = rate->vy * time * v->scale;

        fprintf(v->out,
                "type=\"translate\" values=\"%.2f %.2f;%.2f %.2f;0 0;"
                "0 0;%.2f %.2f\"/>\n",
                draw_px(x), draw_px(y), draw_px(x), draw_px(y), draw_px(x),
                draw_px(y));
        return;
    }
    c.x -= rate->vy / rate->spin * v->scale;
    c.y -= rate->vx / rate->spin * v->scale;
    fputs("type=\"rotate\" values=\"", v->out);
    {
        const double degrees = turn * 180 / 3.14159265358979323846;
        const double at[5] = {degrees, degrees, 0, 0, degrees};
        int i;

        for (i = 0; i < 5; i++)
            fprintf(v->out, "%s%.4f %.2f %.2f", i ? ";" : "", at[i], c.x, c.y);
    }
    fputs("\"/>\n", v->out);
}

static void draw_ghosts(const struct draw_scene *d, const struct draw_view *v,
                        const struct draw_sizes *z)
{
    char style[200];
    int i, j;

    snprintf(style, sizeof style,
             "fill=\"" DRAW_GHOST "\" fill-opacity="
             "\"0.08\" stroke=\"" DRAW_GHOST "\" stroke-width=\"%.2f\" "
             "stroke-dasharray=\"%.1f %.1f\" stroke-linejoin=\"round\"",
             1.2 * z->line, 4 * z->line + 1, 2.5 * z->line + 1);
    draw_open(v->out, style);
    for (i = 0; i < d->s->blocks; i++) {
        const kern_block *k = &d->s->block[i];
        double way = 0;

        for (j = 0; j < k->vertices; j++) {
            struct draw_pt p = draw_moved(k, &d->motion[i], z->time,
                                          k->vertex[j].x, k->vertex[j].y);

            way = fmax(way,
                       draw_hypot(p.x - k->vertex[j].x, p.y - k->vertex[j].y));
        }
        if (k->fixed || !(way * v->scale > 1)) /* it is seen to rest */
            continue;
        draw_open_moving(v, k, &d->motion[i], z->time);
        draw_block(v, k, &d->motion[i], z->time, "");
        draw_close(v->out);
    }
    draw_close(v->out);
}

/* One contact, from p to q (q = p: a point), as a bar with flat ends or, where
   it is shorter than it is wide, as a dot. */
static void draw_bar(FILE *out, struct draw_pt p, struct draw_pt q,
                     double width, const char *colour)
{
    char style[100];

    if (draw_hypot(q.x - p.x, q.y - p.y) > width) {
        snprintf(style, sizeof style, "stroke=\"%s\" stroke-width=\"%.2f\"",
                 colour, width);
        draw_line(out, p, q, style);
    } else {
        snprintf(style, sizeof style, "fill=\"%s\"", colour);
        draw_circle(out, draw_vec((p.x + q.x) / 2, (p.y + q.y) / 2),
                    0.65 * width, style);
    }
}

static void draw_contacts(const struct draw_scene *d, const struct draw_view *v,
                          const struct draw_sizes *z, double shrink,
                          double width, const char *colour)
{
    const kern_structure *s = d->s;
    int c;

    for (c = 0; c < s->contacts; c++) {
        kern_vec p = kern_contact_at(&s->contact[c], (kern_real)shrink,
                                     d->relative);
        kern_vec q = p;
        double w = width;

        if (draw_is_line(s, c)) {
            c++;
            q = kern_contact_at(&s->contact[c], (kern_real)shrink, d->relative);
        } else {
            w = width + 0.5 * z->bar; /* points are small enough */
        }
        draw_bar(v->out, draw_place(v, p.x, p.y), draw_place(v, q.x, q.y), w,
                 colour);
    }
}

/* The limiting contact: a broad stroke under it, and a ring at its point. */
static void draw_limiting(const struct draw_scene *d, const struct draw_view *v,
                          const struct draw_sizes *z, int ring)
{
    const kern_contact *k = &d->s->contact[d->limiting];
    int c = d->limiting;
    kern_vec p = kern_contact_at(k, (kern_real)d->shrink, d->relative);
    struct draw_pt at = draw_place(v, p.x, p.y);
    char style[140];

    if (ring) {
        snprintf(style, sizeof style,
                 "fill=\"none\" stroke=\"" DRAW_LIMIT "\" "
                 "stroke-width=\"%.2f\"",
                 0.5 * z->bar + 0.5);
        draw_circle(v->out, at, 1.7 * z->bar + 1, style);
        return;
    }
    if (c > 0 && k->line && draw_is_line(d->s, c - 1)
        && (c < 2 || !draw_is_line(d->s, c - 2)))
        c--;
    if (!draw_is_line(d->s, c))
        return;
    k = &d->s->contact[c];
    snprintf(style, sizeof style,
             "stroke=\"" DRAW_LIMIT "\" stroke-width="
             "\"%.2f\" stroke-linecap=\"round\"",
             2.4 * z->bar);
    draw_line(v->out, draw_place(v, k->p.x, k->p.y),
              draw_place(v, k[1].p.x, k[1].p.y), style);
}

static void draw_forces(const struct draw_scene *d, const struct draw_view *v,
                        const struct draw_sizes *z)
{
    struct draw_pt a, b;
    int c;

    for (c = 0; c < d->s->contacts; c++)
        if (draw_force_ends(d, z->force, c, &a, &b))
            draw_arrow(v->out, draw_place(v, a.x, a.y), draw_place(v, b.x, b.y),
                       z->arrow, DRAW_FORCE);
}

/* The thrust line goes through each free block on which two interfaces press,
   from one resultant to the other: writes where, two points a block, and
   returns how many interfaces press on each. NULL: no memory. */
DRAW_API int *draw_thrust_of(const struct draw_scene *d,
                             struct draw_pt (*through)[2])
{
    int *presses = calloc((size_t)d->s->blocks, sizeof *presses), c, side;
    struct draw_pt at, f;

    for (c = 0; presses && c < d->s->contacts; c++) {
        if (!draw_resultant(d, c, &at, &f))
            continue;
        for (side = 0; side < 2; side++) {
            const int i = side ? d->s->contact[c].b : d->s->contact[c].a;

            if (presses[i] < 2)
                through[i][presses[i]] = at;
            presses[i]++;
        }
    }
    return presses;
}

static void draw_thrust_style(const struct draw_sizes *z, char *out,
                              size_t room)
{
    snprintf(out, room,
             "stroke=\"" DRAW_FORCE "\" stroke-width="
             "\"%.2f\" stroke-opacity=\"0.6\" stroke-dasharray=\"%.1f %.1f\"",
             0.8 * z->arrow, 5 * z->arrow, 3 * z->arrow);
}

static void draw_thrust(const struct draw_scene *d, const struct draw_view *v,
                        const struct draw_sizes *z)
{
    const int blocks = d->s->blocks;
    struct draw_pt(*through)[2] = malloc((size_t)blocks * sizeof *through);
    int *presses = through ? draw_thrust_of(d, through) : NULL, i;
    char style[120];

    draw_thrust_style(z, style, sizeof style);
    for (i = 0; presses && i < blocks; i++)
        if (presses[i] == 2 && !d->s->block[i].fixed)
            draw_line(v->out, draw_place(v, through[i][0].x, through[i][0].y),
                      draw_place(v, through[i][1].x, through[i][1].y), style);
    free(presses);
    free(through);
}

/* Do the blocks of a contact turn about it in a motion? */
static int draw_is_hinge(const struct draw_scene *d, int c)
{
    const kern_contact *k = &d->s->contact[c];
    const kern_block *a = &d->s->block[k->a], *b = &d->s->block[k->b];
    const kern_motion *u = &d->hinges[k->a], *w = &d->hinges[k->b];
    const kern_vec p = kern_contact_at(k, (kern_real)d->hinged, d->relative);
    const double spin = w->spin - u->spin,
                 size = sqrt(fabs((double)(b->fixed ? a->area : b->area)));
    const double x = w->vx - w->spin * (p.y - b->centre.y) - u->vx
                   + u->spin * (p.y - a->centre.y);
    const double y = w->vy + w->spin * (p.x - b->centre.x) - u->vy
                   - u->spin * (p.x - a->centre.x);

    return fabs(spin) * size > 1e-3
        && draw_hypot(x, y) < 1e-3 * fabs(spin) * size;
}

static void draw_hinges(const struct draw_scene *d, const struct draw_view *v,
                        const struct draw_sizes *z)
{
    char style[120];
    int c;

    snprintf(style, sizeof style,
             "fill=\"#ffffff\" stroke=\"" DRAW_GHOST "\" "
             "stroke-width=\"%.2f\"",
             0.3 * z->bar + 0.4);
    for (c = 0; c < d->s->contacts; c++)
        if (draw_is_hinge(d, c)) {
            kern_vec p = kern_contact_at(&d->s->contact[c],
                                         (kern_real)d->shrink, d->relative);

            draw_circle(v->out, draw_place(v, p.x, p.y), 0.8 * z->bar + 0.6,
                        style);
        }
}

/* A torque: three quarters of a turn around the centre of mass. */
static void draw_torque(const struct draw_view *v, const struct draw_sizes *z,
                        const kern_block *b, double torque, const char *colour)
{
    struct draw_pt c = draw_place(v, b->centre.x, b->centre.y);
    double r = DRAW_TURN * z->stone * v->scale, k = r * 0.70710678;
    double side = torque > 0 ? 1 : -1; /* of the head; the gap is below */
    double head = fmin(3 + 4 * z->arrow, r);

    fprintf(v->out,
            "<path d=\"M%.2f %.2fA%.2f %.2f 0 1 %d %.2f %.2f\" "
            "fill=\"none\" stroke=\"%s\" stroke-width=\"%.2f\"/>\n",
            draw_px(c.x + side * k), draw_px(c.y + k), r, r, torque > 0 ? 0 : 1,
            draw_px(c.x - side * k), draw_px(c.y + k), colour, 1.3 * z->arrow);
    draw_head(v->out,
              draw_vec(c.x - side * (k - 0.6 * head), c.y + k + 0.55 * head),
              side * 0.80, 0.60, head, colour);
}

/* The size of a load, at the tail of its arrow. */
static void draw_load_value(const struct draw_view *v, const kern_wrench *load,
                            const char *unit, struct draw_pt tail,
                            const char *colour)
{
    const double f = draw_hypot(load->fx, load->fy);
    const int large = unit && strcmp(unit, "N") == 0 && f >= 9999.5;
    char text[64], style[120];

    if (!(f > 0))
        return;
    snprintf(text, sizeof text, "%.4g%s%.20s", large ? f / 1000 : f,
             !unit   ? ""
             : large ? " k"
                     : " ",
             unit ? unit : "");
    snprintf(style, sizeof style, "font-family=\"" DRAW_FONT "\" fill=\"%s\"",
             colour);
    draw_open(v->out, style);
    draw_text(v->out, tail.x + (load->fx > 0 ? -4 : 4), tail.y - 2, 9.5,
              load->fx > 0 ? "end" : "start", text, strlen(text));
    draw_close(v->out);
}

/* How many blocks have a load, or a live load. */
static int draw_loaded(const struct draw_scene *d, int live)
{
    struct draw_pt p;
    int i, loads = 0;

    for (i = 0; i < d->s->blocks; i++)
        loads += draw_load_ends(&d->s->block[i], draw_load_of(d, i, live), 0,
                                &p, &p)
               > 0;
    return loads;
}

static void draw_loads_of(const struct draw_scene *d, const struct draw_view *v,
                          const struct draw_sizes *z, int live)
{
    const char *colour = live ? DRAW_LIVE : DRAW_LOAD;
    const int named = draw_loaded(d, live) <= DRAW_VALUES;
    struct draw_pt a, b;
    int i;

    for (i = 0; i < d->s->blocks; i++) {
        const kern_block *k = &d->s->block[i];
        const kern_wrench *load = draw_load_of(d, i, live);
        int kind = draw_load_ends(k, load, z->load[live], &a, &b);

        if (kind > 0)
            draw_arrow(v->out, draw_place(v, a.x, a.y), draw_place(v, b.x, b.y),
                       1.3 * z->arrow, colour);
        if (kind > 0 && named)
            draw_load_value(v, load, d->force_unit, draw_place(v, a.x, a.y),
                            colour);
        if (kind == 2)
            draw_torque(v, z, k, load->torque, colour);
    }
}

static void draw_loads(const struct draw_scene *d, const struct draw_view *v,
                       const struct draw_sizes *z)
{
    int i;

    draw_loads_of(d, v, z, 0);
    draw_loads_of(d, v, z, 1);
    for (i = 0; i < d->masses; i++)
        draw_circle(v->out, draw_place(v, d->mass[i].x, d->mass[i].y),
                    DRAW_MASS, DRAW_MASS_STYLE);
}

/* ---- Names -------------------------------------------------------------- */

/* Does the segment from p to q reach into the box around c? (Liang, Barsky) */
static int draw_box_hit(struct draw_pt c, double w, double h, struct draw_pt p,
                        struct draw_pt q)
{
    double t[2] = {0, 1}, from[2], way[2], half[2];
    int i, j;

    from[0] = p.x - c.x;
    from[1] = p.y - c.y;
    way[0] = q.x - p.x;
    way[1] = q.y - p.y;
    half[0] = w / 2;
    half[1] = h / 2;
    for (i = 0; i < 2; i++)
        for (j = -1; j <= 1; j += 2) {
            double slope = j * way[i], room = half[i] - j * from[i];

            if (slope > 0)
                t[1] = fmin(t[1], room / slope);
            else if (slope < 0)
                t[0] = fmax(t[0], room / slope);
            else if (room < 0)
                return 0;
        }
    return t[0] <= t[1];
}

static int draw_box_seen(const struct draw_view *v, struct draw_pt c, double w,
                         double h)
{
    return c.x - w / 2 >= v->left && c.y - h / 2 >= v->top
        && c.x + w / 2 <= v->left + (v->high.x - v->low.x) * v->scale
        && c.y + h / 2 <= v->top + (v->high.y - v->low.y) * v->scale;
}

/* Does the box lie inside the block, clear of its outline? */
static int draw_box_inside(const struct draw_view *v, const kern_block *b,
                           struct draw_pt c, double w, double h)
{
    int i, inside = 0;

    for (i = 0; i < b->vertices; i++) {
        kern_vec e = b->vertex[i], f = b->vertex[(i + 1) % b->vertices];
        struct draw_pt p = draw_place(v, e.x, e.y);
        struct draw_pt q = draw_place(v, f.x, f.y);

        if (draw_box_hit(c, w + 2, h + 2, p, q))
            return 0;
        if ((p.y > c.y) != (q.y > c.y)
            && c.x < p.x + (q.x - p.x) * (c.y - p.y) / (q.y - p.y))
            inside = !inside;
    }
    return inside;
}

/* Is the box clear of contact i, where it is one of the block, and of the arrow
   of its force? */
static int draw_box_clear(const struct draw_scene *d, const struct draw_view *v,
                          const struct draw_sizes *z, int block, int i,
                          struct draw_pt c, double w, double h)
{
    const kern_contact *k = &d->s->contact[i];
    struct draw_pt p = draw_place(v, k->p.x, k->p.y), q = p, from, to;

    if (k->a == block || k->b == block) {
        if (draw_is_line(d->s, i))
            q = draw_place(v, k[1].p.x, k[1].p.y);
        if (draw_box_hit(c, w + 2 * z->bar, h + 2 * z->bar, p, q))
            return 0;
    } else if (draw_hypot(p.x - c.x, p.y - c.y) > w + z->stone * v->scale) {
        return 1; /* no arrow comes from so far */
    }
    return !d->force || !draw_force_ends(d, z->force, i, &from, &to)
        || !draw_box_hit(c, w + 3 * z->arrow, h + 2 * z->arrow,
                         draw_place(v, from.x, from.y),
                         draw_place(v, to.x, to.y));
}

/* Is there room for a box around c: inside the block and inside the view, and
   clear of the block's outline and contacts, and of arrows? */
static int draw_box_free(const struct draw_scene *d, const struct draw_view *v,
                         const struct draw_sizes *z, int block,
                         struct draw_pt c, double w, double h)
{
    const kern_block *b = &d->s->block[block];
    const double r = DRAW_TURN * z->stone * v->scale;
    struct draw_pt p, from, to;
    int i, live;

    if (!draw_box_seen(v, c, w, h) || !draw_box_inside(v, b, c, w, h))
        return 0;
    for (i = 0; i < d->s->contacts; i++)
        if (!draw_box_clear(d, v, z, block, i, c, w, h))
            return 0;
    p = draw_place(v, b->centre.x, b->centre.y);
    for (live = 0; live < 2; live++) {
        i = draw_load_ends(b, draw_load_of(d, block, live), z->load[live],
                           &from, &to);
        if (i > 0
            && draw_box_hit(c, w + 2, h + 2, draw_place(v, from.x, from.y),
                            draw_place(v, to.x, to.y)))
            return 0;
        if (i == 2 && draw_box_hit(c, w + 3 * r, h + 3 * r, p, p))
            return 0;
    }
    return 1;
}

/* The place for a name nearest to the block's middle, on a raster. */
static int draw_name_place(const struct draw_scene *d,
                           const struct draw_view *v,
                           const struct draw_sizes *z, int block, double w,
                           double h, struct draw_pt *at)
{
    enum { RASTER = 24, MANY = 200 };
    const kern_block *b = &d->s->block[block];
    struct draw_view box = *v;
    struct draw_pt c = draw_place(v, b->centre.x, b->centre.y), p;
    double best = HUGE_VAL, dist;
    int i, j, fits = 0;

    if (b->vertices < 3)
        return 0;
    *at = c;
    if (!b->fixed && draw_box_free(d, v, z, block, c, w, h))
        return 1;
    if (b->vertices > MANY)
        return 0;
    box.low = draw_vec(HUGE_VAL, HUGE_VAL);
    box.high = draw_vec(-HUGE_VAL, -HUGE_VAL);
    for (i = 0; i < b->vertices; i++)
        draw_widen(&box, fmax(v->low.x, fmin(v->high.x, b->vertex[i].x)),
                   fmax(v->low.y, fmin(v->high.y, b->vertex[i].y)));
    if (b->fixed) /* in the middle of what is seen of it */
        c = draw_place(v, (box.low.x + box.high.x) / 2,
                       (box.low.y + box.high.y) / 2);
    for (i = 1; i < RASTER; i++)
        for (j = 1; j < RASTER; j++) {
            p = draw_place(v, box.low.x + (box.high.x - box.low.x) * i / RASTER,
                           box.low.y + (box.high.y - box.low.y) * j / RASTER);
            dist = draw_hypot(p.x - c.x, 2 * (p.y - c.y));
            if (dist < best && draw_box_free(d, v, z, block, p, w, h)) {
                best = dist;
                fits = 1;
                *at = p;
            }
        }
    return fits;
}

/* Names in one size: the largest at which all fit, else that at which most
   do. */
static void draw_names(const struct draw_scene *d, const struct draw_view *v,
                       const struct draw_sizes *z)
{
    static const double sizes[] = {11, 9.5, 8, 7, 6};
    const int choices = (int)(sizeof sizes / sizeof sizes[0]);
    double size = 0, w;
    int i, j, count, most = 0, blocks = d->s->blocks - d->pushes;
    struct draw_pt p;

    for (j = 0; j < choices && most < blocks; j++) {
        if (sizes[j] > 0.26 * z->stone * v->scale)
            continue;
        for (count = i = 0; i < blocks; i++) {
            w = 1.1
              * draw_text_width(d->names[i], strlen(d->names[i]), sizes[j]);
            count += draw_name_place(d, v, z, i, w, 0.9 * sizes[j], &p);
        }
        if (count > most) {
            most = count;
            size = sizes[j];
        }
    }
    if (most == 0)
        return;
    draw_open(v->out, d->value ? "fill=\"" DRAW_INK "\"" : "fill=\"#5b5347\"");
    for (i = 0; i < blocks; i++) {
        w = 1.1 * draw_text_width(d->names[i], strlen(d->names[i]), size);
        if (!draw_name_place(d, v, z, i, w, 0.9 * size, &p))
            continue;
        if (d->s->block[i].fixed) /* a plate on the hatching */
            draw_rect(v->out, p.x - w / 2 - 3, p.y - 0.6 * size, w + 6,
                      1.2 * size, "fill=\"#f4f2ee\" rx=\"2\"");
        draw_text(v->out, p.x, p.y + 0.34 * size, size, "middle", d->names[i],
                  strlen(d->names[i]));
    }
    draw_close(v->out);
}

/* ---- The key ------------------------------------------------------------ */

/* Entries stand in rows; each is a sign of some width and a text. With `out`
   NULL the key is only measured. */
struct draw_key {
    FILE *out;
    double x, y, right;
};

/* Makes room for an entry, writes its text, returns where its sign begins. */
static struct draw_pt draw_key_entry(struct draw_key *key, double sign,
                                     const char *text)
{
    const double size = 10.5;
    double w = sign + 6 + 1.1 * draw_text_width(text, strlen(text), size);
    struct draw_pt p; /* a tenth more: fonts differ */

    if (key->x > DRAW_PAD && key->x + w > key->right) {
        key->x = DRAW_PAD;
        key->y += 18;
    }
    p = draw_vec(key->x, key->y);
    if (key->out)
        draw_text(key->out, p.x + sign + 6, p.y + 3.8, size, "start", text,
                  strlen(text));
    key->x += w + 28;
    return p;
}

static void draw_key_scale(struct draw_key *key, const struct draw_view *v,
                           const char *unit)
{
    double length = draw_round(90 / v->scale), w = length * v->scale;
    struct draw_pt p;
    char text[60];

    snprintf(text, sizeof text, "length %g%s%.20s", length, unit ? " " : "",
             unit ? unit : "");
    p = draw_key_entry(key, w, text);
    if (key->out)
        fprintf(key->out,
                "<path d=\"M%.2f %.2fv7m0 -3.5h%.2fm0 -3.5v7\" fill="
                "\"none\" stroke=\"" DRAW_INK "\" stroke-width=\"1.2\"/>\n",
                draw_px(p.x), draw_px(p.y - 3.5), draw_px(w));
}

/* An arrow of forces that have this model length of a unit. */
static void draw_key_force(struct draw_key *key, const struct draw_view *v,
                           const struct draw_sizes *z, double length,
                           const char *what, const char *colour)
{
    double unit = z->weight > 0 ? z->weight : 1;
    double pixels = unit * length * v->scale;
    double count = draw_round(48 / pixels), w = count * pixels;
    struct draw_pt p;
    char text[160];

    snprintf(text, sizeof text, "%.100s: %g%s", what, count,
             z->weight > 0 ? " \xc3\x97 mean weight" : "");
    p = draw_key_entry(key, w, text);
    if (key->out)
        draw_arrow(key->out, p, draw_vec(p.x + w, p.y), z->arrow, colour);
}

static void draw_key_thrust(struct draw_key *key, const struct draw_sizes *z)
{
    struct draw_pt p = draw_key_entry(key, 26, "thrust line");
    char style[120];

    draw_thrust_style(z, style, sizeof style);
    if (key->out)
        draw_line(key->out, p, draw_vec(p.x + 26, p.y), style);
}

static void draw_key_bar(struct draw_key *key, const char *colour,
                         const char *text)
{
    struct draw_pt p = draw_key_entry(key, 22, text);

    if (key->out)
        draw_bar(key->out, p, draw_vec(p.x + 22, p.y), 4.6, colour);
}

/* The colours of values, from 0 to the most. */
DRAW_API void draw_colours(FILE *out, double x, double y, double width,
                           double height)
{
    const int steps = 48;
    char style[40], shade[8];
    int i;

    for (i = 0; i < steps; i++) {
        snprintf(style, sizeof style, "fill=\"%s\"",
                 draw_shade((i + 0.5) / steps, shade));
        /* a little wider, so that no seams show */
        draw_rect(out, x + width * i / steps, y,
                  width / steps + (i + 1 < steps ? 0.4 : 0), height, style);
    }
    draw_rect(out, x, y, width, height,
              "fill=\"none\" stroke=\"" DRAW_EDGE "\" stroke-width=\"0.6\"");
}

static void draw_key_values(struct draw_key *key, const struct draw_scene *d)
{
    const double zero = 12, w = 110;
    char text[120];
    struct draw_pt p;

    snprintf(text, sizeof text, "%.3g: %s", d->most, d->value_name);
    p = draw_key_entry(key, zero + w, text);
    if (!key->out)
        return;
    draw_text(key->out, p.x, p.y + 3.8, 10.5, "start", "0", 1);
    draw_colours(key->out, p.x + zero, p.y - 5, w, 10);
}

static void draw_key_contacts(struct draw_key *key, const struct draw_scene *d)
{
    int shrunk = d->shrink > 0 || d->shrink < 0;
    char text[80];

    snprintf(text, sizeof text, d->relative ? "%s by %.3g %%" : "%s by %.3g",
             d->shrink > 0 ? "shrunk" : "grown",
             (d->relative ? 100 : 1) * fabs(d->shrink));
    if (shrunk)
        draw_key_bar(key, DRAW_WHOLE, d->shrink > 0 ? "contact" : text);
    draw_key_bar(key, DRAW_KERN, d->shrink > 0 ? text : "contact");
}

static void draw_key_circle(struct draw_key *key, double r, const char *style,
                            const char *text)
{
    struct draw_pt p = draw_key_entry(key, 12, text);

    if (key->out)
        draw_circle(key->out, draw_vec(p.x + 6, p.y), r, style);
}

static void draw_key_loads(struct draw_key *key, const struct draw_scene *d,
                           const struct draw_view *v,
                           const struct draw_sizes *z, int live)
{
    const char *colour = live ? DRAW_LIVE : DRAW_LOAD;
    struct draw_pt p;

    if (draw_loaded(d, live) == 0)
        return;
    if (z->load[live] > 0) {
        draw_key_force(key, v, z, z->load[live], live ? "live load" : "load",
                       colour);
        return;
    }
    p = draw_key_entry(key, 22, live ? "live torque" : "torque");
    if (key->out)
        draw_arrow(key->out, p, draw_vec(p.x + 22, p.y), 1.3 * z->arrow,
                   colour);
}

static void draw_key_motion(struct draw_key *key, const struct draw_scene *d)
{
    struct draw_pt p = draw_key_entry(
        key, 22, d->motion_name ? d->motion_name : "collapse mechanism");

    if (key->out)
        draw_rect(key->out, p.x, p.y - 5, 22, 10,
                  "fill=\"" DRAW_GHOST "\" "
                  "fill-opacity=\"0.08\" stroke=\"" DRAW_GHOST "\" "
                  "stroke-dasharray=\"4 2.5\"");
}

/* Returns the y below the key. */
static double draw_key_all(FILE *out, const struct draw_scene *d,
                           const struct draw_view *v,
                           const struct draw_sizes *z, double width, double y)
{
    struct draw_key key;
    char text[100];

    key.out = out;
    key.x = DRAW_PAD;
    key.y = y + 6;
    key.right = width - DRAW_PAD;
    draw_key_scale(&key, v, d->unit);
    if (d->s->contacts > 0)
        draw_key_contacts(&key, d);
    if (d->limiting >= 0)
        draw_key_circle(&key, 5,
                        "fill=\"none\" stroke=\"" DRAW_LIMIT "\" "
                        "stroke-width=\"2.4\"",
                        "critical contact");
    if (d->hinges)
        draw_key_circle(&key, 4,
                        "fill=\"#ffffff\" stroke=\"" DRAW_GHOST "\" "
                        "stroke-width=\"1.8\"",
                        "hinge of the mechanism");
    if (d->force && z->force > 0) {
        snprintf(text, sizeof text, "resultant, %.80s",
                 d->force_name ? d->force_name
                               : "one admissible set of forces");
        draw_key_force(&key, v, z, z->force, text, DRAW_FORCE);
        draw_key_thrust(&key, z);
    }
    draw_key_loads(&key, d, v, z, 0);
    draw_key_loads(&key, d, v, z, 1);
    if (d->masses > 0)
        draw_key_circle(&key, DRAW_MASS, DRAW_MASS_STYLE, "mass");
    if (z->time > 0)
        draw_key_motion(&key, d);
    if (d->value)
        draw_key_values(&key, d);
    return key.y + 14;
}

/* ---- The picture -------------------------------------------------------- */

/* Returns 0, or -1 if the file could not be written. */
DRAW_API int draw_svg(FILE *out, const struct draw_scene *scene)
{
    struct draw_view v;
    struct draw_sizes z;
    double width, height, key, caption, size = 12.5;
    double w, h;

    v.out = out;
    draw_measure(scene, &v, &z);
    draw_fit(&v, &z);
    w = (v.high.x - v.low.x) * v.scale;
    h = (v.high.y - v.low.y) * v.scale;
    width = ceil(w + 2 * DRAW_PAD);
    key = v.top + h + 14;
    caption = draw_key_all(NULL, scene, &v, &z, width, key) + 13;
    height = caption;
    if (scene->caption)
        height = draw_paragraph(NULL, DRAW_PAD, caption, width - 2 * DRAW_PAD,
                                size, scene->caption);

    draw_begin(out, width, ceil(height));
    fprintf(out,
            "<defs>\n<clipPath id=\"view\"><rect x=\"%.2f\" y=\"%.2f\" "
            "width=\"%.2f\" height=\"%.2f\"/></clipPath>\n"
            "<pattern id=\"ground\" width=\"7\" height=\"7\" patternUnits="
            "\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
            "<rect width=\"7\" height=\"7\" fill=\"#f4f2ee\"/>"
            "<path d=\"M3.5 0V7\" stroke=\"#a59d90\" stroke-width=\"0.9\"/>"
            "</pattern>\n</defs>\n",
            v.left, v.top, draw_px(w), draw_px(h));
    draw_open(out, "clip-path=\"url(#view)\"");
    draw_blocks(scene, &v, &z);
    if (scene->limiting >= 0)
        draw_limiting(scene, &v, &z, 0);
    if (scene->shrink > 0 || scene->shrink < 0) /* the longer one first */
        draw_contacts(scene, &v, &z, fmin(scene->shrink, 0), z.bar, DRAW_WHOLE);
    draw_contacts(scene, &v, &z, fmax(scene->shrink, 0), 0.7 * z.bar,
                  DRAW_KERN);
    if (scene->motion && z.time > 0)
        draw_ghosts(scene, &v, &z);
    if (scene->limiting >= 0)
        draw_limiting(scene, &v, &z, 1);
    if (scene->hinges)
        draw_hinges(scene, &v, &z);
    if (scene->force && z.force > 0) {
        draw_thrust(scene, &v, &z);
        draw_forces(scene, &v, &z);
    }
    draw_loads(scene, &v, &z);
    if (scene->over)
        scene->over(&v, scene->data);
    draw_close(out);
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    if (scene->names)
        draw_names(scene, &v, &z);
    draw_key_all(out, scene, &v, &z, width, key);
    if (scene->caption)
        draw_paragraph(out, DRAW_PAD, caption, width - 2 * DRAW_PAD, size,
                       scene->caption);
    draw_close(out);
    return draw_end(out);
}

/* The same to a file. Nonzero: it cannot be written, and errno says why. */
DRAW_API int draw_file(const char *path, const struct draw_scene *scene)
{
    FILE *out = fopen(path, "w");
    int bad;

    if (!out)
        return -1;
    bad = draw_svg(out, scene);
    return fclose(out) | bad;
}

#endif /* DRAW_H */
