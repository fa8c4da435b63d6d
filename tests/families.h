/* families.h - random structures of kinds that structures.h does not make: wedges
   between walls, fracture surfaces, interlocking stones, stones that were let
   down and rolled to rest, sizes from 1 to 1e4; turned, and away from the
   origin by up to 1e5 sizes. */

#ifndef FAMILIES_H
#define FAMILIES_H

#include "structures.h"

#include "../examples/laboratory/stones.h"

enum { WEDGES, FRACTURES, INTERLOCKS, SETTLED, SIZES, FAMILIES };

static const char *const family_name[FAMILIES] = {
    "wedges", "fractures", "interlocks", "settled", "sizes"};

static double power_of_ten(int n)
{
    double power = 1;
    for (; n > 0; n--)
        power *= 10;
    for (; n < 0; n++)
        power /= 10;
    return power;
}

/* Pieces side by side between two fixed walls that lean. */
static void make_wedges(int blocks)
{
    const double y0 = uniform(0.05, 0.4), y1 = y0 + uniform(0.8, 2);
    const double half = uniform(0.3, 0.8), end = 4;
    const double left = uniform(-0.15, 0.6), right = uniform(-0.15, 0.6);
    const double x0 = -half - left * y0, wide0 = 2 * half + (left + right) * y0;
    const double x1 = -half - left * y1, wide1 = 2 * half + (left + right) * y1;
    double low = 0, high = 0;
    kern_vec c[4];
    int i;
    c[0] = stones_vec(-9, 0);
    c[1] = stones_vec(-half, 0);
    c[2] = stones_vec(-half - end * left, end);
    c[3] = stones_vec(-9, end);
    add(c, 4, 0);
    c[0] = stones_vec(half, 0);
    c[1] = stones_vec(9, 0);
    c[2] = stones_vec(9, end);
    c[3] = stones_vec(half + end * right, end);
    add(c, 4, 0);
    blocks = blocks > 5 ? 5 : blocks;
    for (i = 1; i <= blocks; i++) {
        const double share = (double)i / blocks;
        const double to = i < blocks ? share + uniform(-0.3, 0.3) / blocks : 1;
        const double at = i < blocks ? share + uniform(-0.3, 0.3) / blocks : 1;
        c[0] = stones_vec(x0 + low * wide0, y0);
        c[1] = stones_vec(x0 + to * wide0, y0);
        c[2] = stones_vec(x1 + at * wide1, y1);
        c[3] = stones_vec(x1 + high * wide1, y1);
        add(c, 4, uniform(1, 3));
        low = to;
        high = at;
    }
}

/* Layers of one stone or two that match in a rough surface. */
static void make_fractures(int blocks)
{
    enum { POINTS = 5 };
    kern_vec under[POINTS], over[POINTS], c[2 * POINTS];
    double y = 0;
    int i, k;
    for (k = 0; k < POINTS; k++)
        under[k] = stones_vec(0.4 * k, uniform(-0.1, 0.1));
    for (k = 0; k < POINTS; k++)
        c[POINTS - 1 - k] = under[k];
    c[POINTS] = stones_vec(-1, -1);
    c[POINTS + 1] = stones_vec(2.6, -1);
    add(c, POINTS + 2, 0);
    for (i = 0; i < blocks;) {
        const int middle = i + 1 < blocks && random_below(2) ? 2 : POINTS - 1;
        const double rough = uniform(0, 0.15), lean = uniform(-0.08, 0.08);
        int from = 0, to = middle;
        y += uniform(0.4, 0.9);
        for (k = 0; k < POINTS; k++)
            over[k] = stones_vec(under[k].x + lean, y + rough * uniform(-1, 1));
        for (; from < POINTS - 1; from = to, to = POINTS - 1, i++) {
            int n = 0;
            for (k = from; k <= to; k++)
                c[n++] = under[k];
            for (k = to; k >= from; k--)
                c[n++] = over[k];
            add(c, n, uniform(1, 3));
        }
        memcpy(under, over, sizeof under);
    }
}

enum { WIDE = 4, HIGH = 4 };

/* The outline of the cells of one stone, between the lines of the grid. */
static int outline_of(int cell[HIGH][WIDE], int stone, const double *x,
                      const double *y, kern_vec *out)
{
    static const int dx[5] = {0, 1, 1, 0, 0}, dy[5] = {0, 0, 1, 1, 0};
    static const int nx[4] = {0, 1, 0, -1}, ny[4] = {-1, 0, 1, 0};
    int next[(HIGH + 1) * (WIDE + 1)];
    int i, j, k, n = 0, first = -1, at, last;
    for (k = 0; k < (HIGH + 1) * (WIDE + 1); k++)
        next[k] = -1;
    for (j = 0; j < HIGH; j++)
        for (i = 0; i < WIDE; i++)
            for (k = 0; k < 4 && cell[j][i] == stone; k++) {
                const int p = i + nx[k], q = j + ny[k];
                if (p >= 0 && p < WIDE && q >= 0 && q < HIGH
                    && cell[q][p] == stone)
                    continue;
                at = (j + dy[k]) * (WIDE + 1) + i + dx[k];
                first = first < 0 ? at : first;
                next[at] = (j + dy[k + 1]) * (WIDE + 1) + i + dx[k + 1];
            }
    for (at = first, last = -1; n == 0 || at != first; last = at, at = next[at])
        if (last < 0 || next[at] - at != at - last)
            out[n++] = stones_vec(x[at % (WIDE + 1)], y[at / (WIDE + 1)]);
    return n;
}

