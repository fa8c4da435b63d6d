/* rigid_test - is the simulator of rigid.h right?

       cc -O2 -ffp-contract=off -o rigid_test tests/rigid_test.c -lm
       ./rigid_test examples/structures/arch.kern ...

   Structures that are named must stand still for 20 seconds.

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "../examples/parts/random.h"
#include "../examples/laboratory/rigid.h"
#include "../examples/parts/text.h"

static const double pi = 3.14159265358979323846;
static int failures;

static void check(int good, const char *what, double found, double limit)
{
    printf("%s  %-52s %-12.5g limit %g\n", good ? "ok    " : "FAILED", what,
           found, limit);
    failures += !good;
}

static int box(struct rigid_world *w, double x, double y, double width,
               double height, double mass)
{
    double a = width / 2, b = height / 2;
    struct rigid_pt v[4] = {
        {x - a, y - b}, {x + a, y - b}, {x + a, y + b}, {x - a, y + b}};
    return rigid_add(w, v, 4, mass, rigid_vec(x, y));
}

static void run(struct rigid_world *w, double seconds)
{
    int steps = (int)(seconds / w->step + 0.5);
    for (int i = 0; i < steps; i++)
        rigid_step(w);
}

/* ---- Sliding ------------------------------------------------------------- */

/* How far a block slides in 2 s on a slope of some tangent. */
static double slide(double friction, double tangent)
{
    struct rigid_world w;
    double cosine = 1 / sqrt(1 + tangent * tangent), way;
    int block;
    rigid_init(&w);
    w.friction = friction;
    w.gravity = rigid_vec(9.81 * tangent * cosine, -9.81 * cosine);
    box(&w, 0, -0.5, 100, 1, 0);
    block = box(&w, 0, 0.25, 1, 0.5, 0.5);
    run(&w, 2);
    way = w.block[block].at.x;
    rigid_free(&w);
    return way;
}

static void test_slope(void)
{
    static const double mu[] = {0.1, 0.4, 0.8};
    for (int i = 0; i < 3; i++) {
        double low = 0.9, high = 1.1, tangent = 1.2 * mu[i], g;
        while (high - low > 1e-5) {
            double middle = (low + high) / 2;
            if (slide(mu[i], middle * mu[i]) > 1e-4)
                high = middle;
            else
                low = middle;
        }
        check(fabs(low - 1) < 0.01,
              "slope: tangent of first sliding / "
              "friction",
              low, 0.01);
        g = 9.81 * (tangent - mu[i]) / sqrt(1 + tangent * tangent);
        check(fabs(slide(mu[i], tangent) / (2 * g) - 1) < 0.01,
              "slope: way in 2 s / exact, 1.2 times steeper",
              slide(mu[i], tangent) / (2 * g), 0.01);
    }
}

/* A block at the lower end of a slope of 40 degrees, friction 0.4: what stands
   below touches it at its lowest corner and nowhere else, and must not hold
   it. Returns how far it goes in 2 s. */
static double corner_way(int with_corner)
{
    static const struct rigid_pt
        up[] = {{0.642787609686539, -0.766044443118978},
                {7.53718759775734, 5.01904404405988},
                {6.8943999880708, 5.78508848717885},
                {0, 0}},
        down[] = {{1.16231838594064, -2.94092093904347},
                  {0.642787609686539, -0.766044443118978},
                  {0, 0},
                  {0.412974276750846, -0.95888072602494}},
        stone[] = {{0, 0},
                   {0.766044443118978, 0.642787609686539},
                   {0.123256833432439, 1.40883205280552},
                   {-0.642787609686539, 0.766044443118978}};
    struct rigid_world w;
    struct rigid_pt at = {0.061628416716219, 0.704416026402759}, way;
    int block;
    rigid_init(&w);
    rigid_add(&w, up, 4, 0, at);
    if (with_corner)
        rigid_add(&w, down, 4, 0, at);
    block = rigid_add(&w, stone, 4, 1, at);
    rigid_settle(&w);
    run(&w, 2);
    way = rigid_sub(w.block[block].at, at);
    rigid_free(&w);
    return sqrt(rigid_dot(way, way));
}

