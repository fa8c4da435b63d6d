/* Arbitrary bytes, read as a text file or made into a structure.

   With libFuzzer, a minute each:

       clang -g -O1 -ffp-contract=off -fsanitize=fuzzer,address,undefined \
           -fno-sanitize-recover=all -DFUZZ_TEXT -o fuzz tests/fuzz.c -lm
       ./fuzz -max_total_time=60

   (-DFUZZ_STRUCTURE for the other, -DFUZZ_DRAWING='".dxf"', '".json"' or '".svg"'
   for what reads drawings and photographs), or without it, on files and on random
   bytes:

       cc -g -O1 -ffp-contract=off -DFUZZ_STRUCTURE -DFUZZ_PLAIN -o fuzz \
           tests/fuzz.c -lm
       ./fuzz FILE... | ./fuzz --random COUNT [SEED]

   Whatever the bytes: nothing is written behind an array, the number of pivots
   keeps its limit, contacts that were found are accepted, and every verdict
   passes its proof again. At the end it says how often there was none; of what
   a mason could mean that must be less than one in a thousand. */

#include <float.h>
#include <limits.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"

#ifdef FUZZ_TEXT
#include "../examples/parts/text.h"
#endif
#ifdef FUZZ_DRAWING /* ".dxf", ".json" or ".svg" */
#include "../examples/parts/drawing.h"
#endif

#if !defined(FUZZ_TEXT) && !defined(FUZZ_STRUCTURE) && !defined(FUZZ_DRAWING)
#error "fuzz.c: say -DFUZZ_TEXT, -DFUZZ_STRUCTURE or -DFUZZ_DRAWING=.dxf"
#endif

#define PROPERTY(holds) ((holds) ? (void)0 : property_fails(#holds, __LINE__))

static void property_fails(const char *what, int line)
{
    fprintf(stderr, "fuzz.c:%d: does not hold: %s\n", line, what);
    abort();
}

/* ==== Counts ======================================================== */

/* Tame are structures whose numbers lie within some powers of ten, as those of
   masons do: there a verdict is expected. */
static struct {
    long inputs, asked[2], undecided[2]; /* [1]: of tame structures */
} count;

static void say_counts(void)
{
    fprintf(stderr,
            "%ld inputs; undecided: %ld of %ld questions to tame "
            "structures, %ld of %ld to wild ones\n",
            count.inputs, count.undecided[1], count.asked[1],
            count.undecided[0], count.asked[0]);
    if (KERN_PICK(1000, 100) * KERN_R(count.undecided[1])
        > KERN_R(count.asked[1] + 1000))
        property_fails("undecided is rare", __LINE__);
}

static void count_input(void)
{
    if (count.inputs++ == 0)
        atexit(say_counts);
}

#ifndef FUZZ_DRAWING
/* ==== Every property of a structure ================================= */

enum { BLOCKS = 10, CONTACTS = 100, GUARD = 8, QUESTIONS = 5 };

static kern_real reals[KERN_REALS(BLOCKS, CONTACTS) + GUARD];
static int ints[KERN_INTS(BLOCKS, CONTACTS) + GUARD];
static kern_real proof_reals[4 * BLOCKS];
static kern_force force[CONTACTS];
static kern_motion motion[BLOCKS];
static kern_contact_rate point[CONTACTS];
static kern_block_rate stone[BLOCKS];

static const kern_real real_mark = KERN_R(12345);
enum { INT_MARK = 12345 };

/* Work memory of any size, with marks behind it. */
static kern_work work_of(int real_room, int int_room)
{
    int i;
    for (i = 0; i < GUARD; i++) {
        reals[real_room + i] = real_mark;
        ints[int_room + i] = INT_MARK;
    }
    return kern_work_of(reals, real_room, ints, int_room);
}

static kern_work whole_work(void)
{
    return work_of(KERN_REALS(BLOCKS, CONTACTS), KERN_INTS(BLOCKS, CONTACTS));
}

