/* One end of a joint on a body; -1 on the ground. */
typedef struct {
    int end;
    int block;
    int transposed;
} @Send_place;

/* A triad at a marker, or on the ground where the marker is -1. */
typedef struct {
    int marker;
    @R position[3];
    @R orientation[4];
} @Sattachment;

/* A joint, a drive or a soft link between two triads: where its multipliers stand. */
typedef struct {
    int rows;
    int node;
    int diagonal;
    @Send_place ends[2];
    @Sattachment at[2];
    int relations;
    int relation_count;
    int drive;
    int drive_count;
} @Slink_place;

/* One relation between two triads, with what it depends on. */
typedef struct {
    int kind;
    int held;
    @R length;
} @Srelation;

//@ if ELEMENTS
/*
 * A force element. A constant force and moment stand in the place of the stiffness, and its option is whether it turns with the
 * body; of friction, the stiffness is its limit, `rest` its speed, and the option where it acts.
 */
typedef struct {
    int kind;
    @Sattachment at[2];
    @R stiffness[6];
    @R damping[6];
    @R rest;
    int option;
} @Selement;

//@ end
//@ if ACTUATORS
/* A force or moment that follows an input. */
typedef struct {
    int effort;
    @Sattachment at[2];
    @R gain;
    @R limit;
} @Sactuator;

//@ end
