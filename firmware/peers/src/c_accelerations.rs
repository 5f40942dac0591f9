//! Accelerations alone, by C: CasADi's, or ours.
#![no_std]
#![no_main]

mod state;

use cortex_m_rt::entry;
use state::{ALL, Scalar, show, state};

unsafe extern "C" {
    fn ffrf_accelerations(
        q: *const Scalar,
        r: *const Scalar,
        w: *const Scalar,
        f: *const Scalar,
        a: *mut Scalar,
    );
}

#[entry]
fn main() -> ! {
    let state = state();
    let mut out = [0.0; ALL];
    let good = probe::measure("accelerations", || {
        let (q, r) = (state.q.as_ptr(), state.q_dot.as_ptr());
        // SAFETY: the arrays have the lengths that the function was generated for.
        unsafe { ffrf_accelerations(q, r, state.omega.as_ptr(), state.force.as_ptr(), out.as_mut_ptr()) };
        true
    });
    show(&out);
    probe::finish(good)
}
