//! The passes between formulation and emission, one file each, in their order:
//!
//! 1. constant folding, zero and one elision, changes of sign: `expression/rules`, on insertion of each node;
//! 2. common subexpressions: [`Graph::insert`](crate::expression::Graph::insert), which gives an equal node the same handle;
//! 3. dead code, factors, fused multiply-add (optional), dead code again, order: here, on the whole graph.

mod dead_code;
mod factor;
mod fuse;
mod order;
mod rewrite;

pub(crate) use rewrite::use_counts;

use crate::FusedMultiplyAdd;
use crate::formulate::Kernel;

/// A pass: the same results by other expressions.
type Pass = fn(Kernel) -> Kernel;

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
