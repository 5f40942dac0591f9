//! From a request to component modes.

use std::collections::BTreeSet;

use faer::{Mat, Par};
use ffrf_model::ModeKind;

use crate::modes::{Progress, Stage, gram};
use crate::{FeError, FeModel, ModeBasis};

use super::condition::Condition;
use super::constrained::Constrained;
use super::coordinates::Coordinates;
use super::flexibility::{Flexibility, Supported};
use super::free_free::{Transformed, transform};
use super::importance::{compliance_kept, compliance_shares, effective_mass_shares};
use super::interface_motion::InterfaceMotion;
use super::normal_modes::{NormalModes, normal_modes};
use super::report::{ComponentReport, NormalEntry, entries};
use super::rigid_motion::RigidMotion;
use super::shapes::Shapes;
use super::{
    BasisForm, ComponentBasis, ComponentModeError, ComponentRequest, Interface, attachment, craig_bampton,
    herting, raw, reference_condition, residual, static_load,
};

/// Largest strain energy of a rigid motion relative to that of the lowest mode: a thousandth of its frequency, far
/// above what rounded node coordinates cause, far below any real spring to ground that would matter.
const STRAINED: f64 = 1e-6;

/// A component basis and the account of how it was made.
#[derive(Debug, Clone)]
pub struct ComponentModes {
    /// The modes.
    pub basis: ModeBasis,
    /// Modal stiffness K_ff. Shape: M x M, symmetric; diagonal for transformed modes.
    pub stiffness: Mat<f64>,
    /// Motion of the reference points per unit modal coordinate: six rows for each interface, translations (m) and
    /// rotations (rad) along and about x, y, z. Shape: 6 I x M. Frame: body.
    pub interface_motion: Mat<f64>,
    /// The interfaces.
    pub interfaces: Vec<Interface>,
    /// What was found and how well.
    pub report: ComponentReport,
    /// Motion of the interfaces in the orthonormal modes of the basis, and their eigenvalues.
    pub(crate) modal_motion: Mat<f64>,
    pub(crate) modal_values: Vec<f64>,
}

