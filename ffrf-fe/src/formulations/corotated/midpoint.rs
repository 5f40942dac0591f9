//! The implicit midpoint rule with one factorisation for the whole simulation.

use faer::linalg::solvers::{Solve, SolveCore};
use faer::sparse::linalg::solvers::Llt;
use faer::{Conj, Mat, Side};

use super::joint::constraint_columns;
use super::model::turned;
use super::{CorotatedModel, ElasticState, Frame, GroundJoint};
use crate::formulations::FormulationError;

/// Coordinates and velocities at a time.
#[derive(Debug, Clone)]
pub struct Motion {
    /// Time. Units: s.
    pub time: f64,
    /// Coordinates r. Shape: 3N.
    pub position: Mat<f64>,
    /// ṙ. Shape: 3N.
    pub velocity: Mat<f64>,
}

/// What a step took.
#[derive(Debug, Clone)]
pub struct StepReport {
    /// Newton iterations.
    pub iterations: usize,
    /// Last correction relative to the size of the body.
    pub correction: f64,
    /// Force of each joint on the body, mean over the step, inertial components. Units: N.
    pub reactions: Vec<[f64; 3]>,
}

/// Implicit midpoint rule for M r̈ + f(r) + Cᵀλ = f_ext, C r = const.
///
/// The rule is of second order, symplectic, and keeps momentum and (with f a gradient invariant to rotations)
/// angular momentum; the linear constraints hold exactly, for velocities too.
///
/// In the rotated frame the iteration matrix is 4/h² M + K plus a matrix of rank six, because A_bd commutes with
/// M = M_s ⊗ I3 and with the joints. It is factored once; the rank-six part and the joints are bordered to it.
#[derive(Debug)]
pub struct Midpoint<'a> {
    model: &'a CorotatedModel,
    frame: Frame,
    step: f64,
    factor: Llt<usize, f64>,
    /// Cᵀ and (4/h² M + K)⁻¹ Cᵀ. Shape: 3N x 3J.
    constraints: Mat<f64>,
    constraints_solved: Mat<f64>,
    /// Dead load f_ext. Shape: 3N. Units: N.
    pub load: Mat<f64>,
    /// Correction at which the iteration ends, in the norm of M relative to the reference coordinates: for a mesh
    /// the root mean square displacement over the radius of inertia about the origin.
    pub tolerance: f64,
    /// Iterations allowed in a step.
    pub max_iterations: usize,
    /// Norm of the reference coordinates.
    extent: f64,
}

impl<'a> Midpoint<'a> {
    /// Factors the matrix for steps of `step` seconds.
    ///
    /// Errors: [`FormulationError::NotPositiveDefinite`].
    pub fn new(
        model: &'a CorotatedModel,
        frame: Frame,
        joints: &[GroundJoint],
        step: f64,
    ) -> Result<Self, FormulationError> {
        let factor = model
            .step_matrix(step)?
            .sp_cholesky(Side::Lower)
            .map_err(|_| FormulationError::NotPositiveDefinite)?;
        let constraints = constraint_columns(joints, model.triples());
        let mut constraints_solved = constraints.clone();
        if constraints.ncols() > 0 {
            factor.solve_in_place_with_conj(Conj::No, constraints_solved.as_mut());
        }
        Ok(Self {
            load: Mat::zeros(3 * model.triples(), 1),
            extent: model.kinetic_energy(&model.reference).sqrt(),
            tolerance: 1e-11,
            max_iterations: 25,
            model,
            frame,
            step,
            factor,
            constraints,
            constraints_solved,
        })
    }

    /// Kinetic and elastic energy less the work of the load. Units: J.
    ///
    /// Errors: as [`Frame::at`].
    pub fn energy(&self, motion: &Motion) -> Result<f64, FormulationError> {
        let elastic = ElasticState::at(self.model, &self.frame, &motion.position)?.energy;
        let potential = (self.load.transpose() * &motion.position)[(0, 0)];
        Ok(self.model.kinetic_energy(&motion.velocity) + elastic - potential)
    }

