//! The tolerances of the motion tests, with their reasons.

/// Central differences with a step of 1e-6 of the body: round-off 1e-16 / 1e-6 against curvature 1e-12.
pub const DIFFERENCE: f64 = 1e-7;

/// A conserved quantity of an implicit rule solved to 1e-11 of the body, over some hundred steps.
pub const CONSERVED: f64 = 1e-8;

/// One motion in two bases of one space: the round-off of a stiffness seen through modes, over some hundred steps.
pub const SAME_SPAN: f64 = 1e-7;
