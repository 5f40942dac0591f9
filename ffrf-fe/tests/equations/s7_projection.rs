//! Sections 7.7 and 7.8: eccentricity and the projected mass matrix, (151) to (166).

use faer::Mat;
use ffrf_fe::formulations::null_space::projection;
use ffrf_fe::formulations::rotation::skew;

use crate::bodies::{Body, Part, State, each_state};
use crate::check::{as_vector, block, column, different, equal, scaled, sum, transposed, vanishes};
use crate::nodal;
use crate::s7_inertia::{inertia_of, inertia_vector};

/// Blocks P_fr (9M x 3) and P_ff (9M x M).
pub fn flexible_blocks(body: &Body, state: &State) -> (Mat<f64>, Mat<f64>) {
    let p = projection(&state.floating);
    let modes = body.mode_count();
    (block(&p, 12, 3, 9 * modes, 3), block(&p, 12, 6, 9 * modes, modes))
}

/// m a, m b_μ in inertial components.
pub fn spatial_moment(state: &State, moment: &Mat<f64>) -> Mat<f64> {
    &state.a * moment
}

/// m r = m a + q_μ m b_μ in body components, (204) with the sign corrected by `sign` = 1.
pub fn deformed_moment(body: &Body, state: &State, sign: f64) -> Mat<f64> {
    let flexible = (0..body.mode_count()).map(|mu| scaled(sign * state.q[mu], &body.modal_first_moment(mu)));
    body.first_moment() + sum(flexible)
}

/// Θ_rr(q) in body components, (204) corrected.
pub fn deformed_inertia(body: &Body, state: &State) -> Mat<f64> {
    let mut theta = inertia_of(&body.t());
    for mu in 0..body.mode_count() {
        let theta_mu = inertia_of(&body.t_mu(mu));
        theta += scaled(state.q[mu], &(&theta_mu + theta_mu.transpose()));
        for nu in 0..body.mode_count() {
            theta += scaled(state.q[mu] * state.q[nu], &inertia_of(&body.t_munu(mu, nu)));
        }
    }
    theta
}

/// Θ_rf(q) in body components, (204) corrected. Shape: 3 x M.
pub fn deformed_coupling(body: &Body, state: &State) -> Mat<f64> {
    let modes = body.mode_count();
    let mut theta = Mat::zeros(3, modes);
    for mu in 0..modes {
        let mut vector = inertia_vector(&body.t_mu(mu));
        for nu in 0..modes {
            vector += scaled(state.q[nu], &inertia_vector(&body.t_munu(nu, mu)));
        }
        theta.as_mut().submatrix_mut(0, mu, 3, 1).copy_from(vector);
    }
    theta
}

/// Θ_ff = [tr T_μν].
pub fn modal_mass(body: &Body) -> Mat<f64> {
    Mat::from_fn(body.mode_count(), body.mode_count(), |mu, nu| {
        let t = body.t_munu(mu, nu);
        t[(0, 0)] + t[(1, 1)] + t[(2, 2)]
    })
}

/// m B in body components. Shape: 3 x M.
pub fn modal_moments(body: &Body) -> Mat<f64> {
    Mat::from_fn(3, body.mode_count(), |i, mu| body.modal_first_moment(mu)[(i, 0)])
}

/// P M̄ P with P of (73): the left-hand side of (156).
fn projected_mass(body: &Body, state: &State) -> Mat<f64> {
    let p = projection(&state.floating);
    p.transpose() * &body.reduced_mass * &p
}

#[test]
fn equations_151_152_eccentricity_of_the_body() {
    each_state(|body, state| {
        let found = body.m_block(Part::T, Part::R) * &state.p_rr;
        let a = spatial_moment(state, &body.first_moment());
        equal(&found, &scaled(-1.0, &skew(as_vector(&a))));
        equal(&found, &scaled(-1.0, &state.rotate(&skew(as_vector(&body.first_moment())))));
        // Printed with a plus sign.
        different(&found, &skew(as_vector(&a)));
    });
}

#[test]
fn equations_153_154_155_eccentricity_of_the_modes() {
    each_state(|body, state| {
        for mu in 0..body.mode_count() {
            let b = spatial_moment(state, &body.modal_first_moment(mu));
            equal(&(body.m_block(Part::T, Part::Mode(mu)) * &state.p_ff), &b);
            let found = body.m_block(Part::T, Part::Mode(mu)) * &state.p_rr;
            equal(&found, &scaled(-1.0, &skew(as_vector(&b))));
        }
        let (_, p_ff) = flexible_blocks(body, state);
        equal(&(body.m_block(Part::T, Part::F) * p_ff), &(&state.a * modal_moments(body)));
    });
}

