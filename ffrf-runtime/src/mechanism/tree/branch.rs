//! Where a body stands in a tree, decided when the mechanism is composed.

use nalgebra::RealField;

/// A body of a tree with the joint that holds it. A body comes after its parent.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Branch {
    /// The body.
    pub body: usize,
    /// The joint that holds it; `None` if it is free.
    pub joint: Option<usize>,
    /// Whether it is the second end of that joint.
    pub is_second: bool,
    /// Where the body at the other end stands among the branches; `None` on the ground.
    pub parent: Option<usize>,
    /// Number of the first of its motions among those of all bodies.
    pub freedom: usize,
    /// Number of its motions: six less the rows of its joint.
    pub freedoms: usize,
}

impl Branch {
    /// Which way the rows of its joint count at the body: they are those of the second end less those of the first.
    pub(crate) fn sign<T: RealField>(&self) -> T {
        if self.is_second { T::one() } else { -T::one() }
    }
}

/// The most modes of a body with which a sweep costs less than the equations of all joints.
///
/// Multiply-adds of a body with M modes in a chain with revolute joints: some 250 + 100 M + 12 M² + M³/6 and 1300 + 156 M.
const MOST_MODES: usize = 10;

/// Whether a tree of bodies with so many modes is swept over.
pub const fn sweeps(modes: &[usize]) -> bool {
    let mut rest = modes;
    while let [count, others @ ..] = rest {
        if *count > MOST_MODES {
            return false;
        }
        rest = others;
    }
    true
}
