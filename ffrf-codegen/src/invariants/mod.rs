//! The invariants of a body: one table, from which layout keys, symbols, fields at run time, their places and checks
//! follow.

mod description;
mod structure;

pub use description::Description;
pub use structure::Structure;

use Structure::{Antisymmetric, Dense, Diagonal, Identity, Symmetric, Zero};

/// An invariant of a reduced body: a number, a vector, a matrix or a list of them that its model holds.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Invariant {
    /// Mass m.
    Mass,
    /// First moment m a.
    FirstMoment,
    /// Modal first moments m b_μ.
    ModalFirstMoment,
    /// Second moment T.
    SecondMoment,
    /// Position-mode moments T_μ; symmetric means Ξ = `[ϑ_μ]` = 0 (free-free modes).
    PositionModeMoment,
    /// Mode-mode moments T_μν; symmetric means ϑ_μν = 0.
    ModeModeMoment,
    /// Modal mass Θ_ff; identity for mass-normalised modes.
    ModalMass,
    /// Modal stiffness K_ff; diagonal for eigenmodes.
    Stiffness,
    /// Modal damping D_ff.
    Damping,
    /// Geometric stiffness Γ_μν of uniform body forces; zero unless it is declared.
    UniformLoadStiffness,
    /// Geometric stiffness Γ_μν of body forces that are linear in the position; zero unless it is declared.
    LinearLoadStiffness,
}

const VECTOR: &[Structure] = &[Zero, Dense];
const MATRICES: &[Structure] = &[Zero, Diagonal, Symmetric, Antisymmetric, Dense];
const MODAL: &[Structure] = &[Zero, Identity, Diagonal, Symmetric];

/// What there is to say about each invariant, in the order in which layouts and fields are written.
const TABLE: [Description; Invariant::ALL.len()] = [
    Description {
        name: "mass",
        title: "Mass m",
        units: "kg",
        modes: 0,
        axes: 0,
        admitted: &[Dense],
        free_free: Dense,
        undeclared: None,
    },
    Description {
        name: "first_moment",
        title: "First moment m a",
        units: "kg m",
        modes: 0,
        axes: 1,
        admitted: VECTOR,
        free_free: Zero,
        undeclared: None,
    },
    Description {
        name: "modal_first_moment",
        title: "Modal first moments m b_μ",
        units: "",
        modes: 1,
        axes: 1,
        admitted: VECTOR,
        free_free: Zero,
        undeclared: None,
    },
    Description {
        name: "second_moment",
        title: "Second moment (Euler tensor) T",
        units: "kg m²",
        modes: 0,
        axes: 2,
        admitted: &[Diagonal, Symmetric],
        free_free: Diagonal,
        undeclared: None,
    },
    Description {
        name: "position_mode_moment",
        title: "Position-mode moments T_μ",
        units: "",
        modes: 1,
        axes: 2,
        admitted: MATRICES,
        free_free: Symmetric,
        undeclared: None,
    },
    Description {
        name: "mode_mode_moment",
        title: "Mode-mode moments T_μν, read where μ <= ν; T_νμ must be T_μνᵀ",
        units: "",
        modes: 2,
        axes: 2,
        admitted: MATRICES,
        free_free: Dense,
        undeclared: None,
    },
    Description {
        name: "modal_mass",
        title: "Modal mass Θ_ff",
        units: "",
        modes: 2,
        axes: 0,
        admitted: &[Identity, Diagonal, Symmetric],
        free_free: Identity,
        undeclared: None,
    },
    Description {
        name: "stiffness",
        title: "Modal stiffness K_ff",
        units: "",
        modes: 2,
        axes: 0,
        admitted: MODAL,
        free_free: Diagonal,
        undeclared: None,
    },
    Description {
        name: "damping",
        title: "Modal damping D_ff",
        units: "",
        modes: 2,
        axes: 0,
        admitted: MODAL,
        free_free: Diagonal,
        undeclared: None,
    },
    Description {
        name: "uniform_load_stiffness",
        title: "Geometric stiffness Γ_μν^j of the body forces ρ e_j, M x M x 3, read where μ <= ν; Γ_νμ must be Γ_μν",
        units: "",
        modes: 2,
        axes: 1,
        admitted: VECTOR,
        free_free: Zero,
        undeclared: Some(Zero),
    },
    Description {
        name: "linear_load_stiffness",
        title: "Geometric stiffness Γ_μν^{ij} of the body forces ρ xⁱ e_j, read where μ <= ν; Γ_νμ must be Γ_μν",
        units: "",
        modes: 2,
        axes: 2,
        admitted: VECTOR,
        free_free: Zero,
        undeclared: Some(Zero),
    },
];

impl Invariant {
    /// Every invariant, in the order of the table.
    pub const ALL: [Self; 11] = [
        Self::Mass,
        Self::FirstMoment,
        Self::ModalFirstMoment,
        Self::SecondMoment,
        Self::PositionModeMoment,
        Self::ModeModeMoment,
        Self::ModalMass,
        Self::Stiffness,
        Self::Damping,
        Self::UniformLoadStiffness,
        Self::LinearLoadStiffness,
    ];

    /// What the table says.
    pub const fn description(self) -> &'static Description {
        &TABLE[self as usize]
    }

    /// The name by which layouts, fields and symbols know it.
    pub const fn name(self) -> &'static str {
        self.description().name
    }

    /// The invariant of that name.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|invariant| invariant.name() == name)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_table_stands_in_the_order_of_the_list() {
        for (position, invariant) in Invariant::ALL.into_iter().enumerate() {
            assert_eq!(invariant as usize, position);
            assert_eq!(Invariant::from_name(invariant.name()), Some(invariant));
            let description = invariant.description();
            assert!(description.admitted.contains(&description.free_free), "{invariant:?}");
        }
    }
}
