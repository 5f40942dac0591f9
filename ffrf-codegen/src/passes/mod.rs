//! The passes between formulation and emission, one file each, in their order.
//!
//! Folding, zero and one elision and common subexpressions need no pass: they happen on insertion.

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
