/* state.h - what the command line asks for, what was found of one file, and
   what report, JSON and picture want to know of it.

   SPDX-License-Identifier: MIT */

#ifndef PROGRAM_STATE_H
#define PROGRAM_STATE_H

#include "../../kern.h"

#include "../parts/draw.h"
#include "../parts/drawing.h"
#include "../parts/text.h"

#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { LEFT, RIGHT, LIVE };
enum { MARGIN, LOAD_LEFT, LOAD_RIGHT, PROFILES };
enum { LABELS_MOST = 100 }; /* options --layer, and --density */

struct settings { /* of the command line; numbers < 0: not given */
    kern_real epsilon, mu, gap, at, limit, overlap;
    kern_real sweep;       /* places of the live load                     */
    kern_real turns, most; /* of --place                                  */
    kern_real error, turn; /* of --measured                               */
    kern_real own_error, own_turn; /* of --error                          */
    int relative, forces, mechanism, profile, touching, json, verdict_only;
    int raised, sequence, mechanism_live, lone;
    const char *svg, *page, *title, *c_file, *kern_file, *stays, *place,
        *thrust;
    struct shapes_asked drawing; /* of drawings and photographs         */
    const char *layer[LABELS_MOST], *density[LABELS_MOST],
        *friction[LABELS_MOST];
    kern_real ground, pixel, phi;
    char **file, **word; /* of the command line all words, up to NULL */
    int files;
};

/* The live load at a place: where its first force stands, and its factors. */
struct swept {
    double x, y, live, raised;
    int block; /* -1: beyond the structure */
    int cut;   /* the limit of work ended `raised` */
    int edge;  /* `raised` is known to .1 %        */
};

/* How many times the earth may press, 0: not asked. */
enum earth_part { EARTH_WHOLE, EARTH_HORIZONTAL, EARTH_PARTS };

struct growth {
    double limit, let_go; /* by limit analysis; let go NAN: not shown */
    kern_motion *motion;  /* just past `limit`; NULL: none            */
};

/* A place of one more stone, which is there. */
struct placed {
    kern_place rank;
    kern_vec *vertex;
};

/* All there is to say about one file. Numbers that do not exist are NAN. */
struct analysis {
    const struct settings *set;
    const char *file;
    int number; /* of the file among all             */
    struct text_file text;
    struct drawing drawing; /* that the text was made of               */
    int line;               /* of the error, 0: the whole file   */
    char error[600];        /* "" where there is none            */

    kern_task task;
    kern_contact *contact; /* task.s.contact                    */
    kern_work work;

    kern_status verdict;    /* of real contacts, at the shrinkage asked for */
    int certain;            /* 1 or 0; -1: --measured tells nothing  */
    kern_interval interval; /* of the margin, where it tells         */
    double probable;        /* margin of the measured poses, there   */
    kern_status shown;      /* of the contacts that are shown: with --near
                               near ones too                     */
    kern_force *force;      /* there, if it stands               */
    int least;              /* they are the least forces         */
    kern_force *live_force; /* with the live load as stated, for the page, if
                               it stands; NULL: not found        */
    kern_motion *motion;    /* there, if it falls                */
    kern_motion *fall;      /* the same with all other mechanisms: falls.h */

    kern_status measured; /* from shrinkage 0                  */
    kern_margin m;
    kern_force *last_force; /* at m.holds, if it stands at 0     */
    kern_motion *collapse;  /* just past the margin, or at 0; with
                               --mechanism live past its factor  */
    kern_critical critical; /* what limits the margin            */
    double deficit, bearing, load[2], tilt[2];
    kern_status lived;         /* whether a factor of the live load holds it */
    double live_least, live;   /* the range of these factors                 */
    double live_let_go[2];     /* that in which it stays; NAN: none is shown */
    double raised_load[3];     /* left, right, live; NAN: none is shown      */
    const char *raised_end[3]; /* of these: why the path ended; NULL: none */
    int cut[3];                /* of these: the limit of work ended it       */
    double *stress;            /* of a line contact at the margin; 0: none   */
    kern_contact *whole;       /* contacts before stone crushes, then those that
                                  are gone; NULL: it does not                */
    int crushes;               /* stands with stone that does not, falls     */
    int broken;                /* line contacts that bear nothing any more   */
    double crushed;            /* how far an end has moved in at most        */
    int settled;               /* the forces no longer move ends             */

