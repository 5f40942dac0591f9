//! The account of a component basis.

use std::fmt;

use ffrf_model::{Mode, ModeKind};

use super::BasisForm;
use super::frequency::hertz;

/// One mode of the basis.
#[derive(Debug, Clone, PartialEq)]
pub struct ComponentEntry {
    /// Number from 1, in the order of the basis.
    pub number: usize,
    /// How the mode was made.
    pub kind: ModeKind,
    /// Natural frequency, if the mode is an eigenmode. Units: Hz.
    pub frequency_hz: Option<f64>,
    /// Largest share that the mode has of the static compliance of any interface motion; transformed modes only.
    pub importance: Option<f64>,
}

/// One normal mode that entered the basis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NormalEntry {
    /// Natural frequency. Units: Hz.
    pub frequency_hz: f64,
    /// For clamped modes: largest share of the mass that any interface motion accelerates.
    pub effective_mass: Option<f64>,
}

impl NormalEntry {
    pub(crate) fn list(values: &[f64], effective: Option<&[f64]>) -> Vec<Self> {
        let entry = |(k, &value): (usize, &f64)| Self {
            frequency_hz: hertz(value),
            effective_mass: effective.map(|shares| shares[k]),
        };
        values.iter().enumerate().map(entry).collect()
    }
}

/// The account of a component basis. `Display` prints it.
#[derive(Debug, Clone, PartialEq)]
pub struct ComponentReport {
    /// How the basis was made, in words.
    pub method: String,
    /// The interfaces, in words.
    pub interfaces: Vec<String>,
    /// Rigid motions that the export's boundary conditions leave.
    pub rigid_modes: usize,
    /// The normal modes that entered the basis.
    pub normal: Vec<NormalEntry>,
    /// Shapes that held nothing but rigid motion and what other shapes hold.
    pub removed: usize,
    /// Modes that the selection left out.
    pub left_out: usize,
    /// Static elastic compliance of each interface motion in the full model, the diagonal of B G_e Bᵀ.
    /// Units: m/N for translations, rad/(N m) for rotations.
    pub compliance: Vec<f64>,
    /// Least part of the static elastic compliance of any interface motion that the basis holds.
    pub compliance_kept: f64,
    /// Largest entry of |ΦᵀMΦ - I|.
    pub orthogonality_error: f64,
    /// Largest |φ_iᵀKφ_j| over ω_i ω_j of two transformed modes, which K_ff leaves out as round-off.
    pub stiffness_coupling: f64,
    /// One entry per mode.
    pub modes: Vec<ComponentEntry>,
    /// True for orthonormal modes.
    pub is_transformed: bool,
}

impl fmt::Display for ComponentReport {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(f, "{}", self.method)?;
        for interface in &self.interfaces {
            writeln!(f, "interface {interface}")?;
        }
        if !self.normal.is_empty() {
            writeln!(f, "normal modes that entered: Hz (effective interface mass/%)")?;
        }
        for entries in self.normal.chunks(5) {
            for entry in entries {
                write!(f, " {:>12.3}", entry.frequency_hz)?;
                if let Some(share) = entry.effective_mass {
                    write!(f, " ({:>6.2})", 100.0 * share)?;
                }
            }
            writeln!(f)?;
        }
        writeln!(f, "mode  kind       frequency/Hz  share of static interface compliance/%")?;
        for mode in &self.modes {
            write!(f, "{:>4}  {:<10}", mode.number, kind_name(mode.kind))?;
            match mode.frequency_hz {
                Some(frequency) => write!(f, " {frequency:>12.3}")?,
                None => write!(f, " {:>12}", "-")?,
            }
            match mode.importance {
                Some(share) => writeln!(f, "  {:>8.3}", 100.0 * share)?,
                None => writeln!(f, "  {:>8}", "-")?,
            }
        }
        write!(
            f,
            "{} shapes removed (rigid motion: {}, or dependent); {} modes not selected; static interface compliance \
             held: {:.6} %",
            self.removed,
            self.rigid_modes,
            self.left_out,
            100.0 * self.compliance_kept
        )?;
        if self.is_transformed {
            write!(
                f,
                "; mass orthogonality error {:.1e}, coupling by stiffness {:.1e}",
                self.orthogonality_error, self.stiffness_coupling
            )?;
        }
        Ok(())
    }
}

pub(crate) fn entries(
    modes: &[Mode],
    importance: &[f64],
    chosen: &[usize],
    form: BasisForm,
) -> Vec<ComponentEntry> {
    let share = |k: usize| match form {
        BasisForm::FreeFree => Some(importance[chosen[k]]),
        BasisForm::Raw => None,
    };
    let entry = |(k, mode): (usize, &Mode)| ComponentEntry {
        number: k + 1,
        kind: mode.kind,
        frequency_hz: mode.frequency_hz,
        importance: share(k),
    };
    modes.iter().enumerate().map(entry).collect()
}

fn kind_name(kind: ModeKind) -> &'static str {
    match kind {
        ModeKind::FreeFree => "free-free",
        ModeKind::Clamped => "clamped",
        ModeKind::Constraint => "constraint",
        ModeKind::Attachment => "attachment",
        ModeKind::Component => "component",
        ModeKind::User => "user",
        _ => "other",
    }
}
