/* A marker in a state: the lever arm, and how the material there is turned by the modes. */
typedef struct {
    int body;
    int modes;
    const real *axes;
    real arm[3];
//@ if FLEXIBLE
    const marker_shape *shape;
    real half[3];
    real share;
//@ if STRESSED
    /* the rows in this deformation */
    marker_shape bent;
//@ end
//@ end
} placed_marker;

//@ if FLEXIBLE
/* What modes with these coefficients do at a marker, along x, y and z. */
static void combine(int modes, const real *rows, const real *amounts, real vector[3])
{
    int axis;
    int k;
    for (axis = 0; axis < 3; axis++) {
        real sum = (real)0;
        for (k = 0; k < modes; k++) {
            sum += rows[MODES * axis + k] * amounts[k];
        }
        vector[axis] = sum;
    }
}

//@ end
//@ if STRESSED
/* The rows of a marker where loads stress the body: they follow the deformation. */
static void bend(const marker_shape *shape, int modes, const real *q, marker_shape *bent)
{
    int axis;
    int k;
    int l;
    *bent = *shape;
    for (axis = 0; axis < 6; axis++) {
        real *row = axis < 3 ? &bent->translation[MODES * axis] : &bent->rotation[MODES * (axis - 3)];
        for (k = 0; k < modes; k++) {
            const real *stressed = &shape->stressed[modes * (modes * axis + k)];
            real sum = (real)0;
            for (l = 0; l < modes; l++) {
                sum += stressed[l] * q[l];
            }
            row[k] -= sum;
        }
    }
}

//@ end
static void place_marker(int marker, const workspace *work, placed_marker *placed)
{
    const marker_place *place = &markers[marker];
    placed->body = place->body;
    placed->modes = 0;
    placed->axes = work->bodies[place->body].axes;
    copy(3, place->position, placed->arm);
//@ if FLEXIBLE
    placed->shape = NULL;
    fill(3, (real)0, placed->half);
    placed->share = (real)1;
    if (place->shape >= 0) {
        const real *q = work->state.bodies[place->body].q;
        real moved[3];
        real turned_by[3];
        placed->shape = &shapes[place->shape];
        placed->modes = flexible_bodies[flexible_of[place->body]].modes;
        combine(placed->modes, placed->shape->translation, q, moved);
        combine(placed->modes, placed->shape->rotation, q, turned_by);
//@ if STRESSED
        if (placed->shape->stressed != NULL) {
            /* The place is the integral of the rows along q: the mean of both. */
            real vector[3];
            int k;
            bend(placed->shape, placed->modes, q, &placed->bent);
            combine(placed->modes, placed->bent.translation, q, vector);
            for (k = 0; k < 3; k++) {
                moved[k] = (moved[k] + vector[k]) * (real)0.5;
            }
            combine(placed->modes, placed->bent.rotation, q, vector);
            for (k = 0; k < 3; k++) {
                turned_by[k] = (turned_by[k] + vector[k]) * (real)0.5;
            }
            placed->shape = &placed->bent;
        }
//@ end
        add_scaled(3, (real)1, moved, placed->arm);
        add_scaled(3, (real)0.5, turned_by, placed->half);
        placed->share = (real)1 / ((real)1 + dot(placed->half, placed->half));
    }
//@ end
}

/* Velocities [v; omega] (inertial) at a marker from velocities or accelerations of its body, without bias. */
static void marker_twist(const placed_marker *placed, const real *moving, real twist[6])
{
    real vector[3];
    cross(&moving[3], placed->arm, vector);
    copy(6, moving, twist);
    add_scaled(3, (real)1, vector, twist);
//@ if FLEXIBLE
    if (placed->shape != NULL) {
        real turning[3];
        combine(placed->modes, placed->shape->translation, &moving[6], vector);
        add_scaled(3, (real)1, vector, twist);
        combine(placed->modes, placed->shape->rotation, &moving[6], turning);
        cross(placed->half, turning, vector);
        add_scaled(3, (real)1, vector, turning);
        add_scaled(3, placed->share, turning, &twist[3]);
    }
//@ end
    along_axes(placed->axes, &twist[0], &twist[0]);
    along_axes(placed->axes, &twist[3], &twist[3]);
}

