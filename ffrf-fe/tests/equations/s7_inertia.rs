//! Sections 7.5 and 7.6: generalised inertia tensors and inertia vectors, (133) to (150).

use faer::Mat;
use ffrf_fe::formulations::rotation::{axial, cross, dot, skew};
use ffrf_test_kit::random::Random;

use crate::bodies::{Body, Part, State, each_state};
use crate::check::{block, column, different, equal, identity, outer, scaled, sum, transposed};

/// tr(T) I - Tᵀ: the true Θ of (133), (136), (138). The print lacks the transpose.
pub fn inertia_of(t: &Mat<f64>) -> Mat<f64> {
    scaled(t[(0, 0)] + t[(1, 1)] + t[(2, 2)], &identity(3)) - t.transpose()
}

/// tr(T) I - T, as printed in (136)-(139) and (207).
pub fn inertia_printed(t: &Mat<f64>) -> Mat<f64> {
    scaled(t[(0, 0)] + t[(1, 1)] + t[(2, 2)], &identity(3)) - t
}

/// ϑ = T^{ij} e_i × e_j. Shape: 3 x 1.
pub fn inertia_vector(t: &Mat<f64>) -> Mat<f64> {
    column(&[t[(1, 2)] - t[(2, 1)], t[(2, 0)] - t[(0, 2)], t[(0, 1)] - t[(1, 0)]])
}

/// Σ T^{ij} f(d_i, d_j).
fn contract(t: &Mat<f64>, state: &State, f: impl Fn([f64; 3], [f64; 3]) -> Mat<f64>) -> Mat<f64> {
    sum((0..9).map(|k| scaled(t[(k / 3, k % 3)], &f(state.d[k / 3], state.d[k % 3]))))
}

fn pairs(body: &Body) -> impl Iterator<Item = (usize, usize)> + use<> {
    let modes = body.mode_count();
    (0..modes).flat_map(move |mu| (0..modes).map(move |nu| (mu, nu)))
}

/// P_rrᵀ X P_rr.
fn project(state: &State, x: &Mat<f64>) -> Mat<f64> {
    state.p_rr.transpose() * x * &state.p_rr
}

#[test]
fn equations_133_134_135_inertia_tensor() {
    each_state(|body, state| {
        let t = body.t();
        let theta = project(state, &body.m_block(Part::R, Part::R));
        equal(&theta, &contract(&t, state, |a, b| scaled(-1.0, &(skew(a) * skew(b)))));
        // The middle member is printed without the minus sign.
        different(&theta, &contract(&t, state, |a, b| skew(a) * skew(b)));
        equal(&theta, &state.rotate(&inertia_of(&t)));
        let trace = t[(0, 0)] + t[(1, 1)] + t[(2, 2)];
        let spatial = state.rotate(&t);
        let by_directors: f64 = (0..9).map(|k| t[(k / 3, k % 3)] * dot(state.d[k % 3], state.d[k / 3])).sum();
        equal(
            &column(&[by_directors, trace]),
            &column(&[trace, spatial[(0, 0)] + spatial[(1, 1)] + spatial[(2, 2)]]),
        );
        let back = state.a.transpose() * theta * &state.a;
        equal(&back, &inertia_of(&t));
    });
}

#[test]
fn equations_136_137_coupling_inertia_tensors() {
    each_state(|body, state| {
        for mu in 0..body.mode_count() {
            let t = body.t_mu(mu);
            let theta = project(state, &body.m_block(Part::R, Part::Mode(mu)));
            equal(&theta, &state.rotate(&inertia_of(&t)));
            different(&theta, &state.rotate(&inertia_printed(&t)));
        }
    });
}

#[test]
fn equations_138_139_deformation_inertia_tensors() {
    each_state(|body, state| {
        for (mu, nu) in pairs(body) {
            let t = body.t_munu(mu, nu);
            let theta = project(state, &body.m_block(Part::Mode(mu), Part::Mode(nu)));
            equal(&theta, &state.rotate(&inertia_of(&t)));
            if mu != nu {
                different(&theta, &state.rotate(&inertia_printed(&t)));
            }
        }
    });
}

#[test]
fn equations_140_141_142_inertia_vectors() {
    each_state(|body, state| {
        for mu in 0..body.mode_count() {
            let t = body.t_mu(mu);
            let theta = state.p_rr.transpose() * body.m_block(Part::R, Part::Mode(mu)) * &state.p_ff;
            equal(&theta, &contract(&t, state, |a, b| column(&cross(a, b))));
            equal(&theta, &(&state.a * inertia_vector(&t)));
        }
        let modes = body.mode_count();
        let p_ff =
            Mat::from_fn(9 * modes, modes, |i, j| if i / 9 == j { state.p_ff[(i % 9, 0)] } else { 0.0 });
        let xi = state.p_rr.transpose() * body.m_block(Part::R, Part::F) * p_ff;
        let body_xi = Mat::from_fn(3, modes, |i, mu| inertia_vector(&body.t_mu(mu))[(i, 0)]);
        equal(&(state.a.transpose() * xi), &body_xi);
    });
}

