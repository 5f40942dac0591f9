//@ if TURN
/* The angle from x1 to x2 about z1, within half a turn. */
static real relative_angle(const motion at[2])
{
    real first[9];
    real second[9];
    axes_of(at[0].orientation, first);
    axes_of(at[1].orientation, second);
    return angle_of(dot(&first[3], &second[0]), dot(&first[0], &second[0]));
}

//@ end
//@ if SPRING
/* A spring and damper along the line between two points. */
static void spring(const element *one, const motion at[2], real wrenches[2][6])
{
    real between[3];
    real velocity[3];
    real length;
    real pull;
    int k;
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
        velocity[k] = at[1].velocity[k] - at[0].velocity[k];
    }
    length = square_root(dot(between, between));
    if (length <= ROUND_OFF) {
        return;
    }
    for (k = 0; k < 3; k++) {
        between[k] /= length;
    }
    pull = one->stiffness[0] * (length - one->rest) + one->damping[0] * dot(between, velocity);
    add_scaled(3, pull, between, wrenches[0]);
    add_scaled(3, -pull, between, wrenches[1]);
}

//@ end
//@ if TORSION_SPRING
/* The angle of a torsion spring from rest, within half a turn. */
static real angle_from_rest(const element *one, const motion at[2])
{
    real angle = relative_angle(at) - one->rest;
    if (angle > PI) {
        angle -= (real)2 * PI;
    } else if (angle < -PI) {
        angle += (real)2 * PI;
    }
    return angle;
}

/* A spring and damper about the z axis of the first triad. */
static void torsion_spring(const element *one, const motion at[2], real wrenches[2][6])
{
    real axes[9];
    real relative[3];
    real moment;
    int k;
    axes_of(at[0].orientation, axes);
    for (k = 0; k < 3; k++) {
        relative[k] = at[1].omega[k] - at[0].omega[k];
    }
    moment = one->stiffness[0] * angle_from_rest(one, at) + one->damping[0] * dot(&axes[6], relative);
    add_scaled(3, moment, &axes[6], &wrenches[0][3]);
    add_scaled(3, -moment, &axes[6], &wrenches[1][3]);
}

//@ end
//@ if BUSHING
/* Springs and dampers along and about the axes of the first triad, at the second end. */
static void bushing(const element *one, const motion at[2], real wrenches[2][6])
{
    real axes[9];
    real between[3];
    real displacement[3];
    real velocity[3];
    real spin[3];
    real relative[4];
    real restoring[3];
    real force[3];
    real moment[3];
    real product[3];
    int k;
    axes_of(at[0].orientation, axes);
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
        spin[k] = at[1].omega[k] - at[0].omega[k];
    }
    cross(at[0].omega, between, product);
    for (k = 0; k < 3; k++) {
        velocity[k] = at[1].velocity[k] - at[0].velocity[k] - product[k];
    }
    components_along(axes, between, displacement);
    components_along(axes, velocity, velocity);
    components_along(axes, spin, spin);
    relative_rotation(at, relative);
    for (k = 0; k < 3; k++) {
        force[k] = displacement[k] * one->stiffness[k] + velocity[k] * one->damping[k];
        restoring[k] = relative[1 + k] * one->stiffness[3 + k] * (real)2;
    }
    cross(&relative[1], restoring, product);
    for (k = 0; k < 3; k++) {
        moment[k] = restoring[k] * relative[0] + product[k] + spin[k] * one->damping[3 + k];
    }
    along_axes(axes, force, force);
    along_axes(axes, moment, moment);
    cross(between, force, product);
    for (k = 0; k < 3; k++) {
        wrenches[0][k] = force[k];
        wrenches[0][3 + k] = moment[k] + product[k];
        wrenches[1][k] = -force[k];
        wrenches[1][3 + k] = -moment[k];
    }
}

//@ end
//@ if CONSTANT
/* A constant force and moment at the second end, fixed in space or turning with it. */
static void constant_wrench(const element *one, const motion at[2], real wrenches[2][6])
{
    copy(3, &one->stiffness[0], &wrenches[1][0]);
    copy(3, &one->stiffness[3], &wrenches[1][3]);
    if (one->option != 0) {
        real axes[9];
        axes_of(at[1].orientation, axes);
        along_axes(axes, &wrenches[1][0], &wrenches[1][0]);
        along_axes(axes, &wrenches[1][3], &wrenches[1][3]);
    }
}

//@ end
//@ if EFFORT
/*
 * A force or moment of one number: about or along the z axis of the first triad, or on the line through both origins. On the
 * second end, its reaction on the first.
 */
