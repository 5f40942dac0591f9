//! The energy-momentum method with force elements that store energy: each does the work of its change, to round-off.

use std::path::Path;

use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::simulate::{Sample, header, simulate};

/// A random walk of some 1e-15 per step.
const KEPT: f64 = 1e-12;

fn run(text: &str) -> (Vec<String>, Vec<Sample>, usize) {
    let file = SceneFile::parse(text).unwrap();
    let scene = Scene::compose(&file, Path::new("")).unwrap_or_else(|error| panic!("{error}"));
    let mut samples = Vec::new();
    let keep = |sample: &Sample| {
        samples.push(sample.clone());
        Ok(())
    };
    let summary = simulate(&scene, None, keep, |_| ()).unwrap_or_else(|error| panic!("{error}"));
    (header(&scene), samples, summary.advance.iterations)
}

/// Two bodies that fly and turn fast; large steps: the rotation per step is a quarter of a radian.
const FREE: &str = r#"[simulation]
duration = 10.0
step = 2e-2
integrator = "energy_momentum"
output_step = 0.1
[bodies.one]
mass = 2.0
center_of_mass = [0.05, -0.1, 0.02]
inertia = [[0.3, 0.0, 0.0], [0.0, 0.5, 0.0], [0.0, 0.0, 0.6]]
angular_velocity = [8.0, 4.0, -3.0]
velocity = [0.3, 0.0, -0.2]
markers.END = [0.4, 0.1, 0.0]
[bodies.other]
mass = 1.0
inertia = [[0.1, 0.0, 0.0], [0.0, 0.15, 0.0], [0.0, 0.0, 0.2]]
position = [0.6, 0.2, 0.1]
angular_velocity = [-5.0, 2.0, 6.0]
markers.END = [-0.1, 0.1, 0.0]
"#;

const SPRING: &str = "[forces.spring]\nkind = \"spring\"\nfirst = \"one.END\"\nsecond = \"other.END\"\nstiffness = 60.0\nrest = 0.05\n";
/// Turns by up to two radians.
const BUSHING: &str = "[forces.bushing]\nkind = \"bushing\"\nfirst = \"one.END\"\nsecond = \"other.END\"\n\
                       stiffness_matrix = [90.0, 50.0, 70.0, 20.0, 14.0, 30.0]\n";
/// A coil about the axis of a hinge.
const COIL: &str = "[forces.coil]\nkind = \"torsion_spring\"\nfirst = \"one.END\"\nsecond = \"other.END\"\naxis = [0.3, 1.0, 0.2]\n\
                    stiffness = 9.0\nrest = 0.4\n";

fn energy(names: &[String], sample: &Sample) -> f64 {
    let parts = ["energy.kinetic", "energy.elastic", "energy.potential"];
    parts.iter().map(|part| sample.values[names.iter().position(|name| name == part).unwrap() - 1]).sum()
}

/// The largest change of the energy, relative to the first.
fn change(text: &str) -> (f64, f64, usize) {
    let (names, samples, iterations) = run(text);
    let start = energy(&names, &samples[0]);
    let worst = samples.iter().map(|sample| (energy(&names, sample) - start).abs()).fold(0.0, f64::max);
    let potential = names.iter().position(|name| name == "energy.potential").unwrap() - 1;
    let all: Vec<f64> = samples.iter().map(|sample| sample.values[potential]).collect();
    let spread = all.iter().fold(f64::MIN, |a, b| a.max(*b)) - all.iter().fold(f64::MAX, |a, b| a.min(*b));
    (worst / start.abs(), spread / start.abs(), iterations)
}

#[test]
fn springs_and_bushings_between_free_bodies_keep_the_energy() {
    for (name, element) in [("spring", SPRING), ("bushing", BUSHING)] {
        let (change, spread, iterations) = change(&format!("{FREE}{element}"));
        eprintln!("{name}: energy {change:.1e}, exchanged {spread:.2}, iterations {iterations}");
        assert!(spread > 0.02, "{name} takes part: {spread}");
        assert!(change < KEPT, "{name}: {change:e}");
    }
}

#[test]
fn a_torsion_spring_keeps_the_energy_about_a_turning_axis() {
    // a hinge whose axis turns with two free bodies; within half a turn, where the angle has no jump
    let slow = FREE.replace("[-5.0, 2.0, 6.0]", "[7.0, 5.0, -4.0]");
    let hinge = "[joints.hinge]\nkind = \"revolute\"\nfirst = \"one.END\"\nsecond = \"other.END\"\naxis = [0.3, 1.0, 0.2]\n";
    let (change, spread, iterations) = change(&format!("{slow}{hinge}{COIL}"));
    eprintln!("coil: energy {change:.1e}, exchanged {spread:.2}, iterations {iterations}");
    assert!(spread > 0.02, "{spread}");
    assert!(change < KEPT, "{change:e}");
}

#[test]
fn momentum_of_free_bodies_is_kept_with_force_elements_between_them() {
    let text = format!("{FREE}{SPRING}{BUSHING}");
    let (names, samples, _) = run(&text);
    let scene = Scene::compose(&SceneFile::parse(&text).unwrap(), Path::new("")).unwrap();
    let at = |name: &str| names.iter().position(|found| found == name).unwrap() - 1;
    let momenta = |sample: &Sample| {
        let mut sum = [nalgebra::Vector3::zeros(); 2];
        for (name, body) in ["one", "other"].iter().zip(scene.mechanism.bodies()) {
            let vector = |what: &str| {
                let first = at(&format!("{name}.{what}.x"));
                nalgebra::Vector3::from_column_slice(&sample.values[first..first + 3])
            };
            let first = at(&format!("{name}.orientation.w"));
            let [w, i, j, k] = [0, 1, 2, 3].map(|n| sample.values[first + n]);
            let rotation = nalgebra::UnitQuaternion::new_unchecked(nalgebra::Quaternion::new(w, i, j, k));
            let (position, velocity, spin) =
                (vector("position"), vector("velocity"), vector("angular_velocity"));
            let still = ffrf_host::HostModal(nalgebra::DVector::zeros(0));
            let prepared = ffrf_runtime::FlexibleBody::prepare(body, &still, &spin, &still);
            let motion = ffrf_runtime::Motion {
                linear: rotation.inverse() * velocity,
                angular: spin,
                modal: still.clone(),
            };
            let mass = ffrf_runtime::FlexibleBody::modal_mass(body);
            let momentum = prepared.mass_times(&mass, &motion);
            let linear = rotation * momentum.force;
            sum[0] += linear;
            sum[1] += position.cross(&linear) + rotation * momentum.moment;
        }
        sum
    };
    let start = momenta(&samples[0]);
    for sample in &samples {
        let now = momenta(sample);
        for k in 0..2 {
            let off = (now[k] - start[k]).norm() / start[k].norm();
            assert!(off < 10.0 * KEPT, "t = {}, momentum {k}: {off:e}", sample.time);
        }
    }
}

#[test]
fn dampers_only_take_energy() {
    let damped = SPRING.replace("rest = 0.05", "rest = 0.05\ndamping = 0.3")
        + &BUSHING.replace("30.0]\n", "30.0]\ndamping_matrix = [0.1, 0.1, 0.1, 0.02, 0.03, 0.01]\n");
    let (names, samples, _) = run(&format!("{FREE}{damped}"));
    let energies: Vec<f64> = samples.iter().map(|sample| energy(&names, sample)).collect();
    for pair in energies.windows(2) {
        assert!(pair[1] < pair[0] * (1.0 + KEPT), "{pair:?}");
    }
    assert!(energies[energies.len() - 1] < 0.9 * energies[0]);
}
