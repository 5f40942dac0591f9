//! A scene as plain numbers, for the generator of its time step in C.

use ffrf_codegen::mechanism::{
    ActuatorModel, AttachmentModel, BodyKind, BodyModel, EffortModel, ElementKindModel, ElementModel,
    FlexibleModel, JointModel, MarkerModel, MechanismModel, RelationModel, SensorKindModel, SensorModel,
    StepMethod,
};
use ffrf_runtime::forces::{Effort, Frame};
use ffrf_runtime::joints::JointKind;
use ffrf_runtime::mechanism::{Assembly, Attachment, Treatment};
use ffrf_runtime::{FlexibleBody, ModalMatrix, State, rotation};
use nalgebra::Vector3;

use super::{Coordinates, Integrator, Scene, SceneError, SceneModel, SensorKind, StepChoice};
use crate::mechanism::{Drive, ElementKind};
use crate::{HostBody, HostModal};

impl Scene {
    /// The scene as plain numbers, with its joints met. `source_name`: the name of its file.
    ///
    /// Errors: what generated C does not have is named; the scene cannot be assembled.
    pub fn mechanism_model(&self, source_name: &str) -> Result<MechanismModel, SceneError> {
        let method = self.method_in_c()?;
        let Treatment::Projection { iterations, tolerance } = self.settings.treatment else {
            return Err(refused("simulation.constraints", "`projection`", "another treatment"));
        };
        self.check_for_c()?;
        let StepChoice::Fixed(step) = self.settings.step else {
            return Err(refused(
                "simulation",
                "a fixed `step` and `constraints = \"projection\"`",
                "other ones",
            ));
        };
        let (initial, _) = self.assembled()?;
        let mut markers = Markers { scene: self, used: Vec::new() };
        let joints = self.joint_models(&mut markers)?;
        let elements = self.mechanism.elements().iter();
        let elements = elements.map(|element| ElementModel {
            kind: element_kind(&element.kind),
            ends: [&element.first, &element.second].map(|end| markers.attachment(end)),
        });
        let elements: Vec<ElementModel> = elements.collect();
        let actuators = self.mechanism.actuators().iter().zip(&self.actuator_names);
        let actuators = actuators.map(|(actuator, name)| ActuatorModel {
            name: name.clone(),
            effort: effort(actuator.effort),
            gain: actuator.gain,
            limit: actuator.limit,
            ends: [&actuator.first, &actuator.second].map(|end| markers.attachment(end)),
        });
        let actuators = actuators.collect();
        let sensors = self.sensors.iter().map(|sensor| {
            let kind = sensor_kind(&sensor.name, &sensor.kind, &mut markers)?;
            Ok(SensorModel { name: sensor.name.clone(), kind })
        });
        let sensors = sensors.collect::<Result<_, SceneError>>()?;
        let bodies = self.mechanism.bodies().iter().zip(&self.models).zip(&self.body_names).zip(&initial);
        Ok(MechanismModel {
            source_name: source_name.to_owned(),
            bodies: bodies
                .map(|(((body, model), name), state)| body_model(name, body, model, state))
                .collect(),
            markers: markers.models(),
            joints,
            elements,
            actuators,
            sensors,
            gravity: self.mechanism.gravity().into(),
            method,
            step,
            corrections: iterations,
            tolerance,
            composition: None,
        })
    }

    /// Errors: generated C has another integrator, or other coordinates.
    fn method_in_c(&self) -> Result<StepMethod, SceneError> {
        const METHODS: [(Integrator, StepMethod); 4] = [
            (Integrator::Rk4, StepMethod::Rk4),
            (Integrator::SymplecticEuler, StepMethod::SymplecticEuler),
            (Integrator::LinearlyImplicit, StepMethod::LinearlyImplicit),
            (Integrator::LinearlyImplicitEuler, StepMethod::LinearlyImplicitEuler),
        ];
        let integrator = self.settings.integrator;
        let Some((_, method)) = METHODS.iter().find(|(known, _)| *known == integrator) else {
            let names = METHODS.map(|(known, _)| known.name()).join(", ");
            return Err(refused("simulation.integrator", names, format!("`{}`", integrator.name())));
        };
        if self.settings.coordinates == Coordinates::Joint {
            return Err(refused("simulation.constraints", "`projection`", "`minimal`"));
        }
        Ok(*method)
    }

