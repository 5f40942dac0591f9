//! Pivots of eliminations that are known when the code is generated.

use crate::expression::{Expression, Graph};

/// A pivot that is not positive.
pub(super) struct BadPivot {
    /// Its value.
    pub(super) found: f64,
    /// What it would have to exceed.
    pub(super) expected: f64,
}

/// The pivot if it is a constant that is not positive by more than round-off of `whole`, the entry that it is left of.
pub(super) fn bad_pivot(graph: &Graph, pivot: Expression, whole: Expression) -> Option<BadPivot> {
    let expected = graph.constant_value(whole).unwrap_or(0.0) * 1e-14;
    let found = graph.constant_value(pivot)?;
    (found.is_nan() || found <= expected).then_some(BadPivot { found, expected })
}
