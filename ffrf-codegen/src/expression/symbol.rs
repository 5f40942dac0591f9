//! Symbols: the inputs of an expression, named by what they are.

use super::input::{AXES, Input};
use crate::invariants::Invariant;

/// Indices of an entry of an invariant, modes first, then axes; the rest is zero.
pub type Indices = [usize; 4];

/// An input of an expression. Indices count from 0.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[non_exhaustive]
pub enum Symbol {
    /// An entry of an input of the kernel.
    Input(Input, usize),
    /// An entry of an invariant of the body. Of a symmetric one the entry with ascending indices; T_μν where μ <= ν.
    Parameter(Invariant, Indices),
    /// A value computed elsewhere: number `1` of the group `0`.
    Intermediate(&'static str, usize),
}

impl Symbol {
    /// Whether the symbol is an invariant of the body, not a part of its state.
    pub fn is_parameter(self) -> bool {
        matches!(self, Self::Parameter(..))
    }
}

impl Input {
    /// The symbol of entry `k`.
    pub const fn symbol(self, k: usize) -> Symbol {
        Symbol::Input(self, k)
    }

    /// The symbols of all entries.
    pub fn symbols(self, mode_count: usize) -> impl Iterator<Item = Symbol> {
        (0..self.size(mode_count)).map(move |k| self.symbol(k))
    }
}

impl Invariant {
    /// The symbol of an entry, by as many indices as the invariant has.
    pub fn at<const R: usize>(self, indices: [usize; R]) -> Symbol {
        debug_assert_eq!(R, self.description().rank(), "indices of {}", self.name());
        let mut all = [0; 4];
        for (index, given) in all.iter_mut().zip(indices) {
            *index = given;
        }
        Symbol::Parameter(self, all)
    }
}

impl core::fmt::Display for Symbol {
    /// A name that is a Rust identifier, unique for each symbol.
    fn fmt(&self, f: &mut core::fmt::Formatter<'_>) -> core::fmt::Result {
        match self {
            Self::Input(input, k) => input.write_entry(f, *k),
            Self::Parameter(invariant, indices) => {
                let description = invariant.description();
                f.write_str(description.name)?;
                let (modes, rest) = indices.split_at(description.modes);
                for (position, mode) in modes.iter().enumerate() {
                    write!(f, "{}{mode}", if position == 0 { "" } else { "_" })?;
                }
                for (position, axis) in rest.iter().take(description.axes).enumerate() {
                    let separator = if position == 0 { "_" } else { "" };
                    write!(f, "{separator}{}", AXES.get(*axis).copied().unwrap_or("unknown"))?;
                }
                Ok(())
            }
            Self::Intermediate(group, k) => write!(f, "{group}{k}"),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_say_which_entry_it_is() {
        for (symbol, name) in [
            (Input::COORDINATES.symbol(11), "q11"),
            (Input::ANGULAR_VELOCITY.symbol(2), "omega_z"),
            (Input::FORCE.symbol(1), "force_y"),
            (Input::FORCE.symbol(5), "moment_z"),
            (Input::ACCELERATION.symbol(8), "modal_acceleration2"),
            (Invariant::Mass.at([]), "mass"),
            (Invariant::FirstMoment.at([0]), "first_moment_x"),
            (Invariant::ModalFirstMoment.at([4, 1]), "modal_first_moment4_y"),
            (Invariant::ModeModeMoment.at([1, 12, 0, 2]), "mode_mode_moment1_12_xz"),
            (Invariant::Damping.at([0, 3]), "damping0_3"),
        ] {
            assert_eq!(symbol.to_string(), name);
        }
    }
}
