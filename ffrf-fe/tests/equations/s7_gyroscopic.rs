//! Section 7.9: gyroscopic forces and moments, (167) to (186).

use faer::Mat;
use ffrf_fe::formulations::null_space::{projection, projection_rate};
use ffrf_fe::formulations::rotation::{cross, dot, skew};

use crate::bodies::{Body, Part, State, each_state};
use crate::check::{
    as_vector, block, column, different, equal, scaled, smallest_scale, sum, transposed, vanishes,
};
use crate::nodal;
use crate::s7_inertia::{inertia_of, inertia_printed, inertia_vector};
use crate::s7_projection::{
    deformed_inertia, deformed_masses, deformed_moment, flexible_blocks, modal_moments,
};

fn velocities(state: &State) -> Mat<f64> {
    let mut w = vec![0.0; 3];
    w.extend(as_vector(&state.omega));
    w.extend(&state.q_dot);
    column(&w)
}

/// Ṗ_rr and ṗ_ff.
fn rates(state: &State) -> (Mat<f64>, Mat<f64>) {
    let rate = projection_rate(&state.floating);
    let p_ff_rate = scaled(1.0, &block(&rate, 12, 6, 9, 1));
    (block(&rate, 3, 3, 9, 3), p_ff_rate)
}

fn parts(q: &Mat<f64>) -> [Mat<f64>; 3] {
    [block(q, 0, 0, 3, 1), block(q, 3, 0, 3, 1), block(q, 6, 0, q.nrows() - 6, 1)]
}

/// Θ_μ^d in inertial components, (205) corrected: index order νμ.
pub fn deformed_coupling_tensor(body: &Body, state: &State, mu: usize) -> Mat<f64> {
    let mut theta = inertia_of(&body.t_mu(mu));
    for nu in 0..body.mode_count() {
        theta += scaled(state.q[nu], &inertia_of(&body.t_munu(nu, mu)));
    }
    state.rotate(&theta)
}

/// L_rf = [Θ_μ^d ω]. Shape: 3 x M.
pub fn l_rf(body: &Body, state: &State) -> Mat<f64> {
    let columns: Vec<_> =
        (0..body.mode_count()).map(|mu| deformed_coupling_tensor(body, state, mu) * &state.omega).collect();
    Mat::from_fn(3, columns.len(), |i, mu| columns[mu][(i, 0)])
}

/// L_ff = [-ω · ϑ_μν], (183); (209) prints a plus sign.
pub fn l_ff(body: &Body, state: &State) -> Mat<f64> {
    Mat::from_fn(body.mode_count(), body.mode_count(), |mu, nu| {
        let vector = &state.a * inertia_vector(&body.t_munu(mu, nu));
        -dot(as_vector(&state.omega), as_vector(&vector))
    })
}

#[test]
fn equation_167_projected_gyroscopic_forces_are_the_nodal_ones() {
    each_state(|body, state| {
        let found = projection(&state.floating).transpose()
            * &body.reduced_mass
            * projection_rate(&state.floating)
            * velocities(state);
        for (a, b) in parts(&found).iter().zip(&parts(&nodal::gyroscopic(body, state))) {
            equal(a, b);
        }
    });
}

#[test]
fn equations_168_169_170_171_gyroscopic_forces_by_blocks() {
    each_state(|body, state| {
        let [truth_t, truth_r, truth_f] = parts(&nodal::gyroscopic(body, state));
        let (p_rr_rate, _) = rates(state);
        let (p_fr, p_ff) = flexible_blocks(body, state);
        let modes = body.mode_count();
        let rate = projection_rate(&state.floating);
        let (p_fr_rate, p_ff_rate) =
            (block(&rate, 12, 3, 9 * modes, 3), block(&rate, 12, 6, 9 * modes, modes));
        let (m_tr, m_tf) = (body.m_block(Part::T, Part::R), body.m_block(Part::T, Part::F));
        let (m_rr, m_rf) = (body.m_block(Part::R, Part::R), body.m_block(Part::R, Part::F));
        let m_ff = body.m_block(Part::F, Part::F);
        let w_f = column(&state.q_dot);
        // (168), first form of each line.
        let t = (&m_tr * &p_rr_rate + &m_tf * &p_fr_rate) * &state.omega + &m_tf * &p_ff_rate * &w_f;
        equal(&t, &truth_t);
        let common = &m_rr * &p_rr_rate + &m_rf * &p_fr_rate;
        let flexible = m_rf.transpose() * &p_rr_rate + &m_ff * &p_fr_rate;
        let r = (state.p_rr.transpose() * common + p_fr.transpose() * &flexible) * &state.omega
            + (state.p_rr.transpose() * &m_rf * &p_ff_rate + p_fr.transpose() * &m_ff * &p_ff_rate) * &w_f;
        equal(&r, &truth_r);
        let f = p_ff.transpose() * flexible * &state.omega + p_ff.transpose() * &m_ff * &p_ff_rate * &w_f;
        equal(&f, &truth_f);
        // (170), (171): with the masses of the deformed body.
        let (d_tr, d_rr, d_rf) = deformed_masses(body, state);
        let turn = |m: &Mat<f64>| m * &p_rr_rate * &state.omega;
        let coriolis = &p_ff_rate * &w_f;
        equal(&(turn(&d_tr) + scaled(2.0, &(&m_tf * &coriolis))), &truth_t);
        let by_171 = state.p_rr.transpose() * (turn(&d_rr) + scaled(2.0, &(&d_rf * &coriolis)));
        equal(&by_171, &truth_r);
        let by_171 = p_ff.transpose() * (turn(&transposed(&d_rf)) + scaled(2.0, &(&m_ff * &coriolis)));
        equal(&by_171, &truth_f);
        let weighted = sum((0..modes).map(|mu| scaled(state.q_dot[mu], &block(&d_rf, 0, 9 * mu, 9, 9))));
        let by_170 =
            state.p_rr.transpose() * (turn(&d_rr) + scaled(2.0, &(weighted * &state.p_rr * &state.omega)));
        equal(&by_170, &truth_r);
    });
}