#[test]
fn equations_156_157_projected_mass_is_the_nodal_mass_matrix() {
    each_state(|body, state| {
        let truth = nodal::mass_matrix(body, state);
        let modes = body.mode_count();
        let found = projected_mass(body, state);
        for (row, rows) in [(0, 3), (3, 3), (6, modes)] {
            for (col, columns) in [(0, 3), (3, 3), (6, modes)] {
                let (a, b) = (block(&found, row, col, rows, columns), block(&truth, row, col, rows, columns));
                equal(&a, &b);
            }
        }
        let (p_fr, p_ff) = flexible_blocks(body, state);
        let (m_tr, m_tf) = (body.m_block(Part::T, Part::R), body.m_block(Part::T, Part::F));
        let (m_rr, m_rf) = (body.m_block(Part::R, Part::R), body.m_block(Part::R, Part::F));
        let m_ff = body.m_block(Part::F, Part::F);
        equal(&(&m_tr * &state.p_rr + &m_tf * &p_fr), &block(&truth, 0, 3, 3, 3));
        equal(&(&m_tf * &p_ff), &block(&truth, 0, 6, 3, modes));
        let rotational = state.p_rr.transpose() * &m_rr * &state.p_rr
            + state.p_rr.transpose() * &m_rf * &p_fr
            + p_fr.transpose() * m_rf.transpose() * &state.p_rr
            + p_fr.transpose() * &m_ff * &p_fr;
        equal(&rotational, &block(&truth, 3, 3, 3, 3));
        let coupling = state.p_rr.transpose() * &m_rf * &p_ff + p_fr.transpose() * &m_ff * &p_ff;
        equal(&coupling, &block(&truth, 3, 6, 3, modes));
        equal(&(p_ff.transpose() * &m_ff * &p_ff), &block(&truth, 6, 6, modes, modes));
    });
}

#[test]
fn equation_158_each_term_of_the_projection() {
    each_state(|body, state| {
        let (p_fr, p_ff) = flexible_blocks(body, state);
        let modes = body.mode_count();
        let weighted = |f: &dyn Fn(usize) -> Mat<f64>| sum((0..modes).map(|mu| scaled(state.q[mu], &f(mu))));
        let b_q = weighted(&|mu| spatial_moment(state, &body.modal_first_moment(mu)));
        equal(&(body.m_block(Part::T, Part::F) * &p_fr), &scaled(-1.0, &skew(as_vector(&b_q))));
        let m_rf = body.m_block(Part::R, Part::F);
        let m_ff = body.m_block(Part::F, Part::F);
        equal(
            &(state.p_rr.transpose() * &m_rf * &p_fr),
            &weighted(&|mu| state.rotate(&inertia_of(&body.t_mu(mu)))),
        );
        let double = weighted(&|mu| weighted(&|nu| state.rotate(&inertia_of(&body.t_munu(mu, nu)))));
        equal(&(p_fr.transpose() * m_ff.transpose() * &p_fr), &double);
        let xi_sum = weighted(&|mu| {
            Mat::from_fn(3, modes, |i, nu| (&state.a * inertia_vector(&body.t_munu(mu, nu)))[(i, 0)])
        });
        vanishes(&(p_fr.transpose() * m_ff.transpose() * &p_ff - &xi_sum), m_ff.norm_max());
        equal(&(p_ff.transpose() * m_ff.transpose() * &p_ff), &modal_mass(body));
    });
}

#[test]
fn equations_160_161_162_modal_mass_is_constant() {
    each_state(|body, state| {
        let theta_ff = modal_mass(body);
        equal(&theta_ff, &transposed(&theta_ff));
        for mu in 0..body.mode_count() {
            for nu in 0..body.mode_count() {
                let m = body.m_block(Part::Mode(mu), Part::Mode(nu));
                equal(&(state.p_ff.transpose() * m * &state.p_ff), &column(&[theta_ff[(mu, nu)]]));
            }
        }
    });
}

