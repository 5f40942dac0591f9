/* The functions of FMI 2.0 for co-simulation: names, arguments and answers are those of the standard. */

EXPORTED const char *FMI(GetTypesPlatform)(void)
{
    return "default";
}

EXPORTED const char *FMI(GetVersion)(void)
{
    return "2.0";
}

EXPORTED fmi2Status FMI(SetDebugLogging)(
    fmi2Component component, fmi2Boolean logging_on, size_t category_count, const fmi2String categories[]
)
{
    (void)category_count;
    (void)categories;
    if (component == NULL) {
        return fmi2Error;
    }
    ((fmu *)component)->is_logging = logging_on != 0 ? 1 : 0;
    return fmi2OK;
}

EXPORTED fmi2Component FMI(Instantiate)(
    fmi2String instance_name, fmi2Type fmu_type, fmi2String guid, fmi2String resource_location,
    const fmi2CallbackFunctions *functions, fmi2Boolean visible, fmi2Boolean logging_on
)
{
    caller to;
    fmu *instance;
    (void)resource_location;
    (void)visible;
    memset(&to, 0, sizeof to);
    if (instance_name != NULL) {
        (void)snprintf(to.name, sizeof to.name, "%s", instance_name);
    }
    if (functions != NULL) {
        to.environment = functions->componentEnvironment;
        to.log = functions->logger;
        to.allocate = functions->freeMemory != NULL ? functions->allocateMemory : NULL;
        to.release = functions->freeMemory;
    }
    if (fmu_type != fmi2CoSimulation) {
        report(&to, STATUS_ERROR, "logStatusError", "this FMU is for co-simulation only");
        return NULL;
    }
    if (guid == NULL || strcmp(guid, TOKEN) != 0) {
        report(&to, STATUS_ERROR, "logStatusError", OTHER_TOKEN);
        return NULL;
    }
    instance = (fmu *)allocate(&to, sizeof *instance);
    if (instance == NULL) {
        report(&to, STATUS_ERROR, "logStatusError", "no memory for an instance");
        return NULL;
    }
    memset(instance, 0, sizeof *instance);
    instance->caller = to;
    instance->is_logging = logging_on != 0 ? 1 : 0;
    reset(instance);
    return instance;
}

EXPORTED void FMI(FreeInstance)(fmi2Component component)
{
    if (component != NULL) {
        const caller from = ((fmu *)component)->caller;
        release(&from, component);
    }
}

EXPORTED fmi2Status FMI(SetupExperiment)(
    fmi2Component component, fmi2Boolean tolerance_defined, fmi2Real tolerance, fmi2Real start_time,
    fmi2Boolean stop_time_defined, fmi2Real stop_time
)
{
    (void)tolerance_defined;
    (void)tolerance;
    (void)stop_time_defined;
    (void)stop_time;
    if (component == NULL) {
        return fmi2Error;
    }
    ((fmu *)component)->announced_start = start_time;
    return fmi2OK;
}

EXPORTED fmi2Status FMI(EnterInitializationMode)(fmi2Component component)
{
    fmu *instance = (fmu *)component;
    return instance == NULL ? fmi2Error : (fmi2Status)enter_initialisation(instance, instance->announced_start);
}

EXPORTED fmi2Status FMI(ExitInitializationMode)(fmi2Component component)
{
    return component == NULL ? fmi2Error : (fmi2Status)exit_initialisation((fmu *)component);
}

EXPORTED fmi2Status FMI(Terminate)(fmi2Component component)
{
    return component == NULL ? fmi2Error : (fmi2Status)terminate((fmu *)component);
}

EXPORTED fmi2Status FMI(Reset)(fmi2Component component)
{
    if (component == NULL) {
        return fmi2Error;
    }
    reset((fmu *)component);
    return fmi2OK;
}

/* Whether arrays of variables and values are there. */
static int arrays_are_there(const fmu *instance, const void *references, const void *values, size_t count)
{
    return count > 0 && (references == NULL || values == NULL) ? refuse(instance, NO_VALUE) : STATUS_OK;
}

