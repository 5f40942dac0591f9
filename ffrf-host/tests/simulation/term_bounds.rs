//! What a term of the kinetic energy can contribute at most: no state within the limits exceeds it, and states come near it.
#![allow(clippy::unwrap_used, clippy::panic)] // helpers of tests are tests

use ffrf_codegen::Fidelity;
use ffrf_codegen::fidelity::EnergyTerm;
use ffrf_host::scene::file::SceneFile;
use ffrf_host::tradeoff::{
    Finding, MotionLimits, PlanOptions, Quantity, Reference, ReferenceOptions, Study, plan, run, term_bound,
};
use ffrf_host::{HostBody, HostModal};
use ffrf_model::ReducedBody;
use ffrf_runtime::{FlexibleBody, GeneralisedForce, Motion};
use ffrf_test_kit::random::Random;
use ffrf_test_kit::random_body::{Modes, random_body, stiffened};
use nalgebra::{DVector, Vector3};
use std::path::Path;

/// Sums of numbers of order one, in two orders.
const ROUND_OFF: f64 = 1e-11;
/// A bound adds the sizes of up to four products, whose directions never agree all at once: the nearest of some thousand random
/// states reaches this share of it, for a body of one mode.
const NEAR: f64 = 0.15;
/// What a plan may exceed its prediction by.
const OVER_PREDICTION: f64 = 2.0;

/// A random state within limits: directions are random, sizes often at their limit.
struct Sample {
    q: HostModal,
    q_dot: HostModal,
    omega: Vector3<f64>,
    motion: Motion<HostModal, f64>,
}

fn sample(random: &mut Random, limits: &MotionLimits) -> Sample {
    let mut vector = |size: f64| {
        let direction = Vector3::from(random.vector());
        direction * (size / direction.norm().max(1e-3))
    };
    let (omega, linear, angular) =
        (vector(limits.spin), vector(limits.acceleration), vector(limits.spin_rate));
    let mut modal = |sizes: &[f64]| {
        let numbers = sizes.iter().map(|size| {
            let number = random.number();
            size * (2.0 * number).clamp(-1.0, 1.0)
        });
        HostModal(DVector::from_iterator(sizes.len(), numbers.collect::<Vec<_>>()))
    };
    Sample {
        q: modal(&limits.coordinates),
        q_dot: modal(&limits.rates),
        motion: Motion { linear, angular, modal: modal(&limits.accelerations) },
        omega,
    }
}

fn inertia_force(body: &HostBody, at: &Sample) -> GeneralisedForce<HostModal> {
    let prepared = body.prepare(&at.q, &at.omega, &at.q_dot);
    let mut force = prepared.mass_times(&body.modal_mass(), &at.motion);
    force.add_scaled(1.0, &prepared.quadratic_velocity);
    force
}

fn bodies() -> Vec<(String, ReducedBody)> {
    let mut bodies = Vec::new();
    for (name, modes) in
        [("random", Modes::Random), ("normalised", Modes::Normalised), ("free-free", Modes::FreeFree)]
    {
        for count in [1, 3] {
            let body = random_body(7 + count as u64, count, modes);
            bodies.push((format!("{name}, {count}"), body.clone()));
            bodies.push((format!("{name}, {count}, stiffened"), stiffened(body, 5, 0.05)));
        }
    }
    bodies
}

