//! Sections 6.3 and 7.1: shape of the projection and the constrained equations of motion, (73) and (82) to (88).

use faer::Mat;
use ffrf_fe::formulations::gcms::apply_mass;
use ffrf_fe::formulations::null_space::projection;
use ffrf_fe::formulations::rotation::block_diagonal;

use crate::bodies::{Body, Part, State, each_body, each_state};
use crate::check::{block, column, equal, equal_within, identity, largest, scaled, vanishes};

/// q of (19) with q_t = 0.
fn coordinates(state: &State) -> Mat<f64> {
    let tail = state.floating.generalized_coordinates();
    Mat::from_fn(3 + tail.nrows(), 1, |i, _| if i < 3 { 0.0 } else { tail[(i - 3, 0)] })
}

#[test]
fn equation_073_shape_of_the_projection() {
    each_state(|body, state| {
        let p = projection(&state.floating);
        let modes = body.mode_count();
        assert_eq!((p.nrows(), p.ncols()), (12 + 9 * modes, 6 + modes));
        equal(&block(&p, 0, 0, 3, 3), &identity(3));
        for (row, rows, col, columns) in
            [(0, 3, 3, 3 + modes), (3, 9, 0, 3), (3, 9, 6, modes), (12, 9 * modes, 0, 3)]
        {
            assert_eq!(largest(&block(&p, row, col, rows, columns)), 0.0);
        }
        equal(&block(&p, 3, 3, 9, 3), &state.p_rr);
    });
}

#[test]
fn equation_082_flexible_coordinates_of_a_rigid_frame() {
    each_state(|body, state| {
        // With C_r = 0 the polar rotation of I + Q_rᵀ is A itself, hence q_r = q_r* and q_flex = [0; 0; q_f].
        let q = coordinates(state);
        let a = Mat::from_fn(3, 3, |i, j| q[(3 + 3 * j + i, 0)] + if i == j { 1.0 } else { 0.0 });
        let svd = a.svd().expect("singular values converge");
        equal(&(svd.U() * svd.V().transpose()), &state.a);
        // And q_f alone is the flexible displacement: Φ_f q_f = A_bd Ψ q'.
        let q_f = block(&q, 12, 0, 9 * body.mode_count(), 1);
        let turned = block_diagonal(state.a.as_ref(), body.positions.len()) * &body.shapes * column(&state.q);
        equal(&(body.modes.flexible() * q_f), &turned);
    });
}

#[test]
fn equations_083_084_blocks_of_the_reduced_matrices() {
    each_body(|body| {
        let parts = [Part::T, Part::R, Part::F];
        let columns = [body.modes.translation(), body.modes.rotation(), body.modes.flexible()];
        for (left, a) in parts.iter().zip(columns) {
            for (right, b) in parts.iter().zip(columns) {
                let stiffness = a.transpose() * (&body.stiffness * b);
                equal_within(&body.k_block(*left, *right), &stiffness, largest(&body.reduced_stiffness));
                equal(&body.m_block(*left, *right), &(a.transpose() * apply_mass(&body.mass, b)));
            }
        }
    });
}

/// A_bd K̄ A_bdᵀ.
fn turned(state: &State, stiffness: &Mat<f64>) -> Mat<f64> {
    let left = block_diagonal(state.a.as_ref(), stiffness.nrows() / 3);
    let right = block_diagonal(state.a.as_ref(), stiffness.ncols() / 3);
    left * stiffness * right.transpose()
}

#[test]
fn equation_086_rotated_stiffness() {
    each_state(|body, state| {
        // A_bd and Φ commute, so rotating the reduced stiffness is reducing the rotated stiffness.
        let a_bd = block_diagonal(state.a.as_ref(), body.positions.len());
        for (left, a) in [(Part::R, body.modes.rotation()), (Part::F, body.modes.flexible())] {
            for (right, b) in [(Part::R, body.modes.rotation()), (Part::F, body.modes.flexible())] {
                let inner = &body.stiffness * (a_bd.transpose() * b);
                let rotated = (a_bd.transpose() * a).transpose() * inner;
                let scale = largest(&body.reduced_stiffness);
                equal_within(&turned(state, &body.k_block(left, right)), &rotated, scale);
            }
        }
    });
}

