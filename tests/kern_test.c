/* cc -O2 -ffp-contract=off -o kern_test tests/kern_test.c -lm && ./kern_test

   Tests of kern.h. `kern_test --help` lists what it can be told; the same file
   is compiled with -DKERN_SINGLE (float) and with -DKERN_USE_GLPK -lglpk.

   Every verdict that a test gets through verdict() or measure() is verified
   again by twin.h, which shares nothing with kern.h but its types.

   ROOMS: each file of tests/unit/ compiles alone and includes the rooms that it
   uses. To compile and run the tests of one room, in about three seconds:

       cc -O1 -ffp-contract=off -DONLY=contact -o kern_test \
           tests/kern_test.c -lm && ./kern_test

   CONTENTS: all rooms, in the order in which their tests run.
     tools      harness.h    checks, tolerances, random numbers
                worlds.h     structures by hand
     twin       twin.h       proofs, verified again
                tableau.h    another simplex method
     answers    verdict.h    calls of the library, each answer verified
                random.h     structures from a seed
     geometry   polygon.h  contact.h
                turned.h     contacts, whichever way the world is turned
                steps.h  simplify.h  outlines.h
     engine     engine.h     one row, one factor, one group, one basis
                lp.h         linear programs
                bases.h      a twin that tries all bases
     statics    proof.h      verdicts and proofs
                digits.h     proofs of the last digits
                margin.h     level and margin
                load.h       deficit, load factor, tilt
     plans      plan.h  plan_fuzz.h  jams.h
                rest.h       where stones come to rest
     bounds     bearing.h    the bearing length
                limits.h     limits of work
     known      known.h      cases whose answer is known, each with its
                             derivation or source
                laws.h       what related structures have in common
                against.h    random structures against the twin
     bad input  bad.h  statuses.h  memory.h
     readers    profile.h    also what is near, measured, certain
                measured.h   stretches, gross errors, laws of certainty
                raised.h     raised forces and loads
                pose.h       pose errors
                push.h  sensitivity.h
                forces.h     the least forces

   RULES of the header and their tests; `kern_test NAME` runs those alone whose
   names contain NAME:
     line         contact_cube contact_narrow
     point        contact_points   corner       contact_concave
     face         contact_merged   overlap      overlap contact_in_a_mouth
     gap, angle   contact_gap contact_floor contact_angle
     each of them where it alone decides: contact_rules
     shrinkage    contact_travels  lone         lone_points
     level        margin_steps     margin       margin_ known_
     deficit      deficit_         load factor  load_ laws_load
     tilt         tilt_            profile      profile_
     mechanism    proof_motions    critical     critical_
     stands       twin_ known_     falls        proof_
     simplified outlines           simplify_ steps_

   Of the private parts of kern.h only these are called: kern_max, kern_closes;
   the boxes of an outline (kern_outline_set, kern_polygon_depth); in engine.h
   what is listed there. */

#ifdef ONLY
/* a space around the stroke would be part of the name of the file */
#define TEXT(x) #x
/* clang-format off */
#define FILE_OF(room) TEXT(unit/room.h)
/* clang-format on */
#include FILE_OF(ONLY)
#else
#include "unit/polygon.h"
#include "unit/contact.h"
#include "unit/turned.h"
#include "unit/steps.h"
#include "unit/simplify.h"
#include "unit/outlines.h"
#include "unit/engine.h"
#include "unit/lp.h"
#include "unit/bases.h"
#include "unit/proof.h"
#include "unit/digits.h"
#include "unit/margin.h"
#include "unit/load.h"
#include "unit/plan.h"
#include "unit/plan_fuzz.h"
#include "unit/rest.h"
#include "unit/jams.h"
#include "unit/bearing.h"
#include "unit/limits.h"
#include "unit/known.h"
#include "unit/laws.h"
#include "unit/against.h"
#include "unit/bad.h"
#include "unit/statuses.h"
#include "unit/memory.h"
#include "unit/profile.h"
#include "unit/measured.h"
#include "unit/raised.h"
#include "unit/pose.h"
#include "unit/push.h"
#include "unit/sensitivity.h"
#include "unit/forces.h"
#endif
#include "unit/harness.h"
#include "unit/verdict.h"

/* The tests of a room. */
typedef struct room {
    const test *tests;
    int count;
} room;

#define TESTS_OF(room)                       \
    {                                        \
        room##_tests, COUNT_OF(room##_tests) \
    }
