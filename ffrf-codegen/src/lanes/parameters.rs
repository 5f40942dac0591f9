//! Loops over lanes for bodies whose invariants come at run time: which of them the loops read.

use super::strategy::in_lanes;
use crate::fidelity::{EnergyTerm, Fidelity};
use crate::invariants::{Invariant, Structure};
use crate::layout::Layout;
use crate::{CodegenError, GenerateOptions};

/// A body in lanes whose invariants are fields.
#[derive(Debug, Clone)]
pub(crate) struct LaneParameters {
    /// Number of modes M.
    pub(crate) modes: usize,
    /// What is known about the fields.
    pub(crate) layout: Layout,
    fidelity: Fidelity,
}

/// The body in lanes if that is to be its form, `None` for statements.
///
/// Errors: lanes were demanded where they cannot be had.
pub(super) fn choose(
    modes: usize,
    layout: &Layout,
    options: &GenerateOptions,
) -> Result<Option<LaneParameters>, CodegenError> {
    let is_diagonal = matches!(layout[Invariant::ModalMass], Structure::Identity | Structure::Diagonal);
    let stiffening = [Invariant::UniformLoadStiffness, Invariant::LinearLoadStiffness];
    let obstacle = if !is_diagonal {
        Some("they need a modal mass that the layout declares identity or diagonal")
    } else if stiffening.into_iter().any(|invariant| layout.is_data(invariant)) {
        Some("they do not read geometric stiffness from fields")
    } else {
        None
    };
    let lanes = LaneParameters { modes, layout: *layout, fidelity: options.fidelity.clone() };
    Ok(in_lanes(modes, obstacle, options)?.then_some(lanes))
}

impl LaneParameters {
    /// The strategy in words, for the banner.
    pub(super) fn description(&self) -> String {
        format!("lanes over modes, {} groups of 4; moments read from the fields", self.groups())
    }

    /// Groups of four lanes.
    pub(crate) fn groups(&self) -> usize {
        self.modes.div_ceil(4)
    }

    /// Whether the loops know K_ff and D_ff.
    pub(crate) fn has_internal(&self) -> bool {
        let is_diagonal = |invariant| self.layout[invariant] != Structure::Symmetric;
        is_diagonal(Invariant::Stiffness) && is_diagonal(Invariant::Damping)
    }

    /// Whether the loops read a first moment.
    pub(crate) fn keeps(&self, invariant: Invariant) -> bool {
        let term = match invariant {
            Invariant::FirstMoment => EnergyTerm::FirstMoment,
            _ => EnergyTerm::ModalMomentum,
        };
        self.fidelity.keeps(term) && self.layout.is_data(invariant)
    }

    /// Whether the trace of T_μν is part of the change of inertia.
    pub(crate) fn has_trace(&self) -> bool {
        self.fidelity.keeps(EnergyTerm::RotationQuadratic)
    }

    /// Whether the loops read even and odd parts of T_μν.
    pub(crate) fn moment_parts(&self) -> (bool, bool) {
        self.parts(
            Invariant::ModeModeMoment,
            EnergyTerm::RotationQuadratic,
            EnergyTerm::ModalRotationDeformed,
        )
    }

    /// Whether the loops read even and odd parts of T_μ.
    pub(crate) fn position_parts(&self) -> (bool, bool) {
        self.parts(Invariant::PositionModeMoment, EnergyTerm::RotationLinear, EnergyTerm::ModalRotation)
    }

    fn parts(&self, invariant: Invariant, even: EnergyTerm, odd: EnergyTerm) -> (bool, bool) {
        let structure = self.layout[invariant];
        let has_even = !matches!(structure, Structure::Zero | Structure::Antisymmetric);
        let has_odd = matches!(structure, Structure::Dense | Structure::Antisymmetric);
        (has_even && self.fidelity.keeps(even), has_odd && self.fidelity.keeps(odd))
    }
}
