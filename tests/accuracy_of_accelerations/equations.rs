//! What is compared: kernels that give accelerations, and the truth.

use ffrf::nalgebra::{DMatrix, DVector};
use ffrf_codegen::expression::{Input, Scalar, Symbol, evaluate};
use ffrf_codegen::formulate::kernels::{
    EQUATIONS_OF_MOTION, FORWARD_DYNAMICS, INTERNAL_FORCE, MASS_MATRIX, QUADRATIC_VELOCITY,
};
use ffrf_codegen::formulate::{Definition, Kernel};
use ffrf_codegen::{FusedMultiplyAdd, KernelInput, Kernels, passes};

use crate::double_double::DoubleDouble;
use crate::real::Real;

/// A state.
pub struct Point<T> {
    pub q: Vec<T>,
    pub q_dot: Vec<T>,
    pub omega: [T; 3],
}

/// The kernels of a body in one form and one precision.
pub trait Equations<T> {
    /// Column by column. Shape: N x N.
    fn mass_matrix(&self, point: &Point<T>) -> Vec<T>;
    /// Shape: N.
    fn quadratic_velocity(&self, point: &Point<T>) -> Vec<T>;
    /// Shape: N.
    fn accelerations(&self, point: &Point<T>, force: &[T]) -> Vec<T>;
    /// Accelerations from the kernel that gives mass matrix and quadratic velocity vector, too. Shape: N.
    fn accelerations_with_equations(&self, point: &Point<T>, force: &[T]) -> Vec<T>;
}

/// Statements: the expressions that are printed as code, after all passes, interpreted.
pub struct Statements(Vec<Kernel>);

impl Statements {
    /// The kernels that the suite asks for.
    pub fn new(kernels: &Kernels) -> Self {
        let names = [&MASS_MATRIX, &QUADRATIC_VELOCITY, &FORWARD_DYNAMICS, &EQUATIONS_OF_MOTION]
            .map(|definition| definition.signature.name);
        let wanted = kernels.kernels().iter().filter(|kernel| names.contains(&kernel.signature.name));
        Self(wanted.map(|kernel| passes::run(kernel.clone(), FusedMultiplyAdd::Auto)).collect())
    }

    fn evaluate<T: Real>(&self, definition: &Definition, point: &Point<T>, force: &[T]) -> Vec<T> {
        let name = definition.signature.name;
        let kernel = self.0.iter().find(|kernel| kernel.signature.name == name).unwrap();
        evaluate(&kernel.graph, &kernel.outputs, |symbol| match symbol {
            Symbol::Input(input, k) if input == Input::COORDINATES => point.q[k],
            Symbol::Input(input, k) if input == Input::RATES => point.q_dot[k],
            Symbol::Input(input, k) if input == Input::ANGULAR_VELOCITY => point.omega[k],
            Symbol::Input(input, k) if input == Input::FORCE => force[k],
            _ => panic!("no such input"),
        })
    }
}

impl<T: Real> Equations<T> for Statements {
    fn mass_matrix(&self, point: &Point<T>) -> Vec<T> {
        self.evaluate(&MASS_MATRIX, point, &[])
    }

    fn quadratic_velocity(&self, point: &Point<T>) -> Vec<T> {
        self.evaluate(&QUADRATIC_VELOCITY, point, &[])
    }

    fn accelerations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        self.evaluate(&FORWARD_DYNAMICS, point, force)
    }

    fn accelerations_with_equations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        let results = self.evaluate(&EQUATIONS_OF_MOTION, point, force);
        results[results.len() - force.len()..].to_vec()
    }
}

/// What must not be done: the modes eliminated by products with the inverse of Θ_ff.
pub struct Inverted(pub Statements);

impl<T: Real> Equations<T> for Inverted {
    fn mass_matrix(&self, point: &Point<T>) -> Vec<T> {
        self.0.mass_matrix(point)
    }

    fn quadratic_velocity(&self, point: &Point<T>) -> Vec<T> {
        self.0.quadratic_velocity(point)
    }

