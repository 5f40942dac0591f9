//! The arrays that the code takes and gives.

use ffrf_codegen::{ArrayInput, InputForm};
use ffrf_runtime::{Increment, State};
use ffrf_trace::Traced;
use nalgebra::{DVector, Quaternion, UnitQuaternion, Vector3};

use super::motions::{Motions, STILL};
use crate::scene::{Scene, StepChoice};
use crate::{HostModal, mechanism::HostIncrement};

/// Numbers between -1 and 1 that look random, the same in every run.
struct Scatter(u64);

impl Scatter {
    fn next(&mut self) -> f64 {
        // the multiplier and increment of Knuth's MMIX
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// γ h of the stage that is run where the scene names no step. Units: s.
const USUAL_GAMMA_H: f64 = 1e-4;

/// Entries of an array one after the other, zeros where nothing moves.
struct Entries<'a> {
    array: &'a ArrayInput,
    moving: core::iter::Enumerate<core::slice::Iter<'a, bool>>,
    /// The sum of the squares of those that are taken as zero.
    still: Traced,
}

impl<'a> Entries<'a> {
    fn of(array: &'a ArrayInput, moving: &'a [bool]) -> Self {
        Self { array, moving: moving.iter().enumerate(), still: Traced::number(0.0) }
    }

    /// The next one: an input with this value if it moves.
    fn next(&mut self, value: f64) -> Traced {
        let zero = Traced::number(0.0);
        let Some((index, is_moving)) = self.moving.next() else { return zero };
        let symbol = self.array.symbol(index);
        if *is_moving {
            return Traced::input(symbol, value);
        }
        let still = Traced::input(symbol, 0.0);
        self.still += still * still;
        zero
    }

    /// Takes for granted that what is taken as zero is.
    fn grant(self) {
        // the comparison is written down
        let _ = self.still <= Traced::number(STILL * STILL);
    }
}

/// State and drives of a scene, and what a linearly implicit stage has besides, entry by entry.
pub(super) struct Arguments {
    pub(super) state: ArrayInput,
    pub(super) drives: ArrayInput,
    pub(super) subtracted: ArrayInput,
    pub(super) gamma_h: ArrayInput,
    /// Number of modes of each body, behind its name.
    bodies: Vec<(String, usize)>,
    motions: Motions,
}

impl Arguments {
    pub(super) fn of(scene: &Scene, motions: &Motions) -> Self {
        let modes = scene.initial.iter().map(|state| state.modal_coordinates.0.len());
        let bodies: Vec<(String, usize)> = scene.body_names.iter().cloned().zip(modes).collect();
        let count = |rigid: usize| bodies.iter().map(|(_, modes)| rigid + 2 * modes).sum();
        let array = |name, entry, count, form| ArrayInput { name, entry, count, form };
        Self {
            state: array("state", "state", count(13), InputForm::Flat),
            drives: array("drives", "drive", 3 * scene.mechanism.drives().len(), InputForm::Nested(3)),
            subtracted: array("subtracted", "subtracted", count(12), InputForm::Flat),
            gamma_h: array("gamma_h", "gamma_h", 1, InputForm::Number),
            bodies,
            motions: motions.clone(),
        }
    }

    /// The documentation of a function: these lines, what does not move, and what is where.
    pub(super) fn documentation(&self, lines: &[&str], arrays: &[(&str, usize, usize)]) -> Vec<String> {
        let lines = lines.iter().map(|line| (*line).to_owned());
        lines.chain(self.motions.documentation()).chain(self.table(arrays)).collect()
    }

    /// What is where, a line for each body; arrays with so many numbers of each of them without modes and for each of its modes.
    fn table(&self, arrays: &[(&str, usize, usize)]) -> Vec<String> {
        let mut first = vec![0; arrays.len()];
        let bodies = self.bodies.iter();
        bodies
            .map(|(name, modes)| {
                let places = arrays.iter().zip(&mut first).map(|((array, rigid, each), first)| {
                    let start = *first;
                    *first += rigid + each * modes;
                    format!("{array} {start}..{first}")
                });
                format!("{name} ({modes} modes): {}", places.collect::<Vec<_>>().join(", "))
            })
            .collect()
    }

