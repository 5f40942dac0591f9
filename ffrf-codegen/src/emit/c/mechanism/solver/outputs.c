//@ if SENSORS
int @P_read(@Gconst mechanism_state *state, const mechanism_inputs *inputs, @P_outputs *outputs)
{
    workspace space;
    workspace *work = &space;
    stage_terms terms;
    int status;
    int index;
    int k;
//@ if PARAMETERS
    work->tables = tables;
//@ end
    terms.gamma_h = (real)0;
    terms.subtracted = NULL;
    terms.increment = NULL;
    if (!(state_is_finite(state) && is_finite(state->time))) {
        return @M_STATE_NOT_FINITE;
    }
    work->state = *state;
    status = evaluate(inputs, state->time, &terms, work);
    if (status != DONE) {
        return status;
    }
    for (index = 0; index < SENSORS; index++) {
        const sensor *one = &sensors[index];
        real *values = &outputs->values[one->first];
        real vector[3] = {(real)0, (real)0, (real)0};
        motion at;
        attachment_motion(&one->at, work, &at);
        switch (one->kind) {
        case POSITION:
            copy(3, at.position, values);
            break;
        case VELOCITY:
            copy(3, at.velocity, values);
            break;
        case ORIENTATION:
            copy(4, at.orientation, values);
            break;
        case ACCELERATION:
            if (one->at.marker >= 0) {
                placed_marker placed;
                real twist[6];
                place_marker(one->at.marker, work, &placed);
                marker_twist(&placed, work->bodies[placed.body].result, twist);
                copy(3, twist, vector);
            }
            for (k = 0; k < 3; k++) {
                values[k] = at.bias[k] + vector[k];
            }
            break;
//@ if TURN
        case TURN:
            values[0] = relative_angle(work->at[one->link]);
            break;
//@ end
//@ if REACTION
        case REACTION_FORCE:
        case REACTION_MOMENT: {
            /* on the second body, of a joint and of its drive behind it */
            int j;
            for (j = one->link; j < one->link + one->link_count; j++) {
                const real *gradients = work->rows[j].gradients[1];
                for (k = 0; k < work->rows[j].count; k++) {
                    const real multiplier = -work->solution[6 * @Tlinks[j].node + k];
                    const int first = one->kind == REACTION_FORCE ? 0 : 3;
                    vector[0] += gradients[6 * first + k] * multiplier;
                    vector[1] += gradients[6 * (first + 1) + k] * multiplier;
                    vector[2] += gradients[6 * (first + 2) + k] * multiplier;
                }
            }
            copy(3, vector, values);
            break;
        }
//@ end
        default:
            break;
        }
    }
    return DONE;
}
//@ end
