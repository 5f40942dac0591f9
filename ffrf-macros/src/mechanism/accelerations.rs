//! The keys `accelerations`, `projection` and those of implicit steps: functions that were printed for the mechanism, and what they
//! cannot know of.

use syn::{Ident, Path};

use super::controls::Control;
use super::forces::{Force, Nature};
use super::scalar::Scalar;
use crate::parse::Field;
use crate::values::Mistakes;

/// The path of the function under a key.
pub(super) fn accelerations(field: &Field, scalar: Scalar, mistakes: &mut Mistakes) -> Option<Path> {
    let key = &field.key;
    if scalar == Scalar::Generic {
        let message = format!("`{key}` is a function of f64 or f32: it does not go with `scalar: generic`");
        mistakes.add(field.key.span(), message);
    }
    let path = syn::parse2(field.value.clone()).map_err(|_| {
        let message = format!("`{key}` must be the path of a function, found `{}`", field.value);
        syn::Error::new(field.span, message)
    });
    mistakes.keep(path)
}

/// Reports what a function with numbers of its own, the one under `key`, cannot follow.
pub(super) fn check_known(
    key: &Ident,
    constraints: Option<&Field>,
    controls: &[Control],
    forces: &[Force],
    mistakes: &mut Mistakes,
) {
    if let Some(field) = constraints
        && field.value.to_string().starts_with("baumgarte")
    {
        let message =
            format!("the function of `{key}` keeps the joints as they are: it has no gains of `baumgarte`");
        mistakes.add(field.span, message);
    }
    for Control { name, .. } in controls {
        let message =
            format!("the function of `{key}` cannot know of the control `{name}`, which may change");
        mistakes.add(name.span(), message);
    }
    for Force { name, nature, .. } in forces {
        let what = match nature {
            Nature::User { .. } => "a function of your own",
            Nature::Friction { .. } | Nature::Element { type_name: "Friction", .. } => "friction",
            Nature::Element { type_name: "Actuator", .. } => "an actuator, whose inputs may change",
            Nature::Element { .. } => continue,
        };
        let message = format!("the function of `{key}` cannot know of `{name}`, {what}");
        mistakes.add(name.span(), message);
    }
}
