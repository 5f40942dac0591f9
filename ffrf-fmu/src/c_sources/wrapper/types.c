enum {
    PLACES_OF_PARAMETERS = PARAMETERS > 0 ? PARAMETERS : 1,
    PLACES_OF_INPUTS = INPUTS > 0 ? INPUTS : 1,
    PLACES_OF_ANGLES = ANGLES > 0 ? ANGLES : 1,
    LONGEST_MESSAGE = 512
};

/* How far the life of an instance has come. */
enum { INSTANTIATED, INITIALISATION, STEPPING, TERMINATED };

/* A sample as close as this share of a step to the end of a whole step is that end. */
#define SAME_TIME 1e-9
/* How far a communication point may be from where the last step led, as a share of the step: other tools sum up steps. */
#define SAME_POINT 1e-3

/* Everything of an instance that changes; it is saved and taken up again by assignment. */
typedef struct {
    int phase;
    /* whether a simulation has begun: then what stands behind the inputs is set */
    int has_begun;
    double start;
    double parameters[PLACES_OF_PARAMETERS];
    /* those that are not set follow the function of time of the scene */
    @P_inputs inputs;
    /* after the last whole step, and where steps are counted from */
    @P_state whole;
    double grid;
    double count;
    /* at the communication point */
    @P_state now;
    /* of angle sensors, counted over turns since the beginning */
    int angles_are_known;
    double angles[PLACES_OF_ANGLES];
} life;

/* An instance: its life, what is measured where it has come to, and where its messages go. */
typedef struct {
    life life;
    /* what follows from the parameters, and whether it is there */
    @P_tables tables;
    int is_composed;
    double values[COLUMNS];
    int is_measured;
    /* no event of a scene is in C: nothing but errors is reported */
    int is_logging;
    /* of FMI 2.0, which says it before initialisation */
    double announced_start;
    caller caller;
} fmu;

/* Reports why something cannot be done. */
static int refuse(const fmu *instance, const char *format, ...)
{
    char message[LONGEST_MESSAGE];
    va_list arguments;
    va_start(arguments, format);
    (void)vsnprintf(message, sizeof message, format, arguments);
    va_end(arguments);
    report(&instance->caller, STATUS_ERROR, "logStatusError", message);
    return STATUS_ERROR;
}

/* A not a number and an infinity are neither. */
static int number_is_finite(double x)
{
    return 0.0 * x >= 0.0;
}

static double distance(double a, double b)
{
    return a < b ? b - a : a - b;
}

/* The nearest whole number, of two the one farther from zero. */
static double rounded(double x)
{
    /* beyond this all numbers are whole */
    if (!(x < 4503599627370496.0 && x > -4503599627370496.0)) {
        return x;
    }
    {
        const double whole = (double)(int64_t)x;
        if (x - whole >= 0.5) {
            return whole + 1.0;
        }
        return x - whole <= -0.5 ? whole - 1.0 : whole;
    }
}

/* The largest whole number that is not larger. */
static double whole_below(double x)
{
    const double near = rounded(x);
    return near > x ? near - 1.0 : near;
}
