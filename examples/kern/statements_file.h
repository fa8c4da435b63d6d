/* statements_file.h - --kern: a drawing or a photograph in the format of text.h,
   where loads, weights and friction can be added.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_STATEMENTS_FILE_H
#define PROGRAM_STATEMENTS_FILE_H

#include "picture.h"
#include "state.h"

#include <stdio.h>
#include <string.h>

/* Writes a sentence as a comment. */
static inline void write_comment(FILE *out, const char *text, int n)
{
    fprintf(out, "# %.*s\n", n, text);
}

static inline void write_statements(FILE *out, const struct analysis *a)
{
    const struct shapes *s = &a->drawing.s;
    fprintf(out, "# made by kern --kern of %.*s\n",
            (int)strcspn(a->file, "\r\n"), a->file);
    for (const char *n = s->notes.at; *n; n = strchr(n, '\n') + 1)
        write_comment(out, n, (int)strcspn(n, "\n"));
    for (int i = 0; i < s->skips; i++)
        fprintf(out, "# skipped: %d %s on '%s', line %d\n", s->skip[i].count,
                shapes_at(s, s->skip[i].kind), shapes_at(s, s->skip[i].label),
                s->skip[i].line);
    fputs(s->text.at, out);
}

static inline int write_kern(const struct analysis *a)
{
    FILE *out;
    char *path;
    if (!a->drawing.made) {
        fprintf(stderr,
                "%s: --kern takes a drawing or a photograph, and this "
                "is in that format already\n",
                a->file);
        return 1;
    }
    path = open_output(a, a->set->kern_file, &out);
    if (out)
        write_statements(out, a);
    return close_output(path, out, !out);
}

#endif /* PROGRAM_STATEMENTS_FILE_H */
