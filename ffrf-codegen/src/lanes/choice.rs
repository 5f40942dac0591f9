//! What the loops of a body read, if its strategy is loops.

use ffrf_model::ReducedBody;

use super::LaneTables;
use super::parameters::{self, LaneParameters};
use super::strategy::in_lanes;
use crate::body::BodyExpressions;
use crate::expression::Graph;
use crate::formulate::ConstantFactors;
use crate::layout::Layout;
use crate::prepare::prepare;
use crate::{CodegenError, GenerateOptions, ScalarType};

/// Why the loops do not know [`LinearAccelerationStiffening`](crate::fidelity::EnergyTerm::LinearAccelerationStiffening).
const LINEAR_ACCELERATION: &str = "they factorise the mass that the modes leave for translation once for all states, which \
    `linear_acceleration_stiffening` makes one of the deformation";

/// The tables in the code that [`generate`](crate::generate) makes of a body; `None` if that code is straight-line.
///
/// Whoever runs the loops of the runtime over them computes what the generated code computes.
/// Errors: as those of `generate`.
pub fn tables_of(body: &ReducedBody, options: &GenerateOptions) -> Result<Option<LaneTables>, CodegenError> {
    let body = prepare(body, options)?;
    let mut graph = Graph::new();
    let expressions = BodyExpressions::baked(&mut graph, &body, options.layout_tolerance)
        .truncated(&mut graph, &options.fidelity);
    choose_tables(&mut graph, &expressions, options)
}

/// What the loops of a body read.
#[derive(Debug, Clone)]
pub(crate) enum Lanes {
    /// Constant tables.
    Tables(Box<LaneTables>),
    /// Fields.
    Parameters(LaneParameters),
}

impl Lanes {
    /// The tables of a body of constants if it is to be computed in lanes, `None` for straight-line code.
    ///
    /// Errors: as those of [`tables_of`].
    pub(crate) fn of_constants(
        graph: &mut Graph,
        body: &BodyExpressions,
        options: &GenerateOptions,
    ) -> Result<Option<Self>, CodegenError> {
        Ok(choose_tables(graph, body, options)?.map(|tables| Self::Tables(Box::new(tables))))
    }

    /// The same for a body whose invariants come at run time.
    ///
    /// Errors: lanes were demanded where they cannot be had.
    pub(crate) fn of_parameters(
        modes: usize,
        layout: &Layout,
        options: &GenerateOptions,
    ) -> Result<Option<Self>, CodegenError> {
        Ok(parameters::choose(modes, layout, options)?.map(Self::Parameters))
    }

    /// The strategy in words, for the banner.
    pub(crate) fn description(&self, scalar: ScalarType) -> String {
        match self {
            Self::Tables(tables) => tables.description(scalar),
            Self::Parameters(parameters) => parameters.description(),
        }
    }

    /// Bytes of the tables in the generated code; none where invariants come at run time.
    pub(crate) fn table_bytes(&self, scalar: ScalarType) -> usize {
        match self {
            Self::Tables(tables) => tables.bytes(scalar),
            Self::Parameters(_) => 0,
        }
    }
}

/// The tables if the body is to be computed in lanes, `None` for straight-line code.
///
/// Lanes need at least one mode, and leave the contraction of products and sums to the target.
/// Errors: lanes were demanded where they cannot be had, the modes depend on each other, or they contain rigid-body
/// motion.
fn choose_tables(
    graph: &mut Graph,
    body: &BodyExpressions,
    options: &GenerateOptions,
) -> Result<Option<LaneTables>, CodegenError> {
    let moments = body.second_order_first_moment.iter().flatten().flatten();
    let has_stiffening = moments.into_iter().any(|entry| !graph.is_zero(*entry));
    let obstacle = has_stiffening.then_some(LINEAR_ACCELERATION);
    if in_lanes(body.mode_count(), obstacle, options)? {
        tables(graph, body, options).map(Some)
    } else {
        Ok(None)
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
