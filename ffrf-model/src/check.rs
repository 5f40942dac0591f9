//! Consistency checks: does the body contradict itself or physics, and by how much.

use crate::eigenvalues::smallest_eigenvalue;
use crate::independence::{Independence, dependent_modes, independence};
use crate::measured::{Check, Limit};
use crate::tolerances::{INDEPENDENCE, NEGATIVE_EIGENVALUE, RIGID_PIVOT, SYMMETRY};
use crate::{GeometricStiffness, Inertia, Matrix3, ModelError, ReducedBody};

/// The checks of one body, in a fixed order.
#[derive(Debug, Clone, PartialEq)]
pub struct CheckReport {
    /// Every check, passed or not.
    pub checks: Vec<Check>,
}

impl CheckReport {
    /// The checks that failed.
    pub fn failures(&self) -> impl Iterator<Item = &Check> {
        self.checks.iter().filter(|check| !check.passed())
    }

    /// All is well, or every failure at once.
    ///
    /// Errors: [`ModelError::Inconsistent`].
    pub fn verdict(&self) -> Result<(), ModelError> {
        let failures: Vec<Check> = self.failures().cloned().collect();
        if failures.is_empty() { Ok(()) } else { Err(ModelError::Inconsistent { failures }) }
    }
}

impl ReducedBody {
    /// Measures how consistent the body is: mass, symmetries, definiteness, independence of the modes from
    /// rigid motion, marker names.
    ///
    /// Errors: only those of [`check_shape`](Self::check_shape); the verdict on the numbers is
    /// [`CheckReport::verdict`]. Panics: never.
    pub fn check(&self) -> Result<CheckReport, ModelError> {
        self.check_shape()?;
        let inertia = &self.inertia;
        let mut checks = vec![
            Check::new("mass", inertia.mass, Limit::Above(0.0)),
            symmetry("asymmetry of the second moment T", &inertia.second_moment),
            mode_mode_symmetry(inertia),
            symmetry("asymmetry of the stiffness K_ff", &self.stiffness),
            symmetry("asymmetry of the damping D_ff", &self.damping),
        ];
        let fields = if self.second_order_terms.is_known() { usize::MAX } else { RIGID_FIELDS };
        let gram = smallest_eigenvalue(leading(scaled_gram_matrix(inertia), fields));
        checks.push(Check::new(
            "smallest eigenvalue of the Gram matrix of the inertia invariants, each field of unit norm",
            gram.unwrap_or(0.0),
            Limit::AtLeast(NEGATIVE_EIGENVALUE),
        ));
        checks.push(independent_modes(inertia));
        checks.push(definiteness("smallest eigenvalue of K_ff over its largest entry", &self.stiffness));
        checks.push(definiteness("smallest eigenvalue of D_ff over its largest entry", &self.damping));
        if let Some(geometric) = &self.geometric_stiffness {
            let (uniform, linear) = (&geometric.uniform_load, &geometric.linear_load);
            checks.push(exchange("asymmetry of the geometric stiffness of uniform loads", uniform));
            let flat: Vec<Vec<[f64; 9]>> =
                linear.iter().map(|row| row.iter().map(flattened).collect()).collect();
            checks.push(exchange("asymmetry of the geometric stiffness of linear loads", &flat));
            for load in &geometric.marker_loads {
                let subject = format!("asymmetry of the geometric stiffness of loads at {:?}", load.marker);
                checks.push(exchange(&subject, &load.stiffness));
            }
            checks.extend(loaded_markers(self, geometric));
        }
        checks.extend(marker_names(self));
        Ok(CheckReport { checks })
    }
}

fn largest<R: AsRef<[f64]>>(matrix: &[R]) -> f64 {
    matrix.iter().flat_map(|row| row.as_ref()).fold(0.0, |max, entry| max.max(entry.abs()))
}

/// `deviation / scale`, and 0 where both vanish.
fn relative(deviation: f64, scale: f64) -> f64 {
    if deviation == 0.0 { 0.0 } else { deviation / scale }
}

