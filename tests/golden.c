/* cc -O2 -ffp-contract=off -o golden tests/golden.c -lm && ./golden

   The same bits on every machine: a hash of everything that the library says
   of some thousand random structures - contacts, verdicts, levels, margins,
   forces, motions, deficits, load factors, angles, raised or not - against
   those that stand below. tests/golden.sh compiles and runs it for many targets.

       golden [N]      the first N structures: 200, 1000 or 5000, the default
       -DKERN_SINGLE   in float
       -DGOLDEN_BARE   200 of them without an operating system, on
                       examples/firmware/board.c
       -DGOLDEN_WHOLE  with those functions too that it does not call */

#include <float.h>
#include <stdint.h>
#include <string.h>

#ifndef GOLDEN_WHOLE
#define KERN_STATIC
#endif
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "structures.h"

#ifdef GOLDEN_BARE
#include "../examples/firmware/board.h"
#define SAY(text) board_print(text)
#else
#include <stdio.h>
#include <stdlib.h>
#define SAY(text) fputs(text, stdout)
#endif

/* ==== What must come out: paste here what the program prints ======== */

static const struct {
    int structures; /* hash of so many from the first on */
    uint64_t hash;
} golden[] = {
#ifdef KERN_SINGLE
    {200, 0x07d70cdbba16f104u},
    {1000, 0x1976a8f859acaca7u},
    {5000, 0xf633b3dc51b3cefau},
#else
    {200, 0xa543f592e2cb1683u},
    {1000, 0x05d9f48ed5a6d233u},
    {5000, 0xedf2497399c80efdu},
#endif
};

enum {
    GOLDENS = (int)(sizeof golden / sizeof *golden),
    FEWEST = 200,
    MOST = 5000
};

/* ==== Arithmetic as the promise needs it ============================ */

#if defined(__FAST_MATH__)
#error "golden.c: not with -ffast-math or -Ofast: they change results"
#endif
/* 16 (gcc with _Float16) means the same as 0 for float and double. */
#if FLT_EVAL_METHOD != 0 && FLT_EVAL_METHOD != 16
#error "golden.c: numbers are kept in excess precision: -msse2 -mfpmath=sse"
#endif

/* What no macro tells: each is a sum that IEEE arithmetic rounds to 0 (or does
   not), from numbers that the compiler cannot know. */
static const char *arithmetic_fault(void)
{
    volatile kern_real up = 1 + KERN_EPS, down = 1 - KERN_EPS, one = 1;
    volatile kern_real tiny = KERN_EPS / 4, least = KERN_PICK(DBL_MIN, FLT_MIN);
    const kern_real a = up, b = down, c = one, d = tiny, e = least;
    const kern_real fused = a * b - c, sum = (c + d) - c, below = e / 4;
    if (fused < 0 || fused > 0)
        return "multiply and add are fused: compile with -ffp-contract=off\n";
    if (sum < 0 || sum > 0)
        return "sums are reordered: no -funsafe-math-optimizations\n";
    if (!(below > 0))
        return "small numbers are flushed to zero: no -ffast-math, also "
               "where it is linked\n";
    return NULL;
}

/* ==== The hash ====================================================== */

static uint64_t hash; /* FNV-1a, over bytes from the lowest one up */

static void hash_bits(uint64_t bits, int bytes)
{
    for (; bytes > 0; bytes--, bits >>= 8)
        hash = (hash ^ (bits & 0xff)) * 1099511628211u;
}

static void hash_int(int number) { hash_bits((uint32_t)number, 4); }

static void hash_real(kern_real number)
{
#ifdef KERN_SINGLE
    uint32_t bits;
#else
    uint64_t bits;
#endif
    memcpy(&bits, &number, sizeof bits);
    hash_bits(bits, (int)sizeof bits);
}

/* ==== What the library says ========================================= */

static kern_force force[CONTACTS];
static kern_motion motion[BLOCKS];

static void hash_geometry(void)
{
    int i;
    for (i = 0; i < s.blocks; i++) {
        hash_real(block[i].area);
        hash_real(block[i].mass);
        hash_real(block[i].centre.x);
        hash_real(block[i].centre.y);
        hash_real(block[i].load.torque);
    }
    hash_int(s.contacts);
    for (i = 0; i < s.contacts; i++) {
        const kern_contact *c = &contact[i];
        hash_int(c->a);
        hash_int(c->b);
        hash_int(c->line);
        hash_real(c->p.x);
        hash_real(c->p.y);
        hash_real(c->n.x);
        hash_real(c->n.y);
        hash_real(c->mu);
        hash_real(c->travel);
    }
}

/* Verdicts as numbers of their own: those of kern_status may change. */
static void hash_verdict(kern_status got)
{
    hash_int(got == KERN_STANDS ? 0 : got == KERN_FALLS ? 1 : (int)got);
}

static void hash_proof(int forces, int motions)
{
    int i;
    for (i = 0; forces && i < s.contacts; i++) {
        hash_real(force[i].normal);
        hash_real(force[i].tangential);
    }
    for (i = 0; motions && i < s.blocks; i++) {
        hash_real(motion[i].vx);
        hash_real(motion[i].vy);
        hash_real(motion[i].spin);
    }
}

static kern_contact_rate point[CONTACTS];
static kern_block_rate stone[BLOCKS];

