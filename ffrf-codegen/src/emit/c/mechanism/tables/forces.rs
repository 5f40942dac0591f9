//! Force elements, actuators and sensors.

use std::fmt::Write as _;

use super::Numbers;
use super::numbers::{attachment, integers, table};
use crate::ScalarType;
use crate::emit::c::mechanism::MechanismSubject;
use crate::emit::c::text::braced;
use crate::mechanism::{
    ActuatorModel, AttachmentModel, EffortModel, ElementKindModel, ElementModel, SensorKindModel,
};

fn effort_name(effort: EffortModel) -> &'static str {
    match effort {
        EffortModel::About => "ABOUT",
        EffortModel::Along => "ALONG",
        EffortModel::Line => "LINE",
    }
}

/// Force elements and actuators.
pub(super) fn forces(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let both = |ends: &[AttachmentModel; 2]| {
        format!("{{{},\n  {}}}", attachment(&ends[0], numbers), attachment(&ends[1], numbers))
    };
    let element = |ElementModel { kind, ends }: &ElementModel| {
        let (mut first, mut second, mut rest, mut option) = ([0.0; 6], [0.0; 6], 0.0, "0");
        let name = match kind {
            ElementKindModel::Spring([stiffness, damping, length]) => {
                (first[0], second[0], rest) = (*stiffness, *damping, *length);
                "SPRING"
            }
            ElementKindModel::TorsionSpring([stiffness, damping, angle]) => {
                (first[0], second[0], rest) = (*stiffness, *damping, *angle);
                "TORSION_SPRING"
            }
            ElementKindModel::Bushing { stiffness, damping } => {
                (first, second) = (*stiffness, *damping);
                "BUSHING"
            }
            ElementKindModel::Constant { wrench, turns: turning } => {
                (first, option) = (*wrench, if *turning { "1" } else { "0" });
                "CONSTANT"
            }
            ElementKindModel::Friction { effort, limit, speed, viscous } => {
                (first[0], second[0], rest, option) = (*limit, *viscous, *speed, effort_name(*effort));
                "FRICTION"
            }
        };
        format!(
            "{{{name}, {},\n {}, {}, {}, {}}}",
            both(ends),
            numbers.list(&first),
            numbers.list(&second),
            numbers.one(rest),
            option
        )
    };
    let actuator = |ActuatorModel { effort, gain, limit, ends, .. }: &ActuatorModel| {
        let name = effort_name(*effort);
        let most = if numbers.scalar == ScalarType::F32 { f64::from(f32::MAX) } else { f64::MAX };
        let (gain, limit) = (numbers.one(*gain), numbers.one(limit.min(most)));
        format!("{{{name}, {},\n {gain}, {limit}}}", both(ends))
    };
    let mut text =
        table("element", "elements", &subject.model.elements.iter().map(element).collect::<Vec<_>>());
    text.push_str(&table(
        "actuator",
        "actuators",
        &subject.model.actuators.iter().map(actuator).collect::<Vec<_>>(),
    ));
    if !subject.soft.is_empty() {
        let list = integers(subject.soft);
        let _ = writeln!(text, "static const int soft_elements[{}] = {};\n", list.len(), braced(&list));
    }
    text
}

/// Sensors.
pub(super) fn sensors(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let mut first = 0;
    let mut list = Vec::new();
    for sensor in &subject.model.sensors {
        let (kind, at, link, count) = match &sensor.kind {
            SensorKindModel::Position(at) => ("POSITION", at, 0, 0),
            SensorKindModel::Velocity(at) => ("VELOCITY", at, 0, 0),
            SensorKindModel::Acceleration(at) => ("ACCELERATION", at, 0, 0),
            SensorKindModel::Orientation(at) => ("ORIENTATION", at, 0, 0),
            SensorKindModel::Turn(link) => ("TURN", &AttachmentModel::GROUND, *link, 1),
            SensorKindModel::ReactionForce(link, count) => {
                ("REACTION_FORCE", &AttachmentModel::GROUND, *link, *count)
            }
            SensorKindModel::ReactionMoment(link, count) => {
                ("REACTION_MOMENT", &AttachmentModel::GROUND, *link, *count)
            }
        };
        list.push(format!("{{{kind}, {first}, {}, {link}, {count}}}", attachment(at, numbers)));
        first += sensor.kind.width();
    }
    table("sensor", "sensors", &list)
}
