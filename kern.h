/* kern.h 0.1.0: how safely does a dry-stacked structure stand?

   A header-only C library for robots that build with found stones and no
   mortar. It finds the contacts between polygons, contact forces that hold
   every stone, and how far every contact interface (its kern) can shrink until
   no forces exist: a measure of stability. Each verdict comes with a proof
   that was checked before it is returned.

   SPDX-License-Identifier: MIT (text at the end of the file)

   CONTENTS: search for the tags
     I    Manual            >>what >>use >>conventions >>memory >>verdicts
                            >>config >>method >>measures >>limits
                            >>determinism >>misra >>references
     II   Declarations      >>decl >>types >>sizes >>api
     III  Implementation    >>impl >>tol >>vec >>polygon >>contact >>work >>lp
                            >>check >>statics >>proof >>model >>kern >>words


   WHAT IT COMPUTES                                                    >>what

        +-----------+               A stone on two others. Each bed is a line
        |     2     |               contact, and its load may pass anywhere
        +--====-====+               along it (====). Shrink every contact by
      +------+ +------+             the same distance d from both ends:
      |   0  | |   1  |
      +------+ +------+             d = 0       |==========|   stands
     ==================             d           |===    ===|   what is left in
                                    d*             |====|      the middle is
                                                               the kern

   The largest d at which forces in equilibrium still exist is the margin d*.
   The level is Algorithm 1 of the paper: the number of steps of size epsilon
   after which they exist no longer. A structure that falls anyway has level 0
   and a deficit: how much larger its contacts would have to be.


   HOW TO USE IT                                                        >>use

   In one C or C++ file of the program, before the header is included:

       #define KERN_IMPLEMENTATION
       #include "kern.h"

   and everywhere else #include "kern.h" alone. Nothing else is needed than
   sqrt() (link -lm where the compiler wants it).

       kern_vec ground[4] = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
       kern_vec stone[4]  = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
       kern_block block[2];
       kern_contact contact[8];
       kern_real real[KERN_REALS(2, 8)];
       int index[KERN_INTS(2, 8)];
       kern_work work = kern_work_of(real, KERN_REALS(2, 8),
                                     index, KERN_INTS(2, 8));
       kern_options options = kern_defaults();
       kern_structure s = {block, 2, contact, 0, {0, -9.81}};
       kern_margin m;

       kern_block_init(&block[0], ground, 4, 0, NULL);       fixed
       kern_block_init(&block[1], stone, 4, 2400, NULL);     2400 kg/m^2
       s.contacts = kern_contacts(block, 2, &options, contact, 8, NULL);
       if (kern_measure(&s, &options, &work, &m, NULL) == KERN_STANDS)
           printf("level %d, margin %g m\n", m.level, m.margin);

   Check what each call returns: examples/one_block.c is the same program with
   the checks, examples/kern.c the program for the command line.

   multiple definition of kern_...: KERN_IMPLEMENTATION is in more than one
   file. undefined reference to kern_...: it is in none, or that file was
   compiled in the other precision (KERN_SINGLE).


   CONVENTIONS                                                  >>conventions

   Length, mass and time are in units of your choice, used throughout; comments
   say m, kg, s. Angles are in radians, counter-clockwise positive. The world
   is a plane: think of one unit of depth, and of a density per area.

   Blocks are polygons in world coordinates, so a planner that tries a stone in
   many places moves its vertices, and everything that the library sees is
   data which the caller can print, edit or make by other means: contacts may
   come from polygons, a camera or a tactile sensor. A contact is a point, with
   a normal n from block a into block b and the tangent t = (-n.y, n.x); a line
   contact is two points. A point carries its own direction and length of
   shrinkage, so that lines, pairs and groups of points are one thing. Points
   of one stone follow each other, so a stone on top is taken back by making
   `contacts` smaller.

   The size of a block is the square root of its area. Found contacts of a pair
   accept gaps and overlaps up to 1/1000 of the size of the smaller free block.


   MEMORY                                                            >>memory

   The library allocates nothing, has no globals and no recursion, and keeps
   nothing between calls: it may be used from any number of threads, each with
   its own work memory. Work memory is two plain arrays, sized by the constant
   expressions KERN_REALS(blocks, contacts) and KERN_INTS(blocks, contacts),
   or by the function kern_work_need() at run time. Contacts are counted as
   contact points: a running bond has about seven for a block, twelve with the
   joints between neighbours.

   Bytes of work memory, double (float is about half):

       blocks and contact points    5, 20    10, 60   30, 140  100, 600
       KERN_REALS, bytes             5,720    16,960    47,328   213,568
       KERN_INTS, bytes              1,100     2,680     6,792    25,392


   VERDICTS AND PROOFS                                             >>verdicts

   A call that returns KERN_STANDS found forces which pass kern_check_forces(),
   one that returns KERN_FALLS a motion which passes kern_check_motion(). The
   checks use nothing of the solver. What passes neither is KERN_UNDECIDED:
   never a guess. It happens within some 1e-9 of critical, if at all.

   "Stands" means that forces exist which are admissible: no tension, friction
   in its cone. See >>limits.

   Where a call returns less than 0 the work memory's `fault` says where the
   fault lies, kern_status_text() says what was expected, and nothing else of
   the caller's was changed.


   CONFIGURATION                                                     >>config

   KERN_IMPLEMENTATION  in one file: the implementation
   KERN_STATIC          in a file that wants a private copy of everything
   KERN_API             linkage of public functions; extern
   KERN_SINGLE          kern_real is float; the same in every file
   KERN_SQRT(x)         in place of sqrt or sqrtf and of <math.h>
   KERN_USE_GLPK        large programs go to GLPK: see kern_lp.h, and what it
                        says about the licence
   KERN_GLPK_ROWS       rows above which they do (three a free block); 96


   METHOD                                                            >>method

   Names of the paper and of this file: alpha (friction) `mu`, epsilon
   `epsilon`, f_n and f_r `normal` and `tangential`, A_eq the columns of
   >>model, w the right-hand side.

   Every free block i is in equilibrium, Eqs. (1) to (3):

       sum f n + r t + weight = 0,     sum (p - c) x (f n + r t) = 0,

   with contact forces that press and stick, Eq. (4):  f >= 0, |r| <= mu f.
   In the plane that cone is spanned by its two edges n + mu t and n - mu t.
   Counting forces along the edges, all this is Eq. (5):

       find x >= 0 with A x = -w:

   three rows a free block, two columns a contact point. If there is no such x
   there is, by Farkas' lemma, a y with y.A >= 0 and y.w > 0: a velocity and a
   spin of every block such that no contact closes and the weights do work. It
   is the collapse mechanism, and the proof that nothing holds it.

   Algorithm 1 moves the contact points inward step by step and solves again.
   Only the torques change, so the next solution starts from the last. The
   margin is found by Newton's method on y (>>kern): some ten solutions, most
   of them without a pivot.


   WHAT EACH NUMBER IS GOOD FOR                                    >>measures

   level       comparing structures and places for a stone, as in the paper
   margin      the same, exact: how far the worst stone is from the edge of
               what carries it. In metres, so large stones weigh more; relative
               mode counts shares of each contact instead
   load factor the largest sideways acceleration, in units of gravity
   tilt        the angle to which the ground may turn
   deficit     how much is missing, where it falls
   mechanism   which stones go first, and how
   All of these belong to the weakest place of a structure.


   LIMITS                                                            >>limits

   Two dimensions; rigid blocks that do not break; statics. That admissible
   forces exist is necessary for standing still. With friction it is not
   sufficient: a cube held between two walls only by friction is held by forces
   that nothing raises, and counts as standing. Mechanisms are those of limit
   analysis: blocks that slide also part (the sliding of a mechanism is
   dilatant).

   In float the proofs are weaker (tolerances in >>impl) and near to critical
   more is undecided; coordinates should not be far from the origin.


   DETERMINISM                                                  >>determinism

   The same input gives the same bits on every machine with IEEE arithmetic,
   if the compiler keeps to it:

       -ffp-contract=off     where the target has fused multiply-add (AArch64,
                             PowerPC, s390x, x86 with -mfma); gcc contracts by
                             default in GNU modes, clang from version 14 on
       -msse2 -mfpmath=sse   on 32-bit x86
       never -ffast-math, -Ofast or -funsafe-math-optimizations, nor where the
                             program is linked: they flush small numbers to 0

   Only + - * / and square root are used, and KERN_SQRT must round as IEEE asks.
   tests/golden.c compares a hash of all results, and notices wrong flags.


   MISRA                                                             >>misra

   There is no claim of compliance. From these rules of MISRA C:2012 the header
   deviates with intent:

   2.5, 8.7          macros and functions that are there for the caller
   10.3, 10.4, 10.8  small whole numbers among kern_real, and indices among int
                     and enum: they are exact
   11.5              an array that is free for the moment holds something else
   12.1, 12.3        precedence without brackets where it is that of algebra;
                     variables of one kind declared together
   13.3, 13.4        indices that count on in passing, as in p[n++]
   14.1, 14.2, 14.4  loops over steps that grow; pointers and flags as
                     conditions
   15.5, 15.7        a function that refuses does so in its first lines
   16.4              no default where the compiler can tell which one is missing
   17.8              a parameter serves as the variable that it starts
   18.4              a slice of an array is a pointer into it
   20.1, 20.5        one file holds declarations and implementation; the list of
                     statuses is expanded twice


   REFERENCES                                                    >>references

   The paper: the kern-based measure and Algorithm 1 for planning dry stacking
   with irregular stones (Thangavelu, Napp and others). Limit analysis by
   linear programming: R. K. Livesley, Limit analysis of structures formed from
   rigid blocks, Int. J. Numer. Meth. Engng 12 (1978). Bland's rule: R. G.
   Bland, New finite pivoting rules for the simplex method, Math. Oper. Res. 2
   (1977).

   0.1.0  first version */

/* ==== Part II: Declarations ======================================== >>decl */

#ifndef KERN_H
#define KERN_H

#define KERN_VERSION "0.1.0"

#if defined(KERN_IMPL) || defined(KERN_IMPLEMENT)
#error "kern.h: the implementation is asked for with KERN_IMPLEMENTATION"
#endif
#if defined(KERN_FLOAT) || defined(KERN_DOUBLE)
#error "kern.h: float is asked for with KERN_SINGLE, double is the default"
#endif
#if defined(KERN_GLPK) || defined(USE_GLPK)
#error "kern.h: GLPK is asked for with KERN_USE_GLPK"
#endif

#ifdef KERN_SINGLE
typedef float kern_real;
/* Symbols of their own: a file compiled in the other precision fails when it
   is linked, not when it runs, and one program may hold both. */
#define kern_block_init      kern_block_init_f32
#define kern_block_load      kern_block_load_f32
#define kern_check_forces    kern_check_forces_f32
#define kern_check_motion    kern_check_motion_f32
#define kern_contact_at      kern_contact_at_f32
#define kern_contact_make    kern_contact_make_f32
#define kern_contact_travels kern_contact_travels_f32
#define kern_contacts        kern_contacts_f32
#define kern_defaults        kern_defaults_f32
#define kern_deficit         kern_deficit_f32
#define kern_load_factor     kern_load_factor_f32
#define kern_lp_solve        kern_lp_solve_f32
#define kern_mean_size       kern_mean_size_f32
#define kern_measure         kern_measure_f32
#define kern_stands          kern_stands_f32
#define kern_status_text     kern_status_text_f32
#define kern_tilt            kern_tilt_f32
#define kern_touch           kern_touch_f32
#define kern_work_need       kern_work_need_f32
#define kern_work_of         kern_work_of_f32
#else
typedef double kern_real;
#endif

#ifdef KERN_STATIC
#if defined(__GNUC__) || defined(__clang__)
#define KERN_API static __attribute__((unused))
#else
#define KERN_API static
#endif
#endif
#ifndef KERN_API
#define KERN_API extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Types ------------------------------------------------------- >>types */

typedef struct kern_vec { kern_real x, y; } kern_vec;

/* What a call says. Zero and above is a verdict: its proof was found and
   checked. Below zero there is none, and of what the caller handed in only the
   counters and the fault of the work memory have changed. */
#define KERN_STATUS_LIST(X)                                                   \
    X(KERN_STANDS, 0, "stands: forces were found that hold every block")      \
    X(KERN_FALLS, 1, "falls: a motion was found that no forces can stop")     \
    X(KERN_UNBOUNDED, 2, "unbounded: the cost falls without end")             \
    X(KERN_UNDECIDED, -1, "undecided: neither proof could be completed")      \
    X(KERN_NO_SPACE, -2, "an array is too short for the result or the work")  \
    X(KERN_BAD_POINTER, -3, "a pointer is null where an array is expected")   \
    X(KERN_BAD_NUMBER, -4, "a number is infinite or not a number")            \
    X(KERN_BAD_COUNT, -5, "a count is negative or above its limit")          \
    X(KERN_FEW_VERTICES, -6, "a polygon has fewer than three vertices")       \
    X(KERN_NO_AREA, -7, "a polygon has no area")                              \
    X(KERN_CROSSING, -8, "a polygon crosses or touches itself")               \
    X(KERN_BAD_MASS, -9, "a mass or density is not positive")                 \
    X(KERN_BAD_FRICTION, -10, "a coefficient of friction is negative")        \
    X(KERN_BAD_OPTION, -11, "an option is out of its range")                  \
    X(KERN_BAD_BLOCK, -12, "a contact names a block that does not exist")     \
    X(KERN_SAME_BLOCK, -13, "a contact names the same block twice")           \
    X(KERN_BAD_NORMAL, -14, "the normal of a contact has no direction")       \
    X(KERN_BAD_LINE, -15, "a line contact does not lie along its tangent")    \
    X(KERN_OVERLAP, -16, "two blocks overlap deeper than the gap tolerance")  \
    X(KERN_NO_FREE, -17, "no block is free")                                  \
    X(KERN_BAD_STEP, -18, "the step needs more than 1,000,000 levels")

typedef enum kern_status {
#define KERN_STATUS_NAME(name, value, text) name = value,
    KERN_STATUS_LIST(KERN_STATUS_NAME)
#undef KERN_STATUS_NAME
    KERN_STATUS_LEAST = -18 /* the same number */
} kern_status;

/* Where the fault lies of which a status below zero speaks. */
typedef struct kern_fault {
    int block;            /* index of a block, -1: none                       */
    int other;            /* the other block of an overlap, -1: none          */
    int index;            /* vertex of the polygon or contact point, -1: none */
    kern_real value;      /* the number that was found, 0: none               */
} kern_fault;

/* A force [N] and a counter-clockwise torque [N m] about a centre of mass. */
typedef struct kern_wrench { kern_real fx, fy, torque; } kern_wrench;

/* A stone, or a piece of ground. kern_block_init() fills it from a polygon in
   world coordinates; mass, centre and load may be changed afterwards. */
typedef struct kern_block {
    const kern_vec *vertex; /* simple polygon, the caller's [m]; NULL: none,
                               for a block whose contacts are given           */
    int vertices;           /* >= 3; 0 with vertex NULL                       */
    int fixed;              /* nonzero: ground, exerts whatever is needed     */
    kern_real area;         /* [m^2], < 0 if the polygon runs clockwise; the
                               block's size is the square root of |area|      */
    kern_real mass;         /* [kg] > 0; of fixed blocks not read             */
    kern_vec centre;        /* centre of mass [m]                             */
    kern_wrench load;       /* acts besides the weight, at the centre         */
} kern_block;

/* A contact point. Block b feels the force  f n + r t  at p, block a the
   opposite; t = (-n.y, n.x). The two ends of a line contact are neighbours in
   the array. A point carries its own direction and length of shrinkage, so
   lines, pairs and groups of points are one thing to the statics. */
typedef struct kern_contact {
    int a, b;             /* blocks, a != b                                   */
    int line;             /* nonzero: one end of a line contact               */
    kern_vec p;           /* place [m]                                        */
    kern_vec n;           /* unit normal from a into b                        */
    kern_real mu;         /* coefficient of friction >= 0                     */
    kern_real travel;     /* way along t to the closed kern, signed [m]: at
                             shrinkage d the point acts at p + s t, s = travel
                             cut to [-d, d], or s = d travel if relative      */
} kern_contact;

typedef struct kern_structure {
    const kern_block *block;
    int blocks;
    const kern_contact *contact;
    int contacts;         /* contact points                                   */
    kern_vec gravity;     /* acceleration [m/s^2], on Earth (0, -9.81)        */
} kern_structure;

typedef struct kern_options { /* always start from kern_defaults()            */
    kern_real mu;         /* friction of contacts found from polygons; 0.4    */
    kern_real gap;        /* widest gap that is a contact [m]; 0: 1e-3 of the
                             size of the pair's smaller free block            */
    kern_real angle;      /* widest angle between touching edges [rad], < 0.5;
                             0.0174533                                        */
    kern_real epsilon;    /* step of Algorithm 1 [m]; 0: 0.02 mean block size;
                             relative: a share, 0: 0.05                       */
    int relative;         /* nonzero: shrinkage is a share of each travel     */
    int pivots;           /* most pivots of a linear program; 0: by its size  */
} kern_options;

/* Of a contact point [N], and of a block: velocity of its centre and spin. */
typedef struct kern_force { kern_real normal, tangential; } kern_force;
typedef struct kern_motion { kern_real vx, vy, spin; } kern_motion;

/* Where to put the proof: arrays of the caller, each may be NULL. Measures use
   them on the way, so after a status below zero their contents mean nothing. */
typedef struct kern_proof {
    kern_force *force;    /* one a contact point: written with KERN_STANDS    */
    kern_motion *motion;  /* one a block, fixed ones rest: with KERN_FALLS    */
} kern_proof;

typedef struct kern_margin {
    kern_real margin;     /* d*, the shrinkage up to which it stands [m]      */
    kern_real holds;      /* largest shrinkage known to stand, proven         */
    kern_real fails;      /* smallest known to fall, proven; `most` if none   */
    kern_real most;       /* d_max: every kern is closed [m]; relative: 1     */
    kern_real epsilon;    /* step that was used                               */
    int level;            /* Algorithm 1; -1: a verdict it needs is undecided */
    int saturated;        /* nonzero: stands with every kern closed           */
} kern_margin;

/* Work memory: two arrays of the caller. Nothing in them needs to be set, and
   nothing is kept there between calls. */
typedef struct kern_work {
    kern_real *real;
    int reals;            /* KERN_REALS(blocks, contacts)                     */
    int *index;
    int indices;          /* KERN_INTS(blocks, contacts)                      */
    /* the library adds up; the caller reads, and sets to 0 as it likes       */
    int pivots;           /* of all linear programs                           */
    int solves;           /* linear programs                                  */
    kern_real error;      /* largest error of a proof, as a share of what is
                             allowed: <= 1                                    */
    kern_fault fault;     /* of the last call that returned less than 0       */
} kern_work;

/* A linear program:  minimise cost . x  where  A x = rhs  and  x >= 0. */
typedef struct kern_lp {
    int rows, cols;
    const kern_real *a;    /* rows x cols, column by column                   */
    const kern_real *rhs;  /* one a row                                       */
    const kern_real *cost; /* one a column; NULL: any solution will do        */
    int pivots;            /* most pivots; 0: by size                         */
} kern_lp;
/* ---- Sizes ------------------------------------------------------- >>sizes */
/* Constant expressions, for arrays: of work memory for a structure of so many
   blocks (fixed ones included) and contact points, and for a linear program
   by itself. KERN_EXTRAS is the room for the dense part of a basis. */

/* a product that overflows in the precision it is written in: compilers leave
   it to the machine, and in double it would be emulated where float is not */
#ifdef KERN_SINGLE
#define KERN_INFINITY ((kern_real)(1e30f * 1e30f))
#else
#define KERN_INFINITY ((kern_real)(1e300 * 1e300))
#endif

#define KERN_EXTRAS(blocks) \
    ((blocks) + 24 < 3 * (blocks) ? (blocks) + 24 : 3 * (blocks))
#define KERN_REALS(blocks, contacts)                                        \
    (KERN_EXTRAS(blocks) * KERN_EXTRAS(blocks) + 5 * KERN_EXTRAS(blocks)    \
     + 35 * (blocks) + 12 * (contacts))
#define KERN_INTS(blocks, contacts) \
    (2 * KERN_EXTRAS(blocks) + 25 * (blocks) + 6 * (contacts))
#define KERN_LP_REALS(rows, cols) ((rows) * (rows) + 9 * (rows))
#define KERN_LP_INTS(rows, cols) (9 * (rows) + (cols))

/* ---- Functions ----------------------------------------------------- >>api */
/* Pointers must not be NULL where it does not say so: KERN_BAD_POINTER. Every
   function that takes work memory may return KERN_NO_SPACE, every one that
   takes a structure: KERN_BAD_POINTER, _NUMBER, _COUNT (blocks up to 20,000,
   contacts up to 1,000,000), _MASS, _FRICTION, _OPTION, _BLOCK, _NORMAL,
   KERN_SAME_BLOCK, KERN_NO_AREA, KERN_NO_FREE. B is the number of blocks, C of
   contact points, k the size of the dense complement (see >>lp). */

/* What a status means, in words. */
KERN_API const char *kern_status_text(kern_status status);

/* The defaults that stand beside each field of kern_options. */
KERN_API kern_options kern_defaults(void);

/* Work memory of two arrays, with its counters at zero. */
KERN_API kern_work kern_work_of(kern_real *real, int reals,
                                int *index, int indices);

/* What KERN_REALS and KERN_INTS are, for numbers known at run time. Zero in
   both where the numbers are out of range. */
KERN_API void kern_work_need(int blocks, int contacts,
                             int *reals, int *indices);

/* -- blocks -- */

/* Fills a block from a simple polygon, convex or not, turning either way:
   area, centroid, mass = density * |area|, no load. density 0 [kg/m^2] makes
   it fixed. The vertices stay the caller's and must live as long as the block.
   fault may be NULL; its index is the vertex.
   KERN_FEW_VERTICES, KERN_BAD_COUNT, KERN_BAD_NUMBER, KERN_NO_AREA,
   KERN_CROSSING (also for repeated vertices), KERN_BAD_MASS (density < 0).
   Time: O(n sqrt n) for usual polygons of n vertices, O(n^2) at worst. */
KERN_API kern_status kern_block_init(kern_block *block,
                                     const kern_vec *vertex, int vertices,
                                     kern_real density, kern_fault *fault);

/* Adds a force [N] that acts at a point and a torque [N m] to the block's
   load, which acts at the centre: set the centre first. */
KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec at,
                              kern_real torque);

/* Mean size of the free blocks [m]: the square roots of their areas. */
KERN_API kern_real kern_mean_size(const kern_block *block, int blocks);

/* -- contacts -- */

/* Finds the contacts between all blocks and writes them to out[0..room), pair
   after pair. Returns how many contact points there are, or
   KERN_NO_SPACE (nothing may be read from out; room for a few more than the
   result is needed while the faces of a pair are merged: double it),
   KERN_OVERLAP (fault: both blocks; value: the depth [m] that was found),
   KERN_BAD_POINTER, _COUNT, _NUMBER, _FRICTION, _OPTION, KERN_FEW_VERTICES
   (fault: the block). fault may be NULL. Blocks without vertices are passed
   over. Time: one test of boxes for each two blocks, and a few products for
   each two edges that are near. */
KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options,
                           kern_contact *out, int room, kern_fault *fault);

/* The same for blocks a and b alone, of the same array. */
KERN_API int kern_touch(const kern_block *block, int blocks, int a, int b,
                        const kern_options *options,
                        kern_contact *out, int room, kern_fault *fault);

/* Makes a contact that is given rather than found: from p to q, or at one
   point where p equals q; normal from a into b, of any length. Writes one or
   two contact points to out and returns how many, or KERN_SAME_BLOCK,
   KERN_BAD_BLOCK (an index below 0), KERN_BAD_NUMBER, KERN_BAD_FRICTION,
   KERN_BAD_NORMAL, KERN_BAD_LINE (p to q leaves the tangent by more than
   options->angle), KERN_BAD_OPTION. At the end: kern_contact_travels(). */
KERN_API int kern_contact_make(int a, int b, kern_vec normal, kern_vec p,
                               kern_vec q, kern_real mu,
                               const kern_options *options, kern_contact *out);

/* Sets the travel of every point contact from the others of its interface (the
   same two blocks, in either order): toward the middle of the two that are
   farthest apart; a lone one stays. Lines are left alone. Time: O(C^2). */
