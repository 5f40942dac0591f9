/*
 * A flexible slider-crank: a rigid crank of radius 0.04 m that a motor turns about the inertial z axis, the connecting rod
 * of models/conrod.ffrf.json with four modes, a piston that is guided along x. Gravity 9.81 m/s^2 along -z.
 *
 * No heap: the memory of an object is the caller's, and may be copied by assignment. A step does bounded work and takes
 * less than 96 KiB of stack. An object is used by one thread at a time. Every function answers FFRF_NULL_POINTER and
 * FFRF_NOT_INITIALISED.
 *
 * Units: m, kg, s, N, rad. Frames: inertial, where nothing else is said.
 */
#ifndef SLIDER_CRANK_H
#define SLIDER_CRANK_H

#include "ffrf_status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Size of an object. */
#define SLIDER_CRANK_DOUBLES 272
/*
 * Numbers of a state: time, moment of the motor; then of crank, rod, piston each: position (3), orientation (4, scalar
 * first), modal coordinates (the rod: 4), velocity (3), angular velocity (3, body frame), modal rates (the rod: 4).
 */
#define SLIDER_CRANK_STATE 49

/* An object; what is inside is not for others. */
typedef struct {
    double memory[SLIDER_CRANK_DOUBLES];
} slider_crank;

/* What is measured. */
typedef struct {
    /* Units: s. */
    double time;
    /* Position of the piston. Units: m. */
    double stroke[3];
    /* Force of the main bearing on the crank. Units: N. */
    double bearing[3];
    /* Angular velocity of the crank about z. Units: rad/s. */
    double speed;
} slider_crank_sensors;

/* At rest at time zero, stretched out along x, without a moment. */
ffrf_status slider_crank_init(slider_crank *self);

/*
 * One linearly implicit step of order two: any step is stable for the rod's modes; the motion of the crank wants some
 * hundred steps for a turn. Units: s.
 */
ffrf_status slider_crank_step(slider_crank *self, double step);

/* The moment of the motor about z on the crank from now on. Units: N m. */
ffrf_status slider_crank_set_moment(slider_crank *self, double moment);

/* What is measured now. The force of the bearing takes an evaluation of the accelerations. */
ffrf_status slider_crank_measure(slider_crank *self, slider_crank_sensors *sensors);

/* Writes every number of the state. */
ffrf_status slider_crank_save(slider_crank *self, double state[SLIDER_CRANK_STATE]);

/* Takes up a state that was saved, bit by bit. */
ffrf_status slider_crank_restore(slider_crank *self, const double state[SLIDER_CRANK_STATE]);

#ifdef __cplusplus
}
#endif

#endif /* SLIDER_CRANK_H */