    double thrust_least, thrust_most; /* of --thrust, to the left     */
    struct growth earth[EARTH_PARTS]; /* what of the thrust of earth grows */
    struct swept *swept;              /* the live load at each place       */
    int sweeps;
    int untried; /* places where the least factor may be as well       */
    struct analysis *without; /* the same where fill does not push back;
                                 NULL: no fill does, or it falls with it   */
    int bare; /* is this the same: fill does not push back             */

    struct text_file stone; /* of --place                      */
    struct placed *placed;  /* the best places of --place       */
    int places;
    kern_vec *place_vertex; /* of all of them in their order    */
    int place_vertices;     /* of each                          */

    kern_status let_go;   /* all blocks at once, of real contacts */
    char let_go_why[160]; /* "" where it was not asked            */
    kern_status raised;   /* real contacts, if asked for          */
    kern_raising raising;
    double reserve;
    kern_status borne, slid; /* of the measures behind these two: */
    kern_status slid_let_go, tilted_let_go[2];
    double bears, least_friction, least_friction_let_go;
    double tilt_let_go[2];
    double *sequence; /* the margin after each block       */
    double *laid;     /* the chance of each, laid last on those before */
    double *stays;    /* of a block of the whole: its chance; of both:
                         below 0 where it falls, NAN where it was not
                         asked for, or is undecided                    */

    kern_status profiled; /* both profiles, if asked for       */
    kern_real *fate[3];   /* of each block: its margin, and its load
                               factors to the left and the right */
    kern_collapse all[3]; /* their means                       */
};

static inline int fail(struct analysis *a, int line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(a->error, sizeof a->error, format, list);
    va_end(list);
    a->line = line;
    return -1;
}

/* How many blocks are stones or ground. The others, after them, push. */
static inline int stones(const struct analysis *a)
{
    return a->text.blocks - a->text.props;
}

/* The highest point of the outlines at x. Returns its block; -1: there is
   none. */
static inline int sweep_top(const struct analysis *a, double x, double *y)
{
    const kern_structure *s = &a->task.s;
    int top = -1;
    for (int i = 0; i < stones(a); i++) {
        const kern_block *b = &s->block[i];
        for (int k = 0; k < b->vertices; k++) {
            const kern_vec p = b->vertex[k];
            const kern_vec q = b->vertex[k + 1 < b->vertices ? k + 1 : 0];
            double at, along = x - (double)p.x;
            if ((p.x <= x) == (q.x <= x))
                continue;
            at = p.y + along * ((double)q.y - p.y) / ((double)q.x - p.x);
            if (top >= 0 && at <= *y)
                continue;
            *y = at;
            top = i;
        }
    }
    return top;
}

static inline double mean_size(const struct analysis *a)
{
    return (double)kern_mean_size(a->task.s.block, stones(a));
}

static inline int fail_memory(struct analysis *a)
{
    return fail(a, 0, "not enough memory for %d blocks and %d contact points",
                a->task.s.blocks, a->task.s.contacts);
}

/* The standard error of places: of the command line, or of the file. */
static inline kern_real pose_error(const struct analysis *a)
{
    return a->set->error > 0 ? a->set->error : a->text.error;
}

/* That of angles: the error of places over a block, where nobody tells it. */
static inline kern_real pose_turn(const struct analysis *a)
{
    if (a->set->error > 0 && !(a->set->turn < 0))
        return a->set->turn;
    if (!(a->set->error > 0) && a->text.turn > 0)
        return a->text.turn;
    return pose_error(a) / (kern_real)mean_size(a);
}

/* Does the collapse motion belong to the verdict, or to the margin? */
static inline kern_motion *shown_motion(const struct analysis *a)
{
    if (a->shown == KERN_FALLS)
        return a->motion;
    if (a->set->mechanism_live)
        return isfinite(a->live) ? a->collapse : NULL;
    if (a->measured == KERN_STANDS && !a->m.saturated)
        return a->collapse;
    return NULL;
}

/* What pictures and lists of blocks show: of what falls, every mechanism. */
static inline kern_motion *shown_fall(const struct analysis *a)
{
    return a->shown == KERN_FALLS ? a->fall : shown_motion(a);
}

static inline kern_real shrinkage(const struct analysis *a)
{
    return a->set->at < 0 ? 0 : a->set->at;
}

static inline double gravity_of(const struct analysis *a)
{
    return hypot(a->task.s.gravity.x, a->task.s.gravity.y);
}

/* Length 0 is asked for as 1, so that NULL always means failure. */
static inline void *array(int count, size_t size)
{
    return calloc(count > 0 ? (size_t)count : 1, size);
}

