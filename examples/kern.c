/* kern - can a dry-stacked structure stand, and how far from falling is it?

   Reads structures in the text format of text.h, or drawings as dxf.h says, and
   reports on each: verdict,
   level and margin, what limits them, how it falls, the horizontal load and the
   tilt it bears; for a person, as JSON (one object a line), or as a picture.

       cc -O2 -o kern examples/kern.c -lm
       ./kern --svg wall.svg examples/structures/wall-60.kern
       ./kern --help

   SPDX-License-Identifier: MIT */

/* The same digits where products and sums are fused: see >>determinism. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__FMA__)
#pragma GCC optimize("no-tree-vectorize")
#endif

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "parts/args.h"
#include "parts/draw.h"
#include "parts/dxf.h"
#include "parts/json.h"
#include "parts/room.h"
#include "parts/stays.h"
#include "parts/text.h"

#include <errno.h>
#include <limits.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

static const char help[] =
"usage: kern [options] FILE...\n"
"For each structure: does it stand, and with what margin? FILE - is stdin.\n"
"\n"
"      --verdict    the verdict alone, at once even for thousands of blocks\n"
"  -e, --epsilon E  step of the level, a length (-r: share of each contact);\n"
"                   default: the file's, else 2 % of the mean block (-r: 5 %)\n"
"  -r, --relative   shrink every contact by a share of itself, not a length\n"
"      --mu MU      tan(friction angle) of contacts without a value of their own\n"
"                   (overrides the file's)\n"
"      --gap G      widest gap that is still a contact, a length\n"
"      --at D       verdict, forces, mechanism, loads and tilts with contacts\n"
"                   shrunk by D; level, margin and profile count from 0\n"
"      --forces     list the contacts and the least forces that hold it (any,\n"
"                   where these are not found)\n"
"      --mechanism  list how every block moves as it falls; where it stands,\n"
"                   just past the margin\n"
"      --mechanism live   just past the factor of the live load\n"
"      --profile    how far each block is from falling in a progressive\n"
"                   collapse: contacts shrink, or a horizontal load grows;\n"
"                   collapsed blocks are removed and the analysis goes on\n"
"      --near       all numbers also count near contacts (gaps up to 4 % of the\n"
"                   mean block, angles up to 0.15 rad): best predictor of\n"
"                   shaking; the verdict still comes from real contacts\n"
"      --lone       the one contact point of two blocks shrinks as well, toward\n"
"                   the middle of what carries the block: a stone on a tip\n"
"                   then has a margin (of contacts that are found)\n"
"      --raised     does the load raise the forces that hold it, or do blocks\n"
"                   hang; the load factors of Coulomb friction, from rest; and\n"
"                   the reserve, the share of g that may push to\n"
"                   either side: 0.0055 is enough for a stone that is let go\n"
"      --error E[,THETA]  how many times the robot's error the structure bears:\n"
"                   +-E in place (a length), +-THETA in angle (rad); and the\n"
"                   least friction at which it stands\n"
"      --sequence   the margin after each block in the order of the file\n"
"      --stays NAME the chance that the block NAME, laid last, stays where it is\n"
"                   let go; all: that of every block in the order of the file\n"
"      --measured E[,THETA]  poses were measured with the standard error E, a\n"
"                   length, and THETA in angle (rad; default E over the mean\n"
"                   block): gaps and overlaps of some errors are contacts;\n"
"                   between what the margin lies, and whether the verdict is\n"
"                   certain\n"
"      --overlap D  deepest overlap that is accepted as a contact, a length\n"
"      --limit N    most work of each query, in units of some 0.3 us, default\n"
"                   10 million; what takes more is undecided, and reported as\n"
"                   far as proven; 0: no limit\n"
"      --json       one JSON object a file, one line each\n"
"      --svg OUT.svg  draw it, with --profile coloured by the margins of the\n"
"                   blocks; of several files each NAME.* in OUT-NAME.svg\n"
"  -h, --help, --version\n";

static const char help_format[] =
"\n"
"FILE.dxf: closed polylines are blocks; on the layer ground or fixed, else the\n"
"lowest, they do not move; metres by $INSUNITS.\n"
"Other files: one statement a line; # begins a comment. Units are yours (SI: m, kg, N).\n"
"  fixed    NAME  X1 Y1  X2 Y2  X3 Y3 ...        ground, any simple polygon\n"
"  block    NAME  MASS  X1 Y1  X2 Y2  X3 Y3 ...  MASS *: area x density\n"
"  friction MU         tan(friction angle); 0.4  gravity GX GY   default 0 -9.81\n"
"  density  D          of later blocks, 1        epsilon E       as above\n"
"  tolerance GAP [ANGLE]  widest gap and angle (rad) of a contact; 1e-3 of the\n"
"                      smaller block, 0.0175\n"
"  com NAME X Y        centre of mass, where it is not the centroid\n"
"  load NAME FX FY X Y   a force at a point      torque NAME T   counter-clockwise\n"
"  live NAME FX FY X Y   a force of the live load, whose factor is asked for\n"
"  mass NAME M X Y     weight that is no stone (fill, snow), added to mass and\n"
"                      centre of the block: gravity, tilt and load factor act on\n"
"                      it. Loads stay as they are in all of these\n"
"  contact A B  NX NY  X1 Y1 [X2 Y2] [mu MU]  a contact that is given, normal from\n"
"                      A into B; then none are searched for\n"
"\n"
"JSON: status (stands, falls, undecided, limit, error); blocks, fixed,\n"
"contact_points, line_contacts, point_contacts: counts; near, relative; level;\n"
"epsilon, margin, holds, fails (proven bracket of the margin), deficit,\n"
"signed_margin: lengths (-r: shares); load_left, load_right: horizontal load\n"
"factor, in g; tilt_left, tilt_right: rad; loads_stay: true where the file has\n"
"loads, which none of these scales; live: factor of the live load; saturated: stands with every contact a\n"
"point; limited_by: contacts of a and b at x, y that limit the margin, strongest\n"
"first: share of the strongest, and does (rests, hinges, slides, opens);\n"
"(corner_x, corner_y: the same point before contacts shrink);\n"
"would_fall: groups of blocks that move as one where it falls, fastest first, of\n"
"all mechanisms;\n"
"bearing: length of the shortest contact that it needs; peak_stress: the largest\n"
"of a line contact, its force at the margin over twice the margin (or length);\n"
"certain (--measured): the verdict holds within the stated error;\n"
"margin_low, margin_high (--measured): between these the margin lies;\n"
"undecided: names of the keys that are null for that; proof_error: of the worst\n"
"proof, as a share of what is allowed; pivots, solves: work. --profile:\n"
"progressive_* and weak_*: mean and mean of the weakest half of the blocks'\n"
"margins (lengths) and load factors (g); expected_drop: under shaking, in mean\n"
"blocks, larger is worse; profile: of each block margin, load_left, load_right,\n"
"and load, their mean. --forces: contacts with x, y, normal nx, ny from a into b,\n"
"mu, travel (half the length), forces normal, tangential; resultants: force fx,\n"
"fy on b at x, y, of each two blocks, stress (as above); thrust: of blocks which\n"
"two others press, from resultant x1, y1 to x2, y2. --mechanism: motion with\n"
"velocities vx, vy of the centre and spin, the angular velocity (rad,\n"
"counter-clockwise); the fastest is 1.\n"
"--raised: raised (raised, hangs, not shown), reserve (g); raised_load_left,\n"
"raised_load_right, raised_live: as load_left, load_right, live, by equilibrium\n"
"that the load raises from rest, null where none is shown. --stays: stays (chance\n"
"from 0 to 1, null where it falls; with all a list of block, stays).\n"
"--sequence: sequence\n"
"of block, margin; weakest_step: the first block with the least.\n"
"--error: bears (margin / 2E, with cones that narrow by tan THETA / 2E),\n"
"least_friction (of contacts without a value of their own).\n"
"Numbers that do not exist or have no bound are null.\n"
"\n"
"Stands means: admissible forces exist, without tension and within friction.\n"
"Exit status: 0 all stand, 1 some fall, 2 bad use or input, 3 undecided.\n";

enum { EXIT_STANDS, EXIT_FALLS, EXIT_BAD, EXIT_UNDECIDED };

enum { LEFT, RIGHT, LIVE };
enum { MARGIN, LOAD_LEFT, LOAD_RIGHT, PROFILES };

/* Beyond that an int may not hold the length of the work arrays. */
enum { MOST_CONTACTS = 10000000 };

struct settings {           /* of the command line; numbers < 0: not given */
    kern_real epsilon, mu, gap, at, limit, overlap;
    kern_real error, turn;  /* of --measured                               */
    kern_real own_error, own_turn; /* of --error                          */
    int relative, forces, mechanism, profile, touching, json, verdict_only;
    int raised, sequence, mechanism_live, lone;
    const char *svg, *stays;
    char **file;
    int files;
};

/* All there is to say about one file. Numbers that do not exist are NAN. */
struct analysis {
    const struct settings *set;
    const char *file;
    int number;             /* of the file among all             */
    struct text_file text;
    int line;               /* of the error, 0: the whole file   */
    char error[600];        /* "" where there is none            */

    kern_task task;
    kern_contact *contact;  /* task.s.contact                    */
    kern_work work;

    kern_status verdict;    /* of real contacts, at the shrinkage asked for */
    int certain;            /* 1 or 0; -1: --measured tells nothing  */
    kern_interval interval; /* of the margin, where it tells         */
    kern_status shown;      /* of the contacts that are shown: with --near
                               near ones too                     */
    kern_force *force;      /* there, if it stands               */
    int least;              /* they are the least forces         */
    kern_motion *motion;    /* there, if it falls                */
    kern_motion *fall;      /* the same with all other mechanisms: falls.h */

    kern_status measured;   /* from shrinkage 0                  */
    kern_margin m;
    kern_force *last_force; /* at m.holds, if it stands at 0     */
    kern_motion *collapse;  /* just past the margin, or at 0; with
                               --mechanism live past its factor  */
    kern_critical critical; /* what limits the margin            */
    double deficit, bearing, load[2], tilt[2], live;
    double raised_load[3];  /* left, right, live; NAN: none is shown */
    double *stress;         /* of a line contact at the margin; 0: none   */

