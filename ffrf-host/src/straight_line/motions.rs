//! Which numbers of a state move: what a mechanism does in its plane needs no code for what is out of it.

use ffrf_codegen::expression::{Expression, Graph};
use ffrf_runtime::State;
use nalgebra::RealField;

use crate::HostModal;
use crate::scene::Scene;

/// How large all numbers together may be that are taken as zero, as a norm (m, rad, modal units; 1/s of them): the round-off of
/// motions of 1e3 of these units.
pub(super) const STILL: f64 = 1e-13;

/// The numbers of a state in the order of the arrays, whose orientations are as they are stored: [`State::numbers`] has the scalar first.
pub(super) fn numbers<T: RealField + Copy>(state: &State<HostModal<T>, T>) -> impl Iterator<Item = T> {
    let places = state.position.iter().chain(&state.orientation.coords).chain(&state.modal_coordinates.0);
    let velocities = state.velocity.iter().chain(&state.angular_velocity).chain(&state.modal_rates.0);
    places.chain(velocities).copied()
}

/// Which numbers of the states of a scene code is made for; the others are zero where it holds.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Motions {
    /// For each number of the state, in the order of its array.
    moving: Vec<bool>,
    /// Number of modes of each body.
    modes: Vec<usize>,
}

impl Motions {
    /// All: the code holds in every state.
    pub fn all(scene: &Scene) -> Self {
        Self::starting(scene, |_| true)
    }

    pub(super) fn starting(scene: &Scene, is_moving: impl Fn(f64) -> bool) -> Self {
        let moving = scene.initial.iter().flat_map(numbers).map(is_moving).collect();
        Self { moving, modes: scene.initial.iter().map(|state| state.modal_coordinates.0.len()).collect() }
    }

    /// Whether each number moves.
    pub(super) fn of_state(&self) -> &[bool] {
        &self.moving
    }

    /// Whether each number of a change of the states moves: as the velocities do, places and velocities of each body.
    pub(super) fn of_change(&self) -> Vec<bool> {
        let bodies = self.bodies().map(|(places, velocities)| {
            debug_assert_eq!(
                places.len(),
                velocities.len() + 1,
                "an orientation has a number more than its rate"
            );
            [velocities, velocities].concat()
        });
        bodies.flatten().collect()
    }

    /// Indices of the numbers of the state that are zero, in the order of its array.
    pub fn still(&self) -> impl Iterator<Item = usize> {
        self.moving.iter().enumerate().filter(|(_, moving)| !**moving).map(|(index, _)| index)
    }

    /// What the documentation of a function says of numbers that do not move.
    pub(super) fn documentation(&self) -> Vec<String> {
        let still: Vec<usize> = self.still().collect();
        if still.is_empty() {
            return Vec::new();
        }
        let runs = still.chunk_by(|one, next| one + 1 == *next).map(|run| match run {
            [first, .., last] => format!("{first}..={last}"),
            _ => run.iter().map(usize::to_string).collect(),
        });
        let runs: Vec<String> = runs.collect();
        let mut lines = vec![format!("Zero (together below {STILL:e}) where it holds, of `state`:")];
        lines.extend(runs.chunks(16).map(|line| line.join(", ")));
        lines.push(String::new());
        lines
    }

    /// Places and velocities of each body.
    fn bodies(&self) -> impl Iterator<Item = (&[bool], &[bool])> {
        let mut rest = self.moving.as_slice();
        self.modes.iter().map(move |modes| {
            let (own, others) = rest.split_at(13 + 2 * modes);
            rest = others;
            own.split_at(7 + modes)
        })
    }

    /// Velocities that accelerations lead to, and places that velocities lead to.
    pub(super) fn follow(&mut self, accelerations: &[Expression], graph: &Graph) {
        let is_zero = |expression: &Expression| graph.constant_value(*expression) == Some(0.0);
        let mut accelerations = accelerations.iter();
        let mut rest = self.moving.as_mut_slice();
        for modes in &self.modes {
            let (own, others) = rest.split_at_mut(13 + 2 * modes);
            rest = others;
            let (places, velocities) = own.split_at_mut(7 + modes);
            for (velocity, acceleration) in velocities.iter_mut().zip(accelerations.by_ref()) {
                *velocity |= !is_zero(acceleration);
            }
            let [x, y, z, i, j, k, w, modal_coordinates @ ..] = places else { continue };
            let [u, v, a, p, q, r, modal_rates @ ..] = velocities else { continue };
            for (place, velocity) in [(x, u), (y, v), (z, a)] {
                *place |= *velocity;
            }
            for (place, velocity) in modal_coordinates.iter_mut().zip(modal_rates) {
                *place |= *velocity;
            }
            // the rates of the numbers of an orientation, and what they lead to
            for _ in 0..4 {
                *i |= (*w & *p) | (*j & *r) | (*k & *q);
                *j |= (*w & *q) | (*k & *p) | (*i & *r);
                *k |= (*w & *r) | (*i & *q) | (*j & *p);
                *w |= (*i & *p) | (*j & *q) | (*k & *r);
            }
        }
    }
}
