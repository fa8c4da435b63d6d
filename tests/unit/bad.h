/* bad.h - bad input. */

#ifndef UNIT_BAD_H
#define UNIT_BAD_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "plan.h"

/* Every entry that takes a structure says the same of a bad one. */
static void all_say(const kern_structure *s, const kern_options *o,
                    kern_work *work, int want, int block, int index,
                    const char *where)
{
    kern_margin m;
    kern_real out = R(7), value[MAX_BLOCKS];
    kern_collapse all;
    int k;
    all.mean = R(7);
    memset(&m, 0x55, sizeof m);
    for (k = 0; k < 6; k++) {
        kern_margin keep = m;
        int got;
        if (work)
            work->fault.block = work->fault.index = -77;
        got = k == 0 ? kern_verdict(task_of(s, o, work), 0, NULL)
            : k == 1 ? kern_measure(task_of(s, o, work), &m, NULL)
            : k == 2 ? kern_deficit(task_of(s, o, work), &out)
            : k == 3 ? kern_load_factor(task_of(s, o, work), 0, KERN_RIGHT,
                                        &out, NULL)
            : k == 4
                ? kern_tilt(task_of(s, o, work), 0, KERN_RIGHT, &out, NULL)
                : kern_profile(task_of(s, o, work), KERN_SHRINK, value, &all);
        check_near(got, want, 0, where, "status of a bad structure");
        /* nothing but the fault is touched */
        check_report(!memcmp(&keep, &m, sizeof m), where, "margin untouched", 0,
                     0, 0);
        check_near((double)out, 7, 0, where, "result untouched");
        check_near((double)all.mean, 7, 0, where, "means untouched");
        if (work && block >= -1)
            check_near(work->fault.block, block, 0, where, "fault.block");
        if (work && index >= -1)
            check_near(work->fault.index, index, 0, where, "fault.index");
    }
}

/* A field of the world with a value that makes the structure bad, and what the
   library says: a status, and in the fault the index of a block or a contact
   (-2: any). Blocks 0, 1, 2 stand on each other; contacts 0 and 1 lie between
   the first two, 2 and 3 between the last two. */
typedef struct spoilt {
    const char *where;
    size_t field;
    int whole; /* nonzero: the field is an int */
    double value;
    int want, block, index;
} spoilt;

#define REAL(field, value, want, block, index)                     \
    {                                                              \
        HERE, offsetof(world, field), 0, value, want, block, index \
    }
#define WHOLE(field, value, want, block, index)                    \
    {                                                              \
        HERE, offsetof(world, field), 1, value, want, block, index \
    }

static const spoilt bad_values[] = {
    WHOLE(blocks, -1, KERN_BAD_COUNT, -2, -2),
    WHOLE(contacts, -1, KERN_BAD_COUNT, -2, -2),
    WHOLE(blocks, 2147483647, KERN_BAD_COUNT, -2, -2),
    WHOLE(contacts, 2147483647, KERN_BAD_COUNT, -2, -2),
    REAL(block[1].mass, 0, KERN_BAD_MASS, 1, -2),
    REAL(block[1].mass, -3, KERN_BAD_MASS, 1, -2),
    REAL(contact[1].mu, -0.1, KERN_BAD_FRICTION, -2, 1),
    WHOLE(contact[2].a, -1, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].b, 3, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].b, 2147483647, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[2].a, -2147483648.0, KERN_BAD_BLOCK, -2, 2),
    WHOLE(contact[0].a, 1, KERN_SAME_BLOCK, -2, 0),
    REAL(contact[0].n.y, 0, KERN_BAD_NORMAL, -2, 0),
    REAL(options.epsilon, -1, KERN_BAD_OPTION, -2, -2),
    WHOLE(options.limit, -1, KERN_BAD_OPTION, -2, -2),
    WHOLE(options.limit, 2000000001, KERN_BAD_OPTION, -2, -2),
};

