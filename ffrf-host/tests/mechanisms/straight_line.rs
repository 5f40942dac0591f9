//! Straight-line code of whole scenes: the operations that were written down give the bits of the equations that they were
//! written down from, in other states and with other drives.

use std::path::Path;

use ffrf_codegen::ArrayFunction;
use ffrf_codegen::expression::Symbol;
use ffrf_host::HostModal;
use ffrf_host::mechanism::HostIncrement;
use ffrf_host::scene::Scene;
use ffrf_host::straight_line::{
    Motions, StraightLineError, accelerations, implicit_accelerations, implicit_projection, projection,
};
use ffrf_runtime::integrators::Correction;
use ffrf_runtime::mechanism::{Assembly, Constrained, EvaluatedJoint};
use ffrf_runtime::rotation::cayley_omega;
use ffrf_runtime::{ImplicitSystem, Increment, State, StepError, StiffSystem, System, VectorSpace};
use ffrf_test_kit::random::Random;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

fn scene(name: &str) -> Scene {
    scene_in("models/scenes", name)
}

fn scene_in(folder: &str, name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("..").join(folder);
    Scene::read(&folder.join(format!("{name}.toml"))).unwrap()
}

/// States near the initial one, farther than those that the equations were traced in, and their numbers in one array.
fn near(scene: &Scene, random: &mut Random) -> (Vec<State<HostModal>>, Vec<f64>) {
    near_in(scene, &Motions::all(scene), random)
}

/// The same where what does not move is zero.
fn near_in(scene: &Scene, motions: &Motions, random: &mut Random) -> (Vec<State<HostModal>>, Vec<f64>) {
    let still: Vec<usize> = motions.still().collect();
    let mut numbers = Vec::new();
    let states = scene
        .initial
        .iter()
        .map(|state| {
            let mut off = |near: f64| {
                let number = near + 3e-2 * random.number();
                let number = if still.contains(&numbers.len()) { 0.0 } else { number };
                numbers.push(number);
                number
            };
            let mut vector = |near: Vector3<f64>| near.map(&mut off);
            let position = vector(state.position);
            let turned = state.orientation.coords.map(&mut off);
            let modal_coordinates = HostModal(state.modal_coordinates.0.map(|near| off(1e-3 * near)));
            let mut vector = |near: Vector3<f64>| near.map(&mut off);
            let (velocity, angular_velocity) = (vector(state.velocity), vector(state.angular_velocity));
            State {
                position,
                orientation: UnitQuaternion::new_unchecked(Quaternion::from(turned)),
                modal_coordinates,
                velocity,
                angular_velocity,
                modal_rates: HostModal(state.modal_rates.0.map(&mut off)),
            }
        })
        .collect();
    (states, numbers)
}

/// Value, rate and acceleration of each connection that has a drive, zeros of the others.
fn drive_values(scene: &Scene, random: &mut Random) -> Vec<[f64; 3]> {
    let drives = scene.mechanism.drives().iter();
    drives.map(|drive| if drive.is_some() { [0, 1, 2].map(|_| random.number()) } else { [0.0; 3] }).collect()
}

/// Results and whether the conditions hold, by interpreting the operations.
fn interpreted(function: &ArrayFunction, state: &[f64], drives: &[f64]) -> (Vec<f64>, bool) {
    interpreted_stage(function, state, &[], f64::NAN, drives)
}

/// The same for a linearly implicit stage.
fn interpreted_stage(
    function: &ArrayFunction,
    state: &[f64],
    subtracted: &[f64],
    gamma_h: f64,
    drives: &[f64],
) -> (Vec<f64>, bool) {
    function.interpret(|symbol| match symbol {
        Symbol::Intermediate("state", index) => state[index],
        Symbol::Intermediate("subtracted", index) => subtracted[index],
        Symbol::Intermediate("gamma_h", 0) => gamma_h,
        Symbol::Intermediate("drive", index) => drives[index],
        other => panic!("{other} is no input"),
    })
}