KERN_API void kern_contact_travels(kern_contact *contact, int contacts);

/* Where a contact point acts at a shrinkage; grown, where it is negative. */
KERN_API kern_vec kern_contact_at(const kern_contact *contact,
                                  kern_real shrink, int relative);

/* -- verdicts and measures -- */

/* Whether the structure stands with its kerns shrunk by `shrink` (grown, if
   negative). KERN_STANDS, KERN_FALLS or KERN_UNDECIDED. proof may be NULL.
   Time: about C + B k for each pivot, and as many pivots as the crash basis
   leaves to do: none for a tower, some tens for a wall of 30. */
KERN_API kern_status kern_stands(const kern_structure *s, kern_real shrink,
                                 const kern_options *options, kern_work *work,
                                 const kern_proof *proof);

/* Margin and level. KERN_STANDS: all of *out; proof->force holds the structure
   at out->holds and proof->motion (unless saturated) moves it at out->fails.
   KERN_FALLS: it does not stand as it is; level, margin, holds, fails are 0,
   most and epsilon are set, and proof->motion says how it falls.
   KERN_UNDECIDED, and KERN_BAD_STEP where most / epsilon is above 1,000,000:
   *out is as it was. [holds, fails] is at most 2e-6 of the mean block size
   wide, more only where no proof can be completed nearer to critical. Kerns of
   line contacts are nested, and the margin is then the only place where the
   verdict changes. Points of one interface with different normals are not:
   then the path is searched in steps of most/1001, and the level is the
   literal scan. */
KERN_API kern_status kern_measure(const kern_structure *s,
                                  const kern_options *options, kern_work *work,
                                  kern_margin *out, const kern_proof *proof);

/* How far kerns must grow [m] (relative: a share) until the structure stands.
   KERN_STANDS: it does already, 0. KERN_FALLS: *deficit is written, and is
   KERN_INFINITY where growing to 1000 times the structure does not help. */
KERN_API kern_status kern_deficit(const kern_structure *s,
                                  const kern_options *options, kern_work *work,
                                  kern_real *deficit);

/* The largest factor of a load pattern (one wrench a block, about its centre;
   those of fixed blocks are not read) that stands on top of weights and loads,
   with kerns shrunk by `shrink`. pattern NULL: m |g| at every centre, to the
   right (side 1: gravity turned by +90 degrees) or left (-1). KERN_STANDS:
   *factor, KERN_INFINITY where it stands at 1,000,000; proof as in
   kern_measure(), for the loads at the factor. KERN_FALLS: it falls at 0. */
KERN_API kern_status kern_load_factor(const kern_structure *s,
                                      kern_real shrink,
                                      const kern_wrench *pattern, int side,
                                      const kern_options *options,
                                      kern_work *work, kern_real *factor,
                                      const kern_proof *proof);

/* The first angle [rad] at which it falls when gravity turns toward the right
   (side 1) or left (-1) and loads stay; pi where it stands at every angle.
   With loads, gaps between angles that stand are seen if wider than 1/100.
   KERN_FALLS: it falls at 0. KERN_BAD_OPTION: no gravity, or no such side. */
KERN_API kern_status kern_tilt(const kern_structure *s, kern_real shrink,
                               int side, const kern_options *options,
                               kern_work *work, kern_real *angle,
                               const kern_proof *proof);

/* -- proofs -- */

/* The error of a proof as a share of what is allowed: up to 1 it holds.
   KERN_INFINITY where it proves nothing, and for bad input. Time: O(B + C),
   work memory: 4 B reals. Allowed is: for forces, 1e-9 (float: 1e-4) of what
   acts on a block in each of its equilibrium equations; for a motion, that
   forces up to 1e6 (1e3) times the weight could not stop it. */
KERN_API kern_real kern_check_forces(const kern_structure *s, kern_real shrink,
                                     const kern_options *options,
                                     const kern_force *force, kern_work *work);
KERN_API kern_real kern_check_motion(const kern_structure *s, kern_real shrink,
                                     const kern_options *options,
                                     const kern_motion *motion);

/* -- the linear program alone -- */

/* Solves a small dense program. x has cols, y rows numbers.
   KERN_STANDS: x is a solution, of least cost if there are costs, and then y
   are its prices: cost - y.A >= 0. KERN_FALLS: no x exists: y.A >= 0 and
   y.rhs < 0. KERN_UNBOUNDED: along x the cost falls: A x = 0, x >= 0,
   cost.x < 0. Each is checked against A. KERN_UNDECIDED: pivot limit, or the
   check failed. Work memory: KERN_LP_REALS(rows, cols), KERN_LP_INTS(...).
   Time: rows^2 + rows cols for a pivot. */
KERN_API kern_status kern_lp_solve(const kern_lp *lp, kern_real *x,
                                   kern_real *y, kern_work *work);

#ifdef __cplusplus
}
#endif
#endif /* KERN_H */

/* Stop here if you only want to use the library. Below is how it works.      */

/* ==== Part III: Implementation ===================================== >>impl */

#if defined(KERN_IMPLEMENTATION) || defined(KERN_STATIC)
#ifndef KERN_IMPLEMENTED
#define KERN_IMPLEMENTED

#include <float.h>
#include <stddef.h>
#ifndef KERN_SQRT
#include <math.h>
#ifdef KERN_SINGLE
#define KERN_SQRT(x) sqrtf(x)
#else
#define KERN_SQRT(x) sqrt(x)
#endif
#endif

#if defined(__FINITE_MATH_ONLY__)
#if __FINITE_MATH_ONLY__ == 1
#error "kern.h: do not compile the implementation with -ffast-math"
#endif
#endif

#ifdef __cplusplus
extern "C" {
#endif

#define KERN_R(x) ((kern_real)(x))

/* Tolerances. Lengths are in units of a block's size, forces in units of the
   weight of all, so none has a unit. First double, then float.               */
#ifdef KERN_SINGLE
#define KERN_EPS FLT_EPSILON
#define KERN_PICK(in_double, in_float) ((kern_real)(in_float))
#else
#define KERN_EPS DBL_EPSILON
#define KERN_PICK(in_double, in_float) ((kern_real)(in_double))
#endif

/* Residual that a proof may leave, as a share of what acts on the block. */
#define KERN_TOL         KERN_PICK(1e-9, 1e-4)
/* Largest forces that are taken for real, in weights: it ends the jam of
   blocks that press as hard as they like, and asks of a motion that it closes
   no contact faster than its power divided by this. */
#define KERN_BOUND       KERN_PICK(1e6, 1e3)
/* What a row of a proof may lose by rounding, as a share of its terms. */
#define KERN_ROUNDING    (32 * KERN_EPS)
/* How far a certificate is lifted off the columns that it touches: some
   roundings. In float, where KERN_BOUND is small, it is better left there. */
#define KERN_ABOVE       KERN_PICK(8 * KERN_EPS, 0)
/* A variable this far below zero is still zero. A tenth of what the proof
   allows; less, and the simplex chases rounding. */
#define KERN_FEAS_TOL    KERN_PICK(1e-10, 1e-5)
/* Least weight of a block, as a share of all, that KERN_FEAS_TOL refers to. */
#define KERN_LEAST_SCALE KERN_PICK(1e-4, 1e-3)
/* Pivots and gains below this share of the largest are rounding. */
#define KERN_PIVOT_TOL   KERN_PICK(1e-10, 1e-5)
/* A column whose part outside of the basis is less depends on it. */
#define KERN_RANK_TOL    KERN_PICK(1e-10, 1e-5)
/* Square of the share of a column that must be new to its group's block: an
   inverse of up to ten a group. Less makes the base grow from course to
   course, more fills the dense complement. */
#define KERN_BASE_TOL    KERN_PICK(1e-2, 1e-2)
/* Determinant of three columns, each about 1 long, for the crash basis. */
#define KERN_CRASH_TOL   KERN_PICK(1e-6, 1e-4)
/* Residual of the basic solution at which refinement ends, and above which the
   basis is made anew. */
#define KERN_REFINE_TOL  KERN_PICK(1e-15, 2e-7)
#define KERN_RENEW_TOL   KERN_PICK(1e-12, 1e-5)
/* Width of the bracket of a measure, in mean block sizes, and how many times
   wider it may get where neither proof can be completed nearer to critical. */
#define KERN_WIDTH       KERN_PICK(1.4e-6, 2e-3)
#define KERN_WIDEST      KERN_PICK(20, 20)

/* Bounds of loops and counts. */
#define KERN_RENEW         40      /* pivots until the basis is made anew     */
#define KERN_CRASH_MOST    12      /* columns tried for a crash triple        */
#define KERN_EDGE_ROUNDS   200     /* questions to narrow a bracket           */
#define KERN_CLIMB_ROUNDS  5000    /* questions to find one                   */
#define KERN_SCAN          1001    /* steps where kerns are not nested        */
#define KERN_TILTS         400     /* steps of a tilt under loads             */
#define KERN_FACTOR_MOST   KERN_R(1e6)
#define KERN_BLOCKS_MOST   20000   /* the work memory still counts in int     */
#define KERN_CONTACTS_MOST 1000000
#define KERN_COUNT_MOST    100000000

static kern_real kern_abs(kern_real a) { return a < 0 ? -a : a; }
static kern_real kern_max(kern_real a, kern_real b) { return a > b ? a : b; }
static kern_real kern_min(kern_real a, kern_real b) { return a < b ? a : b; }

static void kern_fault_clear(kern_fault *fault)
{
    fault->block = fault->other = fault->index = -1;
    fault->value = KERN_R(0);
}

/* ---- Tolerances of the geometry ----------------------------------- >>tol */
/* All are shares of a length that the user knows: a gap, a block's size, the
   largest coordinate. */

/* Share of the largest coordinate below which places are the same: some tens
   of roundings of a coordinate. No gap is less; smaller, and cubes that were
   turned and moved would no longer touch. */
#define KERN_FLOOR      (KERN_R(64) * KERN_EPS)
/* Turn [rad] below which a vertex is no corner, and within which of a half
   turn it is a spike. A dropped vertex is off its edge by a millionth of the
   edge at the most; much larger, and round stones would lose their shape. */
#define KERN_TURN       KERN_R(1e-6)
/* Most vertices of a polygon: its mean turn is then well above KERN_TURN. */
#define KERN_VERTICES_MOST 1000000
/* Share of the size: the gap that a mason does not see, and the line that he
   would call a point. */
#define KERN_GAP        KERN_R(1e-3)
/* Share of the size by which a foot must lie inside its edge, so that rounding
   makes no contacts between diagonal neighbours. */
#define KERN_FOOT       KERN_R(1e-6)
/* Cosine of 10 degrees: a vertex at a line contact belongs to it if their
   normals differ by less; across a real corner they differ by more. */
#define KERN_SAME_FACE  KERN_R(0.98480775301220806)
/* Angle [rad] from which an option for the angle is refused: it would take a
   corner for a face, and the series of kern_sine() would lose digits. */
#define KERN_ANGLE_MOST KERN_R(0.5)
/* Share of the mean block size below which a travel is rounding. */
#define KERN_TRAVEL     KERN_R(1e-9)
/* How many squares of coordinates may be added up and stay finite. */
#define KERN_SQUARES    KERN_R(64)
/* Edges that are looked at as one chunk, at the least. */
#define KERN_CHUNK 16
/* Heights at which an inner point of a polygon is looked for, and by how much
   of their distance they lie off the round numbers that edges love. */
#define KERN_HEIGHTS 5
#define KERN_OFF_ROUND  KERN_R(0.381966)

/* ---- Vectors ------------------------------------------------------ >>vec */

static int kern_is_finite(kern_real a)
{
    const kern_real zero = a - a; /* not a number where a is not finite */
    return zero >= 0 && zero <= 0;
}

static kern_vec kern_vec_make(kern_real x, kern_real y)
{
    kern_vec v;
    v.x = x;
    v.y = y;
    return v;
}

static kern_vec kern_vec_add(kern_vec a, kern_vec b)
{ return kern_vec_make(a.x + b.x, a.y + b.y); }

static kern_vec kern_vec_sub(kern_vec a, kern_vec b)
{ return kern_vec_make(a.x - b.x, a.y - b.y); }

static kern_vec kern_vec_scale(kern_vec a, kern_real s)
{ return kern_vec_make(a.x * s, a.y * s); }

/* a + s b */
static kern_vec kern_vec_step(kern_vec a, kern_real s, kern_vec b)
{ return kern_vec_make(a.x + s * b.x, a.y + s * b.y); }

static kern_real kern_vec_dot(kern_vec a, kern_vec b)
{ return a.x * b.x + a.y * b.y; }

static kern_real kern_vec_cross(kern_vec a, kern_vec b)
{ return a.x * b.y - a.y * b.x; }

/* a turned by +90 degrees */
static kern_vec kern_vec_turn(kern_vec a)
{ return kern_vec_make(-a.y, a.x); }

static kern_real kern_vec_length(kern_vec a)
{ return KERN_SQRT(kern_vec_dot(a, a)); }

static kern_vec kern_vec_unit(kern_vec a)
{ return kern_vec_scale(a, 1 / kern_vec_length(a)); }

static kern_vec kern_vec_mid(kern_vec a, kern_vec b)
{ return kern_vec_step(a, KERN_R(0.5), kern_vec_sub(b, a)); }

static int kern_vec_is_finite(kern_vec a)
{ return kern_is_finite(a.x) && kern_is_finite(a.y); }

/* The larger coordinate, without its sign. */
static kern_real kern_vec_largest(kern_vec a)
{ return kern_max(kern_abs(a.x), kern_abs(a.y)); }

/* Is a finite, and small enough to be squared? */
static int kern_is_moderate(kern_real a)
{ return kern_is_finite(KERN_SQUARES * a * a); }

/* By the series and not by libm, whose last digit differs between machines;
   angles below KERN_ANGLE_MOST are right to ten digits. */
static kern_real kern_sine(kern_real angle)
{
    const kern_real q = angle * angle;
    return angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42 * (1 - q / 72))));
}

/* Keeps of the interval [*low, *high] those s for which at + s slope lies from
   least to most. An empty interval has *low > *high. */
static void kern_clip(kern_real *low, kern_real *high, kern_real at,
                      kern_real slope, kern_real least, kern_real most)
{
    if (slope > 0) {
        *low = kern_max(*low, (least - at) / slope);
        *high = kern_min(*high, (most - at) / slope);
    } else if (slope < 0) {
        *low = kern_max(*low, (most - at) / slope);
        *high = kern_min(*high, (least - at) / slope);
    } else if (at < least || at > most) {
        *low = 1;
        *high = 0;
    }
}

static kern_status kern_fault_set(kern_fault *fault, kern_status status,
                                  int block, int index, kern_real value)
{
    fault->block = block;
    fault->index = index;
    fault->value = value;
    return status;
}

/* ---- Polygons ------------------------------------------------- >>polygon */
/* A polygon is read counter-clockwise, whichever way it was written. Vertices
   that hardly turn are no corners. An edge runs from a corner to the next one
   and has the index of the corner where it starts; other indices have none.

   Pairs of edges that are near each other are found without memory: edges are
   looked at in chunks of about a third of the root of their number, whose box
   is computed on the way, each time anew. Two chunks whose boxes are apart are
   passed over as a whole, else edge by edge, so that n edges of a reasonable
   polygon cost n sqrt(n), and those of the worst one n^2. */

typedef struct kern_box { kern_vec low, high; } kern_box;

static kern_vec kern_polygon_at(const kern_block *block, int i)
{
    return block->vertex[block->area < 0 ? block->vertices - 1 - i : i];
}

static int kern_polygon_next(const kern_block *block, int i)
{ return i + 1 < block->vertices ? i + 1 : 0; }

static int kern_polygon_prev(const kern_block *block, int i)
{ return i > 0 ? i - 1 : block->vertices - 1; }

/* How vertex i turns, as the tangent of the angle over *dot: above 0 it is
   convex, below 0 reflex. */
static kern_real kern_polygon_turn(const kern_block *block, int i,
                                   kern_real *dot)
{
    const kern_vec p = kern_polygon_at(block, i);
    const kern_vec in = kern_vec_sub(
        p, kern_polygon_at(block, kern_polygon_prev(block, i)));
    const kern_vec out = kern_vec_sub(
        kern_polygon_at(block, kern_polygon_next(block, i)), p);
    *dot = kern_vec_dot(in, out);
    return kern_vec_cross(in, out);
}

static int kern_polygon_is_corner(const kern_block *block, int i)
{
    kern_real dot;
    const kern_real turn = kern_polygon_turn(block, i, &dot);
    return !(kern_abs(turn) < KERN_TURN * dot);
}

static int kern_polygon_is_convex(const kern_block *block, int i)
{
    kern_real dot;
    return kern_polygon_turn(block, i, &dot) > 0;
}

static int kern_polygon_corner_after(const kern_block *block, int i)
{
    const int start = i;
    do
        i = kern_polygon_next(block, i);
    while (i != start && !kern_polygon_is_corner(block, i));
    return i;
}

static int kern_polygon_corner_before(const kern_block *block, int i)
{
    const int start = i;
    do
        i = kern_polygon_prev(block, i);
    while (i != start && !kern_polygon_is_corner(block, i));
    return i;
}

static kern_box kern_box_of(kern_vec p, kern_vec q)
{
    kern_box box;
    box.low = kern_vec_make(kern_min(p.x, q.x), kern_min(p.y, q.y));
    box.high = kern_vec_make(kern_max(p.x, q.x), kern_max(p.y, q.y));
    return box;
}

static void kern_box_add(kern_box *box, kern_vec p)
{
    box->low.x = kern_min(box->low.x, p.x);
    box->low.y = kern_min(box->low.y, p.y);
    box->high.x = kern_max(box->high.x, p.x);
    box->high.y = kern_max(box->high.y, p.y);
}

static kern_box kern_box_grow(kern_box box, kern_real by)
{
    const kern_vec step = kern_vec_make(by, by);
    box.low = kern_vec_sub(box.low, step);
    box.high = kern_vec_add(box.high, step);
    return box;
}

static int kern_box_meets(const kern_box *a, const kern_box *b)
{
    return a->low.x <= b->high.x && b->low.x <= a->high.x &&
           a->low.y <= b->high.y && b->low.y <= a->high.y;
}

static int kern_box_within(const kern_box *a, const kern_box *b)
{
    return a->low.x >= b->low.x && a->high.x <= b->high.x &&
           a->low.y >= b->low.y && a->high.y <= b->high.y;
}

static kern_box kern_polygon_box(const kern_block *block)
{
    kern_box box = kern_box_of(block->vertex[0], block->vertex[0]);
    int i;
    for (i = 1; i < block->vertices; i++)
        kern_box_add(&box, block->vertex[i]);
    return box;
}

static kern_box kern_polygon_edge_box(const kern_block *block, int i)
{
    const int end = kern_polygon_corner_after(block, i);
    return kern_box_of(kern_polygon_at(block, i), kern_polygon_at(block, end));
}

/* Less than the root: to look at an edge costs more than to box a vertex. */
static int kern_polygon_chunk(const kern_block *block)
{
    int size = KERN_CHUNK;
    while (size < block->vertices / (8 * size))
        size *= 2;
    return size;
}

static int kern_chunk_end(const kern_block *block, int first, int size)
{
    return size < block->vertices - first ? first + size : block->vertices;
}

/* The box of the edges from first on, at most size of them; 0: there are none.
   Dropped vertices lie on edges, so the box of all vertices will do. */
static int kern_polygon_chunk_box(const kern_block *block, int first, int size,
                                  kern_box *box)
{
    int i, last = kern_chunk_end(block, first, size) - 1;
    while (last >= first && !kern_polygon_is_corner(block, last))
        last--;
    if (last < first)
        return 0;
    i = kern_polygon_corner_after(block, last);
    *box = kern_box_of(kern_polygon_at(block, first),
                       kern_polygon_at(block, i));
    for (i = first + 1; i <= last; i++)
        kern_box_add(box, kern_polygon_at(block, i));
    return 1;
}

/* All pairs of an edge i of a and an edge j of b whose boxes are not farther
   apart than the gap; of a polygon with itself, each pair once. */
typedef struct kern_pairs {
    const kern_block *a, *b;
    kern_real gap;
    int i, j;               /* the pair                                    */
    int chunk_a, chunk_b;   /* first edge of the chunk                     */
    int size_a, size_b;     /* edges in a chunk                            */
    int end_a, end_b;       /* after the last edge of the chunk            */
    int some_a;             /* nonzero: the chunk of a is worth a look     */
    kern_box whole_b, box_a, box_b, edge; /* those of a grown by the gap   */
} kern_pairs;

static void kern_pairs_chunk_a(kern_pairs *pairs, int first)
{
    pairs->chunk_a = first;
    pairs->end_a = kern_chunk_end(pairs->a, first, pairs->size_a);
    pairs->some_a = kern_polygon_chunk_box(pairs->a, first, pairs->size_a,
                                           &pairs->box_a);
    if (pairs->some_a) {
        pairs->box_a = kern_box_grow(pairs->box_a, pairs->gap);
        pairs->some_a = kern_box_meets(&pairs->box_a, &pairs->whole_b);
    }
    pairs->chunk_b = (pairs->a == pairs->b ? first : 0) - pairs->size_b;
}

static void kern_pairs_open(kern_pairs *pairs, const kern_block *a,
                            const kern_block *b, kern_real gap)
{
    pairs->a = a;
    pairs->b = b;
    pairs->gap = gap;
    pairs->size_a = kern_polygon_chunk(a);
    pairs->size_b = kern_polygon_chunk(b);
    pairs->whole_b = kern_polygon_box(b);
    kern_pairs_chunk_a(pairs, 0);
    pairs->i = pairs->end_a;
    pairs->j = pairs->end_b = 0;
}

/* Goes to the next two chunks that are near each other; 0: there are none. */
static int kern_pairs_next_chunk(kern_pairs *pairs)
{
    for (;;) {
        pairs->chunk_b += pairs->size_b;
        while (!pairs->some_a || pairs->chunk_b >= pairs->b->vertices) {
            if (pairs->end_a >= pairs->a->vertices)
                return 0;
            kern_pairs_chunk_a(pairs, pairs->end_a);
            pairs->chunk_b += pairs->size_b;
        }
        if (kern_polygon_chunk_box(pairs->b, pairs->chunk_b, pairs->size_b,
                                   &pairs->box_b) &&
            kern_box_meets(&pairs->box_a, &pairs->box_b))
            break;
    }
    pairs->end_b = kern_chunk_end(pairs->b, pairs->chunk_b, pairs->size_b);
    pairs->i = pairs->chunk_a - 1;
    return 1;
}

/* Goes to the next edge of a that is near the chunk of b; 0: there is none. */
static int kern_pairs_next_edge(kern_pairs *pairs)
{
    while (++pairs->i < pairs->end_a) {
        if (!kern_polygon_is_corner(pairs->a, pairs->i))
            continue;
        pairs->edge = kern_polygon_edge_box(pairs->a, pairs->i);
        pairs->edge = kern_box_grow(pairs->edge, pairs->gap);
        if (kern_box_meets(&pairs->edge, &pairs->box_b))
            break;
    }
    pairs->j = pairs->chunk_b - 1;
    if (pairs->a == pairs->b && pairs->j < pairs->i)
        pairs->j = pairs->i;
    return pairs->i < pairs->end_a;
}

static int kern_pairs_next(kern_pairs *pairs)
{
    for (;;) {
        while (++pairs->j < pairs->end_b) {
            kern_box box;
            if (!kern_polygon_is_corner(pairs->b, pairs->j))
                continue;
            box = kern_polygon_edge_box(pairs->b, pairs->j);
            if (kern_box_meets(&pairs->edge, &box))
                return 1;
        }
        while (!kern_pairs_next_edge(pairs))
            if (!kern_pairs_next_chunk(pairs))
                return 0;
    }
}

/* On the same side of the line from p to q, and not on it? */
static int kern_same_side(kern_vec p, kern_vec q, kern_vec a, kern_vec b)
{
    const kern_vec d = kern_vec_sub(q, p);
    const kern_real left = kern_vec_cross(d, kern_vec_sub(a, p));
    const kern_real right = kern_vec_cross(d, kern_vec_sub(b, p));
    return (left > 0 && right > 0) || (left < 0 && right < 0);
}

/* Two edges whose boxes meet touch unless one lies on one side of the other;
   neighbours touch by right unless they turn back, which is a spike. */
