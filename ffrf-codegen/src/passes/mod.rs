//! The passes between formulation and emission, one file each, in their order:
//!
//! 1. constant folding, zero and one elision, changes of sign: `expression/rules`, on insertion of each node;
//! 2. common subexpressions: [`Graph::insert`](crate::expression::Graph::insert), which gives an equal node the same handle;
//! 3. dead code, factors, fused multiply-add (optional), dead code again, order: here, on the whole graph. Functions
//!    on arrays: inverses before those, or nothing but dead code and order.

mod dead_code;
mod factor;
mod fuse;
mod inverse;
mod order;
mod rewrite;

pub(crate) use rewrite::use_counts;

use crate::FusedMultiplyAdd;
use crate::formulate::Kernel;

/// A pass: the same results by other expressions.
type Pass = fn(Kernel) -> Kernel;

/// The passes that leave every operation as it is: what is needed, in the order of its first use.
pub(crate) fn run_exactly(kernel: Kernel) -> Kernel {
    order::run(dead_code::run(kernel))
}

/// [`run`] with one division for each number that is divided by more than once.
pub(crate) fn run_with_inverses(kernel: Kernel, fused_multiply_add: FusedMultiplyAdd) -> Kernel {
    run(inverse::run(kernel), fused_multiply_add)
}

/// Every pass, in order.
pub fn run(kernel: Kernel, fused_multiply_add: FusedMultiplyAdd) -> Kernel {
    let fuse: &[Pass] = match fused_multiply_add {
        FusedMultiplyAdd::Off => &[],
        FusedMultiplyAdd::Auto | FusedMultiplyAdd::On => &[fuse::run],
    };
    let passes: &[Pass] = &[dead_code::run, factor::run];
    passes
        .iter()
        .chain(fuse)
        .chain(&[dead_code::run as Pass, order::run])
        .fold(kernel, |kernel, pass| pass(kernel))
}
