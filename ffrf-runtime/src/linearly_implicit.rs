//! A linearly implicit step of order two for bodies with stiff modes.
//!
//! The method is ROS2, a Rosenbrock-W method with two stages. For y' = f(t, y),
//!
//! ```text
//! (I - γ h J) k1 = f(t, y)
//! (I - γ h J) k2 = f(t + h, y + h k1) - 2 k1
//! y_new = y + 3/2 h k1 + 1/2 h k2,        γ = 1 - 1/√2
//! ```
//!
//! It has order two for *any* matrix J and is L-stable when J is the Jacobian of a linear f. Here J holds
//! what is stiff, the elastic and damping forces, frozen at the start of the step, and nothing else:
//!
//! ```text
//! q'                = q̇
//! M(q_n) [α; ω̇; q̈]  = -[0; 0; K_ff q + D_ff q̇]
//! ```
//!
//! so that a stage, with residual r_q for q and r for [α; ω̇; q̈], is one symmetric positive definite system:
//!
//! ```text
//! (M(q_n) + diag(0, 0, γ h D_ff + γ² h² K_ff)) k = M(q_n) r - γ h [0; 0; K_ff r_q]
//! k_q = r_q + γ h k_f
//! ```
//!
//! Modes with h ω >> 1 are damped away, not resolved: that is the point. Modes with h ω of order one lose
//! amplitude; what must ring for long needs a step that resolves it (h ω < 0.1), or the explicit method.
//!
//! Source: Verwer, Spee, Blom, Hundsdorfer, A second-order Rosenbrock method applied to photochemical
//! dispersion problems, SIAM J. Sci. Comput. 20 (1999) 1456-1480.

use nalgebra::{RealField, SVector, Vector3};

use crate::augmented_mass::AugmentedMass;
use crate::phase::{Phase, part, rates};
use crate::rotation::quaternion_rate;
use crate::step::checked_step_size;
use crate::{FlexibleBody, Load, State, StepError, StepReport};

/// One step of ROS2 with the modal stiffness and damping implicit: order 2, stable for any h ω_max.
///
/// One mass matrix, one quadratic velocity vector, one `forward_dynamics`, two evaluations of the load, one
/// factorisation (M x M and 6 x 6); no allocation, bounded work. The error estimate is the difference to
/// the embedded method of order one. Source: see the module's text, Verwer et al. (1999).
///
/// Units: `time`, `step` s. Errors: see [`StepError`]. Panics: never.
pub fn step_linearly_implicit<B, L, const M: usize, const N: usize, T>(
    body: &B,
    state: &State<M, T>,
    time: T,
    step: T,
    load: &L,
) -> Result<(State<M, T>, StepReport<T>), StepError>
where
    B: FlexibleBody<M, N, T>,
    L: Load<B, M, N, T>,
    T: RealField + Copy,
{
    let h = checked_step_size(step)?;
    if !state.is_finite() {
        return Err(StepError::NonFiniteState);
    }
    let half: T = nalgebra::convert(0.5);
    let two: T = nalgebra::convert(2.0);
    // γ = 1 - 1/√2: the L-stable choice with the smaller error constant
    let gamma_h = (T::one() - half.sqrt()) * h;

    let q = &state.modal_coordinates;
    let (omega, q_dot) = (&state.angular_velocity, &state.modal_rates);
    let stiffness = body.stiffness_matrix();
    let mass = body.mass_matrix(q);
    let implicit = body.damping_matrix() * gamma_h + stiffness * (gamma_h * gamma_h);
    let matrix = AugmentedMass::new(&mass, &implicit).ok_or(StepError::MassNotPositive)?;

    // one stage: `right` is M(q_n) r; the rest of `residual` passes through, as J has no rows for it
    let stage = |right: SVector<T, N>, residual: &Phase<M, T>| {
        let mut right = right;
        let pull = stiffness * residual.modal_coordinates * gamma_h;
        for mu in 0..M {
            right[6 + mu] -= pull[mu];
        }
        let k = matrix.solve(&right);
        let modal_rates = part::<M, N, T>(&k, 6);
        Phase {
            position: residual.position,
            quaternion: residual.quaternion,
            modal_coordinates: residual.modal_coordinates + modal_rates * gamma_h,
            velocity: state.to_inertial(&Vector3::new(k[0], k[1], k[2])),
            angular_velocity: Vector3::new(k[3], k[4], k[5]),
            modal_rates,
        }
    };

    let y = Phase::of(state);
    let mut right = -body.quadratic_velocity(q, omega, q_dot);
    load.add_to(body, time, state, &mut right);
    let internal = body.internal_force(q, q_dot);
    for mu in 0..M {
        right[6 + mu] -= internal[mu];
    }
    let first = Phase {
        position: y.velocity,
        quaternion: quaternion_rate(&y.quaternion, omega),
        modal_coordinates: y.modal_rates,
        // not read by the stage, which has M(q_n) r instead
        velocity: Vector3::zeros(),
        angular_velocity: Vector3::zeros(),
        modal_rates: SVector::zeros(),
    };
    let k1 = stage(right, &first);

    let second = rates(body, load, time + h, &y.plus(h, &k1))?.plus(-two, &k1);
    let mut residual = SVector::<T, N>::zeros();
    residual.fixed_rows_mut::<3>(0).copy_from(&state.to_body(&second.velocity));
    residual.fixed_rows_mut::<3>(3).copy_from(&second.angular_velocity);
    residual.fixed_rows_mut::<M>(6).copy_from(&second.modal_rates);
    let k2 = stage(mass * residual, &second);

    let slope = k1.scaled(h + h * half).plus(h * half, &k2);
    y.plus(T::one(), &slope).accept(&slope.plus(-h, &k1))
}