#[test]
fn equations_143_144_vectors_from_tensors() {
    each_state(|body, state| {
        for mu in 0..body.mode_count() {
            let t = body.t_mu(mu);
            let vector = inertia_vector(&t);
            let tilde = skew([vector[(0, 0)], vector[(1, 0)], vector[(2, 0)]]);
            let theta = inertia_of(&t);
            equal(&tilde, &(theta.transpose() - &theta));
            // Printed as Θ - Θᵀ, which is right only for the printed Θ.
            different(&tilde, &(&theta - theta.transpose()));
            equal(&tilde, &(inertia_printed(&t) - inertia_printed(&t).transpose()));
            let antisymmetric = &t - t.transpose();
            let spatial = state.rotate(&tilde);
            equal(&spatial, &contract(&antisymmetric, state, |a, b| skew(a) * skew(b)));
            equal(&spatial, &contract(&antisymmetric, state, |a, b| outer(b, a)));
            // The last member of (144) is printed with the factors exchanged.
            different(&spatial, &contract(&antisymmetric, state, outer));
        }
    });
}

#[test]
fn equation_145_jacobi_identity() {
    let mut random = Random::new(7);
    let (a, b, v) = (random.vector(), random.vector(), random.vector());
    let twice = |x, y, z| column(&cross(x, cross(y, z)));
    equal(&(twice(a, b, v) + twice(b, v, a)), &scaled(-1.0, &twice(v, a, b)));
    // Printed with d_j × d_i in the third term.
    different(&(twice(a, b, v) + twice(b, v, a)), &scaled(-1.0, &twice(v, b, a)));
}

#[test]
fn equation_146_product_of_cross_product_matrices() {
    let mut random = Random::new(8);
    let (a, b) = (random.vector(), random.vector());
    let product = skew(a) * skew(b);
    equal(&product, &(outer(b, a) - scaled(dot(a, b), &identity(3))));
    // Printed with the opposite sign.
    different(&product, &(scaled(dot(a, b), &identity(3)) - outer(b, a)));
}

#[test]
fn equation_147_inertia_vectors_of_mode_pairs() {
    each_state(|body, state| {
        for (mu, nu) in pairs(body).filter(|(mu, nu)| mu != nu) {
            let t = body.t_munu(mu, nu);
            let vector = state.p_rr.transpose() * body.m_block(Part::Mode(mu), Part::Mode(nu)) * &state.p_ff;
            equal(&vector, &contract(&t, state, |a, b| scaled(-1.0, &(transposed(&skew(a)) * column(&b)))));
            equal(&vector, &(&state.a * inertia_vector(&t)));
            // Printed with the rate of d_j.
            let omega = [state.omega[(0, 0)], state.omega[(1, 0)], state.omega[(2, 0)]];
            let printed =
                contract(&t, state, |a, b| scaled(-1.0, &(transposed(&skew(a)) * column(&cross(omega, b)))));
            different(&vector, &printed);
        }
    });
}

#[test]
fn equation_148_inertia_vectors_are_antisymmetric_in_the_modes() {
    each_state(|body, _| {
        for (mu, nu) in pairs(body) {
            let sum = inertia_vector(&body.t_munu(mu, nu)) + inertia_vector(&body.t_munu(nu, mu));
            let scale = (body.t_munu(mu, mu).norm_max() * body.t_munu(nu, nu).norm_max()).sqrt();
            crate::check::vanishes(&sum, scale);
        }
    });
}

#[test]
fn equation_149_mode_pair_vectors_from_tensors() {
    each_state(|body, _| {
        for (mu, nu) in pairs(body).filter(|(mu, nu)| mu != nu) {
            let t = body.t_munu(mu, nu);
            let theta = inertia_of(&t);
            let vector = inertia_vector(&t);
            let corrected = axial((theta.transpose() - &theta).as_ref());
            equal(&vector, &column(&corrected));
            different(&vector, &column(&axial((&theta - theta.transpose()).as_ref())));
        }
    });
}

#[test]
fn equation_150_matrices_of_inertia_vectors() {
    each_state(|body, state| {
        let modes = body.mode_count();
        let p_ff =
            Mat::from_fn(9 * modes, modes, |i, j| if i / 9 == j { state.p_ff[(i % 9, 0)] } else { 0.0 });
        let m_ff = body.m_block(Part::F, Part::F);
        for mu in 0..modes {
            let xi = state.p_rr.transpose() * block(&m_ff, 9 * mu, 0, 9, 9 * modes) * &p_ff;
            let expected = Mat::from_fn(3, modes, |i, nu| inertia_vector(&body.t_munu(mu, nu))[(i, 0)]);
            let turned = &state.a * expected;
            crate::check::vanishes(&(&xi - &turned), body.t_munu(mu, mu).norm_max().max(xi.norm_max()));
        }
    });
}
