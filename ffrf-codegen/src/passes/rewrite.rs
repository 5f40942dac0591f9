//! What all passes share: copying a kernel node by node into a new graph.

use crate::expression::{Expression, Graph, Node};
use crate::formulate::{Draft, Kernel};

/// Copies what the outputs need, in order, letting `change` write each node anew.
///
/// `change` gets the new graph, the node with its operands already renamed, and the old handle. Labels and sections
/// go along.
pub(super) fn rewrite(
    kernel: &Kernel,
    change: impl FnMut(&mut Graph, Node, Expression) -> Expression,
) -> Kernel {
    let needed = kernel.graph.reachable(&kernel.outputs);
    let order = kernel.graph.nodes().map(|(old, _)| old).zip(&needed);
    rewrite_in_order(kernel, order.filter(|(_, needed)| **needed).map(|(old, _)| old), change)
}

/// [`rewrite`] in another order, which holds every node that the outputs need, behind its operands.
pub(super) fn rewrite_in_order(
    kernel: &Kernel,
    order: impl IntoIterator<Item = Expression>,
    mut change: impl FnMut(&mut Graph, Node, Expression) -> Expression,
) -> Kernel {
    let mut graph = Draft::default();
    let mut renamed: Vec<Option<Expression>> = vec![None; kernel.graph.len()];
    for old in order {
        let node = kernel.graph.node(old);
        // Operands stand before their node and are needed with it.
        let new_name = |operand: Expression| renamed[operand.index()].unwrap_or(operand);
        graph.section(kernel.graph.section_of(old));
        let new = change(&mut graph, node.with_operands(new_name), old);
        if let Some(label) = kernel.graph.label_of(old) {
            graph.label(new, label);
        }
        renamed[old.index()] = Some(new);
    }
    let outputs = kernel.outputs.iter().map(|output| renamed[output.index()].unwrap_or(*output)).collect();
    Kernel { graph, outputs, signature: kernel.signature, mode_count: kernel.mode_count }
}

/// How often each node up to the last needed one is used by needed nodes and outputs.
pub(crate) fn use_counts(kernel: &Kernel) -> Vec<usize> {
    let needed = kernel.graph.reachable(&kernel.outputs);
    let mut counts = vec![0; needed.len()];
    for (handle, node) in kernel.graph.nodes().take(needed.len()) {
        if needed[handle.index()] {
            for operand in node.operands() {
                counts[operand.index()] += 1;
            }
        }
    }
    for output in &kernel.outputs {
        counts[output.index()] += 1;
    }
    counts
}

impl Node {
    /// The same operation with other operands.
    fn with_operands(self, new: impl Fn(Expression) -> Expression) -> Self {
        match self {
            Self::Constant(_) | Self::Symbol(_) => self,
            Self::Negate(a) => Self::Negate(new(a)),
            Self::Add(a, b) => Self::Add(new(a), new(b)),
            Self::Subtract(a, b) => Self::Subtract(new(a), new(b)),
            Self::Multiply(a, b) => Self::Multiply(new(a), new(b)),
            Self::MultiplyAdd(a, b, c) => Self::MultiplyAdd(new(a), new(b), new(c)),
            Self::Divide(a, b) => Self::Divide(new(a), new(b)),
            Self::SquareRoot(a) => Self::SquareRoot(new(a)),
        }
    }
}
