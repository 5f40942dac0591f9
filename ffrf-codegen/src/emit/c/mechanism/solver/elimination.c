/*
 * Block L D L' of the equations, in the order and with the pattern of `steps`: the unknowns are grouped in nodes, the six
 * accelerations of each body's frame and the multipliers of each joint. Blocks are 6 x 6, row by row, and have the rows of the
 * node that is eliminated first. In place: L' above the diagonal of a node's block, one over D on it; behind it D^-1 L^-1 A.
 */
static int factor_blocks(real *blocks)
{
    int step;
    int i;
    int j;
    int k;
    int p;
    int q;
    for (step = 0; step < STEPS; step++) {
        const step_place *place = &steps[step];
        const int size = place->size;
        real *diagonal = &blocks[36 * place->diagonal];
        real *panel = diagonal + 36;
        real sound = (real)0;
        int target = place->targets;
        for (j = 0; j < size; j++) {
            const real pivot = diagonal[7 * j];
            const real inverse = (real)1 / pivot;
            for (i = j + 1; i < size; i++) {
                const real upper = inverse * diagonal[6 * j + i];
                for (k = i; k < size; k++) {
                    diagonal[6 * i + k] -= upper * diagonal[6 * j + k];
                }
            }
            for (i = j + 1; i < size; i++) {
                diagonal[6 * j + i] *= inverse;
            }
            diagonal[7 * j] = inverse;
            /* one, unless the pivot is zero or not finite */
            sound += pivot * inverse;
        }
        if (!is_finite(sound)) {
            return 0;
        }
        for (p = 0; p < place->coupling_count; p++) {
            const int columns = couplings[place->couplings + p].size;
            real *own = &panel[36 * p];
            real eliminated[36];
            copy(36, own, eliminated);
            for (j = 0; j < size; j++) {
                for (i = j + 1; i < size; i++) {
                    add_scaled(columns, -diagonal[6 * j + i], &eliminated[6 * j], &eliminated[6 * i]);
                }
            }
            for (i = 0; i < size; i++) {
                for (k = 0; k < columns; k++) {
                    own[6 * i + k] = diagonal[7 * i] * eliminated[6 * i + k];
                }
            }
            for (q = 0; q <= p; q++) {
                const real *other = &panel[36 * q];
                const int rows = couplings[place->couplings + q].size;
                real *block = &blocks[36 * targets[target]];
                target++;
                for (k = 0; k < rows; k++) {
                    const int begin = q == p ? k : 0;
                    for (i = 0; i < size; i++) {
                        add_scaled(
                            columns - begin, -other[6 * i + k], &eliminated[6 * i + begin], &block[6 * k + begin]
                        );
                    }
                }
            }
        }
    }
    return 1;
}

/* L x = b in place, from a step on. */
static void solve_forwards(int begin, const real *blocks, real *unknowns)
{
    int step;
    int i;
    int j;
    int p;
    for (step = begin; step < STEPS; step++) {
        const step_place *place = &steps[step];
        const real *diagonal = &blocks[36 * place->diagonal];
        real *own = &unknowns[6 * place->node];
        for (j = 0; j < place->size; j++) {
            for (i = j + 1; i < place->size; i++) {
                own[i] -= diagonal[6 * j + i] * own[j];
            }
        }
        for (p = 0; p < place->coupling_count; p++) {
            const coupling_place *coupling = &couplings[place->couplings + p];
            const real *block = diagonal + 36 + 36 * p;
            for (i = 0; i < place->size; i++) {
                add_scaled(coupling->size, -own[i], &block[6 * i], &unknowns[6 * coupling->node]);
            }
        }
    }
}

/* D L' x = b in place, from the step before `end` down to `begin`. */
static void solve_backwards(int begin, int end, const real *blocks, real *unknowns)
{
    int step;
    int i;
    int j;
    int k;
    int p;
    for (step = end - 1; step >= begin; step--) {
        const step_place *place = &steps[step];
        const real *diagonal = &blocks[36 * place->diagonal];
        real *own = &unknowns[6 * place->node];
        for (i = 0; i < place->size; i++) {
            own[i] *= diagonal[7 * i];
        }
        for (p = 0; p < place->coupling_count; p++) {
            const coupling_place *coupling = &couplings[place->couplings + p];
            const real *block = diagonal + 36 + 36 * p;
            const real *later = &unknowns[6 * coupling->node];
            for (i = 0; i < place->size; i++) {
                for (k = 0; k < coupling->size; k++) {
                    own[i] -= block[6 * i + k] * later[k];
                }
            }
        }
        for (i = place->size - 1; i > 0; i--) {
            for (j = 0; j < i; j++) {
                own[j] -= diagonal[6 * j + i] * own[i];
            }
        }
    }
}
