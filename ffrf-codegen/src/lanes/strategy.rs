//! Which strategy a body gets.

use crate::options::Strategy;
use crate::{CodegenError, FusedMultiplyAdd, GenerateOptions};

/// From this number of modes on, lanes are chosen. Measured, see benches/kernels.md.
const LANES_FROM: usize = 7;

/// Whether a body is to be computed in lanes; `obstacle` is what stands in the way besides its size and the options.
///
/// Errors: lanes were demanded where they cannot be had.
pub(super) fn in_lanes(
    modes: usize,
    obstacle: Option<&'static str>,
    options: &GenerateOptions,
) -> Result<bool, CodegenError> {
    let obstacle = if modes == 0 {
        Some("a body without modes has no lanes")
    } else if obstacle.is_some() {
        obstacle
    } else if options.fused_multiply_add != FusedMultiplyAdd::Auto {
        Some("they contract products and sums where the target does (fma: auto)")
    } else {
        None
    };
    match (options.strategy, obstacle) {
        (Strategy::Lanes, Some(reason)) => Err(CodegenError::NoLanes { reason }),
        (Strategy::Lanes, None) => Ok(true),
        (Strategy::StraightLine, _) | (Strategy::Auto, Some(_)) => Ok(false),
        (Strategy::Auto, None) => Ok(modes >= LANES_FROM),
    }
}
