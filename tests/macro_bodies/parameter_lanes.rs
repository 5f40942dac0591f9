//! Bodies of many modes whose invariants come at run time: loops over lanes that read the fields.

#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{FlexibleBody, GeneralisedForce, flexible_body};
use ffrf_codegen::{Fidelity, GenerateOptions, Kernels};
use ffrf_model::ReducedBody;
use ffrf_test_kit::random_body::{Modes, random_body};
use ffrf_test_kit::{filled, witness};

flexible_body! {
    /// Everything dense but Θ_ff; stiffness and damping are taken from the force before the loops.
    pub struct General { modes: 9, layout: { modal_mass: identity } }
}

flexible_body! {
    pub struct FreeFree {
        modes: 16,
        layout: {
            first_moment: zero,
            modal_first_moment: zero,
            position_mode_moment: symmetric,
            modal_mass: identity,
            stiffness: diagonal,
            damping: diagonal,
        },
    }
}

flexible_body! {
    /// Θ_ff from the traces, without the terms of second order.
    pub struct Linear {
        modes: 7,
        layout: { modal_mass: diagonal, stiffness: diagonal, damping: zero },
        fidelity: linear,
    }
}

flexible_body! {
    /// One group with padding, on request.
    pub struct Few { modes: 3, layout: { modal_mass: identity }, strategy: lanes }
}

flexible_body! {
    pub struct Single { modes: 9, layout: { modal_mass: identity }, scalar: f32 }
}

flexible_body! {
    pub struct Generic { modes: 9, layout: { modal_mass: identity }, scalar: generic }
}

flexible_body! {
    /// Moments that are diagonal each, and no modes' moments with the positions.
    pub struct Special {
        modes: 8,
        layout: {
            second_moment: diagonal,
            position_mode_moment: zero,
            mode_mode_moment: diagonal,
            modal_mass: diagonal,
            stiffness: identity,
            damping: zero,
        },
    }
}

fn kernels(body: &ReducedBody, fidelity: Fidelity) -> Kernels {
    Kernels::formulate(body, &GenerateOptions { fidelity, ..GenerateOptions::default() }).unwrap()
}

#[test]
fn a_general_body_agrees_with_the_naive_form_and_the_interpreter() {
    let body = random_body(21, 9, Modes::Normalised);
    witness::check::<9, 15, _>(&filled!(General, body, f64), &body, &kernels(&body, Fidelity::Full), true);
    let body = random_body(22, 3, Modes::Normalised);
    witness::check::<3, 9, _>(&filled!(Few, body, f64), &body, &kernels(&body, Fidelity::Full), true);
}

#[test]
fn a_generic_body_and_one_in_single_precision_do_the_same() {
    let body = random_body(21, 9, Modes::Normalised);
    let full = kernels(&body, Fidelity::Full);
    witness::check::<9, 15, _>(&filled!(Generic, body, f64), &body, &full, true);
    witness::check_single::<9, 15, _>(&filled!(Single, body, f32), &full);
}

/// The body with a diagonal stiffness and damping.
fn with_diagonals(mut body: ReducedBody) -> ReducedBody {
    for (mu, row) in body.stiffness.iter_mut().enumerate() {
        row.iter_mut().enumerate().for_each(|(nu, k)| *k = if mu == nu { 40.0 + mu as f64 } else { 0.0 });
    }
    body.damping.clone_from(&body.stiffness);
    body
}

#[test]
fn a_free_free_body_agrees() {
    let body = with_diagonals(random_body(23, 16, Modes::FreeFree));
    let given = witness::invariants::<16>(&body);
    let free = FreeFree {
        mass: given.mass,
        second_moment: given.euler_tensor,
        position_mode_moment: given.modal_euler_tensor,
        mode_mode_moment: given.modal_pair_euler_tensor,
        stiffness: std::array::from_fn(|mu| given.stiffness[mu][mu]),
        damping: std::array::from_fn(|mu| given.damping[mu][mu]),
    };
    witness::check::<16, 22, _>(&free, &body, &kernels(&body, Fidelity::Full), true);
}

#[test]
fn a_truncated_energy_is_that_of_the_interpreter() {
    let mut body = with_diagonals(random_body(24, 7, Modes::Normalised));
    body.damping = vec![vec![0.0; 7]; 7];
    let given = witness::invariants::<7>(&body);
    let linear = Linear {
        mass: given.mass,
        first_moment: body.inertia.first_moment,
        modal_first_moment: std::array::from_fn(|mu| body.inertia.modal_first_moment[mu]),
        second_moment: given.euler_tensor,
        position_mode_moment: given.modal_euler_tensor,
        mode_mode_moment: given.modal_pair_euler_tensor,
        stiffness: std::array::from_fn(|mu| given.stiffness[mu][mu]),
    };
    witness::check::<7, 13, _>(&linear, &body, &kernels(&body, Fidelity::Linear), false);
}

/// Invariants made up to fit a layout; the model is the same body written out.
#[test]
fn diagonal_moments_agree_with_the_same_moments_written_out() {
    let mut body = random_body(25, 8, Modes::Normalised);
    // Small first moments: with moments that are diagonal, large ones would belong to no body.
    body.inertia.first_moment = body.inertia.first_moment.map(|x| 0.05 * x);
    body.inertia.modal_first_moment.iter_mut().flatten().for_each(|x| *x *= 0.05);
    body.stiffness = (0..8).map(|mu| (0..8).map(|nu| f64::from(u8::from(mu == nu))).collect()).collect();
    body.damping = vec![vec![0.0; 8]; 8];
    let diagonal = |entries: [f64; 3]| {
        let mut matrix = [[0.0; 3]; 3];
        (0..3).for_each(|i| matrix[i][i] = entries[i]);
        matrix
    };
    let second = [3.0, 4.0, 5.0];
    let moment = |mu: usize, nu: usize| match mu == nu {
        true => [0.5 + 0.01 * mu as f64, 0.25, 0.25],
        // Without a trace: Θ_ff is diagonal.
        false => [0.02, -0.03 + 0.001 * (mu + nu) as f64, 0.01 - 0.001 * (mu + nu) as f64],
    };
    body.inertia.second_moment = diagonal(second);
    body.inertia.position_mode_moment = vec![[[0.0; 3]; 3]; 8];
    body.inertia.mode_mode_moment =
        (0..8).map(|mu| (0..8).map(|nu| diagonal(moment(mu, nu))).collect()).collect();
    let special = Special {
        mass: body.inertia.mass,
        first_moment: body.inertia.first_moment,
        modal_first_moment: std::array::from_fn(|mu| body.inertia.modal_first_moment[mu]),
        second_moment: second,
        mode_mode_moment: std::array::from_fn(|mu| std::array::from_fn(|nu| moment(mu, nu))),
    };
    witness::check::<8, 14, _>(&special, &body, &kernels(&body, Fidelity::Full), true);
}

#[test]
fn a_body_at_rest_without_forces_stays_at_rest() {
    let body = random_body(21, 9, Modes::Normalised);
    let general = filled!(General, body, f64);
    let zero = SVector::<f64, 9>::zeros();
    let rest = general.forward_dynamics(&zero, &Vector3::zeros(), &zero, &GeneralisedForce::zeros(&zero));
    assert_eq!(rest.to_vector::<15>().amax(), 0.0);
}
