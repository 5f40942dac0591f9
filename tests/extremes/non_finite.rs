//! Input that is not finite, and numbers that a scene cannot have.

use ffrf::mechanism::Constrained;
use ffrf::nalgebra::{Matrix3, Vector3};
use ffrf::{
    EnergyMomentum, FreeBody, FreeSystem, GeneralisedAlpha, GeneralisedForce, Load, RigidBody, State,
    StepError, StepReport, System, step_dormand_prince, step_exponential, step_linearly_implicit,
    step_linearly_implicit_euler, step_rk4, step_symplectic_euler,
};
use ffrf_host::scene::Scene;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::simulate::simulate;

use crate::row;
use crate::settings::{Rod, Setting, brick};
use crate::table::{Figure, Real, Section, refused};

pub fn section() -> Section {
    Section {
        title: "Input that is not finite",
        text: "Each number of a state (a free rod; a pendulum) is infinite or not a number, for every integrator: refused, and \
               the state is as it was. The same for step sizes, loads and masses. Scenes: each number of a file that has every \
               kind of body, force and event is replaced by nan, inf, -inf, 0, -1, 1e300 and 1e-300, one at a time: the file is refused, \
               or the run is with its time, or every number of every sample is finite.",
        rows: vec![
            row!("a number of a free rod's state", free_state),
            row!("a number of a pendulum's state", pendulum_state),
            row!("step size nan", step_size, f64::NAN),
            row!("step size inf", step_size, f64::INFINITY),
            row!("step size 0", step_size, 0.0),
            row!("step size -1", step_size, -1.0),
            row!("a load that is nan", bad_load),
            row!("a mass that is nan", mass, f64::NAN),
            row!("a mass that is 0", mass, 0.0),
            row!("a mass that is negative", mass, -1.0),
            row!("each number of a scene, one at a time", scenes),
        ],
    }
}

type Method<S, T> =
    fn(&S, &<S as System<T>>::State, T, T) -> Result<(<S as System<T>>::State, StepReport<T>), StepError>;

/// Every number of a state in turn, by its place.
fn spoiled<T: Real, V: ffrf::ModalVector<T>>(state: &State<V, T>, place: usize, value: T) -> State<V, T> {
    let mut spoiled = state.clone();
    let mut numbers: Vec<T> = state.numbers().collect();
    numbers[place] = value;
    spoiled.set_numbers(&mut numbers.into_iter());
    spoiled
}

fn bad<T: Real>() -> [T; 3] {
    [T::of(f64::NAN), T::of(f64::INFINITY), T::of(f64::NEG_INFINITY)]
}

fn free_state<T: Real>() -> Figure {
    let start = FreeBody::<Rod, T>::new(Rod);
    let system = FreeSystem { body: &Rod, load: &() };
    let methods: [Method<FreeSystem<'_, Rod, ()>, T>; 6] = [
        step_rk4,
        step_symplectic_euler,
        step_dormand_prince,
        step_linearly_implicit,
        step_linearly_implicit_euler,
        step_exponential,
    ];
    let (alpha, conserving) = (GeneralisedAlpha::new(), EnergyMomentum::new());
    let (zero, step) = (T::zero(), T::of(1e-6));
    let memory = alpha.start(&system, &start.state, zero, step).unwrap();
    let mut found = Vec::new();
    for place in 0..start.state.numbers().count() {
        for value in bad() {
            let state = spoiled(&start.state, place, value);
            found.extend(methods.iter().map(|method| method(&system, &state, zero, step).unwrap_err()));
            found.push(alpha.start(&system, &state, zero, step).unwrap_err());
            found.push(alpha.step(&system, &mut memory.clone(), &state, zero, step).unwrap_err());
            found.push(conserving.step(&system, &state, zero, step).unwrap_err());
        }
    }
    one(&found)
}

/// What all errors say.
fn one(errors: &[StepError]) -> Figure {
    assert!(errors.iter().all(|error| *error == errors[0]), "{errors:?}");
    refused(errors[0])
}

fn pendulum<T: Real>() -> Setting<T> {
    Setting::of(
        "[simulation]\nduration = 1.0\nstep = 1e-3\ngravity = [0.0, -9.81, 0.0]\n\
         [bodies.rod]\nmodel = \"../conrod.ffrf.json\"\nmodes = 2\n\
         [joints.pin]\nkind = \"revolute\"\nfirst = \"ground\"\nfirst_position = [-0.06, 0.0, 0.0]\nsecond = \"rod.BIG_END\"\n\
         axis = [0.0, 0.0, 1.0]\n",
    )
}

