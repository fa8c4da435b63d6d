/* usage.h - which part of help.h is printed, and the option that a mistyped word
   may have meant.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_USAGE_H
#define PROGRAM_USAGE_H

#include "../../kern.h"

#include "help.h"

#include <stdio.h>
#include <string.h>

/* What kern -h prints. */
/* clang-format off */
static const char usage_brief[] =
"usage: kern [options] FILE...\n"
"Does a structure of dry stones stand, does it stay, and with what margin? FILE is\n"
"text (.kern), a drawing (.dxf, .svg) or a photograph (.json); -: stdin.\n"
"\n"
"  --svg OUT.svg      draw it                  --json       one object a line\n"
"  --verdict          the verdict alone        --limit N    most work of a query\n"
"  --raised           loads of friction, and the reserve\n"
"  --stays NAME|all   the chance that a stone stays where it is let go\n"
"  --place STONE      where one more stone lies best; --turns N, --most N\n"
"  --sequence         the margin after each stone that is laid\n"
"  --profile          the margin of each stone; --near: which wall outlasts shaking\n"
"  --sweep N          a live load that drives over it\n"
"  --error E          how many times a placing error it bears; least friction\n"
"  --measured E       poses were measured with this standard error\n"
"  --mu MU  --gap G  --overlap D  --epsilon E  --relative  --at D\n"
"  --layer NAME=ROLE  --ground Y  --density D  --pixel L   how a drawing is taken\n"
"  --mu LAYER=MU      friction of a layer      --phi PHI    fill that pushes back\n"
"  --kern OUT.kern    a drawing as text        --c OUT.h    C arrays for firmware\n"
"  --report OUT.html  one page to hand in      --title TEXT  its title\n"
"  --forces, --mechanism   contacts, moves     --thrust NAME   of a support\n"
"\n"
"  --help             all of these             --help TOPIC asks, drawing, taken,\n"
"  -V                 the version                           written, format, json\n"
"\n"
"Exit status: 0 all stand, 1 one falls, 2 an error, 3 one is undecided.\n";
/* clang-format on */

/* A topic of --help: the text from `head` on, up to an empty line; the whole
   text where head is NULL. */
struct usage_topic {
    const char *name, *text, *head;
};

static const struct usage_topic usage_topics[] = {
    {"asks", help, "What is asked for"},
    {"drawing", help, "How a drawing"},
    {"taken", help, "How the file is taken"},
    {"written", help, "What is written"},
    {"format", help_format, NULL},
    {"json", help_json, NULL}};

/* Prints one topic. Returns -1 where there is none of that name, or where it
   cannot be written. */
static inline int usage_topic(const char *name)
{
    for (size_t k = 0; k < sizeof usage_topics / sizeof *usage_topics; k++) {
        const struct usage_topic *t = &usage_topics[k];
        if (strcmp(name, t->name) != 0)
            continue;
        const char *from = t->head ? strstr(t->text, t->head) : t->text + 1;
        const char *end = t->head ? strstr(from, "\n\n") : NULL;
        const int n = (int)(end ? (size_t)(end - from) + 1 : strlen(from));
        return printf("%.*s", n, from) < 0 ? -1 : 0;
    }
    fprintf(stderr,
            "kern: --help takes asks, drawing, taken, written, format or json, "
            "read '%s'\n",
            name);
    return -1;
}

/* Prints what is asked for: "-h", or "--help" with a topic or NULL. */
static inline int usage_print(const char *word, const char *topic)
{
    if (strcmp(word, "-h") == 0)
        return fputs(usage_brief, stdout) < 0 ? -1 : 0;
    if (topic)
        return usage_topic(topic);
    return fputs(help, stdout) < 0 || fputs(help_format, stdout) < 0
                || fputs(help_json, stdout) < 0
             ? -1
             : 0;
}

/* Returns how many letters are to be put in, left out, changed or exchanged with
   their neighbour to make a of b, words of at most USAGE_WORD letters. */
enum { USAGE_WORD = 24 };
static inline int usage_distance(const char *a, int m, const char *b, int n)
{
    int row[3][USAGE_WORD + 1];
    for (int i = 0; i <= m; i++) {
        int *now = row[i % 3];
        const int *above = row[(i + 2) % 3], *higher = row[(i + 1) % 3];
        for (int j = 0; j <= n; j++) {
            int least = i + j;
            if (i > 0 && j > 0) {
                least = above[j - 1] + (a[i - 1] != b[j - 1]);
                if (above[j] + 1 < least)
                    least = above[j] + 1;
                if (now[j - 1] + 1 < least)
                    least = now[j - 1] + 1;
            }
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]
                && higher[j - 2] + 1 < least)
                least = higher[j - 2] + 1;
            now[j] = least;
        }
    }
    return row[m % 3][n];
}

/* Writes the option of the help that is least far from a word, up to what comes
   before "=", into `best`; "" where none is within a third of its letters. */
static inline void usage_nearest(const char *word, char best[USAGE_WORD + 1])
{
    const int n = (int)strcspn(word, "=");
    int least = n / 3 + 1;
    best[0] = '\0';
    if (n > USAGE_WORD)
        return;
    for (const char *at = strstr(help, "--"); at; at = strstr(at + 2, "--")) {
        const int m = (int)strspn(at, "-abcdefghijklmnopqrstuvwxyz");
        const int far_off = m > USAGE_WORD ? least
                                           : usage_distance(at, m, word, n);
        if (m > 3 && far_off < least) {
            least = far_off;
            memcpy(best, at, (size_t)m);
            best[m] = '\0';
        }
    }
}

#endif /* PROGRAM_USAGE_H */
