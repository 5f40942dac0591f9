/* Adds a row without gradients; its number. */
static int add_row(row_set *rows, real residual, real rate, real bias)
{
    const int row = rows->count;
    int k;
    rows->residual[row] = residual;
    rows->rate[row] = rate;
    rows->bias[row] = bias;
    for (k = 0; k < 6; k++) {
        rows->gradients[0][6 * k + row] = (real)0;
        rows->gradients[1][6 * k + row] = (real)0;
    }
    rows->count = row + 1;
    return row;
}

//@ if GRADIENTS
/* Sets the gradient of a row to the translation (first 0) or rotation (first 3) of an end. */
static void set_gradient(row_set *rows, int row, int end, int first, real factor, const real gradient[3])
{
    int k;
    for (k = 0; k < 3; k++) {
        rows->gradients[end][6 * (first + k) + row] = factor * gradient[k];
    }
}

//@ end
//@ if IN_PLANE
/* n . (r2 - r1) = travel, where n turns with the first triad; `travel`: value, rate, acceleration. */
static void in_plane(row_set *rows, const motion at[2], const real normal[3], const real travel[3])
{
    real distance[3];
    real velocity[3];
    real turning[3];
    real product[3];
    real bias;
    int row;
    int k;
    for (k = 0; k < 3; k++) {
        distance[k] = at[1].position[k] - at[0].position[k];
        velocity[k] = at[1].velocity[k] - at[0].velocity[k];
    }
    cross(at[0].omega, normal, turning);
    cross(at[0].omega, turning, product);
    bias = dot(turning, velocity) * (real)2 + dot(product, distance) - travel[2];
    row = add_row(rows, dot(normal, distance) - travel[0], -travel[1], bias);
    cross(normal, distance, product);
    set_gradient(rows, row, 0, 0, (real)-1, normal);
    set_gradient(rows, row, 0, 3, (real)1, product);
    set_gradient(rows, row, 1, 0, (real)1, normal);
}

//@ end
//@ if PERPENDICULAR
/* u . w = 0, where u turns with `turning`, whose rate has `turning_bias` besides the accelerations, and w with the second. */
static void perpendicular(
    row_set *rows, const motion at[2], const real u[3], const real turning[3], const real turning_bias[3],
    const real w[3], real rate
)
{
    real normal[3];
    real change[3];
    real product[3];
    real relative[3];
    int row;
    int k;
    cross(u, w, normal);
    cross(turning, u, product);
    cross(product, w, change);
    cross(at[1].omega, w, product);
    cross(u, product, product);
    for (k = 0; k < 3; k++) {
        change[k] += product[k];
        relative[k] = turning[k] - at[1].omega[k];
    }
    row = add_row(rows, dot(u, w), rate, dot(relative, change) + dot(turning_bias, normal));
    set_gradient(rows, row, 0, 3, (real)1, normal);
    set_gradient(rows, row, 1, 3, (real)-1, normal);
}

//@ end
//@ if ANGLE
/* sin(theta - phi) = 0, where theta is the angle from x1 to x2 about z1 and phi is given. Gives 0 where phi is too large. */
static int angle_row(row_set *rows, const motion at[2], const real first[9], const real second[9], const real angle[3])
{
    real sine;
    real cosine;
    real turned_axis[3];
    real turning[3];
    real bias[3];
    real normal[3];
    int k;
    if (!sine_cosine(angle[0], &sine, &cosine)) {
        return 0;
    }
    cross(at[0].omega, &first[6], bias);
    for (k = 0; k < 3; k++) {
        turned_axis[k] = first[3 + k] * cosine - first[k] * sine;
        turning[k] = at[0].omega[k] + first[6 + k] * angle[1];
        bias[k] = first[6 + k] * angle[2] + bias[k] * angle[1];
    }
    cross(turned_axis, &second[0], normal);
    perpendicular(rows, at, turned_axis, turning, bias, &second[0], dot(&first[6], normal) * angle[1]);
    return 1;
}

//@ end
//@ if DISTANCE
/* (|d|^2 - L^2) / (2 L) = 0 with d = r2 - r1. */
static void distance_row(row_set *rows, const motion at[2], real length)
{
    real between[3];
    real velocity[3];
    real direction[3];
    int row;
    int k;
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
        velocity[k] = at[1].velocity[k] - at[0].velocity[k];
        direction[k] = between[k] / length;
    }
    row = add_row(
        rows, (dot(between, between) / length - length) * (real)0.5, (real)0, dot(velocity, velocity) / length
    );
    set_gradient(rows, row, 0, 0, (real)-1, direction);
    set_gradient(rows, row, 1, 0, (real)1, direction);
}

//@ end
//@ if RELATIVE
/* The quaternion from the first to the second triad, of the two the one near none. */
static void relative_rotation(const motion at[2], real relative[4])
{
    real inverse[4];
    int k;
    inverse[0] = at[0].orientation[0];
    for (k = 1; k < 4; k++) {
        inverse[k] = -at[0].orientation[k];
    }
    quaternion_product(inverse, at[1].orientation, relative);
    if (relative[0] < (real)0) {
        for (k = 0; k < 4; k++) {
            relative[k] = -relative[k];
        }
    }
}

