/* text.h - reads the text format of a structure: one statement a line,

       friction MU [A [B]]                            default 0.4; of the contacts
                                                      of A, or of A with B
       gravity  GX GY                                 default 0 -9.81
       density  D                                     of the blocks after it, 1;
                                                      one must follow
       fixed    NAME  X1 Y1  X2 Y2  X3 Y3 ...         ground; a simple polygon
       block    NAME  MASS  X1 Y1  X2 Y2  X3 Y3 ...   MASS * is area x density
       com      NAME  X Y                             centre of mass
       load     NAME  FX FY  X Y                      force at a point
       torque   NAME  T
       live     NAME  FX FY  X Y                      load pattern: its factor
                                                      is asked for
       mass     NAME  M  X Y                          weight that is no stone,
                                                      added to mass and centre
       contact  A B  NX NY  X1 Y1 [X2 Y2] [mu MU]     normal from A into B; with
                                                      any of these none is found
       epsilon  E                                     step of Algorithm 1
       tolerance GAP [ANGLE]                          ANGLE in radians; GAP up
                                                      to the blocks' mean size
       measured E [ANGLE]                             standard errors of places
                                                      and angles, a length and
                                                      radians
       units NAME [FORCE]                             of lengths and forces, for
                                                      the report
       fill TOP DENSITY [phi PHI] [from X1 to X2]     soil on the upper outline:
                                                      its weight and, with PHI,
                                                      what it pushes back
       earth SIDE TOP DENSITY PHI DELTA [surcharge Q] [water LEVEL DENSITY] [live]
                                                      active pressure on the left
                                                      or right outline; live: its
                                                      factor is asked for
       axle X FORCE [WIDTH]                           live load downwards, which
                                                      fill spreads
       prop NAME FX FY X Y MOST                       a push from 0 to MOST
       bond STRESS                                    tensile strength of joints
       strength STRESS                                of the stone, for those who
                                                      let it crush

   PHI and DELTA are in degrees; soil.h has the physics. A block takes the least
   of its own frictions and of those of its neighbour; that of a pair goes first.
   Contacts are found here where statements need them: of friction A, prop, fill
   with phi, bond, strength. Props are blocks, the last ones.

   And # begins a comment. friction, gravity, epsilon, tolerance, measured and
   units hold for the whole file, wherever they stand; of several the last one
   holds. A program
   uses text_load() or text_read(), then text_free(); of the rest text_show(),
   text_number() and text_utf8() may be of use.

   SPDX-License-Identifier: MIT */

#ifndef TEXT_H
#define TEXT_H

#include "../../kern.h"

#include "soil.h"
#include "words.h"

#include <errno.h>
#include <float.h>
#include <limits.h>
#include <locale.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A statement `live`, or what reaches a block of an axle. */
struct text_live {
    int block;
    kern_vec force, place;
};

/* A statement `axle`. */
struct text_axle {
    int line;
    double x, force, width;
};

enum text_soil_kind { TEXT_FILL, TEXT_EARTH, TEXT_PROP };

/* A statement fill, earth or prop, and what it does in all. */
struct text_soil {
    enum text_soil_kind kind;
    int line, block; /* block: of prop                                   */
    enum soil_side side;
    double density, from, to; /* of fill, from x to x                    */
    struct soil_earth earth;  /* angles in rad; of fill top and phi      */
    kern_vec way, at;         /* of prop: direction and place            */
    struct soil_force sum;    /* weight or thrust, and where it acts        */
    kern_vec foot, head;      /* of the back that earth meets               */
    int live;                 /* nonzero: it is a part of the live load     */
    int blocks;               /* on how many blocks                         */
    int props;                /* and with how many pushes                   */
    double most;              /* that are this large in all                 */
};

/* A push that is made of a statement. */
struct text_push {
    enum text_soil_kind kind;
    int block;
    kern_vec at, way;
    double most;
};

struct text_file {
    kern_block *block;     /* polygons, masses, centres and loads in place    */
    char **name;           /* one a block                                     */
    int *block_line;       /* the line each block stands in                   */
    int blocks, fixed;     /* all of them; the fixed among them               */
    int given;             /* nonzero: contacts are those of the file alone   */
    kern_contact *contact; /* these, with their travels                       */
    double beside; /* share of the axles that no free block bears      */
    char *own_mu;  /* nonzero: the contact has a friction of its own  */
    int contacts;
    kern_wrench *live; /* one a block: load pattern about its centre      */
    int lives, loads;  /* statements of a pattern; of loads that stay     */
    struct text_live *axle; /* the statements of the pattern                  */
    kern_vec *mass; /* where statements `mass` put it                  */
    int masses;     /* how many                                        */
    double added, added_x,
        added_y; /* their masses in sum, and moments of these */
    kern_vec gravity;
    kern_options options;  /* the defaults, and what the file says            */
    int epsilon_line;      /* where `epsilon` stands, 0: nowhere              */
    kern_real error, turn; /* of `measured`; 0: exact, turn 0: not told      */
    const char *units;     /* of lengths, NULL: not known                     */
    int line;              /* of the error, 0: of the file as a whole         */
    char message[512];     /* what is wrong, with what was read               */
    char *text;            /* a copy of the file, which the names point into  */
    kern_vec *vertex;      /* of all blocks                                   */
    struct text_axle *wheel; /* the statements `axle`                         */
    struct text_soil *soil;  /* the statements fill, earth, prop              */
    int wheels, soils;
    int spread; /* the last of `lives` that axles and earth made         */
    int props;  /* the last of `blocks` that push: of props, then of fill */
    int found;  /* nonzero: `given` contacts were found here              */
    double bond, strength; /* 0: none                                         */
    const char *force_units; /* NULL: not known                               */
    kern_vec *prop_vertex;
    char *prop_name;
};

/* A file as long as that, or longer, is not read. */
#define TEXT_LONGEST ((size_t)INT_MAX / 2)

/* Room for a word as text_show() writes it. */
enum { TEXT_SHOWN = 40, TEXT_SHOW_ROOM = 4 * TEXT_SHOWN + 4 };

/* A contact waits until the file is read: `friction` and `tolerance` may come
   after it. */
struct text_contact {
    int a, b, line;
    kern_vec n, p, q;
    kern_real mu; /* < 0: that of the file */
};

/* A friction of a block, or of a pair. */
struct text_friction {
    int a, b; /* b < 0: of all contacts of a */
    kern_real mu;
};

struct text_reader {
    struct text_file *t;
    char *at, *end;        /* what is left of the line */
    const char *statement; /* its first word           */
    kern_real density;
    int unused;       /* the line of a density no block follows, or 0 */
    int gap_line;     /* where the last `tolerance` stands            */
    const char *name; /* of the block that is read, or NULL             */
    int vertices;
    int *slot, slots; /* names by hash: index of the block + 1, 0: none */
    struct text_contact *contact;
    int contacts;
    struct text_friction *friction;
    int frictions;
    struct text_push *push;
    int pushes;
    int laid; /* nonzero: all fill is on the outline */
};

enum text_range { TEXT_ANY, TEXT_NOT_NEGATIVE, TEXT_POSITIVE };

#ifdef KERN_SINGLE
#define TEXT_MOST ((double)FLT_MAX)
#else
#define TEXT_MOST DBL_MAX
#endif

/* ---- Words --------------------------------------------------------------- */

/* Writes a word as a terminal may see it: cut where it is long, bytes that are
   not printable as \xNN. Returns out, which has TEXT_SHOW_ROOM bytes. */
static inline const char *text_show(char *out, const char *word)
{
    char *o = out;
    const char *s = word;
    while (*s && s - word < TEXT_SHOWN) {
        const unsigned char *u = (const unsigned char *)s;
        int n = text_utf8(s);
        int control = u[0] < 0x20 || u[0] == 0x7f
                   || (u[0] == 0xc2 && u[1] < 0xa0);
        if (n == 0 || control) {
            o += snprintf(o, 5, "\\x%02x", (unsigned)u[0]);
            s++;
        } else {
            if (s - word + n > TEXT_SHOWN)
                break;
            while (n-- > 0)
                *o++ = *s++;
        }
    }
    strcpy(o, *s ? "..." : "");
    return out;
}

/* strtod() of a number whose point is at `dot`, in a process whose locale may
   write it in another way. Infinite where memory is lacking. */
static double text_strtod(const char *word, const char *dot)
{
    const char *point = localeconv()->decimal_point;
    if (*dot != '.' || strcmp(point, ".") == 0)
        return strtod(word, NULL);
    char room[64], *copy = room;
    size_t length = strlen(word) + strlen(point); /* less the dot, and a NUL */
    if (length > sizeof room)
        copy = malloc(length);
    if (!copy)
        return HUGE_VAL;
    char *o = copy;
    while (word < dot)
        *o++ = *word++;
    while (*point)
        *o++ = *point++;
    strcpy(o, dot + 1);
    double value = strtod(copy, NULL);
    if (copy != room)
        free(copy);
    return value;
}

