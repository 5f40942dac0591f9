//! The kernels of the code that `ffrf generate` and the macro make, run without compiling that code.

use ffrf_codegen::formulate::kernels::LINEAR_MOMENTUM;
use ffrf_codegen::{CodegenError, GenerateOptions, KernelInput, Kernels, lanes};
use ffrf_model::ReducedBody;

use super::lane_kernels::{LARGEST, LaneKernels, lane_kernels};

/// The generated kernels of a body, in f64.
///
/// What the generator prints as statements, the interpreter does, statement by statement (products and sums are not
/// contracted). What it writes as loops over lanes, the runtime's loops do, over the same tables.
pub struct GeneratedKernels {
    statements: Kernels,
    lanes: Option<Box<dyn LaneKernels>>,
    description: String,
}

impl GeneratedKernels {
    /// The kernels that the options give.
    ///
    /// Errors: as those of [`ffrf_codegen::generate`].
    pub fn new(body: &ReducedBody, options: &GenerateOptions) -> Result<Self, CodegenError> {
        let tables = lanes::tables_of(body, options)?;
        let loops = tables.as_ref().and_then(lane_kernels);
        let description = match (&tables, &loops) {
            (None, _) => "straight-line code".to_owned(),
            (Some(tables), Some(_)) => tables.description(options.scalar),
            (Some(_), None) => format!(
                "lanes over modes; more than {LARGEST} modes: the expressions are interpreted instead of the loops"
            ),
        };
        let statements = match &loops {
            Some(_) => Kernels::formulate_statements(body, options)?,
            None => Kernels::formulate(body, options)?,
        };
        Ok(Self { statements, lanes: loops, description })
    }

    /// How the kernels compute, in words.
    pub fn description(&self) -> &str {
        &self.description
    }

    /// Mass matrix M(q). Shape: N x N.
    pub fn mass_matrix(&self, q: &[f64]) -> Vec<Vec<f64>> {
        match &self.lanes {
            Some(lanes) => lanes.mass_matrix(q),
            None => self.statements.mass_matrix(q),
        }
    }

    /// Quadratic velocity vector Q(q, ω, q̇), on the left-hand side. Shape: N.
    pub fn quadratic_velocity(&self, q: &[f64], omega: &[f64; 3], q_dot: &[f64]) -> Vec<f64> {
        match &self.lanes {
            Some(lanes) => lanes.quadratic_velocity(q, *omega, q_dot),
            None => self.statements.quadratic_velocity(q, omega, q_dot),
        }
    }

    /// Accelerations [α; ω̇; q̈], elastic and damping forces included. Shape: N.
    pub fn forward_dynamics(&self, q: &[f64], omega: &[f64; 3], q_dot: &[f64], force: &[f64]) -> Vec<f64> {
        match &self.lanes {
            Some(lanes) => lanes.forward_dynamics(q, *omega, q_dot, force),
            None => self.statements.forward_dynamics(q, omega, q_dot, force),
        }
    }

    /// Kinetic energy. Units: J.
    pub fn kinetic_energy(&self, q: &[f64], velocity: &[f64; 3], omega: &[f64; 3], q_dot: &[f64]) -> f64 {
        match &self.lanes {
            Some(lanes) => lanes.kinetic_energy(q, *velocity, *omega, q_dot),
            None => self.statements.kinetic_energy(q, velocity, omega, q_dot),
        }
    }

    /// Elastic energy. Units: J.
    pub fn elastic_energy(&self, q: &[f64]) -> f64 {
        self.statements.elastic_energy(q)
    }

    /// Linear momentum, body-resolved. Shape: 3. Units: N s.
    pub fn linear_momentum(
        &self,
        q: &[f64],
        velocity: &[f64; 3],
        omega: &[f64; 3],
        q_dot: &[f64],
    ) -> Vec<f64> {
        let input = KernelInput { q, velocity, omega, q_dot, ..KernelInput::default() };
        self.statements.evaluate(&LINEAR_MOMENTUM, &input)
    }

    /// Angular momentum about the frame origin, body-resolved. Shape: 3. Units: N m s.
    pub fn angular_momentum(
        &self,
        q: &[f64],
        velocity: &[f64; 3],
        omega: &[f64; 3],
        q_dot: &[f64],
    ) -> Vec<f64> {
        match &self.lanes {
            Some(lanes) => lanes.angular_momentum(q, *velocity, *omega, q_dot).to_vec(),
            None => self.statements.angular_momentum(q, velocity, omega, q_dot),
        }
    }
}