    kern_status raised;     /* real contacts, if asked for       */
    kern_raising raising;
    double reserve;
    double bears, least_friction;
    double *sequence;       /* the margin after each block       */
    double *stays;          /* of a block: its chance, or NAN    */

    kern_status profiled;   /* both profiles, if asked for       */
    kern_real *fate[3];     /* of each block: its margin, and its load
                               factors to the left and the right */
    kern_collapse all[3];   /* their means                       */
};

static int fail(struct analysis *a, int line, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(a->error, sizeof a->error, format, list);
    va_end(list);
    a->line = line;
    return -1;
}

static double mean_size(const struct analysis *a)
{ return (double)kern_mean_size(a->task.s.block, a->task.s.blocks); }

static int fail_memory(struct analysis *a)
{
    return fail(a, 0, "not enough memory for %d blocks and %d contact points",
                a->task.s.blocks, a->task.s.contacts);
}

/* Does the collapse motion belong to the verdict, or to the margin? */
static kern_motion *shown_motion(const struct analysis *a)
{
    if (a->shown == KERN_FALLS) return a->motion;
    if (a->set->mechanism_live && a->text.lives > 0)
        return isfinite(a->live) ? a->collapse : NULL;
    if (a->measured == KERN_STANDS && !a->m.saturated) return a->collapse;
    return NULL;
}

/* What pictures and lists of blocks show: of what falls, every mechanism. */
static kern_motion *shown_fall(const struct analysis *a)
{
    return a->shown == KERN_FALLS ? a->fall : shown_motion(a);
}

static kern_real shrinkage(const struct analysis *a)
{
    return a->set->at < 0 ? 0 : a->set->at;
}

static double gravity_of(const struct analysis *a)
{
    return hypot(a->task.s.gravity.x, a->task.s.gravity.y);
}

/* ---- Analysis ------------------------------------------------------------ */

/* All pairs that overlap, as far as the message has room, and the remedy. */
static int fail_overlaps(struct analysis *a, int block)
{
    const struct text_file *t = &a->text;
    int ints = 2 * t->blocks, *index = malloc((size_t)ints * sizeof *index);
    kern_work work = kern_work_of(NULL, 0, index, ints);
    kern_overlap pair[8];
    char list[400] = "", one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    size_t used = 0;
    int pairs = kern_overlaps(t->block, t->blocks, &a->task.options, pair, 8,
                              &work);
    int shown = 0;
    free(index);
    while (shown < pairs && shown < 8 && used < sizeof list / 2) {
        const kern_overlap *p = &pair[shown++];
        used += (size_t)snprintf(
            list + used, sizeof list - used, "%s'%s' and '%s' overlap, %.3g "
            "deep, %.3g is allowed", used ? "; " : "",
            text_show(one, t->name[p->a]), text_show(two, t->name[p->b]),
            (double)p->depth, (double)p->allowed);
    }
    if (pairs < 0) return fail(a, 0, "%s", kern_status_text((kern_status)pairs));
    if (shown < pairs)
        snprintf(two, sizeof two, "; %d pairs in all", pairs);
    return fail(a, t->block_line[block], "%s%s (--measured E, --overlap D)",
                list, shown < pairs ? two : "");
}

/* An error of the library, at the block it names. */
static int fail_blocks(struct analysis *a, kern_status status,
                       const kern_fault *fault)
{
    const struct text_file *t = &a->text;
    char one[TEXT_SHOW_ROOM];
    int i = fault->block, j = fault->other;
    if (i < 0 || i >= t->blocks)
        return fail(a, 0, "%s", kern_status_text(status));
    if (j < 0 || j >= t->blocks)
        return fail(a, t->block_line[i], "block '%s': %s",
                    text_show(one, t->name[i]), kern_status_text(status));
    return fail_overlaps(a, i > j ? i : j);
}

/* The contacts of the file, or all that are found between its polygons. */
static int find_contacts(struct analysis *a)
{
    struct text_file *t = &a->text;
    if (t->given) {
        a->contact = t->contact;
        a->task.s.contacts = t->contacts;
        for (int k = 0; k < t->contacts; k++)
            if (!t->own_mu[k]) t->contact[k].mu = a->task.options.mu;
        return 0;
    }
    int found = KERN_NO_SPACE, ints = 2 * t->blocks;
    int *index = malloc((size_t)ints * sizeof *index + 1);
    kern_work work = kern_work_of(NULL, 0, index, ints);
    for (int room = 16 * t->blocks + 64;
         index && found == KERN_NO_SPACE && room < INT_MAX / 4; room *= 2) {
        kern_contact *more = realloc(a->contact, (size_t)room * sizeof *more);
        if (!more) break;
        a->contact = more;
        found = kern_contacts(t->block, t->blocks, &a->task.options, a->contact,
                              room, &work);
    }
    free(index);
    if (found == KERN_NO_SPACE)
        return fail(a, 0, "not enough memory for the contacts of %d blocks",
                    t->blocks);
    if (found < 0) return fail_blocks(a, (kern_status)found, &work.fault);
    a->task.s.contacts = found;
    return 0;
}

/* What a large structure is busy with, under its verdict on a terminal. */
static void show_stage(const struct analysis *a, const char *what)
{
    if (a->task.s.blocks < 200 || !ARGS_TERMINAL(2)) return;
    fprintf(stderr, "\r%-20s%s", what, *what ? "" : "\r");
    fflush(stderr);
}

/* Length 0 is asked for as 1, so that NULL always means failure. */
static void *array(int count, size_t size)
{
    return calloc(count > 0 ? (size_t)count : 1, size);
}

static int take_memory(struct analysis *a)
{
    int blocks = a->task.s.blocks, contacts = a->task.s.contacts;
    if (contacts > MOST_CONTACTS) return fail_memory(a);
    a->work = room_work(blocks, contacts);
    a->force = array(contacts, sizeof *a->force);
    a->last_force = array(contacts, sizeof *a->last_force);
    a->critical.limit = array(contacts, sizeof *a->critical.limit);
    a->critical.meeting = array(contacts, sizeof *a->critical.meeting);
    a->motion = array(blocks, sizeof *a->motion);
    a->fall = array(blocks, sizeof *a->fall);
    a->collapse = array(blocks, sizeof *a->collapse);
    int bad = 0;
    for (int k = 0; k < PROFILES; k++) {
        a->fate[k] = array(blocks, sizeof *a->fate[k]);
        bad |= !a->fate[k];
    }
    bad |= !a->critical.limit || !a->critical.meeting;
    return a->work.real && a->work.index && a->force && a->last_force &&
           a->motion && a->fall && a->collapse && !bad ? 0 : fail_memory(a);
}

static void free_work(struct analysis *a)
{
    room_free_work(&a->work);
    free(a->force);
    free(a->last_force);
    free(a->critical.limit);
    free(a->critical.meeting);
    free(a->motion);
    free(a->fall);
    free(a->collapse);
    for (int k = 0; k < PROFILES; k++) free(a->fate[k]);
}

static void free_analysis(struct analysis *a)
{
    if (a->contact != a->text.contact) free(a->contact);
    free(a->sequence);
    free(a->stays);
    free(a->stress);
    free_work(a);
    text_free(&a->text);
}

/* What limits the margin; nothing does where it is not known or saturated. */
static void find_limit(struct analysis *a)
{
    int falls = a->measured == KERN_FALLS;
    kern_proof proof = { falls ? NULL : a->last_force, a->collapse };
    a->critical.contact = -1;
    if (a->measured < 0 || (!falls && a->m.saturated)) return;
    kern_critical_of(&a->task, a->m.margin, &proof, &a->critical);
}

/* At the margin a force acts no nearer to the end of a line contact than that:
   it can spread over twice the margin, or over all of a shorter contact. */
static void find_stress(struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    kern_force *least = array(s->contacts, sizeof *least), *force = least;
    a->stress = array(s->contacts, sizeof *a->stress);
    if (a->measured == KERN_STANDS && force && a->stress) {
        if (kern_forces(&a->task, a->m.holds, least) != KERN_STANDS)
            force = a->last_force;
        for (int k = 0; k < s->contacts; k++) {
            if (!draw_is_line(s, k)) continue;
            kern_vec p = s->contact[k].p;
            kern_vec q = kern_contact_at(&s->contact[k], a->m.margin,
                                         a->set->relative);
            double pressed = (double)force[k].normal + force[k + 1].normal;
            if (pressed > 0)
                a->stress[k] = pressed / (2 * hypot(q.x - p.x, q.y - p.y));
            k++;
        }
    }
    free(least);
}

/* The contact of the largest stress among n from k on; -1: there is none. */
static int most_stressed(const struct analysis *a, int k, int n)
{
    int most = -1;
    for (int i = k; a->stress && i < k + n; i++)
        if (a->stress[i] > (most < 0 ? 0 : a->stress[most] * (1 + 1e-9)))
            most = i;
    return most;
}

static double value_or_nan(kern_status status, kern_real value)
{
    return status == KERN_STANDS ? (double)value : (double)NAN;
}

/* By what factor the live load may grow, and how it falls just beyond. */
static void find_live(struct analysis *a)
{
    const kern_proof proof = { NULL, a->set->mechanism_live ? a->collapse : NULL };
    kern_real value = 0;
    kern_status status;
    a->live = (double)NAN;
    if (a->shown != KERN_STANDS || a->text.lives == 0) return;
    status = kern_load_factor_of(&a->task, shrinkage(a), a->text.live, &value,
                                 &proof);
    a->live = value_or_nan(status, value);
}

/* The same for Coulomb friction, from rest. */
static void find_raised_loads(struct analysis *a)
{
    static const kern_side side[3] = { KERN_LEFT, KERN_RIGHT, KERN_SHRINK };
    for (int k = 0; k < 3; k++) {
        const kern_wrench *pattern = k == LIVE ? a->text.live : NULL;
        kern_real value = 0;
        a->raised_load[k] = (double)NAN;
        kern_status status;
        if (a->raising != KERN_RAISED || a->raised != KERN_STANDS ||
            !(pattern ? a->text.lives > 0 : gravity_of(a) > 0))
            continue;
        status = kern_raised_load(&a->task, shrinkage(a), side[k], pattern,
                                  &value, NULL);
        a->raised_load[k] = value_or_nan(status, value);
    }
}

