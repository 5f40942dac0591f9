//! A joint that drives, forces and sensors name: `pin`, `hinges[2]`, `hinges[i]`.

use proc_macro2::TokenStream;
use quote::quote;
use syn::parse::{Parse, ParseStream, Parser};
use syn::{Expr, Ident, bracketed};

use super::bodies::Body;
use super::call::{Argument, Range};
use super::index::evaluate;
use super::joints::Joint;
use super::scalar::Scalar;

/// A joint, or one of those of `for` for each index of another range.
pub(super) struct NamedJoint {
    /// The joint among those written.
    pub(super) joint: usize,
    /// Which of its joints, one for each index of the range.
    pub(super) elements: Vec<usize>,
    /// The index as written.
    index: Option<Expr>,
}

impl NamedJoint {
    /// What is written in place of a joint.
    pub(super) fn find(argument: &Argument, joints: &[Joint], range: Option<&Range>) -> syn::Result<Self> {
        let (name, index) = written
            .parse2(argument.tokens.clone())
            .map_err(|_| syn::Error::new(argument.span, "expected a joint: `pin` or `hinges[2]`"))?;
        let Some(joint) = joints.iter().position(|joint| joint.name == name) else {
            let known: Vec<String> = joints.iter().map(|joint| format!("`{}`", joint.name)).collect();
            let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
            let message = format!("there is no joint `{name}`; there are: {known}");
            return Err(syn::Error::new(name.span(), message));
        };
        let own = joints[joint].range.as_ref();
        let count = range.map_or(1, Range::len);
        let Some(index) = index else {
            return match own {
                None => Ok(Self { joint, elements: vec![0; count], index: None }),
                Some(own) => Err(syn::Error::new(
                    argument.span,
                    format!(
                        "`{name}` are several joints: write `{name}[{}]`, or `for` all of them",
                        own.start
                    ),
                )),
            };
        };
        let Some(own) = own else {
            return Err(syn::Error::new_spanned(&index, format!("`{name}` is one joint: it has no index")));
        };
        let elements = (0..count).map(|k| {
            let variable = range.map(|range| (&range.variable, i64::try_from(range.start + k).unwrap_or(0)));
            let value = evaluate(&index, variable)?;
            usize::try_from(value).ok().filter(|value| (own.start..own.end).contains(value)).map_or_else(
                || {
                    let message =
                        format!("there is no `{name}[{value}]`: from {} to {}", own.start, own.end - 1);
                    Err(syn::Error::new_spanned(&index, message))
                },
                |value| Ok(value - own.start),
            )
        });
        let elements = elements.collect::<syn::Result<_>>()?;
        Ok(Self { joint, elements, index: Some(index) })
    }

    /// The joint as it was written.
    pub(super) fn of<'a>(&self, joints: &'a [Joint]) -> &'a Joint {
        &joints[self.joint]
    }

    /// The numbers of its connections, one for each index of the range.
    pub(super) fn connections(&self, joints: &[Joint]) -> Vec<usize> {
        let first = self.of(joints).first;
        self.elements.iter().map(|element| first + element).collect()
    }

    /// The number of its connection as an expression, in which the variable of the range has its value.
    pub(super) fn connection(&self, joints: &[Joint]) -> TokenStream {
        let joint = self.of(joints);
        let first = joint.first;
        match (&self.index, &joint.range) {
            (Some(index), Some(range)) => {
                let start = range.start;
                quote! { #first + ((#index) - #start) }
            }
            _ => quote! { #first },
        }
    }

    /// The bodies at both ends, for each index of the range.
    pub(super) fn bodies(&self, joints: &[Joint]) -> Vec<[Option<usize>; 2]> {
        let ends = &self.of(joints).ends;
        self.elements.iter().map(|element| [ends[0].body(*element), ends[1].body(*element)]).collect()
    }

    /// Both attachments as expressions, in which the variable of the range has its value.
    pub(super) fn attachments(&self, joints: &[Joint], bodies: &[Body], scalar: &Scalar) -> [TokenStream; 2] {
        let joint = self.of(joints);
        let [first, second] = joint.axes.orientations(scalar);
        let ends = [
            joint.ends[0].attachment(bodies, scalar, &first),
            joint.ends[1].attachment(bodies, scalar, &second),
        ];
        ends.map(|end| match (&self.index, &joint.range) {
            (Some(index), Some(range)) => {
                let variable = &range.variable;
                quote! { { let #variable: usize = #index; #end } }
            }
            _ => end,
        })
    }
}

fn written(input: ParseStream<'_>) -> syn::Result<(Ident, Option<Expr>)> {
    let name = Ident::parse(input)?;
    if !input.peek(syn::token::Bracket) {
        return Ok((name, None));
    }
    let content;
    bracketed!(content in input);
    Ok((name, Some(content.parse()?)))
}
