//! Section 8, Euler parameters: (210) to (217).

use faer::Mat;
use ffrf_fe::formulations::rotation::{body_rate_matrix, inertial_rate_matrix, rotation_matrix, skew};

use crate::bodies::{Body, State, each_state};
use crate::check::{as_vector, block, column, different, equal, identity, scaled, vanishes};
use crate::nodal;
use crate::s7_gyroscopic::{l_ff, l_rf};
use crate::s7_projection::{deformed_coupling, deformed_inertia, deformed_moment, modal_mass, modal_moments};
use crate::s8_result::{gyroscopic, mass_matrix};

/// θ̇ = ¼ Gᵀ ω, the inverse of (210) on the tangent space.
fn theta_rate(state: &State) -> Mat<f64> {
    scaled(0.25, &(inertial_rate_matrix(state.theta).transpose() * &state.omega))
}

fn four(matrix: &Mat<f64>) -> [f64; 4] {
    [0, 1, 2, 3].map(|i| matrix[(i, 0)])
}

/// diag(I, G, I): [q̇_t; ω; q̇'] per [q̇_t; θ̇; q̇']. Shape: (6 + M) x (7 + M).
fn substitution(body: &Body, state: &State) -> Mat<f64> {
    let g = inertial_rate_matrix(state.theta);
    Mat::from_fn(6 + body.mode_count(), 7 + body.mode_count(), |i, j| match (i, j) {
        (3..6, 3..7) => g[(i - 3, j - 3)],
        (0..3, _) if i == j => 1.0,
        (6.., _) if i + 1 == j => 1.0,
        _ => 0.0,
    })
}

/// A state with the body at rest in the inertial frame's axes and ω given in body components.
fn body_resolved(state: &State) -> State {
    let omega = state.a.transpose() * &state.omega;
    State::new([1.0, 0.0, 0.0, 0.0], as_vector(&omega), state.q.clone(), state.q_dot.clone())
}

#[test]
fn equation_210_angular_velocity() {
    each_state(|_, state| {
        let rate = theta_rate(state);
        equal(&(inertial_rate_matrix(state.theta) * &rate), &state.omega);
        // ω̃ = Ȧ Aᵀ; A is quadratic in θ, so a central difference of any step is exact.
        let moved = |h: f64| rotation_matrix([0, 1, 2, 3].map(|i| state.theta[i] + h * rate[(i, 0)]));
        let a_rate = moved(0.5) - moved(-0.5);
        equal(&(a_rate * state.a.transpose()), &skew(as_vector(&state.omega)));
        // ω̇ = G θ̈ because Ġ θ̇ = 0.
        let g_rate = inertial_rate_matrix(four(&rate));
        vanishes(&(g_rate * &rate), rate.norm_max());
    });
}

#[test]
fn equations_211_212_213_rate_matrices() {
    each_state(|_, state| {
        let (g, g_body) = (inertial_rate_matrix(state.theta), body_rate_matrix(state.theta));
        equal(&g_body, &(state.a.transpose() * &g));
        equal(&(&g * g.transpose()), &scaled(4.0, &identity(3)));
        equal(&scaled(0.25, &(&g * g_body.transpose())), &state.a);
        equal(&(state.a.transpose() * &state.a), &identity(3));
        let theta = column(&state.theta);
        vanishes(&(g * &theta), 1.0);
    });
}

#[test]
fn equation_214_mass_matrix_in_euler_parameters() {
    each_state(|body, state| {
        let s = substitution(body, state);
        let truth = s.transpose() * nodal::mass_matrix(body, state) * &s;
        let g = body_rate_matrix(state.theta);
        let modes = body.mode_count();
        equal(&block(&truth, 3, 3, 4, 4), &(g.transpose() * deformed_inertia(body, state) * &g));
        equal(&block(&truth, 3, 7, 4, modes), &(g.transpose() * deformed_coupling(body, state)));
        equal(&block(&truth, 0, 7, 3, modes), &(&state.a * modal_moments(body)));
        equal(&block(&truth, 7, 7, modes, modes), &modal_mass(body));
        let lever = |sign: f64| &state.a * skew(as_vector(&deformed_moment(body, state, sign))) * &g;
        equal(&block(&truth, 0, 3, 3, 4), &scaled(-1.0, &lever(1.0)));
        // Printed: + m A r̃ Ḡ with r of (204).
        different(&block(&truth, 0, 3, 3, 4), &lever(1.0));
        different(&block(&truth, 0, 3, 3, 4), &lever(-1.0));
        equal(&(s.transpose() * mass_matrix(body, state) * &s), &truth);
    });
}

