//! Kernels: what a generated body computes, as expressions with a signature.

use super::{
    DeformedBody, State, angular_momentum, elastic_energy, forward_dynamics, gravity_force, internal_force,
    kinetic_energy, linear_momentum, mass_matrix, quadratic_velocity,
};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::derive::Jacobian;
use crate::expression::{Expression, Graph, Symbol};

/// What a kernel computes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum KernelKind {
    /// Mass matrix M(q).
    MassMatrix,
    /// Quadratic velocity vector Q(q, ω, q̇).
    QuadraticVelocity,
    /// Accelerations [α; ω̇; q̈].
    ForwardDynamics,
    /// The three above in one pass.
    EquationsOfMotion,
    /// Kinetic energy.
    KineticEnergy,
    /// Elastic energy.
    ElasticEnergy,
    /// Linear momentum.
    LinearMomentum,
    /// Angular momentum about the frame origin.
    AngularMomentum,
    /// Elastic and damping forces.
    InternalForce,
    /// Generalised force of uniform gravity.
    GravityForce,
    /// Modal stiffness K_ff.
    StiffnessMatrix,
    /// Modal damping D_ff.
    DampingMatrix,
    /// Accelerations with their derivatives, on request.
    AccelerationJacobian,
    /// Implicit residual with its derivatives, on request.
    ResidualJacobian,
}

/// An input of a kernel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Argument {
    /// Modal coordinates q. Shape: M.
    Coordinates,
    /// Velocity v of the frame origin. Shape: 3.
    Velocity,
    /// Angular velocity ω. Shape: 3.
    AngularVelocity,
    /// Modal rates q̇. Shape: M.
    Rates,
    /// Generalised force. Shape: N.
    Force,
    /// Uniform gravity g. Shape: 3.
    Gravity,
    /// Accelerations w. Shape: N.
    Acceleration,
}

/// The shape of a result.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OutputShape {
    /// One number.
    Scalar,
    /// A column.
    Vector(usize),
    /// A square matrix, column by column.
    Matrix(usize),
    /// A matrix, column by column.
    Columns {
        /// Number of rows.
        rows: usize,
        /// Number of columns.
        columns: usize,
    },
}

impl OutputShape {
    /// Number of entries.
    pub fn entries(self) -> usize {
        match self {
            Self::Scalar => 1,
            Self::Vector(size) => size,
            Self::Matrix(size) => size * size,
            Self::Columns { rows, columns } => rows * columns,
        }
    }
}

/// A kernel: expressions with a signature.
#[derive(Debug, Clone)]
pub struct Kernel {
    /// What it computes.
    pub kind: KernelKind,
    /// Number of modes M.
    pub mode_count: usize,
    /// The expressions.
    pub graph: Graph,
    /// The results, one after another; matrices column by column.
    pub outputs: Vec<Expression>,
}

impl KernelKind {
    /// Every kernel that each body has, in the order in which they are printed.
    pub const ALL: [Self; 12] = [
        Self::MassMatrix,
        Self::QuadraticVelocity,
        Self::ForwardDynamics,
        Self::EquationsOfMotion,
        Self::KineticEnergy,
        Self::ElasticEnergy,
        Self::LinearMomentum,
        Self::AngularMomentum,
        Self::InternalForce,
        Self::GravityForce,
        Self::StiffnessMatrix,
        Self::DampingMatrix,
    ];

    /// The kernels that a body has on request.
    pub const JACOBIANS: [Self; 2] = [Self::AccelerationJacobian, Self::ResidualJacobian];

    /// Name of the function.
    pub fn name(self) -> &'static str {
        match self {
            Self::MassMatrix => "mass_matrix",
            Self::QuadraticVelocity => "quadratic_velocity",
            Self::ForwardDynamics => "forward_dynamics",
            Self::EquationsOfMotion => "equations_of_motion",
            Self::KineticEnergy => "kinetic_energy",
            Self::ElasticEnergy => "elastic_energy",
            Self::LinearMomentum => "linear_momentum",
            Self::AngularMomentum => "angular_momentum",
            Self::InternalForce => "internal_force",
            Self::GravityForce => "gravity_force",
            Self::StiffnessMatrix => "stiffness_matrix",
            Self::DampingMatrix => "damping_matrix",
            Self::AccelerationJacobian => "acceleration_jacobian",
            Self::ResidualJacobian => "residual_jacobian",
        }
    }

    /// The inputs, in the order of the signature.
    pub fn arguments(self) -> &'static [Argument] {
        use Argument::{Acceleration, AngularVelocity, Coordinates, Force, Gravity, Rates, Velocity};
        match self {
            Self::MassMatrix | Self::ElasticEnergy => &[Coordinates],
            Self::QuadraticVelocity => &[Coordinates, AngularVelocity, Rates],
            Self::ForwardDynamics | Self::EquationsOfMotion | Self::AccelerationJacobian => {
                &[Coordinates, AngularVelocity, Rates, Force]
            }
            Self::ResidualJacobian => &[Coordinates, AngularVelocity, Rates, Acceleration, Force],
            Self::KineticEnergy | Self::LinearMomentum | Self::AngularMomentum => {
                &[Coordinates, Velocity, AngularVelocity, Rates]
            }
            Self::InternalForce => &[Coordinates, Rates],
            Self::GravityForce => &[Coordinates, Gravity],
            Self::StiffnessMatrix | Self::DampingMatrix => &[],
        }
    }

    /// The results, in order.
    pub fn outputs(self, mode_count: usize) -> Vec<OutputShape> {
        let size = 6 + mode_count;
        match self {
            Self::MassMatrix => vec![OutputShape::Matrix(size)],
            Self::QuadraticVelocity | Self::ForwardDynamics | Self::GravityForce => {
                vec![OutputShape::Vector(size)]
            }
            Self::EquationsOfMotion => {
                vec![OutputShape::Matrix(size), OutputShape::Vector(size), OutputShape::Vector(size)]
            }
            Self::KineticEnergy | Self::ElasticEnergy => vec![OutputShape::Scalar],
            Self::LinearMomentum | Self::AngularMomentum => vec![OutputShape::Vector(3)],
            Self::InternalForce => vec![OutputShape::Vector(mode_count)],
            Self::StiffnessMatrix | Self::DampingMatrix => vec![OutputShape::Matrix(mode_count)],
            // value, ∂/∂q, ∂/∂q̇, ∂/∂ω, and the one square block: ∂/∂force or ∂/∂w
            Self::AccelerationJacobian | Self::ResidualJacobian => vec![
                OutputShape::Vector(size),
                OutputShape::Columns { rows: size, columns: mode_count },
                OutputShape::Columns { rows: size, columns: mode_count },
                OutputShape::Columns { rows: size, columns: 3 },
                OutputShape::Matrix(size),
            ],
        }
    }
}

