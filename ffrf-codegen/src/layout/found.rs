//! Finding the layout of a model by a relative tolerance.
//!
//! The invariants are a Gram matrix, so the Cauchy-Schwarz inequality gives each entry its natural scale:
//! an entry counts as zero if it is below the tolerance times that scale.

use ffrf_model::{GeometricStiffness, Matrix3, ReducedBody};

use super::Layout;
use crate::invariants::{Invariant, Structure};
use crate::options::{CENTRED_TOLERANCE, ORTHOGONALITY_TOLERANCE};

/// Norms, in the mass inner product, of the fields that the invariants are products of.
#[derive(Debug, Clone, PartialEq)]
pub struct GramScales {
    /// √m
    pub translation: f64,
    /// √tr T
    pub position: f64,
    /// √tr T_μμ
    pub modes: Vec<f64>,
    /// √K_μμ
    pub stiffness: Vec<f64>,
    /// √D_μμ
    pub damping: Vec<f64>,
}

impl GramScales {
    /// The scales of a body.
    pub fn of(body: &ReducedBody) -> Self {
        let root = |value: f64| value.max(0.0).sqrt();
        let trace = |matrix: &Matrix3| matrix[0][0] + matrix[1][1] + matrix[2][2];
        let inertia = &body.inertia;
        let modes = 0..body.mode_count();
        let scales = |matrix: &[Vec<f64>]| modes.clone().map(|mu| root(matrix[mu][mu])).collect();
        Self {
            translation: root(inertia.mass),
            position: root(trace(&inertia.second_moment)),
            modes: modes.clone().map(|mu| root(trace(&inertia.mode_mode_moment[mu][mu]))).collect(),
            stiffness: scales(&body.stiffness),
            damping: scales(&body.damping),
        }
    }
}

/// The most special layout that holds for `body` within `tolerance`.
pub fn found(body: &ReducedBody, tolerance: f64) -> Layout {
    let scales = GramScales::of(body);
    let inertia = &body.inertia;
    let count = body.mode_count();
    let modal_mass = inertia.modal_mass();
    let small = |value: f64, scale: f64| value.abs() <= tolerance * scale;
    let zero_or_dense = |zero: bool| if zero { Structure::Zero } else { Structure::Dense };
    let matrix3 = |matrix: &Matrix3, scale: f64| {
        let structure = Structure::of_matrix(3, |i, j| matrix[i][j], |_, _, value| small(value, scale));
        // A mode-moment equal to the unit matrix is chance; nothing is made of it.
        if structure == Structure::Identity { Structure::Diagonal } else { structure }
    };
    let modal = |matrix: &[Vec<f64>], scale: &[f64]| {
        Structure::of_matrix(
            count,
            |mu, nu| matrix[mu][nu],
            |mu, nu, value| value.abs() <= tolerance.max(ORTHOGONALITY_TOLERANCE) * scale[mu] * scale[nu],
        )
    };
    let join = |structures: &mut dyn Iterator<Item = Structure>| {
        structures.reduce(Structure::join).unwrap_or(Structure::Zero)
    };
    let negligible_lever = negligible_first_moment(body, &scales, tolerance);
    let position_square = scales.position * scales.position;
    let first_moment = zero_or_dense(inertia.first_moment.iter().all(|x| x.abs() <= negligible_lever));
    let position_mode_moment = join(
        &mut (0..count)
            .map(|mu| matrix3(&inertia.position_mode_moment[mu], scales.position * scales.modes[mu])),
    );
    let mode_mode_moment = join(&mut (0..count).flat_map(|mu| {
        let scales = &scales;
        (0..count)
            .map(move |nu| matrix3(&inertia.mode_mode_moment[mu][nu], scales.modes[mu] * scales.modes[nu]))
    }));
    let modal_mass = match count {
        0 => Structure::Identity,
        _ => at_least_diagonal(modal(&modal_mass, &scales.modes)),
    };
    let geometric = body.geometric_stiffness.as_ref();
    let stiffening = |entries: fn(&GeometricStiffness) -> Vec<f64>| {
        let is_zero = |geometric| entries(geometric).iter().all(|entry| *entry == 0.0);
        zero_or_dense(geometric.is_none_or(is_zero))
    };
    Layout::GENERAL
        .with(Invariant::FirstMoment, first_moment)
        .with(Invariant::ModalFirstMoment, zero_or_dense(modes_keep_the_centre(body, &scales, tolerance)))
        .with(Invariant::SecondMoment, at_least_diagonal(matrix3(&inertia.second_moment, position_square)))
        .with(Invariant::PositionModeMoment, position_mode_moment)
        .with(Invariant::ModeModeMoment, mode_mode_moment)
        .with(Invariant::ModalMass, modal_mass)
        .with(Invariant::Stiffness, modal(&body.stiffness, &scales.stiffness))
        .with(Invariant::Damping, modal(&body.damping, &scales.damping))
        .with(Invariant::UniformLoadStiffness, stiffening(|geometric| rows_of(&geometric.uniform_load)))
        .with(Invariant::LinearLoadStiffness, stiffening(|geometric| rows_of(&geometric.linear_load)))
}

/// Every number of a list of lists of vectors or matrices.
fn rows_of<T: Numbers>(blocks: &[Vec<T>]) -> Vec<f64> {
    blocks.iter().flatten().flat_map(Numbers::numbers).collect()
}

trait Numbers {
    fn numbers(&self) -> Vec<f64>;
}

impl Numbers for [f64; 3] {
    fn numbers(&self) -> Vec<f64> {
        self.to_vec()
    }
}

impl Numbers for Matrix3 {
    fn numbers(&self) -> Vec<f64> {
        self.concat()
    }
}

/// True if every b_μ counts as zero.
fn modes_keep_the_centre(body: &ReducedBody, scales: &GramScales, tolerance: f64) -> bool {
    body.inertia
        .modal_first_moment
        .iter()
        .zip(&scales.modes)
        .all(|(moment, mode)| moment.iter().all(|x| x.abs() <= tolerance * scales.translation * mode))
}

/// Up to which size an entry of the first moment m a counts as zero. Units: kg m.
pub fn negligible_first_moment(body: &ReducedBody, scales: &GramScales, tolerance: f64) -> f64 {
    let centred = modes_keep_the_centre(body, scales, tolerance);
    let tolerance = if centred { tolerance.max(CENTRED_TOLERANCE) } else { tolerance };
    tolerance * scales.translation * scales.position
}

/// A tensor that is never zero: zero, as found in degenerate bodies, is diagonal; unequal transposes are round-off.
fn at_least_diagonal(structure: Structure) -> Structure {
    match structure {
        Structure::Zero => Structure::Diagonal,
        Structure::Antisymmetric | Structure::Dense => Structure::Symmetric,
        other => other,
    }
}
