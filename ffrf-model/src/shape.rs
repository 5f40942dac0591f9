//! Lengths and finiteness: what every body must satisfy before any number in it means anything.

use crate::{ModelError, ReducedBody, SCHEMA_VERSION};

impl ReducedBody {
    /// Checks the version, that every list has one entry per mode, and that every number is finite.
    ///
    /// Errors: `Version`, `Length`, `NotFinite`, each with the full path of the field.
    pub fn check_shape(&self) -> Result<(), ModelError> {
        if self.schema_version != SCHEMA_VERSION {
            return Err(ModelError::Version { found: self.schema_version.into(), known: SCHEMA_VERSION });
        }
        let expected = self.mode_count();
        let inertia = &self.inertia;
        length("inertia.modal_first_moment", &inertia.modal_first_moment, expected)?;
        length("inertia.position_mode_moment", &inertia.position_mode_moment, expected)?;
        square("inertia.mode_mode_moment", &inertia.mode_mode_moment, expected)?;
        square("stiffness", &self.stiffness, expected)?;
        square("damping", &self.damping, expected)?;
        if let Some(geometric) = &self.geometric_stiffness {
            square("geometric_stiffness.uniform_load", &geometric.uniform_load, expected)?;
            square("geometric_stiffness.linear_load", &geometric.linear_load, expected)?;
            for (index, load) in geometric.marker_loads.iter().enumerate() {
                let field = format!("geometric_stiffness.marker_loads[{index}].stiffness");
                square(&field, &load.stiffness, expected)?;
            }
        }
        for (index, marker) in self.markers.iter().enumerate() {
            length(&format!("markers[{index}].translation"), &marker.translation, expected)?;
            length(&format!("markers[{index}].rotation"), &marker.rotation, expected)?;
        }
        for (index, marker) in self.stress_markers.iter().enumerate() {
            length(&format!("stress_markers[{index}].stress"), &marker.stress, expected)?;
        }
        for (index, marker) in self.section_markers.iter().enumerate() {
            length(&format!("section_markers[{index}].force"), &marker.force, expected)?;
        }
        match self.find_number(|number| !number.is_finite()) {
            Some((field, found)) => Err(ModelError::NotFinite { field, found }),
            None => Ok(()),
        }
    }
}

fn length<T>(field: &str, list: &[T], expected: usize) -> Result<(), ModelError> {
    if list.len() == expected {
        Ok(())
    } else {
        Err(ModelError::Length { field: field.to_owned(), expected, found: list.len() })
    }
}

fn square<T>(field: &str, matrix: &[Vec<T>], expected: usize) -> Result<(), ModelError> {
    length(field, matrix, expected)?;
    for (index, row) in matrix.iter().enumerate() {
        length(&format!("{field}[{index}]"), row, expected)?;
    }
    Ok(())
}
