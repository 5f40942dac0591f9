//! The highest frequency of a free body, and the largest step of an explicit integrator that follows from it.

use crate::ReducedBody;
use crate::eigenvalues::{cholesky, congruent, largest_eigenvalue};
use crate::independence::elastic_mass;

/// Radius about zero within which the classical Runge-Kutta method of order four is stable, for eigenvalues on the
/// negative real axis and for those of a damping ratio up to 0.3.
///
/// |R(z)| ≤ 1 with R(z) = 1 + z + z²/2 + z³/6 + z⁴/24 holds up to 2.785 on the real axis and 2√2 = 2.828 on the
/// imaginary one, and further at the damping ratios between 0 and 0.3. Source: Hairer & Wanner, Solving Ordinary
/// Differential Equations II, section IV.2; the numbers by bisection of |R(z)| = 1.
const RADIUS: f64 = 2.785;

/// The same radius for every eigenvalue of the left half plane; least at a damping ratio of 0.55.
const LEAST_RADIUS: f64 = 2.615;

/// Up to this ratio of D to the highest frequency, both of unit modal mass, every eigenvalue that is large enough to
/// matter has a damping ratio below 0.3.
///
/// An eigenvalue of damping ratio ζ and magnitude ω has 2 ζ ω ≤ d, the largest eigenvalue of D. Where the radius is
/// [`LEAST_RADIUS`] only ω above 2.615 / 2.785 of the highest frequency matters: ζ ≤ 0.55 / (2 · 0.939) = 0.29.
const LIGHT_DAMPING: f64 = 0.55;

impl ReducedBody {
    /// Highest natural frequency of the free, undeformed and undamped body with these modes.
    ///
    /// The square root of the largest eigenvalue of K_ff against what elimination of the rigid motion leaves of Θ_ff:
    /// the coupling of the modes with rigid motion and with each other raises it above the frequency of any one mode.
    /// `None` if the masses of the modes are not positive, which [`check`](Self::check) refuses.
    ///
    /// Units: radians per unit of time of the model. Source: (203) at q = 0.
    pub fn highest_frequency(&self) -> Option<f64> {
        self.largest_over_mass(&self.stiffness).map(|square| square.max(0.0).sqrt())
    }

    /// Largest step with which the classical Runge-Kutta method of order four is stable for small motions of the
    /// free body: 2.785 over the [highest frequency](Self::highest_frequency) where damping is light.
    ///
    /// Where damping is heavy it is a step that is stable whatever the damping ratios, down to about half the largest
    /// one near critical damping. Large deformation and fast rotation shift frequencies, and so does stiffness that
    /// forces bring along; none of this is in it.
    /// Infinite without stiffness and damping; `None` as for the frequency.
    ///
    /// Units: unit of time of the model.
    pub fn largest_stable_step(&self) -> Option<f64> {
        let frequency = self.highest_frequency()?;
        let damping = self.largest_over_mass(&self.damping)?.max(0.0);
        Some(if damping <= LIGHT_DAMPING * frequency {
            RADIUS / frequency
        } else {
            (LEAST_RADIUS / frequency).min(RADIUS / damping)
        })
    }

    /// Largest eigenvalue of a modal matrix against what rigid motion leaves of Θ_ff; 0 without modes.
    fn largest_over_mass(&self, matrix: &[Vec<f64>]) -> Option<f64> {
        self.check_shape().ok()?;
        let (mass, scale) = elastic_mass(&self.inertia)?;
        let factor = cholesky(mass)?;
        let scaled: Vec<Vec<f64>> = matrix
            .iter()
            .zip(&scale)
            .map(|(row, left)| row.iter().zip(&scale).map(|(entry, right)| entry * left * right).collect())
            .collect();
        let largest = largest_eigenvalue(congruent(&factor, &scaled)).unwrap_or(0.0);
        largest.is_finite().then_some(largest)
    }
}
