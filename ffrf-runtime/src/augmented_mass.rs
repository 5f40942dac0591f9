//! The matrix of the linearly implicit stages: the mass matrix with stiffness and damping added.

use nalgebra::{Cholesky, Const, RealField, SMatrix, SVector};

use crate::phase::part;

/// Factors of M^ = M(q) + diag(0, 0, S), with S = γ h D_ff + γ² h² K_ff, flexible block first.
///
/// With M = [M_rr C; Cᵀ Θ_ff], the modes are eliminated through Θ_ff + S and the rigid motion follows from the
/// Schur complement M_rr - C (Θ_ff + S)⁻¹ Cᵀ, so the coupling of stiff modes with rigid motion is exact.
pub(crate) struct AugmentedMass<const M: usize, T: RealField> {
    /// Factor of Θ_ff + S. Shape: M x M.
    flexible: Cholesky<T, Const<M>>,
    /// Cᵀ, the coupling of modes with rigid motion. Shape: M x 6.
    coupling: SMatrix<T, M, 6>,
    /// (Θ_ff + S)⁻¹ Cᵀ. Shape: M x 6.
    followed: SMatrix<T, M, 6>,
    /// Factor of the Schur complement. Shape: 6 x 6.
    rigid: Cholesky<T, Const<6>>,
}

impl<const M: usize, T: RealField + Copy> AugmentedMass<M, T> {
    /// Factors `mass` with `implicit` (S) added to its flexible block; `None` if that is not positive definite.
    pub fn new<const N: usize>(mass: &SMatrix<T, N, N>, implicit: &SMatrix<T, M, M>) -> Option<Self> {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        let flexible = Cholesky::new(mass.fixed_view::<M, M>(6, 6) + implicit)?;
        let coupling = mass.fixed_view::<M, 6>(6, 0).into_owned();
        let followed = flexible.solve(&coupling);
        let rigid = Cholesky::new(mass.fixed_view::<6, 6>(0, 0) - coupling.tr_mul(&followed))?;
        Some(Self { flexible, coupling, followed, rigid })
    }

    /// Solves M^ w = `right`. Shape: N.
    pub fn solve<const N: usize>(&self, right: &SVector<T, N>) -> SVector<T, N> {
        const { assert!(N == 6 + M, "a body with M modes has N = 6 + M velocities") };
        let alone = self.flexible.solve(&part::<M, N, T>(right, 6));
        let rigid = self.rigid.solve(&(right.fixed_rows::<6>(0) - self.coupling.tr_mul(&alone)));
        let flexible = alone - self.followed * rigid;
        let mut solution = SVector::<T, N>::zeros();
        solution.fixed_rows_mut::<6>(0).copy_from(&rigid);
        solution.fixed_rows_mut::<M>(6).copy_from(&flexible);
        solution
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_the_full_system() {
        // positive definite by diagonal dominance, unsymmetric in no entry
        let mass = SMatrix::<f64, 8, 8>::from_fn(|i, j| {
            if i == j { 10.0 + i as f64 } else { 0.1 * (i + j) as f64 - 0.05 * (i * j) as f64 }
        });
        let implicit = SMatrix::<f64, 2, 2>::new(5.0, 1.0, 1.0, 7.0);
        let right = SVector::<f64, 8>::from_fn(|i, _| 1.0 - 0.3 * i as f64);
        let solution = AugmentedMass::new(&mass, &implicit).unwrap().solve(&right);
        let mut full = mass;
        for i in 0..2 {
            for j in 0..2 {
                full[(6 + i, 6 + j)] += implicit[(i, j)];
            }
        }
        assert!((full * solution - right).amax() < 1e-14);
    }

    #[test]
    fn refuses_what_is_not_positive() {
        let mass = SMatrix::<f64, 7, 7>::identity();
        assert!(AugmentedMass::new(&mass, &SMatrix::<f64, 1, 1>::new(-2.0)).is_none());
        assert!(AugmentedMass::new(&mass, &SMatrix::<f64, 1, 1>::new(f64::NAN)).is_none());
    }

    #[test]
    fn a_rigid_body_has_no_flexible_block() {
        let mass = SMatrix::<f64, 6, 6>::identity() * 2.0;
        let solution =
            AugmentedMass::new(&mass, &SMatrix::<f64, 0, 0>::zeros())
                .unwrap()
                .solve(&SVector::<f64, 6>::repeat(3.0));
        assert!((solution - SVector::<f64, 6>::repeat(1.5)).amax() < 1e-15);
    }
}
