//! The kernels of a body: one table of signatures and formulations. All other lists follow from it.

use super::{
    DeformedBody, Draft, Jacobian, Output, Shape, Signature, State, angular_momentum, elastic_energy,
    forward_dynamics, gravity_force, internal_force, kinetic_energy, linear_momentum, mass_matrix,
    quadratic_velocity,
};
use crate::CodegenError;
use crate::body::BodyExpressions;
use crate::expression::Extent::{Axes, Modes, Velocities};
use crate::expression::{Expression, Input};

/// How a kernel is written: its results, one after another.
pub type Formulate =
    fn(&mut Draft, &BodyExpressions, &State, &DeformedBody) -> Result<Vec<Expression>, CodegenError>;

/// A kernel that bodies can have.
#[derive(Debug, Clone, Copy)]
pub struct Definition {
    /// What it takes and gives.
    pub signature: Signature,
    /// Writes its results.
    pub formulate: Formulate,
    /// The trait of the runtime that has it as a method.
    pub interface: Interface,
    /// The runtime's loop over lanes that computes it. `None` for kernels that stay statements: they cost no more than M
    /// operations per entry.
    pub lanes: Option<Loop>,
}

/// The trait that has a kernel as a method.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Interface {
    /// What every body is.
    FlexibleBody,
    /// Energies, momenta, mass.
    Observables,
    /// N x N matrices.
    DenseForms,
    /// Derivatives.
    FlexibleBodyJacobians,
}

/// A loop of the runtime over lanes.
#[derive(Debug, Clone, Copy)]
pub struct Loop {
    /// What it takes besides the state; the force there is less what the loops do not know.
    pub inputs: &'static [Input],
    /// The kernel that gives the last result, which the loop leaves out.
    pub rest: Option<&'static Definition>,
}

const fn over(inputs: &'static [Input]) -> Option<Loop> {
    Some(Loop { inputs, rest: None })
}

/// Every kernel that each body has, in the order in which they are printed.
pub static KERNELS: [&Definition; 15] = [
    &MASS_MATRIX,
    &QUADRATIC_VELOCITY,
    &FORWARD_DYNAMICS,
    &EQUATIONS_OF_MOTION,
    &KINETIC_ENERGY,
    &ELASTIC_ENERGY,
    &LINEAR_MOMENTUM,
    &ANGULAR_MOMENTUM,
    &INTERNAL_FORCE,
    &GRAVITY_FORCE,
    &MODAL_MASS,
    &STIFFNESS,
    &DAMPING,
    &MASS,
    &PREPARE,
];

/// The kernels that a body has on request.
pub static JACOBIANS: [&Definition; 2] = [&ACCELERATION_JACOBIAN, &RESIDUAL_JACOBIAN];

const STATE: &[Input] = &[Input::COORDINATES, Input::ANGULAR_VELOCITY, Input::RATES];
const STATE_AND_FORCE: &[Input] = &[Input::COORDINATES, Input::ANGULAR_VELOCITY, Input::RATES, Input::FORCE];
const MOTION: &[Input] = &[Input::COORDINATES, Input::VELOCITY, Input::ANGULAR_VELOCITY, Input::RATES];

const MASSES: &str = "kg, kg m, kg m² and their modal kin";
const FORCES: &str = "N, N m, modal forces";

const fn one(name: &'static str, shape: Shape) -> Output {
    Output { name, shape }
}

const SQUARE: Shape = Shape::Symmetric(Velocities);
const fn derivative(name: &'static str, columns: crate::expression::Extent) -> Output {
    Output { name, shape: Shape::Columns { rows: Velocities, columns } }
}

/// Mass matrix M(q).
pub static MASS_MATRIX: Definition = Definition {
    signature: Signature {
        name: "mass_matrix",
        inputs: &[Input::COORDINATES],
        outputs: &[one("mass_matrix", SQUARE)],
        results: "",
        title: "Mass matrix M(q).",
        units: MASSES,
        source: "(203), body-resolved",
    },
    formulate: |g, body, _, deformed| Ok(mass_matrix(g, body, deformed).concat()),
    interface: Interface::DenseForms,
    lanes: over(&[]),
};

