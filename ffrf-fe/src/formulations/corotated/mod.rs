//! Bodies in absolute coordinates with a co-rotated linear stiffness: the whole mesh (ACF, Sections 2-3) and its
//! generalised component modes (GCMS, Sections 4-5).
//!
//! Both have the same equations, because A_bd commutes with Φ: coordinates come in triples, the mass matrix is
//! constant, M_s ⊗ I3, and the elastic energy is ½ sᵀ K s with s = A_bdᵀ r - x. So one [`CorotatedModel`] serves
//! both, and [`Midpoint`] integrates both.
//!
//! One pendulum in three formulations, with figures: `docs/theory/equivalence.md` of the repository.

mod elastic;
mod frame;
mod joint;
mod midpoint;
mod model;
mod orthonormal;

pub use elastic::ElasticState;
pub use frame::{Frame, FramePosition};
pub use joint::GroundJoint;
pub use midpoint::{Midpoint, Motion, StepReport};
pub use model::CorotatedModel;
pub use orthonormal::Recombination;
