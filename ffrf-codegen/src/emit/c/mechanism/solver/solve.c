//@ if FLEXIBLE
/* Subtracts what the modes of a body let two of its links yield. */
static void subtract_compliance(int rows_end, int row_count, int columns_end, int column_count, int modes,
    const workspace *work, real block[36])
{
    const real *modal = work->ends[rows_end].modal;
    const real *weighted = work->ends[columns_end].weighted;
    int row;
    int k;
    for (k = 0; k < modes; k++) {
        for (row = 0; row < row_count; row++) {
            add_scaled(column_count, -modal[6 * k + row], &weighted[6 * k], &block[6 * row]);
        }
    }
}

//@ end
//@ if LOOPS
/* How far a body yields to a force on its frame; one with modes, to each component of the force alone. */
static real yielding(const body_work *body, int modes, const real force[6])
{
    real sum = (real)0;
    int k;
//@ if RIGID
    if (modes == 0) {
        for (k = 0; k < 36; k++) {
            sum += body->compliance[k] * force[k / 6] * force[k % 6];
        }
        return sum;
    }
//@ end
    for (k = 0; k < 6; k++) {
        const real mass = body->remaining[7 * k];
        if (mass > (real)0) {
            sum += force[k] * force[k] / mass;
        }
    }
    (void)modes;
    return sum;
}

//@ end
/* Puts the rows of a link on one of its bodies into the matrix; of a joint in a loop, sums what its rows meet there. */
static void attach(int index, int end, workspace *work)
{
    const link_place *link = &@Tlinks[index];
    const end_place *place = &link->ends[end];
    const real *gradients = work->rows[index].gradients[end];
    real *block;
    placed_marker placed;
//@ if FLEXIBLE
    const body_work *body;
//@ end
    real generalised[VELOCITIES];
    int row;
    int k;
    if (place->end < 0) {
        return;
    }
    place_marker(link->at[end].marker, work, &placed);
//@ if FLEXIBLE
    body = &work->bodies[placed.body];
//@ end
    block = &work->blocks[36 * place->block];
    for (row = 0; row < work->rows[index].count; row++) {
        real force[3];
        real moment[3];
        for (k = 0; k < 3; k++) {
            force[k] = gradients[6 * k + row];
            moment[k] = gradients[6 * (3 + k) + row];
        }
        marker_force(&placed, force, moment, generalised);
//@ if FLEXIBLE
        for (k = 0; k < placed.modes; k++) {
            work->ends[place->end].modal[6 * k + row] = generalised[6 + k];
            work->ends[place->end].weighted[6 * k + row] = generalised[6 + k];
            add_scaled(6, -generalised[6 + k], &body->followed[6 * k], generalised);
        }
//@ end
//@ if LOOPS
        if (index < JOINTS) {
            work->shift[6 * link->node + row] += yielding(&work->bodies[placed.body], placed.modes, generalised);
        }
//@ end
        for (k = 0; k < 6; k++) {
            block[place->transposed != 0 ? 6 * row + k : 6 * k + row] = generalised[k];
        }
    }
//@ if FLEXIBLE
    if (placed.modes > 0) {
        const int count = work->rows[index].count;
        solve_modal(
            placed.modes, flexible_bodies[flexible_of[placed.body]].is_diagonal, body->factors, count, 6,
            work->ends[place->end].weighted
        );
        subtract_compliance(
            place->end, count, place->end, count, placed.modes, work, &work->blocks[36 * link->diagonal]
        );
    }
//@ end
}

//@ if LOOPS
/* Subtracts a share of the compliance that each row of a joint meets from the diagonal, where the modes' part of it stands. */
static void shift_rows(const link_place *link, workspace *work)
{
    real *diagonal = &work->blocks[36 * link->diagonal];
    real *shift = &work->shift[6 * link->node];
    int k;
    for (k = 0; k < link->rows; k++) {
        shift[k] = SHARE * (shift[k] - diagonal[7 * k]);
        diagonal[7 * k] -= shift[k];
    }
}