/// Quadratic velocity vector Q(q, ω, q̇).
pub static QUADRATIC_VELOCITY: Definition = Definition {
    signature: Signature {
        name: "quadratic_velocity",
        inputs: STATE,
        outputs: &[one("quadratic_velocity", Shape::Force)],
        results: "",
        title: "Quadratic velocity vector Q(q, ω, q̇), on the left-hand side.",
        units: FORCES,
        source: "(209), signs and index order corrected",
    },
    formulate: |g, body, state, deformed| Ok(quadratic_velocity(g, body, state, deformed)),
    interface: Interface::DenseForms,
    lanes: over(&[]),
};

/// Accelerations [α; ω̇; q̈].
pub static FORWARD_DYNAMICS: Definition = Definition {
    signature: Signature {
        name: "forward_dynamics",
        inputs: STATE_AND_FORCE,
        outputs: &[one("acceleration", Shape::Motion)],
        results: "",
        title: "Accelerations [α; ω̇; q̈] under a generalised force, elastic and damping forces included.",
        units: "m/s², rad/s², 1/s²",
        source: "(203), q̈ eliminated first, the mass matrix never formed",
    },
    formulate: |g, body, state, deformed| {
        let quadratic = quadratic_velocity(g, body, state, deformed);
        forward_dynamics(g, body, state, deformed, &quadratic)
    },
    interface: Interface::FlexibleBody,
    lanes: over(&[Input::COORDINATES, Input::RATES, Input::FORCE]),
};

/// The three above in one pass.
pub static EQUATIONS_OF_MOTION: Definition = Definition {
    signature: Signature {
        name: "equations_of_motion",
        inputs: STATE_AND_FORCE,
        outputs: &[
            one("mass_matrix", SQUARE),
            one("quadratic_velocity", Shape::Force),
            one("acceleration", Shape::Motion),
        ],
        results: "EquationsOfMotion",
        title: "Mass matrix, quadratic velocity vector and accelerations in one pass.",
        units: "as of the three",
        source: "(203), (209)",
    },
    formulate: |g, body, state, deformed| {
        let mass = mass_matrix(g, body, deformed).concat();
        let quadratic = quadratic_velocity(g, body, state, deformed);
        let acceleration = forward_dynamics(g, body, state, deformed, &quadratic)?;
        Ok([mass, quadratic, acceleration].concat())
    },
    interface: Interface::DenseForms,
    lanes: over(&[Input::COORDINATES, Input::RATES, Input::FORCE]),
};

/// Kinetic energy.
pub static KINETIC_ENERGY: Definition = Definition {
    signature: Signature {
        name: "kinetic_energy",
        inputs: MOTION,
        outputs: &[one("energy", Shape::Scalar)],
        results: "",
        title: "Kinetic energy.",
        units: "J",
        source: "½ (v · P + ω · L + q̇ · p)",
    },
    formulate: |g, body, state, deformed| Ok(vec![kinetic_energy(g, body, state, deformed)]),
    interface: Interface::Observables,
    lanes: over(&[Input::VELOCITY, Input::ANGULAR_VELOCITY, Input::RATES]),
};

/// Elastic energy.
pub static ELASTIC_ENERGY: Definition = Definition {
    signature: Signature {
        name: "elastic_energy",
        inputs: &[Input::COORDINATES],
        outputs: &[one("energy", Shape::Scalar)],
        results: "",
        title: "Elastic energy.",
        units: "J",
        source: "½ qᵀ K q",
    },
    formulate: |g, body, state, _| Ok(vec![elastic_energy(g, body, state)]),
    interface: Interface::Observables,
    lanes: None,
};

/// Linear momentum.
pub static LINEAR_MOMENTUM: Definition = Definition {
    signature: Signature {
        name: "linear_momentum",
        inputs: MOTION,
        outputs: &[one("momentum", Shape::Vector(Axes))],
        results: "",
        title: "Linear momentum.",
        units: "N s",
        source: "m v + ω × m r + m B q̇",
    },
    formulate: |g, body, state, deformed| Ok(linear_momentum(g, body, state, deformed).to_vec()),
    interface: Interface::Observables,
    lanes: None,
};

