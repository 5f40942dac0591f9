/* The axes of the bodies, and what depends on their states. */
static void prepare_all(workspace *work)
{
    int index;
    for (index = 0; index < BODIES; index++) {
        body_work *body = &work->bodies[index];
        axes_of(work->state.bodies[index].orientation, body->axes);
        prepare_body(index, &work->state.bodies[index], body);
        fill(VELOCITIES, (real)0, body->force);
        fill(VELOCITIES, (real)0, body->result);
    }
}

/* Evaluates all joints; soft links resist in stages with a gamma h only. Gives a status. */
static int evaluate_links(real time, real gamma_h, workspace *work)
{
    int index;
    for (index = 0; index < JOINTS; index++) {
        const int status = evaluate_link(index, time, work);
        if (status != DONE) {
            return status;
        }
    }
//@ if SOFT
    for (index = JOINTS; index < LINKS; index++) {
        soften(index, gamma_h, work);
    }
//@ end
    (void)gamma_h;
    return DONE;
}

/* Accelerations and multipliers in the state of the workspace. Gives a status. */
static int evaluate(const mechanism_inputs *inputs, real time, const stage_terms *terms, workspace *work)
{
    int status;
    fill(6 * NODES, (real)0, work->shift);
    prepare_all(work);
    load(inputs, time, work);
    status = evaluate_links(time, terms->gamma_h, work);
    if (status == DONE) {
        status = factor(terms, work);
    }
    if (status == DONE) {
        accelerate(terms, work);
    }
    return status;
}

/* The state that an increment leads to. */
static void retract(const mechanism_state *origin, const real *increment, mechanism_state *state)
{
    int index;
    *state = *origin;
    for (index = 0; index < BODIES; index++) {
        const real *change = &increment[INCREMENT * index];
        body_state *body = &state->bodies[index];
        add_scaled(3, (real)1, &change[0], body->position);
        turned(origin->bodies[index].orientation, &change[3], body->orientation);
        add_scaled(3, (real)1, &change[VELOCITIES], body->velocity);
        add_scaled(3, (real)1, &change[VELOCITIES + 3], body->omega);
//@ if FLEXIBLE
        add_scaled(MODES, (real)1, &change[6], body->q);
        add_scaled(MODES, (real)1, &change[VELOCITIES + 6], body->q_dot);
//@ end
    }
}

/* The rates of the places at the state of the workspace, to which an increment has led; those of velocities zero. */
static void place_rates(const real *increment, const workspace *work, real *rates)
{
    int index;
    for (index = 0; index < BODIES; index++) {
        const body_state *state = &work->state.bodies[index];
        real *rate = &rates[INCREMENT * index];
        fill(INCREMENT, (real)0, rate);
        copy(3, state->velocity, &rate[0]);
        cayley_rate(&increment[INCREMENT * index + 3], state->omega, &rate[3]);
//@ if FLEXIBLE
        copy(MODES, state->q_dot, &rate[6]);
//@ end
    }
}

/* The rates of an increment in the chart about a state. Gives a status. */
static int rates_at(
    const mechanism_state *origin, const mechanism_inputs *inputs, real time, const stage_terms *terms,
    workspace *work, real *rates
)
{
    int index;
    int status;
    retract(origin, terms->increment, &work->state);
    status = evaluate(inputs, time, terms, work);
    place_rates(terms->increment, work, rates);
    for (index = 0; index < BODIES; index++) {
        const body_work *body = &work->bodies[index];
        real *rate = &rates[INCREMENT * index];
        along_axes(body->axes, body->result, &rate[VELOCITIES]);
        copy(VELOCITIES - 3, &body->result[3], &rate[VELOCITIES + 3]);
//@ if IMPLICIT
        add_scaled(VELOCITIES - 6, terms->gamma_h, &body->result[6], &rate[6]);
        if (terms->subtracted != NULL) {
            add_scaled(VELOCITIES, (real)-1, &terms->subtracted[INCREMENT * index], rate);
        }
//@ end
//@ if SOFT
        if (terms->gamma_h > (real)0) {
            real turning[3];
            add_scaled(3, terms->gamma_h, &rate[VELOCITIES], &rate[0]);
            cayley_rate(&terms->increment[INCREMENT * index + 3], &rate[VELOCITIES + 3], turning);
            add_scaled(3, terms->gamma_h, turning, &rate[3]);
        }
//@ end
    }
    return status;
}

/* The largest residual of positions and of velocities; the first that is not finite stays the largest. */
static void residuals(const workspace *work, real largest[2])
{
    int index;
    int level;
    int k;
    largest[0] = (real)0;
    largest[1] = (real)0;
    for (index = 0; index < JOINTS; index++) {
        real found[2][6];
        copy(6, work->rows[index].residual, found[0]);
        row_velocities(index, work, found[1]);
        for (level = 0; level < 2; level++) {
            for (k = 0; k < work->rows[index].count; k++) {
                const real one = magnitude(found[level][k]);
                if (one > largest[level] || (is_finite(largest[level]) && !is_finite(one))) {
                    largest[level] = one;
                }
            }
        }
    }
}

