/* shake - at which strength of shaking does a dry-stacked structure collapse?

   Puts structures, in the text format of text.h, on a table that moves along
   a figure of eight, harder from level to level, and says how far the stones
   are displaced after each, and at which level the structure collapses.

       cc -O2 -ffp-contract=off -o shake examples/shake.c -lm
       ./shake --film wall.svg examples/structures/wall-60.kern
       ./shake --help

   SPDX-License-Identifier: MIT */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "draw.h"
#include "rigid.h"
#include "text.h"

#include <stdint.h>
#include <time.h>

/* Is stream 2 (stderr) a terminal? The C library cannot tell. */
#if defined(_WIN32)
#include <io.h>
#define IS_TERMINAL(stream) (_isatty(stream) != 0)
#elif defined(__unix__) || defined(__APPLE__)
#include <unistd.h>
#define IS_TERMINAL(stream) (isatty(stream) != 0)
#else
#define IS_TERMINAL(stream) 0
#endif

static const char help[] =
"usage: shake [options] FILE...\n"
"Shakes structures, each time as they were built and harder from level to\n"
"level, and says at which they collapse: the first after which the stones are\n"
"displaced by more than a quarter of a stone in the mean. FILE holds one\n"
"statement a line; - is stdin.\n"
"\n"
"  -l, --levels A-B   shake at levels A to B; default 1-20; N: 1-N\n"
"  -n, --repeat R     shake R times, each with a little noise in the places\n"
"                     of the stones and another moment to begin; default 1\n"
"      --seed S       of that noise, an integer; default 1\n"
"      --unit U       length of a stone, in the units of the file; default 1\n"
"      --json         one JSON object a file, one line each\n"
"      --svg OUT.svg  draw it before and after a level\n"
"      --film OUT.svg the shaking of a level, an SVG that moves\n"
"      --show L       the level which they show; default: that of collapse\n"
"      --help, --version\n"
"\n"
"With several files the pictures of each NAME.* are in OUT-NAME.svg.\n"
"A level is 0.059 g of peak horizontal acceleration, 0.01 U of amplitude.\n"
"Exit status: 0 done, 2 bad use or input.\n";

enum { EXIT_DONE = 0, EXIT_BAD = 2, MOST_LEVELS = 1000, NAME_ROOM = 4096 };

/* ---- The scene and its numbers: lengths in stones, g is 9.81 ------------- */

static const double gravity = 9.81;
static const double pi = 3.14159265358979323846;
static const double frequency = 0.7;      /* of the table, 1/s               */
static const double amplitude = 0.02;     /* of a level, over 3 - cos 2wt    */
static const double turn_weight = 0.25;   /* of a turn, squared, in a score  */
static const double threshold = 0.25;     /* of the mean score: collapse     */
static const double noise = 1e-4;         /* of each place and angle         */
static const double stop_height = 0.3;    /* of the side stops on the base   */
static const double stop_thick = 0.3;     /* of each                         */
static const double stop_clear = 0.5;     /* between them and the structure  */
static const double ground_below = 0.25;  /* the base                        */

/* The shaking: rest, swelling, full strength, fading, and rest until nothing
   moves any more. The end of each, in seconds. */
static const double rest_ends = 0.5, swell_ends = 1.5, full_ends = 7.5,
                    fade_ends = 8.5, last_end = 10.5;
static const double still = 2e-3;         /* speed below which a stone rests */
static const int look_every = 24;         /* steps, whether all do           */
static const int frame_every = 12;        /* steps, of a film                */

struct settings {
    int first, last;        /* levels                                  */
    int repeat, json;
    int show;               /* level of the pictures, 0: collapse      */
    kern_real unit;
    uint64_t seed;
    const char *svg, *film;
    char **file;
    int files;
};

struct pose { double x, y, angle; };

/* A structure on the table. Pose 0 is the base, pose i + 1 stone i. */
struct table {
    const struct settings *set;
    const char *file;
    struct text_file text;
    struct rigid_world world;
    int stones;
    int *block;             /* of the world, for each pose             */
    int *source;            /* block of the text, for each stone       */
    struct pose *home;      /* as in the file                          */
    struct pose *begin;     /* with the noise                          */
    double left, right, bottom, top;      /* of base and structure     */
    struct rigid_pt stop[2];              /* upper inner corners       */
};

/* Poses of a film, frame after frame. */
struct film {
    struct pose *pose;
    int frames, room;       /* in frames                               */
};

/* What shaking said, over all repetitions. */
struct report {
    double *ads;            /* mean score, one a level                 */
    double *first;          /* mean first level of each stone          */
    double level, level_sd; /* of collapse                             */
    int shown;              /* level of collapse of repetition 0       */
    double seconds;
};

/* ---- Noise --------------------------------------------------------------- */

static uint64_t random_next(uint64_t *state)
{
    uint64_t z = *state += UINT64_C(0x9e3779b97f4a7c15); /* splitmix64 */
    z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
    z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
    return z ^ (z >> 31);
}

