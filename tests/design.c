/* design.c: the examples of three stones of tests/DESIGN.md, by the library

       cc -O2 -ffp-contract=off -o design tests/design.c -lm && ./design

   Every number that an example works out by hand is compared with what the
   library returns. A number that differs is printed with its section: then the
   page, or the library, is wrong. All stones are boxes, friction is 0.4 and
   gravity (0, -1), so that a weight is a mass.

   SPDX-License-Identifier: MIT */

#define KERN_STATIC
#define KERN_IMPLEMENTATION
#define main algorithm1_main
#include "../examples/copy/algorithm1.c"
#undef main

#define MOST_BLOCKS 6
#define MOST_CONTACTS 40
#define DIGITS 1e-4 /* half of the last digit that the page prints        */

struct box {
    double mass; /* 0: fixed                                              */
    double left, low, right, high;
};

/* An example, with all that its questions need. */
struct example {
    const char *section;
    kern_vec corner[MOST_BLOCKS][4];
    kern_block block[MOST_BLOCKS];
    kern_contact contact[MOST_CONTACTS];
    kern_force force[MOST_CONTACTS];
    kern_motion motion[MOST_BLOCKS];
    kern_real real[KERN_REALS(MOST_BLOCKS, MOST_CONTACTS)];
    int index[KERN_INTS(MOST_BLOCKS, MOST_CONTACTS)];
    kern_work work;
    kern_task task;
    kern_proof proof;
};

static int checks, wrong;

/* Counts a number, and prints it if it is off by more than its digits. */
static void check(const struct example *e, const char *what, double got,
                  double want)
{
    checks++;
    if (fabs(got - want) <= DIGITS)
        return;
    wrong++;
    printf("%s: %s is %.9g, the page says %g\n", e->section, what, got, want);
}

/* Makes the blocks from boxes and finds their contacts. */
static void open_example(struct example *e, const char *section,
                         const struct box *box, int boxes)
{
    int i;
    e->section = section;
    e->work = kern_work_of(e->real, KERN_REALS(MOST_BLOCKS, MOST_CONTACTS),
                           e->index, KERN_INTS(MOST_BLOCKS, MOST_CONTACTS));
    for (i = 0; i < boxes; i++, box++) {
        kern_vec *v = e->corner[i];
        v[0].x = v[3].x = box->left;
        v[1].x = v[2].x = box->right;
        v[0].y = v[1].y = box->low;
        v[2].y = v[3].y = box->high;
        if (box->mass > 0) {
            kern_block_init(&e->block[i], v, 4, 1, NULL);
            e->block[i].mass = box->mass;
        } else
            kern_ground_init(&e->block[i], v, 4, NULL);
    }
    e->task = kern_task_of(e->block, boxes, e->contact, 0, &e->work);
    e->task.s.gravity.y = -1;
    e->task.s.contacts = kern_contacts(e->block, boxes, &e->task.options,
                                       e->contact, MOST_CONTACTS, &e->work);
    e->proof.force = e->force;
    e->proof.motion = e->motion;
}

/* Returns the index of the contact point of two blocks at (x, y). */
static int contact_near(const struct example *e, int a, int b, double x,
                        double y)
{
    int i;
    for (i = 0; i < e->task.s.contacts; i++) {
        const kern_contact *c = &e->contact[i];
        if (c->a == a && c->b == b && fabs(c->p.x - x) < DIGITS
            && fabs(c->p.y - y) < DIGITS)
            return i;
    }
    printf("%s: no contact at (%g, %g)\n", e->section, x, y);
    wrong++;
    return 0;
}

/* ---- left, right, beam: sections 1 to 3, 6 and 8 ---- */

static const struct box three[] = {
    {0, -3, -1, 6, 0},
    {1, -1, 0, 0, 1},
    {1, 1, 0, 2, 1},
    {3, -1, 1, 4.2, 1.5},
};

