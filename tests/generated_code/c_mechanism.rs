//! Whole steps of mechanisms in C against the same steps of the same scenes on the desktop.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use ffrf::mechanism::Constrained;
use ffrf::nalgebra::RealField;
use ffrf::{
    Observables, State, step_linearly_implicit, step_linearly_implicit_euler, step_rk4, step_symplectic_euler,
};
use ffrf_codegen::{GenerateOptions, GeneratedMechanismC, ScalarType, generate_mechanism_c};
use ffrf_host::mechanism::Drive;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::scene::{Integrator, Scene};
use ffrf_host::simulate::CoSimulation;
use ffrf_host::{HostMechanism, HostModal};
use ffrf_test_kit::scene_text::with_step;

use crate::c_program::{last_places, printed};
use crate::committed::Committed;

/// Input of every actuator.
const INPUT: f64 = 0.75;

/// What is compared: a scene for so many steps, in units in the last place a step of the largest number of a kind.
struct Case {
    name: &'static str,
    scene: String,
    steps: usize,
    /// Of the state after each step. C sums in another order than the desktop: every step adds some round-off of its own,
    /// and stiff modes and redundant rows multiply it by what they are large.
    places: f64,
    /// Of what the sensors show: accelerations and reactions have the round-off of stiff modes over a step.
    sensed: f64,
}

fn folder() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes")
}

fn compose(text: &str) -> Scene {
    Scene::compose(&SceneFile::parse(text).unwrap(), &folder()).unwrap()
}

fn example(name: &str, integrator: &str, step: f64) -> String {
    with_step(&folder().join(name), integrator, step)
}

/// A body on every kind of joint, with forces, actuators and sensors of every kind.
fn every_joint(integrator: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/generated_code/every_joint.toml");
    with_step(&path, integrator, 1.0 / 4096.0)
}

fn numbers<T: RealField + Copy + Into<f64>>(states: &[State<HostModal<T>, T>]) -> Vec<f64> {
    states.iter().flat_map(State::numbers).map(Into::into).collect()
}

/// The states after each step on the desktop in a number type.
fn on_the_desktop<T>(mechanism: &HostMechanism<T>, scene: &Scene, steps: usize, step: f64) -> Vec<Vec<f64>>
where
    T: RealField + Copy + Into<f64>,
{
    let number = |x: f64| ffrf::nalgebra::convert::<f64, T>(x);
    let system = Constrained(mechanism);
    let initial = scene.assembled().unwrap().0;
    let mut state: Vec<State<HostModal<T>, T>> = initial
        .iter()
        .zip(mechanism.bodies())
        .map(|(from, body)| {
            let mut state = State::at_rest(body);
            state.set_numbers(&mut from.numbers().map(number));
            state
        })
        .collect();
    let mut list = Vec::new();
    let mut time = T::zero();
    for _ in 0..steps {
        let h = number(step);
        let done = match scene.settings.integrator {
            Integrator::SymplecticEuler => step_symplectic_euler(&system, &state, time, h),
            Integrator::LinearlyImplicit => step_linearly_implicit(&system, &state, time, h),
            Integrator::LinearlyImplicitEuler => step_linearly_implicit_euler(&system, &state, time, h),
            _ => step_rk4(&system, &state, time, h),
        };
        state = done.unwrap().0;
        time += h;
        list.push(numbers(&state));
    }
    list
}

fn program(code: &GeneratedMechanismC, scene: &Scene, scalar: &str, steps: usize, step: f64) -> String {
    let prefix = &code.prefix;
    let mut text = format!(
        "#include \"{prefix}.h\"\n#include <stdio.h>\n\n\
         static void show(const {scalar} *numbers, int count)\n{{\n    int k;\n    for (k = 0; k < count; k++) {{\n        \
         printf(\"%.17g \", (double)numbers[k]);\n    }}\n}}\n\n\
         int main(void)\n{{\n    {prefix}_state state;\n    {prefix}_state before;\n    {prefix}_inputs inputs;\n    int n;\n    int k;\n    \
         const {scalar} zero = ({scalar})0;\n    \
         for (k = 0; k < (int)(sizeof inputs.actuators / sizeof inputs.actuators[0]); k++) {{\n        \
         inputs.actuators[k] = ({scalar}){INPUT:?};\n    }}\n    {prefix}_start(&state);\n    before = state;\n    \
         if ({prefix}_step(&state, &inputs, zero) != 1) {{ return 2; }}\n    \
         if ({prefix}_step(&state, &inputs, ({scalar})1 / zero) != 1) {{ return 3; }}\n    \
         before.bodies[0].omega[1] = zero / zero;\n    \
         if ({prefix}_step(&before, &inputs, ({scalar}){step:?}) != 2) {{ return 4; }}\n    \
         for (n = 0; n < {steps}; n++) {{\n        \
         if ({prefix}_step(&state, &inputs, ({scalar}){step:?}) != 0) {{ return 5; }}\n"
    );
    for (body, parts) in scene.mechanism.bodies().iter().enumerate() {
        let modes = parts.mode_count();
        for (field, count) in [
            ("position", 3),
            ("orientation", 4),
            ("q", modes),
            ("velocity", 3),
            ("omega", 3),
            ("q_dot", modes),
        ] {
            if count > 0 {
                let _ = writeln!(text, "        show(state.bodies[{body}].{field}, {count});");
            }
        }
    }
    text.push_str("        printf(\"\\n\");\n    }\n");
    if !scene.sensors.is_empty() {
        let upper = prefix.to_uppercase();
        let _ = write!(
            text,
            "    {{\n        {prefix}_outputs outputs;\n        \
             if ({prefix}_read(&state, &inputs, &outputs) != 0) {{ return 6; }}\n        \
             show(outputs.values, {upper}_SENSOR_COUNT);\n        printf(\"\\n\");\n    }}\n"
        );
    }
    let _ = write!(
        text,
        "    {{\n        {prefix}_observables observed;\n        \
         if ({prefix}_observe(&state, &observed) != 0) {{ return 7; }}\n        \
         show(&observed.kinetic, 1);\n        show(&observed.elastic, 1);\n        show(&observed.potential, 1);\n        \
         show(&observed.position_drift, 1);\n        show(&observed.velocity_drift, 1);\n        printf(\"\\n\");\n    }}\n"
    );
    text.push_str("    return 0;\n}\n");
    text
}