static void test_corner(void)
{
    double bare = corner_way(0), with = corner_way(1);
    check(fabs(with / bare - 1) < 0.02, "slope: way past a corner / without it",
          with / bare, 0.02);
}

/* ---- Standing still ------------------------------------------------------ */

/* The greatest way of a block from where it began, over its size, in 20 s. A
   turn counts with the reach. */
static double creep(struct rigid_world *w, const double *size, double *late)
{
    struct rigid_pt *at = malloc((size_t)w->blocks * sizeof *at);
    double most = 0;
    *late = 0;
    rigid_settle(w);
    for (int i = 0; i < w->blocks; i++)
        at[i] = w->block[i].at;
    for (int part = 0; part < 20 && at; part++) {
        run(w, 1);
        for (int i = 0; i < w->blocks; i++) {
            struct rigid_pt d = rigid_sub(w->block[i].at, at[i]);
            double dist = sqrt(rigid_dot(d, d))
                        + fabs(w->block[i].angle) * w->block[i].reach;
            if (!(w->block[i].inv_mass > 0))
                continue;
            most = fmax(most, dist / size[i]);
            if (part == 0)
                *late = fmax(*late, dist / size[i]);
        }
    }
    *late = most - *late;
    free(at);
    return most;
}

static void test_tower(void)
{
    struct rigid_world w;
    double size[11], most, late;
    rigid_init(&w);
    box(&w, 0, -0.5, 10, 1, 0);
    for (int i = 0; i < 10; i++) {
        box(&w, 0, i + 0.5, 1, 1, 1);
        size[i + 1] = 1;
    }
    most = creep(&w, size, &late);
    check(most < 1e-3, "tower of 10 boxes: creep in 20 s", most, 1e-3);
    rigid_free(&w);
}

/* Eight courses of five, in bond. */
static void test_wall(void)
{
    struct rigid_world w;
    double size[41], most, late;
    rigid_init(&w);
    box(&w, 0, -0.5, 20, 1, 0);
    for (int i = 0; i < 40; i++) {
        size[i + 1] = sqrt(0.5);
        box(&w, i % 5 + i / 5 % 2 * 0.3 - 2, i / 5 * 0.5 + 0.25, 1, 0.5, 0.5);
    }
    most = creep(&w, size, &late);
    check(most < 1e-3, "wall of 40 boxes: creep in 20 s", most, 1e-3);
    rigid_free(&w);
}

/* Adds all blocks of a file. */
static double *load(struct rigid_world *w, const char *file)
{
    struct text_file t;
    double *size = NULL;
    rigid_init(w);
    if (text_load(&t, file) == 0)
        size = malloc((size_t)t.blocks * sizeof *size);
    for (int i = 0; size && i < t.blocks; i++) {
        const kern_block *b = &t.block[i];
        struct rigid_pt v[256];
        if (b->vertices > 256)
            continue;
        for (int k = 0; k < b->vertices; k++)
            v[k] = rigid_vec(b->vertex[k].x, b->vertex[k].y);
        size[i] = sqrt(fabs(b->area));
        rigid_add(w, v, b->vertices, b->fixed ? 0 : b->mass,
                  rigid_vec(b->centre.x, b->centre.y));
    }
    w->friction = t.options.mu;
    w->gravity = rigid_vec(t.gravity.x, t.gravity.y);
    text_free(&t);
    return size;
}

static void test_file(const char *file)
{
    struct rigid_world w;
    double *size = load(&w, file), most = HUGE_VAL, late = HUGE_VAL;
    const char *name = strrchr(file, '/') ? strrchr(file, '/') + 1 : file;
    char text[100];
    if (size)
        most = creep(&w, size, &late);
    snprintf(text, sizeof text, "%.20s, %d blocks: creep in 20 s", name,
             w.blocks);
    check(most < 1e-3, text, most, 1e-3);
    snprintf(text, sizeof text, "%.20s: of that after the first second", name);
    check(late < 1e-3, text, late, 1e-3);
    free(size);
    rigid_free(&w);
}

