/* A plan from an empty ground to five stones: try, choose, add, remove.

       cc -O2 -o plan examples/copy/plan.c -lm

   Two stones stand on the ground, two on these, and one on both. For each stone
   there are four places, 0.1 m apart. kern_plan_try() returns the margin of the
   wall with the stone there, kern_plan_stays() the chance that the stone rests
   where it is put. The first place with the largest margin is taken if that
   chance is at least 1/2. At the end each stone is removed and put back: which of
   them could be taken away again? */

#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { STONES = 5, BLOCKS = STONES + 1, CONTACTS = KERN_CONTACTS(BLOCKS) };
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS),
    INTS = KERN_INTS(BLOCKS, CONTACTS)
}; /* of work memory */

static const double same = 0.001; /* margins that are one [m]                 */

/* Stones to be laid: their first place, height above ground, length, height. */
static const double stones[STONES][4] = {
    {0.0, 0.0, 1.0, 0.5},  {1.3, 0.0, 0.9, 0.6}, {0.2, 0.5, 0.7, 0.5},
    {1.55, 0.6, 0.8, 0.4}, {0.3, 1.0, 1.6, 0.4},
};

static const kern_vec ground[] = {{-2, -1}, {5, -1}, {5, 0}, {-2, 0}};
static kern_vec corner[BLOCKS][4]; /* vertices live as long as their plan     */
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_motion motion[BLOCKS]; /* of the last measure, with the forces:   */
static kern_force force[CONTACTS]; /* the next one starts from these          */
static kern_real reals[REALS];
static int ints[INTS];

/* Makes a stone at its k-th place. */
static kern_status make_stone(kern_block *out, int i, int k)
{
    const double left = stones[i][0] + 0.1 * k, right = left + stones[i][2];
    const double low = stones[i][1], high = low + stones[i][3];
    kern_vec *c = corner[i + 1];
    c[0].x = c[3].x = left;
    c[1].x = c[2].x = right;
    c[0].y = c[1].y = low;
    c[2].y = c[3].y = high;
    return kern_block_init(out, c, 4, 2400, NULL);
}

/* Tries a stone at its places. Returns the best of them, or -1 if there is
   none. Prints margin and chance of each. */
static int choose_place(kern_plan *plan, int i)
{
    kern_real most = 0;
    int k, best = -1;
    printf("stone %d:", i + 1);
    for (k = 0; k < 4; k++) {
        kern_block stone;
        kern_margin m = {0, 0, 0, 0, 0, 0, 0};
        kern_real chance = 0;
        if (make_stone(&stone, i, k) != KERN_OK
            || kern_plan_try(plan, &stone, &m, NULL) != KERN_STANDS
            || kern_plan_stays(plan, &stone, &chance) != KERN_STANDS) {
            printf("   falls     ");
            continue;
        }
        printf("   %.3f %.2f", m.margin, chance);
        if (chance >= 0.5 && m.margin > most + same) {
            most = m.margin;
            best = k;
        }
    }
    printf("   place %d\n", best + 1);
    return best;
}

/* Lays the stones one after the other. Returns 0 if one finds no place. */
static int build(kern_plan *plan)
{
    kern_block stone;
    kern_margin m = {0, 0, 0, 0, 0, 0, 0};
    int i, place;
    if (kern_ground_init(&stone, ground, 4, NULL) != KERN_OK
        || kern_plan_add(plan, &stone) < 0)
        return 0;
    for (i = 0; i < STONES; i++) {
        place = choose_place(plan, i);
        if (place < 0 || make_stone(&stone, i, place) != KERN_OK
            || kern_plan_add(plan, &stone) < 0
            || kern_measure(&plan->task, &m, NULL) != KERN_STANDS)
            return 0;
    }
    printf("the wall: level %d, margin %.3f m\n", m.level, m.margin);
    return 1;
}

/* Removes each stone and puts it back. The plan's first stone is always the one
   whose turn it is: what is added comes last. */
static void remove_each(kern_plan *plan)
{
    int i;
    for (i = 0; i < STONES; i++) {
        const kern_block stone = block[1];
        kern_margin m = {0, 0, 0, 0, 0, 0, 0};
        kern_plan_remove(plan, 1);
        if (kern_measure(&plan->task, &m, NULL) == KERN_STANDS)
            printf("without stone %d: margin %.3f m\n", i + 1, m.margin);
        else
            printf("without stone %d: falls\n", i + 1);
        kern_plan_add(plan, &stone);
    }
}

int main(void)
{
    kern_work work = kern_work_of(reals, REALS, ints, INTS);
    kern_plan plan = kern_plan_of(block, BLOCKS, contact, CONTACTS,
                                  kern_known_of(motion, force), &work);
    if (!build(&plan))
        return 1;
    remove_each(&plan);
    return 0;
}

/* Output:
stone 1:   0.500 1.00   0.500 1.00   0.500 1.00   0.500 1.00   place 1
stone 2:   0.500 1.00   0.500 1.00   0.500 1.00   0.500 1.00   place 1
stone 3:   0.479 1.00   0.438 1.00   0.250 1.00   0.150 1.00   place 1
stone 4:   0.250 1.00   0.150 1.00   0.050 1.00   falls        place 1
stone 5:   0.342 1.00   0.320 1.00   0.300 1.00   0.291 1.00   place 1
the wall: level 26, margin 0.342 m
without stone 1: falls
without stone 2: falls
without stone 3: falls
without stone 4: falls
without stone 5: margin 0.250 m
*/
