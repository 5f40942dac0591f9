//! What the user may choose when generating a body.

use ffrf_model::ModeSelection;

use crate::fidelity::Fidelity;

/// The scalar type of a generated body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ScalarType {
    /// Double precision.
    #[default]
    F64,
    /// Single precision: the constants are rounded once, from their double-precision values.
    F32,
    /// Every number type of nalgebra: f64, f32, dual numbers. The constants are kept in double precision.
    Generic,
}

impl ScalarType {
    /// Every type, the default first.
    pub const ALL: [Self; 3] = [Self::F64, Self::F32, Self::Generic];

    /// The type of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|scalar| scalar.name() == name)
    }

    /// The name by which the macro and the command line know the type.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
            Self::Generic => "generic",
        }
    }

    /// The Rust name of the type of values.
    pub(crate) fn type_name(self) -> &'static str {
        match self {
            Self::Generic => "T",
            plain => plain.name(),
        }
    }

    /// The Rust name of the type of constants.
    pub(crate) fn constant_type_name(self) -> &'static str {
        match self {
            Self::Generic => "f64",
            plain => plain.name(),
        }
    }

    /// What stands after the name of a function or after `impl`.
    pub(crate) fn generics(self) -> &'static str {
        match self {
            Self::Generic => "<T: support::Number>",
            _ => "",
        }
    }

    /// Size of a constant. Units: bytes.
    pub(crate) fn bytes(self) -> usize {
        match self {
            Self::F64 | Self::Generic => 8,
            Self::F32 => 4,
        }
    }

    /// Whether a constant is finite in this type.
    pub fn is_finite(self, value: f64) -> bool {
        match self {
            Self::F64 | Self::Generic => value.is_finite(),
            Self::F32 => (value as f32).is_finite(),
        }
    }
}

/// Whether products and sums are contracted, which rounds once instead of twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum FusedMultiplyAdd {
    /// Contracted where the target has the instruction; the last bits then depend on the target.
    #[default]
    Auto,
    /// Always contracted, in software if need be: the same bits on every target, slow without the instruction.
    On,
    /// Never contracted: the same bits on every target.
    Off,
}

impl FusedMultiplyAdd {
    /// Every choice, the default first.
    pub const ALL: [Self; 3] = [Self::Auto, Self::On, Self::Off];

    /// The choice of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|choice| choice.name() == name)
    }

    /// The name by which the macro and the command line know the choice.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::On => "on",
            Self::Off => "off",
        }
    }
}

/// The language of generated code.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Language {
    /// Rust, as the macro makes it.
    #[default]
    Rust,
    /// C99.
    C,
}

impl Language {
    /// Every language, the default first.
    pub const ALL: [Self; 2] = [Self::Rust, Self::C];

    /// The name by which the command line knows the language.
    pub fn name(self) -> &'static str {
        match self {
            Self::Rust => "rust",
            Self::C => "c",
        }
    }

    /// The language of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|language| language.name() == name)
    }
}

/// How the kernels with a product over all pairs of modes are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Strategy {
    /// Straight-line code for few modes, lanes for many; the change-over is measured.
    #[default]
    Auto,
    /// Statements only, whatever their number.
    StraightLine,
    /// Loops over lanes of modes; an error where that is impossible.
    Lanes,
}

impl Strategy {
    /// Every choice, the default first.
    pub const ALL: [Self; 3] = [Self::Auto, Self::StraightLine, Self::Lanes];

    /// The name by which the macro and the command line know the choice.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::StraightLine => "straight_line",
            Self::Lanes => "lanes",
        }
    }

    /// The choice of that name, if there is one.
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|strategy| strategy.name() == name)
    }
}

/// Everything that a generated body depends on, besides its model.
#[derive(Debug, Clone, PartialEq)]
pub struct GenerateOptions {
    /// Name of the struct.
    pub name: String,
    /// Its visibility as written before `struct`: `pub`, `pub(crate)` or empty.
    pub visibility: String,
    /// Attributes of the struct as written, doc comments included, one per entry.
    pub attributes: Vec<String>,
    /// File name of the model for the banner, without its folder.
    pub source_name: String,
    /// Which modes to use; all of them if `None`.
    pub modes: Option<ModeSelection>,
    /// Scalar type of all kernels.
    pub scalar: ScalarType,
    /// Which terms of the kinetic energy are kept.
    pub fidelity: Fidelity,
    /// Whether analytic Jacobians of the accelerations and of the residual are generated, too.
    pub jacobians: bool,
    /// Contraction of products and sums.
    pub fused_multiply_add: FusedMultiplyAdd,
    /// Straight-line code or lanes.
    pub strategy: Strategy,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    pub layout_tolerance: f64,
}

/// Default of [`GenerateOptions::layout_tolerance`].
///
/// Small enough that a number which a user's mode shapes really have is kept: of a deformed free-free body the
/// coupling Θ_rf can be a hundred-thousandth of its Gram scale, and must still be right to 1e-12 of itself.
/// What is zero by construction (b and ϑ of computed free-free modes) the reduction writes as zero.
pub const DEFAULT_LAYOUT_TOLERANCE: f64 = 1e-15;

/// Least tolerance for a centre of mass in the frame origin, when no mode moves it (all b_μ zero).
///
/// The lever m r̃ is then this noise alone, and its natural size is the mass times the size of the body.
pub const CENTRED_TOLERANCE: f64 = 1e-13;

/// Least tolerance for the orthogonality of modes: Θ_ff, K_ff and D_ff count as identity or diagonal up to this
/// deviation, relative to their own diagonal, against which their accuracy is measured.
pub const ORTHOGONALITY_TOLERANCE: f64 = 1e-13;

impl Default for GenerateOptions {
    fn default() -> Self {
        Self {
            name: "Body".to_owned(),
            visibility: "pub".to_owned(),
            attributes: Vec::new(),
            source_name: String::new(),
            modes: None,
            scalar: ScalarType::default(),
            fidelity: Fidelity::default(),
            jacobians: false,
            fused_multiply_add: FusedMultiplyAdd::default(),
            strategy: Strategy::default(),
            layout_tolerance: DEFAULT_LAYOUT_TOLERANCE,
        }
    }
}
