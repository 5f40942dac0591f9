//! Accelerations by functions that were printed for the mechanism: the keys `accelerations` and `implicit_accelerations`.

use std::cell::{Cell, RefCell};

use ffrf::integrators::System as _;
use ffrf::mechanism;
use ffrf::mechanism::{Assembly as _, Constrained, Loaded, Mechanism, Treatment};
use ffrf::nalgebra::{UnitQuaternion, Vector3};
use ffrf::rotation::cayley_omega;
use ffrf::{Marker, Wrench};

use crate::bodies::{BIG_END, Rod};

const MASS: f64 = 0.7;
const INERTIA: f64 = 3e-3;
const LEVER: f64 = 0.2;
const WEIGHT: f64 = MASS * 9.81;

/// State, drives, and what is answered.
type Asked = ([f64; 55], [[f64; 3]; 5], Option<[f64; 26]>);

thread_local! {
    /// How often a function of this thread was asked.
    static ASKED: Cell<usize> = const { Cell::new(0) };
    /// What the functions of the rods were asked last, and what they answer.
    static RODS: RefCell<Asked> = const { RefCell::new(([0.0; 55], [[0.0; 3]; 5], None)) };
}

/// What is subtracted, and γ h.
type AskedStage = ([f64; 52], f64);

thread_local! {
    /// What the function of stages of the rods was asked last.
    static STAGE: Cell<AskedStage> = const { Cell::new(([0.0; 52], 0.0)) };
}

/// Cosine and sine of the angle about y.
fn turn(state: &[f64; 13]) -> [f64; 2] {
    let [j, w] = [state[4], state[6]];
    [w * w - j * j, 2.0 * w * j]
}

/// Accelerations of a bar whose frame origin, its centre of mass, turns about y at a distance from the inertial origin.
fn turning(state: &[f64; 13], angular: f64, accelerations: &mut [f64; 6]) {
    let ([x, z], rate) = (turn(state).map(|part| LEVER * part), state[11]);
    let square = rate * rate;
    *accelerations = [-angular * z - square * x, 0.0, -angular * x + square * z, 0.0, angular, 0.0];
}

fn swinging(state: &[f64; 13], drives: &[[f64; 3]; 1], accelerations: &mut [f64; 6]) -> bool {
    ASKED.set(ASKED.get() + 1);
    assert_eq!(drives, &[[0.0; 3]], "no drive");
    let [cosine, _] = turn(state);
    turning(state, WEIGHT * LEVER * cosine / (INERTIA + MASS * LEVER * LEVER), accelerations);
    true
}

fn driven(state: &[f64; 13], drives: &[[f64; 3]; 2], accelerations: &mut [f64; 6]) -> bool {
    ASKED.set(ASKED.get() + 1);
    let [pin, [value, rate, acceleration]] = drives;
    assert_eq!(pin, &[0.0; 3], "the joint itself");
    // 3 t + t²
    assert!((rate * rate - 9.0 - 4.0 * value).abs() < 1e-12 && *acceleration == 2.0);
    turning(state, *acceleration, accelerations);
    true
}

fn declining(_: &[f64; 13], _: &[[f64; 3]; 1], accelerations: &mut [f64; 6]) -> bool {
    ASKED.set(ASKED.get() + 1);
    *accelerations = [f64::NAN; 6];
    false
}

fn in_single(state: &[f32; 13], _: &[[f32; 3]; 1], accelerations: &mut [f32; 6]) -> bool {
    let mut result = [0.0; 6];
    let answered = swinging(&state.map(f64::from), &[[0.0; 3]], &mut result);
    *accelerations = result.map(|number| number as f32);
    answered
}

fn rods(state: &[f64; 55], drives: &[[f64; 3]; 5], accelerations: &mut [f64; 26]) -> bool {
    RODS.with_borrow_mut(|(seen, driven, answer)| {
        (*seen, *driven) = (*state, *drives);
        answer.map(|answer| *accelerations = answer).is_some()
    })
}