/// The lines that the program prints; none without a compiler.
fn in_c(code: &GeneratedMechanismC, program: &str) -> Option<Vec<Vec<f64>>> {
    printed(&code.prefix, [&code.header, &code.source, &code.single], program)
}

/// What is off, if anything is.
fn compare(case: &Case, single: bool) -> Option<String> {
    let mut scene = compose(&case.scene);
    let ffrf_host::scene::StepChoice::Fixed(step) = scene.settings.step else { panic!("a fixed step") };
    for actuator in 0..scene.mechanism.actuators().len() {
        scene.mechanism.set_actuator_input(actuator, Drive::Polynomial(vec![INPUT]));
    }
    let model = scene.mechanism_model("scene.toml").unwrap();
    let (scalar, kind, epsilon) = match single {
        true => (ScalarType::F32, "float", f64::from(f32::EPSILON)),
        false => (ScalarType::F64, "double", f64::EPSILON),
    };
    let options = GenerateOptions { name: "TestMechanism".to_owned(), scalar, ..GenerateOptions::default() };
    let code = generate_mechanism_c(&model, &options).unwrap();
    assert_eq!(code, generate_mechanism_c(&model, &options).unwrap());
    let mut found = in_c(&code, &program(&code, &scene, kind, case.steps, step))?;
    let expected = match single {
        true => on_the_desktop(&scene.mechanism.cast::<f32>(), &scene, case.steps, step),
        false => on_the_desktop(&scene.mechanism, &scene, case.steps, step),
    };
    let name = case.name;
    let observed = found.pop().unwrap();
    let sensed = (!scene.sensors.is_empty()).then(|| found.pop().unwrap());
    assert_eq!(found.len(), case.steps);
    let mut worst = 0.0_f64;
    for (index, (found, expected)) in found.iter().zip(&expected).enumerate() {
        let places = last_places(found, expected, epsilon) / (index + 1) as f64;
        assert!(places.is_finite(), "{name}");
        worst = worst.max(places);
    }
    let moved = expected[case.steps - 1].iter().zip(&expected[0]).any(|(a, b)| (a - b).abs() > 1e-3);
    assert!(moved, "{name} stands still");
    let [mut worst_sensed, mut worst_energy, mut worst_drift] = [0.0; 3];
    if !single {
        let state_size = found[0].len();
        let mut way = CoSimulation::new(scene, 0.0).unwrap();
        way.advance(step * case.steps as f64).unwrap();
        let values = way.values().unwrap();
        let (seen, expected) = values[state_size..].split_at(values.len() - state_size - OBSERVED);
        if let Some(sensed) = sensed {
            worst_sensed = last_places(&sensed, seen, epsilon) / case.steps as f64;
        }
        worst_energy = last_places(&observed[..3], &expected[..3], epsilon) / case.steps as f64;
        let largest = found[case.steps - 1].iter().fold(1.0_f64, |largest, x| largest.max(x.abs()));
        for (found, expected) in observed[3..].iter().zip(&expected[3..]) {
            worst_drift = f64::max(worst_drift, (found - expected).abs() / (epsilon * largest));
        }
    }
    // in single precision there is no other reading of the sensors to compare with
    let shown = |value: f64| if single { "not compared".to_owned() } else { format!("{value:.3}") };
    eprintln!(
        "{name} ({kind}): states {worst:.3}, sensors {}, energies {} units in the last place a step; drift {}",
        shown(worst_sensed),
        shown(worst_energy),
        shown(worst_drift)
    );
    let fine = worst <= case.places
        && worst_sensed <= case.sensed
        && worst_energy <= case.places
        && worst_drift <= DRIFT;
    (!fine).then(|| {
        format!("{name} ({kind}): states {worst}, sensors {worst_sensed}, energies {worst_energy}, drift {worst_drift}")
    })
}