static void check_work(const kern_work *work, int rows, int cols, int limit,
                       kern_status status)
{
    const double most = 200 + 20 * (rows + cols);
    int i;
    for (i = 0; i < GUARD; i++) {
        PROPERTY(!(work->real[work->reals + i] < real_mark)
                 && !(work->real[work->reals + i] > real_mark));
        PROPERTY(work->index[work->indices + i] == INT_MARK);
    }
    /* both phases have the limit, and a verdict may be asked for twice; the
       interior point factors its matrix before its first verdict, and the limit
       of work may end it there */
    PROPERTY(work->pivots >= 0 && work->solves >= 0);
    PROPERTY(work->pivots <= 2 * most * (work->solves + 1));
    PROPERTY(work->units >= 0 && (limit == 0 || work->units <= limit + 1));
    PROPERTY(status != KERN_LIMIT || work->units == limit + 1);
    PROPERTY(status == KERN_LIMIT || limit == 0 || work->units <= limit);
    PROPERTY(work->error <= 1);
}

/* A verdict at a shrinkage has a proof that passes by itself. */
static void check_proof(const kern_task *task, kern_real shrink,
                        kern_status verdict)
{
    kern_work work = kern_work_of(proof_reals, 4 * BLOCKS, ints, 0);
    kern_task own = *task;
    own.work = &work;
    if (verdict == KERN_STANDS)
        PROPERTY(kern_check_forces(&own, shrink, force) <= 1);
    if (verdict == KERN_FALLS)
        PROPERTY(kern_check_motion(&own, shrink, motion) <= 1);
}

static void check_margin(const kern_task *task, const kern_margin *m,
                         kern_status status)
{
    PROPERTY(m->margin >= 0 && m->margin <= m->most);
    PROPERTY(m->holds >= 0 && m->holds <= m->margin && m->most >= m->fails);
    PROPERTY(m->level >= -1);
    if (status == KERN_FALLS) {
        PROPERTY(m->level == 0 && !(m->margin > 0));
        check_proof(task, 0, KERN_FALLS);
        return;
    }
    PROPERTY(m->level != 0);
    check_proof(task, m->holds, KERN_STANDS);
    if (!m->saturated)
        check_proof(task, m->fails, KERN_FALLS);
}

/* Asks question number `which`; returns its status. */
static kern_status ask(int which, kern_task *task, kern_real shrink)
{
    kern_proof proof;
    kern_margin m;
    kern_real out = KERN_R(0);
    kern_status status;
    memset(&m, 0, sizeof m);
    proof.force = force;
    proof.motion = motion;
    switch (which) {
    case 0:
        check_proof(task, shrink, kern_forces(task, shrink, force));
        status = kern_verdict(task, shrink, &proof);
        check_proof(task, shrink, status);
        return status;
    case 1:
        status = kern_measure(task, &m, &proof);
        if (status >= 0)
            check_margin(task, &m, status);
        if (status == KERN_STANDS) {
            const kern_status got = kern_sensitivity(task, &m, &proof, point,
                                                     stone);
            PROPERTY(got == KERN_OK || got == KERN_UNDECIDED);
        }
        return status;
    case 2:
        status = kern_deficit(task, &out);
        PROPERTY(status < 0 || out >= 0);
        return status;
    case 3:
        status = kern_load_factor(task, shrink, KERN_RIGHT, &out, NULL);
        PROPERTY(status < 0 || out >= 0);
        return status;
    default:
        status = kern_tilt(task, shrink, KERN_LEFT, &out, NULL);
        PROPERTY(status < 0 || (out >= 0 && out < KERN_R(3.15)));
        return status;
    }
}

/* One question, in work memory of the size given. */
static void check_structure(int which, const kern_structure *s,
                            const kern_options *o, kern_real shrink, int tame,
                            int real_room, int int_room)
{
    kern_work work = work_of(real_room, int_room);
    kern_task task = kern_task_of(s->block, s->blocks, s->contact, s->contacts,
                                  &work);
    kern_status status;
    int i, free_blocks = 0;
    task.s.gravity = s->gravity;
    task.options = *o;
    status = ask(which, &task, shrink);
    for (i = 0; i < s->blocks; i++)
        free_blocks += !s->block[i].fixed;
    PROPERTY(status >= KERN_STATUS_LEAST && status <= KERN_FALLS);
    check_work(&work, 3 * free_blocks, 2 * s->contacts, o->limit, status);
    if (status >= KERN_UNDECIDED) {
        count.asked[tame]++;
        count.undecided[tame] += status == KERN_UNDECIDED;
    }
    if (status < KERN_UNDECIDED)
        PROPERTY(status != KERN_BAD_NORMAL && status != KERN_BAD_LINE
                 && status != KERN_BAD_BLOCK && status != KERN_SAME_BLOCK);
}