/* Load factors and tilts; without gravity there are neither. */
static void find_loads(struct analysis *a)
{
    for (int side = LEFT; side <= RIGHT; side++) {
        a->load[side] = a->tilt[side] = (double)NAN;
        if (a->shown != KERN_STANDS || !(gravity_of(a) > 0)) continue;
        kern_real value = 0;
        kern_side sign = side == LEFT ? KERN_LEFT : KERN_RIGHT;
        kern_status status;
        status = kern_load_factor(&a->task, shrinkage(a), sign, &value, NULL);
        a->load[side] = value_or_nan(status, value);
        status = kern_tilt(&a->task, shrinkage(a), sign, &value, NULL);
        a->tilt[side] = value_or_nan(status, value);
    }
}

/* Margins first, then loads; without gravity there are none of those. */
static void find_profile(struct analysis *a)
{
    static const kern_side side[PROFILES] = {
        KERN_SHRINK, KERN_LEFT, KERN_RIGHT
    };
    int falls = gravity_of(a) > 0;
    a->profiled = KERN_OK;
    for (int k = 0; k < (falls ? PROFILES : 1); k++) {
        kern_status status;
        status = kern_profile(&a->task, side[k], a->fate[k], &a->all[k]);
        if (status < 0) a->profiled = status;
    }
    for (int k = falls ? PROFILES : 1; k < PROFILES; k++) {
        for (int i = 0; i < a->task.s.blocks; i++)
            a->fate[k][i] = (kern_real)NAN;
        a->all[k].least = a->all[k].mean = a->all[k].weak =
            a->all[k].drop = (kern_real)NAN;
    }
}

/* The load factor of block i: the mean of both sides. */
static double fate_load(const struct analysis *a, int i)
{
    return ((double)a->fate[LOAD_LEFT][i] + (double)a->fate[LOAD_RIGHT][i]) / 2;
}

static double mean_load(const struct analysis *a)
{
    return ((double)a->all[LOAD_LEFT].mean + (double)a->all[LOAD_RIGHT].mean)
           / 2;
}

static double weak_load(const struct analysis *a)
{
    return ((double)a->all[LOAD_LEFT].weak + (double)a->all[LOAD_RIGHT].weak)
           / 2;
}

static int is_open(kern_status status)
{
    return status == KERN_UNDECIDED || status == KERN_LIMIT;
}

/* The contacts with these options, and the verdict with them. */
static int decide(struct analysis *a, const kern_options *options)
{
    kern_proof proof = { NULL, NULL };
    a->task.options = *options;
    if (find_contacts(a)) return -1;
    a->task.s.contact = a->contact;
    free_work(a);
    if (take_memory(a)) return -1;
    proof.force = a->force;
    proof.motion = a->motion;
    /* The least forces prove it as well, and of thousands of blocks sooner. */
    a->shown = kern_forces(&a->task, shrinkage(a), a->force);
    a->least = a->shown == KERN_STANDS;
    if (!a->least)
        a->shown = kern_verdict(&a->task, shrinkage(a), &proof);
    if (a->shown == KERN_FALLS) {
        memcpy(a->fall, a->motion, sizeof *a->fall * (size_t)a->task.s.blocks);
        room_falls(&a->task, shrinkage(a), a->fall);
    }
    return a->shown < 0 && !is_open(a->shown)
         ? fail_blocks(a, a->shown, &a->work.fault) : 0;
}

/* Whether the load raises the forces, and how far gravity may push sideways. */
static int find_raised(struct analysis *a)
{
    kern_real reserve = 0;
    int pushed = gravity_of(a) > 0;
    a->raised = kern_raised(&a->task, shrinkage(a), &a->raising,
                            pushed ? &reserve : NULL, NULL);
    a->reserve = value_or_nan(pushed ? a->raised : KERN_UNDECIDED, reserve);
    return a->raised < 0 && !is_open(a->raised)
         ? fail_blocks(a, a->raised, &a->work.fault) : 0;
}

/* The structure as it grows in the order of the file, all fixed blocks there
   from the start. */
struct grown {
    kern_task task;
    struct falls_part part;
    kern_real *value;       /* room for a number a block                     */
};

static int open_grown(const struct analysis *a, struct grown *g)
{
    const size_t blocks = (size_t)a->task.s.blocks;
    g->task = a->task;
    g->part.contact = array(a->task.s.contacts, sizeof *g->part.contact);
    g->part.block = malloc(sizeof *g->part.block * blocks);
    g->part.place = malloc(sizeof *g->part.place * blocks);
    g->value = malloc(sizeof *g->value * blocks);
    return g->part.contact && g->part.block && g->part.place && g->value;
}

static void close_grown(struct grown *g)
{
    free(g->part.contact);
    free(g->part.block);
    free(g->part.place);
    free(g->value);
}

/* All blocks up to `last`, with the contacts between them. */
static void grow_to(const struct analysis *a, struct grown *g, int last)
{
    const kern_structure *s = &a->task.s;
    for (int i = 0; i < s->blocks; i++)
        g->part.place[i] = s->block[i].fixed || i <= last ? 0 : -1;
    falls_take(s, &g->part, &g->task.s);
}

/* The margin after each block, 0 where it falls, NAN where that is undecided. */
static int find_sequence(struct analysis *a)
{
    struct grown g = { 0 };
    int last, there = open_grown(a, &g);
    const int blocks = a->task.s.blocks;
    a->sequence = malloc(sizeof *a->sequence * (size_t)blocks);
    for (last = 0; last < blocks && there && a->sequence; last++) {
        kern_margin m;
        kern_status status;
        a->sequence[last] = (double)NAN;
        if (a->task.s.block[last].fixed) continue;
        grow_to(a, &g, last);
        status = kern_measure(&g.task, &m, NULL);
        if (status == KERN_STANDS) a->sequence[last] = (double)m.margin;
        if (status == KERN_FALLS) a->sequence[last] = 0;
    }
    close_grown(&g);
    return last < blocks ? fail_memory(a) : 0;
}

static int is_all(const char *word) { return strcmp(word, "all") == 0; }

/* The chance of the block of --stays, laid last, or of each in the order of the
   file, that it stays; NAN where the structure falls. */
static int find_stays(struct analysis *a)
{
    struct grown g = { 0 };
    const int all = is_all(a->set->stays), blocks = a->task.s.blocks;
    int there = open_grown(a, &g), found = all;
    a->stays = malloc(sizeof *a->stays * (size_t)blocks);
    for (int i = 0; i < blocks && there && a->stays; i++) {
        a->stays[i] = (double)NAN;
        if (a->task.s.block[i].fixed ||
            (!all && strcmp(a->text.name[i], a->set->stays) != 0)) continue;
        found = 1;
        grow_to(a, &g, all ? i : blocks);
        stays_of(&g.task, g.part.place[i], g.value, &a->stays[i]);
    }
    close_grown(&g);
    if (!there || !a->stays) return fail_memory(a);
    return found ? 0 : fail(a, 0, "--stays: there is no free block '%s'",
                            a->set->stays);
}

/* The first block with the least margin in the sequence; -1: none is known. */
static int weakest_step(const struct analysis *a)
{
    int weakest = -1;
    for (int i = 0; i < a->task.s.blocks; i++)
        if (a->sequence[i] >= 0 && (weakest < 0 || a->sequence[i] <
                                    a->sequence[weakest]))
            weakest = i;
    return weakest;
}

/* Between what the margin of measured blocks lies, and whether the verdict holds
   within their error; contacts that are given have none. Twice the error allowed
   finds more contacts, for which there is work memory of its own. */
static int find_certain(struct analysis *a)
{
    int room = 2 * a->task.s.contacts + KERN_CONTACTS(a->text.blocks);
    const int most = 64 * room;
    kern_status got = KERN_NO_SPACE;
    kern_margin m;
    if (!(a->set->error > 0) || a->text.given || is_open(a->shown) ||
        shrinkage(a) > 0 || kern_measure(&a->task, &m, NULL) < 0)
        return 0;
    for (; got == KERN_NO_SPACE && room <= most; room *= 2) {
        kern_contact *out = malloc((size_t)room * sizeof *out);
        kern_work work = room_work(a->text.blocks, room);
        kern_task task = a->task;
        const int there = out && work.real && work.index;
        task.work = &work;
        if (there)
            got = kern_certain(&task, m.margin, &a->interval, out, room);
        free(out);
        room_free_work(&work);
        if (!there) return fail_memory(a);
    }
    if (got >= 0) a->certain = got > 0;
    return 0;
}

/* How many times the error of --error the structure bears, and the least
   friction at which it stands: where cones narrow so fast that kerns hardly
   shrink. 0 for what falls. */
static void find_error(struct analysis *a)
{
    const struct settings *set = a->set;
    const kern_options options = a->task.options;
    const kern_real size = (kern_real)mean_size(a);
    const kern_real fast = 1000 / (set->relative ? 1 : size);
    kern_margin m;
    kern_status status;
    double slope, mu = (double)options.mu;
    a->bears = a->least_friction = (double)NAN;
    a->task.options.narrow = (kern_real)tan((double)set->own_turn) /
                             (2 * set->own_error);
    status = kern_measure(&a->task, &m, NULL);
    if (status == KERN_STANDS)
        a->bears = (double)(m.margin / (2 * set->own_error));
    if (status == KERN_FALLS) a->bears = 0;
    a->task.options.narrow = fast;
    status = kern_measure(&a->task, &m, NULL);
    a->task.options = options;
    slope = (double)(fast * m.margin);
    if (status == KERN_STANDS)
        a->least_friction = fmax(mu - slope, 0) / (1 + mu * slope);
}

/* The deficit of what falls, the bearing length of what stands. */
static void find_lengths(struct analysis *a)
{
    kern_real length = 0;
    a->deficit = a->bearing = (double)NAN;
    if (a->measured == KERN_FALLS) {
        kern_status status = kern_deficit(&a->task, &length);
        a->deficit = status < 0 ? (double)NAN : (double)length;
    } else if (a->measured == KERN_STANDS) {
        kern_status status = kern_bearing(&a->task, &length, NULL);
        a->bearing = value_or_nan(status, length);
    }
}

