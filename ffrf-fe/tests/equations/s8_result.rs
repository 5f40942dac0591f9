//! Section 8: the projected equations of motion and their inertia components, (203) to (209).

use faer::Mat;
use faer::linalg::solvers::Solve;
use ffrf_fe::formulations::floating::FloatingBody;
use ffrf_fe::formulations::gcms::gram_matrix;
use ffrf_fe::formulations::rotation::{axial, skew};

use crate::bodies::{Body, State, each_body, each_state};
use crate::check::{as_vector, block, column, different, equal, largest, scaled, transposed};
use crate::nodal;
use crate::s7_gyroscopic::{l_ff, l_rf};
use crate::s7_inertia::{inertia_of, inertia_printed, inertia_vector};
use crate::s7_projection::{deformed_coupling, deformed_inertia, deformed_moment, modal_mass, modal_moments};

/// Mass matrix of (203), inertial form, corrected; built from the constant invariants only.
pub fn mass_matrix(body: &Body, state: &State) -> Mat<f64> {
    let modes = body.mode_count();
    let moment = &state.a * deformed_moment(body, state, 1.0);
    let blocks = [
        (0, 0, scaled(body.m(), &Mat::identity(3, 3))),
        (0, 3, scaled(-1.0, &skew(as_vector(&moment)))),
        (0, 6, &state.a * modal_moments(body)),
        (3, 3, state.rotate(&deformed_inertia(body, state))),
        (3, 6, &state.a * deformed_coupling(body, state)),
        (6, 6, modal_mass(body)),
    ];
    let mut mass = Mat::zeros(6 + modes, 6 + modes);
    for (row, col, content) in blocks {
        mass.as_mut().submatrix_mut(row, col, content.nrows(), content.ncols()).copy_from(&content);
        mass.as_mut()
            .submatrix_mut(col, row, content.ncols(), content.nrows())
            .copy_from(content.transpose());
    }
    mass
}

/// Gyroscopic forces of (203), corrected.
pub fn gyroscopic(body: &Body, state: &State) -> Mat<f64> {
    let omega = skew(as_vector(&state.omega));
    let rates = scaled(2.0, &column(&state.q_dot));
    let moment = skew(as_vector(&(&state.a * deformed_moment(body, state, 1.0))));
    let l_rf = l_rf(body, state);
    let t =
        scaled(-1.0, &(&omega * moment * &state.omega)) + &omega * (&state.a * modal_moments(body)) * &rates;
    let r = &omega * state.rotate(&deformed_inertia(body, state)) * &state.omega + &l_rf * &rates;
    let f = scaled(-1.0, &(l_rf.transpose() * &state.omega)) + l_ff(body, state) * &rates;
    Mat::from_fn(6 + body.mode_count(), 1, |i, _| match i {
        0..3 => t[(i, 0)],
        3..6 => r[(i - 3, 0)],
        _ => f[(i - 6, 0)],
    })
}

#[test]
fn equation_203_equations_of_motion() {
    each_state(|body, state| {
        let truth = nodal::mass_matrix(body, state);
        let found = mass_matrix(body, state);
        equal(&found, &truth);
        let lowest = found.self_adjoint_eigenvalues(faer::Side::Lower).expect("eigenvalues converge")[0];
        assert!(lowest > 0.0, "the mass matrix is positive definite, smallest eigenvalue {lowest:e}");
        equal(&gyroscopic(body, state), &nodal::gyroscopic(body, state));
        // With + m r̃ as printed the matrix is not even positive definite.
        let mut printed = found.clone();
        let wrong = scaled(-1.0, &block(&found, 0, 3, 3, 3));
        printed.as_mut().submatrix_mut(0, 3, 3, 3).copy_from(&wrong);
        printed.as_mut().submatrix_mut(3, 0, 3, 3).copy_from(wrong.transpose());
        different(&printed, &truth);
    });
}

#[test]
fn equation_203_accelerations_move_the_nodes_as_newton_says() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let force = column(&(0..6 + modes).map(|i| 1.0 - 0.3 * i as f64).collect::<Vec<_>>());
        let acceleration = mass_matrix(body, state).partial_piv_lu().solve(&force - gyroscopic(body, state));
        let residual =
            nodal::mass_matrix(body, state) * acceleration + nodal::gyroscopic(body, state) - &force;
        assert!(largest(&residual) < 1e-10 * largest(&force), "{:e}", largest(&residual));
    });
}