/// Angular momentum about the frame origin.
pub static ANGULAR_MOMENTUM: Definition = Definition {
    signature: Signature {
        name: "angular_momentum",
        inputs: MOTION,
        outputs: &[one("momentum", Shape::Vector(Axes))],
        results: "",
        title: "Angular momentum about the frame origin.",
        units: "N m s",
        source: "m r × v + Θ_rr ω + Θ_rf q̇",
    },
    formulate: |g, _, state, deformed| Ok(angular_momentum(g, state, deformed).to_vec()),
    interface: Interface::Observables,
    lanes: over(&[Input::VELOCITY, Input::ANGULAR_VELOCITY]),
};

/// Elastic and damping forces.
pub static INTERNAL_FORCE: Definition = Definition {
    signature: Signature {
        name: "internal_force",
        inputs: &[Input::COORDINATES, Input::RATES],
        outputs: &[one("force", Shape::Vector(Modes))],
        results: "",
        title: "Elastic and damping forces, on the left-hand side.",
        units: "modal forces",
        source: "K q + D q̇",
    },
    formulate: |g, body, state, _| Ok(internal_force(g, body, state)),
    interface: Interface::FlexibleBody,
    lanes: None,
};

/// Generalised force of uniform gravity.
pub static GRAVITY_FORCE: Definition = Definition {
    signature: Signature {
        name: "gravity_force",
        inputs: &[Input::COORDINATES, Input::GRAVITY],
        outputs: &[one("force", Shape::Force)],
        results: "",
        title: "Generalised force of uniform gravity g.",
        units: FORCES,
        source: "[m g; m r × g; m b_μ · g]",
    },
    formulate: |g, body, state, deformed| Ok(gravity_force(g, body, state, deformed)),
    interface: Interface::FlexibleBody,
    lanes: None,
};

/// Modal mass Θ_ff.
pub static MODAL_MASS: Definition = Definition {
    signature: Signature {
        name: "modal_mass",
        inputs: &[],
        outputs: &[one("modal_mass", Shape::Symmetric(Modes))],
        results: "",
        title: "Modal mass Θ_ff.",
        units: "kg for unit modes",
        source: "[tr T_μν]",
    },
    formulate: |_, body, _, _| Ok(body.modal_mass.concat()),
    interface: Interface::FlexibleBody,
    lanes: None,
};

/// Modal stiffness K_ff.
pub static STIFFNESS: Definition = Definition {
    signature: Signature {
        name: "stiffness",
        inputs: &[],
        outputs: &[one("stiffness", Shape::Symmetric(Modes))],
        results: "",
        title: "Modal stiffness K_ff.",
        units: "modal force per unit modal coordinate",
        source: "Ψᵀ K Ψ",
    },
    formulate: |_, body, _, _| Ok(body.stiffness.concat()),
    interface: Interface::FlexibleBody,
    lanes: None,
};

/// Modal damping D_ff.
pub static DAMPING: Definition = Definition {
    signature: Signature {
        name: "damping",
        inputs: &[],
        outputs: &[one("damping", Shape::Symmetric(Modes))],
        results: "",
        title: "Modal damping D_ff.",
        units: "modal force per unit modal rate",
        source: "the model",
    },
    formulate: |_, body, _, _| Ok(body.damping.concat()),
    interface: Interface::FlexibleBody,
    lanes: None,
};

/// Mass m.
pub static MASS: Definition = Definition {
    signature: Signature {
        name: "mass",
        inputs: &[],
        outputs: &[one("mass", Shape::Scalar)],
        results: "",
        title: "Mass m.",
        units: "kg",
        source: "the model",
    },
    formulate: |_, body, _, _| Ok(vec![body.mass]),
    interface: Interface::Observables,
    lanes: None,
};

