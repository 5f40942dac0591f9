//! Section 7.4: mass matrices of the generalised component modes, (107) to (132).
//!
//! The volume integrals of the same section, (112), (114), (122), (125) and (131), need elements
//! and stand in the tests of the element quadrature.

use faer::Mat;

use crate::bodies::{Body, Part, each_body};
use crate::check::{block, different, equal, identity, scaled, transposed};

/// [t^{ij} I] for a 3 x 3 matrix of coefficients.
pub fn kronecker_identity(coefficients: &Mat<f64>) -> Mat<f64> {
    Mat::from_fn(3 * coefficients.nrows(), 3 * coefficients.ncols(), |i, j| {
        if i % 3 == j % 3 { coefficients[(i / 3, j / 3)] } else { 0.0 }
    })
}

fn pairs(body: &Body) -> Vec<(usize, usize)> {
    (0..body.mode_count()).flat_map(|mu| (0..body.mode_count()).map(move |nu| (mu, nu))).collect()
}

#[test]
fn equation_108_translational_mass() {
    each_body(|body| equal(&body.m_block(Part::T, Part::T), &scaled(body.m(), &identity(3))));
}

#[test]
fn equation_111_translation_rotation_mass() {
    each_body(|body| {
        equal(&body.m_block(Part::T, Part::R), &kronecker_identity(&transposed(&body.first_moment())));
    });
}

#[test]
fn equations_113_116_translation_flexible_mass() {
    each_body(|body| {
        let whole = body.m_block(Part::T, Part::F);
        for mu in 0..body.mode_count() {
            let expected = kronecker_identity(&transposed(&body.modal_first_moment(mu)));
            equal(&body.m_block(Part::T, Part::Mode(mu)), &expected);
            equal(&block(&whole, 0, 9 * mu, 3, 9), &expected);
        }
    });
}

#[test]
fn equations_118_119_any_coordinate_direction_will_do() {
    each_body(|body| {
        // The footnote: e_2 or e_3 serve as well as e_1, because the mass matrix is isotropic.
        let along = |direction: usize| {
            let field = Mat::from_fn(3 * body.positions.len(), 3, |row, i| {
                if row % 3 == direction { body.positions[row / 3][i] } else { 0.0 }
            });
            body.mass_product(&field, &field)
        };
        equal(&along(0), &along(1));
        equal(&along(0), &along(2));
    });
}

#[test]
fn equation_120_mass_and_first_moments() {
    each_body(|body| {
        let scalar: Vec<Vec<f64>> = (0..body.positions.len())
            .map(|n| (0..body.positions.len()).map(|k| body.mass.get(n, k).copied().unwrap_or(0.0)).collect())
            .collect();
        let total: f64 = scalar.iter().flatten().sum();
        equal(&Mat::from_fn(1, 1, |_, _| body.m()), &Mat::from_fn(1, 1, |_, _| total));
        let weighted = |field: &dyn Fn(usize, usize) -> f64| {
            Mat::from_fn(3, 1, |i, _| {
                (0..body.positions.len()).map(|n| scalar[n].iter().sum::<f64>() * field(n, i)).sum::<f64>()
            })
        };
        equal(&body.first_moment(), &weighted(&|n, i| body.positions[n][i]));
        for mu in 0..body.mode_count() {
            equal(&body.modal_first_moment(mu), &weighted(&|n, i| body.shapes[(3 * n + i, mu)]));
        }
    });
}

#[test]
fn equation_121_rotational_mass() {
    each_body(|body| equal(&body.m_block(Part::R, Part::R), &kronecker_identity(&body.t())));
}

#[test]
fn equations_123_124_rotation_flexible_mass() {
    each_body(|body| {
        let whole = body.m_block(Part::R, Part::F);
        for mu in 0..body.mode_count() {
            equal(&block(&whole, 0, 9 * mu, 9, 9), &kronecker_identity(&body.t_mu(mu)));
        }
    });
}

#[test]
fn equations_126_127_132_euler_tensors() {
    each_body(|body| {
        // Node by node: Σ M_s,nk x_nⁱ x_kʲ and its modal relatives.
        let sum = |left: &dyn Fn(usize, usize) -> f64, right: &dyn Fn(usize, usize) -> f64| {
            Mat::from_fn(3, 3, |i, j| {
                let nodes = body.positions.len();
                (0..nodes)
                    .flat_map(|n| (0..nodes).map(move |k| (n, k)))
                    .map(|(n, k)| body.mass.get(n, k).copied().unwrap_or(0.0) * left(n, i) * right(k, j))
                    .sum::<f64>()
            })
        };
        let position = |n: usize, i: usize| body.positions[n][i];
        equal(&body.t(), &sum(&position, &position));
        for (mu, nu) in pairs(body) {
            let mode_mu = |n: usize, i: usize| body.shapes[(3 * n + i, mu)];
            let mode_nu = |n: usize, i: usize| body.shapes[(3 * n + i, nu)];
            equal(&body.t_mu(mu), &sum(&position, &mode_mu));
            equal(&body.t_munu(mu, nu), &sum(&mode_mu, &mode_nu));
        }
    });
}

#[test]
fn equations_129_130_flexible_mass() {
    each_body(|body| {
        let whole = body.m_block(Part::F, Part::F);
        for (mu, nu) in pairs(body) {
            equal(&block(&whole, 9 * mu, 9 * nu, 9, 9), &kronecker_identity(&body.t_munu(mu, nu)));
        }
        if body.mode_count() > 1 {
            let last = body.mode_count() - 1;
            let lower_left = block(&whole, 9 * last, 0, 9, 9);
            let m_1m = kronecker_identity(&body.t_munu(0, last));
            equal(&lower_left, &transposed(&m_1m));
            // Printed as M_M1ᵀ, which is M_1M.
            different(&lower_left, &transposed(&kronecker_identity(&body.t_munu(last, 0))));
        }
    });
}

#[test]
fn equations_122_131_symmetries_of_the_euler_tensors() {
    each_body(|body| {
        equal(&body.t(), &transposed(&body.t()));
        for (mu, nu) in pairs(body) {
            equal(&body.t_munu(mu, nu), &transposed(&body.t_munu(nu, mu)));
        }
        // (125): T_μ is not symmetric.
        different(&body.t_mu(0), &transposed(&body.t_mu(0)));
    });
}