static kern_status kern_polygon_simple(const kern_block *block,
                                       kern_fault *fault)
{
    kern_pairs pairs;
    int i;
    for (i = 0; i < block->vertices; i++) {
        kern_real dot;
        const kern_real turn = kern_polygon_turn(block, i, &dot);
        if (kern_abs(turn) <= -KERN_TURN * dot)
            return kern_fault_set(fault, KERN_CROSSING, -1, i, 0);
    }
    kern_pairs_open(&pairs, block, block, 0);
    while (kern_pairs_next(&pairs)) {
        const int end = kern_polygon_corner_after(block, pairs.i);
        const int other = kern_polygon_corner_after(block, pairs.j);
        const kern_vec p = kern_polygon_at(block, pairs.i);
        const kern_vec q = kern_polygon_at(block, end);
        const kern_vec r = kern_polygon_at(block, pairs.j);
        const kern_vec s = kern_polygon_at(block, other);
        if (end == pairs.j || other == pairs.i)
            continue;
        if (!kern_same_side(p, q, r, s) && !kern_same_side(r, s, p, q))
            return kern_fault_set(fault, KERN_CROSSING, -1, pairs.i, 0);
    }
    return KERN_STANDS;
}

/* What the triangles between vertex 0 and the edges add up to. Everything is
   measured from vertex 0, against round-off far from the origin. */
typedef struct kern_fan {
    kern_real area;       /* signed                                      */
    kern_real spread;     /* sum of areas without their signs            */
    kern_real extent;     /* largest distance from vertex 0              */
    kern_real coordinate; /* largest                                     */
    kern_vec moment;
} kern_fan;

static kern_fan kern_polygon_fan(const kern_block *block)
{
    const kern_vec o = block->vertex[0];
    kern_fan fan;
    int i;
    fan.moment = kern_vec_make(0, 0);
    fan.area = fan.spread = fan.extent = 0;
    fan.coordinate = kern_vec_largest(o);
    for (i = 1; i < block->vertices; i++) {
        const kern_vec u = kern_vec_sub(block->vertex[i], o);
        const kern_vec w = kern_vec_sub(
            block->vertex[kern_polygon_next(block, i)], o);
        const kern_real area = kern_vec_cross(u, w) / 2;
        fan.area += area;
        fan.spread += kern_abs(area);
        fan.extent = kern_max(fan.extent, kern_vec_length(u));
        fan.coordinate = kern_max(fan.coordinate,
                                  kern_vec_largest(block->vertex[i]));
        fan.moment = kern_vec_step(fan.moment, area / 3, kern_vec_add(u, w));
    }
    return fan;
}

/* Fills in the area and the centre if the polygon is a good one. */
static kern_status kern_polygon_measure(kern_block *block, kern_fault *fault)
{
    kern_fan fan;
    kern_real least;
    kern_status status;
    int i;
    for (i = 0; i < block->vertices; i++) {
        const kern_vec p = block->vertex[i];
        if (!kern_is_moderate(p.x) || !kern_is_moderate(p.y))
            return kern_fault_set(fault, KERN_BAD_NUMBER, -1, i,
                                  kern_is_moderate(p.x) ? p.y : p.x);
    }
    fan = kern_polygon_fan(block);
    if (!kern_is_finite(fan.spread))
        return kern_fault_set(fault, KERN_BAD_NUMBER, -1, 0, fan.coordinate);
    least = KERN_FLOOR * fan.coordinate * fan.extent;
    if (!(fan.spread > least)) /* all vertices on one line */
        return kern_fault_set(fault, KERN_NO_AREA, -1, -1, fan.area);
    status = kern_polygon_simple(block, fault);
    if (status < 0)
        return status;
    if (!(kern_abs(fan.area) > least))
        return kern_fault_set(fault, KERN_NO_AREA, -1, -1, fan.area);
    block->area = fan.area;
    block->centre = kern_vec_step(block->vertex[0], 1 / fan.area, fan.moment);
    return kern_vec_is_finite(block->centre) ? KERN_STANDS :
           kern_fault_set(fault, KERN_BAD_NUMBER, -1, 0, fan.coordinate);
}

KERN_API kern_status kern_block_init(kern_block *block, const kern_vec *vertex,
                                     int vertices, kern_real density,
                                     kern_fault *fault)
{
    kern_fault ignored;
    kern_block made;
    kern_status status;
    if (!fault)
        fault = &ignored;
    kern_fault_clear(fault);
    if (vertices < 0 || vertices > KERN_VERTICES_MOST)
        return kern_fault_set(fault, KERN_BAD_COUNT, -1, -1,
                              KERN_R(vertices));
    if (vertices < 3)
        return kern_fault_set(fault, KERN_FEW_VERTICES, -1, -1,
                              KERN_R(vertices));
    if (!block || !vertex)
        return KERN_BAD_POINTER;
    if (!kern_is_finite(density) || density < 0)
        return kern_fault_set(fault, KERN_BAD_MASS, -1, -1, density);
    made.vertex = vertex;
    made.vertices = vertices;
    made.area = 0; /* unknown: vertices are read, and faults told, as written */
    status = kern_polygon_measure(&made, fault);
    if (status < 0)
        return status;
    made.fixed = !(density > 0);
    made.mass = density * kern_abs(made.area);
    if (!kern_is_finite(made.mass) || (!made.fixed && !(made.mass > 0)))
        return kern_fault_set(fault, KERN_BAD_MASS, -1, -1, made.mass);
    made.load.fx = made.load.fy = made.load.torque = 0;
    *block = made;
    return KERN_STANDS;
}

KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec at,
                              kern_real torque)
{
    const kern_vec arm = kern_vec_sub(at, block->centre);
    block->load.fx += force.x;
    block->load.fy += force.y;
    block->load.torque += kern_vec_cross(arm, force) + torque;
}

static kern_real kern_block_size(const kern_block *block)
{
    return KERN_SQRT(kern_abs(block->area));
}

KERN_API kern_real kern_mean_size(const kern_block *block, int blocks)
{
    kern_real sum = 0;
    int i, sized = 0;
    for (i = 0; block && i < blocks; i++) {
        const kern_real size = block[i].fixed ? 0 : kern_block_size(&block[i]);
        if (size > 0) { /* blocks without a polygon have no size */
            sum += size;
            sized++;
        }
    }
    return sized ? sum / KERN_R(sized) : 0;
}

static int kern_polygon_holds(const kern_block *block, kern_vec p)
{
    int i, inside = 0;
    for (i = 0; i < block->vertices; i++) {
        const kern_vec u = block->vertex[i];
        const kern_vec v = block->vertex[kern_polygon_next(block, i)];
        if ((u.y > p.y) != (v.y > p.y) &&
            ((kern_vec_cross(kern_vec_sub(v, u), kern_vec_sub(p, u)) > 0) ==
             (v.y > u.y)))
            inside = !inside;
    }
    return inside;
}

/* Distance of p from the way between u and v. */
static kern_real kern_distance(kern_vec p, kern_vec u, kern_vec v)
{
    const kern_vec d = kern_vec_sub(v, u), r = kern_vec_sub(p, u);
    const kern_real along = kern_vec_dot(r, d), whole = kern_vec_dot(d, d);
    kern_real share = 0;
    if (along > 0)
        share = along < whole ? along / whole : 1;
    return kern_vec_length(kern_vec_sub(r, kern_vec_scale(d, share)));
}

static kern_real kern_polygon_distance(const kern_block *block, kern_vec p)
{
    kern_real least = kern_distance(p, block->vertex[0], block->vertex[1]);
    int i;
    for (i = 1; i < block->vertices; i++)
        least = kern_min(least, kern_distance(p, block->vertex[i],
                         block->vertex[kern_polygon_next(block, i)]));
    return least;
}

/* Middle of the widest way through the polygon at the height y. Seen counter-
   clockwise it is entered through edges that go down. */
static kern_vec kern_polygon_inner(const kern_block *block, kern_real y)
{
    kern_vec best = block->vertex[0];
    kern_real widest = 0;
    int i, j;
    for (i = 0; i < block->vertices; i++) {
        const kern_vec u = kern_polygon_at(block, i);
        const kern_vec v =
            kern_polygon_at(block, kern_polygon_next(block, i));
        kern_real x, wide = -1;
        if (!(u.y > y && v.y <= y))
            continue;
        x = u.x + (v.x - u.x) * ((y - u.y) / (v.y - u.y));
        for (j = 0; j < block->vertices; j++) {
            const kern_vec p = kern_polygon_at(block, j);
            const kern_vec q =
                kern_polygon_at(block, kern_polygon_next(block, j));
            kern_real way;
            if (!(p.y <= y && q.y > y))
                continue;
            way = p.x + (q.x - p.x) * ((y - p.y) / (q.y - p.y)) - x;
            if (way > 0 && (wide < 0 || way < wide))
                wide = way;
        }
        if (wide > widest) {
            widest = wide;
            best = kern_vec_make(x + wide / 2, y);
        }
    }
    return best;
}

/* ---- Contacts ------------------------------------------------- >>contact */
/*      line               point              corner in a corner
        ___________             \  b  /         | b
       |     b     |             \   /          |____
    ___o___________o___      _____\ /_____        a  |  two normals
       |     a         |       a   o              ___|  at one place

   A search goes over the blocks pair by pair. Of a pair it first looks for
   overlap, then for lines, then for points where no line is; what it finds is
   raw and is written to the free rest of the caller's array. There the raw
   contacts are merged to faces in place: a face never takes more room than its
   members. The pairs know nothing of each other. */

typedef struct kern_search {
    const kern_block *block;
    int blocks;
    kern_real floor;        /* places closer than that are the same [m]    */
    kern_real mean;         /* mean block size [m]                         */
    kern_real mu, sine;     /* of the options; sine of their angle         */
    kern_real user_gap;     /* 0: by the size of the pair                  */
    kern_contact *out;
    int room, count;
    kern_fault *fault;
    /* the pair */
    const kern_block *a, *b;
    int index_a, index_b;   /* a before b                                  */
    kern_real gap;          /* widest [m]                                  */
    kern_real least;        /* a line is longer [m]                        */
    kern_real foot;         /* from there on a foot is inside its edge [m] */
    int first, lines;       /* raw contacts: first, and first after lines  */
} kern_search;

/* An edge from p to q: unit direction, outer normal, length. */
typedef struct kern_edge {
    kern_vec p, q, d, n;
    kern_real length;
    int end;                /* corner at q */
} kern_edge;

static kern_edge kern_edge_of(const kern_block *block, int i)
{
    kern_edge e;
    e.end = kern_polygon_corner_after(block, i);
    e.p = kern_polygon_at(block, i);
    e.q = kern_polygon_at(block, e.end);
    e.d = kern_vec_sub(e.q, e.p);
    e.length = kern_vec_length(e.d);
    e.d = kern_vec_scale(e.d, 1 / e.length);
    e.n = kern_vec_make(e.d.y, -e.d.x);
    return e;
}

/* ---- overlap ---- */
/* No boundary point of a may lie inside b and deeper than the gap. Along an
   edge of a the places within the gap of one edge of b are an interval: the
   edge of b, grown by the gap, is convex. The intervals of all edges of b
   cover part of the edge of a; each part they leave uncovered lies inside b
   or outside as a whole, for the way in or out is covered. So one place of it
   tells, exactly, also where no vertex is inside (crossing bars).

   Edges of a are taken in chunks; most chunks are far from b, or so far from
   its boundary that one place tells for the chunk. Two blocks at nearly the
   same place cover each other: then an inner point of one lies in the other. */

typedef struct kern_cover {
    const kern_block *b;
    kern_vec p, d;          /* the edge of a, and its unit direction */
    kern_real length;
    kern_real gap;
    int first, last;        /* edges of b that matter                */
} kern_cover;

/* Widens [*low, *high] to hold the part of [from, to] that is on the edge. */
static void kern_cover_join(const kern_cover *c, kern_real from, kern_real to,
                            kern_real *low, kern_real *high)
{
    from = kern_max(from, 0);
    to = kern_min(to, c->length);
    if (from > to)
        return;
    *low = kern_min(*low, from);
    *high = kern_max(*high, to);
}

static void kern_cover_disc(const kern_cover *c, kern_vec centre,
                            kern_real *low, kern_real *high)
{
    const kern_real off = kern_vec_cross(c->d, centre);
    const kern_real along = kern_vec_dot(c->d, centre);
    const kern_real square = (c->gap - off) * (c->gap + off);
    if (square >= 0) {
        const kern_real half = KERN_SQRT(square);
        kern_cover_join(c, along - half, along + half, low, high);
    }
}

/* Interval of the places p + s d within the gap of edge j of b, 0: none. */
static int kern_cover_span(const kern_cover *c, int j, kern_real *low,
                           kern_real *high)
{
    const kern_vec u = kern_vec_sub(c->b->vertex[j], c->p);
    const kern_vec v = kern_vec_sub(
        c->b->vertex[kern_polygon_next(c->b, j)], c->p);
    const kern_vec f = kern_vec_sub(v, u);
    const kern_real hu = kern_vec_cross(c->d, u), hv = kern_vec_cross(c->d, v);
    const kern_real length = kern_vec_length(f);
    kern_real from = 0, to = c->length;
    if ((hu > c->gap && hv > c->gap) || (hu < -c->gap && hv < -c->gap))
        return 0;
    *low = c->length;
    *high = 0;
    kern_cover_disc(c, u, low, high);
    kern_cover_disc(c, v, low, high);
    if (length > 0) {
        kern_clip(&from, &to, -kern_vec_dot(f, u), kern_vec_dot(f, c->d), 0,
                  length * length);
        kern_clip(&from, &to, -kern_vec_cross(f, u),
                  kern_vec_cross(f, c->d), -c->gap * length,
                  c->gap * length);
        kern_cover_join(c, from, to, low, high);
    }
    return *low <= *high;
}

/* How far the edge is covered from s on without a break. Where blocks touch
   their boundaries run against each other, so b's edges are tried backward
   first; each round that goes on is followed by one the other way. */
static kern_real kern_cover_reach(const kern_cover *c, kern_real s)
{
    int backward = 1, further = 1;
    while (further) {
        int k;
        further = 0;
        for (k = c->first; k <= c->last; k++) {
            const int j = backward ? c->last - (k - c->first) : k;
            kern_real low, high;
            if (kern_cover_span(c, j, &low, &high) && low <= s && high > s) {
                s = high;
                further = 1;
            }
        }
        backward = !backward;
    }
    return s;
}

/* Where the next interval beyond s begins, at most `to`. */
static kern_real kern_cover_next(const kern_cover *c, kern_real s, kern_real to)
{
    int j;
    for (j = c->first; j <= c->last; j++) {
        kern_real low, high;
        if (kern_cover_span(c, j, &low, &high) && low > s)
            to = kern_min(to, low);
    }
    return to;
}

/* Depth of place p of one block in block b, 0 where it is not inside. */
static kern_real kern_depth(const kern_block *b, kern_vec p)
{
    return kern_polygon_holds(b, p) ? kern_polygon_distance(b, p) : 0;
}

/* The first depth beyond the gap on the edge, 0: none. The core is b's box
   less the gap: what is deep lies in it. */
static kern_real kern_cover_depth(const kern_cover *c, const kern_box *core)
{
    kern_real s = 0, to = c->length;
    kern_clip(&s, &to, c->p.x, c->d.x, core->low.x, core->high.x);
    kern_clip(&s, &to, c->p.y, c->d.y, core->low.y, core->high.y);
    while (s < to) {
        kern_real next, depth;
        s = kern_cover_reach(c, s);
        if (!(s < to))
            break;
        next = kern_cover_next(c, s, to);
        depth = kern_depth(c->b, kern_vec_step(c->p, s + (next - s) / 2, c->d));
        if (depth > c->gap)
            return depth;
        s = next;
    }
    return 0;
}

/* Sets the first and the last edge of b whose box meets the given one; 0:
   there is none. */
static int kern_cover_range(kern_cover *c, const kern_box *box)
{
    int j, some = 0;
    for (j = 0; j < c->b->vertices; j++) {
        const kern_box edge = kern_box_of(
            c->b->vertex[j], c->b->vertex[kern_polygon_next(c->b, j)]);
        if (!kern_box_meets(&edge, box))
            continue;
        if (!some)
            c->first = j;
        c->last = j;
        some = 1;
    }
    return some;
}

/* Depth beyond the gap of a's boundary in b, 0: none. */
static kern_real kern_overlap_boundary(const kern_block *a, const kern_block *b,
                                       kern_real gap)
{
    const int size = kern_polygon_chunk(a);
    const kern_box core = kern_box_grow(kern_polygon_box(b), -gap);
    kern_real depth = 0;
    kern_cover c;
    int first, i;
    c.b = b;
    c.gap = gap;
    for (first = 0; first < a->vertices && !(depth > gap); first += size) {
        kern_box box;
        if (!kern_polygon_chunk_box(a, first, size, &box) ||
            !kern_box_meets(&box, &core))
            continue;
        box = kern_box_grow(box, gap);
        if (!kern_cover_range(&c, &box)) {
            depth = kern_depth(b, kern_polygon_at(a, first));
            continue;
        }
        for (i = first; i < kern_chunk_end(a, first, size); i++) {
            kern_edge e;
            if (!kern_polygon_is_corner(a, i))
                continue;
            e = kern_edge_of(a, i);
            c.p = e.p;
            c.d = e.d;
            c.length = e.length;
            depth = kern_cover_depth(&c, &core);
            if (depth > gap)
                break;
        }
    }
    return depth > gap ? depth : 0;
}

/* Depth in b of an inner point of a, where a may be held by b altogether. */
static kern_real kern_overlap_inner(const kern_block *a, const kern_block *b,
                                    kern_real gap)
{
    const kern_box box = kern_polygon_box(a);
    const kern_box held = kern_box_grow(kern_polygon_box(b), gap);
    int k;
    if (!kern_box_within(&box, &held))
        return 0;
    for (k = 1; k <= KERN_HEIGHTS; k++) {
        const kern_real share = (KERN_R(k) - KERN_OFF_ROUND) / KERN_HEIGHTS;
        const kern_vec p = kern_polygon_inner(
            a, box.low.y + share * (box.high.y - box.low.y));
        const kern_real depth = kern_depth(b, p);
        if (depth > gap && kern_depth(a, p) > gap)
            return depth;
    }
    return 0;
}

static kern_real kern_overlap(const kern_block *a, const kern_block *b,
                              kern_real gap)
{
    kern_real depth = kern_overlap_boundary(a, b, gap);
    if (!(depth > 0))
        depth = kern_overlap_boundary(b, a, gap);
    if (!(depth > 0))
        depth = kern_overlap_inner(a, b, gap);
    return depth > 0 ? depth : kern_overlap_inner(b, a, gap);
}

/* ---- lines and points ---- */

static kern_status kern_search_put(kern_search *s, kern_vec p, kern_vec n,
                                   int line)
{
    kern_contact *c;
    if (s->count >= s->room)
        return KERN_NO_SPACE;
    c = &s->out[s->count++];
    c->a = s->index_a;
    c->b = s->index_b;
    c->line = line;
    c->p = p;
    c->n = n;
    c->mu = s->mu;
    c->travel = 0;
    return KERN_STANDS;
}

/* Edge i of a and edge j of b run against each other. In the frame of their
   mean tangent t and mean normal n both are heights over s, and so is the gap
   between them: the line contact is where it is small enough. */
static kern_status kern_search_line(kern_search *s, int i, int j)
{
    const kern_edge e = kern_edge_of(s->a, i), f = kern_edge_of(s->b, j);
    kern_vec n, t, eq, fp, fq, mid;
    kern_real low, high, rise_e, rise_f, start_f;
    kern_status status;
    if (!(kern_vec_dot(e.n, f.n) < 0) ||
        kern_abs(kern_vec_cross(e.n, f.n)) > s->sine)
        return KERN_STANDS;
    n = kern_vec_unit(kern_vec_sub(e.n, f.n));
    t = kern_vec_turn(n);
    eq = kern_vec_sub(e.q, e.p); /* from e.p on, against round-off */
    fp = kern_vec_sub(f.p, e.p);
    fq = kern_vec_sub(f.q, e.p);
    low = kern_max(0, kern_vec_dot(fq, t));
    high = kern_min(kern_vec_dot(eq, t), kern_vec_dot(fp, t));
    if (!(high - low > s->least))
        return KERN_STANDS;
    rise_e = kern_vec_dot(eq, n) / kern_vec_dot(eq, t);
    rise_f = kern_vec_dot(kern_vec_sub(fp, fq), n) /
             kern_vec_dot(kern_vec_sub(fp, fq), t);
    start_f = kern_vec_dot(fq, n) - rise_f * kern_vec_dot(fq, t);
    kern_clip(&low, &high, start_f, rise_f - rise_e, -s->gap, s->gap);
    if (!(high - low > s->least))
        return KERN_STANDS;
    rise_f = (rise_f + rise_e) / 2; /* of the midline */
    start_f /= 2;
    t = kern_vec_step(t, rise_f, n);
    mid = kern_vec_step(e.p, start_f, n);
    status = kern_search_put(s, kern_vec_step(mid, low, t), n, 1);
    return status < 0 ? status :
           kern_search_put(s, kern_vec_step(mid, high, t), n, 1);
}

/* Is a line contact with about this normal within the gap of p? */
static int kern_search_on_line(const kern_search *s, kern_vec p, kern_vec n)
{
    int i;
    for (i = s->first; i < s->lines; i += 2)
        if (kern_vec_dot(s->out[i].n, n) > KERN_SAME_FACE &&
            kern_distance(p, s->out[i].p, s->out[i + 1].p) <= s->gap)
            return 1;
    return 0;
}

/* Is v in the corner that the edge makes at one of its ends? */
static int kern_search_in_corner(const kern_search *s, const kern_block *block,
                                 int j, const kern_edge *e, kern_vec v)
{
    return (kern_vec_length(kern_vec_sub(v, e->p)) <= s->gap &&
            !kern_polygon_is_convex(block, j)) ||
           (kern_vec_length(kern_vec_sub(v, e->q)) <= s->gap &&
            !kern_polygon_is_convex(block, e->end));
}

/* Does the way from v to its neighbour lead to the outer side of the edge? */
static int kern_search_leads_out(const kern_search *s, const kern_edge *e,
                                 kern_vec v, kern_vec neighbour)
{
    const kern_vec way = kern_vec_sub(neighbour, v);
    return kern_vec_dot(way, e->n) >= -s->sine * kern_vec_length(way);
}

/* Vertex i of the block `from` stands on edge j of the block `to`: its foot is
   inside the edge, or it is in a corner of `to`. */
static kern_status kern_search_point(kern_search *s, const kern_block *from,
                                     int i, const kern_block *to, int j)
{
    const kern_vec v = kern_polygon_at(from, i);
    kern_edge e;
    kern_vec r, n, before, after;
    kern_real along;
    if (!kern_polygon_is_convex(from, i))
        return KERN_STANDS;
    e = kern_edge_of(to, j);
    r = kern_vec_sub(v, e.p);
    if (!(kern_abs(kern_vec_dot(r, e.n)) <= s->gap))
        return KERN_STANDS;
    along = kern_vec_dot(r, e.d);
    if (!(along > s->foot && along < e.length - s->foot) &&
        !kern_search_in_corner(s, to, j, &e, v))
        return KERN_STANDS;
    before = kern_polygon_at(from, kern_polygon_corner_before(from, i));
    after = kern_polygon_at(from, kern_polygon_corner_after(from, i));
    n = to == s->a ? e.n : kern_vec_scale(e.n, -1);
    if (!kern_search_leads_out(s, &e, v, before) ||
        !kern_search_leads_out(s, &e, v, after) ||
        kern_search_on_line(s, v, n))
        return KERN_STANDS;
    return kern_search_put(s, v, n, 0);
}

/* ---- faces ---- */
/* The longest raw contact leads a face; all others with its normal and on its
   line join it. They leave the array, the rest moves up to its end in order,
   and the face is written to the place they left. What is left of raw contacts
   is shorter, so the next one leads again, and no order need be kept. */

typedef struct kern_face {
    kern_vec p, n;          /* the leader's                               */
    kern_vec low, high;     /* outermost points along its tangent         */
    kern_real least, most;  /* where they are, from p on                  */
    kern_vec sum;           /* of normals times lengths                   */
    int points;
} kern_face;

static kern_real kern_raw_length(const kern_contact *c)
{
    return c->line ? kern_vec_length(kern_vec_sub(c[1].p, c->p)) : 0;
}

