/* tableau.h - the twin: a simplex method on a dense tableau, with verdicts and
   levels of its own, that shares nothing with kern.h but its types. */

#ifndef UNIT_TABLEAU_H
#define UNIT_TABLEAU_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"

static wide *twin_table;
static int *twin_basis, twin_stalled;
#define TWIN_MOST 20000
static long twin_room;

/* The tableau of twin_least_error(): `rows` rows of all + 1 numbers, and below
   them the prices. Columns from `errors` on are the errors; the last holds the
   right-hand side. */
typedef struct tableau {
    int rows, errors, all;
    int still; /* pivots since something moved: then Bland's rule */
} tableau;

static wide *twin_row(const tableau *t, int i)
{
    return twin_table + (long)i * (t->all + 1);
}

/* Prices carry the roundings of all pivots: before they are believed they are
   made anew from the rows that err. */
static void twin_price(const tableau *t)
{
    wide *cost = twin_row(t, t->rows);
    int i, j;
    for (j = 0; j <= t->all; j++) {
        cost[j] = j >= t->errors && j < t->all ? 1 : 0;
        for (i = 0; i < t->rows; i++)
            if (twin_basis[i] >= t->errors)
                cost[j] -= twin_row(t, i)[j];
    }
    for (i = 0; i < t->rows; i++)
        cost[twin_basis[i]] = 0;
}

/* The entering column, -1: none. */
static int twin_enter(const tableau *t)
{
    const wide *cost = twin_row(t, t->rows);
    wide best = -(wide)TWIN_PRICE;
    int j, enter = -1;
    for (j = 0; j < t->all; j++)
        if (cost[j] < best) {
            enter = j;
            if (t->still > 2 * t->rows)
                break;
            best = cost[j];
        }
    return enter;
}

/* The leaving row, -1: none. A row may go below zero by TWIN_ZERO, so that
   among ties, which are the rule here, the largest coefficient can be taken. */
static int twin_leave(const tableau *t, int enter)
{
    wide least = 0;
    int i, leave = -1;
    for (i = 0; i < t->rows; i++) {
        const wide *row = twin_row(t, i);
        if (row[enter] > (wide)TWIN_PIVOT
            && (leave < 0
                || (row[t->all] + (wide)TWIN_ZERO) / row[enter] < least)) {
            least = (row[t->all] + (wide)TWIN_ZERO) / row[enter];
            leave = i;
        }
    }
    for (i = 0; i < t->rows && leave >= 0; i++) {
        const wide *row = twin_row(t, i), *now = twin_row(t, leave);
        if (row[enter] > (wide)TWIN_PIVOT && row[t->all] / row[enter] <= least
            && (t->still > 2 * t->rows && row[enter] > (wide)1e-6
                        && now[enter] > (wide)1e-6
                    ? twin_basis[i] < twin_basis[leave]
                    : row[enter] > now[enter]))
            leave = i;
    }
    return leave;
}

static void twin_pivot(const tableau *t, int enter, int leave)
{
    wide *pivot = twin_row(t, leave);
    const wide by = 1 / pivot[enter];
    int i, j;
    for (j = 0; j <= t->all; j++)
        pivot[j] *= by;
    pivot[enter] = 1;
    for (i = 0; i <= t->rows; i++) {
        wide *row = twin_row(t, i);
        const wide h = row[enter];
        if (i == leave || (h <= 0 && h >= 0))
            continue;
        for (j = 0; j <= t->all; j++)
            row[j] -= h * pivot[j];
        row[enter] = 0;
        if (i < t->rows && row[t->all] < 0)
            row[t->all] = 0;
    }
    twin_basis[leave] = enter;
}

/* Least sum of errors, up and down, in all rows but the last. A row of the
   tableau holds `cols` coefficients, two error columns for each row but the
   last (+1 and -1), and the right-hand side, which is not negative. The last
   row has its own slack in column cols - 1 and no error. Errors cost 1 each.
   Largest price first; Bland's rule when nothing has moved for a while. */