/* ==== Text ========================================================== */
#endif

#ifdef FUZZ_DRAWING
/* Whatever the bytes: an error has a message, and what is made of a drawing can
   be read as text. */
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    static const char *const layer[] = {"stone=ground", "0=fill"};
    static const char *const density[] = {"2", "0=3"};
    static const char *const friction[] = {"stone=.5", "0,stone=.3"};
    struct shapes_asked asked;
    struct drawing drawing;
    struct text_file t;
    int bad;
    memset(&asked, 0, sizeof asked);
    asked.tolerance = 1.5;
    if (length > 0) { /* the last byte says what is asked */
        asked.layer = layer;
        asked.layers = data[length - 1] % 3;
        asked.densities = density;
        asked.density_words = data[length - 1] / 3 % 3;
        asked.has_ground = data[length - 1] / 9 % 2;
        asked.phi = data[length - 1] % 5 == 0 ? 30 : 0;
        asked.frictions = friction;
        asked.friction_words = data[length - 1] / 18 % 3;
        asked.ground = 1.5;
    }
    count_input();
    bad = drawing_parse(&t, &drawing, "x" FUZZ_DRAWING, (const char *)data,
                        length, &asked);
    PROPERTY(bad == 0 || bad == -1);
    PROPERTY(memchr(t.message, '\0', sizeof t.message) != NULL);
    PROPERTY(!bad || t.message[0]);
    /* what is made of a drawing can be read, unless its stones overlap, which
       shows where fill or friction needs the contacts; a DWG is refused before
       anything is made of it */
    if (bad && drawing.made && drawing.s.message.length == 0)
        fprintf(stderr, "%s\n%s\n", t.message, drawing.s.text.at);
    PROPERTY(!bad || !drawing.made || drawing.s.message.length > 0
             || strstr(t.message, "overlap"));
    PROPERTY(bad || (t.blocks > t.fixed && drawing.s.notes.at));
    for (int i = 0; i < drawing.s.skips; i++)
        PROPERTY(drawing.s.skip[i].count > 0);
    text_free(&t);
    drawing_free(&drawing);
    return 0;
}
#endif

#ifdef FUZZ_TEXT
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    struct text_file t;
    kern_contact contact[CONTACTS];
    kern_structure s;
    kern_work work = whole_work();
    const int bad = text_read(&t, (const char *)data, length);
    count_input();
    PROPERTY(bad == 0 || bad == -1);
    PROPERTY(memchr(t.message, '\0', sizeof t.message) != NULL);
    PROPERTY(!bad || (t.message[0] && t.line >= 0));
    if (!bad && t.blocks <= BLOCKS && t.contacts <= CONTACTS) {
        s.block = t.block;
        s.blocks = t.blocks;
        s.contact = t.given ? t.contact : contact;
        s.contacts = t.given ? t.contacts
                             : kern_contacts(t.block, t.blocks, &t.options,
                                             contact, CONTACTS, &work);
        s.gravity = t.gravity;
        if (s.contacts >= 0)
            check_structure((int)(length % QUESTIONS), &s, &t.options,
                            KERN_R(0.01), 0, KERN_REALS(BLOCKS, CONTACTS),
                            KERN_INTS(BLOCKS, CONTACTS));
    }
    text_free(&t);
    return 0;
}
#endif

/* ==== Structures from bytes ========================================= */

#ifdef FUZZ_STRUCTURE
enum { VERTICES = 7 };

typedef struct bytes {
    const uint8_t *at, *end;
    int tame;       /* only numbers of a mason so far          */
    kern_real last; /* number, that the next may be close to   */
} bytes;

static int byte_of(bytes *b) { return b->at < b->end ? *b->at++ : 0; }

static kern_real power_of_two(int exponent)
{
    kern_real power = KERN_R(1);
    for (; exponent > 0; exponent--)
        power *= 2;
    for (; exponent < 0; exponent++)
        power /= 2;
    return power;
}