static int kern_face_lead(const kern_search *s, int raw)
{
    kern_real longest = -1;
    int i, lead = raw;
    for (i = raw; i < s->count; i += s->out[i].line ? 2 : 1) {
        const kern_real length = kern_raw_length(&s->out[i]);
        if (length > longest) {
            longest = length;
            lead = i;
        }
    }
    return lead;
}

static void kern_face_open(kern_face *face, const kern_contact *leader)
{
    face->p = leader->p;
    face->n = leader->n;
    face->low = face->high = leader->p;
    face->least = face->most = 0;
    face->sum = kern_vec_make(0, 0);
    face->points = 0;
}

static int kern_face_takes(const kern_face *face, const kern_search *s,
                           const kern_contact *c)
{
    const kern_vec first = kern_vec_sub(c[0].p, face->p);
    const kern_vec second = kern_vec_sub(c[c->line ? 1 : 0].p, face->p);
    return kern_vec_dot(face->n, c->n) > 0 &&
           kern_abs(kern_vec_cross(face->n, c->n)) <= s->sine &&
           kern_abs(kern_vec_dot(first, face->n)) <= s->gap &&
           kern_abs(kern_vec_dot(second, face->n)) <= s->gap;
}

static void kern_face_point(kern_face *face, kern_vec p)
{
    const kern_real at =
        kern_vec_dot(kern_vec_sub(p, face->p), kern_vec_turn(face->n));
    if (at < face->least) {
        face->least = at;
        face->low = p;
    }
    if (at > face->most) {
        face->most = at;
        face->high = p;
    }
    face->points++;
}

static void kern_face_join(kern_face *face, const kern_search *s,
                           const kern_contact *c)
{
    const kern_real weight = c->line ? kern_raw_length(c) : s->gap;
    face->sum = kern_vec_step(face->sum, weight, c->n);
    kern_face_point(face, c[0].p);
    if (c->line)
        kern_face_point(face, c[1].p);
}

/* Writes the face to `out`; returns the number of contact points: 2, or 1 if
   it has no extent. */
static int kern_face_write(const kern_face *face, const kern_search *s,
                           kern_contact *out)
{
    const kern_vec n = face->points > 1 ? kern_vec_unit(face->sum) : face->n;
    const kern_vec t = kern_vec_turn(n);
    const kern_vec mid = kern_vec_mid(face->low, face->high);
    const kern_real half =
        kern_vec_dot(kern_vec_sub(face->high, face->low), t) / 2;
    const int points = 2 * half > s->foot ? 2 : 1;
    int k;
    for (k = 0; k < points; k++) {
        out[k].a = s->index_a;
        out[k].b = s->index_b;
        out[k].mu = s->mu;
        out[k].n = n;
        out[k].line = points > 1;
        out[k].p = mid;
        out[k].travel = 0;
    }
    if (points > 1) {
        out[0].p = kern_vec_step(mid, -half, t);
        out[1].p = kern_vec_step(mid, half, t);
    }
    return points;
}

/* Merges the raw contacts of the pair to faces. */
static void kern_search_merge(kern_search *s)
{
    int done = s->first, raw = s->first;
    while (raw < s->count) {
        const int lead = kern_face_lead(s, raw);
        kern_face face;
        int i, rest = s->count;
        kern_face_open(&face, &s->out[lead]);
        for (i = s->count - 1; i >= raw; i--) {
            const int second = i;
            if (s->out[i].line)
                i--; /* both ends at once */
            if (i == lead || kern_face_takes(&face, s, &s->out[i])) {
                kern_face_join(&face, s, &s->out[i]);
                continue;
            }
            s->out[--rest] = s->out[second];
            if (second > i)
                s->out[--rest] = s->out[i];
        }
        done += kern_face_write(&face, s, &s->out[done]);
        raw = rest;
    }
    s->count = done;
}

/* ---- pairs of blocks ---- */

/* Sets the pair and its lengths; 0: these two have no contacts. */
static int kern_search_pair(kern_search *s, int a, int b)
{
    kern_real size;
    s->index_a = a < b ? a : b;
    s->index_b = a < b ? b : a;
    s->a = &s->block[s->index_a];
    s->b = &s->block[s->index_b];
    if ((s->a->fixed && s->b->fixed) || !s->a->vertices || !s->b->vertices)
        return 0;
    if (s->a->fixed)
        size = kern_block_size(s->b);
    else if (s->b->fixed)
        size = kern_block_size(s->a);
    else
        size = kern_min(kern_block_size(s->a), kern_block_size(s->b));
    s->gap = s->user_gap > 0 ? s->user_gap : KERN_GAP * size;
    s->gap = kern_max(s->gap, s->floor);
    s->least = kern_max(kern_min(s->gap, KERN_GAP * size), s->floor);
    s->foot = kern_max(KERN_FOOT * size, s->floor);
    return 1;
}

/* Goes over the pairs of edges, once for lines and once for points. */
static kern_status kern_search_edges(kern_search *s, int points)
{
    kern_pairs pairs;
    kern_status status = KERN_STANDS;
    kern_pairs_open(&pairs, s->a, s->b, s->gap);
    while (status >= 0 && kern_pairs_next(&pairs)) {
        if (!points)
            status = kern_search_line(s, pairs.i, pairs.j);
        else
            status = kern_search_point(s, s->a, pairs.i, s->b, pairs.j);
        if (points && status >= 0)
            status = kern_search_point(s, s->b, pairs.j, s->a, pairs.i);
    }
    return status;
}

/* Finds the contacts of the pair and appends them. */
static kern_status kern_search_touch(kern_search *s)
{
    const kern_real depth = kern_overlap(s->a, s->b, s->gap);
    kern_status status;
    int i;
    if (depth > 0) {
        s->fault->other = s->index_b;
        return kern_fault_set(s->fault, KERN_OVERLAP, s->index_a, -1, depth);
    }
    s->first = s->count;
    status = kern_search_edges(s, 0);
    s->lines = s->count;
    if (status >= 0)
        status = kern_search_edges(s, 1);
    if (status < 0)
        return status;
    kern_search_merge(s);
    if (s->count > s->first)
        kern_contact_travels(s->out + s->first, s->count - s->first);
    for (i = s->first; i < s->count; i++)
        if (kern_abs(s->out[i].travel) < KERN_TRAVEL * s->mean)
            s->out[i].travel = 0;
    return KERN_STANDS;
}

/* All later blocks whose boxes are near that of block a. */
static kern_status kern_search_later(kern_search *s, int a)
{
    const kern_box box_a = kern_polygon_box(&s->block[a]);
    kern_status status = KERN_STANDS;
    int b;
    for (b = a + 1; b < s->blocks && status >= 0; b++) {
        kern_box box_b;
        if (!kern_search_pair(s, a, b))
            continue;
        box_b = kern_box_grow(kern_polygon_box(s->b), s->gap);
        if (kern_box_meets(&box_a, &box_b))
            status = kern_search_touch(s);
    }
    return status;
}

/* ---- what is read ---- */

static kern_status kern_options_check(const kern_options *o)
{
    if (!kern_is_finite(o->mu) || !kern_is_finite(o->gap)
        || !kern_is_finite(o->angle) || !kern_is_finite(o->epsilon))
        return KERN_BAD_NUMBER;
    if (o->mu < 0)
        return KERN_BAD_FRICTION;
    if (o->gap < 0 || !(o->angle > 0) || !(o->angle < KERN_R(0.5))
        || o->epsilon < 0 || o->pivots < 0)
        return KERN_BAD_OPTION;
    return KERN_STANDS;
}

/* Checks what the search reads of block i; raises *largest to its largest
   coordinate. */
static kern_status kern_search_check(const kern_search *s, int i,
                                     kern_real *largest)
{
    const kern_block *block = &s->block[i];
    int k;
    if (block->vertices < 0 || block->vertices > KERN_VERTICES_MOST)
        return kern_fault_set(s->fault, KERN_BAD_COUNT, i, -1,
                              KERN_R(block->vertices));
    if (!block->vertices)
        return KERN_STANDS;
    if (block->vertices < 3)
        return kern_fault_set(s->fault, KERN_FEW_VERTICES, i, -1,
                              KERN_R(block->vertices));
    if (!block->vertex)
        return kern_fault_set(s->fault, KERN_BAD_POINTER, i, -1, 0);
    if (!kern_is_finite(block->area))
        return kern_fault_set(s->fault, KERN_BAD_NUMBER, i, -1, block->area);
    if (!(kern_abs(block->area) > 0))
        return kern_fault_set(s->fault, KERN_NO_AREA, i, -1, block->area);
    for (k = 0; k < block->vertices; k++) {
        const kern_vec p = block->vertex[k];
        if (!kern_is_moderate(p.x) || !kern_is_moderate(p.y))
            return kern_fault_set(s->fault, KERN_BAD_NUMBER, i, k,
                                  kern_is_moderate(p.x) ? p.y : p.x);
        *largest = kern_max(*largest, kern_vec_largest(p));
    }
    return KERN_STANDS;
}

static kern_status kern_search_open(kern_search *s, const kern_block *block,
                                    int blocks, const kern_options *options,
                                    kern_contact *out, int room)
{
    const kern_options chosen = options ? *options : kern_defaults();
    kern_status status = kern_options_check(&chosen);
    kern_real largest = 0;
    int i;
    if (status < 0)
        return status;
    if (!kern_is_moderate(chosen.gap)) /* normals are weighted with it */
        return KERN_BAD_OPTION;
    if (blocks < 0 || blocks > KERN_COUNT_MOST || room < 0)
        return KERN_BAD_COUNT;
    if ((blocks > 0 && !block) || (room > 0 && !out))
        return KERN_BAD_POINTER;
    s->block = block;
    s->blocks = blocks;
    s->out = out;
    s->room = room;
    s->count = s->first = s->lines = 0;
    for (i = 0; i < blocks && status >= 0; i++)
        status = kern_search_check(s, i, &largest);
    s->floor = KERN_FLOOR * largest;
    s->mean = kern_mean_size(block, blocks);
    s->mu = chosen.mu;
    s->sine = kern_sine(chosen.angle);
    s->user_gap = chosen.gap;
    return status;
}

KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options, kern_contact *out,
                           int room, kern_fault *fault)
{
    kern_fault ignored;
    kern_search s;
    kern_status status;
    int a;
    kern_fault_clear(&ignored);
    s.fault = fault ? fault : &ignored;
    kern_fault_clear(s.fault);
    status = kern_search_open(&s, block, blocks, options, out, room);
    for (a = 0; a < blocks && status >= 0; a++)
        if (block[a].vertices)
            status = kern_search_later(&s, a);
    return status < 0 ? (int)status : s.count;
}

KERN_API int kern_touch(const kern_block *block, int blocks, int a, int b,
                        const kern_options *options, kern_contact *out,
                        int room, kern_fault *fault)
{
    kern_fault ignored;
    kern_search s;
    kern_status status;
    kern_fault_clear(&ignored);
    s.fault = fault ? fault : &ignored;
    kern_fault_clear(s.fault);
    status = kern_search_open(&s, block, blocks, options, out, room);
    if (status < 0)
        return (int)status;
    if (a < 0 || a >= blocks || b < 0 || b >= blocks)
        return (int)KERN_BAD_BLOCK;
    if (a == b)
        return (int)KERN_SAME_BLOCK;
    if (kern_search_pair(&s, a, b))
        status = kern_search_touch(&s);
    return status < 0 ? (int)status : s.count;
}

/* ---- contacts that are given ---- */

KERN_API int kern_contact_make(int a, int b, kern_vec normal, kern_vec p,
                               kern_vec q, kern_real mu,
                               const kern_options *options, kern_contact *out)
{
    const kern_options chosen = options ? *options : kern_defaults();
    const kern_vec d = kern_vec_sub(q, p);
    const kern_real length = kern_vec_length(d);
    const kern_real near_by =
        KERN_FLOOR * kern_max(kern_vec_largest(p), kern_vec_largest(q));
    kern_real along;
    int k, points;
    if (kern_options_check(&chosen) < 0)
        return (int)kern_options_check(&chosen);
    if (!out)
        return (int)KERN_BAD_POINTER;
    if (a < 0 || b < 0)
        return (int)KERN_BAD_BLOCK;
    if (a == b)
        return (int)KERN_SAME_BLOCK;
    if (!kern_vec_is_finite(normal) || !kern_is_finite(mu) ||
        !kern_vec_is_finite(p) || !kern_is_finite(length))
        return (int)KERN_BAD_NUMBER;
    if (mu < 0)
        return (int)KERN_BAD_FRICTION;
    if (!(kern_vec_largest(normal) > 0))
        return (int)KERN_BAD_NORMAL;
    /* first made about 1 long: its square may be no number */
    normal = kern_vec_scale(normal, 1 / kern_vec_largest(normal));
    normal = kern_vec_unit(normal);
    points = length > near_by ? 2 : 1;
    if (points > 1 && kern_abs(kern_vec_dot(d, normal)) >
                      kern_sine(chosen.angle) * length)
        return (int)KERN_BAD_LINE;
    along = points > 1 ? kern_vec_dot(d, kern_vec_turn(normal)) : 0;
    for (k = 0; k < points; k++) {
        out[k].a = a;
        out[k].b = b;
        out[k].line = points > 1;
        out[k].p = (k > 0) == (along < 0) ? p : q;
        out[k].n = normal;
        out[k].mu = mu;
        out[k].travel = (k > 0 ? -1 : 1) * kern_abs(along) / 2;
    }
    return points;
}

static int kern_same_interface(const kern_contact *c, const kern_contact *d)
{
    return (c->a == d->a && c->b == d->b) || (c->a == d->b && c->b == d->a);
}

/* The next point contact of the interface of c, from i on. */
static int kern_next_point(const kern_contact *contact, int contacts, int i,
                           const kern_contact *c)
{
    while (i < contacts &&
           (contact[i].line || !kern_same_interface(&contact[i], c)))
        i++;
    return i;
}

/* Midpoint of the two points of the interface that are farthest apart. */
static kern_vec kern_interface_centre(const kern_contact *contact, int contacts,
                                      int first)
{
    const kern_contact *c = &contact[first];
    kern_vec centre = c->p;
    kern_real widest = 0;
    int i, j;
    for (i = first; i < contacts;
         i = kern_next_point(contact, contacts, i + 1, c)) {
        j = kern_next_point(contact, contacts, i + 1, c);
        for (; j < contacts; j = kern_next_point(contact, contacts, j + 1, c)) {
            const kern_vec d = kern_vec_sub(contact[j].p, contact[i].p);
            if (kern_vec_dot(d, d) > widest) {
                widest = kern_vec_dot(d, d);
                centre = kern_vec_mid(contact[i].p, contact[j].p);
            }
        }
    }
    return centre;
}

/* The ends of a line go to its middle, the points of an interface to its
   centre; a lone point is its own centre and stays. */
KERN_API void kern_contact_travels(kern_contact *contact, int contacts)
{
    int i, j;
    for (i = 0; i < contacts; i++) {
        kern_contact *c = &contact[i];
        if (c->line && i + 1 < contacts) {
            const kern_vec d = kern_vec_sub(c[1].p, c->p);
            c->travel = kern_vec_dot(d, kern_vec_turn(c->n)) / 2;
            c[1].travel = -c->travel;
            i++;
        } else if (!c->line &&
                   kern_next_point(contact, i, 0, c) >= i) {
            const kern_vec q = kern_interface_centre(contact, contacts, i);
            for (j = i; j < contacts;
                 j = kern_next_point(contact, contacts, j + 1, c))
                contact[j].travel =
                    kern_vec_dot(kern_vec_sub(q, contact[j].p),
                                 kern_vec_turn(contact[j].n));
        }
    }
}


/* ---- Work arrays ------------------------------------------------- >>work */
/* Slices are handed out one after the other. Without arrays (real NULL) they
   are only counted: one layout function says both what is needed and where it
   lies, so the two cannot disagree. */

typedef struct kern_take {
    kern_real *real;
    int *index;
    int reals, indices;         /* there are */
    int used_reals, used_ints;  /* handed out */
} kern_take;

static void kern_take_open(kern_take *take, const kern_work *work)
{
    take->real = work->real;
    take->index = work->index;
    take->reals = work->real ? work->reals : 0;
    take->indices = work->index ? work->indices : 0;
    take->used_reals = take->used_ints = 0;
}

static kern_real *kern_take_reals(kern_take *take, int n)
{
    const int at = take->used_reals;
    take->used_reals += n;
    return take->real && take->used_reals <= take->reals ? take->real + at
                                                         : NULL;
}

static int *kern_take_ints(kern_take *take, int n)
{
    const int at = take->used_ints;
    take->used_ints += n;
    return take->index && take->used_ints <= take->indices ? take->index + at
                                                           : NULL;
}

static int kern_take_fits(const kern_take *take)
{
    return take->used_reals <= take->reals && take->used_ints <= take->indices;
}
/* ---- The LP room --------------------------------------------------- >>lp */
/* minimise cost . x  where  A x = rhs,  x >= 0.

   The basis is kept as a cheap base B0 and a small dense complement. Columns
   of a network (`ends` given) touch one or two groups of three rows. In the
   order in which groups carry each other, each group takes the best three of
   the basic columns that lead from it to later groups or to none, so

            | D1          |     B0 is block lower triangular, its blocks D are
       B0 = | *  D2       |     3 x 3, and a solve costs a few products a
            | *  *  D3    |     group.

   Basic columns that found no place are the extras E, and the slots of B0 that
   hold a column which is not basic (or none: a filler, a unit vector that
   completes D) are its spares. With S = (B0^-1 E) at the spare slots,

       B x = b:      v = B0^-1 b,  S z = v_spare,  x = B0^-1 (b - E z)
       B' y = c:     w = B0^-T c,  S' u = c_E - E' w,  y = B0^-T (c + u)

   S is dense and as small as the basis is unbalanced: 0 for a tower, a third
   of the number of groups for a wall. A pivot changes S by a row and a column
   at the most, and S^-1, which is what is stored, by one rank. Without `ends`
   the base is the unit matrix and S is the basis itself: the usual small dense
   simplex, by the same code. */

typedef struct kern_program {
    int rows, cols;
    const kern_real *a;     /* dense: rows x cols by columns; network: 4 a
                               column, (u, v, r) in the head's rows and
                               (-u, -v, s) in the tail's                      */
    const kern_real *rhs;
    const kern_real *cost;  /* or NULL                                        */
    const int *ends;        /* network: head and tail group of a column, -1
                               for none; NULL: dense                          */
    const int *order;       /* network: the groups, each before those that
                               carry it                                       */
    const kern_real *scale; /* network: what is large for a group             */
    kern_real most;         /* what a variable can be at the most; 0: all     */
    int pivots;             /* limit                                          */
} kern_program;

typedef struct kern_simplex {
    const kern_program *lp;
    int groups;             /* of a network, else 0                           */
    int room;               /* most extras, and the stride of inv             */
    int extras;             /* in use: the size of S                          */
    int pivots;             /* since the last refactorisation                 */
    int ray;                /* unbounded: the column that rises without end   */
    int started;            /* there is a basis                               */
    int stale;              /* the matrix has changed since                   */
    int settled;            /* no pivot since the values were refined         */
    kern_real unit;         /* what counts as 1 in the right-hand side        */
    int *base;              /* variable of a slot: column, or cols + row of a
                               filler, a unit vector                          */
    int *spare;             /* slot: its row of S, or -1 where it is basic    */
    int *extra;             /* column of an extra                             */
    int *slot;              /* slot of a row of S                             */
    int *place;             /* column: slot, KERN_OUT, or -2 - its extra      */
    int *link;              /* scratch: 2 groups + 5 rows                     */
    kern_real *block;       /* D^-1, 9 a group                                */
    kern_real *inv;         /* S^-1                                           */
    kern_real *value;       /* of the variable in a slot; 0 in spare ones     */
    kern_real *value_extra;
    kern_real *alpha;       /* entering column in terms of the basis          */
    kern_real *alpha_extra;
    kern_real *row;         /* prices y; rows + room, as temp                 */
    kern_real *row_extra;
    kern_real *temp;        /* scratch                                        */
} kern_simplex;

#define KERN_OUT (-1)

/* ---- columns ---- */

/* The three entries of network column j in group g, one of its ends. */
static void kern_lp_part(const kern_program *lp, int j, int g, kern_real out[3])
{
    const kern_real *c = lp->a + 4 * j;
    if (lp->ends[2 * j] == g) {
        out[0] = c[0]; out[1] = c[1]; out[2] = c[2];
    } else {
        out[0] = -c[0]; out[1] = -c[1]; out[2] = c[3];
    }
}

static kern_real kern_lp_dot(const kern_program *lp, int j, const kern_real *y)
{
    kern_real sum = KERN_R(0);
    int i;
    if (lp->ends) {
        const kern_real *c = lp->a + 4 * j;
        const int head = lp->ends[2 * j], tail = lp->ends[2 * j + 1];
        if (head >= 0) {
            const kern_real *h = y + 3 * head;
            sum += c[0] * h[0] + c[1] * h[1] + c[2] * h[2];
        }
        if (tail >= 0) {
            const kern_real *t = y + 3 * tail;
            sum += c[3] * t[2] - c[0] * t[0] - c[1] * t[1];
        }
    } else {
        const kern_real *c = lp->a + (size_t)j * (size_t)lp->rows;
        for (i = 0; i < lp->rows; i++)
            sum += c[i] * y[i];
    }
    return sum;
}

/* v -= s * column j */
static void kern_lp_subtract(const kern_program *lp, int j, kern_real s,
                             kern_real *v)
{
    int i;
    if (lp->ends) {
        const kern_real *c = lp->a + 4 * j;
        const int head = lp->ends[2 * j], tail = lp->ends[2 * j + 1];
        if (head >= 0) {
            kern_real *h = v + 3 * head;
            h[0] -= s * c[0]; h[1] -= s * c[1]; h[2] -= s * c[2];
        }
        if (tail >= 0) {
            kern_real *t = v + 3 * tail;
            t[0] += s * c[0]; t[1] += s * c[1]; t[2] -= s * c[3];
        }
    } else {
        const kern_real *c = lp->a + (size_t)j * (size_t)lp->rows;
        for (i = 0; i < lp->rows; i++)
            v[i] -= s * c[i];
    }
}

/* How large is large for the variable of column j: what the groups it touches
   carry by themselves. */
static kern_real kern_lp_scale(const kern_program *lp, int j, kern_real unit)
{
    kern_real scale = unit;
    if (lp->scale) {
        const int head = lp->ends[2 * j], tail = lp->ends[2 * j + 1];
        if (head >= 0)
            scale = lp->scale[head];
        if (tail >= 0 && (head < 0 || lp->scale[tail] < scale))
            scale = lp->scale[tail];
    }
    return scale;
}

/* ---- solves with the base ---- */

/* v := B0^-1 v, group by group in the order of carrying */
static void kern_base_solve(const kern_simplex *sx, kern_real *v)
{
    int i, s;
    for (i = 0; i < sx->groups; i++) {
        const int g = sx->lp->order[i];
        const kern_real *d = sx->block + 9 * g;
        kern_real *x = v + 3 * g;
        const kern_real b0 = x[0], b1 = x[1], b2 = x[2];
        if (b0 >= 0 && b0 <= 0 && b1 >= 0 && b1 <= 0 && b2 >= 0 && b2 <= 0)
            continue;
        x[0] = d[0] * b0 + d[1] * b1 + d[2] * b2;
        x[1] = d[3] * b0 + d[4] * b1 + d[5] * b2;
        x[2] = d[6] * b0 + d[7] * b1 + d[8] * b2;
        for (s = 0; s < 3; s++) {
            const int j = sx->base[3 * g + s];
            if (j < sx->lp->cols) {
                const kern_real *c = sx->lp->a + 4 * j;
                const int head = sx->lp->ends[2 * j];
                const int tail = sx->lp->ends[2 * j + 1];
                if (head == g) {
                    if (tail >= 0) {
                        kern_real *t = v + 3 * tail;
                        t[0] += x[s] * c[0]; t[1] += x[s] * c[1];
                        t[2] -= x[s] * c[3];
                    }
                } else if (head >= 0) {
                    kern_real *h = v + 3 * head;
                    h[0] -= x[s] * c[0]; h[1] -= x[s] * c[1];
                    h[2] -= x[s] * c[2];
                }
            }
        }
    }
}

