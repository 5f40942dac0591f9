//! What the generator knows about an invariant, and what follows from it.

use super::Structure;

/// One line of the table of invariants.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Description {
    /// The name by which layouts, fields and symbols know it.
    pub name: &'static str,
    /// What it is, with its symbol.
    pub title: &'static str,
    /// Units for unit modes; empty where they depend on those of the modes.
    pub units: &'static str,
    /// Number of indices that count modes; they come first.
    pub modes: usize,
    /// Number of indices that count axes.
    pub axes: usize,
    /// The structures that it can have, from the most special to the most general.
    pub admitted: &'static [Structure],
    /// Its structure for mass-normalised free-free eigenmodes in a frame at the centre of mass along the principal axes.
    pub free_free: Structure,
    /// Its structure where a layout says nothing about it, if that is not the most general one: few bodies have it.
    pub undeclared: Option<Structure>,
}

impl Description {
    /// Number of indices of an entry.
    pub const fn rank(&self) -> usize {
        self.modes + self.axes
    }

    /// The structure of which nothing is known.
    pub const fn general(&self) -> Structure {
        match self.admitted {
            [.., last] => *last,
            [] => Structure::Dense,
        }
    }

    /// The structure of an invariant that a layout does not name.
    pub const fn unnamed(&self) -> Structure {
        match self.undeclared {
            Some(structure) => structure,
            None => self.general(),
        }
    }

    /// Whether its structure is that of square matrices: over the axes if it has two of them, else over the modes.
    pub const fn is_square(&self) -> bool {
        self.axes == 2 || self.modes == 2
    }

    /// How many indices are written where it is stored with the given structure: of a diagonal, one of the last two.
    pub fn stored_rank(&self, structure: Structure) -> usize {
        let is_list = self.is_square() && structure == Structure::Diagonal;
        self.rank() - usize::from(is_list)
    }

    /// Lengths of the nested arrays in which it is stored, the outermost first.
    pub fn stored_lengths(&self, structure: Structure, mode_count: usize) -> Vec<usize> {
        (0..self.stored_rank(structure)).map(|k| if k < self.modes { mode_count } else { 3 }).collect()
    }

    /// The documentation of a field that stores it with the given structure.
    pub fn documentation(&self, structure: Structure, mode_count: usize) -> String {
        let mut text = format!("{}.", self.title);
        if !self.is_square() && self.rank() > 0 {
            let lengths: Vec<String> =
                self.stored_lengths(structure, mode_count).iter().map(usize::to_string).collect();
            text.push_str(&format!(" Shape: {}.", lengths.join(" x ")));
        }
        if !self.units.is_empty() {
            text.push_str(&format!(" Units: {}.", self.units));
        }
        if self.axes > 0 {
            text.push_str(" Frame: body.");
        }
        text.push_str(match structure {
            Structure::Diagonal => " Its diagonal.",
            Structure::Symmetric => " Symmetric: the upper triangle is read, the lower one must mirror it.",
            Structure::Antisymmetric => {
                " Antisymmetric: the upper triangle is read, the lower one must be its negative."
            }
            Structure::Zero | Structure::Identity | Structure::Dense => "",
        });
        text
    }
}
