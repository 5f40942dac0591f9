#ifdef FFRF_STANDARD_HEADERS
#include "fmi2Functions.h"
#else
/* The types of FMI 2.0 that are used here; sources are complete without the headers of the standard. */
typedef void *fmi2Component;
typedef void *fmi2ComponentEnvironment;
typedef void *fmi2FMUstate;
typedef unsigned int fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef char fmi2Char;
typedef const fmi2Char *fmi2String;
typedef char fmi2Byte;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef enum { fmi2ModelExchange, fmi2CoSimulation } fmi2Type;
typedef enum { fmi2DoStepStatus, fmi2PendingStatus, fmi2LastSuccessfulTime, fmi2Terminated } fmi2StatusKind;
typedef void (*fmi2CallbackLogger)(
    fmi2ComponentEnvironment environment, fmi2String instance_name, fmi2Status status, fmi2String category,
    fmi2String message, ...
);
typedef void *(*fmi2CallbackAllocateMemory)(size_t count, size_t size);
typedef void (*fmi2CallbackFreeMemory)(void *place);
typedef void (*fmi2StepFinished)(fmi2ComponentEnvironment environment, fmi2Status status);
typedef struct {
    fmi2CallbackLogger logger;
    fmi2CallbackAllocateMemory allocateMemory;
    fmi2CallbackFreeMemory freeMemory;
    fmi2StepFinished stepFinished;
    fmi2ComponentEnvironment componentEnvironment;
} fmi2CallbackFunctions;
#endif

/*
 * Functions have the names of the standard; where FMUs are linked into one program, FMI2_FUNCTION_PREFIX stands before them,
 * unless FMI2_OVERRIDE_FUNCTION_PREFIX is defined.
 */
#if !defined(FFRF_STANDARD_HEADERS) && defined(FMI2_FUNCTION_PREFIX) && !defined(FMI2_OVERRIDE_FUNCTION_PREFIX)
#define FFRF_JOINED_AS(a, b) a##b
#define FFRF_JOINED(a, b) FFRF_JOINED_AS(a, b)
#define FMI(name) FFRF_JOINED(FMI2_FUNCTION_PREFIX, fmi2##name)
#else
#define FMI(name) fmi2##name
#endif

#ifndef FMI2_Export
#if defined(_WIN32) || defined(__CYGWIN__)
#define FMI2_Export __declspec(dllexport)
#elif defined(__GNUC__)
#define FMI2_Export __attribute__((visibility("default")))
#else
#define FMI2_Export
#endif
#endif
#define EXPORTED FMI2_Export

enum { STATUS_OK = fmi2OK, STATUS_ERROR = fmi2Error, LONGEST_NAME = 128 };

#define NO_VALUE "a null pointer was passed where a value is expected"
#define OTHER_TOKEN "the sources of this binary are not those of this model description: another token was given"

/* Where the messages of an instance go, and whose memory it has: the caller's, or that of C where this has none. */
typedef struct {
    char name[LONGEST_NAME];
    fmi2ComponentEnvironment environment;
    fmi2CallbackLogger log;
    fmi2CallbackAllocateMemory allocate;
    fmi2CallbackFreeMemory release;
} caller;

static void report(const caller *to, int status, const char *category, const char *message)
{
    if (to->log != NULL) {
        to->log(to->environment, to->name, (fmi2Status)status, category, "%s", message);
    }
}

static void *allocate(const caller *from, size_t size)
{
    return from->allocate != NULL ? from->allocate(1, size) : calloc(1, size);
}

static void release(const caller *from, void *place)
{
    if (from->allocate == NULL) {
        free(place);
    } else if (from->release != NULL) {
        from->release(place);
    }
}
