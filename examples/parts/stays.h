/* stays.h - the chance that a stone stays where it is let go, from statics.

   Three numbers are asked for: the sideways reserve of the structure with the
   stone (kern_raised()), and how far the stone itself is from falling in a
   progressive collapse (kern_profile()): under a horizontal load to its weaker
   side, and by its margin. The odds that it stays are

       9000 r^(3/2) l^(1/2) m^(1/4),   r = reserve + .004, .001: not raised,
                                       l = own load factor + .004, at most 10,
                                       m = own margin in mean sizes + .003

   a logistic law whose exponents were rounded so that square roots will do. It
   was fitted to 969 placements that stand, of 100 walls under construction, each
   let go six times in another simulator (tests/truth): 630 stay, 205 move, 134
   are unclear and count as not staying. Fitted on the walls of odd number and
   tested on those of even number, and the other way: area under the ROC curve of
   stays against moves .976 and .979 (reserve alone .973 and .971), where the
   wall below has a reserve of .0055 or more .978 and .983; where 95 % of what
   stays is kept, .92 and .91 of what moves and .74 and .70 of what is unclear is
   rejected. Calibration, in ten groups of equal number in the order of the
   chance: the mean chance and the share that stays differ by at most .046 on the
   data the law was fitted to; of a law fitted to one half, by up to .13 and .10
   on the other, in groups of about 48.

   SPDX-License-Identifier: MIT */

#ifndef STAYS_H
#define STAYS_H

#include <stddef.h>

#include "../../kern.h"

/* A square root, for programs without a C library too. */
#ifndef STAYS_SQRT
#include <math.h>
#define STAYS_SQRT(x) sqrt(x)
#endif

static inline double stays_least(double x, double y) { return x < y ? x : y; }

static inline double stays_chance(int raised, double reserve, double load,
                                  double margin)
{
    const double r = (raised ? reserve : -0.003) + 0.004;
    const double l = stays_least(load, 10) + 0.004;
    const double m = stays_least(margin, 1) + 0.003;
    const double odds = 9000 * r * STAYS_SQRT(r) * STAYS_SQRT(l) *
                        STAYS_SQRT(STAYS_SQRT(m));
    return odds / (1 + odds);
}

/* The chance of block i, laid last. KERN_STANDS: *chance, 0 where a part hangs;
   else what the questions return; KERN_FALLS: nothing is written. `value` has
   room for a number a block. Gravity is needed. Cost: that of a reserve and of
   three profiles. */
static inline kern_status stays_of(const kern_task *task, int i,
                                   kern_real *value, double *chance)
{
    static const kern_side side[] = { KERN_SHRINK, KERN_LEFT, KERN_RIGHT };
    double own[3];
    kern_raising raising = KERN_NOT_SHOWN;
    kern_real reserve = 0;
    kern_collapse all;
    kern_status status = kern_raised(task, 0, &raising, &reserve, NULL);
    for (int k = 0; k < 3 && status == KERN_STANDS; k++) {
        kern_status told = kern_profile(task, side[k], value, &all);
        own[k] = (double)value[i];
        if (told < 0) status = told;
    }
    if (status == KERN_STANDS)
        *chance = raising == KERN_HANGS ? 0 : stays_chance(
            raising == KERN_RAISED, (double)reserve,
            stays_least(own[1], own[2]),
            own[0] / (double)kern_mean_size(task->s.block, task->s.blocks));
    return status;
}

#endif /* STAYS_H */