//@ end
//@ if ALIGNED
/* 2 u = 0, where (s, u) is the quaternion from the first to the second triad: about the axes of the first in `held`. */
static void aligned(row_set *rows, const motion at[2], const real first[9], int held)
{
    real relative[4];
    real omega[3];
    real frame[3];
    real carried[3];
    real u_rate[3];
    real bias[3];
    real product[3];
    real s_rate;
    const real *u = &relative[1];
    int axis;
    int k;
    relative_rotation(at, relative);
    for (k = 0; k < 3; k++) {
        omega[k] = at[1].omega[k] - at[0].omega[k];
    }
    components_along(first, at[0].omega, frame);
    components_along(first, omega, omega);
    s_rate = -dot(omega, u) * (real)0.5;
    cross(omega, u, product);
    cross(frame, omega, carried);
    for (k = 0; k < 3; k++) {
        u_rate[k] = (omega[k] * relative[0] + product[k]) * (real)0.5;
        carried[k] = -carried[k];
        bias[k] = carried[k] * relative[0] + omega[k] * s_rate;
    }
    cross(carried, u, product);
    add_scaled(3, (real)1, product, bias);
    cross(omega, u_rate, product);
    add_scaled(3, (real)1, product, bias);
    for (axis = 0; axis < 3; axis++) {
        real unit[3] = {(real)0, (real)0, (real)0};
        real gradient[3];
        int row;
        if ((held & (1 << axis)) == 0) {
            continue;
        }
        unit[axis] = (real)1;
        cross(u, unit, gradient);
        add_scaled(3, relative[0], unit, gradient);
        along_axes(first, gradient, gradient);
        row = add_row(rows, u[axis] * (real)2, (real)0, bias[axis]);
        set_gradient(rows, row, 0, 3, (real)-1, gradient);
        set_gradient(rows, row, 1, 3, (real)1, gradient);
    }
}

//@ end
//@ if DRIVES
/* Value, rate and acceleration of a drive, a polynomial of time. */
static void drive_at(const link_place *link, real time, real drive[3])
{
    int k;
    fill(3, (real)0, drive);
    for (k = link->drive_count - 1; k >= 0; k--) {
        drive[2] = drive[2] * time + drive[1] * (real)2;
        drive[1] = drive[1] * time + drive[0];
        drive[0] = drive[0] * time + coefficients[link->drive + k];
    }
}

//@ end
/* Evaluates a joint: motion of its ends and rows. Gives a status. */
static int evaluate_link(int index, real time, workspace *work)
{
    const link_place *link = &@Tlinks[index];
    motion *at = work->at[index];
    row_set *rows = &work->rows[index];
    const real none[3] = {(real)0, (real)0, (real)0};
    real drive[3] = {(real)0, (real)0, (real)0};
    real first[9];
    real second[9];
    int k;
    int axis;
    attachment_motion(&link->at[0], work, &at[0]);
    attachment_motion(&link->at[1], work, &at[1]);
    axes_of(at[0].orientation, first);
    axes_of(at[1].orientation, second);
    rows->count = 0;
//@ if DRIVES
    drive_at(link, time, drive);
//@ end
    for (k = 0; k < link->relation_count; k++) {
        const relation *held = &@Trelations[link->relations + k];
        switch (held->kind) {
        case COINCIDENT:
            for (axis = 0; axis < 3; axis++) {
                const int row = add_row(rows, at[1].position[axis] - at[0].position[axis], (real)0, (real)0);
                rows->gradients[0][6 * axis + row] = (real)-1;
                rows->gradients[1][6 * axis + row] = (real)1;
            }
            break;
//@ if IN_PLANE
        case IN_PLANE:
            for (axis = 0; axis < 3; axis++) {
                if ((held->held & (1 << axis)) != 0) {
                    in_plane(rows, at, &first[3 * axis], drive);
                }
            }
            break;
//@ end
//@ if PERPENDICULAR
        case PERPENDICULAR:
            /* the z axis of the first, and axes of the second */
            for (axis = 0; axis < 3; axis++) {
                if ((held->held & (1 << axis)) != 0) {
                    perpendicular(rows, at, &first[6], at[0].omega, none, &second[3 * axis], (real)0);
                }
            }
            break;
//@ end
//@ if ALIGNED
        case ALIGNED:
            aligned(rows, at, first, held->held);
            break;
//@ end
//@ if DISTANCE
        case DISTANCE:
            distance_row(rows, at, held->length);
            break;
//@ end
//@ if ANGLE
        case ANGLE:
            if (!angle_row(rows, at, first, second, drive)) {
                return TOO_FAR;
            }
            break;
//@ end
        default:
            break;
        }
    }
    (void)time;
    (void)none;
    (void)drive;
    (void)second;
    return DONE;
}

/* Adds the products of the gradients of an end with a velocity and an angular velocity. */
static void add_powers(int count, const real gradients[36], const real linear[3], const real angular[3], real sum[6])
{
    int k;
    for (k = 0; k < 3; k++) {
        add_scaled(count, linear[k], &gradients[6 * k], sum);
    }
    for (k = 0; k < 3; k++) {
        add_scaled(count, angular[k], &gradients[6 * (3 + k)], sum);
    }
}

/* The rates of the residuals of a link. */
static void row_velocities(int index, const workspace *work, real sum[6])
{
    const row_set *rows = &work->rows[index];
    int end;
    copy(rows->count, rows->rate, sum);
    for (end = 0; end < 2; end++) {
        const motion *at = &work->at[index][end];
        add_powers(rows->count, rows->gradients[end], at->velocity, at->omega, sum);
    }
}
