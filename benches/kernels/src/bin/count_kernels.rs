//! Calls one kernel so and so often, for instruction counts: `count_kernels NAME CALLS`, or `count_kernels --list`.
#![forbid(unsafe_code)]

use std::hint::black_box;

use ffrf::nalgebra::{SMatrix, SVector, Vector3};
use ffrf::{DenseForms, GeneralisedForce, Motion};

/// Calls the kernel of that name; `None` if the name belongs to another body.
///
/// Not inlined, so that the code of one body does not depend on how much of the others stands around it.
#[inline(never)]
fn call<const M: usize, const N: usize, B: DenseForms<M, N>>(
    body: &B,
    prefix: &str,
    name: &str,
    calls: usize,
) -> Option<()> {
    let kernel = name.strip_prefix(prefix)?.strip_prefix('/')?;
    let q = black_box(SVector::<f64, M>::from_element(0.01));
    let omega = black_box(Vector3::new(0.1, 0.2, 0.3));
    let force = black_box(SVector::<f64, N>::from_element(1.0));
    let parts = black_box(GeneralisedForce::from_vector(&force));
    let mut motion = Motion::zeros(&q);
    let mut mass = Box::new(SMatrix::<f64, N, N>::zeros());
    let (mut quadratic, mut acceleration) = (SVector::zeros(), SVector::zeros());
    for _ in 0..calls {
        match kernel {
            "equations_of_motion" => body.write_equations_of_motion(
                &q,
                &omega,
                &q,
                &force,
                &mut mass,
                &mut quadratic,
                &mut acceleration,
            ),
            "forward_dynamics" => motion = body.forward_dynamics(&q, &omega, &q, &parts),
            _ => return None,
        }
        black_box((&mass, &quadratic, &acceleration, &motion));
    }
    Some(())
}

macro_rules! bodies {
    ($($name:ident $modes:literal $size:literal;)*) => {
        const NAMES: &[&str] = &[$(
            concat!(stringify!($name), "/equations_of_motion"),
            concat!(stringify!($name), "/forward_dynamics"),
        )*];

        fn find(name: &str, calls: usize) -> Option<()> {
            let mut found = None;
            $(found = found.or_else(|| {
                call::<$modes, $size, _>(&kernels::$name::Body, stringify!($name), name, calls)
            });)*
            found
        }
    };
}

bodies! {
    general_m1 1 7;
    general_m2 2 8;
    general_m4 4 10;
    general_m8 8 14;
    general_m16 16 22;
    general_m32 32 38;
    general_m64 64 70;
    free_free_m4 4 10;
    free_free_m16 16 22;
}

fn main() -> Result<(), String> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    match arguments.as_slice() {
        [list] if list == "--list" => {
            NAMES.iter().for_each(|name| println!("{name}"));
            Ok(())
        }
        [name, calls] => {
            let calls = calls.parse().map_err(|_| format!("expected a number of calls, found `{calls}`"))?;
            find(name, calls).ok_or_else(|| format!("unknown kernel `{name}`, see --list"))
        }
        _ => Err("usage: count_kernels NAME CALLS, or count_kernels --list".to_owned()),
    }
}
