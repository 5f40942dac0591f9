//@ if ELEMENTS
/* The energy that a force element stores. */
static real stored(const element *one, const workspace *work)
{
    motion at[2];
    attachment_motion(&one->at[0], work, &at[0]);
    attachment_motion(&one->at[1], work, &at[1]);
    switch (one->kind) {
//@ if SPRING
    case SPRING: {
        real between[3];
        real stretch;
        int k;
        for (k = 0; k < 3; k++) {
            between[k] = at[1].position[k] - at[0].position[k];
        }
        stretch = square_root(dot(between, between)) - one->rest;
        return one->stiffness[0] * stretch * stretch * (real)0.5;
    }
//@ end
//@ if TORSION_SPRING
    case TORSION_SPRING: {
        const real angle = angle_from_rest(one, at);
        return one->stiffness[0] * angle * angle * (real)0.5;
    }
//@ end
//@ if BUSHING
    case BUSHING: {
        real axes[9];
        real between[3];
        real displacement[3];
        real relative[4];
        real sum = (real)0;
        int k;
        axes_of(at[0].orientation, axes);
        for (k = 0; k < 3; k++) {
            between[k] = at[1].position[k] - at[0].position[k];
        }
        components_along(axes, between, displacement);
        relative_rotation(at, relative);
        for (k = 0; k < 3; k++) {
            sum += displacement[k] * displacement[k] * one->stiffness[k];
        }
        for (k = 0; k < 3; k++) {
            const real turn = relative[1 + k] * (real)2;
            sum += turn * turn * one->stiffness[3 + k];
        }
        return sum * (real)0.5;
    }
//@ end
    default:
        return (real)0;
    }
}

//@ end
int @P_observe(@Gconst mechanism_state *state, @P_observables *observed)
{
    workspace space;
    workspace *work = &space;
    real left[2];
    int status;
    int index;
    int k;
//@ if PARAMETERS
    work->tables = tables;
//@ end
    if (!(state_is_finite(state) && is_finite(state->time))) {
        return @M_STATE_NOT_FINITE;
    }
    work->state = *state;
    prepare_all(work);
    status = evaluate_links(state->time, (real)0, work);
    if (status != DONE) {
        return status;
    }
    observed->kinetic = (real)0;
    observed->elastic = (real)0;
    observed->potential = (real)0;
    for (index = 0; index < BODIES; index++) {
        const body_state *at = &state->bodies[index];
        const body_work *body = &work->bodies[index];
        real moving[VELOCITIES];
        real momentum[VELOCITIES];
        real moment[3];
        components_along(body->axes, at->velocity, &moving[0]);
        copy(3, at->omega, &moving[3]);
//@ if FLEXIBLE
        copy(MODES, at->q_dot, &moving[6]);
//@ end
        fill(VELOCITIES, (real)0, momentum);
        subtract_momentum(index, body, moving, momentum);
        for (k = 0; k < VELOCITIES; k++) {
            observed->kinetic -= momentum[k] * moving[k] * (real)0.5;
        }
//@ if FLEXIBLE
        if (flexible_of[index] >= 0) {
            const flexible_body *flexible = &flexible_bodies[flexible_of[index]];
            real force[MODES];
            fill(MODES, (real)0, force);
            add_modal_product(flexible, flexible->stiffness, (real)1, at->q, force);
            for (k = 0; k < flexible->modes; k++) {
                observed->elastic += force[k] * at->q[k] * (real)0.5;
            }
        }
//@ end
        along_axes(body->axes, body->first_moment, moment);
        add_scaled(3, body->mass, at->position, moment);
        observed->potential -= dot(@Tgravity, moment);
    }
//@ if ELEMENTS
    for (index = 0; index < ELEMENTS; index++) {
        observed->potential += stored(&@Telements[index], work);
    }
//@ end
    residuals(work, left);
    observed->position_drift = left[0];
    observed->velocity_drift = left[1];
    return DONE;
}
