//@ if FLEXIBLE
/* The lower Cholesky factor of a matrix in place, one over its diagonal there; a diagonal one is only inverted. */
static int factor_modal(int modes, int is_diagonal, real *matrix)
{
    int i;
    int j;
    int k;
    for (j = 0; j < modes; j++) {
        real pivot = matrix[modes * j + j];
        if (!(pivot > (real)0)) {
            return 0;
        }
        if (is_diagonal != 0) {
            matrix[modes * j + j] = (real)1 / pivot;
            continue;
        }
        pivot = square_root(pivot);
        matrix[modes * j + j] = (real)1 / pivot;
        for (i = j + 1; i < modes; i++) {
            matrix[modes * i + j] /= pivot;
        }
        for (i = j + 1; i < modes; i++) {
            for (k = j + 1; k <= i; k++) {
                matrix[modes * i + k] -= matrix[modes * i + j] * matrix[modes * k + j];
            }
        }
    }
    return 1;
}

/* Solves for `width` right-hand sides side by side, `stride` numbers for each mode. */
static void solve_modal(int modes, int is_diagonal, const real *factors, int width, int stride, real *right)
{
    int i;
    int j;
    int k;
    for (i = 0; i < modes; i++) {
        if (is_diagonal == 0) {
            for (j = 0; j < i; j++) {
                add_scaled(width, -factors[modes * i + j], &right[stride * j], &right[stride * i]);
            }
        }
        for (k = 0; k < width; k++) {
            right[stride * i + k] *= factors[modes * i + i];
        }
    }
    if (is_diagonal != 0) {
        return;
    }
    for (i = modes - 1; i >= 0; i--) {
        for (j = i + 1; j < modes; j++) {
            add_scaled(width, -factors[modes * j + i], &right[stride * j], &right[stride * i]);
        }
        for (k = 0; k < width; k++) {
            right[stride * i + k] *= factors[modes * i + i];
        }
    }
}

/* Adds a multiple of the product of a modal matrix with a vector. */
static void add_modal_product(
    const flexible_body *flexible, const real *matrix, real factor, const real *vector, real *sum
)
{
    const int modes = flexible->modes;
    int i;
    int k;
    for (i = 0; i < modes; i++) {
        if (flexible->is_diagonal != 0) {
            sum[i] += factor * (matrix[modes * i + i] * vector[i]);
            continue;
        }
        for (k = 0; k < modes; k++) {
            sum[i] += factor * (matrix[modes * i + k] * vector[k]);
        }
    }
}

//@ end
/* The block of rigid motion in the mass matrix, symmetric. */
static void rigid_mass(const body_work *body, real matrix[36])
{
    const real *moment = body->first_moment;
    int i;
    int k;
    fill(36, (real)0, matrix);
    for (i = 0; i < 3; i++) {
        matrix[7 * i] = body->mass;
        for (k = 0; k < 3; k++) {
            matrix[6 * (3 + i) + 3 + k] = body->inertia[3 * k + i];
        }
    }
    matrix[6 * 4 + 2] = -moment[0];
    matrix[6 * 5 + 1] = moment[0];
    matrix[6 * 3 + 2] = moment[1];
    matrix[6 * 5 + 0] = -moment[1];
    matrix[6 * 3 + 1] = -moment[2];
    matrix[6 * 4 + 0] = moment[2];
    for (i = 0; i < 3; i++) {
        for (k = 3; k < 6; k++) {
            matrix[6 * i + k] = matrix[6 * k + i];
        }
    }
}

/* The mass matrix of a body times a motion is subtracted from a force. */
static void subtract_momentum(int index, const body_work *body, const real *moving, real *force)
{
    real product[3];
    int k;
    cross(&moving[3], body->first_moment, product);
    for (k = 0; k < 3; k++) {
        force[k] -= moving[k] * body->mass + product[k];
    }
    cross(body->first_moment, &moving[0], product);
    add_scaled(3, (real)-1, product, &force[3]);
    along_axes(body->inertia, &moving[3], product);
    add_scaled(3, (real)-1, product, &force[3]);
//@ if FLEXIBLE
    if (flexible_of[index] >= 0) {
        const flexible_body *flexible = &flexible_bodies[flexible_of[index]];
        int i;
        add_modal_product(flexible, flexible->modal_mass, (real)-1, &moving[6], &force[6]);
        for (k = 0; k < flexible->modes; k++) {
            for (i = 0; i < 6; i++) {
                force[i] -= body->coupling[6 * k + i] * moving[6 + k];
                force[6 + k] -= body->coupling[6 * k + i] * moving[i];
            }
        }
    }
//@ end
    (void)index;
}

