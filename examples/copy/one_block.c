/* Does a block stand on the ground, and how safely?

       cc -O2 -o one_block examples/copy/one_block.c -lm

   The smallest complete program: two polygons, their contacts, the verdict.
   All memory is static, sized by macros, as firmware wants it. The centre
   of the stone is 0.5 m from the end of its base. */

#include <stdio.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { BLOCKS = 2, CONTACTS = 8 }; /* with room for a few more than needed */
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS),
    INTS = KERN_INTS(BLOCKS, CONTACTS)
}; /* of work memory */

static const kern_vec ground[] = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
static const kern_vec stone[] = {{0, 0}, {2, 0}, {3, 1.5}, {1, 1.5}};

static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_real reals[REALS];
static int ints[INTS];

int main(void)
{
    kern_work work = kern_work_of(reals, REALS, ints, INTS);
    kern_task task = kern_task_of(block, BLOCKS, contact, 0, &work);
    kern_margin m;
    kern_status status;

    status = kern_ground_init(&block[0], ground, 4, NULL);
    if (status == KERN_OK)
        status = kern_block_init(&block[1], stone, 4, 2400, NULL);
    if (status == KERN_OK) {
        task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                        CONTACTS, &work);
        status = kern_measure(&task, &m, NULL); /* refuses a bad count */
    }
    printf("%s\n", kern_status_text(status));
    if (status == KERN_STANDS)
        printf("%d contact points, level %d, margin %.3f m\n", task.s.contacts,
               m.level, m.margin);
    return status == KERN_STANDS ? 0 : 1;
}

/* Output:
stands: forces were found that hold every block
2 contact points, level 15, margin 0.500 m
*/