static double random_uniform(uint64_t *state)
{
    return (double)(random_next(state) >> 11) / 9007199254740992.0;
}

/* Near enough to a normal distribution, and without a logarithm, which not
   every machine rounds alike. */
static double random_normal(uint64_t *state)
{
    double sum = -6;
    for (int i = 0; i < 12; i++) sum += random_uniform(state);
    return sum;
}

/* ---- Building ------------------------------------------------------------ */

static int fail(struct table *t, const char *message)
{
    snprintf(t->text.message, sizeof t->text.message, "%s", message);
    t->text.line = 0;
    return -1;
}

/* A point of the file, in stones. */
static struct rigid_pt scaled(const struct table *t, kern_vec p)
{
    double unit = (double)t->set->unit;
    return rigid_vec((double)p.x / unit, (double)p.y / unit);
}

/* Adds block i of the text; with `more` it becomes part of the last one. */
static int add_block(struct table *t, int i, int more)
{
    const kern_block *b = &t->text.block[i];
    struct rigid_pt *v = malloc((size_t)b->vertices * sizeof *v);
    int index = -1;
    if (!v) return -1;
    for (int k = 0; k < b->vertices; k++) {
        v[k] = scaled(t, b->vertex[k]);
        t->left = fmin(t->left, v[k].x);
        t->right = fmax(t->right, v[k].x);
        t->bottom = fmin(t->bottom, v[k].y);
        t->top = fmax(t->top, v[k].y);
    }
    index = rigid_add_part(&t->world, v, b->vertices,
                           b->fixed ? 0 : (double)b->mass,
                           scaled(t, b->centre), more);
    free(v);
    return index;
}

/* Adds a rectangle that is part of the last block, or a block of its own. */
static int add_box(struct table *t, double left, double bottom, double right,
                   double top, int more)
{
    struct rigid_pt v[4] = { { left, bottom }, { right, bottom },
                             { right, top }, { left, top } };
    return rigid_add_part(&t->world, v, 4, 0, v[0], more);
}

/* Where the base ends on one side (-1 left, 1 right), and its height there. */
static struct rigid_pt base_end(const struct table *t, int side)
{
    struct rigid_pt end = { 0, 0 };
    double far = -HUGE_VAL;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        double reach = -HUGE_VAL, top = -HUGE_VAL;
        if (!b->fixed) continue;
        for (int k = 0; k < b->vertices; k++) {
            struct rigid_pt p = scaled(t, b->vertex[k]);
            reach = fmax(reach, side * p.x);
            top = fmax(top, p.y);
        }
        if (reach > far) {
            far = reach;
            end = rigid_vec(side * reach, top);
        }
    }
    return end;
}

/* The table: all that is fixed, with a stop at either side so that stones do
   not roll off, and the ground beneath. */
static int add_base(struct table *t, double left, double right)
{
    const double thick = stop_thick, deep = 2, wide = 200;
    int base = -1;
    for (int i = 0; i < t->text.blocks; i++)
        if (t->text.block[i].fixed) {
            base = add_block(t, i, base >= 0);
            if (base < 0) return -1;
        }
    t->stop[0] = base_end(t, -1);
    t->stop[1] = base_end(t, 1);
    t->stop[0].x = fmin(t->stop[0].x, left - stop_clear);
    t->stop[1].x = fmax(t->stop[1].x, right + stop_clear);
    t->stop[0].y += stop_height;
    t->stop[1].y += stop_height;
    t->left = fmin(t->left, t->stop[0].x) - thick;
    t->right = fmax(t->right, t->stop[1].x) + thick;
    t->top = fmax(t->top, fmax(t->stop[0].y, t->stop[1].y));
    if (add_box(t, t->stop[0].x - thick, t->bottom, t->stop[0].x,
                t->stop[0].y, 1) < 0 ||
        add_box(t, t->stop[1].x, t->bottom, t->stop[1].x + thick,
                t->stop[1].y, 1) < 0)
        return -1;
    t->block[0] = base;
    t->bottom -= ground_below;
    return add_box(t, t->left - wide, t->bottom - deep, t->right + wide,
                   t->bottom, 0) < 0 ? -1 : 0;
}

/* Loads keep their ratio to the weights: g becomes 9.81, a stone 1. */
static int add_stones(struct table *t, double strength)
{
    double pull = gravity / strength;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        struct rigid_block *r;
        int index;
        if (b->fixed) continue;
        index = add_block(t, i, 0);
        if (index < 0) return -1;
        r = &t->world.block[index];
        r->force = rigid_vec((double)b->load.fx * pull,
                             (double)b->load.fy * pull);
        r->torque = (double)b->load.torque * pull / (double)t->set->unit;
        t->source[t->stones] = i;
        t->block[++t->stones] = index;
    }
    return 0;
}

static int make_room(struct table *t)
{
    size_t poses = (size_t)t->text.blocks + 1;
    t->block = calloc(poses, sizeof *t->block);
    t->source = calloc(poses, sizeof *t->source);
    t->home = calloc(poses, sizeof *t->home);
    t->begin = calloc(poses, sizeof *t->begin);
    return t->block && t->source && t->home && t->begin ? 0 : -1;
}

