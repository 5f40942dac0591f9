//! Displacements of forces while the interfaces move as prescribed.

use faer::{Mat, MatRef, Par};

use crate::FeError;
use crate::modes::{gram, product, subtract_product, symmetrised};

use super::ComponentModeError;
use super::flexibility::Flexibility;
use super::interface_motion::InterfaceMotion;
use super::jacobi;

/// Least pivot of the scaled interface compliance: at this ratio the interface forces keep about four digits.
const LEAST_PIVOT: f64 = 1e-12;

/// The part with the motion of its interfaces prescribed.
///
/// Displacements u = G (f - Bᵀλ) + R a with B u = q and RᵀBᵀλ = Rᵀf: the interface forces λ balance the load.
pub(crate) struct Constrained<'a> {
    pub flexibility: &'a Flexibility<'a>,
    pub motion: &'a InterfaceMotion,
    /// G Bᵀ. Shape: n x m.
    compliance: Mat<f64>,
    /// Eigenvalues and scaled eigenvectors of [BGBᵀ, -BR; -RᵀBᵀ, 0].
    values: Vec<f64>,
    vectors: Mat<f64>,
}

impl<'a> Constrained<'a> {
    /// `elastic` is the diagonal of B G_e Bᵀ, which scales the interface forces.
    ///
    /// Errors: [`ComponentModeError::Dependent`] if the interfaces cannot move independently.
    pub fn new(
        flexibility: &'a Flexibility<'a>,
        motion: &'a InterfaceMotion,
        elastic: &[f64],
    ) -> Result<Self, FeError> {
        let coordinates = flexibility.coordinates;
        let compliance = flexibility.supported(motion.forces(coordinates).as_ref());
        let at_interfaces = symmetrised(motion.of(coordinates, compliance.as_ref()).as_ref());
        let rigid = motion.of(coordinates, flexibility.rigid.shapes.as_ref());
        let (count, rigid_count) = (motion.count(), rigid.ncols());
        let saddle =
            Mat::from_fn(count + rigid_count, count + rigid_count, |i, j| match (i < count, j < count) {
                (true, true) => at_interfaces[(i, j)],
                (true, false) => -rigid[(i, j - count)],
                (false, true) => -rigid[(j, i - count)],
                (false, false) => 0.0,
            });
        let scale = scaling(elastic, &rigid);
        let scaled =
            Mat::from_fn(saddle.nrows(), saddle.ncols(), |i, j| saddle[(i, j)] * scale[i] * scale[j]);
        let (values, vectors) = jacobi::eigen(scaled.as_ref())?;
        let largest = values.iter().fold(0.0_f64, |max, value| max.max(value.abs()));
        let smallest = values.iter().fold(f64::INFINITY, |min, value| min.min(value.abs()));
        let pivot = if largest > 0.0 { smallest / largest } else { 0.0 };
        if pivot.is_nan() || pivot < LEAST_PIVOT {
            return Err(ComponentModeError::Dependent { motions: count, pivot, least: LEAST_PIVOT }.into());
        }
        let vectors = Mat::from_fn(vectors.nrows(), vectors.ncols(), |i, j| vectors[(i, j)] * scale[i]);
        Ok(Self { flexibility, motion, compliance, values, vectors })
    }

    /// Displacements of `forces` with the interfaces at `motion` (m x k).
    pub fn solve(&self, forces: MatRef<'_, f64>, motion: MatRef<'_, f64>) -> Mat<f64> {
        let free = self.flexibility.supported(forces);
        let reached = self.motion.of(self.flexibility.coordinates, free.as_ref());
        let resultant = gram(self.flexibility.rigid.shapes.as_ref(), forces, Par::Seq);
        let count = self.motion.count();
        let right = Mat::from_fn(self.values.len(), forces.ncols(), |i, j| {
            if i < count { reached[(i, j)] - motion[(i, j)] } else { -resultant[(i - count, j)] }
        });
        let mut modal = gram(self.vectors.as_ref(), right.as_ref(), Par::Seq);
        for j in 0..modal.ncols() {
            for (i, value) in self.values.iter().enumerate() {
                modal[(i, j)] /= value;
            }
        }
        let solution = product(self.vectors.as_ref(), modal.as_ref(), Par::Seq);
        let mut shapes = free + self.flexibility.rigid_shapes(solution.get(count.., ..));
        subtract_product(shapes.as_mut(), self.compliance.as_ref(), solution.get(..count, ..), Par::Seq);
        shapes
    }

    /// [`Self::solve`] with one step of refinement, for the few shapes that enter a basis.
    pub fn solve_refined(&self, forces: MatRef<'_, f64>, motion: MatRef<'_, f64>) -> Mat<f64> {
        let coordinates = self.flexibility.coordinates;
        let shapes = self.solve(forces, motion);
        let rest = forces - coordinates.stiffness_times(shapes.as_ref());
        let missed = motion - self.motion.of(coordinates, shapes.as_ref());
        let correction = self.solve(rest.as_ref(), missed.as_ref());
        shapes + correction
    }

    /// Displacements of forces with the interfaces at rest.
    pub fn clamped(&self, forces: MatRef<'_, f64>) -> Mat<f64> {
        self.solve(forces, Mat::zeros(self.motion.count(), forces.ncols()).as_ref())
    }

    /// Static shapes of a unit motion of each interface coordinate, all others at rest. Shape: n x m.
    pub fn constraint_modes(&self) -> Mat<f64> {
        let count = self.motion.count();
        let none = Mat::zeros(self.flexibility.coordinates.dimension(), count);
        self.solve_refined(none.as_ref(), Mat::identity(count, count).as_ref())
    }
}

/// Interface forces in units that give a unit elastic displacement, and rigid amounts in units that displace the
/// interfaces by at most one in those: then no block of the matrix outweighs another.
fn scaling(elastic: &[f64], rigid: &Mat<f64>) -> Vec<f64> {
    let inverse_root = |x: f64| if x > 0.0 { x.sqrt().recip() } else { 1.0 };
    let forces: Vec<f64> = elastic.iter().map(|&compliance| inverse_root(compliance)).collect();
    let amounts = (0..rigid.ncols()).map(|k| {
        let largest = (0..rigid.nrows()).fold(0.0_f64, |max, i| max.max((forces[i] * rigid[(i, k)]).abs()));
        if largest > 0.0 { largest.recip() } else { 1.0 }
    });
    forces.iter().copied().chain(amounts).collect()
}
