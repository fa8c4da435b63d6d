/* random.h - random numbers for the programs and the tests: from a seed, the
   same on every machine.

       uint64_t state = random_from(seed);
       x = random_uniform(&state, low, high);

   SPDX-License-Identifier: MIT */

#ifndef RANDOM_H
#define RANDOM_H

#include <stdint.h>

/* Xorshift, from a state that is not 0: G. Marsaglia, Xorshift RNGs, Journal of
   Statistical Software 8 (2003). */
static inline uint64_t random_bits(uint64_t *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return *state;
}

/* A state for it from a seed. Of seeds that are small numbers one after the other
   the first few numbers are alike. */
static inline uint64_t random_start(uint64_t seed)
{
    return seed * UINT64_C(2862933555777941757) + UINT64_C(3037000493);
}

/* The same, behind those first numbers. */
static inline uint64_t random_from(uint64_t seed)
{
    uint64_t state = random_start(seed);
    int i;
    for (i = 0; i < 8; i++)
        random_bits(&state);
    return state;
}

/* Splitmix64, for states that are small numbers one after the other: G. L.
   Steele, D. Lea, C. H. Flood, Fast splittable pseudorandom number generators,
   OOPSLA 2014. */
static inline uint64_t random_mixed(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

/* From 0 up to but not 1: the first 53 bits. */
static inline double random_share(uint64_t bits)
{
    return (double)(bits >> 11) / 9007199254740992.0;
}

static inline double random_uniform(uint64_t *state, double low, double high)
{
    return low + (high - low) * random_share(random_bits(state));
}

#endif
