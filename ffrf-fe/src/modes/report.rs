//! The account of a mode computation: what was found and how well.

use std::fmt;

use ffrf_model::ModeKind;

/// One row of the mode table.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeEntry {
    /// Number from 1, in the order of the basis.
    pub number: usize,
    /// How the mode was made.
    pub kind: ModeKind,
    /// Natural frequency, or that of the Rayleigh quotient φᵀKφ / φᵀMφ for a shape of the user.
    /// Units: Hz. `None` without a stiffness matrix.
    pub frequency_hz: Option<f64>,
    /// ||K φ - λ M φ|| / ||K φ||. `None` without a stiffness matrix.
    pub residual: Option<f64>,
    /// Effective mass (φᵀ M e_i)² / φᵀMφ along x, y, z. Units: kg.
    pub effective_mass: [f64; 3],
    /// Effective moment of inertia (φᵀ M (e_i × x))² / φᵀMφ about the frame axes. Units: kg m².
    pub effective_inertia: [f64; 3],
}

/// One rigid-body mode that the supports leave.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct RigidModeEntry {
    /// Frequency of its Rayleigh quotient, ideally zero. Units: Hz.
    pub frequency_hz: f64,
    /// ||K r|| / || |K| |r| ||, ideally round-off.
    pub residual: f64,
}

/// The account of a mode computation. `Display` prints the mode table.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeReport {
    /// How the modes were found, in words.
    pub method: String,
    /// One entry per mode.
    pub modes: Vec<ModeEntry>,
    /// The rigid-body modes found and removed. Empty for shapes of the user.
    pub rigid_modes: Vec<RigidModeEntry>,
    /// Modes with zero frequency that are not rigid motion: the part is a mechanism. They are kept.
    pub mechanisms: usize,
    /// Largest entry of |ΦᵀMΦ - I|; for shapes of the user after scaling to unit modal mass.
    pub orthogonality_error: f64,
    /// Number of eigenvalues below [`Self::counted_below_hz`] by the signs of LDLᵀ pivots; `None` if not counted.
    pub counted: Option<usize>,
    /// Number of eigenvalues found below the same limit, rigid-body modes included.
    pub found: usize,
    /// The limit of the count. Units: Hz.
    pub counted_below_hz: Option<f64>,
    /// True if the last mode belongs to a repeated eigenvalue of which not all modes were asked for.
    pub cut_repeated: bool,
    /// Mass of the part. Units: kg.
    pub total_mass: f64,
    /// Moments of inertia about the frame axes. Units: kg m².
    pub total_inertia: [f64; 3],
    /// Degrees of freedom without mass and stiffness, which stay at rest.
    pub loose_dofs: usize,
    /// Values in the sparse factor; 0 for the dense method.
    pub factor_values: usize,
}

impl fmt::Display for ModeReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.method)?;
        if !self.rigid_modes.is_empty() {
            let frequency = self.rigid_modes.iter().fold(0.0_f64, |max, mode| max.max(mode.frequency_hz));
            let residual = self.rigid_modes.iter().fold(0.0_f64, |max, mode| max.max(mode.residual));
            writeln!(
                f,
                "{} rigid-body modes removed (frequency up to {frequency:.1e} Hz, residual up to {residual:.1e})",
                self.rigid_modes.len()
            )?;
        }
        writeln!(
            f,
            "{:>4}  {:<9} {:>14} {:>9}  {:>23}  {:>23}",
            "mode", "kind", "frequency/Hz", "residual", "effective mass x y z/%", "inertia x y z/%"
        )?;
        for mode in &self.modes {
            write!(f, "{:>4}  {:<9}", mode.number, kind_name(mode.kind))?;
            match mode.frequency_hz {
                Some(frequency) => write!(f, " {frequency:>14.6}")?,
                None => write!(f, " {:>14}", "-")?,
            }
            match mode.residual {
                Some(residual) => write!(f, " {residual:>9.1e} ")?,
                None => write!(f, " {:>9} ", "-")?,
            }
            for value in mode.effective_mass {
                write!(f, " {:>7.3}", percent(value, self.total_mass))?;
            }
            write!(f, " ")?;
            for (value, total) in mode.effective_inertia.into_iter().zip(self.total_inertia) {
                write!(f, " {:>7.3}", percent(value, total))?;
            }
            writeln!(f)?;
        }
        write!(f, " sum  {:<9} {:>14} {:>9} ", "", "", "")?;
        for (i, total) in [self.total_mass; 3].into_iter().enumerate() {
            write!(
                f,
                " {:>7.3}",
                percent(self.modes.iter().map(|mode| mode.effective_mass[i]).sum(), total)
            )?;
        }
        write!(f, " ")?;
        for (i, total) in self.total_inertia.into_iter().enumerate() {
            write!(
                f,
                " {:>7.3}",
                percent(self.modes.iter().map(|mode| mode.effective_inertia[i]).sum(), total)
            )?;
        }
        writeln!(f)?;
        write!(f, "mass orthogonality error {:.1e}", self.orthogonality_error)?;
        if let (Some(counted), Some(limit)) = (self.counted, self.counted_below_hz) {
            write!(f, "; {counted} eigenvalues below {limit:.6} Hz by Sturm count, {} found", self.found)?;
        }
        if self.mechanisms > 0 {
            write!(
                f,
                "\nnote: {} modes have zero frequency but are no rigid motion (mechanism)",
                self.mechanisms
            )?;
        }
        if self.cut_repeated {
            write!(
                f,
                "\nnote: the last mode belongs to a repeated frequency; ask for more modes to have all of it"
            )?;
        }
        if self.loose_dofs > 0 {
            write!(
                f,
                "\nnote: {} degrees of freedom have neither mass nor stiffness and stay at rest",
                self.loose_dofs
            )?;
        }
        Ok(())
    }
}

fn percent(part: f64, whole: f64) -> f64 {
    if whole > 0.0 { 100.0 * part / whole } else { 0.0 }
}

fn kind_name(kind: ModeKind) -> &'static str {
    match kind {
        ModeKind::FreeFree => "free-free",
        ModeKind::Clamped => "clamped",
        ModeKind::User => "user",
        _ => "other",
    }
}
