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

/// Tip deflection in the plane over a spin-up to `spin` in 15 s, hub rate Ω/T (t - T/2π sin 2π t/T): at the largest
/// and at the end, 20 s. Lowest modes only; the frame is the hub.
fn spin_up(body: &FloatingBody, tip: &[f64], spin: f64) -> (f64, f64) {
    const TIME: f64 = 15.0;
    let modes = body.modes();
    let hub = |t: f64| {
        if t >= TIME {
            return (spin, 0.0);
        }
        let turn = std::f64::consts::TAU;
        (
            spin / TIME * (t - TIME / turn * (turn * t / TIME).sin()),
            spin / TIME * (1.0 - (turn * t / TIME).cos()),
        )
    };
    let slope = |t: f64, q: &[f64], rate: &[f64]| -> Vec<f64> {
        let (omega, alpha) = hub(t);
        let forces = body.gyroscopic(q, [0.0, 0.0, omega], rate);
        let mass = body.mass_matrix(q);
        // Mass-normalised modes: Θ_ff = I.
        (0..modes)
            .map(|mu| {
                let elastic: f64 = (0..modes).map(|nu| body.stiffness[(mu, nu)] * q[nu]).sum();
                -forces[(6 + mu, 0)] - mass[(6 + mu, 5)] * alpha - elastic
            })
            .collect()
    };
    let (mut q, mut rate) = (vec![0.0; modes], vec![0.0; modes]);
    let (h, mut largest, mut last) = (2e-3, 0.0_f64, 0.0);
    for step in 0..10_000 {
        let t = f64::from(step) * h;
        let moved = |a: &[f64], b: &[f64], by: f64| -> Vec<f64> {
            a.iter().zip(b).map(|(a, b)| a + by * b).collect()
        };
        let k1 = slope(t, &q, &rate);
        let (q2, v2) = (moved(&q, &rate, 0.5 * h), moved(&rate, &k1, 0.5 * h));
        let k2 = slope(t + 0.5 * h, &q2, &v2);
        let (q3, v3) = (moved(&q, &v2, 0.5 * h), moved(&rate, &k2, 0.5 * h));
        let k3 = slope(t + 0.5 * h, &q3, &v3);
        let (q4, v4) = (moved(&q, &v3, h), moved(&rate, &k3, h));
        let k4 = slope(t + h, &q4, &v4);
        for mu in 0..modes {
            q[mu] += h / 6.0 * (rate[mu] + 2.0 * v2[mu] + 2.0 * v3[mu] + v4[mu]);
            rate[mu] += h / 6.0 * (k1[mu] + 2.0 * k2[mu] + 2.0 * k3[mu] + k4[mu]);
        }
        last = tip.iter().zip(&q).map(|(shape, q)| shape * q).sum::<f64>();
        if last.abs() > f64::abs(largest) {
            largest = last;
        }
    }
    (largest, last)
}

/// The centrifugal force has a part across the beam, which lies beside the axis. Below the critical spin the deflection
/// is finite and grows with the softening; above it, it grows without limit, and nothing warns.
#[test]
fn a_spin_up_shows_the_missing_stiffening() {
    let model = beam([8, 1, 1]);
    let (shapes, frequencies) = clamped_modes(&model);
    let low = shapes.subcols(0, 4).to_owned();
    let body = FloatingBody::new(&model, low.as_ref()).expect("a model with stiffness");
    let tip: Vec<f64> = (0..4).map(|mu| low[(3 * (model.nodes.len() - 1) + 1, mu)]).collect();
    let table: Vec<_> = [0.3, 0.7, 0.9, 1.1]
        .iter()
        .map(|part| {
            let (largest, end) = spin_up(&body, &tip, part * frequencies[0]);
            println!(
                "spin {part} of the bending frequency: tip {largest:.3e} m at most, {end:.3e} m at the end"
            );
            (largest.abs(), end.abs())
        })
        .collect();
    assert!(table[0].0 < 0.1 && table[0].1 < 0.01, "slow: the deflection is small");
    assert!(table[3].1 > 10.0, "above the critical spin it leaves the part's own size behind");
}