/* The leftmost and rightmost corner of the stones. */
static void find_sides(const struct table *t, double *left, double *right)
{
    *left = HUGE_VAL;
    *right = -HUGE_VAL;
    for (int i = 0; i < t->text.blocks; i++) {
        const kern_block *b = &t->text.block[i];
        for (int k = 0; k < b->vertices && !b->fixed; k++) {
            *left = fmin(*left, scaled(t, b->vertex[k]).x);
            *right = fmax(*right, scaled(t, b->vertex[k]).x);
        }
    }
}

/* Reads a file and builds the scene. Returns 0, or -1 with a message. */
static int table_load(struct table *t)
{
    const struct text_file *s = &t->text;
    double left, right, gx, gy, strength;
    if (text_load(&t->text, t->file)) return -1;
    gx = (double)s->gravity.x;
    gy = (double)s->gravity.y;
    strength = draw_hypot(gx, gy);
    if (s->given) return fail(t, "its contacts are given; stones that move "
                                 "find their own");
    if (s->fixed == 0) return fail(t, "nothing is fixed that could shake it");
    if (!(strength > 0)) return fail(t, "there is no gravity");
    if (make_room(t)) return fail(t, "not enough memory to shake it");

    rigid_init(&t->world);
    t->world.friction = (double)s->options.mu;
    t->world.gravity = rigid_vec(gx / strength * gravity,
                                 gy / strength * gravity);
    t->left = t->bottom = HUGE_VAL;
    t->right = t->top = -HUGE_VAL;
    find_sides(t, &left, &right);
    if (add_base(t, left, right) || add_stones(t, strength))
        return fail(t, "not enough memory to shake it");
    for (int i = 0; i <= t->stones; i++) {
        struct rigid_pt at = t->world.block[t->block[i]].at;
        t->home[i].x = at.x;
        t->home[i].y = at.y;
    }
    return 0;
}

static void table_free(struct table *t)
{
    text_free(&t->text);
    rigid_free(&t->world);
    free(t->block);
    free(t->source);
    free(t->home);
    free(t->begin);
}

/* ---- Shaking ------------------------------------------------------------- */

/* How strong the shaking is at a time. */
static double strength_at(double time)
{
    if (time < rest_ends || time > fade_ends) return 0;
    if (time < swell_ends) return (time - rest_ends) / (swell_ends - rest_ends);
    if (time < full_ends) return 1;
    return (fade_ends - time) / (fade_ends - full_ends);
}

/* The table runs x = s cos a, y = s/2 sin 2a, s = scale / (3 - cos 2a), here
   with the cosine and sine of a as q. */
static struct rigid_pt eight(struct rigid_pt q, double scale)
{
    double cos2 = q.x * q.x - q.y * q.y, sin2 = 2 * q.x * q.y;
    double s = scale / (3 - cos2);
    return rigid_vec(s * q.x, s / 2 * sin2);
}

static struct pose pose_of(const struct table *t, int i)
{
    const struct rigid_block *b = &t->world.block[t->block[i]];
    struct pose p = { b->at.x, b->at.y, b->angle };
    return p;
}

/* Puts everything back, the stones with a little noise. */
static void table_reset(struct table *t, uint64_t *state)
{
    for (int i = 0; i <= t->stones; i++) {
        struct pose *p = &t->begin[i];
        *p = t->home[i];
        if (i > 0) {
            p->x += noise * random_normal(state);
            p->y += noise * random_normal(state);
            p->angle += noise * random_normal(state);
        }
        rigid_put(&t->world, t->block[i], rigid_vec(p->x, p->y), p->angle);
    }
}

static int all_still(const struct table *t)
{
    for (int i = 1; i <= t->stones; i++) {
        const struct rigid_block *b = &t->world.block[t->block[i]];
        if (!(fabs(b->v.x) + fabs(b->v.y) + fabs(b->spin) < still)) return 0;
    }
    return 1;
}

static int film_add(struct film *f, const struct table *t)
{
    size_t poses = (size_t)t->stones + 1;
    struct pose *more = rigid_room(f->pose, f->frames, 1, &f->room,
                                   poses * sizeof *more);
    if (!more) return -1;
    f->pose = more;
    for (int i = 0; i <= t->stones; i++)
        f->pose[(size_t)f->frames * poses + (size_t)i] = pose_of(t, i);
    f->frames++;
    return 0;
}

/* Shakes at one level. The table is driven by its speed, so that it is at each
   place at the end of a step. Returns -1 where memory is lacking. */