/* Reads a word that is a finite number, and nothing but one: no hexadecimal
   and no "inf". Returns 0 where it is not. */
static inline int text_number(const char *word, kern_real *out)
{
    static const char digit[] = "0123456789";
    const char *s = word + (*word == '+' || *word == '-');
    size_t whole = strspn(s, digit), part = 0;
    s += whole;
    const char *dot = s;
    if (*s == '.') {
        part = strspn(s + 1, digit);
        s += 1 + part;
    }
    if (whole + part == 0)
        return 0;
    if (*s == 'e' || *s == 'E') {
        s += 1 + (s[1] == '+' || s[1] == '-');
        size_t power = strspn(s, digit);
        if (power == 0)
            return 0;
        s += power;
    }
    if (*s)
        return 0;
    double value = text_strtod(word, dot);
    if (!(value <= TEXT_MOST && value >= -TEXT_MOST))
        return 0;
    *out = (kern_real)value;
    return 1;
}

/* The next word of the line, ended by a NUL; the empty word after the last. */
static char *text_next(struct text_reader *r)
{
    static const char blank[] = " \t\r";
    r->at += strspn(r->at, blank);
    char *word = r->at;
    r->at += strcspn(r->at, blank);
    if (r->at < r->end)
        *r->at++ = '\0';
    return word;
}

/* ---- Errors -------------------------------------------------------------- */

static int text_fail(struct text_file *t, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    vsnprintf(t->message, sizeof t->message, format, list);
    va_end(list);
    return -1;
}

/* The statement, and the block that it makes: a name that was forgotten is seen
   by what was taken for one. */
static const char *text_about(const struct text_reader *r,
                              char out[TEXT_SHOW_ROOM + 16])
{
    char shown[TEXT_SHOW_ROOM];
    if (!r->name)
        return r->statement;
    snprintf(out, TEXT_SHOW_ROOM + 16, "%s '%s'", r->statement,
             text_show(shown, r->name));
    return out;
}

/* The error of most statements: something else was expected than this word. */
static int text_expect(struct text_reader *r, const char *what,
                       const char *word)
{
    char shown[TEXT_SHOW_ROOM], about[TEXT_SHOW_ROOM + 16];
    if (*word == '\0')
        return text_fail(r->t, "%s: %s is expected, but the line ends",
                         text_about(r, about), what);
    return text_fail(r->t, "%s: %s is expected, read '%s'",
                     text_about(r, about), what, text_show(shown, word));
}

static int text_no_memory(struct text_file *t)
{
    return text_fail(t, "not enough memory to read it");
}

/* ---- Parts of a statement ------------------------------------------------ */

static int text_value(struct text_reader *r, const char *word,
                      enum text_range range, kern_real *out)
{
    static const char *const what[] = {"a number", "a number not below zero",
                                       "a positive number"};
    kern_real value;
    if (!text_number(word, &value) || (range == TEXT_POSITIVE && !(value > 0))
        || (range == TEXT_NOT_NEGATIVE && value < 0))
        return text_expect(r, what[range], word);
    *out = value;
    return 0;
}

static int text_real(struct text_reader *r, enum text_range range,
                     kern_real *out)
{
    return text_value(r, text_next(r), range, out);
}

static int text_vec(struct text_reader *r, kern_vec *out)
{
    if (text_real(r, TEXT_ANY, &out->x))
        return -1;
    return text_real(r, TEXT_ANY, &out->y);
}

/* The slot of a name: its own, or the free one where it belongs. There are
   twice as many slots as names, so the search ends. */
static int text_slot(const struct text_reader *r, const char *name)
{
    unsigned hash = 2166136261u; /* FNV-1a */
    for (const char *s = name; *s; s++)
        hash = ((hash ^ (unsigned char)*s) * 16777619u) & 0xffffffffu;
    int i = (int)(hash & (unsigned)(r->slots - 1));
    while (r->slot[i] && strcmp(r->t->name[r->slot[i] - 1], name) != 0)
        i = (i + 1) & (r->slots - 1);
    return i;
}

static int text_block_named(struct text_reader *r, int *index)
{
    char *word = text_next(r);
    *index = r->slot[text_slot(r, word)] - 1;
    if (*index < 0)
        return text_expect(r, "the name of a block above", word);
    return 0;
}

static int text_free_block(struct text_reader *r, kern_block **out)
{
    int index;
    if (text_block_named(r, &index))
        return -1;
    *out = &r->t->block[index];
    if ((*out)->fixed)
        return text_expect(r, "a block that is not fixed", r->t->name[index]);
    return 0;
}

static int text_same(kern_vec p, kern_vec q)
{
    return p.x <= q.x && p.x >= q.x && p.y <= q.y && p.y >= q.y;
}

/* Reads vertices to the end of the line, repeated neighbours once. */
static int text_polygon(struct text_reader *r, int *vertices)
{
    kern_vec *v = r->t->vertex + r->vertices;
    int n = 0, read = 0;
    char shown[TEXT_SHOW_ROOM], about[TEXT_SHOW_ROOM + 16];
    for (;;) {
        kern_vec p;
        char *x = text_next(r);
        if (*x == '\0')
            break;
        if (text_value(r, x, TEXT_ANY, &p.x))
            return -1;
        char *y = text_next(r);
        read++;
        if (*y == '\0')
            return text_fail(r->t,
                             "%s: the number of coordinates is odd, "
                             "vertex %d has only x = %s",
                             text_about(r, about), read, text_show(shown, x));
        if (text_value(r, y, TEXT_ANY, &p.y))
            return -1;
        if (n == 0 || !text_same(p, v[n - 1]))
            v[n++] = p;
    }
    while (n > 1 && text_same(v[n - 1], v[0]))
        n--;
    *vertices = n;
    return 0;
}

/* ---- Statements ---------------------------------------------------------- */

/* Reads a friction of the file, or of blocks above. */
static int text_friction(struct text_reader *r)
{
    struct text_friction *f = &r->friction[r->frictions];
    kern_real mu = 0;
    if (text_real(r, TEXT_NOT_NEGATIVE, &mu))
        return -1;
    r->at += strspn(r->at, " \t\r");
    if (r->at >= r->end) {
        r->t->options.mu = mu;
        return 0;
    }
    f->mu = mu;
    f->b = -1;
    if (text_block_named(r, &f->a))
        return -1;
    r->at += strspn(r->at, " \t\r");
    if (r->at < r->end && text_block_named(r, &f->b))
        return -1;
    r->frictions++;
    return 0;
}

static int text_gravity(struct text_reader *r)
{
    return text_vec(r, &r->t->gravity);
}

static int text_density(struct text_reader *r)
{
    r->unused = r->t->line;
    return text_real(r, TEXT_POSITIVE, &r->density);
}

static int text_epsilon(struct text_reader *r)
{
    r->t->epsilon_line = r->t->line;
    return text_real(r, TEXT_POSITIVE, &r->t->options.epsilon);
}

/* E or E ANGLE: kern_measured_options() is the caller's to ask. */
static int text_measured(struct text_reader *r)
{
    char *word;
    r->t->turn = 0;
    if (text_real(r, TEXT_POSITIVE, &r->t->error))
        return -1;
    word = text_next(r);
    if (*word == '\0')
        return 0;
    if (text_value(r, word, TEXT_POSITIVE, &r->t->turn))
        return -1;
    return r->t->turn < (kern_real)0.5
             ? 0
             : text_expect(r, "an angle below 0.5 (in radians)", word);
}

static int text_units(struct text_reader *r)
{
    char *force;
    r->t->units = text_next(r);
    force = text_next(r);
    r->t->force_units = *force ? force : NULL;
    return *r->t->units ? 0 : text_expect(r, "a unit of length", "");
}

static int text_tolerance(struct text_reader *r)
{
    kern_options *o = &r->t->options;
    r->gap_line = r->t->line;
    o->angle = kern_defaults().angle;
    if (text_real(r, TEXT_POSITIVE, &o->gap))
        return -1;
    char *word = text_next(r);
    if (*word == '\0')
        return 0;
    if (text_value(r, word, TEXT_POSITIVE, &o->angle))
        return -1;
    if (!(o->angle < (kern_real)0.5))
        return text_expect(r, "an angle below 0.5 (in radians)", word);
    return 0;
}

