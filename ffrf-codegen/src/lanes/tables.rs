//! The numbers of a body in the layout of vector registers, padded with zero.

use super::{MomentTables, Table};
use crate::body::{BodyExpressions, MomentComponents};
use crate::expression::{Expression, Graph};
use crate::{CodegenError, ScalarType};

/// A diagonal matrix over the modes.
#[derive(Debug, Clone, PartialEq)]
pub enum Diagonal {
    /// Nothing.
    Zero,
    /// Ones.
    Identity,
    /// These entries. Shape: groups, lanes (4).
    Entries(Table),
}

/// The numbers of a body whose kernels are loops over lanes, as the generated `static` holds them.
///
/// A lane is a mode; lanes stand in groups of four, padded with zero. Frame: body. What is `None` the layout leaves out.
#[derive(Debug, Clone, PartialEq)]
pub struct LaneTables {
    /// Number of modes M.
    pub modes: usize,
    /// Number of groups of four lanes.
    pub groups: usize,
    /// Mass m. Units: kg.
    pub mass: f64,
    /// First moment m a. Shape: 3. Units: kg m.
    pub first_moment: Option<[f64; 3]>,
    /// m b_μ. Shape: groups, axes (3), lanes (4).
    pub modal_first_moment: Option<Table>,
    /// Inertia tensor: xx, yy, zz, xy, xz, yz. Units: kg m².
    pub inertia: [f64; 6],
    /// Inverse of the mass left for translation: xx, yy, zz, xy, xz, yz. Units: 1/kg.
    pub translation_compliance: [f64; 6],
    /// tr T_μ, then yy, zz, xy + yx, xz + zx, yz + zy of T_μ. Shape: groups, components (6), lanes (4).
    pub position_mode_even: Option<Table>,
    /// ϑ_μ. Shape: groups, axes (3), lanes (4).
    pub position_mode_odd: Option<Table>,
    /// tr T_μμ.
    pub trace: Diagonal,
    /// Θ_ff.
    pub modal_mass: Diagonal,
    /// Θ_ff⁻¹.
    pub modal_compliance: Diagonal,
    /// K_ff and D_ff if both are diagonal.
    pub internal: Option<[Diagonal; 2]>,
    /// T_νμ.
    pub moments: MomentTables,
}

impl LaneTables {
    /// The tables of a body whose invariants are constants and whose Θ_ff is diagonal.
    pub(crate) fn new(
        graph: &Graph,
        body: &BodyExpressions,
        scalar: ScalarType,
    ) -> Result<Self, CodegenError> {
        let modes = body.mode_count();
        let value = |expression: Expression| graph.constant_value(expression).unwrap_or(f64::NAN);
        let even = |moment: &MomentComponents| moment.even.map(value);
        let odd = |moment: &MomentComponents| moment.odd.map(value);
        let mut entries = vec![0.0; 8 * modes * modes];
        for mu in 0..modes {
            for nu in 0..modes {
                let moment = &body.mode_mode[nu][mu];
                let components = even(moment).into_iter().skip(1).chain(odd(moment));
                for (component, entry) in components.enumerate() {
                    entries[(component * modes + mu) * modes + nu] = entry;
                }
            }
        }
        let is_empty = entries.iter().all(|entry| *entry == 0.0);
        let moments = MomentTables::new(modes, scalar, is_empty, |component, mu, nu| {
            let inside = mu < modes && nu < modes;
            if inside { entries[(component * modes + mu) * modes + nu] } else { 0.0 }
        });
        let groups = moments.groups(modes);
        let mass = value(body.mass);
        let first: Vec<[f64; 3]> = body.modal_first_moment.iter().map(|moment| moment.map(value)).collect();
        let modal_mass: Vec<f64> = (0..modes).map(|mu| value(body.modal_mass[mu][mu])).collect();
        let [xx, yy, zz] = body.inertia.diagonal.map(value);
        let [yz, xz, xy] = body.inertia.off_diagonal.map(value);
        let internal = diagonal_of(graph, &body.stiffness).zip(diagonal_of(graph, &body.damping));
        Ok(Self {
            modes,
            groups,
            mass,
            first_moment: Some(body.first_moment.map(value)).filter(|moment| !is_zero(moment)),
            translation_compliance: translation_compliance(mass, &first, &modal_mass)?,
            modal_first_moment: in_lanes(groups, first),
            inertia: [xx, yy, zz, xy, xz, yz],
            position_mode_even: in_lanes(groups, body.position_mode.iter().map(even).collect()),
            position_mode_odd: in_lanes(groups, body.position_mode.iter().map(odd).collect()),
            trace: diagonal(groups, (0..modes).map(|mu| value(body.mode_mode[mu][mu].even[0])).collect()),
            modal_compliance: diagonal(groups, modal_mass.iter().map(|mass| 1.0 / mass).collect()),
            modal_mass: diagonal(groups, modal_mass),
            internal: internal
                .map(|(stiffness, damping)| [diagonal(groups, stiffness), diagonal(groups, damping)]),
            moments,
        })
    }

