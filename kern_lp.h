/* kern_lp.h: GLPK as the backend of large linear programs of kern.h

   Not to be included by itself. Compile the implementation of kern.h with
   KERN_USE_GLPK defined and link GLPK:

       cc -DKERN_USE_GLPK ... -lglpk -lm        (Debian: libglpk-dev)

   Programs of more than KERN_GLPK_ROWS rows (three a free block; default 96,
   about 32 blocks) then go to GLPK, the others stay with the simplex of
   kern.h. GLPK is not trusted: what it answers passes the same proof as any
   other answer, and where the proof fails the simplex of kern.h is asked.

   WHEN. Hardly ever for speed: where the forces of a wall can be passed on from
   the top down no linear program is asked, and where one is, the simplex of
   kern.h, which starts from a basis that carries the weights, was 20 to 200
   times as fast on walls, towers and arches of 50 to 200 blocks. It is a second
   opinion: another solver, beneath the same proofs.

   LICENCE. GLPK is under the GNU General Public License, version 3 or later.
   This file is under the licence of kern.h, but a program that is linked with
   GLPK may be given away only under the GPL as a whole. Firmware whose source
   stays closed must not define KERN_USE_GLPK; kern.h needs nothing of it.

   THREADS. GLPK keeps its state for each thread; a program is made and deleted
   within one call, so several threads may ask at the same time.

   MEMORY. GLPK allocates with malloc and ends the process where that fails.
   Everything that it is handed was checked before, so that its other errors,
   which end the process too, cannot be reached. It prints nothing.

   SPDX-License-Identifier: MIT */

#if !defined(KERN_LP_H_ALLOWED)
#error \
    "kern_lp.h: include kern.h instead, with KERN_USE_GLPK defined where the implementation is"
#endif

#ifndef KERN_LP_H
#define KERN_LP_H

#include <glpk.h>

#ifndef KERN_GLPK_ROWS
#define KERN_GLPK_ROWS 96
#endif

/* The entries of column j, numbered from 1 as GLPK wants them. */
static int kern_glpk_column(const kern_program *lp, int j, int *row,
                            double *value)
{
    int n = 0, i, end;
    if (lp->ends) {
        for (end = 0; end < 2; end++) {
            const int g = lp->ends[end ? j | 1 : j & ~1];
            const kern_real *c = lp->a + 4 * (size_t)j;
            if (3 * g >= lp->rows)
                continue;
            for (i = 0; i < 3; i++) {
                n++;
                row[n] = 3 * g + i + 1;
                value[n] = (double)(end ? i == 2 ? c[3] : -c[i] : c[i]);
            }
        }
        return n;
    }
    for (i = 0; i < lp->rows; i++) {
        n++;
        row[n] = i + 1;
        value[n] = (double)lp->a[(size_t)j * (size_t)lp->rows + (size_t)i];
    }
    return n;
}

/* The program, with two elastic columns a row (rhs - A x = s - r, s, r >= 0)
   that keep it feasible. */
static glp_prob *kern_glpk_make(const kern_program *lp)
{
    glp_prob *p = glp_create_prob();
    const int most = lp->ends ? 6 : lp->rows;
    int *row = (int *)glp_alloc(most + 1, sizeof(int));
    double *value = (double *)glp_alloc(most + 1, sizeof(double));
    int i, j;
    glp_add_rows(p, lp->rows);
    glp_add_cols(p, lp->cols + 2 * lp->rows);
    for (i = 1; i <= lp->rows; i++)
        glp_set_row_bnds(p, i, GLP_FX, (double)lp->rhs[i - 1], 0.0);
    for (j = 0; j < lp->cols; j++) {
        const int n = kern_glpk_column(lp, j, row, value);
        glp_set_mat_col(p, j + 1, n, row, value);
        glp_set_col_bnds(p, j + 1, GLP_LO, 0.0, 0.0);
    }
    for (i = 0; i < 2 * lp->rows; i++) {
        row[1] = i / 2 + 1;
        value[1] = i % 2 ? -1.0 : 1.0;
        glp_set_mat_col(p, lp->cols + i + 1, 1, row, value);
        glp_set_col_bnds(p, lp->cols + i + 1, GLP_LO, 0.0, 0.0);
        glp_set_obj_coef(p, lp->cols + i + 1, 1.0);
    }
    glp_free(row);
    glp_free(value);
    return p;
}