/* What options ask for, of the real contacts. */
static int find_what_is_asked(struct analysis *a)
{
    if (a->set->raised && find_raised(a)) return -1;
    if (a->set->raised) find_raised_loads(a);
    if (a->set->own_error > 0) find_error(a);
    if (a->set->sequence && find_sequence(a)) return -1;
    return a->set->stays ? find_stays(a) : 0;
}

/* What follows the verdict. */
static int measure(struct analysis *a)
{
    kern_proof limit = { a->last_force, a->collapse };
    const kern_options near_too = kern_near(&a->task.options,
                                            (kern_real)mean_size(a));
    if (find_what_is_asked(a)) return -1;
    if (a->set->touching && !a->text.given && decide(a, &near_too)) return -1;
    limit.force = a->last_force;
    limit.motion = a->collapse;
    show_stage(a, "  margin ...");
    a->measured = kern_measure(&a->task, &a->m, &limit);
    if (a->measured == KERN_BAD_STEP)
        return fail(a, a->set->epsilon < 0 ? a->text.epsilon_line : 0,
                    "%s, the step is %.9g (--epsilon)", kern_status_text(a->measured),
                    (double)a->task.options.epsilon);
    if (a->measured < 0 && !is_open(a->measured))
        return fail_blocks(a, a->measured, &a->work.fault);
    find_lengths(a);
    find_limit(a);
    find_stress(a);
    show_stage(a, "  load factors ...");
    find_loads(a);
    find_live(a);
    show_stage(a, "  profile ...");
    if (a->set->profile) find_profile(a);
    return 0;
}

/* Reads the file and finds the verdict. */
static int analyse(struct analysis *a)
{
    const struct settings *set = a->set;
    kern_options options;
    if (dxf_named(a->file) ? dxf_load(&a->text, a->file)
                           : text_load(&a->text, a->file))
        return fail(a, a->text.line, "%s", a->text.message);
    if (a->text.blocks > KERN_BLOCKS_MOST)
        return fail(a, 0, "%d blocks, at most %d are analysed", a->text.blocks,
                    KERN_BLOCKS_MOST);
    a->task = kern_task_of(a->text.block, a->text.blocks, NULL, 0, &a->work);
    a->task.s.gravity = a->text.gravity;
    options = a->text.options;
    options.relative = set->relative;
    if (set->lone) options.lone = a->text.gravity;
    if (set->epsilon > 0) options.epsilon = set->epsilon;
    if (set->gap > 0) options.gap = set->gap;
    if (!(set->mu < 0)) options.mu = set->mu;
    if (!(set->limit < 0)) options.limit = (int)set->limit;
    if (set->error > 0)
        options = kern_measured_options(&options, set->error, set->turn < 0
            ? set->error / (kern_real)mean_size(a) : set->turn);
    if (set->overlap > options.overlap) options.overlap = set->overlap;
    if (decide(a, &options)) return -1;
    a->verdict = a->shown;
    return find_certain(a);
}

static const char *status_word(const struct analysis *a)
{
    if (a->error[0]) return "error";
    return a->verdict == KERN_STANDS ? "stands"
         : a->verdict == KERN_FALLS ? "falls"
         : a->verdict == KERN_LIMIT ? "limit" : "undecided";
}

/* What is asked for, and neither found nor without limit: bits of the names
   below. */
static const char *const open_name[] = {
    "level", "margin", "deficit", "bearing", "load_left", "load_right", "tilt_left",
    "tilt_right", "profile", "live"
};
enum { OPENS_MOST = (int)(sizeof open_name / sizeof *open_name) };

static unsigned open_questions(const struct analysis *a)
{
    int loaded = a->shown == KERN_STANDS && gravity_of(a) > 0;
    int open[OPENS_MOST] = {
        a->measured < 0 || a->m.level < 0, a->measured < 0,
        a->measured == KERN_FALLS && isnan(a->deficit),
        a->measured == KERN_STANDS && isnan(a->bearing),
        loaded && isnan(a->load[LEFT]), loaded && isnan(a->load[RIGHT]),
        loaded && isnan(a->tilt[LEFT]), loaded && isnan(a->tilt[RIGHT]),
        a->set->profile && a->profiled < 0,
        a->shown == KERN_STANDS && a->text.lives > 0 && isnan(a->live)
    };
    unsigned bits = 0;
    for (int k = 0; k < OPENS_MOST; k++) bits |= open[k] ? 1u << k : 0;
    return bits;
}

static int line_points(const struct analysis *a)
{
    int points = 0;
    for (int k = 0; k < a->task.s.contacts; k++)
        points += a->task.s.contact[k].line != 0;
    return points;
}

/* ---- Report for a person ------------------------------------------------- */

static const char *name_of(const struct analysis *a, int block, char *shown)
{
    return text_show(shown, a->text.name[block]);
}

static const char *plural(int count) { return count == 1 ? "" : "s"; }

/* A coordinate without what the width of a bracket left where it should be 0. */
static double tidy(const struct analysis *a, double x)
{
    return fabs(x) < 2e-6 * mean_size(a) ? 0 : x;
}

/* A rate that is printed with five decimals, without the sign of a zero. */
static double rate(double x) { return fabs(x) < 5e-6 ? 0 : x; }

static void report_structure(const struct analysis *a)
{
    int blocks = a->task.s.blocks - a->text.fixed, ends = line_points(a);
    int lines = ends / 2, points = a->task.s.contacts - ends;
    printf("  structure   %d block%s on %d fixed; ", blocks, plural(blocks),
           a->text.fixed);
    printf("%d line contact%s and %d point%s%s\n", lines, plural(lines), points,
           plural(points), a->text.given ? ", given by the file" : "");
}

static void report_level(const struct analysis *a)
{
    const char *unit = a->set->relative ? " of each contact" : "";
    if (a->measured < 0 || a->m.level < 0) {
        printf("  level       undecided\n");
        return;
    }
    printf("  level       %-8d", a->m.level);
    if (a->measured == KERN_FALLS && a->shown == KERN_STANDS &&
        !(shrinkage(a) > 0))
        printf("  critical: it stands and it falls, as exactly as proofs are\n");
    else if (a->measured == KERN_FALLS)
        printf("  falls as it is\n");
    else if (a->m.saturated)
        printf("  stands even with every kern closed (steps of %.4g%s), so\n"
               "                        level and margin do not compare\n",
               (double)a->m.epsilon, unit);
    else
        printf("  falls after %d step%s of %.4g%s\n", a->m.level,
               plural(a->m.level), (double)a->m.epsilon, unit);
}

static void report_margin(const struct analysis *a)
{
    int falls = a->measured == KERN_FALLS;
    double value = falls ? a->deficit : (double)a->m.margin;
    printf("  %-10s  ", falls ? "deficit" : "margin");
    if (a->measured == KERN_LIMIT) {
        printf("undecided by the limit of work (--limit 0 goes on): ");
        if (a->m.holds < 0) printf("not known to stand, ");
        else printf("stands at %.4g, ", (double)a->m.holds);
        printf("%s %.4g\n", a->m.fails < a->m.most ? "falls at" : "at most",
               (double)a->m.fails);
        return;
    }
    if (a->measured < 0 || isnan(value)) {
        printf("undecided\n");
        return;
    }
    if (isinf(value)) {
        printf("none      longer contacts would not help\n");
        return;
    }
    if (!falls && !(value > 1e-9 * mean_size(a))) {
        printf("0         critical: it stands, but with any smaller contact it "
               "falls\n");
        return;
    }
    printf("%-8.4g  %s each contact %s at both ends", value,
           a->set->relative ? "by which share of its half" : "how far",
           falls ? "must grow" : "can shrink");
    if (!a->set->relative)
        printf(", %.3g %% of the mean block size",
               100 * value / mean_size(a));
    printf("\n");
}

static void report_bearing(const struct analysis *a)
{
    if (a->measured != KERN_STANDS) return;
    printf("  bearing     ");
    if (isnan(a->bearing)) printf("undecided\n");
    else if (isinf(a->bearing)) printf("none      it needs points alone\n");
    else printf("%-8.4g  length of the shortest contact that it needs, %.3g %% "
                "of the mean block size\n", a->bearing,
                100 * a->bearing / (double)kern_mean_size(a->task.s.block,
                                                          a->task.s.blocks));
}

static void report_stress(const struct analysis *a)
{
    int most = most_stressed(a, 0, a->task.s.contacts);
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    if (most < 0) return;
    const kern_contact *c = &a->task.s.contact[most];
    if (isinf(a->stress[most])) printf("  stress      any       ");
    else printf("  stress      %-8.4g  ", a->stress[most]);
    printf("mean stress if the most loaded contact, between %s and %s, were only "
           "twice the margin long\n", name_of(a, c->a, one), name_of(a, c->b, two));
}

static const char *const meeting_word[] = { "rests", "hinges", "slides",
                                            "opens" };

/* A contact point that limits, each once, the strongest first; -1: no more. */
static int next_limit(const struct analysis *a, double *share)
{
    kern_real *limit = a->critical.limit;
    int best = 0;
    if (a->critical.contact < 0) return -1;
    for (int k = 1; k < a->task.s.contacts; k++)
        if (limit[k] > limit[best]) best = k;
    *share = (double)limit[best];
    limit[best] = 0;
    return *share > 0.1 ? best : -1;
}

static void report_limit(const struct analysis *a)
{
    const char *head = a->measured == KERN_FALLS ? "gives way" : "limited by";
    double share;
    for (int shown = 0, k; shown < 4 && (k = next_limit(a, &share)) >= 0;
         shown++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, a->m.margin, a->set->relative);
        char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
        printf("  %-10s  %s and %s at (%.6g, %.6g), which %s", head,
               name_of(a, c->a, one), name_of(a, c->b, two), tidy(a, c->p.x),
               tidy(a, c->p.y), meeting_word[a->critical.meeting[k]]);
        if (a->m.margin > 0 && fabs((double)c->travel) > 0)
            printf(" (shrunk: at %.6g, %.6g)", tidy(a, p.x), tidy(a, p.y));
        printf("\n");
        head = "";
    }
}

