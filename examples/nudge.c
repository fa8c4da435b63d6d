/* Which way should each stone move, and how exactly must it lie?

       cc -O2 -o nudge examples/nudge.c -lm
       ./nudge nudge.svg examples/structures/wall-60.kern

   kern_sensitivity() tells how the margin changes when a stone moves or turns,
   from one measure. The stone that matters most is then moved along its bed to
   where the margin is largest: where it is known with its slope at two places
   it lies below both tangents, and the next place is where they meet. Without
   arguments the structure is the one below, in which a stone holds down a slab
   that reaches out. The first argument is a file for a picture (- for none), the
   second a structure made of polygons, the third the stone that moves. */

#define KERN_IMPLEMENTATION
#include "../kern.h"

#include "parts/args.h"
#include "parts/draw.h"
#include "parts/room.h"
#include "parts/text.h"

#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MEASURES = 12, ROWS = 8 };

#define SHARE 0.1 /* of the margin, that a place may cost                   */
#define GAIN 0.01 /* that is not worth another measure                      */
#define FLAT 1e-3 /* slope that is none                                     */

static const char built_in[] =
    "fixed pier     0 0      1 0      1 1      0 1\n"
    "block slab  *  0.1 1    2.1 1    2.1 1.3  0.1 1.3\n"
    "block top   *  0.15 1.3 0.95 1.3 0.95 2.1 0.15 2.1\n";

struct nudge {
    struct text_file file;
    kern_task task;
    kern_work work;
    kern_contact *contact;
    int room; /* contact points                             */
    kern_force *force;
    kern_motion *motion;
    kern_contact_rate *point; /* how the margin depends on each contact ... */
    kern_block_rate *stone;   /* ... and on each block                      */
    kern_margin m;
    int measures;
    int climber;    /* the stone that moves; -1: none             */
    kern_vec along; /* its bed                                    */
    double way;     /* how far it moved                           */
};

/* A place along the bed. */
struct step {
    double x, margin, slope; /* margin < 0: it cannot lie there            */
};

static int complain(const char *what, const char *why)
{
    fprintf(stderr, "nudge: %s: %s\n", what, why);
    return -1;
}

/* ---- the margin, and what it depends on --------------------------------- */

/* Contacts, margin and rates, as the stones lie. */
static kern_status measure(struct nudge *n)
{
    kern_proof proof;
    kern_status status;
    int i;

    proof.force = n->force;
    proof.motion = n->motion;
    n->measures++;
    n->task.s.contacts = kern_contacts(n->task.s.block, n->task.s.blocks,
                                       &n->task.options, n->contact, n->room,
                                       &n->work);
    status = kern_measure(&n->task, &n->m, &proof);
    for (i = 0; i < n->task.s.blocks; i++)
        memset(&n->stone[i], 0, sizeof n->stone[i]);
    if (status == KERN_STANDS) /* saturated: nothing moves it */
        kern_sensitivity(&n->task, &n->m, &proof, n->point, n->stone);
    return status;
}

static int open_task(struct nudge *n)
{
    struct text_file *t = &n->file;
    const size_t blocks = (size_t)t->blocks;
    size_t room;

    n->room = 32 * t->blocks + 64;
    room = (size_t)n->room;
    n->work = room_work(t->blocks, n->room);
    n->contact = malloc(room * sizeof *n->contact);
    n->force = malloc(room * sizeof *n->force);
    n->point = malloc(room * sizeof *n->point);
    n->motion = malloc(blocks * sizeof *n->motion);
    n->stone = calloc(blocks, sizeof *n->stone);
    if (!n->work.real || !n->work.index || !n->contact || !n->force || !n->point
        || !n->motion || !n->stone)
        return complain("memory", strerror(errno));
    n->task = kern_task_of(t->block, t->blocks, n->contact, 0, &n->work);
    n->task.s.gravity = t->gravity;
    n->task.options = t->options;
    return 0;
}