#[test]
fn equation_172_matrix_notation() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let (d_tr, d_rr, d_rf) = deformed_masses(body, state);
        let mut mass = body.reduced_mass.clone();
        mass.as_mut().submatrix_mut(0, 3, 3, 9).copy_from(&d_tr);
        mass.as_mut().submatrix_mut(3, 0, 9, 3).copy_from(d_tr.transpose());
        mass.as_mut().submatrix_mut(3, 3, 9, 9).copy_from(&d_rr);
        mass.as_mut().submatrix_mut(3, 12, 9, 9 * modes).copy_from(&d_rf);
        mass.as_mut().submatrix_mut(12, 3, 9 * modes, 9).copy_from(d_rf.transpose());
        let mut left = projection(&state.floating);
        let mut right = projection_rate(&state.floating);
        // The block-diagonal forms of (172): no coupling blocks, twice the flexible rate.
        left.as_mut().submatrix_mut(12, 3, 9 * modes, 3).fill(0.0);
        right.as_mut().submatrix_mut(12, 3, 9 * modes, 3).fill(0.0);
        let doubled = scaled(2.0, &block(&right, 12, 6, 9 * modes, modes));
        right.as_mut().submatrix_mut(12, 6, 9 * modes, modes).copy_from(doubled);
        let found = left.transpose() * mass * right * velocities(state);
        for (a, b) in parts(&found).iter().zip(&parts(&nodal::gyroscopic(body, state))) {
            equal(a, b);
        }
    });
}

#[test]
fn equations_173_174_translational_terms() {
    each_state(|body, state| {
        let (p_rr_rate, _) = rates(state);
        let (d_tr, ..) = deformed_masses(body, state);
        let omega = skew(as_vector(&state.omega));
        let r = |sign| &state.a * deformed_moment(body, state, sign);
        let found = d_tr * p_rr_rate * &state.omega;
        equal(&found, &(&omega * &omega * r(1.0)));
        equal(&found, &scaled(-1.0, &(&omega * skew(as_vector(&r(1.0))) * &state.omega)));
        different(&found, &(&omega * &omega * r(-1.0)));
        let weighted =
            sum((0..body.mode_count())
                .map(|mu| scaled(state.q_dot[mu], &body.m_block(Part::T, Part::Mode(mu)))));
        let b_rate = &state.a * modal_moments(body) * column(&state.q_dot);
        equal(&(weighted * &state.p_rr * &state.omega), &(omega * b_rate));
    });
}

#[test]
fn equations_175_176_177_178_gyroscopic_moment() {
    each_state(|body, state| {
        let (p_rr_rate, _) = rates(state);
        let (_, d_rr, _) = deformed_masses(body, state);
        let omega = skew(as_vector(&state.omega));
        let found = state.p_rr.transpose() * d_rr * &p_rr_rate * &state.omega;
        equal(&found, &(&omega * state.rotate(&deformed_inertia(body, state)) * &state.omega));
        // The first form of (175) is printed with the undeformed inertia.
        different(&found, &(&omega * state.rotate(&inertia_of(&body.t())) * &state.omega));
        // The proof, for the undeformed part.
        let rate = |i: usize| cross(as_vector(&state.omega), state.d[i]);
        let t = body.t();
        let undeformed = state.p_rr.transpose() * body.m_block(Part::R, Part::R) * p_rr_rate * &state.omega;
        let by_176 = sum((0..9).map(|k| {
            let (i, j) = (k / 3, k % 3);
            scaled(-t[(i, j)] * dot(state.d[i], as_vector(&state.omega)), &column(&rate(j)))
        }));
        equal(&undeformed, &by_176);
        let theta = state.rotate(&inertia_of(&t));
        let by_177 = scaled(t[(0, 0)] + t[(1, 1)] + t[(2, 2)], &state.omega)
            - sum((0..9).map(|k| {
                let (i, j) = (k / 3, k % 3);
                scaled(t[(i, j)] * dot(state.d[j], as_vector(&state.omega)), &column(&state.d[i]))
            }));
        equal(&(&theta * &state.omega), &by_177);
        equal(&(omega * theta * &state.omega), &by_176);
    });
}

