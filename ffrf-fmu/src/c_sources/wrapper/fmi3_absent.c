/*
 * Functions that every binary has and that mean nothing here: other kinds of simulation, other types of variables, clocks,
 * derivatives. They answer with an error, or do nothing where nothing is asked for.
 */

static fmi3Status has_none(const fmi3Instance instance, const char *function)
{
    return instance == NULL ? fmi3Error
                            : (fmi3Status)refuse((const fmu *)instance, "%s: this FMU has no such thing", function);
}

static fmi3Status has_no_variables(const fmi3Instance instance, const char *function, size_t count)
{
    if (instance == NULL || count == 0) {
        return instance == NULL ? fmi3Error : fmi3OK;
    }
    return (fmi3Status)refuse((const fmu *)instance, "%s: this FMU has no variables of that type", function);
}

EXPORTED fmi3Instance FMI(InstantiateModelExchange)(
    fmi3String instance_name, fmi3String instantiation_token, fmi3String resource_path, fmi3Boolean visible,
    fmi3Boolean logging_on, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log_message
)
{
    const caller to = {environment, log_message};
    (void)instance_name;
    (void)instantiation_token;
    (void)resource_path;
    (void)visible;
    (void)logging_on;
    report(&to, STATUS_ERROR, "logStatusError", "this FMU is for co-simulation only");
    return NULL;
}

EXPORTED fmi3Instance FMI(InstantiateScheduledExecution)(
    fmi3String instance_name, fmi3String instantiation_token, fmi3String resource_path, fmi3Boolean visible,
    fmi3Boolean logging_on, fmi3InstanceEnvironment environment, fmi3LogMessageCallback log_message,
    fmi3ClockUpdateCallback clock_update, fmi3LockPreemptionCallback lock_preemption,
    fmi3UnlockPreemptionCallback unlock_preemption
)
{
    const caller to = {environment, log_message};
    (void)instance_name;
    (void)instantiation_token;
    (void)resource_path;
    (void)visible;
    (void)logging_on;
    (void)clock_update;
    (void)lock_preemption;
    (void)unlock_preemption;
    report(&to, STATUS_ERROR, "logStatusError", "this FMU is for co-simulation only");
    return NULL;
}