static int open_file(struct nudge *n, const char *path)
{
    const char *name = path ? path : "the built-in structure";
    kern_status status;

    if (path ? text_load(&n->file, path)
             : text_read(&n->file, built_in, sizeof built_in - 1))
        return complain(name, n->file.message);
    if (n->file.given)
        return complain(name, "contacts are given, so none can be found");
    if (open_task(n))
        return -1;
    status = measure(n);
    if (status != KERN_STANDS)
        return complain(name, kern_status_text(status));
    return 0;
}

static void close_file(struct nudge *n)
{
    room_free_work(&n->work);
    free(n->contact);
    free(n->force);
    free(n->point);
    free(n->motion);
    free(n->stone);
    text_free(&n->file);
}

/* How far off stone i may lie until that costs a share of the margin. */
static double exactness(const struct nudge *n, int i)
{
    const kern_vec v = n->stone[i].place;

    return SHARE * n->m.margin / draw_hypot(v.x, v.y);
}

/* Does it matter where the stone lies: by more than the bracket of the margin?
   */
static int matters(const struct nudge *n, int i)
{
    return !n->task.s.block[i].fixed
        && exactness(n, i)
               < 100 * kern_mean_size(n->task.s.block, n->task.s.blocks);
}

/* ---- along the bed ------------------------------------------------------ */

/* The direction of the contact that presses the stone most; 0 where none
   does. */
static int find_bed(const struct nudge *n, int stone, kern_vec *along)
{
    double most = 0;
    int k;

    along->x = along->y = 0;
    for (k = 0; k < n->task.s.contacts; k++) {
        const kern_contact *c = &n->contact[k];

        if ((c->a == stone || c->b == stone) && n->force[k].normal > most) {
            most = n->force[k].normal;
            along->x = -c->n.y;
            along->y = c->n.x;
        }
    }
    return most > 0;
}

static double slope_of(const struct nudge *n, int stone, kern_vec along)
{
    return n->stone[stone].place.x * along.x
         + n->stone[stone].place.y * along.y;
}

/* The stone whose bed it matters most to move along; -1: none. */
static int find_stone(const struct nudge *n)
{
    double most = 0;
    int i, best = -1;

    for (i = 0; i < n->task.s.blocks; i++) {
        kern_vec along;

        if (!matters(n, i) || !find_bed(n, i, &along)
            || !(fabs(slope_of(n, i, along)) > most * (1 + 1e-6)))
            continue;
        most = fabs(slope_of(n, i, along));
        best = i;
    }
    return best;
}

static void move_stone(struct nudge *n, int stone, kern_vec along, double way)
{
    kern_block *b = &n->file.block[stone];
    const kern_block was = *b;
    kern_vec *v = n->file.vertex + (b->vertex - n->file.vertex);
    int i;

    for (i = 0; i < was.vertices; i++) {
        v[i].x += way * along.x;
        v[i].y += way * along.y;
    }
    kern_block_init(b, v, was.vertices, 1, NULL);
    b->mass = was.mass;
    b->load = was.load;
    b->centre.x = was.centre.x + way * along.x;
    b->centre.y = was.centre.y + way * along.y;
}

/* The margin with the stone at x along its bed, from where it was first. */
static struct step try_step(struct nudge *n, int stone, kern_vec along,
                            double *at, double x)
{
    struct step s;

    move_stone(n, stone, along, x - *at);
    *at = x;
    s.x = x;
    s.margin = measure(n) == KERN_STANDS ? n->m.margin : -1;
    s.slope = s.margin < 0 ? 0 : slope_of(n, stone, along);
    if (s.margin < 0)
        printf("%8.4f  no place for it, or it falls\n", x);
    else
        printf("%8.4f  %8.5f  %+8.4f\n", x, s.margin, s.slope);
    return s;
}

/* Where the tangents at two places meet, and in *margin how high. */
static double tangents_meet(const struct step *a, const struct step *b,
                            double *margin)
{
    const double x = (b->margin - a->margin + a->slope * a->x - b->slope * b->x)
                   / (a->slope - b->slope);

    *margin = a->margin + a->slope * (x - a->x);
    return x;
}

