/* cc -O2 -ffp-contract=off -o exact tests/exact.c -lgmp -lm && ./exact 1000

   Verdicts against exact rational arithmetic (Debian: libgmp-dev).

       exact N [FIRST [MOST]]   one question about each of N random structures
                                of up to MOST blocks (6; no more than 14)
       exact families N [FIRST [MOST]]   the same for those of families.h

   The data, which are doubles, are taken as the rational numbers that they
   are. Most questions are asked close to critical: with the kerns shrunk to
   the margin (or grown to the deficit), give or take 1e-11, 1e-10, 1e-9, 1e-7,
   1e-5 or 1e-3 of the mean block size. Each is decided three times:

   - by the library;
   - by its proof, checked without rounding: the sums that must vanish within
     the tolerance, the motion that no force below the bound can stop;
   - by a simplex method in whole numbers, which knows no tolerance.

   A verdict is wrong where its proof fails, and where "stands" would still be
   untrue if every kern were larger by 1e-8 of the mean size, and every
   coefficient of friction by 1e-8 (where the rounding of the forces on a block
   is more than 1e-9 of its weight: by ten times that share). Counted besides,
   by distance: "tolerance", where the exact answer is "falls" but a little
   less shrinkage makes it "stands" (a load that passes exactly through a closed
   kern is of this kind at any distance), "bound", where forces exist that are
   larger than is allowed, and "margin off", where the margin is not where the
   exact answer changes; with point contacts it may change more than once. */

#include <float.h>
#include <gmp.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef KERN_SINGLE
#error "exact.c: the comparison is made in double"
#endif
#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "structures.h"
#include "families.h"

enum { FREE = 14, ROWS = 3 * FREE, COLS = 2 * CONTACTS };

static kern_force force[CONTACTS];
static kern_motion motion[BLOCKS];

/* ==== Numbers without rounding ====================================== */

static mpq_t t1, t2; /* scratch */

/* sum += a b */
static void add_product(mpq_t sum, const mpq_t a, const mpq_t b)
{
    mpq_mul(t1, a, b);
    mpq_add(sum, sum, t1);
}

/* sum -= a b */
static void take_product(mpq_t sum, const mpq_t a, const mpq_t b)
{
    mpq_mul(t1, a, b);
    mpq_sub(sum, sum, t1);
}

/* ==== The structure without rounding ================================ */

/* Where contact point k acts, and its normal: exact values of the doubles. */
typedef struct point {
    mpq_t x, y, nx, ny, mu;
} point;

static point place[CONTACTS];
static mpq_t centre[BLOCKS][2], load[BLOCKS][3]; /* weight and load */
static int group[BLOCKS]; /* number of a free block, -1: fixed */
static int groups;

static void exact_start(void)
{
    int i, k;
    mpq_inits(t1, t2, NULL);
    for (k = 0; k < CONTACTS; k++)
        mpq_inits(place[k].x, place[k].y, place[k].nx, place[k].ny, place[k].mu,
                  NULL);
    for (i = 0; i < BLOCKS; i++)
        mpq_inits(centre[i][0], centre[i][1], load[i][0], load[i][1],
                  load[i][2], NULL);
}

/* `grow` [m] opens every kern that much beyond the shrinkage. */
static void exact_point(int k, double shrink, double grow, double mean)
{
    const kern_contact *c = &contact[k];
    const double travel = kern_abs(c->travel) < 1e-9 * mean ? 0 : c->travel;
    point *p = &place[k];
    mpq_set_d(p->x, c->p.x);
    mpq_set_d(p->y, c->p.y);
    mpq_set_d(p->nx, c->n.x);
    mpq_set_d(p->ny, c->n.y);
    mpq_set_d(p->mu, c->mu);
    mpq_set_d(t2, travel);
    if (options.relative) {
        mpq_set_d(t1, shrink);
        mpq_mul(t2, t2, t1);
    } else if (shrink < kern_abs(travel))
        mpq_set_d(t2, travel < 0 ? -shrink : travel > 0 ? shrink : 0);
    mpq_set_d(t1, travel < 0 ? -grow : travel > 0 ? grow : 0);
    mpq_sub(t2, t2, t1);
    take_product(p->x, t2, p->ny);
    add_product(p->y, t2, p->nx);
}