fn symmetry<R: AsRef<[f64]>>(subject: &str, matrix: &[R]) -> Check {
    let mut deviation = 0.0_f64;
    for (i, row) in matrix.iter().enumerate() {
        for (j, entry) in row.as_ref().iter().enumerate() {
            deviation = deviation.max((entry - matrix[j].as_ref()[i]).abs());
        }
    }
    Check::new(subject, relative(deviation, largest(matrix)), Limit::AtMost(SYMMETRY))
}

fn flattened(matrix: &Matrix3) -> [f64; 9] {
    std::array::from_fn(|k| matrix[k / 3][k % 3])
}

/// Γ_νμ = Γ_μν.
fn exchange<const K: usize>(subject: &str, blocks: &[Vec<[f64; K]>]) -> Check {
    let (mut deviation, mut scale) = (0.0_f64, 0.0_f64);
    for (mu, row) in blocks.iter().enumerate() {
        for (nu, block) in row.iter().enumerate() {
            for (entry, mirrored) in block.iter().zip(&blocks[nu][mu]) {
                deviation = deviation.max((entry - mirrored).abs());
                scale = scale.max(entry.abs());
            }
        }
    }
    Check::new(subject, relative(deviation, scale), Limit::AtMost(SYMMETRY))
}

/// T_νμ = T_μνᵀ.
fn mode_mode_symmetry(inertia: &Inertia) -> Check {
    let (mut deviation, mut scale) = (0.0_f64, 0.0_f64);
    for (mu, row) in inertia.mode_mode_moment.iter().enumerate() {
        for (nu, block) in row.iter().enumerate() {
            for i in 0..3 {
                for j in 0..3 {
                    let mirrored = inertia.mode_mode_moment[nu][mu][j][i];
                    deviation = deviation.max((block[i][j] - mirrored).abs());
                    scale = scale.max(block[i][j].abs());
                }
            }
        }
    }
    let subject = "deviation of T_νμ from the transpose of T_μν";
    Check::new(subject, relative(deviation, scale), Limit::AtMost(SYMMETRY))
}

/// The fields 1 and xⁱ. What T_μν is known of only in part cannot be compared with them.
const RIGID_FIELDS: usize = 4;

fn leading(mut matrix: Vec<Vec<f64>>, size: usize) -> Vec<Vec<f64>> {
    matrix.truncate(size);
    matrix.iter_mut().for_each(|row| row.truncate(size));
    matrix
}

/// Gram matrix of the fields 1, xⁱ, φ_μⁱ in the mass inner product. Shape: 4 + 3M square.
fn gram_matrix(inertia: &Inertia) -> Vec<Vec<f64>> {
    let size = 4 + 3 * inertia.mode_count();
    let mut gram = vec![vec![0.0; size]; size];
    let mut set = |row: usize, column: usize, value: f64| {
        gram[row][column] = value;
        gram[column][row] = value;
    };
    set(0, 0, inertia.mass);
    for i in 0..3 {
        set(0, 1 + i, inertia.first_moment[i]);
        for j in 0..3 {
            set(1 + i, 1 + j, inertia.second_moment[i][j]);
        }
        for mu in 0..inertia.mode_count() {
            set(0, 4 + 3 * mu + i, inertia.modal_first_moment[mu][i]);
            for j in 0..3 {
                set(1 + i, 4 + 3 * mu + j, inertia.position_mode_moment[mu][i][j]);
                for nu in 0..inertia.mode_count() {
                    set(4 + 3 * mu + i, 4 + 3 * nu + j, inertia.mode_mode_moment[mu][nu][i][j]);
                }
            }
        }
    }
    gram
}

