//! Force elements, friction that follows reactions, and forces of the user's own.

use ffrf_codegen::mechanism::{JointTopology, soft_row_count};
use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::axis::Axes;
use super::bodies::Body;
use super::call::{Call, Entry, Range, USER};
use super::ends::{End, end};
use super::joints::Joint;
use super::named_joint::NamedJoint;
use super::scalar::Scalar;
use crate::values::Mistakes;

/// A force, or one for each index of a range.
pub(super) struct Force {
    pub(super) name: Ident,
    pub(super) range: Option<Range>,
    pub(super) nature: Nature,
}

/// What a force is.
pub(super) enum Nature {
    /// An element between two attachments: its type in `ffrf::forces`, it and both attachments as expressions.
    Element {
        type_name: &'static str,
        kind: TokenStream,
        attachments: [TokenStream; 2],
        /// The bodies at both ends, for each index of the range.
        bodies: Vec<[Option<usize>; 2]>,
    },
    /// Friction that follows the reaction of a joint, as an expression.
    Friction { value: TokenStream },
    /// A function of the user's own.
    User { function: TokenStream },
}

/// Name, type, options.
const KINDS: [(&str, &str, &[&str]); 8] = [
    ("spring", "Spring", &["stiffness", "damping", "rest_length"]),
    ("torsion_spring", "TorsionSpring", &["stiffness", "damping", "rest_angle", "axis"]),
    ("bushing", "Bushing", &["stiffness", "damping", "axis"]),
    ("force", "ConstantWrench", &["value", "frame"]),
    ("moment", "ConstantWrench", &["value", "frame"]),
    ("actuator", "Actuator", &["axis"]),
    ("friction", "Friction", &["limit", "speed", "viscous", "acts", "axis", "coefficient", "radius"]),
    (USER, "", &[]),
];

impl Force {
    /// The number of soft rows, if implicit steps take it into their matrix.
    pub(super) fn soft_row_count(&self) -> Option<usize> {
        match &self.nature {
            Nature::Element { type_name, .. } => soft_row_count(type_name),
            Nature::Friction { .. } | Nature::User { .. } => None,
        }
    }

    /// What the order of elimination of implicit steps must know of each.
    pub(super) fn soft_links(&self) -> Vec<JointTopology> {
        match (&self.nature, self.soft_row_count()) {
            (Nature::Element { bodies, .. }, Some(rows)) => {
                bodies.iter().map(|ends| JointTopology { rows, holds_point: false, ends: *ends }).collect()
            }
            _ => Vec::new(),
        }
    }
}

/// The force of an entry.
pub(super) fn force(
    entry: Entry,
    bodies: &mut [Body],
    joints: &[Joint],
    scalar: &Scalar,
    mistakes: &mut Mistakes,
) -> Option<Force> {
    let Entry { name, range, call } = entry;
    let Some((_, type_name, options)) = KINDS.iter().find(|(name, ..)| call.kind == name) else {
        let known: Vec<&str> = KINDS.iter().map(|(name, ..)| *name).collect();
        let message = format!("unknown kind of force `{}`, expected one of: {}", call.kind, known.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    };
    for error in call.check_options(options) {
        mistakes.push(error);
    }
    let nature = if call.kind == USER {
        if let Some(range) = &range {
            mistakes.add(range.span, "a function of your own sees all bodies: write it once".to_owned());
        }
        let [function] = mistakes.keep(call.arguments("one function"))?;
        Nature::User { function: function.tokens.clone() }
    } else if call.option("coefficient").is_some() {
        Nature::Friction { value: mistakes.keep(following_friction(&call, joints, range.as_ref(), scalar))? }
    } else {
        let attachments = attachments(&call, bodies, joints, range.as_ref(), scalar);
        let kind = kind(type_name, &call, joints, range.as_ref(), scalar);
        let (attachments, kind) = (mistakes.keep(attachments), mistakes.keep(kind));
        let (attachments, bodies) = attachments?;
        Nature::Element { type_name, kind: kind?, attachments, bodies }
    };
    Some(Force { name, range, nature })
}

/// Both attachments as expressions, and the bodies at them for each index of the range.
type Attached = ([TokenStream; 2], Vec<[Option<usize>; 2]>);

/// Kinds that act in a joint, or between two ends.
fn at_joint(call: &Call) -> bool {
    ["torsion_spring", "bushing", "actuator", "friction"].iter().any(|kind| call.kind == kind)
}

/// Between two ends, at a joint, or from the ground to one end.
fn attachments(
    call: &Call,
    bodies: &mut [Body],
    joints: &[Joint],
    range: Option<&Range>,
    scalar: &Scalar,
) -> syn::Result<Attached> {
    let at_joint = at_joint(call);
    let one_end = ["force", "moment"].iter().any(|kind| call.kind == kind);
    if at_joint && call.arguments.len() == 1 {
        let [argument] = call.arguments("a joint, or two ends")?;
        let joint = NamedJoint::find(argument, joints, range)?;
        if let Some(option) = call.option("axis") {
            return Err(syn::Error::new(option.key.span(), "the axis is that of the joint"));
        }
        return Ok((joint.attachments(joints, bodies, scalar), joint.bodies(joints)));
    }
    let (first, second) = if one_end {
        let [argument] = call.arguments("one end")?;
        let second = end(argument, bodies, range)?;
        if matches!(second, End::Ground(_)) {
            return Err(syn::Error::new(argument.span, "the ground cannot be pushed"));
        }
        (End::Ground(None), second)
    } else {
        let expected = if at_joint { "a joint, or two ends" } else { "two ends" };
        let [first, second] = call.arguments(expected)?;
        (end(first, bodies, range)?, end(second, bodies, range)?)
    };
    let connected: Vec<[Option<usize>; 2]> =
        (0..range.map_or(1, Range::len)).map(|k| [first.body(k), second.body(k)]).collect();
    if connected.iter().any(|[first, second]| first == second) {
        let message = "both ends of this element are on the same body, or on the ground";
        return Err(syn::Error::new(call.kind.span(), message));
    }
    let [one, other] = Axes::of(call, false)?.orientations(scalar);
    let attachments = [first.attachment(bodies, scalar, &one), second.attachment(bodies, scalar, &other)];
    Ok((attachments, connected))
}

fn needed(call: &Call, key: &str) -> syn::Result<TokenStream> {
    call.option(key)
        .map(|option| option.value.clone())
        .ok_or_else(|| syn::Error::new(call.kind.span(), format!("`{}` needs `{key}`", call.kind)))
}

fn otherwise(call: &Call, key: &str, value: TokenStream) -> TokenStream {
    call.option(key).map_or(value, |option| option.value.clone())
}

fn kind(
    type_name: &str,
    call: &Call,
    joints: &[Joint],
    range: Option<&Range>,
    scalar: &Scalar,
) -> syn::Result<TokenStream> {
    let needed = |key: &str| needed(call, key);
    let otherwise = |key: &str, value: TokenStream| otherwise(call, key, value);
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
        "Friction" => {
            if let Some(option) = call.option("radius") {
                let message = "`radius` goes with `coefficient`: friction that follows the reaction";
                return Err(syn::Error::new(option.key.span(), message));
            }
            friction(call, joints, range, &needed("limit")?, scalar)?
        }
        _ => quote! { #forces::Actuator::<#t>::idle() },
    })
}

