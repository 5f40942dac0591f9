//! A whole mechanism as plain numbers: what its time step in C is printed from.

use ffrf_model::ReducedBody;

use super::CompositionModel;
use crate::fidelity::Fidelity;

/// A mechanism with everything that its time step depends on. SI units; Euler parameters scalar first.
#[derive(Debug, Clone, PartialEq)]
pub struct MechanismModel {
    /// Where it is from, for the banner: the name of a file.
    pub source_name: String,
    /// The bodies.
    pub bodies: Vec<BodyModel>,
    /// The markers that joints, forces and sensors use.
    pub markers: Vec<MarkerModel>,
    /// Joints and drives.
    pub joints: Vec<JointModel>,
    /// Force elements.
    pub elements: Vec<ElementModel>,
    /// Actuators.
    pub actuators: Vec<ActuatorModel>,
    /// Sensors.
    pub sensors: Vec<SensorModel>,
    /// Gravity. Shape: 3. Units: m/s². Frame: inertial.
    pub gravity: [f64; 3],
    /// How a step is done.
    pub method: StepMethod,
    /// The step that it is meant for. Units: s.
    pub step: f64,
    /// Most corrections of positions and of velocities after a step.
    pub corrections: usize,
    /// The residual of positions that a step may be left with. Units: m or rad.
    pub tolerance: f64,
    /// What the caller says when the mechanism begins; nothing if all numbers are constants.
    pub composition: Option<CompositionModel>,
}

impl MechanismModel {
    /// Whether loads stress the body at some marker, so that the rows of the marker follow the deformation.
    pub fn has_loaded_markers(&self) -> bool {
        self.markers.iter().any(|marker| marker.load_stiffness.is_some())
    }
}

/// A method of fixed cost.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum StepMethod {
    /// Classical Runge-Kutta, order 4.
    Rk4,
    /// Symplectic Euler, order 1.
    SymplecticEuler,
    /// ROS2 with modes and force elements implicit, order 2.
    LinearlyImplicit,
    /// Linearly implicit Euler, order 1.
    LinearlyImplicitEuler,
}

impl StepMethod {
    /// Whether modes and force elements are implicit.
    pub fn is_implicit(self) -> bool {
        matches!(self, Self::LinearlyImplicit | Self::LinearlyImplicitEuler)
    }
}

/// A body and where it begins.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyModel {
    /// Its name.
    pub name: String,
    /// What moves.
    pub kind: BodyKind,
    /// Position. Shape: 3. Units: m. Frame: inertial.
    pub position: [f64; 3],
    /// Euler parameters, scalar first.
    pub orientation: [f64; 4],
    /// Modal coordinates. Shape: M.
    pub modal_coordinates: Vec<f64>,
    /// Velocity. Shape: 3. Units: m/s. Frame: inertial.
    pub velocity: [f64; 3],
    /// Angular velocity. Shape: 3. Units: rad/s. Frame: body.
    pub angular_velocity: [f64; 3],
    /// Modal rates. Shape: M.
    pub modal_rates: Vec<f64>,
}

/// A body without or with modes.
#[derive(Debug, Clone, PartialEq)]
pub enum BodyKind {
    /// Mass properties about the frame origin. Frame: body.
    Rigid {
        /// Units: kg.
        mass: f64,
        /// Shape: 3. Units: kg m.
        first_moment: [f64; 3],
        /// Shape: 3 x 3, symmetric, column by column. Units: kg m².
        inertia: [f64; 9],
    },
    /// A reduced body.
    Flexible(Box<FlexibleModel>),
}

/// A reduced body with the terms that are kept of it.
#[derive(Debug, Clone, PartialEq)]
pub struct FlexibleModel {
    /// The model, with the modes that are used.
    pub model: ReducedBody,
    /// Terms of its kinetic energy.
    pub fidelity: Fidelity,
    /// Whether these three are diagonal.
    pub is_diagonal: bool,
    /// Modal mass. Shape: M x M, row by row.
    pub modal_mass: Vec<f64>,
    /// Modal stiffness. Shape: M x M, row by row.
    pub stiffness: Vec<f64>,
    /// Modal damping. Shape: M x M, row by row.
    pub damping: Vec<f64>,
}

impl BodyKind {
    /// Number of modes.
    pub fn mode_count(&self) -> usize {
        match self {
            Self::Rigid { .. } => 0,
            Self::Flexible(flexible) => flexible.model.mode_count(),
        }
    }
}

/// A point of a body.
#[derive(Debug, Clone, PartialEq)]
pub struct MarkerModel {
    /// The body.
    pub body: usize,
    /// Shape: 3. Units: m. Frame: body.
    pub position: [f64; 3],
    /// Displacement along x, y and z per unit modal coordinate. Shape: 3 x M.
    pub translation: [Vec<f64>; 3],
    /// Small rotation about x, y and z per unit modal coordinate. Shape: 3 x M. Units: rad.
    pub rotation: [Vec<f64>; 3],
    /// Γ of unit forces and moments there, by which the rows follow the deformation. Shape: 6 x M x M, row by row.
    pub load_stiffness: Option<[Vec<f64>; 6]>,
}

