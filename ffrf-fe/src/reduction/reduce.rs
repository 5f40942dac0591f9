//! The reduction itself.

use faer::Mat;
use ffrf_model::{
    Inertia, Mode, ModeKind, ModelError, Provenance, ReducedBody, SCHEMA_VERSION, UNKNOWN_UNITS, Units,
};

use crate::modes::ModeError;
use crate::{FeError, FeModel, ModeBasis};

use super::damping::modal_damping;
use super::invariants::inertia_of;
use super::marker::make_marker;
use super::stiffness::modal_stiffness;
use super::{Damping, ReductionError, ReductionOptions, mean_axis};

/// Role of the file with the mode shapes of the user among the sources of a model.
pub const MODE_SHAPES: &str = "mode shapes";

/// Reduces a finite-element model to the modes of a basis.
///
/// Source: `docs/theory/equations.md`, (206-208): every invariant from M_s, K_ff = ΨᵀKΨ.
/// Errors: sizes that do not fit, no stiffness, bad damping or markers, and every failed consistency check of
/// [`ReducedBody::check`], dependence of the modes on rigid motion among them.
/// Panics: never.
pub fn reduce(
    model: &FeModel,
    basis: &ModeBasis,
    options: &ReductionOptions,
) -> Result<ReducedBody, FeError> {
    let shapes = &basis.shapes;
    let nodes = model.nodes.len();
    if shapes.nrows() != 3 * nodes {
        return Err(ModeError::ModeShapeRows { nodes, expected: 3 * nodes, found: shapes.nrows() }.into());
    }
    if shapes.ncols() != basis.modes.len() {
        return Err(ReductionError::ModeCount { shapes: shapes.ncols(), modes: basis.modes.len() }.into());
    }
    let mut inertia = inertia_of(model, shapes);
    mean_axis::clear(&mut inertia, &basis.modes);
    let stiffness = modal_stiffness(model, basis, options.modal_stiffness.as_ref())?;
    let second = options.units.map_or(1.0, |units| units.time());
    let mass = modal_mass(&inertia);
    let damping = modal_damping(&options.damping, mass.as_ref(), stiffness.as_ref(), second)?;
    let mut notes = model.notes.clone();
    if options.damping != Damping::None {
        notes.push(format!("damping: {}", options.damping));
    }
    let markers = options
        .markers
        .iter()
        .map(|request| make_marker(model, shapes, request))
        .collect::<Result<Vec<_>, _>>()?;
    let body = ReducedBody {
        schema_version: SCHEMA_VERSION,
        title: options.title.clone(),
        units: options.units.map_or_else(|| UNKNOWN_UNITS.to_owned(), |units| units.to_string()),
        provenance: Provenance {
            tool: "ffrf".to_owned(),
            tool_version: env!("CARGO_PKG_VERSION").to_owned(),
            sources: model.sources.clone(),
            notes,
        },
        modes: in_hertz(&basis.modes, options.units),
        inertia,
        stiffness: rows(&stiffness),
        damping: rows(&damping),
        geometric_stiffness: None,
        second_order_terms: Default::default(),
        markers,
        stress_markers: Vec::new(),
        section_markers: Vec::new(),
    };
    match body.check()?.verdict() {
        Ok(()) => Ok(body),
        Err(fault) => Err(blame(fault, model, &basis.modes)),
    }
}

/// The modes with frequencies in hertz, given those in cycles per unit of time; as they are where units are not known.
fn in_hertz(modes: &[Mode], units: Option<Units>) -> Vec<Mode> {
    let time = units.map_or(1.0, |units| units.time());
    modes.iter().map(|mode| Mode { frequency_hz: mode.frequency_hz.map(|f| f / time), ..*mode }).collect()
}

/// Names the file of the mode shapes if the user supplied them.
fn blame(fault: ModelError, model: &FeModel, modes: &[Mode]) -> FeError {
    let shapes = model.sources.iter().find(|source| source.role == MODE_SHAPES);
    match shapes.filter(|_| modes.iter().any(|mode| mode.kind == ModeKind::User)) {
        Some(source) => FeError::UserModes { file: source.file.clone(), fault: Box::new(fault) },
        None => fault.into(),
    }
}

/// Θ_ff = [tr T_μν].
fn modal_mass(inertia: &Inertia) -> Mat<f64> {
    let moments = &inertia.mode_mode_moment;
    Mat::from_fn(moments.len(), moments.len(), |mu, nu| (0..3).map(|i| moments[mu][nu][i][i]).sum())
}

fn rows(matrix: &Mat<f64>) -> Vec<Vec<f64>> {
    (0..matrix.nrows()).map(|i| (0..matrix.ncols()).map(|j| matrix[(i, j)]).collect()).collect()
}
