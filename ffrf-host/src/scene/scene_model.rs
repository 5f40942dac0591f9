//! What a flexible body of a scene was read from.

use ffrf_codegen::Fidelity;
use ffrf_model::ReducedBody;

/// What a flexible body of a scene was read from.
#[derive(Debug, Clone, PartialEq)]
pub struct SceneModel {
    /// The model, with the modes that the scene uses.
    pub model: ReducedBody,
    /// Terms of its kinetic energy.
    pub fidelity: Fidelity,
}
