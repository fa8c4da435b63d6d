/* The paper in one page: Eq. (5), and Algorithm 1, one linear program a step.

       cc -O2 -o algorithm1 examples/copy/algorithm1.c -lm

   A structure stands if there are forces x >= 0 with A x = -w. A has three
   rows for each free block, and two columns for each contact point: the edges
   of its cone of friction. Algorithm 1 shrinks every contact by epsilon, 2
   epsilon, and so on, until there is no solution. The number of that step is
   the level. kern_measure() returns the same level in a fraction of the time;
   tests/DESIGN.md says how. This program needs only kern_contact_at() and
   kern_lp_solve() for it. */

#include <math.h>
#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

/* ---- Eq. (5) ---- */

/* The unit of length is the mean size of the stones, that of force their mean
   weight: then entries of all rows are about 1, as a solver wants them. */
struct equation5 {
    int *row;       /* first of the three rows of a block, -1: it is fixed    */
    int rows;       /* three a free block                                     */
    kern_real *a;   /* rows x 2 contacts, column by column                    */
    kern_real *rhs; /* -w                                                     */
    kern_real *x;   /* forces along the edges of the cones, two a contact     */
    kern_real *y;   /* where there are none: the velocities of the proof      */
    kern_real length, weight; /* the units                                    */
};

/* Adds a force, and its torque about the centre, to the rows of a block. */
static void add_force(const struct equation5 *e, kern_real *column, int row,
                      kern_vec force, kern_real torque)
{
    column[row] += force.x;
    column[row + 1] += force.y;
    column[row + 2] += torque / e->length;
}

/* Chooses the units, numbers the rows of the free blocks and writes -w. */
static void write_weights(struct equation5 *e, const kern_structure *s)
{
    const kern_vec g = s->gravity;
    kern_real mass = 0;
    int i;
    e->rows = 0;
    for (i = 0; i < s->blocks; i++) {
        e->row[i] = s->block[i].fixed ? -1 : e->rows;
        e->rows += s->block[i].fixed ? 0 : 3;
        mass += s->block[i].fixed ? 0 : s->block[i].mass;
    }
    e->length = kern_mean_size(s->block, s->blocks);
    e->weight = 3 * mass / e->rows * sqrt(g.x * g.x + g.y * g.y);
    for (i = 0; i < e->rows; i++)
        e->rhs[i] = 0;
    for (i = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        const kern_vec w = {(b->mass * g.x + b->load.fx) / e->weight,
                            (b->mass * g.y + b->load.fy) / e->weight};
        const kern_vec less = {-w.x, -w.y};
        if (e->row[i] >= 0)
            add_force(e, e->rhs, e->row[i], less, -b->load.torque / e->weight);
    }
}

/* Writes A for contacts that are shrunk by d: two columns a contact point, the
   edges n + mu t and n - mu t of its cone with t = (-n.y, n.x). */
static void write_columns(const struct equation5 *e, const kern_structure *s,
                          kern_real d, int relative)
{
    int i, k;
    for (i = 0; i < 2 * s->contacts; i++) {
        const kern_contact *c = &s->contact[i / 2];
        const kern_vec p = kern_contact_at(c, d, relative);
        const kern_real mu = i % 2 ? -c->mu : c->mu;
        const kern_vec f = {c->n.x - mu * c->n.y, c->n.y + mu * c->n.x};
        kern_real *column = e->a + (size_t)i * (size_t)e->rows;

        for (k = 0; k < e->rows; k++)
            column[k] = 0;
        for (k = 0; k < 2; k++) { /* f acts on b, the opposite on a */
            const int on = k ? c->a : c->b;
            const kern_vec o = s->block[on].centre;
            const kern_vec feels = {k ? -f.x : f.x, k ? -f.y : f.y};
            if (e->row[on] >= 0)
                add_force(e, column, e->row[on], feels,
                          (p.x - o.x) * feels.y - (p.y - o.y) * feels.x);
        }
    }
}

