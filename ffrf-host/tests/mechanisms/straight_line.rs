//! Straight-line code of whole scenes: the operations that were written down give the bits of the equations that they were
//! written down from, in other states and with other drives.

use std::path::Path;

use ffrf_codegen::ArrayFunction;
use ffrf_codegen::expression::Symbol;
use ffrf_host::HostModal;
use ffrf_host::scene::Scene;
use ffrf_host::straight_line::{StraightLineError, accelerations};
use ffrf_runtime::mechanism::Constrained;
use ffrf_runtime::{State, System};
use ffrf_test_kit::random::Random;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

fn scene(name: &str) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    Scene::read(&folder.join(format!("{name}.toml"))).unwrap()
}

/// States near the initial one, farther than those that the equations were traced in, and their numbers in one array.
fn near(scene: &Scene, random: &mut Random) -> (Vec<State<HostModal>>, Vec<f64>) {
    let mut numbers = Vec::new();
    let states = scene
        .initial
        .iter()
        .map(|state| {
            let mut off = |near: f64| {
                let number = near + 3e-2 * random.number();
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

/// Results and whether the conditions hold, by interpreting the operations.
fn interpreted(function: &ArrayFunction, state: &[f64], drives: &[f64]) -> (Vec<f64>, bool) {
    function.interpret(|symbol| match symbol {
        Symbol::Intermediate("state", index) => state[index],
        Symbol::Intermediate("drive", index) => drives[index],
        other => panic!("{other} is no input"),
    })
}

/// Compares so many states in which the conditions hold; gives how many there were.
fn compare(name: &str, scene: &Scene, function: &ArrayFunction) -> usize {
    let mut random = Random::new(7);
    let connections = scene.mechanism.drives();
    let mut seen = 0;
    for case in 0..12 {
        let (states, numbers) = near(scene, &mut random);
        let values: Vec<[f64; 3]> = connections
            .iter()
            .map(|drive| if drive.is_some() { [0, 1, 2].map(|_| random.number()) } else { [0.0; 3] })
            .collect();
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
        let function =
            accelerations(&scene, "accelerations").unwrap_or_else(|error| panic!("{name}: {error}"));
        let seen = compare(name, &scene, &function);
        assert!(seen > 3, "{name}: the conditions held in {seen} of 12 states");
    }
}

#[test]
fn other_branches_are_noticed() {
    let scene = scene("slider_crank");
    let function = accelerations(&scene, "accelerations").unwrap();
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
    let error = |name: &str| accelerations(&scene(name), "accelerations").unwrap_err();
    let motor = error("flexible_rotor");
    assert!(matches!(motor, StraightLineError::Unknown { .. }), "{motor}");
    assert!(motor.to_string().starts_with("forces.motor"), "{motor}");
    let torsion = error("crane");
    assert!(matches!(torsion, StraightLineError::Functions { .. }), "{torsion}");
    assert!(torsion.to_string().contains("atan2"), "{torsion}");
}