fn rods_in_stage(
    state: &[f64; 55],
    subtracted: &[f64; 52],
    gamma_h: f64,
    drives: &[[f64; 3]; 5],
    accelerations: &mut [f64; 26],
) -> bool {
    STAGE.set((*subtracted, gamma_h));
    rods(state, drives, accelerations)
}

/// The same bar about y, with what else is written.
macro_rules! bar {
    ($name:ident $(, $key:ident: $value:tt)*) => {
        mechanism! {
            /// A bar that swings about y.
            pub struct $name {
                bodies: { bar: rigid { mass: MASS, inertia: [INERTIA; 3] } },
                gravity: [0.0, 0.0, -9.81],
                joints: { pin: revolute(ground, bar.at([-LEVER, 0.0, 0.0]), axis: y) },
                $($key: $value,)*
            }
        }
    };
}

bar!(Swinging, accelerations: swinging);
bar!(General);
bar!(Declining, accelerations: declining);
bar!(Driven, drives: { motor: angle(pin, polynomial: [0.0, 3.0, 1.0]) }, accelerations: driven);
bar!(DrivenGeneral, drives: { motor: angle(pin, polynomial: [0.0, 3.0, 1.0]) });
bar!(InSingle, accelerations: in_single, scalar: f32);

mechanism! {
    /// A flexible rod, a rigid bar and an array of a rod.
    pub struct Rods {
        bodies: { first: Rod, bar: rigid { mass: 1.0, inertia: [1e-3; 3] }, others: [Rod; 1] },
        joints: {
            pin: revolute(ground, first.BIG_END, axis: z),
            hinge: revolute(first.SMALL_END, bar, axis: z),
            hinges: for i in 0..1 { revolute(bar, others[i].BIG_END, axis: z) },
        },
        drives: {
            motors: for i in 0..1 { angle(hinges[i], polynomial: [0.5, 0.25]) },
            motor: angle(pin, polynomial: [7.0, 8.0, 9.0]),
        },
        accelerations: crate::accelerations::rods,
        implicit_accelerations: crate::accelerations::rods_in_stage,
    }
}

/// A bar that turns: its state with the joint met, at this angle and rate.
macro_rules! turned {
    ($model:expr, $angle:expr, $rate:expr) => {{
        let mut state = $model.at_rest();
        state.bar.orientation = UnitQuaternion::from_axis_angle(&Vector3::y_axis(), $angle);
        state.bar.position = state.bar.orientation * Vector3::new(LEVER as _, 0.0, 0.0);
        state.bar.angular_velocity.y = $rate;
        state.bar.velocity = state.bar.angular_velocity.cross(&state.bar.position);
        state
    }};
}

#[test]
fn explicit_steps_ask_the_function_and_nothing_else_does() {
    let model = Swinging::new();
    let mut straight = model.in_motion(turned!(model, 0.3, 2.0));
    let model = General::new();
    let mut general = model.in_motion(turned!(model, 0.3, 2.0));
    ASKED.set(0);
    for _ in 0..100 {
        straight.step_rk4(1e-3).unwrap();
        general.step_rk4(1e-3).unwrap();
    }
    assert_eq!(ASKED.replace(0), 400, "four stages of a hundred steps");
    let apart = straight.state.bar.position - general.state.bar.position;
    assert!(apart.norm() < 1e-13, "{apart}");
    assert!((general.state.bar.position.x - LEVER * 0.3_f64.cos()).abs() > 1e-3, "it swings");
    straight.step_linearly_implicit(1e-3).unwrap();
    straight.assemble().unwrap();
    assert_eq!(ASKED.get(), 0);
}