/* ---- Energy -------------------------------------------------------------- */

/* Numbers from 0 to 1, irregular enough to throw stones with. */
static double scatter(int i, int k)
{
    static const double step[] = {0.14159265, 0.71828182, 0.41421356};
    double x = (i + 1) * step[k];
    return x - floor(x);
}

/* Thirty stones fall on a floor. The greatest rise of the energy above what
   it was at any time before, over all that is lost in the end: what remains
   is that springs lift stones out of overlaps. */
static void test_energy(void)
{
    struct rigid_world w;
    double start, least, rise = 0;
    int steps;
    rigid_init(&w);
    box(&w, 0, -0.5, 100, 1, 0);
    for (int i = 0; i < 30; i++) {
        double width = 0.6 + scatter(i, 0), height = 0.4 + 0.5 * scatter(i, 1);
        int b = box(&w, i % 5 * 2.1 + 0.5 * scatter(i, 2), 1 + i / 5 * 2.1,
                    width, height, width * height);
        rigid_put(&w, b, w.block[b].at, 3 * scatter(i, 1));
        w.block[b].spin = 4 * scatter(i, 2) - 2;
    }
    start = least = rigid_energy(&w);
    steps = (int)(20 / w.step);
    for (int i = 0; i < steps; i++) {
        double e;
        rigid_step(&w);
        e = rigid_energy(&w);
        rise = fmax(rise, e - least);
        least = fmin(least, e);
    }
    check(rise < 1e-4 * (start - least), "energy of a heap: rise / its loss",
          rise / (start - least), 1e-4);
    rigid_free(&w);
}

/* ---- Rocking ------------------------------------------------------------- */

enum { HALF_SINE = 1, FULL_SINE = 2 };

struct pulse {
    int kind;
    double amplitude, seconds;
};

/* Acceleration of the base at a time, and its way by then. */
static double pulse_at(const struct pulse *p, double t)
{
    return t < p->seconds ? p->amplitude * sin(p->kind * pi * t / p->seconds)
                          : 0;
}

static double pulse_way(const struct pulse *p, double t)
{
    double om = p->kind * pi / p->seconds, a = p->amplitude;
    double end = fmin(t, p->seconds);
    double way = a / om * end - a / (om * om) * sin(om * end);
    return way + (t - end) * a / om * (1 - cos(om * end));
}

/* Housner's equation: I w' = -m g R sin(A - |x|) sgn x + m a R cos(A - |x|)
   with the base going to the left as x > 0 falls to the right; an impact takes
   away so much speed that the moment about the new corner stays. */
static double rock_rate(double x, double side, double a, double alpha,
                        double pp)
{
    double u = alpha - side * x;
    return pp * (-side * sin(u) + a / 9.81 * cos(u));
}

/* Does the block fall? Exact. */
static int rock_exact(const struct pulse *p, double alpha, double pp)
{
    const double h = 1e-4, kept = 1 - 1.5 * sin(alpha) * sin(alpha);
    double x = 0, v = 0, side = 0;
    for (int i = 0; i < (int)(8 / h); i++) {
        double t = i * h, a = pulse_at(p, t);
        if (side > -0.5 && side < 0.5) {
            if (fabs(a) <= 9.81 * tan(alpha))
                continue;
            side = a > 0 ? 1 : -1;
        }
        double k1 = rock_rate(x, side, a, alpha, pp);
        double am = pulse_at(p, t + h / 2), ae = pulse_at(p, t + h);
        double k2 = rock_rate(x + h / 2 * v, side, am, alpha, pp);
        double k3 = rock_rate(x + h / 2 * v + h * h / 4 * k1, side, am, alpha,
                              pp);
        double k4 = rock_rate(x + h * v + h * h / 2 * k2, side, ae, alpha, pp);
        x += h * v + h * h / 6 * (k1 + k2 + k3);
        v += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        if (fabs(x) > pi / 2)
            return 1;
        if (side * x < 0) {
            x = 0;
            v *= kept;
            side = fabs(v) < 1e-6 ? 0 : v > 0 ? 1 : -1;
            if (fabs(v) < 1e-6)
                v = 0;
        }
    }
    return 0;
}