/// Everything that depends on the state, once for whatever needs it.
pub static PREPARE: Definition = Definition {
    signature: Signature {
        name: "prepare",
        inputs: STATE,
        outputs: &[
            one("mass", Shape::Scalar),
            one("first_moment", Shape::Vector(Axes)),
            one("inertia", Shape::Symmetric(Axes)),
            one("modal_first_moment", Shape::Columns { rows: Modes, columns: Axes }),
            one("rotation_modal_coupling", Shape::Columns { rows: Modes, columns: Axes }),
            one("quadratic_velocity", Shape::Force),
            one("internal_force", Shape::Vector(Modes)),
        ],
        results: "Prepared",
        title: "Everything that depends on the state: m, m r, Θ_rr, rows of m B and of Θ_rf, Q, K q + D q̇.",
        units: "as of each",
        source: "(204), (209), corrected",
    },
    formulate: |g, body, state, deformed| {
        let axes = [0, 1, 2];
        let quadratic = quadratic_velocity(g, body, state, deformed);
        g.section("Elastic and damping forces K q + D q̇");
        let internal = internal_force(g, body, state);
        let momentum: [Vec<Expression>; 3] =
            axes.map(|i| deformed.modal_first_moment.iter().map(|moment| moment[i]).collect());
        let coupling: [Vec<Expression>; 3] =
            axes.map(|i| deformed.moments.iter().map(|moment| moment.odd[i]).collect());
        let parts: [Vec<Expression>; 7] = [
            vec![body.mass],
            deformed.first_moment.to_vec(),
            axes.map(|i| axes.map(|j| deformed.inertia.at(i, j))).concat(),
            momentum.concat(),
            coupling.concat(),
            quadratic,
            internal,
        ];
        Ok(parts.concat())
    },
    interface: Interface::FlexibleBody,
    lanes: Some(Loop { inputs: &[], rest: Some(&INTERNAL_FORCE) }),
};

/// Accelerations with their derivatives.
pub static ACCELERATION_JACOBIAN: Definition = Definition {
    signature: Signature {
        name: "acceleration_jacobian",
        inputs: STATE_AND_FORCE,
        outputs: &[
            one("acceleration", Shape::Motion),
            derivative("coordinates", Modes),
            derivative("rates", Modes),
            derivative("angular_velocity", Axes),
            derivative("force", Velocities),
        ],
        results: "AccelerationJacobian",
        title: "Accelerations w and their derivatives with respect to q, q̇, ω and force; that to the velocity is zero.",
        units: "those of w, per unit of the variable",
        source: "∂w/∂x = -M⁻¹ ∂R/∂x (implicit function theorem), ∂w/∂force = M⁻¹",
    },
    formulate: |g, body, _, _| {
        let jacobian = Jacobian::of_accelerations(g, body)?;
        let force = jacobian.force.concat();
        Ok(with_derivatives(jacobian, force))
    },
    interface: Interface::FlexibleBodyJacobians,
    lanes: None,
};

/// Implicit residual with its derivatives.
pub static RESIDUAL_JACOBIAN: Definition = Definition {
    signature: Signature {
        name: "residual_jacobian",
        inputs: &[
            Input::COORDINATES,
            Input::ANGULAR_VELOCITY,
            Input::RATES,
            Input::ACCELERATION,
            Input::FORCE,
        ],
        outputs: &[
            one("residual", Shape::Force),
            derivative("coordinates", Modes),
            derivative("rates", Modes),
            derivative("angular_velocity", Axes),
            derivative("acceleration", Velocities),
        ],
        results: "ResidualJacobian",
        title: "Residual M w + Q + K q + D q̇ - force and its derivatives with respect to q, q̇, ω and w.",
        units: "those of forces, per unit of the variable",
        source: "(203), differentiated symbolically; ∂R/∂w = M, ∂R/∂force = -I, ∂R/∂v = 0",
    },
    formulate: |g, body, _, deformed| {
        let mass = mass_matrix(g, body, deformed).concat();
        Ok(with_derivatives(Jacobian::of_residual(g, body), mass))
    },
    interface: Interface::FlexibleBodyJacobians,
    lanes: None,
};

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