/// Energies and drifts at the end of the columns.
const OBSERVED: usize = 5;

/// What drifts may differ by: they are themselves round-off of the largest number of the state, whose units in the last place
/// these are; a step is brought back to the joints until some of them are left.
const DRIFT: f64 = 64.0;

#[test]
fn mechanisms_in_c_move_as_on_the_desktop() {
    let case = |name, scene, steps, places, sensed| Case { name, scene, steps, places, sensed };
    let cases = [
        case("double pendulum", example("double_pendulum.toml", "rk4", 1.0 / 1024.0), 500, 1.0, 1.0),
        case("slider-crank", example("slider_crank.toml", "rk4", 1.0 / 524_288.0), 500, 1.0, 1.0),
        // bodies stand on their joints with the ground on the desktop, and are held by rows in C: another round-off, which
        // accelerations of stiff modes show enlarged
        case(
            "stiff slider-crank",
            example("slider_crank.toml", "linearly_implicit", 1.0 / 16384.0),
            500,
            4.0,
            500.0,
        ),
        case("four-bar", example("four_bar.toml", "symplectic_euler", 1.0 / 1024.0), 500, 4.0, 1.0),
        case("governor", example("governor.toml", "linearly_implicit_euler", 1.0 / 1024.0), 500, 10.0, 10.0),
        // without a joint
        case("rotor", example("rotor.toml", "linearly_implicit", 1.0 / 16384.0), 500, 10.0, 10.0),
        case(
            "tumbling rod",
            example("tumbling_rod.toml", "linearly_implicit", 1.0 / 1024.0),
            500,
            10.0,
            10.0,
        ),
        case("every joint, explicit", every_joint("rk4"), 200, 1.0, 1.0),
        case("every joint, implicit", every_joint("linearly_implicit"), 200, 10.0, 10.0),
    ];
    let folder = tempfile::tempdir().unwrap();
    let loaded = |integrator| crate::loaded_markers::scene(folder.path(), integrator, "full");
    let cases = cases.into_iter().chain([
        case("loaded markers, explicit", loaded("rk4"), 500, 10.0, 10.0),
        case("loaded markers, implicit", loaded("linearly_implicit"), 500, 10.0, 10.0),
    ]);
    let cases: Vec<Case> = cases.collect();
    let single = ["double pendulum", "stiff slider-crank"];
    let off: Vec<String> = cases
        .iter()
        .flat_map(|case| [Some((case, false)), single.contains(&case.name).then_some((case, true))])
        .flatten()
        .filter_map(|(case, single)| compare(case, single))
        .collect();
    assert!(off.is_empty(), "units in the last place a step: {off:#?}");
}

/// Kinetic and potential energy of a state as C printed it, without force elements. Units: J.
fn energy(scene: &Scene, numbers: &[f64]) -> f64 {
    let mut numbers = numbers.iter().copied();
    let bodies = scene.mechanism.bodies().iter();
    bodies
        .map(|body| {
            let mut state = State::at_rest(body);
            state.set_numbers(&mut numbers);
            let q = &state.modal_coordinates;
            let moment = state.position * body.mass() + state.to_inertial(&body.first_mass_moment(q));
            body.kinetic_energy(q, &state.body_velocity(), &state.angular_velocity, &state.modal_rates)
                + body.elastic_energy(q)
                - scene.mechanism.gravity().dot(&moment)
        })
        .sum()
}

/// What RK4 changes the energy of the double pendulum by in half a second, relative to what the upper end would fall: h⁴ and
/// constants of order one.
const ENERGY: f64 = 1e-9;

#[test]
fn the_double_pendulum_in_c_keeps_its_energy_and_its_text() {
    let scene = compose(&example("double_pendulum.toml", "rk4", 1.0 / 1024.0));
    let model = scene.mechanism_model("double_pendulum.toml").unwrap();
    let options = GenerateOptions { name: "DoublePendulum".to_owned(), ..GenerateOptions::default() };
    let code = generate_mechanism_c(&model, &options).unwrap();
    if let Some(found) = in_c(&code, &program(&code, &scene, "double", 512, 1.0 / 1024.0)) {
        let begin = energy(&scene, &found[0]);
        for state in &found[..512] {
            let change = (energy(&scene, state) - begin).abs() / 9.81;
            assert!(change < ENERGY, "{change}");
        }
    }
    let mut committed = Committed::default();
    committed.compare("double_pendulum_mechanism.h", &code.header);
    committed.compare("double_pendulum_mechanism.c", &code.source);
    committed.assert_current();
}