/* The same by the simulator. The base goes to the left where the block is to
   fall to the right, as the sign of the equation has it. */
static int rock_simulated(const struct pulse *p, double width, double height)
{
    struct rigid_world w;
    int block, fell, steps;
    rigid_init(&w);
    w.friction = 2;
    box(&w, 0, -0.5, 10, 1, 0);
    block = box(&w, 0, height / 2, width, height, width * height);
    run(&w, 0.2);
    steps = (int)(8 / w.step);
    for (int i = 0; i < steps; i++) {
        double next = -pulse_way(p, (i + 1) * w.step);
        w.block[0].v.x = (next - w.block[0].at.x) / w.step;
        rigid_step(&w);
        if (fabs(w.block[block].angle) > pi / 2 - 0.1)
            break;
    }
    fell = fabs(w.block[block].angle) > pi / 4;
    rigid_free(&w);
    return fell;
}

/* Compares verdicts over amplitudes from 0.3 g to 5 g. Where the exact verdict
   is the same from 0.9 to 1.1 times the amplitude, the simulator's must be
   that; the exact one has islands in which a block that comes back from one
   side falls over the other. They are no wider than the tenth, and under a
   full sine of 0.3 s, at 2.4 to 2.9 g, the simulator misses one. */
static void test_pulse(int kind, double seconds)
{
    enum { STEPS = 140, TENTH = 5 }; /* 1.02 to the fifth is 1.1 */
    const double width = 0.5, height = 2, alpha = atan(width / height);
    const double pp = 0.75 * 9.81 / (sqrt(width * width + height * height) / 2);
    int exact[STEPS], falls[STEPS], wrong = 0, clear = 0;
    double a = 0.3 * 9.81, first = 0, found = 0;
    char text[100];
    for (int i = 0; i < STEPS; i++, a *= 1.02) {
        struct pulse p = {kind, a, seconds};
        exact[i] = rock_exact(&p, alpha, pp);
        falls[i] = rock_simulated(&p, width, height);
        if (exact[i] && first <= 0)
            first = a;
        if (falls[i] && found <= 0)
            found = a;
    }
    for (int i = TENTH; i + TENTH < STEPS; i++) {
        int sum = 0;
        for (int k = -TENTH; k <= TENTH; k++)
            sum += exact[i + k];
        if (sum > 0 && sum <= 2 * TENTH)
            continue;
        clear++;
        wrong += falls[i] != exact[i];
    }
    snprintf(text, sizeof text, "rocking: %s sine of %.1f s: wrong of %d clear",
             kind == HALF_SINE ? "half" : "full", seconds, clear);
    check(wrong == 0 && clear > STEPS / 2, text, wrong, 0);
    printf("        it first falls at %.3f g, exact %.3f g\n", found / 9.81,
           first / 9.81);
}

/* A leaning block comes back and goes over to its other corner: the speed
   after that impact, over the one before. The energies give both. */
static void test_impact(void)
{
    const double alpha = atan(0.25), start = -0.15;
    struct rigid_world w;
    struct rigid_pt q = rigid_unit(start);
    double before = 0, after = 0, base;
    int block;
    rigid_init(&w);
    w.friction = 2;
    box(&w, 0, -0.5, 10, 1, 0);
    block = box(&w, 0, 1, 0.5, 2, 1);
    base = rigid_energy(&w);
    rigid_put(&w, block, rigid_vec(0.25 - 0.25 * q.x - q.y, q.x - 0.25 * q.y),
              start);
    while (w.block[block].angle < 0.02) {
        rigid_step(&w);
        if (w.block[block].angle < -0.01)
            before = rigid_energy(&w) - base;
        after = rigid_energy(&w) - base;
    }
    after = sqrt(after / before);
    before = 1 - 1.5 * sin(alpha) * sin(alpha);
    check(fabs(after / before - 1) < 0.02,
          "rocking: speed kept at an impact / "
          "exact",
          after / before, 0.02);
    rigid_free(&w);
}

