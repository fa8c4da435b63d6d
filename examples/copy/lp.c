/* What can the LP solver do alone? Minimise a cost, and prove infeasibility.

       cc -O2 -o lp examples/copy/lp.c -lm

   A program is minimise cost.x where A x = rhs, x >= 0, with A given column
   by column. An inequality gets a column of its own that takes the slack.
   In the prices lies the proof that nothing is cheaper, in the last line
   the proof that the second program has no solution. */

#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { ROWS = 2, COLS = 4 };

static kern_real reals[KERN_LP_REALS(ROWS, COLS)];
static int ints[KERN_LP_INTS(ROWS, COLS)];

int main(void)
{
    /* Rubble at 3 and ashlar at 5 a ton: at least 10 tons in all, and at least
       4 of ashlar.    x0 + x1 - x2 = 10,   x1 - x3 = 4 */
    static const kern_real a[COLS * ROWS] = {1, 0, 1, 1, -1, 0, 0, -1};
    static const kern_real rhs[ROWS] = {10, 4};
    static const kern_real cost[COLS] = {3, 5, 0, 0};

    /* Two numbers whose difference is 1, and is 2. */
    static const kern_real b[2 * ROWS] = {1, 1, -1, -1};
    static const kern_real difference[ROWS] = {1, 2};

    kern_work work = kern_work_of(reals, KERN_LP_REALS(ROWS, COLS), ints,
                                  KERN_LP_INTS(ROWS, COLS));
    kern_real x[COLS], y[ROWS];
    kern_lp lp = {ROWS, COLS, a, rhs, cost, 0};
    kern_lp impossible = {ROWS, 2, b, difference, NULL, 0};

    if (kern_lp_solve(&lp, x, y, &work) == KERN_LP_OPTIMAL) {
        printf("rubble %g t, ashlar %g t, cost %g\n", x[0], x[1],
               3 * x[0] + 5 * x[1]);
        printf("prices: one ton more in all %g, of ashlar %g\n", y[0], y[1]);
    }
    if (kern_lp_solve(&impossible, x, y, &work) == KERN_LP_INFEASIBLE) {
        kern_real sum = -(y[0] * difference[0] + y[1] * difference[1]);

        y[0] /= sum; /* a proof may have any length */
        y[1] /= sum;
        printf("no solution: the rows times %g and %g add up to\n", y[0], y[1]);
        printf("%g x0 + %g x1 = -1, which no x >= 0 can be\n",
               y[0] * b[0] + y[1] * b[1], y[0] * b[2] + y[1] * b[3]);
    }
    return 0;
}

/* Output:
rubble 6 t, ashlar 4 t, cost 38
prices: one ton more in all 3, of ashlar 2
no solution: the rows times 1 and -1 add up to
0 x0 + 0 x1 = -1, which no x >= 0 can be
*/
