//! Emission: validated kernels as text.
//!
//! ```text
//! ValidKernel --listing--> sections, statements, trees --printer--> text
//! ```
//!
//! The listing knows no language; a printer does. The text is the one form: the tokens of the macro are the tokens of
//! that text, comments left out.

mod banner;
mod c;
mod documentation;
mod expression;
mod listing;
mod literal;
mod markers;
mod rust;
mod units;
mod writer;

pub use self::c::snake_case;
pub(crate) use self::c::{
    Files as CFiles, MechanismSubject as CMechanism, Names as CNames, kernel as c_kernel,
    mechanism as c_mechanism,
};
use ffrf_model::ReducedBody;

use crate::lanes::Lanes;
use crate::report::Report;
use crate::validate::ValidKernel;
use crate::{ArrayFunction, GenerateOptions};

/// A body that is to be printed, besides its kernels.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Subject<'a> {
    /// The model, if its numbers are baked in; else the invariants come at run time.
    pub(crate) model: Option<&'a ReducedBody>,
    /// What its loops over lanes need, if it has any.
    pub(crate) lanes: Option<&'a Lanes>,
    /// What the banner says.
    pub(crate) report: &'a Report,
    /// What the user wants.
    pub(crate) options: &'a GenerateOptions,
}

/// The whole text of a body in Rust.
pub(crate) fn rust(subject: &Subject<'_>, kernels: &[ValidKernel]) -> String {
    rust::body(subject, kernels)
}

/// A function on arrays in Rust; the results of its kernel are those of the function, then both sides of its conditions.
pub(crate) fn rust_array_function(
    function: &ArrayFunction,
    kernel: &ValidKernel,
    options: &GenerateOptions,
) -> String {
    rust::array_function(function, kernel, options)
}

/// Header and source of a body in C.
pub(crate) fn c(subject: &Subject<'_>, kernels: &[ValidKernel]) -> CFiles {
    c::files(subject, kernels)
}
