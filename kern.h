/* kern.h 0.2.0: how safely does a dry-stacked structure stand?

   A header-only C library for robots that build with found stones and no
   mortar. It finds the contacts between polygons, contact forces that hold
   every stone, and how far every contact can shrink until no such forces
   exist: a measure of stability. Each verdict has a proof, which was checked.

   SPDX-License-Identifier: MIT (text at the end of the file)

   CONTENTS: search for the tags
     I    Manual           >>what >>use >>conventions >>memory >>verdicts
                           >>config >>method >>rules >>measures >>measured
                           >>limits >>determinism
     II   Declarations     >>decl >>types >>sizes >>api
     III  Statics, proofs  >>impl >>tune (constants) >>vec >>statics (Eq. 5)
                           >>work >>check >>proof >>model
     IV   Forces, motions  >>lp (simplex method) >>skyline >>part >>norm >>pass
                           >>ipm >>verdict
     V    Measures         >>kern (Algorithm 1) >>search >>measure >>profile
                           >>critical >>sensitivity >>raised
     VI   Geometry         >>tol (tolerances) >>polygon >>contact, and >>plan
                           >>rest
     VII  Words            >>words
     VIII Sources          >>references >>changes, and the licence

   WHAT IT COMPUTES                                                    >>what

        +-----------+               A stone on two others. Each bed is a line
        |     2     |               contact, and its load may pass anywhere
        +--====-====+               along it (====). Shrink every contact by
      +------+ +------+             the same distance d from both ends:
      |   0  | |   1  |
      +------+ +------+             d = 0       |==========|   stands
     ==================             d             |======|     what is left: the
                                    d*              |==|       kern of a contact

   "Kern" is the paper's word for this, not for the middle third of a section.
   Beyond the margin d* no forces are in equilibrium.

   HOW TO USE IT                                                        >>use

   Define KERN_IMPLEMENTATION in exactly one C or C++ file before including
   kern.h; include it alone everywhere else. Only sqrt() is needed (-lm).

       kern_vec ground[4] = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
       kern_vec stone[4]  = {{0, 0}, {2, 0}, {2, 1}, {0, 1}};
       kern_block block[2];
       kern_contact contact[8];
       kern_real real[KERN_REALS(2, 8)];
       int index[KERN_INTS(2, 8)];
       kern_work work = kern_work_of(real, KERN_REALS(2, 8),
                                     index, KERN_INTS(2, 8));
       kern_task task = kern_task_of(block, 2, contact, 0, &work);
       kern_margin m;

       kern_ground_init(&block[0], ground, 4, NULL);
       kern_block_init(&block[1], stone, 4, 2400, NULL);     2400 kg/m^2
       task.s.contacts = kern_contacts(block, 2, &task.options, contact, 8,
                                       &work);
       if (kern_measure(&task, &m, NULL) == KERN_STANDS)
           printf("level %d, margin %g m\n", m.level, m.margin);

   Compare a verdict with == KERN_STANDS: KERN_FALLS is nonzero too. A negative
   count of contacts is a status, which the next call returns. With all checks
   it is examples/copy/one_block.c. "multiple definition": KERN_IMPLEMENTATION
   is in two files; "undefined reference": in none, or of the other precision.

   CONVENTIONS                                                  >>conventions

   Units of length, mass and time are your choice; comments say m, kg, s. Angles
   are in radians, counter-clockwise positive. Blocks are polygons in world
   coordinates of a plane: think of one unit of depth, and of a density per
   area. Contacts of a new stone (kern_touch()) are appended; to take the last
   stone back, make `blocks` and `contacts` smaller.

   MEMORY                                                            >>memory

   The library allocates nothing, has no globals and no recursion, and keeps
   nothing between calls: threads need no locks, each with its own work memory:
   two arrays, of KERN_REALS(blocks, contacts) and KERN_INTS(blocks, contacts)
   numbers (kern_work_need() at run time). Contacts are counted as points: a
   running bond has seven a block, twelve with joints between neighbours.
   KERN_CONTACTS(blocks) has room for these; stones with many short edges may
   need twice as many (KERN_NO_SPACE). Bytes in double (float: about half):

       blocks and contact points    5, 20    10, 60   30, 140  100, 600
       KERN_REALS and KERN_INTS     9,124    21,496    66,296   359,616
       both KERN_LEAN_ sizes        9,124    12,364    20,204    64,404

   KERN_LEAN_REALS and KERN_LEAN_INTS (from 10 blocks on) are enough where few
   blocks move at the margin, as in most walls: 0.7 MB, not 20, for 1000 blocks
   and 7000 points. Where many do, as in arches, a call returns KERN_NO_SPACE.

   VERDICTS AND PROOFS                                             >>verdicts

   KERN_STANDS: forces were found that pass kern_check_forces(); KERN_FALLS: a
   motion that passes kern_check_motion(). The checks use nothing of the solver.
   What passes neither is KERN_UNDECIDED (>>limits), never a guess.

   options.limit bounds the work of one call. Work that would exceed the limit,
   to read the input included, is not begun: the call returns KERN_LIMIT and
   writes what is proven by then. Below the limit the answer is the same, to the
   last bit, as without. A call takes at most 3,000 instructions and 2,000 for
   each unit of its limit, a whole answer 650 to 2,000 for each unit that it
   took (tests/work.sh limits): 0.1 to 0.6 microseconds of a desktop computer.

   CONFIGURATION                                                     >>config

   KERN_STATIC          in a file that wants a private copy of everything
   KERN_API             linkage of public functions; extern
   KERN_SINGLE          kern_real is float; the same in every file
   KERN_SQRT(x)         in place of sqrt or sqrtf and of <math.h>
   KERN_NO_INTERIOR     without >>ipm, for firmware: above 64 free blocks the
                        simplex method decides, which may take minutes
   KERN_USE_GLPK        large programs go to GLPK (under the GPL): see kern_lp.h
   KERN_GLPK_ROWS       rows above which they do (three a free block); 96

   Without a C library, -Os -fno-tree-loop-distribute-patterns keep gcc from
   memcpy and memset; -fno-math-errno makes the square root an instruction.

   METHOD                                                            >>method

   Every free block is in equilibrium, Eqs. (1) to (3), under contact forces
   without tension and within friction, Eq. (4):

       sum f n + r t + weight = 0,     sum (p - c) x (f n + r t) = 0,
       f >= 0,  |r| <= mu f.

   Along the two edges of the friction cone, n + mu t and n - mu t, this is Eq.
   (5): find x >= 0 with A x = -w (A_eq of the paper, >>statics). If there is
   none, Farkas' lemma gives a y with y.A >= 0 and y.w > 0: velocities and spins
   such that no contact closes and the weights do work: a mechanism. It proves
   that the structure falls.

   A verdict asks, in this order, until one gives a proof:

       top-down     >>pass    forces are passed on from top to bottom, a block
         |                    by three equations, a cluster where it cannot
         |-- every block balanced ------------------------> STANDS
         |-- some blocks cannot be held, all others fixed:
         |   simplex method on these (>>lp) --------------> FALLS
       whole        >>ipm     above 64 free blocks the interior-point method,
                    >>lp      else, and last, the simplex method

   A measure is the critical value of a path (kerns shrink, a load grows,
   gravity turns): the first at which it falls. That of the whole is at most
   that of a part with all other blocks fixed. So the search (>>search) begins
   at the smallest value of a body (a block with what rests on it alone), runs
   the pass there, and goes on to that of the part that falls, until none does.
   Where the pass gives no proof, the whole is asked. Load factor and tilt of up
   to 64 free blocks are one linear program with the value as a column. A
   proof to each side of the critical value makes the bracket.

   RULES                                                               >>rules

   What each number is, exactly, so that another program can reproduce it; the
   tests of each rule: CONTENTS of tests/kern_test.c.

   Contacts of two polygons that are not both fixed. `gap` and `angle` are
   those of the options; no tolerance is below 64 roundings of the largest
   coordinate. "Size" is that of the pair's smaller free block. Vertices where
   the outline turns by less than 1e-6 rad do not count.
     steps     A step turns one way and back. An outline with steps lower than
               the gap, or with risers of at most 1.6 gaps, carries as its
               Douglas-Peucker simplification (within the gap, or 1.42 risers)
               does: contacts lie on its chords and have their normals. Arcs and
               knees, whose corners all turn to one side, keep their edges.
     line      Two edges, one of each block, antiparallel within `angle`, and
               within the gap over a length of more than the gap or 1e-3 of the
               size, whichever is less. The contact points are the ends of that
               stretch, midway between the edges; n is the mean normal.
     point     A convex vertex within the gap of an edge, its foot more than
               1e-6 of the size from both ends, both edges of the vertex on the
               outer side of that edge within `angle`. The contact point is the
               vertex, n is the normal of the edge. It is no contact where a
               line contact of the pair, its normal within 10 degrees of n,
               passes within the gap.
     corner    A convex vertex within the gap of a reflex one: a point contact
               with each edge there on whose outer side both its edges lie.
               A convex vertex on a convex one is no contact.
     face      Contacts of a pair whose normals agree within `angle` and which
               lie on one line within the gap are one line contact, from the
               first to the last point, with the mean of the normals weighted by
               length. The longest contact begins a face, points come last.
     overlap   A point of one outline deeper than the gap inside the other
               block, or a block inside another: KERN_OVERLAP.
   A larger gap removes no support. Contacts that are given are taken as they
   are, with unit normals; a line off t by more than `angle` is refused.

   Shrinkage. A contact point has a direction u = t or -t, a travel l >= 0:
     line      The two ends go to each other; l is half the length.
     points    Two or more points of one pair go to the middle q of the two that
               are farthest apart, each along its own t: l = |(q - p) . t|.
     one point stays: l = 0, as does every l below 1e-9 of the mean size.
     lone      Where options.lone asks for it, the one point of a pair goes to
               the middle of what carries its block, as in Fig. 2 c, d of the
               paper: a contact carries the block that its normal pushes up, and
               the middle is that of the two points farthest apart that carry
               the same one. Kerns are then not nested (>>limits): a measure
               takes some fifteen times as long.
   It acts at p + min(d, l) u; with options.relative at p + d l u, d <= 1.
   d_max is the largest l (relative: 1). Normals do not change. With lines
   alone the contacts are nested and a structure that has fallen falls at every
   larger d; with points of different normals it may stand again.

   Measures, for a structure that stands at d = 0 unless said otherwise:
     level     The smallest k >= 1 such that it falls at min(k epsilon, d_max);
               ceil(d_max / epsilon) + 1, saturated, where there is none; 0
               where it falls at d = 0.
     margin    The largest d* such that it stands at every d below d*; d_max,
               saturated, where it stands throughout.
     deficit   Where it falls at d = 0: the least growth d with contact points
               at p - d u (relative: p - d l u) such that it stands; infinite
               where a growth of 1000 times the longest side of the free
               blocks' box (relative: over the smallest l) is not enough.
     load      The largest factor f such that it stands under every multiple of
     factor    the pattern up to f. Horizontal: f m |g| at every centre, to the
               right (gravity turned by +90 degrees) or to the left.
     tilt      The first angle of gravity, turned to the side, at which it
               falls; pi where there is none. Loads do not turn.
     profile   d grows from 0. Where the structure falls, the blocks that move
               in the mechanism get that d and are taken away, and d goes on
               from there. A block that never moves gets d_max, one that moves
               at once 0. The same with a horizontal load, up to a factor 10.
               Of several mechanisms one of few blocks is preferred.
     mechanism Where it falls: velocities of all free blocks, the largest of a
               centre or of a spin times the block's size being 1.

   WHAT EACH NUMBER IS GOOD FOR                                    >>measures

   margin      comparing structures and places for a stone: how far the worst
               stone is from the edge of what carries it, in metres, so that
               large stones weigh more; relative: a share. level: the paper's
   load factor the largest sideways acceleration, in units of gravity; raised
               load: without dilatant sliding, see >>limits
   tilt        how far the ground may turn: without loads atan(load factor)
   deficit     how much is missing, where it falls
   bearing     the length of the shortest contact that it needs
   mechanism   which stones go first, and how
   profile     how much worse it gets then: every stone's margin or load factor,
               their mean, that of the weaker half, and the expected drop
   raised      whether its load raises its forces, with what reserve for a push
   stays       the chance that a stone stays where it is let go
   sensitivity how a stone should move, and how exactly lie (examples/nudge.c)
   push        the load factor of a force on one stone (examples/push.c)
   rest        where a stone comes to rest, and which place is best: the chance
               that it stays comes first (kern_place_compare(), examples/place.c)

   Kerns shrink to a point, and a point still carries: a stone one end of which
   rests on 2 micrometres has the margin of the other end. The bearing length
   sees the sliver; a robot that places stones less exactly than that cannot
   count on it. A saturated margin, half the longest contact, tells no safety.

   Collapse under shaking. All but the profile tell when the first stone falls,
   not when half of a wall does. A stone that rocks soon meets the next one, so
   contacts that a little motion closes count too:

       task.options = kern_near(&task.options, kern_mean_size(block, blocks));
       find the contacts with these, then
       kern_profile(&task, side, value, &c) for KERN_LEFT and KERN_RIGHT,
       and add both c.drop, the expected drop: larger is worse

   It ranks structures by their level of collapse as no other measure does
   (README; examples/shaking/study/STUDY.md). Where stones slide before they
   tip, as in low walls, all load factors end at mu and rank less well. Near
   contacts are not for verdicts: a gap carries nothing yet.

   Whether a stone stays where it is let go. kern_stays() gives the chance. Let
   go from 0.5 on, that keeps 0.95 of what stays and rejects 0.97 of what moves;
   from 0.3 on 0.96, 0.94; from 0.9 on 0.85, 0.995 (README, tests/TRUST.md).

   Forces. Many sets of forces hold a structure; no measure depends on which,
   and a proof has the first that was found. To look at, take the minimum-norm
   forces (kern_forces()): one set, symmetric where the structure is, which
   loads all that can carry. Those of kern_raised() are closer to friction, but
   not unique. Neither says how stones of some stiffness share a load.

   STONES FROM A CAMERA OR A SCANNER                               >>measured

   Outline. Simplify it first (Douglas and Peucker), to one to three pixels:
   raw points on a grid touch each other (KERN_CROSSING). Steps of a pixel
   carry no load of their own where a pixel is no more than the gap (>>rules):
   else set options.gap to a pixel and a half. The density is that of the
   material times the thickness. examples/copy/contour.c shows these steps.

   Error. kern_measured_options() takes the standard errors of a stone's place
   (of pixel, simplification and registration the squares are added) and angle.
   Margins of a stone of 40, 200 or 1000 vertices then agree within 2 %; else
   the discretisation decides them. Overlaps beyond the error are modelling
   errors (kern_overlaps()): measure again, or set options.overlap.

   Certainty. kern_certain() tells whether the verdict is certain within the
   error, and between what the margin lies. A gap below the error may be open,
   so what needs two supports of a block never stands for certain: with one of
   them half an error short it may fall and looks the same. How often it is
   right: README; with noise of 0.5 % of the mean size 99 % of the verdicts are,
   and of near misses 0.7 % at most stand for certain (tests/TRUST.md).

   LIMITS                                                            >>limits

   Model     Two dimensions, rigid blocks that do not break, statics. "Stands"
             means that admissible forces exist: necessary for standing still,
             with friction not sufficient. A cube held between two walls by
             friction alone counts as standing; kern_raised() tells whether the
             load raises such forces.
   Unsafe    Mechanisms are those of limit analysis: blocks that slide also part
             (dilatant sliding). Where a wall's own joints slide, load factor
             and tilt are too high: against a simulator by 11 to 26 % on four
             published brick walls with openings (tests/PUBLISHED.md), once 2.5
             times on random ones; never on settled rubble. kern_raised_load()
             has no dilatancy (README), but answers for one path of loading:
             take the lower. Bricks that hang in a flat arch are not raised.
   Ambiguous A reserve cannot see equilibria that depend on what happened
   forces    before: of 181 rows of wedges between cliffs that fall in a
             simulator though forces exist, 2 have the largest (tests/TRUST.md).
   Loads     stay: what kern_block_load() adds neither grows with a horizontal
             load nor turns with gravity.
   Not       Kerns that are not nested (points of different normals) are
   nested    searched in steps <= d_max / 1001, tilts with loads in steps of
             pi / 1001: a fall narrower than that may be missed.
   Undecided Within 1e-9 of the mean size of critical; in jams, whose forces
             grow without bound toward critical, within 1e-7, rarely 1e-5; where
             one block weighs more than 1e4 times another, farther. A level is
             undecided only if the verdict at a step that it depends on is.
             Bricks held by loads up to 1000 times their weight: none of 288
             with mu up to 100, with mu 1000 2 of 96.
   Brackets  At most 2e-6 mean sizes wide (load factor 2e-6, tilt 8e-6 rad); in
             jams up to ten times as wide (one of a thousand of 4 to 15 blocks);
             above 256 blocks of which many move at once up to 3e-5. Above 64
             such blocks a value may lie anywhere in it.
   Slow      Structures of many blocks of which many move at the margin: bricks
             of one size, long arches (tests/BENCH.md).
   Float     Proofs are weaker (>>tune), a deficit is exact to 3e-6 sizes, above
             64 blocks values to 0.05; more is undecided near critical; where
             wedges jam a margin may be off by 1/3 size. Stay near the origin.

   DETERMINISM                                                  >>determinism

   The same input gives the same bits on every machine whose compiler keeps to
   IEEE arithmetic:

       -ffp-contract=off     where the target has fused multiply-add (AArch64,
                             PowerPC, s390x, x86 with -mfma); gcc contracts by
                             default in GNU modes, clang from version 14 on
       -fno-tree-vectorize   with gcc as well, where it has vectors of those:
                             it fuses pairs of products all the same. On x86
                             this file sees to that, for itself alone
       -msse2 -mfpmath=sse   on 32-bit x86
       never -ffast-math, -Ofast or -funsafe-math-optimizations, nor where the
                             program is linked: they flush small numbers to 0

   Only + - * / and square root are used, which must round as IEEE asks: sums of
   doubles by libgcc for ARM do not always. tests/golden.c sees wrong flags. */

/* ==== Part II: Declarations ======================================== >>decl */

#ifndef KERN_H
#define KERN_H

#define KERN_VERSION "0.2.0"
#define KERN_VERSION_NUMBER 200 /* 10000 major + 100 minor + patch */

#if defined(KERN_IMPL) || defined(KERN_IMPLEMENT) || defined(KERN_FLOAT) \
    || defined(KERN_DOUBLE) || defined(KERN_GLPK) || defined(USE_GLPK)
#error "kern.h: define KERN_IMPLEMENTATION, _SINGLE (float) or _USE_GLPK"
#endif

#ifdef KERN_SINGLE
typedef float kern_real;
/* Symbols of their own: a file compiled in the other precision fails when it
   is linked, not when it runs, and one program may hold both. */
#define kern_bearing kern_bearing_f32
#define kern_block_init kern_block_init_f32
#define kern_block_load kern_block_load_f32
#define kern_check_forces kern_check_forces_f32
#define kern_check_motion kern_check_motion_f32
#define kern_check_raised kern_check_raised_f32
#define kern_contact_at kern_contact_at_f32
#define kern_contact_make kern_contact_make_f32
#define kern_contact_travels kern_contact_travels_f32
#define kern_contacts kern_contacts_f32
#define kern_critical_of kern_critical_of_f32
#define kern_defaults kern_defaults_f32
#define kern_deficit kern_deficit_f32
#define kern_forces kern_forces_f32
#define kern_ground_init kern_ground_init_f32
#define kern_known_of kern_known_of_f32
#define kern_load_factor kern_load_factor_f32
#define kern_load_factor_of kern_load_factor_of_f32
#define kern_lp_solve kern_lp_solve_f32
#define kern_mean_size kern_mean_size_f32
#define kern_measure kern_measure_f32
#define kern_near kern_near_f32
#define kern_measured_options kern_measured_options_f32
#define kern_certain kern_certain_f32
#define kern_overlaps kern_overlaps_f32
#define kern_plan_add kern_plan_add_f32
#define kern_plan_bears kern_plan_bears_f32
#define kern_place_compare kern_place_compare_f32
#define kern_plan_copy kern_plan_copy_f32
#define kern_plan_of kern_plan_of_f32
#define kern_plan_raised kern_plan_raised_f32
#define kern_plan_stays kern_plan_stays_f32
#define kern_plan_remove kern_plan_remove_f32
#define kern_plan_try kern_plan_try_f32
#define kern_profile kern_profile_f32
#define kern_raised kern_raised_f32
#define kern_raised_load kern_raised_load_f32
#define kern_rest kern_rest_f32
#define kern_sensitivity kern_sensitivity_f32
#define kern_status_text kern_status_text_f32
#define kern_stays kern_stays_f32
#define kern_task_of kern_task_of_f32
#define kern_tilt kern_tilt_f32
#define kern_touch kern_touch_f32
#define kern_verdict kern_verdict_f32
#define kern_work_need kern_work_need_f32
#define kern_work_of kern_work_of_f32
#else
typedef double kern_real;
#endif

#if defined(KERN_STATIC) && (defined(__GNUC__) || defined(__clang__))
#define KERN_API static __attribute__((unused))
#elif defined(KERN_STATIC)
#define KERN_API static
#elif !defined(KERN_API)
#define KERN_API extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Types ------------------------------------------------------- >>types */

typedef struct kern_vec {
    kern_real x, y;
} kern_vec;

/* Upright rectangle: its lower left and its upper right corner [m]. */
typedef struct kern_box {
    kern_vec low, high;
} kern_box;

/* Above zero a call returns a verdict, or a linear program's result; zero where
   it has none. Below zero it failed, and of the caller's data only counters and
   fault of the work memory changed; with KERN_LIMIT also what it says. */
#define KERN_STATUS_LIST(X)                                                  \
    X(KERN_OK, 0, "done")                                                    \
    X(KERN_STANDS, 1, "stands: forces were found that hold every block")     \
    X(KERN_FALLS, 2, "falls: a motion was found that no forces can stop")    \
    X(KERN_LP_OPTIMAL, 3, "optimal: a solution of least cost")               \
    X(KERN_LP_INFEASIBLE, 4, "infeasible: no solution exists")               \
    X(KERN_LP_UNBOUNDED, 5, "unbounded: the cost falls without end")         \
    X(KERN_UNDECIDED, -1, "undecided: neither is proven")                    \
    X(KERN_NO_SPACE, -2, "a result or work array is too short")              \
    X(KERN_BAD_POINTER, -3, "a pointer is null")                             \
    X(KERN_BAD_NUMBER, -4, "a number is not finite or out of bounds")        \
    X(KERN_BAD_COUNT, -5, "a count is out of bounds")                        \
    X(KERN_FEW_VERTICES, -6, "a polygon has fewer than three vertices")      \
    X(KERN_NO_AREA, -7, "a polygon has no area")                             \
    X(KERN_CROSSING, -8, "a polygon crosses itself or passes a point twice") \
    X(KERN_BAD_MASS, -9, "a mass or density is out of range")                \
    X(KERN_BAD_FRICTION, -10, "friction is negative")                        \
    X(KERN_BAD_OPTION, -11, "an option or side is out of range")             \
    X(KERN_BAD_BLOCK, -12, "no block has that index")                        \
    X(KERN_SAME_BLOCK, -13, "a contact names one block twice")               \
    X(KERN_BAD_NORMAL, -14, "a contact has no normal of length 1")           \
    X(KERN_BAD_LINE, -15, "a line contact is off its tangent")               \
    X(KERN_OVERLAP, -16, "two blocks overlap deeper than the gap tolerance") \
    X(KERN_NO_FREE, -17, "no block is free")                                 \
    X(KERN_BAD_STEP, -18, "a step needs over 1,000,000 levels")              \
    X(KERN_LIMIT, -19, "the limit of work was reached")                      \
    X(KERN_STALE, -20, "vertices have moved since kern_block_init()")        \
    X(KERN_NO_LOAD, -21, "no gravity or load acts on a free block")          \
    X(KERN_BAD_SHARE, -22, "relative: a shrinkage is above 1")               \
    X(KERN_NO_BLOCK, -23, "a block was refused when it was made")            \
    X(KERN_NO_SUPPORT, -24, "nothing is below the stone: it falls past")     \
    X(KERN_NO_REST, -25, "the stone goes on turning or sliding")

typedef enum kern_status {
#define KERN_STATUS_NAME(name, value, text) name = value,
    KERN_STATUS_LIST(KERN_STATUS_NAME)
#undef KERN_STATUS_NAME
        KERN_STATUS_LEAST = -25 /* the same number */
} kern_status;

/* Where the fault of a status below zero lies. */
typedef struct kern_fault {
    int block;         /* index of a block, -1: none                       */
    int other;         /* the other block of an overlap, -1: none          */
    int index;         /* vertex of the polygon or contact point, -1: none */
    kern_real value;   /* an overlap is at least this deep [m], 0: none    */
    kern_real allowed; /* overlap that would be a contact [m], 0: none     */
} kern_fault;

/* A force [N] and a counter-clockwise torque [N m] about a centre of mass. */
typedef struct kern_wrench {
    kern_real fx, fy, torque;
} kern_wrench;

/* A stone or ground: kern_block_init(). Mass, centre, load may change later. */
typedef struct kern_block {
    const kern_vec *vertex; /* simple polygon, the caller's [m]; NULL: none   */
    int vertices;           /* >= 3; 0 with vertex NULL; -1: it was refused   */
    int fixed;              /* nonzero: ground, exerts whatever is needed     */
    kern_real area;         /* [m^2], < 0: clockwise; "size": sqrt(|area|)    */
    kern_box box;           /* of the polygon; read where there are vertices  */
    kern_real mass;         /* [kg] > 0; of fixed blocks not read             */
    kern_vec centre;        /* centre of mass [m]                             */
    kern_wrench load;       /* acts besides the weight, at the centre         */
} kern_block;

/* A contact point. Block b feels the force  f n + r t  at p, block a the
   opposite; t = (-n.y, n.x). A line contact is two points, neighbours in the
   array: lines, pairs and groups of points are one thing to the statics. */
typedef struct kern_contact {
    int a, b;         /* blocks, a != b                                   */
    int line;         /* nonzero: one end of a line contact               */
    kern_vec p;       /* place [m]                                        */
    kern_vec n;       /* unit normal from a into b                        */
    kern_real mu;     /* coefficient of friction >= 0                     */
    kern_real travel; /* along t to the closed kern, signed [m]: >>rules  */
} kern_contact;

/* Two blocks that overlap deeper than the options allow. */
typedef struct kern_overlap {
    int a, b;          /* blocks, a < b                                    */
    kern_real depth;   /* of the overlap [m], 1/8 too small at most        */
    kern_real allowed; /* it would be a contact up to that [m]             */
} kern_overlap;

typedef struct kern_structure {
    const kern_block *block;
    int blocks;
    const kern_contact *contact;
    int contacts;     /* contact points                                   */
    kern_vec gravity; /* acceleration [m/s^2], on Earth (0, -9.81)        */
} kern_structure;

typedef struct kern_options { /* always start from kern_defaults()            */
    kern_real mu;         /* friction of contacts found from polygons; 0.4    */
    kern_real gap;        /* widest gap that is a contact [m]; 0: 1e-3 of the
                             size of the pair's smaller free block            */
    kern_real angle;      /* widest of touching edges [rad], < 0.5; 0.0174533 */
    kern_real epsilon;    /* step of Algorithm 1 [m]; 0: 0.02 mean block size;
                             relative: a share, 0: 0.05                       */
    int relative;         /* nonzero: shrinkage is a share of each travel     */
    int limit;            /* most units of work of one call (>>verdicts);
                             10,000,000; 0: 2,000,000,000, also the largest   */
    kern_real overlap;    /* deepest overlap that is a contact [m]; 0: gap    */
    kern_real pose_error; /* standard error of the blocks' places [m] and     */
    kern_real pose_turn;  /* angles [rad]: kern_measured_options(); 0: exact  */
    kern_real narrow;     /* rate at which cones of friction narrow as kerns
                             shrink [1/m; relative: 1]; 0, see kern_measure() */
    kern_real reserve;    /* most that kern_raised() asks for, <= 0.1; 0: 0.1 */
    kern_vec lone;        /* gravity, of any length: lone points that are found
                             travel (>>rules); (0, 0): they stay              */
} kern_options;

/* Of a contact point [N], and of a block: velocity of its centre and spin. */
typedef struct kern_force {
    kern_real normal, tangential;
} kern_force;
typedef struct kern_motion {
    kern_real vx, vy, spin;
} kern_motion;

/* Where to put the proof: arrays of the caller, each may be NULL. Measures use
   them on the way, so after a status below zero their contents mean nothing. */
typedef struct kern_proof {
    kern_force *force;   /* one a contact point: written with KERN_STANDS    */
    kern_motion *motion; /* one a block, fixed ones rest: with KERN_FALLS    */
} kern_proof;

typedef struct kern_margin {
    kern_real margin;  /* d*, the shrinkage up to which it stands [m]      */
    kern_real holds;   /* largest shrinkage known to stand, proven         */
    kern_real fails;   /* smallest known to fall, proven; `most` if none   */
    kern_real most;    /* d_max: every kern is closed [m]; relative: 1     */
    kern_real epsilon; /* step that was used                               */
    int level;         /* Algorithm 1; -1: a verdict it needs is undecided */
    int saturated;     /* nonzero: stands with every kern closed           */
} kern_margin;

/* Of the margin of a measured structure: kern_certain() [m; relative: 1]. */
typedef struct kern_interval {
    kern_real low;  /* 0: it may fall                                   */
    kern_real high; /* 0: it falls; KERN_INFINITY: not known            */
} kern_interval;

/* By how much the margin grows when one datum of a contact point does by 1: its
   place, normal turned [1/rad], friction, travel of a kern closed there. */
typedef struct kern_contact_rate {
    kern_vec p;
    kern_real turn, mu, travel;
} kern_contact_rate;

/* The same of a block. Its place, and its turning about its centre [m/rad]: its
   contacts follow as the search would find them again; loads stay. */
typedef struct kern_block_rate {
    kern_vec centre, place;
    kern_real turn, mass; /* [m/rad], [m/kg] */
    kern_wrench load;     /* [m/N], [1/N] */
} kern_block_rate;

/* What is known of the forces in a structure that stands. */
typedef enum kern_raising {
    KERN_NOT_SHOWN, /* neither of these: no proof of falling            */
    KERN_RAISED,    /* its load raises forces that hold it              */
    KERN_HANGS      /* some blocks rest on nothing, others stand alone  */
} kern_raising;

/* A profile in four numbers: of margins [m] or load factors of free blocks. */
typedef struct kern_collapse {
    kern_real least; /* the weakest block's: the margin, the load factor */
    kern_real mean;  /* progressive margin, or progressive load factor   */
    kern_real weak;  /* mean of the lower half                           */
    kern_real drop;  /* expected drop: mean of h exp(-value / 0.07), h
                             the height of the centre above the lowest block
                             in mean sizes, at least 0.3; without loads 0     */
} kern_collapse;

/* What a mechanism does at a contact point. */
typedef enum kern_meeting {
    KERN_RESTS,  /* its blocks move as one, or not at all            */
    KERN_HINGES, /* they turn about it                               */
    KERN_SLIDES, /* they slide, and part as sliding does (>>limits)  */
    KERN_OPENS   /* they part                                        */
} kern_meeting;

/* What limits a measure, and what moves first: kern_critical_of(). Each array,
   of the caller, may be NULL. */
typedef struct kern_critical {
    kern_meeting *meeting; /* one a contact point                             */
    kern_real *limit;      /* one a contact point: how much it limits, as a
                             share of `contact`; up to 1.0001                 */
    int *group;            /* one a block: number of the group that moves as one
                             with it, 0 the fastest; -1: it rests             */
    int contact; /* the first that limits most, to 1e-4; -1: none    */
    int groups;  /* 0 where `group` is NULL                          */
} kern_critical;

/* Work memory: two arrays of the caller. Nothing in them needs to be set. */
typedef struct kern_work {
    kern_real *real;
    int reals; /* KERN_REALS(blocks, contacts)                     */
    int *index;
    int indices; /* KERN_INTS(blocks, contacts)                      */
    /* the library adds up; the caller reads, and sets to 0 as it likes       */
    int pivots;       /* of all linear programs                           */
    int solves;       /* top-down passes and linear programs              */
    int units;        /* work of the last call but searches for contacts;
                             limit + 1 with KERN_LIMIT, else within the limit */
    kern_real error;  /* largest of a proof, in what is allowed: <= 1     */
    kern_fault fault; /* of the last call that returned less than 0       */
} kern_work;

/* Warm start: what kern_measure() remembers for the next one of nearly the same
   structure. Two arrays of the caller, both or none. Whatever stands there
   changes the time of a measure and not its answer: it is verified first. */
typedef struct kern_known {
    kern_motion *motion; /* one a block: of the mechanism, at fails          */
    kern_force *force;   /* one a contact point: at holds                    */
    kern_real holds, margin, fails; /* of the last measure; fails 0: none     */
} kern_known;

/* What a call needs: kern_task_of(). Fields may be changed between calls. */
typedef struct kern_task {
    kern_structure s;
    kern_options options; /* kern_defaults()                                  */
    kern_work *work;      /* not NULL                                         */
    kern_known known;     /* arrays NULL: nothing is remembered               */
} kern_task;

/* A structure that a planner changes by one block at a time: kern_plan_of().
   Set task.options and task.s.gravity before blocks are added. Contacts that
   are given rather than found may be appended to contact[task.s.contacts]. */
typedef struct kern_plan {
    kern_task task;    /* the structure as it is now                       */
    kern_block *block; /* arrays of the caller, which task.s reads         */
    int block_room;
    kern_contact *contact;
    int contact_room;
} kern_plan;

/* How a stone at rest is held. */
typedef enum kern_held {
    KERN_HELD,  /* forces at two touches, or one, balance its weight */
    KERN_WEDGED /* no motion is free; friction may hold it or not    */
} kern_held;

/* Where a stone comes to rest: kern_rest(). */
typedef struct kern_pose {
    kern_block block; /* the stone there, with its own vertices        */
    kern_vec turn;    /* by which it was turned: cosine, sine          */
    kern_held held;
    kern_vec at[2]; /* KERN_HELD: where the forces act               */
    int on[2];      /* the blocks that they come from, -1: none      */
    int motions;    /* on the way, the first of which is downward    */
} kern_pose;

/* A place for a stone, with what kern_place_compare() ranks it by. A number
   that was not asked for is 0 in all places. */
typedef struct kern_place {
    kern_real x, turn; /* as in kern_rest()                               */
    kern_real stays;   /* chance that it stays: kern_plan_stays()         */
    kern_real margin;  /* of the structure with it: kern_plan_try()       */
    kern_real own;     /* the stone's value in a profile: kern_profile()  */
    kern_real load;    /* the least load factor: kern_load_factor()       */
} kern_place;

/* Sides of a horizontal load or tilt: right is +x for gravity (0, -9.81). */
typedef enum kern_side {
    KERN_LEFT = -1,
    KERN_SHRINK = 0, /* no load, kerns shrink: for kern_profile() alone  */
    KERN_RIGHT = 1
} kern_side;

/* A linear program:  minimise cost . x  where  A x = rhs  and  x >= 0. */
typedef struct kern_lp {
    int rows, cols;
    const kern_real *a;    /* rows x cols, column by column                   */
    const kern_real *rhs;  /* one a row                                       */
    const kern_real *cost; /* one a column; NULL: any solution will do        */
    int limit;             /* most units of work, as in kern_options          */
} kern_lp;
/* Infinity: outside of gcc and clang a product that overflows when compiled. */
#if defined(__GNUC__) && defined(KERN_SINGLE)
#define KERN_INFINITY __builtin_inff()
#elif defined(__GNUC__)
#define KERN_INFINITY __builtin_inf()
#else
#define KERN_INFINITY ((kern_real)(1e300 * 1e300))
#endif

/* ---- Sizes ------------------------------------------------------- >>sizes */
/* Constant expressions (>>memory); blocks include fixed ones. KERN_ROOM is for
   factors of columns with fill-in (>>lp), KERN_LP_ROOM of a dense program. */
#define KERN_CONTACTS(blocks) (12 * (blocks) + 16)
#define KERN_EXTRAS(blocks) ((blocks) < 4 ? 3 * (blocks) : 3 * (blocks) / 2 + 8)
#define KERN_LEAN_EXTRAS(blocks) \
    ((blocks) < 10 ? KERN_EXTRAS(blocks) : (blocks) / 2 + 2)
#define KERN_ROOM(extras) ((extras) * ((extras) + 5))
#define KERN_REALS(blocks, contacts)                                  \
    (KERN_ROOM(KERN_EXTRAS(blocks)) + 54 * (blocks) + 12 * (contacts) \
     + 4 * ((contacts) < 400 ? (contacts) : 400) + 24)
#define KERN_INTS(blocks, contacts) (45 * (blocks) + 9 * (contacts) + 48)
#define KERN_LEAN_PART(blocks) ((blocks) / 40 + 3)
#define KERN_LEAN_REALS(blocks, contacts) \
    (12 * (blocks) + 6 * (contacts)       \
     + KERN_REALS(KERN_LEAN_PART(blocks), 8 * KERN_LEAN_PART(blocks)))
#define KERN_LEAN_INTS(blocks, contacts) \
    (10 * (blocks) + 4 * (contacts)      \
     + KERN_INTS(KERN_LEAN_PART(blocks), 8 * KERN_LEAN_PART(blocks)))
#define KERN_LP_ROOM(rows) (((rows) + (rows) / 2 + 8) * ((rows) + 2))
#define KERN_LP_REALS(rows, cols) (KERN_LP_ROOM(rows) + 5 * (rows) + 16)
#define KERN_LP_INTS(rows, cols) (9 * (rows) + (cols) + 30)

/* ---- Functions ----------------------------------------------------- >>api */
/* B is the number of blocks, C of contact points. No pointer may be NULL unless
   its function says so: KERN_BAD_POINTER. Every function that takes work memory
   may return KERN_NO_SPACE, every one that takes a structure: KERN_BAD_POINTER,
   _NUMBER, _COUNT (blocks up to 20,000, contacts up to 1,000,000), _MASS,
   _FRICTION, _OPTION, _BLOCK, _NORMAL, _SHARE (a relative shrinkage above 1),
   KERN_SAME_BLOCK, KERN_NO_BLOCK, KERN_NO_AREA, KERN_NO_FREE, KERN_NO_LOAD,
   KERN_LIMIT; where the number of contacts is below -1 it is the status of
   kern_contacts(), returned with its fault. A measure with KERN_LIMIT is the
   largest proven to stand by then, below 0 if none is. Numbers that cannot be
   squared or multiplied safely are refused, with the block in the fault. With F
   = 1e60 (float: 1e10): a mass out of 1 / F to F (KERN_BAD_MASS), an area below
   1 / F^2 (KERN_NO_AREA), as KERN_BAD_NUMBER an option, vertex, centre, place
   or travel above F [m], an area above F^2, pattern or weight with load of a
   block above F [N], or the latter below 1 / F and not 0. */

/* Returns what a status means, in words; also of a count that is below 0. */
KERN_API const char *kern_status_text(int status);

/* The defaults that stand beside each field of kern_options. */
KERN_API kern_options kern_defaults(void);

/* *options (NULL: the defaults) that also find contacts which a little rocking
   closes: gap at least 4 % of the mean size [m], angle at least 0.15 rad. */
KERN_API kern_options kern_near(const kern_options *options,
                                kern_real mean_size);

/* Options for measured structures (>>measured), from *options (NULL: the
   defaults): e is the standard error of a stone's place [m], theta of its angle
   [rad]; vertices within their stone are as exact as half of e. Sets
     gap      5.25 e, and 1e-3 of the size; at a place r from the centre of its
              block 3.5 theta r is added for both blocks, as squares (>>tol)
     angle    7 theta, at least 1 degree and below 0.5; a corner may stand 3 e
              beyond the end of an edge
     overlap  8 e, and 3.5 theta r for r half the diagonal of both boxes;
              contacts lie at half the depth. Set it higher to accept more
   Verdicts are then those of the structure as it most likely rests. Every call
   returns KERN_BAD_OPTION for these options unless e > 0 and theta >= 0. */
KERN_API kern_options kern_measured_options(const kern_options *options,
                                            kern_real e, kern_real theta);

/* Work memory of two arrays, with its counters at zero. */
KERN_API kern_work kern_work_of(kern_real *real, int reals, int *index,
                                int indices);

/* KERN_REALS and KERN_INTS at run time; 0 where a count is out of range. */
KERN_API void kern_work_need(int blocks, int contacts, int *reals,
                             int *indices);

/* -- blocks -- */

/* Fills a block from a simple polygon, convex or not, turning either way: area,
   box, centroid, mass = density * |area| with the density in kg/m^2, no load.
   The vertices stay the caller's and must live as long as the block; after they
   have moved, call this again. fault may be NULL; its index is the vertex. A
   failed call leaves no block: others return KERN_NO_BLOCK for it.
   KERN_FEW_VERTICES, KERN_BAD_COUNT (above 1,000,000), KERN_BAD_NUMBER,
   KERN_NO_AREA, KERN_CROSSING (also where the last vertex repeats the first, as
   in closed rings of other formats), KERN_BAD_MASS (also a density not above
   0): bounds as above. Time: O(n) for n vertices of a convex polygon, else a
   test of boxes for each two edges. */
KERN_API kern_status kern_block_init(kern_block *block, const kern_vec *vertex,
                                     int vertices, kern_real density,
                                     kern_fault *fault);

/* The same for a fixed block: ground, a wall, a support. */
KERN_API kern_status kern_ground_init(kern_block *block, const kern_vec *vertex,
                                      int vertices, kern_fault *fault);

/* Adds a force [N] that acts at a point and a torque [N m] to the block's
   load, which acts at the centre: set the centre first. */
KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec at,
                              kern_real torque);

/* Mean size of the free blocks [m]: the mean of the roots of their areas. */
KERN_API kern_real kern_mean_size(const kern_block *block, int blocks);

/* -- contacts -- */

/* Finds the contacts between all blocks (>>rules) and writes them to
   out[0..room): those of block 1 with block 0, of block 2 with 0 and with 1,
   and so on. A block without vertices has none. Returns how many contact
   points there are, or KERN_NO_SPACE (out means nothing; on the way it takes
   some seven points for each step of an outline), KERN_OVERLAP (the first
   pair), KERN_BAD_POINTER, _COUNT, _NUMBER, _FRICTION, _OPTION,
   KERN_FEW_VERTICES, KERN_NO_AREA, KERN_NO_BLOCK, KERN_STALE (the block's
   vertices have moved, or their array was used for another block). Work
   memory: the fault alone. Time: a test of boxes for each two blocks; where
   they meet a few products for near edges, tens where no edge parts them. */
KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options, kern_contact *out,
                           int room, kern_work *work);

/* Lists all pairs of blocks that overlap too deeply for a contact. Returns how
   many, of which room are written at most, or below 0 as kern_contacts(). */
KERN_API int kern_overlaps(const kern_block *block, int blocks,
                           const kern_options *options, kern_overlap *out,
                           int room, kern_work *work);

/* The contacts of block b with the blocks before it: those of kern_contacts(),
   unless a later block lies so far out that the rounding of its coordinates
   counts. Returns the same; KERN_STALE is found of block b and of what it may
   touch. options.lone: what carries a block is looked for among these contacts
   alone. Time: O(b), and the edges as above. */
KERN_API int kern_touch(const kern_block *block, int b,
                        const kern_options *options, kern_contact *out,
                        int room, kern_work *work);

/* Makes a contact that is given rather than found. *out has a, b, p, mu and
   the normal n, from a into b and of any length; the contact goes from p to q,
   or is the point p where q equals p. Writes one or two contact points from
   out on and returns how many, or KERN_SAME_BLOCK, KERN_BAD_BLOCK (an index
   below 0), KERN_BAD_NUMBER, KERN_BAD_FRICTION, KERN_BAD_NORMAL (no length),
   KERN_BAD_LINE (p to q leaves the tangent by more than options->angle),
   KERN_BAD_OPTION. When all are made: kern_contact_travels(). */
KERN_API int kern_contact_make(kern_contact *out, kern_vec q,
                               const kern_options *options);

/* Sets the travel of every contact point (>>rules), a point's from the others
   of its interface: the same two blocks, in either order. NULL: no effect.
   Time: O(C) for each interface, and for each of its points beside another. */
KERN_API void kern_contact_travels(kern_contact *contact, int contacts);

/* Where a contact point acts at a shrinkage, or where it is negative a growth;
   relative: at a share, above 1 at the middle. The origin for NULL. */
KERN_API kern_vec kern_contact_at(const kern_contact *contact, kern_real shrink,
                                  int relative);

/* -- verdicts and measures -- */
/* `shrink` [m] (relative: a share, at most 1): kerns are shrunk by so much, and
   grown where it is negative. proof may be NULL. */

/* A structure under gravity (0, -9.81), kern_defaults(), nothing known. */
KERN_API kern_task kern_task_of(const kern_block *block, int blocks,
                                const kern_contact *contact, int contacts,
                                kern_work *work);

/* Two arrays to remember in (task.known), as long as the structure will be. */
KERN_API kern_known kern_known_of(kern_motion *motion, kern_force *force);

/* Whether the structure stands: KERN_STANDS, KERN_FALLS or KERN_UNDECIDED.
   Time: O(B + C) where forces can be passed on from the top down, as in most
   walls; else C and the entries of factors (>>lp), at most B^2, for a pivot. */
KERN_API kern_status kern_verdict(const kern_task *task, kern_real shrink,
                                  const kern_proof *proof);

/* The interval of the margin of a measured structure, from the error in its
   options, and the verdict that is certain: KERN_STANDS (low is above 0 and its
   forces are raised), KERN_FALLS (it falls with all that high allows), or
   KERN_OK: neither. `margin` is that of kern_measure(), 0 where it falls.
     low   Margin without doubtful contacts: of the blocks that carry a block
           only that with the widest bed, as gravity sees it, is kept; kerns are
           shorter by 3.5 e, friction angles less by 3 theta.
     high  Margin with every contact that may exist, found anew (given ones and
           friction of their own do not count): gaps and angles of twice the
           error, kerns longer by 3.5 e, friction angles more by 3 theta. Where
           it stands, at least `margin` + 3.5 e (relative: `margin`).
   A larger error never makes a fall certain, and lowers `low` for the same
   contacts. Errors are absolute in relative mode too. contact[0..room) receives
   the contacts for `high`; work memory is for `room` contact points.
   Below 0: what kern_contacts() or kern_measure() returns, KERN_BAD_OPTION also
   where the options are not those of kern_measured_options(). *out then means
   nothing, but with KERN_LIMIT, of the whole call, what is proven by then.
   Time: a search for contacts, two margins and kern_raised(). */
KERN_API kern_status kern_certain(const kern_task *task, kern_real margin,
                                  kern_interval *out, kern_contact *contact,
                                  int room);

/* Whether the load, put on contacts without stress, raises forces that hold the
   structure: blocks approach wherever a force acts, stick where there is
   friction to spare, else slide against it. Where the loads of all blocks at
   once show nothing, they grow from 0, as in kern_raised_load().
   KERN_STANDS: *out is written, and both arrays of the proof, which passes
   kern_check_raised() (KERN_NOT_SHOWN: forces alone). KERN_FALLS: the motion is
   that of kern_verdict(), *out as it was.
   *reserve (may be NULL) is the largest share of gravity, among 0, .001 ...
   .005, .0055, .006, .007, .008, .01, .015, .02, .03, .05 and .1, with which a
   push to either side, and kerns shrunk further by that share of the mean size
   (relative: by that share), leave it raised; 0 where it is not. No share above
   options.reserve is asked; KERN_BAD_OPTION: a reserve without gravity.
   KERN_NO_SPACE also where a structure is much wider than a wall of squares.
   Time: 3 margins in the mean of 969 walls; with the reserve 5. */
KERN_API kern_status kern_raised(const kern_task *task, kern_real shrink,
                                 kern_raising *out, kern_real *reserve,
                                 const kern_proof *proof);

/* The chance that block i, laid last, stays where it is let go, from statics: a
   law fitted to placements (>>measures), of what raises it where all that is
   more than four contacts away from it is held:
       .05 + .95 odds / (1 + odds),    odds = (5.5e7 r^3 / s)^2
       r = reserve, up to .01, + .004
       s = how far the block goes until forces are raised, at least 1, where the
           mean weight is 1 and the stiffness of a contact point .1 and its
           travel in mean sizes; a turn counts by half the size
   KERN_STANDS: *chance, from .05 to 1; 0 where something hangs. KERN_FALLS: as
   it was. KERN_BAD_BLOCK: no free block i; KERN_BAD_OPTION: no gravity. Time:
   that of 3 kern_plan_try() in the median, by a plan's known forces. */
KERN_API kern_status kern_stays(const kern_task *task, int i,
                                kern_real *chance);

/* The minimum-norm forces (>>measures): of all that hold the structure those of
   least sum of f^2 + (r / mu)^2 over the contact points. KERN_STANDS:
   force[0..contacts), checked like those of a proof. KERN_UNDECIDED: there are
   none, as kern_verdict() tells, or none so exact, as where jams are critical
   or sizes differ by 1e4. KERN_NO_SPACE as kern_raised(). Time: 1/3 margin. */
KERN_API kern_status kern_forces(const kern_task *task, kern_real shrink,
                                 kern_force *force);

/* Margin and level.
     KERN_STANDS    All of *out. proof->force holds the structure at out->holds,
                    with its kerns shrunk; proof->motion moves it at out->fails
                    (not written where the margin is saturated).
     KERN_FALLS     level, margin, holds, fails, saturated are 0; most, epsilon
                    are set; proof->motion says how it falls.
     KERN_LIMIT     level -1, saturated 0; margin and holds are the largest
                    shrinkage proven to stand, -1: none yet; fails the smallest
                    proven to fall, `most`: none; these and epsilon infinity
                    where the input was not read. The proof means nothing.
     KERN_UNDECIDED, KERN_BAD_STEP (most / epsilon > 1,000,000): *out is kept.
   How wide [holds, fails] is: >>limits. The level is proven with the margin
   where kerns are nested, else by a proof of each step.
   options.narrow = k: at shrinkage d > 0 friction mu is max(0, (mu - k d) / (1
   + mu k d)), the tangent of its angle less atan(k d), in every question about
   shrunk kerns. A robot that places stones within e and theta asks with k =
   tan(theta) / (2 e): margin / (2 e) is how many times its own error the
   structure bears; a measure, not a bound. Where k is so large that kerns
   hardly shrink, this mu at the margin is the least that it stands with.
   Warm start: from task->known, where the result is remembered; after
   KERN_UNDECIDED and KERN_LIMIT nothing is known any longer. */
KERN_API kern_status kern_measure(kern_task *task, kern_margin *out,
                                  const kern_proof *proof);

/* How the margin depends on every contact point and block, from the proof that
   kern_measure() wrote: contact[0..contacts) and block[0..blocks). It is the
   derivative where one mechanism alone is critical, contacts stay and no kern
   that carries is about to close; else that of the mechanism of the proof.
   Where corners of two blocks end a contact together, either is taken to move
   it. The travel of lone points (options.lone) is taken to stay as it is.
   KERN_OK, or KERN_UNDECIDED where the margin is saturated or does not move.
   With narrow 0. Time: O(B + C), 0.03 of that of the margin. */
KERN_API kern_status kern_sensitivity(const kern_task *task,
                                      const kern_margin *margin,
                                      const kern_proof *proof,
                                      kern_contact_rate *contact,
                                      kern_block_rate *block);

/* The deficit (>>rules) [m; relative: 1]. KERN_STANDS: it is 0. KERN_FALLS: it
   is written. KERN_LIMIT: how far kerns must grow at least, -1 where the
   structure is not proven to fall yet. */
KERN_API kern_status kern_deficit(const kern_task *task, kern_real *deficit);

/* The length [m] of the shortest contact that the structure needs: it stands on
   its contacts of at least this length alone, but not on the longer ones
   alone. A point of an interface of several counts with twice its travel; a
   lone point that stays is never left out. KERN_STANDS: *length, KERN_INFINITY
   where it needs no contact that has a length; proof->force holds the structure
   by those contacts, proof->motion moves it without the shortest of them (0
   where that is undecided: it counts as needed). KERN_FALLS: it falls with all
   contacts. Time: a verdict for each halving of the logarithms of lengths. */
KERN_API kern_status kern_bearing(const kern_task *task, kern_real *length,
                                  const kern_proof *proof);

/* The largest factor of a horizontal load to a side on top of weights and
   loads. KERN_STANDS: *factor, KERN_INFINITY where it stands at 1,000,000;
   proof as in kern_measure(), for the loads at the factor. KERN_FALLS: it
   falls at 0. KERN_BAD_OPTION: no gravity, or no side to the left or right. */
KERN_API kern_status kern_load_factor(const kern_task *task, kern_real shrink,
                                      kern_side side, kern_real *factor,
                                      const kern_proof *proof);

/* The same for pattern[0..blocks): a wrench about each free block's centre. */
KERN_API kern_status kern_load_factor_of(const kern_task *task,
                                         kern_real shrink,
                                         const kern_wrench *pattern,
                                         kern_real *factor,
                                         const kern_proof *proof);

/* The load factor of Coulomb friction, from rest: stones that slide need not
   part. *factor is the largest multiple of the load with forces that it raises,
   as in kern_raised(), proven while the load grows from 0, each step (>>tune)
   from those before. With friction equilibrium is not unique: another path of
   loading may collapse earlier (seen: 5 %) or later. It is never above the load
   factor, which is asked for first. The load is `pattern`, or where that is
   NULL horizontal to the side.
   KERN_STANDS: *factor, KERN_INFINITY where it is raised at 1,000,000; proof as
   kern_check_raised() takes it with the loads at the factor, both its arrays.
   KERN_FALLS: it falls at 0. KERN_UNDECIDED also where nothing shows that its
   own weight raises the forces; *factor stays. Time: 8 load factors in the
   median of settled stones, 13 on walls that slide (9.5 of 40 to 60 blocks). */
KERN_API kern_status kern_raised_load(const kern_task *task, kern_real shrink,
                                      kern_side side,
                                      const kern_wrench *pattern,
                                      kern_real *factor,
                                      const kern_proof *proof);

/* The first angle [rad] at which it falls when gravity turns toward a side.
   KERN_STANDS: *angle; proof and all else as in kern_load_factor(). */
KERN_API kern_status kern_tilt(const kern_task *task, kern_real shrink,
                               kern_side side, kern_real *angle,
                               const kern_proof *proof);

/* The profile (>>rules), in value[0..blocks): shrinkages [m] (KERN_SHRINK) or
   factors of a horizontal load to a side; of a fixed block KERN_INFINITY. Below
   0 *out is as it was, and value means nothing. KERN_BAD_OPTION: no such side,
   or a load and no gravity. KERN_UNDECIDED: a verdict it depends on is.
   KERN_LIMIT: value of the blocks that have been taken away is as it will be,
   of others -1. Time: 3 to 5 times that of the margin. */
KERN_API kern_status kern_profile(const kern_task *task, kern_side side,
                                  kern_real *value, kern_collapse *out);

/* What limits a measure, from its proof: proof->motion, not NULL, moves the
   structure at about `shrink`, proof->force holds it there or is NULL. After
   kern_measure(): out.margin and its proof; where it falls, 0 and the motion
   alone. A contact point limits by the power that the mechanism gains per
   length by which the point moves inward; without forces, or where none gains,
   by its turning, and where nothing turns, by its sliding. Slower than 1e-4
   (the fastest is 1) counts as rest. KERN_OK: out's arrays are filled, contact
   and groups are set. KERN_BAD_POINTER also for no motion, KERN_BAD_NUMBER for
   one that is not finite (the block). Time: O(C), and O(B) for each group. */
KERN_API kern_status kern_critical_of(const kern_task *task, kern_real shrink,
                                      const kern_proof *proof,
                                      kern_critical *out);

/* -- planning -- */
/* Structures that differ by a stone: no contact is searched twice, and
   kern_measure(&plan.task, ...) and the questions below go on from its last
   measure. Measure first: answers are the same without, but slower. Questions
   leave the plan as it is; below 0 they also return what kern_plan_add() does,
   and their proof is of the structure with the block: one motion more, and the
   forces of the block's contacts, which lie behind the plan's, last. */

/* An empty plan under gravity (0, -9.81): arrays for so many blocks and contact
   points, kern_known_of() arrays as long, and work memory for so many. */
KERN_API kern_plan kern_plan_of(kern_block *block, int blocks,
                                kern_contact *contact, int contacts,
                                kern_known known, kern_work *work);

/* Adds a block behind the others and finds its contacts. Returns how many
   contact points it has, or what kern_touch() does below 0, KERN_NO_SPACE also
   without room for it, KERN_BAD_POINTER also without known forces or motions;
   the plan is then as it was. The block is copied, its vertices are NOT: they
   must outlive the plan. Options, friction too, count as of now. Time: O(B). */
KERN_API int kern_plan_add(kern_plan *plan, const kern_block *block);

/* Takes block i away; those behind it move up, in contacts too. KERN_OK: done.
   KERN_BAD_BLOCK: there is none. Time: O(B + C). */
KERN_API kern_status kern_plan_remove(kern_plan *plan, int i);

/* What kern_measure() would say with the block added. Time: that of one
   verdict, where the block does not change which stones are the weakest. */
KERN_API kern_status kern_plan_try(kern_plan *plan, const kern_block *block,
                                   kern_margin *out, const kern_proof *proof);

/* Whether the margin with the block added is at least `margin` [m] (relative: a
   share): KERN_STANDS with forces at that shrinkage, KERN_FALLS with a motion.
   What stands with every kern closed bears any margin, unless options.narrow is
   set. Where kerns are not nested it falls, too, with the motion at the margin
   of kern_plan_try(), if that is smaller.
   KERN_BAD_NUMBER also for a margin below 0. Time: that of a verdict; O(B + C)
   beyond the measured margin where it does not touch what limits that. */
KERN_API kern_status kern_plan_bears(kern_plan *plan, const kern_block *block,
                                     kern_real margin, const kern_proof *proof);

/* kern_stays() and kern_raised() with a block added; for NULL of the plan as it
   is, and of its last block. */
KERN_API kern_status kern_plan_stays(kern_plan *plan, const kern_block *block,
                                     kern_real *chance);
KERN_API kern_status kern_plan_raised(kern_plan *plan, const kern_block *block,
                                      kern_raising *out, kern_real *reserve,
                                      const kern_proof *proof);

/* Copies a plan into `to`, which kern_plan_of() made with arrays and work
   memory of its own: one plan for each thread. Vertices are not copied; both
   plans read the same. KERN_OK: answers of the two are the same, to the last
   bit. KERN_NO_SPACE: an array of `to` is too short, and `to` is as it was. */
KERN_API kern_status kern_plan_copy(kern_plan *to, const kern_plan *from);

/* Finds where a stone comes to rest on a structure, such as plan.task, when it
   is let down with its centre at x and turned by an angle of at most 64 rad. x
   is measured along gravity turned by +90 degrees, which is the x of the plane
   for gravity (0, -9.81).
   The stone goes down without turning to the first touch. Then it turns about
   the support nearest to its centre, as its weight turns it, and slides down an
   edge that is steeper than options.mu holds, until forces at two touches
   balance its weight. Blocks of the structure stay. Each motion ends where the
   stone meets a block, so it overlaps none by more than 1e-6 of its size. A
   mirrored stone and structure have the mirrored pose, except where the centre
   is exactly above a point that does not hold it.
   vertex[0..stone->vertices) receives the vertices there, in their order; it is
   another array than the stone's own. The structure's contacts are not read.
   KERN_OK: *out is written; below 0 it means nothing. KERN_NO_SUPPORT: the stone falls past the
   structure. KERN_NO_REST: it still moves after 48 motions. KERN_BAD_OPTION: no
   gravity; KERN_BAD_BLOCK: a fixed stone; KERN_NO_BLOCK, KERN_FEW_VERTICES,
   KERN_STALE: a stone that kern_block_init() refused, has no polygon or has
   moved; KERN_BAD_NUMBER also for x and turn. A bad stone is block B in the
   fault. Time: O(B) for each motion, and the edges near it. */
KERN_API kern_status kern_rest(const kern_task *task, const kern_block *stone,
                               kern_real x, kern_real turn, kern_vec *vertex,
                               kern_pose *out);

/* Compares two places for a stone: above 0 if a is better, below 0 if b is, 0
   if no number differs. `alone` is the margin of the structure without the
   stone: most places leave that as it is, and then its margin tells nothing
   about them. The first of these that differs decides:
       stays   from 0.9 on all are one class; below, the larger chance
       margin  the larger; within 1e-5 of `alone` all are one class
       own     the larger
       load    the larger
       x turn  the smaller, so that any order of places gives the same best
   On 77 states of walls in a simulator with places of which some stay and some
   move, the stone stays in the place of the largest margin in 0.78 and 0.68 of
   two halves; of those with a chance of at least 0.9, in 0.91 and 0.90. */
KERN_API int kern_place_compare(const kern_place *a, const kern_place *b,
                                kern_real alone);

/* -- proofs -- */

/* The error of a proof as a share of what is allowed: up to 1 it holds.
   KERN_INFINITY where it proves nothing, and for bad input: NULL, what is not a
   number. Allowed is: for forces, 1e-9 (float: 1e-4) of what acts on a block in
   each of its equations, and roundings of the largest force there, in sum 1e6
   (1e3) weights; for a motion, that such forces could not stop it, whatever
   rounding does. Time: O(B + C). Work memory: for forces 4 B reals. */
KERN_API kern_real kern_check_forces(const kern_task *task, kern_real shrink,
                                     const kern_force *force);
KERN_API kern_real kern_check_motion(const kern_task *task, kern_real shrink,
                                     const kern_motion *motion);

/* The same for what kern_raised() found. Raised: besides the forces, that the
   motion approaches at every force which equilibrium would miss, and slides by
   less than 1/500 (float: 1/5) of that where it must not. Hanging: that the
   motion moves blocks without a load, that no contact with another presses one
   of them against gravity, and that the forces hold the others without them.
   KERN_NOT_SHOWN proves nothing. Work memory: 5 B reals. */
KERN_API kern_real kern_check_raised(const kern_task *task, kern_real shrink,
                                     kern_raising raising,
                                     const kern_proof *proof);

/* -- the linear program alone -- */

/* Solves a small dense program. x has cols, y rows numbers.
     KERN_LP_OPTIMAL     x is a solution, of least cost if there are costs, and
                         then y are its prices: cost - y.A >= 0, 0 where x > 0
     KERN_LP_INFEASIBLE  no x exists: y.A >= 0 and y.rhs < 0
     KERN_LP_UNBOUNDED   the cost falls along x: A x = 0, x >= 0, cost.x < 0
     KERN_UNDECIDED      the method does not end, or the check failed, as it may
                         where units differ by more than 1e4
     KERN_LIMIT          lp->limit was reached
   Each is checked against A, every row and column by its own terms, so that
   units do not matter. Below 0 x and y mean nothing. Work memory: KERN_LP_REALS
   and _INTS(rows, cols). Time: rows^2 + rows cols for a pivot. */
KERN_API kern_status kern_lp_solve(const kern_lp *lp, kern_real *x,
                                   kern_real *y, kern_work *work);

#ifdef __cplusplus
}
#endif
#endif /* KERN_H */

/* Stop here if you only want to use the library. Below is how it works.      */

/* ==== Part III: Statics and proofs ================================= >>impl */

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

#if defined(__FINITE_MATH_ONLY__) && __FINITE_MATH_ONLY__ == 1
#error "kern.h: do not compile the implementation with -ffast-math"
#endif

/* The vectorisers of gcc make one fused operation of pairs of products such as
   a c - b d, a d + b c, also with -ffp-contract=off. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__FMA__)
#pragma GCC push_options
#pragma GCC optimize("no-tree-vectorize")
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* Conditions that hold whatever the caller hands in, and what looks at the
   state of an engine (tests/audit.h); off, unless a test build defines them. */
#ifndef KERN_ASSERT
#define KERN_ASSERT(condition) ((void)0)
#endif
#ifndef KERN_AUDIT
#define KERN_AUDIT(engine, state) ((void)0)
#endif

#define KERN_R(x) ((kern_real)(x))
#ifdef KERN_SINGLE
#define KERN_EPS FLT_EPSILON
#define KERN_PICK(in_double, in_float) KERN_R(in_float)
#else
#define KERN_EPS DBL_EPSILON
#define KERN_PICK(in_double, in_float) KERN_R(in_double)
#endif

#define KERN_OUT (-1)

/* Inlined, these take more room in firmware, by their callers or registers. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define KERN_SHARED __attribute__((noinline))
#else
#define KERN_SHARED
#endif

/* ---- Constants -------------------------------------------------- >>tune */
/* All of Parts III and IV; those of the geometry are in >>tol. Lengths are in
   units of a block's size, forces in units of the weight of all, so where no
   unit is given there is none. KERN_PICK: in double, in float. */

/* ---- what a proof allows ---- */

/* Residual that a proof may leave, as a share of what acts on the block. */
#define KERN_TOL KERN_PICK(1e-9, 1e-4)
/* Largest forces that are taken for real, in weights: the bound excludes jams,
   whose forces are arbitrarily large; a motion may close no contact faster than
   its power divided by it. A larger gap leaves the interior point no digits. */
#define KERN_BOUND KERN_PICK(1e6, 1e3)
/* What is no more than rounding in the result of a method, a tenth of KERN_TOL:
   a variable below zero, as a share of the largest, a pivot or a gain, and what
   >>ipm adds to a diagonal without pivots; and the difference of two critical
   values, in mean block sizes. Less, and simplex and search chase rounding. */
#define KERN_NOISE KERN_PICK(1e-10, 1e-5)
/* What a row of a proof may lose by rounding, as a share of its terms; by how
   much a certificate is lifted off the columns that it touches, since the check
   of a motion adds as much; and what is added to the diagonal of the matrix of
   >>norm, as a share of its mean: without it what no ray presses has no pivot.
   Within twice as much of the largest coordinate places are the same, or cubes
   that were turned would not touch; and a normal has the length 1. */
#define KERN_ROUNDING (32 * KERN_EPS)
/* The most that a proof of >>raised takes for sticking, in approaches. */
#define KERN_STICKS KERN_PICK(2e-3, 0.2)

/* ---- what may be asked ---- */

/* Largest coordinate and option [m], mass [kg] and sum of all that acts on a
   block [N]. Inverse, it is the least size, mass and sum of a block; its
   inverse square is the least area [m^2] and power of a motion [W]. Squares,
   moments and products with KERN_BOUND of these keep all digits. */
#define KERN_FAR KERN_PICK(1e60, 1e10)
/* Turn [rad] below which a vertex is no corner, and within which of a half turn
   it is a spike: much larger, and round stones would lose their shape. And
   share of the size by which a foot must lie inside its edge, so that rounding
   makes no contacts between diagonal neighbours; of the shortest line, below
   which a travel is none. And slope along which blocks are at one height. */
#define KERN_SLIGHT KERN_R(1e-6)
/* Share of the size: the default gap, the length of the shortest line, and how
   far off a corner ends a contact; of an area, by how much it may differ, by
   rounding at large coordinates, from what the block says. */
#define KERN_GAP KERN_R(1e-3)
/* Angle [rad] from which an option for the angle is refused: it would take a
   corner for a face, and the series of kern_sine() would lose digits. */
#define KERN_ANGLE_MOST KERN_R(0.5)
/* Counts whose work memory, and products in it, are still an int. */
/* Blocks of a task; rows of a program. */
#define KERN_BLOCKS_MOST 20000
/* Contact points, vertices, levels, blocks of a search; columns. */
#define KERN_POINTS_MOST 1000000
/* Units of a call; entries of a matrix. */
#define KERN_WORK_MOST 2000000000
/* Entries of sparse columns that a unit of work adds up (of a dense factor 8/3
   as many): 650 to 2,000 instructions, as >>verdicts says. */
#define KERN_UNIT 64

/* ---- measures ---- */

/* Width of the bracket of a measure, half of it before the critical value [mean
   block size; load factor; tangent of a quarter of the angle]; up to all of it
   may lie beyond. Narrower, fewer verdicts near critical have a proof; wider,
   the bracket is no longer within the 2e-6 that are promised. */
#define KERN_WIDTH KERN_PICK(1.26e-6, 1.8e-3)
/* How many times wider it may get near what has no proof; wider: undecided. */
#define KERN_WIDEST KERN_R(20)
/* Groups up to which one linear program is solved: margins are then exact.
   More, and its factor costs more than the interior point. */
#define KERN_SMALL 64
/* Steps to the largest travel where kerns are not nested, and of half a circle
   of tilt under loads that stay: a range that falls, and is narrower than one,
   may be missed. A walk, or a climb, takes at most five times as many steps. */
#define KERN_SCAN 1001
/* Largest load factor; beyond, the load counts as held for ever. */
#define KERN_FACTOR_MOST KERN_R(1e6)

/* Rounds of what ends in far fewer, unless digits are lost: Newton's method for
   minimum-norm forces, a bracket (four to eight suffice), the interior point
   (some ten), prices of contacts along a load. */
#define KERN_ROUNDS 100
/* Rounds of what ends in fewer, as a rule: Newton's method for one group and
   from bend to bend; parts that fall before the whole is asked; steps of a
   collapse that take nothing away. */
#define KERN_FEW_ROUNDS 8

/* ---- profile, mechanism ---- */

/* Load factor that counts as no limit. */
#define KERN_PROFILE_MOST KERN_R(10)
/* Expected drop: the load factor at which a stone's chance to fall is 1/e (0.05
   to 0.1 rank as well), and the least height that counts [mean block size]. */
#define KERN_DROP_LOAD KERN_R(0.07)
#define KERN_DROP_HEIGHT KERN_R(0.3)
/* Share of the highest speed below which blocks rest, or do not approach. */
#define KERN_REST KERN_R(1e-4)

/* ---- minimum-norm forces, top-down pass ---- */

/* Residual of equilibrium that a method leaves, of a group as a share of its
   load. A proof allows far more, and so residuals of many groups may add up. At
   1e-10 in double a light stone beside heavy ones stands that falls. Where a
   basis leaves more it is made anew. */
#define KERN_PASS_TOL KERN_PICK(1e-11, 1e-6)
/* Pivot of a 3 x 3 matrix, as a share of its trace, that counts as rounding: at
   1e-11 in double a profile of rubble begins beyond the margin. */
#define KERN_THREE_TOL KERN_PICK(1e-12, 1e-5)
/* Pivot that costs no digits: of a 3 x 3 matrix, as a share of its trace (more,
   and the solution needs no refinement); of a column in a basis, as a share of
   its largest entry, and determinant of three columns (less: dependent). */
#define KERN_PIVOT KERN_PICK(1e-4, 1e-2)
/* Norm of the forces, in loads of a cluster, beyond which it counts as
   infeasible. Larger, clusters grow later and Newton's method takes more
   steps: without the bound trying a stone costs 4 % more. And slide of a stone
   that falls into a jam, in approaches. */
#define KERN_NORM_MOST KERN_R(100)
/* Contacts of one group; columns of it that are tried for the crash basis. */
#define KERN_ROWS_MOST 12
/* Groups of a cluster: a quarter of all in a verdict, a fifth in a search, a
   seventh in one that knows forces. With a fifth verdicts take 7 % more, with a
   quarter measures 6 %, and tries from known forces 6 % with a fifth. Of more
   than KERN_SMALL so many, and two more for each KERN_SMALL: with fewer some
   measures of 100 blocks take four times the work. */
#define KERN_CLUSTER 4
#define KERN_CLUSTER_MOST 20
/* Units of work of a pass for each group and contact. With 30 measures of
   bricks take 1.4 times as long. */
#define KERN_PASS_UNITS 9

/* ---- search ---- */

/* First step of a search [mean size; load factor, tangent of a quarter of the
   angle], by the corpus' odd half and by walls of 100 to 200 blocks. */
#define KERN_CLIMB KERN_R(0.1)
#define KERN_CLIMB_PUSH KERN_R(0.5)
/* Parts of a bracket, unpredicted; of Newton's steps Halley's, at most. */
#define KERN_NEAR KERN_R(4)
/* A step, in the one before. */
#define KERN_CLIMB_GROWS KERN_R(1.5)

/* ---- interior point ---- */

/* A little: what a step leaves of the way to x, z = 0, less as the gap closes;
   what x and z are lifted by to begin, in their largest, and may shrink to when
   forces are balanced; least gap, and s below 0, with which a query begins. */
#define KERN_IPM_LITTLE KERN_R(1e-3)
/* Least x z, in means, and share of a gap that a step is to leave: with
   less, less is decided. */
#define KERN_IPM_APART KERN_R(0.03)
/* What its gap shrinks to in a step at least, in the mean, or it begins anew:
   without that some walls take three times the work. */
#define KERN_IPM_PACE KERN_R(0.95)

/* ---- simplex method ---- */

/* Loads that a crash column may pull. */
#define KERN_CRASH_PULL KERN_R(2)
/* Least pivot of a column in its own group, where its entries are about 1. Less
   makes the inverse grow from course to course, more fills it: at 0.01 a call
   may take more than 2,000 instructions for a unit of its limit. */
#define KERN_OWN_TOL KERN_R(0.03)

/* ---- raised ---- */

/* Rounds of prices from nothing or along a load; from those of a smaller push,
   or near a block, half as many, near it from a smaller push a sixth. More show
   more that moves, fewer less that stays. */
#define KERN_RAISE_ROUNDS 21
/* Steps of a load up to the load factor; where one fails, a fifth of it, and of
   that: with halves, to as little, loads take 1.4 times as long. */
#define KERN_LOAD_STEPS 8
/* Share of a price's fall in a round. */
#define KERN_LOAD_FALL KERN_R(0.3)
/* kern_stays(): from block to block, how many contacts away from the stone what
   is not held may be: with 3 and 5 it tells less. No proof is asked for,
   so that contacts may be less stiff along t. */
#define KERN_STAYS_NEAR 4
#define KERN_STAYS_STIFF KERN_R(4)
/* Its law, fitted to placements: the largest reserve that it asks for, since
   more says no more; what is added to it; and its scale. */
#define KERN_STAYS_MOST KERN_R(0.01)
#define KERN_STAYS_ADD KERN_R(0.004)
#define KERN_STAYS_ODDS KERN_R(5.5e7)

/* ---- Vectors ------------------------------------------------------ >>vec */

/* Without its sign, also of -0; compilers do not find the one instruction. */
static kern_real kern_abs(kern_real a)
{
#ifdef __GNUC__
    return KERN_PICK(__builtin_fabs(a), __builtin_fabsf(a));
#else
    return a > 0 ? a : 0 - a;
#endif
}

KERN_SHARED static kern_real kern_max(kern_real a, kern_real b)
{
    return a > b ? a : b;
}

KERN_SHARED static kern_real kern_min(kern_real a, kern_real b)
{
    return a < b ? a : b;
}

/* Where it is not, a - a is not a number. */
KERN_SHARED static int kern_is_finite(kern_real a) { return a - a <= 0; }

static kern_vec kern_vec_make(kern_real x, kern_real y)
{
    const kern_vec v = {x, y};
    return v;
}

static kern_vec kern_vec_add(kern_vec a, kern_vec b)
{
    return kern_vec_make(a.x + b.x, a.y + b.y);
}

static kern_vec kern_vec_sub(kern_vec a, kern_vec b)
{
    return kern_vec_make(a.x - b.x, a.y - b.y);
}

static kern_vec kern_vec_scale(kern_vec a, kern_real s)
{
    return kern_vec_make(a.x * s, a.y * s);
}

/* a + s b */
static kern_vec kern_vec_step(kern_vec a, kern_real s, kern_vec b)
{
    return kern_vec_make(a.x + s * b.x, a.y + s * b.y);
}

static kern_real kern_vec_dot(kern_vec a, kern_vec b)
{
    return a.x * b.x + a.y * b.y;
}

static kern_real kern_vec_cross(kern_vec a, kern_vec b)
{
    return a.x * b.y - a.y * b.x;
}

/* a turned by +90 degrees */
static kern_vec kern_vec_turn(kern_vec a) { return kern_vec_make(-a.y, a.x); }

static kern_real kern_vec_length(kern_vec a)
{
    return KERN_SQRT(kern_vec_dot(a, a));
}

static kern_vec kern_vec_unit(kern_vec a)
{
    return kern_vec_scale(a, 1 / kern_vec_length(a));
}

static kern_vec kern_vec_mid(kern_vec a, kern_vec b)
{
    return kern_vec_step(a, KERN_R(0.5), kern_vec_sub(b, a));
}

/* The larger coordinate, without its sign. */
static kern_real kern_vec_largest(kern_vec a)
{
    return kern_max(kern_abs(a.x), kern_abs(a.y));
}

/* Numbers, and none too large to reckon with? */
static int kern_vec_is_moderate(kern_vec a)
{
    return kern_abs(a.x) + kern_abs(a.y) <= KERN_FAR;
}

/* The sine by its series: the last digit of libm's differs between machines;
   angles below KERN_ANGLE_MOST are right to eight digits. */
static kern_real kern_sine(kern_real angle)
{
    const kern_real q = angle * angle;
    return angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42)));
}

/* Keeps of the interval [*low, *high] those s for which at + s slope lies from
   least to most. An empty interval has *low > *high. */
static void kern_clip(kern_real *low, kern_real *high, kern_real at,
                      kern_real slope, kern_real least, kern_real most)
{
    if (slope > 0 || slope < 0) {
        const kern_real a = (least - at) / slope, b = (most - at) / slope;
        *low = kern_max(*low, kern_min(a, b));
        *high = kern_min(*high, kern_max(a, b));
    } else if (at < least || at > most) {
        *low = 1;
        *high = 0;
    }
}

/* Velocity of a point of a body, at an arm from its centre. */
static inline kern_vec kern_velocity(const kern_motion *v, kern_vec arm)
{
    return kern_vec_make(v->vx - v->spin * arm.y, v->vy + v->spin * arm.x);
}

static kern_real kern_block_size(const kern_block *block)
{
    return KERN_SQRT(kern_abs(block->area));
}

/* Sum of magnitudes, or of a motion's: 0 only for none, finite for finite. */
static kern_real kern_wrench_sum(const void *w)
{
    const kern_real *of = (const kern_real *)w;
    return kern_abs(of[0]) + kern_abs(of[1]) + kern_abs(of[2]);
}

/* v := s v, n numbers, also those of structs of numbers */
static void kern_scale(void *v, int n, kern_real s)
{
    kern_real *to = (kern_real *)v;
    for (; n > 0; n--)
        *to++ *= s;
}

/* v := 0 */
static void kern_zero(void *v, int n)
{
    kern_real *to = (kern_real *)v;
    for (; n > 0; n--)
        *to++ = KERN_R(0);
}

/* v := w */
static void kern_copy(void *v, const void *w, int n)
{
    kern_real *to = (kern_real *)v;
    const kern_real *from = (const kern_real *)w;
    for (; n > 0; n--)
        *to++ = *from++;
}

/* v += s w */
static void kern_add(void *v, kern_real s, const void *w, int n)
{
    kern_real *to = (kern_real *)v;
    const kern_real *from = (const kern_real *)w;
    for (; n > 0; n--)
        *to++ += s * *from++;
}

static kern_real kern_largest(const kern_real *v, int n)
{
    kern_real size = KERN_R(0);
    int i;
    for (i = 0; i < n; i++)
        if (!(size > kern_abs(v[i]))) /* in place: a third of all */
            size = kern_abs(v[i]);
    return size;
}

/* sum of a[i] b[i] */
static kern_real kern_dot(const kern_real *a, const kern_real *b, int n)
{
    kern_real s0 = KERN_R(0), s1 = s0, s2 = s0, s3 = s0;
    int i;
    for (i = 0; i + 4 <= n; i += 4) {
        s0 += a[i] * b[i];
        s1 += a[i + 1] * b[i + 1];
        s2 += a[i + 2] * b[i + 2];
        s3 += a[i + 3] * b[i + 3];
    }
    for (; i < n; i++)
        s0 += a[i] * b[i];
    return s0 + s1 + (s2 + s3);
}

static inline kern_real kern_three(const kern_real *a, const kern_real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static void kern_box_add(kern_box *box, kern_vec p)
{
    box->low.x = kern_min(box->low.x, p.x);
    box->low.y = kern_min(box->low.y, p.y);
    box->high.x = kern_max(box->high.x, p.x);
    box->high.y = kern_max(box->high.y, p.y);
}

/* ---- Statics -------------------------------------------------- >>statics */
/* Eq. (5) of >>method, which kern_part_set() writes:

       \   n   /         f n + r t = x1 (n + mu t) + x2 (n - mu t),
        \  |  /              x1, x2 >= 0
         \ | /
       ---- p ----  t

   A has three rows a free block (force, torque about its centre), two columns a
   contact point. Units are the size of the block and the weight of all. */

/* A query: the weights and loads to carry, and how far kerns shrink. */
typedef struct kern_query {
    kern_real shrink;
    int relative;     /* nonzero: a share of each travel            */
    kern_real narrow; /* rate at which cones narrow                 */
    kern_real mean;   /* size of the free blocks                    */
    kern_vec gravity;
    const kern_wrench *pattern; /* NULL: side * m |g| horizontally            */
    kern_real factor;           /* of the pattern                             */
    kern_real loads;            /* share of the blocks' loads                 */
    int side;
    const kern_real *fallen; /* of a block, >= 0: it is gone; NULL: none   */
    kern_real shortest;      /* a shorter contact carries nothing [m]      */
} kern_query;

/* The tangent by which cones of friction are narrower. */
static kern_real kern_reduction(const kern_query *q)
{
    return kern_max(q->narrow * q->shrink, KERN_R(0));
}

/* Friction of a contact whose cone is narrower by the angle of that tangent. */
static inline kern_real kern_friction(const kern_contact *c, kern_real by)
{
    return by > 0 ? kern_max(c->mu - by, KERN_R(0)) / (1 + c->mu * by) : c->mu;
}

/* Whether a block has been taken away. */
static inline int kern_is_gone(const kern_query *q, int i)
{
    return q->fallen && q->fallen[i] >= 0;
}

/* A travel too short to be one counts as none: slight beside the least line. */
KERN_SHARED static kern_real kern_travel(const kern_contact *c, kern_real mean)
{
    return kern_abs(c->travel) < KERN_SLIGHT * KERN_GAP * mean ? 0 : c->travel;
}

/* Length of its line, or about that of its points; 0: it is a lone point. */
static kern_real kern_contact_length(const kern_contact *c, kern_real mean)
{
    return 2 * kern_abs(kern_travel(c, mean));
}

/* Whether a contact carries nothing: too short, or one of its blocks gone. */
static inline int kern_is_out(const kern_query *q, const kern_contact *c)
{
    const kern_real len = q->shortest > 0 ? kern_contact_length(c, q->mean) : 0;
    return (len > 0 && len < q->shortest) || kern_is_gone(q, c->a)
        || kern_is_gone(q, c->b);
}

/* What gravity does to a mass. */
static void kern_weigh(kern_vec gravity, kern_real mass, kern_wrench *w)
{
    w->fx = gravity.x * mass;
    w->fy = gravity.y * mass;
    w->torque = KERN_R(0);
}

/* The load pattern's share of block i, for a factor of 1. */
static void kern_pattern_on(const kern_structure *s, const kern_query *q, int i,
                            kern_wrench *w)
{
    if (q->pattern)
        *w = q->pattern[i];
    else
        kern_weigh(kern_vec_turn(q->gravity),
                   s->block[i].mass * KERN_R(q->side), w);
}

/* Magnitude of the force. Not 0 where only its squares underflow. */
static kern_real kern_force_size(const kern_wrench *w)
{
    const kern_vec f = kern_vec_make(w->fx, w->fy);
    return kern_max(kern_vec_length(f), kern_vec_largest(f));
}

/* Adds a share of what acts on block b; returns its magnitude. */
static kern_real kern_wrench_add(kern_wrench *sum, const kern_block *b,
                                 const kern_wrench *w, kern_real share)
{
    if (!(kern_wrench_sum(w) > 0))
        return KERN_R(0);
    kern_add(sum, share, w, 3);
    return share
         * (kern_force_size(w) + kern_abs(w->torque) / kern_block_size(b));
}

/* All that acts on block i besides its contacts. Returns the sum of the
   magnitudes: what its equilibrium is measured by. */
static inline kern_real kern_wrench_on(const kern_structure *s,
                                       const kern_query *q, int i,
                                       kern_wrench *sum)
{
    const kern_block *b = s->block + i;
    kern_wrench pattern;
    kern_real size;
    kern_weigh(q->gravity, b->mass, sum);
    size = kern_force_size(sum) + kern_wrench_add(sum, b, &b->load, q->loads);
    if (!(q->factor > 0))
        return size;
    kern_pattern_on(s, q, i, &pattern);
    return size + kern_wrench_add(sum, b, &pattern, q->factor);
}

/* How far along t a contact point moves with a shrinkage, and how fast. */
static kern_real kern_shift(kern_real travel, kern_real shrink, int relative,
                            kern_real *rate)
{
    const kern_real sign = travel > 0 ? KERN_R(1)
                         : travel < 0 ? KERN_R(-1)
                                      : KERN_R(0);
    const int closed = !relative && shrink >= kern_abs(travel);
    *rate = relative ? travel : closed ? KERN_R(0) : sign;
    return relative ? kern_min(shrink, KERN_R(1)) * travel
         : closed   ? travel
                    : shrink * sign;
}

KERN_API kern_vec kern_contact_at(const kern_contact *c, kern_real shrink,
                                  int relative)
{
    kern_real rate, shift;
    if (!c)
        return kern_vec_make(0, 0);
    shift = kern_shift(c->travel, shrink, relative, &rate);
    return kern_vec_step(c->p, shift, kern_vec_turn(c->n));
}

/* From the centres of its blocks, a and b, to where contact c acts. The centre
   is taken off first, since far from the origin a place has fewer digits than
   an arm. Returns how far along t it moved. A tenth of the time goes here. */
static inline kern_real kern_arms(const kern_structure *s,
                                  const kern_contact *c, const kern_query *q,
                                  kern_vec arm[2])
{
    kern_real rate;
    const kern_real shift = kern_shift(kern_travel(c, q->mean), q->shrink,
                                       q->relative, &rate);
    const kern_vec way = kern_vec_scale(kern_vec_turn(c->n), shift);
    arm[0] = kern_vec_add(kern_vec_sub(c->p, s->block[c->a].centre), way);
    arm[1] = kern_vec_add(kern_vec_sub(c->p, s->block[c->b].centre), way);
    return shift;
}

/* Velocity of block b relative to block a where contact point c acts. */
static kern_vec kern_meeting_motion(const kern_structure *s,
                                    const kern_query *q, const kern_contact *c,
                                    const kern_motion *motion)
{
    kern_vec arm[2];
    kern_arms(s, c, q, arm);
    return kern_vec_sub(kern_velocity(motion + c->b, arm[1]),
                        kern_velocity(motion + c->a, arm[0]));
}

/* Do contact points i and i + 1 end one line? */
static int kern_line_begins(const kern_contact *contact, int contacts, int i)
{
    const kern_contact *c = contact + i;
    return i + 1 < contacts && c->line && c[1].line && c->a == c[1].a
        && c->b == c[1].b;
}

/* Are they between the same blocks? */
static int kern_same_blocks(const kern_contact *c, const kern_contact *d)
{
    return (c->a == d->a && c->b == d->b) || (c->a == d->b && c->b == d->a);
}

/* And is d a point? */
KERN_SHARED static int kern_same_interface(const kern_contact *c,
                                           const kern_contact *d)
{
    return !d->line && kern_same_blocks(c, d);
}

/* ---- Work arrays ------------------------------------------------- >>work */
/* What is left of the work memory. Slices are handed out one after the other.
   Below 0 are left where one did not fit: it and what follows mean nothing. */

typedef struct kern_take {
    kern_real *real;
    int *index;
    int reals, indices;
} kern_take;

KERN_SHARED static void kern_take_open(kern_take *take, const kern_work *work)
{
    const kern_take all = {work->real, work->index, work->reals, work->indices};
    *take = all;
}

static kern_real *kern_take_reals(kern_take *take, int n)
{
    kern_real *const at = take->real;
    take->real += n <= take->reals ? n : 0;
    take->reals = n <= take->reals ? take->reals - n : KERN_OUT;
    return at;
}

static int *kern_take_ints(kern_take *take, int n)
{
    int *const at = take->index;
    take->index += n <= take->indices ? n : 0;
    take->indices = n <= take->indices ? take->indices - n : KERN_OUT;
    return at;
}

/* The last n numbers of what is left. */
static kern_real *kern_take_last(kern_take *take, int n)
{
    take->reals -= n;
    return take->real + take->reals;
}

static int kern_take_fits(const kern_take *take)
{
    return take->reals >= 0 && take->indices >= 0;
}

/* ---- what a call may spend ---- */

static int kern_limit_of(int limit)
{
    return limit > 0 ? limit : KERN_WORK_MOST;
}

KERN_SHARED static void kern_fault_clear(kern_fault *fault)
{
    fault->block = fault->other = fault->index = -1;
    fault->value = fault->allowed = KERN_R(0);
}

static void kern_work_begin(kern_work *work)
{
    kern_fault_clear(&work->fault);
    work->units = 0;
}

/* Counts work that is about to be done. Returns 0 where the call has no more
   of it left: this and all further work is refused, and the call ends. */
static int kern_spend(kern_work *work, int limit, int units)
{
    const int left = kern_limit_of(limit) - work->units;
    work->units += units <= left ? units : left + 1;
    return units <= left;
}

/* What a call returns: KERN_LIMIT where work was refused on the way. */
static kern_status kern_ended(const kern_task *task, kern_status status)
{
    return task->work->units > kern_limit_of(task->options.limit) ? KERN_LIMIT
                                                                  : status;
}

/* ---- What is handed in ------------------------------------------ >>check */
/* All that the statics reads is looked at once, before any memory is used:
   numbers are within bounds, indices exist, normals have length 1. */

static kern_status kern_options_check(const kern_options *o)
{
    if (!(kern_abs(o->mu + o->gap + o->angle + o->epsilon + o->overlap
                   + o->pose_error + o->pose_turn + o->narrow + o->reserve)
          <= KERN_FAR)
        || !kern_vec_is_moderate(o->lone))
        return KERN_BAD_NUMBER;
    if (o->mu < 0)
        return KERN_BAD_FRICTION;
    if (o->gap < 0 || !(o->angle > 0) || !(o->angle < KERN_ANGLE_MOST)
        || o->overlap < 0 || o->pose_error < 0 || o->pose_turn < 0
        || o->narrow < 0 || o->reserve < 0 || o->reserve > KERN_R(0.1)
        || o->epsilon < 0 || o->limit < 0 || o->limit > KERN_WORK_MOST)
        return KERN_BAD_OPTION;
    return KERN_OK;
}

/* A contact whose normal may have any length. */
static inline kern_status kern_contact_check(const kern_contact *c, int blocks)
{
    if ((unsigned)c->a >= (unsigned)blocks
        || (unsigned)c->b >= (unsigned)blocks)
        return KERN_BAD_BLOCK;
    if (c->a == c->b)
        return KERN_SAME_BLOCK;
    if (!kern_vec_is_moderate(c->p)
        || !(kern_abs(c->travel) <= KERN_FAR)
        /* 0 times what is not finite is not a number */
        || !kern_is_finite(0 * c->n.x + 0 * c->n.y + 0 * c->mu))
        return KERN_BAD_NUMBER;
    return c->mu < 0 ? KERN_BAD_FRICTION : KERN_OK;
}

/* A block; *loaded becomes nonzero where it is free and something acts. */
static kern_status kern_block_check(const kern_block *b, kern_vec gravity,
                                    int *loaded)
{
    const kern_real size = kern_block_size(b);
    const kern_real acts = kern_abs(b->load.fx) + kern_abs(b->load.fy)
                         + kern_abs(b->load.torque) / size
                         + b->mass
                               * (kern_abs(gravity.x) + kern_abs(gravity.y));
    if (b->vertices < 0)
        return KERN_NO_BLOCK;
    if (!kern_vec_is_moderate(b->centre) || !(size <= KERN_FAR))
        return KERN_BAD_NUMBER;
    if (b->fixed)
        return KERN_OK;
    if (!(size >= 1 / KERN_FAR))
        return KERN_NO_AREA;
    if (!(b->mass >= 1 / KERN_FAR) || b->mass > KERN_FAR)
        return kern_is_finite(b->mass) ? KERN_BAD_MASS : KERN_BAD_NUMBER;
    *loaded |= acts > 0;
    return acts <= KERN_FAR && (acts >= 1 / KERN_FAR || !(acts > 0))
             ? KERN_OK
             : KERN_BAD_NUMBER;
}

/* Checks what the arrays of a structure hold. */
static kern_status kern_structure_check(const kern_structure *s,
                                        kern_fault *fault)
{
    kern_status status;
    int i, any = 0, loaded = 0;
    for (i = 0; i < s->blocks; i++) {
        status = kern_block_check(s->block + i, s->gravity, &loaded);
        if (status != KERN_OK) {
            fault->block = i;
            return status;
        }
        any |= !s->block[i].fixed;
    }
    if (!any || !loaded)
        return any ? KERN_NO_LOAD : KERN_NO_FREE;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        status = kern_contact_check(c, s->blocks);
        if (status == KERN_OK
            && kern_abs(kern_vec_dot(c->n, c->n) - 1) > 2 * KERN_ROUNDING)
            status = KERN_BAD_NORMAL;
        if (status != KERN_OK) {
            fault->index = i;
            return status;
        }
    }
    return KERN_OK;
}

/* What is handed in, but for what its arrays hold; the answer goes to `out`. */
static kern_status kern_task_check(const kern_task *task, kern_real shrink,
                                   const void *out)
{
    const kern_structure *s;
    kern_status status;
    if (!task || !task->work || !task->work->real || !task->work->index || !out)
        return KERN_BAD_POINTER;
    s = &task->s;
    /* what kern_contacts() returned, and the fault that it left */
    if (s->contacts <= (int)KERN_NO_SPACE
        && s->contacts >= (int)KERN_STATUS_LEAST)
        return (kern_status)s->contacts;
    kern_work_begin(task->work);
    status = kern_options_check(&task->options);
    if (status != KERN_OK)
        return status;
    if ((unsigned)s->blocks > KERN_BLOCKS_MOST
        || (unsigned)s->contacts > KERN_POINTS_MOST)
        return KERN_BAD_COUNT;
    if ((!s->block && s->blocks > 0) || (!s->contact && s->contacts > 0))
        return KERN_BAD_POINTER;
    return kern_is_finite(s->gravity.x + s->gravity.y + shrink)
             ? KERN_OK
             : KERN_BAD_NUMBER;
}

/* The query of a task, and checks what its arrays hold. */
static kern_status kern_query_read(const kern_task *task, kern_real shrink,
                                   kern_query *q)
{
    kern_status status;
    q->shrink = shrink;
    q->relative = task->options.relative;
    q->narrow = task->options.narrow;
    q->mean = kern_mean_size(task->s.block, task->s.blocks);
    q->gravity = task->s.gravity;
    q->pattern = NULL;
    q->factor = q->shortest = KERN_R(0);
    q->loads = KERN_R(1);
    q->side = 0;
    q->fallen = NULL;
    status = kern_structure_check(&task->s, &task->work->fault);
    return status == KERN_OK && q->relative && shrink > 1 ? KERN_BAD_SHARE
                                                          : status;
}

static kern_status kern_query_check(const kern_task *task, kern_real shrink,
                                    const void *out, kern_query *q)
{
    const kern_status status = kern_task_check(task, shrink, out);
    return status == KERN_OK ? kern_query_read(task, shrink, q) : status;
}

/* What is wrong with the caller's linear program, if anything. */
static kern_status kern_lp_check(const kern_lp *lp, kern_fault *fault)
{
    int i, n;
    if (!lp || !lp->a || !lp->rhs)
        return KERN_BAD_POINTER;
    if (lp->rows < 1 || lp->cols < 1 || lp->rows > KERN_BLOCKS_MOST
        || lp->cols > KERN_POINTS_MOST || lp->rows > KERN_WORK_MOST / lp->cols)
        return KERN_BAD_COUNT;
    if (lp->limit < 0 || lp->limit > KERN_WORK_MOST)
        return KERN_BAD_OPTION;
    n = lp->rows * lp->cols;
    for (i = 0; i < n + lp->rows + (lp->cost ? lp->cols : 0); i++) {
        const kern_real v = i < n            ? lp->a[i]
                          : i < n + lp->rows ? lp->rhs[i - n]
                                             : lp->cost[i - n - lp->rows];
        if (!kern_is_finite(v)) {
            fault->index = i;
            fault->value = v;
            return KERN_BAD_NUMBER;
        }
    }
    return KERN_OK;
}

/* ---- Proofs ----------------------------------------------------- >>proof */
/* From the caller's data alone. An error is a share of what is allowed.

   Forces prove "stands": each in its cone, the residual of every equilibrium
   row within KERN_TOL of what acts on the block (or within the rounding of the
   forces that meet there), their sum at most KERN_BOUND times the weight. A
   motion proves "falls": its power exceeds its own rounding plus KERN_BOUND
   times the weight of what moves times the highest speed at which it closes a
   contact: forces of that sum could not hold it. The speed includes all that
   rounding may have taken from it: the proof holds without rounding as well. */

/* What is left in the rows of free blocks under contact forces of `sum`, four a
   block, or all normal forces, `total`: the larger share of what is allowed. */
static kern_real kern_prove_rows(const kern_structure *s, const kern_query *q,
                                 const kern_real *sum, kern_real total)
{
    kern_real error = KERN_R(0), weight = KERN_R(0);
    int i;
    for (i = 0; i < s->blocks; i++, sum += 4)
        if (!s->block[i].fixed && !kern_is_gone(q, i)) {
            kern_wrench w;
            const kern_real size = kern_wrench_on(s, q, i, &w);
            const kern_real x = kern_abs(sum[0] + w.fx);
            const kern_real y = kern_abs(sum[2] + w.fy);
            const kern_real turn = kern_abs(sum[1] + w.torque)
                                 / kern_block_size(s->block + i);
            const kern_real left = kern_max(kern_max(x, y), turn);
            weight += size;
            if (!kern_is_finite(x + y + turn))
                return KERN_INFINITY;
            if (left > 0)
                error = kern_max(
                    error, left / (KERN_TOL * size + KERN_ROUNDING * sum[3]));
        }
    weight *= KERN_BOUND;
    if (!kern_is_finite(weight)) /* too much is allowed to prove anything */
        return KERN_INFINITY;
    if (total > 0)
        error = kern_max(error, total / weight);
    return error <= 1 ? error : kern_max(error, KERN_R(2));
}

/* Adds a force, normal f, to a block's sums: fx, torque, fy, largest f. */
KERN_SHARED static void kern_prove_end(kern_real *sum, kern_vec arm,
                                       kern_real fx, kern_real fy, kern_real f)
{
    sum[0] += fx;
    sum[1] += arm.x * fy - arm.y * fx;
    sum[2] += fy;
    sum[3] = kern_max(sum[3], f);
}

/* `sum` is scratch, four a block. */
static kern_real kern_prove_forces(const kern_structure *s, const kern_query *q,
                                   const kern_force *force, kern_real *sum)
{
    const kern_real by = kern_reduction(q);
    kern_real total = KERN_R(0);
    int i;
    kern_zero(sum, 4 * s->blocks);
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real f = force[i].normal, r = force[i].tangential;
        const kern_real fx = f * c->n.x - r * c->n.y;
        const kern_real fy = f * c->n.y + r * c->n.x;
        kern_vec arm[2];
        if (kern_is_out(q, c))
            continue;
        if (!(f >= 0)
            || !(kern_abs(r) <= kern_friction(c, by) * f * (1 + 8 * KERN_EPS)))
            return KERN_INFINITY; /* not in its cone */
        if (!(f > 0))
            continue;
        kern_arms(s, c, q, arm);
        kern_prove_end(sum + 4 * (size_t)c->a, arm[0], -fx, -fy, f);
        kern_prove_end(sum + 4 * (size_t)c->b, arm[1], fx, fy, f);
        total += f;
    }
    return kern_prove_rows(s, q, sum, total);
}

/* How fast a motion closes contact c at the most, the rounding of this sum
   included: the worst force of 1 there takes so much power out of the motion.
   Every operation may lose half of KERN_EPS of its result. Of an arm these are
   three, those of its three terms; what they lose, the spin multiplies. */
static kern_real kern_closing(const kern_structure *s, const kern_contact *c,
                              const kern_query *q, const kern_motion *motion)
{
    kern_vec arm[2], v = kern_vec_make(0, 0), lost = v;
    const kern_real shift = kern_abs(kern_arms(s, c, q, arm));
    const kern_real mu = kern_friction(c, kern_reduction(q));
    const kern_real nx = kern_abs(c->n.x), ny = kern_abs(c->n.y);
    kern_real gap;
    int end;
    for (end = 0; end < 2; end++) { /* of b, less that of a */
        const kern_motion *m = motion + (end ? c->b : c->a);
        const kern_vec u = kern_velocity(m, arm[end]);
        const kern_real spin = 3 * kern_abs(m->spin);
        v = kern_vec_sub(u, v);
        lost.x += kern_abs(u.x) + spin * (kern_abs(arm[end].y) + shift * nx);
        lost.y += kern_abs(u.y) + spin * (kern_abs(arm[end].x) + shift * ny);
    }
    lost.x += 5 * kern_abs(v.x);
    lost.y += 5 * kern_abs(v.y);
    gap = nx * lost.x + ny * lost.y + mu * (nx * lost.y + ny * lost.x);
    return mu * kern_abs(kern_vec_cross(c->n, v)) - kern_vec_dot(c->n, v)
         + KERN_EPS / 2 * gap + 1 / (KERN_FAR * KERN_FAR);
}

/* The speed of a block that rests is 0. */
static kern_real kern_speed(const kern_motion *m) { return kern_wrench_sum(m); }

/* The larger of a block's speed and that of its turning. */
static kern_real kern_block_speed(const kern_block *b, const kern_motion *v)
{
    return kern_max(kern_vec_length(kern_vec_make(v->vx, v->vy)),
                    kern_abs(v->spin) * kern_block_size(b));
}

/* Scales a motion, so that the speed of the fastest block is 1. */
static void kern_motion_scale(const kern_structure *s, kern_motion *v)
{
    kern_real most = KERN_R(0);
    int i;
    for (i = 0; i < s->blocks; i++)
        most = kern_max(most, kern_block_speed(s->block + i, v + i));
    if (most > 0)
        kern_scale(v, 3 * s->blocks, 1 / most);
}

/* Of both blocks of a contact. */
static kern_real kern_speeds(const kern_contact *c, const kern_motion *motion)
{
    return kern_speed(motion + c->a) + kern_speed(motion + c->b);
}

static kern_real kern_prove_motion(const kern_structure *s, const kern_query *q,
                                   const kern_motion *motion)
{
    kern_real power = KERN_R(0), terms = power, weight = power, closing = power;
    int i, first = -1; /* that moves */
    for (i = 0; i < s->blocks; i++) {
        const kern_motion *m = motion + i;
        kern_wrench w, p;
        const kern_real speed = kern_speed(m);
        if (speed <= 0)
            continue;
        first = first < 0 ? i : first;
        if (s->block[i].fixed || !kern_is_finite(speed))
            return KERN_INFINITY;
        weight += kern_wrench_on(s, q, i, &w);
        p.fx = w.fx * m->vx;
        p.fy = w.fy * m->vy;
        p.torque = w.torque * m->spin;
        power += p.fx + p.fy + p.torque;
        terms += kern_wrench_sum(&p);
    }
    weight *= KERN_BOUND;
    if (!(power > 1 / (KERN_FAR * KERN_FAR)) || !kern_is_finite(terms + weight))
        return KERN_INFINITY;
    /* a stone laid last is the first that may stop it */
    for (i = s->contacts - 1; i >= 0 && weight * closing <= power; i--) {
        const kern_contact *c = s->contact + i;
        if ((c->a >= first || c->b >= first) && kern_speeds(c, motion) > 0
            && !kern_is_out(q, c)) {
            const kern_real speed = kern_closing(s, c, q, motion);
            closing = kern_is_finite(speed) ? kern_max(closing, speed)
                                            : KERN_INFINITY;
        }
    }
    return (weight * closing + KERN_ROUNDING * terms) / power;
}

/* Forces and the displacement that raised them: each contact that is loaded
   approaches, and slides as its friction says. That is a proof for some
   stiffness of each contact, f over its approach. */
static kern_real kern_prove_raised(const kern_structure *s, const kern_query *q,
                                   const kern_force *force,
                                   const kern_motion *motion, kern_real *sum)
{
    kern_real error = kern_prove_forces(s, q, force, sum);
    kern_real least = KERN_INFINITY;
    kern_wrench w;
    int i;
    for (i = 0; i < s->blocks; i++)
        if (!s->block[i].fixed)
            least = kern_min(least, kern_wrench_on(s, q, i, &w));
        else if (!(kern_speed(motion + i) <= 0))
            return KERN_INFINITY;
    for (i = 0; i < s->contacts && error <= 1; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real f = force[i].normal, r = force[i].tangential;
        const kern_vec u = kern_meeting_motion(s, q, c, motion);
        const kern_real mu = kern_friction(c, kern_reduction(q));
        const kern_real press = -kern_vec_dot(c->n, u);
        const kern_real slide = kern_vec_cross(c->n, u);
        if (!(f > KERN_TOL * least)) /* equilibrium would not miss it */
            continue;
        if (!(press
              > KERN_ROUNDING
                    * (kern_block_speed(s->block + c->a, motion + c->a)
                       + kern_block_speed(s->block + c->b, motion + c->b))))
            return KERN_INFINITY;
        if (kern_abs(r) < mu * f * (1 - KERN_TOL) || r * slide > 0)
            error = kern_max(error, kern_abs(slide) / (KERN_STICKS * press));
    }
    return error;
}

/* Takes those blocks out of the set (value >= 0) that are fixed or loaded, or
   that a block outside presses against gravity. Returns how many are left. */
static int kern_hang(const kern_structure *s, kern_real *value)
{
    const kern_real pull = kern_vec_length(s->gravity);
    int k, left = 0, held = 1;
    for (k = 0; k < s->blocks; k++) {
        if (s->block[k].fixed || !(pull > 0)
            || kern_wrench_sum(&s->block[k].load) > 0)
            value[k] = KERN_R(-1);
        left += value[k] >= 0;
    }
    while (held)
        for (k = held = 0; k < s->contacts; k++) {
            const kern_contact *c = s->contact + k;
            const kern_real up = -kern_vec_dot(c->n, s->gravity);
            const int on = up > 0 ? c->a : c->b, b = up > 0 ? c->b : c->a;
            if (kern_abs(up) > KERN_R(1e-9) * pull && value[b] >= 0
                && !(value[on] >= 0)) {
                value[b] = KERN_R(-1);
                held++;
                left--;
            }
        }
    return left;
}

KERN_API kern_real kern_check_forces(const kern_task *task, kern_real shrink,
                                     const kern_force *force)
{
    kern_take take;
    kern_query q;
    kern_real *sum;
    if (kern_query_check(task, shrink, force, &q) != KERN_OK)
        return KERN_INFINITY;
    kern_take_open(&take, task->work);
    sum = kern_take_reals(&take, 4 * task->s.blocks);
    return kern_take_fits(&take) ? kern_prove_forces(&task->s, &q, force, sum)
                                 : KERN_INFINITY;
}

KERN_API kern_real kern_check_motion(const kern_task *task, kern_real shrink,
                                     const kern_motion *motion)
{
    kern_query q;
    return kern_query_check(task, shrink, motion, &q) == KERN_OK
             ? kern_prove_motion(&task->s, &q, motion)
             : KERN_INFINITY;
}

KERN_API kern_real kern_check_raised(const kern_task *task, kern_real shrink,
                                     kern_raising raising,
                                     const kern_proof *proof)
{
    const kern_structure *s;
    kern_take take;
    kern_query q;
    kern_real *sum, *value;
    int i, n = 0;
    if (!proof || !proof->force || !proof->motion
        || kern_query_check(task, shrink, proof, &q) != KERN_OK)
        return KERN_INFINITY;
    s = &task->s;
    kern_take_open(&take, task->work);
    sum = kern_take_reals(&take, 5 * s->blocks);
    if (!kern_take_fits(&take) || raising == KERN_NOT_SHOWN)
        return KERN_INFINITY;
    if (raising == KERN_RAISED)
        return kern_prove_raised(s, &q, proof->force, proof->motion, sum);
    value = sum + 4 * s->blocks;
    for (i = 0; i < s->blocks; i++) { /* what moves must hang */
        const int falls = kern_speed(proof->motion + i) > 0;
        value[i] = falls ? KERN_R(1) : KERN_R(-1);
        n += falls;
    }
    if (n == 0 || kern_hang(s, value) != n)
        return KERN_INFINITY;
    q.fallen = value;
    return kern_prove_forces(s, &q, proof->force, sum);
}

/* ---- The model ------------------------------------------------- >>model */
/* Free blocks become groups of three rows, numbered from top to bottom as
   gravity sees them, so that what a group carries has a smaller number. What
   is fixed, or has been taken away, is the ground, and has the number after
   the last. A contact belongs to the upper group, which it carries. */

/* Groups and the contacts between them. */
typedef struct kern_graph {
    int groups;
    int *group;         /* of a block                                   */
    int *block;         /* of a group                                   */
    int *ends;          /* groups of b (2 i) and a (2 i + 1), contact i */
    int *touch, *after; /* first end of a contact at a group, and the end
                                 at the same group that follows an end        */
    kern_real *torque;  /* two an end: of n and t, as its row has them  */
    int *local;         /* of a group: its number in the open part      */
    int *carrier;       /* of a group: what alone bears it; or KERN_OUT */
} kern_graph;

/* What was found for the last verdict. */
typedef struct kern_answer {
    const kern_known *known; /* forces that held one like it, or NULL        */
    kern_force *force;       /* one a contact                                */
    kern_motion *motion;     /* one a block                                  */
    kern_real *sum;          /* scratch, four a block                        */
} kern_answer;

/* States of a cluster, or'ed: to be balanced; was balanced as it is. */
enum { KERN_OPEN = 1, KERN_TRIED = 2 };

/* Disjoint sets of groups that are balanced together. */
typedef struct kern_clusters {
    int *last; /* of a group: the last group of its cluster    */
    int *next; /* of a group: the next of its cluster, cyclic  */
    int *open; /* of a last group: the state of its cluster    */
    int at;    /* no cluster that is open ends before this one */
    int most;  /* groups of one                                */
    int until; /* units of work at which the pass ends         */
    int only;  /* group that known forces may not balance, if
                                 they begin the next pass, or KERN_OUT        */
} kern_clusters;

typedef struct kern_model {
    const kern_task *task; /* that it is of                                */
    const kern_structure *s;
    kern_graph graph;
    kern_answer answer;
    int relative;
    kern_real mean;      /* size of the free blocks                      */
    kern_real weight;    /* unit of force: all that acts on free blocks  */
    kern_real *unit;     /* of a group: 1 / the unit of its torques      */
    kern_real *load;     /* three a group: what contacts must exert [N]  */
    kern_real *size;     /* of a group: magnitude of all that acts       */
    kern_real shrunk;    /* shrinkage that torques are of, or infinity   */
    kern_real reduction; /* of cones of friction, of the last question   */
    kern_clusters cluster;
    int whole;        /* nonzero: all groups are one part             */
    kern_take common; /* work memory behind what every method needs   */
    kern_take rest;   /* work memory that is left                     */
} kern_model;

/* Structs that are copied, cleared and scaled as numbers. */
typedef char kern_structs_are_numbers
    [sizeof(kern_force) == 2 * sizeof(kern_real)
             && sizeof(kern_motion) == 3 * sizeof(kern_real)
             && sizeof(kern_wrench) == 3 * sizeof(kern_real)
             && sizeof(kern_contact_rate) == 5 * sizeof(kern_real)
             && sizeof(kern_block_rate) == 9 * sizeof(kern_real)
         ? 1
         : -1];

KERN_API void kern_work_need(int blocks, int contacts, int *reals, int *indices)
{
    const int fit = blocks >= 0 && blocks <= KERN_BLOCKS_MOST && contacts >= 0
                 && contacts <= KERN_POINTS_MOST;
    *reals = fit ? KERN_REALS(blocks, contacts) : 0;
    *indices = fit ? KERN_INTS(blocks, contacts) : 0;
}

KERN_API kern_work kern_work_of(kern_real *real, int reals, int *index,
                                int indices)
{
    const kern_work work = {
        real,    reals,     index,
        indices, 0,         0,
        0,       KERN_R(0), {KERN_OUT, KERN_OUT, KERN_OUT, 0, 0}};
    return work;
}

KERN_API kern_task kern_task_of(const kern_block *block, int blocks,
                                const kern_contact *contact, int contacts,
                                kern_work *work)
{
    const kern_task task = {
        {block, blocks, contact, contacts, {0, KERN_R(-9.81)}},
        kern_defaults(),
        work,
        kern_known_of(NULL, NULL)};
    return task;
}

KERN_API kern_known kern_known_of(kern_motion *motion, kern_force *force)
{
    const kern_known known = {motion, force, 0, 0, 0};
    return known;
}

/* Orders the blocks of all groups along gravity, at one height from side to
   side: were it rounding that decides, few columns of a flat arch would be own
   ones of their groups (>>lp). The rounding of float is larger: there by index.
   Shell sort, since it needs neither memory nor recursion. */
static void kern_model_order(const kern_model *m)
{
    const kern_block *block = m->s->block;
    const kern_vec down = m->s->gravity,
                   along = KERN_PICK(0, 1) > 0
                             ? down
                             : kern_vec_step(down, KERN_SLIGHT,
                                             kern_vec_turn(down));
    int *list = m->graph.block, gap, i, j;
    for (gap = 1; gap < m->graph.groups / 64; gap = 3 * gap + 1)
        continue;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < m->graph.groups; i++) {
            const int b = list[i];
            const kern_real at = kern_vec_dot(block[b].centre, along);
            for (j = i; j >= gap; j -= gap) {
                const int c = list[j - gap];
                const kern_real other = kern_vec_dot(block[c].centre, along);
                if (other < at || (other <= at && c < b))
                    break;
                list[j] = c;
            }
            list[j] = b;
        }
}

/* No contact bears anything. */
static void kern_model_unload(kern_model *m)
{
    kern_zero(m->answer.force, 2 * m->s->contacts);
}

/* Gives every free block that is not gone a group, and lists its contacts. */
static void kern_model_group(kern_model *m, const kern_query *q)
{
    const kern_structure *s = m->s;
    int i, g, none = 0;
    for (i = s->blocks - 1; i >= 0; i--)
        if (!s->block[i].fixed && !kern_is_gone(q, i))
            m->graph.block[none++] = i;
    m->graph.groups = none;
    m->shrunk = KERN_INFINITY;
    m->cluster.only = KERN_OUT;
    m->whole = 0;
    kern_model_unload(m);
    kern_model_order(m);
    for (i = 0; i < s->blocks; i++)
        m->graph.group[i] = none;
    for (g = 0; g < none; g++) {
        m->graph.group[m->graph.block[g]] = g;
        m->graph.touch[g] = KERN_OUT;
    }
    for (i = s->contacts - 1; i >= 0; i--) {
        const kern_contact *c = s->contact + i;
        const int gone = kern_is_out(q, c);
        m->graph.ends[2 * i] = gone ? none : m->graph.group[c->b];
        m->graph.ends[2 * i + 1] = gone ? none : m->graph.group[c->a];
    }
    for (i = 2 * s->contacts - 1; i >= 0; i--) { /* an end */
        g = m->graph.ends[i];
        if (g < none) {
            m->graph.after[i] = m->graph.touch[g];
            m->graph.touch[g] = i;
        }
    }
}

/* Opens the model of a task that has been checked, for a query. */
static kern_status kern_model_open(kern_model *m, const kern_task *task,
                                   const kern_query *q)
{
    const kern_structure *s = &task->s;
    kern_take *const take = &m->rest;
    int i, groups = 0;
    for (i = 0; i < s->blocks; i++)
        groups += !s->block[i].fixed;
    kern_take_open(take, task->work);
    m->graph.group = kern_take_ints(take, s->blocks + groups);
    m->graph.block = m->graph.group + s->blocks;
    m->graph.ends = kern_take_ints(take, 2 * s->contacts);
    m->load = kern_take_reals(take, 5 * groups + 1);
    m->size = m->load + 3 * groups;
    m->unit = m->size + groups;
    m->answer.force = (kern_force *)(void *)kern_take_reals(take,
                                                            2 * s->contacts);
    m->answer.sum = kern_take_reals(take, 7 * s->blocks);
    m->answer.motion = (kern_motion *)(void *)(m->answer.sum + 4 * s->blocks);
    m->common = *take;
    m->graph.touch = kern_take_ints(take, 6 * groups + 1);
    m->graph.carrier = m->graph.touch + groups;
    m->cluster.last = m->graph.carrier + groups;
    m->cluster.next = m->cluster.last + groups;
    m->cluster.open = m->cluster.next + groups;
    m->graph.local = m->cluster.open + groups;
    m->graph.after = kern_take_ints(take, 2 * s->contacts);
    m->graph.torque = kern_take_reals(take, 4 * s->contacts);
    if (!kern_take_fits(take))
        return KERN_NO_SPACE;
    m->task = task;
    m->s = s;
    m->relative = task->options.relative;
    m->mean = q->mean;
    m->answer.known = NULL;
    kern_model_group(m, q);
    return KERN_OK;
}

/* The row of a contact at one of its ends: three equations of the group there.
   All that look for forces use it by two verbs, motion to speed and force to
   wrench; proofs have their own, so as not to share a fault. */
typedef struct kern_row {
    kern_real n[3]; /* wrench of a unit of normal force             */
    kern_real turn; /* along t it is (-n[1], n[0], turn)            */
} kern_row;

/* The row of a normal n that acts at an arm, its torque times `unit`. */
static inline kern_row kern_row_of(kern_vec n, kern_vec arm, kern_real unit)
{
    const kern_row row = {{n.x, n.y, kern_vec_cross(arm, n) * unit},
                          kern_vec_dot(arm, n) * unit};
    return row;
}

/* w += the speed along n and t of motion v */
static inline void kern_row_speed(const kern_row *c, const kern_real *v,
                                  kern_real w[2])
{
    w[0] += c->n[0] * v[0] + c->n[1] * v[1] + c->n[2] * v[2];
    w[1] += c->n[0] * v[1] - c->n[1] * v[0] + c->turn * v[2];
}

/* w := the wrench of forces f along n and r along t */
static inline void kern_row_wrench(const kern_row *c, kern_real f, kern_real r,
                                   kern_real w[3])
{
    w[0] = f * c->n[0] - r * c->n[1];
    w[1] = f * c->n[1] + r * c->n[0];
    w[2] = f * c->n[2] + r * c->turn;
}

/* b += that wrench */
static inline void kern_row_exert(const kern_row *c, kern_real f, kern_real r,
                                  kern_real *b)
{
    b[0] += f * c->n[0] - r * c->n[1];
    b[1] += f * c->n[1] + r * c->n[0];
    b[2] += f * c->n[2] + r * c->turn;
}

/* The rows of contact i: of block b, and of a. Torques depend on the query. */
static inline void kern_model_rows(const kern_model *m, const kern_query *q,
                                   int i, kern_row row[2])
{
    const kern_contact *c = m->s->contact + i;
    kern_vec arm[2];
    kern_arms(m->s, c, q, arm);
    row[0] = kern_row_of(c->n, arm[1], m->unit[m->graph.ends[2 * i]]);
    row[1] = kern_row_of(kern_vec_scale(c->n, KERN_R(-1)), arm[0],
                         m->unit[m->graph.ends[2 * i + 1]]);
}

/* The row at an end, for the query that is set. */
static inline kern_row kern_model_row(const kern_model *m, int end)
{
    const kern_vec n = m->s->contact[end >> 1].n;
    const kern_real *torque = m->graph.torque + 2 * (size_t)end;
    const kern_row row = {
        {end & 1 ? -n.x : n.x, end & 1 ? -n.y : n.y, torque[0]}, torque[1]};
    return row;
}

/* The cones, and the torques of all rows unless they are those, of a query. */
static void kern_model_arms(kern_model *m, const kern_query *q)
{
    kern_real *to = m->graph.torque;
    int i, end;
    m->reduction = kern_reduction(q);
    if (m->shrunk >= q->shrink && m->shrunk <= q->shrink)
        return;
    m->shrunk = q->shrink;
    for (i = 0; i < m->s->contacts; i++) {
        kern_row row[2];
        kern_model_rows(m, q, i, row);
        for (end = 0; end < 2; end++) {
            *to++ = row[end].n[2];
            *to++ = row[end].turn;
        }
    }
}

/* The unit of a group's torques: its block's size plus how far kerns grew. */
static inline void kern_model_unit(kern_model *m, const kern_query *q, int g)
{
    const kern_real size = kern_block_size(m->s->block + m->graph.block[g]);
    const kern_real grown = kern_max(-q->shrink, KERN_R(0));
    m->unit[g] = 1 / (q->relative ? size * (1 + grown) : size + grown);
}

static inline kern_real kern_model_mu(const kern_model *m, int i)
{
    return kern_friction(m->s->contact + i, m->reduction);
}

/* What contacts must exert on group g: Eq. (5)'s -w. */
static inline void kern_model_load(kern_model *m, const kern_query *q, int g)
{
    kern_real *load = m->load + 3 * (size_t)g;
    kern_wrench w;
    m->size[g] = kern_wrench_on(m->s, q, m->graph.block[g], &w);
    load[0] = -w.fx;
    load[1] = -w.fy;
    load[2] = -w.torque * m->unit[g];
}

/* The loads of all groups, none in a part, and the unit of force. */
static void kern_model_weigh(kern_model *m, const kern_query *q)
{
    kern_real weight = KERN_R(0);
    int g;
    m->unit[m->graph.groups] = KERN_R(0);
    for (g = 0; g < m->graph.groups; g++) {
        kern_model_unit(m, q, g);
        kern_model_load(m, q, g);
        weight += m->size[g];
        m->graph.local[g] = KERN_OUT;
    }
    m->graph.local[g] = KERN_OUT;
    m->weight = weight > 0 ? weight : KERN_R(1);
}

/* All of the model for a query. */
static void kern_model_set(kern_model *m, const kern_query *q)
{
    kern_model_weigh(m, q);
    kern_model_arms(m, q);
}

/* Whether a load lies on a block that is free. */
static int kern_model_loaded(const kern_model *m)
{
    int g;
    for (g = 0; g < m->graph.groups; g++)
        if (kern_wrench_sum(&m->s->block[m->graph.block[g]].load) > 0)
            return 1;
    return 0;
}

/* Whether kerns are nested, as those of lines are: what a smaller one can carry
   a larger one can. Points that move toward each other along different tangents
   are not. range: the shortest of their travels, and the longest, d_max. */
static int kern_is_nested(const kern_model *m, kern_real range[2])
{
    const int *ends = m->graph.ends, none = 2 * m->graph.groups;
    const kern_contact *c = m->s->contact, *const end = c + m->s->contacts;
    int points = 0;
    range[0] = KERN_INFINITY;
    range[1] = KERN_R(0);
    for (; c < end; c++, ends += 2) {
        const kern_real travel = kern_abs(kern_travel(c, m->mean));
        if (!(travel > 0) || ends[0] + ends[1] == none)
            continue;
        range[0] = kern_min(range[0], travel);
        range[1] = kern_max(range[1], travel);
        points += !c->line;
    }
    if (m->relative)
        range[1] = KERN_R(1);
    return points == 0;
}

/* What is known of a structure like it, if anything is. */
KERN_SHARED static void kern_model_know(kern_model *m, const kern_known *known)
{
    m->answer.known = known->fails > 0 && known->force ? known : NULL;
}

static int kern_model_spend(const kern_model *m, int units)
{
    return kern_spend(m->task->work, m->task->options.limit, units);
}

/* The same for queries, however small: proofs are of all. */
static int kern_model_ask(const kern_model *m, int queries)
{
    return kern_model_spend(
        m, queries * (3 + (m->s->blocks + m->s->contacts) / 14));
}

/* Whether one linear program answers: few groups, all of the work memory. */
static int kern_model_is_small(const kern_model *m)
{
    const kern_work *work = m->task->work;
    int reals, indices;
    kern_work_need(m->s->blocks, m->s->contacts, &reals, &indices);
    return m->graph.groups <= KERN_SMALL && work->reals >= reals
        && work->indices >= indices;
}

/* Whether a proof with this error holds; notes the largest such error. */
static int kern_model_proven(const kern_model *m, kern_real error)
{
    if (error <= 1)
        m->task->work->error = kern_max(m->task->work->error, error);
    return error <= 1;
}

/* Whether the forces of the answer prove that it stands. */
static int kern_answer_holds(const kern_model *m, const kern_query *q)
{
    return kern_model_proven(
        m, kern_prove_forces(m->s, q, m->answer.force, m->answer.sum));
}

/* Replaces the forces of all lines, whose ends are where `from` puts them, by
   those of the same wrenches at the ends where `shrink` < `from` puts them. */
static void kern_force_transfer(kern_model *m, kern_real from, kern_real shrink)
{
    int i, k;
    for (i = 0; i < m->s->contacts; i++) {
        const kern_real travel = kern_travel(m->s->contact + i, m->mean);
        kern_force *f = m->answer.force + i;
        kern_real rate, is, sum, more, along;
        if (!kern_line_begins(m->s->contact, m->s->contacts, i))
            continue;
        i++;
        sum = f[0].normal + f[1].normal;
        if (!(sum > 0))
            continue;
        is = travel - kern_shift(travel, shrink, m->relative, &rate);
        along = (f[0].tangential + f[1].tangential) / sum;
        more = f[0].normal - f[1].normal;
        if (kern_abs(is) > 0)
            more *= (travel - kern_shift(travel, from, m->relative, &rate))
                  / is;
        for (k = 0; k < 2; k++, f++, more = -more) {
            f->normal = kern_max((sum + more) / 2, KERN_R(0));
            f->tangential = along * f->normal;
        }
    }
}

/* Hands the proof of a verdict to the caller. */
KERN_SHARED static void kern_proof_out(const kern_model *m,
                                       const kern_proof *proof,
                                       kern_status status)
{
    if (proof && status == KERN_STANDS && proof->force)
        kern_copy(proof->force, m->answer.force, 2 * m->s->contacts);
    if (proof && status == KERN_FALLS && proof->motion)
        kern_copy(proof->motion, m->answer.motion, 3 * m->s->blocks);
}

/* ==== Part IV: How forces and motions are found ========================== */

/* ---- The simplex method -------------------------------------------- >>lp */
/* minimise cost . x  where  A x = rhs,  x >= 0,  by the revised simplex method.
   Variables are the columns, then the place (see kern_program), then a logical
   for each row, a unit vector. Logicals must be zero.

   The inverse of the basis B is a product of factors:

       B^-1 = E_n ... E_2 E_1 B_0^-1.

   Rows come in groups of three. A column of a network (`ends` given) touches
   one or two groups; it is an own column of the first of them, in the order in
   which groups carry each other. B_0 has three own columns of each group, or
   logicals: it is block triangular, and for each group its inverse, 3 x 3, and
   what its three columns do to other groups is all there is to store. Without
   `ends` B_0 is the unit matrix.

   E_i lets one column more enter (the product form of the inverse). It is the
   unit matrix but for one column: with alpha the entering column in terms of
   the basis, and p the row in which it pivots, that is -alpha / alpha_p with 1
   / alpha_p in row p. Its entries are kept in threes, from the first that is
   not zero to the last.

   Vectors over the rows have three more places at their end: there lie the rows
   of the group that a column leads to which leads to none. Reading it gives 0,
   writing to it has no effect, and no loop tests for it. */

typedef struct kern_program {
    int rows, cols;
    const kern_real *a; /* dense: rows x cols by columns; network: 4 a
                               column, (u, v, r) in the head's rows and
                               (-u, -v, s) in the tail's                      */
    const kern_real *rhs;
    const kern_real *cost; /* or NULL                                        */
    const int *ends;       /* network: head and tail group of columns 2 i and
                               2 i + 1, rows / 3 for none; NULL: dense        */
    const kern_real *rate; /* column of the place: less its growth of rhs    */
    int follow;            /* 1: the place grows from rhs's, 0: it is held   */
    kern_real most;        /* what a variable can be at the most; 0: all     */
    int limit;             /* of work->units                                 */
    kern_work *work;       /* of the call                                    */
} kern_program;

/* The inverse of a basis: B_0, by groups, and the factors E_i. */
typedef struct kern_factors {
    int size;          /* rows, to a multiple of three                   */
    int groups;        /* of B_0: all of a network, or 0                 */
    kern_real *block;  /* row: of the inverse of its group, three; then
                               what its column is in its other end's rows     */
    int *to;           /* row: the first of those rows                   */
    int most, room;    /* for factors, and for entries                   */
    int count;         /* factors                                        */
    int *pivot, *from; /* factor: its pivot's row, the first with entry  */
    int *first;        /* where its entries begin; one more              */
    kern_real *entry;  /* its column, in threes of rows                  */
} kern_factors;

typedef enum kern_basis {
    KERN_BASIS_NONE,  /* begins from logicals                           */
    KERN_BASIS_STALE, /* columns are not those that were factored       */
    KERN_BASIS_READY
} kern_basis;

typedef struct kern_simplex {
    const kern_program *lp;
    kern_basis state;
    kern_factors factors;
    int *base;        /* row: its variable                              */
    int *place;       /* column: its row, or KERN_OUT; then the place's */
    kern_real *value; /* row: of its variable                           */
    kern_real *slope; /* row: c, by what growth of its variable lowers
                               violations, then costs                         */
    kern_real *price; /* row: y                                         */
    kern_real *alpha; /* row: of what is solved for, as what enters     */
    kern_real *ratio; /* of the ratio test: steps                       */
    int *list;        /* its rows; or the columns to be factored        */
    int enters;       /* column                                         */
    kern_real least;  /* violation that counts                          */
    kern_real gain;   /* largest c_j - y.A_j                            */
    int refined;      /* no pivot since the values were refined         */
    int violated;     /* variables                                      */
} kern_simplex;

/* ---- columns ---- */

/* Column j where it is dense. */
static const kern_real *kern_lp_dense(const kern_program *lp, int j)
{
    return j == lp->cols ? lp->rate : lp->a + (size_t)j * (size_t)lp->rows;
}

/* y.A_j of a column, or of the place. */
static inline kern_real kern_lp_dot(const kern_program *lp, int j,
                                    const kern_real *y)
{
    if (lp->ends && j < lp->cols) {
        const kern_real *h = y + 3 * lp->ends[j & ~1];
        const kern_real *t = y + 3 * lp->ends[j | 1];
        const kern_real *c = lp->a + 4 * (size_t)j;
        return c[0] * (h[0] - t[0]) + c[1] * (h[1] - t[1]) + c[2] * h[2]
             + c[3] * t[2];
    }
    return kern_dot(kern_lp_dense(lp, j), y, lp->rows);
}

/* Column j's entries in the rows of the group whose own it is, or of its other
   end; returns the first of these rows. */
static inline int kern_lp_part(const kern_program *lp, int j, int other,
                               kern_real out[3])
{
    const int *ends = lp->ends + (j & ~1);
    const int end = (ends[1] < ends[0]) ^ other;
    const kern_real *c = lp->a + 4 * (size_t)j;
    out[0] = end ? -c[0] : c[0];
    out[1] = end ? -c[1] : c[1];
    out[2] = c[2 + end];
    return 3 * ends[end];
}

/* v -= s * variable j */
static void kern_lp_subtract(const kern_program *lp, int j, kern_real s,
                             kern_real *v)
{
    if (j > lp->cols)
        v[j - lp->cols - 1] -= s;
    else if (!lp->ends || j == lp->cols)
        kern_add(v, -s, kern_lp_dense(lp, j), lp->rows);
    else {
        kern_real *h = v + 3 * lp->ends[j & ~1], *t = v + 3 * lp->ends[j | 1];
        const kern_real *c = lp->a + 4 * (size_t)j, x = s * c[0], y = s * c[1];
        h[0] -= x;
        h[1] -= y;
        h[2] -= s * c[2];
        t[0] += x;
        t[1] += y;
        t[2] -= s * c[3];
    }
}

/* ---- the basis ---- */

/* v := B^-1 v, from rows to variables */
static void kern_basis_solve(const kern_simplex *sx, kern_real *v)
{
    const kern_factors *f = &sx->factors;
    int e, g, k;
    for (g = 0; g < f->groups; g++) {
        const kern_real *d = f->block + 18 * (size_t)g;
        kern_real *own = v + 3 * g;
        const kern_real b[3] = {own[0], own[1], own[2]};
        if (kern_abs(b[0]) + kern_abs(b[1]) + kern_abs(b[2]) <= 0)
            continue;
        for (k = 0; k < 3; k++, d += 6) {
            const kern_real x = d[0] * b[0] + d[1] * b[1] + d[2] * b[2];
            kern_real *to = v + f->to[3 * g + k];
            own[k] = x;
            to[0] -= x * d[3];
            to[1] -= x * d[4];
            to[2] -= x * d[5];
        }
    }
    for (e = 0; e < f->count; e++) {
        const kern_real x = v[f->pivot[e]], *a;
        kern_real *w;
        if (kern_abs(x) <= 0)
            continue;
        v[f->pivot[e]] = KERN_R(0);
        w = v + f->from[e];
        for (a = f->entry + f->first[e]; a < f->entry + f->first[e + 1];
             a += 3, w += 3) {
            w[0] += x * a[0];
            w[1] += x * a[1];
            w[2] += x * a[2];
        }
    }
}

/* c := B^-T c, from variables to rows; zero where no rows are. */
static void kern_basis_solve_t(const kern_simplex *sx, kern_real *c)
{
    const kern_factors *f = &sx->factors;
    int e, g, k;
    kern_zero(c + sx->lp->rows, f->size + 3 - sx->lp->rows);
    for (e = f->count - 1; e >= 0; e--)
        c[f->pivot[e]] = kern_dot(f->entry + f->first[e], c + f->from[e],
                                  f->first[e + 1] - f->first[e]);
    for (g = f->groups - 1; g >= 0; g--) {
        const kern_real *d = f->block + 18 * (size_t)g;
        kern_real y0 = KERN_R(0), y1 = KERN_R(0), y2 = KERN_R(0);
        for (k = 0; k < 3; k++, d += 6) {
            const kern_real *to = c + f->to[3 * g + k];
            const kern_real z = c[3 * g + k] - to[0] * d[3] - to[1] * d[4]
                              - to[2] * d[5];
            y0 += z * d[0];
            y1 += z * d[1];
            y2 += z * d[2];
        }
        c[3 * g] = y0;
        c[3 * g + 1] = y1;
        c[3 * g + 2] = y2;
    }
}

/* Column j in terms of the basis: to sx->alpha. */
static void kern_basis_column(kern_simplex *sx, int j)
{
    kern_zero(sx->alpha, sx->factors.size + 3);
    kern_lp_subtract(sx->lp, j, KERN_R(-1), sx->alpha);
    kern_basis_solve(sx, sx->alpha);
}

/* Whether there is no room for one more factor. */
static int kern_basis_full(const kern_simplex *sx)
{
    const kern_factors *f = &sx->factors;
    return f->count == f->most || f->first[f->count] + f->size > f->room;
}

/* Makes column q, which is sx->alpha in terms of the basis, basic in row p. */
static void kern_basis_enter(kern_simplex *sx, int q, int p)
{
    kern_factors *f = &sx->factors;
    const kern_real one = 1 / sx->alpha[p];
    kern_real *entry = f->entry + f->first[f->count];
    int from = 0, to = f->size, i;
    while (kern_largest(sx->alpha + from, 3) <= 0)
        from += 3;
    while (kern_largest(sx->alpha + to - 3, 3) <= 0)
        to -= 3;
    for (i = from; i < to; i++)
        *entry++ = i == p ? one : -sx->alpha[i] * one;
    f->from[f->count] = from;
    f->pivot[f->count++] = p;
    f->first[f->count] = f->first[f->count - 1] + to - from;
    sx->base[p] = q;
    sx->place[q] = p;
}

/* ---- the crash basis ---- */

static kern_real kern_three_det(const kern_real *a, const kern_real *b,
                                const kern_real *c)
{
    return (a[1] * b[2] - a[2] * b[1]) * c[0]
         + (a[2] * b[0] - a[0] * b[2]) * c[1]
         + (a[0] * b[1] - a[1] * b[0]) * c[2];
}

/* Of the columns of group g, a list from j, three become basic and pass on what
   they exert: those that carry its load with the largest least share. If not
   `all` they must push against it, and none pull more than so many loads; else
   one may be the logical of its torque. 0: there are none. */
static int kern_crash_choose(kern_simplex *sx, int g, int j, int all)
{
    const int logical = sx->lp->cols + 1 + 3 * g + 2;
    int *base = sx->base + 3 * g;
    const kern_real *load = sx->alpha + 3 * g;
    const kern_real x = load[0], y = load[1];
    kern_real part[KERN_ROWS_MOST][3], share[3];
    kern_real best = all ? -KERN_INFINITY
                         : -KERN_CRASH_PULL * (kern_abs(x) + kern_abs(y));
    int mine[KERN_ROWS_MOST], n = 0, found = 0, i, k;
    for (; j != KERN_OUT && n < KERN_ROWS_MOST - 1; j = sx->place[j]) {
        const kern_real *a = part[n];
        kern_real along;
        kern_lp_part(sx->lp, j, 0, part[n]);
        along = a[0] * x + a[1] * y;
        mine[n] = j;
        n += all
          || (along > 0
              && 4 * along * along
                     >= (a[0] * a[0] + a[1] * a[1]) * (x * x + y * y));
    }
    if (all) {
        part[n][0] = part[n][1] = KERN_R(0);
        part[n][2] = KERN_R(1);
        mine[n++] = logical;
    }
    for (i = 0; i < n; i++)
        for (j = i + 1; j < n; j++) {
            const kern_real *a = part[i], *b = part[j];
            const kern_real last = kern_three_det(a, b, load);
            for (k = j + 1; k < n; k++) {
                const kern_real *c = part[k], det = kern_three_det(a, b, c);
                const kern_real lc = last / det;
                kern_real la, lb, least;
                if (kern_abs(det) < KERN_PIVOT || lc <= best)
                    continue;
                la = kern_three_det(b, c, load) / det;
                lb = kern_three_det(c, a, load) / det;
                least = kern_min(kern_min(la, lb),
                                 mine[k] == logical ? -kern_abs(lc) : lc);
                if (least > best) {
                    best = least;
                    found = 1;
                    base[0] = mine[i];
                    base[1] = mine[j];
                    base[2] = mine[k];
                    share[0] = la;
                    share[1] = lb;
                    share[2] = lc;
                }
            }
        }
    for (k = 0; k < 3 && found; k++)
        kern_lp_subtract(sx->lp, base[k], kern_max(share[k], KERN_R(0)),
                         sx->alpha);
    return found;
}

/* Begins from the columns that x uses, if they may be a basis, and the last. */
static void kern_simplex_start(kern_simplex *sx, const kern_real *x,
                               kern_real least)
{
    const kern_program *lp = sx->lp;
    int j, n = 0;
    sx->state = KERN_BASIS_NONE;
    for (j = 0; j < lp->cols; j++)
        if (x[j] > least) {
            if (n == lp->rows)
                return;
            sx->base[n++] = j;
        }
    for (; n < lp->rows; n++)
        sx->base[n] = j > 0 ? --j : lp->cols + 1;
    sx->state = KERN_BASIS_STALE;
}

/* Logicals; of a network three columns of each group, from top to bottom. */
static void kern_simplex_crash(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    int *next = sx->place, *first = sx->list; /* columns of a group */
    int g, j;
    for (j = 0; j < lp->rows; j++) {
        sx->base[j] = lp->cols + 1 + j; /* its logical */
        sx->alpha[j] = lp->rhs[j];
        first[j] = KERN_OUT;
    }
    for (j = lp->cols - 1; j >= 0 && lp->ends; j--) {
        kern_real part[3];
        g = kern_lp_part(lp, j, 0, part) / 3;
        next[j] = first[g];
        first[g] = j;
    }
    for (g = 0; g < sx->factors.groups; g++)
        if (!kern_crash_choose(sx, g, first[g], 0))
            kern_crash_choose(sx, g, first[g], 1);
    sx->state = KERN_BASIS_STALE;
}

/* ---- factors ---- */

/* Lets column j take one of its own rows that still have their logical: where
   it is largest in terms of the columns before it. */
static int kern_own_enter(kern_simplex *sx, int j)
{
    const kern_program *lp = sx->lp;
    kern_real part[3], alpha[3], least = KERN_OWN_TOL, *block, *own;
    int k, best = KERN_OUT, row;
    if (!lp->ends || j == lp->cols)
        return 0;
    row = kern_lp_part(lp, j, 0, part);
    block = sx->factors.block + 6 * (size_t)row;
    for (k = 0; k < 3; k++) {
        alpha[k] = kern_three(block + 6 * k, part);
        if (sx->base[row + k] > lp->cols && kern_abs(alpha[k]) >= least) {
            least = kern_abs(alpha[k]);
            best = k;
        }
    }
    if (best == KERN_OUT)
        return 0;
    own = block + 6 * best;
    for (k = 0; k < 3; k++)
        own[k] /= alpha[best];
    for (k = 0; k < 3; k++)
        if (k != best)
            kern_add(block + 6 * k, -alpha[k], own, 3);
    sx->factors.to[row + best] = kern_lp_part(lp, j, 1, own + 3);
    sx->base[row + best] = j;
    sx->place[j] = row + best;
    return 1;
}

/* Lets column j enter in any row that still has its logical, unless it depends
   on the columns before it, or there is no room. */
static void kern_left_enter(kern_simplex *sx, int j)
{
    kern_real least;
    int p, best = KERN_OUT;
    kern_basis_column(sx, j);
    least = KERN_PIVOT * kern_largest(sx->alpha, sx->lp->rows);
    for (p = 0; p < sx->lp->rows; p++)
        if (sx->base[p] > sx->lp->cols && kern_abs(sx->alpha[p]) >= least) {
            least = kern_abs(sx->alpha[p]);
            best = p;
        }
    if (best != KERN_OUT && !kern_basis_full(sx))
        kern_basis_enter(sx, j, best);
}

/* What the values leave of the right-hand side, to sx->alpha: returns its
   largest entry as a share of the largest value. */
static kern_real kern_basis_residual(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    kern_real size = KERN_R(0);
    int p;
    kern_copy(sx->alpha, lp->rhs, lp->rows);
    for (p = 0; p < lp->rows; p++) {
        const kern_real v = sx->value[p];
        size = kern_max(size, kern_abs(v));
        if (kern_abs(v) > 0)
            kern_lp_subtract(lp, sx->base[p], v, sx->alpha);
    }
    return size > 0 ? kern_largest(sx->alpha, lp->rows) / size : KERN_INFINITY;
}

/* The basic solution. What it leaves of the right-hand side is solved for
   again until that is rounding: the inverse grows with every course of a wall,
   and one solve may lose half of the digits. Returns 0 where it is not. */
static int kern_basis_values(kern_simplex *sx)
{
    kern_real left = kern_basis_residual(sx);
    int round;
    for (round = 0; round < 3 && left > 4 * KERN_EPS; round++) {
        kern_basis_solve(sx, sx->alpha);
        kern_add(sx->value, KERN_R(1), sx->alpha, sx->lp->rows);
        left = kern_basis_residual(sx);
    }
    sx->refined = 1;
    return left <= KERN_PASS_TOL;
}

/* Factors the basis anew: three own columns of each group, then the others. */
static void kern_basis_refactorise(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    kern_factors *f = &sx->factors;
    int i, p, left = 0;
    for (i = 0; i <= lp->cols; i++)
        sx->place[i] = KERN_OUT;
    for (p = 0; p < lp->rows; p++) {
        sx->list[p] = sx->base[p];
        sx->base[p] = lp->cols + 1 + p;
        sx->value[p] = KERN_R(0);
    }
    kern_zero(f->block, 18 * f->groups);
    for (p = 0; p < 3 * f->groups; p++) {
        f->block[6 * p + p % 3] = KERN_R(1);
        f->to[p] = lp->rows;
    }
    f->count = f->first[0] = 0;
    for (p = 0; p < lp->rows; p++)
        if (sx->list[p] <= lp->cols && !kern_own_enter(sx, sx->list[p]))
            sx->list[left++] = sx->list[p];
    for (i = 0; i < left; i++)
        kern_left_enter(sx, sx->list[i]);
    sx->state = KERN_BASIS_READY;
    kern_basis_values(sx);
}

/* The basic solution, of a basis that is factored anew where the matrix changed
   or pivots have made the factors too long, or lost digits. */
static void kern_basis_renew(kern_simplex *sx)
{
    if (sx->state != KERN_BASIS_READY || kern_basis_full(sx)
        || !kern_basis_values(sx))
        kern_basis_refactorise(sx);
}

/* ---- pivots ---- */
/* Every basis gives x with A x = rhs. While a variable violates x >= 0 (or is a
   logical that is not zero) what is lowered is the sum of all violations. With

       y = B^-T c,    c = +1 or -1 for what violates, else 0,

   y.A_j < 0 tells how fast the sum falls when column j enters. When no column
   lowers it and it is not zero, y is a Farkas certificate, and the one that
   shows the largest sum of violations: what a step of Newton's method needs.
   Where nothing violates c is less the costs, and y less their prices. */

/* Whether variable j must be zero: a logical, or a place that is held. */
static int kern_lp_fixed(const kern_program *lp, int j)
{
    return j >= lp->cols + lp->follow;
}

/* By what the costs fall where variable j grows; 1 for a place that is free. */
static kern_real kern_lp_worth(const kern_program *lp, int j)
{
    return lp->cost && j < lp->cols ? -lp->cost[j]
                                    : KERN_R(j == lp->cols ? lp->follow : 0);
}

/* c to sx->slope; returns the sum of violations. */
static kern_real kern_violations(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const kern_real least = sx->least;
    kern_real sum = KERN_R(0);
    int p;
    sx->violated = 0;
    for (p = 0; p < lp->rows; p++) {
        const kern_real v = sx->value[p];
        sx->slope[p] = KERN_R(0);
        if (v < -least || (v > least && kern_lp_fixed(lp, sx->base[p]))) {
            sx->slope[p] = KERN_R(v < 0 ? 1 : -1);
            sx->violated++;
            sum += kern_abs(v);
        }
    }
    for (p = 0; p < lp->rows && !sx->violated; p++)
        sx->slope[p] = kern_lp_worth(lp, sx->base[p]);
    return sum;
}

/* Corrects y by what a solution that lost digits leaves of y.A_j = c of basic
   variables; and lifts it, as a certificate, off the columns, by a share of its
   size. Rounding puts it a little below zero there as often as above; a few
   roundings higher it costs of its power no more than all of x is worth, times
   those roundings. 0: no basis, since the backend has answered. */
static int kern_prices_mend(kern_simplex *sx, kern_real *y, kern_real lift)
{
    const kern_program *lp = sx->lp;
    int p;
    lift *= kern_largest(y, lp->rows);
    if (sx->state == KERN_BASIS_NONE)
        return 0;
    for (p = 0; p < lp->rows; p++) {
        const int j = sx->base[p];
        sx->alpha[p] = sx->slope[p] + (j < lp->cols ? lift : KERN_R(0))
                     - (j > lp->cols ? y[j - lp->cols - 1]
                                     : kern_lp_dot(lp, j, y));
    }
    kern_basis_solve_t(sx, sx->alpha);
    kern_add(y, KERN_R(1), sx->alpha, lp->rows);
    return 1;
}

/* Prices; and of the variables outside of the basis that lowers what they stand
   for fastest, or the first that does: sx->enters does by sx->gain = c_j -
   y.A_j. 0: none does. What would have to carry more than lp->most to undo the
   violations is no help: the bound on forces of a jam. */
static int kern_entering(kern_simplex *sx, int first, int fine)
{
    const kern_program *lp = sx->lp;
    const kern_real sum = kern_violations(sx);
    const int costs = !sx->violated, all = lp->cols + lp->follow;
    kern_real size, least;
    int j;
    kern_copy(sx->price, sx->slope, lp->rows);
    if (costs && !lp->cost && !lp->follow)
        return 0;
    kern_basis_solve_t(sx, sx->price);
    if (fine)
        kern_prices_mend(sx, sx->price, KERN_R(0));
    size = kern_largest(sx->price, lp->rows);
    least = costs || !(lp->most > 0) ? KERN_NOISE * size : sum / lp->most;
    least = kern_max(least, KERN_ROUNDING * size);
    sx->gain = KERN_R(0);
    for (j = 0; j < all; j++) {
        kern_real d;
        if (sx->place[j] != KERN_OUT)
            continue;
        d = (costs ? kern_lp_worth(lp, j) : KERN_R(0))
          - kern_lp_dot(lp, j, sx->price);
        if (d > sx->gain) {
            sx->enters = j;
            sx->gain = d;
            if (first && d > least)
                break;
        }
    }
    return sx->gain > least;
}

/* How much the slope of the sum rises when the basic variable of row p, which
   falls at the rate alpha, passes zero, and in `at` where that is. What
   violates may move towards zero only, what must be zero leaves it at once. */
static kern_real kern_break(const kern_simplex *sx, int p, kern_real *at)
{
    const int fixed = kern_lp_fixed(sx->lp, sx->base[p]);
    const kern_real a = sx->alpha[p];
    const kern_real falls = sx->violated ? -sx->slope[p] * a : KERN_R(0);
    if (falls < 0 || (!fixed && a < 0 && !(falls > 0)))
        return KERN_R(0);
    *at = falls > 0 ? sx->value[p] / a
        : fixed     ? KERN_R(0)
                    : kern_max(sx->value[p], KERN_R(0)) / a;
    return fixed ? kern_abs(a) + falls : kern_abs(a);
}

/* Counts work on a program that is about to be done; 0: it is refused. */
static int kern_lp_spend(const kern_program *lp, int units)
{
    return kern_spend(lp->work, lp->limit, units);
}

/* The row that the entering column takes, and how far it goes, from those whose
   variables reach zero on the way. The ratio test goes on past every one as
   long as the sum of violations still falls: a long step, which passes through
   degenerate corners. With `first`, and for costs, it stops at once. Of equals
   it takes the largest pivot, with `first` the least index (Bland). Where its
   work is refused, so is the pivot. */
static int kern_leaving(kern_simplex *sx, int first, kern_real *step)
{
    const kern_real least = KERN_NOISE * kern_largest(sx->alpha, sx->lp->rows);
    kern_real *at = sx->ratio, left = sx->gain;
    int *list = sx->list, i, n = 0, best = KERN_OUT, next, seen = 0;
    for (i = 0; i < sx->lp->rows; i++)
        if (kern_abs(sx->alpha[i]) > least) {
            list[n] = i;
            n += kern_break(sx, i, at + n) > 0;
        }
    for (; n > 0 && left > 2 * KERN_ROUNDING * sx->gain; n--) {
        seen += n;
        next = 0;
        for (i = 1; i < n; i++)
            if (at[i] < at[next]
                || (at[i] <= at[next]
                    && (first ? sx->base[list[i]] < sx->base[list[next]]
                              : kern_abs(sx->alpha[list[i]])
                                    > kern_abs(sx->alpha[list[next]]))))
                next = i;
        best = list[next];
        left -= kern_break(sx, best, step);
        if (first || !sx->violated)
            break;
        at[next] = at[n - 1];
        list[next] = list[n - 1];
    }
    kern_lp_spend(sx->lp, seen / (2 * KERN_UNIT));
    return best;
}

/* Counts a pivot: a column, prices, what both cost of factors; 0: refused. */
static int kern_pivot_spend(const kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    return kern_lp_spend(
        lp,
        1
            + (sx->factors.first[sx->factors.count] + 6 * sx->factors.groups)
                  / KERN_UNIT
            + (lp->ends ? 4 * lp->cols / (3 * KERN_UNIT)
                        : lp->rows * (lp->cols / (4 * KERN_UNIT))));
}

/* Lowers the sum of violations, then the costs, until no column does. The sum
   falls with every step that is not of length zero, unless prices are rounding:
   when the budget is used up they are refined; beyond five the smallest indices
   are taken (Bland), which cannot cycle. The limit ends what rounding might
   keep going. Returns KERN_LP_OPTIMAL, KERN_LP_INFEASIBLE, KERN_LP_UNBOUNDED:
   the last column may grow for ever; or where there is no room or no work left
   for a pivot, KERN_NO_SPACE or KERN_LIMIT. */
static kern_status kern_simplex_run(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const int limit = 200 + 20 * (lp->rows + lp->cols);
    const int budget = 50 + 2 * lp->rows;
    int count;
    for (count = 0; count < limit;) {
        const int fine = count > budget, first = count > 5 * budget;
        const int enters = kern_entering(sx, first, fine);
        kern_real step = KERN_R(0);
        int p = KERN_OUT;
        if (enters) {
            kern_basis_column(sx, sx->enters);
            p = kern_leaving(sx, first, &step);
        }
        if (p == KERN_OUT && !sx->refined) {
            kern_basis_renew(sx);
            continue;
        }
        if (!enters)
            return sx->violated ? KERN_LP_INFEASIBLE : KERN_LP_OPTIMAL;
        if (p == KERN_OUT)
            return sx->violated ? KERN_UNDECIDED : KERN_LP_UNBOUNDED;
        if (kern_basis_full(sx))
            return KERN_NO_SPACE;
        if (!kern_pivot_spend(sx))
            return KERN_LIMIT;
        kern_add(sx->value, -step, sx->alpha, lp->rows);
        if (sx->base[p] <= lp->cols)
            sx->place[sx->base[p]] = KERN_OUT;
        kern_basis_enter(sx, sx->enters, p);
        sx->value[p] = step;
        sx->refined = 0;
        lp->work->pivots++;
        count++;
        KERN_AUDIT(simplex, sx);
        if (kern_basis_full(sx))
            kern_basis_renew(sx);
    }
    return KERN_UNDECIDED;
}

/* ---- opening, starting, reading ---- */

/* Lays out the arrays of a simplex, with room for so many entries. */
static void kern_simplex_lay(kern_simplex *sx, const kern_program *lp, int room,
                             kern_take *take)
{
    const int m = lp->rows;
    kern_factors *f = &sx->factors;
    sx->lp = lp;
    sx->state = KERN_BASIS_NONE;
    f->size = m + 2 - (m + 2) % 3;
    f->groups = lp->ends ? m / 3 : 0;
    f->room = room;
    f->most = 2 * m + 8;
    f->to = kern_take_ints(take, 3 * f->groups);
    f->pivot = kern_take_ints(take, f->most);
    f->from = kern_take_ints(take, f->most);
    f->first = kern_take_ints(take, f->most + 1);
    f->block = kern_take_reals(take, 18 * f->groups);
    f->entry = kern_take_reals(take, room);
    sx->base = kern_take_ints(take, m);
    sx->place = kern_take_ints(take, lp->cols + 1);
    sx->list = kern_take_ints(take, m + 1);
    sx->value = kern_take_reals(take, m);
    sx->slope = kern_take_reals(take, m);
    sx->alpha = kern_take_reals(take, f->size + 3);
    sx->price = kern_take_reals(take, f->size + 3);
    sx->ratio = kern_take_reals(take, m);
}

/* The next program begins without a basis, or from the same, factored anew. */
static void kern_simplex_change(kern_simplex *sx, kern_basis to)
{
    if (sx->state > to)
        sx->state = to;
}

#ifdef KERN_USE_GLPK
#define KERN_LP_H_ALLOWED
#include "kern_lp.h"
#endif

/* x := v, of the basis, as variables. */
static void kern_basis_read(const kern_simplex *sx, const kern_real *v,
                            kern_real *x)
{
    int i;
    kern_zero(x, sx->lp->cols + sx->lp->follow);
    for (i = 0; i < sx->lp->rows; i++)
        if (!kern_lp_fixed(sx->lp, sx->base[i]))
            x[sx->base[i]] = v[i];
}

/* x := what v, which is scratch, adds to rhs, in terms of the basis, if any. */
static int kern_simplex_along(kern_simplex *sx, kern_real *v, kern_real *x)
{
    if (sx->state == KERN_BASIS_NONE)
        return 0;
    kern_basis_solve(sx, v);
    kern_basis_read(sx, v, x);
    return 1;
}

/* The one entry of the engine. Starts from the last basis, or that of
   kern_simplex_crash(). x is written for every verdict: one that falls leaves
   A x = rhs in it, with what is negative about it, which tells how the verdict
   changes with the matrix. y is a certificate for KERN_LP_INFEASIBLE, less the
   prices for KERN_LP_OPTIMAL. `builtin` keeps it from the backend. */
static kern_status kern_program_solve(kern_simplex *sx, int builtin,
                                      kern_real *x, kern_real *y)
{
    const kern_program *lp = sx->lp;
    kern_status status;
    lp->work->solves++;
#ifdef KERN_USE_GLPK
    if (!builtin && !lp->follow && lp->rows > KERN_GLPK_ROWS) {
        kern_simplex_change(sx, KERN_BASIS_NONE);
        return kern_lp_glpk(lp, x, y);
    }
#endif
    (void)builtin;
    sx->least = KERN_NOISE * kern_largest(lp->rhs, lp->rows);
    if (sx->state != KERN_BASIS_READY
        && !kern_lp_spend(lp, lp->ends ? (lp->rows + lp->cols) / 2
                                       : lp->rows * (lp->cols / KERN_UNIT)))
        return KERN_LIMIT;
    if (sx->state == KERN_BASIS_NONE)
        kern_simplex_crash(sx);
    kern_basis_renew(sx);
    status = kern_pivot_spend(sx) ? kern_simplex_run(sx) : KERN_LIMIT;
    kern_basis_read(sx, sx->value, x);
    kern_copy(y, sx->price, lp->rows);
    return status;
}

/* To 0, of n numbers: those below a share of the largest; `sign`: negative. */
KERN_SHARED static void kern_lp_clean(kern_real *v, int n, kern_real share,
                                      int sign)
{
    const kern_real least = share * kern_largest(v, n);
    int i;
    for (i = 0; i < n; i++)
        if (!(kern_abs(v[i]) > least) || (sign && v[i] < 0))
            v[i] = KERN_R(0);
}

/* from plus the sum of u v over n numbers, those of v so far apart, as a share
   of all terms; not a number where one is not. */
static kern_real kern_lp_sum(kern_real from, const kern_real *u,
                             const kern_real *v, int apart, int n)
{
    kern_real terms = kern_abs(from);
    for (; n > 0; n--, v += apart) {
        const kern_real term = *u++ * *v;
        from += term;
        terms += kern_abs(term);
    }
    return terms > 0 ? from / terms + (terms - terms) : from;
}

/* Whether x and y prove the status by products with the matrix alone, each row
   and column to KERN_TOL of its own terms. What is not a number proves nothing.

       optimal      A x = rhs,  cost + y A >= 0, = 0 where x > 0
       infeasible   y A >= 0,  y.rhs < 0
       unbounded    A x = 0,  cost.x < 0                                      */
static int kern_lp_holds(const kern_program *lp, const kern_real *x,
                         const kern_real *y, kern_status status)
{
    const int m = lp->rows, best = status == KERN_LP_OPTIMAL;
    int i, j;
    for (i = 0; i < m && status != KERN_LP_INFEASIBLE; i++) {
        const kern_real left = kern_lp_sum(best ? -lp->rhs[i] : KERN_R(0), x,
                                           lp->a + i, m, lp->cols);
        if (!(kern_abs(left) <= KERN_TOL))
            return 0;
    }
    for (j = 0; j < lp->cols && status != KERN_LP_UNBOUNDED; j++) {
        const kern_real left = kern_lp_sum(best && lp->cost ? lp->cost[j]
                                                            : KERN_R(0),
                                           y, kern_lp_dense(lp, j), 1, m);
        if (!(left >= -KERN_TOL) || (best && x[j] > 0 && left > KERN_TOL))
            return 0;
    }
    return best
        || (status == KERN_LP_INFEASIBLE
                ? kern_lp_sum(KERN_R(0), y, lp->rhs, 1, m)
                : kern_lp_sum(KERN_R(0), x, lp->cost, 1, lp->cols))
               < -KERN_TOL;
}

/* The same; where nothing else is in a row the last digits of x or y are all
   there is: if need be they are taken out. */
static int kern_lp_proven(const kern_program *lp, kern_real *x, kern_real *y,
                          kern_status status)
{
    int again;
    for (again = 0; again < 2; again++) {
        kern_lp_clean(x, lp->cols, KERN_R(again) * KERN_ROUNDING, 1);
        kern_lp_clean(y, lp->rows, KERN_R(again) * KERN_ROUNDING, 0);
        if (kern_lp_holds(lp, x, y, status))
            return 1;
    }
    return 0;
}

/* kern_lp_solve() of a program that has been checked. */
static kern_status kern_lp_run(const kern_lp *lp, kern_real *x, kern_real *y,
                               kern_work *work)
{
    const kern_program p = {lp->rows,  lp->cols,  lp->a, lp->rhs,
                            lp->cost,  NULL,      NULL,  0,
                            KERN_R(0), lp->limit, work};
    kern_simplex sx;
    kern_take take;
    kern_status status;
    int i;
    kern_take_open(&take, work);
    kern_simplex_lay(&sx, &p, KERN_LP_ROOM(p.rows), &take);
    if (!kern_take_fits(&take))
        return KERN_NO_SPACE;
    status = kern_program_solve(&sx, 0, x, y);
    if (work->units > kern_limit_of(p.limit))
        return KERN_LIMIT;
    if (status < 0)
        return status;
    if (status == KERN_LP_UNBOUNDED && sx.state != KERN_BASIS_NONE) {
        kern_scale(sx.alpha, p.rows, KERN_R(-1));
        kern_basis_read(&sx, sx.alpha, x);
        x[sx.enters] = KERN_R(1);
    }
    if (!kern_lp_proven(&p, x, y, status))
        return KERN_UNDECIDED;
    for (i = 0; i < p.rows && status == KERN_LP_OPTIMAL; i++)
        y[i] = 0 - y[i];
    return status;
}

KERN_API kern_status kern_lp_solve(const kern_lp *lp, kern_real *x,
                                   kern_real *y, kern_work *work)
{
    kern_status status;
    if (!work || !work->real || !work->index)
        return KERN_BAD_POINTER;
    kern_work_begin(work);
    status = x && y ? kern_lp_check(lp, &work->fault) : KERN_BAD_POINTER;
    return status == KERN_OK ? kern_lp_run(lp, x, y, work) : status;
}

/* ---- Contact law and skyline factor --------------------------- >>skyline */
/* What a contact answers to a motion (wn, wt) along n and t is linear between
   bends: f = nn wn + nt wt, r = nt wn + tt wt. A x = b then asks for a matrix
   with the pattern of the groups, which is factored (skyline Cholesky) in their
   order. Minimum-norm forces, >>ipm and >>raised differ in the law alone. */

/* A symmetric matrix of 3 x 3 blocks, a row of them a group, or its factor: of
   each row what lies from its first column to the diagonal (>>skyline). */
typedef struct kern_skyline {
    int groups;
    int *first;  /* of a row: its first block column             */
    int *offset; /* of a row: where it is stored                 */
    kern_real *entry;
} kern_skyline;

typedef struct kern_law {
    kern_real nn, nt, tt;
    kern_force force; /* in the cone to the last digit                */
} kern_law;

/* The law of a contact that answers what presses it by `stiff`, and what shears
   it by mu `along` times as much until it slides. With 2 and mu it is that of
   rays of stiffness 1 that only press. */
static inline kern_law kern_law_stiff(kern_real wn, kern_real wt, kern_real mu,
                                      kern_real stiff, kern_real along)
{
    const kern_real side = wt > 0 ? mu : -mu;
    kern_law s = {0, 0, 0, {0, 0}};
    if (wn > 0 && along * kern_abs(wt) <= wn) {
        s.nn = stiff;
        s.tt = along * mu * stiff;
        s.force.normal = stiff * wn;
        s.force.tangential = s.tt * wt;
    } else if (wn + side * wt > 0) {
        s.nn = stiff * along / (along + mu);
        s.nt = side * s.nn;
        s.tt = side * s.nt;
        s.force.normal = s.nn * (wn + side * wt);
        s.force.tangential = side * s.force.normal;
    }
    return s;
}

/* Takes room for the matrix of so many groups, with what the two groups of each
   of n contacts exert on each other: the later one's row reaches to the column
   of the other. Returns the products of a factor, if there is room: more than
   an int holds where a row is long. */
static kern_real kern_skyline_open(kern_skyline *a, int groups, const int *ends,
                                   int n, kern_take *take)
{
    kern_real products = KERN_R(0);
    int g, k, end = 0;
    a->groups = groups;
    a->first = kern_take_ints(take, 2 * groups);
    a->offset = a->first + groups;
    if (!kern_take_fits(take))
        return products;
    for (g = 0; g < groups; g++)
        a->first[g] = g;
    for (k = 0; k < 2 * n; k++) {
        const int high = ends[k], low = ends[k ^ 1];
        if (high < groups && low < a->first[high])
            a->first[high] = low;
    }
    for (g = 0; g < groups; g++) {
        const int width = g - a->first[g] + 1;
        a->offset[g] = end;
        end += 9 * width;
        products += 14 * KERN_R(width) * KERN_R(width);
    }
    a->entry = kern_take_reals(take, end);
    return products;
}

static void kern_skyline_clear(kern_skyline *a)
{
    int g;
    for (g = 0; g < a->groups; g++)
        kern_zero(a->entry + a->offset[g], 9 * (g - a->first[g] + 1));
}

/* Adds what the two groups of a contact exert on each other by its law: to the
   block of each, and to that in the row of the later one. What is fixed has the
   last number and no row. */
static void kern_skyline_law(kern_skyline *a, const int ends[2],
                             const kern_row row[2], const kern_law *s)
{
    kern_real v[3], w[3];
    int k;
    for (k = 0; k < 2; k++, row++) {
        const int g = ends[k], h = ends[1 - k];
        if (g < a->groups) {
            const kern_row *other = row + 1 - 2 * k;
            const int wide = 3 * (g - a->first[g] + 1);
            kern_real *to = a->entry + a->offset[g] + wide - 3;
            kern_row_wrench(row, s->nn, s->nt, v); /* it adds n v' + t w' */
            kern_row_wrench(row, s->nt, s->tt, w);
            kern_row_exert(row, v[0], w[0], to);
            kern_row_exert(row, v[1], w[1], to + wide);
            kern_row_exert(row, v[2], w[2], to + 2 * wide);
            if (g < h)
                continue;
            to += 3 * (h - g);
            kern_row_exert(other, v[0], w[0], to);
            kern_row_exert(other, v[1], w[1], to + wide);
            kern_row_exert(other, v[2], w[2], to + 2 * wide);
        }
    }
}

/* Adds a share of their mean to the entries of the diagonal. */
static void kern_skyline_shift(kern_skyline *a, kern_real share)
{
    kern_real trace = KERN_R(0), more = KERN_R(0);
    int g, k, add;
    for (add = 0; add < 2; add++) {
        for (g = 0; g < a->groups; g++) {
            const int length = 3 * (g - a->first[g] + 1);
            kern_real *d = a->entry + a->offset[g] + length - 3;
            for (k = 0; k < 3; k++, d += length + 1) {
                trace += *d;
                *d += more;
            }
        }
        more = share * trace / KERN_R(3 * a->groups);
    }
}

/* Takes from the 3 x 3 block c of rows a what rows a and b have in common in n
   columns. The rows are `wide_a` and `wide_b` apart. */
static void kern_skyline_common(kern_real *c, const kern_real *a, int wide_a,
                                const kern_real *b, int wide_b, int n)
{
    const kern_real *a1 = a + wide_a, *a2 = a1 + wide_a;
    const kern_real *b1 = b + wide_b, *b2 = b1 + wide_b;
    kern_real *c1 = c + wide_a, *c2 = c1 + wide_a;
    kern_real s00 = c[0], s01 = c[1], s02 = c[2];
    kern_real s10 = c1[0], s11 = c1[1], s12 = c1[2];
    kern_real s20 = c2[0], s21 = c2[1], s22 = c2[2];
    int i;
    for (i = 0; i < n; i++) {
        const kern_real x = b[i], y = b1[i], z = b2[i];
        s00 -= a[i] * x;
        s01 -= a[i] * y;
        s02 -= a[i] * z;
        s10 -= a1[i] * x;
        s11 -= a1[i] * y;
        s12 -= a1[i] * z;
        s20 -= a2[i] * x;
        s21 -= a2[i] * y;
        s22 -= a2[i] * z;
    }
    c[0] = s00;
    c[1] = s01;
    c[2] = s02;
    c1[0] = s10;
    c1[1] = s11;
    c1[2] = s12;
    c2[0] = s20;
    c2[1] = s21;
    c2[2] = s22;
}

/* Cholesky's L of the matrix in its place; a pivot is at least rounding. */
static void kern_skyline_factor(kern_skyline *a)
{
    int g, h, r, k;
    for (g = 0; g < a->groups; g++) {
        const int wide = 3 * (g - a->first[g] + 1);
        kern_real *row = a->entry + a->offset[g], *d = row + wide - 3;
        const kern_real was[3] = {d[0], d[wide + 1], d[2 * wide + 2]};
        for (h = a->first[g]; h <= g; h++) {
            const int from = a->first[g] > a->first[h] ? a->first[g]
                                                       : a->first[h];
            const int wide_h = 3 * (h - a->first[h] + 1);
            const kern_real *other = a->entry + a->offset[h];
            const kern_real *l = other + wide_h - 3;
            kern_real *c = row + 3 * (h - a->first[g]);
            kern_skyline_common(c, row + 3 * (from - a->first[g]), wide,
                                other + 3 * (from - a->first[h]), wide_h,
                                3 * (h - from));
            for (r = 0; r < 3; r++, c += wide) {
                if (h < g || r > 0)
                    c[0] /= l[0];
                if (h < g || r > 1)
                    c[1] = (c[1] - c[0] * l[wide_h]) / l[wide_h + 1];
                if (h < g) {
                    c[2] = (c[2] - c[0] * l[2 * wide_h]
                            - c[1] * l[2 * wide_h + 1])
                         / l[2 * wide_h + 2];
                    continue;
                }
                for (k = 0; k < r; k++)
                    c[r] -= c[k] * c[k];
                c[r] = KERN_SQRT(
                    kern_max(c[r], KERN_EPS * (KERN_EPS + was[r])));
            }
        }
    }
    KERN_AUDIT(factor, a);
}

/* out := the solution of matrix times it = b, by the factor, row by row. */
static void kern_skyline_solve(const kern_skyline *a, const kern_real *b,
                               kern_real *out)
{
    const int n = 3 * a->groups;
    int i;
    for (i = 0; i < n; i++) {
        const int from = 3 * a->first[i / 3], wide = 3 * (i / 3) + 3 - from;
        const kern_real *row = a->entry + a->offset[i / 3] + i % 3 * wide;
        out[i] = (b[i] - kern_dot(row, out + from, i - from)) / row[i - from];
    }
    for (i = n - 1; i >= 0; i--) {
        const int from = 3 * a->first[i / 3], wide = 3 * (i / 3) + 3 - from;
        const kern_real *row = a->entry + a->offset[i / 3] + i % 3 * wide;
        out[i] /= row[i - from];
        kern_add(out + from, -out[i], row, i - from);
    }
}

/* ---- Parts ------------------------------------------------------ >>part */
/* Some of the groups with all contacts that touch them, all other blocks held.
   What is held can exert whatever is needed, so where a part falls the whole
   falls: the motion of the part, and none of the others, proves it. */

/* Minimum-norm forces of a part, by Newton's method on their dual (>>norm). */
typedef struct kern_dual {
    kern_skyline matrix; /* of the contacts that carry                   */
    kern_real *u, *step, *grad; /* three a group, and three of 0              */
    kern_real *b;          /* loads, three a group                         */
    kern_real *way, *turn; /* two a contact: u and step along n and t      */
    kern_real *price;      /* then stiffness, of contacts: >>raised; NULL  */
    kern_real stiff;       /* along t, in stiffnesses along n              */
    int cost;              /* of a step, in units of work                  */
} kern_dual;

/* Eq. (5) of a part as a linear program: see >>verdict. */
typedef struct kern_equations {
    kern_real *arc, *rhs;
    kern_real *rate;  /* less that of rhs along a path                */
    kern_real shrink; /* of its columns                               */
    kern_program lp;
    kern_simplex simplex;
} kern_equations;

typedef struct kern_part {
    kern_dual dual;
    kern_model *m;
    int groups, contacts;
    int own;           /* contacts that carry a group of the part come
                                 first, then those by which others rest on it */
    int *group;        /* of the part; ascending but in >>norm        */
    int *contact;      /* of the part                                  */
    int *ends;         /* of a contact: groups of the part, or none    */
    kern_real *x, *y;  /* two a contact: forces, and how far the place
                                 grows; three a group: motion                 */
    kern_status found; /* what the program said, proven or not         */
    kern_real ahead;   /* where it may stop to fall: >>search          */
    kern_take rest;    /* work memory behind these                     */
    kern_equations eq;
} kern_part;

/* Lists the groups of the part at the ends of its contacts; 0: no room. */
static int kern_part_ends(kern_part *p)
{
    const kern_model *m = p->m;
    int k;
    p->ends = kern_take_ints(&p->rest, 2 * p->contacts);
    for (k = 0; k < 2 * p->contacts && kern_take_fits(&p->rest); k++) {
        const int g = m->graph.ends[2 * p->contact[k >> 1] + (k & 1)];
        p->ends[k] = m->graph.local[g] == KERN_OUT ? p->groups
                                                   : m->graph.local[g];
    }
    return kern_take_fits(&p->rest);
}

/* Lists the part's contacts: those that carry its groups, then those above. */
static void kern_part_list(kern_part *p)
{
    const kern_model *m = p->m;
    int own, n, e;
    p->contacts = 0;
    p->contact = kern_take_ints(&p->rest, 0);
    for (own = 1; own >= 0; own--) {
        for (n = 0; n < p->groups; n++) {
            const int g = p->group[n];
            for (e = m->graph.touch[g]; e >= 0; e = m->graph.after[e]) {
                const int other = m->graph.ends[e ^ 1];
                if (own ? other > g
                        : other < g && m->graph.local[other] == KERN_OUT) {
                    int *const to = kern_take_ints(&p->rest, 1);
                    if (!kern_take_fits(&p->rest))
                        return;
                    *to = e >> 1;
                    p->contacts++;
                }
            }
        }
        if (own)
            p->own = p->contacts;
    }
}

/* Three loads of a query a group, in units of force, as all of a part's
   program. Returns what equilibrium may miss. */
static kern_real kern_part_load(const kern_part *p, const kern_query *q,
                                kern_real *to)
{
    kern_model *m = p->m;
    kern_real least = KERN_INFINITY;
    int n;
    for (n = 0; n < p->groups; n++) {
        const int g = p->group[n];
        kern_model_load(m, q, g);
        least = kern_min(least, m->size[g]);
        kern_copy(to + 3 * n, m->load + 3 * g, 3);
    }
    kern_scale(to, 3 * p->groups, 1 / m->weight);
    return KERN_NOISE * least / m->weight;
}

/* Takes the lists of a part's groups; 0 if there is no room. */
static int kern_part_begin(kern_part *p, kern_model *m, int groups,
                           const kern_take *rest)
{
    p->m = m;
    p->rest = *rest;
    p->groups = groups;
    p->ahead = KERN_R(0);
    p->found = KERN_UNDECIDED;
    p->group = kern_take_ints(&p->rest, groups);
    return kern_take_fits(&p->rest);
}

/* Opens the part of the `groups` groups that graph.local marks, the last of
   which is `last`. Returns 0 if the work memory does not hold it. */
static int kern_part_open(kern_part *p, kern_model *m, int groups, int last)
{
    int g, n = groups;
    KERN_ASSERT(groups > 0 && !m->whole);
    if (!kern_part_begin(p, m, groups, &m->rest))
        return 0;
    for (g = last; n > 0; g--)
        if (m->graph.local[g] != KERN_OUT) {
            m->graph.local[g] = --n;
            p->group[n] = g;
        }
    kern_part_list(p);
    if (!kern_part_ends(p))
        return 0;
    KERN_AUDIT(part, p);
    return 1;
}

/* y as a motion of the part. */
static void kern_part_motion(kern_part *p)
{
    kern_model *m = p->m;
    int n;
    kern_zero(m->answer.motion, 3 * m->s->blocks);
    for (n = 0; n < p->groups; n++) {
        kern_motion *v = m->answer.motion + m->graph.block[p->group[n]];
        kern_copy(v, p->y + 3 * n, 3);
        v->spin *= m->unit[p->group[n]];
    }
    kern_motion_scale(m->s, m->answer.motion);
}

/* Writes y as a motion: whether it proves that the part falls. */
static int kern_part_falls(kern_part *p, const kern_query *q)
{
    const kern_model *m = p->m;
    kern_part_motion(p);
    return kern_model_proven(m, kern_prove_motion(m->s, q, m->answer.motion));
}

/* The forces of a program of all groups; 0 where rounding made them less. */
static void kern_part_forces(kern_part *p)
{
    kern_model *m = p->m;
    int k;
    kern_model_unload(m);
    for (k = 0; k < p->contacts; k++) {
        const kern_real x1 = kern_max(p->x[2 * k], KERN_R(0)) * m->weight;
        const kern_real x2 = kern_max(p->x[2 * k + 1], KERN_R(0)) * m->weight;
        const int i = p->contact[k];
        m->answer.force[i].normal = x1 + x2;
        m->answer.force[i].tangential = kern_model_mu(m, i) * (x1 - x2);
    }
}

/* Writes these forces: whether they prove that all stands. */
static int kern_part_stands(kern_part *p, const kern_query *q)
{
    kern_part_forces(p);
    return kern_answer_holds(p->m, q);
}

/* ---- Minimum-norm forces ----------------------------------------- >>norm */
/* Minimum-norm forces of a part, by a dual Newton method:

       min |x|^2 / 2,  A x = b,  x >= 0.

   The dual, max b.u - |max(0, A'u)|^2 / 2, has three unknowns a group, is
   concave and of piecewise constant curvature; x = max(0, A'u). Newton's method
   ends after a few steps; its matrix is A_S A_S' of the rays S that press.
   Where no forces exist the dual grows without limit. */

/* The approach of contact i at which its law exerts the force of the answer.
   Newton's method begins there, and finds the least change of the forces. */
static inline kern_real kern_model_prior(const kern_model *m, int i,
                                         kern_real way[2])
{
    const kern_force *f = m->answer.force + i;
    const kern_real mu = kern_model_mu(m, i);
    way[0] = f->normal / 2;
    way[1] = mu > 0 ? f->tangential / (2 * mu * mu) : KERN_R(0);
    return mu;
}

/* The contact law of the part's contact k at (wn, wt). */
static inline kern_law kern_part_law(const kern_part *p, int k, kern_real wn,
                                     kern_real wt)
{
    const kern_real mu = kern_model_mu(p->m, p->contact[k]);
    const kern_real *price = p->dual.price;
    return kern_law_stiff(wn, wt, mu,
                          price ? price[p->contacts + k] : KERN_R(2),
                          price ? p->dual.stiff : mu);
}

/* Lays out the arrays for the part's minimum-norm forces; 0: no room. */
static int kern_norm_lay(kern_part *p, kern_take *take)
{
    const int n = 3 * p->groups + 3;
    kern_real products = KERN_R(100) * KERN_R(p->contacts);
    p->dual.price = NULL;
    p->dual.u = kern_take_reals(take, 4 * n + 4 * p->contacts);
    p->dual.step = p->dual.u + n;
    p->dual.grad = p->dual.step + n;
    p->dual.b = p->dual.grad + n;
    p->dual.way = p->dual.b + n;
    p->dual.turn = p->dual.way + 2 * p->contacts;
    products += kern_skyline_open(&p->dual.matrix, p->groups, p->ends, p->own,
                                  take);
    p->dual.cost = 1
                 + (int)kern_min(products / KERN_R(8 * KERN_UNIT / 3),
                                 KERN_R(KERN_WORK_MOST));
    return kern_take_fits(take);
}

/* The rows of the part's contact k at its two ends. */
static inline void kern_part_rows(const kern_part *p, int k, kern_row row[2])
{
    row[0] = kern_model_row(p->m, 2 * p->contact[k]);
    row[1] = kern_model_row(p->m, 2 * p->contact[k] + 1);
}

/* w += the approach of the part's contact k along n and t by the motion v. The
   difference of velocities is formed first: a rigid motion gives exactly 0. */
static inline void kern_part_speed(const kern_part *p, int k,
                                   const kern_real *v, kern_real *w)
{
    const kern_real *h = v + 3 * p->ends[2 * k];
    const kern_real *t = v + 3 * p->ends[2 * k + 1];
    const kern_real apart[3] = {h[0] - t[0], h[1] - t[1], h[2]};
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_row_speed(row, apart, w);
    w[0] += row[1].n[2] * t[2];
    w[1] += row[1].turn * t[2];
}

/* b += the wrenches of contact k of the part by f along n and r along t. Those
   on held blocks go to the last three numbers. */
static inline void kern_part_exert(const kern_part *p, int k, kern_real f,
                                   kern_real r, kern_real *b)
{
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_row_exert(row, f, r, b + 3 * p->ends[2 * k]);
    kern_row_exert(row + 1, f, r, b + 3 * p->ends[2 * k + 1]);
}

/* Approach of contacts along n and t: by u and the prior forces, or a step. */
KERN_SHARED static void kern_norm_ways(kern_part *p, int step)
{
    kern_real *way = step ? p->dual.turn : p->dual.way;
    int k;
    for (k = 0; k < p->own; k++, way += 2) {
        way[0] = way[1] = KERN_R(0);
        if (!step && p->dual.price)
            way[0] = -p->dual.price[k];
        else if (!step)
            kern_model_prior(p->m, p->contact[k], way);
        kern_part_speed(p, k, step ? p->dual.step : p->dual.u, way);
    }
}

/* Writes the gradient of the dual at u: b less what the forces of u exert.
   Returns the dual's value, and in *most the largest force. */
static kern_real kern_norm_gradient(kern_part *p, kern_real *most)
{
    const int n = 3 * p->groups;
    kern_real value = kern_dot(p->dual.b, p->dual.u, n);
    int k;
    *most = KERN_R(0);
    kern_copy(p->dual.grad, p->dual.b, n);
    for (k = 0; k < p->own; k++) {
        const kern_real *w = p->dual.way + 2 * (size_t)k;
        const kern_law s = kern_part_law(p, k, w[0], w[1]);
        const kern_real f = s.force.normal, r = s.force.tangential;
        if (!(f > 0))
            continue;
        *most = kern_max(*most, f);
        value -= (f * w[0] + r * w[1]) / 2;
        kern_part_exert(p, k, -f, -r, p->dual.grad);
    }
    kern_zero(p->dual.grad + n, 3);
    return value;
}

/* Adds what contact k of the part answers by a law to the matrix. */
static void kern_part_add(kern_part *p, int k, const kern_law *s)
{
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_skyline_law(&p->dual.matrix, p->ends + 2 * (size_t)k, row, s);
}

/* The matrix of what presses at u, or of all, with more on its diagonal. */
static void kern_norm_matrix(kern_part *p, int all)
{
    kern_skyline *a = &p->dual.matrix;
    int k;
    kern_skyline_clear(a);
    for (k = 0; k < p->own; k++) {
        const kern_real *w = p->dual.way + 2 * (size_t)k;
        kern_law s = kern_part_law(p, k, w[0], w[1]);
        if (all && (p->dual.price || !(s.nn > 0)))
            s = kern_part_law(p, k, KERN_R(1), KERN_R(0));
        if (all && p->dual.price) /* as stiff along t for every friction */
            s.tt = p->dual.stiff * s.nn;
        if (s.nn > 0)
            kern_part_add(p, k, &s);
    }
    kern_skyline_shift(a, KERN_ROUNDING);
}

/* The dual's derivative at u + share * step, along it; `push`: the loads'. */
static kern_real kern_norm_slope(const kern_part *p, kern_real push,
                                 kern_real share)
{
    int k;
    for (k = 0; k < p->own; k++) {
        const kern_real *w = p->dual.way + 2 * k, *d = p->dual.turn + 2 * k;
        const kern_law s = kern_part_law(p, k, w[0] + share * d[0],
                                         w[1] + share * d[1]);
        push -= s.force.normal * d[0] + s.force.tangential * d[1];
    }
    return push;
}

/* Line search: the share of the step at which the dual is largest, to an eighth
   of its derivative; with prices to a thousandth, since the next round begins
   there, and a place is work. The dual is concave: regula falsi. */
KERN_SHARED static kern_real kern_norm_share(const kern_part *p)
{
    const kern_real push = kern_dot(p->dual.b, p->dual.step, 3 * p->groups);
    const kern_real first = kern_dot(p->dual.grad, p->dual.step, 3 * p->groups);
    const kern_real least = first / (p->dual.price ? 1000 : 8);
    kern_real lo = KERN_R(0), at_lo = first, hi = KERN_INFINITY, at_hi = lo;
    kern_real at = KERN_R(1);
    int round;
    for (round = 0; round < (hi < KERN_INFINITY ? 20 : 13); round++) {
        kern_real slope;
        if (round > 0)
            at = hi < KERN_INFINITY
                   ? (hi * at_lo - lo * at_hi) / (at_lo - at_hi)
                   : 4 * at;
        slope = kern_norm_slope(p, push, at);
        if (kern_abs(slope) <= least
            || (p->dual.price && !kern_model_spend(p->m, (p->own + 12) / 16)))
            break;
        if (slope > 0) {
            at_hi /= 3; /* else the other end may stay for long */
            lo = at;
            at_lo = slope;
        } else {
            hi = at;
            at_hi = slope;
        }
    }
    return at;
}

/* Minimum-norm forces of a part's own contacts under the loads p->dual.b, by
   rounds [first, end); after round 0 u goes on from what it is. KERN_STANDS
   with u; KERN_FALLS, unproven, where `bound` is exceeded; KERN_UNDECIDED. */
static kern_status kern_norm_find(kern_part *p, kern_real tolerance,
                                  kern_real bound, int first, int end)
{
    const int n = 3 * p->groups;
    int i, round;
    for (i = first == 0 ? 0 : n; i < n + 3; i++)
        p->dual.u[i] = p->dual.step[i] = KERN_R(0);
    kern_norm_ways(p, 0);
    for (round = first; round < end; round++) {
        kern_real most, share;
        const kern_real value = kern_norm_gradient(p, &most);
        if (kern_largest(p->dual.grad, n) <= tolerance + 4 * KERN_EPS * most)
            return KERN_STANDS;
        if (!(value <= bound * bound / 2))
            return KERN_FALLS;
        if (!kern_model_spend(p->m, p->dual.cost))
            return KERN_LIMIT;
        kern_norm_matrix(p, round == 0);
        kern_skyline_factor(&p->dual.matrix);
        kern_skyline_solve(&p->dual.matrix, p->dual.grad, p->dual.step);
        kern_norm_ways(p, 1);
        share = round == 0 ? KERN_R(1) : kern_norm_share(p);
        kern_add(p->dual.u, share, p->dual.step, n);
        kern_add(p->dual.way, share, p->dual.turn, 2 * p->own);
    }
    return KERN_UNDECIDED;
}

/* Of how many contacts group g is an end. */
static int kern_graph_degree(const kern_graph *graph, int g)
{
    int e = graph->touch[g], n = 0;
    for (; e >= 0; e = graph->after[e])
        n++;
    return n;
}

/* Lists the groups that contacts connect to `first`, from place n of the part
   down: of each listed group the neighbours that are not yet, those of fewer
   contacts first. Returns the place below the last. */
static int kern_norm_layers(kern_part *p, int first, int n)
{
    const kern_graph *graph = &p->m->graph;
    int at = n, from, e, k;
    graph->local[first] = 0;
    p->group[n--] = first;
    for (; at > n; at--) {
        from = n;
        for (e = graph->touch[p->group[at]]; e >= 0; e = graph->after[e]) {
            const int g = graph->ends[e ^ 1];
            if (g == p->groups || graph->local[g] != KERN_OUT)
                continue;
            graph->local[g] = 0;
            for (k = n--; k < from
                          && kern_graph_degree(graph, g)
                                 < kern_graph_degree(graph, p->group[k + 1]);
                 k++)
                p->group[k] = p->group[k + 1];
            p->group[k] = g;
        }
    }
    return n;
}

/* Orders the groups that are not marked, which are the part then, for short
   rows of the factor: in layers around one of the last layer around another,
   from the last place down (reverse Cuthill-McKee). */
static void kern_norm_order(kern_part *p)
{
    int *local = p->m->graph.local;
    int g, k, n = p->groups - 1;
    for (g = 0; g < p->groups; g++)
        if (local[g] == KERN_OUT) {
            const int end = kern_norm_layers(p, g, n);
            for (k = n; k > end; k--)
                local[p->group[k]] = KERN_OUT;
            n = kern_norm_layers(p, p->group[end + 1], n);
        }
    p->group += ++n;
    p->groups -= n;
    for (g = 0; g < p->groups; g++)
        local[p->group[g]] = g;
}

/* Opens all groups that are not marked as one part; 0: no room. */
static int kern_norm_open(kern_part *p, kern_model *m)
{
    const int *local = m->graph.local;
    int i;
    if (!kern_model_spend(m, 1 + (m->graph.groups + m->s->contacts) / 4))
        return 0;
    kern_part_begin(p, m, m->graph.groups, &m->rest);
    p->contact = kern_take_ints(&p->rest, m->s->contacts);
    if (!kern_take_fits(&p->rest))
        return 0;
    kern_norm_order(p);
    p->contacts = 0;
    for (i = 0; i < m->s->contacts; i++)
        if (local[m->graph.ends[2 * i]] != local[m->graph.ends[2 * i + 1]])
            p->contact[p->contacts++] = i;
    p->own = p->contacts;
    return kern_part_ends(p) && kern_norm_lay(p, &p->rest);
}

/* Writes the forces of u. */
static void kern_norm_write(kern_part *p)
{
    kern_model *m = p->m;
    int k;
    kern_model_unload(m);
    for (k = 0; k < p->contacts; k++) {
        const kern_real *w = p->dual.way + 2 * (size_t)k;
        m->answer.force[p->contact[k]] = kern_part_law(p, k, w[0], w[1]).force;
    }
    kern_scale(m->answer.force, 2 * m->s->contacts, m->weight);
}

/* ---- The top-down pass ------------------------------------------- >>pass */
/* The pass balances the groups from top to bottom. A group passes its load, and
   what rests on it, on to the contacts that carry it: by the least change of
   their forces, in three unknowns. A group that cannot do so alone forms a
   cluster with the groups that rest on it. A group whose load changes is
   balanced again. Forces that balance every group prove that the structure
   stands. Where a cluster cannot be balanced, and its motion parts it from all
   that rests on it, no forces from above could hold it: it is a part that
   falls.

   The outcome of a cluster, or of the whole pass: KERN_STANDS, its groups are
   balanced; KERN_FALLS, a part that seems to fall is open; KERN_UNDECIDED, it
   is out of work memory or budget. */

/* The cluster of a group must be balanced. */
static void kern_pass_mark_open(kern_model *m, int g)
{
    const int last = m->cluster.last[g];
    m->cluster.open[last] |= KERN_OPEN;
    if (last < m->cluster.at)
        m->cluster.at = last;
}

/* Writes the force of contact i. Where it changed `on` is balanced again. */
static void kern_pass_write(kern_model *m, int i, int on, kern_force f,
                            kern_real tolerance)
{
    kern_force *to = m->answer.force + i;
    const kern_real change = kern_abs(f.normal - to->normal)
                           + kern_abs(f.tangential - to->tangential);
    if (on < m->graph.groups && change > tolerance)
        kern_pass_mark_open(m, on);
    *to = f;
}

/* x := H^-1 b for the lower half of a symmetric 3 x 3 matrix h. The unknown of
   a pivot that is rounding becomes 0. Returns whether no pivot is small. */
static int kern_pass_three(const kern_real h[9], const kern_real b[3],
                           kern_real x[3])
{
    const kern_real least = KERN_THREE_TOL * (h[0] + h[4] + h[8]);
    const kern_real i0 = h[0] > least ? 1 / h[0] : KERN_R(0);
    const kern_real l1 = h[3] * i0, l3 = h[6] * i0;
    const kern_real d1 = h[4] - l1 * h[3], e = h[7] - l3 * h[3];
    const kern_real i1 = d1 > least ? 1 / d1 : KERN_R(0);
    const kern_real l4 = e * i1, d2 = h[8] - l3 * h[6] - l4 * e;
    const kern_real i2 = d2 > least ? 1 / d2 : KERN_R(0);
    const kern_real y1 = b[1] - l1 * b[0], y2 = b[2] - l3 * b[0] - l4 * y1;
    x[2] = y2 * i2;
    x[1] = y1 * i1 - l4 * x[2];
    x[0] = b[0] * i0 - l1 * x[1] - l3 * x[2];
    return kern_min(d1, d2) > KERN_PIVOT * (h[0] + h[4] + h[8]);
}

typedef struct kern_ray { /* an edge of a friction cone at the group      */
    kern_real a[3];       /* wrench of a unit of force along it           */
    kern_real x;          /* its force; below 0: none                     */
    int press;            /* nonzero: it is among those that carry        */
} kern_ray;

/* The two rays of a row, with the forces of its motion along n and t. */
static inline void kern_ray_pair(kern_ray *to, const kern_row *row,
                                 kern_real mu, const kern_real way[2])
{
    const kern_real more = mu * way[1];
    kern_row_wrench(row, KERN_R(1), mu, to[0].a);
    kern_row_wrench(row, KERN_R(1), -mu, to[1].a);
    to[0].x = way[0] + more;
    to[1].x = way[0] - more;
    to[0].press = to[1].press = 1;
}

/* b less what the rays exert that press; and the matrix of these. */
static void kern_ray_sum(const kern_ray *c, int n, const kern_real b[3],
                         kern_real left[3], kern_real h[9])
{
    kern_zero(h, 9);
    left[0] = b[0];
    left[1] = b[1];
    left[2] = b[2];
    for (; n > 0; n--, c++) {
        const kern_real *a = c->a, x = c->x;
        if (!c->press)
            continue;
        left[0] -= a[0] * x;
        left[1] -= a[1] * x;
        left[2] -= a[2] * x;
        h[0] += a[0] * a[0];
        h[3] += a[1] * a[0];
        h[4] += a[1] * a[1];
        h[6] += a[2] * a[0];
        h[7] += a[2] * a[1];
        h[8] += a[2] * a[2];
    }
}

/* The least change that makes the rays exert b, by Newton's method with full
   steps. KERN_FALLS: something is left; KERN_UNDECIDED: it does not end. */
static kern_status kern_pass_solve(kern_ray *c, int n, const kern_real b[3],
                                   kern_real tolerance)
{
    kern_real left[3], h[9], step[3], u[3] = {0, 0, 0}, last = KERN_INFINITY;
    int k, round, same = 0; /* nonzero: the same rays press as before */
    for (round = 0; round < KERN_FEW_ROUNDS + 2; round++) {
        const kern_real before = last / 8;
        int good, changed = 0;
        kern_ray_sum(c, n, b, left, h);
        last = kern_largest(left, 3);
        if (same && last <= tolerance + 4 * KERN_EPS * kern_largest(u, 3))
            return KERN_STANDS;
        if (same && last > before)
            return KERN_FALLS;
        good = kern_pass_three(h, left, step);
        kern_add(u, KERN_R(1), step, 3);
        for (k = 0; k < n; k++) {
            c[k].x += kern_three(c[k].a, step);
            if (!same && (c[k].x > 0) != c[k].press) {
                c[k].press = !c[k].press;
                changed = 1;
            }
        }
        if (good && !changed)
            return KERN_STANDS;
        same = !changed;
    }
    return KERN_UNDECIDED;
}

/* Balances group g alone. KERN_FALLS or KERN_UNDECIDED where it cannot be. */
static kern_status kern_pass_alone(kern_model *m, int g)
{
    const kern_real tolerance = KERN_PASS_TOL * m->size[g];
    kern_ray c[2 * KERN_ROWS_MOST];
    int of[KERN_ROWS_MOST]; /* ends */
    kern_real b[3];
    kern_status status;
    int e, k, n = 0;
    kern_copy(b, m->load + 3 * (size_t)g, 3);
    for (e = m->graph.touch[g]; e >= 0; e = m->graph.after[e]) {
        const kern_row row = kern_model_row(m, e);
        const kern_force *f = m->answer.force + (e >> 1);
        kern_real way[2], mu;
        if (m->graph.ends[e ^ 1] < g) {
            kern_row_exert(&row, -f->normal, -f->tangential, b);
            continue;
        }
        if (n == KERN_ROWS_MOST)
            return KERN_UNDECIDED;
        mu = kern_model_prior(m, e >> 1, way);
        kern_ray_pair(c + 2 * n, &row, mu, way);
        of[n++] = e;
    }
    status = kern_pass_solve(c, 2 * n, b, tolerance);
    for (k = 0; k < n && status == KERN_STANDS; k++) {
        const kern_real plus = kern_max(c[2 * k].x, KERN_R(0));
        const kern_real minus = kern_max(c[2 * k + 1].x, KERN_R(0));
        const kern_force f = {plus + minus,
                              kern_model_mu(m, of[k] >> 1) * (plus - minus)};
        kern_pass_write(m, of[k] >> 1, m->graph.ends[of[k] ^ 1], f, tolerance);
    }
    return status;
}

/* Joins two clusters. */
static void kern_pass_join(kern_model *m, int g, int h)
{
    kern_clusters *c = &m->cluster;
    const int swap = c->next[g];
    const int last = c->last[g] > c->last[h] ? c->last[g] : c->last[h];
    int i = g;
    c->open[c->last[g]] = c->open[c->last[h]] = 0;
    c->next[g] = c->next[h];
    c->next[h] = swap;
    do {
        c->last[i] = last;
        i = c->next[i];
    } while (i != g);
}

/* Marks, or unmarks, every group of g's cluster; returns how many there are. */
static int kern_pass_mark(kern_model *m, int g, int mark)
{
    int i = g, n = 0;
    do {
        m->graph.local[i] = mark;
        i = m->cluster.next[i];
        n++;
    } while (i != g);
    return n;
}

/* Adds the clusters that rest on that of `last`, which cannot be balanced, and
   leaves it open. Returns 0 if there are none, or it is too large now. */
static int kern_pass_grow(kern_model *m, int last)
{
    const kern_clusters *c = &m->cluster;
    int g = last, after, e, grown = 0;
    do {
        after = c->next[g];
        for (e = m->graph.touch[g]; e >= 0; e = m->graph.after[e]) {
            const int h = m->graph.ends[e ^ 1];
            if (h < g && c->last[h] != c->last[g]) {
                kern_pass_join(m, g, h);
                grown = 1;
            }
        }
        g = after;
    } while (g != last);
    kern_pass_mark_open(m, last);
    return grown && kern_pass_mark(m, last, KERN_OUT) <= c->most;
}

/* Writes the minimum-norm forces of a part. Groups that rest on it and carry it
   join it the second time: else they and it would be balanced in turns. */
static void kern_pass_keep(kern_part *p, kern_real tolerance)
{
    kern_model *m = p->m;
    int *const of = m->cluster.last, *const open = m->cluster.open;
    const int last = p->group[p->groups - 1], again = open[last] & KERN_TRIED;
    int k;
    open[last] |= KERN_TRIED;
    for (k = 0; k < p->own; k++) {
        const int i = p->contact[k], *ends = m->graph.ends + 2 * i;
        const kern_real *w = p->dual.way + 2 * (size_t)k;
        const kern_law s = kern_part_law(p, k, w[0], w[1]);
        const int low = ends[0] > ends[1] ? 0 : 1, on = ends[low];
        const int inside = p->ends[2 * k + low] < p->groups;
        kern_pass_write(m, i, inside ? m->graph.groups : on, s.force,
                        tolerance);
        if (again && on < m->graph.groups && of[on] < last
            && (open[of[on]] & KERN_OPEN)) {
            kern_pass_join(m, on, last);
            kern_pass_mark_open(m, last);
        }
    }
}

/* Whether u, the motion of a part that cannot be balanced, parts it from all
   that rests on it, and its loads do work: no force from above holds it. */
static int kern_pass_parts(kern_part *p)
{
    const kern_real most = KERN_REST * kern_largest(p->dual.u, 3 * p->groups);
    kern_real power = KERN_R(0);
    int n, k;
    for (n = 0; n < p->groups; n++)
        power += kern_dot(p->dual.u + 3 * n, p->m->load + 3 * p->group[n], 3);
    for (k = p->own; k < p->contacts; k++) {
        kern_real w[2] = {0, 0};
        kern_part_speed(p, k, p->dual.u, w);
        if (w[0] + kern_model_mu(p->m, p->contact[k]) * kern_abs(w[1]) > most)
            return 0;
    }
    return power > 0;
}

/* Opens the part of a cluster, and writes its minimum-norm forces if they
   balance it. KERN_FALLS where no forces would, all else held. */
KERN_SHARED static kern_status kern_pass_part(kern_part *p, kern_model *m,
                                              int last)
{
    kern_real load = KERN_R(0), least = KERN_INFINITY;
    kern_status status;
    kern_take take;
    int n;
    if (!kern_part_open(p, m, kern_pass_mark(m, last, 0), last))
        return KERN_NO_SPACE;
    take = p->rest;
    if (!kern_norm_lay(p, &take)
        || p->dual.cost > m->cluster.until - m->task->work->units)
        return KERN_NO_SPACE;
    for (n = 0; n < p->groups; n++) {
        least = kern_min(least, m->size[p->group[n]]);
        load += m->size[p->group[n]];
        kern_copy(p->dual.b + 3 * n, m->load + 3 * p->group[n], 3);
    }
    for (n = p->own; n < p->contacts; n++) { /* and of what rests on them */
        const kern_force *f = m->answer.force + p->contact[n];
        kern_part_exert(p, n, -f->normal, -f->tangential, p->dual.b);
    }
    for (n = 0; n < 3 * p->groups; n++)
        load += kern_abs(p->dual.b[n]);
    status = kern_norm_find(p, KERN_PASS_TOL * least, KERN_NORM_MOST * load, 0,
                            KERN_ROUNDS);
    if (status == KERN_STANDS)
        kern_pass_keep(p, KERN_PASS_TOL * least);
    if (status == KERN_FALLS && p->own < p->contacts && !kern_pass_parts(p))
        status = KERN_UNDECIDED;
    return status;
}

/* Balances the cluster of `last`. KERN_FALLS: a part that falls is open. */
static kern_status kern_pass_cluster(kern_model *m, kern_part *p, int last)
{
    kern_status status = m->cluster.next[last] == last
                           ? kern_pass_alone(m, last)
                           : KERN_UNDECIDED;
    if (status == KERN_FALLS) { /* whatever rests on it */
        if (!kern_part_open(p, m, kern_pass_mark(m, last, 0), last)
            || p->own < p->contacts)
            status = KERN_UNDECIDED;
    } else if (status == KERN_UNDECIDED)
        status = kern_pass_part(p, m, last);
    if (status != KERN_FALLS)
        kern_pass_mark(m, last, KERN_OUT);
    return status;
}

/* Begins the next pass with the known forces, if there are any. Where kerns are
   no smaller they balance all but the last block. */
static void kern_known_begin(kern_model *m, kern_real shrink)
{
    const kern_known *known = m->answer.known;
    if (!known
        || !kern_model_spend(m, 1 + (m->graph.groups + m->s->contacts) / 32))
        return;
    kern_copy(m->answer.force, known->force, 2 * m->s->contacts);
    if (shrink < known->holds)
        kern_force_transfer(m, known->holds, shrink);
    if (shrink <= known->holds)
        m->cluster.only = m->graph.group[m->s->blocks - 1];
}

/* Begins from the forces of the answer, all groups open, or those alone that
   these do not balance. `share`: of a cluster. */
static void kern_pass_begin(kern_model *m, int share)
{
    const int groups = m->graph.groups, only = m->cluster.only;
    int i;
    m->cluster.only = KERN_OUT;
    m->cluster.most = groups > KERN_SMALL
                        ? KERN_CLUSTER_MOST + 2 * groups / KERN_SMALL
                        : groups / share + 1;
    for (i = m->cluster.at = 0; i < groups; i++) {
        m->cluster.last[i] = m->cluster.next[i] = i;
        m->cluster.open[i] = only == KERN_OUT || only == i ? KERN_OPEN : 0;
        m->graph.local[i] = KERN_OUT; /* a part may have been open */
    }
}

/* Balances all groups that must be, alone or with others in clusters, which
   grow until they can be balanced, or fall. */
static kern_status kern_pass(kern_model *m, kern_part *p)
{
    kern_clusters *c = &m->cluster;
    c->until = m->task->work->units
             + KERN_PASS_UNITS * (m->s->contacts + m->graph.groups);
    while (c->at < m->graph.groups) {
        const int g = c->at++;
        kern_status status;
        if (!(c->open[g] & KERN_OPEN))
            continue;
        if (m->task->work->units > c->until || !kern_model_spend(m, 1))
            return KERN_UNDECIDED;
        c->open[g] -= KERN_OPEN;
        status = kern_pass_cluster(m, p, g);
        if (status == KERN_FALLS)
            return status;
        if (status != KERN_STANDS
            && !(status == KERN_UNDECIDED && kern_pass_grow(m, g)))
            return KERN_UNDECIDED; /* or space or work ends */
    }
    return KERN_STANDS;
}

/* ---- Interior point ---------------------------------------------- >>ipm */
/* The verdict on all groups at once, in some ten factorisations. With g what
   the first forces, x > 0, miss of equilibrium, how much of it is made up:

       max s,  A x + s g = b,  x >= 0,  s <= 0,

   from s = -1. It stands if s gets to 0. The maximum is where

       A x = b - s g,   A'y = z >= 0,   g.y = 1,   x z = 0 for every ray:

   y is the mechanism by which it falls. A primal-dual method follows x z = mu >
   0 to mu = 0. A step is Newton's,

       M dy - g ds = A x~ + s g - b,  g.dy = 1 - g.y,  M = A D A',  D = x / z,

   with x~ the forces that mu demands, solved twice with one factor (Mehrotra):
   the predictor, with mu = 0, tells how small mu may be, and what the corrector
   has to take into account. Along a path x, y, z and s are those last found. */

typedef struct kern_ipm {
    kern_part *p; /* all groups; its x, y and eq.rhs are x, y, b  */
    kern_real s;
    kern_real gap;   /* sum of x z: s is so near to the maximum      */
    kern_real *z;    /* of a ray: its opening speed                  */
    kern_real *dx;   /* of a ray: its step; that of z is dual.turn   */
    kern_real *d;    /* of a ray: D                                  */
    kern_real *over; /* of a row: A x - b + s g                      */
    kern_real *g;    /* of a row                                     */
    kern_real *gain; /* of a row: M^-1 g                             */
} kern_ipm;

#ifndef KERN_NO_INTERIOR
/* out := A'v, two rays a contact */
static void kern_ipm_ways(const kern_part *p, const kern_real *v,
                          kern_real *out)
{
    int k;
    for (k = 0; k < p->contacts; k++, out += 2) {
        kern_real w[2] = {0, 0};
        kern_part_speed(p, k, v, w);
        w[1] *= kern_model_mu(p->m, p->contact[k]);
        out[0] = w[0] + w[1];
        out[1] = w[0] - w[1];
    }
}

/* out += A x */
static void kern_ipm_carry(const kern_part *p, const kern_real *x,
                           kern_real *out)
{
    int k;
    for (k = 0; k < p->contacts; k++, x += 2)
        kern_part_exert(p, k, x[0] + x[1],
                        kern_model_mu(p->m, p->contact[k]) * (x[0] - x[1]),
                        out);
}

/* A x - b + s g, and the gap */
static void kern_ipm_over(kern_ipm *in)
{
    const kern_part *p = in->p;
    int i;
    for (i = 0; i < 3 * p->groups; i++)
        in->over[i] = in->s * in->g[i] - p->eq.rhs[i];
    kern_ipm_carry(p, p->x, in->over);
    in->gap = kern_dot(p->x, in->z, 2 * p->contacts);
}

/* out := M^-1 b, M of in->d with a share of its mean diagonal more on that. */
static void kern_ipm_factor(kern_ipm *in, kern_real shift, const kern_real *b,
                            kern_real *out)
{
    kern_part *p = in->p;
    int k;
    kern_skyline_clear(&p->dual.matrix);
    for (k = 0; k < p->contacts; k++) {
        const kern_real plus = in->d[2 * k], minus = in->d[2 * k + 1];
        const kern_real mu = kern_model_mu(p->m, p->contact[k]);
        const kern_law s = {plus + minus,
                            mu * (plus - minus),
                            mu * mu * (plus + minus),
                            {0, 0}};
        kern_part_add(p, k, &s);
    }
    kern_skyline_shift(&p->dual.matrix, shift);
    kern_skyline_factor(&p->dual.matrix);
    kern_skyline_solve(&p->dual.matrix, b, out);
    p->m->task->work->pivots++;
}

/* How much of a step keeps v above 0; at most all of it. */
static kern_real kern_ipm_share(const kern_real *v, const kern_real *step,
                                int n)
{
    kern_real share = KERN_R(1);
    int i;
    for (i = 0; i < n; i++)
        if (v[i] < -share * step[i])
            share = v[i] / -step[i];
    return share;
}

/* Lifts products x z that are near to 0 to the mean of a gap. */
static void kern_ipm_centre(kern_ipm *in, kern_real gap)
{
    const int rays = 2 * in->p->contacts;
    const kern_real mean = gap / KERN_R(rays);
    kern_real *x = in->p->x, *z = in->z;
    int i;
    for (i = 0; i < rays; i++)
        if (x[i] * z[i] < mean)
            *(x[i] > z[i] ? &z[i] : &x[i]) = mean / kern_max(x[i], z[i]);
    kern_ipm_over(in);
}

/* One solution of Newton's equations: dx, which has x~ - x without what dy
   makes of it, dy = dual.step and dz = dual.turn; returns ds. */
static kern_real kern_ipm_solve(kern_ipm *in)
{
    kern_part *p = in->p;
    kern_real *way = p->dual.way, *turn = p->dual.turn;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real ds;
    int i;
    kern_copy(p->dual.grad, in->over, n);
    kern_ipm_carry(p, in->dx, p->dual.grad);
    kern_skyline_solve(&p->dual.matrix, p->dual.grad, p->dual.step);
    ds = (1 - kern_dot(in->g, p->y, n) - kern_dot(in->g, p->dual.step, n))
       / kern_dot(in->g, in->gain, n);
    ds = kern_min(ds, -in->s);
    kern_add(p->dual.step, ds, in->gain, n);
    kern_ipm_ways(p, p->dual.step, turn);
    for (i = 0; i < rays; i++) {
        in->dx[i] -= in->d[i] * turn[i];
        turn[i] = way[i] + turn[i] - in->z[i];
    }
    return ds;
}

/* One step of the method: the predictor's, and the corrector's with what that
   tells. 0: the limit or the digits do not reach for one. */
static int kern_ipm_step(kern_ipm *in)
{
    kern_part *p = in->p;
    kern_real *dx = in->dx, *dz = p->dual.turn;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real of_x = KERN_R(0), of_z = of_x, mu = of_x, left = of_x, ds;
    int i, corrects;
    if (!(in->gap <= KERN_BOUND) || !kern_model_spend(p->m, p->dual.cost))
        return 0;
    for (i = 0; i < rays; i++) {
        in->d[i] = p->x[i] / in->z[i];
        dx[i] = dz[i] = KERN_R(0);
    }
    kern_ipm_factor(in, KERN_R(0), in->g, in->gain);
    if (!kern_is_finite(kern_dot(in->g, in->gain, n)))
        kern_ipm_factor(in, KERN_NOISE, in->g, in->gain);
    kern_ipm_ways(p, p->y, p->dual.way);
    for (corrects = 0;; corrects = 1) {
        for (i = 0; i < rays; i++)
            dx[i] = (mu - of_x * of_z * dx[i] * dz[i]) / in->z[i]
                  - in->d[i] * p->dual.way[i];
        ds = kern_ipm_solve(in);
        of_x = kern_ipm_share(p->x, dx, rays);
        of_z = kern_ipm_share(in->z, dz, rays);
        if (corrects)
            break;
        for (i = 0; i < rays; i++)
            left += (p->x[i] + of_x * dx[i]) * (in->z[i] + of_z * dz[i]);
        left = kern_max(kern_max(left / in->gap, 1 - of_x), KERN_IPM_APART);
        mu = in->gap * left * left * left / KERN_R(rays);
    }
    left = kern_min(KERN_IPM_LITTLE * left, KERN_IPM_LITTLE);
    of_z -= of_z * left;
    if (of_x < 1)
        of_x -= of_x * left;
    in->s = kern_min(in->s + of_x * ds, 0); /* a sum that is rounded */
    for (i = 0; i < rays; i++) {
        p->x[i] = kern_max(p->x[i] + of_x * dx[i], p->x[i] * KERN_EPS);
        in->z[i] += of_z * dz[i];
    }
    kern_add(p->y, of_z, p->dual.step, n);
    kern_ipm_centre(in, KERN_IPM_APART * kern_dot(p->x, in->z, rays));
    KERN_AUDIT(ipm, in);
    return kern_is_finite(in->gap);
}

/* Takes A x - b from the forces, of each as a share of it: so M is far from
   singular where x / z has entries of all sizes. Returns whether it stands. */
static int kern_ipm_balance(kern_ipm *in, const kern_query *q)
{
    kern_part *p = in->p;
    const int rays = 2 * p->contacts;
    kern_real *turn = p->dual.turn;
    int i;
    kern_copy(in->d, p->x, rays);
    kern_ipm_factor(in, KERN_R(0), in->over, p->dual.step);
    kern_ipm_ways(p, p->dual.step, turn);
    for (i = 0; i < rays; i++)
        p->x[i] -= p->x[i] * kern_min(turn[i], 1 - KERN_IPM_LITTLE);
    kern_ipm_over(in);
    return kern_part_stands(p, q);
}

/* v += 1.5 times what its least entry is below 0, a little of its largest */
static void kern_ipm_lift(kern_real *v, int n)
{
    kern_real lift = KERN_R(0);
    int i;
    for (i = 0; i < n; i++)
        lift = kern_max(lift, KERN_R(-1.5) * v[i]);
    lift += KERN_IPM_LITTLE * kern_largest(v, n);
    for (i = 0; i < n; i++)
        v[i] += lift;
}

/* Begins with minimum-norm forces of both signs, and such motions, lifted above
   0 (Mehrotra). Returns 0 where they miss nothing, or no work is left. */
static int kern_ipm_begin(kern_ipm *in)
{
    kern_part *p = in->p;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real power;
    int i;
    if (!kern_model_spend(p->m, p->dual.cost))
        return 0;
    in->s = KERN_R(-1);
    for (i = 0; i < rays; i++) {
        in->z[i] = KERN_R(0);
        in->d[i] = KERN_R(1);
    }
    kern_zero(in->g, n);
    kern_ipm_factor(in, KERN_NOISE, p->eq.rhs, p->y);
    kern_ipm_ways(p, p->y, p->x);
    kern_ipm_lift(p->x, rays);
    kern_ipm_over(in);
    kern_copy(in->g, in->over, n);
    kern_skyline_solve(&p->dual.matrix, in->g, in->gain);
    power = kern_dot(in->g, in->gain, n);
    if (!(power > 0))
        return 0;
    for (i = 0; i < n; i++)
        p->y[i] = in->gain[i] / power;
    kern_ipm_ways(p, p->y, in->z);
    kern_ipm_lift(in->z, rays);
    kern_ipm_over(in);
    return 1;
}

/* Opens all groups for queries like q; 0 if there is no room. */
static int kern_ipm_open(kern_ipm *in, kern_model *m, kern_part *p,
                         const kern_query *q)
{
    int rays, n;
    if (m->whole)
        kern_model_group(m, q);
    kern_model_set(m, q);
    if (!kern_norm_open(p, m) || p->contacts == 0)
        return 0;
    rays = 2 * p->contacts;
    n = 3 * p->groups + 3;
    in->p = p;
    in->gap = KERN_INFINITY; /* of no question so far */
    p->x = kern_take_reals(&p->rest, 4 * rays + 5 * n - 3);
    if (!kern_take_fits(&p->rest))
        return 0;
    in->z = p->x + rays;
    in->dx = in->z + rays;
    in->d = in->dx + rays;
    p->y = in->d + rays;
    in->over = p->y + n;
    in->g = in->over + n;
    in->gain = in->g + n;
    p->eq.rhs = in->gain + n;
    p->eq.rate = p->dual.grad;
    p->eq.shrink = KERN_INFINITY; /* there are no columns */
    kern_zero(p->y, 4 * n);       /* what is held rests */
    kern_zero(p->dual.step, n);
    return 1;
}

/* Steps until forces, where s is 0, or the motion prove a verdict, while the
   gap is neither rounding nor above its pace. */
static kern_status kern_ipm_run(kern_ipm *in, const kern_query *q,
                                kern_real pace)
{
    int round = 0;
    while (round++ < KERN_ROUNDS && in->gap > KERN_NOISE * KERN_NOISE
           && in->gap <= pace && kern_ipm_step(in)) {
        if (in->s >= 0
            && (kern_part_stands(in->p, q) || kern_ipm_balance(in, q)))
            return KERN_STANDS;
        if (kern_part_falls(in->p, q))
            return KERN_FALLS;
        pace *= KERN_IPM_PACE;
    }
    return KERN_UNDECIDED;
}

/* The verdict for a query: from what was found for the last, else anew. */
static kern_status kern_ipm_evaluate(kern_ipm *in, const kern_query *q)
{
    kern_part *p = in->p;
    kern_model *m = p->m;
    kern_status status = KERN_UNDECIDED;
    if (!kern_model_ask(m, 1))
        return KERN_LIMIT;
    m->task->work->solves++;
    kern_model_arms(m, q);
    kern_part_load(p, q, p->eq.rhs);
    if (in->gap <= KERN_BOUND) {
        in->s = kern_min(in->s, -KERN_IPM_LITTLE);
        kern_ipm_centre(in, kern_max(in->gap, KERN_IPM_LITTLE));
        status = kern_ipm_run(in, q, KERN_R(1.1) * in->gap);
    }
    if (status == KERN_UNDECIDED && kern_ipm_begin(in))
        status = kern_ipm_run(in, q, KERN_INFINITY);
    return p->found = status;
}

/* The verdict on all groups for a query. */
static kern_status kern_ipm_verdict(kern_model *m, kern_part *p,
                                    const kern_query *q)
{
    kern_ipm in;
    return kern_ipm_open(&in, m, p, q) ? kern_ipm_evaluate(&in, q)
                                       : KERN_UNDECIDED;
}
#else /* it decides nothing */
#define kern_ipm_open(in, m, p, q) 0
#define kern_ipm_evaluate(in, q) KERN_UNDECIDED
#define kern_ipm_verdict(m, p, q) KERN_UNDECIDED
#endif

/* ---- Verdicts ------------------------------------------------- >>verdict */

/* Lays out the linear program of a part; 0 if there is no room. */
static int kern_part_lay(kern_part *p)
{
    const int n = p->groups;
    /* clang-format off */
    const kern_program lp = {3 * n, 2 * p->contacts, NULL, NULL, NULL, p->ends,
                             NULL, 0, KERN_BOUND, p->m->task->options.limit,
                             p->m->task->work};
    /* clang-format on */
    int room = KERN_EXTRAS(n);
    p->eq.lp = lp;
    p->eq.shrink = KERN_INFINITY; /* none */
    for (; room >= KERN_LEAN_EXTRAS(n); room--) {
        kern_take take = p->rest;
        p->eq.lp.a = p->eq.arc = kern_take_reals(&take,
                                                 10 * p->contacts + 9 * n + 7);
        p->eq.lp.rhs = p->eq.rhs = p->eq.arc + 8 * (size_t)p->contacts;
        p->eq.lp.rate = p->eq.rate = p->eq.rhs + 3 * n;
        p->y = p->eq.rate + 3 * n + 3;
        p->x = p->y + 3 * n + 3;
        kern_simplex_lay(&p->eq.simplex, &p->eq.lp, KERN_ROOM(room), &take);
        if (kern_take_fits(&take)) {
            kern_zero(p->y + 3 * n, 3);
            return 1;
        }
    }
    return 0;
}

/* Eq. (5) for a query: two columns a contact, along the edges n + mu t and
   n - mu t of its friction cone, and the loads on the right. */
static void kern_part_set(kern_part *p, const kern_query *q)
{
    kern_model *m = p->m;
    int k, edge;
    KERN_ASSERT(p->eq.lp.rows == 3 * p->groups);
    m->reduction = kern_reduction(q);
    for (k = 0; k < p->groups; k++)
        kern_model_unit(m, q, p->group[k]);
    kern_part_load(p, q, p->eq.rhs);
    if (p->eq.shrink >= q->shrink && p->eq.shrink <= q->shrink)
        return;
    p->eq.shrink = q->shrink;
    kern_simplex_change(&p->eq.simplex, KERN_BASIS_STALE);
    for (k = 0; k < p->contacts; k++) {
        kern_real *f = p->eq.arc + 8 * (size_t)k;
        kern_real mu = kern_model_mu(m, p->contact[k]);
        kern_row row[2];
        kern_model_rows(m, q, p->contact[k], row);
        for (edge = 0; edge < 2; edge++, f += 4, mu = -mu) {
            kern_row_wrench(row, KERN_R(1), mu, f);
            f[3] = row[1].n[2] + mu * row[1].turn;
        }
    }
}

/* Whether the part is all there is: then forces on it prove that it stands. */
static int kern_part_is_whole(const kern_part *p)
{
    return p->groups == p->m->graph.groups;
}

/* The proof of a verdict, and the verdict itself only if the proof holds. That
   a part stands is no verdict, and needs no proof. */
static kern_status kern_part_prove(kern_part *p, const kern_query *q,
                                   kern_status status)
{
    const int whole = kern_part_is_whole(p);
    int again;
    if (status < 0 || (status == KERN_STANDS && !whole))
        return status;
    for (again = 0; status == KERN_FALLS && again < 2; again++)
        if ((!again || kern_prices_mend(&p->eq.simplex, p->y, KERN_ROUNDING))
            && kern_part_falls(p, q))
            return status;
    /* forces may still do, within the tolerance */
    return whole && kern_part_stands(p, q) ? KERN_STANDS : KERN_UNDECIDED;
}

/* Where normal forces are larger in sum than is allowed, the least that there
   are, by costs of 1: if too large, their prices are a motion that shows it. */
static kern_status kern_part_norm(kern_part *p, int builtin)
{
    kern_real *one = (kern_real *)(void *)p->m->answer.force; /* not in use */
    kern_status status;
    int i;
    for (i = 0; i < p->eq.lp.cols; i++)
        one[i] = KERN_R(1);
    if (!(kern_dot(p->x, one, p->eq.lp.cols) > KERN_BOUND))
        return KERN_STANDS;
    p->eq.lp.cost = one;
    status = kern_program_solve(&p->eq.simplex, builtin, p->x, p->y);
    p->eq.lp.cost = NULL;
    if (status != KERN_LP_OPTIMAL)
        return status < 0 ? status : KERN_UNDECIDED;
    return kern_dot(p->x, one, p->eq.lp.cols) > KERN_BOUND ? KERN_FALLS
                                                           : KERN_STANDS;
}

/* How far rhs can grow at eq.rate, which is the same for all of a program. */
static kern_real kern_part_follow(kern_part *p)
{
    kern_status status;
    p->eq.lp.follow = 1;
    status = kern_program_solve(&p->eq.simplex, 1, p->x, p->y);
    p->eq.lp.follow = 0;
    return status == KERN_LP_OPTIMAL ? p->x[p->eq.lp.cols] : KERN_INFINITY;
}

/* What the simplex method says of a part, without a proof. */
static kern_status kern_part_ask(kern_part *p, const kern_query *q, int builtin)
{
    kern_status status;
    if (!kern_model_ask(p->m, 1))
        return KERN_LIMIT;
    kern_part_set(p, q);
    status = kern_program_solve(&p->eq.simplex, builtin, p->x, p->y);
    if (status == KERN_LP_OPTIMAL)
        status = kern_part_norm(p, builtin);
    else if (status == KERN_LP_INFEASIBLE)
        status = KERN_FALLS;
    return p->found = status;
}

/* The verdict with its proof: `status`, else what a second solve finds. */
static kern_status kern_part_judge(kern_part *p, const kern_query *q,
                                   kern_status status)
{
    kern_model *m = p->m;
    status = kern_part_prove(p, q, status);
    if (status < 0) { /* from no basis */
        kern_simplex_change(&p->eq.simplex, KERN_BASIS_NONE);
        status = kern_part_prove(p, q, kern_part_ask(p, q, 1));
    }
    /* other rounding, other room; in float it would prove what is critical */
    if (KERN_PICK(1, 0) > 0 && m->whole
        && ((status == KERN_UNDECIDED && m->graph.groups <= KERN_SMALL)
            || (status == KERN_NO_SPACE && kern_model_is_small(m)))) {
        status = kern_ipm_verdict(m, p, q);
        p->found = KERN_UNDECIDED; /* y predicts less exactly than a basis */
    }
    return status;
}

/* Passes the loads of the query that is set down: KERN_STANDS with a proof;
   KERN_FALLS with an open part that seems to fall; or KERN_UNDECIDED. */
static kern_status kern_model_pass(kern_model *m, kern_part *p,
                                   const kern_query *q, int share)
{
    kern_status found;
    for (;; m->answer.known = NULL) { /* known forces may be of other loads */
        if (!kern_model_ask(m, 1))
            return KERN_LIMIT;
        m->task->work->solves++;
        kern_pass_begin(m, share);
        found = kern_pass(m, p);
        if (found == KERN_FALLS
            || (found == KERN_STANDS && kern_answer_holds(m, q)))
            return found;
        if (found != KERN_STANDS || !m->answer.known)
            return KERN_UNDECIDED;
        kern_model_unload(m);
    }
}

/* From now on one linear program of all groups answers, from its last basis. It
   lies in the place of what the pass needs. */
static kern_status kern_model_whole(kern_model *m, kern_part *p,
                                    const kern_query *q)
{
    int g, k;
    kern_model_weigh(m, q);
    kern_part_begin(p, m, m->graph.groups, &m->common);
    p->contacts = p->own = m->s->contacts;
    p->ends = m->graph.ends;
    p->contact = kern_take_ints(&p->rest, p->contacts);
    if (!kern_take_fits(&p->rest))
        return KERN_NO_SPACE;
    for (g = 0; g < p->groups; g++)
        p->group[g] = g;
    for (k = 0; k < p->contacts; k++)
        p->contact[k] = k;
    m->whole = kern_part_lay(p);
    return m->whole ? KERN_OK : KERN_NO_SPACE;
}

/* The verdict for a query, with a proof or none, by the methods that >>method
   lists. After KERN_FALLS the part that falls is open. */
static kern_status kern_model_evaluate(kern_model *m, kern_part *p,
                                       const kern_query *q)
{
    kern_status status;
    p->found = KERN_UNDECIDED;
    if (!m->whole) {
        kern_model_set(m, q);
        status = kern_model_pass(m, p, q, KERN_CLUSTER);
        if (status == KERN_STANDS || status == KERN_LIMIT)
            return status;
        if (status == KERN_FALLS && kern_part_lay(p)
            && kern_part_judge(p, q, kern_part_ask(p, q, 0)) == KERN_FALLS)
            return KERN_FALLS;
        status = m->graph.groups > KERN_SMALL ? kern_ipm_verdict(m, p, q)
                                              : KERN_UNDECIDED;
        if (status != KERN_UNDECIDED)
            return status;
        status = kern_model_whole(m, p, q);
        if (status != KERN_OK)
            return status;
    }
    return kern_part_judge(p, q, kern_part_ask(p, q, 0));
}

/* ==== Part V: What is measured =========================================== */

/* ---- The kern -------------------------------------------------- >>kern */
/* At a place that falls y gives the power -y.rhs > 0, which changes along the
   path at the rate y.(rhs' - A' x): its zero is where this mechanism stops
   (Newton's method). It converges quadratically, from the side that falls. */

typedef enum kern_path_kind {
    KERN_PATH_SHRINK,
    KERN_PATH_LOAD,
    KERN_PATH_TILT
} kern_path_kind;

/* Farthest place proven to stand, nearest to fall; -1, infinity: none. */
typedef struct kern_proven {
    kern_real low, high;
} kern_proven;

typedef struct kern_path {
    kern_path_kind kind;
    kern_query q;            /* at s = 0; what the path changes is replaced  */
    kern_real unit;          /* along it: a block's size, or 1               */
    kern_real start, end;    /* of the path; the first stands                */
    kern_real holds, fails;  /* the bracket                                  */
    kern_real critical;      /* value that Newton's method predicts          */
    kern_real exact;         /* one that a verdict there has confirmed       */
    kern_proven proven;      /* places with a proof                          */
    int never;               /* nonzero: it stands to the end                */
    kern_part *part;         /* that fell last                               */
    kern_known warm;         /* of a structure like it, or of the body that
                                 falls first; `fails` 0: nothing              */
    int alone;               /* nonzero: the part is evaluated alone         */
    struct kern_ipm *ipm;    /* evaluates the whole, or NULL                 */
    const kern_proof *proof; /* the caller's: of the last verdict each way   */
} kern_path;

/* Width of a bracket, as it is wanted; from the critical value to its ends. */
KERN_SHARED static kern_real kern_width(const kern_path *path)
{
    return KERN_WIDTH * path->unit;
}

KERN_SHARED static kern_real kern_aside(const kern_path *path)
{
    return kern_width(path) / 2;
}

/* The widest bracket that is an answer. */
KERN_SHARED static kern_real kern_widest(const kern_path *path)
{
    return kern_width(path) * KERN_WIDEST;
}

/* The place that lies `aside` before the critical value, or the start. */
KERN_SHARED static kern_real kern_before(const kern_path *path, kern_real aside)
{
    return kern_max(path->critical - aside, path->start);
}

/* The query at s. Gravity turns by 4 atan(s), so that s in [0, 1] turns it
   through half a circle by arithmetic alone. */
static kern_query kern_path_at(const kern_path *path, kern_real s)
{
    kern_query q = path->q;
    if (path->kind == KERN_PATH_SHRINK)
        q.shrink = s;
    else if (path->kind == KERN_PATH_LOAD)
        q.factor = s;
    else {
        const kern_real d = 1 + s * s, c2 = (1 - s * s) / d, n2 = 2 * s / d;
        const kern_real c = c2 * c2 - n2 * n2;
        const kern_real n = 2 * c2 * n2 * KERN_R(q.side);
        q.gravity.x = c * path->q.gravity.x - n * path->q.gravity.y;
        q.gravity.y = c * path->q.gravity.y + n * path->q.gravity.x;
    }
    return q;
}

/* The tangent of half the angle whose tangent is t. */
static kern_real kern_halved(kern_real t)
{
    return t / (1 + KERN_SQRT(1 + t * t));
}

/* ---- Searching a path ------------------------------------------ >>search */
/* Verdicts along a path; the critical value is the place where they change. */

/* How y.rhs changes when kerns, shrunk as in q, are shrunk by `to`, if y stays:
   by y.v, v = -(A(to) - A(q)) x, straight but where a kern closes. One that was
   closed opens to the side that helps. *rate: at `to`; p->eq.rate: v. */
static kern_real kern_shrink_power(const kern_part *p, const kern_query *q,
                                   kern_real to, const kern_real *x,
                                   kern_real *rate)
{
    const kern_model *m = p->m;
    kern_real sum = KERN_R(0), slope = sum, *v = p->eq.rate;
    int i;
    kern_zero(v, 3 * p->groups + 3);
    for (i = 0; i < p->contacts; i++, x += 2) {
        const kern_contact *c = m->s->contact + p->contact[i];
        const int *ends = m->graph.ends + 2 * p->contact[i];
        const int head = 3 * p->ends[2 * i], tail = 3 * p->ends[2 * i + 1];
        const kern_real travel = kern_travel(c, m->mean);
        const kern_real mu = kern_model_mu(m, p->contact[i]);
        /* the arm grows along t, and t x (f n + r t) = -f */
        const kern_real work = p->y[head + 2] * m->unit[ends[0]]
                             - p->y[tail + 2] * m->unit[ends[1]];
        kern_real n = x[0] + x[1], was, is, more;
        if (!(n > 0 || n < 0))
            continue;
        more = kern_shift(travel, to, q->relative, &is)
             - kern_shift(travel, q->shrink, q->relative, &was);
        if (!q->relative && q->shrink >= kern_abs(travel)
            && n * work * more < 0)
            n = -n;
        slope += n * work * is;
        n *= more;
        v[head + 2] += n * m->unit[ends[0]];
        v[tail + 2] -= n * m->unit[ends[1]];
        sum += n * work;
        if (q->narrow > 0 && mu > 0) { /* the reduction of q is set */
            const kern_real by = kern_max(q->narrow * to, KERN_R(0));
            const kern_real narrow = kern_friction(c, by);
            kern_real speed[2] = {0, 0};
            kern_row row[2];
            kern_model_rows(m, q, p->contact[i], row);
            kern_row_speed(row, p->y + head, speed);
            kern_row_speed(row + 1, p->y + tail, speed);
            speed[1] *= x[0] - x[1];
            sum += speed[1] * (mu - narrow);
            if (narrow > 0)
                slope += speed[1] * q->narrow * (1 + narrow * narrow)
                       / (1 + by * by);
        }
    }
    *rate = slope;
    return sum;
}

/* Where the mechanism y that falls at q, by `power` < 0, stops to fall: its
   power is straight but for bends where kerns close. At least path->holds. And
   p->ahead: where its basis does, which turns y meanwhile (Halley's method). */
static kern_real kern_shrink_critical(kern_path *path, const kern_query *q,
                                      kern_real power)
{
    kern_part *p = path->part;
    const kern_real same = KERN_NOISE * path->unit / 8;
    kern_real *x = (kern_real *)(void *)p->m->answer.force; /* not in use */
    kern_real lo = path->holds, hi = q->shrink, at = hi, rate, step;
    int round;
    for (round = 0;; round++) {
        const kern_real left = power + kern_shrink_power(p, q, at, p->x, &rate);
        step = left / rate;
        if (kern_abs(step) <= same || round == KERN_FEW_ROUNDS)
            break;
        *(left < 0 ? &hi : &lo) = at;
        at -= step;
        if (!(at > lo && at < hi))
            at = lo + (hi - lo) / 2;
    }
    p->ahead = at = round < KERN_FEW_ROUNDS ? at - step : path->holds;
    if (p->eq.shrink <= q->shrink
        && kern_simplex_along(&p->eq.simplex, p->eq.rate, x))
        p->ahead = q->shrink
                 + (at - q->shrink)
                       / kern_max(
                           1 - kern_shrink_power(p, q, at, x, &rate) / power,
                           1 / KERN_NEAR);
    return at;
}

/* By what rhs falls at a query with the load, or with the tangent of the angle
   by which gravity turns, which is a load too. */
static void kern_path_rate(const kern_part *p, const kern_query *q,
                           kern_real *to)
{
    const kern_model *m = p->m;
    kern_wrench w;
    int n;
    for (n = 0; n < p->groups; n++) {
        kern_pattern_on(m->s, q, m->graph.block[p->group[n]], &w);
        w.torque *= m->unit[p->group[n]];
        kern_copy(to + 3 * n, &w, 3);
    }
    kern_scale(to, 3 * n, 1 / m->weight);
}

/* Records a verdict at s, an end of the bracket then, and hands its proof to
   the caller, whose motion stays that of the nearest place that falls. That a
   part stands alone proves nothing. */
static void kern_path_note(const kern_model *m, kern_path *path,
                           kern_status status, kern_real s)
{
    if (status == KERN_STANDS) {
        path->holds = s;
        if (path->alone)
            return;
        path->proven.low = kern_max(path->proven.low, s);
    } else if (status == KERN_FALLS) {
        path->fails = s;
        if (!(s <= path->proven.high))
            return;
        path->proven.high = s;
    }
    kern_proof_out(m, path->proof, status);
}

/* The place beyond s where a load grew by t, or gravity turned by atan(t). */
static kern_real kern_path_pushed(const kern_path *path, kern_real s,
                                  kern_real t)
{
    if (path->kind == KERN_PATH_LOAD)
        return s + t;
    t = kern_halved(kern_halved(t));
    return (s + t) / (1 - s * t);
}

/* Where the mechanism p->y that falls at s stops to fall: Newton's method,
   which is exact but for bends, and for loads that do not turn. */
static kern_real kern_path_newton(kern_path *path, const kern_query *q,
                                  kern_real s)
{
    const kern_part *p = path->part;
    const int n = 3 * p->groups;
    const kern_real power = kern_dot(p->y, p->eq.rhs, n);
    kern_real *rate = p->m->answer.sum; /* not in use */
    if (path->kind == KERN_PATH_SHRINK)
        return kern_shrink_critical(path, q, power);
    kern_path_rate(p, q, rate);
    return kern_path_pushed(path, s, power / kern_dot(p->y, rate, n));
}

/* The verdict at s. The critical value of a mechanism, proven or not, becomes
   the path's: near it rounding may spoil the proof, but not the value. What the
   simplex method finds to fall far beyond it becomes an end of the bracket and
   is not proven: the search goes on just beyond the value. */
static kern_status kern_path_ask(kern_model *m, kern_path *path, kern_real s)
{
    const kern_query q = kern_path_at(path, s);
    kern_part *p = path->part;
    const int simplex = m->whole || path->alone;
    const kern_status status = simplex   ? kern_part_ask(p, &q, 0)
                             : path->ipm ? kern_ipm_evaluate(path->ipm, &q)
                                         : kern_model_evaluate(m, p, &q);
    if (status != KERN_STANDS && p->found == KERN_FALLS)
        path->critical = kern_path_newton(path, &q, s);
    if (simplex && status == KERN_FALLS && path->critical > path->holds
        && s - path->critical > kern_widest(path))
        path->fails = s;
    else if (simplex)
        return kern_part_judge(p, &q, status);
    return status;
}

/* The verdict at s, which becomes an end of the bracket, with its proof. */
static kern_status kern_path_evaluate(kern_model *m, kern_path *path,
                                      kern_real s)
{
    const kern_status status = kern_path_ask(m, path, s);
    if (status != KERN_FALLS || s < path->fails || s > path->fails)
        kern_path_note(m, path, status, s); /* else an end without a proof */
    return status;
}

/* Whether the basis that fell just beyond the critical value holds there: by
   how its forces change, which kern_shrink_critical() left. They prove that it
   stands `aside` before it, with larger kerns. */
static int kern_path_forces(kern_model *m, kern_path *path, kern_real aside)
{
    kern_part *p = path->part;
    const kern_real s = kern_before(path, aside);
    const kern_query q = kern_path_at(path, s);
    int i;
    if (!m->whole || path->kind != KERN_PATH_SHRINK || p->found != KERN_FALLS)
        return 0;
    kern_add(p->x, KERN_R(1), (kern_real *)(void *)m->answer.force,
             2 * p->contacts);
    for (i = 0; i < 2 * p->contacts; i++)
        if (p->x[i] < -KERN_NOISE)
            return 0;
    kern_part_forces(p);
    kern_force_transfer(m, path->critical, s);
    if (!kern_answer_holds(m, &q))
        return 0;
    kern_path_note(m, path, KERN_STANDS, s);
    return 1;
}

/* The verdict at the critical value, which proves no end of the bracket. Where
   another mechanism falls, its value is the path's; else the value is exact. */
KERN_SHARED static kern_status kern_path_verify(kern_model *m, kern_path *path,
                                                kern_real aside)
{
    const kern_real at = path->critical;
    const kern_status status = kern_path_forces(m, path, aside)
                                 ? KERN_STANDS
                                 : kern_path_ask(m, path, at);
    if (status != KERN_FALLS || path->critical > at)
        path->critical = at;
    if (path->critical >= at - KERN_NOISE * path->unit)
        path->exact = path->critical;
    return status;
}

/* The next place: where the basis may stop to fall; `aside` beyond the critical
   value (`fails` may be twice as far); as far before it, to stand; at it, to be
   verified; else a part of the bracket; infinity: it is narrow, or of a part */
KERN_SHARED static kern_real kern_path_next(const kern_path *path,
                                            kern_real aside)
{
    const kern_real lo = path->holds, hi = path->fails, crit = path->critical;
    kern_real next = path->part->ahead;
    if (!path->alone && path->proven.low < lo
        && kern_min(crit, hi) < lo + 2 * aside)
        return lo; /* not proven yet */
    if (hi - lo <= aside / 8 || 2 * aside > kern_widest(path))
        return KERN_INFINITY;
    if (!(crit > lo && crit <= hi)) /* `lo` is where none was found */
        return lo + (hi - lo) / KERN_NEAR * (kern_aside(path) / aside);
    if (!(next > lo && hi - next > aside * 2))
        next = crit;
    if (hi - next > aside * 2)
        return next + aside;
    if (path->alone)
        return KERN_INFINITY;
    if (!path->ipm && crit > lo
        && kern_abs(path->exact - crit) > KERN_NOISE * path->unit)
        return crit;
    return crit - lo > aside * KERN_R(1.05) ? kern_before(path, aside)
                                            : KERN_INFINITY;
}

/* Narrows [holds, fails] to the tolerance around path->critical, where the
   verdict changes. Each verdict may find a mechanism with a smaller value. The
   interior point knows the value no better than its bracket. In a jam no proof
   comes near it: then the distance doubles. KERN_FALLS where the structure
   falls at the start, which was not proven. */
static kern_status kern_path_critical(kern_model *m, kern_path *path)
{
    kern_real aside = kern_aside(path);
    int round;
    for (round = 0; round < KERN_ROUNDS; round++) {
        const kern_real lo = path->holds, crit = path->critical;
        const kern_real at = kern_path_next(path, aside);
        const int verify = at > lo && at >= crit && at <= crit;
        kern_status status;
        if (!(at < KERN_INFINITY))
            break;
        status = verify ? kern_path_verify(m, path, aside)
                        : kern_path_evaluate(m, path, at);
        if (status < KERN_UNDECIDED || (at <= lo && status != KERN_STANDS))
            return status;
        if (status == KERN_UNDECIDED)
            aside *= 2;
    }
    if (path->fails < path->proven.high /* without a proof */
        || (path->fails - path->holds > kern_widest(path) && !path->alone))
        return KERN_UNDECIDED;
    path->critical = kern_max(path->critical, path->holds);
    path->critical = kern_min(path->critical, path->fails);
    return KERN_STANDS;
}

/* It stands to the end of the path. */
static kern_status kern_path_saturate(kern_path *path)
{
    path->never = 1;
    path->critical = path->fails = path->end;
    return KERN_STANDS;
}

/* Whether gravity that turns under loads that stay is held from `at` to the end
   of a step. The gravities that are held are a convex set, and the arc lies in
   the triangle of its ends and of the corner where their tangents meet. */
static int kern_turn_holds(kern_model *m, const kern_path *path, kern_real at)
{
    kern_query q = kern_path_at(path, path->holds);
    const kern_vec from = kern_path_at(path, at).gravity, to = q.gravity;
    const kern_real square = kern_vec_dot(to, to);
    q.gravity = kern_vec_scale(kern_vec_add(from, to),
                               square / (square + kern_vec_dot(from, to)));
    return kern_model_evaluate(m, path->part, &q) == KERN_STANDS;
}

/* Climbs from a place that stands until the whole falls, in steps that grow, or
   are halved where nothing can be proven; then finds the critical value. Where
   verdicts may change more than once `even` is the least step; else it is 0. */
static kern_status kern_path_climb(kern_model *m, kern_path *path,
                                   kern_real first, kern_real step,
                                   kern_real even)
{
    const kern_real least = KERN_R(1.5) * (even > 0 ? even : kern_width(path));
    int round;
    for (round = 0; round < 5 * KERN_SCAN; round++) {
        const kern_real at = path->holds;
        const kern_real next = kern_min(path->end, at + kern_max(first, even));
        const int small = next - at <= least, sure = small || !(even > 0);
        const kern_status status = kern_path_evaluate(m, path, next);
        if (status == KERN_STANDS && (sure || kern_turn_holds(m, path, at))) {
            if (next >= path->end)
                return kern_path_saturate(path);
            first = kern_min(step, (path->fails - next) / 2);
            step *= KERN_CLIMB_GROWS;
        } else if (status == KERN_FALLS && sure)
            return kern_path_critical(m, path);
        else if (status < KERN_UNDECIDED || small)
            return status;
        else {
            step = first /= 2;
            path->holds = at;
            if (status == KERN_STANDS) /* the proof is that of `next` */
                kern_path_evaluate(m, path, at);
        }
    }
    return KERN_UNDECIDED;
}

/* Whether the known motion, then the answer's, proves that it falls. */
static int kern_known_falls(kern_model *m, const kern_query *q,
                            const kern_known *known)
{
    if (!kern_model_proven(m, kern_prove_motion(m->s, q, known->motion)))
        return 0;
    kern_copy(m->answer.motion, known->motion, 3 * m->s->blocks);
    return 1;
}

/* Whether the known motion proves that the structure falls at the known place:
   that bounds the critical value. */
static int kern_start_falls(kern_model *m, kern_path *path)
{
    const kern_query q = kern_path_at(path, path->warm.fails);
    if (!kern_known_falls(m, &q, &path->warm))
        return 0;
    kern_path_note(m, path, KERN_FALLS, path->warm.fails);
    path->critical = path->exact = path->warm.margin;
    return 1;
}

/* ---- bodies ---- */
/* A body is a block with all that rests on it alone, moved as one. On a single
   line it tips where its load leaves the kern, with all others held, and then
   the whole falls. The critical value of most structures is that of a body. */

/* The first contact of the line that carries body g, as an end; KERN_OUT where
   other contacts carry it. Sets graph.carrier: what carries it alone. */
KERN_SHARED static int kern_body_line(kern_model *m, int g)
{
    int e, n = 0, first = KERN_OUT, on = KERN_OUT;
    for (e = m->graph.touch[g]; e >= 0; e = m->graph.after[e]) {
        const int other = m->graph.ends[e ^ 1];
        if (other < g && m->graph.carrier[other] == g)
            continue;
        on = on == KERN_OUT || on == other ? other : m->graph.groups;
        if (n++ == 0)
            first = e;
    }
    m->graph.carrier[g] = on > g && on < m->graph.groups ? on : KERN_OUT;
    return n == 2 && kern_line_begins(m->s->contact, m->s->contacts, first >> 1)
             ? first
             : KERN_OUT;
}

/* Where body g tips under load b on the line that begins with end *e, and *e
   about which end; infinity: it is not pressed, or stands on a closed kern. */
static kern_real kern_body_critical(const kern_model *m, int g, int *e,
                                    const kern_real *b, kern_real aside)
{
    const kern_contact *c = m->s->contact + (*e >> 1);
    const kern_vec at = m->s->block[m->graph.block[g]].centre;
    const kern_real side = KERN_R(*e & 1 ? -1 : 1);
    const kern_vec n = kern_vec_scale(c->n, side);
    const kern_row row = kern_row_of(n, kern_vec_sub(c->p, at), m->unit[g]);
    const kern_row last = kern_row_of(n, kern_vec_sub(c[1].p, at), m->unit[g]);
    const kern_real normal = row.n[0] * b[0] + row.n[1] * b[1];
    const kern_real along = row.n[0] * b[1] - row.n[1] * b[0];
    const kern_real travel = kern_travel(c, m->mean);
    const kern_real most = m->relative ? KERN_R(1) : kern_abs(travel);
    const kern_real rate = travel / most * -side * m->unit[g];
    kern_real place, crit, other;
    if (!(normal > 0))
        return KERN_INFINITY;
    place = (b[2] - along * row.turn) / normal; /* of the load, as an arm */
    crit = (place - row.n[2]) / rate;
    other = (last.n[2] - place) / rate;
    if (other < crit) {
        crit = other;
        *e += 2;
    }
    return crit + aside <= most ? crit : KERN_INFINITY;
}

/* The motion of a body about the end e of its line at s; the fastest is 1. */
static void kern_body_moves(kern_model *m, int body, int e, kern_real s)
{
    const kern_contact *c = m->s->contact + (e >> 1);
    const kern_real spin = KERN_R((c->travel > 0) == (e & 1) ? 1 : -1);
    const kern_real all = m->relative ? KERN_R(1) : kern_abs(c->travel);
    const kern_vec t = kern_vec_scale(kern_vec_turn(c->n), c->travel / all);
    int g, h;
    kern_zero(m->answer.motion, 3 * m->s->blocks);
    for (g = 0; g <= body; g++) {
        const kern_block *b = m->s->block + m->graph.block[g];
        kern_motion *v = m->answer.motion + m->graph.block[g];
        kern_vec arm;
        for (h = g; h != KERN_OUT && h < body; h = m->graph.carrier[h])
            ;
        if (h != body)
            continue;
        arm = kern_vec_step(kern_vec_sub(c->p, b->centre), s, t);
        v->vx = spin * arm.y;
        v->vy = -spin * arm.x;
        v->spin = spin;
    }
    kern_motion_scale(m->s, m->answer.motion);
}

/* The smallest critical value of a body, or infinity: the path's warm start. */
static kern_real kern_body_first(kern_model *m, kern_path *path)
{
    kern_known *warm = &path->warm;
    const kern_real aside = kern_aside(path);
    kern_real *load = m->answer.sum; /* of a body: three, in its units */
    int g, first = KERN_OUT, about = 0;
    warm->margin = KERN_INFINITY;
    if (!kern_model_ask(m, 1))
        return warm->margin;
    kern_copy(load, m->load, 3 * m->graph.groups);
    for (g = 0; g < m->graph.groups; g++, load += 3) {
        int end = kern_body_line(m, g);
        const int on = m->graph.carrier[g];
        const kern_real crit = end == KERN_OUT
                                 ? KERN_INFINITY
                                 : kern_body_critical(m, g, &end, load, aside);
        if (crit < warm->margin) {
            warm->margin = crit;
            first = g;
            about = end;
        }
        if (on != KERN_OUT) {
            kern_real *to = load + 3 * (on - g);
            const kern_vec arm = kern_vec_sub(
                m->s->block[m->graph.block[g]].centre,
                m->s->block[m->graph.block[on]].centre);
            to[0] += load[0];
            to[1] += load[1];
            to[2] += (load[2] / m->unit[g] + arm.x * load[1] - arm.y * load[0])
                   * m->unit[on];
        }
    }
    warm->holds = warm->margin - aside;
    warm->fails = warm->margin + aside;
    warm->motion = m->answer.motion;
    if (first != KERN_OUT)
        kern_body_moves(m, first, about, warm->fails);
    return warm->margin;
}

/* ---- the search: which method is asked when ---- */

/* The critical value of the whole where a load grows or gravity turns, by one
   program: the largest place, or the tangent of the largest angle, that rhs can
   reach. Its prices are the mechanism. KERN_UNDECIDED where there is none. */
static kern_status kern_path_follow(kern_model *m, kern_path *path)
{
    kern_part *p = path->part;
    const kern_real s = path->holds;
    kern_query q = kern_path_at(path, s);
    kern_real most, beyond;
    kern_part_set(p, &q);
    kern_path_rate(p, &q, p->eq.rate);
    most = kern_part_follow(p);
    path->critical = path->exact = kern_path_pushed(path, s, most);
    if (!(most < KERN_INFINITY && path->critical < path->end))
        return KERN_UNDECIDED;
    beyond = path->critical + kern_aside(path);
    q = kern_path_at(path, beyond);
    if (!kern_model_ask(m, 1))
        return KERN_LIMIT;
    if (kern_part_falls(p, &q))
        kern_path_note(m, path, KERN_FALLS, beyond);
    return kern_path_critical(m, path);
}

/* The critical value in the known bracket, or where that fails by a climb. */
static kern_status kern_path_narrow(kern_model *m, kern_path *path,
                                    kern_real first, kern_real step)
{
    const kern_status status = path->fails < KERN_INFINITY
                                 ? kern_path_critical(m, path)
                                 : KERN_UNDECIDED;
    if (status != KERN_UNDECIDED)
        return status;
    path->holds = kern_max(path->start, path->proven.low);
    return kern_path_climb(m, path, first, step, KERN_R(0));
}

/* Begins a program of all groups with the known forces. */
static void kern_known_start(kern_model *m, kern_part *p)
{
    int k;
    kern_copy(m->answer.force, m->answer.known->force, 2 * p->contacts);
    for (k = p->contacts - 1; k >= 0; k--) {
        kern_real *x = p->x + 2 * k, way[2];
        const kern_real along = kern_model_prior(m, k, way) * way[1];
        x[0] = way[0] + along;
        x[1] = way[0] - along;
    }
    kern_simplex_start(&p->eq.simplex, p->x, KERN_NOISE * m->weight);
}

/* The critical value of the whole beyond path->holds: of many groups by the
   interior point, which shrinks half as far first, where fewer mechanisms fall;
   of few, or where that finds none, by their linear program. */
static kern_status kern_path_whole(kern_model *m, kern_path *path,
                                   kern_real first, kern_real step)
{
    const kern_query q = kern_path_at(path, path->holds);
    kern_ipm in;
    kern_status status;
    if (!m->whole && m->graph.groups > KERN_SMALL
        && kern_ipm_open(&in, m, path->part, &q)) {
        path->ipm = &in;
        status = kern_path_narrow(
            m, path, path->kind == KERN_PATH_SHRINK ? first / 2 : first, step);
        path->ipm = NULL;
        if (status != KERN_UNDECIDED)
            return status;
    }
    status = m->whole ? KERN_OK : kern_model_whole(m, path->part, &q);
    if (status == KERN_OK && m->answer.known)
        kern_known_start(m, path->part);
    if (status == KERN_OK && path->kind != KERN_PATH_SHRINK)
        status = kern_path_follow(m, path);
    return status == KERN_OK || status == KERN_UNDECIDED
             ? kern_path_narrow(m, path, first, step)
             : status;
}

/* The verdict on the open part alone at s, and after KERN_FALLS in
   path->critical its critical value; KERN_UNDECIDED where it does not fall. */
static kern_status kern_path_part(kern_model *m, kern_path *path, kern_real s)
{
    const kern_real holds = path->holds;
    kern_status status;
    if (!kern_part_lay(path->part))
        return KERN_UNDECIDED;
    path->alone = 1;
    status = kern_path_evaluate(m, path, s);
    if (status == KERN_FALLS && path->critical <= path->start)
        status = kern_path_evaluate(m, path, s = path->start);
    if (status == KERN_FALLS && s > path->start)
        status = kern_path_critical(m, path) == KERN_STANDS ? KERN_FALLS
                                                            : KERN_UNDECIDED;
    path->alone = 0;
    path->holds = holds;
    if (status == KERN_FALLS) /* within a bracket, which is the whole's */
        path->exact = path->critical;
    return status == KERN_STANDS ? KERN_UNDECIDED : status;
}

/* Whether what moved in the known structure, if it is a small part, falls with
   the last block at s; its critical value is the path's. */
static int kern_known_part(kern_model *m, kern_path *path, kern_real s)
{
    const kern_motion *motion = m->answer.known->motion;
    int g, groups = 0;
    for (g = 0; g < m->graph.groups; g++) {
        const int b = m->graph.block[g];
        if (b == m->s->blocks - 1 || kern_speed(motion + b) > 0) {
            m->graph.local[g] = 0;
            groups++;
        }
    }
    return groups > 1 && 2 * groups <= g
        && kern_part_open(path->part, m, groups, g - 1)
        && kern_path_part(m, path, s) == KERN_FALLS;
}

/* Where a search begins: just before the known critical value, if its motion
   proves it, that of a body or of what moved; else where it held or beyond. */
static kern_real kern_path_first(kern_model *m, kern_path *path,
                                 kern_real first)
{
    kern_known *warm = &path->warm;
    const int known = warm->fails > path->start && warm->fails <= path->end
                   && warm->fails - warm->holds <= kern_widest(path)
                   && warm->holds <= warm->margin
                   && warm->margin <= warm->fails;
    const kern_real at = known ? kern_max(path->start, warm->holds)
                               : kern_min(path->start + first, path->end);
    const kern_real most = known ? kern_min(at + first, path->end) : path->end;
    kern_model_weigh(m, &path->q); /* the same for all places */
    m->reduction = kern_reduction(&path->q);
    if (known && kern_start_falls(m, path))
        return at;
    if (kern_body_first(m, path) < most) {
        if (warm->holds > path->start) /* else it falls, or is asked, there */
            kern_start_falls(m, path);
        return kern_max(path->start, warm->holds);
    }
    if (m->answer.known && kern_known_part(m, path, most))
        return kern_before(path, kern_aside(path));
    path->fails = KERN_INFINITY;
    return at;
}

/* The critical value of a path; where verdicts may change more than once, even
   is the width of a walk's steps. Where they change but once, it is 0: the pass
   is asked just before that of the part that fell last, until it finds none. */
static kern_status kern_path_search(kern_model *m, kern_path *path,
                                    kern_real even)
{
    kern_status status = KERN_UNDECIDED;
    kern_real at, then = KERN_R(0), step = path->unit * KERN_CLIMB;
    int round;
    path->start = path->holds;
    path->fails = path->exact = path->proven.high = KERN_INFINITY;
    if (even > 0) { /* gravity turns in larger steps */
        step *= KERN_R(path->kind == KERN_PATH_TILT);
        return kern_path_climb(m, path, step, step, even);
    }
    if (path->kind != KERN_PATH_SHRINK)
        step = path->unit * KERN_CLIMB_PUSH;
    if (m->whole || path->kind != KERN_PATH_SHRINK)
        return kern_path_whole(m, path, step, step);
    if (m->graph.groups <= KERN_SMALL) { /* a part that falls ends it soon; what
            stands at the first place mostly stands to the end, or nearly */
        step *= KERN_CLIMB_GROWS;
        then = m->answer.known ? then : path->end;
    }
    at = kern_path_first(m, path, step);
    for (round = 0; round < KERN_FEW_ROUNDS;) {
        const kern_query q = kern_path_at(path, at);
        kern_model_arms(m, &q);
        kern_known_begin(m, at);
        status = kern_model_pass(m, path->part, &q,
                                 KERN_CLUSTER + 1
                                     + 2 * (m->answer.known != NULL));
        if (status == KERN_STANDS)
            kern_path_note(m, path, status, at);
        else if (status == KERN_FALLS)
            status = kern_path_part(m, path, at);
        if (status == KERN_FALLS && path->fails > path->start) {
            at = kern_before(path, kern_aside(path));
            kern_model_unload(m);
            status = KERN_UNDECIDED;
            round++;
        } else if (status != KERN_STANDS || path->fails < KERN_INFINITY)
            break;
        else if (at >= path->end)
            return kern_path_saturate(path);
        else {
            at = kern_min(kern_max(at + step, then), path->end);
            step *= KERN_CLIMB_GROWS;
        }
    }
    return status != KERN_UNDECIDED
             ? status
             : kern_path_whole(m, path, at - path->holds, step);
}

/* ---- The measures --------------------------------------------- >>measure */

/* Along the path a load grows or gravity turns instead. */
KERN_SHARED static void kern_path_push(kern_path *path, kern_path_kind kind,
                                       const kern_wrench *pattern,
                                       kern_side side)
{
    path->kind = kind;
    path->q.pattern = pattern;
    path->q.side = side;
    path->unit = KERN_R(1);
}

/* What a call works on. */
typedef struct kern_call {
    kern_model m;
    kern_part part;
    kern_path path;
} kern_call;

/* Checks the task and opens its path, with kerns shrunk to begin with; `out` is
   where the answer goes. What that costs is charged before. */
static kern_status kern_call_open(kern_call *c, const kern_task *task,
                                  kern_real shrink, const void *out)
{
    kern_path *const path = &c->path;
    kern_status status = kern_task_check(task, shrink, out);
    if (status != KERN_OK)
        return status;
    if (!kern_spend(task->work, task->options.limit,
                    1 + (task->s.blocks + task->s.contacts) / 5))
        return KERN_LIMIT;
    status = kern_query_read(task, shrink, &path->q);
    if (status != KERN_OK)
        return status;
    path->kind = KERN_PATH_SHRINK;
    path->part = &c->part;
    path->proof = NULL;
    path->alone = path->never = 0;
    path->ipm = NULL;
    path->unit = task->options.relative ? 1 : path->q.mean;
    path->start = path->holds = path->critical = KERN_R(0);
    path->warm.fails = KERN_R(0);
    path->proven.low = KERN_R(-1);
    path->proven.high = path->exact = path->fails = KERN_INFINITY;
    return kern_model_open(&c->m, task, &path->q);
}

/* The same of a call whose answer is a number: -1 where it ends unread. */
KERN_SHARED static kern_status kern_number_open(kern_call *c,
                                                const kern_task *task,
                                                kern_real shrink,
                                                kern_real *number)
{
    const kern_status status = kern_call_open(c, task, shrink, number);
    if (status == KERN_LIMIT)
        *number = KERN_R(-1);
    return status;
}

KERN_API kern_status kern_verdict(const kern_task *task, kern_real shrink,
                                  const kern_proof *proof)
{
    kern_call c;
    kern_status status = kern_call_open(&c, task, shrink, task);
    if (status != KERN_OK)
        return status;
    status = kern_model_evaluate(&c.m, &c.part, &c.path.q);
    kern_proof_out(&c.m, proof, status);
    return kern_ended(task, status);
}

/* Algorithm 1 of the paper: the first k at which kerns shrunk by k steps hold
   no longer; last + 1 if they always do, -1 if a verdict is undecided. Up to
   path->holds they do; where kerns are nested, none does from path->fails. */
static void kern_level_scan(kern_model *m, const kern_path *path, int nested,
                            int last, kern_margin *out)
{
    kern_status status = KERN_STANDS;
    int k = (int)(path->holds / out->epsilon);
    for (k += k == 0; k <= last && status == KERN_STANDS; k++) {
        const kern_query q = kern_path_at(
            path, kern_min(KERN_R(k) * out->epsilon, out->most));
        if (q.shrink > path->holds)
            status = nested && q.shrink >= path->fails
                       ? KERN_FALLS
                       : kern_model_evaluate(m, path->part, &q);
    }
    out->level = status == KERN_STANDS ? last + 1
               : status == KERN_FALLS  ? k - 1
                                       : -1;
}

/* The measure of an open task, with what is known of one like it. Where
   kerns are not nested, all levels are among the even steps. */
static kern_status kern_measure_task(kern_call *c, const kern_known *known,
                                     kern_margin *out, const kern_proof *proof)
{
    const kern_task *const task = c->m.task;
    kern_path *const path = &c->path;
    kern_real range[2], steps, first;
    const int nested = kern_is_nested(&c->m, range);
    kern_margin r = {0, 0, 0, range[1], task->options.epsilon, 0, 0};
    kern_status status;
    int last;
    path->proof = proof;
    path->warm = *known;
    kern_model_know(&c->m, known);
    path->end = r.most;
    if (!(r.epsilon > 0))
        r.epsilon = path->q.relative ? KERN_R(0.05) : KERN_R(0.02) * c->m.mean;
    steps = r.most / r.epsilon;
    if (!(steps <= KERN_POINTS_MOST))
        return KERN_BAD_STEP;
    last = (int)steps;
    last += KERN_R(last) < steps; /* until every kern is closed */
    first = kern_min(r.epsilon, r.most);
    status = nested ? KERN_STANDS : kern_path_evaluate(&c->m, path, KERN_R(0));
    if (status == KERN_STANDS)
        status = kern_path_search(
            &c->m, path,
            nested ? KERN_R(0)
                   : first / KERN_R(1 + (int)(KERN_SCAN * first / r.most)));
    if (status == KERN_STANDS) {
        r.margin = path->critical;
        r.holds = path->holds;
        r.fails = path->fails;
        r.saturated = path->never;
        kern_level_scan(&c->m, path, nested, last, &r);
    }
    status = kern_ended(task, status);
    if (status == KERN_LIMIT) {
        r.fails = kern_min(path->proven.high, r.most);
        r.margin = r.holds = kern_min(path->proven.low, r.fails);
        r.level = -1;
        r.saturated = 0;
    }
    if (status >= 0 || status == KERN_LIMIT)
        *out = r;
    return status;
}

/* The same of a task that is not open yet. */
static kern_status kern_measure_anew(const kern_task *task,
                                     const kern_known *known, kern_margin *out,
                                     const kern_proof *proof)
{
    kern_call c;
    const kern_status status = kern_call_open(&c, task, KERN_R(0), out);
    if (status == KERN_OK)
        return kern_measure_task(&c, known, out, proof);
    if (status != KERN_LIMIT)
        return status;
    out->margin = out->holds = KERN_R(-1);
    out->fails = out->most = out->epsilon = KERN_INFINITY;
    out->level = -1;
    out->saturated = 0;
    return status;
}

KERN_API kern_status kern_measure(kern_task *task, kern_margin *out,
                                  const kern_proof *proof)
{
    kern_known known;
    kern_proof kept;
    kern_status status;
    if (!task)
        return KERN_BAD_POINTER;
    known = task->known;
    if (!known.motion || !known.force) {
        known.fails = KERN_R(0);
        return kern_measure_anew(task, &known, out, proof);
    }
    kept.force = known.force;
    kept.motion = known.motion;
    known.force = NULL; /* what was remembered is overwritten on the way */
    status = kern_measure_anew(task, &known, out, &kept);
    if (status >= KERN_UNDECIDED || status == KERN_LIMIT)
        task->known.fails = KERN_R(0);
    if (status >= 0 && proof && proof->force)
        kern_copy(proof->force, kept.force, 2 * task->s.contacts);
    if (status >= 0 && !out->saturated && proof && proof->motion)
        kern_copy(proof->motion, kept.motion, 3 * task->s.blocks);
    if (status == KERN_STANDS) {
        if (out->saturated)
            kern_zero(kept.motion, 3 * task->s.blocks);
        task->known.holds = out->holds;
        task->known.margin = out->margin;
        task->known.fails = out->fails;
    }
    return status;
}

/* Grows the kerns of what falls, to the bound in >>rules, until it stands. */
static kern_status kern_grow(kern_model *m, kern_path *path)
{
    kern_real range[2], grown = path->unit * KERN_R(0.001), limit;
    const kern_real growth = kern_is_nested(m, range) ? KERN_R(4) : KERN_R(1.1);
    const kern_real none = KERN_INFINITY;
    kern_box whole = {{none, none}, {-none, -none}};
    kern_status status;
    int i;
    for (i = 0; i < 2 * m->graph.groups; i++) {
        const kern_block *b = m->s->block + m->graph.block[i / 2];
        const kern_real way = kern_block_size(b) * KERN_R(i & 1 ? 0.5 : -0.5);
        kern_box_add(&whole,
                     b->vertices
                         ? i & 1 ? b->box.high : b->box.low
                         : kern_vec_add(b->centre, kern_vec_make(way, way)));
    }
    limit = 1000 * kern_vec_largest(kern_vec_sub(whole.high, whole.low));
    if (path->q.relative)
        limit = range[0] < KERN_INFINITY ? limit / range[0] : KERN_R(1);
    path->start = -limit;
    for (;; grown = kern_min(grown * growth, limit)) {
        status = kern_path_evaluate(m, path, -grown);
        if (status != KERN_FALLS && status != KERN_UNDECIDED)
            break;
        if (grown >= limit) {
            path->critical = -KERN_INFINITY;
            return status;
        }
    }
    if (status == KERN_STANDS)
        status = kern_path_critical(m, path);
    return status == KERN_STANDS ? KERN_FALLS : status;
}

KERN_API kern_status kern_deficit(const kern_task *task, kern_real *deficit)
{
    kern_call c;
    kern_status status = kern_number_open(&c, task, KERN_R(0), deficit);
    if (status != KERN_OK)
        return status;
    status = kern_path_evaluate(&c.m, &c.path, KERN_R(0));
    if (status == KERN_FALLS)
        status = kern_grow(&c.m, &c.path);
    status = kern_ended(task, status);
    if (status == KERN_LIMIT)
        *deficit = c.path.proven.high <= 0 ? 0 - c.path.proven.high
                                           : KERN_R(-1);
    else if (status >= 0)
        *deficit = status == KERN_STANDS ? KERN_R(0) : 0 - c.path.critical;
    return status;
}

/* A contact's length between lo and hi, near their logarithmic middle, or 0. */
static kern_real kern_length_between(const kern_structure *s, kern_real mean,
                                     kern_real lo, kern_real hi)
{
    kern_real middle = KERN_R(0), least = hi, most;
    int i, pass;
    for (pass = 0; pass < 2; pass++) {
        least = hi;
        most = lo;
        for (i = 0; i < s->contacts; i++) {
            const kern_real length = kern_contact_length(s->contact + i, mean);
            if (length > lo && length < hi && length >= middle) {
                least = kern_min(least, length);
                most = kern_max(most, length);
            }
        }
        middle = kern_min(KERN_SQRT(least) * KERN_SQRT(most), most);
    }
    return least < hi ? least : KERN_R(0);
}

KERN_API kern_status kern_bearing(const kern_task *task, kern_real *length,
                                  const kern_proof *proof)
{
    kern_real at = KERN_R(0), lo = KERN_R(-1), hi = KERN_INFINITY;
    kern_call c;
    int round;
    kern_status status = kern_number_open(&c, task, at, length);
    if (status != KERN_OK)
        return status;
    for (round = 0; round < 2 || at > 0; round++) {
        c.path.q.shortest = at;
        kern_model_group(&c.m, &c.path.q);
        status = kern_model_evaluate(&c.m, &c.part, &c.path.q);
        kern_proof_out(&c.m, proof, status);
        if (status == KERN_STANDS)
            lo = at;
        else if (lo < 0 || status < KERN_UNDECIDED)
            break;
        else
            hi = at;
        if (status == KERN_UNDECIDED && proof && proof->motion)
            kern_zero(proof->motion, 3 * task->s.blocks);
        at = round == 0 ? KERN_INFINITY
                        : kern_length_between(&task->s, c.path.q.mean, lo, hi);
        status = KERN_STANDS;
    }
    status = kern_ended(task, status);
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *length = lo;
    return status;
}

/* Gravity and a side to turn it to. */
static int kern_has_side(const kern_structure *s, kern_side side)
{
    return (side == KERN_RIGHT || side == KERN_LEFT)
        && kern_vec_largest(s->gravity) > 0;
}

/* The angle whose tangent is s >= 0: halved three times, then the series. */
static kern_real kern_angle_of(kern_real s)
{
    kern_real sum = KERN_R(0), t2;
    int i;
    s = kern_halved(kern_halved(kern_halved(s)));
    t2 = s * s;
    for (i = 25; i > 0; i -= 2)
        sum = KERN_R(1) / KERN_R(i) - t2 * sum;
    return 8 * s * sum;
}

/* Checks what grows: a pattern, or a load or tilt that has a side (NULL). */
static kern_status kern_growth_check(const kern_task *task,
                                     const kern_wrench *pattern, kern_side side)
{
    int i;
    if (!pattern && !kern_has_side(&task->s, side))
        return KERN_BAD_OPTION;
    for (i = 0; pattern && i < task->s.blocks; i++)
        if (!task->s.block[i].fixed
            && !(kern_wrench_sum(pattern + i) <= KERN_FAR)) {
            task->work->fault.block = i;
            return KERN_BAD_NUMBER;
        }
    return KERN_OK;
}

/* Runs a path on which a load grows or gravity turns. */
static kern_status kern_run(kern_call *c, const kern_task *task,
                            kern_real shrink, kern_path_kind kind,
                            const kern_wrench *pattern, kern_side side,
                            kern_real *out, const kern_proof *proof)
{
    const int tilt = kind == KERN_PATH_TILT;
    kern_path *const path = &c->path;
    int loaded;
    kern_status status = kern_number_open(c, task, shrink, out);
    if (status == KERN_OK)
        status = kern_growth_check(task, pattern, side);
    if (status != KERN_OK)
        return status;
    /* under loads that stay a tilt may stand again after it fell */
    loaded = tilt && kern_model_loaded(&c->m);
    kern_path_push(path, kind, pattern, side);
    path->proof = proof;
    path->end = tilt ? KERN_R(1) : KERN_FACTOR_MOST;
    if (!loaded && kern_model_is_small(&c->m))
        kern_model_whole(&c->m, path->part, &path->q);
    status = kern_path_evaluate(&c->m, path, KERN_R(0));
    if (status == KERN_STANDS)
        status = kern_path_search(&c->m, path, KERN_R(loaded) / KERN_SCAN);
    status = kern_ended(task, status);
    if (status == KERN_LIMIT)
        path->critical = path->proven.low;
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *out = tilt        ? 4 * kern_angle_of(path->critical)
             : path->never ? KERN_INFINITY
                           : path->critical;
    return status;
}

KERN_API kern_status kern_load_factor(const kern_task *task, kern_real shrink,
                                      kern_side side, kern_real *factor,
                                      const kern_proof *proof)
{
    kern_call c;
    return kern_run(&c, task, shrink, KERN_PATH_LOAD, NULL, side, factor,
                    proof);
}

KERN_API kern_status kern_load_factor_of(const kern_task *task,
                                         kern_real shrink,
                                         const kern_wrench *pattern,
                                         kern_real *factor,
                                         const kern_proof *proof)
{
    kern_call c;
    return pattern ? kern_run(&c, task, shrink, KERN_PATH_LOAD, pattern,
                              KERN_SHRINK, factor, proof)
                   : KERN_BAD_POINTER;
}

KERN_API kern_status kern_tilt(const kern_task *task, kern_real shrink,
                               kern_side side, kern_real *angle,
                               const kern_proof *proof)
{
    kern_call c;
    return kern_run(&c, task, shrink, KERN_PATH_TILT, NULL, side, angle, proof);
}

KERN_API kern_status kern_forces(const kern_task *task, kern_real shrink,
                                 kern_force *force)
{
    const kern_proof proof = {force, NULL};
    kern_call c;
    kern_part *p = &c.part;
    kern_status status = kern_call_open(&c, task, shrink, force);
    if (status == KERN_OK) {
        kern_model_set(&c.m, &c.path.q);
        status = kern_norm_open(p, &c.m)
                   ? kern_norm_find(p, kern_part_load(p, &c.path.q, p->dual.b),
                                    KERN_BOUND, 0, KERN_ROUNDS)
                   : KERN_NO_SPACE;
        if (status == KERN_FALLS) /* unproven */
            status = KERN_UNDECIDED;
        if (status == KERN_STANDS) {
            kern_norm_write(p);
            if (!kern_answer_holds(&c.m, &c.path.q))
                status = KERN_UNDECIDED;
        }
        status = kern_ended(task, status);
    }
    kern_proof_out(&c.m, &proof, status);
    return status;
}

/* ---- The profile --------------------------------------------- >>profile */
/* Progressive collapse: the path goes on past its critical value, without what
   moves there. A model of fewer blocks is the same one with fewer groups. */

typedef struct kern_fall {
    int weak;         /* places in the weaker half that are not taken */
    kern_real sum;    /* of the values of that half                   */
    kern_real *value; /* of each block, -1 as long as it stands       */
} kern_fall;

/* Blocks that are left fall there: all, or those that move in the mechanism. */
static void kern_fall_add(const kern_model *m, kern_fall *fall, kern_real at,
                          int all)
{
    const kern_motion *v = m->answer.motion;
    int i;
    for (i = 0; i < m->s->blocks; i++)
        if (m->graph.group[i] < m->graph.groups
            && (all || kern_block_speed(m->s->block + i, v + i) > KERN_REST)) {
            fall->value[i] = at;
            if (fall->weak-- > 0)
                fall->sum += at;
        }
}

/* Evaluates where it fell last, and farther on while that is undecided. */
static kern_status kern_fall_beyond(kern_model *m, kern_path *path)
{
    kern_real beyond = path->fails;
    kern_status status;
    int more = KERN_FEW_ROUNDS;
    do {
        status = kern_path_evaluate(m, path, beyond);
        beyond += kern_width(path);
    } while (status == KERN_UNDECIDED && more-- > 0);
    return status;
}

/* The whole collapse along a path, from one critical value to the next, and to
   the mechanism there: the last verdict of a search may be another. Rounds that
   take nothing away, where both proofs hold at one place, are bounded. */
static kern_status kern_fall_follow(kern_model *m, kern_path *path,
                                    kern_fall *fall)
{
    kern_real range[2], at = KERN_R(0);
    kern_status status = kern_path_evaluate(m, path, at);
    int rounds = 3 * m->graph.groups + KERN_FEW_ROUNDS;
    while (m->graph.groups > 0 && !path->never) {
        if (rounds-- == 0)
            return KERN_UNDECIDED;
        if (status == KERN_FALLS) { /* the rest, just beyond the proof */
            kern_fall_add(m, fall, at, 0);
            kern_model_group(m, &path->q);
            if (m->graph.groups > 0)
                status = kern_fall_beyond(m, path);
        } else if (status == KERN_STANDS) {
            status = kern_path_search(m, path,
                                      path->kind != KERN_PATH_SHRINK
                                              || kern_is_nested(m, range)
                                          ? KERN_R(0)
                                          : path->end / KERN_SCAN);
            at = path->critical;
            if (status == KERN_STANDS && !path->never)
                status = kern_fall_beyond(m, path);
        } else
            return status;
    }
    kern_fall_add(m, fall, path->end, 1);
    return KERN_OK;
}

/* e^-x for x >= 0, by the first terms of the series of e^x squared ten times:
   libm may differ from machine to machine. Within 2e-4 of itself up to 10. */
static kern_real kern_decay(kern_real x)
{
    const kern_real t = x / KERN_R(1024);
    kern_real y = 1 + t + t * t / 2;
    int i;
    for (i = 0; i < 10; i++)
        y *= y;
    return 1 / y;
}

/* A stone's chance to fall times how far, above the lowest of them: the sum. */
static kern_real kern_expected_drop(const kern_model *m, const kern_real *value)
{
    const kern_structure *s = m->s;
    const kern_real pull = kern_vec_length(s->gravity);
    kern_real base = KERN_INFINITY, sum = KERN_R(0);
    int i, pass;
    for (pass = 0; pass < 2; pass++)
        for (i = 0; i < s->blocks; i++) {
            const kern_block *b = s->block + i;
            const kern_real at = -kern_vec_dot(b->centre, s->gravity) / pull;
            if (b->fixed)
                continue;
            if (pass == 0)
                base = kern_min(base, at - kern_block_size(b) / 2);
            else
                sum += kern_max(KERN_DROP_HEIGHT, (at - base) / m->mean)
                     * kern_decay(value[i] / KERN_DROP_LOAD);
        }
    return sum;
}

KERN_API kern_status kern_profile(const kern_task *task, kern_side side,
                                  kern_real *value, kern_collapse *out)
{
    kern_call c;
    kern_fall fall;
    kern_real range[2], least = KERN_INFINITY, sum = KERN_R(0);
    int i, free_blocks, half;
    kern_status status = kern_call_open(&c, task, KERN_R(0),
                                        value ? out : NULL);
    for (i = 0;
         (status == KERN_OK || status == KERN_LIMIT) && i < task->s.blocks; i++)
        value[i] = KERN_R(-1);
    if (status != KERN_OK)
        return status;
    kern_is_nested(&c.m, range);
    if (side != KERN_SHRINK && !kern_has_side(&task->s, side))
        return KERN_BAD_OPTION;
    if (side != KERN_SHRINK)
        kern_path_push(&c.path, KERN_PATH_LOAD, NULL, side);
    c.path.end = side ? KERN_PROFILE_MOST : range[1];
    c.path.q.fallen = value;
    free_blocks = c.m.graph.groups;
    fall.weak = half = (free_blocks + 1) / 2;
    fall.sum = sum;
    fall.value = value;
    status = kern_ended(task, kern_fall_follow(&c.m, &c.path, &fall));
    for (i = 0; i < task->s.blocks; i++) {
        if (task->s.block[i].fixed)
            value[i] = KERN_INFINITY;
        else
            sum += value[i];
        least = kern_min(least, value[i]);
    }
    if (status != KERN_OK)
        return status;
    out->least = least;
    out->mean = sum / KERN_R(free_blocks);
    out->weak = fall.sum / KERN_R(half);
    out->drop = side ? kern_expected_drop(&c.m, value) / KERN_R(free_blocks)
                     : KERN_R(0);
    return KERN_OK;
}

/* ---- What is critical ---------------------------------------- >>critical */

static kern_meeting kern_meeting_of(const kern_contact *c, kern_real mu,
                                    kern_vec u, kern_real turn)
{
    const kern_real along = kern_abs(kern_vec_cross(c->n, u));
    if (kern_vec_dot(c->n, u) > mu * along + KERN_REST)
        return KERN_OPENS;
    if (along > KERN_REST)
        return KERN_SLIDES;
    return kern_abs(turn) > KERN_REST ? KERN_HINGES : KERN_RESTS;
}

/* How much a contact point limits is told by the first of these that any has:
   the power f w that moving inward with a force f costs while the blocks turn
   at w, unless its kern is closed; the rate of a hinge; the speed of slides. */
static void kern_critical_contacts(const kern_structure *s, const kern_query *q,
                                   const kern_proof *proof, kern_critical *out)
{
    kern_real most = KERN_R(0), narrow = kern_reduction(q), rate;
    int by, i;
    for (by = !proof->force; by < 3 && out->contact < 0; by++)
        for (i = 0; i < s->contacts; i++) {
            const kern_contact *c = s->contact + i;
            const kern_vec u = kern_meeting_motion(s, q, c, proof->motion);
            const kern_real spin = proof->motion[c->b].spin
                                 - proof->motion[c->a].spin;
            const kern_meeting meeting = kern_meeting_of(
                c, kern_friction(c, narrow), u, spin * q->mean);
            kern_real limit = KERN_R(0);
            kern_shift(c->travel, q->shrink, q->relative, &rate);
            if (by == 0 && meeting != KERN_OPENS)
                limit = kern_max(-spin * rate * proof->force[i].normal, 0);
            if (by == 1 && meeting == KERN_HINGES)
                limit = kern_abs(spin);
            if (by == 2 && meeting == KERN_SLIDES)
                limit = kern_vec_length(u);
            if (out->meeting)
                out->meeting[i] = meeting;
            if (out->limit)
                out->limit[i] = limit;
            if (limit > most * (1 + KERN_REST)) {
                most = limit;
                out->contact = i;
            }
        }
    for (i = 0; i < s->contacts && out->limit && most > 0; i++)
        out->limit[i] /= most;
}

/* Whether two blocks move as one rigid body. */
static int kern_as_one(const kern_structure *s, const kern_motion *motion,
                       int i, int j)
{
    const kern_vec r = kern_vec_sub(s->block[j].centre, s->block[i].centre);
    const kern_vec v = kern_velocity(motion + i, r);
    kern_motion apart = motion[j];
    apart.vx -= v.x;
    apart.vy -= v.y;
    apart.spin -= motion[i].spin;
    return kern_block_speed(s->block + j, &apart) < KERN_REST;
}

/* Groups around the fastest block that is in none. */
static void kern_critical_blocks(const kern_structure *s,
                                 const kern_motion *motion, kern_critical *out)
{
    const int none = s->blocks;
    int i, lead;
    for (i = 0; i < s->blocks; i++)
        out->group[i] = none;
    for (;; out->groups++) {
        kern_real most = KERN_R(0);
        for (lead = i = 0; i < s->blocks; i++) {
            const kern_real speed = kern_block_speed(s->block + i, motion + i);
            if (speed < KERN_REST)
                out->group[i] = -1;
            if (out->group[i] == none && speed > most * (1 + KERN_REST)) {
                most = speed;
                lead = i;
            }
        }
        if (!(most > 0))
            return;
        for (i = 0; i < s->blocks; i++)
            if (out->group[i] == none && kern_as_one(s, motion, lead, i))
                out->group[i] = out->groups;
    }
}

KERN_API kern_status kern_critical_of(const kern_task *task, kern_real shrink,
                                      const kern_proof *proof,
                                      kern_critical *out)
{
    kern_query q;
    int i;
    const kern_status status = kern_query_check(
        task, shrink, proof && proof->motion ? out : NULL, &q);
    if (status != KERN_OK)
        return status;
    for (i = 0; i < task->s.blocks; i++)
        if (!kern_is_finite(kern_speed(proof->motion + i))) {
            task->work->fault.block = i;
            return KERN_BAD_NUMBER;
        }
    out->contact = -1;
    out->groups = 0;
    kern_critical_contacts(&task->s, &q, proof, out);
    if (out->group)
        kern_critical_blocks(&task->s, proof->motion, out);
    return KERN_OK;
}

/* ---- Sensitivity ------------------------------------------- >>sensitivity */
/* At the margin d* the power G of forces and loads on the mechanism is 0, also
   if a datum q changes: d*' = -G_q / G_d, by forces and motion of the proof. */

/* G_q of contact i, and its share of G_d: 0 without a force or a motion. */
static kern_real kern_contact_gain(const kern_structure *s, const kern_query *q,
                                   int i, const kern_proof *proof,
                                   kern_contact_rate *out)
{
    const kern_contact *c = s->contact + i;
    const kern_vec t = kern_vec_turn(c->n);
    const kern_real f = proof->force[i].normal, r = proof->force[i].tangential;
    const kern_vec force = kern_vec_step(kern_vec_scale(c->n, f), r, t);
    const kern_real travel = kern_travel(c, q->mean);
    const int closed = !q->relative && q->shrink >= kern_abs(travel);
    const kern_real spin = proof->motion[c->b].spin - proof->motion[c->a].spin;
    kern_real rate, shift;
    kern_vec u;
    kern_zero(out, 5);
    if (!(f > 0) || !(kern_speeds(c, proof->motion) > 0))
        return KERN_R(0);
    u = kern_meeting_motion(s, q, c, proof->motion);
    shift = kern_shift(travel, q->shrink, q->relative, &rate);
    out->p = kern_vec_make(spin * force.y, -spin * force.x);
    out->turn = kern_vec_cross(force, u) - shift * spin * r;
    if (c->mu > 0)
        out->mu = r / c->mu * kern_vec_dot(u, t);
    if (q->relative || closed)
        out->travel = -spin * f * (closed ? KERN_R(1) : q->shrink);
    return -rate * spin * f;
}

/* What the blocks of contact i move of it, as the search would find it; pair is
   the other end of its line, or i. Line: corners take ends along, which stay
   midway between the edges; normal and middle take half of what an end does.
   Point: a corner takes it along, an edge turns the normal. */
KERN_SHARED static void kern_pose_gain(const kern_task *task,
                                       const kern_contact_rate *rate, int i,
                                       int pair, kern_block_rate *out)
{
    const kern_contact *c = task->s.contact + i;
    const kern_vec t = kern_vec_turn(c->n);
    const kern_real along = kern_vec_dot(rate[i].p, t)
                          + (rate[pair].travel - rate[i].travel) / 2;
    const kern_real across = kern_vec_dot(rate[i].p, c->n);
    kern_real off[2]; /* along the contact to the nearest corner */
    int end, k;
    if (!(kern_abs(along) + kern_abs(across) + kern_abs(rate[i].turn) > 0))
        return;
    for (end = 0; end < 2; end++) {
        const kern_block *b = task->s.block + (end ? c->b : c->a);
        off[end] = KERN_INFINITY;
        for (k = 0; b->vertex && k < b->vertices; k++) {
            const kern_vec r = kern_vec_sub(b->vertex[k], c->p);
            const kern_real at = kern_abs(kern_vec_cross(c->n, r));
            if (at < off[end]
                && kern_abs(kern_vec_dot(c->n, r))
                       <= KERN_GAP * kern_block_size(b) + task->options.gap)
                off[end] = at;
        }
    }
    for (end = 0; end < 2; end++) {
        const int on = end ? c->b : c->a;
        const kern_block *b = task->s.block + on;
        const kern_vec r = kern_vec_sub(c->p, b->centre);
        const kern_real size = kern_block_size(b);
        const kern_real owns = KERN_R(off[end] <= KERN_GAP * size
                                      && off[end]
                                             <= off[!end] + KERN_SLIGHT * size);
        const kern_real part = pair != i ? KERN_R(0.5) : owns;
        const kern_vec way = kern_vec_step(kern_vec_scale(t, owns * along),
                                           part * across, c->n);
        kern_block_rate *to = out + on;
        if (b->vertex) {
            to->place = kern_vec_add(to->place, way);
            to->turn += kern_vec_cross(r, way) + (1 - part) * rate[i].turn;
        }
    }
}

KERN_API kern_status kern_sensitivity(const kern_task *task,
                                      const kern_margin *margin,
                                      const kern_proof *proof,
                                      kern_contact_rate *contact,
                                      kern_block_rate *block)
{
    kern_query q;
    kern_real gain = KERN_R(0), most = KERN_R(0);
    int i, end, line;
    kern_status status = kern_query_check(
        task, margin ? margin->margin : KERN_R(0),
        margin && proof && proof->force && proof->motion && contact ? block
                                                                    : NULL,
        &q);
    if (status != KERN_OK)
        return status;
    for (i = 0; i < task->s.contacts; i++) {
        const kern_real g = kern_contact_gain(&task->s, &q, i, proof,
                                              contact + i);
        gain += g;
        most += kern_abs(g);
    }
    if (margin->saturated || !(kern_abs(gain) > KERN_NOISE * most))
        return KERN_UNDECIDED;
    for (i = 0; i < task->s.blocks; i++) {
        const kern_block *b = task->s.block + i;
        const kern_real mass = b->fixed ? KERN_R(0) : b->mass;
        const kern_vec g = task->s.gravity;
        const kern_motion *v = proof->motion + i;
        kern_copy(&block[i].load, v, 3);
        block[i].turn = KERN_R(0);
        block[i].place = block[i].centre = kern_vec_make(
            v->spin * (g.y * mass), -v->spin * (g.x * mass));
        block[i].mass = g.x * v->vx + g.y * v->vy;
    }
    for (i = 0; i < task->s.contacts; i += 1 + line) {
        line = kern_line_begins(task->s.contact, task->s.contacts, i);
        for (end = 0; end <= line; end++)
            kern_pose_gain(task, contact, i + end, i + line - end, block);
    }
    kern_scale(contact, 5 * task->s.contacts, -1 / gain);
    kern_scale(block, 9 * task->s.blocks, -1 / gain);
    return KERN_OK;
}

/* ---- Raised ----------------------------------------------------- >>raised */
/* Forces that a load puts on unstressed contacts of some stiffness. They are
   looked for as minimum-norm forces of stiff contacts (>>norm), a program with
   a solution wherever forces exist, but with the associated flow rule of limit
   analysis, by which what slides parts: f = k (approach + mu slip). A price mu
   slip on each contact takes that away (the fixed point of Acary, Cadoux,
   Lemarechal and Malick). Prices need not be exact (kern_prove_raised()). They
   are extrapolated (Anderson's method with one difference): where no contact
   opens or begins to slide, the map of prices is linear. Along a load they fall
   slowly: else those of joints that lean on each other alternate. */

typedef struct kern_raise {
    kern_part *p;            /* all groups, or those near a block            */
    kern_real *last;         /* two a contact: last outcome, and its change  */
    int size;                /* numbers of u and prices, one after the other */
    kern_real *begin, *best; /* both: without a push, with the largest so far;
                                 the last two along a load                    */
    int around;              /* the block asked about, or KERN_OUT           */
    const kern_proof *proof; /* that each step along a load writes, or NULL  */
} kern_raise;

/* Marks all but the n groups near block i, and the ground, as place n. */
static void kern_raise_near(kern_model *m, int i)
{
    const int *ends = m->graph.ends, groups = m->graph.groups;
    int *local = m->graph.local, g, e, at, n = 1;
    for (g = 0; g < groups; g++)
        local[g] = 0;
    local[groups] = local[m->graph.group[i]] = 1;
    for (at = 1; at <= KERN_STAYS_NEAR; at++)
        for (g = 0; g < groups; g++)
            for (e = local[g] == at ? m->graph.touch[g] : KERN_OUT; e >= 0;
                 e = m->graph.after[e])
                if (local[ends[e ^ 1]] == 0) {
                    local[ends[e ^ 1]] = at + 1;
                    n++;
                }
    for (g = 0; g < groups; g++)
        local[g] = local[g] > 0 ? KERN_OUT : n;
    local[groups] = n;
}

/* Opens the groups as one part, without prices; 0: no room. Stiffness, a tenth
   plus the length in mean sizes: of the laws tried nearest to a simulator. */
static int kern_raise_open(kern_raise *r, kern_model *m)
{
    kern_part *p = r->p;
    int k;
    if (r->around >= 0)
        kern_raise_near(m, r->around);
    if (!kern_norm_open(p, m))
        return 0;
    p->y = p->dual.step;
    p->dual.stiff = r->around < 0 ? KERN_R(1.1) / KERN_STICKS /* it proves */
                                  : KERN_STAYS_STIFF;
    r->size = 3 * p->groups + 3 + p->contacts;
    p->dual.u = kern_take_reals(&p->rest, 3 * r->size + 3 * p->contacts);
    if (!kern_take_fits(&p->rest))
        return 0;
    p->dual.price = p->dual.u + r->size - p->contacts;
    r->last = p->dual.price + 2 * p->contacts;
    r->begin = r->last + 2 * p->contacts;
    r->best = r->begin + r->size;
    kern_zero(p->dual.price, p->contacts);
    for (k = 0; k < p->contacts; k++) {
        const kern_contact *c = m->s->contact + p->contact[k];
        p->dual.price[p->contacts + k] =
            KERN_R(0.1) + (c->line ? kern_abs(c->travel) / m->mean : KERN_R(0));
    }
    return 1;
}

/* Writes the forces, and what prices lead to. Returns whether every loaded
   contact approaches, and none slides so far as only a stone that falls into a
   jam. Along a load prices fall slowly, and a contact that parts keeps its
   price where forces were found; where that is too low to open it, it grows by
   twice what is missing: else a joint that no longer presses stays loaded. */
static int kern_raise_price(kern_raise *r, kern_real tolerance, int along,
                            int found)
{
    kern_part *p = r->p;
    kern_model *m = p->m;
    kern_real slid = KERN_R(0), most = KERN_R(0);
    int k, pressed = found;
    kern_norm_write(p);
    for (k = 0; k < p->contacts; k++) {
        const int i = p->contact[k];
        const kern_real *w = p->dual.way + 2 * (size_t)k;
        kern_real *to = p->dual.turn + 2 * (size_t)k;
        const kern_real mu = kern_model_mu(m, i), price = p->dual.price[k];
        const kern_real approach = w[0] + price;
        const kern_real slip = kern_abs(w[1])
                             - kern_max(approach, 0) / p->dual.stiff;
        if (m->answer.force[i].normal > tolerance * m->weight) {
            pressed &= approach > 0;
            slid = kern_max(slid, slip);
            most = kern_max(most, approach);
        }
        to[0] = mu * kern_max(slip, 0);
        if (along && found && !(approach > 0))
            to[0] = kern_max(to[0], price) + 2 * kern_max(w[0] + to[0], 0);
        if (along && to[0] < price)
            to[0] = price + KERN_LOAD_FALL * (to[0] - price);
        to[1] = to[0] - price;
    }
    return pressed && slid <= KERN_NORM_MOST * most;
}

/* Makes new prices, by Anderson's method: how much of the last difference is
   taken back makes the next change least if the map is linear; more cycles. */
static void kern_raise_extrapolate(kern_raise *r, int round)
{
    const kern_part *p = r->p;
    const kern_real *to = p->dual.turn;
    kern_real up = KERN_R(0), down = KERN_R(0), back;
    int k;
    if (round == 0)
        kern_copy(r->last, to, 2 * p->contacts);
    for (k = 1; k < 2 * p->contacts; k += 2) {
        const kern_real change = to[k] - r->last[k];
        up += to[k] * change;
        down += change * change;
    }
    back = down > 0 ? kern_max(-1, kern_min(up / down, 1)) : KERN_R(0);
    for (k = 0; k < p->contacts; k++)
        p->dual.price[k] = kern_max(
            to[2 * k] - back * (to[2 * k] - r->last[2 * k]), 0);
    kern_copy(r->last, to, 2 * p->contacts);
}

/* Whether forces and u prove it; near a block none asks. */
static int kern_raise_proves(const kern_raise *r, const kern_query *q)
{
    kern_part *p = r->p;
    const kern_model *m = p->m;
    int i;
    for (i = 0; i < 3 * p->groups; i++)
        p->y[i] = -p->dual.u[i];
    kern_part_motion(p);
    if (!kern_model_proven(m,
                           kern_prove_raised(m->s, q, m->answer.force,
                                             m->answer.motion, m->answer.sum)))
        return 0;
    kern_proof_out(m, r->proof, KERN_STANDS);
    kern_proof_out(m, r->proof, KERN_FALLS);
    return 1;
}

/* Looks for a proof, from nothing (cold) or from u and prices as they are. Near
   a block in fewer rounds: slow prices are a sign that it moves. */
static int kern_raise_settle(kern_raise *r, const kern_query *q, int cold,
                             int along)
{
    kern_part *p = r->p;
    const int rounds = KERN_RAISE_ROUNDS
                     / (r->around >= 0  ? cold ? 2 : 6
                        : along || cold ? 1
                                        : 2);
    const kern_real tolerance = kern_part_load(p, q, p->dual.b);
    int round;
    if (!kern_model_ask(p->m, r->around < 0 ? 3 : 1))
        return 0;
    for (round = 0; round < rounds; round++) {
        const kern_status found = kern_norm_find(
            p, tolerance, 2 * KERN_NORM_MOST, !cold || round > 0,
            KERN_FEW_ROUNDS + 2);
        int pressed;
        if (found != KERN_STANDS && found != KERN_UNDECIDED)
            return 0;
        pressed = kern_raise_price(r, tolerance, along, found == KERN_STANDS);
        kern_raise_extrapolate(r, round);
        if (pressed && (r->around >= 0 || kern_raise_proves(r, q)))
            return 1;
    }
    return 0;
}

/* The largest of a sequence of shares of gravity, none above `most` unless that
   is 0, that it bears to either side as kerns shrink by the same share of the
   mean size, where they are not nested without that too: the worst that errors
   of places, and of angles over that size, do. Each begins at the last. */
KERN_SHARED static kern_real kern_raise_reserve(kern_raise *r,
                                                const kern_query *asked,
                                                kern_real most)
{
    static const short share[] = {
        0,  10, 20,  30,  40,  50,  55,  60,
        70, 80, 100, 150, 200, 300, 500, 1000}; /* of 10,000 */
    kern_model *m = r->p->m;
    kern_real range[2];
    const int nested = kern_is_nested(m, range);
    kern_query q = *asked;
    int low = (int)(sizeof share / sizeof share[0]) - 1, at, high;
    while (most > 0 && KERN_R(share[low]) / 10000 > most)
        low--;
    kern_copy(r->begin, r->p->dual.u, r->size);
    for (q.side = 1; q.side >= -1; q.side -= 2) {
        kern_copy(r->best, r->begin, r->size);
        for (at = low, high = low + 1, low = 0; high - low > 1;
             at = (low + high) / 2) {
            int k, good = 1;
            q.factor = KERN_R(share[at]) / 10000;
            kern_copy(r->p->dual.u, r->best, r->size);
            for (k = nested; k < 2 && good; k++) {
                q.shrink = asked->shrink
                         + (kern_real)k * q.factor
                               * (q.relative ? KERN_R(1) : m->mean);
                kern_model_arms(m, &q);
                good = kern_raise_settle(r, &q, 0, 0);
            }
            if (good)
                kern_copy(r->best, r->p->dual.u, r->size);
            low = good ? at : low;
            high = good ? high : at;
        }
    }
    return KERN_R(share[low]) / 10000;
}

/* Opens the question: whether blocks hang that nothing holds up, and the others
   stand without them, in *out, with a proof; else room for prices. */
static kern_status kern_raise_begin(kern_raise *r, kern_call *c,
                                    kern_raising *out)
{
    kern_model *m = &c->m;
    kern_query *const q = &c->path.q;
    kern_status status = KERN_STANDS;
    kern_real *value;
    int i, left;
    r->p = &c->part;
    *out = KERN_NOT_SHOWN;
    value = kern_take_last(&m->rest, m->s->blocks);
    kern_take_last(&m->common, m->s->blocks); /* both end at one place */
    if (!kern_take_fits(&m->rest))
        return KERN_NO_SPACE;
    for (i = 0; i < m->s->blocks; i++)
        value[i] = KERN_R(1);
    left = kern_hang(m->s, value);
    if (left > 0 || r->around >= 0) {
        kern_known_begin(m, q->shrink);
        status = kern_model_evaluate(m, r->p, q);
    }
    if (left > 0 && status == KERN_STANDS && kern_model_ask(m, 1)) {
        const kern_vec way = kern_vec_unit(m->s->gravity);
        q->fallen = value;
        kern_model_group(m, q);
        if (m->graph.groups == 0
            || kern_model_evaluate(m, r->p, q) == KERN_STANDS)
            *out = KERN_HANGS;
        q->fallen = NULL;
        kern_zero(m->answer.motion, 3 * m->s->blocks);
        for (i = 0; i < m->s->blocks; i++)
            kern_copy(m->answer.motion + i, &way, 2 * (value[i] >= 0));
    }
    if (status != KERN_STANDS || *out == KERN_HANGS)
        return status;
    if (left > 0 || m->whole)
        kern_model_group(m, q);
    kern_model_set(m, q);
    return kern_raise_open(r, m) ? KERN_STANDS : KERN_NO_SPACE;
}

/* Raises the load of q, by *share of it, from 0 to `most` in steps, each from
   the last two in the same direction, a fifth as long once one fails. The end
   doubles if unknown. Returns the last share proven, below 0 if none. */
static kern_real kern_raise_climb(kern_raise *r, const kern_query *q,
                                  kern_real *share, kern_real most)
{
    kern_real end = most < KERN_FACTOR_MOST ? most : KERN_R(1);
    kern_real stood = *share = KERN_R(0), taken = KERN_R(1), *u = r->p->dual.u;
    kern_real step = end / KERN_LOAD_STEPS;
    int i, good = 1;
    if (!kern_raise_settle(r, q, 1, 1))
        return KERN_R(-1);
    kern_copy(r->best, u, r->size);
    while (stood < end && step >= end / (32 * KERN_LOAD_STEPS)) {
        *share = kern_min(stood + step, end);
        for (i = 0; i < r->size; i++) {
            if (good) {
                r->begin[i] = r->best[i];
                r->best[i] = u[i];
            }
            u[i] = r->best[i]
                 + (*share - stood) / taken * (r->best[i] - r->begin[i]);
            if (u + i >= r->p->dual.price)
                u[i] = kern_max(u[i], 0);
        }
        good = kern_raise_settle(r, q, 0, 1)
            || (!(stood > 0) /* from rest nothing leads there */
                && kern_raise_settle(r, q, 1, 1));
        if (good) {
            taken = *share - stood;
            stood = *share;
        } else
            step /= 5;
        if (!(stood < end) && end < most) {
            end = kern_min(2 * end, most);
            step = end / KERN_LOAD_STEPS;
        }
    }
    return stood;
}

/* Whether it is raised, in *out: at once, or where the blocks' loads grow from
   0. Unless sag is NULL, how far the block goes until then, for a stiffness and
   a mean weight of 1; a turn by half the way of a point a size off. */
static kern_status kern_raise_show(kern_raise *r, kern_call *c,
                                   kern_raising *out, kern_real *sag)
{
    kern_query grown = c->path.q;
    const kern_status status = kern_raise_begin(r, c, out);
    if (status != KERN_STANDS || *out == KERN_HANGS)
        return status;
    if (kern_raise_settle(r, &c->path.q, 1, 0)
        || (kern_model_loaded(&c->m)
            && kern_raise_climb(r, &grown, &grown.loads, KERN_R(1)) >= 1))
        *out = KERN_RAISED;
    if (sag) {
        const kern_graph *graph = &c->m.graph;
        const kern_real *u = r->p->dual.u
                           + 3 * graph->local[graph->group[r->around]];
        *sag = (kern_real)graph->groups
             * (kern_abs(u[2]) / 2
                + kern_vec_length(kern_vec_make(u[0], u[1])));
    }
    return *out == KERN_RAISED || sag
             ? status
             : kern_model_evaluate(&c->m, r->p, &c->path.q);
}

/* kern_raised(); with a sag of what is near block i, for kern_stays(). */
static kern_status kern_raise_task(const kern_task *task, kern_real shrink,
                                   kern_raising *out, kern_real *reserve,
                                   const kern_proof *proof, int i,
                                   kern_real *sag)
{
    kern_call c;
    kern_raise r;
    kern_raising raising;
    kern_real share = KERN_R(0);
    kern_status status = kern_call_open(&c, task, shrink, out);
    if (status != KERN_OK)
        return status;
    if (reserve && !kern_has_side(&task->s, KERN_RIGHT))
        return KERN_BAD_OPTION;
    if (sag
        && ((unsigned)i >= (unsigned)task->s.blocks || task->s.block[i].fixed))
        return KERN_BAD_BLOCK;
    r.around = i;
    r.proof = NULL;
    if (sag)
        kern_model_know(&c.m, &task->known);
    status = kern_raise_show(&r, &c, &raising, sag);
    kern_proof_out(&c.m, proof, status);
    if (raising != KERN_NOT_SHOWN)
        kern_proof_out(&c.m, proof, KERN_FALLS);
    if (raising == KERN_RAISED && reserve)
        share = kern_raise_reserve(
            &r, &c.path.q, sag ? KERN_STAYS_MOST : task->options.reserve);
    status = kern_ended(task, status);
    if (status == KERN_STANDS)
        *out = raising;
    if (status == KERN_STANDS && reserve)
        *reserve = share;
    return status;
}

KERN_API kern_status kern_raised(const kern_task *task, kern_real shrink,
                                 kern_raising *out, kern_real *reserve,
                                 const kern_proof *proof)
{
    return kern_raise_task(task, shrink, out, reserve, proof, KERN_OUT, NULL);
}

KERN_API kern_status kern_stays(const kern_task *task, int i, kern_real *chance)
{
    kern_raising raising;
    kern_real reserve, sag = KERN_R(0), odds;
    const kern_status status = chance
                                 ? kern_raise_task(task, KERN_R(0), &raising,
                                                   &reserve, NULL, i, &sag)
                                 : KERN_BAD_POINTER;
    if (status != KERN_STANDS)
        return status;
    reserve += KERN_STAYS_ADD;
    odds = KERN_STAYS_ODDS * reserve * reserve * reserve / kern_max(sag, 1);
    odds *= odds;
    *chance = raising == KERN_HANGS
                ? KERN_R(0)
                : KERN_R(0.05) + KERN_R(0.95) * odds / (1 + odds);
    return status;
}

KERN_API kern_status kern_raised_load(const kern_task *task, kern_real shrink,
                                      kern_side side,
                                      const kern_wrench *pattern,
                                      kern_real *factor,
                                      const kern_proof *proof)
{
    kern_real most = KERN_R(-1), stood = most;
    kern_call c;
    kern_raise r;
    kern_status status = kern_run(&c, task, shrink, KERN_PATH_LOAD, pattern,
                                  side, factor ? &most : NULL, proof);
    if (status == KERN_STANDS) { /* a model again that no part is open of */
        kern_query *q = &c.path.q;
        kern_raising hung;
        kern_model_open(&c.m, task, q);
        r.around = KERN_OUT;
        r.proof = proof;
        status = kern_raise_begin(&r, &c, &hung);
        if (hung == KERN_HANGS)
            status = KERN_UNDECIDED;
        q->factor = most = kern_min(most, KERN_FACTOR_MOST);
        kern_model_set(&c.m, q); /* the unit of force is what acts at the end */
        if (status == KERN_STANDS)
            stood = kern_raise_climb(&r, q, &q->factor, most);
        status = kern_ended(
            task, status == KERN_STANDS && stood < 0 ? KERN_UNDECIDED : status);
    }
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *factor = stood < KERN_FACTOR_MOST ? stood : KERN_INFINITY;
    return status;
}

/* ==== Part VI: Geometry and planning ===================================== */

/* ---- Tolerances of the geometry ----------------------------------- >>tol */
/* Shares of a length of the user's: a gap, a block's size, a coordinate. */

/* Most runs of edges with a box, where an outline has more vertices, of half as
   many edges at least; and most nested spans. More take stack, fewer time. */
#define KERN_RUNS 16
/* The default angle [rad]; and from a contact's line to the widest cone. */
#define KERN_ANGLE KERN_R(0.0174533)
/* Gap, as a share of the mean size, and angle [rad] of contacts that a little
   rocking closes: 0.03 to 0.1 and 0.1 to 0.2 predict shaking tests as well. */
#define KERN_NEAR_GAP KERN_R(0.04)
#define KERN_NEAR_ANGLE KERN_R(0.15)
/* Measured structures, in errors of place and of angle: 3.5 standard
   deviations, so that of 30 contacts which carry none is missed in 98 % of
   structures. The gap of a corner and an edge of two stones varies by 2 e^2 for
   their places, 3/8 e^2 for their vertices: 1.5 times as much, and theta^2 r^2
   for each; the angle of two edges, 0.7 sizes long, by 2 theta^2, and as much
   for their ends: twice as much. To be certain, kerns shrink or grow by it. */
#define KERN_ERRORS KERN_R(3.5)
#define KERN_ERROR_OVERLAP KERN_R(8.0)
#define KERN_ERROR_EDGE KERN_R(3.0) /* beyond its end; of angle: of cones */
/* Gaps up to which a riser is one of a drawing and no shear key: the pixel of
   an image of 900 a stone must not hold. At 2 a kerb of two gaps would go. */
#define KERN_RISER KERN_R(1.6)
/* Sine of 10 degrees: by so much ways of steps may turn; by less do the normals
   of a line contact and of a vertex that belongs to it, by more at a corner. */
#define KERN_SAME_FACE KERN_R(0.17364817766693036)
/* Largest share of a step: of the smaller free block's size, or it stays with
   any gap; and of a way whose direction it hardly changes. */
#define KERN_STEP_MOST KERN_R(0.1)
/* Strides of the search for overlap to a gap, which may be so much deeper
   unseen; and of a stride to that by which it grows. Fewer miss more, more take
   time. And most triangles of a size that are tried for an inner point. */
#define KERN_STRIDES 32

/* ---- coming to rest ---- */

/* Most motions of a stone; most touches that are kept. */
#define KERN_REST_MOTIONS 48
#define KERN_REST_TOUCHES 16
/* Distance within which outlines touch, as a share of the stone's size. */
#define KERN_REST_NEAR KERN_PICK(1e-7, 1e-4)
/* Share of that by which a vertex may lie beyond the end of an edge. */
#define KERN_REST_END KERN_R(0.01)
/* And the part of an edge, in these, that belongs to its end. */
#define KERN_REST_FOOT KERN_R(10)
/* Slope against its normal up to which a motion runs along an edge. */
#define KERN_REST_ALONG KERN_PICK(1e-6, 1e-3)
/* Upward part of the normal from which a touch supports. */
#define KERN_REST_UP KERN_R(0.05)
/* Largest turn of one motion: what it may meet is looked for in a small box. */
#define KERN_REST_COSINE KERN_R(0.8)
#define KERN_REST_SINE KERN_R(0.6)
#define KERN_REST_STEPS 3
/* Chance from which a stone counts as staying; margins that count as equal. */
#define KERN_PLACE_STAYS KERN_R(0.9)
#define KERN_PLACE_SAME KERN_R(1e-5)
/* Largest turn that may be asked for [rad]; turn whose series is exact. */
#define KERN_REST_TURN KERN_R(64)
#define KERN_REST_SMALL KERN_R(0.06)

/* ---- Polygons ------------------------------------------------- >>polygon */
/* Vertices are counted as written, which may be clockwise: the area is below 0
   then. Those that hardly turn are no corners. */

/* The vertex behind i, or the one before. */
KERN_SHARED static int kern_polygon_next(const kern_block *block, int i,
                                         int back)
{
    if (back)
        return (i > 0 ? i : block->vertices) - 1;
    return ++i < block->vertices ? i : 0;
}

/* How vertex i turns: 1 to the inner side (convex), -1 to the outer side
   (reflex), 0 hardly at all, -2 back: a spike, or a vertex that is repeated. */
static inline int kern_polygon_turn(const kern_block *block, int i)
{
    const kern_vec *v = block->vertex;
    const kern_vec in = kern_vec_sub(v[i], v[kern_polygon_next(block, i, 1)]);
    const kern_vec out = kern_vec_sub(v[kern_polygon_next(block, i, 0)], v[i]);
    const kern_real turn = kern_vec_cross(in, out);
    const kern_real least = KERN_SLIGHT * kern_vec_dot(in, out);
    if (kern_abs(turn) < least)
        return 0;
    if (kern_abs(turn) <= -least)
        return -2;
    return (turn > 0) == (block->area >= 0) ? 1 : -1;
}

/* Are they no farther apart than the gap? Below 0: do they overlap by more? */
static int kern_box_near(const kern_box *a, const kern_box *b, kern_real gap)
{
    return b->low.y - gap <= a->high.y && a->low.y - gap <= b->high.y
        && b->low.x - gap <= a->high.x && a->low.x - gap <= b->high.x;
}

/* The largest coordinate, without its sign. */
static kern_real kern_box_largest(const kern_box *box)
{
    return kern_max(kern_vec_largest(box->low), kern_vec_largest(box->high));
}

/* ---- outlines ---- */

typedef struct kern_span {
    int start, end; /* corners; equal: the whole outline         */
    int steps;      /* 1: its chord stands for edges; -1: unknown */
} kern_span;

/* A block's outline in runs of `each` vertices with a box around the edges that
   start there, from corner to corner. A short outline is one run. */
typedef struct kern_outline {
    const kern_block *block;
    int straight, reflex;      /* are there such vertices, or spikes?   */
    int each;                  /* vertices of a run                     */
    kern_real step;            /* a corner is so far from its chord [m] */
    int spans;                 /* so many; 0: not known yet             */
    kern_span span[KERN_RUNS]; /* each lies in the one before        */
    kern_box box[KERN_RUNS];
} kern_outline;

/* The next corner; a closed outline has some. */
static int kern_outline_corner(const kern_outline *o, int i)
{
    do
        i = kern_polygon_next(o->block, i, 0);
    while (o->straight && kern_polygon_turn(o->block, i) == 0);
    return i;
}

static void kern_outline_set(kern_outline *o, const kern_block *block)
{
    const int n = block->vertices;
    int i;
    o->block = block;
    o->straight = o->reflex = 0;
    for (i = 0; i < n; i++) {
        const int turn = kern_polygon_turn(block, i);
        o->straight |= turn == 0;
        o->reflex |= turn < 0;
    }
    o->each = n > KERN_RUNS ? n / KERN_RUNS + KERN_RUNS / 2 : n;
    o->box[0] = block->box;
    for (i = 0; n > KERN_RUNS && i < n; i++) {
        kern_box *box = &o->box[i / o->each];
        const int end = kern_polygon_next(block, i, 0);
        if (i % o->each == 0)
            box->low = box->high = block->vertex[i];
        kern_box_add(box, block->vertex[end]);
        if (end % o->each == 0)
            kern_box_add(box, block->vertex[kern_outline_corner(o, i)]);
    }
}

/* ---- edges ---- */

/* The way from one corner to another, counter-clockwise: an edge or a chord. */
typedef struct kern_edge {
    int at;           /* its first corner as written           */
    int start, end;   /* its corners, counter-clockwise        */
    kern_vec p, q, d; /* their places; unit direction          */
    kern_real length;
    kern_box box; /* of an edge                            */
} kern_edge;

static inline void kern_edge_set(kern_edge *e, const kern_block *block, int at,
                                 int to)
{
    e->at = at;
    e->start = block->area < 0 ? to : at;
    e->end = block->area < 0 ? at : to;
    e->p = block->vertex[e->start];
    e->q = block->vertex[e->end];
    e->d = kern_vec_sub(e->q, e->p);
    e->length = kern_vec_length(e->d);
    e->d = kern_vec_scale(e->d, 1 / e->length);
}

/* Where the foot of p on the line of e is, from its start on. */
static kern_real kern_edge_along(const kern_edge *e, kern_vec p)
{
    return kern_vec_dot(kern_vec_sub(p, e->p), e->d);
}

static kern_vec kern_edge_foot(const kern_edge *e, kern_vec p)
{
    return kern_vec_step(e->p, kern_edge_along(e, p), e->d);
}

/* Goes to the next edge near the box, behind vertex e->at or -1; 0: none. */
static int kern_edge_next(kern_edge *e, const kern_outline *o,
                          const kern_box *box, kern_real gap)
{
    const kern_block *block = o->block;
    int i;
    for (i = e->at + 1; i < block->vertices; i++)
        if (o->each < block->vertices && i % o->each == 0
            && !kern_box_near(&o->box[i / o->each], box, gap)) {
            i += o->each - 1;
        } else if (!o->straight || kern_polygon_turn(block, i) != 0) {
            const int corner = kern_outline_corner(o, i);
            kern_box own = {block->vertex[i], block->vertex[i]};
            kern_box_add(&own, block->vertex[corner]);
            if (kern_box_near(&own, box, gap)) {
                kern_edge_set(e, block, i, corner);
                e->box = own;
                return 1;
            }
        }
    return 0;
}

/* ---- places ---- */

/* Squared distance of the origin from the edge u, v, which may be a point. */
static kern_real kern_edge_square(kern_vec u, kern_vec v)
{
    const kern_vec d = kern_vec_sub(v, u);
    const kern_real whole = kern_vec_dot(d, d);
    const kern_real along = kern_min(kern_max(-kern_vec_dot(u, d), KERN_R(0)),
                                     whole);
    const kern_real share = whole > 0 ? along / whole : KERN_R(0);
    const kern_vec r = kern_vec_step(u, share, d);
    return kern_vec_dot(r, r);
}

/* Distance of p from the boundary, below 0 where it is outside, and the vertex
   at which the nearest edge starts. What *nearest is before is a guess, and
   saves time. A run that is farther away than the nearest edge so far crosses
   the level of p once or not, as its ends say, and all of it to one side. */
static kern_real kern_polygon_depth(const kern_outline *o, kern_vec p,
                                    int *nearest)
{
    const kern_block *block = o->block;
    const kern_vec *vertex = block->vertex;
    const int n = block->vertices;
    kern_vec u = kern_vec_sub(vertex[*nearest], p);
    kern_real least = kern_edge_square(
        u, kern_vec_sub(vertex[kern_polygon_next(block, *nearest, 0)], p));
    int i, start, end, inside = 0;
    u = kern_vec_sub(vertex[0], p);
    for (start = 0; start < n; start = end) {
        const kern_box *box = &o->box[start / o->each];
        const kern_real x = kern_min(kern_max(p.x, box->low.x), box->high.x);
        const kern_real y = kern_min(kern_max(p.y, box->low.y), box->high.y);
        const kern_vec way = kern_vec_sub(p, kern_vec_make(x, y));
        const int skip = /* beyond all rounding */
            KERN_R(0.999) * kern_vec_dot(way, way) > least;
        end = n - start > o->each ? start + o->each : n;
        for (i = skip ? end - 1 : start; i < end; i++) {
            const kern_vec v = kern_vec_sub(
                vertex[kern_polygon_next(block, i, 0)], p);
            const kern_real square = skip ? least : kern_edge_square(u, v);
            if (square < least) {
                least = square;
                *nearest = i;
            }
            if ((u.y > 0) != (v.y > 0)
                && (skip ? box->low.x > p.x
                         : (kern_vec_cross(u, v) > 0) == (v.y > u.y)))
                inside = !inside;
            u = v;
        }
    }
    least = KERN_SQRT(least);
    return inside ? least : -least;
}

/* Does f lie to one side of the line of e? A unit direction is rounded. */
static int kern_one_side(const kern_edge *e, const kern_edge *f)
{
    const kern_vec d = kern_vec_sub(e->q, e->p);
    const kern_real from = kern_vec_cross(d, kern_vec_sub(f->p, e->p));
    const kern_real to = kern_vec_cross(d, kern_vec_sub(f->q, e->p));
    return (from > 0 && to > 0) || (from < 0 && to < 0);
}

/* ---- what a polygon must be ---- */

/* The first edge that touches another but its neighbours, or turns back; -1:
   none, as in a convex polygon: it turns one way only and has one lowest place.
   Edges whose boxes meet touch, unless one lies on one side of the other. */
static int kern_polygon_crossing(const kern_block *block)
{
    const kern_vec *v = block->vertex;
    kern_outline o;
    kern_edge e, f;
    int i, lowest = 0;
    for (i = 0; i < block->vertices; i++)
        lowest += v[kern_polygon_next(block, i, 0)].y > v[i].y
               && v[kern_polygon_next(block, i, 1)].y >= v[i].y;
    kern_outline_set(&o, block);
    if (!o.reflex && lowest < 2)
        return -1;
    o.straight = 0; /* from vertex to vertex, which costs less */
    e.at = -1;
    while (kern_edge_next(&e, &o, &block->box, 0)) {
        int touch = kern_polygon_turn(block, e.at) == -2;
        f = e;
        while (!touch && kern_edge_next(&f, &o, &e.box, 0))
            touch = f.start != e.end && f.end != e.start
                 && !kern_one_side(&e, &f) && !kern_one_side(&f, &e);
        if (touch)
            return e.at;
    }
    return -1;
}

/* Fills in area, centre and box, by the triangles between vertex 0 and the
   edges, against round-off far from the origin. Returns their unsigned sum. */
static inline kern_real kern_polygon_area(kern_block *block)
{
    const kern_vec o = block->vertex[0];
    kern_vec u = kern_vec_make(KERN_R(0), KERN_R(0));
    kern_vec moment = u; /* about vertex 0 */
    kern_real spread = KERN_R(0);
    int i;
    block->area = KERN_R(0);
    block->box.low = block->box.high = o;
    for (i = 1; i < block->vertices; i++) {
        const kern_vec w = kern_vec_sub(block->vertex[i], o);
        const kern_real part = kern_vec_cross(u, w) / 2;
        kern_box_add(&block->box, block->vertex[i]);
        block->area += part;
        spread += kern_abs(part);
        moment = kern_vec_step(moment, part / 3, kern_vec_add(u, w));
        u = w;
    }
    block->centre = kern_vec_step(o, 1 / block->area, moment);
    return spread;
}

/* Fills in area, centre and box, or says what is wrong with the polygon. */
static kern_status kern_polygon_measure(kern_block *block, kern_fault *fault)
{
    kern_real spread, least;
    for (fault->index = 0; fault->index < block->vertices; fault->index++)
        if (!kern_vec_is_moderate(block->vertex[fault->index]))
            return KERN_BAD_NUMBER;
    spread = kern_polygon_area(block);
    least = 2 * KERN_ROUNDING * kern_box_largest(&block->box)
          * kern_vec_largest(kern_vec_sub(block->box.high, block->box.low));
    least = kern_max(least, 1 / (KERN_FAR * KERN_FAR));
    /* or all vertices are on one line */
    fault->index = spread > least ? kern_polygon_crossing(block) : -1;
    return fault->index >= 0             ? KERN_CROSSING
         : kern_abs(block->area) > least ? KERN_OK
                                         : KERN_NO_AREA;
}

KERN_SHARED static kern_status kern_vertices_check(const kern_vec *v, int n)
{
    return n < 0 || n > KERN_POINTS_MOST ? KERN_BAD_COUNT
         : n < 3                         ? KERN_FEW_VERTICES
         : v                             ? KERN_OK
                                         : KERN_BAD_POINTER;
}

/* Leaves a block that every call refuses where the polygon is none. */
KERN_API kern_status kern_ground_init(kern_block *block, const kern_vec *vertex,
                                      int vertices, kern_fault *fault)
{
    const kern_block made = {vertex,           vertices, 1,      0,
                             {{0, 0}, {0, 0}}, 0,        {0, 0}, {0, 0, 0}};
    kern_fault ignored;
    kern_status status = kern_vertices_check(vertex, vertices);
    fault = fault ? fault : &ignored;
    kern_fault_clear(fault);
    if (!block)
        return status == KERN_OK ? KERN_BAD_POINTER : status;
    *block = made;
    if (status == KERN_OK)
        status = kern_polygon_measure(block, fault);
    if (status != KERN_OK)
        block->vertices = -1;
    return status;
}

KERN_API kern_status kern_block_init(kern_block *block, const kern_vec *vertex,
                                     int vertices, kern_real density,
                                     kern_fault *fault)
{
    kern_status status = kern_ground_init(block, vertex, vertices, fault);
    if (status != KERN_OK)
        return status;
    block->mass = density * kern_abs(block->area);
    if (!(block->mass >= 1 / KERN_FAR) || block->mass > KERN_FAR) {
        block->vertices = -1;
        return KERN_BAD_MASS;
    }
    block->fixed = 0;
    return KERN_OK;
}

KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec at,
                              kern_real torque)
{
    const kern_vec arm = kern_vec_sub(at, block->centre);
    block->load.fx += force.x;
    block->load.fy += force.y;
    block->load.torque += kern_vec_cross(arm, force) + torque;
}

KERN_API kern_real kern_mean_size(const kern_block *block, int blocks)
{
    kern_real sum = KERN_R(0);
    int i, sized = 0;
    for (i = 0; block && i < blocks; i++) {
        const kern_real size = block[i].fixed ? 0 : kern_block_size(&block[i]);
        sum += size;
        sized += size > 0; /* blocks without a polygon have no size */
    }
    return sized ? sum / KERN_R(sized) : KERN_R(0);
}

/* ---- Contacts ------------------------------------------------- >>contact */
/*      line               point              corner in a corner
        ___________             \  b  /         | b
       |     b     |             \   /          |____
    ___o___________o___      _____\ /_____        a  |  two normals
       |     a         |       a   o              ___|  at one place

   Of each two blocks whose boxes are within the gap (kern_search_pair()), as
   >>rules says:
   1. Overlap: the search fails (kern_overlap_depth()).
   2. Edges make lines (kern_pair_line()) and points (kern_pair_point()).
   3. Steps: contacts go to the chords of an outline (kern_outline_chord()).
   4. Faces: what lies on one line is merged (kern_pair_face()).
   5. Travels: kern_point_travels().
   At the end each line becomes two contact points. */

/* ---- overlap ---- */
/* The search goes along the edges of one block. The depth in the other changes
   by no more than the way, so each depth gives a step that is safe. */

/* Is no vertex farther than that to a side of an edge, 1 its left, -1 right? */
static int kern_overlap_beside(const kern_edge *e, const kern_block *b,
                               kern_real side, kern_real most)
{
    const kern_vec d = kern_vec_scale(e->d, side);
    int k;
    for (k = 0; k < b->vertices; k++)
        if (kern_vec_cross(d, kern_vec_sub(b->vertex[k], e->p)) > most)
            return 0;
    return 1;
}

/* Raises *deep to the depth in b of the boundary of a, but for a stride, or to
   one beyond `enough`. Strides grow: a gap of few roundings takes too many. */
static void kern_overlap_boundary(const kern_outline *a, const kern_outline *b,
                                  kern_real enough, kern_real *deep)
{
    kern_edge e, f;
    int nearest = 0;
    e.at = -1;
    while (kern_edge_next(&e, a, &b->block->box, -*deep)) {
        kern_real s, step, low, stride = *deep / KERN_STRIDES;
        for (s = 0; s < e.length; s += step) {
            const kern_vec at = kern_vec_step(e.p, s, e.d);
            const kern_real depth = kern_polygon_depth(b, at, &nearest);
            *deep = kern_max(*deep, depth);
            if (*deep > enough)
                return;
            /* as far as the edge stays no deeper than that at the nearest */
            kern_edge_set(&f, b->block, nearest,
                          kern_polygon_next(b->block, nearest, 0));
            low = KERN_R(0);
            step = e.length - s;
            kern_clip(&low, &step, kern_edge_along(&f, at),
                      kern_vec_dot(e.d, f.d), KERN_R(0), f.length);
            kern_clip(&low, &step, kern_vec_cross(kern_vec_sub(at, f.p), f.d),
                      kern_vec_cross(e.d, f.d), -*deep, *deep);
            step = kern_max(low > 0 ? KERN_R(0) : step, *deep - depth + stride);
            stride += stride / KERN_STRIDES;
        }
    }
}

/* Raises *deep to the depth in b of inner points of a: middles of triangles of
   vertices, which lie inside where the outline turns left, those far apart
   first. Where no boundary is deep, one speaks for all that is around it. */
static void kern_overlap_within(const kern_outline *a, const kern_outline *b,
                                kern_real *deep)
{
    const kern_vec *vertex = a->block->vertex;
    const int n = a->block->vertices;
    int step, i, near_a = 0, near_b = 0;
    for (step = n / 3; step > 0; step /= 2)
        for (i = 0; i < n; i += 1 + n / KERN_STRIDES) {
            const kern_vec sum = kern_vec_add(
                kern_vec_add(vertex[i], vertex[(i + step) % n]),
                vertex[(i + 2 * step) % n]);
            const kern_vec at = kern_vec_scale(sum, KERN_R(1) / 3);
            const kern_real own = kern_polygon_depth(a, at, &near_a);
            if (own > *deep)
                *deep = kern_max(
                    *deep, kern_min(own, kern_polygon_depth(b, at, &near_b)));
            if (own > 2 * *deep)
                return;
        }
}

/* Depth of the overlap of a and b, but for a stride, or one beyond `enough`; 0:
   none deeper than the gap. As a rule the line of an edge parts a convex pair,
   but for half a gap. Two blocks at one place have no deep boundary. */
KERN_SHARED static kern_real kern_overlap_depth(const kern_outline *a,
                                                const kern_outline *b,
                                                kern_real gap, kern_real enough)
{
    const kern_outline *const side[3] = {a, b, a};
    kern_real deep = gap;
    kern_edge e;
    int i, k, apart = 0;
    if (!kern_box_near(&a->block->box, &b->block->box, -gap))
        return KERN_R(0);
    for (i = 1; i >= 0; i--) {
        const kern_block *own = side[i]->block, *other = side[i + 1]->block;
        for (k = 0; k < own->vertices && !apart; k++) {
            kern_edge_set(&e, own, k, kern_polygon_next(own, k, 0));
            apart = kern_overlap_beside(&e, other, 1, gap / 2)
                 && (side[i]->reflex + side[i]->straight == 0 /* convex */
                     || kern_overlap_beside(&e, own, -1, gap / 2));
        }
    }
    for (i = 0; i < 2 && !apart && !(deep > enough); i++)
        kern_overlap_boundary(side[i], side[i + 1], enough, &deep);
    for (i = 0; i < 2 && !apart && !(deep > gap); i++)
        kern_overlap_within(side[i], side[i + 1], &deep);
    return deep > gap ? deep : KERN_R(0);
}

/* ---- simplified outlines ---- */
/* The simplification of an outline with steps (Douglas & Peucker 1973) is not
   stored: the span of an edge is found from the whole outline, which is split
   until no corner is farther than a step from the chord. The nested spans on
   the way serve the next edge, which is a neighbour as a rule. */

/* Does the edge that starts at vertex i of n lie in the span? */
KERN_SHARED static int kern_span_holds(const kern_span *span, int i, int n)
{
    return (i - span->start + n) % n <= (span->end - span->start - 1 + n) % n;
}

/* Length of the edge from corner i to k if it turns to both sides: a riser. */
static kern_real kern_riser_length(const kern_block *block, int i, int k)
{
    const int turns = kern_polygon_turn(block, i) * kern_polygon_turn(block, k);
    return turns < 0
             ? kern_vec_length(kern_vec_sub(block->vertex[k], block->vertex[i]))
             : KERN_INFINITY;
}

/* Has the span a riser: of any length inside, of at most a step at its ends? */
static int kern_span_has_steps(const kern_outline *o, const kern_span *span)
{
    int i, k = span->start;
    do {
        i = k;
        k = kern_outline_corner(o, i);
        if (kern_riser_length(o->block, i, k)
            < (i == span->start || k == span->end ? o->step : KERN_INFINITY))
            return 1;
    } while (k != span->end);
    return 0;
}

/* The corner farthest from pq, in an open span by over a step; else the end. */
static int kern_span_split(const kern_outline *o, int start, int end,
                           kern_vec p, kern_vec q)
{
    const kern_vec d = kern_vec_sub(q, p);
    kern_real most = start == end ? KERN_R(0) : o->step * o->step;
    int i = start, at = end;
    do {
        const kern_vec r = kern_vec_sub(p, o->block->vertex[i]);
        const kern_real square = kern_edge_square(r, kern_vec_add(r, d));
        if (square > most) {
            most = square;
            at = i;
        }
    } while ((i = kern_outline_corner(o, i)) != end);
    return at;
}

/* The whole outline is a span from the corner farthest from the centre. Stairs
   of low risers, the shorter edges at reflex corners, take what they deviate
   from their chord: the root of 2 times a riser where treads are as long. */
static void kern_outline_whole(kern_outline *o)
{
    const kern_block *block = o->block;
    const kern_vec c = block->centre;
    kern_span *whole = o->span;
    kern_real riser = KERN_R(0), before = KERN_INFINITY;
    int i = kern_outline_corner(o, block->vertices - 1);
    i = kern_span_split(o, i, i, c, c);
    whole->start = whole->end = i;
    whole->steps = -1;
    o->spans = 1;
    do {
        const int k = kern_outline_corner(o, i);
        const kern_real after = kern_riser_length(block, i, k);
        const kern_real high = kern_min(before, after);
        if (high <= KERN_RISER * o->step && kern_polygon_turn(block, i) < 0)
            riser = kern_max(riser, high);
        before = after;
        i = k;
    } while (i != whole->start);
    o->step = kern_max(o->step, KERN_SQRT(KERN_R(2)) * riser);
}

/* 1: the chord that stands for edge i; 0: itself, as in a convex outline. */
static int kern_outline_chord(kern_outline *o, int i, kern_edge *chord)
{
    const kern_vec *v = o->block->vertex;
    const int n = o->block->vertices;
    kern_span *span, half;
    if (!o->reflex)
        return 0;
    if (!o->spans)
        kern_outline_whole(o);
    while (!kern_span_holds(&o->span[o->spans - 1], i, n))
        o->spans--;
    while ((span = &o->span[o->spans - 1])->steps < 0) {
        half = *span;
        span->steps = kern_span_has_steps(o, span);
        if (span->steps)
            half.end = kern_span_split(o, half.start, half.end, v[half.start],
                                       v[half.end]);
        if (half.end == span->end)
            break;
        if (!kern_span_holds(&half, i, n)) {
            half.start = half.end;
            half.end = span->end;
        }
        span->steps = -1;
        if (o->spans == KERN_RUNS) /* all but the whole are found anew */
            o->spans = 1;
        o->span[o->spans++] = half;
    }
    if (span->steps)
        kern_edge_set(chord, o->block, span->start, span->end);
    return span->steps;
}

/* ---- the pair ---- */

/* Two blocks, and the contacts of all pairs so far, in the caller's array. Here
   a line is one: p is its middle, travel half its length; 0: it is a point. */
typedef struct kern_pair {
    int a, b;        /* indices of the blocks, a before b           */
    kern_real gap;   /* widest [m], at the blocks' centres          */
    kern_real swing; /* what its errors of angle add, per distance  */
    kern_real deep;  /* deepest overlap [m]                         */
    kern_real reach; /* no gap or overlap is wider [m]              */
    kern_real least; /* a line is longer [m]                        */
    kern_real foot;  /* a foot on an edge is so far inside [m]      */
    kern_real sine;  /* of the angle of the options                 */
    const kern_options *options;
    kern_contact *out;
    int room, count;    /* count may exceed the room: no more is stored */
    int first;          /* of the contacts of this pair                */
    kern_outline of[2]; /* a and b                                     */
} kern_pair;

/* One end of a line: side is -1 or 1. */
static kern_vec kern_line_end(const kern_contact *line, kern_real side)
{
    return kern_vec_step(line->p, side * line->travel, kern_vec_turn(line->n));
}

/* Adds a contact behind those as long or longer; without room it is counted. */
static void kern_pair_put(kern_pair *pair, kern_vec p, kern_vec n,
                          kern_real half)
{
    const kern_contact made = {pair->a, pair->b,           half > 0, p,
                               n,       pair->options->mu, half};
    kern_contact *at = pair->out;
    int i = pair->count++;
    if (i >= pair->room)
        return;
    for (; i > pair->first && at[i - 1].travel < half; i--)
        at[i] = at[i - 1];
    at[i] = made;
}

/* Do the ways run against each other, within the angle? */
static int kern_pair_opposed(const kern_pair *pair, const kern_edge *e,
                             const kern_edge *f)
{
    return kern_vec_dot(e->d, f->d) < 0
        && kern_abs(kern_vec_cross(e->d, f->d)) <= pair->sine;
}

/* ---- steps ---- */
/* Contacts are found at the edges as they are, so that no support is lost by
   the simplification. A contact at a step then goes to the chord, unless its
   normal is far from that of the chord: it is that of the step's own edge. */

/* A point at *p on chord e is the nearer end of chord f of the block. 0: that
   end does not stand there, since one of the ways from it leads inside by more
   than a chord of steps may be off, as between stones whose corners meet. */
static int kern_chord_stands(const kern_edge *e, const kern_edge *f,
                             const kern_outline *o, kern_vec *p)
{
    const kern_block *block = o->block;
    const int back = 2 * kern_edge_along(f, *p) <= f->length;
    const int corner = back ? f->start : f->end;
    const kern_vec chord = kern_vec_scale(f->d, back ? KERN_R(1) : KERN_R(-1));
    kern_vec way;
    int i = corner;
    *p = back ? f->p : f->q;
    do {
        i = kern_polygon_next(block, i, back == (block->area > 0));
        way = kern_vec_sub(block->vertex[i], *p);
    } while (i != corner && KERN_STEP_MOST * kern_vec_length(way) < o->step);
    return kern_vec_cross(chord, e->d) >= -KERN_SAME_FACE
        && kern_vec_cross(way, e->d) >= -KERN_SAME_FACE * kern_vec_length(way);
}

/* The chord of an edge, in *chord, or the edge. At a corner where it starts it
   may be that of the edge before, where that is low: the end of a step. */
static const kern_edge *kern_pair_chord(kern_outline *o, const kern_edge *edge,
                                        int corner, kern_edge *chord)
{
    const kern_block *block = o->block;
    const int out = block->area > 0;
    const int last = kern_polygon_next(block, edge->start, out);
    return kern_outline_chord(o, edge->at, chord)
                || (corner
                    && kern_vec_length(
                           kern_vec_sub(block->vertex[last], edge->p))
                           <= o->step
                    && kern_outline_chord(o, out ? last : edge->start, chord))
             ? chord
             : edge;
}

/* Adds a contact of two edges, on their chords: midway between two that run
   against each other, else on the one inside of whose ends it lies farther. A
   point's corner is of a (0) or b (1): its own chord's end has no normal. */
static void kern_pair_add(kern_pair *pair, const kern_edge *edge, kern_vec p,
                          kern_vec n, kern_real half, int corner)
{
    kern_edge chord[2];
    const kern_edge *e[2] = {edge, edge + 1};
    kern_real inside[2];
    kern_vec t, q;
    int on, reflex = pair->of[0].reflex | pair->of[1].reflex;
    for (on = 0; on < 2 && reflex; on++) {
        e[on] = kern_pair_chord(&pair->of[on], edge + on, corner == on,
                                chord + on);
        inside[on] = kern_edge_along(e[on], p);
        inside[on] = kern_min(inside[on], e[on]->length - inside[on]);
        if (corner == on && !(inside[on] > 0))
            inside[on] = -KERN_INFINITY;
    }
    if (e[0] == edge && e[1] == edge + 1) {
        kern_pair_put(pair, p, n, half);
        return;
    }
    on = inside[0] < inside[1];
    if (kern_pair_opposed(pair, e[0], e[1])) {
        t = kern_vec_unit(kern_vec_sub(e[0]->d, e[1]->d));
        q = kern_vec_mid(kern_edge_foot(e[0], p), kern_edge_foot(e[1], p));
    } else if (2 * half > pair->gap
               || kern_chord_stands(e[on], e[!on], &pair->of[!on], &p)) {
        t = on ? kern_vec_scale(e[1]->d, -1) : e[0]->d;
        q = kern_edge_foot(e[on], p);
    } else {
        return;
    }
    t = kern_vec_scale(kern_vec_turn(t), -1); /* the outer normal */
    if (2 * kern_vec_dot(t, n) > 1)           /* less than 60 degrees off */
        kern_pair_put(pair, q, t, half * kern_vec_dot(t, n));
}

/* ---- lines and points ---- */

/* The widest gap at p. Errors of angle count by the distance from centres. */
static kern_real kern_pair_gap(const kern_pair *pair, kern_vec p)
{
    const kern_vec u = kern_vec_sub(p, pair->of[0].block->centre);
    const kern_vec v = kern_vec_sub(p, pair->of[1].block->centre);
    return !(pair->swing > 0)
             ? pair->gap
             : KERN_SQRT(pair->gap * pair->gap
                         + pair->swing * pair->swing
                               * (kern_vec_dot(u, u) + kern_vec_dot(v, v)));
}

/* Edge e of a and edge f of b run against each other. In the frame of their
   mean tangent t and normal n both are heights over s, e rises as f falls, and
   the gap opens at twice that slope: a contact where it is small, midway. */
static void kern_pair_line(kern_pair *pair, const kern_edge *edge)
{
    const kern_edge *e = edge, *f = edge + 1;
    const kern_vec r = kern_vec_sub(f->q, e->p); /* against round-off */
    kern_real at, cosine, slope, low, high, gap, wide;
    kern_vec t, n, p;
    if (!kern_pair_opposed(pair, e, f))
        return;
    t = kern_vec_unit(kern_vec_sub(e->d, f->d));
    n = kern_vec_scale(kern_vec_turn(t), -1); /* outward */
    cosine = kern_vec_dot(e->d, t);           /* and of f the opposite */
    slope = kern_vec_dot(e->d, n) / cosine;
    at = kern_vec_dot(r, t);
    low = kern_max(KERN_R(0), at);
    high = kern_min(e->length * cosine, at + f->length * cosine);
    gap = kern_vec_dot(r, n) + slope * at; /* at s = 0 */
    wide = kern_pair_gap(pair, kern_vec_step(e->p, (low + high) / 2, t));
    kern_clip(&low, &high, gap, -2 * slope, -kern_max(wide, pair->deep), wide);
    if (!(high - low > pair->least))
        return;
    p = kern_vec_step(kern_vec_step(e->p, (low + high) / 2, t), gap / 2, n);
    kern_pair_add(pair, edge, p, n, (high - low) / 2, KERN_OUT);
}

/* Is the foot of p inside edge e, or does e end at p in a reflex corner? */
static int kern_pair_bears(const kern_pair *pair, const kern_edge *e, int on,
                           kern_vec p, kern_real gap)
{
    const kern_real along = kern_edge_along(e, p);
    const kern_real inside = pair->foot
                           - KERN_ERROR_EDGE * pair->options->pose_error;
    int end, bears = along > inside && along < e->length - inside;
    for (end = 0; end < 2 && !bears; end++) {
        const kern_vec r = kern_vec_sub(p, end ? e->q : e->p);
        bears = kern_vec_dot(r, r) <= gap * gap
             && kern_polygon_turn(pair->of[on].block, end ? e->end : e->start)
                    < 0;
    }
    return bears;
}

/* The corner where f starts, which leads outward, stands on e, of a (on 0) or b
   (1): convex, within the gap, borne by e, and its other edge leads outward. */
static void kern_pair_point(kern_pair *pair, const kern_edge *edge, int on)
{
    const kern_edge *e = &edge[on], *f = &edge[!on];
    const kern_real wide = kern_pair_gap(pair, f->p);
    const kern_real high = kern_vec_cross(kern_vec_sub(f->p, e->p), e->d);
    const kern_block *own = pair->of[!on].block;
    kern_vec back, p = f->p;
    if (high > wide || high < -kern_max(wide, pair->deep))
        return;
    back = kern_vec_unit(kern_vec_sub(
        own->vertex[kern_polygon_next(own, f->start, own->area > 0)], f->p));
    if (kern_vec_cross(back, f->d) > 0
        || kern_vec_cross(back, e->d) < -pair->sine
        || !kern_pair_bears(pair, e, on, p, wide))
        return;
    if (pair->deep > pair->gap) /* midway, as a line */
        p = kern_vec_step(p, high / 2, kern_vec_turn(e->d));
    kern_pair_add(pair, edge, p,
                  kern_vec_scale(kern_vec_turn(e->d), on ? 1 : -1), 0, !on);
}

/* Looks for lines and points at each two edges that are near each other. */
static void kern_pair_edges(kern_pair *pair)
{
    const kern_outline *a = &pair->of[0], *b = &pair->of[1];
    kern_edge edge[2];
    edge[0].at = -1;
    while (kern_edge_next(&edge[0], a, &b->block->box, pair->reach)) {
        edge[1].at = -1;
        while (kern_edge_next(&edge[1], b, &edge[0].box, pair->reach)) {
            const kern_real turn = kern_vec_cross(edge[0].d, edge[1].d);
            kern_pair_line(pair, edge);
            if (turn >= -pair->sine)
                kern_pair_point(pair, edge, 1);
            if (turn <= pair->sine)
                kern_pair_point(pair, edge, 0);
        }
    }
}

/* ---- faces ---- */
/* The longest contact leads a face; all others with its normal and on its line
   join it, lines first. A point about as inclined and within the gap of a line
   with what has joined it is left out. The rest's first leads the next face. */

/* Makes a face of contact i and all that join it. */
KERN_SHARED static void kern_pair_face(kern_pair *pair, int i)
{
    kern_contact *at = pair->out;
    const kern_contact *const lead = &at[i];
    kern_vec low = lead->p, high = lead->p; /* outermost points            */
    kern_real least = KERN_R(0), most = KERN_R(0);      /* where they are     */
    kern_vec sum = kern_vec_make(KERN_R(0), KERN_R(0)); /* of normals    */
    kern_real half;
    int k, rest = i + 1;
    for (k = i; k < pair->count; k++) { /* itself first */
        const kern_contact *c = &at[k];
        const kern_vec r = kern_vec_sub(c->p, lead->p);
        const kern_real cosine = kern_vec_dot(lead->n, c->n);
        const kern_real sine = kern_abs(kern_vec_cross(lead->n, c->n));
        const kern_real along = kern_vec_cross(lead->n, r);
        const kern_real off = kern_abs(kern_vec_dot(lead->n, r));
        if (lead->line && !c->line && cosine > 0 && sine < KERN_SAME_FACE
            && kern_max(off, kern_max(least - along, along - most))
                   <= pair->gap)
            continue;
        if (!(cosine > 0) || sine > pair->sine
            || off + c->travel * sine > pair->gap) {
            at[rest++] = *c;
            continue;
        }
        half = c->travel * cosine;
        if (along - half < least) {
            least = along - half;
            low = kern_line_end(c, -1);
        }
        if (along + half > most) {
            most = along + half;
            high = kern_line_end(c, 1);
        }
        sum = kern_vec_step(sum, c->line ? 2 * c->travel : pair->gap, c->n);
    }
    pair->count = rest;
    at[i].p = kern_vec_mid(low, high);
    at[i].n = kern_vec_unit(sum);
    half = kern_vec_cross(at[i].n, kern_vec_sub(high, low)) / 2;
    at[i].line = 2 * half > pair->foot;
    at[i].travel = at[i].line ? half : KERN_R(0);
}

/* ---- travels ---- */

/* The block that a contact carries where `down` is the direction of gravity. */
KERN_SHARED static int kern_carried(const kern_contact *c, kern_vec down)
{
    const kern_real push = kern_vec_dot(c->n, down);
    return push < 0 ? c->b : push > 0 ? c->a : KERN_OUT;
}

/* Are c and d of one interface, or with `down` of what carries one block? */
static int kern_together(const kern_contact *c, const kern_contact *d,
                         const kern_vec *down)
{
    return down ? kern_carried(c, *down) == kern_carried(d, *down)
                : kern_same_interface(c, d);
}

/* The middle of the two points farthest apart of those that belong together
   with *of, one of them; of several such two the first by index. */
static kern_vec kern_middle(const kern_contact *contact, int contacts,
                            const kern_contact *of, const kern_vec *down)
{
    kern_vec middle = of->p;
    kern_real widest = KERN_R(0);
    int j, k;
    for (j = 0; j < contacts; j++)
        for (k = j + 1; k < contacts && kern_together(of, &contact[j], down);
             k++) {
            const kern_vec d = kern_vec_sub(contact[k].p, contact[j].p);
            const kern_real square = kern_vec_dot(d, d);
            if (square > widest && kern_together(of, &contact[k], down)) {
                widest = square;
                middle = kern_vec_mid(contact[j].p, contact[k].p);
            }
        }
    return middle;
}

/* Travels of all points, or with `down` of those that are alone in an interface
   and carry a block, to the foot of a middle, mostly the last; 0 is not -0. */
static void kern_point_travels(kern_contact *contact, int contacts,
                               const kern_vec *down)
{
    kern_vec middle = kern_vec_make(KERN_R(0), KERN_R(0));
    const kern_contact *of = NULL;
    int i, k;
    for (i = 0; i < contacts; i++) {
        kern_contact *c = contact + i;
        int found = 0;
        for (k = 0; down && !c->line && k < contacts; k++)
            found += kern_same_interface(c, contact + k);
        if (c->line || (down && (found > 1 || kern_carried(c, *down) < 0)))
            continue;
        if (!of || !kern_together(of, c, down)) {
            of = c;
            middle = kern_middle(contact, contacts, c, down);
        }
        c->travel = 0 + kern_vec_cross(c->n, kern_vec_sub(middle, c->p));
    }
}

/* ---- the search ---- */

typedef struct kern_search {
    const kern_block *block;
    int blocks;
    int from; /* the first block that meets those before     */
    kern_fault *fault;
    kern_real floor;       /* places closer than that are the same [m]    */
    kern_real reach;       /* widest gap of any pair [m]                  */
    int listing;           /* overlaps are found and no contacts: of them */
    kern_overlap *overlap; /* there are pair.count                        */
    kern_pair pair;
} kern_search;

/* Half the diagonal of the block's box. */
static kern_real kern_box_half(const kern_block *block)
{
    return kern_vec_length(kern_vec_sub(block->box.high, block->box.low)) / 2;
}

/* The widest gap of blocks of that size; the error's is added to the exact. */
static kern_real kern_search_gap(const kern_search *s, kern_real size)
{
    const kern_options *o = s->pair.options;
    const kern_real exact = o->gap > 0 && !(o->pose_error > 0)
                              ? KERN_R(0)
                              : KERN_GAP * size;
    return kern_max(o->gap + exact, s->floor);
}

/* The tolerances of the pair. */
static void kern_pair_tolerances(kern_pair *pair, const kern_search *s)
{
    const kern_block *a = pair->of[0].block, *b = pair->of[1].block;
    const kern_real size = KERN_SQRT(
        kern_min(a->fixed ? KERN_INFINITY : kern_abs(a->area),
                 b->fixed ? KERN_INFINITY : kern_abs(b->area)));
    pair->gap = kern_search_gap(s, size);
    pair->deep = kern_max(pair->gap, pair->options->overlap)
               + pair->swing * (kern_box_half(a) + kern_box_half(b));
    pair->reach = kern_max(s->reach, pair->deep);
    pair->least = kern_max(kern_min(pair->gap, KERN_GAP * size), s->floor);
    pair->foot = kern_max(KERN_SLIGHT * size, s->floor);
    pair->of[0].step = kern_min(pair->gap, KERN_STEP_MOST * size) + s->floor;
    pair->of[1].step = pair->of[0].step;
    pair->of[0].spans = pair->of[1].spans = 0;
}

/* Whether box or area of the vertices changed since kern_block_init(). */
static int kern_block_is_stale(const kern_block *block)
{
    kern_block now = *block;
    kern_polygon_area(&now);
    return kern_vec_largest(kern_vec_sub(now.box.low, block->box.low)) > 0
        || kern_vec_largest(kern_vec_sub(now.box.high, block->box.high)) > 0
        || !(kern_abs(now.area - block->area)
             <= KERN_GAP * kern_abs(block->area));
}

/* Finds contacts of blocks i and j that are not both fixed, or an overlap. */
KERN_SHARED static kern_status kern_search_pair(kern_search *s, int i, int j)
{
    kern_pair *pair = &s->pair;
    const kern_block *a = &s->block[i], *b = &s->block[j];
    kern_real depth;
    int k;
    if (!a->vertices
        || (!kern_box_near(&a->box, &b->box, s->reach)
            && a->vertex != b->vertex) /* else the first has lost its own */
        || (a->fixed && b->fixed))
        return KERN_OK;
    if (i < s->from && kern_block_is_stale(a)) {
        s->fault->block = i;
        return KERN_STALE;
    }
    kern_outline_set(&pair->of[0], a);
    kern_pair_tolerances(pair, s);
    depth = kern_overlap_depth(&pair->of[0], &pair->of[1], pair->deep,
                               s->listing ? KERN_INFINITY : pair->deep);
    if (depth > 0 && !s->listing) {
        s->fault->block = i;
        s->fault->other = j;
        s->fault->value = depth;
        s->fault->allowed = pair->deep;
        return KERN_OVERLAP;
    }
    if (s->listing) {
        const kern_overlap found = {i, j, depth, pair->deep};
        if (depth > 0 && pair->count++ < pair->room)
            s->overlap[pair->count - 1] = found;
        return KERN_OK;
    }
    pair->a = i;
    pair->b = j;
    pair->first = pair->count;
    kern_pair_edges(pair);
    if (pair->count > pair->room)
        return KERN_NO_SPACE;
    for (k = pair->first; k < pair->count; k++)
        kern_pair_face(pair, k);
    kern_point_travels(pair->out + pair->first, pair->count - pair->first,
                       NULL);
    return KERN_OK;
}

/* Makes two points of every line, from the last on. Returns how many points. */
static int kern_search_close(const kern_search *s)
{
    kern_contact *out = s->pair.out;
    int i, side, points = s->pair.count, to;
    for (i = 0; i < s->pair.count; i++)
        points += out[i].line;
    if (points > s->pair.room)
        return (int)KERN_NO_SPACE;
    to = points;
    for (i = s->pair.count - 1; i >= 0; i--) {
        const kern_contact c = out[i];
        for (side = 1; side >= -1; side -= 2) {
            kern_contact *end = &out[--to];
            *end = c;
            if (!c.line)
                break;
            end->travel = -KERN_R(side) * c.travel;
            end->p = kern_vec_step(c.p, -end->travel, kern_vec_turn(c.n));
        }
    }
    return points;
}

/* Looks at every block, but at the vertices of those before s->from when a pair
   does; what the tolerances of all pairs depend on. */
KERN_SHARED static kern_status kern_search_survey(kern_search *s)
{
    kern_real most = KERN_R(0); /* largest coordinate                 */
    kern_real area = KERN_R(0); /* largest of a free block            */
    kern_real arm = KERN_R(0);  /* twice the longest diagonal of a box */
    int i;
    s->pair.swing = KERN_ERRORS * s->pair.options->pose_turn;
    s->pair.sine = kern_sine(s->pair.options->angle);
    for (i = 0; i < s->blocks; i++) {
        const kern_block *block = &s->block[i];
        const kern_box *box = &block->box;
        kern_status status = block->vertices < 0
                               ? KERN_NO_BLOCK
                               : kern_vertices_check(block->vertex,
                                                     block->vertices);
        if (!block->vertices)
            continue;
        if (status == KERN_OK)
            status = !kern_is_finite(block->area)
                          || !kern_box_near(box, box, 0) /* low above high */
                          || kern_box_largest(box) > KERN_FAR
                       ? KERN_BAD_NUMBER
                   : !(kern_abs(block->area) > 0)               ? KERN_NO_AREA
                   : i >= s->from && kern_block_is_stale(block) ? KERN_STALE
                                                                : KERN_OK;
        if (status != KERN_OK) {
            s->fault->block = i;
            return status;
        }
        most = kern_max(most, kern_box_largest(box));
        if (s->pair.swing > 0) /* spares roots */
            arm = kern_max(arm, 4 * kern_box_half(block));
        if (!block->fixed)
            area = kern_max(area, kern_abs(block->area));
    }
    s->floor = 2 * KERN_ROUNDING * most;
    s->reach = kern_search_gap(s, KERN_SQRT(area)) + s->pair.swing * arm;
    return KERN_OK;
}

/* What the search was handed, but for the blocks themselves. */
static kern_status kern_search_asked(const kern_search *s)
{
    const kern_options *o = s->pair.options;
    const kern_status status = o ? kern_options_check(o) : KERN_BAD_POINTER;
    return status != KERN_OK ? status
         : s->from < 0 || s->blocks < s->from || s->pair.room < 0
                   || s->blocks > KERN_POINTS_MOST
             ? KERN_BAD_COUNT
         : (s->blocks > 0 && !s->block) || (s->pair.room > 0 && !s->pair.out)
             ? KERN_BAD_POINTER
             : KERN_OK;
}

/* Contacts of the blocks from one on, or a list of overlaps. */
static int kern_search_run(const kern_block *block, int blocks,
                           const kern_options *options, void *out, int room,
                           kern_work *work, int from, int listing)
{
    kern_search s;
    kern_status status;
    int a, b;
    if (!work)
        return (int)KERN_BAD_POINTER;
    kern_fault_clear(&work->fault);
    s.block = block;
    s.blocks = blocks;
    s.from = from;
    s.pair.options = options;
    s.fault = &work->fault;
    s.listing = listing;
    s.overlap = (kern_overlap *)out;
    s.pair.out = (kern_contact *)out;
    s.pair.room = room;
    s.pair.count = 0;
    status = kern_search_asked(&s);
    if (status == KERN_OK)
        status = kern_search_survey(&s);
    for (b = from; b < blocks && status == KERN_OK; b++) {
        kern_outline_set(&s.pair.of[1], &block[b]);
        for (a = block[b].vertices ? 0 : b; a < b && status == KERN_OK; a++)
            status = kern_search_pair(&s, a, b);
    }
    if (status != KERN_OK)
        return (int)status;
    if (listing)
        return s.pair.count;
    room = kern_search_close(&s);
    if (room > 0 && kern_vec_largest(options->lone) > 0)
        kern_point_travels(s.pair.out, room, &options->lone);
    return room;
}

KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options, kern_contact *out,
                           int room, kern_work *work)
{
    return kern_search_run(block, blocks, options, out, room, work, 0, 0);
}

KERN_API int kern_touch(const kern_block *block, int b,
                        const kern_options *options, kern_contact *out,
                        int room, kern_work *work)
{
    return kern_search_run(block, b + (b <= KERN_POINTS_MOST), options, out,
                           room, work, b, 0);
}

KERN_API int kern_overlaps(const kern_block *block, int blocks,
                           const kern_options *options, kern_overlap *out,
                           int room, kern_work *work)
{
    return kern_search_run(block, blocks, options, out, room, work, 0, 1);
}

/* ---- contacts that are given ---- */

KERN_API int kern_contact_make(kern_contact *out, kern_vec q,
                               const kern_options *options)
{
    kern_vec d, normal;
    kern_status status;
    kern_real length, longest;
    int line;
    if (!options || !out)
        return (int)KERN_BAD_POINTER;
    out->travel = KERN_R(0);
    status = kern_options_check(options);
    if (status >= 0)
        status = kern_contact_check(out, KERN_POINTS_MOST);
    if (status < 0)
        return (int)status;
    if (!kern_vec_is_moderate(q))
        return (int)KERN_BAD_NUMBER;
    longest = kern_vec_largest(out->n);
    if (!(longest > 0) || !kern_is_finite(1 / longest))
        return (int)KERN_BAD_NORMAL;
    /* first made about 1 long: its square may be no number */
    normal = kern_vec_unit(kern_vec_scale(out->n, 1 / longest));
    d = kern_vec_sub(q, out->p);
    length = kern_vec_length(d);
    line = length
         > 2 * KERN_ROUNDING
               * kern_max(kern_vec_largest(out->p), kern_vec_largest(q));
    if (line
        && kern_abs(kern_vec_dot(d, normal))
               > kern_sine(options->angle) * length)
        return (int)KERN_BAD_LINE;
    out->n = normal;
    out->line = line;
    if (line) {
        out->travel = kern_vec_cross(normal, d) / 2;
        out[1] = *out;
        out[1].p = q;
        out[1].travel = -out->travel;
    }
    return 1 + line;
}

/* The ends of a line go to its middle. */
KERN_API void kern_contact_travels(kern_contact *contact, int contacts)
{
    int i;
    if (!contact)
        return;
    kern_point_travels(contact, contacts, NULL);
    for (i = 0; i < contacts; i++)
        if (kern_line_begins(contact, contacts, i)) {
            kern_contact *c = &contact[i++];
            c->travel = kern_vec_cross(c->n, kern_vec_sub(c[1].p, c->p)) / 2;
            c[1].travel = -c->travel;
        }
}

/* ---- Planning ---------------------------------------------------- >>plan */
/* What is known of a structure is the bracket of its last margin, with a
   mechanism at the upper end of it. A stone that does not touch what moves
   there leaves the mechanism as it is: the old motion proves it again, and one
   verdict at the lower end is left to do. Else the known forces help. */

KERN_API kern_plan kern_plan_of(kern_block *block, int blocks,
                                kern_contact *contact, int contacts,
                                kern_known known, kern_work *work)
{
    kern_plan plan = {kern_task_of(block, 0, contact, 0, work), block, blocks,
                      contact, contacts};
    plan.task.known = known;
    return plan;
}

/* Whether all that a plan needs was given. */
static int kern_plan_is_whole(const kern_plan *plan)
{
    return plan && plan->block && plan->contact && plan->task.known.motion
        && plan->task.known.force && plan->task.work;
}

/* Lays the block behind the others, at rest, and finds its contacts. */
KERN_API int kern_plan_add(kern_plan *plan, const kern_block *block)
{
    kern_structure *s;
    int found;
    if (plan && plan->task.work)
        kern_work_begin(plan->task.work);
    if (!kern_plan_is_whole(plan) || !block)
        return (int)KERN_BAD_POINTER;
    s = &plan->task.s;
    if (s->blocks >= plan->block_room)
        return (int)KERN_NO_SPACE;
    plan->block[s->blocks] = *block;
    found = kern_touch(plan->block, s->blocks, &plan->task.options,
                       plan->contact + s->contacts,
                       plan->contact_room - s->contacts, plan->task.work);
    if (found < 0)
        return found;
    kern_zero(plan->task.known.motion + s->blocks++, 3);
    kern_zero(plan->task.known.force + s->contacts, 2 * found);
    s->contacts += found;
    return found;
}

KERN_API kern_status kern_plan_remove(kern_plan *plan, int i)
{
    kern_structure *s;
    int k, n = 0;
    if (!kern_plan_is_whole(plan))
        return KERN_BAD_POINTER;
    s = &plan->task.s;
    kern_fault_clear(&plan->task.work->fault);
    if (i < 0 || i >= s->blocks)
        return KERN_BAD_BLOCK;
    for (k = 0; k < s->contacts; k++) {
        kern_contact *c = &plan->contact[k];
        if (c->a == i || c->b == i)
            continue;
        c->a -= c->a > i;
        c->b -= c->b > i;
        plan->task.known.force[n] = plan->task.known.force[k];
        plan->contact[n++] = *c;
    }
    for (k = i; k + 1 < s->blocks; k++) {
        plan->block[k] = plan->block[k + 1];
        plan->task.known.motion[k] = plan->task.known.motion[k + 1];
    }
    s->contacts = n;
    s->blocks--;
    if (plan->task.known.fails > 0)
        kern_motion_scale(s, plan->task.known.motion);
    return KERN_OK;
}

/* Adds the block, unless that is NULL: a number of contacts, or a status. */
KERN_SHARED static int kern_plan_open(kern_plan *plan, const kern_block *block)
{
    return block                    ? kern_plan_add(plan, block)
         : kern_plan_is_whole(plan) ? 0
                                    : (int)KERN_BAD_POINTER;
}

/* Takes back what kern_plan_add() did; returns the answer that it was for. */
static kern_status kern_plan_back(kern_plan *plan, const kern_block *block,
                                  int found, kern_status answer)
{
    if (found >= 0) {
        plan->task.s.blocks -= block != NULL;
        plan->task.s.contacts -= found;
    }
    return answer;
}

KERN_API kern_status kern_plan_try(kern_plan *plan, const kern_block *block,
                                   kern_margin *out, const kern_proof *proof)
{
    const int found = kern_plan_add(plan, block);
    return kern_plan_back(
        plan, block, found,
        found < 0
            ? (kern_status)found
            : kern_measure_anew(&plan->task, &plan->task.known, out, proof));
}

/* Whether it stands at that margin; if kerns are not nested, below it too. */
static kern_status kern_plan_stands(const kern_task *task, kern_real margin,
                                    const kern_proof *proof)
{
    const kern_known *known = &task->known;
    kern_real range[2];
    kern_call c;
    kern_margin r;
    kern_status status = kern_call_open(&c, task, margin, known);
    if (status == KERN_OK && !(margin >= 0))
        status = KERN_BAD_NUMBER;
    if (status != KERN_OK)
        return status;
    kern_model_know(&c.m, known);
    status = KERN_FALLS;
    if (!(known->fails > 0 && margin >= known->fails
          && kern_known_falls(&c.m, &c.path.q, known))) {
        kern_known_begin(&c.m, margin);
        status = kern_model_evaluate(&c.m, &c.part, &c.path.q);
    }
    kern_proof_out(&c.m, proof, status);
    if (status == KERN_STANDS && !kern_is_nested(&c.m, range)) {
        const kern_proof below = {NULL, proof ? proof->motion : NULL};
        c.path.q.shrink = KERN_R(0);
        status = kern_measure_task(&c, known, &r, &below);
        if (status == KERN_STANDS && !r.saturated && r.margin < margin)
            status = KERN_FALLS;
    }
    return kern_ended(task, status);
}

KERN_API kern_status kern_plan_bears(kern_plan *plan, const kern_block *block,
                                     kern_real margin, const kern_proof *proof)
{
    const int found = kern_plan_add(plan, block);
    return kern_plan_back(plan, block, found,
                          found < 0
                              ? (kern_status)found
                              : kern_plan_stands(&plan->task, margin, proof));
}

KERN_API kern_status kern_plan_stays(kern_plan *plan, const kern_block *block,
                                     kern_real *chance)
{
    const int found = kern_plan_open(plan, block);
    return kern_plan_back(
        plan, block, found,
        found < 0 ? (kern_status)found
                  : kern_stays(&plan->task, plan->task.s.blocks - 1, chance));
}

KERN_API kern_status kern_plan_raised(kern_plan *plan, const kern_block *block,
                                      kern_raising *out, kern_real *reserve,
                                      const kern_proof *proof)
{
    const int found = kern_plan_open(plan, block);
    return kern_plan_back(
        plan, block, found,
        found < 0 ? (kern_status)found
                  : kern_raised(&plan->task, KERN_R(0), out, reserve, proof));
}

KERN_API kern_status kern_plan_copy(kern_plan *to, const kern_plan *from)
{
    const kern_structure *s;
    kern_known *known;
    int i;
    if (!kern_plan_is_whole(to) || !kern_plan_is_whole(from))
        return KERN_BAD_POINTER;
    s = &from->task.s;
    if (s->blocks > to->block_room || s->contacts > to->contact_room)
        return KERN_NO_SPACE;
    for (i = 0; i < s->blocks; i++)
        to->block[i] = s->block[i];
    for (i = 0; i < s->contacts; i++)
        to->contact[i] = s->contact[i];
    to->task.s.block = to->block;
    to->task.s.blocks = s->blocks;
    to->task.s.contact = to->contact;
    to->task.s.contacts = s->contacts;
    to->task.s.gravity = s->gravity;
    to->task.options = from->task.options;
    known = &to->task.known;
    kern_copy(known->motion, from->task.known.motion, 3 * s->blocks);
    kern_copy(known->force, from->task.known.force, 2 * s->contacts);
    known->holds = from->task.known.holds;
    known->margin = from->task.known.margin;
    known->fails = from->task.known.fails;
    return KERN_OK;
}

/* ---- Coming to rest ---------------------------------------------- >>rest */
/* A stone goes down without turning, and then from touch to touch, turning
   about one of the points where it touches or sliding along an edge, until two
   of these points can hold it against its weight. Each motion ends where the
   stone meets something, so nothing overlaps. A vertex of one outline meets an
   edge of the other: along a line, or on an arc. */

/* A point where the stone touches a block. */
typedef struct kern_prop {
    kern_vec p, n;    /* place; unit normal into the stone */
    kern_vec from, t; /* the edge that is touched: its start, unit direction */
    kern_real length;
    int back;   /* 1: an edge of the block; -1: of the stone */
    int block;  /* that is touched                           */
    int corner; /* 1: a convex end of it, which holds nothing */
} kern_prop;

/* A motion of the stone: a slide, or a turn. */
typedef struct kern_course {
    int sense;      /* 0: slide; 1: counter-clockwise; -1: clockwise      */
    kern_real end;  /* end of the motion: way, or sine of the turn        */
    kern_vec along; /* slide: unit direction                              */
    kern_real low, high; /* what the stone covers across that             */
    kern_real front;     /* how far it reaches along it                   */
    kern_vec about;      /* turn: its centre                              */
    kern_vec turn;       /* at its end: cosine, and sine in its sense     */
    kern_real reach;     /* distance of the farthest vertex               */
    kern_real ring[2];   /* of the distances of the edge in question      */
} kern_course;

typedef struct kern_settling {
    const kern_task *task;
    const kern_block *shape; /* the stone as it was given          */
    kern_pose *pose;         /* where it is now                    */
    kern_vec *vertex;        /* its vertices                       */
    kern_vec down;           /* unit direction of gravity          */
    kern_real touch;         /* distance that touches              */
    kern_box swept;          /* what a motion covers at most       */
    kern_prop prop[KERN_REST_TOUCHES];
    int props;
} kern_settling;

/* Returns a turned by the angle whose cosine and sine are q. */
static kern_vec kern_vec_turned(kern_vec a, kern_vec q)
{
    return kern_vec_make(q.x * a.x - q.y * a.y, q.y * a.x + q.x * a.y);
}

/* Returns a turned about a point. */
static kern_vec kern_vec_about(kern_vec a, kern_vec about, kern_vec q)
{
    return kern_vec_add(about, kern_vec_turned(kern_vec_sub(a, about), q));
}

/* Returns cosine and sine of an angle: of a small part of it, which doubles. */
static kern_vec kern_turn_of(kern_real angle)
{
    kern_vec q;
    int doubles = 0;
    while (kern_abs(angle) > KERN_REST_SMALL) {
        angle /= 2;
        doubles++;
    }
    q.y = kern_sine(angle);
    q.x = KERN_SQRT(1 - q.y * q.y);
    for (; doubles > 0; doubles--)
        q = kern_vec_unit(kern_vec_turned(q, q));
    return q;
}

/* Returns cosine and sine of the turn at the end of a motion. */
static kern_vec kern_rest_turn(const kern_course *c)
{
    return kern_vec_make(c->turn.x, KERN_R(c->sense) * c->turn.y);
}

/* Moves the stone to a place of its centre, turned as the pose says. */
static void kern_rest_put(kern_settling *r, kern_vec centre)
{
    const kern_block *shape = r->shape;
    kern_block *b = &r->pose->block;
    int i;
    b->centre = centre;
    for (i = 0; i < b->vertices; i++) {
        r->vertex[i] = kern_vec_add(
            centre,
            kern_vec_turned(kern_vec_sub(shape->vertex[i], shape->centre),
                            r->pose->turn));
        if (i == 0)
            b->box.low = b->box.high = r->vertex[0];
        kern_box_add(&b->box, r->vertex[i]);
    }
}

/* Sets the ends of edge i of a block, counter-clockwise. */
static void kern_rest_ends(const kern_block *b, int i, kern_vec *from,
                           kern_vec *to)
{
    const kern_vec p = b->vertex[i];
    const kern_vec q = b->vertex[i + 1 < b->vertices ? i + 1 : 0];
    *from = b->area < 0 ? q : p;
    *to = b->area < 0 ? p : q;
}

/* Returns 1 if a point `s` along the edge from its start lies on it, and does
   not leave it at an end where it moves along the edge at that pace. */
static int kern_rest_on(const kern_settling *r, const kern_prop *e, kern_real s,
                        kern_real pace)
{
    const kern_real end = KERN_REST_END * r->touch;
    return s > (pace < -KERN_REST_ALONG ? end : -end)
        && s < e->length + (pace > KERN_REST_ALONG ? -end : end);
}

/* Returns 1 if both edges of vertex k of b are on the outer side of the edge. */
static int kern_rest_parts(const kern_settling *r, const kern_prop *e,
                           const kern_block *b, int k)
{
    int back, parts = 1;
    for (back = 0; back < 2; back++)
        parts &= KERN_R(e->back)
                   * kern_vec_dot(
                       e->n,
                       kern_vec_sub(b->vertex[kern_polygon_next(b, k, back)],
                                    b->vertex[k]))
              >= -r->touch;
    return parts;
}

/* Keeps the touch of vertex k of b with edge i of a, if it is one. */
static void kern_rest_touch(kern_settling *r, const kern_prop *e,
                            const kern_block *a, int i, const kern_block *b,
                            int k)
{
    const kern_vec w = kern_vec_sub(b->vertex[k], e->from);
    const kern_real s = kern_vec_dot(e->t, w);
    const kern_real foot = KERN_REST_FOOT * r->touch;
    kern_prop *prop = &r->prop[r->props];
    if (kern_abs(kern_vec_cross(e->t, w)) > r->touch
        || !kern_rest_on(r, e, s, KERN_R(0)) || r->props >= KERN_REST_TOUCHES)
        return;
    *prop = *e;
    prop->p = b->vertex[k];
    prop->corner = 0;
    if (s < foot || s > e->length - foot) {
        const int last = (s < foot) == (a->area < 0);
        prop->corner = kern_polygon_turn(a,
                                         last ? kern_polygon_next(a, i, 0) : i)
                     > 0;
    }
    r->props += !prop->corner || kern_rest_parts(r, e, b, k);
}

/* Ends a slide where a point meets the edge from outside. */
static void kern_rest_slide(const kern_settling *r, kern_course *c,
                            const kern_prop *e, kern_vec p)
{
    const kern_vec w = kern_vec_sub(p, e->from);
    const kern_real into = -kern_vec_dot(e->n, c->along);
    const kern_real gap = kern_vec_cross(w, e->t), way = gap / into;
    const kern_real pace = KERN_R(e->back) * kern_vec_dot(e->t, c->along);
    if (into > KERN_NOISE && gap >= -r->touch && way < c->end
        && kern_rest_on(r, e, kern_vec_dot(e->t, w) + way * pace,
                        gap > r->touch ? KERN_R(0) : pace))
        c->end = kern_max(way, 0);
}

/* Ends a turn where a point meets the edge from outside. */
static void kern_rest_arc(const kern_settling *r, kern_course *c,
                          const kern_prop *e, kern_vec p)
{
    const kern_vec arm = kern_vec_sub(p, c->about);
    const kern_vec w = kern_vec_sub(c->about, e->from);
    const kern_real square = kern_vec_dot(arm, arm);
    const kern_real off = kern_vec_cross(e->t, w), side = square - off * off;
    const kern_real sense = KERN_R(c->sense * e->back);
    kern_real s, sine, cosine;
    kern_vec to;
    if (side < 0 || square < r->touch * r->touch)
        return;
    s = kern_vec_dot(e->t, w) + sense * KERN_SQRT(side);
    if (!kern_rest_on(r, e, s, KERN_R(0)))
        return;
    to = kern_vec_sub(kern_vec_step(e->from, s, e->t), c->about);
    cosine = kern_vec_dot(arm, to) / square;
    sine = sense * kern_vec_cross(arm, to) / square;
    if (!(cosine > 0) || sine >= c->end || -sine * KERN_SQRT(square) > r->touch)
        return;
    c->end = kern_max(sine, 0);
    c->turn = sine > 0 ? kern_vec_unit(kern_vec_make(cosine, sine))
                       : kern_vec_make(KERN_R(1), KERN_R(0));
}

/* Returns 1 if a vertex of the other outline may meet the edge in a slide. */
static int kern_rest_slides(const kern_course *c, int back, kern_vec from,
                            kern_vec to)
{
    const kern_real p = kern_vec_cross(c->along, from);
    const kern_real q = kern_vec_cross(c->along, to);
    return KERN_R(back) * (p - q) > 0
        && (back < 0
            || (kern_max(p, q) > c->low && kern_min(p, q) < c->high
                && kern_min(kern_vec_dot(c->along, from),
                            kern_vec_dot(c->along, to))
                       < c->front + c->end));
}

/* Returns 1 if a vertex of the other outline may meet the edge in a turn, and
   sets the squares of the distances between which its points lie. */
static int kern_rest_turns(kern_course *c, kern_vec from, kern_vec to)
{
    const kern_vec p = kern_vec_sub(from, c->about);
    const kern_vec q = kern_vec_sub(to, c->about), d = kern_vec_sub(to, from);
    const kern_real pp = kern_vec_dot(p, p), qq = kern_vec_dot(q, q);
    const kern_real off = kern_vec_cross(p, d);
    c->ring[0] = kern_vec_dot(p, d) < 0 && kern_vec_dot(q, d) > 0
                   ? off * off / kern_vec_dot(d, d)
                   : kern_min(pp, qq);
    c->ring[0] *= 1 - KERN_REST_ALONG;
    c->ring[1] = kern_max(pp, qq) * (1 + KERN_REST_ALONG);
    return c->ring[0] <= c->reach * c->reach;
}

/* Returns 1 if the box of an edge comes near another. */
static int kern_rest_is_near(const kern_box *box, kern_vec from, kern_vec to,
                             kern_real touch)
{
    const kern_real left = box->low.x - touch, right = box->high.x + touch;
    const kern_real low = box->low.y - touch, high = box->high.y + touch;
    return (from.x >= left || to.x >= left)
        && (from.x <= right || to.x <= right) && (from.y >= low || to.y >= low)
        && (from.y <= high || to.y <= high);
}

/* Ends a motion where the vertex p meets the edge. */
static void kern_rest_meet(const kern_settling *r, kern_course *c,
                           const kern_prop *e, kern_vec p)
{
    if (c->sense) {
        const kern_vec arm = kern_vec_sub(p, c->about);
        const kern_real square = kern_vec_dot(arm, arm);
        if (square >= c->ring[0] && square <= c->ring[1])
            kern_rest_arc(r, c, e, p);
    } else {
        const kern_real across = kern_vec_cross(c->along, p);
        if (e->back > 0 || (across > c->low && across < c->high))
            kern_rest_slide(r, c, e, p);
    }
}

/* Returns 1 if a vertex of b may meet the edge: is near it, where c is NULL. */
static int kern_rest_may(const kern_settling *r, kern_course *c,
                         const kern_prop *e, kern_vec to, const kern_block *b)
{
    const kern_box *const box = e->back > 0 ? &r->swept : &b->box;
    if ((e->back > 0 || !c) && !kern_rest_is_near(box, e->from, to, r->touch))
        return 0;
    return !c
        || (c->sense ? kern_rest_turns(c, e->from, to)
                     : kern_rest_slides(c, e->back, e->from, to));
}

/* Returns 1 if the stone may come to a point in its motion. */
static int kern_rest_sweeps(const kern_settling *r, kern_vec p)
{
    return p.y <= r->swept.high.y && p.y >= r->swept.low.y
        && p.x >= r->swept.low.x && p.x <= r->swept.high.x;
}

/* Looks at each edge of a and each vertex of b, one of which is the stone: for
   touches, or for the end of a motion unless c is NULL. */
static void kern_rest_pair(kern_settling *r, kern_course *c, kern_prop *e,
                           const kern_block *a, const kern_block *b)
{
    int i, k, first = 0, last = b->vertices;
    if (e->back < 0) {
        while (first < last && !kern_rest_sweeps(r, b->vertex[first]))
            first++;
        while (first < last && !kern_rest_sweeps(r, b->vertex[last - 1]))
            last--;
    }
    for (i = 0; i < a->vertices && first < last; i++) {
        kern_vec to;

        /* pass by an edge that no vertex of b can meet */
        kern_rest_ends(a, i, &e->from, &to);
        if (!kern_rest_may(r, c, e, to, b))
            continue;

        e->t = kern_vec_sub(to, e->from);
        e->length = kern_vec_length(e->t);
        e->t = kern_vec_scale(e->t, 1 / e->length);
        e->n = kern_vec_scale(kern_vec_turn(e->t), -KERN_R(e->back));
        for (k = first; k < last; k++)
            if (c)
                kern_rest_meet(r, c, e, b->vertex[k]);
            else
                kern_rest_touch(r, e, a, i, b, k);
    }
}

/* Measures the stone for a motion: how far it reaches. */
static void kern_rest_reach(kern_settling *r, kern_course *c)
{
    const kern_real end = KERN_REST_END * r->touch;
    int i;
    c->low = KERN_INFINITY;
    c->high = c->front = -c->low;
    c->reach = KERN_R(0);
    for (i = 0; i < r->shape->vertices; i++) {
        const kern_vec p = r->vertex[i];
        if (c->sense) {
            const kern_vec arm = kern_vec_sub(p, c->about);
            c->reach = kern_max(c->reach, kern_vec_dot(arm, arm));
        } else {
            const kern_real across = kern_vec_cross(c->along, p);
            c->low = kern_min(c->low, across + end);
            c->high = kern_max(c->high, across - end);
            c->front = kern_max(c->front, kern_vec_dot(c->along, p));
        }
    }
    c->reach = KERN_SQRT(c->reach);
}

/* Sets what the stone covers at most in a motion; where c is NULL, covers. */
static void kern_rest_box(kern_settling *r, const kern_course *c)
{
    const kern_vec touch = kern_vec_make(r->touch, r->touch);
    const kern_box stone = r->pose->block.box;
    kern_box *const box = &r->swept;
    *box = stone;
    if (c && c->sense) {
        /* an arc is beyond its ends by less than this */
        const kern_real bulge = c->reach * (1 - c->turn.x);
        const kern_vec turn = kern_rest_turn(c);
        const kern_vec out = kern_vec_make(bulge, bulge);
        int i;
        for (i = 0; i < r->shape->vertices; i++)
            kern_box_add(box, kern_vec_about(r->vertex[i], c->about, turn));
        box->low = kern_vec_sub(box->low, out);
        box->high = kern_vec_add(box->high, out);
    } else if (c) {
        const kern_vec way = kern_vec_scale(c->along, c->end);
        kern_box_add(box, kern_vec_add(stone.low, way));
        kern_box_add(box, kern_vec_add(stone.high, way));
    }
    box->low = kern_vec_sub(box->low, touch);
    box->high = kern_vec_add(box->high, touch);
}

/* Returns the units of work of a look at a block. */
static int kern_rest_units(const kern_block *b, const kern_block *stone)
{
    const kern_real pairs = KERN_R(b->vertices) * KERN_R(stone->vertices);
    return 1 + (int)kern_min(pairs / (KERN_UNIT / 2), KERN_R(KERN_WORK_MOST));
}

/* Returns 1 if the stone goes farther than it takes to touch. */
static int kern_rest_goes(const kern_settling *r, const kern_course *c)
{
    return c->end * (c->sense ? c->reach : KERN_R(1)) > r->touch;
}

/* Finds where a motion ends, or for NULL the touches. Returns 0 where the call
   has no work left, and where the motion ends at once. */
static int kern_rest_look(kern_settling *r, kern_course *c)
{
    const kern_structure *s = &r->task->s;
    const kern_block *stone = &r->pose->block;
    const int limit = r->task->options.limit;
    kern_prop edge;
    if (!kern_spend(r->task->work, limit, 1 + s->blocks / KERN_UNIT))
        return 0;
    if (c)
        kern_rest_reach(r, c);
    else
        r->props = 0;
    kern_rest_box(r, c);
    /* the last are often the highest, and shorten the way */
    for (edge.block = s->blocks - 1; edge.block >= 0; edge.block--) {
        const kern_block *b = &s->block[edge.block];
        if (!b->vertices || !kern_box_near(&r->swept, &b->box, KERN_R(0)))
            continue;
        if (!kern_spend(r->task->work, limit, kern_rest_units(b, stone)))
            return 0;
        edge.back = 1;
        kern_rest_pair(r, c, &edge, b, stone);
        edge.back = -1;
        kern_rest_pair(r, c, &edge, stone, b);
        if (c && !kern_rest_goes(r, c))
            return 0;
        if (c)
            kern_rest_box(r, c);
    }
    return 1;
}

/* Returns 1 if a force within the cone of friction there may be `at` + s
   `slope`, for an s in [*low, *high], which it narrows. */
static void kern_rest_cone(const kern_settling *r, const kern_prop *e,
                           kern_vec at, kern_vec slope, kern_real *low,
                           kern_real *high)
{
    const kern_vec t = kern_vec_turn(e->n);
    int side;
    for (side = -1; side <= 1; side++) {
        const kern_vec inner = kern_vec_step(
            kern_vec_scale(e->n, side ? r->task->options.mu : KERN_R(1)),
            KERN_R(side), t);
        kern_clip(low, high, kern_vec_dot(inner, at),
                  kern_vec_dot(inner, slope), -KERN_NOISE, KERN_INFINITY);
    }
}

/* Returns 1 if forces at two touches balance the weight; at one of them, if
   they are the same, below or above the centre. */
static int kern_rest_balances(const kern_settling *r, const kern_prop *e,
                              const kern_prop *f)
{
    const kern_vec up = kern_vec_scale(r->down, KERN_R(-1));
    const kern_vec arm = kern_vec_sub(r->pose->block.centre, e->p);
    const kern_vec d = kern_vec_sub(f->p, e->p);
    const kern_real square = kern_vec_dot(d, d),
                    lever = kern_vec_cross(arm, up);
    kern_real low = -KERN_BOUND, high = KERN_BOUND;
    kern_vec at = kern_vec_make(KERN_R(0), KERN_R(0)), slope = at;
    if (e != f) {
        if (square < r->touch * r->touch)
            return 0;
        /* the force at f, but for a share of d, from torques about e */
        at = kern_vec_scale(kern_vec_turn(d), lever / square);
        slope = kern_vec_scale(d, 1 / KERN_SQRT(square));
        kern_rest_cone(r, f, at, slope, &low, &high);
    } else if (kern_abs(lever) > r->touch)
        return 0;
    kern_rest_cone(r, e, kern_vec_sub(up, at),
                   kern_vec_scale(slope, KERN_R(-1)), &low, &high);
    return low <= high;
}

/* Returns 1 if the touches hold the stone, and tells which. */
static int kern_rest_holds(kern_settling *r)
{
    int i, k;
    for (i = 0; i < r->props; i++)
        for (k = 0; k <= i; k++)
            if (!r->prop[i].corner && !r->prop[k].corner
                && kern_rest_balances(r, &r->prop[k], &r->prop[i])) {
                r->pose->at[0] = r->prop[k].p;
                r->pose->at[1] = r->prop[i].p;
                r->pose->on[0] = r->prop[k].block;
                r->pose->on[1] = r->prop[i].block;
                return 1;
            }
    return 0;
}

/* Moves the stone to where the motion ends. Returns 1 if it moved. */
static int kern_rest_go(kern_settling *r, kern_course *c)
{
    kern_block *b = &r->pose->block;
    kern_vec centre;
    if (!kern_rest_look(r, c) || !kern_rest_goes(r, c))
        return 0;
    if (c->sense == 0) {
        centre = kern_vec_step(b->centre, c->end, c->along);
    } else {
        const kern_vec turn = kern_rest_turn(c);
        r->pose->turn = kern_vec_unit(kern_vec_turned(r->pose->turn, turn));
        centre = kern_vec_about(b->centre, c->about, turn);
    }
    kern_rest_put(r, centre);
    r->pose->motions++;
    return 1;
}

/* Turns the stone about a touch, the way its weight turns it, until it meets
   something, by at most a quarter and until the centre is lowest. Each step
   looks only at what is near. Returns 1 if it moved. */
static int kern_rest_tip(kern_settling *r, const kern_prop *e)
{
    const kern_vec about = e->p;
    kern_course c;
    int step;
    c.sense = 0;
    for (step = 0; step < KERN_REST_STEPS; step++) {
        const kern_vec arm = kern_vec_sub(r->pose->block.centre, about);
        const kern_real lever = kern_vec_cross(arm, r->down);
        const kern_real low = kern_vec_dot(arm, r->down);
        kern_real most = KERN_REST_SINE;
        c.about = c.along = about;
        c.sense = lever < 0 ? -1 : 1;
        c.turn = kern_vec_make(KERN_REST_COSINE, KERN_REST_SINE);
        if (low > 0 && kern_abs(lever) < low * KERN_REST_SINE) {
            c.turn = kern_vec_unit(kern_vec_make(low, kern_abs(lever)));
            most = c.turn.y;
        }
        c.end = most;
        if (!kern_rest_go(r, &c))
            break;
        if (c.end < KERN_REST_SINE)
            return 1;
    }
    return step > 0;
}

/* Slides the stone until it meets something, its centre is above the end of
   what it slides on, or a vertex runs off there. Returns 1 if it moved. */
static int kern_rest_run(kern_settling *r, kern_vec along, kern_real most)
{
    const kern_vec level = kern_vec_turn(r->down);
    const kern_vec centre = r->pose->block.centre;
    const kern_real pace = kern_vec_dot(along, level);
    kern_course c;
    int i;
    c.along = c.about = c.turn = along;
    c.sense = 0;
    c.end = most;
    for (i = 0; i < r->props; i++) {
        const kern_prop *e = &r->prop[i];
        const kern_real way = KERN_R(e->back) * kern_vec_dot(e->t, along);
        const kern_real at = kern_vec_dot(e->t, kern_vec_sub(e->p, e->from));
        const kern_real end = way > 0 ? e->length - at : at;
        const kern_real ahead = kern_vec_dot(kern_vec_sub(e->p, centre), level);
        if (kern_abs(kern_vec_dot(e->n, along)) > KERN_REST_ALONG)
            continue;
        if (end > r->touch)
            c.end = kern_min(c.end, end);
        if (e->back < 0 && ahead * pace > 0 && ahead / pace > r->touch)
            c.end = kern_min(c.end, ahead / pace);
    }
    return kern_rest_go(r, &c);
}

/* Returns 1 if a slide parts the stone from all that it touches. Past a corner
   on a corner one of the edges there is enough. */
static int kern_rest_open(const kern_settling *r, kern_vec along)
{
    int i, k, open = 1;
    for (i = 0; i < r->props && open; i++) {
        const kern_prop *e = &r->prop[i];
        open = kern_vec_dot(e->n, along) >= -KERN_REST_ALONG;
        for (k = 0; k < r->props && e->corner && !open; k++) {
            const kern_prop *f = &r->prop[k];
            open = f->corner && f->block == e->block
                && kern_vec_largest(kern_vec_sub(e->p, f->p)) <= 2 * r->touch
                && kern_vec_dot(f->n, along) >= -KERN_REST_ALONG;
        }
    }
    return open;
}

/* Slides the stone down freely, or along the steepest edge that is steeper than
   friction holds and along which nothing is in the way. Returns 1 if it moved.
 */
static int kern_rest_slip(kern_settling *r, kern_real sticks)
{
    const kern_vec size = kern_vec_sub(r->pose->block.box.high,
                                       r->pose->block.box.low);
    kern_vec best = r->down;
    kern_real steepest = KERN_R(0);
    int i, side;
    for (i = -1; i < r->props; i++)
        for (side = -1; side <= 1; side += 2) {
            const kern_prop *e = &r->prop[i < 0 ? 0 : i];
            const kern_vec u = i < 0 ? r->down
                                     : kern_vec_scale(e->t, KERN_R(side));
            const kern_real steep = kern_vec_dot(u, r->down);
            if (steep > steepest
                && (i < 0 || -kern_vec_dot(e->n, r->down) < sticks)
                && kern_rest_open(r, u)) {
                steepest = steep;
                best = u;
            }
        }
    return steepest > 0 && kern_rest_run(r, best, 2 * kern_vec_length(size));
}

/* Returns the support beside which the centre lies, or NULL where it lies
   between supports or there are none. */
static const kern_prop *kern_rest_hinge(const kern_settling *r)
{
    const kern_vec level = kern_vec_turn(r->down);
    const kern_prop *left = NULL, *right = NULL;
    kern_real least = KERN_INFINITY, most = -least, at;
    int i;
    for (i = 0; i < r->props; i++) {
        const kern_prop *e = &r->prop[i];
        if (-kern_vec_dot(e->n, r->down) < KERN_REST_UP)
            continue;
        at = kern_vec_dot(kern_vec_sub(e->p, r->pose->block.centre), level);
        if (at < least) {
            least = at;
            left = e;
        }
        if (at > most) {
            most = at;
            right = e;
        }
    }
    return least > 0 ? left : most < 0 ? right : NULL;
}

/* Moves the stone to the next touch. Returns 1 if it moved. */
static int kern_rest_move(kern_settling *r, kern_real below)
{
    const kern_real mu = r->task->options.mu;
    const kern_real sticks = 1 / KERN_SQRT(1 + mu * mu);
    const kern_prop *hinge = kern_rest_hinge(r);
    int i, holds;
    if (r->props == 0)
        return kern_rest_run(
            r, r->down, below - kern_vec_dot(r->pose->block.centre, r->down));
    holds = hinge && -kern_vec_dot(hinge->n, r->down) >= sticks;
    if ((holds && kern_rest_tip(r, hinge)) || kern_rest_slip(r, sticks)
        || (hinge && !holds && kern_rest_tip(r, hinge)))
        return 1;
    for (i = 0; i < r->props; i++)
        if (&r->prop[i] != hinge && kern_rest_tip(r, &r->prop[i]))
            return 1;
    return 0;
}

/* Returns the extent of a box along a direction: from its middle. */
static kern_real kern_rest_half(const kern_box *box, kern_vec d)
{
    return ((box->high.x - box->low.x) * kern_abs(d.x)
            + (box->high.y - box->low.y) * kern_abs(d.y))
         / 2;
}

/* Puts the stone above all blocks, with its centre at x. Sets how far down its
   centre goes where it misses them; -infinity where there are none. */
static kern_status kern_rest_lift(kern_settling *r, kern_real x,
                                  kern_real *below)
{
    const kern_structure *s = &r->task->s;
    const kern_vec level = kern_vec_turn(r->down);
    const kern_real half = 2 * kern_box_half(r->shape);
    kern_real top = KERN_INFINITY, bottom = -top, largest = kern_abs(x);
    int i;
    for (i = 0; i < s->blocks; i++) {
        const kern_box *box = &s->block[i].box;
        kern_real at, deep;
        r->task->work->fault.block = i;
        if (s->block[i].vertices < 0)
            return KERN_NO_BLOCK;
        if (!s->block[i].vertices)
            continue;
        at = kern_vec_dot(kern_vec_mid(box->low, box->high), r->down);
        deep = kern_rest_half(box, r->down);
        if (!kern_vec_is_moderate(box->low) || !kern_vec_is_moderate(box->high))
            return KERN_BAD_NUMBER;
        top = kern_min(top, at - deep);
        bottom = kern_max(bottom, at + deep);
        largest = kern_max(kern_box_largest(box), largest);
    }
    r->task->work->fault.block = KERN_OUT;
    r->touch = kern_max(KERN_REST_NEAR * kern_block_size(r->shape),
                        2 * KERN_ROUNDING * largest);
    if (top <= bottom)
        kern_rest_put(
            r, kern_vec_step(kern_vec_scale(level, x), top - half, r->down));
    *below = bottom + half;
    return KERN_OK;
}

/* Checks what kern_rest() is given, but for the structure. */
static kern_status kern_rest_check(const kern_task *task,
                                   const kern_block *stone,
                                   const kern_vec *vertex, kern_vec place)
{
    const kern_vec none = {KERN_R(0), KERN_R(0)};
    kern_status status;
    int loaded = 0;
    if (!stone || !vertex || vertex == stone->vertex)
        return KERN_BAD_POINTER;
    if (!kern_vec_is_moderate(place) || !(kern_abs(place.y) <= KERN_REST_TURN))
        return KERN_BAD_NUMBER;
    if (!(kern_vec_largest(task->s.gravity) > 0))
        return KERN_BAD_OPTION;
    task->work->fault.block = task->s.blocks;
    status = kern_block_check(stone, none, &loaded);
    if (status != KERN_OK)
        return status;
    return stone->fixed               ? KERN_BAD_BLOCK
         : stone->vertices < 3        ? KERN_FEW_VERTICES
         : kern_block_is_stale(stone) ? KERN_STALE
         : kern_spend(task->work, task->options.limit,
                      2 + stone->vertices / KERN_UNIT
                          + task->s.blocks / (KERN_UNIT / 2))
             ? KERN_OK
             : KERN_LIMIT;
}

KERN_API kern_status kern_rest(const kern_task *task, const kern_block *stone,
                               kern_real x, kern_real turn, kern_vec *vertex,
                               kern_pose *out)
{
    kern_settling r;
    kern_real below;
    kern_status status = kern_task_check(task, KERN_R(0), out);
    if (status == KERN_OK)
        status = kern_rest_check(task, stone, vertex, kern_vec_make(x, turn));
    if (status != KERN_OK)
        return status;

    out->block = *stone;
    out->block.vertex = r.vertex = vertex;
    out->turn = kern_turn_of(turn);
    out->held = KERN_HELD;
    out->on[0] = out->on[1] = KERN_OUT;
    out->motions = r.props = 0;
    kern_zero(out->at, 4);
    r.task = task;
    r.shape = stone;
    r.pose = out;
    r.down = kern_vec_unit(
        kern_vec_scale(task->s.gravity, 1 / kern_vec_largest(task->s.gravity)));
    status = kern_rest_lift(&r, x, &below);
    if (status != KERN_OK)
        return status;

    /* a stone that cannot move is wedged; one that is below all falls past */
    status = below > -KERN_INFINITY ? KERN_NO_REST : KERN_NO_SUPPORT;
    while (status == KERN_NO_REST && out->motions < KERN_REST_MOTIONS) {
        const int moved = kern_rest_move(&r, below) && kern_rest_look(&r, NULL);
        if (moved && kern_vec_dot(out->block.centre, r.down) > below - r.touch)
            status = KERN_NO_SUPPORT;
        else if (!moved || kern_rest_holds(&r))
            status = KERN_OK;
        if (!moved)
            out->held = KERN_WEDGED;
    }
    return kern_ended(task, status);
}

/* ---- which place is best ---- */

/* Returns 1, 0 or -1 as a is larger than, equal to or smaller than b. */
static int kern_order(kern_real a, kern_real b) { return (a > b) - (a < b); }

/* Returns the margin that a place is ranked by. */
static kern_real kern_place_margin(const kern_place *place, kern_real alone)
{
    return kern_abs(place->margin - alone) <= KERN_PLACE_SAME * alone
             ? alone
             : place->margin;
}

KERN_API int kern_place_compare(const kern_place *a, const kern_place *b,
                                kern_real alone)
{
    int order;
    if (!a || !b)
        return (a != NULL) - (b != NULL);
    order = kern_order(kern_min(a->stays, KERN_PLACE_STAYS),
                       kern_min(b->stays, KERN_PLACE_STAYS));
    if (!order)
        order = kern_order(kern_place_margin(a, alone),
                           kern_place_margin(b, alone));
    if (!order)
        order = kern_order(a->own, b->own);
    if (!order)
        order = kern_order(a->load, b->load);
    if (!order)
        order = kern_order(b->x, a->x);
    return order ? order : kern_order(b->turn, a->turn);
}

/* ==== Part VII: Words ==================================================== */

/* ---- Words and defaults ------------------------------------------ >>words */

KERN_API const char *kern_status_text(int status)
{
    switch (status) {
#define KERN_STATUS_TEXT(name, value, text) \
    case name: return text;
        KERN_STATUS_LIST(KERN_STATUS_TEXT)
#undef KERN_STATUS_TEXT
    }
    return "no status";
}

KERN_API kern_options kern_defaults(void)
{
    kern_options o;
    o.mu = KERN_R(0.4);
    o.angle = KERN_ANGLE;
    o.limit = 10000000; /* a second or two */
    o.relative = 0;
    o.gap = o.epsilon = o.overlap = o.pose_error = o.pose_turn = KERN_R(0);
    o.narrow = o.reserve = o.lone.x = o.lone.y = KERN_R(0);
    return o;
}

/* The options, or for NULL the defaults. */
KERN_SHARED static kern_options kern_options_of(const kern_options *options)
{
    return options ? *options : kern_defaults();
}

KERN_API kern_options kern_measured_options(const kern_options *options,
                                            kern_real e, kern_real theta)
{
    kern_options o = kern_options_of(options);
    o.pose_error = e > 0 ? e : KERN_R(-1); /* refused by every call */
    o.pose_turn = theta;
    o.gap = KERN_R(1.5) * KERN_ERRORS * e;
    o.angle = kern_max(KERN_ANGLE, 2 * KERN_ERRORS * theta);
    o.angle = kern_min(o.angle, KERN_R(0.99) * KERN_ANGLE_MOST);
    o.overlap = kern_max(o.overlap, KERN_ERROR_OVERLAP * e);
    return o;
}

/* Moves the points of n contacts along their ways by `by`, and turns the edges
   of their cones inward by an angle of tangent `turn`; or, below 0, back. */
static void kern_contacts_err(kern_contact *c, int n, kern_real by,
                              kern_real turn)
{
    for (; n-- > 0; c++) {
        kern_real rate;
        const kern_real shift = kern_shift(c->travel, by, 0, &rate);
        c->p = kern_vec_step(c->p, shift, kern_vec_turn(c->n));
        c->travel -= shift;
        c->mu = kern_max(c->mu - turn, KERN_R(0))
              / kern_max(1 + c->mu * turn, KERN_ANGLE);
    }
}

/* The end of the contacts from i on of one pair of blocks, the block of these
   that they carry, and how wide that bed is, as gravity sees it. */
static int kern_bed_end(const kern_structure *s, int i, int *held,
                        kern_real *wide)
{
    const kern_contact *c = s->contact, *first = c + i;
    kern_real low = KERN_INFINITY, high = -KERN_INFINITY, up = KERN_R(0);
    for (; i < s->contacts && kern_same_blocks(first, c + i); i++) {
        const kern_real at = kern_vec_cross(s->gravity, c[i].p);
        const kern_real lift = -kern_vec_dot(s->gravity, c[i].n);
        low = kern_min(low, at);
        high = kern_max(high, at);
        up += c[i].a == first->a ? lift : -lift;
    }
    *held = up > 0 ? first->b : first->a;
    *wide = up > 0 || up < 0 ? high - low : KERN_R(-1);
    return i;
}

/* Keeps of the contacts those of each block's widest bed. Returns how many. */
static int kern_beds_keep(const kern_structure *s, kern_contact *out,
                          kern_work *work)
{
    kern_real *widest = work->real, wide;
    int *bed = work->index, i, next, held, n = 0;
    for (i = 0; i < s->blocks; i++) {
        widest[i] = KERN_R(-0.5);
        bed[i] = KERN_OUT;
    }
    for (i = 0; i < s->contacts; i = next) {
        next = kern_bed_end(s, i, &held, &wide);
        if (!s->block[held].fixed && wide > widest[held]) {
            widest[held] = wide;
            bed[held] = i;
        }
    }
    for (i = 0; i < s->contacts; i = next) {
        int k;
        next = kern_bed_end(s, i, &held, &wide);
        for (k = i; k < next && bed[held] == i; k++)
            out[n++] = s->contact[k];
    }
    return n;
}

/* Takes the work of a call off the limit: its status, or KERN_LIMIT. */
static kern_status kern_limit_less(kern_task *task, kern_status status)
{
    task->options.limit -= task->work->units;
    task->work->units = status >= KERN_UNDECIDED && task->options.limit == 0;
    return task->work->units ? KERN_LIMIT : status;
}

static kern_status kern_certain_check(const kern_task *task, kern_real margin,
                                      const kern_interval *out,
                                      const kern_contact *contact, int room)
{
    kern_query q;
    const kern_status status = kern_query_check(task, margin, out, &q);
    if (status != KERN_OK)
        return status;
    if (!contact)
        return KERN_BAD_POINTER;
    if (!(task->options.pose_error > 0 && margin >= 0))
        return KERN_BAD_OPTION;
    return task->s.contacts > room || task->work->reals < task->s.blocks
                || task->work->indices < task->s.blocks
             ? KERN_NO_SPACE
             : KERN_OK;
}

KERN_API kern_status kern_certain(const kern_task *task, kern_real margin,
                                  kern_interval *out, kern_contact *contact,
                                  int room)
{
    kern_task other;
    kern_margin m;
    kern_raising raised = KERN_NOT_SHOWN;
    kern_real by, turn;
    kern_status status = kern_certain_check(task, margin, out, contact, room);
    if (status != KERN_OK)
        return status;
    by = KERN_ERRORS * task->options.pose_error;
    turn = KERN_ERROR_EDGE * task->options.pose_turn;
    out->low = KERN_R(0);
    out->high = KERN_INFINITY;
    other = kern_task_of(task->s.block, task->s.blocks, contact,
                         kern_beds_keep(&task->s, contact, task->work),
                         task->work);
    other.s.gravity = task->s.gravity;
    other.options = task->options;
    other.options.limit = kern_limit_of(task->options.limit);
    kern_contacts_err(contact, other.s.contacts, by, turn);
    status = kern_measure(&other, &m, NULL);
    if (status == KERN_STANDS || status == KERN_LIMIT)
        out->low = kern_min(kern_max(m.holds, KERN_R(0)), margin);
    status = kern_limit_less(&other, status);
    if (status == KERN_STANDS && out->low > 0)
        status = kern_limit_less(
            &other, kern_raised(&other, KERN_R(0), &raised, NULL, NULL));
    if (status >= KERN_UNDECIDED) {
        other.options = kern_measured_options(&other.options,
                                              2 * task->options.pose_error,
                                              2 * task->options.pose_turn);
        other.s.contacts = kern_contacts(task->s.block, task->s.blocks,
                                         &other.options, contact, room,
                                         task->work);
        kern_contacts_err(contact, other.s.contacts, -by, -turn);
        status = kern_measure(&other, &m, NULL);
        if (status == KERN_FALLS)
            out->low = out->high = KERN_R(0);
        else if (status == KERN_STANDS || status == KERN_LIMIT)
            out->high = kern_max(m.fails, margin > 0 && !task->options.relative
                                              ? margin + by
                                              : margin);
        if (status >= KERN_UNDECIDED && status != KERN_FALLS)
            status = raised == KERN_RAISED ? KERN_STANDS : KERN_OK;
    }
    task->work->units += kern_limit_of(task->options.limit)
                       - other.options.limit;
    return status;
}

KERN_API kern_options kern_near(const kern_options *options,
                                kern_real mean_size)
{
    kern_options o = kern_options_of(options);
    o.gap = kern_max(o.gap, KERN_NEAR_GAP * mean_size);
    o.angle = kern_max(o.angle, KERN_NEAR_ANGLE);
    return o;
}

#ifdef __cplusplus
}
#endif

#if defined(__GNUC__) && !defined(__clang__) && defined(__FMA__)
#pragma GCC pop_options
#endif

#endif /* KERN_IMPLEMENTED */
#endif /* KERN_IMPLEMENTATION */

/* ==== Part VIII: Sources and changes ===================================== */

/* REFERENCES                                                    >>references

   The paper, with the kern-based measure and Algorithm 1: Y. Liu, M. Saboia, V.
   Thangavelu, N. Napp, Approximate Stability Analysis for Drystacked
   Structures, IEEE/RSJ Int. Conf. Intelligent Robots and Systems (IROS), 2019.

   Limit analysis of masonry: J. Heyman, The stone skeleton, Int. J. Solids
   Struct. 2 (1966) 249; by linear programming: R. K. Livesley, Int. J. Numer.
   Meth. Engng 12 (1978) 1853. Certificates: J. Farkas, J. reine angew. Math.
   124 (1902) 1. Minimum-norm forces: C. L. Lawson, R. J. Hanson, Solving Least
   Squares Problems (1974), ch. 23; O. L. Mangasarian, Optim. Methods Softw. 17
   (2002) 913, for the dual of piecewise constant curvature; S. Mehrotra, SIAM
   J. Optim. 2 (1992) 575, for predictor and corrector. Simplex method: R. G.
   Bland, Math. Oper. Res. 2 (1977) 103, against cycling; R. Fourer, Math.
   Programming 33 (1985) 204, for long steps; G. B. Dantzig, W. Orchard-Hays,
   Math. Tables Aids Comput. 8 (1954) 64, for the product form; E. Hellerman, D.
   Rarick, Math. Programming 1 (1971) 195, for the order of columns. Raised: V.
   Acary, F. Cadoux, C. Lemarechal, J. Malick, ZAMM 91 (2011) 155, for prices as
   a fixed point of minimum-norm forces. Newton's method along a path: W.
   Dinkelbach, Management Science 13 (1967) 492. Outlines: D. H. Douglas, T. K.
   Peucker, Canadian Cartographer 10 (1973) 112.

   CHANGES                                                          >>changes

   Before 1.0 a minor version may add fields at the end of a struct and statuses
   below 0, may need more work memory and may move a margin within its bracket.
   What is in the code of a caller keeps its name and meaning, or no longer
   compiles. A patch version changes no result.

   0.2.0  kern_measured() is kern_measured_options() and has other tolerances,
          options.error and .turn are .pose_error and .pose_turn. kern_certain()
          takes the margin and fills in a kern_interval. kern_known and
          kern_plan have fewer fields. options.limit is 10,000,000, was 0. More
          is refused (>>api). Steps in outlines carry as their chords. New:
          kern_stays(), kern_plan_stays(), kern_raised_load(), options.reserve,
          .lone, KERN_NO_INTERIOR, kern_rest(), kern_place_compare(),
          kern_plan_copy().
   0.1.0  First version. */

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
