//! The terms that the paper drops from (199), (201) and (215), and what a body does without them.
//!
//! `cargo test -p ffrf-fe --test equations dropped -- --nocapture` prints the figures of `docs/theory/errata.md`.

use faer::Mat;
use faer::linalg::solvers::Solve;
use ffrf_fe::formulations::gcms::apply_mass;
use ffrf_fe::formulations::rotation::{cross, dot};

use crate::bodies::{Body, State, each_state};
use crate::check::{as_vector, column};
use crate::nodal;

const GRAVITY: [f64; 3] = [0.0, 0.0, -9.81];

/// Spurious angular acceleration times body size over g, in free fall from rest in a deformed state.
fn free_fall(body: &Body, state: &State, deformed_lever: bool) -> f64 {
    let modes = body.mode_count();
    let weight =
        apply_mass(&body.mass, Mat::from_fn(body.phi_t().nrows(), 1, |row, _| GRAVITY[row % 3]).as_ref());
    let mut forces = nodal::jacobian(body, state).transpose() * &weight;
    if !deformed_lever {
        let mut moment = [0.0; 3];
        for (node, x) in body.positions.iter().enumerate() {
            let force = [0, 1, 2].map(|i| weight[(3 * node + i, 0)]);
            let turned = cross(as_vector(&(&state.a * column(x))), force);
            for i in 0..3 {
                moment[i] += turned[i];
            }
        }
        for i in 0..3 {
            forces[(3 + i, 0)] = moment[i];
        }
    }
    let w = nodal::mass_matrix(body, state).partial_piv_lu().solve(&forces);
    let size = body.positions.iter().flatten().fold(0.0, |m: f64, x| m.max(x.abs()));
    let spin = (3..6).map(|i| w[(i, 0)] * w[(i, 0)]).sum::<f64>().sqrt();
    assert_eq!(w.nrows(), 6 + modes);
    spin * size / 9.81
}

/// Power of a joint at a node over |λ| |ω × A c|, for a motion that the joint allows; 1 direction of λ, the worst.
fn joint_power(body: &Body, state: &State, with_p_fr: bool) -> f64 {
    let node = body.positions.len() - 1;
    let omega = as_vector(&state.omega);
    let lever = as_vector(&nodal::lever(body, state, node));
    let relative = as_vector(&nodal::relative_velocity(body, state, node));
    let turned = cross(omega, lever);
    // The joint holds the node: ṗ = - ω × A c - A Ψ_n q̇.
    let origin = [0, 1, 2].map(|i| -turned[i] - relative[i]);
    let arm = if with_p_fr { lever } else { as_vector(&(&state.a * column(&body.positions[node]))) };
    let by_jacobian = cross(omega, arm);
    let power = [0, 1, 2].map(|i| origin[i] + by_jacobian[i] + relative[i]);
    (dot(power, power) / dot(turned, turned)).sqrt()
}

fn worst(measure: impl Fn(&Body, &State) -> f64) -> f64 {
    let mut worst = 0.0_f64;
    each_state(|body, state| {
        if body.name.starts_with("random") {
            worst = worst.max(measure(body, state));
        }
    });
    worst
}

#[test]
fn dropped_lever_arms_turn_a_falling_body_and_let_a_joint_do_work() {
    let fall = [true, false].map(|deformed| worst(|body, state| free_fall(body, state, deformed)));
    println!("free fall: spurious spin {:.1e}, with (201) as printed {:.2}", fall[0], fall[1]);
    assert!(fall[0] < 1e-12 && fall[1] > 1e-2);
    let joint = [true, false].map(|complete| worst(|body, state| joint_power(body, state, complete)));
    println!("joint: power {:.1e}, with (215) as printed {:.2}", joint[0], joint[1]);
    assert!(joint[0] < 1e-13 && joint[1] > 1e-2);
}
