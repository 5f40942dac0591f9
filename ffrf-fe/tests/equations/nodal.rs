//! The truth: everything node by node, without invariants and without generalised modes.

use faer::Mat;
use ffrf_fe::formulations::gcms::apply_mass;
use ffrf_fe::formulations::rotation::skew;

use crate::bodies::{Body, State};
use crate::check::{as_vector, column};

/// Velocity of every node per unit [q̇_t; ω; q̇'] (inertial components). Shape: 3N x (6 + M).
pub fn jacobian(body: &Body, state: &State) -> Mat<f64> {
    let modes = body.mode_count();
    let mut jacobian = Mat::zeros(3 * body.positions.len(), 6 + modes);
    for node in 0..body.positions.len() {
        let lever = skew(as_vector(&lever(body, state, node)));
        for i in 0..3 {
            jacobian[(3 * node + i, i)] = 1.0;
            for j in 0..3 {
                jacobian[(3 * node + i, 3 + j)] = -lever[(i, j)];
            }
            for mu in 0..modes {
                jacobian[(3 * node + i, 6 + mu)] =
                    (0..3).map(|j| state.a[(i, j)] * body.shapes[(3 * node + j, mu)]).sum();
            }
        }
    }
    jacobian
}

/// A (x_n + Ψ_n q). Shape: 3 x 1.
pub fn lever(body: &Body, state: &State, node: usize) -> Mat<f64> {
    let deformed = [0, 1, 2].map(|i| {
        let displacement: f64 =
            (0..body.mode_count()).map(|mu| body.shapes[(3 * node + i, mu)] * state.q[mu]).sum();
        body.positions[node][i] + displacement
    });
    &state.a * column(&deformed)
}

/// A Ψ_n q̇. Shape: 3 x 1.
pub fn relative_velocity(body: &Body, state: &State, node: usize) -> Mat<f64> {
    let rate = [0, 1, 2].map(|i| {
        (0..body.mode_count()).map(|mu| body.shapes[(3 * node + i, mu)] * state.q_dot[mu]).sum::<f64>()
    });
    &state.a * column(&rate)
}

/// Mass matrix of the floating frame, Σ J_nᵀ M_nm J_m. Shape: (6 + M) square.
pub fn mass_matrix(body: &Body, state: &State) -> Mat<f64> {
    let jacobian = jacobian(body, state);
    jacobian.transpose() * apply_mass(&body.mass, jacobian.as_ref())
}

/// Gyroscopic forces, Σ J_nᵀ M_nm (ω × (ω × r_m) + 2 ω × v_m). Shape: 6 + M.
pub fn gyroscopic(body: &Body, state: &State) -> Mat<f64> {
    let omega = skew(as_vector(&state.omega));
    let mut acceleration = Mat::zeros(3 * body.positions.len(), 1);
    for node in 0..body.positions.len() {
        let centripetal = &omega * (&omega * lever(body, state, node));
        let coriolis = &omega * relative_velocity(body, state, node);
        for i in 0..3 {
            acceleration[(3 * node + i, 0)] = centripetal[(i, 0)] + 2.0 * coriolis[(i, 0)];
        }
    }
    jacobian(body, state).transpose() * apply_mass(&body.mass, acceleration.as_ref())
}
