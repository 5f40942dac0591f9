//! A flexible body from its model, with invariants as tables.

use ffrf_codegen::fidelity::{EnergyTerm, Fidelity};
use ffrf_model::ReducedBody;
use ffrf_runtime::{FlexibleBody, GeneralisedForce, Marker, ModalMatrix, ModalVector, Observables, Prepared};
use nalgebra::{DMatrix, DVector, Matrix3, Vector3};

use super::HostModal;

/// Symmetric tensor: xx, yy, zz, xy, xz, yz.
type Symmetric = [f64; 6];

/// A flexible body of run-time size, in f64.
#[derive(Debug, Clone, PartialEq)]
pub struct HostBody {
    mass: f64,
    /// m a, or zero.
    first_moment: Vector3<f64>,
    /// Rows of m B. Shape: 3 x M.
    modal_first_moment: [HostModal; 3],
    /// Θ.
    inertia: Symmetric,
    /// Θ_μ + Θ_μᵀ. Shape: M.
    linear: Vec<Symmetric>,
    /// Θ_νμ + Θ_μν. Shape: M x M.
    quadratic: Vec<Vec<Symmetric>>,
    /// ϑ_μ. Shape: M.
    rotation: Vec<Vector3<f64>>,
    /// ϑ_νμ. Shape: M x M.
    whirl: Vec<Vec<Vector3<f64>>>,
    modal_mass: ModalMatrix<HostModal, f64>,
    stiffness: ModalMatrix<HostModal, f64>,
    damping: ModalMatrix<HostModal, f64>,
    largest_stable_step: Option<f64>,
}

impl HostBody {
    /// The body of a model, with the terms of the kinetic energy that `fidelity` keeps.
    ///
    /// The model must have passed its checks.
    pub fn new(body: &ReducedBody, fidelity: &Fidelity) -> Self {
        let keeps = |term: EnergyTerm| fidelity.keeps(term);
        let when = |kept: bool, tensor: Symmetric| if kept { tensor } else { [0.0; 6] };
        let vector_when = |kept: bool, vector: Vector3<f64>| if kept { vector } else { Vector3::zeros() };
        let (inertia, modes) = (&body.inertia, body.mode_count());
        let row = |axis: usize| {
            let entries = inertia.modal_first_moment.iter().map(|moment| moment[axis]);
            let kept = if keeps(EnergyTerm::ModalMomentum) { 1.0 } else { 0.0 };
            HostModal(DVector::from_iterator(modes, entries.map(|entry| kept * entry)))
        };
        let linear = keeps(EnergyTerm::RotationLinear);
        let quadratic = keeps(EnergyTerm::RotationQuadratic);
        let modal_rotation = keeps(EnergyTerm::ModalRotation);
        let deformed_rotation = keeps(EnergyTerm::ModalRotationDeformed);
        let pairs = &inertia.mode_mode_moment;
        let trace = |mu: usize, nu: usize| (0..3).map(|i| pairs[mu][nu][i][i]).sum::<f64>();
        Self {
            mass: inertia.mass,
            first_moment: vector_when(keeps(EnergyTerm::FirstMoment), inertia.first_moment.into()),
            modal_first_moment: [row(0), row(1), row(2)],
            inertia: twice_inertia(&inertia.second_moment).map(|entry| 0.5 * entry),
            linear: inertia
                .position_mode_moment
                .iter()
                .map(|moment| when(linear, twice_inertia(moment)))
                .collect(),
            quadratic: pairs
                .iter()
                .map(|row| row.iter().map(|moment| when(quadratic, twice_inertia(moment))).collect())
                .collect(),
            rotation: inertia
                .position_mode_moment
                .iter()
                .map(|moment| vector_when(modal_rotation, axial(moment)))
                .collect(),
            whirl: pairs
                .iter()
                .map(|row| row.iter().map(|moment| vector_when(deformed_rotation, axial(moment))).collect())
                .collect(),
            modal_mass: matrix(modes, |mu, nu| 0.5 * (trace(mu, nu) + trace(nu, mu))),
            stiffness: matrix(modes, |mu, nu| body.stiffness[mu][nu]),
            damping: matrix(modes, |mu, nu| body.damping[mu][nu]),
            largest_stable_step: body.largest_stable_step().filter(|step| step.is_finite()),
        }
    }

