/* What the functions of this library answer. */
#ifndef FFRF_STATUS_H
#define FFRF_STATUS_H

typedef enum {
    /* Done. */
    FFRF_OK = 0,
    /* A null pointer where a value or an object is expected. */
    FFRF_NULL_POINTER = 1,
    /* There is no object: the init function was not called on it. */
    FFRF_NOT_INITIALISED = 2,
    /* A number that is given is infinite or not a number; nothing has changed. */
    FFRF_NOT_FINITE = 3,
    /* The step is zero, negative or not finite; nothing has changed. */
    FFRF_STEP_SIZE = 4,
    /* The step leads nowhere: it is too large, or a force is absurd; nothing has changed. */
    FFRF_STEP_REFUSED = 5,
    /* The joints could not be met again at the end of the step; nothing has changed. */
    FFRF_JOINTS_NOT_MET = 6,
    /* The numbers are no state: an orientation is no rotation; nothing has changed. */
    FFRF_NO_STATE = 7
} ffrf_status;

#endif /* FFRF_STATUS_H */