static void test_rocking(void)
{
    static const double seconds[] = {0.4, 0.6, 1.2};
    test_impact();
    for (int kind = HALF_SINE; kind <= FULL_SINE; kind++)
        for (int i = 0; i < 3; i++)
            test_pulse(kind, seconds[i]);
}

/* ---- Bits ---------------------------------------------------------------- */

static unsigned long heap_hash(void)
{
    struct rigid_world w;
    unsigned long hash = 2166136261u;
    rigid_init(&w);
    box(&w, 0, -0.5, 100, 1, 0);
    for (int i = 0; i < 20; i++)
        rigid_put(&w, box(&w, 0, 0, 1, 0.5, 1), rigid_vec(scatter(i, 0), 1 + i),
                  3 * scatter(i, 1));
    run(&w, 5);
    for (int i = 0; i < w.blocks; i++) {
        unsigned char byte[sizeof w.block[i].at];
        memcpy(byte, &w.block[i].at, sizeof byte);
        for (size_t k = 0; k < sizeof byte; k++)
            hash = ((hash ^ byte[k]) * 16777619u) & 0xffffffffu;
    }
    rigid_free(&w);
    return hash;
}

static void test_bits(void)
{
    unsigned long a = heap_hash(), b = heap_hash();
    printf("        the bits of a heap after 5 s: %08lx\n", a);
    check(a == b, "same calls, same bits", (double)(a != b), 0);
}

/* ---- Pieces -------------------------------------------------------------- */

/* A star: concave at every other corner. Its pieces must be convex and have
   its area together. */
static void test_pieces(void)
{
    struct rigid_world w;
    struct rigid_pt v[14];
    double whole = 0, sum = 0, least = 1;
    rigid_init(&w);
    for (int i = 0; i < 14; i++) {
        struct rigid_pt q = rigid_unit(2 * pi * i / 14);
        v[i] = rigid_vec((i % 2 ? 1 : 2) * q.x, (i % 2 ? 1 : 2) * q.y);
    }
    for (int i = 0; i < 14; i++)
        whole += rigid_cross(v[i], v[(i + 1) % 14]) / 2;
    rigid_add(&w, v, 14, 1, rigid_vec(0, 0));
    for (int i = 0; i < w.pieces; i++) {
        const struct rigid_corner *c = w.corner + w.piece[i].first;
        int n = w.piece[i].corners;
        for (int k = 0; k < n; k++) {
            sum += rigid_cross(c[k].local, c[(k + 1) % n].local) / 2;
            least = fmin(least, rigid_area(c[k].local, c[(k + 1) % n].local,
                                           c[(k + 2) % n].local));
        }
    }
    check(fabs(sum / whole - 1) < 1e-12, "star: area of pieces / area",
          sum / whole, 1e-12);
    check(least >= 0 && w.pieces <= 15, "star: convex pieces", w.pieces, 15);
    rigid_free(&w);
}

/* ---- Raised -------------------------------------------------------------- */

/* A row of up to four wedges of height 1 between two walls, by numbers drawn
   with the seed; its friction in *mu. Returns how many corners v has: four a
   wedge, then four for each wall. */