/// A triad at a marker, or on the ground.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AttachmentModel {
    /// Which of the markers; `None` on the ground.
    pub marker: Option<usize>,
    /// On the ground. Shape: 3. Units: m.
    pub position: [f64; 3],
    /// In the triad of the marker: Euler parameters, scalar first.
    pub orientation: [f64; 4],
}

impl AttachmentModel {
    /// The inertial triad.
    pub const GROUND: Self = Self { marker: None, position: [0.0; 3], orientation: [1.0, 0.0, 0.0, 0.0] };
}

/// A joint, or the drive of one.
#[derive(Debug, Clone, PartialEq)]
pub struct JointModel {
    /// Its name.
    pub name: String,
    /// What it holds.
    pub relations: Vec<RelationModel>,
    /// Its ends.
    pub ends: [AttachmentModel; 2],
    /// Coefficients of t^0, t^1, ...: how it is driven.
    pub drive: Option<Vec<f64>>,
}

/// What the joints are composed of; see the runtime's `relations`. Axes: x, y, z.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum RelationModel {
    /// Both origins coincide: three rows.
    Coincident,
    /// Along these axes of the first triad the origins do not move apart, or as driven: a row each.
    InPlane([bool; 3]),
    /// The z axis of the first triad is perpendicular to these axes of the second: a row each.
    Perpendicular([bool; 3]),
    /// The triads do not turn against each other about these axes of the first: a row each.
    Aligned([bool; 3]),
    /// The origins keep this distance (m): one row.
    Distance(f64),
    /// The angle about the z axis of the first triad is as driven: one row.
    Angle,
}

impl RelationModel {
    /// Number of rows.
    pub fn rows(&self) -> usize {
        match self {
            Self::Coincident => 3,
            Self::InPlane(axes) | Self::Perpendicular(axes) | Self::Aligned(axes) => {
                axes.iter().filter(|held| **held).count()
            }
            Self::Distance(_) | Self::Angle => 1,
        }
    }
}

/// A force element.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ElementModel {
    /// What acts.
    pub kind: ElementKindModel,
    /// Between what.
    pub ends: [AttachmentModel; 2],
}

/// Kinds of force elements.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ElementKindModel {
    /// Stiffness (N/m), damping (N s/m), length without force (m).
    Spring([f64; 3]),
    /// Stiffness (N m/rad), damping (N m s/rad), angle without moment (rad).
    TorsionSpring([f64; 3]),
    /// Along x, y, z, then about them.
    Bushing {
        /// Units: N/m and N m/rad.
        stiffness: [f64; 6],
        /// Units: N s/m and N m s/rad.
        damping: [f64; 6],
    },
    /// A constant force and moment at the second end.
    Constant {
        /// Force and moment. Units: N and N m.
        wrench: [f64; 6],
        /// Whether it turns with the second end.
        turns: bool,
    },
    /// Dry and viscous friction, smooth at rest.
    Friction {
        /// Where it acts.
        effort: EffortModel,
        /// Units: N or N m.
        limit: f64,
        /// Of the passage through rest. Units: m/s or rad/s.
        speed: f64,
        /// Units: N s/m or N m s/rad.
        viscous: f64,
    },
}

impl ElementKindModel {
    /// Number of its soft rows in implicit steps.
    pub fn soft_rows(&self) -> Option<usize> {
        super::soft_row_count(match self {
            Self::Spring(_) => "Spring",
            Self::TorsionSpring(_) => "TorsionSpring",
            Self::Bushing { .. } => "Bushing",
            Self::Constant { .. } => "ConstantWrench",
            Self::Friction { .. } => "Friction",
        })
    }
}

/// A force or moment that follows an input.
#[derive(Debug, Clone, PartialEq)]
pub struct ActuatorModel {
    /// Its name.
    pub name: String,
    /// Where it acts.
    pub effort: EffortModel,
    /// Force or moment per unit of the input. Units: N or N m per unit.
    pub gain: f64,
    /// The largest force or moment, either way. Units: N or N m.
    pub limit: f64,
    /// Between what.
    pub ends: [AttachmentModel; 2],
}

/// See the runtime's `forces::Effort`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum EffortModel {
    /// About the z axis of the first triad.
    About,
    /// Along the z axis of the first triad.
    Along,
    /// On the line through both origins.
    Line,
}

/// What is measured.
#[derive(Debug, Clone, PartialEq)]
pub struct SensorModel {
    /// Its name.
    pub name: String,
    /// What.
    pub kind: SensorKindModel,
}

/// Kinds of sensors.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SensorKindModel {
    /// Units: m. Frame: inertial.
    Position(AttachmentModel),
    /// Units: m/s. Frame: inertial.
    Velocity(AttachmentModel),
    /// Units: m/s². Frame: inertial.
    Acceleration(AttachmentModel),
    /// Euler parameters, scalar first.
    Orientation(AttachmentModel),
    /// Angle of a joint about its axis, within half a turn. Units: rad.
    Turn(usize),
    /// Force on the second body of so many joints from this one on. Units: N. Frame: inertial.
    ReactionForce(usize, usize),
    /// The moment of these. Units: N m. Frame: inertial.
    ReactionMoment(usize, usize),
}

impl SensorKindModel {
    /// Numbers that it measures.
    pub fn width(&self) -> usize {
        match self {
            Self::Turn(_) => 1,
            Self::Orientation(_) => 4,
            _ => 3,
        }
    }
}