/* The two columns of the contact point (2, 1), in units of 1. */
static void equations(struct example *e)
{
    static kern_real matrix[2 * MOST_CONTACTS * 3 * MOST_BLOCKS];
    static kern_real rhs_of[3 * MOST_BLOCKS];
    static int first[MOST_BLOCKS];
    struct equation5 q = {first, 0, matrix, rhs_of, NULL, NULL, 1, 1};
    const kern_real *column;
    write_weights(&q, &e->task.s);
    q.length = 1;
    write_columns(&q, &e->task.s, 0, 0);
    column = q.a + 2 * contact_near(e, 2, 3, 2, 1) * q.rows;
    check(e, "rows", q.rows, 9);
    check(e, "columns", 2 * e->task.s.contacts, 16);
    check(e, "force x on the beam", column[first[3]], -0.4);
    check(e, "force y on the beam", column[first[3] + 1], 1);
    check(e, "torque on the beam", column[first[3] + 2], 0.3);
    check(e, "force x on the right stone", column[first[2]], 0.4);
    check(e, "force y on the right stone", column[first[2] + 1], -1);
    check(e, "torque on the right stone", column[first[2] + 2], -0.7);
}

static void passed_forces(struct example *e)
{
    static const struct {
        int a, b;
        double x, y, f;
    } want[] = {
        {1, 3, -1, 1, 0},  {1, 3, 0, 1, 0.1},  {2, 3, 1, 1, 1},
        {2, 3, 2, 1, 1.9}, {0, 1, -1, 0, 0.5}, {0, 1, 0, 0, 0.6},
        {0, 2, 1, 0, 1.5}, {0, 2, 2, 0, 2.4},
    };
    int i;
    e->section = "6. The top-down pass";
    check(e, "verdict", kern_verdict(&e->task, 0, &e->proof), KERN_STANDS);
    for (i = 0; i < 8; i++)
        check(e, "force",
              e->force[contact_near(e, want[i].a, want[i].b, want[i].x,
                                    want[i].y)]
                  .normal,
              want[i].f);
}

static void beam(struct example *e)
{
    kern_real factor;
    kern_margin m;
    open_example(e, "1. The equations", three, 4);
    equations(e);
    e->section = "2. One program for each step";
    e->task.options.epsilon = 0.15;
    kern_measure(&e->task, &m, NULL);
    check(e, "level", m.level, 3);
    check(e, "margin", m.margin, 0.4);
    e->section = "3. What a proof is";
    check(e, "verdict", kern_verdict(&e->task, 0.45, &e->proof), KERN_FALLS);
    check(e, "vx", e->motion[3].vx, 0.1550);
    check(e, "vy", e->motion[3].vy, -0.0310);
    check(e, "spin", e->motion[3].spin, -0.6202);
    check(e, "verdict at 0.4 + 5e-10",
          kern_verdict(&e->task, 0.4 + 5e-10, NULL), KERN_FALLS);
    check(e, "verdict at 0.4 + 1e-10",
          kern_verdict(&e->task, 0.4 + 1e-10, NULL), KERN_STANDS);
    passed_forces(e);
    e->section = "8. The simplex method";
    kern_load_factor(&e->task, 0, KERN_RIGHT, &factor, NULL);
    check(e, "load factor", factor, 0.4);
}

/* ---- the others ---- */

static void jam(struct example *e)
{
    static const struct box box[] = {
        {0, -1, -1, 0, 2}, {0, 3, -1, 4, 2}, {1, 0, 0, 1, 1},
        {1, 1, 0, 2, 1},   {1, 2, 0, 3, 1},
    };
    kern_margin m;
    open_example(e, "3. What a proof is, three cubes", box, 5);
    kern_measure(&e->task, &m, NULL);
    check(e, "holds up to the bound", m.holds <= 0.5 - 6.667e-7, 1);
    check(e, "falls beyond it", m.fails >= 0.5 - 6.667e-7, 1);
    check(e, "width of the bracket", m.fails - m.holds, 0);
    check(e, "forces exist", kern_verdict(&e->task, 0, NULL), KERN_STANDS);
}

