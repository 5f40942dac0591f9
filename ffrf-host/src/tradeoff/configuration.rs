//! What is varied: one configuration, and the grid of all.

use ffrf_codegen::{Fidelity, ScalarType};

use super::SceneModes;
use crate::scene::Integrator;

/// One way to simulate a scene.
#[derive(Debug, Clone, PartialEq)]
pub struct Configuration {
    /// Modes of the flexible bodies.
    pub modes: SceneModes,
    /// Terms of the kinetic energy that are kept, of every flexible body.
    pub fidelity: Fidelity,
    /// Number type, f64 or f32; `generic` counts as f64.
    pub scalar: ScalarType,
    /// Integrator.
    pub integrator: Integrator,
    /// Longest step; steps are equal and shortened to meet the times at which errors are taken. Units: s.
    pub step: f64,
}

impl Configuration {
    /// Grows with what a run takes: steps, and about the square of the modes above a constant share. Without units.
    pub fn expected_effort(&self) -> f64 {
        (8.0 + self.modes.most() as f64).powi(2) / self.step
    }

    /// A name that no other configuration has, fit for files.
    pub fn key(&self) -> String {
        format!("{}-h{:e}", self.program(), self.step)
    }

    /// The name of what is compiled for it: all but the step, which a program takes as a number.
    pub fn program(&self) -> String {
        let fidelity: String = self
            .fidelity
            .to_string()
            .chars()
            .filter_map(|c| match c {
                ',' => Some('+'),
                c if c.is_alphanumeric() || c == '_' => Some(c),
                _ => None,
            })
            .collect();
        let (modes, scalar, integrator) = (self.modes.key(), self.scalar.name(), self.integrator.name());
        format!("{modes}-{fidelity}-{scalar}-{integrator}")
    }
}

/// The values of each axis; a study runs every combination.
#[derive(Debug, Clone, PartialEq)]
pub struct Axes {
    /// Modes.
    pub modes: Vec<SceneModes>,
    /// Fidelities.
    pub fidelities: Vec<Fidelity>,
    /// Number types.
    pub scalars: Vec<ScalarType>,
    /// Integrators.
    pub integrators: Vec<Integrator>,
    /// Steps. Units: s.
    pub steps: Vec<f64>,
}

impl Axes {
    /// Every combination, each once and in a fixed order; without modes all fidelities are the same body, which is called
    /// `full` whichever are asked for.
    pub fn configurations(&self) -> Vec<Configuration> {
        let mut all: Vec<Configuration> = Vec::new();
        for modes in &self.modes {
            let fidelities = if modes.is_rigid() { &[Fidelity::Full] } else { self.fidelities.as_slice() };
            for fidelity in fidelities {
                for scalar in &self.scalars {
                    for integrator in &self.integrators {
                        all.extend(self.steps.iter().map(|step| Configuration {
                            modes: modes.clone(),
                            fidelity: fidelity.clone(),
                            scalar: *scalar,
                            integrator: *integrator,
                            step: *step,
                        }));
                    }
                }
            }
        }
        let mut unique: Vec<Configuration> = Vec::with_capacity(all.len());
        let mut seen = std::collections::BTreeSet::new();
        unique.extend(all.into_iter().filter(|one| seen.insert(one.key())));
        unique
    }
}

#[cfg(test)]
mod tests {
    use super::super::Modes;
    use super::*;

    #[test]
    fn every_combination_is_there_once() {
        let axes = Axes {
            modes: vec![0.into(), 2.into(), Modes::listed(vec![0, 1]).into()],
            fidelities: vec![Fidelity::Linear, Fidelity::Full],
            scalars: vec![ScalarType::F64, ScalarType::F32],
            integrators: vec![Integrator::Rk4],
            steps: vec![1e-3, 1e-4, 1e-5],
        };
        let all = axes.configurations();
        // (one body without modes, two with) times two scalars and three steps
        assert_eq!(all.len(), (1 + 2) * 2 * 3);
        assert_eq!(all[0].key(), "m0-full-f64-rk4-h1e-3");
    }

    #[test]
    fn a_list_of_terms_has_a_name_fit_for_files() {
        let fidelity = Fidelity::from_term_names(["first_moment", "modal_rotation"]).unwrap();
        let integrator = Integrator::Rk4;
        let modes = SceneModes::first(4);
        let one = Configuration { modes, fidelity, scalar: ScalarType::F32, integrator, step: 2.5e-4 };
        assert_eq!(one.program(), "m4-first_moment+modal_rotation-f32-rk4");
        assert_eq!(one.key(), "m4-first_moment+modal_rotation-f32-rk4-h2.5e-4");
    }
}