    /// A rigid body from mass (kg), centre of mass (m) and inertia about it (kg m²), in the body frame.
    pub fn rigid(mass: f64, center_of_mass: Vector3<f64>, inertia: &Matrix3<f64>) -> Self {
        let c = center_of_mass;
        let moved = inertia + (Matrix3::from_diagonal_element(c.norm_squared()) - c * c.transpose()) * mass;
        let nothing = || ModalMatrix::Diagonal(HostModal::zeros(0));
        Self {
            mass,
            first_moment: c * mass,
            modal_first_moment: core::array::from_fn(|_| HostModal::zeros(0)),
            inertia: [
                moved[(0, 0)],
                moved[(1, 1)],
                moved[(2, 2)],
                moved[(0, 1)],
                moved[(0, 2)],
                moved[(1, 2)],
            ],
            linear: Vec::new(),
            quadratic: Vec::new(),
            rotation: Vec::new(),
            whirl: Vec::new(),
            modal_mass: nothing(),
            stiffness: nothing(),
            damping: nothing(),
            largest_stable_step: None,
        }
    }

    /// Number of modes.
    pub fn mode_count(&self) -> usize {
        self.linear.len()
    }

    /// S(ω): what centrifugal forces at spin ω take from the stiffness of the modes. Shape: M x M. `omega`: body frame.
    ///
    /// Source: (209), derivative of the modal part to q.
    pub fn centrifugal_softening(&self, omega: &Vector3<f64>) -> DMatrix<f64> {
        let (spin, modes) = (spin_products(omega), self.mode_count());
        DMatrix::from_fn(modes, modes, |mu, nu| {
            0.5 * spin.iter().zip(&self.quadratic[nu][mu]).map(|(spin, entry)| spin * entry).sum::<f64>()
        })
    }

    /// The markers of a model, in its order.
    pub fn markers(body: &ReducedBody) -> Vec<Marker<HostModal, f64>> {
        let rows = |list: &[[f64; 3]]| -> [HostModal; 3] {
            core::array::from_fn(|axis| {
                HostModal(DVector::from_iterator(list.len(), list.iter().map(|entry| entry[axis])))
            })
        };
        body.markers
            .iter()
            .map(|marker| Marker {
                position: marker.position.into(),
                translation: rows(&marker.translation),
                rotation: rows(&marker.rotation),
            })
            .collect()
    }
}

impl FlexibleBody<f64> for HostBody {
    type Modal = HostModal;

    fn undeformed(&self) -> HostModal {
        HostModal::zeros(self.mode_count())
    }

    fn modal_mass(&self) -> ModalMatrix<HostModal, f64> {
        self.modal_mass.clone()
    }

    fn stiffness(&self) -> ModalMatrix<HostModal, f64> {
        self.stiffness.clone()
    }

    fn damping(&self) -> ModalMatrix<HostModal, f64> {
        self.damping.clone()
    }