/* The velocities of an increment, resolved in the body frame. */
static void body_velocities(const body_work *body, const real *increment, real *moving)
{
    components_along(body->axes, &increment[VELOCITIES], &moving[0]);
    copy(VELOCITIES - 3, &increment[VELOCITIES + 3], &moving[3]);
}

/* Adds the force of uniform gravity. */
static void weigh(int index, workspace *work)
{
    body_work *body = &work->bodies[index];
    real along[3];
    real moment[3];
    components_along(body->axes, @Tgravity, along);
    cross(body->first_moment, along, moment);
    add_scaled(3, body->mass, along, &body->force[0]);
    add_scaled(3, (real)1, moment, &body->force[3]);
//@ if FLEXIBLE
    if (flexible_of[index] >= 0) {
        int k;
        for (k = 0; k < flexible_bodies[flexible_of[index]].modes; k++) {
            body->force[6 + k] += dot(&body->coupling[6 * k], along);
        }
    }
//@ end
    (void)index;
}

/* The mass matrix without its modes, and what is left of the force to accelerate in a stage. Gives 0 without factors. */
static int factor_body(int index, const body_state *state, const stage_terms *terms, body_work *body)
{
    const real *subtracted = terms->subtracted != NULL ? &terms->subtracted[INCREMENT * index] : NULL;
    rigid_mass(body, body->remaining);
    add_scaled(VELOCITIES, (real)-1, body->quadratic_velocity, body->force);
//@ if FLEXIBLE
    if (flexible_of[index] >= 0) {
        const flexible_body *flexible = &flexible_bodies[flexible_of[index]];
        const int modes = flexible->modes;
        const int is_diagonal = flexible->is_diagonal;
        int i;
        int k;
        add_scaled(modes, (real)-1, body->internal_force, &body->force[6]);
        for (k = 0; k < modes * modes; k++) {
            body->factors[k] = flexible->modal_mass[k] + terms->gamma_h * flexible->damping[k]
                + terms->gamma_h * terms->gamma_h * flexible->stiffness[k];
        }
        if (!factor_modal(modes, is_diagonal, body->factors)) {
            return 0;
        }
        copy(6 * modes, body->coupling, body->followed);
        solve_modal(modes, is_diagonal, body->factors, 6, 6, body->followed);
        for (k = 0; k < modes; k++) {
            for (i = 0; i < 6; i++) {
                add_scaled(6, -body->coupling[6 * k + i], &body->followed[6 * k], &body->remaining[6 * i]);
            }
        }
        if (terms->gamma_h > (real)0) {
            real moved[MODES];
            copy(modes, state->q_dot, moved);
            if (subtracted != NULL) {
                add_scaled(modes, (real)-1, &subtracted[6], moved);
            }
            add_modal_product(flexible, flexible->stiffness, -terms->gamma_h, moved, &body->force[6]);
        }
    }
//@ end
    if (subtracted != NULL) {
        real moving[VELOCITIES];
        body_velocities(body, subtracted, moving);
        subtract_momentum(index, body, moving, body->force);
    }
    (void)state;
    return 1;
}

/* The force on the frame when the modes move freely under their part of the force. */
static void reduced_force(int index, body_work *body, real reduced[6])
{
    copy(6, body->force, reduced);
//@ if FLEXIBLE
    if (flexible_of[index] >= 0) {
        const flexible_body *flexible = &flexible_bodies[flexible_of[index]];
        int k;
        copy(flexible->modes, &body->force[6], body->alone);
        solve_modal(flexible->modes, flexible->is_diagonal, body->factors, 1, 1, body->alone);
        for (k = 0; k < flexible->modes; k++) {
            add_scaled(6, -body->force[6 + k], &body->followed[6 * k], reduced);
        }
    }
//@ end
    (void)index;
}

/* The motion of a body from that of its frame. */
static void finish_body(int index, const real frame[6], body_work *body)
{
    copy(6, frame, body->result);
//@ if FLEXIBLE
    if (flexible_of[index] >= 0) {
        const int modes = flexible_bodies[flexible_of[index]].modes;
        int i;
        int k;
        for (k = 0; k < modes; k++) {
            real entry = body->alone[k];
            for (i = 0; i < 6; i++) {
                entry -= body->followed[6 * k + i] * frame[i];
            }
            body->result[6 + k] = entry;
        }
    }
//@ end
    (void)index;
}
