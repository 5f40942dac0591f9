//! Driven joints.

use ffrf_codegen::mechanism::JointTopology;
use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::call::Entry;
use super::joints::Joint;
use super::scalar::Scalar;
use crate::values::Mistakes;

/// The angle or travel of a joint as a function of time.
pub(super) struct Drive {
    pub(super) name: Ident,
    /// The joint among those written.
    pub(super) joint: usize,
    /// `Angle` or `Travel`.
    pub(super) type_name: &'static str,
    /// The function as an expression.
    pub(super) function: TokenStream,
    /// Index of its row among all connections.
    pub(super) first: usize,
}

impl Drive {
    /// What the order of elimination must know of it.
    pub(super) fn topology(&self, joints: &[Joint]) -> JointTopology {
        let [first, second] = &joints[self.joint].ends;
        JointTopology { rows: 1, ends: [first.body(0), second.body(0)] }
    }
}

const KINDS: [&str; 2] = ["angle", "position"];

/// The drive of an entry.
pub(super) fn drive(
    entry: Entry,
    joints: &[Joint],
    earlier: &[Drive],
    scalar: &Scalar,
    mistakes: &mut Mistakes,
) -> Option<Drive> {
    let Entry { name, range, call } = entry;
    if let Some(range) = range {
        mistakes.add(range.span, "a drive belongs to one joint".to_owned());
    }
    if !KINDS.iter().any(|kind| call.kind == kind) {
        let message = format!("unknown kind of drive `{}`, expected one of: {}", call.kind, KINDS.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    }
    for error in call.check_options(&["polynomial", "function"]) {
        mistakes.push(error);
    }
    let [argument] = mistakes.keep(call.arguments("one joint"))?;
    let joint = mistakes.keep(find(argument, joints))?;
    let found = &joints[joint];
    let is_angle = call.kind == KINDS[0];
    if found.range.is_some() {
        mistakes.add(argument.span, format!("`{}` are several joints, a drive belongs to one", found.name));
        return None;
    }
    if !(if is_angle { found.known.has_angle } else { found.known.has_travel }) {
        let message = format!(
            "the {} of `{}`, a {} joint, cannot be driven: `angle` is for revolute and cylindrical joints, `position` for prismatic, cylindrical and in_line ones",
            call.kind, found.name, found.known.name
        );
        mistakes.add(argument.span, message);
        return None;
    }
    let type_name = if is_angle { "Angle" } else { "Travel" };
    if earlier.iter().any(|other| other.joint == joint && other.type_name == type_name) {
        mistakes.add(argument.span, format!("the {} of `{}` is driven twice", call.kind, found.name));
        return None;
    }
    let t = scalar.name();
    let function = match (call.option("polynomial"), call.option("function")) {
        (Some(coefficients), None) => {
            let coefficients = &coefficients.value;
            quote! {
                ::ffrf::mechanism::Drive::<#t>::polynomial(
                    &::ffrf::generated_support::mechanism::numbers::<_, #t>(#coefficients),
                )
            }
        }
        (None, Some(function)) => {
            let function = &function.value;
            quote! { ::ffrf::mechanism::Drive::<#t>::Function(#function) }
        }
        (None, None) => quote! { ::ffrf::mechanism::Drive::<#t>::polynomial(&[]) },
        (Some(_), Some(function)) => {
            let message = "a drive is either a `polynomial` or a `function`".to_owned();
            mistakes.add(function.key.span(), message);
            return None;
        }
    };
    Some(Drive { name, joint, type_name, function, first: 0 })
}

/// The joint that is named by an argument.
pub(super) fn find(argument: &super::call::Argument, joints: &[Joint]) -> syn::Result<usize> {
    let written = argument.tokens.to_string();
    joints.iter().position(|joint| joint.name == written).ok_or_else(|| {
        let known: Vec<String> = joints.iter().map(|joint| format!("`{}`", joint.name)).collect();
        let known = if known.is_empty() { "none".to_owned() } else { known.join(", ") };
        syn::Error::new(argument.span, format!("there is no joint `{written}`; there are: {known}"))
    })
}
