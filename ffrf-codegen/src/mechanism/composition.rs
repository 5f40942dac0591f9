//! How a mechanism follows from numbers that are only known when it begins.

/// What a step in C takes from its caller instead of having it as constants.
///
/// Joints and force elements take their triads and lengths from the state that the parameters say, as scenes do from their
/// initial state.
#[derive(Debug, Clone, PartialEq)]
pub struct CompositionModel {
    /// The parameters in their order.
    pub parameters: Vec<ParameterModel>,
    /// What each of the joints and drives takes from the initial state.
    pub joints: Vec<JointRule>,
    /// What each force element takes from it.
    pub elements: Vec<ElementRule>,
    /// For each actuator the joint that it acts in, whose ends are its own.
    pub actuators: Vec<Option<usize>>,
    /// For each actuator the coefficients of t^0, t^1, ...: what its input is until the caller sets it.
    pub schedules: Vec<Vec<f64>>,
}

/// A parameter.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ParameterModel {
    /// What it is; `None` if the step does not depend on it.
    pub place: Option<ParameterPlace>,
    /// The value that the tables are printed for.
    pub start: f64,
}

/// A number of a mechanism, with a body, force element or actuator, and which component.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs)] // the fields of the models, by their names
pub enum ParameterPlace {
    Gravity(usize),
    Position(usize, usize),
    Orientation(usize, usize),
    Velocity(usize, usize),
    AngularVelocity(usize, usize),
    ModalCoordinate(usize, usize),
    ModalRate(usize, usize),
    /// Of a spring or bushing; the limit of friction.
    Stiffness(usize, usize),
    /// Of a spring or bushing; viscous friction.
    Damping(usize, usize),
    /// The length of a spring without force.
    RestLength(usize),
    /// The angle of a torsion spring without moment.
    RestAngle(usize),
    /// Of the passage of friction through rest.
    Speed(usize),
    /// Of a constant force and moment.
    Wrench(usize, usize),
    Gain(usize),
    Limit(usize),
}

/// What a joint takes from the initial state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum JointRule {
    /// Its second triad: as its first is turned then, with the turn about the axis kept if `turns`.
    SecondTriad {
        /// Whether the joint lets its second triad turn about the axis.
        turns: bool,
    },
    /// The second triad of a universal joint: its z axis is the x axis of the first.
    SecondAxis,
    /// The length between its ends, and its second triad with the turn.
    Length,
    /// The ends of another joint, as a drive has them.
    As(usize),
    /// Nothing.
    Nothing,
}

/// What a force element takes from the initial state.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ElementRule {
    /// The length of a spring without force.
    RestLength,
    /// The second triad of a torsion spring, and its angle without moment if `rest`.
    Turn {
        /// Whether the angle without moment is that of the initial state.
        rest: bool,
    },
    /// The ends of a joint.
    As(usize),
    /// Nothing.
    Nothing,
}