static int shake(struct table *t, int level, int repetition, struct film *film)
{
    struct rigid_world *w = &t->world;
    double dt = w->step;
    uint64_t state = t->set->seed * 1000003 + (uint64_t)repetition;
    state = random_next(&state) + (uint64_t)level;
    table_reset(t, &state);
    struct rigid_block *base = &w->block[t->block[0]];
    struct rigid_pt q = rigid_unit(2 * pi * random_uniform(&state));
    struct rigid_pt on = rigid_unit(2 * pi * frequency * dt);
    int steps = (int)(last_end / dt + 0.5);
    for (int i = 1; i <= steps; i++) {
        double time = i * dt, strength = strength_at(time);
        struct rigid_pt p = eight(q, amplitude * level * strength);
        if (film && i % frame_every == 1 && film_add(film, t)) return -1;
        if (time > fade_ends && i % look_every == 0 && all_still(t)) break;
        base->v.x = (t->home[0].x + p.x - base->at.x) / dt;
        base->v.y = (t->home[0].y + p.y - base->at.y) / dt;
        if (rigid_step(w)) return -1;
        q = rigid_turned(q, on);
    }
    return film ? film_add(film, t) : 0;
}

/* The displacement score of a stone: its way on the base, and its turn. */
static double score_of(const struct table *t, int stone)
{
    struct pose base = pose_of(t, 0), p = pose_of(t, stone + 1);
    const struct pose *b = &t->begin[0], *o = &t->begin[stone + 1];
    double x = (p.x - base.x) - (o->x - b->x);
    double y = (p.y - base.y) - (o->y - b->y), turn = p.angle - o->angle;
    return sqrt(x * x + y * y + turn_weight * turn * turn);
}

static double mean_score(const struct table *t)
{
    double sum = 0;
    for (int i = 0; i < t->stones; i++) sum += score_of(t, i);
    return sum / t->stones;
}

/* ---- All levels ---------------------------------------------------------- */

/* Says what is going on where someone may be waiting. */
static void show_progress(const struct table *t, int number, int repetition,
                          int level, time_t since)
{
    if (!IS_TERMINAL(2) || difftime(time(NULL), since) < 2) return;
    fprintf(stderr, "\rshake: file %d of %d, repetition %d of %d, level %d   ",
            number + 1, t->set->files, repetition + 1, t->set->repeat, level);
    fflush(stderr);
}

/* Shakes at all levels once. `first` takes the first level after which each
   stone is displaced, `level` that of collapse; one more than the last where
   there is none. */
static int one_repetition(struct table *t, int repetition, struct report *r,
                          int *first, int *level, int number, time_t since)
{
    const struct settings *set = t->set;
    *level = set->last + 1;
    for (int i = 0; i < t->stones; i++) first[i] = set->last + 1;
    for (int l = set->first; l <= set->last; l++) {
        double ads;
        show_progress(t, number, repetition, l, since);
        if (shake(t, l, repetition, NULL)) return -1;
        ads = mean_score(t);
        r->ads[l - set->first] += ads / set->repeat;
        if (ads > threshold && l < *level) *level = l;
        for (int i = 0; i < t->stones; i++)
            if (score_of(t, i) > threshold && l < first[i]) first[i] = l;
    }
    return 0;
}

static int shake_all(struct table *t, struct report *r, int number)
{
    const struct settings *set = t->set;
    time_t since = time(NULL);
    clock_t start = clock();
    double sum = 0, squares = 0;
    int *first = calloc((size_t)t->stones, sizeof *first), bad = 0;
    r->ads = calloc((size_t)(set->last - set->first + 1), sizeof *r->ads);
    r->first = calloc((size_t)t->stones, sizeof *r->first);
    bad = !first || !r->ads || !r->first;
    for (int k = 0; k < set->repeat && !bad; k++) {
        int level;
        bad = one_repetition(t, k, r, first, &level, number, since);
        if (bad) break;
        if (k == 0) r->shown = level > set->last ? set->last : level;
        sum += level;
        squares += (double)level * level;
        for (int i = 0; i < t->stones; i++)
            r->first[i] += (double)first[i] / set->repeat;
    }
    free(first);
    r->level = sum / set->repeat;
    if (set->repeat > 1)
        r->level_sd = sqrt(fmax(0, squares - sum * r->level) /
                           (set->repeat - 1));
    r->seconds = (double)(clock() - start) / CLOCKS_PER_SEC;
    if (IS_TERMINAL(2)) fprintf(stderr, "\r%*s\r", 70, "");
    return bad ? fail(t, "not enough memory to shake it") : 0;
}

/* ---- Reports ------------------------------------------------------------- */

static const char *stone_name(const struct table *t, int stone)
{
    return t->text.name[t->source[stone]];
}

static void print_text(const struct table *t, const struct report *r)
{
    const struct settings *set = t->set;
    char shown[TEXT_SHOW_ROOM];
    printf("%s: %d stones\n", t->file, t->stones);
    if (r->level > set->last)
        printf("  does not collapse up to level %d\n", set->last);
    else
        printf("  collapses at level %.4g", r->level);
    if (r->level <= set->last && set->repeat > 1)
        printf(" (standard deviation %.2g of %d)", r->level_sd, set->repeat);
    if (r->level <= set->last) putchar('\n');
    printf("  %.2f s to shake it\n  level  mean displacement\n", r->seconds);
    for (int l = set->first; l <= set->last; l++)
        printf("  %5d  %.4f\n", l, r->ads[l - set->first]);
    printf("  stone  first displaced at level\n");
    for (int i = 0; i < t->stones; i++)
        if (r->first[i] > set->last)
            printf("  %s  never\n", text_show(shown, stone_name(t, i)));
        else
            printf("  %s  %.4g\n", text_show(shown, stone_name(t, i)),
                   r->first[i]);
}