static int text_polygon_fault(struct text_reader *r, const kern_block *b,
                              kern_status status, const kern_fault *fault)
{
    char about[TEXT_SHOW_ROOM + 16], place[80] = "";
    if (status == KERN_FEW_VERTICES)
        snprintf(place, sizeof place, ", read %d different ones", b->vertices);
    else if (fault->index >= 0 && fault->index < b->vertices)
        snprintf(place, sizeof place, ", at its vertex %.9g %.9g",
                 (double)b->vertex[fault->index].x,
                 (double)b->vertex[fault->index].y);
    return text_fail(r->t, "%s: %s%s%s", text_about(r, about),
                     kern_status_text(status), place,
                     status != KERN_CROSSING || b->vertices <= 50
                         ? ""
                         : "; simplify an outline of pixels first (contour.c)");
}

static int text_body(struct text_reader *r, int fixed)
{
    struct text_file *t = r->t;
    kern_block *b = &t->block[t->blocks];
    char *name = text_next(r), shown[TEXT_SHOW_ROOM];
    char about[TEXT_SHOW_ROOM + 16];
    if (*name == '\0')
        return text_expect(r, "a name", name);
    int slot = text_slot(r, name), vertices = 0, weighed = 0;
    if (r->slot[slot])
        return text_fail(t, "%s: the name '%s' was given in line %d already",
                         r->statement, text_show(shown, name),
                         t->block_line[r->slot[slot] - 1]);
    kern_real mass = 0;
    r->name = name;
    if (!fixed) {
        char *word = text_next(r);
        weighed = strcmp(word, "*") != 0;
        if (weighed && !(text_number(word, &mass) && mass > 0))
            return text_expect(r, "a mass (a positive number, or *)", word);
    }
    if (text_polygon(r, &vertices))
        return -1;

    kern_fault fault = {-1, -1, -1, 0, 0};
    const kern_vec *v = t->vertex + r->vertices;
    kern_status status = fixed ? kern_ground_init(b, v, vertices, &fault)
                               : kern_block_init(b, v, vertices, r->density,
                                                 &fault);
    b->vertex = v;
    b->vertices = vertices;
    if (status < 0)
        return text_polygon_fault(r, b, status, &fault);
    if (weighed)
        b->mass = mass;
    if (!fixed && !(b->mass > 0 && (double)b->mass <= TEXT_MOST))
        return text_fail(t, "%s: area x density is no mass, found %g",
                         text_about(r, about), (double)b->mass);

    t->name[t->blocks] = name;
    t->block_line[t->blocks++] = t->line;
    t->fixed += fixed;
    if (!fixed)
        r->unused = 0;
    r->slot[slot] = t->blocks;
    r->vertices += vertices;
    return 0;
}

static int text_fixed(struct text_reader *r) { return text_body(r, 1); }
static int text_block(struct text_reader *r) { return text_body(r, 0); }

/* Numbers that can be read may still add up to one that cannot be held. */
static int text_check_load(struct text_reader *r, const kern_wrench *load)
{
    double fx = (double)load->fx, fy = (double)load->fy;
    double torque = (double)load->torque;
    if (fx - fx + (fy - fy) + (torque - torque) >= 0)
        return 0;
    return text_fail(r->t, "%s: the load adds up to %g %g, torque %g",
                     r->statement, fx, fy, torque);
}

/* Loads read above count about the old centre; they stay in their place. */
static int text_centre(struct text_reader *r, kern_block *b, kern_vec c)
{
    kern_wrench *load[2] = {&b->load, &r->t->live[b - r->t->block]};
    for (int k = 0; k < 2; k++)
        load[k]->torque += (b->centre.x - c.x) * load[k]->fy
                         - (b->centre.y - c.y) * load[k]->fx;
    b->centre = c;
    return text_check_load(r, load[0]) || text_check_load(r, load[1]) ? -1 : 0;
}

static int text_com(struct text_reader *r)
{
    kern_block *b;
    kern_vec c;
    if (text_free_block(r, &b) || text_vec(r, &c))
        return -1;
    return text_centre(r, b, c);
}

/* Adds weight that is no stone to a block; loads stay in their place. */
static int text_weigh(struct text_reader *r, kern_block *b, kern_real mass,
                      kern_vec at)
{
    kern_real share;
    kern_vec c;
    if (!((double)b->mass + (double)mass <= TEXT_MOST))
        return text_fail(r->t, "%s: the mass adds up to %g", r->statement,
                         (double)b->mass + (double)mass);
    b->mass += mass;
    share = mass / b->mass;
    c.x = b->centre.x + share * (at.x - b->centre.x);
    c.y = b->centre.y + share * (at.y - b->centre.y);
    return text_centre(r, b, c);
}

static int text_mass(struct text_reader *r)
{
    kern_block *b;
    kern_real mass = 0;
    kern_vec at;
    if (text_free_block(r, &b) || text_real(r, TEXT_POSITIVE, &mass)
        || text_vec(r, &at))
        return -1;
    r->t->mass[r->t->masses++] = at;
    r->t->added += (double)mass;
    r->t->added_x += (double)(mass * at.x);
    r->t->added_y += (double)(mass * at.y);
    return text_weigh(r, b, mass, at);
}

static int text_load_at(struct text_reader *r)
{
    kern_block *b;
    kern_vec force, at;
    if (text_free_block(r, &b) || text_vec(r, &force) || text_vec(r, &at))
        return -1;
    kern_block_load(b, force, at, 0);
    r->t->loads++;
    return text_check_load(r, &b->load);
}

static int text_live(struct text_reader *r)
{
    kern_block *b, alone;
    kern_vec force, at;
    kern_wrench *live;
    struct text_live *axle;
    if (text_free_block(r, &b) || text_vec(r, &force) || text_vec(r, &at))
        return -1;
    live = &r->t->live[b - r->t->block];
    alone = *b;
    alone.load = *live;
    kern_block_load(&alone, force, at, 0);
    *live = alone.load;
    axle = &r->t->axle[r->t->lives++];
    axle->block = (int)(b - r->t->block);
    axle->force = force;
    axle->place = at;
    return text_check_load(r, live);
}

static int text_torque(struct text_reader *r)
{
    kern_block *b;
    kern_vec none = {0, 0};
    kern_real torque = 0;
    if (text_free_block(r, &b) || text_real(r, TEXT_ANY, &torque))
        return -1;
    kern_block_load(b, none, b->centre, torque);
    r->t->loads++;
    return text_check_load(r, &b->load);
}

static int text_contact(struct text_reader *r)
{
    struct text_contact *c = &r->contact[r->contacts];
    if (text_block_named(r, &c->a) || text_block_named(r, &c->b)
        || text_vec(r, &c->n) || text_vec(r, &c->p))
        return -1;
    c->q = c->p;
    c->mu = -1;
    c->line = r->t->line;
    char *word = text_next(r);
    if (*word && strcmp(word, "mu") != 0) {
        if (text_value(r, word, TEXT_ANY, &c->q.x)
            || text_real(r, TEXT_ANY, &c->q.y))
            return -1;
        word = text_next(r);
    }
    if (*word) {
        if (strcmp(word, "mu") != 0)
            return text_expect(r, "mu", word);
        if (text_real(r, TEXT_NOT_NEGATIVE, &c->mu))
            return -1;
    }
    r->contacts++;
    return 0;
}

/* ---- Statements about soil, mortar and stone ----------------------------- */

/* Reads an angle in degrees, between two, as radians. A small one above 0 is
   one in radians. */
static int text_degrees(struct text_reader *r, const char *what, double least,
                        double most, double *out)
{
    char *word = text_next(r);
    kern_real value = 0;
    if (!text_number(word, &value) || (double)value < least
        || (double)value > most || (value > 0 && value < 1))
        return text_expect(r, what, word);
    *out = (double)value / 57.295779513082321;
    return 0;
}

/* Reads a number into a double. */
static int text_double(struct text_reader *r, enum text_range range,
                       double *out)
{
    kern_real value = 0;
    if (text_real(r, range, &value))
        return -1;
    *out = (double)value;
    return 0;
}

static const char text_phi[] = "phi, an angle in degrees from 5 to 60";

/* Begins a record of a statement. */
static struct text_soil *text_begin_soil(struct text_reader *r,
                                         enum text_soil_kind kind)
{
    static const struct text_soil none;
    struct text_soil *s = &r->t->soil[r->t->soils];
    *s = none;
    s->kind = kind;
    s->line = r->t->line;
    s->from = -HUGE_VAL;
    s->to = HUGE_VAL;
    return s;
}

