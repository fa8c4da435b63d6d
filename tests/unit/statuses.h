/* statuses.h - a call for every status. */

#ifndef UNIT_STATUSES_H
#define UNIT_STATUSES_H

#include "harness.h"
#include "worlds.h"
#include "verdict.h"
#include "polygon.h"
#include "lp.h"
#include "known.h"
#include "bad.h"

static const struct {
    int value;
    const char *name;
} statuses[] = {
#define STATUS_ROW(name, value, text) {value, #name},
    KERN_STATUS_LIST(STATUS_ROW)
#undef STATUS_ROW
};

/* The statuses that calls of the tests below returned. */
static int had[64], had_count;

static int have(int status)
{
    had[had_count++] = status;
    return status;
}

/* A limit of work, and friction of which no number is left in the proofs. */
static void statuses_without_verdict(void)
{
    static world w;
    kern_work work;
    brick_wall(&w, wall4, 0.4, 1);
    work = work_of(&w);
    w.options.limit = 1;
    have(kern_verdict(world_task(&w, &work), 0, NULL));
    w.options.limit = 0;
    world_friction(&w, 1e9);
    have(kern_verdict(world_task(&w, &work), R(0.12), NULL));
}

static void statuses_of_measures(void)
{
    static const double ray[] = {1, -1, 1}, down[] = {-1, -1},
                        minus[] = {-1, 1};
    static world w;
    kern_margin m;
    kern_structure s;
    kern_work work;
    program p;
    stack_of_two(&w, 0.25);
    have(verdict(&w, 0));
    w.gravity = vec(9, 0);
    have(verdict(&w, 0));
    program_set(&p, 1, 2, ray, down);
    have(program_solve(&p));
    program_set(&p, 1, 2, ray, NULL);
    have(program_solve(&p));
    program_set(&p, 1, 1, minus, NULL);
    have(program_solve(&p));
    work = work_of(&w);
    s = structure_of(&w);
    work.reals = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    have(kern_verdict(task_of(NULL, &w.options, &work), 0, NULL));
    work = work_of(&w);
    have(kern_verdict(task_of(&s, &w.options, &work), R(not_a_number()), NULL));
    s.gravity = vec(0, 0);
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.contacts = KERN_STALE;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.blocks = -1;
    s.contacts = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s.blocks = 1;
    s.contacts = 0;
    have(kern_verdict(task_of(&s, &w.options, &work), 0, NULL));
    s = structure_of(&w);
    w.options.epsilon = R(1e-12);
    w.gravity = vec(0, -9.81);
    s = structure_of(&w);
    have(kern_measure(task_of(&s, &w.options, &work), &m, NULL));
    w.options.epsilon = R(-1);
    have(kern_measure(task_of(&s, &w.options, &work), &m, NULL));
    w.options = kern_defaults();
    w.options.relative = 1;
    have(kern_verdict(task_of(&s, &w.options, &work), R(1.5), NULL));
}

static void statuses_of_geometry(void)
{
    static const double square[] = {0, 0, 1, 0, 1, 1, 0, 1};
    static const double bow[] = {0, 0, 1, 1, 1, 0, 0, 1};
    static const double flat[] = {0, 0, 1, 0, 2, 0, 1, 0};
    static const struct {
        int a, ny, py; /* block a and block 1, normal and second point */
        double mu;
    } given_contact[] = {
        {0, 1, 0, -1}, {1, 1, 0, 1}, {-1, 1, 0, 1}, {0, 0, 0, 1}, {0, 1, 1, 1}};
    static world w;
    const kern_options o = kern_defaults();
    kern_block b;
    kern_fault fault;
    kern_contact c[2];
    int i;
    have(polygon(&b, &fault, 1, square, 4));
    have(polygon(&b, &fault, 1, square, 2));
    have(polygon(&b, &fault, 1, bow, 4));
    have(polygon(&b, &fault, 1, flat, 3));
    have(polygon(&b, &fault, -1, square, 4));
    for (i = 0; i < 5; i++)
        have(contact_make(given_contact[i].a, 1, vec(0, given_contact[i].ny),
                          vec(0, 0), vec(0, given_contact[i].py),
                          R(given_contact[i].mu), &o, c));
    world_reset(&w);
    world_box(&w, 1, 0, 0, 1, 1);
    world_box(&w, 1, 0.5, 0.5, 2, 2);
    have(world_touch(&w));
    refused(&w.block[0], 0);
    have(world_touch(&w));
}

/* A wheel of 40 corners beside a long slope, and on it. */
static void statuses_of_rest(void)
{
    enum { CORNERS = 40 };
    const kern_vec slope[3] = {vec(0, 0), vec(90, 0), vec(90, 30)};
    kern_vec wheel[CORNERS], out[CORNERS];
    kern_block stone, ground;
    kern_pose pose;
    kern_work work = work_for(1, 4);
    kern_task task = kern_task_of(&ground, 1, NULL, 0, &work);
    int i;
    for (i = 0; i < CORNERS; i++)
        wheel[i] = vec(cos(2 * pi * i / CORNERS), sin(2 * pi * i / CORNERS));
    kern_block_init(&stone, wheel, CORNERS, 1, NULL);
    kern_ground_init(&ground, slope, 3, NULL);
    have(kern_rest(&task, &stone, -9, vec(1, 0), out, &pose));
    have(kern_rest(&task, &stone, 80, vec(1, 0), out, &pose));
}

/* Every status has a text of its own and can be had. */
static void status_of_every_kind(void)
{
    enum { ROWS = COUNT_OF(statuses) };
    int i, j;
    had_count = 0;
    statuses_of_measures();
    statuses_without_verdict();
    statuses_of_geometry();
    statuses_of_rest();
    for (i = 0; i < ROWS; i++) {
        const char *text = kern_status_text((kern_status)statuses[i].value);
        int count = 0;
        CHECK(text && text[0]);
        for (j = 0; j < i; j++)
            CHECK(strcmp(text, kern_status_text((kern_status)statuses[j].value))
                  != 0);
        for (j = 0; j < had_count; j++)
            count += had[j] == statuses[i].value;
        if (!count)
            printf("no test gives %s\n", statuses[i].name);
        CHECK(count > 0);
        CHECK(statuses[i].value >= KERN_STATUS_LEAST);
    }
    CHECK(kern_status_text((kern_status)-99) != NULL);
    CHECK(kern_status_text((kern_status)99) != NULL);
}

static const test statuses_tests[] = {
    TEST(status_of_every_kind),
};

#endif
