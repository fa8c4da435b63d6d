/* wall_test.cpp - examples/copy/wall.hpp when there is no memory, and the names
   in its errors.

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../examples/copy/wall.hpp"

#include <cstdio>
#include <cstdlib>
#include <new>

static long allowed = -1; /* allocations until one fails; -1: none fails */
static int failed = 0;

void *operator new(std::size_t n)
{
    if (allowed >= 0 && allowed-- == 0)
        throw std::bad_alloc();
    void *p = std::malloc(n);
    if (!p)
        throw std::bad_alloc();
    return p;
}

void operator delete(void *p) noexcept { std::free(p); }

void operator delete(void *p, std::size_t) noexcept { std::free(p); }

#define CHECK(x)   \
    ((x) ? (void)0 \
         : (void)(failed = 1, std::printf("line %d: %s\n", __LINE__, #x)))

static kern::Outline box(double x, double y)
{
    const kern_real l = kern_real(x), b = kern_real(y);
    return {{l, b}, {l + 1, b}, {l + 1, b + 1}, {l, b + 1}};
}

static kern::Wall row(int stones)
{
    kern::Wall wall;
    wall.ground({{-1, -1}, {100, -1}, {100, 0}, {-1, 0}}, "ground");
    for (int i = 0; i < stones; i++)
        wall.add(box(1.1 * i, 0), 2400,
                 "a name that is too long to be without memory of its own");
    return wall;
}

/* Lets every allocation of a call fail in turn: the wall is as it was. */
template <class Call> static void short_of_memory(int stones, Call call)
{
    for (long i = 0, threw = 1; threw; i++) {
        kern::Wall wall = row(stones);
        const kern_real margin = wall.measure().margin;
        const int blocks = wall.blocks();
        threw = 0;
        try {
            allowed = i;
            call(wall);
        } catch (const std::bad_alloc &) {
            threw = 1;
        }
        allowed = -1;
        CHECK(!threw || wall.blocks() == blocks);
        CHECK(!threw || wall.measure().margin >= margin);
        wall.rest(box(0, 0), kern_real(0.5));
        wall.add(box(0, 2), 2400, "later");
        CHECK(wall.name(wall.blocks() - 1) == "later");
        wall.measure();
        CHECK(i < 1000);
    }
}

/* Returns the text of the error that a stone gives. */
static std::string refused(const kern::Outline &outline, const char *name)
{
    kern::Wall wall = row(2);
    try {
        wall.add(outline, 2400, name);
    } catch (const kern::error &e) {
        CHECK(wall.blocks() == 3);
        return e.what();
    }
    return "";
}

int main()
{
    for (int stones = 3; stones < 7; stones += 3) {
        short_of_memory(stones, [](kern::Wall &wall) {
            wall.add(box(0, 1), 2400, "one more name that needs memory");
        });
        short_of_memory(stones, [](kern::Wall &wall) {
            wall.places(box(0, 0), 2400, 0, 4, 6);
        });
        short_of_memory(stones, [](kern::Wall &wall) {
            kern::Place place = wall.attempt(box(0, 1), 2400);
            wall.complete(place, 2400);
        });
        short_of_memory(stones, [](kern::Wall &wall) { kern::Wall b = wall; });
    }

    /* a stone that overlaps another, one that crosses itself */
    const kern::Outline bow = {{0, 2}, {1, 3}, {1, 2}, {0, 3}};
    CHECK(refused(box(0.5, 0), "wedge").find("wedge") != std::string::npos);
    CHECK(refused(box(0.5, 0), "").find("the new stone") != std::string::npos);
    CHECK(refused(bow, "bow tie").find("bow tie") != std::string::npos);
    CHECK(refused(bow, "").find("the new stone") != std::string::npos);
    return failed;
}
