/* Checks and times columns in one run. usage: time_columns body_M.bin ROUNDS name=library [name=library ...]
   One JSON line per column: errors against the reference, minimum and median of nanoseconds per call, and the median of the
   ratios of the first column to this one, taken round by round: load that lasts longer than a round is on both sides of it. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

typedef void equations_t(const double *, const double *, const double *, const double *, double *, double *, double *);
typedef void accelerations_t(const double *, const double *, const double *, const double *, double *);
struct column {
    char name[64];
    equations_t *equations;
    accelerations_t *accelerations;
    double error;
    long calls[2];
    double *times[2], ratio[2];
};
enum { STRIDE = 80, LIMIT = 32 };

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec * 1e9 + t.tv_nsec;
}
static int ascending(const void *a, const void *b) {
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}
static double *room(size_t count) {
    double *p = aligned_alloc(64, (count * sizeof(double) + 127) / 64 * 64);
    memset(p, 0, count * sizeof(double));
    return p;
}
/* Largest deviation, relative to the largest entry; NaN counts as infinite. */
static double deviation(const double *found, const double *expected, int count) {
    double worst = 0, size = 0;
    for (int i = 0; i < count; i++) {
        double d = fabs(found[i] - expected[i]);
        if (!(d <= worst)) worst = isnan(d) ? INFINITY : d;
        if (fabs(expected[i]) > size) size = fabs(expected[i]);
    }
    return worst / size;
}
static int states, modes, size;
static double *q, *rates, *omega, *force, *mass, *quadratic, *acceleration;

static double run(struct column *c, int kind, long calls) {
    double start = now();
    for (long k = 0; k < calls; k++) {
        int s = k % states;
        if (kind == 0)
            c->equations(q + STRIDE * s, rates + STRIDE * s, omega + 8 * s, force + STRIDE * s, mass, quadratic, acceleration);
        else
            c->accelerations(q + STRIDE * s, rates + STRIDE * s, omega + 8 * s, force + STRIDE * s, acceleration);
    }
    return (now() - start) / calls;
}

int main(int argc, char **argv) {
    FILE *file = fopen(argv[1], "rb");
    if (!file) return perror(argv[1]), 1;
    fseek(file, 0, SEEK_END);
    long bytes = ftell(file);
    rewind(file);
    double *data = room(bytes / 8);
    if (fread(data, 1, bytes, file) != (size_t)bytes) return 1;
    fclose(file);
    modes = data[0], states = data[1], size = 6 + modes;
    const double *invariants = data + 2, *first = invariants + 13 + 13 * modes + 9 * modes * modes;
    int length = 2 * modes + 3 + 3 * size + size * size, rounds = atoi(argv[2]), count = 0;
    q = room(STRIDE * states), rates = room(STRIDE * states), omega = room(8 * states), force = room(STRIDE * states);
    for (int s = 0; s < states; s++) {
        const double *p = first + (long)s * length;
        memcpy(q + STRIDE * s, p, modes * 8), memcpy(rates + STRIDE * s, p + modes, modes * 8);
        memcpy(omega + 8 * s, p + 2 * modes, 24), memcpy(force + STRIDE * s, p + 2 * modes + 3, size * 8);
    }
    mass = room(STRIDE * STRIDE), quadratic = room(STRIDE), acceleration = room(STRIDE);
    static struct column columns[LIMIT];
    for (int i = 3; i < argc && count < LIMIT; i++) {
        struct column *c = &columns[count];
        char *library = strchr(argv[i], '=');
        if (!library) continue;
        snprintf(c->name, sizeof c->name, "%.*s", (int)(library - argv[i]), argv[i]);
        void *handle = dlmopen(LM_ID_NEWLM, library + 1, RTLD_NOW);
        if (!handle) handle = dlopen(library + 1, RTLD_NOW | RTLD_LOCAL);
        if (!handle) { fprintf(stderr, "SKIPPED: %s: %s\n", c->name, dlerror()); continue; }
        int (*prepare)(int, const double *) = dlsym(handle, "ffrf_prepare");
        c->equations = dlsym(handle, "ffrf_equations"), c->accelerations = dlsym(handle, "ffrf_accelerations");
        if (!prepare || prepare(modes, invariants) || !c->equations) { fprintf(stderr, "SKIPPED: %s\n", c->name); continue; }
        for (int s = 0; s < states; s++) {
            const double *expected = first + (long)s * length + 2 * modes + 3 + size;
            memset(mass, 255, size * size * 8), memset(quadratic, 255, size * 8), memset(acceleration, 255, size * 8);
            run(c, 0, 0);
            c->equations(q + STRIDE * s, rates + STRIDE * s, omega + 8 * s, force + STRIDE * s, mass, quadratic, acceleration);
            double errors[4] = {deviation(mass, expected, size * size), deviation(quadratic, expected + size * size, size),
                                deviation(acceleration, expected + size * size + size, size), 0};
            if (c->accelerations) {
                memset(acceleration, 255, size * 8);
                c->accelerations(q + STRIDE * s, rates + STRIDE * s, omega + 8 * s, force + STRIDE * s, acceleration);
                errors[3] = deviation(acceleration, expected + size * size + size, size);
            }
            for (int k = 0; k < 4; k++) if (!(errors[k] <= c->error)) c->error = errors[k];
        }
        for (int kind = 0; kind < (c->accelerations ? 2 : 1); kind++) {
            run(c, kind, states);
            long calls = 1e5 / run(c, kind, states);
            c->calls[kind] = (calls < states ? states : calls / states * states);
            c->times[kind] = malloc(rounds * sizeof(double));
        }
        count++;
    }
    for (int r = 0; r < rounds; r++)
        for (int i = 0; i < count; i++)
            for (int kind = 0; kind < 2; kind++)
                if (columns[i].times[kind]) columns[i].times[kind][r] = run(&columns[i], kind, columns[i].calls[kind]);
    double *ratios = malloc(rounds * sizeof(double));
    for (int i = 0; i < count; i++) /* before any column's times are sorted */
        for (int kind = 0; kind < 2; kind++)
            if (columns[i].times[kind] && columns[0].times[kind]) {
                for (int r = 0; r < rounds; r++) ratios[r] = columns[0].times[kind][r] / columns[i].times[kind][r];
                qsort(ratios, rounds, sizeof(double), ascending);
                columns[i].ratio[kind] = ratios[rounds / 2];
            }
    int failed = 0;
    for (int i = 0; i < count; i++) {
        struct column *c = &columns[i];
        printf("{\"column\": \"%s\", \"modes\": %d, \"error\": %.1e", c->name, modes, c->error);
        for (int kind = 0; kind < 2; kind++)
            if (c->times[kind]) {
                qsort(c->times[kind], rounds, sizeof(double), ascending);
                printf(", \"%s\": {\"minimum_ns\": %.1f, \"median_ns\": %.1f, \"ratio\": %.3f}",
                       kind ? "accelerations" : "equations", c->times[kind][0], c->times[kind][rounds / 2], c->ratio[kind]);
            }
        printf("}\n");
        if (!(c->error <= 1e-12)) fprintf(stderr, "FAILED: %s deviates by %g\n", c->name, c->error), failed = 1;
    }
    return failed;
}