    /// The state as inputs, with values `off` those that the scene begins with.
    pub(super) fn state(&self, scene: &Scene, off: f64) -> Vec<State<HostModal<Traced>, Traced>> {
        let mut entries = Entries::of(&self.state, self.motions.of_state());
        let mut scatter = Scatter(1);
        let mut input = |near: f64| entries.next(near + off * scatter.next());
        let vector = |near: &Vector3<f64>, input: &mut dyn FnMut(f64) -> Traced| near.map(input);
        let modal = |near: &HostModal, input: &mut dyn FnMut(f64) -> Traced| HostModal(near.0.map(input));
        let states = scene.initial.iter();
        let states = states
            .map(|state| {
                // the order of evaluation is that of the array
                State {
                    position: vector(&state.position, &mut input),
                    // as it is: what runs keeps it of length one
                    orientation: UnitQuaternion::new_unchecked(Quaternion::from(
                        state.orientation.coords.map(&mut input),
                    )),
                    modal_coordinates: modal(&state.modal_coordinates, &mut input),
                    velocity: vector(&state.velocity, &mut input),
                    angular_velocity: vector(&state.angular_velocity, &mut input),
                    modal_rates: modal(&state.modal_rates, &mut input),
                }
            })
            .collect();
        entries.grant();
        states
    }

    /// What a linearly implicit stage subtracts, as inputs with values `off` zero.
    pub(super) fn subtracted(&self, off: f64) -> HostIncrement<Traced> {
        let (moving, mut scatter) = (self.motions.of_change(), Scatter(2));
        let mut entries = Entries::of(&self.subtracted, &moving);
        let mut input = || entries.next(off * scatter.next());
        let bodies = self.bodies.iter();
        let change = HostIncrement(
            bodies
                .map(|(_, modes)| {
                    let mut zeros =
                        Increment::zeros(&HostModal(DVector::from_element(*modes, Traced::number(0.0))));
                    // the order is that of the array
                    zeros.position.apply(|place| *place = input());
                    zeros.rotation.apply(|place| *place = input());
                    zeros.modal_coordinates.0.apply(|place| *place = input());
                    zeros.velocity.apply(|place| *place = input());
                    zeros.angular_velocity.apply(|place| *place = input());
                    zeros.modal_rates.0.apply(|place| *place = input());
                    zeros
                })
                .collect(),
        );
        entries.grant();
        change
    }

    /// γ h as an input, near the step of the scene.
    pub(super) fn gamma_h(&self, scene: &Scene) -> Traced {
        let near = match scene.settings.step {
            StepChoice::Fixed(step) => step,
            StepChoice::Tolerance(_) => USUAL_GAMMA_H,
        };
        Traced::input(self.gamma_h.symbol(0), near)
    }

    /// Value, rate and acceleration of the drive of each connection as inputs; zeros for those without one.
    pub(super) fn drive_values(&self, scene: &Scene, off: f64) -> Vec<[Traced; 3]> {
        let drives = scene.mechanism.drives().iter().enumerate();
        drives
            .map(|(connection, drive)| match drive {
                None => [Traced::number(0.0); 3],
                Some(drive) => {
                    let values = drive.at(0.0);
                    [0, 1, 2].map(|k| {
                        Traced::input(
                            self.drives.symbol(3 * connection + k),
                            values[k] + off * (k as f64 + 1.0),
                        )
                    })
                }
            })
            .collect()
    }

    /// The accelerations in rates at an increment of zero.
    pub(super) fn results(rates: &HostIncrement<Traced>) -> Vec<Traced> {
        let bodies = rates.0.iter();
        bodies
            .flat_map(|body| {
                body.velocity.iter().chain(&body.angular_velocity).chain(&body.modal_rates.0).copied()
            })
            .collect()
    }
}
