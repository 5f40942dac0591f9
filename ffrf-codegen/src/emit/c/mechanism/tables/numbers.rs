//! Numbers and tables as text.

use std::cell::Cell;
use std::fmt::Write as _;

use crate::emit::c::notation::number;
use crate::emit::c::text::braced;
use crate::mechanism::AttachmentModel;
use crate::{CodegenError, ScalarType};

/// Numbers in the scalar type, and the first that it does not hold.
pub(in super::super) struct Numbers {
    pub(super) scalar: ScalarType,
    refused: Cell<Option<f64>>,
}

impl Numbers {
    pub(in super::super) fn new(scalar: ScalarType) -> Self {
        Self { scalar, refused: Cell::new(None) }
    }

    pub(super) fn one(&self, value: f64) -> String {
        if self.scalar.is_finite(value) {
            number(value, self.scalar)
        } else {
            self.refused.set(self.refused.get().or(Some(value)));
            String::from("0")
        }
    }

    pub(super) fn list(&self, values: &[f64]) -> String {
        let entries: Vec<String> = values.iter().map(|value| self.one(*value)).collect();
        braced(&entries)
    }

    /// Errors: a number was not finite.
    pub(in super::super) fn verdict(&self) -> Result<(), CodegenError> {
        match self.refused.get() {
            None => Ok(()),
            Some(found) => Err(CodegenError::TooLarge {
                field: "a number of the mechanism".to_owned(),
                found,
                scalar: self.scalar.name(),
            }),
        }
    }
}

/// A named table; nothing where it would be empty, which C does not have.
pub(super) fn table(kind: &str, name: &str, entries: &[String]) -> String {
    if entries.is_empty() {
        return String::new();
    }
    let mut text = format!("static const {kind} {name}[{}] = {{\n", entries.len());
    for (index, entry) in entries.iter().enumerate() {
        let comma = if index + 1 < entries.len() { "," } else { "" };
        let _ = writeln!(text, "    {}{comma}", entry.replace('\n', "\n    "));
    }
    text.push_str("};\n\n");
    text
}

pub(super) fn integers(values: &[usize]) -> Vec<String> {
    values.iter().map(usize::to_string).collect()
}

/// A triad at a marker or on the ground.
pub(super) fn attachment(at: &AttachmentModel, numbers: &Numbers) -> String {
    let marker = at.marker.map_or_else(|| "-1".to_owned(), |marker| marker.to_string());
    format!("{{{marker}, {}, {}}}", numbers.list(&at.position), numbers.list(&at.orientation))
}