static int wedges(unsigned seed, struct rigid_pt *v, double *mu)
{
    uint64_t state = seed;
    double draw[8], x = 0, lean[5];
    int many = 1 + (int)(seed % 4), n = 0;
    for (int i = 0; i < 8; i++)
        draw[i] = random_share(random_mixed(&state));
    *mu = 0.1 + 0.7 * draw[0];
    for (int i = 0; i <= many; i++)
        lean[i] = 0.6 * (draw[i + 1] - 0.5);
    for (int i = 0; i < many; i++) {
        double wide = 0.7 + 0.6 * draw[6 + i % 2];
        v[n++] = rigid_vec(x, 0);
        v[n++] = rigid_vec(x + wide, 0);
        v[n++] = rigid_vec(x + wide + lean[i + 1], 1);
        v[n++] = rigid_vec(x + lean[i], 1);
        x += wide;
    }
    v[n++] = rigid_vec(-3, 0);
    v[n++] = rigid_vec(0, 0);
    v[n++] = rigid_vec(lean[0], 1);
    v[n++] = rigid_vec(-3, 1);
    v[n++] = rigid_vec(x, 0);
    v[n++] = rigid_vec(x + 3, 0);
    v[n++] = rigid_vec(x + 3, 1);
    v[n++] = rigid_vec(x + lean[many], 1);
    return n;
}

/* How far the row moves in 2 s from rest, and what kern_raised() says: one of
   its verdicts, or -1 where it does not stand. */
static double wedges_move(const struct rigid_pt *v, int n, double mu, int *said)
{
    kern_vec corner[24];
    static kern_block block[6];
    kern_contact contact[40];
    kern_real reals[KERN_REALS(6, 40)];
    int ints[KERN_INTS(6, 40)];
    kern_work work = kern_work_of(reals, KERN_REALS(6, 40), ints,
                                  KERN_INTS(6, 40));
    kern_task task = kern_task_of(block, n / 4, contact, 0, &work);
    kern_raising raising = KERN_NOT_SHOWN;
    struct rigid_world w;
    double moved = 0;
    task.options.mu = mu;
    rigid_init(&w);
    w.gravity = rigid_vec(0, -9.81);
    w.friction = mu;
    for (int i = 0; i < n; i++) {
        corner[i].x = v[i].x;
        corner[i].y = v[i].y;
    }
    for (int i = 0; i < n / 4; i++) {
        if (i < n / 4 - 2)
            kern_block_init(block + i, corner + 4 * i, 4, 1, NULL);
        else
            kern_ground_init(block + i, corner + 4 * i, 4, NULL);
        rigid_add(&w, v + 4 * i, 4, block[i].mass,
                  rigid_vec(block[i].centre.x, block[i].centre.y));
    }
    task.s.contacts = kern_contacts(block, n / 4, &task.options, contact, 40,
                                    &work);
    *said = kern_raised(&task, 0, &raising, NULL, NULL) == KERN_STANDS
              ? (int)raising
              : -1;
    run(&w, 2);
    for (int i = 0; i < n / 4 - 2; i++)
        moved = fmax(moved, hypot(w.block[i].at.x - block[i].centre.x,
                                  w.block[i].at.y - block[i].centre.y));
    rigid_free(&w);
    return moved;
}

static void test_wedges(void)
{
    int falls = 0, wrong = 0, stays = 0, kept = 0, said;
    for (unsigned seed = 1; seed <= 700; seed++) {
        struct rigid_pt v[24];
        double mu, moved;
        int n = wedges(seed, v, &mu);
        moved = wedges_move(v, n, mu, &said);
        falls += moved > 0.05;
        wrong += moved > 0.05 && said == KERN_RAISED;
        stays += moved < 0.02;
        kept += moved < 0.02 && said == KERN_RAISED;
    }
    printf("rows of wedges: %d fall, %d of them raised; %d stay, %d raised\n",
           falls, wrong, stays, kept);
    check(wrong <= falls / 50, "rows of wedges that fall and are raised / all",
          (double)wrong / falls, 0.02);
    check(kept >= stays * 9 / 10, "rows of wedges that stay and are raised",
          (double)kept / stays, 0.9);
}

int main(int argc, char **argv)
{
    test_slope();
    test_corner();
    test_pieces();
    test_tower();
    test_wall();
    test_wedges();
    for (int i = 1; i < argc; i++)
        test_file(argv[i]);
    test_energy();
    test_rocking();
    test_bits();
    printf("%d failed\n", failures);
    return failures > 0;
}
