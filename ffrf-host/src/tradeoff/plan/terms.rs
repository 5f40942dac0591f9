//! How large the terms of the kinetic energy are in a motion: bounded before, and as they are.

use ffrf_codegen::Fidelity;
use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_model::{ReducedBody, SecondOrderTerms};
use ffrf_runtime::{FlexibleBody, GeneralisedForce, Motion, Observables, State};

use super::super::bounds::{ForceSize, term_bound};
use super::super::held::TOGETHER;
use super::super::{MotionLimits, Study, TradeoffError};
use super::track::Track;
use crate::{HostBody, HostModal};

/// How large a term of the kinetic energy is in a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct TermUse {
    /// Name of the body.
    pub body: String,
    /// The term; of a body that holds only the sum of two, both.
    pub terms: Vec<EnergyTerm>,
    /// Its largest size over the largest kinetic energy of the body: what the equations lose without it.
    pub share: f64,
    /// The most that it can contribute to the force on the frame, the moment about its origin and the forces on the modes,
    /// over the largest that any term, gravity with it, or the stiffness reaches there; from the limits of the motion alone.
    pub bound: [f64; 3],
    /// What it contributes at most at the times that are known, over the same.
    pub reached: [f64; 3],
}

impl TermUse {
    /// Its name; of two, joined by `with`.
    pub fn name(&self) -> String {
        self.terms.iter().map(|term| term.name()).collect::<Vec<_>>().join(" with ")
    }

    /// Whether a fidelity keeps it.
    pub fn is_kept_by(&self, fidelity: &Fidelity) -> bool {
        self.terms.iter().all(|term| fidelity.keeps(*term))
    }

    /// The largest of its bounds.
    pub fn largest_bound(&self) -> f64 {
        self.bound.iter().copied().fold(0.0, f64::max)
    }

    /// The largest of its contributions.
    pub fn largest_reached(&self) -> f64 {
        self.reached.iter().copied().fold(0.0, f64::max)
    }
}

/// The terms of a fidelity that a body can leave out, each by itself where the body knows it by itself.
fn optional(richest: &Fidelity, held: SecondOrderTerms) -> Vec<Vec<EnergyTerm>> {
    let is_together = held == SecondOrderTerms::Together;
    let terms = richest.terms().filter(|term| !term.is_always_kept());
    let alone = terms.filter(|term| !(is_together && TOGETHER.contains(term))).map(|term| vec![term]);
    let both = is_together && TOGETHER.iter().all(|term| richest.keeps(*term));
    alone.chain(both.then(|| TOGETHER.to_vec())).collect()
}