/* A number, round more often than not. */
static kern_real number_of(bytes *b)
{
    const int kind = byte_of(b), value = byte_of(b) - 128;
    double raw;
    if (kind < 192) /* quarters */
        b->last = KERN_R(value) / 4;
    else if (kind < 232) /* almost the last one */
        b->last += KERN_R(value) * power_of_two(-20 - (kind - 192));
    else if (kind < 244) { /* huge or tiny */
        b->last = KERN_R(value) * power_of_two(byte_of(b) - 128);
        b->tame = 0;
    } else if (kind < 248) { /* any bits */
        uint64_t bits = 0;
        int i;
        for (i = 0; i < 8; i++)
            bits = bits << 8 | (unsigned)byte_of(b);
        memcpy(&raw, &bits, sizeof raw);
        if (raw < FLT_MAX && raw > -FLT_MAX) /* more is not for a float */
            b->last = KERN_R(raw);
        else
            b->last = KERN_INFINITY;
        b->tame = 0;
    } /* else the last one again */
    return b->last;
}

static kern_vec vec_of(bytes *b)
{
    kern_vec v;
    v.x = number_of(b);
    v.y = number_of(b);
    return v;
}

/* A box on a grid, some of whose corners are moved, or any polygon. */
static int polygon_of(bytes *b, kern_vec *v, int row)
{
    const int shape = byte_of(b);
    int i, n = 4;
    if (shape < 160) {
        const kern_real x = KERN_R(byte_of(b) % 16) / 4;
        const kern_real wide = KERN_R(1 + byte_of(b) % 16) / 4;
        for (i = 0; i < 4; i++) {
            v[i].x = i == 1 || i == 2 ? x + wide : x;
            v[i].y = KERN_R(row + (i > 1));
        }
        if (shape >= 80) /* one corner a little off */
            v[shape % 4].y += KERN_R(byte_of(b) - 128)
                            * power_of_two(-8 - byte_of(b) % 40);
    } else {
        n = shape % (VERTICES + 1);
        for (i = 0; i < n; i++)
            v[i] = vec_of(b);
    }
    return n;
}

static kern_options options_of(bytes *b)
{
    kern_options o = kern_defaults();
    const int flags = byte_of(b);
    o.relative = flags & 1;
    if (flags & 2)
        o.mu = number_of(b);
    if (flags & 4)
        o.gap = number_of(b);
    if (flags & 8)
        o.angle = number_of(b);
    if (flags & 16)
        o.epsilon = number_of(b);
    if (flags & 32) {
        o.limit = 16 * byte_of(b);
        b->tame = b->tame && o.limit == 0;
    }
    b->tame = b->tame && !(flags & 12);
    return o;
}

/* Contacts that are given one by one; returns how many points. */
static int contacts_of(bytes *b, int blocks, const kern_options *o,
                       kern_contact *contact)
{
    int n = 0;
    while (b->at < b->end && n + 2 <= CONTACTS) {
        const int a = byte_of(b) % (blocks + 1), other = byte_of(b) % blocks;
        const kern_vec normal = vec_of(b), p = vec_of(b);
        const kern_vec q = byte_of(b) % 2 ? p : vec_of(b);
        kern_contact *c = contact + n;
        int got;
        c->a = a % blocks;
        c->b = other;
        c->n = normal;
        c->p = p;
        c->mu = number_of(b);
        got = kern_contact_make(c, q, o);
        PROPERTY(got >= KERN_STATUS_LEAST && got != 0 && got <= 2);
        n += got > 0 ? got : 0;
    }
    kern_contact_travels(contact, n);
    return n;
}

