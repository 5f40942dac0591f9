//! A kernel: expressions with a signature.

use super::{Definition, DeformedBody, Draft, Output, Shape, Signature, State};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::{Expression, Extent, Graph};

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

    /// The kernel with the diagonal as its result, if that is a symmetric matrix over the modes and zero elsewhere.
    pub(crate) fn condensed(mut self) -> Self {
        let (size, graph) = (self.mode_count, &self.graph);
        let is_matrix =
            self.signature.outputs.iter().all(|output| output.shape == Shape::Symmetric(Extent::Modes));
        let is_off = |position: usize| position / size.max(1) != position % size.max(1);
        let mut entries = self.outputs.iter().enumerate();
        if is_matrix && entries.all(|(position, entry)| !is_off(position) || graph.is_zero(*entry)) {
            self.signature.outputs = &[Output { name: "diagonal", shape: Shape::Vector(Extent::Modes) }];
            self.outputs = self.outputs.into_iter().step_by(size + 1).collect();
        }
        self
    }
}
