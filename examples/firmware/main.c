/* A robot's controller asks where to put the next stone.

   From the root of the project:

       arm-none-eabi-gcc -std=c99 -Os -mcpu=cortex-m4 -mthumb -mfloat-abi=hard \
           -mfpu=fpv4-sp-d16 -ffp-contract=off -fno-math-errno \
           -fno-tree-loop-distribute-patterns -ffreestanding -nostdlib \
           -ffunction-sections -fdata-sections -Wl,--gc-sections \
           -T examples/firmware/mps2-an386.ld -o firmware.elf \
           examples/firmware/main.c examples/firmware/board.c
       qemu-system-arm -M mps2-an386 -nographic -icount shift=0 \
           -semihosting-config enable=on,target=native -kernel firmware.elf

   A wall of 30 stones lies in flash. It is measured, then a candidate stone is
   laid in four places on top, and the questions that cost least come first: does
   the structure keep a margin (bears), which margin has it (try), does the stone
   stay (stays)? Only its own contacts are found each time, and each answer starts
   from what is known of the wall. At the end one place is asked again with less
   and less work allowed. All memory is static: 64 KB of RAM hold everything,
   stack included. The library needs nothing but
   a square root, which is an instruction here;
   -fno-tree-loop-distribute-patterns keeps gcc from calling memset() for its
   loops.

   Time is counted by SysTick, since QEMU has no cycle counter (that of the DWT
   reads 0). With -icount shift=0 QEMU takes a nanosecond for an instruction,
   and a tick of the 25 MHz clock is 40 instructions; the ticks then are the
   same in every run. */

#define KERN_SINGLE
#define KERN_SQRT(x) __builtin_sqrtf(x)
#define KERN_IMPLEMENTATION
#include "../../kern.h"

#include "board.h"
#include "wall.h"

enum {
    BLOCKS = WALL_STONES + 2, /* the ground, the wall and the candidate */
    CONTACTS = 160
};

static kern_vec placed[CANDIDATE_VERTICES]; /* the candidate, where tried */
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_motion motion[BLOCKS];
static kern_force force[CONTACTS];
static kern_real reals[KERN_REALS(BLOCKS, CONTACTS)];
static int ints[KERN_INTS(BLOCKS, CONTACTS)];

/* Prints what a call cost: units of work, and ticks. */
static void print_cost(uint32_t start, const kern_work *work)
{
    const int32_t ticks = (int32_t)(board_ticks() - start);
    board_print("; ");
    board_print_int(work->units);
    board_print(" units; ");
    board_print_int(ticks);
    board_print(" ticks\n");
}

/* Prints a margin, or why there is none. */
static void print_margin(kern_status status, const kern_margin *m)
{
    if (status == KERN_STANDS) {
        board_print("level ");
        board_print_int(m->level);
        board_print(", margin ");
        board_print_fixed(m->margin, 4);
        board_print(" m");
    } else
        board_print(kern_status_text(status));
}

/* The ground and the wall, stone by stone. Returns below 0 what went wrong. */
static int build_wall(kern_plan *plan)
{
    kern_block stone;
    kern_fault *fault = &plan->task.work->fault;
    int i, status = kern_ground_init(&stone, ground, 4, fault);
    if (status >= 0)
        status = kern_plan_add(plan, &stone);
    for (i = 0; i < WALL_STONES && status >= 0; i++) {
        status = kern_block_init(&stone, wall[i].vertex, wall[i].vertices,
                                 DENSITY, fault);
        if (status >= 0)
            status = kern_plan_add(plan, &stone);
    }
    return status;
}

/* Makes the candidate, put down `along` its bed. */
static kern_status make_candidate(kern_plan *plan, float along,
                                  kern_block *stone)
{
    int i;
    for (i = 0; i < CANDIDATE_VERTICES; i++) {
        placed[i].x = candidate[i].x + along;
        placed[i].y = candidate[i].y + along * CANDIDATE_SLOPE;
    }
    return kern_block_init(stone, placed, CANDIDATE_VERTICES, DENSITY,
                           &plan->task.work->fault);
}

/* Asks whether a place keeps the margin `least`, which one it has, and whether
   the stone stays. Returns the margin; -1 where one of these says no. */
static float ask_place(kern_plan *plan, float along, float least)
{
    const kern_work *work = plan->task.work;
    uint32_t start = board_ticks();
    kern_block stone;
    kern_margin m;
    float chance = 0;
    kern_status status = make_candidate(plan, along, &stone);
    if (status >= 0)
        status = kern_plan_bears(plan, &stone, least, 0);
    board_print(status == KERN_STANDS  ? "bears "
                : status == KERN_FALLS ? "does not bear "
                                       : kern_status_text(status));
    if (status >= 0) {
        board_print_fixed(least, 4);
        board_print(" m");
    }
    print_cost(start, work);
    if (status != KERN_STANDS)
        return -1;

    start = board_ticks();
    status = kern_plan_try(plan, &stone, &m, 0);
    board_print("                      ");
    print_margin(status, &m);
    print_cost(start, work);
    if (status != KERN_STANDS)
        return -1;

    start = board_ticks();
    status = kern_plan_stays(plan, &stone, &chance);
    board_print("                      stays ");
    if (status == KERN_STANDS)
        board_print_fixed(chance, 2);
    else
        board_print(kern_status_text(status));
    print_cost(start, work);
    return status == KERN_STANDS && chance >= 0.5f ? m.margin : -1;
}