static void tower(struct example *e)
{
    static const struct box box[] = {
        {0, -3, -1, 6, 0},
        {1, 0, 0, 1, 1},
        {1, 0.2, 1, 1.2, 2},
        {1, 0.5, 2, 1.5, 3},
    };
    kern_margin m;
    open_example(e, "4. Newton's method, 5. Bodies first", box, 4);
    kern_measure(&e->task, &m, NULL);
    check(e, "margin", m.margin, 0.15);
    check(e, "level", m.level, 8);
    check(e, "verdict at 0.5", kern_verdict(&e->task, 0.5, &e->proof),
          KERN_FALLS);
    check(e, "spin of C at 0.5", e->motion[3].spin, -1);
    check(e, "spin of B at 0.5", e->motion[2].spin, 0);
    check(e, "verdict at 0.19", kern_verdict(&e->task, 0.19, &e->proof),
          KERN_FALLS);
    check(e, "spins of B and C at 0.19", e->motion[2].spin - e->motion[3].spin,
          0);
    check(e, "spin of A at 0.19", e->motion[1].spin, 0);
}

static void cluster(struct example *e)
{
    static const struct box box[] = {
        {0, -4, -1, 6, 0},  {0, -4, 0, -2.5, 1.5}, {1, 0, 0, 1, 1},
        {4, -1, 1, 4, 1.5}, {2, -3, 1.5, -0.5, 2}, {1, 4.5, 0, 5.5, 1},
    };
    double on_arm = 0, on_pier = 0;
    int at[4];
    open_example(e, "7. Clusters", box, 6);
    at[0] = contact_near(e, 3, 4, -1, 1.5);
    at[1] = contact_near(e, 3, 4, -0.5, 1.5);
    at[2] = contact_near(e, 2, 3, 0, 1);
    at[3] = contact_near(e, 2, 3, 1, 1);
    check(e, "verdict", kern_verdict(&e->task, 0, &e->proof), KERN_STANDS);
    on_arm = e->force[at[0]].normal + e->force[at[1]].normal;
    on_pier = e->force[at[2]].normal + e->force[at[3]].normal;
    check(e, "force on the arm", on_arm, 1.2269);
    check(e, "of that at its end", e->force[at[0]].normal, 1.2269);
    check(e, "place on the pier", e->force[at[3]].normal / on_pier, 0.8990);
}

static void cubes(struct example *e)
{
    static const struct box box[] = {
        {0, -3, -1, 6, 0},
        {1, 0, 0, 1, 1},
        {1, 0, 1, 1, 2},
        {1, 0, 2, 1, 3},
    };
    kern_real factor;
    open_example(e, "9. The interior point, 10. The value as a column", box, 4);
    kern_verdict(&e->task, 0, &e->proof);
    check(e, "top joint", 2 * e->force[contact_near(e, 2, 3, 0, 2)].normal, 1);
    check(e, "middle", 2 * e->force[contact_near(e, 1, 2, 0, 1)].normal, 2);
    check(e, "base", 2 * e->force[contact_near(e, 0, 1, 0, 0)].normal, 3);
    kern_load_factor(&e->task, 0, KERN_RIGHT, &factor, NULL);
    check(e, "load factor", factor, 1.0 / 3);
}

/* Asks whether the weights and a push to the right on each stone are raised. */
static int is_raised(struct example *e, double push)
{
    kern_raising raising = KERN_NOT_SHOWN;
    int i;
    for (i = 0; i < e->task.s.blocks; i++)
        e->block[i].load.fx = e->block[i].fixed ? 0 : push;
    kern_raised(&e->task, 0, &raising, NULL, &e->proof);
    return raising == KERN_RAISED;
}

