/* page.c - what page.html calls of kern.h, as WebAssembly: build.sh compiles it
   without a C library.

   One structure lies in static arrays, which the page reads and writes as
   arrays of double. A status is that of kern.h, and where it is below zero
   `fault` holds block, other, index and value.

   SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#define KERN_SQRT(x) __builtin_sqrt(x) /* an instruction */
#include "../../kern.h"
#include "../parts/falls.h"
#include "heap.h"

#include "../parts/drawing.h"

#define PAGE(name) __attribute__((export_name(#name)))

enum {
    BLOCKS = 400,
    CONTACTS = 6000,
    VERTICES = 40000,
    PAIRS = 50,
    LIMIT = 1000000
}; /* units of work, before a page seems to hang */

/* Exported by build.sh: the page finds them by name. */
kern_vec vertex[VERTICES];  /* of all blocks, written by the page         */
kern_force force[CONTACTS]; /* of the last call that found KERN_STANDS    */
kern_motion motion[BLOCKS]; /* of the last one that found KERN_FALLS, and
                                  of measure()                               */
int meeting[CONTACTS];      /* of contact points, by critical(): hinges 1 */
int group[BLOCKS];          /* of blocks that move as one, by critical();
                                  -1: rests                                  */
double centre[BLOCKS][2];
double point[CONTACTS][8];  /* a, b, line, x, y, normal, travel           */
double overlap[PAIRS][3];   /* a, b, depth                                */
double fault[4], answer[6]; /* answer: of the last call                   */
const int constant[9] = {BLOCKS,     VERTICES,      KERN_STANDS,
                         KERN_FALLS, KERN_OVERLAP,  KERN_RAISED,
                         KERN_HANGS, KERN_END_LOST, KERN_END_WORK};

static kern_block block[BLOCKS];
static kern_wrench live[BLOCKS]; /* the live load, about the centres          */
static kern_contact contact[CONTACTS];
static kern_real real[KERN_REALS(BLOCKS, CONTACTS)];
static int indices[KERN_INTS(BLOCKS, CONTACTS)];
static kern_work work;
static kern_task task;
static int made; /* blocks, the one in the hand with them                   */
static int held; /* 1: the last block is in the hand, not in the structure  */

static int report(int status, const kern_fault *f)
{
    fault[0] = f->block;
    fault[1] = f->other;
    fault[2] = f->index;
    fault[3] = f->value;
    return status;
}

PAGE(text) const char *page_text(int status)
{
    return kern_status_text((kern_status)status);
}

PAGE(gravity) void page_gravity(double x, double y)
{
    task.s.gravity.x = x;
    task.s.gravity.y = y;
}

/* A new structure without blocks. */
PAGE(begin) void page_begin(double gravity_x, double gravity_y)
{
    work = kern_work_of(real, KERN_REALS(BLOCKS, CONTACTS), indices,
                        KERN_INTS(BLOCKS, CONTACTS));
    task = kern_task_of(block, 0, contact, 0, &work);
    made = held = 0;
    page_gravity(gravity_x, gravity_y);
}

/* After the blocks; error and turn: of measured places, 0: exact, or not told. */
PAGE(options)
void page_options(double mu, double gap, double angle, double epsilon,
                  double error, double turn)
{
    task.options = kern_defaults();
    task.options.mu = mu;
    task.options.gap = gap;
    task.options.angle = angle;
    task.options.epsilon = epsilon;
    task.options.limit = LIMIT;
    if (error > 0)
        task.options = kern_measured_options(
            &task.options, error,
            turn > 0 ? turn : error / kern_mean_size(block, task.s.blocks));
}

static void put_centre(int i)
{
    centre[i][0] = block[i].centre.x;
    centre[i][1] = block[i].centre.y;
}

/* Block i, the next or one that was there, from vertices of the array; density
   0: fixed. */
PAGE(block) int page_block(int i, int first, int vertices, double density)
{
    kern_fault f = {.block = i, .other = -1, .index = -1};
    int status = density > 0
                   ? kern_block_init(&block[i], vertex + first, vertices,
                                     density, &f)
                   : kern_ground_init(&block[i], vertex + first, vertices, &f);
    const kern_wrench none = {0, 0, 0};
    f.block = i;
    live[i] = none;
    put_centre(i);
    if (i >= made)
        made = i + 1;
    task.s.blocks = made - held;
    return report(status, &f);
}

/* Takes the last block into the hand (1), or lets it go (0). A block in the hand
   is no part of the structure. */
PAGE(hold) void page_hold(int last)
{
    held = last;
    task.s.blocks = made - held;
}

