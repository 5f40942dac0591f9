//! The error type of this crate.

/// What can go wrong between a finite-element export and a reduced body.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum FeError {
    /// The files cannot be read, or do not make a model.
    #[error(transparent)]
    Import(#[from] crate::import::ImportError),
    /// The modes cannot be computed.
    #[error(transparent)]
    Modes(#[from] crate::modes::ModeError),
    /// The component modes cannot be computed.
    #[error(transparent)]
    ComponentModes(#[from] crate::component_modes::ComponentModeError),
    /// The body cannot be reduced.
    #[error(transparent)]
    Reduction(#[from] crate::reduction::ReductionError),
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
    /// An element is not usable.
    #[error(transparent)]
    Element(#[from] crate::elements::ElementError),
}
