//! Kinetic energy and angular momentum.

use super::equations::{State, sums};
use super::groups::{groups, stored, zero};
use super::rigid::{add, cross, dot, times};
use super::{LaneBody, Lanes, Registers, Scalar};

impl<C: Copy, const M: usize, const G: usize, P, R> LaneBody<'_, C, M, G, P, R> {
    /// Kinetic energy. Units: J. Source: `docs/theory/README.md`, E, the sum of all kept terms.
    #[inline(always)]
    pub fn kinetic_energy<T: Scalar<Constant = C>>(
        &self,
        state: &State<T, G>,
        velocity: &[T; 3],
        omega: &[T; 3],
        q_dot: &[T; M],
    ) -> T
    where
        R: Registers<T>,
    {
        let registers = self.registers;
        let rates = groups::<T, R, M, G>(registers, q_dot);
        let mut modal = zero::<T, R>(registers);
        let vector = stored::<T, R, G>(&rates);
        for g in 0..G {
            let [momentum] = self.modal_mass.products::<T, R, 1>(registers, g, [rates[g]], [&vector]);
            modal = momentum.multiply_add(rates[g], modal);
        }
        let [modal] = sums::<T, R, 1>(registers, [modal]);
        let (velocity, omega) = (*velocity, *omega);
        let carried = add(cross(registers, omega, state.first_moment), state.momentum);
        let twice = T::constant(self.mass) * dot(registers, velocity, velocity)
            + dot(registers, omega, times(registers, state.inertia, omega))
            + modal;
        T::half() * twice + dot(registers, velocity, carried) + dot(registers, omega, state.spin)
    }

    /// Angular momentum m r × v + Θ_rr ω + Θ_rf q̇ about the frame origin. Shape: 3. Units: N m s.
    #[inline(always)]
    pub fn angular_momentum<T: Scalar<Constant = C>>(
        &self,
        state: &State<T, G>,
        velocity: &[T; 3],
        omega: &[T; 3],
    ) -> [T; 3]
    where
        R: Registers<T>,
    {
        let registers = self.registers;
        let orbital = cross(registers, state.first_moment, *velocity);
        add(orbital, add(times(registers, state.inertia, *omega), state.spin))
    }
}
