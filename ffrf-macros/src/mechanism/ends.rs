//! What joints, forces and sensors are attached to: `ground`, `ground.at([x, y, z])`, `body`, `body.MARKER`,
//! `bodies[i].MARKER`, `body.at([x, y, z])`.

use proc_macro2::{Span, TokenStream};
use quote::quote;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Expr, Ident, Token, bracketed, parenthesized};

use super::bodies::{Body, GROUND, UsedMarker};
use super::call::{Argument, Range};
use super::index::evaluate;
use super::scalar::Scalar;

/// An end that was found.
pub(super) enum End {
    /// A place on the ground, if not its origin.
    Ground(Option<TokenStream>),
    /// A marker of a body.
    OnBody(BodyEnd),
}

/// A marker of a body.
pub(super) struct BodyEnd {
    /// The field.
    pub(super) field: usize,
    /// Index in the field, as written.
    pub(super) index: Option<TokenStream>,
    /// The bodies among all, one for each index of the range.
    pub(super) bodies: Vec<usize>,
    /// Number of the marker among those used on the field.
    pub(super) marker: usize,
    pub(super) span: Span,
}

impl End {
    /// The body for the `k`-th index of the range.
    pub(super) fn body(&self, k: usize) -> Option<usize> {
        match self {
            Self::Ground(_) => None,
            Self::OnBody(end) => end.bodies.get(k).copied(),
        }
    }

    /// The attachment as an expression, `orientation` being that of its triad.
    pub(super) fn attachment(
        &self,
        bodies: &[Body],
        scalar: &Scalar,
        orientation: &TokenStream,
    ) -> TokenStream {
        let t = scalar.name();
        match self {
            Self::Ground(position) => {
                let position = match position {
                    Some(position) => scalar.vector(position),
                    None => quote! { ::ffrf::nalgebra::Vector3::<#t>::zeros() },
                };
                quote! { ::ffrf::mechanism::Attachment::<#t>::on_ground(#position, #orientation) }
            }
            Self::OnBody(BodyEnd { field, index, marker, .. }) => {
                let first = bodies[*field].first;
                let body = match index {
                    Some(index) => quote! { #first + (#index) },
                    None => quote! { #first },
                };
                quote! { ::ffrf::mechanism::Attachment::<#t>::on_body(#body, #marker, #orientation) }
            }
        }
    }
}

/// What is written, before it is looked up.
struct Written {
    name: Ident,
    index: Option<Expr>,
    marker: Option<Ident>,
    position: Option<TokenStream>,
}

impl Parse for Written {
    fn parse(input: ParseStream<'_>) -> syn::Result<Self> {
        let name = input.parse()?;
        let index = if input.peek(syn::token::Bracket) {
            let content;
            bracketed!(content in input);
            Some(content.parse()?)
        } else {
            None
        };
        let (mut marker, mut position) = (None, None);
        while input.peek(Token![.]) {
            input.parse::<Token![.]>()?;
            let word: Ident = input.parse()?;
            if input.peek(syn::token::Paren) {
                if word != "at" || position.is_some() {
                    return Err(syn::Error::new(word.span(), "expected `.at([x, y, z])`, once"));
                }
                let content;
                parenthesized!(content in input);
                position = Some(content.parse()?);
            } else if marker.is_some() || position.is_some() {
                return Err(syn::Error::new(word.span(), "expected one marker: `body.MARKER`"));
            } else {
                marker = Some(word);
            }
        }
        if input.is_empty() {
            Ok(Self { name, index, marker, position })
        } else {
            Err(input
                .error("expected `ground`, `body`, `body.MARKER`, `bodies[i].MARKER` or `.at([x, y, z])`"))
        }
    }
}

/// Looks an end up; its marker joins those used on the body.
pub(super) fn end(argument: &Argument, bodies: &mut [Body], range: Option<&Range>) -> syn::Result<End> {
    let Written { name, index, marker, position } =
        Written::parse.parse2(argument.tokens.clone()).map_err(|error| {
            if argument.tokens.is_empty() { syn::Error::new(argument.span, error) } else { error }
        })?;
    if name == GROUND {
        return match (index, marker) {
            (None, None) => Ok(End::Ground(position)),
            _ => Err(syn::Error::new(
                name.span(),
                "the ground has no markers and no index: write `ground.at([x, y, z])`",
            )),
        };
    }
    let Some(field) = bodies.iter().position(|body| body.name == name) else {
        let known: Vec<String> = bodies.iter().map(|body| format!("`{}`", body.name)).collect();
        let message = format!("there is no body `{name}`; there are `{GROUND}`, {}", known.join(", "));
        return Err(syn::Error::new(name.span(), message));
    };
    let body = &mut bodies[field];
    let found = indices(&name, index.as_ref(), body, range)?;
    let marker = match (marker, position) {
        (Some(marker), None) => body.named(&marker)?,
        (Some(marker), Some(_)) => {
            let message = "a marker has its place: write `body.MARKER` or `body.at([x, y, z])`";
            return Err(syn::Error::new(marker.span(), message));
        }
        (None, Some(position)) => UsedMarker::Point(position),
        (None, None) => UsedMarker::Point(quote! { [0.0, 0.0, 0.0] }),
    };
    let marker = body.use_marker(marker);
    let index = index.map(|index| quote! { #index });
    Ok(End::OnBody(BodyEnd {
        field,
        index,
        bodies: found.into_iter().map(|index| body.first + index).collect(),
        marker,
        span: argument.span,
    }))
}

/// The indices in a field, one for each index of the range.
fn indices(
    name: &Ident,
    index: Option<&Expr>,
    body: &Body,
    range: Option<&Range>,
) -> syn::Result<Vec<usize>> {
    let (start, end) = range.map_or((0, 1), |range| (range.start, range.end));
    match (index, body.count) {
        (None, None) => Ok(vec![0; end - start]),
        (None, Some(count)) => {
            let message = format!("`{name}` is an array of {count} bodies: write `{name}[0]`");
            Err(syn::Error::new(name.span(), message))
        }
        (Some(_), None) => {
            Err(syn::Error::new(name.span(), format!("`{name}` is one body and takes no index")))
        }
        (Some(index), Some(count)) => (start..end)
            .map(|k| {
                let variable = range.map(|range| (&range.variable, k as i64));
                let value = evaluate(index, variable)?;
                usize::try_from(value).ok().filter(|value| *value < count).ok_or_else(|| {
                    let message = format!("`{name}` has {count} bodies, there is no `{name}[{value}]`");
                    syn::Error::new_spanned(index, message)
                })
            })
            .collect(),
    }
}
