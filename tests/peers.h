/* peers.h - the linear program of a structure, from the equations, and general
   solvers that it is given to: GLPK with -DBENCH_GLPK, Clp with -DBENCH_CLP,
   DAQP with -DBENCH_DAQP, OSQP with -DBENCH_OSQP, or none. Nothing here is taken
   from kern.h but its types:

       A(d) x = -w, x >= 0    three rows a free block, two columns a contact
                              point; lengths in mean block sizes, forces in
                              mean weights; torques about each block's centre

   SPDX-License-Identifier: MIT */

#ifndef PEERS_H
#define PEERS_H

#include "scenes.h"

#ifdef BENCH_GLPK
#include <glpk.h>
#endif
#ifdef BENCH_CLP
#include <coin/Clp_C_Interface.h>
#endif
#ifdef BENCH_DAQP
#include <api.h>
#endif
#ifdef BENCH_OSQP
#include <osqp.h>
#endif

/* ---- The linear program -------------------------------------------------- */

struct program {
    const struct scene *scene;
    int rows, cols;
    int *first; /* first row of each block, -1 of fixed ones       */
    int *start; /* of each column in row and value; start[cols]    */
    int *row;
    double *value;
    double *rhs;
    double length, weight; /* units                                           */
    double shrink;         /* at which the entries are                        */
};

/* One end of a column: what the unit force f at p does to a block. Solvers drop
   zeros, and a torque of 0 may be another number at another shrinkage: such an
   entry gets a number that solvers keep, and that changes nothing. */
static inline int program_end(const struct program *lp, int block, kern_vec f,
                              kern_vec p, double sign, int at)
{
    const kern_vec c = lp->scene->block[block].centre;
    const double value[3] = {sign * f.x, sign * f.y,
                             sign * ((p.x - c.x) * f.y - (p.y - c.y) * f.x)
                                 / lp->length};
    int i;
    if (lp->first[block] < 0)
        return at;
    for (i = 0; i < 3; i++) {
        lp->value[at + i] = fabs(value[i]) < 1e-15 ? 1e-15 : value[i];
        lp->row[at + i] = lp->first[block] + i;
    }
    return at + 3;
}

/* Writes all columns for a shrinkage; the pattern is always the same. */
static inline void program_shrink(struct program *lp, double shrink)
{
    const struct scene *scene = lp->scene;
    int i, side, at = 0, col = 0;
    for (i = 0; i < scene->contacts; i++) {
        const kern_contact *c = &scene->contact[i];
        const double way = fmin(fabs(c->travel), shrink)
                         * (c->travel < 0 ? -1 : 1);
        const kern_vec p = vec(c->p.x - way * c->n.y, c->p.y + way * c->n.x);
        for (side = -1; side <= 1; side += 2) {
            const kern_vec f = vec(c->n.x - side * c->mu * c->n.y,
                                   c->n.y + side * c->mu * c->n.x);
            lp->start[col++] = at;
            at = program_end(lp, c->b, f, p, 1, at);
            at = program_end(lp, c->a, f, p, -1, at);
        }
    }
    lp->start[col] = at;
    lp->shrink = shrink;
}

/* What the contacts must bear of a block. */
static inline void program_load(const struct program *lp, const kern_block *b,
                                double *rhs)
{
    rhs[0] = -(b->mass * lp->scene->gravity.x + b->load.fx) / lp->weight;
    rhs[1] = -(b->mass * lp->scene->gravity.y + b->load.fy) / lp->weight;
    rhs[2] = -b->load.torque / (lp->weight * lp->length);
}

static inline void program_open(struct program *lp, const struct scene *scene)
{
    const size_t cols = 2 * (size_t)scene->contacts;
    double mass = 0;
    int i;
    lp->scene = scene;
    lp->rows = 0;
    lp->cols = (int)cols;
    lp->first = room_for((size_t)scene->blocks, sizeof(int));
    lp->start = room_for(cols + 1, sizeof(int));
    lp->row = room_for(6 * cols, sizeof(int));
    lp->value = room_for(6 * cols, sizeof(double));
    lp->rhs = room_for(3 * (size_t)scene->blocks, sizeof(double));
    for (i = 0; i < scene->blocks; i++) {
        lp->first[i] = scene->block[i].fixed ? -1 : lp->rows;
        lp->rows += scene->block[i].fixed ? 0 : 3;
        mass += scene->block[i].fixed ? 0 : scene->block[i].mass;
    }
    lp->length = kern_mean_size(scene->block, scene->blocks);
    if (!(lp->length > 0))
        lp->length = 1; /* no block has a shape                            */
    lp->weight = mass * hypot(scene->gravity.x, scene->gravity.y)
               / (lp->rows / 3);
    for (i = 0; i < scene->blocks; i++)
        if (lp->first[i] >= 0)
            program_load(lp, &scene->block[i], lp->rhs + lp->first[i]);
    program_shrink(lp, 0);
}