/* A JSON string; what is not UTF-8 becomes a question mark. */
static void print_string(const char *s)
{
    putchar('"');
    while (*s) {
        int n = text_utf8(s);
        if (n == 0) putchar('?');
        else if (n == 1 && (*s == '"' || *s == '\\')) printf("\\%c", *s);
        else if (n == 1 && ((unsigned char)*s < 32 || *s == 127))
            printf("\\u%04x", (unsigned)*s);
        else fwrite(s, 1, (size_t)n, stdout);
        s += n > 0 ? n : 1;
    }
    putchar('"');
}

static void print_json(const struct table *t, const struct report *r)
{
    const struct settings *set = t->set;
    printf("{\"file\":");
    print_string(t->file);
    printf(",\"stones\":%d,\"levels\":[%d,%d],\"repetitions\":%d,"
           "\"level\":%.6g,\"level_sd\":%.6g,\"ads\":[", t->stones, set->first,
           set->last, set->repeat, r->level, r->level_sd);
    for (int l = set->first; l <= set->last; l++)
        printf("%s%.9g", l > set->first ? "," : "", r->ads[l - set->first]);
    printf("],\"first\":[");
    for (int i = 0; i < t->stones; i++) {
        printf("%s{\"block\":", i > 0 ? "," : "");
        print_string(stone_name(t, i));
        printf(",\"level\":%.6g}", r->first[i]);
    }
    printf("],\"seconds\":%.6g}\n", r->seconds);
}

/* ---- Pictures ------------------------------------------------------------ */

/* What both pictures show of the world: the room that the base may take. */
static void fit_view(const struct table *t, struct draw_view *v, double level,
                     double width, double height)
{
    const double margin = 0.25, fallen = 1.5; /* for what is beside the base */
    double sway = amplitude * level / 2;
    v->low = draw_vec(t->left - sway - fallen, t->bottom - margin);
    v->high = draw_vec(t->right + sway + fallen, t->top + sway / 2 + margin);
    v->scale = fmin(width / (v->high.x - v->low.x),
                    height / (v->high.y - v->low.y));
    v->scale = fmin(v->scale, DRAW_STONE);
}

static double view_width(const struct draw_view *v)
{
    return (v->high.x - v->low.x) * v->scale;
}

static double view_height(const struct draw_view *v)
{
    return (v->high.y - v->low.y) * v->scale;
}

/* Writes the outline of a block of the text, about its home, as a path in
   pixels. The end of the element is the caller's. */
static void put_outline(const struct table *t, const struct draw_view *v,
                        int source, int pose)
{
    const kern_block *b = &t->text.block[source];
    const double far = 4 * (t->right - t->left + t->top - t->bottom);
    fputs("<path d=\"", v->out);
    for (int k = 0; k < b->vertices; k++) {
        struct rigid_pt p = scaled(t, b->vertex[k]);
        /* Renderers do not like a ground as wide as the world. */
        double x = draw_clamp(p.x - t->home[pose].x, -far, far);
        double y = draw_clamp(p.y - t->home[pose].y, -far, far);
        fprintf(v->out, "%s%.2f %.2f", k ? "L" : "M", draw_px(x * v->scale),
                draw_px(-y * v->scale));
    }
    fputs("Z\"", v->out);
}

/* The base about its home, with the side stops. */
static void put_base(const struct table *t, const struct draw_view *v)
{
    static const char *const hatch = "fill=\"url(#ground)\" stroke=\""
                                     DRAW_EDGE "\" stroke-width=\"1\"";
    for (int i = 0; i < t->text.blocks; i++) {
        if (!t->text.block[i].fixed) continue;
        put_outline(t, v, i, 0);
        fprintf(v->out, " %s/>\n", hatch);
    }
    for (int side = 0; side < 2; side++) {
        const double thick = stop_thick;
        double x = (t->stop[side].x - (side ? 0 : thick) - t->home[0].x);
        double y = t->stop[side].y - t->home[0].y;
        double height = t->stop[side].y - (t->bottom + ground_below);
        draw_rect(v->out, x * v->scale, -y * v->scale, thick * v->scale,
                  height * v->scale, hatch);
    }
}

static void put_ground(const struct table *t, const struct draw_view *v)
{
    struct draw_pt p = draw_place(v, v->low.x, t->bottom);
    draw_rect(v->out, p.x, p.y, view_width(v), v->top + view_height(v) - p.y,
              "fill=\"#d8d3c8\"");
    draw_line(v->out, p, draw_vec(p.x + view_width(v), p.y),
              "stroke=\"" DRAW_EDGE "\" stroke-width=\"1\"");
}

