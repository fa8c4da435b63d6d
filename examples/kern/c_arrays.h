/* c_arrays.h - a structure as a C header: constant arrays that lie in flash, and
   a function that makes the task of them. The program that includes it brings
   work memory alone, and has the margin that kern prints.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_C_ARRAYS_H
#define PROGRAM_C_ARRAYS_H

#include "../../kern.h"

#include "../parts/json.h"
#include "picture.h"
#include "state.h"

#include <ctype.h>
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { C_NAME_ROOM = 64 };

/* The name of a file as a C name, in small letters or capitals. */
static inline void c_name(const struct analysis *a, int capitals,
                          char out[C_NAME_ROOM])
{
    int length, n = 0;
    const char *stem = stem_of(a->file, &length);
    if (!isalpha((unsigned char)stem[0]) || strncmp(stem, "kern", 4) == 0)
        out[n++] = capitals ? 'S' : 's'; /* no name of kern.h, nor a digit */
    for (int i = 0; i < length && n < C_NAME_ROOM - 1; i++) {
        const unsigned char c = (unsigned char)stem[i];
        out[n++] = (char)(c >= 0x80 || !isalnum(c) ? '_'
                          : capitals               ? toupper(c)
                                                   : tolower(c));
    }
    out[n] = '\0';
}

/* Numbers with a word before, between and behind them. */
static inline void c_numbers(FILE *out, const char *before, int count,
                             const kern_real *value, const char *behind)
{
    char digits[JSON_DIGITS];
    fputs(before, out);
    for (int i = 0; i < count; i++) {
        json_digits((double)value[i], digits);
        fprintf(out, "%s%s", i > 0 ? ", " : "", digits);
    }
    fputs(behind, out);
}

static inline void c_vertices(FILE *out, const kern_structure *s)
{
    for (int i = 0; i < s->blocks; i++)
        for (int k = 0; k < s->block[i].vertices; k++) {
            const kern_vec p = s->block[i].vertex[k];
            const kern_real value[] = {p.x, p.y};
            c_numbers(out, "    { ", 2, value, " },\n");
        }
}

static inline void c_blocks(FILE *out, const kern_structure *s,
                            const char *name)
{
    for (int i = 0, first = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        const kern_real box[] = {b->box.low.x, b->box.low.y, b->box.high.x,
                                 b->box.high.y};
        const kern_real load[] = {b->load.fx, b->load.fy, b->load.torque};
        const kern_real centre[] = {b->centre.x, b->centre.y};
        if (b->vertices > 0)
            fprintf(out, "    { %s_vertex + %d", name, first);
        else
            fprintf(out, "    { 0");
        fprintf(out, ", %d, %d", b->vertices, b->fixed);
        c_numbers(out, ", ", 1, &b->area, ",\n      { { ");
        c_numbers(out, "", 2, box, " }, { ");
        c_numbers(out, "", 2, box + 2, " } },\n      ");
        c_numbers(out, "", 1, &b->mass, ", { ");
        c_numbers(out, "", 2, centre, " }, { ");
        c_numbers(out, "", 3, load, " } },\n");
        first += b->vertices;
    }
}

static inline void c_contacts(FILE *out, const kern_structure *s)
{
    for (int k = 0; k < s->contacts; k++) {
        const kern_contact *c = &s->contact[k];
        const kern_real place[] = {c->p.x, c->p.y}, normal[] = {c->n.x, c->n.y};
        const kern_real rest[] = {c->mu, c->travel};
        fprintf(out, "    { %d, %d, %d", c->a, c->b, c->line);
        c_numbers(out, ", { ", 2, place, " }, { ");
        c_numbers(out, "", 2, normal, " },\n      ");
        c_numbers(out, "", 2, rest, " },\n");
    }
}

