//! How the step in C follows from the parameters of a scene.

use ffrf_codegen::mechanism::{
    CompositionModel, ElementRule, JointRule, ParameterModel, ParameterPlace as Place,
};
use ffrf_host::mechanism::Drive;
use ffrf_host::scene::file::{ForceTable, JointTable, SceneFile};
use ffrf_host::scene::{Scene, SceneError};

use crate::parameter::{BodyKey, ForceKey, Parameter};
use crate::variables::{Role, Variable};

/// The composition of a scene. Errors: an input that is a formula or a table, which generated C has not.
pub(super) fn composition(
    file: &SceneFile,
    scene: &Scene,
    variables: &[Variable],
) -> Result<CompositionModel, SceneError> {
    let forces = Forces::of(file);
    let parameters = variables.iter().filter_map(|variable| match variable.role {
        Role::Parameter(parameter, start) => {
            Some(ParameterModel { place: place(parameter, file, &forces), start })
        }
        _ => None,
    });
    // a drive follows its joint
    let (mut joints, mut joint_names) = (Vec::new(), Vec::new());
    for (name, table) in &file.joints {
        joint_names.push((name.as_str(), joints.len()));
        let joint = joints.len();
        joints.push(joint_rule(table));
        if table.drive.is_some() {
            joints.push(JointRule::As(joint));
        }
    }
    let joint_of = |table: &ForceTable| {
        let name = table.joint.as_deref()?;
        joint_names.iter().find(|(known, _)| *known == name).map(|(_, joint)| *joint)
    };
    let (mut elements, mut actuators) = (Vec::new(), Vec::new());
    for (_, table) in &file.forces {
        if table.kind == "actuator" {
            actuators.push(joint_of(table));
        } else {
            elements.push(element_rule(table, joint_of(table)));
        }
    }
    let schedules =
        scene.actuator_names.iter().zip(scene.mechanism.actuators()).map(|(name, actuator)| match &actuator
            .input
        {
            Drive::Polynomial(coefficients) => Ok(coefficients.clone()),
            Drive::Formula(_) | Drive::Table(_) => Err(SceneError::Key {
                key: format!("forces.{name}.input"),
                message: "expected coefficients of a polynomial in generated C, found a formula or a table"
                    .to_owned(),
            }),
        });
    Ok(CompositionModel {
        parameters: parameters.collect(),
        joints,
        elements,
        actuators,
        schedules: schedules.collect::<Result<_, _>>()?,
    })
}

/// For each force of the file, which of the elements or actuators it is.
struct Forces(Vec<usize>);

impl Forces {
    fn of(file: &SceneFile) -> Self {
        let (mut elements, mut actuators) = (0, 0);
        let numbers = file.forces.iter().map(|(_, table)| {
            let count = if table.kind == "actuator" { &mut actuators } else { &mut elements };
            *count += 1;
            *count - 1
        });
        Self(numbers.collect())
    }
}

fn place(parameter: Parameter, file: &SceneFile, forces: &Forces) -> Option<Place> {
    match parameter {
        Parameter::Gravity(k) => Some(Place::Gravity(k)),
        // the caller of the step says how long it is
        Parameter::Step | Parameter::Tolerance => None,
        Parameter::Body(body, key, k) => Some(match key {
            BodyKey::Position => Place::Position(body, k),
            BodyKey::Orientation => Place::Orientation(body, k),
            BodyKey::Velocity => Place::Velocity(body, k),
            BodyKey::AngularVelocity => Place::AngularVelocity(body, k),
            BodyKey::ModalCoordinates => Place::ModalCoordinate(body, k),
            BodyKey::ModalRates => Place::ModalRate(body, k),
        }),
        Parameter::Force(force, key, k) => {
            let kind = file.forces.get(force)?.1.kind.as_str();
            let number = *forces.0.get(force)?;
            match (key, kind) {
                (ForceKey::Stiffness, _) => Some(Place::Stiffness(number, 0)),
                (ForceKey::Damping, _) => Some(Place::Damping(number, 0)),
                (ForceKey::StiffnessMatrix, _) => Some(Place::Stiffness(number, k)),
                (ForceKey::DampingMatrix, _) => Some(Place::Damping(number, k)),
                (ForceKey::Rest, "spring") => Some(Place::RestLength(number)),
                (ForceKey::Rest, _) => Some(Place::RestAngle(number)),
                (ForceKey::Limit, "actuator") => Some(Place::Limit(number)),
                (ForceKey::Limit, _) => Some(Place::Stiffness(number, 0)),
                (ForceKey::Speed, _) => Some(Place::Speed(number)),
                (ForceKey::Gain, _) => Some(Place::Gain(number)),
                (ForceKey::Value, "force") => Some(Place::Wrench(number, k)),
                (ForceKey::Value, _) => Some(Place::Wrench(number, 3 + k)),
                // friction that follows reactions is refused before
                (ForceKey::Coefficient | ForceKey::Radius, _) => None,
            }
        }
    }
}

fn joint_rule(table: &JointTable) -> JointRule {
    match table.kind.as_str() {
        "universal" if table.second_axis.is_some() => JointRule::Nothing,
        "universal" => JointRule::SecondAxis,
        "distance" if table.length.is_none() => JointRule::Length,
        kind => JointRule::SecondTriad {
            turns: !["fixed", "prismatic", "constant_orientation", "generic"].contains(&kind),
        },
    }
}

fn element_rule(table: &ForceTable, joint: Option<usize>) -> ElementRule {
    match (table.kind.as_str(), joint) {
        ("spring", _) if table.rest.is_none() => ElementRule::RestLength,
        ("torsion_spring", _) => ElementRule::Turn { rest: table.rest.is_none() },
        (_, Some(joint)) => ElementRule::As(joint),
        _ => ElementRule::Nothing,
    }
}