/* The colour of a stone: one of the usual, or that of what was displaced. */
static const char *stone_fill(int stone, int displaced)
{
    const int fills = (int)(sizeof draw_stone / sizeof draw_stone[0]);
    return displaced ? "#e2a37f" : draw_stone[stone % fills];
}

static void put_stone(const struct table *t, const struct draw_view *v,
                      int stone, int displaced)
{
    put_outline(t, v, t->source[stone], stone + 1);
    fprintf(v->out, " fill=\"%s\" stroke=\"" DRAW_EDGE "\" stroke-width=\"1\" "
            "stroke-linejoin=\"round\"/>\n", stone_fill(stone, displaced));
}

static void put_transform(const struct draw_view *v, struct pose p)
{
    struct draw_pt at = draw_place(v, p.x, p.y);
    fprintf(v->out, "<g transform=\"translate(%.2f %.2f) rotate(%.3f)\">\n",
            draw_px(at.x), draw_px(at.y), -p.angle * 180 / pi);
}

/* The scene, base and stones at these poses; NULL: as in the file. */
static void put_scene(const struct table *t, const struct draw_view *v,
                      const struct pose *pose)
{
    if (!pose) pose = t->home;
    put_ground(t, v);
    put_transform(v, pose[0]);
    put_base(t, v);
    draw_close(v->out);
    for (int i = 0; i < t->stones; i++) {
        put_transform(v, pose[i + 1]);
        put_stone(t, v, i, pose != t->home && score_of(t, i) > threshold);
        draw_close(v->out);
    }
}

/* Hatching, and the window that the drawing is cut at, named by a number. */
static void put_window(const struct draw_view *v, int number)
{
    fprintf(v->out, "<defs>\n<clipPath id=\"view%d\"><rect x=\"%.2f\" "
            "y=\"%.2f\" width=\"%.2f\" height=\"%.2f\"/></clipPath>\n", number,
            v->left, v->top, draw_px(view_width(v)), draw_px(view_height(v)));
    if (number == 0)
        fputs("<pattern id=\"ground\" width=\"7\" height=\"7\" patternUnits="
              "\"userSpaceOnUse\" patternTransform=\"rotate(45)\">"
              "<rect width=\"7\" height=\"7\" fill=\"#f4f2ee\"/>"
              "<path d=\"M3.5 0V7\" stroke=\"#a59d90\" stroke-width=\"0.9\"/>"
              "</pattern>\n", v->out);
    fputs("</defs>\n", v->out);
}

static void put_heading(FILE *out, double x, double y, const char *text)
{
    draw_open(out, "font-family=\"" DRAW_FONT "\" fill=\"" DRAW_INK "\"");
    draw_text(out, x, y, 12.5, "start", text, strlen(text));
    draw_close(out);
}

/* Two drawings, before and after a level; above each other where the
   structure is wider than high. */
static int put_svg(FILE *out, const struct table *t, int level)
{
    const double head = 20, gap = 18;
    struct draw_view v;
    struct pose *after = malloc(((size_t)t->stones + 1) * sizeof *after);
    char text[2][120];
    double w, h;
    int below = t->right - t->left > t->top - t->bottom;
    if (!after) return -1;
    for (int i = 0; i <= t->stones; i++) after[i] = pose_of(t, i);
    v.out = out;
    fit_view(t, &v, level, below ? DRAW_WIDTH : DRAW_WIDTH / 2,
             below ? DRAW_HEIGHT / 2 : DRAW_HEIGHT);
    w = fmax(view_width(&v), 300);
    h = view_height(&v) + head;
    snprintf(text[0], sizeof text[0], "before");
    snprintf(text[1], sizeof text[1], "after level %d: displaced by %.2f in "
             "the mean", level, mean_score(t));
    draw_begin(out, ceil((below ? w : 2 * w + gap) + 2 * DRAW_PAD),
               ceil((below ? 2 * h + gap : h) + 2 * DRAW_PAD));
    for (int k = 0; k < 2; k++) {
        v.left = DRAW_PAD + (k && !below ? w + gap : 0);
        v.top = DRAW_PAD + head + (k && below ? h + gap : 0);
        put_window(&v, k);
        put_heading(out, v.left, v.top - 8, text[k]);
        draw_open(out, k ? "clip-path=\"url(#view1)\""
                         : "clip-path=\"url(#view0)\"");
        put_scene(t, &v, k ? after : NULL);
        draw_close(out);
    }
    free(after);
    return draw_end(out);
}