/* TOP DENSITY [phi PHI] [from X1 to X2] */
static int text_fill(struct text_reader *r)
{
    struct text_soil *s = text_begin_soil(r, TEXT_FILL);
    char *word;
    if (text_double(r, TEXT_ANY, &s->earth.top)
        || text_double(r, TEXT_POSITIVE, &s->density))
        return -1;
    word = text_next(r);
    if (strcmp(word, "phi") == 0) {
        if (text_degrees(r, text_phi, 5, 60, &s->earth.phi))
            return -1;
        word = text_next(r);
    }
    if (*word) {
        if (strcmp(word, "from") != 0)
            return text_expect(r, "phi, from or the end of the line", word);
        if (text_double(r, TEXT_ANY, &s->from))
            return -1;
        word = text_next(r);
        if (strcmp(word, "to") != 0)
            return text_expect(r, "to", word);
        word = text_next(r);
        kern_real to = 0;
        if (!text_number(word, &to) || !((double)to > s->from))
            return text_expect(r, "a number above that behind from", word);
        s->to = (double)to;
    }
    r->t->soils++;
    return 0;
}

/* Reads the level of water in earth, and its density. */
static int text_wet(struct text_reader *r, struct text_soil *s)
{
    kern_real water = 0;
    char *word;
    if (text_double(r, TEXT_ANY, &s->earth.level))
        return -1;
    word = text_next(r);
    if (!text_number(word, &water) || !(water > 0)
        || !((double)water < s->density))
        return text_expect(r, "the density of water, below that of the earth,",
                           word);
    s->earth.water = (double)water;
    return 0;
}

/* SIDE TOP DENSITY PHI DELTA [surcharge Q] [water LEVEL DENSITY] [live] */
static int text_earth(struct text_reader *r)
{
    struct text_soil *s = text_begin_soil(r, TEXT_EARTH);
    char *word = text_next(r);
    const int left = strcmp(word, "left") == 0;
    if (!left && strcmp(word, "right") != 0)
        return text_expect(r, "left or right, where the earth is,", word);
    s->side = left ? SOIL_LEFT : SOIL_RIGHT;
    if (text_double(r, TEXT_ANY, &s->earth.top)
        || text_double(r, TEXT_NOT_NEGATIVE, &s->density)
        || text_degrees(r, text_phi, 5, 60, &s->earth.phi)
        || text_degrees(r, "delta, an angle in degrees from 0 to phi", 0,
                        57.295779513082321 * s->earth.phi * (1 + 1e-12),
                        &s->earth.delta))
        return -1;
    word = text_next(r);
    if (strcmp(word, "surcharge") == 0) {
        if (text_double(r, TEXT_NOT_NEGATIVE, &s->earth.surcharge))
            return -1;
        word = text_next(r);
    }
    if (strcmp(word, "water") == 0) {
        if (text_wet(r, s))
            return -1;
        word = text_next(r);
    }
    s->live = strcmp(word, "live") == 0;
    if (*word && !s->live)
        return text_expect(r, "surcharge, water, live or the end of the line",
                           word);
    if (!(s->density > 0 || s->earth.surcharge > 0))
        return text_fail(r->t, "earth: a density above 0, or a surcharge, is "
                               "expected");
    r->t->soils++;
    return 0;
}

/* Is a point off a block, by more than a twentieth of what that is large? */
static int text_beside(const kern_block *b, kern_vec at)
{
    const double size = 0.05
                      * hypot((double)(b->box.high.x - b->box.low.x),
                              (double)(b->box.high.y - b->box.low.y));
    return (double)at.x < (double)b->box.low.x - size
        || (double)at.x > (double)b->box.high.x + size
        || (double)at.y < (double)b->box.low.y - size
        || (double)at.y > (double)b->box.high.y + size;
}

/* NAME FX FY X Y MOST */
static int text_prop(struct text_reader *r)
{
    char shown[TEXT_SHOW_ROOM];
    struct text_soil *s = text_begin_soil(r, TEXT_PROP);
    kern_block *b;
    kern_vec f;
    double length;
    if (text_free_block(r, &b) || text_vec(r, &f) || text_vec(r, &s->at)
        || text_double(r, TEXT_POSITIVE, &s->most))
        return -1;
    length = hypot((double)f.x, (double)f.y);
    if (text_beside(b, s->at))
        return text_fail(r->t,
                         "prop: a point on block '%s', which is from x = %.9g "
                         "to %.9g and from y = %.9g to %.9g, is expected, read "
                         "%.9g %.9g",
                         text_show(shown, r->t->name[b - r->t->block]),
                         (double)b->box.low.x, (double)b->box.high.x,
                         (double)b->box.low.y, (double)b->box.high.y,
                         (double)s->at.x, (double)s->at.y);
    if (!(length > 0 && length <= TEXT_MOST))
        return text_fail(r->t, "prop: a direction is expected, read %.9g %.9g",
                         (double)f.x, (double)f.y);
    s->way.x = (kern_real)((double)f.x / length);
    s->way.y = (kern_real)((double)f.y / length);
    s->block = (int)(b - r->t->block);
    r->t->soils++;
    return 0;
}

/* X FORCE [WIDTH] */
static int text_axle_at(struct text_reader *r)
{
    struct text_axle *w = &r->t->wheel[r->t->wheels];
    char *word;
    kern_real width = 0;
    w->line = r->t->line;
    w->width = 0;
    if (text_double(r, TEXT_ANY, &w->x)
        || text_double(r, TEXT_POSITIVE, &w->force))
        return -1;
    word = text_next(r);
    if (*word) {
        if (text_value(r, word, TEXT_POSITIVE, &width))
            return -1;
        w->width = (double)width;
    }
    r->t->wheels++;
    return 0;
}

static int text_bond(struct text_reader *r)
{
    return text_double(r, TEXT_POSITIVE, &r->t->bond);
}

static int text_strength(struct text_reader *r)
{
    return text_double(r, TEXT_POSITIVE, &r->t->strength);
}

/* ---- What soil does ------------------------------------------------------ */

/* The outline of all blocks from a side, and memory for it. */
struct text_surface {
    struct soil_edge *edge;
    int edges;
};

enum { TEXT_SURFACE = 400000000 /* blocks times vertices of an outline */ };

/* Finds the outline from a side. Its edges are the caller's to free. */
static inline int text_outline(struct text_file *t, enum soil_side side,
                               struct text_surface *out)
{
    size_t n = 1;
    double *corner;
    const int stones = t->blocks - t->props;
    for (int i = 0; i < stones; i++)
        n += (size_t)t->block[i].vertices;
    out->edges = 0;
    out->edge = NULL;
    if ((double)n * t->blocks > TEXT_SURFACE)
        return text_fail(t,
                         "fill, earth and axle take up to 400 million blocks "
                         "times vertices, read %d times %.0f",
                         t->blocks, (double)n);
    out->edge = malloc(n * sizeof *out->edge);
    corner = malloc(n * sizeof *corner);
    if (out->edge && corner)
        out->edges = soil_surface(t->block, stones, side, corner, out->edge);
    free(corner);
    return out->edge && corner ? 0 : text_no_memory(t);
}

/* Adds a force to the sum of a statement. */
static void text_sum(struct text_soil *s, struct soil_force f)
{
    const double was = hypot((double)s->sum.force.x, (double)s->sum.force.y);
    const double more = hypot((double)f.force.x, (double)f.force.y);
    const kern_real share = (kern_real)(more / (was + more));
    s->sum.at.x += share * (f.at.x - s->sum.at.x);
    s->sum.at.y += share * (f.at.y - s->sum.at.y);
    s->sum.force.x += f.force.x;
    s->sum.force.y += f.force.y;
    s->blocks++;
}

/* Notes a push, for when the contacts are known. */
static int text_add_push(struct text_reader *r, struct text_soil *s, int block,
                         kern_vec at, kern_vec way, double most)
{
    struct text_push *p = realloc(r->push, (size_t)(r->pushes + 1) * sizeof *p);
    if (!p)
        return text_no_memory(r->t);
    r->push = p;
    p += r->pushes++;
    p->kind = s->kind;
    p->block = block;
    p->at = at;
    p->way = way;
    p->most = most;
    s->props++;
    return 0;
}

/* Does fill lie over x? */
static int text_covers(const struct text_soil *s, double x)
{
    return s->kind == TEXT_FILL && s->from < x && s->to > x;
}

/* Orders fills from the lowest top to the highest; of two with the same top the
   first of the file lies below. */
static int text_lower(const void *a, const void *b)
{
    const struct text_soil *s = *(struct text_soil *const *)a;
    const struct text_soil *u = *(struct text_soil *const *)b;
    const int above = (s->earth.top > u->earth.top)
                    - (s->earth.top < u->earth.top);
    return above ? above : s->line - u->line;
}

/* Returns where the piece of an edge that begins at p ends: at the end of the
   edge, of a fill, or where a top of a fill crosses it. */
