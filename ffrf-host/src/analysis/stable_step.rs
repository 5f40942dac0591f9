//! The largest step with which explicit integrators keep small motions of a scene bounded: modes, joints and force elements
//! together.

use ffrf_runtime::State;
use nalgebra::Complex;

use super::{AnalysisError, Drives, eigenmodes, linearise};
use crate::HostModal;
use crate::scene::{Integrator, Scene};

/// |R(z)| up to this counts as stable: of undamped motion it is 1, and eigenvalues have round-off.
const BOUNDED: f64 = 1.0 + 1e-9;

/// Steps times |λ| beyond this are stable in no explicit method here.
const FARTHEST: f64 = 6.0;

/// Steps times |λ| that are tried in between.
const TRIED: usize = 600;

/// The largest step of an explicit integrator that keeps small motions about `state` bounded. Units: s.
///
/// By the eigenvalues of the scene, linearised there at `time` (s): derivatives of 6 + M velocities of each body, and a dense
/// eigenvalue problem of their number. Motion that grows or decays by itself, slower than the step could see, does not count.
/// `None` if nothing limits the step, and for implicit integrators. Errors: see [`linearise`], [`eigenmodes`].
///
/// Source: stability polynomials, Hairer & Wanner, Solving Ordinary Differential Equations II, IV.2; of the symplectic Euler
/// method its characteristic polynomial for q̈ + 2 ζ ω q̇ + ω² q = 0, bounded for h² ω² + 4 ζ h ω ≤ 4.
pub fn largest_explicit_step(
    scene: &Scene,
    time: f64,
    state: &[State<HostModal>],
    integrator: Integrator,
) -> Result<Option<f64>, AnalysisError> {
    if !integrator.is_explicit() {
        return Ok(None);
    }
    let system = linearise(scene, time, state, Drives::Moving)?;
    let steps = eigenmodes(&system.a)?.into_iter().filter_map(|mode| {
        let size = mode.eigenvalue.norm();
        // what grows by itself is no matter of the step
        (size > 0.0 && mode.eigenvalue.re <= 1e-6 * size)
            .then(|| radius(integrator, mode.eigenvalue / size) / size)
    });
    Ok(steps.reduce(f64::min).filter(|step| step.is_finite()))
}

/// The largest h |λ| that is stable, for an eigenvalue in this direction.
fn radius(integrator: Integrator, direction: Complex<f64>) -> f64 {
    let damping = (-direction.re).max(0.0);
    if integrator == Integrator::SymplecticEuler {
        // r² + 4 ζ r = 4
        return 2.0 * ((damping * damping + 1.0).sqrt() - damping);
    }
    let coefficients: &[f64] = match integrator {
        Integrator::Dopri5 => &[1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0, 1.0 / 120.0, 1.0 / 600.0],
        _ => &[1.0, 1.0, 1.0 / 2.0, 1.0 / 6.0, 1.0 / 24.0],
    };
    let direction = Complex::new(-damping, direction.im);
    let bounded = |radius: f64| {
        let z = direction * radius;
        let sum =
            coefficients.iter().rev().fold(Complex::new(0.0, 0.0), |sum, c| sum * z + Complex::new(*c, 0.0));
        sum.norm() <= BOUNDED
    };
    let tried = (1..=TRIED).map(|k| FARTHEST * k as f64 / TRIED as f64);
    tried.take_while(|radius| bounded(*radius)).last().unwrap_or(0.0)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The spacing of the radii that are tried.
    const SPACING: f64 = FARTHEST / TRIED as f64;

    #[test]
    fn radii_are_those_of_the_methods() {
        let (real, imaginary) = (Complex::new(-1.0, 0.0), Complex::new(0.0, 1.0));
        for (integrator, direction, expected) in [
            (Integrator::Rk4, imaginary, 8.0_f64.sqrt()),
            (Integrator::Rk4, real, 2.785),
            (Integrator::Dopri5, real, 3.307),
            (Integrator::SymplecticEuler, imaginary, 2.0),
        ] {
            let found = radius(integrator, direction);
            assert!((found - expected).abs() <= SPACING, "{integrator:?} {direction}: {found}, {expected}");
        }
    }
}