fn pendulum_state<T: Real>() -> Figure {
    let setting = pendulum::<T>();
    let system = Constrained(&setting.mechanism);
    let methods = [
        step_rk4,
        step_symplectic_euler,
        step_dormand_prince,
        step_linearly_implicit,
        step_linearly_implicit_euler,
    ];
    let mut found = Vec::new();
    for place in 0..setting.states[0].numbers().count() {
        for value in bad() {
            let state = vec![spoiled(&setting.states[0], place, value)];
            found.extend(
                methods.iter().map(|method| method(&system, &state, T::zero(), T::of(1e-6)).unwrap_err()),
            );
        }
    }
    one(&found)
}

fn step_size<T: Real>(step: f64) -> Figure {
    let mut body = FreeBody::new(Rod);
    let mut found = [
        body.step_rk4(T::of(step), &()).unwrap_err(),
        body.step_linearly_implicit(T::of(step), &()).unwrap_err(),
    ];
    // not a number equals nothing
    if let [StepError::StepSize { found: first }, StepError::StepSize { found: second }] = &mut found
        && first.is_nan()
        && second.is_nan()
    {
        return refused(StepError::StepSize { found: *first });
    }
    one(&found)
}

struct BadLoad;

impl<B, S, V, T: Real> Load<B, S, GeneralisedForce<V, T>, T> for BadLoad {
    fn add_to(&self, _: &B, _: T, _: &S, force: &mut GeneralisedForce<V, T>) {
        force.force.x = T::of(f64::NAN);
    }
}

fn bad_load<T: Real>() -> Figure {
    let mut body = FreeBody::<Rod, T>::new(Rod);
    let before = body.state;
    let found = [
        body.step_rk4(T::of(1e-6), &BadLoad).unwrap_err(),
        body.step_linearly_implicit(T::of(1e-6), &BadLoad).unwrap_err(),
    ];
    assert_eq!(body.state, before);
    one(&found)
}

fn mass<T: Real>(mass: f64) -> Figure {
    let body = RigidBody::new(T::of(mass), Vector3::zeros(), Matrix3::identity());
    let mut free = FreeBody::new(body).with_spin(Vector3::x());
    let found = [
        free.step_rk4(T::of(1e-3), &()).unwrap_err(),
        free.step_linearly_implicit(T::of(1e-3), &()).unwrap_err(),
    ];
    assert!(brick::<T>() != body);
    one(&found)
}

const SCENE: &str = include_str!("every_number.toml");

/// Where the numbers of a scene stand.
fn numbers(text: &str) -> Vec<std::ops::Range<usize>> {
    let mut found = Vec::new();
    let mut at = 0;
    for line in text.split_inclusive('\n') {
        if let Some(equals) = line.find('=') {
            let mut begin = None;
            let mut quoted = false;
            for (k, c) in line.char_indices().skip(equals + 1) {
                quoted ^= c == '"';
                let part = !quoted && (c.is_ascii_digit() || ".-e".contains(c));
                match (begin, part) {
                    (None, true) if c.is_ascii_digit() || c == '-' => begin = Some(k),
                    (Some(start), false) => {
                        found.push(at + start..at + k);
                        begin = None;
                    }
                    _ => {}
                }
            }
        }
        at += line.len();
    }
    found
}

/// Whether all of a run is finite, or refused.
fn runs(text: &str) -> bool {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("models/scenes");
    let scene = SceneFile::parse(text).and_then(|file| Scene::compose(&file, &folder));
    let Ok(scene) = scene else { return false };
    let write = |sample: &ffrf_host::simulate::Sample| {
        let finite = sample.time.is_finite() && sample.values.iter().all(|value| value.is_finite());
        assert!(finite, "{} in\n{text}", sample.time);
        Ok(())
    };
    simulate(&scene, None, write, |_| ()).is_ok()
}

fn scenes<T: Real>() -> Figure {
    if T::SINGLE {
        return Figure::Holds("-");
    }
    assert!(runs(SCENE), "the scene as it stands");
    let places = numbers(SCENE);
    assert!(places.len() > 100, "{}", places.len());
    let mut counts = [0; 2];
    for place in &places {
        for value in ["nan", "inf", "-inf", "0.0", "-1.0", "1e300", "1e-300"] {
            let line = SCENE[..place.start].rsplit('\n').next().unwrap_or_default();
            let lasts = ["duration", "step", "output_step"].iter().any(|key| line.trim().starts_with(key));
            if lasts && value.starts_with("1e") {
                // asks for steps without end
                continue;
            }
            let text = format!("{}{value}{}", &SCENE[..place.start], &SCENE[place.end..]);
            counts[usize::from(runs(&text))] += 1;
        }
    }
    assert!(counts[0] > 300, "{counts:?}");
    Figure::Holds("refused or finite")
}
