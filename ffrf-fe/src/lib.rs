//! Finite-element import, modes and reduction to a flexible body.
//!
//! The way through this crate: files --[`import`]--> [`FeModel`] --[`modes`]--> [`ModeBasis`]
//! --[`reduction`]--> [`ffrf_model::ReducedBody`]. Bodies that joints load at interfaces take their basis from
//! [`component_modes`] in place of [`modes`].
#![forbid(unsafe_code)]

mod compensated;
pub mod component_modes;
mod elasticity;
pub mod elements;
mod error;
pub mod export;
mod fe_model;
pub mod formulations;
pub mod geometric_stiffness;
pub mod import;
pub mod modes;
pub mod oracle;
mod part_elasticity;
pub mod reduction;
pub mod section;
mod sparse;
pub mod stress;
mod tolerances;
pub mod units;

pub use elasticity::Elasticity;
pub use error::FeError;
pub use fe_model::{Element, ElementKind, FeModel, Nodes, SolidMaterial};
pub use modes::ModeBasis;
pub use part_elasticity::PartElasticity;
pub use sparse::SparseMatrix;
