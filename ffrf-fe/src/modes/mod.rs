//! Mode bases: eigenmodes of K φ = ω² M φ, or shapes that the user supplies.
//!
//! The way through this module: a [`ModeRequest`] on an [`FeModel`](crate::FeModel) becomes a
//! `Problem` on the degrees of freedom that may move; `rigid` finds the motions without strain;
//! `dense` or `lanczos` finds the lowest elastic pairs; `canonical` fixes order, signs and the basis
//! within repeated eigenvalues; `inertia_count` proves that none was missed; `report` says it all.

mod basis;
mod block;
mod canonical;
mod dense;
mod error;
mod factor;
mod inertia_count;
mod lanczos;
mod ordering;
mod participation;
mod problem;
mod random;
mod report;
mod request;
mod rigid;
mod scale;
mod solve;
mod user;

pub use basis::ModeBasis;
pub use error::ModeError;
pub use report::{ModeEntry, ModeReport, RigidModeEntry};
pub use request::{Method, ModeRequest, ModeSolution, Progress, Stage, Support};
pub use solve::compute_modes;
pub use user::user_modes;

pub(crate) use block::{gram, product, subtract_product, symmetric_eigen, symmetrised};
pub(crate) use canonical::settle_signs;
pub(crate) use dense::{cholesky, generalised_eigen};
pub(crate) use factor::{Analysis, Factor};
pub(crate) use ordering::{analyse, order as node_order, permutation};
pub(crate) use problem::{entries, mass_times_full};
pub(crate) use random::Random;
pub(crate) use user::times as stiffness_times;
