//! Where everything of a mechanism stands in its system of equations, decided when it is composed.

use super::{Branch, Elimination};

/// The frame of one body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct BodyPlace {
    /// Its node: where its six unknowns stand.
    pub node: usize,
    /// Its diagonal block.
    pub diagonal: usize,
}

/// One end of a joint on a body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct EndPlace {
    /// The body.
    pub body: usize,
    /// Which of the ends of joints on the body this is.
    pub slot: usize,
    /// The block of joint and body.
    pub block: Block,
}

/// A block off the diagonal.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Block {
    /// Which block it is.
    pub index: usize,
    /// Whether the joint (the first joint, of two) is the node of the rows: the one that is eliminated first.
    pub transposed: bool,
}

/// A joint.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct JointPlace {
    /// Number of rows.
    pub rows: usize,
    /// Its node: where its multipliers stand.
    pub node: usize,
    /// Its diagonal block.
    pub diagonal: usize,
    /// Whether it is a support: it holds a rigid body on the ground, whose unknowns can be the at most three motions that it leaves.
    pub is_support: bool,
    /// Its first and second end; `None` on the ground.
    pub ends: [Option<EndPlace>; 2],
}

/// Two joints on one flexible body, which couples them through its modes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct SharedPlace {
    /// The body.
    pub body: usize,
    /// The slot of the first joint.
    pub first: usize,
    /// The slot of the second joint.
    pub second: usize,
    /// The block of both joints.
    pub block: Block,
}

/// Some of the modes of a body as a node: unknowns of their own.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModesPlace {
    /// The body.
    pub body: usize,
    /// The first of the modes.
    pub first: usize,
    /// Its node.
    pub node: usize,
    /// Its diagonal block.
    pub diagonal: usize,
    /// The block of modes and frame; `transposed` if the frame is the node of the rows.
    pub frame: Block,
}

/// Some of the modes of a body and one end of a joint on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModalEndPlace {
    /// The body.
    pub body: usize,
    /// Which of the ends of joints on the body this is.
    pub slot: usize,
    /// The first of the modes.
    pub first: usize,
    /// The block of modes and joint; `transposed` if the joint is the node of the rows.
    pub block: Block,
}

/// Two nodes of modes of one body.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct ModalPairPlace {
    /// The body.
    pub body: usize,
    /// The first mode of the rows.
    pub rows: usize,
    /// The first mode of the columns.
    pub columns: usize,
    /// Their block.
    pub block: usize,
}

/// Which equations an evaluation solves, and has room for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Equations {
    /// Those of all bodies and joints.
    Rows,
    /// Those of all bodies, joints and soft links.
    SoftRows,
    /// Those of each branch of a tree.
    Tree,
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
    /// Pairs of joints on one flexible body whose modes are eliminated in it.
    pub shared: &'a [SharedPlace],
    /// The modes of bodies that keep them as unknowns.
    pub modes: &'a [ModesPlace],
    /// These modes at the ends of joints.
    pub modal_ends: &'a [ModalEndPlace],
    /// These modes among each other, where a body has more of them than a node.
    pub modal_pairs: &'a [ModalPairPlace],
    /// The bodies from the roots to the leaves if joints close no loop and are swept over; else empty.
    pub branches: &'a [Branch],
}

impl Plan<'_> {
    /// Which equations are solved where rows are those of one instant.
    #[inline(always)]
    pub(super) fn equations(&self) -> Equations {
        if self.branches.is_empty() { Equations::Rows } else { Equations::Tree }
    }
}
