//@ if PARAMETERS
/* What a parameter may be. */
static int is_allowed(const parameter_place *place, real value)
{
    switch (place->kind) {
    case TO_STIFFNESS:
    case TO_DAMPING:
    case TO_REST_LENGTH:
    case TO_LIMIT:
        return value >= (real)0 && is_finite(value);
    case TO_SPEED:
        return value > (real)0 && is_finite(value);
    default:
        return is_finite(value);
    }
}

/* Writes a parameter where it belongs. */
static void write_parameter(const parameter_place *place, real value, @P_tables *tables, mechanism_state *state)
{
    const int entry = place->entry;
    switch (place->kind) {
    case TO_GRAVITY:
        tables->gravity[entry] = value;
        break;
    case TO_POSITION:
        state->bodies[place->index].position[entry] = value;
        break;
    case TO_ORIENTATION:
        state->bodies[place->index].orientation[entry] = value;
        break;
    case TO_VELOCITY:
        state->bodies[place->index].velocity[entry] = value;
        break;
    case TO_ANGULAR_VELOCITY:
        state->bodies[place->index].omega[entry] = value;
        break;
//@ if FLEXIBLE
    case TO_COORDINATE:
        state->bodies[place->index].q[entry] = value;
        break;
    case TO_RATE:
        state->bodies[place->index].q_dot[entry] = value;
        break;
//@ end
//@ if ELEMENTS
    case TO_STIFFNESS:
    case TO_WRENCH:
        tables->elements[place->index].stiffness[entry] = value;
        break;
    case TO_DAMPING:
        tables->elements[place->index].damping[entry] = value;
        break;
    case TO_REST_LENGTH:
    case TO_REST_ANGLE:
    case TO_SPEED:
        tables->elements[place->index].rest = value;
        break;
//@ end
//@ if ACTUATORS
    case TO_GAIN:
        tables->actuators[place->index].gain = value;
        break;
    case TO_LIMIT:
        tables->actuators[place->index].limit = value;
        break;
//@ end
    default:
        break;
    }
}

/* Euler parameters of norm one; 0 where there is no direction. */
static int normalised(real orientation[4])
{
    real largest = (real)0;
    real squares = (real)0;
    int k;
    for (k = 0; k < 4; k++) {
        largest = larger(largest, magnitude(orientation[k]));
    }
    if (!(largest > (real)0)) {
        return 0;
    }
    for (k = 0; k < 4; k++) {
        orientation[k] /= largest;
        squares += orientation[k] * orientation[k];
    }
    squares = square_root(squares);
    for (k = 0; k < 4; k++) {
        orientation[k] /= squares;
    }
    return 1;
}

static void conjugated(const real orientation[4], real result[4])
{
    result[0] = orientation[0];
    result[1] = -orientation[1];
    result[2] = -orientation[2];
    result[3] = -orientation[3];
}

/* The motion of an end without the orientation that a joint gives it. */
static void bare_motion(const attachment *at, const workspace *work, motion *moving)
{
    attachment bare = *at;
    bare.orientation[0] = (real)1;
    fill(3, (real)0, &bare.orientation[1]);
    attachment_motion(&bare, work, moving);
}

/* The second triad of a joint about the axis of the first, as both ends are turned now; with the turn about it, or without. */
static void second_triad(attachment ends[2], int turns, const workspace *work)
{
    motion at[2];
    real inverse[4];
    real product[4];
    real relative[4];
    real turn[4] = {(real)1, (real)0, (real)0, (real)0};
    bare_motion(&ends[0], work, &at[0]);
    bare_motion(&ends[1], work, &at[1]);
    conjugated(at[0].orientation, inverse);
    quaternion_product(inverse, at[1].orientation, relative);
    if (turns != 0) {
        /* of the rotation as the axis sees it, the part about z */
        real seen[4];
        real norm;
        conjugated(ends[0].orientation, inverse);
        quaternion_product(inverse, relative, product);
        quaternion_product(product, ends[0].orientation, seen);
        norm = square_root(seen[0] * seen[0] + seen[3] * seen[3]);
        if (norm > (real)0) {
            turn[0] = seen[0] / norm;
            turn[3] = seen[3] / norm;
        }
    }
    conjugated(relative, inverse);
    quaternion_product(inverse, ends[0].orientation, product);
    quaternion_product(product, turn, ends[1].orientation);
}

