/* board.c: start-up, semihosting, SysTick and stack watch of a Cortex-M4F.

   Built together with main.c, see there. Nothing here knows of stones. */

#include "board.h"

/* Placed by mps2-an386.ld. */
extern uint32_t board_data_load[], board_data_start[], board_data_end[];
extern uint32_t board_bss_start[], board_bss_end[];
extern uint32_t board_stack_top[], board_flash_start[];

int main(void);

#define REGISTER(address) (*(volatile uint32_t *)(address))
#define SYSTICK_CONTROL REGISTER(0xE000E010u)
#define SYSTICK_RELOAD REGISTER(0xE000E014u)
#define SYSTICK_VALUE REGISTER(0xE000E018u)
#define FPU_ACCESS REGISTER(0xE000ED88u)

#define SYSTICK_BITS 24
#define SYSTICK_MOST ((1u << SYSTICK_BITS) - 1)

#define UNUSED_STACK 0xA5C3A5C3u

/* ---- semihosting: a breakpoint that the emulator or debugger answers ---- */

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20 };
#define APPLICATION_EXIT 0x20026u

static void semihosting(uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xAB" : "+r"(r0) : "r"(r1) : "memory");
}

void board_print(const char *text) { semihosting(SYS_WRITE0, text); }

void board_exit(int status)
{
    uint32_t reason[2];
    reason[0] = APPLICATION_EXIT;
    reason[1] = (uint32_t)status;
    semihosting(SYS_EXIT_EXTENDED, reason);
    for (;;) /* nobody listened */
        ;
}

/* ---- numbers ---- */

void board_print_int(int32_t number)
{
    char text[12];
    char *at = text + sizeof text - 1;
    uint32_t rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    *at = '\0';
    do
        *--at = (char)('0' + rest % 10);
    while (rest /= 10);
    if (number < 0)
        *--at = '-';
    board_print(at);
}

void board_print_fixed(float number, int digits)
{
    char text[8];
    float unit = 1;
    int32_t whole, part;
    int i;
    for (i = 0; i < digits; i++)
        unit *= 10;
    if (number < 0)
        board_print("-");
    number = number < 0 ? -number : number;
    whole = (int32_t)number;
    part = (int32_t)((number - (float)whole) * unit + 0.5f);
    if (part >= (int32_t)unit) {
        part -= (int32_t)unit;
        whole++;
    }
    board_print_int(whole);
    if (digits == 0)
        return;
    text[0] = '.';
    text[digits + 1] = '\0';
    for (i = digits; i > 0; i--) {
        text[i] = (char)('0' + part % 10);
        part /= 10;
    }
    board_print(text);
}

/* ---- time ---- */

static volatile uint32_t wraps; /* of the 24 bits, counted at each 0 */

static void systick_handler(void) { wraps++; }

uint32_t board_ticks(void)
{
    uint32_t before, value;
    do { /* again, if it wrapped in between */
        before = wraps;
        value = SYSTICK_VALUE;
    } while (before != wraps);
    return (before << SYSTICK_BITS) + ((0u - value) & SYSTICK_MOST);
}

/* ---- memory ---- */

static int32_t bytes(const uint32_t *from, const uint32_t *to)
{
    return (int32_t)((uintptr_t)to - (uintptr_t)from);
}

int32_t board_stack_used(void)
{
    const uint32_t *at = board_bss_end;
    while (at < board_stack_top && *at == UNUSED_STACK)
        at++;
    return bytes(at, board_stack_top);
}

int32_t board_stack_size(void) { return bytes(board_bss_end, board_stack_top); }

int32_t board_variables(void) { return bytes(board_data_start, board_bss_end); }

int32_t board_flash(void)
{
    return bytes(board_flash_start, board_data_load)
         + bytes(board_data_start, board_data_end);
}

/* ---- start ---- */

void reset(void);
void reset(void) /* named in mps2-an386.ld */
{
    const uint32_t *from = board_data_load;
    uint32_t *to;
    uint32_t *here;
    FPU_ACCESS |= 0xFu << 20; /* full access to coprocessors 10 and 11 */
    __asm__ volatile("dsb\n isb" ::: "memory");
    for (to = board_data_start; to < board_data_end; to++)
        *to = *from++;
    for (to = board_bss_start; to < board_bss_end; to++)
        *to = 0;
    __asm__ volatile("mov %0, sp" : "=r"(here));
    while (to < here)
        *to++ = UNUSED_STACK;
    SYSTICK_RELOAD = SYSTICK_MOST;
    SYSTICK_VALUE = 0;
    SYSTICK_CONTROL = 7; /* on, with interrupt, at the processor's clock */
    board_exit(main());
}

static void fault(void)
{
    board_print("fault\n");
    board_exit(3);
}

/* The first sixteen entries of the vector table; no interrupts are used. */
static void (*const vector[])(void)
    __attribute__((used, section(".vectors"))) = {
        (void (*)(void))(uintptr_t)board_stack_top, /* initial stack pointer */
        reset,
        fault,
        fault,
        fault,
        fault,
        fault,
        0,
        0,
        0,
        0,
        fault,
        fault,
        0,
        fault,
        systick_handler,
};