fn split(body: &Body, vector: &Mat<f64>) -> [Mat<f64>; 3] {
    [block(vector, 0, 0, 3, 1), block(vector, 3, 0, 9, 1), block(vector, 12, 0, 9 * body.mode_count(), 1)]
}

#[test]
fn equation_087_reduced_equations_by_blocks() {
    each_state(|body, state| {
        // The block form is Φᵀ of the full-order equation M r̈ + A_bd K A_bdᵀ u_f, term by term.
        let acceleration = Mat::from_fn(12 + 9 * body.mode_count(), 1, |i, _| (1.3 * i as f64).sin());
        let inertia = body.modes.shapes.transpose()
            * apply_mass(&body.mass, (&body.modes.shapes * &acceleration).as_ref());
        let [q_t, q_r, q_f] = split(body, &acceleration);
        let by_blocks = |row: Part| {
            body.m_block(row, Part::T) * &q_t
                + body.m_block(row, Part::R) * &q_r
                + body.m_block(row, Part::F) * &q_f
        };
        for (row, expected) in [Part::T, Part::R, Part::F].into_iter().zip(split(body, &inertia)) {
            equal_within(&by_blocks(row), &expected, largest(&inertia));
        }
        let a_bd = block_diagonal(state.a.as_ref(), body.positions.len());
        let elastic = a_bd * (&body.stiffness * (&body.shapes * column(&state.q)));
        let [t, r, f] = split(body, &(body.modes.shapes.transpose() * elastic));
        let [_, _, q_f] = split(body, &coordinates(state));
        let scale = largest(&body.reduced_stiffness) * largest(&q_f) * 9.0;
        vanishes(&t, scale);
        equal_within(&(turned(state, &body.k_block(Part::R, Part::F)) * &q_f), &r, scale);
        equal_within(&(turned(state, &body.k_block(Part::F, Part::F)) * &q_f), &f, scale);
    });
}

#[test]
fn equation_088_constraint_jacobian_of_a_ground_joint() {
    each_state(|body, state| {
        // C_b = Φ_n q - const at node n: its three blocks are the node's rows of Φ_t, Φ_r, Φ_f, and moving the
        // coordinates by δ moves the node by C_λ δ.
        let node = body.positions.len() - 1;
        let rows = block(&body.modes.shapes, 3 * node, 0, 3, 12 + 9 * body.mode_count());
        let delta = Mat::from_fn(rows.ncols(), 1, |i, _| (0.7 * i as f64).cos());
        let at = |q: &Mat<f64>| block(&(&body.modes.shapes * q), 3 * node, 0, 3, 1);
        let q = coordinates(state);
        equal_within(&(at(&(&q + &delta)) - at(&q)), &(&rows * &delta), largest(&(&rows * &delta)));
        equal(&block(&rows, 0, 0, 3, 3), &identity(3));
        let x = body.positions[node];
        equal(&block(&rows, 0, 3, 3, 9), &Mat::from_fn(3, 9, |i, j| if j % 3 == i { x[j / 3] } else { 0.0 }));
        // Its projection maps [w_t; ω; q̇'] to the velocity of the node relative to the origin's.
        let w =
            Mat::from_fn(6 + body.mode_count(), 1, |i, _| if i < 3 { 0.0 } else { 1.0 / (1.0 + i as f64) });
        let velocity = &rows * projection(&state.floating) * &w;
        let jacobian = crate::nodal::jacobian(body, state);
        equal(&velocity, &block(&(scaled(1.0, &jacobian) * w), 3 * node, 0, 3, 1));
    });
}