/* c := B0^-T c, in the opposite order */
static void kern_base_solve_t(const kern_simplex *sx, kern_real *c)
{
    int i, s;
    for (i = sx->groups - 1; i >= 0; i--) {
        const int g = sx->lp->order[i];
        const kern_real *d = sx->block + 9 * g;
        kern_real *y = c + 3 * g;
        kern_real b0, b1, b2;
        for (s = 0; s < 3; s++) {
            const int j = sx->base[3 * g + s];
            if (j < sx->lp->cols) {
                const kern_real *col = sx->lp->a + 4 * j;
                const int head = sx->lp->ends[2 * j];
                const int tail = sx->lp->ends[2 * j + 1];
                if (head == g) {
                    if (tail >= 0) {
                        const kern_real *t = c + 3 * tail;
                        y[s] += col[0] * t[0] + col[1] * t[1] - col[3] * t[2];
                    }
                } else if (head >= 0) {
                    const kern_real *h = c + 3 * head;
                    y[s] -= col[0] * h[0] + col[1] * h[1] + col[2] * h[2];
                }
            }
        }
        b0 = y[0]; b1 = y[1]; b2 = y[2];
        y[0] = d[0] * b0 + d[3] * b1 + d[6] * b2;
        y[1] = d[1] * b0 + d[4] * b1 + d[7] * b2;
        y[2] = d[2] * b0 + d[5] * b1 + d[8] * b2;
    }
}

/* ---- solves with the basis ---- */

/* v := the part of B^-1 v in the slots, ve := the part in the extras */
static void kern_basis_solve(kern_simplex *sx, kern_real *v, kern_real *ve)
{
    const int k = sx->extras, m = sx->lp->rows;
    int i, e;
    if (k > 0) {
        for (i = 0; i < m; i++)
            sx->temp[i] = v[i];
        kern_base_solve(sx, sx->temp);
        for (e = 0; e < k; e++) {
            const kern_real *inv = sx->inv + (size_t)e * (size_t)sx->room;
            kern_real sum = KERN_R(0);
            for (i = 0; i < k; i++)
                sum += inv[i] * sx->temp[sx->slot[i]];
            ve[e] = sum;
        }
        for (e = 0; e < k; e++)
            kern_lp_subtract(sx->lp, sx->extra[e], ve[e], v);
    }
    kern_base_solve(sx, v);
    for (i = 0; i < k; i++)
        v[sx->slot[i]] = KERN_R(0);
}

/* c := B^-T (c, ce), where c has the slots' and ce the extras' part; ce
   becomes the part u at the spare slots. */
static void kern_basis_solve_t(kern_simplex *sx, kern_real *c, kern_real *ce)
{
    const int k = sx->extras, m = sx->lp->rows;
    int i, e;
    if (k > 0) {
        for (i = 0; i < k; i++)
            c[sx->slot[i]] = KERN_R(0);
        for (i = 0; i < m; i++)
            sx->temp[i] = c[i];
        kern_base_solve_t(sx, sx->temp);
        for (e = 0; e < k; e++)
            ce[e] -= kern_lp_dot(sx->lp, sx->extra[e], sx->temp);
        for (i = 0; i < k; i++)
            sx->temp[i] = KERN_R(0);
        for (e = 0; e < k; e++) {
            const kern_real *inv = sx->inv + (size_t)e * (size_t)sx->room;
            const kern_real h = ce[e];
            for (i = 0; i < k; i++)
                sx->temp[i] += inv[i] * h;
        }
        for (i = 0; i < k; i++) {
            ce[i] = sx->temp[i];
            c[sx->slot[i]] = ce[i];
        }
    }
    kern_base_solve_t(sx, c);
}

/* ---- choosing the base ---- */

/* Chooses, of the columns list[0..n) that touch group g, up to three whose
   parts in g are far from dependent (Gram-Schmidt, largest rest first), puts
   them into the slots of g, completes them with unit vectors and stores the
   inverse of the 3 x 3 block. */
static void kern_base_fill(kern_simplex *sx, int g, const int *list, int n)
{
    const kern_program *lp = sx->lp;
    kern_real q[3][3], d[9], part[3], best[3], det;
    kern_real *inv = sx->block + 9 * g;
    int s, i, k, r;
    for (s = 0; s < 3; s++) {
        kern_real most = KERN_R(0), size = KERN_R(0);
        int take = -1;
        for (i = 0; i < n; i++) {
            kern_real whole, rest;
            int taken = 0;
            for (k = 0; k < s; k++)
                taken |= sx->base[3 * g + k] == list[i];
            if (taken)
                continue;
            kern_lp_part(lp, list[i], g, part);
            whole = part[0] * part[0] + part[1] * part[1] + part[2] * part[2];
            for (k = 0; k < s; k++) {
                const kern_real along = part[0] * q[k][0] + part[1] * q[k][1]
                                        + part[2] * q[k][2];
                for (r = 0; r < 3; r++)
                    part[r] -= along * q[k][r];
            }
            rest = part[0] * part[0] + part[1] * part[1] + part[2] * part[2];
            if (rest > most && rest > KERN_BASE_TOL * whole) {
                most = rest;
                take = list[i];
                for (r = 0; r < 3; r++)
                    best[r] = part[r];
            }
        }
        if (take >= 0) {
            sx->base[3 * g + s] = take;
            sx->place[take] = 3 * g + s;
            kern_lp_part(lp, take, g, part);
        } else {
            /* the unit vector farthest from what is there */
            int far = 0;
            for (i = 0; i < 3; i++) {
                kern_real unit[3], rest;
                for (r = 0; r < 3; r++)
                    unit[r] = r == i ? KERN_R(1) : KERN_R(0);
                for (k = 0; k < s; k++)
                    for (r = 0; r < 3; r++)
                        unit[r] -= q[k][i] * q[k][r];
                rest = unit[0] * unit[0] + unit[1] * unit[1]
                       + unit[2] * unit[2];
                if (rest > most) {
                    most = rest;
                    far = i;
                    for (r = 0; r < 3; r++)
                        best[r] = unit[r];
                }
            }
            sx->base[3 * g + s] = lp->cols + 3 * g + far;
            for (r = 0; r < 3; r++)
                part[r] = r == far ? KERN_R(1) : KERN_R(0);
        }
        size = KERN_SQRT(most);
        for (r = 0; r < 3; r++) {
            q[s][r] = best[r] / size;
            d[3 * r + s] = part[r];
        }
    }
    det = d[0] * (d[4] * d[8] - d[5] * d[7])
          - d[1] * (d[3] * d[8] - d[5] * d[6])
          + d[2] * (d[3] * d[7] - d[4] * d[6]);
    inv[0] = (d[4] * d[8] - d[5] * d[7]) / det;
    inv[1] = (d[2] * d[7] - d[1] * d[8]) / det;
    inv[2] = (d[1] * d[5] - d[2] * d[4]) / det;
    inv[3] = (d[5] * d[6] - d[3] * d[8]) / det;
    inv[4] = (d[0] * d[8] - d[2] * d[6]) / det;
    inv[5] = (d[2] * d[3] - d[0] * d[5]) / det;
    inv[6] = (d[3] * d[7] - d[4] * d[6]) / det;
    inv[7] = (d[1] * d[6] - d[0] * d[7]) / det;
    inv[8] = (d[0] * d[4] - d[1] * d[3]) / det;
}

/* ---- exchanging columns ---- */

static void kern_basis_column(kern_simplex *sx, int j)
{
    int i;
    for (i = 0; i < sx->lp->rows; i++)
        sx->alpha[i] = KERN_R(0);
    kern_lp_subtract(sx->lp, j, KERN_R(-1), sx->alpha);
    kern_basis_solve(sx, sx->alpha, sx->alpha_extra);
}

/* The row of B^-1 for slot s, at the spare slots: to sx->row_extra. */
static void kern_basis_row(kern_simplex *sx, int s)
{
    const int k = sx->extras;
    int i, e;
    for (i = 0; i < k; i++)
        sx->row_extra[i] = KERN_R(0);
    if (k == 0)
        return;
    for (i = 0; i < sx->lp->rows; i++)
        sx->temp[i] = KERN_R(0);
    sx->temp[s] = KERN_R(1);
    kern_base_solve_t(sx, sx->temp);
    for (e = 0; e < k; e++) {
        const kern_real *inv = sx->inv + (size_t)e * (size_t)sx->room;
        const kern_real h = kern_lp_dot(sx->lp, sx->extra[e], sx->temp);
        for (i = 0; i < k; i++)
            sx->row_extra[i] -= inv[i] * h;
    }
}

/* Slot s is left by its basic variable, and q enters as a new extra: S gains
   a row and a column. */
static void kern_extra_add(kern_simplex *sx, int s, int q)
{
    const int k = sx->extras;
    const size_t n = (size_t)sx->room;
    const kern_real *z = sx->alpha_extra, *u = sx->row_extra;
    const kern_real one = KERN_R(1) / sx->alpha[s];
    int e, i;
    for (e = 0; e < k; e++) {
        kern_real *inv = sx->inv + (size_t)e * n;
        const kern_real f = z[e] * one;
        for (i = 0; i < k; i++)
            inv[i] -= f * u[i];
        inv[k] = -f;
    }
    for (i = 0; i < k; i++)
        sx->inv[(size_t)k * n + (size_t)i] = u[i] * one;
    sx->inv[(size_t)k * n + (size_t)k] = one;
    sx->extra[k] = q;
    sx->slot[k] = s;
    sx->spare[s] = k;
    sx->place[q] = -2 - k;
    sx->extras = k + 1;
}

/* Extra e gives its place to q: a column of S is replaced. */
static void kern_extra_replace(kern_simplex *sx, int e, int q)
{
    const int k = sx->extras;
    const size_t n = (size_t)sx->room;
    const kern_real *z = sx->alpha_extra;
    kern_real *pivot = sx->inv + (size_t)e * n;
    const kern_real one = KERN_R(1) / z[e];
    int r, i;
    for (i = 0; i < k; i++)
        pivot[i] *= one;
    for (r = 0; r < k; r++) {
        kern_real *inv = sx->inv + (size_t)r * n;
        if (r != e)
            for (i = 0; i < k; i++)
                inv[i] -= z[r] * pivot[i];
    }
    sx->extra[e] = q;
    sx->place[q] = -2 - e;
}

/* Slot s is left by its variable and the spare slot of row u returns with the
   column that it kept: a row of S is replaced. */
static void kern_spare_swap(kern_simplex *sx, int s, int u)
{
    const int k = sx->extras;
    const size_t n = (size_t)sx->room;
    const kern_real *g = sx->row_extra;
    const kern_real one = KERN_R(1) / g[u];
    int e, i;
    for (e = 0; e < k; e++) {
        kern_real *inv = sx->inv + (size_t)e * n;
        const kern_real f = inv[u] * one;
        for (i = 0; i < k; i++)
            inv[i] -= f * g[i];
        inv[u] = -f;
    }
    sx->spare[sx->slot[u]] = -1;
    sx->slot[u] = s;
    sx->spare[s] = u;
}

/* Extra e leaves and the spare slot of row u returns: S loses a row and a
   column; the last ones fill the gap. */
static void kern_extra_drop(kern_simplex *sx, int e, int u)
{
    const int k = sx->extras, last = k - 1;
    const size_t n = (size_t)sx->room;
    kern_real *pivot = sx->inv + (size_t)e * n;
    const kern_real one = KERN_R(1) / pivot[u];
    int r, i;
    for (r = 0; r < k; r++) {
        kern_real *inv = sx->inv + (size_t)r * n;
        const kern_real f = inv[u] * one;
        if (r != e)
            for (i = 0; i < k; i++)
                if (i != u)
                    inv[i] -= f * pivot[i];
    }
    sx->spare[sx->slot[u]] = -1;
    for (i = 0; i < k; i++)
        pivot[i] = sx->inv[(size_t)last * n + (size_t)i];
    for (r = 0; r < last; r++)
        sx->inv[(size_t)r * n + (size_t)u] =
            sx->inv[(size_t)r * n + (size_t)last];
    if (e != last) {
        sx->extra[e] = sx->extra[last];
        sx->place[sx->extra[e]] = -2 - e;
    }
    if (u != last) {
        sx->slot[u] = sx->slot[last];
        sx->spare[sx->slot[u]] = u;
    }
    sx->extras = last;
}

/* Which position a variable enters and which it leaves decides which of the
   four happens. `position` is a slot, or -2 - an extra. */
static void kern_basis_exchange(kern_simplex *sx, int q, int position)
{
    const int home = sx->place[q];  /* a spare slot, or KERN_OUT */
    if (position >= 0) {
        if (home == KERN_OUT)
            kern_extra_add(sx, position, q);
        else
            kern_spare_swap(sx, position, sx->spare[home]);
    } else {
        const int e = -2 - position;
        sx->place[sx->extra[e]] = KERN_OUT;
        if (home == KERN_OUT)
            kern_extra_replace(sx, e, q);
        else
            kern_extra_drop(sx, e, sx->spare[home]);
    }
}

static int kern_is_basic(const kern_simplex *sx, int j)
{
    const int p = sx->place[j];
    return p <= -2 || (p >= 0 && sx->spare[p] < 0);
}

/* ---- the basis from nothing ---- */

/* Sorts the basic columns list[0..n) by the first of their groups in the order
   in which groups carry each other, so that loads pass through the base in one
   direction, and lets every group take three. What is left over goes to
   `over`; returns how many columns are. */
static int kern_base_sort(kern_simplex *sx, const int *list, int n, int *over)
{
    const kern_program *lp = sx->lp;
    const int G = sx->groups;
    int *first = sx->link, *rank = first + G, *next = rank + G;
    int *mine = next + n;
    int i, left = 0;
    for (i = 0; i < G; i++) {
        first[i] = -1;
        rank[lp->order[i]] = i;
    }
    for (i = n - 1; i >= 0; i--) {
        const int head = lp->ends[2 * list[i]];
        const int tail = lp->ends[2 * list[i] + 1];
        const int g = head < 0 || (tail >= 0 && rank[tail] < rank[head])
                      ? tail : head;
        next[i] = first[g];
        first[g] = i;
    }
    for (i = 0; i < G; i++) {
        const int g = lp->order[i];
        int k, count = 0;
        for (k = first[g]; k >= 0; k = next[k])
            mine[count++] = list[k];
        kern_base_fill(sx, g, mine, count);
        for (k = 0; k < count; k++)
            if (sx->place[mine[k]] == KERN_OUT)
                over[left++] = mine[k];
    }
    return left;
}

/* What found no place in the base, over[0..left), becomes extras: S is made at
   the fillers' slots, and inverted where it stands (Gauss and Jordan, the
   largest pivot of each column). A column that depends on those before it
   leaves the basis, and a filler stays in it. */
static void kern_extras_make(kern_simplex *sx, const int *over, int left)
{
    const kern_program *lp = sx->lp;
    const size_t n = (size_t)sx->room;
    int rows = 0, k = left < sx->room ? left : sx->room;
    int r, c, i, t;
    for (r = 0; r < lp->rows && rows < sx->room; r++)
        if (sx->base[r] >= lp->cols)
            sx->slot[rows++] = r;
    if (k > rows)
        k = rows;
    for (c = 0; c < k; c++) {
        sx->extra[c] = over[c];
        for (i = 0; i < lp->rows; i++)
            sx->temp[i] = KERN_R(0);
        kern_lp_subtract(lp, over[c], KERN_R(-1), sx->temp);
        kern_base_solve(sx, sx->temp);
        for (r = 0; r < rows; r++)
            sx->inv[(size_t)r * n + (size_t)c] = sx->temp[sx->slot[r]];
    }
    for (t = 0; t < k; ) {
        kern_real *pivot = sx->inv + (size_t)t * n, one;
        int best = t;
        for (r = t + 1; r < rows; r++)
            if (kern_abs(sx->inv[(size_t)r * n + (size_t)t])
                > kern_abs(sx->inv[(size_t)best * n + (size_t)t]))
                best = r;
        if (kern_abs(sx->inv[(size_t)best * n + (size_t)t])
            < KERN_RANK_TOL) {
            k--;
            sx->extra[t] = sx->extra[k];
            for (r = 0; r < rows; r++)
                sx->inv[(size_t)r * n + (size_t)t] =
                    sx->inv[(size_t)r * n + (size_t)k];
            continue;
        }
        for (c = 0; c < k && best != t; c++) {
            const kern_real swap = pivot[c];
            pivot[c] = sx->inv[(size_t)best * n + (size_t)c];
            sx->inv[(size_t)best * n + (size_t)c] = swap;
        }
        i = sx->slot[t];
        sx->slot[t] = sx->slot[best];
        sx->slot[best] = i;
        one = KERN_R(1) / pivot[t];
        pivot[t] = KERN_R(1);
        for (c = 0; c < k; c++)
            pivot[c] *= one;
        for (r = 0; r < rows; r++) {
            kern_real *row = sx->inv + (size_t)r * n;
            const kern_real f = row[t];
            if (r == t || (f >= 0 && f <= 0))
                continue;
            row[t] = KERN_R(0);
            for (c = 0; c < k; c++)
                row[c] -= f * pivot[c];
        }
        t++;
    }
    for (t = 0; t < k; t++) {
        sx->place[sx->extra[t]] = -2 - t;
        sx->spare[sx->slot[t]] = t;
    }
    sx->extras = k;
}

/* Chooses base and extras anew for the basic columns as they are now. */
static void kern_basis_refactor(kern_simplex *sx)
{
    const int m = sx->lp->rows, cols = sx->lp->cols;
    int *list = sx->link + 2 * sx->groups + 3 * m, *over = list + m;
    int n = 0, i, left;
    for (i = 0; i < m; i++)
        if (sx->base[i] < cols) {
            sx->place[sx->base[i]] = KERN_OUT;
            if (sx->spare[i] < 0)
                list[n++] = sx->base[i];
        }
    for (i = 0; i < sx->extras; i++) {
        sx->place[sx->extra[i]] = KERN_OUT;
        list[n++] = sx->extra[i];
    }
    for (i = 0; i < m; i++) {
        sx->base[i] = cols + i;
        sx->spare[i] = -1;
    }
    sx->extras = 0;
    if (sx->groups > 0)
        left = kern_base_sort(sx, list, n, over);
    else
        for (left = 0; left < n; left++)
            over[left] = list[left];
    kern_extras_make(sx, over, left);
    sx->pivots = 0;
    sx->stale = 0;
}

/* The values of the basic variables, refined until what they leave of the
   right-hand side is rounding: the inverse grows with every course of a wall,
   and one solve may lose half of the digits. Returns 0 where it is not. */
static int kern_basis_values(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const int m = lp->rows;
    kern_real size = KERN_R(0), last = KERN_INFINITY, worst = KERN_R(0);
    int i, round;
    for (i = 0; i < m; i++) {
        sx->value[i] = KERN_R(0);
        size = kern_max(size, kern_abs(lp->rhs[i]));
    }
    for (i = 0; i < sx->extras; i++)
        sx->value_extra[i] = KERN_R(0);
    for (round = 0; round < 4; round++) {
        worst = KERN_R(0);
        for (i = 0; i < m; i++)
            sx->alpha[i] = lp->rhs[i];
        if (round > 0) {
            for (i = 0; i < m; i++) {
                const int j = sx->base[i];
                if (sx->spare[i] >= 0)
                    continue;
                if (j < lp->cols)
                    kern_lp_subtract(lp, j, sx->value[i], sx->alpha);
                else
                    sx->alpha[j - lp->cols] -= sx->value[i];
            }
            for (i = 0; i < sx->extras; i++)
                kern_lp_subtract(lp, sx->extra[i], sx->value_extra[i],
                                 sx->alpha);
            for (i = 0; i < m; i++)
                worst = kern_max(worst, kern_abs(sx->alpha[i]));
            if (worst <= KERN_REFINE_TOL * size || worst >= last)
                break;
            last = worst;
        }
        kern_basis_solve(sx, sx->alpha, sx->alpha_extra);
        for (i = 0; i < m; i++)
            sx->value[i] += sx->alpha[i];
        for (i = 0; i < sx->extras; i++)
            sx->value_extra[i] += sx->alpha_extra[i];
    }
    sx->settled = 1;
    return worst <= KERN_RENEW_TOL * size;
}

/* Begins anew from the basic columns: after a change of the matrix, and when
   pivots have made S larger or less accurate than it needs to be. */
static void kern_basis_renew(kern_simplex *sx)
{
    kern_basis_refactor(sx);
    kern_basis_values(sx);
}

/* ---- phase one ---- */
/* Every basis gives x with A x = rhs; phase one makes it non-negative. What it
   lowers is the sum of all violations: of negative columns and of fillers that
   are not zero, each in units of what is large for it. The prices of that sum,

       y = B^-T c,    c = -1 or +1 (in these units) for what violates, else 0,

   tell by y.A_j > 0 how fast the sum falls when column j enters. When no
   column lowers it and it is not zero, -y is a Farkas certificate, and the one
   that shows the largest sum of violations: what a step of Newton's method
   wants. */

/* The weight of a violation of variable j, and in `sign` which way v, if at
   all, violates. Columns may not be negative, fillers must be zero. */
static kern_real kern_violation(const kern_simplex *sx, int j, kern_real v,
                                int *sign)
{
    const kern_program *lp = sx->lp;
    const kern_real scale = j < lp->cols ? kern_lp_scale(lp, j, sx->unit)
        : lp->scale ? lp->scale[(j - lp->cols) / 3] : sx->unit;
    *sign = v < -KERN_FEAS_TOL * scale ? -1
            : j >= lp->cols && v > KERN_FEAS_TOL * scale ? 1 : 0;
    return 1 / scale;
}

/* What a violation costs: the price of a slot, or of an extra. */
static kern_real kern_slot_price(const kern_simplex *sx, int r)
{
    int sign = 0;
    kern_real w;
    if (sx->spare[r] >= 0 || (sx->value[r] >= 0 && sx->base[r] < sx->lp->cols))
        return KERN_R(0);
    w = kern_violation(sx, sx->base[r], sx->value[r], &sign);
    return KERN_R(sign) * w;
}

static kern_real kern_extra_price(const kern_simplex *sx, int e)
{
    int sign;
    const kern_real w = kern_violation(sx, sx->extra[e], sx->value_extra[e],
                                       &sign);
    return KERN_R(sign) * w;
}

/* y to sx->row; returns the sum of violations. */
static kern_real kern_phase_one_prices(kern_simplex *sx)
{
    kern_real sum = KERN_R(0);
    int i;
    for (i = 0; i < sx->lp->rows; i++) {
        sx->row[i] = kern_slot_price(sx, i);
        sum += sx->row[i] * sx->value[i];
    }
    for (i = 0; i < sx->extras; i++) {
        sx->row_extra[i] = kern_extra_price(sx, i);
        sum += sx->row_extra[i] * sx->value_extra[i];
    }
    if (sum > 0)
        kern_basis_solve_t(sx, sx->row, sx->row_extra);
    return sum;
}

/* One step of refinement for y = sx->row: the certificate -y must be zero on
   the basic columns to the last digits, or be `above` zero, as a share of its
   largest entry. */
static void kern_phase_one_refine(kern_simplex *sx, kern_real above)
{
    const kern_program *lp = sx->lp;
    kern_real size = KERN_R(0);
    int i;
    for (i = 0; i < lp->rows; i++)
        size = kern_max(size, kern_abs(sx->row[i]));
    for (i = 0; i < lp->rows; i++) {
        const int j = sx->base[i];
        sx->alpha[i] = kern_slot_price(sx, i)
            - (j < lp->cols ? kern_lp_dot(lp, j, sx->row) + above * size
                            : sx->row[j - lp->cols]);
    }
    for (i = 0; i < sx->extras; i++)
        sx->alpha_extra[i] = kern_extra_price(sx, i) - above * size
                             - kern_lp_dot(lp, sx->extra[i], sx->row);
    kern_basis_solve_t(sx, sx->alpha, sx->alpha_extra);
    for (i = 0; i < lp->rows; i++)
        sx->row[i] += sx->alpha[i];
}

/* Lifts a certificate y off the columns that it touches. Rounding puts it a
   little below zero there as often as above; a few roundings higher it costs
   of its power no more than all of x is worth, times those roundings. */
static void kern_certificate_lift(kern_simplex *sx, kern_real *y)
{
    int i;
    for (i = 0; i < sx->lp->rows; i++)
        sx->row[i] = -y[i];
    kern_phase_one_refine(sx, KERN_ABOVE);
    for (i = 0; i < sx->lp->rows; i++)
        y[i] = -sx->row[i];
}

