//! What can go wrong, one file for each step; [`FeError`] is any of it.
//!
//! The steps import their errors from here, and [`FeError`], which holds them all: beside the steps, so that none of them
//! imports another for it.

mod component_modes;
mod geometric_stiffness;
mod modes;
mod reduction;
mod section;
mod stress;

pub use crate::elements::ElementError;
pub use component_modes::ComponentModeError;
pub use geometric_stiffness::GeometricStiffnessError;
pub use modes::ModeError;
pub use reduction::ReductionError;
pub use section::SectionError;
pub use stress::StressError;

/// What can go wrong between a finite-element export and a reduced body.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FeError {
    /// The files cannot be read, or do not make a model.
    #[error(transparent)]
    Import(#[from] crate::import::ImportError),
    /// The modes cannot be computed.
    #[error(transparent)]
    Modes(#[from] ModeError),
    /// The component modes cannot be computed.
    #[error(transparent)]
    ComponentModes(#[from] ComponentModeError),
    /// The body cannot be reduced.
    #[error(transparent)]
    Reduction(#[from] ReductionError),
    /// The reduced body contradicts itself.
    #[error(transparent)]
    Model(#[from] ffrf_model::ModelError),
    /// The body of mode shapes that the user supplied contradicts itself, such as modes that repeat each other.
    #[error("{}: {fault}", ffrf_model::printable(file))]
    UserModes {
        /// Name of the file with the mode shapes.
        file: String,
        /// What is wrong.
        fault: Box<ffrf_model::ModelError>,
    },
    /// The geometric stiffness cannot be computed.
    #[error(transparent)]
    GeometricStiffness(#[from] GeometricStiffnessError),
    /// Stresses cannot be recovered.
    #[error(transparent)]
    Stress(#[from] StressError),
    /// A cut cannot be made.
    #[error(transparent)]
    Section(#[from] SectionError),
    /// An element is not usable.
    #[error(transparent)]
    Element(#[from] ElementError),
}
