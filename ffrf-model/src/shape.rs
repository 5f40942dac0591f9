//! Lengths and finiteness: what every body must satisfy before any number in it means anything.

use crate::{ModelError, ReducedBody, SCHEMA_VERSION};

impl ReducedBody {
    /// Checks the version, that every list has one entry per mode, and that every number is finite.
    ///
    /// Errors: `Version`, `Length`, `NotFinite`, each with the full path of the field. Panics: never.
    pub fn check_shape(&self) -> Result<(), ModelError> {
        if self.schema_version != SCHEMA_VERSION {
            return Err(ModelError::Version { found: self.schema_version.into(), known: SCHEMA_VERSION });
        }
        let expected = self.mode_count();
        let inertia = &self.inertia;
        for (mu, mode) in self.modes.iter().enumerate() {
            finite(&format!("modes[{mu}].frequency_hz"), mode.frequency_hz.as_slice())?;
        }
        finite("inertia.mass", &[inertia.mass])?;
        finite("inertia.first_moment", &inertia.first_moment)?;
        rows("inertia.modal_first_moment", &inertia.modal_first_moment, expected)?;
        rows("inertia.second_moment", &inertia.second_moment, 3)?;
        matrices("inertia.position_mode_moment", &inertia.position_mode_moment, expected)?;
        length("inertia.mode_mode_moment", inertia.mode_mode_moment.len(), expected)?;
        for (mu, row) in inertia.mode_mode_moment.iter().enumerate() {
            matrices(&format!("inertia.mode_mode_moment[{mu}]"), row, expected)?;
        }
        square("stiffness", &self.stiffness, expected)?;
        square("damping", &self.damping, expected)?;
        for (index, marker) in self.markers.iter().enumerate() {
            finite(&format!("markers[{index}].position"), &marker.position)?;
            rows(&format!("markers[{index}].translation"), &marker.translation, expected)?;
            rows(&format!("markers[{index}].rotation"), &marker.rotation, expected)?;
        }
        Ok(())
    }
}

fn length(field: &str, found: usize, expected: usize) -> Result<(), ModelError> {
    if found == expected {
        Ok(())
    } else {
        Err(ModelError::Length { field: field.to_owned(), expected, found })
    }
}

fn finite(field: &str, numbers: &[f64]) -> Result<(), ModelError> {
    match numbers.iter().position(|number| !number.is_finite()) {
        None => Ok(()),
        Some(index) => {
            let field = if numbers.len() == 1 { field.to_owned() } else { format!("{field}[{index}]") };
            Err(ModelError::NotFinite { field, found: numbers[index] })
        }
    }
}

fn rows<R: AsRef<[f64]>>(field: &str, list: &[R], expected: usize) -> Result<(), ModelError> {
    length(field, list.len(), expected)?;
    for (index, row) in list.iter().enumerate() {
        finite(&format!("{field}[{index}]"), row.as_ref())?;
    }
    Ok(())
}

fn matrices(field: &str, list: &[crate::Matrix3], expected: usize) -> Result<(), ModelError> {
    length(field, list.len(), expected)?;
    for (index, matrix) in list.iter().enumerate() {
        rows(&format!("{field}[{index}]"), matrix, 3)?;
    }
    Ok(())
}

fn square(field: &str, matrix: &[Vec<f64>], expected: usize) -> Result<(), ModelError> {
    length(field, matrix.len(), expected)?;
    for (index, row) in matrix.iter().enumerate() {
        let field = format!("{field}[{index}]");
        length(&field, row.len(), expected)?;
        finite(&field, row)?;
    }
    Ok(())
}
