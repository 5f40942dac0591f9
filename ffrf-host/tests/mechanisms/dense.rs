//! The whole saddle-point system of a mechanism as one dense matrix: the slow form of the constrained solve.
//!
//! ```text
//! [ M  Gᵀ ] [  w ]   [  f ]
//! [ G  0  ] [ -λ ] = [ -γ ]
//! ```
//!
//! M and f come from the naive form of each body, G from the gradients of the joints' rows at the markers.

use ffrf_host::HostModal;
use ffrf_host::mechanism::HostIncrement;
use ffrf_runtime::mechanism::{Assembly, Constrained, EvaluatedJoint, ImplicitTerms};
use ffrf_runtime::{GeneralisedForce, Motion, PlacedMarker, State};
use nalgebra::{DMatrix, DVector};

use super::graphs::{Case, GRAVITY};

/// What the solver under test says of a state.
pub struct Evaluation {
    /// Accelerations of all bodies: [linear, angular, modes] of each, body frame.
    pub accelerations: DVector<f64>,
    /// λ of all rows.
    pub multipliers: DVector<f64>,
    /// G.
    pub jacobian: DMatrix<f64>,
    /// What the rows' second rates have besides accelerations, those subtracted included: γ.
    pub bias: DVector<f64>,
    /// First row of each joint.
    pub starts: Vec<usize>,
}

/// γ h and what a stage subtracts.
pub type Stage<'a> = Option<(f64, &'a HostIncrement)>;

/// Evaluates a mechanism in a state, as a stage of a linearly implicit step if one is given.
pub fn evaluate(case: &Case, states: &[State<HostModal>], time: f64, stage: Stage<'_>) -> Evaluation {
    let mechanism = &case.mechanism;
    let offsets = offsets(states);
    let total = *offsets.last().unwrap();
    let implicit =
        stage.map(|(gamma_h, increment)| ImplicitTerms { gamma_h, subtracted: Some(increment), chart: None });
    let system = Constrained(mechanism);
    let found = system.evaluate(time, states.to_vec(), implicit, |ports, storage| {
        let mut accelerations = DVector::zeros(total);
        for (port, start) in ports.0.iter().zip(&offsets) {
            let own = flat_motion(&port.motion);
            accelerations.rows_mut(*start, own.len()).copy_from(&own);
        }
        let plan = mechanism.plan();
        let (mut gradients, mut starts) = (Vec::new(), Vec::new());
        let (mut bias, mut multipliers) = (Vec::new(), Vec::new());
        for (joint, connection) in mechanism.connections().iter().enumerate() {
            starts.push(gradients.len());
            let Some(EvaluatedJoint { rows, ends: [first, second] }) = &storage.joints[joint] else {
                continue;
            };
            for (k, row) in rows.iter().enumerate() {
                let mut gradient = DVector::zeros(total);
                for (end, wrench) in [(&connection.first, &row.first), (&connection.second, &row.second)] {
                    let Some(body) = end.body else { continue };
                    let placed = PlacedMarker::new(&mechanism.markers()[body][end.marker], &states[body]);
                    let own = flat_force(&placed.generalised_force(wrench));
                    let mut place = gradient.rows_mut(offsets[body], own.len());
                    place += own;
                }
                gradients.push(gradient);
                bias.push(row.whole_bias(first, second));
                multipliers.push(-storage.solution[plan.joints[joint].node][k]);
            }
        }
        let jacobian = DMatrix::from_fn(gradients.len(), total, |i, j| gradients[i][j]);
        let mut bias = DVector::from_vec(bias);
        if let Some((_, subtracted)) = stage {
            bias += &jacobian * subtracted_motion(states, subtracted);
        }
        Evaluation { accelerations, multipliers: DVector::from_vec(multipliers), jacobian, bias, starts }
    });
    found.unwrap_or_else(|error| panic!("{}: {error}", case.name))
}

/// M and f of all bodies, with the terms of a linearly implicit stage if one is given.
pub fn free_equations(
    case: &Case,
    states: &[State<HostModal>],
    stage: Stage<'_>,
) -> (DMatrix<f64>, DVector<f64>) {
    let offsets = offsets(states);
    let total = *offsets.last().unwrap();
    let (mut mass, mut force) = (DMatrix::zeros(total, total), DVector::zeros(total));
    for (body, state) in states.iter().enumerate() {
        let (start, witness) = (offsets[body], &case.witnesses[body]);
        let mut own = witness.mass(state);
        let placed = PlacedMarker::new(&case.mechanism.markers()[body][0], state);
        let mut right = witness.force(state, &GRAVITY);
        right += flat_force(&placed.generalised_force(&case.wrenches[body]));
        if let Some((gamma_h, subtracted)) = stage {
            let part = &subtracted.0[body];
            right -= &own * &motion_of(state, part);
            let [stiffness, damping] = witness.stiffness_and_damping();
            let moved = &state.modal_rates.0 - &part.modal_coordinates.0;
            let implicit = &stiffness * moved * gamma_h;
            let mut modes = right.rows_mut(6, implicit.len());
            modes -= implicit;
            let terms = damping * gamma_h + stiffness * (gamma_h * gamma_h);
            let mut block = own.view_mut((6, 6), terms.shape());
            block += terms;
        }
        mass.view_mut((start, start), own.shape()).copy_from(&own);
        force.rows_mut(start, right.len()).copy_from(&right);
    }
    (mass, force)
}