/// Compares so many states in which the conditions hold; gives how many there were.
fn compare(name: &str, scene: &Scene, motions: &Motions, function: &ArrayFunction) -> usize {
    let mut random = Random::new(7);
    let mut seen = 0;
    for case in 0..12 {
        let (states, numbers) = near_in(scene, motions, &mut random);
        let values = drive_values(scene, &mut random);
        let array: Vec<f64> = values.iter().flatten().copied().collect();
        let mechanism = scene.mechanism.cast::<f64>().with_drive_values(values);
        let system = Constrained(&mechanism);
        let rates = system.rates(0.0, &states, &system.no_change(&states)).unwrap();
        let expected = rates.0.iter().flat_map(|body| {
            body.velocity.iter().chain(&body.angular_velocity).chain(&body.modal_rates.0).copied()
        });
        let (found, holds) = interpreted(function, &numbers, &array);
        if !holds {
            continue;
        }
        seen += 1;
        for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
            // zeros of either sign are equal
            assert!(found == &expected, "{name}, case {case}, {index}: {found:e} and {expected:e}");
        }
    }
    seen
}

#[test]
fn straight_line_code_has_the_bits_of_the_equations() {
    // trees that are swept over, loops, redundant rows, drives, springs, modes
    for name in [
        "double_pendulum",
        "flexible_pendulum",
        "slider_crank",
        "four_bar",
        "bricard",
        "rotor",
        "tumbling_rod",
    ] {
        let scene = scene(name);
        let motions = Motions::all(&scene);
        let function = accelerations(&scene, &motions, "accelerations")
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        let seen = compare(name, &scene, &motions, &function);
        assert!(seen > 3, "{name}: the conditions held in {seen} of 12 states");
    }
}

/// What leaves the plane of a planar mechanism, and modes that nothing excites, need no code: where it is zero, the rest has the
/// bits of the equations.
#[test]
fn what_never_moves_is_left_out() {
    for (name, still, share) in [
        // of two links in space: place across, two of the orientation, and the velocities of these
        ("double_pendulum", 12, 0.5),
        ("four_bar", 18, 0.7),
        // its rod is no symmetric body: it bends and turns out of the plane
        ("slider_crank", 14, 0.9),
        // a rotor bends in every direction, and so does a body that tumbles
        ("tumbling_rod", 0, 1.0),
    ] {
        let scene = scene(name);
        let [all, motions] = [Motions::all(&scene), Motions::of(&scene).unwrap()];
        assert!(motions.still().count() >= still, "{name}: {:?}", motions.still().collect::<Vec<_>>());
        let [general, own] =
            [&all, &motions].map(|motions| accelerations(&scene, motions, "accelerations").unwrap());
        let [operations, least] = [&own, &general].map(|function| function.graph.len() as f64);
        assert!(operations <= share * least, "{name}: {operations} nodes of {least}");
        assert!(compare(name, &scene, &motions, &own) > 3, "{name}");
        // round-off out of the plane is no motion, more is one
        let (_, mut numbers) = near_in(&scene, &motions, &mut Random::new(7));
        let drives = vec![0.0; own.inputs[1].count];
        let held = interpreted(&own, &numbers, &drives).1;
        for (off, holds) in [(1e-14, held), (1e-12, false)] {
            for place in motions.still() {
                numbers[place] = off;
                assert_eq!(interpreted(&own, &numbers, &drives).1, holds, "{name}: {place}, {off:e}");
                numbers[place] = 0.0;
            }
        }
    }
}

/// A change of the states, or a rate of one, with random numbers of this size.
fn change(states: &[State<HostModal>], size: f64, random: &mut Random) -> HostIncrement {
    let bodies = states.iter().map(|state| {
        let mut change = Increment::zeros(&state.modal_coordinates);
        let mut number = || size * random.number();
        change.position.apply(|place| *place = number());
        change.rotation.apply(|place| *place = number());
        change.modal_coordinates.0.apply(|place| *place = 1e-3 * number());
        change.velocity.apply(|place| *place = number());
        change.angular_velocity.apply(|place| *place = number());
        change.modal_rates.0.apply(|place| *place = number());
        change
    });
    HostIncrement(bodies.collect())
}

fn numbers_of(states: &[State<HostModal>]) -> Vec<f64> {
    let bodies = states.iter().map(|state| {
        let parts = [
            state.position.as_slice(),
            state.orientation.coords.as_slice(),
            state.modal_coordinates.0.as_slice(),
            state.velocity.as_slice(),
            state.angular_velocity.as_slice(),
            state.modal_rates.0.as_slice(),
        ];
        parts.concat()
    });
    bodies.collect::<Vec<_>>().concat()
}