/// `ffrf::forces::Friction` as an expression.
fn friction(
    call: &Call,
    joints: &[Joint],
    range: Option<&Range>,
    limit: &TokenStream,
    scalar: &Scalar,
) -> syn::Result<TokenStream> {
    let (effort, limit) = (effort(call, joints, range)?, scalar.number(limit));
    let speed = scalar.number(&needed(call, "speed")?);
    let viscous = scalar.number(&otherwise(call, "viscous", quote! { 0.0 }));
    let forces = quote! { ::ffrf::forces };
    Ok(quote! {
        #forces::Friction { effort: #forces::Effort::#effort, limit: #limit, speed: #speed, viscous: #viscous }
    })
}

/// Where friction acts: as `acts` says, or on what the joint leaves free.
fn effort(call: &Call, joints: &[Joint], range: Option<&Range>) -> syn::Result<Ident> {
    let word = match call.option("acts") {
        Some(option) => match option.value.to_string().as_str() {
            "about" => "About",
            "along" => "Along",
            "line" => "Line",
            other => {
                let message = format!("`acts` must be `about`, `along` or `line`, found `{other}`");
                return Err(syn::Error::new(option.key.span(), message));
            }
        },
        None => {
            let usual = match call.arguments.as_slice() {
                [argument] => match NamedJoint::find(argument, joints, range)?.of(joints).known.name {
                    "revolute" => Some("About"),
                    "prismatic" | "in_line" => Some("Along"),
                    _ => None,
                },
                _ => None,
            };
            usual.ok_or_else(|| {
                let message = "`friction` needs `acts`: `about` or `along` the axis, or on the `line` between both ends";
                syn::Error::new(call.kind.span(), message)
            })?
        }
    };
    Ok(Ident::new(word, call.kind.span()))
}

/// Friction that follows the reaction of its joint.
fn following_friction(
    call: &Call,
    joints: &[Joint],
    range: Option<&Range>,
    scalar: &Scalar,
) -> syn::Result<TokenStream> {
    let [argument] = call.arguments("one joint, whose reaction it follows")?;
    let joint = NamedJoint::find(argument, joints, range)?.connection(joints);
    if let Some(option) = call.option("axis") {
        return Err(syn::Error::new(option.key.span(), "the axis is that of the joint"));
    }
    let kind = friction(call, joints, range, &otherwise(call, "limit", quote! { 0.0 }), scalar)?;
    let coefficient = scalar.number(&needed(call, "coefficient")?);
    let is_about = effort(call, joints, range)? == "About";
    let arm = match (call.option("radius"), is_about) {
        (Some(radius), true) => radius.value.clone(),
        (None, false) => quote! { 1.0 },
        (None, true) => {
            let message =
                "friction about an axis that follows the reaction needs the `radius` of the bearing (m)";
            return Err(syn::Error::new(call.kind.span(), message));
        }
        (Some(radius), false) => {
            let message = "`radius` is for friction about an axis";
            return Err(syn::Error::new(radius.key.span(), message));
        }
    };
    let arm = scalar.number(&arm);
    Ok(quote! {
        ::ffrf::mechanism::JointFriction { joint: #joint, kind: #kind, coefficient: #coefficient, arm: #arm }
    })
}
