/* cc -O2 -ffp-contract=off -o faults tests/faults.c -lm && ./faults
   cc -O2 -ffp-contract=off -DKERN_USE_GLPK -o faults tests/faults.c \
       -lglpk -lm && ./faults

   What the library says when it lacks memory, or (with GLPK) when the
   solver lies to it. Allowed is the verdict that it gives when nothing is
   wrong, with a proof that passes, and none at all: never another one.

   The lies are told between GLPK and kern_lp.h: wrong numbers, wrong
   certificates, wrong statuses, singly and mixed. */

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#ifdef KERN_USE_GLPK
#define KERN_GLPK_ROWS 0 /* GLPK is asked every time */
#include "lies.h"
#endif

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "structures.h"

static long checks, failures, decided, undecided, no_space;

static void check_at(int line, int holds, const char *what)
{
    checks++;
    if (holds)
        return;
    if (failures++ < 20)
        printf("faults.c:%d: does not hold: %s\n", line, what);
}
#define CHECK(holds) check_at(__LINE__, (holds) ? 1 : 0, #holds)

/* ==== One question, and what may be answered ======================== */

static kern_force force[CONTACTS];
static kern_motion motion[BLOCKS];

static kern_status ask(kern_margin *m, kern_work *work)
{
    kern_proof proof;
    proof.force = force;
    proof.motion = motion;
    memset(m, 0, sizeof *m);
    return kern_measure(task_of(work), m, &proof);
}

/* The same verdict as without the fault, or none. */
static void compare(kern_status got, const kern_margin *m, kern_status want,
                    const kern_margin *right)
{
    const kern_real mean = kern_mean_size(block, s.blocks);
    const kern_real close = KERN_PICK(4e-6, 0.08)
                          * (options.relative ? KERN_R(1) : mean);
    kern_work work = whole_work();
    if (got == KERN_NO_SPACE) {
        no_space++;
        return;
    }
    if (got == KERN_UNDECIDED) {
        undecided++;
        return;
    }
    decided++;
    CHECK(got == want);
    if (got != want)
        return;
    CHECK(m->level == right->level || m->level == -1 || right->level == -1);
    CHECK(kern_abs(m->margin - right->margin) <= close);
    if (got == KERN_STANDS)
        CHECK(kern_check_forces(task_of(&work), m->holds, force) <= 1);
    if (got == KERN_FALLS || !m->saturated)
        CHECK(kern_check_motion(task_of(&work), m->fails, motion) <= 1);
}

static void report(const char *what)
{
    printf("%-36s %6ld decided, %6ld undecided, %6ld no space\n", what, decided,
           undecided, no_space);
    decided = undecided = no_space = 0;
}

#ifndef KERN_USE_GLPK

/* ==== Too little ==================================================== */

/* Each array in every size, with the other one whole. */
static void cut_memory(int seed)
{
    kern_margin right, m;
    kern_work work = whole_work();
    int need[2], size[2], array;
    kern_status want;
    random_structure(seed, 6, &work);
    want = ask(&right, &work);
    if (want < 0)
        return;
    kern_work_need(s.blocks, s.contacts, &need[0], &need[1]);
    for (array = 0; array < 2; array++) {
        size[!array] = need[!array];
        for (size[array] = 0; size[array] <= need[array]; size[array]++) {
            kern_status got;
            work = kern_work_of(reals, size[0], ints, size[1]);
            got = ask(&m, &work);
            compare(got, &m, want, &right);
            CHECK(size[array] > 0 || got == KERN_NO_SPACE);
            CHECK(size[array] < need[array] || got == want);
        }
    }
}

/* Room for contacts, from none to enough. */
static void cut_room(int seed)
{
    static kern_contact found[CONTACTS];
    kern_work work = whole_work();
    int room, all;
    random_structure(seed, 6, &work);
    all = kern_contacts(block, s.blocks, &options, found, CONTACTS, &work);
    for (room = 0; room < CONTACTS && all >= 0; room++) {
        const int got = kern_contacts(block, s.blocks, &options, contact, room,
                                      &work);
        CHECK(got == all || got == KERN_NO_SPACE);
        CHECK(got != all || got <= room);
        CHECK(got < 0
              || memcmp(contact, found, sizeof *found * (size_t)got) == 0);
    }
}

