/* verdict.h - calls of the library, each answer verified with twin.h and
   tableau.h. */

#ifndef UNIT_VERDICT_H
#define UNIT_VERDICT_H

#include "harness.h"
#include "worlds.h"
#include "twin.h"
#include "tableau.h"

static kern_force force_of[MAX_POINTS];
static kern_motion motion_of[MAX_BLOCKS];
static kern_real proof_error; /* largest that the library admitted */
static long undecided, asked;

static kern_proof proof_here(void)
{
    kern_proof proof;
    proof.force = force_of;
    proof.motion = motion_of;
    return proof;
}

/* In float the band between the two proofs is wide enough to be met by chance;
   then no verdict is right, if rare (see main()). In double it must not happen.
 */
static int decided(int got)
{
    return got >= 0 || (SINGLE && got == KERN_UNDECIDED);
}

/* The largest of the speeds of the centres and of the spins times the size. */
static double speed_of(const world *w, const kern_motion *motion)
{
    double most = 0;
    int i;
    for (i = 0; i < w->blocks; i++) {
        const double size = sqrt(fabs((double)w->block[i].area));
        most = fmax(most, hypot((double)motion[i].vx, (double)motion[i].vy));
        most = fmax(most, fabs((double)motion[i].spin) * size);
    }
    return most;
}

/* kern_verdict(), its proof checked by the code above and by the header's. */
static int verdict(const world *w, double d)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w);
    const kern_status got = kern_verdict(world_task(w, &work), R(d), &proof);
    d = (double)R(d);
    asked++;
    if (work.error > proof_error)
        proof_error = work.error;
    if (got == KERN_STANDS) {
        CHECK(share_of_forces(w, d, force_of) <= 1.001);
        CHECK(kern_check_forces(world_task(w, &work), R(d), force_of) <= 1);
    } else if (got == KERN_FALLS) {
        CHECK(share_of_motion(w, d, motion_of) <= 1.001);
        CHECK(kern_check_motion(world_task(w, &work), R(d), motion_of) <= 1);
        CHECK_NEAR(speed_of(w, motion_of), 1, 100 * EPS);
    } else if (got == KERN_UNDECIDED)
        undecided++;
    return got;
}

/* Is it an answer without a verdict, or without a level? */
static int unanswered(int got, const kern_margin *m)
{
    return got == KERN_UNDECIDED || (got >= 0 && m->level < 0);
}

/* What a measure promises of a structure that does not stand. */
static void check_fallen(const world *w, const kern_margin *m)
{
    CHECK_INT(m->level, 0);
    CHECK(!(m->margin < 0) && !(m->margin > 0));
    CHECK(!(m->holds < 0) && !(m->holds > 0));
    CHECK(!m->saturated);
    CHECK(share_of_motion(w, 0, motion_of) <= 1.001);
}

/* And of one that stands at any shrinkage. */
static void check_saturated(const kern_margin *m)
{
    /* a quotient that is a whole number may be rounded either way */
    const double steps = (double)m->most / (double)m->epsilon,
                 slip = 8 * fmax(EPS, 1e-10) * steps;
    CHECK_NEAR(m->margin, m->most, 0);
    CHECK_NEAR(m->fails, m->most, 0);
    CHECK((SINGLE && m->level == -1) || m->level == (int)ceil(steps - slip) + 1
          || m->level == (int)ceil(steps + slip) + 1);
}

/* And of one that falls at the end of the bracket. */
static void check_end(const world *w, const kern_margin *m)
{
    const double mean = mean_size(w);
    const double past = (double)m->margin
                      + (SINGLE ? 1e-4 : 1e-6) * fmax((double)m->margin, mean);
    /* forces of GLPK miss more than a proof allows in a wider zone: the bracket
       may grow there to KERN_WIDEST times its width */
    const double wide_as = (SINGLE ? 0.04001
                            : GLPK ? 2.8001e-5
                                   : 2.0001e-6)
                         * (w->options.relative ? 1 : mean);
    CHECK_NEAR(m->fails - m->holds, 0, wide_as);
    CHECK(share_of_motion(w, (double)m->fails, motion_of) <= 1.001
          || share_of_motion(w, past, motion_of) <= 1.001);
    CHECK_NEAR(speed_of(w, motion_of), 1, 100 * EPS);
}

/* Everything that a measure promises about itself, where `work` counted it and
   its proofs are in force_of and motion_of. */
static void check_measure(const world *w, int got, const kern_margin *m,
                          const kern_work *work)
{
    asked++;
    if (work->error > proof_error)
        proof_error = work->error;
    undecided += unanswered(got, m);
    if (got < 0)
        return;
    CHECK_NEAR(m->most, twin_most(w), 8 * EPS * (reach_of(w) + mean_size(w)));
    CHECK(work->error <= 1 && work->solves > 0);
    if (got == KERN_FALLS) {
        check_fallen(w, m);
        return;
    }
    CHECK_INT(got, KERN_STANDS);
    CHECK(m->level >= 1 || (SINGLE && m->level == -1));
    CHECK(m->margin >= 0 && m->margin <= m->most);
    CHECK(m->holds >= 0 && m->holds <= m->margin * (1 + 4 * R(EPS)));
    CHECK(m->fails >= m->margin * (1 - 4 * R(EPS)) || m->saturated);
    CHECK(share_of_forces(w, (double)m->holds, force_of) <= 1.001);
    if (m->saturated)
        check_saturated(m);
    else
        check_end(w, m);
}

