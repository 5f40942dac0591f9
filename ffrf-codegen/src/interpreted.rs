//! The kernels of a body evaluated by the interpreter, without generating code.

use ffrf_model::ReducedBody;

use crate::body::BodyExpressions;
use crate::expression::{Graph, Input, Scalar, Symbol, evaluate};
use crate::formulate::kernels::{
    ANGULAR_MOMENTUM, ELASTIC_ENERGY, FORWARD_DYNAMICS, GRAVITY_FORCE, INTERNAL_FORCE, KINETIC_ENERGY,
    LINEAR_MOMENTUM, MASS_MATRIX, QUADRATIC_VELOCITY,
};
use crate::formulate::{Definition, KERNELS, Kernel};
use crate::prepare::prepare;
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

impl<'a, T> KernelInput<'a, T> {
    /// The values of an input; none of one that bodies do not have or that is not given.
    fn values(&self, input: Input) -> &'a [T] {
        match input {
            Input::COORDINATES => self.q,
            Input::RATES => self.q_dot,
            Input::VELOCITY => self.velocity,
            Input::ANGULAR_VELOCITY => self.omega,
            Input::FORCE => self.force,
            Input::GRAVITY => self.gravity,
            _ => &[],
        }
    }
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
        Self::of(body, options, |_| true)
    }

    /// Formulates every kernel of `body` but those that loops over lanes compute where a body has them; the results of those
    /// are then empty.
    ///
    /// Errors: as those of [`Kernels::formulate`].
    pub fn formulate_statements(body: &ReducedBody, options: &GenerateOptions) -> Result<Self, CodegenError> {
        Self::of(body, options, |definition| definition.lanes.is_none())
    }

    /// Formulates the one kernel of that name; none if there is no such kernel.
    ///
    /// Errors: as those of [`Kernels::formulate`].
    pub fn formulate_one(
        body: &ReducedBody,
        options: &GenerateOptions,
        name: &str,
    ) -> Result<Self, CodegenError> {
        Self::of(body, options, |definition| definition.signature.name == name)
    }

    fn of(
        body: &ReducedBody,
        options: &GenerateOptions,
        is_wanted: impl Fn(&Definition) -> bool,
    ) -> Result<Self, CodegenError> {
        let body = prepare(body, options)?;
        let mut graph = Graph::new();
        let expressions = BodyExpressions::baked(&mut graph, &body, options.layout_tolerance)
            .truncated(&mut graph, &options.fidelity);
        let kernels = KERNELS
            .into_iter()
            .filter(|definition| is_wanted(definition))
            .map(|definition| Kernel::formulate(definition, graph.clone(), &expressions))
            .collect::<Result<_, _>>()?;
        Ok(Self { mode_count: body.mode_count(), kernels })
    }

    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.mode_count
    }

    /// The kernels, in the order of [`KERNELS`].
    pub fn kernels(&self) -> &[Kernel] {
        &self.kernels
    }

    /// The results of a kernel, one after another.
    ///
    /// Entries that are missing from the input count as not-a-number, so that a result which depends on them shows it.
    pub fn evaluate<T: Scalar>(&self, definition: &Definition, values: &KernelInput<'_, T>) -> Vec<T> {
        let missing = || T::from_constant(f64::NAN);
        let at = |slice: &[T], k: usize| slice.get(k).cloned().unwrap_or_else(missing);
        let mut kernels = self.kernels.iter();
        let Some(kernel) = kernels.find(|kernel| kernel.signature == definition.signature) else {
            return Vec::new();
        };
        evaluate(&kernel.graph, &kernel.outputs, |symbol| match symbol {
            Symbol::Input(input, k) => at(values.values(input), k),
            _ => missing(),
        })
    }

    /// Mass matrix M(q). Shape: N x N.
    pub fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>> {
        let entries = self.evaluate(&MASS_MATRIX, &KernelInput { q, ..Default::default() });
        entries.chunks(6 + self.mode_count).map(<[f64]>::to_vec).collect()
    }

    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N.
    pub fn quadratic_velocity(&self, q: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, omega, q_dot, ..Default::default() };
        self.evaluate(&QUADRATIC_VELOCITY, &input)
    }

    /// Accelerations [α; ω̇; q̈]. Shape: N.
    pub fn forward_dynamics(&self, q: &[f64], omega: &[f64], q_dot: &[f64], force: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, omega, q_dot, force, ..Default::default() };
        self.evaluate(&FORWARD_DYNAMICS, &input)
    }

    /// Kinetic energy. Units: J.
    pub fn kinetic_energy(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> f64 {
        self.scalar(&KINETIC_ENERGY, q, velocity, omega, q_dot)
    }

    /// Elastic energy. Units: J.
    pub fn elastic_energy(&self, q: &[f64]) -> f64 {
        self.scalar(&ELASTIC_ENERGY, q, &[], &[], &[])
    }

    /// Linear momentum, body-resolved. Shape: 3. Units: N s.
    pub fn linear_momentum(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(&LINEAR_MOMENTUM, &input)
    }

    /// Angular momentum about the frame origin, body-resolved. Shape: 3. Units: N m s.
    pub fn angular_momentum(&self, q: &[f64], velocity: &[f64], omega: &[f64], q_dot: &[f64]) -> Vec<f64> {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(&ANGULAR_MOMENTUM, &input)
    }

    /// Elastic and damping forces K q + D q̇. Shape: M.
    pub fn internal_force(&self, q: &[f64], q_dot: &[f64]) -> Vec<f64> {
        self.evaluate(&INTERNAL_FORCE, &KernelInput { q, q_dot, ..Default::default() })
    }

    /// Generalised force of uniform gravity, body-resolved. Shape: N.
    pub fn gravity_force(&self, q: &[f64], gravity: &[f64]) -> Vec<f64> {
        self.evaluate(&GRAVITY_FORCE, &KernelInput { q, gravity, ..Default::default() })
    }

    fn scalar(
        &self,
        definition: &Definition,
        q: &[f64],
        velocity: &[f64],
        omega: &[f64],
        q_dot: &[f64],
    ) -> f64 {
        let input = KernelInput { q, velocity, omega, q_dot, ..Default::default() };
        self.evaluate(definition, &input).first().copied().unwrap_or(f64::NAN)
    }
}
