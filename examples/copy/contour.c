/* From a camera's outline of a stone to its margin.

       cc -O2 -o contour examples/copy/contour.c -lm

   A camera gives thousands of points on a grid of pixels. Three steps make a
   stone of them:
     simplify  kern_outline_simplify() leaves out points as long as none is
               farther than a tolerance from the polygon that remains
     init      kern_block_init() measures area and centre whichever way the
               points run; the mass is density x area x thickness
     tell      kern_measured_options() is told how exact the outline is: the
               pixel and the tolerance together
   The tables show what simplifying does to the margin of a rounded stone on
   flat ground, and that the number of vertices hardly matters if the error is
   told. */

#include <math.h>
#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { POINTS = 10000, CONTACTS = 4000, BLOCKS = 2 };
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS),
    INTS = KERN_INTS(BLOCKS, CONTACTS)
}; /* of work memory */

static const kern_vec ground[] = {{-3, -4}, {3, -4}, {3, -1}, {-3, -1}};
static const double pixel = 0.002, thickness = 0.3, density = 2400;

static kern_vec outline[POINTS], simple[POINTS];
static int kept[POINTS];
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_real reals[REALS];
static int ints[INTS];

/* ---- the stone ---- */

/* A rounded stone some 2 m wide, of n points; with a pixel on its grid. */
static void look(int n, double grid)
{
    for (int i = 0; i < n; i++) {
        double a = 6.283185307179586 * (i + 0.5) / n;
        double c = cos(a), s = sin(a);
        double r = pow(c * c * c * c + s * s * s * s, -0.25);
        outline[i].x = r * c;
        outline[i].y = r * s;
        if (grid > 0) {
            outline[i].x = floor(outline[i].x / grid + 0.5) * grid;
            outline[i].y = floor(outline[i].y / grid + 0.5) * grid;
        }
    }
}

/* Prints what the stone of these vertices is worth, told an error of e. */
static void row(const char *what, const kern_vec *vertex, int n, double e)
{
    kern_work work = kern_work_of(reals, REALS, ints, INTS);
    kern_task task = kern_task_of(block, BLOCKS, contact, 0, &work);
    kern_margin m = {0, 0, 0, 0, 0, 0, 0};
    kern_interval within;
    kern_status status = kern_ground_init(&block[0], ground, 4, NULL);
    if (status == KERN_OK)
        status = kern_block_init(&block[1], vertex, n, density * thickness,
                                 NULL);
    printf("%-16s %8d", what, n);
    if (status == KERN_OK) {
        double size = kern_mean_size(block, BLOCKS);
        if (e > 0)
            task.options = kern_measured_options(&task.options, e, e / size);
        task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                        CONTACTS, &work);
        status = kern_measure(&task, &m, NULL);
    }
    if (status == KERN_STANDS)
        printf(
            " %8.1f %9.4f %9.4f%s\n", block[1].mass, e, m.margin,
            e > 0
                    && kern_certain(&task, m.margin, &within, contact, CONTACTS)
                           == KERN_STANDS
                ? "  certain"
                : "");
    else
        printf("   %s\n", kern_status_text(status));
}

int main(void)
{
    static const double tolerance[] = {0.003, 0.006, 0.012, 0.024, 0.048};
    static const int vertices[] = {40, 200, 1000};
    char what[40];
    look(POINTS, pixel);
    printf("%-16s %8s %8s %9s %9s\n", "outline", "vertices", "mass", "error",
           "margin");
    row("as it comes", outline, POINTS, pixel);
    for (int k = 0; k < 5; k++) {
        int n = kern_outline_simplify(outline, POINTS, tolerance[k], simple,
                                      kept, POINTS);
        snprintf(what, sizeof what, "within %.3f m", tolerance[k]);
        row(what, simple, n, hypot(pixel, tolerance[k]));
    }
    printf("\nexact outlines, untold and told an error of 0.02 m\n");
    for (int told = 0; told < 2; told++)
        for (int k = 0; k < 3; k++) {
            look(vertices[k], 0);
            row(told ? "told" : "untold", outline, vertices[k],
                told ? 0.02 : 0);
        }
    return 0;
}

/* Output:
outline          vertices     mass     error    margin
as it comes         10000   a polygon crosses itself or passes a point twice
within 0.003 m         56   2670.5    0.0036    0.2500  certain
within 0.006 m         36   2664.9    0.0063    0.2500  certain
within 0.012 m         28   2653.1    0.0122    0.2500  certain
within 0.024 m         20   2638.8    0.0241    0.2500  certain
within 0.048 m         16   2625.3    0.0480    0.4921

exact outlines, untold and told an error of 0.02 m
untold                 40   2656.9    0.0000    0.2399
untold                200   2669.3    0.0000    0.1445
untold               1000   2669.8    0.0000    0.2598
told                   40   2656.9    0.0200    0.4113  certain
told                  200   2669.3    0.0200    0.4113  certain
told                 1000   2669.8    0.0200    0.4113  certain
*/