/* Residuals that no correction makes smaller: the round-off of what they are differences of. */
static void smallest_residuals(const workspace *work, real smallest[2])
{
    int index;
    int k;
    smallest[0] = (real)1;
    smallest[1] = (real)1;
    for (index = 0; index < JOINTS; index++) {
        for (k = 0; k < 6; k++) {
            const motion *at = &work->at[index][k < 3 ? 0 : 1];
            const int axis = k < 3 ? k : k - 3;
            smallest[0] = larger(smallest[0], magnitude(at->position[axis]));
            smallest[1] = larger(smallest[1], larger(magnitude(at->velocity[axis]), magnitude(at->omega[axis])));
        }
    }
    for (k = 0; k < 2; k++) {
        smallest[k] = larger((real)16 * ROUND_OFF, (real)2 * ROUND_OFF * smallest[k]);
    }
}

/* Adds the result of a correction to places or velocities. */
static void apply_correction(int is_velocity, workspace *work)
{
    int index;
    for (index = 0; index < BODIES; index++) {
        body_work *body = &work->bodies[index];
        body_state *state = &work->state.bodies[index];
        real moved[3];
        along_axes(body->axes, body->result, moved);
        if (is_velocity != 0) {
            add_scaled(3, (real)1, moved, state->velocity);
            add_scaled(3, (real)1, &body->result[3], state->omega);
//@ if FLEXIBLE
            add_scaled(MODES, (real)1, &body->result[6], state->q_dot);
//@ end
        } else {
            add_scaled(3, (real)1, moved, state->position);
            turned(state->orientation, &body->result[3], state->orientation);
//@ if FLEXIBLE
            add_scaled(MODES, (real)1, &body->result[6], state->q);
//@ end
            axes_of(state->orientation, body->axes);
        }
    }
}

/*
 * Projects positions, then velocities, of the state of the workspace on the joints, by so many corrections of each. Modes and
 * soft links resist as in a stage with their gamma h. Gives a status.
 */
static int project(
    real time, real gamma_h, real soft_gamma_h, int corrections, real tolerance, workspace *work
)
{
    stage_terms terms;
    real left[2];
    real enough[2];
    int is_factored = 0;
    int level;
    int pass;
    int status;
    if (JOINTS == 0) {
        return DONE;
    }
    terms.gamma_h = gamma_h;
    terms.subtracted = NULL;
    terms.increment = NULL;
    fill(6 * NODES, (real)0, work->shift);
    prepare_all(work);
    status = evaluate_links(time, soft_gamma_h, work);
    if (status != DONE) {
        return status;
    }
    residuals(work, left);
    smallest_residuals(work, enough);
    for (level = 0; level < 2; level++) {
        const real least = larger(enough[level], ENOUGH_PROJECTED * left[level]);
        for (pass = 0; pass < corrections; pass++) {
            if (left[level] <= least) {
                break;
            }
            if (is_factored == 0) {
                status = factor(&terms, work);
                if (status != DONE) {
                    return status;
                }
                is_factored = 1;
            }
            correct(level, work);
            apply_correction(level, work);
            status = evaluate_links(time, soft_gamma_h, work);
            if (status != DONE) {
                return status;
            }
            residuals(work, left);
        }
    }
    return left[0] <= tolerance ? DONE : JOINTS_NOT_MET;
}

static int state_is_finite(const mechanism_state *state)
{
    real sum = (real)0;
    int index;
    int k;
    for (index = 0; index < BODIES; index++) {
        const body_state *body = &state->bodies[index];
        real norm = (real)0;
        for (k = 0; k < 3; k++) {
            sum += (real)0 * body->position[k] + (real)0 * body->velocity[k] + (real)0 * body->omega[k];
        }
        for (k = 0; k < 4; k++) {
            sum += (real)0 * body->orientation[k];
            norm = larger(norm, magnitude(body->orientation[k]));
        }
        if (!(norm > (real)0)) {
            return 0;
        }
//@ if FLEXIBLE
        for (k = 0; k < MODES; k++) {
            sum += (real)0 * body->q[k] + (real)0 * body->q_dot[k];
        }
//@ end
    }
    return is_finite(sum);
}

/* The end of every step: the joints are met again. */
static int finish(mechanism_state *state, const real *slope, real h, real gamma_h, workspace *work)
{
    int status;
    retract(state, slope, &work->state);
    if (!state_is_finite(&work->state)) {
        return NOT_FINITE;
    }
    status = project(state->time + h, gamma_h, gamma_h, CORRECTIONS, TOLERANCE, work);
    if (status != DONE) {
        return status;
    }
    if (!state_is_finite(&work->state)) {
        return NOT_FINITE;
    }
    work->state.time = state->time + h;
    *state = work->state;
    return DONE;
}
