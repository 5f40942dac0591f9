//! Bodies for every number type: the same numbers as in f64 and f32, and derivatives by dual numbers.

#![allow(clippy::unwrap_used)] // helpers of tests are tests

use ffrf::nalgebra::{RealField, SVector, Vector3, convert};
use ffrf::{
    DenseForms, FlexibleBody, FlexibleBodyJacobians, FreeBody, GeneralisedForce, NamedMarkers, Observables,
    State, flexible_body,
};
use num_dual::Dual64;

flexible_body! {
    /// Eight modes: loops over lanes.
    pub struct Rod { model: "models/conrod.ffrf.json", scalar: generic }
}

flexible_body! {
    pub struct PlainRod { model: "models/conrod.ffrf.json" }
}

flexible_body! {
    pub struct SingleRod { model: "models/conrod.ffrf.json", scalar: f32 }
}

flexible_body! {
    /// Dense Θ_ff, four modes: statements.
    pub struct Random { model: "tests/models/random_m4.ffrf.json", scalar: generic, jacobians: true }
}

flexible_body! {
    pub struct PlainRandom { model: "tests/models/random_m4.ffrf.json", jacobians: true }
}

flexible_body! {
    /// Invariants at run time stay f64.
    pub struct Open { modes: 1, layout: { modal_mass: diagonal }, scalar: generic }
}

/// Both sides compute the same sums; contraction and order differ.
const ROUNDING: f64 = 1e-12;
/// The same in single precision.
const SINGLE: f64 = 2e-5;

/// A state of `M` modes: q, ω, q̇ and a force, of sizes at which every term counts.
struct Point<const M: usize, const N: usize, T> {
    q: SVector<T, M>,
    omega: Vector3<T>,
    q_dot: SVector<T, M>,
    force: SVector<T, N>,
}

fn point<const M: usize, const N: usize, T: RealField + Copy>(size: f64) -> Point<M, N, T> {
    let number = |k: usize, factor: f64| convert::<f64, T>(factor * ((7 * k + 3) as f64).sin());
    Point {
        q: SVector::from_fn(|k, _| number(k, size)),
        omega: Vector3::from_fn(|k, _| number(k + 20, 3.0)),
        q_dot: SVector::from_fn(|k, _| number(k + 40, 10.0 * size)),
        force: SVector::from_fn(|k, _| number(k + 60, 5.0)),
    }
}

#[track_caller]
fn close<'a>(found: impl IntoIterator<Item = &'a f64>, expected: &[f64], tolerance: f64) {
    let scale = expected.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
    for (found, expected) in found.into_iter().zip(expected) {
        assert!((found - expected).abs() <= tolerance * scale, "{found} for {expected} of {scale}");
    }
}

/// Every kernel of `generic` in f64 against `plain`.
fn same<const M: usize, const N: usize>(
    generic: &(impl DenseForms<M, N> + Observables),
    plain: &(impl DenseForms<M, N> + Observables),
    size: f64,
) {
    let Point { q, omega, q_dot, force } = point::<M, N, f64>(size);
    let velocity = Vector3::new(0.3, -2.0, 1.0);
    close(generic.mass_matrix(&q).iter(), plain.mass_matrix(&q).as_slice(), ROUNDING);
    let (found, expected) =
        (generic.quadratic_velocity(&q, &omega, &q_dot), plain.quadratic_velocity(&q, &omega, &q_dot));
    close(found.iter(), expected.as_slice(), ROUNDING);
    let resultant = GeneralisedForce::from_vector(&force);
    let expected = plain.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>();
    let found = generic.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>();
    close(found.iter(), expected.as_slice(), ROUNDING);
    let (found, expected) = (
        generic.equations_of_motion(&q, &omega, &q_dot, &force),
        plain.equations_of_motion(&q, &omega, &q_dot, &force),
    );
    close(found.mass_matrix.iter(), expected.mass_matrix.as_slice(), ROUNDING);
    close(found.quadratic_velocity.iter(), expected.quadratic_velocity.as_slice(), ROUNDING);
    close(found.acceleration.iter(), expected.acceleration.as_slice(), ROUNDING);
    let expected = plain.kinetic_energy(&q, &velocity, &omega, &q_dot);
    close([&generic.kinetic_energy(&q, &velocity, &omega, &q_dot)], &[expected], ROUNDING);
    close([&generic.elastic_energy(&q)], &[plain.elastic_energy(&q)], ROUNDING);
    let momentum = plain.angular_momentum(&q, &velocity, &omega, &q_dot);
    close(generic.angular_momentum(&q, &velocity, &omega, &q_dot).iter(), momentum.as_slice(), ROUNDING);
    let momentum = plain.linear_momentum(&q, &velocity, &omega, &q_dot);
    close(generic.linear_momentum(&q, &velocity, &omega, &q_dot).iter(), momentum.as_slice(), ROUNDING);
    let weight = plain.gravity_force(&q, &velocity).to_vector::<N>();
    close(generic.gravity_force(&q, &velocity).to_vector::<N>().iter(), weight.as_slice(), ROUNDING);
}

#[test]
fn a_generic_body_in_f64_is_the_f64_body() {
    same::<8, 14>(&Rod, &PlainRod, 1e-5);
    same::<4, 10>(&Random, &PlainRandom, 0.1);
}

#[test]
fn a_generic_body_in_f32_is_the_f32_body() {
    let Point { q, omega, q_dot, force } = point::<8, 14, f32>(1e-5);
    let force = GeneralisedForce::from_vector(&force);
    let found = Rod.forward_dynamics(&q, &omega, &q_dot, &force).to_vector::<14>().map(f64::from);
    let expected = SingleRod.forward_dynamics(&q, &omega, &q_dot, &force).to_vector::<14>().map(f64::from);
    for rows in [0..3, 3..6, 6..14] {
        let (found, expected) = (&found.as_slice()[rows.clone()], &expected.as_slice()[rows]);
        close(found, expected, SINGLE);
    }
}