PAGE(mass) void page_mass(int i, double mass) { block[i].mass = mass; }

PAGE(move_centre) void page_move_centre(int i, double x, double y)
{
    block[i].centre.x = x;
    block[i].centre.y = y;
    put_centre(i);
}

PAGE(load)
void page_load(int i, double fx, double fy, double x, double y, double torque)
{
    kern_vec f = {fx, fy}, at = {x, y};
    kern_block_load(&block[i], f, at, torque);
}

/* Weight that is no stone: the centre moves toward it. */
PAGE(weight) void page_weight(int i, double mass, double x, double y)
{
    kern_block *b = &block[i];
    b->mass += mass;
    b->centre.x += mass / b->mass * (x - b->centre.x);
    b->centre.y += mass / b->mass * (y - b->centre.y);
    put_centre(i);
}

PAGE(live) void page_live(int i, double fx, double fy, double x, double y)
{
    kern_vec f = {fx, fy}, at = {x, y};
    kern_block alone = block[i];
    alone.load = live[i];
    kern_block_load(&alone, f, at, 0);
    live[i] = alone.load;
}

/* ---- Drawings ---- */

static struct drawing drawing;
static struct shapes_text skipped;

/* Room for bytes that the page writes: of a new file, or one more of it. */
PAGE(room) char *page_room(int bytes, int fresh)
{
    if (fresh)
        heap_reset();
    return malloc((size_t)bytes);
}

/* One line a kind of what became no block. */
static void put_skipped(void)
{
    const struct shapes_text empty = {NULL, 0, 0, 0};
    skipped = empty;
    shapes_put(&skipped, "");
    for (int i = 0; i < drawing.s.skips; i++) {
        const struct shapes_skip *k = drawing.s.skip + i;
        shapes_put_int(&skipped, k->count);
        shapes_put(&skipped, " ");
        shapes_put(&skipped, shapes_at(&drawing.s, k->kind));
        if (*shapes_at(&drawing.s, k->label))
            shapes_put(&skipped, " on ");
        shapes_put(&skipped, shapes_at(&drawing.s, k->label));
        shapes_put(&skipped, ", line ");
        shapes_put_int(&skipped, k->line);
        shapes_put(&skipped, "\n");
    }
}

/* What the user says about the next drawings: words as those of the program's
   --layer and --density, which stay in the page's room. */
enum { WORDS = 64 };
static const char *layer[WORDS], *density_word[WORDS];
static struct shapes_asked asked;

PAGE(asked) void page_asked(int has_ground, double ground)
{
    const struct shapes_asked fresh = {.layer = layer,
                                       .densities = density_word,
                                       .has_ground = has_ground,
                                       .ground = ground,
                                       .tolerance = 1.5};
    asked = fresh;
}

/* Adds one word, 0: there are too many, or no role has that name. */
PAGE(layer) int page_layer(const char *word)
{
    const int at = shapes_equals(word);
    if (asked.layers == WORDS || at < 1
        || shapes_role_named(word + at + 1, (int)strlen(word + at + 1)) < 0)
        return 0;
    layer[asked.layers++] = word;
    return 1;
}

/* Adds one word, 0: there are too many. */
PAGE(density) int page_density(const char *word)
{
    if (asked.density_words == WORDS)
        return 0;
    density_word[asked.density_words++] = word;
    return 1;
}

/* Makes statements of a drawing or a photograph in a file of that name: 1, 0: it
   is in the text format, -1: with a message. */
PAGE(draw) int page_draw(const char *name, const char *data, int length)
{
    const enum drawing_format format = drawing_format(name, data,
                                                      (size_t)length);
    int bad;
    if (format == DRAWING_TEXT && !drawing_foreign(data, (size_t)length))
        return 0;
    bad = drawing_make(&drawing, format, data, (size_t)length, &asked);
    put_skipped();
    return bad ? -1 : 1;
}

/* What was made: 0 statements, 1 notes, 2 what was skipped, 3 the message. */
PAGE(drawn) const char *page_drawn(int what)
{
    const char *const text[] = {drawing.s.text.at, drawing.s.notes.at,
                                skipped.at, drawing.s.message.at};
    return text[what] ? text[what] : "";
}

/* The line of the message, 0: the whole file. */
PAGE(drawn_line) int page_drawn_line(void) { return drawing.s.fault; }

