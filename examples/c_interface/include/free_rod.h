/*
 * The connecting rod of models/conrod.ffrf.json with four modes, in free flight under gravity and a force at its small end.
 *
 * No heap: the memory of an object is the caller's, and may be copied by assignment. A step does bounded work. An object is
 * used by one thread at a time. Every function answers FFRF_NULL_POINTER and FFRF_NOT_INITIALISED.
 *
 * Units: m, kg, s, N, rad. Frames: inertial, where nothing else is said.
 */
#ifndef FREE_ROD_H
#define FREE_ROD_H

#include "ffrf_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Size of an object. */
#define FREE_ROD_DOUBLES 96
/*
 * Numbers of a state: time, force (3), position of the frame origin (3), orientation (4, scalar first, body to inertial),
 * modal coordinates (4), velocity of the frame origin (3), angular velocity (3, body frame), modal rates (4).
 */
#define FREE_ROD_STATE 25

/* An object; what is inside is not for others. */
typedef struct {
    double memory[FREE_ROD_DOUBLES];
} free_rod;

/* What is measured. */
typedef struct {
    /* Units: s. */
    double time;
    /* Position and velocity of the small end. Units: m, m/s. */
    double tip[3];
    double tip_velocity[3];
    /* Units: J. */
    double kinetic_energy;
    double elastic_energy;
} free_rod_sensors;

/* At rest at the origin at time zero, without a force. Units: m/s^2. */
ffrf_status free_rod_init(free_rod *self, const double gravity[3]);

/* The largest step that keeps small vibrations bounded. Units: s. */
double free_rod_largest_stable_step(void);

/* One explicit step of order four. Units: s. */
ffrf_status free_rod_step(free_rod *self, double step);

/* The force at the small end from now on. Units: N. */
ffrf_status free_rod_set_force(free_rod *self, const double force[3]);

/* What is measured now. */
ffrf_status free_rod_measure(free_rod *self, free_rod_sensors *sensors);

/* Writes every number of the state. */
ffrf_status free_rod_save(free_rod *self, double state[FREE_ROD_STATE]);

/* Takes up a state, bit by bit: one that was saved, or one of your own. */
ffrf_status free_rod_restore(free_rod *self, const double state[FREE_ROD_STATE]);

#ifdef __cplusplus
}
#endif

#endif /* FREE_ROD_H */