static kern_vec text_cut(struct text_soil *const *fill, int fills,
                         const struct soil_edge *e, kern_vec p)
{
    const double dx = (double)(e->q.x - e->p.x), dy = (double)(e->q.y - e->p.y);
    const double least = (double)p.x + 1e-9 * dx;
    double to = (double)e->q.x;
    kern_vec q = e->q;
    for (int i = 0; i < fills; i++) {
        const double rise = fill[i]->earth.top - (double)e->p.y;
        const double place[3] = {fill[i]->from, fill[i]->to,
                                 fabs(dy) > 0 ? (double)e->p.x + rise / dy * dx
                                              : HUGE_VAL};
        for (int k = 0; k < 3; k++)
            if (place[k] > least && place[k] < to && (kern_real)place[k] > p.x)
                to = place[k];
    }
    if (to < (double)e->q.x) {
        q.x = (kern_real)to;
        q.y = e->p.y + (kern_real)((to - (double)e->p.x) / dx * dy);
    }
    return q;
}

/* Adds the push of the fill that lies on a piece, under a pressure `over` of the
   fills above it. */
static int text_push_back(struct text_reader *r, struct text_soil *s, int block,
                          kern_vec p, kern_vec q, double over)
{
    const double g = -(double)r->t->gravity.y, weight = s->density * g;
    const double most = s->earth.phi > 0
                          ? soil_push_back(p, q, s->earth.top + over / weight,
                                           weight, s->earth.phi)
                          : 0;
    const kern_vec middle = {(p.x + q.x) / 2, (p.y + q.y) / 2};
    const kern_vec way = {q.y > p.y ? 1 : -1, 0};
    if (!(most > 1e-6 * (double)r->t->block[block].mass * g))
        return 0;
    s->most += most;
    return text_add_push(r, s, block, middle, way, most);
}

/* Lays the fills over a piece of the outline on it, each on the one below: a
   layer weighs its own thickness, and the lowest pushes back under all. */
static int text_layers(struct text_reader *r, struct text_soil *const *fill,
                       int fills, int block, kern_vec p, kern_vec q)
{
    struct text_file *t = r->t;
    const double g = -(double)t->gravity.y, x = (double)(p.x + q.x) / 2;
    double level = (double)(p.y + q.y) / 2, over = 0;
    struct text_soil *lowest = NULL;
    kern_vec left = p, right = q;
    for (int i = 0; i < fills; i++) {
        struct text_soil *s = fill[i];
        if (!text_covers(s, x) || !(s->earth.top > level))
            continue;
        struct soil_force f = soil_fill(left, right, s->earth.top, s->density);
        t->line = s->line;
        if (text_weigh(r, &t->block[block], -f.force.y, f.at))
            return -1;
        f.force.y *= (kern_real)g;
        text_sum(s, f);
        over += lowest ? s->density * g * (s->earth.top - level) : 0;
        lowest = lowest ? lowest : s;
        level = s->earth.top;
        left.y = right.y = (kern_real)level;
    }
    return lowest ? text_push_back(r, lowest, block, p, q, over) : 0;
}

/* Lays all fill on the upper outline. */
static int text_lay(struct text_reader *r, const struct text_surface *above)
{
    struct text_file *t = r->t;
    struct text_soil **fill = malloc((size_t)t->soils
                                     * sizeof(struct text_soil *));
    int fills = 0, bad = !fill;
    r->statement = "fill";
    for (int i = 0; i < t->soils && fill; i++)
        if (t->soil[i].kind == TEXT_FILL)
            fill[fills++] = t->soil + i;
    if (fill)
        qsort(fill, (size_t)fills, sizeof(struct text_soil *), text_lower);
    if (4.0 * fills * fills * above->edges > TEXT_SURFACE) {
        free(fill);
        return text_fail(t, "fill: %d statements over %d edges are too many",
                         fills, above->edges);
    }
    for (int i = 0; i < above->edges && !bad; i++) {
        const struct soil_edge *e = above->edge + i;
        kern_vec p = e->p;
        while (!t->block[e->block].fixed && !bad && p.x < e->q.x) {
            const kern_vec q = text_cut(fill, fills, e, p);
            bad = text_layers(r, fill, fills, e->block, p, q);
            p = q;
        }
    }
    free(fill);
    return bad && !t->message[0] ? text_no_memory(t) : bad;
}

/* Adds a force to the live load. */
static int text_add_live(struct text_reader *r, int block, struct soil_force f)
{
    struct text_file *t = r->t;
    struct text_live *l = realloc(t->axle, (size_t)(t->lives + 1) * sizeof *l);
    kern_block alone = t->block[block];
    if (!l)
        return text_no_memory(t);
    t->axle = l;
    l += t->lives++;
    t->spread++;
    l->block = block;
    l->force = f.force;
    l->place = f.at;
    alone.load = t->live[block];
    kern_block_load(&alone, f.force, f.at, 0);
    t->live[block] = alone.load;
    return text_check_load(r, &alone.load);
}

/* Adds a force on a piece of a back, as its side sees it, to the block. */
static int text_press(struct text_reader *r, struct text_soil *s, int block,
                      struct soil_force f)
{
    kern_block *b = &r->t->block[block];
    if (s->side == SOIL_LEFT) { /* seen in a mirror */
        f.force.x = -f.force.x;
        f.at.x = -f.at.x;
    }
    if (!(fabs((double)f.force.x) + fabs((double)f.force.y) > 0))
        return 0;
    text_sum(s, f);
    if (s->live)
        return text_add_live(r, block, f);
    kern_block_load(b, f.force, f.at, 0);
    return text_check_load(r, &b->load);
}

/* Returns how an edge, or the line between two, leans over the earth. */
static double text_lean_of(const struct text_soil *s, kern_vec foot,
                           kern_vec head)
{
    return (s->side == SOIL_LEFT ? -1 : 1)
         * atan2((double)(head.x - foot.x), (double)(head.y - foot.y));
}

/* Finds how the back that earth meets leans over the earth: as the line from its
   foot to its crest, or, of one over the earth, no more than any of its faces.
   The pressure is then at least that on the plane through its outermost point. */
static int text_lean(struct text_reader *r, struct text_soil *s,
                     const struct text_surface *back)
{
    struct text_file *t = r->t;
    const struct soil_earth *e = &s->earth;
    const double highest = e->water > 0 ? fmax(e->top, e->level) : e->top;
    const double rankine = 0.78539816339744831 - e->phi / 2;
    const struct soil_edge *foot = NULL, *head = NULL;
    double least = HUGE_VAL;
    for (int i = 0; i < back->edges; i++) {
        const struct soil_edge *edge = back->edge + i;
        if (t->block[edge->block].fixed || !((double)edge->p.y < highest))
            continue;
        foot = foot ? foot : edge;
        head = edge;
        least = fmin(least, text_lean_of(s, edge->p, edge->q));
    }
    if (!foot)
        return text_fail(t, "earth: no free block is below its top, %.9g",
                         highest);
    s->foot = foot->p;
    s->head = head->q;
    s->earth.lean = text_lean_of(s, foot->p, head->q);
    if (s->earth.lean > least)
        s->earth.lean = fmin(fmax(least, 0), s->earth.lean);

    /* On a back that leans farther under the earth than Rankine's plane of
       sliding, Coulomb's plane along the back is not the worst one. */
    if (s->earth.lean <= 0.79 && s->earth.lean >= -rankine - 1e-6)
        return 0;
    return text_fail(t,
                     "earth: a back that leans over the earth by at most 45 "
                     "degrees, or under it by at most 45 - phi / 2 = %.3g "
                     "degrees, is expected, read one of %.3g degrees",
                     57.295779513082321 * rankine,
                     57.295779513082321 * s->earth.lean);
}

/* Refuses fill on a back that bears the weight of the earth on it already. */
static int text_twice(struct text_file *t, const struct text_soil *s,
                      const struct text_surface *above)
{
    const double least = fmin((double)s->foot.x, (double)s->head.x);
    const double most = fmax((double)s->foot.x, (double)s->head.x);
    const double slack = 1e-6 * (double)(s->head.y - s->foot.y);
    for (int i = 0; i < above->edges && s->earth.lean < 0; i++) {
        const struct soil_edge *e = above->edge + i;
        const double p = fmax(least, (double)e->p.x);
        const double q = fmin(most, (double)e->q.x);
        for (int k = 0; k < t->soils && q - p > slack; k++) {
            const struct text_soil *f = t->soil + k;
            if (t->block[e->block].fixed || f->kind != TEXT_FILL
                || !(fmin(f->to, q) - fmax(f->from, p) > slack)
                || !(fmin(f->earth.top, s->earth.top)
                     > fmin((double)e->p.y, (double)e->q.y)))
                continue;
            return text_fail(t,
                             "earth: the back from x = %.9g to %.9g bears the "
                             "earth on it already, and the fill of line %d "
                             "lies there too: write 'from X1 to X2' in that "
                             "line, without this stretch",
                             least, most, f->line);
        }
    }
    return 0;
}

