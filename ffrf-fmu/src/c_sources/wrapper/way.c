static const char *const reasons[] = {
    "nothing",
    "the step is not positive and finite",
    "a number of the state or of the inputs is not finite",
    "a mass or the system of equations has no factors",
    "a joint cannot be met again: the step is too large",
    "a number of the state after the step is not finite: the step is too large",
    "the angle of a driven joint is beyond the digits of its number"
};

static int refuse_step(const fmu *instance, double time, int status)
{
    const int known = status > 0 && status < (int)(sizeof reasons / sizeof reasons[0]);
    return refuse(instance, "at t = %.9g s: %s", time, known ? reasons[status] : "the step was refused");
}

/* The size of whole steps. Units: s. */
static double step_of(const life *now)
{
    return STEP_PARAMETER > 0 ? now->parameters[STEP_PARAMETER - 1] : SCENE_STEP;
}

/* Lets whole steps begin at a state: on the grid of steps from zero if the state is there. */
static void begin_steps(life *now, const @P_state *state)
{
    const double step = step_of(now);
    const double count = rounded(state->time / step);
    now->whole = *state;
    if (count >= 0.0 && distance(state->time, count * step) <= SAME_TIME * step) {
        now->grid = 0.0;
        now->count = count;
        now->whole.time = count * step;
    } else {
        now->grid = state->time;
        now->count = 0.0;
    }
}

/* The numbers of all outputs and other columns in the state where the instance is. */
static int measure(fmu *instance)
{
    life *now = &instance->life;
    double *values = instance->values;
    @P_observables observed;
    int place = 0;
    int body;
    int k;
    int status;
    if (instance->is_measured != 0) {
        return STATUS_OK;
    }
    for (body = 0; body < BODIES; body++) {
        const @P_body *at = &now->now.bodies[body];
        for (k = 0; k < 3; k++) {
            values[place++] = at->position[k];
        }
        for (k = 0; k < 4; k++) {
            values[place++] = at->orientation[k];
        }
#if HAS_MODES
        for (k = 0; k < modes[body]; k++) {
            values[place++] = at->q[k];
        }
#endif
        for (k = 0; k < 3; k++) {
            values[place++] = at->velocity[k];
        }
        for (k = 0; k < 3; k++) {
            values[place++] = at->omega[k];
        }
#if HAS_MODES
        for (k = 0; k < modes[body]; k++) {
            values[place++] = at->q_dot[k];
        }
#endif
    }
#if HAS_SENSORS
    {
        @P_outputs outputs;
        status = @P_read(&instance->tables, &now->now, &now->inputs, &outputs);
        if (status != @M_DONE) {
            return refuse_step(instance, now->now.time, status);
        }
        for (k = 0; k < ANGLES; k++) {
            const double turn = 6.283185307179586;
            double *angle = &outputs.values[angles[k]];
            if (now->angles_are_known != 0) {
                *angle += turn * rounded((now->angles[k] - *angle) / turn);
            }
            now->angles[k] = *angle;
        }
        for (k = 0; k < @M_SENSOR_COUNT; k++) {
            values[place++] = outputs.values[k];
        }
    }
#endif
    status = @P_observe(&instance->tables, &now->now, &observed);
    if (status != @M_DONE) {
        return refuse_step(instance, now->now.time, status);
    }
    values[place++] = observed.kinetic;
    values[place++] = observed.elastic;
    values[place++] = observed.potential;
    values[place++] = observed.position_drift;
    values[place] = observed.velocity_drift;
    now->angles_are_known = 1;
    instance->is_measured = 1;
    return STATUS_OK;
}

/* What follows from the parameters, and the state at the beginning with its joints met. */
static int compose(fmu *instance, @P_state *beginning)
{
    const life *now = &instance->life;
    int refused;
    int status;
    if (STEP_PARAMETER > 0 && !(step_of(now) > 0.0)) {
        return refuse(instance, "`%s`: expected a positive step, found %.9g", names[STEP_PARAMETER], step_of(now));
    }
    instance->is_composed = 0;
    status = @P_compose(now->parameters, now->start, &instance->tables, beginning, &refused);
    if (status == @M_PARAMETERS && refused >= 0) {
        return refuse(
            instance, "`%s`: expected a number that is %s, found %.9g", names[refused + 1],
            now->parameters[refused] < 0.0 ? "not negative" : "positive", now->parameters[refused]
        );
    }
    if (status == @M_PARAMETERS) {
        return refuse(instance, "the parameters: an orientation of a body is zero, or a joint has no length");
    }
    if (status == @M_JOINTS_NOT_MET) {
        return refuse(instance, "the parameters: the joints cannot be met from these places of the bodies");
    }
    if (status != @M_DONE) {
        return refuse_step(instance, now->start, status);
    }
    instance->is_composed = 1;
    return STATUS_OK;
}

/* Begins the simulation with the parameters and inputs of now, unless it has begun. */
static int begin(fmu *instance)
{
    life *now = &instance->life;
    life before;
    int status;
    if (now->has_begun != 0) {
        return STATUS_OK;
    }
    before = *now;
    if (compose(instance, &now->now) != STATUS_OK) {
        *now = before;
        return STATUS_ERROR;
    }
    begin_steps(now, &now->now);
    now->angles_are_known = 0;
    now->has_begun = 1;
    instance->is_measured = 0;
    status = measure(instance);
    if (status != STATUS_OK) {
        *now = before;
    }
    return status;
}

/* Leads to a time behind the communication point: whole steps follow each other, the rest is a shorter step beside them. */
static int advance(fmu *instance, double end)
{
    life *now = &instance->life;
    const double step = step_of(now);
    const double last = whole_below((end - now->grid) / step + SAME_TIME);
    @P_state whole = now->whole;
    @P_state reached;
    double count = now->count;
    int status;
    while (count < last) {
        status = @P_step(&instance->tables, &whole, &now->inputs, step);
        if (status != @M_DONE) {
            return refuse_step(instance, whole.time, status);
        }
        count += 1.0;
        whole.time = now->grid + count * step;
    }
    reached = whole;
    if (end - whole.time > SAME_TIME * step) {
        status = @P_step(&instance->tables, &reached, &now->inputs, end - whole.time);
        if (status != @M_DONE) {
            return refuse_step(instance, whole.time, status);
        }
    }
    reached.time = end;
    now->whole = whole;
    now->count = count;
    now->now = reached;
    instance->is_measured = 0;
    return STATUS_OK;
}

#if INPUTS_ARE_THERE
/* Sets an input from now on; whole steps begin anew where it changes. */
static void set_input(fmu *instance, int input, double value)
{
    life *now = &instance->life;
    if (now->inputs.follows[input] == 0 && memcmp(&now->inputs.actuators[input], &value, sizeof value) == 0) {
        return;
    }
    if (now->has_begun != 0 && distance(now->now.time, now->whole.time) > SAME_TIME * step_of(now)) {
        begin_steps(now, &now->now);
    }
    now->inputs.actuators[input] = value;
    now->inputs.follows[input] = 0;
    instance->is_measured = 0;
}
#endif
