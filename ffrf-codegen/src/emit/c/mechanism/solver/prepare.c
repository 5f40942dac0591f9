//@ if RIGID
/* The deformed quantities of a rigid body. */
static void prepare_rigid(int index, const body_state *state, body_work *body)
{
    const rigid_body *rigid = &rigid_bodies[index];
    real product[3];
    body->mass = rigid->mass;
    copy(3, rigid->first_moment, body->first_moment);
    copy(9, rigid->inertia, body->inertia);
//@ if LOOPS
    body->compliance = rigid->compliance;
//@ end
    cross(state->omega, body->first_moment, product);
    cross(state->omega, product, &body->quadratic_velocity[0]);
    along_axes(body->inertia, state->omega, product);
    cross(state->omega, product, &body->quadratic_velocity[3]);
}

//@ end
//@ if FLEXIBLE
/* The coupling of the frame with the modes, mode by mode, from its rows. */
static void take_coupling(int modes, const real *moment, const real *rotation, body_work *body)
{
    int axis;
    int k;
    for (k = 0; k < modes; k++) {
        for (axis = 0; axis < 3; axis++) {
            body->coupling[6 * k + axis] = moment[modes * axis + k];
            body->coupling[6 * k + 3 + axis] = rotation[modes * axis + k];
        }
    }
}

//@ end
