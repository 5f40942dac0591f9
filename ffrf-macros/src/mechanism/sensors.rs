//! What is measured.

use proc_macro2::TokenStream;
use quote::quote;
use syn::Ident;

use super::bodies::Body;
use super::call::{Entry, Range};
use super::drives::Drive;
use super::ends::end;
use super::joints::Joint;
use super::named_joint::NamedJoint;
use super::scalar::Scalar;
use crate::values::Mistakes;

/// A sensor, or one for each index of a range.
pub(super) struct Sensor {
    pub(super) name: Ident,
    pub(super) range: Option<Range>,
    pub(super) measured: Measured,
}

/// What a sensor measures.
pub(super) enum Measured {
    /// The place or motion of an attachment: `position`, `velocity` or `orientation`.
    Motion { field: Ident, at: TokenStream },
    /// The acceleration of an attachment.
    Acceleration { at: TokenStream },
    /// The angle of each joint.
    Angle { connections: Vec<usize> },
    /// Force or moment of each joint and its drives.
    Reaction { field: &'static str, connections: Vec<Vec<usize>> },
}

const KINDS: [&str; 7] =
    ["position", "velocity", "acceleration", "orientation", "angle", "reaction_force", "reaction_moment"];

/// The sensor of an entry.
pub(super) fn sensor(
    entry: Entry,
    bodies: &mut [Body],
    joints: &[Joint],
    drives: &[Drive],
    scalar: &Scalar,
    mistakes: &mut Mistakes,
) -> Option<Sensor> {
    let Entry { name, range, call } = entry;
    let kind = call.kind.to_string();
    if !KINDS.contains(&kind.as_str()) {
        let message = format!("unknown kind of sensor `{kind}`, expected one of: {}", KINDS.join(", "));
        mistakes.add(call.kind.span(), message);
        return None;
    }
    for error in call.check_options(&[]) {
        mistakes.push(error);
    }
    let of_joint = kind == "angle" || kind.starts_with("reaction");
    let expected = if of_joint { "one joint" } else { "one end" };
    let [argument] = mistakes.keep(call.arguments(expected))?;
    if !of_joint {
        let t = scalar.name();
        let at = mistakes.keep(end(argument, bodies, range.as_ref()))?;
        let straight = quote! { ::ffrf::nalgebra::UnitQuaternion::<#t>::identity() };
        let at = at.attachment(bodies, scalar, &straight);
        let measured = match kind.as_str() {
            "acceleration" => Measured::Acceleration { at },
            _ => Measured::Motion { field: call.kind, at },
        };
        return Some(Sensor { name, range, measured });
    }
    let joint = mistakes.keep(NamedJoint::find(argument, joints, range.as_ref()))?;
    let found = joint.of(joints);
    let measured = match kind.as_str() {
        "angle" if !found.known.has_angle => {
            let message = format!(
                "`{}`, a {} joint, has no angle: revolute and cylindrical joints have one",
                found.name, found.known.name
            );
            mistakes.add(argument.span, message);
            return None;
        }
        "angle" => Measured::Angle { connections: joint.connections(joints) },
        _ => {
            let with_drives = |(element, connection): (&usize, usize)| {
                let of_drives = drives.iter().filter_map(|drive| drive.connection(joint.joint, *element));
                std::iter::once(connection).chain(of_drives).collect()
            };
            let connections = joint.elements.iter().zip(joint.connections(joints)).map(with_drives).collect();
            let field = if kind == "reaction_force" { "force" } else { "moment" };
            Measured::Reaction { field, connections }
        }
    };
    Some(Sensor { name, range, measured })
}