/// What is subtracted, as the function takes it: with rotations about the state that `increment` has led to.
fn about_the_state(subtracted: &HostIncrement, increment: &HostIncrement) -> Vec<f64> {
    let bodies = subtracted.0.iter().zip(&increment.0).map(|(subtracted, increment)| {
        [
            subtracted.position.as_slice(),
            cayley_omega(&increment.rotation, &subtracted.rotation).as_slice(),
            subtracted.modal_coordinates.0.as_slice(),
            subtracted.velocity.as_slice(),
            subtracted.angular_velocity.as_slice(),
            subtracted.modal_rates.0.as_slice(),
        ]
        .concat()
    });
    bodies.collect::<Vec<_>>().concat()
}

/// Compares linearly implicit stages of such states, without and with something subtracted, and corrections of implicit methods;
/// gives in how many of twelve the conditions held.
fn compare_stages(name: &str, scene: &Scene, function: &ArrayFunction) -> usize {
    let mut random = Random::new(11);
    let mut seen = 0;
    for case in 0..12 {
        let (origin, _) = near(scene, &mut random);
        let increment = change(&origin, 1e-2, &mut random);
        // of no step size that the equations were traced with
        let gamma_h = 2e-4 * (1.5 + random.number());
        let subtracted = change(&origin, 1.0, &mut random);
        let values = drive_values(scene, &mut random);
        let array = values.concat();
        let mechanism = scene.mechanism.cast::<f64>().with_drive_values(values);
        let system = Constrained(&mechanism);
        let state = system.retract(&origin, &increment);
        let numbers = numbers_of(&state);
        let none = vec![0.0; function.inputs[1].count];
        // what a correction subtracts: the rates of the places beside the accelerations
        let mut elastic = system.place_rates(&origin, &increment);
        elastic.add_scaled(1.0, &system.velocities_only(&subtracted));
        let rates = |subtracted| system.implicit_rates(0.0, &origin, &increment, gamma_h, subtracted);
        let correction = || -> Result<HostIncrement, StepError> {
            let accelerations = system.velocities_only(&subtracted);
            let Correction { accelerations, .. } =
                system.correction(0.0, &origin, &increment, &accelerations, gamma_h)?;
            Ok(accelerations)
        };
        let stages = [
            ("alone", rates(None), none),
            ("less", rates(Some(&subtracted)), about_the_state(&subtracted, &increment)),
            ("correction", correction(), about_the_state(&elastic, &increment)),
        ];
        let mut held = true;
        for (what, expected, subtracted) in stages {
            let expected = expected.unwrap();
            let expected = expected.0.iter().flat_map(|body| {
                body.velocity.iter().chain(&body.angular_velocity).chain(&body.modal_rates.0).copied()
            });
            let (found, holds) = interpreted_stage(function, &numbers, &subtracted, gamma_h, &array);
            held &= holds;
            if !holds {
                continue;
            }
            for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
                assert!(
                    found == &expected,
                    "{name}, case {case}, {what}, {index}: {found:e} and {expected:e}"
                );
            }
        }
        seen += usize::from(held);
    }
    seen
}

#[test]
fn straight_line_stages_have_the_bits_of_the_equations() {
    // soft rows alone, beside joints and on modes; trees that are swept over, loops, redundant rows, drives
    for (name, soft, least) in [
        ("rotor", true, 4),
        // a spring draws back across its line where it is stretched, and nowhere else: each has two branches
        ("governor", true, 2),
        ("tumbling_rod", false, 4),
        ("double_pendulum", false, 4),
        ("flexible_pendulum", false, 4),
        ("slider_crank", false, 4),
        ("four_bar", false, 4),
    ] {
        let scene = scene(name);
        assert_eq!(scene.mechanism.soft(0).is_some(), soft, "{name}");
        let function = implicit_accelerations(&scene, &Motions::all(&scene), "accelerations")
            .unwrap_or_else(|error| panic!("{name}: {error}"));
        let seen = compare_stages(name, &scene, &function);
        assert!(seen >= least, "{name}: the conditions held in {seen} of 12 states");
    }
}