static void exact_structure(double shrink, double grow)
{
    const double mean = kern_mean_size(block, s.blocks);
    int i, k;
    groups = 0;
    for (i = 0; i < s.blocks; i++) {
        const kern_block *b = &block[i];
        group[i] = b->fixed ? -1 : groups++;
        mpq_set_d(centre[i][0], b->centre.x);
        mpq_set_d(centre[i][1], b->centre.y);
        mpq_set_d(load[i][0], b->load.fx);
        mpq_set_d(load[i][1], b->load.fy);
        mpq_set_d(load[i][2], b->load.torque);
        mpq_set_d(t2, b->mass);
        mpq_set_d(t1, s.gravity.x);
        mpq_mul(t1, t1, t2);
        mpq_add(load[i][0], load[i][0], t1);
        mpq_set_d(t1, s.gravity.y);
        mpq_mul(t1, t1, t2);
        mpq_add(load[i][1], load[i][1], t1);
    }
    for (k = 0; k < s.contacts; k++)
        exact_point(k, shrink, grow, mean);
}

/* Adds to the three sums of block i what a force (fx, fy) at point k does. */
static void exact_act(mpq_t sum[3], int i, int k, const mpq_t fx,
                      const mpq_t fy, int sign)
{
    mpq_t arm, turn;
    mpq_inits(arm, turn, NULL);
    mpq_sub(arm, place[k].x, centre[i][0]);
    add_product(turn, arm, fy);
    mpq_sub(arm, place[k].y, centre[i][1]);
    take_product(turn, arm, fx);
    if (sign > 0) {
        mpq_add(sum[0], sum[0], fx);
        mpq_add(sum[1], sum[1], fy);
        mpq_add(sum[2], sum[2], turn);
    } else {
        mpq_sub(sum[0], sum[0], fx);
        mpq_sub(sum[1], sum[1], fy);
        mpq_sub(sum[2], sum[2], turn);
    }
    mpq_clears(arm, turn, NULL);
}

/* The force f n + r t of point k. */
static void exact_force(mpq_t fx, mpq_t fy, int k, const mpq_t f, const mpq_t r)
{
    mpq_mul(fx, f, place[k].nx);
    take_product(fx, r, place[k].ny);
    mpq_mul(fy, f, place[k].ny);
    add_product(fy, r, place[k].nx);
}

/* ==== Proofs without rounding ======================================= */

static double weight_of(int i)
{
    kern_work work = whole_work();
    kern_query q;
    kern_wrench w;
    kern_query_read(task_of(&work), 0, &q);
    return kern_block_wrench(&s, &q, i, &w);
}

/* The largest share of its own weight that a block may miss. */
static double missing;

/* The arm of point k about block i, or the size of that if it is longer. */
static double arm_of(int i, int k)
{
    const double x = mpq_get_d(place[k].x) - block[i].centre.x;
    const double y = mpq_get_d(place[k].y) - block[i].centre.y;
    return kern_max(kern_block_size(&block[i]), kern_abs(x) + kern_abs(y));
}

/* What the forces leave of the load in the three sums of every block. */
static void sum_forces(mpq_t sum[BLOCKS][3])
{
    mpq_t f, r, fx, fy;
    int i, k, row;
    mpq_inits(f, r, fx, fy, NULL);
    for (i = 0; i < s.blocks; i++)
        for (row = 0; row < 3; row++)
            mpq_set(sum[i][row], load[i][row]);
    for (k = 0; k < s.contacts; k++) {
        const int a = contact[k].a, b = contact[k].b;
        mpq_set_d(f, force[k].normal);
        mpq_set_d(r, force[k].tangential);
        exact_force(fx, fy, k, f, r);
        exact_act(sum[a], a, k, fx, fy, -1);
        exact_act(sum[b], b, k, fx, fy, 1);
    }
    mpq_clears(f, r, fx, fy, NULL);
}

