/* The functions of FMI 3.0 for co-simulation: names, arguments and answers are those of the standard. */

EXPORTED const char *FMI(GetVersion)(void)
{
    return "3.0";
}

EXPORTED fmi3Status FMI(SetDebugLogging)(
    fmi3Instance instance, fmi3Boolean logging_on, size_t category_count, const fmi3String categories[]
)
{
    (void)category_count;
    (void)categories;
    if (instance == NULL) {
        return fmi3Error;
    }
    ((fmu *)instance)->is_logging = logging_on ? 1 : 0;
    return fmi3OK;
}

EXPORTED fmi3Instance FMI(InstantiateCoSimulation)(
    fmi3String instance_name, fmi3String instantiation_token, fmi3String resource_path, fmi3Boolean visible,
    fmi3Boolean logging_on, fmi3Boolean event_mode_used, fmi3Boolean early_return_allowed,
    const fmi3ValueReference required_intermediate_variables[], size_t required_intermediate_variable_count,
    fmi3InstanceEnvironment environment, fmi3LogMessageCallback log_message,
    fmi3IntermediateUpdateCallback intermediate_update
)
{
    const caller to = {environment, log_message};
    fmu *instance;
    (void)instance_name;
    (void)resource_path;
    (void)visible;
    (void)early_return_allowed;
    (void)required_intermediate_variables;
    (void)required_intermediate_variable_count;
    (void)intermediate_update;
    if (event_mode_used) {
        report(&to, STATUS_ERROR, "logStatusError", "event mode: this FMU has none");
        return NULL;
    }
    if (instantiation_token == NULL || strcmp(instantiation_token, TOKEN) != 0) {
        report(&to, STATUS_ERROR, "logStatusError", OTHER_TOKEN);
        return NULL;
    }
    instance = (fmu *)allocate(&to, sizeof *instance);
    if (instance == NULL) {
        report(&to, STATUS_ERROR, "logStatusError", "no memory for an instance");
        return NULL;
    }
    instance->caller = to;
    instance->is_logging = logging_on ? 1 : 0;
    reset(instance);
    return instance;
}

EXPORTED void FMI(FreeInstance)(fmi3Instance instance)
{
    free(instance);
}

EXPORTED fmi3Status FMI(EnterInitializationMode)(
    fmi3Instance instance, fmi3Boolean tolerance_defined, fmi3Float64 tolerance, fmi3Float64 start_time,
    fmi3Boolean stop_time_defined, fmi3Float64 stop_time
)
{
    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_time_defined;
    (void)stop_time;
    return instance == NULL ? fmi3Error : (fmi3Status)enter_initialisation((fmu *)instance, start_time);
}

EXPORTED fmi3Status FMI(ExitInitializationMode)(fmi3Instance instance)
{
    return instance == NULL ? fmi3Error : (fmi3Status)exit_initialisation((fmu *)instance);
}

EXPORTED fmi3Status FMI(Terminate)(fmi3Instance instance)
{
    return instance == NULL ? fmi3Error : (fmi3Status)terminate((fmu *)instance);
}

EXPORTED fmi3Status FMI(Reset)(fmi3Instance instance)
{
    if (instance == NULL) {
        return fmi3Error;
    }
    reset((fmu *)instance);
    return fmi3OK;
}

/* Whether arrays of variables and values are there and of the same size. */
static int arrays_fit(const fmu *instance, const void *references, size_t reference_count, const void *values, size_t count)
{
    if (reference_count != count) {
        return refuse(
            instance, "%lu variables and %lu values: every variable is one number", (unsigned long)reference_count,
            (unsigned long)count
        );
    }
    return count > 0 && (references == NULL || values == NULL) ? refuse(instance, NO_VALUE) : STATUS_OK;
}

EXPORTED fmi3Status FMI(GetFloat64)(
    fmi3Instance instance, const fmi3ValueReference references[], size_t reference_count, fmi3Float64 values[],
    size_t value_count
)
{
    size_t k;
    if (instance == NULL
        || arrays_fit((const fmu *)instance, references, reference_count, values, value_count) != STATUS_OK) {
        return fmi3Error;
    }
    for (k = 0; k < value_count; k++) {
        if (get((fmu *)instance, references[k], &values[k]) != STATUS_OK) {
            return fmi3Error;
        }
    }
    return fmi3OK;
}

EXPORTED fmi3Status FMI(SetFloat64)(
    fmi3Instance instance, const fmi3ValueReference references[], size_t reference_count, const fmi3Float64 values[],
    size_t value_count
)
{
    size_t k;
    if (instance == NULL
        || arrays_fit((const fmu *)instance, references, reference_count, values, value_count) != STATUS_OK) {
        return fmi3Error;
    }
    for (k = 0; k < value_count; k++) {
        if (set((fmu *)instance, references[k], values[k]) != STATUS_OK) {
            return fmi3Error;
        }
    }
    return fmi3OK;
}

EXPORTED fmi3Status FMI(GetFMUState)(fmi3Instance instance, fmi3FMUState *state)
{
    return instance == NULL ? fmi3Error : (fmi3Status)save((fmu *)instance, state);
}

EXPORTED fmi3Status FMI(SetFMUState)(fmi3Instance instance, fmi3FMUState state)
{
    return instance == NULL ? fmi3Error : (fmi3Status)resume((fmu *)instance, state);
}

EXPORTED fmi3Status FMI(FreeFMUState)(fmi3Instance instance, fmi3FMUState *state)
{
    if (instance == NULL) {
        return fmi3Error;
    }
    free_state((const fmu *)instance, state);
    return fmi3OK;
}

EXPORTED fmi3Status FMI(SerializedFMUStateSize)(fmi3Instance instance, fmi3FMUState state, size_t *size)
{
    if (instance == NULL) {
        return fmi3Error;
    }
    if (state == NULL || size == NULL) {
        return (fmi3Status)refuse((const fmu *)instance, NO_VALUE);
    }
    *size = state_size();
    return fmi3OK;
}

EXPORTED fmi3Status FMI(SerializeFMUState)(fmi3Instance instance, fmi3FMUState state, fmi3Byte bytes[], size_t size)
{
    return instance == NULL ? fmi3Error
                            : (fmi3Status)write_state((const fmu *)instance, (const life *)state, bytes, size);
}

EXPORTED fmi3Status FMI(DeserializeFMUState)(
    fmi3Instance instance, const fmi3Byte bytes[], size_t size, fmi3FMUState *state
)
{
    return instance == NULL ? fmi3Error : (fmi3Status)deserialise((fmu *)instance, bytes, size, state);
}

EXPORTED fmi3Status FMI(DoStep)(
    fmi3Instance instance, fmi3Float64 current_communication_point, fmi3Float64 communication_step_size,
    fmi3Boolean no_set_fmu_state_prior_to_current_point, fmi3Boolean *event_handling_needed,
    fmi3Boolean *terminate_simulation, fmi3Boolean *early_return, fmi3Float64 *last_successful_time
)
{
    fmu *one = (fmu *)instance;
    int status;
    (void)no_set_fmu_state_prior_to_current_point;
    if (one == NULL) {
        return fmi3Error;
    }
    if (event_handling_needed == NULL || terminate_simulation == NULL || early_return == NULL
        || last_successful_time == NULL) {
        return (fmi3Status)refuse(one, NO_VALUE);
    }
    status = do_step(one, current_communication_point, communication_step_size);
    *event_handling_needed = false;
    *terminate_simulation = false;
    *early_return = false;
    *last_successful_time = one->life.has_begun != 0 ? one->life.now.time : one->life.start;
    return (fmi3Status)status;
}
