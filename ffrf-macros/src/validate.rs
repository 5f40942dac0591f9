//! From what the user wrote to options of the generator; every mistake is reported, each once.

use ffrf_codegen::GenerateOptions;
use ffrf_codegen::layout::Layout;
use proc_macro2::Span;
use quote::ToTokens;
use syn::LitStr;

use crate::parse::{Field, Input};
use crate::values::{self, Mistakes};

/// A body that can be generated.
pub(crate) struct Request {
    pub(crate) source: Source,
    pub(crate) options: GenerateOptions,
}

/// Where the invariants come from.
pub(crate) enum Source {
    /// A model file; the place where the choice of modes stands, if it does.
    Model { path: LitStr, modes: Option<Span> },
    /// Run time.
    Layout { mode_count: usize, layout: Layout, span: Span },
}

const KEYS: [&str; 9] =
    ["model", "modes", "layout", "scalar", "fidelity", "jacobians", "fma", "strategy", "layout_tolerance"];

/// Checks every field; all mistakes are in the error.
pub(crate) fn validate(input: &Input) -> syn::Result<Request> {
    let mut mistakes = Mistakes::default();
    let mut options = GenerateOptions {
        name: input.name.to_string(),
        visibility: input.visibility.to_token_stream().to_string(),
        attributes: input.attributes.iter().map(attribute_text).collect(),
        ..GenerateOptions::default()
    };
    report_repeated_keys(input, &mut mistakes);
    let find = |key: &str| input.fields.iter().find(|field| field.key == key);
    for field in &input.fields {
        if !KEYS.iter().any(|key| field.key == key) {
            let message = format!("unknown key `{}`, expected one of: {}", field.key, KEYS.join(", "));
            mistakes.add(field.key.span(), message);
        }
    }
    set(&mut options.scalar, find("scalar"), values::scalar, &mut mistakes);
    set(&mut options.fidelity, find("fidelity"), values::fidelity, &mut mistakes);
    set(&mut options.jacobians, find("jacobians"), values::jacobians, &mut mistakes);
    set(&mut options.fused_multiply_add, find("fma"), values::fused_multiply_add, &mut mistakes);
    set(&mut options.strategy, find("strategy"), values::strategy, &mut mistakes);
    set(&mut options.layout_tolerance, find("layout_tolerance"), values::tolerance, &mut mistakes);
    let source = match (find("model"), find("layout")) {
        (Some(model), None) => model_source(model, find("modes"), &mut options, &mut mistakes),
        (None, Some(layout)) => {
            if let Some(field) = find("layout_tolerance") {
                let message = "`layout_tolerance` finds the layout of a model; here the layout is declared";
                mistakes.add(field.key.span(), message.to_owned());
            }
            layout_source(layout, find("modes"), &mut mistakes)
        }
        (Some(_), Some(layout)) => {
            let message = "the layout of a model is found, not declared: give `model` or `layout`";
            mistakes.add(layout.key.span(), message.to_owned());
            None
        }
        (None, None) => {
            let message = format!(
                "`{0}` needs invariants: write `model: \"path/to/file.ffrf.json\"`, or `modes: M, layout: {{...}}` to supply them at run time",
                input.name
            );
            mistakes.add(input.name.span(), message);
            None
        }
    };
    mistakes.verdict(())?;
    // Without a mistake there is a source.
    source
        .map(|source| Request { source, options })
        .ok_or_else(|| syn::Error::new(input.name.span(), "no invariants"))
}

fn report_repeated_keys(input: &Input, mistakes: &mut Mistakes) {
    for (position, field) in input.fields.iter().enumerate() {
        if input.fields[..position].iter().any(|earlier| earlier.key == field.key) {
            mistakes.add(field.key.span(), format!("`{}` is given twice", field.key));
        }
    }
}

fn set<T>(
    option: &mut T,
    field: Option<&Field>,
    value: fn(&Field) -> syn::Result<T>,
    mistakes: &mut Mistakes,
) {
    if let Some(value) = field.and_then(|field| mistakes.keep(value(field))) {
        *option = value;
    }
}

fn model_source(
    model: &Field,
    modes: Option<&Field>,
    options: &mut GenerateOptions,
    mistakes: &mut Mistakes,
) -> Option<Source> {
    options.modes = modes.and_then(|field| mistakes.keep(values::mode_selection(field)));
    let path = mistakes.keep(values::model(model))?;
    Some(Source::Model { path, modes: modes.map(|field| field.span) })
}

fn layout_source(layout: &Field, modes: Option<&Field>, mistakes: &mut Mistakes) -> Option<Source> {
    let declared = mistakes.keep(values::layout(layout));
    let Some(modes) = modes else {
        let message = "a declared layout needs the number of modes: write `modes: M`";
        mistakes.add(layout.key.span(), message.to_owned());
        return None;
    };
    let mode_count = mistakes.keep(values::mode_count(modes));
    Some(Source::Layout { mode_count: mode_count?, layout: declared?, span: layout.key.span() })
}

/// An attribute as a line of text; doc comments in their short form, as the command line prints them.
fn attribute_text(attribute: &syn::Attribute) -> String {
    if let syn::Meta::NameValue(pair) = &attribute.meta
        && attribute.path().is_ident("doc")
        && let syn::Expr::Lit(syn::ExprLit { lit: syn::Lit::Str(text), .. }) = &pair.value
        && !text.value().contains('\n')
    {
        return format!("///{}", text.value());
    }
    attribute.to_token_stream().to_string()
}