static void slot(struct example *e)
{
    static const struct box box[] = {
        {0, -1, -1, 12, 0}, {0, -1, 1, 12, 2}, {1, 0, 0, 2, 1},
        {1, 3, 0, 5, 1},    {1, 6, 0, 8, 1},
    };
    kern_real factor = 0;
    open_example(e, "11. Raised forces, slot", box, 5);
    kern_load_factor(&e->task, 0, KERN_RIGHT, &factor, NULL);
    check(e, "any load factor", factor > 1e30, 1);
    kern_raised_load(&e->task, 0, KERN_RIGHT, NULL, &factor, NULL);
    check(e, "raised load", factor, 0.4);
    check(e, "raised at 0.39", is_raised(e, 0.39), 1);
    check(e, "raised at 0.41", is_raised(e, 0.41), 0);
}

/* Returns the force of a joint between two stones, along its normal. */
static double joint(const struct example *e, int a, int b, double x)
{
    return e->force[contact_near(e, a, b, x, 0)].normal
         + e->force[contact_near(e, a, b, x, 1)].normal;
}

static void row_of_stones(struct example *e)
{
    static const struct box box[] = {
        {0, -1, -1, 8, 0}, {0, 6, 0, 7, 1}, {1, 0, 0, 2, 1},
        {1, 2, 0, 4, 1},   {1, 4, 0, 6, 1},
    };
    open_example(e, "11. Raised forces, row", box, 5);
    check(e, "raised", is_raised(e, 0.5), 1);
    check(e, "A on B", joint(e, 2, 3, 2), 0.1190);
    check(e, "B on C", joint(e, 3, 4, 4), 0.2247);
    check(e, "C on the wall", joint(e, 1, 4, 6), 0.3571);
}

/* Returns 100 times the gap of the contact point of two blocks at (x, y). */
static double gap_near(const struct example *e, const kern_repose *r, int a,
                       double x, double y)
{
    return 100 * r->gap[contact_near(e, a, 3, x, y)];
}

/* The right stone is lower by 0.003. Lengths are compared in hundredths. */
static void settling(struct example *e)
{
    static const struct box box[] = {
        {0, -3, -1, 6, 0},
        {1, -1, 0, 0, 1},
        {1, 1, 0, 2, 0.997},
        {3, -1, 1, 4.2, 1.5},
    };
    kern_repose r;
    kern_real way = 0;
    open_example(e, "12. Settling", box, 4);
    e->task.options.gap = 0.004;
    e->task.options.pose_error = 0.001;
    e->task.s.contacts = kern_contacts(e->block, 4, &e->task.options,
                                       e->contact, MOST_CONTACTS, &e->work);
    check(e, "contact points", e->task.s.contacts, 8);
    check(e, "begins", kern_repose_begin(&r, &e->task), KERN_OK);
    kern_repose_open(&r, 0, 1, 0, 1);
    check(e, "gap at (2, 1)", gap_near(e, &r, 2, 2, 0.9985), 0.3);
    check(e, "settles", kern_repose_settle(&r, 1, &way), KERN_OK);
    check(e, "the beam turns by", 100 * r.motion[3].spin, -0.15);
    check(e, "the beam sinks by", 100 * r.motion[3].vy, -0.24);
    check(e, "its energy", 3 * 100 * r.motion[3].vy, -0.72);
    check(e, "closed gap at (2, 1)", gap_near(e, &r, 2, 2, 0.9985), 0);
    check(e, "closed gap at (0, 1)", gap_near(e, &r, 1, 0, 1), 0);
    check(e, "open gap at (1, 1)", gap_near(e, &r, 2, 1, 0.9985), 0.15);
}

int main(void)
{
    static struct example e;
    beam(&e);
    jam(&e);
    tower(&e);
    cluster(&e);
    cubes(&e);
    slot(&e);
    row_of_stones(&e);
    settling(&e);
    printf("%d numbers of tests/DESIGN.md, %d differ\n", checks, wrong);
    return wrong > 0;
}
