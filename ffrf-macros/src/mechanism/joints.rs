//! The joints of a mechanism.

use ffrf_codegen::mechanism::{JointTopology, KNOWN_JOINTS, KnownJoint};
use proc_macro2::TokenStream;
use quote::quote;
use syn::punctuated::Punctuated;
use syn::{Ident, LitBool, Token};

use super::axis::Axes;
use super::bodies::Body;
use super::call::{Call, Entry, Range};
use super::ends::{End, end};
use super::scalar::Scalar;
use crate::values::Mistakes;

/// A joint, or one for each index of a range.
pub(super) struct Joint {
    pub(super) name: Ident,
    pub(super) known: &'static KnownJoint,
    pub(super) rows: usize,
    pub(super) range: Option<Range>,
    pub(super) ends: [End; 2],
    /// The kind as an expression.
    pub(super) kind: TokenStream,
    pub(super) axes: Axes,
    /// Index of the first of them among all connections.
    pub(super) first: usize,
}

impl Joint {
    /// Number of joints.
    pub(super) fn len(&self) -> usize {
        self.range.as_ref().map_or(1, Range::len)
    }

    /// What the order of elimination must know of each.
    pub(super) fn topology(&self) -> impl Iterator<Item = JointTopology> + '_ {
        (0..self.len()).map(|k| JointTopology {
            rows: self.rows,
            holds_point: self.known.holds_point,
            ends: [self.ends[0].body(k), self.ends[1].body(k)],
        })
    }

    /// The name of each.
    pub(super) fn names(&self) -> Vec<String> {
        match &self.range {
            None => vec![self.name.to_string()],
            Some(range) => range.names(&self.name),
        }
    }
}

/// The joint of an entry.
pub(super) fn joint(
    entry: Entry,
    bodies: &mut [Body],
    scalar: &Scalar,
    mistakes: &mut Mistakes,
) -> Option<Joint> {
    let Entry { name, range, call } = entry;
    let Some(known) = KnownJoint::find(&call.kind.to_string()) else {
        let names: Vec<&str> = KNOWN_JOINTS.iter().map(|joint| joint.name).collect();
        let message = format!("unknown kind of joint `{}`, expected one of: {}", call.kind, names.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    };
    for error in call.check_options(&options(known)) {
        mistakes.push(error);
    }
    let [first, second] = mistakes.keep(call.arguments("two ends"))?;
    let ends = [
        mistakes.keep(end(first, bodies, range.as_ref())),
        mistakes.keep(end(second, bodies, range.as_ref())),
    ];
    let kind = mistakes.keep(kind(known, &call, scalar));
    let axes = mistakes.keep(Axes::of(&call, known.name == "universal"));
    let [Some(first), Some(second)] = ends else { return None };
    let ends = [first, second];
    for k in 0..range.as_ref().map_or(1, Range::len) {
        let message = match (ends[0].body(k), ends[1].body(k)) {
            (None, None) => "both ends of this joint are on the ground".to_owned(),
            (Some(one), Some(other)) if one == other => {
                "both ends of this joint are on the same body".to_owned()
            }
            _ => continue,
        };
        let at = range
            .as_ref()
            .map_or(String::new(), |range| format!(", at `{} = {}`", range.variable, range.start + k));
        mistakes.add(second_span(&ends, &call), format!("{message}{at}"));
        return None;
    }
    let (kind, rows) = kind?;
    Some(Joint { name, known, rows, range, ends, kind, axes: axes?, first: 0 })
}

fn second_span(ends: &[End; 2], call: &Call) -> proc_macro2::Span {
    match &ends[1] {
        End::OnBody(end) => end.span,
        End::Ground(_) => call.kind.span(),
    }
}

fn options(known: &KnownJoint) -> Vec<&'static str> {
    let own: &[&str] = match known.name {
        "distance" => &["length"],
        "generic" => &["translation", "rotation"],
        _ => &[],
    };
    let axis = known.has_axis.then_some("axis");
    axis.into_iter().chain(own.iter().copied()).collect()
}

/// The kind as an expression, and its number of rows.
fn kind(known: &KnownJoint, call: &Call, scalar: &Scalar) -> syn::Result<(TokenStream, usize)> {
    let variant = Ident::new(known.type_name, call.kind.span());
    let joints = quote! { ::ffrf::joints };
    match known.name {
        "distance" => {
            let Some(length) = call.option("length") else {
                return Err(syn::Error::new(call.kind.span(), "a distance joint needs its `length` (m)"));
            };
            let length = scalar.number(&length.value);
            let kind = quote! { #joints::JointKind::Distance(#joints::Distance { length: #length }) };
            Ok((kind, 1))
        }
        "generic" => {
            let (translation, rotation) = (held(call, "translation")?, held(call, "rotation")?);
            let rows = translation.iter().chain(&rotation).filter(|held| **held).count();
            if rows == 0 {
                let message = "a generic joint holds something: `translation: [true, false, true]` or `rotation: [...]`";
                return Err(syn::Error::new(call.kind.span(), message));
            }
            let kind = quote! {
                #joints::JointKind::Generic(#joints::Generic {
                    translation: [#(#translation),*],
                    rotation: [#(#rotation),*],
                })
            };
            Ok((kind, rows))
        }
        _ => Ok((quote! { #joints::JointKind::#variant(#joints::#variant) }, known.rows.unwrap_or(0))),
    }
}

fn held(call: &Call, key: &str) -> syn::Result<[bool; 3]> {
    let Some(option) = call.option(key) else { return Ok([false; 3]) };
    let parser = |input: syn::parse::ParseStream<'_>| {
        let content;
        syn::bracketed!(content in input);
        let all = Punctuated::<LitBool, Token![,]>::parse_terminated(&content)?;
        Ok(all.into_iter().map(|held| held.value).collect::<Vec<_>>())
    };
    let found = syn::parse::Parser::parse2(parser, option.value.clone()).ok();
    found.and_then(|held| held.try_into().ok()).ok_or_else(|| {
        let message = format!("`{key}` must be three of `true` and `false`: `[true, true, false]`");
        syn::Error::new(option.key.span(), message)
    })
}
