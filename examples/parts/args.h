/* args.h - what the example programs read on the command line.

   SPDX-License-Identifier: MIT */

#ifndef ARGS_H
#define ARGS_H

#include <errno.h>
#include <stdlib.h>
#include <string.h>

/* Is stream 1 (stdout) or 2 (stderr) a terminal? The C library cannot tell. */
#if defined(_WIN32)
#include <io.h>
#define ARGS_TERMINAL(stream) (_isatty(stream) != 0)
#elif defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#define ARGS_TERMINAL(stream) (isatty(stream) != 0)
#else
#define ARGS_TERMINAL(stream) 0
#endif

/* The value of option `name` at argv[*i]: after "=", or the next argument, to
   which it moves *i; NULL where there is none. Returns 0 where the argument is
   another one. */
static inline int args_value(char **argv, int *i, const char *name,
                             const char **value)
{
    const size_t n = strlen(name);
    if (strncmp(argv[*i], name, n) != 0)
        return 0;
    *value = NULL;
    if (argv[*i][n] == '=' && name[1] == '-')
        *value = argv[*i] + n + 1;
    else if (argv[*i][n] != '\0')
        return 0;
    else if (argv[*i + 1])
        *value = argv[++*i];
    return 1;
}

/* Reads an integer at *s within a range and moves *s behind it. Returns 0, or
   -1. */
static inline int args_integer(const char **s, long least, long most, int *out)
{
    char *end;
    long value;
    if (!*s || **s < '0' || **s > '9')
        return -1;
    errno = 0;
    value = strtol(*s, &end, 10);
    if (errno || value < least || value > most)
        return -1;
    *out = (int)value;
    *s = end;
    return 0;
}

/* A, or A-B with A <= B. Returns 0, or -1. */
static inline int args_range(const char *s, long least, long most, int *first,
                             int *last)
{
    if (args_integer(&s, least, most, first))
        return -1;
    *last = *first;
    if (*s == '-') {
        s++;
        if (args_integer(&s, *first, most, last))
            return -1;
    }
    return *s ? -1 : 0;
}

/* Does a name, longer than its end, end so? */
static inline int args_ends(const char *name, const char *end)
{
    const size_t n = name ? strlen(name) : 0, m = strlen(end);
    return n > m && strcmp(name + n - m, end) == 0;
}

/* A picture's name ends in .svg, so that no structure is written over. */
static inline int args_is_svg(const char *name)
{
    return args_ends(name, ".svg");
}

enum { ARGS_HELP = -1, ARGS_VERSION = -2, ARGS_BAD = -3 };

/* Reads the options: option() takes the one at argv[*i] with what belongs to it,
   and returns 0 where it is fine. What is no option, and all behind --, moves to
   the front of argv. Returns how many these are, or one of the above; with
   ARGS_HELP argv[0] is the word that asks for help, argv[1] what follows it, or
   NULL. */
static inline int args_read(int argc, char **argv,
                            int (*option)(void *set, char **argv, int *i),
                            void *set)
{
    int files = 0, options = 1;
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        if (!options || word[0] != '-' || word[1] == '\0')
            argv[files++] = argv[i]; /* over arguments read already */
        else if (strcmp(word, "--") == 0)
            options = 0;
        else if (strcmp(word, "--help") == 0 || strcmp(word, "-h") == 0) {
            argv[0] = argv[i];
            argv[1] = argv[i + 1];
            return ARGS_HELP;
        } else if (strcmp(word, "--version") == 0 || strcmp(word, "-V") == 0)
            return ARGS_VERSION;
        else if (option(set, argv, &i))
            return ARGS_BAD;
    }
    return files;
}

#endif /* ARGS_H */