/* Two nested groups: one moves with the poses of a film, one turns. */
static void put_motion(const struct draw_view *v, const struct film *f, int i,
                       int poses, double seconds)
{
    const struct pose *p = f->pose + i;
    struct draw_pt at = draw_place(v, p->x, p->y);
    fprintf(v->out, "<g transform=\"translate(%.2f %.2f)\">"
            "<animateTransform attributeName=\"transform\" type=\"translate\" "
            "dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"",
            draw_px(at.x), draw_px(at.y), seconds);
    for (int k = 0; k < f->frames; k++) {
        at = draw_place(v, p[k * poses].x, p[k * poses].y);
        fprintf(v->out, "%s%.4g %.4g", k ? ";" : "", draw_px(at.x),
                draw_px(at.y));
    }
    fprintf(v->out, "\"/>\n<g><animateTransform attributeName=\"transform\" "
            "type=\"rotate\" dur=\"%.2fs\" repeatCount=\"indefinite\" "
            "values=\"", seconds);
    for (int k = 0; k < f->frames; k++)
        fprintf(v->out, "%s%.4g", k ? ";" : "",
                draw_px(-p[k * poses].angle * 180 / pi));
    fputs("\"/>\n", v->out);
}

static int put_film(FILE *out, const struct table *t, const struct film *f,
                    int level)
{
    const double head = 20, foot = 14;
    int poses = t->stones + 1;
    double seconds = (f->frames - 1) * frame_every * t->world.step;
    struct draw_view v;
    char text[120];
    v.out = out;
    v.left = DRAW_PAD;
    v.top = DRAW_PAD + head;
    fit_view(t, &v, level, DRAW_WIDTH, DRAW_HEIGHT);
    snprintf(text, sizeof text, "level %d: displaced by %.2f in the mean",
             level, mean_score(t));
    draw_begin(out, ceil(fmax(view_width(&v), 300) + 2 * DRAW_PAD),
               ceil(view_height(&v) + head + foot + 2 * DRAW_PAD));
    put_window(&v, 0);
    put_heading(out, v.left, v.top - 8, text);
    draw_open(out, "clip-path=\"url(#view0)\"");
    put_ground(t, &v);
    for (int i = 0; i < poses; i++) {
        put_motion(&v, f, i, poses, seconds);
        if (i == 0) put_base(t, &v);
        else put_stone(t, &v, i - 1, 0);
        fputs("</g></g>\n", out);
    }
    draw_close(out);
    fprintf(out, "<rect x=\"%.2f\" y=\"%.2f\" width=\"0\" height=\"3\" "
            "fill=\"" DRAW_KERN "\"><animate attributeName=\"width\" "
            "dur=\"%.2fs\" repeatCount=\"indefinite\" values=\"0;%.2f\"/>"
            "</rect>\n", v.left, v.top + view_height(&v) + foot - 5, seconds,
            view_width(&v));
    return draw_end(out);
}

/* The file of a picture: with several structures it takes their name, without
   folder and ending, before its own ending. */
static void picture_name(const struct table *t, const char *name, char *out)
{
    const char *base = t->file, *end, *dot = strrchr(name, '.');
    int stem = dot && !strpbrk(dot, "/\\") ? (int)(dot - name)
                                            : (int)strlen(name);
    for (const char *s = t->file; *s; s++)
        if (*s == '/' || *s == '\\') base = s + 1;
    end = strrchr(base, '.');
    if (!end || end == base) end = base + strlen(base);
    if (t->set->files == 1) snprintf(out, NAME_ROOM, "%s", name);
    else snprintf(out, NAME_ROOM, "%.*s-%.*s%s", stem, name, (int)(end - base),
                  base, name + stem);
}

/* Writes one picture; `film` NULL: that of before and after. */
static int write_picture(const struct table *t, const char *name, int level,
                         const struct film *film)
{
    char path[NAME_ROOM];
    FILE *out;
    int bad;
    picture_name(t, name, path);
    out = fopen(path, "wb");
    bad = !out;
    if (out) {
        bad = film ? put_film(out, t, film, level) : put_svg(out, t, level);
        bad |= fclose(out) != 0;
    }
    if (bad)
        fprintf(stderr, "shake: cannot write %s: %s\n", path, strerror(errno));
    return bad ? -1 : 0;
}

/* Shakes once more at the level that is to be seen, as in repetition 0. */
static int draw_level(struct table *t, int level)
{
    const struct settings *set = t->set;
    struct film film = { NULL, 0, 0 };
    int bad = shake(t, level, 0, &film);
    if (bad) fputs("shake: not enough memory for the pictures\n", stderr);
    if (!bad && set->svg) bad = write_picture(t, set->svg, level, NULL);
    if (!bad && set->film) bad = write_picture(t, set->film, level, &film);
    free(film.pose);
    return bad;
}

/* ---- The command line ---------------------------------------------------- */

static int run_file(const struct settings *set, int number)
{
    static const struct table empty;
    struct table t = empty;
    struct report r = { NULL, NULL, 0, 0, 0, 0 };
    int bad;
    t.set = set;
    t.file = set->file[number];
    bad = table_load(&t) || shake_all(&t, &r, number);
    if (bad) {
        fprintf(stderr, "%s:", t.file);
        if (t.text.line > 0) fprintf(stderr, "%d:", t.text.line);
        fprintf(stderr, " %s\n", t.text.message);
    } else {
        if (set->json) print_json(&t, &r);
        else print_text(&t, &r);
        fflush(stdout);
        if (set->svg || set->film)
            bad = draw_level(&t, set->show ? set->show : r.shown);
    }
    free(r.ads);
    free(r.first);
    table_free(&t);
    return bad ? EXIT_BAD : EXIT_DONE;
}