static inline void program_close(struct program *lp)
{
    free(lp->first);
    free(lp->start);
    free(lp->row);
    free(lp->value);
    free(lp->rhs);
}

/* ---- Solvers ------------------------------------------------------------- */

#ifdef BENCH_GLPK

static inline void glpk_change(void *model, const struct program *lp)
{
    int row[7], j, k;
    for (j = 0; j < lp->cols; j++) {
        const int n = lp->start[j + 1] - lp->start[j];
        for (k = 0; k < n; k++)
            row[k + 1] = lp->row[lp->start[j] + k] + 1;
        glp_set_mat_col(model, j + 1, n, row, lp->value + lp->start[j] - 1);
    }
}

static inline void *glpk_open(const struct program *lp)
{
    glp_prob *p = glp_create_prob();
    int i, j;
    glp_add_rows(p, lp->rows);
    glp_add_cols(p, lp->cols);
    for (i = 0; i < lp->rows; i++)
        glp_set_row_bnds(p, i + 1, GLP_FX, lp->rhs[i], 0);
    for (j = 0; j < lp->cols; j++)
        glp_set_col_bnds(p, j + 1, GLP_LO, 0, 0);
    glpk_change(p, lp);
    glp_std_basis(p);
    return p;
}

/* Where two points of a contact coincide the last basis may be singular. That
   is an error and no answer: it starts again from the slacks. */
static inline int glpk_solve(void *model)
{
    glp_smcp how;
    int status;
    glp_init_smcp(&how);
    how.msg_lev = GLP_MSG_OFF;
    how.meth = GLP_DUAL;
    how.pricing = GLP_PT_STD; /* some 10 % faster here than the default       */
    if (glp_simplex(model, &how)) {
        glp_std_basis(model);
        if (glp_simplex(model, &how))
            return -1;
    }
    status = glp_get_status(model);
    return status == GLP_OPT ? 1 : status == GLP_NOFEAS ? 0 : -1;
}

static inline void glpk_close(void *model) { glp_delete_prob(model); }

#endif
#ifdef BENCH_CLP

/* Writes into the matrix itself: the door for single entries searches the
   column for each. It is used once, to tell Clp that there was a change. */
static inline void clp_change(void *model, const struct program *lp)
{
    memcpy((void *)Clp_getElements(model), lp->value,
           (size_t)lp->start[lp->cols] * sizeof(double));
    Clp_modifyCoefficient(model, lp->row[0], 0, lp->value[0], 1);
}

static inline void *clp_open(const struct program *lp)
{
    Clp_Simplex *p = Clp_newModel();
    Clp_setLogLevel(p, 0);
    Clp_loadProblem(p, lp->cols, lp->rows, lp->start, lp->row, lp->value, NULL,
                    NULL, NULL, lp->rhs, lp->rhs);
    return p;
}

static inline int clp_solve(void *model)
{
    const int failed = Clp_dual(model, 0);
    const int status = Clp_status(model);
    if (failed < 0)
        return -1;
    return status == 0 ? 1 : status == 1 ? 0 : -1;
}

static inline void clp_close(void *model) { Clp_deleteModel(model); }

#endif
#ifdef BENCH_DAQP

/* The least-norm forces: bounds of the columns first, then dense rows. */
struct daqp {
    DAQPProblem problem;
    DAQPSettings settings;
    DAQPResult result;
};