/* Shows the page the contacts that there are. */
static int put_contacts(int contacts)
{
    int i;
    for (i = 0; i < contacts; i++) {
        const kern_contact *c = &contact[i];
        double *out = point[i];
        out[0] = c->a;
        out[1] = c->b;
        out[2] = c->line;
        out[3] = c->p.x;
        out[4] = c->p.y;
        out[5] = c->n.x;
        out[6] = c->n.y;
        out[7] = c->travel;
    }
    task.s.contacts = contacts;
    return contacts;
}

/* Finds the contacts: how many points, or a status below zero. */
PAGE(find) int page_find(void)
{
    int found = kern_contacts(block, task.s.blocks, &task.options, contact,
                              CONTACTS, &work);
    return report(found < 0 ? found : put_contacts(found), &work.fault);
}

/* All pairs that overlap deeper than they may: how many of them are shown. */
PAGE(overlaps) int page_overlaps(void)
{
    kern_overlap pair[PAIRS];
    int i, found = kern_overlaps(block, task.s.blocks, &task.options, pair,
                                 PAIRS, &work);
    if (found > PAIRS)
        found = PAIRS;
    for (i = 0; i < found; i++) {
        overlap[i][0] = pair[i].a;
        overlap[i][1] = pair[i].b;
        overlap[i][2] = pair[i].depth;
    }
    return report(found, &work.fault);
}

/* How block i lies against the others: how many contact points it has with a
   normal that is more upright than not, or a status below zero. */
PAGE(rests) int page_rests(int i)
{
    int other, k, upright = 0;
    for (other = 0; other < task.s.blocks; other++) {
        const kern_block pair[2] = {block[other], block[i]};
        int found = other == i ? 0
                               : kern_touch(pair, 1, &task.options, contact,
                                            CONTACTS, &work);
        if (found < 0)
            return found;
        for (k = 0; k < found; k++)
            upright += contact[k].n.y * contact[k].n.y > 0.5;
    }
    return upright;
}

/* Returns the height of a block's lowest vertex. */
static double foot(const kern_block *b, kern_vec down)
{
    double height = KERN_INFINITY;
    int k;
    for (k = 0; k < b->vertices; k++)
        height = kern_min(height, -kern_vec_dot(b->vertex[k], down));
    return height;
}

/* Finds where block i comes to rest on the blocks that begin lower than `above`
   over its centre. Answer: its centre there, cosine and sine of its turn. */
PAGE(rest) int page_rest(int i, double above)
{
    static kern_block under[BLOCKS];
    static kern_vec there[VERTICES];
    const kern_vec down = kern_vec_unit(task.s.gravity), upright = {1, 0};
    const kern_vec from = block[i].centre;
    kern_task other = task;
    kern_pose pose;
    int k, n = 0, status;
    for (k = 0; k < task.s.blocks; k++)
        if (k != i && foot(&block[k], down) + kern_vec_dot(from, down) < above)
            under[n++] = block[k];
    other.s.block = under;
    other.s.blocks = n;
    other.s.contacts = 0;
    other.known = kern_known_of(NULL, NULL);
    status = kern_rest(&other, &block[i], kern_vec_cross(down, from), upright,
                       there, &pose);
    if (status == KERN_OK) {
        answer[0] = pose.block.centre.x;
        answer[1] = pose.block.centre.y;
        answer[2] = pose.turn.x;
        answer[3] = pose.turn.y;
    }
    return report(status, &work.fault);
}

/* A contact that is given, from p to q; after the last one, given(). */
PAGE(contact)
int page_contact(int a, int b, double nx, double ny, double px, double py,
                 double qx, double qy, double mu)
{
    kern_contact c = {.a = a, .b = b, .p = {px, py}, .n = {nx, ny}, .mu = mu};
    kern_vec q = {qx, qy};
    int made;
    if (task.s.contacts + 2 > CONTACTS)
        return KERN_NO_SPACE;
    contact[task.s.contacts] = c;
    made = kern_contact_make(&contact[task.s.contacts], q, &task.options);
    if (made > 0)
        task.s.contacts += made;
    return made;
}

PAGE(given) int page_given(void)
{
    kern_contact_travels(contact, task.s.contacts);
    return put_contacts(task.s.contacts);
}

PAGE(verdict) int page_verdict(double shrink)
{
    kern_proof proof = {force, motion};
    return report(kern_verdict(&task, shrink, &proof), &work.fault);
}

/* The least forces, in place of those of the verdict. */
PAGE(forces) int page_forces(double shrink)
{
    return report(kern_forces(&task, shrink, force), &work.fault);
}