/* The column that lowers the sum fastest, or the first that lowers it. One
   that would have to carry more than lp->most to undo it is no help: the
   bound on the forces of a jam. */
static int kern_phase_one_entering(const kern_simplex *sx, kern_real sum,
                                   int first, kern_real *gain)
{
    const kern_program *lp = sx->lp;
    kern_real size = KERN_R(0);
    int i, j, best = KERN_OUT;
    for (i = 0; i < lp->rows; i++)
        size = kern_max(size, kern_abs(sx->row[i]));
    *gain = lp->most > 0 ? kern_max(sum / lp->most, KERN_ROUNDING * size)
                         : KERN_PIVOT_TOL * size;
    for (j = 0; j < lp->cols; j++)
        if (!kern_is_basic(sx, j)) {
            const kern_real fall = kern_lp_dot(lp, j, sx->row);
            if (fall > *gain) {
                best = j;
                *gain = fall;
                if (first)
                    return best;
            }
        }
    return best;
}

/* How much the slope of the sum rises when position i passes zero, on the way
   on which the entering column takes it, and in `at` where that is. */
static kern_real kern_break(const kern_simplex *sx, int i, kern_real least,
                            kern_real *at)
{
    const int e = i - sx->lp->rows;
    const int j = e < 0 ? sx->base[i] : sx->extra[e];
    const kern_real a = e < 0 ? sx->alpha[i] : sx->alpha_extra[e];
    const kern_real v = e < 0 ? sx->value[i] : sx->value_extra[e];
    const kern_real size = kern_abs(a);
    kern_real w;
    int sign;
    *at = KERN_R(0);
    if ((e < 0 && sx->spare[i] >= 0) || !(size > least))
        return KERN_R(0);
    w = kern_violation(sx, j, v, &sign);
    if (sign != 0) {
        if ((sign < 0) != (a < 0))
            return KERN_R(0);
        *at = v / a;
        return j < sx->lp->cols ? w * size : 2 * w * size;
    }
    if (j >= sx->lp->cols)
        return w * size;
    if (a < 0)
        return KERN_R(0);
    *at = kern_max(v, KERN_R(0)) / a;
    return w * size;
}

/* The ratio test goes on past every variable that reaches zero as long as the
   sum still falls: a long step, which passes through degenerate corners. With
   `first` it stops at the first, the least index of equals (Bland). */
static int kern_phase_one_leaving(kern_simplex *sx, kern_real gain, int first,
                                  kern_real *step)
{
    const int m = sx->lp->rows, n = m + sx->extras;
    const kern_real enough = gain * KERN_R(64) * KERN_EPS;
    kern_real *at = sx->temp, *rise = sx->row; /* neither is in use here */
    kern_real size = KERN_R(0);
    int i, best = -1;
    for (i = 0; i < n; i++)
        size = kern_max(size, kern_abs(i < m ? sx->alpha[i]
                                             : sx->alpha_extra[i - m]));
    for (i = 0; i < n; i++)
        rise[i] = kern_break(sx, i, KERN_PIVOT_TOL * size, &at[i]);
    do {
        int j, next = -1, least = 0;
        for (i = 0; i < n; i++)
            if (rise[i] > 0) {
                j = i < m ? sx->base[i] : sx->extra[i - m];
                if (next < 0 || at[i] < at[next]
                    || (first && at[i] <= at[next] && j < least)) {
                    next = i;
                    least = j;
                }
            }
        if (next < 0)
            break;
        gain -= rise[next];
        rise[next] = KERN_R(0);
        *step = at[next];
        best = next;
    } while (!first && gain > enough);
    return best < 0 ? KERN_OUT : best < m ? best : -2 - (best - m);
}

/* A row y of the inverse turns when the matrix changes. change[j] is y.A_j's
   own rate for every column; returns the rate at which y grows, as a share of
   its length; 0 where y is not of this basis but a backend's, which bounds its
   length. */
static kern_real kern_row_growth(kern_simplex *sx, const kern_real *y,
                                 const kern_real *change)
{
    const int m = sx->lp->rows, cols = sx->lp->cols;
    kern_real along = KERN_R(0), size = KERN_R(0);
    int i;
    if (!sx->started)
        return KERN_R(0);
    for (i = 0; i < m; i++)
        sx->alpha[i] = sx->base[i] < cols ? change[sx->base[i]] : KERN_R(0);
    for (i = 0; i < sx->extras; i++)
        sx->alpha_extra[i] = change[sx->extra[i]];
    kern_basis_solve_t(sx, sx->alpha, sx->alpha_extra);
    for (i = 0; i < m; i++) {
        along -= y[i] * sx->alpha[i];
        size += y[i] * y[i];
    }
    return along / size;
}

/* Moves the basic variables by -step alpha, puts q = step in the place of
   what leaves. */
static void kern_basis_move(kern_simplex *sx, int q, int position,
                            kern_real step)
{
    const int home = sx->place[q];
    int i;
    for (i = 0; i < sx->lp->rows; i++)
        sx->value[i] -= step * sx->alpha[i];
    for (i = 0; i < sx->extras; i++)
        sx->value_extra[i] -= step * sx->alpha_extra[i];
    if (position >= 0)
        sx->value[position] = KERN_R(0);
    else if (home != KERN_OUT)
        sx->value_extra[-2 - position] = sx->value_extra[sx->extras - 1];
    kern_basis_exchange(sx, q, position);
    if (sx->place[q] >= 0)
        sx->value[sx->place[q]] = step;
    else
        sx->value_extra[-2 - sx->place[q]] = step;
    sx->pivots++;
    sx->settled = 0;
}

/* Lowers the sum of violations until it is zero or no column lowers it. The
   sum falls with every step that is not of length zero; when the budget is
   used up the smallest indices are taken (Bland), which cannot cycle. The
   limit ends what rounding might keep going. Returns KERN_STANDS with a
   feasible basis, KERN_FALLS with y in sx->row, or KERN_UNDECIDED. */
static kern_status kern_phase_one(kern_simplex *sx, kern_work *work,
                                  int limit)
{
    const kern_program *lp = sx->lp;
    const int budget = 50 + 10 * lp->rows;
    int count, i;
    for (count = 0; count < limit; ) {
        const int first = count > budget;
        const kern_real sum = kern_phase_one_prices(sx);
        kern_real gain = KERN_R(0), step = KERN_R(0);
        int q = KERN_OUT, position = KERN_OUT;
        if (sum > 0) {
            if (sx->settled)
                kern_phase_one_refine(sx, KERN_R(0));
            q = kern_phase_one_entering(sx, sum, first, &gain);
        }
        if (q == KERN_OUT && sx->settled) {
            for (i = 0; i < lp->rows; i++)
                sx->row[i] = -sx->row[i];
            return sum > 0 ? KERN_FALLS : KERN_STANDS;
        }
        if (q != KERN_OUT) {
            kern_basis_column(sx, q);
            position = kern_phase_one_leaving(sx, gain, first, &step);
        }
        if (position == KERN_OUT) {
            if (sx->settled)
                return KERN_UNDECIDED;
            if (!kern_basis_values(sx))
                kern_basis_renew(sx);
            continue;
        }
        if (sx->extras == sx->room && position >= 0
            && sx->place[q] == KERN_OUT)
            return KERN_UNDECIDED;
        if (position >= 0)
            kern_basis_row(sx, position);
        kern_basis_move(sx, q, position, step);
        work->pivots++;
        count++;
        if (sx->extras == sx->room || sx->pivots >= KERN_RENEW)
            kern_basis_renew(sx);
    }
    return KERN_UNDECIDED;
}

/* ---- the primal simplex, for costs ---- */

/* The column whose variable lowers the cost most (or the first that does). */
static int kern_primal_entering(kern_simplex *sx, int first)
{
    const kern_program *lp = sx->lp;
    kern_real least, size = KERN_R(0);
    int i, j, best = KERN_OUT;
    for (i = 0; i < lp->rows; i++)
        sx->row[i] = sx->base[i] < lp->cols ? lp->cost[sx->base[i]]
                                            : KERN_R(0);
    for (i = 0; i < sx->extras; i++)
        sx->row_extra[i] = lp->cost[sx->extra[i]];
    kern_basis_solve_t(sx, sx->row, sx->row_extra);
    for (j = 0; j < lp->cols; j++)
        size = kern_max(size, kern_abs(lp->cost[j]));
    least = -KERN_FEAS_TOL * size;
    for (j = 0; j < lp->cols; j++)
        if (!kern_is_basic(sx, j)) {
            const kern_real d = lp->cost[j] - kern_lp_dot(lp, j, sx->row);
            if (d < least) {
                best = j;
                if (first)
                    return best;
                least = d;
            }
        }
    return best;
}

/* The ratio test: how far the entering variable may rise, and what leaves
   then. Fillers are zero and stay so: they leave at once. */
static int kern_primal_leaving(const kern_simplex *sx, int first,
                               kern_real *step)
{
    const int cols = sx->lp->cols;
    kern_real size = KERN_R(0), pivot = KERN_R(0);
    int i, best = KERN_OUT, least = 0;
    for (i = 0; i < sx->lp->rows + sx->extras; i++) {
        const int e = i - sx->lp->rows;
        size = kern_max(size, kern_abs(e < 0 ? sx->alpha[i]
                                             : sx->alpha_extra[e]));
    }
    for (i = 0; i < sx->lp->rows + sx->extras; i++) {
        const int e = i - sx->lp->rows;
        const int j = e < 0 ? sx->base[i] : sx->extra[e];
        const kern_real a = e < 0 ? sx->alpha[i] : sx->alpha_extra[e];
        const kern_real v = e < 0 ? sx->value[i] : sx->value_extra[e];
        kern_real ratio;
        int better;
        if ((e < 0 && sx->spare[i] >= 0)
            || (j < cols ? a : kern_abs(a)) <= KERN_PIVOT_TOL * size)
            continue;
        ratio = j < cols ? kern_max(v, KERN_R(0)) / a : KERN_R(0);
        better = best == KERN_OUT || ratio < *step;
        if (!better && ratio <= *step)
            better = first ? j < least : kern_abs(a) > pivot;
        if (better) {
            *step = ratio;
            pivot = kern_abs(a);
            least = j;
            best = e < 0 ? i : -2 - e;
        }
    }
    return best;
}

/* From a feasible basis to an optimal one. Dantzig's rule while the budget
   lasts, then Bland's, which cannot cycle. */
static kern_status kern_simplex_primal(kern_simplex *sx, kern_work *work,
                                       int limit)
{
    const int budget = 20 + 6 * sx->lp->rows;
    int count;
    for (count = 0; count < limit; ) {
        const int first = count > budget;
        const int q = kern_primal_entering(sx, first);
        kern_real step = KERN_R(0);
        int position;
        if (q == KERN_OUT && sx->settled)
            return KERN_STANDS;
        if (q == KERN_OUT) {
            if (!kern_basis_values(sx))
                kern_basis_renew(sx);
            continue;
        }
        kern_basis_column(sx, q);
        position = kern_primal_leaving(sx, first, &step);
        if (position == KERN_OUT) {
            sx->ray = q;
            return KERN_UNBOUNDED;
        }
        if (sx->extras == sx->room && position >= 0
            && sx->place[q] == KERN_OUT)
            return KERN_NO_SPACE;
        if (position >= 0)
            kern_basis_row(sx, position);
        kern_basis_move(sx, q, position, step);
        work->pivots++;
        count++;
        if (sx->extras == sx->room || sx->pivots >= KERN_RENEW)
            kern_basis_renew(sx);
    }
    return KERN_UNDECIDED;
}

/* ---- opening, starting, reading ---- */

/* Lays the arrays of a simplex out in work memory. Called with real NULL it
   only counts, so that what is asked for and what is used cannot differ. */
static void kern_simplex_lay(kern_simplex *sx, const kern_program *lp, int room,
                             kern_take *take)
{
    const int m = lp->rows;
    sx->lp = lp;
    sx->started = sx->stale = 0;
    sx->groups = lp->ends ? m / 3 : 0;
    sx->room = room;
    sx->base = kern_take_ints(take, m);
    sx->spare = kern_take_ints(take, m);
    sx->extra = kern_take_ints(take, room);
    sx->slot = kern_take_ints(take, room);
    sx->place = kern_take_ints(take, lp->cols);
    sx->link = kern_take_ints(take, 2 * sx->groups + 5 * m);
    sx->block = kern_take_reals(take, 9 * sx->groups);
    sx->inv = kern_take_reals(take, room * room);
    sx->value = kern_take_reals(take, m);
    sx->value_extra = kern_take_reals(take, room);
    sx->alpha = kern_take_reals(take, m);
    sx->alpha_extra = kern_take_reals(take, room);
    sx->row = kern_take_reals(take, m + room);
    sx->row_extra = kern_take_reals(take, room);
    sx->temp = kern_take_reals(take, m + room);
}

/* Of the columns mine[0..n), the three that carry `load` in group g with the
   largest smallest share; none if every three of them are dependent. */
static void kern_crash_choose(const kern_simplex *sx, int g, const int *mine,
                              int n, const kern_real load[3], int take[3],
                              kern_real share[3])
{
    kern_real part[KERN_CRASH_MOST][3], best = -KERN_INFINITY;
    const int step = (n + KERN_CRASH_MOST - 1) / KERN_CRASH_MOST;
    int i, j, k, count = 0;
    take[0] = take[1] = take[2] = KERN_OUT;
    for (i = 0; i < n; i += step)
        kern_lp_part(sx->lp, mine[i], g, part[count++]);
    for (i = 0; i < count; i++)
        for (j = i + 1; j < count; j++) {
            const kern_real *a = part[i], *b = part[j];
            const kern_real ab0 = a[1] * b[2] - a[2] * b[1];
            const kern_real ab1 = a[2] * b[0] - a[0] * b[2];
            const kern_real ab2 = a[0] * b[1] - a[1] * b[0];
            const kern_real lc = ab0 * load[0] + ab1 * load[1] + ab2 * load[2];
            for (k = j + 1; k < count; k++) {
                const kern_real *c = part[k];
                const kern_real det = ab0 * c[0] + ab1 * c[1] + ab2 * c[2];
                kern_real la, lb, least, w = lc / det;
                if (kern_abs(det) < KERN_CRASH_TOL || w <= best)
                    continue;
                la = (load[0] * (b[1] * c[2] - b[2] * c[1])
                      + load[1] * (b[2] * c[0] - b[0] * c[2])
                      + load[2] * (b[0] * c[1] - b[1] * c[0])) / det;
                lb = (load[0] * (c[1] * a[2] - c[2] * a[1])
                      + load[1] * (c[2] * a[0] - c[0] * a[2])
                      + load[2] * (c[0] * a[1] - c[1] * a[0])) / det;
                least = kern_min(w, kern_min(la, lb));
                if (least > best) {
                    best = least;
                    take[0] = mine[i * step];
                    take[1] = mine[j * step];
                    take[2] = mine[k * step];
                    share[0] = la; share[1] = lb; share[2] = w;
                }
            }
        }
}

/* Whether column j faces the load of group g within 60 degrees: what stands
   beside a group only steadies it. */
static int kern_crash_faces(const kern_program *lp, int j, int g,
                            const kern_real load[3])
{
    kern_real part[3], along;
    kern_lp_part(lp, j, g, part);
    along = part[0] * load[0] + part[1] * load[1];
    return along > 0 && 4 * along * along
           >= (part[0] * part[0] + part[1] * part[1])
              * (load[0] * load[0] + load[1] * load[1]);
}

/* The crash basis: down the order, each group takes three columns to groups
   after it (or to none) that carry its load and what rests on it. Feasible at
   once for most walls. Without an order every filler is basic. */
static void kern_simplex_crash(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    int *first = sx->link, *rank = first + sx->groups;
    int *mine = rank + sx->groups, *next = sx->place;
    int i, j, s;
    for (i = 0; i < lp->rows; i++) {
        sx->base[i] = lp->cols + i;
        sx->spare[i] = -1;
        sx->row[i] = lp->rhs[i];
    }
    for (i = 0; i < sx->groups; i++) {
        first[i] = -1;
        rank[lp->order[i]] = i;
    }
    for (j = lp->cols - 1; j >= 0 && sx->groups > 0; j--) {
        const int head = lp->ends[2 * j], tail = lp->ends[2 * j + 1];
        const int g = head < 0 || (tail >= 0 && rank[tail] < rank[head])
                      ? tail : head;
        if (g >= 0) {
            next[j] = first[g];
            first[g] = j;
        }
    }
    for (i = 0; i < sx->groups; i++) {
        const int g = lp->order[i];
        int n = 0, take[3];
        kern_real share[3];
        for (j = first[g]; j >= 0 && n < 4 * lp->rows; j = next[j])
            if (kern_crash_faces(lp, j, g, sx->row + 3 * g))
                mine[n++] = j;
        kern_crash_choose(sx, g, mine, n, sx->row + 3 * g, take, share);
        for (s = 0; s < 3 && take[0] != KERN_OUT; s++) {
            sx->base[3 * g + s] = take[s];
            kern_lp_subtract(lp, take[s], share[s], sx->row);
        }
    }
    for (j = 0; j < lp->cols; j++)
        sx->place[j] = KERN_OUT;
    sx->extras = 0;
    sx->started = 1;
    sx->unit = KERN_R(0);
    for (i = 0; i < lp->rows; i++)
        sx->unit = kern_max(sx->unit, kern_abs(lp->rhs[i]));
    if (!(sx->unit > 0))
        sx->unit = KERN_R(1);
    kern_basis_refactor(sx);
}

static void kern_simplex_read(const kern_simplex *sx, kern_real *x)
{
    int i;
    for (i = 0; i < sx->lp->cols; i++)
        x[i] = KERN_R(0);
    for (i = 0; i < sx->lp->rows; i++)
        if (sx->spare[i] < 0 && sx->base[i] < sx->lp->cols)
            x[sx->base[i]] = sx->value[i];
    for (i = 0; i < sx->extras; i++)
        x[sx->extra[i]] = sx->value_extra[i];
}


#ifdef KERN_USE_GLPK
#define KERN_LP_H_ALLOWED
#include "kern_lp.h"
#endif

/* The door of the room: everything outside asks here. Starts from the last
   basis, or from the crash basis. x is written for every verdict: one that
   falls leaves A x = rhs in it, with what is negative about it, which tells
   how the verdict changes with the matrix. y is written for KERN_FALLS, and
   with costs for KERN_STANDS. `own` keeps the question from the backend. */
static kern_status kern_program_solve(kern_simplex *sx, int own,
                                      kern_real *x, kern_real *y,
                                      kern_work *work)
{
    const kern_program *lp = sx->lp;
    const int limit = lp->pivots > 0 ? lp->pivots
                                     : 200 + 20 * (lp->rows + lp->cols);
    kern_status status;
    int i;
    work->solves++;
#ifdef KERN_USE_GLPK
    if (!own && lp->rows > KERN_GLPK_ROWS) {
        sx->started = 0;
        return kern_lp_glpk(lp, x, y, work);
    }
#endif
    (void)own;
    if (!sx->started)
        kern_simplex_crash(sx);
    else if (sx->stale)
        kern_basis_refactor(sx);
    kern_basis_values(sx);
    status = kern_phase_one(sx, work, limit);
    if (status == KERN_STANDS && lp->cost)
        status = kern_simplex_primal(sx, work, limit);
    if (status < 0)
        return status;
    if (status == KERN_UNBOUNDED) {
        for (i = 0; i < lp->rows; i++)
            sx->value[i] = -sx->alpha[i];
        for (i = 0; i < sx->extras; i++)
            sx->value_extra[i] = -sx->alpha_extra[i];
    }
    kern_simplex_read(sx, x);
    if (status == KERN_UNBOUNDED)
        x[sx->ray] = KERN_R(1);
    for (i = 0; i < lp->rows; i++)
        y[i] = status == KERN_FALLS || (status == KERN_STANDS && lp->cost)
               ? sx->row[i] : KERN_R(0);
    return status;
}

/* Whether x, or y, proves the status, by products with the matrix alone. What
   is not a number proves nothing. */
static int kern_lp_proven(const kern_program *lp, kern_real *x,
                          const kern_real *y, kern_status status)
{
    kern_real size = KERN_R(0), rhs = KERN_R(0), ys = KERN_R(0);
    kern_real xs = KERN_R(0), cost = KERN_R(0), gain = KERN_R(0);
    kern_real value = KERN_R(0);
    int i, j;
    for (i = 0; i < lp->rows; i++) {
        rhs = kern_max(rhs, kern_abs(lp->rhs[i]));
        ys = kern_max(ys, kern_abs(y[i]));
        gain += y[i] * lp->rhs[i];
    }
    for (j = 0; j < lp->cols; j++) {
        if (x[j] < 0 && x[j] >= -KERN_TOL * rhs)
            x[j] = KERN_R(0);
        if (status != KERN_FALLS && !(x[j] >= 0))
            return 0;
        xs = kern_max(xs, x[j]);
        if (lp->cost)
            cost = kern_max(cost, kern_abs(lp->cost[j]));
        for (i = 0; i < lp->rows; i++)
            size = kern_max(size, kern_abs(lp->a[(size_t)j
                                * (size_t)lp->rows + (size_t)i]));
    }
    if (status == KERN_FALLS || (status == KERN_STANDS && lp->cost))
        for (j = 0; j < lp->cols; j++) {
            const kern_real d = kern_lp_dot(lp, j, y);
            if (status == KERN_FALLS ? !(d >= -KERN_TOL * size * ys)
                : !(lp->cost[j] - d >= -KERN_TOL * (cost + size * ys)))
                return 0;
        }
    if (status == KERN_FALLS)
        return gain < -KERN_TOL * ys * rhs && kern_is_finite(gain);
    for (j = 0; lp->cost && j < lp->cols; j++)
        value += lp->cost[j] * x[j];
    if (status == KERN_UNBOUNDED && !(value < -KERN_TOL * cost * xs))
        return 0;
    if (status == KERN_STANDS && lp->cost) { /* least: the prices pay for it */
        const kern_real allowed = KERN_TOL
            * (KERN_R(lp->cols) * cost * xs
               + KERN_R(lp->rows) * ys * (rhs + size * xs));
        if (!(kern_abs(value - gain) <= allowed) || !kern_is_finite(allowed))
            return 0;
    }
    for (i = 0; i < lp->rows; i++) {
        kern_real left = status == KERN_UNBOUNDED ? KERN_R(0) : lp->rhs[i];
        for (j = 0; j < lp->cols; j++)
            left -= x[j] * lp->a[(size_t)j * (size_t)lp->rows + (size_t)i];
        if (!(kern_abs(left) <= KERN_TOL * (size * xs + rhs)))
            return 0;
    }
    return kern_is_finite(size * xs);
}

/* What is wrong with a program, if anything. */
static kern_status kern_lp_check(const kern_lp *lp, kern_fault *fault)
{
    int i, n;
    if (!lp || !lp->a || !lp->rhs)
        return KERN_BAD_POINTER;
    if (lp->rows < 1 || lp->cols < 1 || lp->pivots < 0
        || lp->rows > KERN_COUNT_MOST / lp->cols
        || lp->rows > KERN_COUNT_MOST / lp->rows)
        return KERN_BAD_COUNT;
    n = lp->rows * lp->cols;
    for (i = 0; i < n + lp->rows + (lp->cost ? lp->cols : 0); i++) {
        const kern_real v = i < n ? lp->a[i] : i < n + lp->rows
            ? lp->rhs[i - n] : lp->cost[i - n - lp->rows];
        if (!kern_is_finite(v)) {
            fault->index = i;
            fault->value = v;
            return KERN_BAD_NUMBER;
        }
    }
    return KERN_STANDS;
}

KERN_API kern_status kern_lp_solve(const kern_lp *lp, kern_real *x,
                                   kern_real *y, kern_work *work)
{
    kern_simplex sx;
    kern_program p;
    kern_take take;
    kern_status status;
    if (!work)
        return KERN_BAD_POINTER;
    kern_fault_clear(&work->fault);
    status = x && y ? kern_lp_check(lp, &work->fault) : KERN_BAD_POINTER;
    if (status != KERN_STANDS)
        return status;
    p.rows = lp->rows;
    p.cols = lp->cols;
    p.a = lp->a;
    p.rhs = lp->rhs;
    p.cost = lp->cost;
    p.ends = p.order = NULL;
    p.scale = NULL;
    p.most = KERN_R(0);
    p.pivots = lp->pivots;
    kern_take_open(&take, work);
    kern_simplex_lay(&sx, &p, lp->rows, &take);
    if (!kern_take_fits(&take))
        return KERN_NO_SPACE;
    status = kern_program_solve(&sx, 0, x, y, work);
    if (status < 0)
        return status;
    return kern_lp_proven(&p, x, y, status) ? status : KERN_UNDECIDED;
}

