//! Times generated bodies and the naive form: `cargo run --release [rounds]`; JSON lines on standard output.
#![forbid(unsafe_code)]

use std::hint::black_box;

use ffrf::nalgebra::{RealField, SMatrix, SVector, Vector3, convert};
use ffrf::{EquationsOfMotion, FlexibleBody};
use kernels::cases;
use kernels::naive_body::{Invariants, NaiveBody};
use kernels::random_body::Random;
use kernels::timing::{Column, time};

struct States<const M: usize, const N: usize, T> {
    q: Vec<SVector<T, M>>,
    omega: Vec<Vector3<T>>,
    q_dot: Vec<SVector<T, M>>,
    force: Vec<SVector<T, N>>,
}

impl<const M: usize, const N: usize, T: RealField + Copy> States<M, N, T> {
    fn new() -> Self {
        let mut random = Random::new(7);
        let mut states = Self { q: vec![], omega: vec![], q_dot: vec![], force: vec![] };
        for _ in 0..32 {
            states.q.push(SVector::from_fn(|_, _| convert(0.2 * random.number())));
            states.omega.push(Vector3::from_fn(|_, _| convert(2.0 * random.number())));
            states.q_dot.push(SVector::from_fn(|_, _| convert(random.number())));
            states.force.push(SVector::from_fn(|_, _| convert(random.number())));
        }
        states
    }
}

/// Two columns of one body: everything in one pass into a place used again, and accelerations alone.
fn columns<'a, const M: usize, const N: usize, T, B>(
    name: &str,
    body: &'a B,
    states: &'a States<M, N, T>,
) -> [Column<'a>; 2]
where
    T: RealField + Copy,
    B: FlexibleBody<M, N, T>,
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
            name: format!("{name} equations_of_motion"),
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
            name: format!("{name} forward_dynamics"),
            call: Box::new(move |k| {
                black_box(body.forward_dynamics(&s.q[k], &s.omega[k], &s.q_dot[k], &s.force[k]));
            }),
        },
    ]
}

fn naive<const M: usize, const N: usize>() -> NaiveBody<M, N> {
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

macro_rules! timed {
    ($rounds:expr; $($modes:literal $size:literal $general:ident $single:ident $free:ident;)*) => {$({
        let states = States::<$modes, $size, f64>::new();
        let states_single = States::<$modes, $size, f32>::new();
        let naive = Box::new(naive::<$modes, $size>());
        let mut all: Vec<Column<'_>> = Vec::new();
        all.extend(columns("general", &kernels::$general::Body, &states));
        all.extend(columns("naive", &*naive, &states));
        all.extend(columns("free-free", &kernels::$free::Body, &states));
        all.extend(columns("general f32", &kernels::$single::Body, &states_single));
        let times = time(&mut all, $rounds);
        for (column, time) in all.iter().zip(times) {
            println!(
                "{{\"modes\": {}, \"column\": \"{}\", \"minimum_ns\": {:.1}, \"median_ns\": {:.1}}}",
                $modes, column.name, time.minimum, time.median
            );
        }
    })*};
}

fn main() {
    let rounds = std::env::args().nth(1).and_then(|text| text.parse().ok()).unwrap_or(200);
    timed! { rounds;
        1 7 general_m1 single_m1 free_free_m1;
        2 8 general_m2 single_m2 free_free_m2;
        4 10 general_m4 single_m4 free_free_m4;
        8 14 general_m8 single_m8 free_free_m8;
        16 22 general_m16 single_m16 free_free_m16;
        32 38 general_m32 single_m32 free_free_m32;
        64 70 general_m64 single_m64 free_free_m64;
    }
}
