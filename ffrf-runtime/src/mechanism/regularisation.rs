//! How redundant rows are dealt with.

use nalgebra::RealField;

use crate::six::{add_products, products, sum};

/// How redundant rows are dealt with: the proximal method, exact for consistent redundant rows, reactions of least norm.
///
/// The factored matrix has μ subtracted from the diagonal of the rows, and a bounded number of refinements takes its effect
/// out again: what it makes the rows leave over, μ times the last correction of their multipliers, is solved for anew,
/// until the next correction would be lost in round-off. Source: Carpentier, Budhiraja, Mansard, Proximal and sparse resolution of constrained dynamic equations,
/// RSS 2021.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularisation<T = f64> {
    /// μ relative to the compliance that each row meets. Units: 1.
    pub share: T,
    /// Most refinements.
    pub refinements: usize,
}

/// The share of a residual that μ may leave in one correction, times the condition number of the rows.
const NEGLIGIBLE: f64 = 1e-8;

impl<T: RealField + Copy> Regularisation<T> {
    /// For mechanisms whose joints close loops: 1e-9 and two refinements in double precision, 1e-3 and three in single.
    ///
    /// Measured on a four-bar linkage that passes its singular position: these equal an exact solution there.
    pub fn of_loops() -> Self {
        let share = if T::default_epsilon() < nalgebra::convert(1e-10) { 1e-9 } else { 1e-3 };
        let refinements = if share < 1e-6 { 2 } else { 3 };
        Self { share: nalgebra::convert(share), refinements }
    }

    /// Whether the next refinement would change multipliers by less than round-off of the system does.
    ///
    /// With the condition number κ a refinement changes its part of the last change by μ κ at most: when that was ε / μ of
    /// the whole, ε κ is left. Measured by Σ μ λ², in which forces and moments have one unit.
    pub(super) fn is_met(&self, shift: &[[T; 6]], solution: &[[T; 6]], change: &[[T; 6]]) -> bool {
        let squares = |numbers: &[[T; 6]]| {
            let mut squares = [T::zero(); 6];
            for (shift, numbers) in shift.iter().zip(numbers) {
                add_products(&mut squares, &products(shift, numbers), numbers);
            }
            sum(&squares)
        };
        let share = T::default_epsilon() / self.share;
        squares(change) <= share * share * squares(solution)
    }

    /// Refinements of corrections of places and velocities, which are repeated until their residuals are small: none, unless
    /// μ leaves more than digits that a correction does not have.
    pub(super) fn refinements_of_corrections(&self) -> usize {
        let negligible: T = nalgebra::convert(NEGLIGIBLE);
        if self.share > negligible { self.refinements } else { 0 }
    }

    /// For trees, whose rows are never redundant: nothing is added, nothing to refine.
    pub fn of_trees() -> Self {
        Self { share: T::zero(), refinements: 0 }
    }
}
