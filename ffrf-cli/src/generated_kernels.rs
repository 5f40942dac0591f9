//! The kernels of the code that `ffrf generate` and the macro make, run without compiling that code.

use ffrf_codegen::formulate::kernels::LINEAR_MOMENTUM;
use ffrf_codegen::{CodegenError, GenerateOptions, KernelInput, Kernels, lanes};
use ffrf_model::ReducedBody;

use crate::lane_kernels::{self, LARGEST, LaneKernels};

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
        let loops = tables.as_ref().and_then(lane_kernels::of);
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

#[cfg(test)]
#[path = "../../ffrf-codegen/tests/common/random_body.rs"]
#[allow(dead_code)]
mod random_body;

#[cfg(test)]
mod tests {
    use ffrf_codegen::Strategy;

    use super::random_body::{Modes, Random, random_body};
    use super::*;

    /// Rounding of sums over all pairs of 64 modes, relative to the largest entry; far above what was found.
    const ROUNDING: f64 = 1e-13;

    fn compare(what: &str, modes: usize, found: &[f64], expected: &[f64]) {
        assert_eq!(found.len(), expected.len(), "{what}, M = {modes}");
        let scale = expected.iter().fold(0.0, |largest: f64, entry| largest.max(entry.abs()));
        for (index, (found, expected)) in found.iter().zip(expected).enumerate() {
            let deviation = (found - expected).abs();
            assert!(deviation <= ROUNDING * scale, "{what}, M = {modes}, {index}: {found} for {expected}");
        }
    }

    /// Every kernel that is a loop, in the loops and in the expressions.
    fn agree(body: &ReducedBody, options: &GenerateOptions, form: &str) {
        let modes = body.mode_count();
        let found = GeneratedKernels::new(body, options).unwrap();
        assert!(found.description().contains(form), "M = {modes}: {}", found.description());
        let expected = Kernels::formulate(body, options).unwrap();
        let mut random = Random::new(7);
        let (q, q_dot) = (random.numbers(modes), random.numbers(modes));
        let vector = |random: &mut Random| [random.number(), random.number(), random.number()];
        let (velocity, omega) = (vector(&mut random), vector(&mut random));
        let q: Vec<f64> = q.iter().map(|q| 0.05 * q).collect();
        let force = random.numbers(6 + modes);
        let mass = expected.mass_matrix(&q).concat();
        compare("mass matrix", modes, &found.mass_matrix(&q).concat(), &mass);
        let quadratic = expected.quadratic_velocity(&q, &omega, &q_dot);
        compare("quadratic velocity", modes, &found.quadratic_velocity(&q, &omega, &q_dot), &quadratic);
        let accelerations = expected.forward_dynamics(&q, &omega, &q_dot, &force);
        compare("accelerations", modes, &found.forward_dynamics(&q, &omega, &q_dot, &force), &accelerations);
        let energy = expected.kinetic_energy(&q, &velocity, &omega, &q_dot);
        compare("energy", modes, &[found.kinetic_energy(&q, &velocity, &omega, &q_dot)], &[energy]);
        let momentum = expected.angular_momentum(&q, &velocity, &omega, &q_dot);
        compare("momentum", modes, &found.angular_momentum(&q, &velocity, &omega, &q_dot), &momentum);
    }

    #[test]
    fn loops_over_tables_compute_what_the_expressions_say() {
        // The layout tolerance covers the rounding of the orthonormalisation.
        let options = GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() };
        for modes in [7, 8, 9, 13, 19, 20, 22, 33, 64] {
            // The stiffness of these bodies is dense: K q is taken from the force before the loops.
            agree(&random_body(3, modes, Modes::Normalised), &options, "lanes over modes");
        }
        for modes in [7, 21] {
            let mut body = random_body(4, modes, Modes::FreeFree);
            for (mu, row) in body.stiffness.iter_mut().enumerate() {
                row.iter_mut().enumerate().for_each(|(nu, k)| *k = if mu == nu { 40.0 } else { 0.0 });
            }
            body.damping.clone_from(&body.stiffness);
            agree(&body, &options, "lanes over modes");
        }
        let lanes = GenerateOptions { strategy: Strategy::Lanes, ..options.clone() };
        for modes in [1, 3, 5] {
            agree(&random_body(5, modes, Modes::Normalised), &lanes, "lanes over modes");
        }
        let constant = GenerateOptions { fidelity: ffrf_codegen::Fidelity::Constant, ..options };
        for modes in [10, 24] {
            agree(&random_body(6, modes, Modes::Normalised), &constant, "no moments");
        }
    }

    #[test]
    fn few_modes_and_very_many_are_interpreted_and_say_so() {
        let options = GenerateOptions { layout_tolerance: 1e-12, ..GenerateOptions::default() };
        agree(&random_body(3, 2, Modes::Normalised), &options, "straight-line");
        let body = random_body(3, 65, Modes::Normalised);
        let kernels = GeneratedKernels::new(&body, &options).unwrap();
        assert!(kernels.description().contains("more than 64 modes"), "{}", kernels.description());
    }
}
