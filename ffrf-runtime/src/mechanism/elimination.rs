//! Block L D Lᵀ of the equations of a mechanism, in an order and with a pattern that are known beforehand.
//!
//! The unknowns are grouped in nodes: the six accelerations of each body's frame, the multipliers of each joint. The
//! matrix [Z Yᵀ; Y -E] is quasi-definite, so it has factors in every order in which a joint follows one of its bodies,
//! without pivoting; which order costs least, and keeps pivots regular in trees, is decided when the mechanism is composed
//! (R. J. Vanderbei, Symmetric quasidefinite matrices, SIAM J. Optim. 5 (1995) 100-113;
//! D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996).

use nalgebra::RealField;

use super::node::{Coupling, Node, Step};

/// Calls a method of a node with its number of unknowns as a constant, so that its loops have no bounds to check.
macro_rules! by_size {
    ($node:ident.$method:ident($($argument:expr),*)) => {
        match $node.step.size {
            1 => $node.$method::<1, T>($($argument),*),
            2 => $node.$method::<2, T>($($argument),*),
            3 => $node.$method::<3, T>($($argument),*),
            4 => $node.$method::<4, T>($($argument),*),
            5 => $node.$method::<5, T>($($argument),*),
            LARGEST_NODE => $node.$method::<LARGEST_NODE, T>($($argument),*),
            _ => None,
        }
    };
}

/// The largest node: six accelerations or six rows.
pub const LARGEST_NODE: usize = 6;

/// The order of elimination with all places, made once for a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// The nodes in their order.
    pub steps: &'a [Step],
    /// The couplings of each node, in the order of elimination of the later nodes.
    pub couplings: &'a [Coupling],
    /// Where the blocks of each pair of couplings begin.
    pub targets: &'a [usize],
}

impl<'a> Elimination<'a> {
    fn nodes(&self) -> impl DoubleEndedIterator<Item = Node<'a>> + use<'a> {
        let (steps, couplings, targets) = (self.steps, self.couplings, self.targets);
        (0..steps.len()).filter_map(move |index| {
            let step = steps.get(index)?;
            let end = steps.get(index + 1).map_or(couplings.len(), |next| next.couplings);
            Some(Node {
                step,
                couplings: couplings.get(step.couplings..end)?,
                targets: targets.get(step.targets..)?,
            })
        })
    }

    /// Factors the matrix in place: its lower triangle becomes L, its diagonal D⁻¹.
    ///
    /// Returns the smallest |pivot| over the largest of its block's diagonal before elimination, the digits lost there.
    /// `None` if a pivot is zero or not finite.
    pub fn factor<T: RealField + Copy>(&self, values: &mut [T]) -> Option<T> {
        let mut smallest = T::one();
        for node in self.nodes() {
            smallest = smallest.min(by_size!(node.factor(values))?);
        }
        Some(smallest)
    }

    /// Solves the factored system in place.
    pub fn solve<T: RealField + Copy>(&self, values: &[T], unknowns: &mut [T]) {
        for node in self.nodes() {
            let _ = by_size!(node.solve_forwards(values, unknowns));
        }
        for node in self.nodes().rev() {
            let _ = by_size!(node.solve_backwards(values, unknowns));
        }
    }

    /// Subtracts the product of a matrix that is not factored with `unknowns` from `right`.
    pub fn subtract_product<T: RealField + Copy>(&self, matrix: &[T], unknowns: &[T], right: &mut [T]) {
        for node in self.nodes() {
            let _ = by_size!(node.subtract_product(matrix, unknowns, right));
        }
    }
}
