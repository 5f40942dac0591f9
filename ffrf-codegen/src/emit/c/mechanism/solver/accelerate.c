/* Accelerations of every body and multipliers in the factored state: rates of residuals stay as they are. */
static void accelerate(const stage_terms *terms, workspace *work)
{
    real subtracted[BODIES * VELOCITIES];
    int index;
    int k;
    fill(BODIES * VELOCITIES, (real)0, subtracted);
    fill(6 * NODES, (real)0, work->right);
    for (index = 0; index < BODIES; index++) {
        reduced_force(index, &work->bodies[index], &work->right[6 * index]);
        if (terms->subtracted != NULL) {
            body_velocities(
                &work->bodies[index], &terms->subtracted[INCREMENT * index], &subtracted[VELOCITIES * index]
            );
        }
    }
    for (index = 0; index < JOINTS; index++) {
        const row_set *rows = &work->rows[index];
        real *wanted = &work->right[6 * @Tlinks[index].node];
        int end;
        copy(rows->count, rows->bias, wanted);
        for (end = 0; end < 2; end++) {
            const motion *at = &work->at[index][end];
            add_powers(rows->count, rows->gradients[end], at->bias, at->omega_bias, wanted);
        }
        for (k = 0; k < rows->count; k++) {
            wanted[k] = -wanted[k];
        }
        subtract_modal_accelerations(index, work, wanted);
        if (terms->subtracted != NULL) {
            subtract_powers(index, work, subtracted, wanted);
        }
    }
//@ if SOFT
    pull_soft_links(terms, work);
//@ end
    solve(REFINEMENTS, work);
}

/* Displacements or changes of velocity of least kinetic energy that take residuals away, to first order. */
static void correct(int is_velocity, workspace *work)
{
    int index;
    int k;
    fill(6 * NODES, (real)0, work->right);
//@ if FLEXIBLE
    for (index = 0; index < BODIES; index++) {
        fill(MODES, (real)0, work->bodies[index].alone);
    }
//@ end
    for (index = 0; index < JOINTS; index++) {
        const row_set *rows = &work->rows[index];
        real *wanted = &work->right[6 * @Tlinks[index].node];
        if (is_velocity != 0) {
            row_velocities(index, work, wanted);
        } else {
            copy(rows->count, rows->residual, wanted);
        }
        for (k = 0; k < rows->count; k++) {
            wanted[k] = -wanted[k];
        }
    }
    solve(REFINEMENTS_OF_CORRECTIONS, work);
}