/// Computes component modes.
///
/// Errors: no interface, interfaces that share nodes or cannot move independently, a stiffness that is missing, not
/// positive definite or that resists rigid motion, more normal modes than there are, nothing left to keep.
pub fn component_modes(
    model: &FeModel,
    request: &ComponentRequest,
    progress: &mut dyn FnMut(Progress),
) -> Result<ComponentModes, FeError> {
    check(request)?;
    let interfaces = &request.interfaces;
    let tied_to = request.reference.tied_to(interfaces)?;
    let coordinates = Coordinates::new(model, interfaces)?;
    let motion = InterfaceMotion::new(&coordinates, interfaces)?;
    let rigid = RigidMotion::new(&coordinates)?;
    progress(Progress { stage: Stage::Ordering, done: 0, total: 1 });
    let (supported, stiffness) = Supported::new(&coordinates, &rigid)?;
    progress(Progress { stage: Stage::Factorising, done: 0, total: 1 });
    let flexibility = Flexibility::new(&coordinates, &rigid, &supported, stiffness, request.threads)?;
    let compliance = motion.of(&coordinates, flexibility.elastic(motion.forces(&coordinates)).as_ref());
    let compliance: Vec<f64> = (0..motion.count()).map(|i| compliance[(i, i)]).collect();
    let spanned = span(&flexibility, &motion, &compliance, request, progress)?;
    let kept = match request.form {
        BasisForm::FreeFree => spanned.shapes,
        BasisForm::Raw => {
            let numbers = raw::independent(&coordinates, &rigid, &spanned.shapes, tied_to.unwrap_or(0))?;
            spanned.shapes.choose(&numbers)
        }
    };
    let given = spanned.count;
    let transformed = transform(&coordinates, &rigid, kept.clone())?;
    check_unstrained(&coordinates, &rigid, &transformed.values)?;
    let removed = match request.form {
        BasisForm::FreeFree => transformed.removed,
        BasisForm::Raw => given - kept.modes.len(),
    };
    let modal_motion = motion.of(&coordinates, transformed.shapes.columns.as_ref());
    let importance = compliance_shares(modal_motion.as_ref(), &transformed.values, &compliance);
    let chosen = choose(request, &transformed, &importance, given)?;
    let values: Vec<f64> = chosen.iter().map(|&k| transformed.values[k]).collect();
    let modal_motion = Mat::from_fn(motion.count(), chosen.len(), |i, k| modal_motion[(i, chosen[k])]);
    let compliance_kept = compliance_kept(modal_motion.as_ref(), &values, &compliance);
    let left_out = transformed.values.len() - chosen.len();

    let mut coupling = 0.0;
    let (shapes, stiffness) = match request.form {
        BasisForm::FreeFree => {
            let shapes = transformed.shapes.choose(&chosen);
            coupling = largest_coupling(&coordinates.stiffness_gram(shapes.columns.as_ref()));
            let size = chosen.len();
            let stiffness = Mat::from_fn(size, size, |i, j| if i == j { values[i] } else { 0.0 });
            (shapes, stiffness)
        }
        BasisForm::Raw => {
            let stiffness = coordinates.stiffness_gram(kept.columns.as_ref());
            (kept, stiffness)
        }
    };
    let Shapes { columns, modes } = shapes;
    let columns = reference_condition::apply(&request.reference, &flexibility, &motion, interfaces, columns)?;
    let interface_motion = motion.of(&coordinates, columns.as_ref());
    let report = ComponentReport {
        method: method(request, &spanned.normal, &supported),
        interfaces: interfaces.iter().map(describe).collect(),
        rigid_modes: rigid.count(),
        normal: spanned.entries,
        removed,
        left_out,
        compliance,
        compliance_kept,
        orthogonality_error: deviation_from_identity(&coordinates.mass_gram(columns.as_ref())),
        stiffness_coupling: coupling,
        modes: entries(&modes, &importance, &chosen, request.form),
        is_transformed: request.form == BasisForm::FreeFree,
    };
    let basis = ModeBasis { shapes: coordinates.expand(columns.as_ref()), modes };
    Ok(ComponentModes {
        basis,
        stiffness,
        interface_motion,
        interfaces: interfaces.clone(),
        report,
        modal_motion,
        modal_values: values,
    })
}

/// The shapes asked for and the normal modes among them.
struct Span {
    shapes: Shapes,
    count: usize,
    normal: NormalModes,
    entries: Vec<NormalEntry>,
}

fn span(
    flexibility: &Flexibility<'_>,
    motion: &InterfaceMotion,
    compliance: &[f64],
    request: &ComponentRequest,
    progress: &mut dyn FnMut(Progress),
) -> Result<Span, FeError> {
    let count = request.normal_modes;
    let mut told = |done| progress(Progress { stage: Stage::Iterating, done, total: count });
    let needs_constraints = matches!(request.basis, ComponentBasis::CraigBampton | ComponentBasis::Herting);
    let constrained =
        if needs_constraints { Some(Constrained::new(flexibility, motion, compliance)?) } else { None };
    let (shapes, normal) = match (&constrained, request.basis) {
        (Some(constrained), ComponentBasis::Herting) => herting::shapes(constrained, count, &mut told)?,
        (Some(constrained), _) => craig_bampton::shapes(constrained, count, &mut told)?,
        (None, ComponentBasis::Rubin) => residual::shapes(flexibility, motion, count, &mut told)?,
        (None, ComponentBasis::FreeFree) => {
            eigenmodes(Condition::Free(flexibility), ModeKind::FreeFree, count, &mut told)?
        }
        (None, ComponentBasis::Clamped) => {
            let first = InterfaceMotion::new(flexibility.coordinates, &request.interfaces)?.first();
            let held = Constrained::new(flexibility, &first, &compliance[..first.count()])?;
            eigenmodes(Condition::Clamped(&held), ModeKind::Clamped, count, &mut told)?
        }
        (None, _) => attachment::shapes(flexibility, motion, count, &mut told)?,
    };
    let coordinates = flexibility.coordinates;
    let effective = if request.basis.is_clamped() {
        let constraint = shapes.columns.get(.., ..motion.count());
        let mass = coordinates.mass_times(constraint);
        let coupling = gram(normal.shapes.as_ref(), mass.as_ref(), Par::Seq);
        let interface_mass = gram(constraint, mass.as_ref(), Par::Seq);
        Some(effective_mass_shares(&coupling, &interface_mass))
    } else {
        None
    };
    let entries = NormalEntry::list(&normal.values, effective.as_deref());
    let loads =
        static_load::shapes(coordinates.model, flexibility, constrained.as_ref(), &request.static_loads)?;
    let shapes = shapes.and(loads);
    Ok(Span { count: shapes.modes.len(), shapes, normal, entries })
}