#[test]
fn a_flexible_body_on_soft_supports_has_the_bits_of_the_equations() {
    let scene = scene_in("benches/mechanisms/scenes", "supported_rod");
    let function = implicit_accelerations(&scene, &Motions::all(&scene), "accelerations").unwrap();
    let seen = compare_stages("supported_rod", &scene, &function);
    assert!(seen > 3, "the conditions held in {seen} of 12 states");
}

#[test]
fn straight_line_projections_have_the_bits_of_the_equations() {
    for name in ["double_pendulum", "flexible_pendulum", "slider_crank", "four_bar", "bricard"] {
        let scene = scene(name);
        let motions = Motions::all(&scene);
        let functions = [projection, implicit_projection]
            .map(|function| function(&scene, &motions, "projection").unwrap().unwrap());
        for (function, gamma_h) in functions.iter().zip([None, Some(3e-4)]) {
            let mut random = Random::new(13);
            let mut seen = 0;
            for case in 0..12 {
                let (states, numbers) = near(&scene, &mut random);
                let values = drive_values(&scene, &mut random);
                let array = values.concat();
                let mechanism = scene.mechanism.cast::<f64>().with_drive_values(values);
                let mut residuals = Vec::new();
                let look = |joints: &[Option<EvaluatedJoint>]| {
                    for level in [0, 1] {
                        let rows = joints.iter().flatten().flat_map(EvaluatedJoint::residuals);
                        residuals.extend(rows.map(|residuals| residuals[level]));
                    }
                };
                let projected =
                    Constrained(&mechanism).correct_once(0.0, states.clone(), gamma_h, look).unwrap();
                let (found, holds) =
                    interpreted_stage(function, &numbers, &[], gamma_h.unwrap_or(f64::NAN), &array);
                if !holds {
                    continue;
                }
                seen += 1;
                let expected = numbers_of(&projected).into_iter().chain(residuals);
                for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
                    assert!(found == &expected, "{name}, case {case}, {index}: {found:e} and {expected:e}");
                }
                // and it is what `project` begins with
                let [count, rows] = [numbers.len(), (found.len() - numbers.len()) / 4];
                let largest = |rows: &[f64]| rows.iter().fold(0.0_f64, |most, row| most.max(row.abs()));
                let (_, drift) = Constrained(&mechanism).project(0.0, states, gamma_h, 1, f64::MAX).unwrap();
                // sums of another order
                for (found, expected) in [
                    (largest(&found[count..count + rows]), drift.position),
                    (largest(&found[count + rows..count + 2 * rows]), drift.velocity),
                ] {
                    assert!((found - expected).abs() <= 1e-13 * expected, "{name}: {found:e} {expected:e}");
                }
            }
            assert!(seen > 3, "{name}: the conditions held in {seen} of 12 states");
        }
    }
    let free = scene("tumbling_rod");
    assert!(projection(&free, &Motions::all(&free), "projection").unwrap().is_none(), "no joints");
}

#[test]
fn other_branches_are_noticed() {
    let scene = scene("slider_crank");
    let function = accelerations(&scene, &Motions::all(&scene), "accelerations").unwrap();
    let mut random = Random::new(7);
    let (_, mut numbers) = near(&scene, &mut random);
    let drives = vec![0.0; function.inputs[1].count];
    assert!(interpreted(&function, &numbers, &drives).1);
    // a modal coordinate of the rod, the second body
    numbers[13 + 7] = f64::NAN;
    assert!(!interpreted(&function, &numbers, &drives).1);
}

#[test]
fn what_code_cannot_know_is_refused() {
    let error = |name: &str| {
        let scene = scene(name);
        let error = accelerations(&scene, &Motions::all(&scene), "accelerations").unwrap_err();
        // and there is nothing to follow
        assert_eq!(Motions::of(&scene).unwrap_err().to_string(), error.to_string());
        error
    };
    let motor = error("flexible_rotor");
    assert!(matches!(motor, StraightLineError::Unknown { .. }), "{motor}");
    assert!(motor.to_string().starts_with("forces.motor"), "{motor}");
    let torsion = error("crane");
    assert!(matches!(torsion, StraightLineError::Functions { .. }), "{torsion}");
    assert!(torsion.to_string().contains("atan2"), "{torsion}");
}