/* How the margin depends on places, and the least forces. */
static void hash_rates(kern_work *work, const kern_margin *m,
                       const kern_proof *proof)
{
    kern_status got = kern_sensitivity(task_of(work), m, proof, point, stone);
    int i;
    hash_int(got);
    for (i = 0; i < s.blocks && got == KERN_OK; i++) {
        hash_real(stone[i].place.x);
        hash_real(stone[i].place.y);
        hash_real(stone[i].turn);
    }
    got = kern_forces(task_of(work), m->margin / 2, force);
    hash_verdict(got);
    hash_proof(got == KERN_STANDS, 0);
}

static void hash_measure(kern_work *work, const kern_proof *proof)
{
    kern_margin m;
    kern_status got;
    memset(&m, 0, sizeof m);
    got = kern_measure(task_of(work), &m, proof);
    hash_verdict(got);
    if (got < 0)
        return;
    hash_int(m.level);
    hash_int(m.saturated);
    hash_real(m.margin);
    hash_real(m.holds);
    hash_real(m.fails);
    hash_real(m.most);
    hash_real(m.epsilon);
    hash_proof(got == KERN_STANDS, got == KERN_FALLS || !m.saturated);
    if (got == KERN_STANDS) {
        kern_status at;
        hash_rates(work, &m, proof);
        at = kern_verdict(task_of(work), m.margin / 2, proof);
        hash_verdict(at);
        hash_proof(at == KERN_STANDS, at == KERN_FALLS);
    }
}

static void hash_raised(kern_work *work, const kern_proof *proof)
{
    kern_raising raising = KERN_NOT_SHOWN;
    kern_real reserve = 0;
    const kern_status got = kern_raised(task_of(work), 0, &raising, &reserve,
                                        proof);
    hash_verdict(got);
    if (got != KERN_STANDS)
        return;
    hash_int((int)raising);
    hash_real(reserve);
    hash_proof(1, raising != KERN_NOT_SHOWN);
}

/* The chance of the last block, to stay. */
static void hash_stays(kern_work *work)
{
    kern_task *task = task_of(work);
    kern_real chance = 0;
    const kern_status got = kern_stays(task, task->s.blocks - 1, &chance);
    hash_verdict(got);
    if (got == KERN_STANDS)
        hash_real(chance);
}

static void hash_raised_load(kern_work *work, const kern_proof *proof)
{
    kern_real factor = 0;
    const kern_status got = kern_raised_load(task_of(work), 0, KERN_RIGHT, NULL,
                                             &factor, proof);
    hash_verdict(got);
    if (got != KERN_STANDS)
        return;
    hash_real(factor);
    hash_proof(1, 1);
}

/* Everything that can be asked of structure number `seed`. */
static void hash_structure(int seed)
{
    kern_work work = whole_work();
    kern_proof proof;
    kern_real out = 0;
    int got, side;
    proof.force = force;
    proof.motion = motion;
    random_structure(seed, 14, &work);
    hash_geometry();
    if (s.contacts < 0)
        return;
    hash_measure(&work, &proof);
    got = kern_deficit(task_of(&work), &out);
    hash_verdict(got);
    if (got >= 0)
        hash_real(out);
    for (side = -1; side < 2; side += 2) {
        got = kern_load_factor(task_of(&work), 0, side, &out, NULL);
        hash_verdict(got);
        if (got == KERN_STANDS)
            hash_real(out);
    }
    if (seed % 4 == 0) {
        got = kern_tilt(task_of(&work), 0, KERN_RIGHT, &out, NULL);
        hash_verdict(got);
        if (got == KERN_STANDS)
            hash_real(out);
    }
    hash_raised(&work, &proof);
    hash_stays(&work);
    if (seed % 4 == 0)
        hash_raised_load(&work, &proof);
    hash_int(work.pivots);
    hash_int(work.solves);
    hash_real(work.error);
}

/* ==== Comparison ==================================================== */

static void say_int(unsigned number)
{
    char digits[12];
    char *at = digits + sizeof digits - 1;
    *at = '\0';
    do
        *--at = (char)('0' + number % 10);
    while ((number /= 10) > 0);
    SAY(at);
}

static void say_hash(uint64_t value)
{
    char text[17];
    int i;
    for (i = 0; i < 16; i++)
        text[i] = "0123456789abcdef"[value >> (60 - 4 * i) & 15];
    text[16] = '\0';
    SAY("0x");
    SAY(text);
}

static int compare(int structures, uint64_t want)
{
    const int same = hash == want;
    SAY(sizeof(kern_real) == sizeof(float) ? "float, " : "double, ");
    say_int((unsigned)structures);
    SAY(" structures: ");
    say_hash(hash);
    if (!same) {
        SAY("  FAILED, want ");
        say_hash(want);
    }
    SAY("\n");
    return same;
}

static int run(int structures)
{
    const char *fault = arithmetic_fault();
    int i, k, compared = 0, same = 0;
    if (fault) {
        SAY("FAILED: ");
        SAY(fault);
        return 1;
    }
    hash = 14695981039346656037u;
    for (i = 1; i <= structures; i++) {
        hash_structure(i);
        for (k = 0; k < GOLDENS; k++)
            if (i == golden[k].structures) {
                compared++;
                same += compare(i, golden[k].hash);
            }
    }
    return compared > 0 && same == compared ? 0 : 1;
}

#ifdef GOLDEN_BARE
int main(void) { return run(FEWEST); }
#else
int main(int argc, char **argv) { return run(argc > 1 ? atoi(argv[1]) : MOST); }
#endif