/* Near contacts are looked for where contacts are. */
static inline int is_near(const struct analysis *a)
{
    return a->set->touching && !a->text.given;
}

/* The contact of the largest stress among n from k on; -1: there is none. */
static inline int most_stressed(const struct analysis *a, int k, int n)
{
    int most = -1;
    for (int i = k; a->stress && i < k + n; i++)
        if (a->stress[i] > (most < 0 ? 0 : a->stress[most] * (1 + 1e-9)))
            most = i;
    return most;
}

static inline double value_or_nan(kern_status status, kern_real value)
{
    return status == KERN_STANDS ? (double)value : (double)NAN;
}

/* The load factor of block i: the mean of both sides. */
static inline double fate_load(const struct analysis *a, int i)
{
    return ((double)a->fate[LOAD_LEFT][i] + (double)a->fate[LOAD_RIGHT][i]) / 2;
}

static inline double mean_load(const struct analysis *a)
{
    return ((double)a->all[LOAD_LEFT].mean + (double)a->all[LOAD_RIGHT].mean)
         / 2;
}

static inline double weak_load(const struct analysis *a)
{
    return ((double)a->all[LOAD_LEFT].weak + (double)a->all[LOAD_RIGHT].weak)
         / 2;
}

static inline int is_open(kern_status status)
{
    return status == KERN_UNDECIDED || status == KERN_LIMIT;
}

static inline int is_all(const char *word) { return strcmp(word, "all") == 0; }

/* The first block with the least margin in the sequence; -1: none is known. */
static inline int weakest_step(const struct analysis *a)
{
    int weakest = -1;
    for (int i = 0; i < stones(a); i++)
        if (a->sequence[i] >= 0
            && (weakest < 0 || a->sequence[i] < a->sequence[weakest]))
            weakest = i;
    return weakest;
}

/* Let go as a whole: known once it was asked. */
static inline const char *let_go_word(const struct analysis *a)
{
    return a->let_go == KERN_STANDS ? "stays"
         : a->let_go == KERN_FALLS  ? "moves"
                                    : "not shown";
}

static inline const char *status_word(const struct analysis *a)
{
    if (a->error[0])
        return "error";
    return a->verdict == KERN_STANDS ? "stands"
         : a->verdict == KERN_FALLS  ? "falls"
         : a->verdict == KERN_LIMIT  ? "limit"
                                     : "undecided";
}

/* What is asked for, and neither found nor without limit: bits of the names
   below. */
/* clang-format off */
static const char *const open_name[] = {
    "level", "margin", "deficit", "bearing", "load_left", "load_right",
    "tilt_left", "tilt_right", "profile", "live", "certain", "raised", "bears",
    "least_friction", "sequence", "stays", "sweep", "raised_load_left",
    "raised_load_right", "raised_live", "live_least",
    "least_friction_let_go", "thrust_most", "tilt_let_go_left",
    "tilt_let_go_right"
};
/* clang-format on */
enum { OPENS_MOST = (int)(sizeof open_name / sizeof *open_name) };

/* Is --stays about block i? */
static inline int is_asked(const struct analysis *a, int i)
{
    return !a->task.s.block[i].fixed && i < stones(a)
        && (is_all(a->set->stays)
            || strcmp(a->text.name[i], a->set->stays) == 0);
}

/* Whether one number of a list that was asked for is undecided. */
static inline int is_open_list(const struct analysis *a, const double *list,
                               int stays)
{
    for (int i = 0; list && i < stones(a); i++)
        if (isnan(list[i])
            && (stays ? is_asked(a, i) : !a->task.s.block[i].fixed))
            return 1;
    return 0;
}

static inline int is_open_sweep(const struct analysis *a)
{
    for (int k = 0; k < a->sweeps; k++)
        if (isnan(a->swept[k].live) || a->swept[k].cut)
            return 1;
    return 0;
}

/* Returns 1 if this verdict is certain within the error that was told. */
static inline int is_sure(const struct analysis *a, kern_status verdict)
{
    return a->certain > 0 && a->verdict == verdict;
}

/* With given contacts, or shrunk ones, it is not asked. */
static inline int is_open_certain(const struct analysis *a)
{
    return pose_error(a) > 0 && !a->text.given && !(shrinkage(a) > 0)
        && a->certain < 0;
}

static inline int is_open_thrust(const struct analysis *a)
{
    return a->set->thrust && a->shown == KERN_STANDS && isnan(a->thrust_most);
}

static inline int is_open_live(const struct analysis *a)
{
    return a->lived < 0 || (a->lived == KERN_STANDS && isnan(a->live));
}

