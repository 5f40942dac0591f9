/* States as bytes: what they begin with, then every number of a life as the eight bytes of a double, the lowest first. */
static const char head[] = "ffrf-fmu C state 1\n" TOKEN;

/* A place among bytes that are written, read, or only counted. */
typedef struct {
    unsigned char *write;
    const unsigned char *read;
    size_t size;
} tape;

static void pass(tape *bytes, double *number)
{
    uint64_t bits = 0;
    size_t k;
    if (bytes->read != NULL) {
        for (k = 0; k < 8; k++) {
            bits |= (uint64_t)bytes->read[bytes->size + k] << (8 * k);
        }
        memcpy(number, &bits, sizeof bits);
    }
    if (bytes->write != NULL) {
        memcpy(&bits, number, sizeof bits);
        for (k = 0; k < 8; k++) {
            bytes->write[bytes->size + k] = (unsigned char)((bits >> (8 * k)) & 0xffU);
        }
    }
    bytes->size += 8;
}

static void pass_all(tape *bytes, int count, double *numbers)
{
    int k;
    for (k = 0; k < count; k++) {
        pass(bytes, &numbers[k]);
    }
}

/* A small whole number. */
static void pass_whole(tape *bytes, int *number)
{
    double value = (double)*number;
    pass(bytes, &value);
    if (bytes->read != NULL) {
        *number = value > -1e9 && value < 1e9 ? (int)value : -1;
    }
}

static void pass_mechanism(tape *bytes, @P_state *state)
{
    int body;
    for (body = 0; body < BODIES; body++) {
        @P_body *at = &state->bodies[body];
        pass_all(bytes, 3, at->position);
        pass_all(bytes, 4, at->orientation);
        pass_all(bytes, 3, at->velocity);
        pass_all(bytes, 3, at->omega);
#if HAS_MODES
        pass_all(bytes, MOST_MODES, at->q);
        pass_all(bytes, MOST_MODES, at->q_dot);
#endif
    }
    pass(bytes, &state->time);
}

static void pass_life(tape *bytes, life *saved)
{
#if INPUTS_ARE_THERE
    int k;
#endif
    pass_whole(bytes, &saved->phase);
    pass_whole(bytes, &saved->has_begun);
    pass(bytes, &saved->start);
    pass_all(bytes, PARAMETERS, saved->parameters);
#if INPUTS_ARE_THERE
    for (k = 0; k < INPUTS; k++) {
        pass_whole(bytes, &saved->inputs.follows[k]);
        pass(bytes, &saved->inputs.actuators[k]);
    }
#endif
    pass_mechanism(bytes, &saved->whole);
    pass(bytes, &saved->grid);
    pass(bytes, &saved->count);
    pass_mechanism(bytes, &saved->now);
    pass_whole(bytes, &saved->angles_are_known);
    pass_all(bytes, ANGLES, saved->angles);
}

static size_t state_size(void)
{
    life counted;
    tape bytes = {NULL, NULL, sizeof head - 1};
    memset(&counted, 0, sizeof counted);
    pass_life(&bytes, &counted);
    return bytes.size;
}

static int write_state(const fmu *instance, const life *saved, unsigned char *place, size_t size)
{
    tape bytes = {NULL, NULL, sizeof head - 1};
    life copy;
    if (saved == NULL || place == NULL) {
        return refuse(instance, NO_VALUE);
    }
    if (size < state_size()) {
        return refuse(
            instance, "a state takes %lu bytes, found place for %lu", (unsigned long)state_size(), (unsigned long)size
        );
    }
    copy = *saved;
    memcpy(place, head, sizeof head - 1);
    bytes.write = place;
    pass_life(&bytes, &copy);
    return STATUS_OK;
}

static int read_state(const fmu *instance, const unsigned char *place, size_t size, life *saved)
{
    tape bytes = {NULL, NULL, sizeof head - 1};
    if (place == NULL) {
        return refuse(instance, NO_VALUE);
    }
    if (size != state_size() || memcmp(place, head, sizeof head - 1) != 0) {
        return refuse(instance, "the state is not one of this model");
    }
    memset(saved, 0, sizeof *saved);
    bytes.read = place;
    pass_life(&bytes, saved);
    if (saved->phase < INSTANTIATED || saved->phase > TERMINATED) {
        return refuse(instance, "the state is not one of this model");
    }
    return STATUS_OK;
}

/* Saves the state in a place of its own, or in that of a state that is there. */
static int save(fmu *instance, void **place)
{
    if (place == NULL) {
        return refuse(instance, NO_VALUE);
    }
    if (*place == NULL) {
        *place = allocate(&instance->caller, sizeof(life));
        if (*place == NULL) {
            return refuse(instance, "no memory for a state");
        }
    }
    *(life *)*place = instance->life;
    return STATUS_OK;
}

/* Takes up a state again, bit by bit. */
static int resume(fmu *instance, const void *saved)
{
    life before;
    int is_same;
    if (saved == NULL) {
        return refuse(instance, NO_VALUE);
    }
    before = instance->life;
    is_same = instance->is_composed != 0 && instance->life.has_begun != 0
        && memcmp(before.parameters, ((const life *)saved)->parameters, sizeof before.parameters) == 0
        && memcmp(&before.start, &((const life *)saved)->start, sizeof before.start) == 0;
    instance->life = *(const life *)saved;
    instance->is_measured = 0;
    if (instance->life.has_begun != 0 && is_same == 0) {
        @P_state beginning;
        if (compose(instance, &beginning) != STATUS_OK) {
            instance->life = before;
            if (before.has_begun != 0) {
                (void)compose(instance, &beginning);
            }
            return STATUS_ERROR;
        }
    }
    return STATUS_OK;
}

static void free_state(const fmu *instance, void **place)
{
    if (place != NULL && *place != NULL) {
        release(&instance->caller, *place);
        *place = NULL;
    }
}

/* A state from bytes, in a place of its own. */
static int deserialise(fmu *instance, const unsigned char *bytes, size_t size, void **place)
{
    life saved;
    if (place == NULL) {
        return refuse(instance, NO_VALUE);
    }
    if (read_state(instance, bytes, size, &saved) != STATUS_OK) {
        return STATUS_ERROR;
    }
    if (*place == NULL) {
        *place = allocate(&instance->caller, sizeof(life));
        if (*place == NULL) {
            return refuse(instance, "no memory for a state");
        }
    }
    *(life *)*place = saved;
    return STATUS_OK;
}