static int bad_use(const char *what, const char *word)
{
    fprintf(stderr, "shake: %s %s; try shake --help\n", what, word);
    return -1;
}

/* The value of option `name` at argv[*i]: after "=", or the next argument.
   Returns 1 and moves *i on, or 0 where this is another option. */
static int option_value(char **argv, int *i, const char *name,
                        const char **value)
{
    size_t n = strlen(name);
    if (strncmp(argv[*i], name, n) != 0) return 0;
    *value = "";
    if (argv[*i][n] == '=' && name[1] == '-') *value = argv[*i] + n + 1;
    else if (argv[*i][n] != '\0') return 0;
    else if (argv[*i + 1]) *value = argv[++*i];
    return 1;
}

/* Reads an integer at *s within a range and moves *s behind it. */
static int read_integer(const char **s, long least, long most, int *out)
{
    char *end;
    long value;
    if (**s < '0' || **s > '9') return -1;
    errno = 0;
    value = strtol(*s, &end, 10);
    if (errno || value < least || value > most) return -1;
    *out = (int)value;
    *s = end;
    return 0;
}

/* "A-B", "A..B", or "B", which is 1-B. */
static int read_levels(struct settings *set, const char *s)
{
    int first = 1, last;
    if (read_integer(&s, 1, MOST_LEVELS, &last)) return -1;
    if (*s) {
        size_t n = *s == '-' ? 1 : strncmp(s, "..", 2) == 0 ? 2 : 0;
        first = last;
        s += n;
        if (n == 0 || read_integer(&s, first, MOST_LEVELS, &last)) return -1;
    }
    set->first = first;
    set->last = last;
    return *s ? -1 : 0;
}

static int read_number(struct settings *set, const char *name, const char *s)
{
    int seed = 0, bad;
    const char *word = s;
    if (strcmp(name, "--repeat") == 0)
        bad = read_integer(&s, 1, 100000, &set->repeat) || *s;
    else if (strcmp(name, "--show") == 0)
        bad = read_integer(&s, 1, MOST_LEVELS, &set->show) || *s;
    else if (strcmp(name, "--levels") == 0)
        bad = read_levels(set, s);
    else if (strcmp(name, "--unit") == 0)
        bad = !text_number(s, &set->unit) || !(set->unit > 0);
    else {
        bad = read_integer(&s, 0, INT_MAX, &seed) || *s;
        set->seed = (uint64_t)seed;
    }
    if (!bad) return 0;
    fprintf(stderr, "shake: %s does not take '%s'; try shake --help\n", name,
            word);
    return -1;
}

static int read_option(struct settings *set, char **argv, int *i)
{
    static const char *const number[] = { "--levels", "--repeat", "--seed",
                                          "--unit", "--show" };
    const char *word = argv[*i], *value;
    for (int k = 0; k < (int)(sizeof number / sizeof number[0]); k++)
        if (option_value(argv, i, number[k], &value) ||
            (k == 0 && option_value(argv, i, "-l", &value)) ||
            (k == 1 && option_value(argv, i, "-n", &value)))
            return read_number(set, number[k], value);
    if (option_value(argv, i, "--svg", &set->svg))
        return *set->svg ? 0 : bad_use("no file is given for", word);
    if (option_value(argv, i, "--film", &set->film))
        return *set->film ? 0 : bad_use("no file is given for", word);
    if (strcmp(word, "--json") != 0) return bad_use("unknown option", word);
    set->json = 1;
    return 0;
}

int main(int argc, char **argv)
{
    struct settings set = { 1, 20, 1, 0, 0, 1, 1, NULL, NULL, argv, 0 };
    int options = 1, status = EXIT_DONE;
    for (int i = 1; i < argc; i++) {
        const char *word = argv[i];
        if (!options || word[0] != '-' || word[1] == '\0') {
            set.file[set.files++] = argv[i]; /* over arguments read already */
        } else if (strcmp(word, "--") == 0) {
            options = 0;
        } else if (strcmp(word, "--help") == 0) {
            return fputs(help, stdout) < 0 ? EXIT_BAD : EXIT_DONE;
        } else if (strcmp(word, "--version") == 0) {
            return puts("shake " KERN_VERSION) < 0 ? EXIT_BAD : EXIT_DONE;
        } else if (read_option(&set, argv, &i)) {
            return EXIT_BAD;
        }
    }
    if (set.files == 0) {
        fputs("shake: no file is given\n", stderr);
        fputs(help, stderr);
        return EXIT_BAD;
    }
    for (int i = 0; i < set.files; i++)
        if (run_file(&set, i)) status = EXIT_BAD;
    if (fflush(stdout) != 0 || ferror(stdout)) {
        fprintf(stderr, "shake: cannot write the report: %s\n",
                strerror(errno));
        return EXIT_BAD;
    }
    return status;
}
