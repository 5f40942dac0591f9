//! A flexible body that hangs on a revolute joint.

use ffrf::nalgebra::Vector3;
use ffrf::{Observables, flexible_body, mechanism};

flexible_body! {
    /// A body with four modes.
    pub struct Beam { model: "tests/models/random_m4.ffrf.json" }
}

mechanism! {
    /// A flexible pendulum.
    pub struct Pendulum {
        bodies: { beam: Beam },
        gravity: [0.0, 0.0, -9.81],
        joints: { pin: revolute(ground, beam.ROOT, axis: y) },
        sensors: { tip: position(beam.TIP), load: reaction_force(pin) },
    }
}

fn energy(pendulum: &Pendulum, state: &PendulumState) -> f64 {
    let (body, state) = (&pendulum.beam, &state.beam);
    let q = &state.modal_coordinates;
    let moment: Vector3<f64> =
        state.position * <Beam as Observables>::mass(body) + state.to_inertial(&body.first_mass_moment(q));
    body.kinetic_energy(q, &state.body_velocity(), &state.angular_velocity, &state.modal_rates)
        + body.elastic_energy(q)
        - pendulum.gravity.dot(&moment)
}

/// Steps for a tenth of a second and gives the largest drift and change of energy.
fn swing(step: impl Fn(&mut ffrf::mechanism::Mechanism<Pendulum>) -> ffrf::Drift) -> (f64, f64) {
    let model = Pendulum::new(Beam);
    let mut pendulum = model.in_motion(model.at_rest());
    let open = pendulum.assemble().unwrap();
    assert!(open.position > 0.1, "the joint is open at first, found {open:?}");
    let start = energy(&model, &pendulum.state);
    let (mut drift, mut change) = (0.0_f64, 0.0_f64);
    for _ in 0..1000 {
        drift = drift.max(step(&mut pendulum).position);
        change = change.max((energy(&model, &pendulum.state) - start).abs());
    }
    assert!((pendulum.state.beam.position - model.at_rest().beam.position).norm() > 1e-3);
    (drift, change)
}

#[test]
fn it_swings_with_its_energy() {
    let (drift, change) = swing(|pendulum| pendulum.step_rk4(1e-4).unwrap().drift);
    println!("rk4: drift {drift:.2e}, energy {change:.2e}");
    let (implicit_drift, implicit_change) =
        swing(|pendulum| pendulum.step_linearly_implicit(1e-4).unwrap().drift);
    println!("ros2: drift {implicit_drift:.2e}, energy {implicit_change:.2e}");
    assert!(drift < 1e-9 && change < 1e-6);
    assert!(implicit_drift < 1e-6 && implicit_change < 1e-2);
}
