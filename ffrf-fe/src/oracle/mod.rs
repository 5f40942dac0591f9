//! The equations of motion node by node, without the inertia invariants: brute force, to check the rest.
//!
//! Node n of the moving, deformed body is at X_n = x_n + Ψ_n q in the body frame and has the velocity
//! V_n = J_n [v; ω; q̇] with J_n = [I, -X̃_n, φ(n)]. Everything follows from the scalar mass matrix M_s:
//!
//! - mass matrix Σ_nm M_s,nm J_nᵀ J_m,
//! - gyroscopic forces Σ_nm M_s,nm J_nᵀ γ_m with γ_m = ω × (ω × X_m) + 2 ω × φ(m) q̇,
//! - kinetic energy ½ Σ_nm M_s,nm V_n · V_m, momenta Σ_nm M_s,nm V_m and Σ_nm M_s,nm X_n × V_m,
//! - elastic energy ½ uᵀ K u and elastic forces Ψᵀ K u with u = Ψ q,
//! - for bodies with geometric stiffness, what displacements of second order add to these (`second_order`).
//!
//! No formula is shared with the reduction or with the generated kernels. Sums carry twice the digits of
//! `f64`, so that a deviation is that of the other side.

mod magnitudes;
mod second_order;

use faer::MatRef;

use crate::compensated::{Sum, dot};
use crate::geometric_stiffness::SecondOrder;
use crate::modes::ModeError;
use crate::{FeModel, ModeBasis, SparseMatrix};
pub use magnitudes::{Scales, group_of};

/// A finite-element model with a mode basis, ready to be evaluated state by state.
#[derive(Debug, Clone, Copy)]
pub struct Oracle<'a> {
    model: &'a FeModel,
    shapes: MatRef<'a, f64>,
    /// Displacements of second order, a column for each pair of modes μ <= ν.
    second_order: Option<MatRef<'a, f64>>,
}

/// A state of the body, resolved in the body frame.
#[derive(Debug, Clone, PartialEq)]
pub struct OracleState {
    /// Modal coordinates q. Shape: M.
    pub q: Vec<f64>,
    /// Velocity v of the frame origin. Units: m/s.
    pub velocity: [f64; 3],
    /// Angular velocity ω. Units: rad/s.
    pub omega: [f64; 3],
    /// Modal rates q̇. Shape: M.
    pub q_dot: Vec<f64>,
}

/// What the nodes say about one state.
#[derive(Debug, Clone, PartialEq)]
pub struct OracleValues {
    /// Mass matrix. Shape: (6 + M) square, rows.
    pub mass_matrix: Vec<Vec<f64>>,
    /// Quadratic velocity vector, on the left-hand side. Shape: 6 + M.
    pub quadratic_velocity: Vec<f64>,
    /// Kinetic energy. Units: J.
    pub kinetic_energy: f64,
    /// Linear momentum. Shape: 3. Units: N s. Frame: body.
    pub linear_momentum: [f64; 3],
    /// Angular momentum about the frame origin. Shape: 3. Units: N m s. Frame: body.
    pub angular_momentum: [f64; 3],
    /// Elastic energy and forces, if the model has a stiffness.
    pub elastic: Option<Elastic>,
    /// Natural magnitude of each quantity, to measure deviations by.
    pub scales: Scales,
}

/// Elastic energy and forces of one state.
#[derive(Debug, Clone, PartialEq)]
pub struct Elastic {
    /// Elastic energy ½ uᵀ K u. Units: J.
    pub energy: f64,
    /// Elastic forces Ψᵀ K u, on the left-hand side. Shape: M.
    pub force: Vec<f64>,
    /// ½ |u|ᵀ |K| |u|: times 2⁻⁵³ it is what rounding each product once does to the energy. Units: J.
    pub absolute_energy: f64,
}

/// One vector per node.
type Field = Vec<[f64; 3]>;

impl<'a> Oracle<'a> {
    /// Takes the nodes, matrices and mode shapes as they are.
    ///
    /// Errors: [`ModeError::ModeShapeRows`] if the mode shapes do not have three rows per node.
    pub fn new(model: &'a FeModel, basis: &'a ModeBasis) -> Result<Self, ModeError> {
        let (found, nodes) = (basis.shapes.nrows(), model.nodes.len());
        if found != 3 * nodes {
            return Err(ModeError::ModeShapeRows { nodes, expected: 3 * nodes, found });
        }
        Ok(Self { model, shapes: basis.shapes.as_ref(), second_order: None })
    }

    /// The oracle with the displacements ½ q_μ q_ν g_μν of second order that stresses leave; see
    /// [`second_order_displacements`](crate::geometric_stiffness::second_order_displacements).
    ///
    /// Errors: [`ModeError::MatrixSize`] for another shape.
    pub fn with_second_order(mut self, fields: &'a SecondOrder) -> Result<Self, ModeError> {
        let fields = fields.columns.as_ref();
        let (expected, pairs) = (self.shapes.nrows(), self.mode_count() * (self.mode_count() + 1) / 2);
        if fields.nrows() != expected || fields.ncols() != pairs {
            let what = format!("displacements of second order ({pairs} columns)");
            return Err(ModeError::MatrixSize {
                what,
                expected,
                rows: fields.nrows(),
                columns: fields.ncols(),
            });
        }
        self.second_order = Some(fields);
        Ok(self)
    }

    /// Number of modes M.
    pub fn mode_count(&self) -> usize {
        self.shapes.ncols()
    }

