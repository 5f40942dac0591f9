//! Markers where loads stress the body: generated code, scenes and C bend their rows alike, and forces there do the work of places.

use std::path::Path;

use ffrf::mechanism::{Constrained, Treatment};
use ffrf::{EnergyMomentum, State, mechanism};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::{HostMechanism, HostModal};

use crate::bodies::all;
use crate::stiffened_m2::StiffenedBody;

mechanism! {
    /// A body that hangs at one marker and is pulled at the other.
    pub struct Pulled {
        bodies: { part: StiffenedBody },
        joints: { pin: spherical(ground, part.ROOT) },
        forces: {
            rope: spring(ground.at([1.5, 0.5, -0.5]), part.TIP, stiffness: 8.0, damping: 0.0, rest_length: 0.25),
        },
    }
}

/// The same as a scene, with more: what the sensors show at the loaded marker. `folder`: where the body may be written.
pub fn scene(folder: &Path, integrator: &str, fidelity: &str) -> String {
    let (_, body, _) = all().into_iter().find(|(name, ..)| *name == "stiffened_m2").unwrap();
    let path = folder.join("loaded.ffrf.json");
    body.write(&path).unwrap();
    format!(
        r#"
[simulation]
duration = 1.0
step = 0.0009765625
integrator = "{integrator}"
[bodies.part]
model = {path:?}
fidelity = "{fidelity}"
modal_coordinates = [0.2, -0.3]
[joints.pin]
kind = "spherical"
first = "ground"
second = "part.root"
[forces.rope]
kind = "spring"
first_position = [1.5, 0.5, -0.5]
second = "part.tip"
stiffness = 8.0
damping = 0.0
rest = 0.25
[sensors.place]
kind = "position"
of = "part.tip"
[sensors.speed]
kind = "velocity"
of = "part.tip"
[sensors.shock]
kind = "acceleration"
of = "part.tip"
[sensors.hold]
kind = "reaction_force"
of = "pin"
"#
    )
}

fn composed(folder: &Path, integrator: &str, fidelity: &str) -> Scene {
    let file = SceneFile::parse(&scene(folder, integrator, fidelity)).unwrap();
    Scene::compose(&file, folder).unwrap()
}

/// The state after so many steps of 1/1024 s.
fn after(scene: &Scene, steps: usize) -> Vec<f64> {
    following(scene, steps, |system, state| ffrf::step_rk4(system, state, 0.0, STEP).unwrap().0)
}

type Place = Vec<State<HostModal>>;

fn following(
    scene: &Scene,
    steps: usize,
    step: impl Fn(&Constrained<'_, HostMechanism>, &Place) -> Place,
) -> Vec<f64> {
    let system = Constrained(&scene.mechanism);
    let (mut state, _) = scene.assembled().unwrap();
    for _ in 0..steps {
        state = step(&system, &state);
    }
    state.iter().flat_map(State::<HostModal>::numbers).collect()
}

fn compiled(treatment: Treatment<f64>) -> mechanism::Mechanism<Pulled, f64> {
    let model = Pulled { treatment, ..Pulled::new(StiffenedBody) };
    let mut state = model.at_rest();
    state.part.modal_coordinates = [0.2, -0.3].into();
    let mut compiled = model.in_motion(state);
    compiled.assemble().unwrap();
    compiled
}

/// Power that damping of the modes takes. Units: W.
fn dissipated(state: &PulledState) -> f64 {
    let (_, body, _) = all().into_iter().find(|(name, ..)| *name == "stiffened_m2").unwrap();
    let rates = &state.part.modal_rates;
    (0..2).map(|mu| (0..2).map(|nu| rates[mu] * body.damping[mu][nu] * rates[nu]).sum::<f64>()).sum()
}

/// Units: s.
const STEP: f64 = 1.0 / 1024.0;
const STEPS: usize = 512;

/// Round-off of a few hundred steps of a soft motion, as a share of the largest number.
const SAME: f64 = 1e-10;
/// What an iteration to round-off leaves of the energy in a step.
const CONSERVED: f64 = 1e-13;
/// What RK4 changes the energy by with this step: the fourth power of its product with the highest frequency, 10 to 20 rad/s.
const ENERGY: f64 = 1e-7;

#[test]
fn compiled_bodies_bend_their_markers_as_scenes_do() {
    let folder = tempfile::tempdir().unwrap();
    let mut compiled = compiled(Pulled::new(StiffenedBody).treatment);
    let begin = compiled.energy().total();
    let mut lost = dissipated(&compiled.state);
    for k in 1..=STEPS {
        compiled.step_rk4(STEP).unwrap();
        // Simpson's rule
        let weight = [2.0, 4.0, 1.0][if k == STEPS { 2 } else { k % 2 }];
        lost += weight * dissipated(&compiled.state);
    }
    lost *= STEP / 3.0;
    let off = (compiled.energy().total() + lost - begin).abs();
    let found = compiled.state.to_array();
    let expected = after(&composed(folder.path(), "rk4", "full"), STEPS);
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apart = |other: &[f64]| {
        assert_eq!(found.len(), other.len());
        found.iter().zip(other).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / largest
    };
    println!(
        "apart {:.1e}, energy {:.1e} of {begin:.3}, {lost:.3} dissipated",
        apart(&expected),
        off / begin.abs()
    );
    assert!(apart(&expected) < SAME);
    assert!(off < ENERGY * begin.abs(), "{off:e} of {begin}");
    // Rows that stay are another motion: the comparison would see it.
    let straight = after(&composed(folder.path(), "rk4", "unstiffened"), STEPS);
    assert!(apart(&straight) > 1e-3);
}

#[test]
fn the_energy_momentum_method_does_the_work_of_bent_markers() {
    let folder = tempfile::tempdir().unwrap();
    let (_, body, _) = all().into_iter().find(|(name, ..)| *name == "stiffened_m2").unwrap();
    let method = EnergyMomentum::new();
    let mut compiled = compiled(Treatment::Index3);
    let begin = compiled.energy().total();
    let (mut energy, mut worst) = (begin, 0.0_f64);
    for _ in 0..STEPS {
        let before = compiled.state.part.modal_coordinates;
        compiled.step_with(STEP, |system, state, time, step| method.step(system, state, time, step)).unwrap();
        // Damping acts on the mean rates.
        let rates = (compiled.state.part.modal_coordinates - before) / STEP;
        let taken: f64 =
            (0..2).map(|mu| (0..2).map(|nu| rates[mu] * body.damping[mu][nu] * rates[nu]).sum::<f64>()).sum();
        let after = compiled.energy().total();
        worst = worst.max((after + taken * STEP - energy).abs());
        energy = after;
    }
    let found = compiled.state.to_array();
    let step = |system: &Constrained<'_, HostMechanism>, state: &Place| {
        method.step(system, state, 0.0, STEP).unwrap().0
    };
    let expected = following(&composed(folder.path(), "energy_momentum", "full"), STEPS, step);
    let largest = expected.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let apart = found.iter().zip(&expected).fold(0.0_f64, |most, (a, b)| most.max((a - b).abs())) / largest;
    println!(
        "energy of a step {:.1e} of {begin:.3}, apart {apart:.1e}, dissipated {:.1e}",
        worst / begin.abs(),
        begin - energy
    );
    assert!(worst < CONSERVED * begin.abs(), "{worst:e} of {begin}");
    assert!(apart < SAME, "{apart:e}");
}
