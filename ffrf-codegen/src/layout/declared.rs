//! A layout: one structure per invariant.

use super::Structure;
use crate::CodegenError;
use crate::fidelity::{EnergyTerm, Fidelity};

/// The structure of each invariant.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Layout {
    /// First moment m a: zero (frame at the centre of mass) or dense.
    pub first_moment: Structure,
    /// Modal first moments m b_μ: zero (free-free modes) or dense.
    pub modal_first_moment: Structure,
    /// Second moment T: diagonal (principal axes) or symmetric.
    pub second_moment: Structure,
    /// Position-mode moments T_μ: symmetric means Ξ = `[ϑ_μ]` = 0 (free-free modes).
    pub position_mode_moment: Structure,
    /// Mode-mode moments T_μν: symmetric means ϑ_μν = 0.
    pub mode_mode_moment: Structure,
    /// Modal mass Θ_ff: identity (mass-normalised modes), diagonal or symmetric.
    pub modal_mass: Structure,
    /// Modal stiffness K_ff: zero, diagonal (eigenmodes) or symmetric.
    pub stiffness: Structure,
    /// Modal damping D_ff: zero, diagonal or symmetric.
    pub damping: Structure,
}

use Structure::{Antisymmetric, Dense, Diagonal, Identity, Symmetric, Zero};

impl Layout {
    /// Nothing is known: every invariant as general as it can be.
    pub const GENERAL: Self = Self {
        first_moment: Dense,
        modal_first_moment: Dense,
        second_moment: Symmetric,
        position_mode_moment: Dense,
        mode_mode_moment: Dense,
        modal_mass: Symmetric,
        stiffness: Symmetric,
        damping: Symmetric,
    };

    /// Mass-normalised free-free eigenmodes in a frame at the centre of mass along the principal axes.
    pub const FREE_FREE: Self = Self {
        first_moment: Zero,
        modal_first_moment: Zero,
        second_moment: Diagonal,
        position_mode_moment: Symmetric,
        mode_mode_moment: Dense,
        modal_mass: Identity,
        stiffness: Diagonal,
        damping: Diagonal,
    };

    /// Name, structure and admissible structures of each invariant, in the order of the fields.
    pub fn entries(&self) -> [(&'static str, Structure, &'static [Structure]); 8] {
        const VECTOR: &[Structure] = &[Zero, Dense];
        const TENSOR: &[Structure] = &[Diagonal, Symmetric];
        const MATRICES: &[Structure] = &[Zero, Diagonal, Symmetric, Antisymmetric, Dense];
        const MASS: &[Structure] = &[Identity, Diagonal, Symmetric];
        const MODAL: &[Structure] = &[Zero, Identity, Diagonal, Symmetric];
        [
            ("first_moment", self.first_moment, VECTOR),
            ("modal_first_moment", self.modal_first_moment, VECTOR),
            ("second_moment", self.second_moment, TENSOR),
            ("position_mode_moment", self.position_mode_moment, MATRICES),
            ("mode_mode_moment", self.mode_mode_moment, MATRICES),
            ("modal_mass", self.modal_mass, MASS),
            ("stiffness", self.stiffness, MODAL),
            ("damping", self.damping, MODAL),
        ]
    }

    /// Sets the structure of the invariant called `name`; `dense` on a symmetric invariant means symmetric.
    ///
    /// Returns whether there is such an invariant.
    pub fn set(&mut self, name: &str, structure: Structure) -> bool {
        let symmetric = if structure == Dense { Symmetric } else { structure };
        match name {
            "first_moment" => self.first_moment = structure,
            "modal_first_moment" => self.modal_first_moment = structure,
            "second_moment" => self.second_moment = symmetric,
            "position_mode_moment" => self.position_mode_moment = structure,
            "mode_mode_moment" => self.mode_mode_moment = structure,
            "modal_mass" => self.modal_mass = symmetric,
            "stiffness" => self.stiffness = symmetric,
            "damping" => self.damping = symmetric,
            _ => return false,
        }
        true
    }

