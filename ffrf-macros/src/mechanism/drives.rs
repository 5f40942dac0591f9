//! Driven joints.

use ffrf_codegen::mechanism::JointTopology;
use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::call::{Entry, Range};
use super::joints::Joint;
use super::named_joint::NamedJoint;
use super::scalar::Scalar;
use crate::values::Mistakes;

/// The angle or travel of a joint as a function of time, or one for each index of a range.
pub(super) struct Drive {
    pub(super) name: Ident,
    pub(super) range: Option<Range>,
    /// The joint or joints.
    pub(super) of: NamedJoint,
    /// `Angle` or `Travel`.
    pub(super) type_name: &'static str,
    /// The function as an expression.
    pub(super) function: TokenStream,
    /// Index of its row among all connections, of the first of them.
    pub(super) first: usize,
}

impl Drive {
    /// Number of drives.
    pub(super) fn len(&self) -> usize {
        self.range.as_ref().map_or(1, Range::len)
    }

    /// What the order of elimination must know of each.
    pub(super) fn topology(&self, joints: &[Joint]) -> impl Iterator<Item = JointTopology> {
        let [first, second] = &self.of.of(joints).ends;
        self.of.elements.iter().map(move |element| JointTopology {
            rows: 1,
            holds_point: false,
            ends: [first.body(*element), second.body(*element)],
        })
    }

    /// The name of each.
    pub(super) fn names(&self) -> Vec<String> {
        self.range.as_ref().map_or_else(|| vec![self.name.to_string()], |range| range.names(&self.name))
    }

    /// The connection of the drive of joint `joint`'s `element`, if it is one of these.
    pub(super) fn connection(&self, joint: usize, element: usize) -> Option<usize> {
        let found = self.of.elements.iter().position(|own| *own == element);
        found.filter(|_| self.of.joint == joint).map(|k| self.first + k)
    }

    /// Whether a joint is driven by both in the same way.
    fn meets(&self, joint: &NamedJoint, type_name: &str) -> bool {
        let same = |element: &usize| joint.elements.contains(element);
        self.of.joint == joint.joint && self.type_name == type_name && self.of.elements.iter().any(same)
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
    if !KINDS.iter().any(|kind| call.kind == kind) {
        let message = format!("unknown kind of drive `{}`, expected one of: {}", call.kind, KINDS.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    }
    for error in call.check_options(&["polynomial", "function"]) {
        mistakes.push(error);
    }
    let [argument] = mistakes.keep(call.arguments("one joint"))?;
    let of = mistakes.keep(NamedJoint::find(argument, joints, range.as_ref()))?;
    let found = of.of(joints);
    let is_angle = call.kind == KINDS[0];
    if !(if is_angle { found.known.has_angle } else { found.known.has_travel }) {
        let message = format!(
            "the {} of `{}`, a {} joint, cannot be driven: `angle` is for revolute and cylindrical joints, `position` for prismatic, cylindrical and in_line ones",
            call.kind, found.name, found.known.name
        );
        mistakes.add(argument.span, message);
        return None;
    }
    let type_name = if is_angle { "Angle" } else { "Travel" };
    let twice =
        |elements: &[usize]| elements.iter().enumerate().any(|(k, element)| elements[..k].contains(element));
    if twice(&of.elements) || earlier.iter().any(|other| other.meets(&of, type_name)) {
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
    Some(Drive { name, range, of, type_name, function, first: 0 })
}