static inline void c_lives(FILE *out, const struct analysis *a)
{
    for (int i = 0; i < a->task.s.blocks; i++) {
        const kern_wrench *w = &a->text.live[i];
        const kern_real value[] = {w->fx, w->fy, w->torque};
        c_numbers(out, "    { ", 3, value, " },\n");
    }
}

/* The function that makes the task. */
static inline void c_task(FILE *out, const struct analysis *a, const char *name,
                          const char *capitals)
{
    const kern_options *o = &a->task.options;
    const struct {
        const char *field;
        const kern_real *value;
    } set[] = {{"s.gravity.x", &a->task.s.gravity.x},
               {"s.gravity.y", &a->task.s.gravity.y},
               {"options.mu", &o->mu},
               {"options.gap", &o->gap},
               {"options.angle", &o->angle},
               {"options.epsilon", &o->epsilon}};
    fprintf(out,
            "static inline kern_task %s_task(kern_work *work)\n{\n"
            "    kern_task task = kern_task_of(%s_block, %s_BLOCKS,\n"
            "        %s_contact, %s_CONTACTS, work);\n",
            name, name, capitals, name, capitals);
    for (size_t k = 0; k < sizeof set / sizeof *set; k++) {
        fprintf(out, "    task.%s", set[k].field);
        c_numbers(out, " = (kern_real)", 1, set[k].value, ";\n");
    }
    fprintf(out, "    task.options.relative = %d;\n", o->relative);
    fprintf(out, "    return task;\n}\n");
}

/* Numbers are written in double; in float they are rounded. */
static const char c_quiet[] =
    "\n#ifdef __GNUC__\n#pragma GCC diagnostic push\n"
    "#pragma GCC diagnostic ignored \"-Wfloat-conversion\"\n#endif\n";

static const char c_loud[] =
    "\n#ifdef __GNUC__\n#pragma GCC diagnostic pop\n#endif\n\n";

/* Opens an array of a type. */
static inline void c_open(FILE *out, const char *type, const char *name,
                          const char *what, int count)
{
    fprintf(out, "\nstatic const %s %s_%s[%d] = {\n", type, name, what, count);
}

static inline void c_write(FILE *out, const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    char name[C_NAME_ROOM], capitals[C_NAME_ROOM];
    int vertices = 0;
    for (int i = 0; i < s->blocks; i++)
        vertices += s->block[i].vertices;
    c_name(a, 0, name);
    c_name(a, 1, capitals);
    fprintf(out,
            "/* Made by kern --c, for kern.h " KERN_VERSION ". */\n\n"
            "#ifndef %s_H\n#define %s_H\n\n#include \"kern.h\"\n\n"
            "#define %s_BLOCKS %d\n#define %s_CONTACTS %d\n",
            capitals, capitals, capitals, s->blocks, capitals, s->contacts);
    fputs(c_quiet, out);
    if (vertices > 0) {
        c_open(out, "kern_vec", name, "vertex", vertices);
        c_vertices(out, s);
        fprintf(out, "};\n");
    }
    c_open(out, "kern_block", name, "block", s->blocks);
    c_blocks(out, s, name);
    fprintf(out, "};\n");
    c_open(out, "kern_contact", name, "contact",
           s->contacts > 0 ? s->contacts : 1);
    if (s->contacts > 0)
        c_contacts(out, s);
    else
        fprintf(out, "    { 0 }\n");
    fprintf(out, "};\n");
    if (a->text.lives > 0) {
        c_open(out, "kern_wrench", name, "live", s->blocks);
        c_lives(out, a);
        fprintf(out, "};\n");
    }
    fputs(c_loud, out);
    c_task(out, a, name, capitals);
    fprintf(out, "\n#endif\n");
}

static inline int write_c(const struct analysis *a)
{
    FILE *out;
    char *path = open_output(a, a->set->c_file, &out);
    if (out)
        c_write(out, a);
    return close_output(path, out, !out);
}

#endif /* PROGRAM_C_ARRAYS_H */
