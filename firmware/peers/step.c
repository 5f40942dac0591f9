/*
 * Counts a step of a mechanism in generated C on an emulated board: the most instructions of 32 steps, and bytes of stack.
 * As firmware/probe does it: with -icount shift=6 the emulator lets 64 ns pass with each instruction, and the timer counts every
 * 40 ns.
 */
#include <stdint.h>
#include "mechanism.h"

/* Registers of the first timer of the boards (CMSDK APB timer): control, value, reload; 25 MHz. */
#define TIMER ((volatile uint32_t *)0x40000000u)

extern uint32_t stack_top;
extern uint32_t stack_low;
static volatile int answer;
static mechanism_state state;
static mechanism_inputs inputs;

void reset(void);

__attribute__((section(".vectors"), used)) static const void *const vectors[2] = {&stack_top, (const void *)reset};

static void semihosting(int operation, const void *argument)
{
    register int r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void show(const char *name, uint32_t number)
{
    char text[12];
    int place = 11;
    text[place] = 0;
    do {
        text[--place] = (char)('0' + number % 10u);
        number /= 10u;
    } while (number > 0u);
    semihosting(4, name);
    semihosting(4, &text[place]);
}

__attribute__((noinline)) static void work(void)
{
    answer |= mechanism_step(&state, &inputs, MECHANISM_SCENE_STEP);
}

__attribute__((noinline)) static void nothing(void)
{
    __asm__ volatile("");
}

static uint32_t counted(void (*what)(void))
{
    const uint32_t before = TIMER[1];
    what();
    return (uint32_t)((uint64_t)(before - TIMER[1]) * 5u / 8u);
}

static __attribute__((noinline)) uint32_t stack_of(void (*what)(void))
{
    uint32_t *low = &stack_low;
    uint32_t *here = (uint32_t *)__builtin_frame_address(0) - 64;
    uint32_t *place;
    for (place = low; place < here; place++) {
        *(volatile uint32_t *)place = 0x5afe5afeu;
    }
    what();
    for (place = low; place < here && *(volatile uint32_t *)place == 0x5afe5afeu; place++) {
    }
    return (uint32_t)((uint8_t *)(here + 64) - (uint8_t *)place);
}

void reset(void)
{
    uint32_t most = 0, base, used, n;
    *(volatile uint32_t *)0xe000ed88u |= 0xfu << 20;
    __asm__ volatile("dsb\n isb");
    TIMER[2] = 0xffffffffu;
    TIMER[1] = 0xffffffffu;
    TIMER[0] = 1u;
    mechanism_start(&state);
    used = stack_of(work) - stack_of(nothing);
    base = counted(nothing);
    for (n = 0; n < 32u; n++) {
        const uint32_t count = counted(work) - base;
        most = count > most ? count : most;
    }
    show("instructions ", most);
    show(" stack ", used);
    show(" answer ", (uint32_t)answer);
    semihosting(4, "\n");
    semihosting(0x18, (const void *)0x20026);
    for (;;) {
    }
}
