//@ if RK4
/* The classical Runge-Kutta method of order four. */
static int advance(mechanism_state *state, const mechanism_inputs *inputs, real h, workspace *work)
{
    const real share[4] = {h / (real)6, h / (real)3, h / (real)3, h / (real)6};
    const real reach[4] = {(real)0, h * (real)0.5, h * (real)0.5, h};
    stage_terms terms;
    real rates[SIZE];
    real increment[SIZE];
    real slope[SIZE];
    int stage;
    int k;
    terms.gamma_h = (real)0;
    terms.subtracted = NULL;
    terms.increment = increment;
    fill(SIZE, (real)0, rates);
    fill(SIZE, (real)0, slope);
    for (stage = 0; stage < 4; stage++) {
        int status;
        for (k = 0; k < SIZE; k++) {
            increment[k] = rates[k] * reach[stage];
        }
        status = rates_at(state, inputs, state->time + reach[stage], &terms, work, rates);
        if (status != DONE) {
            return status;
        }
        add_scaled(SIZE, share[stage], rates, slope);
    }
    return finish(state, slope, h, (real)0, work);
}
//@ end
//@ if EULER
/*
 * Euler's method of order one: velocities from the forces, with modes and soft links implicit if the method is, then places
 * from the new velocities.
 */
static int advance(mechanism_state *state, const mechanism_inputs *inputs, real h, workspace *work)
{
    stage_terms terms;
    real increment[SIZE];
    real rates[SIZE];
    real slope[SIZE];
    int status;
    int index;
    int k;
//@ if IMPLICIT
    terms.gamma_h = h;
//@ end
//@ if EXPLICIT
    terms.gamma_h = (real)0;
//@ end
    terms.subtracted = NULL;
    terms.increment = increment;
    fill(SIZE, (real)0, increment);
    status = rates_at(state, inputs, state->time, &terms, work, rates);
    if (status != DONE) {
        return status;
    }
    for (index = 0; index < BODIES; index++) {
        for (k = VELOCITIES; k < INCREMENT; k++) {
            increment[INCREMENT * index + k] = rates[INCREMENT * index + k] * h;
        }
    }
    retract(state, increment, &work->state);
    place_rates(increment, work, slope);
    for (k = 0; k < SIZE; k++) {
        slope[k] = increment[k] + slope[k] * h;
    }
    return finish(state, slope, h, terms.gamma_h, work);
}
//@ end
//@ if LINEARLY_IMPLICIT
/*
 * ROS2, the linearly implicit method of order two, with modes and soft links implicit.
 * Source: Verwer, Spee, Blom, Hundsdorfer, SIAM J. Sci. Comput. 20 (1999) 1456-1480.
 */
static int advance(mechanism_state *state, const mechanism_inputs *inputs, real h, workspace *work)
{
    const real gamma_h = ((real)1 - square_root((real)0.5)) * h;
    stage_terms terms;
    real increment[SIZE];
    real first[SIZE];
    real twice[SIZE];
    real slope[SIZE];
    int status;
    int k;
    terms.gamma_h = gamma_h;
    terms.subtracted = NULL;
    terms.increment = increment;
    fill(SIZE, (real)0, increment);
    status = rates_at(state, inputs, state->time, &terms, work, first);
    if (status != DONE) {
        return status;
    }
    for (k = 0; k < SIZE; k++) {
        increment[k] = first[k] * h;
        twice[k] = first[k] * (real)2;
    }
    terms.subtracted = twice;
    status = rates_at(state, inputs, state->time + h, &terms, work, first);
    if (status != DONE) {
        return status;
    }
    for (k = 0; k < SIZE; k++) {
        slope[k] = increment[k] * (real)1.5 + h * (real)0.5 * first[k];
    }
    return finish(state, slope, h, gamma_h, work);
}
//@ end

int @P_step(@Gmechanism_state *state, const mechanism_inputs *inputs, real step)
{
    workspace work;
//@ if PARAMETERS
    work.tables = tables;
//@ end
    if (!(step > (real)0 && is_finite(step))) {
        return @M_STEP_SIZE;
    }
    if (!(state_is_finite(state) && is_finite(state->time))) {
        return @M_STATE_NOT_FINITE;
    }
//@ if ACTUATORS
    {
        int k;
        for (k = 0; k < ACTUATORS; k++) {
            if (!is_finite(inputs->actuators[k])) {
                return @M_STATE_NOT_FINITE;
            }
        }
    }
//@ end
    return advance(state, inputs, step, &work);
}
//@ if CONSTANT_TABLES

void @P_start(mechanism_state *state)
{
    *state = beginning;
}
//@ end
