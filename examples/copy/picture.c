/* Three stones of your own: do they stand, how safely, and how does it look?

       cc -O2 -o picture examples/copy/picture.c -lm && ./picture three.svg

   Two stones carry a third. The picture, written only where a name is given,
   is that of examples/parts/draw.h. Copy it with the program; both need no
   other file but kern.h. */

#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "../parts/draw.h"

#include <stdio.h>
#include <string.h>

enum { BLOCKS = 4, CONTACTS = KERN_CONTACTS(BLOCKS) };
enum {
    REALS = KERN_REALS(BLOCKS, CONTACTS),
    INTS = KERN_INTS(BLOCKS, CONTACTS)
}; /* of work memory */

static const kern_vec corner[BLOCKS][4] = {
    {{-3, -1}, {3, -1}, {3, 0}, {-3, 0}},
    {{-2, 0}, {-1, 0}, {-1, 1}, {-2, 1}},
    {{1, 0}, {2, 0}, {2, 1}, {1, 1}},
    {{-2, 1}, {5.2, 1}, {5.2, 1.5}, {-2, 1.5}},
};
static char ground[] = "ground", left[] = "left", right[] = "right",
            beam[] = "beam";
static char *const name[BLOCKS] = {ground, left, right, beam};

static kern_force force[CONTACTS];
static kern_motion motion[BLOCKS];

/* The task of the stones, with all memory that it needs. */
static kern_task stones_task(void)
{
    static kern_contact contact[CONTACTS];
    static kern_real reals[REALS];
    static int ints[INTS];
    static kern_block block[BLOCKS];
    static kern_work work;
    kern_task task;
    int i;

    work = kern_work_of(reals, REALS, ints, INTS);
    task = kern_task_of(block, BLOCKS, contact, 0, &work);
    kern_ground_init(&block[0], corner[0], 4, NULL);
    for (i = 1; i < BLOCKS; i++)
        kern_block_init(&block[i], corner[i], 4, 2400, NULL);
    task.s.contacts = kern_contacts(block, BLOCKS, &task.options, contact,
                                    CONTACTS, &work);
    return task;
}

static int draw(const kern_task *task, kern_status verdict, const char *path)
{
    struct draw_scene scene = {0};

    scene.s = &task->s;
    scene.names = name;
    scene.force = verdict == KERN_STANDS ? force : NULL;
    scene.motion = verdict == KERN_FALLS ? motion : NULL;
    scene.limiting = -1;
    scene.caption = kern_status_text(verdict);
    return draw_file(path, &scene);
}

int main(int argc, char **argv)
{
    kern_task task = stones_task();
    kern_proof proof = {force, motion};
    kern_status verdict;
    kern_margin m;

    verdict = kern_verdict(&task, 0, &proof);
    printf("%s\n", kern_status_text(verdict));
    if (verdict == KERN_STANDS)
        kern_forces(&task, 0, force); /* those of the proof are any */
    if (kern_measure(&task, &m, NULL) == KERN_STANDS)
        printf("level %d, margin %.3f m\n", m.level, m.margin);
    if (argc == 1 || verdict < 0)
        return verdict < 0;
    if (argc != 2 || !strstr(argv[1], ".svg")
        || draw(&task, verdict, argv[1])) {
        fputs("usage: picture [OUT.svg]\n", stderr);
        return 2;
    }
    return 0;
}

/* Output:
stands: forces were found that hold every block
level 16, margin 0.400 m
*/