static wide twin_least_error(int rows, int cols)
{
    tableau t;
    wide sum = 0;
    long count;
    int i, fresh = 0;
    t.rows = rows;
    t.errors = cols;
    t.all = cols + 2 * (rows - 1);
    t.still = 0;
    for (i = 0; i < rows - 1; i++) {
        twin_row(&t, i)[cols + i] = 1;
        twin_row(&t, i)[cols + rows - 1 + i] = -1;
        twin_basis[i] = cols + i;
    }
    twin_basis[rows - 1] = cols - 1;
    for (count = 0; count < TWIN_MOST; count++) {
        wide *cost = twin_row(&t, rows), before;
        int enter, leave;
        if (count == 0 || fresh == 1)
            twin_price(&t);
        before = -cost[t.all];
        enter = twin_enter(&t);
        if (before < (wide)TWIN_ZERO || (enter < 0 && fresh))
            break;
        fresh = enter < 0;
        if (fresh)
            continue;
        leave = twin_leave(&t, enter);
        if (leave < 0) {
            cost[enter] = 0; /* only roundings are left of this price */
            continue;
        }
        twin_pivot(&t, enter, leave);
        t.still = -cost[t.all] < before - (wide)TWIN_ZERO ? 0 : t.still + 1;
    }
    /* it has no rule against cycling: where it stalls it cannot tell */
    twin_stalled = count == TWIN_MOST;
    for (i = 0; i < rows; i++)
        if (twin_basis[i] >= cols)
            sum += twin_row(&t, i)[t.all];
    return sum;
}

/* An empty tableau of the size, in memory that grows. */
static void twin_clear(int rows, int all)
{
    const long need = (long)(rows + 1) * (all + 1);
    long cell;
    if (need > twin_room) {
        free(twin_table);
        twin_table = (wide *)malloc(sizeof *twin_table * (size_t)need);
        twin_room = need;
    }
    if (!twin_basis)
        twin_basis = (int *)malloc(sizeof *twin_basis * (3 * MAX_BLOCKS + 1));
    for (cell = 0; cell < need; cell++)
        twin_table[cell] = 0;
}

static wide twin_size(const kern_block *b)
{
    const double area = fabs((double)b->area);
    return area > 0 ? sqrt(area) : 1;
}

/* The two columns of contact k, in the rows of its blocks: the edges of its
   friction cone. */
static void twin_contact(const world *w, int k, wide s, const int *row_of,
                         int all)
{
    const kern_contact *c = &w->contact[k];
    const wide px = c->p.x - s * c->n.y, py = c->p.y + s * c->n.x;
    int side, j;
    for (side = 0; side < 2; side++) {
        const wide m = side ? -(wide)c->mu : (wide)c->mu;
        const wide gx = c->n.x - m * c->n.y, gy = c->n.y + m * c->n.x;
        for (j = 0; j < 2; j++) {
            const int e = j ? c->b : c->a;
            const wide sign = j ? 1 : -1;
            const kern_block *b = &w->block[e];
            wide *at = twin_table + (long)row_of[e] * (all + 1) + 2 * k + side;
            if (row_of[e] < 0)
                continue;
            at[0] = sign * gx;
            at[all + 1] = sign * gy;
            at[2 * (all + 1)] = sign
                              * ((px - b->centre.x) * gy
                                 - (py - b->centre.y) * gx)
                              / twin_size(b);
        }
    }
}

/* The right-hand side of a block's rows, which are turned where it is
   negative. */
static void twin_load(const world *w, int i, wide weight, int row, int all)
{
    const kern_block *b = &w->block[i];
    wide load[3];
    int j, k;
    load[0] = (wide)b->mass * w->gravity.x + b->load.fx;
    load[1] = (wide)b->mass * w->gravity.y + b->load.fy;
    load[2] = (wide)b->load.torque / twin_size(b);
    for (j = 0; j < 3; j++) {
        wide *at = twin_table + (long)(row + j) * (all + 1);
        at[all] = -load[j] / weight;
        for (k = 0; k <= all && load[j] > 0; k++)
            at[k] = -at[k];
    }
}

