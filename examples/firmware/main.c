/* A robot's controller asks where to put the next stone.

   From the root of the project:

       arm-none-eabi-gcc -std=c99 -Os -mcpu=cortex-m4 -mthumb -mfloat-abi=hard \
           -mfpu=fpv4-sp-d16 -ffp-contract=off -fno-math-errno \
           -fno-tree-loop-distribute-patterns -ffreestanding -nostdlib \
           -ffunction-sections -fdata-sections -Wl,--gc-sections \
           -T examples/firmware/mps2-an386.ld -o firmware.elf \
           examples/firmware/main.c examples/firmware/board.c
       qemu-system-arm -M mps2-an386 -nographic \
           -semihosting-config enable=on,target=native -kernel firmware.elf

   A wall of 30 stones lies in flash. It is measured, then a candidate stone is
   tried in four places on top: only its own contacts are found each time, and
   it is taken back by forgetting them. All memory is static: 64 KB of RAM hold
   everything, stack included. The library needs nothing but a square root,
   which is an instruction here; -fno-tree-loop-distribute-patterns keeps gcc
   from calling memset() for its loops.

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
    CONTACTS = 160,
    CANDIDATE = BLOCKS - 1
};

static kern_vec placed[CANDIDATE_VERTICES]; /* the candidate, where tried */
static kern_block block[BLOCKS];
static kern_contact contact[CONTACTS];
static kern_real reals[KERN_REALS(BLOCKS, CONTACTS)];
static int ints[KERN_INTS(BLOCKS, CONTACTS)];

static void print_measure(kern_status status, const kern_margin *m,
                          int contacts, int32_t ticks, const kern_work *work)
{
    if (status == KERN_STANDS) {
        board_print("level ");
        board_print_int(m->level);
        board_print(", margin ");
        board_print_fixed(m->margin, 4);
        board_print(" m");
    } else
        board_print(kern_status_text(status));
    if (contacts > 0) {
        board_print("; ");
        board_print_int(contacts);
        board_print(" contact points, ");
        board_print_int(work->pivots);
        board_print(" pivots");
    }
    board_print("; ");
    board_print_int(ticks);
    board_print(" ticks\n");
}

/* Blocks of the ground and the wall, and all contacts between them. */
static int build_wall(const kern_options *options, kern_work *work)
{
    int i, status = kern_block_init(&block[0], ground, 4, 0, &work->fault);
    for (i = 0; i < WALL_STONES && status == KERN_STANDS; i++)
        status = kern_block_init(&block[i + 1], wall[i].vertex,
                                 wall[i].vertices, DENSITY, &work->fault);
    if (status != KERN_STANDS)
        return status;
    return kern_contacts(block, CANDIDATE, options, contact, CONTACTS,
                         &work->fault);
}

/* Puts the candidate down `along` its bed and adds its contacts behind the
   first `contacts`. Returns how many there are then. */
static int place_candidate(float along, int contacts,
                           const kern_options *options, kern_work *work)
{
    int i;
    for (i = 0; i < CANDIDATE_VERTICES; i++) {
        placed[i].x = candidate[i].x + along;
        placed[i].y = candidate[i].y + along * CANDIDATE_SLOPE;
    }
    i = kern_block_init(&block[CANDIDATE], placed, CANDIDATE_VERTICES, DENSITY,
                        &work->fault);
    if (i != KERN_STANDS)
        return i;
    for (i = 0; i < CANDIDATE; i++) {
        const int added = kern_touch(block, BLOCKS, i, CANDIDATE, options,
                                     contact + contacts, CONTACTS - contacts,
                                     &work->fault);
        if (added < 0)
            return added;
        contacts += added;
    }
    return contacts;
}

/* Measures the first `blocks` blocks and prints what was found. */
static kern_status measure(int blocks, int contacts, uint32_t start,
                           const kern_options *options, kern_work *work,
                           kern_margin *m)
{
    const kern_structure s = { block, blocks, contact, contacts,
                               { 0, -9.81f } };
    kern_status status = (kern_status)contacts;
    work->pivots = 0;
    if (contacts >= 0)
        status = kern_measure(&s, options, work, m, 0);
    print_measure(status, m, contacts, (int32_t)(board_ticks() - start), work);
    return status;
}

static void print_memory(void)
{
    board_print("memory: ");
    board_print_int((int32_t)(sizeof reals + sizeof ints));
    board_print(" bytes of work memory, ");
    board_print_int((int32_t)(sizeof block + sizeof contact + sizeof placed));
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
    static const float place[] = { 0, 0.2f, 0.4f, -0.3f };
    kern_options options = kern_defaults();
    kern_work work = kern_work_of(reals, KERN_REALS(BLOCKS, CONTACTS), ints,
                                  KERN_INTS(BLOCKS, CONTACTS));
    kern_margin m;
    float most = -1;
    uint32_t start = board_ticks();
    int i, best = -1;
    const int contacts = build_wall(&options, &work);

    options.epsilon = 0.005f; /* one step for the wall and all it may become */
    board_print("wall of 30 stones:    ");
    if (measure(CANDIDATE, contacts, start, &options, &work, &m) != KERN_STANDS)
        return 1;
    for (i = 0; i < 4; i++) {
        int with;
        start = board_ticks();
        with = place_candidate(place[i], contacts, &options, &work);
        board_print(place[i] < 0 ? "candidate at " : "candidate at  ");
        board_print_fixed(place[i], 2);
        board_print(" m: ");
        if (measure(BLOCKS, with, start, &options, &work, &m) == KERN_STANDS
            && m.margin > most) {
            best = i;
            most = m.margin;
        }
    }
    print_memory();
    if (best < 0)
        return 1;
    board_print("best place: ");
    board_print_fixed(place[best], 2);
    board_print(" m\n");
    return 0;
}

/* Output, where pivots and ticks depend on compiler and version:
wall of 30 stones:    level 31, margin 0.1518 m; 120 contact points, 60 pivots; 226728 ticks
candidate at  0.00 m: level 31, margin 0.1518 m; 124 contact points, 64 pivots; 185522 ticks
candidate at  0.20 m: level 34, margin 0.1663 m; 124 contact points, 78 pivots; 225725 ticks
candidate at  0.40 m: level 34, margin 0.1663 m; 124 contact points, 59 pivots; 193971 ticks
candidate at -0.30 m: two blocks overlap deeper than the gap tolerance; 11063 ticks
memory: 33312 bytes of work memory, 7080 of blocks and contacts,
        40400 of variables in all, 1448 of 25136 of stack, 30656 of flash
best place: 0.40 m
*/
