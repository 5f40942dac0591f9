//! From a reduced flexible body to kernels in Rust or C.
//!
//! ```text
//! ReducedBody --layout--> BodyExpressions --formulate--> Kernel --passes--> Kernel
//!             --validate--> ValidKernel --listing--> sections, statements, trees --printer--> text and tokens
//! ```
//!
//! Two tables hold what there is: [`invariants`] those of a body, [`formulate::KERNELS`] what is computed from them.
//!
//! Functions on arrays, as the accelerations of a whole mechanism, come as graphs: [`array_function`].
//!
//! One generator, three doors: the macro `ffrf::flexible_body!`, the command `ffrf generate`, and a build script
//! that calls [`generate`] and writes [`GeneratedCode::text`] to a file. A pure library: no files, no environment.
#![forbid(unsafe_code)]

pub mod array_function;
pub mod body;
pub mod derive;
pub mod expression;
pub mod fidelity;
pub mod formulate;
pub mod invariants;
pub mod lanes;
pub mod layout;
pub mod mechanism;
pub mod polynomial;

mod counts;
mod emit;
mod error;
mod generate;
mod generate_array_function;
mod generate_mechanism;
mod interpreted;
mod options;
pub mod passes;
mod prepare;
mod report;
mod validate;

pub use array_function::{ArrayFunction, ArrayInput, Call, Condition, Function, InputForm, Relation};
pub use counts::OperationCounts;
pub use emit::snake_case;
pub use error::CodegenError;
pub use fidelity::Fidelity;
pub use generate::{GeneratedC, GeneratedCode, generate, generate_c, generate_with_layout};
pub use generate_array_function::{GeneratedArrayFunction, generate_array_function};
pub use generate_mechanism::{GeneratedMechanismC, generate_mechanism_c};
pub use interpreted::{KernelInput, Kernels};
pub use options::{
    DEFAULT_LAYOUT_TOLERANCE, FusedMultiplyAdd, GenerateOptions, Language, ScalarType, Strategy,
};
pub use report::{KernelReport, Report, Source};