#[test]
fn a_function_that_declines_leaves_no_trace() {
    let model = Declining::new();
    let mut declining = model.in_motion(turned!(model, 0.3, 2.0));
    let model = General::new();
    let mut general = model.in_motion(turned!(model, 0.3, 2.0));
    ASKED.set(0);
    for _ in 0..20 {
        let (one, other) = (declining.step_rk4(1e-3).unwrap(), general.step_rk4(1e-3).unwrap());
        assert_eq!(format!("{one:?}"), format!("{other:?}"));
        assert_eq!(declining.state.to_array(), general.state.to_array());
    }
    assert_eq!((ASKED.get(), declining.straight_difference()), (80, None));
    declining.state.bar.velocity.x = f64::INFINITY;
    general.state.bar.velocity.x = f64::INFINITY;
    assert_eq!(declining.step_rk4(1e-3).unwrap_err(), general.step_rk4(1e-3).unwrap_err());
}

#[test]
fn drives_stand_at_their_connections() {
    assert_eq!(Driven::JOINTS, ["pin", "motor"]);
    let model = Driven::new();
    let mut straight = model.in_motion(turned!(model, 0.0, 3.0));
    let model = DrivenGeneral::new();
    let mut general = model.in_motion(turned!(model, 0.0, 3.0));
    for _ in 0..50 {
        straight.step_rk4(1e-3).unwrap();
        general.step_rk4(1e-3).unwrap();
    }
    let apart = straight.state.bar.position - general.state.bar.position;
    assert!(apart.norm() < 1e-13, "{apart}");
    assert!(straight.straight_difference().unwrap() < 1e-12);
}

#[test]
fn the_difference_tells_whether_a_function_belongs_to_a_mechanism() {
    let model = Swinging::new();
    let mut swinging = model.in_motion(turned!(model, 0.3, 2.0));
    assert!(swinging.straight_difference().unwrap() < 1e-14);
    let general = General::new();
    assert_eq!(general.in_motion(turned!(general, 0.3, 2.0)).straight_difference(), None);
    // the function does not follow
    swinging.model.gravity.z *= 1.01;
    let difference = swinging.straight_difference().unwrap();
    assert!(difference > 1e-3 && difference < 1e-2, "{difference}");
    // at rest and without weight there is nothing to compare
    swinging.model.gravity.z = 0.0;
    swinging.state = turned!(model, std::f64::consts::FRAC_PI_2, 0.0);
    assert!(swinging.straight_difference().unwrap() <= 1.0);
}

#[test]
fn gains_and_loads_that_the_function_does_not_know_are_general() {
    let mut model = Swinging::new();
    let state = turned!(model, 0.3, 2.0);
    ASKED.set(0);
    let none = model.no_change(&state);
    let pushed = Loaded::new(&model, |_: &Swinging, _, ports: &mut SwingingPorts<'_>| {
        let wrench = Wrench { force: Vector3::x(), moment: Vector3::zeros() };
        ports.bar.push_at(&Marker::rigid(Vector3::zeros(), &Default::default()), &wrench);
    });
    let alone = Constrained(&model).rates(0.0, &state, &none).unwrap();
    assert_eq!(ASKED.replace(0), 1);
    let rates = Constrained(&pushed).rates(0.0, &state, &none).unwrap();
    assert_eq!(ASKED.get(), 0);
    assert!((rates.bar.angular_velocity - alone.bar.angular_velocity).norm() > 1.0);
    model.treatment = Treatment::Baumgarte { alpha: 1.0, beta: 1.0 };
    assert_eq!(model.straight_rates(0.0, &state, &none), None);
    assert_eq!((ASKED.get(), Mechanism::new(model, state).straight_difference()), (0, None));
}

#[test]
fn functions_in_single_precision_have_arrays_in_single_precision() {
    let model = InSingle::new();
    let swinging = model.in_motion(turned!(model, 0.3_f32, 2.0_f32));
    assert!(swinging.straight_difference().unwrap() < 1e-5);
}