    /// The strategy in words, for the banner.
    pub fn description(&self, scalar: ScalarType) -> String {
        format!("lanes over modes, {} groups of 4; {}", self.groups, self.moments.description(scalar))
    }

    /// Bytes of the table of moments.
    pub(crate) fn moment_bytes(&self, scalar: ScalarType) -> usize {
        self.moments.bytes(scalar)
    }
}

/// The diagonal of a matrix that has nothing else.
fn diagonal_of(graph: &Graph, matrix: &[Vec<Expression>]) -> Option<Vec<f64>> {
    let mut entries = Vec::with_capacity(matrix.len());
    for (mu, row) in matrix.iter().enumerate() {
        if row.iter().enumerate().any(|(nu, entry)| mu != nu && !graph.is_zero(*entry)) {
            return None;
        }
        entries.push(graph.constant_value(row[mu])?);
    }
    Some(entries)
}

fn is_zero(numbers: &[f64]) -> bool {
    numbers.iter().all(|number| *number == 0.0)
}

/// One row per mode in lanes, `None` if all are zero. Shape: groups, K, lanes (4).
fn in_lanes<const K: usize>(groups: usize, rows: Vec<[f64; K]>) -> Option<Table> {
    let at = |[group, k, lane]: [usize; 3]| rows.get(4 * group + lane).map_or(0.0, |row| row[k]);
    (!is_zero(rows.as_flattened())).then(|| Table::new([groups, K, 4], at))
}

fn diagonal(groups: usize, entries: Vec<f64>) -> Diagonal {
    if is_zero(&entries) {
        Diagonal::Zero
    } else if entries.iter().all(|entry| *entry == 1.0) {
        Diagonal::Identity
    } else {
        let at = |[group, lane]: [usize; 2]| entries.get(4 * group + lane).copied().unwrap_or(0.0);
        Diagonal::Entries(Table::new([groups, 4], at))
    }
}

/// (m I - m B Θ_ff⁻¹ (m B)ᵀ)⁻¹ by Cholesky factors, which also show whether it is positive definite.
fn translation_compliance(
    mass: f64,
    first: &[[f64; 3]],
    modal_mass: &[f64],
) -> Result<[f64; 6], CodegenError> {
    let mut left = [[0.0; 3]; 3];
    for (i, row) in left.iter_mut().enumerate() {
        for (j, entry) in row.iter_mut().enumerate() {
            let carried: f64 = first.iter().zip(modal_mass).map(|(b, m)| b[i] * b[j] / m).sum();
            *entry = if i == j { mass - carried } else { -carried };
        }
    }
    let mut factor = [[0.0; 3]; 3];
    for i in 0..3 {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| factor[i][k] * factor[j][k]).sum();
            let rest = left[i][j] - sum;
            if i == j {
                if rest.is_nan() || rest <= f64::EPSILON * mass {
                    return Err(CodegenError::DependentModes { pivot: i, found: rest });
                }
                factor[i][i] = f64::sqrt(rest);
            } else {
                factor[i][j] = rest / factor[j][j];
            }
        }
    }
    let mut inverse = [[0.0; 3]; 3];
    for (column, inverse) in inverse.iter_mut().enumerate() {
        let mut x = [0.0; 3];
        for i in 0..3 {
            let sum: f64 = (0..i).map(|k| factor[i][k] * x[k]).sum();
            x[i] = (if i == column { 1.0 } else { 0.0 } - sum) / factor[i][i];
        }
        for i in (0..3).rev() {
            let sum: f64 = (i + 1..3).map(|k| factor[k][i] * inverse[k]).sum();
            inverse[i] = (x[i] - sum) / factor[i][i];
        }
    }
    let [[xx, xy, xz], [_, yy, yz], [_, _, zz]] = inverse;
    Ok([xx, yy, zz, xy, xz, yz])
}
