//! A kernel: expressions with a signature.

use super::{Definition, DeformedBody, Draft, Signature, State};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Graph};

/// A kernel: expressions with a signature.
#[derive(Debug, Clone)]
pub struct Kernel {
    /// What it takes and gives.
    pub signature: Signature,
    /// Number of modes M.
    pub mode_count: usize,
    /// The expressions, with headings and names.
    pub graph: Draft,
    /// The results, one after another; matrices column by column.
    pub outputs: Vec<Expression>,
}

impl Kernel {
    /// Writes the kernel of a body whose invariants are expressions of `graph`.
    ///
    /// Errors: see [`forward_dynamics`](super::forward_dynamics).
    pub fn formulate(
        definition: &Definition,
        graph: Graph,
        body: &BodyExpressions,
    ) -> Result<Self, CodegenError> {
        let mut graph = Draft::new(graph);
        let mode_count = body.mode_count();
        let state = State::symbolic(&mut graph, mode_count);
        let deformed = DeformedBody::new(&mut graph, body, &state);
        let outputs = (definition.formulate)(&mut graph, body, &state, &deformed)?;
        Ok(Self { signature: definition.signature, mode_count, graph, outputs })
    }
}
