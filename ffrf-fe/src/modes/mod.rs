//! Mode bases: eigenmodes of K φ = ω² M φ, or shapes that the user supplies.
//!
//! The way through this module: a [`ModeRequest`] on an [`FeModel`](crate::FeModel) becomes a
//! `Problem` on the degrees of freedom that may move; `rigid` finds the motions without strain;
//! `dense` or `lanczos` finds the lowest elastic pairs, the latter in a `subspace` that the `operator` makes grow;
//! `polish` makes them orthonormal to round-off; `canonical` fixes order, signs and the basis
//! within repeated eigenvalues; `inertia_count` proves that none was missed; `account` and `report` say it all.
//!
//! Memory of the sparse solver for n free degrees of freedom and m modes, beside K and M: the factor, and
//! m + min(m, 128) + 56 vectors of n numbers, of which those that the search needs are touched.

mod account;
mod basis;
mod block;
mod canonical;
mod dense;
mod factor;
mod inertia_count;
mod lanczos;
mod operator;
mod ordering;
mod orthonormal;
mod participation;
mod polish;
mod problem;
mod products;
mod random;
mod report;
mod request;
mod rigid;
mod scale;
mod solve;
mod subspace;
mod symmetric_eigen;
mod user;

pub use crate::error::ModeError;
pub use basis::ModeBasis;
pub use report::{ModeEntry, ModeReport, RigidModeEntry};
pub use request::{Method, ModeRequest, ModeSolution, Progress, Stage, Support};
pub use solve::compute_modes;
pub use user::user_modes;

pub(crate) use block::{gram, product, subtract_product, symmetrised};
pub(crate) use canonical::settle_signs;
pub(crate) use dense::{cholesky, generalised_eigen};
pub(crate) use factor::{Analysis, Factor};
pub(crate) use lanczos::{lowest as lowest_pairs, subspace_size};
pub(crate) use operator::Operator;
pub(crate) use ordering::{analyse, order as node_order, permutation};
pub(crate) use problem::{entries, mass_times_full};
pub(crate) use symmetric_eigen::symmetric_eigen;
pub(crate) use user::times as stiffness_times;