#define NUMBER(field, block, index) \
    REAL(field, 0, KERN_BAD_NUMBER, block, index)
static const spoilt numbers_of_a_structure[] = {
    NUMBER(block[2].mass, 2, -2),     NUMBER(block[2].centre.x, 2, -2),
    NUMBER(block[2].centre.y, 2, -2), NUMBER(block[2].load.fx, 2, -2),
    NUMBER(block[2].load.fy, 2, -2),  NUMBER(block[2].load.torque, 2, -2),
    NUMBER(block[2].area, 2, -2),     NUMBER(contact[3].p.x, -2, 3),
    NUMBER(contact[3].p.y, -2, 3),    NUMBER(contact[3].n.x, -2, 3),
    NUMBER(contact[3].n.y, -2, 3),    NUMBER(contact[3].mu, -2, 3),
    NUMBER(contact[3].travel, -2, 3), NUMBER(gravity.x, -2, -2),
    NUMBER(gravity.y, -2, -2),        NUMBER(options.epsilon, -2, -2),
};

static void spoil(world *w, const spoilt *row, double value)
{
    void *field = (char *)w + row->field;
    if (row->whole)
        *(int *)field = (int)value;
    else
        *(kern_real *)field = R(value);
}

/* Calls say() of each row with its own value, and of each of a second table
   with all that is not a number. */
static void spoil_each(const world *good, const spoilt *row, int rows,
                       const spoilt *number, int numbers,
                       void (*say)(const world *, const spoilt *, double))
{
    int i, j;
    for (i = 0; i < rows; i++)
        say(good, &row[i], row[i].value);
    for (i = 0; i < numbers; i++)
        for (j = 0; j < NO_NUMBERS; j++)
            say(good, &number[i], no_number(j));
}

/* Every entry, asked about a stack of two in which one field has a value. */
static void say_of_row(const world *good, const spoilt *row, double value)
{
    static world w;
    kern_structure s;
    kern_work work = work_of(good);
    world_copy(&w, good);
    spoil(&w, row, value);
    s = structure_of(&w);
    all_say(&s, &w.options, &work, row->want, row->block, row->index,
            row->where);
}

static void bad_structure(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    int i;
    stack_of_two(&w, 0.25);
    CHECK_INT(w.contacts, 4);
    s = structure_of(&w);
    work = work_of(&w);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_STANDS);
    spoil_each(&w, bad_values, COUNT_OF(bad_values), numbers_of_a_structure,
               COUNT_OF(numbers_of_a_structure), say_of_row);
    /* no block, the ground alone, nothing but fixed blocks */
    work = work_of(&w);
    s.contacts = 0;
    for (i = 0; i < 2; i++) {
        s.blocks = i;
        all_say(&s, &w.options, &work, KERN_NO_FREE, -2, -2, HERE);
    }
    s = structure_of(&w);
    w.block[1].fixed = w.block[2].fixed = 1;
    all_say(&s, &w.options, &work, KERN_NO_FREE, -2, -2, HERE);
    /* what is wrong with a fixed block's mass does not matter */
    stack_of_two(&w, 0.25);
    w.block[0].mass = R(-5);
    CHECK_INT(kern_verdict(task_of(&s, &w.options, &work), 0, NULL),
              KERN_STANDS);
}

