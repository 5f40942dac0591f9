//! Our mass matrix, quadratic velocity vector and accelerations.
#![no_std]
#![no_main]

mod state;

use cortex_m_rt::entry;
use state::{ALL, Scalar, show, state};

use ffrf::DenseForms;
use ffrf::nalgebra::{SMatrix, SVector, Vector3};
use state::Body;

#[inline(never)]
fn measured(
    matrix: &mut SMatrix<Scalar, ALL, ALL>,
    quadratic: &mut SVector<Scalar, ALL>,
    out: &mut SVector<Scalar, ALL>,
    state: &state::State,
) {
    let (q, q_dot) = (SVector::from(state.q), SVector::from(state.q_dot));
    let force = SVector::from(state.force);
    Body.write_equations_of_motion(&q, &Vector3::from(state.omega), &q_dot, &force, matrix, quadratic, out);
}

#[entry]
fn main() -> ! {
    let state = state();
    let (mut matrix, mut quadratic, mut out) = (SMatrix::zeros(), SVector::zeros(), SVector::zeros());
    let good = probe::measure("equations", || {
        measured(&mut matrix, &mut quadratic, &mut out, &state);
        true
    });
    show(matrix.as_slice());
    show(quadratic.as_slice());
    show(out.as_slice());
    probe::finish(good)
}
