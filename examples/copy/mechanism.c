/* Why does it fall? The proof of a fall is the motion of every block.

       cc -O2 -o mechanism examples/copy/mechanism.c -lm

   A beam rests on a fixed pier and reaches out too far. A stone on its short
   end should hold it down, and is too light: beam and stone turn as one about
   the corner (1, 2) of the pier. Rates are scaled: the largest, here the
   beam's spin times its size, is 1. Work memory is allocated at run time. */

#include <stdio.h>
#include <stdlib.h>

#define KERN_IMPLEMENTATION
#include "../../kern.h"

enum { BLOCKS = 3, CONTACTS = 12 };

static const kern_vec corner[BLOCKS][4] = {
    {{0, 0}, {1, 0}, {1, 2}, {0, 2}},             /* pier  */
    {{0, 2}, {4, 2}, {4, 2.5}, {0, 2.5}},         /* beam  */
    {{0, 2.5}, {0.8, 2.5}, {0.8, 3.5}, {0, 3.5}}, /* stone */
};
static const char *const name[BLOCKS] = {"pier", "beam", "stone"};

static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_motion motion[BLOCKS];

/* Finds the contacts, asks for the verdict, prints it with its proof. */
static kern_status explain(kern_work *work)
{
    kern_task task = kern_task_of(block, BLOCKS, contact, 0, work);
    kern_proof proof = {NULL, motion};
    kern_real deficit;
    kern_status status;
    int i;

    task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                    CONTACTS, work);
    status = kern_verdict(&task, 0, &proof);
    printf("%s\n", kern_status_text(status));
    if (status != KERN_FALLS)
        return status;
    for (i = 1; i < BLOCKS; i++)
        printf("%-6s vx %6.3f  vy %6.3f  spin %6.3f\n", name[i], motion[i].vx,
               motion[i].vy, motion[i].spin);
    if (kern_deficit(&task, &deficit) == KERN_FALLS)
        printf("contacts longer by %.3f m at each end would hold it\n",
               deficit);
    return status;
}

int main(void)
{
    int i, reals, ints;
    kern_real *real;
    int *index;
    kern_work work;
    kern_status status = KERN_NO_SPACE;

    kern_work_need(BLOCKS, CONTACTS, &reals, &ints);
    real = (kern_real *)malloc((size_t)reals * sizeof *real);
    index = (int *)malloc((size_t)ints * sizeof *index);
    work = kern_work_of(real, reals, index, ints);
    kern_ground_init(&block[0], corner[0], 4, NULL);
    for (i = 1; i < BLOCKS; i++)
        kern_block_init(&block[i], corner[i], 4, 2400, NULL);
    if (real && index)
        status = explain(&work);
    free(real);
    free(index);
    return status == KERN_FALLS ? 0 : 1;
}

/* Output:
falls: a motion was found that no forces can stop
beam   vx  0.177  vy -0.707  spin -0.707
stone  vx  0.707  vy  0.424  spin -0.707
contacts longer by 0.543 m at each end would hold it
*/
