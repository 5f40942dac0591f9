static const char *phase_name(int phase)
{
    switch (phase) {
    case INSTANTIATED:
        return "instantiated";
    case INITIALISATION:
        return "in initialisation mode";
    case STEPPING:
        return "in step mode";
    default:
        return "terminated";
    }
}

static int must_be(const fmu *instance, const char *call, int phase)
{
    if (instance->life.phase == phase) {
        return STATUS_OK;
    }
    return refuse(
        instance, "%s is not allowed: the instance is %s, it must be %s", call, phase_name(instance->life.phase),
        phase_name(phase)
    );
}

/* Makes an instance what it is at its beginning. */
static void reset(fmu *instance)
{
    life *now = &instance->life;
    int k;
    memset(now, 0, sizeof *now);
    for (k = 0; k < PARAMETERS; k++) {
        now->parameters[k] = parameter_starts[k];
    }
#if INPUTS_ARE_THERE
    for (k = 0; k < INPUTS; k++) {
        now->inputs.actuators[k] = @P_scheduled(k, 0.0);
        now->inputs.follows[k] = 1;
    }
#endif
    instance->is_measured = 0;
}

static int enter_initialisation(fmu *instance, double start)
{
    if (must_be(instance, "the beginning of initialisation", INSTANTIATED) != STATUS_OK) {
        return STATUS_ERROR;
    }
    if (!number_is_finite(start)) {
        return refuse(instance, "start time: expected a finite number");
    }
    if (distance(start, instance->life.start) > 0.0) {
        instance->life.start = start;
        instance->life.has_begun = 0;
    }
    instance->life.phase = INITIALISATION;
    return STATUS_OK;
}

static int exit_initialisation(fmu *instance)
{
    if (must_be(instance, "the end of initialisation", INITIALISATION) != STATUS_OK
        || begin(instance) != STATUS_OK) {
        return STATUS_ERROR;
    }
    instance->life.phase = STEPPING;
    return STATUS_OK;
}

static int terminate(fmu *instance)
{
    if (must_be(instance, "the end", STEPPING) != STATUS_OK) {
        return STATUS_ERROR;
    }
    instance->life.phase = TERMINATED;
    return STATUS_OK;
}

/* One step from a communication point to the next; where it fails, the instance is where it was. */
static int do_step(fmu *instance, double from, double size)
{
    life before;
    double time;
    if (must_be(instance, "a step", STEPPING) != STATUS_OK || begin(instance) != STATUS_OK) {
        return STATUS_ERROR;
    }
    time = instance->life.now.time;
    if (!(size > 0.0 && number_is_finite(size) && distance(from, time) <= SAME_POINT * size)) {
        return refuse(
            instance, "a step of %.9g s from t = %.9g s: expected a positive step from t = %.9g s", size, from, time
        );
    }
    if (!(from + size > time)) {
        return STATUS_OK;
    }
    before = instance->life;
    if (advance(instance, from + size) != STATUS_OK || measure(instance) != STATUS_OK) {
        instance->life = before;
        instance->is_measured = 0;
        return STATUS_ERROR;
    }
    return STATUS_OK;
}

static int known_reference(const fmu *instance, uint32_t reference)
{
    if (reference < (uint32_t)VARIABLES) {
        return STATUS_OK;
    }
    return refuse(
        instance, "value reference %lu: expected one of 0 to %d", (unsigned long)reference, VARIABLES - 1
    );
}

static int get(fmu *instance, uint32_t reference, double *value)
{
    const life *now = &instance->life;
    int place;
    if (known_reference(instance, reference) != STATUS_OK) {
        return STATUS_ERROR;
    }
    place = (int)reference;
    if (place == 0) {
        *value = now->has_begun != 0 ? now->now.time : now->start;
        return STATUS_OK;
    }
    place -= 1;
    if (place < PARAMETERS) {
        *value = now->parameters[place];
        return STATUS_OK;
    }
    place -= PARAMETERS;
#if INPUTS_ARE_THERE
    if (place < INPUTS) {
        /* of an input that is not set, what the scene has at this time */
        *value = now->inputs.follows[place] != 0
            ? @P_scheduled(place, now->has_begun != 0 ? now->now.time : 0.0)
            : now->inputs.actuators[place];
        return STATUS_OK;
    }
#endif
    place -= INPUTS;
    if (begin(instance) != STATUS_OK || measure(instance) != STATUS_OK) {
        return STATUS_ERROR;
    }
    *value = instance->values[place];
    return STATUS_OK;
}

static int set(fmu *instance, uint32_t reference, double value)
{
    life *now = &instance->life;
    int place;
    if (known_reference(instance, reference) != STATUS_OK) {
        return STATUS_ERROR;
    }
    if (!number_is_finite(value)) {
        return refuse(instance, "`%s`: expected a finite number", names[reference]);
    }
    place = (int)reference - 1;
    if (place >= 0 && place < PARAMETERS) {
        if (now->phase != INSTANTIATED && now->phase != INITIALISATION) {
            return refuse(
                instance, "`%s` cannot be set: parameters are fixed once the simulation has begun", names[reference]
            );
        }
        if (memcmp(&now->parameters[place], &value, sizeof value) != 0) {
            now->parameters[place] = value;
            now->has_begun = 0;
            instance->is_measured = 0;
        }
        return STATUS_OK;
    }
    place -= PARAMETERS;
#if INPUTS_ARE_THERE
    if (place >= 0 && place < INPUTS) {
        set_input(instance, place, value);
        return STATUS_OK;
    }
#endif
    return refuse(instance, "`%s` cannot be set: it is what the simulation computes", names[reference]);
}
