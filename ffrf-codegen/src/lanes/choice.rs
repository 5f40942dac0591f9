//! Which strategy a body gets.

use ffrf_model::ReducedBody;

use super::LaneTables;
use crate::body::BodyExpressions;
use crate::expression::Graph;
use crate::formulate::ConstantFactors;
use crate::options::Strategy;
use crate::{CodegenError, FusedMultiplyAdd, GenerateOptions};

/// From this number of modes on, lanes are chosen. Measured, see benches/kernels.md.
const LANES_FROM: usize = 7;

/// The tables in the code that [`generate`](crate::generate) makes of a body; `None` if that code is straight-line.
///
/// Whoever runs the loops of the runtime over them computes what the generated code computes.
/// Errors: as those of `generate`.
pub fn tables_of(body: &ReducedBody, options: &GenerateOptions) -> Result<Option<LaneTables>, CodegenError> {
    let body = crate::prepare(body, options)?;
    let mut graph = Graph::new();
    let expressions = BodyExpressions::baked(&mut graph, &body, options.layout_tolerance)
        .truncated(&mut graph, &options.fidelity);
    choose(&mut graph, &expressions, options)
}

/// The tables if the body is to be computed in lanes, `None` for straight-line code.
///
/// Lanes need at least one mode, and leave the contraction of products and sums to the target.
/// Errors: lanes were demanded where they cannot be had, the modes depend on each other, or they contain rigid-body
/// motion.
pub(crate) fn choose(
    graph: &mut Graph,
    body: &BodyExpressions,
    options: &GenerateOptions,
) -> Result<Option<LaneTables>, CodegenError> {
    if in_lanes(body.mode_count(), None, options)? {
        tables(graph, body, options).map(Some)
    } else {
        Ok(None)
    }
}

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

fn tables(
    graph: &mut Graph,
    body: &BodyExpressions,
    options: &GenerateOptions,
) -> Result<LaneTables, CodegenError> {
    let factors = ConstantFactors::new(graph, body)?;
    Ok(LaneTables::arrange(graph, body, options.scalar, &factors).numbers(graph))
}