/* kern_measure(), checked. */
static int measure(const world *w, kern_margin *m)
{
    const kern_proof proof = proof_here();
    kern_work work = work_of(w);
    int got;
    memset(m, 0, sizeof *m);
    got = kern_measure(world_task(w, &work), m, &proof);
    check_measure(w, got, m, &work);
    return got;
}

/* May both verdicts be right, since the twin cannot tell at d? */
static int open_question(const world *w, double d)
{
    return twin_agrees(w, d, 1) && twin_agrees(w, d, 0);
}

/* The bracket of a measured margin, asked again one verdict at a time. Where it
   ends within the tolerance of the edge both proofs can pass, so either verdict
   is right; none at all is not. */
static void check_bracket(const world *w, const kern_margin *m)
{
    const int holds = verdict(w, (double)m->holds);
    const int fails = m->saturated ? KERN_FALLS : verdict(w, (double)m->fails);
    CHECK(decided(holds) && decided(fails));
    CHECK(holds != KERN_FALLS || open_question(w, (double)m->holds));
    CHECK(fails != KERN_STANDS || m->saturated
          || open_question(w, (double)m->fails));
}

/* Two margins of one structure are alike, or what differs is an open question.
 */
static void same_margin(const world *w, double n, double m, double tol,
                        const char *where)
{
    if (fabs(n - m) > tol && !open_question(w, (n + m) / 2))
        check_near(n, m, tol, where, "margin of the same");
    passed++;
}

/* The same for the levels. One step more or less to closing is a rounding of
   the quotient of most and epsilon. */
static void same_level(const world *w, const kern_margin *m,
                       const kern_margin *n, const char *where)
{
    const double steps = (double)(m->most / m->epsilon);
    const double edge = (n->level < m->level ? n->level : m->level)
                      * (double)m->epsilon;
    const int closing = n->saturated && m->saturated
                     && abs(n->level - m->level) == 1
                     && fabs(steps - floor(steps + 0.5)) < 1e-6;
    if (n->level != m->level && !closing
        && !open_question(w, fmin(edge, (double)m->most)))
        check_near(n->level, m->level, 0, where, "level of the same");
    passed++;
}

/* The answer `now`, n is the answer `got`, m about w, its lengths `scale` times
   as long; or what differs is an open question. */
static void same_answer(const world *w, const kern_margin *m, int got,
                        const kern_margin *n, int now, double scale, double tol,
                        const char *where)
{
    const double unit = w->options.relative ? 1 : mean_size(w);
    const double by = w->options.relative ? 1 : scale;
    if (SINGLE && (unanswered(now, n) || unanswered(got, m)))
        return; /* no answer is like any other */
    if (now != got) {
        if (now < 0 || got < 0 || !open_question(w, 0))
            check_near(now, got, 0, where, "verdict of the same");
        return;
    }
    passed++;
    if (got != KERN_STANDS)
        return;
    same_margin(w, (double)n->margin / by, (double)m->margin, tol * unit,
                where);
    same_level(w, m, n, where);
}

static int load_factor(const world *w, const kern_wrench *pattern, int side,
                       double *factor)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const kern_task *task = world_task(w, &work);
    const int got = pattern ? kern_load_factor_of(task, 0, pattern, &out, NULL)
                            : kern_load_factor(task, 0, side, &out, NULL);
    *factor = (double)out;
    return got;
}

static int tilt(const world *w, int side, double *angle)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const int got = kern_tilt(world_task(w, &work), 0, side, &out, NULL);
    *angle = (double)out;
    return got;
}

static int deficit(const world *w, double *growth)
{
    kern_work work = work_of(w);
    kern_real out = R(-1);
    const int got = kern_deficit(world_task(w, &work), &out);
    *growth = (double)out;
    return got;
}

/* Threshold of a family of structures: build(w, x) stands at `stands` and
   falls at `falls`. */
typedef void (*family)(world *w, double x);

static double threshold(family build, double stands, double falls)
{
    static world w;
    int i, got;
    build(&w, stands);
    CHECK_INT(verdict(&w, 0), KERN_STANDS);
    build(&w, falls);
    CHECK_INT(verdict(&w, 0), KERN_FALLS);
    for (i = 0; i < (SINGLE ? 20 : 40); i++) {
        const double middle = (stands + falls) / 2;
        build(&w, middle);
        got = verdict(&w, 0);
        if (got == KERN_UNDECIDED) {
            /* allowed only where nobody could tell */
            CHECK_NEAR(stands, falls, EDGE);
            undecided--;
            break;
        }
        if (got == KERN_STANDS)
            stands = middle;
        else
            falls = middle;
    }
    return (stands + falls) / 2;
}

#endif
