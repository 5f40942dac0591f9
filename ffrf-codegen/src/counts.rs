//! Operation counts: what a kernel costs.

use crate::expression::Node;
use crate::formulate::Kernel;

/// Number of floating-point operations of one call.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct OperationCounts {
    /// Sums and differences.
    pub additions: usize,
    /// Products.
    pub multiplications: usize,
    /// Products contracted with a sum.
    pub fused: usize,
    /// Quotients.
    pub divisions: usize,
    /// Square roots.
    pub square_roots: usize,
}

impl OperationCounts {
    /// Counts what the results of a kernel need. Changes of sign are free.
    pub fn of(kernel: &Kernel) -> Self {
        let needed = kernel.graph.reachable(&kernel.outputs);
        let mut counts = Self::default();
        for (handle, node) in kernel.graph.nodes().take(needed.len()) {
            if needed[handle.index()] {
                counts.add(node);
            }
        }
        counts
    }

    /// Counts one node.
    pub fn add(&mut self, node: Node) {
        match node {
            Node::Constant(_) | Node::Symbol(_) | Node::Negate(_) => {}
            Node::Add(..) | Node::Subtract(..) => self.additions += 1,
            Node::Multiply(..) => self.multiplications += 1,
            Node::MultiplyAdd(..) => self.fused += 1,
            Node::Divide(..) => self.divisions += 1,
            Node::SquareRoot(..) => self.square_roots += 1,
        }
    }

    /// All operations, a contracted product and sum counting once.
    pub fn total(&self) -> usize {
        self.additions + self.multiplications + self.fused + self.divisions + self.square_roots
    }
}

impl core::fmt::Display for OperationCounts {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        write!(f, "{} operations", self.total())?;
        let mut separator = ": ";
        for (count, name) in [
            (self.fused, "multiply-add"),
            (self.multiplications, "multiply"),
            (self.additions, "add"),
            (self.divisions, "divide"),
            (self.square_roots, "square root"),
        ] {
            if count > 0 {
                write!(f, "{separator}{count} {name}")?;
                separator = ", ";
            }
        }
        Ok(())
    }
}
