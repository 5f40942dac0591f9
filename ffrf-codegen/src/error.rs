//! What can go wrong between a model and its code.

use ffrf_model::ModelError;

use crate::fidelity::FidelityError;
use crate::mechanism::TopologyError;

/// Why no code was generated.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum CodegenError {
    /// The body's lists do not fit together, a number is not finite, the checks of the body fail, or there are too few
    /// modes.
    #[error(transparent)]
    Model(#[from] ModelError),
    /// The body lacks a term of the fidelity.
    #[error(transparent)]
    Fidelity(#[from] FidelityError),
    /// The layout tolerance must be a small relative number.
    #[error("layout tolerance must be at least 0 and below 1, found {found}")]
    LayoutTolerance {
        /// The value given.
        found: f64,
    },
    /// An invariant was declared with a structure that it cannot have.
    #[error("{invariant} cannot be {found}, expected one of: {expected}")]
    Structure {
        /// Name of the invariant.
        invariant: &'static str,
        /// The structure declared.
        found: &'static str,
        /// The structures that make sense.
        expected: String,
    },
    /// Two declarations of a layout cannot both be true of a body.
    #[error("{invariant} cannot be {found} here: {reason}")]
    Contradiction {
        /// Name of the invariant.
        invariant: &'static str,
        /// The structure declared.
        found: &'static str,
        /// What it contradicts, and what to do.
        reason: &'static str,
    },
    /// A layout names an invariant that there is not.
    #[error("unknown invariant `{found}`, expected one of: {expected}")]
    UnknownInvariant {
        /// The name given.
        found: String,
        /// The known names.
        expected: String,
    },
    /// The text of a layout cannot be read.
    #[error("`{found}`: {reason}")]
    LayoutText {
        /// The part that cannot be read.
        found: String,
        /// What is expected there.
        reason: String,
    },
    /// The name does not stand for a type.
    #[error("`{found}` is not a name for a type")]
    Name {
        /// The name given.
        found: String,
    },
    /// Lanes were demanded where they cannot be had.
    #[error("strategy lanes: {reason}")]
    NoLanes {
        /// What stands in the way.
        reason: &'static str,
    },
    /// An option that C has no equal of.
    #[error("{option} {found} cannot be had in C: expected {expected}")]
    NotInC {
        /// The option.
        option: &'static str,
        /// Its value.
        found: &'static str,
        /// What can be had.
        expected: &'static str,
    },
    /// A scalar type that functions on arrays do not have.
    #[error("scalar {found} cannot be had of a function on arrays: expected {expected}")]
    NotInArrays {
        /// The scalar type.
        found: &'static str,
        /// What can be had.
        expected: &'static str,
    },
    /// A mechanism cannot be composed.
    #[error(transparent)]
    Topology(#[from] TopologyError),
    /// Two names are the same in C.
    #[error(
        "`{found}` and `{other}` are both called `{name}` in C: expected names that differ in letters or digits"
    )]
    SameNameInC {
        /// The second name.
        found: String,
        /// The first.
        other: String,
        /// What both become.
        name: String,
    },
    /// The mass left after eliminating the modes is not positive: the modes contain rigid-body motion.
    #[error(
        "the modes are not independent of rigid-body motion: pivot {pivot} of the reduced mass is {found:e}, expected > 0"
    )]
    DependentModes {
        /// Which pivot of the elimination.
        pivot: usize,
        /// Its value.
        found: f64,
    },
    /// Θ_ff is not positive definite: a mode repeats those before it.
    #[error(
        "the modes are not independent of each other: the mass of mode {mode} that the modes before it leave is {found:e}, expected more than {expected:e}"
    )]
    RepeatedModes {
        /// Which pivot of the factorisation, from 0.
        mode: usize,
        /// Its value.
        found: f64,
        /// What is round-off.
        expected: f64,
    },
    /// A number of the body is too large for the scalar type.
    #[error(
        "{field}: {found:e} is not finite in {scalar}: use f64, or units in which the numbers are smaller"
    )]
    TooLarge {
        /// Full path of the field.
        field: String,
        /// The number.
        found: f64,
        /// Name of the scalar type.
        scalar: &'static str,
    },
    /// The modes depend on rigid motion or on each other more than the digits of the scalar type can tell.
    #[error(
        "independence of the modes from rigid motion and from each other: {found:.3e}, must be at least {expected:.1e} in {scalar}: use f64, or other modes"
    )]
    TooDependent {
        /// The share of the kinetic energy of some combination of modes that nothing else expresses.
        found: f64,
        /// The least share.
        expected: f64,
        /// Name of the scalar type.
        scalar: &'static str,
    },
    /// A constant of a kernel is not finite.
    #[error(
        "{kernel}: node {node} is the constant {found:e}, expected a number that is finite in the scalar type of the body"
    )]
    NotFinite {
        /// Name of the kernel.
        kernel: &'static str,
        /// Index of the node.
        node: usize,
        /// Its value.
        found: f64,
    },
    /// A kernel uses an input that it does not have.
    #[error("{kernel}: {symbol} is not an input of this kernel")]
    UndefinedSymbol {
        /// Name of the kernel.
        kernel: &'static str,
        /// Name of the symbol.
        symbol: String,
    },
    /// A node refers to a later node, or to none.
    #[error("{kernel}: node {node} refers to node {operand}, expected an earlier one")]
    ForwardReference {
        /// Name of the kernel.
        kernel: &'static str,
        /// Index of the node.
        node: usize,
        /// Index of its operand.
        operand: usize,
    },
    /// A kernel has the wrong number of results.
    #[error("{kernel}: {found} results, expected {expected}")]
    OutputCount {
        /// Name of the kernel.
        kernel: &'static str,
        /// Number of results that the formulation made.
        found: usize,
        /// Number of results that the signature needs.
        expected: usize,
    },
    /// The text is not a sequence of Rust tokens: a defect of the emitter.
    #[error("the generated text is not valid Rust: {message}")]
    Tokens {
        /// What the lexer says.
        message: String,
    },
}
