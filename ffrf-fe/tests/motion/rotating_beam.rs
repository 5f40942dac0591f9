//! A rotating cantilever as beam theory has it, by Ritz's method with polynomials: an independent witness of one dimension.
//!
//! Displacements (U - y θ, V) in the plane of rotation; length, mass and bending stiffness 1, axial stiffness s² at slenderness s.
//! Linear about the undeformed beam, under the tension T = μ² (1 - x²) / 2 of its own mass.

use faer::Mat;

/// Polynomials of each field.
const COUNT: usize = 13;
/// Intervals of Simpson's rule: products of these polynomials come out to 1e-12.
const INTERVALS: usize = 4000;

/// What the beam knows.
#[derive(Clone, Copy)]
pub struct Beam {
    pub slenderness: f64,
    /// Shear stiffness κ G over E. Large for a beam that does not shear (Euler and Bernoulli).
    pub shear: f64,
    /// Share of the inertia of its sections about their middle, above 0.
    pub rotary: f64,
    /// Share of the work of stress on the gradient along the stress itself, ½ σ (∂u/∂x)² of Green's strain.
    pub along: f64,
}

/// Value and slope of x P_k(2 x - 1), Legendre's polynomials.
fn polynomials(x: f64) -> [[f64; 2]; COUNT] {
    let t = 2.0 * x - 1.0;
    let (mut p, mut slope) = ([1.0; COUNT], [0.0; COUNT]);
    p[1] = t;
    slope[1] = 2.0;
    for k in 2..COUNT {
        let n = k as f64;
        p[k] = ((2.0 * n - 1.0) * t * p[k - 1] - (n - 1.0) * p[k - 2]) / n;
        slope[k] = slope[k - 2] + 2.0 * (2.0 * n - 1.0) * p[k - 1];
    }
    std::array::from_fn(|k| [x * p[k], p[k] + x * slope[k]])
}

impl Beam {
    /// Lowest frequency at a speed μ: out of the plane of rotation, and in it.
    pub fn lowest(&self, speed: f64) -> [f64; 2] {
        let size = 3 * COUNT;
        let (mut mass, mut rest) = (Mat::<f64>::zeros(size, size), Mat::<f64>::zeros(size, size));
        let (mut softening, mut coupling) = (mass.clone(), mass.clone());
        let squared = self.slenderness.powi(2);
        for place in 0..=INTERVALS {
            let x = place as f64 / INTERVALS as f64;
            let ends = place == 0 || place == INTERVALS;
            let weight = if ends {
                1.0
            } else if place % 2 == 1 {
                4.0
            } else {
                2.0
            } / (3 * INTERVALS) as f64;
            let tension = 0.5 * speed * speed * (1.0 - x * x);
            let values = polynomials(x);
            for (a, [f, df]) in values.iter().enumerate() {
                for (b, [g, dg]) in values.iter().enumerate() {
                    let (u, v, t) = ((a, b), (COUNT + a, COUNT + b), (2 * COUNT + a, 2 * COUNT + b));
                    mass[u] += weight * f * g;
                    mass[v] += weight * f * g;
                    mass[t] += weight * self.rotary * f * g / squared;
                    rest[u] += weight * (squared + self.along * tension) * df * dg;
                    rest[v] += weight * (self.shear * squared + tension) * df * dg;
                    rest[t] += weight
                        * ((1.0 + self.along * tension / squared) * df * dg + self.shear * squared * f * g);
                    // (V' - θ)²
                    rest[(v.0, t.1)] -= weight * self.shear * squared * df * g;
                    rest[(t.1, v.0)] -= weight * self.shear * squared * df * g;
                    softening[t] += weight * self.rotary * f * g / squared;
                    coupling[(u.0, v.1)] += weight * f * g;
                }
            }
        }
        for k in 0..2 * COUNT {
            for l in 0..2 * COUNT {
                softening[(k, l)] = mass[(k, l)];
            }
        }
        let out_of_plane = smallest(&mass, &rest, &Mat::zeros(size, size), COUNT..size);
        let stiffness = &rest - faer::Scale(speed * speed) * &softening;
        let gyroscopic = faer::Scale(2.0 * speed) * (coupling.transpose() - &coupling);
        [out_of_plane, smallest(&mass, &stiffness, &gyroscopic, 0..size)]
    }
}

/// Least frequency of M q̈ + G q̇ + K q = 0 on a range of coordinates.
fn smallest(
    mass: &Mat<f64>,
    stiffness: &Mat<f64>,
    gyroscopic: &Mat<f64>,
    range: std::ops::Range<usize>,
) -> f64 {
    use faer::linalg::solvers::Solve as _;
    let part = |matrix: &Mat<f64>| matrix.get(range.clone(), range.clone()).to_owned();
    let factor = part(mass).partial_piv_lu();
    let (by_place, by_rate) = (factor.solve(part(stiffness)), factor.solve(part(gyroscopic)));
    let size = range.len();
    let matrix = Mat::from_fn(2 * size, 2 * size, |i, j| match (i < size, j < size) {
        (true, true) => 0.0,
        (true, false) => f64::from(u8::from(i == j - size)),
        (false, true) => -by_place[(i - size, j)],
        (false, false) => -by_rate[(i - size, j - size)],
    });
    let values = matrix.eigenvalues().expect("eigenvalues converge");
    values.iter().map(|value| value.im).filter(|omega| *omega > 0.1).fold(f64::INFINITY, f64::min)
}
