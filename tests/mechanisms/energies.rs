//! Energy and momentum of compiled mechanisms: those of the scene, of each body alone, and what mechanics says of them.

use std::path::Path;

use ffrf::mechanism;
use ffrf::mechanism::{Assembly, Mechanism};
use ffrf::nalgebra::Vector3;
use ffrf_host::scene::Scene;

use crate::bodies::{BIG_END, Pendulum, Rod, SMALL_END, SliderCrank, SliderCrankState, WholeRod, energy};

/// Sums of numbers of one size, in another order and by other kernels: some hundred roundings.
const ROUND_OFF: f64 = 1e-13;
/// What the central difference over one step leaves.
const DIFFERENCE: f64 = 1e-6;

/// Within this share of the largest of both.
fn agree(found: f64, expected: f64, share: f64, what: &str) {
    let size = found.abs().max(expected.abs());
    assert!((found - expected).abs() <= share * size, "{what}: {found:e}, expected {expected:e}");
}

fn turning() -> Mechanism<SliderCrank> {
    let model = SliderCrank::new(Rod);
    let state = SliderCrankState::stretched(&model);
    let mut compiled = model.met_in(&state).in_motion(state);
    compiled.assemble().unwrap();
    for _ in 0..300 {
        compiled.step_rk4(2e-6).unwrap();
    }
    compiled
}

#[test]
fn the_energies_are_those_of_the_scene_and_of_the_bodies() {
    let compiled = turning();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes/slider_crank.toml");
    let scene = Scene::read(&path).unwrap();
    let mut states = scene.initial.clone();
    let numbers = compiled.state.to_array();
    let mut numbers = numbers.iter().copied();
    for state in &mut states {
        state.set_numbers(&mut numbers);
    }
    let (found, expected) = (compiled.energy(), scene.mechanism.energy(&states));
    agree(found.kinetic, expected.kinetic, ROUND_OFF, "kinetic energy");
    agree(found.elastic, expected.elastic, ROUND_OFF, "elastic energy");
    // the heights are small: their sum is of the size of its terms, which is that of the kinetic energy at most
    assert!((found.potential - expected.potential).abs() < ROUND_OFF, "{found:?} {expected:?}");
    assert!(found.kinetic > 1.0 && found.elastic > 0.0, "{found:?}");
    let (found, expected) = (compiled.momentum(), scene.mechanism.momentum(&states));
    assert!((found.linear - expected.linear).norm() < ROUND_OFF * found.linear.norm());
    assert!((found.angular - expected.angular).norm() < ROUND_OFF * found.angular.norm());
    // each body by its own kernel
    let Mechanism { model, state, .. } = &compiled;
    let bodies = energy(&model.crank, &state.crank, &model.gravity)
        + energy(&model.rod, &state.rod, &model.gravity)
        + energy(&model.piston, &state.piston, &model.gravity);
    agree(compiled.energy().total(), bodies, ROUND_OFF, "sum over bodies");
}

#[test]
fn momentum_is_mass_times_the_velocity_of_its_center() {
    let mut compiled = turning();
    let step = 1e-7;
    // the potential energy in a field of one unit is less the first moment of mass
    let moment = |mechanism: &Mechanism<SliderCrank>| {
        [Vector3::x(), Vector3::y(), Vector3::z()].map(|gravity| {
            let mut model = mechanism.model;
            model.gravity = gravity;
            -model.energy(&mechanism.state).potential
        })
    };
    let before = Vector3::from(moment(&compiled));
    compiled.step_rk4(step).unwrap();
    let momentum = compiled.momentum().linear;
    compiled.step_rk4(step).unwrap();
    let rate = (Vector3::from(moment(&compiled)) - before) / (2.0 * step);
    assert!((rate - momentum).norm() < DIFFERENCE * momentum.norm(), "{rate} {momentum}");
}

mechanism! {
    /// The pendulum with a spring that pulls at its tip.
    pub struct Pulled {
        bodies: { rod: WholeRod },
        gravity: [0.0, -9.81, 0.0],
        joints: { pin: revolute(ground, rod.BIG_END, axis: z) },
        forces: {
            spring: spring(ground.at([0.1, 0.05, 0.0]), rod.SMALL_END, stiffness: 2e3, damping: 0.0, rest_length: 0.05),
        },
    }
}

#[test]
fn energy_is_kept_in_what_bodies_and_springs_store() {
    let model = Pulled::new(WholeRod);
    let mut pulled = model.in_motion(model.at_rest());
    pulled.assemble().unwrap();
    let start = pulled.energy();
    let mut moved = 0.0_f64;
    for _ in 0..2000 {
        pulled.step_rk4(2e-6).unwrap();
        let now = pulled.energy();
        moved = moved.max((now.potential - start.potential).abs());
        let change = (now.total() - start.total()).abs();
        assert!(change < 1e-9, "{change:e} after {} s: {start:?} {now:?}", pulled.time);
    }
    // much of what the spring held has become motion
    assert!(moved > 1e-2, "{moved:e}");
}

#[test]
fn the_angular_momentum_of_a_pendulum_changes_by_its_weight() {
    let model = Pendulum::new(WholeRod);
    let mut pendulum = model.in_motion(model.at_rest());
    pendulum.assemble().unwrap();
    assert_eq!(pendulum.momentum().angular, Vector3::zeros());
    let step = 2e-6;
    let pin = Vector3::new(pendulum.state.rod.position.x + BIG_END, 0.0, 0.0);
    let about_pin = |pendulum: &Mechanism<Pendulum>| {
        let momentum = pendulum.momentum();
        momentum.angular.z - pin.cross(&momentum.linear).z
    };
    for _ in 0..100 {
        pendulum.step_rk4(step).unwrap();
    }
    let before = about_pin(&pendulum);
    pendulum.step_rk4(step).unwrap();
    let mut field = pendulum.model;
    field.gravity = Vector3::x();
    let mass = <WholeRod as ffrf::Observables>::mass(&WholeRod);
    let lever = -field.energy(&pendulum.state).potential - mass * pin.x;
    pendulum.step_rk4(step).unwrap();
    let torque = (about_pin(&pendulum) - before) / (2.0 * step);
    agree(torque, -9.81 * lever, DIFFERENCE, "moment about the pin");
    assert!(lever > 0.1 * mass * (SMALL_END - BIG_END));
}
