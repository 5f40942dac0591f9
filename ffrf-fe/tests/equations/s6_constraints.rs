//! Section 6: constraints, their Jacobians and the null space, (65) to (81).

use faer::Mat;
use ffrf_fe::formulations::constraints::{self, Triad};
use ffrf_fe::formulations::null_space::projection;
use ffrf_fe::formulations::rotation::{axial, skew};
use ffrf_test_kit::random::Random;

use crate::bodies::{State, each_state};
use crate::check::{VISIBLE, block, column, different, equal, identity, scaled, transposed, vanishes};

/// [C_r; C_f,1; ...] as a function of all 12 + 9M coordinates, (65) and (69).
fn all_constraints(coordinates: &Mat<f64>) -> Mat<f64> {
    let triad =
        |start: usize| -> Triad { [0, 1, 2].map(|i| [0, 1, 2].map(|j| coordinates[(start + 3 * i + j, 0)])) };
    let mut d = triad(3);
    for i in 0..3 {
        d[i][i] += 1.0;
    }
    let mut values = constraints::rigid(&d).to_vec();
    for mu in 0..(coordinates.nrows() - 12) / 9 {
        values.extend(constraints::flexible(&d, &triad(12 + 9 * mu)));
    }
    column(&values)
}

fn coordinates(state: &State) -> Mat<f64> {
    let tail = state.floating.generalized_coordinates();
    Mat::from_fn(3 + tail.nrows(), 1, |i, _| if i < 3 { 0.7 * (i as f64) - 0.2 } else { tail[(i - 3, 0)] })
}

/// Central differences, exact up to round-off since the constraints are quadratic.
fn differentiate(at: &Mat<f64>) -> Mat<f64> {
    let step = 0.5;
    let rows = all_constraints(at).nrows();
    let mut jacobian = Mat::zeros(rows, at.nrows());
    for k in 0..at.nrows() {
        let shifted = |h: f64| {
            let mut moved = at.clone();
            moved[(k, 0)] += h;
            all_constraints(&moved)
        };
        let slope = scaled(0.5 / step, &(shifted(step) - shifted(-step)));
        jacobian.as_mut().submatrix_mut(0, k, rows, 1).copy_from(slope);
    }
    jacobian
}

fn triads(state: &State) -> Vec<Triad> {
    (0..state.q.len()).map(|mu| state.mode_triad(mu)).collect()
}

#[test]
fn equation_065_orthonormal_directors() {
    each_state(|_, state| {
        vanishes(&column(&constraints::rigid(&state.d)), 1.0);
        let stretched = state.d.map(|d| d.map(|x| 1.1 * x));
        assert!(constraints::rigid(&stretched).iter().any(|c| c.abs() > VISIBLE));
    });
}

#[test]
fn equation_066_jacobian_of_the_rigid_constraints() {
    each_state(|_, state| {
        let found = constraints::rigid_jacobian(&state.d);
        equal(&found, &block(&differentiate(&coordinates(state)), 0, 3, 6, 9));
    });
}

#[test]
fn equation_067_rigid_constraints_depend_on_rotation_only() {
    each_state(|_, state| {
        let jacobian = differentiate(&coordinates(state));
        vanishes(&block(&jacobian, 0, 0, 6, 3), 1.0);
        vanishes(&block(&jacobian, 0, 12, 6, jacobian.ncols() - 12), 1.0);
    });
}

#[test]
fn equation_068_corotated_modal_coordinates() {
    each_state(|_, state| {
        for mu in 0..state.q.len() {
            let triad = state.mode_triad(mu);
            let transposed_q = Mat::from_fn(3, 3, |i, j| triad[j][i]);
            equal(&(state.a.transpose() * &transposed_q), &scaled(state.q[mu], &identity(3)));
            // Printed without the transpose of Q.
            different(&(state.a.transpose() * transposed_q.transpose()), &scaled(state.q[mu], &identity(3)));
        }
    });
}

#[test]
fn equation_069_flexible_constraints() {
    each_state(|_, state| {
        for mu in 0..state.q.len() {
            vanishes(&column(&constraints::flexible(&state.d, &state.mode_triad(mu))), state.q[mu].abs());
            let mut broken = state.mode_triad(mu);
            broken[0][0] += 1.0;
            assert!(constraints::flexible(&state.d, &broken).iter().any(|c| c.abs() > VISIBLE));
        }
    });
}