    /// Evaluates everything at one state.
    ///
    /// Panics: if `q` or `q_dot` does not have one entry per mode.
    pub fn evaluate(&self, state: &OracleState) -> OracleValues {
        let displacement = self.combine(&state.q);
        let positions: Field =
            self.model.nodes.positions.iter().zip(&displacement).map(|(x, u)| add(*x, *u)).collect();
        let columns = self.velocity_columns(&positions);
        let weighted: Vec<Field> = columns.iter().map(|column| self.apply_mass(column)).collect();
        let mass_matrix: Vec<Vec<f64>> =
            columns.iter().map(|left| weighted.iter().map(|right| inner(left, right)).collect()).collect();

        let relative = self.combine(&state.q_dot);
        let convective: Field = positions
            .iter()
            .zip(&relative)
            .map(|(x, rate)| {
                let centripetal = cross(state.omega, cross(state.omega, *x));
                add(centripetal, cross(state.omega, *rate).map(|entry| 2.0 * entry))
            })
            .collect();
        let weighted_convective = self.apply_mass(&convective);
        let quadratic_velocity = columns.iter().map(|left| inner(left, &weighted_convective)).collect();

        let velocities: Field = positions
            .iter()
            .zip(&relative)
            .map(|(x, rate)| add(add(state.velocity, cross(state.omega, *x)), *rate))
            .collect();
        let momenta = self.apply_mass(&velocities);
        let kinetic_energy = 0.5 * inner(&velocities, &momenta);
        let moments: Field = positions.iter().zip(&momenta).map(|(x, p)| cross(*x, *p)).collect();

        let scales = Scales::new(&mass_matrix, inner(&convective, &weighted_convective), kinetic_energy);
        let mut values = OracleValues {
            mass_matrix,
            quadratic_velocity,
            kinetic_energy,
            linear_momentum: total(&momenta),
            angular_momentum: total(&moments),
            elastic: self.model.stiffness.as_ref().map(|stiffness| self.elastic(stiffness, &displacement)),
            scales,
        };
        if self.second_order.is_some() {
            self.add_second_order(state, &mut values);
        }
        values
    }

    /// Largest displacement of a node for the modal coordinates `q`. Units: m.
    ///
    /// Panics: if `q` does not have one entry per mode.
    pub fn largest_displacement(&self, q: &[f64]) -> f64 {
        self.combine(q).iter().map(|u| (u[0] * u[0] + u[1] * u[1] + u[2] * u[2]).sqrt()).fold(0.0, f64::max)
    }

    /// Largest edge of the box around the nodes. Units: m.
    pub fn size(&self) -> f64 {
        let extent = |axis: usize| {
            let coordinates = self.model.nodes.positions.iter().map(|x| x[axis]);
            let least = coordinates.clone().fold(f64::INFINITY, f64::min);
            coordinates.fold(f64::NEG_INFINITY, f64::max) - least
        };
        (0..3).map(extent).fold(0.0, f64::max)
    }

    /// Ψ c, node by node.
    fn combine(&self, coefficients: &[f64]) -> Field {
        assert_eq!(coefficients.len(), self.mode_count(), "one coefficient per mode");
        let entry = |row: usize| {
            let mut sum = Sum::default();
            for (mu, coefficient) in coefficients.iter().enumerate() {
                sum.add_product(self.shapes[(row, mu)], *coefficient);
            }
            sum.value()
        };
        (0..self.model.nodes.len()).map(|n| [entry(3 * n), entry(3 * n + 1), entry(3 * n + 2)]).collect()
    }

    /// The columns of J as fields over the nodes.
    fn velocity_columns(&self, positions: &Field) -> Vec<Field> {
        let axis = |i: usize| std::array::from_fn(|j| if i == j { 1.0 } else { 0.0 });
        let translations = (0..3).map(|i| vec![axis(i); positions.len()]);
        let rotations = (0..3).map(|i| positions.iter().map(|x| cross(axis(i), *x)).collect());
        let modes = (0..self.mode_count()).map(|mu| {
            (0..positions.len()).map(|n| std::array::from_fn(|i| self.shapes[(3 * n + i, mu)])).collect()
        });
        translations.chain(rotations).chain(modes).collect()
    }

    /// (M_s ⊗ I3) applied to a field.
    fn apply_mass(&self, field: &Field) -> Field {
        let mut sums = vec![[Sum::default(); 3]; field.len()];
        for entry in self.model.mass.triplet_iter() {
            for i in 0..3 {
                sums[entry.row][i].add_product(*entry.val, field[entry.col][i]);
            }
        }
        sums.iter().map(|sum| [sum[0].value(), sum[1].value(), sum[2].value()]).collect()
    }

    fn elastic(&self, stiffness: &SparseMatrix, displacement: &Field) -> Elastic {
        let u = displacement.as_flattened();
        let mut force = vec![Sum::default(); u.len()];
        let mut absolute = 0.0;
        for entry in stiffness.triplet_iter() {
            force[entry.row].add_product(*entry.val, u[entry.col]);
            absolute += (entry.val * u[entry.row] * u[entry.col]).abs();
        }
        let force: Vec<f64> = force.iter().map(Sum::value).collect();
        let modal = |mu: usize| dot((0..u.len()).map(|row| (self.shapes[(row, mu)], force[row])));
        Elastic {
            energy: 0.5 * dot(u.iter().copied().zip(force.iter().copied())),
            force: (0..self.mode_count()).map(modal).collect(),
            absolute_energy: 0.5 * absolute,
        }
    }
}

fn add(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// Sum over the nodes of the scalar products of two fields.
fn inner(left: &Field, right: &Field) -> f64 {
    dot(left.as_flattened().iter().copied().zip(right.as_flattened().iter().copied()))
}

fn total(field: &Field) -> [f64; 3] {
    std::array::from_fn(|i| dot(field.iter().map(|vector| (vector[i], 1.0))))
}