/* Whether free block i misses no more than it may: forces are doubles, so some
   roundings of them and of their moments. */
static int is_balanced(int i, mpq_t sum[3])
{
    const double own = weight_of(i), size = kern_block_size(&block[i]);
    double largest = 0, moment = 0, allowed, turning;
    int k;
    for (k = 0; k < s.contacts; k++)
        if (contact[k].a == i || contact[k].b == i) {
            largest = kern_max(largest, force[k].normal);
            moment = kern_max(moment, force[k].normal * arm_of(i, k));
        }
    allowed = 1.000001e-9 * own + 1e-14 * largest;
    turning = 1.000001e-9 * own * size + 1e-14 * moment;
    if (own > 0)
        missing = kern_max(missing, allowed / own);
    return kern_abs(mpq_get_d(sum[0])) <= allowed
        && kern_abs(mpq_get_d(sum[1])) <= allowed
        && kern_abs(mpq_get_d(sum[2])) <= turning;
}

/* Whether the forces hold: they lie in their cones, are not too large in all,
   and leave nothing in any sum. */
static int forces_hold(void)
{
    mpq_t sum[BLOCKS][3];
    double total = 0, weight = 0;
    int i, k, holds = 1;
    missing = 1e-9;
    for (k = 0; k < s.contacts; k++) {
        const double most = force[k].normal * contact[k].mu;
        holds = holds && force[k].normal >= 0
             && kern_abs(force[k].tangential) <= most * (1 + 1e-15);
        total += force[k].normal;
    }
    for (i = 0; i < s.blocks; i++)
        mpq_inits(sum[i][0], sum[i][1], sum[i][2], NULL);
    sum_forces(sum);
    for (i = 0; i < s.blocks; i++) {
        if (!block[i].fixed) {
            weight += weight_of(i);
            holds &= is_balanced(i, sum[i]);
        }
        mpq_clears(sum[i][0], sum[i][1], sum[i][2], NULL);
    }
    return holds && total <= 1e6 * weight * (1 + 1e-9);
}

/* A force along edge n + side mu t of the friction cone of point k. */
static void edge_force(mpq_t fx, mpq_t fy, int k, int side)
{
    mpq_t f, r;
    mpq_inits(f, r, NULL);
    mpq_set_si(f, 1, 1);
    mpq_set(r, place[k].mu);
    if (side < 0)
        mpq_neg(r, r);
    exact_force(fx, fy, k, f, r);
    mpq_clears(f, r, NULL);
}

/* What the motion gains from a force of 1 on edge n + side mu t of point k. */
static double gain_of(int k, int side)
{
    mpq_t sum[3], fx, fy, gain, speed;
    double result;
    int end, row;
    mpq_inits(fx, fy, gain, speed, sum[0], sum[1], sum[2], NULL);
    edge_force(fx, fy, k, side);
    for (end = 0; end < 2; end++) {
        const int i = end ? contact[k].b : contact[k].a;
        const double v[3] = {motion[i].vx, motion[i].vy, motion[i].spin};
        for (row = 0; row < 3; row++)
            mpq_set_si(sum[row], 0, 1);
        exact_act(sum, i, k, fx, fy, end ? 1 : -1);
        for (row = 0; row < 3 && !block[i].fixed; row++) {
            mpq_set_d(speed, v[row]);
            add_product(gain, speed, sum[row]);
        }
    }
    result = mpq_get_d(gain);
    mpq_clears(fx, fy, gain, speed, sum[0], sum[1], sum[2], NULL);
    return result;
}

/* Whether the motion proves the fall: its power over what forces of the
   largest size could take out of it. */
