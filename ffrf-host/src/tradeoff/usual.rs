//! The grid that is run where the user names none.

use ffrf_codegen::ScalarType;

use super::{Axes, Modes, Study};
use crate::scene::Integrator;

/// The usual steps: so many, each this much smaller than the one before.
const STEPS: i32 = 5;
const STEP_FACTOR: f64 = 4.0;

/// One explicit method, and the two that take stiff modes implicitly.
const INTEGRATORS: [Integrator; 3] =
    [Integrator::Rk4, Integrator::LinearlyImplicit, Integrator::GeneralizedAlpha];

impl Axes {
    /// Modes doubled up to all, the levels of terms that the bodies have, both number types, one explicit and two implicit methods, and steps from
    /// the interval between samples down.
    pub fn usual(study: &Study) -> Self {
        let most = study.most_modes();
        let doubled =
            std::iter::successors(Some(1), |modes| Some(2 * modes)).take_while(|modes| *modes < most);
        Self {
            modes: std::iter::once(0)
                .chain(doubled)
                .chain((most > 0).then_some(most))
                .map(Modes::first)
                .collect(),
            fidelities: study.levels(),
            scalars: vec![ScalarType::F64, ScalarType::F32],
            integrators: INTEGRATORS.to_vec(),
            steps: (0..STEPS).map(|k| study.interval() / STEP_FACTOR.powi(k)).collect(),
        }
    }
}
