//! Are the modes independent of rigid motion and of each other, and if not, which are to blame.

use std::fmt::Write;

use crate::eigenvalues::{eliminate, schur_complement, smallest_eigenvalue, to_unit_diagonal};
use crate::tolerances::{INDEPENDENCE, PARTICIPATION, RIGID_PIVOT};
use crate::{Inertia, ReducedBody};

/// Names of modes that a message lists; of more than these it says how many.
const LISTED: usize = 6;

/// How independent the modes of a body are.
pub(crate) enum Independence {
    /// The body has no rotational inertia about some axis, so there is no rigid motion to be independent of.
    NoRotationalInertia,
    /// Smallest eigenvalue of what elimination of the rigid motion leaves of Θ_ff at q = 0, over the modal masses.
    Measured(f64),
}

/// Measures the independence of the modes.
pub(crate) fn independence(inertia: &Inertia) -> Independence {
    match elastic_mass(inertia) {
        None => Independence::NoRotationalInertia,
        // A body without modes has nothing that could depend on rigid motion.
        Some((mass, _)) => Independence::Measured(smallest_eigenvalue(mass).unwrap_or(1.0)),
    }
}

impl ReducedBody {
    /// How independent the modes are: the least share of the kinetic energy of a combination of modes, at q = 0, that neither
    /// rigid motion nor other modes can express. The mass matrix has a condition number of about its reciprocal.
    ///
    /// 1 without modes; `None` if shapes contradict each other, or without rotational inertia about some axis, both of which
    /// [`check`](Self::check) refuses. Units: 1.
    pub fn independence_of_modes(&self) -> Option<f64> {
        self.check_shape().ok()?;
        match independence(&self.inertia) {
            Independence::NoRotationalInertia => None,
            Independence::Measured(share) => Some(share),
        }
    }
}

/// What elimination of the rigid motion leaves of Θ_ff at q = 0, each mode scaled to unit modal mass, and the scales.
///
/// Shape: M x M, symmetric. `None` if the body has no rotational inertia about some axis.
pub(crate) fn elastic_mass(inertia: &Inertia) -> Option<(Vec<Vec<f64>>, Vec<f64>)> {
    let (mass, scale) = to_unit_diagonal(undeformed_mass_matrix(inertia));
    let schur = schur_complement(mass, 6, RIGID_PIVOT)?;
    Some((schur, scale.into_iter().skip(6).collect()))
}

/// Which modes add nothing to rigid motion and the modes before them, in words; numbers from 1.
pub(crate) fn dependent_modes(inertia: &Inertia) -> String {
    let (mass, _) = to_unit_diagonal(undeformed_mass_matrix(inertia));
    let mut left = mass.clone();
    let mut kept: Vec<usize> = Vec::new();
    let mut dependent = Vec::new();
    let mut weakest = (f64::INFINITY, 6);
    for k in 0..mass.len() {
        if k >= 6 && left[k][k] < weakest.0 {
            weakest = (left[k][k], k);
        }
        // A mode of no mass at all comes here as well.
        if k >= 6 && (left[k][k].is_nan() || left[k][k] < INDEPENDENCE) {
            dependent.push((k, participants(&mass, &kept, k)));
        } else {
            eliminate(&mut left, k);
            kept.push(k);
        }
    }
    if dependent.is_empty() && weakest.1 < mass.len() {
        // Several modes together are nearly dependent: the one that is left the least is named.
        kept.retain(|k| *k < weakest.1);
        dependent.push((weakest.1, participants(&mass, &kept, weakest.1)));
    }
    let mut text = String::new();
    for (mode, others) in dependent.iter().take(LISTED) {
        let separator = if text.is_empty() { "" } else { "; " };
        let _ = write!(text, "{separator}mode {} {}", mode - 5, describe(others));
    }
    if dependent.len() > LISTED {
        let rest: Vec<usize> = dependent.iter().skip(LISTED).map(|(mode, _)| mode - 5).collect();
        let _ = write!(text, "; and {}", numbers(&rest));
    }
    text
}

/// The rows among `kept` whose combination gives row `k`: Cholesky-like elimination of the normal equations.
fn participants(mass: &[Vec<f64>], kept: &[usize], k: usize) -> Vec<usize> {
    // Rows (A | b) of the system A c = b in the mass metric.
    let mut system: Vec<Vec<f64>> = kept
        .iter()
        .map(|&row| kept.iter().map(|&column| mass[row][column]).chain([mass[row][k]]).collect())
        .collect();
    for pivot in 0..kept.len() {
        eliminate(&mut system, pivot);
    }
    let mut share = vec![0.0; kept.len()];
    for row in (0..kept.len()).rev() {
        let known: f64 = (row + 1..kept.len()).map(|column| system[row][column] * share[column]).sum();
        share[row] = (system[row][kept.len()] - known) / system[row][row];
    }
    kept.iter().zip(&share).filter(|(_, share)| share.abs() > PARTICIPATION).map(|(&row, _)| row).collect()
}

fn describe(others: &[usize]) -> String {
    let rigid = others.iter().any(|k| *k < 6);
    let modes: Vec<usize> = others.iter().filter(|k| **k >= 6).map(|k| k - 5).collect();
    match (rigid, modes.as_slice()) {
        (false, []) => "moves no mass".to_owned(),
        (true, []) => "is a rigid motion".to_owned(),
        (false, [one]) => format!("repeats mode {one}"),
        (false, _) => format!("is a combination of {}", numbers(&modes)),
        (true, _) => format!("is a combination of rigid motion and {}", numbers(&modes)),
    }
}

fn numbers(modes: &[usize]) -> String {
    let listed: Vec<String> = modes.iter().take(LISTED).map(usize::to_string).collect();
    let word = if modes.len() == 1 { "mode" } else { "modes" };
    match modes.len().checked_sub(LISTED) {
        None | Some(0) => format!("{word} {}", listed.join(", ")),
        Some(more) => format!("{word} {} and {more} more", listed.join(", ")),
    }
}

/// Mass matrix at q = 0. Shape: 6 + M square. Source: (203), body-resolved.
fn undeformed_mass_matrix(inertia: &Inertia) -> Vec<Vec<f64>> {
    let modal_mass = inertia.modal_mass();
    let count = inertia.mode_count();
    let mut matrix = vec![vec![0.0; 6 + count]; 6 + count];
    let mut set = |row: usize, column: usize, value: f64| {
        matrix[row][column] = value;
        matrix[column][row] = value;
    };
    let tensor = inertia.inertia_tensor();
    for i in 0..3 {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        set(i, i, inertia.mass);
        // -m ã: entry (i, j) is m a_k, entry (i, k) is -m a_j.
        set(i, 3 + j, inertia.first_moment[k]);
        set(i, 3 + k, -inertia.first_moment[j]);
        for column in 0..3 {
            set(3 + i, 3 + column, tensor[i][column]);
        }
    }
    for mu in 0..count {
        let coupling = inertia.rotation_coupling(mu);
        for i in 0..3 {
            set(i, 6 + mu, inertia.modal_first_moment[mu][i]);
            set(3 + i, 6 + mu, coupling[i]);
        }
        for nu in 0..count {
            set(6 + mu, 6 + nu, modal_mass[mu][nu]);
        }
    }
    matrix
}
