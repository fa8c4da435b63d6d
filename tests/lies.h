/* lies.h - GLPK as a liar: stands between GLPK and kern_lp.h.

   Include it before the implementation of kern.h, with KERN_USE_GLPK. The
   variable `lie` says what is falsified: numbers of the solution, prices (the
   certificate that there is none), the objective (by which kern_lp.h tells
   feasible from infeasible), the status, the direction of a ray, or any of them
   by chance. */

#ifndef LIES_H
#define LIES_H

#include "../examples/parts/random.h"

#include <glpk.h>
#include <stdint.h>

/* What is done to a number. */
enum {
    SCALED,
    SHIFTED,
    NEGATED,
    ZEROED,
    SWAPPED,
    NOT_A_NUMBER,
    INFINITE,
    FALSIFICATIONS
};

/* The lies: FALSIFICATIONS of the solution, then of the prices, then: */
enum {
    HONEST = -1,
    OF_SOLUTION = 0,
    OF_PRICES = FALSIFICATIONS,
    ALWAYS_FEASIBLE = 2 * FALSIFICATIONS,
    NEVER_FEASIBLE,
    ALWAYS_OPTIMAL,
    ALWAYS_UNBOUNDED,
    NEVER_DONE,
    WRONG_RAY,
    ANY_OF_THEM,
    LIES
};

static int lie = HONEST;
static long lies_told;

static int lie_random(int end)
{
    static uint64_t state = 1;
    return (int)(random_bits(&state) % (uint64_t)end);
}

/* Is this lie to be told now? */
static int lies_with(int kind)
{
    const int now = lie == kind || (lie == ANY_OF_THEM && lie_random(4) == 0);
    lies_told += now;
    return now;
}

static double falsified(double value, int how)
{
    volatile double big = 1e300;
    switch (how) {
    case SCALED: return value * 1.0001;
    case SHIFTED: return value + 1e-3 * (lie_random(100));
    case NEGATED: return lie_random(3) ? value : -value;
    case ZEROED: return 0;
    case SWAPPED: return lie_random(5);
    case NOT_A_NUMBER: return big * big - big * big;
    default: return big * big;
    }
}

static double lying_col_prim(glp_prob *p, int j)
{
    const double value = glp_get_col_prim(p, j);
    int how;
    for (how = 0; how < FALSIFICATIONS; how++)
        if (lies_with(OF_SOLUTION + how))
            return falsified(value, how);
    return value;
}

static double lying_row_dual(glp_prob *p, int i)
{
    const double value = glp_get_row_dual(p, i);
    int how;
    for (how = 0; how < FALSIFICATIONS; how++)
        if (lies_with(OF_PRICES + how))
            return falsified(value, how);
    return value;
}

static double lying_obj_val(glp_prob *p)
{
    if (lies_with(ALWAYS_FEASIBLE))
        return 0;
    return lies_with(NEVER_FEASIBLE) ? 1e9 : glp_get_obj_val(p);
}

static int lying_status(glp_prob *p)
{
    if (lies_with(ALWAYS_OPTIMAL))
        return GLP_OPT;
    if (lies_with(ALWAYS_UNBOUNDED))
        return GLP_UNBND;
    return lies_with(NEVER_DONE) ? GLP_UNDEF : glp_get_status(p);
}

static int lying_unbnd_ray(glp_prob *p)
{
    return lies_with(WRONG_RAY) ? lie_random(20) - 2 : glp_get_unbnd_ray(p);
}

/* Asked for a ray where there is none GLPK would end the process. */
static int lying_tab_col(glp_prob *p, int k, int index[], double value[])
{
    const int rows = glp_get_num_rows(p);
    const int basic = k <= rows ? glp_get_row_stat(p, k) == GLP_BS
                                : glp_get_col_stat(p, k - rows) == GLP_BS;
    return basic || !glp_bf_exists(p) ? 0
                                      : glp_eval_tab_col(p, k, index, value);
}

#define glp_get_col_prim lying_col_prim
#define glp_get_row_dual lying_row_dual
#define glp_get_obj_val lying_obj_val
#define glp_get_status lying_status
#define glp_get_unbnd_ray lying_unbnd_ray
#define glp_eval_tab_col lying_tab_col

#endif