/* How far the structure is from standing at shrinkage d (negative: grown): the
   least sum of equilibrium errors, as a share of the weight, that contact
   forces of total size up to `bound` times the weight leave. 0: it stands. */
static double twin_shortfall(const world *w, double d, double bound)
{
    static wide travel[MAX_POINTS];
    const wide weight = own_total(w);
    const int cols = 2 * w->contacts + 1;
    int row_of[MAX_BLOCKS], rows = 0, all, i, k;
    wide *last;
    own_travels(w, travel);
    for (i = 0; i < w->blocks; i++) {
        row_of[i] = w->block[i].fixed ? -1 : rows;
        rows += w->block[i].fixed ? 0 : 3;
    }
    if (!(weight > 0))
        return 0;
    rows++;
    all = cols + 2 * (rows - 1);
    twin_clear(rows, all);
    for (k = 0; k < w->contacts; k++)
        twin_contact(w, k, own_slide(travel[k], (wide)d, w->options.relative),
                     row_of, all);
    last = twin_table + (long)(rows - 1) * (all + 1);
    for (k = 0; k < cols - 1; k++)
        last[k] = 1 / (wide)bound;
    last[cols - 1] = 1;
    last[all] = 1;
    for (i = 0; i < w->blocks; i++)
        if (row_of[i] >= 0)
            twin_load(w, i, weight, row_of[i], all);
    return (double)twin_least_error(rows, cols);
}

/* A verdict agrees with the twin unless the twin is sure of the opposite. Near
   the edge, and where only forces about as large as the bound would help, the
   twin is not sure. */
static long twin_near, twin_asked;

static int twin_agrees(const world *w, double d, int stands)
{
    double z = twin_shortfall(w, d, FORCE_BOUND);
    twin_asked++;
    if (twin_stalled || (z > NEAR_LO && z < NEAR_HI))
        twin_near++;
    if (twin_stalled)
        return 1;
    if (stands ? z < NEAR_HI : z > NEAR_LO)
        return 1;
    z = twin_shortfall(w, d, stands ? FORCE_BOUND * 1000 : FORCE_BOUND / 1000);
    if (twin_stalled || (stands ? z < NEAR_HI : z > NEAR_LO)) {
        twin_near++;
        return 1;
    }
    return 0;
}

static double twin_most(const world *w)
{
    static wide travel[MAX_POINTS];
    double most = 0;
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++)
        most = fmax(most, fabs((double)travel[k]));
    return w->options.relative ? 1 : most;
}

/* Largest coordinate of a contact: its rounding is in every length. */
static double reach_of(const world *w)
{
    double most = 0;
    int k;
    for (k = 0; k < w->contacts; k++)
        most = fmax(most, fmax(fabs((double)w->contact[k].p.x),
                               fabs((double)w->contact[k].p.y)));
    return most;
}

/* Contacts are nested where no interface has two point contacts. */
static int twin_nested(const world *w)
{
    static wide travel[MAX_POINTS];
    int k;
    own_travels(w, travel);
    for (k = 0; k < w->contacts; k++)
        if (!w->contact[k].line && (travel[k] < 0 || travel[k] > 0))
            return 0;
    return 1;
}

/* Algorithm 1, literally: shrink, test, until it falls. */
static int twin_level(const world *w, double epsilon, double most)
{
    int k = 0;
    if (twin_shortfall(w, 0, FORCE_BOUND) > NEAR_LO)
        return 0;
    for (;;) {
        double d;
        k++;
        d = k * epsilon < most ? k * epsilon : most;
        if (twin_shortfall(w, d, FORCE_BOUND) > NEAR_LO)
            return k;
        if (d >= most)
            return (int)ceil(most / epsilon) + 1;
    }
}

/* First loss: between `low`, which stands, and `high`, which falls. */
static double twin_bisect(const world *w, double low, double high, double width)
{
    while (high - low > width) {
        const double middle = (low + high) / 2;
        if (!(middle > low && middle < high))
            break;
        if (twin_shortfall(w, middle, FORCE_BOUND) > NEAR_LO)
            high = middle;
        else
            low = middle;
    }
    return (low + high) / 2;
}

#endif
