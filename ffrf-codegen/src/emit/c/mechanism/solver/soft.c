//@ if SOFT
/*
 * Springs, torsion springs and bushings in the matrix of a linearly implicit stage, as rows behind those of the joints: of a row
 * of gradient g, stiffness k and damping d it has the root of c times g, c = gamma h d + gamma^2 h^2 k, with -1 on the diagonal.
 */
static void soft_row(
    row_set *rows, real gamma_h, real stiffness, real damping, const real first[6], const real second[6]
)
{
    const real k = larger(stiffness, (real)0);
    const real d = larger(damping, (real)0);
    const real whole = gamma_h * (d + gamma_h * k);
    real root;
    int row;
    if (!(whole > (real)0)) {
        (void)add_row(rows, (real)0, (real)0, (real)0);
        return;
    }
    root = square_root(whole);
    row = add_row(rows, k / (d + gamma_h * k), (real)0, (real)0);
    set_gradient(rows, row, 0, 0, root, &first[0]);
    set_gradient(rows, row, 0, 3, root, &first[3]);
    set_gradient(rows, row, 1, 0, root, &second[0]);
    set_gradient(rows, row, 1, 3, root, &second[3]);
}

//@ if SPRING
/* Along the line of a spring, and across it. */
static void soften_spring(const element *one, const motion at[2], real gamma_h, row_set *rows)
{
    real direction[3][3];
    real between[3];
    real unit[3] = {(real)0, (real)0, (real)0};
    real length;
    real across = one->rest > (real)0 ? (real)0 : one->stiffness[0];
    real along = across;
    real damping = (real)0;
    int least = 0;
    int row;
    int k;
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
    }
    length = square_root(dot(between, between));
    fill(3, (real)0, direction[0]);
    direction[0][2] = (real)1;
    if (length > ROUND_OFF) {
        for (k = 0; k < 3; k++) {
            direction[0][k] = between[k] / length;
        }
        along = one->stiffness[0];
        across = one->stiffness[0] * (length - one->rest) / length;
        damping = one->damping[0];
    }
    for (k = 1; k < 3; k++) {
        if (magnitude(direction[0][k]) < magnitude(direction[0][least])) {
            least = k;
        }
    }
    unit[least] = (real)1;
    cross(direction[0], unit, direction[1]);
    length = square_root(dot(direction[1], direction[1]));
    for (k = 0; k < 3; k++) {
        direction[1][k] /= length;
    }
    cross(direction[0], direction[1], direction[2]);
    for (row = 0; row < 3; row++) {
        real first[6] = {(real)0, (real)0, (real)0, (real)0, (real)0, (real)0};
        real second[6] = {(real)0, (real)0, (real)0, (real)0, (real)0, (real)0};
        add_scaled(3, (real)-1, direction[row], first);
        add_scaled(3, (real)1, direction[row], second);
        soft_row(rows, gamma_h, row == 0 ? along : across, row == 0 ? damping : (real)0, first, second);
    }
}

//@ end
/* The rows of a soft link. */
static void soften(int index, real gamma_h, workspace *work)
{
    const element *one = &@Telements[soft_elements[index - JOINTS]];
    row_set *rows = &work->rows[index];
    motion *at = work->at[index];
    attachment_motion(&one->at[0], work, &at[0]);
    attachment_motion(&one->at[1], work, &at[1]);
    rows->count = 0;
    switch (one->kind) {
//@ if SPRING
    case SPRING:
        soften_spring(one, at, gamma_h, rows);
        break;
//@ end
//@ if FRICTION
    case FRICTION: {
        /* a damper with the slope that friction has at this rate */
        const real rate = friction_rate(one, at);
        const real squares = rate * rate + one->rest * one->rest;
        const real slope = one->stiffness[0] * one->rest * one->rest / (squares * square_root(squares));
        real wrenches[2][6];
        fill(6, (real)0, wrenches[0]);
        fill(6, (real)0, wrenches[1]);
        exert(one->option, at, (real)1, wrenches);
        soft_row(rows, gamma_h, (real)0, slope + one->damping[0], wrenches[0], wrenches[1]);
        break;
    }
//@ end
//@ if TURNING
    default: {
        real axes[9];
        real between[3];
        int row;
        int k;
        axes_of(at[0].orientation, axes);
        for (k = 0; k < 3; k++) {
            between[k] = at[1].position[k] - at[0].position[k];
        }
        /* a bushing along and about three axes, a torsion spring about one */
        for (row = one->kind == BUSHING ? 0 : 5; row < 6; row++) {
            const int first_axis = row < 3 ? 0 : 3;
            const real *axis = &axes[3 * (row - first_axis)];
            const int entry = one->kind == BUSHING ? row : 0;
            real first[6] = {(real)0, (real)0, (real)0, (real)0, (real)0, (real)0};
            real second[6] = {(real)0, (real)0, (real)0, (real)0, (real)0, (real)0};
            add_scaled(3, (real)-1, axis, &first[first_axis]);
            add_scaled(3, (real)1, axis, &second[first_axis]);
            if (row < 3) {
                real arm[3];
                cross(between, axis, arm);
                add_scaled(3, (real)-1, arm, &first[3]);
            }
            soft_row(rows, gamma_h, one->stiffness[entry], one->damping[entry], first, second);
        }
        break;
    }
//@ end
//@ if NOT_TURNING
    default:
        break;
//@ end
    }
}

/* Sets the right-hand sides of soft links. */
static void pull_soft_links(const stage_terms *terms, workspace *work)
{
    real displaced[BODIES * VELOCITIES];
    int index;
    int k;
    fill(BODIES * VELOCITIES, (real)0, displaced);
    if (terms->subtracted != NULL) {
        for (index = 0; index < BODIES; index++) {
            const real *at = &terms->increment[INCREMENT * index];
            const real *subtracted = &terms->subtracted[INCREMENT * index];
            real *moving = &displaced[VELOCITIES * index];
            real half[3];
            real product[3];
            real size;
            components_along(work->bodies[index].axes, subtracted, moving);
            /* the angular velocity with which the rotation of the chart changes at this rate */
            for (k = 0; k < 3; k++) {
                half[k] = (real)0.5 * at[3 + k];
            }
            cross(half, &subtracted[3], product);
            size = (real)1 + dot(half, half);
            for (k = 0; k < 3; k++) {
                moving[3 + k] = (subtracted[3 + k] - product[k]) / size;
            }
            copy(VELOCITIES - 6, &subtracted[6], &moving[6]);
        }
    }
    for (index = JOINTS; index < LINKS; index++) {
        real moved[6];
        real *wanted = &work->right[6 * @Tlinks[index].node];
        row_velocities(index, work, moved);
        if (terms->subtracted != NULL) {
            subtract_powers(index, work, displaced, moved);
        }
        for (k = 0; k < work->rows[index].count; k++) {
            wanted[k] = -(work->rows[index].residual[k] * moved[k]);
        }
        subtract_modal_accelerations(index, work, wanted);
    }
}

//@ end