/* How block i moves, seen with gravity pointing down. */
static void print_move(const struct analysis *a, const kern_motion *motion,
                       int i)
{
    kern_motion v = motion[i];
    const kern_block *b = &a->task.s.block[i];
    double g = gravity_of(a);
    double downx = g > 0 ? a->task.s.gravity.x / g : 0;
    double downy = g > 0 ? a->task.s.gravity.y / g : -1;
    double right = -v.vx * downy + v.vy * downx;
    double down = v.vx * downx + v.vy * downy;
    double size = sqrt(fabs((double)b->area)), speed = hypot(v.vx, v.vy);

    /* Beyond some ten sizes a centre of rotation says less than a direction. */
    if (fabs(v.spin) * size > 0.1 * speed)
        printf("tipping %s about (%.4g, %.4g)\n", v.spin < 0 ? "right" : "left",
               tidy(a, b->centre.x - v.vy / v.spin),
               tidy(a, b->centre.y + v.vx / v.spin));
    else if (fabs(down) > 2 * fabs(right))
        printf("%s\n", down > 0 ? "dropping" : "rising");
    else
        printf("sliding %s%s\n", right < 0 ? "left" : "right",
               down > 0.25 * fabs(right) ? " and down"
               : down < -0.25 * fabs(right) ? " and up" : "");
}

/* The moving blocks, in groups that move as one, the fastest first; `group` is
   the caller's to free. */
static kern_critical find_groups(const struct analysis *a)
{
    kern_proof proof = { NULL, shown_fall(a) };
    kern_critical moving = { NULL, NULL, array(a->task.s.blocks, sizeof(int)),
                             -1, 0 };
    if (proof.motion && moving.group)
        kern_critical_of(&a->task, 0, &proof, &moving);
    return moving;
}

static void report_collapse(const struct analysis *a)
{
    enum { GROUPS = 5, NAMES = 6 };
    const char *head = a->shown == KERN_FALLS ? "falls by" : "would fall";
    kern_critical moving = find_groups(a);
    char shown[TEXT_SHOW_ROOM];
    int rest = 0;
    for (int group = 0; group < moving.groups && group < GROUPS; group++) {
        int lead = -1, names = 0;
        printf("  %-10s  ", head);
        head = "";
        for (int i = 0; i < a->task.s.blocks; i++) {
            if (moving.group[i] != group) continue;
            if (lead < 0) lead = i;
            if (names++ < NAMES)
                printf("%s%s", names > 1 ? " " : "", name_of(a, i, shown));
        }
        if (names > NAMES) printf(" and %d more", names - NAMES);
        printf(" ");
        print_move(a, shown_fall(a), lead);
    }
    for (int i = 0; i < a->task.s.blocks && moving.groups > GROUPS; i++)
        rest += moving.group[i] >= GROUPS;
    if (rest > 0)
        printf("              and %d more block%s\n", rest, plural(rest));
    free(moving.group);
}

static const char *factor_text(double value, double scale, const char *unit,
                               char out[32])
{
    if (isnan(value)) return "undecided";
    if (isinf(value)) return "any";
    snprintf(out, 32, "%.4g%s", fabs(value) < 1e-9 ? 0 : scale * value, unit);
    return out;
}

static void report_loads(const struct analysis *a)
{
    static const double degrees = 57.295779513082321;
    const char *stay = a->text.loads > 0 ? " (loads stay as they are)" : "";
    char left[32], right[32];
    if (a->shown != KERN_STANDS) return;
    if (a->text.lives > 0)
        printf("  live        %s: factor of the live load\n",
               factor_text(a->live, 1, "", left));
    if (!(gravity_of(a) > 0)) return;
    printf("  load        %s left, %s right: horizontal load factor, in g%s\n",
           factor_text(a->load[LEFT], 1, "", left),
           factor_text(a->load[RIGHT], 1, "", right), stay);
    printf("  tilt        %s left, %s right, ",
           factor_text(a->tilt[LEFT], 1, "", left),
           factor_text(a->tilt[RIGHT], 1, "", right));
    printf("in rad: %s and %s%s\n",
           factor_text(a->tilt[LEFT], degrees, " deg", left),
           factor_text(a->tilt[RIGHT], degrees, " deg", right), stay);
}

static void report_forces(const struct analysis *a)
{
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    if (a->shown != KERN_STANDS) {
        printf("  forces      none that hold every block\n");
        return;
    }
    printf("  forces      %-10s %-10s %11s %11s %11s %11s %8s\n", "from", "on",
           "x", "y", "normal", "tangential", "of mu");
    for (int k = 0; k < a->task.s.contacts; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, shrinkage(a), a->set->relative);
        printf("              %-10s %-10s %11.5g %11.5g", name_of(a, c->a, one),
               name_of(a, c->b, two), tidy(a, p.x), tidy(a, p.y));
        double f = (double)a->force[k].normal;
        double r = (double)a->force[k].tangential;
        if (fabs(r) < 1e-9 * f) r = 0;
        if (f * c->mu > 0)
            printf(" %11.5g %11.5g %7.0f%%\n", f, r,
                   100 * fabs(r) / (f * c->mu));
        else
            printf(" %11.5g %11.5g %8s\n", f, r, "-");
    }
}

/* The forces, as the picture has them. */
static struct draw_scene scene_of(const struct analysis *a)
{
    struct draw_scene scene = { 0 };
    scene.s = &a->task.s;
    scene.relative = a->set->relative;
    scene.shrink = (double)shrinkage(a);
    scene.force = a->shown == KERN_STANDS ? a->force : NULL;
    scene.force_name = a->least ? "least forces" : NULL;
    scene.limiting = -1;
    return scene;
}

static void report_resultants(const struct analysis *a)
{
    const struct draw_scene scene = scene_of(a);
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    struct draw_pt at, f;
    double least = 0; /* below, a component is rounding */
    if (!scene.force) return;
    for (int k = 0; k < a->task.s.contacts; k++)
        if (draw_resultant(&scene, k, &at, &f))
            least = fmax(least, 1e-9 * hypot(f.x, f.y));
    printf("  resultants  %-10s %-10s %11s %11s %11s %11s\n", "from", "on", "x",
           "y", "fx", "fy");
    for (int k = 0; k < a->task.s.contacts; k++)
        if (draw_resultant(&scene, k, &at, &f))
            printf("              %-10s %-10s %11.5g %11.5g %11.5g %11.5g\n",
                   name_of(a, a->task.s.contact[k].a, one),
                   name_of(a, a->task.s.contact[k].b, two), tidy(a, at.x),
                   tidy(a, at.y), fabs(f.x) < least ? 0 : f.x,
                   fabs(f.y) < least ? 0 : f.y);
}

static void report_motion(const struct analysis *a)
{
    const kern_motion *motion = shown_motion(a);
    char shown[TEXT_SHOW_ROOM];
    if (!motion) {
        printf("  motion      none\n");
        return;
    }
    printf("  motion      %-10s %11s %11s %11s\n", "block", "vx", "vy", "spin");
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        printf("              %-10s %11.5f %11.5f %11.5f\n",
               name_of(a, i, shown), rate(motion[i].vx), rate(motion[i].vy),
               rate(motion[i].spin));
    }
}

/* Of both sides together: larger is worse. */
static double expected_drop(const struct analysis *a)
{
    return (double)a->all[LOAD_LEFT].drop + (double)a->all[LOAD_RIGHT].drop;
}

static void report_profile(const struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    if (a->profiled < 0) {
        printf("  profile     undecided\n");
        return;
    }
    printf("  profile     %-10s %11s %11s %11s\n", "block", "margin",
           "load left", "load right");
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        printf("              %-10s %11.5f %11.5f %11.5f\n",
               name_of(a, i, shown), (double)a->fate[MARGIN][i],
               (double)a->fate[LOAD_LEFT][i], (double)a->fate[LOAD_RIGHT][i]);
    }
    printf("              %-10s %11.5f %11.5f %11.5f\n", "mean",
           (double)a->all[MARGIN].mean, (double)a->all[LOAD_LEFT].mean,
           (double)a->all[LOAD_RIGHT].mean);
    printf("              %-10s %11.5f %11.5f %11.5f\n", "weaker half",
           (double)a->all[MARGIN].weak, (double)a->all[LOAD_LEFT].weak,
           (double)a->all[LOAD_RIGHT].weak);
    printf("  drop        %-10.4g expected under shaking, in mean blocks; more "
           "is worse\n", expected_drop(a));
}

/* Distance between two outlines that do not cross: of a corner from an edge. */
static double gap_between(const kern_block *a, const kern_block *b)
{
    double least = HUGE_VAL;
    for (int side = 0; side < 2; side++) {
        for (int i = 0; i < a->vertices; i++)
            for (int j = 0; j < b->vertices; j++) {
                kern_vec p = a->vertex[i], q = b->vertex[j];
                kern_vec r = b->vertex[j + 1 < b->vertices ? j + 1 : 0];
                double ex = r.x - q.x, ey = r.y - q.y;
                double x = p.x - q.x, y = p.y - q.y;
                double at = (x * ex + y * ey) / (ex * ex + ey * ey);
                at = at > 0 ? at < 1 ? at : 1 : 0;
                least = fmin(least, hypot(x - at * ex, y - at * ey));
            }
        const kern_block *other = a;
        a = b;
        b = other;
    }
    return least;
}

/* Given contacts whose normal leads from b, over the contact, into a. */
static void report_normals(const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    int shown = 0;
    for (int k = 0; k < s->contacts && a->text.given && shown < 5; k++) {
        const kern_contact *c = &s->contact[k];
        const kern_vec u = s->block[c->a].centre, v = s->block[c->b].centre;
        if ((c->p.x - u.x) * c->n.x + (c->p.y - u.y) * c->n.y >= 0 ||
            (v.x - c->p.x) * c->n.x + (v.y - c->p.y) * c->n.y >= 0)
            continue;
        printf("  contact %s %s at (%.6g, %.6g): its normal, %.4g %.4g, leads "
               "into %s\n", name_of(a, c->a, one), name_of(a, c->b, two),
               (double)c->p.x, (double)c->p.y, (double)c->n.x, (double)c->n.y,
               name_of(a, c->a, one));
        shown++;
    }
}

