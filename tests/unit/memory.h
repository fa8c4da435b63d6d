/* memory.h - how much work memory is needed, and too little of it. */

#ifndef UNIT_MEMORY_H
#define UNIT_MEMORY_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "random.h"
#include "known.h"
#include "laws.h"
#include "bad.h"

static const int constant_reals[KERN_REALS(3, 4) > 0 ? 1 : -1] = {
    KERN_REALS(3, 4)};
static const int constant_ints[KERN_INTS(3, 4) > 0 ? 1 : -1] = {
    KERN_INTS(3, 4)};

static void memory_need(void)
{
    int b, c, reals, ints;
    for (b = 0; b < 60; b++)
        for (c = 0; c < 200; c += 1 + c / 7) {
            kern_work_need(b, c, &reals, &ints);
            CHECK_INT(reals, KERN_REALS(b, c));
            CHECK_INT(ints, KERN_INTS(b, c));
        }
    CHECK_INT(constant_reals[0], KERN_REALS(3, 4));
    CHECK_INT(constant_ints[0], KERN_INTS(3, 4));
    /* arguments of the macro are not torn apart */
    CHECK_INT(KERN_REALS(1 + 2, 2 + 2), KERN_REALS(3, 4));
    CHECK_INT(KERN_INTS(1 + 2, 2 + 2), KERN_INTS(3, 4));
}

/* Above 300 blocks the need is linear, without a step where that begins. Of
   20,000 blocks the reals take less than 250 MB in double. */
static void memory_linear(void)
{
    int last = 0, b, reals, ints;
    CHECK_INT(KERN_ROOM(457), 457 * 462);
    CHECK_INT(KERN_ROOM(458), 458 * 463);
    for (b = 0; b <= 20000; b += 100) {
        kern_work_need(b, 7 * b, &reals, &ints);
        CHECK_INT(reals, KERN_REALS(b, 7 * b));
        if (b > 300)
            CHECK_INT(reals - last, 100 * (921 * 3 / 2 + 54 + 84) + 50);
        last = reals;
    }
    CHECK(reals < 250000000 / 8);
}

enum { ENTRIES = 6 };

/* Every entry that takes a structure, with nothing said of the answer. */
static int call_entry(int entry, const world *w, kern_work *work)
{
    const kern_structure s = structure_of(w);
    const kern_options *o = &w->options;
    kern_real value[MAX_BLOCKS], out;
    kern_collapse all;
    kern_margin m;
    switch (entry) {
    case 0: return kern_verdict(task_of(&s, o, work), 0, NULL);
    case 1: return kern_measure(task_of(&s, o, work), &m, NULL);
    case 2: return kern_deficit(task_of(&s, o, work), &out);
    case 3:
        return kern_load_factor(task_of(&s, o, work), 0, KERN_RIGHT, &out,
                                NULL);
    case 4: return kern_tilt(task_of(&s, o, work), 0, KERN_RIGHT, &out, NULL);
    default:
        return kern_profile(task_of(&s, o, work), KERN_SHRINK, value, &all);
    }
}

/* Sizes below zero, and arrays that are not there. */
static void no_work(const world *w, kern_real *real, int reals, int *index,
                    int ints)
{
    kern_work work = kern_work_of(real, -1, index, ints);
    int got;
    CHECK_INT(call_entry(0, w, &work), KERN_NO_SPACE);
    work = kern_work_of(real, reals, index, -5);
    CHECK_INT(call_entry(0, w, &work), KERN_NO_SPACE);
    work = kern_work_of(NULL, reals, index, ints);
    got = call_entry(0, w, &work);
    CHECK(got == KERN_BAD_POINTER || got == KERN_NO_SPACE);
    work = kern_work_of(real, reals, NULL, ints);
    got = call_entry(0, w, &work);
    CHECK(got == KERN_BAD_POINTER || got == KERN_NO_SPACE);
}

/* Every size of one array with the other whole: enough gives the right answer,
   less says so, and what lies behind the array is never touched. */
static void every_size(const world *w, int stride)
{
    int reals, ints, array, size, entry, want[ENTRIES];
    kern_real *real;
    int *index;
    kern_work work = work_of(w);
    for (entry = 0; entry < ENTRIES; entry++)
        want[entry] = call_entry(entry, w, &work);
    kern_work_need(w->blocks, w->contacts, &reals, &ints);
    real = (kern_real *)malloc(sizeof *real * (size_t)(reals + GUARD));
    index = (int *)malloc(sizeof *index * (size_t)(ints + GUARD));
    for (array = 0; array < 2; array++) {
        const int need = array ? ints : reals;
        for (size = 0; size <= need;
             size += size + stride > need && size < need ? need - size : stride)
            for (entry = 0; entry < ENTRIES; entry++) {
                int got;
                guard_fill(real, reals, index, ints);
                work = kern_work_of(real, array ? reals : size, index,
                                    array ? size : ints);
                got = call_entry(entry, w, &work);
                CHECK(guard_holds(&work, reals, ints));
                if (got != KERN_NO_SPACE)
                    CHECK_INT(got, want[entry]);
                if (size == 0)
                    CHECK_INT(got, KERN_NO_SPACE);
                if (size == need)
                    CHECK_INT(got, want[entry]);
            }
    }
    no_work(w, real, reals, index, ints);
    free(real);
    free(index);
}