/* Presses earth and water on the outline of a side. */
static int text_back(struct text_reader *r, struct text_soil *s,
                     const struct text_surface *back)
{
    struct text_file *t = r->t;
    const double g = -(double)t->gravity.y;
    r->statement = "earth";
    s->earth.weight = s->density * g;
    s->earth.water *= g;
    if (text_lean(r, s, back))
        return -1;
    for (int i = 0; i < back->edges; i++) {
        const struct soil_edge *e = back->edge + i;
        struct soil_force force[4];
        kern_vec p = e->p, q = e->q;
        if (t->block[e->block].fixed)
            continue;
        if (s->side == SOIL_LEFT) { /* seen in a mirror */
            p.x = -p.x;
            q.x = -q.x;
        }
        soil_back(p, q, &s->earth, force);
        for (int k = 0; k < 4; k++)
            if (text_press(r, s, e->block, force[k]))
                return -1;
    }
    t->loads += !s->live;
    return 0;
}

#define TEXT_CONE 0.52359877559829887 /* 30 degrees: how far fill spreads */

/* The level on which an axle stands at x, and the cone of its spread: 0 where
   nothing lies on the outline. */
static inline double text_road(const struct text_file *t, double x,
                               double *cone)
{
    double top = -HUGE_VAL;
    for (int i = 0; i < t->soils; i++)
        if (t->soil[i].kind == TEXT_FILL && t->soil[i].from <= x
            && t->soil[i].to >= x)
            top = fmax(top, t->soil[i].earth.top);
    *cone = top > -HUGE_VAL ? TEXT_CONE : 0;
    return top;
}

/* Adds to the pattern all axles, moved by `shift`, as they reach the blocks. */
static inline void text_axles(const struct text_file *t, double shift,
                              kern_wrench *pattern)
{
    for (int k = 0; k < t->wheels; k++) {
        const struct text_axle *w = t->wheel + k;
        kern_wrench *one = calloc((size_t)t->blocks, sizeof *one);
        double cone;
        const double top = text_road(t, w->x + shift, &cone);
        if (!one)
            return;
        soil_spread(one, t->block, t->blocks - t->props, w->x + shift, w->width,
                    top, cone);
        for (int i = 0; i < t->blocks; i++) {
            if (t->block[i].fixed)
                continue;
            pattern[i].fy += (kern_real)w->force * one[i].fy;
            pattern[i].torque += (kern_real)w->force * one[i].torque;
        }
        free(one);
    }
}

/* Makes the live load of the axles: one force a block. */
static int text_drive(struct text_reader *r)
{
    struct text_file *t = r->t;
    kern_wrench *pattern = calloc((size_t)t->blocks, sizeof *pattern);
    struct text_live *axle = realloc(t->axle, (size_t)(t->lives + t->blocks)
                                                  * sizeof *axle);
    int bad = !pattern || !axle;
    const int before = t->spread;
    double all = 0, met = 0;
    if (axle)
        t->axle = axle;
    r->statement = "axle";
    t->line = t->wheel[0].line;
    if (!bad)
        text_axles(t, 0, pattern);
    for (int k = 0; k < t->wheels; k++)
        all += fabs((double)t->wheel[k].force);
    for (int i = 0; i < t->blocks && !bad; i++)
        met += fabs((double)pattern[i].fy);
    t->beside = all > 0 ? fmax(0, 1 - met / all) : 0;
    for (int i = 0; i < t->blocks && !bad; i++) {
        const kern_vec c = t->block[i].centre;
        struct text_live *l = t->axle + t->lives;
        if (!(pattern[i].fy < 0))
            continue;
        l->block = i;
        l->force.x = 0;
        l->force.y = pattern[i].fy;
        l->place.x = c.x + pattern[i].torque / pattern[i].fy;
        l->place.y = c.y;
        t->live[i].fy += pattern[i].fy;
        t->live[i].torque += pattern[i].torque;
        bad = text_check_load(r, &t->live[i]);
        t->lives++;
        t->spread++;
    }
    free(pattern);
    if (!bad && t->spread == before)
        return text_fail(t, "axle: no free block is below one");
    return bad && t->message[0] ? -1 : bad ? text_no_memory(t) : 0;
}

/* Does a statement need the outline from this side? */
static int text_sees(const struct text_file *t, enum soil_side side)
{
    int asked = 0;
    for (int i = 0; i < t->soils; i++)
        asked |= t->soil[i].kind != TEXT_PROP && t->soil[i].side == side;
    return asked;
}

/* Says why fill lies on nothing: what its range holds, and what was meant. */
static int text_no_fill(struct text_file *t, const struct text_soil *s,
                        const struct text_surface *above)
{
    char range[80] = "", shown[TEXT_SHOW_ROOM];
    const char *fixed = NULL;
    int free_blocks = 0;
    double lowest = HUGE_VAL;
    for (int i = 0; i < above->edges; i++) {
        const struct soil_edge *e = above->edge + i;
        if (!((double)e->q.x > s->from) || !((double)e->p.x < s->to))
            continue;
        if (t->block[e->block].fixed) {
            fixed = t->name[e->block];
            continue;
        }
        free_blocks = 1;
        lowest = fmin(lowest, fmin((double)e->p.y, (double)e->q.y));
    }
    if (s->to < HUGE_VAL)
        snprintf(range, sizeof range, " from x = %.9g to %.9g", s->from, s->to);
    if (free_blocks && s->earth.top > lowest)
        return text_fail(t,
                         "fill: a top above the other fill%s is expected, read "
                         "%.9g: each fill lies on those with a lower top, or "
                         "with the same one and written before, and nothing "
                         "is left of this one",
                         range, s->earth.top);
    if (free_blocks)
        return text_fail(t,
                         "fill: a top above the upper outline of a free block "
                         "is expected, read %.9g; the outline%s begins at "
                         "%.9g",
                         s->earth.top, range, lowest);
    return text_fail(t,
                     "fill: a free block below it is expected, on which it "
                     "lies; the upper outline%s is %s%s%s. Fill does not push "
                     "on an upright face: for the passive pressure of soil in "
                     "front of one write prop NAME FX FY X Y MOST, for active "
                     "pressure earth",
                     range, fixed ? "'" : "no block's",
                     fixed ? text_show(shown, fixed) : "",
                     fixed ? "', which is fixed" : "");
}

/* Does what one statement says. */
static int text_act(struct text_reader *r, struct text_soil *s,
                    const struct text_surface *seen)
{
    struct text_file *t = r->t;
    const int fill = s->kind == TEXT_FILL;
    t->line = s->line;
    if (s->kind == TEXT_PROP)
        return text_add_push(r, s, s->block, s->at, s->way, s->most);
    if ((double)(t->gravity.x * t->gravity.x) > 0 || !(t->gravity.y < 0))
        return text_fail(
            t, "%s: gravity straight down is expected, read %.9g %.9g",
            fill ? "fill" : "earth", (double)t->gravity.x,
            (double)t->gravity.y);
    if (!fill)
        return text_back(r, s, &seen[s->side])
                    || text_twice(t, s, &seen[SOIL_ABOVE])
                 ? -1
                 : 0;
    if (!r->laid && text_lay(r, &seen[SOIL_ABOVE]))
        return -1;
    r->laid = 1;
    t->line = s->line;
    return s->blocks > 0 ? 0 : text_no_fill(t, s, &seen[SOIL_ABOVE]);
}

/* Does what fill, earth, prop and axle say, but for the pushes. */
static int text_soil(struct text_reader *r)
{
    struct text_file *t = r->t;
    struct text_surface seen[3] = {{NULL, 0}, {NULL, 0}, {NULL, 0}};
    int bad = 0;
    for (int k = 0; k < 3 && !bad; k++)
        if (text_sees(t, (enum soil_side)k))
            bad = text_outline(t, (enum soil_side)k, &seen[k]);
    for (int i = 0; i < t->soils && !bad; i++)
        bad = text_act(r, t->soil + i, seen);
    if (!bad && t->wheels > 0)
        bad = text_drive(r);
    for (int k = 0; k < 3; k++)
        free(seen[k].edge);
    return bad;
}

/* ---- The file ------------------------------------------------------------ */