impl Argument {
    /// Number of entries.
    pub fn size(self, mode_count: usize) -> usize {
        match self {
            Self::Coordinates | Self::Rates => mode_count,
            Self::Velocity | Self::AngularVelocity | Self::Gravity => 3,
            Self::Force | Self::Acceleration => 6 + mode_count,
        }
    }

    /// The symbol of entry `k`.
    pub fn symbol(self, k: usize) -> Symbol {
        match self {
            Self::Coordinates => Symbol::Coordinate(k),
            Self::Velocity => Symbol::Velocity(k),
            Self::AngularVelocity => Symbol::AngularVelocity(k),
            Self::Rates => Symbol::Rate(k),
            Self::Force => Symbol::Force(k),
            Self::Gravity => Symbol::Gravity(k),
            Self::Acceleration => Symbol::Acceleration(k),
        }
    }
}

impl Kernel {
    /// Writes the kernel of a body whose invariants are expressions of `graph`.
    ///
    /// Errors: see [`forward_dynamics`].
    pub fn formulate(
        kind: KernelKind,
        mut graph: Graph,
        body: &BodyExpressions,
    ) -> Result<Self, CodegenError> {
        let mode_count = body.mode_count();
        let g = &mut graph;
        let state = State::symbolic(g, mode_count);
        let deformed = DeformedBody::new(g, body, &state);
        let outputs = match kind {
            KernelKind::MassMatrix => mass_matrix(g, body, &deformed).concat(),
            KernelKind::QuadraticVelocity => quadratic_velocity(g, body, &state, &deformed),
            KernelKind::ForwardDynamics => {
                let quadratic = quadratic_velocity(g, body, &state, &deformed);
                forward_dynamics(g, body, &state, &deformed, &quadratic)?
            }
            KernelKind::EquationsOfMotion => {
                let mass = mass_matrix(g, body, &deformed).concat();
                let quadratic = quadratic_velocity(g, body, &state, &deformed);
                let acceleration = forward_dynamics(g, body, &state, &deformed, &quadratic)?;
                [mass, quadratic, acceleration].concat()
            }
            KernelKind::KineticEnergy => vec![kinetic_energy(g, body, &state, &deformed)],
            KernelKind::ElasticEnergy => vec![elastic_energy(g, body, &state)],
            KernelKind::LinearMomentum => linear_momentum(g, body, &state, &deformed).to_vec(),
            KernelKind::AngularMomentum => angular_momentum(g, &state, &deformed).to_vec(),
            KernelKind::InternalForce => internal_force(g, body, &state),
            KernelKind::GravityForce => gravity_force(g, body, &state, &deformed),
            KernelKind::StiffnessMatrix => body.stiffness.concat(),
            KernelKind::DampingMatrix => body.damping.concat(),
            KernelKind::AccelerationJacobian => {
                let jacobian = Jacobian::of_accelerations(g, body)?;
                let force = jacobian.force.concat();
                with_derivatives(jacobian, force)
            }
            KernelKind::ResidualJacobian => {
                let mass = mass_matrix(g, body, &deformed).concat();
                with_derivatives(Jacobian::of_residual(g, body), mass)
            }
        };
        Ok(Self { kind, mode_count, graph, outputs })
    }
}

/// The results of a kernel with derivatives. Those with respect to the velocity are zero and not written.
fn with_derivatives(jacobian: Jacobian, square: Vec<Expression>) -> Vec<Expression> {
    [
        jacobian.value,
        jacobian.coordinates.concat(),
        jacobian.rates.concat(),
        jacobian.angular_velocity.concat(),
        square,
    ]
    .concat()
}
