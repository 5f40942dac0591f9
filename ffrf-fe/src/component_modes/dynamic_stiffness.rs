//! Response of the full model at one frequency: (K - ω²M) u = f, undamped.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::cholesky::{SymbolicCholesky, SymmetricOrdering};
use faer::{Conj, Mat, MatRef, Par, Side};

use crate::FeError;
use crate::modes::{ModeError, analyse, node_order, permutation};

use super::ComponentModeError;
use super::coordinates::Coordinates;
use super::frequency::eigenvalue;

/// Largest residual accepted: the response is then right to about this part of the distance to a resonance.
const RESIDUAL: f64 = 1e-8;
/// Steps of refinement.
const REFINEMENTS: usize = 4;

/// The dynamic stiffness of a model, analysed once for all frequencies.
pub(crate) struct DynamicStiffness<'a> {
    coordinates: &'a Coordinates<'a>,
    number: Vec<Option<u32>>,
    symbolic: SymbolicCholesky<u32>,
}

impl<'a> DynamicStiffness<'a> {
    /// Errors: [`ModeError::FactorTooLarge`].
    pub fn new(coordinates: &'a Coordinates<'a>) -> Result<Self, ModeError> {
        let number: Vec<Option<u32>> = (0..coordinates.dimension() as u32).map(Some).collect();
        // Any shift but zero: the pattern is that of stiffness and mass together.
        let (lower, node_of) = coordinates.shifted_lower(-1.0, &number);
        let too_large = |_| ModeError::FactorTooLarge { size: lower.nrows() };
        let order = node_order(&lower, &node_of, &coordinates.node_positions())?.order;
        let pattern = lower.symbolic().to_owned().map_err(too_large)?;
        let permutation = permutation(&order);
        let symbolic =
            analyse(&pattern, SymmetricOrdering::Custom(permutation.as_ref())).map_err(too_large)?;
        Ok(Self { coordinates, number, symbolic })
    }

    /// (K - ω²M)⁻¹ F by Bunch-Kaufman pivots within supernodes and refinement.
    ///
    /// Errors: [`ComponentModeError::Response`] if the residual stays large, as it does on a resonance.
    pub fn solve(&self, frequency_hz: f64, forces: MatRef<'_, f64>) -> Result<Mat<f64>, FeError> {
        let value = eigenvalue(frequency_hz);
        let (lower, _) = self.coordinates.shifted_lower(value, &self.number);
        let size = lower.nrows();
        let par = Par::Seq;
        let mut values = vec![0.0; self.symbolic.len_val()];
        let (mut below, mut forward, mut inverse) = (vec![0.0; size], vec![0_u32; size], vec![0_u32; size]);
        let scratch = self.symbolic.factorize_numeric_intranode_lblt_scratch::<f64>(par, Default::default());
        let mut memory = MemBuffer::try_new(scratch).map_err(|_| ModeError::FactorTooLarge { size })?;
        let factor = self.symbolic.factorize_numeric_intranode_lblt(
            &mut values,
            &mut below,
            &mut forward,
            &mut inverse,
            lower.as_ref(),
            Side::Lower,
            par,
            MemStack::new(&mut memory),
            Default::default(),
        );
        let mut memory = MemBuffer::new(self.symbolic.solve_in_place_scratch::<f64>(forces.ncols(), par));
        let mut solution = Mat::zeros(size, forces.ncols());
        let mut rest = forces.to_owned();
        let mut residual = f64::INFINITY;
        for _ in 0..=REFINEMENTS {
            factor.solve_in_place_with_conj(Conj::No, rest.as_mut(), par, MemStack::new(&mut memory));
            solution += &rest;
            rest = forces - self.coordinates.stiffness_times(solution.as_ref());
            rest += faer::Scale(value) * self.coordinates.mass_times(solution.as_ref());
            let last = residual;
            residual = relative(&rest, forces);
            if residual <= 1e-3 * RESIDUAL || residual >= 0.5 * last {
                break;
            }
        }
        if residual.is_nan() || residual > RESIDUAL {
            return Err(ComponentModeError::Response { frequency_hz, residual, limit: RESIDUAL }.into());
        }
        Ok(solution)
    }
}

fn relative(rest: &Mat<f64>, forces: MatRef<'_, f64>) -> f64 {
    (0..forces.ncols()).fold(0.0_f64, |largest, j| {
        let norm = forces.col(j).norm_l2();
        let ratio = if norm > 0.0 { rest.col(j).norm_l2() / norm } else { 0.0 };
        // A number that is none must not be lost in a maximum.
        if ratio.is_nan() {
            f64::NAN
        } else if largest.is_nan() {
            largest
        } else {
            largest.max(ratio)
        }
    })
}
