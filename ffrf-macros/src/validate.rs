//! From what the user wrote to options of the generator; every mistake is reported, each once.

use ffrf_codegen::{Fidelity, FusedMultiplyAdd, GenerateOptions, ScalarType};
use proc_macro2::Span;
use quote::ToTokens;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Ident, LitBool, LitFloat, LitInt, LitStr, Token};

use crate::parse::{Field, Input};

/// A body that can be generated.
pub(crate) struct Request {
    pub(crate) model: LitStr,
    pub(crate) modes: Option<Modes>,
    pub(crate) options: GenerateOptions,
}

/// How many modes, and where that stands.
pub(crate) struct Modes {
    pub(crate) span: Span,
}

const KEYS: [&str; 7] = ["model", "modes", "scalar", "fidelity", "jacobians", "fma", "layout_tolerance"];

/// Checks every field; all mistakes are in the error.
pub(crate) fn validate(input: &Input) -> syn::Result<Request> {
    let mut mistakes = Mistakes::default();
    let mut options = GenerateOptions {
        name: input.name.to_string(),
        visibility: input.visibility.to_token_stream().to_string(),
        attributes: input.attributes.iter().map(attribute_text).collect(),
        ..GenerateOptions::default()
    };
    let mut model = None;
    let mut modes = None;
    let mut seen: Vec<&Ident> = Vec::new();
    for field in &input.fields {
        if seen.contains(&&field.key) {
            mistakes.add(field.key.span(), format!("`{}` is given twice", field.key));
            continue;
        }
        seen.push(&field.key);
        match field.key.to_string().as_str() {
            "model" => {
                model = mistakes.keep(parse_value(field, "a path in quotes", <LitStr as Parse>::parse))
            }
            "modes" => {
                if let Some(count) =
                    mistakes.keep(parse_value(field, "`..8` to use the first 8 modes", range))
                {
                    options.modes = Some(count);
                    modes = Some(Modes { span: field.span });
                }
            }
            "scalar" => {
                if let Some(name) = mistakes.keep(parse_value(field, "f64 or f32", Ident::parse)) {
                    match name.to_string().as_str() {
                        "f64" => options.scalar = ScalarType::F64,
                        "f32" => options.scalar = ScalarType::F32,
                        other => mistakes.add(name.span(), format!("expected f64 or f32, found `{other}`")),
                    }
                }
            }
            "fidelity" => match fidelity(field) {
                Ok(fidelity) => options.fidelity = fidelity,
                Err(error) => mistakes.push(error),
            },
            "jacobians" => {
                if let Some(wanted) = mistakes.keep(parse_value(field, "true or false", LitBool::parse)) {
                    options.jacobians = wanted.value;
                }
            }
            "fma" => {
                if let Some(name) = mistakes.keep(parse_value(field, "auto, on or off", Ident::parse)) {
                    match name.to_string().as_str() {
                        "auto" => options.fused_multiply_add = FusedMultiplyAdd::Auto,
                        "on" => options.fused_multiply_add = FusedMultiplyAdd::On,
                        "off" => options.fused_multiply_add = FusedMultiplyAdd::Off,
                        other => {
                            mistakes.add(name.span(), format!("expected auto, on or off, found `{other}`"))
                        }
                    }
                }
            }
            "layout_tolerance" => match tolerance(field) {
                Ok(tolerance) => options.layout_tolerance = tolerance,
                Err(error) => mistakes.push(error),
            },
            other => mistakes.add(
                field.key.span(),
                format!("unknown key `{other}`, expected one of: {}", KEYS.join(", ")),
            ),
        }
    }
    if model.is_none() && !seen.iter().any(|key| *key == "model") {
        mistakes.add(
            input.name.span(),
            format!("`{}` needs a model: write `model: \"path/to/file.ffrf.json\"`", input.name),
        );
    }
    match (mistakes.0, model) {
        (None, Some(model)) => Ok(Request { model, modes, options }),
        (Some(error), _) => Err(error),
        (None, None) => Err(syn::Error::new(input.name.span(), "no model")),
    }
}

/// Mistakes so far, combined.
#[derive(Default)]
struct Mistakes(Option<syn::Error>);

impl Mistakes {
    fn push(&mut self, error: syn::Error) {
        match &mut self.0 {
            Some(first) => first.combine(error),
            None => self.0 = Some(error),
        }
    }

    fn add(&mut self, span: Span, message: String) {
        self.push(syn::Error::new(span, message));
    }

    fn keep<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.push(error)).ok()
    }
}

/// Parses the whole value of a field; on failure says what was expected.
fn parse_value<T>(
    field: &Field,
    expected: &str,
    parser: fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    parser.parse2(field.value.clone()).map_err(|_| {
        let found = field.value.to_string();
        let found = if found.is_empty() { "nothing".to_owned() } else { format!("`{found}`") };
        syn::Error::new(field.span, format!("`{}` must be {expected}, found {found}", field.key))
    })
}

/// `..8`
fn range(input: ParseStream<'_>) -> syn::Result<usize> {
    input.parse::<Token![..]>()?;
    input.parse::<LitInt>()?.base10_parse()
}

fn tolerance(field: &Field) -> syn::Result<f64> {
    let number = |input: ParseStream<'_>| {
        if input.peek(LitInt) {
            return input.parse::<LitInt>()?.base10_parse();
        }
        input.parse::<LitFloat>()?.base10_parse()
    };
    let tolerance: f64 = parse_value(field, "a relative tolerance, like 1e-13", number)?;
    if !(0.0..1.0).contains(&tolerance) {
        let message = format!("layout tolerance must be at least 0 and below 1, found {tolerance}");
        return Err(syn::Error::new(field.span, message));
    }
    Ok(tolerance)
}

/// `full`, or `[translation, rotation, ...]`
fn fidelity(field: &Field) -> syn::Result<Fidelity> {
    let names = |input: ParseStream<'_>| {
        if !input.peek(syn::token::Bracket) {
            return input.parse::<Ident>().map(|level| (Some(level), Vec::new()));
        }
        let content;
        syn::bracketed!(content in input);
        let terms = content.parse_terminated(Ident::parse, Token![,])?;
        Ok((None, terms.into_iter().collect::<Vec<_>>()))
    };
    let (level, terms) = parse_value(field, "a level (full) or a list of energy terms", names)?;
    if let Some(level) = level {
        return Fidelity::from_name(&level.to_string())
            .map_err(|error| syn::Error::new(level.span(), error.to_string()));
    }
    let mut mistakes = Mistakes::default();
    for term in &terms {
        mistakes.keep(
            Fidelity::from_term_names([term.to_string().as_str()])
                .map_err(|error| syn::Error::new(term.span(), error.to_string())),
        );
    }
    if let Some(error) = mistakes.0 {
        return Err(error);
    }
    let terms: Vec<String> = terms.iter().map(Ident::to_string).collect();
    Fidelity::from_term_names(terms.iter().map(String::as_str))
        .map_err(|error| syn::Error::new(field.span, error.to_string()))
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
