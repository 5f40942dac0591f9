//! The numbers of a body in the layout of vector registers, padded with zero.

use crate::body::{BodyExpressions, MomentComponents};
use crate::expression::{Expression, Graph};
use crate::{CodegenError, ScalarType};

/// Largest table of all moments, in bytes, that is stored whole: with coordinates and results it stays in a
/// first-level cache of 32 KB. Larger ones are stored by half.
const LARGEST_WHOLE_TABLE: usize = 24 * 1024;

/// A diagonal matrix over the modes.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Diagonal {
    Zero,
    Identity,
    Entries(Vec<f64>),
}

/// The moments T_νμ in the eight components of a product, at `(component, mu, nu)`.
#[derive(Debug, Clone)]
pub(crate) struct Moments {
    entries: Vec<f64>,
    modes: usize,
}

/// How the moments are stored.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Storage {
    /// No moment is left.
    None,
    /// All of them, in this many pairs of groups of four lanes, and a single group or none.
    Whole { pairs: usize, single: usize },
    /// Half of them, in blocks of this width, and this many rows of blocks.
    Half { width: usize, rows: usize },
}

/// What a `LaneBody` consists of.
#[derive(Debug, Clone)]
pub(crate) struct LaneTables {
    pub(crate) modes: usize,
    /// Groups of four lanes.
    pub(crate) groups: usize,
    pub(crate) mass: f64,
    pub(crate) first_moment: Option<[f64; 3]>,
    pub(crate) modal_first_moment: Option<Vec<[f64; 3]>>,
    /// xx, yy, zz, xy, xz, yz.
    pub(crate) inertia: [f64; 6],
    /// Inverse of the mass left for translation: xx, yy, zz, xy, xz, yz.
    pub(crate) translation_compliance: [f64; 6],
    pub(crate) position_mode_even: Option<Vec<[f64; 6]>>,
    pub(crate) position_mode_odd: Option<Vec<[f64; 3]>>,
    pub(crate) trace: Diagonal,
    pub(crate) modal_mass: Diagonal,
    pub(crate) modal_compliance: Diagonal,
    /// K_ff and D_ff if both are diagonal.
    pub(crate) internal: Option<[Diagonal; 2]>,
    pub(crate) moments: Moments,
    pub(crate) storage: Storage,
}

impl Moments {
    /// Component `component` of T_νμ; zero outside the modes.
    pub(crate) fn at(&self, component: usize, mu: usize, nu: usize) -> f64 {
        if mu >= self.modes || nu >= self.modes {
            return 0.0;
        }
        self.entries[(component * self.modes + mu) * self.modes + nu]
    }
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
        let storage = storage(modes, scalar, entries.iter().all(|entry| *entry == 0.0));
        let mass = value(body.mass);
        let first: Vec<[f64; 3]> = body.modal_first_moment.iter().map(|moment| moment.map(value)).collect();
        let modal_mass: Vec<f64> = (0..modes).map(|mu| value(body.modal_mass[mu][mu])).collect();
        let [xx, yy, zz] = body.inertia.diagonal.map(value);
        let [yz, xz, xy] = body.inertia.off_diagonal.map(value);
        Ok(Self {
            modes,
            groups: match storage {
                Storage::Half { width, rows } => width * rows / 4,
                _ => modes.div_ceil(4),
            },
            mass,
            first_moment: Some(body.first_moment.map(value)).filter(|moment| !is_zero(moment)),
            translation_compliance: translation_compliance(mass, &first, &modal_mass)?,
            modal_first_moment: Some(first).filter(|first| !is_zero(first.as_flattened())),
            inertia: [xx, yy, zz, xy, xz, yz],
            position_mode_even: kept(body.position_mode.iter().map(even).collect()),
            position_mode_odd: kept(body.position_mode.iter().map(odd).collect()),
            trace: diagonal((0..modes).map(|mu| value(body.mode_mode[mu][mu].even[0])).collect()),
            modal_compliance: diagonal(modal_mass.iter().map(|mass| 1.0 / mass).collect()),
            modal_mass: diagonal(modal_mass),
            internal: diagonal_of(graph, &body.stiffness)
                .zip(diagonal_of(graph, &body.damping))
                .map(|(stiffness, damping)| [stiffness, damping]),
            moments: Moments { entries, modes },
            storage,
        })
    }

    /// The strategy in words, for the banner.
    pub(crate) fn description(&self, scalar: ScalarType) -> String {
        let storage = match self.storage {
            Storage::None => "no moments of pairs of modes".to_owned(),
            Storage::Whole { .. } => {
                format!("whole table of moments, {} bytes", self.moment_bytes(scalar))
            }
            Storage::Half { width, .. } => format!(
                "table of moments by half in blocks of {width} x {width}, {} bytes",
                self.moment_bytes(scalar)
            ),
        };
        format!("lanes over modes, {} groups of 4; {storage}", self.groups)
    }

    /// Bytes of the table of moments.
    pub(crate) fn moment_bytes(&self, scalar: ScalarType) -> usize {
        let numbers = match self.storage {
            Storage::None => 0,
            Storage::Whole { .. } => 32 * self.groups * self.modes,
            Storage::Half { width, rows } => 8 * width * width * rows * (rows + 1) / 2,
        };
        numbers * scalar_bytes(scalar)
    }
}

fn scalar_bytes(scalar: ScalarType) -> usize {
    match scalar {
        ScalarType::F64 => 8,
        ScalarType::F32 => 4,
    }
}

fn storage(modes: usize, scalar: ScalarType, is_empty: bool) -> Storage {
    let groups = modes.div_ceil(4);
    if is_empty {
        Storage::None
    } else if 32 * groups * modes * scalar_bytes(scalar) <= LARGEST_WHOLE_TABLE {
        Storage::Whole { pairs: groups / 2, single: groups % 2 }
    } else {
        // A register of 32 bytes is the widest that every current x86-64 processor works on at full rate.
        let width = 32 / scalar_bytes(scalar);
        Storage::Half { width, rows: modes.div_ceil(width) }
    }
}

/// The diagonal of a matrix that has nothing else.
fn diagonal_of(graph: &Graph, matrix: &[Vec<Expression>]) -> Option<Diagonal> {
    let mut entries = Vec::with_capacity(matrix.len());
    for (mu, row) in matrix.iter().enumerate() {
        if row.iter().enumerate().any(|(nu, entry)| mu != nu && !graph.is_zero(*entry)) {
            return None;
        }
        entries.push(graph.constant_value(row[mu])?);
    }
    Some(diagonal(entries))
}

fn is_zero(numbers: &[f64]) -> bool {
    numbers.iter().all(|number| *number == 0.0)
}

fn kept<const K: usize>(rows: Vec<[f64; K]>) -> Option<Vec<[f64; K]>> {
    Some(rows).filter(|rows| !is_zero(rows.as_flattened()))
}

fn diagonal(entries: Vec<f64>) -> Diagonal {
    if is_zero(&entries) {
        Diagonal::Zero
    } else if entries.iter().all(|entry| *entry == 1.0) {
        Diagonal::Identity
    } else {
        Diagonal::Entries(entries)
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