/* Answer: margin, level, saturated, most, fails, mean block size. */
PAGE(measure) int page_measure(void)
{
    kern_proof proof = {force, motion};
    kern_margin m = {.margin = 0};
    int status = kern_measure(&task, &m, &proof);
    answer[0] = m.margin;
    answer[1] = m.level;
    answer[2] = m.saturated;
    answer[3] = m.most;
    answer[4] = m.fails;
    answer[5] = kern_mean_size(block, task.s.blocks);
    return report(status, &work.fault);
}

/* Adds to the motion of a verdict those with which the rest falls. */
PAGE(falls) void page_falls(double shrink)
{
    static kern_block rest[BLOCKS];
    static kern_contact touch[CONTACTS];
    static kern_motion moved[BLOCKS];
    static int place[BLOCKS];
    struct falls_part left = {rest, touch, moved, place};
    falls_all(&task, shrink, motion, &left);
}

/* After a verdict or a measure: the contact point that limits most, or -1. */
PAGE(critical) int page_critical(double shrink, int stands)
{
    kern_proof proof = {stands ? force : NULL, motion};
    kern_critical out = {
        .meeting = (kern_meeting *)meeting, .group = group, .contact = -1};
    kern_critical_of(&task, shrink, &proof, &out);
    return out.contact;
}

/* Were all places known to within e only: the verdict, and in answer whether
   it is certain. */
PAGE(measured) int page_measured(double e)
{
    static kern_contact measured[CONTACTS], scratch[CONTACTS];
    kern_task other = task;
    kern_margin m = {.margin = 0};
    kern_interval in;
    int status;
    other.known = kern_known_of(NULL, NULL);
    other.options = kern_measured_options(
        &task.options, e, e / kern_mean_size(block, task.s.blocks));
    other.s.contact = measured;
    other.s.contacts = kern_contacts(block, task.s.blocks, &other.options,
                                     measured, CONTACTS, &work);
    if (other.s.contacts < 0)
        return report(other.s.contacts, &work.fault);
    status = kern_measure(&other, &m, NULL);
    answer[0] = status < 0
                  ? 0
                  : kern_certain(&other, m.margin, &in, scratch, CONTACTS) > 0;
    return report(status, &work.fault);
}

/* Answer: the margin where friction narrows as well (kern_options). */
PAGE(narrowed) int page_narrowed(double narrow)
{
    kern_margin m = {.margin = 0};
    int status;
    task.options.narrow = narrow;
    status = kern_measure(&task, &m, NULL);
    task.options.narrow = 0;
    answer[0] = m.margin;
    return report(status, &work.fault);
}

/* Answer: the load factor to the right (side 1) or left (-1). */
PAGE(load_factor) int page_load_factor(int side)
{
    return report(kern_load_factor(&task, 0, (kern_side)side, &answer[0], NULL),
                  &work.fault);
}

/* Answer: the factor of the live load. */
PAGE(live_factor) int page_live_factor(void)
{
    return report(kern_load_factor_of(&task, 0, live, &answer[0], NULL),
                  &work.fault);
}

/* Answer: the factor of Coulomb friction, from rest, of a horizontal load to a
   side, or (0) of the live load. */
PAGE(raised_load) int page_raised_load(int side)
{
    return report(kern_raised_load(&task, 0, (kern_side)side,
                                   side ? NULL : live, &answer[0], NULL),
                  &work.fault);
}

/* Answer: how it is held (kern_raising), why a search ended (kern_end). The
   motion is that of a structure that moves. */
PAGE(let_go) int page_let_go(void)
{
    kern_raising how = KERN_NOT_SHOWN;
    kern_proof proof = {NULL, motion};
    int status;
    work.end = KERN_END_NONE;
    status = kern_let_go(&task, &how, &proof);
    answer[0] = how;
    answer[1] = work.end;
    return report(status, &work.fault);
}

/* Answer: the tilt [rad] up to which forces hold it, to the right (side 1) or
   left (-1). */
PAGE(tilt) int page_tilt(int side)
{
    return report(kern_tilt(&task, 0, (kern_side)side, &answer[0], NULL),
                  &work.fault);
}

/* Answer: the chance that block i, laid last, stays where it is let go. */
PAGE(stays) int page_stays(int i)
{
    return report(kern_stays(&task, i, &answer[0]), &work.fault);
}

/* Answer: how it is held (kern_raising), and the sideways reserve. */
PAGE(raised) int page_raised(void)
{
    kern_raising raising = KERN_NOT_SHOWN;
    int status = kern_raised(&task, 0, &raising, &answer[1], NULL);
    answer[0] = raising;
    return report(status, &work.fault);
}

/* Answer: the deficit. */
PAGE(deficit) int page_deficit(void)
{
    return report(kern_deficit(&task, &answer[0]), &work.fault);
}