static inline void daqp_change(void *model, const struct program *lp)
{
    const DAQPProblem *p = &((struct daqp *)model)->problem;
    int j, k;
    for (k = 0; k < lp->rows * lp->cols; k++)
        p->A[k] = 0;
    for (j = 0; j < lp->cols; j++)
        for (k = lp->start[j]; k < lp->start[j + 1]; k++)
            p->A[lp->row[k] * lp->cols + j] = lp->value[k];
}

static inline void *daqp_open(const struct program *lp)
{
    struct daqp *daqp = room_for(1, sizeof *daqp);
    DAQPProblem *p = &daqp->problem;
    const size_t rows = (size_t)lp->rows, cols = (size_t)lp->cols;
    size_t i;
    memset(daqp, 0, sizeof *daqp);
    p->n = p->ms = lp->cols;
    p->m = lp->cols + lp->rows;
    p->A = room_for(rows * cols, sizeof(double));
    p->blower = room_for(cols + rows, sizeof(double));
    p->bupper = room_for(cols + rows, sizeof(double));
    for (i = 0; i < cols + rows; i++) {
        p->blower[i] = i < cols ? 0 : lp->rhs[i - cols];
        p->bupper[i] = i < cols ? DAQP_INF : lp->rhs[i - cols];
    }
    p->sense = room_for(cols + rows, sizeof(int));
    daqp->result.x = room_for(cols, sizeof(double));
    daqp->result.lam = room_for(cols + rows, sizeof(double));
    daqp_default_settings(&daqp->settings);
    daqp_change(daqp, lp);
    return daqp;
}

/* Begins from nothing each time: DAQP factors while it reads the matrix. It
   marks rows in `sense`, which is cleared first. */
static inline int daqp_answer(void *model)
{
    struct daqp *daqp = model;
    memset(daqp->problem.sense, 0, (size_t)daqp->problem.m * sizeof(int));
    daqp_quadprog(&daqp->result, &daqp->problem, &daqp->settings);
    return daqp->result.exitflag == DAQP_EXIT_OPTIMAL    ? 1
         : daqp->result.exitflag == DAQP_EXIT_INFEASIBLE ? 0
                                                         : -1;
}

static inline void daqp_close(void *model)
{
    struct daqp *daqp = model;
    free(daqp->problem.A);
    free(daqp->problem.blower);
    free(daqp->problem.bupper);
    free(daqp->problem.sense);
    free(daqp->result.x);
    free(daqp->result.lam);
    free(daqp);
}

#endif

#ifdef BENCH_OSQP

/* The least-norm forces: the rows of equilibrium first, then one for each
   column, which is not below 0. */
struct osqp {
    OSQPFloat *norm, *value, *cost, *low, *high;
    OSQPInt *norm_row, *norm_start, *row, *start;
    int rows, cols;
    OSQPSettings *settings;
};

/* Writes the entries of a column by rows, then the one of its bound. */
static inline void osqp_column(struct osqp *osqp, const struct program *lp,
                               int j)
{
    const int from = lp->start[j];
    const OSQPInt at = from + j;
    OSQPInt end = at, i;
    int k;
    for (k = from; k < lp->start[j + 1]; k++) {
        for (i = end; i > at && osqp->row[i - 1] > lp->row[k]; i--) {
            osqp->row[i] = osqp->row[i - 1];
            osqp->value[i] = osqp->value[i - 1];
        }
        osqp->row[i] = lp->row[k];
        osqp->value[i] = lp->value[k];
        end++;
    }
    osqp->row[end] = lp->rows + j;
    osqp->value[end] = 1;
    osqp->start[j + 1] = end + 1;
}

static inline void osqp_change(void *model, const struct program *lp)
{
    int j;
    for (j = 0; j < lp->cols; j++)
        osqp_column(model, lp, j);
}

