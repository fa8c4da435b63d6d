/* Where should the next stone go? From an empty ground to a wall of found stones.

       cc -O2 -o best_place examples/copy/best_place.c -lm

   Every stone is let down at 100 places: kern_rest() finds where it comes to
   rest, kern_plan_try() the margin of the wall with it, kern_plan_stays() the
   chance that it stays when it is let go. kern_place_compare() ranks the places:
   first the chance, since the margin of a wall is that of its weakest stone and
   half of all places leave it as it is. The same places in any order give the
   same best place. */

#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { STONES = 6, CORNERS = 5, PLACES = 100 };
enum { BLOCKS = STONES + 1, CONTACTS = KERN_CONTACTS(BLOCKS) };

/* Of the stones, in the order in which they are laid [m]. */
static const kern_vec outline[STONES][CORNERS] = {
    {{0, 0}, {1.2, 0.1}, {1.3, 0.5}, {0.7, 0.7}, {0, 0.5}},
    {{0, 0}, {0.9, -0.1}, {1, 0.4}, {0.5, 0.5}, {0.1, 0.4}},
    {{0, 0}, {1.1, 0}, {1, 0.5}, {0.4, 0.6}, {-0.1, 0.3}},
    {{0, 0}, {0.8, 0.1}, {0.9, 0.4}, {0.4, 0.5}, {0, 0.4}},
    {{0, 0}, {1, -0.1}, {1.2, 0.3}, {0.6, 0.5}, {0.1, 0.4}},
    {{0, 0}, {0.7, 0}, {0.8, 0.3}, {0.3, 0.4}, {-0.1, 0.2}},
};
static const kern_vec ground[] = {{-1, -1}, {4, -1}, {4, 0}, {-1, 0}};
static const kern_vec upright = {1, 0}; /* cosine and sine of a turn of 0     */

static kern_vec corner[STONES]
                      [CORNERS]; /* vertices live as long as their plan */
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_motion motion[BLOCKS]; /* of the last measure, with the forces:   */
static kern_force force[CONTACTS]; /* the next one starts from these          */
static kern_real reals[KERN_REALS(BLOCKS, CONTACTS)];
static int ints[KERN_INTS(BLOCKS, CONTACTS)];

/* Finds where a stone is best let down with its centre at x = low to high.
   Returns 0 if the wall stands with it nowhere. */
static int best_place(kern_plan *wall, const kern_block *stone, double low,
                      double high, kern_place *best)
{
    kern_vec vertex[CORNERS];
    kern_pose pose;
    kern_margin alone = {0, 0, 0, 0, 0, 0, 0}, m = alone;
    int i, found = 0;

    /* once: every try starts from it; bare ground has no margin */
    if (kern_measure(&wall->task, &alone, NULL) != KERN_STANDS)
        alone.margin = 0;

    /* The most expensive test comes last, for what could still be the best. */
    for (i = 0; i < PLACES; i++) {
        kern_place place = {1, 0, 0, 0, 0, 0};
        place.x = low + (high - low) * (i + 0.5) / PLACES;
        if (kern_rest(&wall->task, stone, place.x, upright, vertex, &pose)
                != KERN_OK
            || kern_plan_try(wall, &pose.block, &m, NULL) != KERN_STANDS)
            continue;
        place.margin = m.margin;
        if (kern_place_compare(&place, found ? best : NULL, alone.margin) > 0
            && kern_plan_stays(wall, &pose.block, &place.stays) == KERN_STANDS
            && kern_place_compare(&place, found ? best : NULL, alone.margin)
                   > 0) {
            *best = place;
            found = 1;
        }
    }
    return found;
}

/* Lays stone i where it is best. Returns 0 if there is no such place. */
static int lay(kern_plan *wall, int i)
{
    kern_block stone;
    kern_place best;
    kern_pose pose;
    if (kern_block_init(&stone, outline[i], CORNERS, 2400, NULL) != KERN_OK
        || !best_place(wall, &stone, 0, 3, &best)
        || kern_rest(&wall->task, &stone, best.x, upright, corner[i], &pose)
               != KERN_OK
        || kern_plan_add(wall, &pose.block) < 0)
        return 0;
    printf("stone %d at x = %.3f, y = %.3f, turned by %.3f: stays %.3f, "
           "margin %.3f m\n",
           i + 1, pose.block.centre.x, pose.block.centre.y, pose.turn.y,
           best.stays, best.margin);
    return 1;
}

int main(void)
{
    kern_work work = kern_work_of(reals, KERN_REALS(BLOCKS, CONTACTS), ints,
                                  KERN_INTS(BLOCKS, CONTACTS));
    kern_plan wall = kern_plan_of(block, BLOCKS, contact, CONTACTS,
                                  kern_known_of(motion, force), &work);
    kern_block base;
    int i;
    if (kern_ground_init(&base, ground, 4, NULL) != KERN_OK
        || kern_plan_add(&wall, &base) < 0)
        return 1;
    for (i = 0; i < STONES; i++)
        if (!lay(&wall, i))
            return 1;
    return 0;
}

/* Output:
stone 1 at x = 0.040, y = 0.280, turned by -0.083: stays 1.000, margin 0.565 m
stone 2 at x = 0.993, y = 0.481, turned by -0.704: stays 0.997, margin 0.579 m
stone 3 at x = 0.231, y = 0.986, turned by 0.322: stays 0.995, margin 0.602 m
stone 4 at x = 1.631, y = 0.422, turned by -0.921: stays 0.997, margin 0.602 m
stone 5 at x = 1.209, y = 1.235, turned by -0.508: stays 0.972, margin 0.602 m
stone 6 at x = -0.736, y = 0.459, turned by 0.997: stays 0.999, margin 0.602 m
*/
