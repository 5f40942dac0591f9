//! The C interface of benches/peers around a generated body.

use ffrf_runtime::nalgebra::{SMatrix, SVector, Vector3};
use ffrf_runtime::{DenseForms, FlexibleBody, GeneralisedForce};

include!(concat!(env!("OUT_DIR"), "/size.rs"));

#[cfg(not(feature = "naive"))]
mod generated {
    include!(concat!(env!("OUT_DIR"), "/body.rs"));
}

#[cfg(feature = "naive")]
mod naive;

#[cfg(not(feature = "naive"))]
fn body() -> &'static generated::Body {
    &generated::Body
}
#[cfg(feature = "naive")]
use naive::body;

/// Whether this library has `modes` modes.
#[unsafe(no_mangle)]
pub extern "C" fn ffrf_prepare(modes: i32, invariants: *const f64) -> i32 {
    #[cfg(feature = "naive")]
    naive::prepare(invariants);
    #[cfg(not(feature = "naive"))]
    let _ = invariants;
    i32::from(usize::try_from(modes) != Ok(M))
}

/// Mass matrix, quadratic velocity vector and accelerations.
#[unsafe(no_mangle)]
pub extern "C" fn ffrf_equations(
    q: &SVector<f64, M>,
    q_dot: &SVector<f64, M>,
    omega: &Vector3<f64>,
    force: &SVector<f64, N>,
    mass: &mut SMatrix<f64, N, N>,
    quadratic: &mut SVector<f64, N>,
    acceleration: &mut SVector<f64, N>,
) {
    body().write_equations_of_motion(q, omega, q_dot, force, mass, quadratic, acceleration);
}

/// Accelerations alone.
#[unsafe(no_mangle)]
pub extern "C" fn ffrf_accelerations(
    q: &SVector<f64, M>,
    q_dot: &SVector<f64, M>,
    omega: &Vector3<f64>,
    force: &SVector<f64, N>,
    acceleration: &mut SVector<f64, N>,
) {
    let force = GeneralisedForce::from_vector(force);
    *acceleration = body().forward_dynamics(q, omega, q_dot, &force).to_vector();
}