static int motion_proves(void)
{
    mpq_t power, speed;
    double closing = 0, weight = 0, gained;
    int i, k, row;
    mpq_inits(power, speed, NULL);
    for (i = 0; i < s.blocks; i++) {
        const double v[3] = {motion[i].vx, motion[i].vy, motion[i].spin};
        if (block[i].fixed)
            continue;
        if (v[0] < 0 || v[0] > 0 || v[1] < 0 || v[1] > 0 || v[2] < 0
            || v[2] > 0)
            weight += weight_of(i);
        for (row = 0; row < 3; row++) {
            mpq_set_d(speed, v[row]);
            add_product(power, speed, load[i][row]);
        }
    }
    for (k = 0; k < s.contacts; k++) {
        closing = kern_max(closing, -gain_of(k, 1));
        closing = kern_max(closing, -gain_of(k, -1));
    }
    gained = mpq_get_d(power);
    mpq_clears(power, speed, NULL);
    return gained > 0 && gained * (1 + 1e-9) >= 1e6 * weight * closing;
}

/* ==== The simplex method in whole numbers =========================== */

/* Tableau of whole numbers over one common denominator (Bareiss): rows of the
   equilibrium, last row what is left of them all; last column the load. */
static mpz_t cell[ROWS + 1][COLS + 1];
static mpz_t denominator, product;
static int basis[ROWS]; /* column of a row; COLS + row where artificial */

static void simplex_start(void)
{
    int i, j;
    for (i = 0; i <= ROWS; i++)
        for (j = 0; j <= COLS; j++)
            mpz_init(cell[i][j]);
    mpz_inits(denominator, product, NULL);
}

/* Writes a column, multiplied by what makes it whole. */
static void simplex_column(int j, mpq_t *entry, int rows)
{
    mpz_t whole;
    int i;
    mpz_init_set_ui(whole, 1);
    for (i = 0; i < rows; i++)
        mpz_lcm(whole, whole, mpq_denref(entry[i]));
    for (i = 0; i < rows; i++) {
        mpz_divexact(product, whole, mpq_denref(entry[i]));
        mpz_mul(cell[i][j], product, mpq_numref(entry[i]));
    }
    mpz_clear(whole);
}

/* Whether edge n + side mu t of point k carried in the library's solution. */
static int carried(int k, int side)
{
    return force[k].normal * contact[k].mu + side * force[k].tangential
         > 1e-9 * force[k].normal;
}

/* What a force along an edge does in the sums of all groups. */
static void edge_entries(mpq_t entry[ROWS], int k, int side)
{
    mpq_t fx, fy;
    int i;
    mpq_inits(fx, fy, NULL);
    for (i = 0; i < ROWS; i++)
        mpq_set_si(entry[i], 0, 1);
    edge_force(fx, fy, k, side);
    for (i = 0; i < 2; i++) {
        const int b = i ? contact[k].b : contact[k].a;
        if (group[b] >= 0)
            exact_act(entry + 3 * group[b], b, k, fx, fy, i ? 1 : -1);
    }
    mpq_clears(fx, fy, NULL);
}

/* Columns of the friction cones; those that carried in the library's solution
   come first, since Bland's rule tries them in this order. */
static int simplex_fill(int with_forces)
{
    mpq_t entry[ROWS];
    int i, k, side, pass, cols = 0;
    for (i = 0; i < ROWS; i++)
        mpq_init(entry[i]);
    for (pass = 0; pass < 2; pass++)
        for (k = 0; k < s.contacts; k++)
            for (side = -1; side < 2; side += 2) {
                if ((with_forces && carried(k, side)) != (pass == 0))
                    continue;
                edge_entries(entry, k, side);
                simplex_column(cols++, entry, 3 * groups);
            }
    for (i = 0; i < s.blocks; i++)
        for (k = 0; k < 3 && group[i] >= 0; k++)
            mpq_neg(entry[3 * group[i] + k], load[i][k]);
    simplex_column(cols, entry, 3 * groups);
    for (i = 0; i < ROWS; i++)
        mpq_clear(entry[i]);
    return cols;
}