    /// Errors: something that generated C does not have.
    fn check_for_c(&self) -> Result<(), SceneError> {
        if let Some(event) = self.events.first() {
            return Err(refused("events", "none", format!("`{}`", event.name)));
        }
        if self.mechanism.friction(0).is_some() {
            return Err(refused("forces", "no friction that follows reactions", "some"));
        }
        Ok(())
    }

    fn joint_models(&self, markers: &mut Markers<'_>) -> Result<Vec<JointModel>, SceneError> {
        let named = self.connection_names.iter().zip(self.mechanism.drives()).enumerate();
        let joints = named.filter_map(|(index, (name, drive))| {
            self.mechanism.connection(index).map(|connection| (connection, name, drive))
        });
        joints
            .map(|(connection, name, drive)| {
                let drive = match drive {
                    None => None,
                    Some(Drive::Polynomial(coefficients)) => Some(coefficients.clone()),
                    Some(Drive::Formula(_) | Drive::Table(_)) => {
                        let found = "a formula or a table";
                        return Err(refused(format!("joints.{name}"), "coefficients of a polynomial", found));
                    }
                };
                Ok(JointModel {
                    name: name.clone(),
                    relations: relations(&connection.kind),
                    ends: [&connection.first, &connection.second].map(|end| markers.attachment(end)),
                    drive,
                })
            })
            .collect()
    }
}

fn refused(key: impl Into<String>, expected: impl Into<String>, found: impl ToString) -> SceneError {
    SceneError::value(key, format!("{} in generated C", expected.into()), found)
}

/// The markers that something is attached to, in the order of their first use.
struct Markers<'a> {
    scene: &'a Scene,
    used: Vec<(usize, usize)>,
}

impl Markers<'_> {
    fn attachment(&mut self, at: &Attachment<f64>) -> AttachmentModel {
        let marker = at.body.map(|body| {
            let known = self.used.iter().position(|used| *used == (body, at.marker));
            known.unwrap_or_else(|| {
                self.used.push((body, at.marker));
                self.used.len() - 1
            })
        });
        AttachmentModel {
            marker,
            position: at.position.into(),
            orientation: rotation::euler_parameters(&at.orientation),
        }
    }

    fn models(&self) -> Vec<MarkerModel> {
        let (all, bodies) = (self.scene.mechanism.markers(), self.scene.mechanism.bodies());
        let stiffness = |body: usize, number: u16| {
            let load = bodies.get(body)?.marker_load(number)?;
            // symmetric: by rows or by columns
            Some(load.each_ref().map(|matrix| matrix.as_slice().to_vec()))
        };
        let found =
            self.used.iter().filter_map(|(body, marker)| Some((*body, all.get(*body)?.get(*marker)?)));
        let rows = |rows: &[HostModal; 3]| rows.each_ref().map(|row| row.0.as_slice().to_vec());
        found
            .map(|(body, marker)| MarkerModel {
                body,
                position: marker.position.into(),
                translation: rows(&marker.translation),
                rotation: rows(&marker.rotation),
                load_stiffness: marker.stressing.and_then(|number| stiffness(body, number)),
            })
            .collect()
    }
}

fn body_model(
    name: &str,
    body: &HostBody,
    model: &Option<SceneModel>,
    state: &State<HostModal>,
) -> BodyModel {
    let flexible = model.as_ref().filter(|_| body.mode_count() > 0);
    let kind = match flexible {
        Some(SceneModel { model, fidelity }) => {
            let matrices = [body.modal_mass(), body.stiffness(), body.damping()];
            let is_diagonal = matrices.iter().all(|matrix| matches!(matrix, ModalMatrix::Diagonal(_)));
            // symmetric: by rows or by columns
            let [modal_mass, stiffness, damping] = matrices.map(|matrix| matrix.dense().as_slice().to_vec());
            BodyKind::Flexible(Box::new(FlexibleModel {
                model: model.clone(),
                fidelity: fidelity.clone(),
                is_diagonal,
                modal_mass,
                stiffness,
                damping,
            }))
        }
        None => {
            let none = body.undeformed();
            let prepared = body.prepare(&none, &Vector3::zeros(), &none);
            let mut inertia = [0.0; 9];
            inertia.copy_from_slice(prepared.inertia.as_slice());
            BodyKind::Rigid { mass: prepared.mass, first_moment: prepared.first_moment.into(), inertia }
        }
    };
    BodyModel {
        name: name.to_owned(),
        kind,
        position: state.position.into(),
        orientation: rotation::euler_parameters(&state.orientation),
        modal_coordinates: state.modal_coordinates.0.as_slice().to_vec(),
        velocity: state.velocity.into(),
        angular_velocity: state.angular_velocity.into(),
        modal_rates: state.modal_rates.0.as_slice().to_vec(),
    }
}