#define TESTS_IN(room) TESTS_OF(room)
static const room rooms[] = {
#ifdef ONLY
    TESTS_IN(ONLY),
#else
    TESTS_OF(polygon), TESTS_OF(contact),     TESTS_OF(turned),
    TESTS_OF(steps),   TESTS_OF(simplify),    TESTS_OF(outlines),
    TESTS_OF(engine),  TESTS_OF(lp),          TESTS_OF(bases),
    TESTS_OF(proof),   TESTS_OF(digits),      TESTS_OF(margin),
    TESTS_OF(load),    TESTS_OF(plan),        TESTS_OF(plan_fuzz),
    TESTS_OF(jams),    TESTS_OF(bearing),     TESTS_OF(limits),
    TESTS_OF(known),   TESTS_OF(laws),        TESTS_OF(against),
    TESTS_OF(bad),     TESTS_OF(statuses),    TESTS_OF(memory),
    TESTS_OF(profile), TESTS_OF(raised),      TESTS_OF(pose),
    TESTS_OF(push),    TESTS_OF(sensitivity), TESTS_OF(forces),
    TESTS_OF(rest),    TESTS_OF(measured),
#endif
};

/* A count with a comma after every three digits. */
static const char *grouped(long n)
{
    static char text[40];
    char digits[24];
    int i, k = 0, length = sprintf(digits, "%ld", n);
    for (i = 0; i < length; i++) {
        if (i > 0 && (length - i) % 3 == 0)
            text[k++] = ',';
        text[k++] = digits[i];
    }
    text[k] = 0;
    return text;
}

#ifndef ONLY
/* Compares `many` structures with the twin. */
static void run_random(long many, long first)
{
    const long none = compare_many(first, many, 40, 20);
    printf("%ld random structures: %ld undecided, %ld of %ld questions open to "
           "the twin\n",
           many, none, twin_near, twin_asked);
    CHECK(SINGLE || none == 0);
}

/* Makes `many` calls on plans, each compared with a fresh structure. */
static void run_plans(long many, long first)
{
    plan_fuzz_calls(many, (unsigned long long)first);
    printf("%ld calls on plans, %ld ended by a limit or for want of memory\n",
           plan_calls, plan_ends);
}
#endif

static void run_test(const test *one)
{
    const clock_t start = clock();
    failed_here = 0;
    context[0] = 0;
    one->run();
    context[0] = 0;
    printf("%-28s %s%6.2f s\n", one->name, failed_here ? "FAILED" : "ok    ",
           (double)(clock() - start) / CLOCKS_PER_SEC);
    if (failed_here > 10)
        printf("    ... %ld checks failed\n", failed_here);
    fflush(stdout);
}

static const char help[] =
    "usage: kern_test [--quick] [NAME...]\n"
    "       kern_test --random N [FIRST] | --plans N [FIRST]\n"
    "Runs the tests whose name contains one of the NAMEs, or all.\n"
    "  --quick    a fifth of the random structures, or fewer\n"
    "  --random   only this comparison, on N structures from number FIRST on\n"
    "  --plans    only N calls on plans, on structures from number FIRST on\n"
    "A program of one room has neither --random nor --plans.\n";

/* Does the name of a test contain one of the words? True where there are no
   words. */
static int is_wanted(const test *one, int words, char **word)
{
    int k, wanted = words == 0;
    for (k = 0; k < words; k++)
        wanted = wanted || strstr(one->name, word[k]);
    return wanted;
}

/* Runs the tests whose names contain one of some words, or all where there is
   none. Returns how many. */
static int run_tests(int words, char **word)
{
    int i, k, run = 0;
    for (i = 0; i < COUNT_OF(rooms); i++) {
        for (k = 0; k < rooms[i].count; k++) {
            const test *one = &rooms[i].tests[k];
            if (!is_wanted(one, words, word))
                continue;
            run_test(one);
            run++;
        }
    }
    if (run == 0) {
        printf("no test has such a name\n");
        failed++;
    }
    return run;
}

/* Does what --random or --plans says. Returns 0 where neither is said. */
static int run_many(int argc, char **argv)
{
#ifndef ONLY
    if (argc > 2 && strcmp(argv[1], "--random") == 0) {
        run_random(atol(argv[2]), argc > 3 ? atol(argv[3]) : 10000000);
        return 1;
    }
    if (argc > 2 && strcmp(argv[1], "--plans") == 0) {
        run_plans(atol(argv[2]), argc > 3 ? atol(argv[3]) : 7400000);
        return 1;
    }
#else
    (void)argc;
    (void)argv;
#endif
    return 0;
}

int main(int argc, char **argv)
{
    int run = 1;
    if (argc > 1 && strcmp(argv[1], "--help") == 0)
        return fputs(help, stdout) < 0;
    if (argc > 1 && strcmp(argv[1], "--quick") == 0) {
        quick = 1;
        argc--;
        argv++;
    }
    if (!run_many(argc, argv)) {
        if (argc > 1 && argv[1][0] == '-') {
            fputs(help, stderr);
            return 2;
        }
        run = run_tests(argc - 1, argv + 1);
    }
    failed_here = 0;
    CHECK(undecided <= (SINGLE ? asked / 50 : 0));
    CHECK(proof_error <= 1);
    printf("%d tests: %s checks passed, ", run, grouped(passed));
    printf("%s failed\n", grouped(failed));
    return failed ? 1 : 0;
}