/* Where the tangents meet, or in the middle: where one end falls, or where the
   margin is not concave. */
static double place_between(const struct step *low, const struct step *high,
                            double *hope)
{
    if (!(high->margin < 0)) {
        const double x = tangents_meet(low, high, hope);
        if ((x - low->x) * (x - high->x) < 0)
            return x;
    }
    return (low->x + high->x) / 2;
}

/* Climbs the margin along the bed; the stone ends at the best place. Returns how
   far it has moved. */
static double climb(struct nudge *n, int stone, kern_vec along)
{
    struct step low, high = {0, 0, 0}, best, s;
    double at = 0, next, hope = 0, step;
    int between = 0;

    printf("     way    margin     slope\n");
    low = best = try_step(n, stone, along, &at, 0);
    step = 0.1 * sqrt(fabs(n->task.s.block[stone].area));
    step = low.slope > 0 ? step : -step;
    while (n->measures <= MEASURES && !n->m.saturated
           && fabs(low.slope) > FLAT) {
        next = between ? place_between(&low, &high, &hope) : low.x + step;
        if (between
            && ((high.margin >= 0 && hope < best.margin * (1 + GAIN))
                || fabs(high.x - low.x) < 0.1 * fabs(step)))
            break;
        s = try_step(n, stone, along, &at, next);
        if (s.margin > best.margin)
            best = s;
        if (s.margin >= 0 && s.slope * step > FLAT * fabs(step)) {
            low = s;
            step *= between ? 1 : 2;
        } else {
            high = s;
            between = 1;
        }
    }
    move_stone(n, stone, along, best.x - at);
    return best.x;
}

/* ---- what it prints ----------------------------------------------------- */

/* For three decimals: no zero with a sign. */
static double tidy(double x) { return fabs(x) < 5e-4 ? 0 : x; }

static void print_stones(const struct nudge *n)
{
    char *done = calloc((size_t)n->task.s.blocks, 1), name[TEXT_SHOW_ROOM];
    int row, i;

    printf(
        "margin %.5f, of which %.0f %% are lost where one stone lies no more "
        "exact than\n\n%-10s %8s  %s\n",
        n->m.margin, 100 * SHARE, "stone", "exact to",
        "the margin grows by x, y and turning");
    for (row = 0; done && row < ROWS; row++) {
        int best = -1;

        for (i = 0; i < n->task.s.blocks; i++)
            if (!done[i] && matters(n, i)
                && (best < 0 || exactness(n, i) < exactness(n, best)))
                best = i;
        if (best < 0)
            break;
        done[best] = 1;
        printf("%-10s %8.4f  %+.3f %+.3f %+.3f\n",
               text_show(name, n->file.name[best]), exactness(n, best),
               tidy(n->stone[best].place.x), tidy(n->stone[best].place.y),
               tidy(n->stone[best].turn));
    }
    free(done);
}

/* Chooses the stone, or takes the one that is named, and moves it. */
static int climb_one(struct nudge *n, const char *wanted)
{
    const double was = n->m.margin;
    char name[TEXT_SHOW_ROOM];
    int i;

    n->climber = wanted ? -1 : find_stone(n);
    for (i = 0; wanted && i < n->task.s.blocks; i++)
        if (!n->task.s.block[i].fixed && strcmp(n->file.name[i], wanted) == 0)
            n->climber = i;
    if (n->climber < 0 && wanted)
        return complain(wanted, "no free block has this name");
    if (n->climber < 0 || !find_bed(n, n->climber, &n->along)) {
        printf("\nno move along a bed makes the margin larger\n");
        return 0;
    }
    printf("\n%s along its bed, toward %+.3f %+.3f:\n",
           text_show(name, n->file.name[n->climber]), tidy(n->along.x),
           tidy(n->along.y));
    n->measures = 0;
    n->way = climb(n, n->climber, n->along);
    i = n->measures;
    measure(n);
    printf("\nmargin %.5f before, %.5f after %d measures\n", was, n->m.margin,
           i);
    return 0;
}