/// The Gram matrix with position and each mode scaled to unit norm as vector fields.
///
/// Not component by component: what a mode has in a direction in which it does not move is round-off, and the
/// products of round-off need not satisfy anything.
fn scaled_gram_matrix(inertia: &Inertia) -> Vec<Vec<f64>> {
    let mut gram = gram_matrix(inertia);
    let norm = |first: usize, count: usize| (first..first + count).map(|k| gram[k][k]).sum::<f64>();
    let mut squares = vec![norm(0, 1)];
    for group in 0..=inertia.mode_count() {
        squares.extend([norm(1 + 3 * group, 3); 3]);
    }
    let scale: Vec<f64> =
        squares.into_iter().map(|square| if square > 0.0 { square.sqrt().recip() } else { 1.0 }).collect();
    for (row, left) in gram.iter_mut().zip(&scale) {
        for (entry, right) in row.iter_mut().zip(&scale) {
            *entry *= left * right;
        }
    }
    gram
}

/// Independence of the modes from rigid motion and from each other; names the modes at fault.
fn independent_modes(inertia: &Inertia) -> Check {
    match independence(inertia) {
        Independence::NoRotationalInertia => {
            let subject = "rotational inertia of the undeformed body about its least axis, relative";
            Check::new(subject, 0.0, Limit::Above(RIGID_PIVOT))
        }
        Independence::Measured(measured) => {
            let subject = "independence of the modes from rigid motion and from each other";
            let mut check = Check::new(subject, measured, Limit::AtLeast(INDEPENDENCE));
            if !check.passed() {
                check.subject = format!("{subject} (counted from 1, {})", dependent_modes(inertia));
            }
            check
        }
    }
}

fn definiteness(subject: &str, matrix: &[Vec<f64>]) -> Check {
    let smallest = smallest_eigenvalue(matrix.to_vec()).unwrap_or(0.0);
    Check::new(subject, relative(smallest, largest(matrix)), Limit::AtLeast(NEGATIVE_EIGENVALUE))
}

/// True if the name can stand in generated code: letters, digits and underscores, a letter first.
pub fn is_valid_marker_name(name: &str) -> bool {
    name.starts_with(|c: char| c.is_ascii_alphabetic())
        && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_')
}

/// Loads are at markers that the body has, once each.
fn loaded_markers(body: &ReducedBody, geometric: &GeometricStiffness) -> Option<Check> {
    let names: Vec<&str> = geometric.marker_loads.iter().map(|load| load.marker.as_str()).collect();
    let wrong = |i: usize| {
        names[..i].contains(&names[i]) || !body.markers.iter().any(|marker| marker.name == names[i])
    };
    let faulty: Vec<&str> = (0..names.len()).filter(|i| wrong(*i)).map(|i| names[i]).collect();
    let subject = "geometric stiffness of loads at what is no marker, or twice at one";
    let subject = if faulty.is_empty() { subject.to_owned() } else { format!("{subject} ({faulty:?})") };
    (!names.is_empty()).then(|| Check::new(subject, faulty.len() as f64, Limit::AtMost(0.0)))
}

/// One check on how many names are at fault, which names them.
fn marker_names(body: &ReducedBody) -> Vec<Check> {
    let stress = body.stress_markers.iter().map(|marker| marker.name.as_str());
    let others = stress.chain(body.section_markers.iter().map(|marker| marker.name.as_str()));
    let names: Vec<&str> = body.markers.iter().map(|marker| marker.name.as_str()).chain(others).collect();
    let invalid: Vec<&str> = names.iter().copied().filter(|name| !is_valid_marker_name(name)).collect();
    let repeated: Vec<&str> = names
        .iter()
        .enumerate()
        .filter(|(i, name)| names[..*i].contains(name))
        .map(|(_, name)| *name)
        .collect();
    let count = |subject: &str, faulty: &[&str]| {
        let subject = if faulty.is_empty() { subject.to_owned() } else { format!("{subject} ({faulty:?})") };
        Check::new(subject, faulty.len() as f64, Limit::AtMost(0.0))
    };
    vec![
        count("marker names other than letters, digits, underscores with a letter first", &invalid),
        count("repeated marker names", &repeated),
    ]
}
