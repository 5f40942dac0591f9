//! What `ffrf generate SCENE` prints, compiled as it is: `tests/golden/straight_*.rs`, which a test of ffrf-cli compares with
//! what the command prints.

/// The slider-crank of `models/scenes`, with a drive, four modes and redundant rows; every operation as the equations have it.
mod slider_crank {
    include!("../golden/straight_slider_crank.rs");
}

/// The double pendulum of `models/scenes`: a tree, with products contracted where the target has that; and its
/// linearly implicit stages.
mod double_pendulum {
    include!("../golden/straight_double_pendulum.rs");
}

/// The rotor of `benches/mechanisms/scenes` on two soft supports, with its linearly implicit stages.
mod supported_rotor {
    include!("../golden/straight_supported_rotor.rs");
}

use double_pendulum::DoublePendulum;
use ffrf::mechanism::{Assembly, Constrained, Loaded, Mechanism, Treatment};
use ffrf::nalgebra::{UnitQuaternion, Vector3};
use ffrf::{GeneralisedAlpha, RadauIIA, step_linearly_implicit, step_linearly_implicit_euler};
use slider_crank::{Rod, SliderCrank};
use supported_rotor::SupportedRotor;

/// Rounded in another order, relative to the accelerations: stiffness and reactions are some thousand times those.
const ROUND_OFF: f64 = 1e-9;

/// The same of corrections, whose equations have condition numbers of some thousands. Units: m; m/s.
const PROJECTED: f64 = 1e-12;

/// Radius of the crank, as in `models/scenes/slider_crank.toml`. Units: m.
const RADIUS: f64 = 0.04;
/// What the rod is stretched and bent by, at most. Units: m.
const ELASTIC: f64 = 2e-5;

fn turning() -> Mechanism<SliderCrank> {
    let model = SliderCrank::new(Rod);
    let mut state = model.at_rest();
    let length = Rod::SMALL_END.position.x - Rod::BIG_END.position.x;
    state.rod.position = Vector3::new(RADIUS - Rod::BIG_END.position.x, 0.0, 0.0);
    state.piston.position = Vector3::new(RADIUS + length, 0.0, 0.0);
    let mut mechanism = model.in_motion(state);
    mechanism.assemble().unwrap();
    mechanism
}

#[test]
fn a_slider_crank_turns_by_straight_line_code() {
    let mut mechanism = turning();
    let length = Rod::SMALL_END.position.x - Rod::BIG_END.position.x;
    for step in 0..2000 {
        mechanism.step_rk4(2e-6).unwrap();
        if step % 50 == 49 {
            // some: the code held here, and was used
            let difference = mechanism.straight_difference().unwrap();
            assert!(difference < ROUND_OFF, "{difference:e} after {step} steps");
        }
    }
    let angle = 100.0 * mechanism.time;
    let rigid = RADIUS * angle.cos() + (length * length - (RADIUS * angle.sin()).powi(2)).sqrt();
    let found = mechanism.model.stroke(&mechanism.state).x;
    assert!((found - rigid).abs() < ELASTIC, "{found} {rigid}");
}

#[test]
fn a_slider_crank_is_projected_by_straight_line_code() {
    let mut mechanism = turning();
    for _ in 0..100 {
        mechanism.step_rk4(2e-6).unwrap();
    }
    let mut state = mechanism.state;
    state.crank.position.x += 1e-6;
    state.rod.velocity.y += 1e-3;
    let projected = mechanism.model.straight_projection(mechanism.time, &state, None).unwrap();
    let (expected, drift) =
        Constrained(&mechanism.model).project(mechanism.time, state, None, 1, 1e-6).unwrap();
    let [position, velocity] = projected.before;
    assert!((position - drift.position).abs() <= PROJECTED && position > 1e-7, "{position:e}");
    assert!((velocity - drift.velocity).abs() <= PROJECTED && velocity > 1e-4, "{velocity:e}");
    for (found, expected) in [
        (projected.state.rod.position, expected.rod.position),
        (projected.state.crank.position, expected.crank.position),
        (projected.state.rod.velocity, expected.rod.velocity),
        (projected.state.piston.velocity, expected.piston.velocity),
    ] {
        assert!((found - expected).norm() <= PROJECTED, "{found} {expected}");
    }
    assert!(projected.after[0] < 1e-10 && projected.after[1] < 1e-6, "{:?}", projected.after);
}

#[test]
fn where_straight_line_code_does_not_hold_the_equations_say_why() {
    let mut mechanism = turning();
    mechanism.state.rod.modal_coordinates[0] = f64::NAN;
    assert_eq!(mechanism.straight_difference(), None);
    mechanism.step_rk4(2e-6).unwrap_err();
}

#[test]
fn a_double_pendulum_keeps_its_energy_by_straight_line_code() {
    let mut mechanism = falling();
    let before = mechanism.energy();
    let total = |mechanism: &Mechanism<DoublePendulum>| {
        let energy = mechanism.energy();
        energy.kinetic + energy.elastic + energy.potential
    };
    let start = total(&mechanism);
    for _ in 0..1000 {
        mechanism.step_rk4(1e-3).unwrap();
        let difference = mechanism.straight_difference().unwrap();
        assert!(difference < ROUND_OFF, "{difference:e}");
    }
    let kinetic = mechanism.energy().kinetic;
    assert!(kinetic > 1e-2, "it moves: {kinetic} J, {before:?} before");
    // of order four: (h ω)^4 ω T of some joules
    assert!((total(&mechanism) - start).abs() < 1e-6, "{} {start}", total(&mechanism));
}

