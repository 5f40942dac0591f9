//! Mechanisms whose joints close no loop: one sweep over the bodies instead of a system of equations.
//!
//! Each body is held by one joint to the one before it, its parent, or is free. With t the acceleration of the end of that
//! joint on the body (inertial axes, without bias), the joint's r rows leave
//!
//! ```text
//! t = X t_parent + δ + Σ s_k y_k,      k = 1 .. 6 - r
//! ```
//!
//! where X carries the parent's end to the same point, δ takes the right-hand side of the rows and the s_k span the motions
//! that they leave. From the leaves to the roots a body with all that hangs on it is A t - h = w, with w from its joint, and the
//! motions go one by one: s_kᵀ w = 0 takes A s_k s_kᵀ A / (s_kᵀ A s_k) out of A. What is left resists the parent's motion. So a
//! joint costs as many pivots as it leaves motions, and six by six is the largest matrix; the multipliers follow from w.
//!
//! A body's modes are eliminated with it, before the motions of its joint: see [`Woven`]. That costs the square of their number,
//! where the equations of all joints cost it in proportion: [`sweeps`] says which of both.
//!
//! Source: Featherstone, Rigid body dynamics algorithms (2008), chapter 7, with the rows of any joint in place of coordinates:
//! the same sweep takes residuals of accelerations, velocities or positions away.

mod branch;
mod freedom;
mod held;
mod limb;
mod woven;

pub use branch::{Branch, sweeps};
pub use freedom::Freedom;
pub(super) use held::hold;
pub use limb::{Limb, LimbEnd};
pub(super) use limb::{Parent, Seat};
pub(crate) use woven::Woven;
