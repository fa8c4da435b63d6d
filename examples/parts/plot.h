/* plot.h - scatter plots and curves as SVG, for the example programs.

   plot_open() opens the file, plot_begin() writes axes with round numbers,
   plot_point(), plot_curve() and plot_band() what is in them, plot_colours() a
   colour bar beside them, plot_end() the rest.

   SPDX-License-Identifier: MIT */

#ifndef PLOT_H
#define PLOT_H

#include "draw.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

struct plot {
    FILE *out;
    double x0, x1, y0, y1; /* what the axes span                     */
    double left, top, width, height; /* of the field between them, pixels */
};

/* Opens FOLDER/NAME for writing; says on stderr where it cannot. */
DRAW_API FILE *plot_open(const char *folder, const char *name)
{
    char path[4096];
    FILE *out;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    out = fopen(path, "w");
    if (!out)
        fprintf(stderr, "cannot write %s\n", path);
    return out;
}

static const double plot_width = 380, plot_height = 270;

/* Wider limits, at round numbers; returns the step between those. */
static double plot_round(double *low, double *high)
{
    double step = draw_round((*high - *low) / 3.5);
    if (!(step > 0))
        step = 1;
    *low = floor(*low / step + 1e-9) * step;
    *high = ceil(*high / step - 1e-9) * step;
    return step;
}

static struct draw_pt plot_place(const struct plot *p, double x, double y)
{
    return draw_vec(p->left + (x - p->x0) / (p->x1 - p->x0) * p->width,
                    p->top + (p->y1 - y) / (p->y1 - p->y0) * p->height);
}

static void plot_text(const struct plot *p, double x, double y, double size,
                      const char *anchor, const char *text)
{
    draw_text(p->out, x, y, size, anchor, text, strlen(text));
}

static void plot_axes(const struct plot *p, double xstep, double ystep)
{
    char text[40];
    draw_open(p->out, "stroke=\"#d8d4cc\" stroke-width=\"0.7\"");
    for (double x = p->x0; x < p->x1 + xstep / 2; x += xstep)
        draw_line(p->out, plot_place(p, x, p->y0), plot_place(p, x, p->y1), "");
    for (double y = p->y0; y < p->y1 + ystep / 2; y += ystep)
        draw_line(p->out, plot_place(p, p->x0, y), plot_place(p, p->x1, y), "");
    draw_close(p->out);
    for (double x = p->x0; x < p->x1 + xstep / 2; x += xstep) {
        snprintf(text, sizeof text, "%.4g", fabs(x) < xstep / 1e6 ? 0 : x);
        plot_text(p, plot_place(p, x, p->y0).x, p->top + p->height + 15, 10.5,
                  "middle", text);
    }
    for (double y = p->y0; y < p->y1 + ystep / 2; y += ystep) {
        snprintf(text, sizeof text, "%.4g", fabs(y) < ystep / 1e6 ? 0 : y);
        plot_text(p, p->left - 7, plot_place(p, p->x0, y).y + 3.6, 10.5, "end",
                  text);
    }
}

/* The limits of p are widened to round numbers. `extra` is the room at the
   right, `title` may be of two lines. */
DRAW_API void plot_begin(struct plot *p, FILE *out, const char *title,
                         const char *xname, const char *yname, double extra)
{
    double xstep = plot_round(&p->x0, &p->x1);
    double ystep = plot_round(&p->y0, &p->y1);
    p->out = out;
    p->left = 62;
    p->top = 34;
    p->width = plot_width;
    p->height = plot_height;
    draw_begin(out, p->left + p->width + 24 + extra, p->top + p->height + 48);
    fprintf(out,
            "<clipPath id=\"field\"><rect x=\"%.1f\" y=\"%.1f\" width="
            "\"%.1f\" height=\"%.1f\"/></clipPath>\n",
            p->left, p->top, p->width, p->height);
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    plot_axes(p, xstep, ystep);
    plot_text(p, p->left, 20, 12.5, "start", title);
    plot_text(p, p->left + p->width / 2, p->top + p->height + 35, 11.5,
              "middle", xname);
    fprintf(out, "<g transform=\"rotate(-90 16 %.1f)\">",
            p->top + p->height / 2);
    plot_text(p, 16, p->top + p->height / 2, 11.5, "middle", yname);
    draw_close(out);
}

DRAW_API void plot_point(const struct plot *p, double x, double y,
                         const char *colour)
{
    char style[120];
    snprintf(style, sizeof style,
             "fill=\"%s\" fill-opacity=\"0.75\" stroke="
             "\"" DRAW_EDGE "\" stroke-width=\"0.5\"",
             colour);
    draw_circle(p->out, plot_place(p, x, y), 3, style);
}

/* A curve through n places; what is above the field is cut off. */
DRAW_API void plot_curve(const struct plot *p, const double *x, const double *y,
                         int n, const char *colour, double width)
{
    fprintf(p->out,
            "<polyline clip-path=\"url(#field)\" fill=\"none\" stroke="
            "\"%s\" stroke-width=\"%.2f\" stroke-linejoin=\"round\" points=\"",
            colour, width);
    for (int i = 0; i < n; i++) {
        struct draw_pt q = plot_place(p, x[i], y[i]);
        fprintf(p->out, "%s%.2f,%.2f", i ? " " : "", draw_px(q.x),
                draw_px(q.y));
    }
    fputs("\"/>\n", p->out);
}

/* The band between two curves through n places, within the field. */
DRAW_API void plot_band(const struct plot *p, const double *x,
                        const double *low, const double *high, int n,
                        const char *colour)
{
    fprintf(p->out,
            "<polygon clip-path=\"url(#field)\" stroke=\"none\" "
            "fill=\"%s\" fill-opacity=\"0.3\" points=\"",
            colour);
    for (int i = 0; i < 2 * n; i++) {
        const int k = i < n ? i : 2 * n - 1 - i;
        struct draw_pt q = plot_place(p, x[k], i < n ? low[k] : high[k]);
        fprintf(p->out, "%s%.2f,%.2f", i ? " " : "", draw_px(q.x),
                draw_px(q.y));
    }
    fputs("\"/>\n", p->out);
}

/* A bar with the colours of values from `low` to `high`, at the right. */
DRAW_API void plot_colours(const struct plot *p, double low, double high,
                           const char *name)
{
    const double x = p->left + p->width + 22, w = 14;
    char text[40];
    fprintf(p->out, "<g transform=\"translate(%.1f %.1f) rotate(-90)\">", x,
            p->top + p->height);
    draw_colours(p->out, 0, 0, p->height, w);
    draw_close(p->out);
    snprintf(text, sizeof text, "%.3g", low);
    plot_text(p, x + w + 6, p->top + p->height, 10.5, "start", text);
    snprintf(text, sizeof text, "%.3g", high);
    plot_text(p, x + w + 6, p->top + 9, 10.5, "start", text);
    fprintf(p->out, "<g transform=\"rotate(-90 %.1f %.1f)\">", x + w + 16,
            p->top + p->height / 2);
    plot_text(p, x + w + 16, p->top + p->height / 2, 11.5, "middle", name);
    draw_close(p->out);
}

DRAW_API int plot_end(const struct plot *p)
{
    draw_close(p->out);
    return draw_end(p->out);
}

#endif /* PLOT_H */
