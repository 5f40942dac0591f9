//! The kernels with accelerations: modes eliminated first, then translation, then rotation.

use super::equations::{State, accumulate, sums};
use super::factors::solve_with_divisions_deferred;
use super::groups::{Register, four, grouped, groups, load, splat, stored, ungroup, zero};
use super::rigid::{subtract, subtract_dot};
use super::{LaneBody, Lanes, ModalFactors, Registers, Scalar};

impl<C: Copy, const M: usize, const G: usize, P, R> LaneBody<'_, C, M, G, P, R> {
    /// Mass matrix M(q), columns of N = 6 + M entries. Source: (203).
    #[inline(always)]
    pub fn mass_matrix<T: Scalar<Constant = C>, const N: usize>(&self, state: &State<T, G>) -> [[T; N]; N]
    where
        R: Registers<T>,
    {
        let mut columns = [[T::zero(); N]; N];
        self.write_mass_matrix(state, &mut columns);
        columns
    }

    /// Quadratic velocity vector Q(q, ω, q̇). Shape: N. Source: (209), corrected.
    #[inline(always)]
    pub fn quadratic_velocity<T: Scalar<Constant = C>, const N: usize>(&self, state: &State<T, G>) -> [T; N] {
        let mut entries = [T::zero(); N];
        state.write_quadratic_velocity(&mut entries);
        entries
    }

    /// Mass matrix, quadratic velocity vector and accelerations; `force` as in [`LaneBody::forward_dynamics`].
    #[inline(always)]
    pub fn equations_of_motion<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
        q: &[T; M],
        q_dot: &[T; M],
        force: &[T; N],
    ) -> ([[T; N]; N], [T; N], [T; N])
    where
        R: Registers<T>,
    {
        let mut results = ([[T::zero(); N]; N], [T::zero(); N], [T::zero(); N]);
        let (columns, quadratic, accelerations) = &mut results;
        self.write_equations_of_motion(state, q, q_dot, force, columns, quadratic, accelerations);
        results
    }

    /// [`LaneBody::equations_of_motion`] into given places: a large matrix is not moved.
    #[inline(always)]
    #[allow(clippy::too_many_arguments)] // inputs and outputs, each in its place
    pub fn write_equations_of_motion<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
        q: &[T; M],
        q_dot: &[T; M],
        force: &[T; N],
        mass_matrix: &mut [[T; N]; N],
        quadratic_velocity: &mut [T; N],
        acceleration: &mut [T; N],
    ) where
        R: Registers<T>,
    {
        // Accelerations last: where they wait for a division, what stands before them is still being stored.
        state.write_quadratic_velocity(quadratic_velocity);
        self.write_mass_matrix(state, mass_matrix);
        self.write_accelerations(state, q, q_dot, force, acceleration);
    }

    /// Accelerations [α; ω̇; q̈] under `force`, from which the caller subtracts the elastic and damping
    /// forces that are not in [`LaneBody::stiffness`] and [`LaneBody::damping`].
    ///
    /// M⁻¹ (force - Q) by factors M = L D Lᵀ in the order modes, translation, rotation; those of modes and translation
    /// are constant. Nothing is multiplied by an inverse: as accurate as a Cholesky factorisation of M.
    #[inline(always)]
    pub fn forward_dynamics<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
        q: &[T; M],
        q_dot: &[T; M],
        force: &[T; N],
    ) -> [T; N]
    where
        R: Registers<T>,
    {
        let mut entries = [T::zero(); N];
        self.write_accelerations(state, q, q_dot, force, &mut entries);
        entries
    }

    #[inline(always)]
    fn write_accelerations<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
        q: &[T; M],
        q_dot: &[T; M],
        force: &[T; N],
        entries: &mut [T; N],
    ) where
        R: Registers<T>,
    {
        let registers = self.registers;
        const { assert!(N == 6 + M) };
        let mut modal: [Register<T, R>; G] = grouped::<T, R, G>(registers, &force[6..]);
        let (q, q_dot) = (groups::<T, R, M, G>(registers, q), groups::<T, R, M, G>(registers, q_dot));
        let mut coupled = [zero::<T, R>(registers); 9];
        let mut shared = [zero::<T, R>(registers); 9];
        let mut carried = [zero::<T, R>(registers); 3];
        let (coordinates, rates) = (stored::<T, R, G>(&q), stored::<T, R, G>(&q_dot));
        for g in 0..G {
            modal[g] = modal[g] - load::<T, R>(registers, &state.modal.whirl[g]);
            modal[g] = self.stiffness.subtract_product::<T, R>(registers, g, q[g], &coordinates, modal[g]);
            modal[g] = self.damping.subtract_product::<T, R>(registers, g, q_dot[g], &rates, modal[g]);
        }
        // L⁻¹ Θ_rfᵀ and L⁻¹ f, where L is not the identity.
        let substituted;
        let mut coupling = &state.modal.odd;
        if let ModalFactors::Triangular { .. } = self.modal_factors {
            let [x, y, z] = state.modal.odd;
            let mut vectors = [x, y, z, stored::<T, R, G>(&modal)];
            self.modal_factors.forward(registers, &mut vectors);
            let [x, y, z, net] = vectors;
            substituted = [x, y, z];
            coupling = &substituted;
            modal = net.each_ref().map(|numbers| load::<T, R>(registers, numbers));
        }
        for g in 0..G {
            let rows = [0, 1, 2].map(|axis| load::<T, R>(registers, &coupling[axis][g]));
            let [row_x, row_y, row_z] = rows;
            let [weighted_x, weighted_y, weighted_z, free] =
                self.modal_factors.weigh::<T, R, 4>(registers, g, [row_x, row_y, row_z, modal[g]]);
            let weighted = [weighted_x, weighted_y, weighted_z];
            // Θ_rf Θ_ff⁻¹ Θ_rfᵀ and Θ_rf Θ_ff⁻¹ f
            for (k, (i, j)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
                shared[k] = accumulate::<T, R, G>(g, rows[i], weighted[j], shared[k]);
            }
            for i in 0..3 {
                shared[6 + i] = accumulate::<T, R, G>(g, rows[i], free, shared[6 + i]);
            }
            // m B Θ_ff⁻¹ Θ_rfᵀ and m B Θ_ff⁻¹ f
            if let Some(moments) = self.eliminated_first_moment {
                for i in 0..3 {
                    let moment = four::<T, R>(registers, &moments[g][i]);
                    for j in 0..3 {
                        coupled[3 * i + j] =
                            accumulate::<T, R, G>(g, moment, weighted[j], coupled[3 * i + j]);
                    }
                    carried[i] = accumulate::<T, R, G>(g, moment, free, carried[i]);
                }
            }
        }
        let shared = sums::<T, R, 9>(registers, shared);
        let mut rotation = [3, 4, 5].map(|i| force[i] - state.rotation[i - 3] - shared[i + 3]);
        let [s0, s1, s2, s3, s4, s5, ..] = shared;
        let mut schur = subtract(state.inertia, [s0, s1, s2, s3, s4, s5]);
        let mut translation = [0, 1, 2].map(|i| force[i] - state.translation[i]);

        let mass = self.translation_factors.map(T::constant);
        let [xx, yy, zz, ..] = self.inertia.map(T::constant);
        let scale = T::one() / (xx + yy + zz);
        let angular;
        if self.first_moment.is_none() && self.modal_first_moment.is_none() {
            translation = mass.weigh(translation);
            angular = solve_with_divisions_deferred(registers, schur, scale, rotation);
        } else {
            // Columns of -m r̃ - m B Θ_ff⁻¹ Θ_rfᵀ.
            let [x, y, z] = state.first_moment;
            let none = T::zero();
            let mut columns = [[none, -z, y], [z, none, -x], [-y, x, none]];
            if self.modal_first_moment.is_some() {
                let [c0, c1, c2, c3, c4, c5, c6, c7, c8] = coupled;
                let [f0, f1, f2] = carried;
                let [c0, c1, c2, c3, c4, c5, c6, c7, c8, f0, f1, f2] =
                    sums::<T, R, 12>(registers, [c0, c1, c2, c3, c4, c5, c6, c7, c8, f0, f1, f2]);
                columns = [[-c0, -z - c3, y - c6], [z - c1, -c4, -x - c7], [-y - c2, x - c5, -c8]];
                translation = subtract(translation, [f0, f1, f2]);
            }
            let columns = columns.map(|column| mass.forward(registers, column));
            let moved = columns.map(|column| mass.weigh(column));
            translation = mass.weigh(mass.forward(registers, translation));
            for (k, (i, j)) in [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].into_iter().enumerate() {
                schur[k] = subtract_dot(registers, schur[k], columns[i], moved[j]);
            }
            for axis in 0..3 {
                rotation[axis] = subtract_dot(registers, rotation[axis], columns[axis], translation);
            }
            angular = solve_with_divisions_deferred(registers, schur, scale, rotation);
            // Unknowns enter in the order in which they are found, so that little is left to do behind the last one.
            for axis in 0..3 {
                let row = [2, 1, 0].map(|k: usize| moved[k][axis]);
                translation[axis] =
                    subtract_dot(registers, translation[axis], row, [2, 1, 0].map(|k: usize| angular[k]));
            }
            translation = mass.backward(registers, translation);
        }

        let (along, about) = (
            translation.map(|number| splat::<T, R>(registers, number)),
            angular.map(|number| splat::<T, R>(registers, number)),
        );
        for g in 0..G {
            for axis in [2, 1, 0] {
                let row = load::<T, R>(registers, &coupling[axis][g]);
                modal[g] = row.subtract_from(about[axis], modal[g]);
            }
            if let Some(moments) = self.eliminated_first_moment {
                for axis in [2, 1, 0] {
                    modal[g] =
                        four::<T, R>(registers, &moments[g][axis]).subtract_from(along[axis], modal[g]);
                }
            }
            let [weighted] = self.modal_factors.weigh::<T, R, 1>(registers, g, [modal[g]]);
            modal[g] = weighted;
        }
        if let ModalFactors::Triangular { .. } = self.modal_factors {
            let mut vectors = [stored::<T, R, G>(&modal)];
            self.modal_factors.backward(registers, &mut vectors);
            let [accelerations] = vectors;
            modal = accelerations.each_ref().map(|numbers| load::<T, R>(registers, numbers));
        }
        write(translation, angular, |g| modal[g].store(), entries);
    }
}

impl<T: Scalar, const G: usize> State<T, G> {
    #[inline(always)]
    fn write_quadratic_velocity<const N: usize>(&self, entries: &mut [T; N]) {
        write(self.translation, self.rotation, |g| self.modal.whirl[g], entries);
    }
}

/// The parts one below the other.
#[inline(always)]
fn write<T: Scalar, const N: usize>(
    translation: [T; 3],
    rotation: [T; 3],
    modal: impl Fn(usize) -> [T; 4],
    entries: &mut [T; N],
) {
    entries[..3].copy_from_slice(&translation);
    entries[3..6].copy_from_slice(&rotation);
    ungroup(modal, &mut entries[6..]);
}
