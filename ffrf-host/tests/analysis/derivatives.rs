//! The state matrix against differences of the rates that integrators see, in states that move and bend.

use ffrf_host::HostModal;
use ffrf_host::analysis::{Drives, linearise};
use ffrf_host::mechanism::HostIncrement;
use ffrf_runtime::mechanism::{Assembly as _, Constrained};
use ffrf_runtime::{Increment, System as _};
use nalgebra::DVector;

use crate::scene;

/// Sixth-order differences of rates, relative to the largest entry of a column.
const DIFFERENCES: f64 = 1e-8;

/// A flexible rod on a rigid arm, both turning, with a spring and a damper.
const TEXT: &str = r#"
[simulation]
duration = 1.0
step = 1e-4
gravity = [0.0, -9.81, 1.0]
[bodies.arm]
mass = 1.0
center_of_mass = [0.1, 0.0, 0.0]
inertia = [[1e-3, 0.0, 0.0], [0.0, 4e-3, 0.0], [0.0, 0.0, 4e-3]]
angular_velocity = [0.0, 0.0, 5.0]
markers.END = [0.2, 0.0, 0.0]
[bodies.rod]
model = "../conrod.ffrf.json"
modes = 3
position = [0.24740099151709372, 0.0, 0.0]
angular_velocity = [1.0, 2.0, -4.0]
modal_coordinates = [1e-5, -2e-5, 1e-5]
modal_rates = [0.02, 0.01, -0.03]
[joints.shoulder]
kind = "revolute"
first = "ground"
second = "arm"
[joints.elbow]
kind = "spherical"
first = "arm.END"
second = "rod.BIG_END"
[forces.cord]
kind = "spring"
first = "ground"
first_position = [0.3, 0.4, 0.1]
second = "rod.SMALL_END"
stiffness = 400.0
damping = 2.0
rest = 0.2
[sensors.tip]
kind = "acceleration"
of = "rod.SMALL_END"
[sensors.load]
kind = "reaction_force"
of = "elbow"
"#;

#[test]
fn the_state_matrix_is_the_derivative_of_the_rates() {
    let scene = scene(TEXT);
    let (state, _) = scene.assembled().unwrap();
    let system = linearise(&scene, 0.0, &state, Drives::Moving).unwrap();
    let n = system.basis.nrows() / 2;
    // 6 + 9 velocities, of which the joints hold 5 and 3
    assert_eq!((n, system.a.nrows()), (15, 14));
    let identity = &system.projection * &system.basis;
    assert!((identity - nalgebra::DMatrix::identity(14, 14)).amax() < 1e-12);
    let mechanism = &scene.mechanism;
    let rates = |x: &DVector<f64>| {
        let change = increment(&[6, 9], x);
        flat(&Constrained(mechanism).rates(0.0, &state, &change).unwrap())
    };
    for column in 0..system.a.ncols() {
        let direction = system.basis.column(column).into_owned();
        let difference = |h: f64| (rates(&(&direction * h)) - rates(&(&direction * -h))) / (2.0 * h);
        // steps so large that round-off is small; three of them take the errors of second and fourth order out
        let h = 2e-4 / direction.amax();
        let (first, second, third) = (difference(h), difference(h / 2.0), difference(h / 4.0));
        let (one, two) = ((&second * 4.0 - first) / 3.0, (third * 4.0 - &second) / 3.0);
        let expected = (two * 16.0 - one) / 15.0;
        // what bends the surface of the constraints is at right angles to it in the kinetic energy, and so is projected away
        let found = &system.projection * &expected;
        let worst = (found - system.a.column(column)).amax();
        assert!(worst < DIFFERENCES * expected.amax(), "column {column}: {worst:e} of {:e}", expected.amax());
    }
    assert!(mechanism.is_finite(&state));
}

fn increment(sizes: &[usize], x: &DVector<f64>) -> HostIncrement {
    let (n, mut start) = (x.len() / 2, 0);
    let bodies = sizes.iter().map(|size| {
        let three = |offset: usize| x.fixed_rows::<3>(offset).into_owned();
        let modal = |offset: usize| HostModal(x.rows(offset + 6, size - 6).into_owned());
        let body = Increment {
            position: three(start),
            rotation: three(start + 3),
            modal_coordinates: modal(start),
            velocity: three(n + start),
            angular_velocity: three(n + start + 3),
            modal_rates: modal(n + start),
        };
        start += size;
        body
    });
    HostIncrement(bodies.collect())
}

fn flat(increment: &HostIncrement) -> DVector<f64> {
    let (mut places, mut velocities) = (Vec::new(), Vec::new());
    for body in &increment.0 {
        places
            .extend(body.position.iter().chain(body.rotation.iter()).chain(body.modal_coordinates.0.iter()));
        velocities.extend(
            body.velocity.iter().chain(body.angular_velocity.iter()).chain(body.modal_rates.0.iter()),
        );
    }
    DVector::from_vec(places.into_iter().chain(velocities).copied().collect())
}
