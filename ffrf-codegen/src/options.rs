//! What the user may choose when generating a body.

use crate::fidelity::Fidelity;

/// The scalar type of a generated body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum ScalarType {
    /// Double precision.
    #[default]
    F64,
    /// Single precision: the constants are rounded once, from their double-precision values.
    F32,
}

impl ScalarType {
    /// The Rust name of the type.
    pub fn name(self) -> &'static str {
        match self {
            Self::F64 => "f64",
            Self::F32 => "f32",
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
    /// The name by which the macro and the command line know the choice.
    pub fn name(self) -> &'static str {
        match self {
            Self::Auto => "auto",
            Self::On => "on",
            Self::Off => "off",
        }
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
    /// How many modes to use; all of them if `None`.
    pub modes: Option<usize>,
    /// Scalar type of all kernels.
    pub scalar: ScalarType,
    /// Which terms of the kinetic energy are kept.
    pub fidelity: Fidelity,
    /// Whether analytic Jacobians of the accelerations and of the residual are generated, too.
    pub jacobians: bool,
    /// Contraction of products and sums.
    pub fused_multiply_add: FusedMultiplyAdd,
    /// Below which size, relative to its Gram scale, an entry of an invariant counts as zero.
    pub layout_tolerance: f64,
}

/// Default of [`GenerateOptions::layout_tolerance`]: round-off of sums over some thousand nodes stays below it,
/// and zeroing what is smaller changes no kernel by more than the accuracy that the reference cases ask for (1e-12).
pub const DEFAULT_LAYOUT_TOLERANCE: f64 = 1e-13;

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
            layout_tolerance: DEFAULT_LAYOUT_TOLERANCE,
        }
    }
}