/* The linear program by itself. */
static void check_program(bytes *b)
{
    enum { ROWS = 4, COLS = 7 };
    kern_real a[ROWS * COLS], rhs[ROWS], cost[COLS], x[COLS], y[ROWS];
    kern_work work = work_of(KERN_LP_REALS(ROWS, COLS),
                             KERN_LP_INTS(ROWS, COLS));
    kern_lp lp;
    kern_status status;
    int i;
    lp.rows = 1 + byte_of(b) % ROWS;
    lp.cols = 1 + byte_of(b) % COLS;
    lp.limit = byte_of(b) % 8 ? 0 : byte_of(b);
    lp.a = a;
    lp.rhs = rhs;
    lp.cost = byte_of(b) % 2 ? cost : NULL;
    for (i = 0; i < lp.rows * lp.cols; i++)
        a[i] = number_of(b);
    for (i = 0; i < lp.rows; i++)
        rhs[i] = number_of(b);
    for (i = 0; i < lp.cols; i++)
        cost[i] = number_of(b);
    status = kern_lp_solve(&lp, x, y, &work);
    check_work(&work, lp.rows, lp.cols, lp.limit, status);
    PROPERTY(status != KERN_NO_SPACE && status != KERN_BAD_POINTER
             && status != KERN_BAD_COUNT);
    if (status == KERN_LP_OPTIMAL || status == KERN_LP_UNBOUNDED)
        for (i = 0; i < lp.cols; i++)
            PROPERTY(x[i] >= 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length);
int LLVMFuzzerTestOneInput(const uint8_t *data, size_t length)
{
    kern_vec vertex[BLOCKS][VERTICES];
    kern_block block[BLOCKS];
    kern_contact contact[CONTACTS];
    kern_structure s;
    kern_options o;
    kern_real shrink;
    kern_work work = whole_work();
    bytes b;
    int i, blocks, flags, real_room, int_room;
    b.at = data;
    b.end = data + length;
    b.tame = 1;
    b.last = KERN_R(0);
    count_input();
    flags = byte_of(&b);
    if (flags % 16 == 15) {
        check_program(&b);
        return 0;
    }
    o = options_of(&b);
    shrink = flags & 1 ? KERN_R(byte_of(&b)) / 256 : KERN_R(0);
    real_room = KERN_REALS(BLOCKS, CONTACTS);
    int_room = KERN_INTS(BLOCKS, CONTACTS);
    if (flags & 2) { /* any size, most of them too small */
        real_room = (byte_of(&b) << 8 | byte_of(&b)) % real_room;
        int_room = (byte_of(&b) << 8 | byte_of(&b)) % int_room;
    }
    s.gravity = flags & 4 ? vec_of(&b)
                          : kern_vec_make(KERN_R(0), KERN_R(-9.81));
    blocks = 2 + byte_of(&b) % (BLOCKS - 1);
    for (i = s.blocks = 0; i < blocks; i++) {
        const int n = polygon_of(&b, vertex[s.blocks], i);
        const kern_real density = flags & 8 && i ? number_of(&b) : KERN_R(2);
        const kern_status made = i == 0 ? kern_ground_init(&block[0], vertex[0],
                                                           n, &work.fault)
                                        : kern_block_init(&block[s.blocks],
                                                          vertex[s.blocks], n,
                                                          density, &work.fault);
        if (made == KERN_OK)
            s.blocks++;
    }
    if (!b.tame && o.limit == 0)
        o.limit = 1000000; /* or it takes seconds where the simplex stalls */
    s.block = block;
    s.contact = contact;
    if (flags & 16 && s.blocks > 0)
        s.contacts = contacts_of(&b, s.blocks, &o, contact);
    else
        s.contacts = kern_contacts(block, s.blocks, &o, contact, CONTACTS,
                                   &work);
    PROPERTY(s.contacts >= KERN_STATUS_LEAST && s.contacts <= CONTACTS);
    if (s.contacts >= 0)
        check_structure((flags >> 5) % QUESTIONS, &s, &o, shrink, b.tame,
                        real_room, int_room);
    return 0;
}
#endif

/* ==== Without libFuzzer ============================================= */

#ifdef FUZZ_PLAIN
#include "../examples/parts/random.h"

static uint64_t state;

static unsigned random_byte(void)
{
    return (unsigned)(random_bits(&state) >> 56);
}

static void run_random(long many, unsigned seed)
{
    static uint8_t data[512];
    long k;
    for (k = 0; k < many; k++) {
        size_t i, length;
        state = random_from((uint64_t)seed * 1000003u + (uint64_t)k);
        length = 16 + 2 * random_byte() % (sizeof data - 16);
        for (i = 0; i < length; i++)
            data[i] = (uint8_t)random_byte();
        LLVMFuzzerTestOneInput(data, length);
    }
}

static int run_file(const char *path)
{
    static uint8_t data[1 << 20];
    FILE *in = fopen(path, "rb");
    size_t length;
    if (!in) {
        perror(path);
        return 1;
    }
    length = fread(data, 1, sizeof data, in);
    fclose(in);
    LLVMFuzzerTestOneInput(data, length);
    return 0;
}

int main(int argc, char **argv)
{
    int i, failed = 0;
    if (argc > 2 && strcmp(argv[1], "--random") == 0) {
        run_random(atol(argv[2]), argc > 3 ? (unsigned)atol(argv[3]) : 1);
        return 0;
    }
    for (i = 1; i < argc; i++)
        failed += run_file(argv[i]);
    return failed ? 1 : 0;
}
#endif