    fn accelerations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        let size = force.len();
        let matrix = DMatrix::from_vec(size, size, self.0.mass_matrix(point));
        // The bodies of this form have neither stiffness nor damping.
        let right = DVector::from_vec(force.to_vec()) - DVector::from_vec(self.0.quadratic_velocity(point));
        let modes = size - 6;
        let inverse = matrix.view((6, 6), (modes, modes)).clone_owned().try_inverse().unwrap();
        let coupling = matrix.view((0, 6), (6, modes)).clone_owned();
        let (rigid, modal) = (right.rows(0, 6).clone_owned(), right.rows(6, modes).clone_owned());
        let reduced = matrix.view((0, 0), (6, 6)) - &coupling * &inverse * coupling.transpose();
        let rigid = reduced.cholesky().unwrap().solve(&(rigid - &coupling * (&inverse * &modal)));
        let modal = inverse * (modal - coupling.transpose() * &rigid);
        rigid.iter().chain(modal.iter()).copied().collect()
    }

    fn accelerations_with_equations(&self, point: &Point<T>, force: &[T]) -> Vec<T> {
        self.accelerations(point, force)
    }
}

impl<T: Real> Point<T> {
    fn input(&self) -> KernelInput<'_, T> {
        KernelInput { q: &self.q, q_dot: &self.q_dot, omega: &self.omega, ..KernelInput::default() }
    }

    /// K q + D q̇. Shape: M.
    pub fn internal_force(&self, kernels: &Kernels) -> Vec<T> {
        kernels.evaluate(&INTERNAL_FORCE, &self.input())
    }
}

/// M and Q + K q + D q̇ of one state, to twice the digits of f64.
pub struct Truth {
    /// Column by column.
    mass: Vec<DoubleDouble>,
    bias: Vec<DoubleDouble>,
    /// L of M = L Lᵀ, row by row.
    factor: Vec<Vec<DoubleDouble>>,
}

impl Truth {
    /// The equations of the body that is in the constants of the kernels: that these are rounded is no error.
    pub fn new<T: Real>(kernels: &Kernels, point: &Point<T>) -> Self {
        let exact = |numbers: &[T]| -> Vec<DoubleDouble> {
            numbers.iter().map(|&x| DoubleDouble::from(x.double())).collect()
        };
        let (q, q_dot, omega) = (exact(&point.q), exact(&point.q_dot), exact(&point.omega));
        let input = KernelInput { q: &q, q_dot: &q_dot, omega: &omega, ..KernelInput::default() };
        let mass = kernels.evaluate(&MASS_MATRIX, &input);
        let mut bias = kernels.evaluate(&QUADRATIC_VELOCITY, &input);
        let internal = kernels.evaluate(&INTERNAL_FORCE, &input);
        bias.iter_mut().skip(6).zip(internal).for_each(|(bias, internal)| *bias = *bias + internal);
        let factor = cholesky(&mass, bias.len());
        Self { mass, bias, factor }
    }

    fn size(&self) -> usize {
        self.bias.len()
    }

    /// M_ij
    pub fn mass(&self, i: usize, j: usize) -> f64 {
        self.mass[j * self.size() + i].value()
    }

    /// √M_ii. Shape: N.
    pub fn scale(&self) -> Vec<f64> {
        (0..self.size()).map(|i| self.mass(i, i).sqrt()).collect()
    }

    /// The force that gives these accelerations.
    pub fn force_of(&self, accelerations: &[f64]) -> Vec<f64> {
        let row = |i: usize| {
            let products = accelerations.iter().enumerate().map(|(j, &w)| {
                let entry = self.mass[j * self.size() + i];
                entry * DoubleDouble::from(w)
            });
            products.fold(self.bias[i], |sum, product| sum + product).value()
        };
        (0..self.size()).map(row).collect()
    }

    /// The accelerations under a force.
    pub fn accelerations<T: Real>(&self, force: &[T]) -> Vec<DoubleDouble> {
        let mut x: Vec<DoubleDouble> =
            force.iter().zip(&self.bias).map(|(f, b)| DoubleDouble::from(f.double()) - *b).collect();
        let size = self.size();
        for i in 0..size {
            for k in 0..i {
                x[i] = x[i] - self.factor[i][k] * x[k];
            }
            x[i] = x[i] / self.factor[i][i];
        }
        for i in (0..size).rev() {
            for k in i + 1..size {
                x[i] = x[i] - self.factor[k][i] * x[k];
            }
            x[i] = x[i] / self.factor[i][i];
        }
        x
    }
}

fn cholesky(matrix: &[DoubleDouble], size: usize) -> Vec<Vec<DoubleDouble>> {
    let mut factor = vec![vec![DoubleDouble::from(0.0); size]; size];
    for i in 0..size {
        for j in 0..=i {
            let mut sum = matrix[j * size + i];
            for k in 0..j {
                sum = sum - factor[i][k] * factor[j][k];
            }
            factor[i][j] = if i == j { sum.square_root() } else { sum / factor[j][j] };
        }
    }
    factor
}