/// A state whose numbers can be told apart: hundreds for the body, tens for what they are.
fn numbered(model: &Rods) -> RodsState {
    let mut state = model.at_rest();
    let fill = |numbers: &mut [f64], first: f64| {
        for (index, number) in numbers.iter_mut().enumerate() {
            *number = first + index as f64;
        }
    };
    fill(state.first.position.as_mut_slice(), 100.0);
    fill(state.first.modal_coordinates.as_mut_slice(), 110.0);
    fill(state.first.velocity.as_mut_slice(), 120.0);
    fill(state.first.angular_velocity.as_mut_slice(), 130.0);
    fill(state.first.modal_rates.as_mut_slice(), 140.0);
    fill(state.bar.position.as_mut_slice(), 200.0);
    fill(state.bar.velocity.as_mut_slice(), 220.0);
    fill(state.bar.angular_velocity.as_mut_slice(), 230.0);
    fill(state.others[0].position.as_mut_slice(), 300.0);
    fill(state.others[0].modal_coordinates.as_mut_slice(), 310.0);
    fill(state.others[0].velocity.as_mut_slice(), 320.0);
    fill(state.others[0].angular_velocity.as_mut_slice(), 330.0);
    fill(state.others[0].modal_rates.as_mut_slice(), 340.0);
    state.bar.orientation = UnitQuaternion::from_euler_angles(0.1, 0.2, 0.3);
    state
}

#[test]
fn numbers_of_flexible_bodies_stand_in_their_order() {
    let model = Rods::new(Rod, [Rod]);
    let state = numbered(&model);
    RODS.with_borrow_mut(|(_, _, answer)| *answer = Some(std::array::from_fn(|index| index as f64)));
    // a change that has led here, so that rates of rotations are those of the chart
    let mut increment = model.no_change(&state);
    increment.first.rotation = Vector3::new(0.1, 0.2, 0.3);
    let rates = model.straight_rates(2.0, &state, &increment).unwrap();
    let (seen, drives) = RODS.with_borrow(|(seen, drives, _)| (*seen, *drives));
    let sequence = |first: f64, count: usize| (0..count).map(move |index| first + index as f64);
    let [i, j, k, w]: [f64; 4] = state.bar.orientation.coords.into();
    let first = sequence(100.0, 3).chain([0.0, 0.0, 0.0, 1.0]).chain(sequence(110.0, 4));
    let first = first.chain(sequence(120.0, 3)).chain(sequence(130.0, 3)).chain(sequence(140.0, 4));
    let bar = sequence(200.0, 3).chain([i, j, k, w]).chain(sequence(220.0, 3)).chain(sequence(230.0, 3));
    let other = sequence(300.0, 3).chain([0.0, 0.0, 0.0, 1.0]).chain(sequence(310.0, 4));
    let other = other.chain(sequence(320.0, 3)).chain(sequence(330.0, 3)).chain(sequence(340.0, 4));
    assert_eq!(seen.to_vec(), first.chain(bar).chain(other).collect::<Vec<_>>());
    assert_eq!(Rods::JOINTS, ["pin", "motor", "hinge", "hinges[0]", "motors[0]"]);
    let none = [0.0; 3];
    assert_eq!(drives, [none, [7.0 + 16.0 + 36.0, 8.0 + 36.0, 18.0], none, none, [1.0, 0.25, 0.0]]);

    // places as ever, velocities from the answer
    let places = model.place_rates(&state, &model.no_change(&state));
    assert_eq!(rates.first.velocity, Vector3::new(0.0, 1.0, 2.0));
    assert_eq!(rates.first.angular_velocity, Vector3::new(3.0, 4.0, 5.0));
    assert_eq!(rates.first.modal_rates.as_slice(), [6.0, 7.0, 8.0, 9.0]);
    assert_eq!(rates.bar.velocity, Vector3::new(10.0, 11.0, 12.0));
    assert_eq!(rates.bar.angular_velocity, Vector3::new(13.0, 14.0, 15.0));
    assert_eq!(rates.others[0].velocity, Vector3::new(16.0, 17.0, 18.0));
    assert_eq!(rates.others[0].angular_velocity, Vector3::new(19.0, 20.0, 21.0));
    assert_eq!(rates.others[0].modal_rates.as_slice(), [22.0, 23.0, 24.0, 25.0]);
    assert_eq!(rates.first.rotation, increment.first.place_rate(&state.first).rotation);
    assert_ne!(rates.first.rotation, places.first.rotation, "the chart");
    assert_eq!(rates.bar.position, places.bar.position);
    assert_eq!(rates.others[0].modal_coordinates, state.others[0].modal_rates);
}