/* Solves Eq. (5) at shrinkage d. Returns KERN_LP_OPTIMAL if it has a solution,
   KERN_LP_INFEASIBLE if it has none, and a number below 0 if it was not solved.
   */
static kern_status solve(const struct equation5 *e, const kern_structure *s,
                         kern_real d, int relative, kern_work *work)
{
    const kern_lp lp = {e->rows, 2 * s->contacts, e->a, e->rhs, NULL, 0};
    write_columns(e, s, d, relative);
    return kern_lp_solve(&lp, e->x, e->y, work);
}

/* ---- Algorithm 1 ---- */

/* Returns the level: the first k for which contacts that are shrunk by
   k epsilon, and at most by d_max, hold no longer. If they hold for every k,
   returns one more than the last. Returns -1 if a program was not solved. */
static int algorithm1(struct equation5 *e, const kern_structure *s,
                      int relative, kern_real epsilon, kern_real d_max,
                      kern_work *work)
{
    const int last = (int)ceil(d_max / epsilon);
    int k;
    write_weights(e, s);
    for (k = 0; k <= last; k++) {
        const kern_real d = k * epsilon < d_max ? k * epsilon : d_max;
        const kern_status status = solve(e, s, d, relative, work);
        if (status != KERN_LP_OPTIMAL)
            return status == KERN_LP_INFEASIBLE ? k : -1;
    }
    return last + 1;
}

/* ---- Three stones ---- */

enum { BLOCKS = 4, CONTACTS = 12, ROWS = 3 * (BLOCKS - 1) };
enum { COLS = 2 * CONTACTS };
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS) + KERN_LP_REALS(ROWS, COLS),
    INTS = KERN_INTS(BLOCKS, CONTACTS) + KERN_LP_INTS(ROWS, COLS)
}; /* of work memory, for both ways */

static const kern_vec corner[BLOCKS][4] = {
    {{-3, -1}, {3, -1}, {3, 0}, {-3, 0}},       /* ground */
    {{-1, 0}, {0, 0}, {0, 1}, {-1, 1}},         /* left   */
    {{1, 0}, {2, 0}, {2, 1}, {1, 1}},           /* right  */
    {{-1, 1}, {4.2, 1}, {4.2, 1.5}, {-1, 1.5}}, /* beam   */
};

static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_real reals[REALS], a[ROWS * COLS], rhs[ROWS], x[COLS], y[ROWS];
static int ints[INTS], row[BLOCKS];

int main(void)
{
    kern_work work = kern_work_of(reals, REALS, ints, INTS);
    kern_task task = kern_task_of(block, BLOCKS, contact, 0, &work);
    struct equation5 e = {row, 0, a, rhs, x, y, 1, 1};
    kern_margin m;
    int i, k, level;

    kern_ground_init(&block[0], corner[0], 4, NULL);
    for (i = 1; i < BLOCKS; i++)
        kern_block_init(&block[i], corner[i], 4, 1, NULL);
    block[3].mass = 3;
    task.options.epsilon = 0.15;
    task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                    CONTACTS, &work);
    if (kern_measure(&task, &m, NULL) != KERN_STANDS)
        return 1;
    level = algorithm1(&e, &task.s, 0, m.epsilon, m.most, &work);
    printf("%d equations, %d columns\n", e.rows, 2 * task.s.contacts);
    for (k = 0; k <= level; k++)
        printf("shrunk by %.2f: %s\n", k * m.epsilon,
               solve(&e, &task.s, k * m.epsilon, 0, &work) == KERN_LP_OPTIMAL
                   ? "forces hold it"
                   : "no forces can");
    printf("level %d; of kern_measure() %d, margin %g\n", level, m.level,
           m.margin);
    return level == m.level ? 0 : 1;
}

/* Output:
9 equations, 16 columns
shrunk by 0.00: forces hold it
shrunk by 0.15: forces hold it
shrunk by 0.30: forces hold it
shrunk by 0.45: no forces can
level 3; of kern_measure() 3, margin 0.4
*/