#[test]
fn no_state_within_the_limits_exceeds_the_bound_of_a_term() {
    for (seed, (name, model)) in bodies().into_iter().enumerate() {
        let mut random = Random::new(100 + seed as u64);
        let modes = model.mode_count();
        let whole = HostBody::new(&model, &Fidelity::Full);
        let mut size = |least: f64| least + 0.5 * (1.0 + random.number().clamp(-1.0, 1.0));
        let limits = MotionLimits {
            acceleration: size(0.1),
            spin: size(0.3),
            spin_rate: size(0.0),
            coordinates: (0..modes).map(|_| size(0.1)).collect(),
            rates: (0..modes).map(|_| size(0.1)).collect(),
            accelerations: (0..modes).map(|_| size(0.1)).collect(),
        };
        for term in EnergyTerm::ALL.into_iter().filter(|term| !term.is_always_kept()) {
            let others = EnergyTerm::ALL.into_iter().filter(|other| *other != term);
            let without = HostBody::new(&model, &Fidelity::Terms(others.collect()));
            let bound = term_bound(&model, term, &limits);
            let mut nearest = 0.0_f64;
            let mut is_there = false;
            for _ in 0..2000 {
                let at = sample(&mut random, &limits);
                let (all, rest) = (inertia_force(&whole, &at), inertia_force(&without, &at));
                let mut check = |what: &str, all: f64, found: f64, bound: f64| {
                    let allowed = bound + ROUND_OFF * (1.0 + all);
                    assert!(found <= allowed, "{name}, {}: {what} {found} of at most {bound}", term.name());
                    if bound > ROUND_OFF {
                        is_there = true;
                        nearest = nearest.max(found / bound);
                    }
                };
                check("force", all.force.norm(), (all.force - rest.force).norm(), bound.force);
                check("moment", all.moment.norm(), (all.moment - rest.moment).norm(), bound.moment);
                for mode in 0..modes {
                    let difference = (all.modal.0[mode] - rest.modal.0[mode]).abs();
                    check("on a mode", all.modal.0[mode].abs(), difference, bound.modal[mode]);
                }
            }
            // a body of one mode: no sum over modes, whose signs never agree
            if modes == 1 && is_there {
                assert!(nearest > NEAR, "{name}, {}: at most {nearest} of the bound", term.name());
            }
        }
    }
}

fn study(name: &str, duration: f64, samples: f64) -> Study {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../models/scenes");
    let mut file = SceneFile::read(&scenes.join(name)).unwrap();
    file.simulation.duration = duration;
    file.simulation.output_step = Some(duration / samples);
    Study::new(file, scenes).unwrap()
}

/// Bounds from a plan's own run hold in a run whose samples are others and seven times as many, and what is dropped costs no more
/// than was said.
#[test]
fn bounds_of_a_plan_hold_in_a_closer_look_and_dropping_costs_no_more_than_was_said() {
    let cases = [
        ("tumbling_rod.toml", 4.0, 1e-4, vec![]),
        ("slider_crank.toml", 4e-3, 3e-2, vec![Quantity::Sensor("bearing".to_owned())]),
        ("flexible_pendulum.toml", 0.01, 1e-3, vec![]),
    ];
    for (name, duration, error, quantities) in cases {
        let coarse = study(name, duration, 29.0);
        let options = PlanOptions { quantities: quantities.clone(), ..PlanOptions::usual(error) };
        let found = plan(&coarse, &options).unwrap();
        // the same motion, looked at elsewhere
        let close = study(name, duration, 7.0 * 29.0 - 6.0);
        let closer = plan(&close, &PlanOptions { error: 1e3 * error, ..options.clone() }).unwrap();
        assert!(!found.motion.terms.is_empty(), "{name}");
        for (bound, reached) in found.motion.terms.iter().zip(&closer.motion.terms) {
            assert_eq!((&bound.body, &bound.terms), (&reached.body, &reached.terms));
            for block in 0..3 {
                let (most, is) = (bound.bound[block], reached.reached[block]);
                assert!(is <= most + 1e-9, "{name}, {}, block {block}: {is} of {most}", bound.name());
            }
        }
        let tolerance = 0.1 * found.reference.tolerance;
        let reference = Reference::compute(&coarse, &quantities, ReferenceOptions { tolerance }).unwrap();
        let one = &found.configuration;
        let variant = coarse.variant(&one.modes, &one.fidelity).unwrap();
        let Finding::Finished(measured) = run(&coarse, &variant, &reference, one).finding else {
            panic!("{name}: {one:?} fails");
        };
        eprintln!(
            "{name}: {} predicted {:.2e}, measured {:.2e}",
            one.key(),
            found.predicted_error,
            measured.error()
        );
        assert!(measured.error() <= OVER_PREDICTION * found.predicted_error, "{name}: {}", measured.error());
        // what the dropped modes move is what the model loses, where places are asked for
        for truncation in &found.truncations {
            assert!(
                truncation.with_static_correction <= truncation.lost * 1.5 + 1e-12,
                "{name}: {truncation:?}"
            );
        }
    }
}