static void exert(int effort, const motion at[2], real amount, real wrenches[2][6])
{
    real axes[9];
    real between[3];
    real force[3];
    int k;
    axes_of(at[0].orientation, axes);
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
        force[k] = axes[6 + k] * amount;
    }
    if (effort == ABOUT) {
        add_scaled(3, (real)-1, force, &wrenches[0][3]);
        add_scaled(3, (real)1, force, &wrenches[1][3]);
        return;
    }
    if (effort == ALONG) {
        real moment[3];
        cross(between, force, moment);
        add_scaled(3, (real)-1, moment, &wrenches[0][3]);
    } else {
        const real length = square_root(dot(between, between));
        for (k = 0; k < 3; k++) {
            force[k] = length <= ROUND_OFF ? (real)0 : between[k] / length * amount;
        }
    }
    add_scaled(3, (real)-1, force, &wrenches[0][0]);
    add_scaled(3, (real)1, force, &wrenches[1][0]);
}

//@ end
//@ if FRICTION
/* The rate that the friction of an element has power on. */
static real friction_rate(const element *one, const motion at[2])
{
    real wrenches[2][6];
    real rate = (real)0;
    int end;
    fill(6, (real)0, wrenches[0]);
    fill(6, (real)0, wrenches[1]);
    exert(one->option, at, (real)1, wrenches);
    for (end = 0; end < 2; end++) {
        rate += dot(&wrenches[end][0], at[end].velocity) + dot(&wrenches[end][3], at[end].omega);
    }
    return rate;
}

/* Dry friction that passes smoothly through rest, and viscous friction. */
static void friction(const element *one, const motion at[2], real wrenches[2][6])
{
    const real rate = friction_rate(one, at);
    const real share = one->stiffness[0] / square_root(rate * rate + one->rest * one->rest);
    exert(one->option, at, -rate * (share + one->damping[0]), wrenches);
}

//@ end
//@ if FORCES
static void push_both(const attachment at[2], real wrenches[2][6], workspace *work)
{
    push(&at[0], &wrenches[0][0], &wrenches[0][3], work);
    push(&at[1], &wrenches[1][0], &wrenches[1][3], work);
}

//@ end
//@ if SCHEDULES
real @P_scheduled(int index, real time)
{
    real value = (real)0;
    int k;
    if (index < 0 || index >= ACTUATORS) {
        return value;
    }
    for (k = schedules[index].count - 1; k >= 0; k--) {
        value = value * time + schedule_coefficients[schedules[index].first + k];
    }
    return value;
}

//@ end
//@ if ACTUATORS
/* The input of an actuator: what the caller has set, or where it has set nothing, the polynomial of time of the scene. */
static real input_at(int index, const mechanism_inputs *inputs, real time)
{
//@ if SCHEDULES
    if (inputs->follows[index] != 0) {
        return @P_scheduled(index, time);
    }
//@ end
    (void)time;
    return inputs->actuators[index];
}

//@ end
/* Adds gravity, force elements and actuators. */
static void load(const mechanism_inputs *inputs, real time, workspace *work)
{
    int index;
    for (index = 0; index < BODIES; index++) {
        weigh(index, work);
    }
//@ if ELEMENTS
    for (index = 0; index < ELEMENTS; index++) {
        const element *one = &@Telements[index];
        real wrenches[2][6];
        motion at[2];
        attachment_motion(&one->at[0], work, &at[0]);
        attachment_motion(&one->at[1], work, &at[1]);
        fill(6, (real)0, wrenches[0]);
        fill(6, (real)0, wrenches[1]);
        switch (one->kind) {
//@ if SPRING
        case SPRING:
            spring(one, at, wrenches);
            break;
//@ end
//@ if TORSION_SPRING
        case TORSION_SPRING:
            torsion_spring(one, at, wrenches);
            break;
//@ end
//@ if BUSHING
        case BUSHING:
            bushing(one, at, wrenches);
            break;
//@ end
//@ if CONSTANT
        case CONSTANT:
            constant_wrench(one, at, wrenches);
            break;
//@ end
//@ if FRICTION
        case FRICTION:
            friction(one, at, wrenches);
            break;
//@ end
        default:
            break;
        }
        push_both(one->at, wrenches, work);
    }
//@ end
//@ if ACTUATORS
    for (index = 0; index < ACTUATORS; index++) {
        real wrenches[2][6];
        motion at[2];
        real effort;
        attachment_motion(&@Tactuators[index].at[0], work, &at[0]);
        attachment_motion(&@Tactuators[index].at[1], work, &at[1]);
        fill(6, (real)0, wrenches[0]);
        fill(6, (real)0, wrenches[1]);
        effort = @Tactuators[index].gain * input_at(index, inputs, time);
        effort = effort < -@Tactuators[index].limit ? -@Tactuators[index].limit : effort;
        effort = effort > @Tactuators[index].limit ? @Tactuators[index].limit : effort;
        exert(@Tactuators[index].effort, at, effort, wrenches);
        push_both(@Tactuators[index].at, wrenches, work);
    }
//@ end
    (void)inputs;
    (void)time;
}