/// A double pendulum that falls.
fn falling() -> Mechanism<DoublePendulum> {
    let model = DoublePendulum::new();
    let mut state = model.at_rest();
    let turned = UnitQuaternion::from_axis_angle(&Vector3::z_axis(), 0.7);
    state.upper.orientation = turned;
    state.lower.orientation = turned;
    state.lower.position = turned * Vector3::new(1.0, 0.0, 0.0);
    let mut mechanism = model.in_motion(state);
    mechanism.assemble().unwrap();
    mechanism
}

/// A rotor that whirls.
fn whirling() -> Mechanism<SupportedRotor> {
    let model = SupportedRotor::new();
    let mut state = model.at_rest();
    state.rotor.angular_velocity.z = 600.0;
    state.rotor.velocity.x = 0.05;
    model.in_motion(state)
}

/// Advances with straight-line code and, as a load that is none makes of the same model, by the general equations.
fn advances_by_implicit_stages<A: Assembly<f64, State: Copy>>(
    mut mechanism: Mechanism<A>,
    step: f64,
    position: impl Fn(&A::State) -> Vector3<f64>,
) {
    let mut general = mechanism.state;
    let start = position(&general);
    for count in 0..400 {
        // some: the code held here, and was used
        let difference = mechanism.straight_implicit_difference(0.3 * step).unwrap();
        assert!(difference < ROUND_OFF, "{difference:e} after {count} steps");
        let Mechanism { model, state, time } = &mechanism;
        let loaded = Loaded::new(model, |_: &A, _, _: &mut A::Ports<'_>| {});
        let (straight, loaded) = (Constrained(model), Constrained(&loaded));
        let (next, _) = if count % 4 == 3 {
            general = step_linearly_implicit_euler(&loaded, &general, *time, step).unwrap().0;
            step_linearly_implicit_euler(&straight, state, *time, step).unwrap()
        } else {
            general = step_linearly_implicit(&loaded, &general, *time, step).unwrap().0;
            step_linearly_implicit(&straight, state, *time, step).unwrap()
        };
        mechanism.state = next;
        mechanism.time += step;
    }
    let difference = (position(&mechanism.state) - position(&general)).norm();
    let moved = (position(&general) - start).norm();
    assert!(moved > 1e-5, "it moves: {moved:e} m");
    assert!(difference < 1e-6 * moved, "{difference:e} of {moved:e} m");
}

#[test]
fn linearly_implicit_steps_take_straight_line_code() {
    advances_by_implicit_stages(falling(), 1e-3, |state| state.lower.position);
    advances_by_implicit_stages(whirling(), 1e-4, |state| state.rotor.position);
}

/// The corrections of implicit methods are such stages too, where joints are kept by projection.
#[test]
fn implicit_methods_take_straight_line_code() {
    let mechanism = whirling();
    let Mechanism { model, state, .. } = &mechanism;
    let loaded =
        Loaded::new(model, |_: &SupportedRotor, _, _: &mut <SupportedRotor as Assembly<f64>>::Ports<'_>| {});
    let radau = RadauIIA::order_five();
    let (one, _) = radau.step(&Constrained(model), state, 0.0, 1e-4).unwrap();
    let (other, _) = radau.step(&Constrained(&loaded), state, 0.0, 1e-4).unwrap();
    let (moved, difference) =
        (other.rotor.velocity.norm(), (one.rotor.velocity - other.rotor.velocity).norm());
    // the sweeps end at ten digits
    assert!(difference < 1e-9 * moved, "{difference:e} of {moved:e} m/s");
    let alpha = GeneralisedAlpha::new();
    let of = |memory, straight: bool| {
        let mut memory = memory;
        let step = if straight {
            alpha.step(&Constrained(model), &mut memory, state, 0.0, 1e-4)
        } else {
            alpha.step(&Constrained(&loaded), &mut memory, state, 0.0, 1e-4)
        };
        step.unwrap().0
    };
    let memory = alpha.start(&Constrained(model), state, 0.0, 1e-4).unwrap();
    let [one, other] = [true, false].map(|straight| of(memory, straight));
    let difference = (one.rotor.velocity - other.rotor.velocity).norm();
    assert!(difference < 1e-9 * moved, "{difference:e} of {moved:e} m/s");
}

#[test]
fn other_treatments_and_stages_are_general() {
    let mut mechanism = falling();
    mechanism.model.treatment = Treatment::Baumgarte { alpha: 1.0, beta: 1.0 };
    assert_eq!(mechanism.straight_implicit_difference(1e-4), None);
    let mut mechanism = whirling();
    assert!(mechanism.straight_implicit_difference(1e-4).is_some());
    // no step: soft rows of nothing
    assert_eq!(mechanism.straight_implicit_difference(0.0), None);
    mechanism.state.rotor.position.x = f64::NAN;
    mechanism.step_linearly_implicit(1e-4).unwrap_err();
}