#define NO_VARIABLES(type) \
    EXPORTED fmi3Status FMI(Get##type)( \
        fmi3Instance instance, const fmi3ValueReference references[], size_t count, fmi3##type values[], size_t value_count \
    ) \
    { \
        (void)references; \
        (void)values; \
        (void)value_count; \
        return has_no_variables(instance, "fmi3Get" #type, count); \
    } \
    EXPORTED fmi3Status FMI(Set##type)( \
        fmi3Instance instance, const fmi3ValueReference references[], size_t count, const fmi3##type values[], \
        size_t value_count \
    ) \
    { \
        (void)references; \
        (void)values; \
        (void)value_count; \
        return has_no_variables(instance, "fmi3Set" #type, count); \
    }

NO_VARIABLES(Float32)
NO_VARIABLES(Int8)
NO_VARIABLES(UInt8)
NO_VARIABLES(Int16)
NO_VARIABLES(UInt16)
NO_VARIABLES(Int32)
NO_VARIABLES(UInt32)
NO_VARIABLES(Int64)
NO_VARIABLES(UInt64)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

/* A function of value references, their number and whatever else. */
#define NONE_OF_THOSE(name, arguments, unused) \
    EXPORTED fmi3Status FMI(name) arguments \
    { \
        (void)references; \
        unused; \
        return has_no_variables(instance, "fmi3" #name, count); \
    }
#define REFERENCES fmi3Instance instance, const fmi3ValueReference references[], size_t count

NONE_OF_THOSE(
    GetBinary, (REFERENCES, size_t sizes[], fmi3Binary values[], size_t value_count),
    ((void)sizes, (void)values, (void)value_count)
)
NONE_OF_THOSE(
    SetBinary, (REFERENCES, const size_t sizes[], const fmi3Binary values[], size_t value_count),
    ((void)sizes, (void)values, (void)value_count)
)
NONE_OF_THOSE(GetClock, (REFERENCES, fmi3Clock values[]), (void)values)
NONE_OF_THOSE(SetClock, (REFERENCES, const fmi3Clock values[]), (void)values)
NONE_OF_THOSE(
    GetIntervalDecimal, (REFERENCES, fmi3Float64 intervals[], fmi3IntervalQualifier qualifiers[]),
    ((void)intervals, (void)qualifiers)
)
NONE_OF_THOSE(
    GetIntervalFraction,
    (REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[], fmi3IntervalQualifier qualifiers[]),
    ((void)counters, (void)resolutions, (void)qualifiers)
)
NONE_OF_THOSE(GetShiftDecimal, (REFERENCES, fmi3Float64 shifts[]), (void)shifts)
NONE_OF_THOSE(
    GetShiftFraction, (REFERENCES, fmi3UInt64 counters[], fmi3UInt64 resolutions[]), ((void)counters, (void)resolutions)
)
NONE_OF_THOSE(SetIntervalDecimal, (REFERENCES, const fmi3Float64 intervals[]), (void)intervals)
NONE_OF_THOSE(
    SetIntervalFraction, (REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]),
    ((void)counters, (void)resolutions)
)
NONE_OF_THOSE(SetShiftDecimal, (REFERENCES, const fmi3Float64 shifts[]), (void)shifts)
NONE_OF_THOSE(
    SetShiftFraction, (REFERENCES, const fmi3UInt64 counters[], const fmi3UInt64 resolutions[]),
    ((void)counters, (void)resolutions)
)
NONE_OF_THOSE(
    GetOutputDerivatives, (REFERENCES, const fmi3Int32 orders[], fmi3Float64 values[], size_t value_count),
    ((void)orders, (void)values, (void)value_count)
)

/* A function that nothing can be asked of. */
#define ABSENT(name, arguments, unused) \
    EXPORTED fmi3Status FMI(name) arguments \
    { \
        unused; \
        return has_none(instance, "fmi3" #name); \
    }

ABSENT(EnterEventMode, (fmi3Instance instance), (void)0)
ABSENT(EnterConfigurationMode, (fmi3Instance instance), (void)0)
ABSENT(ExitConfigurationMode, (fmi3Instance instance), (void)0)
ABSENT(EvaluateDiscreteStates, (fmi3Instance instance), (void)0)
ABSENT(EnterContinuousTimeMode, (fmi3Instance instance), (void)0)
ABSENT(EnterStepMode, (fmi3Instance instance), (void)0)
ABSENT(SetTime, (fmi3Instance instance, fmi3Float64 time), (void)time)
ABSENT(
    GetNumberOfVariableDependencies, (fmi3Instance instance, fmi3ValueReference reference, size_t *count),
    ((void)reference, (void)count)
)
ABSENT(
    GetVariableDependencies,
    (fmi3Instance instance, fmi3ValueReference dependent, size_t elements_of_dependent[],
     fmi3ValueReference independents[], size_t elements_of_independents[], fmi3DependencyKind kinds[], size_t count),
    ((void)dependent, (void)elements_of_dependent, (void)independents, (void)elements_of_independents, (void)kinds,
     (void)count)
)
ABSENT(
    GetDirectionalDerivative,
    (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_count, const fmi3ValueReference knowns[],
     size_t known_count, const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[], size_t sensitivity_count),
    ((void)unknowns, (void)unknown_count, (void)knowns, (void)known_count, (void)seed, (void)seed_count,
     (void)sensitivity, (void)sensitivity_count)
)
ABSENT(
    GetAdjointDerivative,
    (fmi3Instance instance, const fmi3ValueReference unknowns[], size_t unknown_count, const fmi3ValueReference knowns[],
     size_t known_count, const fmi3Float64 seed[], size_t seed_count, fmi3Float64 sensitivity[], size_t sensitivity_count),
    ((void)unknowns, (void)unknown_count, (void)knowns, (void)known_count, (void)seed, (void)seed_count,
     (void)sensitivity, (void)sensitivity_count)
)
ABSENT(
    UpdateDiscreteStates,
    (fmi3Instance instance, fmi3Boolean *update_needed, fmi3Boolean *terminated, fmi3Boolean *nominals_changed,
     fmi3Boolean *values_changed, fmi3Boolean *next_time_defined, fmi3Float64 *next_time),
    ((void)update_needed, (void)terminated, (void)nominals_changed, (void)values_changed, (void)next_time_defined,
     (void)next_time)
)
ABSENT(
    CompletedIntegratorStep,
    (fmi3Instance instance, fmi3Boolean no_set, fmi3Boolean *enter_event_mode, fmi3Boolean *terminated),
    ((void)no_set, (void)enter_event_mode, (void)terminated)
)
ABSENT(SetContinuousStates, (fmi3Instance instance, const fmi3Float64 states[], size_t count), ((void)states, (void)count))
ABSENT(
    GetContinuousStateDerivatives, (fmi3Instance instance, fmi3Float64 values[], size_t count), ((void)values, (void)count)
)
ABSENT(GetEventIndicators, (fmi3Instance instance, fmi3Float64 values[], size_t count), ((void)values, (void)count))
ABSENT(GetContinuousStates, (fmi3Instance instance, fmi3Float64 values[], size_t count), ((void)values, (void)count))
ABSENT(
    GetNominalsOfContinuousStates, (fmi3Instance instance, fmi3Float64 values[], size_t count), ((void)values, (void)count)
)
ABSENT(GetNumberOfEventIndicators, (fmi3Instance instance, size_t *count), (void)count)
ABSENT(GetNumberOfContinuousStates, (fmi3Instance instance, size_t *count), (void)count)
ABSENT(
    ActivateModelPartition, (fmi3Instance instance, fmi3ValueReference clock, fmi3Float64 time),
    ((void)clock, (void)time)
)