/* The generalised force of a force and a moment (inertial) at a marker. */
static void marker_force(const placed_marker *placed, const real force[3], const real moment[3], real *generalised)
{
    real vector[3];
    components_along(placed->axes, force, &generalised[0]);
    components_along(placed->axes, moment, &generalised[3]);
//@ if FLEXIBLE
    if (placed->shape != NULL) {
        real share[3];
        int k;
        cross(placed->half, &generalised[3], vector);
        for (k = 0; k < 3; k++) {
            share[k] = (generalised[3 + k] - vector[k]) * placed->share;
        }
        for (k = 0; k < placed->modes; k++) {
            const real *along = &placed->shape->translation[k];
            const real *about = &placed->shape->rotation[k];
            generalised[6 + k] = along[0] * generalised[0] + along[MODES] * generalised[1]
                + along[2 * MODES] * generalised[2] + about[0] * share[0] + about[MODES] * share[1]
                + about[2 * MODES] * share[2];
        }
    }
//@ end
    cross(placed->arm, &generalised[0], vector);
    add_scaled(3, (real)1, vector, &generalised[3]);
}

//@ if STRESSED
/* Adds what the rows change with time to the bias of a motion, along the axes of the body. */
static void add_bending(const placed_marker *placed, const marker_shape *straight, const real *q_dot, motion *moving)
{
    marker_shape rates;
    real change[3];
    real vector[3];
    bend(straight, placed->modes, q_dot, &rates);
    combine(placed->modes, rates.translation, q_dot, change);
    combine(placed->modes, straight->translation, q_dot, vector);
    add_scaled(3, (real)-1, vector, change);
    add_scaled(3, (real)1, change, moving->bias);
    combine(placed->modes, rates.rotation, q_dot, change);
    combine(placed->modes, straight->rotation, q_dot, vector);
    add_scaled(3, (real)-1, vector, change);
    cross(placed->half, change, vector);
    add_scaled(3, (real)1, vector, change);
    add_scaled(3, placed->share, change, moving->omega_bias);
}

//@ end
/* Place and motion of a triad at a marker or on the ground. */
static void attachment_motion(const attachment *at, const workspace *work, motion *moving)
{
    placed_marker placed;
    const body_state *state;
    real vector[3];
    real carried[3];
    real orientation[4];
    int k;
    if (at->marker < 0) {
        copy(3, at->position, moving->position);
        copy(4, at->orientation, moving->orientation);
        fill(3, (real)0, moving->velocity);
        fill(3, (real)0, moving->omega);
        fill(3, (real)0, moving->bias);
        fill(3, (real)0, moving->omega_bias);
        return;
    }
    place_marker(at->marker, work, &placed);
    state = &work->state.bodies[placed.body];
    cross(state->omega, placed.arm, carried);
    copy(3, state->omega, moving->omega);
    fill(3, (real)0, moving->omega_bias);
    copy(3, carried, vector);
    copy(4, state->orientation, orientation);
//@ if FLEXIBLE
    if (placed.shape != NULL) {
        const real none[4] = {(real)1, (real)0, (real)0, (real)0};
        real shift[3];
        real turning[3];
        real spin[3];
        real twice[3];
        real slowing;
        real rotation[4];
        combine(placed.modes, placed.shape->translation, state->q_dot, shift);
        combine(placed.modes, placed.shape->rotation, state->q_dot, turning);
        cross(placed.half, turning, spin);
        slowing = dot(placed.half, turning) * placed.share;
        for (k = 0; k < 3; k++) {
            spin[k] = (turning[k] + spin[k]) * placed.share;
            carried[k] += shift[k];
            vector[k] = carried[k] + shift[k];
            twice[k] = placed.half[k] * (real)2;
        }
        cross(state->omega, spin, moving->omega_bias);
        add_scaled(3, -slowing, spin, moving->omega_bias);
        add_scaled(3, (real)1, spin, moving->omega);
        turned(none, twice, rotation);
        quaternion_product(state->orientation, rotation, orientation);
    }
//@ end
    cross(state->omega, vector, moving->bias);
//@ if STRESSED
    if (placed.shape == &placed.bent) {
        add_bending(&placed, &shapes[markers[at->marker].shape], state->q_dot, moving);
    }
//@ end
    along_axes(placed.axes, moving->bias, moving->bias);
    along_axes(placed.axes, moving->omega_bias, moving->omega_bias);
    along_axes(placed.axes, moving->omega, moving->omega);
    along_axes(placed.axes, placed.arm, vector);
    along_axes(placed.axes, carried, carried);
    for (k = 0; k < 3; k++) {
        moving->position[k] = state->position[k] + vector[k];
        moving->velocity[k] = state->velocity[k] + carried[k];
    }
    quaternion_product(orientation, at->orientation, moving->orientation);
}

//@ if FORCES
/* Adds a force and a moment (inertial) at an attachment to the forces on its body. */
static void push(const attachment *at, const real force[3], const real moment[3], workspace *work)
{
    placed_marker placed;
    real generalised[VELOCITIES];
    if (at->marker < 0) {
        return;
    }
    place_marker(at->marker, work, &placed);
    marker_force(&placed, force, moment, generalised);
    add_scaled(6 + placed.modes, (real)1, generalised, work->bodies[placed.body].force);
}
//@ end
