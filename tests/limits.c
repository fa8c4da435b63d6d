/* cc -O2 -ffp-contract=off -o limits tests/limits.c -lm
   bash tests/work.sh limits [FILE...]

   What a unit of work costs: each question to each structure, and the last with
   what a measure left known, with limits of 1 to 30000 units, run under
   callgrind, which counts instructions. Prints a line for each call: its name,
   limit, units, and whether it was answered whole or the limit ended it. work.sh
   makes a table of it.
   SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"
#include "../examples/parts/room.h"
#include "../examples/parts/text.h"

#include <stdio.h>
#include <string.h>
#include <valgrind/callgrind.h>

enum { QUESTIONS = 15, LIMITS = 6, POINTS = 20000, STONES = 1000 };

static const char *const question[QUESTIONS] = {
    "verdict", "measure",     "load",     "tilt",    "raised",
    "reserve", "bearing",     "deficit",  "profile", "profile_load",
    "forces",  "raised_load", "contacts", "stays",   "stays_known"};

static kern_contact contact[POINTS];
static kern_force force[POINTS];
static kern_motion motion[STONES];
static kern_real value[STONES];

static int ask(int i, kern_task *task)
{
    kern_margin m;
    kern_real x;
    kern_collapse c;
    kern_raising raising;
    switch (i) {
    case 0: return kern_verdict(task, 0, NULL);
    case 1: return kern_measure(task, &m, NULL);
    case 2: return kern_load_factor(task, 0, KERN_RIGHT, &x, NULL);
    case 3: return kern_tilt(task, 0, KERN_LEFT, &x, NULL);
    case 4: return kern_raised(task, 0, &raising, NULL, NULL);
    case 5: return kern_raised(task, 0, &raising, &x, NULL);
    case 6: return kern_bearing(task, &x, NULL);
    case 7: return kern_deficit(task, &x);
    case 8: return kern_profile(task, KERN_SHRINK, value, &c);
    case 9: return kern_profile(task, KERN_RIGHT, value, &c);
    case 10: return kern_forces(task, 0, force);
    case 11: return kern_raised_load(task, 0, KERN_RIGHT, NULL, &x, NULL);
    case 12:
        return kern_contacts(task->s.block, task->s.blocks, &task->options,
                             contact, POINTS, task->work);
    default: return kern_stays(task, task->s.blocks - 1, &x);
    }
}

static void ask_limited(const char *file, int i, kern_task *task)
{
    static const int limits[LIMITS] = {1, 50, 100, 1000, 10000, 30000};
    const char *name = strrchr(file, '/');
    char tag[400];
    int k, status;
    for (k = 0; k < LIMITS; k++) {
        snprintf(tag, sizeof tag, "%.200s/%s/%d", name ? name + 1 : file,
                 question[i], limits[k]);
        task->options.limit = limits[k];
        CALLGRIND_ZERO_STATS;
        CALLGRIND_TOGGLE_COLLECT;
        status = ask(i, task);
        CALLGRIND_TOGGLE_COLLECT;
        CALLGRIND_DUMP_STATS_AT(tag);
        printf("%s %d %d %s\n", tag, limits[k], task->work->units,
               status == KERN_LIMIT ? "ended" : "whole");
        if (status != KERN_LIMIT)
            break;
    }
}

int main(int argc, char **argv)
{
    int file, i;
    for (file = 1; file < argc; file++) {
        struct text_file t;
        kern_work work = kern_work_of(NULL, 0, NULL, 0);
        kern_task task;
        int n;
        if (text_load(&t, argv[file]) || t.blocks > STONES) {
            fprintf(stderr, "%s: %s\n", argv[file], t.message);
            return 2;
        }
        n = t.given ? t.contacts
                    : kern_contacts(t.block, t.blocks, &t.options, contact,
                                    POINTS, &work);
        if (n < 0 || n > POINTS) {
            fprintf(stderr, "%s: no contacts\n", argv[file]);
            return 2;
        }
        for (i = 0; t.given && i < n; i++)
            contact[i] = t.contact[i];
        work = room_work(t.blocks, n);
        task = kern_task_of(t.block, t.blocks, contact, n, &work);
        task.s.gravity = t.gravity;
        task.options = t.options;
        for (i = 0; i < QUESTIONS; i++) {
            kern_margin m;
            if (i == QUESTIONS - 1) {
                task.options.limit = 0;
                task.known = kern_known_of(motion, force);
                kern_measure(&task, &m, NULL);
            }
            ask_limited(argv[file], i, &task);
        }
        room_free_work(&work);
        text_free(&t);
    }
    return 0;
}