static int text_line(struct text_reader *r)
{
    static const struct {
        const char *name;
        int (*read)(struct text_reader *);
    } statement[] = {{"friction", text_friction}, {"gravity", text_gravity},
                     {"epsilon", text_epsilon},   {"tolerance", text_tolerance},
                     {"block", text_block},       {"fixed", text_fixed},
                     {"contact", text_contact},   {"load", text_load_at},
                     {"torque", text_torque},     {"com", text_com},
                     {"density", text_density},   {"live", text_live},
                     {"mass", text_mass},         {"measured", text_measured},
                     {"units", text_units},       {"fill", text_fill},
                     {"earth", text_earth},       {"prop", text_prop},
                     {"axle", text_axle_at},      {"bond", text_bond},
                     {"strength", text_strength}};
    char *word = text_next(r), shown[TEXT_SHOW_ROOM];
    if (*word == '\0')
        return 0;
    for (size_t i = 0; i < sizeof statement / sizeof *statement; i++) {
        if (strcmp(word, statement[i].name) != 0)
            continue;
        r->statement = statement[i].name;
        r->name = NULL;
        if (statement[i].read(r))
            return -1;
        word = text_next(r);
        return *word ? text_expect(r, "the end of the line", word) : 0;
    }
    return text_fail(r->t, "unknown statement '%s'", text_show(shown, word));
}

/* Does the statement at s begin with this word? A count from above will do. */
static int text_begins(const char *s, const char *word)
{
    return strncmp(s, word, strlen(word)) == 0;
}

/* Takes all memory at once, so that nothing moves later. A coordinate takes
   two bytes at least: a line of n bytes holds at most n / 4 + 1 vertices. */
static int text_make_room(struct text_reader *r, size_t length)
{
    struct text_file *t = r->t;
    size_t blocks = 1, contacts = 1, vertices = 1, points = 1, soils = 1;
    size_t wheels = 1, frictions = 1;
    for (size_t i = 0, n; i < length; i += n + 1) {
        const char *line = t->text + i, *end = memchr(line, '\n', length - i);
        n = end ? (size_t)(end - line) : length - i;
        line += strspn(line, " \t\r");
        contacts += (size_t)text_begins(line, "contact");
        points += (size_t)(text_begins(line, "live")
                           | text_begins(line, "mass"));
        soils += (size_t)(text_begins(line, "fill") | text_begins(line, "earth")
                          | text_begins(line, "prop"));
        wheels += (size_t)text_begins(line, "axle");
        frictions += (size_t)text_begins(line, "friction");
        if (!text_begins(line, "block") && !text_begins(line, "fixed"))
            continue;
        blocks++;
        vertices += n / 4 + 1;
    }
    for (r->slots = 4; (size_t)r->slots < 2 * blocks;)
        r->slots *= 2;
    r->slot = calloc((size_t)r->slots, sizeof *r->slot);
    r->contact = calloc(contacts, sizeof *r->contact);
    t->block = calloc(blocks, sizeof *t->block);
    t->live = calloc(blocks, sizeof *t->live);
    t->axle = calloc(points, sizeof *t->axle);
    t->mass = calloc(points, sizeof *t->mass);
    t->name = calloc(blocks, sizeof *t->name);
    t->block_line = calloc(blocks, sizeof *t->block_line);
    t->vertex = calloc(vertices, sizeof *t->vertex);
    t->contact = calloc(2 * contacts, sizeof *t->contact);
    t->own_mu = calloc(2 * contacts, sizeof *t->own_mu);
    t->soil = calloc(soils, sizeof *t->soil);
    t->wheel = calloc(wheels, sizeof *t->wheel);
    r->friction = calloc(frictions, sizeof *r->friction);
    const void *const taken[] = {r->slot,     r->contact,   t->block, t->live,
                                 t->axle,     t->mass,      t->name,  t->vertex,
                                 t->contact,  t->own_mu,    t->soil,  t->wheel,
                                 r->friction, t->block_line};
    for (size_t i = 0; i < sizeof taken / sizeof *taken; i++)
        if (!taken[i])
            return text_no_memory(t);
    return 0;
}

/* What only the whole file tells. */
static int text_check(struct text_reader *r)
{
    struct text_file *t = r->t;
    const kern_real size = kern_mean_size(t->block, t->blocks);
    if (r->unused) {
        t->line = r->unused;
        return text_fail(t, "density: expected a block after it, found none");
    }
    if (t->blocks == 0)
        return text_fail(t, "there is no block in the file ('block NAME MASS "
                            "X1 Y1 X2 Y2 X3 Y3 ...')");
    if (t->blocks == t->fixed)
        return text_fail(t, "no block is free, read %d fixed up to the end",
                         t->fixed);
    if (t->options.gap > size && r->contacts == 0) {
        t->line = r->gap_line;
        return text_fail(t,
                         "tolerance: a gap up to the mean size of the "
                         "blocks, %.4g, is expected, read %.9g",
                         (double)size, (double)t->options.gap);
    }
    return 0;
}

static int text_lines(struct text_reader *r, size_t length)
{
    struct text_file *t = r->t;
    char *next = t->text, *stop = t->text + length;
    while (next < stop) {
        size_t left = (size_t)(stop - next);
        char *line = next, *end = memchr(line, '\n', left);
        next = end ? end + 1 : stop;
        if (!end)
            end = stop;
        t->line++;
        if (memchr(line, '\0', (size_t)(end - line)))
            return text_fail(t, "a NUL byte; this is not text");
        *end = '\0';
        r->at = line;
        r->end = line + strcspn(line, "#");
        *r->end = '\0';
        if (text_line(r))
            return -1;
    }
    if (t->line == 0)
        t->line = 1;
    return text_check(r) || text_soil(r);
}

/* A normal may be too short to tell its direction. */
static int text_is_unit(kern_vec n)
{
    kern_real square = n.x * n.x + n.y * n.y;
    return square > (kern_real)0.9 && square < (kern_real)1.1;
}

/* Makes the explicit contacts, now that the whole file is known. */
static int text_given(struct text_reader *r)
{
    struct text_file *t = r->t;
    for (int i = 0; i < r->contacts; i++) {
        const struct text_contact *c = &r->contact[i];
        char a[TEXT_SHOW_ROOM], b[TEXT_SHOW_ROOM];
        kern_contact *out = t->contact + t->contacts;
        int made;
        out->a = c->a;
        out->b = c->b;
        out->n = c->n;
        out->p = c->p;
        out->mu = c->mu < 0 ? t->options.mu : c->mu;
        made = kern_contact_make(out, c->q, &t->options);
        if (made > 0 && !text_is_unit(out->n))
            made = KERN_BAD_NORMAL;
        if (made < 0) {
            t->line = c->line;
            return text_fail(t,
                             "contact '%s' '%s': %s, read normal %.9g %.9g, "
                             "points %.9g %.9g and %.9g %.9g",
                             text_show(a, t->name[c->a]),
                             text_show(b, t->name[c->b]),
                             kern_status_text((kern_status)made),
                             (double)c->n.x, (double)c->n.y, (double)c->p.x,
                             (double)c->p.y, (double)c->q.x, (double)c->q.y);
        }
        /* Two fixed blocks do nothing to each other. */
        if (t->block[c->a].fixed && t->block[c->b].fixed)
            continue;
        for (int k = 0; k < made; k++)
            t->own_mu[t->contacts++] = (char)!(c->mu < 0);
    }
    return 0;
}

/* Finds the contacts between all blocks, in *contact, which grows as they need
   and is the caller's to free. Returns how many there are, KERN_NO_SPACE where
   memory is lacking, or a status below 0 with the blocks in *fault. */
static inline int text_all_contacts(const kern_block *block, int blocks,
                                    const kern_options *options,
                                    kern_contact **contact, kern_fault *fault)
{
    int *index = calloc((size_t)(2 * blocks) + 1, sizeof *index);
    kern_work work = kern_work_of(NULL, 0, index, 2 * blocks);
    int found = KERN_NO_SPACE;
    for (int room = 16 * blocks + 64;
         index && found == KERN_NO_SPACE && room < INT_MAX / 8; room *= 2) {
        kern_contact *more = realloc(*contact, (size_t)room * sizeof *more);
        if (!more)
            break;
        *contact = more;
        found = kern_contacts(block, blocks, options, *contact, room, &work);
    }
    *fault = work.fault;
    free(index);
    return found;
}

/* Finds the contacts between all blocks, as the file's options say. */
static int text_find(struct text_reader *r)
{
    struct text_file *t = r->t;
    const kern_real size = kern_mean_size(t->block, t->blocks);
    kern_options options = t->options;
    kern_fault fault;
    char *own;
    int found;
    if (t->error > 0)
        options = kern_measured_options(
            &options, t->error, t->turn > 0 ? t->turn : t->error / size);
    found = text_all_contacts(t->block, t->blocks, &options, &t->contact,
                              &fault);
    if (found == KERN_NO_SPACE)
        return text_no_memory(t);
    if (found < 0) {
        const int i = fault.block, j = fault.other;
        char one[TEXT_SHOW_ROOM], two[TEXT_SHOW_ROOM];
        t->line = i < 0 ? 0 : t->block_line[i > j ? i : j];
        return text_fail(
            t, "block '%s'%s%s%s: %s", i < 0 ? "" : text_show(one, t->name[i]),
            j < 0 ? "" : " and '", j < 0 ? "" : text_show(two, t->name[j]),
            j < 0 ? "" : "'", kern_status_text((kern_status)found));
    }
    own = realloc(t->own_mu, (size_t)found + 1);
    if (!own)
        return text_no_memory(t);
    memset(own, 0, (size_t)found + 1);
    t->own_mu = own;
    t->contacts = found;
    t->found = 1;
    return 0;
}

