//! Kinetic energy and angular momentum.

use super::equations::{State, sums};
use super::rigid::{add, cross, dot, times};
use super::scalar::{Register, groups, stored};
use super::{LaneBody, Lanes, Scalar};

impl<C: Copy, const M: usize, const G: usize, P> LaneBody<'_, C, M, G, P> {
    /// Kinetic energy. Units: J. Source: `docs/theory/README.md`, E, the sum of all kept terms.
    #[inline(always)]
    pub fn kinetic_energy<T: Scalar<Constant = C>>(
        &self,
        state: &State<T, G>,
        velocity: &[T; 3],
        omega: &[T; 3],
        q_dot: &[T; M],
    ) -> T {
        let rates = groups::<T, M, G>(q_dot);
        let mut modal = Register::<T>::zero();
        let vector = stored::<T, G>(&rates);
        for g in 0..G {
            let [momentum] = self.modal_mass.products::<T, 1>(g, [rates[g]], [&vector]);
            modal = momentum.multiply_add(rates[g], modal);
        }
        let [modal] = sums::<T, 1>([modal]);
        let (velocity, omega) = (*velocity, *omega);
        let carried = add(cross(omega, state.first_moment), state.momentum);
        let twice = T::constant(self.mass) * dot(velocity, velocity)
            + dot(omega, times(state.inertia, omega))
            + modal;
        T::half() * twice + dot(velocity, carried) + dot(omega, state.spin)
    }

    /// Angular momentum m r × v + Θ_rr ω + Θ_rf q̇ about the frame origin. Shape: 3. Units: N m s.
    #[inline(always)]
    pub fn angular_momentum<T: Scalar<Constant = C>>(
        &self,
        state: &State<T, G>,
        velocity: &[T; 3],
        omega: &[T; 3],
    ) -> [T; 3] {
        let orbital = cross(state.first_moment, *velocity);
        add(orbital, add(times(state.inertia, *omega), state.spin))
    }
}
