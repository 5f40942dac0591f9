//! The generator: a body in, Rust or C out. The macro, build scripts and the command line all come through here.

use ffrf_model::ReducedBody;
use proc_macro2::TokenStream;

use crate::body::BodyExpressions;
use crate::emit;
use crate::expression::Graph;
use crate::formulate::{Definition, JACOBIANS, KERNELS, Kernel, PREPARE};
use crate::lanes::Lanes;
use crate::layout::{Layout, found};
use crate::passes;
use crate::prepare::{check_name, prepare};
use crate::report::{KernelReport, Report, Source};
use crate::validate::ValidKernel;
use crate::{CodegenError, FusedMultiplyAdd, GenerateOptions, ScalarType, Strategy};

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
    Formulated::baked(body, options)?.code(options)
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
    let body =
        BodyExpressions::symbolic(&mut graph, mode_count, layout).truncated(&mut graph, &options.fidelity);
    let lanes = Lanes::of_parameters(mode_count, layout, options)?;
    Formulated { source: None, layout: *layout, graph, body, lanes }.code(options)
}

/// A body in C.
#[derive(Debug, Clone)]
pub struct GeneratedC {
    /// The header.
    pub header: String,
    /// The source; it includes the header as `PREFIX.h`.
    pub source: String,
    /// Header and source in one text, for who wants one file.
    pub single: String,
    /// What every name begins with, in lower case: the name of the body in snake case.
    pub prefix: String,
    /// Layout found and cost of each kernel.
    pub report: Report,
}

/// Generates the kernels of a body whose numbers are baked in as C99.
///
/// The kernels are statements, whatever their number, and the same operations in the same order as in Rust: a compiler
/// that contracts nothing (`-ffp-contract=off`) gives the same bits. Attributes and visibility of the options are not used.
/// Errors: see [`CodegenError`]. Panics: never.
pub fn generate_c(body: &ReducedBody, options: &GenerateOptions) -> Result<GeneratedC, CodegenError> {
    let refuse = |option, found, expected| Err(CodegenError::NotInC { option, found, expected });
    if options.scalar == ScalarType::Generic {
        return refuse("scalar", options.scalar.name(), "f64 or f32");
    }
    if options.fused_multiply_add == FusedMultiplyAdd::On {
        return refuse("fma", options.fused_multiply_add.name(), "auto or off");
    }
    if options.strategy == Strategy::Lanes {
        return refuse("strategy", options.strategy.name(), "auto or straight_line");
    }
    let options = GenerateOptions { strategy: Strategy::StraightLine, ..options.clone() };
    let formulated = Formulated::baked(body, &options)?;
    let kernels = formulated.kernels(&options)?;
    let report = formulated.report(&options, &kernels);
    let emit::CFiles { header, source, single, prefix } =
        emit::c(&formulated.subject(&report, &options), &kernels);
    Ok(GeneratedC { header, source, single, prefix, report })
}

/// The kernel `prepare` of a body in C, seen by no other file.
pub(crate) fn prepare_c(body: &ReducedBody, options: &GenerateOptions) -> Result<String, CodegenError> {
    let formulated = Formulated::baked(body, options)?;
    let kernel = Kernel::formulate(&PREPARE, formulated.graph.clone(), &formulated.body)?;
    let kernel = passes::run(kernel.condensed(), options.fused_multiply_add);
    let kernel = ValidKernel::new(kernel, options.scalar, false)?;
    Ok(emit::c_kernel(&kernel, options, formulated.body.mode_count()))
}

/// A body as expressions, whether its invariants are numbers or symbols.
struct Formulated {
    /// The model that the numbers are from.
    source: Option<(Source, ReducedBody)>,
    layout: Layout,
    graph: Graph,
    body: BodyExpressions,
    lanes: Option<Lanes>,
}

impl Formulated {
    fn baked(body: &ReducedBody, options: &GenerateOptions) -> Result<Self, CodegenError> {
        let source = Source::of(body)?;
        let model = prepare(body, options)?;
        let mut graph = Graph::new();
        let body = BodyExpressions::baked(&mut graph, &model, options.layout_tolerance)
            .truncated(&mut graph, &options.fidelity);
        let lanes = Lanes::of_constants(&mut graph, &body, options)?;
        let layout = found(&model, options.layout_tolerance);
        Ok(Self { source: Some((source, model)), layout, graph, body, lanes })
    }

    /// What is said about the body.
    fn report(&self, options: &GenerateOptions, kernels: &[ValidKernel]) -> Report {
        Report {
            mode_count: self.body.mode_count(),
            source: self.source.as_ref().map(|(source, _)| source.clone()),
            layout: self.layout,
            lanes: self.lanes.as_ref().map(|lanes| lanes.description(options.scalar)),
            table_bytes: self.lanes.as_ref().map_or(0, |lanes| lanes.table_bytes(options.scalar)),
            kernels: kernels.iter().map(|kernel| KernelReport::of(kernel.kernel())).collect(),
        }
    }

    /// The body as printers take it.
    fn subject<'a>(&'a self, report: &'a Report, options: &'a GenerateOptions) -> emit::Subject<'a> {
        let model = self.source.as_ref().map(|(_, model)| model);
        emit::Subject { model, lanes: self.lanes.as_ref(), report, options }
    }

    fn code(self, options: &GenerateOptions) -> Result<GeneratedCode, CodegenError> {
        let kernels = self.kernels(options)?;
        let report = self.report(options, &kernels);
        let subject = self.subject(&report, options);
        let text = emit::rust(&subject, &kernels);
        let tokens = text
            .parse()
            .map_err(|error: proc_macro2::LexError| CodegenError::Tokens { message: error.to_string() })?;
        Ok(GeneratedCode { text, tokens, report })
    }

    /// Every kernel that is printed as statements, through all passes and the validator.
    fn kernels(&self, options: &GenerateOptions) -> Result<Vec<ValidKernel>, CodegenError> {
        let requested: &[&Definition] = if options.jacobians { &JACOBIANS } else { &[] };
        let is_loop = |definition: &Definition| self.lanes.is_some() && definition.lanes.is_some();
        KERNELS
            .iter()
            .chain(requested)
            .filter(|definition| !is_loop(definition))
            .map(|definition| {
                let kernel = Kernel::formulate(definition, self.graph.clone(), &self.body)?;
                let kernel = passes::run(kernel.condensed(), options.fused_multiply_add);
                ValidKernel::new(kernel, options.scalar, self.source.is_none())
            })
            .collect()
    }
}
