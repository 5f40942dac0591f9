//! The arrays that the code takes and gives.

use ffrf_codegen::ArrayInput;
use ffrf_runtime::State;
use ffrf_trace::Traced;
use nalgebra::{Quaternion, UnitQuaternion, Vector3};

use crate::scene::Scene;
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

/// State and drives of a scene, entry by entry.
pub(super) struct Arguments {
    pub(super) state: ArrayInput,
    pub(super) drives: ArrayInput,
    /// What is where, a line for each body.
    pub(super) table: Vec<String>,
}

impl Arguments {
    pub(super) fn of(scene: &Scene) -> Self {
        let modes: Vec<usize> = scene.initial.iter().map(|state| state.modal_coordinates.0.len()).collect();
        let drives = scene.mechanism.drives();
        let (mut first, mut result) = (0, 0);
        let table = scene.body_names.iter().zip(&modes).map(|(name, modes)| {
            let line = format!(
                "{name} ({modes} modes): state {first}..{}, accelerations {result}..{}",
                first + 13 + 2 * modes,
                result + 6 + modes
            );
            (first, result) = (first + 13 + 2 * modes, result + 6 + modes);
            line
        });
        Self {
            table: table.collect(),
            state: ArrayInput {
                name: "state",
                entry: "state",
                count: modes.iter().map(|modes| 13 + 2 * modes).sum(),
                inner: None,
            },
            drives: ArrayInput { name: "drives", entry: "drive", count: 3 * drives.len(), inner: Some(3) },
        }
    }

    /// The state as inputs, with values `off` those that the scene begins with.
    pub(super) fn state(&self, scene: &Scene, off: f64) -> Vec<State<HostModal<Traced>, Traced>> {
        let (mut index, mut scatter) = (0, Scatter(1));
        let mut input = |near: f64| {
            let input = Traced::input(self.state.symbol(index), near + off * scatter.next());
            index += 1;
            input
        };
        let vector = |near: &Vector3<f64>, input: &mut dyn FnMut(f64) -> Traced| near.map(input);
        let modal = |near: &HostModal, input: &mut dyn FnMut(f64) -> Traced| HostModal(near.0.map(input));
        let states = scene.initial.iter();
        states
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
            .collect()
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
