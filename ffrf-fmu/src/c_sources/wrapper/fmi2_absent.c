/*
 * Functions that every binary has and that mean nothing here: other types of variables, derivatives, steps that wait. They
 * answer with an error, or do nothing where nothing is asked for.
 */

static fmi2Status has_none(const fmi2Component component, const char *function, size_t count)
{
    if (component == NULL || count == 0) {
        return component == NULL ? fmi2Error : fmi2OK;
    }
    return (fmi2Status)refuse((const fmu *)component, "%s: this FMU has no such thing", function);
}

#define NO_VARIABLES(type) \
    EXPORTED fmi2Status FMI(Get##type)( \
        fmi2Component component, const fmi2ValueReference references[], size_t count, fmi2##type values[] \
    ) \
    { \
        (void)references; \
        (void)values; \
        return has_none(component, "fmi2Get" #type, count); \
    } \
    EXPORTED fmi2Status FMI(Set##type)( \
        fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2##type values[] \
    ) \
    { \
        (void)references; \
        (void)values; \
        return has_none(component, "fmi2Set" #type, count); \
    }

NO_VARIABLES(Integer)
NO_VARIABLES(Boolean)
NO_VARIABLES(String)

EXPORTED fmi2Status FMI(GetDirectionalDerivative)(
    fmi2Component component, const fmi2ValueReference unknowns[], size_t unknown_count, const fmi2ValueReference knowns[],
    size_t known_count, const fmi2Real seed[], fmi2Real sensitivity[]
)
{
    (void)unknowns;
    (void)knowns;
    (void)known_count;
    (void)seed;
    (void)sensitivity;
    return has_none(component, "fmi2GetDirectionalDerivative", unknown_count);
}

EXPORTED fmi2Status FMI(SetRealInputDerivatives)(
    fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
    const fmi2Real values[]
)
{
    (void)references;
    (void)orders;
    (void)values;
    return has_none(component, "fmi2SetRealInputDerivatives", count);
}

EXPORTED fmi2Status FMI(GetRealOutputDerivatives)(
    fmi2Component component, const fmi2ValueReference references[], size_t count, const fmi2Integer orders[],
    fmi2Real values[]
)
{
    (void)references;
    (void)orders;
    (void)values;
    return has_none(component, "fmi2GetRealOutputDerivatives", count);
}

EXPORTED fmi2Status FMI(CancelStep)(fmi2Component component)
{
    return has_none(component, "fmi2CancelStep", 1);
}

/* Steps end before they return: nothing can be asked of one that is under way. */
#define NO_STATUS(type, kind_of_value) \
    EXPORTED fmi2Status FMI(Get##type##Status)(fmi2Component component, const fmi2StatusKind kind, kind_of_value *value) \
    { \
        (void)kind; \
        (void)value; \
        return component == NULL ? fmi2Error : fmi2Discard; \
    }

NO_STATUS(, fmi2Status)
NO_STATUS(Integer, fmi2Integer)
NO_STATUS(String, fmi2String)
