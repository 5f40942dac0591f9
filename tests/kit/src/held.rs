//! A body whose frame origin is held, by the reaction force that keeps its acceleration zero.

use ffrf_runtime::nalgebra::{Matrix3, SVector, Vector3};
use ffrf_runtime::{FlexibleBody, Load, State};

/// A load, and the force at the frame origin that makes α = 0 under it.
pub struct HeldAtOrigin<L>(pub L);

impl<L> HeldAtOrigin<L> {
    /// The reaction f̄ on the body. The accelerations are linear in it: α(f̄) = α(0) + G f̄ = 0.
    ///
    /// Shape: 3. Units: N. Frame: body.
    pub fn reaction<B, const M: usize, const N: usize>(
        &self,
        body: &B,
        time: f64,
        state: &State<M>,
    ) -> Vector3<f64>
    where
        B: FlexibleBody<M, N>,
        L: Load<B, M, N>,
    {
        let mut force = SVector::<f64, N>::zeros();
        self.0.add_to(body, time, state, &mut force);
        let origin_acceleration = |force: &SVector<f64, N>| {
            let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
            let all = body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, force);
            Vector3::new(all[0], all[1], all[2])
        };
        let free = origin_acceleration(&force);
        let columns = [0, 1, 2].map(|i| {
            let mut with_unit_force = force;
            with_unit_force[i] += 1.0;
            origin_acceleration(&with_unit_force) - free
        });
        let compliance = Matrix3::from_columns(&columns);
        compliance.lu().solve(&-free).unwrap_or_else(|| Vector3::repeat(f64::NAN))
    }
}

impl<B, L, const M: usize, const N: usize> Load<B, M, N> for HeldAtOrigin<L>
where
    B: FlexibleBody<M, N>,
    L: Load<B, M, N>,
{
    fn add_to(&self, body: &B, time: f64, state: &State<M>, force: &mut SVector<f64, N>) {
        self.0.add_to(body, time, state, force);
        let reaction = self.reaction(body, time, state);
        for i in 0..3 {
            force[i] += reaction[i];
        }
    }
}
