/*
 * Drives the slider-crank and the free rod from C, and prints the bits of what is measured.
 *
 * cargo build --release -p ffrf-c-interface
 * gcc -std=c99 -Iexamples/c_interface/include examples/c_interface/main.c target/release/libffrf_c_interface.a -lm -lpthread -ldl
 */
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "free_rod.h"
#include "slider_crank.h"

/* Ends the program if a call does not answer what is expected. */
static void expect(ffrf_status found, ffrf_status expected, const char *what)
{
    if (found != expected) {
        fprintf(stderr, "%s: expected status %d, found %d\n", what, (int)expected, (int)found);
        exit(1);
    }
}

static void show(const char *name, const double *numbers, size_t count)
{
    size_t k;
    printf("%s", name);
    for (k = 0; k < count; k++) {
        uint64_t bits;
        memcpy(&bits, &numbers[k], sizeof bits);
        printf(" %016" PRIx64, bits);
    }
    printf("\n");
}

static void drive_slider_crank(void)
{
    static slider_crank crank;
    static slider_crank copy;
    slider_crank_sensors sensors;
    double state[SLIDER_CRANK_STATE];
    double again[SLIDER_CRANK_STATE];
    int k;

    expect(slider_crank_step(NULL, 1e-3), FFRF_NULL_POINTER, "no object");
    expect(slider_crank_step(&crank, 1e-3), FFRF_NOT_INITIALISED, "an empty object");
    expect(slider_crank_init(&crank), FFRF_OK, "init");
    expect(slider_crank_step(&crank, 0.0), FFRF_STEP_SIZE, "no step");
    expect(slider_crank_set_moment(&crank, 0.2), FFRF_OK, "set_moment");
    for (k = 0; k < 100; k++) {
        if (k == 50) {
            expect(slider_crank_set_moment(&crank, -0.1), FFRF_OK, "set_moment");
        }
        expect(slider_crank_step(&crank, 1e-3), FFRF_OK, "step");
        if (k % 10 == 9) {
            expect(slider_crank_measure(&crank, &sensors), FFRF_OK, "measure");
            show("crank", (const double *)&sensors, sizeof sensors / sizeof(double));
        }
    }
    /* a state that is restored goes on bit by bit, and so does a copy of the object */
    expect(slider_crank_save(&crank, state), FFRF_OK, "save");
    copy = crank;
    for (k = 0; k < 5; k++) {
        expect(slider_crank_step(&crank, 1e-3), FFRF_OK, "step");
        expect(slider_crank_step(&copy, 1e-3), FFRF_OK, "step of the copy");
    }
    expect(slider_crank_save(&crank, again), FFRF_OK, "save");
    expect(slider_crank_init(&copy), FFRF_OK, "init");
    expect(slider_crank_restore(&copy, state), FFRF_OK, "restore");
    for (k = 0; k < 5; k++) {
        expect(slider_crank_step(&copy, 1e-3), FFRF_OK, "step");
    }
    expect(slider_crank_save(&copy, state), FFRF_OK, "save");
    if (memcmp(state, again, sizeof state) != 0) {
        fprintf(stderr, "the restored slider-crank goes another way\n");
        exit(1);
    }
    state[5] = 2.0;
    expect(slider_crank_restore(&copy, state), FFRF_NO_STATE, "an orientation that is none");
    show("crank state", again, SLIDER_CRANK_STATE);
}

static void drive_free_rod(void)
{
    static free_rod rod;
    free_rod_sensors sensors;
    const double gravity[3] = {0.0, 0.0, -9.81};
    const double push[3] = {3.0, -20.0, 5.0};
    const double nothing[3] = {0.0, 0.0, 0.0};
    double state[FREE_ROD_STATE];
    const double step = 0.5 * free_rod_largest_stable_step();
    int k;

    expect(free_rod_init(&rod, NULL), FFRF_NULL_POINTER, "no gravity");
    expect(free_rod_init(&rod, gravity), FFRF_OK, "init");
    expect(free_rod_set_force(&rod, push), FFRF_OK, "set_force");
    for (k = 0; k < 200; k++) {
        if (k == 100) {
            expect(free_rod_set_force(&rod, nothing), FFRF_OK, "set_force");
        }
        expect(free_rod_step(&rod, step), FFRF_OK, "step");
        if (k % 20 == 19) {
            expect(free_rod_measure(&rod, &sensors), FFRF_OK, "measure");
            show("rod", (const double *)&sensors, sizeof sensors / sizeof(double));
        }
    }
    expect(free_rod_save(&rod, state), FFRF_OK, "save");
    expect(free_rod_restore(&rod, state), FFRF_OK, "restore");
    expect(free_rod_save(&rod, state), FFRF_OK, "save");
    show("rod state", state, FREE_ROD_STATE);
}

int main(void)
{
    drive_slider_crank();
    drive_free_rod();
    return 0;
}
