//! A layout as text: `invariant=structure,...`, as the command line takes it.

use std::str::FromStr;

use super::Layout;
use crate::CodegenError;
use crate::invariants::{Invariant, Structure};

impl Layout {
    /// Declares one invariant by names; `dense` on an invariant that is symmetric at best means symmetric.
    ///
    /// Errors: [`CodegenError::UnknownInvariant`], and [`CodegenError::Structure`] for a structure that the invariant
    /// cannot have; the layout is then unchanged.
    pub fn declare(&mut self, invariant: &str, structure: Structure) -> Result<(), CodegenError> {
        let Some(known) = Invariant::from_name(invariant) else {
            return Err(CodegenError::UnknownInvariant {
                found: invariant.to_owned(),
                expected: Invariant::ALL.map(Invariant::name).join(", "),
            });
        };
        let general = known.description().general();
        let changed = self.with(known, if structure == Structure::Dense { general } else { structure });
        changed.check()?;
        *self = changed;
        Ok(())
    }
}

impl FromStr for Layout {
    type Err = CodegenError;

    /// What is not named is as in the general layout; the empty text is the general layout.
    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let mut layout = Self::GENERAL;
        let mut seen: Vec<&str> = Vec::new();
        for entry in text.split(',').map(str::trim).filter(|entry| !entry.is_empty()) {
            let refused = |reason: String| CodegenError::LayoutText { found: entry.to_owned(), reason };
            let Some((invariant, structure)) = entry.split_once('=') else {
                return Err(refused("expected invariant=structure, like first_moment=zero".to_owned()));
            };
            let (invariant, structure) = (invariant.trim(), structure.trim());
            if seen.contains(&invariant) {
                return Err(refused(format!("{invariant} is given twice")));
            }
            seen.push(invariant);
            let structure = Structure::from_name(structure).ok_or_else(|| {
                let names = Structure::ALL.map(Structure::name).join(", ");
                refused(format!("expected one of: {names}; found {structure}"))
            })?;
            layout.declare(invariant, structure)?;
        }
        Ok(layout)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_layout_is_read_from_text() {
        assert_eq!("".parse::<Layout>().unwrap(), Layout::GENERAL);
        let text = "first_moment=zero, modal_first_moment=zero, second_moment=diagonal, mass=dense, \
                    position_mode_moment=symmetric, modal_mass=identity, stiffness=diagonal, damping=diagonal";
        assert_eq!(text.parse::<Layout>().unwrap(), Layout::FREE_FREE);
    }

    #[test]
    fn every_invariant_can_be_declared_by_its_name() {
        let mut layout = Layout::GENERAL;
        for (invariant, _) in Layout::FREE_FREE.entries() {
            let structure = invariant.description().admitted[0];
            layout.declare(invariant.name(), structure).unwrap();
            assert_eq!(layout[invariant], structure);
            layout.declare(invariant.name(), Structure::Dense).unwrap();
            assert_eq!(layout[invariant], invariant.description().general());
        }
        assert!(layout.declare("colour", Structure::Zero).is_err());
    }

    #[test]
    fn mistakes_are_answered_with_what_is_known() {
        let message = |text: &str| text.parse::<Layout>().unwrap_err().to_string();
        assert_eq!(
            message("first_moment"),
            "`first_moment`: expected invariant=structure, like first_moment=zero"
        );
        assert!(
            message("third_moment=zero")
                .starts_with("unknown invariant `third_moment`, expected one of: mass, ")
        );
        assert!(message("damping=sparse").contains("zero, identity, diagonal"));
        assert!(message("damping=zero,damping=zero").contains("given twice"));
        assert_eq!(message("mass=zero"), "mass cannot be zero, expected one of: dense");
        assert_eq!(
            message("modal_mass=zero"),
            "modal_mass cannot be zero, expected one of: identity, diagonal, symmetric"
        );
    }
}