    fn prepare(&self, q: &HostModal, omega: &Vector3<f64>, q_dot: &HostModal) -> Prepared<HostModal, f64> {
        let (coordinates, rates) = (q.as_slice(), q_dot.as_slice());
        let spin = spin_products(omega);
        let mut inertia = self.inertia;
        let mut inertia_rate = [0.0; 6];
        let mut coupling = [q.zeros_alike(), q.zeros_alike(), q.zeros_alike()];
        let mut modal_force = q.zeros_alike();
        for (mu, (linear, rotation)) in self.linear.iter().zip(&self.rotation).enumerate() {
            // Θ_μ + Θ_μᵀ + q_ν (Θ_νμ + Θ_μν), ϑ_μ + q_ν ϑ_νμ and q̇_ν ϑ_νμ
            let (mut even, mut odd, mut whirl) = (*linear, *rotation, Vector3::zeros());
            for nu in 0..coordinates.len() {
                for (sum, entry) in even.iter_mut().zip(&self.quadratic[nu][mu]) {
                    *sum += coordinates[nu] * entry;
                }
                odd += self.whirl[nu][mu] * coordinates[nu];
                whirl += self.whirl[nu][mu] * rates[nu];
            }
            for k in 0..6 {
                inertia[k] += 0.5 * coordinates[mu] * (linear[k] + even[k]);
                inertia_rate[k] += rates[mu] * even[k];
            }
            for axis in 0..3 {
                coupling[axis].as_mut_slice()[mu] = odd[axis];
            }
            let centrifugal: f64 = spin.iter().zip(&even).map(|(spin, even)| spin * even).sum();
            modal_force.as_mut_slice()[mu] = 2.0 * omega.dot(&whirl) - 0.5 * centrifugal;
        }
        let inertia = full(&inertia);
        let rows_times = |rows: &[HostModal; 3], modal: &HostModal| {
            Vector3::new(rows[0].dot(modal), rows[1].dot(modal), rows[2].dot(modal))
        };
        let first_moment = self.first_moment + rows_times(&self.modal_first_moment, q);
        let momentum = rows_times(&self.modal_first_moment, q_dot);
        let angular = inertia * omega + rows_times(&coupling, q_dot);
        let mut internal_force = self.stiffness.product(q);
        internal_force.add_scaled(1.0, &self.damping.product(q_dot));
        Prepared {
            mass: self.mass,
            first_moment,
            inertia,
            modal_first_moment: self.modal_first_moment.clone(),
            rotation_modal_coupling: coupling,
            quadratic_velocity: GeneralisedForce {
                force: omega.cross(&(omega.cross(&first_moment) + momentum * 2.0)),
                moment: omega.cross(&angular) + full(&inertia_rate) * omega,
                modal: modal_force,
            },
            internal_force,
        }
    }

    fn largest_stable_step(&self) -> Option<f64> {
        self.largest_stable_step
    }
}

impl Observables<f64> for HostBody {}

/// Θ + Θᵀ of a moment, with Θ = tr(T) I - Tᵀ. Source: (207), transpose corrected.
fn twice_inertia(moment: &[[f64; 3]; 3]) -> Symmetric {
    let trace = moment[0][0] + moment[1][1] + moment[2][2];
    let off = |i: usize, j: usize| -(moment[i][j] + moment[j][i]);
    let on = |i: usize| 2.0 * (trace - moment[i][i]);
    [on(0), on(1), on(2), off(0, 1), off(0, 2), off(1, 2)]
}

/// ε_ijk T^{ij} e_k. Source: (208).
fn axial(moment: &[[f64; 3]; 3]) -> Vector3<f64> {
    Vector3::new(moment[1][2] - moment[2][1], moment[2][0] - moment[0][2], moment[0][1] - moment[1][0])
}

fn full([xx, yy, zz, xy, xz, yz]: &Symmetric) -> Matrix3<f64> {
    Matrix3::new(*xx, *xy, *xz, *xy, *yy, *yz, *xz, *yz, *zz)
}

/// Factors of a symmetric tensor S in ω · S ω.
fn spin_products(omega: &Vector3<f64>) -> Symmetric {
    let [x, y, z] = [omega.x, omega.y, omega.z];
    [x * x, y * y, z * z, 2.0 * x * y, 2.0 * x * z, 2.0 * y * z]
}

/// Diagonal if every other entry is zero.
fn matrix(modes: usize, entry: impl Fn(usize, usize) -> f64) -> ModalMatrix<HostModal, f64> {
    let dense = DMatrix::from_fn(modes, modes, entry);
    let diagonal = (0..modes).all(|mu| (0..modes).all(|nu| mu == nu || dense[(mu, nu)] == 0.0));
    if diagonal { ModalMatrix::Diagonal(HostModal(dense.diagonal())) } else { ModalMatrix::Dense(dense) }
}