/* Sets the friction of a contact from those of its blocks: that of the pair, or
   else the least of both. */
static void text_set_friction(const struct text_reader *r, int k)
{
    kern_contact *c = &r->t->contact[k];
    kern_real mu[2] = {-1, -1}, pair = -1;
    for (int i = 0; i < r->frictions; i++) {
        const struct text_friction *f = r->friction + i;
        const int same = (f->a == c->a && f->b == c->b)
                      || (f->a == c->b && f->b == c->a);
        if (same)
            pair = f->mu;
        if (f->b < 0 && f->a == c->a)
            mu[0] = f->mu;
        if (f->b < 0 && f->a == c->b)
            mu[1] = f->mu;
    }
    if (pair < 0)
        pair = mu[0] < 0 || (mu[1] >= 0 && mu[1] < mu[0]) ? mu[1] : mu[0];
    if (pair < 0 || r->t->own_mu[k])
        return;
    c->mu = pair;
    r->t->own_mu[k] = 1;
}

/* Makes room for pushes: blocks, names, and contact points. */
static int text_prop_room(struct text_reader *r)
{
    struct text_file *t = r->t;
    const size_t n = (size_t)(t->blocks + r->pushes);
    const size_t points = (size_t)(t->contacts + 2 * r->pushes);
    kern_block *block = realloc(t->block, n * sizeof *block);
    if (block)
        t->block = block;
    kern_wrench *live = realloc(t->live, n * sizeof *live);
    if (live)
        t->live = live;
    char **name = realloc(t->name, n * sizeof *name);
    if (name)
        t->name = name;
    int *line = realloc(t->block_line, n * sizeof *line);
    if (line)
        t->block_line = line;
    kern_contact *contact = realloc(t->contact, points * sizeof *contact);
    if (contact)
        t->contact = contact;
    char *own = realloc(t->own_mu, points);
    if (own)
        t->own_mu = own;
    t->prop_vertex = calloc((size_t)r->pushes, 4 * sizeof *t->prop_vertex);
    t->prop_name = calloc((size_t)r->pushes, 16);
    return block && live && name && line && contact && own && t->prop_vertex
                && t->prop_name
             ? 0
             : text_no_memory(t);
}

/* Makes a block of each push, and its contacts: first of props, then of fill. */
static int text_props(struct text_reader *r)
{
    struct text_file *t = r->t;
    const double size = (double)kern_mean_size(t->block, t->blocks);
    int floor = 0, number = 0;
    if (r->pushes == 0)
        return 0;
    while (floor < t->blocks && !t->block[floor].fixed)
        floor++;
    if (floor == t->blocks)
        return text_fail(t, "a fixed block is expected, from which props and "
                            "fill push, read none");
    if (text_prop_room(r))
        return -1;
    for (int k = 0; k < 2 * r->pushes; k++) {
        const struct text_push *p = r->push + k % r->pushes;
        const int i = t->blocks;
        char *name = t->prop_name + 16 * t->props;
        if ((p->kind == TEXT_FILL) != (k >= r->pushes))
            continue;
        const int bad = soil_prop(t->block, i, t->prop_vertex + 4 * t->props,
                                  t->contact + t->contacts, &t->options, floor,
                                  p->block, p->at, p->way, p->most, t->gravity,
                                  size);
        if (bad < 0)
            return text_fail(t, "a push of up to %g on '%s': %s", p->most,
                             t->name[p->block],
                             kern_status_text((kern_status)bad));
        do
            snprintf(name, 16, "prop%d", ++number);
        while (r->slot[text_slot(r, name)]);
        t->name[i] = name;
        t->block_line[i] = t->block_line[p->block];
        memset(&t->live[i], 0, sizeof t->live[i]);
        memset(t->own_mu + t->contacts, 1, 2);
        t->contacts += 2;
        t->blocks++;
        t->props++;
    }
    return 0;
}

/* Makes the contacts that statements give or need, and what acts in them. */
static int text_contacts(struct text_reader *r)
{
    struct text_file *t = r->t;
    if (text_given(r))
        return -1;
    t->given = r->contacts > 0 || r->frictions > 0 || r->pushes > 0
            || t->bond > 0 || t->strength > 0;
    if (!t->given)
        return 0;
    if (r->contacts == 0 && text_find(r))
        return -1;
    for (int k = 0; k < t->contacts; k++)
        text_set_friction(r, k);
    if (t->bond > 0) {
        soil_bond(t->block, t->contact, t->contacts, t->bond);
        t->loads++;
    }
    if (text_props(r))
        return -1;
    kern_contact_travels(t->contact, t->contacts);
    return 0;
}

/* Frees what text_read() or text_load() took, also after an error. */
static inline void text_free(struct text_file *t)
{
    free(t->block);
    free(t->live);
    free(t->axle);
    free(t->mass);
    free(t->name);
    free(t->block_line);
    free(t->contact);
    free(t->own_mu);
    free(t->text);
    free(t->vertex);
    free(t->soil);
    free(t->wheel);
    free(t->prop_vertex);
    free(t->prop_name);
    t->soil = NULL;
    t->wheel = NULL;
    t->prop_vertex = NULL;
    t->prop_name = NULL;
    t->block = NULL;
    t->live = NULL;
    t->axle = NULL;
    t->mass = NULL;
    t->name = NULL;
    t->block_line = NULL;
    t->contact = NULL;
    t->own_mu = NULL;
    t->text = NULL;
    t->vertex = NULL;
}

/* Reads a structure from any bytes; they may go afterwards. Returns 0, or -1
   with `line` and `message`. Call text_free() in both cases. */
static inline int text_read(struct text_file *t, const char *data,
                            size_t length)
{
    static const struct text_file empty;
    *t = empty;
    t->gravity.y = (kern_real)-9.81;
    t->options = kern_defaults();
    if (length >= TEXT_LONGEST)
        return text_fail(t, "the file is too long, %.0f MB or more",
                         (double)TEXT_LONGEST / 1e6);
    if (length >= 3 && memcmp(data, "\xef\xbb\xbf", 3) == 0) {
        data += 3; /* a byte order mark */
        length -= 3;
    }
    t->text = malloc(length + 1);
    if (!t->text)
        return text_no_memory(t);
    if (length > 0)
        memcpy(t->text, data, length);
    t->text[length] = '\0';

    struct text_reader r = {t,    NULL, NULL, "", 1,    0, 0,    NULL, 0,
                            NULL, 0,    NULL, 0,  NULL, 0, NULL, 0,    0};
    int bad = text_make_room(&r, length) || text_lines(&r, length)
           || text_contacts(&r);
    free(r.slot);
    free(r.contact);
    free(r.friction);
    free(r.push);
    return bad ? -1 : 0;
}

/* Reads a file to its end, or to where text_read() will refuse it: a NUL byte,
   or too much of it. Some files have no end. Returns NULL with errno where that
   fails. A 0 follows the bytes. */
static inline char *text_slurp(FILE *in, size_t *length)
{
    size_t room = 1 << 16, n;
    char *data = malloc(room);
    *length = 0;
    while (data && (n = fread(data + *length, 1, room - 1 - *length, in)) > 0) {
        const char *read = data + *length;
        *length += n;
        if (*length >= TEXT_LONGEST || memchr(read, '\0', n))
            break;
        if (*length + 1 < room)
            continue;
        char *more = realloc(data, 2 * room);
        if (!more)
            free(data);
        data = more;
        room *= 2;
    }
    if (data && ferror(in)) {
        free(data);
        return NULL;
    }
    if (data)
        data[*length] = '\0';
    return data;
}

/* text_read() of a file, "-" for standard input. */
static inline int text_load(struct text_file *t, const char *path)
{
    int standard = strcmp(path, "-") == 0;
    size_t length;
    errno = 0;
    FILE *in = standard ? stdin : fopen(path, "rb");
    char *data = in ? text_slurp(in, &length) : NULL;
    int error = errno;
    if (in && !standard)
        fclose(in);
    if (!data) {
        static const struct text_file empty;
        *t = empty;
        return text_fail(t, "cannot be read: %s", strerror(error));
    }
    int bad = text_read(t, data, length);
    free(data);
    return bad;
}

#endif /* TEXT_H */