/* ---- What is handed in ------------------------------------------ >>check */
/* Everything that the statics reads is looked at once, before any memory is
   used: numbers are finite, indices exist, normals have length 1. */

static kern_status kern_block_check(const kern_block *b)
{
    if (!kern_vec_is_finite(b->centre) || !kern_is_finite(b->area)
        || !kern_is_finite(b->mass) || !kern_is_finite(b->load.fx)
        || !kern_is_finite(b->load.fy) || !kern_is_finite(b->load.torque))
        return KERN_BAD_NUMBER;
    if (!b->fixed && !(kern_abs(b->area) > 0))
        return KERN_NO_AREA;
    if (!b->fixed && !(b->mass > 0))
        return KERN_BAD_MASS;
    return KERN_STANDS;
}

static kern_status kern_contact_check(const kern_contact *c, int blocks)
{
    const kern_real n = c->n.x * c->n.x + c->n.y * c->n.y;
    if (c->a < 0 || c->a >= blocks || c->b < 0 || c->b >= blocks)
        return KERN_BAD_BLOCK;
    if (c->a == c->b)
        return KERN_SAME_BLOCK;
    if (!kern_vec_is_finite(c->p) || !kern_vec_is_finite(c->n)
        || !kern_is_finite(c->mu) || !kern_is_finite(c->travel))
        return KERN_BAD_NUMBER;
    if (c->mu < 0)
        return KERN_BAD_FRICTION;
    if (kern_abs(n - 1) > KERN_R(64) * KERN_EPS)
        return KERN_BAD_NORMAL;
    return KERN_STANDS;
}

static kern_status kern_structure_check(const kern_structure *s,
                                        const kern_options *o,
                                        kern_fault *fault, int *free_blocks)
{
    kern_status status;
    int i, n = 0;
    if (!s || !o)
        return KERN_BAD_POINTER;
    status = kern_options_check(o);
    if (status != KERN_STANDS)
        return status;
    if (s->blocks < 0 || s->blocks > KERN_BLOCKS_MOST || s->contacts < 0
        || s->contacts > KERN_CONTACTS_MOST)
        return KERN_BAD_COUNT;
    if ((!s->block && s->blocks > 0) || (!s->contact && s->contacts > 0))
        return KERN_BAD_POINTER;
    if (!kern_vec_is_finite(s->gravity))
        return KERN_BAD_NUMBER;
    for (i = 0; i < s->blocks; i++) {
        status = kern_block_check(s->block + i);
        if (status != KERN_STANDS) {
            fault->block = i;
            return status;
        }
        n += !s->block[i].fixed;
    }
    if (n == 0)
        return KERN_NO_FREE;
    for (i = 0; i < s->contacts; i++) {
        status = kern_contact_check(s->contact + i, s->blocks);
        if (status != KERN_STANDS) {
            fault->index = i;
            return status;
        }
    }
    *free_blocks = n;
    return KERN_STANDS;
}

/* ---- Statics -------------------------------------------------- >>statics */
/* Eq. (5): every free block is in equilibrium under its weight, its load and
   contact forces f n + r t with f >= 0 and |r| <= mu f. In the plane the
   friction cone is spanned by its two edges,

       \   n   /         f n + r t = x1 (n + mu t) + x2 (n - mu t),
        \  |  /              x1, x2 >= 0
         \ | /
       ---- p ----  t

   so forces exist just if A x = -w has a solution x >= 0: three rows a free
   block (force, torque about its centre), two columns a contact point. The
   same rows turned round are a motion y of every block: y.A >= 0 says that no
   contact closes, y.w > 0 that the weight drives it. By Farkas' lemma there is
   either the one or the other. Lengths are measured in the size of the block,
   forces in the weight of all, so tolerances have no units. */

/* What is asked: the weights and loads to carry and how far kerns shrink. */
typedef struct kern_question {
    kern_real shrink;
    kern_vec gravity;
    const kern_wrench *pattern; /* NULL: side * m |g| horizontally            */
    kern_real factor;           /* of the pattern                             */
    int side;
} kern_question;

static kern_question kern_question_of(const kern_structure *s,
                                      kern_real shrink)
{
    kern_question q;
    q.shrink = shrink;
    q.gravity = s->gravity;
    q.pattern = NULL;
    q.factor = KERN_R(0);
    q.side = 0;
    return q;
}

/* The load pattern's share of block i, for a factor of 1. */
static kern_wrench kern_pattern_on(const kern_structure *s,
                                   const kern_question *q, int i)
{
    kern_wrench w;
    if (q->pattern)
        return q->pattern[i];
    w.fx = -s->gravity.y * s->block[i].mass * KERN_R(q->side);
    w.fy = s->gravity.x * s->block[i].mass * KERN_R(q->side);
    w.torque = KERN_R(0);
    return w;
}

/* All that acts on block i besides its contacts, and in `size` the sum of the
   magnitudes: what its equilibrium is measured by. */
static kern_wrench kern_wrench_on(const kern_structure *s,
                                  const kern_question *q, int i,
                                  kern_real *size)
{
    const kern_block *b = s->block + i;
    const kern_real gx = b->mass * q->gravity.x, gy = b->mass * q->gravity.y;
    kern_wrench w = b->load;
    *size = KERN_SQRT(gx * gx + gy * gy)
            + KERN_SQRT(w.fx * w.fx + w.fy * w.fy)
            + kern_abs(w.torque) / kern_block_size(b);
    w.fx += gx;
    w.fy += gy;
    if (q->factor > 0) {
        const kern_wrench p = kern_pattern_on(s, q, i);
        *size += q->factor * (KERN_SQRT(p.fx * p.fx + p.fy * p.fy)
                              + kern_abs(p.torque) / kern_block_size(b));
        w.fx += q->factor * p.fx;
        w.fy += q->factor * p.fy;
        w.torque += q->factor * p.torque;
    }
    return w;
}

/* A travel too short to be one counts as none. */
static kern_real kern_travel(const kern_contact *c, kern_real mean)
{
    return kern_abs(c->travel) < KERN_TRAVEL * mean ? KERN_R(0)
                                                          : c->travel;
}

/* How far along t a contact point has moved at a shrinkage, and in `rate` how
   fast it moves when the shrinkage grows. */
static kern_real kern_shift(kern_real travel, kern_real shrink, int relative,
                            kern_real *rate)
{
    const kern_real sign = travel > 0 ? KERN_R(1) : travel < 0 ? KERN_R(-1)
                                                               : KERN_R(0);
    if (relative) {
        *rate = travel;
        return shrink * travel;
    }
    if (shrink >= kern_abs(travel)) {
        *rate = KERN_R(0);
        return travel;
    }
    *rate = sign;
    return shrink * sign;
}

KERN_API kern_vec kern_contact_at(const kern_contact *c, kern_real shrink,
                                  int relative)
{
    kern_real rate;
    const kern_real shift = kern_shift(c->travel, shrink, relative, &rate);
    kern_vec p = c->p;
    p.x -= shift * c->n.y;
    p.y += shift * c->n.x;
    return p;
}

/* From the centre of block b to where contact c acts. The centre is taken off
   first, since far from the origin a place has fewer digits than an arm. */
static kern_vec kern_arm(const kern_contact *c, const kern_block *b,
                         kern_real shrink, int relative, kern_real mean)
{
    kern_real rate;
    const kern_real shift = kern_shift(kern_travel(c, mean), shrink, relative,
                                       &rate);
    kern_vec arm = kern_vec_sub(c->p, b->centre);
    arm.x -= shift * c->n.y;
    arm.y += shift * c->n.x;
    return arm;
}

/* ---- Proofs ----------------------------------------------------- >>proof */
/* Both checks use the caller's data only, and nothing of the solver. A proof's
   error is given as a share of what is allowed, so up to 1 it holds.

   Forces prove "stands": each in its cone, the residual of every equilibrium
   row within KERN_TOL of what acts on the block (or within the rounding of
   the forces that meet there), all together not above KERN_BOUND times the
   weight. A motion proves "falls": its power exceeds its own rounding, and
   exceeds KERN_BOUND times the weight of what moves times the worst speed at
   which it closes a contact: even forces of that size could not hold it. */

static kern_real kern_prove_forces(const kern_structure *s,
                                   const kern_question *q, int relative,
                                   const kern_force *force, kern_real mean,
                                   kern_real *sum)
{
    kern_real total = KERN_R(0), weight = KERN_R(0), error = KERN_R(0);
    int i;
    for (i = 0; i < 4 * s->blocks; i++)
        sum[i] = KERN_R(0);
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real f = force[i].normal, r = force[i].tangential;
        const kern_real fx = f * c->n.x - r * c->n.y;
        const kern_real fy = f * c->n.y + r * c->n.x;
        int end;
        if (!(f >= 0) || !(kern_abs(r) <= c->mu * f * (1 + 8 * KERN_EPS)))
            return KERN_INFINITY;
        total += f;
        for (end = 0; end < 2; end++) {
            const int b = end ? c->b : c->a;
            const kern_real sign = end ? KERN_R(1) : KERN_R(-1);
            const kern_vec arm = kern_arm(c, s->block + b, q->shrink, relative,
                                          mean);
            sum[4 * b] += sign * fx;
            sum[4 * b + 1] += sign * fy;
            sum[4 * b + 2] += sign * (arm.x * fy - arm.y * fx);
            sum[4 * b + 3] = kern_max(sum[4 * b + 3], f);
        }
    }
    for (i = 0; i < s->blocks; i++)
        if (!s->block[i].fixed) {
            kern_real size, left, allowed;
            const kern_wrench w = kern_wrench_on(s, q, i, &size);
            left = kern_max(kern_max(kern_abs(sum[4 * i] + w.fx),
                                     kern_abs(sum[4 * i + 1] + w.fy)),
                            kern_abs(sum[4 * i + 2] + w.torque)
                            / kern_block_size(s->block + i));
            allowed = KERN_TOL * size + KERN_ROUNDING * sum[4 * i + 3];
            weight += size;
            if (left > 0)
                error = kern_max(error, left / allowed);
        }
    if (total > 0)
        error = kern_max(error, total / (KERN_BOUND * weight));
    return error <= 1 ? error : kern_max(error, KERN_R(2));
}

static kern_real kern_prove_motion(const kern_structure *s,
                                   const kern_question *q, int relative,
                                   const kern_motion *motion, kern_real mean)
{
    kern_real power = KERN_R(0), terms = KERN_R(0), weight = KERN_R(0);
    kern_real closing = KERN_R(0), need;
    int i, edge;
    for (i = 0; i < s->blocks; i++) {
        const kern_motion *m = motion + i;
        kern_real size, px, py, pt;
        kern_wrench w;
        const int moves = kern_abs(m->vx) > 0 || kern_abs(m->vy) > 0
                          || kern_abs(m->spin) > 0;
        if (s->block[i].fixed ? moves : !kern_is_finite(m->vx)
            || !kern_is_finite(m->vy) || !kern_is_finite(m->spin))
            return KERN_INFINITY;
        if (!moves)
            continue;
        w = kern_wrench_on(s, q, i, &size);
        px = w.fx * m->vx;
        py = w.fy * m->vy;
        pt = w.torque * m->spin;
        power += px + py + pt;
        terms += kern_abs(px) + kern_abs(py) + kern_abs(pt);
        weight += size;
    }
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_motion *a = motion + c->a, *b = motion + c->b;
        const kern_vec pa = kern_arm(c, s->block + c->a, q->shrink, relative,
                                     mean);
        const kern_vec pb = kern_arm(c, s->block + c->b, q->shrink, relative,
                                     mean);
        const kern_real vx = b->vx - b->spin * pb.y - (a->vx - a->spin * pa.y);
        const kern_real vy = b->vy + b->spin * pb.x - (a->vy + a->spin * pa.x);
        const kern_real open = vx * c->n.x + vy * c->n.y;
        const kern_real slide = vy * c->n.x - vx * c->n.y;
        if (s->block[c->a].fixed && s->block[c->b].fixed)
            continue;
        for (edge = -1; edge < 2; edge += 2)
            closing = kern_max(closing, -(open + KERN_R(edge) * c->mu * slide));
    }
    need = kern_max(KERN_BOUND * weight * closing, KERN_ROUNDING * terms);
    if (!(power > 0))
        return KERN_INFINITY;
    return need / power;
}

KERN_API kern_real kern_check_forces(const kern_structure *s, kern_real shrink,
                                     const kern_options *o,
                                     const kern_force *force, kern_work *work)
{
    kern_take take;
    kern_question q;
    kern_real *sum;
    int n = 0;
    if (!work || !force)
        return KERN_INFINITY;
    kern_fault_clear(&work->fault);
    if (kern_structure_check(s, o, &work->fault, &n) != KERN_STANDS)
        return KERN_INFINITY;
    kern_take_open(&take, work);
    sum = kern_take_reals(&take, 4 * s->blocks);
    if (!kern_take_fits(&take))
        return KERN_INFINITY;
    q = kern_question_of(s, shrink);
    return kern_prove_forces(s, &q, o->relative, force,
                             kern_mean_size(s->block, s->blocks), sum);
}

KERN_API kern_real kern_check_motion(const kern_structure *s, kern_real shrink,
                                     const kern_options *o,
                                     const kern_motion *motion)
{
    kern_question q;
    kern_fault fault;
    int n = 0;
    if (!motion || kern_structure_check(s, o, &fault, &n) != KERN_STANDS)
        return KERN_INFINITY;
    q = kern_question_of(s, shrink);
    return kern_prove_motion(s, &q, o->relative, motion,
                             kern_mean_size(s->block, s->blocks));
}

/* ---- The model ------------------------------------------------- >>model */
/* Blocks and contacts become groups and columns. The model lives in the work
   memory for the length of a call; from question to question only what a
   question changes is made anew, and the basis stays. */

typedef struct kern_model {
    const kern_structure *s;
    kern_work *work;
    int relative;
    kern_real mean;           /* size of the free blocks                      */
    kern_real weight;         /* unit of force: all that acts on free blocks  */
    kern_real shrink;         /* that the columns were made for               */
    kern_program lp;
    kern_simplex simplex;
    int *group;               /* of a block, -1 where it is fixed             */
    int *ends, *order;
    kern_real *arc, *rhs, *scale;
    kern_real *x;             /* solution, two a contact point                */
    kern_real *y;             /* certificate, three a group                   */
    kern_real *sum;           /* scratch of the proof, four a block           */
    kern_force *force;        /* of the last verdict                          */
    kern_motion *motion;
    kern_status found;        /* what the program said, proven or not         */
} kern_model;

/* Slices of the work arrays that hold structs of numbers. */
typedef char kern_force_is_two[sizeof(kern_force) == 2 * sizeof(kern_real)
                               ? 1 : -1];
typedef char kern_motion_is_three[sizeof(kern_motion) == 3 * sizeof(kern_real)
                                  ? 1 : -1];

static void kern_model_lay(kern_model *m, int blocks, int free_blocks,
                           int contacts, kern_take *take)
{
    m->lp.rows = 3 * free_blocks;
    m->lp.cols = 2 * contacts;
    m->group = kern_take_ints(take, blocks);
    m->ends = kern_take_ints(take, 4 * contacts);
    m->order = kern_take_ints(take, free_blocks);
    m->arc = kern_take_reals(take, 8 * contacts);
    m->rhs = kern_take_reals(take, 3 * free_blocks);
    m->scale = kern_take_reals(take, free_blocks);
    m->x = kern_take_reals(take, 2 * contacts);
    m->y = kern_take_reals(take, 3 * free_blocks);
    m->sum = kern_take_reals(take, 4 * blocks);
    m->force = (kern_force *)(void *)kern_take_reals(take, 2 * contacts);
    m->motion = (kern_motion *)(void *)kern_take_reals(take, 3 * blocks);
    m->lp.ends = m->ends;
    m->lp.order = m->order;
    m->lp.a = m->arc;
    m->lp.rhs = m->rhs;
    m->lp.scale = m->scale;
    m->lp.cost = NULL;
    m->lp.most = KERN_BOUND;
    kern_simplex_lay(&m->simplex, &m->lp, KERN_EXTRAS(free_blocks), take);
}

KERN_API void kern_work_need(int blocks, int contacts, int *reals,
                             int *indices)
{
    const int fit = blocks >= 0 && blocks <= KERN_BLOCKS_MOST
                    && contacts >= 0 && contacts <= KERN_CONTACTS_MOST;
    *reals = fit ? KERN_REALS(blocks, contacts) : 0;
    *indices = fit ? KERN_INTS(blocks, contacts) : 0;
}

KERN_API kern_work kern_work_of(kern_real *real, int reals, int *index,
                                int indices)
{
    kern_work w;
    w.real = real;
    w.reals = reals;
    w.index = index;
    w.indices = indices;
    w.pivots = w.solves = 0;
    w.error = KERN_R(0);
    kern_fault_clear(&w.fault);
    return w;
}

/* Blocks from top to bottom, as gravity sees them: what is higher rests on
   what is lower. Shell sort, since it needs neither memory nor recursion. */
static void kern_model_order(kern_model *m, kern_real *height)
{
    const int n = m->lp.rows / 3;
    int gap, i, j;
    for (i = 0; i < n; i++)
        m->order[i] = i;
    for (gap = 1; gap < n / 9; gap = 3 * gap + 1)
        continue;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < n; i++) {
            const int g = m->order[i];
            for (j = i; j >= gap; j -= gap) {
                const int h = m->order[j - gap];
                if (height[h] > height[g]
                    || (h < g && height[h] >= height[g]))
                    break;
                m->order[j] = h;
            }
            m->order[j] = g;
        }
}

static kern_status kern_model_open(kern_model *m, const kern_structure *s,
                                   const kern_options *o, kern_work *work)
{
    kern_take take;
    kern_status status;
    int i, free_blocks = 0;
    if (!work)
        return KERN_BAD_POINTER;
    kern_fault_clear(&work->fault);
    status = kern_structure_check(s, o, &work->fault, &free_blocks);
    if (status != KERN_STANDS)
        return status;
    kern_take_open(&take, work);
    kern_model_lay(m, s->blocks, free_blocks, s->contacts, &take);
    if (!kern_take_fits(&take))
        return KERN_NO_SPACE;
    m->s = s;
    m->work = work;
    m->relative = o->relative;
    m->lp.pivots = o->pivots;
    m->mean = kern_mean_size(s->block, s->blocks);
    free_blocks = 0;
    for (i = 0; i < s->blocks; i++) {
        const kern_block *b = s->block + i;
        m->group[i] = b->fixed ? -1 : free_blocks;
        if (!b->fixed)
            m->simplex.temp[free_blocks++] = -(b->centre.x * s->gravity.x
                                               + b->centre.y * s->gravity.y);
    }
    kern_model_order(m, m->simplex.temp);
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        m->ends[4 * i] = m->ends[4 * i + 2] = m->group[c->b];
        m->ends[4 * i + 1] = m->ends[4 * i + 3] = m->group[c->a];
    }
    return KERN_STANDS;
}

/* The unit of a block's torques: its size, or where kerns have grown beyond
   it, how far. */
static kern_real kern_lever(const kern_model *m, const kern_block *b)
{
    const kern_real grown = kern_max(-m->shrink, KERN_R(0));
    const kern_real size = kern_block_size(b);
    return m->relative ? size * (1 + grown) : size + grown;
}

/* The columns of A at a shrinkage: what changes with it is the torques. */
static void kern_model_columns(kern_model *m, kern_real shrink)
{
    const kern_structure *s = m->s;
    int i, edge;
    m->shrink = shrink;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_block *ba = s->block + c->a, *bb = s->block + c->b;
        const kern_vec pa = kern_arm(c, ba, shrink, m->relative, m->mean);
        const kern_vec pb = kern_arm(c, bb, shrink, m->relative, m->mean);
        for (edge = 0; edge < 2; edge++) {
            kern_real *f = m->arc + 8 * i + 4 * edge;
            const kern_real mu = edge ? -c->mu : c->mu;
            f[0] = c->n.x - mu * c->n.y;
            f[1] = c->n.y + mu * c->n.x;
            f[2] = (pb.x * f[1] - pb.y * f[0]) / kern_lever(m, bb);
            f[3] = (pa.y * f[0] - pa.x * f[1]) / kern_lever(m, ba);
        }
    }
}

/* The right-hand side of A x = -w, in units of all that acts. */
static void kern_model_loads(kern_model *m, const kern_question *q)
{
    const kern_structure *s = m->s;
    kern_real size;
    int i, g;
    m->weight = KERN_R(0);
    for (i = 0; i < s->blocks; i++)
        if (m->group[i] >= 0) {
            kern_wrench_on(s, q, i, &size);
            m->weight += size;
        }
    if (!(m->weight > 0))
        m->weight = KERN_R(1);
    for (i = 0; i < s->blocks; i++)
        if (m->group[i] >= 0) {
            const kern_wrench w = kern_wrench_on(s, q, i, &size);
            g = m->group[i];
            m->rhs[3 * g] = -w.fx / m->weight;
            m->rhs[3 * g + 1] = -w.fy / m->weight;
            m->rhs[3 * g + 2] = -w.torque
                                / (m->weight * kern_lever(m, s->block + i));
            m->scale[g] = kern_max(size / m->weight, KERN_LEAST_SCALE);
        }
}

/* x as forces. What is negative by rounding is nothing. */
static void kern_model_forces(kern_model *m)
{
    int i;
    for (i = 0; i < m->s->contacts; i++) {
        const kern_real x1 = kern_max(m->x[2 * i], KERN_R(0));
        const kern_real x2 = kern_max(m->x[2 * i + 1], KERN_R(0));
        m->force[i].normal = (x1 + x2) * m->weight;
        m->force[i].tangential = m->s->contact[i].mu * (x1 - x2) * m->weight;
    }
}

/* y as a motion, its fastest block at speed 1. */
static void kern_model_motion(kern_model *m)
{
    kern_real most = KERN_R(0);
    int i;
    for (i = 0; i < m->s->blocks; i++) {
        kern_motion *v = m->motion + i;
        const kern_block *b = m->s->block + i;
        const kern_real *y = m->y + 3 * m->group[i];
        v->vx = v->vy = v->spin = KERN_R(0);
        if (m->group[i] < 0)
            continue;
        v->vx = y[0];
        v->vy = y[1];
        v->spin = y[2] / kern_lever(m, b);
        most = kern_max(most, kern_max(KERN_SQRT(y[0] * y[0] + y[1] * y[1]),
                                kern_abs(v->spin) * kern_block_size(b)));
    }
    for (i = 0; i < m->s->blocks && most > 0; i++) {
        m->motion[i].vx /= most;
        m->motion[i].vy /= most;
        m->motion[i].spin /= most;
    }
}

/* The proof of a verdict, and the verdict itself only if the proof holds. */
static kern_status kern_model_prove(kern_model *m, const kern_question *q,
                                    kern_status status)
{
    kern_real error = KERN_INFINITY;
    if (status == KERN_FALLS) {
        kern_model_motion(m);
        error = kern_prove_motion(m->s, q, m->relative, m->motion, m->mean);
    }
    if (status == KERN_FALLS && !(error <= 1) && m->simplex.started) {
        kern_certificate_lift(&m->simplex, m->y);
        kern_model_motion(m);
        error = kern_prove_motion(m->s, q, m->relative, m->motion, m->mean);
    }
    if (!(error <= 1)) {
        /* forces may still do, within the tolerance */
        status = KERN_STANDS;
        kern_model_forces(m);
        error = kern_prove_forces(m->s, q, m->relative, m->force, m->mean,
                                  m->sum);
    }
    if (!(error <= 1))
        return KERN_UNDECIDED;
    m->work->error = kern_max(m->work->error, error);
    return status;
}

/* Forces were found, but larger than is allowed: the least there are, by
   costs of 1. If they still are too large their prices are a motion that shows
   that no smaller ones exist. The costs stand where forces will. */
