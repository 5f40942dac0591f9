//! A point of a co-simulation as a list of numbers, and back, bit by bit.

use ffrf_runtime::{AlphaMemory, Increment, State};
use nalgebra::{DVector, Quaternion, UnitQuaternion, Vector3};

use super::one_step::States;
use super::{Advance, Point};
use crate::mechanism::HostIncrement;
use crate::scene::Scene;
use crate::{HostBody, HostModal};

impl Point {
    /// All its numbers; their meaning is known to [`Point::from_numbers`] alone.
    pub fn to_numbers(&self) -> Vec<f64> {
        let mut list = Vec::new();
        let (start, count) = self.advance.grid();
        // counts of steps stay below 2⁵³
        list.extend([start, count as f64, self.advance.next_step, self.advance.time]);
        put_states(&mut list, &self.advance.state);
        put_memory(&mut list, self.advance.memory.as_ref());
        list.push(self.time);
        put_states(&mut list, &self.state);
        put_memory(&mut list, self.memory.as_ref());
        for optional in self.angles.iter().chain(&self.inputs) {
            put_optional(&mut list, *optional);
        }
        list.extend(&self.left);
        list.extend([self.begin, f64::from(u8::from(self.stopped))]);
        list
    }

    /// The point of a scene whose numbers these are; none if they are more or fewer.
    pub fn from_numbers(scene: &Scene, numbers: &[f64]) -> Option<Self> {
        let modes: Vec<usize> = scene.mechanism.bodies().iter().map(HostBody::mode_count).collect();
        let mut reader = Reader { numbers, modes: &modes };
        let [start, count, next_step, time] = reader.array()?;
        let state = reader.states()?;
        let mut advance = Advance::new(&scene.settings, time, state.clone());
        advance.take_up((start, count as u64), time, next_step);
        advance.memory = reader.memory()?;
        let [time] = reader.array()?;
        let point = Self {
            advance,
            time,
            state: reader.states()?,
            memory: reader.memory()?,
            angles: scene.sensors.iter().map(|_| reader.optional()).collect::<Option<_>>()?,
            inputs: scene.mechanism.actuators().iter().map(|_| reader.optional()).collect::<Option<_>>()?,
            left: scene
                .events
                .iter()
                .map(|_| reader.array::<1>().map(|[left]| left))
                .collect::<Option<_>>()?,
            begin: reader.array::<1>()?[0],
            stopped: reader.array::<1>()?[0] != 0.0,
        };
        reader.numbers.is_empty().then_some(point)
    }
}

fn put_states(list: &mut Vec<f64>, states: &States) {
    for state in states {
        let theta = &state.orientation;
        list.extend_from_slice(state.position.as_slice());
        list.extend([theta.w, theta.i, theta.j, theta.k]);
        list.extend_from_slice(state.modal_coordinates.0.as_slice());
        list.extend_from_slice(state.velocity.as_slice());
        list.extend_from_slice(state.angular_velocity.as_slice());
        list.extend_from_slice(state.modal_rates.0.as_slice());
    }
}

fn put_memory(list: &mut Vec<f64>, memory: Option<&AlphaMemory<HostIncrement>>) {
    list.push(f64::from(u8::from(memory.is_some())));
    for part in memory.into_iter().flat_map(|memory| [&memory.accelerations, &memory.shifted]) {
        for rates in &part.0 {
            list.extend_from_slice(rates.velocity.as_slice());
            list.extend_from_slice(rates.angular_velocity.as_slice());
            list.extend_from_slice(rates.modal_rates.0.as_slice());
        }
    }
}

fn put_optional(list: &mut Vec<f64>, number: Option<f64>) {
    list.extend([f64::from(u8::from(number.is_some())), number.unwrap_or(0.0)]);
}

/// What is left to read, and the number of modes of each body.
struct Reader<'a> {
    numbers: &'a [f64],
    modes: &'a [usize],
}

impl Reader<'_> {
    fn take(&mut self, count: usize) -> Option<&[f64]> {
        let (taken, rest) = self.numbers.split_at_checked(count)?;
        self.numbers = rest;
        Some(taken)
    }

    fn array<const N: usize>(&mut self) -> Option<[f64; N]> {
        self.take(N)?.try_into().ok()
    }

    fn vector(&mut self) -> Option<Vector3<f64>> {
        self.array().map(Vector3::from)
    }

    fn modal(&mut self, count: usize) -> Option<HostModal> {
        self.take(count).map(|numbers| HostModal(DVector::from_column_slice(numbers)))
    }

    fn optional(&mut self) -> Option<Option<f64>> {
        self.array().map(|[is_there, number]: [f64; 2]| (is_there != 0.0).then_some(number))
    }

    fn states(&mut self) -> Option<States> {
        let modes = self.modes;
        modes
            .iter()
            .map(|&modes| {
                let position = self.vector()?;
                let [w, i, j, k] = self.array()?;
                Some(State {
                    position,
                    // not normalised: it was when it was written, and must keep its bits
                    orientation: UnitQuaternion::new_unchecked(Quaternion::new(w, i, j, k)),
                    modal_coordinates: self.modal(modes)?,
                    velocity: self.vector()?,
                    angular_velocity: self.vector()?,
                    modal_rates: self.modal(modes)?,
                })
            })
            .collect()
    }

    fn memory(&mut self) -> Option<Option<AlphaMemory<HostIncrement>>> {
        if self.array::<1>()? == [0.0] {
            return Some(None);
        }
        let accelerations = self.increment()?;
        Some(Some(AlphaMemory { accelerations, shifted: self.increment()? }))
    }

    fn increment(&mut self) -> Option<HostIncrement> {
        let modes = self.modes;
        let bodies = modes.iter().map(|&modes| {
            let (velocity, angular_velocity) = (self.vector()?, self.vector()?);
            let modal_rates = self.modal(modes)?;
            Some(Increment { velocity, angular_velocity, ..Increment::zeros(&modal_rates) })
                .map(|rates| Increment { modal_rates, ..rates })
        });
        bodies.collect::<Option<_>>().map(HostIncrement)
    }
}
