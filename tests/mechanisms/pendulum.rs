//! A flexible body that hangs on a revolute joint.

use ffrf::mechanism::Mechanism;
use ffrf::{Drift, StepError, StepReport};

use crate::bodies::{BIG_END, Pendulum, WholeRod, energy};

/// Steps through a hundredth of a second; the largest drift and change of energy, and the fall of the tip
/// over that of a rigid rod.
fn swing(mut step: impl FnMut(&mut Mechanism<Pendulum>) -> StepReport) -> (Drift, f64, f64) {
    let model = Pendulum::new(WholeRod);
    let mut pendulum = model.in_motion(model.at_rest());
    let open = pendulum.assemble().unwrap();
    assert!((open.position + BIG_END).abs() < 1e-12, "the joint was open by its distance, found {open:?}");
    let start = energy(&WholeRod, &pendulum.state.rod, &model.gravity);
    let height = model.tip(&pendulum.state).y;
    let (mut drift, mut change) = (Drift::<f64>::none(), 0.0_f64);
    while pendulum.time < 0.01 {
        let found = step(&mut pendulum).drift;
        drift.position = drift.position.max(found.position);
        drift.velocity = drift.velocity.max(found.velocity);
        let now = energy(&WholeRod, &pendulum.state.rod, &model.gravity);
        change = change.max((now - start).abs());
    }
    (drift, change, (height - model.tip(&pendulum.state).y) / expected_fall(pendulum.time))
}

/// The fall of the end of a bar from rest, horizontal, after this time: ½ α L t² to third order.
fn expected_fall(time: f64) -> f64 {
    use ffrf::Observables;
    // mass times lever over the moment of inertia about the pin, from the rigid body
    let mass_matrix =
        ffrf::FlexibleBody::prepare(&WholeRod, &Default::default(), &Default::default(), &Default::default());
    let mass = <WholeRod as Observables>::mass(&WholeRod);
    let center = mass_matrix.first_moment.x / mass;
    let lever = center - BIG_END;
    let inertia = mass_matrix.inertia[(2, 2)] - mass * center * center + mass * lever * lever;
    let length = crate::bodies::SMALL_END - BIG_END;
    0.5 * 9.81 * mass * lever / inertia * length * time * time
}

#[test]
fn an_explicit_step_keeps_energy_and_joint() {
    let (drift, change, fall) = swing(|pendulum| pendulum.step_rk4(2e-6).unwrap());
    // steps of h ω = 0.1 and less for the modes: no error but rounding is left in the joint
    assert!(drift.position < 1e-12 && drift.velocity < 1e-9, "{drift:?}");
    assert!(change < 1e-9, "{change:.2e}");
    // the angle stays below 0.01 rad: relative 1e-4; modes add some 1e-6
    assert!((fall - 1.0).abs() < 1e-3, "{fall}");
}

#[test]
fn an_implicit_step_does_not_resolve_the_modes() {
    let (drift, change, fall) = swing(|pendulum| pendulum.step_linearly_implicit(1e-4).unwrap());
    assert!(drift.position < 1e-8 && drift.velocity < 1e-4, "{drift:?}");
    assert!(change < 1e-5, "{change:.2e}");
    assert!((fall - 1.0).abs() < 1e-2, "{fall}");
}

#[test]
fn sensors_agree_with_each_other() {
    let model = Pendulum::new(WholeRod);
    let mut pendulum = model.in_motion(model.at_rest());
    pendulum.assemble().unwrap();
    for _ in 0..200 {
        pendulum.step_linearly_implicit(1e-4).unwrap();
    }
    let (state, time) = (pendulum.state, pendulum.time);
    let turn = model.tilt(&state).angle();
    // the angle of the joint is that of the marker at the pin; modes turn both ends differently by some 1e-6
    assert!((model.swing(&state).abs() - turn).abs() < 1e-4, "{} {turn}", model.swing(&state));
    // a revolute joint does not hold the moment about its axis
    assert!(model.bending(time, &state).unwrap().z.abs() < 1e-9);
    // the joint carries what the weight does not: momentum balance of the body
    let step = 1e-6;
    let after = pendulum.step_rk4(step).map(|_| pendulum.state).unwrap();
    let momentum = |state: &crate::bodies::PendulumState| {
        ffrf::FreeBody::new(WholeRod).with_state(state.rod).linear_momentum()
    };
    let rate = (momentum(&after) - momentum(&state)) / step;
    let weight = model.gravity * <WholeRod as ffrf::Observables>::mass(&WholeRod);
    let load = model.load(time, &state).unwrap();
    assert!((rate - weight - load).norm() < 1e-3 * load.norm(), "{rate} {load}");
    let speed = (model.tip(&after) - model.tip(&state)) / step;
    assert!((speed - model.speed(&state)).norm() < 1e-3 * speed.norm());
    let shock = (model.speed(&after) - model.speed(&state)) / step;
    let found = model.shock(time, &state).unwrap();
    assert!((shock - found).norm() < 1e-2 * found.norm(), "{shock} {found}");
}

#[test]
fn an_absurd_deformation_is_told_with_the_body_and_its_size() {
    let model = Pendulum::new(WholeRod);
    let mut pendulum = model.in_motion(model.at_rest());
    pendulum.assemble().unwrap();
    // squares of it are beyond the number type
    pendulum.state.rod.modal_coordinates[0] = -1e200;
    let before = pendulum.state;
    let error = pendulum.step_rk4(1e-6).unwrap_err();
    assert_eq!(error, StepError::BodyNotPositive { body: 0, amplitude: 1e200 });
    assert!(
        error.to_string().contains("body 0 is not positive definite at modal coordinates of up to 1.000e200")
    );
    assert_eq!((Pendulum::BODIES, pendulum.state), (["rod"], before));
}