/* An angle in degrees taken for its tangent: no stones stick like that. */
static void report_friction(const struct analysis *a)
{
    const double mu = (double)a->task.options.mu;
    if (mu > 2)
        printf("  friction %g is that of %.4g degrees: MU is the tangent of the "
               "friction angle\n", mu, 57.295779513082321 * atan(mu));
}

/* What a structure that falls may lack: ground, or contacts. */
static void report_lack(const struct analysis *a)
{
    const kern_structure *s = &a->task.s;
    char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
    int shown = 0;
    if (a->verdict != KERN_FALLS) return;
    if (a->text.fixed == 0)
        printf("  no block is fixed: name the ground with 'fixed'\n");
    if (s->gravity.y > 0)
        printf("  gravity points up: %.6g %.6g\n", (double)s->gravity.x,
               (double)s->gravity.y);
    report_normals(a);
    for (int i = 0; i < s->blocks && shown < 5; i++) {
        int touches = s->block[i].fixed || a->text.given, nearest = -1;
        double least = HUGE_VAL;
        for (int k = 0; k < s->contacts && !touches; k++)
            touches = s->contact[k].a == i || s->contact[k].b == i;
        for (int j = 0; j < s->blocks && !touches; j++) {
            double gap = j == i ? HUGE_VAL : gap_between(&s->block[i],
                                                         &s->block[j]);
            if (!(gap < least)) continue;
            least = gap;
            nearest = j;
        }
        if (touches || nearest < 0) continue;
        printf("  %s touches nothing; nearest gap %.4g, to %s (--gap)\n",
               name_of(a, i, one), least, name_of(a, nearest, two));
        shown++;
    }
}

/* The verdict, as soon as it is known. */
static void report_verdict(const struct analysis *a)
{
    printf("%s: %s", a->file, status_word(a));
    if (shrinkage(a) > 0)
        printf(" when shrunk by %.6g%s", (double)shrinkage(a),
               a->set->relative ? " of each contact" : "");
    if (a->certain >= 0)
        printf(a->certain ? ", for certain" : ", not for certain: within the "
                                              "error it may be otherwise");
    printf("\n");
    if (a->certain >= 0 && a->interval.high < KERN_INFINITY)
        printf("  within the error  margin from %.4g to %.4g\n",
               (double)a->interval.low, (double)a->interval.high);
    report_friction(a);
    report_lack(a);
    fflush(stdout);
}

static const char *const raising_word[] = { "not shown", "raised", "hangs" };

static void report_raised(const struct analysis *a)
{
    printf("  raised      ");
    if (a->raised != KERN_STANDS) {
        printf("%s\n", a->raised == KERN_FALLS ? "no: it falls" : "undecided");
        return;
    }
    printf("%s", a->raising == KERN_RAISED
           ? "yes       its load raises the forces that hold it"
           : a->raising == KERN_HANGS
           ? "hangs     some blocks rest on nothing"
           : "not shown  no forces were found that its load raises");
    if (a->raising == KERN_RAISED && !isnan(a->reserve))
        printf("; reserve %.4g g to either side", a->reserve);
    printf("\n");
}

static const char *shown_text(double value, char out[32])
{
    return isnan(value) ? "not shown" : factor_text(value, 1, "", out);
}

/* Beside the load factor: what Coulomb friction bears, from rest. */
static void report_raised_loads(const struct analysis *a)
{
    char left[32], right[32];
    if (a->raised != KERN_STANDS) return;
    if (gravity_of(a) > 0)
        printf("  raised load %s left, %s right: where stones slide without "
               "parting, from rest\n",
               shown_text(a->raised_load[LEFT], left),
               shown_text(a->raised_load[RIGHT], right));
    if (a->text.lives > 0)
        printf("  raised live %s: the same for the live load\n",
               shown_text(a->raised_load[LIVE], left));
}

static void report_error(const struct analysis *a)
{
    printf("  bears       ");
    if (isnan(a->bears)) printf("undecided\n");
    else {
        printf("%-8.4g  times an error of %.4g in place", a->bears,
               (double)a->set->own_error);
        if (a->set->own_turn > 0)
            printf(" and %.4g rad in angle", (double)a->set->own_turn);
        printf("\n");
    }
    if (!isnan(a->least_friction))
        printf("  friction    %-8.4g  the least at which it stands\n",
               a->least_friction);
}

static void report_sequence(const struct analysis *a)
{
    int weakest = weakest_step(a);
    char shown[TEXT_SHOW_ROOM];
    printf("  sequence    margin after each block\n");
    for (int i = 0; i < a->task.s.blocks; i++)
        if (!a->task.s.block[i].fixed)
            printf("    %-16s %.4g%s\n", name_of(a, i, shown),
                   a->sequence[i], i == weakest ? "  weakest" : "");
}

/* Of all blocks, or of the one that was named. */
static void report_stays(const struct analysis *a)
{
    char shown[TEXT_SHOW_ROOM];
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed ||
            (!is_all(a->set->stays) &&
             strcmp(a->text.name[i], a->set->stays) != 0)) continue;
        printf("  stays       ");
        if (isnan(a->stays[i])) printf("no        ");
        else printf("%-8.3f  ", a->stays[i]);
        printf("chance that %s, laid last, stays where it is let go\n",
               name_of(a, i, shown));
    }
}

static void report(const struct analysis *a)
{
    report_structure(a);
    if (a->set->touching)
        printf("  near contacts count in what follows, but not in the verdict "
               "above\n");
    if (shrinkage(a) > 0)
        printf("  level, margin and bearing are those of contacts as they are, "
               "loads and tilts at %.6g\n", (double)shrinkage(a));
    report_level(a);
    report_margin(a);
    report_bearing(a);
    report_stress(a);
    report_limit(a);
    if (a->set->raised) report_raised(a);
    if (a->set->own_error > 0) report_error(a);
    if (a->set->sequence) report_sequence(a);
    if (a->set->stays) report_stays(a);
    report_collapse(a);
    report_loads(a);
    if (a->set->raised) report_raised_loads(a);
    if (a->set->forces) report_forces(a);
    if (a->set->forces) report_resultants(a);
    if (a->set->mechanism) report_motion(a);
    if (a->set->profile) report_profile(a);
    if (a->set->files > 1) printf("\n");
}

/* ---- JSON ---------------------------------------------------------------- */

static void json_count(const char *key, int value, int exists)
{
    if (exists) printf(", \"%s\": %d", key, value);
    else printf(", \"%s\": null", key);
}

static void json_known(const char *key, double value, int known)
{
    json_number(key, known ? value : (double)NAN);
}

static void json_flag(const char *key, int value, int known)
{
    printf(", \"%s\": %s", key, !known ? "null" : value ? "true" : "false");
}

static void json_contacts(const struct analysis *a)
{
    int stands = a->shown == KERN_STANDS;
    printf(", \"contacts\": [");
    for (int k = 0; k < a->task.s.contacts; k++) {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, shrinkage(a), a->set->relative);
        printf("%s{", k > 0 ? ", " : "");
        json_string("a", a->text.name[c->a]);
        printf(", ");
        json_string("b", a->text.name[c->b]);
        json_number("x", (double)p.x);
        json_number("y", (double)p.y);
        json_number("nx", (double)c->n.x);
        json_number("ny", (double)c->n.y);
        json_number("mu", (double)c->mu);
        json_number("travel", fabs((double)c->travel));
        json_known("normal", (double)a->force[k].normal, stands);
        json_known("tangential", (double)a->force[k].tangential, stands);
        printf("}");
    }
    printf("]");
}

/* One resultant an interface, and where the thrust goes through blocks. */
static void json_thrust(const struct analysis *a)
{
    const struct draw_scene scene = scene_of(a);
    const kern_structure *s = &a->task.s;
    struct draw_pt at, f;
    struct draw_pt (*through)[2] = array(s->blocks, sizeof *through);
    int *presses = scene.force && through ? draw_thrust_of(&scene, through)
                                          : NULL;
    const char *comma = "";
    printf(", \"resultants\": [");
    for (int k = 0; presses && k < s->contacts; k++) {
        if (!draw_resultant(&scene, k, &at, &f)) continue;
        printf("%s{", comma);
        json_string("a", a->text.name[s->contact[k].a]);
        printf(", ");
        json_string("b", a->text.name[s->contact[k].b]);
        json_number("x", at.x);
        json_number("y", at.y);
        json_number("fx", f.x);
        json_number("fy", f.y);
        int most = most_stressed(a, k, draw_interface(s, k));
        json_number("stress", most < 0 ? (double)NAN : a->stress[most]);
        printf("}");
        comma = ", ";
    }
    printf("], \"thrust\": [");
    comma = "";
    for (int i = 0; presses && i < s->blocks; i++) {
        if (presses[i] != 2 || s->block[i].fixed) continue;
        printf("%s{", comma);
        json_string("block", a->text.name[i]);
        json_number("x1", through[i][0].x);
        json_number("y1", through[i][0].y);
        json_number("x2", through[i][1].x);
        json_number("y2", through[i][1].y);
        printf("}");
        comma = ", ";
    }
    printf("]");
    free(through);
    free(presses);
}

static void json_motion(const struct analysis *a)
{
    const kern_motion *motion = shown_motion(a);
    if (!motion) {
        printf(", \"motion\": null");
        return;
    }
    printf(", \"motion\": [");
    int first = 1;
    for (int i = 0; i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("vx", (double)motion[i].vx);
        json_number("vy", (double)motion[i].vy);
        json_number("spin", (double)motion[i].spin);
        printf("}");
        first = 0;
    }
    printf("]");
}

