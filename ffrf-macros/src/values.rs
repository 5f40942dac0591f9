//! The values of single fields: what each may be, and what is said if it is something else.

use ffrf_codegen::layout::{Layout, Structure};
use ffrf_codegen::{CodegenError, Fidelity, FusedMultiplyAdd, ScalarType, Strategy};
use ffrf_model::ModeSelection;
use proc_macro2::Span;
use quote::ToTokens;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Ident, LitBool, LitFloat, LitInt, LitStr, Token};

use crate::parse::Field;

/// Mistakes so far, combined.
#[derive(Default)]
pub(crate) struct Mistakes(pub(crate) Option<syn::Error>);

impl Mistakes {
    pub(crate) fn push(&mut self, error: syn::Error) {
        match &mut self.0 {
            Some(first) => first.combine(error),
            None => self.0 = Some(error),
        }
    }

    pub(crate) fn add(&mut self, span: Span, message: String) {
        self.push(syn::Error::new(span, message));
    }

    pub(crate) fn keep<T>(&mut self, result: syn::Result<T>) -> Option<T> {
        result.map_err(|error| self.push(error)).ok()
    }

    pub(crate) fn verdict<T>(self, value: T) -> syn::Result<T> {
        self.0.map_or(Ok(value), Err)
    }
}

/// Parses the whole value of a field; on failure says what was expected.
fn value_of<T>(
    field: &Field,
    expected: &str,
    parser: impl FnOnce(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<T> {
    parser.parse2(field.value.clone()).map_err(|_| {
        let found = field.value.to_string();
        let found = if found.is_empty() { "nothing".to_owned() } else { format!("`{found}`") };
        syn::Error::new(field.span, format!("`{}` must be {expected}, found {found}", field.key))
    })
}

/// One word out of a list.
fn word<T: Copy>(field: &Field, expected: &str, words: &[(&str, T)]) -> syn::Result<T> {
    value_of(field, expected, |input: ParseStream<'_>| {
        let word: Ident = input.parse()?;
        let known = words.iter().find(|(name, _)| word == name);
        known.map(|(_, value)| *value).ok_or_else(|| syn::Error::new(word.span(), "unknown"))
    })
}

pub(crate) fn model(field: &Field) -> syn::Result<LitStr> {
    value_of(field, "a path in quotes", <LitStr as Parse>::parse)
}

pub(crate) fn scalar(field: &Field) -> syn::Result<ScalarType> {
    word(field, "f64, f32 or generic", &ScalarType::ALL.map(|scalar| (scalar.name(), scalar)))
}

pub(crate) fn fused_multiply_add(field: &Field) -> syn::Result<FusedMultiplyAdd> {
    word(field, "auto, on or off", &FusedMultiplyAdd::ALL.map(|choice| (choice.name(), choice)))
}

pub(crate) fn strategy(field: &Field) -> syn::Result<Strategy> {
    let words = Strategy::ALL.map(|strategy| (strategy.name(), strategy));
    word(field, "auto, straight_line or lanes", &words)
}

pub(crate) fn jacobians(field: &Field) -> syn::Result<bool> {
    value_of(field, "true or false", <LitBool as Parse>::parse).map(|wanted| wanted.value)
}

/// `..8`, `2..5` or `[0, 2, 5]` with a model.
pub(crate) fn mode_selection(field: &Field) -> syn::Result<ModeSelection> {
    let expected = "`..8` for the first 8 modes of the model, a range `2..5` or a list `[0, 2, 5]` (from 0)";
    let number = |input: ParseStream<'_>| input.parse::<LitInt>()?.base10_parse::<usize>();
    value_of(field, expected, |input: ParseStream<'_>| {
        if input.peek(syn::token::Bracket) {
            let content;
            syn::bracketed!(content in input);
            let indices = content.parse_terminated(number, Token![,])?;
            return Ok(ModeSelection::Listed(indices.into_iter().collect()));
        }
        let start = if input.peek(Token![..]) { None } else { Some(number(input)?) };
        input.parse::<Token![..]>()?;
        let end = number(input)?;
        match start {
            None => Ok(ModeSelection::First(end)),
            Some(start) if start < end => Ok(ModeSelection::Range(start, end)),
            Some(_) => Err(input.error("an empty range")),
        }
    })
}

/// `[0, 2, 4]` in a family: numbers of modes with their places, each once.
pub(crate) fn mode_counts(field: &Field) -> syn::Result<Vec<(usize, Span)>> {
    let expected = "a list of numbers of modes, like `[0, 2, 4, 8]`, in a family";
    let found = elements(field, expected, |input: ParseStream<'_>| {
        let literal: LitInt = input.parse()?;
        Ok((literal.base10_parse::<usize>()?, literal.span()))
    })?;
    each_once(field, found, |(count, span)| (count.to_string(), *span))
}

