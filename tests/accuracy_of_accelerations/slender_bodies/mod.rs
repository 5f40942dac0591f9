//! Accelerations of very slender bodies, compared with exact arithmetic: what the elimination of a slender inertia costs.
//!
//! `cargo test -p ffrf --test accuracy_of_accelerations slender -- --nocapture` prints the figures.
#![allow(clippy::unwrap_used)] // helpers of tests are tests

mod body;
mod exact_motion;
mod tolerances;

use self::body::slender_body;
use self::exact_motion::{Errors, ExactMotion, Force};
use self::tolerances::{ACCELERATION, FACTORISED};
use ffrf::nalgebra::{DMatrix, DVector, Rotation3, Vector3};
use ffrf_codegen::{GenerateOptions, Kernels, Strategy, lanes};
use ffrf_host::kernels::lane_kernels;
use ffrf_test_kit::random::Random;

/// A state at which the body is still slender: deformed by no more than its thickness.
pub struct Point {
    q: Vec<f64>,
    q_dot: Vec<f64>,
    omega: [f64; 3],
}

/// The worst errors over some states of one body: statements, loops over lanes, a Cholesky factorisation of M(q).
struct Found {
    condition: f64,
    statements: Errors,
    /// `None` without modes.
    loops: Option<Errors>,
    factorised: Errors,
}

fn measure(modes: usize, thickness: f64, turn: &Rotation3<f64>, applied: Force) -> Found {
    let body = slender_body(31, modes, thickness, turn);
    // The modes are orthonormal up to the rounding of the turn.
    let options = GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() };
    let kernels = Kernels::formulate(&body, &options).unwrap();
    // There are no lanes over no modes.
    let in_lanes = GenerateOptions { strategy: Strategy::Lanes, ..options };
    let tables = (modes > 0).then(|| lanes::tables_of(&body, &in_lanes).unwrap().unwrap());
    let loops = tables.as_ref().map(|tables| lane_kernels(tables).unwrap());
    let mut found =
        Found { condition: 0.0, statements: Errors::default(), loops: None, factorised: Errors::default() };
    for seed in 1..4 {
        let mut random = Random::new(seed);
        let point = Point {
            q: random.numbers(modes).iter().map(|x| thickness * x).collect(),
            q_dot: random.numbers(modes),
            omega: random.vector(),
        };
        let Point { q, q_dot, omega } = &point;
        let motion = ExactMotion::new(&kernels, &point, applied, &random.numbers(6 + modes));
        found.condition = found.condition.max(motion.condition());
        let errors = |acceleration: &[f64]| motion.errors(acceleration, &(turn * Vector3::x()));

        let force = &motion.force;
        found.statements.widen(errors(&kernels.forward_dynamics(q, omega, q_dot, force)));

        if let Some(loops) = &loops {
            found
                .loops
                .get_or_insert_default()
                .widen(errors(&loops.forward_dynamics(q, *omega, q_dot, force)));
        }

        let internal = kernels.internal_force(q, q_dot);
        let mut net = force.clone();
        net.iter_mut().skip(6).zip(&internal).for_each(|(net, internal)| *net -= internal);
        let quadratic = kernels.quadratic_velocity(q, omega, q_dot);
        net.iter_mut().zip(&quadratic).for_each(|(net, quadratic)| *net -= quadratic);
        let columns = kernels.mass_matrix(q).concat();
        let factors = DMatrix::from_vec(net.len(), net.len(), columns).cholesky().unwrap();
        found.factorised.widen(errors(factors.solve(&DVector::from_vec(net)).as_slice()));
    }
    found
}

fn compare(frame: &str, turn: &Rotation3<f64>) {
    for (modes, thickness) in [(0, 1e-3), (0, 1e-4), (2, 1e-3), (2, 1e-4), (8, 1e-3), (8, 1e-4)] {
        for applied in [Force::Any, Force::OfModerateAccelerations] {
            let found = measure(modes, thickness, turn, applied);
            let case = format!("{frame}, M = {modes}, thickness {thickness:e}, {applied:?}");
            println!("{case}, condition {:.1e}", found.condition);
            // Rounding of the elimination, and of the right-hand side: see the table of tolerances.
            let unit = f64::EPSILON * (found.condition + 1.0 / thickness);
            let forms = [("statements", found.statements), ("factorised", found.factorised)];
            for (form, errors) in forms.into_iter().chain(found.loops.map(|errors| ("loops", errors))) {
                println!("    {form:10} {errors}");
                let most = ACCELERATION * unit;
                assert!(errors.forward <= most, "{case}, {form}: {errors}, at most {most:.1e}");
                assert!(errors.backward <= most, "{case}, {form}: {errors}, at most {most:.1e}");
            }
            let most = FACTORISED * f64::EPSILON / thickness;
            assert!(found.factorised.backward <= most, "{case}: {}, at most {most:.1e}", found.factorised);
        }
    }
}

#[test]
fn a_frame_along_the_body_costs_no_digits() {
    compare("along the body", &Rotation3::identity());
}

#[test]
fn a_frame_askew_costs_the_digits_of_the_condition_number() {
    compare("askew", &Rotation3::from_euler_angles(0.7, -0.5, 0.9));
}