static void memory_every_size(void)
{
    static world w;
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_touch(&w);
    every_size(&w, 1); /* no contacts */
    stack_of_two(&w, 0.25);
    every_size(&w, 1);
    given.n = 12;
    given.a = 1;
    given.mu = 0.6;
    semicircle(&w, 0.2);
    every_size(&w, 37);
}

static int lean(const world *w, kern_margin *m)
{
    kern_work work = work_of(w);
    work.reals = KERN_LEAN_REALS(w->blocks, w->contacts);
    work.indices = KERN_LEAN_INTS(w->blocks, w->contacts);
    return kern_measure(world_task(w, &work), m, NULL);
}

/* Lean memory gives the same answer, or none: it is too little for arches, and
   where many blocks move at the margin. */
static void memory_lean(void)
{
    static world w;
    kern_margin m, whole;
    int seed, refused = 0, none = 0;
    for (seed = 0; seed < 600; seed++) {
        int got;
        random_world(&w, 700000u + (unsigned long long)seed, 40);
        got = lean(&w, &m);
        refused += got < 0;
        if (got < 0) {
            CHECK(got == KERN_NO_SPACE || got == KERN_UNDECIDED);
            continue;
        }
        CHECK_INT(got, measure(&w, &whole));
        if (!SINGLE)
            CHECK_INT(m.level, whole.level);
        CHECK_NEAR(m.margin, whole.margin, law_tolerance(&w));
    }
    CHECK(refused < 180);
    context[0] = 0;
    given.n = 60;
    given.a = 1;
    given.mu = 3; /* holds it almost until every kern is a point */
    for (seed = 2; seed < 14; seed++) {
        int got;
        semicircle(&w, 0.1 * seed);
        got = lean(&w, &m);
        none += got == KERN_NO_SPACE;
        CHECK_INT(measure(&w, &whole), KERN_STANDS);
        if (got == KERN_STANDS)
            CHECK_NEAR(m.margin, whole.margin, law_tolerance(&w));
        else
            CHECK(got == KERN_NO_SPACE || got == KERN_UNDECIDED);
    }
#ifndef KERN_USE_GLPK /* which has its own memory */
    CHECK(none > 0);
#endif
}

/* Nothing is kept in the work arrays: garbage in them changes no bit. */
static void memory_garbage(void)
{
    static world w;
    int seed, fill;
    for (seed = 0; seed < 200; seed++) {
        kern_margin m[3];
        kern_real f[3];
        int units[3];
        random_world(&w, 300000u + (unsigned long long)seed, 15);
        for (fill = 0; fill < 3; fill++) {
            kern_work work = work_of(&w);
            const int byte = fill == 0 ? 0 : fill == 1 ? 0xff : 0x3f;
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            memset(&m[fill], 0, sizeof m[fill]);
            f[fill] = 0;
            CHECK(decided(kern_measure(world_task(&w, &work), &m[fill], NULL)));
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            CHECK(decided(kern_load_factor(world_task(&w, &work), 0, KERN_RIGHT,
                                           &f[fill], NULL)));
            CHECK(work.pivots >= 0 && work.solves > 0);
            memset(work.real, byte, sizeof *work.real * (size_t)work.reals);
            memset(work.index, byte, sizeof *work.index * (size_t)work.indices);
            CHECK(decided(kern_verdict(world_task(&w, &work), R(-1), NULL)));
            units[fill] = work.units;
            if (fill > 0) {
                CHECK_INT(units[fill], units[0]);
                CHECK_NEAR(m[fill].margin, m[0].margin, 0);
                CHECK_NEAR(m[fill].holds, m[0].holds, 0);
                CHECK_NEAR(m[fill].fails, m[0].fails, 0);
                CHECK_INT(m[fill].level, m[0].level);
                CHECK_NEAR(f[fill], f[0], 0);
            }
        }
    }
    context[0] = 0;
}

static const test memory_tests[] = {
    TEST(memory_need), TEST(memory_linear),  TEST(memory_every_size),
    TEST(memory_lean), TEST(memory_garbage),
};

#endif