    /// Whether Θ_ff is data of its own: T_μν is declared so that its trace cannot supply it.
    ///
    /// Such layouts are for fidelities that take nothing else from the even part of T_μν, see
    /// [`check_body`](Self::check_body).
    pub fn has_own_modal_mass(&self) -> bool {
        self.modal_mass != Identity && matches!(self.mode_mode_moment, Zero | Antisymmetric)
    }

    /// Checks that each invariant has a structure that it can have.
    ///
    /// Errors: [`CodegenError::Structure`], the first in the order of the fields.
    pub fn check(&self) -> Result<(), CodegenError> {
        for (invariant, structure, admissible) in self.entries() {
            if !admissible.contains(&structure) {
                let expected: Vec<_> = admissible.iter().map(|known| known.name()).collect();
                return Err(CodegenError::Structure {
                    invariant,
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
        let without_trace = matches!(self.mode_mode_moment, Zero | Antisymmetric);
        if mode_count > 0 && without_trace && fidelity.keeps(EnergyTerm::RotationQuadratic) {
            return Err(CodegenError::Contradiction {
                invariant: "mode_mode_moment",
                found: self.mode_mode_moment.name(),
                reason: "its trace is the modal mass Θ_ff = [tr T_μν], which is positive; declare it diagonal, \
                         symmetric or dense, or choose a fidelity without `rotation_quadratic` (linear, constant, rigid)",
            });
        }
        Ok(())
    }
}

impl core::fmt::Display for Layout {
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        let mut separator = "";
        for (invariant, structure, _) in self.entries() {
            write!(f, "{separator}{invariant}: {structure}")?;
            separator = ", ";
        }
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_invariant_can_be_set_by_its_name() {
        let mut layout = Layout::GENERAL;
        for (name, _, admissible) in Layout::FREE_FREE.entries() {
            assert!(layout.set(name, admissible[0]), "{name}");
        }
        assert!(!layout.set("colour", Zero));
        assert!(layout.check().is_ok());
        assert_eq!(layout.first_moment, Zero);
        assert_eq!(layout.modal_mass, Identity);
    }

    #[test]
    fn a_structure_that_an_invariant_cannot_have_is_refused() {
        let mut layout = Layout::GENERAL;
        layout.modal_mass = Zero;
        let error = layout.check().unwrap_err().to_string();
        assert_eq!(error, "modal_mass cannot be zero, expected one of: identity, diagonal, symmetric");
        assert!(Layout::GENERAL.check().is_ok() && Layout::FREE_FREE.check().is_ok());
    }

    #[test]
    fn a_tensor_without_trace_contradicts_a_positive_modal_mass() {
        for mode_mode_moment in [Zero, Antisymmetric] {
            for modal_mass in [Identity, Diagonal, Symmetric] {
                let layout = Layout { mode_mode_moment, modal_mass, ..Layout::GENERAL };
                let error = layout.check_body(2, &Fidelity::Full).unwrap_err().to_string();
                let named = format!(
                    "mode_mode_moment cannot be {mode_mode_moment} here: its trace is the modal mass"
                );
                assert!(error.starts_with(&named), "{error}");
                // No mode, no trace; and a fidelity that takes only the trace and the odd part has them both.
                assert!(layout.check_body(0, &Fidelity::Full).is_ok());
                assert!(layout.check_body(2, &Fidelity::Linear).is_ok());
                let whirl = Fidelity::from_term_names(["modal_rotation_deformed"]).unwrap();
                assert!(layout.check_body(2, &whirl).is_ok());
                let stretch = Fidelity::from_term_names(["rotation_quadratic"]).unwrap();
                assert!(layout.check_body(2, &stretch).is_err());
            }
        }
        for layout in [Layout::GENERAL, Layout::FREE_FREE] {
            assert!(layout.check_body(3, &Fidelity::Full).is_ok());
        }
    }
}
