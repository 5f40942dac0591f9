//! Generated bodies: statements, loops over a whole table, loops over half of it, every number type, invariants at run time.

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{DenseForms, FreeBody, GeneralisedForce, NamedMarkers, Observables, flexible_body};

include!(concat!(env!("OUT_DIR"), "/ManyModes.rs"));
include!(concat!(env!("OUT_DIR"), "/DenseModalMass.rs"));

flexible_body! {
    struct FewModes { model: "../../models/conrod.ffrf.json", modes: ..2, jacobians: true }
}

flexible_body! {
    struct EightModes { model: "../../models/conrod.ffrf.json" }
}

flexible_body! {
    struct Generic { model: "../../models/conrod.ffrf.json", scalar: generic }
}

flexible_body! {
    struct AtRunTime { modes: 2, layout: { first_moment: zero, modal_mass: identity } }
}

/// Whether invariants that come at run time are checked, and the wrong number is named.
fn invariants_are_checked(mass: f64) -> bool {
    let third = [[1.0 / 3.0, 0.0, 0.0], [0.0, 1.0 / 3.0, 0.0], [0.0, 0.0, 1.0 / 3.0]];
    let zero = [[0.0; 3]; 3];
    let mut body = AtRunTime {
        mass,
        modal_first_moment: [[0.1, 0.0, 0.0], [0.0, 0.1, 0.0]],
        second_moment: [[2.0, 0.0, 0.0], [0.0, 1.0, 0.1], [0.0, 0.1, 3.0]],
        position_mode_moment: [zero; 2],
        mode_mode_moment: [[third, zero], [zero, third]],
        stiffness: [[9.0, 1.0], [1.0, 9.0]],
        damping: [[0.0; 2]; 2],
    };
    let sound = body.check().is_ok();
    body.mode_mode_moment[1][0][2][0] = mass;
    sound && body.check().is_err_and(|error| error.index.as_slice() == [1, 0, 2, 0] && error.found == mass)
}

flexible_body! {
    /// Nine modes whose invariants come at run time.
    struct Fields {
        modes: 9,
        layout: { modal_first_moment: zero, modal_mass: identity, stiffness: diagonal, damping: zero },
    }
}

fn fields() -> Fields {
    let third = 1.0 / 3.0;
    let mut moments = [[[[0.0; 3]; 3]; 9]; 9];
    for (mu, row) in moments.iter_mut().enumerate() {
        for (nu, moment) in row.iter_mut().enumerate() {
            let odd = 0.01 * (mu as f64 - nu as f64);
            *moment = [[0.0, odd, 0.0], [-odd, 0.0, 0.0], [0.0; 3]];
            if mu == nu {
                *moment = [[third, 0.0, 0.0], [0.0, third, 0.0], [0.0, 0.0, third]];
            }
        }
    }
    Fields {
        mass: 3.0,
        first_moment: [0.1, 0.0, 0.2],
        second_moment: [[5.0, 0.0, 0.0], [0.0, 6.0, 0.0], [0.0, 0.0, 7.0]],
        position_mode_moment: [[[0.0, 0.1, 0.0], [0.2, 0.0, 0.0], [0.0, 0.0, 0.1]]; 9],
        mode_mode_moment: moments,
        stiffness: [100.0; 9],
    }
}

/// Whether a spinning, vibrating body keeps its energy over some steps of both integrators, and every kernel runs.
fn flies<const M: usize, const N: usize>(
    body: impl DenseForms<M, N> + Observables + Copy,
    step: f64,
    q: f64,
) -> bool {
    let mut flight = FreeBody::new(body)
        .with_spin(Vector3::new(0.5, 2.0, 0.1))
        .with_deformation(SVector::repeat(q), SVector::zeros());
    let energy = flight.kinetic_energy() + flight.elastic_energy();
    for _ in 0..20 {
        if flight.step_rk4(step, &()).is_err() {
            return false;
        }
    }
    let change = flight.kinetic_energy() + flight.elastic_energy() - energy;
    let (q, q_dot) = (flight.state.modal_coordinates, flight.state.modal_rates);
    let omega = flight.state.angular_velocity;
    let force = SVector::<f64, N>::repeat(1.0);
    let equations = body.equations_of_motion(&q, &omega, &q_dot, &force);
    let mut written = equations;
    body.write_equations_of_motion(
        &q,
        &omega,
        &q_dot,
        &force,
        &mut written.mass_matrix,
        &mut written.quadratic_velocity,
        &mut written.acceleration,
    );
    let resultant = GeneralisedForce::from_vector(&force);
    let alone = body.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>();
    let same = (alone - equations.acceleration).amax() <= 1e-9 * alone.amax()
        && (written.mass_matrix - body.mass_matrix(&q)).amax() <= 1e-12 * written.mass_matrix.amax();
    // Damping may take energy, nothing may give it.
    same && change < 1e-6 * energy
        && flight.step_linearly_implicit(step, &()).is_ok()
        && flight.state.is_finite()
}

/// Whether every form of generated code runs.
pub fn every_form_flies() -> bool {
    let markers = FewModes.marker("BIG_END").is_some() && FewModes.marker("nowhere").is_none();
    markers
        && flies::<2, 8>(FewModes, 1e-5, 1e-6)
        && flies::<8, 14>(EightModes, 1e-6, 1e-6)
        && flies::<8, 14>(Generic, 1e-6, 1e-6)
        && flies::<20, 26>(ManyModes, 1e-4, 1e-3)
        && flies::<9, 15>(DenseModalMass, 1e-4, 1e-3)
        && flies::<9, 15>(fields(), 1e-4, 1e-3)
        && jacobians_agree()
        && invariants_are_checked(core::hint::black_box(2.0))
}

/// M(q) from the residual's Jacobian.
fn jacobians_agree() -> bool {
    use ffrf::FlexibleBodyJacobians;
    let q = SVector::<f64, 2>::new(1e-6, -2e-6);
    let omega = Vector3::new(1.0, 2.0, 3.0);
    let zero = SVector::<f64, 8>::zeros();
    let residual = FewModes.residual_jacobian(&q, &omega, &q, &zero, &zero);
    let accelerations = FewModes.acceleration_jacobian(&q, &omega, &q, &zero);
    (residual.acceleration - FewModes.mass_matrix(&q)).amax() < 1e-12 && accelerations.force.amax() > 0.0
}