/// Normal modes alone.
fn eigenmodes(
    condition: Condition<'_>,
    kind: ModeKind,
    count: usize,
    progress: &mut dyn FnMut(usize),
) -> Result<(Shapes, NormalModes), FeError> {
    let modes = normal_modes(condition, count, progress)?;
    Ok((Shapes::normal(&modes, kind), modes))
}

fn check(request: &ComponentRequest) -> Result<(), ComponentModeError> {
    if request.interfaces.is_empty() {
        return Err(ComponentModeError::NoInterface);
    }
    let mut names = BTreeSet::new();
    for interface in &request.interfaces {
        if !names.insert(&interface.name) {
            return Err(ComponentModeError::Repeated { interface: interface.name.clone() });
        }
    }
    request.selection.check()
}

fn choose(
    request: &ComponentRequest,
    transformed: &Transformed,
    importance: &[f64],
    given: usize,
) -> Result<Vec<usize>, ComponentModeError> {
    let frequencies: Vec<f64> =
        transformed.shapes.modes.iter().map(|mode| mode.frequency_hz.unwrap_or(0.0)).collect();
    let chosen = match request.form {
        BasisForm::FreeFree => request.selection.choose(&frequencies, importance),
        BasisForm::Raw => (0..frequencies.len()).collect(),
    };
    if chosen.is_empty() { Err(ComponentModeError::EmptyBasis { given }) } else { Ok(chosen) }
}

fn check_unstrained(
    coordinates: &Coordinates<'_>,
    rigid: &RigidMotion,
    values: &[f64],
) -> Result<(), FeError> {
    let energy = coordinates.stiffness_gram(rigid.shapes.as_ref());
    let lowest = values.first().copied().unwrap_or(0.0);
    for i in 0..rigid.count() {
        let ratio = energy[(i, i)].abs() / lowest;
        if ratio.is_nan() || ratio > STRAINED {
            return Err(ComponentModeError::RigidMotionStrained { ratio, limit: STRAINED }.into());
        }
    }
    Ok(())
}

fn method(request: &ComponentRequest, normal: &NormalModes, supported: &Supported) -> String {
    let form = match request.form {
        BasisForm::FreeFree => "transformed to free-free modes",
        BasisForm::Raw => "as it is",
    };
    format!(
        "{} basis {form}; {} normal modes ({}), factor of {:.1} million values",
        request.basis,
        normal.values.len(),
        normal.method,
        supported.analysis.stored_values() as f64 * 1e-6
    )
}

fn describe(interface: &Interface) -> String {
    let [x, y, z] = interface.reference_point;
    let coupling = if interface.is_rigid() { "rigid (RBE2)" } else { "mean (RBE3)" };
    format!(
        "{}: {} nodes, {coupling}, reference point {x:.6} {y:.6} {z:.6}",
        interface.name,
        interface.nodes.len()
    )
}

/// Largest entry off the diagonal over the geometric mean of its diagonal entries.
fn largest_coupling(matrix: &Mat<f64>) -> f64 {
    let mut largest = 0.0_f64;
    for j in 0..matrix.ncols() {
        for i in 0..j {
            largest = largest.max(matrix[(i, j)].abs() / (matrix[(i, i)] * matrix[(j, j)]).abs().sqrt());
        }
    }
    largest
}

fn deviation_from_identity(matrix: &Mat<f64>) -> f64 {
    let mut error = 0.0_f64;
    for j in 0..matrix.ncols() {
        for i in 0..matrix.nrows() {
            error = error.max((matrix[(i, j)] - if i == j { 1.0 } else { 0.0 }).abs());
        }
    }
    error
}
