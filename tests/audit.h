/* audit.h - kern.h with its asserts, and with the state of its engines checked
   where KERN_AUDIT(engine, state) stands: the simplex method after every pivot, a
   skyline factor when it is made, a part when it is opened, the interior point
   after every step.

   Include it before everything else, as tests/unit.sh does:

       cc -O2 -include tests/audit.h -o kern_test tests/kern_test.c -lm */

#ifndef AUDIT_H
#define AUDIT_H

#include <assert.h>

struct kern_simplex;
struct kern_skyline;
struct kern_part;
struct kern_ipm;
static void audit_simplex(struct kern_simplex *sx);
static void audit_factor(const struct kern_skyline *a);
static void audit_part(const struct kern_part *p);
static void audit_ipm(const struct kern_ipm *in);

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#define KERN_ASSERT(condition) assert(condition)
#define KERN_AUDIT(engine, state) audit_##engine(state)
#include "../kern.h"

/* Bases of float, and of jams, may be nearly singular. */
#define AUDIT_TOL KERN_PICK(1e-2, 1e30)
/* Entries of the matrix beyond which a basis keeps no digits. */
#define AUDIT_LARGE KERN_R(1e6)
/* Rows of larger programs are not looked at. */
enum { AUDIT_ROWS = 2000 };

/* Header and places are inverse to each other, logicals in their rows. */
static void audit_places(const kern_simplex *sx)
{
    const int cols = sx->lp->cols;
    int p, j;
    for (j = 0; j <= cols; j++)
        assert(sx->basic_row[j] == KERN_OUT || sx->base[sx->basic_row[j]] == j);
    for (p = 0; p < sx->lp->rows; p++)
        assert(sx->base[p] > cols ? sx->base[p] == cols + 1 + p
                                  : sx->basic_row[sx->base[p]] == p);
}

/* And for a network, where rounding is bounded, whether B x = b, and B^-1 B = I
   for a vector of ones of mixed signs. */
static void audit_simplex(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const int m = lp->rows;
    kern_real v[AUDIT_ROWS + 6];
    int p;
    if (m > AUDIT_ROWS)
        return;
    audit_places(sx);
    if (!lp->ends || kern_largest(lp->a, 4 * lp->cols) > AUDIT_LARGE)
        return;
    for (p = 0; p < m; p++)
        v[p] = 0;
    for (p = 0; p < m; p++) {
        const kern_real want = p % 3 ? KERN_R(1) : KERN_R(-1);
        kern_lp_subtract(lp, sx->base[p], -want, v);
    }
    kern_basis_solve(sx, v);
    for (p = 0; p < m; p++)
        assert(kern_abs(v[p] - (p % 3 ? KERN_R(1) : KERN_R(-1))) <= AUDIT_TOL);
    assert(kern_basis_residual(sx) <= AUDIT_TOL
           || !(kern_largest(sx->value, m) > 0));
}

/* A factor has a positive diagonal, and is finite up to where it overflows: the
   interior point ends there. */
static void audit_factor(const kern_skyline *a)
{
    int g, i, k;
    for (g = 0; g < a->groups; g++) {
        const int wide = 3 * (g - a->first_column[g] + 1);
        const kern_real *row = a->entry + a->offset[g];
        assert(a->first_column[g] >= 0 && a->first_column[g] <= g);
        for (k = 0; k < 3; k++) {
            for (i = 0; i < wide - 3 + k; i++)
                if (!kern_is_finite(row[k * wide + i]))
                    return;
            assert(row[k * wide + wide - 3 + k] > 0);
        }
    }
}

/* The groups that are marked are those of the part, in their order, and no
   contact of it lies within a group. */
static void audit_part(const kern_part *p)
{
    const kern_graph *graph = &p->m->graph;
    int g, k, marked = 0;
    for (g = 0; g < graph->groups; g++)
        if (graph->local[g] != KERN_OUT) {
            assert(graph->local[g] == marked && p->group[marked] == g);
            marked++;
        }
    assert(marked == p->groups);
    for (k = 0; k < p->contacts; k++)
        assert(p->ends[2 * k] != p->ends[2 * k + 1]);
}

/* After a step that kept its digits every ray is within its bounds, and s. */
static void audit_ipm(const kern_ipm *in)
{
    int i;
    if (!kern_is_finite(in->duality_gap))
        return;
    assert(in->duality_gap > 0 && in->s <= 0);
    for (i = 0; i < 2 * in->part->contacts; i++)
        assert(in->part->x[i] > 0 && in->z[i] > 0 && in->scaling[i] > 0);
}

#endif