    /// One step.
    ///
    /// Errors: [`FormulationError::NoConvergence`], as [`Frame::at`].
    pub fn advance(&self, motion: &mut Motion) -> Result<StepReport, FormulationError> {
        let h = self.step;
        let held = self.constraints.transpose() * &motion.position;
        let mut middle = &motion.position + faer::Scale(0.5 * h) * &motion.velocity;
        let mut previous = f64::INFINITY;
        for iteration in 1..=self.max_iterations {
            let elastic = ElasticState::at(self.model, &self.frame, &middle)?;
            let to_body = elastic.rotation.transpose();
            // 4/h² M (r_m - r_0 - h/2 v_0) + f(r_m) - f_ext.
            let moved = &middle - &motion.position - faer::Scale(0.5 * h) * &motion.velocity;
            let inertial = faer::Scale(4.0 / (h * h)) * self.model.mass_times(moved.as_ref()) - &self.load;
            let residual = turned(inertial.as_ref(), to_body) + &elastic.force;
            let gap = turned((self.constraints.transpose() * &middle - &held).as_ref(), to_body);
            let (correction, multipliers) = self.solve(&elastic, &residual, &gap);
            middle += turned(correction.as_ref(), elastic.rotation.as_ref());
            let size = self.model.kinetic_energy(&correction).max(0.0).sqrt() / self.extent;
            let stagnant = size <= 1e3 * self.tolerance && size >= 0.5 * previous;
            if size <= self.tolerance || stagnant {
                let velocity = faer::Scale(2.0 / h) * (&middle - &motion.position);
                motion.position = faer::Scale(2.0) * &middle - &motion.position;
                motion.velocity = faer::Scale(2.0) * velocity - &motion.velocity;
                motion.time += h;
                let forces = turned(multipliers.as_ref(), elastic.rotation.as_ref());
                let reactions =
                    (0..forces.nrows() / 3).map(|j| [0, 1, 2].map(|i| -forces[(3 * j + i, 0)])).collect();
                return Ok(StepReport { iterations: iteration, correction: size, reactions });
            }
            if !size.is_finite() {
                break;
            }
            previous = size;
        }
        Err(FormulationError::NoConvergence {
            time: motion.time,
            correction: previous,
            iterations: self.max_iterations,
        })
    }

    /// [S + U Vᵀ, Cᵀ; C, 0] [δ; λ] = -[residual; gap] by bordering with the factor of S.
    fn solve(&self, elastic: &ElasticState, residual: &Mat<f64>, gap: &Mat<f64>) -> (Mat<f64>, Mat<f64>) {
        let (u, v) = elastic.low_rank(self.model);
        let (size, rank, held) = (residual.nrows(), u.ncols(), self.constraints.ncols());
        let mut solved = Mat::zeros(size, 1 + rank);
        solved.as_mut().submatrix_mut(0, 0, size, 1).copy_from(faer::Scale(-1.0) * residual);
        solved.as_mut().submatrix_mut(0, 1, size, rank).copy_from(&u);
        self.factor.solve_in_place_with_conj(Conj::No, solved.as_mut());
        let (free, u_solved) = (solved.subcols(0, 1), solved.subcols(1, rank));
        let c_solved = &self.constraints_solved;
        // δ = free - U_s z - C_s λ with z = Vᵀ δ and C δ = -gap.
        let mut small = Mat::zeros(rank + held, rank + held);
        let mut right = Mat::zeros(rank + held, 1);
        small
            .as_mut()
            .submatrix_mut(0, 0, rank, rank)
            .copy_from(Mat::<f64>::identity(rank, rank) + &v * u_solved);
        right.as_mut().submatrix_mut(0, 0, rank, 1).copy_from(&v * free);
        if held > 0 {
            let c = self.constraints.transpose();
            small.as_mut().submatrix_mut(0, rank, rank, held).copy_from(&v * c_solved);
            small.as_mut().submatrix_mut(rank, 0, held, rank).copy_from(c * u_solved);
            small.as_mut().submatrix_mut(rank, rank, held, held).copy_from(c * c_solved);
            right.as_mut().submatrix_mut(rank, 0, held, 1).copy_from(c * free + gap);
        }
        let unknowns = small.partial_piv_lu().solve(&right);
        let (z, multipliers) = (unknowns.subrows(0, rank), unknowns.subrows(rank, held));
        let mut correction = free - u_solved * z;
        if held > 0 {
            correction -= c_solved * multipliers;
        }
        (correction, multipliers.to_owned())
    }
}