#[test]
fn equation_163_reduced_mass_matrices() {
    each_state(|body, state| {
        let truth = projected_mass(body, state);
        let modes = body.mode_count();
        let m_tr = block(&truth, 0, 3, 3, 3);
        let lever = |sign: f64| skew(as_vector(&spatial_moment(state, &deformed_moment(body, state, sign))));
        equal(&m_tr, &scaled(-1.0, &lever(1.0)));
        // Printed: + m r̃ with r = a - q b; each fault alone and both together.
        different(&m_tr, &lever(1.0));
        different(&m_tr, &scaled(-1.0, &lever(-1.0)));
        different(&m_tr, &lever(-1.0));
        let m_rr = block(&truth, 3, 3, 3, 3);
        equal(&m_rr, &state.rotate(&deformed_inertia(body, state)));
        let mut printed = deformed_inertia(body, state);
        for mu in 0..modes {
            let theta_mu = inertia_of(&body.t_mu(mu));
            // Printed: 2 q_μ Θ_μ.
            printed += scaled(state.q[mu], &(&theta_mu - theta_mu.transpose()));
        }
        different(&m_rr, &state.rotate(&printed));
        equal(&block(&truth, 3, 6, 3, modes), &(&state.a * deformed_coupling(body, state)));
        equal(&block(&truth, 0, 6, 3, modes), &(&state.a * modal_moments(body)));
        equal(&block(&truth, 6, 6, modes, modes), &modal_mass(body));
    });
}

#[test]
fn equation_164_mass_matrix_turns_with_the_body() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let at_rest =
            State::new([1.0, 0.0, 0.0, 0.0], state.floating.omega, state.q.clone(), state.q_dot.clone());
        let turn = Mat::from_fn(6 + modes, 6 + modes, |i, j| match (i / 3, j / 3) {
            (0, 0) | (1, 1) => state.a[(i % 3, j % 3)],
            _ if i >= 6 && i == j => 1.0,
            _ => 0.0,
        });
        equal(&projected_mass(body, state), &(&turn * projected_mass(body, &at_rest) * turn.transpose()));
    });
}

/// M_rr^d, M_rf^d and M_tr^d of (165), corrected.
pub fn deformed_masses(body: &Body, state: &State) -> (Mat<f64>, Mat<f64>, Mat<f64>) {
    let modes = body.mode_count();
    let mut m_tr = body.m_block(Part::T, Part::R);
    let mut m_rr = body.m_block(Part::R, Part::R);
    let mut m_rf = body.m_block(Part::R, Part::F);
    for mu in 0..modes {
        let m_mu = body.m_block(Part::R, Part::Mode(mu));
        m_tr += scaled(state.q[mu], &body.m_block(Part::T, Part::Mode(mu)));
        m_rr += scaled(state.q[mu], &(&m_mu + m_mu.transpose()));
        for nu in 0..modes {
            m_rr += scaled(state.q[mu] * state.q[nu], &body.m_block(Part::Mode(mu), Part::Mode(nu)));
            let update = scaled(state.q[nu], &body.m_block(Part::Mode(nu), Part::Mode(mu)));
            let mut target = m_rf.as_mut().submatrix_mut(0, 9 * mu, 9, 9);
            target += &update;
        }
    }
    (m_tr, m_rr, m_rf)
}

#[test]
fn equations_165_166_mass_matrices_of_the_deformed_body() {
    each_state(|body, state| {
        let truth = projected_mass(body, state);
        let modes = body.mode_count();
        let (m_tr, m_rr, m_rf) = deformed_masses(body, state);
        let (_, p_ff) = flexible_blocks(body, state);
        equal(&(m_tr * &state.p_rr), &block(&truth, 0, 3, 3, 3));
        equal(&(state.p_rr.transpose() * m_rr * &state.p_rr), &block(&truth, 3, 3, 3, 3));
        equal(&(state.p_rr.transpose() * m_rf * &p_ff), &block(&truth, 3, 6, 3, modes));
        if modes > 1 {
            // Printed with the mode indices of the last term of (165) exchanged.
            let mut printed = body.m_block(Part::R, Part::F);
            for mu in 0..modes {
                for nu in 0..modes {
                    let update = scaled(state.q[nu], &body.m_block(Part::Mode(mu), Part::Mode(nu)));
                    let mut target = printed.as_mut().submatrix_mut(0, 9 * mu, 9, 9);
                    target += &update;
                }
            }
            different(&(state.p_rr.transpose() * printed * &p_ff), &block(&truth, 3, 6, 3, modes));
        }
    });
}