pub fn subtracted_motion(states: &[State<HostModal>], subtracted: &HostIncrement) -> DVector<f64> {
    let parts = states.iter().zip(&subtracted.0).map(|(state, part)| motion_of(state, part));
    let numbers: Vec<f64> = parts.flat_map(|part| part.as_slice().to_vec()).collect();
    DVector::from_vec(numbers)
}

/// The rates of velocities of an increment in the body frame.
fn motion_of(state: &State<HostModal>, part: &ffrf_runtime::Increment<HostModal>) -> DVector<f64> {
    flat_motion(&Motion {
        linear: state.to_body(&part.velocity),
        angular: part.angular_velocity,
        modal: part.modal_rates.clone(),
    })
}

/// First velocity of each body, and the number of all.
pub fn offsets(states: &[State<HostModal>]) -> Vec<usize> {
    let mut offsets = vec![0];
    for state in states {
        offsets.push(offsets[offsets.len() - 1] + 6 + state.modal_coordinates.0.len());
    }
    offsets
}

pub fn flat_force(force: &GeneralisedForce<HostModal>) -> DVector<f64> {
    let modal = force.modal.0.iter();
    DVector::from_vec(force.force.iter().chain(force.moment.iter()).chain(modal).copied().collect())
}

pub fn flat_motion(motion: &Motion<HostModal>) -> DVector<f64> {
    let modal = motion.modal.0.iter();
    DVector::from_vec(motion.linear.iter().chain(motion.angular.iter()).chain(modal).copied().collect())
}

/// The dense system in units in which its diagonal is one.
pub struct Saddle {
    /// [M Gᵀ; G 0] with rows and columns scaled.
    pub matrix: DMatrix<f64>,
    /// [f; -γ] with rows scaled.
    pub right: DVector<f64>,
    /// A scaled unknown times its entry here is the unknown.
    pub scale: DVector<f64>,
}

impl Saddle {
    pub fn new(mass: &DMatrix<f64>, force: &DVector<f64>, found: &Evaluation) -> Self {
        let (n, rows) = found.jacobian.transpose().shape();
        // of unit mass, and of unit compliance as each row meets it
        let compliance = mass.clone().cholesky().unwrap().solve(&found.jacobian.transpose());
        let scale = DVector::from_fn(n + rows, |i, _| {
            let diagonal = if i < n {
                mass[(i, i)]
            } else {
                found.jacobian.row(i - n).transpose().dot(&compliance.column(i - n))
            };
            1.0 / diagonal.sqrt()
        });
        let mut matrix = DMatrix::zeros(n + rows, n + rows);
        matrix.view_mut((0, 0), (n, n)).copy_from(mass);
        matrix.view_mut((n, 0), (rows, n)).copy_from(&found.jacobian);
        matrix.view_mut((0, n), (n, rows)).copy_from(&found.jacobian.transpose());
        let mut right = DVector::zeros(n + rows);
        right.rows_mut(0, n).copy_from(force);
        right.rows_mut(n, rows).copy_from(&-&found.bias);
        let matrix = DMatrix::from_fn(n + rows, n + rows, |i, j| matrix[(i, j)] * scale[i] * scale[j]);
        Self { matrix, right: right.component_mul(&scale), scale }
    }

    /// The solver's answer in these units.
    pub fn scaled(&self, found: &Evaluation) -> DVector<f64> {
        let unknowns = found.accelerations.iter().copied().chain(found.multipliers.iter().map(|l| -l));
        DVector::from_iterator(self.scale.len(), unknowns.zip(self.scale.iter()).map(|(x, s)| x / s))
    }

    /// Ratio of the largest to the smallest singular value.
    pub fn condition(&self) -> f64 {
        let values = self.matrix.clone().singular_values();
        values.max() / values.min()
    }

    /// What the equations leave over in `solution`, each over the size of its terms; the largest.
    pub fn residual(&self, solution: &DVector<f64>) -> f64 {
        let left = &self.matrix * solution - &self.right;
        let sizes = self.matrix.abs() * solution.abs() + self.right.abs();
        // rows with hardly any motion are measured by the whole
        let floor = sizes.amax() * 1e-3;
        left.iter().zip(sizes.iter()).map(|(left, size)| left.abs() / size.max(floor)).fold(0.0, f64::max)
    }
}