#[test]
fn markers_of_a_generic_body_come_in_every_number_type() {
    let names = NamedMarkers::<f64>::marker_names(&Rod);
    assert_eq!(names, ["BIG_END", "SMALL_END"]);
    let plain = PlainRod.marker("SMALL_END").unwrap();
    assert_eq!(Rod::SMALL_END, plain);
    let dual: ffrf::Marker<SVector<Dual64, 8>, Dual64> = Rod.marker("SMALL_END").unwrap();
    assert_eq!(dual.position.map(|x| x.re), plain.position);
    assert_eq!(NamedMarkers::<f32>::marker(&Rod, "TIP"), None);
}

/// Derivatives of the accelerations with respect to one entry of [q; ω; q̇; force].
fn derivative<const M: usize, const N: usize>(
    body: &impl DenseForms<M, N, Dual64>,
    size: f64,
    direction: usize,
) -> SVector<f64, N> {
    let mut at = point::<M, N, Dual64>(size);
    let inputs = at.q.iter_mut().chain(at.omega.iter_mut()).chain(at.q_dot.iter_mut());
    inputs.chain(at.force.iter_mut()).nth(direction).unwrap().eps = 1.0;
    let force = GeneralisedForce::from_vector(&at.force);
    let all: SVector<Dual64, N> = body.forward_dynamics(&at.q, &at.omega, &at.q_dot, &force).to_vector();
    all.map(|acceleration| acceleration.eps)
}

#[test]
fn dual_numbers_through_statements_give_the_analytic_jacobian() {
    let Point { q, omega, q_dot, force } = point::<4, 10, f64>(0.1);
    let jacobian = PlainRandom.acceleration_jacobian(&q, &omega, &q_dot, &force);
    let columns = jacobian.coordinates.column_iter().chain(jacobian.angular_velocity.column_iter());
    let columns = columns.chain(jacobian.rates.column_iter()).chain(jacobian.force.column_iter());
    for (direction, column) in columns.enumerate() {
        let found = derivative::<4, 10>(&Random, 0.1, direction);
        close(found.iter(), column.into_owned().as_slice(), 1e-10);
    }
    // Jacobians of a generic body are generic, too: their own derivative would be the second one.
    let generic = Random.acceleration_jacobian(&q, &omega, &q_dot, &force);
    close(generic.coordinates.iter(), jacobian.coordinates.as_slice(), 1e-10);
}

flexible_body! {
    struct DifferentiatedRod { model: "models/conrod.ffrf.json", strategy: straight_line, jacobians: true }
}

#[test]
fn dual_numbers_through_loops_give_the_analytic_jacobian() {
    let Point { q, omega, q_dot, force } = point::<8, 14, f64>(1e-5);
    let jacobian = DifferentiatedRod.acceleration_jacobian(&q, &omega, &q_dot, &force);
    let columns = jacobian.coordinates.column_iter().chain(jacobian.angular_velocity.column_iter());
    let columns = columns.chain(jacobian.rates.column_iter()).chain(jacobian.force.column_iter());
    for (direction, column) in columns.enumerate() {
        let found = derivative::<8, 14>(&Rod, 1e-5, direction);
        close(found.iter(), column.into_owned().as_slice(), 1e-10);
    }
}

/// A whole flight with dual numbers: the derivative of where a marker ends with respect to the spin at the start.
#[test]
fn a_flight_in_dual_numbers_knows_how_it_depends_on_its_start() {
    fn flight<T: RealField + Copy>(spin: T) -> Vector3<T> {
        let number = |x: f64| convert::<f64, T>(x);
        let mut rod = FreeBody::<_, T>::new(Rod).with_spin(Vector3::new(spin, number(20.0), number(1.0)));
        for _ in 0..200 {
            rod.step_rk4(number(2e-5), &()).unwrap();
        }
        let state: State<SVector<T, 8>, T> = rod.state;
        let marker = Rod::SMALL_END.cast::<T>();
        state.position + state.orientation * marker.position(&state.modal_coordinates)
    }
    let start = 5.0;
    let mut spin = Dual64::from(start);
    spin.eps = 1.0;
    let found = flight(spin).map(|place| place.eps);
    let step = 1e-4;
    let expected = (flight(start + step) - flight(start - step)) / (2.0 * step);
    // The difference quotient is good to step² and to rounding / step.
    close(found.iter(), expected.as_slice(), 1e-7);
}

#[test]
fn invariants_at_run_time_stay_plain_numbers() {
    let body = Open {
        mass: 2.0,
        first_moment: [0.1, 0.0, 0.0],
        modal_first_moment: [[0.0, 0.2, 0.0]],
        second_moment: [[1.0, 0.0, 0.0], [0.0, 2.0, 0.0], [0.0, 0.0, 3.0]],
        position_mode_moment: [[[0.0, 0.3, 0.0], [0.1, 0.0, 0.0], [0.0, 0.0, 0.0]]],
        mode_mode_moment: [[[[0.5, 0.0, 0.0], [0.0, 0.25, 0.0], [0.0, 0.0, 0.25]]]],
        stiffness: [[9.0]],
        damping: [[0.0]],
    };
    let q = SVector::<Dual64, 1>::from_element({
        let mut q = Dual64::from(0.1);
        q.eps = 1.0;
        q
    });
    let energy = Observables::<Dual64>::elastic_energy(&body, &q);
    assert!((energy.re - 0.045).abs() < 1e-15 && (energy.eps - 0.9).abs() < 1e-14, "{energy}");
}