static void json_limits(const struct analysis *a, int good)
{
    const char *comma = "";
    double share;
    printf(", \"limited_by\": [");
    for (int k; good && (k = next_limit(a, &share)) >= 0; comma = ", ") {
        const kern_contact *c = &a->task.s.contact[k];
        kern_vec p = kern_contact_at(c, a->m.margin, a->set->relative);
        printf("%s{", comma);
        json_string("a", a->text.name[c->a]);
        printf(", ");
        json_string("b", a->text.name[c->b]);
        json_number("x", (double)p.x);
        json_number("y", (double)p.y);
        json_number("corner_x", (double)c->p.x);
        json_number("corner_y", (double)c->p.y);
        json_number("share", share);
        printf(", ");
        json_string("does", meeting_word[a->critical.meeting[k]]);
        printf("}");
    }
    printf("], \"would_fall\": [");
    kern_critical moving = { NULL, NULL, NULL, -1, 0 };
    if (good) moving = find_groups(a);
    for (int group = 0; group < moving.groups; group++) {
        printf("%s[", group > 0 ? ", " : "");
        comma = "\"";
        for (int i = 0; i < a->task.s.blocks; i++) {
            if (moving.group[i] != group) continue;
            printf("%s", comma);
            json_text(a->text.name[i]);
            comma = "\", \"";
        }
        printf("\"]");
    }
    printf("]");
    free(moving.group);
}

/* Of what is undecided the numbers are null, and the list is empty. */
static void json_profile(const struct analysis *a, int good)
{
    int known = good && a->profiled >= 0, first = 1;
    json_known("progressive_margin", (double)a->all[MARGIN].mean, known);
    json_known("progressive_load", mean_load(a), known);
    json_known("weak_margin", (double)a->all[MARGIN].weak, known);
    json_known("weak_load", weak_load(a), known);
    json_known("expected_drop", expected_drop(a), known);
    printf(", \"profile\": [");
    for (int i = 0; known && i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("margin", (double)a->fate[MARGIN][i]);
        json_number("load_left", (double)a->fate[LOAD_LEFT][i]);
        json_number("load_right", (double)a->fate[LOAD_RIGHT][i]);
        json_number("load", fate_load(a, i));
        printf("}");
        first = 0;
    }
    printf("]");
}

static void json_error(const struct analysis *a)
{
    printf(", \"error\": ");
    if (!a->error[0]) {
        printf("null");
        return;
    }
    printf("\"");
    json_text(a->file);
    if (a->line > 0) printf(":%d", a->line);
    printf(": ");
    json_text(a->error);
    printf("\"");
}

/* Which numbers are null because they are undecided; others that are null are
   without limit, or belong to the other verdict. */
static void json_raised(const struct analysis *a, int good)
{
    int known = good && a->raised == KERN_STANDS;
    if (known) {
        printf(", ");
        json_string("raised", raising_word[a->raising]);
    } else
        printf(", \"raised\": null");
    json_known("reserve", a->reserve, known);
    json_known("raised_load_left", a->raised_load[LEFT], known);
    json_known("raised_load_right", a->raised_load[RIGHT], known);
    if (a->text.lives > 0)
        json_known("raised_live", a->raised_load[LIVE], known);
}

static void json_sequence(const struct analysis *a, int good)
{
    int weakest = good ? weakest_step(a) : -1, first = 1;
    printf(", \"sequence\": [");
    for (int i = 0; good && i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        printf("%s{", first ? "" : ", ");
        json_string("block", a->text.name[i]);
        json_number("margin", a->sequence[i]);
        printf("}");
        first = 0;
    }
    printf("], ");
    if (weakest < 0) printf("\"weakest_step\": null");
    else json_string("weakest_step", a->text.name[weakest]);
}

/* A number for the block that was named; a list for all. */
static void json_stays(const struct analysis *a, int good)
{
    const int all = is_all(a->set->stays);
    const char *comma = "";
    printf(", \"stays\": %s", all ? "[" : good ? "" : "null");
    for (int i = 0; good && i < a->task.s.blocks; i++) {
        if (a->task.s.block[i].fixed) continue;
        if (all) {
            printf("%s{", comma);
            json_string("block", a->text.name[i]);
            json_number("stays", a->stays[i]);
            printf("}");
            comma = ", ";
        } else if (strcmp(a->text.name[i], a->set->stays) == 0)
            json_value(a->stays[i]);
    }
    printf("%s", all ? "]" : "");
}

static void json_open(unsigned open)
{
    const char *comma = "";
    printf(", \"undecided\": [");
    for (int k = 0; k < OPENS_MOST; k++) {
        if (!(open >> k & 1)) continue;
        printf("%s\"%s\"", comma, open_name[k]);
        comma = ", ";
    }
    printf("]");
}

/* What the file has, and how it was taken. */
static void json_structure(const struct analysis *a, int good)
{
    int lines = good ? line_points(a) : 0;
    json_count("blocks", a->task.s.blocks - a->text.fixed, good);
    json_count("fixed", a->text.fixed, good);
    json_count("contact_points", a->task.s.contacts, good);
    json_count("line_contacts", lines / 2, good);
    json_count("point_contacts", a->task.s.contacts - lines, good);
}

static void json_measure(const struct analysis *a, int good, int asked)
{
    int known = asked && a->measured >= 0;
    int falls = known && a->measured == KERN_FALLS;
    int proven = known || (good && a->measured == KERN_LIMIT);
    int most = known ? most_stressed(a, 0, a->task.s.contacts) : -1;
    json_known("epsilon", (double)a->m.epsilon, known);
    json_flag("relative", a->set->relative, 1);
    json_flag("near", a->set->touching, 1);
    if (a->set->error > 0) json_flag("certain", a->certain > 0, a->certain >= 0);
    json_count("level", a->m.level, known && a->m.level >= 0);
    json_flag("saturated", a->m.saturated, known);
    json_known("margin", (double)a->m.margin, known);
    if (a->set->error > 0) {
        json_known("margin_low", (double)a->interval.low, a->certain >= 0);
        json_known("margin_high", (double)a->interval.high,
                   a->certain >= 0 && a->interval.high < KERN_INFINITY);
    }
    json_known("holds", (double)a->m.holds, proven && !(a->m.holds < 0));
    json_known("fails", (double)a->m.fails,
               proven && (falls || a->m.fails < a->m.most));
    json_known("deficit", a->deficit, falls);
    json_known("signed_margin", falls ? -a->deficit : (double)a->m.margin,
               known);
    json_known("bearing", a->bearing, asked);
    json_known("peak_stress", most < 0 ? 0 : a->stress[most], most >= 0);
}

static void json_loads(const struct analysis *a, int asked)
{
    json_known("load_left", a->load[LEFT], asked);
    json_known("load_right", a->load[RIGHT], asked);
    json_known("tilt_left", a->tilt[LEFT], asked);
    json_known("tilt_right", a->tilt[RIGHT], asked);
    if (a->text.loads > 0) json_flag("loads_stay", 1, 1);
    if (a->text.lives > 0) json_known("live", a->live, asked);
    json_open(asked ? open_questions(a) : 0);
}

/* A file with an error has the same keys as any other. */
static void report_json(const struct analysis *a)
{
    int good = !a->error[0], asked = good && !a->set->verdict_only;
    printf("{");
    json_string("file", a->file);
    printf(", ");
    json_string("status", status_word(a));
    json_structure(a, good);
    json_measure(a, good, asked);
    json_limits(a, asked);
    if (a->set->raised) json_raised(a, asked);
    if (a->set->own_error > 0) {
        json_known("bears", a->bears, asked);
        json_known("least_friction", a->least_friction, asked);
    }
    if (a->set->sequence) json_sequence(a, good && a->sequence);
    if (a->set->stays) json_stays(a, good && a->stays);
    json_loads(a, asked);
    json_known("proof_error", (double)a->work.error, good);
    json_count("pivots", a->work.pivots, good);
    json_count("solves", a->work.solves, good);
    if (a->set->profile) json_profile(a, good);
    json_error(a);
    if (good && a->set->forces) json_contacts(a);
    if (good && a->set->forces) json_thrust(a);
    if (good && a->set->mechanism) json_motion(a);
    printf("}\n");
}

/* ---- Picture ------------------------------------------------------------- */

/* The name of a file without folder and suffix. */
static const char *stem_of(const char *path, int *length)
{
    const char *name = path;
    for (const char *s = path; *s; s++)
        if (*s == '/' || *s == '\\') name = s + 1;
    if (strcmp(name, "-") == 0) name = "stdin";
    const char *dot = strrchr(name, '.');
    *length = dot && dot > name ? (int)(dot - name) : (int)strlen(name);
    return name;
}

/* OUT.svg for one file, OUT-NAME.svg for each of several, and OUT-NAME-2.svg
   for the second of that name. */
static char *svg_name(const struct analysis *a)
{
    const struct settings *set = a->set;
    int out, stem, same = 1, folder;
    const char *name = stem_of(a->file, &stem), *base = stem_of(set->svg, &out);
    folder = (int)(base - set->svg) + out;
    for (int i = 0; i < a->number; i++) {
        int n;
        const char *other = stem_of(set->file[i], &n);
        same += n == stem && strncmp(name, other, (size_t)n) == 0;
    }
    size_t room = strlen(set->svg) + (size_t)stem + 16;
    char *path = malloc(room);
    if (!path) return NULL;
    if (set->files == 1)
        strcpy(path, set->svg);
    else if (same == 1)
        snprintf(path, room, "%.*s-%.*s%s", folder, set->svg, stem, name,
                 set->svg + folder);
    else
        snprintf(path, room, "%.*s-%.*s-%d%s", folder, set->svg, stem, name,
                 same, set->svg + folder);
    return path;
}

static void write_caption(const struct analysis *a, char *out, size_t room)
{
    int stem;
    const char *name = stem_of(a->file, &stem);
    char level[80] = "level undecided";
    if (a->set->verdict_only)
        snprintf(level, sizeof level, "margin not asked for");
    else if (a->measured == KERN_FALLS)
        snprintf(level, sizeof level,
                 isfinite(a->deficit) ? "level 0, deficit %.4g"
                                      : "level 0, wider contacts do not help",
                 a->deficit);
    else if (a->measured == KERN_STANDS)
        snprintf(level, sizeof level, "level %d, margin %.4g%s", a->m.level,
                 (double)a->m.margin, a->m.saturated ? " (every kern closed)"
                                    : a->set->relative ? " of each contact"
                                    : " (a length)");
    char shrunk[40] = "";
    if (shrinkage(a) > 0)
        snprintf(shrunk, sizeof shrunk, " when shrunk by %.4g",
                 (double)shrinkage(a));
    stem = (int)strlen(name);
    snprintf(out, room, "%.*s %s%s; %s", stem > 100 ? 100 : stem, name,
             status_word(a), shrunk, level);
}

