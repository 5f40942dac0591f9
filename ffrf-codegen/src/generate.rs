//! The generator: a body in, Rust out. The macro, build scripts and the command line all come through here.

use ffrf_model::ReducedBody;
use proc_macro2::TokenStream;

use crate::body::BodyExpressions;
use crate::counts::OperationCounts;
use crate::emit;
use crate::expression::Graph;
use crate::formulate::{Kernel, KernelKind};
use crate::lanes;
use crate::layout::{Layout, found};
use crate::passes;
use crate::report::{KernelReport, Report, Source};
use crate::validate::ValidKernel;
use crate::{CodegenError, GenerateOptions, ScalarType};

/// A generated body.
#[derive(Debug, Clone)]
pub struct GeneratedCode {
    /// The code as readable text, with comments and counts.
    pub text: String,
    /// The tokens of that text.
    pub tokens: TokenStream,
    /// Layout found and cost of each kernel.
    pub report: Report,
}

/// Generates the code of a body whose numbers are baked in.
///
/// The same body and options give the same text, to the byte. Errors: see [`CodegenError`]. Panics: never.
pub fn generate(body: &ReducedBody, options: &GenerateOptions) -> Result<GeneratedCode, CodegenError> {
    let source = Source::of(body)?;
    let body = prepare(body, options)?;
    let mut graph = Graph::new();
    let expressions = BodyExpressions::baked(&mut graph, &body, options.layout_tolerance)
        .truncated(&mut graph, &options.fidelity);
    let lanes = lanes::choose(&mut graph, &expressions, options)?;
    let looped: &[KernelKind] = if lanes.is_some() { &lanes::IN_LANES } else { &[] };
    let kernels = kernels(&graph, &expressions, options, false, looped)?;
    let layout = found(&body, options.layout_tolerance);
    let mut report = report(body.mode_count(), Some(source), layout, &kernels);
    report.lanes = lanes.as_ref().map(|lanes| lanes.description(options.scalar));
    let text = emit::baked_body(&body, &kernels, lanes.as_ref(), &report, options);
    finish(text, report)
}

/// Generates the code of a body whose invariants are supplied at run time, as far as `layout` leaves them open.
///
/// Errors: [`CodegenError::Structure`], [`CodegenError::Contradiction`], [`CodegenError::Name`],
/// [`CodegenError::NoLanes`]. Panics: never.
pub fn generate_with_layout(
    mode_count: usize,
    layout: &Layout,
    options: &GenerateOptions,
) -> Result<GeneratedCode, CodegenError> {
    layout.check_body(mode_count, &options.fidelity)?;
    check_name(&options.name)?;
    let mut graph = Graph::new();
    let expressions =
        BodyExpressions::symbolic(&mut graph, mode_count, layout).truncated(&mut graph, &options.fidelity);
    let lanes = lanes::choose_parameters(mode_count, layout, options)?;
    let looped: &[KernelKind] = if lanes.is_some() { &lanes::IN_LANES } else { &[] };
    let kernels = kernels(&graph, &expressions, options, true, looped)?;
    let mut report = report(mode_count, None, *layout, &kernels);
    report.lanes = lanes.as_ref().map(lanes::LaneParameters::description);
    let text = emit::parameter_body(&kernels, lanes.as_ref(), &report, options);
    finish(text, report)
}

/// Every kernel that the options want but those `looped` over lanes, through all passes and the validator.
fn kernels(
    graph: &Graph,
    expressions: &BodyExpressions,
    options: &GenerateOptions,
    has_parameters: bool,
    looped: &[KernelKind],
) -> Result<Vec<ValidKernel>, CodegenError> {
    let requested: &[KernelKind] = if options.jacobians { &KernelKind::JACOBIANS } else { &[] };
    KernelKind::ALL
        .iter()
        .chain(requested)
        .filter(|kind| !looped.contains(kind))
        .map(|&kind| {
            let kernel = Kernel::formulate(kind, graph.clone(), expressions)?;
            ValidKernel::new(passes::run(kernel, options.fused_multiply_add), options.scalar, has_parameters)
        })
        .collect()
}

fn report(mode_count: usize, source: Option<Source>, layout: Layout, kernels: &[ValidKernel]) -> Report {
    let kernels = kernels
        .iter()
        .map(|kernel| KernelReport {
            name: kernel.kernel().kind.name(),
            counts: OperationCounts::of(kernel.kernel()),
        })
        .collect();
    Report { mode_count, source, layout, lanes: None, kernels }
}

fn finish(text: String, report: Report) -> Result<GeneratedCode, CodegenError> {
    let tokens = text
        .parse()
        .map_err(|error: proc_macro2::LexError| CodegenError::Tokens { message: error.to_string() })?;
    Ok(GeneratedCode { text, tokens, report })
}

/// The body with the modes that the options want; checks both.
pub(crate) fn prepare(body: &ReducedBody, options: &GenerateOptions) -> Result<ReducedBody, CodegenError> {
    let tolerance = options.layout_tolerance;
    if !(0.0..1.0).contains(&tolerance) {
        return Err(CodegenError::LayoutTolerance { found: tolerance });
    }
    check_name(&options.name)?;
    let body = match &options.modes {
        Some(selection) => body.with_selected_modes(selection)?,
        None => body.clone(),
    };
    // What was read from a file has been checked; what was built by hand, and what a selection leaves, has not.
    body.check()?.verdict()?;
    check_numbers(&body, options.scalar)?;
    Ok(body)
}

/// Every number of the body is finite in the scalar type of its constants.
fn check_numbers(body: &ReducedBody, scalar: ScalarType) -> Result<(), CodegenError> {
    match body.find_number(|number| !scalar.is_finite(number)) {
        Some((field, found)) => Err(CodegenError::TooLarge { field, found, scalar: scalar.name() }),
        None => Ok(()),
    }
}

fn check_name(name: &str) -> Result<(), CodegenError> {
    let mut characters = name.chars();
    let starts = characters.next().is_some_and(|c| c.is_alphabetic() || c == '_');
    if starts && name != "_" && characters.all(|c| c.is_alphanumeric() || c == '_') {
        return Ok(());
    }
    Err(CodegenError::Name { found: name.to_owned() })
}