/* The second triad of a universal joint: z along what is x of the first now. */
static void second_axis(attachment ends[2], const workspace *work)
{
    motion at[2];
    real axes[9];
    real x[3];
    real turn[4];
    attachment_motion(&ends[0], work, &at[0]);
    bare_motion(&ends[1], work, &at[1]);
    axes_of(at[0].orientation, axes);
    copy(3, &axes[0], x);
    axes_of(at[1].orientation, axes);
    components_along(axes, x, x);
    turn[0] = (real)1 + x[2];
    turn[1] = -x[1];
    turn[2] = x[0];
    turn[3] = (real)0;
    if (!(turn[0] > ROUND_OFF) || normalised(turn) == 0) {
        turn[0] = (real)0;
        turn[1] = (real)1;
        turn[2] = (real)0;
    }
    copy(4, turn, ends[1].orientation);
}

/* The distance between two ends. */
static real length_between(const attachment ends[2], const workspace *work)
{
    motion at[2];
    real between[3];
    int k;
    attachment_motion(&ends[0], work, &at[0]);
    attachment_motion(&ends[1], work, &at[1]);
    for (k = 0; k < 3; k++) {
        between[k] = at[1].position[k] - at[0].position[k];
    }
    return square_root(dot(between, between));
}

/* What joints and forces take from the initial state. Gives a status. */
static int take_from_state(@P_tables *tables, const workspace *work)
{
    int index;
    for (index = 0; index < JOINTS; index++) {
        const rule *one = &joint_rules[index];
        link_place *link = &tables->links[index];
        switch (one->kind) {
        case RULE_TURNING:
        case RULE_HELD:
            second_triad(link->at, one->kind == RULE_TURNING ? 1 : 0, work);
            break;
        case RULE_AXIS:
            second_axis(link->at, work);
            break;
        case RULE_LENGTH: {
            const real length = length_between(link->at, work);
            if (!(length > (real)0)) {
                return @M_PARAMETERS;
            }
            tables->relations[link->relations].length = length;
            second_triad(link->at, 1, work);
            break;
        }
        case RULE_AS:
            link->at[0] = tables->links[one->joint].at[0];
            link->at[1] = tables->links[one->joint].at[1];
            break;
        default:
            break;
        }
    }
//@ if ELEMENTS
    for (index = 0; index < ELEMENTS; index++) {
        const rule *of = &element_rules[index];
        element *one = &tables->elements[index];
        switch (of->kind) {
        case RULE_LENGTH:
            one->rest = length_between(one->at, work);
            break;
//@ if TORSION_SPRING
        case RULE_TURNING:
        case RULE_HELD:
            second_triad(one->at, 1, work);
            if (of->kind == RULE_TURNING) {
                motion at[2];
                attachment_motion(&one->at[0], work, &at[0]);
                attachment_motion(&one->at[1], work, &at[1]);
                one->rest = relative_angle(at);
            }
            break;
//@ end
        case RULE_AS:
            one->at[0] = tables->links[of->joint].at[0];
            one->at[1] = tables->links[of->joint].at[1];
            break;
        default:
            break;
        }
    }
//@ end
//@ if SOFT
    for (index = JOINTS; index < LINKS; index++) {
        tables->links[index].at[0] = tables->elements[soft_elements[index - JOINTS]].at[0];
        tables->links[index].at[1] = tables->elements[soft_elements[index - JOINTS]].at[1];
    }
//@ end
//@ if ACTUATORS
    for (index = 0; index < ACTUATORS; index++) {
        if (actuator_rules[index].kind == RULE_AS) {
            tables->actuators[index].at[0] = tables->links[actuator_rules[index].joint].at[0];
            tables->actuators[index].at[1] = tables->links[actuator_rules[index].joint].at[1];
        }
    }
//@ end
    return DONE;
}

