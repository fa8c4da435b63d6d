/* How does a tower lose its stability as its top stone slides out?

       cc -O2 -o tower examples/copy/tower.c -lm

   Five cubes of 1 m stand on each other. The top one moves to the right,
   and contacts and verdict are found anew each time. The margin is 0.5 m
   less the offset, and the level counts the steps of 0.02 m up to the first
   at which the tower no longer stands. */

#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { STONES = 5, BLOCKS = STONES + 1, CONTACTS = 2 * STONES + 8 };
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS),
    INTS = KERN_INTS(BLOCKS, CONTACTS)
}; /* of work memory */

static const double offset[] = {0, 0.05, 0.15, 0.25, 0.35, 0.45, 0.55};

static kern_vec corner[BLOCKS][4];
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_real reals[REALS];
static int ints[INTS];

/* Makes block i a box: a stone, or with density 0 the ground. */
static kern_status put(int i, double x, double y, double w, double h,
                       double density)
{
    kern_vec *c = corner[i];

    c[0].x = c[3].x = x;
    c[1].x = c[2].x = x + w;
    c[0].y = c[1].y = y;
    c[2].y = c[3].y = y + h;
    return density > 0 ? kern_block_init(&block[i], c, 4, density, NULL)
                       : kern_ground_init(&block[i], c, 4, NULL);
}

int main(void)
{
    kern_work work = kern_work_of(reals, REALS, ints, INTS);
    kern_task task = kern_task_of(block, BLOCKS, contact, 0, &work);
    kern_margin m;
    int i, step;

    put(0, -5, -1, 11, 1, 0);
    for (i = 1; i < BLOCKS; i++)
        put(i, 0, i - 1, 1, 1, 2400);
    printf("offset   level  margin\n");
    for (step = 0; step < 7; step++) {
        put(STONES, offset[step], STONES - 1, 1, 1, 2400);
        task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                        CONTACTS, &work);
        if (task.s.contacts < 0) {
            printf("%s\n", kern_status_text((kern_status)task.s.contacts));
            return 1;
        }
        switch (kern_measure(&task, &m, NULL)) {
        case KERN_STANDS:
            printf("%4.2f m  %5d  %.3f m%s\n", offset[step], m.level, m.margin,
                   m.saturated ? ", every kern closed" : "");
            break;
        case KERN_FALLS: printf("%4.2f m  falls\n", offset[step]); break;
        default: printf("%4.2f m  undecided\n", offset[step]); break;
        }
    }
    return 0;
}

/* Output:
offset   level  margin
0.00 m     26  0.500 m, every kern closed
0.05 m     23  0.450 m
0.15 m     18  0.350 m
0.25 m     13  0.250 m
0.35 m      8  0.150 m
0.45 m      3  0.050 m
0.55 m  falls
*/
