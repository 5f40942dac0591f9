//! Mass matrix, quadratic velocity vector and accelerations, by C: CasADi's, or ours.
#![no_std]
#![no_main]

mod state;

use cortex_m_rt::entry;
use state::{ALL, Scalar, show, state};

unsafe extern "C" {
    fn ffrf_equations(
        q: *const Scalar,
        r: *const Scalar,
        w: *const Scalar,
        f: *const Scalar,
        m: *mut Scalar,
        g: *mut Scalar,
        a: *mut Scalar,
    );
}

#[entry]
fn main() -> ! {
    let state = state();
    let (mut matrix, mut quadratic, mut out) = ([[0.0; ALL]; ALL], [0.0; ALL], [0.0; ALL]);
    let good = probe::measure("equations", || {
        let (q, r) = (state.q.as_ptr(), state.q_dot.as_ptr());
        let (m, g, a) = (matrix.as_flattened_mut().as_mut_ptr(), quadratic.as_mut_ptr(), out.as_mut_ptr());
        // SAFETY: the arrays have the lengths that the function was generated for.
        unsafe { ffrf_equations(q, r, state.omega.as_ptr(), state.force.as_ptr(), m, g, a) };
        true
    });
    show(matrix.as_flattened());
    show(&quadratic);
    show(&out);
    probe::finish(good)
}