static inline void *osqp_open(const struct program *lp)
{
    struct osqp *osqp = room_for(1, sizeof *osqp);
    const size_t cols = (size_t)lp->cols, all = cols + (size_t)lp->rows;
    const size_t entries = cols + (size_t)lp->start[lp->cols];
    size_t i;
    osqp->rows = lp->rows;
    osqp->cols = lp->cols;
    osqp->norm = room_for(cols, sizeof *osqp->norm);
    osqp->norm_row = room_for(cols, sizeof *osqp->norm_row);
    osqp->norm_start = room_for(cols + 1, sizeof *osqp->norm_start);
    osqp->cost = room_for(cols, sizeof *osqp->cost);
    for (i = 0; i < cols; i++) {
        osqp->norm[i] = 1;
        osqp->cost[i] = 0;
        osqp->norm_row[i] = osqp->norm_start[i] = (OSQPInt)i;
    }
    osqp->norm_start[cols] = (OSQPInt)cols;
    osqp->low = room_for(all, sizeof *osqp->low);
    osqp->high = room_for(all, sizeof *osqp->high);
    for (i = 0; i < all; i++) {
        osqp->low[i] = i < (size_t)lp->rows ? lp->rhs[i] : 0;
        osqp->high[i] = i < (size_t)lp->rows ? lp->rhs[i] : OSQP_INFTY;
    }
    osqp->value = room_for(entries, sizeof *osqp->value);
    osqp->row = room_for(entries, sizeof *osqp->row);
    osqp->start = room_for(cols + 1, sizeof *osqp->start);
    osqp->start[0] = 0;
    osqp->settings = OSQPSettings_new();
    osqp->settings->verbose = 0;
    osqp->settings->eps_abs = osqp->settings->eps_rel = 1e-6;
    osqp->settings->eps_prim_inf = 1e-6;
    osqp_change(osqp, lp);
    return osqp;
}

/* Begins from nothing each time, with the factorisation: a solver that is kept
   factors a changed matrix again. */
static inline int osqp_answer(void *model)
{
    struct osqp *osqp = model;
    const OSQPInt n = osqp->cols, m = osqp->rows + n;
    OSQPCscMatrix *P = OSQPCscMatrix_new(n, n, n, osqp->norm, osqp->norm_row,
                                         osqp->norm_start);
    OSQPCscMatrix *A = OSQPCscMatrix_new(m, n, osqp->start[n], osqp->value,
                                         osqp->row, osqp->start);
    OSQPSolver *solver = NULL;
    OSQPInt status = 0;
    if (!osqp_setup(&solver, P, osqp->cost, A, osqp->low, osqp->high, m, n,
                    osqp->settings)
        && !osqp_solve(solver))
        status = solver->info->status_val;
    osqp_cleanup(solver);
    OSQPCscMatrix_free(A);
    OSQPCscMatrix_free(P);
    return status == OSQP_SOLVED            ? 1
         : status == OSQP_PRIMAL_INFEASIBLE ? 0
                                            : -1;
}

static inline void osqp_close(void *model)
{
    struct osqp *osqp = model;
    free(osqp->norm);
    free(osqp->norm_row);
    free(osqp->norm_start);
    free(osqp->cost);
    free(osqp->low);
    free(osqp->high);
    free(osqp->value);
    free(osqp->row);
    free(osqp->start);
    OSQPSettings_free(osqp->settings);
    free(osqp);
}

#endif

/* A solver: a model made of a program, with the basis of slacks; its solve from
   the basis at hand (the quadratic ones keep none), 1 feasible, 0 infeasible,
   -1 no answer; and new entries in the same places. Answers of a simplex must
   agree with those of kern.h; wrong ones of a quadratic solver are counted, and
   its times are in a table of their own. */
static const struct peer {
    const char *name;
    int number;     /* 0 GLPK, 1 Clp, 2 DAQP, 3 OSQP                   */
    int most;       /* largest structures that it is asked about       */
    int is_simplex; /* else it solves quadratic programs               */
    void *(*open)(const struct program *lp);
    void (*change)(void *model, const struct program *lp);
    int (*solve)(void *model);
    void (*close)(void *model);
} peers[] = {
#ifdef BENCH_GLPK
    {"GLPK", 0, 200, 1, glpk_open, glpk_change, glpk_solve, glpk_close},
#endif
#ifdef BENCH_CLP
    {"Clp", 1, 2000, 1, clp_open, clp_change, clp_solve, clp_close},
#endif
#ifdef BENCH_DAQP
    {"DAQP", 2, 50, 0, daqp_open, daqp_change, daqp_answer, daqp_close},
#endif
#ifdef BENCH_OSQP
    {"OSQP", 3, 200, 0, osqp_open, osqp_change, osqp_answer, osqp_close},
#endif
    {NULL, 0, 0, 0, NULL, NULL, NULL, NULL},
};

#endif
