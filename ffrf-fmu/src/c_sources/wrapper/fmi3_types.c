#ifdef FFRF_STANDARD_HEADERS
#include "fmi3Functions.h"
#else
/* The types of FMI 3.0 that are used here; sources are complete without the headers of the standard. */
typedef void *fmi3Instance;
typedef void *fmi3InstanceEnvironment;
typedef void *fmi3FMUState;
typedef uint32_t fmi3ValueReference;
typedef float fmi3Float32;
typedef double fmi3Float64;
typedef int8_t fmi3Int8;
typedef uint8_t fmi3UInt8;
typedef int16_t fmi3Int16;
typedef uint16_t fmi3UInt16;
typedef int32_t fmi3Int32;
typedef uint32_t fmi3UInt32;
typedef int64_t fmi3Int64;
typedef uint64_t fmi3UInt64;
typedef bool fmi3Boolean;
typedef const char *fmi3String;
typedef uint8_t fmi3Byte;
typedef const fmi3Byte *fmi3Binary;
typedef bool fmi3Clock;
typedef enum { fmi3OK, fmi3Warning, fmi3Discard, fmi3Error, fmi3Fatal } fmi3Status;
typedef enum { fmi3Independent, fmi3Constant, fmi3Fixed, fmi3Tunable, fmi3Discrete, fmi3Dependent } fmi3DependencyKind;
typedef enum { fmi3IntervalNotYetKnown, fmi3IntervalUnchanged, fmi3IntervalChanged } fmi3IntervalQualifier;
typedef void (*fmi3LogMessageCallback)(
    fmi3InstanceEnvironment environment, fmi3Status status, fmi3String category, fmi3String message
);
typedef void (*fmi3ClockUpdateCallback)(fmi3InstanceEnvironment environment);
typedef void (*fmi3IntermediateUpdateCallback)(
    fmi3InstanceEnvironment environment, fmi3Float64 time, fmi3Boolean set_requested, fmi3Boolean get_allowed,
    fmi3Boolean step_finished, fmi3Boolean can_return_early, fmi3Boolean *early_return, fmi3Float64 *early_return_time
);
typedef void (*fmi3LockPreemptionCallback)(void);
typedef void (*fmi3UnlockPreemptionCallback)(void);
#endif

/*
 * Functions have the names of the standard; where FMUs are linked into one program, FMI3_FUNCTION_PREFIX stands before them,
 * unless FMI3_OVERRIDE_FUNCTION_PREFIX is defined.
 */
#ifndef FFRF_STANDARD_HEADERS
#if defined(FMI3_FUNCTION_PREFIX) && !defined(FMI3_OVERRIDE_FUNCTION_PREFIX)
#define FFRF_JOINED_AS(a, b) a##b
#define FFRF_JOINED(a, b) FFRF_JOINED_AS(a, b)
#define FMI(name) FFRF_JOINED(FMI3_FUNCTION_PREFIX, fmi3##name)
#else
#define FMI(name) fmi3##name
#endif
#else
#define FMI(name) fmi3##name
#endif

#ifndef FMI3_Export
#if defined(_WIN32) || defined(__CYGWIN__)
#define FMI3_Export __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI3_Export __attribute__((visibility("default")))
#else
#define FMI3_Export
#endif
#endif
#define EXPORTED FMI3_Export

enum { STATUS_OK = fmi3OK, STATUS_ERROR = fmi3Error };

#define NO_VALUE "a null pointer was passed where a value is expected"
#define OTHER_TOKEN "the sources of this binary are not those of this model description: another token was given"

/* Where the messages of an instance go. */
typedef struct {
    fmi3InstanceEnvironment environment;
    fmi3LogMessageCallback log;
} caller;

static void report(const caller *to, int status, const char *category, const char *message)
{
    if (to->log != NULL) {
        to->log(to->environment, (fmi3Status)status, category, message);
    }
}

static void *allocate(const caller *from, size_t size)
{
    (void)from;
    return calloc(1, size);
}

static void release(const caller *from, void *place)
{
    (void)from;
    free(place);
}
