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
#include "../examples/parts/room.h"
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

/* The factor of the live load of a text; below 0 where it is refused, or its
   contacts are not given. */
static double factor_of(const char *text)
{
    struct text_file t;
    kern_real factor = -1;
    if (text_read(&t, text, strlen(text)) == 0 && t.given) {
        kern_work work = room_work(t.blocks, t.contacts);
        kern_task task = kern_task_of(t.block, t.blocks, t.contact, t.contacts,
                                      &work);
        task.s.gravity = t.gravity;
        task.options = t.options;
        if (kern_load_factor_of(&task, 0, t.live, &factor, NULL) < 0)
            factor = -2;
        room_free_work(&work);
    } else
        printf("%s\n", t.message);
    text_free(&t);
    return (double)factor;
}

static void is_close(double got, double want, const char *what)
{
    check(fabs(got - want) <= 1e-6 * fabs(want), what);
    if (!(fabs(got - want) <= 1e-6 * fabs(want)))
        printf("  %.9g, not %.9g\n", got, want);
}

/* A stone 1 wide and 2 tall of the weight 20, pushed at its head: 5 tips it. */
#define STONE                                         \
    "gravity 0 -10\nfixed g -3 -1  3 -1  3 0  -3 0\n" \
    "block a 2  0 0  1 0  1 2  0 2\n"
#define PUSHED STONE "friction 2\nlive a 1 0 0 2\n"

/* Pushes that are there as needed, from any side, and the bond of mortar. */
static void props(void)
{
    is_close(factor_of(PUSHED "prop a -1 0 1 2 3\n"), 8, "prop at the head");
    is_close(factor_of(PUSHED "prop a -5 0 1 1 3\n"), 6.5, "prop at half");
    is_close(factor_of(PUSHED "prop a 0 -1 0 2 4\n"), 7, "prop from above");
    is_close(factor_of(PUSHED "prop a 1 0 0 2 4\n"), 5, "prop from behind");
    is_close(factor_of(PUSHED "prop a -3 -4 0 2 5\n"), 5 + 3 + 2,
             "prop at a slope");
    is_close(factor_of(PUSHED "bond 6\n"), 5 + 6 * .5 / 2, "bond");
    is_close(factor_of(STONE "friction 2\nlive a 0 1 .5 0\nbond 6\n"), 26,
             "bond, lifted");
}

/* A friction of a block, of two, and of their pair. */
static void frictions(void)
{
    is_close(factor_of(STONE "friction .1 a\nlive a 1 0 0 .1\n"), 2, "of a");
    is_close(factor_of(STONE "friction .1 a\nfriction .05 g\n"
                             "live a 1 0 0 .1\n"),
             1, "the least of two");
    is_close(factor_of(STONE "friction .1 a\nfriction .05 g\n"
                             "friction .15 g a\nlive a 1 0 0 .1\n"),
             3, "of the pair");
    is_close(factor_of(STONE "friction .1 a\nfriction 2\n"
                             "contact g a  0 1  0 0  1 0\nlive a 1 0 0 .1\n"),
             2, "of a contact that is given");
    is_close(factor_of(STONE "friction .1 a\nlive a 1 0 0 .1\n"
                             "contact g a  0 1  0 0  1 0  mu .2\n"),
             4, "of a contact with its own");
}

/* The sum of a statement: force and place. */
static void sum_is(const char *text, double fx, double fy, double x, double y,
                   const char *what)
{
    struct text_file t;
    const int bad = text_read(&t, text, strlen(text));
    if (bad)
        printf("%s\n", t.message);
    check(!bad && t.soils == 1, what);
    if (!bad && t.soils == 1) {
        const struct soil_force f = t.soil[0].sum;
        const double off = fabs((double)f.force.x - fx)
                         + fabs((double)f.force.y - fy)
                         + fabs((double)f.at.x - x) + fabs((double)f.at.y - y);
        check(off < 1e-4, what);
        if (!(off < 1e-4))
            printf("  %.6g %.6g at %.6g %.6g\n", (double)f.force.x,
                   (double)f.force.y, (double)f.at.x, (double)f.at.y);
    }
    text_free(&t);
}

/* A stone of the weight 20 whose middle is .2 from the edge of the ground. */
#define LEDGE                                                     \
    "gravity 0 -10\nfixed g -3 -1  1 -1  1 0  -3 0\nbond 1e-12\n" \
    "block a 2  0 0  1.6 0  1.6 1  0 1\n"

/* Rankine's third for phi 30; half a square of water; weight of fill, and of the
   part that is asked for. */
