/* cc -O2 -ffp-contract=off -o levels tests/levels.c -lm && ./levels 10000

   Seed, status, level, contact points of random structures, a line each, and
   whether the margin ends where a kern closes. Built in double and with
   -DKERN_SINGLE, the two outputs are compared by tests/levels.sh. */

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "structures.h"

/* Does a kern close where the margin ends? Then the load passes through what
   was left of it, within the tolerance or not. */
static int closes(const kern_margin *m)
{
    const kern_real same = kern_mean_size(block, s.blocks) / 1000;
    int k;
    for (k = 0; k < s.contacts; k++)
        if (kern_abs(kern_abs(contact[k].travel) - m->margin) < same)
            return 1;
    return 0;
}

int main(int argc, char **argv)
{
    const int many = argc > 1 ? atoi(argv[1]) : 1000;
    int seed;
    for (seed = 1; seed <= many; seed++) {
        kern_work work = whole_work();
        kern_margin m;
        kern_status got;
        memset(&m, 0, sizeof m);
        random_structure(seed, 14, &work);
        got = s.contacts < 0 ? (kern_status)s.contacts
                             : kern_measure(task_of(&work), &m, NULL);
        printf("%d %d %d %d %d\n", seed, (int)got, m.level, s.contacts,
               closes(&m));
    }
    return 0;
}