static void simplex_pivot(int row, int col, int rows, int cols)
{
    int i, j;
    for (i = 0; i <= rows; i++) {
        if (i == row)
            continue;
        for (j = 0; j <= cols; j++) {
            if (j == col)
                continue;
            mpz_mul(product, cell[i][j], cell[row][col]);
            mpz_submul(product, cell[i][col], cell[row][j]);
            mpz_divexact(cell[i][j], product, denominator);
        }
        mpz_set_ui(cell[i][col], 0);
    }
    mpz_set(denominator, cell[row][col]);
    basis[row] = col;
}

/* The row that limits column `col`, the least basic variable among equals. */
static int simplex_leaving(int col, int rows, int cols)
{
    int i, best = -1;
    for (i = 0; i < rows; i++) {
        int order = -1;
        if (mpz_sgn(cell[i][col]) <= 0)
            continue;
        if (best >= 0) {
            mpz_mul(product, cell[i][cols], cell[best][col]);
            mpz_submul(product, cell[best][cols], cell[i][col]);
            order = mpz_sgn(product);
        }
        if (order < 0 || (order == 0 && basis[i] < basis[best]))
            best = i;
    }
    return best;
}

/* Whether forces in their cones exist that hold every block, exactly. */
static int exact_stands(int with_forces)
{
    const int rows = 3 * groups, cols = simplex_fill(with_forces);
    int i, j;
    mpz_set_ui(denominator, 1);
    for (j = 0; j <= cols; j++)
        mpz_set_ui(cell[rows][j], 0);
    for (i = 0; i < rows; i++) {
        const int turn = mpz_sgn(cell[i][cols]) < 0;
        basis[i] = COLS + i;
        for (j = 0; j <= cols; j++) {
            if (turn)
                mpz_neg(cell[i][j], cell[i][j]);
            mpz_add(cell[rows][j], cell[rows][j], cell[i][j]);
        }
    }
    while (mpz_sgn(cell[rows][cols]) > 0) {
        for (j = 0; j < cols && mpz_sgn(cell[rows][j]) <= 0; j++)
            ;
        if (j == cols)
            return 0;
        simplex_pivot(simplex_leaving(j, rows, cols), j, rows, cols);
    }
    return 1;
}

/* ==== Questions ===================================================== */

enum { DISTANCES = 7 };
static const char *const distance_name[DISTANCES] = {
    "1e-11", "1e-10", "1e-9", "1e-7", "1e-5", "1e-3", "any"};
static const double distance[DISTANCES] = {1e-11, 1e-10, 1e-9, 1e-7,
                                           1e-5,  1e-3,  0};

/* A proof allows a residual of 1e-9 of a block's weight. Where "stands" is only
   true within that tolerance, kerns that grow by TOLERANCE times 1e-9 of the
   length must make it true: a force that is a part of the weight has to move by
   several times its residual. A pebble between boulders may need more. */
#define TOLERANCE 10

/* By distance: how many were asked, and what was answered. */
static struct tally {
    long asked, stands, undecided, wrong, tolerance, bound, off;
} tally[DISTANCES];

/* What distances are shares of: the mean block size, or how far kerns are
   moved if that is more. */
static double length_of(double shrink)
{
    const double mean = kern_mean_size(block, s.blocks);
    return options.relative ? kern_max(1, kern_abs(shrink))
                            : kern_max(mean, kern_abs(shrink));
}

/* A shrinkage near to where the verdict changes; the last: there is none. */
static int question(kern_work *work, double *shrink, int *expect)
{
    const int which = random_below(DISTANCES - 1), inside = random_below(2);
    const double unit = length_of(0);
    kern_margin m;
    kern_real deficit = 0;
    kern_status got;
    *shrink = 0;
    *expect = KERN_UNDECIDED;
    got = kern_measure(task_of(work), &m, NULL);
    if (got == KERN_STANDS && !m.saturated && m.margin > 2e-3 * unit)
        *shrink = m.margin;
    else if (got == KERN_FALLS
             && kern_deficit(task_of(work), &deficit) == KERN_FALLS
             && deficit < 100 * unit)
        *shrink = -deficit;
    else
        return DISTANCES - 1;
    *shrink += (inside ? -1 : 1) * distance[which] * length_of(*shrink);
    if (options.relative && *shrink > 1)
        *shrink = 1; /* every kern is closed */
    *expect = inside ? KERN_STANDS : KERN_FALLS;
    return which;
}