/* Does it stand with the live load as the file states it, at a factor of 1?
   KERN_UNDECIDED: that is not known. */
static inline kern_status as_stated(const struct analysis *a)
{
    if (a->lived == KERN_FALLS)
        return KERN_FALLS;
    if (a->lived != KERN_STANDS || isnan(a->live))
        return KERN_UNDECIDED;
    return a->live_least <= 1 + 1e-9 && a->live >= 1 - 1e-9 ? KERN_STANDS
                                                            : KERN_FALLS;
}

/* A number of stresses and forces has no unit but this one. */
static inline int is_per_density(const struct analysis *a)
{
    return a->drawing.made && a->drawing.s.all_assumed;
}

static inline unsigned open_questions(const struct analysis *a)
{
    int loaded = a->shown == KERN_STANDS && gravity_of(a) > 0;
    int open[OPENS_MOST] = {a->measured < 0 || a->m.level < 0,
                            a->measured < 0,
                            a->measured == KERN_FALLS && isnan(a->deficit),
                            a->measured == KERN_STANDS && isnan(a->bearing),
                            loaded && isnan(a->load[LEFT]),
                            loaded && isnan(a->load[RIGHT]),
                            loaded && isnan(a->tilt[LEFT]),
                            loaded && isnan(a->tilt[RIGHT]),
                            a->set->profile && a->profiled < 0,
                            is_open_live(a),
                            is_open_certain(a),
                            a->raised < 0,
                            a->borne < 0,
                            a->slid == KERN_LIMIT,
                            is_open_list(a, a->sequence, 0),
                            is_open_list(a, a->stays, 1),
                            is_open_sweep(a),
                            a->cut[LEFT],
                            a->cut[RIGHT],
                            a->cut[LIVE],
                            a->lived < 0,
                            a->slid_let_go == KERN_LIMIT,
                            is_open_thrust(a),
                            a->tilted_let_go[LEFT] == KERN_LIMIT,
                            a->tilted_let_go[RIGHT] == KERN_LIMIT};
    unsigned bits = 0;
    for (int k = 0; k < OPENS_MOST; k++)
        bits |= open[k] ? 1u << k : 0;
    return bits;
}

static inline int line_points(const struct analysis *a)
{
    int points = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        points += a->task.s.contact[k].line != 0;
    return points;
}

static const char *const meeting_word[] = {"rests", "hinges", "slides",
                                           "opens"};

/* A contact point that limits, each once, the strongest first; -1: no more. */
static inline int next_limit(const struct analysis *a, double *share)
{
    kern_real *limit = a->critical.limit;
    int best = 0;
    if (a->critical.contact < 0)
        return -1;
    for (int k = 1; k < a->task.s.contacts; k++)
        if (limit[k] > limit[best])
            best = k;
    *share = (double)limit[best];
    limit[best] = 0;
    return *share > 0.1 ? best : -1;
}

/* The moving blocks, in groups that move as one, the fastest first, and how blocks
   meet; for free_groups(). */
static inline kern_critical find_groups(const struct analysis *a)
{
    kern_proof proof = {NULL, shown_fall(a)};
    kern_critical moving = {array(a->task.s.contacts, sizeof(kern_meeting)),
                            NULL, array(a->task.s.blocks, sizeof(int)), -1, 0};
    if (proof.motion && moving.group)
        kern_critical_of(&a->task, 0, &proof, &moving);
    return moving;
}

static inline void free_groups(kern_critical *moving)
{
    free(moving->meeting);
    free(moving->group);
}

/* The forces, as the picture has them. */
static inline struct draw_scene scene_of(const struct analysis *a)
{
    struct draw_scene scene = {0};
    scene.s = &a->task.s;
    scene.relative = a->set->relative;
    scene.shrink = (double)shrinkage(a);
    scene.live = a->text.live;
    scene.unit = a->text.units;
    scene.force_unit = a->text.force_units;
    scene.mass = a->text.mass;
    scene.masses = a->text.masses;
    scene.pushes = a->text.props;
    scene.force = a->shown == KERN_STANDS ? a->force : NULL;
    scene.force_name = a->least ? "least forces" : NULL;
    scene.limiting = -1;
    return scene;
}

/* Of both sides together: larger is worse. */
static inline double expected_drop(const struct analysis *a)
{
    return (double)a->all[LOAD_LEFT].drop + (double)a->all[LOAD_RIGHT].drop;
}

static const char *const raising_word[] = {"not shown", "raised", "hangs"};

#endif /* PROGRAM_STATE_H */
