//! Emission: validated kernels as Rust text.
//!
//! The text is the one form: the tokens of the macro are the tokens of that text, comments left out.

mod banner;
mod check;
mod documentation;
mod expression_text;
mod function;
mod implementation;
mod literal;
mod markers;
mod names;
mod parameters;
mod structure;

pub(crate) use self::literal::literal;

use ffrf_model::ReducedBody;

use self::function::{FunctionStyle, function};
use crate::GenerateOptions;
use crate::lanes::{self, LaneParameters, LaneTables};
use crate::layout::Layout;
use crate::report::Report;
use crate::validate::ValidKernel;

/// The whole text of a body whose numbers are baked in.
pub(crate) fn baked_body(
    body: &ReducedBody,
    kernels: &[ValidKernel],
    lanes: Option<&LaneTables>,
    report: &Report,
    options: &GenerateOptions,
) -> String {
    let mut text = head(report, options);
    text.push_str(&structure::unit_struct(body, report, options));
    text.push('\n');
    text.push_str(&markers::inherent_constants(body, report, options));
    text.push('\n');
    let mut methods = lanes.map_or_else(String::new, |lanes| lanes::trait_method(lanes, options.scalar));
    methods.push_str(&markers::trait_methods(body, options));
    let modes = report.mode_count;
    let loops =
        lanes.map(|lanes| lanes::functions(lanes, options.scalar, |kind| documentation::of(kind, modes)));
    text.push_str(&kernels_block(kernels, loops, options, None, &methods));
    text
}

/// The whole text of a body whose invariants are supplied at run time.
pub(crate) fn parameter_body(
    kernels: &[ValidKernel],
    lanes: Option<&LaneParameters>,
    report: &Report,
    options: &GenerateOptions,
) -> String {
    let mut text = head(report, options);
    text.push_str(&parameters::parameter_struct(report.mode_count, &report.layout, options));
    text.push('\n');
    text.push_str(&check::inherent_method(report.mode_count, &report.layout, options));
    text.push('\n');
    let loops =
        lanes.map(|lanes| lanes.functions(options, |kind| documentation::of(kind, report.mode_count)));
    text.push_str(&kernels_block(kernels, loops, options, Some((&options.name, &report.layout)), ""));
    text
}

fn head(report: &Report, options: &GenerateOptions) -> String {
    let mut text = String::new();
    for line in banner::banner(options, report) {
        text.push_str(format!("// {line}").trim_end());
        text.push('\n');
    }
    text.push('\n');
    text
}

/// Functions and trait implementation in a scope of their own, so that no name can clash.
fn kernels_block(
    kernels: &[ValidKernel],
    loops: Option<String>,
    options: &GenerateOptions,
    parameters: Option<(&str, &Layout)>,
    extra_methods: &str,
) -> String {
    let style = FunctionStyle { scalar: options.scalar, parameters };
    let functions: Vec<String> = kernels.iter().map(|kernel| function(kernel, style, "    ")).collect();
    let mut functions = functions.join("\n");
    if let Some(loops) = loops {
        functions.push('\n');
        functions.push_str(&loops);
    }
    let mode_count = kernels.first().map_or(0, |kernel| kernel.kernel().mode_count);
    let mut text = String::from(ALLOWED);
    text.push_str("const _: () = {\n");
    text.push_str("    use ::ffrf::generated_support as support;\n");
    for (call, import) in implementation::imports(options) {
        if functions.contains(&call) {
            text.push_str(&format!("    {import}\n"));
        }
    }
    text.push('\n');
    text.push_str(&functions);
    text.push('\n');
    text.push_str(&implementation::implementation(options, mode_count, parameters.is_some(), extra_methods));
    text.push_str("};\n");
    text
}

/// The user's lints are for the user's code.
const ALLOWED: &str = "#[allow(
    clippy::all,
    clippy::pedantic,
    clippy::nursery,
    unused_imports,
    unused_qualifications,
    unused_variables
)]
";