//@ end
/* Factors the system in the state that was evaluated. Gives a status. */
static int factor(const stage_terms *terms, workspace *work)
{
    int index;
    fill(36 * BLOCKS, (real)0, work->blocks);
    for (index = 0; index < BODIES; index++) {
        if (!factor_body(index, &work->state.bodies[index], terms, &work->bodies[index])) {
            return NO_MASS;
        }
        copy(36, work->bodies[index].remaining, &work->blocks[36 * body_diagonals[index]]);
    }
    for (index = 0; index < LINKS; index++) {
        attach(index, 0, work);
        attach(index, 1, work);
//@ if SOFT
        if (index >= JOINTS) {
            const link_place *link = &@Tlinks[index];
            int k;
            for (k = 0; k < link->rows; k++) {
                work->blocks[36 * link->diagonal + 7 * k] -= (real)1;
            }
        }
//@ end
//@ if LOOPS
        if (index < JOINTS) {
            shift_rows(&@Tlinks[index], work);
        }
//@ end
    }
//@ if SHARED
    for (index = 0; index < SHARED; index++) {
        const shared_place *place = &shared[index];
        subtract_compliance(
            place->rows, place->row_count, place->columns, place->column_count, end_modes[place->rows], work,
            &work->blocks[36 * place->block]
        );
    }
//@ end
    return factor_blocks(work->blocks) ? DONE : NO_MASS;
}

/* Solves for the right-hand sides; what rows leave over for being shifted is solved for anew. */
static void solve(int refinements, workspace *work)
{
    int index;
    int k;
    int pass;
    copy(6 * NODES, work->right, work->solution);
    solve_forwards(0, work->blocks, work->solution);
    solve_backwards(LEADING, STEPS, work->blocks, work->solution);
    for (pass = 0; pass < refinements; pass++) {
        const real *last = pass == 0 ? work->solution : work->right;
        real change = (real)0;
        real size = (real)0;
        for (k = 0; k < 6 * NODES; k++) {
            work->right[k] = -(work->shift[k] * last[k]);
        }
        solve_forwards(LEADING, work->blocks, work->right);
        solve_backwards(LEADING, STEPS, work->blocks, work->right);
        for (index = LEADING; index < STEPS; index++) {
            const int node = steps[index].node;
            add_scaled(6, (real)1, &work->right[6 * node], &work->solution[6 * node]);
        }
        for (k = 0; k < 6 * NODES; k++) {
            change += work->shift[k] * work->right[k] * work->right[k];
            size += work->shift[k] * work->solution[k] * work->solution[k];
        }
        if (change <= ENOUGH_REFINED * size) {
            break;
        }
    }
    solve_backwards(0, LEADING, work->blocks, work->solution);
    for (index = 0; index < BODIES; index++) {
        finish_body(index, &work->solution[6 * index], &work->bodies[index]);
    }
//@ if FLEXIBLE
    for (index = 0; index < LINKS; index++) {
        const link_place *link = &@Tlinks[index];
        int end;
        for (end = 0; end < 2; end++) {
            if (link->ends[end].end >= 0) {
                const end_work *rows = &work->ends[link->ends[end].end];
                body_work *body = &work->bodies[markers[link->at[end].marker].body];
                int row;
                for (k = 0; k < end_modes[link->ends[end].end]; k++) {
                    for (row = 0; row < link->rows; row++) {
                        body->result[6 + k] -= rows->weighted[6 * k + row] * work->solution[6 * link->node + row];
                    }
                }
            }
        }
    }
//@ end
}

/* Subtracts what the modes do to the rows of a link without the motion of the frames. */
static void subtract_modal_accelerations(int index, const workspace *work, real wanted[6])
{
//@ if FLEXIBLE
    const link_place *link = &@Tlinks[index];
    int end;
    int k;
    for (end = 0; end < 2; end++) {
        if (link->ends[end].end >= 0) {
            const body_work *body = &work->bodies[markers[link->at[end].marker].body];
            for (k = 0; k < end_modes[link->ends[end].end]; k++) {
                add_scaled(link->rows, -body->alone[k], &work->ends[link->ends[end].end].modal[6 * k], wanted);
            }
        }
    }
//@ end
    (void)index;
    (void)work;
    (void)wanted;
}

/* Subtracts the products of the gradients of a link with a motion of its bodies, one motion after the other. */
static void subtract_powers(int index, const workspace *work, const real *moving, real wanted[6])
{
    int end;
    for (end = 0; end < 2; end++) {
        const int marker = @Tlinks[index].at[end].marker;
        if (marker >= 0) {
            placed_marker placed;
            real twist[6];
            int k;
            place_marker(marker, work, &placed);
            marker_twist(&placed, &moving[VELOCITIES * placed.body], twist);
            for (k = 0; k < 6; k++) {
                twist[k] = -twist[k];
            }
            add_powers(work->rows[index].count, work->rows[index].gradients[end], &twist[0], &twist[3], wanted);
        }
    }
}