static void soils(void)
{
    sum_is(STONE "earth right 2 .6 30 0\n", -4, 0, 1, 2 / 3., "Rankine");
    sum_is(STONE "earth left 2 .6 30 0\n", 4, 0, 0, 2 / 3., "on the left");
    sum_is(STONE "earth right 1 .6 30 0\n", -1, 0, 1, 1 / 3., "half up");
    sum_is(STONE "earth right 2 .6 30 0 surcharge 3\n", -6, 0, 1, 7 / 9.,
           "surcharge");
    sum_is(STONE "earth right 2 .6 30 0 water 2 .3\n", -2 - 6, 0, 1, 2 / 3.,
           "water to the top");
    sum_is(STONE "earth right 2 .6 30 0 water 1 .3\n", -1 - 2 - .5 - 1.5, 0, 1,
           (1 * (4 / 3.) + 2 * .5 + .5 / 3 + 1.5 / 3) / 5, "water halfway");
    sum_is(STONE "fill 3 .5\n", 0, -5, .5, 2.5, "fill");
    sum_is(STONE "fill 3 .5 from 0.5 to 9\n", 0, -2.5, .75, 2.5,
           "a part of the fill");
    is_close(factor_of(STONE "friction 2\nbond 1e-12\n"
                             "earth left 2 .6 30 0 live\n"),
             20 * .5 / (4 * 2 / 3.), "earth as live load");
    is_close(factor_of(PUSHED "fill 3 .5\nstrength 9\n"), 25 * .5 / 2,
             "fill holds down");
    is_close(factor_of(LEDGE "axle 1.5 1\n"), 8, "an axle");
    is_close(factor_of(LEDGE "axle 1.4 1 .4\n"), 10, "a wide one");
    is_close(factor_of(LEDGE "fill 1.5 1e-12\naxle 1.2 1 .1\n"), 4 / .2,
             "one on fill");
    is_close(factor_of(LEDGE "axle 1.5 1\naxle .5 1\naxle 1.5 1\n"), 8,
             "three axles");
}

/* What is refused, in its line, with what was expected and what was read. */
static void soil_refused(void)
{
    static const struct {
        const char *line, *words;
    } bad[] = {
        {"fill", "fill: a number is expected, but the line ends"},
        {"fill 3 0", "fill: a positive number is expected, read '0'"},
        {"fill 3 2 psi 3", "fill: phi, from or the end of the line is expected"
                           ", read 'psi'"},
        {"fill 3 2 phi .6", "degrees from 5 to 60 is expected, read '.6'"},
        {"fill 3 2 from 1", "fill: to is expected, but the line ends"},
        {"fill 3 2 from 1 to 1", "a number above that behind from is expected"},
        {"fill -1 2", "fill: a top above the upper outline of a free block "},
        {"earth up 3 2 30 0", "earth: left or right, where the earth is, is "
                              "expected, read 'up'"},
        {"earth right 3 2 30 31", "delta, an angle in degrees from 0 to phi is "
                                  "expected, read '31'"},
        {"earth right 3 2 30 0 water 2 2", "the density of water, below that "
                                           "of the earth, is expected"},
        {"earth right 3 2 30 0 x",
         "earth: surcharge, water, live or the end of "
         "the line is expected, read 'x'"},
        {"earth right -2 2 30 0", "earth: no free block is below its top, -2"},
        {"prop a 0 0 1 1 3", "prop: a direction is expected, read 0 0"},
        {"prop g 1 0 1 1 3", "prop: a block that is not fixed is expected"},
        {"prop a 1 0 1 1 0", "prop: a positive number is expected, read '0'"},
        {"axle 9 1", "axle: no free block is below one"},
        {"axle 0 -1", "axle: a positive number is expected, read '-1'"},
        {"bond x", "bond: a positive number is expected, read 'x'"},
        {"strength -1", "strength: a positive number is expected, read '-1'"},
        {"friction .1 b", "friction: the name of a block above is expected, "
                          "read 'b'"},
        {"friction .1 a b", "the name of a block above is expected, read 'b'"},
        {"friction .1 a g x", "the end of the line is expected, read 'x'"}};
    char text[400];
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        snprintf(text, sizeof text, STONE "%s\n# the end\n", bad[i].line);
        refused(text, strlen(text), 4, bad[i].words);
    }
    snprintf(text, sizeof text, STONE "fill 3 1\ngravity 1 -9\n");
    refused(text, strlen(text), 4,
            "fill: gravity straight down is expected, read 1 -9");
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
    props();
    frictions();
    soils();
    soil_refused();
    refused(late_density, sizeof late_density - 1, 2, "a block after it");
    if (sizeof(kern_real) == sizeof(double)) /* in float it is 0 */
        refused(short_normal, sizeof short_normal - 1, 3, "no normal");
    check(text_load(&t, "/dev/zero") == -1 && strstr(t.message, "NUL"),
          "a file without end");
    text_free(&t);
    printf("%d failed\n", failed);
    return failed > 0;
}
