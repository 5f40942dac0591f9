//! Block L D Lᵀ of the equations of a mechanism, in an order and with a pattern that are known beforehand.
//!
//! The unknowns are grouped in nodes: the six accelerations of each body's frame, the multipliers of each joint. The
//! matrix [Z Yᵀ; Y -E] is quasi-definite, so it has factors in every order in which a joint follows one of its bodies,
//! without pivoting; which order costs least, and keeps pivots regular in trees, is decided when the mechanism is composed
//! (R. J. Vanderbei, Symmetric quasidefinite matrices, SIAM J. Optim. 5 (1995) 100-113;
//! D. Baraff, Linear-time dynamics using Lagrange multipliers, SIGGRAPH 1996).

use core::ops::Range;

use nalgebra::RealField;

use super::node::{Coupling, LARGEST_NODE, Node, Step};
use crate::six::Square;

/// Calls a method of a node with its number of unknowns as a constant, so that it is straight-line code.
macro_rules! by_size {
    ($node:ident.$method:ident($($argument:expr),*)) => {
        match $node.step.size {
            1 => $node.$method::<1, T>($($argument),*),
            2 => $node.$method::<2, T>($($argument),*),
            3 => $node.$method::<3, T>($($argument),*),
            4 => $node.$method::<4, T>($($argument),*),
            5 => $node.$method::<5, T>($($argument),*),
            _ => $node.$method::<LARGEST_NODE, T>($($argument),*),
        }
    };
}

/// The order of elimination with all places, made once for a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Elimination<'a> {
    /// The nodes in their order.
    pub steps: &'a [Step],
    /// Number of bodies that come before any joint: corrections of multipliers do not begin before them.
    pub leading: usize,
    /// The couplings of each node, in the order of elimination of the later nodes.
    pub couplings: &'a [Coupling],
    /// Where the blocks of each pair of couplings begin.
    pub targets: &'a [usize],
    /// Whether rows are those of one instant: those of joints that hold a point are then as [`Coupling::holds_point`] says.
    /// In a step of the energy-momentum method they are means, and full.
    pub of_instant: bool,
}

impl<'a> Elimination<'a> {
    fn nodes(&self, range: Range<usize>) -> impl DoubleEndedIterator<Item = Node<'a>> + use<'a> {
        let Self { steps, couplings, targets, of_instant, .. } = *self;
        range.filter_map(move |index| {
            let step = steps.get(index)?;
            let end = steps.get(index + 1).map_or(couplings.len(), |next| next.couplings);
            Some(Node {
                step,
                couplings: couplings.get(step.couplings..end)?,
                targets: targets.get(step.targets..)?,
                of_instant,
            })
        })
    }

    /// The nodes from the `start`-th to the last.
    pub(super) fn nodes_from(&self, start: usize) -> impl Iterator<Item = usize> + use<'a> {
        self.steps.iter().skip(start).map(|step| step.node)
    }

    /// Factors the matrix in place. `None` if a pivot is zero or not finite.
    pub(super) fn factor<T: RealField + Copy>(&self, blocks: &mut [Option<Square<T>>]) -> Option<()> {
        for node in self.nodes(0..self.steps.len()) {
            by_size!(node.factor(blocks))?;
        }
        Some(())
    }

    /// The first half of a solve in place, over the nodes from `start` on.
    pub(super) fn solve_forwards<T: RealField + Copy>(
        &self,
        start: usize,
        blocks: &[Option<Square<T>>],
        unknowns: &mut [[T; 6]],
    ) {
        for node in self.nodes(start..self.steps.len()) {
            let _ = by_size!(node.solve_forwards(blocks, unknowns));
        }
    }

    /// The second half of a solve in place, over the nodes of `range` from the last to the first.
    pub(super) fn solve_backwards<T: RealField + Copy>(
        &self,
        range: Range<usize>,
        blocks: &[Option<Square<T>>],
        unknowns: &mut [[T; 6]],
    ) {
        for node in self.nodes(range).rev() {
            let _ = by_size!(node.solve_backwards(blocks, unknowns));
        }
    }
}