/// The accelerations in rates, in the order of the function.
fn velocities_of(rates: &RodsIncrement) -> [f64; 26] {
    let mut answer = [0.0; 26];
    let parts = [
        rates.first.velocity.as_slice(),
        rates.first.angular_velocity.as_slice(),
        rates.first.modal_rates.as_slice(),
        rates.bar.velocity.as_slice(),
        rates.bar.angular_velocity.as_slice(),
        rates.others[0].velocity.as_slice(),
        rates.others[0].angular_velocity.as_slice(),
        rates.others[0].modal_rates.as_slice(),
    ];
    for (place, number) in answer.iter_mut().zip(parts.into_iter().flatten()) {
        *place = *number;
    }
    answer
}

#[test]
fn known_numbers_of_a_flexible_body_are_forwarded() {
    let model = Rods::new(Rod, [Rod]);
    let mut state = model.at_rest();
    state.first.position.x = -BIG_END;
    state.first.modal_rates[1] = 0.1;
    let mut rods = model.in_motion(state);
    RODS.with_borrow_mut(|(_, _, answer)| *answer = None);
    let none = model.no_change(&state);
    let rates = Constrained(&model).rates(0.0, &state, &none).unwrap();
    assert_eq!(rods.straight_difference(), None);
    let answer = velocities_of(&rates);
    RODS.with_borrow_mut(|(_, _, known)| *known = Some(answer));
    assert_eq!(Constrained(&model).rates(0.0, &state, &none).unwrap(), rates);
    assert_eq!(rods.straight_difference(), Some(0.0));
    rods.state.first.modal_rates[1] = 1.0;
    assert!(rods.straight_difference().unwrap() > 0.0);
}

#[test]
fn stages_are_told_what_is_subtracted_and_give_rates_that_look_ahead() {
    let model = Rods::new(Rod, [Rod]);
    let mut state = model.at_rest();
    state.first.position.x = -BIG_END;
    state.first.modal_rates[1] = 0.1;
    let mut increment = model.no_change(&state);
    increment.others[0].rotation = Vector3::new(0.1, 0.2, 0.3);
    let mut subtracted = model.no_change(&state);
    subtracted.first.position.x = 1.0;
    subtracted.first.modal_coordinates[0] = 2.0;
    subtracted.first.modal_rates[3] = 3.0;
    subtracted.bar.velocity.y = 4.0;
    subtracted.others[0].rotation.z = 5.0;
    subtracted.others[0].angular_velocity.z = 6.0;
    for less in [None, Some(&subtracted)] {
        RODS.with_borrow_mut(|(_, _, answer)| *answer = None);
        let system = Constrained(&model);
        let general = system.implicit_rates_at(0.0, state, &increment, 1e-3, less).unwrap();
        assert_eq!(model.straight_implicit_rates(0.0, &state, &increment, 1e-3, less), None, "it declines");
        RODS.with_borrow_mut(|(_, _, answer)| *answer = Some(velocities_of(&general)));
        let straight = model.straight_implicit_rates(0.0, &state, &increment, 1e-3, less).unwrap();
        // the same operations on the same numbers
        assert_eq!(straight, general);
        let (seen, gamma_h) = STAGE.get();
        assert_eq!(gamma_h, 1e-3);
        let mut expected = [0.0; 52];
        if less.is_some() {
            // of a body: position 3, rotation 3, modes 4, velocity 3, angular velocity 3, modes 4
            (expected[0], expected[6], expected[19], expected[20 + 7]) = (1.0, 2.0, 3.0, 4.0);
            let about_the_state = cayley_omega(&increment.others[0].rotation, &Vector3::new(0.0, 0.0, 5.0));
            expected[32 + 3..32 + 6].copy_from_slice(about_the_state.as_slice());
            expected[32 + 15] = 6.0;
        }
        assert_eq!(seen, expected);
    }
}
