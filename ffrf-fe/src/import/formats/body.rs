//! A reduced body from a file that another multibody program has for flexible bodies.

use std::path::Path;

use ffrf_model::{
    GeometricStiffness, Inertia, Marker, Mode, Provenance, ReducedBody, SCHEMA_VERSION, SecondOrderTerms,
    SourceFile, UNKNOWN_UNITS, Units,
};

use crate::import::ImportError;

/// What such a file holds.
pub(super) struct Parts {
    pub(super) modes: Vec<Mode>,
    pub(super) inertia: Inertia,
    pub(super) stiffness: Vec<Vec<f64>>,
    pub(super) damping: Vec<Vec<f64>>,
    pub(super) geometric_stiffness: Option<GeometricStiffness>,
    pub(super) second_order_terms: SecondOrderTerms,
    pub(super) markers: Vec<Marker>,
    pub(super) notes: Vec<String>,
}

/// The body, called after its file. Errors: its checks fail.
pub(super) fn body(
    path: &Path,
    units: Option<Units>,
    source: SourceFile,
    parts: Parts,
) -> Result<ReducedBody, ImportError> {
    let body = ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: path.file_stem().unwrap_or_default().to_string_lossy().into_owned(),
        units: units.map_or_else(|| UNKNOWN_UNITS.to_owned(), |units| units.to_string()),
        modes: parts.modes,
        inertia: parts.inertia,
        stiffness: parts.stiffness,
        damping: parts.damping,
        geometric_stiffness: parts.geometric_stiffness,
        second_order_terms: parts.second_order_terms,
        markers: parts.markers,
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: env!("CARGO_PKG_VERSION").to_owned(),
            sources: vec![source],
            notes: parts.notes,
        },
    };
    match body.check().and_then(|checks| checks.verdict()) {
        Ok(()) => Ok(body),
        Err(fault) => Err(ImportError::Body { path: path.to_path_buf(), fault: Box::new(fault) }),
    }
}
