//! The naive form, made from the invariants at run time.

use std::sync::OnceLock;

use crate::{M, N};
use ffrf_test_kit::naive_body::{Invariants, NaiveBody};

static BODY: OnceLock<Box<NaiveBody<M, N>>> = OnceLock::new();

/// Reads the invariants in the order of README.md.
pub fn prepare(invariants: *const f64) {
    // SAFETY: the interface promises that many numbers.
    let numbers = unsafe { core::slice::from_raw_parts(invariants, 13 + 13 * M + 9 * M * M) };
    let mut place = 0;
    let mut next = || {
        place += 1;
        numbers[place - 1]
    };
    let mass = next();
    let centre_of_mass = [next(), next(), next()];
    let inertia = matrix(&mut next);
    let half_trace = 0.5 * (inertia[0][0] + inertia[1][1] + inertia[2][2]);
    let euler_tensor =
        [0, 1, 2].map(|i| [0, 1, 2].map(|j| if i == j { half_trace } else { 0.0 } - inertia[i][j]));
    let invariants = Box::new(Invariants::<M> {
        mass,
        centre_of_mass,
        modal_centre_of_mass: [(); M].map(|()| [next(), next(), next()]),
        euler_tensor,
        modal_euler_tensor: [(); M].map(|()| matrix(&mut next)),
        modal_pair_euler_tensor: [(); M].map(|()| [(); M].map(|()| matrix(&mut next))),
        stiffness: std::array::from_fn(|mu| {
            let stiffness = next();
            std::array::from_fn(|nu| if mu == nu { stiffness } else { 0.0 })
        }),
        damping: [[0.0; M]; M],
    });
    BODY.get_or_init(|| Box::new(NaiveBody::new(&invariants)));
}

fn matrix(next: &mut impl FnMut() -> f64) -> [[f64; 3]; 3] {
    [(); 3].map(|()| [next(), next(), next()])
}

/// The body.
pub fn body() -> &'static NaiveBody<M, N> {
    BODY.get().expect("ffrf_prepare comes first")
}
