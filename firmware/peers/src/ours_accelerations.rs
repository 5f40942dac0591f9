//! Our accelerations alone.
#![no_std]
#![no_main]

mod state;

use cortex_m_rt::entry;
use state::{ALL, Scalar, show, state};

use ffrf::nalgebra::{SVector, Vector3};
use ffrf::{FlexibleBody, GeneralisedForce};
use state::Body;

#[inline(never)]
fn measured(out: &mut [Scalar; ALL], state: &state::State) {
    let force = GeneralisedForce::from_vector(&SVector::from(state.force));
    let (q, q_dot) = (SVector::from(state.q), SVector::from(state.q_dot));
    *out =
        Body.forward_dynamics(&q, &Vector3::from(state.omega), &q_dot, &force).to_vector::<ALL>().data.0[0];
}

#[entry]
fn main() -> ! {
    let state = state();
    let mut out = [0.0; ALL];
    let good = probe::measure("accelerations", || {
        measured(&mut out, &state);
        true
    });
    show(&out);
    probe::finish(good)
}