/* Runs the primal simplex, with as many pivots as are left of the call's
   work. */
static int kern_glpk_run(glp_prob *p, const kern_program *lp)
{
    const int unit = 1 + (lp->rows + lp->cols) / 16; /* of work, for a pivot */
    const int left = (kern_limit_of(lp->limit) - lp->work->units) / unit;
    const int before = glp_get_it_cnt(p);
    glp_smcp how;
    int code;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_PRIMAL;
    how.presolve = GLP_OFF;
    how.tol_bnd = 1e-10;
    how.tol_dj = 1e-10;
    how.tol_piv = 1e-10;
    /* it can stall on programs as degenerate as these */
    how.it_lim = 200 + 5 * (lp->rows + lp->cols);
    how.it_lim = how.it_lim < left ? how.it_lim : left;
    code = glp_simplex(p, &how);
    kern_lp_spend(lp,
                  (glp_get_it_cnt(p) - before) * unit
                      + (code == GLP_EITLIM && how.it_lim == left ? unit : 0));
    return code == 0 ? glp_get_status(p) : GLP_UNDEF;
}

/* The direction in which an unbounded program falls: one variable rises, and
   the basic ones follow. */
static int kern_glpk_ray(glp_prob *p, const kern_program *lp, kern_real *x)
{
    const int k = glp_get_unbnd_ray(p);
    int *index;
    double *value;
    int i, n;
    if (k <= lp->rows || k > lp->rows + lp->cols)
        return 0;
    index = (int *)glp_alloc(lp->rows + 1, sizeof(int));
    value = (double *)glp_alloc(lp->rows + 1, sizeof(double));
    n = glp_eval_tab_col(p, k, index, value);
    for (i = 0; i < lp->cols; i++)
        x[i] = KERN_R(0);
    x[k - lp->rows - 1] = KERN_R(1);
    for (i = 1; i <= n; i++)
        if (index[i] > lp->rows && index[i] <= lp->rows + lp->cols)
            x[index[i] - lp->rows - 1] = (kern_real)value[i];
    glp_free(index);
    glp_free(value);
    return 1;
}

/* As kern_program_solve(). First the elastic columns are made as small as can
   be. If they cannot vanish the row prices are the certificate, turned round;
   if they can they are held at zero and the cost is minimised. */
static kern_status kern_lp_glpk(const kern_program *lp, kern_real *x,
                                kern_real *y)
{
    glp_prob *p = kern_glpk_make(lp);
    kern_status status = KERN_UNDECIDED;
    int i, code = kern_glpk_run(p, lp);
    double size = 0.0;
    for (i = 0; i < lp->rows; i++)
        size = size > (double)kern_abs(lp->rhs[i])
                 ? size
                 : (double)kern_abs(lp->rhs[i]);
    if (code == GLP_OPT)
        status = glp_get_obj_val(p) > 1e-11 * size ? KERN_LP_INFEASIBLE
                                                   : KERN_LP_OPTIMAL;
    if (status == KERN_LP_OPTIMAL && lp->cost) {
        for (i = 1; i <= 2 * lp->rows; i++) {
            glp_set_col_bnds(p, lp->cols + i, GLP_FX, 0.0, 0.0);
            glp_set_obj_coef(p, lp->cols + i, 0.0);
        }
        for (i = 1; i <= lp->cols; i++)
            glp_set_obj_coef(p, i, (double)lp->cost[i - 1]);
        code = kern_glpk_run(p, lp);
        status = code == GLP_OPT   ? KERN_LP_OPTIMAL
               : code == GLP_UNBND ? KERN_LP_UNBOUNDED
                                   : KERN_UNDECIDED;
    }
    for (i = 0; i < lp->cols; i++)
        x[i] = (kern_real)glp_get_col_prim(p, i + 1);
    for (i = 0; i < lp->rows; i++)
        y[i] = (kern_real)-glp_get_row_dual(p, i + 1);
    if (status == KERN_LP_UNBOUNDED && !kern_glpk_ray(p, lp, x))
        status = KERN_UNDECIDED;
    lp->work->pivots += glp_get_it_cnt(p);
    glp_delete_prob(p);
    return status;
}

#endif /* KERN_LP_H */
