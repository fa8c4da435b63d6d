/* cc -O2 -ffp-contract=off -o text_test tests/text_test.c -lm && ./text_test

   What examples/parts/text.h reads where the locale is not "C", and what it says of
   files that are none. The locale here writes a comma, or two bytes, in place
   of the point: strtod() and localeconv() are replaced. */

#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static char point[3] = ",";

/* strtod() of the locale: stops at a point. */
static double local_strtod(const char *word, char **end)
{
    char copy[512];
    const char *comma = strstr(word, point);
    size_t n = comma ? (size_t)(comma - word) : strcspn(word, ".");
    memcpy(copy, word, n);
    copy[n] = '\0';
    if (comma)
        snprintf(copy + n, sizeof copy - n, ".%s", comma + strlen(point));
    if (end)
        *end = NULL;
    return strtod(copy, NULL);
}

static struct lconv *local_conventions(void)
{
    static struct lconv conventions;
    conventions.decimal_point = point;
    return &conventions;
}

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#include "../kern.h"

#define strtod local_strtod
#define localeconv local_conventions
#include "../examples/parts/text.h"
#undef strtod

static int failed;

static void check(int good, const char *what)
{
    if (!good)
        printf("FAILED: %s\n", what);
    failed += !good;
}

static void numbers(void)
{
    static const struct {
        const char *word;
        double value;
    } good[] = {
        {"0.5", 0.5},
        {"-.25e3", -250},
        {"1.", 1},
        {"+12", 12},
        {"3e2", 300},
        {"0.12345678901234567890123456789012345678901234567890123456789012345"
         "6789012345678901234567890",
         0.12345678901234568}};
    static const char *const bad[] = {"0,5", ".",     "1.5x",  "1e400", "",
                                      "inf", "0x1p3", "1.2.3", "e5"};
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        kern_real got = -1;
        check(text_number(good[i].word, &got)
                  && fabs((double)got - good[i].value)
                         <= 4 * (double)KERN_EPS * fabs(good[i].value),
              good[i].word);
    }
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        kern_real got;
        check(!text_number(bad[i], &got), bad[i]);
    }
}

/* Whether this text is refused in a line, with these words. */
static void refused(const char *text, size_t length, int line,
                    const char *words)
{
    struct text_file t;
    check(text_read(&t, text, length) == -1 && t.line == line
              && strstr(t.message, words),
          words);
    text_free(&t);
}

/* Of statements that hold for the whole file the last one does, wherever it
   stands; a tolerance without an angle has the default one. */
static void last_wins(void)
{
    static const char text[] =
        "friction 0.5\ngravity 1 -2\nepsilon 0.3\ntolerance 0.01 0.1\n"
        "block a *  0 0  1 0  1 1  0 1\n"
        "friction 0.25\ngravity 0 -8\nepsilon 0.5\ntolerance 0.125\n";
    struct text_file t;
    check(text_read(&t, text, sizeof text - 1) == 0
              && t.options.mu == (kern_real)0.25
              && t.options.gap == (kern_real)0.125
              && t.options.epsilon == (kern_real)0.5
              && t.options.angle == kern_defaults().angle && t.gravity.x == 0
              && t.gravity.y == -8,
          "the last one wins");
    text_free(&t);
}

/* A gap wider than a block is refused in its line, but not of given contacts. */
static void wide_gap(void)
{
    static const char text[] =
        "tolerance 0.9\nfixed g  -1 -1  1 -1  1 0  -1 0\n"
        "block a *  0 0  1 0  1 1  0 1\n"
        "tolerance 1.1\n# the end\ncontact g a  0 1  0 0  1 0\n";
    struct text_file t;
    refused(text, strlen(text) - strlen("contact g a  0 1  0 0  1 0\n"), 4,
            "tolerance: a gap up to the mean size of the blocks, 1, is "
            "expected, read 1.1");
    check(text_read(&t, text, sizeof text - 1) == 0, "contacts are given");
    text_free(&t);
}

/* A file without blocks says so; where a name is missing the message shows what
   was taken for one. */
static void no_block_no_name(void)
{
    static const char empty[] = "\n# nothing\n";
    static const char no_name[] = "block * 0 0  1 0  1 1  0 1\n";
    static const char no_name_fixed[] = "fixed -1 -1  1 -1  1 0  -1 0\n";
    static const char comma[] = "\nblock a *  0,0  1,0  1,1\n";
    static const char end[] = "fixed\n";
    refused("", 0, 1, "there is no block in the file ('block NAME MASS X1");
    refused(empty, sizeof empty - 1, 2, "there is no block in the file");
    refused(no_name, sizeof no_name - 1, 1, "block '*': a mass (a positive");
    refused(no_name_fixed, sizeof no_name_fixed - 1, 1,
            "fixed '-1': the number of coordinates is odd, vertex 4 has");
    refused(comma, sizeof comma - 1, 2,
            "block 'a': a number is expected, read '0,0'");
    refused(end, sizeof end - 1, 1, "fixed: a name is expected, but the line");
}

/* The error of places and the unit of lengths are read, and refused where they
   are none. */
static void measured_units(void)
{
    static const char text[] =
        "measured 0.25 0.125\nunits m\nfixed g  -1 -1  1 -1  1 0  -1 0\n"
        "block a *  0 0  1 0  1 1  0 1\nmeasured 0.5\n";
    static const char zero[] = "measured 0\n", none[] = "units\n";
    static const char wide[] = "measured 1 0.5\n";
    struct text_file t;
    check(text_read(&t, text, sizeof text - 1) == 0 && t.error == (kern_real)0.5
              && t.turn == 0 && t.units && strcmp(t.units, "m") == 0,
          "measured and units");
    text_free(&t);
    refused(zero, sizeof zero - 1, 1, "measured: a positive number");
    refused(wide, sizeof wide - 1, 1, "measured: an angle below 0.5");
    refused(none, sizeof none - 1, 1, "units: a unit of length is expected");
}

int main(void)
{
    static const char short_normal[] =
        "fixed g -1 -1  1 -1  1 0  -1 0\nblock a 1  0 0  1 0  1 1  0 1\n"
        "contact g a 1e-310 1e-310  0 0  1 0\n";
    static const char late_density[] =
        "block a *  0 0  1 0  1 1  0 1\ndensity 2\nfriction 0.4\n";
    struct text_file t;
    numbers();
    strcpy(point, "\xd9\xab"); /* as Pashto has it */
    numbers();
    strcpy(point, ".");
    refused("friction 0.5\n\0\0", 15, 2, "NUL");
    last_wins();
    wide_gap();
    no_block_no_name();
    measured_units();
    refused(late_density, sizeof late_density - 1, 2, "a block after it");
    if (sizeof(kern_real) == sizeof(double)) /* in float it is 0 */
        refused(short_normal, sizeof short_normal - 1, 3, "no normal");
    check(text_load(&t, "/dev/zero") == -1 && strstr(t.message, "NUL"),
          "a file without end");
    text_free(&t);
    printf("%d failed\n", failed);
    return failed > 0;
}
