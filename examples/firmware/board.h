/* board.h: what the examples need of a Cortex-M4F: output, time, stack.

   Output and the end of the program go through semihosting, so the same image
   runs in QEMU and under a debugger. No libc is needed. */

#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

void board_print(const char *text);
void board_print_int(int32_t number);
/* A number with `digits` (up to 6) digits after the point. */
void board_print_fixed(float number, int digits);

/* Ticks of the processor clock since reset, by SysTick. */
uint32_t board_ticks(void);

/* Bytes of stack that were ever used since reset, and bytes there are. */
int32_t board_stack_used(void);
int32_t board_stack_size(void);
/* Bytes of the variables (.data and .bss), and of code and constants. */
int32_t board_variables(void);
int32_t board_flash(void);

/* Ends the program; status is the exit status of the emulator. */
void board_exit(int status);

#endif
