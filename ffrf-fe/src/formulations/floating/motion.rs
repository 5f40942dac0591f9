//! Time integration of the floating frame by the classical Runge-Kutta method, with an optional pinned point.

use faer::linalg::solvers::Solve;
use faer::{Mat, MatRef};

use super::FloatingBody;
use crate::formulations::rotation::{body_rate_matrix, cross, rotation_matrix, skew};

/// State of a floating body.
#[derive(Debug, Clone)]
pub struct FloatingMotion {
    /// Time. Units: s.
    pub time: f64,
    /// Origin of the body frame, inertial components. Units: m.
    pub origin: [f64; 3],
    /// Euler parameters, scalar first.
    pub theta: [f64; 4],
    /// Modal coordinates. Shape: M.
    pub q: Vec<f64>,
    /// Velocity of the origin, body components. Units: m/s.
    pub velocity: [f64; 3],
    /// Angular velocity, body components. Units: rad/s.
    pub omega: [f64; 3],
    /// Modal rates. Shape: M.
    pub q_dot: Vec<f64>,
}

/// A material point held in space (spherical joint to the ground).
#[derive(Debug, Clone)]
pub struct Pin {
    /// Reference position, body frame. Units: m.
    pub position: [f64; 3],
    /// Its rows of Ψ. Shape: 3 x M.
    pub shapes: Mat<f64>,
}

/// Runge-Kutta of fourth order for one body under gravity.
#[derive(Debug)]
pub struct RungeKutta<'a> {
    /// The body.
    pub body: &'a FloatingBody,
    /// Gravity, inertial components. Units: m/s².
    pub gravity: [f64; 3],
    /// A held point, at acceleration level: it drifts with the error of the rule.
    pub pin: Option<Pin>,
}

impl FloatingMotion {
    /// Current position of a material point, inertial components. Units: m.
    pub fn point(&self, position: [f64; 3], shapes: MatRef<'_, f64>) -> [f64; 3] {
        let a = rotation_matrix(self.theta);
        let x = deformed(position, shapes, &self.q);
        [0, 1, 2].map(|i| self.origin[i] + (0..3).map(|j| a[(i, j)] * x[j]).sum::<f64>())
    }

    fn to_vector(&self) -> Vec<f64> {
        let mut y = Vec::with_capacity(13 + 2 * self.q.len());
        y.extend(self.origin);
        y.extend(self.theta);
        y.extend(&self.q);
        y.extend(self.velocity);
        y.extend(self.omega);
        y.extend(&self.q_dot);
        y
    }

    fn from_vector(time: f64, y: &[f64], modes: usize) -> Self {
        let three = |at: usize| [y[at], y[at + 1], y[at + 2]];
        Self {
            time,
            origin: three(0),
            theta: [y[3], y[4], y[5], y[6]],
            q: y[7..7 + modes].to_vec(),
            velocity: three(7 + modes),
            omega: three(10 + modes),
            q_dot: y[13 + modes..].to_vec(),
        }
    }
}

fn deformed(position: [f64; 3], shapes: MatRef<'_, f64>, q: &[f64]) -> [f64; 3] {
    [0, 1, 2].map(|i| position[i] + q.iter().enumerate().map(|(mu, q)| q * shapes[(i, mu)]).sum::<f64>())
}

