//! The names of a mechanism and its parts in C.

use crate::CodegenError;
use crate::emit::c::snake_case;
use crate::mechanism::MechanismModel;

/// The names of a mechanism and its parts in C, in lower case.
pub(crate) struct Names {
    /// Before every name that other files see.
    pub(crate) prefix: String,
    /// Of each body.
    pub(crate) bodies: Vec<String>,
    /// Of each actuator.
    pub(super) actuators: Vec<String>,
    /// Of each sensor.
    pub(super) sensors: Vec<String>,
}

impl Names {
    /// Errors: two names of a kind are the same in C.
    pub(crate) fn of(name: &str, mechanism: &MechanismModel) -> Result<Self, CodegenError> {
        Ok(Self {
            prefix: snake_case(name),
            bodies: distinct(mechanism.bodies.iter().map(|body| &body.name))?,
            actuators: distinct(mechanism.actuators.iter().map(|actuator| &actuator.name))?,
            sensors: distinct(mechanism.sensors.iter().map(|sensor| &sensor.name))?,
        })
    }
}

fn distinct<'a>(names: impl Iterator<Item = &'a String>) -> Result<Vec<String>, CodegenError> {
    let mut found: Vec<(&String, String)> = Vec::new();
    for name in names {
        let in_c = snake_case(name);
        if let Some((other, _)) = found.iter().find(|(_, known)| *known == in_c) {
            return Err(CodegenError::SameNameInC {
                found: name.clone(),
                other: (*other).clone(),
                name: in_c,
            });
        }
        found.push((name, in_c));
    }
    Ok(found.into_iter().map(|(_, name)| name).collect())
}
