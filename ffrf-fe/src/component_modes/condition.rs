//! How the part is held while its normal modes are computed.

use faer::Mat;

use super::constrained::Constrained;
use super::coordinates::Coordinates;
use super::flexibility::Flexibility;

/// How the part is held while its normal modes are computed.
#[derive(Clone, Copy)]
pub(crate) enum Condition<'a> {
    /// Not at all: elastic modes of the unsupported part, orthogonal to rigid motion.
    Free(&'a Flexibility<'a>),
    /// The reference points of all interfaces at rest.
    Clamped(&'a Constrained<'a>),
}

impl Condition<'_> {
    pub fn coordinates(&self) -> &Coordinates<'_> {
        match self {
            Self::Free(flexibility) => flexibility.coordinates,
            Self::Clamped(constrained) => constrained.flexibility.coordinates,
        }
    }

    /// Displacements of forces under the condition.
    pub fn flexibility_times(&self, forces: Mat<f64>) -> Mat<f64> {
        match self {
            Self::Free(flexibility) => flexibility.elastic(forces),
            Self::Clamped(constrained) => constrained.clamped(forces.as_ref()),
        }
    }

    /// Linear conditions C y = 0 on admissible shapes, as columns Cᵀ.
    pub fn constraint_columns(&self) -> Mat<f64> {
        match self {
            Self::Free(flexibility) => flexibility.rigid.mass_shapes.clone(),
            Self::Clamped(constrained) => constrained.motion.forces(constrained.flexibility.coordinates),
        }
    }

    /// Number of independent admissible shapes.
    pub fn dimension(&self) -> usize {
        let conditions = match self {
            Self::Free(flexibility) => flexibility.rigid.count(),
            Self::Clamped(constrained) => constrained.motion.count(),
        };
        self.coordinates().dimension().saturating_sub(conditions)
    }
}
