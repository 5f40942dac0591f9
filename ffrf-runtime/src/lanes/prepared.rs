//! What mechanisms, outputs and implicit steps need of a state.

use super::equations::State;
use super::groups::ungroup;
use super::{LaneBody, Scalar};

impl<C: Copy, const M: usize, const G: usize, P, R> LaneBody<'_, C, M, G, P, R> {
    /// m, m r, Θ_rr, rows of m B, rows of Θ_rf and Q: the parts of [`Prepared`](crate::Prepared) that loops compute.
    #[inline(always)]
    #[allow(clippy::type_complexity)] // the results of a kernel, one after another
    pub fn prepare<T: Scalar<Constant = C>, const N: usize>(
        &self,
        state: &State<T, G>,
    ) -> (T, [T; 3], [[T; 3]; 3], [[T; M]; 3], [[T; M]; 3], [T; N]) {
        let [xx, yy, zz, xy, xz, yz] = state.inertia;
        let mut momentum = [[T::zero(); M]; 3];
        let mut coupling = [[T::zero(); M]; 3];
        for (axis, (momentum, coupling)) in momentum.iter_mut().zip(&mut coupling).enumerate() {
            if let Some(moments) = self.modal_first_moment {
                ungroup(|g| moments[g][axis].map(T::constant), momentum);
            }
            ungroup(|g| state.modal.odd[axis][g], coupling);
        }
        (
            T::constant(self.mass),
            state.first_moment,
            [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]],
            momentum,
            coupling,
            self.quadratic_velocity(state),
        )
    }
}