/* Is a cell empty, and does a stone have one beside it? */
static int may_grow(int cell[HIGH][WIDE], int stone, int i, int j)
{
    return !cell[j][i]
        && ((i > 0 && cell[j][i - 1] == stone)
            || (i + 1 < WIDE && cell[j][i + 1] == stone)
            || (j > 0 && cell[j - 1][i] == stone)
            || (j + 1 < HIGH && cell[j + 1][i] == stone));
}

/* Stones of one to four cells of a grid, some cells empty. */
static void make_interlocks(int blocks)
{
    int cell[HIGH][WIDE], i, j, k, stone;
    double x[WIDE + 1], y[HIGH + 1];
    add_box(-9, -1, 9, 0, 0);
    x[0] = y[0] = 0;
    for (i = 0; i < WIDE; i++)
        x[i + 1] = x[i] + uniform(0.4, 0.8);
    for (j = 0; j < HIGH; j++)
        y[j + 1] = y[j] + uniform(0.4, 0.8);
    memset(cell, 0, sizeof cell);
    for (stone = 1; stone <= blocks; stone++) {
        const int size = 1 + random_below(4);
        kern_vec c[VERTICES];
        int cells = 0;
        for (k = 0; k < 60 && cells < size; k++) {
            i = random_below(WIDE);
            j = random_below(HIGH);
            if (cells > 0 ? may_grow(cell, stone, i, j) : !cell[j][i]) {
                cell[j][i] = stone;
                cells++;
            }
        }
        if (cells > 0)
            add(c, outline_of(cell, stone, x, y, c), uniform(1, 3));
    }
}

/* Stones let down one after the other that came to rest. */
static void make_settled(int blocks)
{
    kern_work work = whole_work();
    uint64_t made = state;
    int i;
    add_box(-9, -1, 9, 0, 0);
    for (i = 0; i < 3 * blocks && s.blocks <= blocks; i++) {
        const double x = uniform(-1, 1), turn = uniform(-1, 1);
        kern_vec at[STONES_CORNERS];
        struct stone stone;
        kern_block shape;
        kern_pose pose;
        stone_make(&made, 20 + 60 * (double)uniform(0, 1), &stone);
        kern_block_init(&shape, stone.v, stone.n, 1, NULL);
        if (stone.n <= VERTICES
            && kern_rest(task_of(&work), &shape, x, on_circle(turn, 1), at,
                         &pose)
                   == KERN_OK)
            add(at, stone.n, uniform(1, 3));
    }
}

/* Boxes of any size on each other, from 1 to 1e4. */
static void make_sizes(int blocks)
{
    double x = 0, y = 0, below = 1e4;
    int i;
    add_box(-9e4, -1, 9e4, 0, 0);
    for (i = 0; i < blocks; i++) {
        const double unit = uniform(1, 3); /* factors have no order */
        const double size = unit * power_of_ten(random_below(5));
        const double least = size < below ? size : below;
        const double high = size * uniform(0.5, 1);
        x += 0.55 * least * uniform(-1, 1);
        add_box(x - size / 2, y, x + size / 2, y + high, uniform(1, 3));
        y += high;
        below = size;
    }
}

/* Turns and shifts all blocks, and gravity with them. */
static void move_all(kern_vec turn, kern_vec way)
{
    int i, k;
    for (i = 0; i < s.blocks; i++) {
        const kern_real density = block[i].fixed
                                    ? 0
                                    : block[i].mass / fabs(block[i].area);
        for (k = 0; k < block[i].vertices; k++) {
            const kern_vec p = stones_turned(turn, vertex[i][k]);
            vertex[i][k] = stones_vec(p.x + way.x, p.y + way.y);
        }
        if (density > 0)
            kern_block_init(&block[i], vertex[i], block[i].vertices, density,
                            NULL);
        else
            kern_ground_init(&block[i], vertex[i], block[i].vertices, NULL);
    }
    s.gravity = stones_turned(turn, s.gravity);
}

/* As random_structure(); returns the family. */
static int random_family(int seed, int most, kern_work *work)
{
    int family, i;
    random_begin(seed, 6);
    family = random_below(FAMILIES);
    i = random_count(1, most);
    switch (family) {
    case WEDGES: make_wedges(i); break;
    case FRACTURES: make_fractures(i); break;
    case INTERLOCKS: make_interlocks(i); break;
    case SETTLED: make_settled(i); break;
    default: make_sizes(i); break;
    }
    if (random_below(3) == 0) {
        const double size = kern_mean_size(block, s.blocks);
        const double far_off = size * power_of_ten(random_below(6));
        const double x = uniform(-1, 1), y = uniform(-1, 1);
        const kern_vec turn = random_below(2) ? stones_vec(1, 0)
                                              : on_circle(uniform(-1, 1), 1);
        move_all(turn, stones_vec(far_off * x, far_off * y));
    }
    s.contacts = kern_contacts(block, s.blocks, &options, contact, CONTACTS,
                               work);
    if (random_below(4) == 0)
        load_some();
    return family;
}

#endif