#[test]
fn equations_204_205_printed_inertia_of_the_deformed_body() {
    each_state(|body, state| {
        let corrected = deformed_inertia(body, state);
        equal(&corrected, &transposed(&corrected));
        // Printed: Θ^d + q_μ Θ_μ^d = Θ + 2 q_μ Θ_μ + ..., which is not symmetric.
        let mut printed = inertia_of(&body.t());
        for mu in 0..body.mode_count() {
            printed += scaled(2.0 * state.q[mu], &inertia_of(&body.t_mu(mu)));
            for nu in 0..body.mode_count() {
                printed += scaled(state.q[mu] * state.q[nu], &inertia_of(&body.t_munu(mu, nu)));
            }
        }
        different(&printed, &transposed(&printed));
        different(&deformed_moment(body, state, -1.0), &deformed_moment(body, state, 1.0));
        // The third line turns a 3 x M matrix from the left only.
        let rotated = &state.a * deformed_coupling(body, state);
        equal(&rotated, &block(&nodal::mass_matrix(body, state), 3, 6, 3, body.mode_count()));
        if body.mode_count() == 3 {
            different(&rotated, &state.rotate(&deformed_coupling(body, state)));
        }
    });
}

#[test]
fn equation_206_first_moments() {
    each_body(|body| {
        // φ_tᵀ M φ_r; printed with φ_t twice, which is the mass.
        let found = body.mass_product(&body.phi_t(), &body.phi_r());
        equal(&found, &transposed(&body.first_moment()));
        different(&found, &Mat::from_fn(1, 3, |_, _| body.m()));
    });
}

#[test]
fn equation_207_inertia_tensors() {
    each_body(|body| {
        equal(&inertia_of(&body.t()), &inertia_printed(&body.t()));
        for mu in 0..body.mode_count() {
            let t = body.t_mu(mu);
            // ∫ρ [ (x · φ) I - φ xᵀ ] for the point masses of a diagonal mass matrix, extended by bilinearity.
            let nodes = body.positions.len();
            let mut truth = Mat::zeros(3, 3);
            for n in 0..nodes {
                for k in 0..nodes {
                    let weight = body.mass.get(n, k).copied().unwrap_or(0.0);
                    let shape = [0, 1, 2].map(|i| body.shapes[(3 * k + i, mu)]);
                    truth -= scaled(weight, &(skew(body.positions[n]) * skew(shape)));
                }
            }
            equal(&inertia_of(&t), &truth);
            different(&inertia_printed(&t), &truth);
        }
    });
}

#[test]
fn equation_208_inertia_vectors() {
    each_body(|body| {
        for mu in 0..body.mode_count() {
            let vector = inertia_vector(&body.t_mu(mu));
            let (theta, printed) = (inertia_of(&body.t_mu(mu)), inertia_printed(&body.t_mu(mu)));
            equal(&vector, &column(&axial((theta.transpose() - &theta).as_ref())));
            equal(&vector, &column(&axial((&printed - printed.transpose()).as_ref())));
            // With ax of (78) as printed the vector is twice as long.
            let doubled = axial((theta.transpose() - &theta).as_ref()).map(|x| 2.0 * x);
            different(&vector, &column(&doubled));
        }
    });
}

#[test]
fn equation_209_generalized_angular_momentum() {
    each_state(|body, state| {
        let omega_body = state.a.transpose() * &state.omega;
        let modes = body.mode_count();
        let at_rest =
            State::new([1.0, 0.0, 0.0, 0.0], as_vector(&omega_body), state.q.clone(), state.q_dot.clone());
        equal(&l_rf(body, state), &(&state.a * l_rf(body, &at_rest)));
        for mu in 0..modes {
            for nu in (0..modes).filter(|&nu| nu != mu) {
                let projected = omega_body.transpose() * inertia_vector(&body.t_munu(mu, nu));
                equal(&column(&[l_ff(body, state)[(mu, nu)]]), &scaled(-1.0, &projected));
                different(&column(&[l_ff(body, state)[(mu, nu)]]), &projected);
            }
        }
    });
}

/// The library's floating frame, built from the Gram matrix, is the nodal one in body axes.
#[test]
fn equations_185_203_floating_body_of_the_library() {
    each_state(|body, state| {
        let omega = as_vector(&(state.a.transpose() * &state.omega));
        let in_body_axes = State::new([1.0, 0.0, 0.0, 0.0], omega, state.q.clone(), state.q_dot.clone());
        let floating = FloatingBody {
            gram: gram_matrix(&body.positions, body.shapes.as_ref(), &body.mass),
            stiffness: Mat::zeros(body.mode_count(), body.mode_count()),
        };
        equal(&floating.mass_matrix(&state.q), &nodal::mass_matrix(body, &in_body_axes));
        let found = floating.gyroscopic(&state.q, omega, &state.q_dot);
        equal(&found, &nodal::gyroscopic(body, &in_body_axes));
    });
}
