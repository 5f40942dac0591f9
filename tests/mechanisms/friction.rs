//! Friction in joints: what is known of sliding blocks, and energy.

use ffrf::mechanism;
use ffrf::mechanism::{Assembly, Constrained};
use ffrf::nalgebra::Vector3;
use ffrf::{
    AlphaMemory, EnergyMomentum, GeneralisedAlpha, StepError, System, step_dormand_prince,
    step_linearly_implicit, step_linearly_implicit_euler, step_rk4, step_symplectic_euler,
};
use ffrf_test_kit::convergence::measured_order;
use ffrf_test_kit::tolerances::SLOPE;

use crate::bodies::{BIG_END, Rod, energy};

/// Round-off of some hundred steps, and the passage through rest: (speed / v)² / 2.
const EXACT: f64 = 1e-10;
const COEFFICIENT: f64 = 0.3;
const GRAVITY: f64 = 9.81;

/// One step of a method on the rubbing pendulum: system, state, time, step.
type RubbingStep = dyn Fn(&Constrained<'_, Rubbing>, &RubbingState, f64, f64) -> RubbingState;

mechanism! {
    /// A block on a rail along x.
    pub struct Block {
        bodies: { block: rigid { mass: 2.0, inertia: [0.1; 3] } },
        gravity: [0.0, 0.0, -GRAVITY],
        joints: { rail: prismatic(ground, block, axis: x) },
        forces: { rub: friction(rail, coefficient: COEFFICIENT, speed: 1e-7) },
        sensors: { hold: reaction_force(rail) },
    }
}

mechanism! {
    /// A flexible pendulum whose bearing rubs.
    pub struct Rubbing {
        bodies: { rod: Rod },
        gravity: [0.0, -GRAVITY, 0.0],
        joints: { pin: revolute(ground, rod.BIG_END) },
        forces: { bearing: friction(pin, coefficient: 0.2, radius: 0.01, speed: 0.05, viscous: 1e-5) },
        sensors: { load: reaction_force(pin) },
    }
}

mechanism! {
    /// The same with a moment of the user's own.
    pub struct Pushed {
        bodies: { rod: Rod },
        gravity: [0.0, -GRAVITY, 0.0],
        joints: { pin: revolute(ground, rod.BIG_END) },
        controls: { moment: 0.0 },
        forces: { own: user(|model, _, ports| {
            let wrench = ffrf::Wrench { force: Vector3::zeros(), moment: Vector3::z() * model.moment };
            ports.rod.push_at(&Rod::BIG_END, &wrench);
        }) },
    }
}

type Step = fn(&Constrained<'_, Block>, &BlockState, f64, f64) -> BlockState;

#[test]
fn a_block_slides_to_a_stop_as_coulomb_says() {
    let methods: [(&str, Step); 7] = [
        ("symplectic Euler", |system, state, t, h| step_symplectic_euler(system, state, t, h).unwrap().0),
        ("RK4", |system, state, t, h| step_rk4(system, state, t, h).unwrap().0),
        ("Dormand-Prince", |system, state, t, h| step_dormand_prince(system, state, t, h).unwrap().0),
        ("linearly implicit", |system, state, t, h| step_linearly_implicit(system, state, t, h).unwrap().0),
        ("linearly implicit Euler", |system, state, t, h| {
            step_linearly_implicit_euler(system, state, t, h).unwrap().0
        }),
        ("generalised alpha", |system, state, t, h| {
            let method = GeneralisedAlpha::new();
            let mut memory: AlphaMemory<_> = method.start(system, state, t, h).unwrap();
            method.step(system, &mut memory, state, t, h).unwrap().0
        }),
        ("energy-momentum", |system, state, t, h| EnergyMomentum::new().step(system, state, t, h).unwrap().0),
    ];
    let model = Block::new();
    for (name, step) in methods {
        let mut state = model.at_rest();
        state.block.velocity.x = 2.0;
        let (h, steps) = (1e-3, 500);
        for k in 0..steps {
            state = step(&Constrained(&model), &state, f64::from(k) * h, h);
        }
        let expected = 2.0 - COEFFICIENT * GRAVITY * h * f64::from(steps);
        let off = (state.block.velocity.x - expected).abs();
        assert!(off < EXACT, "{name}: {} instead of {expected}", state.block.velocity.x);
    }
    let mut state = model.at_rest();
    state.block.velocity.x = 1.0;
    let hold = model.hold(0.0, &state).unwrap();
    assert!((hold - Vector3::new(0.0, 0.0, 2.0 * GRAVITY)).amax() < EXACT, "{hold}");
}

#[test]
fn a_block_on_a_slope_slides_with_what_friction_leaves() {
    let mut model = Block::new();
    let slope = 0.5_f64;
    model.gravity = Vector3::new(GRAVITY * slope.sin(), 0.0, -GRAVITY * slope.cos());
    let mut state = model.at_rest();
    state.block.velocity.x = 0.1;
    let rates = Constrained(&model).rates(0.0, &state, &model.no_change(&state)).unwrap();
    let expected = GRAVITY * (slope.sin() - COEFFICIENT * slope.cos());
    assert!((rates.block.velocity.x - expected).abs() < EXACT, "{} {expected}", rates.block.velocity.x);
}

/// A swinging start: the rod level, turning.
pub fn swinging(model: &Rubbing, spin: f64) -> RubbingState {
    let mut state = model.at_rest();
    state.rod.position.x = -BIG_END;
    state.rod.angular_velocity.z = spin;
    state.rod.velocity.y = -BIG_END * spin;
    state
}

/// How fast the bearing turns: the marker, which the modes turn as well.
fn bearing_rate(model: &Rubbing, state: &RubbingState) -> f64 {
    let mut rooms = model.rooms();
    let ports = model.ports(&mut rooms, *state, None);
    model.connections()[0].second.motion(&ports).angular_velocity.z
}

#[test]
fn friction_and_reaction_agree_with_each_other() {
    let model = Rubbing::new(Rod);
    let mut mechanism = model.in_motion(swinging(&model, 3.0));
    for _ in 0..50 {
        mechanism.step_rk4(5e-6).unwrap();
    }
    // the reaction as the sensor has it, friction by its law, and the same motion under that moment as a load
    let normal = model.load(mechanism.time, &mechanism.state).unwrap().norm();
    let rate = bearing_rate(&model, &mechanism.state);
    let mut pushed = Pushed::new(Rod);
    pushed.moment = model.bearing.exerted(normal, rate);
    assert!(pushed.moment < -1e-3, "{}", pushed.moment);
    let found = Constrained(&model)
        .rates(mechanism.time, &mechanism.state, &model.no_change(&mechanism.state))
        .unwrap();
    let state = PushedState { rod: mechanism.state.rod };
    let expected = Constrained(&pushed).rates(mechanism.time, &state, &pushed.no_change(&state)).unwrap();
    let apart = (found.rod.modal_rates - expected.rod.modal_rates).amax();
    assert!(apart < 1e-10 * expected.rod.modal_rates.amax(), "{apart:.2e}");
    let apart = (found.rod.angular_velocity - expected.rod.angular_velocity).amax();
    assert!(apart < 1e-10 * expected.rod.angular_velocity.amax(), "{apart:.2e}");
}

#[test]
fn friction_takes_the_energy_that_its_power_says() {
    let model = Rubbing::new(Rod);
    let of = |state: &RubbingState| energy(&Rod, &state.rod, &model.gravity);
    let mut mechanism = model.in_motion(swinging(&model, 3.0));
    let power = |time: f64, state: &RubbingState| {
        let normal = model.load(time, state).unwrap().norm();
        let rate = bearing_rate(&model, state);
        model.bearing.exerted(normal, rate) * rate
    };
    let (h, mut before, start) = (5e-6, of(&mechanism.state), of(&mechanism.state));
    let (mut work, mut last) = (0.0, power(0.0, &mechanism.state));
    for _ in 0..400 {
        mechanism.step_rk4(h).unwrap();
        let now = power(mechanism.time, &mechanism.state);
        work += 0.5 * h * (last + now);
        last = now;
        let after = of(&mechanism.state);
        assert!(after < before, "t = {}: {after} after {before}", mechanism.time);
        before = after;
    }
    // the trapezoidal rule on a vibrating reaction
    assert!((before - start - work).abs() < 1e-3 * work.abs(), "{} {work}", before - start);
    assert!(work < -1e-5, "{work}");
}

#[test]
fn methods_keep_their_order_with_friction() {
    let model = Rubbing::new(Rod);
    let start = swinging(&model, 30.0);
    let span = 4e-4;
    let run = |steps: usize, step: &RubbingStep| {
        let (mut state, h) = (start, span / steps as f64);
        for k in 0..steps {
            state = step(&Constrained(&model), &state, k as f64 * h, h);
        }
        state
    };
    let rk4 = |system: &Constrained<'_, Rubbing>, state: &RubbingState, t: f64, h: f64| {
        step_rk4(system, state, t, h).unwrap().0
    };
    let exact = run(1600, &rk4);
    let apart = |state: &RubbingState| {
        let (found, exact) = (state.to_array(), exact.to_array());
        found.iter().zip(&exact).fold(0.0_f64, |most, (found, exact)| most.max((found - exact).abs()))
    };
    let order = measured_order(50, 2, |steps| apart(&run(steps, &rk4)));
    assert!(order > 4.0 - SLOPE, "RK4: {order}");
    let order = measured_order(200, 2, |steps| {
        apart(&run(steps, &|system, state, t, h| step_linearly_implicit(system, state, t, h).unwrap().0))
    });
    // the reaction of a stage is of first order where modes give way: friction follows an extrapolated one
    assert!(order > 2.0 - SLOPE, "linearly implicit: {order}");
}

#[test]
fn a_bearing_that_locks_itself_is_refused() {
    let mut model = Rubbing::new(Rod);
    // a bearing larger than the rod: what friction adds to the reaction is more than what it came from
    model.bearing.coefficient = 1.0;
    model.bearing.arm = 1.0;
    let mut mechanism = model.in_motion(swinging(&model, 3.0));
    let refused = mechanism.step_rk4(5e-6);
    assert!(matches!(refused, Err(StepError::NotConverged { .. })), "{refused:?}");
}
