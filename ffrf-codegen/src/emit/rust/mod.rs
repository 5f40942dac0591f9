//! The Rust printer: listings and tables as the text of a body.
//!
//! ```text
//! struct NAME; impl NAME { constants }         structure, markers   (invariants baked in)
//! struct NAME { fields } impl NAME { check }   parameters, check    (invariants at run time)
//! const _: () = { functions; impl traits };    function, in_place, lanes, implementation
//! ```

mod array_function;
mod check;
mod found_registers;
mod function;
mod implementation;
mod in_place;
mod lanes;
mod markers;
mod method;
mod notation;
mod parameters;
mod structure;

pub(super) use self::array_function::array_function;
use self::function::function;
use super::expression::expression;
use super::units::UnitNames;
use super::writer::Writer;
use super::{Subject, banner, listing};
use crate::layout::Layout;
use crate::validate::ValidKernel;
use crate::{FusedMultiplyAdd, GenerateOptions, ScalarType};

/// What the functions of one body have in common.
#[derive(Debug, Clone, Copy)]
struct Style<'a> {
    /// Scalar type of all values.
    scalar: ScalarType,
    /// The struct, if its fields are inputs of the functions.
    parameters: Option<Parameters<'a>>,
}

/// A struct whose fields are invariants.
#[derive(Debug, Clone, Copy)]
struct Parameters<'a> {
    name: &'a str,
    layout: &'a Layout,
}

/// The whole text of a body.
pub(super) fn body(subject: &Subject<'_>, kernels: &[ValidKernel]) -> String {
    let Subject { model, report, options, .. } = subject;
    let mut writer = Writer::new(UnitNames::of(*model));
    for line in banner::banner(options, report, model.map(|model| model.units.as_str())) {
        writer.line(format!("// {line}"));
    }
    writer.blank();
    match model {
        Some(model) => {
            structure::unit_struct(&mut writer, model, report, options);
            writer.blank();
            markers::inherent_constants(&mut writer, model, report, options);
        }
        None => {
            parameters::parameter_struct(&mut writer, report.mode_count, &report.layout, options);
            writer.blank();
            check::inherent_method(&mut writer, report.mode_count, &report.layout, options);
        }
    }
    writer.blank();
    scope(&mut writer, subject, kernels);
    writer.finish()
}

/// Functions and trait implementation in a scope of their own, so that no name can clash.
fn scope(writer: &mut Writer, subject: &Subject<'_>, kernels: &[ValidKernel]) {
    let Subject { model, lanes, report, options } = subject;
    let parameters = match model {
        Some(_) => None,
        None => Some(Parameters { name: &options.name, layout: &report.layout }),
    };
    let style = Style { scalar: options.scalar, parameters };
    let width = |tree: &listing::Tree| expression(tree, &style).chars().count();
    let listings: Vec<_> = kernels.iter().map(|kernel| listing::listing(kernel, width)).collect();
    writer.line(ALLOWED);
    writer.block("const _: () = {", "};", |writer| {
        writer.line("use ::ffrf::generated_support as support;");
        let needs: Vec<_> = listings.iter().map(listing::Listing::needs).collect();
        if needs.iter().any(|needs| needs.multiply_add) {
            writer.line(import(multiply_add(options), "fma", options.scalar));
        }
        if needs.iter().any(|needs| needs.square_root) {
            writer.line(import("square_root", "square_root", options.scalar));
        }
        for listing in &listings {
            writer.blank();
            if in_place::is_in_place(&listing.signature) {
                in_place::function(writer, listing, style);
            } else {
                function(writer, listing, style);
            }
        }
        if let Some(lanes) = lanes {
            writer.blank();
            lanes::functions(writer, lanes, options);
        }
        writer.blank();
        implementation::implementations(writer, subject, &listings);
    });
}

/// The function of the runtime for a b + c.
fn multiply_add(options: &GenerateOptions) -> &'static str {
    match options.fused_multiply_add {
        FusedMultiplyAdd::On => "always_fused_multiply_add",
        FusedMultiplyAdd::Auto | FusedMultiplyAdd::Off => "fused_multiply_add",
    }
}

/// The line that brings a function of the runtime for `scalar` into scope.
fn import(function: &str, name: &str, scalar: ScalarType) -> String {
    let suffix = match scalar {
        ScalarType::F64 => "",
        ScalarType::F32 => "_f32",
        ScalarType::Generic => "_of",
    };
    let path = format!("::ffrf::generated_support::{function}{suffix}");
    if format!("{function}{suffix}") == name {
        format!("use {path};")
    } else {
        format!("use {path} as {name};")
    }
}

/// The user's lints are for the user's code.
const ALLOWED: &str = "#[allow(
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    unused_imports,
    unused_qualifications,
    unused_variables
)]";
