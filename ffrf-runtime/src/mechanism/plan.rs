//! Where everything of a mechanism stands in its system of equations, decided when it is composed.

use super::Elimination;

/// The frame of one body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BodyPlace {
    /// First of its six unknowns.
    pub unknowns: usize,
    /// Its diagonal block among the values.
    pub diagonal: usize,
}

/// One end of a joint on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EndPlace {
    /// The body.
    pub body: usize,
    /// First row of this joint among those attached to the body.
    pub slot: usize,
    /// The block of joint and body among the values.
    pub block: Block,
}

/// A block off the diagonal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block {
    /// Where it begins among the values.
    pub start: usize,
    /// Number of its columns: the unknowns of the node that is eliminated first.
    pub columns: usize,
    /// Whether the joint (the first joint, of two) is the node of the columns.
    pub transposed: bool,
}

impl Block {
    /// Where the entry of row `row` of the joint and unknown `column` of the other node stands.
    pub fn entry(&self, row: usize, column: usize) -> usize {
        let (row, column) = if self.transposed { (column, row) } else { (row, column) };
        self.start + self.columns * row + column
    }
}

/// A joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlace {
    /// Number of rows.
    pub rows: usize,
    /// First of its multipliers among the unknowns.
    pub unknowns: usize,
    /// Its diagonal block among the values.
    pub diagonal: usize,
    /// Its first and second end; `None` on the ground.
    pub ends: [Option<EndPlace>; 2],
}

/// Two joints on one flexible body, which couples them through its modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedPlace {
    /// The body.
    pub body: usize,
    /// First attached row and number of rows of the first joint.
    pub first: (usize, usize),
    /// The same of the second joint.
    pub second: (usize, usize),
    /// The block of both joints among the values.
    pub block: Block,
}

/// The places of a mechanism.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Plan<'a> {
    /// The order of elimination.
    pub elimination: Elimination<'a>,
    /// The bodies.
    pub bodies: &'a [BodyPlace],
    /// The joints.
    pub joints: &'a [JointPlace],
    /// Pairs of joints on one flexible body.
    pub shared: &'a [SharedPlace],
}