static void too_little(void)
{
    int seed;
    for (seed = 1; seed <= 30; seed++)
        cut_memory(seed);
    for (seed = 1; seed <= 300; seed++)
        cut_room(seed);
    report("every size of memory");
}

#else

/* ==== A solver that lies ============================================ */

/* Every lie about structure number `seed`. */
static void lie_about_structure(int seed)
{
    kern_margin right, m;
    kern_work work = whole_work();
    kern_status want;
    random_structure(seed, 8, &work);
    lie = HONEST;
    want = ask(&right, &work);
    if (want < 0)
        return;
    for (lie = HONEST; lie < LIES; lie++) {
        kern_status got;
        work = whole_work();
        got = ask(&m, &work);
        compare(got, &m, want, &right);
        CHECK(got != KERN_NO_SPACE && work.error <= 1);
    }
}

enum { ROWS = 5, COLS = 9 };

typedef struct program {
    kern_real a[ROWS * COLS], rhs[ROWS], cost[COLS];
    kern_lp lp;
} program;

/* Small whole numbers, so that many programs are degenerate. */
static void random_program(program *p, int seed)
{
    int i;
    state = random_from((uint64_t)seed);
    p->lp.rows = 1 + random_below(ROWS);
    p->lp.cols = p->lp.rows + random_below(COLS - ROWS + 1);
    p->lp.limit = 0;
    p->lp.a = p->a;
    p->lp.rhs = p->rhs;
    p->lp.cost = random_below(3) ? p->cost : NULL;
    for (i = 0; i < ROWS * COLS; i++)
        p->a[i] = KERN_R(random_below(7) - 3);
    for (i = 0; i < ROWS; i++)
        p->rhs[i] = KERN_R(random_below(9) - 2);
    for (i = 0; i < COLS; i++)
        p->cost[i] = KERN_R(random_below(9) - 1);
}

static double cost_of(const program *p, const kern_real *x)
{
    double sum = 0;
    int j;
    for (j = 0; j < p->lp.cols; j++)
        sum += (double)p->cost[j] * (double)x[j];
    return sum;
}

/* The same status as honest GLPK, and the same least cost, or no answer. */
static void lie_about_program(int seed)
{
    kern_real right[COLS], x[COLS], y[ROWS];
    kern_work work = whole_work();
    kern_status want;
    program p;
    random_program(&p, seed);
    lie = HONEST;
    want = kern_lp_solve(&p.lp, right, y, &work);
    for (lie = HONEST; lie < LIES && want >= 0; lie++) {
        const kern_status got = kern_lp_solve(&p.lp, x, y, &work);
        double gap;
        if (got == KERN_UNDECIDED) {
            undecided++;
            continue;
        }
        decided++;
        CHECK(got == want);
        if (got != want || !p.lp.cost)
            continue;
        gap = got == KERN_LP_OPTIMAL ? cost_of(&p, x) - cost_of(&p, right) : 0;
        CHECK(gap < 1e-5 && gap > -1e-5);
        if (got == KERN_LP_UNBOUNDED)
            CHECK(cost_of(&p, x) < 0);
    }
}

static void lies(void)
{
    int seed;
    for (seed = 1; seed <= 300; seed++)
        lie_about_structure(seed);
    report("structures, a solver that lies");
    for (seed = 1; seed <= 3000; seed++)
        lie_about_program(seed);
    report("linear programs, a solver that lies");
    CHECK(lies_told > 10000);
}
#endif

int main(void)
{
#ifdef KERN_USE_GLPK
    lies();
#else
    too_little();
#endif
    printf("%ld checks, %ld failed\n", checks, failures);
    return failures ? 1 : 0;
}
