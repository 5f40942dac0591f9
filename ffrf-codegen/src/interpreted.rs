//! The kernels of a body evaluated by the interpreter, without generating code.

use ffrf_model::ReducedBody;

use crate::body::BodyExpressions;
use crate::expression::{Graph, Scalar, Symbol, evaluate};
use crate::formulate::{Kernel, KernelKind};
use crate::{CodegenError, GenerateOptions};

/// The kernels of a body as expressions, ready to be evaluated for any state.
///
/// The same expressions as in generated code; results differ from it by rounding only. For bodies whose generated
/// code is loops over lanes, see [`crate::lanes`], these are the expressions that the loops are tested against.
#[derive(Debug, Clone)]
pub struct Kernels {
    mode_count: usize,
    kernels: Vec<Kernel>,
}

/// The inputs of a kernel. Slices that a kernel does not use may be empty.
#[derive(Debug, Clone, Copy)]
pub struct KernelInput<'a, T = f64> {
    /// Modal coordinates q. Shape: M.
    pub q: &'a [T],
    /// Velocity of the frame origin, body-resolved. Shape: 3.
    pub velocity: &'a [T],
    /// Angular velocity, body-resolved. Shape: 3.
    pub omega: &'a [T],
    /// Modal rates q̇. Shape: M.
    pub q_dot: &'a [T],
    /// Generalised force. Shape: N.
    pub force: &'a [T],
    /// Uniform gravity, body-resolved. Shape: 3.
    pub gravity: &'a [T],
}

impl<T> Default for KernelInput<'_, T> {
    fn default() -> Self {
        Self { q: &[], velocity: &[], omega: &[], q_dot: &[], force: &[], gravity: &[] }
    }
}

impl Kernels {
    /// Formulates every kernel of `body`.
    ///
    /// Errors: [`CodegenError::Model`] for a body of the wrong shape or with too few modes,
    /// [`CodegenError::DependentModes`].
    pub fn formulate(body: &ReducedBody, options: &GenerateOptions) -> Result<Self, CodegenError> {
        Self::formulate_without(body, options, &[])
    }

    /// Formulates every kernel of `body` but those `left_out`, whose results are then empty.
    ///
    /// Errors: as those of [`Kernels::formulate`].
    pub fn formulate_without(
        body: &ReducedBody,
        options: &GenerateOptions,
        left_out: &[KernelKind],
    ) -> Result<Self, CodegenError> {
        let body = crate::prepare(body, options)?;
        let mut graph = Graph::new();
        let expressions = BodyExpressions::baked(&mut graph, &body, options.layout_tolerance)
            .truncated(&mut graph, &options.fidelity);
        let kernels = KernelKind::ALL
            .into_iter()
            .filter(|kind| !left_out.contains(kind))
            .map(|kind| Kernel::formulate(kind, graph.clone(), &expressions))
            .collect::<Result<_, _>>()?;
        Ok(Self { mode_count: body.mode_count(), kernels })
    }

    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.mode_count
    }

    /// The kernels, in the order of [`KernelKind::ALL`].
    pub fn kernels(&self) -> &[Kernel] {
        &self.kernels
    }

    /// The results of a kernel, one after another.
    ///
    /// Entries that are missing from the input count as not-a-number, so that a result which depends on them shows it.
    pub fn evaluate<T: Scalar>(&self, kind: KernelKind, input: &KernelInput<'_, T>) -> Vec<T> {
        let missing = || T::from_constant(f64::NAN);
        let at = |slice: &[T], k: usize| slice.get(k).cloned().unwrap_or_else(missing);
        let Some(kernel) = self.kernels.iter().find(|kernel| kernel.kind == kind) else {
            return Vec::new();
        };
        evaluate(&kernel.graph, &kernel.outputs, |symbol| match symbol {
            Symbol::Coordinate(k) => at(input.q, k),
            Symbol::Rate(k) => at(input.q_dot, k),
            Symbol::Velocity(k) => at(input.velocity, k),
            Symbol::AngularVelocity(k) => at(input.omega, k),
            Symbol::Force(k) => at(input.force, k),
            Symbol::Gravity(k) => at(input.gravity, k),
            _ => missing(),
        })
    }

    /// Mass matrix M(q). Shape: N x N.
    pub fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>> {
        let entries = self.evaluate(KernelKind::MassMatrix, &KernelInput { q, ..Default::default() });
        entries.chunks(6 + self.mode_count).map(<[f64]>::to_vec).collect()
    }

    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N.
    pub fn quadratic_velocity(&self, q: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, omega, q_dot, ..Default::default() };
        self.evaluate(KernelKind::QuadraticVelocity, &input)
    }

    /// Accelerations [α; ω̇; q̈]. Shape: N.
    pub fn forward_dynamics(&self, q: &[f64], omega: &[f64], q_dot: &[f64], force: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, omega, q_dot, force, ..Default::default() };
        self.evaluate(KernelKind::ForwardDynamics, &input)
    }

    /// Kinetic energy. Units: J.
    pub fn kinetic_energy(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> f64 {
        self.scalar(KernelKind::KineticEnergy, q, velocity, omega, q_dot)
    }

    /// Elastic energy. Units: J.
    pub fn elastic_energy(&self, q: &[f64]) -> f64 {
        self.scalar(KernelKind::ElasticEnergy, q, &[], &[], &[])
    }

    /// Linear momentum, body-resolved. Shape: 3. Units: N s.
    pub fn linear_momentum(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(KernelKind::LinearMomentum, &input)
    }

    /// Angular momentum about the frame origin, body-resolved. Shape: 3. Units: N m s.
    pub fn angular_momentum(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(KernelKind::AngularMomentum, &input)
    }

    /// Elastic and damping forces K q + D q̇. Shape: M.
    pub fn internal_force(&self, q: &[f64], q_dot: &[f64]) -> Vec<f64> {
        self.evaluate(KernelKind::InternalForce, &KernelInput { q, q_dot, ..Default::default() })
    }

    /// Generalised force of uniform gravity, body-resolved. Shape: N.
    pub fn gravity_force(&self, q: &[f64], gravity: &[f64]) -> Vec<f64> {
        self.evaluate(KernelKind::GravityForce, &KernelInput { q, gravity, ..Default::default() })
    }

    fn scalar(&self, kind: KernelKind, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> f64 {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(kind, &input).first().copied().unwrap_or(f64::NAN)
    }
}