#[test]
fn equations_179_180_coupling_momentum() {
    each_state(|body, state| {
        let (.., d_rf) = deformed_masses(body, state);
        let weighted =
            sum((0..body.mode_count()).map(|mu| scaled(state.q_dot[mu], &block(&d_rf, 0, 9 * mu, 9, 9))));
        let found = state.p_rr.transpose() * weighted * &state.p_rr * &state.omega;
        equal(&found, &(l_rf(body, state) * column(&state.q_dot)));
        let with = |tensor: &dyn Fn(&Mat<f64>) -> Mat<f64>, swapped: bool| {
            sum((0..body.mode_count()).map(|mu| {
                let mut theta = tensor(&body.t_mu(mu));
                for nu in 0..body.mode_count() {
                    let pair = if swapped { body.t_munu(mu, nu) } else { body.t_munu(nu, mu) };
                    theta += scaled(state.q[nu], &tensor(&pair));
                }
                scaled(state.q_dot[mu], &(state.rotate(&theta) * &state.omega))
            }))
        };
        equal(&found, &with(&inertia_of, false));
        if body.mode_count() > 1 {
            // Printed: Θ_μν in Θ_μ^d; and with the printed, transposed Θ of (207).
            different(&found, &with(&inertia_of, true));
        }
        different(&found, &with(&inertia_printed, true));
    });
}

#[test]
fn equations_181_182_centrifugal_modal_force() {
    each_state(|body, state| {
        let (p_rr_rate, _) = rates(state);
        let (.., d_rf) = deformed_masses(body, state);
        let (_, p_ff) = flexible_blocks(body, state);
        let found = p_ff.transpose() * d_rf.transpose() * &p_rr_rate * &state.omega;
        equal(&found, &scaled(-1.0, &(l_rf(body, state).transpose() * &state.omega)));
        for mu in 0..body.mode_count() {
            let single = state.p_ff.transpose()
                * body.m_block(Part::R, Part::Mode(mu)).transpose()
                * &p_rr_rate
                * &state.omega;
            let theta = state.rotate(&inertia_of(&body.t_mu(mu)));
            // A sum that may cancel: compared against the size of its terms.
            let scale = theta.norm_max().max(smallest_scale())
                * dot(as_vector(&state.omega), as_vector(&state.omega));
            vanishes(&(single + state.omega.transpose() * theta.transpose() * &state.omega), scale);
        }
    });
}

#[test]
fn equations_183_184_coriolis_modal_force() {
    each_state(|body, state| {
        let (_, p_ff) = flexible_blocks(body, state);
        let modes = body.mode_count();
        let p_ff_rate = block(&projection_rate(&state.floating), 12, 6, 9 * modes, modes);
        let m_ff = body.m_block(Part::F, Part::F);
        let found = p_ff.transpose() * &m_ff * p_ff_rate;
        vanishes(&(&found - l_ff(body, state)), m_ff.norm_max());
        let (_, single_rate) = rates(state);
        for mu in 0..modes {
            for nu in (0..modes).filter(|&nu| nu != mu) {
                let m = body.m_block(Part::Mode(mu), Part::Mode(nu));
                let expected = column(&[l_ff(body, state)[(mu, nu)]]);
                equal(&(state.p_ff.transpose() * &m * &single_rate), &expected);
                // (184) is printed with M_μν transposed, (209) with a plus sign: both are the negative.
                different(&(state.p_ff.transpose() * m.transpose() * &single_rate), &expected);
            }
        }
        if modes > 1 {
            different(&found, &scaled(-1.0, &l_ff(body, state)));
        }
    });
}

#[test]
fn equations_185_186_gyroscopic_forces() {
    each_state(|body, state| {
        let truth = parts(&nodal::gyroscopic(body, state));
        let omega = skew(as_vector(&state.omega));
        let rates = scaled(2.0, &column(&state.q_dot));
        let r = skew(as_vector(&(&state.a * deformed_moment(body, state, 1.0))));
        let b = &state.a * modal_moments(body);
        let theta = state.rotate(&deformed_inertia(body, state));
        let l_rf = l_rf(body, state);
        equal(&truth[0], &(scaled(-1.0, &(&omega * r * &state.omega)) + &omega * b * &rates));
        equal(&truth[1], &(&omega * theta * &state.omega + &l_rf * &rates));
        let flexible = |l_ff: Mat<f64>| scaled(-1.0, &(l_rf.transpose() * &state.omega)) + l_ff * &rates;
        equal(&truth[2], &flexible(l_ff(body, state)));
        match body.mode_count() {
            1 => assert!(l_ff(body, state)[(0, 0)].abs() <= 1e-13 * body.t_munu(0, 0).norm_max()),
            // (209) as printed: the sign that no conservation law can see.
            _ => different(&truth[2], &flexible(scaled(-1.0, &l_ff(body, state)))),
        }
    });
}
