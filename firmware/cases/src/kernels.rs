//! Every kernel of a body in states that repeat on every target.

use ffrf::nalgebra::{self, SVector, Vector3};
use ffrf::{DenseForms, FlexibleBody, GeneralisedForce, Observables};

use crate::bodies::{Eight32, Eight64, Four32, Four64, Rigid32, Rigid64};
use crate::{Bits, Hash, Sink};

/// How far modes are deformed. Units: those of the modes (mass-normalised), m kg^½.
const DEFORMATION: f64 = 1e-4;

/// Numbers of a linear congruential generator (Knuth, MMIX), from -1 to 1: sums and products of integers, the same everywhere.
struct Numbers(u64);

impl Numbers {
    fn next<T: Bits>(&mut self) -> T {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        // 24 bits fit into either scalar without rounding
        nalgebra::convert(f64::from((self.0 >> 40) as u32) / 8_388_608.0 - 1.0)
    }

    fn vector<T: Bits, const R: usize>(&mut self, scale: f64) -> SVector<T, R> {
        SVector::from_fn(|_, _| self.next::<T>() * nalgebra::convert(scale))
    }
}

fn hash_motion<T: Bits, const M: usize>(hash: &mut Hash, motion: &GeneralisedForce<SVector<T, M>, T>) {
    hash.numbers(motion.force.as_slice());
    hash.numbers(motion.moment.as_slice());
    hash.numbers(motion.modal.as_slice());
}

fn every_kernel<T, B, const M: usize, const N: usize>(body: B, states: u32, sink: Sink<'_>)
where
    T: Bits,
    B: DenseForms<M, N, T> + Observables<T> + FlexibleBody<T, Modal = SVector<T, M>>,
{
    let mut numbers = Numbers(1);
    let (mut hash, mut mark) = (Hash::default(), 10);
    for done in 1..=states {
        let q = numbers.vector::<T, M>(DEFORMATION);
        let q_dot = numbers.vector::<T, M>(1.0);
        let (omega, velocity): (Vector3<T>, Vector3<T>) = (numbers.vector(60.0), numbers.vector(3.0));
        let force = numbers.vector::<T, N>(10.0);
        hash.numbers(body.mass_matrix(&q).as_slice());
        hash.numbers(body.quadratic_velocity(&q, &omega, &q_dot).as_slice());
        let equations = body.equations_of_motion(&q, &omega, &q_dot, &force);
        hash.numbers(equations.mass_matrix.as_slice());
        hash.numbers(equations.quadratic_velocity.as_slice());
        hash.numbers(equations.acceleration.as_slice());
        let resultant = GeneralisedForce::from_vector(&force);
        hash.numbers(body.forward_dynamics(&q, &omega, &q_dot, &resultant).to_vector::<N>().as_slice());
        hash.numbers(body.internal_force(&q, &q_dot).as_slice());
        hash_motion(&mut hash, &body.gravity_force(&q, &velocity));
        hash.numbers(&[body.kinetic_energy(&q, &velocity, &omega, &q_dot), body.elastic_energy(&q)]);
        hash.numbers(body.linear_momentum(&q, &velocity, &omega, &q_dot).as_slice());
        hash.numbers(body.angular_momentum(&q, &velocity, &omega, &q_dot).as_slice());
        if done == mark || done == states {
            sink(done, hash.0);
            mark = mark.saturating_mul(10);
        }
    }
}

macro_rules! cases {
    ($($name:ident: $body:ident $scalar:ident $modes:literal $all:literal;)*) => {$(
        pub fn $name(states: u32, sink: Sink<'_>) {
            every_kernel::<$scalar, $body, $modes, $all>($body, states, sink);
        }
    )*};
}

cases! {
    rigid_f32: Rigid32 f32 0 6;
    four_f32: Four32 f32 4 10;
    eight_f32: Eight32 f32 8 14;
    rigid_f64: Rigid64 f64 0 6;
    four_f64: Four64 f64 4 10;
    eight_f64: Eight64 f64 8 14;
}