#[test]
fn equation_215_constraint_jacobian_of_a_spherical_joint() {
    each_state(|body, state| {
        // C_b = q_t + A (x_n + Ψ_n q) - const at node n, written in the generalised coordinates:
        // C_bt = I, C_br and C_bf are the node's rows of Φ_r and Φ_f.
        let node = body.positions.len() - 1;
        let modes = body.mode_count();
        let c_br = block(&body.modes.shapes, 3 * node, 3, 3, 9);
        let c_bf = block(&body.modes.shapes, 3 * node, 12, 3, 9 * modes);
        let p_fr = Mat::from_fn(9 * modes, 3, |i, j| state.q[i / 9] * state.p_rr[(i % 9, j)]);
        let g = inertial_rate_matrix(state.theta);
        // Truth: the position is quadratic in θ, so a central difference is exact.
        let deformed = [0, 1, 2].map(|i| {
            body.positions[node][i]
                + (0..modes).map(|mu| body.shapes[(3 * node + i, mu)] * state.q[mu]).sum::<f64>()
        });
        let truth = Mat::from_fn(3, 4, |i, k| {
            let moved = |h: f64| {
                let mut theta = state.theta;
                theta[k] += h;
                (rotation_matrix(theta) * column(&deformed))[(i, 0)]
            };
            moved(0.5) - moved(-0.5)
        });
        // They agree on the tangent space of unit quaternions, G θ = 0.
        let tangent = scaled(0.25, &(g.transpose() * &g));
        let corrected = (&c_br * &state.p_rr + c_bf * p_fr) * &g;
        equal(&corrected, &(&truth * &tangent));
        // Printed without C_bf P_fr.
        different(&(c_br * &state.p_rr * &g), &(truth * tangent));
    });
}

#[test]
fn equation_216_normalisation_and_its_multiplier() {
    each_state(|body, state| {
        let norm: f64 = state.theta.iter().map(|t| t * t).sum();
        assert!((0.5 * (norm - 1.0)).abs() < 1e-15);
        // The normalisation's direction θ carries no force: G θ = 0, hence Sᵀ(anything) has none.
        let s = substitution(body, state);
        let force = s.transpose() * gyroscopic(body, state);
        let along = column(&state.theta).transpose() * block(&force, 3, 0, 4, 1);
        vanishes(&along, force.norm_max());
        // And the mass matrix has rank 6 + M, its null vector being [0; θ; 0].
        let mut null = Mat::zeros(7 + body.mode_count(), 1);
        null.as_mut().submatrix_mut(3, 0, 4, 1).copy_from(column(&state.theta));
        let mass = s.transpose() * mass_matrix(body, state) * &s;
        vanishes(&(&mass * null), mass.norm_max());
    });
}

#[test]
fn equation_217_quadratic_velocity_vector() {
    each_state(|body, state| {
        let s = substitution(body, state);
        let truth = scaled(-1.0, &(s.transpose() * nodal::gyroscopic(body, state)));
        let g = body_rate_matrix(state.theta);
        let omega = &g * theta_rate(state);
        let tilde = skew(as_vector(&omega));
        let rates = column(&state.q_dot);
        let local = body_resolved(state);
        let lever = skew(as_vector(&deformed_moment(body, state, 1.0)));
        let t = &state.a * (&tilde * lever * &omega - scaled(2.0, &(&tilde * modal_moments(body) * &rates)));
        equal(&block(&truth, 0, 0, 3, 1), &t);
        let moment =
            &tilde * deformed_inertia(body, state) * &omega + scaled(2.0, &(l_rf(body, &local) * &rates));
        equal(&block(&truth, 3, 0, 4, 1), &scaled(-1.0, &(g.transpose() * moment)));
        let modal = |l_ff: Mat<f64>| l_rf(body, &local).transpose() * &omega - scaled(2.0, &(l_ff * &rates));
        equal(&block(&truth, 7, 0, body.mode_count(), 1), &modal(l_ff(body, &local)));
        if body.mode_count() > 1 {
            different(&block(&truth, 7, 0, body.mode_count(), 1), &modal(scaled(-1.0, &l_ff(body, &local))));
        }
    });
}
