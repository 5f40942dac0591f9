/* The rigid pendulum of n links, the same in every column: gravity -9.81 along y, hinges about z, links of 0.3 m and 0.6 kg
 * whose centre is in the middle, inertia about it 1e-3, 5e-3, 5e-3; joint angles 0.1 sin(k + 1), rates 0.3 cos(k). */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <time.h>

static double now(void) {
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + 1e-9 * t.tv_nsec;
}
static double joint_angle(int k) { return 0.1 * sin(k + 1.0); }
static double joint_rate(int k) { return 0.3 * cos((double)k); }

/* Prints one line of JSON: ns, and the accelerations of the joints. */
static void report(const char *column, int n, double seconds, const double *accelerations) {
    printf("{\"column\": \"%s\", \"n\": %d, \"ns\": %.1f, \"check\": [", column, n, seconds * 1e9);
    for (int k = 0; k < n; k++) printf("%s%.17g", k ? ", " : "", accelerations[k]);
    printf("]}\n");
}
/* Least seconds of one CALL in ROUNDS rounds of about 0.1 ms. */
#define LEAST(best, rounds, CALL)                                      \
    do {                                                               \
        double begin = now();                                          \
        CALL;                                                          \
        int calls = (int)(1e-4 / fmax(now() - begin, 1e-9)) + 1;       \
        best = 1e99;                                                   \
        for (int round = 0; round < rounds; round++) {                 \
            begin = now();                                             \
            for (int i = 0; i < calls; i++) CALL;                      \
            best = fmin(best, (now() - begin) / calls);                \
        }                                                              \
    } while (0)
