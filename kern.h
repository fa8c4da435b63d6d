/* kern.h 0.2.0: how safely does a dry-stacked structure stand?

   A header-only C library for robots that build with found stones and no
   mortar. It finds the contacts between polygons, and contact forces that hold
   every stone. Its measure of stability is the length by which every contact
   can shrink before no such forces exist. Every verdict comes with a proof,
   which kern checks before it returns.

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
                           >>rest >>settle
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

   "Kern" is the word for the shrunk contact in the paper on which this library
   is based (>>references). It does not mean the middle third of a section here.
   If contacts shrink a little more than the margin d*, no contact forces hold
   every stone, unless points can hold the stones, too.

   HOW TO USE IT                                                        >>use

   Define KERN_IMPLEMENTATION in exactly one C or C++ file before including
   kern.h. All other files only include kern.h. The library needs no function of
   the C library but sqrt() (-lm).

       kern_vec ground[4] = {{-5, -1}, {5, -1}, {5, 0}, {-5, 0}};
       kern_vec stone[4]  = {{0, 0}, {2, 0}, {3, 1.5}, {1, 1.5}};
       kern_block block[2];
       kern_contact contact[8];
       kern_real real[KERN_REALS(2, 8)];
       int index[KERN_INTS(2, 8)];
       kern_work work = kern_work_of(real, KERN_REALS(2, 8),
                                     index, KERN_INTS(2, 8));
       kern_task task = kern_task_of(block, 2, contact, 0, &work);
       kern_margin m;

       kern_ground_init(&block[0], ground, 4, NULL);
       kern_block_init(&block[1], stone, 4, 2400, NULL);  // 2400 kg/m^2
       task.s.contacts = kern_contacts(block, 2, &task.options, contact, 8,
                                       &work);
       if (kern_measure(&task, &m, NULL) == KERN_STANDS)
           printf("level %d, margin %g m\n", m.level, m.margin);

   Compare a verdict with == KERN_STANDS: KERN_FALLS is nonzero too.
   If kern_contacts() fails it returns a negative status. A call that gets this
   status as the number of contacts returns it again. examples/copy/one_block.c
   is this program with all checks. If the linker reports "multiple definition",
   KERN_IMPLEMENTATION is in two files. If the linker reports "undefined
   reference", KERN_IMPLEMENTATION is in no file, or only in a file that was
   compiled in the other precision (KERN_SINGLE).

   To ask where a stone can go, keep the structure in a plan (kern_plan_of(),
   kern_plan_add()). A plan answers for one more block without solving the whole
   structure again: kern_plan_try() returns the margin with this block,
   kern_plan_bears() tells whether that margin is at least a given length, and
   kern_plan_stays() returns the chance that the block stays when it is
   released. The arrays of the plan must have room for this block. A chance of
   0.5 is a usual threshold (>>measures). kern_rest() finds where a stone that
   is lowered comes to rest. examples/copy/plan.c and best_place.c use these
   functions.

   CONVENTIONS                                                  >>conventions

   You may use any consistent units of length, mass and time; comments use m, kg
   and s. Angles are in radians, counter-clockwise positive. Blocks are polygons
   in world coordinates of a plane, with a depth of one unit and a density per
   area. Friction is 0.4 and the gap of a contact 1e-3 of a block's size unless
   you set the options (kern_options). Without a plan, add a stone by appending
   the contacts that kern_touch() finds, and remove the last stone by reducing
   the counts `blocks` and `contacts` of the structure.

   MEMORY                                                            >>memory

   The library allocates nothing, has no globals and no recursion, and keeps
   nothing between calls. Threads need no locks if each has its own work memory.
   Work memory is two arrays, of KERN_REALS(blocks, contacts) and of
   KERN_INTS(blocks, contacts) numbers (kern_work_need() at run time).
   `contacts` counts contact points. A wall in running bond has seven contact
   points for each block, or twelve if neighbours in a course touch, too.
   KERN_CONTACTS(blocks) is enough for both. Stones with many short edges may
   need twice as many points; if the array is too short, kern_contacts() returns
   KERN_NO_SPACE. Bytes in double (float: about half):

       blocks and contact points    5, 20    10, 60   30, 140  100, 600
       KERN_REALS and KERN_INTS     9,124    21,496    66,296   359,616
       both KERN_LEAN_ sizes        9,124    12,364    20,204    64,404

   KERN_LEAN_REALS and KERN_LEAN_INTS are smaller from 10 blocks on. For 1000
   blocks and 7000 points they are 0.7 MB instead of 11 MB. These sizes suffice
   if few blocks move in the mechanism at the margin, as in most walls. If many
   blocks move, as in arches, a call with these smaller arrays returns
   KERN_NO_SPACE.

   VERDICTS AND PROOFS                                             >>verdicts

   KERN_STANDS: kern found forces that pass kern_check_forces(). KERN_FALLS:
   kern found a motion that passes kern_check_motion(). These checks are
   independent of the solver. KERN_UNDECIDED: kern found neither such forces nor
   such a motion (>>limits). It never guesses.

   options.limit bounds the work of one call, reading the input included. Work
   that would exceed the limit is not begun: the call returns KERN_LIMIT and
   writes the results that are proven by then. A call that ends below the limit
   gives the same bits as without a limit. On x86-64 a call takes at most 3,000
   instructions plus 2,000 for each unit of its limit. If most blocks have a
   single contact, as in a loose fill that is pushed, it may take 3,100 for each
   unit instead of 2,000 (tests/work.sh limits). A call that completes takes 550
   to 2,000 instructions for each unit in work->units, or 2,230 in such a fill.
   On a desktop computer that is 0.1 to 0.6 microseconds. On a Cortex-M4F a unit
   took up to 2,520 instructions.

   CONFIGURATION                                                     >>config

   KERN_STATIC          makes every function static: the file that includes
                        kern.h then has its own copy of the library
   KERN_API             is the linkage of public functions; default: extern
   KERN_SINGLE          makes kern_real a float; define it in every file that
                        includes kern.h
   KERN_SQRT(x)         replaces sqrt or sqrtf; <math.h> is then not included
   KERN_NO_INTERIOR     leaves out the interior-point method (>>ipm), for
                        firmware. Structures of more than 64 free blocks are
                        then solved by the simplex method, which may take
                        minutes
   KERN_USE_GLPK        lets GLPK (under the GPL) solve large linear programs,
                        through kern_lp.h
   KERN_GLPK_ROWS       GLPK solves programs with more rows than this number;
                        default: 96. A program has three rows for each free
                        block

   Without a C library, compile with -Os -fno-tree-loop-distribute-patterns;
   otherwise gcc inserts calls of memcpy and memset. With -fno-math-errno a
   square root is compiled to one instruction.

   METHOD                                                            >>method

   A structure stands if there are contact forces under which every free block
   is in equilibrium, Eqs. (1) to (3), and which are without tension and within
   friction, Eq. (4). The equations are numbered as in the paper. The weight
   acts at the centre c of the block. Contact point p has the normal n, the
   tangent t, and the force f n + r t:

       sum (f n + r t) + weight = 0,     sum (p - c) x (f n + r t) = 0,
       f >= 0,  |r| <= mu f.

   With forces x along the two edges of each friction cone, which are n + mu t
   and n - mu t, this becomes Eq. (5) (A_eq of the paper, >>statics):

       find x >= 0 with A x = -w.

   If no x exists, Farkas' lemma gives a y with

       y.A >= 0,  y.w > 0.

   This y is a mechanism: velocities and spins with which no two blocks press
   into each other at a contact, and the weights do work. Such a mechanism
   proves that the structure falls.

   A verdict tries these methods in order until one gives a proof:

       top-down     >>pass    balances one block after the other, from top to
         |                    bottom, by three equations each. Blocks that
         |                    cannot be balanced alone are balanced together,
         |                    as a cluster
         |-- every block is balanced ---------------------> STANDS
         |-- some blocks cannot be held, even if all
         |   others are fixed: the simplex method (>>lp)
         |   proves this for these blocks ----------------> FALLS
       whole        >>ipm     solves all blocks at once. More than 64 free
                    >>lp      blocks are solved by the interior-point method
                              or, if it decides nothing, by the simplex method.
                              Up to 64 free blocks are solved by the simplex
                              method. If it decides nothing, the interior-point
                              method follows (in double only)

   A measure is the critical value of a path (kerns shrink, a load grows,
   gravity turns): the first value at which the structure falls. Fixing blocks
   never lowers the critical value, so any part, with all other blocks fixed,
   gives an upper bound. A body is a block together with the blocks that rest on
   it alone, directly or through others. The search (>>search) begins at the
   smallest of the critical values of all bodies. There it runs the top-down
   pass. If a part falls, the search continues at
   the critical value of that part, until no part falls. If the pass gives no
   proof, the search solves the whole structure. For up to 64 free blocks, load
   factor and tilt are computed by one linear program in which the critical
   value is a variable. If that program cannot decide, as in jams, the
   interior-point method narrows the bracket of the critical value, which has a
   proof at each end. tests/DESIGN.md says why each step is there, and what it
   costs to leave it out.

   RULES                                                               >>rules

   This chapter defines each number exactly, so that another program can
   reproduce it. The table RULES in tests/kern_test.c names the tests of each
   rule.

   Contacts are found for each pair of polygons that are not both fixed. `gap`
   and `angle` are fields of kern_options. No tolerance is below 64 times the
   machine epsilon times the largest coordinate. "Size" is the size of the
   pair's smaller free block: the square root of its area. Vertices at which the
   outline turns by less than 1e-6 rad are ignored. Each remaining edge has its
   own contacts, even a step of one pixel, so simplify raw outlines first
   (kern_outline_simplify()).
     line      Two edges, one of each block, make a line contact if they are
               antiparallel within `angle`. They must also be within the gap of
               each other over a stretch that is longer than the least of three
               lengths: the gap, 1e-3 of the size, half of the longer edge. The
               contact points are the ends of the stretch, midway between the
               edges. n is the mean of the edges' normals.
     point     A convex vertex makes a point contact with an edge if it is
               within the gap of the edge. The foot of the perpendicular from
               the vertex to the edge must be more than 1e-6 of the size from
               both ends of the edge. Both edges that meet at the vertex must be
               on the outer side of the edge that it touches, within `angle`.
               The contact point is the vertex, and n is the normal of the edge.
               There is no point contact if a line contact of the pair passes
               within the gap and its normal is within 10 degrees of n.
     corner    A convex vertex that is within the gap of a reflex vertex makes a
               point contact with each of the two edges of the reflex vertex.
               Both edges of the convex vertex must be on the outer side of
               these two edges. Two convex vertices make no contact.
     face      Contacts of a pair are joined to one line contact if their
               normals agree within `angle` and they lie on one line within the
               gap. The line contact goes from the first to the last of their
               points. n is the mean of their normals, weighted by length.
               Contacts are joined in the order of their lengths, the longest
               first and points last.
     overlap   The deepest overlap that is allowed is the larger of the gap and
               options.overlap. KERN_OVERLAP is returned if a point of one
               outline is deeper inside the other block than that, if a block is
               inside another, if two edges cross and all four of their ends are
               farther than that from the other edge's line, or if two convex
               blocks cannot be separated by a motion as short as that.
   A larger gap never removes a support. Contacts that the caller makes are used
   as they are, with unit normals. A line contact whose direction differs from t
   by more than `angle` is refused.

   Shrinkage. As kerns shrink, a contact point moves in a direction u = t or -t,
   by at most its travel l >= 0, which is the magnitude of kern_contact.travel:
     line      The two ends move toward each other; l is half the length.
     points    Two or more points of one pair move toward the middle q of the
               two that are farthest apart, each along its own t. Their travel
               is l = |(q - p) . t|.
     one point The only point contact of a pair does not move, even if the pair
               has line contacts, too: l = 0. A point with l below 1e-9 of the
               mean size does not move either.
     lone      If options.lone is set, a single point of a pair moves toward the
               middle of the contacts that carry its block, as in Fig. 2 c, d of
               the paper. A contact carries the block that its normal pushes up,
               or none if the normal is horizontal within 1e-6. The middle is
               the midpoint of the two contact points that carry the block and
               are farthest apart. Kerns are then not nested (>>limits).
   At a shrinkage d the point acts at p + min(d, l) u, or with options.relative
   at p + d l u, d <= 1. d_max is the largest l (relative: 1). Normals do not
   change. If all contacts are lines, kerns are nested: a structure that falls
   at one d falls at every larger d. With points of different normals a
   structure may stand again at a larger d.

   Measures, for a structure that stands at d = 0 unless said otherwise:
     level     The smallest k >= 1 such that the structure falls at min(k
               epsilon, d_max). If there is no such k, the level is ceil(d_max /
               epsilon) + 1 and the margin is saturated. The level is 0 if the
               structure falls at d = 0.
     margin    The largest d* such that the structure stands at every d below
               d*. If the structure stands at every d, the margin is d_max and
               is saturated.
     deficit   For a structure that falls at d = 0: the least growth d at which
               it stands with contact points at p - d u (relative: p - d l u).
               The deficit is infinite if the structure still falls at a growth
               of L, which is 1000 times the longest side of the box around the
               free blocks (relative: L divided by the smallest l).
     load      The load is a pattern of forces and torques, or a horizontal load
     factor    of m |g| at every centre, to the right (gravity turned by +90
               degrees) or to the left. The load factor is the largest factor F
               such that the structure stands under the load times every factor
               up to F.
     tilt      The first angle at which the structure falls when gravity turns
               to the side, or pi if it falls at no angle. Loads of blocks do
               not turn with gravity.
     profile   d grows from 0. When the structure falls, the blocks that move in
               the mechanism get the present d as their value and are removed,
               and d continues to grow. A block that never moves gets d_max, and
               a block that moves at d = 0 gets 0. For a horizontal load the
               factor grows instead of d, up to 10. If there are several
               mechanisms, one that moves few blocks is preferred.
     mechanism For a structure that falls: the velocities of all free blocks
               when it begins to fall, scaled so that the largest is 1. A spin
               counts as spin times the size of its block.

   WHAT EACH NUMBER IS GOOD FOR                                    >>measures

   margin      compares structures, and places for a stone. The margin is the
               distance of the force on the worst stone from the edge of its
               support. It is a length, so large stones count more. With
               options.relative it is a share of half the length of a contact
   level       is the paper's measure: the first step of length epsilon at
               which the structure falls
   load factor is the largest sideways acceleration that the structure bears, in
               units of gravity
   raised load is the load factor for a load that grows from 0 on blocks that
               slide without moving apart (kern_raised_load()). The load factor
               supposes that they move apart (>>limits)
   tilt        tells how far the ground may tilt before the structure falls.
               Without loads it is the arc tangent of the load factor, if that
               is finite
   deficit     tells how far the contacts of a structure that falls must grow
               until it stands
   bearing     is the length of the shortest contact that the structure needs
   mechanism   is how the stones move first, with the velocity of each
   profile     gives the margin or load factor at which each stone falls, while
               the stones that fall before it are removed. Gives also the mean
               of these values, the mean of their lower half, and the expected
               drop
   raised      takes each contact as a stiff spring with friction that is
               unstressed at first, and tells whether the load presses the
               blocks together so that forces arise ("are raised") that hold the
               structure. The reserve tells how large a push the structure bears
               in addition
   stays       is the chance that a stone stays where it is released
   rest        finds where a stone comes to rest, and compares places
               (kern_rest(), kern_place_compare(), examples/place.c)
   sensitivity tells how to move a stone for a larger margin, and how exactly it
               must lie (examples/nudge.c)
   push        is the load factor of a force on one stone (examples/push.c)

   The margin does not show that a support is very short. A contact shrinks to a
   point, and a point still carries: if one end of a stone rests on a contact of
   2 micrometres, the margin is that of the other end. The bearing length
   (kern_bearing()) shows such a short support. A robot that misplaces stones by
   more than the bearing length cannot rely on the shortest contact. Compute the
   bearing length with the contacts of kern_stretches(), since kern_contacts()
   makes one contact of the two feet of a block, from the outer end of one foot
   to that of the other. A saturated margin is half the length of the longest
   contact and says nothing about safety.

   Collapse under shaking. Every measure but the profile says when the first
   stone falls, not when half of a wall falls. A stone that rocks soon meets the
   next one, so include contacts that a slight motion closes:

       task.options = kern_near(&task.options, kern_mean_size(block, blocks));
       find the contacts with these options, then call
       kern_profile(&task, side, value, &c) for KERN_LEFT and for KERN_RIGHT,
       and add the two values of c.drop, the expected drop

   A larger sum is worse. This sum ranks structures by the shaking at which they
   collapse, and does so better than any other measure (README;
   examples/laboratory/STUDY.md). Where stones slide before they tip, as in low
   walls, no load factor exceeds mu, so load factors rank less well. Do not use
   the contacts of kern_near() for a verdict: a gap carries nothing until it is
   closed.

   Whether a stone stays where it is released. kern_stays() returns the chance.
   Suppose that a planner releases a stone if the chance is at least a
   threshold. Of 969 placements 835 are clear: they stay, or they move, in all
   of six noisy runs of a simulator. The table gives shares of these 835. They
   were split in two halves, and the chances of each half follow from the law
   that was fitted to the other half:

       threshold                       0.3    0.5    0.7    0.9
       630 that stay: released         0.96   0.95   0.93   0.83
       205 that move: not released     0.90   0.96   0.985  0.995

   The chance is computed from the distance by which stones press into their
   contacts until the forces hold them, and from the reserve (kern_raised()).
   The larger that distance, the more equilibria are possible. Friction decides
   which of them is reached.

   Whether a finished structure stays. kern_let_go() releases all blocks at
   once, so the order of the blocks does not matter. kern_least_load_of() and
   kern_load_factor_of() return the least and the largest factor of a load with
   which the structure stands.

   Forces. Many sets of forces can hold a structure. No measure depends on the
   choice of a set, and a proof contains the first set that was found. For
   pictures use the minimum-norm forces (kern_forces()). This set is unique, is
   symmetric if the structure is, and loads every contact that can carry. The
   forces of kern_raised() are closer to real friction, but not unique. Neither
   set tells how elastic stones share a load.

   STONES FROM A CAMERA OR A SCANNER                               >>measured

   Outline. Simplify each outline first, within 1.5 to 3 pixels
   (kern_outline_simplify()). Raw points on a grid touch each other
   (KERN_CROSSING), and each step of one pixel would hold like a shear key. With
   a tolerance of 1.5 pixels or more a straight joint becomes one edge; with
   less than 1.42 pixels its steps may remain. Simplification may open gaps as
   wide as twice its tolerance. Set options.gap to that width, or include it in
   the error of kern_measured_options(). Outlines from drawings and from polygon
   clipping have tiny steps that come from rounding: simplify them with a
   tolerance of half of options.gap. The density is that of the material times
   the thickness. examples/copy/contour.c shows these steps.

   Error. kern_measured_options() takes the standard errors of a stone's place
   and of its angle. To combine the errors of pixel, simplification and
   registration, take the square root of the sum of their squares. With these
   options margins of a stone with 40, 200 or 1000 vertices agree within 2 %;
   without them margins depend on the number of vertices. Overlaps beyond the
   error (kern_overlaps()) are modelling errors: measure again, or set
   options.overlap.

   Certainty. The poses of a structure at rest are measured with errors. The
   measured stones therefore lie a little apart or inside each other, and must
   settle by a few errors before they rest. kern_certain() computes this
   settling. It returns a lower and an upper end of the margin, whether the
   verdict is called certain, and how far stones may settle. A stretch is a
   contact, or a part of a contact between hollows (kern_stretches()). The
   verdict KERN_STANDS is called certain if the structure passes the tests of
   kern_certain(). For example, it must stand on the stretches that are longer
   than the errors, and it must come to rest again after a small motion if every
   third stretch is supposed not to touch. tests/TRUST.md tells how often these
   answers are right, and which structures they overlook.

   LIMITS                                                            >>limits

   Model     The model is plane and static, and its blocks are rigid and do not
             break. "Stands" means that admissible forces exist. With friction
             that is necessary for standing still, but not sufficient: a cube
             held between two walls by friction alone counts as standing.
             kern_raised() tells whether the load raises such forces.
   Unsafe    Mechanisms are those of limit analysis: blocks that slide also move
             apart (dilatant sliding). If a wall slides in its own joints, load
             factor and tilt are too high. Compared with a simulator they were
             too high by 11 to 26 % on four published brick walls with openings
             (tests/PUBLISHED.md), by a factor of up to 2.5 on random brick
             walls, and never on settled rubble. A toppling slope is a row of
             columns on a stepped base. Goodman and Bray (1976) compute what
             holds it column by column (below: limit equilibrium). For 90 such
             rows the load factor was up to 3.1 times too high
             (tests/TRUST.md). The least friction at which the verdict is
             "stands" is up to 31 % too low for such rows. If the tops of the
             columns rise at the slope of the base, the error has no bound: one
             load factor was 100 times too high, and one verdict was "stands"
             with a friction of .44 where 2.07 is needed.
             kern_raised_load() has no dilatancy. kern_let_go() tells whether
             such a row stays: it returned KERN_STANDS for none of 360 toppling
             slopes with .9 and .99 of the friction that limit equilibrium
             needs. kern_raised_load() and kern_let_go() follow one path of
             loading. If these or other functions disagree, rely on the less
             favourable answer. For a flat arch with hanging bricks
             kern_raised() never returns KERN_RAISED, although the arch may
             stay.
   Search    KERN_NOT_SHOWN is no proof of falling. kern_work.end tells whether
             the search found no equilibrium or was ended by a limit of work.
             The raised load of 90 rows of 20 to 90 columns is at least 87 % of
             that of limit equilibrium, and at least 97 % for 75 of them. The
             raised load is at least 97 % of that of limit equilibrium for 326
             of 360 slopes within 10 % of critical friction. For one of these
             slopes kern_raised() returns KERN_NOT_SHOWN. Near critical
             friction, or if a structure has several equilibria close to each
             other, the raised load may change when the input is turned,
             mirrored or rounded. The raised load changed by more than 2 % for
             28 of these 360 slopes, and for 13 of 969 placements, 10 of which
             move in the simulator.
   Ambiguous The reserve does not cover equilibria that depend on the history of
   forces    loading. 181 rows of wedges between cliffs fall in a simulator,
             although forces exist that hold them. Two of these rows have a
             reserve of 0.1 g, the largest that kern_raised() tries
             (tests/TRUST.md). If a stone is pushed out from under a longer one,
             the forces that hold it may need the weight of the longer stone,
             and this weight can shift to other supports. Of 51 such walls under
             .6 to .9 of their raised load, 7 move in a simulator.
   Loads     Loads of kern_block_load() neither grow with a horizontal load nor
             turn with gravity.
   Not       If kerns are not nested (points of different normals), the path
   nested    is first searched without these points. If the value that is found
             does not hold with these points, the path is searched in steps of
             at most d_max / 1001. Tilts with loads are searched in steps of pi
             / 1001. An interval in which the structure falls may be missed if
             it is narrower than a step.
   Undecided A verdict may be undecided if the shrinkage is closer than 1e-9
             mean sizes to the critical value. In jams, whose forces grow
             without bound toward the critical value, this distance may be 1e-7,
             and rarely 1e-4. It may be larger if one block weighs more than 1e4
             times another. Among 800 hoppers, rows between walls, zigzag beds
             and packed discs of up to 120 stones, four measures were undecided,
             and among rows of skew stones between walls one of twenty. The
             brackets of these measures were 1e-4 to 1e-2 mean sizes wide. In a
             jam a proof of standing and a proof of falling may overlap: a
             structure may be proven to stand at one shrinkage and to fall at
             another that is smaller by up to 1e-6. The reason is that the two
             proofs bound the forces by different weights (>>proof). Of
             structures of bricks that are held by loads up to 1000 times their
             weight, none of 288 was undecided with mu up to 100, and 2 of 96
             with mu 1000. A level is undecided only if it depends on an
             undecided verdict.
   Brackets  Brackets are at most 2e-6 mean sizes wide (load factor 2e-6, tilt
             8e-6 rad), in jams up to 50 times as wide, and up to 3e-5 if there
             are more than 256 blocks and many of them move at once. If more
             than 64 blocks move at once, the returned value may differ from the
             true one by the width of the bracket.
   Slow      Structures in which many blocks move at the margin take long:
             ragged walls, fitted masonry, long arches (tests/BENCH.md).
   Float     Proofs are weaker (>>tune), and more verdicts near critical are
             undecided. A deficit is exact to 3e-6 sizes. For more than 64
             blocks a margin may be wrong by 0.05 mean sizes, and another
             measure by 0.05. If wedges jam, a margin may be wrong by 1/3 size.
             Choose coordinates close to the origin.

   DETERMINISM                                                  >>determinism

   The same input gives the same bits on every machine if the compiler follows
   IEEE arithmetic. Flags:

       -ffp-contract=off     is needed if the target has fused multiply-add
                             (AArch64, PowerPC, s390x, x86 with -mfma). Without
                             it gcc (in GNU modes) and clang (from version 14)
                             fuse products and sums
       -fno-tree-vectorize   is needed, too, if gcc compiles for a target with
                             fused multiply-add for vectors: gcc fuses pairs of
                             products despite the first option. On x86 kern.h
                             sets this option for its own code
       -msse2 -mfpmath=sse   are needed on 32-bit x86
       never -ffast-math, -Ofast or -funsafe-math-optimizations, not even when
                             the program is linked: they flush small numbers to
                             0

   kern uses only + - * / and square root, which must round as IEEE 754
   requires. On ARM without a unit for doubles, sums of doubles are computed by
   libgcc, which does not always round so. tests/golden.c detects wrong
   flags. */

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
/* Gives public functions other names in float. If two files of a program
   disagree about the precision, the linker then reports an error; otherwise the
   program would fail only when it runs. One program may also use both
   precisions. */
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
#define kern_least_load_of kern_least_load_of_f32
#define kern_let_go kern_let_go_f32
#define kern_load_factor kern_load_factor_f32
#define kern_load_factor_of kern_load_factor_of_f32
#define kern_lp_solve kern_lp_solve_f32
#define kern_mean_size kern_mean_size_f32
#define kern_measure kern_measure_f32
#define kern_near kern_near_f32
#define kern_measured_options kern_measured_options_f32
#define kern_certain kern_certain_f32
#define kern_stretches kern_stretches_f32
#define kern_overlaps kern_overlaps_f32
#define kern_outline_simplify kern_outline_simplify_f32
#define kern_place_compare kern_place_compare_f32
#define kern_plan_add kern_plan_add_f32
#define kern_plan_bears kern_plan_bears_f32
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

/* Result of a call. A positive status is a verdict or the result of a linear
   program. KERN_OK means success of a function that has neither a verdict nor
   such a result. A negative status means failure. A failed call has changed no
   data of the caller except the counters and the fault in the work memory, and
   after KERN_LIMIT the results that the comment of the function names. */
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
    X(KERN_NO_REST, -25, "the stone still moves after the most motions")

typedef enum kern_status {
#define KERN_STATUS_NAME(name, value, text) name = value,
    KERN_STATUS_LIST(KERN_STATUS_NAME)
#undef KERN_STATUS_NAME
        KERN_STATUS_LEAST = -25 /* least value of a status */
} kern_status;

/* Where the fault of a negative status lies. */
typedef struct kern_fault {
    int block;         /* index of the block at fault; -1: none             */
    int other;         /* the other block of an overlap; -1: none           */
    int index;         /* index of the vertex or contact point, or for
                          kern_lp_solve() of the number in a, then rhs, then
                          cost; -1: none                                    */
    kern_real value;   /* the overlap is at least this deep [m]; for
                          kern_lp_solve() the number that is not finite; 0:
                          neither                                           */
    kern_real allowed; /* deepest overlap that is allowed [m]; 0: the fault is
                          no overlap                                        */
} kern_fault;

/* A force [N] and a counter-clockwise torque [N m] about a centre of mass. */
typedef struct kern_wrench {
    kern_real fx, fy, torque;
} kern_wrench;

/* A stone or the ground, made by kern_block_init() or kern_ground_init(). Mass,
   centre and load may change later. */
typedef struct kern_block {
    const kern_vec *vertex; /* simple polygon in an array of the caller [m];
                               NULL: the block has no polygon                 */
    int vertices;           /* >= 3; 0 if vertex is NULL; -1 if the block was
                               refused when it was made                       */
    int fixed;              /* nonzero: ground; it bears any force and rests  */
    kern_real area;         /* area of the polygon [m^2], negative if its
                               vertices turn clockwise. The "size" of a block
                               is sqrt(|area|)                                */
    kern_box box;           /* bounds of the polygon; not read if vertex is
                               NULL                                           */
    kern_real mass;         /* mass [kg], above 0; not read if the block is
                               fixed                                          */
    kern_vec centre;        /* centre of mass [m]                             */
    kern_wrench load;       /* force [N] at the centre and torque [N m] that act
                               in addition to the weight                      */
} kern_block;

/* A contact point. The force  f n + r t  acts at p on block b, and the opposite
   force on block a, with t = (-n.y, n.x). A line contact is two points that are
   neighbours in the array. Equilibrium depends only on the points: the ends of
   a line act like any two points. */
typedef struct kern_contact {
    int a, b;         /* indices of the two blocks, a != b                */
    int line;         /* nonzero: one end of a line contact               */
    kern_vec p;       /* place of the contact point [m]                   */
    kern_vec n;       /* unit normal from a into b                        */
    kern_real mu;     /* coefficient of friction >= 0                     */
    kern_real travel; /* signed distance along t to the closed kern [m]   */
} kern_contact;

/* Two blocks that overlap deeper than the options allow. */
typedef struct kern_overlap {
    int a, b;          /* indices of the two blocks, a < b                 */
    kern_real depth;   /* depth of the overlap [m], at most 1/8 too small  */
    kern_real allowed; /* deepest overlap that would be a contact [m]      */
} kern_overlap;

typedef struct kern_structure {
    const kern_block *block;
    int blocks;
    const kern_contact *contact;
    int contacts;     /* number of contact points                         */
    kern_vec gravity; /* acceleration of gravity [m/s^2], on Earth (0,
                         -9.81)                                           */
} kern_structure;

typedef struct kern_options { /* start from kern_defaults(): the default of a
                                 field is 0 unless its comment names another  */
    kern_real mu;         /* coefficient of friction that is given to contacts
                             when they are found; default 0.4                 */
    kern_real gap;        /* widest gap that is a contact [m]; 0: 1e-3 of the
                             size of the pair's smaller free block            */
    kern_real angle;      /* widest angle between touching edges [rad], < 0.5;
                             default 0.0174533                                */
    kern_real epsilon;    /* step of a level in Algorithm 1 [m; relative: share
                             of the travel]; 0: 0.02 mean sizes [relative:
                             0.05]                                            */
    int relative;         /* nonzero: shrinkage is a share of each travel     */
    int limit;            /* most units of work of one call (>>verdicts);
                             default 10,000,000, at most 2e9; 0 means 2e9     */
    kern_real overlap;    /* deepest overlap that is still a contact [m]; 0:
                             as deep as the gap                               */
    kern_real pose_error; /* standard error of the places of blocks [m], set by
                             kern_measured_options(); 0: places are exact     */
    kern_real pose_turn;  /* standard error of the angles of blocks [rad], set
                             by kern_measured_options(); 0: angles are exact  */
    kern_real narrow;     /* rate at which friction cones narrow as kerns shrink
                             [1/m; relative: 1]: kern_measure()               */
    kern_real reserve;    /* largest push that kern_raised() tries, in shares of
                             gravity, at most 0.1; 0: 0.1                     */
    kern_vec lone;        /* if not (0, 0): the direction of gravity, of any
                             length; then a contact point moves, too, if it is
                             the only one of its two blocks (>>rules)         */
} kern_options;

/* The force at a contact point [N], along n and t. */
typedef struct kern_force {
    kern_real normal, tangential;
} kern_force;
/* The velocity of a block's centre, and its spin. */
typedef struct kern_motion {
    kern_real vx, vy, spin;
} kern_motion;

/* Arrays of the caller for a proof. Each may be NULL. Measures also use these
   arrays for intermediate results, so after a negative status their contents
   mean nothing. */
typedef struct kern_proof {
    kern_force *force;   /* one per contact point, written with KERN_STANDS  */
    kern_motion *motion; /* one per block, written with KERN_FALLS; 0 for
                            fixed blocks                                     */
} kern_proof;

/* Result of kern_measure(): margin and level, with the bracket of the margin.
   Shrinkages are in metres, or with options.relative shares of the travel. */
typedef struct kern_margin {
    kern_real margin;  /* d*: the structure stands at every smaller shrinkage */
    kern_real holds;   /* largest shrinkage at which it is proven to stand    */
    kern_real fails;   /* smallest shrinkage at which it is proven to fall, or
                          `most` if there is none                             */
    kern_real most;    /* d_max: shrinkage at which every kern is closed;
                          relative: 1                                         */
    kern_real epsilon; /* step of Algorithm 1 that was used                   */
    int level;         /* level of Algorithm 1; -1: a verdict that it needs is
                          missing                                             */
    int saturated;     /* nonzero: it stands even with every kern closed      */
} kern_margin;

/* Result of kern_certain(): an interval of the margin of a measured structure
   [m; relative: 1]. */
typedef struct kern_interval {
    kern_real low;     /* lower end; 0: none is known                     */
    kern_real high;    /* upper end; 0: it falls; KERN_INFINITY: unknown  */
    kern_real settles; /* how far its blocks may move as they settle [m];
                          KERN_INFINITY: unknown, or too far              */
} kern_interval;

/* Derivatives of the margin with respect to the data of a contact point: `p` to
   its place, `turn` to the angle of its normal [m/rad], `mu` to its friction,
   and `travel` to its travel. `travel` is 0 unless the kern of the point is
   closed or options.relative is set. */
typedef struct kern_contact_rate {
    kern_vec p;
    kern_real turn, mu, travel;
} kern_contact_rate;

/* Derivatives of the margin with respect to the data of a block. `centre` moves
   the centre of mass alone. `place` moves the block, and `turn` turns it about
   its centre: the contacts then move to where the search would find them, and
   the loads do not change. */
typedef struct kern_block_rate {
    kern_vec centre, place;
    kern_real turn, mass; /* turn [m/rad], mass [m/kg]            */
    kern_wrench load;     /* forces [m/N], torque [1/N]           */
} kern_block_rate;

/* Result of kern_raised(). */
typedef enum kern_raising {
    KERN_NOT_SHOWN, /* neither KERN_RAISED nor KERN_HANGS is shown. This is no
                       proof of falling                                 */
    KERN_RAISED,    /* the load raises forces that hold the structure   */
    KERN_HANGS      /* some blocks rest on nothing; the others stand without
                       them                                             */
} kern_raising;

/* Why a search for forces that the load raises ended (kern_work.end). */
typedef enum kern_end {
    KERN_END_NONE,  /* no search has run                              */
    KERN_END_SHOWN, /* forces were found; for kern_raised_load(): at the
                       load factor                                    */
    KERN_END_LOST,  /* no equilibrium was found: blocks move away, or the search
                       makes no progress                              */
    KERN_END_WORK   /* a limit of work was reached                    */
} kern_end;

/* A profile in four numbers. The values are the margins [m] or the load factors
   of the free blocks. */
typedef struct kern_collapse {
    kern_real least; /* smallest value: the margin or the load factor    */
    kern_real mean;  /* mean of all values: the margin or load factor of
                        progressive collapse                             */
    kern_real weak;  /* mean of the lower half of the values             */
    kern_real drop;  /* expected drop: mean of h exp(-value / 0.07), where h is
                             the height of the centre above the lowest block in
                             mean sizes, at least 0.3. The drop is 0 if the
                             values are margins                          */
} kern_collapse;

/* Motion of the two blocks at a contact point. */
typedef enum kern_meeting {
    KERN_RESTS,  /* the blocks move as one body, or not at all       */
    KERN_HINGES, /* the blocks turn relative to each other about the point */
    KERN_SLIDES, /* the blocks slide on each other, and move apart at the
                    friction angle (dilatancy: >>limits)             */
    KERN_OPENS   /* the blocks move apart                            */
} kern_meeting;

/* Result of kern_critical_of(): the contacts that limit a measure, and the
   blocks that move. The arrays are the caller's, and each may be NULL. */
typedef struct kern_critical {
    kern_meeting *meeting; /* per contact point: how its two blocks move      */
    kern_real *limit;      /* per contact point: how much it limits the measure
                              (kern_critical_of()), divided by the same number
                              of point `contact`; up to 1.0001                */
    int *group;            /* per block: the number of its group, whose blocks
                              move as one body; 0: the fastest group; -1: the
                              block rests                                     */
    int contact; /* index of the point with the largest limit, the first of
                    those that are equal to 1e-4; -1: none                    */
    int groups;  /* number of groups; 0 if `group` is NULL                    */
} kern_critical;

/* Work memory: two arrays of the caller. Nothing in them needs to be set. */
typedef struct kern_work {
    kern_real *real;
    int reals; /* length of `real`: KERN_REALS(blocks, contacts)   */
    int *index;
    int indices; /* length of `index`: KERN_INTS(blocks, contacts)   */
    /* counters: the library adds to them, the caller may set them to 0       */
    int pivots;       /* number of pivots of the simplex method           */
    int solves;       /* number of top-down passes and of linear programs
                         that were solved                                 */
    int units;        /* work of the last call, not counting the search of a
                         plan for contacts; limit + 1 after KERN_LIMIT    */
    kern_real error;  /* largest error of a proof so far, as a share of the
                         allowed error: at most 1                         */
    kern_fault fault; /* fault of the last call with a negative status    */
    kern_end end;     /* why the last search for raised forces ended      */
} kern_work;

/* Warm start: results of kern_measure() that speed up the next call for a
   similar structure. Measures use the bracket and the motion. kern_plan_*() and
   kern_stays() also use the forces. The caller provides both arrays or neither.
   Their contents are verified before use: they change the time of an answer,
   not the answer. */
typedef struct kern_known {
    kern_motion *motion; /* one per block: the mechanism at `fails`           */
    kern_force *force;   /* one per contact point: the forces at `holds`      */
    kern_real holds, margin, fails; /* results of the last kern_measure();
                                       fails = 0: there are none              */
} kern_known;

/* Arguments of a call, from kern_task_of(). Fields may be changed between
   calls. */
typedef struct kern_task {
    kern_structure s;
    kern_options options; /* at first kern_defaults()                         */
    kern_work *work;      /* work memory; not NULL                            */
    kern_known known;     /* warm start; none if its arrays are NULL          */
} kern_task;

/* A structure that a planner changes by one block at a time; kern_plan_of()
   makes it. Set task.options and task.s.gravity before you add blocks. You may
   append contacts of your own: write them to contact[task.s.contacts] and later
   places of the array, and raise task.s.contacts. */
typedef struct kern_plan {
    kern_task task;    /* the present structure                            */
    kern_block *block; /* the caller's array, which task.s reads           */
    int block_room;    /* length of the array `block`                      */
    kern_contact *contact; /* the caller's array, which task.s reads       */
    int contact_room;      /* length of the array `contact`                */
} kern_plan;

/* Where a stone comes to rest: kern_rest(). */
typedef struct kern_pose {
    kern_block block; /* the stone at rest, with vertices of its own   */
    kern_vec turn;    /* cosine and sine of the angle by which the stone has
                         been turned                                   */
    int motions;      /* number of motions until rest, counting the first
                         one straight down                             */
} kern_pose;

/* A place for a stone, and the numbers by which kern_place_compare() ranks it.
   A number that was not computed must be the same in all places, such as 0. */
typedef struct kern_place {
    kern_real stays;   /* chance that the stone stays: kern_plan_stays()  */
    kern_real margin;  /* margin with the stone added: kern_plan_try()    */
    kern_real own;     /* the stone's value in a profile: kern_profile()  */
    kern_real load;    /* the least load factor: kern_load_factor()       */
    kern_real x, turn; /* the stone's position and angle, in any units    */
} kern_place;

/* Sides of a horizontal load or tilt: right is +x for gravity (0, -9.81). */
typedef enum kern_side {
    KERN_LEFT = -1,
    KERN_SHRINK = 0, /* only for kern_profile(): kerns shrink, and no load
                        grows                                            */
    KERN_RIGHT = 1
} kern_side;

/* A linear program:  minimise cost . x  where  A x = rhs  and  x >= 0. */
typedef struct kern_lp {
    int rows, cols;
    const kern_real *a;    /* matrix A: rows x cols numbers, by columns       */
    const kern_real *rhs;  /* right-hand side: one number per row             */
    const kern_real *cost; /* one number per column; NULL: any solution will
                              do                                              */
    int limit;             /* most units of work, as in kern_options          */
} kern_lp;
/* Infinity. Other compilers than gcc and clang compute it by a product that
   overflows. */
#if defined(__GNUC__) && defined(KERN_SINGLE)
#define KERN_INFINITY __builtin_inff()
#elif defined(__GNUC__)
#define KERN_INFINITY __builtin_inf()
#else
#define KERN_INFINITY ((kern_real)(1e300 * 1e300))
#endif

/* ---- Sizes ------------------------------------------------------- >>sizes */
/* Constant expressions (>>memory). Blocks include fixed ones. KERN_ROOM is the
   number of reals for the factors of a basis (>>lp) of a structure, and
   KERN_LP_ROOM for those of a dense program. KERN_ROOM grows with the square of
   `extras` up to 458, which is KERN_EXTRAS of 300 blocks, and beyond that along
   the tangent of the square. If this room is full, the basis is factored again.
   If it is full after that, as may happen for large structures near critical,
   the call returns KERN_NO_SPACE. The lean sizes have room for parts of
   KERN_LEAN_PART blocks. */
#define KERN_CONTACTS(blocks) (12 * (blocks) + 16)
#define KERN_EXTRAS(blocks) ((blocks) < 4 ? 3 * (blocks) : 3 * (blocks) / 2 + 8)
#define KERN_LEAN_EXTRAS(blocks) \
    ((blocks) < 10 ? KERN_EXTRAS(blocks) : (blocks) / 2 + 2)
#define KERN_ROOM(extras) \
    ((extras) < 458 ? (extras) * ((extras) + 5) : (extras)*921 - 458 * 458)
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
/* In the comments below, B is the number of blocks and C the number of contact
   points. No pointer may be NULL unless the comment of the function says so;
   otherwise the function returns KERN_BAD_POINTER. Every function that takes
   work memory may return KERN_NO_SPACE. Every function that takes a structure
   may return KERN_BAD_POINTER, _NUMBER, _COUNT (blocks up to 20,000, contacts
   up to 1,000,000), _MASS, _FRICTION, _OPTION, _BLOCK, _NORMAL, _SHARE (a
   relative shrinkage above 1), KERN_SAME_BLOCK, KERN_NO_BLOCK, KERN_NO_AREA,
   KERN_NO_FREE, KERN_NO_LOAD and KERN_LIMIT. A number of contacts below -1 is a
   status of kern_contacts(): every function returns this status and keeps its
   fault in the work memory. After KERN_LIMIT a measure is the largest value at
   which the structure is proven to stand so far, or negative if there is none.

   Numbers that cannot be squared or multiplied safely are refused, and the
   fault names the block. With F = 1e60 (float: 1e10) the bounds are
     KERN_BAD_MASS    a mass outside [1 / F, F] [kg]
     KERN_NO_AREA     an area below 1 / F^2 [m^2]
     KERN_BAD_NUMBER  an area above F^2 [m^2]; an option, vertex, centre, place
                      or travel above F [m]; a wrench of a pattern above F; the
                      sum of weight and load of a block above F [N], or below 1
                      / F [N] and not 0 */

/* Returns the meaning of a status in words. If a function that returns a count
   returns a negative number, that number is a status, too. */
KERN_API const char *kern_status_text(int status);

/* Returns the default options. The comments of kern_options name them. */
KERN_API kern_options kern_defaults(void);

/* Returns *options (NULL: the defaults) with a gap of at least 4 % of the mean
   size [m] and an angle of at least 0.15 rad. With these options
   kern_contacts() also finds contacts that a slight rocking motion would
   close. */
KERN_API kern_options kern_near(const kern_options *options,
                                kern_real mean_size);

/* Returns options for measured structures (>>measured), from *options (NULL:
   the defaults). e is the standard error of a stone's place [m], theta that of
   its angle [rad]. The vertices are assumed to be exact to e / 2 relative to
   their stone. Sets
     gap      5.25 e, to which 1e-3 of the size is added. At a contact at
              distances r_a and r_b from the centres of its blocks the gap g
              becomes sqrt(g^2 + (3.5 theta)^2 (r_a^2 + r_b^2)) (>>tol)
     angle    7 theta, at least 1 degree and below 0.5 rad. A corner may lie 3 e
              beyond the end of an edge
     overlap  8 e, or options->overlap if that is larger. To this 3.5 theta r
              is added for each pair, where r is the diagonal of the smaller of
              its two boxes. Contacts of blocks that overlap lie at half the
              depth of the overlap, inside both blocks. No contact lies where
              one block has passed through a thin part of the other
   Verdicts are then those of the structure as it most likely rests. Every call
   refuses these options (KERN_BAD_OPTION) unless e > 0 and theta >= 0. */
KERN_API kern_options kern_measured_options(const kern_options *options,
                                            kern_real e, kern_real theta);

/* Returns work memory that consists of these two arrays, with its counters at
   zero. */
KERN_API kern_work kern_work_of(kern_real *real, int reals, int *index,
                                int indices);

/* Writes the lengths KERN_REALS(blocks, contacts) and KERN_INTS(blocks,
   contacts), for counts that are known only at run time. Writes 0 if a count is
   out of range. */
KERN_API void kern_work_need(int blocks, int contacts, int *reals,
                             int *indices);

/* -- blocks -- */

/* Fills a block from a simple polygon, convex or not, turning either way: area,
   box, centroid, mass = density * |area| with the density in kg/m^2, no load.
   The block points to the caller's vertices, which must live as long as the
   block. If the vertices move, call this function again. `fault` may be NULL;
   otherwise fault->index is the vertex at fault. After a failed call other
   functions refuse the block with KERN_NO_BLOCK. Errors (the bounds of numbers
   are given at the head of this chapter): KERN_FEW_VERTICES, KERN_BAD_COUNT
   (above 1,000,000), KERN_BAD_NUMBER, KERN_NO_AREA, KERN_CROSSING (also if the
   last vertex repeats the first, as in closed rings of other formats),
   KERN_BAD_MASS (also a density not above 0). Time: O(n) for a convex polygon
   of n vertices; otherwise O(n^2) tests of whether the boxes of two edges
   meet. */
KERN_API kern_status kern_block_init(kern_block *block, const kern_vec *vertex,
                                     int vertices, kern_real density,
                                     kern_fault *fault);

/* Fills a fixed block, such as ground, a wall or a support. Errors are those of
   kern_block_init(). */
KERN_API kern_status kern_ground_init(kern_block *block, const kern_vec *vertex,
                                      int vertices, kern_fault *fault);

/* Simplifies a closed outline, such as one from an image: leaves out as many
   vertices as it can, so that none of them is farther than the tolerance [m]
   from the edge that replaces it (Douglas and Peucker 1973). A step lower than
   the tolerance is removed, unless one of its vertices is the farthest from a
   longer edge. A step higher than twice the tolerance is kept. Corners follow
   the same rule as steps.
   Writes the vertices that stay to out[0..room), beginning with the one
   farthest from the centroid, and their indices in `vertex` to kept[0..room).
   Returns the number of these vertices; `room` must not be less. They form a
   simple polygon, ready for kern_block_init(): if edges would cross, the
   tolerance is halved, up to seven times, and then set to 0. The result does
   not depend on the vertex with which the outline begins. If two vertices are
   equally far from an edge, a mirrored or turned outline may keep the other
   one. `vertex` may touch or cross itself. `vertex` must not overlap `out`.
   Errors: KERN_NO_SPACE, KERN_FEW_VERTICES, KERN_NO_AREA or KERN_CROSSING (no
   polygon remains; out means nothing), KERN_BAD_COUNT (above 1,000,000),
   KERN_BAD_POINTER, KERN_BAD_NUMBER, KERN_BAD_OPTION (the tolerance is negative
   or not a number). Time: O(n log n) for most outlines of n vertices; at worst
   O(n) for each vertex that is kept. */
KERN_API int kern_outline_simplify(const kern_vec *vertex, int vertices,
                                   kern_real tolerance, kern_vec *out,
                                   int *kept, int room);

/* Adds a force [N] that acts at a point, and a torque [N m], to the block's
   load. The load acts at the centre of mass, so set the centre first. */
KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec point,
                              kern_real torque);

/* Returns the mean size of the free blocks [m], which is the mean of the square
   roots of their areas. */
KERN_API kern_real kern_mean_size(const kern_block *block, int blocks);

/* -- contacts -- */

/* Finds the contacts between all blocks (>>rules) and writes them to
   out[0..room): those of block 1 with block 0, of block 2 with 0 and with 1,
   and so on. A block without vertices has no contacts. Returns the number of
   contact points. Errors: KERN_NO_SPACE (`out` then means nothing; the search
   itself needs room for about seven points for each short edge of an outline),
   KERN_OVERLAP (the fault names the first pair that overlaps),
   KERN_BAD_POINTER, _COUNT, _NUMBER, _FRICTION, _OPTION, KERN_FEW_VERTICES,
   KERN_NO_AREA, KERN_NO_BLOCK, KERN_STALE (the vertices of a block have moved,
   or their array was used for another block), KERN_LIMIT (the search exceeds
   options.limit; reading the vertices is not counted). Of the work memory it
   uses only the fields fault and units. Time: one test of boxes for each pair
   of blocks. For blocks whose boxes meet, a few products for each pair of close
   edges, or tens of products if no edge separates the blocks. In the worst
   case, such as two saws, the time grows with the square of the number of edges
   and contacts of a pair. */
KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options, kern_contact *out,
                           int room, kern_work *work);

/* Finds the pairs of blocks that overlap too deeply to be in contact, and
   writes them to out[0..room). Returns the number of such pairs, which may be
   more than `room`, or a negative status of kern_contacts(). */
KERN_API int kern_overlaps(const kern_block *block, int blocks,
                           const kern_options *options, kern_overlap *out,
                           int room, kern_work *work);

/* Finds the stretches of the contacts, which are contacts divided at hollows.
   Pass stretches to kern_bearing(), which computes the length of contact that
   the structure needs. kern_stretches() works as kern_contacts(), with two
   differences. First, a hollow wider than the gap divides a line: a block on
   two feet has one contact from the outer end of one foot to that of the other,
   but two stretches. Second, all contacts with fixed blocks are written as
   contacts with one fixed block, that of the first such contact. So cutting a
   fixed block in two changes nothing. For margins use kern_contacts() instead.
   Time: that of kern_contacts(), plus O(C) for each pair of blocks that has
   point contacts and, if there are several fixed blocks, for each contact. */
KERN_API int kern_stretches(const kern_block *block, int blocks,
                            const kern_options *options, kern_contact *out,
                            int room, kern_work *work);

/* Finds the contacts of block b with the blocks of lower index. These contacts
   equal those of kern_contacts(), unless a later block lies so far out that the
   rounding of its coordinates matters. Return values are those of
   kern_contacts(). KERN_STALE is returned only for block b and the blocks that
   it may touch. If options.lone is set, only the contacts found here count as
   contacts that carry a block. Time: O(b) tests of boxes, and for blocks whose
   boxes meet the time of kern_contacts(). */
KERN_API int kern_touch(const kern_block *block, int b,
                        const kern_options *options, kern_contact *out,
                        int room, kern_work *work);

/* Makes a contact that the caller defines. Set a, b, p, mu and the normal n in
   *out first; n points from a into b and may have any length. The contact is
   the line from out->p to q, or the point out->p if q equals it. Writes one or
   two contact points to out and returns their number. Errors: KERN_SAME_BLOCK,
   KERN_BAD_BLOCK (a negative index), KERN_BAD_NUMBER, KERN_BAD_FRICTION,
   KERN_BAD_NORMAL (no length), KERN_BAD_LINE (the line from p to q differs from
   the direction of the tangent by more than options->angle), KERN_BAD_OPTION.
   When all contacts are made, call kern_contact_travels(). */
KERN_API int kern_contact_make(kern_contact *out, kern_vec q,
                               const kern_options *options);

/* Sets the travel of every contact point (>>rules). The travel of a point
   depends on the other points of its interface, which are the points between
   the same two blocks, in either order. Does nothing if `contact` is NULL.
   Time: O(C n) for each n points of one interface that follow each other in the
   array. */
KERN_API void kern_contact_travels(kern_contact *contact, int contacts);

/* Returns the place at which a contact point acts at a shrinkage [m]. A
   negative shrinkage is a growth. If `relative` is nonzero, `shrink` is a share
   of the travel, and if it is 1 or more, the point acts at the middle, where
   its kern is closed. Returns the origin for NULL. */
KERN_API kern_vec kern_contact_at(const kern_contact *contact, kern_real shrink,
                                  int relative);

/* -- verdicts and measures -- */
/* In all these functions `shrink` is the length [m] by which kerns are shrunk
   (options.relative: a share of their travel, at most 1). If `shrink` is
   negative, kerns grow. `proof` may be NULL. */

/* Returns a task with gravity (0, -9.81), kern_defaults() and no warm start. */
KERN_API kern_task kern_task_of(const kern_block *block, int blocks,
                                const kern_contact *contact, int contacts,
                                kern_work *work);

/* Returns an empty warm start for task.known. The arrays must have room for one
   motion of each block and one force of each contact point. */
KERN_API kern_known kern_known_of(kern_motion *motion, kern_force *force);

/* Returns whether the structure stands: KERN_STANDS, KERN_FALLS or
   KERN_UNDECIDED. Time: O(B + C) if forces can be passed on from the top down,
   as in most walls. Otherwise the simplex method needs pivots, each of which
   takes O(C + F) for F entries of the factors (>>lp), where F is at most
   B^2. */
KERN_API kern_status kern_verdict(const kern_task *task, kern_real shrink,
                                  const kern_proof *proof);

/* Computes an interval for the margin of a measured structure, from the errors
   e and theta in its options. Returns the verdict that is called certain:
   KERN_STANDS if out->low is above 0 and out->settles is finite, KERN_FALLS if
   the structure falls even with all contacts and friction that `high` allows,
   or KERN_OK if neither is certain. KERN_FALLS is never returned if forces on
   the contacts of the task hold the structure. Pass the `margin` of
   kern_measure(), or 0 if the structure falls.
     low      Lets the blocks settle twice on the stretches (kern_stretches()),
              first with every second stretch open by 3 e, then with the other
              half open. `low` is the least of `margin` and of the two margins
              on the stretches that are closed then. All stretches get the least
              friction of the contacts. `low` is divided by 1 + 210 e / size, or
              if e is below 0.0065 mean sizes by 1 + 32,300 (e / size)^2. `low`
              is 0 if the structure may fall. The true margin is above `low` for
              about 94 of 100 structures that stand, and for 80 to 87 of 100
              stones placed where they move. `low` tends to `margin` as e tends
              to 0 if all contacts have the friction of the options.
     high     A shrinkage at which the structure is proven to fall although its
              kerns are longer by 3.5 e and its friction angles larger by 3
              theta, or the shrinkage that closes all kerns if none is found. A
              point that does not move counts as two points, 3.5 e to either
              side. `high` is at least `margin`. If kerns are not nested
              (>>rules), the structure may fall at smaller shrinkages, too. If
              `margin` is 0, contacts of edges and corners that
              kern_measured_options() finds with errors 2 e and 2 theta count as
              well.
     settles  How far the blocks may move [m], or KERN_INFINITY if one of four
              tests fails. Let g be the gap of the options plus 1.75 theta
              sizes. First, the structure stands on stretches at least 3.5 e
              long, or that far inside their edge, with kerns shorter by 3.5 e
              and friction angles smaller by 3 theta. Second, no block rocks
              (below). Third, the structure comes to rest with every third
              stretch, each third in turn, open by g more than was measured, the
              others closed, and no closed line leaves the end of the block
              on which it slides. Fourth, the structure stands on the stretches
              that are closed then. Their normals have turned by the smaller
              turn of their two blocks if both turn to the same side.
              `settles` is twice the longest motion of these settlings and of
              those of `low`, at least 6 e and at most 0.6 mean sizes.
   The second test tells whether a block may topple by its own speed because one
   end of its bed lacks support. The force on a bed is the weight and the load
   of its block and of the blocks that stand on this block alone and move with
   it. Divide this force by its magnitude. Let h be the height of the centre
   above the end of the bed along the force, c the distance of the line of the
   force from that end, and n the share of the force along the normal of the
   contact. The block falls until the gap at the end closes, which frees the
   energy n gap, and the impact is taken to lose none of it. The block passes if
   this energy does not lift it over the end: 2 h n gap <= c^2. The gap is the
   measured one plus g / 2. A stretch longer than half of the bed may hide a
   gap: if it has a bump, the gap is the measured one plus 1.25 g, and if it has
   none, only the end that is farther from the line of the force is tested. A
   bump is a place of a stretch that is nearer to the other block, by 0.3 e and
   more, than the line through the two places 1/16 of the stretch to either
   side. Contacts steeper than 60 degrees are no beds. A block is not tested on
   a side on which it is held: on both sides by a block that it carries together
   with a third block, on one side by a neighbour on which it leans there. The
   block that holds it must be fixed or have at least half of its mass.
   Limits: settling has no inertia, and in the second test loads act at centres.
   So a stone whose slope is within 0.1 rad of friction may slide when its
   support drops. A block may topple although it is called certain to stand
     - if a step narrower than 1/8 of a long stretch carries it,
     - if the line of the force is nearer to one end of a long stretch, and the
       half at that end lacks .5 to 2 e,
     - if it is tilted on a bed narrower than 30 e,
     - if it carries a frame: blocks that carry others together do not load the
       bed below them, and frames that sway as a whole are not seen.
   Stones that are wedged between walls, as in a flat arch, may fall through if
   the joints are open. Towers of which every bed lacks the same side move up to
   1.5 times as far as `settles`. `low` is too high for a bed with a step of 1
   to 4 e. tests/TRUST.md has shares for all of these.
   The order of blocks and contacts does not matter, except without gravity and
   for contacts of exactly the same height and place. A turned frame does not
   matter, and a mirrored one only for contacts of exactly the same height. A
   cut of the ground changes the contacts beside it a little, since with theta
   the gap of a contact depends on the distance from the centres of its blocks.
   e and theta are absolute even with options.relative.
   contact[0..room) receives the stretches, then the points for `high`. The
   work memory must be long enough for `room` contact points. Errors: those of
   kern_contacts() and kern_measure(), KERN_BAD_OPTION also if the options are
   not those of kern_measured_options(). After an error *out means nothing.
   After KERN_LIMIT, which limits the work of the whole call, *out has the ends
   proven so far.
   Time: five searches for contacts, six margins or verdicts, and five settlings
   of usually two and at most 16 linear programs. For settled structures that
   stand, the median time is 10 times that of kern_measure() at errors of 2 % of
   the mean size, and 21 times at 0.2 %. A wall of 200 bricks takes 0.1 to
   0.2 s. */
KERN_API kern_status kern_certain(const kern_task *task, kern_real margin,
                                  kern_interval *out, kern_contact *contact,
                                  int room);

/* Finds whether the load, applied to unstressed contacts, raises forces that
   hold the structure. Such forces come with a motion of the blocks. At every
   contact that has a force, the motion brings the two blocks closer. If the
   force is inside the friction cone the contact sticks, and otherwise it slides
   against the friction. If no such forces are found for the whole load at once,
   the load is increased from 0 in steps, as in kern_raised_load(). KERN_STANDS:
   writes *out and both arrays of the proof, which passes kern_check_raised().
   If *out is KERN_NOT_SHOWN, only the forces are written. KERN_FALLS:
   proof->motion is that of kern_verdict(), and *out is unchanged.
   *reserve (may be NULL) is the largest of the shares of gravity 0, .001 ...
   .005, .0055, .006, .007, .008, .01, .015, .02, .03, .05 and .1 for which the
   structure stays raised under a push of that share to either side, with kerns
   shrunk further by that share of the mean size (relative: by that share).
   *reserve is 0 if the structure is not raised. Shares above options.reserve
   are not tried. Returns KERN_BAD_OPTION if `reserve` is not NULL but there is
   no gravity. work->end tells why the search without a push ended. Returns
   KERN_NO_SPACE also for structures much wider than a wall of square blocks,
   whose matrix does not fit. Time: 3 times that of kern_measure() in the mean
   of 969 walls, and 6 times if the reserve is computed. */
KERN_API kern_status kern_raised(const kern_task *task, kern_real shrink,
                                 kern_raising *out, kern_real *reserve,
                                 const kern_proof *proof);

/* Computes the chance that block i, placed last, stays where it is released.
   The chance follows from statics by a law fitted to placements (>>measures).
   Blocks more than four contacts away from block i are held. Then
       chance = .05 + .95 odds / (1 + odds),    odds = (5.5e7 r^3 / s)^2
       r = min(reserve, .01) + .004
       s = max(1, displacement of block i that raises the forces), where the
           mean weight is 1 and the stiffness of a contact point is .1 plus,
           at the end of a line, its travel in mean sizes. A turn counts as a
           displacement by its angle times half the size of the block
   The law was fitted to 835 placements, most of them close to falling: 630 stay
   and 205 move (tests/TRUST.md). If a planner draws places at random and the
   structure stands with the stone there, more of the stones stay than the
   chance predicts. KERN_STANDS: writes *chance, from .05 to 1, or 0 if some
   block hangs. KERN_FALLS: *chance is unchanged. Returns KERN_BAD_BLOCK if i is
   no free block, and KERN_BAD_OPTION if there is no gravity. Time: that of 3
   calls of kern_plan_try() in the median, if the known forces of a plan are
   used. */
KERN_API kern_status kern_stays(const kern_task *task, int i,
                                kern_real *chance);

/* Finds whether the structure stays when all blocks are released at once, from
   rest, in the given poses. Use kern_let_go() for a finished structure.
     KERN_STANDS     It stays: its load raises forces that hold it. The proof
                     passes kern_check_raised() as KERN_RAISED. A pencil on its
                     tip counts as staying, too: kern_raised() computes its
                     reserve.
     KERN_FALLS      It moves, by proof->motion. This motion passes
                     kern_check_motion() or, if blocks hang, kern_check_raised()
                     as KERN_HANGS.
     KERN_UNDECIDED  Neither is shown; work->end tells why.
   *how (may be NULL) is KERN_HANGS if blocks hang, KERN_RAISED if the structure
   stays, and otherwise KERN_NOT_SHOWN. To find the least friction with which
   the structure stays, bisect options.mu, finding the contacts again at each
   step. To find its tilt, bisect the angle of s.gravity. Begin the bisection at
   a value at which the structure stays. The least friction with which the
   structure stays is not below the least friction of the verdict, and the tilt
   is not above that of kern_tilt(). Time: that of kern_raised(). */
KERN_API kern_status kern_let_go(const kern_task *task, kern_raising *how,
                                 const kern_proof *proof);

/* Computes the minimum-norm forces (>>measures): of all forces that hold the
   structure, those with the least sum of f^2 + (r / mu)^2 over the contact
   points. KERN_STANDS: writes force[0..contacts), which pass the check of a
   proof. KERN_UNDECIDED: no such forces exist (see kern_verdict()), or no
   forces were found that are as exact as a proof requires, as in critical jams
   or where sizes differ by 1e4. Returns KERN_NO_SPACE in the cases of
   kern_raised(). Time: a third of that of kern_measure(). */
KERN_API kern_status kern_forces(const kern_task *task, kern_real shrink,
                                 kern_force *force);

/* Computes the margin and the level.
     KERN_STANDS    All of *out is written. proof->force holds the structure at
                    out->holds, with its kerns shrunk. proof->motion moves it at
                    out->fails (not written if the margin is saturated).
     KERN_FALLS     level, margin, holds, fails and saturated are 0; most and
                    epsilon are set. proof->motion is the mechanism.
     KERN_LIMIT     level is -1, saturated 0. margin and holds are the largest
                    shrinkage proven to stand, or -1 if there is none yet. fails
                    is the smallest shrinkage proven to fall, or `most`. If the
                    limit ended the call before it read the input, then fails,
                    most and epsilon are infinite. The proof means nothing.
     KERN_UNDECIDED As for KERN_LIMIT. No verdict between holds and fails is
                    proven.
     KERN_BAD_STEP  most / epsilon is above 1,000,000. *out is unchanged.
   The width of [holds, fails] is given in >>limits. If kerns are nested, the
   proofs of the margin also prove the level. Otherwise each step has a proof of
   its own.
   If options.narrow = k, a shrinkage d > 0 also reduces friction from mu to
   max(0, (mu - k d) / (1 + mu k d)), the tangent of the friction angle minus
   atan(k d). A robot that places stones within e and theta sets k = tan(theta)
   / (2 e). Then margin / (2 e) estimates, but does not bound, the multiple of
   the error e that the structure can bear. If k is so large that kerns hardly
   shrink, the reduced friction at the margin is the least friction with which
   the structure stands. Warm start: the search begins from task->known and
   remembers its result there. After KERN_UNDECIDED and KERN_LIMIT task->known
   is empty. */
KERN_API kern_status kern_measure(kern_task *task, kern_margin *out,
                                  const kern_proof *proof);

/* Computes the derivatives of the margin with respect to every contact point
   and block, from the proof that kern_measure() wrote. Writes them to
   contact[0..contacts) and block[0..blocks). The derivatives are exact if only
   one mechanism is critical, a small change does not make or end a contact, and
   no contact that carries is about to shrink to a point. Otherwise the
   derivatives hold only for the mechanism of the proof. If corners of two
   blocks coincide at the end of a contact, both corners are taken to move that
   end. The travel of single points (options.lone) is treated as constant.
   options.narrow must be 0. Returns KERN_OK, or KERN_UNDECIDED if the margin is
   saturated or does not change. Time: O(B + C), 0.03 of that of
   kern_measure(). */
KERN_API kern_status kern_sensitivity(const kern_task *task,
                                      const kern_margin *margin,
                                      const kern_proof *proof,
                                      kern_contact_rate *contact,
                                      kern_block_rate *block);

/* Computes the deficit (>>rules) [m; relative: 1]. KERN_STANDS: *deficit is 0.
   KERN_FALLS: *deficit is written. KERN_LIMIT: *deficit is a lower bound, or -1
   if the structure is not proven to fall yet. */
KERN_API kern_status kern_deficit(const kern_task *task, kern_real *deficit);

/* Computes the length [m] of the shortest contact that the structure needs,
   among those of kern_contacts() or, where faces may be hollow, of
   kern_stretches(). The structure stands on its contacts of at least this
   length, but not on the longer ones alone. If several points form an
   interface, the length of each is twice its travel. A single point without a
   travel is never left out. KERN_STANDS: writes *length, or KERN_INFINITY if no
   contact that has a length is needed. proof->force holds the structure by the
   contacts of at least this length. proof->motion moves the structure without
   the shortest of these contacts. If the verdict without this shortest contact
   is undecided, the contact counts as needed and the motion is 0. KERN_FALLS:
   the structure falls even with all contacts. Time: one verdict for each step
   of a bisection of the lengths on a logarithmic scale. */
KERN_API kern_status kern_bearing(const kern_task *task, kern_real *length,
                                  const kern_proof *proof);

/* Computes the largest factor of a horizontal load to a side, on top of weights
   and loads. KERN_STANDS: writes *factor, which is KERN_INFINITY if the
   structure stands at 1,000,000. As in kern_measure(), proof->force holds the
   structure under the loads at the factor or just below it, and proof->motion
   moves it just above. KERN_FALLS: the structure falls at a factor of 0.
   Returns KERN_BAD_OPTION if there is no gravity, or if the side is neither
   left nor right. */
KERN_API kern_status kern_load_factor(const kern_task *task, kern_real shrink,
                                      kern_side side, kern_real *factor,
                                      const kern_proof *proof);

/* Computes the largest factor of a load pattern[0..blocks), which has a wrench
   about the centre of each free block. Statuses and proof are those of
   kern_load_factor(). */
KERN_API kern_status kern_load_factor_of(const kern_task *task,
                                         kern_real shrink,
                                         const kern_wrench *pattern,
                                         kern_real *factor,
                                         const kern_proof *proof);

/* Computes the least factor of a load pattern with which the structure stands.
   *factor is 0 if the structure stands without the pattern. Otherwise the
   pattern times *factor is the smallest load that holds the structure, as a
   prop or a hand would. To find the largest factor, call kern_load_factor_of()
   with this load added to the blocks. KERN_STANDS: writes *factor. proof->force
   holds the structure at the factor. proof->motion moves it just below, and is
   not written if the factor is 0. KERN_FALLS: the structure falls at every
   factor, and *factor is KERN_INFINITY. KERN_UNDECIDED, KERN_LIMIT: the
   structure is proven to fall at every factor below *factor. Time: that of one
   verdict for each mechanism on the way. */
KERN_API kern_status kern_least_load_of(const kern_task *task, kern_real shrink,
                                        const kern_wrench *pattern,
                                        kern_real *factor,
                                        const kern_proof *proof);

/* Computes the load factor for Coulomb friction, with the load growing from 0:
   unlike in kern_load_factor(), stones that slide need not move apart. *factor
   is the largest multiple of the load that raises forces which hold the
   structure, as in kern_raised(). Each step of the load (>>tune) is proven,
   starting from the step before. With friction equilibrium is not unique: on
   another path of loading the structure may collapse earlier (by 5 % in one
   case) or later. *factor is never above the load factor, which is computed
   first. The load is `pattern`, or if that is NULL, horizontal to the side.
   KERN_STANDS: writes *factor, which is KERN_INFINITY if forces are raised even
   at a factor of 1,000,000. Both arrays of the proof pass kern_check_raised()
   with the loads at the factor. work->end is KERN_END_SHOWN if *factor is the
   load factor; otherwise work->end tells why *factor is less. KERN_FALLS: the
   structure falls at a factor of 0. Returns KERN_UNDECIDED also if the weight
   alone is not shown to raise forces; *factor is then unchanged. Time, in
   multiples of kern_load_factor(): 8 in the median for settled stones, 13 for
   walls that fall by sliding (9.5 for those of 40 to 60 blocks). */
KERN_API kern_status kern_raised_load(const kern_task *task, kern_real shrink,
                                      kern_side side,
                                      const kern_wrench *pattern,
                                      kern_real *factor,
                                      const kern_proof *proof);

/* Computes the first angle [rad] at which the structure falls when gravity
   turns toward a side. KERN_STANDS: writes *angle. Proof and errors are those
   of kern_load_factor(). */
KERN_API kern_status kern_tilt(const kern_task *task, kern_real shrink,
                               kern_side side, kern_real *angle,
                               const kern_proof *proof);

/* Computes the profile (>>rules). Writes to value[0..blocks) shrinkages [m] for
   KERN_SHRINK, factors of a horizontal load for a side, and KERN_INFINITY for a
   fixed block. After a negative status *out is unchanged and the values mean
   nothing, except after KERN_LIMIT: then the values of blocks that have been
   removed are final, and the others are -1. Returns KERN_BAD_OPTION if there is
   no such side, or if there is a side but no gravity. Returns KERN_UNDECIDED if
   a verdict that the profile depends on is undecided. Time: 3 to 5 times that
   of kern_measure(). */
KERN_API kern_status kern_profile(const kern_task *task, kern_side side,
                                  kern_real *value, kern_collapse *out);

/* Finds the contacts that limit a measure and the blocks that move, from the
   measure's proof. proof->motion must not be NULL and must move the structure
   at about `shrink`. proof->force must hold the structure at `shrink`, or be
   NULL. After kern_measure() pass out->margin and its proof. If the structure
   falls, pass 0 and only the motion. How much a contact point limits the
   measure is the first of these quantities that is above 0 for at least one
   contact point:
     1. if there are forces: the increase of the mechanism's power per length
        [m] by which the contact point moves inward
     2. the spin of its two blocks relative to each other about the point
     3. the speed at which its two blocks slide
   Motions slower than 1e-4 (the fastest is 1) count as rest. KERN_OK: the
   arrays of *out are filled, and its fields contact and groups are set. Returns
   KERN_BAD_POINTER also if there is no motion, and KERN_BAD_NUMBER also if a
   motion is not finite; the fault then names the block. Time: O(C), and O(B)
   for each group. */
KERN_API kern_status kern_critical_of(const kern_task *task, kern_real shrink,
                                      const kern_proof *proof,
                                      kern_critical *out);

/* -- planning -- */
/* A plan is a structure that changes by one stone at a time. Contacts that have
   been found are not searched again. kern_measure(&plan.task, ...) and the
   queries below start from the results of the last kern_measure() of the plan.
   Without such results the answers are the same, but take longer. Queries leave
   the plan unchanged. Negative statuses of a query include those of
   kern_plan_add(). The proof of a query is for the structure with the block
   added: the proof has one more motion, and the forces of the block's contacts
   follow those of the plan. The search for these contacts may use options.limit
   units, and the query itself as many again. */

/* Returns an empty plan under gravity (0, -9.81). Add all blocks, the ground
   too, by kern_plan_add(). All arrays, also those of `known` and of the work
   memory, must be long enough for `blocks` blocks and `contacts` contact
   points. `blocks` counts the fixed blocks and the block that a query adds. */
KERN_API kern_plan kern_plan_of(kern_block *block, int blocks,
                                kern_contact *contact, int contacts,
                                kern_known known, kern_work *work);

/* Adds a block after the others and finds its contacts. Returns the number of
   its contact points, or a negative status of kern_touch(). Returns
   KERN_NO_SPACE also if the plan is full, and KERN_BAD_POINTER also if the plan
   has no arrays for known forces or motions. After a negative status the plan
   is unchanged. The block is copied, but its vertices are NOT: they must
   outlive the plan. Contacts of the block are found with the present options.
   Later changes of options.mu do not change the friction of these contacts.
   Time: O(B). */
KERN_API int kern_plan_add(kern_plan *plan, const kern_block *block);

/* Removes block i. The indices of later blocks decrease by 1, also in the
   contacts. KERN_OK: done. KERN_BAD_BLOCK: there is no block i. Time: O(B +
   C). */
KERN_API kern_status kern_plan_remove(kern_plan *plan, int i);

/* Computes the results of kern_measure() with the block added. Time: that of
   one verdict, if the stones that limit the margin do not change. The search
   starts at an upper bound: if options.limit ends the call, out->fails is an
   upper bound, but out->holds is above 0 only if the search was nearly done.
   Of 963 tries on walls, each ended after half of the work that it needs, these
   shares had such a bound:
     an upper bound of at most 2 margins    0.73    no upper bound   0.06
     an upper bound of at most 1.1 margins  0.53    any lower bound  0.03
   For a lower bound use kern_plan_bears(). For half of the margin,
   kern_plan_bears() takes 0.44 of the work of kern_plan_try() in the median,
   and 0.13 of it where kern_plan_try() takes 1,500 units. */
KERN_API kern_status kern_plan_try(kern_plan *plan, const kern_block *block,
                                   kern_margin *out, const kern_proof *proof);

/* Returns whether the margin with the block added is at least `margin` [m]
   (relative: a share): KERN_STANDS with forces at that shrinkage, KERN_FALLS
   with a motion. A structure that stands with every kern closed bears any
   margin, unless options.narrow is set. If kerns are not nested, the result is
   KERN_FALLS also if the margin of kern_plan_try() is smaller than `margin`;
   the motion is then the one at that smaller margin. Returns KERN_BAD_NUMBER
   also for a negative margin. Time: that of a verdict. If `margin` is above the
   margin that was measured last, the time is O(B + C) if the block does not
   touch the blocks that limit that margin. */
KERN_API kern_status kern_plan_bears(kern_plan *plan, const kern_block *block,
                                     kern_real margin, const kern_proof *proof);

/* Compute kern_stays() and kern_raised() for the plan with a block added. If
   `block` is NULL they use the plan as it is: kern_plan_stays() then treats its
   last block as the one placed last. */
KERN_API kern_status kern_plan_stays(kern_plan *plan, const kern_block *block,
                                     kern_real *chance);
KERN_API kern_status kern_plan_raised(kern_plan *plan, const kern_block *block,
                                      kern_raising *out, kern_real *reserve,
                                      const kern_proof *proof);

/* Copies a plan into `to`, which kern_plan_of() made with arrays and work
   memory of its own. Each thread needs a plan of its own. Vertices are not
   copied, so both plans read the same ones. KERN_OK: both plans give the same
   answers, to the last bit. KERN_NO_SPACE: an array of `to` is too short, and
   `to` is unchanged. */
KERN_API kern_status kern_plan_copy(kern_plan *to, const kern_plan *from);

/* Finds where a stone comes to rest on a structure, such as plan.task, when it
   is lowered with its centre at x, turned by the angle with cosine turn.x and
   sine turn.y. x is measured along gravity turned by +90 degrees, which is the
   x of the plane for gravity (0, -9.81). The height of the stone does not
   matter: the descent begins above all blocks.
   The stone moves straight down to its first touch. Then it moves on from touch
   to touch, each time by the motion that lowers its centre most steeply: a turn
   about a point where the stone touches, a slide along an edge that is steeper
   than friction holds, or a turn while it slides at two touches that friction
   does not hold. Friction is options.mu, and at two touches at least 0.01. A
   motion turns the stone by at most 28 degrees. The stone is at rest where no
   motion lowers its centre, or where it touches the structure at 24 points. A
   touch of two convex corners holds nothing. Of 41,000 stones on blocks that
   cannot move, such as cubes on a grid, stairs and saw teeth, a share of 0.993
   stand where they come to rest. To check whether a stone stands, call
   kern_plan_bears(). Blocks of the structure do not move.
   Each motion ends where the stone meets a block, so the stone overlaps no
   block by more than 1e-6 (float: 1e-4) of its size. A mirrored stone and
   structure have the mirrored pose, and the order of blocks does not matter.
   vertex[0..stone->vertices) receives the vertices of the stone at rest, in
   their order. vertex must not be the stone's own array. The contacts of the
   structure are not read. KERN_OK: *out is written. After a negative status
   *out means nothing. KERN_NO_SUPPORT: the stone falls past the structure.
   KERN_NO_REST: the stone still moves after 64 motions. KERN_NO_LOAD: there is
   no gravity. Returns KERN_BAD_NUMBER also if x or the centre of the stone is
   out of bounds, or if the length of `turn` is not 1. Blocks and stone are
   checked as by kern_touch(). If the fault is at the stone, the block of the
   fault is B. Time: O(B) for each motion, plus the time for the edges close to
   the stone. A call takes 32,000 instructions in the mean on a wall of 30 rough
   stones, and 19,000 on a bond of 36 bricks. */
KERN_API kern_status kern_rest(const kern_task *task, const kern_block *stone,
                               kern_real x, kern_vec turn, kern_vec *vertex,
                               kern_pose *out);

/* Compares two places for a stone. Returns 1 if a is better, -1 if b is better,
   and 0 if no number differs. NULL is worse than any place. `alone` is the
   margin of the structure without the stone. At most places the stone does not
   change this margin. The first of these numbers that differs between the two
   places decides:
     stays   the larger chance; all from 0.9 on count as equal
     margin  the larger; all within 1e-4 (float: 1e-3) of `alone` count as equal
     own     the larger
     load    the larger
     x turn  the smaller, so that any order of places gives the same best
   All but x and turn are first rounded to 13 bits, 1e-4 of the number. So
   rounding errors hardly ever decide, and moving a structure does not change
   its best place. Mirroring a structure mirrors its best place, unless x
   decides between two places. NaN is worse than any number.
   Tested on 111 walls under construction, for each of which kern_rest() found
   eight places. At some of these the stone stays in all six runs of the
   simulator of examples/laboratory, and at others it does not. The stone stays
   at the best place on 107 of these walls, and at the place of the largest
   margin on 96. */
KERN_API int kern_place_compare(const kern_place *a, const kern_place *b,
                                kern_real alone);

/* -- proofs -- */

/* Return the error of a proof as a share of the allowed error. The proof holds
   if the result is at most 1. Return KERN_INFINITY if the forces or the motion
   prove nothing, and for bad input (NULL, NaN). In each equation of equilibrium
   of a block, forces may leave a residual of 1e-9 (float: 1e-4) of the load on
   the block, plus the rounding error of the largest force on it. The sum of all
   forces may be at most 1e6 (float: 1e3) times the total weight. A motion
   proves a fall only if such forces could not stop it, even with the largest
   rounding errors. Time: O(B + C). kern_check_forces() needs work memory of 4 B
   reals. */
KERN_API kern_real kern_check_forces(const kern_task *task, kern_real shrink,
                                     const kern_force *force);
KERN_API kern_real kern_check_motion(const kern_task *task, kern_real shrink,
                                     const kern_motion *motion);

/* Returns the error of the proof of kern_raised(), as a share of the allowed
   error. For KERN_RAISED it checks the forces, and that the motion closes every
   contact whose force is needed for equilibrium. A contact that must stick may
   slide by at most 1/500 (float: 1/5) of the length by which the motion closes
   it. For KERN_HANGS kern_check_raised() checks that the motion moves blocks
   without a load, that no contact with another block presses one of them
   against gravity, and that the forces hold the other blocks without these. For
   KERN_NOT_SHOWN, which proves nothing, it returns KERN_INFINITY. It needs work
   memory of 5 B reals. */
KERN_API kern_real kern_check_raised(const kern_task *task, kern_real shrink,
                                     kern_raising raising,
                                     const kern_proof *proof);

/* -- the linear program alone -- */

/* Solves a small dense linear program. x must have room for lp->cols numbers,
   and y for lp->rows numbers.
     KERN_LP_OPTIMAL     x is a solution. If there are costs, x has the least
                         cost and y are its prices: cost - y.A >= 0, and = 0
                         where x > 0
     KERN_LP_INFEASIBLE  no x exists: y.A >= 0 and y.rhs < 0
     KERN_LP_UNBOUNDED   the cost falls along x: A x = 0, x >= 0, cost.x < 0
     KERN_UNDECIDED      the method did not end, or the check failed, as it may
                         where units differ by more than 1e4
     KERN_LIMIT          lp->limit was reached
   Each answer is checked against A, every row and column in its own units, so
   that the choice of units does not matter. After a negative status x and y
   mean nothing. It needs work memory of KERN_LP_REALS(rows, cols) reals and
   KERN_LP_INTS(rows, cols) ints. Time: O(rows^2 + rows cols) for each pivot. */
KERN_API kern_status kern_lp_solve(const kern_lp *lp, kern_real *x,
                                   kern_real *y, kern_work *work);

#ifdef __cplusplus
}
#endif
#endif /* KERN_H */

/* Users of the library can stop reading here. The rest is the
   implementation. */

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

/* Turns off the warning of C++ compilers for C-style casts. */
#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wold-style-cast"
#endif

/* Turns off the vectorisers of gcc, which use fused multiply-add for pairs of
   products such as a c - b d and a d + b c even with -ffp-contract=off. */
#if defined(__GNUC__) && !defined(__clang__) && defined(__FMA__)
#pragma GCC push_options
#pragma GCC optimize("no-tree-vectorize")
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* KERN_ASSERT checks a condition that must hold whatever arguments a caller
   passes. KERN_AUDIT checks the internal state of a method, such as the simplex
   method (tests/audit.h). Both do nothing unless a test build defines them. */
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

/* Marks functions that would make firmware larger if they were inlined. */
#if defined(__GNUC__) && defined(__OPTIMIZE_SIZE__)
#define KERN_SHARED __attribute__((noinline))
#else
#define KERN_SHARED
#endif

/* ---- Constants -------------------------------------------------- >>tune */
/* All constants of Parts III to V; those of the geometry are in >>tol. Each
   constant has one job. Lengths are shares of a block's size and forces are
   shares of the total weight, unless a unit is given in brackets. KERN_PICK(a,
   b) is a in double and b in float. A constant defined by another constant
   bounds the same rounding.

   Words that the constants use. A group is a free block in the model, with its
   three equations of equilibrium. A ray is a force along one edge of a friction
   cone: each contact point has two. A cluster is a set of groups that the
   top-down pass balances together. A part is a set of groups that is solved
   while all other blocks are held. A place is a value on the path of a measure:
   a shrinkage, a load factor, or the tangent of a quarter of the angle by which
   gravity has turned. A jam is a structure whose forces grow without bound
   toward the critical value. */

/* ---- what a proof allows ---- */

/* Largest residual of an equation of equilibrium in a proof, as a share of the
   loads on the block. Coordinates and masses of real stones are known far less
   exactly. */
#define KERN_TOL KERN_PICK(1e-9, 1e-4)
/* Largest sum of forces in a proof, as a multiple of the total weight. The
   bound excludes jams, whose forces are arbitrarily large. A motion proves a
   fall only if its power exceeds this sum times the fastest speed at which it
   closes a contact. */
#define KERN_BOUND KERN_PICK(1e6, 1e3)
/* Largest rounding error of a sum in a proof, as a share of the sum of the
   magnitudes of its terms: an equation has some tens of terms. In Part VI two
   points are the same if they are closer than twice this share of the largest
   coordinate. */
#define KERN_ROUNDING (32 * KERN_EPS)
/* Largest share by which a tangential force r may exceed its bound mu f. It is
   the rounding error of mu f. */
#define KERN_CONE_TOL (8 * KERN_EPS)
/* Least power [W] that a motion must have to prove a fall. The same number
   [m/s] is added to each closing speed. Products of smaller numbers may lose
   digits by underflow. */
#define KERN_POWER_LEAST (1 / (KERN_FAR * KERN_FAR))
/* Largest residual of a row or column in the proof of a caller's linear
   program, as a share of the sum of the magnitudes of its terms. */
#define KERN_LP_TOL KERN_TOL
/* Raised forces: a contact must stick if its tangential force is below mu f by
   more than this share of mu f. */
#define KERN_SLIDES_TOL KERN_TOL
/* Raised forces: the blocks of a contact must approach each other if its force
   is above this share of the least load of a block. Equilibrium does not need
   smaller forces. */
#define KERN_PRESSED_LEAST KERN_TOL
/* Raised forces: largest slide of a contact that must stick, as a share of its
   approach. The stiffness along t in >>raised (kern_dual.shear) is 1.1 /
   KERN_STICKS. */
#define KERN_STICKS KERN_PICK(2e-3, 0.2)
/* Least cosine between a contact's normal and gravity at which the contact can
   hold a block up. A contact with a smaller cosine counts as a vertical joint
   whose coordinates were rounded. If such a contact held a block up, it would
   act as a wedge and press with thousands of times the weight that it holds. */
#define KERN_HOLDS_UP KERN_R(1e-4)

/* ---- what may be asked ---- */

/* Largest coordinate and option [m], largest sum of weight and loads of a block
   [N], and largest mass [kg] and size [m]. Squares and moments of such numbers,
   and products with KERN_BOUND, keep all digits. */
#define KERN_FAR KERN_PICK(1e60, 1e10)
/* Least size [m] of a block: arms divided by it keep all digits. */
#define KERN_SIZE_LEAST (1 / KERN_FAR)
/* Least mass [kg] of a block: its weight does not underflow. */
#define KERN_MASS_LEAST (1 / KERN_FAR)
/* Largest mass [kg] of a block: its weight keeps all digits. */
#define KERN_MASS_MOST KERN_FAR
/* Least sum of weight and loads of a block [N], unless that is 0. */
#define KERN_LOAD_LEAST (1 / KERN_FAR)
/* Largest difference between 1 and the square of a normal's length, by rounding
   in this precision. */
#define KERN_NORMAL_TOL (64 * KERN_EPS)
/* Least options.angle [rad] that is refused: with it a corner would count as a
   face, and the series of kern_sine() would lose digits. */
#define KERN_ANGLE_MOST KERN_R(0.5)
/* Largest options.reserve, in shares of gravity: the table of
   kern_raise_reserve() ends there. */
#define KERN_RESERVE_MOST KERN_R(0.1)
/* Default gravity of a task [m/s^2]. */
#define KERN_GRAVITY KERN_R(9.81)
/* Largest number of blocks of a task, and of rows of a program. Sizes of the
   work memory and products of its indices then fit into an int. */
#define KERN_BLOCKS_MOST 20000
/* Largest number of contact points, vertices, levels and columns, and of blocks
   of a contact search. */
#define KERN_POINTS_MOST 1000000
/* Largest limit of work of a call [units], and largest number of entries of a
   caller's matrix. */
#define KERN_WORK_MOST 2000000000

/* ---- what work costs, in units ---- */
/* The costs are fitted to counts of instructions: one unit of work is 550 to
   2,000 instructions (>>verdicts). A constant *_UNIT is the number of items
   that one unit of work processes. */

/* Number of entries of sparse columns that are added up in one unit of work.
   For a dense factor the number is 8/3 times as large, since no indices are
   read. */
#define KERN_UNIT 64
/* Number of blocks and contacts that a call reads and checks in one unit of
   work. */
#define KERN_CALL_UNIT 5
/* Number of blocks and contacts that the check of a proof reads in one unit of
   work. Each proof costs three units in addition. */
#define KERN_QUERY_UNIT 14
/* Number of groups and contacts that are ordered in one unit of work, so that
   the rows of the skyline matrix become short. */
#define KERN_ORDER_UNIT 4
/* Number of groups and contacts whose known forces are copied in one unit of
   work. */
#define KERN_KNOWN_UNIT 32
/* Number of contacts whose forces the line search computes in one unit of
   work. */
#define KERN_PLACE_UNIT 16
/* Number of multiplications for one contact in a step of Newton's method: for
   its row, its forces and their derivatives, and its blocks of the matrix. */
#define KERN_CONTACT_PRODUCTS KERN_R(100)
/* Number of multiplications for one row of a Cholesky factor, divided by the
   square of its number of 3 x 3 blocks. Half of all pairs of blocks are
   multiplied, which takes 27 multiplications for each pair. */
#define KERN_PAIR_PRODUCTS KERN_R(14)

/* ---- model ---- */

/* Travels of contact points below this count as 0 [mean size]: a millionth of
   the length of the shortest line contact is rounding. */
#define KERN_TRAVEL_LEAST (KERN_R(1e-6) * KERN_R(1e-3))
/* Slope of the lines along which blocks count as equally high (only in double).
   The blocks of a flat arch are then ordered from side to side, and not by
   their rounding errors. */
#define KERN_LEVEL_SLOPE KERN_R(1e-6)
/* Longest run of blocks that is sorted by insertion. If shorter runs were
   divided further, the passes of Shell's sort would cost more than they
   save. */
#define KERN_SORT_RUN 32

/* ---- measures ---- */

/* Width of the bracket of a measure [mean block size; load factor; tangent of a
   quarter of the angle]. Half of the width lies below the critical value, and
   up to all of it may lie above. With a narrower bracket fewer verdicts near
   critical have a proof. A wider bracket exceeds the promised 2e-6. */
#define KERN_WIDTH KERN_PICK(1.26e-6, 1.8e-3)
/* Largest distance between the two places, one on each side of a critical
   value, that the search tries, in units of KERN_WIDTH. If the places would
   have to be farther apart, the search cuts the bracket instead. */
#define KERN_WIDEST KERN_R(20)
/* Widest bracket that is accepted as an answer, in units of KERN_WIDTH. In jams
   no proof is found closer to the critical value. */
#define KERN_ANSWER KERN_PICK(80, 20)
/* Largest number of groups that are solved as one linear program, which gives
   exact margins. With more groups, factoring this program costs more than the
   interior-point method. */
#define KERN_SMALL 64
/* Number of even steps in which the search goes along a path on which the
   verdict may change more than once. Such a path is a shrinkage up to the
   largest travel if kerns are not nested, or a tilt through half a circle under
   fixed loads. An interval in which the structure falls may be missed if it is
   narrower than a step. Since steps may be halved, a search takes at most five
   times as many steps. */
#define KERN_SCAN 1001
/* Default step of a level [mean size]: the paper's steps are of this order. */
#define KERN_LEVEL_STEP KERN_R(0.02)
/* Default step of a level if options.relative is set [share of the travel]. */
#define KERN_LEVEL_SHARE KERN_R(0.05)
/* Largest load factor that is searched. A structure that stands at this factor
   counts as standing under any multiple of the load. */
#define KERN_FACTOR_MOST KERN_R(1e6)
/* Deficit: first growth of the kerns that is tried [mean size; share of the
   travel], smaller than any deficit that matters. */
#define KERN_GROW_FIRST KERN_R(0.001)
/* Deficit: factor from one growth that is tried to the next if kerns are
   nested. The factor is large, so that few verdicts suffice. */
#define KERN_GROW_NESTED KERN_R(4)
/* Deficit: factor from one growth that is tried to the next if kerns are not
   nested. The factor is small, so that an interval in which the structure
   stands is seldom missed. */
#define KERN_GROW_EVEN KERN_R(1.1)
/* Deficit: largest growth that is tried, as a multiple of the longest side of
   the box around the free blocks (>>rules). */
#define KERN_GROW_MOST 1000

/* ---- profile, mechanism, sensitivity ---- */

/* Profile: largest load factor that is tried. A stone that still stands at this
   factor gets it as its value. */
#define KERN_PROFILE_MOST KERN_R(10)
/* Profile: if the verdict is undecided at the place where the structure fell
   last, the search tries at most this number of places beyond it, KERN_WIDTH
   apart. */
#define KERN_FALL_TRIES 8
/* Profile: a collapse may take three rounds for each group plus this number.
   Some rounds remove no block, since both verdicts may have a proof at one
   place. */
#define KERN_FALL_IDLE 8
/* Expected drop: a stone with this load factor falls with a chance of 1/e.
   Constants from 0.05 to 0.1 rank structures equally well. */
#define KERN_DROP_LOAD KERN_R(0.07)
/* Expected drop: least height with which a stone counts [mean block size],
   since even the lowest stones fall. */
#define KERN_DROP_HEIGHT KERN_R(0.3)
/* Blocks count as resting, or as not approaching each other, if their speed is
   below this share of the highest speed. */
#define KERN_REST KERN_R(1e-4)
/* Two limits of contact points (kern_critical_of()), or two speeds, count as
   equal if they differ by at most this share. The first of equal ones is then
   reported, and not the one that rounding makes largest. */
#define KERN_TIE KERN_R(1e-4)
/* Sensitivity: a sum of powers counts as 0 if it is below this share of the sum
   of the magnitudes of its terms. */
#define KERN_RATE_LEAST KERN_PICK(1e-10, 1e-5)
/* Sensitivity: the corner of a block moves the end of a contact if it is not
   farther from it than this [size]. The distance is the length of the shortest
   line contact. */
#define KERN_CORNER_NEAR KERN_R(1e-3)
/* Sensitivity: two distances from corners to an end count as equal if they
   differ by less than this [size]. */
#define KERN_CORNER_TIE KERN_R(1e-6)

/* ---- residuals that rounding leaves ---- */

/* Largest residual of equilibrium of a group that a method may leave, as a
   share of its load. The value is far below KERN_TOL, since residuals of many
   groups may add up. If it were 1e-10 in double, a light stone beside heavy
   ones would be reported to stand although it falls. */
#define KERN_PASS_TOL KERN_PICK(1e-11, 1e-6)
/* Largest residual of equilibrium that minimum-norm forces of all groups may
   leave (kern_forces(), >>raised), as a share of the least load of a group. A
   tenth of KERN_TOL is small enough, since these forces are not passed on from
   group to group and residuals do not add up. */
#define KERN_PART_TOL KERN_PICK(1e-10, 1e-5)
/* Rounding error of a residual, as a share of the largest force or value in
   it. */
#define KERN_RESIDUAL (4 * KERN_EPS)

/* ---- minimum-norm forces ---- */

/* Number that is added to the diagonal of Newton's matrix, as a share of the
   mean of the diagonal. Without this shift the rows of a group would be 0 if no
   contact presses on the group, and the matrix would be singular. */
#define KERN_DUAL_SHIFT KERN_ROUNDING
/* Most rounds of Newton's method for minimum-norm forces. The method takes far
   fewer, unless rounding errors spoil it. */
#define KERN_NORM_ROUNDS 100
/* Line search: factor by which the derivative must fall. A rough maximum is
   enough, since the next step of Newton's method starts from it. */
#define KERN_SHARE_TOL 8
/* Line search if contacts have prices (>>raised): factor by which the
   derivative must fall. This factor is larger than KERN_SHARE_TOL, since the
   next prices are computed from the result. */
#define KERN_SHARE_TOL_PRICED 1000
/* Line search: most steps until the maximum has been passed. Each step is four
   times as long as the last. */
#define KERN_SHARE_GROWS 13
/* Line search: most places that regula falsi tries after the maximum has been
   passed. Usually few are enough. */
#define KERN_SHARE_PLACES 20

/* ---- top-down pass ---- */

/* A pivot of a 3 x 3 matrix counts as rounding if it is below this share of the
   trace of the matrix. If this were 1e-11 in double, a profile of rubble would
   wrongly start above the margin. */
#define KERN_THREE_TOL KERN_PICK(1e-12, 1e-5)
/* If all pivots of a 3 x 3 matrix are above this share of its trace, the
   solution needs no refinement. */
#define KERN_THREE_GOOD KERN_PICK(1e-4, 1e-2)
/* A group is balanced alone only if it is carried by at most this number of
   contacts, which is the length of arrays on the stack. */
#define KERN_ROWS_MOST 12
/* Most rounds of Newton's method for one group. Usually it ends in four. */
#define KERN_ALONE_ROUNDS 10
/* If the same rays press in two rounds, the second one must divide the residual
   by this factor. Otherwise no forces balance the group. */
#define KERN_ALONE_PACE 8
/* Unit of the forces of a joint within 30 degrees of upright, as a share of the
   unit of a bed. For the same approach the joint takes the square of this share
   of the load of a bed. If this were 0.3, verdicts on 126 courses of bricks
   would take eight times the work, and if it were 1, they would take 900 times
   the work. */
#define KERN_SIDE_SHARE KERN_R(0.1)
/* A cluster counts as one that no forces can balance if the norm of its forces
   exceeds this multiple of its loads. With a larger bound clusters grow later
   and Newton's method takes more steps. Without a bound kern_plan_try() would
   take 4 % more work. */
#define KERN_CLUSTER_NORM KERN_R(100)
/* A contact counts as one that does not close if its closing speed is below
   this share of the largest speed. */
#define KERN_PARTS_TOL KERN_R(1e-4)
/* In a verdict on at most KERN_SMALL groups, a cluster may have the number of
   all groups divided by KERN_CLUSTER, plus one. In a search the divisor is
   KERN_CLUSTER + 1, and in a search from known forces KERN_CLUSTER + 3. If the
   divisor of verdicts were 5, they would take 7 % more work. If that of
   searches were 4, measures would take 6 % more. If that of searches from known
   forces were 5, kern_plan_try() would take 6 % more. */
#define KERN_CLUSTER 4
/* Number of groups that a cluster may have if the structure has more than
   KERN_SMALL groups, before KERN_CLUSTER_MORE is counted. With smaller clusters
   some measures of 100 blocks take four times the work. */
#define KERN_CLUSTER_MOST 20
/* A cluster may have one group more than KERN_CLUSTER_MOST for each
   KERN_CLUSTER_MORE groups of the structure. */
#define KERN_CLUSTER_MORE 32
/* Most work of a top-down pass, for each group and contact [units]. If this
   were 30, measures of bricks would take 1.4 times as long. */
#define KERN_PASS_UNITS 9

/* ---- search ---- */

/* Critical values that differ by less than this count as equal [mean block
   size]. If this were smaller, Newton's method would follow rounding errors. */
#define KERN_VALUE_SAME KERN_PICK(1e-10, 1e-5)
/* A negative force of a basis counts as rounding if its magnitude is below this
   share of the weight. A known force makes its column basic only if it is above
   this share. */
#define KERN_BASIS_NOISE KERN_PICK(1e-10, 1e-5)
/* Most places at which the search evaluates a verdict to narrow one bracket.
   Four to eight suffice, unless rounding spoils the proofs. */
#define KERN_BRACKET_ROUNDS 100
/* Most verdicts of kern_least_load_of(), which needs one for each mechanism
   that it meets. */
#define KERN_LEAST_ROUNDS 100
/* Most steps of Newton's method for the shrinkage at which a mechanism stops
   falling. The power of a mechanism has a kink wherever a kern closes, so that
   one step is not always enough. */
#define KERN_BENDS 8
/* Most falling parts that a search follows before it solves the whole
   structure. */
#define KERN_PARTS 8
/* A bracket without a predicted value is cut at 1 / KERN_CUT of its width,
   since mechanisms are found near its lower end more often. */
#define KERN_CUT KERN_R(4)
/* Largest step of Halley's method, as a multiple of the step of Newton's
   method. */
#define KERN_HALLEY_MOST KERN_R(4)
/* First step of a search: KERN_CLIMB [mean size], KERN_CLIMB_PUSH [load factor,
   tangent of a quarter of the angle]. Both are tuned on the odd half of the
   corpus (tests/CORPUS.md) and on walls of 100 to 200 blocks. */
#define KERN_CLIMB KERN_R(0.1)
#define KERN_CLIMB_PUSH KERN_R(0.5)
/* Factor from one step of a search to the next. */
#define KERN_CLIMB_GROWS KERN_R(1.5)

/* ---- interior point ---- */

/* Most steps of the interior-point method. Ten usually suffice, unless rounding
   spoils the method. */
#define KERN_IPM_ROUNDS 100
/* Number that is added to the diagonal of the matrix M (>>ipm) if M is
   singular, as a share of the mean of the diagonal. */
#define KERN_IPM_SHIFT KERN_PICK(1e-10, 1e-5)
/* A step of the interior point stops short of the boundary, x = 0 or z = 0, by
   at most this share of the way, and by less as the gap closes. From the
   boundary itself no further step is possible. */
#define KERN_IPM_BACKOFF KERN_R(1e-3)
/* Least share of its force that a ray keeps in a step of the interior point. A
   force that became 0 by rounding would never grow again. */
#define KERN_IPM_KEEP KERN_EPS
/* Least share of its force that a ray keeps when kern_ipm_balance() corrects
   the forces. */
#define KERN_IPM_BALANCE KERN_R(1e-3)
/* Starting point (Mehrotra): if the least entry of x or z is negative, the
   vector is raised by this multiple of that entry's magnitude. */
#define KERN_IPM_LIFT_LEAST KERN_R(1.5)
/* Starting point (Mehrotra): x and z are also raised by this share of their
   largest entry. */
#define KERN_IPM_LIFT_SHARE KERN_R(1e-3)
/* A query that continues from the solution of the last query sets s to at most
   minus this number. From s = 0 the query could not find that the structure
   falls. */
#define KERN_IPM_S KERN_R(1e-3)
/* A query that continues from the solution of the last query raises the gap to
   at least this number. Closer to the boundary the method makes no progress in
   a new direction. */
#define KERN_IPM_GAP KERN_R(1e-3)
/* Least product x z of a ray after a step, as a share of the mean product of
   all rays. */
#define KERN_IPM_CENTRE KERN_R(0.03)
/* Least share of the gap that the predictor is assumed to leave. The step aims
   at the cube of the share that it leaves. With a smaller constant fewer
   verdicts are decided. */
#define KERN_IPM_AIM KERN_R(0.03)
/* Gap below which a solution of the interior point is exact except for
   rounding: the square of the shift of the diagonal. */
#define KERN_IPM_GAP_LEAST (KERN_IPM_SHIFT * KERN_IPM_SHIFT)
/* Largest gap at which the interior point continues. At a larger gap the
   solution has no correct digits left. */
#define KERN_IPM_GAP_MOST KERN_BOUND
/* A query that continues from the solution of the last query begins again from
   scratch if, after k steps, its gap is above KERN_IPM_SLACK * KERN_IPM_PACE^k
   times its first gap. Without this restart some walls take three times the
   work. */
#define KERN_IPM_PACE KERN_R(0.95)
/* Constant factor in the bound on the gap that the comment of KERN_IPM_PACE
   gives. */
#define KERN_IPM_SLACK KERN_R(1.1)

/* Programs with costs. COST: least x, in the lightest load, and least z with
   which a program starts. TOL: the same, largest error of a solution. PRESSES:
   forces x below this multiple of z become 0, the square root of TOL. */
#define KERN_IPM_COST KERN_R(0.1)
#define KERN_IPM_COST_TOL KERN_PICK(1e-8, 1e-3)
#define KERN_IPM_PRESSES KERN_PICK(1e-4, 0.03)

/* ---- simplex method ---- */

/* Least violation of x >= 0 that counts in the simplex method, as a share of
   the largest load. */
#define KERN_VALUE_TOL KERN_PICK(1e-10, 1e-5)
/* Least gain of a column that enters, as a share of the largest price. Smaller
   gains are rounding. */
#define KERN_PRICE_TOL KERN_VALUE_TOL
/* Least pivot, as a share of the largest entry of the entering column. */
#define KERN_PIVOT_LEAST KERN_VALUE_TOL
/* Prices, slopes and entries of x and y count as rounding below this share of
   the largest of their kind. */
#define KERN_LP_ROUNDING KERN_ROUNDING
/* Amount by which y.A_j is raised for the basic columns of a certificate y, as
   a share of the largest entry of y. It is the rounding that the check of a
   motion allows for. */
#define KERN_LIFT KERN_ROUNDING
/* Largest residual of a basic solution, as a share of its largest value, before
   the basis is factored again. */
#define KERN_BASIS_TOL KERN_PASS_TOL
/* Most refinements of a basic solution. Each one adds almost as many correct
   digits as a number has. */
#define KERN_REFINES 3
/* Least pivot of a column that is factored after all own columns (>>lp), as a
   share of its largest entry. If its pivot is smaller, the column counts as
   linearly dependent on earlier columns. */
#define KERN_LATE_PIVOT KERN_PICK(1e-4, 1e-2)
/* Least pivot of a column in its own group, where its entries are about 1. With
   0.01 the entries of the inverse grow from course to course of a wall, and a
   call may take more than 2,000 instructions for a unit of its limit. With a
   larger constant the inverse has more entries. */
#define KERN_OWN_TOL KERN_R(0.03)
/* Crash basis (kern_crash_choose()): most columns of a group that are tried,
   which is the length of arrays on the stack. */
#define KERN_CRASH_COLUMNS 12
/* Crash basis: least determinant of three columns with entries of about 1. */
#define KERN_CRASH_DET KERN_LATE_PIVOT
/* Crash basis: largest tension in a column, as a multiple of its group's
   load. */
#define KERN_CRASH_PULL KERN_R(2)
/* One budget of pivots is KERN_PIVOTS plus KERN_PIVOTS_ROW for each row of the
   program. When the first budget is used up, prices are refined in every pivot.
   Most programs need less than one budget. */
#define KERN_PIVOTS 50
/* Pivots for each row of the program in one budget of pivots (KERN_PIVOTS). */
#define KERN_PIVOTS_ROW 2
/* Number of budgets of pivots (KERN_PIVOTS) after which Bland's rule chooses
   the pivots. Bland's rule cannot cycle, but is slow. */
#define KERN_PIVOTS_BLAND 5
/* The simplex method on a structure ends after this number of budgets of pivots
   (KERN_PIVOTS) plus one pivot for each column. Only jams take more than two
   budgets, and the interior point solves jams sooner. */
#define KERN_PIVOTS_JAM 3
/* Most pivots of a caller's program are this number plus KERN_PIVOTS_EACH for
   each row and column. The bound ends cycles that rounding causes. */
#define KERN_PIVOTS_MOST 200
/* Pivots for each row and column of a caller's program, in the bound that
   KERN_PIVOTS_MOST begins. */
#define KERN_PIVOTS_EACH 20

/* ---- raised ---- */

/* Norm of the forces, as a multiple of the loads of all groups, above which a
   search for raised forces ends. */
#define KERN_RAISE_NORM KERN_R(200)
/* Raised forces are accepted only if no loaded contact slides farther than this
   multiple of the largest approach of a loaded contact. A stone that falls into
   a jam slides farther. */
#define KERN_SLIDE_MOST KERN_R(100)
/* Most rounds of Newton's method for minimum-norm forces under one set of
   prices (>>raised). Usually it takes 4. */
#define KERN_PRICED_ROUNDS 10
/* A search for raised forces is lost if the displacement u is larger than
   (KERN_RUNS_AWAY + number of groups) times the u of the first round. The
   number of groups is added since slides add up along a row of groups. The
   search is also lost if u differs from the last u that had a proof by more
   than KERN_JUMPS times the size of that last u. */
#define KERN_RUNS_AWAY KERN_R(30)
#define KERN_JUMPS KERN_R(2)
/* A search for raised forces is also lost if the change of prices does not
   become smaller in this number of rounds, plus one for every two groups. With
   fewer rounds the search of a long row of blocks would end before the far end
   of the row has moved. */
#define KERN_PATIENCE 20
/* Most work of one search for raised forces, as a multiple of the cost of one
   step of Newton's method, which is mostly a factorisation. */
#define KERN_SEARCH_COSTS 3000
/* The prices of a search for raised forces are extrapolated by KERN_FORWARD
   times the difference between those that the last two rounds computed, if the
   cosine between the last two changes is larger than KERN_COHERENT. */
#define KERN_FORWARD KERN_R(2)
#define KERN_COHERENT KERN_R(0.7)
/* A price that falls is not set to its new value, but changes in a round by
   this share of the difference. */
#define KERN_PRICE_FALL KERN_R(0.3)
/* A search for raised forces tries Newton's method if at most KERN_FEW_CHANGES
   contacts have changed between open, sticking and sliding in the last round.
   The method takes at most KERN_NEWTON_ROUNDS steps. More steps cost more and
   find no more solutions. */
#define KERN_FEW_CHANGES 2
#define KERN_NEWTON_ROUNDS 3
/* kern_raised_load() raises a load to the load factor in KERN_LOAD_STEPS steps.
   A step that fails, which takes the work of ten others, is divided by
   KERN_LOAD_FINER. The least step is the share KERN_LOAD_NARROW of the largest
   load with a proof. If it were a share of the load factor, which may be
   several times too high, the search would end 3 % below limit equilibrium. */
#define KERN_LOAD_STEPS 10
#define KERN_LOAD_FINER 4
#define KERN_LOAD_NARROW KERN_R(0.005)
/* kern_stays(): distance from the stone, in contacts from block to block, up to
   which blocks are free. All other blocks are held. If this were 3 or 5, the
   chance would separate stones that stay from stones that move less well. */
#define KERN_STAYS_NEAR 4
/* kern_stays(): stiffness of contacts along t, in mu times their stiffness
   along n (kern_dual.shear). The stiffness for a proof is larger, since
   contacts must then stick within KERN_STICKS. */
#define KERN_STAYS_STIFF KERN_R(4)
/* kern_stays(): constants of the law by which it computes the chance, fitted to
   placements. KERN_STAYS_MOST is the largest reserve that counts,
   KERN_STAYS_ADD is added to the reserve, and KERN_STAYS_ODDS scales the
   odds. */
#define KERN_STAYS_MOST KERN_R(0.01)
#define KERN_STAYS_ADD KERN_R(0.004)
#define KERN_STAYS_ODDS KERN_R(5.5e7)

/* ---- Vectors ------------------------------------------------------ >>vec */

/* Returns the magnitude of a, and 0 for -0. gcc and clang need the builtin to
   compile this to one instruction. */
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

/* Returns 1 if a is a finite number: otherwise a - a is not a number. */
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

/* Returns a + s b. */
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

/* Returns a turned by +90 degrees. */
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

/* Returns the larger magnitude of the two coordinates. */
static kern_real kern_vec_largest(kern_vec a)
{
    return kern_max(kern_abs(a.x), kern_abs(a.y));
}

/* Returns 1 if both coordinates are numbers and small enough to compute
   with. */
static int kern_vec_is_moderate(kern_vec a)
{
    return kern_abs(a.x) + kern_abs(a.y) <= KERN_FAR;
}

/* Returns the sine by its series, since the last digit of libm's sine differs
   between machines. The result is exact to eight digits for angles below
   KERN_ANGLE_MOST. */
static kern_real kern_sine(kern_real angle)
{
    const kern_real q = angle * angle;
    return angle * (1 - q / 6 * (1 - q / 20 * (1 - q / 42)));
}

/* Shortens the interval [*low, *high] to those s for which offset + s * slope
   lies in [lower, upper]. An empty interval has *low > *high. */
static void kern_clip(kern_real *low, kern_real *high, kern_real offset,
                      kern_real slope, kern_real lower, kern_real upper)
{
    if (slope > 0 || slope < 0) {
        const kern_real a = (lower - offset) / slope,
                        b = (upper - offset) / slope;
        *low = kern_max(*low, kern_min(a, b));
        *high = kern_min(*high, kern_max(a, b));
    } else if (offset < lower || offset > upper) {
        *low = 1;
        *high = 0;
    }
}

/* Returns the velocity of the point at `arm` from the centre of a body that has
   the motion v. */
static inline kern_vec kern_velocity(const kern_motion *v, kern_vec arm)
{
    return kern_vec_make(v->vx - v->spin * arm.y, v->vy + v->spin * arm.x);
}

static kern_real kern_block_size(const kern_block *block)
{
    return KERN_SQRT(kern_abs(block->area));
}

/* Returns the sum of the magnitudes of the three numbers of a wrench or a
   motion. The sum is 0 only if all three are 0, and finite only if all three
   are finite. */
static kern_real kern_wrench_sum(const void *w)
{
    const kern_real *value = (const kern_real *)w;
    return kern_abs(value[0]) + kern_abs(value[1]) + kern_abs(value[2]);
}

/* v := s v, for an array of n numbers or structs with n numbers in total */
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
        *to++ = 0;
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

/* Returns the largest magnitude of n numbers. */
static kern_real kern_largest(const kern_real *v, int n)
{
    kern_real size = 0;
    int i;
    for (i = 0; i < n; i++)
        if (!(size > kern_abs(v[i]))) /* a call would take a third of a solve */
            size = kern_abs(v[i]);
    return size;
}

/* Returns the sum of a[i] b[i]. Four sums keep the pipeline of a processor
   full. */
static kern_real kern_dot(const kern_real *a, const kern_real *b, int n)
{
    kern_real s0 = 0, s1 = s0, s2 = s0, s3 = s0;
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

/* Returns the sum of three products. */
static inline kern_real kern_three(const kern_real *a, const kern_real *b)
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Extends a box to point p. */
static void kern_box_add(kern_box *box, kern_vec p)
{
    box->low.x = kern_min(box->low.x, p.x);
    box->low.y = kern_min(box->low.y, p.y);
    box->high.x = kern_max(box->high.x, p.x);
    box->high.y = kern_max(box->high.y, p.y);
}

/* ---- Statics -------------------------------------------------- >>statics */
/* Eq. (5) of >>method, as kern_part_set() assembles it:

       \   n   /         f n + r t = x1 (n + mu t) + x2 (n - mu t),
        \  |  /              x1, x2 >= 0
         \ | /
       ---- p ----  t

   A has three rows for each free block (force, torque about its centre) and two
   columns for each contact point. The unit of a length is the size of the
   block, and the unit of a force is the total weight. */

/* Which contacts may carry: all, or only those whose kerns are nested (lines,
   and points that do not move). */
typedef enum kern_carry { KERN_CARRY_ALL, KERN_CARRY_NESTED } kern_carry;

/* A query: the weights and loads that the structure has to carry, and the
   shrinkage of its kerns. */
typedef struct kern_query {
    kern_real shrink;    /* shrinkage of all kerns [m; relative: a share] */
    int relative;        /* nonzero: shrink is a share of each travel     */
    kern_real narrow;    /* options.narrow of the task                    */
    kern_real mean_size; /* mean size of the free blocks                  */
    kern_vec gravity;
    const kern_wrench *pattern; /* load pattern; NULL: a horizontal force of
                                   side * m |g| on each block               */
    kern_real factor;           /* factor of the pattern                    */
    kern_real loads;            /* factor of the loads of the blocks        */
    int side;                   /* right (1) or left (-1): side of the tilt,
                                   or of the load if pattern is NULL        */
    const kern_real *fallen;    /* block i has been removed if fallen[i] >=
                                   0; NULL: no block has been removed       */
    kern_real length_min;       /* contacts shorter than this carry nothing
                                   [m]                                      */
    kern_carry carry;           /* which contacts may carry                 */
} kern_query;

/* Returns the tangent of the angle by which a query narrows friction cones. */
static kern_real kern_reduction(const kern_query *q)
{
    return kern_max(q->narrow * q->shrink, 0);
}

/* Returns the friction of a contact whose cone is narrowed by the angle with
   the tangent `reduction`. */
static inline kern_real kern_friction(const kern_contact *c,
                                      kern_real reduction)
{
    return reduction > 0
             ? kern_max(c->mu - reduction, 0) / (1 + c->mu * reduction)
             : c->mu;
}

/* Returns 1 if block i has been removed. */
static inline int kern_is_gone(const kern_query *q, int i)
{
    return q->fallen && q->fallen[i] >= 0;
}

/* Returns the travel of a contact point, or 0 if it is so short that it is
   rounding. */
KERN_SHARED static kern_real kern_travel(const kern_contact *c, kern_real mean)
{
    KERN_ASSERT(mean > 0);
    return kern_abs(c->travel) < KERN_TRAVEL_LEAST * mean ? 0 : c->travel;
}

/* Returns the length of the line contact to which a contact point belongs. For
   a point of an interface of several points, returns the approximate length of
   the interface. Returns 0 for a single point. */
static kern_real kern_contact_length(const kern_contact *c, kern_real mean)
{
    return 2 * kern_abs(kern_travel(c, mean));
}

/* Returns 1 if a contact carries nothing: it is too short, one of its blocks
   has been removed, or q->carry excludes it as a point that travels. */
static inline int kern_is_idle(const kern_query *q, const kern_contact *c)
{
    const kern_real len = q->length_min > 0
                            ? kern_contact_length(c, q->mean_size)
                            : 0;
    if (q->carry == KERN_CARRY_NESTED && !c->line
        && kern_abs(kern_travel(c, q->mean_size)) > 0)
        return 1;
    return (len > 0 && len < q->length_min) || kern_is_gone(q, c->a)
        || kern_is_gone(q, c->b);
}

/* Writes the weight of a mass to *w. */
static void kern_weigh(kern_vec gravity, kern_real mass, kern_wrench *w)
{
    w->fx = gravity.x * mass;
    w->fy = gravity.y * mass;
    w->torque = 0;
}

/* Writes the load pattern's wrench on block i, for a factor of 1. */
static void kern_pattern_wrench(const kern_structure *s, const kern_query *q,
                                int i, kern_wrench *w)
{
    if (q->pattern)
        *w = q->pattern[i];
    else
        kern_weigh(kern_vec_turn(q->gravity),
                   s->block[i].mass * KERN_R(q->side), w);
}

/* Returns the magnitude of a force. If the squares of the components underflow,
   the result is the larger component, and not 0. */
static kern_real kern_force_size(const kern_wrench *w)
{
    const kern_vec f = kern_vec_make(w->fx, w->fy);
    return kern_max(kern_vec_length(f), kern_vec_largest(f));
}

/* Adds a share of a wrench on block b to `sum`. Returns the magnitude of the
   addend. */
static kern_real kern_wrench_add(kern_wrench *sum, const kern_block *b,
                                 const kern_wrench *w, kern_real share)
{
    if (!(kern_wrench_sum(w) > 0))
        return 0;
    kern_add(sum, share, w, 3);
    return share
         * (kern_force_size(w) + kern_abs(w->torque) / kern_block_size(b));
}

/* Writes the sum of all wrenches on block i except those of its contacts to
   *sum. Returns the sum of their magnitudes, by which the residual of the block
   is scaled. */
static inline kern_real kern_block_wrench(const kern_structure *s,
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
    kern_pattern_wrench(s, q, i, &pattern);
    return size + kern_wrench_add(sum, b, &pattern, q->factor);
}

/* Returns how far along t a shrinkage moves a contact point. Writes the
   derivative of this distance by the shrinkage to *rate. */
static kern_real kern_shift(kern_real travel, kern_real shrink, int relative,
                            kern_real *rate)
{
    const kern_real sign = travel > 0 ? 1 : travel < 0 ? -1 : 0;
    const int closed = !relative && shrink >= kern_abs(travel);
    *rate = relative ? travel : closed ? 0 : sign;
    return relative ? kern_min(shrink, 1) * travel
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

/* Writes the arms from the centres of blocks a and b to the place where contact
   c acts. Returns how far along t the shrinkage has moved the contact. The
   centre of a block is subtracted from the place of the contact before the
   motion of the contact is added, since far from the origin a place has fewer
   digits than an arm. The library spends a tenth of its time here. */
static inline kern_real kern_arms(const kern_structure *s,
                                  const kern_contact *c, const kern_query *q,
                                  kern_vec arm[2])
{
    kern_real rate;
    const kern_real shift = kern_shift(kern_travel(c, q->mean_size), q->shrink,
                                       q->relative, &rate);
    const kern_vec way = kern_vec_scale(kern_vec_turn(c->n), shift);
    arm[0] = kern_vec_add(kern_vec_sub(c->p, s->block[c->a].centre), way);
    arm[1] = kern_vec_add(kern_vec_sub(c->p, s->block[c->b].centre), way);
    return shift;
}

/* Returns the velocity of block b relative to block a where contact point c
   acts. */
static kern_vec kern_meeting_motion(const kern_structure *s,
                                    const kern_query *q, const kern_contact *c,
                                    const kern_motion *motion)
{
    kern_vec arm[2];
    kern_arms(s, c, q, arm);
    return kern_vec_sub(kern_velocity(motion + c->b, arm[1]),
                        kern_velocity(motion + c->a, arm[0]));
}

/* Returns 1 if contact points i and i + 1 are the ends of a line. */
static int kern_line_begins(const kern_contact *contact, int contacts, int i)
{
    const kern_contact *c = contact + i;
    return i + 1 < contacts && c->line && c[1].line && c->a == c[1].a
        && c->b == c[1].b;
}

/* Returns 1 if two contacts are between the same blocks. */
static int kern_same_blocks(const kern_contact *c, const kern_contact *d)
{
    return (c->a == d->a && c->b == d->b) || (c->a == d->b && c->b == d->a);
}

/* Returns 1 if contact d is a point between the blocks of contact c. */
KERN_SHARED static int kern_same_interface(const kern_contact *c,
                                           const kern_contact *d)
{
    return !d->line && kern_same_blocks(c, d);
}

/* ---- Work arrays ------------------------------------------------- >>work */
/* kern_take is the part of the work memory that is still free. Slices are taken
   from it one after the other. If a slice does not fit, the count of free
   numbers or indices becomes -1 and stays negative. That slice and all later
   ones must not be used. */

typedef struct kern_take {
    kern_real *real;
    int *index;
    int reals, indices;
} kern_take;

/* Writes to *take that the whole work memory of a call is free. */
KERN_SHARED static void kern_take_open(kern_take *take, const kern_work *work)
{
    const kern_take memory = {work->real, work->index, work->reals,
                              work->indices};
    *take = memory;
}

/* Take a slice of n numbers, or of n indices, and return it. If the slice does
   not fit, the count becomes negative. */
static kern_real *kern_take_reals(kern_take *take, int n)
{
    kern_real *const slice = take->real;
    KERN_ASSERT(n >= 0);
    take->real += n <= take->reals ? n : 0;
    take->reals = n <= take->reals ? take->reals - n : KERN_OUT;
    return slice;
}

static int *kern_take_ints(kern_take *take, int n)
{
    int *const slice = take->index;
    take->index += n <= take->indices ? n : 0;
    take->indices = n <= take->indices ? take->indices - n : KERN_OUT;
    return slice;
}

/* Takes a slice of n numbers from the end of the free memory. */
static kern_real *kern_take_last(kern_take *take, int n)
{
    take->reals -= n;
    return take->real + take->reals;
}

/* Returns 1 if every slice so far has fitted. */
static int kern_take_fits(const kern_take *take)
{
    return take->reals >= 0 && take->indices >= 0;
}

/* ---- what a call may spend ---- */

/* Returns the limit of work [units]; options.limit = 0 means the largest. */
static int kern_limit_of(int limit)
{
    return limit > 0 ? limit : KERN_WORK_MOST;
}

KERN_SHARED static void kern_fault_clear(kern_fault *fault)
{
    fault->block = fault->other = fault->index = -1;
    fault->value = fault->allowed = 0;
}

static void kern_work_begin(kern_work *work)
{
    kern_fault_clear(&work->fault);
    work->units = 0;
}

/* Adds the units of some work to work->units before it is done. Returns 0 if
   the limit of the call is then exceeded: this work and all further work is
   refused, and the call ends. */
static int kern_spend(kern_work *work, int limit, int units)
{
    const int rest = kern_limit_of(limit) - work->units;
    KERN_ASSERT(units >= 0);
    work->units += units <= rest ? units : rest + 1;
    return units <= rest;
}

/* Returns the status of a call: KERN_LIMIT if work was refused, otherwise
   `status`. */
static kern_status kern_call_status(const kern_task *task, kern_status status)
{
    return task->work->units > kern_limit_of(task->options.limit) ? KERN_LIMIT
                                                                  : status;
}

/* ---- Checks of arguments ---------------------------------------- >>check */
/* All input of the statics is checked once, before any work memory is used:
   numbers are within bounds, indices exist, normals have length 1. */

/* Checks the options. */
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
        || o->narrow < 0 || o->reserve < 0 || o->reserve > KERN_RESERVE_MOST
        || o->epsilon < 0 || o->limit < 0 || o->limit > KERN_WORK_MOST)
        return KERN_BAD_OPTION;
    return KERN_OK;
}

/* Checks a contact, except the length of its normal. */
static inline kern_status kern_contact_check(const kern_contact *c, int blocks)
{
    if ((unsigned)c->a >= (unsigned)blocks
        || (unsigned)c->b >= (unsigned)blocks)
        return KERN_BAD_BLOCK;
    if (c->a == c->b)
        return KERN_SAME_BLOCK;
    if (!kern_vec_is_moderate(c->p)
        || !(kern_abs(c->travel) <= KERN_FAR)
        /* the sum is NaN if one of these is not finite */
        || !kern_is_finite(0 * c->n.x + 0 * c->n.y + 0 * c->mu))
        return KERN_BAD_NUMBER;
    return c->mu < 0 ? KERN_BAD_FRICTION : KERN_OK;
}

/* Checks a block. Sets *loaded if the block is free and a weight or load acts
   on it. */
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
    if (!(size >= KERN_SIZE_LEAST))
        return KERN_NO_AREA;
    if (!(b->mass >= KERN_MASS_LEAST) || b->mass > KERN_MASS_MOST)
        return kern_is_finite(b->mass) ? KERN_BAD_MASS : KERN_BAD_NUMBER;
    *loaded |= acts > 0;
    return acts <= KERN_FAR && (acts >= KERN_LOAD_LEAST || !(acts > 0))
             ? KERN_OK
             : KERN_BAD_NUMBER;
}

/* Checks the contents of the arrays of a structure. */
static kern_status kern_structure_check(const kern_structure *s,
                                        kern_fault *fault)
{
    kern_status status;
    int i, has_free = 0, loaded = 0;
    for (i = 0; i < s->blocks; i++) {
        status = kern_block_check(s->block + i, s->gravity, &loaded);
        if (status != KERN_OK) {
            fault->block = i;
            return status;
        }
        has_free |= !s->block[i].fixed;
    }
    if (!has_free || !loaded)
        return has_free ? KERN_NO_LOAD : KERN_NO_FREE;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        status = kern_contact_check(c, s->blocks);
        if (status == KERN_OK
            && kern_abs(kern_vec_dot(c->n, c->n) - 1) > KERN_NORMAL_TOL)
            status = KERN_BAD_NORMAL;
        if (status != KERN_OK) {
            fault->index = i;
            return status;
        }
    }
    return KERN_OK;
}

/* Checks all arguments except the contents of the arrays. `out` is the address
   of the caller's result; a function without a result passes the task instead.
   Clears the units and the fault of the work memory. It does not clear the
   other counters, which add up over calls. */
static kern_status kern_task_check(const kern_task *task, kern_real shrink,
                                   const void *out)
{
    const kern_structure *s;
    kern_status status;
    if (!task || !task->work || !task->work->real || !task->work->index || !out)
        return KERN_BAD_POINTER;
    s = &task->s;
    /* the count is a status of kern_contacts(): its fault is kept */
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

/* Writes the query of a task with kerns shrunk by `shrink`, and checks the
   contents of the arrays. */
static kern_status kern_query_read(const kern_task *task, kern_real shrink,
                                   kern_query *q)
{
    kern_status status;
    q->shrink = shrink;
    q->relative = task->options.relative;
    q->narrow = task->options.narrow;
    q->mean_size = kern_mean_size(task->s.block, task->s.blocks);
    q->gravity = task->s.gravity;
    q->pattern = NULL;
    q->factor = q->length_min = 0;
    q->loads = 1;
    q->side = 0;
    q->fallen = NULL;
    q->carry = KERN_CARRY_ALL;
    status = kern_structure_check(&task->s, &task->work->fault);
    return status == KERN_OK && q->relative && shrink > 1 ? KERN_BAD_SHARE
                                                          : status;
}

/* Checks all arguments and writes the query. */
static kern_status kern_query_check(const kern_task *task, kern_real shrink,
                                    const void *out, kern_query *q)
{
    const kern_status status = kern_task_check(task, shrink, out);
    return status == KERN_OK ? kern_query_read(task, shrink, q) : status;
}

/* Checks the caller's linear program. */
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
/* The check of a proof reads only the caller's data and the proof. The error of
   a proof is a share of the allowed error. A proof holds if its error is at
   most 1.

   Forces prove that a structure stands if three conditions hold. Each force
   lies in its friction cone. The residual of each equation of equilibrium of a
   block is at most KERN_TOL times the loads on the block plus the rounding of
   its contact forces. The sum of all forces is at most KERN_BOUND times the
   total weight.

   A motion proves that a structure falls if the power of the loads is larger
   than the sum of two terms. The first is the rounding error of the power. The
   second is KERN_BOUND times the weight of the blocks that move, times the
   highest speed at which the motion closes a contact. So contact forces cannot
   stop the motion if their sum is at most KERN_BOUND times that weight. The
   speed includes a bound of its own rounding error, so the proof also holds in
   exact arithmetic. */

/* Returns the error of equilibrium as a share of the allowed error. This is the
   larger of two shares: the largest residual of a free block divided by the
   allowed residual, and the sum `total` of all normal forces divided by the
   allowed sum. `sum` has four numbers per block, which kern_prove_end() has
   added up. If the error is above 1, the result is at least 2. */
static kern_real kern_prove_rows(const kern_structure *s, const kern_query *q,
                                 const kern_real *sum, kern_real total)
{
    kern_real error = 0, weight = 0;
    int i;

    /* Finds the largest residual of a row of a free block, as a share of the
       allowed residual. */
    for (i = 0; i < s->blocks; i++, sum += 4)
        if (!s->block[i].fixed && !kern_is_gone(q, i)) {
            kern_wrench w;
            const kern_real size = kern_block_wrench(s, q, i, &w);
            const kern_real x = kern_abs(sum[0] + w.fx);
            const kern_real y = kern_abs(sum[2] + w.fy);
            const kern_real turn = kern_abs(sum[1] + w.torque)
                                 / kern_block_size(s->block + i);
            const kern_real residual = kern_max(kern_max(x, y), turn);
            weight += size;
            if (!kern_is_finite(x + y + turn))
                return KERN_INFINITY;
            if (residual > 0)
                error = kern_max(
                    error,
                    residual / (KERN_TOL * size + KERN_ROUNDING * sum[3]));
        }

    /* Computes the sum of the forces as a share of the largest allowed sum. */
    weight *= KERN_BOUND;
    if (!kern_is_finite(weight)) /* a bound that would allow any forces */
        return KERN_INFINITY;
    if (total > 0)
        error = kern_max(error, total / weight);
    return error <= 1 ? error : kern_max(error, 2);
}

/* Adds a force with the normal component f to the four numbers of a block: the
   sums of fx, torque and fy, and the largest f. */
KERN_SHARED static void kern_prove_end(kern_real *sum, kern_vec arm,
                                       kern_real fx, kern_real fy, kern_real f)
{
    sum[0] += fx;
    sum[1] += arm.x * fy - arm.y * fx;
    sum[2] += fy;
    sum[3] = kern_max(sum[3], f);
}

/* Returns the error of forces as a proof that the structure stands, as a share
   of the allowed error. Returns KERN_INFINITY if a force is outside its cone or
   not finite. `sum` is scratch, four numbers per block. */
static kern_real kern_prove_forces(const kern_structure *s, const kern_query *q,
                                   const kern_force *force, kern_real *sum)
{
    const kern_real reduction = kern_reduction(q);
    kern_real total = 0;
    int i;
    KERN_ASSERT(force && sum);
    kern_zero(sum, 4 * s->blocks);

    /* Checks that each force is in its cone, and adds its wrenches to its two
       blocks. */
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real f = force[i].normal, r = force[i].tangential;
        const kern_real fx = f * c->n.x - r * c->n.y;
        const kern_real fy = f * c->n.y + r * c->n.x;
        kern_vec arm[2];
        if (kern_is_idle(q, c))
            continue;
        if (!(f >= 0)
            || !(kern_abs(r)
                 <= kern_friction(c, reduction) * f * (1 + KERN_CONE_TOL)))
            return KERN_INFINITY; /* not in its cone */
        if (!(f > 0))
            continue;
        kern_arms(s, c, q, arm);
        kern_prove_end(sum + 4 * c->a, arm[0], -fx, -fy, f);
        kern_prove_end(sum + 4 * c->b, arm[1], fx, fy, f);
        total += f;
    }

    /* Checks the residuals of equilibrium. */
    return kern_prove_rows(s, q, sum, total);
}

/* Returns an upper bound of the speed at which a motion closes contact c. A
   force in the cone with a normal component of 1 takes at most this power out
   of the motion. The bound includes rounding errors: each operation may lose
   KERN_EPS / 2 of its result, an arm takes three operations, and the spin
   multiplies the error of the arm. */
static kern_real kern_closing(const kern_structure *s, const kern_contact *c,
                              const kern_query *q, const kern_motion *motion)
{
    kern_vec arm[2], v = kern_vec_make(0, 0), rounding = v;
    const kern_real shift = kern_abs(kern_arms(s, c, q, arm));
    const kern_real mu = kern_friction(c, kern_reduction(q));
    const kern_real nx = kern_abs(c->n.x), ny = kern_abs(c->n.y);
    kern_real gap;
    int end;
    for (end = 0; end < 2; end++) { /* v: velocity of b minus that of a */
        const kern_motion *m = motion + (end ? c->b : c->a);
        const kern_vec u = kern_velocity(m, arm[end]);
        const kern_real spin = 3 * kern_abs(m->spin);
        v = kern_vec_sub(u, v);
        rounding.x += kern_abs(u.x)
                    + spin * (kern_abs(arm[end].y) + shift * nx);
        rounding.y += kern_abs(u.y)
                    + spin * (kern_abs(arm[end].x) + shift * ny);
    }
    rounding.x += 5 * kern_abs(v.x);
    rounding.y += 5 * kern_abs(v.y);
    gap = nx * rounding.x + ny * rounding.y
        + mu * (nx * rounding.y + ny * rounding.x);
    return mu * kern_abs(kern_vec_cross(c->n, v)) - kern_vec_dot(c->n, v)
         + KERN_EPS / 2 * gap + KERN_POWER_LEAST;
}

/* Returns a norm of a motion: 0 only if the block rests. */
static kern_real kern_speed(const kern_motion *m) { return kern_wrench_sum(m); }

/* Returns the larger of the speed of a block's centre and its spin times its
   size. */
static kern_real kern_block_speed(const kern_block *b, const kern_motion *v)
{
    return kern_max(kern_vec_length(kern_vec_make(v->vx, v->vy)),
                    kern_abs(v->spin) * kern_block_size(b));
}

/* Scales a motion so that kern_block_speed() of the fastest block is 1. */
static void kern_motion_scale(const kern_structure *s, kern_motion *v)
{
    kern_real fastest = 0;
    int i;
    for (i = 0; i < s->blocks; i++)
        fastest = kern_max(fastest, kern_block_speed(s->block + i, v + i));
    if (fastest > 0)
        kern_scale(v, 3 * s->blocks, 1 / fastest);
}

/* Returns the sum of kern_speed() for both blocks of a contact. */
static kern_real kern_speeds(const kern_contact *c, const kern_motion *motion)
{
    return kern_speed(motion + c->a) + kern_speed(motion + c->b);
}

/* Returns the error of a motion as a proof that the structure falls, as a share
   of the allowed error. Returns KERN_INFINITY if the motion proves nothing. */
static kern_real kern_prove_motion(const kern_structure *s, const kern_query *q,
                                   const kern_motion *motion)
{
    kern_real power = 0, terms = power, weight = power, closing = power;
    int i, first = -1; /* the first block that moves */

    /* Sums the power of the loads on the moving blocks, the magnitudes of its
       terms, which bound its rounding, and the weight of the moving blocks. */
    for (i = 0; i < s->blocks; i++) {
        const kern_motion *m = motion + i;
        kern_wrench w, p;
        const kern_real speed = kern_speed(m);
        if (speed <= 0)
            continue;
        first = first < 0 ? i : first;
        if (s->block[i].fixed || !kern_is_finite(speed))
            return KERN_INFINITY;
        weight += kern_block_wrench(s, q, i, &w);
        p.fx = w.fx * m->vx;
        p.fy = w.fy * m->vy;
        p.torque = w.torque * m->spin;
        power += p.fx + p.fy + p.torque;
        terms += kern_wrench_sum(&p);
    }

    /* The power must be above 0 despite rounding. */
    weight *= KERN_BOUND;
    if (!(power > KERN_POWER_LEAST) || !kern_is_finite(terms + weight))
        return KERN_INFINITY;

    /* Finds the highest speed at which the motion closes a contact. Begins with
       the contacts of the last stone, which are the most likely to stop the
       motion. */
    for (i = s->contacts - 1; i >= 0 && weight * closing <= power; i--) {
        const kern_contact *c = s->contact + i;
        if ((c->a >= first || c->b >= first) && kern_speeds(c, motion) > 0
            && !kern_is_idle(q, c)) {
            const kern_real speed = kern_closing(s, c, q, motion);
            closing = kern_is_finite(speed) ? kern_max(closing, speed)
                                            : KERN_INFINITY;
        }
    }

    /* Returns the power that contact forces and rounding could take, as a share
       of the power of the loads. */
    return (weight * closing + KERN_ROUNDING * terms) / power;
}

/* Returns the error of forces and of the displacement that raises them, as a
   share of the allowed error. The proof requires that the blocks of each loaded
   contact approach each other. It also requires that a contact slides only if
   its force lies on the edge of the friction cone, and only against the
   friction. Forces and displacement are then a solution for some stiffness of
   each contact, which is its force divided by its approach. */
static kern_real kern_prove_raised(const kern_structure *s, const kern_query *q,
                                   const kern_force *force,
                                   const kern_motion *motion, kern_real *sum)
{
    kern_real error = kern_prove_forces(s, q, force, sum);
    kern_real lightest = KERN_INFINITY;
    kern_wrench w;
    int i;

    /* Checks that fixed blocks rest, and finds the least load on a block:
       equilibrium does not need forces that are far smaller. */
    for (i = 0; i < s->blocks; i++)
        if (!s->block[i].fixed)
            lightest = kern_min(lightest, kern_block_wrench(s, q, i, &w));
        else if (!(kern_speed(motion + i) <= 0))
            return KERN_INFINITY;

    /* Checks each loaded contact. The contact must approach by more than the
       rounding of its blocks' motions. With a force inside the cone it must
       stick. With a force on the cone it must slide against the friction. */
    for (i = 0; i < s->contacts && error <= 1; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real f = force[i].normal, r = force[i].tangential;
        const kern_vec u = kern_meeting_motion(s, q, c, motion);
        const kern_real mu = kern_friction(c, kern_reduction(q));
        const kern_real approach = -kern_vec_dot(c->n, u);
        const kern_real slide = kern_vec_cross(c->n, u);
        if (!(f > KERN_PRESSED_LEAST
                      * lightest)) /* equilibrium does not need it */
            continue;
        if (!(approach
              > KERN_ROUNDING
                    * (kern_block_speed(s->block + c->a, motion + c->a)
                       + kern_block_speed(s->block + c->b, motion + c->b))))
            return KERN_INFINITY;
        if (kern_abs(r) < mu * f * (1 - KERN_SLIDES_TOL) || r * slide > 0)
            error = kern_max(error, kern_abs(slide) / (KERN_STICKS * approach));
    }
    return error;
}

/* Finds the blocks that hang among the set of blocks i with value[i] >= 0.
   Removes from this set each block that is fixed, that has a load, or that a
   block outside of the set holds up against gravity. Returns the number of
   blocks that are left. */
static int kern_unsupported(const kern_structure *s, kern_real *value)
{
    const kern_real pull = kern_vec_length(s->gravity);
    int k, count = 0, removed = 1;
    for (k = 0; k < s->blocks; k++) {
        if (s->block[k].fixed || !(pull > 0)
            || kern_wrench_sum(&s->block[k].load) > 0)
            value[k] = -1;
        count += value[k] >= 0;
    }
    while (removed)
        for (k = removed = 0; k < s->contacts; k++) {
            const kern_contact *c = s->contact + k;
            const kern_real lift = -kern_vec_dot(c->n, s->gravity);
            const int support = lift > 0 ? c->a : c->b,
                      b = lift > 0 ? c->b : c->a;
            if (kern_abs(lift) > KERN_HOLDS_UP * pull && value[b] >= 0
                && !(value[support] >= 0)) {
                value[b] = -1;
                removed++;
                count--;
            }
        }
    return count;
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

    /* The work memory holds the sums of the proof, and after them a mark for
       each block. */
    s = &task->s;
    kern_take_open(&take, task->work);
    sum = kern_take_reals(&take, 5 * s->blocks);
    if (!kern_take_fits(&take) || raising == KERN_NOT_SHOWN)
        return KERN_INFINITY;

    /* Forces and a displacement prove that the load is raised. */
    if (raising == KERN_RAISED)
        return kern_prove_raised(s, &q, proof->force, proof->motion, sum);

    /* The hanging blocks are those that move. Nothing may hold them up, and the
       forces must hold the other blocks without them. */
    value = sum + 4 * s->blocks;
    for (i = 0; i < s->blocks; i++) { /* every block that moves must hang */
        const int falls = kern_speed(proof->motion + i) > 0;
        value[i] = falls ? 1 : -1;
        n += falls;
    }
    if (n == 0 || kern_unsupported(s, value) != n)
        return KERN_INFINITY;
    q.fallen = value;
    return kern_prove_forces(s, &q, proof->force, sum);
}

/* ---- The model ------------------------------------------------- >>model */
/* Each free block becomes a group of three rows. Groups are numbered along
   gravity from top to bottom, so a group has a larger number than the groups
   that it carries. Fixed blocks and blocks that have been removed form the
   ground, whose number follows that of the last group. A contact belongs to its
   upper group, which is the group that it carries. */

/* Groups and the contacts between them.

   `local` tells which groups belong to the open part (>>part). This array has
   three phases. While no part is open it is KERN_OUT for every group. Before a
   part is opened it is KERN_MARKED for the groups of the next part. While a
   part is open it is the number that a group has in the part, and KERN_OUT for
   all other groups. kern_norm_open() makes an exception: it opens the groups
   with KERN_OUT and holds all others. */
typedef struct kern_graph {
    int groups;
    int *group;        /* per block: the number of its group              */
    int *block;        /* per group: the index of its block               */
    int *ends;         /* two per contact i: the groups of its blocks b
                          (2 i) and a (2 i + 1)                           */
    int *first_end;    /* per group: first end of a contact at this group */
    int *next_end;     /* per end of a contact: the next end at the same
                          group                                           */
    kern_real *torque; /* two per end: torques of unit forces along n and
                          t, as in kern_row                               */
    int *local;        /* per group: its number in the open part          */
    int *carrier;      /* per group: the only group that carries it, or
                          KERN_OUT                                        */
} kern_graph;

/* The forces and the motion of the last verdict.

   `force` has two phases. Between verdicts and in the pass it holds contact
   forces; the pass starts from them and overwrites them. While a program of all
   groups is solved it is scratch (kern_model_rays()). `scratch` belongs to the
   function that runs: no function leaves anything in it for another. */
typedef struct kern_answer {
    const kern_known *known; /* forces that held a similar structure, or NULL */
    kern_force *force;       /* one per contact: contact forces [N]          */
    kern_motion *motion;     /* one per block: the mechanism                 */
    kern_real *scratch;      /* four numbers per block                       */
} kern_answer;

/* State of a cluster. KERN_OPEN: it must be balanced. KERN_TRIED: its groups
   have been balanced as one part before. Both may be set. */
enum { KERN_OPEN = 1, KERN_TRIED = 2 };

/* A value of graph.local: the group will belong to the next part. */
enum { KERN_MARKED = 0 };

/* Clusters: disjoint sets of groups, each of which the top-down pass balances
   together. */
typedef struct kern_clusters {
    int *last;      /* per group: the last group of its cluster              */
    int *next;      /* per group: the next group of its cluster, in a ring   */
    int *flags;     /* per last group of a cluster: state of the cluster     */
    int front;      /* the last group of every open cluster is this group or
                       a later one                                           */
    int groups_max; /* largest number of groups that a cluster may have      */
    int budget_end; /* value of work->units at which the pass ends           */
    int unbalanced; /* the only group that the known forces may not balance;
                       KERN_OUT: they may not balance any group              */
} kern_clusters;

typedef struct kern_model {
    const kern_task *task; /* the caller's task */
    const kern_structure *s;
    kern_graph graph;
    kern_answer answer;
    int relative;
    kern_real mean_size;     /* mean size of the free blocks                */
    kern_real weight;        /* unit of force: sum of the loads on free
                                blocks [N]                                  */
    kern_real *torque_scale; /* per group: torques are multiplied by this, so
                                that they have the unit of forces [1/m]     */
    kern_real *load;         /* three per group: wrench that its contacts must
                                exert [N]                                   */
    kern_real *load_size;    /* per group: magnitude of its loads [N]       */
    kern_real shrunk;        /* shrinkage for which graph.torque is set;
                                infinity: none                              */
    kern_real reduction;     /* tangent of the angle by which the last query
                                narrows friction cones                      */
    kern_clusters cluster;
    int whole;        /* nonzero: all groups are open as one part */
    kern_take common; /* work memory for a program of all groups */
    kern_take rest;   /* work memory for parts                   */
} kern_model;

/* Checks at compile time that these structs can be copied, cleared and scaled
   as arrays of numbers. */
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
    const kern_work work = {real,
                            reals,
                            index,
                            indices,
                            0,
                            0,
                            0,
                            0,
                            {KERN_OUT, KERN_OUT, KERN_OUT, 0, 0},
                            KERN_END_NONE};
    return work;
}

KERN_API kern_task kern_task_of(const kern_block *block, int blocks,
                                const kern_contact *contact, int contacts,
                                kern_work *work)
{
    const kern_task task = {
        {block, blocks, contact, contacts, {0, -KERN_GRAVITY}},
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

/* Sorts the indices list[0..n) by their keys, and equal keys by index. Shell's
   sort needs neither memory nor recursion. */
static void kern_sort(int *list, int n, const kern_real *key)
{
    int gap, i, j;
    for (gap = 1; gap < n / KERN_SORT_RUN; gap = 3 * gap + 1)
        continue;
    for (; gap > 0; gap /= 3)
        for (i = gap; i < n; i++) {
            const int b = list[i];
            for (j = i; j >= gap; j -= gap) {
                const int c = list[j - gap];
                /* cppcheck-suppress arrayIndexThenCheck ; c < b breaks ties */
                if (key[c] < key[b] || (key[c] <= key[b] && c < b))
                    break;
                list[j] = c;
            }
            list[j] = b;
        }
}

/* Sorts the blocks of all groups along gravity, and blocks of equal height from
   side to side. If rounding errors decided the order of blocks of equal height,
   few columns of a flat arch would be own columns of their groups (>>lp). In
   float rounding is too large for an order from side to side, and blocks of
   equal height are ordered by their index. */
static void kern_model_order(const kern_model *m)
{
    const kern_block *block = m->s->block;
    const kern_vec gravity = m->s->gravity,
                   axis = KERN_PICK(0, 1) > 0
                            ? gravity
                            : kern_vec_step(gravity, KERN_LEVEL_SLOPE,
                                            kern_vec_turn(gravity));
    kern_real *const height = m->answer.scratch; /* one per block */
    int i;
    for (i = 0; i < m->s->blocks; i++)
        height[i] = kern_vec_dot(block[i].centre, axis);
    kern_sort(m->graph.block, m->graph.groups, height);
}

/* Sets all forces to 0. */
static void kern_model_unload(kern_model *m)
{
    kern_zero(m->answer.force, 2 * m->s->contacts);
}

/* Returns an array of two numbers for each contact, one for each edge of its
   friction cone, for programs of all groups. The array uses the memory of
   answer.force, which means nothing until kern_part_forces() writes it
   again. */
static kern_real *kern_model_rays(const kern_model *m)
{
    return (kern_real *)(void *)m->answer.force;
}

/* Makes a group of every free block that has not been removed, and lists the
   contacts of each group. */
static void kern_model_group(kern_model *m, const kern_query *q)
{
    kern_graph *const graph = &m->graph;
    const kern_structure *s = m->s;
    int i, g, groups = 0;

    /* Lists the free blocks as groups. Resets all data of the last groups:
       torques, forces, and the group that the pass must balance again. */
    for (i = s->blocks - 1; i >= 0; i--)
        if (!s->block[i].fixed && !kern_is_gone(q, i))
            graph->block[groups++] = i;
    graph->groups = groups;
    m->shrunk = KERN_INFINITY;
    m->cluster.unbalanced = KERN_OUT;
    m->whole = 0;
    kern_model_unload(m);
    kern_model_order(m);

    /* Numbers the groups in their order. The ground has the number after the
       last group. */
    for (i = 0; i < s->blocks; i++)
        graph->group[i] = groups;
    for (g = 0; g < groups; g++) {
        graph->group[graph->block[g]] = g;
        graph->first_end[g] = KERN_OUT;
    }

    /* Sets the groups at both ends of each contact. A contact that carries
       nothing has both ends on the ground. */
    for (i = s->contacts - 1; i >= 0; i--) {
        const kern_contact *c = s->contact + i;
        const int gone = kern_is_idle(q, c);
        graph->ends[2 * i] = gone ? groups : graph->group[c->b];
        graph->ends[2 * i + 1] = gone ? groups : graph->group[c->a];
    }

    /* Chains the ends at each group, from the first contact to the last. */
    for (i = 2 * s->contacts - 1; i >= 0; i--) { /* i is an end */
        g = graph->ends[i];
        if (g < groups) {
            graph->next_end[i] = graph->first_end[g];
            graph->first_end[g] = i;
        }
    }
}

/* Opens the model of a task for a query: takes the arrays of the model and
   makes its groups. The data of the task must have been checked. Returns
   KERN_NO_SPACE if the work memory is too small. */
static kern_status kern_model_open(kern_model *m, const kern_task *task,
                                   const kern_query *q)
{
    kern_graph *const graph = &m->graph;
    const kern_structure *s = &task->s;
    kern_take *const take = &m->rest;
    int i, groups = 0;

    /* Counts the free blocks. Later queries may remove blocks, but never add
       one. */
    for (i = 0; i < s->blocks; i++)
        groups += !s->block[i].fixed;

    /* Takes the arrays that every method needs. A program of all groups uses
       the memory from `common` on. */
    KERN_ASSERT(groups > 0);
    kern_take_open(take, task->work);
    graph->group = kern_take_ints(take, s->blocks + groups);
    graph->block = graph->group + s->blocks;
    graph->ends = kern_take_ints(take, 2 * s->contacts);
    m->load = kern_take_reals(take, 5 * groups + 1);
    m->load_size = m->load + 3 * groups;
    m->torque_scale = m->load_size + groups;
    m->answer.force = (kern_force *)(void *)kern_take_reals(take,
                                                            2 * s->contacts);
    m->answer.scratch = kern_take_reals(take, 7 * s->blocks);
    m->answer.motion = (kern_motion *)(void *)(m->answer.scratch
                                               + 4 * s->blocks);
    m->common = *take;

    /* Takes the arrays of the top-down pass and of parts. */
    graph->first_end = kern_take_ints(take, 6 * groups + 1);
    graph->carrier = graph->first_end + groups;
    m->cluster.last = graph->carrier + groups;
    m->cluster.next = m->cluster.last + groups;
    m->cluster.flags = m->cluster.next + groups;
    graph->local = m->cluster.flags + groups;
    graph->next_end = kern_take_ints(take, 2 * s->contacts);
    graph->torque = kern_take_reals(take, 4 * s->contacts);
    if (!kern_take_fits(take))
        return KERN_NO_SPACE;

    m->task = task;
    m->s = s;
    m->relative = task->options.relative;
    m->mean_size = q->mean_size;
    m->answer.known = NULL;
    kern_model_group(m, q);
    return KERN_OK;
}

/* The row of a contact at one of its two ends: the coefficients of the contact
   in the three equations of the group at that end.
   The row maps a motion of the group to speeds along n and t, and forces along
   n and t to a wrench. Every method that looks for forces uses these rows.
   The checks of proofs have code of their own, so that they share no mistake
   with the code of rows. */
typedef struct kern_row {
    kern_real n[3];   /* wrench of a unit force along n           */
    kern_real torque; /* torque of a unit force along t, whose wrench is
                         (-n[1], n[0], torque)                    */
} kern_row;

/* Returns the row of a normal n that acts at an arm. Torques are multiplied by
   `unit`. */
static inline kern_row kern_row_of(kern_vec n, kern_vec arm, kern_real unit)
{
    const kern_row row = {{n.x, n.y, kern_vec_cross(arm, n) * unit},
                          kern_vec_dot(arm, n) * unit};
    return row;
}

/* w += the speeds along n and t that motion v of the group gives to the
   contact. */
static inline void kern_row_speed(const kern_row *c, const kern_real *v,
                                  kern_real w[2])
{
    w[0] += c->n[0] * v[0] + c->n[1] * v[1] + c->n[2] * v[2];
    w[1] += c->n[0] * v[1] - c->n[1] * v[0] + c->torque * v[2];
}

/* w := the wrench of forces f along n and r along t. */
static inline void kern_row_wrench(const kern_row *c, kern_real f, kern_real r,
                                   kern_real w[3])
{
    w[0] = f * c->n[0] - r * c->n[1];
    w[1] = f * c->n[1] + r * c->n[0];
    w[2] = f * c->n[2] + r * c->torque;
}

/* b += the wrench of forces f along n and r along t. */
static inline void kern_row_exert(const kern_row *c, kern_real f, kern_real r,
                                  kern_real *b)
{
    b[0] += f * c->n[0] - r * c->n[1];
    b[1] += f * c->n[1] + r * c->n[0];
    b[2] += f * c->n[2] + r * c->torque;
}

/* Writes the rows of contact i for a query: row[0] of block b, row[1] of block
   a. */
static inline void kern_model_rows(const kern_model *m, const kern_query *q,
                                   int i, kern_row row[2])
{
    const kern_contact *c = m->s->contact + i;
    kern_vec arm[2];
    kern_arms(m->s, c, q, arm);
    row[0] = kern_row_of(c->n, arm[1], m->torque_scale[m->graph.ends[2 * i]]);
    row[1] = kern_row_of(kern_vec_scale(c->n, -1), arm[0],
                         m->torque_scale[m->graph.ends[2 * i + 1]]);
}

/* Returns the row at an end, for the query last passed to kern_model_arms(). */
static inline kern_row kern_model_row(const kern_model *m, int end)
{
    const kern_vec n = m->s->contact[end >> 1].n;
    const kern_real *torque = m->graph.torque + 2 * end;
    const kern_row row = {
        {end & 1 ? -n.x : n.x, end & 1 ? -n.y : n.y, torque[0]}, torque[1]};
    return row;
}

/* Sets the reduction of friction cones for a query. Sets the torques of all
   rows, unless they have already been set for this shrinkage. */
static void kern_model_arms(kern_model *m, const kern_query *q)
{
    kern_real *torque = m->graph.torque;
    int i, end;
    m->reduction = kern_reduction(q);
    if (m->shrunk >= q->shrink && m->shrunk <= q->shrink)
        return;
    m->shrunk = q->shrink;
    for (i = 0; i < m->s->contacts; i++) {
        kern_row row[2];
        kern_model_rows(m, q, i, row);
        for (end = 0; end < 2; end++) {
            *torque++ = row[end].n[2];
            *torque++ = row[end].torque;
        }
    }
}

/* Sets the unit of a group's torques: the size of its block plus the growth of
   kerns. */
static inline void kern_model_unit(kern_model *m, const kern_query *q, int g)
{
    const kern_real size = kern_block_size(m->s->block + m->graph.block[g]);
    const kern_real growth = kern_max(-q->shrink, 0);
    m->torque_scale[g] = 1
                       / (q->relative ? size * (1 + growth) : size + growth);
}

/* Returns the friction of contact i for the query last passed to
   kern_model_arms(). */
static inline kern_real kern_model_mu(const kern_model *m, int i)
{
    return kern_friction(m->s->contact + i, m->reduction);
}

/* Sets the wrench that contacts must exert on group g: -w of Eq. (5). */
static inline void kern_model_load(kern_model *m, const kern_query *q, int g)
{
    kern_real *load = m->load + 3 * g;
    kern_wrench w;
    m->load_size[g] = kern_block_wrench(m->s, q, m->graph.block[g], &w);
    load[0] = -w.fx;
    load[1] = -w.fy;
    load[2] = -w.torque * m->torque_scale[g];
}

/* Sets the loads of all groups and the unit of force. Marks that no part is
   open. */
static void kern_model_weigh(kern_model *m, const kern_query *q)
{
    kern_real weight = 0;
    int g;
    m->torque_scale[m->graph.groups] = 0;
    for (g = 0; g < m->graph.groups; g++) {
        kern_model_unit(m, q, g);
        kern_model_load(m, q, g);
        weight += m->load_size[g];
        m->graph.local[g] = KERN_OUT;
    }
    m->graph.local[g] = KERN_OUT;
    m->weight = weight > 0 ? weight : 1;
}

/* Sets the loads, cones and torques of a query. */
static void kern_model_set(kern_model *m, const kern_query *q)
{
    kern_model_weigh(m, q);
    kern_model_arms(m, q);
}

/* Returns 1 if a free block has a load besides its weight. */
static int kern_model_loaded(const kern_model *m)
{
    int g;
    for (g = 0; g < m->graph.groups; g++)
        if (kern_wrench_sum(&m->s->block[m->graph.block[g]].load) > 0)
            return 1;
    return 0;
}

/* Returns 1 if kerns are nested: a contact that is shrunk less then carries
   every load that it carries when it is shrunk more. Kerns of lines are nested.
   Kerns of points that move toward each other along different tangents are not
   nested. Writes the shortest travel to range[0], and d_max to range[1], which
   is the longest travel (relative: 1). */
static int kern_is_nested(const kern_model *m, kern_real range[2])
{
    const int *ends = m->graph.ends, both_held = 2 * m->graph.groups;
    const kern_contact *c = m->s->contact, *const end = c + m->s->contacts;
    int points = 0;
    range[0] = KERN_INFINITY;
    range[1] = 0;
    for (; c < end; c++, ends += 2) {
        const kern_real travel = kern_abs(kern_travel(c, m->mean_size));
        if (!(travel > 0) || ends[0] + ends[1] == both_held)
            continue;
        range[0] = kern_min(range[0], travel);
        range[1] = kern_max(range[1], travel);
        points += !c->line;
    }
    if (m->relative)
        range[1] = 1;
    return points == 0;
}

/* Sets the known forces of a similar structure, or NULL if there are none. */
KERN_SHARED static void kern_model_know(kern_model *m, const kern_known *known)
{
    m->answer.known = known->fails > 0 && known->force ? known : NULL;
}

/* Charges units of work. Returns 0 if the work is refused. */
static int kern_model_spend(const kern_model *m, int units)
{
    return kern_spend(m->task->work, m->task->options.limit, units);
}

/* Charges the work of `queries` verdicts. Even for a small part a proof reads
   all blocks. Returns 0 if the work is refused. */
static int kern_model_charge(const kern_model *m, int queries)
{
    return kern_model_spend(
        m, queries * (3 + (m->s->blocks + m->s->contacts) / KERN_QUERY_UNIT));
}

/* Returns 1 if the work memory has its full size: KERN_REALS and KERN_INTS. */
static int kern_model_has_room(const kern_model *m)
{
    const kern_work *work = m->task->work;
    int reals, indices;
    kern_work_need(m->s->blocks, m->s->contacts, &reals, &indices);
    return work->reals >= reals && work->indices >= indices;
}

/* Returns 1 if a proof with this error holds, and then records the error in
   work->error if it is the largest so far. */
static int kern_model_proven(const kern_model *m, kern_real error)
{
    if (error <= 1)
        m->task->work->error = kern_max(m->task->work->error, error);
    return error <= 1;
}

/* Returns 1 if the forces of the answer prove that the structure stands. */
static int kern_answer_holds(const kern_model *m, const kern_query *q)
{
    return kern_model_proven(
        m, kern_prove_forces(m->s, q, m->answer.force, m->answer.scratch));
}

/* Moves the two forces of each line from its ends at the shrinkage `from` to
   its ends at `shrink` < `from`. The wrench of the two forces is unchanged. */
static void kern_force_transfer(kern_model *m, kern_real from, kern_real shrink)
{
    int i, k;
    for (i = 0; i < m->s->contacts; i++) {
        const kern_real travel = kern_travel(m->s->contact + i, m->mean_size);
        kern_force *f = m->answer.force + i;
        kern_real rate, arm, sum, difference, ratio;
        if (!kern_line_begins(m->s->contact, m->s->contacts, i))
            continue;
        i++;
        sum = f[0].normal + f[1].normal;
        if (!(sum > 0))
            continue;
        arm = travel - kern_shift(travel, shrink, m->relative, &rate);
        ratio = (f[0].tangential + f[1].tangential) / sum;
        difference = f[0].normal - f[1].normal;
        if (kern_abs(arm) > 0)
            difference *= (travel
                           - kern_shift(travel, from, m->relative, &rate))
                        / arm;
        for (k = 0; k < 2; k++, f++, difference = -difference) {
            f->normal = kern_max((sum + difference) / 2, 0);
            f->tangential = ratio * f->normal;
        }
    }
}

/* Copies the proof of a verdict to the caller. */
KERN_SHARED static void kern_proof_write(const kern_model *m,
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
/* Minimises cost . x where A x = rhs, x >= 0, by the revised simplex method.
   The variables are numbered: first one for each column of A, then the place
   (see kern_program), then one logical for each row. A logical is a variable
   whose column is a unit vector, and it must be zero.

   The inverse of the basis B is a product of factors:

       B^-1 = E_n ... E_2 E_1 B_0^-1.

   The rows come in threes: the equations of one group. If the program is a
   network (`ends` is given), a column has entries in the rows of one or two
   groups. The column is an own column of the upper of these groups. B_0 has
   three own columns, or logicals, of each group, so it is block triangular. For
   each group B_0 stores only a 3 x 3 inverse, and the entries of its three
   columns in the rows of other groups. Without `ends` B_0 is the unit matrix.

   Each E_i makes one more column enter the basis (the product form of the
   inverse). E_i is the unit matrix except for column p. Let alpha = B^-1 A_j
   for the entering column j, and let p be the row in which it pivots. Then
   column p of E_i is -alpha / alpha_p, with 1 / alpha_p in row p. Its entries
   are stored in threes, from the first that is not zero to the last.

   Vectors over the rows have three more entries at their end, the rows of the
   ground. The ground is the second group of a column that touches only one
   group. Its entries read as 0, and what is written to them has no effect, so
   no loop has to test for such columns. */

/* A linear program. It is dense, or its columns are those of a network: two
   columns for each contact. Columns 2 i and 2 i + 1 touch the groups ends[2 i]
   and ends[2 i + 1]; the number rows / 3 is the ground. Such a column has four
   entries (u, v, r, s): (u, v, r) in the rows of the first of these groups,
   (-u, -v, s) in those of the second.

   The place on a path (>>kern) is one more variable. Its column is `rate`, and
   its value is the distance by which rhs has moved along the path. */
typedef struct kern_program {
    int rows, cols;
    const kern_real *a; /* dense: all entries, by columns; network: the four
                           entries of each column                      */
    const kern_real *rhs;
    const kern_real *cost; /* NULL: all costs are 0                      */
    const int *ends;       /* groups of the columns of a network (see above);
                              NULL: the program is dense                 */
    const kern_real *rate; /* column of the place: minus the rate of rhs */
    int follow;            /* 1: the place grows from 0; 0: it is fixed  */
    kern_real bound;       /* largest value of a variable; 0: no bound   */
    int limit;             /* largest value of work->units               */
    kern_work *work;       /* work memory of the call                    */
} kern_program;

/* The inverse of a basis: the inverse of B_0, group by group, and the factors
   E_i. Each row of B_0 has six numbers: a row of the inverse of its group, and
   the entries of its column in the three rows of the other group. `other_row`
   is the first of these rows. */
typedef struct kern_factors {
    int padded_rows;     /* number of rows, rounded up to a multiple of
                            three                                           */
    int groups;          /* number of groups of B_0; 0 if B_0 is the unit
                            matrix                                          */
    kern_real *column;   /* per row: the six numbers of B_0                 */
    int *other_row;      /* per row: first row of its column's other group  */
    int count_max, room; /* largest number of factors, and of their entries */
    int count;           /* number of factors E_i                           */
    int *pivot;          /* per factor: the row of its pivot                */
    int *first_row;      /* per factor: its first row with an entry         */
    int *first_entry;    /* per factor: index of its first entry; one more
                            index is the end of the last factor             */
    kern_real *entry;    /* entries of all factors, for three rows at a time */
} kern_factors;

typedef enum kern_basis {
    KERN_BASIS_NONE,  /* there is no basis: the next solve makes one    */
    KERN_BASIS_STALE, /* there is a basis, but its columns have changed since
                         it was factored                                */
    KERN_BASIS_READY  /* the factors of the basis are valid             */
} kern_basis;

/* Solvers that may be used. KERN_SOLVER_ANY: also GLPK, if KERN_USE_GLPK is
   defined. KERN_SOLVER_BUILTIN: only the simplex method of this chapter. */
typedef enum kern_solver { KERN_SOLVER_ANY, KERN_SOLVER_BUILTIN } kern_solver;

/* `alpha` and `list` are scratch: no phase reads values that another phase left
   there. While a crash basis is made, `alpha` is the load that is not carried
   yet. During refinement `alpha` is a residual, and otherwise the entering
   column in terms of the basis. While a crash basis is made, `list` has the
   first column of each group. During a factorisation `list` has the columns
   that are still to be entered, and during a ratio test the rows that it
   compares. */
typedef struct kern_simplex {
    const kern_program *lp;
    kern_basis basis;
    kern_factors factors;
    int *base;        /* per row: the basic variable of this row             */
    int *basic_row;   /* per column, and for the place: the row in which it is
                         basic, or KERN_OUT; while a crash basis is made: the
                         next column of the same group                       */
    kern_real *value; /* per row: value of its basic variable                */
    kern_real *slope; /* per row: c of its basic variable (see "pivots")     */
    kern_real *price; /* per row: the price y of this row                    */
    kern_real *alpha; /* per row: scratch, see above                         */
    kern_real *ratio; /* per row of the ratio test: the step after which its
                         variable is zero                                    */
    int *list;        /* per row: scratch, see above                         */

    int entering;        /* the entering column                          */
    kern_real tolerance; /* smallest violation that counts               */
    kern_real gain;      /* c_j - y.A_j of the entering column           */
    int refined;         /* 1: no pivot since the values were refined    */
    int violated;        /* number of basic variables in violation       */
} kern_simplex;

/* ---- columns ---- */

/* Returns column j of a dense program, or the column of the place. */
static const kern_real *kern_lp_dense(const kern_program *lp, int j)
{
    return j == lp->cols ? lp->rate : lp->a + j * lp->rows;
}

/* Returns the product of y with column j, or with the column of the place. */
static inline kern_real kern_lp_dot(const kern_program *lp, int j,
                                    const kern_real *y)
{
    if (lp->ends && j < lp->cols) {
        const kern_real *h = y + 3 * lp->ends[j & ~1];
        const kern_real *t = y + 3 * lp->ends[j | 1];
        const kern_real *c = lp->a + 4 * j;
        return c[0] * (h[0] - t[0]) + c[1] * (h[1] - t[1]) + c[2] * h[2]
             + c[3] * t[2];
    }
    return kern_dot(kern_lp_dense(lp, j), y, lp->rows);
}

/* One of the two groups of a column. KERN_LP_END_OWN: the upper group, of which
   it is an own column. KERN_LP_END_OTHER: the other group. */
typedef enum kern_lp_end { KERN_LP_END_OWN, KERN_LP_END_OTHER } kern_lp_end;

/* Writes to `out` the three entries that column j has in the rows of one of its
   groups. Returns the first of these rows. */
static inline int kern_lp_part(const kern_program *lp, int j, kern_lp_end side,
                               kern_real out[3])
{
    const int *ends = lp->ends + (j & ~1);
    const int end = (ends[1] < ends[0]) ^ (int)side;
    const kern_real *c = lp->a + 4 * j;
    out[0] = end ? -c[0] : c[0];
    out[1] = end ? -c[1] : c[1];
    out[2] = c[2 + end];
    return 3 * ends[end];
}

/* v -= s times the column of variable j. */
static void kern_lp_subtract(const kern_program *lp, int j, kern_real s,
                             kern_real *v)
{
    if (j > lp->cols)
        v[j - lp->cols - 1] -= s;
    else if (!lp->ends || j == lp->cols)
        kern_add(v, -s, kern_lp_dense(lp, j), lp->rows);
    else {
        kern_real *h = v + 3 * lp->ends[j & ~1], *t = v + 3 * lp->ends[j | 1];
        const kern_real *c = lp->a + 4 * j, x = s * c[0], y = s * c[1];
        h[0] -= x;
        h[1] -= y;
        h[2] -= s * c[2];
        t[0] += x;
        t[1] += y;
        t[2] -= s * c[3];
    }
}

/* ---- the basis ---- */

/* v := B^-1 v. Before the call v has one number per row, and afterwards one
   number per basic variable. */
static void kern_basis_solve(const kern_simplex *sx, kern_real *v)
{
    const kern_factors *f = &sx->factors;
    int e, g, k;

    /* Multiplies v by B_0^-1, from the top group to the bottom one. Solves the
       rows of each group for its own columns, and subtracts the entries that
       these columns have in the rows of other groups, times their values. */
    for (g = 0; g < f->groups; g++) {
        const kern_real *d = f->column + 18 * g;
        kern_real *own_rows = v + 3 * g;
        const kern_real b[3] = {own_rows[0], own_rows[1], own_rows[2]};
        if (kern_abs(b[0]) + kern_abs(b[1]) + kern_abs(b[2]) <= 0)
            continue;
        for (k = 0; k < 3; k++, d += 6) {
            const kern_real x = d[0] * b[0] + d[1] * b[1] + d[2] * b[2];
            kern_real *other_rows = v + f->other_row[3 * g + k];
            own_rows[k] = x;
            other_rows[0] -= x * d[3];
            other_rows[1] -= x * d[4];
            other_rows[2] -= x * d[5];
        }
    }

    /* Multiplies v by E_1 to E_n: each adds a multiple of its column to v. */
    for (e = 0; e < f->count; e++) {
        const kern_real x = v[f->pivot[e]], *a;
        kern_real *w;
        if (kern_abs(x) <= 0)
            continue;
        v[f->pivot[e]] = 0;
        w = v + f->first_row[e];
        for (a = f->entry + f->first_entry[e];
             a < f->entry + f->first_entry[e + 1]; a += 3, w += 3) {
            w[0] += x * a[0];
            w[1] += x * a[1];
            w[2] += x * a[2];
        }
    }
}

/* c := B^-T c. Before the call c has one number per basic variable, and
   afterwards one number per row, with zeros after the last row. */
static void kern_basis_solve_t(const kern_simplex *sx, kern_real *c)
{
    const kern_factors *f = &sx->factors;
    int e, g, k;
    kern_zero(c + sx->lp->rows, f->padded_rows + 3 - sx->lp->rows);
    for (e = f->count - 1; e >= 0; e--)
        c[f->pivot[e]] = kern_dot(f->entry + f->first_entry[e],
                                  c + f->first_row[e],
                                  f->first_entry[e + 1] - f->first_entry[e]);
    for (g = f->groups - 1; g >= 0; g--) {
        const kern_real *d = f->column + 18 * g;
        kern_real y0 = 0, y1 = 0, y2 = 0;
        for (k = 0; k < 3; k++, d += 6) {
            const kern_real *other_rows = c + f->other_row[3 * g + k];
            const kern_real z = c[3 * g + k] - other_rows[0] * d[3]
                              - other_rows[1] * d[4] - other_rows[2] * d[5];
            y0 += z * d[0];
            y1 += z * d[1];
            y2 += z * d[2];
        }
        c[3 * g] = y0;
        c[3 * g + 1] = y1;
        c[3 * g + 2] = y2;
    }
}

/* Writes B^-1 A_j to sx->alpha: column j in terms of the basis. */
static void kern_basis_column(kern_simplex *sx, int j)
{
    kern_zero(sx->alpha, sx->factors.padded_rows + 3);
    kern_lp_subtract(sx->lp, j, -1, sx->alpha);
    kern_basis_solve(sx, sx->alpha);
}

/* Returns 1 if there is no room for one more factor of the basis. */
static int kern_basis_full(const kern_simplex *sx)
{
    const kern_factors *f = &sx->factors;
    return f->count == f->count_max
        || f->first_entry[f->count] + f->padded_rows > f->room;
}

/* Makes column q basic in row p. sx->alpha must be column q in terms of the
   basis. */
static void kern_basis_enter(kern_simplex *sx, int q, int p)
{
    kern_factors *f = &sx->factors;
    const kern_real inverse = 1 / sx->alpha[p];
    kern_real *entry = f->entry + f->first_entry[f->count];
    int from = 0, to = f->padded_rows, i;
    KERN_ASSERT(!kern_basis_full(sx));
    while (kern_largest(sx->alpha + from, 3) <= 0)
        from += 3;
    while (kern_largest(sx->alpha + to - 3, 3) <= 0)
        to -= 3;
    for (i = from; i < to; i++)
        *entry++ = i == p ? inverse : -sx->alpha[i] * inverse;
    f->first_row[f->count] = from;
    f->pivot[f->count++] = p;
    f->first_entry[f->count] = f->first_entry[f->count - 1] + to - from;
    sx->base[p] = q;
    sx->basic_row[q] = p;
}

/* ---- the crash basis ---- */

/* Returns the determinant of three columns. */
static kern_real kern_three_det(const kern_real *a, const kern_real *b,
                                const kern_real *c)
{
    return (a[1] * b[2] - a[2] * b[1]) * c[0]
         + (a[2] * b[0] - a[0] * b[2]) * c[1]
         + (a[0] * b[1] - a[1] * b[0]) * c[2];
}

typedef enum kern_crash {
    KERN_CRASH_PUSHING, /* only columns that push against the load       */
    KERN_CRASH_ANY      /* any column, and the logical of the group's
                           torque                                        */
} kern_crash;

/* Chooses three columns of group g from the list that begins with column j, and
   makes them basic. The forces of these columns carry the load of the group,
   and of all triples of columns the one is chosen whose least force is largest.
   Adds these forces to the loads of the groups at the other ends of the
   columns. With KERN_CRASH_PUSHING no column may pull by more than
   KERN_CRASH_PULL loads. Returns 0 if there are no such columns. */
static int kern_crash_choose(kern_simplex *sx, int g, int j, kern_crash crash)
{
    const int logical = sx->lp->cols + 1 + 3 * g + 2;
    const int any_column = crash != KERN_CRASH_PUSHING;
    int *base = sx->base + 3 * g;
    const kern_real *load = sx->alpha + 3 * g;
    const kern_real x = load[0], y = load[1];
    kern_real part[KERN_CRASH_COLUMNS][3], share[3];
    kern_real best = any_column
                       ? -KERN_INFINITY
                       : -KERN_CRASH_PULL * (kern_abs(x) + kern_abs(y));
    int column[KERN_CRASH_COLUMNS], n = 0, found = 0, i, k;

    /* Lists the columns: all, or those that push against the load within 60
       degrees of it, since others would hardly carry it. */
    for (; j != KERN_OUT && n < KERN_CRASH_COLUMNS - 1; j = sx->basic_row[j]) {
        const kern_real *a = part[n];
        kern_real push;
        kern_lp_part(sx->lp, j, KERN_LP_END_OWN, part[n]);
        push = a[0] * x + a[1] * y;
        column[n] = j;
        n += any_column
          || (push > 0
              && 4 * push * push
                     >= (a[0] * a[0] + a[1] * a[1]) * (x * x + y * y));
    }

    /* The logical of the torque is one more column. */
    if (any_column) {
        part[n][0] = part[n][1] = 0;
        part[n][2] = 1;
        column[n++] = logical;
    }

    /* Tries all triples of columns. Computes the force of each column as a
       share of the load by Cramer's rule. The share of the third column comes
       first, since it excludes most triples. */
    for (i = 0; i < n; i++)
        for (j = i + 1; j < n; j++) {
            const kern_real *a = part[i], *b = part[j];
            const kern_real det_c = kern_three_det(a, b, load);
            for (k = j + 1; k < n; k++) {
                const kern_real *c = part[k], det = kern_three_det(a, b, c);
                const kern_real lc = det_c / det;
                kern_real la, lb, smallest;
                if (kern_abs(det) < KERN_CRASH_DET || lc <= best)
                    continue;
                la = kern_three_det(b, c, load) / det;
                lb = kern_three_det(c, a, load) / det;
                smallest = kern_min(kern_min(la, lb),
                                    column[k] == logical ? -kern_abs(lc) : lc);
                if (smallest > best) {
                    best = smallest;
                    found = 1;
                    base[0] = column[i];
                    base[1] = column[j];
                    base[2] = column[k];
                    share[0] = la;
                    share[1] = lb;
                    share[2] = lc;
                }
            }
        }

    /* Adds the forces of the three columns to the loads of their other groups.
       The force of a column that pulls counts as 0. */
    for (k = 0; k < 3 && found; k++)
        kern_lp_subtract(sx->lp, base[k], kern_max(share[k], 0), sx->alpha);
    return found;
}

/* Makes a basis of the columns j with x[j] > threshold, and fills it up with
   the last columns of the program. If there are more such columns than rows,
   the next program begins without a basis. */
static void kern_simplex_start(kern_simplex *sx, const kern_real *x,
                               kern_real threshold)
{
    const kern_program *lp = sx->lp;
    int j, n = 0;
    sx->basis = KERN_BASIS_NONE;
    for (j = 0; j < lp->cols; j++)
        if (x[j] > threshold) {
            if (n == lp->rows)
                return;
            sx->base[n++] = j;
        }
    for (; n < lp->rows; n++)
        sx->base[n] = j > 0 ? --j : lp->cols + 1;
    sx->basis = KERN_BASIS_STALE;
}

/* Makes a crash basis, from which the simplex method starts. At first all
   logicals are basic. For a network, three columns of each group then replace
   its logicals, from the top group to the bottom one. */
static void kern_simplex_crash(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    int *next = sx->basic_row, *first = sx->list; /* columns of a group */
    int g, j;
    for (j = 0; j < lp->rows; j++) {
        sx->base[j] = lp->cols + 1 + j; /* the logical of row j */
        sx->alpha[j] = lp->rhs[j];
        first[j] = KERN_OUT;
    }
    for (j = lp->cols - 1; j >= 0 && lp->ends; j--) {
        kern_real part[3];
        g = kern_lp_part(lp, j, KERN_LP_END_OWN, part) / 3;
        next[j] = first[g];
        first[g] = j;
    }
    for (g = 0; g < sx->factors.groups; g++)
        if (!kern_crash_choose(sx, g, first[g], KERN_CRASH_PUSHING))
            kern_crash_choose(sx, g, first[g], KERN_CRASH_ANY);
    sx->basis = KERN_BASIS_STALE;
}

/* ---- factors ---- */

/* Makes column j basic in a row of its own group that still has its logical.
   Of these rows it takes the one in which the column, in terms of the columns
   that are already basic, has its largest entry. Returns 0 if that entry is too
   small. */
static int kern_own_enter(kern_simplex *sx, int j)
{
    const kern_program *lp = sx->lp;
    kern_real part[3], alpha[3], largest = KERN_OWN_TOL, *block, *pivot_row;
    int k, best = KERN_OUT, row;
    if (!lp->ends || j == lp->cols)
        return 0;

    /* Computes the column in terms of the basic columns of its group, and finds
       its largest entry in a row that still has its logical. */
    row = kern_lp_part(lp, j, KERN_LP_END_OWN, part);
    block = sx->factors.column + 6 * row;
    for (k = 0; k < 3; k++) {
        alpha[k] = kern_three(block + 6 * k, part);
        if (sx->base[row + k] > lp->cols && kern_abs(alpha[k]) >= largest) {
            largest = kern_abs(alpha[k]);
            best = k;
        }
    }
    if (best == KERN_OUT)
        return 0;

    /* Eliminates this row from the inverse of the group, and stores the entries
       of the column in the rows of its other group. */
    pivot_row = block + 6 * best;
    for (k = 0; k < 3; k++)
        pivot_row[k] /= alpha[best];
    for (k = 0; k < 3; k++)
        if (k != best)
            kern_add(block + 6 * k, -alpha[k], pivot_row, 3);
    sx->factors.other_row[row + best] = kern_lp_part(lp, j, KERN_LP_END_OTHER,
                                                     pivot_row + 3);
    sx->base[row + best] = j;
    sx->basic_row[j] = row + best;
    return 1;
}

/* Makes column j basic in any row that still has its logical. Does nothing if
   the column depends on the basic columns, or if there is no room. */
static void kern_late_enter(kern_simplex *sx, int j)
{
    kern_real largest;
    int p, best = KERN_OUT;
    kern_basis_column(sx, j);
    largest = KERN_LATE_PIVOT * kern_largest(sx->alpha, sx->lp->rows);
    for (p = 0; p < sx->lp->rows; p++)
        if (sx->base[p] > sx->lp->cols && kern_abs(sx->alpha[p]) >= largest) {
            largest = kern_abs(sx->alpha[p]);
            best = p;
        }
    if (best != KERN_OUT && !kern_basis_full(sx))
        kern_basis_enter(sx, j, best);
}

/* Writes the residual rhs - A x of the basic solution to sx->alpha. Returns its
   largest entry as a share of the largest value. */
static kern_real kern_basis_residual(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    kern_real size = 0;
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

/* Computes the basic solution and refines it until its residual is rounding.
   The entries of the inverse grow with every course of a wall, so one solve
   without refinement may lose half of the digits. Returns 0 if the residual
   stays too large. */
static int kern_basis_values(kern_simplex *sx)
{
    kern_real residual = kern_basis_residual(sx);
    int round;
    for (round = 0; round < KERN_REFINES && residual > KERN_RESIDUAL; round++) {
        kern_basis_solve(sx, sx->alpha);
        kern_add(sx->value, 1, sx->alpha, sx->lp->rows);
        residual = kern_basis_residual(sx);
    }
    sx->refined = 1;
    return residual <= KERN_BASIS_TOL;
}

/* Factors the basis again: first up to three own columns of each group, then
   the other columns. */
static void kern_basis_refactorise(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    kern_factors *f = &sx->factors;
    int i, p, count = 0;

    /* Moves the columns of the basis to a list, and makes the basis of
       logicals. */
    for (i = 0; i <= lp->cols; i++)
        sx->basic_row[i] = KERN_OUT;
    for (p = 0; p < lp->rows; p++) {
        sx->list[p] = sx->base[p];
        sx->base[p] = lp->cols + 1 + p;
        sx->value[p] = 0;
    }

    /* Makes B_0 the unit matrix without factors. */
    kern_zero(f->column, 18 * f->groups);
    for (p = 0; p < 3 * f->groups; p++) {
        f->column[6 * p + p % 3] = 1;
        f->other_row[p] = lp->rows;
    }
    f->count = f->first_entry[0] = 0;

    /* Places own columns of each group in its rows of B_0. Columns that find no
       row there are entered one after the other, each with a factor. */
    for (p = 0; p < lp->rows; p++)
        if (sx->list[p] <= lp->cols && !kern_own_enter(sx, sx->list[p]))
            sx->list[count++] = sx->list[p];
    for (i = 0; i < count; i++)
        kern_late_enter(sx, sx->list[i]);
    sx->basis = KERN_BASIS_READY;
    kern_basis_values(sx);
}

/* Computes the basic solution. Factors the basis again if its columns have
   changed, if there is no room for another factor, or if the factors have lost
   digits. */
static void kern_basis_renew(kern_simplex *sx)
{
    if (sx->basis != KERN_BASIS_READY || kern_basis_full(sx)
        || !kern_basis_values(sx))
        kern_basis_refactorise(sx);
}

/* ---- pivots ---- */
/* Every basis gives an x with A x = rhs. A variable is in violation if it is
   negative, or if it must be zero (a logical, or a place that is fixed) but is
   not. The first phase minimises the sum of violations. With

       y = B^-T c,    c = +1 or -1 for a variable that violates, otherwise 0,

   y.A_j < 0 is the rate at which the sum falls when column j enters. If no
   column lowers the sum and it is not zero, y is a Farkas certificate. Among
   the certificates it is the one with the largest -y.rhs, which is the sum of
   violations; a step of Newton's method along a path requires this one. If
   there are no violations, c is minus the costs, and y is minus their
   prices. */

/* Rules by which pivots are chosen. */
typedef enum kern_rule {
    KERN_RULE_LARGEST, /* the column of the largest gain enters            */
    KERN_RULE_REFINED, /* the column of the largest gain enters, after prices
                          have been refined                                */
    KERN_RULE_BLAND    /* the first column with a gain enters, and of equal
                          rows the variable of least index leaves: this cannot
                          cycle                                            */
} kern_rule;

/* Returns 1 if variable j must be zero: a logical, or a place that is fixed. */
static int kern_lp_fixed(const kern_program *lp, int j)
{
    return j >= lp->cols + lp->follow;
}

/* Returns the rate at which the costs fall as variable j grows. For the place
   the rate is 1 if the place may grow. */
static kern_real kern_lp_worth(const kern_program *lp, int j)
{
    return lp->cost && j < lp->cols ? -lp->cost[j]
                                    : KERN_R(j == lp->cols ? lp->follow : 0);
}

/* Writes c of each basic variable to sx->slope, and the number of violations to
   sx->violated. Returns the sum of violations. */
static kern_real kern_violations(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const kern_real tolerance = sx->tolerance;
    kern_real sum = 0;
    int p;
    sx->violated = 0;
    for (p = 0; p < lp->rows; p++) {
        const kern_real v = sx->value[p];
        sx->slope[p] = 0;
        if (v < -tolerance
            || (v > tolerance && kern_lp_fixed(lp, sx->base[p]))) {
            sx->slope[p] = KERN_R(v < 0 ? 1 : -1);
            sx->violated++;
            sum += kern_abs(v);
        }
    }
    for (p = 0; p < lp->rows && !sx->violated; p++)
        sx->slope[p] = kern_lp_worth(lp, sx->base[p]);
    return sum;
}

/* Refines y once by the residual of the equations y.A_j = c of the basic
   columns j. At the same time raises y.A_j of these columns by `lift` times the
   largest entry of y. A certificate needs this lift, since rounding leaves
   y.A_j below zero as often as above. The lift costs little of the
   certificate's power. Returns 0 if there is no basis, as after an answer of
   GLPK (KERN_USE_GLPK). */
static int kern_prices_mend(kern_simplex *sx, kern_real *y, kern_real lift)
{
    const kern_program *lp = sx->lp;
    int p;
    lift *= kern_largest(y, lp->rows);
    if (sx->basis == KERN_BASIS_NONE)
        return 0;
    for (p = 0; p < lp->rows; p++) {
        const int j = sx->base[p];
        sx->alpha[p] = sx->slope[p] + (j < lp->cols ? lift : 0)
                     - (j > lp->cols ? y[j - lp->cols - 1]
                                     : kern_lp_dot(lp, j, y));
    }
    kern_basis_solve_t(sx, sx->alpha);
    kern_add(y, 1, sx->alpha, lp->rows);
    return 1;
}

/* Computes prices and chooses the entering variable, sx->entering, by the rule.
   sx->gain = c_j - y.A_j is the rate at which this variable lowers the sum of
   violations, or the costs. If a variable would have to exceed lp->bound to
   remove the violations, it does not enter, since it belongs to a jam. Returns
   0 if no variable enters. */
static int kern_entering(kern_simplex *sx, kern_rule rule)
{
    const kern_program *lp = sx->lp;
    const kern_real sum = kern_violations(sx);
    const int costs = !sx->violated, columns = lp->cols + lp->follow;
    kern_real size, gain_min;
    int j;

    /* Computes prices y = B^-T c, and refines them after many pivots. */
    kern_copy(sx->price, sx->slope, lp->rows);
    if (costs && !lp->cost && !lp->follow)
        return 0;
    kern_basis_solve_t(sx, sx->price);
    if (rule > KERN_RULE_LARGEST)
        kern_prices_mend(sx, sx->price, 0);

    /* Computes the least gain with which a variable may enter, which is above
       rounding. If variables are bounded, the variable must also be able to
       remove all violations within its bound. */
    size = kern_largest(sx->price, lp->rows);
    gain_min = costs || !(lp->bound > 0) ? KERN_PRICE_TOL * size
                                         : sum / lp->bound;
    gain_min = kern_max(gain_min, KERN_LP_ROUNDING * size);

    /* Finds the largest gain of all columns that are not basic, or with Bland's
       rule the first gain. */
    sx->gain = 0;
    for (j = 0; j < columns; j++) {
        kern_real d;
        if (sx->basic_row[j] != KERN_OUT)
            continue;
        d = (costs ? kern_lp_worth(lp, j) : 0) - kern_lp_dot(lp, j, sx->price);
        if (d > sx->gain) {
            sx->entering = j;
            sx->gain = d;
            if (rule == KERN_RULE_BLAND && d > gain_min)
                break;
        }
    }
    return sx->gain > gain_min;
}

/* Returns the increase in the slope of the sum of violations where the basic
   variable of row p passes zero. The variable approaches zero at the rate alpha
   and reaches it after a step of *step. Returns 0 if the variable never reaches
   zero, as when it is in violation and moves away from zero. A variable that
   must be zero leaves zero at once. */
static kern_real kern_break(const kern_simplex *sx, int p, kern_real *step)
{
    const int fixed = kern_lp_fixed(sx->lp, sx->base[p]);
    const kern_real a = sx->alpha[p];
    const kern_real falls = sx->violated ? -sx->slope[p] * a : 0;
    if (falls < 0 || (!fixed && a < 0 && !(falls > 0)))
        return 0;
    *step = falls > 0 ? sx->value[p] / a
          : fixed     ? 0
                      : kern_max(sx->value[p], 0) / a;
    return fixed ? kern_abs(a) + falls : kern_abs(a);
}

/* Charges work on a program. Returns 0 if the work is refused. */
static int kern_lp_spend(const kern_program *lp, int units)
{
    return kern_spend(lp->work, lp->limit, units);
}

/* Chooses the row that the entering column takes, and writes the length of the
   step to *step. Candidates are the rows whose variables reach zero. The ratio
   test passes a candidate if the sum of violations still falls after it: such a
   long step passes through degenerate corners. With Bland's rule, and for
   costs, the step ends at the first candidate. Of equal candidates it takes the
   largest pivot, or with Bland's rule the least index. Returns KERN_OUT if no
   variable reaches zero. If the work of the test is refused, kern_pivot_spend()
   refuses the pivot. */
static int kern_leaving(kern_simplex *sx, kern_rule rule, kern_real *step)
{
    const kern_real pivot_min = KERN_PIVOT_LEAST
                              * kern_largest(sx->alpha, sx->lp->rows);
    kern_real *ratio = sx->ratio, slope = sx->gain;
    const int bland = rule == KERN_RULE_BLAND;
    int *list = sx->list, i, n = 0, best = KERN_OUT, next, seen = 0;

    /* Lists the rows whose variables change, and the step after which each of
       these variables reaches zero. */
    for (i = 0; i < sx->lp->rows; i++)
        if (kern_abs(sx->alpha[i]) > pivot_min) {
            list[n] = i;
            n += kern_break(sx, i, ratio + n) > 0;
        }

    /* Passes these rows, the closest first, until the sum of violations no
       longer falls. */
    for (; n > 0 && slope > 2 * KERN_LP_ROUNDING * sx->gain; n--) {
        seen += n;
        next = 0;
        for (i = 1; i < n; i++)
            if (ratio[i] < ratio[next]
                || (ratio[i] <= ratio[next]
                    && (bland ? sx->base[list[i]] < sx->base[list[next]]
                              : kern_abs(sx->alpha[list[i]])
                                    > kern_abs(sx->alpha[list[next]]))))
                next = i;

        best = list[next];
        slope -= kern_break(sx, best, step);
        if (bland || !sx->violated)
            break;
        ratio[next] = ratio[n - 1];
        list[next] = list[n - 1];
    }

    kern_lp_spend(sx->lp, seen / (2 * KERN_UNIT));
    return best;
}

/* Charges the work of a pivot: one column and one set of prices, each
   multiplied by all factors. Returns 0 if the work is refused. */
static int kern_pivot_spend(const kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    return kern_lp_spend(
        lp, 1
                + (sx->factors.first_entry[sx->factors.count]
                   + 6 * sx->factors.groups)
                      / KERN_UNIT
                + (lp->ends ? 4 * lp->cols / (3 * KERN_UNIT)
                            : lp->rows * (lp->cols / (4 * KERN_UNIT))));
}

/* Pivots until no column lowers the sum of violations, and then until no column
   lowers the costs. The sum falls with every step whose length is not zero,
   unless rounding spoils the prices. So prices are refined after one budget of
   pivots (KERN_PIVOTS), and Bland's rule, which cannot cycle, is used after
   five budgets. A limit on the number of pivots ends cycles that rounding
   causes. Programs of structures take less than two budgets of pivots, except
   in jams. Their limit is three budgets, plus one pivot for each column.

   Returns KERN_LP_OPTIMAL, KERN_LP_INFEASIBLE or KERN_LP_UNBOUNDED. Returns
   KERN_NO_SPACE if there is no room for the factor of a pivot, KERN_LIMIT if
   the work of a pivot is refused, and otherwise KERN_UNDECIDED. */
static kern_status kern_simplex_run(kern_simplex *sx)
{
    const kern_program *lp = sx->lp;
    const int budget = KERN_PIVOTS + KERN_PIVOTS_ROW * lp->rows;
    const int limit = lp->ends ? KERN_PIVOTS_JAM * budget + lp->cols
                               : KERN_PIVOTS_MOST
                                     + KERN_PIVOTS_EACH * (lp->rows + lp->cols);
    int count;
    for (count = 0; count < limit;) {
        kern_rule rule = KERN_RULE_LARGEST;
        kern_real step = 0;
        int enters, p = KERN_OUT;

        /* Chooses the rule. After one budget of pivots prices may be spoilt by
           rounding. After five budgets only Bland's rule is sure to end. */
        if (count > budget)
            rule = count > KERN_PIVOTS_BLAND * budget ? KERN_RULE_BLAND
                                                      : KERN_RULE_REFINED;
        enters = kern_entering(sx, rule);

        /* Computes the entering column in terms of the basis, and chooses its
           row. */
        if (enters) {
            kern_basis_column(sx, sx->entering);
            p = kern_leaving(sx, rule, &step);
        }

        /* Refines the values before the method may end, and tries again. */
        if (p == KERN_OUT && !sx->refined) {
            kern_basis_renew(sx);
            continue;
        }

        /* Ends if no column lowers the sum of violations or the costs, or if
           the entering variable may grow without bound. */
        if (!enters)
            return sx->violated ? KERN_LP_INFEASIBLE : KERN_LP_OPTIMAL;
        if (p == KERN_OUT)
            return sx->violated ? KERN_UNDECIDED : KERN_LP_UNBOUNDED;

        /* Ends if there is no room for one more factor, or no work left. */
        if (kern_basis_full(sx))
            return KERN_NO_SPACE;
        if (!kern_pivot_spend(sx))
            return KERN_LIMIT;

        /* Makes the step: values change along the column, one variable leaves,
           and the column takes its row. */
        kern_add(sx->value, -step, sx->alpha, lp->rows);
        if (sx->base[p] <= lp->cols)
            sx->basic_row[sx->base[p]] = KERN_OUT;
        kern_basis_enter(sx, sx->entering, p);
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

/* Takes the arrays of the simplex method for a program, with room for `room`
   entries of factors. */
static void kern_simplex_lay(kern_simplex *sx, const kern_program *lp, int room,
                             kern_take *take)
{
    const int m = lp->rows;
    kern_factors *f = &sx->factors;
    sx->lp = lp;
    sx->basis = KERN_BASIS_NONE;
    f->padded_rows = m + 2 - (m + 2) % 3;
    f->groups = lp->ends ? m / 3 : 0;
    f->room = room;
    f->count_max = 2 * m + 8;
    f->other_row = kern_take_ints(take, 3 * f->groups);
    f->pivot = kern_take_ints(take, f->count_max);
    f->first_row = kern_take_ints(take, f->count_max);
    f->first_entry = kern_take_ints(take, f->count_max + 1);
    f->column = kern_take_reals(take, 18 * f->groups);
    f->entry = kern_take_reals(take, room);
    sx->base = kern_take_ints(take, m);
    sx->basic_row = kern_take_ints(take, lp->cols + 1);
    sx->list = kern_take_ints(take, m + 1);
    sx->value = kern_take_reals(take, m);
    sx->slope = kern_take_reals(take, m);
    sx->alpha = kern_take_reals(take, f->padded_rows + 3);
    sx->price = kern_take_reals(take, f->padded_rows + 3);
    sx->ratio = kern_take_reals(take, m);
}

/* Makes the next solve begin without a basis (KERN_BASIS_NONE), or with the
   same basis after factoring it again (KERN_BASIS_STALE). */
static void kern_simplex_change(kern_simplex *sx, kern_basis basis)
{
    if (sx->basis > basis)
        sx->basis = basis;
}

#ifdef KERN_USE_GLPK
#define KERN_LP_H_ALLOWED
#include "kern_lp.h"
#endif

/* Writes all variables to x: the basic variables have the values v, and the
   others are 0. */
static void kern_basis_read(const kern_simplex *sx, const kern_real *v,
                            kern_real *x)
{
    int i;
    kern_zero(x, sx->lp->cols + sx->lp->follow);
    for (i = 0; i < sx->lp->rows; i++)
        if (!kern_lp_fixed(sx->lp, sx->base[i]))
            x[sx->base[i]] = v[i];
}

/* Writes B^-1 v as a vector of variables to x. Destroys v. Returns 0 if there
   is no basis. */
static int kern_simplex_direction(kern_simplex *sx, kern_real *v, kern_real *x)
{
    if (sx->basis == KERN_BASIS_NONE)
        return 0;
    kern_basis_solve(sx, v);
    kern_basis_read(sx, v, x);
    return 1;
}

/* Solves a program, beginning with the last basis or with that of
   kern_simplex_crash(). Every linear program is solved by this function. Writes
   x for every status. For an infeasible program x is the last basic solution,
   which satisfies A x = rhs but has negative entries. Newton's method along a
   path takes its step from this x. Writes to y a certificate for
   KERN_LP_INFEASIBLE, and minus the prices for KERN_LP_OPTIMAL. */
static kern_status kern_program_solve(kern_simplex *sx, kern_solver solver,
                                      kern_real *x, kern_real *y)
{
    const kern_program *lp = sx->lp;
    kern_status status;
    KERN_ASSERT(lp->rows > 0);
    lp->work->solves++;
#ifdef KERN_USE_GLPK
    if (solver == KERN_SOLVER_ANY && !lp->follow && lp->rows > KERN_GLPK_ROWS) {
        kern_simplex_change(sx, KERN_BASIS_NONE);
        return kern_lp_glpk(lp, x, y);
    }
#endif
    (void)solver;

    /* Charges the work of the start, unless the last basis is ready. This work
       is to read the columns and to factor a basis. */
    sx->tolerance = KERN_VALUE_TOL * kern_largest(lp->rhs, lp->rows);
    if (sx->basis != KERN_BASIS_READY
        && !kern_lp_spend(lp, lp->ends ? (lp->rows + lp->cols) / 2
                                       : lp->rows * (lp->cols / KERN_UNIT)))
        return KERN_LIMIT;

    /* Starts from the last basis, or makes a crash basis, and pivots. */
    if (sx->basis == KERN_BASIS_NONE)
        kern_simplex_crash(sx);
    kern_basis_renew(sx);
    status = kern_pivot_spend(sx) ? kern_simplex_run(sx) : KERN_LIMIT;
    kern_basis_read(sx, sx->value, x);
    kern_copy(y, sx->price, lp->rows);
    return status;
}

/* Signs of the numbers that kern_lp_clean() keeps: only positive ones, or
   both. */
typedef enum kern_sign { KERN_SIGN_PLUS, KERN_SIGN_ANY } kern_sign;

/* Sets each of n numbers to 0 if its magnitude is at most `share` times the
   largest magnitude, or if its sign is not one of those that are kept. */
KERN_SHARED static void kern_lp_clean(kern_real *v, int n, kern_real share,
                                      kern_sign sign)
{
    const kern_real threshold = share * kern_largest(v, n);
    int i;
    for (i = 0; i < n; i++)
        if (!(kern_abs(v[i]) > threshold)
            || (sign == KERN_SIGN_PLUS && v[i] < 0))
            v[i] = 0;
}

/* Returns start + u.v, divided by the sum of the magnitudes of its terms. The
   vectors u and v have n numbers; those of v lie `stride` apart. Returns NaN if
   a term is not finite. */
static kern_real kern_lp_sum(kern_real start, const kern_real *u,
                             const kern_real *v, int stride, int n)
{
    kern_real terms = kern_abs(start);
    for (; n > 0; n--, v += stride) {
        const kern_real term = *u++ * *v;
        start += term;
        terms += kern_abs(term);
    }
    return terms > 0 ? start / terms + (terms - terms) : start;
}

/* Returns 1 if x and y prove the status. The check uses only products with the
   matrix A. The condition of each row and column must hold within KERN_LP_TOL
   times the sum of the magnitudes of its terms. Returns 0 if a number is NaN.

       optimal      A x = rhs,  cost + y A >= 0, = 0 where x > 0
       infeasible   y A >= 0,  y.rhs < 0
       unbounded    A x = 0,  cost.x < 0
 */
static int kern_lp_holds(const kern_program *lp, const kern_real *x,
                         const kern_real *y, kern_status status)
{
    const int m = lp->rows, optimal = status == KERN_LP_OPTIMAL;
    int i, j;
    for (i = 0; i < m && status != KERN_LP_INFEASIBLE; i++) {
        const kern_real share = kern_lp_sum(optimal ? -lp->rhs[i] : 0, x,
                                            lp->a + i, m, lp->cols);
        if (!(kern_abs(share) <= KERN_LP_TOL))
            return 0;
    }
    for (j = 0; j < lp->cols && status != KERN_LP_UNBOUNDED; j++) {
        const kern_real share = kern_lp_sum(optimal && lp->cost ? lp->cost[j]
                                                                : 0,
                                            y, kern_lp_dense(lp, j), 1, m);
        if (!(share >= -KERN_LP_TOL)
            || (optimal && x[j] > 0 && share > KERN_LP_TOL))
            return 0;
    }
    return optimal
        || (status == KERN_LP_INFEASIBLE
                ? kern_lp_sum(0, y, lp->rhs, 1, m)
                : kern_lp_sum(0, x, lp->cost, 1, lp->cols))
               < -KERN_LP_TOL;
}

/* Sets negative entries of x to 0. Returns 1 if x and y then prove the status.
   Otherwise sets to 0 those entries of x and y that are no larger than rounding
   errors, and checks once more: such entries spoil the check of a row that has
   no other entries. */
static int kern_lp_proven(const kern_program *lp, kern_real *x, kern_real *y,
                          kern_status status)
{
    int attempt;
    for (attempt = 0; attempt < 2; attempt++) {
        kern_lp_clean(x, lp->cols, KERN_R(attempt) * KERN_LP_ROUNDING,
                      KERN_SIGN_PLUS);
        kern_lp_clean(y, lp->rows, KERN_R(attempt) * KERN_LP_ROUNDING,
                      KERN_SIGN_ANY);
        if (kern_lp_holds(lp, x, y, status))
            return 1;
    }
    return 0;
}

/* Solves a program whose data have been checked, for kern_lp_solve(). */
static kern_status kern_lp_run(const kern_lp *lp, kern_real *x, kern_real *y,
                               kern_work *work)
{
    const kern_program p = {lp->rows, lp->cols,  lp->a, lp->rhs,
                            lp->cost, NULL,      NULL,  0,
                            0,        lp->limit, work};
    kern_simplex sx;
    kern_take take;
    kern_status status;
    int i;

    kern_take_open(&take, work);
    kern_simplex_lay(&sx, &p, KERN_LP_ROOM(p.rows), &take);
    if (!kern_take_fits(&take))
        return KERN_NO_SPACE;

    status = kern_program_solve(&sx, KERN_SOLVER_ANY, x, y);
    if (work->units > kern_limit_of(p.limit))
        return KERN_LIMIT;
    if (status < 0)
        return status;

    /* For an unbounded program the proof is the ray of the entering column. */
    if (status == KERN_LP_UNBOUNDED && sx.basis != KERN_BASIS_NONE) {
        kern_scale(sx.alpha, p.rows, -1);
        kern_basis_read(&sx, sx.alpha, x);
        x[sx.entering] = 1;
    }

    /* Returns nothing without a proof. The prices of an optimum are -y. */
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
/* A contact law gives the normal force f and the tangential force r of a
   contact as functions of its approach, which is wn along n and wt along t. The
   law is piecewise linear. On each piece

       f = nn wn + nt wt,   r = nt wn + tt wt.

   With such laws the equations of equilibrium A x = b become a linear system
   for the motion of the groups. The matrix of this system is symmetric and has
   one row of 3 x 3 blocks for each group. The matrix is factored in the order
   of the groups (skyline Cholesky). >>norm, >>ipm and >>raised build the matrix
   from different laws. Newton's method in >>raised also has a matrix that is
   not symmetric (kern_skyline_outer()). */

/* A symmetric matrix of 3 x 3 blocks, with one row of blocks for each group, or
   the Cholesky factor of such a matrix. Each row of blocks is stored from its
   first nonzero block to the diagonal block. */
typedef struct kern_skyline {
    int groups;
    int *first_column; /* per row of blocks: column of its first block    */
    int *offset;       /* per row of blocks: index of its first number    */
    kern_real *entry;  /* the numbers of all rows                         */
} kern_skyline;

/* The law of a contact near one approach (wn, wt). */
typedef struct kern_law {
    kern_real nn, nt, tt; /* f = nn wn + nt wt, r = nt wn + tt wt            */
    kern_force force;     /* f and r at the approach, in the friction cone   */
} kern_law;

/* Returns the law of a contact at the approach (wn, wt). The contact has the
   stiffness `stiffness` along n, and the stiffness mu * shear * stiffness along
   t until it slides. With stiffness = 2 and shear = mu this is the law of two
   independent forces along the edges of the friction cone (rays), each of which
   has the stiffness 1 and cannot pull. */
static inline kern_law kern_law_stiff(kern_real wn, kern_real wt, kern_real mu,
                                      kern_real stiffness, kern_real shear)
{
    const kern_real side = wt > 0 ? mu : -mu;
    kern_law s = {0, 0, 0, {0, 0}};
    if (wn > 0 && shear * kern_abs(wt) <= wn) {
        s.nn = stiffness;
        s.tt = shear * mu * stiffness;
        s.force.normal = stiffness * wn;
        s.force.tangential = s.tt * wt;
    } else if (wn + side * wt > 0) {
        s.nn = stiffness * shear / (shear + mu);
        s.nt = side * s.nn;
        s.tt = side * s.nt;
        s.force.normal = s.nn * (wn + side * wt);
        s.force.tangential = side * s.force.normal;
    }
    return s;
}

/* Takes memory for the matrix of `groups` groups. Each of n contacts couples
   two groups, so the row of the later group must reach back to the column of
   the earlier group. Returns the number of multiplications of one
   factorisation. This number is returned as a real, since it may exceed the
   range of an int. */
static kern_real kern_skyline_open(kern_skyline *a, int groups, const int *ends,
                                   int n, kern_take *take)
{
    kern_real products = 0;
    int g, k, end = 0;
    a->groups = groups;
    a->first_column = kern_take_ints(take, 2 * groups);
    a->offset = a->first_column + groups;
    if (!kern_take_fits(take))
        return products;
    for (g = 0; g < groups; g++)
        a->first_column[g] = g;
    for (k = 0; k < 2 * n; k++) {
        const int high = ends[k], low = ends[k ^ 1];
        if (high < groups && low < a->first_column[high])
            a->first_column[high] = low;
    }
    for (g = 0; g < groups; g++) {
        const int width = g - a->first_column[g] + 1;
        a->offset[g] = end;
        end += 9 * width;
        products += KERN_PAIR_PRODUCTS * KERN_R(width) * KERN_R(width);
    }
    a->entry = kern_take_reals(take, end);
    return products;
}

/* Sets all entries of the matrix to 0. */
static void kern_skyline_clear(kern_skyline *a)
{
    int g;
    for (g = 0; g < a->groups; g++)
        kern_zero(a->entry + a->offset[g], 9 * (g - a->first_column[g] + 1));
}

/* Adds the stiffness nn, nt and tt of a contact's law to the matrix. The law
   changes three blocks: the diagonal blocks of the two groups at the contact,
   and in the row of the later group the block that couples these groups. A held
   block has the number a->groups and no row. */
static void kern_skyline_law(kern_skyline *a, const int ends[2],
                             const kern_row row[2], const kern_law *s)
{
    kern_real v[3], w[3];
    int k;
    for (k = 0; k < 2; k++, row++) {
        const int g = ends[k], h = ends[1 - k];
        if (g < a->groups) {
            const kern_row *other_row = row + 1 - 2 * k;
            const int width = 3 * (g - a->first_column[g] + 1);
            kern_real *entry = a->entry + a->offset[g] + width - 3;

            /* Adds v n' + w t' to each block, where v and w are the wrenches
               that the contact exerts for an approach of 1 along n and t. */
            kern_row_wrench(row, s->nn, s->nt, v);
            kern_row_wrench(row, s->nt, s->tt, w);
            kern_row_exert(row, v[0], w[0], entry);
            kern_row_exert(row, v[1], w[1], entry + width);
            kern_row_exert(row, v[2], w[2], entry + 2 * width);
            if (g < h)
                continue;
            KERN_ASSERT(h >= a->first_column[g]);
            entry += 3 * (h - g);
            kern_row_exert(other_row, v[0], w[0], entry);
            kern_row_exert(other_row, v[1], w[1], entry + width);
            kern_row_exert(other_row, v[2], w[2], entry + 2 * width);
        }
    }
}

/* Adds `share` times the mean of the diagonal entries to each diagonal
   entry. */
static void kern_skyline_shift(kern_skyline *a, kern_real share)
{
    kern_real trace = 0, shift = 0;
    int g, k, add;
    for (add = 0; add < 2; add++) {
        for (g = 0; g < a->groups; g++) {
            const int length = 3 * (g - a->first_column[g] + 1);
            kern_real *d = a->entry + a->offset[g] + length - 3;
            for (k = 0; k < 3; k++, d += length + 1) {
                trace += *d;
                *d += shift;
            }
        }
        shift = share * trace / KERN_R(3 * a->groups);
    }
}

/* Subtracts the product a b' from the 3 x 3 block c, which lies in the same
   three rows as a. `b` points to three other rows. a and b begin at the same
   column, and the product takes n columns of each. Successive rows of a and c
   are wide_a numbers apart, and successive rows of b are wide_b numbers
   apart. */
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

    /* Keeps the nine sums in registers, since a factorisation spends most of
       its time in this loop. */
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

/* Replaces the matrix by its Cholesky factor L. A pivot that is smaller than
   rounding error is raised to the size of rounding error. */
static void kern_skyline_factor(kern_skyline *a)
{
    int g, h, r, k;
    for (g = 0; g < a->groups; g++) {
        const int width = 3 * (g - a->first_column[g] + 1);
        kern_real *row = a->entry + a->offset[g], *d = row + width - 3;
        const kern_real diagonal[3] = {d[0], d[width + 1], d[2 * width + 2]};

        /* Computes the blocks of row g from the first block to the diagonal
           block. From block h subtracts the product of rows g and h over the
           earlier columns that both rows have. */
        for (h = a->first_column[g]; h <= g; h++) {
            const int from = a->first_column[g] > a->first_column[h]
                               ? a->first_column[g]
                               : a->first_column[h];
            const int width_h = 3 * (h - a->first_column[h] + 1);
            const kern_real *row_h = a->entry + a->offset[h];
            const kern_real *l = row_h + width_h - 3;
            kern_real *c = row + 3 * (h - a->first_column[g]);
            kern_skyline_common(c, row + 3 * (from - a->first_column[g]), width,
                                row_h + 3 * (from - a->first_column[h]),
                                width_h, 3 * (h - from));

            /* Divides block h by the diagonal block of row h. For h = g the
               block is the diagonal block of row g, and the loop computes its
               Cholesky factor. */
            for (r = 0; r < 3; r++, c += width) {
                if (h < g || r > 0)
                    c[0] /= l[0];
                if (h < g || r > 1)
                    c[1] = (c[1] - c[0] * l[width_h]) / l[width_h + 1];
                if (h < g) {
                    c[2] = (c[2] - c[0] * l[2 * width_h]
                            - c[1] * l[2 * width_h + 1])
                         / l[2 * width_h + 2];
                    continue;
                }
                for (k = 0; k < r; k++)
                    c[r] -= c[k] * c[k];
                c[r] = KERN_SQRT(
                    kern_max(c[r], KERN_EPS * (KERN_EPS + diagonal[r])));
            }
        }
    }
    KERN_AUDIT(factor, a);
}

/* Solves L L' out = b for `out`. `a` is the Cholesky factor L. */
static void kern_skyline_solve(const kern_skyline *a, const kern_real *b,
                               kern_real *out)
{
    const int n = 3 * a->groups;
    int i;
    for (i = 0; i < n; i++) {
        const int from = 3 * a->first_column[i / 3],
                  width = 3 * (i / 3) + 3 - from;
        const kern_real *row = a->entry + a->offset[i / 3] + i % 3 * width;
        out[i] = (b[i] - kern_dot(row, out + from, i - from)) / row[i - from];
    }
    for (i = n - 1; i >= 0; i--) {
        const int from = 3 * a->first_column[i / 3],
                  width = 3 * (i / 3) + 3 - from;
        const kern_real *row = a->entry + a->offset[i / 3] + i % 3 * width;
        out[i] /= row[i - from];
        kern_add(out + from, -out[i], row, i - from);
    }
}

/* Adds the stiffness of a contact to a matrix that is not symmetric. The
   stiffness is the outer product f w': for an approach (wn, wt) the contact
   exerts the force (f[0], f[1]) times w[0] wn + w[1] wt. Only the blocks up to
   the diagonal are written. */
static void kern_skyline_outer(kern_skyline *a, const int ends[2],
                               const kern_row row[2], const kern_real f[2],
                               const kern_real w[2])
{
    int k, i;
    for (k = 0; k < 2; k++) {
        const int g = ends[k], h = ends[1 - k];
        if (g < a->groups) {
            const int width = 3 * (g - a->first_column[g] + 1);
            kern_real *entry = a->entry + a->offset[g] + width - 3, v[3];
            kern_row_wrench(row + k, f[0], f[1], v);
            for (i = 0; i < 3; i++, entry += width) {
                kern_row_exert(row + k, v[i] * w[0], v[i] * w[1], entry);
                if (h < g)
                    kern_row_exert(row + 1 - k, v[i] * w[0], v[i] * w[1],
                                   entry + 3 * (h - g));
            }
        }
    }
}

/* Factors a matrix that is not symmetric into L U, in place. `lower` has the
   rows of the matrix up to the diagonal and becomes L. `upper` has the columns
   of the matrix down to the diagonal, each stored as a row, and becomes U. The
   diagonal entries of L are 1 and are not stored. A pivot that is smaller than
   rounding error is raised to the size of rounding error. */
static void kern_skyline_split(kern_skyline *lower, kern_skyline *upper)
{
    int i, j;
    for (i = 0; i < 3 * lower->groups; i++) {
        const int from = 3 * lower->first_column[i / 3],
                  width = 3 * (i / 3) + 3 - from;
        const int row = lower->offset[i / 3] + i % 3 * width;
        kern_real *l = lower->entry + row, *u = upper->entry + row;
        const kern_real pivot_min = KERN_EPS
                                  * (KERN_EPS + kern_abs(u[i - from]));
        for (j = from; j < i; j++) {
            const int from_j = 3 * lower->first_column[j / 3];
            const int width_j = 3 * (j / 3) + 3 - from_j;
            const int row_j = lower->offset[j / 3] + j % 3 * width_j;
            const int start = from_j > from ? from_j : from;
            const kern_real *lj = lower->entry + row_j + start - from_j;
            const kern_real *uj = upper->entry + row_j + start - from_j;
            u[j - from] -= kern_dot(u + start - from, lj, j - start);
            l[j - from] -= kern_dot(l + start - from, uj, j - start);
            l[j - from] /= uj[j - start];
        }
        u[i - from] -= kern_dot(l, u, i - from);
        if (kern_abs(u[i - from]) < pivot_min)
            u[i - from] = pivot_min;
    }
}

/* Solves L U out = b for `out`, with the factors of kern_skyline_split(). */
static void kern_skyline_split_solve(const kern_skyline *lower,
                                     const kern_skyline *upper,
                                     const kern_real *b, kern_real *out)
{
    const int n = 3 * lower->groups;
    int i;
    for (i = 0; i < n; i++) {
        const int from = 3 * lower->first_column[i / 3],
                  width = 3 * (i / 3) + 3 - from;
        const kern_real *l = lower->entry + lower->offset[i / 3]
                           + i % 3 * width;
        out[i] = b[i] - kern_dot(l, out + from, i - from);
    }
    for (i = n - 1; i >= 0; i--) {
        const int from = 3 * upper->first_column[i / 3],
                  width = 3 * (i / 3) + 3 - from;
        const kern_real *u = upper->entry + upper->offset[i / 3]
                           + i % 3 * width;
        out[i] /= u[i - from];
        kern_add(out + from, -out[i], u, i - from);
    }
}

/* ---- Parts ------------------------------------------------------ >>part */
/* A part consists of some of the groups and of all contacts that touch these
   groups. All other blocks are held, and held blocks can exert any force. A
   part is open while its groups and contacts are listed in a kern_part. Only
   one part is open at a time. So if a part falls, the whole structure falls:
   the motion of the part, with all other blocks at rest, proves this fall. */

/* Laws that the contacts of a part may have (>>skyline). */
typedef enum kern_law_kind {
    /* Two forces along the edges of the friction cone (rays), each of which has
       the stiffness 1 and cannot pull. */
    KERN_LAW_RAYS,
    /* A stiffness along n and one along t, and a price (>>raised). */
    KERN_LAW_STIFF
} kern_law_kind;

/* Starting point of Newton's method. KERN_START_COLD: the method begins at
   u = 0 with one additional round, in which all contacts are assumed to press.
   KERN_START_WARM: the method begins at the present u. */
typedef enum kern_start { KERN_START_COLD, KERN_START_WARM } kern_start;

/* Data of Newton's method for the minimum-norm forces of a part. The method
   solves the dual problem of >>norm, whose unknowns u are a motion of the
   groups. */
typedef struct kern_dual {
    kern_law_kind law;   /* law of the contacts                      */
    kern_skyline matrix; /* matrix of Newton's method                */

    /* The unknowns u, the step of Newton's method and the gradient of the dual.
       Each of these arrays has three numbers per group, and then three zeros
       for held blocks. */
    kern_real *u, *step, *grad;
    kern_real *load; /* three per group: the wrench that supports must exert */

    /* The approach of each contact under u, and its change under the step: two
       numbers per contact, along n and t. */
    kern_real *approach, *change;
    int step_units; /* work of one step of Newton's method [units]           */

    /* The price of each contact, which is mu times its slip (>>raised), and the
       stiffness of each contact along n. Only KERN_LAW_STIFF has these two
       arrays. */
    kern_real *price;
    kern_real *stiffness;
    kern_real shear; /* stiffness along t, divided by mu times that along n  */
} kern_dual;

/* Eq. (5) of a part as a linear program (>>verdict). The interior-point method
   stores no columns and uses only rhs, rate and shrink. */
typedef struct kern_equations {
    kern_real *arc;   /* columns: eight numbers per contact              */
    kern_real *rhs;   /* right-hand side: three loads per group          */
    kern_real *rate;  /* rate at which rhs falls along a path            */
    kern_real shrink; /* shrinkage at which the columns were computed;
                         infinity: there are no columns                  */
    kern_program lp;
    kern_simplex simplex;
} kern_equations;

typedef struct kern_part {
    kern_take rest; /* work memory that the part leaves free */
    kern_dual dual;
    kern_model *m;
    int groups, contacts;

    /* The first `supports` contacts carry groups of the part. The other
       contacts carry groups that rest on the part. */
    int supports;
    int *group;   /* groups of the part, from top to bottom; in >>norm in
                     the order of kern_norm_order()                          */
    int *contact; /* contacts of the part                                    */
    int *ends;    /* two per contact: number of the group at each end within
                     the part, or `groups` if the block is held              */
    kern_real *x; /* two per contact: forces along the edges of its friction
                     cone; after all of them the value of the place (>>lp)   */
    kern_real *y; /* three per group: y of the program (>>lp), a motion      */
    kern_equations eq;
    kern_status result; /* last result of a method, with or without a proof  */
} kern_part;

/* Writes to p->ends, for both ends of each contact, the number that the group
   there has within the part, or p->groups if the block there is held. Returns 0
   if the work memory is too small. */
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

/* Lists the contacts of the part: first its supports, which carry groups of the
   part, then the contacts that carry groups above the part. If the work memory
   is too small, the list is incomplete and kern_part_ends() returns 0. */
static void kern_part_list(kern_part *p)
{
    const kern_model *m = p->m;
    int supporting, n, e;
    p->contacts = 0;
    p->contact = kern_take_ints(&p->rest, 0);

    /* First (supporting = 1) lists the contacts with the ground and with groups
       below. Then (supporting = 0) lists the contacts with those groups above
       that do not belong to the part. */
    for (supporting = 1; supporting >= 0; supporting--) {
        for (n = 0; n < p->groups; n++) {
            const int g = p->group[n];
            for (e = m->graph.first_end[g]; e >= 0; e = m->graph.next_end[e]) {
                const int other_group = m->graph.ends[e ^ 1];
                if (supporting
                        ? other_group > g
                        : other_group < g
                              && m->graph.local[other_group] == KERN_OUT) {
                    int *const slot = kern_take_ints(&p->rest, 1);
                    if (!kern_take_fits(&p->rest))
                        return;
                    *slot = e >> 1;
                    p->contacts++;
                }
            }
        }
        if (supporting)
            p->supports = p->contacts;
    }
}

/* Writes the loads of a part's groups for a query as the right-hand side of a
   program: three numbers per group, divided by the unit of force. Returns the
   largest residual of equilibrium that is allowed, in the unit of force. */
static kern_real kern_part_load(const kern_part *p, const kern_query *q,
                                kern_real *load)
{
    kern_model *m = p->m;
    kern_real lightest = KERN_INFINITY;
    int n;
    for (n = 0; n < p->groups; n++) {
        const int g = p->group[n];
        kern_model_load(m, q, g);
        lightest = kern_min(lightest, m->load_size[g]);
        kern_copy(load + 3 * n, m->load + 3 * g, 3);
    }
    kern_scale(load, 3 * p->groups, 1 / m->weight);
    return KERN_PART_TOL * lightest / m->weight;
}

/* Begins a part of `groups` groups: takes the memory for the list of these
   groups from `rest`. Returns 0 if `rest` is too small. */
static int kern_part_begin(kern_part *p, kern_model *m, int groups,
                           const kern_take *rest)
{
    p->m = m;
    p->rest = *rest;
    p->groups = groups;
    p->result = KERN_UNDECIDED;
    p->group = kern_take_ints(&p->rest, groups);
    return kern_take_fits(&p->rest);
}

/* Opens the part whose groups are marked in graph.local. `groups` is the number
   of marked groups, and `last` is the last of them. Returns 0 if the work
   memory is too small. */
static int kern_part_open(kern_part *p, kern_model *m, int groups, int last)
{
    int g, n = groups;
    KERN_ASSERT(groups > 0 && !m->whole);
    if (!kern_part_begin(p, m, groups, &m->rest))
        return 0;

    /* Gives the marked groups their numbers within the part, in the order of
       all groups. Counts the groups from the last marked one back to the
       first. */
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

/* Writes the part's y as the motion in m->answer. All other blocks rest. */
static void kern_part_motion(kern_part *p)
{
    kern_model *m = p->m;
    int n;
    kern_zero(m->answer.motion, 3 * m->s->blocks);
    for (n = 0; n < p->groups; n++) {
        kern_motion *v = m->answer.motion + m->graph.block[p->group[n]];
        kern_copy(v, p->y + 3 * n, 3);
        v->spin *= m->torque_scale[p->group[n]];
    }
}

/* Writes the part's y as the motion in m->answer. Returns 1 if this motion
   proves that the structure falls. */
static int kern_part_falls(kern_part *p, const kern_query *q)
{
    const kern_model *m = p->m;
    kern_part_motion(p);
    kern_motion_scale(m->s, m->answer.motion);
    return kern_model_proven(m, kern_prove_motion(m->s, q, m->answer.motion));
}

/* Writes the x of a program of all groups as the contact forces in m->answer.
   Negative entries of x, which are rounding errors, become 0. */
static void kern_part_forces(kern_part *p)
{
    kern_model *m = p->m;
    int k;
    kern_model_unload(m);
    for (k = 0; k < p->contacts; k++) {
        const kern_real x1 = kern_max(p->x[2 * k], 0) * m->weight;
        const kern_real x2 = kern_max(p->x[2 * k + 1], 0) * m->weight;
        const int i = p->contact[k];
        m->answer.force[i].normal = x1 + x2;
        m->answer.force[i].tangential = kern_model_mu(m, i) * (x1 - x2);
    }
}

/* Writes the x of a program of all groups as the contact forces in m->answer.
   Returns 1 if these forces prove that the structure stands. */
static int kern_part_stands(kern_part *p, const kern_query *q)
{
    kern_part_forces(p);
    return kern_answer_holds(p->m, q);
}

/* ---- Minimum-norm forces ----------------------------------------- >>norm */
/* The minimum-norm forces x of a part solve

       min |x|^2 / 2,  A x = b,  x >= 0.

   Here x has one force for each ray, an edge of a friction cone, and b is the
   wrench that the contacts must exert on each group. The dual problem,

       max b.u - |max(0, A'u)|^2 / 2,

   has three unknowns u for each group, a motion. The solution u of the dual
   gives the forces x = max(0, A'u). The dual is concave and its curvature is
   piecewise constant, so Newton's method ends after a few steps. The matrix of
   Newton's method is A_S A_S', where S is the set of rays that press at u,
   those with A'u > 0. If no forces exist, the dual grows without bound. */

/* Writes to `way` the approach at which contact i exerts its present force in
   m->answer. Newton's method begins at this approach of each contact, so it
   finds the forces that differ least from the present ones. Returns the
   friction of the contact. */
static inline kern_real kern_model_prior(const kern_model *m, int i,
                                         kern_real way[2])
{
    const kern_force *f = m->answer.force + i;
    const kern_real mu = kern_model_mu(m, i);
    way[0] = f->normal / 2;
    way[1] = mu > 0 ? f->tangential / (2 * mu * mu) : 0;
    return mu;
}

/* Returns the law of the part's contact k at the approach (wn, wt). */
static inline kern_law kern_part_law(const kern_part *p, int k, kern_real wn,
                                     kern_real wt)
{
    const kern_real mu = kern_model_mu(p->m, p->contact[k]);
    const int has_stiffness = p->dual.law != KERN_LAW_RAYS;
    return kern_law_stiff(wn, wt, mu, has_stiffness ? p->dual.stiffness[k] : 2,
                          has_stiffness ? p->dual.shear : mu);
}

/* Takes memory for the arrays of Newton's method, p->dual. Returns 0 if the
   work memory is too small. */
static int kern_norm_lay(kern_part *p, kern_take *take)
{
    kern_dual *d = &p->dual;
    const int n = 3 * p->groups + 3;
    kern_real products = KERN_CONTACT_PRODUCTS * KERN_R(p->contacts);
    d->law = KERN_LAW_RAYS;
    d->u = kern_take_reals(take, 4 * n + 4 * p->contacts);
    d->step = d->u + n;
    d->grad = d->step + n;
    d->load = d->grad + n;
    d->approach = d->load + n;
    d->change = d->approach + 2 * p->contacts;
    products += kern_skyline_open(&d->matrix, p->groups, p->ends, p->supports,
                                  take);
    d->step_units = 1
                  + (int)kern_min(products / KERN_R(8 * KERN_UNIT / 3),
                                  KERN_R(KERN_WORK_MOST));
    return kern_take_fits(take);
}

/* Writes the rows (kern_row) of the part's contact k: row[0] at its block b and
   row[1] at its block a. */
static inline void kern_part_rows(const kern_part *p, int k, kern_row row[2])
{
    row[0] = kern_model_row(p->m, 2 * p->contact[k]);
    row[1] = kern_model_row(p->m, 2 * p->contact[k] + 1);
}

/* Adds to w the approach of the part's contact k along n and t under the motion
   v of the groups. Subtracts the velocities of the two blocks first, so that a
   translation of both together gives exactly 0. */
static inline void kern_part_speed(const kern_part *p, int k,
                                   const kern_real *v, kern_real *w)
{
    const kern_real *h = v + 3 * p->ends[2 * k];
    const kern_real *t = v + 3 * p->ends[2 * k + 1];
    const kern_real relative[3] = {h[0] - t[0], h[1] - t[1], h[2]};
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_row_speed(row, relative, w);
    w[0] += row[1].n[2] * t[2];
    w[1] += row[1].torque * t[2];
}

/* Adds to b the wrenches that the part's contact k exerts on its two groups,
   with the force f along n and r along t. Wrenches on held blocks are added to
   the last three numbers of b. */
static inline void kern_part_exert(const kern_part *p, int k, kern_real f,
                                   kern_real r, kern_real *b)
{
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_row_exert(row, f, r, b + 3 * p->ends[2 * k]);
    kern_row_exert(row + 1, f, r, b + 3 * p->ends[2 * k + 1]);
}

/* Motion under which kern_norm_approach() computes the approaches: the step of
   Newton's method alone, or u. */
typedef enum kern_way_of { KERN_WAY_OF_STEP, KERN_WAY_OF_U } kern_way_of;

/* Writes the approach of each support along n and t: under u to dual.approach,
   or under the step alone to dual.change. The approach under u includes a
   constant. For a stiff contact this constant is minus the price of the
   contact. For any other contact the constant is the approach that gives its
   present force. */
KERN_SHARED static void kern_norm_approach(kern_part *p, kern_way_of source)
{
    const kern_dual *d = &p->dual;
    const int step = source == KERN_WAY_OF_STEP;
    kern_real *way = step ? d->change : d->approach;
    int k;
    for (k = 0; k < p->supports; k++, way += 2) {
        way[0] = way[1] = 0;
        if (!step && d->law != KERN_LAW_RAYS)
            way[0] = -d->price[k];
        else if (!step)
            kern_model_prior(p->m, p->contact[k], way);
        kern_part_speed(p, k, step ? d->step : d->u, way);
    }
}

/* Writes the gradient of the dual at u: b minus the wrenches that the contacts
   exert at u. Returns the value of the dual, and writes the largest normal
   force to *largest. */
static kern_real kern_norm_gradient(kern_part *p, kern_real *largest)
{
    const kern_dual *d = &p->dual;
    const int n = 3 * p->groups;
    kern_real value = kern_dot(d->load, d->u, n);
    int k;
    *largest = 0;
    kern_copy(d->grad, d->load, n);
    for (k = 0; k < p->supports; k++) {
        const kern_real *w = d->approach + 2 * k;
        const kern_law s = kern_part_law(p, k, w[0], w[1]);
        const kern_real f = s.force.normal, r = s.force.tangential;
        if (!(f > 0))
            continue;
        *largest = kern_max(*largest, f);
        value -= (f * w[0] + r * w[1]) / 2;
        kern_part_exert(p, k, -f, -r, d->grad);
    }
    kern_zero(d->grad + n, 3);
    return value;
}

/* Adds the law s of the part's contact k to the matrix of Newton's method. */
static void kern_part_add(kern_part *p, int k, const kern_law *s)
{
    kern_row row[2];
    kern_part_rows(p, k, row);
    kern_skyline_law(&p->dual.matrix, p->ends + 2 * k, row, s);
}

/* Writes the matrix of Newton's method. The matrix sums the stiffness of the
   contacts that press at u, or for a cold start the stiffness of all contacts.
   Adds KERN_DUAL_SHIFT times the mean of the diagonal to each diagonal
   entry. */
static void kern_norm_matrix(kern_part *p, kern_start start)
{
    const int cold = start == KERN_START_COLD;
    kern_skyline *a = &p->dual.matrix;
    int k;
    kern_skyline_clear(a);
    for (k = 0; k < p->supports; k++) {
        const kern_real *w = p->dual.approach + 2 * k;
        kern_law s = kern_part_law(p, k, w[0], w[1]);
        if (cold && (p->dual.law != KERN_LAW_RAYS || !(s.nn > 0)))
            s = kern_part_law(p, k, 1, 0);
        if (cold
            && p->dual.law
                   == KERN_LAW_STIFF) /* here tt must not depend on mu */
            s.tt = p->dual.shear * s.nn;
        if (s.nn > 0)
            kern_part_add(p, k, &s);
    }
    kern_skyline_shift(a, KERN_DUAL_SHIFT);
}

/* Returns the derivative of the dual along the step of Newton's method, at the
   place u + share * step. `push` is the contribution of the loads to the
   derivative. */
static kern_real kern_norm_slope(const kern_part *p, kern_real push,
                                 kern_real share)
{
    int k;
    for (k = 0; k < p->supports; k++) {
        const kern_real *w = p->dual.approach + 2 * k,
                        *d = p->dual.change + 2 * k;
        const kern_law s = kern_part_law(p, k, w[0] + share * d[0],
                                         w[1] + share * d[1]);
        push -= s.force.normal * d[0] + s.force.tangential * d[1];
    }
    return push;
}

/* Returns the share of the step of Newton's method at which the dual is
   largest. Finds the zero of the derivative along the step by regula falsi,
   since the dual is concave. The search ends where the derivative has become at
   most an eighth of its first value (KERN_SHARE_TOL), or with stiff contacts a
   thousandth (KERN_SHARE_TOL_PRICED). With stiff contacts the work of each
   place is charged. */
KERN_SHARED static kern_real kern_norm_share(const kern_part *p)
{
    const kern_dual *d = &p->dual;
    const kern_real push = kern_dot(d->load, d->step, 3 * p->groups);
    const kern_real first = kern_dot(d->grad, d->step, 3 * p->groups);
    const kern_real slope_end = first
                              / (d->law != KERN_LAW_RAYS ? KERN_SHARE_TOL_PRICED
                                                         : KERN_SHARE_TOL);
    kern_real lo = 0, slope_lo = first, hi = KERN_INFINITY, slope_hi = lo;
    kern_real share = 1;
    int round;

    /* Increases the share until the derivative has changed its sign. Then cuts
       the bracket at the share at which the derivative would be 0 if it were
       linear. */
    for (round = 0;
         round < (hi < KERN_INFINITY ? KERN_SHARE_PLACES : KERN_SHARE_GROWS);
         round++) {
        kern_real slope;
        if (round > 0)
            share = hi < KERN_INFINITY
                      ? (hi * slope_lo - lo * slope_hi) / (slope_lo - slope_hi)
                      : 4 * share;

        slope = kern_norm_slope(p, push, share);
        if (kern_abs(slope) <= slope_end
            || (d->law != KERN_LAW_RAYS
                && !kern_model_spend(p->m,
                                     (p->supports + 12) / KERN_PLACE_UNIT)))
            break;

        /* Moves the end of the bracket at which the derivative has the same
           sign as at the new place. */
        if (slope > 0) {
            slope_hi /= 3; /* otherwise hi would not move for long       */
            lo = share;
            slope_lo = slope;
        } else {
            hi = share;
            slope_hi = slope;
        }
    }
    return share;
}

/* Finds the minimum-norm forces of a part's supports under the loads in
   p->dual.load. `tolerance` is the largest residual of equilibrium that is
   allowed. Returns KERN_STANDS if the forces are found; p->dual.u then gives
   these forces. Returns KERN_FALLS if the norm of the forces exceeds `bound`,
   which is no proof of falling. Returns KERN_UNDECIDED if round number `rounds`
   is reached, and KERN_LIMIT if work is refused. */
static kern_status kern_norm_find(kern_part *p, kern_real tolerance,
                                  kern_real bound, kern_start start, int rounds)
{
    kern_dual *d = &p->dual;
    const int n = 3 * p->groups;
    int i, round;
    KERN_ASSERT(p->supports <= p->contacts);

    /* Sets u and the step to 0 for a cold start. The last three numbers of u
       and of the step, which belong to held blocks, are always 0. */
    for (i = start == KERN_START_COLD ? 0 : n; i < n + 3; i++)
        d->u[i] = d->step[i] = 0;
    kern_norm_approach(p, KERN_WAY_OF_U);

    /* Takes one step of Newton's method in each round, for the contacts that
       press at the present u. */
    for (round = (int)start; round < rounds; round++) {
        kern_real largest, share;
        const kern_real value = kern_norm_gradient(p, &largest);

        /* Ends if the forces are in equilibrium. Also ends if the dual exceeds
           bound^2 / 2: then no forces with a norm up to `bound` exist. */
        if (kern_largest(d->grad, n) <= tolerance + KERN_RESIDUAL * largest)
            return KERN_STANDS;
        if (!(value <= bound * bound / 2))
            return KERN_FALLS;
        if (!kern_model_spend(p->m, d->step_units))
            return KERN_LIMIT;

        /* Takes Newton's step. The first step of a cold start is taken in full,
           since all contacts are assumed to press. */
        kern_norm_matrix(p, round == 0 ? KERN_START_COLD : KERN_START_WARM);
        kern_skyline_factor(&d->matrix);
        kern_skyline_solve(&d->matrix, d->grad, d->step);
        kern_norm_approach(p, KERN_WAY_OF_STEP);
        share = round == 0 ? 1 : kern_norm_share(p);
        kern_add(d->u, share, d->step, n);
        kern_add(d->approach, share, d->change, 2 * p->supports);
    }
    return KERN_UNDECIDED;
}

/* Returns the number of contact points at group g. */
static int kern_graph_degree(const kern_graph *graph, int g)
{
    int e = graph->first_end[g], n = 0;
    for (; e >= 0; e = graph->next_end[e])
        n++;
    return n;
}

/* Lists all groups that contacts connect to group `first`, in the order of a
   breadth-first search. Writes the groups to p->group, from index n down. If a
   group has several new neighbours, those with fewer contacts are listed first.
   Returns the index below that of the last group written. */
static int kern_norm_layers(kern_part *p, int first, int n)
{
    const kern_graph *graph = &p->m->graph;
    int place = n, start, e, k;
    graph->local[first] = KERN_MARKED;
    p->group[n--] = first;
    for (; place > n; place--) {
        start = n;
        for (e = graph->first_end[p->group[place]]; e >= 0;
             e = graph->next_end[e]) {
            const int g = graph->ends[e ^ 1];
            if (g == p->groups || graph->local[g] != KERN_OUT)
                continue;
            graph->local[g] = KERN_MARKED;
            for (k = n--; k < start
                          && kern_graph_degree(graph, g)
                                 < kern_graph_degree(graph, p->group[k + 1]);
                 k++)
                p->group[k] = p->group[k + 1];
            p->group[k] = g;
        }
    }
    return n;
}

/* Makes a part of the groups whose graph.local is KERN_OUT. Lists these groups
   in the order of a breadth-first search that begins at one end of the
   structure, backwards from the last index (reverse Cuthill-McKee order). This
   order keeps the rows of the factor short. */
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

/* Opens all groups whose graph.local is KERN_OUT as one part, and holds the
   other groups. Returns 0 if the work memory is too small or the work is
   refused. */
static int kern_norm_open(kern_part *p, kern_model *m)
{
    const int *local = m->graph.local;
    int i;
    if (!kern_model_spend(
            m, 1 + (m->graph.groups + m->s->contacts) / KERN_ORDER_UNIT))
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
    p->supports = p->contacts;
    return kern_part_ends(p) && kern_norm_lay(p, &p->rest);
}

/* Writes to m->answer the contact forces that the laws give for the approaches
   in dual.approach. */
static void kern_norm_write(kern_part *p)
{
    kern_model *m = p->m;
    int k;
    kern_model_unload(m);
    for (k = 0; k < p->contacts; k++) {
        const kern_real *w = p->dual.approach + 2 * k;
        m->answer.force[p->contact[k]] = kern_part_law(p, k, w[0], w[1]).force;
    }
    kern_scale(m->answer.force, 2 * m->s->contacts, m->weight);
}

/* ---- The top-down pass ------------------------------------------- >>pass */
/* The pass balances the groups from top to bottom. To balance a group, the pass
   changes the forces that carry the group as little as possible, until they
   balance the load of the group and the forces from above. To balance one group
   is a problem in three unknowns. A group that cannot be balanced alone forms a
   cluster with the groups that rest on it. A cluster is open while the pass
   must still balance it. A cluster on which the load has changed becomes open
   again. Forces that balance every group prove that the structure stands. If a
   cluster cannot be balanced, and its motion separates it from all groups that
   rest on it, no forces from above could hold the cluster: it is a part that
   falls.

   The functions that balance a cluster, and kern_pass() itself, return one of
   three results. KERN_STANDS: all groups of the cluster, or of the structure,
   are balanced. KERN_FALLS: a part is open and seems to fall. KERN_UNDECIDED:
   the pass finds neither of these. If memory or work is used up, the result for
   a cluster is KERN_NO_SPACE or KERN_LIMIT, and kern_pass() returns
   KERN_UNDECIDED. */

/* Marks the cluster of group g as open: the pass must balance the cluster, even
   if the pass has balanced it before. */
static void kern_pass_mark_open(kern_model *m, int g)
{
    const int last = m->cluster.last[g];
    m->cluster.flags[last] |= KERN_OPEN;
    if (last < m->cluster.front)
        m->cluster.front = last;
}

/* Writes the force of contact i. `carrier` is the group below the contact, or
   graph.groups if that group needs no mark. If the force changes by more than
   the tolerance, marks the cluster of the carrier as open. */
static void kern_pass_write(kern_model *m, int i, int carrier, kern_force f,
                            kern_real tolerance)
{
    kern_force *force = m->answer.force + i;
    const kern_real change = kern_abs(f.normal - force->normal)
                           + kern_abs(f.tangential - force->tangential);
    KERN_ASSERT(f.normal >= 0);
    if (carrier < m->graph.groups && change > tolerance)
        kern_pass_mark_open(m, carrier);
    *force = f;
}

/* Solves h x = b for a symmetric 3 x 3 matrix h. Reads only the lower half of
   h. An unknown whose pivot is as small as rounding error becomes 0. Returns 1
   if the second and the third pivot are so large that x needs no refinement. */
static int kern_pass_three(const kern_real h[9], const kern_real b[3],
                           kern_real x[3])
{
    const kern_real pivot_min = KERN_THREE_TOL * (h[0] + h[4] + h[8]);
    const kern_real i0 = h[0] > pivot_min ? 1 / h[0] : 0;
    const kern_real l1 = h[3] * i0, l3 = h[6] * i0;
    const kern_real d1 = h[4] - l1 * h[3], e = h[7] - l3 * h[3];
    const kern_real i1 = d1 > pivot_min ? 1 / d1 : 0;
    const kern_real l4 = e * i1, d2 = h[8] - l3 * h[6] - l4 * e;
    const kern_real i2 = d2 > pivot_min ? 1 / d2 : 0;
    const kern_real y1 = b[1] - l1 * b[0], y2 = b[2] - l3 * b[0] - l4 * y1;
    x[2] = y2 * i2;
    x[1] = y1 * i1 - l4 * x[2];
    x[0] = b[0] * i0 - l1 * x[1] - l3 * x[2];
    return kern_min(d1, d2) > KERN_THREE_GOOD * (h[0] + h[4] + h[8]);
}

/* A force along an edge of a friction cone. */
typedef struct kern_ray {
    kern_real wrench[3]; /* wrench on the group if x is 1                   */
    kern_real x;         /* magnitude of the force, in units of
                            kern_pass_unit(); below 0: there is no force    */
    int pressing;        /* nonzero: kern_ray_sum() counts the ray          */
} kern_ray;

/* Writes the two rays of the contact whose row is given. The force x of each
   ray is its force at the approach `way`, divided by `unit`. */
static inline void kern_ray_pair(kern_ray *ray, const kern_row *row,
                                 kern_real mu, const kern_real way[2],
                                 kern_real unit)
{
    const kern_real friction = mu * way[1];
    kern_row_wrench(row, unit, unit * mu, ray[0].wrench);
    kern_row_wrench(row, unit, -unit * mu, ray[1].wrench);
    ray[0].x = (way[0] + friction) / unit;
    ray[1].x = (way[0] - friction) / unit;
    ray[0].pressing = ray[1].pressing = 1;
}

/* Returns the unit in which the forces of contact i are measured. A contact
   with a smaller unit takes less of a load. So upright joints have a smaller
   unit than beds. Otherwise each stone of a course would push the next, and the
   last stone of a long course could not be balanced alone. */
static kern_real kern_pass_unit(const kern_model *m, int i)
{
    const kern_vec g = m->s->gravity;
    const kern_real lift = kern_vec_dot(m->s->contact[i].n, g);
    return 4 * lift * lift < kern_vec_dot(g, g) ? KERN_SIDE_SHARE : KERN_R(1);
}

/* Writes to `residual` b minus the wrenches of the pressing rays. Writes to the
   lower half of h the sum of a a' over the pressing rays, where a is the wrench
   of a ray for x = 1. */
static void kern_ray_sum(const kern_ray *c, int n, const kern_real b[3],
                         kern_real residual[3], kern_real h[9])
{
    kern_zero(h, 9);
    kern_copy(residual, b, 3);
    for (; n > 0; n--, c++) {
        const kern_real *a = c->wrench, x = c->x;
        if (!c->pressing)
            continue;
        residual[0] -= a[0] * x;
        residual[1] -= a[1] * x;
        residual[2] -= a[2] * x;
        h[0] += a[0] * a[0];
        h[3] += a[1] * a[0];
        h[4] += a[1] * a[1];
        h[6] += a[2] * a[0];
        h[7] += a[2] * a[1];
        h[8] += a[2] * a[2];
    }
}

/* Changes the forces of the n rays as little as possible so that they exert the
   wrench b, by Newton's method with full steps. Returns KERN_STANDS if it
   succeeds, KERN_FALLS if the rays cannot exert b, and KERN_UNDECIDED if the
   method does not converge. */
static kern_status kern_pass_solve(kern_ray *c, int n, const kern_real b[3],
                                   kern_real tolerance)
{
    kern_real residual[3], h[9], step[3], u[3] = {0, 0, 0},
                                          last = KERN_INFINITY;
    int k, round,
        unchanged = 0; /* 1: the same rays press as in the last round */
    for (round = 0; round < KERN_ALONE_ROUNDS; round++) {
        /* Computes the residual of the rays that press now. If the same rays
           pressed in the last round, the step of that round solved a linear
           problem. A residual that has not become much smaller by such a step
           (KERN_ALONE_PACE) shows that no solution exists. */
        const kern_real goal = last / KERN_ALONE_PACE;
        int regular, changed = 0;
        kern_ray_sum(c, n, b, residual, h);
        last = kern_largest(residual, 3);
        if (unchanged && last <= tolerance + KERN_RESIDUAL * kern_largest(u, 3))
            return KERN_STANDS;
        if (unchanged && last > goal)
            return KERN_FALLS;

        /* Takes a full step. A ray begins or stops pressing if the sign of its
           force has changed, except while a solution is refined. */
        regular = kern_pass_three(h, residual, step);
        kern_add(u, 1, step, 3);
        for (k = 0; k < n; k++) {
            c[k].x += kern_three(c[k].wrench, step);
            if (!unchanged && (c[k].x > 0) != c[k].pressing) {
                c[k].pressing = !c[k].pressing;
                changed = 1;
            }
        }

        /* Ends if the same rays press after the step as before it, and no pivot
           was so small that the solution needs refinement. */
        if (regular && !changed)
            return KERN_STANDS;
        unchanged = !changed;
    }
    return KERN_UNDECIDED;
}

/* Balances group g alone, by the forces of the contacts that carry it. Returns
   KERN_STANDS if the group is balanced, KERN_FALLS if no forces of these
   contacts balance it, and KERN_UNDECIDED if too many contacts carry it or
   Newton's method does not converge. */
static kern_status kern_pass_alone(kern_model *m, int g)
{
    const kern_real tolerance = KERN_PASS_TOL * m->load_size[g];
    kern_ray c[2 * KERN_ROWS_MOST];
    int end[KERN_ROWS_MOST]; /* ends at g of the contacts that carry it */
    kern_real unit[KERN_ROWS_MOST], b[3];
    kern_status status;
    int e, k, n = 0;

    /* Sums in b the load of the group and the forces of the contacts above it.
       Each contact that carries the group gives two rays, which start from the
       present force of the contact. */
    kern_copy(b, m->load + 3 * g, 3);
    for (e = m->graph.first_end[g]; e >= 0; e = m->graph.next_end[e]) {
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
        unit[n] = kern_pass_unit(m, e >> 1);
        kern_ray_pair(c + 2 * n, &row, mu, way, unit[n]);
        end[n++] = e;
    }

    /* Writes the new forces of the contacts that carry the group. If a force
       has changed, the cluster of the group below that contact becomes open. */
    status = kern_pass_solve(c, 2 * n, b, tolerance);
    for (k = 0; k < n && status == KERN_STANDS; k++) {
        const kern_real plus = unit[k] * kern_max(c[2 * k].x, 0);
        const kern_real minus = unit[k] * kern_max(c[2 * k + 1].x, 0);
        const kern_force f = {plus + minus,
                              kern_model_mu(m, end[k] >> 1) * (plus - minus)};
        kern_pass_write(m, end[k] >> 1, m->graph.ends[end[k] ^ 1], f,
                        tolerance);
    }
    return status;
}

/* Joins the two clusters that contain the groups g and h. */
static void kern_pass_join(kern_model *m, int g, int h)
{
    kern_clusters *c = &m->cluster;
    const int swap = c->next[g];
    const int last = c->last[g] > c->last[h] ? c->last[g] : c->last[h];
    int i = g;
    c->flags[c->last[g]] = c->flags[c->last[h]] = 0;
    c->next[g] = c->next[h];
    c->next[h] = swap;
    do {
        c->last[i] = last;
        i = c->next[i];
    } while (i != g);
}

/* Writes `mark` to graph.local of each group of the cluster that contains g.
   Returns the number of groups in this cluster. */
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

/* Grows a cluster that could not be balanced: joins all clusters that rest on
   it. `last` is the last group of the cluster. Marks the cluster as open again.
   Returns 0 if no cluster rests on this cluster, or if it has become too
   large. */
static int kern_pass_grow(kern_model *m, int last)
{
    const kern_clusters *c = &m->cluster;
    int g = last, next, e, joined = 0;

    /* Joins the cluster of every group that rests on the cluster of `last`.
       Reads `next` before each join, so that the loop skips the groups that are
       new in the cluster. */
    do {
        next = c->next[g];
        for (e = m->graph.first_end[g]; e >= 0; e = m->graph.next_end[e]) {
            const int h = m->graph.ends[e ^ 1];
            if (h < g && c->last[h] != c->last[g]) {
                kern_pass_join(m, g, h);
                joined = 1;
            }
        }
        g = next;
    } while (g != last);

    kern_pass_mark_open(m, last);
    return joined && kern_pass_mark(m, last, KERN_OUT) <= c->groups_max;
}

/* Writes the minimum-norm forces of a part's supports, and marks the clusters
   below whose load changes as open. If the part has been balanced before, each
   open cluster joins the part that carries it and whose last group comes before
   the last group of the part in the order of the pass. Otherwise this cluster
   and the part would be balanced alternately without end. */
static void kern_pass_keep(kern_part *p, kern_real tolerance)
{
    kern_model *m = p->m;
    int *const cluster = m->cluster.last, *const flags = m->cluster.flags;
    const int last = p->group[p->groups - 1], tried = flags[last] & KERN_TRIED;
    int k;

    flags[last] |= KERN_TRIED;

    /* Writes the force of each support. The groups of the part are balanced, so
       only groups outside of the part may have to be balanced again. */
    for (k = 0; k < p->supports; k++) {
        const int i = p->contact[k], *ends = m->graph.ends + 2 * i;
        const kern_real *w = p->dual.approach + 2 * k;
        const kern_law s = kern_part_law(p, k, w[0], w[1]);
        const int low = ends[0] > ends[1] ? 0 : 1, carrier = ends[low];
        const int in_part = p->ends[2 * k + low] < p->groups;
        kern_pass_write(m, i, in_part ? m->graph.groups : carrier, s.force,
                        tolerance);

        if (tried && carrier < m->graph.groups && cluster[carrier] < last
            && (flags[cluster[carrier]] & KERN_OPEN)) {
            kern_pass_join(m, carrier, last);
            kern_pass_mark_open(m, last);
        }
    }
}

/* Returns 1 if no force from above can hold a part that cannot be balanced.
   Checks that the motion u of the part separates it from all groups that rest
   on it, and that the loads of the part do positive work in this motion. */
static int kern_pass_parts(kern_part *p)
{
    const kern_real limit = KERN_PARTS_TOL
                          * kern_largest(p->dual.u, 3 * p->groups);
    kern_real power = 0;
    int n, k;

    /* Sums the power of the loads of the part. */
    for (n = 0; n < p->groups; n++)
        power += kern_dot(p->dual.u + 3 * n, p->m->load + 3 * p->group[n], 3);

    /* Checks that the motion closes no contact with a group above the part, not
       even along an edge of its friction cone. */
    for (k = p->supports; k < p->contacts; k++) {
        kern_real w[2] = {0, 0};
        kern_part_speed(p, k, p->dual.u, w);
        if (w[0] + kern_model_mu(p->m, p->contact[k]) * kern_abs(w[1]) > limit)
            return 0;
    }
    return power > 0;
}

/* Opens the cluster whose last group is `last` as a part. If the minimum-norm
   forces of this part are found, writes these forces and returns KERN_STANDS.
   Returns KERN_FALLS if no forces balance the part while all other blocks are
   held, and the motion of the part separates it from all groups that rest on
   it. */
KERN_SHARED static kern_status kern_pass_part(kern_part *p, kern_model *m,
                                              int last)
{
    kern_real load = 0, lightest = KERN_INFINITY;
    kern_status status;
    kern_take take;
    int n;

    /* Ends if the work memory is too small for the part, or if the rest of the
       pass's budget is too small for one step of Newton's method. */
    if (!kern_part_open(p, m, kern_pass_mark(m, last, KERN_MARKED), last))
        return KERN_NO_SPACE;
    take = p->rest;
    if (!kern_norm_lay(p, &take)
        || p->dual.step_units > m->cluster.budget_end - m->task->work->units)
        return KERN_NO_SPACE;

    /* Sums in dual.load the loads of the groups and the forces of the contacts
       above them. `load` is the sum of the magnitudes of the loads and of the
       numbers in dual.load. `lightest` is the smallest load of a group, which
       determines the largest residual. */
    for (n = 0; n < p->groups; n++) {
        lightest = kern_min(lightest, m->load_size[p->group[n]]);
        load += m->load_size[p->group[n]];
        kern_copy(p->dual.load + 3 * n, m->load + 3 * p->group[n], 3);
    }
    for (n = p->supports; n < p->contacts; n++) {
        const kern_force *f = m->answer.force + p->contact[n];
        kern_part_exert(p, n, -f->normal, -f->tangential, p->dual.load);
    }
    for (n = 0; n < 3 * p->groups; n++)
        load += kern_abs(p->dual.load[n]);

    /* Finds the minimum-norm forces. If the norm of the forces exceeds its
       bound, the part counts as one that no forces balance. Even such a part
       falls only if its motion separates it from all groups that rest on it. */
    status = kern_norm_find(p, KERN_PASS_TOL * lightest,
                            KERN_CLUSTER_NORM * load, KERN_START_COLD,
                            KERN_NORM_ROUNDS);
    if (status == KERN_STANDS)
        kern_pass_keep(p, KERN_PASS_TOL * lightest);
    if (status == KERN_FALLS && p->supports < p->contacts
        && !kern_pass_parts(p))
        status = KERN_UNDECIDED;
    return status;
}

/* Balances the cluster whose last group is `last`. After KERN_FALLS this
   cluster is open as part *p and seems to fall. */
static kern_status kern_pass_cluster(kern_model *m, kern_part *p, int last)
{
    kern_status status = m->cluster.next[last] == last
                           ? kern_pass_alone(m, last)
                           : KERN_UNDECIDED;

    /* If no forces balance a single group, and nothing rests on it, the group
       falls as a part. If groups rest on this group, their forces could hold
       it, so the result is undecided and the cluster grows. */
    if (status == KERN_FALLS) {
        if (!kern_part_open(p, m, kern_pass_mark(m, last, KERN_MARKED), last)
            || p->supports < p->contacts)
            status = KERN_UNDECIDED;
    } else if (status == KERN_UNDECIDED)
        status = kern_pass_part(p, m, last);

    if (status != KERN_FALLS)
        kern_pass_mark(m, last, KERN_OUT);
    return status;
}

/* Makes the next pass begin with the known forces of a similar structure, if
   there are any. If the kerns are at least as large as those for which these
   forces were found, the pass begins with only the last block open. */
static void kern_known_begin(kern_model *m, kern_real shrink)
{
    const kern_known *known = m->answer.known;
    if (!known
        || !kern_model_spend(
            m, 1 + (m->graph.groups + m->s->contacts) / KERN_KNOWN_UNIT))
        return;
    kern_copy(m->answer.force, known->force, 2 * m->s->contacts);
    if (shrink < known->holds)
        kern_force_transfer(m, known->holds, shrink);
    if (shrink <= known->holds)
        m->cluster.unbalanced = m->graph.group[m->s->blocks - 1];
}

/* Begins a pass with the present forces in m->answer. Makes each group a
   cluster of its own. If known forces balance all groups except perhaps one
   (`unbalanced`), opens only the cluster of that group. Otherwise opens all
   clusters. A cluster may have at most groups / share + 1 groups. If there are
   more than KERN_SMALL groups, the largest size of a cluster depends only on
   the number of groups. */
static void kern_pass_begin(kern_model *m, int share)
{
    kern_clusters *c = &m->cluster;
    const int groups = m->graph.groups, unbalanced = c->unbalanced;
    int i;
    c->unbalanced = KERN_OUT;
    c->groups_max = groups > KERN_SMALL
                      ? KERN_CLUSTER_MOST + groups / KERN_CLUSTER_MORE
                      : groups / share + 1;
    for (i = c->front = 0; i < groups; i++) {
        c->last[i] = c->next[i] = i;
        c->flags[i] = unbalanced == KERN_OUT || unbalanced == i ? KERN_OPEN : 0;
        m->graph.local[i] = KERN_OUT; /* no part is open now */
    }
}

/* Runs the pass: balances all open clusters from top to bottom. A cluster that
   cannot be balanced grows until it is balanced, falls or becomes too large.
   After KERN_FALLS the falling cluster is open as part *p. */
static kern_status kern_pass(kern_model *m, kern_part *p)
{
    kern_clusters *c = &m->cluster;
    c->budget_end = m->task->work->units
                  + KERN_PASS_UNITS * (m->s->contacts + m->graph.groups);

    /* Moves the front down, one group after the other. If a cluster above the
       front must be balanced again, kern_pass_mark_open() has moved the front
       back up to that cluster. The budget ends a pass that does not
       converge. */
    while (c->front < m->graph.groups) {
        const int g = c->front++;
        kern_status status;
        if (!(c->flags[g] & KERN_OPEN))
            continue;
        if (m->task->work->units > c->budget_end || !kern_model_spend(m, 1))
            return KERN_UNDECIDED;

        c->flags[g] -= KERN_OPEN;
        status = kern_pass_cluster(m, p, g);
        if (status == KERN_FALLS)
            return status;
        if (status != KERN_STANDS
            && !(status == KERN_UNDECIDED && kern_pass_grow(m, g)))
            return KERN_UNDECIDED; /* also if memory or work is used up */
    }
    return KERN_STANDS;
}

/* ---- Interior point ---------------------------------------------- >>ipm */
/* The interior-point method finds the verdict on all groups at once, in about
   ten factorisations. The method begins with forces x > 0 that are not in
   equilibrium: their residual is g = A x - b. The linear program

       max s,  A x + s g = b,  x >= 0,  s <= 0,

   finds how much of this residual can be removed. The first forces solve the
   equations of this program with s = -1. The structure stands if s reaches 0.
   At the maximum

       A x = b - s g,   A'y = z >= 0,   g.y = 1,   x z = 0 for every ray.

   If the maximum of s is below 0, the structure falls, and y is the mechanism.
   A primal-dual method follows the solutions with x z = mu > 0 to mu = 0, where
   mu is not friction but the same number for all rays. The method takes steps
   of Newton's method:

       M dy - g ds = A x~ + s g - b,  g.dy = 1 - g.y,  M = A D A',  D = x / z,

   with the forces x~ = x + mu / z - D A'y. In each step these equations are
   solved twice with one factor (Mehrotra). The predictor, with mu = 0, gives
   the mu and the products dx dz of the corrector. Along a path each query
   starts from the x, y, z and s of the last query.

   With costs c the same method solves another program (kern_ipm_minimise()):

       min c.x,  A x = b,  x >= 0.

   Then g and s are 0, and z is A'y + c instead of A'y. */

typedef struct kern_ipm {
    kern_part *part;       /* all groups; x, y, eq.rhs: x, y, b of >>ipm */
    kern_real s;           /* minus the share of g that remains          */
    kern_real duality_gap; /* sum of x z: distance of s from its maximum */
    kern_real *z;          /* per ray: its opening speed                 */
    kern_real *dx;         /* per ray: step of x; dual.change: step of z */
    kern_real *scaling;    /* per ray: D = x / z                         */
    kern_real *excess;     /* per row: A x - b + s g                     */
    kern_real *g;          /* per row: residual of the first forces      */
    kern_real *solved_g;   /* per row: M^-1 g                            */
    const kern_real *cost; /* per ray: c; NULL: there are no costs       */
} kern_ipm;

#ifndef KERN_NO_INTERIOR
/* Writes A'v to `out`: for each contact the speeds of the motion v along its
   two rays. */
static void kern_ipm_approach(const kern_part *p, const kern_real *v,
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

/* Adds A x to `out`: the wrenches of the forces x on the groups. */
static void kern_ipm_carry(const kern_part *p, const kern_real *x,
                           kern_real *out)
{
    int k;
    for (k = 0; k < p->contacts; k++, x += 2)
        kern_part_exert(p, k, x[0] + x[1],
                        kern_model_mu(p->m, p->contact[k]) * (x[0] - x[1]),
                        out);
}

/* Computes the excess A x - b + s g and the duality gap, the sum of x z. */
static void kern_ipm_excess(kern_ipm *ipm)
{
    const kern_part *p = ipm->part;
    int i;
    for (i = 0; i < 3 * p->groups; i++)
        ipm->excess[i] = ipm->s * ipm->g[i] - p->eq.rhs[i];
    kern_ipm_carry(p, p->x, ipm->excess);
    ipm->duality_gap = kern_dot(p->x, ipm->z, 2 * p->contacts);
}

/* Factors the matrix M = A D A' with D = ipm->scaling, and solves M out = b for
   `out`. First adds `shift` times the mean of the diagonal of M to each
   diagonal entry. */
static void kern_ipm_factor(kern_ipm *ipm, kern_real shift, const kern_real *b,
                            kern_real *out)
{
    kern_part *p = ipm->part;
    int k;
    kern_skyline_clear(&p->dual.matrix);
    for (k = 0; k < p->contacts; k++) {
        const kern_real plus = ipm->scaling[2 * k],
                        minus = ipm->scaling[2 * k + 1];
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

/* Returns the largest share of `step`, at most 1, that can be added to v so
   that no entry of v becomes negative. */
static kern_real kern_ipm_share(const kern_real *v, const kern_real *step,
                                int n)
{
    kern_real share = 1;
    int i;
    for (i = 0; i < n; i++)
        if (v[i] < -share * step[i])
            share = v[i] / -step[i];
    return share;
}

/* Raises the smaller of x and z of each ray until their product is at least
   gap / rays. Computes the excess and the duality gap again. */
static void kern_ipm_centre(kern_ipm *ipm, kern_real gap)
{
    const int rays = 2 * ipm->part->contacts;
    const kern_real mean = gap / KERN_R(rays);
    kern_real *x = ipm->part->x, *z = ipm->z;
    int i;
    for (i = 0; i < rays; i++)
        if (x[i] * z[i] < mean)
            *(x[i] > z[i] ? &z[i] : &x[i]) = mean / kern_max(x[i], z[i]);
    kern_ipm_excess(ipm);
}

/* Solves the equations of one step (>>ipm). ipm->dx must hold x~ - x, and
   becomes the step dx. Writes dy to dual.step and dz to dual.change. Returns
   ds, at most -s. */
static kern_real kern_ipm_solve(kern_ipm *ipm)
{
    kern_part *p = ipm->part;
    kern_dual *d = &p->dual;
    kern_real *approach = d->approach, *change = d->change;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real ds;
    int i;
    kern_copy(d->grad, ipm->excess, n);
    kern_ipm_carry(p, ipm->dx, d->grad);
    kern_skyline_solve(&d->matrix, d->grad, d->step);
    ds = (1 - kern_dot(ipm->g, p->y, n) - kern_dot(ipm->g, d->step, n))
       / kern_dot(ipm->g, ipm->solved_g, n); /* infinite if there are costs */
    ds = kern_min(ds, -ipm->s);
    kern_add(d->step, ds, ipm->solved_g, n);
    kern_ipm_approach(p, d->step, change);
    for (i = 0; i < rays; i++) {
        ipm->dx[i] -= ipm->scaling[i] * change[i];
        change[i] = approach[i] + change[i] - ipm->z[i];
    }
    return ds;
}

/* Takes one step of the interior-point method, with a predictor and a
   corrector. Returns 0 if the work of the step is refused or rounding spoils
   the step. */
static int kern_ipm_step(kern_ipm *ipm)
{
    kern_part *p = ipm->part;
    kern_real *dx = ipm->dx, *dz = p->dual.change;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real share_x = 0, share_z = share_x, mu = share_x, rest = share_x, ds;
    int i, corrects;

    KERN_ASSERT(ipm->s <= 0);
    if (!(ipm->duality_gap <= KERN_IPM_GAP_MOST)
        || !kern_model_spend(p->m, p->dual.step_units))
        return 0;

    /* Factors M = A D A' once, for predictor and corrector. If M is singular,
       factors it again with a shifted diagonal. */
    for (i = 0; i < rays; i++) {
        ipm->scaling[i] = p->x[i] / ipm->z[i];
        dx[i] = dz[i] = 0;
    }
    kern_ipm_factor(ipm, 0, ipm->g, ipm->solved_g);
    if (!kern_is_finite(kern_dot(ipm->g, ipm->solved_g, n)))
        kern_ipm_factor(ipm, KERN_IPM_SHIFT, ipm->g, ipm->solved_g);
    kern_ipm_approach(p, p->y, p->dual.approach);
    if (ipm->cost)
        kern_add(p->dual.approach, 1, ipm->cost, rays);

    /* Solves for the predictor, which aims at mu = 0, and then for the
       corrector. The corrector aims at the mu that the predictor allows, and
       includes the predictor's products dx dz. */
    for (corrects = 0;; corrects = 1) {
        for (i = 0; i < rays; i++)
            dx[i] = (mu - share_x * share_z * dx[i] * dz[i]) / ipm->z[i]
                  - ipm->scaling[i] * p->dual.approach[i];
        ds = kern_ipm_solve(ipm);
        share_x = kern_ipm_share(p->x, dx, rays);
        share_z = kern_ipm_share(ipm->z, dz, rays);
        if (corrects)
            break;
        for (i = 0; i < rays; i++)
            rest += (p->x[i] + share_x * dx[i]) * (ipm->z[i] + share_z * dz[i]);

        rest = kern_max(kern_max(rest / ipm->duality_gap, 1 - share_x),
                        KERN_IPM_AIM);
        mu = ipm->duality_gap * rest * rest * rest / KERN_R(rays);
    }

    /* Shortens the step so that x and z stay above 0. If the whole step keeps x
       above 0, x takes the whole step. */
    rest = kern_min(KERN_IPM_BACKOFF * rest, KERN_IPM_BACKOFF);
    share_z -= share_z * rest;
    if (share_x < 1)
        share_x -= share_x * rest;

    /* Takes the step. Rounding must not make s positive. */
    ipm->s = kern_min(ipm->s + share_x * ds, 0);
    for (i = 0; i < rays; i++) {
        p->x[i] = kern_max(p->x[i] + share_x * dx[i], p->x[i] * KERN_IPM_KEEP);
        ipm->z[i] += share_z * dz[i];
    }

    kern_add(p->y, share_z, p->dual.step, n);
    kern_ipm_centre(ipm, KERN_IPM_CENTRE * kern_dot(p->x, ipm->z, rays));
    KERN_AUDIT(ipm, ipm);
    return kern_is_finite(ipm->duality_gap);
}

/* Corrects the forces x so that only rounding error is left of their residual
   A x - b. Uses D = x instead of x / z, which keeps M far from singular.
   Returns 1 if the corrected forces prove that the structure stands. */
static int kern_ipm_balance(kern_ipm *ipm, const kern_query *q)
{
    kern_part *p = ipm->part;
    const int rays = 2 * p->contacts;
    kern_real *change = p->dual.change;
    int i;
    kern_copy(ipm->scaling, p->x, rays);
    kern_ipm_factor(ipm, 0, ipm->excess, p->dual.step);
    kern_ipm_approach(p, p->dual.step, change);
    for (i = 0; i < rays; i++)
        p->x[i] -= p->x[i] * kern_min(change[i], 1 - KERN_IPM_BALANCE);
    kern_ipm_excess(ipm);
    return kern_part_stands(p, q);
}

/* Adds the same number to all n entries of v, so that they become positive.
   This number is KERN_IPM_LIFT_LEAST times the magnitude of the least entry, if
   that entry is negative, plus KERN_IPM_LIFT_SHARE times the largest magnitude
   of an entry. */
static void kern_ipm_lift(kern_real *v, int n)
{
    kern_real lift = 0;
    int i;
    for (i = 0; i < n; i++)
        lift = kern_max(lift, -KERN_IPM_LIFT_LEAST * v[i]);
    lift += KERN_IPM_LIFT_SHARE * kern_largest(v, n);
    for (i = 0; i < n; i++)
        v[i] += lift;
}

/* Computes the first forces x of the interior-point method (Mehrotra): the
   minimum-norm solution of A x = b for rays of equal stiffness that can also
   pull, raised above 0. Sets g and z to 0. Returns 0 if the work is refused. */
static int kern_ipm_forces(kern_ipm *ipm)
{
    kern_part *p = ipm->part;
    const int rays = 2 * p->contacts;
    int i;
    if (!kern_model_spend(p->m, p->dual.step_units))
        return 0;
    for (i = 0; i < rays; i++) {
        ipm->z[i] = 0;
        ipm->scaling[i] = 1;
    }
    kern_zero(ipm->g, 3 * p->groups);
    kern_ipm_factor(ipm, KERN_IPM_SHIFT, p->eq.rhs, p->y);
    kern_ipm_approach(p, p->y, p->x);
    kern_ipm_lift(p->x, rays);
    return 1;
}

/* Computes the starting point of a verdict. The speeds z are the opening speeds
   of a motion y, raised above 0. Returns 0 if the first forces are in
   equilibrium, or if the work is refused. */
static int kern_ipm_begin(kern_ipm *ipm)
{
    kern_part *p = ipm->part;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    kern_real power;
    int i;
    if (!kern_ipm_forces(ipm))
        return 0;

    /* Computes g: the residual A x - b of the first forces. */
    ipm->s = -1;
    kern_ipm_excess(ipm);
    kern_copy(ipm->g, ipm->excess, n);

    /* Computes y, the least motion with g.y = 1. Computes z, the opening speeds
       of the rays in this motion, raised above 0. */
    kern_skyline_solve(&p->dual.matrix, ipm->g, ipm->solved_g);
    power = kern_dot(ipm->g, ipm->solved_g, n);
    if (!(power > 0))
        return 0;

    for (i = 0; i < n; i++)
        p->y[i] = ipm->solved_g[i] / power;
    kern_ipm_approach(p, p->y, ipm->z);
    kern_ipm_lift(ipm->z, rays);
    kern_ipm_excess(ipm);
    return 1;
}

/* Opens all groups as one part for the interior-point method, for queries on
   the path of q. Returns 0 if the work memory is too small, if the work is
   refused or if there is no contact. */
static int kern_ipm_open(kern_ipm *ipm, kern_model *m, kern_part *p,
                         const kern_query *q)
{
    int rays, n;

    /* Makes the groups again if a program of all groups has overwritten the
       lists of their contacts. */
    if (m->whole)
        kern_model_group(m, q);
    kern_model_set(m, q);
    if (!kern_norm_open(p, m) || p->contacts == 0)
        return 0;

    rays = 2 * p->contacts;
    n = 3 * p->groups + 3;
    ipm->part = p;
    ipm->cost = NULL;
    ipm->duality_gap = KERN_INFINITY; /* no query has been answered so far */
    p->x = kern_take_reals(&p->rest, 4 * rays + 5 * n - 3);
    if (!kern_take_fits(&p->rest))
        return 0;

    /* Divides the memory into nine arrays: four with a number for each ray,
       then five with a number for each row. Each array of rows except the last
       one has three more numbers for held blocks. */
    ipm->z = p->x + rays;
    ipm->dx = ipm->z + rays;
    ipm->scaling = ipm->dx + rays;
    p->y = ipm->scaling + rays;
    ipm->excess = p->y + n;
    ipm->g = ipm->excess + n;
    ipm->solved_g = ipm->g + n;
    p->eq.rhs = ipm->solved_g + n;

    /* Sets the fields of p->eq that a search reads. */
    p->eq.rate = p->dual.grad;
    p->eq.shrink = KERN_INFINITY; /* there are no columns */
    kern_zero(p->y, 4 * n);       /* held blocks rest     */
    kern_zero(p->dual.step, n);
    return 1;
}

/* Takes steps until forces with s = 0 prove that the structure stands, or the
   motion y proves that it falls. Returns KERN_UNDECIDED if the duality gap has
   become as small as rounding error or exceeds `pace`. `pace` is multiplied by
   KERN_IPM_PACE after each step. */
static kern_status kern_ipm_run(kern_ipm *ipm, const kern_query *q,
                                kern_real pace)
{
    int round = 0;
    while (round++ < KERN_IPM_ROUNDS && ipm->duality_gap > KERN_IPM_GAP_LEAST
           && ipm->duality_gap <= pace && kern_ipm_step(ipm)) {
        if (ipm->s >= 0
            && (kern_part_stands(ipm->part, q) || kern_ipm_balance(ipm, q)))
            return KERN_STANDS;
        if (kern_part_falls(ipm->part, q))
            return KERN_FALLS;
        pace *= KERN_IPM_PACE;
    }
    return KERN_UNDECIDED;
}

/* Returns the verdict of the interior-point method for a query. Starts from the
   x, y, z and s of the last query. If that start gives no verdict, starts again
   from the point of kern_ipm_begin(). */
static kern_status kern_ipm_evaluate(kern_ipm *ipm, const kern_query *q)
{
    kern_part *p = ipm->part;
    kern_model *m = p->m;
    kern_status status = KERN_UNDECIDED;
    if (!kern_model_charge(m, 1))
        return KERN_LIMIT;

    m->task->work->solves++;
    kern_model_arms(m, q);
    kern_part_load(p, q, p->eq.rhs);

    /* Starts from the solution of the last query, raised a little above 0,
       which saves steps. */
    if (ipm->duality_gap <= KERN_IPM_GAP_MOST) {
        ipm->s = kern_min(ipm->s, -KERN_IPM_S);
        kern_ipm_centre(ipm, kern_max(ipm->duality_gap, KERN_IPM_GAP));
        status = kern_ipm_run(ipm, q, KERN_IPM_SLACK * ipm->duality_gap);
    }

    if (status == KERN_UNDECIDED && kern_ipm_begin(ipm))
        status = kern_ipm_run(ipm, q, KERN_INFINITY);
    return p->result = status;
}

/* Finds forces x and a motion y that solve

       min cost.x,  A x = b,  x >= 0,    A'y + cost = z >= 0,  x z = 0.

   If x and y are not unique, finds those in the middle of all solutions. Starts
   from the forces of the last program if that program was solved. Sets x to 0
   where it is much smaller than z. `lightest` is the magnitude of the lightest
   load. Returns KERN_LP_OPTIMAL, or KERN_UNDECIDED if no solution is found, as
   when no forces exist or their cost has no least value. */
static kern_status kern_ipm_minimise(kern_ipm *ipm, const kern_real *cost,
                                     kern_real lightest)
{
    kern_part *p = ipm->part;
    kern_dual *d = &p->dual;
    const int n = 3 * p->groups, rays = 2 * p->contacts;
    const int first = !ipm->cost;
    int i, round;
    p->m->task->work->solves++;
    if (first && !kern_ipm_forces(ipm))
        return KERN_UNDECIDED;

    /* Starts with y = 0. Raises x and z well above 0. */
    ipm->cost = cost;
    ipm->s = 0;
    kern_zero(p->y, n);
    for (i = 0; i < rays; i++) {
        ipm->z[i] = kern_max(kern_abs(cost[i]), KERN_IPM_COST);
        p->x[i] = kern_max(p->x[i], KERN_IPM_COST * lightest);
    }
    kern_ipm_excess(ipm);

    /* Takes steps until A x = b, z = A'y + cost and x z = 0 hold. */
    for (round = 0; round < KERN_IPM_ROUNDS; round++) {
        kern_ipm_approach(p, p->y, d->change);
        kern_add(d->change, 1, cost, rays);
        kern_add(d->change, -1, ipm->z, rays);
        if (ipm->duality_gap <= KERN_IPM_COST_TOL * lightest
            && kern_largest(ipm->excess, n) <= KERN_IPM_COST_TOL * lightest
            && kern_largest(d->change, rays) <= KERN_IPM_COST_TOL) {
            for (i = 0; i < rays; i++)
                p->x[i] *= KERN_R(p->x[i]
                                  > KERN_IPM_PRESSES * lightest * ipm->z[i]);
            return KERN_LP_OPTIMAL;
        }
        if (!kern_ipm_step(ipm))
            break;
    }
    ipm->cost = NULL; /* the next program starts anew */
    return KERN_UNDECIDED;
}

/* Opens the interior-point method and returns its verdict on all groups for a
   query. */
static kern_status kern_ipm_verdict(kern_model *m, kern_part *p,
                                    const kern_query *q)
{
    kern_ipm ipm;
    return kern_ipm_open(&ipm, m, p, q) ? kern_ipm_evaluate(&ipm, q)
                                        : KERN_UNDECIDED;
}
#else /* without the interior-point method these calls decide nothing */
#define kern_ipm_open(in, m, p, q) 0
#define kern_ipm_evaluate(in, q) KERN_UNDECIDED
#define kern_ipm_minimise(in, cost, lightest) KERN_UNDECIDED
#define kern_ipm_verdict(m, p, q) KERN_UNDECIDED
#endif

/* ---- Verdicts ------------------------------------------------- >>verdict */

/* Takes the arrays for the linear program of a part. Gives the factors of the
   basis the largest room that fits into the work memory (KERN_EXTRAS). Returns
   0 if not even the least room fits (KERN_LEAN_EXTRAS). */
static int kern_part_lay(kern_part *p)
{
    kern_equations *const eq = &p->eq;
    const int n = p->groups;
    /* clang-format off */
    const kern_program lp = {3 * n, 2 * p->contacts, NULL, NULL, NULL, p->ends,
                             NULL, 0, KERN_BOUND, p->m->task->options.limit,
                             p->m->task->work};
    /* clang-format on */
    int room = KERN_EXTRAS(n);
    eq->lp = lp;
    eq->shrink = KERN_INFINITY; /* there are no columns */

    /* Tries smaller and smaller rooms for the factors. If the room is small,
       the basis must be factored again more often. */
    for (; room >= KERN_LEAN_EXTRAS(n); room--) {
        kern_take take = p->rest;
        eq->lp.a = eq->arc = kern_take_reals(&take,
                                             10 * p->contacts + 9 * n + 7);
        eq->lp.rhs = eq->rhs = eq->arc + 8 * p->contacts;
        eq->lp.rate = eq->rate = eq->rhs + 3 * n;
        p->y = eq->rate + 3 * n + 3;
        p->x = p->y + 3 * n + 3;
        kern_simplex_lay(&eq->simplex, &eq->lp, KERN_ROOM(room), &take);
        if (kern_take_fits(&take)) {
            kern_zero(p->y + 3 * n, 3);
            return 1;
        }
    }
    return 0;
}

/* Writes Eq. (5) for a query: two columns per contact, along the edges n + mu t
   and n - mu t of its friction cone, and the loads as the right-hand side. */
static void kern_part_set(kern_part *p, const kern_query *q)
{
    kern_equations *const eq = &p->eq;
    kern_model *m = p->m;
    int k, edge;
    KERN_ASSERT(eq->lp.rows == 3 * p->groups);
    m->reduction = kern_reduction(q);

    /* Sets the units of torque and the loads, which depend on the whole
       query. */
    for (k = 0; k < p->groups; k++)
        kern_model_unit(m, q, p->group[k]);
    kern_part_load(p, q, eq->rhs);

    /* Writes the columns, which depend only on the shrinkage. If the columns
       have changed, the basis must be factored again. */
    if (eq->shrink >= q->shrink && eq->shrink <= q->shrink)
        return;
    eq->shrink = q->shrink;
    kern_simplex_change(&eq->simplex, KERN_BASIS_STALE);
    for (k = 0; k < p->contacts; k++) {
        kern_real *f = eq->arc + 8 * k;
        kern_real mu = kern_model_mu(m, p->contact[k]);
        kern_row row[2];
        kern_model_rows(m, q, p->contact[k], row);
        for (edge = 0; edge < 2; edge++, f += 4, mu = -mu) {
            kern_row_wrench(row, 1, mu, f);
            f[3] = row[1].n[2] + mu * row[1].torque;
        }
    }
}

/* Returns 1 if the part has all groups of the structure. Only the forces of
   such a part can prove that the structure stands. */
static int kern_part_is_whole(const kern_part *p)
{
    return p->groups == p->m->graph.groups;
}

/* Checks the proof of `status`, the result of the simplex method. Returns the
   status if its proof holds. Returns KERN_STANDS if the proof of a fall fails
   but the forces of the whole structure are a proof. Returns KERN_UNDECIDED if
   nothing is proven. A negative status is returned unchanged. KERN_STANDS of a
   part that does not have all groups is also returned unchanged, since it is no
   verdict on the structure. */
static kern_status kern_part_prove(kern_part *p, const kern_query *q,
                                   kern_status status)
{
    const int whole = kern_part_is_whole(p);
    int attempt;
    if (status < 0 || (status == KERN_STANDS && !whole))
        return status;

    /* Checks the motion y if the method found a fall. If the motion proves
       nothing, refines y, raises it by KERN_LIFT (kern_prices_mend()) and
       checks the motion again. */
    for (attempt = 0; status == KERN_FALLS && attempt < 2; attempt++)
        if ((!attempt || kern_prices_mend(&p->eq.simplex, p->y, KERN_LIFT))
            && kern_part_falls(p, q))
            return status;

    /* Checks the forces x, since they may hold the structure within the
       tolerance even if the simplex method found that no forces exist. */
    return whole && kern_part_stands(p, q) ? KERN_STANDS : KERN_UNDECIDED;
}

/* Checks that the sum of the forces x is at most KERN_BOUND weights. If the sum
   is larger, finds the forces with the least sum, by a program in which each
   force costs 1. Returns KERN_STANDS if the sum is small enough. Returns
   KERN_FALLS if even the least sum is too large: y is then a motion that proves
   the fall. Returns KERN_UNDECIDED or an error if the program has no
   optimum. */
static kern_status kern_part_norm(kern_part *p, kern_solver solver)
{
    kern_equations *const eq = &p->eq;
    kern_real *ones = kern_model_rays(p->m);
    kern_status status;
    int i;
    for (i = 0; i < eq->lp.cols; i++)
        ones[i] = 1;
    if (!(kern_dot(p->x, ones, eq->lp.cols) > KERN_BOUND))
        return KERN_STANDS;
    eq->lp.cost = ones;
    status = kern_program_solve(&eq->simplex, solver, p->x, p->y);
    eq->lp.cost = NULL;
    if (status != KERN_LP_OPTIMAL)
        return status < 0 ? status : KERN_UNDECIDED;
    return kern_dot(p->x, ones, eq->lp.cols) > KERN_BOUND ? KERN_FALLS
                                                          : KERN_STANDS;
}

/* Returns the largest t for which A x = rhs - t eq.rate has a solution x >= 0,
   or infinity if the program finds no optimum. */
static kern_real kern_part_follow(kern_part *p)
{
    kern_status status;
    KERN_ASSERT(kern_part_is_whole(p));
    p->eq.lp.follow = 1;
    status = kern_program_solve(&p->eq.simplex, KERN_SOLVER_BUILTIN, p->x,
                                p->y);
    p->eq.lp.follow = 0;
    return status == KERN_LP_OPTIMAL ? p->x[p->eq.lp.cols] : KERN_INFINITY;
}

/* Returns the result of the simplex method for a part. The result is not proven
   yet (kern_part_prove()). */
static kern_status kern_part_solve(kern_part *p, const kern_query *q,
                                   kern_solver solver)
{
    kern_status status;
    if (!kern_model_charge(p->m, 1))
        return KERN_LIMIT;
    kern_part_set(p, q);
    status = kern_program_solve(&p->eq.simplex, solver, p->x, p->y);
    if (status == KERN_LP_OPTIMAL)
        status = kern_part_norm(p, solver);
    else if (status == KERN_LP_INFEASIBLE)
        status = KERN_FALLS;
    return p->result = status;
}

/* Returns the verdict of the simplex method on a part, if it has a proof. If
   the first solve ends without a proof, solves the program again from a new
   basis and without the backend (KERN_USE_GLPK), since a long series of pivots
   may have lost digits. */
static kern_status kern_part_evaluate(kern_part *p, const kern_query *q)
{
    kern_status status = kern_part_prove(
        p, q, kern_part_solve(p, q, KERN_SOLVER_ANY));
    if (status < 0 && p->result != KERN_UNDECIDED) {
        kern_simplex_change(&p->eq.simplex, KERN_BASIS_NONE);
        status = kern_part_prove(p, q,
                                 kern_part_solve(p, q, KERN_SOLVER_BUILTIN));
    }
    return status;
}

/* Runs the top-down pass for a query whose loads and cones have been set.
   `share` limits the size of clusters (kern_pass_begin()). Returns KERN_STANDS
   if the forces of the pass prove that the structure stands. Returns KERN_FALLS
   if a part seems to fall, which is then open as *p. Otherwise returns
   KERN_UNDECIDED, or KERN_LIMIT if work is refused. */
static kern_status kern_model_pass(kern_model *m, kern_part *p,
                                   const kern_query *q, int share)
{
    kern_status found;
    for (;; m->answer.known = NULL) { /* round 2 has no known forces */
        if (!kern_model_charge(m, 1))
            return KERN_LIMIT;
        m->task->work->solves++;

        kern_pass_begin(m, share);
        found = kern_pass(m, p);
        if (found == KERN_FALLS
            || (found == KERN_STANDS && kern_answer_holds(m, q)))
            return found;

        /* Repeats the pass without known forces if every group is balanced but
           the forces prove nothing. The known forces of groups that were not
           balanced again may belong to other loads. */
        if (found != KERN_STANDS || !m->answer.known)
            return KERN_UNDECIDED;
        kern_model_unload(m);
    }
}

/* Opens one linear program of all groups, which overwrites the arrays of the
   pass. All later queries use this program, and each one begins with the last
   basis. Returns KERN_OK, or KERN_NO_SPACE if the work memory is too small. */
static kern_status kern_model_whole(kern_model *m, kern_part *p,
                                    const kern_query *q)
{
    int g, k;
    kern_model_weigh(m, q);
    kern_part_begin(p, m, m->graph.groups, &m->common);
    p->contacts = p->supports = m->s->contacts;
    p->ends = m->graph.ends;
    p->contact = kern_take_ints(&p->rest, p->contacts);
    if (!kern_take_fits(&p->rest))
        return KERN_NO_SPACE;

    /* Lists all groups and all contacts in their order. */
    for (g = 0; g < p->groups; g++)
        p->group[g] = g;
    for (k = 0; k < p->contacts; k++)
        p->contact[k] = k;
    m->whole = kern_part_lay(p);
    return m->whole ? KERN_OK : KERN_NO_SPACE;
}

/* Returns the verdict for a query if it has a proof, and otherwise
   KERN_UNDECIDED or an error. Tries the methods listed in >>method. After
   KERN_FALLS *p is the part that falls. */
static kern_status kern_model_evaluate(kern_model *m, kern_part *p,
                                       const kern_query *q)
{
    kern_status status;
    p->result = KERN_UNDECIDED;

    if (!m->whole) {
        kern_model_set(m, q);

        /* Tries the pass: if it balances every group, the structure stands. */
        status = kern_model_pass(m, p, q, KERN_CLUSTER);
        if (status == KERN_STANDS || status == KERN_LIMIT)
            return status;

        /* Solves the linear program of the part that seems to fall, which is
           small. If the program does not prove that the part falls, ignores the
           part. */
        if (status == KERN_FALLS && kern_part_lay(p)
            && kern_part_evaluate(p, q) == KERN_FALLS)
            return KERN_FALLS;

        /* Solves all groups at once. More than KERN_SMALL groups are solved by
           the interior-point method. Up to KERN_SMALL groups, or more if this
           method leaves them undecided, are solved by one linear program, which
           is kept for later queries. */
        status = m->graph.groups > KERN_SMALL ? kern_ipm_verdict(m, p, q)
                                              : KERN_UNDECIDED;
        if (status != KERN_UNDECIDED)
            return status;
        status = kern_model_whole(m, p, q);
        if (status != KERN_OK)
            return status;
    }
    status = kern_part_evaluate(p, q);

    /* Returns KERN_UNDECIDED instead of KERN_NO_SPACE if the work memory has
       its full size. The factors of a basis outgrow the full size only if
       digits were lost. */
    if (status == KERN_NO_SPACE && kern_model_has_room(m))
        status = p->result = KERN_UNDECIDED;

    /* Tries the interior-point method as a last resort: it rounds differently,
       and needs no memory for factors of a basis. In float the method is not
       tried, since its proofs are too coarse near the critical value. */
    if (KERN_PICK(1, 0) > 0 && status == KERN_UNDECIDED
        && m->graph.groups <= KERN_SMALL) {
        status = kern_ipm_verdict(m, p, q);

        /* Keeps kern_path_evaluate() from taking Newton's step with the y of
           the interior-point method. Newton's step starts better from the y of
           a basis. */
        p->result = KERN_UNDECIDED;
    }
    return status;
}

/* ==== Part V: What is measured =========================================== */

/* ---- The kern -------------------------------------------------- >>kern */
/* A path leads from a structure that stands to structures that fall: kerns
   shrink, a load grows or gravity turns. A place s on the path is a shrinkage,
   a load factor, or the tangent of a quarter of the angle of tilt. A mechanism
   y falls at s if the loads at s have a positive power in this motion:

       P(s) = -y.rhs(s) > 0,   whose derivative is   P' = -y.(rhs' - A' x).

   Here rhs' and A' are derivatives with respect to s, and x are the forces of
   the last basis. So the mechanism stops falling at about s - P / P' (Newton's
   method). The place at which a mechanism stops falling is the critical value
   of this mechanism. The steps of the method converge quadratically, from the
   side on which the structure falls. */

/* What changes along a path: kerns shrink, a load grows, or gravity turns. */
typedef enum kern_path_kind {
    KERN_PATH_SHRINK,
    KERN_PATH_LOAD,
    KERN_PATH_TILT
} kern_path_kind;

/* Structure that a search evaluates. KERN_SCOPE_WHOLE: the whole structure.
   KERN_SCOPE_PART: one part, with all other blocks held. KERN_SCOPE_PROGRAM:
   the whole structure, by its linear program. With this scope a search ends at
   the first place that the program cannot decide, so that the interior-point
   method can take over. */
typedef enum kern_scope {
    KERN_SCOPE_WHOLE,
    KERN_SCOPE_PART,
    KERN_SCOPE_PROGRAM
} kern_scope;

/* A range of places on a path. In kern_path.proven `low` is the farthest place
   at which the whole structure is proven to stand, or -1 without such a proof.
   There `high` is the nearest place at which the whole structure is proven to
   fall, or infinity. In kern_path_critical() a range has the first and the last
   undecided place of the bracket. */
typedef struct kern_range {
    kern_real low, high;
} kern_range;

typedef struct kern_path {
    kern_path_kind kind;
    kern_query q;            /* query at place 0, from which kern_path_at()
                                makes the query at a place s                  */
    kern_real unit;          /* unit of places: the mean block size, or 1     */
    kern_real start, end;    /* first and last place of the search            */
    kern_real holds, fails;  /* lower and upper end of the bracket (>>search) */
    kern_real critical;      /* critical value of the last mechanism; at most
                                `holds`: there is no such value               */
    kern_real predicted;     /* predicted critical value of the next
                                mechanism                                     */
    kern_range proven;       /* bracket with proofs for the whole structure   */
    int never_falls;         /* nonzero: the whole structure stands at all
                                places up to the end                          */
    kern_part *part;         /* the open part: the last one that fell         */
    const kern_known *known; /* results of a similar structure, or NULL       */
    kern_scope scope;        /* structure that the search evaluates           */
    struct kern_ipm *ipm;    /* interior-point method that evaluates the
                                whole structure, or NULL                      */
    const kern_proof *proof; /* the caller's arrays, which receive the last
                                proof of each verdict                         */
} kern_path;

/* Returns the width to which a search narrows its bracket. */
KERN_SHARED static kern_real kern_width(const kern_path *path)
{
    return KERN_WIDTH * path->unit;
}

/* Returns the distance from a critical value to the two places beside it, one
   on each side, at which a search looks for proofs. */
KERN_SHARED static kern_real kern_half_width(const kern_path *path)
{
    return kern_width(path) / 2;
}

/* Returns the largest distance between the two places beside a critical value,
   one on each side, at which a search looks for proofs. If the search finds no
   proofs within this distance, it cuts the bracket instead. */
KERN_SHARED static kern_real kern_widest(const kern_path *path)
{
    return kern_width(path) * KERN_WIDEST;
}

/* Returns the place that is `distance` below the critical value, but not below
   the start of the search. */
KERN_SHARED static kern_real kern_path_retreat(const kern_path *path,
                                               kern_real distance)
{
    KERN_ASSERT(distance >= 0);
    return kern_max(path->critical - distance, path->start);
}

/* Returns the query at place s of a path. On a path of tilt gravity turns by
   4 atan(s). So gravity turns through half a circle as s grows from 0 to 1, and
   no trigonometric functions are needed. */
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

/* Returns the tangent of half the angle whose tangent is t. */
static kern_real kern_half_tangent(kern_real t)
{
    return t / (1 + KERN_SQRT(1 + t * t));
}

/* ---- Searching a path ------------------------------------------ >>search */
/* The critical value of a path lies between a place at which the structure
   stands and a place at which it falls. The two places are the ends of a
   bracket, and each end has a proof:

       start         holds     critical     fails                    end
         |-------------[-----------*-----------]----------------------|
                    forces                  motion
                 prove that it          prove that it
                     stands                 falls

   Each verdict moves an end of the bracket. Each mechanism predicts the value
   at which it stops falling. The search tries the place just beyond that value,
   and if the structure falls there, the place just before the value. Four to
   eight verdicts suffice.

   The lower end may lack a proof. If kerns are nested, the search evaluates its
   start only if the critical value is close to it. A part, with all other
   blocks held, can prove that the whole structure falls, but not that it
   stands. So the lower end of the bracket of a part is discarded afterwards.

   A search tries the cheapest method first:

       known       the motion by which a similar structure fell
       bodies      the critical value of a block with all blocks that rest on
                   it alone
       parts       a pass just before that value: it may find a part that
                   falls there
       whole       if the pass finds no such part: one linear program of all
                   groups, or the interior-point method

   Each method gives an upper bound of the critical value, since fixing blocks
   never makes a structure fall. If kerns are not nested, the verdict may change
   many times along the path. A walk in even steps then finds the first place at
   which the structure falls. */

/* ---- the value of a mechanism ---- */

/* Returns the array for the change of the forces of a basis, from the place
   where the part fell to the critical value of its mechanism. The array uses
   the memory of answer.force, which is free after a fall: only the verdict
   KERN_STANDS writes forces there. */
static kern_real *kern_path_change(const kern_model *m)
{
    return (kern_real *)(void *)m->answer.force;
}

/* Adds to *power and *rate the effect of options.narrow at contact k, whose
   friction is smaller at the shrinkage `to` than at q. m->reduction must be
   that of q. x[0] and x[1] are the forces along the two edges of the friction
   cone. */
static void kern_shrink_narrow(const kern_part *p, const kern_query *q, int k,
                               kern_real to, const kern_real *x,
                               kern_real *power, kern_real *rate)
{
    const kern_model *m = p->m;
    const kern_contact *c = m->s->contact + p->contact[k];
    const kern_real mu = kern_model_mu(m, p->contact[k]);
    const kern_real reduction = kern_max(q->narrow * to, KERN_R(0));
    const kern_real mu_to = kern_friction(c, reduction);
    kern_real speed[2] = {0, 0};
    kern_row row[2];
    if (!(q->narrow > 0 && mu > 0))
        return;
    kern_model_rows(m, q, p->contact[k], row);
    kern_row_speed(row, p->y + 3 * p->ends[2 * k], speed);
    kern_row_speed(row + 1, p->y + 3 * p->ends[2 * k + 1], speed);
    speed[1] *= x[0] - x[1];
    *power += speed[1] * (mu - mu_to);
    if (mu_to > 0)
        *rate += speed[1] * q->narrow * (1 + mu_to * mu_to)
               / (1 + reduction * reduction);
}

/* Returns the change of y.rhs if kerns shrink from q to the shrinkage `to`,
   with the same motion y. The change is y.v with v = -(A(to) - A(q)) x, where x
   are the forces of the basis. The change is piecewise linear in `to`, with a
   kink where a kern closes. The term of a contact whose kern is closed at q
   gets the sign that makes y.rhs larger. Writes the slope at `to` to *rate, and
   v to p->eq.rate. The change and the slope, but not v, include the effect of
   options.narrow. */
static kern_real kern_shrink_power(const kern_part *p, const kern_query *q,
                                   kern_real to, const kern_real *x,
                                   kern_real *rate)
{
    const kern_model *m = p->m;
    kern_real sum = KERN_R(0), slope = sum, *v = p->eq.rate;
    int k;
    kern_zero(v, 3 * p->groups + 3);
    for (k = 0; k < p->contacts; k++, x += 2) {
        const kern_contact *c = m->s->contact + p->contact[k];
        const int *ends = m->graph.ends + 2 * p->contact[k];
        const int head = 3 * p->ends[2 * k], tail = 3 * p->ends[2 * k + 1];
        const kern_real travel = kern_travel(c, m->mean_size);
        /* Computes the relative spin of the two blocks. If the arm grows along
           t, the torque changes by t x (f n + r t) = -f per length. */
        const kern_real work = p->y[head + 2] * m->torque_scale[ends[0]]
                             - p->y[tail + 2] * m->torque_scale[ends[1]];
        kern_real n = x[0] + x[1], rate_q, rate_to, shift;
        if (!(n > 0 || n < 0))
            continue;

        /* Computes how far the contact point moves along t from its place at
           q. */
        shift = kern_shift(travel, to, q->relative, &rate_to)
              - kern_shift(travel, q->shrink, q->relative, &rate_q);
        if (!q->relative && q->shrink >= kern_abs(travel)
            && n * work * shift < 0)
            n = -n;

        slope += n * work * rate_to;
        n *= shift;
        v[head + 2] += n * m->torque_scale[ends[0]];
        v[tail + 2] -= n * m->torque_scale[ends[1]];
        sum += n * work;
        kern_shrink_narrow(p, q, k, to, x, &sum, &slope);
    }
    *rate = slope;
    return sum;
}

/* Returns the shrinkage at which the mechanism y, which falls at q, stops
   falling. The result is at least path->holds. `power` is y.rhs at q, which is
   negative. The power of y is piecewise linear in the shrinkage, with kinks
   where kerns close. Also predicts where the next mechanism stops falling, and
   writes that value to path->predicted (Halley's method). The prediction of
   Halley's method includes the change of the basic forces between q and that
   value. */
static kern_real kern_shrink_critical(kern_path *path, const kern_query *q,
                                      kern_real power)
{
    kern_part *p = path->part;
    const kern_real tolerance = KERN_VALUE_SAME * path->unit / 8;
    kern_real *change = kern_path_change(p->m);
    kern_real lo = path->holds, hi = q->shrink, shrink = hi, rate, step;
    int round;

    /* Finds the zero of the power by Newton's method, from kink to kink, within
       [lo, hi]. */
    for (round = 0;; round++) {
        const kern_real total = power
                              + kern_shrink_power(p, q, shrink, p->x, &rate);
        step = total / rate;
        if (kern_abs(step) <= tolerance || round == KERN_BENDS)
            break;
        *(total < 0 ? &hi : &lo) = shrink;
        shrink -= step;
        if (!(shrink > lo && shrink < hi))
            shrink = lo + (hi - lo) / 2;
    }
    shrink = round < KERN_BENDS ? shrink - step : path->holds;

    /* Lengthens the step by Halley's correction: the forces of the basis change
       along the path and lower y.rhs, so that the structure still falls where y
       alone no longer does. */
    path->predicted = shrink;
    if (p->eq.shrink <= q->shrink
        && kern_simplex_direction(&p->eq.simplex, p->eq.rate, change)) {
        const kern_real turned = kern_shrink_power(p, q, shrink, change, &rate);
        path->predicted = q->shrink
                        + (shrink - q->shrink)
                              / kern_max(1 - turned / power,
                                         1 / KERN_HALLEY_MOST);
    }
    return shrink;
}

/* Writes to to[0..3 groups) the rate at which rhs falls, three numbers per
   group. The rate is that per unit of the load factor, or per unit of the
   tangent of the angle by which gravity turns. */
static void kern_path_rate(const kern_part *p, const kern_query *q,
                           kern_real *to)
{
    const kern_model *m = p->m;
    kern_wrench w;
    int n;
    for (n = 0; n < p->groups; n++) {
        kern_pattern_wrench(m->s, q, m->graph.block[p->group[n]], &w);
        w.torque *= m->torque_scale[p->group[n]];
        kern_copy(to + 3 * n, &w, 3);
    }
    kern_scale(to, 3 * n, 1 / m->weight);
}

/* Returns the place beyond s at which a load has grown by t, or gravity has
   turned further by atan(t). */
static kern_real kern_path_pushed(const kern_path *path, kern_real s,
                                  kern_real t)
{
    if (path->kind == KERN_PATH_LOAD)
        return s + t;
    t = kern_half_tangent(kern_half_tangent(t));
    return (s + t) / (1 - s * t);
}

/* Returns the place at which the mechanism p->y, which falls at s, stops
   falling. On a path of shrinkage this is the place of kern_shrink_critical().
   On other paths one step of Newton's method finds the place exactly, unless
   blocks have loads that keep their direction while gravity turns. */
static kern_real kern_path_newton(kern_path *path, const kern_query *q,
                                  kern_real s)
{
    const kern_part *p = path->part;
    const int n = 3 * p->groups;
    const kern_real power = kern_dot(p->y, p->eq.rhs, n);
    kern_real *rate = p->m->answer.scratch;
    if (path->kind == KERN_PATH_SHRINK)
        return kern_shrink_critical(path, q, power);
    kern_path_rate(p, q, rate);
    return kern_path_pushed(path, s, power / kern_dot(p->y, rate, n));
}

/* ---- verdicts, which move the ends ---- */

/* Returns 1 if the motion in m->answer proves that the whole structure falls at
   s. The motion must have been proven on the contacts of the path. If the path
   leaves out the points that travel (KERN_CARRY_NESTED), checks the motion
   again with these points, since they may stop it. */
static int kern_path_falls_whole(const kern_model *m, const kern_path *path,
                                 kern_real s)
{
    kern_query q = kern_path_at(path, s);
    if (q.carry == KERN_CARRY_ALL)
        return 1;
    q.carry = KERN_CARRY_ALL;
    return kern_model_proven(m, kern_prove_motion(m->s, &q, m->answer.motion));
}

/* Records the verdict at s as an end of the bracket. Copies the proof to the
   caller if it is valid for the whole structure. The caller's motion is always
   that of the lowest place that is proven to fall. */
static void kern_path_record(const kern_model *m, kern_path *path,
                             kern_status status, kern_real s)
{
    if (status == KERN_STANDS) {
        path->holds = s;
        if (path->scope == KERN_SCOPE_PART)
            return;
        path->proven.low = kern_max(path->proven.low, s);
    } else if (status == KERN_FALLS) {
        path->fails = s;
        if (!(s <= path->proven.high) || !kern_path_falls_whole(m, path, s))
            return;
        path->proven.high = s;
    }
    kern_proof_write(m, path->proof, status);
}

/* Returns the verdict at place s, and records it if it has a proof. If the
   method found a mechanism, sets path->critical to the value at which the
   mechanism stops falling. Sets path->critical even if the mechanism is no
   proof, since near the critical value rounding spoils the proof before it
   spoils the value. */
static kern_status kern_path_evaluate(kern_model *m, kern_path *path,
                                      kern_real s)
{
    const kern_query q = kern_path_at(path, s);
    kern_part *p = path->part;
    const kern_status status = path->scope == KERN_SCOPE_PART
                                 ? kern_part_evaluate(p, &q)
                             : path->ipm ? kern_ipm_evaluate(path->ipm, &q)
                                         : kern_model_evaluate(m, p, &q);
    if (status != KERN_STANDS && p->result == KERN_FALLS)
        path->critical = kern_path_newton(path, &q, s);
    kern_path_record(m, path, status, s);
    return status;
}

/* Tries to prove that the structure stands at s, just before the critical
   value, from the last basis, which belongs to a fall just beyond that value.
   Adds to the basic forces the change that kern_shrink_critical() wrote, and
   moves the forces to the ends of the larger kerns at s. Returns 1 if these
   forces are a proof. */
static int kern_path_forces(kern_model *m, kern_path *path, kern_real s)
{
    kern_part *p = path->part;
    const kern_query q = kern_path_at(path, s);
    int i;
    if (!m->whole || path->kind != KERN_PATH_SHRINK || p->result != KERN_FALLS)
        return 0;
    kern_add(p->x, KERN_R(1), kern_path_change(m), 2 * p->contacts);
    for (i = 0; i < 2 * p->contacts; i++)
        if (p->x[i] < -KERN_BASIS_NOISE)
            return 0;
    kern_part_forces(p);
    kern_force_transfer(m, path->critical, s);
    if (!kern_answer_holds(m, &q))
        return 0;
    kern_path_record(m, path, KERN_STANDS, s);
    return 1;
}

/* ---- the bracket ---- */

/* Returns the place at which the bracket is cut. `dark` has the first and the
   last undecided place in the bracket. If there is no undecided place, the cut
   is close to the lower end, where forces are small. If there are undecided
   places, the cut halves the wider of the two ranges below and above them.
   Returns infinity if both ranges are narrow. */
static kern_real kern_path_cut(const kern_path *path, const kern_range *dark)
{
    const kern_real lo = path->holds, hi = path->fails;
    const kern_real width_low = dark->low - lo, width_high = hi - dark->high;
    const kern_real width_min = kern_max((dark->high - dark->low) / KERN_CUT,
                                         kern_half_width(path) / 8);
    if (!(dark->low <= dark->high))
        return lo + (hi - lo) / KERN_CUT;
    if (kern_max(width_low, width_high) <= width_min)
        return KERN_INFINITY;
    return width_low > width_high ? lo + width_low / 2 : hi - width_high / 2;
}

/* Returns the place of the next verdict, or infinity if the bracket needs no
   further verdict. `offset` is the distance from the critical value to the
   places that are tried on its two sides. `dark` has the first and the last
   undecided place in the bracket. */
KERN_SHARED static kern_real kern_path_next(const kern_path *path,
                                            kern_real offset,
                                            const kern_range *dark)
{
    const kern_real lo = path->holds, hi = path->fails;
    const kern_real critical = path->critical, predicted = path->predicted;
    kern_real aim;

    /* 1. The start has no proof yet, and the critical value is close to the
       start: prove the start. */
    if (path->scope != KERN_SCOPE_PART && path->proven.low < lo
        && kern_min(critical, hi) < lo + 2 * offset)
        return lo;

    /* 2. The bracket is narrow enough: no further verdict is needed. */
    if (hi - lo <= offset / 8)
        return KERN_INFINITY;

    /* 3. The bracket contains no critical value of a mechanism, or the places
       beside this value are undecided even at the largest distance: cut the
       bracket. */
    if (!(critical > lo && critical <= hi) || 2 * offset > kern_widest(path))
        return kern_path_cut(path, dark);

    /* 4. The upper end is far above the predicted or the critical value: go
       just beyond that value. */
    aim = predicted > lo && hi - predicted > 2 * offset ? predicted : critical;
    if (hi - aim > 2 * offset)
        return aim + offset;

    /* 5. The upper end is close to the critical value: prove that the whole
       structure stands just before this value. */
    if (path->scope != KERN_SCOPE_PART && critical - lo > KERN_R(1.05) * offset)
        return kern_path_retreat(path, offset);
    return KERN_INFINITY;
}

/* Narrows the bracket [holds, fails] around path->critical. Returns KERN_STANDS
   if the bracket has become narrow. Returns KERN_FALLS if the structure falls
   at the start of the search, which may not have been evaluated before. In a
   jam no place close to the critical value has a proof. So each undecided place
   doubles the distance from the critical value at which the next places are
   tried. After the first undecided place the search keeps the least critical
   value that it finds, since mechanisms at more distant places predict the
   value less well. */
static kern_status kern_path_critical(kern_model *m, kern_path *path)
{
    kern_real offset = kern_half_width(path);
    kern_range dark = {KERN_INFINITY, -KERN_INFINITY};
    int round;
    for (round = 0; round < KERN_BRACKET_ROUNDS; round++) {
        const kern_real lo = path->holds, value = path->critical;
        const kern_real place = kern_path_next(path, offset, &dark);
        kern_status status = KERN_STANDS;
        if (!(place < KERN_INFINITY))
            break;

        /* Tries the forces of the last basis if the place is just before the
           critical value. If these forces are no proof, evaluates a verdict. */
        if (!(place < value && kern_path_forces(m, path, place)))
            status = kern_path_evaluate(m, path, place);
        if (status < KERN_UNDECIDED || (place <= lo && status != KERN_STANDS))
            return status;

        /* Keeps the least critical value so far, once a place has been
           undecided. */
        if (offset > kern_half_width(path) && value > path->holds)
            path->critical = kern_min(path->critical, value);
        if (path->scope == KERN_SCOPE_PROGRAM && !m->whole)
            return KERN_UNDECIDED;

        /* If the place is undecided, doubles the distance and records the
           place. */
        if (status == KERN_UNDECIDED) {
            offset *= 2;
            dark.low = kern_min(dark.low, place);
            dark.high = kern_max(dark.high, place);
        }
    }

    /* Returns KERN_UNDECIDED if the bracket is still too wide for an answer,
       except for a part. Moves the critical value into the bracket if it lies
       outside. */
    if (path->fails - path->holds > KERN_ANSWER * kern_width(path)
        && path->scope != KERN_SCOPE_PART)
        return KERN_UNDECIDED;
    path->critical = kern_max(path->critical, path->holds);
    path->critical = kern_min(path->critical, path->fails);
    return KERN_STANDS;
}

/* ---- walks ---- */

/* Records that the structure stands at all places up to the end of the path. */
static kern_status kern_path_saturate(kern_path *path)
{
    path->never_falls = 1;
    path->critical = path->fails = path->end;
    return KERN_STANDS;
}

/* Returns 1 if the structure stands at every place from `place` to path->holds
   while gravity turns under fixed loads. The structure must stand at both of
   these places. Between the two places the vector of gravity describes an arc.
   Evaluates one more gravity vector, the point where the tangents at the two
   ends of this arc intersect. The arc lies in the triangle of its two ends and
   this point. The gravity vectors under which the structure stands form a
   convex set, so if it stands at all three points, it stands on the whole
   arc. */
static int kern_turn_holds(kern_model *m, const kern_path *path,
                           kern_real place)
{
    kern_query q = kern_path_at(path, path->holds);
    const kern_vec from = kern_path_at(path, place).gravity, to = q.gravity;
    const kern_real square = kern_vec_dot(to, to);
    q.gravity = kern_vec_scale(kern_vec_add(from, to),
                               square / (square + kern_vec_dot(from, to)));
    return kern_model_evaluate(m, path->part, &q) == KERN_STANDS;
}

/* Takes steps along the path from path->holds, where the whole structure
   stands, until it falls. Then finds the critical value between the last two
   places. The length of the first step is `first`. Later steps begin with the
   length `step` and grow. If the verdicts along a step remain unknown, the
   step is halved. `stride` is the least length of a step, or 0 if the verdict
   changes only once along the path. */
static kern_status kern_path_climb(kern_model *m, kern_path *path,
                                   kern_real first, kern_real step,
                                   kern_real stride)
{
    const kern_real step_min = KERN_R(1.5)
                             * (stride > 0 ? stride : kern_width(path));
    int round;
    for (round = 0; round < 5 * KERN_SCAN; round++) {
        const kern_real place = path->holds;
        const kern_real next = kern_min(path->end,
                                        place + kern_max(first, stride));
        const int small = next - place <= step_min,
                  sure = small || !(stride > 0);
        const kern_status status = kern_path_evaluate(m, path, next);
        if (path->scope == KERN_SCOPE_PROGRAM && !m->whole)
            return KERN_UNDECIDED;

        /* If the structure stands at all places between `place` and `next`,
           continues with a new step from `next`. */
        if (status == KERN_STANDS
            && (sure || kern_turn_holds(m, path, place))) {
            if (next >= path->end)
                return kern_path_saturate(path);
            first = kern_min(step, (path->fails - next) / 2);
            step *= KERN_CLIMB_GROWS;
            continue;
        }

        /* If the verdict changes only once between `place` and `next`, finds
           the critical value there. */
        if (status == KERN_FALLS && sure)
            return kern_path_critical(m, path);
        if (status < KERN_UNDECIDED || small)
            return status;

        /* Otherwise the verdicts between `place` and `next` are unknown. Tries
           a shorter step from `place`. If the proof of `next` has overwritten
           that of `place`, writes the latter again. */
        step = first /= 2;
        path->holds = place;
        if (status == KERN_STANDS)
            kern_path_evaluate(m, path, place);
    }
    return KERN_UNDECIDED;
}

/* ---- bodies ---- */
/* A body is a block with all blocks that rest on it alone, directly or through
   others. The blocks of a body move as one rigid body. If a single line carries
   a body, the body tips at the shrinkage at which its load leaves the kern of
   this line. Since all other blocks are held, the whole structure falls at that
   shrinkage. The critical value of most structures is that of a body. */

/* Finds the line that carries body g. Returns the end, at body g, of the first
   point of this line (an index of graph.ends). Returns KERN_OUT if the body is
   not carried by a single line. Sets graph.carrier of g to the only group that
   carries the body, or to KERN_OUT if the body has another carrier. */
KERN_SHARED static int kern_body_line(kern_model *m, int g)
{
    int e, n = 0, first = KERN_OUT, carrier = KERN_OUT;
    for (e = m->graph.first_end[g]; e >= 0; e = m->graph.next_end[e]) {
        const int other_group = m->graph.ends[e ^ 1];
        if (other_group < g && m->graph.carrier[other_group] == g)
            continue;
        carrier = carrier == KERN_OUT || carrier == other_group
                    ? other_group
                    : m->graph.groups;
        if (n++ == 0)
            first = e;
    }
    m->graph.carrier[g] = carrier > g && carrier < m->graph.groups ? carrier
                                                                   : KERN_OUT;
    return n == 2 && kern_line_begins(m->s->contact, m->s->contacts, first >> 1)
             ? first
             : KERN_OUT;
}

/* Returns the shrinkage at which body g tips under its load b on the line whose
   first point has the contact end *e. Sets *e to the end of the line about
   which the body tips. Returns infinity if the load does not press the body
   onto the line. Also returns infinity if the body does not tip at least
   `offset` before its kern is closed. */
static kern_real kern_body_critical(const kern_model *m, int g, int *e,
                                    const kern_real *b, kern_real offset)
{
    const kern_contact *c = m->s->contact + (*e >> 1);
    const kern_vec centre = m->s->block[m->graph.block[g]].centre;
    const kern_real side = KERN_R(*e & 1 ? -1 : 1);
    const kern_vec n = kern_vec_scale(c->n, side);
    const kern_row row = kern_row_of(n, kern_vec_sub(c->p, centre),
                                     m->torque_scale[g]);
    const kern_row last = kern_row_of(n, kern_vec_sub(c[1].p, centre),
                                      m->torque_scale[g]);
    const kern_real normal = row.n[0] * b[0] + row.n[1] * b[1];
    const kern_real tangential = row.n[0] * b[1] - row.n[1] * b[0];
    const kern_real travel = kern_travel(c, m->mean_size);
    const kern_real limit = m->relative ? KERN_R(1) : kern_abs(travel);
    const kern_real rate = travel / limit * -side * m->torque_scale[g];
    kern_real place, crit, second;
    if (!(normal > 0))
        return KERN_INFINITY;

    /* Finds the hinge. As the kern shrinks, its two ends move toward the place
       where the load acts. The end that reaches this place first is the hinge.
       Places on the line are measured by the torque that a unit force along n
       has there. */
    place = (b[2] - tangential * row.torque)
          / normal; /* where the load meets the line */
    crit = (place - row.n[2]) / rate;
    second = (last.n[2] - place) / rate;
    if (second < crit) {
        crit = second;
        *e += 2;
    }

    /* At the shrinkage `limit` the kern is closed. An end that has not reached
       the load before never does. */
    return crit + offset <= limit ? crit : KERN_INFINITY;
}

/* Writes to m->answer the motion of a body that tips about end e of its line at
   shrinkage s. Scales the motion so that its largest speed is 1. */
static void kern_body_moves(kern_model *m, int body, int e, kern_real s)
{
    const kern_contact *c = m->s->contact + (e >> 1);
    const kern_real spin = KERN_R((c->travel > 0) == (e & 1) ? 1 : -1);
    const kern_real limit = m->relative ? KERN_R(1) : kern_abs(c->travel);
    const kern_vec t = kern_vec_scale(kern_vec_turn(c->n), c->travel / limit);
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

/* Adds the load of group g to the load of the group `carrier`, which carries g.
   The torque of each load is in the unit of its own group. */
static void kern_body_load(const kern_model *m, int g, int carrier,
                           kern_real *load)
{
    const kern_real *from = load + 3 * g;
    kern_real *to = load + 3 * carrier;
    const kern_vec arm = kern_vec_sub(
        m->s->block[m->graph.block[g]].centre,
        m->s->block[m->graph.block[carrier]].centre);
    to[0] += from[0];
    to[1] += from[1];
    to[2] += (from[2] / m->torque_scale[g] + arm.x * from[1] - arm.y * from[0])
           * m->torque_scale[carrier];
}

/* Finds the body with the least critical value. Writes this value to
   out->margin, or infinity if no body tips. Writes the places just below and
   above the value to out->holds and out->fails. Writes the motion of the body
   to the array in m->answer, to which out->motion points. */
static void kern_body_first(kern_model *m, const kern_path *path,
                            kern_known *out)
{
    const kern_real offset = kern_half_width(path);
    kern_real *load = m->answer.scratch; /* three numbers per body     */
    int g, first = KERN_OUT, pivot = 0;
    out->margin = KERN_INFINITY;
    out->motion = m->answer.motion;
    if (!kern_model_charge(m, 1))
        return;

    /* Visits the bodies from top to bottom, so that the load of a body is
       complete before it is added to the body that carries it. */
    kern_copy(load, m->load, 3 * m->graph.groups);
    for (g = 0; g < m->graph.groups; g++) {
        int end = kern_body_line(m, g);
        const int carrier = m->graph.carrier[g];
        const kern_real value = end == KERN_OUT
                                  ? KERN_INFINITY
                                  : kern_body_critical(m, g, &end, load + 3 * g,
                                                       offset);
        if (value < out->margin) {
            out->margin = value;
            first = g;
            pivot = end;
        }
        if (carrier != KERN_OUT)
            kern_body_load(m, g, carrier, load);
    }

    /* Writes the places just below and above the least value, and the motion of
       the body at the upper place. */
    out->holds = out->margin - offset;
    out->fails = out->margin + offset;
    if (first != KERN_OUT)
        kern_body_moves(m, first, pivot, out->fails);
}

/* ---- parts, and where a search begins ---- */

/* Returns 1 if known->motion proves that the structure falls, and copies this
   motion to m->answer. */
static int kern_known_falls(kern_model *m, const kern_query *q,
                            const kern_known *known)
{
    if (!kern_model_proven(m, kern_prove_motion(m->s, q, known->motion)))
        return 0;
    kern_copy(m->answer.motion, known->motion, 3 * m->s->blocks);
    return 1;
}

/* Returns 1 if value->motion proves that the structure falls at value->fails.
   If so, value->fails becomes the upper end of the bracket, and value->margin
   the critical value. */
static int kern_start_falls(kern_model *m, kern_path *path,
                            const kern_known *value)
{
    const kern_query q = kern_path_at(path, value->fails);
    if (!kern_known_falls(m, &q, value))
        return 0;
    kern_path_record(m, path, KERN_FALLS, value->fails);
    path->critical = value->margin;
    return 1;
}

/* Returns the verdict on the open part at s, with all other blocks held. After
   KERN_FALLS path->critical is the critical value of the part. If the part
   stands, which proves nothing about the whole structure, returns
   KERN_UNDECIDED. Does not change path->holds. */
static kern_status kern_path_part(kern_model *m, kern_path *path, kern_real s)
{
    const kern_real holds = path->holds;
    kern_status status;
    if (!kern_part_lay(path->part))
        return KERN_UNDECIDED;
    path->scope = KERN_SCOPE_PART;
    path->predicted = path->holds;
    status = kern_path_evaluate(m, path, s);
    if (status == KERN_FALLS && path->critical <= path->start)
        status = kern_path_evaluate(m, path, s = path->start);
    if (status == KERN_FALLS && s > path->start)
        status = kern_path_critical(m, path) == KERN_STANDS ? KERN_FALLS
                                                            : KERN_UNDECIDED;
    path->scope = KERN_SCOPE_WHOLE;
    path->predicted = path->holds = holds; /* there is no prediction */
    return status == KERN_STANDS ? KERN_UNDECIDED : status;
}

/* Returns 1 if a small part falls at s: the last block together with the blocks
   that moved in the known structure. Small means at most half of the groups.
   path->critical is then the critical value of this part. */
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

/* Returns 1 if the bracket in path->known can be used: its upper end lies on
   this path, it is narrow, and its three values are in order. */
static int kern_known_fits(const kern_path *path)
{
    const kern_known *known = path->known;
    return known && known->fails > path->start && known->fails <= path->end
        && known->fails - known->holds <= kern_widest(path)
        && known->holds <= known->margin && known->margin <= known->fails;
}

/* Returns the place where the search begins. `first` is the length of the first
   step of the search. Sets the upper end of the bracket to a place that is
   proven to fall, if one is found here, and otherwise to infinity. */
static kern_real kern_path_first(kern_model *m, kern_path *path,
                                 kern_real first)
{
    const kern_known *known = kern_known_fits(path) ? path->known : NULL;
    const kern_real place = known ? kern_max(path->start, known->holds)
                                  : kern_min(path->start + first, path->end);
    const kern_real limit = known ? kern_min(place + first, path->end)
                                  : path->end;
    kern_known body;
    kern_model_weigh(m, &path->q); /* all places have the same loads */
    m->reduction = kern_reduction(&path->q);

    /* 1. The known motion still proves a fall: begin just before its critical
       value. */
    if (known && kern_start_falls(m, path, known))
        return place;

    /* 2. A body tips: begin just before its critical value, but not before the
       start. */
    kern_body_first(m, path, &body);
    if (body.margin < limit) {
        if (body.holds > path->start)
            kern_start_falls(m, path, &body);
        return kern_max(path->start, body.holds);
    }

    /* 3. The blocks that moved in the known structure fall together with the
       last block: begin just before the critical value of this part. */
    if (m->answer.known && kern_known_part(m, path, limit))
        return kern_path_retreat(path, kern_half_width(path));

    /* 4. No fall is known: begin where the known structure stood, or without
       known results one step from the start. */
    path->fails = KERN_INFINITY;
    return place;
}

/* ---- the search: which method is asked when ---- */

/* Finds the critical value of the whole structure under a growing load or a
   tilt, by one linear program. The optimum of the program is the largest load
   factor, or tangent of the angle of tilt, for which forces exist. The prices
   of the program are the mechanism. Returns KERN_UNDECIDED if the path ends
   before that value. */
static kern_status kern_path_follow(kern_model *m, kern_path *path)
{
    kern_part *p = path->part;
    const kern_real s = path->holds;
    kern_query q = kern_path_at(path, s);
    kern_real largest, place;
    kern_part_set(p, &q);
    kern_path_rate(p, &q, p->eq.rate);
    largest = kern_part_follow(p);
    path->critical = kern_path_pushed(path, s, largest);
    if (!(largest < KERN_INFINITY && path->critical < path->end))
        return KERN_UNDECIDED;
    place = path->critical + kern_half_width(path);
    q = kern_path_at(path, place);
    if (!kern_model_charge(m, 1))
        return KERN_LIMIT;
    if (kern_part_falls(p, &q))
        kern_path_record(m, path, KERN_FALLS, place);
    return kern_path_critical(m, path);
}

/* Finds the critical value in the bracket. If there is no bracket, or the
   search in it is undecided, searches by kern_path_climb() instead. The climb
   starts at the last place where the whole structure is proven to stand, and
   takes steps that begin with the lengths `first` and `step`. */
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

/* Makes the first basis of the program of all groups from the known forces. */
static void kern_known_start(kern_model *m, kern_part *p)
{
    int k;
    kern_copy(m->answer.force, m->answer.known->force, 2 * p->contacts);
    for (k = p->contacts - 1; k >= 0; k--) {
        kern_real *x = p->x + 2 * k, way[2];
        const kern_real tangential = kern_model_prior(m, k, way) * way[1];
        x[0] = way[0] + tangential;
        x[1] = way[0] - tangential;
    }
    kern_simplex_start(&p->eq.simplex, p->x, KERN_BASIS_NOISE * m->weight);
}

/* Finds the critical value of the whole structure beyond path->holds by the
   interior-point method. q is the query at path->holds. `first` and `step` are
   the lengths of the first steps (kern_path_climb()). Returns KERN_UNDECIDED if
   the method cannot be opened. */
static kern_status kern_path_interior(kern_model *m, kern_path *path,
                                      const kern_query *q, kern_real first,
                                      kern_real step)
{
    kern_ipm ipm;
    kern_status status;
    if (!kern_ipm_open(&ipm, m, path->part, q))
        return KERN_UNDECIDED;
    path->ipm = &ipm;
    status = kern_path_narrow(m, path, first, step);
    path->ipm = NULL;
    return status;
}

/* Finds the critical value of the whole structure beyond path->holds by the
   linear program of all groups. q is the query at path->holds. `first` and
   `step` are the lengths of the first steps (kern_path_climb()). If the
   interior-point method can take over, returns KERN_UNDECIDED at the first
   place that the program cannot decide. */
static kern_status kern_path_program(kern_model *m, kern_path *path,
                                     const kern_query *q, kern_real first,
                                     kern_real step)
{
    kern_status status = m->whole ? KERN_OK
                                  : kern_model_whole(m, path->part, q);
    if (status != KERN_OK)
        return status;
    /* Uses the known forces only if no points are left out: otherwise the basis
       could lack columns. */
    if (m->answer.known && path->q.carry == KERN_CARRY_ALL)
        kern_known_start(m, path->part);
    if (path->kind != KERN_PATH_SHRINK)
        status = kern_path_follow(m, path);
    if (status == KERN_OK || (status == KERN_UNDECIDED && m->whole))
        status = kern_path_narrow(m, path, first, step);
    return status;
}

/* Finds the critical value of the whole structure beyond path->holds. `first`
   and `step` are the lengths of the first steps (kern_path_climb()). More than
   KERN_SMALL groups are solved by the interior-point method, and by the linear
   program if that method is undecided. When kerns shrink, the first step of the
   interior-point method has half the length, since fewer mechanisms fall at a
   smaller shrinkage. Up to KERN_SMALL groups are solved by the linear program.
   If the program cannot decide a place, as in a jam, the interior-point method
   narrows the remaining bracket (only in double). */
static kern_status kern_path_whole(kern_model *m, kern_path *path,
                                   kern_real first, kern_real step)
{
    const kern_query q = kern_path_at(path, path->holds);
    const int large = m->graph.groups > KERN_SMALL;
    kern_status status = KERN_UNDECIDED;

    /* Solves more than KERN_SMALL groups by the interior-point method. */
    if (large && !m->whole)
        status = kern_path_interior(
            m, path, &q, path->kind == KERN_PATH_SHRINK ? first / 2 : first,
            step);
    if (status != KERN_UNDECIDED)
        return status;

    /* Tries the linear program of all groups. For few groups, in double, the
       interior-point method takes over at the first place that the program
       cannot decide. */
    if (!large && KERN_PICK(1, 0) > 0)
        path->scope = KERN_SCOPE_PROGRAM;
    status = kern_path_program(m, path, &q, first, step);
    path->scope = KERN_SCOPE_WHOLE;
    return status == KERN_UNDECIDED && !large && !m->whole
             ? kern_path_interior(m, path, &q, first, step)
             : status;
}

/* Finds the critical value by passes. If a pass finds a part that falls, the
   next pass is just before the critical value of this part. The search ends
   when the whole structure stands just before the last of these values. If a
   pass cannot decide, or after KERN_PARTS parts, kern_path_whole() continues.
   `step` is the length of the first step. */
static kern_status kern_path_parts(kern_model *m, kern_path *path,
                                   kern_real step)
{
    kern_status status = KERN_UNDECIDED;
    kern_real place = kern_path_first(m, path, step);
    int round;
    for (round = 0; round < KERN_PARTS;) {
        const kern_query q = kern_path_at(path, place);
        kern_model_arms(m, &q);
        kern_known_begin(m, place);
        status = kern_model_pass(m, path->part, &q,
                                 KERN_CLUSTER + 1
                                     + 2 * (m->answer.known != NULL));
        if (status == KERN_STANDS)
            kern_path_record(m, path, status, place);
        else if (status == KERN_FALLS)
            status = kern_path_part(m, path, place);

        /* If a part falls, makes the next pass just before the critical value
           of this part. */
        if (status == KERN_FALLS && path->fails > path->start) {
            place = kern_path_retreat(path, kern_half_width(path));
            kern_model_unload(m);
            status = KERN_UNDECIDED;
            round++;
            continue;
        }

        /* Ends if the whole structure stands just before the critical value, if
           the pass cannot decide, or if a part falls at the start. */
        if (status != KERN_STANDS || path->fails < KERN_INFINITY)
            break;

        /* Takes one more step if the whole structure stands and no fall is
           known. */
        if (place >= path->end)
            return kern_path_saturate(path);
        place = kern_min(place + step, path->end);
        step *= KERN_CLIMB_GROWS;
    }
    return status != KERN_UNDECIDED
             ? status
             : kern_path_whole(m, path, place - path->holds, step);
}

/* Finds the critical value of a path beyond path->holds. Unless kerns are
   nested, the structure must be known to stand at path->holds. If kerns are
   nested, the search evaluates path->holds itself where it needs to. `stride`
   is the step of a walk, or 0 if the verdict changes only once along the
   path. */
static kern_status kern_path_search(kern_model *m, kern_path *path,
                                    kern_real stride)
{
    const int shrinks = path->kind == KERN_PATH_SHRINK;
    const kern_real step = path->unit
                         * (shrinks || stride > 0 ? KERN_CLIMB
                                                  : KERN_CLIMB_PUSH);
    kern_status status;
    path->start = path->critical = path->predicted = path->holds;
    path->fails = path->proven.high = KERN_INFINITY;
    if (stride > 0) {
        /* A walk takes steps of `stride`. If gravity turns, the walk takes
           longer steps, after which kern_turn_holds() proves the arc. */
        const kern_real turn = step * KERN_R(path->kind == KERN_PATH_TILT);
        status = kern_path_climb(m, path, turn, turn, stride);
    } else if (m->whole || !shrinks)
        status = kern_path_whole(m, path, step, step);
    else
        /* Makes the first step of few groups longer. If the step is too long, a
           part falls there, and the next pass is just before the critical value
           of this part. */
        status = kern_path_parts(
            m, path,
            m->graph.groups <= KERN_SMALL ? step * KERN_CLIMB_GROWS : step);

    /* Checks the invariant: the critical value lies between the two ends of the
       bracket, and each end has a proof. */
    KERN_ASSERT(status != KERN_STANDS || path->proven.low >= path->holds);
    KERN_ASSERT(status != KERN_STANDS || path->never_falls
                || path->q.carry == KERN_CARRY_NESTED
                || path->proven.high <= path->fails);
    KERN_ASSERT(
        status != KERN_STANDS
        || (path->holds <= path->critical && path->critical <= path->fails));
    return status;
}

/* ---- nested first ---- */
/* Kerns are not nested if single contact points, which are not the ends of a
   line, travel as kerns shrink. Few structures need such points to stand.
   Without these points kerns are nested, and a search replaces the walk. For
   the structure with all points the proofs at the ends of the bracket mean:

       forces without the points    also hold the structure, here and at every
                                    smaller place: it stands up to here
       a motion without the points  may close one of the points. If it is also
                                    a proof with all points, the structure
                                    falls here

   If the motion is no proof with all points, a walk continues from the last
   place that is proven to stand. */

/* Leaves points that travel out of the queries of the path, or includes them
   again. Discards the known forces if they load a point that is left out. */
static void kern_path_carry(kern_model *m, kern_path *path, kern_carry carry)
{
    int i;
    path->q.carry = carry;
    kern_model_group(m, &path->q);
    for (i = 0; m->answer.known && i < m->s->contacts; i++)
        if (kern_is_idle(&path->q, m->s->contact + i)
            && m->answer.known->force[i].normal > 0)
            m->answer.known = NULL;
}

/* Finds the critical value if kerns are not nested. First searches without the
   points that travel. If the result is not proven for the whole structure,
   walks through the multiples of `stride`. */
static kern_status kern_path_scan(kern_model *m, kern_path *path,
                                  kern_real stride)
{
    kern_status status;
    kern_path_carry(m, path, KERN_CARRY_NESTED);
    status = kern_path_search(m, path, KERN_R(0));
    if (status < 0)
        return status;
    kern_path_carry(m, path, KERN_CARRY_ALL);

    /* Ends if both ends of the bracket are proven for the whole structure, or
       if it falls at 0. */
    if ((status == KERN_STANDS
         && (path->never_falls || path->proven.high <= path->fails))
        || (status == KERN_FALLS && path->proven.high <= 0))
        return status;

    /* Begins the walk at 0, or at the last multiple of `stride` at which the
       whole structure is proven to stand. */
    path->never_falls = 0;
    path->holds = KERN_R(0);
    if (path->proven.low < 0)
        status = kern_path_evaluate(m, path, path->holds);
    else {
        path->holds = stride * KERN_R((int)(path->proven.low / stride));
        status = KERN_STANDS;
    }
    return status == KERN_STANDS ? kern_path_search(m, path, stride) : status;
}

/* ---- The measures --------------------------------------------- >>measure */

/* Turns a path on which kerns shrink into one along which a load grows or
   gravity turns. */
KERN_SHARED static void kern_path_push(kern_path *path, kern_path_kind kind,
                                       const kern_wrench *pattern,
                                       kern_side side)
{
    path->kind = kind;
    path->q.pattern = pattern;
    path->q.side = side;
    path->unit = 1;
}

/* Data of one call to a measure. */
typedef struct kern_call {
    kern_model m;
    kern_part part;
    kern_path path;
} kern_call;

/* Checks the task, charges the work of the check, and opens a path on which
   kerns shrink. `out` is the address of the caller's result, which is checked
   too. */
static kern_status kern_call_open(kern_call *c, const kern_task *task,
                                  kern_real shrink, const void *out)
{
    kern_path *const path = &c->path;
    kern_status status = kern_task_check(task, shrink, out);
    if (status != KERN_OK)
        return status;

    /* Charges the reading and checking of the arrays. */
    if (!kern_spend(task->work, task->options.limit,
                    1 + (task->s.blocks + task->s.contacts) / KERN_CALL_UNIT))
        return KERN_LIMIT;
    status = kern_query_read(task, shrink, &path->q);
    if (status != KERN_OK)
        return status;

    /* Sets up a path that has no bracket, no proof and no known forces yet. */
    path->kind = KERN_PATH_SHRINK;
    path->part = &c->part;
    path->proof = NULL;
    path->scope = KERN_SCOPE_WHOLE;
    path->never_falls = 0;
    path->ipm = NULL;
    path->unit = task->options.relative ? 1 : path->q.mean_size;
    path->start = path->holds = path->critical = path->predicted = 0;
    path->known = NULL;
    path->proven.low = -1;
    path->proven.high = path->fails = KERN_INFINITY;

    return kern_model_open(&c->m, task, &path->q);
}

/* Opens a call whose result is one number. Sets *number to -1 if the limit ends
   the call before it has read the task. */
KERN_SHARED static kern_status kern_number_open(kern_call *c,
                                                const kern_task *task,
                                                kern_real shrink,
                                                kern_real *number)
{
    const kern_status status = kern_call_open(c, task, shrink, number);
    if (status == KERN_LIMIT)
        *number = -1;
    return status;
}

KERN_API kern_status kern_verdict(const kern_task *task, kern_real shrink,
                                  const kern_proof *proof)
{
    kern_call c;
    kern_status status = kern_call_open(&c, task, shrink, task);
    if (status != KERN_OK)
        return status;

    /* Evaluates the path's first query, which is the task at `shrink`. */
    status = kern_model_evaluate(&c.m, &c.part, &c.path.q);
    kern_proof_write(&c.m, proof, status);
    return kern_call_status(task, status);
}

/* Finds the level by Algorithm 1 of the paper: the first k at which the
   structure falls when kerns shrink by k steps of length out->epsilon. The
   level is last + 1 if there is no such k, and -1 if a verdict is undecided.
   The structure stands at all steps up to path->holds. If kerns are nested, the
   structure falls at all steps from path->fails on. */
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

/* Computes the margin and the level of an open task, starting from the known
   results of a similar structure. If kerns are not nested, the search walks in
   even steps, and every level is at one of these steps. */
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
    path->known = known;
    kern_model_know(&c->m, known);
    path->end = r.most;

    /* Computes the number of steps of Algorithm 1. At the last step every kern
       is closed. */
    if (!(r.epsilon > 0))
        r.epsilon = path->q.relative ? KERN_LEVEL_SHARE
                                     : KERN_LEVEL_STEP * c->m.mean_size;
    steps = r.most / r.epsilon;
    if (!(steps <= KERN_POINTS_MOST))
        return KERN_BAD_STEP;
    last = (int)steps;
    last += KERN_R(last) < steps; /* rounded up */
    first = kern_min(r.epsilon, r.most);

    /* Searches for the margin. If kerns are not nested, the search may walk in
       even steps. A whole number of these steps is one step of Algorithm 1. */
    status = nested ? kern_path_search(&c->m, path, 0)
                    : kern_path_scan(
                        &c->m, path,
                        first / KERN_R(1 + (int)(KERN_SCAN * first / r.most)));

    if (status == KERN_STANDS) {
        r.margin = path->critical;
        r.holds = path->holds;
        r.fails = path->fails;
        r.saturated = path->never_falls;
        KERN_ASSERT(r.holds <= r.margin && r.margin <= r.fails);
        kern_level_scan(&c->m, path, nested, last, &r);
    }

    /* If the limit ended the call, or the search is undecided, the result is
       the bracket that is proven so far. */
    status = kern_call_status(task, status);
    if (status == KERN_LIMIT || status == KERN_UNDECIDED) {
        r.fails = kern_min(path->proven.high, r.most);
        r.margin = r.holds = kern_min(path->proven.low, r.fails);
        r.level = -1;
        r.saturated = 0;
    }

    if (status >= KERN_UNDECIDED || status == KERN_LIMIT)
        *out = r;
    return status;
}

/* Opens a task and computes its margin and level. If the limit ends the call
   before it has read the task, writes -1 and infinite values to *out. */
static kern_status kern_measure_anew(const kern_task *task,
                                     const kern_known *known, kern_margin *out,
                                     const kern_proof *proof)
{
    kern_call c;
    const kern_status status = kern_call_open(&c, task, 0, out);
    if (status == KERN_OK)
        return kern_measure_task(&c, known, out, proof);
    if (status != KERN_LIMIT)
        return status;
    out->margin = out->holds = -1;
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

    /* Without both arrays of task->known there is no warm start. */
    known = task->known;
    if (!known.motion || !known.force) {
        known.fails = 0;
        return kern_measure_anew(task, &known, out, proof);
    }

    /* Makes the search write its proof to the arrays of task->known. The search
       reads the old motion in these arrays before it writes the new one. The
       search would overwrite the old forces before it uses them, so known.force
       is NULL. */
    kept.force = known.force;
    kept.motion = known.motion;
    known.force = NULL;

    status = kern_measure_anew(task, &known, out, &kept);
    if (status >= KERN_UNDECIDED || status == KERN_LIMIT)
        task->known.fails = 0;

    /* Copies the proof to the caller. */
    if (status >= 0 && proof && proof->force)
        kern_copy(proof->force, kept.force, 2 * task->s.contacts);
    if (status >= 0 && !out->saturated && proof && proof->motion)
        kern_copy(proof->motion, kept.motion, 3 * task->s.blocks);

    /* Keeps the bracket in task->known, whose arrays already have the proof of
       the bracket. */
    if (status == KERN_STANDS) {
        if (out->saturated)
            kern_zero(kept.motion, 3 * task->s.blocks);
        task->known.holds = out->holds;
        task->known.margin = out->margin;
        task->known.fails = out->fails;
    }
    return status;
}

/* Grows the kerns of a structure that falls until it stands, and finds the
   critical value in between. Returns KERN_FALLS if such a growth is found. Then
   path->critical is minus this growth. If the structure falls even at the
   largest growth (>>rules), path->critical is -infinity. */
static kern_status kern_grow(kern_model *m, kern_path *path)
{
    kern_real range[2], length = path->unit * KERN_GROW_FIRST, limit;
    const kern_real growth = kern_is_nested(m, range) ? KERN_GROW_NESTED
                                                      : KERN_GROW_EVEN;
    const kern_real infinity = KERN_INFINITY;
    kern_box whole = {{infinity, infinity}, {-infinity, -infinity}};
    kern_status status;
    int i;

    /* Computes the largest growth: KERN_GROW_MOST times the longest side of the
       box around the free blocks. If kerns are relative, the largest growth is
       divided by the shortest travel. */
    for (i = 0; i < 2 * m->graph.groups; i++) {
        const kern_block *b = m->s->block + m->graph.block[i / 2];
        const kern_real way = kern_block_size(b) * KERN_R(i & 1 ? 0.5 : -0.5);
        kern_box_add(&whole,
                     b->vertices
                         ? i & 1 ? b->box.high : b->box.low
                         : kern_vec_add(b->centre, kern_vec_make(way, way)));
    }
    limit = KERN_GROW_MOST
          * kern_vec_largest(kern_vec_sub(whole.high, whole.low));
    if (path->q.relative)
        limit = range[0] < KERN_INFINITY ? limit / range[0] : 1;

    /* Multiplies the growth by a factor from step to step. The factor is small
       if kerns are not nested, since the structure may then stand only in a
       narrow interval. */
    path->start = -limit;
    for (;; length = kern_min(length * growth, limit)) {
        status = kern_path_evaluate(m, path, -length);
        if (status != KERN_FALLS && status != KERN_UNDECIDED)
            break;
        if (length >= limit) {
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
    kern_status status = kern_number_open(&c, task, 0, deficit);
    if (status != KERN_OK)
        return status;
    status = kern_path_evaluate(&c.m, &c.path, 0);
    if (status == KERN_FALLS)
        status = kern_grow(&c.m, &c.path);
    status = kern_call_status(task, status);
    if (status == KERN_LIMIT)
        *deficit = c.path.proven.high <= 0 ? 0 - c.path.proven.high : -1;
    else if (status >= 0)
        *deficit = status == KERN_STANDS ? 0 : 0 - c.path.critical;
    return status;
}

/* Returns the smallest length of a contact that is at least the logarithmic
   middle of all lengths between lo and hi. Returns 0 if no length lies between
   lo and hi. */
static kern_real kern_length_between(const kern_structure *s, kern_real mean,
                                     kern_real lo, kern_real hi)
{
    kern_real middle = 0, shortest = hi, longest;
    int i, pass;
    for (pass = 0; pass < 2; pass++) {
        shortest = hi;
        longest = lo;
        for (i = 0; i < s->contacts; i++) {
            const kern_real length = kern_contact_length(s->contact + i, mean);
            if (length > lo && length < hi && length >= middle) {
                shortest = kern_min(shortest, length);
                longest = kern_max(longest, length);
            }
        }
        middle = kern_min(KERN_SQRT(shortest) * KERN_SQRT(longest), longest);
    }
    return shortest < hi ? shortest : 0;
}

KERN_API kern_status kern_bearing(const kern_task *task, kern_real *length,
                                  const kern_proof *proof)
{
    kern_real shortest = 0, lo = -1, hi = KERN_INFINITY;
    kern_call c;
    int round;
    kern_status status = kern_number_open(&c, task, shortest, length);
    if (status != KERN_OK)
        return status;

    /* Evaluates the structure with all contacts in round 0, and in round 1 with
       only those contacts that have no length. Further rounds bisect the
       lengths of the contacts, on a logarithmic scale. */
    for (round = 0; round < 2 || shortest > 0; round++) {
        c.path.q.length_min = shortest;
        kern_model_group(&c.m, &c.path.q);
        status = kern_model_evaluate(&c.m, &c.part, &c.path.q);
        kern_proof_write(&c.m, proof, status);

        /* Moves an end of the interval [lo, hi) of lengths. Ends if the
           structure falls with all contacts, or after an error. */
        if (status == KERN_STANDS)
            lo = shortest;
        else if (lo < 0 || status < KERN_UNDECIDED)
            break;
        else
            hi = shortest;

        /* Sets the motion of an undecided verdict to 0. */
        if (status == KERN_UNDECIDED && proof && proof->motion)
            kern_zero(proof->motion, 3 * task->s.blocks);

        shortest = round == 0 ? KERN_INFINITY
                              : kern_length_between(&task->s,
                                                    c.path.q.mean_size, lo, hi);
        status = KERN_STANDS;
    }

    status = kern_call_status(task, status);
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *length = lo;
    return status;
}

/* Returns 1 if there is gravity and the side is left or right. */
static int kern_has_side(const kern_structure *s, kern_side side)
{
    return (side == KERN_RIGHT || side == KERN_LEFT)
        && kern_vec_largest(s->gravity) > 0;
}

/* Returns the angle whose tangent is s >= 0: halves the angle three times, then
   sums the series of the arctangent. */
static kern_real kern_angle_of(kern_real s)
{
    kern_real sum = 0, t2;
    int i;
    s = kern_half_tangent(kern_half_tangent(kern_half_tangent(s)));
    t2 = s * s;
    for (i = 25; i > 0; i -= 2)
        sum = 1 / KERN_R(i) - t2 * sum;
    return 8 * s * sum;
}

/* Opens a call whose result is the factor of a load pattern. If `pattern` is
   NULL, the result is the factor of a horizontal load to a side, or the tilt to
   that side. Checks the pattern or the side. */
KERN_SHARED static kern_status kern_growth_open(kern_call *c,
                                                const kern_task *task,
                                                kern_real shrink,
                                                const kern_wrench *pattern,
                                                kern_side side, kern_real *out)
{
    int i;
    const kern_status status = kern_number_open(c, task, shrink, out);
    if (status != KERN_OK)
        return status;
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

/* Runs a path on which a load grows or gravity turns: checks it, searches it,
   and writes the factor or the angle to *out. */
static kern_status kern_run(kern_call *c, const kern_task *task,
                            kern_real shrink, kern_path_kind kind,
                            const kern_wrench *pattern, kern_side side,
                            kern_real *out, const kern_proof *proof)
{
    const int tilt = kind == KERN_PATH_TILT;
    kern_path *const path = &c->path;
    int loaded;
    kern_status status = kern_growth_open(c, task, shrink, pattern, side, out);
    if (status != KERN_OK)
        return status;

    /* Under fixed loads a structure that falls may stand again at a larger
       tilt. */
    loaded = tilt && kern_model_loaded(&c->m);
    kern_path_push(path, kind, pattern, side);
    path->proof = proof;
    path->end = tilt ? 1 : KERN_FACTOR_MOST;

    /* Solves up to KERN_SMALL groups by one linear program, which gives the
       critical value exactly. */
    if (!loaded && c->m.graph.groups <= KERN_SMALL
        && kern_model_has_room(&c->m))
        kern_model_whole(&c->m, path->part, &path->q);

    status = kern_path_evaluate(&c->m, path, 0);
    if (status == KERN_STANDS)
        status = kern_path_search(&c->m, path, KERN_R(loaded) / KERN_SCAN);

    status = kern_call_status(task, status);
    if (status == KERN_LIMIT)
        path->critical = path->proven.low;
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *out = tilt              ? 4 * kern_angle_of(path->critical)
             : path->never_falls ? KERN_INFINITY
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

/* Returns the factor of the load pattern below which the motion in m->answer is
   a fall, or infinity if the pattern does not resist this motion. */
static kern_real kern_motion_factor(const kern_model *m, const kern_query *q)
{
    kern_query unloaded = *q;
    kern_real power = KERN_R(0), resisted = power;
    int i;
    unloaded.factor = KERN_R(0);
    for (i = 0; i < m->s->blocks; i++) {
        const kern_motion *v = m->answer.motion + i;
        const kern_wrench *load = q->pattern + i;
        kern_wrench w;
        if (!(kern_speed(v) > 0))
            continue;
        kern_block_wrench(m->s, &unloaded, i, &w);
        power += w.fx * v->vx + w.fy * v->vy + w.torque * v->spin;
        resisted -= load->fx * v->vx + load->fy * v->vy
                  + load->torque * v->spin;
    }
    return resisted > 0 ? power / resisted : KERN_INFINITY;
}

/* Uses Newton's method from below. Each mechanism gives the factor of the
   pattern at which the pattern just stops it. Just above that factor either
   another mechanism falls or the structure stands. */
KERN_API kern_status kern_least_load_of(const kern_task *task, kern_real shrink,
                                        const kern_wrench *pattern,
                                        kern_real *factor,
                                        const kern_proof *proof)
{
    kern_real offset = KERN_WIDTH, falls = KERN_R(0);
    kern_call c;
    kern_query *q = &c.path.q;
    int round;
    kern_status status = pattern ? kern_growth_open(&c, task, shrink, pattern,
                                                    KERN_SHRINK, factor)
                                 : KERN_BAD_POINTER;
    if (status != KERN_OK)
        return status;

    /* Evaluates the structure at a factor just above the value of each
       mechanism. If a factor gives no proof, the next one lies twice as far
       above the value. */
    kern_path_push(&c.path, KERN_PATH_LOAD, pattern, KERN_SHRINK);
    for (round = 0; round < KERN_LEAST_ROUNDS && falls < KERN_FACTOR_MOST;
         round++) {
        status = kern_model_evaluate(&c.m, &c.part, q);
        kern_proof_write(&c.m, proof, status);
        if (status == KERN_FALLS)
            falls = kern_max(falls, kern_motion_factor(&c.m, q));
        else if (status != KERN_UNDECIDED)
            break;
        else if (falls < q->factor)
            offset *= 2;
        q->factor = falls + offset * (1 + falls);
    }

    /* Returns KERN_FALLS only if falls are proven up to the largest factor. */
    if (status == KERN_FALLS && falls < KERN_FACTOR_MOST)
        status = KERN_UNDECIDED;
    status = kern_call_status(task, status);
    *factor = status == KERN_STANDS ? q->factor
            : status == KERN_FALLS  ? KERN_INFINITY
                                    : falls;
    return status;
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
        status = kern_norm_open(p, &c.m) ? kern_norm_find(
                     p, kern_part_load(p, &c.path.q, p->dual.load), KERN_BOUND,
                     KERN_START_COLD, KERN_NORM_ROUNDS)
                                         : KERN_NO_SPACE;
        if (status == KERN_FALLS) /* this has no proof */
            status = KERN_UNDECIDED;
        if (status == KERN_STANDS) {
            kern_norm_write(p);
            if (!kern_answer_holds(&c.m, &c.path.q))
                status = KERN_UNDECIDED;
        }
        status = kern_call_status(task, status);
    }
    kern_proof_write(&c.m, &proof, status);
    return status;
}

/* ---- The profile --------------------------------------------- >>profile */
/* The profile follows a progressive collapse. The blocks that move at a
   critical value are removed from the model, and the path continues with the
   other blocks. */

typedef struct kern_fall {
    int missing;        /* number of values of the weaker half that are not
                           known yet; this half of the blocks falls first   */
    kern_real weak_sum; /* sum of the known values of the weaker half       */
    kern_real *value;   /* per block: its value, or -1 while it stands      */
} kern_fall;

/* Selects which of the remaining blocks kern_fall_add() records as fallen. */
typedef enum kern_fall_scope {
    KERN_FALL_MOVING, /* all blocks that move in the mechanism            */
    KERN_FALL_ALL
} kern_fall_scope;

/* Records `value` as the value of every remaining block that falls, and adds it
   to the sum of the weaker half. */
static void kern_fall_add(const kern_model *m, kern_fall *fall, kern_real value,
                          kern_fall_scope scope)
{
    const kern_motion *v = m->answer.motion;
    int i;
    KERN_ASSERT(value >= 0);
    for (i = 0; i < m->s->blocks; i++)
        if (m->graph.group[i] < m->graph.groups
            && (scope == KERN_FALL_ALL
                || kern_block_speed(m->s->block + i, v + i) > KERN_REST)) {
            fall->value[i] = value;
            if (fall->missing-- > 0)
                fall->weak_sum += value;
        }
}

/* Returns the verdict at path->fails, where the structure fell last. If the
   verdict is undecided, evaluates up to KERN_FALL_TRIES places beyond it. */
static kern_status kern_fall_evaluate(kern_model *m, kern_path *path)
{
    kern_real place = path->fails;
    kern_status status;
    int tries = KERN_FALL_TRIES;
    do {
        status = kern_path_evaluate(m, path, place);
        place += kern_width(path);
    } while (status == KERN_UNDECIDED && tries-- > 0);
    return status;
}

/* Follows the whole collapse along a path: finds a critical value, removes the
   blocks that move in its mechanism, and continues to the next critical value.
   The mechanism needs a verdict of its own, since the last verdict of a search
   may be at another place. The number of rounds that remove no block is
   bounded. Rounds that remove no block occur if the verdicts "stands" and
   "falls" both have a proof at one place. */
static kern_status kern_fall_follow(kern_model *m, kern_path *path,
                                    kern_fall *fall)
{
    kern_real range[2], place = 0;
    kern_status status = kern_path_evaluate(m, path, place);
    int rounds = 3 * m->graph.groups + KERN_FALL_IDLE;

    while (m->graph.groups > 0 && !path->never_falls) {
        if (rounds-- == 0)
            return KERN_UNDECIDED;

        /* Removes the blocks that move in the mechanism. Then evaluates the
           remaining blocks at the place where the structure fell last, or just
           beyond it. */
        if (status == KERN_FALLS) {
            kern_fall_add(m, fall, place, KERN_FALL_MOVING);
            kern_model_group(m, &path->q);
            if (m->graph.groups > 0)
                status = kern_fall_evaluate(m, path);

        } else if (status == KERN_STANDS) {
            /* Finds the critical value of the remaining blocks, which stand
               here, and the mechanism just beyond this value. */
            status = kern_path_search(m, path,
                                      path->kind != KERN_PATH_SHRINK
                                              || kern_is_nested(m, range)
                                          ? 0
                                          : path->end / KERN_SCAN);
            place = path->critical;
            if (status == KERN_STANDS && !path->never_falls)
                status = kern_fall_evaluate(m, path);
        } else
            return status;
    }

    /* Gives the remaining blocks the end of the path as their value, since they
       stand up to there. */
    kern_fall_add(m, fall, path->end, KERN_FALL_ALL);
    return KERN_OK;
}

/* Returns e^-x for x >= 0. Computes e^(x / 1024) by its series and squares it
   ten times, since libm differs between machines. The relative error of the
   result is at most 2e-4 for x up to 10. */
static kern_real kern_decay(kern_real x)
{
    const kern_real t = x / KERN_R(1024);
    kern_real y = 1 + t + t * t / 2;
    int i;
    for (i = 0; i < 10; i++)
        y *= y;
    return 1 / y;
}

/* Returns the expected drop of all free blocks together: the sum, over these
   blocks, of the chance that the block falls times its height above the lowest
   block. The height is measured in mean sizes, and is at least
   KERN_DROP_HEIGHT. */
static kern_real kern_expected_drop(const kern_model *m, const kern_real *value)
{
    const kern_structure *s = m->s;
    const kern_real pull = kern_vec_length(s->gravity);
    kern_real base = KERN_INFINITY, sum = 0;
    int i, pass;
    for (pass = 0; pass < 2; pass++)
        for (i = 0; i < s->blocks; i++) {
            const kern_block *b = s->block + i;
            const kern_real height = -kern_vec_dot(b->centre, s->gravity)
                                   / pull;
            if (b->fixed)
                continue;
            if (pass == 0)
                base = kern_min(base, height - kern_block_size(b) / 2);
            else
                sum += kern_max(KERN_DROP_HEIGHT,
                                (height - base) / m->mean_size)
                     * kern_decay(value[i] / KERN_DROP_LOAD);
        }
    return sum;
}

KERN_API kern_status kern_profile(const kern_task *task, kern_side side,
                                  kern_real *value, kern_collapse *out)
{
    kern_call c;
    kern_fall fall;
    kern_real range[2], weakest = KERN_INFINITY, sum = 0;
    int i, free_blocks, half;
    kern_status status = kern_call_open(&c, task, 0, value ? out : NULL);

    /* Sets every value to -1, which it keeps while its block stands. Sets the
       values even if the limit has ended the call. */
    for (i = 0;
         (status == KERN_OK || status == KERN_LIMIT) && i < task->s.blocks; i++)
        value[i] = -1;
    if (status != KERN_OK)
        return status;

    /* Chooses the path: kerns shrink up to the longest travel, or a load
       grows. */
    kern_is_nested(&c.m, range);
    if (side != KERN_SHRINK && !kern_has_side(&task->s, side))
        return KERN_BAD_OPTION;
    if (side != KERN_SHRINK)
        kern_path_push(&c.path, KERN_PATH_LOAD, NULL, side);
    c.path.end = side ? KERN_PROFILE_MOST : range[1];

    /* Makes queries leave out every block that already has a value. */
    c.path.q.fallen = value;
    free_blocks = c.m.graph.groups;
    fall.missing = half = (free_blocks + 1) / 2;
    fall.weak_sum = sum;
    fall.value = value;
    status = kern_call_status(task, kern_fall_follow(&c.m, &c.path, &fall));

    /* Computes the least value and the sum of the values of free blocks. */
    for (i = 0; i < task->s.blocks; i++) {
        if (task->s.block[i].fixed)
            value[i] = KERN_INFINITY;
        else
            sum += value[i];
        weakest = kern_min(weakest, value[i]);
    }
    if (status != KERN_OK)
        return status;

    out->least = weakest;
    out->mean = sum / KERN_R(free_blocks);
    out->weak = fall.weak_sum / KERN_R(half);
    out->drop = side ? kern_expected_drop(&c.m, value) / KERN_R(free_blocks)
                     : 0;
    return KERN_OK;
}

/* ---- What is critical ---------------------------------------- >>critical */

/* Returns how a contact moves in a mechanism: it opens, slides, hinges or
   rests. u is the velocity of block b relative to block a at the contact.
   `turn` is the relative spin of the two blocks, times the mean size. */
static kern_meeting kern_meeting_of(const kern_contact *c, kern_real mu,
                                    kern_vec u, kern_real turn)
{
    const kern_real slide = kern_abs(kern_vec_cross(c->n, u));
    if (kern_vec_dot(c->n, u) > mu * slide + KERN_REST)
        return KERN_OPENS;
    if (slide > KERN_REST)
        return KERN_SLIDES;
    return kern_abs(turn) > KERN_REST ? KERN_HINGES : KERN_RESTS;
}

/* Writes how each contact moves in the mechanism, and its limit, which is
   larger the more the contact limits the margin. Finds the first contact with
   the largest limit. The limit is the first of these three measures that is
   above 0 for any contact:
     0  the power that the mechanism gains per unit of shrinkage because the
        force moves inward: the normal force times the relative spin of the
        blocks (relative: times the travel, too); 0 if the kern is closed or the
        contact opens
     1  the relative spin of the blocks, if the contact hinges
     2  the relative speed of the blocks, if the contact slides */
static void kern_critical_contacts(const kern_structure *s, const kern_query *q,
                                   const kern_proof *proof, kern_critical *out)
{
    kern_real largest = 0, reduction = kern_reduction(q), rate;
    int measure, i;

    /* Tries the three measures in order until one is above 0 for a contact.
       Measure 0 needs the forces of the proof. */
    for (measure = !proof->force; measure < 3 && out->contact < 0; measure++)
        for (i = 0; i < s->contacts; i++) {
            const kern_contact *c = s->contact + i;
            const kern_vec u = kern_meeting_motion(s, q, c, proof->motion);
            const kern_real spin = proof->motion[c->b].spin
                                 - proof->motion[c->a].spin;
            const kern_meeting meeting = kern_meeting_of(
                c, kern_friction(c, reduction), u, spin * q->mean_size);

            kern_real limit = 0;
            kern_shift(c->travel, q->shrink, q->relative, &rate);
            if (measure == 0 && meeting != KERN_OPENS)
                limit = kern_max(-spin * rate * proof->force[i].normal, 0);
            if (measure == 1 && meeting == KERN_HINGES)
                limit = kern_abs(spin);
            if (measure == 2 && meeting == KERN_SLIDES)
                limit = kern_vec_length(u);

            if (out->meeting)
                out->meeting[i] = meeting;
            if (out->limit)
                out->limit[i] = limit;
            if (limit > largest * (1 + KERN_TIE)) {
                largest = limit;
                out->contact = i;
            }
        }

    /* Scales the limits so that the largest is 1. */
    for (i = 0; i < s->contacts && out->limit && largest > 0; i++)
        out->limit[i] /= largest;
}

/* Returns 1 if the blocks i and j move as one rigid body. */
static int kern_as_one(const kern_structure *s, const kern_motion *motion,
                       int i, int j)
{
    const kern_vec r = kern_vec_sub(s->block[j].centre, s->block[i].centre);
    const kern_vec v = kern_velocity(motion + i, r);
    kern_motion relative = motion[j];
    relative.vx -= v.x;
    relative.vy -= v.y;
    relative.spin -= motion[i].spin;
    return kern_block_speed(s->block + j, &relative) < KERN_REST;
}

/* Numbers the groups of blocks that move as one rigid body. Each group begins
   with the fastest block that is not yet in a group. Blocks at rest get -1. */
static void kern_critical_blocks(const kern_structure *s,
                                 const kern_motion *motion, kern_critical *out)
{
    const int unset = s->blocks;
    int i, lead;
    for (i = 0; i < s->blocks; i++)
        out->group[i] = unset;
    for (;; out->groups++) {
        kern_real fastest = 0;
        for (lead = i = 0; i < s->blocks; i++) {
            const kern_real speed = kern_block_speed(s->block + i, motion + i);
            if (speed < KERN_REST)
                out->group[i] = -1;
            if (out->group[i] == unset && speed > fastest * (1 + KERN_TIE)) {
                fastest = speed;
                lead = i;
            }
        }
        if (!(fastest > 0))
            return;
        for (i = 0; i < s->blocks; i++)
            if (out->group[i] == unset && kern_as_one(s, motion, lead, i))
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
/* At the margin d* the power G that forces and loads have in the mechanism is
   0. If an input q changes, such as the place of a contact or the mass of a
   block, d* changes so that G stays 0. So the derivative of d* with respect to
   q is -G_q / G_d, where G_q and G_d are the derivatives of G with respect to q
   and to the shrinkage d. Forces and mechanism are those of the proof. */

/* Writes the derivatives G_q (>>sensitivity) with respect to all data q of
   contact i. Returns the contribution of the contact to G_d. G_q and G_d are 0
   if the contact has no force or its blocks do not move. */
static kern_real kern_contact_gain(const kern_structure *s, const kern_query *q,
                                   int i, const kern_proof *proof,
                                   kern_contact_rate *out)
{
    const kern_contact *c = s->contact + i;
    const kern_vec t = kern_vec_turn(c->n);
    const kern_real f = proof->force[i].normal, r = proof->force[i].tangential;
    const kern_vec force = kern_vec_step(kern_vec_scale(c->n, f), r, t);
    const kern_real travel = kern_travel(c, q->mean_size);
    const int closed = !q->relative && q->shrink >= kern_abs(travel);
    const kern_real spin = proof->motion[c->b].spin - proof->motion[c->a].spin;
    kern_real rate, shift;
    kern_vec u;
    kern_zero(out, 5);
    if (!(f > 0) || !(kern_speeds(c, proof->motion) > 0))
        return 0;
    u = kern_meeting_motion(s, q, c, proof->motion);
    shift = kern_shift(travel, q->shrink, q->relative, &rate);
    out->p = kern_vec_make(spin * force.y, -spin * force.x);
    out->turn = kern_vec_cross(force, u) - shift * spin * r;
    if (c->mu > 0)
        out->mu = r / c->mu * kern_vec_dot(u, t);
    if (q->relative || closed)
        out->travel = -spin * f * (closed ? 1 : q->shrink);
    return -rate * spin * f;
}

/* Adds to the rates of the two blocks of contact i the contribution of this
   contact: if a block moves, the contact moves as the contact search would find
   it. `pair` is the other end of the line, or i for a point. At an end of a
   line, the block whose corner is there moves the end along the line. Across
   the line, each block moves the end by half of its own motion and turns the
   normal by half of its own turn, since the line stays midway between the two
   edges. At a point, the block with the corner moves the point, and the block
   with the edge turns the normal. */
KERN_SHARED static void kern_pose_gain(const kern_task *task,
                                       const kern_contact_rate *rate, int i,
                                       int pair, kern_block_rate *out)
{
    const kern_contact *c = task->s.contact + i;
    const kern_vec t = kern_vec_turn(c->n);
    const kern_real rate_t = kern_vec_dot(rate[i].p, t)
                           + (rate[pair].travel - rate[i].travel) / 2;
    const kern_real rate_n = kern_vec_dot(rate[i].p, c->n);
    kern_real nearest[2]; /* per block: distance along t to the next corner */
    int end, k;

    if (!(kern_abs(rate_t) + kern_abs(rate_n) + kern_abs(rate[i].turn) > 0))
        return;

    /* Finds for each block the vertex that is nearest to the contact point,
       measured along the contact, of those close to the line of the contact.
       The nearer of the two vertices is the corner at this end. */
    for (end = 0; end < 2; end++) {
        const kern_block *b = task->s.block + (end ? c->b : c->a);
        nearest[end] = KERN_INFINITY;
        for (k = 0; b->vertex && k < b->vertices; k++) {
            const kern_vec r = kern_vec_sub(b->vertex[k], c->p);
            const kern_real distance = kern_abs(kern_vec_cross(c->n, r));
            if (distance < nearest[end]
                && kern_abs(kern_vec_dot(c->n, r))
                       <= KERN_CORNER_NEAR * kern_block_size(b)
                              + task->options.gap)
                nearest[end] = distance;
        }
    }

    /* Adds the contribution to each block. The block with the corner moves the
       contact point along the contact. Across the contact, `part` is the share
       by which the block moves it: half for a line, and for a point 1 for the
       block with the corner and 0 for the other one. The normal turns with the
       block by the remaining share, 1 - part. */
    for (end = 0; end < 2; end++) {
        const int owner = end ? c->b : c->a;
        const kern_block *b = task->s.block + owner;
        const kern_vec r = kern_vec_sub(c->p, b->centre);
        const kern_real size = kern_block_size(b);
        const kern_real owns = KERN_R(
            nearest[end] <= KERN_CORNER_NEAR * size
            && nearest[end] <= nearest[!end] + KERN_CORNER_TIE * size);
        const kern_real part = pair != i ? KERN_R(0.5) : owns;
        const kern_vec way = kern_vec_step(kern_vec_scale(t, owns * rate_t),
                                           part * rate_n, c->n);

        kern_block_rate *gain = out + owner;
        if (b->vertex) {
            gain->place = kern_vec_add(gain->place, way);
            gain->turn += kern_vec_cross(r, way) + (1 - part) * rate[i].turn;
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
    kern_real gain = 0, total = 0;
    int i, end, line;
    kern_status status = kern_query_check(
        task, margin ? margin->margin : 0,
        margin && proof && proof->force && proof->motion && contact ? block
                                                                    : NULL,
        &q);
    if (status != KERN_OK)
        return status;

    /* Writes G_q for the data of the contacts, and sums their contributions to
       G_d. */
    for (i = 0; i < task->s.contacts; i++) {
        const kern_real g = kern_contact_gain(&task->s, &q, i, proof,
                                              contact + i);
        gain += g;
        total += kern_abs(g);
    }

    /* Returns KERN_UNDECIDED if the power does not change along the path: then
       the margin has no derivative. */
    if (margin->saturated || !(kern_abs(gain) > KERN_RATE_LEAST * total))
        return KERN_UNDECIDED;

    /* Writes G_q for loads, masses and centres of mass: the change of the power
       of the loads. */
    for (i = 0; i < task->s.blocks; i++) {
        const kern_block *b = task->s.block + i;
        const kern_real mass = b->fixed ? 0 : b->mass;
        const kern_vec g = task->s.gravity;
        const kern_motion *v = proof->motion + i;
        kern_copy(&block[i].load, v, 3);
        block[i].turn = 0;
        block[i].place = block[i].centre = kern_vec_make(
            v->spin * (g.y * mass), -v->spin * (g.x * mass));
        block[i].mass = g.x * v->vx + g.y * v->vy;
    }

    /* Adds G_q for the poses of the blocks, which follows from G_q of the
       contacts. Treats the two ends of a line together. */
    for (i = 0; i < task->s.contacts; i += 1 + line) {
        line = kern_line_begins(task->s.contact, task->s.contacts, i);
        for (end = 0; end <= line; end++)
            kern_pose_gain(task, contact, i + end, i + line - end, block);
    }

    /* Computes the rates of the margin, -G_q / G_d. */
    kern_scale(contact, 5 * task->s.contacts, -1 / gain);
    kern_scale(block, 9 * task->s.blocks, -1 / gain);
    return KERN_OK;
}

/* ---- Raised ----------------------------------------------------- >>raised */
/* Finds the forces that a load raises on contacts that are unstressed at first
   and have a finite stiffness. The loads b cause a displacement u of the
   groups. By this displacement the two blocks of a contact approach each other
   by wn along n and shear by wt along t: w = A' u. Coulomb's law with a
   stiffness k along n and c mu k along t (k = dual.stiffness, c = dual.shear)
   is

       f = k max(0, wn),   r = c mu k wt, cut off at -mu f and mu f      (law)
       A (f, r) = b                                                  (balance)

   The solutions of (law) and (balance) are not those of a linear or convex
   program. Limit analysis leads to such a program, but there two blocks that
   slide also part. A price p on each contact cancels this parting. For given
   prices >>norm finds the u at which the forces of limit analysis, computed
   from wn - p instead of wn, balance b. Where a contact slides by s beyond its
   elastic shear, its two blocks move apart by mu s in limit analysis. So (law)
   and (balance) hold if the prices satisfy

       p = F(p) = max(0, mu s(p))                               (fixed point)

   (Acary, Cadoux, Lemarechal and Malick). Each round of a search finds the
   forces that balance b for the present prices, and then computes new prices.
   When few contacts change between sticking, sliding and open from one round to
   the next, the search tries Newton's method on (law) and (balance). Prices
   need not be exact, since the proof checks only the forces and u
   (kern_prove_raised()).

   A search is lost (KERN_END_LOST) if the forces or u grow too far, if prices
   no longer converge, or if Newton's method balances the loads by forces that
   are no proof. */

typedef struct kern_raise {
    kern_part *part;         /* all groups, or for kern_stays() those near
                                block `placed`                                */
    int placed;              /* index of the block of which kern_stays()
                                computes the chance; otherwise KERN_OUT       */
    const kern_proof *proof; /* the caller's arrays, which receive the proof of
                                each step of the load; NULL: none             */
    kern_end end;            /* why the last search ended                     */
    int unknowns;            /* length of the array that holds u and, after
                                it, the prices                                */
    kern_real *shown;        /* u and prices at the last load with a proof    */
    kern_real *shown_before; /* u and prices at the last but one load that has
                                a proof                                       */
    kern_real *last_price;   /* two per contact: the price that the last round
                                computed, and its change in that round        */
    kern_real *saved;        /* u at the start of Newton's method             */
    kern_skyline columns;    /* upper half of Newton's matrix, by columns;
                                dual.matrix: its lower half, by rows          */
    int *state;              /* per contact: 0 open, 1 sticking, 2 or 3 sliding
                                to one side or the other                      */
} kern_raise;

/* Starting point of a search. KERN_BEGIN_UNLOADED: u = 0. KERN_BEGIN_HERE: the
   present u. Both begin with the present prices. */
typedef enum kern_begin { KERN_BEGIN_UNLOADED, KERN_BEGIN_HERE } kern_begin;

/* State of a search, with the numbers that decide whether it is lost. */
typedef struct kern_settling {
    kern_real tolerance;   /* largest residual of equilibrium              */
    int warm;              /* nonzero: the search starts at the present u  */
    int round;             /* number of rounds that are complete           */
    int units;             /* value of work->units before the search       */
    kern_real drift;       /* largest displacement of a group in the first
                              round                                        */
    kern_real drift_shown; /* largest displacement of a group at the last
                              load with a proof                            */
    kern_real change_min;  /* least sum of squares of the changes of all
                              prices in one round, so far                  */
    int stalled;           /* number of rounds since the one in which
                              change_min was found                         */
} kern_settling;

/* Marks the groups that are held: all except the n groups that are at most
   KERN_STAYS_NEAR contacts away from block i. These n groups keep KERN_OUT in
   graph.local, so that kern_norm_open() opens them. The mark is n, which is the
   index of all held groups and of the ground in the part. */
static void kern_raise_mark(kern_model *m, int i)
{
    const int *ends = m->graph.ends, groups = m->graph.groups;
    int *local = m->graph.local, g, e, distance, n = 1;

    /* Stores for each group its distance from block i, counted in contacts,
       plus 1. The number 0 means that the group has not been reached. The
       ground counts as reached, so that no path leads through it. */
    for (g = 0; g < groups; g++)
        local[g] = 0;
    local[groups] = local[m->graph.group[i]] = 1;
    for (distance = 1; distance <= KERN_STAYS_NEAR; distance++)
        for (g = 0; g < groups; g++)
            for (e = local[g] == distance ? m->graph.first_end[g] : KERN_OUT;
                 e >= 0; e = m->graph.next_end[e])
                if (local[ends[e ^ 1]] == 0) {
                    local[ends[e ^ 1]] = distance + 1;
                    n++;
                }

    /* Replaces the distances by marks: KERN_OUT for groups that were reached, n
       for all others. */
    for (g = 0; g < groups; g++)
        local[g] = local[g] > 0 ? KERN_OUT : n;
    local[groups] = n;
}

/* Opens the groups as one part, with prices of 0. Returns 0 if there is no
   room. The stiffness of a contact point is 0.1, plus at the end of a line its
   travel in mean sizes. Of several such formulas that were tried, this one
   agreed best with a simulator. */
static int kern_raise_open(kern_raise *r, kern_model *m)
{
    kern_part *p = r->part;
    int g, k, entries = 0;
    if (r->placed >= 0)
        kern_raise_mark(m, r->placed);
    if (!kern_norm_open(p, m))
        return 0;

    /* Sets the stiffness along t. In a proof a contact that sticks may slide
       only by the share KERN_STICKS of its approach, so dual.shear is larger
       than 1 / KERN_STICKS. kern_stays() needs no proof and uses a smaller
       stiffness. */
    p->y = p->dual.step; /* y holds a motion: no program uses it */
    p->dual.shear = r->placed < 0 ? KERN_R(1.1) / KERN_STICKS
                                  : KERN_STAYS_STIFF;

    /* Takes memory for the arrays of a search. Newton's matrix is not
       symmetric, so its upper half has memory of its own. The prices follow u
       in one array, so that one copy copies both. */
    for (g = 0; g < p->groups; g++)
        entries += 9 * (g - p->dual.matrix.first_column[g] + 1);
    r->columns = p->dual.matrix;
    r->columns.entry = kern_take_reals(&p->rest, entries);
    r->unknowns = 3 * p->groups + 3 + p->contacts;
    r->saved = kern_take_reals(&p->rest, 3 * p->groups + 3);
    r->shown = kern_take_reals(&p->rest, 2 * r->unknowns);
    r->shown_before = r->shown + r->unknowns;
    p->dual.u = kern_take_reals(&p->rest, r->unknowns + 3 * p->contacts);
    p->dual.law = KERN_LAW_STIFF;
    p->dual.price = p->dual.u + r->unknowns - p->contacts;
    p->dual.stiffness = p->dual.price + p->contacts;
    r->last_price = p->dual.stiffness + p->contacts;
    r->state = kern_take_ints(&p->rest, p->contacts);
    if (!kern_take_fits(&p->rest))
        return 0;

    /* Sets the prices to 0. Sets the stiffness of each contact point, which at
       an end of a line grows with the length of the line. */
    kern_zero(p->dual.price, p->contacts);
    for (k = 0; k < p->contacts; k++) {
        const kern_contact *c = m->s->contact + p->contact[k];
        r->state[k] = 0;
        p->dual.stiffness[k] = KERN_R(0.1)
                             + (c->line ? kern_abs(c->travel) / m->mean_size
                                        : KERN_R(0));
    }
    return 1;
}

/* ---- a round of prices ---- */

/* Returns the distance by which contact k slides beyond its elastic shear. The
   result is negative if the contact sticks. `approach` is the approach of the
   contact, from which no price is subtracted. A contact with a negative
   approach does not press and has no elastic shear. */
static kern_real kern_raise_slip(const kern_part *p, int k, kern_real approach)
{
    return kern_abs(p->dual.approach[2 * k + 1])
         - kern_max(approach, 0) / p->dual.shear;
}

/* Writes the forces at u. Computes the next price of each contact and writes
   the price and its change to dual.change. Returns 1 if the forces may be a
   proof. They then balance the loads (`found`), every loaded contact
   approaches, and the longest slide is at most KERN_SLIDE_MOST times the
   largest approach. A stone that falls into a jam slides farther.
   The next price of a contact is F(p) of >>raised, with two exceptions. A price
   that falls is lowered slowly, since otherwise the prices of joints that lean
   on each other would alternate from round to round. If the forces balance the
   loads, the price of a contact whose blocks move apart does not fall. If such
   a contact still has a force, its price rises by twice the amount that would
   make the force 0, since otherwise a joint that no longer presses would stay
   loaded. */
static int kern_raise_price(kern_raise *r, kern_real tolerance, int found)
{
    kern_part *p = r->part;
    const kern_real force_min = tolerance * p->m->weight;
    kern_real slip_max = KERN_R(0), approach_max = KERN_R(0);
    int k, pressed = found;
    kern_norm_write(p);
    for (k = 0; k < p->contacts; k++) {
        const kern_real wn = p->dual.approach[2 * k], price = p->dual.price[k];
        const kern_real approach = wn + price;
        const kern_real slip = kern_raise_slip(p, k, approach);
        kern_real target = kern_model_mu(p->m, p->contact[k])
                         * kern_max(slip, 0);

        /* Checks that a loaded contact approaches. Finds the longest slide and
           the largest approach of all loaded contacts, which are compared at
           the end. */
        if (p->m->answer.force[p->contact[k]].normal > force_min) {
            pressed &= approach > 0;
            slip_max = kern_max(slip_max, slip);
            approach_max = kern_max(approach_max, approach);
        }

        /* Keeps or raises the price of a contact whose blocks move apart. A
           price that falls changes by the share KERN_PRICE_FALL of the
           difference to its new value. */
        if (found && !(approach > 0))
            target = kern_max(target, price)
                   + 2 * kern_max(wn + kern_max(target, price), 0);
        if (target < price)
            target = price + KERN_PRICE_FALL * (target - price);
        p->dual.change[2 * k] = target;
        p->dual.change[2 * k + 1] = target - price;
    }
    return pressed && slip_max <= KERN_SLIDE_MOST * approach_max;
}

/* Sets the prices for the next round from those that the last two rounds
   computed. Subtracts from the latest prices the share `portion` of the
   difference between the latest and the earlier ones. If F of >>raised is
   linear, this share makes the next change of prices least (Anderson's method).
   If the change of prices has kept its direction and grown, a slide has only
   begun: the prices are then extrapolated forward by KERN_FORWARD times the
   difference. Returns the sum of the squares of the latest changes. */
static kern_real kern_raise_extrapolate(kern_raise *r, int round)
{
    const kern_part *p = r->part;
    const kern_real *price = p->dual.change;
    kern_real cross = KERN_R(0), square = cross, product = cross,
              norm_last = cross, norm_now = cross, portion;
    int k;
    if (round == 0)
        kern_copy(r->last_price, price, 2 * p->contacts);
    for (k = 1; k < 2 * p->contacts; k += 2) {
        const kern_real change = price[k] - r->last_price[k];
        cross += price[k] * change;
        square += change * change;
        product += price[k] * r->last_price[k];
        norm_last += r->last_price[k] * r->last_price[k];
        norm_now += price[k] * price[k];
    }
    portion = square > 0 ? kern_max(-1, kern_min(cross / square, 1))
                         : KERN_R(0);
    if (cross > 0 && product > KERN_COHERENT * KERN_SQRT(norm_last * norm_now))
        portion = -KERN_FORWARD;
    for (k = 0; k < p->contacts; k++)
        p->dual.price[k] = kern_max(
            price[2 * k] - portion * (price[2 * k] - r->last_price[2 * k]), 0);
    kern_copy(r->last_price, price, 2 * p->contacts);
    return norm_now;
}

/* Returns the number of contacts whose state differs from that in the last
   call, and stores the present states. A contact is open, sticks, or slides to
   one side or the other. */
static int kern_raise_changes(kern_raise *r)
{
    const kern_part *p = r->part;
    int k, n = 0;
    for (k = 0; k < p->contacts; k++) {
        const kern_real approach = p->dual.approach[2 * k] + p->dual.price[k];
        const int state = !(approach > 0)                        ? 0
                        : !(kern_raise_slip(p, k, approach) > 0) ? 1
                        : p->dual.approach[2 * k + 1] > 0        ? 2
                                                                 : 3;
        n += r->state[k] != state;
        r->state[k] = state;
    }
    return n;
}

/* ---- Newton's method ---- */

/* Subtracts from dual.grad the wrenches that contact k exerts by Coulomb's law.
   Adds the derivatives of these wrenches with respect to u to Newton's matrix:
   to its rows (dual.matrix) and its columns (r->columns). Returns the normal
   force. */
static kern_real kern_raise_contact(kern_raise *r, int k)
{
    static const kern_real approach[2] = {1, 0}, shear[2] = {0, 1};
    kern_part *p = r->part;
    const int *ends = p->ends + 2 * (size_t)k;
    const kern_real *w = p->dual.approach + 2 * (size_t)k;
    const kern_real mu = kern_model_mu(p->m, p->contact[k]);
    const kern_real stiffness = p->dual.stiffness[k];
    kern_real by_approach[2], by_shear[2] = {0, 0};
    kern_row row[2];
    by_approach[0] = stiffness;
    by_approach[1] = KERN_R(0);
    if (kern_raise_slip(p, k, w[0]) > 0)
        by_approach[1] = w[1] > 0 ? mu * stiffness : -mu * stiffness;
    else
        by_shear[1] = p->dual.shear * mu * stiffness;

    kern_part_exert(p, k, -by_approach[0] * w[0],
                    -by_approach[1] * w[0] - by_shear[1] * w[1], p->dual.grad);
    kern_part_rows(p, k, row);
    kern_skyline_outer(&p->dual.matrix, ends, row, by_approach, approach);
    kern_skyline_outer(&p->dual.matrix, ends, row, by_shear, shear);
    kern_skyline_outer(&r->columns, ends, row, approach, by_approach);
    kern_skyline_outer(&r->columns, ends, row, shear, by_shear);
    return stiffness * w[0];
}

/* Writes to dual.grad the loads b minus the wrenches that the contacts exert by
   Coulomb's law. Writes Newton's matrix to dual.matrix and r->columns. Returns
   the largest normal force. */
static kern_real kern_raise_linearise(kern_raise *r)
{
    kern_part *p = r->part;
    kern_real largest = KERN_R(0);
    int k;
    kern_skyline_clear(&p->dual.matrix);
    kern_skyline_clear(&r->columns);
    kern_copy(p->dual.grad, p->dual.load, 3 * p->groups);
    for (k = 0; k < p->contacts; k++)
        if (p->dual.approach[2 * k] > 0)
            largest = kern_max(largest, kern_raise_contact(r, k));
    kern_zero(p->dual.grad + 3 * p->groups, 3);
    kern_skyline_shift(&p->dual.matrix, KERN_ROUNDING);
    kern_skyline_shift(&r->columns, KERN_ROUNDING);
    return largest;
}

/* Runs Newton's method on the equations (law) and (balance) of >>raised,
   beginning at the present u. Takes whole steps, at most KERN_NEWTON_ROUNDS of
   them, as long as the residual of (balance) falls. If the loads are balanced,
   sets the prices that belong to u and returns 1. Otherwise restores u and
   returns 0. */
static int kern_raise_newton(kern_raise *r, kern_real tolerance)
{
    kern_part *p = r->part;
    const int n = 3 * p->groups;
    kern_real *approach = p->dual.approach, last = KERN_INFINITY;
    int k, round;

    /* Adds the prices to the approaches, from which they have been subtracted,
       since Coulomb's law has no prices. */
    kern_copy(r->saved, p->dual.u, n + 3);
    for (k = 0; k < p->contacts; k++)
        approach[2 * k] += p->dual.price[k];
    for (round = 0; round < KERN_NEWTON_ROUNDS; round++) {
        const kern_real largest = kern_raise_linearise(r);
        const kern_real residual = kern_dot(p->dual.grad, p->dual.grad, n);

        /* Ends if the loads are balanced. The prices that satisfy (fixed point)
           of >>raised then follow from the slips. */
        if (kern_largest(p->dual.grad, n)
            <= tolerance + 4 * KERN_EPS * largest) {
            for (k = 0; k < p->contacts; k++) {
                const kern_real slip = kern_raise_slip(p, k, approach[2 * k]);
                p->dual.price[k] = kern_model_mu(p->m, p->contact[k])
                                 * kern_max(slip, 0);
                approach[2 * k] -= p->dual.price[k];
            }
            return 1;
        }

        /* Takes a whole step. Ends if the last step did not reduce the
           residual, or if the limit of work is reached. */
        if (!(residual < last)
            || !kern_model_spend(p->m, 3 * p->dual.step_units))
            break;
        last = residual;
        kern_skyline_split(&p->dual.matrix, &r->columns);
        kern_skyline_split_solve(&p->dual.matrix, &r->columns, p->dual.grad,
                                 p->dual.step);
        kern_norm_approach(p, KERN_WAY_OF_STEP);
        kern_add(p->dual.u, KERN_R(1), p->dual.step, n);
        kern_add(approach, KERN_R(1), p->dual.change, 2 * p->contacts);
    }

    /* The loads are not balanced: restores u. */
    kern_copy(p->dual.u, r->saved, n + 3);
    kern_norm_approach(p, KERN_WAY_OF_U);
    return 0;
}

/* ---- a search ---- */

/* Returns the largest displacement of a group between u and `origin`, or
   between u and the unloaded structure if `origin` is NULL. A turn counts as
   turn times half the size of the block. */
static kern_real kern_raise_displacement(const kern_raise *r,
                                         const kern_real *u,
                                         const kern_real *origin)
{
    kern_real reach = KERN_R(0);
    int i;
    for (i = 0; i < 3 * r->part->groups; i += 3) {
        kern_real v[3];
        kern_copy(v, u + i, 3);
        if (origin)
            kern_add(v, KERN_R(-1), origin + i, 3);
        v[2] /= 2;
        reach = kern_max(reach, kern_dot(v, v, 3));
    }
    return KERN_SQRT(reach);
}

/* Returns 1 if u has grown too far, by the limits KERN_RUNS_AWAY and
   KERN_JUMPS. */
static int kern_raise_runs_away(const kern_raise *r, kern_settling *settling)
{
    const kern_real *u = r->part->dual.u, groups = KERN_R(r->part->groups);
    const kern_real reach = kern_raise_displacement(r, u, NULL);
    if (settling->round == 0)
        settling->drift = reach;
    return reach > (KERN_RUNS_AWAY + groups) * settling->drift
        || (settling->drift_shown > 0
            && kern_raise_displacement(r, u, r->shown)
                   > KERN_JUMPS * settling->drift_shown);
}

/* Returns 1 if prices no longer converge: for many rounds their change has not
   become smaller than its least value so far. In a row of more groups more
   rounds are allowed, since a slide at one end of the row takes one round for
   each group to reach the other end. */
static int kern_raise_stalls(const kern_raise *r, kern_settling *settling,
                             kern_real change)
{
    if (settling->round == 0 || change < settling->change_min) {
        settling->change_min = change;
        settling->stalled = 0;
    }
    return settling->stalled++ > KERN_PATIENCE + r->part->groups / 2;
}

/* Returns 1 if the forces and u are a proof, and then writes this proof to
   r->proof. For kern_stays(), which needs no proof, always returns 1. */
static int kern_raise_proves(const kern_raise *r, const kern_query *q)
{
    kern_part *p = r->part;
    const kern_model *m = p->m;
    int i;
    if (r->placed >= 0)
        return 1;
    for (i = 0; i < 3 * p->groups; i++)
        p->y[i] = -p->dual.u[i];
    kern_part_motion(p);
    kern_motion_scale(m->s, m->answer.motion);
    if (!kern_model_proven(m, kern_prove_raised(m->s, q, m->answer.force,
                                                m->answer.motion,
                                                m->answer.scratch)))
        return 0;
    kern_proof_write(m, r->proof, KERN_STANDS);
    kern_proof_write(m, r->proof, KERN_FALLS);
    return 1;
}

/* Runs one round of a search. Returns the reason why the search ends, or
   KERN_END_NONE if it continues. */
static kern_end kern_raise_round(kern_raise *r, const kern_query *q,
                                 kern_settling *settling)
{
    kern_part *p = r->part;
    const kern_status found = kern_norm_find(
        p, settling->tolerance, KERN_RAISE_NORM,
        settling->warm || settling->round > 0 ? KERN_START_WARM
                                              : KERN_START_COLD,
        KERN_PRICED_ROUNDS);
    kern_real change;
    int pressed;

    /* Ends the search if a limit of work is reached, or if the forces or u have
       grown too far. */
    if (found == KERN_LIMIT || !kern_model_spend(p->m, 1 + p->contacts / 10)
        || p->m->task->work->units - settling->units
               > KERN_SEARCH_COSTS * p->dual.step_units)
        return KERN_END_WORK;
    if (found == KERN_FALLS || kern_raise_runs_away(r, settling))
        return KERN_END_LOST;

    /* Tries Newton's method if few contacts have changed between sticking,
       sliding and open since the last round. If the method balances the loads,
       the search ends, with or without a proof. */
    if (kern_raise_changes(r) <= KERN_FEW_CHANGES
        && kern_raise_newton(r, settling->tolerance))
        return kern_raise_price(r, settling->tolerance, 1)
                    && kern_raise_proves(r, q)
                 ? KERN_END_SHOWN
                 : KERN_END_LOST;

    /* Computes the prices for the next round. Ends the search if the forces of
       this round are a proof, or if prices no longer converge. */
    pressed = kern_raise_price(r, settling->tolerance, found == KERN_STANDS);
    change = kern_raise_extrapolate(r, settling->round);
    if (pressed && kern_raise_proves(r, q))
        return KERN_END_SHOWN;
    return kern_raise_stalls(r, settling, change) ? KERN_END_LOST
                                                  : KERN_END_NONE;
}

/* Searches for prices that satisfy (fixed point) of >>raised under the loads of
   q. Returns 1 if the search finds a proof. Sets r->end to the reason why the
   search ended. */
static int kern_raise_settle(kern_raise *r, const kern_query *q,
                             kern_begin begin)
{
    const kern_model *m = r->part->m;
    kern_settling settling = {0, 0, 0, 0, 0, 0, 0, 0};
    settling.tolerance = kern_part_load(r->part, q, r->part->dual.load);
    settling.warm = begin == KERN_BEGIN_HERE;
    settling.units = m->task->work->units;
    settling.drift_shown = settling.warm
                             ? kern_raise_displacement(r, r->shown, NULL)
                             : KERN_R(0);
    r->end = kern_model_charge(m, r->placed < 0 ? 3 : 1) ? KERN_END_NONE
                                                         : KERN_END_WORK;
    for (settling.round = 0; r->end == KERN_END_NONE; settling.round++)
        r->end = kern_raise_round(r, q, &settling);
    return r->end == KERN_END_SHOWN;
}

/* ---- questions ---- */

/* Returns the reserve: the largest share in the list below for which the
   structure stays raised under a push to either side. The push is this share of
   gravity, and the kerns are shrunk further by this share of the mean size
   (options.relative: by this share of their travel). A push stands for errors
   of angle, and a shrinkage for errors of place as a share of the size. If
   kerns are not nested, the structure must also stay raised under the push
   without the shrinkage. Shares above `limit` are not tried; a `limit` of 0
   means that all shares are tried. Each search starts at the u and the prices
   of the last share with a proof. */
KERN_SHARED static kern_real kern_raise_reserve(kern_raise *r,
                                                const kern_query *query,
                                                kern_real limit)
{
    static const short share[] = {
        0,  10, 20,  30,  40,  50,  55,  60,
        70, 80, 100, 150, 200, 300, 500, 1000}; /* in units of 1e-4 */
    kern_model *m = r->part->m;
    kern_real range[2];
    const int nested = kern_is_nested(m, range);
    kern_query q = *query;
    int low = (int)(sizeof share / sizeof share[0]) - 1, middle, high;

    /* Finds the largest share for a push to the right. Then tries only shares
       up to that one for a push to the left. */
    while (limit > 0 && KERN_R(share[low]) / 10000 > limit)
        low--;
    kern_copy(r->shown_before, r->part->dual.u, r->unknowns);
    for (q.side = 1; q.side >= -1; q.side -= 2) {
        kern_copy(r->shown, r->shown_before, r->unknowns);

        /* Bisects the list of shares, beginning with the largest share that is
           still possible. */
        for (middle = low, high = low + 1, low = 0; high - low > 1;
             middle = (low + high) / 2) {
            int k, shown = 1;
            q.factor = KERN_R(share[middle]) / 10000;
            kern_copy(r->part->dual.u, r->shown, r->unknowns);
            for (k = nested; k < 2 && shown; k++) {
                q.shrink = query->shrink
                         + (kern_real)k * q.factor
                               * (q.relative ? KERN_R(1) : m->mean_size);
                kern_model_arms(m, &q);
                shown = kern_raise_settle(r, &q, KERN_BEGIN_HERE);
            }
            if (shown)
                kern_copy(r->shown, r->part->dual.u, r->unknowns);
            low = shown ? middle : low;
            high = shown ? high : middle;
        }
    }
    return KERN_R(share[low]) / 10000;
}

/* Begins a search for raised forces. Sets *out to KERN_HANGS, with a proof in
   the model's answer, if nothing holds some of the blocks up and the other
   blocks stand without them. Otherwise sets *out to KERN_NOT_SHOWN, and opens
   all groups as one part for the search. Returns KERN_STANDS, or the status
   with which the call ends. */
static kern_status kern_raise_begin(kern_raise *r, kern_call *c,
                                    kern_raising *out)
{
    kern_model *m = &c->m;
    kern_query *const q = &c->path.q;
    kern_status status = KERN_STANDS;
    kern_real *value;
    int i, hanging;
    r->part = &c->part;
    *out = KERN_NOT_SHOWN;
    value = kern_take_last(&m->rest, m->s->blocks);
    kern_take_last(&m->common, m->s->blocks); /* m->common has the same end as
                                                 m->rest                */
    if (!kern_take_fits(&m->rest))
        return KERN_NO_SPACE;

    /* Finds the blocks that may hang. A verdict on the whole structure is
       needed only if there are any, or for kern_stays(). */
    for (i = 0; i < m->s->blocks; i++)
        value[i] = KERN_R(1);
    hanging = kern_unsupported(m->s, value);
    if (hanging > 0 || r->placed >= 0) {
        kern_known_begin(m, q->shrink);
        status = kern_model_evaluate(m, r->part, q);
    }

    /* The blocks that may hang do so if the other blocks stand without them.
       Writes their motion, a free fall. */
    if (hanging > 0 && status == KERN_STANDS && kern_model_charge(m, 1)) {
        const kern_vec way = kern_vec_unit(m->s->gravity);
        q->fallen = value;
        kern_model_group(m, q);
        if (m->graph.groups == 0
            || kern_model_evaluate(m, r->part, q) == KERN_STANDS)
            *out = KERN_HANGS;
        q->fallen = NULL;
        kern_zero(m->answer.motion, 3 * m->s->blocks);
        for (i = 0; i < m->s->blocks; i++)
            kern_copy(m->answer.motion + i, &way, 2 * (value[i] >= 0));
    }
    if (status != KERN_STANDS || *out == KERN_HANGS)
        return status;

    /* Opens the model of all groups again, without a linear program. */
    if (hanging > 0 || m->whole)
        kern_model_group(m, q);
    kern_model_set(m, q);
    return kern_raise_open(r, m) ? KERN_STANDS : KERN_NO_SPACE;
}

/* Raises a load in steps from 0 to `limit`. *share is the field of q that holds
   the factor of this load. The search at each step starts at a u and prices
   that are extrapolated from the last two steps. A step that fails is repeated
   with a smaller increase of the load. The steps end when the increase would be
   too small a share of the largest factor with a proof (KERN_LOAD_NARROW). A
   `limit` of KERN_FACTOR_MOST or more means that no limit is known: the first
   goal is then a factor of 1, and each goal that is reached is doubled. Returns
   the largest factor with a proof, or -1 if there is none even at a factor of
   0. */
static kern_real kern_raise_climb(kern_raise *r, const kern_query *q,
                                  kern_real *share, kern_real limit)
{
    kern_real end = limit < KERN_FACTOR_MOST ? limit : KERN_R(1);
    kern_real proven = *share = KERN_R(0), taken = KERN_R(1),
              *u = r->part->dual.u;
    kern_real step = end / KERN_LOAD_STEPS;
    int i, shown = 1;

    /* Finds u and the prices at a factor of 0. */
    if (!kern_raise_settle(r, q, KERN_BEGIN_UNLOADED))
        return KERN_R(-1);
    kern_copy(r->shown, u, r->unknowns);
    while (proven < end
           && step >= KERN_LOAD_NARROW * kern_max(proven, end / 100)) {
        *share = proven + KERN_R(1.01) * step < end ? proven + step : end;

        /* Extrapolates u and the prices from the last two loads with a proof. A
           price is never negative. */
        for (i = 0; i < r->unknowns; i++) {
            if (shown) {
                r->shown_before[i] = r->shown[i];
                r->shown[i] = u[i];
            }
            u[i] = r->shown[i]
                 + (*share - proven) / taken
                       * (r->shown[i] - r->shown_before[i]);
            if (u + i >= r->part->dual.price)
                u[i] = kern_max(u[i], 0);
        }

        /* Searches for a proof at the new load. If there is none, the next
           increase is smaller. */
        shown = kern_raise_settle(r, q, KERN_BEGIN_HERE)
             || (!(proven > 0) /* u is known only for a factor of 0 */
                 && kern_raise_settle(r, q, KERN_BEGIN_UNLOADED));
        if (shown) {
            taken = *share - proven;
            proven = *share;
        } else
            step /= KERN_LOAD_FINER;

        /* Doubles a goal that was only a guess, when it has been reached. */
        if (!(proven < end) && end < limit) {
            end = kern_min(2 * end, limit);
            step = end / KERN_LOAD_STEPS;
        }
    }
    return proven;
}

/* Sets *out to KERN_RAISED if the load raises forces that hold the structure,
   either when it acts at once or when the loads of the blocks grow from 0. If
   `sag` is not NULL, writes to it the displacement of block r->placed for a
   mean weight of 1 and the stiffnesses that kern_raise_open() sets. A turn
   counts as turn times half the size of the block. Returns the verdict on the
   structure. */
static kern_status kern_raise_show(kern_raise *r, kern_call *c,
                                   kern_raising *out, kern_real *sag)
{
    kern_query growing = c->path.q;
    const kern_status status = kern_raise_begin(r, c, out);
    if (status != KERN_STANDS || *out == KERN_HANGS)
        return status;
    if (kern_raise_settle(r, &c->path.q, KERN_BEGIN_UNLOADED)
        || (kern_model_loaded(&c->m)
            && kern_raise_climb(r, &growing, &growing.loads, KERN_R(1)) >= 1))
        *out = KERN_RAISED;
    if (sag) {
        const kern_graph *graph = &c->m.graph;
        const kern_real *u = r->part->dual.u
                           + 3 * graph->local[graph->group[r->placed]];
        *sag = (kern_real)graph->groups
             * (kern_abs(u[2]) / 2
                + kern_vec_length(kern_vec_make(u[0], u[1])));
    }
    return *out == KERN_RAISED || sag
             ? status
             : kern_model_evaluate(&c->m, r->part, &c->path.q);
}

/* Computes the results of kern_raised(). If `sag` is not NULL, computes those
   that kern_stays() needs: only the blocks near block i are then free, and *sag
   is the displacement of block i. */
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

    /* Runs the search and writes its proof: the forces, and the motion if there
       is one. */
    r.placed = i;
    r.proof = NULL;
    r.end = KERN_END_NONE;
    if (sag)
        kern_model_know(&c.m, &task->known);
    status = kern_raise_show(&r, &c, &raising, sag);
    kern_proof_write(&c.m, proof, status);
    if (raising != KERN_NOT_SHOWN)
        kern_proof_write(&c.m, proof, KERN_FALLS);
    task->work->end = raising == KERN_NOT_SHOWN ? r.end : KERN_END_SHOWN;

    /* Finds the reserve: the largest push that the structure bears in addition
       to its load. */
    if (raising == KERN_RAISED && reserve)
        share = kern_raise_reserve(
            &r, &c.path.q, sag ? KERN_STAYS_MOST : task->options.reserve);
    status = kern_call_status(task, status);
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

KERN_API kern_status kern_let_go(const kern_task *task, kern_raising *how,
                                 const kern_proof *proof)
{
    kern_raising raising = KERN_NOT_SHOWN;
    kern_status status = kern_raise_task(task, KERN_R(0), &raising, NULL, proof,
                                         KERN_OUT, NULL);
    if (status == KERN_STANDS && raising != KERN_RAISED)
        status = raising == KERN_HANGS ? KERN_FALLS : KERN_UNDECIDED;
    if (how)
        *how = raising;
    return status;
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
    kern_real limit = KERN_R(-1), proven = limit;
    kern_call c;
    kern_raise r;
    kern_status status = kern_run(&c, task, shrink, KERN_PATH_LOAD, pattern,
                                  side, factor ? &limit : NULL, proof);

    /* Raises the load from 0 to the load factor, which is an upper bound. The
       proof of the raised load overwrites that of the load factor in the
       caller's arrays. The search for the load factor left a part open, so the
       model is opened again. That cannot fail, since the work memory is the
       same. */
    if (status == KERN_STANDS) {
        kern_query *q = &c.path.q;
        kern_raising hung;
        kern_model_open(&c.m, task, q);
        r.placed = KERN_OUT;
        r.proof = proof;
        r.end = KERN_END_NONE;
        status = kern_raise_begin(&r, &c, &hung);
        if (hung == KERN_HANGS)
            status = KERN_UNDECIDED;
        q->factor = limit = kern_min(limit, KERN_FACTOR_MOST);
        kern_model_set(&c.m, q); /* sets the unit of force at the largest load
                                                                             */
        if (status == KERN_STANDS)
            proven = kern_raise_climb(&r, q, &q->factor, limit);
        task->work->end = r.end;
        status = kern_call_status(task, status == KERN_STANDS && proven < 0
                                            ? KERN_UNDECIDED
                                            : status);
    }
    if (status == KERN_STANDS || status == KERN_LIMIT)
        *factor = proven < KERN_FACTOR_MOST ? proven : KERN_INFINITY;
    return status;
}

/* ==== Part VI: Geometry and planning ===================================== */

/* ---- Tolerances of the geometry ----------------------------------- >>tol */
/* A tolerance of length is a share of a length in the input (a gap, the size of
   a block or a coordinate), unless its comment names another unit. */

/* Largest number of runs into which an outline is divided (kern_outline). Each
   run but the last has at least KERN_RUNS / 2 edges. With more runs an outline
   takes more stack, and with fewer runs a search takes more time. */
#define KERN_RUNS 16
/* Default of options.gap, as a share of the size of a pair's smaller free
   block. */
#define KERN_GAP_SHARE KERN_R(1e-3)
/* Least length of a line contact, as a share of the size of a pair's smaller
   free block. */
#define KERN_LINE_LEAST KERN_R(1e-3)
/* Largest change of a block's area, as a share of the area, that may be due to
   rounding at large coordinates. After a larger change the block is stale: its
   vertices have moved. */
#define KERN_AREA_TOL KERN_R(1e-3)
/* Least turn of the outline at a vertex that counts as a corner [rad]. A vertex
   at which the outline turns by half a circle, give or take this angle, is a
   spike. With a much larger value round stones would lose their shape. */
#define KERN_TURN_LEAST KERN_R(1e-6)
/* Least distance of a corner's foot from the ends of the edge that it touches,
   as a share of the size of a pair's smaller free block. Without this distance
   rounding could make contacts between blocks that only meet at their corners,
   such as diagonal neighbours. */
#define KERN_FOOT_INSET KERN_R(1e-6)
/* Least component along gravity of the unit normal of a contact that carries a
   block (options.lone). A contact with a smaller component counts as vertical
   and carries neither of its blocks. */
#define KERN_LEVEL_LEAST KERN_R(1e-6)
/* Default of options.angle [rad]. */
#define KERN_ANGLE KERN_R(0.0174533)
/* Least denominator in the formula for the friction of a widened cone, so that
   this friction is finite. */
#define KERN_CONE_LEAST KERN_R(0.0174533)
/* kern_near(): least gap, as a share of the mean size, and least angle [rad] of
   its options, which also find contacts that a slight rocking motion would
   close. Gaps of 0.03 to 0.1 and angles of 0.1 to 0.2 predict the results of
   shaking tests equally well. */
#define KERN_NEAR_GAP KERN_R(0.04)
#define KERN_NEAR_ANGLE KERN_R(0.15)
/* Measured structures: number of standard errors of place and of angle within
   which contacts are found. With 3.5, a structure of 30 contacts has all of
   them found in 98 % of the cases. */
#define KERN_ERRORS KERN_R(3.5)
/* Measured structures: gap, in units of KERN_ERRORS times e, where e is the
   standard error of place. The gap between a corner and an edge has a variance
   of 2 e^2 from the places of two stones and 3/8 e^2 from their vertices. So
   the standard error of the gap is 1.5 e. */
#define KERN_ERROR_GAP KERN_R(1.5)
/* Measured structures: angle, in units of KERN_ERRORS times theta, where theta
   is the standard error of angle. The angle between two edges of 0.7 sizes has
   a variance of 2 theta^2 from the angles of two stones and 2 theta^2 from the
   ends of the edges. So the standard error of this angle is 2 theta. */
#define KERN_ERROR_ANGLE KERN_R(2)
/* Measured structures: deepest overlap, in standard errors of place. */
#define KERN_ERROR_OVERLAP KERN_R(8.0)
/* Measured structures: largest distance of a corner's foot beyond the end of
   the edge that it touches, in standard errors of place. */
#define KERN_ERROR_EDGE KERN_R(3.0)
/* kern_certain(): least length of a line contact that counts as certain, and
   least distance of a certain point contact from the ends of its edge, both in
   standard errors of place. */
#define KERN_ERROR_SURE KERN_R(3.5)
/* kern_certain(): angle by which it narrows or widens friction cones, in
   standard errors of angle. */
#define KERN_ERROR_CONE KERN_R(3.0)
/* Settling. ROUNDS: most rounds. CLOSED: largest gap of a closed contact, in
   errors of place. The blocks rest if every contact that presses is closed. */
#define KERN_SETTLE_ROUNDS 16
#define KERN_SETTLE_CLOSED KERN_R(1.0)
/* Settling: contact points of equal height are ordered by their arms, then from
   side to side. This share of arm and place is added to the height. */
#define KERN_SETTLE_TIE KERN_PICK(1e-10, 1e-5)
/* kern_certain(), lower end. PARTS: the blocks settle PARTS times, each time
   with every PARTS-th stretch open, beginning with another one. OPEN: gap of
   these stretches, in errors of place. */
#define KERN_LOW_PARTS 2
#define KERN_LOW_OPEN KERN_R(3.0)
/* kern_certain(): its lower end is divided by 1 + LOSS e / mean size. For
   errors e below WIDE mean sizes, LOSS is smaller in proportion to e. */
#define KERN_LOW_LOSS KERN_R(210.0)
#define KERN_LOW_WIDE KERN_R(0.0065)
/* kern_certain(), test of settling. PARTS: as for the lower end. TELLS: blocks
   may settle by this multiple of the largest motion found. MOST: largest such
   distance, as a share of the mean size. */
#define KERN_DOUBT_PARTS 3
#define KERN_DOUBT_TELLS KERN_R(2.0)
#define KERN_DOUBT_MOST KERN_R(0.6)
/* kern_certain(), blocks that rock. LACK: factor of safety of a gap that a
   stretch hides. PLACES: parts of a stretch in which a bump is sought. BUMP:
   twice the least height of a bump, in errors of place. STEEP: contacts that
   press a block up by a smaller share are sides, not beds. */
#define KERN_ROCK_LACK KERN_R(1.25)
#define KERN_ROCK_PLACES 16
#define KERN_ROCK_BUMP KERN_R(0.6)
#define KERN_ROCK_STEEP KERN_R(0.5)
/* The middle of an overlap must lie inside each of the two blocks, at a depth
   of at least this share of the overlap. The depth is half of the overlap where
   both blocks are thick, and smaller where one block is thin. */
#define KERN_THIN KERN_R(0.25)
/* Largest angle that kern_measured_options() sets, as a share of
   KERN_ANGLE_MOST. */
#define KERN_ANGLE_SHARE KERN_R(0.99)
/* Sine of 10 degrees. If a point lies on a line contact of the same pair and
   their normals differ by a smaller angle, the point is removed, since the line
   already covers it. At a corner the normals differ by more. */
#define KERN_SAME_FACE KERN_R(0.17364817766693036)
/* The search for overlaps moves along each edge in strides. The first stride is
   the greatest depth found so far (at first the largest overlap that is
   allowed) divided by KERN_STRIDES. Each stride is longer than the one before
   by the factor 1 + 1 / KERN_STRIDES. The depth that the search finds may be
   too small by one stride. Shorter strides take more time. */
#define KERN_STRIDES 32
/* Search for overlaps: most triangles in one pass whose centroids are tried as
   inner points of a block. In each pass the indices of a triangle's vertices
   have another distance. */
#define KERN_TRIANGLES 32
/* Number of steps of a search for contacts that count as one unit of work. A
   step takes at most 80 instructions. */
#define KERN_SEARCH_UNIT 24
/* Number of steps that the search for contacts charges for each pair of edges
   that are close to each other. */
#define KERN_SEARCH_NEAR 8
/* Simplified outlines: two vertices count as equally far from an edge if their
   squared distances differ by less than this share. On a grid of pixels many
   vertices are equally far except for rounding. */
#define KERN_EQUALLY_FAR KERN_PICK(1e-6, 1e-5)
/* Simplified outlines: number of tolerances that are tried before the tolerance
   0. Each is half of the one before, and is tried if the outline that the one
   before gives is no simple polygon. */
#define KERN_HALVINGS 8

/* ---- coming to rest ---- */

/* MOTIONS: largest number of motions of a stone on its way to rest. Only stones
   that roll take more motions. TOUCHES: largest number of touches that are
   stored at a time. */
#define KERN_REST_MOTIONS 64
#define KERN_REST_TOUCHES 24
/* TOUCH: largest distance between two outlines that counts as a touch, as a
   share of the stone's size. END: length by which an edge is extended at each
   end, as a share of the largest distance of a touch. */
#define KERN_REST_TOUCH KERN_PICK(1e-7, 1e-4)
#define KERN_REST_END KERN_R(0.01)
/* Sine of the largest angle that counts as 0, between a motion and one of
   these: an edge that lies ahead, an edge that the stone touches, the
   horizontal. */
#define KERN_REST_LEVEL KERN_PICK(1e-10, 1e-5)
/* Tangent of half the largest turn of one motion. With smaller turns the stone
   comes to rest at better places, and each motion meets fewer edges. */
#define KERN_REST_TURN KERN_R(0.25)
/* Least friction for a turn while the stone slides at two touches. When such a
   turn begins, both touches open at the angle of friction. Without friction the
   touches would not open, and rounding could block the turn. With less friction
   than this value the stone creeps, since each turn soon closes a touch
   again. */
#define KERN_REST_SLIP KERN_R(0.01)
/* kern_place_compare(). STAYS: least chance of staying that counts as equal to
   1. SAME: largest difference between a margin and the margin without the stone
   that counts as 0, as a share of the latter. SPLIT: factor that rounds a
   number to 13 bits (Dekker's split). */
#define KERN_PLACE_STAYS KERN_R(0.9)
#define KERN_PLACE_SAME KERN_PICK(1e-4, 1e-3)
#define KERN_PLACE_SPLIT KERN_PICK(1099511627777.0, 2049)

/* ---- Polygons ------------------------------------------------- >>polygon */
/* The vertices of a polygon are in the caller's order. If this order is
   clockwise, the area is negative. A vertex at which the outline turns by less
   than KERN_TURN_LEAST is no corner. */

/* Returns the vertex after i in the caller's order. */
static int kern_polygon_next(const kern_block *block, int i)
{
    return i + 1 < block->vertices ? i + 1 : 0;
}

/* Returns the vertex before i in the caller's order. */
static int kern_polygon_previous(const kern_block *block, int i)
{
    return (i > 0 ? i : block->vertices) - 1;
}

/* Returns the kind of vertex i: 1 if it is convex, -1 if it is reflex, 0 if the
   outline hardly turns there, and -2 if it is a spike or repeats its
   neighbour. */
static inline int kern_polygon_turn(const kern_block *block, int i)
{
    const kern_vec *v = block->vertex;
    const kern_vec edge_in = kern_vec_sub(v[i],
                                          v[kern_polygon_previous(block, i)]);
    const kern_vec edge_out = kern_vec_sub(v[kern_polygon_next(block, i)],
                                           v[i]);
    const kern_real turn = kern_vec_cross(edge_in, edge_out);
    const kern_real cross_min = KERN_TURN_LEAST
                              * kern_vec_dot(edge_in, edge_out);
    if (kern_abs(turn) < cross_min)
        return 0;
    if (kern_abs(turn) <= -cross_min)
        return -2;
    return (turn > 0) == (block->area >= 0) ? 1 : -1;
}

/* Returns 1 if two boxes are no farther apart than the gap, in x and in y. For
   a negative gap, returns 1 if they overlap by at least its magnitude. */
static int kern_boxes_meet(const kern_box *a, const kern_box *b, kern_real gap)
{
    return b->low.y - gap <= a->high.y && a->low.y - gap <= b->high.y
        && b->low.x - gap <= a->high.x && a->low.x - gap <= b->high.x;
}

/* Returns the largest magnitude of the coordinates of a box. */
static kern_real kern_box_largest(const kern_box *box)
{
    return kern_max(kern_vec_largest(box->low), kern_vec_largest(box->high));
}

/* ---- outlines ---- */

/* A block's outline, divided into runs of `run_vertices` vertices. The box of a
   run contains the edges that start at its vertices; an edge goes from one
   corner to the next. An outline of at most KERN_RUNS vertices is a single
   run. */
typedef struct kern_outline {
    const kern_block *block;
    int straight, reflex; /* straight: nonzero if the outline hardly turns at
                             some vertex. reflex: nonzero if some vertex is
                             reflex or a spike                             */
    int run_vertices;     /* number of vertices of a run                   */
    int visits;           /* number of vertices and runs that were read, but
                             are not charged yet                           */
    kern_box box[KERN_RUNS];
} kern_outline;

/* Returns the first corner after vertex i in the caller's order. A closed
   outline always has corners. */
static int kern_outline_corner(const kern_outline *o, int i)
{
    do
        i = kern_polygon_next(o->block, i);
    while (o->straight && kern_polygon_turn(o->block, i) == 0);
    return i;
}

/* Finds which kinds of vertices a block's outline has, and sets the boxes of
   its runs. */
static void kern_outline_set(kern_outline *o, const kern_block *block)
{
    const int n = block->vertices;
    int i;
    o->block = block;
    o->straight = o->reflex = 0;
    o->visits = n;
    for (i = 0; i < n; i++) {
        const int turn = kern_polygon_turn(block, i);
        o->straight |= turn == 0;
        o->reflex |= turn < 0;
    }
    o->run_vertices = n > KERN_RUNS ? n / KERN_RUNS + KERN_RUNS / 2 : n;
    o->box[0] = block->box;
    for (i = 0; n > KERN_RUNS && i < n; i++) {
        kern_box *box = &o->box[i / o->run_vertices];
        const int end = kern_polygon_next(block, i);
        if (i % o->run_vertices == 0)
            box->low = box->high = block->vertex[i];
        kern_box_add(box, block->vertex[end]);
        if (end % o->run_vertices == 0)
            kern_box_add(box, block->vertex[kern_outline_corner(o, i)]);
    }
}

/* ---- edges ---- */

/* The segment from one corner of a block to another: an edge or a chord. It
   runs counter-clockwise, so the block is on the left of an edge. */
typedef struct kern_edge {
    int corner;       /* index of the corner that is first in the caller's
                         order                                            */
    int start, end;   /* indices of the corners, counter-clockwise        */
    kern_vec p, q, d; /* places of start and end; unit direction          */
    kern_real length;
    kern_box box; /* box around the edge; kern_edge_set() does not set it */
} kern_edge;

/* Sets *e to the edge from vertex `corner` to vertex `next`, which follows in
   the caller's order. */
static inline void kern_edge_set(kern_edge *e, const kern_block *block,
                                 int corner, int next)
{
    e->corner = corner;
    e->start = block->area < 0 ? next : corner;
    e->end = block->area < 0 ? corner : next;
    e->p = block->vertex[e->start];
    e->q = block->vertex[e->end];
    e->d = kern_vec_sub(e->q, e->p);
    e->length = kern_vec_length(e->d);
    e->d = kern_vec_scale(e->d, 1 / e->length);
}

/* Returns the signed distance, along the line of e, from the start of e to the
   foot of the perpendicular from p. */
static kern_real kern_edge_foot(const kern_edge *e, kern_vec p)
{
    return kern_vec_dot(kern_vec_sub(p, e->p), e->d);
}

/* Finds the next edge of the outline whose own box is within the gap of `box`.
   Begins after vertex e->corner; for the first call set e->corner to -1.
   Returns 0 if there is no such edge. */
static int kern_edge_next(kern_edge *e, kern_outline *o, const kern_box *box,
                          kern_real gap)
{
    const kern_block *block = o->block;
    int i;
    for (i = e->corner + 1; i < block->vertices; i++, o->visits++)
        if (o->run_vertices < block->vertices && i % o->run_vertices == 0
            && !kern_boxes_meet(&o->box[i / o->run_vertices], box, gap)) {
            i += o->run_vertices - 1;
        } else if (!o->straight || kern_polygon_turn(block, i) != 0) {
            const int corner = kern_outline_corner(o, i);
            kern_box edge_box = {block->vertex[i], block->vertex[i]};
            kern_box_add(&edge_box, block->vertex[corner]);
            if (kern_boxes_meet(&edge_box, box, gap)) {
                kern_edge_set(e, block, i, corner);
                e->box = edge_box;
                return 1;
            }
        }
    return 0;
}

/* ---- places ---- */

/* Returns the squared distance of the origin from the segment u v, which may be
   a point. */
static kern_real kern_edge_square(kern_vec u, kern_vec v)
{
    const kern_vec d = kern_vec_sub(v, u);
    const kern_real whole = kern_vec_dot(d, d);
    const kern_real foot = kern_min(kern_max(-kern_vec_dot(u, d), KERN_R(0)),
                                    whole);
    const kern_real share = whole > 0 ? foot / whole : KERN_R(0);
    const kern_vec r = kern_vec_step(u, share, d);
    return kern_vec_dot(r, r);
}

/* Returns the distance of p from the boundary of the block, negative if p is
   outside. Writes the first vertex of the nearest edge to *nearest. On entry
   *nearest must be the index of any vertex; a good guess saves time. */
static kern_real kern_polygon_depth(kern_outline *o, kern_vec p, int *nearest)
{
    const kern_block *block = o->block;
    const kern_vec *vertex = block->vertex;
    const int n = block->vertices;
    kern_vec u = kern_vec_sub(vertex[*nearest], p);
    kern_real closest = kern_edge_square(
        u, kern_vec_sub(vertex[kern_polygon_next(block, *nearest)], p));
    int i, start, end, inside = 0;

    u = kern_vec_sub(vertex[0], p);
    for (start = 0; start < n; start = end) {
        /* Skips a run that is farther away than the nearest edge so far. The
           two ends of such a run decide whether it crosses the level of p an
           odd number of times. */
        const kern_box *box = &o->box[start / o->run_vertices];
        const kern_real x = kern_min(kern_max(p.x, box->low.x), box->high.x);
        const kern_real y = kern_min(kern_max(p.y, box->low.y), box->high.y);
        const kern_vec way = kern_vec_sub(p, kern_vec_make(x, y));
        const int skip = /* 0.999 allows for rounding */
            KERN_R(0.999) * kern_vec_dot(way, way) > closest;
        end = n - start > o->run_vertices ? start + o->run_vertices : n;
        o->visits += 1 + (skip ? 0 : end - start);

        /* p is inside if the outline to the right of p crosses the level of p
           an odd number of times. */
        for (i = skip ? end - 1 : start; i < end; i++) {
            const kern_vec v = kern_vec_sub(vertex[kern_polygon_next(block, i)],
                                            p);
            const kern_real square = skip ? closest : kern_edge_square(u, v);
            if (square < closest) {
                closest = square;
                *nearest = i;
            }
            if ((u.y > 0) != (v.y > 0)
                && (skip ? box->low.x > p.x
                         : (kern_vec_cross(u, v) > 0) == (v.y > u.y)))
                inside = !inside;
            u = v;
        }
    }
    closest = KERN_SQRT(closest);
    return inside ? closest : -closest;
}

/* Returns 1 if f lies on one side of the line of e and does not touch this
   line. Does not use e->d, since rounding changes its direction. */
static int kern_one_side(const kern_edge *e, const kern_edge *f)
{
    const kern_vec d = kern_vec_sub(e->q, e->p);
    const kern_real side_p = kern_vec_cross(d, kern_vec_sub(f->p, e->p));
    const kern_real side_q = kern_vec_cross(d, kern_vec_sub(f->q, e->p));
    return (side_p > 0 && side_q > 0) || (side_p < 0 && side_q < 0);
}

/* ---- what a polygon must be ---- */

/* Returns the first vertex of the first edge that turns back on its predecessor
   or touches an edge that is not its neighbour. Returns -1 if there is no such
   edge. Two edges whose boxes meet touch each other, unless one of them lies on
   one side of the line of the other. An outline that turns only one way and has
   only one local minimum of height is convex and needs no search. */
static int kern_polygon_crossing(const kern_block *block)
{
    const kern_vec *v = block->vertex;
    kern_outline o;
    kern_edge e, f;
    int i, lowest = 0;
    for (i = 0; i < block->vertices; i++)
        lowest += v[kern_polygon_next(block, i)].y > v[i].y
               && v[kern_polygon_previous(block, i)].y >= v[i].y;
    kern_outline_set(&o, block);
    if (!o.reflex && lowest < 2)
        return -1;
    o.straight = 0; /* edges then go from vertex to vertex: faster */
    e.corner = -1;
    while (kern_edge_next(&e, &o, &block->box, 0)) {
        int touch = kern_polygon_turn(block, e.corner) == -2;
        f = e;
        while (!touch && kern_edge_next(&f, &o, &e.box, 0))
            touch = f.start != e.end && f.end != e.start
                 && !kern_one_side(&e, &f) && !kern_one_side(&f, &e);
        if (touch)
            return e.corner;
    }
    return -1;
}

/* Writes the area, centre and box of a block. Sums over the triangles between
   vertex 0 and the edges, so that a polygon far from the origin loses no
   digits. Returns the sum of the unsigned areas of the triangles. */
static inline kern_real kern_polygon_area(kern_block *block)
{
    const kern_vec o = block->vertex[0];
    kern_vec u = kern_vec_make(KERN_R(0), KERN_R(0));
    kern_vec moment = u; /* first moment of area about vertex 0 */
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

/* Writes the area, centre and box of a block. Returns KERN_OK, or a status that
   names the fault of the polygon. */
static kern_status kern_polygon_measure(kern_block *block, kern_fault *fault)
{
    kern_real spread, area_min;
    for (fault->index = 0; fault->index < block->vertices; fault->index++)
        if (!kern_vec_is_moderate(block->vertex[fault->index]))
            return KERN_BAD_NUMBER;
    spread = kern_polygon_area(block);
    area_min = 2 * KERN_ROUNDING * kern_box_largest(&block->box)
             * kern_vec_largest(kern_vec_sub(block->box.high, block->box.low));
    area_min = kern_max(area_min, 1 / (KERN_FAR * KERN_FAR));
    /* If `spread` is not above area_min, all vertices are on one line, and the
       polygon has no area. */
    fault->index = spread > area_min ? kern_polygon_crossing(block) : -1;
    return fault->index >= 0                ? KERN_CROSSING
         : kern_abs(block->area) > area_min ? KERN_OK
                                            : KERN_NO_AREA;
}

/* Checks the pointer and the length of an array of n vertices, but not its
   contents. Returns KERN_OK, or a status that names the fault. */
KERN_SHARED static kern_status kern_vertices_check(const kern_vec *v, int n)
{
    return n < 0 || n > KERN_POINTS_MOST ? KERN_BAD_COUNT
         : n < 3                         ? KERN_FEW_VERTICES
         : v                             ? KERN_OK
                                         : KERN_BAD_POINTER;
}

/* Returns a fixed block with these vertices. Area, centre and box are not
   set. */
static kern_block kern_ground_of(const kern_vec *vertex, int vertices)
{
    const kern_block made = {vertex,           vertices, 1,      0,
                             {{0, 0}, {0, 0}}, 0,        {0, 0}, {0, 0, 0}};
    return made;
}

/* If the polygon has a fault, marks the block so that every other call refuses
   it. */
KERN_API kern_status kern_ground_init(kern_block *block, const kern_vec *vertex,
                                      int vertices, kern_fault *fault)
{
    kern_fault ignored;
    kern_status status = kern_vertices_check(vertex, vertices);
    /* cppcheck-suppress uninitvar ; only the address is taken here */
    fault = fault ? fault : &ignored;
    kern_fault_clear(fault);
    if (!block)
        return status == KERN_OK ? KERN_BAD_POINTER : status;
    *block = kern_ground_of(vertex, vertices);
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

KERN_API void kern_block_load(kern_block *block, kern_vec force, kern_vec point,
                              kern_real torque)
{
    const kern_vec arm = kern_vec_sub(point, block->centre);
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

/* ---- simplified outlines ---- */

/* Returns the vertex that is farthest from the segment p q, among the vertices
   after `start` and up to `end`. Returns -1 if none is farther away than the
   tolerance. If start equals end, searches all vertices. Of vertices that are
   equally far it returns the lowest, and of these the leftmost, so that the
   result does not depend on where the outline begins. */
KERN_SHARED static int kern_outline_farthest(const kern_block *block, int start,
                                             int end, kern_vec p, kern_vec q,
                                             kern_real tolerance)
{
    const kern_vec *v = block->vertex;
    kern_real largest = tolerance * tolerance;
    int i = start, found = -1;
    do {
        kern_real square;
        int lower;
        i = kern_polygon_next(block, i);
        square = kern_edge_square(kern_vec_sub(p, v[i]), kern_vec_sub(q, v[i]));
        lower = found >= 0
             && (v[i].y < v[found].y
                 || (!(v[i].y > v[found].y) && v[i].x < v[found].x));
        if (square
            > (lower ? 1 - KERN_EQUALLY_FAR : 1 + KERN_EQUALLY_FAR) * largest) {
            largest = square;
            found = i;
        }
    } while (i != end);
    return found;
}

/* Writes to out[0..room) the vertices that stay in the simplified outline, and
   their indices to `kept`. Returns the number of these vertices, KERN_NO_SPACE,
   or KERN_NO_AREA if all vertices are at one place.
   Some vertices are found to stay before the vertices in front of them are
   finished. Their indices wait at the end of `kept`, and the one that is needed
   next is the first of these. Since each of them is written later, `room` is
   too small if the written and the waiting indices meet. */
static int kern_outline_reduce(const kern_block *block, kern_real tolerance,
                               kern_vec *out, int *kept, int room)
{
    const kern_vec *v = block->vertex, c = block->centre;
    const int anchor = kern_outline_farthest(block, 0, 0, c, c, KERN_R(0));
    int corner = anchor, waiting = room, count = 0;
    KERN_ASSERT(tolerance >= 0 && block->vertices > 0);
    if (anchor < 0)
        return (int)KERN_NO_AREA;
    while (count < waiting) {
        const int end = waiting < room ? kept[waiting] : anchor;
        const int split = kern_outline_farthest(block, corner, end, v[corner],
                                                v[end], tolerance);

        /* Divides the edge from `corner` to `end` if it would leave out a
           vertex that is too far away. This vertex stays, and becomes `end`. */
        if (split >= 0) {
            kept[--waiting] = split;
            continue;
        }

        /* Otherwise writes `corner`. The next edge begins at `end`. */
        kept[count] = corner;
        out[count++] = v[corner];
        if (waiting++ == room)
            return count;
        corner = end;
    }
    return (int)KERN_NO_SPACE;
}

KERN_API int kern_outline_simplify(const kern_vec *vertex, int vertices,
                                   kern_real tolerance, kern_vec *out,
                                   int *kept, int room)
{
    /* The outline as it is given may cross itself. */
    kern_block raw = kern_ground_of(vertex, vertices);
    kern_block made;
    kern_status status = kern_vertices_check(vertex, vertices);
    int tries, count;

    if (status != KERN_OK)
        return (int)status;
    if (!out || !kept)
        return (int)KERN_BAD_POINTER;
    if (!(tolerance >= 0 && tolerance <= KERN_FAR))
        return (int)KERN_BAD_OPTION;
    if (!kern_is_finite(kern_polygon_area(&raw))
        || kern_box_largest(&raw.box) > KERN_FAR)
        return (int)KERN_BAD_NUMBER;

    /* Halves the tolerance as long as the simplified edges cross or enclose no
       area. */
    for (tries = KERN_HALVINGS; tries >= 0; tries--, tolerance /= 2) {
        count = kern_outline_reduce(&raw, tries ? tolerance : KERN_R(0), out,
                                    kept, room);
        if (count < 0)
            return count;
        status = kern_ground_init(&made, out, count, NULL);
        if (status == KERN_OK)
            return count;
    }
    return (int)status;
}

/* ---- Contacts ------------------------------------------------- >>contact */
/*      line               point              corner in a corner
          ___________             \  b  /         | b
         |     b     |             \   /          |____
      ___o___________o___      _____\ /_____        a  |  two normals
         |     a         |       a   o              ___|  at one place

   For each pair of blocks whose boxes are within the gap, kern_search_pair()
   takes these steps, by the rules in >>rules:
   1. Overlap: a pair that overlaps too deeply ends the search for contacts
      (kern_overlap_depth()).
   2. Edges make lines (kern_pair_line()) and points (kern_pair_point()).
   3. Faces: contacts on one line are merged (kern_pair_face()).
   4. Travels of points are set (kern_point_travels()).
   At the end of the search each line becomes two contact points. */

/* ---- the pair ---- */

/* Two blocks, their tolerances, and the caller's array with the contacts of all
   pairs so far. During the search a line is a single contact in that array: its
   p is the middle of the line, and its travel is half the length of the
   line. */
typedef struct kern_pair {
    int a, b;              /* indices of the blocks, a < b                  */
    kern_real gap;         /* widest gap [m] without errors of angle        */
    kern_real swing;       /* gap that errors of angle cause, per distance
                              from the centre of a block [1]                */
    kern_real overlap_max; /* deepest overlap that is a contact [m]         */
    kern_real reach;       /* upper bound of all gaps and overlaps [m]      */
    kern_real length_min;  /* least length of a line [m]                    */
    kern_real inset;       /* least distance of a corner's foot from the ends
                              of an edge [m], against rounding              */
    kern_real sure_inset;  /* added to inset for errors of place [m]; also a
                              least length of a line; below 0: the foot may
                              be beyond an end                              */
    kern_real hollow;      /* widest hollow inside a face [m]               */
    kern_real sine;        /* sine of options->angle                        */
    const kern_options *options;
    kern_work *work;
    int steps; /* number of steps since the last charged unit of work */
    kern_contact *out;
    int room, count;         /* length of `out`; number of contacts found,
                                of which only the first `room` are stored */
    int first_contact;       /* index of the first contact of this pair   */
    kern_outline outline[2]; /* outlines of blocks a and b                */
} kern_pair;

/* Charges the steps that a search is about to take, and the vertices that it
   has read since the last call. Returns 0 if the work exceeds the limit. All
   later calls then return 0, too, so that every loop of the search ends. */
static int kern_pair_spend(kern_pair *pair, int steps)
{
    pair->steps += steps + pair->outline[0].visits + pair->outline[1].visits;
    pair->outline[0].visits = pair->outline[1].visits = 0;
    if (pair->steps >= KERN_SEARCH_UNIT
        && kern_spend(pair->work, pair->options->limit,
                      pair->steps / KERN_SEARCH_UNIT))
        pair->steps %= KERN_SEARCH_UNIT;
    return pair->steps < KERN_SEARCH_UNIT;
}

/* ---- overlap ---- */
/* The search moves along the edges of one block and computes the depth of
   points inside the other block. Between two points this depth changes by at
   most their distance. So the search can step over all points that cannot be
   deeper than the deepest one so far. */

/* Returns the largest signed distance of the vertices of b from the line of
   edge e. Distances are positive to the left of e (side = 1) or to the right
   (side = -1). Stops at the first vertex that is farther away than `limit`, and
   returns the distance of that vertex. */
static kern_real kern_overlap_side(kern_pair *pair, const kern_edge *e,
                                   const kern_block *b, kern_real side,
                                   kern_real limit)
{
    const kern_vec d = kern_vec_scale(e->d, side);
    kern_real reach = -KERN_INFINITY;
    int k;
    for (k = 0; k < b->vertices && reach <= limit; k++)
        reach = kern_max(reach,
                         kern_vec_cross(d, kern_vec_sub(b->vertex[k], e->p)));
    pair->steps += k / 4;
    return reach;
}

/* Returns the distance of the nearer end of f from the line of e if f crosses
   this line. Returns a negative number if both ends of f are on the same side
   of the line. */
static kern_real kern_edge_crossing(const kern_edge *e, const kern_edge *f)
{
    const kern_real p = kern_vec_cross(e->d, kern_vec_sub(f->p, e->p));
    const kern_real q = kern_vec_cross(e->d, kern_vec_sub(f->q, e->p));
    return kern_max(kern_min(p, -q), kern_min(-p, q));
}

/* Raises *deepest to the greatest depth of the boundary of block a (side = 0)
   or b (side = 1) inside the other block. Two edges that cross, as those of
   thin blocks, also raise *deepest: to the shortest motion after which they no
   longer cross. The true depth may be larger by one stride. Stops when *deepest
   is above `limit`. Strides grow from step to step, since equal strides would
   be too many if the gap is close to rounding. */
static void kern_overlap_boundary(kern_pair *pair, int side, kern_real limit,
                                  kern_real *deepest)
{
    kern_outline *a = &pair->outline[side], *b = &pair->outline[!side];
    kern_edge e, f;
    int nearest = 0;
    e.corner = -1;
    while (kern_edge_next(&e, a, &b->block->box, -*deepest)) {
        kern_real s, step, low, stride = *deepest / KERN_STRIDES;
        f.corner = -1;
        while (kern_pair_spend(pair, 1)
               && kern_edge_next(&f, b, &e.box, -*deepest))
            *deepest = kern_max(*deepest, kern_min(kern_edge_crossing(&e, &f),
                                                   kern_edge_crossing(&f, &e)));
        for (s = 0; s < e.length && kern_pair_spend(pair, 1); s += step) {
            const kern_vec point = kern_vec_step(e.p, s, e.d);
            const kern_real depth = kern_polygon_depth(b, point, &nearest);
            *deepest = kern_max(*deepest, depth);
            if (*deepest > limit)
                return;
            /* Steps as far as the points stay within *deepest of the nearest
               edge, so that none of them can be deeper. */
            kern_edge_set(&f, b->block, nearest,
                          kern_polygon_next(b->block, nearest));
            low = KERN_R(0);
            step = e.length - s;
            kern_clip(&low, &step, kern_edge_foot(&f, point),
                      kern_vec_dot(e.d, f.d), KERN_R(0), f.length);
            kern_clip(&low, &step,
                      kern_vec_cross(kern_vec_sub(point, f.p), f.d),
                      kern_vec_cross(e.d, f.d), -*deepest, *deepest);
            step = kern_max(low > 0 ? KERN_R(0) : step,
                            *deepest - depth + stride);
            stride += stride / KERN_STRIDES;
        }
    }
}

/* Raises *deepest to the depth of inner points of block a (side = 0) or b (side
   = 1) inside the other block. The points are centroids of triangles of
   vertices, at first of vertices far apart. A point whose depth inside its own
   block is more than twice *deepest ends the search. The boundary of the other
   block is nowhere deeper than *deepest, so it passes no closer to that point
   than *deepest, and the points around are all inside the other block or all
   outside. */
static void kern_overlap_middles(kern_pair *pair, int side, kern_real *deepest)
{
    kern_outline *a = &pair->outline[side], *b = &pair->outline[!side];
    const kern_vec *vertex = a->block->vertex;
    const int n = a->block->vertices;
    int step, i, near_a = 0, near_b = 0;
    for (step = n / 3; step > 0; step /= 2)
        for (i = 0; i < n && kern_pair_spend(pair, 1);
             i += 1 + n / KERN_TRIANGLES) {
            const kern_vec sum = kern_vec_add(
                kern_vec_add(vertex[i], vertex[(i + step) % n]),
                vertex[(i + 2 * step) % n]);
            const kern_vec point = kern_vec_scale(sum, KERN_R(1) / 3);
            const kern_real depth = kern_polygon_depth(a, point, &near_a);
            if (depth > *deepest)
                *deepest = kern_max(
                    *deepest,
                    kern_min(depth, kern_polygon_depth(b, point, &near_b)));
            if (depth > 2 * *deepest)
                return;
        }
}

/* Returns the length of the shortest motion that separates two convex blocks.
   It is the least distance, over all edges of both blocks, by which the other
   block reaches over the line of an edge to its inner side. If the line of some
   edge separates the blocks, convex or not, the result is at most
   pair->overlap_max / 2. */
static kern_real kern_overlap_parting(kern_pair *pair)
{
    const kern_real limit = pair->overlap_max / 2;
    kern_real parting = KERN_INFINITY;
    kern_edge e;
    int i, k;
    for (i = 1; i >= 0; i--) {
        const kern_outline *o = &pair->outline[i];
        const kern_block *block = o->block, *partner = pair->outline[!i].block;
        for (k = 0; k < block->vertices && kern_pair_spend(pair, 1); k++) {
            kern_real reach;
            kern_edge_set(&e, block, k, kern_polygon_next(block, k));
            reach = kern_overlap_side(pair, &e, partner, 1,
                                      kern_max(parting, limit));
            if (reach > limit)
                parting = kern_min(parting, reach);
            else if (o->reflex + o->straight == 0 /* convex */
                     || kern_overlap_side(pair, &e, block, -1, limit) <= limit)
                return reach;
        }
    }
    return parting;
}

/* Returns the depth of the pair's overlap, or 0 if the overlap is shallow
   enough for a contact. The search may stop at a depth above `limit`, and the
   result is then this depth. The result may be too small by one stride. If two
   convex blocks are so thin that no point is too deep, the result is the length
   of the shortest motion that separates them. Inner points are needed for two
   equal blocks at one place, since neither boundary is inside the other
   block. */
KERN_SHARED static kern_real kern_overlap_depth(kern_pair *pair,
                                                kern_real limit)
{
    const kern_outline *const o = pair->outline;
    const kern_real gap = pair->overlap_max;
    kern_real deepest = gap, parting;
    int i;
    if (!kern_boxes_meet(&o[0].block->box, &o[1].block->box, -gap))
        return KERN_R(0);
    parting = kern_overlap_parting(pair);
    if (parting <= gap / 2 || !kern_pair_spend(pair, 0))
        return KERN_R(0);

    /* Finds how deep points of each block lie inside the other. If no point is
       too deep and both blocks are convex, the depth is the length of the
       motion that separates them. */
    for (i = 0; i < 2 && !(deepest > limit); i++)
        kern_overlap_boundary(pair, i, limit, &deepest);
    for (i = 0; i < 2 && !(deepest > gap); i++)
        kern_overlap_middles(pair, i, &deepest);
    if (!(deepest > gap)
        && o[0].reflex + o[0].straight + o[1].reflex + o[1].straight == 0)
        deepest = parting;
    return deepest > gap ? deepest : KERN_R(0);
}

/* ---- lines ---- */

/* Returns the end of a line on the side of t (side = 1) or of -t (side =
   -1). */
static kern_vec kern_line_end(const kern_contact *line, kern_real side)
{
    return kern_vec_step(line->p, side * line->travel, kern_vec_turn(line->n));
}

/* Adds a contact of length 2 * half, or a point if half is 0, to the contacts
   of the pair. These are in order of length: the contact is inserted after
   those that are at least as long. If there is no room, only counts the
   contact. */
static void kern_pair_put(kern_pair *pair, kern_vec p, kern_vec n,
                          kern_real half)
{
    const kern_contact made = {pair->a, pair->b,           half > 0, p,
                               n,       pair->options->mu, half};
    kern_contact *contact = pair->out;
    int i = pair->count++;
    if (i >= pair->room)
        return;
    for (; i > pair->first_contact && contact[i - 1].travel < half; i--)
        contact[i] = contact[i - 1];
    contact[i] = made;
    pair->steps += (pair->count - i) / 4;
}

/* Returns 1 if two edges are antiparallel within options->angle. */
static int kern_pair_opposed(const kern_pair *pair, const kern_edge *e,
                             const kern_edge *f)
{
    return kern_vec_dot(e->d, f->d) < 0
        && kern_abs(kern_vec_cross(e->d, f->d)) <= pair->sine;
}

/* ---- lines and points ---- */

/* Returns the widest gap that counts as a contact at p. If
   options.pose_turn is set, this gap is wider, the farther p is from the
   centres of the blocks. */
static kern_real kern_pair_gap(const kern_pair *pair, kern_vec p)
{
    const kern_vec u = kern_vec_sub(p, pair->outline[0].block->centre);
    const kern_vec v = kern_vec_sub(p, pair->outline[1].block->centre);
    return !(pair->swing > 0)
             ? pair->gap
             : KERN_SQRT(pair->gap * pair->gap
                         + pair->swing * pair->swing
                               * (kern_vec_dot(u, u) + kern_vec_dot(v, v)));
}

/* Returns 1 if the middle p of an overlap lies inside each of the two blocks,
   at a depth of at least KERN_THIN times the overlap, give or take `slack`. The
   middle lies outside if one block has passed through a thin part of the other.
   `gap` is minus the overlap. Always returns 1 if `gap` is not negative, or if
   the options allow no overlap deeper than the gap. */
static int kern_pair_inside(kern_pair *pair, kern_vec p, kern_real gap,
                            kern_real slack)
{
    int i = 0, k = 0;
    return gap >= 0 || pair->overlap_max <= pair->gap
        || kern_min(kern_polygon_depth(&pair->outline[0], p, &i),
                    kern_polygon_depth(&pair->outline[1], p, &k))
               >= -KERN_THIN * gap - slack;
}

/* Adds the line contact of two edges, one of each block, if they are
   antiparallel and close to each other. Let t and n be the mean tangent and the
   mean normal of the edges, and s the coordinate along t. Plotted over s, the
   two edges have opposite slopes, so the gap between them changes at twice this
   slope. */
static void kern_pair_line(kern_pair *pair, const kern_edge *edge)
{
    const kern_edge *e = edge, *f = edge + 1;
    /* Places are relative to the start of e, so that rounding is small. */
    const kern_vec r = kern_vec_sub(f->q, e->p);
    kern_real start, cosine, slope, low, high, gap, gap_max, length_min;
    kern_vec t, n, p;
    if (!kern_pair_opposed(pair, e, f))
        return;

    /* Finds the range of s that both edges cover. The start of e is at s =
       0. */
    t = kern_vec_unit(kern_vec_sub(e->d, f->d));
    n = kern_vec_scale(kern_vec_turn(t), -1); /* points out of block a */
    cosine = kern_vec_dot(e->d, t);           /* -cosine for f */
    slope = kern_vec_dot(e->d, n) / cosine;
    start = kern_vec_dot(r, t);
    low = kern_max(KERN_R(0), start);
    high = kern_min(e->length * cosine, start + f->length * cosine);

    /* Clips the range to where the gap is small enough. Takes the widest gap at
       the middle of the range, midway between the edges, so that it is the same
       if the edges are exchanged. */
    gap = kern_vec_dot(r, n) + slope * start; /* gap at s = 0 */
    p = kern_vec_step(kern_vec_step(e->p, (low + high) / 2, t), gap / 2, n);
    gap_max = kern_pair_gap(pair, p);
    kern_clip(&low, &high, gap, -2 * slope,
              -kern_max(gap_max, pair->overlap_max), gap_max);

    /* Adds the contact midway between the edges if it is long enough. The least
       length is smaller for short edges, so that two short edges that match
       make a contact, too. An overlap counts only up to the length of the
       contact. */
    length_min = kern_min(pair->length_min, kern_max(e->length, f->length) / 2);
    if (!(high - low
          > kern_max(length_min, kern_max(pair->inset, pair->sure_inset))))
        return;
    p = kern_vec_step(kern_vec_step(e->p, (low + high) / 2, t), gap / 2, n);
    gap = kern_max(gap - slope * (low + high), low - high); /* gap at p */
    if (kern_pair_inside(pair, p, gap, pair->length_min))
        kern_pair_put(pair, p, n, (high - low) / 2);
}

/* Returns 1 if edge e of block a (side = 0) or b (side = 1) can hold a corner
   of the other block at p. The foot of p on the line of e must be inside e. If
   e ends within the gap of the foot in a reflex corner, the foot may also lie
   beyond this end by up to the gap. The two edges of the corner at p, which
   have the directions `prev_d` and `next_d` away from p, must then lead away
   from the other edge of the reflex corner. */
static int kern_pair_holds(const kern_pair *pair, const kern_edge *e, int side,
                           kern_vec p, kern_vec prev_d, kern_vec next_d)
{
    const kern_block *block = pair->outline[side].block;
    const kern_real foot = kern_edge_foot(e, p);
    int end, bears = 1;
    for (end = 0; end < 2 && bears; end++) {
        const int corner = end ? e->end : e->start;
        const kern_real inset = end ? e->length - foot : foot;
        bears = inset > pair->inset + pair->sure_inset;
        if (inset <= pair->gap && kern_polygon_turn(block, corner) < 0) {
            const int start = corner == e->corner
                                ? kern_polygon_previous(block, corner)
                                : corner;
            kern_edge wall; /* other edge of the reflex corner */
            kern_edge_set(&wall, block, start, kern_polygon_next(block, start));
            bears = inset >= -pair->gap
                 && kern_vec_cross(end ? prev_d : next_d, wall.d)
                        >= -pair->sine;
        }
    }
    return bears;
}

/* Adds the point contact of an edge e of block a (side = 0) or b (side = 1)
   with a corner of the other block, if they touch. The corner is the start of
   f, which is an edge of the other block. The caller has checked that f leads
   away from e. The corner must be convex and within the gap of e, its foot must
   be on e, and the edge before f must lead away from e, too. */
static void kern_pair_point(kern_pair *pair, const kern_edge *edge, int side)
{
    const kern_edge *e = &edge[side], *f = &edge[!side];
    const kern_real gap_max = kern_pair_gap(pair, f->p);
    const kern_real high = kern_vec_cross(kern_vec_sub(f->p, e->p), e->d);
    const kern_block *block = pair->outline[!side].block;
    kern_vec prev_d, p = f->p;
    int corner; /* index of the vertex before the start of f */
    if (high > gap_max || high < -kern_max(gap_max, pair->overlap_max))
        return;
    corner = block->area > 0 ? kern_polygon_previous(block, f->start)
                             : kern_polygon_next(block, f->start);
    prev_d = kern_vec_unit(kern_vec_sub(block->vertex[corner], f->p));
    if (kern_vec_cross(prev_d, f->d) > 0
        || kern_vec_cross(prev_d, e->d) < -pair->sine
        || !kern_pair_holds(pair, e, side, p, prev_d, f->d))
        return;
    if (pair->overlap_max > pair->gap) /* midway between corner and edge */
        p = kern_vec_step(p, high / 2, kern_vec_turn(e->d));
    if (kern_pair_inside(pair, p, high,
                         KERN_ERROR_EDGE * pair->options->pose_error))
        kern_pair_put(pair, p,
                      kern_vec_scale(kern_vec_turn(e->d), side ? 1 : -1), 0);
}

/* Adds the lines and points of all pairs of edges, one of each block, that are
   close to each other. */
static void kern_pair_edges(kern_pair *pair)
{
    kern_outline *a = &pair->outline[0], *b = &pair->outline[1];
    kern_edge edge[2];
    edge[0].corner = -1;
    while (kern_edge_next(&edge[0], a, &b->block->box, pair->reach)
           && kern_pair_spend(pair, 1)) {
        edge[1].corner = -1;
        while (kern_edge_next(&edge[1], b, &edge[0].box, pair->reach)) {
            const kern_real turn = kern_vec_cross(edge[0].d, edge[1].d);
            pair->steps += KERN_SEARCH_NEAR;
            kern_pair_line(pair, edge);
            if (turn >= -pair->sine)
                kern_pair_point(pair, edge, 1);
            if (turn <= pair->sine)
                kern_pair_point(pair, edge, 0);
        }
    }
}

/* ---- faces ---- */
/* The contacts of a pair are in order of length, points last. The first contact
   is the lead of a face. All contacts that lie on the line of the lead and have
   its normal, within the tolerances, join the face. A point is removed if its
   normal differs by less than 10 degrees from that of a lead that is a line,
   and if the point lies within the gap of the contacts that have joined. The
   first of the remaining contacts is the lead of the next face. A stretch is a
   face without a hollow that is wider than the gap. */

/* Merges contact i, the lead of a face, with all contacts that join this
   face. */
KERN_SHARED static void kern_pair_face(kern_pair *pair, int i)
{
    kern_contact *contact = pair->out;
    const kern_contact *const lead = &contact[i];
    kern_vec low = lead->p, high = lead->p; /* outermost points of the face */
    kern_real low_place = KERN_R(0),
              high_place = KERN_R(0);                   /* places of low and
                                                           high on the line */
    kern_vec sum = kern_vec_make(KERN_R(0), KERN_R(0)); /* sum of normals */
    kern_real half;
    int k, rest = i + 1;
    KERN_ASSERT(i >= pair->first_contact && i < pair->count);

    for (k = i; k < pair->count; k++) { /* the lead itself comes first */
        /* Computes the place and the angle of the contact relative to the lead,
           and the hollow between it and the face. */
        const kern_contact *c = &contact[k];
        const kern_vec r = kern_vec_sub(c->p, lead->p);
        const kern_real cosine = kern_vec_dot(lead->n, c->n);
        const kern_real sine = kern_abs(kern_vec_cross(lead->n, c->n));
        const kern_real place = kern_vec_cross(lead->n, r);
        const kern_real offset = kern_abs(kern_vec_dot(lead->n, r));
        const kern_real hollow = kern_same_blocks(lead, c) ? kern_max(
                                     low_place - place, place - high_place)
                                                           : KERN_INFINITY;
        half = c->travel * cosine;

        /* Removes a point that the lead, which is a line, already covers. */
        if (lead->line && !c->line && cosine > 0 && sine < KERN_SAME_FACE
            && kern_max(offset, hollow) <= pair->gap)
            continue;

        /* Keeps a contact that does not join, since it belongs to another
           face. */
        if (!(cosine > 0) || sine > pair->sine
            || kern_max(offset + c->travel * sine - pair->gap,
                        hollow - half - pair->hollow)
                   > 0) {
            contact[rest++] = *c;
            continue;
        }

        /* Any other contact joins the face. The ends of the face are its
           outermost points. */
        if (place - half < low_place) {
            low_place = place - half;
            low = kern_line_end(c, -1);
        }
        if (place + half > high_place) {
            high_place = place + half;
            high = kern_line_end(c, 1);
        }
        sum = kern_vec_step(sum, c->line ? 2 * c->travel : pair->gap, c->n);
    }

    /* Replaces the lead by the face. A face that is too short to be a line
       becomes a point. */
    pair->count = rest;
    contact[i].p = kern_vec_mid(low, high);
    contact[i].n = kern_vec_unit(sum);
    half = kern_vec_cross(contact[i].n, kern_vec_sub(high, low)) / 2;
    contact[i].line = 2 * half > pair->inset;
    contact[i].travel = contact[i].line ? half : KERN_R(0);
}

/* Merges the contacts from pair->first_contact on into faces. A contact that
   joins a stretch may close the hollow between the stretch and other contacts.
   So each stretch is merged again until no more contacts join it. */
static void kern_pair_faces(kern_pair *pair)
{
    int i, count;
    for (i = pair->first_contact;
         i < pair->count && kern_pair_spend(pair, pair->count - i);
         i += !(pair->hollow < KERN_INFINITY && pair->count < count)) {
        count = pair->count;
        kern_pair_face(pair, i);
    }
}

/* ---- travels ---- */

/* Returns the block that a contact carries if `gravity` is the direction of
   gravity: the block that its normal force pushes up. Returns KERN_OUT if the
   normal is horizontal within rounding. */
KERN_SHARED static int kern_carried_block(const kern_contact *c,
                                          kern_vec gravity)
{
    const kern_real push = kern_vec_dot(c->n, gravity);
    const kern_real push_min = KERN_LEVEL_LEAST * kern_vec_largest(gravity);
    return push < -push_min ? c->b : push > push_min ? c->a : KERN_OUT;
}

/* Returns 1 if contact d belongs to the group of contact c. If `gravity` is
   NULL, the group is the interface: all single points between the same two
   blocks. Otherwise the group is all contacts that carry the same block. */
static int kern_same_group(const kern_contact *c, const kern_contact *d,
                           const kern_vec *gravity)
{
    return gravity ? kern_carried_block(c, *gravity)
                         == kern_carried_block(d, *gravity)
                   : kern_same_interface(c, d);
}

/* Returns the middle of the two contact points that are farthest apart in the
   group of *member (kern_same_group()). If several pairs are equally far apart,
   the first pair by index counts. Charges the work to `pair`, unless it is
   NULL. */
static kern_vec kern_middle(const kern_contact *contact, int contacts,
                            const kern_contact *member, const kern_vec *gravity,
                            kern_pair *pair)
{
    kern_vec middle = member->p;
    kern_real widest = KERN_R(0);
    int j, k;
    for (j = 0; j < contacts; j++)
        for (k = j + 1;
             k < contacts && kern_same_group(member, &contact[j], gravity)
             && (!pair || kern_pair_spend(pair, 1));
             k++) {
            const kern_vec d = kern_vec_sub(contact[k].p, contact[j].p);
            const kern_real square = kern_vec_dot(d, d);
            if (square > widest
                && kern_same_group(member, &contact[k], gravity)) {
                widest = square;
                middle = kern_vec_mid(contact[j].p, contact[k].p);
            }
        }
    return middle;
}

/* Sets the travel of single points: the signed distance, along t of the point,
   to the middle of its group (kern_middle()). If `gravity` is NULL, a group is
   an interface, and all single points get a travel. Otherwise a group has all
   contacts that carry the same block, and only points that are alone in their
   interface and carry a block get a travel. Keeps the last middle, since
   successive points usually share it. */
static void kern_point_travels(kern_contact *contact, int contacts,
                               const kern_vec *gravity, kern_pair *pair)
{
    kern_vec middle = kern_vec_make(KERN_R(0), KERN_R(0));
    const kern_contact *member = NULL;
    int i, k;
    for (i = 0;
         i < contacts
         && (!pair || kern_pair_spend(pair, gravity ? 1 + contacts / 8 : 1));
         i++) {
        kern_contact *c = contact + i;
        int found = 0;
        for (k = 0; gravity && !c->line && k < contacts; k++)
            found += kern_same_interface(c, contact + k);
        if (c->line
            || (gravity && (found > 1 || kern_carried_block(c, *gravity) < 0)))
            continue;
        if (!member || !kern_same_group(member, c, gravity)) {
            member = c;
            middle = kern_middle(contact, contacts, c, gravity, pair);
        }
        c->travel = 0 /* so that -0 becomes 0 */
                  + kern_vec_cross(c->n, kern_vec_sub(middle, c->p));
    }
}

/* ---- the search ---- */

typedef enum kern_search_kind {
    KERN_SEARCH_CONTACTS,  /* for kern_contacts() and kern_touch()          */
    KERN_SEARCH_OVERLAPS,  /* pairs that overlap too deeply                 */
    KERN_SEARCH_EDGES,     /* contacts of edges and corners, not merged     */
    KERN_SEARCH_STRETCHES, /* faces that end at hollows wider than the gap  */
    KERN_SEARCH_SURE       /* stretches made only of lines at least
                              KERN_ERROR_SURE long, and of points at least as
                              far from the ends of their edge               */
} kern_search_kind;

typedef struct kern_search {
    const kern_block *block;
    int blocks;
    int first_block; /* first block that is paired with earlier blocks   */
    kern_fault *fault;
    kern_real resolution;  /* rounding of places [m]; no tolerance is
                              smaller                                    */
    kern_real reach;       /* widest gap of any pair [m]                 */
    kern_search_kind kind; /* what the search finds, and so what
                              pair.count counts                          */
    kern_overlap *overlap;
    kern_pair pair;
} kern_search;

/* Returns half the length of the diagonal of the block's box. */
static kern_real kern_box_half(const kern_block *block)
{
    return kern_vec_length(kern_vec_sub(block->box.high, block->box.low)) / 2;
}

/* Returns the widest gap that counts as a contact if the smaller free block of
   the pair has this size: options->gap, or KERN_GAP_SHARE of the size if
   options->gap is 0. For measured options the widest gap is the sum of these
   two. The result is at least s->resolution. */
static kern_real kern_search_gap(const kern_search *s, kern_real size)
{
    const kern_options *o = s->pair.options;
    const kern_real exact = o->gap > 0 && !(o->pose_error > 0)
                              ? KERN_R(0)
                              : KERN_GAP_SHARE * size;
    return kern_max(o->gap + exact, s->resolution);
}

/* Sets the tolerances of the pair. The blocks of its two outlines must be
   set. */
static void kern_pair_tolerances(kern_pair *pair, const kern_search *s)
{
    const kern_block *a = pair->outline[0].block, *b = pair->outline[1].block;
    const kern_real size = KERN_SQRT(
        kern_min(a->fixed ? KERN_INFINITY : kern_abs(a->area),
                 b->fixed ? KERN_INFINITY : kern_abs(b->area)));
    pair->gap = kern_search_gap(s, size);
    pair->overlap_max = kern_max(pair->gap, pair->options->overlap)
                      + 2 * pair->swing
                            * kern_min(kern_box_half(a), kern_box_half(b));
    pair->reach = kern_max(s->reach, pair->overlap_max);
    pair->length_min = kern_max(kern_min(pair->gap, KERN_LINE_LEAST * size),
                                s->resolution);
    pair->inset = kern_max(KERN_FOOT_INSET * size, s->resolution);
    pair->sure_inset = (s->kind == KERN_SEARCH_SURE ? KERN_ERROR_SURE
                                                    : -KERN_ERROR_EDGE)
                     * pair->options->pose_error;
    pair->hollow = s->kind == KERN_SEARCH_CONTACTS ? KERN_INFINITY : pair->gap;
}

/* Returns 1 if the box or the area that the vertices now have differs from that
   of kern_block_init(). */
static int kern_block_is_stale(const kern_block *block)
{
    kern_block fresh = *block;
    kern_polygon_area(&fresh);
    return kern_vec_largest(kern_vec_sub(fresh.box.low, block->box.low)) > 0
        || kern_vec_largest(kern_vec_sub(fresh.box.high, block->box.high)) > 0
        || !(kern_abs(fresh.area - block->area)
             <= KERN_AREA_TOL * kern_abs(block->area));
}

/* Returns 1 if two blocks need no search: they are farther apart than any gap,
   both are fixed, or a has no vertices. Two blocks that share one array of
   vertices always need a search, unless both are fixed: the vertices of the
   first were overwritten, and the search finds that the first block is
   stale. */
static int kern_search_is_apart(const kern_search *s, const kern_block *a,
                                const kern_block *b)
{
    return !a->vertices
        || (!kern_boxes_meet(&a->box, &b->box, s->reach)
            && a->vertex != b->vertex)
        || (a->fixed && b->fixed);
}

/* Finds the contacts of blocks i and j. In a search for overlaps, finds their
   overlap instead. Returns KERN_OK, or a negative status that names the
   fault. */
KERN_SHARED static kern_status kern_search_pair(kern_search *s, int i, int j)
{
    kern_pair *pair = &s->pair;
    const kern_block *a = &s->block[i], *b = &s->block[j];
    kern_real depth;
    KERN_ASSERT(i >= 0 && i < j && j < s->blocks);

    if (kern_search_is_apart(s, a, b)) /* true for most pairs */
        return KERN_OK;
    if (i < s->first_block && kern_block_is_stale(a)) {
        s->fault->block = i;
        return KERN_STALE;
    }

    /* Finds an overlap. If it is too deep, a search of kern_contacts() or
       kern_touch() ends. */
    kern_outline_set(&pair->outline[0], a);
    kern_pair_tolerances(pair, s);
    if (!kern_pair_spend(pair, 1))
        return KERN_LIMIT;
    depth = kern_overlap_depth(pair, s->kind == KERN_SEARCH_OVERLAPS
                                         ? KERN_INFINITY
                                         : pair->overlap_max);
    if (depth > 0 && s->kind == KERN_SEARCH_CONTACTS) {
        s->fault->block = i;
        s->fault->other = j;
        s->fault->value = depth;
        s->fault->allowed = pair->overlap_max;
        return KERN_OVERLAP;
    }
    if (s->kind == KERN_SEARCH_OVERLAPS) {
        const kern_overlap found = {i, j, depth, pair->overlap_max};
        if (depth > 0 && pair->count++ < pair->room)
            s->overlap[pair->count - 1] = found;
        return KERN_OK;
    }

    /* Finds the contacts of edges, merges them into faces, and sets the travels
       of points. */
    pair->a = i;
    pair->b = j;
    pair->first_contact = pair->count;
    kern_pair_edges(pair);
    if (pair->count > pair->room)
        return KERN_NO_SPACE;
    if (s->kind != KERN_SEARCH_EDGES)
        kern_pair_faces(pair);
    if (s->kind <= KERN_SEARCH_EDGES)
        kern_point_travels(pair->out + pair->first_contact,
                           pair->count - pair->first_contact, NULL, pair);
    return KERN_OK;
}

/* Makes one ground of all fixed blocks, so that cutting a fixed block in two
   changes nothing. In every contact with a fixed block, this block becomes
   block a and is replaced by the fixed block of the first such contact. Merges
   stretches that continue each other, and sets the travels of points again. */
static void kern_search_ground(kern_search *s)
{
    kern_pair *pair = &s->pair;
    kern_contact *out = pair->out;
    int i, ground = KERN_OUT, joined = 0;
    for (i = 0; i < pair->count; i++) {
        kern_contact *c = &out[i];
        if (s->block[c->b].fixed) {
            const int block = c->a;
            c->a = c->b;
            c->b = block;
            c->n = kern_vec_scale(c->n, -1);
        }
        if (s->block[c->a].fixed) {
            ground = ground < 0 ? c->a : ground;
            joined |= c->a != ground;
            c->a = ground;
        }
    }
    pair->first_contact = 0;
    pair->gap = pair->hollow = kern_search_gap(s, KERN_R(0));
    if (joined)
        kern_pair_faces(pair);
    kern_point_travels(out, pair->count, NULL, pair);
}

/* Replaces every line by two contact points, beginning with the last line.
   Returns the number of contact points, or KERN_NO_SPACE. */
static int kern_search_close(const kern_search *s)
{
    kern_contact *out = s->pair.out;
    int i, side, points = s->pair.count, place;
    for (i = 0; i < s->pair.count; i++)
        points += out[i].line;
    if (points > s->pair.room)
        return (int)KERN_NO_SPACE;
    place = points;
    for (i = s->pair.count - 1; i >= 0; i--) {
        const kern_contact c = out[i];
        for (side = 1; side >= -1; side -= 2) {
            kern_contact *end = &out[--place];
            *end = c;
            if (!c.line)
                break;
            end->travel = -KERN_R(side) * c.travel;
            end->p = kern_vec_step(c.p, -end->travel, kern_vec_turn(c.n));
        }
    }
    KERN_ASSERT(place == 0);
    return points;
}

/* Checks every block. Sets the data from which the tolerances of all pairs are
   computed. The vertices of blocks before s->first_block are not compared with
   their box and area here, but in kern_search_pair(), for blocks that may
   touch. */
KERN_SHARED static kern_status kern_search_survey(kern_search *s)
{
    kern_real largest = KERN_R(0); /* largest coordinate                 */
    kern_real area = KERN_R(0);    /* largest area of a free block       */
    kern_real arm = KERN_R(0);     /* twice the longest diagonal of a box */
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

        /* Checks the box and the area of the block. For a new block, compares
           them with its vertices. */
        if (status == KERN_OK)
            status = !kern_is_finite(block->area)
                          || !kern_boxes_meet(box, box, 0) /* true if low is
                                                            above high     */
                          || kern_box_largest(box) > KERN_FAR
                       ? KERN_BAD_NUMBER
                   : !(kern_abs(block->area) > 0) ? KERN_NO_AREA
                   : i >= s->first_block && kern_block_is_stale(block)
                       ? KERN_STALE
                       : KERN_OK;
        if (status != KERN_OK) {
            s->fault->block = i;
            return status;
        }

        /* Finds the largest coordinate, the largest arm and the largest area of
           a free block. */
        largest = kern_max(largest, kern_box_largest(box));
        if (s->pair.swing > 0) /* `arm` is used only then */
            arm = kern_max(arm, 4 * kern_box_half(block));
        if (!block->fixed)
            area = kern_max(area, kern_abs(block->area));
    }

    /* Sets the least tolerance, which is the rounding of coordinates, and the
       widest gap of any pair. */
    s->resolution = 2 * KERN_ROUNDING * largest;
    s->reach = kern_search_gap(s, KERN_SQRT(area)) + s->pair.swing * arm;
    return KERN_OK;
}

/* Checks the arguments of a search, except the contents of the blocks. Returns
   KERN_LIMIT if reading the blocks would exceed the limit of work. */
static kern_status kern_search_check(kern_search *s)
{
    const kern_options *o = s->pair.options;
    const kern_status status = o ? kern_options_check(o) : KERN_BAD_POINTER;
    return status != KERN_OK ? status
         : s->first_block < 0 || s->blocks < s->first_block || s->pair.room < 0
                   || s->blocks > KERN_POINTS_MOST
             ? KERN_BAD_COUNT
         : (s->blocks > 0 && !s->block) || (s->pair.room > 0 && !s->pair.out)
             ? KERN_BAD_POINTER
         : kern_pair_spend(&s->pair, 2 * s->blocks - s->first_block)
             ? KERN_OK
             : KERN_LIMIT;
}

/* Finds the contacts or the overlaps of each block from index `first` on with
   all blocks of lower index. Returns the number of contact points or overlaps,
   or a negative status. */
static int kern_search_run(const kern_block *block, int blocks,
                           const kern_options *options, void *out, int room,
                           kern_work *work, int first, kern_search_kind kind)
{
    kern_search s;
    kern_status status;
    int a, b;
    if (!work)
        return (int)KERN_BAD_POINTER;

    /* Sets the fields of the search that are the same for all pairs. */
    kern_work_begin(work);
    s.block = block;
    s.blocks = blocks;
    s.first_block = first;
    s.pair.options = options;
    s.pair.work = work;
    s.pair.steps = KERN_SEARCH_UNIT - 1; /* the first step costs a unit */
    s.pair.outline[0].visits = s.pair.outline[1].visits = 0;
    s.fault = &work->fault;
    s.kind = kind;
    s.overlap = (kern_overlap *)out;
    s.pair.out = (kern_contact *)out;
    s.pair.room = room;
    s.pair.count = 0;

    /* Searches every pair of a block from `first` on and a block of lower
       index. */
    status = kern_search_check(&s);
    if (status == KERN_OK)
        status = kern_search_survey(&s);
    for (b = first; b < blocks && status == KERN_OK; b++) {
        if (!kern_pair_spend(&s.pair, b / 4))
            return (int)KERN_LIMIT;
        kern_outline_set(&s.pair.outline[1], &block[b]);
        for (a = block[b].vertices ? 0 : b; a < b && status == KERN_OK; a++)
            status = kern_search_pair(&s, a, b);
    }
    if (status != KERN_OK)
        return (int)status;

    /* Replaces each line by two contact points. With options.lone, sets the
       travels of points that are alone in their interface. They are set last,
       since they depend on all contacts that carry the same block. */
    if (kind >= KERN_SEARCH_STRETCHES)
        kern_search_ground(&s);
    room = kind == KERN_SEARCH_OVERLAPS ? s.pair.count : kern_search_close(&s);
    if (room > 0 && kind != KERN_SEARCH_OVERLAPS
        && kern_vec_largest(options->lone) > 0)
        kern_point_travels(s.pair.out, room, &options->lone, &s.pair);
    return kern_pair_spend(&s.pair, 0) ? room : (int)KERN_LIMIT;
}

KERN_API int kern_contacts(const kern_block *block, int blocks,
                           const kern_options *options, kern_contact *out,
                           int room, kern_work *work)
{
    return kern_search_run(block, blocks, options, out, room, work, 0,
                           KERN_SEARCH_CONTACTS);
}

KERN_API int kern_stretches(const kern_block *block, int blocks,
                            const kern_options *options, kern_contact *out,
                            int room, kern_work *work)
{
    return kern_search_run(block, blocks, options, out, room, work, 0,
                           KERN_SEARCH_STRETCHES);
}

KERN_API int kern_touch(const kern_block *block, int b,
                        const kern_options *options, kern_contact *out,
                        int room, kern_work *work)
{
    return kern_search_run(block, b + (b <= KERN_POINTS_MOST), options, out,
                           room, work, b, KERN_SEARCH_CONTACTS);
}

KERN_API int kern_overlaps(const kern_block *block, int blocks,
                           const kern_options *options, kern_overlap *out,
                           int room, kern_work *work)
{
    return kern_search_run(block, blocks, options, out, room, work, 0,
                           KERN_SEARCH_OVERLAPS);
}

/* ---- contacts that are given ---- */

KERN_API int kern_contact_make(kern_contact *out, kern_vec q,
                               const kern_options *options)
{
    kern_vec d, normal;
    kern_status status;
    kern_real length, longest;
    int line;

    /* Checks the arguments. */
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

    /* Scales the normal to a length of about 1 before it is squared, since its
       square might overflow. */
    normal = kern_vec_unit(kern_vec_scale(out->n, 1 / longest));

    /* Makes a line if p and q differ by more than rounding. Checks that this
       line is along the tangent, within the angle of the options. */
    d = kern_vec_sub(q, out->p);
    length = kern_vec_length(d);
    line = length
         > 2 * KERN_ROUNDING
               * kern_max(kern_vec_largest(out->p), kern_vec_largest(q));
    if (line
        && kern_abs(kern_vec_dot(d, normal))
               > kern_sine(options->angle) * length)
        return (int)KERN_BAD_LINE;

    /* Writes one or two contact points. The travel of each end of a line leads
       to the middle of the line. */
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

KERN_API void kern_contact_travels(kern_contact *contact, int contacts)
{
    int i;
    if (!contact)
        return;
    kern_point_travels(contact, contacts, NULL, NULL);
    for (i = 0; i < contacts; i++)
        if (kern_line_begins(contact, contacts, i)) {
            kern_contact *c = &contact[i++];
            c->travel = kern_vec_cross(c->n, kern_vec_sub(c[1].p, c->p)) / 2;
            c[1].travel = -c->travel;
        }
}

/* ---- Planning ---------------------------------------------------- >>plan */
/* A plan remembers the bracket of its last margin, and the mechanism that
   proves the upper end. If a new stone does not touch the blocks that move in
   this mechanism, the same motion proves the upper end for the new structure,
   too. One verdict then proves the lower end. Otherwise the plan's known forces
   make the verdicts faster. */

KERN_API kern_plan kern_plan_of(kern_block *block, int blocks,
                                kern_contact *contact, int contacts,
                                kern_known known, kern_work *work)
{
    kern_plan plan = {kern_task_of(block, 0, contact, 0, work), block, blocks,
                      contact, contacts};
    plan.task.known = known;
    return plan;
}

/* Returns 1 if no pointer that a plan needs is NULL. */
static int kern_plan_is_whole(const kern_plan *plan)
{
    return plan && plan->block && plan->contact && plan->task.known.motion
        && plan->task.known.force && plan->task.work;
}

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

    /* Writes the block and its contacts after those of the plan. The counts of
       the plan do not include them yet. */
    plan->block[s->blocks] = *block;
    found = kern_touch(plan->block, s->blocks, &plan->task.options,
                       plan->contact + s->contacts,
                       plan->contact_room - s->contacts, plan->task.work);
    if (found < 0)
        return found;

    /* Includes the block in the plan. In the known results it is at rest and
       its contacts carry nothing. */
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

    /* Removes the contacts of block i and their forces. The indices of later
       blocks decrease by one. */
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

    /* Scales the known motion of the remaining blocks: in a mechanism the
       fastest block has the speed 1. */
    if (plan->task.known.fails > 0)
        kern_motion_scale(s, plan->task.known.motion);
    return KERN_OK;
}

/* Writes the present structure of the plan to *original, and then adds the
   block, unless it is NULL. If the block cannot be added, stores the negative
   status as the number of contacts. The query that follows then returns this
   status, with the results that belong to it. Returns KERN_OK or
   KERN_BAD_POINTER. */
KERN_SHARED static kern_status kern_plan_open(kern_plan *plan,
                                              const kern_block *block,
                                              kern_structure *original)
{
    int found;
    if (!kern_plan_is_whole(plan))
        return KERN_BAD_POINTER;
    *original = plan->task.s;
    found = block ? kern_plan_add(plan, block) : 0;
    if (found < 0)
        plan->task.s.contacts = found;
    return KERN_OK;
}

/* Restores the structure that the plan had before kern_plan_open(). Returns
   `answer`. */
static kern_status kern_plan_restore(kern_plan *plan,
                                     const kern_structure *original,
                                     kern_status answer)
{
    plan->task.s = *original;
    return answer;
}

KERN_API kern_status kern_plan_try(kern_plan *plan, const kern_block *block,
                                   kern_margin *out, const kern_proof *proof)
{
    kern_structure original;
    const kern_status status = block ? kern_plan_open(plan, block, &original)
                                     : KERN_BAD_POINTER;
    return status != KERN_OK
             ? status
             : kern_plan_restore(
                 plan, &original,
                 kern_measure_anew(&plan->task, &plan->task.known, out, proof));
}

/* Returns the verdict at a margin. If kerns are not nested, first evaluates the
   structure without the points that travel: if it stands without them, it
   stands at every smaller margin, too. Sets *may_fall to 1 if the structure may
   fall at a smaller margin although it stands at this one, and to 0
   otherwise. */
static kern_status kern_plan_verdict(kern_call *c, kern_real margin,
                                     int *may_fall)
{
    kern_real range[2];
    const int nested = kern_is_nested(&c->m, range);
    kern_status status;
    *may_fall = 0;
    if (!nested)
        kern_path_carry(&c->m, &c->path, KERN_CARRY_NESTED);
    kern_known_begin(&c->m, margin);
    status = kern_model_evaluate(&c->m, &c->part, &c->path.q);
    if (nested)
        return status;

    /* Ends if forces hold the structure without the points that travel, or if
       the motion is a proof with these points, too. Otherwise evaluates the
       whole structure. */
    *may_fall = status != KERN_STANDS
             && !(status == KERN_FALLS
                  && kern_path_falls_whole(&c->m, &c->path, margin));
    if (!*may_fall)
        return status;
    kern_path_carry(&c->m, &c->path, KERN_CARRY_ALL);
    return kern_model_evaluate(&c->m, &c->part, &c->path.q);
}

/* Returns the verdict at a margin. If kerns are not nested, also returns
   KERN_FALLS for a structure that stands at this margin but falls at a smaller
   one. */
static kern_status kern_plan_stands(const kern_task *task, kern_real margin,
                                    const kern_proof *proof)
{
    const kern_known *known = &task->known;
    kern_call c;
    kern_margin r;
    int may_fall = 0;
    kern_status status = kern_call_open(&c, task, margin, known);
    if (status == KERN_OK && !(margin >= 0))
        status = KERN_BAD_NUMBER;
    if (status != KERN_OK)
        return status;
    c.path.known = known;
    kern_model_know(&c.m, known);

    /* Tries the known motion first, unless the margin is below the place at
       which this motion proved a fall. */
    status = KERN_FALLS;
    if (!(known->fails > 0 && margin >= known->fails
          && kern_known_falls(&c.m, &c.path.q, known)))
        status = kern_plan_verdict(&c, margin, &may_fall);
    kern_proof_write(&c.m, proof, status);

    /* If the structure stands only with points that travel, computes its
       margin, since it may fall at a smaller one. */
    if (status == KERN_STANDS && may_fall) {
        const kern_proof motion_only = {NULL, proof ? proof->motion : NULL};
        c.path.q.shrink = KERN_R(0);
        status = kern_measure_task(&c, known, &r, &motion_only);
        if (status == KERN_STANDS && !r.saturated && r.margin < margin)
            status = KERN_FALLS;
    }
    return kern_call_status(task, status);
}

KERN_API kern_status kern_plan_bears(kern_plan *plan, const kern_block *block,
                                     kern_real margin, const kern_proof *proof)
{
    kern_structure original;
    const kern_status status = block ? kern_plan_open(plan, block, &original)
                                     : KERN_BAD_POINTER;
    return status != KERN_OK
             ? status
             : kern_plan_restore(plan, &original,
                                 kern_plan_stands(&plan->task, margin, proof));
}

KERN_API kern_status kern_plan_stays(kern_plan *plan, const kern_block *block,
                                     kern_real *chance)
{
    kern_structure original;
    const kern_status status = kern_plan_open(plan, block, &original);
    return status != KERN_OK
             ? status
             : kern_plan_restore(
                 plan, &original,
                 kern_stays(&plan->task, plan->task.s.blocks - 1, chance));
}

KERN_API kern_status kern_plan_raised(kern_plan *plan, const kern_block *block,
                                      kern_raising *out, kern_real *reserve,
                                      const kern_proof *proof)
{
    kern_structure original;
    const kern_status status = kern_plan_open(plan, block, &original);
    return status != KERN_OK
             ? status
             : kern_plan_restore(
                 plan, &original,
                 kern_raised(&plan->task, KERN_R(0), out, reserve, proof));
}

KERN_API kern_status kern_plan_copy(kern_plan *to, const kern_plan *from)
{
    const kern_structure *s;
    kern_known known;
    int i;
    if (!kern_plan_is_whole(to) || !kern_plan_is_whole(from))
        return KERN_BAD_POINTER;
    s = &from->task.s;
    if (s->blocks > to->block_room || s->contacts > to->contact_room)
        return KERN_NO_SPACE;

    /* Copies blocks, contacts, known forces and known motions into the arrays
       of `to`. */
    known = from->task.known;
    known.motion = to->task.known.motion;
    known.force = to->task.known.force;
    for (i = 0; i < s->blocks; i++) {
        to->block[i] = from->block[i];
        known.motion[i] = from->task.known.motion[i];
    }
    for (i = 0; i < s->contacts; i++) {
        to->contact[i] = from->contact[i];
        known.force[i] = from->task.known.force[i];
    }

    /* Copies the rest of the task. `to` keeps its arrays and its work
       memory. */
    to->task.s = *s;
    to->task.s.block = to->block;
    to->task.s.contact = to->contact;
    to->task.options = from->task.options;
    to->task.known = known;
    return KERN_OK;
}

/* ---- Coming to rest ---------------------------------------------- >>rest */
/* A stone moves straight down to its first touch, and then from touch to touch.
   A motion is a turn about a touch, a slide along an edge that is too steep for
   friction, or a turn while the stone slides at two touches. Of the motions
   that no touch blocks, the stone takes the one that lowers its centre most
   steeply. The stone is at rest when every motion that would lower its centre
   is blocked. A motion ends where a vertex of one outline meets an edge of the
   other, which happens on a straight line or an arc, so the stone overlaps no
   block. Each motion lowers the centre, so no pose occurs twice. */

/* A point where the stone touches a block. */
typedef struct kern_footing {
    kern_vec p, n;     /* place of the touch; unit normal of the edge, into
                          the stone                                      */
    kern_vec corner_n; /* where two convex corners meet: normal of the other
                          edge there; otherwise n                        */
    kern_vec way;      /* unit direction of a slide down the edge        */
    kern_real run;     /* length of the slide, to the end of the edge    */
} kern_footing;

/* Kinds of a course (kern_course). */
typedef enum kern_course_kind {
    KERN_COURSE_TOUCHES, /* no motion: the touches of the stone are found */
    KERN_COURSE_SLIDE,
    KERN_COURSE_TURN
} kern_course_kind;

/* A motion of the stone from one pose to the next, or a search for its touches
   in the present pose. */
typedef struct kern_course {
    kern_course_kind kind;
    kern_vec way;        /* slide: unit direction; turn: the point about
                            which the stone turns                          */
    kern_real sense;     /* turn: 1 counter-clockwise, -1 clockwise        */
    kern_real extent;    /* slide: length; turn: tangent of half its angle */
    kern_real steepness; /* sine of the angle below the horizontal at which
                            the stone's centre begins to move              */
    kern_real low, high; /* slide: range of the stone perpendicular to the
                            slide, without `graze` at both ends            */
} kern_course;

/* State of a stone's descent (kern_rest()). */
typedef struct kern_descent {
    const kern_task *task;
    const kern_block *shape; /* the caller's stone                       */
    kern_pose *pose;         /* present pose of the stone                */
    kern_vec *vertex;        /* present vertices of the stone            */
    kern_vec plumb;          /* unit direction of gravity                */
    kern_real touch;         /* largest distance that counts as a touch  */
    kern_real graze;         /* length by which an edge is extended at each
                                end                                      */
    kern_real bottom;        /* coordinate along `plumb` of a level below all
                                blocks                                   */
    kern_box swept;          /* box around the whole course of the stone */
    int side;                /* 1: vertices of the stone are tested against
                                edges of a block; -1: the reverse        */
    kern_footing footing[KERN_REST_TOUCHES];
    int footings;
    int earlier_footings; /* number of footings on the blocks before the
                             present one                                  */
} kern_descent;

/* Returns a, turned by the angle whose cosine is q.x and whose sine is q.y. */
static kern_vec kern_vec_turned(kern_vec a, kern_vec q)
{
    return kern_vec_make(q.x * a.x - q.y * a.y, q.y * a.x + q.x * a.y);
}

/* Places the stone with its centre at `centre`, turned as r->pose->turn says.
   Sets the vertices and the box of the stone in this pose. */
static void kern_descent_put(kern_descent *r, kern_vec centre)
{
    kern_block *b = &r->pose->block;
    int i;
    b->centre = centre;
    for (i = 0; i < b->vertices; i++) {
        const kern_vec arm = kern_vec_sub(r->shape->vertex[i],
                                          r->shape->centre);
        r->vertex[i] = kern_vec_add(centre,
                                    kern_vec_turned(arm, r->pose->turn));
        if (i == 0)
            b->box.low = b->box.high = r->vertex[0];
        kern_box_add(&b->box, r->vertex[i]);
    }
}

/* Returns a box around the path of a point p during a course. If r->side is 1,
   p is a point of the stone. If r->side is -1, p is a point of a block, and its
   path is relative to the stone. The path of a turn is an arc. The arc lies in
   the triangle of its start, the point where the tangents at its two ends
   intersect, and a point on the line of its chord beyond its end. */
static kern_box kern_descent_way(const kern_descent *r, const kern_course *c,
                                 kern_vec p)
{
    const kern_vec d = kern_vec_make(r->touch, r->touch);
    const kern_real end = KERN_R(r->side) * c->extent;
    kern_box box = {kern_vec_sub(p, d), kern_vec_add(p, d)};
    if (c->kind == KERN_COURSE_SLIDE) {
        kern_box_add(&box, kern_vec_step(p, end, c->way));
    } else if (c->kind == KERN_COURSE_TURN) {
        const kern_real q = c->sense * end;
        const kern_vec meet = kern_vec_step(
            p, q, kern_vec_turn(kern_vec_sub(p, c->way)));
        kern_box_add(&box, meet);
        kern_box_add(
            &box,
            kern_vec_step(p, 2 * q, kern_vec_turn(kern_vec_sub(meet, c->way))));
    }
    return box;
}

/* Returns the distance of p from the line of e, positive on the outer side of
   e. */
static kern_real kern_edge_height(const kern_edge *e, kern_vec p)
{
    return kern_vec_cross(kern_vec_sub(p, e->p), e->d);
}

/* Returns how far the segment from p, which touches e, to q leads away from e:
   the distance of one of its points from the line of e, positive outside. q may
   be very far away, so the point that is taken is no farther from p than e is
   long. */
static kern_real kern_edge_leaves(const kern_edge *e, kern_vec p, kern_vec q)
{
    return kern_edge_height(e, q) * e->length
         / (e->length + kern_vec_largest(kern_vec_sub(q, p)));
}

/* Returns 1 if the point on the line of e at the distance s from its start is
   on e, or at most `tolerance` beyond an end of e. */
static int kern_edge_holds(const kern_edge *e, kern_real s, kern_real tolerance)
{
    return s >= -tolerance && s <= e->length + tolerance;
}

/* Shortens the slide c if point p meets edge e from outside: the slide then
   ends there. Edges that only graze the two flanks of the stone do not stop it,
   so that it fits into a gap of its own width. If p is at an end of e when the
   slide begins, this function does not shorten the slide: kern_descent_prefer()
   has already decided whether that touch blocks it. */
static void kern_descent_slide(const kern_descent *r, kern_course *c,
                               const kern_edge *e, kern_vec p)
{
    const kern_real side = KERN_R(r->side);
    const kern_real place_p = kern_vec_cross(c->way, side > 0 ? e->p : p);
    const kern_real place_q = kern_vec_cross(c->way, side > 0 ? e->q : p);
    const kern_real approach = side * kern_vec_cross(e->d, c->way);
    const kern_real height = kern_edge_height(e, p), way = height / approach;
    if (approach > KERN_REST_LEVEL && height >= -r->touch && way < c->extent
        && kern_max(place_p, place_q) > c->low
        && kern_min(place_p, place_q) < c->high
        && kern_edge_holds(
            e, kern_edge_foot(e, p) + way * side * kern_vec_dot(e->d, c->way),
            way > r->touch ? r->graze : -r->touch))
        c->extent = kern_max(way, KERN_R(0));
}

/* Shortens the turn c if point p meets edge e from outside: the turn then ends
   there. Variables whose names end in _d are coordinates along e, and those in
   _n are coordinates outward from e. If p is at an end of e when the turn
   begins and does not move along e, this function does not shorten the turn:
   kern_descent_prefer() has already decided whether that touch blocks it. */
static void kern_descent_arc(const kern_descent *r, kern_course *c,
                             const kern_edge *e, kern_vec p)
{
    const kern_vec arm = kern_vec_sub(p, c->way);
    const kern_real arm_d = kern_vec_dot(arm, e->d);
    const kern_real arm_n = kern_vec_cross(arm, e->d);
    const kern_real centre_n = kern_edge_height(e, c->way);
    const kern_real square = kern_vec_dot(arm, arm),
                    side = square - centre_n * centre_n;
    const kern_real sense = c->sense * KERN_R(r->side);
    const kern_real touch_square = r->touch * r->touch;
    kern_real chord, cosine, q;
    int is_start;
    if (side < 2 * r->graze * centre_n || square < touch_square)
        return;

    /* Computes where the arc crosses the line of e inward. q is the tangent of
       half the angle of the turn up to there. A turn is smaller than a right
       angle. */
    chord = sense * KERN_SQRT(kern_max(side, KERN_R(0)));
    cosine = arm_d * chord - arm_n * centre_n;
    q = sense * (arm_d * centre_n + arm_n * chord) / (square + cosine);
    is_start = 4 * q * q * square <= touch_square;
    if (is_start)
        chord -= sense * centre_n * r->touch / KERN_SQRT(square);
    if (cosine > 0 && q < c->extent && (q >= 0 || is_start)
        && kern_edge_holds(e, kern_edge_foot(e, c->way) + chord,
                           r->graze - KERN_R(is_start) * r->touch))
        c->extent = kern_max(q, KERN_R(0));
}

/* Stores a footing if vertex k of b touches edge e of a and both edges of this
   vertex lie on the outer side of e. Where two convex corners meet, two edges
   pass this test. The `corner_n` of each of the two footings is then the normal
   of the other edge. Such a pair of footings blocks only a motion that presses
   against both edges. */
static void kern_descent_keep(kern_descent *r, const kern_edge *e,
                              const kern_block *a, const kern_block *b, int k)
{
    const kern_vec p = b->vertex[k];
    const kern_real foot = kern_edge_foot(e, p);
    const int sense = kern_vec_dot(e->d, r->plumb) > 0 ? 1 : -1;
    kern_footing *f = &r->footing[r->footings],
                 *g = r->footing + r->earlier_footings;
    if (r->footings >= KERN_REST_TOUCHES || !kern_edge_holds(e, foot, r->touch)
        || kern_abs(kern_edge_height(e, p)) > r->touch
        || kern_min(
               kern_edge_leaves(e, p, b->vertex[kern_polygon_previous(b, k)]),
               kern_edge_leaves(e, p, b->vertex[kern_polygon_next(b, k)]))
               < -r->touch)
        return;
    f->p = p;
    f->n = f->corner_n = kern_vec_scale(kern_vec_turn(e->d), -KERN_R(r->side));
    f->way = kern_vec_scale(e->d, KERN_R(sense));
    f->run = sense == r->side ? e->length - foot : foot;
    r->footings++;
    if (!kern_edge_holds(e, foot, -r->touch)
        && kern_polygon_turn(a, 2 * foot < e->length ? e->start : e->end) > 0)
        for (; g < f; g++)
            if (kern_vec_largest(kern_vec_sub(g->p, p)) <= r->touch) {
                g->corner_n = f->n;
                f->corner_n = g->n;
            }
}

/* Tests each vertex of b against each edge of a, where either a or b is the
   stone. Shortens the motion of course c, or stores the touches of the stone.
   Returns early if the limit of work is reached. */
static void kern_descent_pair(kern_descent *r, kern_course *c,
                              const kern_block *a, const kern_block *b)
{
    int k, i;
    for (k = 0; k < b->vertices; k++) {
        const kern_vec p = b->vertex[k];
        const kern_box box = kern_descent_way(r, c, p);
        if (!kern_boxes_meet(&box, &a->box, KERN_R(0)))
            continue;
        if (!kern_spend(r->task->work, r->task->options.limit,
                        1 + a->vertices / KERN_UNIT))
            return;

        /* Tests each edge of a whose box meets the path of the vertex. */
        for (i = 0; i < a->vertices; i++) {
            const int next = kern_polygon_next(a, i);
            kern_edge e;
            e.box.low = e.box.high = a->vertex[i];
            kern_box_add(&e.box, a->vertex[next]);
            if (!kern_boxes_meet(&e.box, &box, KERN_R(0)))
                continue;
            kern_edge_set(&e, a, i, next);
            if (c->kind == KERN_COURSE_TURN)
                kern_descent_arc(r, c, &e, p);
            else if (c->kind == KERN_COURSE_SLIDE)
                kern_descent_slide(r, c, &e, p);
            else
                kern_descent_keep(r, &e, a, b, k);
        }
    }
}

/* Sets r->swept, the box around the whole course of the stone. Sets the range
   that the stone covers across a slide. */
static void kern_descent_sweep(kern_descent *r, kern_course *c)
{
    int i;
    r->side = 1;
    r->swept = r->pose->block.box;
    c->low = KERN_INFINITY;
    c->high = -c->low;
    for (i = 0; i < r->shape->vertices; i++) {
        const kern_real place = kern_vec_cross(c->way, r->vertex[i]);
        const kern_box box = kern_descent_way(r, c, r->vertex[i]);
        kern_box_add(&r->swept, box.low);
        kern_box_add(&r->swept, box.high);
        c->low = kern_min(c->low, place + r->graze);
        c->high = kern_max(c->high, place - r->graze);
    }
}

/* Finds where a motion ends, which shortens course c, or finds the touches of
   the stone. */
static void kern_descent_look(kern_descent *r, kern_course *c)
{
    const kern_structure *s = &r->task->s;
    const kern_block *stone = &r->pose->block;
    kern_real end = c->extent;
    int i;
    kern_descent_sweep(r, c);
    /* Begins with the blocks of the highest index. They are often at the top,
       and then soon shorten the course. */
    for (i = s->blocks - 1; i >= 0; i--) {
        const kern_block *b = &s->block[i];
        if (!b->vertices || !kern_boxes_meet(&r->swept, &b->box, KERN_R(0)))
            continue;
        r->earlier_footings = r->footings;
        kern_descent_pair(r, c, b, stone);
        r->side = -1;
        kern_descent_pair(r, c, stone, b);
        r->side = 1;
        if (2 * c->extent < end) {
            end = c->extent;
            kern_descent_sweep(r, c);
        }
    }
}

/* Moves the stone to the end of course c and finds its touches there. Returns 1
   if the stone has moved or has more touches than before. */
static int kern_descent_go(kern_descent *r, kern_course *c)
{
    const kern_vec centre = r->pose->block.centre;
    const int footings = r->footings;
    kern_real size = KERN_R(1);
    int moved;
    kern_descent_look(r, c);
    if (c->kind == KERN_COURSE_TURN) {
        const kern_real q = c->extent, whole = 1 + q * q;
        const kern_vec turn = kern_vec_make((1 - q * q) / whole,
                                            2 * q * c->sense / whole);
        r->pose->turn = kern_vec_unit(kern_vec_turned(r->pose->turn, turn));
        kern_descent_put(
            r, kern_vec_add(c->way, kern_vec_turned(
                                        kern_vec_sub(centre, c->way), turn)));
        size = kern_block_size(r->shape);
    } else {
        kern_descent_put(r, kern_vec_step(centre, c->extent, c->way));
    }
    moved = c->extent * size > r->touch;
    r->pose->motions += moved;
    r->footings = 0;
    c->kind = KERN_COURSE_TOUCHES;
    kern_descent_look(r, c);
    return moved || r->footings > footings;
}

/* Replaces *best by motion c if c is better and presses against no footing. The
   steeper motion is better. Of equally steep motions a turn is better than a
   slide, and of the same kind the shorter one is better. m is the velocity with
   which c begins, scaled so that the centre of the stone has the speed 1. */
static void kern_descent_prefer(const kern_descent *r, kern_course *best,
                                kern_course *c, kern_motion m)
{
    const kern_vec centre = r->pose->block.centre;
    int i;
    c->steepness = m.vx * r->plumb.x + m.vy * r->plumb.y;
    if (c->steepness < best->steepness - KERN_REST_LEVEL
        || (c->steepness <= best->steepness + KERN_REST_LEVEL
            && (c->kind == best->kind ? c->extent >= best->extent
                                      : c->kind < best->kind)))
        return;
    for (i = 0; i < r->footings; i++) {
        const kern_footing *f = &r->footing[i];
        const kern_vec v = kern_velocity(&m, kern_vec_sub(f->p, centre));
        if (kern_max(kern_vec_dot(v, f->n), kern_vec_dot(v, f->corner_n))
            < -KERN_REST_LEVEL)
            return;
    }
    *best = *c;
}

/* Replaces *best by a slide down the edge of footing f if this slide is better
   (kern_descent_prefer()). The slide ends a little beyond the end of the edge,
   by 20 touch distances: kern_contacts() then finds a point contact at that
   end. */
static void kern_descent_slope(const kern_descent *r, const kern_footing *f,
                               kern_course *best)
{
    const kern_motion m = {f->way.x, f->way.y, 0};
    kern_course c;
    c.kind = KERN_COURSE_SLIDE;
    c.way = f->way;
    c.extent = f->run + 20 * r->touch;
    kern_descent_prefer(r, best, &c, m);
}

/* Replaces *best by a turn about p if this turn is better
   (kern_descent_prefer()). The stone turns in the sense in which its weight
   turns it, until its centre is lowest, but not farther than KERN_REST_TURN. */
static void kern_descent_tip(const kern_descent *r, kern_vec p,
                             kern_course *best)
{
    const kern_vec arm = kern_vec_sub(r->pose->block.centre, p);
    const kern_real length = kern_vec_length(arm);
    const kern_real lever = kern_vec_cross(arm, r->plumb);
    const kern_real spin = KERN_R(lever < 0 ? -1 : 1);
    const kern_motion m = {-spin * arm.y / length, spin * arm.x / length,
                           spin / length};
    kern_course c;
    c.kind = KERN_COURSE_TURN;
    c.way = p;
    c.sense = spin;
    c.extent = kern_min(KERN_REST_TURN,
                        spin * lever / (length + kern_vec_dot(arm, r->plumb)));
    kern_descent_prefer(r, best, &c, m);
}

/* Moves the stone by the best motion that its touches do not block. A stone
   without touches falls straight down. Returns 1 if the stone has moved or has
   more touches than before. */
static int kern_descent_move(kern_descent *r)
{
    const kern_real mu = r->task->options.mu;
    const kern_real slip = kern_max(mu, KERN_REST_SLIP);
    kern_course best;
    int i, k;
    best.kind = KERN_COURSE_SLIDE;
    best.way = r->plumb;
    best.extent = r->bottom - kern_vec_dot(r->pose->block.centre, r->plumb);
    best.steepness = r->footings ? KERN_REST_LEVEL : KERN_R(1);
    for (i = 0; i < r->footings; i++) {
        const kern_footing *f = &r->footing[i];
        const kern_real lift = -kern_vec_dot(f->n, r->plumb);
        if (lift > KERN_REST_LEVEL)
            kern_descent_tip(r, f->p, &best);
        if (lift * KERN_SQRT(1 + mu * mu) < 1 - KERN_REST_LEVEL)
            kern_descent_slope(r, f, &best);

        /* Tries turns during which the stone slides at two touches and both
           open. The lines of two contact forces, each on an edge of its
           friction cone, intersect in the point about which the stone then
           turns. */
        for (k = 0; k < 4 * i; k++) {
            const kern_footing *g = &r->footing[k / 4];
            const kern_vec u = kern_vec_step(f->n, k & 1 ? slip : -slip,
                                             f->way);
            const kern_vec v = kern_vec_step(g->n, k & 2 ? slip : -slip,
                                             g->way);
            const kern_real sine = kern_vec_cross(u, v);
            const kern_vec span = kern_vec_sub(g->p, f->p);
            if (kern_abs(sine) > KERN_REST_LEVEL)
                kern_descent_tip(
                    r, kern_vec_step(f->p, kern_vec_cross(span, v) / sine, u),
                    &best);
        }
    }
    return best.steepness > KERN_REST_LEVEL && r->footings < KERN_REST_TOUCHES
        && kern_descent_go(r, &best);
}

/* Checks the blocks and the stone of kern_rest(), and places the stone above
   all blocks. Returns KERN_NO_REST if the descent can begin, KERN_NO_SUPPORT if
   there are no blocks, and otherwise a status that names the fault. */
static kern_status kern_descent_begin(kern_descent *r, kern_real x)
{
    const kern_structure *s = &r->task->s;
    const kern_real weight = kern_vec_length(s->gravity);
    kern_search search;
    kern_status status;
    if (!(weight > 0))
        return KERN_NO_LOAD;
    search.pair.options = &r->task->options;
    search.fault = &r->task->work->fault;
    search.block = r->shape;
    search.blocks = 1;
    search.first_block = 0;
    status = r->shape->vertices ? kern_search_survey(&search)
                                : KERN_FEW_VERTICES;
    if (status == KERN_OK && !kern_vec_is_moderate(r->shape->centre))
        status = KERN_BAD_NUMBER;
    if (status != KERN_OK) {
        search.fault->block = s->blocks;
        return status;
    }
    search.block = s->block;
    search.blocks = search.first_block = s->blocks;
    status = kern_search_survey(&search);
    if (status != KERN_OK)
        return status;

    /* Sets the tolerances and the lowest level. No coordinate of a block
       exceeds `resolution` / (2 KERN_ROUNDING). */
    r->plumb = kern_vec_scale(s->gravity, 1 / weight);
    r->touch = kern_max(KERN_REST_TOUCH * kern_block_size(r->shape),
                        search.resolution);
    r->graze = kern_max(KERN_REST_END * r->touch, search.resolution / 2);
    r->bottom = search.resolution / KERN_ROUNDING + 2 * kern_box_half(r->shape);
    r->footings = 0;
    kern_descent_put(r,
                     kern_vec_step(kern_vec_scale(kern_vec_turn(r->plumb), x),
                                   -r->bottom, r->plumb));
    return s->blocks ? KERN_NO_REST : KERN_NO_SUPPORT;
}

KERN_API kern_status kern_rest(const kern_task *task, const kern_block *stone,
                               kern_real x, kern_vec turn, kern_vec *vertex,
                               kern_pose *out)
{
    kern_descent r;
    kern_status status = kern_task_check(task, KERN_R(0), out);
    if (status != KERN_OK)
        return status;
    if (!stone || !vertex || vertex == stone->vertex)
        return KERN_BAD_POINTER;
    if (!(kern_abs(x) <= KERN_FAR)
        || !(kern_abs(kern_vec_dot(turn, turn) - 1) <= KERN_NORMAL_TOL))
        return KERN_BAD_NUMBER;
    out->block = *stone;
    out->block.vertex = r.vertex = vertex;
    out->turn = turn;
    out->motions = 0;
    r.task = task;
    r.shape = stone;
    r.pose = out;
    status = kern_descent_begin(&r, x);

    /* Moves the stone from touch to touch until it is at rest, is below all
       blocks, or has made KERN_REST_MOTIONS motions. */
    while (status == KERN_NO_REST && out->motions < KERN_REST_MOTIONS)
        if (!kern_descent_move(&r))
            status = KERN_OK;
        else if (kern_vec_dot(out->block.centre, r.plumb) > r.bottom - r.touch)
            status = KERN_NO_SUPPORT;
    return kern_call_status(task, status);
}

/* ---- which place is best ---- */

/* Returns the i-th of the numbers by which a place is ranked, so that a larger
   number is better. Rounds all numbers except x and turn. NaN becomes the worst
   number. */
static kern_real kern_place_number(const kern_place *place, int i,
                                   kern_real alone)
{
    const kern_real number[6] = {kern_min(KERN_PLACE_STAYS, place->stays),
                                 kern_abs(place->margin - alone)
                                         <= KERN_PLACE_SAME * alone
                                     ? alone
                                     : place->margin,
                                 place->own,
                                 place->load,
                                 -place->x,
                                 -place->turn};
    const kern_real value = kern_max(number[i], -KERN_INFINITY);
    const kern_real scaled = KERN_PLACE_SPLIT * value;
    const kern_real rounded = scaled - (scaled - value); /* NaN if infinite */
    return i < 4 && kern_is_finite(rounded) ? rounded : value;
}

KERN_API int kern_place_compare(const kern_place *a, const kern_place *b,
                                kern_real alone)
{
    int i, order = (a != NULL) - (b != NULL);
    for (i = 0; a && b && i < 6 && !order; i++) {
        const kern_real p = kern_place_number(a, i, alone);
        const kern_real q = kern_place_number(b, i, alone);
        order = (p > q) - (p < q);
    }
    return order;
}

/* ---- Settling, certainty ---------------------------------------- >>settle */
/* A measured structure differs by the errors from one that is at rest. This
   chapter lets it settle. Its blocks fall until they rest on each other. If no
   contact may close by more than its gap, the motion y that frees the most
   energy solves a linear program:

       min b.y,  A'y + gap >= 0,

   where b are the wrenches that the contacts must exert, and A'y the opening
   speeds along both edges of each friction cone (>>lp). The program

       min gap.x,  A x = b,  x >= 0

   has y as its prices. Its x are the forces that hold the blocks at their new
   places: of all forces in equilibrium those across the narrowest gaps.

   In this program two blocks that slide by s also part by mu s (>>raised). Real
   blocks do not part. So the program is solved in rounds. After each round the
   gaps are computed without this parting, and the next round closes them. The
   blocks rest if every contact that presses is closed (KERN_SETTLE_CLOSED): the
   forces x then hold them where they are.

   Contacts stay where they were measured, since the blocks move by a few errors
   only. All lengths are measured along contacts, so the frame does not matter.
   A stretch is a contact point or both ends of a line. The gap of a stretch was
   measured with an error. So the structure settles several times, each time
   with other stretches open by more than was measured. */

typedef struct kern_repose {
    kern_call call;      /* the task without shrinkage                      */
    int *order;          /* the contact points, beginning with the lowest   */
    int *stretch;        /* per point: number of points of the stretch that
                            begins here; 0 for the second end of a line     */
    kern_real *gap;      /* per point [m]                                   */
    kern_real *slip;     /* per point: distance slid along t so far [m]     */
    kern_motion *motion; /* per block: sum of the motions of all rounds [m] */
} kern_repose;

/* Returns the vector from the centre of block i, if it is free, to p. */
static kern_vec kern_repose_arm(const kern_structure *s, int i, kern_vec p)
{
    return s->block[i].fixed ? kern_vec_make(KERN_R(0), KERN_R(0))
                             : kern_vec_sub(p, s->block[i].centre);
}

/* Finds the stretches, and sorts the contact points by height, from below. Both
   ends of a line are about as high as its middle. */
static void kern_repose_sort(const kern_repose *r)
{
    const kern_structure *s = r->call.m.s;
    const kern_vec axis = kern_vec_step(s->gravity, KERN_SETTLE_TIE,
                                        kern_vec_turn(s->gravity));
    kern_real *const height = r->gap; /* free until kern_repose_open() */
    int i;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_vec middle = kern_contact_at(c, kern_abs(c->travel), 0);
        const kern_vec arms = kern_vec_add(kern_repose_arm(s, c->a, c->p),
                                           kern_repose_arm(s, c->b, c->p));
        height[i] = -kern_vec_dot(kern_vec_step(middle, -KERN_SETTLE_TIE, arms),
                                  axis);
        r->order[i] = i;
        r->stretch[i] = i > 0 && r->stretch[i - 1] > 1 ? 0 : 1 + c->line;
    }
    kern_sort(r->order, s->contacts, height);
}

/* Begins a settling of the task. Its arrays precede those of the program. */
static kern_status kern_repose_begin(kern_repose *r, const kern_task *task)
{
    const int contacts = task->s.contacts, blocks = task->s.blocks;
    kern_take *const take = &r->call.m.rest;
    const kern_status status = kern_call_open(&r->call, task, 0, task);
    if (status != KERN_OK)
        return status;
    r->order = kern_take_ints(take, 2 * contacts);
    r->stretch = r->order + contacts;
    r->gap = kern_take_reals(take, 2 * contacts + 3 * blocks);
    if (!kern_take_fits(take))
        return KERN_NO_SPACE;
    r->slip = r->gap + contacts;
    r->motion = (kern_motion *)(void *)(r->slip + contacts);
    kern_zero(r->slip, contacts + 3 * blocks);
    r->call.m.common = *take;
    kern_repose_sort(r);
    return KERN_OK;
}

/* Returns the depth of p inside block b. The depth is negative if p is outside.
   All fixed blocks count as one block. */
static kern_real kern_repose_depth(const kern_structure *s, kern_vec p, int b)
{
    kern_real deepest = -KERN_INFINITY;
    kern_outline outline;
    int i, nearest;
    for (i = 0; i < s->blocks; i++)
        if (s->block[i].vertices
            && (i == b || (s->block[i].fixed && s->block[b].fixed))) {
            nearest = 0;
            kern_outline_set(&outline, s->block + i);
            deepest = kern_max(deepest,
                               kern_polygon_depth(&outline, p, &nearest));
        }
    return deepest;
}

/* Returns the gap between the outlines at contact c. The gap is negative where
   the outlines overlap. */
static kern_real kern_repose_gap(const kern_structure *s, const kern_contact *c)
{
    return -kern_repose_depth(s, c->p, c->a) - kern_repose_depth(s, c->p, c->b);
}

/* Sets all gaps to the share `keep` of those between the outlines. Every
   `parts`-th stretch from below, beginning with number `part`, is open by
   `extra` more. */
static void kern_repose_open(const kern_repose *r, int part, int parts,
                             kern_real extra, kern_real keep)
{
    const kern_structure *s = r->call.m.s;
    int i, k, n = 0;
    for (k = 0; k < s->contacts; k++) {
        const int first = r->order[k], points = r->stretch[first];
        for (i = first; i < first + points; i++) {
            const kern_real gap = kern_repose_gap(s, s->contact + i);
            r->gap[i] = n % parts == part ? kern_max(gap + extra, keep * gap)
                                          : keep * gap;
        }
        n += points > 0;
    }
}

/* Solves the program of one round. `interior` is NULL or the interior-point
   method. Gaps and motion are in errors of place. `lightest` is the magnitude
   of the lightest load. Returns KERN_LP_OPTIMAL if the program has a
   solution. */
static kern_status kern_repose_round(kern_repose *r, kern_ipm *interior,
                                     kern_real lightest)
{
    kern_part *p = &r->call.part;
    kern_real *cost = kern_model_rays(&r->call.m);
    int i;
    for (i = 0; i < 2 * p->contacts; i++)
        cost[i] = r->gap[p->contact[i / 2]]
                / r->call.m.task->options.pose_error;
    (void)lightest; /* not used without the interior-point method */
    if (interior)
        return kern_ipm_minimise(interior, cost, lightest);
    p->eq.lp.cost = cost;
    return kern_program_solve(&p->eq.simplex, KERN_SOLVER_BUILTIN, p->x, p->y);
}

/* Moves the blocks by the motion y of a round. Writes to *way how far they have
   moved at most. Returns the widest gap of a contact that presses. */
static kern_real kern_repose_move(kern_repose *r, kern_real *way)
{
    const kern_part *p = &r->call.part;
    const kern_structure *s = r->call.m.s;
    const kern_real e = r->call.m.task->options.pose_error;
    kern_motion *v = r->call.m.answer.motion;
    kern_real widest = KERN_R(0);
    int i;
    kern_part_motion(&r->call.part);
    kern_scale(v, 3 * s->blocks, e);
    kern_add(r->motion, 1, v, 3 * s->blocks);
    for (i = 0, *way = KERN_R(0); i < s->blocks; i++)
        *way = kern_max(*way, kern_block_speed(&s->block[i], &r->motion[i]));

    /* Updates the gaps and slips. */
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_vec u = kern_vec_sub(
            kern_velocity(v + c->b, kern_repose_arm(s, c->b, c->p)),
            kern_velocity(v + c->a, kern_repose_arm(s, c->a, c->p)));
        r->gap[i] += kern_vec_dot(c->n, u);
        r->slip[i] += kern_vec_cross(c->n, u);
    }
    for (i = 0; i < 2 * p->contacts; i++)
        if (p->x[i] > 0)
            widest = kern_max(widest, r->gap[p->contact[i / 2]]);
    return widest;
}

/* Returns 1 if contact point i, which is an end of a line, has slid by half the
   length of the line, and the block on which it slides ends there, give or take
   the errors. `out` is the sign along t of the way out of the line. */
static int kern_repose_slid(const kern_repose *r, int i, kern_real out)
{
    const kern_structure *s = r->call.m.s;
    const kern_contact *c = s->contact + i;
    const kern_real way = kern_abs(r->slip[i]);
    const kern_real error = r->call.m.task->options.pose_error;
    return way > kern_abs(c->travel) + KERN_SETTLE_TIE * error
        && kern_repose_depth(s,
                             kern_vec_step(c->p,
                                           out * (KERN_ERRORS * error + way),
                                           kern_vec_turn(c->n)),
                             out * r->slip[i] > 0 ? c->a : c->b)
               < -way / 2;
}

/* Returns 1 if a closed line contact has slid at both ends
   (kern_repose_slid()): its block may have left the block on which it lies. */
static int kern_repose_leaves(const kern_repose *r)
{
    const kern_structure *s = r->call.m.s;
    const kern_real closed = KERN_SETTLE_CLOSED
                           * r->call.m.task->options.pose_error;
    int i, leaves = 0;
    for (i = 0; i < s->contacts; i++)
        leaves |= r->stretch[i] > 1
               && kern_min(r->gap[i], r->gap[i + 1]) <= closed
               && kern_repose_slid(r, i, KERN_R(1))
               && kern_repose_slid(r, i + 1, KERN_R(-1));
    return leaves;
}

/* Solves rounds until the blocks rest. Writes to *way how far they have moved
   at most, or KERN_INFINITY if that is more than `limit` or if they do not come
   to rest. Returns the status of the last program. */
static kern_status kern_repose_rounds(kern_repose *r, kern_ipm *interior,
                                      kern_real limit, kern_real *way)
{
    const kern_part *p = &r->call.part;
    const kern_real lightest = kern_part_load(p, &r->call.path.q, p->eq.rhs)
                             / KERN_PART_TOL;
    const kern_real rest = KERN_SETTLE_CLOSED
                         * r->call.m.task->options.pose_error;
    kern_real widest = KERN_INFINITY;
    kern_status status = KERN_OK;
    int i, round;
    *way = KERN_R(0);
    for (round = 0;
         round < KERN_SETTLE_ROUNDS && widest > rest && *way <= limit;
         round++) {
        status = kern_repose_round(r, interior, lightest);
        if (status == KERN_LP_OPTIMAL)
            widest = kern_repose_move(r, way);

        /* Counts overlaps as closed contacts and tries again if blocks overlap
           that no motion can part. The interior-point method does not tell this
           case from a fall. */
        else if (round == 0 && (interior || status == KERN_LP_UNBOUNDED))
            for (i = 0; i < r->call.m.s->contacts; i++)
                r->gap[i] = kern_max(r->gap[i], KERN_R(0));
        else
            break;
    }

    if (!(widest <= rest && *way <= limit))
        *way = KERN_INFINITY;
    return status;
}

/* Lets the blocks settle. Writes to *way how far they move at most, or
   KERN_INFINITY if that is more than `limit`, if they do not come to rest or if
   they slide off what they lie on. More than KERN_SMALL groups are solved by
   the interior-point method. Returns KERN_OK or an error. */
static kern_status kern_repose_settle(kern_repose *r, kern_real limit,
                                      kern_real *way)
{
    kern_model *const m = &r->call.m;
    kern_part *const p = &r->call.part;
    const kern_query *q = &r->call.path.q;
    kern_ipm ipm, *interior = NULL;
    kern_status status = KERN_OK;
    if (m->graph.groups > KERN_SMALL && kern_ipm_open(&ipm, m, p, q))
        interior = &ipm;
    else
        status = kern_model_whole(m, p, q);
    if (status != KERN_OK)
        return status;
    if (!interior)
        kern_part_set(p, q);

    status = kern_repose_rounds(r, interior, limit, way);
    if (kern_repose_leaves(r))
        *way = KERN_INFINITY;
    return kern_call_status(
        m->task,
        status == KERN_NO_SPACE && !kern_model_has_room(m) ? status : KERN_OK);
}

/* Returns the angle by which both blocks of a contact have turned [rad]: the
   smaller angle, or 0 if they have turned to different sides. */
static kern_real kern_repose_turn(const kern_repose *r, const kern_contact *c)
{
    const kern_real a = r->motion[c->a].spin, b = r->motion[c->b].spin;
    return a * b > 0 ? (kern_abs(a) < kern_abs(b) ? a : b) : KERN_R(0);
}

/* Keeps the contact points whose gap is at most `closed`: both ends of a line,
   or one end as a point. Turns their normals by `turns` times the angle by
   which their blocks have turned. Returns the number of points. */
static int kern_repose_close(const kern_repose *r, kern_contact *contact,
                             kern_real closed, kern_real turns)
{
    int i, line = 0, n = 0;
    for (i = 0; i < r->call.m.s->contacts; i++) {
        if (r->stretch[i] > 0)
            line = r->stretch[i] > 1
                && kern_max(r->gap[i], r->gap[i + 1]) <= closed;
        if (r->gap[i] <= closed) {
            const kern_vec normal = contact[i].n;
            const kern_real turn = turns * kern_repose_turn(r, &contact[i]);
            contact[n] = contact[i];
            contact[n].n = kern_vec_unit(
                kern_vec_step(normal, turn, kern_vec_turn(normal)));
            contact[n++].line = line;
        }
    }
    kern_contact_travels(contact, n);
    return n;
}

/* ---- certainty ---- */

/* Shrinks the kerns of n contacts by `by` times the errors of place of the
   options (KERN_ERRORS), and turns the edges of their cones inward by `by`
   times the errors of angle (KERN_ERROR_CONE). If `by` is negative, kerns grow
   and cones widen. */
static void kern_contacts_err(kern_contact *c, int n, const kern_options *o,
                              kern_real by)
{
    const kern_real turn = by * KERN_ERROR_CONE * o->pose_turn;
    for (; n-- > 0; c++) {
        kern_real rate;
        const kern_real shift = kern_shift(
            c->travel, by * KERN_ERRORS * o->pose_error, 0, &rate);
        c->p = kern_vec_step(c->p, shift, kern_vec_turn(c->n));
        c->travel -= shift;
        c->mu = kern_max(c->mu - turn, KERN_R(0))
              / kern_max(1 + c->mu * turn, KERN_CONE_LEAST);
    }
}

/* Subtracts the work of the last call from the limit. Returns the status of
   that call, or KERN_LIMIT if nothing of the limit remains. */
static kern_status kern_limit_subtract(kern_task *task, kern_status status)
{
    task->options.limit -= task->work->units;
    task->work->units = status >= KERN_UNDECIDED && task->options.limit == 0;
    return task->work->units ? KERN_LIMIT : status;
}

/* Writes the contacts for `high` to contact[0..room). These are the contacts of
   the task. If the structure falls (`margin` is 0), they are also all contacts
   of edges and corners within twice the errors, and *options receives the
   options for these errors. Returns the number of contact points, or a negative
   status. */
KERN_SHARED static int kern_contacts_upper(const kern_task *task,
                                           kern_real margin,
                                           kern_options *options,
                                           kern_contact *contact, int room)
{
    int i, n = 0;
    if (!(margin > 0)) {
        *options = kern_measured_options(options, 2 * options->pose_error,
                                         2 * options->pose_turn);
        n = kern_search_run(task->s.block, task->s.blocks, options, contact,
                            room - task->s.contacts, task->work, 0,
                            KERN_SEARCH_EDGES);
    }
    for (i = 0; n >= 0 && i < task->s.contacts; i++)
        contact[n++] = task->s.contact[i];

    /* Makes two points of each point that does not move, since it may lie to
       either side of its place. Their travels are negligible, but the signs tell
       kern_contacts_err() to which side each of them moves. */
    for (i = n - 1; i >= 0; i--)
        if (!(kern_abs(contact[i].travel) > 0)) {
            if (n == room)
                return (int)KERN_NO_SPACE;
            contact[n] = contact[i];
            contact[n++].travel = -KERN_EPS * task->options.pose_error;
            contact[i].travel = KERN_EPS * task->options.pose_error;
        }
    return n;
}

/* Returns what is wrong with the arguments of kern_certain(). */
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
    return task->s.contacts > room || task->work->reals < 9 * task->s.blocks
             ? KERN_NO_SPACE
             : KERN_OK;
}

/* The bed of a block and the force on it: the weights and loads of the block
   and of those that stand on it alone. */
typedef struct kern_bed {
    kern_vec force;   /* [N]                                                  */
    kern_real torque; /* of the force about the block's centre [N m]          */
    kern_real lift;   /* sum over the blocks: force, times the vector from the
                         centre of this block to that of the other [N m]      */
    int end[2];       /* contact points farthest to either side; KERN_OUT:
                         none                                                 */
    int held;         /* bits: 1, 2: another block holds it on that side;
                         4: it stands on several blocks                       */
    int carrier;      /* block that carries it, or one of these; KERN_OUT:
                         none                                                 */
} kern_bed;

/* Returns 1 if the stretch that begins at contact point c has a bump. Its gap
   is computed at KERN_ROCK_PLACES - 1 places. A bump is a place with a smaller
   gap than the mean of the places before and after it. The ends of the stretch
   are left out, since overlaps look smaller at corners. */
static int kern_bed_bump(const kern_task *task, const kern_contact *c)
{
    const kern_vec step = kern_vec_scale(kern_vec_turn(c->n),
                                         2 * c->travel / KERN_ROCK_PLACES);
    kern_real gap = KERN_R(0), rise = KERN_R(0);
    kern_contact at = *c;
    int i, bump = 0;
    for (i = 1; i < KERN_ROCK_PLACES; i++) {
        kern_real next;
        at.p = kern_vec_add(at.p, step);
        next = kern_repose_gap(&task->s, &at) - gap;
        bump |= i > 2
             && next - rise > KERN_ROCK_BUMP * task->options.pose_error;
        rise = next;
        gap += next;
    }
    return bump;
}

/* Returns 1 if a block may topple over the end of its bed on side k. Suppose
   that this end lacks support by `lack`. The block falls until the gap at the
   end closes, and the impact is taken to lose no energy. Let the force have the
   magnitude 1, h be the height of the centre above the end along the force, c
   the distance of the line of the force from the end, and n the share of the
   force along the normal there. To first order the fall frees the energy
   n lack, whichever point the block turns about. To topple, the block must rise
   by c^2 / (2 h). So it stays if 2 h n lack <= c^2.

   `lack` is the measured gap at the end plus `extra` / 2. A stretch longer than
   half of the bed that has a bump may hide more: the measured gap plus
   KERN_ROCK_LACK times `extra`. If such a stretch has no bump, only the end
   that is farther from the line of the force is tested. If the line of the
   force passes beyond the bed, other blocks hold the block, which the verdict
   tests. */
static int kern_bed_topples(const kern_task *task, const kern_bed *b,
                            kern_vec centre, int k, kern_real extra)
{
    const kern_contact *c = task->s.contact + b->end[k];
    const kern_vec arm = kern_vec_sub(c->p, centre);
    const kern_vec bed = kern_vec_sub(task->s.contact[b->end[!k]].p, c->p);

    /* Finds where the line of the force meets the bed, as a share of the bed
       from this end on: there the moment of the force is 0. */
    const kern_real moment = b->torque + kern_vec_cross(b->force, arm);
    const kern_real line = -moment / kern_vec_cross(b->force, bed);

    const int hides = 2 * kern_abs(c->travel)
                    > kern_max(line, KERN_R(0.5)) * kern_vec_length(bed);
    const int bump = hides && kern_bed_bump(task, c);
    const kern_real lack = kern_max(kern_repose_gap(&task->s, c), KERN_R(0))
                         + (bump ? KERN_ROCK_LACK : KERN_R(0.5)) * extra;
    return line > 0 && line < 1 && (!hides || bump || 2 * line >= 1)
        && 2 * (kern_vec_dot(b->force, arm) - b->lift) * lack
                   * kern_abs(kern_vec_dot(b->force, c->n))
               > moment * moment;
}

/* Marks block i as held on these sides if block `by` is fixed or has at least
   half of its mass. */
static void kern_bed_hold(kern_bed *bed, const kern_block *block, int i,
                          int sides, int by)
{
    if (block[by].fixed || 2 * block[by].mass >= block[i].mass)
        bed[i].held |= sides;
}

/* Finds the ends of all beds, the carrier of each block, and which blocks hold
   it. A neighbour on which the block leans holds it on that side. A block that
   it carries together with a third block holds it on both sides. */
static void kern_bed_find(kern_bed *bed, const kern_structure *s)
{
    const kern_vec down = kern_vec_unit(s->gravity);
    int i, k;
    kern_zero(bed, 9 * s->blocks);
    for (i = 0; i < s->blocks; i++)
        bed[i].carrier = bed[i].end[0] = bed[i].end[1] = KERN_OUT;
    for (i = 0; i < s->contacts; i++) {
        const kern_contact *c = s->contact + i;
        const kern_real press = kern_vec_dot(c->n, down);
        const int on = press < 0 ? c->b : c->a, under = c->a + c->b - on;
        kern_bed *b = bed + on;

        /* A steep contact is a side: its blocks hold each other. */
        if (kern_abs(press) < KERN_ROCK_STEEP) {
            k = 1 + (kern_vec_cross(down, c->n) > 0);
            kern_bed_hold(bed, s->block, c->a, k, c->b);
            kern_bed_hold(bed, s->block, c->b, 3 - k, c->a);
            continue;
        }

        /* Blocks that carry a third one together are held by it. */
        if (b->carrier != KERN_OUT && b->carrier != under) {
            kern_bed_hold(bed, s->block, b->carrier, 3, on);
            kern_bed_hold(bed, s->block, under, 3, on);
            b->held |= 4;
        }
        b->carrier = under;

        /* The bed ends where its contact points are farthest. */
        for (k = 0; k < 2; k++)
            if (b->end[k] == KERN_OUT
                || (kern_vec_cross(down,
                                   kern_vec_sub(c->p, s->contact[b->end[k]].p))
                    > 0)
                       == k)
                b->end[k] = i;
    }
}

/* Adds the weight and the load of block i to the force on its bed, and while it
   is not held on both sides, to that of the block on which it stands alone: a
   tower moves as one body. */
static void kern_bed_load(kern_bed *bed, const kern_structure *s, int i)
{
    const kern_block *b = s->block + i;
    int steps;
    for (steps = 0; steps < s->blocks && i != KERN_OUT && !s->block[i].fixed;
         steps++) {
        const kern_vec arm = kern_vec_sub(b->centre, s->block[i].centre);
        const kern_vec force = kern_vec_step(
            kern_vec_make(b->load.fx, b->load.fy), b->mass, s->gravity);
        kern_bed *on = bed + i;
        on->force = kern_vec_add(on->force, force);
        on->torque += b->load.torque + kern_vec_cross(arm, force);
        on->lift += kern_vec_dot(arm, force);
        i = on->held > 2 ? KERN_OUT : on->carrier; /* bits: both sides, or 4 */
    }
}

/* Returns 1 if a block, with those that stand on it alone, may topple by its
   own speed over an end of its bed. The work memory is long enough. */
static int kern_certain_rocks(const kern_task *task, kern_real extra)
{
    const kern_structure *s = &task->s;
    kern_bed *bed;
    int i, rocks = 0;
    kern_take take;
    kern_take_open(&take, task->work);
    bed = (kern_bed *)(void *)kern_take_reals(&take, 9 * s->blocks);
    kern_bed_find(bed, s);
    for (i = 0; i < s->blocks; i++)
        kern_bed_load(bed, s, i);

    /* Tests at both ends of each bed whether the block topples over this end,
       unless another block holds it on that side. */
    for (i = 0; i < 2 * s->blocks && !rocks; i++)
        rocks = bed[i / 2].end[0] >= 0 && !(bed[i / 2].held & (1 + i % 2))
             && kern_bed_topples(task, bed + i / 2, s->block[i / 2].centre,
                                 i % 2, extra);
    return rocks;
}

/* Finds the stretches and lets the blocks settle on them. Every second stretch,
   beginning with number `part`, is open by more than was measured. With `kind`
   KERN_SEARCH_SURE every third stretch is open, all stretches are shorter by
   the error, and all measured gaps are taken as 0. Raises *way to the way of
   this settling, or to KERN_INFINITY if the way is longer than allowed or if a
   block may topple by its own speed. Writes the contact points that are closed
   afterwards to contact[0..room). They become the contacts of the task. */
KERN_SHARED static kern_status kern_certain_rest(kern_task *task,
                                                 kern_search_kind kind,
                                                 int part, kern_real *way,
                                                 kern_contact *contact,
                                                 int room)
{
    kern_structure *s = &task->s;
    const kern_options *o = &task->options;
    const int sure = kind == KERN_SEARCH_SURE;
    const kern_real size = kern_mean_size(s->block, s->blocks);
    const kern_real extra = sure
                              ? o->gap + KERN_ERRORS * o->pose_turn * size / 2
                              : KERN_LOW_OPEN * o->pose_error;
    const kern_real limit = KERN_DOUBT_MOST / KERN_DOUBT_TELLS * size;
    kern_real moved;
    kern_repose r;
    kern_status status;

    /* Finds the stretches. Ends if a block may rock. */
    s->contacts = kern_search_run(s->block, s->blocks, o, contact, room,
                                  task->work, 0, kind);
    if (s->contacts < 0)
        return (kern_status)s->contacts;
    moved = sure && part == 0 && kern_certain_rocks(task, extra) ? KERN_INFINITY
                                                                 : KERN_R(0);
    status = kern_limit_subtract(task, kern_call_status(task, KERN_OK));
    *way = kern_max(*way, moved);
    if (status != KERN_OK || moved > 0)
        return status;

    /* Lets the blocks settle, for the lower end as far as they do. */
    if (sure)
        kern_contacts_err(contact, s->contacts, o, 1);
    status = kern_repose_begin(&r, task);
    if (status == KERN_OK) {
        kern_repose_open(&r, part, sure ? KERN_DOUBT_PARTS : KERN_LOW_PARTS,
                         extra, KERN_R(!sure));
        status = kern_repose_settle(&r, sure ? limit : KERN_INFINITY, &moved);
    }
    status = kern_limit_subtract(task, status);
    if (status != KERN_OK)
        return status;
    *way = kern_max(*way, moved <= limit ? moved : KERN_INFINITY);
    s->contacts = kern_repose_close(&r, contact,
                                    KERN_SETTLE_CLOSED * o->pose_error
                                        + KERN_R(!sure) * KERN_GAP_SHARE * size,
                                    KERN_R(sure));
    return KERN_OK;
}

/* Returns the lower end: the smallest of `margin` and of the margins on what is
   closed once the blocks have settled, less what the error takes. Raises *way
   to how far they settled. */
static kern_real kern_certain_low(kern_task *variant, kern_real margin,
                                  kern_real *way, kern_contact *contact,
                                  int room, kern_status *status)
{
    const kern_real e = variant->options.pose_error;
    const kern_real share = e
                          / kern_mean_size(variant->s.block, variant->s.blocks);
    kern_real low = margin;
    kern_margin m;
    int part;
    for (part = 0; part < KERN_LOW_PARTS && low > 0; part++) {
        *status = kern_certain_rest(variant, KERN_SEARCH_STRETCHES, part, way,
                                    contact, room);
        if (*status >= KERN_UNDECIDED)
            *status = kern_limit_subtract(variant,
                                          kern_measure(variant, &m, NULL));
        low = *status == KERN_STANDS ? kern_min(low, m.holds) : KERN_R(0);
    }
    return low
         / (1
            + KERN_LOW_LOSS * share
                  * kern_min(share / KERN_LOW_WIDE, KERN_R(1)));
}

/* Returns how far the blocks may settle: as far as for the lower end, `way`, or
   farther if the gaps of sure stretches were measured too small. Returns
   KERN_INFINITY if that is too far, if a block may topple by its own speed, or
   if the blocks do not stand on the stretches that are closed then. */
static kern_real kern_certain_way(kern_task *variant, kern_real way,
                                  kern_contact *contact, int room,
                                  kern_status *status)
{
    int part;
    for (part = 0; part < KERN_DOUBT_PARTS && *status == KERN_STANDS
                   && way < KERN_INFINITY;
         part++) {
        *status = kern_certain_rest(variant, KERN_SEARCH_SURE, part, &way,
                                    contact, room);
        if (*status >= KERN_UNDECIDED && way < KERN_INFINITY)
            *status = kern_limit_subtract(variant,
                                          kern_verdict(variant, 0, NULL));
    }
    return *status == KERN_STANDS ? KERN_DOUBT_TELLS * way : KERN_INFINITY;
}

/* Writes to *high a shrinkage at which the task is proven to fall, near the
   first one. If there is none, writes the shrinkage that closes all kerns. */
KERN_SHARED static kern_status kern_certain_high(const kern_task *task,
                                                 kern_real *high)
{
    kern_call c;
    kern_path *const path = &c.path;
    kern_real range[2];
    kern_status status = kern_call_open(&c, task, 0, high);
    *high = KERN_INFINITY;
    if (status != KERN_OK)
        return status;

    /* Searches as if the verdict changed only once, without a walk. */
    kern_is_nested(&c.m, range);
    path->end = range[1];
    status = kern_call_status(task, kern_path_search(&c.m, path, 0));
    *high = path->never_falls ? range[1]
                              : kern_min(path->proven.high, range[1]);
    return status;
}

KERN_API kern_status kern_certain(const kern_task *task, kern_real margin,
                                  kern_interval *out, kern_contact *contact,
                                  int room)
{
    kern_task variant;
    kern_real way, high;
    int i;
    kern_status status = kern_certain_check(task, margin, out, contact, room);
    if (status != KERN_OK)
        return status;
    out->high = out->settles = KERN_INFINITY;
    variant = kern_task_of(task->s.block, task->s.blocks, contact, 0,
                           task->work);
    variant.s.gravity = task->s.gravity;
    variant.options = task->options;
    variant.options.limit = kern_limit_of(task->options.limit);

    /* stretches are found anew, with the least friction of the contacts */
    for (i = 0; i < task->s.contacts; i++)
        variant.options.mu = kern_min(variant.options.mu,
                                      task->s.contact[i].mu);

    /* low: less than the margins of the blocks where they come to rest,
       after a way that is no shorter than a stretch may be open */
    way = KERN_LOW_OPEN * variant.options.pose_error;
    out->low = kern_certain_low(&variant, margin, &way, contact, room, &status);

    /* what stands for certain comes to rest on sure stretches, too */
    if (out->low > 0)
        out->settles = kern_certain_way(&variant, way, contact, room, &status);

    /* high: longer kerns and wider cones; of what falls all that may exist */
    if (status >= KERN_UNDECIDED && variant.s.contacts >= 0) {
        variant.options.mu = task->options.mu;
        variant.s.contacts = kern_contacts_upper(task, margin, &variant.options,
                                                 contact, room);
        kern_contacts_err(contact, variant.s.contacts, &task->options, -1);
        status = kern_certain_high(&variant, &high);
        out->high = status == KERN_STANDS || status == KERN_LIMIT
                      ? kern_max(high, margin)
                  : status == KERN_FALLS ? margin /* not nested, if above 0 */
                                         : KERN_INFINITY;
        if (status >= KERN_UNDECIDED && (status != KERN_FALLS || margin > 0))
            status = out->settles < KERN_INFINITY ? KERN_STANDS : KERN_OK;
    }

    /* the work of all calls together */
    task->work->units += kern_limit_of(task->options.limit)
                       - variant.options.limit;
    return variant.s.contacts < 0 ? (kern_status)variant.s.contacts : status;
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
    o.limit = 10000000; /* units: one second or two */
    o.relative = 0;
    o.gap = o.epsilon = o.overlap = o.pose_error = o.pose_turn = KERN_R(0);
    o.narrow = o.reserve = o.lone.x = o.lone.y = KERN_R(0);
    return o;
}

/* Returns *options, or the defaults for NULL. */
KERN_SHARED static kern_options kern_options_of(const kern_options *options)
{
    return options ? *options : kern_defaults();
}

KERN_API kern_options kern_measured_options(const kern_options *options,
                                            kern_real e, kern_real theta)
{
    kern_options o = kern_options_of(options);
    o.pose_error = e > 0 ? e : KERN_R(-1); /* -1: every call refuses it */
    o.pose_turn = theta;
    o.gap = KERN_ERROR_GAP * KERN_ERRORS * e;
    o.angle = kern_max(KERN_ANGLE, KERN_ERROR_ANGLE * KERN_ERRORS * theta);
    o.angle = kern_min(o.angle, KERN_ANGLE_SHARE * KERN_ANGLE_MOST);
    o.overlap = kern_max(o.overlap, KERN_ERROR_OVERLAP * e);
    return o;
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

#if defined(__cplusplus) && defined(__GNUC__)
#pragma GCC diagnostic pop
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
          takes the margin and fills in a kern_interval, with how far blocks
          may settle. kern_known and kern_plan have fewer fields. options.limit
          is 10,000,000, was 0. More is refused (>>api). New:
          kern_outline_simplify(), kern_stays(), kern_plan_stays(),
          kern_raised_load(), kern_stretches(), options.reserve, .lone,
          KERN_NO_INTERIOR, kern_rest(), kern_place_compare(), kern_plan_copy().
          kern_status_text() takes an int.
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