static kern_status kern_model_least(kern_model *m, int own)
{
    kern_real *one = (kern_real *)(void *)m->force;
    kern_real total = KERN_R(0);
    kern_status status;
    int i;
    for (i = 0; i < m->lp.cols; i++) {
        one[i] = KERN_R(1);
        total += m->x[i];
    }
    if (!(total > KERN_BOUND))
        return KERN_STANDS;
    m->lp.cost = one;
    status = kern_program_solve(&m->simplex, own, m->x, m->y, m->work);
    m->lp.cost = NULL;
    if (status != KERN_STANDS)
        return KERN_UNDECIDED;
    total = KERN_R(0);
    for (i = 0; i < m->lp.cols; i++)
        total += m->x[i];
    for (i = 0; i < m->lp.rows; i++)
        m->y[i] = -m->y[i];
    return total > KERN_BOUND ? KERN_FALLS : KERN_STANDS;
}

/* Answers a question with a proof, or not at all. */
static kern_status kern_model_ask(kern_model *m, const kern_question *q)
{
    kern_status status;
    int own;
    m->found = KERN_UNDECIDED;
    if (!m->simplex.started || q->shrink > m->shrink
        || q->shrink < m->shrink) {
        kern_model_columns(m, q->shrink);
        m->simplex.stale = 1;
    }
    kern_model_loads(m, q);
    for (own = 0; own < 2; own++) {
        status = kern_program_solve(&m->simplex, own, m->x, m->y, m->work);
        if (status == KERN_STANDS)
            status = kern_model_least(m, own);
        m->found = status;
        if (status >= 0)
            status = kern_model_prove(m, q, status);
        if (status >= 0)
            break;
        /* once more from the crash basis */
        m->simplex.started = 0;
    }
    return status;
}

/* ---- The kern -------------------------------------------------- >>kern */
/* Every measure asks along a path s: kerns shrink, a load grows, gravity
   turns. What is wanted is the first place where the structure falls.

   Between a place that stands and a place that falls the edge is found by
   Newton's method on the certificate. At a place that falls, y gives the
   power -y.rhs > 0, which changes along the path at the rate
   y.(rhs' - A' x): its zero is where this mechanism stops. It converges
   quadratically, from the side that falls. Then the places half a tolerance
   on each side are asked: the bracket is narrow, and both ends are proven. */

typedef enum kern_path_kind {
    KERN_PATH_SHRINK, KERN_PATH_LOAD, KERN_PATH_TILT
} kern_path_kind;

typedef struct kern_path {
    kern_path_kind kind;
    kern_question q;          /* at s = 0; what the path changes is replaced  */
    kern_real tolerance;      /* width of the bracket                         */
    kern_real start, end;     /* of the path; the first stands                */
    kern_real holds, fails;   /* the bracket                                  */
    kern_real edge;           /* where Newton's method sees the edge          */
    const kern_proof *proof;  /* the caller's: of the last verdict each way   */
} kern_path;

/* Cosine and sine of 4 atan(s), so that s in [0, 1] turns gravity through
   half a circle by arithmetic alone. */
static void kern_turn(kern_real s, kern_real *c, kern_real *n)
{
    const kern_real d = 1 + s * s;
    const kern_real c2 = (1 - s * s) / d, n2 = 2 * s / d;
    *c = c2 * c2 - n2 * n2;
    *n = 2 * c2 * n2;
}

static kern_question kern_path_at(const kern_path *path, kern_real s)
{
    kern_question q = path->q;
    if (path->kind == KERN_PATH_SHRINK)
        q.shrink = s;
    else if (path->kind == KERN_PATH_LOAD)
        q.factor = s;
    else {
        kern_real c, n;
        kern_turn(s, &c, &n);
        n *= KERN_R(q.side);
        q.gravity.x = c * path->q.gravity.x - n * path->q.gravity.y;
        q.gravity.y = c * path->q.gravity.y + n * path->q.gravity.x;
    }
    return q;
}

/* Where kerns shrink A changes: y.A' goes to m->x in the place of x, after
   y.A' x, which is returned. */
static kern_real kern_shrink_rate(kern_model *m, const kern_question *q)
{
    const kern_structure *s = m->s;
    kern_real sum = KERN_R(0);
    int i;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const int ga = m->group[c->a], gb = m->group[c->b];
        kern_real rate, spin = KERN_R(0);
        kern_shift(kern_travel(c, m->mean), q->shrink, m->relative, &rate);
        if (gb >= 0)
            spin += m->y[3 * gb + 2] / kern_lever(m, s->block + c->b);
        if (ga >= 0)
            spin -= m->y[3 * ga + 2] / kern_lever(m, s->block + c->a);
        /* the arm grows along t, and t x (f n + r t) = -f */
        sum -= rate * spin * (m->x[2 * i] + m->x[2 * i + 1]);
        m->x[2 * i] = m->x[2 * i + 1] = -rate * spin;
    }
    return sum;
}

/* y.rhs' where a load grows or gravity turns. */
static kern_real kern_load_rate(const kern_model *m, const kern_path *path,
                                const kern_question *q, kern_real s)
{
    kern_real sum = KERN_R(0);
    int i;
    for (i = 0; i < m->s->blocks; i++) {
        const kern_block *b = m->s->block + i;
        const kern_real *y = m->y + 3 * m->group[i];
        kern_wrench w;
        if (m->group[i] < 0)
            continue;
        if (path->kind == KERN_PATH_LOAD)
            w = kern_pattern_on(m->s, q, i);
        else {
            const kern_real turn = 4 / (1 + s * s) * b->mass
                                   * KERN_R(q->side);
            w.fx = -q->gravity.y * turn;
            w.fy = q->gravity.x * turn;
            w.torque = KERN_R(0);
        }
        sum -= (y[0] * w.fx + y[1] * w.fy + y[2] * w.torque / kern_lever(m, b))
               / m->weight;
    }
    return sum;
}

/* Hands the proof of a verdict to the caller. */
static void kern_proof_out(const kern_model *m, const kern_proof *proof,
                           kern_status status)
{
    int i;
    if (!proof)
        return;
    if (status == KERN_STANDS && proof->force)
        for (i = 0; i < m->s->contacts; i++)
            proof->force[i] = m->force[i];
    if (status == KERN_FALLS && proof->motion)
        for (i = 0; i < m->s->blocks; i++)
            proof->motion[i] = m->motion[i];
}

/* Asks at s, and where it falls lets Newton's method say where that ends. As
   kerns close, y grows without bound where the power per unit of y is nearly
   straight: it is that which is followed. */
static kern_status kern_path_ask(kern_model *m, kern_path *path, kern_real s)
{
    const kern_question q = kern_path_at(path, s);
    const kern_status status = kern_model_ask(m, &q);
    kern_real at = KERN_R(0), rate;
    int i;
    kern_proof_out(m, path->proof, status);
    if (status == KERN_STANDS)
        path->holds = s;
    if (status == KERN_FALLS)
        path->fails = s;
    /* near to critical even a certificate that proves nothing tells where */
    if (status == KERN_STANDS || m->found != KERN_FALLS)
        return status;
    for (i = 0; i < m->lp.rows; i++)
        at += m->y[i] * m->rhs[i];
    if (path->kind == KERN_PATH_SHRINK) {
        rate = -kern_shrink_rate(m, &q);
        rate -= at * kern_row_growth(&m->simplex, m->y, m->x);
    } else
        rate = kern_load_rate(m, path, &q, s);
    path->edge = s - at / rate;
    return status;
}

/* Narrows [holds, fails] to the tolerance, and leaves in `edge` the place in
   it where the verdict changes. Newton's method is asked where it points to:
   what falls there falls by another mechanism, which points farther. What
   stands there, or is too near to critical to tell, is the edge; then half a
   tolerance to each side of it is asked, where verdicts are beyond doubt. */
static kern_status kern_path_edge(kern_model *m, kern_path *path)
{
    kern_real aside = path->tolerance * KERN_R(0.45), under = aside;
    kern_real edge = KERN_R(0), cap = KERN_INFINITY;
    int round, stuck = 0, found = 0, below = 0;
    for (round = 0; round < KERN_EDGE_ROUNDS; round++) {
        const kern_real lo = path->holds, hi = path->fails, r = path->edge;
        const int above = found && hi <= edge + aside
            && (hi >= edge + aside / 4 || hi >= path->end);
        kern_real at = lo + (hi - lo) / 2;
        kern_status status;
        if ((above && below) || (hi - lo <= path->tolerance && stuck > 2)
            || aside + under > path->tolerance * KERN_WIDEST)
            break;
        if (found && !above)
            at = kern_min(edge + aside, path->end);
        else if (found && !below)
            at = kern_max(edge - under, path->start);
        else if (!found && r > lo && r < hi && stuck < 3)
            at = r;
        at = kern_min(at + KERN_R(stuck / 4) * aside / 8, path->end);
        status = kern_path_ask(m, path, at);
        if (status < 0 && status != KERN_UNDECIDED)
            return status;
        if (found && status == KERN_UNDECIDED) {
            if (at > edge)
                aside *= 2;
            else
                under *= 2;
        } else if (!found && status != KERN_FALLS && at >= r && at <= r) {
            found = 1;
            edge = r;
            if (status == KERN_UNDECIDED && path->edge > r - aside)
                cap = path->edge;
        } else if (found && at > edge && status == KERN_STANDS) {
            found = 0;      /* Newton's method was short of it */
        } else if (found && at < edge) {
            below = status == KERN_STANDS;
            found = below;
        }
        stuck = !found && (status == KERN_UNDECIDED
                || path->fails - path->holds > (hi - lo) * KERN_R(0.5))
                ? stuck + 1 : 0;
    }
    if (path->fails - path->holds > path->tolerance * KERN_WIDEST)
        return KERN_UNDECIDED;
    path->edge = kern_min(path->edge, cap);
    path->edge = kern_min(kern_max(path->edge, path->holds), path->fails);
    return KERN_STANDS;
}

/* d_max: the shrinkage at which the last kern closes. */
static kern_real kern_most(const kern_model *m)
{
    kern_real most = KERN_R(0);
    int i;
    for (i = 0; i < m->s->contacts; i++) {
        const kern_contact *c = m->s->contact + i;
        if (m->group[c->a] >= 0 || m->group[c->b] >= 0)
            most = kern_max(most, kern_abs(kern_travel(c, m->mean)));
    }
    return m->relative ? KERN_R(1) : most;
}

/* Kerns of line contacts are nested: what a smaller one can carry a larger one
   can. Points that move toward each other along different tangents are not. */
static int kern_nested(const kern_model *m)
{
    int i;
    for (i = 0; i < m->s->contacts; i++) {
        const kern_contact *c = m->s->contact + i;
        if (!c->line && (m->group[c->a] >= 0 || m->group[c->b] >= 0)
            && kern_abs(kern_travel(c, m->mean)) > 0)
            return 0;
    }
    return 1;
}

/* Goes from a place that stands toward the end, in steps that grow by `growth`,
   until it falls; then finds the edge. `never`: it stands to the end. */
static kern_status kern_path_climb(kern_model *m, kern_path *path,
                                   kern_real step, kern_real growth,
                                   int *never)
{
    const kern_real end = path->end;
    kern_real at = path->holds;
    int round, tries = 0;
    *never = 0;
    for (round = 0; round < KERN_CLIMB_ROUNDS; round++) {
        const kern_real next = kern_min(at + step, end);
        kern_status status = kern_path_ask(m, path, next);
        /* too near to critical to tell: a little aside */
        for (tries = 1; status == KERN_UNDECIDED && tries < 4; tries++)
            status = kern_path_ask(m, path,
                kern_max(next - path->tolerance * KERN_R(tries) / 4,
                         at + (next - at) / 2));
        if (status == KERN_FALLS)
            return kern_path_edge(m, path);
        if (status != KERN_STANDS)
            return status;
        if (next >= end) {
            *never = 1;
            path->edge = path->fails = end;
            return KERN_STANDS;
        }
        at = next;
        step *= growth;
    }
    return KERN_UNDECIDED;
}

static kern_real kern_step(const kern_model *m, const kern_options *o)
{
    if (o->epsilon > 0)
        return o->epsilon;
    return m->relative ? KERN_R(0.05) : KERN_R(0.02) * m->mean;
}

/* How many steps of Algorithm 1 there are until every kern is closed. */
static kern_status kern_steps(const kern_margin *out, int *last)
{
    const kern_real steps = out->most / out->epsilon;
    if (!(steps <= KERN_R(1000000)))
        return KERN_BAD_STEP;
    *last = (int)steps;
    *last += KERN_R(*last) < steps;
    return KERN_STANDS;
}

/* Algorithm 1: the first k at which kerns shrunk by k steps hold no longer;
   last + 1 if they always do. `known` tells the verdicts outside of the
   bracket [holds, fails] without asking: kerns are nested. */
static kern_status kern_level_scan(kern_model *m, kern_path *path, int last,
                                   int known, kern_margin *out)
{
    int k = 1;
    if (known && path->holds > out->epsilon)
        k = (int)(path->holds / out->epsilon);
    if (known && out->saturated)
        k = last + 1;
    for (; k <= last; k++) {
        const kern_real at = kern_min(KERN_R(k) * out->epsilon, out->most);
        const kern_question q = kern_path_at(path, at);
        kern_status status = KERN_STANDS;
        if (!known || (at > path->holds && at < path->fails))
            status = kern_model_ask(m, &q);
        else if (at > path->holds)
            status = KERN_FALLS;
        if (status == KERN_UNDECIDED)
            k = -1;
        if (status == KERN_FALLS || status == KERN_UNDECIDED)
            break;
        if (status != KERN_STANDS)
            return status;
    }
    out->level = k;
    return KERN_STANDS;
}

KERN_API kern_status kern_stands(const kern_structure *s, kern_real shrink,
                                 const kern_options *o, kern_work *work,
                                 const kern_proof *proof)
{
    kern_model m;
    kern_question q;
    kern_status status = kern_model_open(&m, s, o, work);
    if (status != KERN_STANDS)
        return status;
    if (!kern_is_finite(shrink))
        return KERN_BAD_NUMBER;
    q = kern_question_of(s, shrink);
    status = kern_model_ask(&m, &q);
    kern_proof_out(&m, proof, status);
    return status;
}

static void kern_path_open(kern_path *path, kern_path_kind kind,
                           const kern_structure *s, kern_real shrink,
                           const kern_proof *proof)
{
    path->kind = kind;
    path->proof = proof;
    path->q = kern_question_of(s, shrink);
    path->tolerance = KERN_WIDTH;
    path->start = path->end = KERN_R(0);
    path->holds = path->fails = path->edge = KERN_R(0);
}

KERN_API kern_status kern_measure(const kern_structure *s,
                                  const kern_options *o, kern_work *work,
                                  kern_margin *out, const kern_proof *proof)
{
    kern_model m;
    kern_path path;
    kern_margin r;
    kern_status status;
    int last = 0, known;
    if (!out)
        return KERN_BAD_POINTER;
    status = kern_model_open(&m, s, o, work);
    if (status != KERN_STANDS)
        return status;
    kern_path_open(&path, KERN_PATH_SHRINK, s, KERN_R(0), proof);
    r.most = kern_most(&m);
    r.epsilon = kern_step(&m, o);
    r.margin = r.holds = r.fails = KERN_R(0);
    r.level = r.saturated = 0;
    status = kern_steps(&r, &last);
    if (status != KERN_STANDS)
        return status;
    status = kern_path_ask(&m, &path, KERN_R(0));
    if (status != KERN_STANDS) {
        if (status == KERN_FALLS)
            *out = r;
        return status;
    }
    known = kern_nested(&m);
    if (!m.relative)
        path.tolerance *= m.mean;
    path.end = r.most;
    if (!known) {
        status = kern_level_scan(&m, &path, last, 0, &r);
        if (r.level > 0 && r.level <= last)
            path.end = kern_min(KERN_R(r.level) * r.epsilon, r.most);
        path.holds = KERN_R(0);
    }
    if (status == KERN_STANDS)
        status = known ? kern_path_climb(&m, &path,
                             m.relative ? KERN_R(0.2) : KERN_R(0.08) * m.mean,
                             KERN_R(1.25), &r.saturated)
                       : kern_path_climb(&m, &path, r.most / KERN_SCAN,
                             KERN_R(1), &r.saturated);
    if (status != KERN_STANDS)
        return status;
    r.margin = path.edge;
    r.holds = path.holds;
    r.fails = path.fails;
    if (known)
        status = kern_level_scan(&m, &path, last, 1, &r);
    if (status == KERN_STANDS)
        *out = r;
    return status;
}

/* The extent: the longest side of the box around the free blocks. */
static kern_real kern_extent(const kern_structure *s)
{
    kern_real lo[2], hi[2];
    int i, k;
    lo[0] = lo[1] = KERN_INFINITY;
    hi[0] = hi[1] = -KERN_INFINITY;
    for (i = 0; i < s->blocks; i++) {
        const kern_block *b = s->block + i;
        for (k = 0; k < b->vertices && !b->fixed; k++) {
            lo[0] = kern_min(lo[0], b->vertex[k].x);
            lo[1] = kern_min(lo[1], b->vertex[k].y);
            hi[0] = kern_max(hi[0], b->vertex[k].x);
            hi[1] = kern_max(hi[1], b->vertex[k].y);
        }
        if (!b->fixed && b->vertices == 0) {
            const kern_real half = kern_block_size(b) / 2;
            lo[0] = kern_min(lo[0], b->centre.x - half);
            lo[1] = kern_min(lo[1], b->centre.y - half);
            hi[0] = kern_max(hi[0], b->centre.x + half);
            hi[1] = kern_max(hi[1], b->centre.y + half);
        }
    }
    return kern_max(hi[0] - lo[0], hi[1] - lo[1]);
}

KERN_API kern_status kern_deficit(const kern_structure *s,
                                  const kern_options *o, kern_work *work,
                                  kern_real *deficit)
{
    kern_model m;
    kern_path path;
    kern_status status;
    kern_real limit, growth, grown;
    int i;
    if (!deficit)
        return KERN_BAD_POINTER;
    status = kern_model_open(&m, s, o, work);
    if (status != KERN_STANDS)
        return status;
    kern_path_open(&path, KERN_PATH_SHRINK, s, KERN_R(0), NULL);
    status = kern_path_ask(&m, &path, KERN_R(0));
    if (status == KERN_STANDS)
        *deficit = KERN_R(0);
    if (status != KERN_FALLS)
        return status;
    limit = 1000 * kern_extent(s);
    grown = m.mean;
    if (m.relative) {
        kern_real least = KERN_INFINITY;
        for (i = 0; i < s->contacts; i++) {
            const kern_real l = kern_abs(kern_travel(s->contact + i, m.mean));
            if (l > 0 && l < least)
                least = l;
        }
        limit = least < KERN_INFINITY ? limit / least : KERN_R(1);
        grown = KERN_R(1);
    }
    path.tolerance *= grown;
    path.start = -limit;
    growth = kern_nested(&m) ? KERN_R(4) : KERN_R(1.1);
    for (grown *= KERN_R(0.001); ; grown = kern_min(grown * growth, limit)) {
        status = kern_path_ask(&m, &path, -grown);
        if (status != KERN_FALLS && status != KERN_UNDECIDED)
            break;
        if (grown >= limit) {
            *deficit = KERN_INFINITY;
            return status;
        }
    }
    if (status == KERN_STANDS)
        status = kern_path_edge(&m, &path);
    if (status == KERN_STANDS) {
        *deficit = -path.edge;
        status = KERN_FALLS;
    }
    return status;
}

/* How a load or a tilt is followed: a verdict where the path begins, the
   climb, the proofs. `out` is in the path's own measure. */
static kern_status kern_path_follow(kern_model *m, kern_path *path,
                                    kern_real step, kern_real growth,
                                    kern_real *out)
{
    int never = 0;
    kern_status status = kern_path_ask(m, path, KERN_R(0));
    if (status != KERN_STANDS)
        return status;
    status = kern_path_climb(m, path, step, growth, &never);
    if (status == KERN_STANDS)
        *out = never ? KERN_INFINITY : path->edge;
    return status;
}

/* Gravity and a side to turn it to. */
static int kern_has_side(const kern_structure *s, int side)
{
    return (side == 1 || side == -1)
           && kern_abs(s->gravity.x) + kern_abs(s->gravity.y) > 0;
}

KERN_API kern_status kern_load_factor(const kern_structure *s,
                                      kern_real shrink,
                                      const kern_wrench *pattern, int side,
                                      const kern_options *o, kern_work *work,
                                      kern_real *factor,
                                      const kern_proof *proof)
{
    kern_model m;
    kern_path path;
    int i;
    kern_status status = kern_model_open(&m, s, o, work);
    if (status != KERN_STANDS)
        return status;
    if (!factor)
        return KERN_BAD_POINTER;
    if (!kern_is_finite(shrink))
        return KERN_BAD_NUMBER;
    if (!pattern && !kern_has_side(s, side))
        return KERN_BAD_OPTION;
    for (i = 0; pattern && i < s->blocks; i++)
        if (m.group[i] >= 0 && !(kern_is_finite(pattern[i].fx)
                                 && kern_is_finite(pattern[i].fy)
                                 && kern_is_finite(pattern[i].torque))) {
            work->fault.block = i;
            return KERN_BAD_NUMBER;
        }
    kern_path_open(&path, KERN_PATH_LOAD, s, shrink, proof);
    path.q.pattern = pattern;
    path.q.side = side;
    path.end = KERN_FACTOR_MOST;
    return kern_path_follow(&m, &path, KERN_R(0.25), KERN_R(2), factor);
}

/* The angle whose tangent is s >= 0: halved twice, then the series. */
static kern_real kern_angle_of(kern_real s)
{
    kern_real sum = KERN_R(0), t2;
    int i;
    for (i = 0; i < 3; i++)
        s = s / (1 + KERN_SQRT(1 + s * s));
    t2 = s * s;
    for (i = 25; i > 0; i -= 2)
        sum = KERN_R(1) / KERN_R(i) - t2 * sum;
    return 8 * s * sum;
}

KERN_API kern_status kern_tilt(const kern_structure *s, kern_real shrink,
                               int side, const kern_options *o,
                               kern_work *work, kern_real *angle,
                               const kern_proof *proof)
{
    kern_model m;
    kern_path path;
    kern_real at = KERN_R(0);
    int i, loaded = 0;
    kern_status status = kern_model_open(&m, s, o, work);
    if (status != KERN_STANDS)
        return status;
    if (!angle)
        return KERN_BAD_POINTER;
    if (!kern_is_finite(shrink))
        return KERN_BAD_NUMBER;
    if (!kern_has_side(s, side))
        return KERN_BAD_OPTION;
    for (i = 0; i < s->blocks; i++)
        loaded |= m.group[i] >= 0
                  && kern_abs(s->block[i].load.fx)
                     + kern_abs(s->block[i].load.fy)
                     + kern_abs(s->block[i].load.torque) > 0;
    kern_path_open(&path, KERN_PATH_TILT, s, shrink, proof);
    path.q.side = side;
    path.end = KERN_R(1);
    status = kern_path_follow(&m, &path,
                              loaded ? KERN_R(1) / KERN_TILTS : KERN_R(0.1),
                              KERN_R(1), &at);
    if (status == KERN_STANDS)
        *angle = 4 * kern_angle_of(kern_min(at, KERN_R(1)));
    return status;
}

/* ---- Words and defaults ------------------------------------------ >>words */

KERN_API const char *kern_status_text(kern_status status)
{
    switch (status) {
#define KERN_STATUS_TEXT(name, value, text) case name: return text;
    KERN_STATUS_LIST(KERN_STATUS_TEXT)
#undef KERN_STATUS_TEXT
    }
    return "no status";
}

KERN_API kern_options kern_defaults(void)
{
    kern_options o;
    o.mu = KERN_R(0.4);
    o.gap = KERN_R(0);
    o.angle = KERN_R(0.0174533);
    o.epsilon = KERN_R(0);
    o.relative = 0;
    o.pivots = 0;
    return o;
}

#ifdef __cplusplus
}
#endif

#endif /* KERN_IMPLEMENTED */
#endif /* KERN_IMPLEMENTATION */

/*
   MIT License

   Copyright (c) 2026 the kern authors

   Permission is hereby granted, free of charge, to any person obtaining a copy
   of this software and associated documentation files (the "Software"), to deal
   in the Software without restriction, including without limitation the rights
   to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
   copies of the Software, and to permit persons to whom the Software is
   furnished to do so, subject to the following conditions:

   The above copyright notice and this permission notice shall be included in all
   copies or substantial portions of the Software.

   THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
   IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
   FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
   AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
   LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
   OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE
   SOFTWARE. */
