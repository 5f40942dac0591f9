//! What the energy-momentum method keeps.

use ffrf_host::{HostMechanism, HostModal};
use ffrf_runtime::mechanism::{Constrained, Treatment};
use ffrf_runtime::{EnergyMomentum, Observables, State};

use super::problem::double_pendulum;

fn energy(mechanism: &HostMechanism, states: &[State<HostModal>]) -> f64 {
    let bodies = mechanism.bodies().iter().zip(states);
    bodies
        .map(|(body, state)| {
            let q = &state.modal_coordinates;
            let moment = state.position * body.mass() + state.to_inertial(&body.first_mass_moment(q));
            body.kinetic_energy(q, &state.body_velocity(), &state.angular_velocity, &state.modal_rates)
                + body.elastic_energy(q)
                - mechanism.gravity().dot(&moment)
        })
        .sum()
}

/// Relative change of energy that is allowed: a random walk of some 1e-15 per step.
const KEPT: f64 = 1e-12;

/// Steps of a millisecond; `FFRF_CONSERVATION_STEPS` asks for more than a test should take.
fn steps() -> usize {
    std::env::var("FFRF_CONSERVATION_STEPS").map_or(4_000, |steps| steps.parse().unwrap())
}

#[test]
fn energy_of_a_flexible_double_pendulum_is_kept() {
    let (mechanism, mut state) = double_pendulum(Treatment::Index3, false);
    let system = Constrained(&mechanism);
    let method = EnergyMomentum::new();
    let start = energy(&mechanism, &state);
    let (mut worst, mut most, mut drift) = (0.0_f64, 0, 0.0_f64);
    // least squares of the change over the number of the step
    let (mut moments, steps) = ([0.0; 2], steps());
    for k in 0..steps {
        let (next, report) = method.step(&system, &state, k as f64 * 1e-3, 1e-3).unwrap();
        state = next;
        let change = (energy(&mechanism, &state) - start) / start;
        let place = k as f64 / steps as f64 - 0.5;
        moments = [moments[0] + place * change, moments[1] + place * place];
        worst = worst.max(change.abs());
        most = most.max(report.iterations);
        drift = drift.max(report.drift.position);
        if k % (steps / 20) == 0 {
            eprintln!("step {k}: energy {change:.2e}, iterations {}", report.iterations);
        }
    }
    let trend = moments[0] / moments[1];
    eprintln!(
        "{steps} steps: energy {worst:.2e}, trend {trend:.2e} over all, drift {drift:.2e} m, iterations {most}"
    );
    assert!(worst < KEPT, "{worst:e}");
    assert!(drift < 1e-13, "{drift:e}");
    assert!(most <= 10, "{most}");
    // and the pendulum did move: its energy is not all potential
    assert!(state[0].angular_velocity.norm() > 0.1);
}
