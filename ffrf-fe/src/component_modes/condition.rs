//! How the part is held while its normal modes are computed.

use faer::{Mat, MatRef};

use crate::modes::Operator;

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
        self.flexibility().coordinates
    }

    fn flexibility(&self) -> &Flexibility<'_> {
        match self {
            Self::Free(flexibility) => flexibility,
            Self::Clamped(constrained) => constrained.flexibility,
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

/// The flexibility under the condition: it keeps every vector admissible.
impl Operator for Condition<'_> {
    fn size(&self) -> usize {
        self.coordinates().dimension()
    }

    fn pairs(&self) -> usize {
        self.dimension()
    }

    fn shift(&self) -> f64 {
        0.0
    }

    fn threads(&self) -> usize {
        self.flexibility().threads
    }

    fn mass_times(&self, block: MatRef<'_, f64>) -> Mat<f64> {
        self.coordinates().mass_times(block)
    }

    fn apply(&self, mass_block: MatRef<'_, f64>) -> Mat<f64> {
        self.flexibility_times(mass_block.to_owned())
    }

    fn remove_rigid(&self, block: &mut Mat<f64>) {
        if let Self::Free(flexibility) = self {
            flexibility.rigid.remove_from(block);
        }
    }
}