EXPORTED fmi2Status FMI(GetReal)(
    fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2Real values[]
)
{
    size_t k;
    if (component == NULL || arrays_are_there((const fmu *)component, references, values, count) != STATUS_OK) {
        return fmi2Error;
    }
    for (k = 0; k < count; k++) {
        if (get((fmu *)component, references[k], &values[k]) != STATUS_OK) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

EXPORTED fmi2Status FMI(SetReal)(
    fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2Real values[]
)
{
    size_t k;
    if (component == NULL || arrays_are_there((const fmu *)component, references, values, count) != STATUS_OK) {
        return fmi2Error;
    }
    for (k = 0; k < count; k++) {
        if (set((fmu *)component, references[k], values[k]) != STATUS_OK) {
            return fmi2Error;
        }
    }
    return fmi2OK;
}

EXPORTED fmi2Status FMI(GetFMUstate)(fmi2Component component, fmi2FMUstate *state)
{
    return component == NULL ? fmi2Error : (fmi2Status)save((fmu *)component, state);
}

EXPORTED fmi2Status FMI(SetFMUstate)(fmi2Component component, fmi2FMUstate state)
{
    return component == NULL ? fmi2Error : (fmi2Status)resume((fmu *)component, state);
}

EXPORTED fmi2Status FMI(FreeFMUstate)(fmi2Component component, fmi2FMUstate *state)
{
    if (component == NULL) {
        return fmi2Error;
    }
    free_state((const fmu *)component, state);
    return fmi2OK;
}

EXPORTED fmi2Status FMI(SerializedFMUstateSize)(fmi2Component component, fmi2FMUstate state, size_t *size)
{
    if (component == NULL) {
        return fmi2Error;
    }
    if (state == NULL || size == NULL) {
        return (fmi2Status)refuse((const fmu *)component, NO_VALUE);
    }
    *size = state_size();
    return fmi2OK;
}

EXPORTED fmi2Status FMI(SerializeFMUstate)(fmi2Component component, fmi2FMUstate state, fmi2Byte bytes[], size_t size)
{
    return component == NULL
        ? fmi2Error
        : (fmi2Status)write_state((const fmu *)component, (const life *)state, (unsigned char *)bytes, size);
}

EXPORTED fmi2Status FMI(DeSerializeFMUstate)(
    fmi2Component component, const fmi2Byte bytes[], size_t size, fmi2FMUstate *state
)
{
    return component == NULL ? fmi2Error
                             : (fmi2Status)deserialise((fmu *)component, (const unsigned char *)bytes, size, state);
}

EXPORTED fmi2Status FMI(DoStep)(
    fmi2Component component, fmi2Real current_communication_point, fmi2Real communication_step_size,
    fmi2Boolean no_set_fmu_state_prior_to_current_point
)
{
    (void)no_set_fmu_state_prior_to_current_point;
    return component == NULL
        ? fmi2Error
        : (fmi2Status)do_step((fmu *)component, current_communication_point, communication_step_size);
}

/* The end of the last step. */
EXPORTED fmi2Status FMI(GetRealStatus)(fmi2Component component, const fmi2StatusKind kind, fmi2Real *value)
{
    if (component == NULL) {
        return fmi2Error;
    }
    if (kind != fmi2LastSuccessfulTime) {
        return fmi2Discard;
    }
    return value == NULL ? (fmi2Status)refuse((const fmu *)component, NO_VALUE)
                         : (fmi2Status)get((fmu *)component, 0, value);
}

/* Whether the simulation has ended: no event of the scene ends it. */
EXPORTED fmi2Status FMI(GetBooleanStatus)(fmi2Component component, const fmi2StatusKind kind, fmi2Boolean *value)
{
    if (component == NULL) {
        return fmi2Error;
    }
    if (kind != fmi2Terminated) {
        return fmi2Discard;
    }
    if (value == NULL) {
        return (fmi2Status)refuse((const fmu *)component, NO_VALUE);
    }
    *value = 0;
    return fmi2OK;
}
