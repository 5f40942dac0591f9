//! What is timed: the kernels of a body at random states.

use std::hint::black_box;

use ffrf::nalgebra::{RealField, SMatrix, SVector, Vector3, convert};
use ffrf::{DenseForms, EquationsOfMotion, GeneralisedForce};

use crate::cases;
use crate::timing::Column;
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};
use ffrf_test_kit::random::Random;

/// Name of the column with everything in one pass, into a place that is used again.
pub const EQUATIONS: &str = "equations_of_motion";
/// Name of the column with accelerations alone.
pub const ACCELERATIONS: &str = "forward_dynamics";

/// Random states of bodies with `M` modes.
pub struct States<const M: usize, const N: usize, T> {
    /// Modal coordinates.
    pub q: Vec<SVector<T, M>>,
    /// Angular velocities.
    pub omega: Vec<Vector3<T>>,
    /// Modal rates.
    pub q_dot: Vec<SVector<T, M>>,
    /// Generalised forces.
    pub force: Vec<SVector<T, N>>,
    /// The same in named parts.
    pub parts: Vec<GeneralisedForce<SVector<T, M>, T>>,
}

impl<const M: usize, const N: usize, T: RealField + Copy> States<M, N, T> {
    /// 32 of them.
    #[allow(clippy::new_without_default)]
    pub fn new() -> Self {
        let mut random = Random::new(7);
        let mut states = Self { q: vec![], omega: vec![], q_dot: vec![], force: vec![], parts: vec![] };
        for _ in 0..32 {
            states.q.push(SVector::from_fn(|_, _| convert(0.2 * random.number())));
            states.omega.push(Vector3::from_fn(|_, _| convert(2.0 * random.number())));
            states.q_dot.push(SVector::from_fn(|_, _| convert(random.number())));
            let force = SVector::from_fn(|_, _| convert(random.number()));
            states.force.push(force);
            states.parts.push(GeneralisedForce::from_vector(&force));
        }
        states
    }
}

/// Two columns of one body: [`EQUATIONS`] and [`ACCELERATIONS`].
pub fn columns<'a, const M: usize, const N: usize, T, B>(
    name: &str,
    body: &'a B,
    states: &'a States<M, N, T>,
) -> [Column<'a>; 2]
where
    T: RealField + Copy,
    B: DenseForms<M, N, T>,
{
    let zero = SVector::<T, N>::zeros();
    let mut equations = Box::new(EquationsOfMotion::<M, N, T> {
        mass_matrix: SMatrix::<T, N, N>::zeros(),
        quadratic_velocity: zero,
        acceleration: zero,
    });
    let s = states;
    [
        Column {
            name: format!("{name} {EQUATIONS}"),
            call: Box::new(move |k| {
                let EquationsOfMotion { mass_matrix, quadratic_velocity, acceleration } = &mut *equations;
                body.write_equations_of_motion(
                    &s.q[k],
                    &s.omega[k],
                    &s.q_dot[k],
                    &s.force[k],
                    mass_matrix,
                    quadratic_velocity,
                    acceleration,
                );
                black_box(&*equations);
            }),
        },
        Column {
            name: format!("{name} {ACCELERATIONS}"),
            call: Box::new(move |k| {
                black_box(body.forward_dynamics(&s.q[k], &s.omega[k], &s.q_dot[k], &s.parts[k]));
            }),
        },
    ]
}

/// The naive form of the general body with `M` modes.
pub fn naive<const M: usize, const N: usize>() -> NaiveBody<M, N> {
    let case = cases::all().into_iter().find(|case| case.name == format!("general_m{M}"));
    let body = case.expect("every timed number of modes has a general case").body;
    let inertia = &body.inertia;
    let modal = |matrix: &[Vec<f64>]| std::array::from_fn(|mu| std::array::from_fn(|nu| matrix[mu][nu]));
    NaiveBody::new(&Invariants {
        mass: inertia.mass,
        centre_of_mass: inertia.first_moment.map(|x| x / inertia.mass),
        modal_centre_of_mass: std::array::from_fn(|mu| {
            inertia.modal_first_moment[mu].map(|x| x / inertia.mass)
        }),
        euler_tensor: inertia.second_moment,
        modal_euler_tensor: std::array::from_fn(|mu| inertia.position_mode_moment[mu]),
        modal_pair_euler_tensor: std::array::from_fn(|mu| {
            std::array::from_fn(|nu| inertia.mode_mode_moment[mu][nu])
        }),
        stiffness: modal(&body.stiffness),
        damping: modal(&body.damping),
    })
}
