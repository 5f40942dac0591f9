//! Where the formulation ends: no geometric stiffening.

use faer::linalg::solvers::Solve;
use faer::{Mat, Side};
use ffrf_fe::formulations::floating::FloatingBody;

use crate::beam::beam;

/// All modes of the beam clamped at x = 0, mass-normalised, and the lowest circular frequencies.
fn clamped_modes(model: &ffrf_fe::FeModel) -> (Mat<f64>, Vec<f64>) {
    let size = 3 * model.nodes.len();
    let free: Vec<usize> = (0..size).filter(|dof| model.nodes.positions[dof / 3][0] > 0.0).collect();
    let whole = model.stiffness.as_ref().expect("a stiffness") * Mat::<f64>::identity(size, size);
    let stiffness = Mat::from_fn(free.len(), free.len(), |i, j| whole[(free[i], free[j])]);
    let mass = Mat::from_fn(free.len(), free.len(), |i, j| {
        let (a, b) = (free[i], free[j]);
        if a % 3 == b % 3 { model.mass.get(a / 3, b / 3).copied().unwrap_or(0.0) } else { 0.0 }
    });
    let (values, vectors) = generalized_eigen(&stiffness, &mass);
    let mut shapes = Mat::zeros(size, free.len());
    for (row, &dof) in free.iter().enumerate() {
        for mu in 0..free.len() {
            shapes[(dof, mu)] = vectors[(row, mu)];
        }
    }
    (shapes, values.iter().map(|value| value.max(0.0).sqrt()).collect())
}

/// K v = λ M v with M positive definite, ascending λ.
fn generalized_eigen(k: &Mat<f64>, m: &Mat<f64>) -> (Vec<f64>, Mat<f64>) {
    let factor = m.llt(Side::Lower).expect("positive definite");
    let lower = factor.L().partial_piv_lu();
    let whole = lower.solve(lower.solve(k).transpose());
    let symmetric = Mat::from_fn(k.nrows(), k.nrows(), |i, j| 0.5 * (whole[(i, j)] + whole[(j, i)]));
    let eigen = symmetric.self_adjoint_eigen(Side::Lower).expect("eigenvalues converge");
    let vectors = factor.L().transpose().to_owned().partial_piv_lu().solve(eigen.U());
    ((0..k.nrows()).map(|i| eigen.S()[i]).collect(), vectors)
}

/// A beam clamped to a hub that spins about z: at rest relative to the hub, K q = Ω² (S q + s). The in-plane
/// inertia S softens and nothing stiffens, so that K - Ω² S becomes singular at a finite spin.
#[test]
fn a_spun_up_beam_loses_its_stiffness_at_its_first_bending_frequency() {
    let model = beam([8, 1, 1]);
    let (shapes, frequencies) = clamped_modes(&model);
    let body = FloatingBody::new(&model, shapes.as_ref()).expect("a model with stiffness");
    let modes = body.modes();
    // Ω² S q is the part of -Q_f that is linear in q, from the gyroscopic forces themselves.
    let steady = |q: &[f64], spin: f64| body.gyroscopic(q, [0.0, 0.0, spin], &vec![0.0; modes]);
    let at_rest = steady(&vec![0.0; modes], 1.0);
    let mut softening = Mat::zeros(modes, modes);
    for nu in 0..modes {
        let mut q = vec![0.0; modes];
        q[nu] = 1.0;
        let forces = steady(&q, 1.0);
        for mu in 0..modes {
            softening[(mu, nu)] = at_rest[(6 + mu, 0)] - forces[(6 + mu, 0)];
        }
    }
    // Largest 1/Ω² of S q = (1/Ω²) K q.
    let (inverse, vectors) = generalized_eigen(&softening, &body.stiffness);
    let critical = inverse[modes - 1].sqrt().recip();
    let softest = &shapes * vectors.as_ref().subcols(modes - 1, 1);
    let tip = model.nodes.len() - 1;
    println!("critical spin {critical} rad/s, bending {:?} rad/s", &frequencies[..2]);
    assert!(
        softest[(3 * tip + 1, 0)].abs() > 10.0 * softest[(3 * tip + 2, 0)].abs(),
        "it is bending in the plane"
    );
    // The in-plane bending is the first: the beam is thinner along y.
    assert!((critical / frequencies[0] - 1.0).abs() < 1e-2, "{critical} {}", frequencies[0]);
    // The centrifugal force is finite there, so that the deflection has no limit.
    assert!(at_rest.norm_max() > 0.0);
}