/* Asks for the margin of a place with a limit of work: what is proven by then
   is between which values it lies. */
static void ask_within(kern_plan *plan, float along, float limit)
{
    const uint32_t start = board_ticks();
    kern_block stone;
    kern_margin m;
    kern_status status = make_candidate(plan, along, &stone);
    plan->task.options.limit = limit;
    if (status >= 0)
        status = kern_plan_try(plan, &stone, &m, 0);
    board_print("limit ");
    board_print_int((int32_t)limit);
    board_print(": ");
    if (status == KERN_LIMIT) {
        board_print(m.holds < 0 ? "not known to stand, margin up to "
                                : "margin from ");
        if (!(m.holds < 0)) {
            board_print_fixed(m.holds, 4);
            board_print(" to ");
        }
        board_print_fixed(m.fails, 4);
        board_print(" m");
    } else
        print_margin(status, &m);
    print_cost(start, plan->task.work);
}

static void print_memory(void)
{
    board_print("memory: ");
    board_print_int((int32_t)(sizeof reals + sizeof ints));
    board_print(" bytes of work memory, ");
    board_print_int((int32_t)(sizeof block + sizeof contact + sizeof motion
                              + sizeof force + sizeof placed));
    board_print(" of blocks and contacts,\n        ");
    board_print_int(board_variables());
    board_print(" of variables in all, ");
    board_print_int(board_stack_used());
    board_print(" of ");
    board_print_int(board_stack_size());
    board_print(" of stack, ");
    board_print_int(board_flash());
    board_print(" of flash\n");
}

int main(void)
{
    static const float place[] = {0, 0.2f, 0.4f, -0.3f};
    static const float limit[] = {50, 200, 800, 3200};
    kern_work work = kern_work_of(reals, KERN_REALS(BLOCKS, CONTACTS), ints,
                                  KERN_INTS(BLOCKS, CONTACTS));
    kern_plan plan = kern_plan_of(block, BLOCKS, contact, CONTACTS,
                                  kern_known_of(motion, force), &work);
    kern_margin m;
    float most = 0.1f; /* a place with less is no place */
    uint32_t start = board_ticks();
    kern_status status;
    int i, best = -1;

    plan.task.options.epsilon = 0.005f; /* one step for every wall */
    status = (kern_status)build_wall(&plan);
    if (status >= 0)
        status = kern_measure(&plan.task, &m, 0);
    board_print("wall of 30 stones:    ");
    print_margin(status, &m);
    print_cost(start, &work);
    if (status != KERN_STANDS)
        return 1;
    for (i = 0; i < 4; i++) {
        board_print(place[i] < 0 ? "candidate at " : "candidate at  ");
        board_print_fixed(place[i], 2);
        board_print(" m: ");
        const float margin = ask_place(&plan, place[i], most * 1.001f);
        if (margin > most) {
            best = i;
            most = margin;
        }
    }
    if (best < 0)
        return 1;
    board_print("best place: ");
    board_print_fixed(place[best], 2);
    board_print(" m\n");
    for (i = 0; i < 4; i++)
        ask_within(&plan, place[best], limit[i]);
    print_memory();
    return 0;
}

/* Output, where ticks, stack and flash depend on compiler and version:
wall of 30 stones:    level 31, margin 0.1518 m; 639 units; 54644 ticks
candidate at  0.00 m: bears 0.1001 m; 72 units; 4792 ticks
                      level 31, margin 0.1518 m; 128 units; 7196 ticks
                      stays 1.00; 1446 units; 60959 ticks
candidate at  0.20 m: bears 0.1520 m; 140 units; 6732 ticks
                      level 34, margin 0.1663 m; 3004 units; 135881 ticks
                      stays 1.00; 1431 units; 54604 ticks
candidate at  0.40 m: does not bear 0.1665 m; 2032 units; 89814 ticks
candidate at -0.30 m: two blocks overlap deeper than the gap tolerance; 3 units; 321 ticks
best place: 0.20 m
limit 50: not known to stand, margin up to 0.2230 m; 51 units; 2067 ticks
limit 200: margin from 0.1515 to 0.2230 m; 201 units; 8462 ticks
limit 800: margin from 0.1515 to 0.2230 m; 801 units; 43168 ticks
limit 3200: level 34, margin 0.1663 m; 3004 units; 135911 ticks
memory: 42624 bytes of work memory, 9256 of blocks and contacts,
        51888 of variables in all, 2080 of 13648 of stack, 50000 of flash
*/