static void bad_pointers(void)
{
    static world w;
    kern_structure s;
    kern_work work;
    kern_real out;
    stack_of_two(&w, 0.25);
    work = work_of(&w);
    s = structure_of(&w);
    s.block = NULL;
    all_say(&s, &w.options, &work, KERN_BAD_POINTER, -2, -2, HERE);
    s = structure_of(&w);
    s.contact = NULL;
    all_say(&s, &w.options, &work, KERN_BAD_POINTER, -2, -2, HERE);
    s = structure_of(&w);
    all_say(NULL, &w.options, &work, KERN_BAD_POINTER, -2, -2, HERE);
    all_say(&s, NULL, &work, KERN_BAD_POINTER, -2, -2, HERE);
    all_say(&s, &w.options, NULL, KERN_BAD_POINTER, -2, -2, HERE);
    CHECK_INT(kern_measure(task_of(&s, &w.options, &work), NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_deficit(task_of(&s, &w.options, &work), NULL),
              KERN_BAD_POINTER);
    CHECK_INT(kern_load_factor(task_of(&s, &w.options, &work), 0, KERN_RIGHT,
                               NULL, NULL),
              KERN_BAD_POINTER);
    CHECK_INT(
        kern_tilt(task_of(&s, &w.options, &work), 0, KERN_RIGHT, NULL, NULL),
        KERN_BAD_POINTER);
    CHECK_INT(kern_load_factor(task_of(&s, &w.options, &work), 0, KERN_SHRINK,
                               &out, NULL),
              KERN_BAD_OPTION);
    CHECK_INT(kern_tilt(task_of(&s, &w.options, &work), 0, 2, &out, NULL),
              KERN_BAD_OPTION);
    /* a proof that cannot be read is none */
    CHECK(kern_check_forces(task_of(&s, &w.options, &work), 0, NULL) > 1);
    CHECK(kern_check_motion(task_of(&s, &w.options, &work), 0, NULL) > 1);
}

/* Shrinkages and load patterns that are no numbers, patterns that are too large. */
static void bad_arguments(void)
{
    static world w;
    kern_work work;
    kern_real out;
    int i, j;
    stack_of_two(&w, 0.25);
    work = work_of(&w);
    for (j = 0; j < NO_NUMBERS; j++) {
        const kern_real bad = R(no_number(j));
        CHECK_INT(kern_verdict(world_task(&w, &work), bad, NULL),
                  KERN_BAD_NUMBER);
        CHECK_INT(kern_tilt(world_task(&w, &work), bad, KERN_RIGHT, &out, NULL),
                  KERN_BAD_NUMBER);
        CHECK_INT(kern_load_factor(world_task(&w, &work), bad, KERN_RIGHT, &out,
                                   NULL),
                  KERN_BAD_NUMBER);
        for (i = 0; i < 6; i++) {
            kern_wrench pattern[3];
            memset(pattern, 0, sizeof pattern);
            *(i % 3 == 0 ? &pattern[1].fx
              : i % 3 == 1
                  ? &pattern[1].fy
                  : &pattern[1].torque) = i < 3 ? bad : R(SINGLE ? 1e11 : 1e61);
            CHECK_INT(kern_load_factor_of(world_task(&w, &work), 0, pattern,
                                          &out, NULL),
                      KERN_BAD_NUMBER);
            CHECK_INT(work.fault.block, 1);
        }
    }
}

/* The same for kern_contacts(): w.options are those it is given. */
static const spoilt bad_geometries[] = {
    REAL(options.mu, -1, KERN_BAD_FRICTION, -2, -2),
    REAL(options.gap, -1, KERN_BAD_OPTION, -2, -2),
    REAL(options.angle, -1, KERN_BAD_OPTION, -2, -2),
    REAL(options.angle, 0.5, KERN_BAD_OPTION, -2, -2),
    WHOLE(block[2].vertices, 2, KERN_FEW_VERTICES, 2, -2),
};

static const spoilt numbers_of_a_geometry[] = {
    NUMBER(block[1].box.low.x, 1, -1),  NUMBER(block[1].box.low.y, 1, -1),
    NUMBER(block[1].box.high.x, 1, -1), NUMBER(block[1].box.high.y, 1, -1),
    NUMBER(block[1].area, 1, -1),       NUMBER(options.mu, -2, -2),
    NUMBER(options.gap, -2, -2),        NUMBER(options.angle, -2, -2),
};

/* What kern_contacts() says of a world; the fault goes to *fault. */
static int contacts_say(const world *w, kern_fault *fault)
{
    static kern_contact out[64];
    int index[6], got;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    memset(&work.fault, 0x55, sizeof work.fault);
    got = kern_contacts(w->block, w->blocks, &w->options, out, 64, &work);
    *fault = work.fault;
    return got;
}

static void contacts_say_of_row(const world *good, const spoilt *row,
                                double value)
{
    static world w;
    kern_fault fault;
    world_copy(&w, good);
    spoil(&w, row, value);
    check_near(contacts_say(&w, &fault), row->want, 0, row->where,
               "status of bad geometry");
    if (row->block > -2)
        check_near(fault.block, row->block, 0, row->where, "fault.block");
    if (row->index > -2)
        check_near(fault.index, row->index, 0, row->where, "fault.index");
}

static void bad_geometry(void)
{
    static world w;
    kern_fault fault;
    stack_of_two(&w, 0.25);
    CHECK_INT(contacts_say(&w, &fault), 4);
    spoil_each(&w, bad_geometries, COUNT_OF(bad_geometries),
               numbers_of_a_geometry, COUNT_OF(numbers_of_a_geometry),
               contacts_say_of_row);
    w.options.angle = R(0.49);
    CHECK(contacts_say(&w, &fault) >= 0);
    w.options = kern_defaults();
    w.block[2].vertices = -2;
    CHECK_INT(contacts_say(&w, &fault), KERN_NO_BLOCK);
    CHECK_INT(fault.block, 2);
    w.block[2].vertices = 4;
    w.block[2].vertex = NULL;
    CHECK_INT(contacts_say(&w, &fault), KERN_BAD_POINTER);
    CHECK_INT(fault.block, 2);
    /* a block without a polygon touches nothing */
    w.block[2].vertices = 0;
    CHECK_INT(contacts_say(&w, &fault), 2);
}

/* An init that fails in way k. */
static kern_status refused(kern_block *b, int k)
{
    static const kern_vec square[] = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
    static const kern_vec bow[] = {{0, 0}, {1, 1}, {1, 0}, {0, 1}};
    static kern_vec hole[4];
    memcpy(hole, square, sizeof hole);
    hole[2].x = R(not_a_number());
    switch (k) {
    case 0: return kern_block_init(b, hole, 4, 1, NULL);
    case 1: return kern_block_init(b, bow, 4, 1, NULL);
    case 2: return kern_block_init(b, square, 2, 1, NULL);
    case 3: return kern_block_init(b, square, -1, 1, NULL);
    case 4: return kern_block_init(b, square, 4, 0, NULL);
    case 5: return kern_block_init(b, NULL, 4, 1, NULL);
    case 6: return kern_ground_init(b, hole, 4, NULL);
    default: return kern_ground_init(b, NULL, 0, NULL);
    }
}

/* What plans say of a block that was refused. */
static void plans_refuse(const world *w, const kern_block *b)
{
    static site p;
    kern_margin m;
    kern_raising raising;
    site_open(&p, w);
    site_add(&p, 0);
    CHECK_INT(kern_plan_add(&p.plan, b), KERN_NO_BLOCK);
    CHECK_INT(p.work.fault.block, 1);
    CHECK_INT(kern_plan_try(&p.plan, b, &m, NULL), KERN_NO_BLOCK);
    CHECK_INT(kern_plan_bears(&p.plan, b, 0, NULL), KERN_NO_BLOCK);
    CHECK_INT(kern_plan_raised(&p.plan, b, &raising, NULL, NULL),
              KERN_NO_BLOCK);
    CHECK_INT(p.plan.task.s.blocks, 1);
}

/* A block whose init failed was that of the call before, and its answer was
   given again. Now every call refuses it, whatever is set in it by hand, until
   an init succeeds. */
static void refused_blocks(void)
{
    static world w;
    static kern_overlap overlap[4];
    kern_proof proof = proof_here();
    kern_margin m;
    kern_interval in;
    kern_critical critical = {NULL, NULL, NULL, 0, 0};
    kern_raising raising;
    kern_real value = 0;
    int k;
    for (k = 0; k < 8; k++) {
        kern_contact out[8];
        kern_block good, *b = &w.block[1];
        kern_contact_rate rate[8];
        kern_block_rate of[3];
        kern_structure s;
        kern_work work;
        kern_task *task;
        stack_of_two(&w, 0.25);
        good = *b;
        work = work_of(&w);
        s = structure_of(&w);
        CHECK_INT(kern_measure(task_of(&s, &w.options, &work), &m, &proof),
                  KERN_STANDS);
        CHECK(refused(b, k) < 0);
        CHECK_INT(b->vertices, -1);
        CHECK_NEAR(kern_mean_size(b, 1), 0, 0);
        b->mass = good.mass;
        b->centre = good.centre;
        b->area = good.area;
        b->box = good.box;
        all_say(&s, &w.options, &work, KERN_NO_BLOCK, 1, -2, HERE);
        task = task_of(&s, &w.options, &work);
        CHECK_INT(kern_raised(task, 0, &raising, NULL, NULL), KERN_NO_BLOCK);
        CHECK_INT(kern_forces(task, 0, force_of), KERN_NO_BLOCK);
        CHECK_INT(kern_bearing(task, &value, NULL), KERN_NO_BLOCK);
        CHECK_INT(kern_critical_of(task, 0, &proof, &critical), KERN_NO_BLOCK);
        CHECK_INT(kern_sensitivity(task, &m, &proof, rate, of), KERN_NO_BLOCK);
        CHECK(isinf(kern_check_forces(task, 0, force_of)));
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work),
                  KERN_NO_BLOCK);
        CHECK_INT(work.fault.block, 1);
        CHECK_INT(kern_touch(w.block, 2, &w.options, out, 8, &work),
                  KERN_NO_BLOCK);
        CHECK_INT(kern_overlaps(w.block, 3, &w.options, overlap, 4, &work),
                  KERN_NO_BLOCK);
        task->options = kern_measured_options(&w.options, R(0.001), R(0.001));
        CHECK_INT(kern_certain(task, 0, &in, out, 8), KERN_NO_BLOCK);
        plans_refuse(&w, b);
        CHECK_INT(kern_block_init(b, good.vertex, good.vertices, 1, NULL),
                  KERN_OK);
        CHECK_INT(kern_contacts(w.block, 3, &w.options, out, 8, &work), 4);
    }
}

static void bad_contact_pointers(void)
{
    static world w;
    static kern_contact out[64];
    int index[6], got;
    kern_work work = kern_work_of(NULL, 0, index, 6);
    const kern_options o = kern_defaults();
    stack_of_two(&w, 0.25);
    CHECK_INT(kern_contacts(NULL, 3, &o, out, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, 3, NULL, out, 64, &work),
              KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, 3, &o, NULL, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_contacts(w.block, -1, &o, out, 64, &work), KERN_BAD_COUNT);
    got = kern_contacts(w.block, 3, &o, out, -1, &work);
    CHECK(got == KERN_BAD_COUNT || got == KERN_NO_SPACE);
    CHECK_INT(kern_touch(NULL, 1, &o, out, 64, &work), KERN_BAD_POINTER);
    CHECK_INT(kern_touch(w.block, -1, &o, out, 64, &work), KERN_BAD_COUNT);
    CHECK_INT(kern_touch(w.block, 2147483647, &o, out, 64, &work),
              KERN_BAD_COUNT);
}

static const test bad_tests[] = {
    TEST(bad_structure), TEST(bad_pointers),   TEST(bad_arguments),
    TEST(bad_geometry),  TEST(refused_blocks), TEST(bad_contact_pointers),
};

#endif
