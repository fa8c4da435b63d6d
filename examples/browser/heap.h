/* heap.h - the little of a C library that the readers of drawings need in
   WebAssembly: memory that is taken one behind the other and given back all at
   once, and numbers that the page reads and writes. Elsewhere it is empty.

   SPDX-License-Identifier: MIT */

#ifndef HEAP_H
#define HEAP_H

#include <stddef.h>

#ifdef __wasm__
#define SHAPES_BARE
#define SHAPES_SQRT(x) __builtin_sqrt(x)
#define HEAP_CALL(name) \
    __attribute__((import_module("page"), import_name(#name)))

HEAP_CALL(read_number)
int shapes_read_number(const char *s, int n, double *out);
HEAP_CALL(write_number)
int shapes_write_number(double x, int digits, char *out);

/* Instructions of WebAssembly. */
#define memcpy __builtin_memcpy
#define memmove __builtin_memmove
#define memset __builtin_memset

extern unsigned char __heap_base;

enum { HEAP_PAGE = 65536, HEAP_HEAD = 16 };

static size_t heap_at; /* where memory is free; 0: at the beginning          */

static void heap_reset(void) { heap_at = 0; }

/* Memory with its length in front. NULL where the browser has no more. */
static void *malloc(size_t bytes)
{
    const size_t whole = (bytes + 2 * HEAP_HEAD - 1) / HEAP_HEAD * HEAP_HEAD;
    size_t end;
    char *made;
    if (heap_at == 0)
        heap_at = ((size_t)&__heap_base + HEAP_HEAD) / HEAP_HEAD * HEAP_HEAD;
    end = (size_t)__builtin_wasm_memory_size(0) * HEAP_PAGE;
    if (whole < bytes)
        return NULL;
    if (whole > end - heap_at
        && __builtin_wasm_memory_grow(0,
                                      (whole - (end - heap_at)) / HEAP_PAGE + 1)
               == (size_t)-1)
        return NULL;
    made = (char *)heap_at + HEAP_HEAD;
    *(size_t *)heap_at = bytes;
    heap_at += whole;
    return made;
}

/* Gives back what was taken last; the rest waits for heap_reset(). */
static void free(void *old)
{
    const size_t at = (size_t)old - HEAP_HEAD;
    size_t bytes;
    if (!old)
        return;
    bytes = *(size_t *)at;
    if (at + (bytes + 2 * HEAP_HEAD - 1) / HEAP_HEAD * HEAP_HEAD == heap_at)
        heap_at = at;
}

static void *realloc(void *old, size_t bytes)
{
    const size_t before = old ? *(size_t *)((char *)old - HEAP_HEAD) : 0;
    void *made;
    free(old); /* what was taken last stays where it is */
    made = malloc(bytes);
    if (made && old && made != old)
        memcpy(made, old, before < bytes ? before : bytes);
    return made;
}

static size_t strlen(const char *s)
{
    size_t n = 0;
    while (s[n])
        n++;
    return n;
}

static int memcmp(const void *a, const void *b, size_t n)
{
    const unsigned char *p = (const unsigned char *)a;
    const unsigned char *q = (const unsigned char *)b;
    for (; n > 0; n--, p++, q++)
        if (*p != *q)
            return *p - *q;
    return 0;
}

static int strcmp(const char *a, const char *b)
{
    while (*a && *a == *b) {
        a++;
        b++;
    }
    return (unsigned char)*a - (unsigned char)*b;
}

#else /* a C library is there */
static void heap_reset(void) {}
#endif

#endif /* HEAP_H */
