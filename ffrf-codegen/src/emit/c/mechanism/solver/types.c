/* A node in the order of elimination: its unknowns, its diagonal block, and what is coupled to it when its turn comes. */
typedef struct {
    int size;
    int node;
    int diagonal;
    int couplings;
    int coupling_count;
    int targets;
} step_place;

/* A later node. */
typedef struct {
    int size;
    int node;
} coupling_place;

//@ if SHARED
/* The ends of two links on one flexible body. */
typedef struct {
    int rows;
    int row_count;
    int columns;
    int column_count;
    int block;
} shared_place;

//@ end
//@ if RIGID
/* A body without modes. */
typedef struct {
    real mass;
    real first_moment[3];
    real inertia[9];
//@ if LOOPS
    /* accelerations of the frame that a force on it gives, row by row */
    real compliance[36];
//@ end
} rigid_body;

//@ end
//@ if FLEXIBLE
/* The constant matrices of a body with modes, row by row. */
typedef struct {
    int modes;
    int is_diagonal;
    const real *modal_mass;
    const real *stiffness;
    const real *damping;
} flexible_body;

//@ end
//@ if SENSORS
/* What is measured, and where it stands among the outputs. */
typedef struct {
    int kind;
    int first;
    attachment at;
    int link;
    int link_count;
} sensor;

//@ end
/* A point of a body; `shape` is where it is found among the mode shapes, or -1. */
typedef struct {
    int body;
    real position[3];
    int shape;
} marker_place;

//@ if FLEXIBLE
/* How modes move a marker: x, y, z, then about them. */
typedef struct {
    real translation[3 * MODES];
    real rotation[3 * MODES];
//@ if STRESSED
    /* unit loads along and about the axes: what the modes do less per modal coordinate, matrix by matrix; or none */
    const real *stressed;
//@ end
} marker_shape;

//@ end
/* Place and motion of a triad. Frame: inertial. */
typedef struct {
    real position[3];
    real orientation[4];
    real velocity[3];
    real omega[3];
    /* accelerations if those of the body were zero */
    real bias[3];
    real omega_bias[3];
} motion;

/* The rows of a link; their gradients at both ends component by component. Frame: inertial. */
typedef struct {
    int count;
    real residual[6];
    real rate[6];
    real bias[6];
    real gradients[2][36];
} row_set;

/* One body in one state. Frame: body. */
typedef struct {
    real axes[9];
    real mass;
    real first_moment[3];
    real inertia[9];
    real quadratic_velocity[VELOCITIES];
    /* of forces; then what is left of it to accelerate */
    real force[VELOCITIES];
    /* the result: accelerations, or a correction of place or velocities */
    real result[VELOCITIES];
    /* the mass matrix without its modes */
    real remaining[36];
//@ if LOOPS
    /* of a rigid body */
    const real *compliance;
//@ end
//@ if FLEXIBLE
    /* C', mode by mode */
    real coupling[6 * MODES];
    real internal_force[MODES];
    /* of the modal mass with implicit terms: its lower Cholesky factor, one over the diagonal in its place */
    real factors[MODES * MODES];
    /* how modes follow the frame, mode by mode */
    real followed[6 * MODES];
    real alone[MODES];
//@ end
} body_work;

//@ if FLEXIBLE
/* The rows of a link on one body: what they do to its modes, and how these answer; mode by mode. */
typedef struct {
    real modal[6 * MODES];
    real weighted[6 * MODES];
} end_work;

//@ end
/* All numbers of one evaluation. */
typedef struct {
//@ if PARAMETERS
    const @P_tables *tables;
//@ end
    mechanism_state state;
    body_work bodies[BODIES];
//@ if FLEXIBLE
    end_work ends[ENDS];
//@ end
    motion at[LINKS > 0 ? LINKS : 1][2];
    row_set rows[LINKS > 0 ? LINKS : 1];
    real blocks[36 * BLOCKS];
    real solution[6 * NODES];
    real right[6 * NODES];
    real shift[6 * NODES];
} workspace;

/* What a linearly implicit stage adds to an evaluation; gamma h is zero in explicit ones. */
typedef struct {
    real gamma_h;
    const real *subtracted;
    const real *increment;
} stage_terms;
