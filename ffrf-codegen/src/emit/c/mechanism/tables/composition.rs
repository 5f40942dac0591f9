//! Where parameters go, and what joints and forces take from the initial state.

use std::fmt::Write as _;

use super::Numbers;
use super::numbers::table;
use crate::emit::c::mechanism::MechanismSubject;
use crate::mechanism::{CompositionModel, ElementRule, JointRule, ParameterModel, ParameterPlace};

/// The tables of a composition; nothing where all numbers are constants.
pub(super) fn composition(subject: &MechanismSubject<'_>, numbers: &Numbers) -> String {
    let Some(composition) = &subject.model.composition else { return String::new() };
    let CompositionModel { parameters, joints, elements, actuators, schedules } = composition;
    let mut text = String::from(
        "/* Where a parameter goes: what it is, of which body, element or actuator, and which component. */\n\
         typedef struct {\n    int kind;\n    int index;\n    int entry;\n} parameter_place;\n\n\
         /* What something takes from the initial state, and the joint whose ends it has. */\n\
         typedef struct {\n    int kind;\n    int joint;\n} rule;\n\n",
    );
    let or_none = |list: Vec<String>, none: &str| if list.is_empty() { vec![none.to_owned()] } else { list };
    let places = parameters.iter().map(place).collect();
    text.push_str(&table("parameter_place", "parameter_places", &or_none(places, "{0, 0, 0}")));
    let starts: Vec<f64> = parameters.iter().map(|parameter| parameter.start).collect();
    let starts = if starts.is_empty() { vec![0.0] } else { starts };
    let _ = write!(
        text,
        "/* The parameters that the other tables are printed for. */\n\
         static const real parameter_starts[{}] = {};\n\n",
        starts.len(),
        numbers.list(&starts)
    );
    let none = "{RULE_NOTHING, 0}";
    let rules = joints.iter().map(joint_rule).collect();
    text.push_str(&table("rule", "joint_rules", &or_none(rules, none)));
    text.push_str(&table("rule", "element_rules", &elements.iter().map(element_rule).collect::<Vec<_>>()));
    let rules = actuators.iter().map(|joint| joint.map_or_else(|| none.to_owned(), as_joint));
    text.push_str(&table("rule", "actuator_rules", &rules.collect::<Vec<_>>()));
    if !schedules.is_empty() {
        text.push_str(
            "/* The polynomial of an input that is not set. */\ntypedef struct {\n    int first;\n    int count;\n} schedule;\n\n",
        );
        let mut coefficients = Vec::new();
        let mut places = Vec::new();
        for schedule in schedules {
            places.push(format!("{{{}, {}}}", coefficients.len(), schedule.len()));
            coefficients.extend_from_slice(schedule);
        }
        text.push_str(&table("schedule", "schedules", &places));
        // C has no empty tables
        coefficients.extend(coefficients.is_empty().then_some(0.0));
        let _ = write!(
            text,
            "static const real schedule_coefficients[{}] = {};\n\n",
            coefficients.len(),
            numbers.list(&coefficients)
        );
    }
    text
}

fn place(parameter: &ParameterModel) -> String {
    use ParameterPlace as P;
    let (kind, index, entry) = match parameter.place {
        None => ("NOTHING", 0, 0),
        Some(P::Gravity(entry)) => ("GRAVITY", 0, entry),
        Some(P::Position(body, entry)) => ("POSITION", body, entry),
        Some(P::Orientation(body, entry)) => ("ORIENTATION", body, entry),
        Some(P::Velocity(body, entry)) => ("VELOCITY", body, entry),
        Some(P::AngularVelocity(body, entry)) => ("ANGULAR_VELOCITY", body, entry),
        Some(P::ModalCoordinate(body, entry)) => ("COORDINATE", body, entry),
        Some(P::ModalRate(body, entry)) => ("RATE", body, entry),
        Some(P::Stiffness(element, entry)) => ("STIFFNESS", element, entry),
        Some(P::Damping(element, entry)) => ("DAMPING", element, entry),
        Some(P::RestLength(element)) => ("REST_LENGTH", element, 0),
        Some(P::RestAngle(element)) => ("REST_ANGLE", element, 0),
        Some(P::Speed(element)) => ("SPEED", element, 0),
        Some(P::Wrench(element, entry)) => ("WRENCH", element, entry),
        Some(P::Gain(actuator)) => ("GAIN", actuator, 0),
        Some(P::Limit(actuator)) => ("LIMIT", actuator, 0),
    };
    format!("{{TO_{kind}, {index}, {entry}}}")
}

fn as_joint(joint: usize) -> String {
    format!("{{RULE_AS, {joint}}}")
}

fn joint_rule(rule: &JointRule) -> String {
    let kind = match rule {
        JointRule::SecondTriad { turns: true } => "TURNING",
        JointRule::SecondTriad { turns: false } => "HELD",
        JointRule::SecondAxis => "AXIS",
        JointRule::Length => "LENGTH",
        JointRule::As(joint) => return as_joint(*joint),
        JointRule::Nothing => "NOTHING",
    };
    format!("{{RULE_{kind}, 0}}")
}

fn element_rule(rule: &ElementRule) -> String {
    let kind = match rule {
        ElementRule::RestLength => "LENGTH",
        ElementRule::Turn { rest: true } => "TURNING",
        ElementRule::Turn { rest: false } => "HELD",
        ElementRule::As(joint) => return as_joint(*joint),
        ElementRule::Nothing => "NOTHING",
    };
    format!("{{RULE_{kind}, 0}}")
}