impl RungeKutta<'_> {
    /// Advances by one step of `h` seconds; the Euler parameters are normalised after it.
    pub fn advance(&self, motion: &mut FloatingMotion, h: f64) {
        let modes = self.body.modes();
        let y = motion.to_vector();
        let at = |slope: &[f64], by: f64| {
            let moved: Vec<f64> = y.iter().zip(slope).map(|(y, k)| y + by * k).collect();
            self.rates(&FloatingMotion::from_vector(motion.time, &moved, modes))
        };
        let k1 = self.rates(motion);
        let k2 = at(&k1, 0.5 * h);
        let k3 = at(&k2, 0.5 * h);
        let k4 = at(&k3, h);
        let sum: Vec<f64> =
            (0..y.len()).map(|i| y[i] + h / 6.0 * (k1[i] + 2.0 * k2[i] + 2.0 * k3[i] + k4[i])).collect();
        *motion = FloatingMotion::from_vector(motion.time + h, &sum, modes);
        let norm = motion.theta.iter().map(|t| t * t).sum::<f64>().sqrt();
        motion.theta = motion.theta.map(|t| t / norm);
    }

    /// Time derivative of the state.
    fn rates(&self, motion: &FloatingMotion) -> Vec<f64> {
        let modes = self.body.modes();
        let a = rotation_matrix(motion.theta);
        let turn =
            |m: &Mat<f64>, v: [f64; 3]| [0, 1, 2].map(|i| (0..3).map(|j| m[(i, j)] * v[j]).sum::<f64>());
        let w = self.accelerations(motion, turn(&a.transpose().to_owned(), self.gravity));
        let g = body_rate_matrix(motion.theta);
        let mut rates = Vec::with_capacity(13 + 2 * modes);
        rates.extend(turn(&a, motion.velocity));
        // θ̇ = ¼ Ḡᵀ ω.
        rates.extend((0..4).map(|i| 0.25 * (0..3).map(|j| g[(j, i)] * motion.omega[j]).sum::<f64>()));
        rates.extend(&motion.q_dot);
        let transport = cross(motion.omega, motion.velocity);
        rates.extend((0..3).map(|i| w[(i, 0)] - transport[i]));
        rates.extend((3..6 + modes).map(|i| w[(i, 0)]));
        rates
    }

    /// [α; ω̇; q̈] from M w + Q + K q = M g + Jᵀ λ and the pin's J w = -γ.
    fn accelerations(&self, motion: &FloatingMotion, gravity: [f64; 3]) -> Mat<f64> {
        let modes = self.body.modes();
        let size = 6 + modes;
        let held = if self.pin.is_some() { 3 } else { 0 };
        let mut matrix = Mat::zeros(size + held, size + held);
        matrix.as_mut().submatrix_mut(0, 0, size, size).copy_from(self.body.mass_matrix(&motion.q));
        let gyroscopic = self.body.gyroscopic(&motion.q, motion.omega, &motion.q_dot);
        let mut right = Mat::zeros(size + held, 1);
        for i in 0..size {
            right[(i, 0)] = -gyroscopic[(i, 0)];
            if i >= 6 {
                right[(i, 0)] -=
                    (0..modes).map(|nu| self.body.stiffness[(i - 6, nu)] * motion.q[nu]).sum::<f64>();
            }
        }
        if let Some(pin) = &self.pin {
            let lever = deformed(pin.position, pin.shapes.as_ref(), &motion.q);
            let rate = deformed([0.0; 3], pin.shapes.as_ref(), &motion.q_dot);
            let (tilde, omega) = (skew(lever), motion.omega);
            let (centripetal, coriolis) = (cross(omega, cross(omega, lever)), cross(omega, rate));
            for i in 0..3 {
                let mut row = vec![0.0; size];
                row[i] = 1.0;
                for j in 0..3 {
                    row[3 + j] = -tilde[(i, j)];
                }
                for mu in 0..modes {
                    row[6 + mu] = pin.shapes[(i, mu)];
                }
                for (column, value) in row.into_iter().enumerate() {
                    matrix[(size + i, column)] = value;
                    matrix[(column, size + i)] = value;
                }
                // Unknown is α - Aᵀg: the pinned point must not accelerate in space.
                right[(size + i, 0)] = -centripetal[i] - 2.0 * coriolis[i] - gravity[i];
            }
        }
        let mut w = matrix.partial_piv_lu().solve(&right);
        for i in 0..3 {
            w[(i, 0)] += gravity[i];
        }
        w
    }
}
