//! A body whose frame origin is held, by the reaction force that keeps its acceleration zero.

use ffrf_runtime::nalgebra::{Matrix3, Vector3};
use ffrf_runtime::{FlexibleBody, GeneralisedForce, Load, State};

/// A load, and the force at the frame origin that makes α = 0 under it.
pub struct HeldAtOrigin<L>(pub L);

impl<L> HeldAtOrigin<L> {
    /// The reaction f̄ on the body. The accelerations are linear in it: α(f̄) = α(0) + G f̄ = 0.
    ///
    /// Shape: 3. Units: N. Frame: body.
    pub fn reaction<B>(&self, body: &B, time: f64, state: &State<B::Modal>) -> Vector3<f64>
    where
        B: FlexibleBody,
        L: Load<B, State<B::Modal>, GeneralisedForce<B::Modal>>,
    {
        let mut force = GeneralisedForce::zeros(&state.modal_coordinates);
        self.0.add_to(body, time, state, &mut force);
        let origin_acceleration = |force: &GeneralisedForce<B::Modal>| {
            let State { modal_coordinates, angular_velocity, modal_rates, .. } = state;
            body.forward_dynamics(modal_coordinates, angular_velocity, modal_rates, force).linear
        };
        let free = origin_acceleration(&force);
        let columns = [0, 1, 2].map(|i| {
            let mut with_unit_force = force.clone();
            with_unit_force.force[i] += 1.0;
            origin_acceleration(&with_unit_force) - free
        });
        let compliance = Matrix3::from_columns(&columns);
        compliance.lu().solve(&-free).unwrap_or_else(|| Vector3::repeat(f64::NAN))
    }
}

impl<B, L> Load<B, State<B::Modal>, GeneralisedForce<B::Modal>> for HeldAtOrigin<L>
where
    B: FlexibleBody,
    L: Load<B, State<B::Modal>, GeneralisedForce<B::Modal>>,
{
    fn add_to(&self, body: &B, time: f64, state: &State<B::Modal>, force: &mut GeneralisedForce<B::Modal>) {
        self.0.add_to(body, time, state, force);
        force.force += self.reaction(body, time, state);
    }
}