/// Every term of a body that it holds and that can be left out.
pub(super) fn term_uses(
    study: &Study,
    index: usize,
    model: &ReducedBody,
    name: &str,
    track: &Track,
    limits: &MotionLimits,
) -> Result<Vec<TermUse>, TradeoffError> {
    let richest = study.richest();
    let whole = study.body_with(index, &richest)?;
    let kinetic =
        |body: &HostBody| -> Vec<f64> { track.states.iter().map(|state| kinetic(body, state)).collect() };
    let forces = |body: &HostBody| -> Vec<GeneralisedForce<HostModal>> {
        let steps = track.states.iter().zip(&track.accelerations).zip(&track.gravity);
        steps.map(|((state, motion), gravity)| inertia_force(body, state, motion, gravity)).collect()
    };
    let (energies, all) = (kinetic(&whole), forces(&whole));
    let largest_energy = energies.iter().copied().fold(f64::MIN_POSITIVE, f64::max);
    let weights = Weights::of(&whole);
    let sizes = |force: &GeneralisedForce<HostModal>| {
        [force.force.norm(), force.moment.norm(), weights.norm(force.modal.0.as_slice())]
    };
    let modes = model.mode_count();
    let mut uses = Vec::new();
    // what is left of all when the optional terms are taken away: the forces are a sum over terms, as the energy is
    let mut always = all.clone();
    let mut scale = [0.0; 3];
    for terms in optional(&richest, model.second_order_terms) {
        let others = richest.terms().filter(|other| !terms.contains(other));
        let without = study.body_with(index, &Fidelity::Terms(others.collect()))?;
        let size = energies.iter().zip(kinetic(&without)).map(|(all, without)| (all - without).abs());
        let lost: Vec<GeneralisedForce<HostModal>> = all
            .iter()
            .zip(forces(&without))
            .map(|(all, without)| {
                let mut difference = all.clone();
                difference.add_scaled(-1.0, &without);
                difference
            })
            .collect();
        for (rest, lost) in always.iter_mut().zip(&lost) {
            rest.add_scaled(-1.0, lost);
        }
        let reached = largest(lost.iter().map(sizes));
        scale = larger(scale, reached);
        let bounds = terms.iter().map(|term| term_bound(model, *term, limits));
        let ForceSize { force, moment, modal } =
            bounds.fold(ForceSize::nothing(modes), |sum, one| sum.plus(&one));
        uses.push(TermUse {
            body: name.to_owned(),
            terms,
            share: size.fold(0.0, f64::max) / largest_energy,
            bound: [force, moment, weights.norm(&modal)],
            reached,
        });
    }
    scale = larger(scale, largest(always.iter().map(sizes)));
    let elastic = track.states.iter().map(|state| {
        let force = whole.internal_force(&state.modal_coordinates, &state.modal_rates);
        [0.0, 0.0, weights.norm(force.0.as_slice())]
    });
    scale = larger(scale, largest(elastic)).map(|size| size.max(f64::MIN_POSITIVE));
    for one in &mut uses {
        for block in 0..3 {
            one.bound[block] /= scale[block];
            one.reached[block] /= scale[block];
        }
    }
    Ok(uses)
}

/// Forces on modes as one number: Σ f²/k, twice the energy that they would store by themselves; where a mode has no stiffness of
/// its own, Σ f²/m takes its place for all.
struct Weights(Vec<f64>);

impl Weights {
    fn of(body: &HostBody) -> Self {
        let diagonal = |matrix: ffrf_runtime::ModalMatrix<HostModal, f64>| matrix.dense().diagonal();
        let (stiffness, mass) = (diagonal(body.stiffness()), diagonal(body.modal_mass()));
        let over = if stiffness.iter().all(|k| *k > 0.0) { stiffness } else { mass };
        Self(over.iter().map(|x| if *x > 0.0 { 1.0 / x } else { 0.0 }).collect())
    }

    fn norm(&self, forces: &[f64]) -> f64 {
        self.0.iter().zip(forces).map(|(weight, force)| weight * force * force).sum::<f64>().sqrt()
    }
}

fn largest(sizes: impl Iterator<Item = [f64; 3]>) -> [f64; 3] {
    sizes.fold([0.0; 3], larger)
}

fn larger(first: [f64; 3], second: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|block| f64::max(first[block], second[block]))
}

fn kinetic(body: &HostBody, state: &State<HostModal>) -> f64 {
    let velocity = state.body_velocity();
    body.kinetic_energy(&state.modal_coordinates, &velocity, &state.angular_velocity, &state.modal_rates)
}

/// What inertia and gravity ask for in a motion: M (w - g) + Q.
fn inertia_force(
    body: &HostBody,
    state: &State<HostModal>,
    acceleration: &Motion<HostModal, f64>,
    gravity: &nalgebra::Vector3<f64>,
) -> GeneralisedForce<HostModal> {
    let prepared = body.prepare(&state.modal_coordinates, &state.angular_velocity, &state.modal_rates);
    let mut felt = acceleration.clone();
    felt.linear -= gravity;
    let mut force = prepared.mass_times(&body.modal_mass(), &felt);
    force.add_scaled(1.0, &prepared.quadratic_velocity);
    force
}
