//! Force elements.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::axis::Axes;
use super::bodies::Body;
use super::call::{Call, Entry};
use super::drives::find;
use super::ends::{End, end};
use super::joints::Joint;
use super::scalar::Scalar;
use crate::values::Mistakes;

/// A force element.
pub(super) struct Force {
    pub(super) name: Ident,
    /// Its type in `ffrf::forces`.
    pub(super) type_name: &'static str,
    /// The element as an expression.
    pub(super) kind: TokenStream,
    /// Both attachments as expressions.
    pub(super) attachments: [TokenStream; 2],
}

/// Name, type, options.
const KINDS: [(&str, &str, &[&str]); 6] = [
    ("spring", "Spring", &["stiffness", "damping", "rest_length"]),
    ("torsion_spring", "TorsionSpring", &["stiffness", "damping", "rest_angle", "axis"]),
    ("bushing", "Bushing", &["stiffness", "damping", "axis"]),
    ("force", "ConstantWrench", &["value", "frame"]),
    ("moment", "ConstantWrench", &["value", "frame"]),
    ("actuator", "Actuator", &["axis"]),
];

/// The force element of an entry.
pub(super) fn force(
    entry: Entry,
    bodies: &mut [Body],
    joints: &[Joint],
    scalar: &Scalar,
    mistakes: &mut Mistakes,
) -> Option<Force> {
    let Entry { name, range, call } = entry;
    if let Some(range) = range {
        mistakes.add(range.span, "force elements are written one by one".to_owned());
    }
    let Some((_, type_name, options)) = KINDS.iter().find(|(name, ..)| call.kind == name) else {
        let known: Vec<&str> = KINDS.iter().map(|(name, ..)| *name).collect();
        let message = format!("unknown kind of force `{}`, expected one of: {}", call.kind, known.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    };
    for error in call.check_options(options) {
        mistakes.push(error);
    }
    let attachments = attachments(&call, bodies, joints, scalar);
    let kind = kind(type_name, &call, scalar);
    let (attachments, kind) = (mistakes.keep(attachments), mistakes.keep(kind));
    Some(Force { name, type_name, kind: kind?, attachments: attachments? })
}

/// Between two ends, at a joint, or from the ground to one end.
fn attachments(
    call: &Call,
    bodies: &mut [Body],
    joints: &[Joint],
    scalar: &Scalar,
) -> syn::Result<[TokenStream; 2]> {
    let at_joint = ["torsion_spring", "bushing", "actuator"].iter().any(|kind| call.kind == kind);
    let one_end = ["force", "moment"].iter().any(|kind| call.kind == kind);
    if at_joint && call.arguments.len() == 1 {
        let [argument] = call.arguments("a joint, or two ends")?;
        let joint = &joints[find(argument, joints)?];
        if joint.range.is_some() {
            let message = format!("`{}` are several joints, a force element belongs to one", joint.name);
            return Err(syn::Error::new(argument.span, message));
        }
        if let Some(option) = call.option("axis") {
            return Err(syn::Error::new(option.key.span(), "the axis is that of the joint"));
        }
        let [first, second] = joint.axes.orientations(scalar);
        return Ok([
            joint.ends[0].attachment(bodies, scalar, &first),
            joint.ends[1].attachment(bodies, scalar, &second),
        ]);
    }
    let (first, second) = if one_end {
        let [argument] = call.arguments("one end")?;
        let second = end(argument, bodies, None)?;
        if matches!(second, End::Ground(_)) {
            return Err(syn::Error::new(argument.span, "the ground cannot be pushed"));
        }
        (End::Ground(None), second)
    } else {
        let expected = if at_joint { "a joint, or two ends" } else { "two ends" };
        let [first, second] = call.arguments(expected)?;
        (end(first, bodies, None)?, end(second, bodies, None)?)
    };
    if first.body(0) == second.body(0) {
        let message = "both ends of this element are on the same body, or on the ground";
        return Err(syn::Error::new(call.kind.span(), message));
    }
    let [one, other] = Axes::of(call, false)?.orientations(scalar);
    Ok([first.attachment(bodies, scalar, &one), second.attachment(bodies, scalar, &other)])
}

fn kind(type_name: &str, call: &Call, scalar: &Scalar) -> syn::Result<TokenStream> {
    let needed = |key: &str| {
        call.option(key)
            .map(|option| option.value.clone())
            .ok_or_else(|| syn::Error::new(call.kind.span(), format!("`{}` needs `{key}`", call.kind)))
    };
    let otherwise =
        |key: &str, value: TokenStream| call.option(key).map_or(value, |option| option.value.clone());
    let t = scalar.name();
    let forces = quote! { ::ffrf::forces };
    Ok(match type_name {
        "Spring" | "TorsionSpring" => {
            let stiffness = scalar.number(&needed("stiffness")?);
            let damping = scalar.number(&otherwise("damping", quote! { 0.0 }));
            if type_name == "Spring" {
                let rest = scalar.number(&needed("rest_length")?);
                quote! { #forces::Spring { stiffness: #stiffness, damping: #damping, rest_length: #rest } }
            } else {
                let rest = scalar.number(&otherwise("rest_angle", quote! { 0.0 }));
                quote! { #forces::TorsionSpring { stiffness: #stiffness, damping: #damping, rest_angle: #rest } }
            }
        }
        "Bushing" => {
            let stiffness = needed("stiffness")?;
            let damping = otherwise("damping", quote! { [0.0; 6] });
            let numbers = quote! { ::ffrf::generated_support::mechanism::numbers::<6, #t> };
            quote! { #forces::Bushing { stiffness: #numbers(#stiffness), damping: #numbers(#damping) } }
        }
        "ConstantWrench" => {
            let value = scalar.vector(&needed("value")?);
            let none = quote! { ::ffrf::nalgebra::Vector3::<#t>::zeros() };
            let (force, moment) = if call.kind == "force" { (value, none) } else { (none, value) };
            let frame = match call.option("frame") {
                None => quote! { Inertial },
                Some(option) => match option.value.to_string().as_str() {
                    "inertial" => quote! { Inertial },
                    "body" => quote! { Body },
                    other => {
                        let message = format!("`frame` must be `inertial` or `body`, found `{other}`");
                        return Err(syn::Error::new(option.key.span(), message));
                    }
                },
            };
            quote! { #forces::ConstantWrench { force: #force, moment: #moment, frame: #forces::Frame::#frame } }
        }
        _ => quote! { #forces::Actuator::<#t>::idle() },
    })
}
