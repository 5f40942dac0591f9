//! Ten million steps of free spin beside the intermediate axis.

use ffrf::nalgebra::{Matrix3, RealField, Vector3, convert, try_convert};
use ffrf::{FreeBody, RigidBody, State};

/// Moments of inertia: the second axis is the intermediate one. Units: kg m².
const PRINCIPAL: [f64; 3] = [1.0, 2.0, 2.5];
/// Of one step, at 1 rad/s. Units: s.
const STEP: f64 = 0.01;

fn double<T: RealField + Copy>(number: T) -> f64 {
    try_convert(number).unwrap_or(f64::NAN)
}

/// Energy and angular momentum in space.
fn conserved<T: RealField + Copy, V>(state: &State<V, T>) -> (f64, Vector3<f64>) {
    let spin = state.angular_velocity.map(double);
    let momentum = spin.component_mul(&Vector3::from(PRINCIPAL));
    // A momentum, in double precision
    let [x, y, z, w]: [T; 4] = state.orientation.coords.into();
    let (vector, scalar) = (Vector3::new(x, y, z).map(double), double(w));
    let turn = vector.cross(&momentum) * 2.0;
    (0.5 * spin.dot(&momentum), momentum + turn * scalar + vector.cross(&turn))
}

/// Largest drifts after each number of steps.
fn run<T: RealField + Copy>(name: &str, marks: &[usize]) {
    let inertia = Matrix3::from_diagonal(&Vector3::from(PRINCIPAL).map(convert));
    let body = RigidBody::<T>::new(T::one(), Vector3::zeros(), inertia);
    let spin = Vector3::new(1e-3, 1.0, 0.0).map(convert);
    let mut body = FreeBody::new(body).with_spin(spin);
    let (energy, momentum) = conserved(&body.state);
    let (mut drift_of_energy, mut drift_of_momentum, mut norm) = (0.0_f64, 0.0_f64, 0.0_f64);
    let (mut flips, mut side) = (0_u64, 1.0);
    let mut done = 0;
    for mark in marks {
        while done < *mark {
            body.step_rk4(convert(STEP), &()).expect("a finite state");
            done += 1;
            let now = double(body.state.angular_velocity.y);
            if now * side < 0.0 {
                (side, flips) = (-side, flips + 1);
            }
            if done % 1_000 == 0 {
                let (energy_now, momentum_now) = conserved(&body.state);
                drift_of_energy = drift_of_energy.max((energy_now / energy - 1.0).abs());
                drift_of_momentum = drift_of_momentum.max((momentum_now - momentum).norm() / momentum.norm());
                norm = norm.max((body.state.orientation.coords.map(double).norm() - 1.0).abs());
            }
        }
        println!(
            "| {name} | {mark} | {flips} | {drift_of_energy:.0e} | {drift_of_momentum:.0e} | {norm:.0e} |"
        );
    }
}

/// The table of both number types.
pub fn table() {
    println!("| scalar | steps | flips | energy | angular momentum | norm of the quaternion |");
    println!("| --- | --- | --- | --- | --- | --- |");
    let marks = [10_000, 100_000, 1_000_000, 10_000_000];
    run::<f64>("f64", &marks);
    run::<f32>("f32", &marks);
}
