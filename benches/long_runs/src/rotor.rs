//! A flexible rotor out of balance, on two bearings: f32 against f64 over a million steps.

use ffrf::mechanism::Mechanism;
use ffrf::nalgebra::{RealField, Vector3, convert, try_convert};
use ffrf::step_rk4;

ffrf::flexible_body! {
    /// The shaft of `models/`, three pairs of bending, every term.
    pub struct Shaft { model: "../../models/shaft.ffrf.json", fidelity: full, scalar: generic }
}

ffrf::mechanism! {
    /// Shaft and disc of `models/scenes/flexible_rotor.toml` at steady speed, without weight.
    pub struct Rotor {
        bodies: {
            shaft: free Shaft,
            disc: rigid { mass: 5.0, center_of_mass: [0.0, 1e-4, 0.0], inertia: [0.04, 0.02, 0.02] },
        },
        joints: { press_fit: fixed(shaft.MIDDLE, disc) },
        forces: {
            left: bushing(ground.at([-0.25, 0.0, 0.0]), shaft.LEFT,
                          stiffness: [1e7, 1e7, 1.5e7, 0.0, 0.0, 0.0], damping: [500.0, 500.0, 500.0, 0.0, 0.0, 0.0]),
            right: bushing(ground.at([0.25, 0.0, 0.0]), shaft.RIGHT,
                           stiffness: [0.0, 1e7, 1.5e7, 0.0, 0.0, 0.0], damping: [0.0, 500.0, 500.0, 0.0, 0.0, 0.0]),
        },
        sensors: { place: position(disc) },
        scalar: generic,
    }
}

/// Two thirds of the first critical speed. Units: rad/s.
const SPIN: f64 = 300.0;
/// 15 µs, the same number in both types. Units: s.
const STEP: f64 = 1.0 / 65536.0;

fn rotor<T: RealField + Copy>() -> Mechanism<Rotor<T>, T> {
    let model = Rotor::<T>::new(Shaft);
    let mut state = model.at_rest();
    state.shaft.angular_velocity.x = convert(SPIN);
    state.disc.angular_velocity.x = convert(SPIN);
    let mut rotor = model.in_motion(state);
    rotor.assemble().expect("an assembled rotor");
    rotor
}

/// Place of the disc (m), its angle (rad) about the shaft, and its spin (rad/s).
fn shown<T: RealField + Copy>(rotor: &Mechanism<Rotor<T>, T>) -> (Vector3<f64>, f64, f64) {
    let double = |x: T| try_convert(x).unwrap_or(f64::NAN);
    let state = &rotor.state.disc;
    let [x, _, _, w]: [T; 4] = state.orientation.coords.into();
    (
        rotor.model.place(&rotor.state).map(double),
        2.0 * double(x).atan2(double(w)),
        double(state.angular_velocity.x),
    )
}

/// Both at once, step by step.
pub fn table() {
    // the last: in f64, but for the spins, which are rounded to f32 after each step
    let (mut double, mut single, mut again) = (rotor::<f64>(), rotor::<f32>(), rotor::<f64>());
    println!(
        "| steps | whirl | place apart | angle apart | mean spin apart | spins alone in f32: angle apart |"
    );
    println!("| --- | --- | --- | --- | --- | --- |");
    let mut done = 0;
    // the largest, of the spin the mean, of the last thousand steps before each mark
    for mark in [1_000, 3_000, 10_000, 30_000, 100_000, 300_000, 1_000_000] {
        let (mut whirl, mut place, mut angle, mut spin, mut own) =
            (0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64, 0.0_f64);
        while done < mark {
            double.step_with(STEP, step_rk4).expect("a step in f64");
            single.step_with(STEP as f32, step_rk4).expect("a step in f32");
            again.step_with(STEP, step_rk4).expect("a step in f64");
            for body in [&mut again.state.shaft.angular_velocity, &mut again.state.disc.angular_velocity] {
                *body = body.map(|x| f64::from(x as f32));
            }
            done += 1;
            if done + 1_000 > mark {
                let (exact, found, other) = (shown(&double), shown(&single), shown(&again));
                let turned = |a: f64, b: f64| {
                    let turn = std::f64::consts::TAU;
                    ((a - b) / turn - ((a - b) / turn).round()).abs() * turn
                };
                whirl = whirl.max(exact.0.yz().norm());
                place = place.max((exact.0 - found.0).yz().norm());
                angle = angle.max(turned(exact.1, found.1));
                spin += (found.2 - exact.2) / 1_000.0;
                own = own.max(turned(exact.1, other.1));
            }
        }
        println!(
            "| {mark} | {whirl:.1e} m | {place:.0e} m | {angle:.0e} rad | {spin:+.0e} rad/s | {own:.0e} rad |"
        );
    }
}
