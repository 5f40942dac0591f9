//! A layout: one structure per invariant.

use std::ops::{Index, IndexMut};

use crate::CodegenError;
use crate::fidelity::{EnergyTerm, Fidelity};
use crate::invariants::{Invariant, Structure};

/// The structure of each invariant: `layout[Invariant::Stiffness]`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    structures: [Structure; Invariant::ALL.len()],
}

impl Layout {
    /// Nothing is known: every invariant as general as it can be, but no geometric stiffness, which has to be declared.
    pub const GENERAL: Self = {
        let mut structures = [Structure::Dense; Invariant::ALL.len()];
        let mut k = 0;
        while k < structures.len() {
            structures[k] = Invariant::ALL[k].description().unnamed();
            k += 1;
        }
        Self { structures }
    };

    /// Mass-normalised free-free eigenmodes in a frame at the centre of mass along the principal axes.
    pub const FREE_FREE: Self = {
        let mut structures = [Structure::Dense; Invariant::ALL.len()];
        let mut k = 0;
        while k < structures.len() {
            structures[k] = Invariant::ALL[k].description().free_free;
            k += 1;
        }
        Self { structures }
    };

    /// The layout with geometric stiffness of all inertial loads.
    #[must_use]
    pub fn stiffened(self) -> Self {
        self.with(Invariant::UniformLoadStiffness, Structure::Dense)
            .with(Invariant::LinearLoadStiffness, Structure::Dense)
    }

    /// The layout with another structure of one invariant.
    #[must_use]
    pub fn with(mut self, invariant: Invariant, structure: Structure) -> Self {
        self[invariant] = structure;
        self
    }

    /// The invariants whose structure is a choice, with it.
    pub fn entries(&self) -> impl Iterator<Item = (Invariant, Structure)> + use<> {
        let layout = *self;
        let chosen = Invariant::ALL.into_iter().filter(|known| known.description().admitted.len() > 1);
        chosen.map(move |invariant| (invariant, layout[invariant]))
    }

    /// Whether Θ_ff is data of its own: T_μν is declared so that its trace cannot supply it.
    ///
    /// Such layouts are for fidelities that take nothing else from the even part of T_μν, see
    /// [`check_body`](Self::check_body).
    pub fn has_own_modal_mass(&self) -> bool {
        self[Invariant::ModalMass] != Structure::Identity && self.lacks_trace()
    }

    /// Whether an invariant is data where invariants come at run time: neither fixed by the layout nor given by another.
    pub fn is_data(&self, invariant: Invariant) -> bool {
        match (invariant, self[invariant]) {
            (_, Structure::Zero | Structure::Identity) => false,
            (Invariant::ModalMass, _) => self.has_own_modal_mass(),
            _ => true,
        }
    }

    fn lacks_trace(&self) -> bool {
        matches!(self[Invariant::ModeModeMoment], Structure::Zero | Structure::Antisymmetric)
    }

    /// Checks that each invariant has a structure that it can have.
    ///
    /// Errors: [`CodegenError::Structure`], the first in the order of the table.
    pub fn check(&self) -> Result<(), CodegenError> {
        for invariant in Invariant::ALL {
            let (structure, admitted) = (self[invariant], invariant.description().admitted);
            if !admitted.contains(&structure) {
                let expected: Vec<_> = admitted.iter().map(|known| known.name()).collect();
                return Err(CodegenError::Structure {
                    invariant: invariant.name(),
                    found: structure.name(),
                    expected: expected.join(", "),
                });
            }
        }
        Ok(())
    }

    /// Checks each structure, and that the layout does not contradict itself in a body of `mode_count` modes.
    ///
    /// Θ_ff = [tr T_μν] is positive definite, so T_μν is neither zero nor antisymmetric where there are modes: the
    /// kernels would complete its trace by an arbitrary entry. It may be declared so where the fidelity drops
    /// `rotation_quadratic`, the one term that takes more from the even part of T_μν than the trace: zero then says
    /// that no T_μν is supplied, antisymmetric that its odd part is, and Θ_ff is data of its own.
    ///
    /// Errors: [`CodegenError::Structure`], [`CodegenError::Contradiction`].
    pub fn check_body(&self, mode_count: usize, fidelity: &Fidelity) -> Result<(), CodegenError> {
        self.check()?;
        if mode_count > 0 && self.lacks_trace() && fidelity.keeps(EnergyTerm::RotationQuadratic) {
            return Err(CodegenError::Contradiction {
                invariant: Invariant::ModeModeMoment.name(),
                found: self[Invariant::ModeModeMoment].name(),
                reason: "its trace is the modal mass Θ_ff = [tr T_μν], which is positive; declare it diagonal, \
                         symmetric or dense, or choose a fidelity without `rotation_quadratic` (linear, constant, rigid)",
            });
        }
        Ok(())
    }
}

impl Index<Invariant> for Layout {
    type Output = Structure;

    fn index(&self, invariant: Invariant) -> &Structure {
        &self.structures[invariant as usize]
    }
}

impl IndexMut<Invariant> for Layout {
    fn index_mut(&mut self, invariant: Invariant) -> &mut Structure {
        &mut self.structures[invariant as usize]
    }
}

impl core::fmt::Display for Layout {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut separator = "";
        let said = self.entries().filter(|(known, it)| known.description().undeclared != Some(*it));
        for (invariant, structure) in said {
            write!(f, "{separator}{}: {structure}", invariant.name())?;
            separator = ", ";
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::Structure::{Antisymmetric, Diagonal, Identity, Symmetric, Zero};
    use super::*;
    use Invariant::{ModalMass, ModeModeMoment};

    #[test]
    fn the_common_layouts_have_structures_that_their_invariants_can_have() {
        assert!(Layout::GENERAL.check().is_ok() && Layout::FREE_FREE.check().is_ok());
        assert_eq!(Layout::GENERAL.entries().count(), Invariant::ALL.len() - 1);
    }

    #[test]
    fn a_structure_that_an_invariant_cannot_have_is_refused() {
        let error = Layout::GENERAL.with(ModalMass, Zero).check().unwrap_err().to_string();
        assert_eq!(error, "modal_mass cannot be zero, expected one of: identity, diagonal, symmetric");
    }

    #[test]
    fn a_tensor_without_trace_contradicts_a_positive_modal_mass() {
        for moments in [Zero, Antisymmetric] {
            for modal_mass in [Identity, Diagonal, Symmetric] {
                let layout = Layout::GENERAL.with(ModeModeMoment, moments).with(ModalMass, modal_mass);
                let error = layout.check_body(2, &Fidelity::Full).unwrap_err().to_string();
                let named = format!("mode_mode_moment cannot be {moments} here: its trace is the modal mass");
                assert!(error.starts_with(&named), "{error}");
                // No mode, no trace; and a fidelity that takes only the trace and the odd part has them both.
                assert!(layout.check_body(0, &Fidelity::Full).is_ok());
                assert!(layout.check_body(2, &Fidelity::Linear).is_ok());
                let whirl = Fidelity::from_term_names(["modal_rotation_deformed"]).unwrap();
                assert!(layout.check_body(2, &whirl).is_ok());
                let stretch = Fidelity::from_term_names(["rotation_quadratic"]).unwrap();
                assert!(layout.check_body(2, &stretch).is_err());
                assert_eq!(layout.is_data(ModalMass), modal_mass != Identity);
            }
        }
        for layout in [Layout::GENERAL, Layout::FREE_FREE] {
            assert!(layout.check_body(3, &Fidelity::Full).is_ok());
        }
    }
}