/* Does it stand with every kern and every cone of friction a little larger?
   Kerns either by opening them, so that closed ones open as well, or by less
   shrinkage: with point contacts that is not the same. */
static int almost_stands(double shrink)
{
    const double share = TOLERANCE * missing;
    const double little = share * length_of(shrink);
    int way, k;
    for (way = 0; way < 2; way++) {
        exact_structure(way ? shrink - little : shrink, way ? 0 : little);
        mpq_set_d(t1, share);
        for (k = 0; k < s.contacts; k++)
            mpq_add(place[k].mu, place[k].mu, t1);
        if (exact_stands(1))
            return 1;
    }
    return 0;
}

/* With families: how many of each were asked and undecided, and how many could
   not be asked, since contacts were refused. */
static struct {
    long asked, undecided, refused;
} of_family[FAMILIES];

static void ask(int seed, int most, int families)
{
    kern_work work = whole_work();
    kern_proof proof;
    kern_status got;
    double shrink;
    int expect, which, exact, proven = 1, family = 0;
    if (families)
        family = random_family(seed, most, &work);
    else
        random_structure(seed, most, &work);
    if (s.contacts < 0 || s.blocks < 2) {
        of_family[family].refused++;
        return;
    }
    which = question(&work, &shrink, &expect);
    proof.force = force;
    proof.motion = motion;
    got = kern_verdict(task_of(&work), shrink, &proof);
    exact_structure(shrink, 0);
    exact = exact_stands(got == KERN_STANDS) ? KERN_STANDS : KERN_FALLS;
    tally[which].asked++;
    tally[which].stands += exact == KERN_STANDS;
    tally[which].undecided += got == KERN_UNDECIDED;
    of_family[family].asked++;
    of_family[family].undecided += got == KERN_UNDECIDED;
    if (got == KERN_STANDS)
        proven = forces_hold();
    else if (got == KERN_FALLS)
        proven = motion_proves();
    if (proven && got == KERN_STANDS && exact == KERN_FALLS) {
        proven = almost_stands(shrink);
        tally[which].tolerance += proven;
    } else if (expect != KERN_UNDECIDED && exact != expect)
        tally[which].off++;
    if (proven && got == KERN_FALLS && exact == KERN_STANDS)
        tally[which].bound++;
    if (!proven) {
        tally[which].wrong++;
        printf("structure %d at %.17g: %s, without a proof; exactly: %s\n",
               seed, shrink, kern_status_text(got),
               kern_status_text((kern_status)exact));
    }
}

int main(int argc, char **argv)
{
    const int families = argc > 1 && strcmp(argv[1], "families") == 0;
    const int many = argc > families + 1 ? atoi(argv[families + 1]) : 1000;
    const int first = argc > families + 2 ? atoi(argv[families + 2]) : 1;
    const int most = argc > families + 3 ? atoi(argv[families + 3]) : 6;
    long wrong = 0;
    int i;
    if (most < 1 || most > FREE)
        return 2;
    exact_start();
    simplex_start();
    for (i = 0; i < many; i++)
        ask(first + i, most, families);
    printf("distance   asked   stand undecided   wrong  tolerance  bound  "
           "margin off\n");
    for (i = 0; i < DISTANCES; i++) {
        const struct tally *t = &tally[i];
        printf("%8s %7ld %7ld %9ld %7ld %10ld %6ld %11ld\n", distance_name[i],
               t->asked, t->stands, t->undecided, t->wrong, t->tolerance,
               t->bound, t->off);
        wrong += t->wrong;
    }
    for (i = 0; i < FAMILIES && families; i++)
        printf("%-11s %6ld asked, %ld undecided, %ld refused\n", family_name[i],
               of_family[i].asked, of_family[i].undecided,
               of_family[i].refused);
    printf("%ld wrong\n", wrong);
    return wrong ? 1 : 0;
}