#[test]
fn equation_070_jacobians_of_the_flexible_constraints() {
    each_state(|_, state| {
        let jacobian = differentiate(&coordinates(state));
        for (mu, triad) in triads(state).iter().enumerate() {
            equal(
                &constraints::flexible_jacobian_own(&state.d),
                &block(&jacobian, 6 + 8 * mu, 12 + 9 * mu, 8, 9),
            );
            equal(&constraints::flexible_jacobian_rotation(triad), &block(&jacobian, 6 + 8 * mu, 3, 8, 9));
        }
    });
}

#[test]
fn equation_071_flexible_constraints_do_not_depend_on_translation() {
    each_state(|_, state| {
        let jacobian = differentiate(&coordinates(state));
        vanishes(&block(&jacobian, 6, 0, jacobian.nrows() - 6, 3), 1.0);
    });
}

#[test]
fn equation_072_whole_jacobian() {
    each_state(|_, state| {
        equal(&constraints::jacobian(&state.d, &triads(state)), &differentiate(&coordinates(state)));
    });
}

#[test]
fn equation_074_projection_spans_the_null_space() {
    each_state(|body, state| {
        let constraints = constraints::jacobian(&state.d, &triads(state));
        let p = projection(&state.floating);
        vanishes(&(&constraints * &p), 1.0);
        let rank = |matrix: &Mat<f64>| {
            let values = matrix.singular_values().expect("singular values converge");
            values.iter().filter(|&&s| s > 1e-10 * values[0]).count()
        };
        assert_eq!(rank(&p), 6 + body.mode_count());
        assert_eq!(
            constraints.ncols() - rank(&constraints),
            6 + body.mode_count(),
            "dimension of the kernel"
        );
    });
}

#[test]
fn equation_075_rotation_block() {
    each_state(|_, state| vanishes(&(constraints::rigid_jacobian(&state.d) * &state.p_rr), 1.0));
}

#[test]
fn equations_076_077_cross_product_matrix_and_its_inverse() {
    let mut random = Random::new(1);
    let (w, u) = (random.vector(), random.vector());
    let crossed = [w[1] * u[2] - w[2] * u[1], w[2] * u[0] - w[0] * u[2], w[0] * u[1] - w[1] * u[0]];
    equal(&(skew(w) * column(&u)), &column(&crossed));
    equal(&column(&axial(skew(w).as_ref())), &column(&w));
}

#[test]
fn equation_078_axial_vector_by_components() {
    let w = Random::new(2).vector();
    let matrix = skew(w);
    let epsilon = |i: usize, j: usize, k: usize| {
        ((i as f64) - (j as f64)) * ((j as f64) - (k as f64)) * ((k as f64) - (i as f64)) / 2.0
    };
    let contracted: Vec<f64> = (0..3)
        .map(|i| {
            (0..3)
                .flat_map(|j| (0..3).map(move |k| (j, k)))
                .map(|(j, k)| epsilon(i, j, k) * matrix[(j, k)])
                .sum()
        })
        .collect();
    equal(&scaled(-0.5, &column(&contracted)), &column(&w));
    // Printed without the factor one half.
    different(&scaled(-1.0, &column(&contracted)), &column(&w));
    equal(&Mat::from_fn(3, 3, |i, j| -(0..3).map(|k| epsilon(i, j, k) * w[k]).sum::<f64>()), &matrix);
}

#[test]
fn equations_079_080_flexible_blocks() {
    each_state(|_, state| {
        let own = constraints::flexible_jacobian_own(&state.d);
        vanishes(&(&own * &state.p_ff), 1.0);
        for (mu, triad) in triads(state).iter().enumerate() {
            let p_fr = block(&projection(&state.floating), 12 + 9 * mu, 3, 9, 3);
            let stacked = triad.map(skew);
            equal(&p_fr, &Mat::from_fn(9, 3, |i, j| -stacked[i / 3][(i % 3, j)]));
            let coupled = constraints::flexible_jacobian_rotation(triad) * &state.p_rr + &own * p_fr;
            vanishes(&coupled, state.q[mu].abs());
        }
    });
}

#[test]
fn equation_081_kronecker_products() {
    each_state(|body, state| {
        let p = projection(&state.floating);
        let modes = body.mode_count();
        let p_fr = Mat::from_fn(9 * modes, 3, |i, j| state.q[i / 9] * state.p_rr[(i % 9, j)]);
        equal(&block(&p, 12, 3, 9 * modes, 3), &p_fr);
        let p_ff =
            Mat::from_fn(9 * modes, modes, |i, j| if i / 9 == j { state.p_ff[(i % 9, 0)] } else { 0.0 });
        equal(&block(&p, 12, 6, 9 * modes, modes), &p_ff);
        equal(&(scaled(1.0 / 3.0, &transposed(&p_ff)) * &p_ff), &identity(modes));
    });
}