/// What the joints are composed of, as in the runtime's `joints`.
fn relations(kind: &JointKind) -> Vec<RelationModel> {
    use RelationModel::{Aligned, Angle, Coincident, InPlane, Perpendicular};
    const ALL: [bool; 3] = [true; 3];
    const ACROSS: [bool; 3] = [true, true, false];
    const ALONG: [bool; 3] = [false, false, true];
    match kind {
        JointKind::Angle(_) => vec![Angle],
        JointKind::ConstantOrientation(_) => vec![Aligned(ALL)],
        JointKind::Cylindrical(_) => vec![InPlane(ACROSS), Perpendicular(ACROSS)],
        JointKind::Distance(distance) => vec![RelationModel::Distance(distance.length)],
        JointKind::Fixed(_) => vec![Coincident, Aligned(ALL)],
        JointKind::Generic(generic) => {
            let held = [InPlane(generic.translation), Aligned(generic.rotation)];
            held.into_iter().filter(|relation| relation.rows() > 0).collect()
        }
        JointKind::InLine(_) => vec![InPlane(ACROSS)],
        JointKind::InPlane(_) | JointKind::Travel(_) => vec![InPlane(ALONG)],
        JointKind::Planar(_) => vec![InPlane(ALONG), Perpendicular(ACROSS)],
        JointKind::Prismatic(_) => vec![InPlane(ACROSS), Aligned(ALL)],
        JointKind::Revolute(_) => vec![Coincident, Perpendicular(ACROSS)],
        JointKind::Spherical(_) => vec![Coincident],
        JointKind::Universal(_) => vec![Coincident, Perpendicular(ALONG)],
    }
}

fn effort(effort: Effort) -> EffortModel {
    match effort {
        Effort::About => EffortModel::About,
        Effort::Along => EffortModel::Along,
        Effort::Line => EffortModel::Line,
    }
}

fn element_kind(kind: &ElementKind) -> ElementKindModel {
    match kind {
        ElementKind::Spring(spring) => {
            ElementKindModel::Spring([spring.stiffness, spring.damping, spring.rest_length])
        }
        ElementKind::TorsionSpring(spring) => {
            ElementKindModel::TorsionSpring([spring.stiffness, spring.damping, spring.rest_angle])
        }
        ElementKind::Bushing(bushing) => {
            ElementKindModel::Bushing { stiffness: bushing.stiffness, damping: bushing.damping }
        }
        ElementKind::Friction(friction) => ElementKindModel::Friction {
            effort: effort(friction.effort),
            limit: friction.limit,
            speed: friction.speed,
            viscous: friction.viscous,
        },
        ElementKind::Constant(constant) => {
            let (force, moment) = (&constant.force, &constant.moment);
            ElementKindModel::Constant {
                wrench: [force.x, force.y, force.z, moment.x, moment.y, moment.z],
                turns: constant.frame == Frame::Body,
            }
        }
    }
}

fn sensor_kind(
    name: &str,
    kind: &SensorKind,
    markers: &mut Markers<'_>,
) -> Result<SensorKindModel, SceneError> {
    // a joint and its drive follow each other
    let first = |joints: &[usize]| (joints.first().copied().unwrap_or(0), joints.len());
    Ok(match kind {
        SensorKind::Position(at) => SensorKindModel::Position(markers.attachment(at)),
        SensorKind::Velocity(at) => SensorKindModel::Velocity(markers.attachment(at)),
        SensorKind::Acceleration(at) => SensorKindModel::Acceleration(markers.attachment(at)),
        SensorKind::Orientation(at) => SensorKindModel::Orientation(markers.attachment(at)),
        SensorKind::Angle(joint) => SensorKindModel::Turn(*joint),
        SensorKind::ReactionForce(joints) => {
            let (joint, count) = first(joints);
            SensorKindModel::ReactionForce(joint, count)
        }
        SensorKind::ReactionMoment(joints) => {
            let (joint, count) = first(joints);
            SensorKindModel::ReactionMoment(joint, count)
        }
        SensorKind::Stress { .. } => {
            return Err(refused(format!("sensors.{name}"), "another kind of sensor", "a stress"));
        }
        SensorKind::SectionForce { .. } => {
            return Err(refused(format!("sensors.{name}"), "another kind of sensor", "a section force"));
        }
    })
}
