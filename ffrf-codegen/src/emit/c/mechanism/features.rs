//! What a mechanism has, by the names that the solver's text knows.

use std::collections::BTreeSet;

use super::MechanismSubject;
use crate::mechanism::{BodyKind, ElementKindModel, RelationModel, SensorKindModel, SensorModel, StepMethod};

/// The features of a mechanism.
pub(super) fn of(subject: &MechanismSubject<'_>) -> BTreeSet<&'static str> {
    let model = subject.model;
    let mut features = BTreeSet::new();
    for body in &model.bodies {
        features.insert(match body.kind {
            BodyKind::Rigid { .. } => "RIGID",
            BodyKind::Flexible(_) => "FLEXIBLE",
        });
    }
    for relation in model.joints.iter().flat_map(|joint| &joint.relations) {
        features.extend(match relation {
            RelationModel::Coincident => [].as_slice(),
            RelationModel::InPlane(_) => &["IN_PLANE"],
            RelationModel::Perpendicular(_) => &["PERPENDICULAR"],
            RelationModel::Aligned(_) => &["ALIGNED", "RELATIVE"],
            RelationModel::Distance(_) => &["DISTANCE"],
            RelationModel::Angle => &["ANGLE", "PERPENDICULAR"],
        });
    }
    for element in &model.elements {
        features.extend(match element.kind {
            ElementKindModel::Spring(_) => ["SPRING"].as_slice(),
            ElementKindModel::TorsionSpring(_) => &["TORSION_SPRING", "TURN"],
            ElementKindModel::Bushing { .. } => &["BUSHING", "RELATIVE"],
            ElementKindModel::Constant { .. } => &["CONSTANT"],
            ElementKindModel::Friction { .. } => &["FRICTION", "EFFORT"],
        });
    }
    let turn = model.sensors.iter().any(|sensor| matches!(sensor.kind, SensorKindModel::Turn(_)));
    let is_turning = |element: &usize| {
        matches!(
            model.elements.get(*element).map(|element| &element.kind),
            Some(ElementKindModel::TorsionSpring(_) | ElementKindModel::Bushing { .. })
        )
    };
    let turning = subject.soft.iter().any(is_turning);
    let gradients = |relation: &RelationModel| !matches!(relation, RelationModel::Coincident);
    let mut relations = model.joints.iter().flat_map(|joint| &joint.relations);
    let is_reaction = |sensor: &SensorModel| {
        matches!(sensor.kind, SensorKindModel::ReactionForce(..) | SensorKindModel::ReactionMoment(..))
    };
    let implicit = model.method.is_implicit();
    features.extend(
        [
            ("TURN", turn),
            ("GRADIENTS", relations.any(gradients) || !subject.soft.is_empty()),
            ("DRIVES", model.joints.iter().any(|joint| joint.drive.is_some())),
            ("ELEMENTS", !model.elements.is_empty()),
            ("EFFORT", !model.actuators.is_empty()),
            ("ACTUATORS", !model.actuators.is_empty()),
            ("PARAMETERS", model.composition.is_some()),
            ("CONSTANT_TABLES", model.composition.is_none()),
            ("SCHEDULES", model.composition.is_some() && !model.actuators.is_empty()),
            ("FORCES", !(model.elements.is_empty() && model.actuators.is_empty())),
            ("SENSORS", !model.sensors.is_empty()),
            ("REACTION", model.sensors.iter().any(is_reaction)),
            ("LOOPS", subject.has_loops),
            ("SHARED", !subject.plan.shared.is_empty()),
            ("SOFT", !subject.soft.is_empty()),
            ("TURNING", turning),
            ("NOT_TURNING", !turning),
            ("IMPLICIT", implicit),
            ("EXPLICIT", !implicit),
            ("STRESSED", model.has_loaded_markers()),
            ("RK4", model.method == StepMethod::Rk4),
            ("LINEARLY_IMPLICIT", model.method == StepMethod::LinearlyImplicit),
            (
                "EULER",
                matches!(model.method, StepMethod::SymplecticEuler | StepMethod::LinearlyImplicitEuler),
            ),
        ]
        .iter()
        .filter(|(_, has)| *has)
        .map(|(name, _)| *name),
    );
    features
}
