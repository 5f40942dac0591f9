//! Every treatment of the constraints on a compiled mechanism, chosen in the macro.

use ffrf::mechanism;
use ffrf::mechanism::{Constrained, Treatment};
use ffrf::{GeneralisedAlpha, Tolerances, VectorSpace, step_rk4};
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::tolerances::SLOPE;

use crate::bodies::{BIG_END, Rod};

/// How long the pendulum swings: some seventy radians of its highest mode. Units: s.
const SPAN: f64 = 4e-4;
/// Steps that resolve that mode.
const STEP: f64 = 1e-6;
/// State after that: the phase of the highest mode, by the classical Runge-Kutta method.
const RESOLVED: f64 = 1e-6;

macro_rules! pendulum {
    ($name:ident, $state:ident, $($treatment:tt)*) => {
        mechanism! {
            /// The rod as a pendulum.
            pub struct $name {
                bodies: { rod: Rod },
                gravity: [0.0, -9.81, 0.0],
                joints: { pin: revolute(ground, rod.BIG_END) },
                constraints: $($treatment)*,
                sensors: { load: reaction_force(pin) },
            }
        }

        impl $name {
            /// Level, swinging fast.
            fn level(&self) -> $state {
                let mut state = self.at_rest();
                state.rod.position.x = -BIG_END;
                state.rod.angular_velocity.z = 20.0;
                state.rod.velocity.y = -BIG_END * 20.0;
                state
            }
        }
    };
}

pendulum!(Projected, ProjectedState, projection(iterations: 4, tolerance: 1e-9));
pendulum!(Drawn, DrawnState, baumgarte(alpha: 2e5, beta: 2e5));
pendulum!(Index3, Index3State, index3);
pendulum!(Stabilised, StabilisedState, ggl);

/// The exact end, by small steps with projection: all numbers of the state.
fn exact() -> [f64; 21] {
    let model = Projected::new(Rod);
    let mut state = model.level();
    let steps = 2000;
    for k in 0..steps {
        let h = SPAN / f64::from(steps);
        state = step_rk4(&Constrained(&model), &state, f64::from(k) * h, h).unwrap().0;
    }
    state.to_array()
}

fn apart(found: &[f64; 21], exact: &[f64; 21]) -> f64 {
    found.iter().zip(exact).fold(0.0_f64, |most, (found, exact)| most.max((found - exact).abs()))
}

#[test]
fn the_macro_sets_what_it_says() {
    assert_eq!(Projected::new(Rod).treatment, Treatment::Projection { iterations: 4, tolerance: 1e-9 });
    assert_eq!(Drawn::new(Rod).treatment, Treatment::Baumgarte { alpha: 2e5, beta: 2e5 });
    assert_eq!(Index3::new(Rod).treatment, Treatment::Index3);
    assert_eq!(Stabilised::new(Rod).treatment, Treatment::StabilisedIndex2);
}

#[test]
fn projection_meets_the_joint_after_every_step() {
    let model = Projected::new(Rod);
    let mut mechanism = model.in_motion(model.level());
    for _ in 0..400 {
        mechanism.step_rk4(STEP).unwrap();
        let again = Constrained(&model).project(mechanism.time, mechanism.state, None, 0, 1.0).unwrap().1;
        assert!(again.position < 1e-14 && again.velocity < 1e-11, "{again:?}");
    }
    assert!(apart(&mechanism.state.to_array(), &exact()) < RESOLVED);
}

#[test]
fn baumgarte_draws_an_open_joint_together() {
    let model = Drawn::new(Rod);
    let mut state = model.level();
    state.rod.position.y += 1e-5;
    let mut mechanism = model.in_motion(state);
    let mut last = 0.0;
    for _ in 0..400 {
        last = mechanism.step_rk4(STEP).unwrap().drift.position;
    }
    // 1e-5 · e^(-80) is nothing: what stays is the balance of drift and pull
    assert!(last < 1e-10, "{last:.2e}");
    let mut mechanism = model.in_motion(model.level());
    for _ in 0..400 {
        mechanism.step_rk4(STEP).unwrap();
    }
    assert!(apart(&mechanism.state.to_array(), &exact()) < RESOLVED);
}

macro_rules! alpha_run {
    ($model:ident, $steps:expr) => {{
        let model = $model::new(Rod);
        let method = GeneralisedAlpha {
            tolerances: Tolerances { relative: 1e-13, absolute: 1e-14 },
            ..GeneralisedAlpha::new()
        };
        let (system, h) = (Constrained(&model), SPAN / $steps as f64);
        let mut state = model.level();
        let mut memory = method.start(&system, &state, 0.0, h).unwrap();
        let mut drift = [0.0_f64; 2];
        for k in 0..$steps {
            let (next, report) = method.step(&system, &mut memory, &state, k as f64 * h, h).unwrap();
            state = next;
            drift = [drift[0].max(report.drift.position), drift[1].max(report.drift.velocity)];
        }
        (state.to_array(), drift)
    }};
}

#[test]
fn index_3_holds_places_and_converges_with_order_two() {
    let exact = exact();
    let order = measured_order(400, 2, |steps| apart(&alpha_run!(Index3, steps).0, &exact));
    assert!((order - 2.0).abs() < 2.0 * SLOPE, "{order}");
    let (_, [position, velocity]) = alpha_run!(Index3, 400);
    assert!(position < 1e-12, "{position:.2e}");
    assert!(velocity > 1e-11, "nothing holds velocities: {velocity:.2e}");
}

#[test]
fn stabilised_index_2_holds_both_and_converges_with_order_two() {
    let exact = exact();
    let order = measured_order(400, 2, |steps| apart(&alpha_run!(Stabilised, steps).0, &exact));
    assert!((order - 2.0).abs() < 2.0 * SLOPE, "{order}");
    let (_, [position, velocity]) = alpha_run!(Stabilised, 400);
    let (_, [_, loose]) = alpha_run!(Index3, 400);
    assert!(position < 1e-12 && velocity < 0.1 * loose, "{position:.2e} {velocity:.2e} {loose:.2e}");
}

#[test]
fn increments_of_models_are_vectors() {
    let model = Index3::new(Rod);
    let mut change = ffrf::System::no_change(&Constrained(&model), &model.level());
    change.rod.velocity.x = 1.0;
    change.scale(3.0);
    assert_eq!(change.rod.velocity.x, 3.0);
}