/// `[full, [first_moment, modal_rotation]]` in a family, each with the field that one body would have.
pub(crate) fn fidelities(field: &Field) -> syn::Result<Vec<(Fidelity, Field)>> {
    let expected = "a list of levels, or of lists of energy terms, like `[full, linear]`, in a family";
    let trees = elements(field, expected, |input: ParseStream<'_>| input.parse::<proc_macro2::TokenTree>())?;
    let mut mistakes = Mistakes::default();
    let found = trees.into_iter().filter_map(|tree| {
        let one = Field { key: field.key.clone(), span: tree.span(), value: tree.into() };
        mistakes.keep(fidelity(&one)).map(|level| (level, one))
    });
    let found: Vec<_> = found.collect();
    mistakes.verdict(())?;
    each_once(field, found, |(level, one)| (level.to_string(), one.span))
}

/// `[f64, f32]` in a family, each with the field that one body would have.
pub(crate) fn scalars(field: &Field) -> syn::Result<Vec<(ScalarType, Field)>> {
    let expected = "a list of f64 and f32 in a family";
    let words = elements(field, expected, |input: ParseStream<'_>| {
        let word: Ident = input.parse()?;
        let known = ScalarType::from_name(&word.to_string()).filter(|one| *one != ScalarType::Generic);
        let one =
            Field { key: field.key.clone(), span: word.span(), value: word.clone().into_token_stream() };
        known.map(|scalar| (scalar, one)).ok_or_else(|| syn::Error::new(word.span(), "unknown"))
    })?;
    each_once(field, words, |(scalar, one)| (scalar.name().to_owned(), one.span))
}

/// What stands between brackets, separated by commas; at least one.
fn elements<T>(
    field: &Field,
    expected: &str,
    element: impl Fn(ParseStream<'_>) -> syn::Result<T>,
) -> syn::Result<Vec<T>> {
    value_of(field, expected, |input: ParseStream<'_>| {
        let content;
        syn::bracketed!(content in input);
        let mut found = Vec::new();
        while !content.is_empty() {
            found.push(element(&content)?);
            if !content.is_empty() {
                content.parse::<Token![,]>()?;
            }
        }
        if found.is_empty() { Err(content.error("empty")) } else { Ok(found) }
    })
}

/// Two members of one name cannot be.
fn each_once<T>(field: &Field, list: Vec<T>, name: impl Fn(&T) -> (String, Span)) -> syn::Result<Vec<T>> {
    let names: Vec<(String, Span)> = list.iter().map(name).collect();
    for (index, (text, span)) in names.iter().enumerate() {
        if names[..index].iter().any(|(earlier, _)| earlier == text) {
            return Err(syn::Error::new(*span, format!("`{text}` is in `{}` twice", field.key)));
        }
    }
    Ok(list)
}

/// `8` without one.
pub(crate) fn mode_count(field: &Field) -> syn::Result<usize> {
    value_of(field, "the number of modes, like `8`", |input: ParseStream<'_>| {
        input.parse::<LitInt>()?.base10_parse()
    })
}

pub(crate) fn tolerance(field: &Field) -> syn::Result<f64> {
    value_of(field, "a relative tolerance from 0 to below 1, like 1e-13", |input: ParseStream<'_>| {
        let tolerance: f64 = if input.peek(LitInt) {
            input.parse::<LitInt>()?.base10_parse()?
        } else {
            input.parse::<LitFloat>()?.base10_parse()?
        };
        if (0.0..1.0).contains(&tolerance) { Ok(tolerance) } else { Err(input.error("out of range")) }
    })
}

/// `full`, or `[translation, rotation, ...]`
pub(crate) fn fidelity(field: &Field) -> syn::Result<Fidelity> {
    let (level, terms) =
        value_of(field, "a level (full) or a list of energy terms", |input: ParseStream<'_>| {
            if !input.peek(syn::token::Bracket) {
                return input.parse::<Ident>().map(|level| (Some(level), Vec::new()));
            }
            let content;
            syn::bracketed!(content in input);
            let terms = content.parse_terminated(Ident::parse, Token![,])?;
            Ok((None, terms.into_iter().collect::<Vec<_>>()))
        })?;
    if let Some(level) = level {
        return Fidelity::from_name(&level.to_string())
            .map_err(|error| syn::Error::new(level.span(), error.to_string()));
    }
    let mut mistakes = Mistakes::default();
    let names: Vec<String> = terms.iter().map(Ident::to_string).collect();
    for (term, name) in terms.iter().zip(&names) {
        let known = Fidelity::from_term_names([name.as_str()]);
        mistakes.keep(known.map_err(|error| syn::Error::new(term.span(), error.to_string())));
    }
    mistakes.verdict(())?;
    Fidelity::from_term_names(names.iter().map(String::as_str))
        .map_err(|error| syn::Error::new(field.span, error.to_string()))
}

/// `{ first_moment: zero, ... }`; what is not named is as general as it can be.
pub(crate) fn layout(field: &Field) -> syn::Result<Layout> {
    let entries = value_of(
        field,
        "a list of invariants with their structures, like `{ first_moment: zero }`",
        |input: ParseStream<'_>| {
            let content;
            syn::braced!(content in input);
            let entries = content.parse_terminated(Field::parse, Token![,])?;
            Ok(entries.into_iter().collect::<Vec<_>>())
        },
    )?;
    let mut layout = Layout::GENERAL;
    let mut mistakes = Mistakes::default();
    let mut seen: Vec<&Ident> = Vec::new();
    for entry in &entries {
        let key = entry.key.to_string();
        if seen.contains(&&entry.key) {
            mistakes.add(entry.key.span(), format!("`{key}` is given twice"));
            continue;
        }
        seen.push(&entry.key);
        let words = Structure::ALL.map(|structure| (structure.name(), structure));
        let names = Structure::ALL.map(Structure::name).join(", ");
        let Some(structure) = mistakes.keep(word(entry, &format!("one of: {names}"), &words)) else {
            continue;
        };
        if let Err(error) = layout.declare(&key, structure) {
            let unknown = matches!(error, CodegenError::UnknownInvariant { .. });
            mistakes.add(if unknown { entry.key.span() } else { entry.span }, error.to_string());
        }
    }
    mistakes.verdict(layout)
}