/* Stones in the colours of their margins. */
static void colour(const struct analysis *a, struct draw_scene *scene)
{
    scene->value = a->fate[MARGIN];
    scene->value_name = a->set->relative ? "margin of a stone, a share"
                                         : "margin of a stone, a length";
    for (int i = 0; i < a->task.s.blocks; i++)
        if (!a->task.s.block[i].fixed)
            scene->most = fmax(scene->most, (double)a->fate[MARGIN][i]);
}

static int draw(const struct analysis *a)
{
    char caption[256];
    write_caption(a, caption, sizeof caption);
    int falls = a->shown == KERN_FALLS;
    struct draw_scene scene = scene_of(a);
    scene.names = a->text.name;
    scene.motion = falls || a->set->mechanism ? shown_fall(a) : NULL;
    scene.motion_name = falls ? NULL : a->set->mechanism_live
        ? "collapse mechanism just past the factor of the live load"
        : "collapse mechanism just past the margin";
    scene.hinges = shown_fall(a);
    scene.hinged = falls || a->set->mechanism_live ? scene.shrink
                                                   : (double)a->m.fails;
    scene.limiting = a->critical.contact;
    scene.caption = caption;
    if (a->set->profile && a->profiled >= 0) colour(a, &scene);
    char *path = svg_name(a);
    FILE *out = path ? fopen(path, "w") : NULL;
    int bad = !out || draw_svg(out, &scene);
    if (out) bad |= fclose(out) != 0;
    if (bad) fprintf(stderr, "kern: cannot write %s: %s\n",
                     path ? path : "the picture", strerror(errno));
    free(path);
    return bad;
}

/* ---- Files --------------------------------------------------------------- */

/* After the first second: how far a long run has come, ten times a second. */
static void show_progress(const struct settings *set, int number, int *shown)
{
    static clock_t next = CLOCKS_PER_SEC;
    if (clock() < next || !ARGS_TERMINAL(2)) return;
    next = clock() + CLOCKS_PER_SEC / 10;
    fprintf(stderr, "\rkern: file %d of %d ", number + 1, set->files);
    fflush(stderr);
    *shown = 1;
}

static void clear_progress(int *shown)
{
    if (*shown) fprintf(stderr, "\r%*s\r", 40, "");
    *shown = 0;
}

static int exit_status_of(const struct analysis *a)
{
    if (a->error[0]) return EXIT_BAD;
    if (a->verdict < 0 || (!a->set->verdict_only && open_questions(a)))
        return EXIT_UNDECIDED;
    return a->verdict == KERN_FALLS ? EXIT_FALLS : EXIT_STANDS;
}

static int run_file(const struct settings *set, int number, int *shown)
{
    struct analysis a = { 0 };
    a.set = set;
    a.file = set->file[number];
    a.number = number;
    a.critical.contact = a.certain = -1;
    a.deficit = a.load[LEFT] = a.load[RIGHT] = a.tilt[LEFT] = a.tilt[RIGHT] =
        (double)NAN;
    int bad = analyse(&a);
    if (!bad && !set->json) {
        if (ARGS_TERMINAL(1)) clear_progress(shown);
        report_verdict(&a);
    }
    if (!bad && !set->verdict_only) measure(&a);
    show_stage(&a, "");
    if (a.error[0] || ARGS_TERMINAL(1)) clear_progress(shown);
    int status = exit_status_of(&a);
    if (a.error[0]) {
        fflush(stdout); /* so that a common log keeps the order */
        fprintf(stderr, "%s:", a.file);
        if (a.line > 0) fprintf(stderr, "%d:", a.line);
        fprintf(stderr, " %s\n", a.error);
    }
    if (set->json) report_json(&a);
    else if (!a.error[0] && !set->verdict_only) report(&a);
    if (set->svg && !a.error[0] && draw(&a)) status = EXIT_BAD;
    free_analysis(&a);
    return status;
}

static int run(const struct settings *set)
{
    int count[4] = { 0 }, shown = 0;
    for (int i = 0; i < set->files; i++) {
        show_progress(set, i, &shown);
        count[run_file(set, i, &shown)]++;
    }
    clear_progress(&shown);
    if (set->files > 1 && !set->json)
        printf("%d files: %d stand, %d fall, %d undecided, %d bad\n",
               set->files, count[EXIT_STANDS], count[EXIT_FALLS],
               count[EXIT_UNDECIDED], count[EXIT_BAD]);
    if (fflush(stdout) || ferror(stdout)) {
        fprintf(stderr, "kern: cannot write the report: %s\n", strerror(errno));
        return EXIT_BAD;
    }
    return count[EXIT_BAD] ? EXIT_BAD : count[EXIT_UNDECIDED] ? EXIT_UNDECIDED
         : count[EXIT_FALLS] ? EXIT_FALLS : EXIT_STANDS;
}

/* ---- Command line -------------------------------------------------------- */

static int bad_use(const char *what, const char *word)
{
    fprintf(stderr, "kern: %s %s; try kern --help\n", what, word);
    return -1;
}

static int number_option(const char *name, const char *value, int zero,
                         kern_real *out)
{
    if (!value) return bad_use("a number is missing after", name);
    if (!text_number(value, out) || *out < 0 || (!zero && !(*out > 0))) {
        fprintf(stderr, "kern: %s takes a %s, read '%s'\n", name,
                zero ? "number not below zero" : "positive number", value);
        return -1;
    }
    return 0;
}

/* E or E,THETA */
static int error_option(const char *name, const char *value, kern_real *error,
                        kern_real *turn)
{
    char first[100];
    const char *comma = value ? strchr(value, ',') : NULL;
    size_t n = comma ? (size_t)(comma - value) : 0;
    if (!comma || n >= sizeof first)
        return number_option(name, value, 0, error);
    memcpy(first, value, n);
    first[n] = '\0';
    return number_option(name, first, 0, error)
        || number_option(name, comma + 1, 1, turn) ? -1 : 0;
}

/* An option with a name behind it. */
static int name_option(struct settings *set, char **argv, int *i)
{
    const char *word = argv[*i];
    if (args_value(argv, i, "--stays", &set->stays))
        return set->stays && set->stays[0] ? 0
             : bad_use("a block, or all, is missing after", "--stays");
    if (!args_value(argv, i, "--svg", &set->svg))
        return bad_use("unknown option", word);
    if (args_is_svg(set->svg)) return 0;
    return set->svg && set->svg[0]
         ? bad_use("--svg takes a name that ends in .svg, read", set->svg)
         : bad_use("a file name is missing after", "--svg");
}

/* Reads argv[*i], with what belongs to it; 0 where it is fine. */
static int read_option(void *settings, char **argv, int *i)
{
    struct settings *set = settings;
    struct { const char *name; int zero; kern_real *out; } number[] = {
        { "--epsilon", 0, &set->epsilon }, { "-e", 0, &set->epsilon },
        { "--mu", 1, &set->mu }, { "--gap", 0, &set->gap },
        { "--at", 1, &set->at }, { "--limit", 1, &set->limit },
        { "--overlap", 0, &set->overlap }
    };
    struct { const char *name; int *out; } flag[] = {
        { "--relative", &set->relative }, { "-r", &set->relative },
        { "--forces", &set->forces }, { "--mechanism", &set->mechanism },
        { "--raised", &set->raised }, { "--sequence", &set->sequence },
        { "--profile", &set->profile }, { "--near", &set->touching },
        { "--json", &set->json }, { "--verdict", &set->verdict_only },
        { "--lone", &set->lone }
    };
    const char *word = argv[*i], *value;
    if (strcmp(word, "--mechanism") == 0 && argv[*i + 1] &&
        strcmp(argv[*i + 1], "live") == 0) {
        set->mechanism = set->mechanism_live = 1;
        ++*i;
        return 0;
    }
    for (size_t k = 0; k < sizeof number / sizeof *number; k++)
        if (args_value(argv, i, number[k].name, &value))
            return number_option(number[k].name, value, number[k].zero,
                                 number[k].out);
    for (size_t k = 0; k < sizeof flag / sizeof *flag; k++)
        if (strcmp(word, flag[k].name) == 0) {
            *flag[k].out = 1;
            return 0;
        }
    if (args_value(argv, i, "--measured", &value))
        return error_option("--measured", value, &set->error, &set->turn);
    if (args_value(argv, i, "--error", &value))
        return error_option("--error", value, &set->own_error, &set->own_turn);
    return name_option(set, argv, i);
}

int main(int argc, char **argv)
{
    struct settings set = { 0 };
    set.epsilon = set.mu = set.gap = set.at = set.limit = set.overlap = -1;
    set.error = set.turn = set.own_error = set.own_turn = -1;
    set.file = argv;
    set.files = args_read(argc, argv, read_option, &set);
    if (set.files == ARGS_BAD) return EXIT_BAD;
    if (set.files == ARGS_HELP)
        return fputs(help, stdout) < 0 || fputs(help_format, stdout) < 0
             ? EXIT_BAD : EXIT_STANDS;
    if (set.files == ARGS_VERSION)
        return puts("kern " KERN_VERSION) < 0 ? EXIT_BAD : EXIT_STANDS;
    if (set.files == 0) {
        fputs("kern: no file is given\n", stderr);
        fputs(help, stderr);
        return EXIT_BAD;
    }
    if (set.limit > 2e9 || (set.limit > 0 && set.limit < 1)) {
        fputs("kern: --limit takes a number from 1 to 2,000,000,000, or 0\n",
              stderr);
        return EXIT_BAD;
    }
    if (set.relative && set.at > 1) {
        fputs("kern: with --relative --at takes a share from 0 to 1\n", stderr);
        return EXIT_BAD;
    }
    return run(&set);
}