/* ---- the picture: arrows and circles ------------------------------------ */

static void draw_nudges(const struct draw_view *v, const void *data)
{
    const struct nudge *n = data;
    const kern_structure *s = &n->task.s;
    const double size = kern_mean_size(s->block, s->blocks);
    double most = 0;
    int i;

    for (i = 0; i < s->blocks; i++)
        if (matters(n, i))
            most = fmax(most, 1 / exactness(n, i));
    for (i = 0; i < s->blocks; i++) {
        const kern_block *b = &s->block[i];
        const kern_vec r = n->stone[i].place;
        const double unit = 0.6 * size / (most * SHARE * n->m.margin);
        const struct draw_pt c = draw_place(v, b->centre.x, b->centre.y);

        if (!matters(n, i))
            continue;
        if (exactness(n, i) < size)
            draw_circle(v->out, c, exactness(n, i) * v->scale,
                        "fill=\"none\" "
                        "stroke=\"" DRAW_KERN "\" stroke-width=\"1.2\"");
        draw_arrow(
            v->out, c,
            draw_place(v, b->centre.x + unit * r.x, b->centre.y + unit * r.y),
            draw_clamp(0.02 * size * v->scale, 0.8, 2), DRAW_LOAD);
    }
    if (fabs(n->way) > 0) {
        kern_motion moved;

        moved.vx = n->way * n->along.x;
        moved.vy = n->way * n->along.y;
        moved.spin = 0;
        draw_block(v, &s->block[n->climber], &moved, 1,
                   "fill=\"none\" "
                   "stroke=\"" DRAW_GHOST "\" stroke-dasharray=\"4 3\"");
    }
}

/* The structure as it was read. */
static int draw(struct nudge *n, const char *path)
{
    struct draw_scene scene = {0};
    char text[300];

    if (n->climber >= 0) {
        move_stone(n, n->climber, n->along, -n->way);
        measure(n);
    }
    snprintf(text, sizeof text,
             "Arrows: which way the margin, %.4g, grows.\n"
             "Circles: a stone that far off costs %.0f %% of it.\n"
             "Dashed: the best place of one stone along its bed.",
             n->m.margin, 100 * SHARE);
    scene.s = &n->task.s;
    scene.limiting = -1;
    scene.caption = text;
    scene.over = draw_nudges;
    scene.data = n;
    return draw_file(path, &scene) ? complain(path, strerror(errno)) : 0;
}

int main(int argc, char **argv)
{
    static struct nudge n;
    const char *svg = argc > 1 ? argv[1] : "-";
    int bad;

    if (argc > 4 || (strcmp(svg, "-") != 0 && !args_is_svg(svg))) {
        puts("usage: nudge [OUT.svg | - [STRUCTURE.kern [STONE]]]\n"
             "Which way each stone should move, and how exactly it must lie.");
        return strcmp(svg, "--help") == 0 || strcmp(svg, "-h") == 0 ? 0 : 2;
    }
    bad = open_file(&n, argc > 2 ? argv[2] : NULL);
    if (!bad) {
        print_stones(&n);
        bad = climb_one(&n, argc > 3 ? argv[3] : NULL);
    }
    if (!bad && strcmp(svg, "-") != 0)
        bad = draw(&n, svg);
    close_file(&n);
    return bad ? 1 : 0;
}

/* Output:
margin 0.18387, of which 10 % are lost where one stone lies no more exact than

stone      exact to  the margin grows by x, y and turning
top          0.0356  -0.516 +0.000 +0.000
slab         0.0380  -0.484 +0.000 +0.000

top along its bed, toward -1.000 +0.000:
     way    margin     slope
  0.0000   0.18387   +0.5161
  0.0800   0.22516   +0.5161
  0.2400   0.21000   -1.0000
  0.1755   0.27447   -1.0000

margin 0.18387 before, 0.27447 after 4 measures
*/