/* The share of a rate that may be left of joints at the beginning, of the largest velocity or of one. */
#define RATES_MET ((real)1e-7)

/* Moves a state onto the joints: parts as a whole where that meets them, else they give way. Gives a status. */
static int assemble(real time, workspace *work)
{
    real left[2];
    real smallest[2];
    int pass;
    int status = DONE;
    if (JOINTS == 0) {
        return DONE;
    }
    for (pass = 0; pass < ASSEMBLING_PASSES && status == DONE; pass++) {
        status = project(time, (real)1, (real)0, CORRECTIONS_OF_A_PASS, LARGEST, work);
    }
    if (status == DONE) {
        status = project(time, (real)1, (real)0, CORRECTIONS_OF_LAST_PASS, ASSEMBLED, work);
    }
    if (status != DONE) {
        return status;
    }
    prepare_all(work);
    status = evaluate_links(time, (real)0, work);
    if (status == DONE) {
        residuals(work, left);
        smallest_residuals(work, smallest);
        /* smallest residuals are round-off of the largest velocity */
        if (!(left[1] <= RATES_MET * larger((real)1, smallest[1] / ((real)2 * ROUND_OFF)))) {
            status = JOINTS_NOT_MET;
        }
    }
    return status;
}

static int is_start(const real *parameters, real time)
{
    int k;
    if (time < (real)0 || time > (real)0) {
        return 0;
    }
    for (k = 0; k < PARAMETERS; k++) {
        if (parameters[k] < parameter_starts[k] || parameters[k] > parameter_starts[k]) {
            return 0;
        }
    }
    return 1;
}

int @P_compose(const real *parameters, real time, @P_tables *tables, mechanism_state *state, int *refused)
{
    workspace work;
    mechanism_state initial = beginning;
    int status;
    int k;
    *refused = -1;
    copy(3, gravity, tables->gravity);
    for (k = 0; k < LINKS; k++) {
        tables->links[k] = links[k];
    }
    for (k = 0; k < RELATIONS; k++) {
        tables->relations[k] = relations[k];
    }
//@ if ELEMENTS
    for (k = 0; k < ELEMENTS; k++) {
        tables->elements[k] = elements[k];
    }
//@ end
//@ if ACTUATORS
    for (k = 0; k < ACTUATORS; k++) {
        tables->actuators[k] = actuators[k];
    }
//@ end
    if (!is_finite(time)) {
        return @M_STATE_NOT_FINITE;
    }
    for (k = 0; k < PARAMETERS; k++) {
        if (!is_allowed(&parameter_places[k], parameters[k])) {
            *refused = k;
            return @M_PARAMETERS;
        }
    }
    /* what the tables and the state are printed for */
    if (is_start(parameters, time)) {
        *state = beginning;
        return DONE;
    }
    for (k = 0; k < PARAMETERS; k++) {
        write_parameter(&parameter_places[k], parameters[k], tables, &initial);
    }
    for (k = 0; k < BODIES; k++) {
        if (normalised(initial.bodies[k].orientation) == 0) {
            return @M_PARAMETERS;
        }
    }
    work.tables = tables;
    work.state = initial;
    prepare_all(&work);
    status = take_from_state(tables, &work);
    if (status == DONE) {
        status = assemble(time, &work);
    }
    if (status != DONE) {
        return status;
    }
    if (!state_is_finite(&work.state)) {
        return NOT_FINITE;
    }
    *state = work.state;
    state->time = time;
    return DONE;
}
//@ end
